// Cages around surfaces of every kind, checked with winding numbers and counted edges: nothing of the cage's
// own.

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "core/mesh/hanging_parts.h"
#include "core/mesh/quality.h"
#include "core/meshing/cage.h"
#include "core/meshing/cage_fitter.h"
#include "core/meshing/cage_protocol.h"
#include "tests/support/surfaces.h"

using namespace wend;
using namespace wend::test;

class TestCage : public QObject {
    Q_OBJECT
  private slots:
    void holdsTheSurface_data();
    void holdsTheSurface();
    void aimIsMet_data();
    void aimIsMet();
    void volumeIsKept();
    void keepsItsDistance_data();
    void keepsItsDistance();
    void openBoxIsFilledUnlessDetailSaysNo();
    void wideGapsStayNarrowOnesClose();
    void partsThatShareCells();
    void closedSlotsAreFound_data();
    void closedSlotsAreFound();
    void obliqueSlotsAreOpened();
    void noGapIsSeen_data();
    void noGapIsSeen();
    void nothingHangsOnAPoint();
    void sizesDoNotMatter();
    void nonsenseIsRefused_data();
    void nonsenseIsRefused();
    void sameInThisProcess_data();
    void sameInThisProcess();
    void badBytesAreRefused();
    void cancelEnds();
};

namespace {

using Triangle = std::array<int, 3>;

Surface soup(const std::vector<std::array<Vec3, 3>>& triangles) {
    Surface surface;
    surface.points.resize(3, static_cast<Eigen::Index>(3 * triangles.size()));
    for (const auto& triangle : triangles) {
        const int first = 3 * surface.triangleCount();
        for (int k = 0; k < 3; ++k) surface.points.col(first + k) = triangle[k];
        surface.triangles.push_back({first, first + 1, first + 2});
    }
    return surface;
}

Surface noise(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<std::array<Vec3, 3>> triangles(count);
    for (auto& triangle : triangles)
        for (Vec3& p : triangle) p = {place(random), place(random), place(random)};
    return soup(triangles);
}

Surface looseParts() {
    Surface all = box({0, 0, 0}, {0.2, 0.2, 0.2});
    for (int i = 1; i < 122; ++i) {
        const Vec3 at(0.7 * (i % 5), 0.6 * (i / 5 % 5), 0.9 * (i / 25));
        all = joined(all, box(at, at + Vec3(0.5, 0.1, 0.3)));
    }
    return all;
}

Surface openBox() {
    Surface surface = box({0, 0, 0}, {1, 1, 1}, 6);
    std::erase_if(surface.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](int v) { return surface.points(2, v) == 1; });
    });
    return surface;
}

const std::vector<std::pair<const char*, Surface>>& surfaces() {
    static const std::vector<std::pair<const char*, Surface>> all{
        {"box", box({0, 0, 0}, {4, 1, 1}, 4)},
        {"crossing boxes", joined(box({0, 0, 0}, {3, 1, 1}, 7), box({2, 0.2, 0.2}, {5, 0.8, 0.8}))},
        {"open box", openBox()},
        {"band", moebius(40)},
        {"122 parts", looseParts()},
        {"sheet", soup({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)},
                        {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}})},
        {"triangle", soup({{Vec3(0, 0, 0), Vec3(3, 1, 0.5), Vec3(1, 1, 2)}})},
        {"coincident triangles", soup({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}})},
        {"needle", soup({{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)}})},
        {"noise", noise(3000)}};
    return all;
}

/// Faces that one cell only has, counted here.
std::vector<Triangle> boundary(const SimplicialMesh<3>& mesh) {
    std::map<Triangle, std::vector<Triangle>> faces;
    for (const auto& c : mesh.cells)
        for (Triangle face : {Triangle{c[1], c[2], c[3]}, Triangle{c[0], c[3], c[2]},
                              Triangle{c[0], c[1], c[3]}, Triangle{c[0], c[2], c[1]}}) {
            Triangle key = face;
            std::ranges::sort(key);
            faces[key].push_back(face);
        }
    std::vector<Triangle> result;
    for (const auto& [key, sides] : faces)
        if (sides.size() == 1) result.push_back(sides[0]);
    return result;
}

