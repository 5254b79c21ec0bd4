#include "app/session/shape_builder.h"

#include <algorithm>

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
    return a.phi == b.phi && sameSmoothing(a.smoothing, b.smoothing) && a.cellsFile == b.cellsFile &&
           a.cellPhi == b.cellPhi && a.cellB == b.cellB &&
           std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), same);
}

}  // namespace

template <int Dim>
bool ShapeBuilder<Dim>::meshIsCurrent(const ShapeInputs& inputs) const {
    if (!m_shape.rest || m_last.generation != inputs.generation) return false;
    const Domain &a = m_last.project->domain, &b = inputs.project->domain;
    if constexpr (Dim == 3) return sameSolid(a, b);
    return sameOutline(a, b) && a.vertices == b.vertices && a.edge == b.edge &&
           (b.kind != DomainKind::Image || startPoints(m_last) == startPoints(inputs));
}

template <int Dim>
bool ShapeBuilder<Dim>::materialIsCurrent(const ShapeInputs& inputs) const {
    return m_shape.material && m_last.generation == inputs.generation &&
           sameMaterial(designOf<Dim>(m_last).material, designOf<Dim>(inputs).material);
}

template <>
void ShapeBuilder<3>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    Solid solid = loadSolid(*inputs.project, inputs.folder, stop);
    m_shape.rest = std::move(solid.rest);
    m_shape.facets = std::make_shared<const std::vector<Facet<3>>>(facetsOf(*m_shape.rest));
    m_shape.skin = std::move(solid.skin);
    m_shape.ride = std::move(solid.ride);
    m_shape.notices = std::move(solid.notices);
}

template <>
void ShapeBuilder<2>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    const Project& project = *inputs.project;
    if (project.domain.kind != DomainKind::Image) {
        m_shape.rest = std::get<Scene<2>>(loadScene(project, inputs.folder)).rest;
        return;
    }
    if (!m_outline || m_outlineFrom.generation != inputs.generation ||
        !sameOutline(m_outlineFrom.project->domain, project.domain)) {
        m_outline.reset();
        m_outline = std::make_shared<const Outline>(domainOutline(project.domain, *inputs.picture));
        m_outlineFrom = inputs;
    }
    m_shape.rest = meshPicture(project, *m_outline, stop);
}

template <int Dim>
void ShapeBuilder<Dim>::makeShape(const ShapeInputs& inputs, std::stop_token stop) {
    if (!meshIsCurrent(inputs)) {
        m_shape = {};
        makeMesh(inputs, stop);
    }
    if (stop.stop_requested() || !m_shape.rest) {
        m_shape = {};
        return;
    }
    if (!materialIsCurrent(inputs))
        m_shape.material =
            rasterizeMaterial<Dim>(designOf<Dim>(inputs).material, *m_shape.rest, inputs.folder);
    m_last = inputs;
}

template <int Dim>
BuiltShape<Dim> ShapeBuilder<Dim>::build(const ShapeInputs& inputs, std::stop_token stop) {
    try {
        makeShape(inputs, stop);
    } catch (const Cancelled&) {
        m_shape = {};
    } catch (...) {
        m_shape = {};
        throw;
    }
    return m_shape;
}

template class ShapeBuilder<2>;
template class ShapeBuilder<3>;

}  // namespace wend
