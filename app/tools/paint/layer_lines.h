#pragma once

#include <QPainter>
#include <vector>

#include "app/project/design.h"
#include "app/project/project_fwd.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// Outlines of a picture's layer at rest: the border of its regions and the bounds of its soft edge.
/// Overlapping balls, as in a stroke, have a common border.
struct RestLines {
    std::vector<std::vector<Vec<2>>> border, soft;
};
RestLines linesOf(const std::vector<MaterialRegion>& layer, const SimplicialMesh<2>& rest);

/// Maps a line from the rest shape to a pose; in pieces where it leaves the shape.
std::vector<std::vector<Vec<2>>> carriedLine(const std::vector<Vec<2>>& line, const SimplicialMesh<2>& rest,
                                             const PointLocator<2>& locator, const Points<2>& pose);

/// Draws regions of a picture where they are now.
class RegionLines {
  public:
    void setRegions(std::vector<MaterialRegion> regions);
    void paint(QPainter& painter, PictureShapeView& view);

  private:
    std::vector<MaterialRegion> m_regions;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    RestLines m_lines;  // of these on that mesh
};

/// Draws the layer that is chosen, where it is now.
class LayerLines {
  public:
    void setLayer(const QString& name) { m_name = name; }
    void paint(QPainter& painter, PictureShapeView& view);
    void paint(QPainter& painter, SolidShapeView& view);

  private:
    std::vector<MaterialRegion> layerOf(const Design& design) const;

    QString m_name;  // null: none
    std::shared_ptr<const Project> m_project;
    QString m_drawn;
    RegionLines m_lines;  // of that name and project; in the plane
};

}  // namespace wend
