#include "app/session/material_raster.h"

#include <Eigen/Eigenvalues>

#include "app/document/named_files.h"
#include "app/session/material_picture.h"
#include "core/mesh/error.h"

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

/// The values per cell, from the spec or the file that it names.
template <int Dim>
MaterialSpec<Dim> withCells(MaterialSpec<Dim> spec, const std::string& folder, int cells) {
    const bool fromFile = !spec.cellsFile.empty() && spec.cellPhi.empty() && spec.cellB.empty();
    const std::string path = fromFile ? pathIn(folder, spec.cellsFile) : std::string();
    if (fromFile) readCells<Dim>(path, spec);
    try {
        requireCount("phi", spec.cellPhi.size(), cells);
        requireCount("B", spec.cellB.size(), cells);
    } catch (const InputError& error) {
        throw error.named(path);
    }
    return spec;
}

/// True if a ball and its soft edge end before p: most cells, of most strokes.
template <int Dim>
bool endsBefore(const MaterialRegion<Dim>& region, const Vec<Dim>& p) {
    const auto* ball = std::get_if<Ball<Dim>>(&region.shape);
    if (!ball) return false;
    const double reach = (1 + 1e-9) * (ball->radius + region.feather / 2);  // membership() rounds
    return (p - ball->centre).squaredNorm() > reach * reach;
}

}  // namespace

/// B₀ = I + (s − 1) a aᵀ (docs/method.md, (6)).
template <int Dim>
Mat<Dim> anisotropyOf(const Stiffness<Dim>& stiffness) {
    const Vec<Dim> a = stiffness.axis.stableNormalized();
    return Mat<Dim>::Identity() + (stiffness.ratio - 1) * a * a.transpose();
}

template <int Dim>
Stiffness<Dim> stiffnessOf(const Mat<Dim>& B) {
    const Eigen::SelfAdjointEigenSolver<Mat<Dim>> axes(B);
    return {axes.eigenvectors().col(Dim - 1), axes.eigenvalues()[Dim - 1] / axes.eigenvalues()[0]};
}

template <int Dim>
void layRegion(const MaterialRegion<Dim>& region, const SimplicialMesh<Dim>& rest, Material<Dim>& material) {
    const Mat<Dim> B = region.stiffness ? anisotropyOf<Dim>(*region.stiffness) : Mat<Dim>::Identity().eval();
    if (region.stiffness && material.anisotropy.empty())
        material.anisotropy.assign(rest.cells.size(), Mat<Dim>::Identity());
    for (int c = 0; c < rest.cellCount(); ++c) {
        const Vec<Dim> centre = centroid(rest, c);
        if (endsBefore(region, centre)) continue;
        const double m = membership<Dim>(region.shape, centre, region.feather);
        if (region.phi) material.phi[c] += m * (*region.phi - material.phi[c]);
        if (region.stiffness) material.anisotropy[c] = (1 - m) * material.anisotropy[c] + m * B;
    }
}

template <int Dim>
std::shared_ptr<const Material<Dim>> rasterizeMaterial(const MaterialSpec<Dim>& given,
                                                       const SimplicialMesh<Dim>& rest,
                                                       const std::string& folder) {
    const MaterialSpec<Dim> spec = withCells(given, folder, rest.cellCount());
    auto material =
        std::make_shared<Material<Dim>>(Material<Dim>::uniform(rest.cellCount(), spec.phi, spec.smoothing));
    material->memory = spec.memory;
    if (!spec.cellPhi.empty()) material->phi = spec.cellPhi;
    material->anisotropy = spec.cellB;
    for (const auto& region : spec.regions) {
        if (region.hidden) continue;
        if constexpr (Dim == 2)
            if (region.pictures.any()) {
                layPictures(region, rest, folder, *material);
                continue;
            }
        layRegion(region, rest, *material);
    }
    return material;
}

#define WEND_INSTANTIATE(Dim)                                                                             \
    template Mat<Dim> anisotropyOf<Dim>(const Stiffness<Dim>&);                                           \
    template Stiffness<Dim> stiffnessOf<Dim>(const Mat<Dim>&);                                            \
    template void layRegion<Dim>(const MaterialRegion<Dim>&, const SimplicialMesh<Dim>&, Material<Dim>&); \
    template std::shared_ptr<const Material<Dim>> rasterizeMaterial<Dim>(                                 \
        const MaterialSpec<Dim>&, const SimplicialMesh<Dim>&, const std::string&)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
