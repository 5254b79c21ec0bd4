#pragma once

#include <QPainter>
#include <vector>

#include "app/document/design.h"
#include "app/document/project_fwd.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// Where a layer of a picture's material lies at rest: the border of its regions, and where its soft edge
/// begins and ends. Of balls that overlap, as those of a stroke, the border of them all.
struct RestLines {
    std::vector<std::vector<Vec<2>>> border, soft;
};
RestLines linesOf(const std::vector<MaterialRegion<2>>& layer, const SimplicialMesh<2>& rest);

/// The same of a line of the rest shape in a pose; in pieces where it leaves the shape.
std::vector<std::vector<Vec<2>>> carriedLine(const std::vector<Vec<2>>& line, const SimplicialMesh<2>& rest,
                                             const PointLocator<2>& locator, const Points<2>& pose);

/// Draws regions of a picture where they are now.
class RegionLines {
  public:
    void setRegions(std::vector<MaterialRegion<2>> regions);
    void paint(QPainter& painter, ToolSurface& surface);

  private:
    std::vector<MaterialRegion<2>> m_regions;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    RestLines m_lines;  // of these on that mesh
};

/// Draws the layer that is chosen, where it is now.
template <int Dim>
class LayerLines {
  public:
    void setLayer(const QString& name) { m_name = name; }
    void paint(QPainter& painter, SurfaceOf<Dim>& surface);

  private:
    std::vector<MaterialRegion<Dim>> layerOf(const Design<Dim>& design) const;

    QString m_name;  // null: none
    std::shared_ptr<const Project> m_project;
    QString m_drawn;
    RegionLines m_lines;  // of that name and project; in the plane
};

}  // namespace wend
