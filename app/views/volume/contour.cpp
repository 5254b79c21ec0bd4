#include "app/views/volume/contour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

namespace wend {

void Contour::takeTriangles(const std::vector<std::array<int, 3>>& triangles) {
    m_triangles = triangles;
    std::vector<Edge> sides;
    sides.reserve(3 * triangles.size());
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto [from, to] = std::minmax({triangles[t][k], triangles[t][(k + 1) % 3]});
            sides.push_back({from, to, t, -1});
        }
    std::ranges::sort(sides, {}, [](const Edge& edge) { return std::tuple(edge.from, edge.to, edge.one); });
    m_edges.clear();
    for (const Edge& side : sides) {
        Edge* last = m_edges.empty() ? nullptr : &m_edges.back();
        const bool isShared =
            last != nullptr && last->from == side.from && last->to == side.to && last->other < 0;
        if (isShared)
            last->other = side.one;
        else
            m_edges.push_back(side);
    }
}

Points<3> Contour::ends(const Eigen::Matrix4d& view, bool orthographic,
                        const std::optional<CutPlane>& clip) const {
    const Mat<3> turn = view.topLeftCorner<3, 3>();
    const Vec<3> eye = -(turn.transpose() * view.topRightCorner<3, 1>()), toViewer = turn.row(2);
    std::vector<bool> faces(m_triangles.size());
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
        const Vec<3> a = m_points.col(m_triangles[t][0]);
        const Vec<3> normal =
            (m_points.col(m_triangles[t][1]) - a).cross(m_points.col(m_triangles[t][2]) - a);
        faces[t] = normal.dot(orthographic ? toViewer : Vec<3>(eye - a)) > 0;
    }
    std::vector<Vec<3>> ends;
    for (const Edge& edge : m_edges) {
        if (edge.other >= 0 && faces[edge.one] == faces[edge.other]) continue;
        Vec<3> a = m_points.col(edge.from), b = m_points.col(edge.to);
        const double heightOfA = clip ? clip->height(a) : -1, heightOfB = clip ? clip->height(b) : -1;
        if (heightOfA > 0 && heightOfB > 0) continue;
        if (heightOfA > 0) a += heightOfA / (heightOfA - heightOfB) * (b - a);
        if (heightOfB > 0) b += heightOfB / (heightOfB - heightOfA) * (a - b);
        ends.push_back(a);
        ends.push_back(b);
    }
    Points<3> columns(3, static_cast<Eigen::Index>(ends.size()));
    for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = ends[static_cast<std::size_t>(i)];
    return columns;
}

}  // namespace wend
