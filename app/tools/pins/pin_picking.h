#pragma once

#include "app/session/pins.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// Returns whether something of the shape is in front of the pin's point.
bool isCovered(const ShapeView& view, const PinView& pin, std::size_t point);

/// Returns whether the mark is faint: what it holds is covered, or a whole area is cut away.
bool isMarkCovered(const ShapeView& view, const PinView& pin);

/// Picks one of the marks within reach of the pointer: visible ones before covered ones, then the nearest.
class PinPick {
  public:
    void offer(int handle, double distance, bool covered) {
        const bool farther = covered == m_covered ? distance > m_distance : covered;
        if (m_handle >= 0 && farther) return;
        m_handle = handle;
        m_distance = distance;
        m_covered = covered;
    }
    /// Returns the handle; −1 for none.
    int handle() const { return m_handle; }

  private:
    int m_handle = -1;
    double m_distance = 0;
    bool m_covered = false;
};

/// Returns the handle whose mark is within reach of a point of the widget, including inactive handles, or −1.
/// `through`: ignores what is in front.
int markUnder(ShapeView& view, const QPointF& widget, bool through);

/// Returns the handle with a point within reach, or in the plane with a region that contains the point; or
/// −1.
int partUnder(ShapeView& view, const QPointF& widget, bool through);

/// Returns the handle whose path is within reach of a point of the widget, or −1.
int wayUnder(ShapeView& view, const QPointF& widget);

}  // namespace wend
