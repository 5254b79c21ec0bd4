#include "core/meshing/cage_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/meshing/cube_grid.h"
#include "core/meshing/spatial_order.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

constexpr double kMostCubes = 5e7;     // of a grid: half a gigabyte while they are filled
constexpr double kMinDistance = 1e-9;  // of the diagonal: more than rounding
constexpr double kNearEnough = 0.03;   // to the aim, to stop looking
constexpr double kPromised = 0.15;
constexpr double kOblique = 1.2;  // cubes across: a gap that is tilted more is faced from several axes
constexpr int kMostTries = 16;

/// Fills the cubes with tetrahedra. Where cubes touch at a corner or edge only, each side gets its own
/// vertices, so that nothing is connected by a point or a line.
class CubeMesher {
  public:
    CubeMesher(const CubeGrid& grid, std::vector<std::int64_t> full)
        : m_grid(grid), m_full(std::move(full)), m_corners(m_full.size()) {
        for (auto& corners : m_corners) corners.fill(-1);
    }

    /// Builds the tetrahedra of all full cubes, with shared corners and centres.
    SimplicialMesh<3> mesh() {
        for (const std::int64_t cube : m_full) m_points.push_back(m_grid.centre(m_grid.place(cube)));
        for (int i = 0; i < count(); ++i)
            for (int corner = 0; corner < 8; ++corner)
                if (m_corners[i][corner] < 0) placeCorner(i, corner);
        for (int i = 0; i < count(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                for (const int side : {0, 1}) fillSide(i, axis, side);
        SimplicialMesh<3> mesh;
        mesh.points.resize(3, static_cast<Eigen::Index>(m_points.size()));
        for (std::size_t i = 0; i < m_points.size(); ++i)
            mesh.points.col(static_cast<Eigen::Index>(i)) = m_points[i];
        for (auto& cell : m_cells)
            if (cellMeasure<3>(mesh.points, cell) < 0) std::swap(cell[2], cell[3]);
        mesh.cells = std::move(m_cells);
        return mesh;
    }

    int bodies() const {
        DisjointSets sets(count());
        for (int i = 0; i < count(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                if (const int next = neighbour(i, axis, 1); next >= 0) sets.join(i, next);
        int bodies = 0;
        for (int i = 0; i < count(); ++i) bodies += sets.root(i) == i;
        return bodies;
    }

  private:
    int count() const { return static_cast<int>(m_full.size()); }

    /// Returns the place of a cube among the full ones, −1 if it is not full. The outermost cubes never are,
    /// so the number of a neighbour does not wrap around the grid.
    int find(std::int64_t cube) const {
        const auto at = std::ranges::lower_bound(m_full, cube);
        return at != m_full.end() && *at == cube ? static_cast<int>(at - m_full.begin()) : -1;
    }
    int neighbour(int i, int axis, int side) const {
        return find(m_full[i] + (side == 1 ? 1 : -1) * m_grid.stride(axis));
    }

    /// Uses one vertex for all cubes around the corner that are connected through faces there.
    void placeCorner(int i, int corner) {
        CubeGrid::Place place = m_grid.place(m_full[i]);
        for (int k = 0; k < 3; ++k) place[k] += corner >> k & 1;
        std::array<int, 8> around;  // cubes, by the side of the corner that they are on
        for (int c = 0; c < 8; ++c)
            around[c] = find(m_grid.number(
                {place[0] - 1 + (c & 1), place[1] - 1 + (c >> 1 & 1), place[2] - 1 + (c >> 2 & 1)}));
        DisjointSets sets(8);
        for (int c = 0; c < 8; ++c)
            for (int k = 0; k < 3; ++k)
                if (const int other = c ^ 1 << k; around[c] >= 0 && around[other] >= 0) sets.join(c, other);
        const int mine = 7 - corner;  // the cube is diagonally opposite of its corner
        for (int c = 0; c < 8; ++c)
            if (around[c] >= 0 && sets.root(c) == sets.root(mine))
                m_corners[around[c]][7 - c] = static_cast<int>(m_points.size());
        m_points.push_back(m_grid.corner(place));
    }

    /// Adds four tetrahedra around the line to a neighbour's centre, or two on a side without a neighbour.
    void fillSide(int i, int axis, int side) {
        const int next = neighbour(i, axis, side);
        if (next >= 0 && side == 0) return;  // made from there
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
        const std::array ring{m_corners[i][base], m_corners[i][base | u], m_corners[i][base | u | v],
                              m_corners[i][base | v]};
        if (next < 0) {
            m_cells.push_back({i, ring[0], ring[1], ring[2]});
            m_cells.push_back({i, ring[0], ring[2], ring[3]});
            return;
        }
        for (int k = 0; k < 4; ++k) m_cells.push_back({i, next, ring[k], ring[(k + 1) % 4]});
    }

    const CubeGrid& m_grid;
    std::vector<std::int64_t> m_full;
    std::vector<std::array<int, 8>> m_corners;  // vertices, by the axes' sides as bits
    std::vector<Vec3> m_points;                 // the middles first
    std::vector<Cell<3>> m_cells;
};

class CageFitter {
  public:
    CageFitter(const Surface& surface, const CageOptions& options) : m_surface(surface), m_options(options) {
        for (const auto& triangle : surface.triangles)
            for (const int v : triangle) m_box.extend(surface.points.col(v).eval());
        m_diagonal = m_box.diagonal().norm();
        if (!(m_diagonal > 1e-140 && m_diagonal < 1e140))
            throw InputError(sentence("Core", "the surface has no extent"));
    }

    /// Returns the cage of cubes with that edge, or with the least edge that memory allows.
    Cage ofEdge(double edge) const {
        Cage cage;
        cage.edge = std::max(edge, minEdge());
        cage.aimMet = cage.edge <= edge;
        const CubeGrid grid = gridOf(cage.edge);
        CubeMesher mesher(grid, fullCubesOf(grid));
        cage.mesh = mesher.mesh();
        cage.bodies = mesher.bodies();
        return cage;
    }

    /// If whole cubes along the box give too many or too few vertices, tries shifted grids.
    Cage ofCount(int aim) {
        Cage best;
        double bestError = std::numeric_limits<double>::infinity();
        Vec3 bestShift = m_shift;
        for (int shift = 0; shift < 8 && bestError > kPromised; ++shift) {
            m_shift = Vec3(shift & 1, shift >> 1 & 1, shift >> 2 & 1) / 2;
            Cage cage = search(aim);
            const double error = errorOf(cage, aim);
            if (error >= bestError) continue;
            bestError = error;
            bestShift = m_shift;
            best = std::move(cage);
        }
        m_shift = bestShift;
        best.aimMet = bestError <= kPromised;
        return best;
    }

    /// Parts of the surface that have a cube in common move together.
    void countParts(Cage& cage) const {
        const std::vector<int> first = canonicalVertices(m_surface.points);
        DisjointSets parts(m_surface.vertexCount());
        for (const auto& t : m_surface.triangles)
            for (int k = 1; k < 3; ++k) parts.join(first[t[0]], first[t[k]]);
        cage.parts = countOf(parts);
        const CubeGrid grid = gridOf(cage.edge);
        std::map<std::int64_t, int> owner;
        for (int t = 0; t < m_surface.triangleCount(); ++t)
            grid.forEachNear(cornersOf(m_surface, t), kMinDistance * m_diagonal, [&](std::int64_t cube) {
                const int mine = first[m_surface.triangles[t][0]];
                parts.join(owner.try_emplace(cube, mine).first->second, mine);
            });
        cage.apart = countOf(parts);
    }

    /// Searches gaps between sides without an empty cube in between; diagonally they are that far apart.
    void findGaps(Cage& cage) const {
        const CubeGrid grid = gridOf(cage.edge);
        const double widest = gap() + 2 * std::sqrt(3.0) * (cage.edge + distance(cage.edge));
        cage.gaps = closedGaps(m_surface, grid, fullCubesOf(grid), widest, m_options.stop);
        if (!cage.gaps.empty()) findWhatOpens(cage);
    }

  private:
    /// Finds the cubes that keep the widest gap open. A gap of two cubes and two distances between walls
    /// along an axis contains an empty cube for any shift. An oblique gap faces the surface on most sides and
    /// is filled without a detail, however small the cubes. Air of the width of `detail` needs two cubes as
    /// well.
    void findWhatOpens(Cage& cage) const {
        const ClosedGap& closed = cage.gaps.back();
        const double reach = 1 + 2 * m_options.offset;
        const double cubes = 2 * closed.cubeAcross + 2 * m_options.offset;
        const bool isOblique = closed.cubeAcross > kOblique;
        if (gap() == 0 && !isOblique && closed.width < cubes * cage.edge) {
            cage.openEdge = closed.width / cubes;
            return;
        }
        if (cage.edge > closed.width / 3) cage.openEdge = closed.width / 4;
        const double edge = cage.openEdge > 0 ? cage.openEdge : cage.edge;
        const double detail = m_diagonal * reach / (20 * (closed.width - 2 * edge));
        if (cage.openEdge == 0 || detail > m_options.detail) cage.openDetail = detail;
    }

    std::vector<std::int64_t> fullCubesOf(const CubeGrid& grid) const {
        return fullCubes(grid, m_surface, distance(grid.edge()), gap(), m_options.stop);
    }
    static double errorOf(const Cage& cage, int aim) {
        return std::abs(static_cast<double>(cage.mesh.vertexCount()) / aim - 1);
    }

    /// Searches the edge between bounds with too many and too few vertices. The count is proportional to a
    /// power of the edge between −2 and −3, in steps of whole cubes, so the first tries extrapolate with 2.6
    /// and later ones halve the interval geometrically. Returns the best one of all.
    Cage search(int aim) const {
        double edge = m_diagonal / 20, tooFine = 0, tooCoarse = std::numeric_limits<double>::infinity();
        Cage best;
        double bestError = std::numeric_limits<double>::infinity();
        for (int run = 0; run < kMostTries && bestError > kNearEnough; ++run) {
            Cage cage = ofEdge(edge);
            const double count = cage.mesh.vertexCount();
            const bool tooMany = count > aim;
            if (tooMany)
                tooFine = std::max(tooFine, edge);
            else
                tooCoarse = std::min(tooCoarse, edge);
            if (const double error = errorOf(cage, aim); error < bestError) {
                bestError = error;
                best = std::move(cage);
            }
            if (!tooMany && edge <= minEdge()) break;
            edge = std::max(minEdge(), edge * std::clamp(std::pow(count / aim, 1 / 2.6), 0.2, 5.0));
            if (edge <= 1.001 * tooFine || edge >= 0.999 * tooCoarse) edge = std::sqrt(tooFine * tooCoarse);
            if (tooFine >= 0.999 * tooCoarse) break;
        }
        return best;
    }

    int countOf(DisjointSets& parts) const {
        std::vector<int> roots;
        const std::vector<int> first = canonicalVertices(m_surface.points);
        for (const auto& t : m_surface.triangles) roots.push_back(parts.root(first[t[0]]));
        std::ranges::sort(roots);
        return static_cast<int>(std::unique(roots.begin(), roots.end()) - roots.begin());
    }

    double gap() const { return m_options.detail > 0 ? m_diagonal / (20 * m_options.detail) : 0; }
    double distance(double edge) const {
        return std::max(kMinDistance * m_diagonal, m_options.offset * (gap() > 0 ? gap() : edge));
    }
    /// Returns the layers of cubes that leave room for the distance, and for a path around of the gap's
    /// width.
    int layers(double edge) const {
        return 2 + static_cast<int>(std::ceil(distance(edge) / edge)) + static_cast<int>(gap() / edge);
    }
    CubeGrid gridOf(double edge) const { return {m_box, edge, layers(edge), m_shift}; }
    double minEdge() const {
        if (m_minEdge == 0) {
            m_minEdge = m_diagonal / 1e4;
            while (CubeGrid::sizeFor(m_box, m_minEdge, layers(m_minEdge)) > kMostCubes) m_minEdge *= 1.1;
        }
        return m_minEdge;
    }

    const Surface& m_surface;
    const CageOptions& m_options;
    Eigen::AlignedBox3d m_box;
    double m_diagonal = 0;
    mutable double m_minEdge = 0;
    Vec3 m_shift = Vec3::Zero();  // of the cubes
};

void requireFinite(const Surface& surface) {
    if (surface.triangles.empty()) throw InputError(sentence("Core", "the surface has no triangle"));
    for (int t = 0; t < surface.triangleCount(); ++t)
        for (const int v : surface.triangles[t]) {
            if (v < 0 || v >= surface.vertexCount())
                throw InputError("triangle " + std::to_string(t) + " names a missing vertex");
            if (!surface.points.col(v).allFinite())
                throw InputError("vertex " + std::to_string(v) + " is not finite");
        }
}

}  // namespace

Cage cageAround(const Surface& surface, const CageOptions& options) {
    requireFinite(surface);
    CageFitter fitter(surface, options);
    // The largest cells, at sides without neighbour, are a twelfth of a cube, as those between middles are.
    Cage cage = options.maxVolume > 0 ? fitter.ofEdge(std::cbrt(12 * options.maxVolume))
                                      : fitter.ofCount(options.vertices);
    fitter.countParts(cage);
    fitter.findGaps(cage);
    sortSpatially(cage.mesh, 0);
    requireValid(cage.mesh);
    return cage;
}

}  // namespace wend
