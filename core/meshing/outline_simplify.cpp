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

std::vector<Kernel::Point_2> closedLine(const std::vector<Vec2>& loop) {
    std::vector<Kernel::Point_2> points;
    points.reserve(loop.size() + 1);
    for (const auto& p : loop) points.emplace_back(p.x(), p.y());
    points.push_back(points.front());
    return points;
}

}  // namespace

Outline simplified(const Outline& outline, double tolerance) {
    if (!(tolerance > 0)) return outline;
    LineTriangulation triangulation;
    std::vector<LineTriangulation::Constraint_id> ids;
    for (const auto& loop : outline.loops) {
        const auto line = closedLine(loop);
        ids.push_back(triangulation.insert_constraint(line.begin(), line.end()));
    }
    simplification::simplify(triangulation, simplification::Squared_distance_cost(),
                             simplification::Stop_above_cost_threshold(tolerance * tolerance));
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
