#pragma once

#include <QColor>

#include "app/tools/solid_surface.h"

namespace wend {

/// A brush over a solid: lays balls around the rest places of what is under the pointer. `[` and `]` change
/// its size, Esc gives up the stroke.
class StrokeTool : public SolidTool {
  public:
    StrokeTool(SolidSurface& surface, const QColor& colour) : SolidTool(surface), m_colour(colour) {}

    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

  protected:
    struct Dab {
        Location<3> place;
        Vec<3> rest;
        double radius;  // in the domain's units
        Vec<3> axis;    // see axisAt()
    };
    /// A direction at rest that a ball brings along; zero without one.
    virtual Vec<3> axisAt(const PosedFrame<3>&, const SolidHit&) const { return Vec<3>::Zero(); }
    /// A stroke is complete; it has at least one ball.
    virtual void take(const std::vector<Dab>& dabs, Qt::KeyboardModifiers modifiers) = 0;
    static std::vector<Ball<3>> ballsOf(const std::vector<Dab>& dabs);

  private:
    void dab();

    QColor m_colour;
    bool m_active = false;
    double m_radius = 30;  // pixels
    QPointF m_at;
    bool m_over = false;  // the pointer is over the view
    std::vector<Dab> m_dabs;
};

}  // namespace wend