/// Returns the winding number of the boundary around a point, by solid angles.
double winding(const Points3& points, const std::vector<Triangle>& boundary, const Vec3& p) {
    double sum = 0;
    for (const Triangle& t : boundary) {
        const Vec3 a = points.col(t[0]) - p, b = points.col(t[1]) - p, c = points.col(t[2]) - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum +=
            2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * std::numbers::pi);
}

double volumeOf(const SimplicialMesh<3>& mesh) {
    double sum = 0;
    for (const auto& cell : mesh.cells) sum += cellMeasure<3>(mesh.points, cell);
    return sum;
}

Cage cageOf(const Surface& surface, int vertices, double detail = 0) {
    CageOptions options;
    options.vertices = vertices;
    options.detail = detail;
    return fitCage(surface, options);
}

}  // namespace

void TestCage::holdsTheSurface_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < surfaces().size(); ++i) QTest::newRow(surfaces()[i].first) << int(i);
}

void TestCage::holdsTheSurface() {
    QFETCH(int, index);
    const Surface& surface = surfaces()[index].second;
    for (const double detail : {0.0, 1.0}) {
        const Cage cage = cageOf(surface, 600, detail);
        const auto faces = boundary(cage.mesh);
        std::map<std::array<int, 2>, int> sides;
        for (const Triangle& t : faces)
            for (int k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
                ++sides[{low, high}];
            }
        for (const auto& [edge, count] : sides) QVERIFY2(count % 2 == 0, "the cage is open");

        std::mt19937 random(3);
        std::uniform_real_distribution<double> weight(0, 1);
        std::uniform_int_distribution<int> which(0, surface.triangleCount() - 1);
        for (int sample = 0; sample < 150; ++sample) {
            const auto& t = surface.triangles[which(random)];
            Vec3 w(weight(random), weight(random), weight(random));
            if (sample % 3 == 0) w = Vec3::Unit(sample / 3 % 3);  // the vertices themselves
            w /= w.sum();
            const Vec3 p = surface.points(Eigen::all, t) * w;
            const double around = winding(cage.mesh.points, faces, p);
            QVERIFY2(std::abs(around - 1) < 1e-6, qPrintable(QString::number(around)));
        }
        for (const auto& cell : cage.mesh.cells) {
            const CellQuality quality = cellQuality<3>(cage.mesh.points, cell);
            QVERIFY(std::abs(quality.measure / std::pow(cage.edge, 3) - 1.0 / 12) < 1e-9);
            QVERIFY(quality.radiusEdgeRatio < 0.8661);
        }
    }
}

void TestCage::aimIsMet_data() {
    holdsTheSurface_data();
}
void TestCage::aimIsMet() {
    QFETCH(int, index);
    for (const int aim : {150, 300, 500, 2000, 6000}) {
        const Cage cage = cageOf(surfaces()[index].second, aim);
        QVERIFY2(std::abs(cage.mesh.vertexCount() - aim) <= 0.15 * aim,
                 qPrintable(QString("%1 for %2").arg(cage.mesh.vertexCount()).arg(aim)));
        QVERIFY(cage.aimMet);
    }
}

/// Cubes reach over the surface by one of them at most, on either side.
void TestCage::volumeIsKept() {
    const Cage cage = cageOf(box({0, 0, 0}, {4, 1, 1}, 4), 20000);
    const double e = 1.1 * cage.edge, volume = volumeOf(cage.mesh);
    QVERIFY(volume > 4);
    QVERIFY2(volume < (4 + 2 * e) * (1 + 2 * e) * (1 + 2 * e), qPrintable(QString::number(volume)));
    CageOptions options;
    options.maxVolume = 0.001;
    const Cage fine = fitCage(box({0, 0, 0}, {4, 1, 1}, 4), options);
    QVERIFY(cellMeasure<3>(fine.mesh.points, fine.mesh.cells[0]) <= 0.001 * (1 + 1e-9));
}

