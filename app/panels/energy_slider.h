#pragma once

#include <QSlider>
#include <QWidget>

#include "app/panels/energy_scale.h"

class QToolButton;

namespace wend {

/// The slider with the four named stops below it. Near a stop the handle snaps to it.
class EnergySlider : public QWidget {
    Q_OBJECT

  public:
    explicit EnergySlider(QWidget* parent = nullptr);

    double phi() const { return m_phi; }
    void setPhi(double phi);
    const EnergyScale& scale() const { return m_scale; }
    /// The names and the range of φ depend on it.
    void setDimension(int dimension);
    QSlider* slider() const { return m_slider; }
    QSize sizeHint() const override;

  signals:
    /// The user chose another φ; the number is the same for all values of one gesture.
    void phiChosen(double phi, int gesture);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void choose(int value);
    void placeLabels();
    int stopX(int stop) const;
    QString helpText() const;

    int m_dimension = 2;
    EnergyScale m_scale;
    QSlider* m_slider;
    std::array<QToolButton*, EnergyScale::kStops> m_labels;
    double m_phi;
    int m_gesture = 0;
};

}  // namespace wend
