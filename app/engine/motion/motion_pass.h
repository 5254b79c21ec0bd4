#pragma once

#include <functional>
#include <future>
#include <map>
#include <optional>

#include "app/engine/motion/frame.h"
#include "app/engine/motion/velocity_probe.h"
#include "app/engine/shape/shape.h"
#include "app/project/edits/handle_comparison.h"
#include "core/base/message.h"
#include "core/integration/deformer.h"

namespace wend {

/// States by time from which the integration can continue. Changing a handle at time t keeps all states up to
/// t.
template <int Dim>
class PoseCache {
  public:
    void clear() { m_states.clear(); }
    void add(const State<Dim>& state) { m_states.insert_or_assign(state.time, state); }
    /// Keeps the states up to a time and returns the others.
    PoseCache keepUpTo(double time) {
        PoseCache later;
        while (!m_states.empty() && m_states.rbegin()->first > time)
            later.m_states.insert(m_states.extract(std::prev(m_states.end())));
        return later;
    }
    /// Adds the states of another cache that are later than a time.
    void addLater(PoseCache other, double time) { m_states.merge(other.keepUpTo(time).m_states); }
    /// Returns the state at a time that is nearly this one, or null.
    const State<Dim>* at(double time) const {
        for (const auto& [own, state] : m_states)
            if (sameTime(own, time)) return &state;
        return nullptr;
    }
    /// Changes the time of every state, or drops it where the function returns nothing.
    void retime(const std::function<std::optional<double>(double)>& timeOf) {
        std::map<double, State<Dim>> states;
        for (auto& [time, state] : m_states) {
            const auto other = timeOf(time);
            if (!other) continue;
            state.time = *other;
            states.insert_or_assign(*other, std::move(state));
        }
        m_states = std::move(states);
    }
    /// Returns the newest state, or null.
    const State<Dim>* last() const { return m_states.empty() ? nullptr : &m_states.rbegin()->second; }
    std::size_t size() const { return m_states.size(); }

  private:
    std::map<double, State<Dim>> m_states;
};

/// The whole motion of a project at final quality, computed once and continued where it changes. Stops at the
/// breakpoints of the motions' windows, which the integrator never crosses anyway, and keeps the states
/// there: the result is the same bits as one run from the start. Where only the clock changes, the states
/// stay and get other times: then it is the same but for rounding. An elastic shape depends only on where its
/// handles are: once these are where they were before a change, and the shape with them, what was computed
/// for later times is taken from there.
template <int Dim>
class MotionPass {
  public:
    struct Sink {
        std::function<void(const State<Dim>&, double pinError)> onFrame;
        std::function<void(double time, double end)> progress;
        /// Gets the approximate time that the current step has reached; from any thread.
        std::function<void(double time, double end)> within;
        /// Gets a frame that was known from before a change; without it all is computed anew.
        std::function<void(const PosedPtr<Dim>&)> onKnown;
        std::function<void()> meanwhile;  // called while uninterruptible work runs in a thread of its own
    };

    /// Sets the problem and returns how much of the earlier frames stays valid. `frames` are those of the
    /// motion so far.
    KeptFrames set(const Shape<Dim>& shape, std::shared_ptr<const Project> project,
                   const std::vector<FramePtr>& frames = {});
    void clear();

    bool isSet() const { return m_project != nullptr; }
    bool isFinished() const { return m_result.has_value(); }
    /// Returns how the motion ended; valid once it is finished.
    const AdvanceResult& result() const { return *m_result; }
    /// Says whether an elastic shape has snapped; empty if it has not.
    Message snaps() const;
    const State<Dim>& state() const { return *m_cache.last(); }
    double end() const { return m_end; }

    /// Integrates until the end, an inversion or a stop. Frames are emitted in order of time.
    void run(const Sink& sink, std::stop_token stop);
    /// Solves for v̂ at a pose of this motion. Returns no columns if that fails, or if it was stopped before
    /// the solver began. The motion itself stays unchanged, even on exceptions.
    Points<Dim> velocity(double time, const Points<Dim>& pose, std::stop_token stop);
    /// Returns the influence of some handles on all vertices in the first row (influenceAt).
    Points<Dim> influence(const std::vector<int>& handles, double time, const Points<Dim>& pose,
                          std::stop_token stop);

  private:
    bool begin(const Sink& sink, const std::stop_token& stop);
    bool makeDeformer(const Sink& sink, const std::stop_token& stop);
    void beginMaking();
    std::vector<double> frameTimes(double from, double to) const;
    std::vector<double> breakpoints() const;
    double nextBreakpoint(double time) const;
    void changeClock(double scale);
    PoseCache<Dim> forgetFrom(double time);
    bool isWhole() const;
    bool takeKnown(const Sink& sink);
    double frameSpacing() const;
    bool isDense() const;

    Shape<Dim> m_shape;
    std::shared_ptr<const Project> m_project;
    std::optional<Deformer<Dim>> m_deformer;
    std::future<Deformer<Dim>> m_making;         // a deformer that is not ready yet, …
    std::shared_ptr<const Project> m_makingFor;  // … and the project that it will be of
    bool m_begun = false;                        // the deformer is that of this project
    std::optional<VelocityProbe<Dim>> m_probe;   // once a velocity was asked for
    PoseCache<Dim> m_cache;
    /// The part of an elastic motion behind a change.
    struct Known {
        std::shared_ptr<const Project> project;  // whose motion it is
        PoseCache<Dim> states = {};
        std::vector<FramePtr> frames;
        double from = 0;  // when the handles are again where they were
    };
    std::optional<Known> m_known;
    std::optional<AdvanceResult> m_result;
    double m_end = 0;
    std::vector<double> m_sent;  // times of frames
    bool m_restSent = false;
};

}  // namespace wend
