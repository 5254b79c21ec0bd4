#include "core/meshing/closed_gaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <queue>
#include <unordered_map>
#include <unordered_set>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/mesh/triangle_tree.h"
#include "core/meshing/cube_grid.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

constexpr double kAround = 5;       // times the gap or the cube: as far it is along the surface at least
constexpr double kOpposite = -0.5;  // the product of normals that face each other is less
constexpr double kTouching = 1e-3;  // fraction of a cube: closer points touch or cross
constexpr double kOff = 1e-7;       // of the diagonal: rays begin as far above their triangle

/// The surface with merged vertices and edges no longer than `longest`, for paths along it.
class FineSurface {
  public:
    FineSurface(const Surface& surface, double longest) : m_longest(longest) {
        const std::vector<int> first = canonicalVertices(surface.points);
        for (int v = 0; v < surface.vertexCount(); ++v) m_points.push_back(surface.points.col(v));
        for (const auto& t : surface.triangles) split({first[t[0]], first[t[1]], first[t[2]]});
    }

    Surface surface() && {
        Surface fine{Points3(3, static_cast<Eigen::Index>(m_points.size())), std::move(m_triangles), {}};
        for (std::size_t i = 0; i < m_points.size(); ++i)
            fine.points.col(static_cast<Eigen::Index>(i)) = m_points[i];
        return fine;
    }

  private:
    /// Splits the triangle at its longest edge. Its neighbour splits that edge at the same vertex.
    void split(const std::array<int, 3>& t) {
        std::array<double, 3> lengths{};
        for (int k = 0; k < 3; ++k) lengths[k] = (m_points[t[k]] - m_points[t[(k + 1) % 3]]).norm();
        const auto k = std::ranges::max_element(lengths) - lengths.begin();
        if (lengths[k] <= m_longest) {
            m_triangles.push_back(t);
            return;
        }
        const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], middle = middleOf(a, b);
        split({a, middle, c});
        split({middle, b, c});
    }

    int middleOf(int a, int b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [entry, isNew] = m_middles.try_emplace({low, high}, static_cast<int>(m_points.size()));
        if (isNew) m_points.push_back((m_points[low] + m_points[high]) / 2);
        return entry->second;
    }

    double m_longest;
    std::vector<Vec3> m_points;
    std::vector<std::array<int, 3>> m_triangles;
    std::map<std::array<int, 2>, int> m_middles;
};

class GapFinder {
  public:
    GapFinder(Surface fine, const CubeGrid& grid, const std::vector<std::int64_t>& full, double widest)
        : m_surface(std::move(fine)),
          m_grid(grid),
          m_full(full),
          m_widest(widest),
          m_tree(m_surface.points, m_surface.triangles),
          m_parts(m_surface.vertexCount()) {
        for (const auto& t : m_surface.triangles)
            for (int k = 0; k < 3; ++k) m_parts.join(t[0], t[k]);
        m_off = kOff * (m_surface.points.rowwise().maxCoeff() - m_surface.points.rowwise().minCoeff()).norm();
        findNormals();
        findNeighbours();
    }

    std::vector<ClosedGap> gaps(const std::stop_token& stop) {
        std::unordered_set<std::int64_t> seen;  // one of each cube and direction will do
        for (int t = 0; t < m_surface.triangleCount(); ++t) {
            if (stop.stop_requested()) throw Cancelled();
            const std::int64_t cube = m_grid.numberAt(middleOf(t));
            if (m_normals.col(t).isZero() || !seen.insert(6 * cube + directionOf(t)).second) continue;
            lookFrom(t);
        }
        return together();
    }

  private:
    struct Seen {
        ClosedGap gap;
        std::vector<std::int64_t> cubes;
    };

    Vec3 corner(int triangle, int k) const { return m_surface.points.col(m_surface.triangles[triangle][k]); }
    Vec3 middleOf(int t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }

    /// Returns the axis that a normal is nearest to, in either direction: 0 … 5.
    int directionOf(int t) const {
        Eigen::Index axis = 0;
        m_normals.col(t).cwiseAbs().maxCoeff(&axis);
        return static_cast<int>(2 * axis) + (m_normals(axis, t) < 0 ? 1 : 0);
    }

    /// Makes normals point outwards: those of a part with negative volume are flipped. The signed volume is
    /// taken relative to the middle of the part's box, so that a part that is open or far away has a useful
    /// sign as well.
    void findNormals() {
        m_normals.resize(3, m_surface.triangleCount());
        std::map<int, Eigen::AlignedBox3d> boxes;
        for (int t = 0; t < m_surface.triangleCount(); ++t)
            for (int k = 0; k < 3; ++k) boxes[partOf(t)].extend(corner(t, k));
        std::map<int, double> volumes;
        for (int t = 0; t < m_surface.triangleCount(); ++t) {
            const Vec3 centre = boxes[partOf(t)].center(), a = corner(t, 0) - centre;
            const Vec3 normal = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
            volumes[partOf(t)] += a.dot(normal);
            m_normals.col(t) = normal.stableNormalized();
        }
        for (int t = 0; t < m_surface.triangleCount(); ++t)
            if (volumes[partOf(t)] < 0) m_normals.col(t) *= -1;
    }
    int partOf(int t) { return m_parts.root(m_surface.triangles[t][0]); }

