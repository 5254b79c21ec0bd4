#pragma once

#include <optional>

#include "app/tools/solid_surface.h"
#include "app/view/volume/draw_mesh.h"
#include "core/mesh/cut_plane.h"
#include "core/mesh/triangle_tree.h"

namespace wend {

/// What rays meet of a surface that is cut and bent: its boxes are made when the first ray comes, and
/// refitted when the first one comes after a change of the pose.
class RayCasting {
  public:
    void takeSurface(CutSurface surface);
    void takePose() { m_poseStale = true; }
    /// The nearest triangle that the ray meets; cell −1 if there is none.
    SolidHit hit(const Ray& ray, const Points<3>& pose);
    /// Boxes and triangles that the last hit() looked at.
    int visited() const { return m_visited; }

  private:
    const TriangleTree& tree(const Points<3>& pose);

    CutSurface m_surface;
    std::optional<CutPoints> m_points;
    TriangleTree m_tree;
    bool m_surfaceStale = true, m_poseStale = true;
    int m_visited = 0;
};

}  // namespace wend