void TestCage::keepsItsDistance_data() {
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("detail");
    for (const double offset : {1.0 / 15, 0.4, 1.5})
        for (const double detail : {0.0, 1.0})
            QTest::addRow("%.2f of %s", offset, detail > 0 ? "the gap" : "the cubes") << offset << detail;
}

/// Every place that is not farther from the surface along an axis than the given distance is inside.
void TestCage::keepsItsDistance() {
    QFETCH(double, offset);
    QFETCH(double, detail);
    const Surface surface = box({0, 0, 0}, {4, 1, 1}, 4);
    CageOptions options;
    options.vertices = 1500;
    options.offset = offset;
    options.detail = detail;
    const Cage cage = fitCage(surface, options);
    const auto faces = boundary(cage.mesh);
    const double width = detail > 0 ? std::sqrt(18) / 20 : cage.edge;  // of the diagonal
    for (int v = 0; v < surface.vertexCount(); ++v)
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-0.999, 0.999}) {
                const Vec3 p = surface.points.col(v) + side * offset * width * Vec3::Unit(axis);
                const double around = winding(cage.mesh.points, faces, p);
                QVERIFY2(std::abs(around - 1) < 1e-6, qPrintable(QString::number(around)));
            }
}

void TestCage::openBoxIsFilledUnlessDetailSaysNo() {
    QVERIFY(volumeOf(cageOf(openBox(), 6000).mesh) > 0.95);
    QVERIFY(volumeOf(cageOf(openBox(), 6000, 20).mesh) < 0.6);
    QVERIFY(volumeOf(cageOf(openBox(), 6000, 0.05).mesh) > 0.95);
}

/// Two plates side by side have a gap of a tenth, where the diagonal is 1.5.
void TestCage::wideGapsStayNarrowOnesClose() {
    const Surface plates = joined(box({0, 0, 0}, {1, 1, 0.2}), box({0, 0, 0.3}, {1, 1, 0.5}));
    const Cage open = cageOf(plates, 30000, 2), closed = cageOf(plates, 30000, 0.3);
    QCOMPARE(open.bodies, 2);
    QCOMPARE(closed.bodies, 1);
    QVERIFY(volumeOf(closed.mesh) > 0.5 && volumeOf(open.mesh) < 0.5);
}

void TestCage::partsThatShareCells() {
    const Surface one = box({0, 0, 0}, {1, 1, 1});
    const Cage near = cageOf(joined(one, box({1.01, 0, 0}, {2, 1, 1})), 800);
    QCOMPARE(near.parts, 2);
    QCOMPARE(near.apart, 1);
    const Cage far = cageOf(joined(one, box({3, 0, 0}, {4, 1, 1})), 800);
    QCOMPARE(far.apart, 2);
    QCOMPARE(far.bodies, 2);
}

namespace {

Surface turnedOver(Surface surface) {
    for (auto& t : surface.triangles) std::swap(t[0], t[1]);
    return surface;
}

}  // namespace

void TestCage::closedSlotsAreFound_data() {
    QTest::addColumn<Surface>("surface");
    QTest::addColumn<double>("slot");
    QTest::newRow("fork") << fork(0.1) << 0.1;
    QTest::newRow("narrower") << fork(0.02) << 0.02;
    QTest::newRow("turned over") << turnedOver(fork(0.05)) << 0.05;
}

