#include <Eigen/LU>
#include <QtTest>
#include <cmath>
#include <limits>

#include "core/mesh/point_locator.h"
#include "test_mesh_samples.h"

using namespace wend;

namespace {

/// The definition, without a grid: solves for the weights in every cell from the last to the first.
template <int Dim>
int highestCellWith(const SimplicialMesh<Dim>& mesh, const Vec<Dim>& p, double tolerance = 1e-12) {
    for (int c = mesh.cellCount() - 1; c >= 0; --c) {
        Eigen::Matrix<double, Dim + 1, Dim + 1> system;
        for (int k = 0; k <= Dim; ++k) system.col(k) << mesh.points.col(mesh.cells[c][k]), 1;
        Eigen::Matrix<double, Dim + 1, 1> right;
        right << p, 1;
        const auto weights = system.fullPivLu().solve(right).eval();
        if (system.fullPivLu().isInvertible() && weights.minCoeff() >= -tolerance) return c;
    }
    return -1;
}

template <int Dim>
int nearestByHand(const Points<Dim>& points, const Vec<Dim>& p) {
    int nearest = -1;
    (points.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
    return nearest;
}

template <int Dim>
Vec<Dim> interpolate(const SimplicialMesh<Dim>& mesh, const Location<Dim>& at) {
    Vec<Dim> p = Vec<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) p += at.weights[k] * mesh.points.col(mesh.cells[at.cell][k]);
    return p;
}

template <int Dim>
bool agrees(const SimplicialMesh<Dim>& mesh, const Vec<Dim>& p, double tolerance = 1e-12) {
    const PointLocator<Dim> locator(mesh.points, mesh.cells);
    const auto found = locator.find(p, tolerance);
    return (found ? found->cell : -1) == highestCellWith<Dim>(mesh, p, tolerance);
}

template <int Dim>
void findsRandomPoints() {
    const auto mesh = samples::jitteredGrid<Dim>(Dim == 2 ? 12 : 4);
    const PointLocator<Dim> locator(mesh.points, mesh.cells);
    samples::Random random;
    int inside = 0, outside = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec<Dim> p = random.point<Dim>(-0.2, 1.2);
        const auto found = locator.find(p);
        const int expected = highestCellWith<Dim>(mesh, p);
        QCOMPARE(found ? found->cell : -1, expected);
        ++(found ? inside : outside);
        if (!found) continue;
        QVERIFY(std::abs(found->weights.sum() - 1) < 1e-14);
        QVERIFY(found->weights.minCoeff() >= -1e-12);
        QVERIFY((interpolate(mesh, *found) - p).norm() < 1e-14);  // a few roundings of numbers about 1
    }
    QVERIFY(inside > 50 && outside > 50);
}

/// Rounding must not make points fall between two cells at vertices, or at the midpoints of edges and facets.
template <int Dim>
void findsPointsOnFacets(double offset) {
    auto mesh = samples::jitteredGrid<Dim>(Dim == 2 ? 10 : 4);
    mesh.points.array() += offset;
    const PointLocator<Dim> locator(mesh.points, mesh.cells);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const auto found = locator.find(mesh.points.col(v));
        QVERIFY2(found.has_value(), qPrintable(QString("vertex %1").arg(v)));
        int last = -1;
        for (int c = 0; c < mesh.cellCount(); ++c)
            if (std::count(mesh.cells[c].begin(), mesh.cells[c].end(), v)) last = c;
        QCOMPARE(found->cell, last);
    }
    samples::Random random;
    for (const auto& facet : facetsOf<Dim>(mesh)) {
        if (!facet.interior()) continue;
        const double t = random();
        Vec<Dim> p = (1 - t) * mesh.points.col(facet.vertices[0]) + t * mesh.points.col(facet.vertices[1]);
        if (Dim == 3) p = (p + mesh.points.col(facet.vertices[Dim - 1])) / 2;
        const auto found = locator.find(p);
        QVERIFY(found.has_value());
        // at a large offset the rounded point may be on either side, by more than the tolerance
        if (offset == 0) QCOMPARE(found->cell, std::max(facet.cells[0], facet.cells[1]));
        QVERIFY(found->cell == facet.cells[0] || found->cell == facet.cells[1]);
    }
}

/// The mesh folded in half like a sheet of paper: every point is in two layers, half of the cells are
/// inverted.
template <int Dim>
void findsTheLastOfOverlappingCells() {
    auto mesh = samples::jitteredGrid<Dim>(Dim == 2 ? 10 : 4);
    mesh.points.row(0) = (mesh.points.row(0).array() - 0.5).abs();
    samples::Random random(3);
    for (int i = 0; i < 100; ++i) QVERIFY(agrees<Dim>(mesh, random.point<Dim>(0, 0.6)));
}

template <int Dim>
void honoursTheTolerance() {
    const auto mesh = samples::jitteredGrid<Dim>(3);
    samples::Random random(5);
    for (double tolerance : {0.0, 0.01, 0.4, 2.0, -0.05})
        for (int i = 0; i < 60; ++i) QVERIFY(agrees<Dim>(mesh, random.point<Dim>(-1, 2), tolerance));
}

