// The velocity solver with the factors of earlier shapes compared with the direct solve; the vectorized back
// end compared with its reference.
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/factor/cholesky.h"
#include "core/solver/conjugate_gradients.h"
#include "core/solver/reduced_system.h"
#include "core/solver/refactor_policy.h"
#include "core/solver/velocity_history.h"
#include "core/solver/velocity_solver.h"
#include "core/solver/vertex_rotations.h"
#include "tests/core/test_energy_samples.h"
#include "tests/core/test_strip.h"
#include "tests/support/simd_targets.h"

using namespace wend;
using namespace wend::test;

class TestSolverReuse : public QObject {
    Q_OBJECT
  private slots:
    void velocityIsWithinTolerance_data();
    void velocityIsWithinTolerance();
    void toleranceHoldsWhereSinglePrecisionIsPoor();
    void singlePrecisionIsGivenUp();
    void contractionsAreReportedAsMeasured();
    void equiaAlwaysFactorizes();
    void everyTargetStaysWithinTolerance();
    void cholmodServesWhereItIsQuicker();
    void runsRepeat();
    void memoryGoesOnToTheSameBits();
    void rotationsServeNearbyShapes();
    void rotationsAreThoseOfTheShape();
    void isotropicBackEndAgrees();
    void historyExtrapolates();
    void historyLearnsFromMisses();
    void fieldsTurnWithTheShape();
    void historyFitsPrescribed();
    void policyRefactorizes();
};

namespace {

/// A grid whose low side is fixed and whose high side rotates about the middle of the low one.
template <int Dim>
struct Turn {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh;
    std::vector<ConstraintRow> rows;
    std::vector<int> vertices;

    explicit Turn(int n) {
        std::mt19937 random(11);
        mesh = std::make_shared<const SimplicialMesh<Dim>>(unitGrid<Dim>(n, 0.1, random));
        const double high = mesh->points.row(0).maxCoeff();
        for (int v = 0; v < mesh->vertexCount(); ++v)
            if (mesh->points(0, v) < 0.3 * high / n || mesh->points(0, v) > high * (1 - 0.3 / n)) {
                rows.push_back({{{v, 1.0}}});
                vertices.push_back(v);
            }
    }
    /// Returns velocities at 1 radian per unit of time.
    Points<Dim> speeds(const Points<Dim>& shape) const {
        Points<Dim> speeds = Points<Dim>::Zero(Dim, static_cast<Eigen::Index>(vertices.size()));
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const int v = vertices[i];
            if (mesh->points(0, v) < 0.3) continue;
            speeds(0, static_cast<Eigen::Index>(i)) = -shape(1, v);
            speeds(1, static_cast<Eigen::Index>(i)) = shape(0, v);
        }
        return speeds;
    }
};

struct Drive {
    double worst = 0;  // error against the direct solve, relative to the largest velocity
    SolverStatistics statistics;
    Eigen::MatrixXd pose;
};

/// Twenty explicit midpoint steps to 1 radian; every velocity compared with the direct solve's.
template <int Dim>
Drive drive(double phi, double tolerance, int threads, int n) {
    const Turn<Dim> turn(n);
    const auto material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(turn.mesh->cellCount(), phi));
    VelocitySolver<Dim> solver(turn.mesh, material, BackEndKind::Cpu, threads);
    VelocitySolver<Dim> direct(turn.mesh, material, BackEndKind::Cpu, threads);
    solver.setConstraints(turn.rows);
    direct.setConstraints(turn.rows);
    solver.setVelocityTolerance(tolerance);
    VelocityHistory<Dim> history;
    Drive result;
    Points<Dim> x = turn.mesh->points, v, exact;
    const auto evaluate = [&](double t, const Points<Dim>& shape) {
        const auto speeds = turn.speeds(shape);
        const auto guess = history.at(t);
        if (!solver.solve(shape, speeds, v, guess).done() || !direct.solve(shape, speeds, exact).done())
            throw std::runtime_error("not solved");
        history.record(t, speeds, v);
        const double error = (v - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
        result.worst = std::max(result.worst, error);
    };
    const double h = 0.05;
    for (int i = 0; i < 20; ++i) {
        evaluate(i * h, x);
        evaluate(i * h + h / 2, x + h / 2 * v);
        x += h * v;
    }
    result.statistics = solver.statistics();
    result.pose = x;
    return result;
}

