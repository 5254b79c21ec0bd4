// The velocity solver against dense references and identities, one body for 2D and 3D.
#include <Eigen/Dense>
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/energy/cell_energy.h"
#include "core/solver/velocity_solver.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

namespace {

template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> share(SimplicialMesh<Dim> mesh) {
    return std::make_shared<const SimplicialMesh<Dim>>(std::move(mesh));
}

template <int Dim>
std::shared_ptr<const Material<Dim>> share(Material<Dim> material) {
    return std::make_shared<const Material<Dim>>(std::move(material));
}

template <int Dim>
std::shared_ptr<const Material<Dim>> metr(const SimplicialMesh<Dim>& mesh) {
    return share<Dim>(Material<Dim>::uniform(mesh.cellCount(), phi::kMetr));
}

ConstraintRow fixed(int vertex) {
    return {{{vertex, 1.0}}};
}

/// A point inside a cell.
template <int Dim>
ConstraintRow inside(const SimplicialMesh<Dim>& mesh, int cell, std::mt19937& random) {
    ConstraintRow row;
    double left = 1;
    for (int k = 0; k < Dim; ++k) {
        const double weight = left * uniform(random, 0.1, 0.6);
        row.terms.emplace_back(mesh.cells[cell][k], weight);
        left -= weight;
    }
    row.terms.emplace_back(mesh.cells[cell][Dim], left);
    return row;
}

template <int Dim>
Vec<Dim> valueOf(const ConstraintRow& row, const Points<Dim>& field) {
    Vec<Dim> value = Vec<Dim>::Zero();
    for (const auto& [vertex, weight] : row.terms) value += weight * field.col(vertex);
    return value;
}

/// A as a dense matrix, column by column from the matrix-free product, with the solver's mass regularization
/// if asked.
template <int Dim>
Eigen::MatrixXd denseMatrix(const SimplicialMesh<Dim>& mesh, const Material<Dim>& material,
                            const Points<Dim>& shape, double massRegularization = 0) {
    const bool smoothing = material.smoothing.kind != SmoothingKind::None;
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(mesh, smoothing));
    const auto backEnd = makeCpuBackEnd<Dim>(plan, mesh, material, 1);
    if (massRegularization > 0)
        backEnd->setMassRegularization(std::vector<double>(mesh.cells.size(), massRegularization));
    backEnd->setShape(shape);
    const int n = Dim * mesh.vertexCount();
    Eigen::MatrixXd A(n, n);
    Points<Dim> v, Av;
    for (int i = 0; i < n; ++i) {
        v.setZero(Dim, mesh.vertexCount());
        v.data()[i] = 1;
        backEnd->apply(v, Av);
        A.col(i) = Av.reshaped();
    }
    return A;
}

/// The rows as a matrix on the flat vector of velocities.
template <int Dim>
Eigen::MatrixXd denseRows(const std::vector<ConstraintRow>& rows, int vertexCount) {
    Eigen::MatrixXd W = Eigen::MatrixXd::Zero(Dim * static_cast<int>(rows.size()), Dim * vertexCount);
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const auto& [vertex, weight] : rows[r].terms)
            for (int k = 0; k < Dim; ++k) W(Dim * static_cast<int>(r) + k, Dim * vertex + k) += weight;
    return W;
}

/// Returns min vᵀ A v subject to W v = p by Lagrange multipliers.
Eigen::VectorXd saddlePoint(const Eigen::MatrixXd& A, const Eigen::MatrixXd& W, const Eigen::VectorXd& p) {
    const Eigen::Index n = A.rows(), m = W.rows();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
    system.topLeftCorner(n, n) = A;
    system.topRightCorner(n, m) = W.transpose();
    system.bottomLeftCorner(m, n) = W;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
    right.tail(m) = p;
    return system.fullPivLu().solve(right).head(n);
}

template <int Dim>
struct Scene {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh;
    std::shared_ptr<const Material<Dim>> material;
    Points<Dim> shape;
    std::vector<ConstraintRow> rows;
    Points<Dim> prescribed;
};

