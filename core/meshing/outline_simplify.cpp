#include "core/meshing/outline_simplify.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

namespace wend {
namespace {

namespace simplification = CGAL::Polyline_simplification_2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using LineStructure =
    CGAL::Triangulation_data_structure_2<simplification::Vertex_base_2<Kernel>,
                                         CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using LineTriangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, LineStructure, CGAL::Exact_predicates_tag>>;

using Line = std::vector<Kernel::Point_2>;

Line closedLine(const std::vector<Vec2>& loop) {
    Line points;
    points.reserve(loop.size() + 1);
    for (const auto& p : loop) points.emplace_back(p.x(), p.y());
    points.push_back(points.front());
    return points;
}

/// Returns the index of the last point of the straight run that begins with the points at `first` and after
/// it: exactly in one line, and forwards only.
std::size_t endOfRun(const Line& line, std::size_t first) {
    std::size_t last = first + 1;
    while (last + 1 < line.size() && CGAL::collinear(line[first], line[last], line[last + 1]) &&
           CGAL::angle(line[last - 1], line[last], line[last + 1]) == CGAL::OBTUSE)
        ++last;
    return last;
}

/// Removes the points within long straight runs, which cost nothing in the simplification either. There each
/// of n takes a time that grows with n², because all triangles of the other side meet in its vertex. Short
/// runs are left to the simplification, which removes them in its own order.
Line withoutLongRuns(const Line& line) {
    constexpr std::size_t kLongRun = 1000;  // segments; outlines of most pictures have none
    Line points;
    points.reserve(line.size());
    for (std::size_t at = 0; at + 1 < line.size();) {
        const std::size_t last = endOfRun(line, at);
        const std::size_t step = last - at > kLongRun ? last - at : 1;
        for (std::size_t k = at; k < last; k += step) points.push_back(line[k]);
        at = last;
    }
    points.push_back(line.back());
    return points;
}

/// Simplifies the lines as CGAL's simplify() does, but queues them in the order given: CGAL orders them by
/// their addresses, so that its choice between equal costs varies between runs.
void simplify(LineTriangulation& triangulation, const std::vector<LineTriangulation::Constraint_id>& lines,
              double tolerance) {
    using Simplification =
        simplification::Polyline_simplification_2<LineTriangulation, simplification::Squared_distance_cost,
                                                  simplification::Stop_above_cost_threshold>;
    Simplification work(triangulation, simplification::Squared_distance_cost(),
                        simplification::Stop_above_cost_threshold(tolerance * tolerance));
    while (!work.mpq->empty()) work.mpq->pop();
    for (const auto& line : lines) work.initialize_costs(line);
    while (work()) {
    }
}

}  // namespace

Outline simplified(const Outline& outline, double tolerance) {
    if (!(tolerance > 0)) return outline;
    LineTriangulation triangulation;
    std::vector<LineTriangulation::Constraint_id> ids;
    for (const auto& loop : outline.loops) {
        const Line line = withoutLongRuns(closedLine(loop));
        ids.push_back(triangulation.insert_constraint(line.begin(), line.end()));
    }
    simplify(triangulation, ids, tolerance);
    Outline result;
    for (const auto& id : ids) {
        auto& loop = result.loops.emplace_back();
        for (auto v = triangulation.vertices_in_constraint_begin(id);
             v != triangulation.vertices_in_constraint_end(id); ++v)
            loop.emplace_back((*v)->point().x(), (*v)->point().y());
        loop.pop_back();  // the first point again
    }
    return result;
}

}  // namespace wend
