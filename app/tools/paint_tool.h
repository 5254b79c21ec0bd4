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

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void paint(QPainter& painter) const override;

  private:
    void dab();

    MaterialPaint m_paint;
    bool m_active = false;
    double m_radius = 30;  // pixels
    QPointF m_at;
    struct Dab {
        int vertex;
        Vec<3> rest;
        double radius;  // in the domain's units
    };
    std::vector<Dab> m_dabs;
};

}  // namespace wend
