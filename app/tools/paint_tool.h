#pragma once

#include "app/document/material_edits.h"
#include "app/tools/solid_surface.h"

namespace wend {

/// Paints the material: a stroke over the surface lays soft balls with the chosen φ and stiffness into the
/// solid, as one group of regions and one undo step.
class PaintTool : public SolidTool {
  public:
    explicit PaintTool(SolidSurface& surface) : SolidTool(surface) {}

    void setColour(const MaterialPaint& paint) { m_paint = paint; }
    void setAlong(StiffAlong along) { m_along = along; }

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

  private:
    void dab();

    std::vector<Vec<3>> axes() const;
    Vec<3> wayAt(const Vec<3>& p) const;

    MaterialPaint m_paint;
    StiffAlong m_along = StiffAlong::Axis;
    bool m_active = false;
    double m_radius = 30;  // pixels
    QPointF m_at;
    bool m_over = false;  // the pointer is over the view
    struct Dab {
        Location<3> place;
        Vec<3> rest;
        double radius;  // in the domain's units
        Vec<3> axis;    // at rest; zero: that of the paint
    };
    std::vector<Dab> m_dabs;
};

}  // namespace wend
