#include "core/meshing/surface.h"

#include <algorithm>
#include <queue>

#include "core/meshing/surface_edges.h"
#include "core/meshing/surface_holes.h"
#include "core/meshing/touching_bodies.h"

namespace wend {
namespace {

/// Returns "3 open edges" for "open edge|s".
std::string amount(std::size_t count, std::string what) {
    const std::size_t mark = what.find('|');
    if (mark != std::string::npos) what.erase(mark, count == 1 ? 2 : 1);
    return std::to_string(count) + " " + what;
}

std::string counted(std::size_t count, const std::string& what, const std::string& first) {
    if (count == 0) return {};
    return amount(count, what) + " (first: " + first + ")";
}

std::string pair(const std::array<int, 2>& ids) {
    return std::to_string(ids[0]) + "–" + std::to_string(ids[1]);
}

void append(std::string& list, const std::string& item) {
    if (item.empty()) return;
    if (!list.empty()) list += ", ";
    list += item;
}

/// Merges vertices at one place; returns for each old vertex its new id.
std::vector<int> mergeVertices(Surface& surface, RepairReport& report) {
    const std::vector<int> canonical = canonicalVertices(surface.points);
    std::vector<int> newId(canonical.size(), -1);
    int kept = 0;
    for (std::size_t i = 0; i < canonical.size(); ++i) {
        if (canonical[i] != static_cast<int>(i)) continue;
        surface.points.col(kept) = surface.points.col(static_cast<int>(i)).eval();
        newId[i] = kept++;
    }
    for (std::size_t i = 0; i < canonical.size(); ++i) newId[i] = newId[canonical[i]];
    report.mergedVertices = surface.vertexCount() - kept;
    surface.points.conservativeResize(Eigen::NoChange, kept);
    return newId;
}

/// Drops degenerate and duplicate triangles, and counts them.
void dropTriangles(Surface& surface, const SurfaceProblems& problems, RepairReport& report) {
    std::vector<bool> drop(surface.triangles.size(), false);
    for (int t : problems.degenerate) drop[t] = true;
    for (int t : problems.duplicate) drop[t] = true;
    report.droppedDegenerate = static_cast<int>(problems.degenerate.size());
    report.droppedDuplicate = static_cast<int>(problems.duplicate.size());
    Surface kept{surface.points, {}, {}};
    for (int t = 0; t < surface.triangleCount(); ++t) {
        if (drop[t]) continue;
        kept.triangles.push_back(surface.triangles[t]);
        if (!surface.labels.empty()) kept.labels.push_back(surface.labels[t]);
    }
    surface = std::move(kept);
}

/// Turns triangles so that neighbours over manifold edges agree, part by part, after the first triangle of
/// each part.
void orient(Surface& surface, RepairReport& report) {
    const auto edges = edgesOf(surface);
    std::vector<std::vector<int>> edgesOfTriangle(surface.triangles.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (edges[e].triangles.size() == 2)
            for (int t : edges[e].triangles) edgesOfTriangle[t].push_back(static_cast<int>(e));
    std::vector<bool> seen(surface.triangles.size(), false);
    for (int start = 0; start < surface.triangleCount(); ++start) {
        if (seen[start]) continue;
        std::queue<int> front({start});
        seen[start] = true;
        while (!front.empty()) {
            const int t = front.front();
            front.pop();
            for (int e : edgesOfTriangle[t]) {
                const auto& edge = edges[e];
                const int other = edge.triangles[edge.triangles[0] == t ? 1 : 0];
                if (seen[other]) continue;
                seen[other] = true;
                front.push(other);
                const bool mine = runsAlong(surface.triangles[t], edge.vertices[0], edge.vertices[1]);
                const bool theirs = runsAlong(surface.triangles[other], edge.vertices[0], edge.vertices[1]);
                if (mine != theirs) continue;
                std::swap(surface.triangles[other][1], surface.triangles[other][2]);
                ++report.flipped;
            }
        }
    }
}

}  // namespace

bool SurfaceProblems::boundsVolume() const {
    return notFinite.empty() && badIndex.empty() && degenerate.empty() && duplicate.empty() &&
           openEdges.empty() && intersecting.empty() && !flat;
}

/// The most pairs of bodies in a summary.
constexpr std::size_t kMostNamed = 3;

std::string SurfaceProblems::summary() const {
    std::string list;
    const auto first = [](const std::vector<int>& ids) {
        return ids.empty() ? std::string() : std::to_string(ids[0]);
    };
    const auto firstPair = [](const auto& pairs) { return pairs.empty() ? std::string() : pair(pairs[0]); };
    append(list, counted(notFinite.size(),
                         notFinite.size() == 1 ? "vertex that is not finite" : "vertices that are not finite",
                         first(notFinite)));
    append(list, counted(badIndex.size(),
                         badIndex.size() == 1 ? "triangle that names a missing vertex"
                                              : "triangles that name a missing vertex",
                         first(badIndex)));
    if (flat) append(list, "all points lie in one plane");
    append(list, counted(openEdges.size(), "open edge|s", firstPair(openEdges)));
    append(list, counted(nonManifoldEdges.size(), "edge|s of more than two triangles",
                         firstPair(nonManifoldEdges)));
    std::size_t crossing = intersecting.size();
    for (const TouchingBodies& one : touching) crossing -= static_cast<std::size_t>(one.pairs);
    append(list, counted(crossing, "pair|s of triangles that intersect", firstPair(intersecting)));
    for (std::size_t i = 0; i < std::min(touching.size(), kMostNamed); ++i) append(list, textOf(touching[i]));
    append(list, counted(degenerate.size(), "triangle|s without area", first(degenerate)));
    append(list, counted(duplicate.size(), "duplicate triangle|s", first(duplicate)));
    append(list, counted(misoriented.size(), "edge|s where the orientation changes", firstPair(misoriented)));
    return list;
}

std::string RepairReport::summary() const {
    std::string list;
    const auto add = [&](int count, const std::string& what) {
        if (count > 0) append(list, amount(count, what));
    };
    add(steps, "single step|s");
    add(mergedVertices, mergedVertices == 1 ? "coincident vertex merged" : "coincident vertices merged");
    add(droppedDegenerate, "triangle|s without area dropped");
    add(droppedDuplicate, "duplicate triangle|s dropped");
    add(flipped, "triangle|s turned over");
    add(filledHoles, "hole|s filled");
    return list;
}

Surface repairSurface(const Surface& input, int largestHole, RepairReport& report) {
    report = {};
    Surface surface = input;
    const std::vector<int> newId = mergeVertices(surface, report);
    for (auto& triangle : surface.triangles)
        for (int& id : triangle)
            if (id >= 0 && id < static_cast<int>(newId.size())) id = newId[id];
    dropTriangles(surface, checkSurface(surface, 0), report);
    orient(surface, report);
    FilledHoles filled = fillHoles(surface, largestHole);
    report.filledHoles = filled.holes;
    report.addedTriangles = filled.triangles;
    report.largerHoles = std::move(filled.larger);
    std::ranges::sort(report.largerHoles);
    return surface;
}

}  // namespace wend
