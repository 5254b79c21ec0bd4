#pragma once

#include "app/project/design.h"
#include "app/tools/stroke_tool.h"
#include "app/tools/tool_kind.h"

namespace wend {

enum class PaintDeed { Paint, Erase, Smooth };

/// Paints the material: a stroke adds soft balls with the brush's φ, stiffness or direction to one layer, in
/// one undo step. Ctrl erases on all layers, Shift smooths, Shift-click draws a straight line from the last
/// place, Alt-click picks up the material. The eraser erases without Ctrl. Paint is shown at once; the motion
/// follows.
template <int Dim>
class PaintTool : public StrokeTool<Dim> {
  public:
    using Deed = PaintDeed;
    /// Paint: modifiers choose the operation; Erase: always erases.
    PaintTool(SurfaceOf<Dim>& view, Brush& tip, Deed deed) : StrokeTool<Dim>(view, tip), m_deed(deed) {}

    void press(const QMouseEvent& event) override;

  protected:
    using typename StrokeTool<Dim>::Dab;
    QString strokeHint() const override;
    bool takesAway() const override { return deed() == Deed::Erase; }
    bool drawsLines() const override { return true; }
    void begin() override;
    Vec<Dim> axisAt(const PosedFrame<Dim>& frame, const Touch<Dim>& touch) const override;
    void follow(const std::vector<Dab>& dabs) override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override;
    void paintStroke(QPainter&, const std::vector<Dab>&) const override {}  // the view shows it

    using StrokeTool<Dim>::brush;
    using StrokeTool<Dim>::session;
    using StrokeTool<Dim>::surface;

  private:
    Deed deed() const;
    Vec<Dim> wayAt(const Vec<Dim>& p) const;
    MaterialRegion regionOf(const std::vector<Dab>& dabs, std::size_t i) const;
    double phiFor(const Dab& dab) const;
    Stiffness stiffnessFor(const std::vector<Dab>& dabs, std::size_t i) const;
    Vec<Dim> directionOf(const std::vector<Dab>& dabs, std::size_t i) const;
    double amountOf(const Dab& dab) const;
    Mat<Dim> thereAt(const Dab& dab) const;
    std::vector<int> cellsIn(const Dab& dab) const;
    std::string layer() const;
    QString title(const std::vector<Dab>& dabs) const;
    std::string aim() const;
    Design painted(const std::vector<Dab>& dabs);
    std::shared_ptr<const Material<Dim>> laid(const Design& next);
    std::string folder() const { return session().document().folder().toStdString(); }

    Deed m_deed;
    PosedPtr<Dim> m_frame;                              // when the stroke began, with its material
    std::string m_layer;                                // of the stroke
    std::vector<MaterialRegion> m_regions;              // as much of the stroke as is settled
    std::size_t m_first = 0;                            // the first region that it may change …
    std::shared_ptr<const Material<Dim>> m_below = {};  // … and below
};

extern template class PaintTool<2>;
extern template class PaintTool<3>;

ToolKind paintTool();
ToolKind combTool();
ToolKind eraserTool();

}  // namespace wend
