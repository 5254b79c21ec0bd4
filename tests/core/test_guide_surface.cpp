// Surfaces and paths on which points slide.

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>

#include "core/motion/guide_surface.h"

using namespace wend;

class TestGuideSurface : public QObject {
    Q_OBJECT

  private slots:
    void partsOfABox();
    void normalsConverge();
    void normalsAreContinuous();
    void beyondTheRim();
    void paths();
};

namespace {

/// The unit cube, each face of two triangles with points of its own, as an STL file has them.
GuideMesh<3> box() {
    GuideMesh<3> mesh;
    std::vector<Vec3> points;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0}) {
            std::array<Vec3, 4> corner;
            for (int k = 0; k < 4; ++k) {
                corner[k][axis] = side;
                corner[k][(axis + 1) % 3] = k & 1;
                corner[k][(axis + 2) % 3] = k >> 1;
            }
            for (const std::array<int, 3>& t : {std::array{0, 1, 3}, std::array{0, 3, 2}}) {
                const int first = static_cast<int>(points.size());
                for (const int k : t) points.push_back(corner[k]);
                mesh.triangles.push_back({first, first + 1, first + 2});
            }
        }
    mesh.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) mesh.points.col(static_cast<Eigen::Index>(i)) = points[i];
    return mesh;
}

/// A patch of the unit sphere around its pole, n × n squares wide.
GuideMesh<3> cap(int n) {
    GuideMesh<3> mesh;
    mesh.points.resize(3, (n + 1) * (n + 1));
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.points.col(j * (n + 1) + i) = Vec3(double(i) / n - 0.5, double(j) / n - 0.5, 1).normalized();
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            mesh.triangles.push_back({a, a + 1, a + n + 2});
            mesh.triangles.push_back({a, a + n + 2, a + n + 1});
        }
    return mesh;
}

}  // namespace

void TestGuideSurface::partsOfABox() {
    const GuideSurface<3> guide(box());
    QCOMPARE(guide.trackAt({0.3, 0.4, 1.2}, 1e-6), Track::Face);
    QCOMPARE(guide.trackAt({0.3, 0, 0}, 1e-6), Track::Line);
    QCOMPARE(guide.trackAt({0.3, -0.2, -0.1}, 1e-6), Track::Line);  // an edge is nearest
    QCOMPARE(guide.trackAt({1, 1, 1}, 1e-6), Track::Corner);
    // The diagonals of the faces are no lines.
    QCOMPARE(guide.trackAt({0.5, 0.5, 0}, 1e-6), Track::Face);
    const Contact<3> face = guide.contact(Track::Face, {0.3, 0.4, 1.2});
    QVERIFY((face.point - Vec3(0.3, 0.4, 1)).norm() < 1e-15);
    QCOMPARE(face.count, 1);
    QVERIFY(std::abs(std::abs(face.normals(2, 0)) - 1) < 1e-15);
    const Contact<3> line = guide.contact(Track::Line, {0.3, -0.2, -0.1});
    QVERIFY((line.point - Vec3(0.3, 0, 0)).norm() < 1e-15);
    QCOMPARE(line.count, 2);
    const Mat3 across = line.normals.leftCols(2) * line.normals.leftCols(2).transpose();
    QVERIFY((across - Mat3(Vec3(0, 1, 1).asDiagonal())).norm() < 1e-15);
    const Contact<3> corner = guide.contact(Track::Corner, {0.9, 0.9, 1.3});
    QCOMPARE(corner.point, Vec3(1, 1, 1));
    QCOMPARE(corner.count, 3);
}

/// Interpolated normals of a sphere are off by the square of the triangles' size.
void TestGuideSurface::normalsConverge() {
    const auto worst = [](int n) {
        const GuideSurface<3> guide(cap(n));
        double angle = 0;
        for (double x = -0.2; x <= 0.2; x += 0.013)
            for (double y = -0.2; y <= 0.2; y += 0.017) {
                const Vec3 radial = Vec3(x, y, 1).normalized();
                const Vec3 normal = guide.contact(Track::Face, radial).normals.col(0);
                angle = std::max(angle, radial.cross(normal).norm());
            }
        return angle;
    };
    const double coarse = worst(8), fine = worst(32);
    QVERIFY2(fine < coarse / 10, qPrintable(QString("%1 %2").arg(coarse).arg(fine)));
    QVERIFY(coarse < 0.01);
}

void TestGuideSurface::normalsAreContinuous() {
    const GuideSurface<3> guide(cap(6));
    Vec3 before = guide.contact(Track::Face, Vec3(-0.3, 0.013, 1).normalized()).normals.col(0);
    for (int k = 1; k <= 6000; ++k) {
        const Vec3 p = Vec3(-0.3 + 1e-4 * k, 0.013 + 3e-5 * k, 1).normalized();
        const Vec3 normal = guide.contact(Track::Face, p).normals.col(0);
        QVERIFY((normal - before).norm() < 5e-4);
        before = normal;
    }
}

/// A single triangle continues as its plane on all sides.
void TestGuideSurface::beyondTheRim() {
    GuideMesh<3> mesh;
    mesh.points = Mat3::Identity();
    mesh.triangles = {{0, 1, 2}};
    const GuideSurface<3> guide(mesh);
    const Vec3 normal = Vec3::Ones().normalized();
    for (const Vec3& p : {Vec3(3, 0, 0), Vec3(-1, -1, 4), Vec3(2, 2, 0), Vec3(0.2, 0.3, 0.1)}) {
        const Contact<3> contact = guide.contact(Track::Face, p);
        QVERIFY((contact.point - (p - normal * (p.sum() - 1) / std::sqrt(3.0))).norm() < 1e-14);
        QVERIFY(std::abs(std::abs(contact.normals.col(0).dot(normal)) - 1) < 1e-15);
    }
}

/// Bends of less than 50° are smooth, others hold.
void TestGuideSurface::paths() {
    GuideMesh<2> path;
    path.points.resize(2, 4);
    path.points << 0, 1, 2, 2, 0, 0, 0.5, 2;
    path.segments = {{0, 1}, {1, 2}, {2, 3}};
    const GuideSurface<2> guide(path);
    QCOMPARE(guide.trackAt({1, 0}, 1e-6), Track::Line);
    QCOMPARE(guide.trackAt({2, 0.5}, 1e-6), Track::Corner);
    const Contact<2> bend = guide.contact(Track::Line, {1, 0});
    const double angle = std::atan2(0.5, 1) / 2;
    QVERIFY(std::abs(std::abs(bend.normals.col(0).dot(Vec2(-std::sin(angle), std::cos(angle)))) - 1) < 1e-14);
    // Beyond its ends it continues straight.
    const Contact<2> before = guide.contact(Track::Line, {-3, 0.25});
    QVERIFY((before.point - Vec2(-3, 0)).norm() < 1e-15);
    QVERIFY_THROWS_EXCEPTION(std::exception, GuideSurface<2>(GuideMesh<2>()));
}

QTEST_GUILESS_MAIN(TestGuideSurface)
#include "test_guide_surface.moc"
