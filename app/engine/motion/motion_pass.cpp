#include "app/engine/motion/motion_pass.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "app/engine/motion/playback.h"
#include "app/engine/shape/held_border.h"
#include "app/project/design.h"
#include "app/project/edits/handle_comparison.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/options/settings.h"
#include "core/integration/stop_message.h"
#include "core/mesh/shape_size.h"
#include "kernels/back_end_choice.h"

namespace wend {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFramesPerUnit = 24;
constexpr int kMostFrames = 480;
constexpr double kSameShape = 1e-7;              // of the size: as exact as an elastic shape is computed
constexpr std::chrono::milliseconds kLookUp(2);  // from waiting, for a wish to stop

template <int Dim>
State<Dim> restOf(const Shape<Dim>& shape) {
    State<Dim> rest;
    rest.points = shape.rest->points;
    return rest;
}

/// Returns the time on the clock of `b` from which two lists of windows differ, with the times of `a`
/// multiplied by the scale; +infinity if they never do.
double firstDifference(const std::vector<SettleWindow>& a, const std::vector<SettleWindow>& b, double scale) {
    const auto same = [scale](const SettleWindow& x, const SettleWindow& y) {
        return scale == 1 ? x == y : sameTime(scale * x.start, y.start) && sameTime(scale * x.end, y.end);
    };
    const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same);
    return std::min(i == a.end() ? kInfinity : scale * i->start, j == b.end() ? kInfinity : j->start);
}

/// Compares the end times only if equal steps are spread over the whole time.
bool sameIntegration(const Project& a, const Project& b) {
    const IntegrationOptions p = integrationOf(a), q = integrationOf(b);
    return sameSettings(a, b, Makes::Motion) && (p.steps == 0 || p.end == q.end) && p.threads == q.threads;
}

}  // namespace

template <int Dim>
void MotionPass<Dim>::clear() {
    m_project.reset();
    m_deformer.reset();
    m_making = {};
    m_begun = false;
    m_probe.reset();
    m_cache.clear();
    m_known.reset();
    m_result.reset();
    m_restSent = false;
    m_sent.clear();
}

template <int Dim>
KeptFrames MotionPass<Dim>::set(const Shape<Dim>& shape, std::shared_ptr<const Project> project,
                                const std::vector<FramePtr>& frames) {
    KeptFrames kept{1, -kInfinity};
    const double end = motionEnd(*project);
    const bool sameFlow = m_project && shape.rest == m_shape.rest && shape.material == m_shape.material &&
                          sameIntegration(*m_project, *project);
    const bool isFree = integrationOf(*project).steps == 0;
    const bool fits = sameFlow && isFree && settlingOf(*m_project) == settlingOf(*project);
    if (sameFlow) {
        const auto &before = designOf(*m_project).handles, &after = designOf(*project).handles;
        const auto keptWith = [&](double scale) -> KeptFrames {
            return {scale, std::min(firstDifference(before, after, scale),
                                    firstDifference(settlingOf(*m_project), settlingOf(*project), scale))};
        };
        // Steps of fixed number are placed elsewhere when the clock changes.
        const double scale = timeScale(before, after);
        if (scale == 1 || isFree) kept = keptWith(scale);
        // The first motion alone may have become shorter.
        if (const KeptFrames same = keptWith(1); scale != 1 && same.upTo >= kept.upTo) kept = same;
    }
    const bool same = kept.upTo == kInfinity && kept.timeScale == 1 && end == m_end;
    m_shape = shape;
    const auto previous = std::exchange(m_project, std::move(project));
    if (same) return kept;
    const bool isElastic = std::isinf(m_shape.material->memory);
    if (!fits || !isElastic || kept.timeScale != 1 || end != m_end)
        m_known.reset();
    else if (isWhole())
        m_known = Known{previous, {}, frames};
    if (m_known)
        m_known->from = lastDifference(designOf(*m_known->project).handles, designOf(*m_project).handles);
    m_end = end;
    if (!fits) m_deformer.reset(), m_making = {};
    m_begun = false;
    m_probe.reset();
    m_result.reset();
    if (kept.timeScale != 1) changeClock(kept.timeScale);
    PoseCache<Dim> later = forgetFrom(std::min(kept.upTo, end));
    if (m_known && m_known->project == previous) m_known->states = std::move(later);
    if (m_known && m_known->from >= end) m_known.reset();
    if (m_cache.last() && isDense()) return {kept.timeScale, m_cache.last()->time};
    const auto own = std::move(m_project);
    auto deformer = std::move(m_deformer);
    auto making = std::move(m_making);
    clear();
    m_project = own;
    if (fits) m_deformer = std::move(deformer), m_making = std::move(making);
    return {1, -kInfinity};
}