Drive drive(int dimension, double phi, double tolerance, int threads = 1) {
    return dimension == 2 ? drive<2>(phi, tolerance, threads, 24) : drive<3>(phi, tolerance, threads, 7);
}

}  // namespace

void TestSolverReuse::velocityIsWithinTolerance_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<double>("phi");
    QTest::addColumn<double>("tolerance");
    for (int dimension : {2, 3})
        for (double tolerance : {1e-3, 1e-5}) {
            QTest::addRow("%dD METR %g", dimension, tolerance) << dimension << phi::kMetr << tolerance;
            QTest::addRow("%dD AKVF %g", dimension, tolerance) << dimension << phi::kAkvf << tolerance;
            QTest::addRow("%dD CONF %g", dimension, tolerance)
                << dimension << phi::conformal(dimension) << tolerance;
            QTest::addRow("%dD 2.2 %g", dimension, tolerance) << dimension << 2.2 << tolerance;
        }
}

// The error is estimated from the last two corrections: it may be off by a small factor, hence 3.
void TestSolverReuse::velocityIsWithinTolerance() {
    QFETCH(int, dimension);
    QFETCH(double, phi);
    QFETCH(double, tolerance);
    const auto run = drive(dimension, phi, tolerance);
    QVERIFY2(run.worst <= 3 * tolerance, qPrintable(QString::number(run.worst)));
    QVERIFY2(run.statistics.factorizations <= 20, qPrintable(QString::number(run.statistics.factorizations)));
}

namespace {

/// A strip, held at one end and pulled at one vertex of the other. The longer it is, the worse the condition
/// of its matrix; thirty times its width is as bad as many ten thousand vertices of a square.
struct LongStrip {
    std::shared_ptr<const SimplicialMesh<2>> mesh;
    std::shared_ptr<const Material<2>> material;
    std::vector<ConstraintRow> rows;
    Points2 up, slant;           // prescribed
    Points2 lifted, pulledSide;  // what they give, solved directly

    explicit LongStrip(int length) {
        SimplicialMesh<2> strip = samples::strip<2>(4 * length, 4, length);
        strip.points /= boundingBoxDiagonal<2>(strip.points);
        mesh = std::make_shared<const SimplicialMesh<2>>(strip);
        material = std::make_shared<const Material<2>>(Material<2>::uniform(mesh->cellCount(), phi::kMetr));
        for (int v = 0; v < mesh->vertexCount(); ++v)
            if (mesh->points(0, v) < 1e-9 || v == mesh->vertexCount() - 1) rows.push_back({{{v, 1.0}}});
        up = slant = Points2::Zero(2, static_cast<Eigen::Index>(rows.size()));
        up.rightCols(1) << 0, 1;
        slant.rightCols(1) << 0.5, 1;
        VelocitySolver<2> direct = solver(0);
        if (!direct.solve(mesh->points, up, lifted).done() ||
            !direct.solve(mesh->points, slant, pulledSide).done())
            throw std::runtime_error("not solved");
    }
    VelocitySolver<2> solver(double tolerance) const {
        VelocitySolver<2> solver(mesh, material, BackEndKind::Cpu, 1);
        solver.setConstraints(rows);
        solver.setVelocityTolerance(tolerance);
        return solver;
    }
    double error(const Points2& v) const {
        return (v - lifted).cwiseAbs().maxCoeff() / lifted.cwiseAbs().maxCoeff();
    }
    /// Returns a guess with a smooth error, of which a poor factor shows little and leaves much.
    Points2 guess(double off) const { return lifted + off * (pulledSide - lifted); }
};

}  // namespace

