// Conjugate gradients with multigrid against the direct solve, the coarse matrix against the energy, and the
// choice between the two solvers.
#include <QTest>
#include <csignal>
#include <cstring>

#include "core/assembly/cpu_back_end.h"
#include "core/solver/multigrid/galerkin.h"
#include "core/solver/solver_choice.h"
#include "core/solver/velocity_solver.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestMultigrid : public QObject {
    Q_OBJECT
  private slots:
    void signalsStayAsTheyWere();
    void fieldsAreThoseOfTheDirectSolver_data();
    void fieldsAreThoseOfTheDirectSolver();
    void constraintsOfAllKinds();
    void fewConstraints();
    void thinCells();
    void sameBitsForAnyThreads();
    void memoryGoesOnToTheSameBits();
    void coarseMatrixIsTheEnergy();
    void rigidMotionsCostNothing();
    void theChoiceFollowsFromSizeAndMemory();
};

namespace {

#define NEEDS_MODULE() \
    if (!hasAlgebraicHierarchy()) QSKIP("built without PETSc")

constexpr double kTolerance = 1e-4;

ConstraintRow fixed(int vertex) {
    return {{{vertex, 1.0}}};
}

/// A task for both solvers.
template <int Dim>
struct Task {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh;
    std::shared_ptr<const Material<Dim>> material;
    std::vector<ConstraintRow> rows;
    Sliders sliders;
    Points<Dim> prescribed;

    VelocitySolver<Dim> solver(SolverKind kind, double tolerance, int threads = 1) const {
        VelocitySolver<Dim> result(mesh, material, BackEndKind::Cpu, threads, kind);
        result.setVelocityTolerance(tolerance);
        result.setConstraints(rows, sliders);
        return result;
    }
    /// Largest difference of the fields, relative to the largest velocity; infinite if one fails.
    double difference() const {
        Points<Dim> direct, v;
        auto reference = solver(SolverKind::Direct, 0), multigrid = solver(SolverKind::Multigrid, kTolerance);
        if (!reference.solve(mesh->points, prescribed, direct).done() ||
            !multigrid.solve(mesh->points, prescribed, v).done())
            return std::numeric_limits<double>::infinity();
        return (v - direct).cwiseAbs().maxCoeff() / direct.cwiseAbs().maxCoeff();
    }
};

/// A grid held at one side, while some points of the other move anyhow.
template <int Dim>
Task<Dim> sheared(Material<Dim> material, SimplicialMesh<Dim> mesh) {
    Task<Dim> task;
    std::mt19937 random(3);
    task.mesh = std::make_shared<const SimplicialMesh<Dim>>(std::move(mesh));
    task.material = std::make_shared<const Material<Dim>>(std::move(material));
    const auto& points = task.mesh->points;
    const double high = points.row(0).maxCoeff(), low = points.row(0).minCoeff();
    std::vector<Vec<Dim>> velocities;
    for (int v = 0; v < task.mesh->vertexCount(); ++v) {
        const double x = (points(0, v) - low) / (high - low);
        if (x > 0.02 && x < 0.98) continue;
        task.rows.push_back(fixed(v));
        velocities.push_back(x < 0.5 ? Vec<Dim>(Vec<Dim>::Zero()) : Vec<Dim>(randomMatrix<Dim, 1>(random)));
    }
    task.prescribed.resize(Dim, static_cast<Eigen::Index>(velocities.size()));
    for (std::size_t i = 0; i < velocities.size(); ++i)
        task.prescribed.col(static_cast<Eigen::Index>(i)) = velocities[i];
    return task;
}

template <int Dim>
SimplicialMesh<Dim> grid(double jitter = 0.15) {
    std::mt19937 random(2);
    return unitGrid<Dim>(Dim == 2 ? 30 : 9, jitter, random);
}

template <int Dim>
Task<Dim> shearedUniform(double phi, Smoothing smoothing = {}) {
    auto mesh = grid<Dim>();
    auto material = Material<Dim>::uniform(mesh.cellCount(), phi, smoothing);
    return sheared<Dim>(std::move(material), std::move(mesh));
}

template <int Dim>
void compare(const QString& energy) {
    if (energy == "anisotropic") {
        std::mt19937 random(5);
        auto mesh = grid<Dim>();
        auto material = randomMaterial<Dim>(random, mesh.cellCount(), {});
        QVERIFY(sheared<Dim>(std::move(material), std::move(mesh)).difference() < 4 * kTolerance);
        return;
    }
    const double phi = energy == "EQUIA"  ? phi::kEquia
                       : energy == "AKVF" ? phi::kAkvf
                       : energy == "CONF" ? phi::conformal(Dim)
                                          : phi::kMetr;
    Smoothing smoothing;
    if (energy == "paper") smoothing.kind = SmoothingKind::Paper;
    if (energy == "none") smoothing.kind = SmoothingKind::None;
    const double difference = shearedUniform<Dim>(phi, smoothing).difference();
    QVERIFY2(difference < 4 * kTolerance, qPrintable(QString::number(difference)));
}

}  // namespace

