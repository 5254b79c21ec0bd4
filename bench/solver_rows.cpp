#include "bench/solver_rows.h"

#include "core/assembly/cpu_back_end.h"
#include "core/base/error.h"
#include "core/factor/cholesky.h"
#include "core/factor/supernodal_factor.h"
#include "core/integration/deformer.h"
#include "core/solver/reduced_system.h"
#include "core/solver/velocity_solver.h"
#include "kernels/back_end_choice.h"

namespace wend {
namespace {

// The path from one evaluation of an integrator to the next one, as a part of the whole.
constexpr double kStride = 0.05;
constexpr double kTolerance = 1e-4;  // of the integration

template <int Dim>
class SolverBench {
  public:
    SolverBench(const Body<Dim>& body, BenchRecorder& recorder)
        : m_body(body),
          m_recorder(recorder),
          m_start(startRows(body)),
          m_material(std::make_shared<const Material<Dim>>(
              Material<Dim>::uniform(body.rest->cellCount(), phi::kMetr, {}))),
          m_plan(std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(*body.rest, true))),
          m_blocks(static_cast<std::size_t>(m_plan->blockCount()) * Dim * Dim) {}

    double run() {
        addAssembly(makeCpuBackEnd<Dim>, "cpu", 1);
        addAssembly(makeCpuBackEnd<Dim>, "cpu", 0);
        addOpenCl();
        addFactorization();
        addEvaluations();
        return m_bound;
    }

  private:
    void addAssembly(const BackEndFactory<Dim>& factory, const std::string& name, int threads) {
        const auto backEnd = factory(m_plan, *m_body.rest, *m_material, threads);
        const auto assemble = [&] {
            backEnd->setShape(m_body.rest->points);
            backEnd->assemble(m_blocks);
        };
        m_recorder.add({"assembly, " + name, threads, measure(m_recorder.repeats(0.01), assemble), {}});
        Points<Dim> product;
        const auto apply = [&] { backEnd->apply(m_body.rest->points, product); };
        m_recorder.add({"product A v, " + name, threads, measure(m_recorder.repeats(0.01), apply), {}});
    }

    void addOpenCl() {
        try {
            const auto factory = backEndFactory<Dim>(BackEndKind::OpenCl);
            addAssembly(factory, "opencl", 0);
            addOpenClFlow(factory);
        } catch (const InputError& error) {
            m_recorder.remark("no OpenCL: " + error.reason());
        }
    }

    /// Adds one step of RK4 on the device's stages, with what is copied for each of its four fields.
    void addOpenClFlow(const BackEndFactory<Dim>& factory) {
        IntegrationOptions options;
        options.method = Method::RungeKutta4;
        options.steps = 10;
        Deformer<Dim> deformer(m_body.rest, m_material, m_body.handles, options, factory);
        deformer.velocity();
        const Statistics before = deformer.statistics();
        const Timing timing = measureOnce([&] { deformer.advance(0.1); });
        const Statistics& after = deformer.statistics();
        const double evaluations = after.evaluations - before.evaluations;
        m_recorder.add({"one RK4 step, opencl",
                        0,
                        timing,
                        {{"evaluations", evaluations},
                         {"factorizations", after.factorizations - before.factorizations},
                         {"iterations", after.solverIterations - before.solverIterations},
                         {"MB up per evaluation",
                          megabytes(after.copied.toDevice - before.copied.toDevice) / evaluations},
                         {"MB down per evaluation",
                          megabytes(after.copied.fromDevice - before.copied.fromDevice) / evaluations}}});
    }
    static double megabytes(std::size_t bytes) { return 1e-6 * static_cast<double>(bytes); }

    void addFactorization() {
        const ReducedSystem<Dim> system(*m_plan, eliminate(m_start.rows));
        const auto ordering = Dim == 2 && m_body.rest->vertexCount() < 8000 ? Ordering::MinimumDegree
                                                                            : Ordering::NestedDissection;
        Cholesky cholesky;
        const Timing analysis =
            measureOnce([&] { cholesky.analyze(system.columnStart(), system.row(), Dim, ordering); });
        m_recorder.add({"symbolic analysis", 1, analysis, {}});
        system.gather(m_blocks, cholesky.values());
        std::vector<double> b(system.columnStart().size() - 1, 1.0), x(b.size());
        const double flops = cholesky.factorFlops(), entries = cholesky.factorEntries();
        const int repeats = m_recorder.repeats(flops / 2e10);
        const Timing factor = measure(repeats, [&] { cholesky.factorize(); });
        m_recorder.add({"factor, CHOLMOD, double",
                        0,
                        factor,
                        {{"Gflop/s", 1e-9 * flops / factor.median}, {"entries (million)", 1e-6 * entries}}});
        addSolve("solve, CHOLMOD, double", 0, entries * sizeof(double), [&] { cholesky.solve(b, x); });
        for (int threads : {1, 0}) {
            addOwnFactor<double>("double precision", threads, cholesky, system, factor.median);
            addOwnFactor<float>("single precision", threads, cholesky, system, factor.median);
        }
    }