/// Random material; fixed vertices, points in cells (two of them next to each other, one next to a fixed
/// vertex).
template <int Dim>
Scene<Dim> mixedScene(std::mt19937& random, Smoothing smoothing = {}) {
    Scene<Dim> scene;
    scene.mesh = share<Dim>(unitGrid<Dim>(Dim == 2 ? 6 : 2, 0.1, random));
    scene.material = share<Dim>(randomMaterial<Dim>(random, scene.mesh->cellCount(), smoothing));
    scene.shape = scene.mesh->points + 0.01 * randomField<Dim>(random, scene.mesh->vertexCount());
    const int last = scene.mesh->cellCount() - 1;
    scene.rows = {fixed(0),
                  fixed(1),
                  fixed(scene.mesh->vertexCount() - 1),
                  inside<Dim>(*scene.mesh, last / 2, random),
                  inside<Dim>(*scene.mesh, last / 2 + 1, random),
                  inside<Dim>(*scene.mesh, 0, random)};
    scene.prescribed = randomField<Dim>(random, static_cast<int>(scene.rows.size()));
    return scene;
}

double relative(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

template <int Dim>
void agreesWithDenseReference() {
    std::mt19937 random(5 + Dim);
    for (const auto kind : {SmoothingKind::Invariant, SmoothingKind::Paper, SmoothingKind::None}) {
        auto scene = mixedScene<Dim>(random, {kind, 0.05, 0.1});
        VelocitySolver<Dim> solver(scene.mesh, scene.material, BackEndKind::Cpu, 1);
        solver.setConstraints(scene.rows);
        Points<Dim> v;
        QVERIFY(solver.solve(scene.shape, scene.prescribed, v).done());

        const Eigen::MatrixXd A = denseMatrix<Dim>(*scene.mesh, *scene.material, scene.shape);
        const Eigen::MatrixXd W = denseRows<Dim>(scene.rows, scene.mesh->vertexCount());
        const Eigen::VectorXd expected = saddlePoint(A, W, scene.prescribed.reshaped());
        QVERIFY(relative(v.reshaped(), expected) < 1e-9);  // condition number times rounding
        const double energy = expected.dot(A * expected);
        QVERIFY(std::abs(solver.energy() - energy) < 1e-9 * energy);
    }
}

/// Some vertices are held in some coordinates only, which are rows of one scalar in the dense system. One of
/// them is a corner of a cell with a constrained point. The solve is direct, or uses the factor of another
/// shape.
template <int Dim>
void slidersAgreeWithDenseReference() {
    std::mt19937 random(15 + Dim);
    auto scene = mixedScene<Dim>(random);
    const int count = scene.mesh->vertexCount();
    // Some corner of a cell with a point must not slide.
    const Cell<Dim>& first = scene.mesh->cells.front();
    const auto isFree = [&](int v) {
        return v > 1 && v < count - 1 && std::find(first.begin(), first.end(), v) == first.end();
    };
    Sliders sliders;
    for (const int vertex : scene.mesh->cells[static_cast<std::size_t>(scene.mesh->cellCount() - 1) / 2])
        if (sliders.empty() && isFree(vertex)) sliders.push_back({vertex, 1U});
    for (const int vertex : {2, count / 3, count / 2})
        if (vertex != sliders.front().vertex && isFree(vertex))
            sliders.push_back({vertex, vertex == 2 ? 2U : 3U});
    VelocitySolver<Dim> solver(scene.mesh, scene.material, BackEndKind::Cpu, 1);
    solver.setConstraints(scene.rows, sliders);
    const Eigen::MatrixXd rows = denseRows<Dim>(scene.rows, count);
    Eigen::MatrixXd W = rows;
    for (const auto& [vertex, held, normal, isGuided] : sliders)
        for (int k = 0; k < Dim; ++k)
            if (held >> k & 1U) {
                W.conservativeResize(W.rows() + 1, Eigen::NoChange);
                W.bottomRows(1).setZero();
                W(W.rows() - 1, Dim * vertex + k) = 1;
            }
    Eigen::VectorXd prescribed = Eigen::VectorXd::Zero(W.rows());
    prescribed.head(rows.rows()) = scene.prescribed.reshaped();
    for (const double tolerance : {0.0, 1e-7}) {
        solver.setVelocityTolerance(tolerance);
        for (const double by : {0.0, 0.01}) {
            Points<Dim> v;
            const Points<Dim> shape = scene.shape + by * randomField<Dim>(random, count);
            QVERIFY(solver.solve(shape, scene.prescribed, v).done());
            const Eigen::MatrixXd A = denseMatrix<Dim>(*scene.mesh, *scene.material, shape);
            const double off = relative(v.reshaped(), saddlePoint(A, W, prescribed));
            QVERIFY2(
                off < std::max(1e-9, 2 * tolerance),
                qPrintable(QString("%1D, tolerance %2, by %3: %4").arg(Dim).arg(tolerance).arg(by).arg(off)));
            for (const auto& [vertex, held, normal, isGuided] : sliders)
                for (int k = 0; k < Dim; ++k)
                    if (held >> k & 1U) QCOMPARE(v(k, vertex), 0.0);
        }
    }
}

template <int Dim>
void constraintsHold() {
    std::mt19937 random(7 + Dim);
    auto scene = mixedScene<Dim>(random);
    VelocitySolver<Dim> solver(scene.mesh, scene.material, BackEndKind::Cpu, 1);
    solver.setConstraints(scene.rows);
    Points<Dim> v;
    QVERIFY(solver.solve(scene.shape, scene.prescribed, v).done());
    for (std::size_t r = 0; r < scene.rows.size(); ++r) {
        const Vec<Dim> expected = scene.prescribed.col(static_cast<int>(r));
        const Vec<Dim> value = valueOf<Dim>(scene.rows[r], v);
        if (scene.rows[r].terms.size() == 1)
            QCOMPARE(value, expected);  // to the bit
        else
            QVERIFY((value - expected).norm() < 1e-13 * v.cwiseAbs().maxCoeff());
    }
}

template <int Dim>
void reducedMatrixIsZtAZ() {
    std::mt19937 random(9 + Dim);
    auto scene = mixedScene<Dim>(random);
    VelocitySolver<Dim> solver(scene.mesh, scene.material, BackEndKind::Cpu, 1);
    solver.setConstraints(scene.rows);
    Points<Dim> v;
    QVERIFY(solver.solve(scene.shape, scene.prescribed, v).done());

    // Z from the rows alone: the unknown vertices are free, the others follow from W v = 0.
    const auto& unknowns = solver.unknownVertices();
    const int n = Dim * scene.mesh->vertexCount(), m = Dim * static_cast<int>(unknowns.size());
    const Eigen::MatrixXd W = denseRows<Dim>(scene.rows, scene.mesh->vertexCount());
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(n, m);
    std::vector<int> dependentColumns;
    for (int i = 0; i < n; ++i) {
        const auto at = std::find(unknowns.begin(), unknowns.end(), i / Dim);
        if (at == unknowns.end())
            dependentColumns.push_back(i);
        else
            free(i, Dim * static_cast<int>(at - unknowns.begin()) + i % Dim) = 1;
    }
    const Eigen::MatrixXd pivots = W(Eigen::all, dependentColumns).fullPivLu().solve(-W * free);
    Eigen::MatrixXd Z = free;
    Z(dependentColumns, Eigen::all) = pivots;
    const Eigen::MatrixXd A = denseMatrix<Dim>(*scene.mesh, *scene.material, scene.shape);
    const Eigen::MatrixXd K = Z.transpose() * A * Z;
    QVERIFY((solver.reducedMatrix() - K).cwiseAbs().maxCoeff() < 1e-12 * K.cwiseAbs().maxCoeff());
}

template <int Dim>
void projectionPutsPointsOnTargets() {
    std::mt19937 random(11 + Dim);
    auto scene = mixedScene<Dim>(random);
    VelocitySolver<Dim> solver(scene.mesh, scene.material, BackEndKind::Cpu, 1);
    solver.setConstraints(scene.rows);
    Points<Dim> targets(Dim, static_cast<int>(scene.rows.size()));
    for (std::size_t r = 0; r < scene.rows.size(); ++r)
        targets.col(static_cast<int>(r)) =
            valueOf<Dim>(scene.rows[r], scene.shape) + 0.01 * randomMatrix<Dim, 1>(random);
    Points<Dim> shape = scene.shape;
    solver.project(shape, targets);
    for (std::size_t r = 0; r < scene.rows.size(); ++r)
        QVERIFY((valueOf<Dim>(scene.rows[r], shape) - targets.col(static_cast<int>(r))).norm() < 1e-15);

    // The correction is the least of all that fit, by the pseudo-inverse.
    const Eigen::MatrixXd W = denseRows<Dim>(scene.rows, scene.mesh->vertexCount());
    const Eigen::VectorXd gap = targets.reshaped() - W * scene.shape.reshaped();
    const Eigen::VectorXd minimum = W.completeOrthogonalDecomposition().solve(gap);
    QVERIFY(relative((shape - scene.shape).reshaped(), minimum) < 1e-11);
}

template <int Dim>
void noConstraintsNoMotion() {
    std::mt19937 random(13);
    const auto mesh = share<Dim>(unitGrid<Dim>(3, 0.1, random));
    VelocitySolver<Dim> solver(mesh, metr<Dim>(*mesh), BackEndKind::Cpu, 1);
    Points<Dim> v;
    QVERIFY(solver.solve(mesh->points, Points<Dim>(Dim, 0), v).done());
    QVERIFY(v.cols() == mesh->vertexCount() && v.isZero(0));
    QCOMPARE(solver.energy(), 0.0);
}

/// ∫ f over the cells for f quadratic, exactly: by the consistent mass matrix of the products of nodal
/// values.
template <int Dim>
struct Moments {
    double mass = 0;
    Vec<Dim> first = Vec<Dim>::Zero();
    Mat<Dim> second = Mat<Dim>::Zero();  // ∫ x xᵀ

    explicit Moments(const SimplicialMesh<Dim>& mesh) {
        for (const auto& cell : mesh.cells) {
            const double V = cellMeasure<Dim>(mesh.points, cell), unit = V / ((Dim + 1) * (Dim + 2));
            mass += V;
            for (int p : cell) {
                first += V / (Dim + 1) * mesh.points.col(p);
                for (int q : cell)
                    second += (p == q ? 2 : 1) * unit * mesh.points.col(p) * mesh.points.col(q).transpose();
            }
        }
    }
};

/// The rigid motions of the plane or of space as Jacobians: a basis of the skew matrices.
template <int Dim>
std::vector<Mat<Dim>> skewBasis() {
    std::vector<Mat<Dim>> basis;
    for (int a = 0; a < Dim; ++a)
        for (int b = a + 1; b < Dim; ++b) {
            Mat<Dim> W = Mat<Dim>::Zero();
            W(a, b) = -1;
            W(b, a) = 1;
            basis.push_back(W);
        }
    return basis;
}

/// Closed form: of all v(x) = u + J (x − c) with J spanned by `basis` and v = prescribed at the points, the
/// one of least ∫|v|². Unknown (u, coefficients of J); a quadratic form with linear constraints.
template <int Dim>
Points<Dim> minNormMotion(const SimplicialMesh<Dim>& mesh, const std::vector<Mat<Dim>>& basis,
                          const std::vector<Vec<Dim>>& at, const Points<Dim>& prescribed) {
    const int n = Dim + static_cast<int>(basis.size());
    const Moments<Dim> moments(mesh);
    const auto column = [&](const Vec<Dim>& x) {
        Eigen::MatrixXd columns(Dim, n);
        columns.leftCols(Dim).setIdentity();
        for (std::size_t i = 0; i < basis.size(); ++i) columns.col(Dim + static_cast<int>(i)) = basis[i] * x;
        return columns;
    };
    Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(n, n);
    Q.topLeftCorner(Dim, Dim) = moments.mass * Mat<Dim>::Identity();
    for (std::size_t i = 0; i < basis.size(); ++i) {
        const int a = Dim + static_cast<int>(i);
        Q.col(a).head(Dim) = basis[i] * moments.first;
        Q.row(a).head(Dim) = Q.col(a).head(Dim).transpose();
        for (std::size_t j = 0; j < basis.size(); ++j)
            Q(a, Dim + static_cast<int>(j)) = (basis[i] * moments.second * basis[j].transpose()).trace();
    }
    Eigen::MatrixXd W(Dim * static_cast<int>(at.size()), n);
    for (std::size_t i = 0; i < at.size(); ++i) W.middleRows(Dim * static_cast<int>(i), Dim) = column(at[i]);
    // Dependent rows (two points of a rigid body keep their distance): the pseudo-inverse of the saddle
    // point.
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + W.rows(), n + W.rows());
    system.topLeftCorner(n, n) = Q;
    system.topRightCorner(n, W.rows()) = W.transpose();
    system.bottomLeftCorner(W.rows(), n) = W;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(system.rows());
    right.tail(W.rows()) = prescribed.reshaped();
    const Eigen::VectorXd motion = system.completeOrthogonalDecomposition().solve(right).head(n);
    Points<Dim> v(Dim, mesh.vertexCount());
    for (int i = 0; i < mesh.vertexCount(); ++i) v.col(i) = column(mesh.points.col(i)) * motion;
    return v;
}

