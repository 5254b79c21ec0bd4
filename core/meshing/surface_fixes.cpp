#include "core/meshing/surface_fixes.h"

#include <algorithm>
#include <map>
#include <span>

#include "core/mesh/disjoint_sets.h"
#include "core/mesh/error.h"
#include "core/meshing/fix_all.h"
#include "core/meshing/surface_edges.h"
#include "core/meshing/surface_faults.h"
#include "core/meshing/surface_holes.h"

namespace wend {
namespace {

using Edge = std::array<int, 2>;
constexpr int kMostRings = 2;                     // around triangles that cross
constexpr int kMostRounds = 50, kMostTries = 20;  // in each, for all faults of a kind
constexpr int kLeastThatStays = 4;                // times what goes away with them

Edge sorted(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> sidesOf(const std::vector<int>& loop) {
    std::vector<Edge> sides;
    for (std::size_t k = 0; k < loop.size(); ++k)
        sides.push_back(sorted(loop[k], loop[(k + 1) % loop.size()]));
    return sides;
}

/// What counts of a surface: without triangles that are degenerate, double or of missing vertices, and with
/// one vertex at every place.
struct SoundPart {
    Surface surface;
    std::vector<int> triangles;  // whose they are in the whole surface

    explicit SoundPart(const Surface& whole) : surface{whole.points, {}, {}} {
        const SurfaceProblems problems = checkSurface(whole, 0);
        std::vector<bool> left(whole.triangles.size(), false);
        for (const auto* list : {&problems.badIndex, &problems.degenerate, &problems.duplicate})
            for (const int t : *list) left[t] = true;
        const std::vector<int> first = canonicalVertices(whole.points);
        for (int t = 0; t < whole.triangleCount(); ++t) {
            if (left[t]) continue;
            auto ids = whole.triangles[t];
            for (int& id : ids) id = first[id];
            surface.triangles.push_back(ids);
            triangles.push_back(t);
        }
    }

    /// The triangles that are connected with one through edges and agree with it, in the whole surface's
    /// numbers.
    std::vector<int> patchOf(int triangle) const {
        const auto at = std::ranges::lower_bound(triangles, triangle);
        if (at == triangles.end() || *at != triangle) return {};
        std::vector<std::vector<int>> beside(triangles.size());
        for (const SurfaceEdge& edge : edgesOf(surface)) {
            if (edge.triangles.size() != 2) continue;
            const int a = edge.triangles[0], b = edge.triangles[1];
            const auto [from, to] = edge.vertices;
            if (runsAlong(surface.triangles[a], from, to) == runsAlong(surface.triangles[b], from, to))
                continue;
            beside[a].push_back(b);
            beside[b].push_back(a);
        }
        std::vector<bool> seen(triangles.size(), false);
        std::vector<int> patch{static_cast<int>(at - triangles.begin())};
        seen[patch[0]] = true;
        for (std::size_t i = 0; i < patch.size(); ++i)
            for (const int next : beside[patch[i]])
                if (!seen[next]) {
                    seen[next] = true;
                    patch.push_back(next);
                }
        for (int& t : patch) t = triangles[t];
        return patch;
    }
};

class Fixer {
  public:
    explicit Fixer(const Surface& surface) : m_all(surface), m_gone(surface.triangles.size(), false) {}

    void apply(const SurfaceFix& fix) {
        if (fix.kind == SurfaceFix::Kind::Fill) return fill(fix.ids);
        m_holes.clear();
        for (const int triangle : fix.ids) {
            if (triangle < 0 || triangle >= m_all.triangleCount() || m_gone[triangle])
                throw InputError("there is no triangle " + std::to_string(triangle));
            if (fix.kind == SurfaceFix::Kind::Drop)
                m_gone[triangle] = true;
            else
                turn(triangle);
        }
    }

    FixedSurface result() const {
        FixedSurface fixed{{m_all.points, {}, {}}, {}};
        for (int t = 0; t < m_all.triangleCount(); ++t) {
            if (m_gone[t]) continue;
            fixed.surface.triangles.push_back(m_all.triangles[t]);
            if (!m_all.labels.empty()) fixed.surface.labels.push_back(m_all.labels[t]);
            fixed.numbers.push_back(t);
        }
        return fixed;
    }

  private:
    void turn(int triangle) {
        const FixedSurface now = result();
        const auto place = std::ranges::lower_bound(now.numbers, triangle) - now.numbers.begin();
        for (const int t : SoundPart(now.surface).patchOf(static_cast<int>(place))) {
            auto& ids = m_all.triangles[now.numbers[t]];
            std::swap(ids[1], ids[2]);
        }
    }

    void fill(const std::vector<int>& edge) {
        if (fillKnown(edge)) return;
        m_holes = holesOf(SoundPart(result().surface).surface);
        if (!fillKnown(edge))
            throw InputError("no hole has the edge " + std::to_string(edge[0]) + "–" +
                             std::to_string(edge[1]));
    }

    bool fillKnown(const std::vector<int>& edge) {
        const auto hole = std::ranges::find_if(m_holes, [&](const std::vector<int>& loop) {
            return std::ranges::count(sidesOf(loop), sorted(edge.at(0), edge.at(1))) > 0;
        });
        if (hole == m_holes.end()) return false;
        fillHole(m_all, *hole);
        m_gone.resize(m_all.triangles.size(), false);
        m_holes.erase(hole);
        return true;
    }

    Surface m_all;                          // with what went away
    std::vector<bool> m_gone;               // triangles
    std::vector<std::vector<int>> m_holes;  // as far as they are known
};

SurfaceFix fillAlong(const std::vector<int>& loop) {
    const Edge edge = sorted(loop[0], loop[1]);
    return {SurfaceFix::Kind::Fill, {edge[0], edge[1]}};
}

int countOf(const Surface& surface, const SurfaceProblems& problems) {
    int count = 0;
    for (const FaultKind& kind : faultsOf(surface, problems)) count += static_cast<int>(kind.cases.size());
    return count;
}

/// Proposes steps for one fault, and says what they would do.
class FaultFixer {
  public:
    FaultFixer(const Surface& source, const std::vector<SurfaceFix>& done)
        : m_source(source),
          m_done(done),
          m_now(fixSurface(source, done)),
          m_problems(checkSurface(m_now.surface)) {}

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

    /// What steps that are known would do.
    FaultFix withEffect(std::vector<SurfaceFix> steps) const {
        FaultFix fix;
        fix.after = after(steps);
        fix.steps = std::move(steps);
        const Surface &before = m_now.surface, &then = fix.after.surface;
        std::size_t k = 0;  // in what is left
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

    /// For all cases of a kind together, or where that does not help for as many of them as it does.
    FaultFix fixForMost(const std::string& kind, int largestHole) {
        std::vector<std::vector<int>> cases;
        for (FaultKind& found : faultsOf(m_now.surface, m_problems))
            if (found.name == kind) cases = std::move(found.cases);
        if (kind == "hole")
            std::erase_if(cases, [&](const auto& hole) { return std::ssize(hole) > largestHole; });
        if (kind == "turned_edge" && cases.size() > 1) cases.resize(1);  // the others may be turned with it
        int tries = kMostTries;
        return fixForMost(kind, cases, tries);
    }

  private:
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

    /// Every hole that lies along nothing but these; what hangs there alone goes away.
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

    /// A slit with the triangle beside it, which the loop then goes around.
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

    /// The smaller of the parts that disagree; a Möbius band has one only.
    std::vector<SurfaceFix> turned(const std::vector<int>& triangles) const {
        if (triangles.size() != 2) return {};
        const SoundPart sound(m_now.surface);
        const auto one = sound.patchOf(triangles[0]), other = sound.patchOf(triangles[1]);
        if (std::ranges::count(one, triangles[1]) > 0) return {};
        const int triangle = one.size() <= other.size() ? triangles[0] : triangles[1];
        return {{SurfaceFix::Kind::Turn, {m_now.numbers[triangle]}}};
    }

    FaultFix uncrossed(const std::vector<int>& triangles) {
        const SurfaceProblems& before = m_problems;
        std::vector<int> going = triangles;
        for (int ring = 0; ring <= kMostRings; ++ring) {
            if (ring > 0) going = withIslands(withNeighbours(going));
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

    /// With what they hold to the rest, where that is less than half of them.
    std::vector<int> withIslands(std::vector<int> going) const {
        const FixedSurface left = after({drop(going)});
        const SoundPart sound(left.surface);
        const int count = sound.surface.triangleCount();
        DisjointSets parts(count);
        for (const SurfaceEdge& edge : edgesOf(sound.surface))
            for (const int t : edge.triangles) parts.join(t, edge.triangles[0]);
        std::map<int, std::vector<int>> islands;
        for (int t = 0; t < count; ++t) islands[parts.root(t)].push_back(left.numbers[sound.triangles[t]]);
        const std::vector<int> around = withNeighbours(going);
        const std::size_t most = going.size() / 2;
        for (auto& [root, triangles] : islands) {
            if (triangles.size() > most) continue;
            for (int& t : triangles)
                t = static_cast<int>(std::ranges::lower_bound(m_now.numbers, t) - m_now.numbers.begin());
            if (std::ranges::find_first_of(triangles, around) != triangles.end())
                going.insert(going.end(), triangles.begin(), triangles.end());
        }
        std::ranges::sort(going);
        return going;
    }

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

    /// Those that the steps open, none of which touches an edge that was open.
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

FixedSurface fixSurface(const Surface& surface, const std::vector<SurfaceFix>& fixes) {
    Fixer fixer(surface);
    for (std::size_t i = 0; i < fixes.size(); ++i) try {
            fixer.apply(fixes[i]);
        } catch (const InputError& error) {
            throw InputError("fixes[" + std::to_string(i) + "]: " + error.reason());
        }
    return fixer.result();
}

FaultFix fixFor(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                const std::vector<int>& triangles) {
    return FaultFixer(surface, done).fixFor(kind, triangles);
}

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
