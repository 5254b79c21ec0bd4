#pragma once

#include "app/session/shape/depth.h"
#include "app/tools/stroke_tool.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Paints which part of a picture lies in front where the shape covers itself: a stroke brings what it covers
/// to an order, with Ctrl back to that of what is not painted, with Shift to the other side. What has an
/// order is hatched, and told by a badge.
class DepthTool : public StrokeTool<2> {
  public:
    using StrokeTool<2>::StrokeTool;

    void paint(QPainter& painter) const override;

  protected:
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override;

  private:
    /// Greater than 0 in front, less behind.
    double order() const;

    mutable CellDepths m_orders{cellOrders};
};

ToolKind depthTool();

}  // namespace wend