void TestMultigrid::fieldsAreThoseOfTheDirectSolver_data() {
    QTest::addColumn<QString>("energy");
    for (const char* energy : {"METR", "EQUIA", "AKVF", "CONF", "paper", "none", "anisotropic"})
        QTest::newRow(energy) << energy;
}

/// The error is estimated: at EQUIA, the worst here, as a third of what it is.
void TestMultigrid::fieldsAreThoseOfTheDirectSolver() {
    NEEDS_MODULE();
    QFETCH(QString, energy);
    compare<2>(energy);
    compare<3>(energy);
}

/// Points within cells, which depend on each other, and vertices that slide.
void TestMultigrid::constraintsOfAllKinds() {
    NEEDS_MODULE();
    auto task = shearedUniform<3>(phi::kMetr);
    const auto& cells = task.mesh->cells;
    for (const int c : {1000, 1001, 1002})
        task.rows.push_back(
            {{{cells[c][0], 0.4}, {cells[c][1], 0.3}, {cells[c][2], 0.2}, {cells[c][3], 0.1}}});
    const auto before = task.prescribed.cols();
    task.prescribed.conservativeResize(3, before + 3);
    task.prescribed.rightCols(3).setConstant(0.2);
    for (int v = 0; v < task.mesh->vertexCount(); ++v)
        if (task.mesh->points(1, v) < 0.01) task.sliders.emplace_back(v, 2U);
    const double difference = task.difference();
    QVERIFY2(difference < 4 * kTolerance, qPrintable(QString::number(difference)));
}

/// What one point leaves free is settled by the mass matrix.
void TestMultigrid::fewConstraints() {
    NEEDS_MODULE();
    auto task = shearedUniform<3>(phi::kMetr);
    task.rows = {fixed(0)};
    task.prescribed = Points<3>::Constant(3, 1, 1.0);
    QVERIFY(task.difference() < 10 * kTolerance);
}

/// Cells a hundredth as high as they are wide.
void TestMultigrid::thinCells() {
    NEEDS_MODULE();
    auto mesh = grid<3>();
    for (auto& z : mesh.points.row(2)) z *= 0.01;
    auto material = Material<3>::uniform(mesh.cellCount(), phi::kMetr);
    const double difference = sheared<3>(std::move(material), std::move(mesh)).difference();
    QVERIFY2(difference < 10 * kTolerance, qPrintable(QString::number(difference)));
}

void TestMultigrid::sameBitsForAnyThreads() {
    NEEDS_MODULE();
    std::mt19937 random(2);
    auto mesh = unitGrid<3>(15, 0.15, random);
    auto material = Material<3>::uniform(mesh.cellCount(), phi::kMetr);
    const auto task = sheared<3>(std::move(material), std::move(mesh));
    Points<3> first;
    for (const int threads : {1, 2, 3}) {
        Points<3> v;
        QVERIFY(task.solver(SolverKind::Multigrid, 1e-3, threads)
                    .solve(task.mesh->points, task.prescribed, v)
                    .done());
        if (threads == 1) first = v;
        QVERIFY(std::memcmp(first.data(), v.data(), 8 * v.size()) == 0);
    }
}

/// Levels of an earlier shape serve, and are made again from what is remembered.
void TestMultigrid::memoryGoesOnToTheSameBits() {
    NEEDS_MODULE();
    const auto task = shearedUniform<3>(phi::kMetr);
    auto solver = task.solver(SolverKind::Multigrid, kTolerance);
    Points<3> v, other;
    QVERIFY(solver.solve(task.mesh->points, task.prescribed, v).done());
    const auto memory = solver.remember();
    const Points<3> moved = task.mesh->points + 0.01 * v;
    QVERIFY(solver.solve(moved, task.prescribed, v).done());
    QCOMPARE(solver.statistics().factorizations, 1);
    auto again = task.solver(SolverKind::Multigrid, kTolerance);
    again.recall(memory);
    QVERIFY(again.solve(moved, task.prescribed, other).done());
    QVERIFY(std::memcmp(v.data(), other.data(), 8 * v.size()) == 0);
}

namespace {

template <int Dim>
struct Coarse {
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::unique_ptr<BackEnd<Dim>> backEnd;
    CoarseSpace<Dim> space;
    Galerkin<Dim> galerkin;

