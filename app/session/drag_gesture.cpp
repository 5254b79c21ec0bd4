#include "app/session/drag_gesture.h"

#include <algorithm>

#include "app/document/handle_edits.h"

namespace wend {

DragGesture::DragGesture(std::vector<int> handles, const Grip& grip)
    : m_handles(std::move(handles)), m_grip(grip), m_samples{{Amount::Zero()}} {}

int DragGesture::add(const Amount& amount) {
    m_samples.push_back({amount});
    return static_cast<int>(m_samples.size()) - 1;
}

void DragGesture::follow(const ShapeFrame& live) {
    if (live.sample < 0 || live.sample >= static_cast<int>(m_samples.size())) return;
    if (live.stopped)
        for (int i = m_followed + 1; i < live.sample; ++i) m_samples[i].reached = false;
    m_samples[live.sample].amount = live.amount;
    m_followed = std::max(m_followed, live.sample);
    m_stopped = live.stopped;
}

Amount DragGesture::amount() const {
    return m_stopped ? m_samples[m_followed].amount : m_samples.back().amount;
}

std::vector<Amount> DragGesture::straight() const {
    const Amount end = amount();
    return end == Amount::Zero() ? std::vector<Amount>{end} : std::vector<Amount>{Amount::Zero(), end};
}

std::vector<Amount> DragGesture::path(double tolerance) const {
    std::vector<Amount> points;
    for (int i = 0; i < static_cast<int>(m_samples.size()); ++i) {
        if (m_stopped && i > m_followed) break;
        if (m_samples[i].reached) points.push_back(m_samples[i].amount);
    }
    return simplified<3>(points, tolerance);
}

}  // namespace wend
