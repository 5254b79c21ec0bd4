// The shape of single cells, and the gradient of their maps.

#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/mesh/cell_shape.h"

using namespace wend;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Points3 cornerTetrahedron() {
    Points3 points(3, 4);
    points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    return points;
}

Points3 regularTetrahedron() {
    Points3 points(3, 4);
    points << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
    points.col(2).swap(points.col(3));  // positive
    return points;
}

}  // namespace

class TestCellShape : public QObject {
    Q_OBJECT

  private slots:
    void regularCells() {
        Points3 points = regularTetrahedron();
        CellShape shape = cellShape<3>(points, {0, 1, 2, 3});
        if (shape.scaledJacobian < 0) shape = cellShape<3>(points, {0, 1, 3, 2});
        QVERIFY(std::abs(shape.scaledJacobian - 1) < 1e-14);
        QVERIFY(std::abs(shape.aspectRatio - 1) < 1e-14);
        QVERIFY(std::abs(shape.minAngle - std::acos(1.0 / 3)) < 1e-14);
        QVERIFY(std::abs(shape.maxAngle - std::acos(1.0 / 3)) < 1e-14);
        Points2 flat(2, 3);
        flat << 0, 2, 1, 0, 0, std::sqrt(3.0);
        const CellShape triangle = cellShape<2>(flat, {0, 1, 2});
        QVERIFY(std::abs(triangle.scaledJacobian - 1) < 1e-14);
        QVERIFY(std::abs(triangle.aspectRatio - 1) < 1e-14);
        QVERIFY(std::abs(triangle.minAngle - 60 * kDegree) < 1e-14);
        QVERIFY(std::abs(triangle.maxAngle - 60 * kDegree) < 1e-14);
    }

    /// A corner of a cube: J = 1; at the other corners the edges are 1, √2, √2. Angles 90° and acos 1/√3.
    void cornerOfACube() {
        const CellShape shape = cellShape<3>(cornerTetrahedron(), {0, 1, 2, 3});
        QVERIFY(std::abs(shape.scaledJacobian - std::sqrt(2.0) / 2) < 1e-14);
        QVERIFY(std::abs(shape.minAngle - std::acos(1 / std::sqrt(3.0))) < 1e-14);
        QVERIFY(std::abs(shape.maxAngle - 90 * kDegree) < 1e-14);
        const double radius = 1 / (3 + std::sqrt(3.0));  // 3 V / A
        QVERIFY(std::abs(shape.aspectRatio - std::sqrt(2.0) / (2 * std::sqrt(6.0) * radius)) < 1e-14);
        QVERIFY(cellShape<3>(cornerTetrahedron(), {1, 0, 2, 3}).scaledJacobian < 0);
        Points3 flat = cornerTetrahedron();
        flat(2, 3) = 0;
        QCOMPARE(cellShape<3>(flat, {0, 1, 2, 3}).scaledJacobian, 0.0);
        QVERIFY(std::isinf(cellShape<3>(flat, {0, 1, 2, 3}).aspectRatio));
    }

    void rightTriangle() {
        Points2 points(2, 3);
        points << 0, 3, 0, 0, 0, 4;
        const CellShape shape = cellShape<2>(points, {0, 1, 2});
        QVERIFY(std::abs(shape.scaledJacobian - 2 / std::sqrt(3.0) * 12 / 20) < 1e-14);
        QVERIFY(std::abs(shape.aspectRatio - 5 * 12.0 / (4 * std::sqrt(3.0) * 6)) < 1e-14);
        QVERIFY(std::abs(shape.minAngle - std::atan2(3, 4)) < 1e-14);
        QVERIFY(std::abs(shape.maxAngle - 90 * kDegree) < 1e-14);
    }

    /// A linear map is the gradient of itself.
    void gradients() {
        SimplicialMesh<3> rest{cornerTetrahedron(), {{0, 1, 2, 3}}};
        Mat3 A;
        A << 1, 2, 0.5, -1, 3, 0.25, 0, 1, 2;
        const Points3 pose = (A * rest.points).colwise() + Vec3(5, 6, 7);
        QVERIFY((deformationGradients<3>(rest, pose)[0] - A).norm() < 1e-13);
    }
};

QTEST_GUILESS_MAIN(TestCellShape)
#include "test_cell_shape.moc"