template <int Dim>
PoseCache<Dim> MotionPass<Dim>::forgetFrom(double time) {
    for (const double breakpoint : breakpoints())
        if (sameTime(breakpoint, time)) time = breakpoint;
    PoseCache<Dim> later = m_cache.keepUpTo(time);
    while (!m_sent.empty() && (!m_cache.last() || m_sent.back() > m_cache.last()->time)) m_sent.pop_back();
    return later;
}

/// Returns whether the motion is known to its end, on a single branch.
template <int Dim>
bool MotionPass<Dim>::isWhole() const {
    return m_result && m_result->outcome == Outcome::Done && m_deformer &&
           m_deformer->statistics().snaps.empty();
}

/// Goes on with what was known before a change, if the shape is the same there. Returns false if it is not.
template <int Dim>
bool MotionPass<Dim>::takeKnown(const Sink& sink) {
    const State<Dim>& now = m_deformer->state();
    if (!m_known || !sink.onKnown || now.time >= m_end) return false;
    if (now.time < m_known->from && !sameTime(now.time, m_known->from)) return false;
    const State<Dim>* then = m_known->states.at(now.time);
    if (!then) return false;
    const double size = shapeSize<Dim>(m_shape.rest->points, m_shape.rest->cells).size;
    const double off = (now.points - then->points).colwise().norm().maxCoeff();
    Known known = std::move(*m_known);
    m_known.reset();
    if (off > kSameShape * size) return false;
    for (const FramePtr& frame : known.frames) {
        if (frame->time <= m_sent.back() || sameTime(frame->time, m_sent.back())) continue;
        m_sent.push_back(frame->time);
        sink.onKnown(posed<Dim>(frame));
    }
    m_cache.addLater(std::move(known.states), now.time);
    m_deformer->restore(*m_cache.last());
    return true;
}

/// States at breakpoints keep their bits, because the integrator restarts there.
template <int Dim>
void MotionPass<Dim>::changeClock(double scale) {
    const std::vector<double> all = breakpoints();
    m_cache.retime([&](double time) -> std::optional<double> {
        const auto breakpoint =
            std::find_if(all.begin(), all.end(), [&](double t) { return sameTime(t, scale * time); });
        return breakpoint == all.end() ? std::nullopt : std::optional<double>(*breakpoint);
    });
    for (double& time : m_sent) time *= scale;
}

/// Returns false if the existing frames are too far apart because the film became longer.
template <int Dim>
bool MotionPass<Dim>::isDense() const {
    for (std::size_t i = 1; i < m_sent.size(); ++i)
        if (m_sent[i] - m_sent[i - 1] > 1.5 * frameSpacing()) return false;
    return true;
}

/// Returns false if it was stopped.
template <int Dim>
bool MotionPass<Dim>::begin(const Sink& sink, const std::stop_token& stop) {
    if (!m_restSent) {
        sink.onFrame(restOf(m_shape), 0);
        m_sent = {0};
        m_restSent = true;
    }
    if (!makeDeformer(sink, stop)) return false;
    if (!m_cache.last()) m_cache.add(m_deformer->state());
    m_begun = true;
    return true;
}

/// Makes the deformer in a thread of its own, so that uninterruptible work does not delay a drag. A deformer
/// of another project is adapted to this one when it is ready.
template <int Dim>
bool MotionPass<Dim>::makeDeformer(const Sink& sink, const std::stop_token& stop) {
    while (true) {
        if (!m_making.valid()) beginMaking();
        if (sink.meanwhile && !stop.stop_requested()) sink.meanwhile();
        do {
            if (stop.stop_requested()) return false;
        } while (m_making.wait_for(kLookUp) != std::future_status::ready);
        m_deformer = m_making.get();
        if (m_makingFor == m_project) return true;
    }
}

