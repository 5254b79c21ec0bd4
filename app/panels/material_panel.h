#pragma once

#include <QWidget>

#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/setting_rows.h"
#include "app/session/shape_motion.h"

class QLabel;
class QPushButton;

namespace wend {

class JumpSlider;

/// The smoothing length as a logarithmic slider from near to far. Lengths beyond its ends are shown at the
/// ends and kept until it is moved.
class ReachRow : public QWidget {
    Q_OBJECT

  public:
    explicit ReachRow(Document& document, QWidget* parent = nullptr);

  private:
    void showProject();

    Document& m_document;
    JumpSlider* m_slider;
};

/// Exact numbers for the energy of the whole shape and the smoothing length.
class BalancePanel : public QWidget {
    Q_OBJECT

  public:
    explicit BalancePanel(Document& document, QWidget* parent = nullptr);

  private:
    void showProject();

    Document& m_document;
    SettingRows m_settings;
};

/// Shows what the whole shape keeps: the slider with its stops, and a suggestion if the shape grew too much.
class MaterialPanel : public QWidget {
    Q_OBJECT

  public:
    MaterialPanel(Document& document, ShapeMotion& motion, QWidget* parent = nullptr);
    EnergySlider* energySlider() const { return m_slider; }
    /// Makes the title state that these stops belong to the whole shape while a brush has its own.
    void setBesideBrush(bool beside);

  private:
    void changeEvent(QEvent* event) override;
    void showProject();
    void showGrowth();
    int calmerStop() const;
    void choosePhi(double phi, int gesture);

    Document& m_document;
    ShapeMotion& m_motion;
    QLabel* m_title;
    EnergySlider* m_slider;
    QLabel* m_help;
    QPushButton* m_grown;
    bool m_besideBrush = false;
};

}  // namespace wend
