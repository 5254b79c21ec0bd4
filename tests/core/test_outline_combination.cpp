// Outlines added, subtracted and cut: areas in closed form, even-odd places, and the mesher's requirements.
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "core/meshing/outline_check.h"
#include "core/meshing/outline_combination.h"
#include "core/meshing/planar_mesher.h"

using namespace wend;

namespace {

using Loop = std::vector<Vec2>;
using enum OutlineOperation;

Loop rectangle(double x, double y, double w, double h) {
    return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

Loop reversed(Loop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

Loop ngon(const Vec2& centre, double radius, int n, double turn = 0) {
    Loop loop;
    for (int i = 0; i < n; ++i) {
        const double angle = turn + 2 * std::numbers::pi * i / n;
        loop.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return loop;
}

double ngonArea(double radius, int n) {
    return n * radius * radius * std::sin(2 * std::numbers::pi / n) / 2;
}

/// Returns the signed area of a clean outline by the shoelace formula.
double signedSum(const Outline& outline) {
    double twice = 0;
    for (const Loop& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
            twice += a.x() * b.y() - b.x() * a.y();
        }
    return twice / 2;
}

bool inside(const Outline& outline, const Vec2& p) {
    bool result = false;
    for (const Loop& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                result = !result;
        }
    return result;
}

double meshedArea(const Outline& outline) {
    PlanarMeshOptions options;
    options.vertices = 500;
    const auto mesh = meshOutline(outline, options);
    double sum = 0;
    for (const auto& cell : mesh.cells) sum += cellMeasure<2>(mesh.points, cell);
    return sum;
}

}  // namespace

class TestOutlineCombination : public QObject {
    Q_OBJECT
  private slots:
    void rectangles();
    void holesAndIslands();
    void sharedEdges();
    void cutParts();
    void linesThatCrossThemselves();
    void discs();
    void specksGo();
    void everyPlaceAsTold();
    void badPoints();
};

void TestOutlineCombination::rectangles() {
    const Outline a{{rectangle(0, 0, 10, 8)}}, b{{reversed(rectangle(6, 5, 10, 8))}};
    const Outline all = combined(a, b, Add), rest = combined(a, b, TakeAway), both = combined(a, b, Keep);
    QCOMPARE(signedSum(all), 80.0 + 80 - 12);
    QCOMPARE(signedSum(rest), 80.0 - 12);
    QCOMPARE(signedSum(both), 12.0);
    QCOMPARE(all.loops.size(), std::size_t(1));
    QCOMPARE(all.loops[0].size(), std::size_t(8));
    QCOMPARE(rest.loops[0].size(), std::size_t(6));
    QCOMPARE(both.loops[0].size(), std::size_t(4));
    QCOMPARE(areaOf(all), 148.0);
    QVERIFY(combined(a, a, TakeAway).loops.empty());
    QVERIFY(combined({}, {}, Add).loops.empty());
    QCOMPARE(signedSum(combined({}, b, Add)), 80.0);
    QVERIFY(combined(a, {{rectangle(20, 20, 1, 1)}}, Keep).loops.empty());
}

void TestOutlineCombination::holesAndIslands() {
    const Outline ring = combined({{rectangle(0, 0, 20, 20)}}, {{rectangle(5, 5, 10, 10)}}, TakeAway);
    QCOMPARE(ring.loops.size(), std::size_t(2));
    QCOMPARE(signedSum(ring), 300.0);
    const Outline island = combined(ring, {{rectangle(8, 8, 2, 2)}}, Add);
    QCOMPARE(island.loops.size(), std::size_t(3));
    QCOMPARE(signedSum(island), 304.0);
    QCOMPARE(meshedArea(island), 304.0);
    // The hole is filled again, with its island.
    QCOMPARE(signedSum(combined(island, {{rectangle(4, 4, 12, 12)}}, Add)), 400.0);
    // Holes follow the even-odd rule whatever their orientation.
    QCOMPARE(signedSum(combined({{rectangle(0, 0, 20, 20), rectangle(5, 5, 10, 10)}}, {}, Add)), 300.0);
}

/// Adjacent parts become one; a piece along an edge takes exactly the area that it covers.
void TestOutlineCombination::sharedEdges() {
    const Outline left{{rectangle(0, 0, 10, 10)}}, right{{rectangle(10, 2, 10, 6)}};
    const Outline joined = combined(left, right, Add);
    QCOMPARE(joined.loops.size(), std::size_t(1));
    QCOMPARE(signedSum(joined), 160.0);
    QCOMPARE(signedSum(combined(joined, right, TakeAway)), 100.0);
    QCOMPARE(combined(joined, right, TakeAway).loops[0].size(), std::size_t(4));
    // Two loops that touch in a corner are accepted by the mesher.
    const Outline corner = combined(left, {{rectangle(10, 10, 5, 5)}}, Add);
    QCOMPARE(corner.loops.size(), std::size_t(2));
    QCOMPARE(meshedArea(corner), 125.0);
}

/// Touching pieces are separated by a thin strip.
void TestOutlineCombination::cutParts() {
    const Outline cut = combined({{rectangle(0, 0, 100, 40)}}, {{rectangle(49.5, -5, 1, 50)}}, TakeAway);
    QCOMPARE(cut.loops.size(), std::size_t(2));
    QCOMPARE(signedSum(cut), 3960.0);
    QCOMPARE(meshedArea(cut), 3960.0);
    // A cut that does not reach through leaves a slit.
    const Outline slit = combined({{rectangle(0, 0, 100, 40)}}, {{rectangle(49.5, -5, 1, 25)}}, TakeAway);
    QCOMPARE(slit.loops.size(), std::size_t(1));
    QCOMPARE(signedSum(slit), 3980.0);
}

/// The even-odd rule decides: the middle of a figure of two crossings, and a line that comes back over
/// itself.
void TestOutlineCombination::linesThatCrossThemselves() {
    const Outline bow{{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}};
    const Outline clean = combined(bow, {}, Add);
    QCOMPARE(signedSum(clean), 50.0);
    QCOMPARE(clean.loops.size(), std::size_t(2));
    QCOMPARE(meshedArea(clean), 50.0);
    const Outline spike{{{{0, 0}, {10, 0}, {10, 5}, {30, 5}, {10, 5}, {10, 10}, {0, 10}}}};
    QCOMPARE(signedSum(combined(spike, {}, Add)), 100.0);
    QCOMPARE(combined(spike, {}, Add).loops[0].size(), std::size_t(4));
    QCOMPARE(signedSum(combined({{{{0, 0}, {5, 5}, {9, 9}}}}, {}, Add)), 0.0);
}

/// The common part of two 256-gons is between the lens of the inscribed circles and that of the outer ones.
void TestOutlineCombination::discs() {
    const int n = 256;
    const double r = 40, d = 50;
    const Outline a{{ngon({0, 0}, r, n)}}, b{{ngon({d, 0}, r, n, 0.005)}};
    const auto lens = [d](double radius) {
        return 2 * radius * radius * std::acos(d / (2 * radius)) -
               d / 2 * std::sqrt(4 * radius * radius - d * d);
    };
    const double both = signedSum(combined(a, b, Keep));
    QVERIFY(both < lens(r) && both > lens(r * std::cos(std::numbers::pi / n)));
    const double area = ngonArea(r, n), rounding = 0.5 / 4096 * 8 * r;
    QVERIFY(std::abs(signedSum(combined(a, b, Add)) - (2 * area - both)) < rounding);
    QVERIFY(std::abs(signedSum(combined(a, b, TakeAway)) - (area - both)) < rounding);
}

void TestOutlineCombination::specksGo() {
    const Outline a{{rectangle(0, 0, 100, 100)}};
    const Outline speck{{rectangle(50, 50, 3, 3), rectangle(200, 0, 3, 3), rectangle(300, 0, 30, 30)}};
    QCOMPARE(signedSum(combined(a, speck, Add, 10)), 10000.0 + 900);
    QCOMPARE(signedSum(combined(a, speck, TakeAway, 10)), 10000.0);  // no hole of 9
    QCOMPARE(signedSum(combined(a, speck, TakeAway)), 10000.0 - 9);
}

/// Random scribbles: places that are not too close to a line are classified correctly, and a mesher accepts
/// the outline.
void TestOutlineCombination::everyPlaceAsTold() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0, 100);
    const auto scribble = [&](int n) {
        Loop loop;
        for (int k = 0; k < n; ++k) loop.emplace_back(place(random), place(random));
        return loop;
    };
    for (int round = 0; round < 12; ++round) {
        const Outline a{{scribble(9), scribble(5)}}, b{{scribble(7)}};
        for (const auto operation : {Add, TakeAway, Keep}) {
            const Outline result = combined(a, b, operation);
            requireNoCrossing(result);
            int off = 0, places = 2000;
            for (int k = 0; k < places; ++k) {
                const Vec2 p(place(random), place(random));
                const bool inA = inside(a, p), inB = inside(b, p);
                const bool wanted = operation == Add    ? inA || inB
                                    : operation == Keep ? inA && inB
                                                        : inA && !inB;
                off += inside(result, p) != wanted ? 1 : 0;
                QCOMPARE(isInside(result, p), inside(result, p));
            }
            QVERIFY(off <= 2);  // within a 4096th of an edge
            if (!result.loops.empty())
                QVERIFY(std::abs(meshedArea(result) - signedSum(result)) < 1e-6 * signedSum(result));
        }
    }
}

void TestOutlineCombination::badPoints() {
    const Outline bad{{{{0, 0}, {std::nan(""), 1}, {1, 1}}}}, good{{rectangle(0, 0, 1, 1)}};
    QVERIFY_THROWS_EXCEPTION(InputError, combined(bad, good, Add));
    QVERIFY_THROWS_EXCEPTION(InputError, combined(good, bad, Add));
}

QTEST_GUILESS_MAIN(TestOutlineCombination)
#include "test_outline_combination.moc"
