#include "app/session/shape_builder.h"

#include <algorithm>

#include "app/session/mesh_rest.h"
#include "app/session/solid.h"
#include "core/mesh/error.h"

namespace wend {

namespace {

template <int Dim>
const Design<Dim>& designOf(const ShapeInputs& inputs) {
    return std::get<Design<Dim>>(inputs.project->design);
}

bool sameAlpha(const AlphaOutlineOptions& a, const AlphaOutlineOptions& b) {
    return a.threshold == b.threshold && a.margin == b.margin && a.smallest == b.smallest &&
           a.simplify == b.simplify;
}

bool sameOutline(const Domain& a, const Domain& b) {
    return a.kind == b.kind && a.path == b.path && a.outline == b.outline && sameAlpha(a.alpha, b.alpha) &&
           a.polygons.loops == b.polygons.loops;
}

/// The points that become vertices of the mesh: those of handles that are there from the start.
std::vector<Vec<2>> startPoints(const ShapeInputs& inputs) {
    std::vector<Vec<2>> points;
    for (const Handle<2>& handle : designOf<2>(inputs).handles)
        if (const auto* own = std::get_if<std::vector<Vec<2>>>(&handle.at); own && handle.activeFrom <= 0)
            points.insert(points.end(), own->begin(), own->end());
    return points;
}

bool sameSmoothing(const Smoothing& a, const Smoothing& b) {
    return a.kind == b.kind && a.length == b.length && a.lambda == b.lambda;
}

template <int Dim>
bool sameStiffness(const std::optional<Stiffness<Dim>>& a, const std::optional<Stiffness<Dim>>& b) {
    return a.has_value() == b.has_value() && (!a || (a->axis == b->axis && a->ratio == b->ratio));
}

template <int Dim>
bool sameMaterial(const MaterialSpec<Dim>& a, const MaterialSpec<Dim>& b) {
    const auto same = [](const MaterialRegion<Dim>& p, const MaterialRegion<Dim>& q) {
        return p.feather == q.feather && p.phi == q.phi && sameStiffness<Dim>(p.stiffness, q.stiffness) &&
               p.shape == q.shape;
    };
    return a.phi == b.phi && sameSmoothing(a.smoothing, b.smoothing) && a.memory == b.memory &&
           a.cellsFile == b.cellsFile && a.cellPhi == b.cellPhi && a.cellB == b.cellB &&
           std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), same);
}

}  // namespace

template <int Dim>
bool ShapeBuilder<Dim>::meshIsCurrent(const ShapeInputs& inputs) const {
    if (!m_shape.rest || m_last.generation != inputs.generation) return false;
    const Domain &a = m_last.project->domain, &b = inputs.project->domain;
    if constexpr (Dim == 3) return sameSolid(a, b);
    return sameOutline(a, b) && a.texture == b.texture && a.vertices == b.vertices && a.edge == b.edge &&
           (b.kind != DomainKind::Image || startPoints(m_last) == startPoints(inputs));
}

template <int Dim>
bool ShapeBuilder<Dim>::materialIsCurrent(const ShapeInputs& inputs) const {
    return m_shape.material && m_last.generation == inputs.generation &&
           sameMaterial(designOf<Dim>(m_last).material, designOf<Dim>(inputs).material);
}

template <>
BuiltShape<3> ShapeBuilder<3>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    Solid solid = loadSolid(*inputs.project, inputs.folder, stop, Advice::None);
    BuiltShape<3> shape;
    shape.rest = std::move(solid.rest);
    if (!shape.rest) return shape;
    shape.facets = std::make_shared<const std::vector<Facet<3>>>(facetsOf(*shape.rest));
    shape.skin = std::move(solid.skin);
    shape.ride = std::move(solid.ride);
    shape.source = std::move(solid.source);
    shape.notices = std::move(solid.notices);
    shape.refineHelps = solid.refineHelps;
    return shape;
}

template <>
BuiltShape<2> ShapeBuilder<2>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    const Project& project = *inputs.project;
    BuiltShape<2> shape;
    if (project.domain.kind != DomainKind::Image) {
        const Scene<2> scene = std::get<Scene<2>>(loadScene(project, inputs.folder));
        shape.rest = scene.rest;
        shape.source = scene.source;
        shape.notices = scene.notices;
        if (scene.picture) shape.texture = std::make_shared<const Texture>(scene.texture);
        return shape;
    }
    if (!m_outline || m_outlineFrom.generation != inputs.generation ||
        !sameOutline(m_outlineFrom.project->domain, project.domain)) {
        m_outline.reset();
        m_outline = std::make_shared<const Outline>(domainOutline(project.domain, *inputs.picture));
        m_outlineFrom = inputs;
    }
    shape.rest = meshPicture(project, *m_outline, stop);
    tellOfHanging<2>(*shape.rest, shape.notices);
    return shape;
}

template <int Dim>
BuiltShape<Dim> ShapeBuilder<Dim>::build(const ShapeInputs& inputs, std::stop_token stop) try {
    BuiltShape<Dim> shape = meshIsCurrent(inputs) ? m_shape : makeMesh(inputs, stop);
    if (stop.stop_requested() || !shape.rest) return {};
    if (shape.rest != m_shape.rest || !materialIsCurrent(inputs))
        shape.material = rasterizeMaterial<Dim>(designOf<Dim>(inputs).material, *shape.rest, inputs.folder);
    m_shape = shape;
    m_last = inputs;
    return shape;
} catch (const Cancelled&) {
    return {};
}

template class ShapeBuilder<2>;
template class ShapeBuilder<3>;

}  // namespace wend
