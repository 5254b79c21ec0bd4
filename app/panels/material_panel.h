#pragma once

#include <QWidget>

#include "app/panels/energy_slider.h"
#include "app/panels/memory_slider.h"
#include "app/session/shape_session.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace wend {

/// The energy of the whole shape: the slider with its named stops, φ as a number, the smoothing length, and
/// how well it remembers its rest.
class MaterialPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MaterialPanel(ShapeSession& session, QWidget* parent = nullptr);
    EnergySlider* energySlider() const { return m_slider; }
    MemorySlider* memorySlider() const { return m_memory; }

  private:
    static QString phiHelp(int dimension);
    void makeControls();
    void showProject();
    void choosePhi(double phi, int gesture);
    void chooseSmoothing(double length);
    void chooseMemory(double memory, int gesture);

    ShapeSession& m_session;
    EnergySlider* m_slider;
    QLabel* m_help;
    QDoubleSpinBox* m_phi;
    QDoubleSpinBox* m_smoothing;
    MemorySlider* m_memory;
    QPushButton* m_settle;
};

}  // namespace wend
