#include "app/session/motion_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/document/handle_edits.h"
#include "core/mesh/shape_size.h"
#include "kernels/back_end_choice.h"

namespace wend {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFramesPerUnit = 24;
constexpr int kMostFrames = 480;

template <int Dim>
const Design<Dim>& designOf(const Project& project) {
    return std::get<Design<Dim>>(project.design);
}

/// The time from which on two lists of windows differ, or +infinity.
double firstDifference(const std::vector<SettleWindow>& a, const std::vector<SettleWindow>& b) {
    const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return std::min(i == a.end() ? kInfinity : i->start, j == b.end() ? kInfinity : j->start);
}

bool sameIntegration(const IntegrationOptions& a, const IntegrationOptions& b) {
    return a.method == b.method && a.tolerance == b.tolerance && a.steps == b.steps &&
           (a.steps == 0 || a.end == b.end) && a.smallestStep == b.smallestStep && a.threads == b.threads;
}

}  // namespace

template <int Dim>
void MotionPass<Dim>::clear() {
    m_project.reset();
    m_deformer.reset();
    m_probe.reset();
    m_cache.clear();
    m_result.reset();
    m_restSent = false;
}

template <int Dim>
double MotionPass<Dim>::set(const BuiltShape<Dim>& shape, std::shared_ptr<const Project> project) {
    double kept = -kInfinity;
    if (m_project && shape.rest == m_shape.rest && shape.material == m_shape.material &&
        sameIntegration(integrationOf(*m_project), integrationOf(*project)))
        kept = std::min(firstDifference(designOf<Dim>(*m_project).handles, designOf<Dim>(*project).handles),
                        firstDifference(m_project->settle, project->settle));
    const double end = motionEnd(*project);
    const bool same = kept == kInfinity && end == m_end;
    m_shape = shape;
    m_project = std::move(project);
    if (same) return kInfinity;
    m_end = end;
    kept = std::min(kept, end);
    m_deformer.reset();
    m_probe.reset();
    m_result.reset();
    m_cache.keepUpTo(kept);
    if (!m_cache.last()) m_restSent = false;
    m_lastFrame = m_cache.last() ? m_cache.last()->time : 0;
    return m_cache.last() ? m_lastFrame : -kInfinity;
}

template <int Dim>
void MotionPass<Dim>::begin(const Sink& sink) {
    if (!m_restSent) {
        State<Dim> rest;
        rest.points = m_shape.rest->points;
        sink.onFrame(rest, 0);
        m_restSent = true;
    }
    const auto& handles = designOf<Dim>(*m_project).handles;
    m_deformer.emplace(m_shape.rest, m_shape.material, handles, integrationOf(*m_project),
                       backEndFactory<Dim>(BackEndKind::Automatic));
    if (m_cache.last())
        m_deformer->restore(*m_cache.last());
    else
        m_cache.add(m_deformer->state());
}

template <int Dim>
double MotionPass<Dim>::nextBorder(double time) const {
    double next = m_end;
    const auto consider = [&](double t) {
        if (t > time) next = std::min(next, t);
    };
    for (const Handle<Dim>& handle : designOf<Dim>(*m_project).handles) {
        consider(handle.activeFrom);
        consider(handle.activeTo);
        for (const Motion<Dim>& motion : handle.motions) consider(motion.start), consider(motion.end);
    }
    for (const SettleWindow& window : m_project->settle) consider(window.start), consider(window.end);
    return next;
}

template <int Dim>
std::vector<double> MotionPass<Dim>::frameTimes(double from, double to) const {
    const double spacing = std::max(1.0 / kFramesPerUnit, m_end / kMostFrames);
    std::vector<double> times;
    for (double k = std::floor(from / spacing) + 1; k * spacing < to - 0.25 * spacing; ++k)
        if (k * spacing > from) times.push_back(k * spacing);
    return times;
}

template <int Dim>
void MotionPass<Dim>::run(const Sink& sink, std::stop_token stop) {
    if (!m_deformer) begin(sink);
    const double size = shapeSize<Dim>(m_shape.rest->points, m_shape.rest->cells).size;
    const auto send = [&](const State<Dim>& state) {
        m_lastFrame = state.time;
        sink.onFrame(state, m_deformer->statistics().constraintError * size);
    };
    while (m_deformer->state().time < m_end) {
        typename Deformer<Dim>::Watch watch;
        const double border = nextBorder(m_deformer->state().time);
        watch.frames = frameTimes(std::max(m_lastFrame, m_deformer->state().time), border);
        watch.onFrame = send;
        watch.progress = [&](double time) { sink.progress(time, m_end); };
        watch.stop = stop;
        const AdvanceResult result = m_deformer->advance(border, watch);
        if (result.outcome == Outcome::Cancelled) return;
        m_cache.add(m_deformer->state());
        send(m_deformer->state());
        if (result.outcome == Outcome::Done) continue;
        m_result = result;
        return;
    }
    m_result = AdvanceResult{};
}

template <int Dim>
Points<Dim> MotionPass<Dim>::velocity(double time, const Points<Dim>& pose, std::stop_token stop) try {
    const Points<Dim> none(Dim, 0);
    if (!m_project || stop.stop_requested()) return none;
    if (!m_probe) m_probe.emplace(m_shape.rest, m_shape.material, *m_project);
    return stop.stop_requested() ? none : m_probe->at(time, pose);
} catch (...) {
    m_probe.reset();
    throw;
}

template class MotionPass<2>;
template class MotionPass<3>;

}  // namespace wend
