// Runs whose iterations do not converge: factors are used instead, or the run ends at once with a message.
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "tests/core/test_strip.h"

using namespace wend;
using samples::Bend;
using samples::distance;

namespace {

/// Multigrid that gives up after one iteration.
class Impatient final : public IterativeSolver<3> {
  public:
    explicit Impatient(const SolverTask<3>& task) : m_solver(makeMultigridSolver<3>(task)) {}

    BackEnd<3>& backEnd() override { return m_solver->backEnd(); }
    void analyze(std::vector<double> epsilon) override { m_solver->analyze(std::move(epsilon)); }
    BuildStatus build(Nodal<3> shape, const std::stop_token& stop,
                      const WorkerPool::Progress& progress) override {
        return m_solver->build(std::move(shape), stop, progress);
    }
    Result run(const Goal& goal, const Points3* load, Points3& v) override {
        Goal short_ = goal;
        short_.most = 1;
        return m_solver->run(short_, load, v);
    }

  private:
    std::unique_ptr<IterativeSolver<3>> m_solver;
};

Deformer<3> impatient(const Bend<3>& bend, const IntegrationOptions& options) {
    return Deformer<3>(bend.mesh, bend.material, bend.handles, options, makeCpuBackEnd<3>,
                       [](const SolverTask<3>& task) { return std::make_unique<Impatient>(task); });
}

}  // namespace

class TestSolverFallback : public QObject {
    Q_OBJECT

  private slots:
    void factorsTakeOver();
    void multigridThatWasAskedForEnds();
};

/// Wend itself chooses multigrid for this number of vertices.
void TestSolverFallback::factorsTakeOver() {
    const Bend<3> bend(206, 9, 40, 0.5);
    IntegrationOptions options;
    options.tolerance = 1e-2;
    QCOMPARE(bend.deformer(options).solver(), SolverKind::Multigrid);
    auto deformer = impatient(bend, options);
    QCOMPARE(deformer.solver(), SolverKind::Multigrid);
    std::vector<double> frames;
    Deformer<3>::Watch watch;
    watch.frames = {0, 0.01, 0.02};
    watch.onFrame = [&](const State<3>& frame) { frames.push_back(frame.time); };
    const AdvanceResult result = deformer.advance(0.02, watch);
    QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
    QCOMPARE(deformer.solver(), SolverKind::Direct);
    QCOMPARE(frames, watch.frames);
    QVERIFY(deformer.statistics().factorizations >= 2);  // levels, and a factor
    options.solver = SolverKind::Direct;
    auto direct = bend.deformer(options);
    QCOMPARE(direct.advance(0.02).outcome, Outcome::Done);
    QVERIFY(distance(deformer.state().points, direct.state().points) < 1e-6);
}

/// Multigrid that was requested ends the run, since shorter steps would not help.
void TestSolverFallback::multigridThatWasAskedForEnds() {
    const Bend<3> bend(12, 3, 4, 1.2);
    IntegrationOptions options;
    options.solver = SolverKind::Multigrid;
    auto deformer = impatient(bend, options);
    const AdvanceResult result = deformer.advance(1);
    QVERIFY(result.outcome != Outcome::Done);
    QVERIFY2(result.message.text().find("--solver direct") != std::string::npos,
             result.message.text().c_str());
    QCOMPARE(result.time, 0.0);
    QVERIFY(deformer.statistics().evaluations <= 2);
    QCOMPARE(deformer.solver(), SolverKind::Multigrid);
}

QTEST_APPLESS_MAIN(TestSolverFallback)
#include "test_solver_fallback.moc"
