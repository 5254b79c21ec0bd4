#pragma once

#include <QWidget>

#include "app/panels/energy_slider.h"
#include "app/session/shape_session.h"

class QLabel;

namespace wend {

/// What the whole shape keeps when it has to give way: the slider with its named stops.
class MaterialPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MaterialPanel(ShapeSession& session, QWidget* parent = nullptr);
    EnergySlider* energySlider() const { return m_slider; }

  private:
    void showProject();
    void choosePhi(double phi, int gesture);

    ShapeSession& m_session;
    EnergySlider* m_slider;
    QLabel* m_help;
};

}  // namespace wend
