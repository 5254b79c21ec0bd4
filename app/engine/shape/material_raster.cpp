#include "app/engine/shape/material_raster.h"

#include <algorithm>
#include <ranges>

#include "app/engine/shape/material_picture.h"
#include "app/project/edits/material_edits.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/mesh/decompositions.h"
#include "core/mesh/triangle_tree.h"
#include "core/motion/guide_surface.h"

namespace wend {
namespace {

template <int Dim>
Vec<Dim> centroid(const SimplicialMesh<Dim>& mesh, int cell) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int vertex : mesh.cells[cell]) sum += mesh.points.col(vertex);
    return sum / (Dim + 1);
}

void requireCount(const char* key, std::size_t count, int cells) {
    if (count == 0 || count == static_cast<std::size_t>(cells)) return;
    throw InputError(std::string("material.cells.") + key + ": has " + std::to_string(count) +
                     " entries, but the mesh has " + std::to_string(cells) + " cells");
}

/// Returns the spec with its values per cell, read from the file that it names if there is one.
MaterialSpec withCells(MaterialSpec spec, const std::string& folder, int cells, int dimension) {
    const bool fromFile = !spec.cellsFile.empty() && spec.cellPhi.empty() && spec.cellB.empty();
    const std::string path = fromFile ? pathIn(folder, spec.cellsFile) : std::string();
    if (fromFile) readCells(path, spec, dimension);
    try {
        requireCount("phi", spec.cellPhi.size(), cells);
        requireCount("B", spec.cellB.size(), cells);
    } catch (const InputError& error) {
        throw error.named(path);
    }
    return spec;
}

/// The points at which cell values are taken. Neighbours in the list are mostly neighbours in the shape, so a
/// bounding box around every few of them speeds up queries.
template <int Dim>
class Centres {
  public:
    explicit Centres(const SimplicialMesh<Dim>& rest) : m_at(Dim, rest.cellCount()), m_parts(rest.parts) {
        for (int c = 0; c < rest.cellCount(); ++c) m_at.col(c) = centroid(rest, c);
        for (int first = 0; first < rest.cellCount(); first += kBlock) {
            const auto block = m_at.middleCols(first, std::min<Eigen::Index>(kBlock, m_at.cols() - first));
            m_boxes.push_back({block.rowwise().minCoeff(), block.rowwise().maxCoeff()});
        }
    }
    /// Calls `take` for the cells that a region and its soft edge reach, with their degree of membership.
    template <class Take>
    void forCellsIn(const MaterialRegion& region, const Take& take) const {
        const auto [begin, end] = cellsOf(region.part);
        const Region<Dim> shape = regionIn<Dim>(region.shape);
        for (std::size_t b = 0; b < m_boxes.size(); ++b) {
            const int first = static_cast<int>(b) * kBlock;
            if (first >= end || first + kBlock <= begin || endsBefore(shape, region.feather, m_boxes[b]))
                continue;
            for (int c = std::max(first, begin); c < std::min(first + kBlock, end); ++c) {
                const double m = membership<Dim>(shape, m_at.col(c), region.feather);
                if (m > 0) take(c, m);
            }
        }
    }

  private:
    static constexpr int kBlock = 16;

    /// Returns the range of a part's cells; of all if no part is named.
    std::pair<int, int> cellsOf(const std::string& name) const {
        if (name.empty()) return {0, static_cast<int>(m_at.cols())};
        const auto part = std::ranges::find(m_parts, name, &MeshPart::name);
        return part == m_parts.end() ? std::pair(0, 0) : std::pair(part->firstCell, part->endCell);
    }

