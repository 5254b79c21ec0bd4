#include "core/meshing/volume_mesher.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "core/mesh/error.h"
#include "core/mesh/number_text.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/solid_angle.h"
#include "core/meshing/spatial_order.h"
#include "core/meshing/surface_check.h"
#include "core/meshing/surface_edges.h"
#include "core/meshing/tetgen_protocol.h"

namespace wend {
namespace {

constexpr double kAimTolerance = 0.1;  // inner than the 15 % promised

/// Shells: triangles connected over vertices, one number per triangle.
std::vector<int> shellsOf(const Surface& surface) {
    std::vector<int> parent(static_cast<std::size_t>(surface.vertexCount()));
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const auto& t : surface.triangles)
        for (int k = 1; k < 3; ++k) parent[root(t[k])] = root(t[0]);
    std::map<int, int> names;
    std::vector<int> shells;
    shells.reserve(surface.triangles.size());
    for (const auto& t : surface.triangles)
        shells.push_back(names.try_emplace(root(t[0]), static_cast<int>(names.size())).first->second);
    return shells;
}

/// Is p inside an odd number of shells? Their orientation does not matter.
bool inside(const Surface& surface, const std::vector<int>& shells, const Vec<3>& p) {
    std::vector<double> winding(*std::max_element(shells.begin(), shells.end()) + 1, 0.0);
    for (int t = 0; t < surface.triangleCount(); ++t) {
        const auto& ids = surface.triangles[t];
        winding[shells[t]] +=
            solidAngle(p, surface.points.col(ids[0]), surface.points.col(ids[1]), surface.points.col(ids[2]));
    }
    const auto around = [](double angle) {
        return std::lround(std::abs(angle) / (4 * std::numbers::pi)) % 2;
    };
    long enclosing = 0;
    for (double angle : winding) enclosing += around(angle);
    return enclosing % 2 == 1;
}

/// The triangles with the first of all vertices at one place: a soup of triangles is connected, too.
std::vector<std::array<int, 3>> joinedTriangles(const Surface& surface) {
    const std::vector<int> canonical = canonicalVertices(surface.points);
    std::vector<std::array<int, 3>> triangles = surface.triangles;
    for (auto& triangle : triangles)
        for (int& id : triangle) id = canonical[static_cast<std::size_t>(id)];
    return triangles;
}

/// Orients neighbours consistently, so that the winding number of a shell is meaningful.
Surface oriented(const Surface& surface) {
    RepairReport report;
    Surface copy{surface.points, joinedTriangles(surface), surface.labels};
    return checkSurface(copy, 0).misoriented.empty() ? copy : repairSurface(copy, 0, report);
}

MesherProcess mesherFor(const VolumeMeshOptions& options) {
    return {"wend-tetgen", "the volume mesher", "the volume mesher did not finish within ",
            "a coarser quality or a larger maxVolume may help", options.timeLimit};
}

/// Returns the reason for one of TetGen's error codes.
std::string reasonInWords(int tetgenError) {
    switch (tetgenError) {
        case 1:
            return "the volume mesher ran out of memory";
        case 3:
            return "the surface intersects itself";
        case 4:
            return "the surface has features too small for its size";
        case 5:
            return "two facets of the surface lie almost on each other";
        default:
            return "the volume mesher failed inside (code " + std::to_string(tetgenError) + ")";
    }
}

class VolumeMesher {
  public:
    VolumeMesher(const Surface& surface, const VolumeMeshOptions& options)
        : m_surface(surface),
          m_options(options),
          m_oriented(oriented(surface)),
          m_shells(shellsOf(m_oriented)),
          m_labels(surface.labels.empty() ? std::vector<int>{0} : surface.labels) {
        std::ranges::sort(m_labels);
        m_labels.erase(std::unique(m_labels.begin(), m_labels.end()), m_labels.end());
        for (const auto& triangle : joinedTriangles(surface))
            m_sent.insert(m_sent.end(), triangle.begin(), triangle.end());
        std::ranges::sort(m_sent);
        m_sent.erase(std::unique(m_sent.begin(), m_sent.end()), m_sent.end());
    }

