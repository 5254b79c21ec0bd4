#include "app/engine/motion/velocity_probe.h"

#include <algorithm>

#include "app/engine/shape/held_border.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/project.h"
#include "kernels/back_end_choice.h"

namespace wend {

template <int Dim>
VelocityProbe<Dim>::VelocityProbe(const Shape<Dim>& shape, const Project& project)
    : m_deformer(shape.rest, shape.material, heldHandles<Dim>(project, shape), integrationOf(project),
                 backEndFactory<Dim>(BackEndKind::Automatic)) {}

template <int Dim>
Points<Dim> VelocityProbe<Dim>::at(double time, const Points<Dim>& pose) {
    State<Dim> state;
    state.time = time;
    state.points = pose;
    m_deformer.restore(state);
    return m_deformer.velocity();
}

namespace {

/// Keeps the handles that act at a time; the chosen ones move along coordinate k between times k and k + 1.
template <int Dim>
Project unitMotions(Project project, const std::vector<int>& chosen, double time) {
    auto& handles = project.design.handles;
    std::vector<Pin> held;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        Pin handle = handles[static_cast<std::size_t>(h)];
        if (!isActive(handle, time)) continue;
        handle.activeFrom = -std::numeric_limits<double>::infinity();
        handle.activeTo = std::numeric_limits<double>::infinity();
        handle.motions.clear();
        if (std::count(chosen.begin(), chosen.end(), h))
            for (int k = 0; k < Dim; ++k)
                handle.motions.push_back({Translate<3>{Vec3::Unit(k)}, double(k), double(k + 1)});
        held.push_back(std::move(handle));
    }
    handles = std::move(held);
    project.settle.clear();
    project.end = Dim;
    return project;
}

}  // namespace

template <int Dim>
Points<Dim> influenceAt(const Shape<Dim>& shape, const Project& project, const std::vector<int>& handles,
                        double time, const Points<Dim>& pose) {
    Shape<Dim> forgetful = shape;
    auto material = std::make_shared<Material<Dim>>(*shape.material);
    material->memory = 0;
    forgetful.material = material;
    VelocityProbe<Dim> probe(forgetful, unitMotions<Dim>(project, handles, time));
    Points<Dim> influence = Points<Dim>::Zero(Dim, pose.cols());
    for (int k = 0; k < Dim; ++k) {
        const Points<Dim> field = probe.at(k + 0.5, pose);
        if (field.cols() != pose.cols()) return Points<Dim>(Dim, 0);
        influence.row(0) += field.colwise().squaredNorm() / Dim;
    }
    influence.row(0) = influence.row(0).cwiseSqrt();
    return influence;
}

template Points2 influenceAt<2>(const Shape<2>&, const Project&, const std::vector<int>&, double,
                                const Points2&);
template Points3 influenceAt<3>(const Shape<3>&, const Project&, const std::vector<int>&, double,
                                const Points3&);
template class VelocityProbe<2>;
template class VelocityProbe<3>;

}  // namespace wend