template <int Dim>
void minNormDragging(double phiValue, int pointCount) {
    std::mt19937 random(17 + Dim);
    const auto mesh = share<Dim>(unitGrid<Dim>(Dim == 2 ? 8 : 4, 0.1, random));
    const auto material = share<Dim>(Material<Dim>::uniform(mesh->cellCount(), phiValue));
    auto basis = skewBasis<Dim>();
    if (phiValue > 2) basis.push_back(Mat<Dim>::Identity());  // φ_CONF: scaling is free as well
    // A rigid (or similar) motion at the points, so that least energy is 0 and only ∫|v|² decides.
    const Mat<Dim> J = randomSkew<Dim>(random);
    std::vector<ConstraintRow> rows{inside<Dim>(*mesh, 1, random)};
    if (pointCount == 2) rows.push_back(fixed(mesh->vertexCount() - 1));
    std::vector<Vec<Dim>> at;
    Points<Dim> prescribed(Dim, pointCount);
    for (int i = 0; i < pointCount; ++i) {
        at.push_back(valueOf<Dim>(rows[i], mesh->points));
        prescribed.col(i) = J * at.back() + Vec<Dim>::Ones();
    }
    VelocitySolver<Dim> solver(mesh, material, BackEndKind::Cpu, 1);
    solver.setConstraints(rows);
    Points<Dim> v;
    QVERIFY(solver.solve(mesh->points, prescribed, v).done());
    const auto expected = minNormMotion<Dim>(*mesh, basis, at, prescribed);
    // ε = 1e-4 against the least elastic eigenvalue: the remainder is the square of a small number only in
    // the energy.
    qInfo("phi %g, %d points in %dD: relative distance %g, energy %g", phiValue, pointCount, Dim,
          relative(v.reshaped(), expected.reshaped()), solver.energy());
    QVERIFY(relative(v.reshaped(), expected.reshaped()) < 2e-3);
    QVERIFY(solver.energy() < 1e-6);
}