    VolumeMesh mesh(double maxVolume) const {
        const std::string answer = answerOf(mesherFor(m_options), pack(request(maxVolume)),
                                            m_surface.triangleCount(), m_options.stop);
        TetgenReply reply;
        if (!unpack(answer, reply)) throw InputError("the volume mesher gave an incomplete answer");
        if (reply.error != 0) throw InputError(reasonInWords(reply.error));
        return read(reply);
    }

    double volume() const {
        double sum = 0;
        for (const auto& t : m_oriented.triangles) {
            const Vec<3> a = m_oriented.points.col(t[0]), b = m_oriented.points.col(t[1]),
                         c = m_oriented.points.col(t[2]);
            sum += a.dot(b.cross(c)) / 6;
        }
        return std::abs(sum);
    }

  private:
    /// Returns the request to wend-tetgen for a largest volume of cells, with the switches of the options.
    TetgenRequest request(double maxVolume) const {
        TetgenRequest request;
        request.switches =
            std::string("pAQ") + (m_options.keepSurface ? "Y" : "") + "q" + numberText(m_options.quality);
        if (m_options.sizes.empty() && maxVolume > 0) request.switches += "a" + numberText(maxVolume);
        if (!m_options.sizes.empty() && maxVolume > 0) addSizes(maxVolume, request);
        for (const int v : m_sent)
            for (int k = 0; k < 3; ++k) request.points.push_back(m_surface.points(k, v));
        const auto triangles = joinedTriangles(m_surface);
        for (int t = 0; t < m_surface.triangleCount(); ++t) {
            for (const int v : triangles[t])
                request.triangles.push_back(
                    static_cast<int>(std::ranges::lower_bound(m_sent, v) - m_sent.begin()));
            request.labels.push_back(markerOf(t));
        }
        return request;
    }

    /// 0 is TetGen's own "no marker". Where the surface may be split, triangles of a plane and label are one
    /// facet, so that not every one of their edges has to survive.
    int markerOf(int triangle) const {
        if (m_options.keepSurface) return triangle + 1;
        return static_cast<int>(std::ranges::lower_bound(m_labels, labelOf(triangle)) - m_labels.begin()) + 1;
    }
    int labelOf(int triangle) const { return m_surface.labels.empty() ? 0 : m_surface.labels[triangle]; }
    int labelOfMarker(int marker) const {
        return m_options.keepSurface ? labelOf(marker - 1) : m_labels[static_cast<std::size_t>(marker - 1)];
    }
    int markerCount() const {
        return m_options.keepSurface ? m_surface.triangleCount() : static_cast<int>(m_labels.size());
    }
    void addSizes(double maxVolume, TetgenRequest& request) const {
        const SizeGrid& sizes = m_options.sizes;
        request.sizes = {maxVolume};
        request.sizes.insert(request.sizes.end(), sizes.low.begin(), sizes.low.end());
        request.sizes.insert(request.sizes.end(), sizes.spacing.begin(), sizes.spacing.end());
        request.sizes.insert(request.sizes.end(), sizes.factors.begin(), sizes.factors.end());
        request.sizeCounts.assign(sizes.counts.begin(), sizes.counts.end());
    }

    /// Returns all points of the surface, followed by those of the mesher, with cells and boundary in terms
    /// of them: the mesher drops unused points, which would renumber the others.
    TetgenReply renumbered(const TetgenReply& reply) const {
        const auto sent = static_cast<std::ptrdiff_t>(m_sent.size());
        if (static_cast<std::ptrdiff_t>(reply.points.size()) < 3 * sent)
            throw InputError("the volume mesher lost points of the surface");
        TetgenReply result = reply;
        result.points.assign(m_surface.points.data(), m_surface.points.data() + m_surface.points.size());
        result.points.insert(result.points.end(), reply.points.begin() + 3 * sent, reply.points.end());
        const auto rename = [&](int& v) {
            v = v < sent ? m_sent[v] : v - static_cast<int>(sent) + m_surface.vertexCount();
        };
        std::ranges::for_each(result.cells, rename);
        std::ranges::for_each(result.boundary, rename);
        return result;
    }

