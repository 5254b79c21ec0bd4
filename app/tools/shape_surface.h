#pragma once

#include <QPointF>
#include <QTabletEvent>
#include <algorithm>
#include <optional>

#include "app/session/shape_session.h"
#include "core/mesh/point_locator.h"

namespace wend {

/// What lies under the pointer: where on the shape, and where that is seen.
template <int Dim>
struct Touch {
    Location<Dim> place;
    Vec<Dim> point;
};

/// The view of a picture or of a solid, as tools see it that work on both.
template <int Dim>
class ShapeSurface {
  public:
    virtual ~ShapeSurface() = default;
    virtual ShapeSession& session() = 0;
    virtual QPointF toWidget(const Vec<Dim>& p) const = 0;
    /// Length in the domain of a pixel of the screen at a point.
    virtual double pixelSize(const Vec<Dim>& at) const = 0;
    virtual std::optional<Touch<Dim>> touch(const QPointF& widget) const = 0;
    /// The session's frame, with the material that is being painted.
    virtual PosedPtr<Dim> shownFrame() const = 0;
    /// Shows another material until the motion with it is there, or the project changes; `lasts`: it is what
    /// the next change brings.
    virtual void showMaterial(std::shared_ptr<const Material<Dim>> painted, bool lasts = false) = 0;
    virtual void redraw() = 0;
    /// Whether manipulators of tools are shown: there is one at a time.
    virtual bool showsManipulators() const { return true; }

    /// How hard a pen is pressed, in ]0, 1]; 1 for what tells no pressure.
    double pressure() const { return m_pressure; }

  protected:
    /// From a pen's own event; the pointer's events that Qt makes of it follow.
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

}  // namespace wend
