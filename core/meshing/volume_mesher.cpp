#include "core/meshing/volume_mesher.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/spatial_order.h"
#include "core/meshing/surface_check.h"
#include "core/meshing/surface_edges.h"
#include "core/meshing/tetgen_protocol.h"

namespace wend {
namespace {

constexpr double kAimTolerance = 0.1;  // inner than the 15 % promised

/// Returns the triangles with the first of all vertices at one place: a soup of triangles is connected, too.
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
    return {
        "wend-tetgen", "the volume mesher",
        sentence("Core",
                 "the volume mesher did not finish within %1 s of computing; a coarser quality or a larger "
                 "maxVolume may help"),
        options.timeLimit};
}

/// Returns the reason for one of TetGen's error codes.
Message reasonInWords(int tetgenError) {
    switch (tetgenError) {
        case 1:
            return sentence("Core", "the volume mesher ran out of memory");
        case 3:
            return sentence("Core", "the surface intersects itself");
        case 4:
            return sentence("Core", "the surface has features too small for its size");
        case 5:
            return sentence("Core", "two facets of the surface lie almost on each other");
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
          m_triangles(joinedTriangles(surface)) {
        findFacets();
        for (const auto& triangle : m_triangles)
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

    /// Returns about the volume that the surface encloses; that of its box if bodies share walls.
    double volume() const {
        if (m_sharesWalls) {
            const Points3 sent = m_surface.points(Eigen::all, m_sent);
            return (sent.rowwise().maxCoeff() - sent.rowwise().minCoeff()).prod();
        }
        double sum = 0;
        for (const auto& t : m_oriented.triangles) {
            const Vec3 a = m_oriented.points.col(t[0]), b = m_oriented.points.col(t[1]),
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
        for (std::size_t f = 0; f < m_facets.size(); ++f) {
            for (const int v : m_triangles[static_cast<std::size_t>(m_facets[f].triangle)])
                request.triangles.push_back(
                    static_cast<int>(std::ranges::lower_bound(m_sent, v) - m_sent.begin()));
            request.labels.push_back(m_markers[f]);
        }
        return request;
    }

    /// A triangle of the surface, or two that face each other at one place.
    struct SurfaceFacet {
        int triangle, shell;
        std::vector<int> labels;
    };

    void findFacets() {
        const std::vector<int> shells = shellsOf(m_triangles, m_surface.vertexCount());
        std::map<std::array<int, 3>, std::size_t> known;
        for (int t = 0; t < m_surface.triangleCount(); ++t) {
            std::array<int, 3> key = m_triangles[static_cast<std::size_t>(t)];
            std::ranges::sort(key);
            const auto [place, isNew] = known.try_emplace(key, m_facets.size());
            if (isNew) m_facets.push_back({t, shells[static_cast<std::size_t>(t)], {}});
            m_facets[place->second].labels.push_back(m_surface.labels.empty() ? 0 : m_surface.labels[t]);
        }
        Surface distinct{m_surface.points, {}, {}};
        for (const SurfaceFacet& facet : m_facets)
            distinct.triangles.push_back(m_triangles[static_cast<std::size_t>(facet.triangle)]);
        m_sharesWalls = std::ranges::any_of(
            edgesOf(distinct), [](const SurfaceEdge& edge) { return edge.triangles.size() > 2; });
        markFacets();
    }
    /// 0 is TetGen's own "no marker". Where the surface may be split, facets of one shell and label have one
    /// marker, so that TetGen joins those of a plane and not every one of their edges has to survive.
    void markFacets() {
        std::map<std::pair<int, std::vector<int>>, int> markers;
        for (std::size_t f = 0; f < m_facets.size(); ++f) {
            const SurfaceFacet& facet = m_facets[f];
            int marker = static_cast<int>(f) + 1;
            if (!m_options.keepSurface)
                marker =
                    markers.try_emplace({facet.shell, facet.labels}, static_cast<int>(markers.size()) + 1)
                        .first->second;
            m_markers.push_back(marker);
            if (static_cast<std::size_t>(marker) > m_marked.size()) m_marked.push_back(static_cast<int>(f));
        }
    }
    /// Returns a facet that has the marker; null for TetGen's own.
    const SurfaceFacet* facetOf(int marker) const {
        if (marker <= 0 || marker > static_cast<int>(m_marked.size())) return nullptr;
        return &m_facets[static_cast<std::size_t>(m_marked[static_cast<std::size_t>(marker) - 1])];
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

    /// Returns the surface's facets in the reply, by their vertices.
    std::map<std::array<int, 3>, const SurfaceFacet*> facetsIn(const TetgenReply& reply) const {
        std::map<std::array<int, 3>, const SurfaceFacet*> facets;
        for (std::size_t f = 0; f < reply.labels.size(); ++f)
            if (const SurfaceFacet* facet = facetOf(reply.labels[f])) {
                std::array<int, 3> key{reply.boundary[3 * f], reply.boundary[3 * f + 1],
                                       reply.boundary[3 * f + 2]};
                std::ranges::sort(key);
                facets[key] = facet;
            }
        return facets;
    }

    /// Returns the walls between the spaces of cells.
    std::vector<SpaceWall> wallsOf(const TetgenReply& reply, const std::vector<int>& spaceOf) const {
        const auto facets = facetsIn(reply);
        std::vector<std::pair<std::array<int, 3>, int>> faces;  // each with the space on one side
        for (std::size_t c = 0; c < spaceOf.size(); ++c)
            for (std::size_t k = 0; k < 4; ++k) {
                std::array<int, 3> face;
                for (std::size_t i = 0, at = 0; i < 4; ++i)
                    if (i != k) face[at++] = reply.cells[4 * c + i];
                std::ranges::sort(face);
                faces.emplace_back(face, spaceOf[c]);
            }
        std::ranges::sort(faces);
        std::vector<SpaceWall> walls;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const bool isInner = i + 1 < faces.size() && faces[i + 1].first == faces[i].first;
            const std::array<int, 2> spaces{faces[i].second, isInner ? faces[i + 1].second : -1};
            const auto facet = spaces[0] == spaces[1] ? facets.end() : facets.find(faces[i].first);
            if (facet != facets.end())
                walls.push_back({spaces, facet->second->shell, facet->second->labels, faces[i].first});
            if (isInner) ++i;
        }
        return walls;
    }

    /// Finds the spaces of the cells, and keeps the cells of those that are filled.
    void keepFilled(const TetgenReply& reply, VolumeMesh& result) const {
        std::map<int, int> numbers;
        std::vector<int> spaceOf;
        for (const int region : reply.regions)
            spaceOf.push_back(numbers.try_emplace(region, static_cast<int>(numbers.size())).first->second);
        result.spaces = shellSpaces(static_cast<int>(numbers.size()), wallsOf(reply, spaceOf),
                                    m_options.shells, m_options.labelNames);
        const bool labelled = result.spaces.spaces.size() > 1 &&
                              (m_options.shells == Shells::Regions || result.spaces.shareWalls());
        for (std::size_t c = 0; c < spaceOf.size(); ++c) {
            const ShellSpace& space = result.spaces.spaces[static_cast<std::size_t>(spaceOf[c])];
            if (!space.kept) continue;
            Cell<3> cell;
            std::copy_n(reply.cells.begin() + static_cast<std::ptrdiff_t>(4 * c), 4, cell.begin());
            result.mesh.cells.push_back(cell);
            if (labelled) result.cellLabels.push_back(space.label);
        }
    }

    /// Keeps the spaces inside, and drops vertices of other cells.
    VolumeMesh read(const TetgenReply& raw) const {
        const TetgenReply reply = renumbered(raw);
        VolumeMesh result;
        keepFilled(reply, result);
        if (result.mesh.cells.empty()) throw InputError(sentence("Core", "the surface encloses no volume"));
        result.mesh.points = Eigen::Map<const Points3>(reply.points.data(), 3,
                                                       static_cast<Eigen::Index>(reply.points.size() / 3));
        std::vector<int> newId = dropUnused(result.mesh);
        orientPositive(result.mesh);
        const auto ofSurface = newId.begin() + m_surface.vertexCount();
        const auto first = std::count_if(newId.begin(), ofSurface, [](int id) { return id >= 0; });
        std::vector<int> cellOrder;
        const auto number = sortSpatially(result.mesh, static_cast<int>(first), &cellOrder);
        const std::vector<int> unsorted = result.cellLabels;
        for (std::size_t c = 0; c < unsorted.size(); ++c)
            result.cellLabels[c] = unsorted[static_cast<std::size_t>(cellOrder[c])];
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
            const SurfaceFacet* input = facetOf(reply.labels[f]);
            if (!input) continue;
            std::array<int, 3> facet;
            for (int k = 0; k < 3; ++k) facet[k] = newId[reply.boundary[3 * f + k]];
            if (*std::min_element(facet.begin(), facet.end()) < 0) continue;
            result.boundary.push_back(facet);
            result.boundaryLabels.push_back(input->labels.front());
        }
    }

    const Surface& m_surface;
    const VolumeMeshOptions& m_options;
    Surface m_oriented;
    std::vector<std::array<int, 3>> m_triangles;  // of the surface, with joined vertices
    std::vector<SurfaceFacet> m_facets;
    std::vector<int> m_markers;  // of the facets, from 1 on
    std::vector<int> m_marked;   // a facet of each marker
    bool m_sharesWalls = false;
    std::vector<int> m_sent;  // vertices of the surface that its triangles need, increasing
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
SizeGrid sampleSizes(const Surface& surface, const std::function<double(const Vec3&)>& factorAt) {
    constexpr double kNodes = 50;
    SizeGrid grid;
    grid.low = surface.points.rowwise().minCoeff();
    const Vec3 extent = surface.points.rowwise().maxCoeff() - grid.low;
    for (int k = 0; k < 3; ++k) {
        grid.counts[k] = 2 + static_cast<int>(kNodes * extent[k] / std::max(extent.maxCoeff(), 1e-300));
        grid.spacing[k] = extent[k] / (grid.counts[k] - 1);
    }
    for (int z = 0; z < grid.counts[2]; ++z)
        for (int y = 0; y < grid.counts[1]; ++y)
            for (int x = 0; x < grid.counts[0]; ++x)
                grid.factors.push_back(factorAt(grid.low + grid.spacing.cwiseProduct(Vec3(x, y, z))));
    return grid;
}

int VolumeMesh::usedCount() const {
    return static_cast<int>(std::ranges::count(usedVertices<3>(mesh.vertexCount(), mesh.cells), true));
}

VolumeMesh meshVolume(const Surface& surface, const VolumeMeshOptions& options) {
    requireSense(options);
    if (surface.triangles.empty()) throw InputError(sentence("Core", "the surface has no triangle"));
    const SurfaceProblems problems = checkSurface(surface, 10000, options.stop);
    if (!problems.boundsVolume())
        throw SurfaceError({sentence("Core", "the surface bounds no volume: %1"), problems.summary()},
                           problems);
    const VolumeMesher mesher(surface, options);
    return options.vertices > 0 ? meshForAim(mesher, options) : mesher.mesh(options.maxVolume);
}

}  // namespace wend
