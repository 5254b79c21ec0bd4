#include "core/integration/deformer.h"

#include <cmath>

#include "core/base/error.h"
#include "core/integration/integrator.h"

namespace wend {

/// Names the first option that is out of its range, with the range.
std::string IntegrationOptions::problem() const {
    if (!(tolerance >= 1e-12 && tolerance <= 0.1)) return "the tolerance must be in [1e-12, 0.1]";
    if (steps < 0) return "the number of steps must not be negative";
    if (steps == 0 && !isAdaptive(method)) return "this method needs a number of steps";
    if (!(end > 0 && std::isfinite(end))) return "the end of time must be greater than 0";
    if (!(smallestStep > 0 && smallestStep <= 0.1)) return "the smallest step must be in ]0, 0.1]";
    if (!(velocityTolerance <= 0.1)) return "the velocity tolerance must not be greater than 0.1";
    if (threads < 0) return "the number of threads must not be negative";
    return problemOf(settle);
}

template <int Dim>
Deformer<Dim>::Deformer(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                        std::shared_ptr<const Material<Dim>> material, std::vector<Handle<Dim>> handles,
                        IntegrationOptions options, BackEndKind backEnd)
    : m_integrator(std::make_unique<Integrator>(
          rest, material, handles, options,
          [material, backEnd, threads = options.threads](
              std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest, SolverKind solver) {
              return VelocitySolver<Dim>(normalizedRest, material, backEnd, threads, solver);
          })) {}

template <int Dim>
Deformer<Dim>::Deformer(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                        std::shared_ptr<const Material<Dim>> material, std::vector<Handle<Dim>> handles,
                        IntegrationOptions options, const BackEndFactory<Dim>& backEnd,
                        const IterativeSolverFactory<Dim>& multigrid)
    : m_integrator(std::make_unique<Integrator>(
          rest, material, handles, options,
          [material, backEnd, multigrid, threads = options.threads](
              std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest, SolverKind solver) {
              return VelocitySolver<Dim>(normalizedRest, material, backEnd, threads, solver, multigrid);
          })) {}

template <int Dim>
Deformer<Dim>::~Deformer() = default;
template <int Dim>
Deformer<Dim>::Deformer(Deformer&&) noexcept = default;
template <int Dim>
Deformer<Dim>& Deformer<Dim>::operator=(Deformer&&) noexcept = default;

template <int Dim>
const State<Dim>& Deformer<Dim>::state() const {
    return m_integrator->state;
}

template <int Dim>
void Deformer<Dim>::restore(const State<Dim>& state) {
    m_integrator->restore(state);
}

template <int Dim>
void Deformer<Dim>::setHandles(std::vector<Handle<Dim>> handles) {
    m_integrator->setHandles(handles);
}

template <int Dim>
void Deformer<Dim>::prepare() {
    m_integrator->activate(Side::After);
    m_integrator->velocitySolver().analyze();
}

template <int Dim>
AdvanceResult Deformer<Dim>::advance(double time, const Watch& watch) {
    return m_integrator->advance(time, watch);
}

template <int Dim>
Points<Dim> Deformer<Dim>::velocity(const std::stop_token& stop) {
    return m_integrator->velocity(stop);
}

template <int Dim>
double Deformer<Dim>::restEnergy() const {
    return m_integrator->velocitySolver().restEnergy(m_integrator->state.normalized);
}

template <int Dim>
double Deformer<Dim>::restForce() {
    return m_integrator->restForce();
}

template <int Dim>
AdvanceResult Deformer<Dim>::failure() const {
    return m_integrator->stopped();
}

template <int Dim>
const Statistics& Deformer<Dim>::statistics() const {
    return m_integrator->statistics;
}

template <int Dim>
SolverKind Deformer<Dim>::solver() const {
    return m_integrator->velocitySolver().solver();
}

template <int Dim>
std::string Deformer<Dim>::backEndName() const {
    return m_integrator->velocitySolver().backEndName();
}

template <int Dim>
std::string Deformer<Dim>::deviceName() const {
    return m_integrator->velocitySolver().deviceName();
}

template class Deformer<2>;
template class Deformer<3>;

}  // namespace wend
