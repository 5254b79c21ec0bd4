#include "wend/flow.h"

#include <algorithm>
#include <cmath>

#include "api/flow_impl.h"
#include "api/handle_values.h"
#include "core/base/error.h"
#include "core/motion/reach.h"

namespace wend {
namespace {

SmoothingKind smoothingOf(JumpPrice jumps) {
    switch (jumps) {
        case JumpPrice::Paper:
            return SmoothingKind::Paper;
        case JumpPrice::None:
            return SmoothingKind::None;
        case JumpPrice::Length:
            break;
    }
    return SmoothingKind::Invariant;
}

Method methodOf(Stepping stepping) {
    switch (stepping) {
        case Stepping::DormandPrince:
            return Method::DormandPrince;
        case Stepping::RungeKutta4:
            return Method::RungeKutta4;
        case Stepping::Midpoint:
            return Method::Midpoint;
        case Stepping::Adams:
            break;
    }
    return Method::Adams;
}

Ending endingOf(Outcome outcome) {
    switch (outcome) {
        case Outcome::Cancelled:
            return Ending::Cancelled;
        case Outcome::CellInverted:
            return Ending::CellInverted;
        case Outcome::SolverFailed:
            return Ending::SolverFailed;
        case Outcome::StepTooSmall:
            return Ending::StepTooSmall;
        case Outcome::Done:
            break;
    }
    return Ending::Done;
}

template <int Dim>
Material<Dim> materialOf(const FlowMaterial<Dim>& given, int cellCount) {
    auto material = Material<Dim>::uniform(cellCount, given.phi,
                                           {smoothingOf(given.jumps), given.smoothing, given.lambda});
    if (!given.cellPhi.empty()) material.phi = given.cellPhi;
    for (const std::array<double, Dim * Dim>& B : given.anisotropy)
        material.anisotropy.push_back(Eigen::Map<const Mat<Dim>>(B.data()).transpose());
    material.memory = given.memory;
    if (!(given.smoothing >= 0 && std::isfinite(given.smoothing)))
        throw InputError("the smoothing length must be 0 or more");
    if (!(given.lambda >= 0 && std::isfinite(given.lambda))) throw InputError("λ must be 0 or more");
    if (!(given.memory >= 0)) throw InputError("the memory must be 0 or more");
    return material;
}

IntegrationOptions integrationOf(const FlowOptions& given) {
    IntegrationOptions options;
    options.method = methodOf(given.method);
    options.tolerance = given.tolerance;
    options.steps = given.steps;
    options.end = given.end;
    options.threads = given.threads;
    return options;
}

}  // namespace

double phiOf(Keep keep, int dimension) {
    if (dimension != 2 && dimension != 3) throw InvalidInput("the dimension must be 2 or 3");
    switch (keep) {
        case Keep::Measure:
            return phi::kEquia;
        case Keep::Rigidity:
            return phi::kAkvf;
        case Keep::Angles:
            return phi::conformal(dimension);
        case Keep::Length:
            break;
    }
    return phi::kMetr;
}

template <int Dim>
Flow<Dim>::Flow(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
template <int Dim>
Flow<Dim>::Flow(std::span<const Coordinates<Dim>> points, std::span<const CellVertices<Dim>> cells,
                const FlowMaterial<Dim>& material, const FlowOptions& options)
    : m_impl(documented([&] {
          const auto rest = std::make_shared<const SimplicialMesh<Dim>>(meshOf<Dim>(points, cells));
          return std::make_unique<Impl>(
              rest, std::make_shared<const Material<Dim>>(materialOf(material, rest->cellCount())),
              integrationOf(options));
      })) {}
template <int Dim>
Flow<Dim>::Flow(const Mesh<Dim>& mesh, const FlowMaterial<Dim>& material, const FlowOptions& options)
    : Flow(mesh.points, mesh.cells, material, options) {}
template <int Dim>
Flow<Dim>::~Flow() = default;
template <int Dim>
Flow<Dim>::Flow(Flow&&) noexcept = default;
template <int Dim>
Flow<Dim>& Flow<Dim>::operator=(Flow&&) noexcept = default;

template <int Dim>
int Flow<Dim>::hold(const Place<Dim>& place) {
    return move(place, {});
}
template <int Dim>
int Flow<Dim>::move(const Place<Dim>& place, const Movement<Dim>& movement) {
    Handle<Dim> handle{"handle " + std::to_string(handleCount()), place.m_data->at, movement.m_data->motions};
    handle.slides = place.m_data->slides;
    return m_impl->add(std::move(handle));
}
template <int Dim>
void Flow<Dim>::setMovement(int handle, const Movement<Dim>& movement) {
    if (handle < 0 || handle >= handleCount())
        throw InvalidInput("there is no handle " + std::to_string(handle) + " of " +
                           std::to_string(handleCount()));
    m_impl->handles[static_cast<std::size_t>(handle)].motions = movement.m_data->motions;
    m_impl->isChanged = true;
}
template <int Dim>
void Flow<Dim>::clear() {
    m_impl->handles.clear();
    m_impl->isChanged = true;
}
template <int Dim>
int Flow<Dim>::handleCount() const {
    return static_cast<int>(m_impl->handles.size());
}

/// The order of the two does not matter: setHandles() continues from the state that it finds.
template <int Dim>
void Flow<Dim>::reset() {
    m_impl->deformer.restore(m_impl->atRest);
}
template <int Dim>
void Flow<Dim>::prepare() {
    documented([&] {
        m_impl->apply();
        m_impl->deformer.prepare();
    });
}
template <int Dim>
RunResult Flow<Dim>::run(const RunControl& control) {
    const double end = m_impl->end.value_or(lastMotionEnd(m_impl->handles, 1.0));
    return run(std::max(time(), end), control);
}
template <int Dim>
RunResult Flow<Dim>::run(double until, const RunControl& control) {
    if (!(until >= time() && std::isfinite(until)))
        throw InvalidInput("the end of a run must be finite and not before the time of the shape");
    return documented([&]() -> RunResult {
        m_impl->apply();
        typename Deformer<Dim>::Watch watch;
        watch.progress = control.progress;
        watch.stop = control.stop;
        AdvanceResult result = m_impl->deformer.advance(until, watch);
        return {endingOf(result.outcome), result.time, result.cell, std::move(result.message)};
    });
}

template <int Dim>
double Flow<Dim>::time() const {
    return m_impl->deformer.state().time;
}
template <int Dim>
std::span<const Coordinates<Dim>> Flow<Dim>::points() const {
    return spanOf<Dim>(m_impl->deformer.state().points);
}
template <int Dim>
std::span<const Coordinates<Dim>> Flow<Dim>::restPoints() const {
    return spanOf<Dim>(m_impl->rest->points);
}
template <int Dim>
std::span<const CellVertices<Dim>> Flow<Dim>::cells() const {
    return m_impl->rest->cells;
}
template <int Dim>
std::vector<Coordinates<Dim>> Flow<Dim>::velocity() {
    return documented([&] {
        m_impl->apply();
        return coordinatesOf<Dim>(m_impl->deformer.velocity());
    });
}

template <int Dim>
FlowDistortion Flow<Dim>::distortion() const {
    Distortion all = m_impl->distortion();
    return {std::move(all.angle), std::move(all.volume), std::move(all.metric), std::move(all.ratio),
            all.totalAngle,       all.totalVolume,       all.totalMetric,       all.flips};
}
template <int Dim>
double Flow<Dim>::minDet() const {
    return m_impl->distortion().minDet;
}
template <int Dim>
int Flow<Dim>::worst() const {
    return m_impl->distortion().worstCell;
}
template <int Dim>
double Flow<Dim>::restEnergy() const {
    return m_impl->deformer.restEnergy();
}
template <int Dim>
FlowStatistics Flow<Dim>::statistics() const {
    const Statistics& all = m_impl->deformer.statistics();
    FlowStatistics some{all.steps,   all.rejected, all.evaluations, all.factorizations, all.solverIterations,
                        all.analyze, all.assemble, all.factor,      all.solve};
    some.constraintError = all.constraintError;
    for (const Snap& snap : all.snaps) some.snaps.push_back(snap.time);
    return some;
}

template class Flow<2>;
template class Flow<3>;

}  // namespace wend
