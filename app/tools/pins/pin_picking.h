#pragma once

#include "app/tools/shape_tool.h"

namespace wend {

/// True if something of the shape is seen in front of the pin's point.
template <int Dim>
bool isCovered(SurfaceOf<Dim>& surface, const PinView<Dim>& pin, std::size_t point);
template <>
bool isCovered<2>(ToolSurface& surface, const PinView<2>& pin, std::size_t point);
template <>
bool isCovered<3>(SolidSurface& surface, const PinView<3>& pin, std::size_t point);

/// True if its mark is drawn faintly: what it holds is covered, or all of an area is cut away.
template <int Dim>
bool isMarkCovered(SurfaceOf<Dim>& surface, const PinView<Dim>& pin);

/// Of marks that lie within reach of the pointer the one that is picked: what is seen in front comes before
/// what the shape covers, then the nearest.
class PinPick {
  public:
    void offer(int handle, double distance, bool covered) {
        const bool farther = covered == m_covered ? distance > m_distance : covered;
        if (m_handle >= 0 && farther) return;
        m_handle = handle;
        m_distance = distance;
        m_covered = covered;
    }
    /// −1: none.
    int handle() const { return m_handle; }

  private:
    int m_handle = -1;
    double m_distance = 0;
    bool m_covered = false;
};

/// The handle whose mark is within reach of a point of the widget, if need be one that does not hold now, or
/// −1. `through`: what lies in front does not matter.
template <int Dim>
int markUnder(SurfaceOf<Dim>& surface, const QPointF& widget, bool through);

/// The handle of which that is a part: of many points one is within reach, of a region in the plane the point
/// lies inside; or −1.
template <int Dim>
int partUnder(SurfaceOf<Dim>& surface, const QPointF& widget, bool through);

/// The handle whose way is within reach of a point of the widget, or −1.
template <int Dim>
int wayUnder(SurfaceOf<Dim>& surface, const QPointF& widget);

}  // namespace wend
