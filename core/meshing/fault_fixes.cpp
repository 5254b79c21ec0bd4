#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/meshing/fix_all.h"
#include "core/meshing/sound_part.h"
#include "core/meshing/surface_edges.h"
#include "core/meshing/surface_faults.h"
#include "core/meshing/surface_fixes.h"
#include "core/meshing/surface_holes.h"

namespace wend {
namespace {

using Edge = std::array<int, 2>;
constexpr int kMostRings = 2;                     // around triangles that cross
constexpr int kMostRounds = 50, kMostTries = 20;  // in each, for all faults of a kind
constexpr int kLeastThatStays = 4;                // ratio of what stays to what is removed

SurfaceFix fillAlong(const std::vector<int>& loop) {
    const Edge edge = sorted(loop[0], loop[1]);
    return {SurfaceFix::Kind::Fill, {edge[0], edge[1]}};
}

int countOf(const Surface& surface, const SurfaceProblems& problems) {
    int count = 0;
    for (const FaultKind& kind : faultsOf(surface, problems)) count += static_cast<int>(kind.cases.size());
    return count;
}

/// Proposes steps for one fault, and predicts their effect.
class FaultFixer {
  public:
    FaultFixer(const Surface& source, const std::vector<SurfaceFix>& done)
        : m_source(source),
          m_done(done),
          m_now(fixSurface(source, done)),
          m_problems(checkSurface(m_now.surface)) {}

    /// Proposes a fix by the kind of fault: triangles are dropped, turned, or added.
    FaultFix fixFor(const std::string& kind, const std::vector<int>& triangles) {
        if (kind == "crossing") return uncrossed(triangles);
        std::vector<SurfaceFix> steps;
        if (kind == "missing_vertex" || kind == "flat" || kind == "duplicate") steps = {drop(triangles)};
        if (kind == "hole") steps = filled(triangles);
        if (kind == "turned_edge") steps = turned(triangles);
        if (steps.empty()) return {};
        FaultFix fix = withEffect(std::move(steps));
        const bool helps = kind == "hole"
                               ? fix.left.openEdges.size() < m_problems.openEdges.size() && !m_problems.flat
                               : fix.faults < countOf(m_now.surface, m_problems);
        return helps ? fix : FaultFix{};
    }

    /// Returns given steps with their effect.
    FaultFix withEffect(std::vector<SurfaceFix> steps) const {
        FaultFix fix;
        fix.after = after(steps);
        fix.steps = std::move(steps);
        const Surface &before = m_now.surface, &then = fix.after.surface;
        std::size_t k = 0;  // in the remaining surface
        for (int t = 0; t < before.triangleCount(); ++t) {
            const bool stays = k < fix.after.numbers.size() && fix.after.numbers[k] == m_now.numbers[t];
            const bool turned = stays && then.triangles[k] != before.triangles[t];
            fix.dropped += !stays;
            fix.turned += turned;
            if (!stays || turned) fix.changed.push_back(t);
            k += stays;
        }
        fix.added = then.triangleCount() - static_cast<int>(k);
        fix.left = checkSurface(then);
        fix.faults = countOf(then, fix.left);
        return fix;
    }

    /// Fixes all cases of a kind together or, if that fails, as many of them as possible.
    FaultFix fixForMost(const std::string& kind, int largestHole) {
        std::vector<std::vector<int>> cases;
        for (FaultKind& found : faultsOf(m_now.surface, m_problems))
            if (found.name == kind) cases = std::move(found.cases);
        if (kind == "hole")
            std::erase_if(cases, [&](const auto& hole) { return std::ssize(hole) > largestHole; });
        if (kind == "turned_edge" && cases.size() > 1) cases.resize(1);  // one step may turn the others, too
        int tries = kMostTries;
        return fixForMost(kind, cases, tries);
    }

  private:
    /// Tries all cases at once, and then their halves, the first one that helps: one case that cannot be
    /// fixed does not keep the others from it. `tries` bounds the work, since every attempt checks the whole
    /// surface.
    FaultFix fixForMost(const std::string& kind, std::span<const std::vector<int>> cases, int& tries) {
        if (cases.empty() || tries-- <= 0) return {};
        std::vector<int> triangles;
        for (const auto& one : cases) triangles.insert(triangles.end(), one.begin(), one.end());
        if (kind == "crossing") {  // others have a triangle for each edge
            std::ranges::sort(triangles);
            const auto rest = std::ranges::unique(triangles);
            triangles.erase(rest.begin(), rest.end());
        }
        FaultFix fix = fixFor(kind, triangles);
        if (!fix.steps.empty() || cases.size() == 1) return fix;
        fix = fixForMost(kind, cases.first(cases.size() / 2), tries);
        return fix.steps.empty() ? fixForMost(kind, cases.subspan(cases.size() / 2), tries) : fix;
    }