/// The slot is as wide everywhere; its middle is at 0.2 + half of it.
void TestCage::closedSlotsAreFound() {
    QFETCH(Surface, surface);
    QFETCH(double, slot);
    QVERIFY(checkSurface(surface).boundsVolume());
    for (const double detail : {0.0, 0.5}) {
        const Cage closed = cageOf(surface, 1500, detail);
        QCOMPARE(closed.parts, 1);
        QCOMPARE(closed.gaps.size(), std::size_t(1));
        const ClosedGap& gap = closed.gaps[0];
        QVERIFY2(std::abs(gap.width - slot) < 1e-6, qPrintable(QString::number(gap.width)));
        QVERIFY(std::abs(gap.place.x() - (0.2 + slot / 2)) < 1e-6);
        QVERIFY(gap.place.y() > 0.2 && gap.place.y() < 1 && gap.place.z() > 0 && gap.place.z() < 1);
    }
    // Cells of a quarter of the slot leave it open, unless gaps as wide as that are to be closed.
    CageOptions options;
    options.maxVolume = std::pow(slot / 4, 3) / 12;
    if (slot < 0.1) return;  // of too many cells
    // The suggested options do so, whether cubes or the detail closed it.
    CageOptions offered;
    const Cage closed = cageOf(surface, 1500);
    QVERIFY(closed.openEdge > 0 && closed.openEdge < closed.edge);
    offered.maxVolume = std::pow(closed.openEdge, 3) / 12;
    QVERIFY(fitCage(surface, offered).gaps.empty());
    QVERIFY(fitCage(surface, options).gaps.empty());
    options.detail = 3;
    QVERIFY(fitCage(surface, options).gaps.empty());
    options.detail = 0.5;
    const Cage byDetail = fitCage(surface, options);
    QCOMPARE(byDetail.gaps.size(), std::size_t(1));
    QVERIFY(byDetail.openDetail > 0.5);
    options.detail = byDetail.openDetail;
    QVERIFY(fitCage(surface, options).gaps.empty());
}

/// A cube is longer across an oblique slot than across a straight one, and its walls face each other along
/// all axes: the suggested cubes and detail are finer than the present ones and open the slot.
void TestCage::obliqueSlotsAreOpened() {
    Surface surface = fork(0.15);
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), Vec3(1, 1, 1));
    surface.points = (turn.toRotationMatrix() * surface.points).eval();
    int closed = 0;
    for (const int vertices : {500, 1000, 1500, 2000, 3000, 4000, 6000}) {
        const Cage cage = cageOf(surface, vertices);
        if (cage.gaps.empty()) continue;
        ++closed;
        QVERIFY(std::abs(cage.gaps.back().width - 0.15) < 1e-6);
        QVERIFY2(cage.openEdge < cage.edge && cage.openDetail > 0, qPrintable(QString::number(vertices)));
        CageOptions offered;
        offered.maxVolume = std::pow(cage.openEdge > 0 ? cage.openEdge : cage.edge, 3) / 12;
        offered.detail = cage.openDetail;
        QVERIFY(fitCage(surface, offered).gaps.empty());
    }
    QVERIFY(closed > 3);
}

void TestCage::noGapIsSeen_data() {
    QTest::addColumn<Surface>("surface");
    Surface ball = box({-1, -1, -1}, {1, 1, 1}, 12);
    ball.points.colwise().normalize();
    QTest::newRow("ball") << ball;
    QTest::newRow("sheet") << box({0, 0, 0}, {1, 1, 0.01}, 6);
    QTest::newRow("long box") << box({0, 0, 0}, {4, 1, 1});
    QTest::newRow("hollow ball") << joined(ball, [&] {
        Surface inner = turnedOver(ball);
        inner.points *= 0.97;
        return inner;
    }());
    QTest::newRow("two plates") << joined(box({0, 0, 0}, {1, 1, 0.2}), box({0, 0, 0.22}, {1, 1, 0.4}));
    QTest::newRow("noise") << noise(300);
}

/// A thin or hollow part, or two parts, have no gap within a part.
void TestCage::noGapIsSeen() {
    QFETCH(Surface, surface);
    for (const double detail : {0.0, 1.0})
        QCOMPARE(cageOf(surface, 1500, detail).gaps.size(), std::size_t(0));
}