/// Good guesses must not be mistaken for solutions.
void TestSolverReuse::toleranceHoldsWhereSinglePrecisionIsPoor() {
    const LongStrip strip(40);
    const double tolerance = 1e-4;
    auto solver = strip.solver(tolerance);
    Points2 v;
    QVERIFY(solver.solve(strip.mesh->points, strip.up, v).done());
    QVERIFY(strip.error(v) <= 3 * tolerance);
    FactorMemory<2> memory = solver.remember();
    QVERIFY(memory.kind == FactorKind::Single && memory.best == FactorKind::Single);
    // The solver accepts the factor, but it is worse than the 0.05 assumed of any factor: otherwise nothing
    // here would be poor.
    const double poor = memory.freshContraction.value_or(0);
    qInfo("contraction %.3f", poor);
    QVERIFY(poor > 0.05);
    for (double off : {1e-2, 3e-3, 1e-3}) {
        memory.shape = nullptr;  // a new factor
        solver.recall(memory);
        QVERIFY(solver.solve(strip.mesh->points, strip.up, v, strip.guess(off)).done());
        QVERIFY2(strip.error(v) <= 3 * tolerance, qPrintable(QString::number(strip.error(v))));
    }
}

/// With a longer strip, iterations would end with wrong answers or never: a factor in double precision
/// replaces the one in single precision from then on. That happens where an iteration leaves more than a
/// third of the error, or where the matrix is not positive definite in single precision. The condition grows
/// with a power of the length, but the error left also depends on rounding: which strips are given up differs
/// between machines, but the longest are given up on all.
void TestSolverReuse::singlePrecisionIsGivenUp() {
    const double tolerance = 1e-4;
    for (int length : {60, 80, 90, 100, 110, 240, 480}) {
        const LongStrip strip(length);
        auto solver = strip.solver(tolerance);
        Points2 v;
        QVERIFY(!solver.remember().freshContraction);
        QVERIFY(solver.solve(strip.mesh->points, strip.up, v).done());
        QVERIFY2(strip.error(v) <= 3 * tolerance, qPrintable(QString::number(strip.error(v))));
        const FactorMemory<2> memory = solver.remember();
        const bool poor = memory.freshContraction.value_or(1) > 0.33;
        qInfo("length %d, contraction %.3f", length, memory.freshContraction.value_or(1));
        QVERIFY(poor || length < 240);
        QCOMPARE(memory.kind == FactorKind::Double, poor);
        QCOMPARE(memory.best == FactorKind::Double, poor);
        for (double off : {1e-2, 3e-3, 1e-3}) {
            solver.recall(memory);
            QVERIFY(solver.solve(strip.mesh->points, strip.up, v, strip.guess(off)).done());
            QVERIFY2(strip.error(v) <= 3 * tolerance, qPrintable(QString::number(strip.error(v))));
        }
        if (poor) QCOMPARE(solver.statistics().factorizations, memory.freshContraction ? 2 : 1);
    }
}

/// Without a preconditioner a step may increase the error: that is reported as measured, and differs from
/// having no second step.
void TestSolverReuse::contractionsAreReportedAsMeasured() {
    const LongStrip strip(60);
    const auto plan = std::make_shared<const AssemblyPlan<2>>(makeAssemblyPlan(*strip.mesh, true));
    const auto backEnd = makeCpuBackEnd<2>(plan, *strip.mesh, *strip.material, 1);
    const ReducedSystem<2> system(*plan, eliminate(strip.rows));
    QCOMPARE(backEnd->setShape(strip.mesh->points), -1);
    std::vector<double> sizes;
    const auto none = [&](std::span<const double> r, std::span<double> z) {
        std::copy(r.begin(), r.end(), z.begin());
        sizes.push_back(Eigen::Map<const Eigen::VectorXd>(r.data(), static_cast<Eigen::Index>(r.size()))
                            .cwiseAbs()
                            .maxCoeff());
        return true;
    };
    const auto run = [&](const ConjugateGradients<2>::Goal& goal) {
        ConjugateGradients<2> iteration;
        Points2 v;
        system.particular(strip.up, v);
        sizes.clear();
        return iteration.run(*backEnd, system, none, goal, nullptr, v);
    };
    const auto once = run({.tolerance = 1e9, .contraction = 0.5, .hopeless = {}});
    QVERIFY(once.iterations == 1 && !once.firstContraction && !once.worstContraction);
    const auto often = run({.tolerance = 1e-4, .hopeless = [](double) { return false; }});
    double worst = 0;
    for (std::size_t i = 1; i < sizes.size(); ++i) worst = std::max(worst, sizes[i] / sizes[i - 1]);
    QVERIFY(worst >= 1 && often.iterations > 2);
    QCOMPARE(often.worstContraction.value(), worst);
    QCOMPARE(often.firstContraction.value(), sizes[1] / sizes[0]);
    const auto strict =
        run({.tolerance = 1e-4, .poorestContraction = 0.9, .hopeless = [](double) { return false; }});
    QVERIFY(strict.worstContraction.value() > 0.9 && strict.iterations < often.iterations);
    QCOMPARE(strict.end, ConjugateGradients<2>::Result::End::GaveUp);
}

