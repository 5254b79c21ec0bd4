#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/mesh/quality.h"
#include "test_mesh_samples.h"

using namespace wend;

namespace {

constexpr double degree = M_PI / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <int Dim>
CellQuality qualityOfCell(const Points<Dim>& points) {
    Cell<Dim> cell;
    std::iota(cell.begin(), cell.end(), 0);
    return cellQuality<Dim>(points, cell);
}

Points2 triangle(double x0, double y0, double x1, double y1, double x2, double y2) {
    Points2 points(2, 3);
    points << x0, x1, x2, y0, y1, y2;
    return points;
}

bool close(double a, double b) {
    return std::abs(a - b) <= 1e-14 * (1 + std::abs(b));
}

}  // namespace

class TestMeshQuality : public QObject {
    Q_OBJECT

  private slots:
    void triangles_data() {
        QTest::addColumn<QList<double>>("corners");
        QTest::addColumn<double>("measure");
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("ratio");
        const double root3 = std::sqrt(3);
        QTest::newRow("equilateral") << QList<double>{0, 0, 1, 0, 0.5, root3 / 2} << root3 / 4 << 60 * degree
                                     << 1 / root3;
        QTest::newRow("half a square")
            << QList<double>{0, 0, 1, 0, 0, 1} << 0.5 << 45 * degree << std::sqrt(0.5);
        QTest::newRow("3-4-5") << QList<double>{0, 0, 4, 0, 0, 3} << 6.0 << std::atan2(3, 4) << 2.5 / 3;
        QTest::newRow("clockwise") << QList<double>{0, 0, 0, 3, 4, 0} << -6.0 << std::atan2(3, 4) << 2.5 / 3;
        QTest::newRow("obtuse 120°") << QList<double>{0, 0, 1, 0, -0.5, root3 / 2} << root3 / 4 << 30 * degree
                                     << 1.0;
        QTest::newRow("needle") << QList<double>{0, 0, 1e6, 0, 0, 1} << 5e5 << std::atan(1e-6)
                                << std::sqrt(1e12 + 1) / 2;
        QTest::newRow("flat") << QList<double>{0, 0, 1, 0, 2, 0} << 0.0 << 0.0 << infinity;
    }
    void triangles() {
        QFETCH(QList<double>, corners);
        QFETCH(double, measure);
        QFETCH(double, angle);
        QFETCH(double, ratio);
        const auto quality = qualityOfCell<2>(
            triangle(corners[0], corners[1], corners[2], corners[3], corners[4], corners[5]));
        QVERIFY(close(quality.measure, measure));
        QVERIFY(std::abs(quality.minAngle - angle) <= 1e-13 * angle);
        QVERIFY(quality.radiusEdgeRatio == ratio ||
                std::abs(quality.radiusEdgeRatio - ratio) <= 1e-13 * ratio);
    }

    void regularTetrahedron() {
        Points3 points(3, 4);
        points << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
        const auto quality = qualityOfCell<3>(points);
        QVERIFY(close(std::abs(quality.measure), 8.0 / 3));
        QVERIFY(close(quality.minAngle, std::acos(1.0 / 3)));
        QVERIFY(close(quality.radiusEdgeRatio, std::sqrt(3.0 / 8)));
    }
    void cornerOfACube() {
        Points3 points(3, 4);
        points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
        const auto quality = qualityOfCell<3>(points);
        QVERIFY(close(quality.measure, 1.0 / 6));
        QVERIFY(close(quality.minAngle, std::acos(1 / std::sqrt(3.0))));  // to the slanted face
        QVERIFY(close(quality.radiusEdgeRatio, std::sqrt(3.0) / 2));
    }
    /// Four points of a circle, two of them lifted: good edges, but an angle near 0 (a sliver).
    void sliver() {
        const double lift = 1e-3;
        Points3 points(3, 4);
        points << 1, 0, -1, 0, 0, 1, 0, -1, lift, -lift, lift, -lift;
        const auto quality = qualityOfCell<3>(points);
        // neighbouring faces have the normals (0, 2h, 1) and (−2h, 0, 1); the circumcentre is the origin
        const double h = lift, cosine = 1 / (1 + 4 * h * h);
        QVERIFY(std::abs(quality.minAngle - std::atan2(std::sqrt(1 - cosine * cosine), cosine)) < 1e-12);
        QVERIFY(close(quality.radiusEdgeRatio, std::sqrt((1 + h * h) / (2 + 4 * h * h))));
    }
    void unchangedBySimilarity() {
        samples::Random random;
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        for (int i = 0; i < 50; ++i) {
            Points3 points(3, 4);
            for (int k = 0; k < 4; ++k) points.col(k) = random.point<3>();
            const auto a = qualityOfCell<3>(points);
            const auto b =
                qualityOfCell<3>(((1000 * turn * points).colwise() + Eigen::Vector3d(5, 6, 7)).eval());
            QVERIFY(std::abs(a.minAngle - b.minAngle) < 1e-9);
            QVERIFY(std::abs(a.radiusEdgeRatio / b.radiusEdgeRatio - 1) < 1e-9);
            QVERIFY(std::abs(a.measure * 1e9 / b.measure - 1) < 1e-9);
        }
    }

