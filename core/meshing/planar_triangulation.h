#pragma once

// CGAL's types of the refinement are used by planar_refinement.cpp only.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "core/base/types.h"

namespace wend::planar {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

/// A face that knows whether it is inside the outline. CGAL's own mark (is_in_domain) is undefined in the
/// middle of an insertion, which is when boundaries are tested for encroachment.
template <typename Base = CGAL::Delaunay_mesh_face_base_2<Kernel>>
class MarkedFace : public Base {
  public:
    template <typename Tds>
    struct Rebind_TDS {  // NOLINT(readability-identifier-naming): CGAL's name
        using Other = MarkedFace<typename Base::template Rebind_TDS<Tds>::Other>;
    };
    using Base::Base;

    bool inside = false;
};

using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<int, Kernel, CGAL::Delaunay_mesh_vertex_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, MarkedFace<>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Values of a vertex's info that are not mesh indices.
constexpr int newVertex = -1;
constexpr int frameVertex = -2;

/// The triangulation of the mesher: updates the faces' marks whenever a point is added, and stores the length
/// below which boundaries count as conforming.
class MarkedTriangulation : public Cdt {
  public:
    using Cdt::Cdt;

    double shortestSquared = 0;

    /// Marks a new face as on the same side of the outline as the face beyond its edge of the hole, unless
    /// that edge is constrained. The edges are given from the faces outside of the hole.
    template <typename EdgeIterator, typename FaceIterator>
    Vertex_handle star_hole(const Point& p, EdgeIterator firstEdge, EdgeIterator endEdge,
                            FaceIterator firstFace, FaceIterator endFace) {
        const std::vector<Edge> edges(firstEdge, endEdge);
        const auto vertex = Cdt::star_hole(p, firstEdge, endEdge, firstFace, endFace);
        vertex->info() = newVertex;
        for (const auto& [face, i] : edges)
            face->neighbor(i)->inside = face->inside != face->is_constrained(i);
        return vertex;
    }
};

/// Bounds the circumradius and the smallest angle. The circumradius (not the longest edge) as size spreads
/// vertices evenly: no two are nearer than the bound, and no place is farther from one. See RefinementBounds
/// for `shortest`.
class SizeAndAngle {
  public:
    using Face_handle = MarkedTriangulation::Face_handle;

    /// How bad a triangle is; it is refined if its size is over 1 or its angle is under the bound.
    struct Quality {
        double size = 0;   // squared circumradius over its bound
        double angle = 0;  // squared sine of the smallest angle
        /// Orders the worst first: the largest, then the sharpest.
        bool operator<(const Quality& other) const {
            if (size > 1 || other.size > 1) return size > other.size;
            return angle < other.angle;
        }
    };

    class Is_bad {  // NOLINT(readability-identifier-naming): CGAL's name
      public:
        explicit Is_bad(const SizeAndAngle& bounds) : m_bounds(&bounds) {}

        CGAL::Mesh_2::Face_badness operator()(const Quality& q) const {
            return q.size > 1 || q.angle < m_bounds->m_sineSquared ? CGAL::Mesh_2::BAD
                                                                   : CGAL::Mesh_2::NOT_BAD;
        }
        CGAL::Mesh_2::Face_badness operator()(const Face_handle& face, Quality& q) const {
            q = m_bounds->quality(face);
            return (*this)(q);
        }

      private:
        const SizeAndAngle* m_bounds;
    };

    SizeAndAngle() = default;
    /// `factor` multiplies the circumradius at a place; it may be empty, and must outlive this object.
    SizeAndAngle(double circumradius, double sineSquared, double shortest,
                 const std::function<double(const Vec2&)>* factor = nullptr)
        : m_radiusSquared(circumradius * circumradius),
          m_sineSquared(sineSquared),
          m_shortestSquared(shortest * shortest),
          m_factor(factor) {}

    Is_bad is_bad_object() const { return Is_bad(*this); }  // NOLINT(readability-identifier-naming)

  private:
    /// Triangles with all edges at most `shortest` are never bad: their circumcentres may be beyond a
    /// boundary that counts as conforming. Triangles with one such edge are not refined for their angle.
    Quality quality(const Face_handle& face) const {
        const Point &p = face->vertex(0)->point(), &q = face->vertex(1)->point(),
                    &r = face->vertex(2)->point();
        double a = CGAL::squared_distance(q, r), b = CGAL::squared_distance(r, p),
               c = CGAL::squared_distance(p, q);
        const double twiceArea = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
        const double areaSquared = twiceArea * twiceArea;  // 4 A²
        if (a > b) std::swap(a, b);
        if (b > c) std::swap(b, c);
        if (a > b) std::swap(a, b);
        if (c <= m_shortestSquared) return {0, 1};
        // R² = a² b² c² / 16 A²; sin² of the angle between the two longest edges = 4 A² / (b² c²). A flat
        // triangle's circumcircle says nothing about its size: its longest edge counts there (R > 0.65 c from
        // angles of 130° on).
        const double size = std::min(a * b * c / (4 * areaSquared), 0.65 * 0.65 * c);
        return {size / radiusSquared(p, q, r), a <= m_shortestSquared ? 1 : areaSquared / (b * c)};
    }

    double radiusSquared(const Point& p, const Point& q, const Point& r) const {
        if (!m_factor || !*m_factor) return m_radiusSquared;
        const double factor = (*m_factor)({(p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3});
        return factor * factor * m_radiusSquared;
    }

    double m_radiusSquared = 1;
    double m_sineSquared = 0;
    double m_shortestSquared = 0;
    const std::function<double(const Vec2&)>* m_factor = nullptr;
};

}  // namespace wend::planar

namespace CGAL::Mesh_2 {

/// A boundary segment needs an empty diametral circle on its inner side only (CGAL's own rule tests both):
/// points across a gap are not part of the mesh, and narrow gaps would be filled with tiny edges.
template <>
struct Is_locally_conforming_Gabriel<wend::planar::MarkedTriangulation> {
    using Triangulation = wend::planar::MarkedTriangulation;
    using Vertex = Triangulation::Vertex_handle;
    using Face = Triangulation::Face_handle;

    bool operator()(const Triangulation& t, const Face& face, int i) const {
        const Vertex a = face->vertex(Triangulation::cw(i)), b = face->vertex(Triangulation::ccw(i));
        if (squared_distance(a->point(), b->point()) <= t.shortestSquared) return true;
        const Face other = face->neighbor(i);
        return (!face->inside || (*this)(t, a, b, face->vertex(i)->point())) &&
               (!other->inside || (*this)(t, a, b, t.tds().mirror_vertex(face, i)->point()));
    }
    bool operator()(const Triangulation& t, const Vertex& a, const Vertex& b) const {
        Face face;
        int i = 0;
        t.is_edge(a, b, face, i);
        return (*this)(t, face, i);
    }
    bool operator()(const Triangulation& t, const Face& face, int i, const wend::planar::Point& p) const {
        return (*this)(t, face->vertex(Triangulation::cw(i)), face->vertex(Triangulation::ccw(i)), p);
    }
    bool operator()(const Triangulation&, const Vertex& a, const Vertex& b,
                    const wend::planar::Point& p) const {
        return angle(a->point(), p, b->point()) == ACUTE;
    }
};

}  // namespace CGAL::Mesh_2
