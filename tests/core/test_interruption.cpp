// A request to stop in the middle of a velocity field ends the solver, and the following computations have
// the same bits as without it.
#include <QTest>
#include <mutex>
#include <set>

#include "core/assembly/cpu_back_end.h"
#include "core/factor/cholesky.h"
#include "core/factor/supernodal_factor.h"
#include "core/solver/reduced_system.h"
#include "tests/core/test_strip.h"

using namespace wend;
using samples::Bend;

namespace {

/// Reports every assembly and product before it does them.
template <int Dim>
class WatchedBackEnd final : public BackEnd<Dim> {
  public:
    WatchedBackEnd(std::unique_ptr<BackEnd<Dim>> own, std::function<void()> tell)
        : m_own(std::move(own)), m_tell(std::move(tell)) {}
    std::string name() const override { return m_own->name(); }
    std::string device() const override { return m_own->device(); }
    void setMassRegularization(std::vector<double> epsilon) override {
        m_own->setMassRegularization(std::move(epsilon));
    }
    int setShape(const Points<Dim>& shape) override { return m_own->setShape(shape); }
    WorkerPool& workers() override { return m_own->workers(); }
    void assemble(std::span<double> values) override { m_tell(), m_own->assemble(values); }
    void apply(const Points<Dim>& v, Points<Dim>& Av) override { m_tell(), m_own->apply(v, Av); }
    double energy(const Points<Dim>& v) override { return m_own->energy(v); }

  private:
    std::unique_ptr<BackEnd<Dim>> m_own;
    std::function<void()> m_tell;
};

/// Stops at the given piece of work.
struct Alarm {
    std::stop_source source;
    int left = -1;  // pieces of work before it; −1: none

    void tell() {
        if (left >= 0 && left-- == 0) source.request_stop();
    }
    void set(int pieces) { source = {}, left = pieces; }
    template <int Dim>
    BackEndFactory<Dim> factory() {
        return
            [this](auto plan, const SimplicialMesh<Dim>& rest, const Material<Dim>& material, int threads) {
                return std::make_unique<WatchedBackEnd<Dim>>(
                    makeCpuBackEnd<Dim>(plan, rest, material, threads), [this] { tell(); });
            };
    }
};

template <int Dim>
Bend<Dim> bendOf(double phi) {
    return Bend<Dim>(Dim == 2 ? 16 : 8, Dim == 2 ? 4 : 2, 4, 1.5, phi);
}

/// The result is the same for any number and place of interruptions.
template <int Dim>
void goesOnToTheSameBits(double phi) {
    const Bend<Dim> bend = bendOf<Dim>(phi);
    IntegrationOptions options;
    options.tolerance = 1e-3;
    Alarm alarm;
    const auto make = [&] {
        return Deformer<Dim>(bend.mesh, bend.material, bend.handles, options, alarm.factory<Dim>());
    };
    Deformer<Dim> whole = make(), cut = make();
    QCOMPARE(whole.advance(1).outcome, Outcome::Done);
    int stops = 0;
    typename Deformer<Dim>::Watch watch;
    for (int pieces = 0; cut.state().time < 1; pieces += 2) {
        alarm.set(pieces);
        watch.stop = alarm.source.get_token();
        const double before = cut.state().time;
        const AdvanceResult result = cut.advance(1, watch);
        if (result.outcome == Outcome::Done) break;
        QCOMPARE(result.outcome, Outcome::Cancelled);
        QVERIFY(cut.state().time >= before);
        ++stops;
    }
    QVERIFY2(stops >= 5, qPrintable(QString::number(stops)));
    QVERIFY(cut.state().points == whole.state().points);
}

template <int Dim>
Deformer<Dim> steppedDeformer(SolverKind solver) {
    const Bend<Dim> bend(Dim == 2 ? 60 : 24, Dim == 2 ? 20 : 6, 4, 1, phi::kMetr);
    IntegrationOptions options;
    options.solver = solver;
    options.method = Method::RungeKutta4;
    options.steps = 4;
    return Deformer<Dim>(bend.mesh, bend.material, bend.handles, options, BackEndKind::Cpu);
}

/// Progress is reported within the levels, too.
template <int Dim>
void multigridGoesOnToTheSameBits() {
    Deformer<Dim> whole = steppedDeformer<Dim>(SolverKind::Multigrid),
                  cut = steppedDeformer<Dim>(SolverKind::Multigrid);
    QCOMPARE(whole.advance(1).outcome, Outcome::Done);
    std::set<FieldWork> stopped;
    for (int tells = 0;; tells += 7) {
        std::stop_source source;
        std::mutex mutex;
        int left = tells;
        FieldWork work{};
        typename Deformer<Dim>::Watch watch;
        watch.stop = source.get_token();
        watch.withinEvery = {};
        watch.within = [&](const Within& now) {
            const std::scoped_lock lock(mutex);
            if (left-- != 0) return;
            work = now.work;
            source.request_stop();
        };
        const AdvanceResult result = cut.advance(1, watch);
        if (result.outcome == Outcome::Done) break;
        QCOMPARE(result.outcome, Outcome::Cancelled);
        stopped.insert(work);
    }
    QCOMPARE(stopped, (std::set{FieldWork::Levels, FieldWork::Iterations}));
    QVERIFY(cut.state().points == whole.state().points);
}

/// Progress runs from the end of one step to that of the next, and never back.
template <int Dim>
void progressMovesWithinSteps(SolverKind solver) {
    Deformer<Dim> deformer = steppedDeformer<Dim>(solver);
    typename Deformer<Dim>::Watch watch;
    std::vector<double> times;
    double step = 0;
    std::vector<int> within(1, 0);  // of every step
    watch.withinEvery = {};
    watch.within = [&](const Within& now) {
        times.push_back(now.time);
        if (now.time > step && now.time < step + 0.25 && now.part >= 0 && now.part <= 1) ++within.back();
    };
    watch.progress = [&](double time) {
        times.push_back(time);
        step = time;
        within.push_back(0);
    };
    QCOMPARE(deformer.advance(1, watch).outcome, Outcome::Done);
    QVERIFY(std::ranges::is_sorted(times));
    QCOMPARE(within.size(), std::size_t(5));
    for (int k = 0; k < 4; ++k) QVERIFY2(within[k] >= 1, qPrintable(QString::number(within[k])));
}

}  // namespace

