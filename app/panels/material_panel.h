#pragma once

#include <QWidget>

#include "app/panels/energy_slider.h"
#include "app/session/shape_session.h"

class QDoubleSpinBox;
class QLabel;

namespace wend {

/// The energy of the whole shape: the slider with its named stops, φ as a number, the smoothing length.
class MaterialPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MaterialPanel(ShapeSession& session, QWidget* parent = nullptr);
    EnergySlider* energySlider() const { return m_slider; }

  private:
    static QString phiHelp(int dimension);
    void makeControls();
    void showProject();
    void choosePhi(double phi, int gesture);
    void chooseSmoothing(double length);

    ShapeSession& m_session;
    EnergySlider* m_slider;
    QLabel* m_help;
    QDoubleSpinBox* m_phi;
    QDoubleSpinBox* m_smoothing;
};

}  // namespace wend
