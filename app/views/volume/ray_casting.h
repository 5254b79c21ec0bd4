#pragma once

#include <optional>

#include "app/tools/solid_shape_view.h"
#include "app/views/volume/draw_mesh.h"
#include "core/mesh/cut_plane.h"
#include "core/mesh/triangle_tree.h"

namespace wend {

/// Intersects rays with a cut and deformed surface: bounding boxes are built for the first ray, and refitted
/// for the first ray after a change of the pose.
class RayCasting {
  public:
    void takeSurface(CutSurface surface);
    void takePose() { m_poseStale = true; }
    /// Returns the nearest triangle that the ray hits; cell −1 if there is none.
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
