#pragma once

#include "core/mesh/triangle_tree.h"
#include "core/motion/handle.h"

namespace wend {

/// The part of a guide on which a point slides.
enum class Track { None, Face, Line, Corner };

/// The place of a guide nearest to a point.
template <int Dim>
struct Contact {
    Vec<Dim> point = Vec<Dim>::Zero();
    Mat<Dim> normals = Mat<Dim>::Zero();  // orthonormal, in the first `count` columns
    int count = 0;  // 1 on faces and on lines in the plane, 2 on lines in space, Dim at corners
};

/// A surface or path on which points slide, as a polyhedron with sharp lines and corners. Nearest places are
/// exact. Normals of faces and tangents of lines are interpolated linearly between the corners (Phong 1975),
/// so that they are continuous where a point passes from one facet to the next, and not smoothed across lines
/// and corners sharper than 50°. Beyond its rim a guide continues along the planes and lines of its last
/// facets.
template <int Dim>
class GuideSurface {
  public:
    /// Throws InputError for a guide without a facet.
    explicit GuideSurface(const GuideMesh<Dim>& mesh);

    /// Returns the part of lowest dimension within a tolerance of the place nearest to p: points do not leave
    /// a sharp line or a corner. Distances are measured from the nearest place on the guide, not from p.
    Track trackAt(const Vec<Dim>& p, double tolerance) const;
    /// Returns the place of the faces, the lines or the corners nearest to p. The guide must have such a
    /// part. p may be anywhere; at equal distances any of the nearest places may be the result, but always
    /// the same one. In the plane a guide has no faces.
    Contact<Dim> contact(Track track, const Vec<Dim>& p) const;

  private:
    void findSharpEdges(const std::vector<std::array<int, 3>>& triangles);
    void smoothNormals(const std::vector<std::array<int, 3>>& triangles);
    void smoothTangents();
    bool isOnRim(const TriangleTree::Nearest& nearest) const;
    Contact<Dim> onFace(const Vec3& p) const;
    Contact<Dim> onLine(const Vec3& p) const;
    Contact<Dim> onCorner(const Vec3& p) const;

    Points3 m_points;  // z = 0 in the plane
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<std::array<int, 2>> m_segments;  // given ones, and sharp edges
    TriangleTree m_faces, m_lines;               // a segment is a triangle of no area
    Points3 m_normals;                           // per triangle those of its three corners
    Points3 m_tangents;                          // per segment those of its two ends
    std::vector<int> m_corners;                  // vertices where lines meet or bend sharply
    std::vector<bool> m_rimEdges;                // per triangle those opposite its corners
    std::vector<bool> m_rimVertices, m_ends;     // per vertex: of such an edge, or of one segment only
};

}  // namespace wend
