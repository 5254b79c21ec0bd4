#include "app/views/volume/fault_marks.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "app/style/marks.h"

namespace wend {

namespace {

constexpr std::size_t kMost = 60000;  // triangles
constexpr double kLift = 5e-4;        // of the diagonal

}  // namespace

std::vector<DrawVertex> faultMarks(const PosedFrame<3>& frame, const PoseFaults<3>& faults,
                                   const std::function<bool(const Vec<3>&)>& hidden) {
    const SimplicialMesh<3>& rest = *frame.rest;
    const double side = cellMeasure<3>(rest.points, rest.cells.front()) > 0 ? 1 : -1;
    std::vector<DrawVertex> marks;
    const auto add = [&](const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
        const std::array<Vec<3>, 3> corners{a, b, c};
        if (marks.size() > 3 * kMost || std::ranges::any_of(corners, hidden)) return;
        const Vec<3> normal = side * (b - a).cross(c - a).stableNormalized();
        for (const Vec<3>& p : corners)
            marks.push_back(drawVertex(p + kLift * frame.diagonal * normal, normal, kWrong));
    };
    for (const auto& place : faults.crossings)
        for (const int t : place.members) {
            const auto& [a, b, c] = faults.border[t];
            add(faults.points.col(a), faults.points.col(b), faults.points.col(c));
        }
    const Points<3>& pose = frame.pose;
    for (const auto& place : faults.blown)
        for (const int cell : place.members) {
            const auto& [a, b, c, d] = rest.cells[cell];
            for (const auto& [p, q, r] : {std::array{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}})
                add(pose.col(p), pose.col(q), pose.col(r));
        }
    return marks;
}

}  // namespace wend