template <int Dim>
void negativeOrientationIsTheSame() {
    std::mt19937 random(19 + Dim);
    auto scene = mixedScene<Dim>(random);
    auto mirrored = *scene.mesh;
    for (auto& cell : mirrored.cells) std::swap(cell[0], cell[1]);
    VelocitySolver<Dim> a(scene.mesh, scene.material, BackEndKind::Cpu, 1);
    VelocitySolver<Dim> b(share<Dim>(mirrored), scene.material, BackEndKind::Cpu, 1);
    Points<Dim> va, vb;
    a.setConstraints(scene.rows);
    b.setConstraints(scene.rows);
    QVERIFY(a.solve(scene.shape, scene.prescribed, va).done());
    QVERIFY(b.solve(scene.shape, scene.prescribed, vb).done());
    QVERIFY(relative(va.reshaped(), vb.reshaped()) < 1e-10);
}

/// A soft part, with all constraints, carries along a stiff one, near EQUIA: the stiffer that is, the more of
/// the small residual in the soft part is rounding of the large numbers in the stiff one, and the solver
/// solves again for the remainder. Returns how often it solved.
template <int Dim>
int solvesWithStiffPart(double ratio) {
    std::mt19937 random(29);
    const int n = Dim == 2 ? 20 : 4;
    const auto mesh = share(unitGrid<Dim>(n, 0.1, random));
    Material<Dim> material = Material<Dim>::uniform(mesh->cellCount(), phi::kEquia);
    const Mat<Dim> even = Mat<Dim>::Identity();
    const Mat<Dim> stiff = even + (ratio - 1) * Vec<Dim>::Unit(0) * Vec<Dim>::Unit(0).transpose();
    for (int c = 0; c < mesh->cellCount(); ++c) {
        double x = 0;
        for (const int v : mesh->cells[c]) x += mesh->points(0, v) / (Dim + 1);
        if (x < 0.4) material.phi[c] = phi::kMetr;
        material.anisotropy.push_back(x < 0.4 ? even : stiff);
    }
    VelocitySolver<Dim> solver(mesh, share(std::move(material)), BackEndKind::Cpu, 1);
    solver.setConstraints({fixed(0), fixed(2 * (n + 1)), fixed(1)});
    Points<Dim> prescribed = Points<Dim>::Zero(Dim, 3), v;
    prescribed.col(2).setConstant(0.1);
    return solver.solve(mesh->points, prescribed, v).done() ? solver.statistics().iterations : 0;
}