    /// Keeps the regions inside, with one test per region, and drops vertices of other cells.
    VolumeMesh read(const TetgenReply& raw) const {
        const TetgenReply reply = renumbered(raw);
        const Eigen::Map<const Points<3>> points(reply.points.data(), 3,
                                                 static_cast<Eigen::Index>(reply.points.size() / 3));
        std::map<int, bool> keep;
        VolumeMesh result;
        for (std::size_t c = 0; c < reply.regions.size(); ++c) {
            Cell<3> cell;
            std::copy_n(reply.cells.begin() + static_cast<std::ptrdiff_t>(4 * c), 4, cell.begin());
            const auto known = keep.find(reply.regions[c]);
            if (known == keep.end()) {
                const Vec<3> centre =
                    (points.col(cell[0]) + points.col(cell[1]) + points.col(cell[2]) + points.col(cell[3])) /
                    4;
                keep[reply.regions[c]] = inside(m_oriented, m_shells, centre);
            }
            if (keep[reply.regions[c]]) result.mesh.cells.push_back(cell);
        }
        if (result.mesh.cells.empty()) throw InputError("the surface encloses no volume");
        result.mesh.points = points;
        std::vector<int> newId = dropUnused(result.mesh);
        orientPositive(result.mesh);
        const auto ofSurface = newId.begin() + m_surface.vertexCount();
        const auto first = std::count_if(newId.begin(), ofSurface, [](int id) { return id >= 0; });
        const auto number = sortSpatially(result.mesh, static_cast<int>(first));
        for (int& id : newId)
            if (id >= 0) id = number[id];
        readBoundary(reply, newId, result);
        requireValid(result.mesh);
        return result;
    }

    /// Drops vertices beyond the surface's own that no cell uses (they were in a hole); returns the new ids,
    /// −1 for those.
    std::vector<int> dropUnused(SimplicialMesh<3>& mesh) const {
        std::vector<int> newId(static_cast<std::size_t>(mesh.vertexCount()), -1);
        for (int v = 0; m_options.keepSurface && v < m_surface.vertexCount(); ++v) newId[v] = 0;
        for (const auto& cell : mesh.cells)
            for (int v : cell) newId[v] = 0;
        int kept = 0;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (newId[v] < 0) continue;
            mesh.points.col(kept) = mesh.points.col(v).eval();
            newId[v] = kept++;
        }
        mesh.points.conservativeResize(Eigen::NoChange, kept);
        for (auto& cell : mesh.cells)
            for (int& v : cell) v = newId[v];
        return newId;
    }

    static void orientPositive(SimplicialMesh<3>& mesh) {
        for (auto& cell : mesh.cells)
            if (cellMeasure<3>(mesh.points, cell) < 0) std::swap(cell[2], cell[3]);
    }

    /// Reads the boundary triangles, with the labels of the input triangles that contain them.
    void readBoundary(const TetgenReply& reply, const std::vector<int>& newId, VolumeMesh& result) const {
        for (std::size_t f = 0; f < reply.labels.size(); ++f) {
            if (reply.labels[f] <= 0 || reply.labels[f] > markerCount()) continue;
            std::array<int, 3> facet;
            for (int k = 0; k < 3; ++k) facet[k] = newId[reply.boundary[3 * f + k]];
            if (*std::min_element(facet.begin(), facet.end()) < 0) continue;
            result.boundary.push_back(facet);
            result.boundaryLabels.push_back(labelOfMarker(reply.labels[f]));
        }
    }

    const Surface& m_surface;
    const VolumeMeshOptions& m_options;
    Surface m_oriented;
    std::vector<int> m_shells;
    std::vector<int> m_sent;    // vertices of the surface that its triangles need, increasing
    std::vector<int> m_labels;  // those that there are, each once, increasing
};