void TestSolverReuse::equiaAlwaysFactorizes() {
    const auto run = drive<2>(phi::kEquia, 1e-3, 1, 10);
    QCOMPARE(run.statistics.factorizations, 40);
    // Two factors in double precision of matrices of a condition of 1e6, refined to a residual of 1e-10.
    QVERIFY2(run.worst < 1e-9, qPrintable(QString::number(run.worst)));
}

// The targets use Wend's factors, and the lesser ones CHOLMOD's where Wend's are slower.
void TestSolverReuse::everyTargetStaysWithinTolerance() {
    onEveryTarget([](SimdTarget) {
        const auto flat = drive(2, phi::kMetr, 1e-4), solid = drive(3, phi::kMetr, 1e-4);
        QVERIFY2(flat.worst <= 3e-4, qPrintable(QString::number(flat.worst)));
        QVERIFY2(solid.worst <= 3e-4, qPrintable(QString::number(solid.worst)));
        QVERIFY(drive(3, phi::kMetr, 1e-4, 2).pose == solid.pose);
    });
}

// The large fronts of a cube are chosen by their work alone, so the choice is the same on every machine and
// for any number of threads.
void TestSolverReuse::cholmodServesWhereItIsQuicker() {
    const Turn<3> large(12), small(4);
    const auto kindFor = [](const Turn<3>& turn, int threads) {
        const auto material =
            std::make_shared<const Material<3>>(Material<3>::uniform(turn.mesh->cellCount(), phi::kMetr));
        VelocitySolver<3> solver(turn.mesh, material, BackEndKind::Cpu, threads);
        solver.setConstraints(turn.rows);
        solver.setVelocityTolerance(1e-4);
        Points3 v;
        if (!solver.solve(turn.mesh->points, turn.speeds(turn.mesh->points), v).done())
            throw std::runtime_error("not solved");
        return solver.remember().kind;
    };
    onEveryTarget([&](SimdTarget target) {
        QCOMPARE(kindFor(small, 1), FactorKind::Single);
        const auto expected = target < SimdTarget::Avx2 ? FactorKind::Reference : FactorKind::Single;
        QCOMPARE(kindFor(large, 1), expected);
        QCOMPARE(kindFor(large, 2), expected);
    });
}

void TestSolverReuse::runsRepeat() {
    // More than 10 000 unknowns, so that two threads are used.
    const auto one = drive<2>(phi::kMetr, 1e-3, 1, 75), two = drive<2>(phi::kMetr, 1e-3, 2, 75);
    QVERIFY(one.pose == two.pose);
    QCOMPARE(one.statistics.iterations, two.statistics.iterations);
}

/// A solver that did other work meanwhile, and another solver, continue with the same bits.
template <int Dim>
void compareMemories(int n) {
    const Turn<Dim> turn(n);
    const auto material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(turn.mesh->cellCount(), phi::kMetr));
    VelocitySolver<Dim> one(turn.mesh, material, BackEndKind::Cpu, 1),
        two(turn.mesh, material, BackEndKind::Cpu, 1);
    for (auto* solver : {&one, &two}) {
        solver->setConstraints(turn.rows);
        solver->setVelocityTolerance(1e-5);
    }
    Points<Dim> x = turn.mesh->points, v, w, other;
    std::optional<Points<Dim>> guess;
    bool ahead = false;
    for (int i = 0; i < 20; ++i) {
        const auto before = one.remember();
        ahead = ahead || before.ahead > 0;
        QVERIFY(one.solve(x, turn.speeds(x), v, guess).done());
        const auto after = one.remember();
        one.setVelocityTolerance(0);  // something else: a factor of its own
        QVERIFY(one.solve(turn.mesh->points, turn.speeds(x), other).done());
        one.setVelocityTolerance(1e-5);
        one.recall(before);
        QVERIFY(one.solve(x, turn.speeds(x), other, guess).done());
        QVERIFY(v == other);
        one.recall(after);
        if (i % 3 == 0) two.recall(before);
        QVERIFY(two.solve(x, turn.speeds(x), w, guess).done());
        QVERIFY(v == w);
        x += 0.03 * v;
        guess = v;
    }
    QVERIFY(ahead);  // one factor at least was made where the shape was not yet
    QVERIFY(two.statistics().factorizations < 12);
    two.forget();
    const int factorizations = two.statistics().factorizations;
    QVERIFY(two.solve(x, turn.speeds(x), w).done());
    QCOMPARE(two.statistics().factorizations, factorizations + 1);
}

