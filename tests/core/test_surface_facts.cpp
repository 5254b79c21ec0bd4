// Areas, volumes and genus against closed forms.

#include <QTest>
#include <cmath>
#include <numbers>

#include "core/meshing/surface_facts.h"
#include "tests/support/surfaces.h"

using namespace wend;
using namespace wend::test;

class TestSurfaceFacts : public QObject {
    Q_OBJECT
  private slots:
    void sphere();
    void torus();
    void edgesOfABlock();
    void cubeWithAHole();
    void shells_data();
    void shells();
    void blocksThatMeetInAnEdge();
    void openOnes();
    void oneSided();
    void soupIsTheSame();
    void fansThatMeetInAPoint();
};

namespace {

constexpr double kPi = std::numbers::pi;

/// A grid of n × m squares closed in both directions.
Surface torusOf(double major, double minor, int n, int m) {
    Surface surface;
    surface.points.resize(3, n * m);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const double u = 2 * kPi * i / n, v = 2 * kPi * j / m, r = major + minor * std::cos(v);
            surface.points.col(i * m + j) = Vec3(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
            const int a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m,
                      d = i * m + (j + 1) % m;
            surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {a, c, d}});
        }
    return surface;
}

Surface sphereOf(double radius, int n) {
    Surface surface = box({-1, -1, -1}, {1, 1, 1}, n);
    for (int v = 0; v < surface.vertexCount(); ++v)
        surface.points.col(v) = radius * surface.points.col(v).normalized();
    return surface;
}

/// Three by three by one cubes without the middle one.
Surface framed() {
    Surface all;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y) {
            if (x == 1 && y == 1) continue;
            const Surface one = box(Vec3(x, y, 0), Vec3(x + 1, y + 1, 1));
            all = all.triangles.empty() ? one : joined(all, one);
        }
    // Walls between two cubes are removed: the two triangles of each of them coincide with opposite
    // orientation.
    const auto centre = [&](const std::array<int, 3>& t) {
        return Vec3(all.points.col(t[0]) + all.points.col(t[1]) + all.points.col(t[2]));
    };
    const auto isInner = [&](const std::array<int, 3>& t) {
        for (int axis = 0; axis < 2; ++axis) {
            const double at = all.points(axis, t[0]);
            const bool flat = all.points(axis, t[1]) == at && all.points(axis, t[2]) == at;
            const double other = centre(t)[1 - axis] / 3;
            if (flat && (at == 1 || at == 2) && (other < 1 || other > 2)) return true;
        }
        return false;
    };
    std::erase_if(all.triangles, isInner);
    return all;
}

}  // namespace

void TestSurfaceFacts::sphere() {
    const SurfaceFacts facts = factsOf(sphereOf(2, 60));
    QVERIFY(std::abs(facts.area / (16 * kPi) - 1) < 2e-3);
    QVERIFY(std::abs(*facts.volume / (32 * kPi / 3) - 1) < 2e-3);
    QCOMPARE(*facts.genus, 0);
    QCOMPARE(facts.sides, 2);
    QCOMPARE(facts.boundaryLoops, 0);
    QCOMPARE(facts.parts, 1);
    QVERIFY((facts.high - facts.low - Vec3::Constant(4)).norm() < 1e-12);
}

void TestSurfaceFacts::torus() {
    const SurfaceFacts facts = factsOf(torusOf(3, 1, 200, 100));
    QVERIFY(std::abs(facts.area / (12 * kPi * kPi) - 1) < 2e-3);
    QVERIFY(std::abs(*facts.volume / (6 * kPi * kPi) - 1) < 2e-3);
    QCOMPARE(*facts.genus, 1);
    QCOMPARE(facts.edges, 3 * 200 * 100);
    const double shortest = 2 * std::sin(kPi / 100);  // around the tube, or inside the ring
    QVERIFY(std::abs(facts.shortestEdge - std::min(shortest, 2 * 2 * std::sin(kPi / 200))) < 1e-12);
}

