#pragma once

#include <vector>

#include "app/session/motion/frame.h"

namespace wend {

/// A way, and when it was gone: the seconds since its beginning, which increase.
struct TimedPath {
    std::vector<Amount> points;
    std::vector<double> seconds;
};

/// The samples of the pointer while handles are dragged. Where the shape could not follow, the path ends at
/// what was reached.
class DragGesture {
  public:
    /// `records`: when the samples come matters, too.
    DragGesture(std::vector<int> handles, const Grip& grip, bool records = false);

    const std::vector<int>& handles() const { return m_handles; }
    const Grip& grip() const { return m_grip; }
    bool records() const { return m_records; }
    /// The newest sample as it was taken, and its number.
    const Amount& newest() const { return m_newest; }
    int sampleCount() const { return static_cast<int>(m_samples.size()) - 1; }
    /// That it lasts so far.
    double seconds() const { return m_samples.back().seconds - m_samples.front().seconds; }

    /// Another sample, from the start, and when it was taken by a clock of the caller's; returns its number.
    int add(const Amount& amount, double seconds = 0);
    void follow(const ShapeFrame& live);

    /// The newest sample, or what was reached if the shape has stopped short of it.
    Amount amount() const;
    bool isStopped() const { return m_stopped; }
    /// What was really gone, simplified: begins with zero; a single point if nothing moved.
    std::vector<Amount> path(double tolerance) const;
    /// The same with its times, rests included, simplified in space and time: the hand is nowhere earlier or
    /// later by more than 20 ms beyond the tolerance. A single point if nothing moved.
    TimedPath timedPath(double tolerance) const;
    /// The straight way to where it has come.
    std::vector<Amount> straight() const;

  private:
    struct Sample {
        Amount amount;
        double seconds = 0;
        bool reached = true;
    };
    std::vector<int> m_handles;
    Grip m_grip;
    bool m_records;
    std::vector<Sample> m_samples;
    Amount m_newest = Amount::Zero();  // the newest, before the shape was there
    int m_followed = 0;                // samples that live frames have covered
    bool m_stopped = false;
};

}  // namespace wend
