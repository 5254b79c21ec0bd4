#include "core/meshing/cube_grid.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace wend {
namespace {

constexpr int kLookEvery = 1024;  // triangles between two looks at the stop

enum State : std::uint8_t { Free, NearSurface, Air };

/// The enclosed part of a grid.
class Enclosure {
  public:
    Enclosure(const CubeGrid& grid, const Surface& surface, const std::stop_token& stop)
        : m_grid(grid), m_surface(surface), m_stop(stop), m_state(static_cast<std::size_t>(grid.size())) {}

    std::vector<std::int64_t> full(double distance, double gap) {
        for (int t = 0; t < m_surface.triangleCount(); ++t) {
            lookAtStop(t);
            m_grid.forEachNear(cornersOf(m_surface, t), distance,
                               [&](std::int64_t cube) { m_state[cube] = NearSurface; });
        }
        letAirIn(static_cast<int>(gap / (2 * m_grid.edge())));
        if (gap <= 0) fillWhatIsFaced();
        std::vector<std::int64_t> list;
        for (std::int64_t cube = 0; cube < m_grid.size(); ++cube)
            if (m_state[cube] != Air) list.push_back(cube);
        return list;
    }

  private:
    void lookAtStop(int triangle) const {
        if (triangle % kLookEvery == 0 && m_stop.stop_requested()) throw Cancelled();
    }

    /// Calls with the number of the first cube of every row along an axis.
    template <class Take>
    void forEachRow(int axis, const Take& take) const {
        const auto& counts = m_grid.counts();
        for (int v = 0; v < counts[(axis + 2) % 3]; ++v)
            for (int u = 0; u < counts[(axis + 1) % 3]; ++u) {
                CubeGrid::Place place{};
                place[(axis + 1) % 3] = u;
                place[(axis + 2) % 3] = v;
                take(m_grid.number(place));
            }
    }

    /// Dilates the set by `radius` cubes along each axis.
    std::vector<bool> grown(std::vector<bool> set, int radius) const {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<bool> next = set;
            const std::int64_t stride = m_grid.stride(axis);
            const int count = m_grid.counts()[axis];
            forEachRow(axis, [&](std::int64_t row) {
                for (int i = 0; i < count; ++i) {
                    if (!set[row + i * stride]) continue;
                    for (int j = std::max(0, i - radius); j <= std::min(count - 1, i + radius); ++j)
                        next[row + j * stride] = true;
                }
            });
            set = std::move(next);
        }
        return set;
    }

    std::vector<bool> where(State state) const {
        std::vector<bool> set(m_state.size());
        for (std::size_t i = 0; i < set.size(); ++i) set[i] = m_state[i] == state;
        return set;
    }

    /// Returns the cubes that are reachable from the outermost corner without the blocked ones.
    std::vector<bool> reached(const std::vector<bool>& blocked) const {
        std::vector<bool> set(blocked.size());
        std::vector<std::int64_t> front{0};
        set[0] = true;
        while (!front.empty()) {
            const std::int64_t cube = front.back();
            front.pop_back();
            const CubeGrid::Place place = m_grid.place(cube);
            for (int axis = 0; axis < 3; ++axis)
                for (const int step : {-1, 1}) {
                    const int to = place[axis] + step;
                    if (to < 0 || to >= m_grid.counts()[axis]) continue;
                    const std::int64_t next = cube + step * m_grid.stride(axis);
                    if (set[next] || blocked[next]) continue;
                    set[next] = true;
                    front.push_back(next);
                }
        }
        return set;
    }

    /// Removes the cubes that a cube of 2 radius + 1 of them can reach from outside. A cube of this width
    /// fits where its centre is farther than `radius` from the surface; all that it covers there is air. Both
    /// are dilations of sets, along one axis after another.
    void letAirIn(int radius) {
        const std::vector<bool> surface = where(NearSurface);
        std::vector<bool> air = reached(radius > 0 ? grown(surface, radius) : surface);
        if (radius > 0) air = grown(std::move(air), radius);
        for (std::size_t i = 0; i < air.size(); ++i)
            if (air[i] && !surface[i]) m_state[i] = Air;
    }

    /// Fills cubes that the surface faces outwards from in at least four of the six axis directions.
    void fillWhatIsFaced() {
        std::vector<std::int8_t> votes(m_state.size());
        for (int axis = 0; axis < 3; ++axis) vote(axis, votes);
        for (std::size_t i = 0; i < votes.size(); ++i)
            if (std::abs(votes[i]) >= 4) m_state[i] = Free;
    }

    /// Counts for both directions of an axis how much more often a ray enters the surface than leaves it.
    void vote(int axis, std::vector<std::int8_t>& votes) const {
        std::vector<std::int16_t> entered(m_state.size());
        for (int t = 0; t < m_surface.triangleCount(); ++t) {
            lookAtStop(t);
            cross(cornersOf(m_surface, t), axis, entered);
        }
        const std::int64_t stride = m_grid.stride(axis);
        forEachRow(axis, [&](std::int64_t row) {
            int all = 0, below = 0;
            for (int i = 0; i < m_grid.counts()[axis]; ++i) all += entered[row + i * stride];
            for (int i = 0; i < m_grid.counts()[axis]; ++i) {
                below += entered[row + i * stride];
                votes[row + i * stride] = static_cast<std::int8_t>(
                    votes[row + i * stride] + std::clamp(below, -1, 1) + std::clamp(below - all, -1, 1));
            }
        });
    }

