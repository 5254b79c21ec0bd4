#include "core/meshing/surface_holes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

/// A side of a hole: an edge of one triangle, run through against it.
struct Side {
    int from, to;
};

/// Returns the open sides in increasing order of their starts.
std::vector<Side> sidesOf(const Surface& surface) {
    std::vector<Side> sides;
    for (const SurfaceEdge& edge : edgesOf(surface)) {
        if (edge.triangles.size() != 1) continue;
        const auto [low, high] = edge.vertices;
        const bool along = runsAlong(surface.triangles[edge.triangles[0]], low, high);
        sides.push_back(along ? Side{high, low} : Side{low, high});
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.from < b.from; });
    return sides;
}

Vec3 areaNormal(const Surface& surface, const std::array<int, 3>& t) {
    const Vec3 a = surface.points.col(t[0]), b = surface.points.col(t[1]), c = surface.points.col(t[2]);
    return (b - a).cross(c - a) / 2;
}

bool indicesGood(const Surface& surface, const std::array<int, 3>& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](int id) { return id >= 0 && id < surface.vertexCount(); });
}

/// Returns the sums of the normals of the triangles around each vertex, weighted by area; 0 where there is
/// none.
Points3 vertexNormals(const Surface& surface) {
    Points3 normals = Points3::Zero(3, surface.vertexCount());
    for (const auto& triangle : surface.triangles) {
        if (!indicesGood(surface, triangle)) continue;
        const Vec3 normal = areaNormal(surface, triangle);
        for (const int id : triangle) normals.col(id) += normal;
    }
    return normals;
}

/// Successors of open sides. If several start at one vertex, a hole continues with the first of them
/// clockwise around the vertex normal, next to the following triangles.
class Followers {
  public:
    Followers(const Surface& surface, const std::vector<Side>& sides)
        : m_surface(surface),
          m_sides(sides),
          m_normals(vertexNormals(surface)),
          m_taken(sides.size(), false) {}

    std::vector<int> all() {
        std::vector<int> next;
        next.reserve(m_sides.size());
        for (const Side& side : m_sides) next.push_back(after(side));
        return next;
    }

  private:
    /// Returns −1 if every candidate already has a predecessor.
    int after(const Side& side) {
        const auto first = std::lower_bound(m_sides.begin(), m_sides.end(), side.to,
                                            [](const Side& s, int vertex) { return s.from < vertex; });
        int best = -1;
        double minimum = 0;
        for (auto it = first; it != m_sides.end() && it->from == side.to; ++it) {
            const int candidate = static_cast<int>(it - m_sides.begin());
            if (m_taken[candidate]) continue;
            const double turn = clockwise(side, *it);
            if (best >= 0 && turn >= minimum) continue;
            best = candidate;
            minimum = turn;
        }
        if (best >= 0) m_taken[best] = true;
        return best;
    }

    /// Returns the angle from a side's reverse to the next one, in [0, 2π).
    double clockwise(const Side& in, const Side& out) const {
        const Vec3 at = m_surface.points.col(in.to), n = m_normals.col(in.to).normalized();
        const Vec3 from = m_surface.points.col(in.from) - at, to = m_surface.points.col(out.to) - at;
        const Vec3 a = from - from.dot(n) * n, b = to - to.dot(n) * n;
        const double angle = std::atan2(b.cross(a).dot(n), a.dot(b));
        return angle < 0 ? angle + 2 * M_PI : angle;
    }

    const Surface& m_surface;
    const std::vector<Side>& m_sides;
    const Points3 m_normals;
    std::vector<bool> m_taken;
};

/// The triangles of a surface in either orientation.
class Known {
  public:
    explicit Known(const Surface& surface) : m_triangles(surface.triangles) {
        for (auto& triangle : m_triangles) std::sort(triangle.begin(), triangle.end());
        std::sort(m_triangles.begin(), m_triangles.end());
    }
    bool has(std::array<int, 3> triangle) const {
        std::sort(triangle.begin(), triangle.end());
        return std::binary_search(m_triangles.begin(), m_triangles.end(), triangle);
    }

  private:
    std::vector<std::array<int, 3>> m_triangles;
};

constexpr double kSlit = 1e-6;  // width of a slit, relative to its length

/// Returns the loop after the triangle beside one of its sides is removed: it includes the third vertex.
std::vector<int> around(const std::vector<int>& loop, const std::array<int, 3>& triangle) {
    std::vector<int> ring;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        ring.push_back(loop[k]);
        for (int i = 0; i < 3; ++i)
            if (triangle[i] == loop[(k + 1) % loop.size()] && triangle[(i + 1) % 3] == loop[k])
                ring.push_back(triangle[(i + 2) % 3]);
    }
    return ring;
}

