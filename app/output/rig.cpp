#include "app/output/rig.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace wend {
namespace {

/// Returns the closed outlines of triangles with the same orientation. The choice is arbitrary at a vertex
/// that several outlines share.
std::vector<std::vector<int>> outlinesOf(const std::vector<Cell<2>>& triangles) {
    std::set<std::pair<int, int>> edges;
    for (const Cell<2>& t : triangles)
        for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
    std::multimap<int, int> next;
    for (const auto& [from, to] : edges)
        if (!edges.contains({to, from})) next.emplace(from, to);
    std::vector<std::vector<int>> outlines;
    while (!next.empty()) {
        std::vector<int>& outline = outlines.emplace_back();
        for (auto at = next.begin(); at != next.end(); at = next.find(outline.back())) {
            if (outline.empty()) outline.push_back(at->first);
            outline.push_back(at->second);
            next.erase(at);
        }
        outline.pop_back();
    }
    return outlines;
}

double lengthOf(const std::vector<int>& outline, const Points2& points) {
    double length = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        length += (points.col(outline[(i + 1) % outline.size()]) - points.col(outline[i])).norm();
    return length;
}

/// Returns a part whose triangles are in `cells`, numbers of cells with the hindmost first.
RigPart makePart(const SimplicialMesh<2>& mesh, const std::string& name, const std::vector<int>& cells) {
    RigPart part;
    part.name = name;
    for (const int c : cells) part.triangles.push_back(mesh.cells[static_cast<std::size_t>(c)]);
    auto outlines = outlinesOf(part.triangles);
    const auto longest = std::ranges::max_element(
        outlines, {}, [&](const std::vector<int>& outline) { return lengthOf(outline, mesh.points); });
    std::map<int, int> numberOf;
    const auto add = [&](int vertex) {
        if (numberOf.emplace(vertex, static_cast<int>(part.vertices.size())).second)
            part.vertices.push_back(vertex);
    };
    if (longest != outlines.end()) std::ranges::for_each(*longest, add);
    part.hull = static_cast<int>(part.vertices.size());
    for (Cell<2>& triangle : part.triangles)
        for (int& vertex : triangle) {
            add(vertex);
            vertex = numberOf.at(vertex);
        }
    return part;
}

/// Returns the cells from one to another, the hindmost first.
std::vector<int> cellsByDepth(int first, int end, const std::vector<float>& depth) {
    std::vector<int> cells(static_cast<std::size_t>(end - first));
    std::iota(cells.begin(), cells.end(), first);
    if (!depth.empty())
        std::ranges::stable_sort(cells, {}, [&](int c) { return depth[static_cast<std::size_t>(c)]; });
    return cells;
}

/// Returns parts in the order of their levels, the lowest first.
std::vector<int> orderOf(const std::vector<int>& levels) {
    std::vector<int> order(levels.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int part) { return levels[static_cast<std::size_t>(part)]; });
    return order;
}

}  // namespace

Rig makeRig(const Shape<2>& shape, const std::vector<Points2>& poses, const std::vector<float>& depth,
            const std::vector<std::vector<int>>& levels, double framesPerSecond) {
    const auto [width, height] = canvasSize(shape);
    const SimplicialMesh<2>& inTexture = restInPixels(shape);
    Rig rig{shape.picture,  inTexture.points, width, height, {}, {}, inPixels(shape, shape.rest->points), {},
            framesPerSecond};
    std::vector<MeshPart> parts = drawnRest(shape)->parts;
    if (parts.empty()) parts.push_back({"picture", 0, 0, 0, inTexture.cellCount()});
    const bool isSorted = !levels.empty() && !levels.front().empty();
    std::vector<int> order = isSorted ? orderOf(levels.front()) : std::vector<int>(parts.size());
    if (!isSorted) std::iota(order.begin(), order.end(), 0);
    std::vector<int> placeOf(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const MeshPart& part = parts[static_cast<std::size_t>(order[k])];
        placeOf[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
        rig.parts.push_back(
            makePart(inTexture, part.name, cellsByDepth(part.firstCell, part.endCell, depth)));
        if (shape.texture && !shape.texture->sheets.empty())
            rig.parts.back().blend = shape.texture->sheets[static_cast<std::size_t>(order[k])].blend;
    }
    for (std::size_t k = 0; k < poses.size(); ++k) {
        rig.poses.push_back(inPixels(shape, poses[k]));
        std::vector<int> now = isSorted ? orderOf(levels[k]) : order;
        for (int& part : now) part = placeOf[static_cast<std::size_t>(part)];
        rig.orders.push_back(std::move(now));
    }
    return rig;
}

std::vector<std::pair<int, int>> offsetsOf(const std::vector<int>& order) {
    std::vector<int> placeOf(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        placeOf[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    std::vector<std::pair<int, int>> offsets;
    for (std::size_t part = 0; part < placeOf.size(); ++part)
        if (const int by = placeOf[part] - static_cast<int>(part); by != 0)
            offsets.emplace_back(static_cast<int>(part), by);
    return offsets;
}

std::vector<std::size_t> changesOfOrder(const Rig& rig) {
    std::vector<std::size_t> changes;
    for (std::size_t k = 1; k < rig.orders.size(); ++k)
        if (rig.orders[k] != rig.orders[k - 1]) changes.push_back(k);
    return changes;
}

}  // namespace wend
