#include "app/engine/motion/drag_gesture.h"

#include <algorithm>

#include "app/project/edits/handle_edits.h"

namespace wend {

namespace {

constexpr double kSampleTime = 1.0 / 60;    // seconds between two samples of a moving pointer
constexpr double kPause = 3 * kSampleTime;  // longer than that without a sample, it has rested
constexpr double kLate = 0.02;              // seconds that weigh as much as the tolerance

}  // namespace

DragGesture::DragGesture(std::vector<int> handles, const Grip& grip, bool records)
    : m_handles(std::move(handles)), m_grip(grip), m_records(records), m_samples{{Amount::Zero()}} {}

/// Lets the drag begin one tick before its first sample, and keeps the times of samples distinct.
int DragGesture::add(const Amount& amount, double seconds) {
    m_newest = amount;
    if (m_samples.size() == 1) m_samples.front().seconds = seconds - kSampleTime;
    m_samples.push_back({amount, std::max(seconds, m_samples.back().seconds + 1e-3)});
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

TimedPath DragGesture::timedPath(double tolerance) const {
    std::vector<Vec<4>> points;
    const double begin = m_samples.front().seconds, scale = tolerance / kLate;
    const auto add = [&](const Amount& amount, double seconds) {
        points.emplace_back(amount[0], amount[1], amount[2], scale * (seconds - begin));
    };
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
        const Sample& sample = m_samples[i];
        if (m_stopped && static_cast<int>(i) > m_followed) break;
        if (!sample.reached) continue;
        const bool rested = i > 0 && sample.seconds - m_samples[i - 1].seconds > kPause;
        if (rested) add(Amount(points.back().head<3>()), sample.seconds - kSampleTime);
        add(sample.amount, sample.seconds);
    }
    const auto rests = [](const Vec<4>& p) { return p.head<3>().isZero(0); };
    if (std::all_of(points.begin(), points.end(), rests)) points.resize(1);
    TimedPath path;
    for (const Vec<4>& p : simplified<4>(points, tolerance)) {
        path.points.emplace_back(p.head<3>());
        path.seconds.push_back(p[3] / scale);
    }
    return path;
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
