#include "app/engine/shape/shape_builder.h"

#include <algorithm>

#include "app/engine/shape/flat_shape.h"
#include "app/engine/shape/material_raster.h"
#include "app/engine/shape/mesh_rest.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/project/options/settings.h"
#include "core/base/error.h"

namespace wend {

namespace {

/// Returns whether parts are the same; locks change nothing that is made of them.
bool sameParts(const std::vector<PicturePart>& a, const std::vector<PicturePart>& b) {
    return std::ranges::equal(a, b, [](PicturePart p, const PicturePart& q) {
        p.locked = q.locked;
        return p == q;
    });
}

constexpr std::size_t kKept = 2;

const Design& designOf(const ShapeInputs& inputs) {
    return wend::designOf(*inputs.project);
}

bool sameOutline(const Project& a, const Project& b) {
    const Domain &p = domainOf(a), &q = domainOf(b);
    return p.kind == q.kind && p.path == q.path && p.readings == q.readings &&
           sameSettings(a, b, Makes::Outline) && p.polygons.loops == q.polygons.loops &&
           sameParts(p.parts, q.parts);
}

/// Returns the points that become vertices of the mesh, those of handles that hold from the start, with the
/// names of their parts.
std::vector<std::pair<std::string, Vec2>> startPoints(const ShapeInputs& inputs) {
    std::vector<std::pair<std::string, Vec2>> points;
    for (const Pin& handle : designOf(inputs).handles)
        if (const auto* own = std::get_if<std::vector<Vec3>>(&handle.at); own && handle.activeFrom <= 0)
            for (const Vec3& p : *own) points.emplace_back(handle.part, inPlane(p));
    return points;
}

bool sameStiffness(const std::optional<Stiffness>& a, const std::optional<Stiffness>& b) {
    return a.has_value() == b.has_value() &&
           (!a || (a->axis == b->axis && a->ratio == b->ratio && a->wall == b->wall &&
                   a->within == b->within && a->facets == b->facets));
}

bool sameRegionsAndCells(const MaterialSpec& a, const MaterialSpec& b) {
    const auto sameRegion = [](const MaterialRegion& p, const MaterialRegion& q) {
        return p.feather == q.feather && p.phi == q.phi && sameStiffness(p.stiffness, q.stiffness) &&
               p.shape == q.shape && p.pictures == q.pictures && p.hidden == q.hidden &&
               p.leaves == q.leaves && p.part == q.part;
    };
    const auto sameLayer = [&](const MaterialLayer& p, const MaterialLayer& q) {
        return std::ranges::equal(p.regions, q.regions, sameRegion);
    };
    return a.cellsFile == b.cellsFile && a.cellsPhi == b.cellsPhi && a.cellsB == b.cellsB &&
           a.cellPhi == b.cellPhi && a.cellB == b.cellB && std::ranges::equal(a.layers, b.layers, sameLayer);
}

}  // namespace

bool sameSolid(const Project& a, const Project& b) {
    const Domain &p = domainOf(a), &q = domainOf(b);
    return p.kind == q.kind && p.path == q.path && sameSettings(a, b, Makes::Mesh) && p.fixes == q.fixes &&
           p.sizesFile == q.sizesFile && p.sizes == q.sizes && p.detail == q.detail;
}

int ShapeInputs::dimension() const {
    return dimensionOf(*project);
}

bool sameMesh(const ShapeInputs& a, const ShapeInputs& b) {
    if (a.generation != b.generation || a.dimension() != b.dimension()) return false;
    if (b.dimension() == 3) return sameSolid(*a.project, *b.project);
    const Domain &p = domainOf(*a.project), &q = domainOf(*b.project);
    return sameOutline(*a.project, *b.project) && sameSettings(*a.project, *b.project, Makes::Mesh) &&
           p.texture == q.texture && p.sizes == q.sizes &&
           (q.kind != DomainKind::Image || startPoints(a) == startPoints(b));
}

template <int Dim>
bool ShapeBuilder<Dim>::hasMesh(const Made& made, const ShapeInputs& inputs) {
    return sameMesh(made.inputs, inputs);
}

template <int Dim>
bool ShapeBuilder<Dim>::hasMaterial(const Made& made, const ShapeInputs& inputs) {
    return sameSettings(*made.inputs.project, *inputs.project, Makes::Material) &&
           sameRegionsAndCells(designOf(made.inputs).material, designOf(inputs).material);
}

/// Caches the outline, which most changes do not affect.
template <int Dim>
std::shared_ptr<const SimplicialMesh<2>> ShapeBuilder<Dim>::meshOutline(const ShapeInputs& inputs,
                                                                        const Image& picture,
                                                                        std::stop_token stop) try {
    const Domain& domain = domainOf(*inputs.project);
    if (!m_outline || m_outlineFrom.generation != inputs.generation ||
        !sameOutline(*m_outlineFrom.project, *inputs.project)) {
        m_outline.reset();
        m_outline = std::make_shared<const Outline>(domainOutline(domain, picture));
        m_outlineFrom = inputs;
    }
    return meshPicture(domain, designOf(inputs), *m_outline, stop);
} catch (const InputError& error) {
    if (m_advice == Advice::None) throw;
    // Polygons are part of the project; the caller names its file.
    if (domainOf(*inputs.project).outline == OutlineKind::Polygons)
        throw InputError("domain.outline.polygons: " + error.message());
    throw error.named(pathIn(inputs.folder, domainOf(*inputs.project).path));
}

template <>
Shape<3> ShapeBuilder<3>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    Shape<3> shape = loadSolid(domainOf(*inputs.project), designOf(inputs), inputs.folder, stop, m_advice);
    shape.facets = std::make_shared<const std::vector<Facet<3>>>(facetsOf(*shape.rest));
    return shape;
}

