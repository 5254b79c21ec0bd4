#pragma once

#include <optional>

#include "app/tools/solid_shape_view.h"
#include "app/views/volume/draw_mesh.h"
#include "app/views/volume/volume_picture.h"
#include "core/mesh/cut_plane.h"
#include "core/mesh/point_locator.h"
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

/// Intersects rays with a surface embedded in a solid, such as in a cage: the pointer touches the visible
/// surface, and the cells are those that contain the place. Boxes and the cell grid are built for the first
/// ray, and boxes refitted for the first ray after a change of the pose.
class SkinCasting {
  public:
    void takeSkin() { m_skinStale = true; }
    void takePose() { m_poseStale = true; }
    /// Returns the nearest point of the skin on the ray that the cut has left; cell −1 if there is none.
    SolidHit hit(const Ray& ray, const VolumePicture& solid, const Points<3>& skinPose,
                 const std::optional<CutPlane>& cut);
    /// Boxes and triangles that the last hit() looked at.
    int visited() const { return m_visited; }

  private:
    void update(const VolumePicture& solid, const Points<3>& skinPose);
    int cellOf(const VolumePicture& solid, const Vec<3>& point) const;
    int vertexOf(const VolumePicture& solid, int cell, const Vec<3>& point) const;

    TriangleTree m_tree;                       // of the skin's pose
    std::optional<PointLocator<3>> m_locator;  // at rest
    std::vector<bool> m_isOuter;               // per vertex of the solid
    bool m_skinStale = true, m_poseStale = true;
    int m_visited = 0;
};

}  // namespace wend
