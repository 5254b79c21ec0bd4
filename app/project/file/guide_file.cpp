#include "app/project/file/guide_file.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/mesh/mesh_file.h"

namespace wend {
namespace {

using Segment = std::array<int, 2>;

/// Returns the segments of lines, whose nodes run from end to end; lines of second order have their middle
/// node last.
std::vector<Segment> linesOf(const CellList& cells) {
    std::vector<Segment> segments;
    for (int c = 0; c < cells.size(); ++c) {
        const std::span<const int> nodes = cells[c];
        if (cells.dimension(c) != 1 || nodes.size() < 2) continue;
        if (cells.kinds[static_cast<std::size_t>(c)] == CellKind::Line3) {
            segments.push_back({nodes[0], nodes[2]});
            segments.push_back({nodes[2], nodes[1]});
            continue;
        }
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k) segments.push_back({nodes[k], nodes[k + 1]});
    }
    return segments;
}

/// Returns the edges that only one triangle has.
std::vector<Segment> borderOf(const std::vector<std::array<int, 3>>& triangles) {
    std::map<Segment, int> count;
    for (const auto& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
            ++count[{a, b}];
        }
    std::vector<Segment> border;
    for (const auto& [edge, uses] : count)
        if (uses == 1) border.push_back(edge);
    return border;
}

}  // namespace

GuideMesh<3> readGuide(const std::string& path, const PlaneFrame* plane) try {
    const MeshFile file = readMeshFile(path, MeshNeeds::Points);
    GuideMesh<3> guide;
    guide.points = file.points;
    if (plane) {
        guide.points = plane->toPlane(file.points);
        guide.points.row(2).setZero();
        guide.segments = linesOf(file.cells);
        if (guide.segments.empty()) guide.segments = borderOf(file.triangles);
        if (guide.segments.empty()) throw InputError("has no line to slide along");
    } else {
        guide.triangles = file.triangles;
        if (guide.triangles.empty()) guide.segments = linesOf(file.cells);
        if (guide.triangles.empty() && guide.segments.empty())
            throw InputError("has no surface or line to slide on");
    }
    return guide;
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
