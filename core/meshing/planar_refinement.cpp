#include "core/meshing/planar_refinement.h"

#include <cmath>
#include <mutex>
#include <numbers>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/meshing/outline_check.h"
#include "core/meshing/planar_triangulation.h"

namespace wend {

struct PlanarDomain::Triangulation : planar::MarkedTriangulation {};

namespace {

using planar::MarkedTriangulation;
using planar::Point;
using Mesher = CGAL::Delaunay_mesher_2<MarkedTriangulation, planar::SizeAndAngle>;
using Face = MarkedTriangulation::Face_handle;
using Vertex = MarkedTriangulation::Vertex_handle;

// Boundaries are split into pieces of this times the circumradius: about the mean edge that the refinement
// makes inside.
constexpr double boundaryPerRadius = 1.3;

/// Inserts all points of the outline, and then its edges as constraints.
void insertOutline(MarkedTriangulation& triangulation, const Outline& outline) {
    // Inserts all points at once (in spatial order) first: inserting them one by one with their edges is ten
    // times slower.
    std::vector<Point> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (const auto& loop : outline.loops) {
        const std::size_t start = points.size();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            points.emplace_back(loop[k].x(), loop[k].y());
            edges.emplace_back(start + k, start + (k + 1) % loop.size());
        }
    }
    triangulation.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
    for (auto v : triangulation.finite_vertex_handles()) v->info() = planar::newVertex;
}

/// Inserts four vertices far around, so that no edge of the outline is on the convex hull: points on a
/// slanted edge are rounded, and the hull must stay convex.
void insertFrame(MarkedTriangulation& triangulation) {
    CGAL::Bbox_2 box;
    for (auto v : triangulation.finite_vertex_handles()) box += v->point().bbox();
    const double size = (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
    for (const double x : {box.xmin() - size, box.xmax() + size})
        for (const double y : {box.ymin() - size, box.ymax() + size})
            triangulation.insert(Point(x, y))->info() = planar::frameVertex;
}

constexpr int kSamples = 64;  // of an outline's edge, and of a triangle's side, where sizes are not even

Vec2 vec(const Point& p) {
    return {p.x(), p.y()};
}

/// Returns how many edges of length 1, times the factor, fit into the segment up to each place.
std::vector<double> lengthsAlong(const Point& a, const Point& b, const PlanarDomain::Factor& factor) {
    const int samples = factor ? kSamples : 1;
    const double step = std::sqrt(CGAL::squared_distance(a, b)) / samples;
    std::vector<double> sums{0};
    for (int k = 0; k < samples; ++k)
        sums.push_back(sums.back() +
                       step / (factor ? factor(vec(a) + (k + 0.5) / samples * (vec(b) - vec(a))) : 1));
    return sums;
}

/// Returns where to split a segment, in ]0, 1[, into pieces of at most `length` times the factor.
std::vector<double> splits(const Point& a, const Point& b, double length,
                           const PlanarDomain::Factor& factor) {
    const std::vector<double> sums = lengthsAlong(a, b, factor);
    const int pieces = static_cast<int>(std::ceil(sums.back() / length));
    std::vector<double> places;
    for (int k = 1; k < pieces; ++k) {
        const double part = static_cast<double>(k) / pieces, wanted = part * sums.back();
        const auto next = std::upper_bound(sums.begin() + 1, sums.end() - 1, wanted);
        const auto index = next - sums.begin();
        const double within = (wanted - *(next - 1)) / (*next - *(next - 1));
        places.push_back(factor ? (static_cast<double>(index - 1) + within) /
                                      (static_cast<double>(sums.size()) - 1)
                                : part);
    }
    return places;
}

/// Returns ∫ f⁻² over a triangle, by its middle, or by its four parts where it is large.
double weightedArea(const Point& a, const Point& b, const Point& c, const PlanarDomain::Factor& factor,
                    double large) {
    const double longest =
        std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
    if (!factor || longest <= large * large) {
        const double area = CGAL::area(a, b, c);
        if (!factor) return area;
        const double f = factor((vec(a) + vec(b) + vec(c)) / 3);
        return area / (f * f);
    }
    const Point ab = CGAL::midpoint(a, b), bc = CGAL::midpoint(b, c), ca = CGAL::midpoint(c, a);
    return weightedArea(a, ab, ca, factor, large) + weightedArea(ab, b, bc, factor, large) +
           weightedArea(ca, bc, c, factor, large) + weightedArea(ab, bc, ca, factor, large);
}

/// Splits the outline's edges evenly into pieces of at most `length` times the factor. The refinement would
/// halve them, so that the number of vertices would grow in powers of two.
void splitBoundaries(MarkedTriangulation& triangulation, double length, const PlanarDomain::Factor& factor) {
    std::vector<std::pair<Vertex, Vertex>> edges;
    for (const auto& edge : triangulation.finite_edges())
        if (triangulation.is_constrained(edge) &&
            (factor || triangulation.segment(edge).squared_length() > length * length))
            edges.emplace_back(edge.first->vertex(edge.first->ccw(edge.second)),
                               edge.first->vertex(edge.first->cw(edge.second)));
    for (auto [from, to] : edges) {
        const Point a = from->point(), b = to->point();
        for (const double part : splits(a, b, length, factor)) {
            Face face;
            int i = 0;
            triangulation.is_edge(from, to, face, i);
            from = triangulation.insert(a + (b - a) * part, MarkedTriangulation::EDGE, face, i);
            from->info() = planar::newVertex;
        }
    }
}

void insertPoints(MarkedTriangulation& triangulation, const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t known = triangulation.number_of_vertices();
        const Vertex v = triangulation.insert(Point(points[i].x(), points[i].y()));
        const bool isNew = triangulation.number_of_vertices() > known;
        if (!isNew && v->info() >= 0)
            throw InputError({sentence("Core", "points %1 and %2 are the same, %3"), v->info(), i,
                              placeName<2>(points[i])});
        v->info() = static_cast<int>(i);
    }
}

/// Floods from the infinite face; crossing a constrained edge changes sides. Right because no two edges of
/// the outline overlap.
void markInside(MarkedTriangulation& triangulation) {
    for (auto face : triangulation.all_face_handles()) face->tds_data().clear();
    std::vector<Face> front{triangulation.infinite_face()};
    front[0]->inside = false;
    front[0]->tds_data().mark_processed();
    while (!front.empty()) {
        const Face face = front.back();
        front.pop_back();
        for (int i = 0; i < 3; ++i) {
            const Face next = face->neighbor(i);
            if (next->tds_data().processed()) continue;
            next->tds_data().mark_processed();
            next->inside = face->inside != face->is_constrained(i);
            front.push_back(next);
        }
    }
    for (auto face : triangulation.all_face_handles()) {
        face->tds_data().clear();
        face->set_in_domain(face->inside);
    }
}

bool touchesInside(const MarkedTriangulation& triangulation, Vertex v) {
    auto face = triangulation.incident_faces(v);
    const auto first = face;
    do
        if (face->inside) return true;
    while (++face != first);
    return false;
}

void requireInside(const MarkedTriangulation& triangulation) {
    for (auto v : triangulation.finite_vertex_handles())
        if (v->info() >= 0 && !touchesInside(triangulation, v))
            throw InputError({sentence("Core", "point %1, %2, is outside the shape"), v->info(),
                              placeName<2>({v->point().x(), v->point().y()})});
}

/// CGAL's assertions (enabled in this file) throw; their output on standard error is redundant. Called once,
/// because the handler is shared by all threads.
void silenceCgal() {
    static std::once_flag silenced;
    std::call_once(silenced, [] {
        const auto silent = [](const char*, const char*, const char*, int, const char*) {};
        CGAL::set_error_handler(silent);
        CGAL::set_warning_handler(silent);
    });
}

/// Runs f and converts CGAL's errors to InputError.
template <typename Function>
auto guarded(const Function& f) {
    silenceCgal();
    try {
        return f();
    } catch (const CGAL::Failure_exception& e) {
        throw InputError({sentence("Core", "the outline cannot be triangulated (%1)"), e.expression()});
    }
}

double sineSquared(double degrees) {
    const double sine = std::sin(degrees * std::numbers::pi / 180);
    return sine * sine;
}

/// Returns false if the bounds on work are reached first.
bool refine(MarkedTriangulation& triangulation, const RefinementBounds& bounds,
            const PlanarDomain::Factor& factor, const std::stop_token& stop) {
    triangulation.shortestSquared = bounds.shortest * bounds.shortest;
    Mesher mesher(triangulation, planar::SizeAndAngle(bounds.circumradius, sineSquared(bounds.minAngle),
                                                      bounds.shortest, &factor));
    mesher.init(true);
    const auto most = static_cast<std::size_t>(bounds.maxVertices) + 4;
    // A step may end without a new vertex (a face is put off until an edge is split), so steps are bounded
    // too.
    for (std::size_t step = 0; !mesher.is_refinement_done(); ++step) {
        if (triangulation.number_of_vertices() >= most || step > 4 * most) return false;
        if (step % 256 == 0 && stop.stop_requested()) throw Cancelled();
        mesher.step_by_step_refine_mesh();
    }
    return true;
}

/// Numbers the points first, the other vertices after them in the order of their creation.
SimplicialMesh<2> toMesh(MarkedTriangulation& triangulation, int pointCount) {
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, static_cast<Eigen::Index>(triangulation.number_of_vertices()) - 4);
    int next = pointCount;
    for (auto v : triangulation.finite_vertex_handles()) {
        if (v->info() == planar::frameVertex) continue;
        if (v->info() == planar::newVertex) v->info() = next++;
        mesh.points.col(v->info()) << v->point().x(), v->point().y();
    }
    for (auto face : triangulation.finite_face_handles())
        if (face->inside)
            mesh.cells.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return mesh;
}

}  // namespace

