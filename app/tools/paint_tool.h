#pragma once

#include "app/document/material_edits.h"
#include "app/tools/stroke_tool.h"

namespace wend {

/// Paints the material: a stroke over the surface lays soft balls with the chosen φ and stiffness into the
/// solid, as one group of regions and one undo step.
class PaintTool : public StrokeTool {
  public:
    explicit PaintTool(SolidSurface& surface) : StrokeTool(surface, QColor(0xd4, 0x7a, 0x1e)) {}

    void setColour(const MaterialPaint& paint) { m_paint = paint; }
    void setAlong(StiffAlong along) { m_along = along; }

    QString hint() const override;

  protected:
    Vec<3> axisAt(const PosedFrame<3>& frame, const SolidHit& hit) const override;
    void take(const std::vector<Dab>& dabs, Qt::KeyboardModifiers modifiers) override;

  private:
    std::vector<Vec<3>> axes(const std::vector<Dab>& dabs) const;
    Vec<3> wayAt(const Vec<3>& p) const;

    MaterialPaint m_paint;
    StiffAlong m_along = StiffAlong::Axis;
};

}  // namespace wend
