#include "core/meshing/planar_mesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/meshing/outline_check.h"
#include "core/meshing/outline_simplify.h"
#include "core/meshing/planar_refinement.h"
#include "core/meshing/spatial_order.h"

namespace wend {
namespace {

constexpr int mostVertices = 20'000'000;
constexpr double pointTolerance = 1e-9;  // of the diagonal: a point that near to the outline is on it

// Measured on squares, discs and stars: a mesh of triangles with circumradius ≤ r has about verticesPerArea ·
// area / r² inner vertices and a mean edge of edgePerRadius · r.
constexpr double verticesPerArea = 0.7;
constexpr double edgePerRadius = 1.3;

// Edges that are not split for the angle's sake, relative to the aimed spacing: the first that does it is
// taken.
constexpr std::array minEdges{1e-5, 1e-3, 0.03, 1.0};

double diagonalOf(const Outline& outline) {
    Vec2 low = outline.loops[0][0], high = low;
    for (const auto& loop : outline.loops)
        for (const auto& p : loop) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    return (high - low).norm();
}

/// Throws InputError for the first option that is out of its range.
void requireOptions(const PlanarMeshOptions& options) {
    if (!(options.edge >= 0) || std::isinf(options.edge))
        throw InputError("the edge length must be a positive number");
    if (options.edge == 0 && (options.vertices < 3 || options.vertices > mostVertices))
        throw InputError("the number of vertices must be 3 … " + std::to_string(mostVertices));
    if (!(options.minAngle >= 0 && options.minAngle <= 30))
        throw InputError("the minimum angle must be 0 … 30 degrees");
    if (!(options.simplify >= 0) || std::isinf(options.simplify))
        throw InputError("the simplification must not be negative");
    for (std::size_t i = 0; i < options.points.size(); ++i)
        if (!options.points[i].allFinite()) throw InputError("point " + std::to_string(i) + " is not finite");
}

/// Meshes one domain and keeps the data shared by its attempts.
class PlanarMesher {
  public:
    PlanarMesher(const PlanarDomain& domain, const PlanarMeshOptions& options)
        : m_domain(domain), m_options(options), m_area(domain.area()) {}

    SimplicialMesh<2> byEdge();
    SimplicialMesh<2> byCount();

  private:
    std::optional<SimplicialMesh<2>> attempt(double radius, int maxVertices) const;
    /// Returns the mesh in which only angles and the outline require vertices, with the smallest `shortest`
    /// edge that keeps its size reasonable.
    SimplicialMesh<2> coarsest();
    SimplicialMesh<2> searched(double radius);
    bool accepts(int count, int tries) const;

