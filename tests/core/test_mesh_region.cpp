#include <QtTest>
#include <cmath>
#include <limits>

#include "core/mesh/region.h"
#include "test_mesh_samples.h"

using namespace wend;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Polygon star() {  // a pentagram: even-odd leaves its middle out
    Polygon polygon;
    for (int i = 0; i < 5; ++i)
        polygon.points.emplace_back(std::sin(i * 0.8 * M_PI), std::cos(i * 0.8 * M_PI));
    return polygon;
}

Polygon square() {
    return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
}

Polygon comb() {  // concave, with vertices at the height of query points
    return {{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 1}, {2, 1}, {2, 4}, {0, 4}}};
}

template <int Dim>
std::vector<Region<Dim>> withBoundary() {
    std::vector<Region<Dim>> regions = {Ball<Dim>{Vec<Dim>::Constant(0.1), 0.6},
                                        Box<Dim>{Vec<Dim>::Constant(-0.5), Vec<Dim>::Constant(0.4)},
                                        HalfSpace<Dim>{Vec<Dim>::Constant(0.2), Vec<Dim>::LinSpaced(1, Dim)}};
    if constexpr (Dim == 2) {
        regions.push_back(star());
        regions.push_back(Polygon{{{-0.5, -0.5}, {0.7, -0.2}, {0, 0}, {0.1, 0.8}}});
    }
    return regions;
}

/// |d(p) − d(q)| ≤ |p − q| with equality along the gradient: |∇d| = 1 almost everywhere.
template <int Dim>
void distanceHasUnitSlope() {
    samples::Random random;
    for (const auto& region : withBoundary<Dim>()) {
        int steep = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec<Dim> p = random.point<Dim>(-1, 1), q = random.point<Dim>(-1, 1);
            const double d = signedDistance<Dim>(region, p);
            QVERIFY(std::abs(d - signedDistance<Dim>(region, q)) <= (p - q).norm() + 1e-14);
            Vec<Dim> gradient;
            for (int k = 0; k < Dim; ++k) {
                const Vec<Dim> step = 1e-6 * Vec<Dim>::Unit(k);
                gradient[k] =
                    (signedDistance<Dim>(region, p + step) - signedDistance<Dim>(region, p - step)) / 2e-6;
            }
            steep += std::abs(gradient.norm() - 1) < 1e-6;
        }
        QVERIFY(steep > 290);  // all but the few next to a ridge
    }
}

/// 1 inside, 0 outside, ½ on the boundary; slope bounded and continuous where the edge begins and ends.
template <int Dim>
void membershipIsSmooth() {
    const double feather = 0.3, h = 1e-5;
    samples::Random random(2);
    for (const auto& region : withBoundary<Dim>()) {
        for (int i = 0; i < 300; ++i) {
            const Vec<Dim> p = random.point<Dim>(-1, 1);
            const double d = signedDistance<Dim>(region, p), m = membership<Dim>(region, p, feather);
            if (d <= -feather / 2) QCOMPARE(m, 1.0);
            if (d >= feather / 2) QCOMPARE(m, 0.0);
            QVERIFY(m >= 0 && m <= 1);
            QCOMPARE(m > 0.5, d < 0);
            const double slope = (membership<Dim>(region, p + h * Vec<Dim>::Unit(0), feather) - m) / h;
            QVERIFY(std::abs(slope) <= 1.5 / feather + 1e-3);  // largest slope of 3t² − 2t³
            if (std::abs(std::abs(d) - feather / 2) < 1e-4) QVERIFY(std::abs(slope) < 0.05);
        }
    }
    const Region<Dim> half = HalfSpace<Dim>{Vec<Dim>::Zero(), Vec<Dim>::Unit(0)};
    QCOMPARE(membership<Dim>(half, Vec<Dim>::Zero(), feather), 0.5);
    for (double end : {-feather / 2, feather / 2}) {  // C¹: the one-sided slopes are O(h)
        const Vec<Dim> p = end * Vec<Dim>::Unit(0);
        const double m = membership<Dim>(half, p, feather);
        for (double step : {-h, h})
            QVERIFY(std::abs((membership<Dim>(half, p + step * Vec<Dim>::Unit(0), feather) - m) / step) <
                    1e-2);
    }
}

template <int Dim>
void sharpWithoutFeather() {
    samples::Random random(4);
    for (const auto& region : withBoundary<Dim>())
        for (int i = 0; i < 200; ++i) {
            const Vec<Dim> p = random.point<Dim>(-1, 1);
            const double expected = signedDistance<Dim>(region, p) <= 0 ? 1 : 0;
            QCOMPARE(membership<Dim>(region, p, 0), expected);
        }
}

template <int Dim>
void blendIsLinear() {
    const Region<Dim> blend = Blend<Dim>{Vec<Dim>::Zero(), 2 * Vec<Dim>::Unit(1)};
    QCOMPARE(signedDistance<Dim>(blend, Vec<Dim>::Zero()), -infinity);
    for (double feather : {0.0, 5.0}) {
        for (double t : {-1.0, 0.0, 0.25, 0.5, 1.0, 3.0}) {
            const Vec<Dim> p = 2 * t * Vec<Dim>::Unit(1) + 7 * Vec<Dim>::Unit(0);
            QCOMPARE(membership<Dim>(blend, p, feather), std::clamp(t, 0.0, 1.0));
        }
    }
    const Region<Dim> nowhere = Blend<Dim>{Vec<Dim>::Ones(), Vec<Dim>::Ones()};
    QCOMPARE(membership<Dim>(nowhere, Vec<Dim>::Zero(), 0), 0.0);
}

