#include <QTest>

#include <Eigen/Geometry>

#include "core/mesh/cut_plane.h"

using namespace wend;

/// A block of n × n × n cubes, five tetrahedra each (mirrored in turn so that they fit).
static SimplicialMesh<3> block(int n) {
    SimplicialMesh<3> mesh;
    const auto id = [n](int i, int j, int k) { return (i * (n + 1) + j) * (n + 1) + k; };
    mesh.points.resize(3, (n + 1) * (n + 1) * (n + 1));
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            for (int k = 0; k <= n; ++k) mesh.points.col(id(i, j, k)) = Vec3(i, j, k) / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const bool odd = (i + j + k) % 2 != 0;
                const auto corner = [&](int a, int b, int c) {
                    return id(i + (odd ? 1 - a : a), j + b, k + c);
                };
                const int x000 = corner(0, 0, 0), x100 = corner(1, 0, 0), x010 = corner(0, 1, 0),
                          x110 = corner(1, 1, 0);
                const int x001 = corner(0, 0, 1), x101 = corner(1, 0, 1), x011 = corner(0, 1, 1),
                          x111 = corner(1, 1, 1);
                mesh.cells.insert(mesh.cells.end(), {{x000, x100, x010, x001},
                                                     {x110, x010, x100, x111},
                                                     {x101, x001, x111, x100},
                                                     {x011, x111, x001, x010},
                                                     {x100, x010, x001, x111}});
            }
    for (auto& cell : mesh.cells)
        if (cellMeasure<3>(mesh.points, cell) < 0) std::swap(cell[2], cell[3]);
    return mesh;
}

/// Volume behind a closed surface and the area of its cut, by the divergence theorem: a surface that is not
/// closed or has a triangle the wrong way round gives another number.
static std::pair<double, double> volumeAndCutArea(const CutSurface& surface, const Points3& pose) {
    double volume = 0, area = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<Vec3, 3> x;
        for (int k = 0; k < 3; ++k) {
            const auto& c = surface.triangles[t][k];
            x[k] = (1 - c.weight) * pose.col(c.from) + c.weight * pose.col(c.to);
        }
        volume += x[0].dot(x[1].cross(x[2])) / 6;
        if (surface.onCut[t]) area += (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
    }
    return {volume, area};
}

class TestCutPlane : public QObject {
    Q_OBJECT
  private slots:
    void wholeSurfaceEnclosesAll();
    void exactCutOfABlock_data();
    void exactCutOfABlock();
    void planeThroughVertices();
    void wholeCellsEncloseTheirVolume();
};

void TestCutPlane::wholeSurfaceEnclosesAll() {
    const auto mesh = block(3);
    const auto [volume, area] = volumeAndCutArea(wholeSurface(facetsOf(mesh)), mesh.points);
    QVERIFY(std::abs(volume - 1) < 1e-13);
    QCOMPARE(area, 0.0);
}

void TestCutPlane::exactCutOfABlock_data() {
    QTest::addColumn<double>("at");
    for (double at : {0.1, 0.37, 0.5001, 0.93}) QTest::addRow("x = %g", at) << at;
}

void TestCutPlane::exactCutOfABlock() {
    QFETCH(double, at);
    const auto mesh = block(4);
    const auto [volume, area] = volumeAndCutArea(
        exactCut(mesh, facetsOf(mesh), mesh.points, {{at, 0, 0}, Vec3::UnitX()}), mesh.points);
    QVERIFY(std::abs(volume - at) < 1e-12);
    QVERIFY(std::abs(area - 1) < 1e-12);
}

void TestCutPlane::planeThroughVertices() {
    const auto mesh = block(4);
    const auto [volume, area] = volumeAndCutArea(
        exactCut(mesh, facetsOf(mesh), mesh.points, {{0.5, 0, 0}, Vec3::UnitX()}), mesh.points);
    QVERIFY(std::abs(volume - 0.5) < 1e-12);
    QVERIFY(std::abs(area - 1) < 1e-12);
}

void TestCutPlane::wholeCellsEncloseTheirVolume() {
    const auto mesh = block(4);
    const CutPlane plane{{0.4, 0.3, 0.6}, Vec3(1, 2, -1).normalized()};
    double expected = 0;
    for (const auto& cell : mesh.cells) {
        Vec3 centroid = Vec3::Zero();
        for (int v : cell) centroid += mesh.points.col(v) / 4;
        if (plane.height(centroid) <= 0) expected += cellMeasure<3>(mesh.points, cell);
    }
    const auto [volume, area] =
        volumeAndCutArea(wholeCellCut(mesh, facetsOf(mesh), mesh.points, plane), mesh.points);
    QVERIFY(std::abs(volume - expected) < 1e-12);
    QVERIFY(area > 0);
}

QTEST_APPLESS_MAIN(TestCutPlane)
#include "test_cut_plane.moc"