void TestSolverReuse::memoryGoesOnToTheSameBits() {
    compareMemories<2>(12);
    compareMemories<3>(5);
}

/// With one factor, a shape a tenth of the way farther uses the rotations of the one before it, one twice as
/// far has its own. A solver with other rotations in between recomputes them.
void TestSolverReuse::rotationsServeNearbyShapes() {
    const Turn<2> turn(12);
    const Points2& rest = turn.mesh->points;
    const auto material =
        std::make_shared<const Material<2>>(Material<2>::uniform(turn.mesh->cellCount(), phi::kMetr));
    VelocitySolver<2> solver(turn.mesh, material, BackEndKind::Cpu, 1);
    solver.setConstraints(turn.rows);
    solver.setVelocityTolerance(1e-5);
    Points2 start, v, again;
    QVERIFY(solver.solve(rest, turn.speeds(rest), start).done());
    QVERIFY(!solver.remember().turned);
    const auto solve = [&](double time, Points2& field) {
        const Points2 shape = rest + time * start;
        QVERIFY(solver.solve(shape, turn.speeds(shape), field, start).done());
    };
    solve(0.1, v);
    const FactorMemory<2> first = solver.remember();
    QVERIFY(first.turned && *first.turned == rest + 0.1 * start);
    solve(0.11, v);
    QVERIFY(solver.remember().turned == first.turned);
    solve(0.2, again);
    QVERIFY(solver.remember().turned != first.turned && solver.remember().shape == first.shape);
    solver.recall(first);
    solve(0.11, again);
    QVERIFY(again == v);
}

/// A shape that is rotated and stretched as a whole has one rotation, however flat its cells are; Rᵀ undoes
/// R.
template <int Dim>
void compareRotations(double flatness) {
    std::mt19937 random(4);
    auto mesh = unitGrid<Dim>(4, 0.1, random);
    mesh.points.row(Dim - 1) *= flatness;
    Mat<Dim> R = Mat<Dim>::Identity();
    R(0, 0) = R(1, 1) = std::cos(2.0);
    R(1, 0) = std::sin(2.0), R(0, 1) = -R(1, 0);
    VertexRotations<Dim> rotations(makeAssemblyPlan(mesh, false));
    WorkerPool workers(2);
    rotations.compute(mesh.points, 1.3 * R * mesh.points, workers);
    VertexRotations<Dim> again(makeAssemblyPlan(mesh, false));
    WorkerPool alone(1);
    again.compute(mesh.points, 1.3 * R * mesh.points, alone);
    Points<Dim> field = mesh.points, same = field;
    rotations.turn(field), again.turn(same);
    QVERIFY(field == same);
    std::vector<int> vertices = {3, 0, 7};
    std::vector<double> b(vertices.size() * Dim);
    for (auto& value : b) value = uniform(random, -1, 1);
    auto c = b;
    rotations.turn(vertices, c);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec<Dim> from = Eigen::Map<Vec<Dim>>(b.data() + i * Dim),
                       to = Eigen::Map<Vec<Dim>>(c.data() + i * Dim);
        QVERIFY((R * from - to).norm() < 1e-12);
    }
    rotations.turnBack(vertices, c);
    for (std::size_t i = 0; i < b.size(); ++i) QVERIFY(std::abs(b[i] - c[i]) < 1e-12);
}

void TestSolverReuse::rotationsAreThoseOfTheShape() {
    onEveryTarget([](SimdTarget) {
        for (const double flatness : {1.0, 0.01}) {
            compareRotations<2>(flatness);
            compareRotations<3>(flatness);
        }
    });
}