void TestCage::nothingHangsOnAPoint() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<std::array<Vec3, 3>> dust(300);
    for (auto& triangle : dust) {
        const Vec3 p(place(random), place(random), place(random));
        triangle = {p, p + Vec3(0.01, 0, 0), p + Vec3(0, 0.01, 0)};
    }
    const Cage cage = cageOf(soup(dust), 5000);
    QVERIFY(cage.bodies > 1);
    QVERIFY(hangingParts<3>(cage.mesh).empty());
}

void TestCage::sizesDoNotMatter() {
    const Surface unit = box({0, 0, 0}, {4, 1, 1}, 4);
    const int count = cageOf(unit, 1000).mesh.vertexCount();
    for (const double scale : {1e-9, 1e9}) {
        Surface scaled = unit;
        scaled.points *= scale;
        QCOMPARE(cageOf(scaled, 1000).mesh.vertexCount(), count);
    }
}

void TestCage::nonsenseIsRefused_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("nothing") << 0;
    QTest::newRow("not finite") << 1;
    QTest::newRow("missing vertex") << 2;
    QTest::newRow("a point") << 3;
    QTest::newRow("beyond all numbers") << 4;
}
void TestCage::nonsenseIsRefused() {
    QFETCH(int, which);
    Surface surface = box({0, 0, 0}, {1, 1, 1});
    if (which == 0) surface.triangles.clear();
    if (which == 1) surface.points(1, 3) = std::nan("");
    if (which == 2) surface.triangles[5][1] = 99;
    if (which == 3) surface.points.setConstant(2);
    if (which == 4) surface.points *= 1e300;
    QVERIFY_THROWS_EXCEPTION(InputError, cageOf(surface, 500));
}

void TestCage::sameInThisProcess_data() {
    holdsTheSurface_data();
    QTest::newRow("fork") << -1;
}
/// The cage is the same to the last bit.
void TestCage::sameInThisProcess() {
    QFETCH(int, index);
    const Surface surface = index < 0 ? fork(0.05) : surfaces()[index].second;
    for (const double detail : {0.0, 0.5}) {
        CageOptions options;
        options.vertices = 600;
        options.detail = detail;
        options.offset = 0.1;
        const Cage here = cageAround(surface, options), there = fitCage(surface, options);
        QVERIFY(here.mesh.points == there.mesh.points && here.mesh.cells == there.mesh.cells);
        QVERIFY(here.edge == there.edge && here.openEdge == there.openEdge &&
                here.openDetail == there.openDetail);
        QVERIFY(here.aimMet == there.aimMet && here.bodies == there.bodies && here.parts == there.parts &&
                here.apart == there.apart);
        QVERIFY(std::ranges::equal(here.gaps, there.gaps, [](const ClosedGap& a, const ClosedGap& b) {
            return a.width == b.width && a.place == b.place && a.cubeAcross == b.cubeAcross;
        }));
    }
}

/// Bytes truncated anywhere, or with more behind them, are refused.
void TestCage::badBytesAreRefused() {
    const Surface surface = box({0, 0, 0}, {1, 1, 1});
    CageOptions options;
    options.vertices = 150;
    const std::string asked = pack(CageRequest{surface, {}}),
                      answer = pack(CageReply{{}, cageAround(surface, options)});
    for (std::size_t size = 0; size <= answer.size(); size += size < 200 ? 1 : 97) {
        CageRequest request;
        CageReply reply;
        QVERIFY(size >= asked.size() || !unpack(asked.substr(0, size), request));
        QVERIFY(size == answer.size() || !unpack(answer.substr(0, size), reply));
    }
    CageReply reply;
    QVERIFY(unpack(answer, reply) && !unpack(answer + '\0', reply));
}

/// The cage would have more cells than can be made in a minute.
void TestCage::cancelEnds() {
    std::stop_source stop;
    stop.request_stop();
    CageOptions options;
    options.maxVolume = 1e-12;
    options.stop = stop.get_token();
    QVERIFY_THROWS_EXCEPTION(Cancelled, fitCage(noise(2000), options));
}

QTEST_APPLESS_MAIN(TestCage)
#include "test_cage.moc"
