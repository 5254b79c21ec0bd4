#pragma once

#include "app/engine/shape/depth.h"
#include "app/tools/stroke_tool.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Paints the depth of a picture where it overlaps itself: a stroke sets an order, with Ctrl resets it, with
/// Shift inverts it. Ordered parts are hatched and have a badge.
class DepthTool : public StrokeTool {
  public:
    using StrokeTool::StrokeTool;

    void paint(QPainter& painter) const override;

  protected:
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override;

  private:
    /// Returns the order, greater than 0 in front and less behind.
    double order() const;

    mutable CellDepths m_orders{cellOrders};
};

ToolKind depthTool();

}  // namespace wend