    /// Records where lines through the cube centres enter (+1) or leave (−1) through a triangle: at the first
    /// centre behind it. The lines are slightly shifted, because vertices often have round coordinates.
    void cross(const CubeGrid::Triangle& triangle, int axis, std::vector<std::int16_t>& entered) const {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const Vec3 origin = m_grid.corner({0, 0, 0});
        std::array<Vec3, 3> p;  // in cubes, middles at whole numbers
        const Vec3 beside(0.0131, 0.0277, 0.0419);
        for (int k = 0; k < 3; ++k)
            p[k] = (triangle[k] - origin) / m_grid.edge() - Vec3::Constant(0.5) - beside;
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        if (normal[axis] == 0) return;
        const auto& counts = m_grid.counts();
        const auto range = [&](int along) {
            const auto [low, high] = std::minmax({p[0][along], p[1][along], p[2][along]});
            return std::pair(std::max(0, static_cast<int>(std::ceil(low))),
                             std::min(counts[along] - 1, static_cast<int>(std::floor(high))));
        };
        const auto [fromU, toU] = range(u);
        const auto [fromV, toV] = range(v);
        CubeGrid::Place place{};
        for (place[v] = fromV; place[v] <= toV; ++place[v])
            for (place[u] = fromU; place[u] <= toU; ++place[u]) {
                if (!covers(p, u, v, place[u], place[v])) continue;
                const double at =
                    p[0][axis] -
                    (normal[u] * (place[u] - p[0][u]) + normal[v] * (place[v] - p[0][v])) / normal[axis];
                place[axis] = std::clamp(static_cast<int>(std::ceil(at)), 0, counts[axis] - 1);
                entered[m_grid.number(place)] += normal[axis] < 0 ? 1 : -1;
            }
    }

    /// Returns whether a triangle, projected along an axis, covers a point. The shift of the lines keeps them
    /// off edges as a rule, where two triangles could both count or neither.
    static bool covers(const std::array<Vec3, 3>& p, int u, int v, double x, double y) {
        int left = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 &a = p[k], &b = p[(k + 1) % 3];
            left += (b[u] - a[u]) * (y - a[v]) - (b[v] - a[v]) * (x - a[u]) > 0;
        }
        return left == 0 || left == 3;
    }

    const CubeGrid& m_grid;
    const Surface& m_surface;
    const std::stop_token& m_stop;
    std::vector<std::uint8_t> m_state;
};

CubeGrid::Place countsFor(const Eigen::AlignedBox3d& box, double edge, int layers) {
    CubeGrid::Place counts;
    for (int k = 0; k < 3; ++k)
        counts[k] = std::max(1, static_cast<int>(std::ceil(box.sizes()[k] / edge))) + 2 * layers;
    return counts;
}

}  // namespace

CubeGrid::CubeGrid(const Eigen::AlignedBox3d& box, double edge, int layers, const Vec3& shift)
    : m_edge(edge), m_counts(countsFor(box, edge, layers)) {
    m_low = box.center() + edge * (shift - Vec3(m_counts[0], m_counts[1], m_counts[2]) / 2);
}

double CubeGrid::sizeFor(const Eigen::AlignedBox3d& box, double edge, int layers) {
    double size = 1;
    for (int k = 0; k < 3; ++k) size *= std::max(1.0, std::ceil(box.sizes()[k] / edge)) + 2 * layers;
    return size;
}

int CubeGrid::index(int axis, double coordinate) const {
    const double at = std::floor((coordinate - m_low[axis]) / m_edge);
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(m_counts[axis] - 1)));
}

CubeGrid::Triangle cornersOf(const Surface& surface, int triangle) {
    const auto& ids = surface.triangles[triangle];
    return {surface.points.col(ids[0]), surface.points.col(ids[1]), surface.points.col(ids[2])};
}

/// Tests the 13 separating axes of a cube and a triangle: the normals of both, and the cross products of
/// their edges (Akenine-Möller 2001). Touching counts as meeting; a triangle without area is tested as what
/// it is.
bool meetsCube(const CubeGrid::Triangle& triangle, double half) {
    const auto apart = [&](const Vec3& axis) {
        const std::array along{axis.dot(triangle[0]), axis.dot(triangle[1]), axis.dot(triangle[2])};
        const double reach = half * axis.lpNorm<1>();
        return std::ranges::min(along) > reach || std::ranges::max(along) < -reach;
    };
    for (int k = 0; k < 3; ++k)
        if (apart(Vec3::Unit(k))) return false;
    if (apart((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]))) return false;
    for (int e = 0; e < 3; ++e)
        for (int k = 0; k < 3; ++k)
            if (apart(Vec3::Unit(k).cross(triangle[(e + 1) % 3] - triangle[e]))) return false;
    return true;
}

std::vector<std::int64_t> fullCubes(const CubeGrid& grid, const Surface& surface, double distance, double gap,
                                    const std::stop_token& stop) {
    return Enclosure(grid, surface, stop).full(distance, gap);
}

}  // namespace wend