/// Reuses the symbolic factorization if only the handles changed.
template <int Dim>
void MotionPass<Dim>::beginMaking() {
    m_makingFor = m_project;
    m_making =
        std::async(std::launch::async, [shape = m_shape, handles = heldHandles<Dim>(*m_project, m_shape),
                                        options = integrationOf(*m_project),
                                        start = m_cache.last() ? *m_cache.last() : restOf(m_shape),
                                        deformer = std::exchange(m_deformer, std::nullopt)]() mutable {
            if (deformer)
                deformer->setHandles(std::move(handles));
            else
                deformer.emplace(shape.rest, shape.material, std::move(handles), options,
                                 backEndFactory<Dim>(BackEndKind::Automatic));
            deformer->restore(start);
            deformer->prepare();
            return std::move(*deformer);
        });
}

/// Returns the times at which the integrator must stop: the bounds of motions and handles, the start and the
/// end.
template <int Dim>
std::vector<double> MotionPass<Dim>::breakpoints() const {
    std::vector<double> times = {0, m_end};
    for (const Pin& handle : designOf(*m_project).handles) {
        times.insert(times.end(), {handle.activeFrom, handle.activeTo});
        for (const PinMotion& motion : handle.motions) times.insert(times.end(), {motion.start, motion.end});
    }
    for (const SettleWindow& window : settlingOf(*m_project))
        times.insert(times.end(), {window.start, window.end});
    std::erase_if(times, [this](double t) { return !(t >= 0 && t <= m_end); });
    return times;
}

template <int Dim>
double MotionPass<Dim>::nextBreakpoint(double time) const {
    double next = m_end;
    for (const double t : breakpoints())
        if (t > time) next = std::min(next, t);
    return next;
}

template <int Dim>
double MotionPass<Dim>::frameSpacing() const {
    return std::max(1.0 / kFramesPerUnit, m_end / kMostFrames);
}

template <int Dim>
std::vector<double> MotionPass<Dim>::frameTimes(double from, double to) const {
    const double spacing = frameSpacing();
    std::vector<double> times;
    for (double k = std::floor(from / spacing) + 1; k * spacing < to - 0.25 * spacing; ++k)
        if (k * spacing > from) times.push_back(k * spacing);
    return times;
}

template <int Dim>
void MotionPass<Dim>::run(const Sink& sink, std::stop_token stop) {
    if (!m_begun && !begin(sink, stop)) return;
    const double size = shapeSize<Dim>(m_shape.rest->points, m_shape.rest->cells).size;
    const auto send = [&](const State<Dim>& state) {
        m_sent.push_back(state.time);
        sink.onFrame(state, m_deformer->statistics().constraintError * size);
    };
    while (m_deformer->state().time < m_end) {
        typename Deformer<Dim>::Watch watch;
        const double breakpoint = nextBreakpoint(m_deformer->state().time);
        watch.frames =
            frameTimes(std::max(m_sent.empty() ? 0 : m_sent.back(), m_deformer->state().time), breakpoint);
        watch.onFrame = send;
        watch.progress = [&](double time) { sink.progress(time, m_end); };
        if (sink.within) watch.within = [&](const Within& now) { sink.within(now.time, m_end); };
        watch.stop = stop;
        const AdvanceResult result = m_deformer->advance(breakpoint, watch);
        if (result.outcome == Outcome::Cancelled) return;
        m_cache.add(m_deformer->state());
        send(m_deformer->state());
        if (result.outcome == Outcome::Done && takeKnown(sink)) break;
        if (result.outcome == Outcome::Done) continue;
        m_result = result;
        m_known.reset();
        return;
    }
    m_known.reset();
    m_result = AdvanceResult{};
}

template <int Dim>
Message MotionPass<Dim>::snaps() const {
    const double size = shapeSize<Dim>(m_shape.rest->points, m_shape.rest->cells).size;
    return snapRemark(m_deformer->statistics().snaps, Dim, size, Playback::kSecondsPerUnit);
}

template <int Dim>
Points<Dim> MotionPass<Dim>::velocity(double time, const Points<Dim>& pose, std::stop_token stop) try {
    const Points<Dim> none(Dim, 0);
    if (!m_project || stop.stop_requested()) return none;
    if (!m_probe) m_probe.emplace(m_shape, *m_project);
    return stop.stop_requested() ? none : m_probe->at(time, pose);
} catch (...) {
    m_probe.reset();
    throw;
}

template <int Dim>
Points<Dim> MotionPass<Dim>::influence(const std::vector<int>& handles, double time, const Points<Dim>& pose,
                                       std::stop_token stop) {
    if (!m_project || stop.stop_requested()) return Points<Dim>(Dim, 0);
    return influenceAt<Dim>(m_shape, *m_project, handles, time, pose);
}

template class MotionPass<2>;
template class MotionPass<3>;

}  // namespace wend