/// Returns the vertex that the fan is made around: one of a triangle's, or a new one at the mean of the loop.
int apexOf(Surface& surface, const std::vector<int>& loop) {
    if (loop.size() == 3) return loop[0];
    Vec3 centre = Vec3::Zero();
    for (const int id : loop) centre += surface.points.col(id) / static_cast<double>(loop.size());
    const int apex = surface.vertexCount();
    surface.points.conservativeResize(Eigen::NoChange, apex + 1);
    surface.points.col(apex) = centre;
    return apex;
}

}  // namespace

/// Follows the open sides, and closes a loop whenever the path returns to a vertex that it has passed, so
/// that loops that meet at a vertex are separated. A path that ends without returning is no hole.
std::vector<std::vector<int>> holeLoops(const Surface& surface) {
    const std::vector<Side> sides = sidesOf(surface);
    const std::vector<int> next = Followers(surface, sides).all();
    std::vector<bool> used(sides.size(), false);
    std::vector<int> place(static_cast<std::size_t>(surface.vertexCount()),
                           -1);  // in the path, −1: not in it
    std::vector<std::vector<int>> loops;
    for (std::size_t start = 0; start < sides.size(); ++start) {
        std::vector<int> path;
        for (int s = static_cast<int>(start); s >= 0 && !used[s]; s = next[s]) {
            used[s] = true;
            place[sides[s].from] = static_cast<int>(path.size());
            path.push_back(sides[s].from);
            const int back = place[sides[s].to];
            if (back < 0) continue;
            // back at an earlier vertex: the part in between is a hole
            loops.emplace_back(path.begin() + back, path.end());
            for (const int id : loops.back()) place[id] = -1;
            path.resize(static_cast<std::size_t>(back));
        }
        for (const int id : path) place[id] = -1;
    }
    return loops;
}

std::vector<std::vector<int>> holesOf(const Surface& surface) {
    std::vector<std::vector<int>> loops = holeLoops(surface);
    if (loops.empty()) return loops;
    const Known known(surface);
    std::erase_if(loops, [&](const std::vector<int>& loop) {
        return loop.size() == 3 && known.has({loop[0], loop[1], loop[2]});
    });
    return loops;
}

int besideSlit(const Surface& surface, const std::vector<int>& loop) {
    std::array<int, 2> longest{};
    double length = -1;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::array<int, 2> side{loop[k], loop[(k + 1) % loop.size()]};
        const double l = (surface.points.col(side[1]) - surface.points.col(side[0])).norm();
        if (l > length) {
            length = l;
            longest = side;
        }
    }
    const Vec3 from = surface.points.col(longest[0]), to = surface.points.col(longest[1]);
    const bool onALine = std::ranges::all_of(loop, [&](int id) {
        return (surface.points.col(id) - from).cross(to - from).norm() <= kSlit * length * length;
    });
    const auto has = [&](const std::array<int, 3>& t) {
        return runsAlong(t, longest[1], longest[0]) &&
               std::ranges::count_if(t, [&](int id) { return std::ranges::count(loop, id) > 0; }) == 2;
    };
    const auto at = std::ranges::find_if(surface.triangles, has);
    return onALine && at != surface.triangles.end() ? static_cast<int>(at - surface.triangles.begin()) : -1;
}

void fillHole(Surface& surface, const std::vector<int>& loop, int label) {
    const int apex = apexOf(surface, loop);
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const int a = loop[k], b = loop[(k + 1) % loop.size()];
        if (a == apex || b == apex) continue;
        surface.triangles.push_back({apex, a, b});
        if (!surface.labels.empty()) surface.labels.push_back(label);
    }
}

FilledHoles fillHoles(Surface& surface, int largest) {
    FilledHoles filled;
    int kept = surface.triangleCount();
    for (const auto& loop : holesOf(surface)) {
        if (static_cast<int>(loop.size()) > largest) {
            filled.larger.push_back(static_cast<int>(loop.size()));
            continue;
        }
        ++filled.holes;
        const int beside = besideSlit(surface, loop);
        if (beside < 0) {
            fillHole(surface, loop);
            continue;
        }
        fillHole(surface, around(loop, surface.triangles[beside]),
                 surface.labels.empty() ? 0 : surface.labels[beside]);
        surface.triangles.erase(surface.triangles.begin() + beside);
        if (!surface.labels.empty()) surface.labels.erase(surface.labels.begin() + beside);
        if (beside < kept) --kept;
    }
    filled.triangles = surface.triangleCount() - kept;
    return filled;
}

}  // namespace wend
