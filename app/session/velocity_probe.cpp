#include "app/session/velocity_probe.h"

#include "app/session/held_border.h"
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

template class VelocityProbe<2>;
template class VelocityProbe<3>;

}  // namespace wend
