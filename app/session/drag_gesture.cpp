#include "app/session/drag_gesture.h"

#include <algorithm>

#include "app/document/handle_edits.h"

namespace wend {

DragGesture::DragGesture(std::vector<int> handles, std::vector<Vec<2>> starts)
    : m_handles(std::move(handles)), m_starts(std::move(starts)), m_samples{{Vec<2>::Zero()}} {}

int DragGesture::add(const Vec<2>& offset) {
    m_samples.push_back({offset});
    return static_cast<int>(m_samples.size()) - 1;
}

void DragGesture::follow(const ShapeFrame& live) {
    if (live.sample < 0 || live.sample >= static_cast<int>(m_samples.size())) return;
    if (live.stopped)
        for (int i = m_followed + 1; i < live.sample; ++i) m_samples[i].reached = false;
    m_samples[live.sample].offset = live.offset;
    m_followed = std::max(m_followed, live.sample);
    m_stopped = live.stopped;
}

Vec<2> DragGesture::offset() const {
    return m_stopped ? m_samples[m_followed].offset : m_samples.back().offset;
}

std::vector<Vec<2>> DragGesture::path(double tolerance) const {
    std::vector<Vec<2>> points;
    for (int i = 0; i < static_cast<int>(m_samples.size()); ++i) {
        if (m_stopped && i > m_followed) break;
        if (m_samples[i].reached) points.push_back(m_samples[i].offset);
    }
    return simplified(points, tolerance);
}

}  // namespace wend
