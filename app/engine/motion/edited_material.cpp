#include "app/engine/motion/edited_material.h"

#include <algorithm>
#include <cmath>

#include "app/engine/shape/material_raster.h"
#include "app/engine/shape/mesh_parts.h"
#include "app/project/edits/layer_edits.h"

namespace wend {

namespace {

constexpr double kSameMaterial = 1e-9;  // relative to the material
constexpr double kUnseen = 0.02;        // of a layer's cover

bool isWhollyHidden(const MaterialLayer& layer) {
    return std::ranges::all_of(layer.regions, &MaterialRegion::hidden);
}

template <int Dim>
double distanceOf(const Region<3>& region, const Vec3& p) {
    return signedDistance<Dim>(regionIn<Dim>(region), p.template head<Dim>());
}

/// Returns whether an eraser may overlap a region, including both soft edges.
template <int Dim>
bool mayTouch(const Eraser& eraser, const MaterialRegion& region) {
    if (!eraser.part.empty() && !region.part.empty() && eraser.part != region.part) return false;
    const double soft = (eraser.feather + region.feather) / 2;
    if (const auto* ball = std::get_if<Ball<3>>(&eraser.shape))
        return distanceOf<Dim>(region.shape, ball->centre) <= ball->radius + soft;
    if (const auto* ball = std::get_if<Ball<3>>(&region.shape))
        return distanceOf<Dim>(eraser.shape, ball->centre) <= ball->radius + soft;
    return true;
}

/// Returns whether nothing is left of the region, on any mesh.
template <int Dim>
bool erasesAll(const Eraser& eraser, const MaterialRegion& region) {
    const auto* ball = std::get_if<Ball<3>>(&region.shape);
    if (!ball || eraser.amount < 1 || (!eraser.part.empty() && eraser.part != region.part)) return false;
    const double reach = ball->radius + (region.feather + eraser.feather) / 2;
    return distanceOf<Dim>(eraser.shape, ball->centre) + reach <= 0;
}

/// Returns the regions of a layer with erasers on top, without erasers that miss it and without fully erased
/// regions.
template <int Dim>
std::vector<MaterialRegion> erased(const MaterialLayer& layer, std::span<const Eraser> erasers,
                                   const SimplicialMesh<Dim>& rest, const std::string& folder) {
    std::vector<MaterialRegion> left;
    for (const MaterialRegion& region : layer.regions)
        if (std::ranges::none_of(erasers, [&](const auto& one) { return erasesAll<Dim>(one, region); }))
            left.push_back(region);
    const std::vector<MaterialRegion> painted = left;
    std::vector<double> cover;
    for (const Eraser& one : erasers) {
        const auto isUnder = [&](const auto& region) {
            return !region.erases() && mayTouch<Dim>(one, region);
        };
        if (std::ranges::none_of(painted, isUnder)) continue;
        if (one.amount < 1 && cover.empty()) cover = coverOf<Dim>(layer, rest, folder);
        MaterialRegion region{{one.shape, one.feather, one.part}};
        region.leaves = one.amount < 1 ? (1 - one.amount) * cover[one.cell] : 0;
        left.push_back(std::move(region));
    }
    if (std::ranges::all_of(left, &MaterialRegion::erases)) left.clear();
    return left;
}

template <int Dim>
Design withErased(const Design& design, std::span<const Eraser> erasers, const SimplicialMesh<Dim>& rest,
                  const std::string& folder) {
    Design next = design;
    for (MaterialLayer& layer : next.material.layers)
        if (!isWhollyHidden(layer)) layer.regions = erased<Dim>(layer, erasers, rest, folder);
    std::erase_if(next.material.layers, [](const MaterialLayer& layer) { return layer.regions.empty(); });
    keepApart(next.material.layers);
    return next;
}

template <int Dim>
Design withoutErasedLayers(const Design& design, const SimplicialMesh<Dim>& rest, const std::string& folder) {
    Design next = design;
    std::erase_if(next.material.layers, [&](const MaterialLayer& layer) {
        return layer.erases() && !isWhollyHidden(layer) &&
               std::ranges::max(coverOf<Dim>(layer, rest, folder)) < kUnseen;
    });
    keepApart(next.material.layers);
    return next;
}

template <int Dim>
Mat<Dim> anisotropyAt(const Material<Dim>& material, int cell) {
    return material.anisotropy.empty() ? Mat<Dim>(Mat<Dim>::Identity()) : material.anisotropy[cell];
}

template <int Dim>
class EditedMaterialOf : public EditedMaterial {
  public:
    EditedMaterialOf(PosedPtr<Dim> frame, std::string folder)
        : m_frame(std::move(frame)), m_folder(std::move(folder)) {}