template <int Dim>
void outcomesAreValues() {
    std::mt19937 random(23);
    const auto mesh = share<Dim>(unitGrid<Dim>(3, 0, random));
    VelocitySolver<Dim> solver(mesh, metr<Dim>(*mesh), BackEndKind::Cpu, 1);
    std::vector<ConstraintRow> rows;
    for (int i = 0; i < 5; ++i) rows.push_back(fixed(i * (mesh->vertexCount() - 1) / 4));
    solver.setConstraints(rows);
    const Points<Dim> prescribed = Points<Dim>::Ones(Dim, 5);
    Points<Dim> v;
    Points<Dim> folded = mesh->points;
    const Cell<Dim> cell = mesh->cells[4];
    folded.col(cell[0]) = 2 * folded.col(cell[1]) - folded.col(cell[0]);
    auto outcome = solver.solve(folded, prescribed, v);
    QVERIFY(outcome.kind == SolveOutcome::Kind::CellInverted && outcome.cell >= 0 && outcome.cell <= 4);

    Points<Dim> broken = mesh->points;
    broken(0, cell[0]) = std::nan("");
    QCOMPARE(solver.solve(broken, prescribed, v).kind, SolveOutcome::Kind::CellInverted);
    Points<Dim> infinite = prescribed;
    infinite(0, 0) = std::numeric_limits<double>::infinity();
    QCOMPARE(solver.solve(mesh->points, infinite, v).kind, SolveOutcome::Kind::NotFinite);
    std::vector<ConstraintRow> all;  // nothing is left to be solved for
    for (int i = 0; i < mesh->vertexCount(); ++i) all.push_back(fixed(i));
    Points<Dim> none = Points<Dim>::Ones(Dim, mesh->vertexCount());
    none(Dim - 1, 3) = std::nan("");
    solver.setConstraints(all);
    QCOMPARE(solver.solve(mesh->points, none, v).kind, SolveOutcome::Kind::NotFinite);
    solver.setConstraints(rows);
    QVERIFY(solver.solve(mesh->points, prescribed, v).done());  // and goes on
    QVERIFY((v - Points<Dim>::Ones(Dim, v.cols())).cwiseAbs().maxCoeff() < 1e-11);
}

}  // namespace

