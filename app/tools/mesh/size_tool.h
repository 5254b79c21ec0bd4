#pragma once

#include "app/tools/stroke_tool.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Paints the cell size: a stroke multiplies edge lengths by a factor, with Ctrl resets them, with Shift
/// divides. Shows the mesh of a picture.
class SizeTool : public StrokeTool {
  public:
    using StrokeTool::StrokeTool;

    void paint(QPainter& painter) const override;

  protected:
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override { return QColor(0x2a, 0x8a, 0x7a); }

  private:
    double factor() const;
};

ToolKind detailBrushTool();

}  // namespace wend