template <int Dim>
void passesOverBadCells() {
    auto mesh = samples::grid<Dim>(3);
    mesh.points.col(0).setConstant(std::nan(""));
    mesh.points(0, mesh.vertexCount() - 1) = std::numeric_limits<double>::infinity();
    Cell<Dim> flat;
    flat.fill(1);
    mesh.cells.push_back(flat);
    const PointLocator<Dim> locator(mesh.points, mesh.cells);
    QVERIFY(locator.find(Vec<Dim>::Constant(0.5)).has_value());
    QVERIFY(!locator.find(Vec<Dim>::Constant(0.01)).has_value());
    QVERIFY(!locator.find(Vec<Dim>::Constant(std::nan(""))).has_value());
    QVERIFY(!locator.find(Vec<Dim>::Constant(std::numeric_limits<double>::infinity())).has_value());
    QVERIFY(locator.nearestVertex(Vec<Dim>::Zero()) > 0);
    QCOMPARE(locator.nearestVertex(Vec<Dim>::Constant(std::nan(""))), -1);
    const SimplicialMesh<Dim> none;
    const PointLocator<Dim> empty(none.points, none.cells);
    QVERIFY(!empty.find(Vec<Dim>::Zero()).has_value());
    QCOMPARE(empty.nearestVertex(Vec<Dim>::Zero()), -1);
}

/// A box that is a million times longer than wide, a point, and cells that all extend across the whole mesh.
template <int Dim>
void copesWithBadProportions() {
    auto needle = samples::grid<Dim>(5);
    needle.points.row(0) *= 1e6;
    samples::Random random;
    for (int i = 0; i < 50; ++i) {
        Vec<Dim> p = random.point<Dim>();
        p[0] *= 1e6;
        QVERIFY(agrees<Dim>(needle, p));
    }
    auto collapsed = samples::grid<Dim>(2);
    collapsed.points.setConstant(3);
    QVERIFY(agrees<Dim>(collapsed, Vec<Dim>::Constant(3)));
    auto sheared = samples::grid<Dim>(4);
    for (int k = 1; k < Dim; ++k) sheared.points.row(k) += 1e4 * sheared.points.row(0);
    for (int i = 0; i < 50; ++i) {
        Vec<Dim> p = random.point<Dim>(0.05, 0.95);
        for (int k = 1; k < Dim; ++k) p[k] += 1e4 * p[0];
        const PointLocator<Dim> locator(sheared.points, sheared.cells);
        const auto found = locator.find(p);
        QVERIFY(found.has_value());
        QVERIFY((interpolate(sheared, *found) - p).norm() <
                1e-7);  // condition 1e8, coordinates 1e4, 1e-16 each
    }
}

template <int Dim>
void findsTheNearestVertex() {
    const auto mesh = samples::jitteredGrid<Dim>(Dim == 2 ? 15 : 6);
    const PointLocator<Dim> locator(mesh.points, mesh.cells);
    samples::Random random(11);
    for (double reach : {0.0, 0.5, 20.0})
        for (int i = 0; i < 300; ++i) {
            const Vec<Dim> p = random.point<Dim>(-reach, 1 + reach);
            QCOMPARE(locator.nearestVertex(p), nearestByHand<Dim>(mesh.points, p));
        }
    for (int v = 0; v < mesh.vertexCount(); ++v) QCOMPARE(locator.nearestVertex(mesh.points.col(v)), v);
    const auto regular = samples::grid<Dim>(1);  // all corners equally far from the centre
    QCOMPARE(PointLocator<Dim>(regular.points, regular.cells).nearestVertex(Vec<Dim>::Constant(0.5)), 0);
}

}  // namespace

class TestMeshLocator : public QObject {
    Q_OBJECT

  private slots:
    void findsRandomPoints2D() { findsRandomPoints<2>(); }
    void findsRandomPoints3D() { findsRandomPoints<3>(); }
    void findsTheLastOfOverlappingCells2D() { findsTheLastOfOverlappingCells<2>(); }
    void findsTheLastOfOverlappingCells3D() { findsTheLastOfOverlappingCells<3>(); }
    void honoursTheTolerance2D() { honoursTheTolerance<2>(); }
    void honoursTheTolerance3D() { honoursTheTolerance<3>(); }
    void passesOverBadCells2D() { passesOverBadCells<2>(); }
    void passesOverBadCells3D() { passesOverBadCells<3>(); }
    void copesWithBadProportions2D() { copesWithBadProportions<2>(); }
    void copesWithBadProportions3D() { copesWithBadProportions<3>(); }
    void findsTheNearestVertex2D() { findsTheNearestVertex<2>(); }
    void findsTheNearestVertex3D() { findsTheNearestVertex<3>(); }
    void pointsOnFacets_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<double>("offset");
        for (int dim : {2, 3})
            for (double offset : {0.0, 1e3, 1e6}) QTest::addRow("%dD at %g", dim, offset) << dim << offset;
    }
    void pointsOnFacets() {
        QFETCH(int, dim);
        QFETCH(double, offset);
        dim == 2 ? findsPointsOnFacets<2>(offset) : findsPointsOnFacets<3>(offset);
    }
};

QTEST_APPLESS_MAIN(TestMeshLocator)
#include "test_mesh_locator.moc"
