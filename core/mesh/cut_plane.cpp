#include "core/mesh/cut_plane.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/cell_geometry.h"

namespace wend {
namespace {

using CutCorner = CutSurface::Corner;

CutCorner vertex(int id) {
    return {id, id, 0};
}

void addTriangle(CutSurface& surface, const CutCorner& a, const CutCorner& b, const CutCorner& c, int cell,
                 bool onCut) {
    surface.triangles.push_back({a, b, c});
    surface.cells.push_back(cell);
    surface.onCut.push_back(onCut);
}

/// Adds a convex polygon as a fan.
void addFan(CutSurface& surface, const std::vector<CutCorner>& polygon, int cell, bool onCut) {
    for (std::size_t k = 2; k < polygon.size(); ++k)
        addTriangle(surface, polygon[0], polygon[k - 1], polygon[k], cell, onCut);
}

/// A facet seen from cells[side]: the other one looks at its back.
void addFacet(CutSurface& surface, const Facet<3>& facet, int side, bool onCut) {
    const auto& v = facet.vertices;
    if (side == 0)
        addTriangle(surface, vertex(v[0]), vertex(v[1]), vertex(v[2]), facet.cells[0], onCut);
    else
        addTriangle(surface, vertex(v[0]), vertex(v[2]), vertex(v[1]), facet.cells[1], onCut);
}

/// Returns the corner where the plane crosses the edge between heights of different sign.
CutCorner crossing(int from, int to, const std::vector<double>& height) {
    return {from, to, height[from] / (height[from] - height[to])};
}

std::vector<double> heights(const Points3& pose, const CutPlane& plane) {
    std::vector<double> height(static_cast<std::size_t>(pose.cols()));
    for (Eigen::Index i = 0; i < pose.cols(); ++i) height[i] = plane.height(pose.col(i));
    return height;
}

/// Adds the part of a boundary facet that stays (Sutherland and Hodgman's clipping of one polygon at one
/// plane).
void addClipped(CutSurface& surface, const Facet<3>& facet, const std::vector<double>& height) {
    std::vector<CutCorner> polygon;
    for (int k = 0; k < 3; ++k) {
        const int a = facet.vertices[k], b = facet.vertices[(k + 1) % 3];
        if (height[a] <= 0) polygon.push_back(vertex(a));
        if ((height[a] <= 0) != (height[b] <= 0)) polygon.push_back(crossing(a, b, height));
    }
    addFan(surface, polygon, facet.cells[0], false);
}

/// Adds the section of a cell: a triangle or a quadrilateral, its corners in order, facing along the normal.
void addSection(CutSurface& surface, const Cell<3>& cell, int index, const Points3& pose,
                const CutPlane& plane, const std::vector<double>& height) {
    std::vector<int> behind, before;
    for (int v : cell) (height[v] <= 0 ? behind : before).push_back(v);
    if (behind.empty() || before.empty()) return;
    std::vector<CutCorner> polygon;
    for (std::size_t i = 0; i < behind.size(); ++i)
        for (std::size_t j = 0; j < before.size(); ++j) {
            // Reverses every second row, so that the corners of a quadrilateral are in cyclic order.
            const std::size_t column = i % 2 == 0 ? j : before.size() - 1 - j;
            polygon.push_back(crossing(behind[i], before[column], height));
        }
    const auto place = [&](const CutCorner& c) -> Vec3 {
        return (1 - c.weight) * pose.col(c.from) + c.weight * pose.col(c.to);
    };
    // Twice the area vector of the whole polygon: corners may coincide where the plane meets vertices.
    Vec3 normal = Vec3::Zero();
    const Vec3 first = place(polygon[0]);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        normal += (place(polygon[i]) - first).cross(place(polygon[i + 1]) - first);
    if (normal.dot(plane.normal) < 0) std::reverse(polygon.begin(), polygon.end());
    addFan(surface, polygon, index, true);
}

}  // namespace

CutSurface wholeSurface(const std::vector<Facet<3>>& facets) {
    CutSurface surface;
    for (const auto& facet : facets)
        if (!facet.interior()) addFacet(surface, facet, 0, false);
    return surface;
}

/// Keeps the cells whose centroid is below the plane; the facets between these and all others are on the cut.
CutSurface wholeCellCut(const SimplicialMesh<3>& mesh, const std::vector<Facet<3>>& facets,
                        const Points3& pose, const CutPlane& plane) {
    std::vector<bool> stays(mesh.cells.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        stays[c] = plane.height(centroid<3>(pose, mesh.cells[c])) <= 0;
    CutSurface surface;
    for (const auto& facet : facets) {
        const bool first = stays[facet.cells[0]], second = facet.interior() && stays[facet.cells[1]];
        if (first != second) addFacet(surface, facet, first ? 0 : 1, facet.interior());
    }
    return surface;
}

CutSurface exactCut(const SimplicialMesh<3>& mesh, const std::vector<Facet<3>>& facets, const Points3& pose,
                    const CutPlane& plane) {
    const std::vector<double> height = heights(pose, plane);
    CutSurface surface;
    for (const auto& facet : facets)
        if (!facet.interior()) addClipped(surface, facet, height);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        addSection(surface, mesh.cells[c], static_cast<int>(c), pose, plane, height);
    return surface;
}

}  // namespace wend
