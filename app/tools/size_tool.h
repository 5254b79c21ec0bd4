#pragma once

#include "app/tools/stroke_tool.h"

namespace wend {

/// Paints how fine the mesh is: a stroke makes the edges under it longer or shorter by a factor, with Ctrl
/// the other way round. Draws the regions that the panel has chosen.
class SizeTool : public StrokeTool<3> {
  public:
    using StrokeTool::StrokeTool;

    void setFactor(double factor) { m_factor = factor; }
    void setShown(const std::vector<Region<3>>& regions) { m_shown = regions; }

    void paint(QPainter& painter) const override;

  protected:
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override { return QColor(0x2a, 0x8a, 0x7a); }

  private:
    double m_factor = 0.5;
    std::vector<Region<3>> m_shown;
};

}  // namespace wend
