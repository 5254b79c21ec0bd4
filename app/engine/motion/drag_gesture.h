#pragma once

#include <vector>

#include "app/engine/motion/frame.h"

namespace wend {

/// A path with the time of each point in seconds since its start; times increase strictly.
struct TimedPath {
    std::vector<Amount> points;
    std::vector<double> seconds;
};

/// The pointer samples of a drag. If the shape could not follow, the path ends where it stopped.
class DragGesture {
  public:
    /// `records`: keep the times of the samples, too.
    DragGesture(std::vector<int> handles, const Grip& grip, bool records = false);

    const std::vector<int>& handles() const { return m_handles; }
    const Grip& grip() const { return m_grip; }
    bool records() const { return m_records; }
    /// Returns the newest sample as it was added, whether or not the shape has reached it.
    const Amount& newest() const { return m_newest; }
    int sampleCount() const { return static_cast<int>(m_samples.size()) - 1; }
    /// Returns the duration of the drag so far.
    double seconds() const { return m_samples.back().seconds - m_samples.front().seconds; }

    /// Adds a sample with its offset from the start and its time on the caller's clock. Returns its index.
    int add(const Amount& amount, double seconds = 0);
    void follow(const ShapeFrame& live);

    /// Returns the newest sample, or the last reachable one if the shape has stopped.
    Amount amount() const;
    bool isStopped() const { return m_stopped; }
    /// Returns the reached path, simplified. It starts at zero and is a single point if nothing moved.
    std::vector<Amount> path(double tolerance) const;
    /// Returns the reached path with its times, including pauses, simplified in space and time: no point is
    /// off by more than 20 ms beyond the tolerance. A single point if nothing moved.
    TimedPath timedPath(double tolerance) const;
    /// Returns the straight path to the reached point.
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