template <int Dim>
void compareBackEnds() {
    std::mt19937 random(5);
    for (const auto kind : {SmoothingKind::Invariant, SmoothingKind::Paper, SmoothingKind::None}) {
        const auto mesh = unitGrid<Dim>(Dim == 2 ? 13 : 5, 0.2, random);
        auto material = randomMaterial<Dim>(random, mesh.cellCount(), {kind, 0.05, 0.1});
        material.anisotropy.clear();
        const auto plan =
            std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(mesh, kind != SmoothingKind::None));
        const auto fast = makeCpuBackEnd<Dim>(plan, mesh, material, 1),
                   reference = makeGeneralBackEnd<Dim>(plan, mesh, material, 1);
        std::vector<double> massRegularization(mesh.cells.size(), 0.0);
        massRegularization[3] = 0.5;
        const Points<Dim> shape = mesh.points + 0.01 * randomField<Dim>(random, mesh.vertexCount());
        const Points<Dim> v = randomField<Dim>(random, mesh.vertexCount());
        std::vector<double> a(static_cast<std::size_t>(plan->blockCount()) * Dim * Dim), b(a.size());
        Points<Dim> x, y;
        for (const auto& backEnd : {fast.get(), reference.get()}) {
            backEnd->setMassRegularization(massRegularization);
            QCOMPARE(backEnd->setShape(shape), -1);
        }
        fast->assemble(a);
        reference->assemble(b);
        fast->apply(v, x);
        reference->apply(v, y);
        const Eigen::Map<Eigen::VectorXd> A(a.data(), static_cast<Eigen::Index>(a.size())),
            B(b.data(), A.size());
        // Both sum some tens of terms in double.
        QVERIFY((A - B).cwiseAbs().maxCoeff() <= 1e-13 * B.cwiseAbs().maxCoeff());
        QVERIFY((x - y).cwiseAbs().maxCoeff() <= 1e-13 * y.cwiseAbs().maxCoeff());
        QVERIFY(std::abs(fast->energy(v) / reference->energy(v) - 1) <= 1e-13);

        Points<Dim> folded = mesh.points;
        const auto& cell = mesh.cells[40];
        folded.col(cell[0]) += 3 * (folded.col(cell[1]) - folded.col(cell[0]));
        QCOMPARE(fast->setShape(folded), reference->setShape(folded));
        folded(0, cell[0]) = std::nan("");
        QCOMPARE(fast->setShape(folded), reference->setShape(folded));
    }
}

void TestSolverReuse::isotropicBackEndAgrees() {
    compareBackEnds<2>();
    compareBackEnds<3>();
}

void TestSolverReuse::historyExtrapolates() {
    std::mt19937 random(2);
    const Points2 a = randomField<2>(random, 9), b = randomField<2>(random, 9), c = randomField<2>(random, 9);
    const auto field = [&](double t) { return Points2(a + t * b + t * t * c); };
    VelocityHistory<2> history;
    QVERIFY(!history.at(0).has_value());
    const Points2 none(2, 0);
    for (double t : {0.0, 0.3, 0.45}) history.record(t, none, field(t));
    history.record(0.45 * (1 + 1e-16), none, field(0.45));  // the same time
    QVERIFY((*history.at(0.5) - field(0.5)).cwiseAbs().maxCoeff() <= 1e-12);
    history.clear();
    for (double t : {0.0, 0.3}) history.record(t, none, field(t));
    history.record(0.6, none, a);
    history.record(0.62, none, field(0.62));  // too close for a polynomial through both
    QVERIFY((*history.at(0.9) - field(0.9)).cwiseAbs().maxCoeff() <= 1e-12);
    history.clear();
    history.record(1, none, a);
    QVERIFY(*history.at(2) == a);
}

