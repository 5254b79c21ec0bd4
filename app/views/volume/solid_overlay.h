#pragma once

#include "app/tools/paint/layer_lines.h"
#include "app/tools/pins/onion_skin.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

/// Paints pins, paths, names, tools and the legend over a solid. The widget is transparent to the mouse.
class SolidOverlay : public QWidget {
  public:
    explicit SolidOverlay(SolidCanvas& canvas);

    /// Draws what does not belong to tools: pins, paths, the worst place, the axes.
    void paintMarks(QPainter& painter);
    /// Marks a cell of a mesh as long as that is shown.
    void markCell(int cell, const std::shared_ptr<const void>& mesh);
    /// Outlines regions; none if empty.
    void setDetailRegions(const std::vector<SoftRegion>& regions);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    SolidCanvas& m_canvas;
    LayerLines m_layer;
    RegionLines m_detailRegions;
    OnionSkin<3> m_onion;
    int m_marked = -1;                       // a cell …
    std::shared_ptr<const void> m_markedOf;  // … of this mesh
};

}  // namespace wend
