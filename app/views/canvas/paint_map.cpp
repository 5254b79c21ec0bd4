#include "app/views/canvas/paint_map.h"

namespace wend {

PaintMap::PaintMap(DistortionPanel& panel, QAction& showMap) : m_panel(panel), m_showMap(showMap) {
    QObject::connect(&panel, &DistortionPanel::mapChosen, &m_listener, [this] { m_isChosen = true; });
}

void PaintMap::show(Measure wanted) {
    if (m_before && wanted == m_painted) return;
    if (!m_before) m_before = Before{m_panel.measure(), m_showMap.isChecked()};
    m_isChosen = false;
    m_painted = wanted;
    m_panel.setMeasure(wanted);
    m_showMap.setChecked(true);
}

/// The measure may be another one already: a file of another dimension was opened.
void PaintMap::end() {
    if (!m_before) return;
    const Before before = *std::exchange(m_before, std::nullopt);
    if (m_isChosen) return;
    m_panel.setMeasure(before.measure);
    if (m_showMap.isChecked()) m_showMap.setChecked(before.shown);
}

}  // namespace wend
