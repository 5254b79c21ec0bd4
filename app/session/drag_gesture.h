#pragma once

#include <vector>

#include "app/session/frame.h"

namespace wend {

/// The samples of the pointer while pins are dragged. Where the shape could not follow, the path ends at what
/// was reached.
class DragGesture {
  public:
    DragGesture(std::vector<int> handles, std::vector<Vec<2>> starts);

    const std::vector<int>& handles() const { return m_handles; }
    const std::vector<Vec<2>>& starts() const { return m_starts; }

    /// Another sample, as an offset from the start; returns its number.
    int add(const Vec<2>& offset);
    void follow(const ShapeFrame& live);

    /// The newest sample, or what was reached if the shape has stopped short of it.
    Vec<2> offset() const;
    bool isStopped() const { return m_stopped; }
    /// What was really gone, simplified: begins with zero; a single point if nothing moved.
    std::vector<Vec<2>> path(double tolerance) const;

  private:
    struct Sample {
        Vec<2> offset;
        bool reached = true;
    };
    std::vector<int> m_handles;
    std::vector<Vec<2>> m_starts;
    std::vector<Sample> m_samples;
    int m_followed = 0;  // samples that live frames have covered
    bool m_stopped = false;
};

}  // namespace wend