    const PlanarDomain& m_domain;
    const PlanarMeshOptions& m_options;
    double m_area;
    double m_shortest = 0;
};

std::optional<SimplicialMesh<2>> PlanarMesher::attempt(double radius, int maxVertices) const {
    return m_domain.refined({radius, m_options.minAngle, m_shortest, maxVertices}, m_options.stop);
}

SimplicialMesh<2> PlanarMesher::coarsest() {
    const int enough = std::max(m_options.vertices, 8 * m_domain.vertexCount() + 2000);
    const double spacing = m_shortest / minEdges[0];
    for (const double part : minEdges) {
        m_shortest = part * spacing;
        if (auto mesh = attempt(std::numeric_limits<double>::infinity(), enough)) return *std::move(mesh);
    }
    m_shortest = spacing;
    return m_domain.unrefined();
}

/// Meshes for an edge length, which a circumradius determines.
SimplicialMesh<2> PlanarMesher::byEdge() {
    const double radius = m_options.edge / edgePerRadius;
    const double expected = verticesPerArea * m_area / (radius * radius) + m_domain.perimeter() / radius;
    if (!(expected < mostVertices))
        throw InputError({sentence("Core", "an edge length of %1 would take more than %2 vertices"),
                          std::to_string(m_options.edge), std::to_string(mostVertices)});
    const int enough = static_cast<int>(2 * expected) + 20 * m_domain.vertexCount() + 5000;
    for (const double part : minEdges) {
        m_shortest = part * radius;
        if (auto mesh = attempt(radius, enough)) return *std::move(mesh);
    }
    return m_domain.unrefined();
}

/// Accepts a count within 10 %, and a closer one in the first attempts: the count is not a continuous
/// function of the radius.
bool PlanarMesher::accepts(int count, int tries) const {
    return std::abs(count - m_options.vertices) <= (tries < 3 ? 0.05 : 0.09) * m_options.vertices;
}

/// Meshes for a number of vertices: estimates the circumradius, and corrects it by the results. The estimate
/// solves aim = n₀ + k a / r² + p / 2r for r, with the outline's own n₀ vertices, the area a and perimeter p
/// in local target lengths, and the measured k.
SimplicialMesh<2> PlanarMesher::byCount() {
    const double aim = m_options.vertices;
    // aim = n₀ + k a / r² + p / 2r, the boundary's own share included
    const double inner = std::max(aim - m_domain.vertexCount(), 0.3 * aim);
    const double boundary = m_domain.perimeter() / 4;
    const double radius =
        (boundary + std::sqrt(boundary * boundary + inner * verticesPerArea * m_area)) / inner;
    m_shortest = minEdges[0] * radius;
    return searched(radius);
}

/// Models counts by n(r) = n(∞) + c / r² with c from the last attempt. After too many vertices the radius is
/// recomputed with n(∞), once that is known, and then the smallest edge is increased: close parallel
/// boundaries violate the model.
SimplicialMesh<2> PlanarMesher::searched(double radius) {
    const int aim = m_options.vertices, enough = 2 * aim + 100;
    std::optional<SimplicialMesh<2>> best, atInfinity;
    double base = std::min(m_domain.vertexCount(), aim / 2);
    for (int tries = 1; tries <= 8; ++tries) {
        auto mesh = attempt(radius, enough);
        const int count = mesh ? mesh->vertexCount() : enough;
        if (mesh && accepts(count, tries)) return *std::move(mesh);
        if (count > 1.2 * aim && !atInfinity) {
            atInfinity = coarsest();
            base = atInfinity->vertexCount();
            if (base >= 0.95 * aim) return *std::move(atInfinity);
            if (!mesh) radius = std::max(radius, std::sqrt(verticesPerArea * m_area / (aim - base)));
        } else if (!mesh) {
            m_shortest = std::min(30 * m_shortest, radius);
            radius *= 1.2;
        }
        if (!mesh) continue;
        if (!best || std::abs(count - aim) < std::abs(best->vertexCount() - aim)) best = std::move(mesh);
        const double growth = (aim - base) / std::max(count - base, 0.1 * (aim - base));
        radius /= std::sqrt(std::clamp(growth, 0.1, 10.0));
    }
    return best ? *std::move(best) : *std::move(atInfinity);
}

SimplicialMesh<2> meshExactly(Outline outline, const PlanarMeshOptions& options) {
    const double tolerance = pointTolerance * diagonalOf(outline);
    outline = outlineThrough(std::move(outline), options.points, tolerance);
    requireNoCrossing(outline);
    const PlanarDomain domain(outline, options.points, options.factor);
    PlanarMesher mesher(domain, options);
    return options.edge > 0 ? mesher.byEdge() : mesher.byCount();
}

/// Returns nothing if simplification removes what the options need: a part that contains a point. A failure
/// is no error, because the exact outline has been meshed already.
std::optional<SimplicialMesh<2>> meshSimplified(const Outline& outline, double tolerance,
                                                const PlanarMeshOptions& options) {
    try {
        return meshExactly(cleanedOutline(simplified(outline, tolerance)), options);
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

SimplicialMesh<2> meshOutline(const Outline& outline, const PlanarMeshOptions& options) {
    requireOptions(options);
    const Outline clean = cleanedOutline(outline);
    auto mesh = meshExactly(clean, options);
    const bool mayBeCoarser = options.edge <= 0 && options.simplify > 0;
    for (double part = 0.125; mayBeCoarser && part <= 1 && mesh.vertexCount() > 1.1 * options.vertices;
         part *= 2) {
        auto coarser = meshSimplified(clean, part * options.simplify, options);
        if (coarser && coarser->vertexCount() < mesh.vertexCount()) mesh = *std::move(coarser);
    }
    sortSpatially(mesh, static_cast<int>(options.points.size()));
    return mesh;
}

}  // namespace wend
