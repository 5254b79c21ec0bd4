#pragma once

#include <optional>

#include "app/views/volume/camera.h"
#include "core/mesh/cut_plane.h"

namespace wend {

/// The silhouette edges of a triangle surface.
class Contour {
  public:
    /// Takes triangles of point indices.
    void takeTriangles(const std::vector<std::array<int, 3>>& triangles);
    void takePoints(Points<3> points) { m_points = std::move(points); }
    /// Returns both ends of each silhouette edge in a view, without parts above the plane.
    Points<3> ends(const Eigen::Matrix4d& view, bool orthographic, const std::optional<CutPlane>& clip) const;

  private:
    struct Edge {
        int from, to;
        int one, other;  // triangles; −1 for none
    };
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<Edge> m_edges;
    Points<3> m_points;
};

}  // namespace wend
