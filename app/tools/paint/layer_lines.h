#pragma once

#include <QPainter>
#include <vector>

#include "app/project/edits/document.h"
#include "app/project/edits/layer_edits.h"
#include "app/project/project_fwd.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// Outlines of a picture's layer at rest: the border of its regions and the bounds of its soft edge.
/// Overlapping balls, as in a stroke, have a common border.
struct RestLines {
    std::vector<std::vector<Vec2>> border, soft;
};
RestLines linesOf(const std::vector<MaterialRegion>& layer, const SimplicialMesh<2>& rest);

/// Maps a line from the rest shape to a pose; in pieces where it leaves the shape.
std::vector<std::vector<Vec2>> carriedLine(const std::vector<Vec2>& line, const SimplicialMesh<2>& rest,
                                           const PointLocator<2>& locator, const Points2& pose);

/// Draws regions where they are now.
class RegionLines {
  public:
    void setRegions(std::vector<MaterialRegion> regions);
    void setRegions(const std::vector<SoftRegion>& regions);
    void paint(QPainter& painter, PictureShapeView& view);
    void paint(QPainter& painter, SolidShapeView& view) const;

  private:
    std::vector<MaterialRegion> m_regions;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    RestLines m_lines;  // of these on that mesh
};

/// Draws the layer that is chosen, where it is now.
class LayerLines {
  public:
    void setLayer(Id layer) { m_layer = layer; }
    void paint(QPainter& painter, PictureShapeView& view);
    void paint(QPainter& painter, SolidShapeView& view);

  private:
    void takeLayer(const Document& document);

    Id m_layer = Id::None;
    std::shared_ptr<const Project> m_project;
    Id m_drawn = Id::None;
    RegionLines m_lines;  // of that layer and project
};

}  // namespace wend
