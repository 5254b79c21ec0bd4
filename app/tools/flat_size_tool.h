#pragma once

#include "app/tools/outline_settings.h"
#include "app/tools/stroke_tool.h"

namespace wend {

/// Paints how fine the mesh of a picture is: a stroke makes edges under it longer or shorter by a factor,
/// with Ctrl as elsewhere again, with Shift the other way round. What is finer or coarser is circled.
class FlatSizeTool : public StrokeTool<2> {
  public:
    FlatSizeTool(ToolSurface& surface, Brush& brush, const PenValue& factor)
        : StrokeTool<2>(surface, brush), m_factor(factor) {}

    void paint(QPainter& painter) const override;

  protected:
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override { return QColor(0x2a, 0x8a, 0x7a); }

  private:
    double factor() const;

    const PenValue& m_factor;
};

}  // namespace wend
