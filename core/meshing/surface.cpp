#include "core/meshing/surface.h"

#include <algorithm>
#include <queue>

#include "core/meshing/surface_edges.h"
#include "core/meshing/surface_holes.h"
#include "core/meshing/touching_bodies.h"

namespace wend {
namespace {

/// The sentences about one thing and about several.
struct Plural {
    Sentence one, more;
    Sentence operator()(std::size_t count) const { return count == 1 ? one : more; }
};

/// Returns the sentence about as many things, whose second argument is the first of them; nothing about none.
Message counted(std::size_t count, const Plural& what, const std::string& first) {
    return count == 0 ? Message() : Message(what(count), count, first);
}
Message counted(int count, const Plural& what) {
    return count == 0 ? Message() : Message(what(static_cast<std::size_t>(count)), count);
}

std::string pair(const std::array<int, 2>& ids) {
    return std::to_string(ids[0]) + "–" + std::to_string(ids[1]);
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

Message SurfaceProblems::summary() const {
    const auto first = [](const std::vector<int>& ids) {
        return ids.empty() ? std::string() : std::to_string(ids[0]);
    };
    const auto firstPair = [](const auto& pairs) { return pairs.empty() ? std::string() : pair(pairs[0]); };
    std::size_t crossing = intersecting.size();
    for (const TouchingBodies& one : touching) crossing -= static_cast<std::size_t>(one.pairs);
    std::vector<Message> list{
        counted(notFinite.size(),
                {sentence("Core", "%1 vertex that is not finite (first: %2)"),
                 sentence("Core", "%1 vertices that are not finite (first: %2)")},
                first(notFinite)),
        counted(badIndex.size(),
                {sentence("Core", "%1 triangle that names a missing vertex (first: %2)"),
                 sentence("Core", "%1 triangles that name a missing vertex (first: %2)")},
                first(badIndex)),
        flat ? Message(sentence("Core", "all points lie in one plane")) : Message(),
        counted(openEdges.size(),
                {sentence("Core", "%1 open edge (first: %2)"), sentence("Core", "%1 open edges (first: %2)")},
                firstPair(openEdges)),
        counted(nonManifoldEdges.size(),
                {sentence("Core", "%1 edge of more than two triangles (first: %2)"),
                 sentence("Core", "%1 edges of more than two triangles (first: %2)")},
                firstPair(nonManifoldEdges)),
        counted(crossing,
                {sentence("Core", "%1 pair of triangles that intersect (first: %2)"),
                 sentence("Core", "%1 pairs of triangles that intersect (first: %2)")},
                firstPair(intersecting))};
    for (std::size_t i = 0; i < std::min(touching.size(), kMostNamed); ++i)
        list.push_back(textOf(touching[i]));
    list.push_back(counted(degenerate.size(),
                           {sentence("Core", "%1 triangle without area (first: %2)"),
                            sentence("Core", "%1 triangles without area (first: %2)")},
                           first(degenerate)));
    list.push_back(counted(duplicate.size(),
                           {sentence("Core", "%1 duplicate triangle (first: %2)"),
                            sentence("Core", "%1 duplicate triangles (first: %2)")},
                           first(duplicate)));
    list.push_back(counted(misoriented.size(),
                           {sentence("Core", "%1 edge where the orientation changes (first: %2)"),
                            sentence("Core", "%1 edges where the orientation changes (first: %2)")},
                           firstPair(misoriented)));
    return listed(list);
}

Message RepairReport::summary() const {
    return listed({
        counted(steps, {sentence("Core", "%1 single step"), sentence("Core", "%1 single steps")}),
        counted(mergedVertices, {sentence("Core", "%1 coincident vertex merged"),
                                 sentence("Core", "%1 coincident vertices merged")}),
        counted(droppedDegenerate, {sentence("Core", "%1 triangle without area dropped"),
                                    sentence("Core", "%1 triangles without area dropped")}),
        counted(droppedDuplicate, {sentence("Core", "%1 duplicate triangle dropped"),
                                   sentence("Core", "%1 duplicate triangles dropped")}),
        counted(flipped,
                {sentence("Core", "%1 triangle turned over"), sentence("Core", "%1 triangles turned over")}),
        counted(filledHoles, {sentence("Core", "%1 hole filled"), sentence("Core", "%1 holes filled")}),
    });
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