template <int Dim>
void distancesByHand() {
    const Vec<Dim> zero = Vec<Dim>::Zero(), x = Vec<Dim>::Unit(0), y = Vec<Dim>::Unit(1);
    const Region<Dim> ball = Ball<Dim>{x, 2};
    QCOMPARE(signedDistance<Dim>(ball, x), -2.0);
    QCOMPARE(signedDistance<Dim>(ball, x + 5 * y), 3.0);
    const Region<Dim> box = Box<Dim>{Vec<Dim>::Constant(-1), Vec<Dim>::Constant(2)};
    QCOMPARE(signedDistance<Dim>(box, zero), -1.0);
    QCOMPARE(signedDistance<Dim>(box, 4 * x), 2.0);
    QCOMPARE(signedDistance<Dim>(box, Vec<Dim>(5 * x + 6 * y)), 5.0);
    QCOMPARE(signedDistance<Dim>(box, 2 * x), 0.0);
    QCOMPARE(membership<Dim>(box, 2 * x, 0), 1.0);
    const Region<Dim> turned = Box<Dim>{Vec<Dim>::Constant(2), Vec<Dim>::Constant(-1)};
    QCOMPARE(signedDistance<Dim>(turned, Vec<Dim>(5 * x + 6 * y)), 5.0);
    const Region<Dim> half = HalfSpace<Dim>{x, 10 * x};
    QCOMPARE(signedDistance<Dim>(half, zero), 1.0);
    QCOMPARE(signedDistance<Dim>(half, Vec<Dim>(4 * x + y)), -3.0);
    QCOMPARE(signedDistance<Dim>(HalfSpace<Dim>{x, zero}, x), infinity);
}

}  // namespace

class TestMeshRegion : public QObject {
    Q_OBJECT

  private slots:
    void distanceHasUnitSlope2D() { distanceHasUnitSlope<2>(); }
    void distanceHasUnitSlope3D() { distanceHasUnitSlope<3>(); }
    void membershipIsSmooth2D() { membershipIsSmooth<2>(); }
    void membershipIsSmooth3D() { membershipIsSmooth<3>(); }
    void sharpWithoutFeather2D() { sharpWithoutFeather<2>(); }
    void sharpWithoutFeather3D() { sharpWithoutFeather<3>(); }
    void blendIsLinear2D() { blendIsLinear<2>(); }
    void blendIsLinear3D() { blendIsLinear<3>(); }
    void distancesByHand2D() { distancesByHand<2>(); }
    void distancesByHand3D() { distancesByHand<3>(); }

    void polygon_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<QPointF>("p");
        QTest::addColumn<double>("distance");
        QTest::newRow("square, centre") << 0 << QPointF(2, 2) << -2.0;
        QTest::newRow("square, left of it at a vertex's height") << 0 << QPointF(-1, 0) << 1.0;
        QTest::newRow("square, right of it at an edge's height") << 0 << QPointF(7, 4) << 3.0;
        QTest::newRow("square, on a corner") << 0 << QPointF(4, 4) << 0.0;
        QTest::newRow("square, on an edge") << 0 << QPointF(4, 1) << 0.0;
        QTest::newRow("square, off a corner") << 0 << QPointF(7, 8) << 5.0;
        QTest::newRow("comb, left tooth at the notch's height") << 1 << QPointF(1.5, 1) << -0.5;
        QTest::newRow("comb, in the notch") << 1 << QPointF(3, 3) << 1.0;
        QTest::newRow("comb, below the notch") << 1 << QPointF(3, 0.5) << -0.5;
        QTest::newRow("comb, right tooth") << 1 << QPointF(5, 3) << -1.0;
        QTest::newRow("star, middle is out") << 2 << QPointF(0, 0) << std::cos(0.4 * M_PI);
        QTest::newRow("star, tip on the border") << 2 << QPointF(0, 1) << 0.0;
    }
    void polygon() {
        QFETCH(int, shape);
        QFETCH(QPointF, p);
        QFETCH(double, distance);
        const Polygon shapes[] = {square(), comb(), star()};
        QVERIFY(std::abs(signedDistance<2>(shapes[shape], {p.x(), p.y()}) - distance) < 1e-14);
        auto reversed = shapes[shape];
        std::reverse(reversed.points.begin(), reversed.points.end());
        QVERIFY(std::abs(signedDistance<2>(reversed, {p.x(), p.y()}) - distance) < 1e-14);
    }
    void starTipsAreInside() { QVERIFY(signedDistance<2>(star(), {0, 0.8}) < 0); }
    void degeneratePolygons() {
        QCOMPARE(signedDistance<2>(Polygon{}, {0, 0}), infinity);
        QCOMPARE(membership<2>(Polygon{}, {0, 0}, 2), 0.0);
        QCOMPARE(signedDistance<2>(Polygon{{{3, 4}}}, {0, 0}), 5.0);
        QCOMPARE(signedDistance<2>(Polygon{{{1, -1}, {1, 1}}}, {0, 0}), 1.0);
    }
};

QTEST_APPLESS_MAIN(TestMeshRegion)
#include "test_mesh_region.moc"