class TestSolver : public QObject {
    Q_OBJECT

  private slots:
    void agreesWithDense() {
        agreesWithDenseReference<2>();
        agreesWithDenseReference<3>();
        slidersAgreeWithDenseReference<2>();
        slidersAgreeWithDenseReference<3>();
    }
    void constraintsHoldExactly() {
        constraintsHold<2>();
        constraintsHold<3>();
    }
    void reducedMatrix() {
        reducedMatrixIsZtAZ<2>();
        reducedMatrixIsZtAZ<3>();
    }
    void projection() {
        projectionPutsPointsOnTargets<2>();
        projectionPutsPointsOnTargets<3>();
    }
    void unconstrained() {
        noConstraintsNoMotion<2>();
        noConstraintsNoMotion<3>();
    }
    void minNorm() {
        minNormDragging<2>(phi::kMetr, 1);
        minNormDragging<2>(phi::kAkvf, 1);
        minNormDragging<2>(phi::conformal(2), 1);
        minNormDragging<3>(phi::kMetr, 1);
        minNormDragging<3>(phi::conformal(3), 1);
        minNormDragging<3>(phi::kMetr, 2);
        minNormDragging<3>(phi::kAkvf, 2);
    }
    void orientation() {
        negativeOrientationIsTheSame<2>();
        negativeOrientationIsTheSame<3>();
    }
    void stiffPartsAreRefined() {
        QCOMPARE(solvesWithStiffPart<2>(1), 1);
        QCOMPARE(solvesWithStiffPart<3>(1), 1);
        QVERIFY(solvesWithStiffPart<2>(1e6) > 1);
        QVERIFY(solvesWithStiffPart<3>(1e6) > 1);
    }
    void outcomes() {
        outcomesAreValues<2>();
        outcomesAreValues<3>();
    }
};

QTEST_APPLESS_MAIN(TestSolver)
#include "test_solver.moc"
