#include "app/session/scene.h"
#include "core/mesh/error.h"

namespace wend {
namespace {

/// B₀ = I + (s − 1) a aᵀ (method.md, Field and energy).
template <int Dim>
Mat<Dim> stiff(const Stiffness<Dim>& stiffness) {
    const Vec<Dim> a = stiffness.axis.stableNormalized();
    return Mat<Dim>::Identity() + (stiffness.ratio - 1) * a * a.transpose();
}

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

template <int Dim>
void layRegion(const MaterialRegion<Dim>& region, const SimplicialMesh<Dim>& rest, Material<Dim>& material) {
    const Mat<Dim> B = region.stiffness ? stiff(*region.stiffness) : Mat<Dim>::Identity().eval();
    for (int c = 0; c < rest.cellCount(); ++c) {
        const double m = membership<Dim>(region.shape, centroid(rest, c), region.feather);
        if (region.phi) material.phi[c] += m * (*region.phi - material.phi[c]);
        if (region.stiffness) material.anisotropy[c] = (1 - m) * material.anisotropy[c] + m * B;
    }
}

}  // namespace

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
    for (const auto& region : spec.regions)
        if (region.stiffness && material->anisotropy.empty())
            material->anisotropy.assign(rest.cells.size(), Mat<Dim>::Identity());
    for (const auto& region : spec.regions) layRegion(region, rest, *material);
    return material;
}

template std::shared_ptr<const Material<2>> rasterizeMaterial<2>(const MaterialSpec<2>&,
                                                                 const SimplicialMesh<2>&,
                                                                 const std::string&);
template std::shared_ptr<const Material<3>> rasterizeMaterial<3>(const MaterialSpec<3>&,
                                                                 const SimplicialMesh<3>&,
                                                                 const std::string&);

}  // namespace wend