Mat2 rotationBy(double angle) {
    return (Mat2() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
}

/// The steps are those of Runge and Kutta through a rotating field: the error of a quadratic polynomial
/// rotates as well.
void TestSolverReuse::historyLearnsFromMisses() {
    std::mt19937 random(2);
    const Points2 start = randomField<2>(random, 9), none(2, 0);
    const double h = 0.1, rate = 3;
    const auto field = [&](double t) { return Points2(rotationBy(rate * t) * start); };
    const VelocityHistory<2>::Turn turn = [&](const Points2& from, const Points2& to, auto& fields) {
        QVERIFY(from.cols() == 1 && to.cols() == 1);
        for (Points2& f : fields) f = (rotationBy(rate * (to(0) - from(0))) * f).eval();
    };
    VelocityHistory<2> history;
    double worst = 0, worstOfPolynomial = 0;
    for (int n = 0; n < 6; ++n) {
        const double from = n * h;
        const auto shape = std::make_shared<const Points2>(Points2::Constant(2, 1, from));
        history.begin(from, from + 2 * h, shape, turn);
        history.begin(from, from + h, shape, turn);  // the first attempt came to nothing
        VelocityHistory<2> polynomial = history;
        polynomial.begin(from, from + 10 * h, shape, turn);  // so that it learns nothing
        for (const double part : {0.0, 0.5, 0.5, 1.0}) {
            const double t = from + part * h;
            const auto guess = history.at(t), plain = polynomial.at(t);
            if (n > 2) {
                worst = std::max(worst, (*guess - field(t)).cwiseAbs().maxCoeff());
                worstOfPolynomial = std::max(worstOfPolynomial, (*plain - field(t)).cwiseAbs().maxCoeff());
            }
            history.record(t, none, field(t));
            polynomial.record(t, none, field(t));
        }
    }
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
    QVERIFY2(worstOfPolynomial > 1e-3, qPrintable(QString::number(worstOfPolynomial)));
}

/// A field is rotated by the rotation of every place, whatever else happens there.
void TestSolverReuse::fieldsTurnWithTheShape() {
    std::mt19937 random(3);
    const Turn<2> turn(6);
    const auto material =
        std::make_shared<const Material<2>>(Material<2>::uniform(turn.mesh->cellCount(), phi::kMetr));
    VelocitySolver<2> solver(turn.mesh, material, BackEndKind::Cpu, 1);
    const Mat2 R = rotationBy(0.7);
    const Points2 to = 1.2 * (R * turn.mesh->points);
    std::vector<Points2> fields;
    for (int i = 0; i < 2; ++i) fields.push_back(randomField<2>(random, turn.mesh->vertexCount()));
    const auto before = fields;
    solver.turn(turn.mesh->points, to, fields);
    for (int i = 0; i < 2; ++i) QVERIFY((fields[i] - R * before[i]).cwiseAbs().maxCoeff() < 1e-12);
}

void TestSolverReuse::historyFitsPrescribed() {
    std::mt19937 random(2);
    const Points3 response1 = randomField<3>(random, 9), response2 = randomField<3>(random, 9);
    const auto velocity = [&](const Points3& p) { return Points3(p(0) * response1 + p(1) * response2); };
    VelocityHistory<3> history;
    QVERIFY(!history.fitting(Points3::Ones(3, 1)).has_value());
    const std::vector<Vec3> directions = {{1, 0, 0}, {0.5, 0.5, 0}, {2, 0, 0}};
    double t = 0;
    for (const auto& p : directions) history.record(t += 1, p, velocity(p));
    const Vec3 p{-1, 3, 0};
    QVERIFY((*history.fitting(p) - velocity(p)).cwiseAbs().maxCoeff() <= 1e-12);
    QVERIFY(!history.fitting(Points3::Ones(3, 2)).has_value());
}

void TestSolverReuse::policyRefactorizes() {
    RefactorPolicy policy;
    policy.setCosts(10, 1);
    QVERIFY(!policy.due());
    for (int i = 0; i < 4; ++i) policy.evaluated(1);
    QVERIFY(!policy.due());  // (1 + ½) · 4 < 10 + 4
    policy.evaluated(3);
    QVERIFY(policy.due());  // (3 + ½) · 5 > 10 + 7
    policy.factorized();
    QVERIFY(!policy.due());
    QVERIFY(policy.hopeless(16) && !policy.hopeless(14));
    policy.setLongestPause(20);
    for (int i = 0; i < 21; ++i) policy.evaluated(3);
    QVERIFY(policy.due() && !policy.keepsPace());  // a factor of 10 is no long pause
    policy.setLongestPause(5);
    QVERIFY(policy.due() && policy.keepsPace());  // but here: 3 > 0.15 · 10
    policy.evaluated(1);
    QVERIFY(!policy.due());  // whatever was before
}

QTEST_GUILESS_MAIN(TestSolverReuse)
#include "test_solver_reuse.moc"