class TestInterruption : public QObject {
    Q_OBJECT
  private slots:
    void solveStops();
    void factorizationStops();
    void runGoesOnToTheSameBits_data();
    void runGoesOnToTheSameBits();
    void multigridRunGoesOnToTheSameBits();
    void progressMovesWithinSteps_data();
    void progressMovesWithinSteps();
};

/// The solve stops within its factorization and between its iterations at once: no piece of work begins after
/// the request.
void TestInterruption::solveStops() {
    const Bend<3> bend = bendOf<3>(phi::kMetr);
    Alarm alarm;
    VelocitySolver<3> solver(bend.mesh, bend.material, alarm.factory<3>(), 1);
    std::vector<ConstraintRow> rows;
    for (int v = 0; v < bend.mesh->vertexCount(); ++v)
        if (bend.mesh->points(0, v) < 0.1 || bend.mesh->points(0, v) > 3.9) rows.push_back({{{v, 1.0}}});
    solver.setConstraints(rows);
    solver.setVelocityTolerance(1e-6);
    Points3 speeds = Points3::Zero(3, static_cast<Eigen::Index>(rows.size())), expected, v;
    for (Eigen::Index i = 0; i < speeds.cols(); ++i)
        if (bend.mesh->points(0, rows[static_cast<std::size_t>(i)].terms[0].first) > 3.9) speeds(1, i) = 1;
    QVERIFY(solver.solve(bend.mesh->points, speeds, expected).done());
    for (int pieces = 0; pieces < 3; ++pieces) {  // assembly, first product, that of the first iteration
        alarm.set(pieces);
        solver.forget();
        solver.setStop(alarm.source.get_token());
        const int factors = solver.statistics().factorizations;
        QCOMPARE(solver.solve(bend.mesh->points, speeds, v).kind, SolveOutcome::Kind::Stopped);
        QCOMPARE(alarm.left, -1);
        QVERIFY(solver.statistics().factorizations <= factors + 1);
        solver.setStop({});
        solver.forget();
        QVERIFY(solver.solve(bend.mesh->points, speeds, v).done());
        QVERIFY(v == expected);
    }
}

/// A factorization that was stopped leaves no factor, and the next one is as if it had not happened.
void TestInterruption::factorizationStops() {
    const Bend<3> bend = bendOf<3>(phi::kMetr);
    const auto plan = std::make_shared<const AssemblyPlan<3>>(makeAssemblyPlan(*bend.mesh, true));
    const auto backEnd = makeCpuBackEnd<3>(plan, *bend.mesh, *bend.material, 2);
    backEnd->setMassRegularization(
        std::vector<double>(static_cast<std::size_t>(bend.mesh->cellCount()), 1.0));
    backEnd->setShape(bend.mesh->points);
    std::vector<double> blocks(static_cast<std::size_t>(plan->blockCount()) * 9);
    backEnd->assemble(blocks);
    const ReducedSystem<3> system(*plan, eliminate({}));
    Cholesky cholesky;
    cholesky.analyze(system.columnStart(), system.row(), 3, Ordering::NestedDissection);
    system.gather(blocks, cholesky.values());
    SupernodalFactor<double> factor(cholesky.supernodes(), system.columnStart(), system.row());
    std::vector<double> b(system.columnStart().size() - 1, 1.0), x(b.size()), y(b.size());
    QVERIFY(factor.factorize(cholesky.values(), backEnd->workers()));
    QVERIFY(factor.solve(b, x, backEnd->workers()));
    std::stop_source source;
    source.request_stop();
    QVERIFY(!factor.factorize(cholesky.values(), backEnd->workers(), source.get_token()));
    QVERIFY(factor.factorize(cholesky.values(), backEnd->workers()));
    QVERIFY(factor.solve(b, y, backEnd->workers()));
    QVERIFY(x == y);
}

void TestInterruption::runGoesOnToTheSameBits_data() {
    QTest::addColumn<double>("phi");
    QTest::addRow("METR") << phi::kMetr;
    QTest::addRow("EQUIA") << phi::kEquia;
}

void TestInterruption::runGoesOnToTheSameBits() {
    QFETCH(double, phi);
    goesOnToTheSameBits<2>(phi);
    goesOnToTheSameBits<3>(phi);
}

void TestInterruption::multigridRunGoesOnToTheSameBits() {
    multigridGoesOnToTheSameBits<2>();
    multigridGoesOnToTheSameBits<3>();
}

void TestInterruption::progressMovesWithinSteps_data() {
    QTest::addColumn<SolverKind>("solver");
    QTest::addRow("direct") << SolverKind::Direct;
    QTest::addRow("multigrid") << SolverKind::Multigrid;
}

void TestInterruption::progressMovesWithinSteps() {
    QFETCH(SolverKind, solver);
    ::progressMovesWithinSteps<2>(solver);
    ::progressMovesWithinSteps<3>(solver);
}

QTEST_APPLESS_MAIN(TestInterruption)
#include "test_interruption.moc"
