#pragma once

#include <QPointF>
#include <QTabletEvent>
#include <algorithm>
#include <optional>

#include "app/session/shape_session.h"
#include "core/mesh/point_locator.h"

namespace wend {

/// The place under the pointer: on the rest shape and in the view.
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
    /// Does the same for a point in the coordinates of space.
    QPointF onScreen(const Vec3& p) const { return toWidget(p.template head<Dim>()); }
    /// Returns the length in the domain of a pixel of the screen at a point.
    virtual double pixelSize(const Vec<Dim>& at) const = 0;
    virtual std::optional<Touch<Dim>> touch(const QPointF& widget) const = 0;
    /// The session's frame, with the material that is being painted.
    virtual PosedPtr<Dim> shownFrame() const = 0;
    /// Shows another material until the motion with it arrives, or the project changes; `lasts`: the next
    /// change will contain it.
    virtual void showMaterial(std::shared_ptr<const Material<Dim>> painted, bool lasts = false) = 0;
    virtual void redraw() = 0;
    /// Returns whether tools may show manipulators: only one is shown at a time.
    virtual bool showsManipulators() const { return true; }

    /// Returns the pressure of a pen in ]0, 1]; 1 for devices without pressure.
    double pressure() const { return m_pressure; }

  protected:
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

}  // namespace wend