PlanarDomain::PlanarDomain(const Outline& outline, const std::vector<Vec2>& points, Factor factor)
    : m_factor(std::move(factor)), m_pointCount(static_cast<int>(points.size())) {
    guarded([&] {
        auto triangulation = std::make_unique<Triangulation>();
        insertOutline(*triangulation, outline);
        insertFrame(*triangulation);
        insertPoints(*triangulation, points);
        markInside(*triangulation);
        requireInside(*triangulation);
        m_triangulation = std::move(triangulation);
    });
}

PlanarDomain::~PlanarDomain() = default;

double PlanarDomain::area() const {
    CGAL::Bbox_2 box;
    for (auto face : m_triangulation->finite_face_handles())
        if (face->inside) box += m_triangulation->triangle(face).bbox();
    const double large = std::hypot(box.x_span(), box.y_span()) / kSamples;
    double sum = 0;
    for (auto face : m_triangulation->finite_face_handles())
        if (face->inside)
            sum += weightedArea(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point(),
                                m_factor, large);
    return sum;
}

double PlanarDomain::perimeter() const {
    double sum = 0;
    for (const auto& edge : m_triangulation->finite_edges())
        if (m_triangulation->is_constrained(edge)) {
            const auto segment = m_triangulation->segment(edge);
            sum += lengthsAlong(segment.source(), segment.target(), m_factor).back();
        }
    return sum;
}

int PlanarDomain::vertexCount() const {
    return static_cast<int>(m_triangulation->number_of_vertices());
}

std::optional<SimplicialMesh<2>> PlanarDomain::refined(const RefinementBounds& bounds,
                                                       const std::stop_token& stop) const {
    return guarded([&]() -> std::optional<SimplicialMesh<2>> {
        MarkedTriangulation triangulation(*m_triangulation);
        splitBoundaries(triangulation, boundaryPerRadius * bounds.circumradius, m_factor);
        markInside(triangulation);
        if (!refine(triangulation, bounds, m_factor, stop)) return {};
        return toMesh(triangulation, m_pointCount);
    });
}

SimplicialMesh<2> PlanarDomain::unrefined() const {
    MarkedTriangulation triangulation(*m_triangulation);
    return toMesh(triangulation, m_pointCount);
}

}  // namespace wend