    static bool endsBefore(const Region<Dim>& shape, double feather, const Box<Dim>& box) {
        const auto* ball = std::get_if<Ball<Dim>>(&shape);
        if (!ball) return false;
        const double reach = (1 + 1e-9) * (ball->radius + feather / 2);  // membership() rounds
        return (ball->centre - ball->centre.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm() >
               reach * reach;
    }

    Points<Dim> m_at;
    std::vector<MeshPart> m_parts;
    std::vector<Box<Dim>> m_boxes;
};

/// The normals of a wall, and distances from it.
template <int Dim>
class WallNormals {
  public:
    explicit WallNormals(const GuideMesh<3>& wall) : m_surface(guideIn<Dim>(wall)), m_points(wall.points) {
        m_facets = wall.triangles;
        for (const auto& [a, b] : wall.segments) m_facets.push_back({a, b, b});
        m_tree = TriangleTree(m_points, m_facets);
    }
    Vec<Dim> normal(const Vec<Dim>& p) const {
        return m_surface.contact(Dim == 2 ? Track::Line : Track::Face, p).normals.col(0);
    }
    double distance(const Vec<Dim>& p) const {
        Vec3 at = Vec3::Zero();
        at.head<Dim>() = p;
        const TriangleTree::Nearest nearest = m_tree.nearest(at);
        for (int k = 0; k < 3; ++k)
            at -= nearest.weights[k] *
                  m_points.col(
                      m_facets[static_cast<std::size_t>(nearest.triangle)][static_cast<std::size_t>(k)]);
        return at.norm();
    }

  private:
    const GuideSurface<Dim> m_surface;
    Points3 m_points;
    std::vector<std::array<int, 3>> m_facets;  // a segment is a triangle of no area
    TriangleTree m_tree;
};

/// Lays layers upon a material.
template <int Dim>
class LayerRaster {
  public:
    LayerRaster(const SimplicialMesh<Dim>& rest, const std::string& folder, Material<Dim>& material)
        : m_rest(rest), m_folder(folder), m_centres(rest), m_material(material) {}

    void lay(const MaterialLayer& layer, bool covers) {
        m_cover.clear();
        if (covers) m_below = m_material, m_cover.assign(m_rest.cells.size(), 0);
        for (const MaterialRegion& region : layer.regions) {
            if (region.hidden) continue;
            region.erases() ? erase(region) : layRegion(region);
        }
    }
    /// Returns how much the last layer covers each cell, if requested.
    const std::vector<double>& cover() const { return m_cover; }

  private:
    void layRegion(const MaterialRegion& region) {
        if (!m_cover.empty())
            m_centres.forCellsIn(region, [&](int c, double m) { m_cover[c] += m * (1 - m_cover[c]); });
        if constexpr (Dim == 2)
            if (region.pictures.any()) return layPictures(region, m_rest, m_folder, m_material);
        if (region.phi)
            m_centres.forCellsIn(
                region, [&](int c, double m) { m_material.phi[c] += m * (*region.phi - m_material.phi[c]); });
        if (!region.stiffness) return;
        if (m_material.anisotropy.empty())
            m_material.anisotropy.assign(m_rest.cells.size(), Mat<Dim>::Identity());
        if (region.stiffness->facets) return layAlongWall(region, *region.stiffness);
        const Mat<Dim> B = anisotropyOf<Dim>(*region.stiffness);
        m_centres.forCellsIn(region, [&](int c, double m) {
            m_material.anisotropy[c] = (1 - m) * m_material.anisotropy[c] + m * B;
        });
    }
    /// Aligns the axis of every cell near the wall with the normal at the wall's nearest point.
    void layAlongWall(const MaterialRegion& region, Stiffness stiffness) {
        const WallNormals<Dim> wall(*stiffness.facets);
        m_centres.forCellsIn(region, [&](int c, double m) {
            const Vec<Dim> centre = centroid(m_rest, c);
            if (wall.distance(centre) > stiffness.within) return;
            stiffness.axis = inSpace(wall.normal(centre));
            m_material.anisotropy[c] = (1 - m) * m_material.anisotropy[c] + m * anisotropyOf<Dim>(stiffness);
        });
    }
    /// Reduces the layer's cover to what is left, and the material's difference from the layer below
    /// accordingly.
    void erase(const MaterialRegion& region) {
        m_centres.forCellsIn(region, [&](int c, double m) {
            const double before = m_cover[c];
            m_cover[c] = (1 - m) * before + m * std::min(before, region.leaves);
            if (m_cover[c] == before) return;
            const double kept = m_cover[c] / before;
            m_material.phi[c] = kept * m_material.phi[c] + (1 - kept) * m_below.phi[c];
            if (m_material.anisotropy.empty()) return;
            const Mat<Dim> B =
                m_below.anisotropy.empty() ? Mat<Dim>::Identity().eval() : m_below.anisotropy[c];
            m_material.anisotropy[c] = kept * m_material.anisotropy[c] + (1 - kept) * B;
        });
    }