/// There are twelve edges and a diagonal in each of six faces.
void TestSurfaceFacts::edgesOfABlock() {
    const SurfaceFacts facts = factsOf(box({1, 1, 1}, {4, 3, 2}));
    QCOMPARE(facts.edges, 18);
    QVERIFY(std::abs(facts.shortestEdge - 1) < 1e-12);
    QVERIFY(std::abs(facts.longestEdge - std::sqrt(13)) < 1e-12);
    const double sum = 4 * (3 + 2 + 1) + 2 * (std::sqrt(13) + std::sqrt(10) + std::sqrt(5));
    QVERIFY(std::abs(facts.meanEdge - sum / 18) < 1e-12);
    QVERIFY((facts.low - Vec3(1, 1, 1)).norm() == 0 && (facts.high - Vec3(4, 3, 2)).norm() == 0);
}

void TestSurfaceFacts::cubeWithAHole() {
    const SurfaceFacts facts = factsOf(framed());
    QVERIFY(std::abs(facts.area - (2 * 8 + 12 + 4)) < 1e-12);
    QVERIFY(std::abs(*facts.volume - 8) < 1e-12);
    QCOMPARE(*facts.genus, 1);
    QCOMPARE(facts.parts, 1);
}

void TestSurfaceFacts::shells_data() {
    QTest::addColumn<bool>("turned");
    QTest::newRow("inner shell turned") << true;
    QTest::newRow("both outwards, as the mesher takes them, too") << false;
}
void TestSurfaceFacts::shells() {
    QFETCH(bool, turned);
    Surface inner = box({1, 1, 1}, {4, 4, 4});
    if (turned)
        for (auto& t : inner.triangles) std::swap(t[0], t[1]);
    const Surface hollow = joined(box({0, 0, 0}, {5, 5, 5}), inner);
    const SurfaceFacts facts = factsOf(hollow);
    QVERIFY(std::abs(*facts.volume - (125 - 27)) < 1e-10);
    QCOMPARE(facts.parts, 2);
    QCOMPARE(*facts.genus, 0);
    // A block in the hole, and one beside all of it.
    const Surface four = joined(joined(hollow, box({2, 2, 2}, {3, 3, 3})), box({7, 0, 0}, {9, 1, 1}));
    QVERIFY(std::abs(*factsOf(four).volume - (125 - 27 + 1 + 2)) < 1e-10);
}

/// Four triangles meet at one edge.
void TestSurfaceFacts::blocksThatMeetInAnEdge() {
    const SurfaceFacts facts = factsOf(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {3, 2, 1})));
    QVERIFY(std::abs(*facts.volume - 3) < 1e-12);
    QVERIFY(!facts.genus && facts.sides == 0);
}

void TestSurfaceFacts::openOnes() {
    Surface torus = torusOf(3, 1, 40, 20);
    torus.triangles.erase(torus.triangles.begin() + 100);
    torus.triangles.erase(torus.triangles.begin() + 500, torus.triangles.begin() + 502);
    const SurfaceFacts facts = factsOf(torus);
    QCOMPARE(facts.boundaryLoops, 2);
    QCOMPARE(*facts.genus, 1);
    QVERIFY(!facts.volume);
}

void TestSurfaceFacts::oneSided() {
    const SurfaceFacts facts = factsOf(moebius(30));
    QCOMPARE(facts.boundaryLoops, 1);
    QVERIFY(!facts.genus && !facts.volume);
    QCOMPARE(facts.sides, 1);
}

void TestSurfaceFacts::soupIsTheSame() {
    const Surface torus = torusOf(3, 1, 20, 10);
    Surface soup;
    soup.points.resize(3, 3 * torus.triangleCount());
    for (int t = 0; t < torus.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) soup.points.col(3 * t + k) = torus.points.col(torus.triangles[t][k]);
        soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const SurfaceFacts facts = factsOf(soup);
    QCOMPARE(*facts.genus, 1);
    QCOMPARE(facts.edges, factsOf(torus).edges);
    QCOMPARE(facts.parts, 1);
}

void TestSurfaceFacts::fansThatMeetInAPoint() {
    const SurfaceFacts facts = factsOf(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})));
    QCOMPARE(facts.parts, 2);
    QCOMPARE(*facts.genus, 0);
    QVERIFY(std::abs(*facts.volume - 2) < 1e-12);
}

QTEST_APPLESS_MAIN(TestSurfaceFacts)
#include "test_surface_facts.moc"
