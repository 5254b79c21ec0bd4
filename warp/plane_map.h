#pragma once

#include <optional>
#include <vector>

#include "core/mesh/point_locator.h"
#include "core/mesh/simplicial_mesh.h"
#include "warp/svg_path.h"

namespace wend {

/// The map rest → pose of a partition of the plane, for curves. Pictures take the linear map of each cell,
/// whose kinks along edges would be visible in a curve. This one has the same values at vertices and takes
/// the gradients there into account: with barycentric coordinates b of p,
///   F(p) = Σ b_i (x_i + ½ G_i (p − X_i)),
/// where G_i is the mean of the cells' gradients around vertex i, by their areas. It is continuous, and exact
/// for affine maps; for smooth ones its error is of third order in the size of cells, one order better than
/// without the G_i. Points outside follow the nearest point of the border: F(X) + G(X) (p − X).
class PlaneMap {
  public:
    PlaneMap(SimplicialMesh<2> rest, Points2 pose);
    PlaneMap(const PlaneMap&) = delete;  // the locator refers to its points
    PlaneMap& operator=(const PlaneMap&) = delete;

    Vec2 operator()(const Vec2& p) const;
    /// Returns the gradients G_i, interpolated: a continuous approximation of the map's gradient.
    Mat2 gradient(const Vec2& p) const;
    /// Returns whether the point is inside, or within rounding of the border.
    bool contains(const Vec2& p) const;
    /// Returns the mean length of edges at rest.
    double cellSize() const { return m_cellSize; }
    /// Returns the closed curves around the pose.
    std::vector<std::vector<Vec2>> border() const;

  private:
    /// A place of the partition, and what is beyond it.
    struct Place {
        std::array<int, 3> vertices;
        Vec3 weights;
        Vec2 beyond;
    };
    Place placeOf(const Vec2& p) const;
    Place nearestOnBorder(const Vec2& p) const;

    SimplicialMesh<2> m_rest;
    Points2 m_pose;
    PointLocator<2> m_locator;
    std::vector<Mat2> m_gradients;             // at vertices
    std::vector<std::array<int, 2>> m_border;  // edges
    double m_cellSize = 1;
};

/// Returns the affine map that is nearest to a map at some points of the plane, which is also near to its
/// gradient where points are on a line.
Affine nearestAffine(const PlaneMap& map, const std::vector<Vec2>& points);

}  // namespace wend
