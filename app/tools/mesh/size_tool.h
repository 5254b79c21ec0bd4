#pragma once

#include "app/tools/stroke_tool.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Paints the cell size: a stroke multiplies edge lengths by a factor, with Ctrl resets them, with Shift
/// divides. Shows the mesh and size regions of a picture, or the selected regions of a solid.
template <int Dim>
class SizeTool : public StrokeTool<Dim> {
  public:
    SizeTool(SurfaceOf<Dim>& view, Brush& tip) : StrokeTool<Dim>(view, tip) {
        QObject::connect(&tip.regions(), &Changing::changed, &m_listener, [&view] { view.redraw(); });
    }

    void paint(QPainter& painter) const override;

  protected:
    using typename StrokeTool<Dim>::Dab;
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override { return QColor(0x2a, 0x8a, 0x7a); }

  private:
    using StrokeTool<Dim>::brush;
    using StrokeTool<Dim>::modifiers;
    using StrokeTool<Dim>::session;
    using StrokeTool<Dim>::surface;
    double factor() const;

    QObject m_listener;  // to the brush
};

extern template class SizeTool<2>;
extern template class SizeTool<3>;

ToolKind detailBrushTool();

}  // namespace wend