template <>
Shape<2> ShapeBuilder<2>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    const Domain& domain = domainOf(*inputs.project);
    Shape<2> shape;
    if (!domain.parts.empty()) {
        if (m_made.empty() || domainOf(*m_made.front().inputs.project).readings != domain.readings)
            m_parted = {};
        shape = loadPartedShape(domain, designOf(inputs), inputs.folder, m_parted, stop);
        if (!shape.rest) return shape;
    } else if (domain.kind == DomainKind::Image) {
        shape.picture = inputs.picture ? inputs.picture : loadPicture(domain, inputs.folder, &shape.notices);
        shape.rest = meshOutline(inputs, *shape.picture, stop);
        tellOfAim(domain, *shape.rest, shape.notices);
    } else {
        shape = loadFlatMesh(domain, inputs.folder);
    }
    tellOfHanging<2>(*shape.rest, shape.notices);
    return shape;
}

template <int Dim>
Shape<Dim> ShapeBuilder<Dim>::build(const ShapeInputs& inputs, std::stop_token stop) try {
    std::erase_if(m_made, [&](const Made& made) { return made.inputs.generation != inputs.generation; });
    const auto known = std::ranges::find_if(m_made, [&](const Made& made) { return hasMesh(made, inputs); });
    const bool isKnown = known != m_made.end();
    Made now{inputs, isKnown ? known->shape : makeMesh(inputs, stop)};
    if (stop.stop_requested() || !now.shape.rest) return {};
    if (!isKnown || !hasMaterial(*known, inputs))
        now.shape.material =
            rasterizeMaterial<Dim>(designOf(inputs).material, *now.shape.rest, inputs.folder);
    if (isKnown) m_made.erase(known);
    m_made.insert(m_made.begin(), now);
    m_made.resize(std::min(m_made.size(), kKept));
    return now.shape;
} catch (const Cancelled&) {
    return {};
}

AnyShape loadShape(const Project& project, const std::string& folder, std::stop_token stop) {
    const auto load = [&]<int Dim>(ShapeBuilder<Dim> builder) -> AnyShape {
        ShapeInputs inputs;
        inputs.project = copyOf(project);
        inputs.folder = folder;
        Shape<Dim> shape = builder.build(inputs, stop);
        if (!shape.rest) throw Cancelled();
        return shape;
    };
    return dimensionOf(project) == 3 ? load(ShapeBuilder<3>(Advice::Keys))
                                     : load(ShapeBuilder<2>(Advice::Keys));
}

template class ShapeBuilder<2>;
template class ShapeBuilder<3>;

}  // namespace wend
