#pragma once

#include <vector>

#include "app/session/frame.h"

namespace wend {

/// The samples of the pointer while handles are dragged. Where the shape could not follow, the path ends at
/// what was reached.
class DragGesture {
  public:
    DragGesture(std::vector<int> handles, const Grip& grip);

    const std::vector<int>& handles() const { return m_handles; }
    const Grip& grip() const { return m_grip; }

    /// Another sample, from the start; returns its number.
    int add(const Amount& amount);
    void follow(const ShapeFrame& live);

    /// The newest sample, or what was reached if the shape has stopped short of it.
    Amount amount() const;
    bool isStopped() const { return m_stopped; }
    /// What was really gone, simplified: begins with zero; a single point if nothing moved.
    std::vector<Amount> path(double tolerance) const;
    /// The straight way to where it has come.
    std::vector<Amount> straight() const;

  private:
    struct Sample {
        Amount amount;
        bool reached = true;
    };
    std::vector<int> m_handles;
    Grip m_grip;
    std::vector<Sample> m_samples;
    int m_followed = 0;  // samples that live frames have covered
    bool m_stopped = false;
};

}  // namespace wend
