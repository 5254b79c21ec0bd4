// Conjugate gradients with multigrid against the direct solve, the matrices of its levels against the energy,
// and the choice between the two solvers.
#include <QTest>
#include <cstring>

#include "core/assembly/cpu_back_end.h"
#include "core/solver/multigrid/coarse_matrix.h"
#include "core/solver/multigrid/reduced_matrix.h"
#include "core/solver/solver_choice.h"
#include "core/solver/velocity_solver.h"
#include "tests/core/test_energy_samples.h"
#include "tests/support/simd_targets.h"

using namespace wend;
using namespace wend::test;

class TestMultigrid : public QObject {
    Q_OBJECT
  private slots:
    void fieldsAreThoseOfTheDirectSolver_data();
    void fieldsAreThoseOfTheDirectSolver();
    void constraintsOfAllKinds();
    void fewConstraints();
    void thinCells();
    void sameBitsForAnyThreads();
    void memoryGoesOnToTheSameBits();
    void productsAreThoseOfTheBackEnd();
    void coarseMatrixIsTheEnergy();
    void linearFieldsAreCoarse();
    void theChoiceFollowsFromSizeAndMemory();
};

namespace {

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

/// A grid is held at one side, while some points of the other move arbitrarily.
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

/// The error is estimated: at EQUIA, the worst case here, as a third of its true value.
void TestMultigrid::fieldsAreThoseOfTheDirectSolver() {
    QFETCH(QString, energy);
    compare<2>(energy);
    compare<3>(energy);
}

/// The constraints include points within cells, which depend on each other, and sliding vertices.
void TestMultigrid::constraintsOfAllKinds() {
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

/// The mass matrix determines the motion that one point leaves free.
void TestMultigrid::fewConstraints() {
    auto task = shearedUniform<3>(phi::kMetr);
    task.rows = {fixed(0)};
    task.prescribed = Points3::Constant(3, 1, 1.0);
    QVERIFY(task.difference() < 10 * kTolerance);
}

/// The cells are a hundredth as high as they are wide.
void TestMultigrid::thinCells() {
    auto mesh = grid<3>();
    for (auto& z : mesh.points.row(2)) z *= 0.01;
    auto material = Material<3>::uniform(mesh.cellCount(), phi::kMetr);
    const double difference = sheared<3>(std::move(material), std::move(mesh)).difference();
    QVERIFY2(difference < 10 * kTolerance, qPrintable(QString::number(difference)));
}

void TestMultigrid::sameBitsForAnyThreads() {
    std::mt19937 random(2);
    auto mesh = unitGrid<3>(15, 0.15, random);
    auto material = Material<3>::uniform(mesh.cellCount(), phi::kMetr);
    const auto task = sheared<3>(std::move(material), std::move(mesh));
    Points3 first;
    for (const int threads : {1, 2, 3}) {
        Points3 v;
        QVERIFY(task.solver(SolverKind::Multigrid, 1e-3, threads)
                    .solve(task.mesh->points, task.prescribed, v)
                    .done());
        if (threads == 1) first = v;
        QVERIFY(std::memcmp(first.data(), v.data(), 8 * v.size()) == 0);
    }
}

/// Levels of an earlier shape are reused, and are made again from the remembered data.
void TestMultigrid::memoryGoesOnToTheSameBits() {
    const auto task = shearedUniform<3>(phi::kMetr);
    auto solver = task.solver(SolverKind::Multigrid, kTolerance);
    Points3 v, other;
    QVERIFY(solver.solve(task.mesh->points, task.prescribed, v).done());
    const auto memory = solver.remember();
    const Points3 moved = task.mesh->points + 0.01 * v;
    QVERIFY(solver.solve(moved, task.prescribed, v).done());
    QCOMPARE(solver.statistics().factorizations, 1);
    auto again = task.solver(SolverKind::Multigrid, kTolerance);
    again.recall(memory);
    QVERIFY(again.solve(moved, task.prescribed, other).done());
    QVERIFY(std::memcmp(v.data(), other.data(), 8 * v.size()) == 0);
}

namespace {

/// K of a grid whose cells are all different, with a mass in places, points within cells and vertices that
/// slide.
template <int Dim>
struct Fine {
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::unique_ptr<BackEnd<Dim>> backEnd;
    ReducedSystem<Dim> system;
    ReducedMatrix<Dim> matrix;

    Fine(const SimplicialMesh<Dim>& mesh, const Material<Dim>& material, bool constrained) {
        const bool smoothing = material.smoothing.kind != SmoothingKind::None;
        plan = std::make_shared<const AssemblyPlan<Dim>>(
            makeAssemblyPlan<Dim>(mesh, smoothing, Contributions::Left));
        backEnd = makeCpuBackEnd<Dim>(plan, mesh, material, 1);
        std::vector<double> epsilon(mesh.cells.size(), 0.5);
        std::fill(epsilon.begin(), epsilon.begin() + 7, 0.0);
        backEnd->setMassRegularization(epsilon);
        backEnd->setShape(mesh.points);
        std::vector<ConstraintRow> rows;
        Sliders sliders;
        if (constrained) {
            rows = {fixed(0), fixed(3)};
            for (const int c : {20, 21, 22}) {
                rows.emplace_back();
                for (int k = 0; k <= Dim; ++k)
                    rows.back().terms.emplace_back(mesh.cells[c][k], 0.1 * (k + 1));
            }
            sliders = {{mesh.vertexCount() - 1, 1U}, {mesh.vertexCount() - 2, 2U}};
        }
        system = ReducedSystem<Dim>(*plan, eliminate(simplified(rows), sliders), sliders);
        matrix.analyze(*plan, system, static_cast<int>(system.unknowns().size()), backEnd->workers());
        matrix.build(*backEnd);
    }
    /// Computes the product without the matrix.
    Points<Dim> product(const Points<Dim>& x) const {
        Points<Dim> lifted = Points<Dim>::Zero(Dim, plan->vertexCount), Alifted, Kx;
        system.expand(x, lifted);
        backEnd->apply(lifted, Alifted);
        system.restrict(Alifted, Kx);
        return Kx;
    }
    Points<Dim> field(std::mt19937& random) const {
        auto x = randomField<Dim>(random, static_cast<int>(system.unknowns().size()));
        for (std::size_t i = 0; i < system.held().size(); ++i)
            for (int k = 0; k < Dim; ++k)
                if (system.held()[i] >> k & 1U) x(k, static_cast<Eigen::Index>(i)) = 0;
        return x;
    }
};

template <int Dim>
SimplicialMesh<Dim> smallGrid(std::mt19937& random) {
    return unitGrid<Dim>(Dim == 2 ? 12 : 5, 0.1, random);
}

template <int Dim>
void compareProducts(const Material<Dim>& material, const SimplicialMesh<Dim>& mesh) {
    std::mt19937 random(4);
    const Fine<Dim> fine(mesh, material, true);
    const Points<Dim> x = fine.field(random), expected = fine.product(x);
    const auto& K = fine.matrix.blocks();
    Points<Dim> Kx(Dim, K.rows());
    K.multiply(x, 0, 10, Kx.data());
    K.multiply(x, 10, K.rows(), Kx.data() + static_cast<std::ptrdiff_t>(10) * Dim);
    for (std::size_t i = 0; i < fine.system.held().size(); ++i)
        for (int k = 0; k < Dim; ++k)
            if (fine.system.held()[i] >> k & 1U) Kx(k, static_cast<Eigen::Index>(i)) = 0;
    // Entries are in single precision.
    QVERIFY((Kx - expected).cwiseAbs().maxCoeff() < 1e-5 * expected.cwiseAbs().maxCoeff());
}

template <int Dim>
void compareAllProducts() {
    for (const auto kind : {SmoothingKind::Invariant, SmoothingKind::Paper, SmoothingKind::None}) {
        std::mt19937 random(9);
        const auto mesh = smallGrid<Dim>(random);
        Smoothing smoothing;
        smoothing.kind = kind;
        auto material = randomMaterial<Dim>(random, mesh.cellCount(), smoothing);
        compareProducts<Dim>(material, mesh);
        material.anisotropy.clear();  // another back end
        compareProducts<Dim>(material, mesh);
    }
}

template <int Dim>
struct TwoLevels : Fine<Dim> {
    static constexpr int kModes = Dim * (Dim + 1);
    Chebyshev<Dim> smoother;
    Prolongation<Dim, kModes> P;
    std::vector<typename Prolongation<Dim, kModes>::Square> coarseMotions;
    BlockRows<kModes> coarse;

    TwoLevels(const SimplicialMesh<Dim>& mesh, const Material<Dim>& material)
        : Fine<Dim>(mesh, material, false) {
        auto& workers = this->backEnd->workers();
        const auto& K = this->matrix.blocks();
        smoother.prepare(K, {}, {}, workers);
        std::vector<typename Prolongation<Dim, kModes>::Motions> motions(K.rows());
        for (int i = 0; i < K.rows(); ++i) {
            motions[i].template leftCols<Dim>().setIdentity();
            for (int a = 0; a < Dim; ++a)
                motions[i].template middleCols<Dim>(Dim * (a + 1)) = mesh.points(a, i) * Mat<Dim>::Identity();
        }
        coarseMotions =
            P.build(aggregatesOf(graphOf<Dim>(*this->plan, this->system)), motions, K, smoother, workers);
        coarse = coarseMatrix<kModes>(coarseShare<Dim, kModes>(K, P, workers));
    }
};

template <int Dim>
void compareWithEnergy() {
    std::mt19937 random(9);
    const auto mesh = smallGrid<Dim>(random);
    TwoLevels<Dim> levels(mesh, randomMaterial<Dim>(random, mesh.cellCount(), {}));
    constexpr int kModes = TwoLevels<Dim>::kModes;
    const auto c = randomField<kModes>(random, levels.P.aggregates());
    Points<Dim> v(Dim, mesh.vertexCount());
    levels.P.prolong(c, v, levels.backEnd->workers());
    const double fine = v.cwiseProduct(levels.product(v)).sum();
    Points<kModes> Ac(kModes, c.cols());
    levels.coarse.multiply(c, 0, levels.coarse.rows(), Ac.data());
    // All entries are in single precision.
    QVERIFY(std::abs(c.cwiseProduct(Ac).sum() - fine) < 1e-5 * fine);
}

/// In the plane with the mass matrix alone, the smoothed part of a field is the part that the energy sees.
template <int Dim>
void compareLinearFields() {
    std::mt19937 random(10);
    const auto mesh = smallGrid<Dim>(random);
    TwoLevels<Dim> levels(mesh, Material<Dim>::uniform(mesh.cellCount(), phi::kMetr));
    constexpr int kModes = TwoLevels<Dim>::kModes;
    for (const int mode : {0, Dim, kModes - 1}) {
        Points<kModes> c(kModes, levels.P.aggregates());
        for (int a = 0; a < levels.P.aggregates(); ++a) c.col(a) = levels.coarseMotions[a].col(mode);
        Points<Dim> v(Dim, mesh.vertexCount()), expected = Points<Dim>::Zero(Dim, mesh.vertexCount());
        levels.P.prolong(c, v, levels.backEnd->workers());
        if (mode < Dim)
            expected.row(mode).setOnes();
        else
            expected.row(mode % Dim) = mesh.points.row(mode / Dim - 1);
        // One step of Jacobi's method.
        Points<Dim> smoothed = levels.product(expected);
        for (int i = 0; i < mesh.vertexCount(); ++i)
            smoothed.col(i) = expected.col(i) - 4.0 / 3 / levels.smoother.largest() *
                                                    levels.smoother.inverse(i).template cast<double>() *
                                                    smoothed.col(i);
        QVERIFY((v - smoothed).cwiseAbs().maxCoeff() < 1e-4);
    }
}

}  // namespace

/// Rows are sums of contributions around their vertices, the back end's product is made of stresses.
void TestMultigrid::productsAreThoseOfTheBackEnd() {
    onEveryTarget([](SimdTarget) {
        compareAllProducts<2>();
        compareAllProducts<3>();
    });
}

/// cᵀ (Pᵀ K P) c = (P c)ᵀ K (P c), with everything different in every cell.
void TestMultigrid::coarseMatrixIsTheEnergy() {
    onEveryTarget([](SimdTarget) {
        compareWithEnergy<2>();
        compareWithEnergy<3>();
    });
}

/// Linear fields are coarse, except for the step that makes them smooth.
void TestMultigrid::linearFieldsAreCoarse() {
    compareLinearFields<2>();
    compareLinearFields<3>();
}

void TestMultigrid::theChoiceFollowsFromSizeAndMemory() {
    constexpr double kGigabyte = 1e9;
    QCOMPARE(chosenSolver(SolverKind::Direct, 3, 1000000, kGigabyte), SolverKind::Direct);
    QCOMPARE(chosenSolver(SolverKind::Multigrid, 2, 10, 1000 * kGigabyte), SolverKind::Multigrid);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 3, 5000, 8 * kGigabyte), SolverKind::Direct);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 3, 1000000, 64 * kGigabyte), SolverKind::Multigrid);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 2, 300000, 64 * kGigabyte), SolverKind::Direct);
    QCOMPARE(chosenSolver(SolverKind::Automatic, 2, 300000, 2 * kGigabyte), SolverKind::Multigrid);
}

QTEST_APPLESS_MAIN(TestMultigrid)
#include "test_multigrid.moc"