    const SimplicialMesh<Dim>& m_rest;
    const std::string& m_folder;
    Centres<Dim> m_centres;
    Material<Dim>& m_material;
    Material<Dim> m_below;
    std::vector<double> m_cover;
};

}  // namespace

/// Returns B₀ = I + (s − 1) a aᵀ (docs/method.md, (6)).
template <int Dim>
Mat<Dim> anisotropyOf(const Stiffness& stiffness) {
    const Vec<Dim> a = stiffness.axis.template head<Dim>().stableNormalized();
    return Mat<Dim>::Identity() + (stiffness.ratio - 1) * a * a.transpose();
}

template <int Dim>
Stiffness stiffnessOf(const Mat<Dim>& B) {
    const auto [axes, values] = principalAxes<Dim>(B);
    return {inSpace(Vec<Dim>(axes.col(Dim - 1))), values[Dim - 1] / values[0]};
}

template <int Dim>
void layLayers(std::span<const MaterialLayer> layers, const SimplicialMesh<Dim>& rest,
               const std::string& folder, Material<Dim>& material) {
    LayerRaster<Dim> raster(rest, folder, material);
    for (const MaterialLayer& layer : layers) raster.lay(layer, layer.erases());
}

template <int Dim>
std::vector<double> coverOf(const MaterialLayer& layer, const SimplicialMesh<Dim>& rest,
                            const std::string& folder) {
    auto material = Material<Dim>::uniform(rest.cellCount(), phi::kMetr);
    LayerRaster<Dim> raster(rest, folder, material);
    raster.lay(layer, true);
    return raster.cover();
}

template <int Dim>
std::shared_ptr<const Material<Dim>> rasterizeMaterial(const MaterialSpec& given,
                                                       const SimplicialMesh<Dim>& rest,
                                                       const std::string& folder) {
    const MaterialSpec spec = withCells(given, folder, rest.cellCount(), Dim);
    auto material =
        std::make_shared<Material<Dim>>(Material<Dim>::uniform(rest.cellCount(), spec.phi, spec.smoothing));
    material->memory = spec.memory;
    if (!spec.cellPhi.empty()) material->phi = spec.cellPhi;
    for (const Mat3& B : spec.cellB) material->anisotropy.push_back(B.template topLeftCorner<Dim, Dim>());
    layLayers<Dim>(spec.layers, rest, folder, *material);
    return material;
}

#define WEND_INSTANTIATE(Dim)                                                                   \
    template Mat<Dim> anisotropyOf<Dim>(const Stiffness&);                                      \
    template Stiffness stiffnessOf<Dim>(const Mat<Dim>&);                                       \
    template void layLayers<Dim>(std::span<const MaterialLayer>, const SimplicialMesh<Dim>&,    \
                                 const std::string&, Material<Dim>&);                           \
    template std::vector<double> coverOf<Dim>(const MaterialLayer&, const SimplicialMesh<Dim>&, \
                                              const std::string&);                              \
    template std::shared_ptr<const Material<Dim>> rasterizeMaterial<Dim>(                       \
        const MaterialSpec&, const SimplicialMesh<Dim>&, const std::string&)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