    void summary2D() {
        const int n = 5;
        const auto summary = qualityOf<2>(samples::grid<2>(n));
        QVERIFY(close(summary.totalMeasure, 1));
        QVERIFY(close(summary.minMeasure, 0.5 / (n * n)) && close(summary.maxMeasure, 0.5 / (n * n)));
        QVERIFY(std::abs(summary.minAngle - 45 * degree) < 1e-13 &&
                std::abs(summary.meanMinAngle - 45 * degree) < 1e-13);
        QVERIFY(std::abs(summary.maxRadiusEdgeRatio - std::sqrt(0.5)) < 1e-13);
        // 45° is the boundary of two bins
        QCOMPARE(summary.angleHistogram[8] + summary.angleHistogram[9], 2 * n * n);
    }
    void summary3D() {
        const int n = 3;
        const auto summary = qualityOf<3>(samples::grid<3>(n));
        QVERIFY(close(summary.totalMeasure, 1));
        QVERIFY(close(summary.maxMeasure, 1.0 / (6 * n * n * n)));
        QVERIFY(std::abs(summary.minAngle - 45 * degree) < 1e-13);
        QVERIFY(std::abs(summary.maxRadiusEdgeRatio - std::sqrt(3.0) / 2) < 1e-13);
    }
    /// Kuhn's cells are all alike: dihedral angles 45°, 60° and 90° (three of them), ratio √3 / 2.
    void histograms3D() {
        const int n = 3;
        auto mesh = samples::grid<3>(n);
        mesh.points *= 7;
        const auto summary = qualityOf<3>(mesh);
        const int cells = mesh.cellCount();
        const auto around = [&](int degrees) {  // the boundary of two bins
            return summary.allAngles[degrees / 5 - 1] + summary.allAngles[degrees / 5];
        };
        QCOMPARE(around(45), 2 * cells);
        QCOMPARE(around(60), cells);
        QCOMPARE(around(90), 3 * cells);
        QVERIFY(std::abs(summary.maxAngle - 90 * degree) < 1e-13);
        QCOMPARE(summary.ratios[1], cells);                          // [0.75, 1)
        QCOMPARE(summary.measures[7] + summary.measures[8], cells);  // the mean, to rounding
    }
    void flatCellsAreInTheLastBins() {
        auto mesh = samples::grid<2>(2);
        mesh.points.col(4) = mesh.points.col(0);
        const auto summary = qualityOf<2>(mesh);
        QCOMPARE(summary.ratios.back(), 2);  // the two on the diagonal that has gone
        QCOMPARE(summary.measures.front(), 2);
    }
    void worstCellAndHistogram() {
        auto mesh = samples::grid<2>(2);
        mesh.points.col(4) += Eigen::Vector2d(0.2, 0.1);
        const auto summary = qualityOf<2>(mesh);
        int total = 0;
        for (int count : summary.angleHistogram) total += count;
        QCOMPARE(total, mesh.cellCount());
        double smallest = infinity;
        for (const auto& cell : mesh.cells)
            smallest = std::min(smallest, cellQuality<2>(mesh.points, cell).minAngle);
        QCOMPARE(summary.minAngle, smallest);
        QCOMPARE(cellQuality<2>(mesh.points, mesh.cells[summary.worstCell]).minAngle, smallest);
        QVERIFY(summary.minMeasure < summary.maxMeasure);
        QCOMPARE(qualityOf<3>({}).worstCell, -1);
    }
};

QTEST_APPLESS_MAIN(TestMeshQuality)
#include "test_mesh_quality.moc"
