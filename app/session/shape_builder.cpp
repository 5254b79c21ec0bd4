#include "app/session/shape_builder.h"

#include <algorithm>

#include "app/document/handle_edits.h"
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

/// The points that become vertices of a picture's mesh: those of handles that are there from the start.
std::vector<Vec<2>> startPoints(const ShapeInputs& inputs) {
    std::vector<Vec<2>> points;
    if (inputs.project->domain.kind != DomainKind::Image) return points;
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
               sameRegion<Dim>(p.shape, q.shape);
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
    return sameOutline(a, b) && a.vertices == b.vertices && a.edge == b.edge && a.quality == b.quality &&
           a.maxVolume == b.maxVolume && startPoints(m_last) == startPoints(inputs);
}

template <int Dim>
bool ShapeBuilder<Dim>::materialIsCurrent(const ShapeInputs& inputs) const {
    if (!m_shape.material || m_last.generation != inputs.generation) return false;
    const MaterialSpec<Dim>&a = designOf<Dim>(m_last).material, &b = designOf<Dim>(inputs).material;
    return sameMaterial(a, b);
}

template <int Dim>
void ShapeBuilder<Dim>::makeMesh(const ShapeInputs& inputs, std::stop_token stop) {
    const Project& project = *inputs.project;
    if constexpr (Dim == 2)
        if (project.domain.kind == DomainKind::Image) {
            makePictureMesh(inputs, stop);
            return;
        }
    const auto scene = std::get<Scene<Dim>>(loadScene(project, inputs.folder, stop));
    m_shape.rest = scene.rest;
    if constexpr (Dim == 3)
        m_shape.facets = std::make_shared<const std::vector<Facet<3>>>(facetsOf(*scene.rest));
}

template <int Dim>
void ShapeBuilder<Dim>::makePictureMesh(const ShapeInputs& inputs, std::stop_token stop) {
    const Project& project = *inputs.project;
    if (!m_outline || m_outlineFrom.generation != inputs.generation ||
        !sameOutline(m_outlineFrom.project->domain, project.domain)) {
        m_outline.reset();
        m_outline = std::make_shared<const Outline>(domainOutline(project.domain, *inputs.picture));
        m_outlineFrom = inputs;
    }
    if constexpr (Dim == 2) m_shape.rest = meshPicture(project, *m_outline, stop);
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
