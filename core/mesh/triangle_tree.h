#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// A bounding volume hierarchy of triangles for ray and nearest-point queries, split at the median of the
/// centres along the longest side of their box, with at most four triangles in a leaf. Building takes O(n log
/// n), a query O(log n) as a rule. When points move, refit() updates the boxes in far less time than a new
/// tree takes. Queries may run in several threads at a time.
class TriangleTree {
  public:
    /// The first triangle that a ray meets; −1 for none.
    struct Hit {
        int triangle = -1;
        double distance = std::numeric_limits<double>::infinity();
        int visited = 0;  // boxes and triangles that were looked at
    };

    TriangleTree() = default;
    TriangleTree(const Points3& points, std::vector<std::array<int, 3>> triangles);

    /// Updates the tree to other points of the same triangles.
    void refit(const Points3& points);
    /// Returns the nearest triangle that the ray meets, from either side, with its distance > 0 (Möller and
    /// Trumbore 1997); of several at the same distance the one with the lowest number. `direction` must have
    /// length 1. Triangles in the plane of the ray are not met. An empty tree gives −1 and infinity.
    Hit firstHit(const Vec3& origin, const Vec3& direction) const;
    /// The point of all triangles nearest to p: its triangle (−1 for an empty tree) and the barycentric
    /// weights. Of triangles at the same distance, any one may be the result.
    struct Nearest {
        int triangle = -1;
        Vec3 weights = Vec3::Zero();
    };
    /// Returns the point of all triangles nearest to p, with weights ≥ 0 that sum to 1. Triangles without
    /// area count as the segments or points that they are. The result is the same in every call, also where
    /// several are nearest; it is −1 for an empty tree, and for a p that is not finite.
    Nearest nearest(const Vec3& p) const;
    int triangleCount() const { return static_cast<int>(m_triangles.size()); }

  private:
    /// A box with its triangles, or with two children. The left child follows its parent in the list.
    struct Node {
        Vec3 low, high;
        int first = 0, count = 0;  // of m_order; inner nodes have count 0
        int right = -1;            // the left child is the next node
    };
    int build(int first, int last, const std::vector<Vec3>& centres);
    void fit(Node& node, int index);

    Points3 m_points;
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<int> m_order;  // triangles, those of a leaf side by side
    std::vector<Node> m_nodes;
};

}  // namespace wend