    double phiOf(int cell) const override { return m_frame->material->phi[cell]; }
    std::optional<Stiffness> stiffnessOf(int cell) const override {
        if (m_frame->material->anisotropy.empty()) return {};
        return wend::stiffnessOf<Dim>(at(cell));
    }
    Stiffness blended(int cell, double amount, const Stiffness& aim) const override {
        return wend::stiffnessOf<Dim>((1 - amount) * at(cell) + amount * anisotropyOf<Dim>(aim));
    }
    Stiffness smoothed(int cell, double amount, const std::vector<int>& others) const override {
        Mat<Dim> mean = Mat<Dim>::Zero();
        for (const int c : others) mean += at(c) / static_cast<double>(others.size());
        return wend::stiffnessOf<Dim>((1 - amount) * at(cell) + amount * mean);
    }
    std::vector<int> cellsIn(const Ball<3>& ball) const override {
        std::vector<int> cells;
        for (int c = 0; c < rest().cellCount(); ++c) {
            Vec<Dim> centroid = Vec<Dim>::Zero();
            for (const int v : rest().cells[c]) centroid += rest().points.col(v) / (Dim + 1);
            if ((centroid - ball.centre.head<Dim>()).norm() <= ball.radius) cells.push_back(c);
        }
        return cells;
    }
    Region<3> around(int cell) const override {
        return inSpace(regionAround<Dim>(rest(), partOf<Dim>(rest(), cell)));
    }
    Region<3> whole() const override { return inSpace(regionOfAll<Dim>(rest())); }

    FramePtr with(const MaterialSpec& spec, std::size_t first) override {
        if (!m_below) {
            MaterialSpec below = spec;
            below.layers.resize(first);
            m_below = rasterizeMaterial<Dim>(below, rest(), m_folder);
        }
        auto material = std::make_shared<Material<Dim>>(*m_below);
        layLayers<Dim>(std::span(spec.layers).subspan(first), rest(), m_folder, *material);
        auto frame = std::make_shared<PosedFrame<Dim>>(*m_frame);
        frame->material = material;
        return frame;
    }
    /// Treats a missing stiffness as stiffness ×1.
    bool equals(const ShapeFrame& other) const override {
        const Material<Dim>& a = *m_frame->material;
        const Material<Dim>& b = *static_cast<const PosedFrame<Dim>&>(other).material;
        for (std::size_t c = 0; c < a.phi.size(); ++c) {
            const int cell = static_cast<int>(c);
            if (std::abs(a.phi[c] - b.phi[c]) > kSameMaterial) return false;
            if ((anisotropyAt(a, cell) - anisotropyAt(b, cell)).norm() > kSameMaterial) return false;
        }
        return true;
    }
    Design erased(const Design& design, std::span<const Eraser> erasers) const override {
        return withErased<Dim>(design, erasers, rest(), m_folder);
    }
    Design withoutErasedLayers(const Design& design) const override {
        return wend::withoutErasedLayers<Dim>(design, rest(), m_folder);
    }

  private:
    const SimplicialMesh<Dim>& rest() const { return *m_frame->rest; }
    Mat<Dim> at(int cell) const { return anisotropyAt(*m_frame->material, cell); }

    PosedPtr<Dim> m_frame;
    std::string m_folder;
    std::shared_ptr<const Material<Dim>> m_below;  // without the regions that change
};

}  // namespace

std::unique_ptr<EditedMaterial> EditedMaterial::of(const FramePtr& frame, const std::string& folder) {
    if (frame->dimension == 2) return std::make_unique<EditedMaterialOf<2>>(posed<2>(frame), folder);
    return std::make_unique<EditedMaterialOf<3>>(posed<3>(frame), folder);
}

}  // namespace wend