    SurfaceFix drop(const std::vector<int>& triangles) const {
        SurfaceFix fix;
        for (const int t : triangles) fix.ids.push_back(m_now.numbers[t]);
        std::ranges::sort(fix.ids);
        return fix;
    }

    /// Fills every hole bounded by these triangles only; what is connected by a vertex there is removed.
    std::vector<SurfaceFix> filled(const std::vector<int>& triangles) {
        const SoundPart sound(m_now.surface);
        std::vector<Edge> sides;
        for (const int t : triangles) {
            const auto at = std::ranges::lower_bound(sound.triangles, t);
            if (at == sound.triangles.end() || *at != t) continue;
            const auto& ids = sound.surface.triangles[at - sound.triangles.begin()];
            for (int k = 0; k < 3; ++k) sides.push_back(sorted(ids[k], ids[(k + 1) % 3]));
        }
        std::ranges::sort(sides);
        std::vector<SurfaceFix> steps;
        for (const auto& loop : holesOf(sound.surface))
            if (std::ranges::all_of(
                    sidesOf(loop), [&](const Edge& side) { return std::ranges::binary_search(sides, side); }))
                fillOne(sound, loop, steps);
        const bool alone = std::ranges::all_of(triangles, [&](int t) { return t == triangles[0]; });
        if (steps.empty() && alone) steps = {drop({triangles[0]})};
        return steps;
    }

    /// Fills a hole; a slit together with the triangle beside it, which the loop then includes.
    void fillOne(const SoundPart& sound, const std::vector<int>& loop, std::vector<SurfaceFix>& steps) const {
        const int beside = besideSlit(sound.surface, loop);
        if (beside < 0) return steps.push_back(fillAlong(loop));
        steps.push_back(drop({sound.triangles[beside]}));
        const auto& taken = sound.surface.triangles[beside];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const int a = loop[k], b = loop[(k + 1) % loop.size()];
            if (!runsAlong(taken, b, a)) return steps.push_back(fillAlong({a, b}));
        }
    }

    /// Returns a step that turns the smaller of the parts that disagree; a Möbius band has one only.
    std::vector<SurfaceFix> turned(const std::vector<int>& triangles) const {
        if (triangles.size() != 2) return {};
        const SoundPart sound(m_now.surface);
        const auto one = sound.patchOf(triangles[0]), other = sound.patchOf(triangles[1]);
        if (std::ranges::count(one, triangles[1]) > 0) return {};
        const int triangle = one.size() <= other.size() ? triangles[0] : triangles[1];
        return {{SurfaceFix::Kind::Turn, {m_now.numbers[triangle]}}};
    }

    /// Removes crossing triangles with as few neighbours as possible, and fills the resulting holes. Larger
    /// surroundings are tried only if smaller ones do not help.
    FaultFix uncrossed(const std::vector<int>& triangles) {
        const SurfaceProblems& before = m_problems;
        for (const std::vector<int>& going : aroundCrossing(triangles)) {
            if (static_cast<int>(going.size()) * kLeastThatStays > m_now.surface.triangleCount()) break;
            std::vector<SurfaceFix> steps{drop(going)};
            for (const auto& loop : newHoles(steps, before.openEdges)) steps.push_back(fillAlong(loop));
            FaultFix fix = withEffect(std::move(steps));
            const SurfaceProblems& left = fix.left;
            if (left.intersecting.size() < before.intersecting.size() &&
                left.openEdges.size() <= before.openEdges.size() &&
                left.nonManifoldEdges.size() <= before.nonManifoldEdges.size())
                return fix;
        }
        return {};
    }

    /// Returns removable triangles where these cross, smallest set first: themselves, with everything that
    /// crosses them transitively, unless that separates the surface, and with rings of their neighbours.
    std::vector<std::vector<int>> aroundCrossing(const std::vector<int>& triangles) const {
        std::vector<std::vector<int>> choices;
        const auto choose = [&](std::vector<int> going) {
            if (std::ranges::find(choices, going) == choices.end()) choices.push_back(std::move(going));
        };
        const auto chooseWhole = [&](const std::vector<int>& some) {
            if (partsWithout(some).size() <= partsWithout({}).size()) choose(some);
        };
        choose(triangles);
        std::vector<int> going = withCrossing(triangles);
        chooseWhole(withIslands(going));
        for (std::size_t before = 0; std::exchange(before, going.size()) != going.size();)
            going = withCrossing(going);
        chooseWhole(withIslands(going));
        going = triangles;
        for (int ring = 0; ring < kMostRings; ++ring) choose(going = withIslands(withNeighbours(going)));
        std::ranges::stable_sort(choices, {}, &std::vector<int>::size);
        return choices;
    }