    Coarse(const SimplicialMesh<Dim>& mesh, const Material<Dim>& material) {
        plan =
            std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan<Dim>(mesh, true, Contributions::Left));
        backEnd = makeCpuBackEnd<Dim>(plan, mesh, material, 1);
        const std::vector<double> epsilon(mesh.cells.size(), 0.5);
        backEnd->setMassRegularization(epsilon);
        backEnd->setShape(mesh.points);
        typename CoarseSpace<Dim>::Unknowns all;
        all.isUnknown.assign(mesh.vertexCount(), 1);
        for (int v = 0; v < mesh.vertexCount(); ++v) all.vertices.push_back(v);
        space.analyze(plan, all);
        galerkin.analyze(space);
        LocalForms<Dim> forms(plan, std::make_shared<const SimplicialMesh<Dim>>(mesh), material);
        forms.setShape(std::make_shared<const Points<Dim>>(mesh.points));
        forms.setMassRegularization(epsilon);
        space.build(forms, backEnd->workers());
        galerkin.build(space, forms, backEnd->workers(), {});
    }
    Points<Dim> field(const std::vector<double>& coarse) {
        Points<Dim> v = Points<Dim>::Zero(Dim, plan->vertexCount);
        space.prolong(coarse, v, backEnd->workers());
        return v;
    }
    double square(const std::vector<double>& coarse) const {
        const BlockMatrix& A = galerkin.matrix();
        double sum = 0;
        for (int row = 0; row < A.rows(); ++row)
            for (int b = A.start[row]; b < A.start[row + 1]; ++b)
                for (int j = 0; j < A.blockSize; ++j)
                    for (int i = 0; i < A.blockSize; ++i)
                        sum += A.values[b * A.blockEntries() + j * A.blockSize + i] *
                               coarse[row * A.blockSize + i] * coarse[A.column[b] * A.blockSize + j];
        return sum;
    }
};

template <int Dim>
void compareWithEnergy() {
    std::mt19937 random(9);
    const auto mesh = unitGrid<Dim>(Dim == 2 ? 12 : 5, 0.1, random);
    Coarse<Dim> coarse(mesh, randomMaterial<Dim>(random, mesh.cellCount(), {}));
    std::vector<double> c(static_cast<std::size_t>(coarse.space.aggregates()) * CoarseSpace<Dim>::kModes);
    for (auto& x : c) x = uniform(random, -1, 1);
    const Points<Dim> v = coarse.field(c);
    Points<Dim> Av;
    coarse.backEnd->apply(v, Av);
    const double fine = v.cwiseProduct(Av).sum();
    QVERIFY(std::abs(coarse.square(c) - fine) < 1e-12 * fine);
}

template <int Dim>
void compareRigidMotions() {
    std::mt19937 random(10);
    const auto mesh = unitGrid<Dim>(Dim == 2 ? 12 : 5, 0.1, random);
    Coarse<Dim> coarse(mesh, Material<Dim>::uniform(mesh.cellCount(), phi::kMetr));
    const auto motions = coarse.space.rigidMotions();
    const std::size_t length = motions.size() / CoarseSpace<Dim>::kModes;
    const std::vector<double> last(motions.end() - static_cast<std::ptrdiff_t>(length), motions.end());
    Points<Dim> expected = Points<Dim>::Zero(Dim, mesh.vertexCount());
    expected.row(Dim - 2) = -mesh.points.row(Dim - 1);
    expected.row(Dim - 1) = mesh.points.row(Dim - 2);
    // P is in single precision.
    QVERIFY((coarse.field(last) - expected).cwiseAbs().maxCoeff() < 1e-5);
}

}  // namespace

/// cᵀ (Pᵀ A P) c = (P c)ᵀ A (P c), with everything different in every cell.
void TestMultigrid::coarseMatrixIsTheEnergy() {
    compareWithEnergy<2>();
    compareWithEnergy<3>();
}

/// The last of them is the rotation of the last two axes.
void TestMultigrid::rigidMotionsCostNothing() {
    compareRigidMotions<2>();
    compareRigidMotions<3>();
}

void TestMultigrid::theChoiceFollowsFromSizeAndMemory() {
    constexpr double kGigabyte = 1e9;
    QCOMPARE(chosenSolver(SolverKind::Direct, 3, 1000000, kGigabyte), SolverKind::Direct);
    QCOMPARE(chosenSolver(SolverKind::Multigrid, 2, 10, 1000 * kGigabyte), SolverKind::Multigrid);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 3, 5000, 8 * kGigabyte), SolverKind::Direct);
    NEEDS_MODULE();
    QCOMPARE(chosenSolver(SolverKind::Automatic, 3, 1000000, 64 * kGigabyte), SolverKind::Multigrid);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 2, 300000, 64 * kGigabyte), SolverKind::Direct);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 2, 300000, 2 * kGigabyte), SolverKind::Multigrid);
}

/// PETSc and MPI put handlers of their own where they begin, which is in this test.
void TestMultigrid::signalsStayAsTheyWere() {
    NEEDS_MODULE();
    constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP, SIGABRT, SIGSEGV, SIGFPE, SIGUSR1};
    const auto handlers = [&] {
        std::array<void (*)(int), kSignals.size()> result{};
        for (std::size_t i = 0; i < kSignals.size(); ++i) {
            struct sigaction action {};
            sigaction(kSignals[i], nullptr, &action);
            result[i] = action.sa_handler;
        }
        return result;
    };
    const auto before = handlers();
    const auto task = shearedUniform<2>(phi::kMetr);
    Points<2> v;
    QVERIFY(task.solver(SolverKind::Multigrid, 1e-3).solve(task.mesh->points, task.prescribed, v).done());
    QVERIFY(handlers() == before);
}

QTEST_APPLESS_MAIN(TestMultigrid)
#include "test_multigrid.moc"
