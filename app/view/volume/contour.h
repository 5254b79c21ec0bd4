#pragma once

#include <optional>

#include "app/view/volume/camera.h"
#include "core/mesh/cut_plane.h"

namespace wend {

/// The edges of a surface of triangles between what faces the viewer and what does not.
class Contour {
  public:
    /// Of triangles that are given as points.
    void takeTriangles(const std::vector<std::array<int, 3>>& triangles);
    void takePoints(Points<3> points) { m_points = std::move(points); }
    /// As both ends of each, seen by this view; without what lies above the plane.
    Points<3> ends(const Eigen::Matrix4d& view, bool orthographic, const std::optional<CutPlane>& clip) const;

  private:
    struct Edge {
        int from, to;
        int one, other;  // triangles; −1: there is none
    };
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<Edge> m_edges;
    Points<3> m_points;
};

}  // namespace wend
