#include "app/session/velocity_probe.h"

#include "app/session/held_border.h"
#include "kernels/back_end_choice.h"

namespace wend {

template <int Dim>
VelocityProbe<Dim>::VelocityProbe(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                                  std::shared_ptr<const Material<Dim>> material, const Project& project,
                                  const Vec<2>& frame)
    : m_deformer(rest, std::move(material), heldHandles<Dim>(project, *rest, frame), integrationOf(project),
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