    template <class Real>
    void addOwnFactor(const std::string& precision, int threads, Cholesky& cholesky,
                      const ReducedSystem<Dim>& system, double cholmod) {
        WorkerPool workers(threads);
        SupernodalFactor<Real> factor(cholesky.supernodes(), system.columnStart(), system.row());
        const double flops = cholesky.factorFlops();
        const Timing timing =
            measure(m_recorder.repeats(flops / 2e10), [&] { factor.factorize(cholesky.values(), workers); });
        m_recorder.add({"factor, " + precision,
                        threads,
                        timing,
                        {{"Gflop/s", 1e-9 * flops / timing.median},
                         {"times CHOLMOD's speed", cholmod / timing.median}}});
        std::vector<double> b(system.columnStart().size() - 1, 1.0), x(b.size());
        addSolve("solve, " + precision, threads, cholesky.factorEntries() * sizeof(Real),
                 [&] { factor.solve(b, x, workers); });
    }

    /// Compares a solve with the time of reading the factor twice, which is its lower bound.
    void addSolve(const std::string& name, int threads, double bytes, const std::function<void()>& solve) {
        const Timing timing = measure(m_recorder.repeats(0.05), solve);
        const double bound = 2 * bytes / readBandwidth(bytes);
        m_bound = bound;
        m_recorder.add({name,
                        threads,
                        timing,
                        {{"bound (ms)", 1e3 * bound}, {"times the bound", timing.median / bound}}});
    }

    void addEvaluations() {
        VelocitySolver<Dim> direct(m_body.rest, m_material, BackEndKind::Cpu, 1);
        direct.setConstraints(m_start.rows);
        Points<Dim> v;
        const auto solveDirect = [&] { direct.solve(m_body.rest->points, m_start.velocities, v); };
        const Timing paper = measure(m_recorder.repeats(0.5), solveDirect);
        m_recorder.add({"evaluation, paper's scheme", 1, paper, {}});
        for (int threads : {1, 0}) addOwnEvaluations(threads, paper.median, v);
    }

    void addOwnEvaluations(int threads, double paper, const Points<Dim>& field) {
        VelocitySolver<Dim> solver(m_body.rest, m_material, BackEndKind::Cpu, threads);
        solver.setConstraints(m_start.rows);
        solver.setVelocityTolerance(velocityToleranceFor(kTolerance));
        Points<Dim> v;
        const auto solve = [&](const Points<Dim>& shape) {
            solver.solve(shape, m_start.velocities, v, field);
        };
        const Timing fresh = measure(
            m_recorder.repeats(0.2), [&] { solve(m_body.rest->points); }, [&] { solver.forget(); });
        m_recorder.add({"evaluation, fresh factor",
                        threads,
                        fresh,
                        {{"times the paper's speed", paper / fresh.median},
                         {"times a solve's bound", fresh.median / m_bound}}});
        const Points<Dim> next = m_body.rest->points + kStride * field;
        SolverStatistics before;
        const Timing stale = measure(
            m_recorder.repeats(0.2), [&] { solve(next); },
            [&] {
                solver.forget();
                solve(m_body.rest->points);
                before = solver.statistics();
            });
        m_recorder.add({"evaluation, stale factor",
                        threads,
                        stale,
                        {{"iterations", solver.statistics().iterations - before.iterations},
                         {"factorizations", solver.statistics().factorizations - before.factorizations},
                         {"times the paper's speed", paper / stale.median},
                         {"times a solve's bound", stale.median / m_bound}}});
    }

    const Body<Dim>& m_body;
    BenchRecorder& m_recorder;
    BodyRows<Dim> m_start;
    std::shared_ptr<const Material<Dim>> m_material;
    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    std::vector<double> m_blocks;
    double m_bound = 0;  // of the last solve that was measured: seconds
};

}  // namespace

template <int Dim>
double addSolverRows(const Body<Dim>& body, BenchRecorder& recorder) {
    return SolverBench<Dim>(body, recorder).run();
}

template double addSolverRows<2>(const Body<2>&, BenchRecorder&);
template double addSolverRows<3>(const Body<3>&, BenchRecorder&);

}  // namespace wend
