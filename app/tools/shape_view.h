#pragma once

#include <QPointF>
#include <QTabletEvent>
#include <algorithm>
#include <optional>
#include <vector>

#include "app/engine/motion/frame.h"

namespace wend {

class ShapeSession;

/// The place under the pointer: on the rest shape and in the view.
struct Touch {
    Place place;
    Vec3 point;
};

struct Ray {
    Vec3 origin, direction;  // direction has length 1
};

/// Place of a vertex mark on the drawn shape.
struct VertexMark {
    Vec3 at;
    bool hidden;
};

/// The view of a picture or of a solid, as tools see it: in the coordinates of space, with z = 0 in pictures.
class ShapeView {
  public:
    virtual ~ShapeView() = default;
    virtual ShapeSession& session() = 0;
    virtual int dimension() const = 0;
    virtual QPointF onScreen(const Vec3& p) const = 0;
    /// Returns the length in the domain of a pixel of the screen at a point.
    virtual double pixelSize(const Vec3& at) const = 0;
    virtual Ray ray(const QPointF& widget) const = 0;
    virtual Vec3 viewDirection() const = 0;
    virtual std::optional<Touch> touch(const QPointF& widget) const = 0;
    /// Returns whether something of the shape is in front of a place of it, or it is cut off. A picture looks
    /// at the place in the frame, a solid at the point p, where the pointer may have led it.
    virtual bool isHidden(const Place& place, const Vec3& p) const = 0;
    /// Returns whether the point is in the removed part of a cut.
    virtual bool isCutOff(const Vec3&) const { return false; }
    /// Returns the visible place of a cell of the drawn frame; nothing if it is covered or cut off.
    virtual std::optional<Vec3> placeOf(const ShapeFrame& frame, int cell) const = 0;
    /// Returns the marks of vertices that are not cut off.
    virtual std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const = 0;
    /// Returns the session's frame; null if the document has another dimension.
    FramePtr frame();
    /// Returns the session's frame, with the material that is being painted.
    virtual FramePtr shownFrame() const = 0;
    /// Shows the material of another frame, or none, until the motion with it arrives, or the project
    /// changes; `lasts`: the next change will contain it.
    virtual void showMaterial(const FramePtr& painted, bool lasts = false) = 0;
    virtual void redraw() = 0;
    /// Returns whether tools may show manipulators: only one is shown at a time.
    virtual bool showsManipulators() const { return true; }

    /// Returns the pressure of a pen in ]0, 1]; 1 for devices without pressure.
    double pressure() const { return m_pressure; }
    /// Takes the pressure from a tablet event; Qt's synthesized mouse events follow it.
    void takePressure(QTabletEvent& event) {
        const bool tells = event.pointingDevice()->hasCapability(QInputDevice::Capability::Pressure);
        const bool pressed = event.buttons() & Qt::LeftButton;
        m_pressure = tells && pressed ? std::max(kMinPressure, event.pressure()) : 1;
        event.ignore();
    }

  private:
    static constexpr double kMinPressure = 0.01;
    double m_pressure = 1;
};

/// Returns the point under the pointer in the screen-parallel plane through p.
inline Vec3 acrossTheScreen(const ShapeView& view, const Vec3& p, const QPointF& widget) {
    const Ray ray = view.ray(widget);
    const Vec3 normal = view.viewDirection();
    return ray.origin + normal.dot(p - ray.origin) / normal.dot(ray.direction) * ray.direction;
}

}  // namespace wend