    /// Returns the triangles, which must ascend, with all that cross one of them, ascending.
    std::vector<int> withCrossing(const std::vector<int>& triangles) const {
        std::vector<int> all = triangles;
        for (const auto& [a, b] : m_problems.intersecting) {
            if (std::ranges::binary_search(triangles, a)) all.push_back(b);
            if (std::ranges::binary_search(triangles, b)) all.push_back(a);
        }
        std::ranges::sort(all);
        const auto rest = std::ranges::unique(all);
        all.erase(rest.begin(), rest.end());
        return all;
    }

    /// Returns the components connected by edges after some triangles were removed.
    std::map<int, std::vector<int>> partsWithout(const std::vector<int>& going) const {
        const FixedSurface left = going.empty() ? m_now : after({drop(going)});
        const SoundPart sound(left.surface);
        const int count = sound.surface.triangleCount();
        DisjointSets sets(count);
        for (const SurfaceEdge& edge : edgesOf(sound.surface))
            for (const int t : edge.triangles) sets.join(t, edge.triangles[0]);
        std::map<int, std::vector<int>> parts;
        for (int t = 0; t < count; ++t) {
            const int number = left.numbers[sound.triangles[t]];
            const auto at = std::ranges::lower_bound(m_now.numbers, number);
            parts[sets.root(t)].push_back(static_cast<int>(at - m_now.numbers.begin()));
        }
        return parts;
    }

    /// Adds the parts that only they connect to the rest, unless a part has more than half as many triangles
    /// as these.
    std::vector<int> withIslands(std::vector<int> going) const {
        const std::vector<int> around = withNeighbours(going);
        const std::size_t most = going.size() / 2;
        for (const auto& [root, triangles] : partsWithout(going)) {
            if (triangles.size() > most) continue;
            if (std::ranges::find_first_of(triangles, around) != triangles.end())
                going.insert(going.end(), triangles.begin(), triangles.end());
        }
        std::ranges::sort(going);
        return going;
    }

    /// Returns the triangles together with all others that share a vertex with them.
    std::vector<int> withNeighbours(const std::vector<int>& triangles) const {
        const Surface& surface = m_now.surface;
        const std::vector<int> first = canonicalVertices(surface.points);
        std::vector<bool> taken(surface.points.cols(), false);
        const auto at = [&](int id) { return id >= 0 && id < surface.vertexCount() ? first[id] : -1; };
        for (const int t : triangles)
            for (const int id : surface.triangles[t])
                if (at(id) >= 0) taken[at(id)] = true;
        std::vector<int> all;
        for (int t = 0; t < surface.triangleCount(); ++t)
            if (std::ranges::any_of(surface.triangles[t],
                                    [&](int id) { return at(id) >= 0 && taken[at(id)]; }))
                all.push_back(t);
        return all;
    }

    /// Returns the holes that the steps create, none of which touches an edge that was open.
    std::vector<std::vector<int>> newHoles(const std::vector<SurfaceFix>& steps,
                                           const std::vector<Edge>& open) const {
        auto holes = holesOf(SoundPart(after(steps).surface).surface);
        std::erase_if(holes, [&](const std::vector<int>& loop) {
            return std::ranges::any_of(
                sidesOf(loop), [&](const Edge& side) { return std::ranges::binary_search(open, side); });
        });
        return holes;
    }

    FixedSurface after(const std::vector<SurfaceFix>& steps) const {
        std::vector<SurfaceFix> all = m_done;
        all.insert(all.end(), steps.begin(), steps.end());
        return fixSurface(m_source, all);
    }

    const Surface& m_source;
    const std::vector<SurfaceFix>& m_done;
    const FixedSurface m_now;
    const SurfaceProblems m_problems;
};

}  // namespace

FaultFix fixFor(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                const std::vector<int>& triangles) {
    return FaultFixer(surface, done).fixFor(kind, triangles);
}

/// Repeats until nothing helps, because a fix may make others possible; the effect of all steps is measured
/// once, against the surface before them.
FaultFix fixForAll(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                   int largestHole) {
    std::vector<SurfaceFix> all = done, steps;
    for (int round = 0; round < kMostRounds; ++round) {
        const FaultFix fix = FaultFixer(surface, all).fixForMost(kind, largestHole);
        if (fix.steps.empty()) break;
        for (auto* list : {&all, &steps}) list->insert(list->end(), fix.steps.begin(), fix.steps.end());
    }
    return steps.empty() ? FaultFix{} : FaultFixer(surface, done).withEffect(std::move(steps));
}

}  // namespace wend
