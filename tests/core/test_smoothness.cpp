// The smoothness energy: it is zero on affine fields, and a velocity field converges as the mesh is refined.
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/energy/smoothness.h"
#include "core/mesh/point_locator.h"
#include "core/solver/velocity_solver.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

namespace {

template <int Dim>
double energyOf(const SimplicialMesh<Dim>& mesh, double phi, Smoothing smoothing, const Points<Dim>& v) {
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(mesh, true));
    const auto backEnd =
        makeCpuBackEnd<Dim>(plan, mesh, Material<Dim>::uniform(mesh.cellCount(), phi, smoothing), 1);
    backEnd->setShape(mesh.points);
    return backEnd->energy(v);
}

template <int Dim>
void affineFieldsAreSmooth() {
    std::mt19937 random(1);
    const auto mesh = unitGrid<Dim>(3, 0.2, random);
    const auto v = affineField<Dim>(mesh.points, randomMatrix<Dim, Dim>(random), Vec<Dim>::Ones());
    const auto bent = randomField<Dim>(random, mesh.vertexCount());
    for (double phi : {phi::kMetr, phi::kAkvf, phi::conformal(Dim)}) {
        const double alone = energyOf<Dim>(mesh, phi, {SmoothingKind::None}, v);
        const double bentAlone = energyOf<Dim>(mesh, phi, {SmoothingKind::None}, bent);
        for (const auto kind : {SmoothingKind::Invariant, SmoothingKind::Paper}) {
            QVERIFY(std::abs(energyOf<Dim>(mesh, phi, {kind}, v) - alone) < 1e-13 * alone);
            QVERIFY(energyOf<Dim>(mesh, phi, {kind}, bent) > 1.01 * bentAlone);
        }
    }
}

/// The weights by hand on two cells.
template <int Dim>
void weights() {
    std::mt19937 random(2);
    const auto mesh = samples::grid<Dim>(1);
    for (const auto& facet : facetsOf(mesh)) {
        if (!facet.interior()) continue;
        const auto& i = mesh.cells[facet.cells[0]];
        const auto& j = mesh.cells[facet.cells[1]];
        const auto weight = [&](Smoothing smoothing, double scale) {
            return smoothnessWeight<Dim>(smoothing, scale * mesh.points, facet.vertices, i, j);
        };
        const double B = facetMeasure<Dim>(mesh.points, facet.vertices);
        // The facet is the diagonal of a square, or a triangle of an edge, a face's and the cube's diagonal.
        QVERIFY(std::abs(B - std::sqrt(2.0) / (Dim == 2 ? 1 : 2)) < 1e-15);
        QVERIFY(std::abs(weight({SmoothingKind::Paper, 0, 0.3}, 1) - 0.3 * B) < 1e-15);
        // Centroids of the two halves of a square are √2/3 apart; of two such tetrahedra √2/4.
        const double h = std::sqrt(2.0) / (Dim + 1);
        QVERIFY(std::abs(weight({SmoothingKind::Invariant, 0.4, 0}, 1) - 0.16 * B / h) < 1e-15);
        QCOMPARE(weight({SmoothingKind::None, 0.4, 0.3}, 1), 0.0);
        const double bigger =
            weight({SmoothingKind::Invariant, 0.4, 0}, 2) / weight({SmoothingKind::Invariant, 0.4, 0}, 1);
        QVERIFY(std::abs(bigger - (Dim == 2 ? 1 : 2)) < 1e-14);  // a length to the power d − 2
    }
}

/// The field of one pulled vertex on a square of diagonal 1, with n × n boxes and its left side fixed, at
/// fixed points.
Points2 pulledField(int n, double phi, Smoothing smoothing, const Points2& at) {
    std::mt19937 random(3);
    const auto mesh = std::make_shared<const SimplicialMesh<2>>(unitGrid<2>(n, 0, random));
    const auto material =
        std::make_shared<const Material<2>>(Material<2>::uniform(mesh->cellCount(), phi, smoothing));
    VelocitySolver<2> solver(mesh, material, BackEndKind::Cpu, 0);
    std::vector<ConstraintRow> rows;
    for (int j = 0; j <= n; ++j) rows.push_back({{{j * (n + 1), 1.0}}});
    rows.push_back({{{n / 2 * (n + 1) + n / 2 + n / 4, 1.0}}});
    Points2 prescribed = Points2::Zero(2, n + 2), v;
    prescribed.col(n + 1) = Vec2(0.6, 0.8);
    solver.setConstraints(rows);
    if (!solver.solve(mesh->points, prescribed, v).done()) return {};
    const PointLocator<2> locator(mesh->points, mesh->cells);
    Points2 result(2, at.cols());
    for (int i = 0; i < at.cols(); ++i) {
        const auto location = locator.find(at.col(i), 1e-9);
        result.col(i).setZero();
        for (int k = 0; k < 3; ++k)
            result.col(i) += location->weights[k] * v.col(mesh->cells[location->cell][k]);
    }
    return result;
}

/// Points all over the square and on rings around the handle, down to 0.02 of the diagonal.
Points2 samplePoints() {
    const double side = std::sqrt(0.5);
    const Vec2 handle(0.75 * side, 0.5 * side);
    std::vector<Vec2> points;
    for (int i = 1; i < 10; ++i)
        for (int j = 0; j <= 10; ++j) points.push_back(Vec2(i, j) * side / 10);
    for (double radius : {0.02, 0.04, 0.08})
        for (int i = 0; i < 12; ++i)
            points.push_back(handle + radius * Vec2(std::cos(i * std::numbers::pi / 6),
                                                    std::sin(i * std::numbers::pi / 6)));
    Points2 result(2, static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) result.col(static_cast<int>(i)) = points[i];
    return result;
}

struct Changes {
    double first, second;  // 1k → 4k, 4k → 16k vertices, relative to the handle's velocity
};
Changes changes(double phi, Smoothing smoothing) {
    const auto at = samplePoints();
    std::vector<Points2> fields;
    for (int n : {32, 64, 128}) fields.push_back(pulledField(n, phi, smoothing, at));
    const auto distance = [&](int i) { return (fields[i + 1] - fields[i]).colwise().norm().maxCoeff(); };
    return {distance(0), distance(1)};
}

}  // namespace

class TestSmoothness : public QObject {
    Q_OBJECT

  private slots:
    void affine() {
        affineFieldsAreSmooth<2>();
        affineFieldsAreSmooth<3>();
    }
    void byHand() {
        weights<2>();
        weights<3>();
    }
    void settles_data() {
        QTest::addColumn<double>("phi");
        QTest::addColumn<double>("limit");
        QTest::newRow("METR") << phi::kMetr << 0.015;
        QTest::newRow("AKVF") << phi::kAkvf << 0.015;
        QTest::newRow("CONF") << phi::conformal(2) << 0.03;
    }
    void settles() {
        QFETCH(double, phi);
        QFETCH(double, limit);
        const auto invariant = changes(phi, {SmoothingKind::Invariant, 0.02, 0});
        const auto paper = changes(phi, {SmoothingKind::Paper, 0, 0.1});
        qInfo("invariant %.4f %.4f, paper %.4f %.4f", invariant.first, invariant.second, paper.first,
              paper.second);
        QVERIFY(invariant.second <= 0.5 * invariant.first);
        QVERIFY(invariant.second <= limit);
        QVERIFY(paper.second > 0.7 * paper.first);  // the paper's does not settle
    }
};

QTEST_APPLESS_MAIN(TestSmoothness)
#include "test_smoothness.moc"
