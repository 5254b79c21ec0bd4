#pragma once

#include <QWidget>

#include "app/panels/fields/energy_slider.h"
#include "app/session/shape_session.h"

class QLabel;
class QPushButton;

namespace wend {

/// Shows what the whole shape keeps: the slider with its stops, and a suggestion if the shape grew too much.
class MaterialPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MaterialPanel(ShapeSession& session, QWidget* parent = nullptr);
    EnergySlider* energySlider() const { return m_slider; }
    /// Makes the title state that these stops belong to the whole shape while a brush has its own.
    void setBesideBrush(bool beside);

  private:
    void changeEvent(QEvent* event) override;
    void showProject();
    void showGrowth();
    int calmerStop() const;
    void choosePhi(double phi, int gesture);

    ShapeSession& m_session;
    QLabel* m_title;
    EnergySlider* m_slider;
    QLabel* m_help;
    QPushButton* m_grown;
    bool m_besideBrush = false;
};

}  // namespace wend
