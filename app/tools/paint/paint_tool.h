#pragma once

#include "app/engine/motion/edited_material.h"
#include "app/project/edits/material_edits.h"
#include "app/tools/stroke_tool.h"
#include "app/tools/tool_kind.h"

namespace wend {

enum class PaintDeed { Paint, Erase, Smooth };

/// Paints the material: a stroke adds soft balls with the brush's φ, stiffness or direction to one layer, in
/// one undo step. Ctrl erases on all layers, Shift smooths, Shift-click draws a straight line from the last
/// place, Alt-click picks up the material. The eraser erases without Ctrl. Paint is shown at once; the motion
/// follows.
class PaintTool : public StrokeTool {
  public:
    using Deed = PaintDeed;
    /// Paint: modifiers choose the operation; Erase: always erases.
    PaintTool(ShapeView& view, Brush& tip, Deed deed) : StrokeTool(view, tip), m_deed(deed) {}

    void press(const QMouseEvent& event) override;

  protected:
    QString strokeHint() const override;
    bool takesAway() const override { return deed() == Deed::Erase; }
    bool drawsLines() const override { return true; }
    void begin() override;
    Vec3 axisAt(const ShapeFrame& frame, const Touch& touch) const override;
    void follow(const std::vector<Dab>& dabs) override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override;
    void paintStroke(QPainter&, const std::vector<Dab>&) const override {}  // the view shows it

  private:
    Deed deed() const;
    Vec3 wayAt(const Vec3& p) const;
    MaterialRegion regionOf(const std::vector<Dab>& dabs, std::size_t i) const;
    double phiFor(const Dab& dab) const;
    Stiffness stiffnessFor(const std::vector<Dab>& dabs, std::size_t i) const;
    Vec3 directionOf(const std::vector<Dab>& dabs, std::size_t i) const;
    double amountOf(const Dab& dab) const;
    std::vector<int> cellsIn(const Dab& dab) const;
    PaintedLayer layer() const;
    QString title(const std::vector<Dab>& dabs) const;
    std::string aim() const;
    Design painted(const std::vector<Dab>& dabs);
    FramePtr laid(const Design& next);

    Deed m_deed;
    std::unique_ptr<EditedMaterial> m_material;  // when the stroke began
    PaintedLayer m_layer;                        // of the stroke
    std::vector<MaterialRegion> m_regions;       // as much of the stroke as is settled
    std::size_t m_first = 0;                     // the first layer that it may change
};

ToolKind paintTool();
ToolKind combTool();
ToolKind eraserTool();

}  // namespace wend