/// The number of inner vertices is proportional to 1/maxVolume: a secant search in the logarithm, bracketed
/// by known bounds, with at most ten runs.
VolumeMesh meshForAim(const VolumeMesher& mesher, const VolumeMeshOptions& options) {
    double maxVolume = mesher.volume() / (5.0 * options.vertices);
    VolumeMesh best;
    double bestError = std::numeric_limits<double>::infinity();
    double lastVolume = 0, lastCount = 0;
    double tooSmall = 0, tooLarge = std::numeric_limits<double>::infinity();  // volumes
    for (int run = 0; run < 10; ++run) {
        VolumeMesh mesh = mesher.mesh(maxVolume);
        const double count = mesh.usedCount();
        const double error = std::abs(count / options.vertices - 1);
        if (error < bestError) {
            bestError = error;
            best = std::move(mesh);
        }
        if (bestError <= kAimTolerance) break;
        if (count > options.vertices)
            tooSmall = std::max(tooSmall, maxVolume);
        else
            tooLarge = std::min(tooLarge, maxVolume);
        double slope = -1;
        if (lastCount > 0 && lastCount != count && lastVolume != maxVolume)
            slope = std::clamp(std::log(count / lastCount) / std::log(maxVolume / lastVolume), -1.5, -0.2);
        lastVolume = maxVolume;
        lastCount = count;
        maxVolume *= std::clamp(std::pow(options.vertices / count, 1 / slope), 1.0 / 16, 16.0);
        const bool between = maxVolume > 1.02 * tooSmall && 1.02 * maxVolume < tooLarge;
        if (!between && tooSmall > 0 && tooSmall < tooLarge && std::isfinite(tooLarge))
            maxVolume = std::sqrt(tooSmall * tooLarge);
        if (maxVolume > mesher.volume()) maxVolume = mesher.volume();
        if (maxVolume == lastVolume) break;
    }
    best.aimMet = bestError <= 0.15;
    return best;
}

void requireSense(const VolumeMeshOptions& options) {
    if (!(options.quality >= 1.2))
        throw InputError("quality " + numberText(options.quality) +
                         " is below 1.2, where meshing need not end");
    if (!(options.maxVolume >= 0) || !std::isfinite(options.maxVolume))
        throw InputError("maxVolume must be a positive number");
    if (options.vertices < 0) throw InputError("vertices must be positive");
}

}  // namespace

/// Chooses nodes that are equally spaced along all axes.
SizeGrid sampleSizes(const Surface& surface, const std::function<double(const Vec<3>&)>& factorAt) {
    constexpr double kNodes = 50;
    SizeGrid grid;
    grid.low = surface.points.rowwise().minCoeff();
    const Vec<3> extent = surface.points.rowwise().maxCoeff() - grid.low;
    for (int k = 0; k < 3; ++k) {
        grid.counts[k] = 2 + static_cast<int>(kNodes * extent[k] / std::max(extent.maxCoeff(), 1e-300));
        grid.spacing[k] = extent[k] / (grid.counts[k] - 1);
    }
    for (int z = 0; z < grid.counts[2]; ++z)
        for (int y = 0; y < grid.counts[1]; ++y)
            for (int x = 0; x < grid.counts[0]; ++x)
                grid.factors.push_back(factorAt(grid.low + grid.spacing.cwiseProduct(Vec<3>(x, y, z))));
    return grid;
}

int VolumeMesh::usedCount() const {
    return static_cast<int>(std::ranges::count(usedVertices<3>(mesh.vertexCount(), mesh.cells), true));
}

VolumeMesh meshVolume(const Surface& surface, const VolumeMeshOptions& options) {
    requireSense(options);
    if (surface.triangles.empty()) throw InputError("the surface has no triangle");
    const SurfaceProblems problems = checkSurface(surface, 10000, options.stop);
    if (!problems.boundsVolume())
        throw SurfaceError("the surface bounds no volume: " + problems.summary(), problems);
    const VolumeMesher mesher(surface, options);
    return options.vertices > 0 ? meshForAim(mesher, options) : mesher.mesh(options.maxVolume);
}

}  // namespace wend
