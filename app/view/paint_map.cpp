#include "app/view/paint_map.h"

namespace wend {

void PaintMap::show(Measure wanted) {
    if (m_before && wanted == m_painted) return;
    if (!m_before) m_before = Before{m_panel.measure(), m_showMap.isChecked()};
    m_painted = wanted;
    m_panel.setMeasure(wanted);
    m_showMap.setChecked(true);
}

void PaintMap::end() {
    if (!m_before) return;
    const Before before = *std::exchange(m_before, std::nullopt);
    if (m_panel.measure() != m_painted || !m_showMap.isChecked()) return;
    m_panel.setMeasure(before.measure);
    m_showMap.setChecked(before.shown);
}

}  // namespace wend