    void findNeighbours() {
        m_neighbours.resize(static_cast<std::size_t>(m_surface.vertexCount()));
        for (const SurfaceEdge& edge : edgesOf(m_surface)) {
            const auto [a, b] = edge.vertices;
            m_neighbours[a].push_back(b);
            m_neighbours[b].push_back(a);
        }
    }

    /// Looks along the normal of a triangle, outside of the surface, for a side that faces it. The ray begins
    /// a little above the triangle, so that it does not meet the triangle itself or its neighbours. A finding
    /// counts if both sides belong to one part, face each other, have only full cubes between them, and are
    /// far apart along the surface; else they are a fold or a thin edge.
    void lookFrom(int t) {
        const Vec3 from = middleOf(t), normal = m_normals.col(t);
        const TriangleTree::Hit hit = m_tree.firstHit(from + m_off * normal, normal);
        if (hit.triangle < 0 || hit.distance > m_widest || hit.distance < kTouching * m_grid.edge() ||
            partOf(hit.triangle) != partOf(t))
            return;
        if (m_normals.col(hit.triangle).dot(normal) > kOpposite) return;
        const Vec3 to = from + (m_off + hit.distance) * normal;
        std::vector<std::int64_t> cubes = cubesBetween(from, to);
        const double width = (to - from).norm();
        if (cubes.empty() || areNearAlong(t, hit.triangle, to, kAround * std::max(width, m_grid.edge())))
            return;
        m_seen.push_back({{width, (from + to) / 2, normal.lpNorm<1>()}, std::move(cubes)});
    }

    /// Returns the cubes between two points; none if one of them is not full.
    std::vector<std::int64_t> cubesBetween(const Vec3& from, const Vec3& to) const {
        const int steps = 1 + static_cast<int>(4 * (to - from).norm() / m_grid.edge());
        std::vector<std::int64_t> cubes;
        for (int i = 0; i <= steps; ++i) {
            const std::int64_t cube = m_grid.numberAt(from + (to - from) * (static_cast<double>(i) / steps));
            if (!std::ranges::binary_search(m_full, cube)) return {};
            cubes.push_back(cube);
        }
        return cubes;
    }

    /// Returns whether a path along edges of at most `limit` connects the centre of a triangle with a point
    /// of another. It is Dijkstra's search, which ends at the limit: only the neighbourhood of the triangle
    /// is visited.
    bool areNearAlong(int one, int other, const Vec3& to, double limit) const {
        using Entry = std::pair<double, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
        std::unordered_map<int, double> best;
        const auto reach = [&](int v, double distance) {
            const auto [entry, isNew] = best.try_emplace(v, distance);
            if (distance > limit || (!isNew && entry->second <= distance)) return;
            entry->second = distance;
            front.emplace(distance, v);
        };
        for (const int v : m_surface.triangles[one])
            reach(v, (m_surface.points.col(v) - middleOf(one)).norm());
        while (!front.empty()) {
            const auto [distance, v] = front.top();
            front.pop();
            if (distance > best[v]) continue;
            if (std::ranges::count(m_surface.triangles[other], v) > 0 &&
                distance + (m_surface.points.col(v) - to).norm() <= limit)
                return true;
            for (const int next : m_neighbours[v])
                reach(next, distance + (m_surface.points.col(next) - m_surface.points.col(v)).norm());
        }
        return false;
    }

    /// Merges findings in adjacent cubes to one gap.
    std::vector<ClosedGap> together() const {
        std::map<std::int64_t, int> number;
        for (const Seen& seen : m_seen)
            for (const std::int64_t cube : seen.cubes)
                number.try_emplace(cube, static_cast<int>(number.size()));
        DisjointSets sets(static_cast<int>(number.size()));
        for (const auto& [cube, i] : number)
            for (int c = 0; c < 27; ++c) {
                const std::int64_t beside =
                    cube + (c % 3 - 1) + (c / 3 % 3 - 1) * m_grid.stride(1) + (c / 9 - 1) * m_grid.stride(2);
                if (const auto at = number.find(beside); at != number.end()) sets.join(i, at->second);
            }
        std::map<int, ClosedGap> bySet;
        for (const Seen& seen : m_seen) {
            const auto [entry, isNew] = bySet.try_emplace(sets.root(number.at(seen.cubes.front())), seen.gap);
            if (!isNew && seen.gap.width < entry->second.width) entry->second = seen.gap;
        }
        std::vector<ClosedGap> gaps;
        for (const auto& [set, gap] : bySet) gaps.push_back(gap);
        std::ranges::stable_sort(gaps, {}, &ClosedGap::width);
        return gaps;
    }

    const Surface m_surface;
    const CubeGrid& m_grid;
    const std::vector<std::int64_t>& m_full;
    double m_widest, m_off = 0;
    const TriangleTree m_tree;
    DisjointSets m_parts;
    Points3 m_normals;
    std::vector<std::vector<int>> m_neighbours;
    std::vector<Seen> m_seen;
};

}  // namespace

std::vector<ClosedGap> closedGaps(const Surface& surface, const CubeGrid& grid,
                                  const std::vector<std::int64_t>& full, double widest,
                                  const std::stop_token& stop) {
    return GapFinder(FineSurface(surface, grid.edge()).surface(), grid, full, widest).gaps(stop);
}

}  // namespace wend
