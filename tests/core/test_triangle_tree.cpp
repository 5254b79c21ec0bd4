#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <random>

#include "core/mesh/triangle_tree.h"
#include "tests/support/surfaces.h"

using namespace wend;

/// The tree compared with a search through every triangle.
class TestTriangleTree : public QObject {
    Q_OBJECT
  private slots:
    void sameAsLookingAtAll_data();
    void sameAsLookingAtAll();
    void followsThePose();
    void nearestIsThatOfAll();
    void looksAtFew();
    void nothingAndDamage();
};

namespace {

using Triangles = std::vector<std::array<int, 3>>;

struct Shape {
    Points3 points;
    Triangles triangles;
};

Shape shapeOf(const Surface& surface) {
    return {surface.points, surface.triangles};
}

/// Computes distances from the plane's equation and the areas of the parts, unlike the tree.
double distanceByPlane(const Shape& s, int t, const Vec3& origin, const Vec3& direction) {
    const auto& id = s.triangles[t];
    const Vec3 a = s.points.col(id[0]), b = s.points.col(id[1]), c = s.points.col(id[2]);
    const Vec3 n = (b - a).cross(c - a);
    const double along = n.dot(direction);
    if (along == 0) return -1;
    const double distance = n.dot(a - origin) / along;
    const Vec3 p = origin + distance * direction;
    const bool inside = n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                        n.dot((a - c).cross(p - c)) >= 0;
    return inside && distance > 0 ? distance : -1;
}

double nearestOfAll(const Shape& s, const Vec3& origin, const Vec3& direction) {
    double nearest = -1;
    for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
        const double distance = distanceByPlane(s, t, origin, direction);
        if (distance > 0 && (nearest < 0 || distance < nearest)) nearest = distance;
    }
    return nearest;
}

Vec3 randomPoint(std::mt19937& random, double size) {
    const auto one = [&] { return size * (2.0 * random() / std::mt19937::max() - 1); };
    const double x = one(), y = one();
    return {x, y, one()};
}

void compare(const TriangleTree& tree, const Shape& shape, double size) {
    std::mt19937 random(7);
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 origin = randomPoint(random, 2 * size);
        const Vec3 direction = (randomPoint(random, size) - origin).normalized();
        const double expected = nearestOfAll(shape, origin, direction);
        const auto hit = tree.firstHit(origin, direction);
        QCOMPARE(hit.triangle >= 0, expected > 0);
        if (expected <= 0) continue;
        ++met;
        QVERIFY(std::abs(hit.distance - expected) <= 1e-9 * size);
    }
    QVERIFY(met > 50 && met < 400);  // both kinds have been seen
}

/// A sphere as a net of latitudes and longitudes.
Shape sphere(int rings) {
    Shape shape;
    const int around = 2 * rings;
    shape.points.resize(3, static_cast<Eigen::Index>(rings + 1) * around);
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < around; ++j) {
            const double theta = M_PI * i / rings, phi = 2 * M_PI * j / around;
            shape.points.col(i * around + j) << std::sin(theta) * std::cos(phi),
                std::sin(theta) * std::sin(phi), std::cos(theta);
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
            const int a = i * around + j, b = i * around + (j + 1) % around;
            shape.triangles.push_back({a, a + around, b});
            shape.triangles.push_back({b, a + around, b + around});
        }
    return shape;
}

}  // namespace

void TestTriangleTree::sameAsLookingAtAll_data() {
    QTest::addColumn<double>("size");
    for (const double size : {1.0, 1e7, 1e-7}) QTest::addRow("%g", size) << size;
}

void TestTriangleTree::sameAsLookingAtAll() {
    QFETCH(double, size);
    Shape shape = shapeOf(test::box({-1, -0.5, -0.25}, {1, 0.5, 0.25}, 5));
    shape.points *= size;
    compare(TriangleTree(shape.points, shape.triangles), shape, size);
}

void TestTriangleTree::followsThePose() {
    Shape shape = sphere(12);
    TriangleTree tree(shape.points, shape.triangles);
    for (Eigen::Index i = 0; i < shape.points.cols(); ++i) {
        const double z = shape.points(2, i);
        shape.points.col(i) = Eigen::AngleAxisd(2 * z, Vec3::UnitY()) * shape.points.col(i) + Vec3(z, 0, 0);
    }
    tree.refit(shape.points);
    compare(tree, shape, 1.5);
}

/// The result is the least distance to a fine sampling of every triangle, up to the sampling's step.
void TestTriangleTree::nearestIsThatOfAll() {
    const Shape shape = shapeOf(test::box({-1, -0.5, -0.25}, {1, 0.5, 0.25}, 3));
    const TriangleTree tree(shape.points, shape.triangles);
    std::mt19937 random(11);
    constexpr int kSteps = 12;
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = randomPoint(random, 2);
        const auto nearest = tree.nearest(p);
        QVERIFY(nearest.triangle >= 0 && nearest.weights.minCoeff() >= 0);
        QVERIFY(std::abs(nearest.weights.sum() - 1) < 1e-12);
        const auto at = [&](const std::array<int, 3>& t, const Vec3& w) -> Vec3 {
            return w[0] * shape.points.col(t[0]) + w[1] * shape.points.col(t[1]) +
                   w[2] * shape.points.col(t[2]);
        };
        const double distance = (at(shape.triangles[nearest.triangle], nearest.weights) - p).norm();
        double minimum = 1e9;
        for (const auto& t : shape.triangles)
            for (int a = 0; a <= kSteps; ++a)
                for (int b = 0; a + b <= kSteps; ++b)
                    minimum = std::min(minimum, (at(t, Vec3(kSteps - a - b, a, b) / kSteps) - p).norm());
        QVERIFY(distance <= minimum + 1e-12 && distance > minimum - 1.0 / kSteps);
    }
}

/// A hundred times as many triangles need hardly more work.
void TestTriangleTree::looksAtFew() {
    const auto visitedBy = [](int rings) {
        const Shape shape = sphere(rings);
        const TriangleTree tree(shape.points, shape.triangles);
        std::mt19937 random(3);
        double visited = 0;
        for (int i = 0; i < 100; ++i) {
            const Vec3 origin = 3 * randomPoint(random, 1).normalized();
            visited += tree.firstHit(origin, (0.7 * randomPoint(random, 1) - origin).normalized()).visited;
        }
        qInfo("%d triangles: %.1f boxes and triangles looked at per ray", tree.triangleCount(),
              visited / 100);
        return visited / 100;
    };
    const double few = visitedBy(16), many = visitedBy(160);  // 1024 and 102 400 triangles
    QVERIFY(few < 100 && many < 200 && many < 3 * few);
}

void TestTriangleTree::nothingAndDamage() {
    QCOMPARE(TriangleTree().firstHit(Vec3::Zero(), Vec3::UnitX()).triangle, -1);
    QCOMPARE(TriangleTree(Points3(3, 0), {}).firstHit(Vec3::Zero(), Vec3::UnitX()).triangle, -1);
    Shape shape = sphere(8);
    shape.points.col(40).setConstant(std::nan(""));  // the rest can still be met
    const TriangleTree tree(shape.points, shape.triangles);
    QVERIFY(tree.firstHit({0.1, 0.2, 5}, -Vec3::UnitZ()).triangle >= 0);
}

QTEST_APPLESS_MAIN(TestTriangleTree)
#include "test_triangle_tree.moc"
