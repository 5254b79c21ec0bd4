#include "core/solver/velocity_solver.h"

#include "core/assembly/cpu_back_end.h"
#include "core/solver/velocity_solver_impl.h"

namespace wend {
namespace {

template <int Dim>
BackEndFactory<Dim> factoryOf(BackEndKind) {  // other kinds come from above, through the second constructor
    return makeCpuBackEnd<Dim>;
}

}  // namespace

template <int Dim>
VelocitySolver<Dim>::VelocitySolver(std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest,
                                    std::shared_ptr<const Material<Dim>> material, BackEndKind kind,
                                    int threads, SolverKind solver)
    : VelocitySolver(std::move(normalizedRest), std::move(material), factoryOf<Dim>(kind), threads, solver) {}

template <int Dim>
VelocitySolver<Dim>::VelocitySolver(std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest,
                                    std::shared_ptr<const Material<Dim>> material,
                                    const BackEndFactory<Dim>& backEnd, int threads, SolverKind solver,
                                    const IterativeSolverFactory<Dim>& multigrid)
    : m_impl(std::make_unique<Impl>(
          normalizedRest, *material, backEnd, threads,
          chosenSolver(solver, Dim, normalizedRest->vertexCount(), machineMemory()),
          multigrid ? multigrid : IterativeSolverFactory<Dim>(makeMultigridSolver<Dim>))) {}

template <int Dim>
VelocitySolver<Dim>::~VelocitySolver() = default;
template <int Dim>
VelocitySolver<Dim>::VelocitySolver(VelocitySolver&&) noexcept = default;
template <int Dim>
VelocitySolver<Dim>& VelocitySolver<Dim>::operator=(VelocitySolver&&) noexcept = default;

template <int Dim>
void VelocitySolver<Dim>::setConstraints(std::vector<ConstraintRow> rows, Sliders sliders) {
    m_impl->setConstraints(std::move(rows), std::move(sliders));
}

template <int Dim>
void VelocitySolver<Dim>::setDirections(const Points<Dim>& directions) {
    const auto shared = std::make_shared<const Points<Dim>>(directions);
    m_impl->system.setDirections(shared);
    if (m_impl->tracking) m_impl->tracking->system.setDirections(shared);
}

template <int Dim>
bool VelocitySolver<Dim>::analyze() {
    return m_impl->analyze();
}

template <int Dim>
SolveOutcome VelocitySolver<Dim>::solve(const Points<Dim>& shape, const Points<Dim>& prescribed,
                                        Points<Dim>& velocity, const std::optional<Points<Dim>>& guess) {
    stages().combine(std::make_shared<const Points<Dim>>(shape), {});
    return m_impl->solve(prescribed, velocity, guess);
}

template <int Dim>
SolveOutcome VelocitySolver<Dim>::solveAtStage(const Points<Dim>& prescribed, Points<Dim>& velocity,
                                               const std::optional<Points<Dim>>& guess) {
    return m_impl->solve(prescribed, velocity, guess);
}

template <int Dim>
StageVectors<Dim>& VelocitySolver<Dim>::stages() {
    return m_impl->backEnd->stages();
}

template <int Dim>
void VelocitySolver<Dim>::setVelocityTolerance(double tolerance) {
    m_impl->tolerance = tolerance;
}

template <int Dim>
void VelocitySolver<Dim>::setMemoryRate(double rate) {
    m_impl->memoryRate = rate;
}

template <int Dim>
double VelocitySolver<Dim>::restEnergy(const Points<Dim>& shape) const {
    return m_impl->rested().energy(shape);
}

template <int Dim>
double VelocitySolver<Dim>::restForce(const Points<Dim>& shape) const {
    Points<Dim> gradient;
    m_impl->rested().gradient(shape, gradient, m_impl->backEnd->workers());
    for (const auto& slider : m_impl->system.sliders().vertices()) {
        const Vec<Dim> own = gradient.col(slider.vertex);
        gradient.col(slider.vertex) = own - slider.projector * own;
    }
    const std::size_t given = m_impl->rows.size() - m_impl->rest->welds.size();
    project(gradient, Points<Dim>::Zero(Dim, static_cast<Eigen::Index>(given)));
    return gradient.norm();
}

template <int Dim>
SolveOutcome VelocitySolver<Dim>::predict(const Points<Dim>& shape, const Points<Dim>& prescribed,
                                          Points<Dim>& step) {
    const auto* proximal = m_impl->proximal ? &*m_impl->proximal : nullptr;
    Points<Dim> carried = Points<Dim>::Zero(Dim, shape.cols()), others = prescribed;
    for (const LooseGroup& group : m_impl->loose) {
        const Vec<Dim> mean = others(Eigen::all, group.rows).rowwise().mean();
        for (const int v : group.vertices) carried.col(v) = mean;
        for (const int row : group.rows) others.col(row) -= mean;
    }
    const SolveOutcome outcome = m_impl->minimizer().predict(m_impl->pace, shape, m_impl->withWelds(others),
                                                             proximal, m_impl->stop, step);
    if (outcome.done()) step += carried;
    return outcome;
}

template <int Dim>
Descended VelocitySolver<Dim>::descend(Points<Dim>& shape, const Descent<Dim>& descent) {
    const auto* proximal = m_impl->proximal ? &*m_impl->proximal : nullptr;
    return m_impl->minimizer().minimize(shape, descent, proximal, m_impl->stop);
}

template <int Dim>
int VelocitySolver<Dim>::setProximal(double weight, const Points<Dim>& origin) {
    return m_impl->setProximal(weight, origin);
}

template <int Dim>
void VelocitySolver<Dim>::setLongestPause(double seconds) {
    m_impl->cache->policy().setLongestPause(seconds);
    m_impl->pace = RestMinimizer<Dim>::Pace::Even;
}

template <int Dim>
void VelocitySolver<Dim>::setStop(std::stop_token stop) {
    m_impl->stop = std::move(stop);
}

template <int Dim>
void VelocitySolver<Dim>::setProgress(FieldProgress progress) {
    m_impl->progress = progress;
    m_impl->cache->setProgress(std::move(progress));
}

template <int Dim>
bool VelocitySolver<Dim>::reuses() const {
    return m_impl->reuses();
}

template <int Dim>
FactorMemory<Dim> VelocitySolver<Dim>::remember() const {
    return m_impl->cache->remember();
}

template <int Dim>
void VelocitySolver<Dim>::recall(const FactorMemory<Dim>& memory) {
    m_impl->cache->recall(memory);
}

template <int Dim>
double VelocitySolver<Dim>::energy() const {
    return m_impl->last.cols() > 0 ? m_impl->backEnd->energy(m_impl->last) : 0.0;
}

template <int Dim>
const SolverStatistics& VelocitySolver<Dim>::statistics() const {
    return m_impl->statistics;
}

template <int Dim>
SolverKind VelocitySolver<Dim>::solver() const {
    return m_impl->isMultigrid() ? SolverKind::Multigrid : SolverKind::Direct;
}

template <int Dim>
std::string VelocitySolver<Dim>::backEndName() const {
    return m_impl->backEnd->name();
}

template <int Dim>
std::string VelocitySolver<Dim>::deviceName() const {
    return m_impl->backEnd->device();
}

template <int Dim>
CopiedBytes VelocitySolver<Dim>::copied() const {
    return m_impl->backEnd->copied();
}

template <int Dim>
void VelocitySolver<Dim>::project(Points<Dim>& shape, const Points<Dim>& targets) const {
    const SliderSet<Dim>& sliders = m_impl->system.sliders();
    const auto rows = static_cast<Eigen::Index>(m_impl->rows.size());
    Points<Dim> all = m_impl->withWelds(targets);
    if (all.cols() < rows + sliders.count()) {  // sliders stay where they are
        all.conservativeResize(Eigen::NoChange, rows + sliders.count());
        for (std::size_t i = 0; i < m_impl->givenSliders.size(); ++i)
            all.col(rows + static_cast<Eigen::Index>(i)) = shape.col(m_impl->givenSliders[i].vertex);
    }
    const auto slide = [&] {
        for (const auto& slider : sliders.vertices()) slider.place(all, rows, shape.col(slider.vertex));
    };
    slide();
    m_impl->projection.apply(shape, all);
    slide();
}

template <int Dim>
void VelocitySolver<Dim>::turn(const Points<Dim>& from, const Points<Dim>& to,
                               std::vector<Points<Dim>>& fields) {
    m_impl->turn(from, to, fields);
}

template <int Dim>
Eigen::MatrixXd VelocitySolver<Dim>::reducedMatrix() const {
    const auto& start = m_impl->system.columnStart();
    const auto& row = m_impl->system.row();
    const auto values = m_impl->cache->values();
    const auto n = static_cast<Eigen::Index>(start.size()) - 1;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    for (int j = 0; j < n; ++j)
        for (int i = start[j]; i < start[j + 1]; ++i) K(row[i], j) = K(j, row[i]) = values[i];
    return K;
}

template <int Dim>
const std::vector<int>& VelocitySolver<Dim>::unknownVertices() const {
    return m_impl->system.unknowns();
}

template class VelocitySolver<2>;
template class VelocitySolver<3>;

double velocityToleranceFor(double integrationTolerance) {
    return 0.5 * integrationTolerance;
}

}  // namespace wend
