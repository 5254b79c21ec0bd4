// Single faults of surfaces are repaired one by one: counted and measured on boxes with known faults.

#include <QTest>

#include "core/base/error.h"
#include "core/meshing/fix_all.h"
#include "core/meshing/seam_weld.h"
#include "core/meshing/surface_facts.h"
#include "core/meshing/surface_faults.h"
#include "core/meshing/surface_fixes.h"
#include "tests/support/surfaces.h"

using namespace wend;
using namespace wend::test;

namespace {

using Fixes = std::vector<SurfaceFix>;

const Surface kBox = box({0, 0, 0}, {6, 6, 6}, 6);

/// Returns the box without the triangles for whose middle `gone` holds.
template <class Gone>
Surface without(Surface surface, const Gone& gone) {
    std::erase_if(surface.triangles, [&](const std::array<int, 3>& t) {
        return gone(
            Vec3((surface.points.col(t[0]) + surface.points.col(t[1]) + surface.points.col(t[2])) / 3));
    });
    return surface;
}

/// A hole of 4 edges in the top, and one of 8 in the bottom.
Surface twoHoles() {
    return without(kBox, [](const Vec3& p) {
        const bool top = p.z() > 5.9 && p.x() > 2 && p.x() < 3 && p.y() > 2 && p.y() < 3;
        return top || (p.z() < 0.1 && p.x() > 1 && p.x() < 3 && p.y() > 1 && p.y() < 3);
    });
}

std::vector<std::vector<int>> casesOf(const Surface& surface, const std::string& kind) {
    for (const FaultKind& one : faultsOf(surface, checkSurface(surface)))
        if (one.name == kind) return one.cases;
    return {};
}

Surface fixed(const Surface& surface, const Fixes& fixes) {
    return fixSurface(surface, fixes).surface;
}

}  // namespace

class TestSurfaceFixes : public QObject {
    Q_OBJECT
  private slots:
    /// Two halves of a box with a small gap between them are joined again; with a gap beyond reason they stay
    /// two.
    void seams() {
        for (const double gap : {1e-4, 0.5}) {
            Surface box;
            std::vector<Vec3> points;
            for (const double side : {0.0, 1.0})
                for (int x = 0; x < 2; ++x)
                    for (int k = 0; k < 4; ++k)
                        points.emplace_back(side + x + (side == 1 && x == 0 ? gap : 0), k == 1 || k == 2,
                                            k >= 2);
            box.points.resize(3, static_cast<Eigen::Index>(points.size()));
            for (std::size_t v = 0; v < points.size(); ++v)
                box.points.col(static_cast<Eigen::Index>(v)) = points[v];
            for (int half = 0; half < 2; ++half) {
                const int low = 8 * half, high = low + 4, end = half == 0 ? low : high;
                for (int k = 0; k < 4; ++k) {
                    box.triangles.push_back({low + k, low + (k + 1) % 4, high + k});
                    box.triangles.push_back({low + (k + 1) % 4, high + (k + 1) % 4, high + k});
                }
                box.triangles.push_back({end, end + 1, end + 2});
                box.triangles.push_back({end, end + 2, end + 3});
            }
            const SeamWeld weld = weldSeams(box);
            QCOMPARE(weld.vertices, gap < 0.1 ? 4 : 0);
            if (gap < 0.1) QVERIFY(std::abs(weld.tolerance - gap) < 1e-12);
            RepairReport report;
            QCOMPARE(checkSurface(repairSurface(box, 3, report)).openEdges.empty(), gap < 0.1);
        }
    }
    void oneHoleIsFilledAndTheOtherStays();
    void numbersStayWhatTheyAre();
    void soupIsFilledToo();
    void loosePiecesAreRemoved();
    void fillingThatHelpsNothingIsNotOffered();
    void slitIsFilledWithTheTriangleBesideIt();
    void slitsAreRepaired();
    void detachedPiecesAreRemovedToo();
    void partThatIsTurnedOver();
    void bandHasOneSide();
    void crossingDisappears();
    void oneCrossingCostsNoMoreThanAll();
    void flatAndDoubleTrianglesGo();
    void allHolesAreFilledUpToALimit();
    void allCrossingsGo();
    void allDoubleAndTurnedOnesArePutRight();
    void impossibleStepsAreRefused_data();
    void impossibleStepsAreRefused();
};

void TestSurfaceFixes::oneHoleIsFilledAndTheOtherStays() {
    const Surface surface = twoHoles();
    const auto holes = casesOf(surface, "hole");
    QCOMPARE(holes.size(), std::size_t(2));
    for (const std::size_t which : {0, 1}) {
        const int edges = static_cast<int>(holes[which].size()),
                  otherEdges = static_cast<int>(holes[1 - which].size());
        QCOMPARE(edges + otherEdges, 12);
        const FaultFix fix = fixFor(surface, {}, "hole", holes[which]);
        QCOMPARE(fix.steps.size(), std::size_t(1));
        QCOMPARE(fix.added, edges);  // a fan
        QCOMPARE(fix.dropped + fix.turned, 0);
        QCOMPARE(fix.faults, 1);
        QVERIFY(fix.changed.empty());
        const Surface after = fixed(surface, fix.steps);
        QCOMPARE(after.triangles, fix.after.surface.triangles);
        QCOMPARE(checkSurface(after).openEdges.size(), std::size_t(otherEdges));
        const FaultFix last = fixFor(surface, fix.steps, "hole", casesOf(after, "hole").at(0));
        QCOMPARE(last.faults, 0);
        const auto volume = factsOf(last.after.surface).volume;
        QVERIFY(volume && std::abs(*volume - 216) < 1e-9);
    }
}

void TestSurfaceFixes::numbersStayWhatTheyAre() {
    const Surface surface = twoHoles();
    const int all = surface.triangleCount();
    const Fixes fixes{{SurfaceFix::Kind::Drop, {3, 7}}, {SurfaceFix::Kind::Drop, {8}}};
    const FixedSurface after = fixSurface(surface, fixes);
    QCOMPARE(after.surface.triangleCount(), all - 3);
    for (std::size_t t = 0; t < after.numbers.size(); ++t)
        QVERIFY(after.surface.triangles[t] == surface.triangles[after.numbers[t]]);
    QVERIFY(after.surface.points == surface.points);
}

/// Every triangle has vertices of its own.
void TestSurfaceFixes::soupIsFilledToo() {
    const Surface whole = twoHoles();
    Surface soup;
    soup.points.resize(3, 3 * whole.triangleCount());
    for (int t = 0; t < whole.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) soup.points.col(3 * t + k) = whole.points.col(whole.triangles[t][k]);
        soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    Fixes done;
    for (int i = 0; i < 2; ++i) {
        const FaultFix fix = fixFor(soup, done, "hole", casesOf(fixed(soup, done), "hole").at(0));
        done.insert(done.end(), fix.steps.begin(), fix.steps.end());
    }
    QVERIFY(checkSurface(fixed(soup, done)).boundsVolume());
    QVERIFY(fixed(soup, done).points.leftCols(soup.vertexCount()) == soup.points);
}

void TestSurfaceFixes::loosePiecesAreRemoved() {
    Surface surface = kBox;
    surface.points.conservativeResize(Eigen::NoChange, surface.vertexCount() + 2);
    surface.points.rightCols(2) << -1, -2, -1, -1, -1, -1;
    surface.triangles.push_back({0, surface.vertexCount() - 2, surface.vertexCount() - 1});
    const FaultFix fix = fixFor(surface, {}, "hole", casesOf(surface, "hole").at(0));
    QCOMPARE(fix.dropped, 1);
    QCOMPARE(fix.changed, std::vector<int>{surface.triangleCount() - 1});
    QCOMPARE(fix.faults, 0);
}

/// The filling of a flat sheet would coincide with it.
void TestSurfaceFixes::fillingThatHelpsNothingIsNotOffered() {
    Surface sheet = without(kBox, [](const Vec3& p) { return p.z() < 5.9; });
    sheet.points.row(2).setConstant(6);
    QVERIFY(fixFor(sheet, {}, "hole", casesOf(sheet, "hole").at(0)).steps.empty());
}

/// A vertex is on an edge, up to rounding, and the triangle beyond does not have it.
Surface withSlit(double at) {
    Surface slit = box({0, 0, 0}, {1, 1, 1});
    const auto [a, b, c] = slit.triangles.back();
    slit.points.conservativeResize(Eigen::NoChange, 9);
    slit.points.col(8) = (1 - at) * slit.points.col(a) + at * slit.points.col(b);
    slit.triangles.back() = {a, 8, c};
    slit.triangles.push_back({8, b, c});
    return slit;
}

void TestSurfaceFixes::slitIsFilledWithTheTriangleBesideIt() {
    for (const double at : {0.5, 0.3}) {
        const Surface slit = withSlit(at);
        const FaultFix fix = fixFor(slit, {}, "hole", casesOf(slit, "hole").at(0));
        QCOMPARE(fix.dropped, 1);
        QCOMPARE(fix.added, 4);
        QCOMPARE(fix.faults, 0);
        QVERIFY(fix.left.boundsVolume());
        QVERIFY(std::abs(factsOf(fix.after.surface).volume.value() - 1) < 1e-12);
    }
    // A step that fills it all the same may be repeated: the added triangles have no area.
    const Surface slit = withSlit(0.5);
    const auto [a, c, d] = slit.triangles[slit.triangles.size() - 2];
    const SurfaceFix fill{SurfaceFix::Kind::Fill, {a, c}};
    QCOMPARE(fixed(slit, {fill, fill}).triangleCount(), slit.triangleCount() + 2);
}

/// The repair of all faults does the same; the new triangles keep the label, and those before them the order.
void TestSurfaceFixes::slitsAreRepaired() {
    Surface slits = joined(withSlit(0.5), withSlit(0.3));
    slits.points.rightCols(9).colwise() += Vec3(3, 0, 0);
    for (int t = 0; t < slits.triangleCount(); ++t) slits.labels.push_back(t + 1);
    RepairReport report;
    const Surface done = repairSurface(slits, 30, report);
    QVERIFY(checkSurface(done).boundsVolume());
    QCOMPARE(report.filledHoles, 2);
    QCOMPARE(report.addedTriangles, 8);
    QCOMPARE(done.labels.size(), done.triangles.size());
    QVERIFY(std::abs(factsOf(done).volume.value() - 2) < 1e-12);
    const auto added = done.labels.end() - report.addedTriangles;
    QVERIFY(std::is_sorted(done.labels.begin(), added));
    for (auto label = added; label != done.labels.end(); ++label)
        QVERIFY(*label > 0 && std::find(done.labels.begin(), added, *label) == added);
}

/// Returns a box with a needle of three sides through it, its tip outside.
Surface withNeedle() {
    Surface needle;
    const int rings = 9;
    needle.points.resize(3, 3 * rings);
    for (int i = 0; i < 3 * rings; ++i) {
        const double angle = i % 3 * 2 * M_PI / 3;
        const int ring = i / 3, next = i % 3 == 2 ? i - 2 : i + 1;
        needle.points.col(i) = Vec3(3.4 + 0.3 * cos(angle), 3.3 + 0.3 * sin(angle), ring - 0.6);
        if (ring + 1 == rings) continue;
        needle.triangles.push_back({i, next, next + 3});
        needle.triangles.push_back({i, next + 3, i + 3});
    }
    needle.triangles.push_back({2, 1, 0});
    needle.triangles.push_back({3 * rings - 3, 3 * rings - 2, 3 * rings - 1});
    return joined(kBox, needle);
}

/// A piece that was attached only by crossing triangles does not remain as a part of its own.
void TestSurfaceFixes::detachedPiecesAreRemovedToo() {
    const Surface surface = withNeedle();
    QCOMPARE(factsOf(surface).parts, 2);
    const auto cases = casesOf(surface, "crossing");
    QVERIFY(cases.size() > 3);
    for (const auto& triangles : cases) {
        const FaultFix fix = fixFor(surface, {}, "crossing", triangles);
        QVERIFY(!fix.steps.empty());
        QVERIFY(factsOf(fix.after.surface).parts <= 2);
        QVERIFY(fix.left.intersecting.size() < cases.size());
    }
}

/// One side of the box is inverted: the smaller part is turned back.
void TestSurfaceFixes::partThatIsTurnedOver() {
    Surface surface = kBox;
    int turned = 0;
    for (auto& t : surface.triangles) {
        const bool onTop = std::ranges::all_of(t, [&](int v) { return surface.points(2, v) == 6; });
        if (onTop) std::swap(t[0], t[1]);
        turned += onTop;
    }
    const auto cases = casesOf(surface, "turned_edge");
    QCOMPARE(cases.size(), std::size_t(24));
    const FaultFix fix = fixFor(surface, {}, "turned_edge", cases.at(5));
    QCOMPARE(fix.turned, turned);
    QCOMPARE(int(fix.changed.size()), turned);
    QCOMPARE(fix.faults, 0);
    QVERIFY(std::abs(factsOf(fixed(surface, fix.steps)).volume.value() - 216) < 1e-9);
}

void TestSurfaceFixes::bandHasOneSide() {
    const Surface band = moebius(24);
    QVERIFY(fixFor(band, {}, "turned_edge", casesOf(band, "turned_edge").at(0)).steps.empty());
}

/// A vertex of the top that was pushed through the bottom, far below.
void TestSurfaceFixes::crossingDisappears() {
    Surface surface = kBox;
    for (int v = 0; v < surface.vertexCount(); ++v)
        if (surface.points.col(v) == Vec3(3, 3, 6)) surface.points.col(v) = Vec3(3.1, 3.2, -1);
    const auto cases = casesOf(surface, "crossing");
    QVERIFY(!cases.empty());
    const int before = static_cast<int>(cases.size());
    Fixes done;
    int rounds = 0;
    for (Surface now = surface; !casesOf(now, "crossing").empty(); now = fixed(surface, done)) {
        QVERIFY(++rounds <= before);
        const FaultFix fix = fixFor(surface, done, "crossing", casesOf(now, "crossing").at(0));
        QVERIFY(!fix.steps.empty());
        QVERIFY(fix.dropped > 1 && fix.added > 0);
        QCOMPARE(int(fix.changed.size()), fix.dropped);
        done.insert(done.end(), fix.steps.begin(), fix.steps.end());
    }
    const SurfaceProblems left = checkSurface(fixed(surface, done));
    QVERIFY2(left.boundsVolume(), left.summary().text().c_str());
}

/// Two vertices of the top are too far aside: the triangles around them cross one another, and the filling
/// for two of them would cross a third.
void TestSurfaceFixes::oneCrossingCostsNoMoreThanAll() {
    Surface surface = kBox;
    for (int v = 0; v < surface.vertexCount(); ++v) {
        if (surface.points.col(v) == Vec3(3, 3, 6)) surface.points.col(v) = Vec3(1.5, 1.75, 5);
        if (surface.points.col(v) == Vec3(4, 3, 6)) surface.points.col(v) = Vec3(5.5, 2.25, 7.5);
    }
    const auto cases = casesOf(surface, "crossing");
    QVERIFY(cases.size() > 1);
    const FaultFix all = fixForAll(surface, {}, "crossing", 30);
    QCOMPARE(all.faults, 0);
    for (const auto& triangles : cases) {
        const FaultFix fix = fixFor(surface, {}, "crossing", triangles);
        QVERIFY(!fix.steps.empty());
        QVERIFY2(fix.dropped <= all.dropped,
                 qPrintable(QStringLiteral("%1 of %2").arg(fix.dropped).arg(all.dropped)));
    }
}

void TestSurfaceFixes::flatAndDoubleTrianglesGo() {
    Surface surface = kBox;
    surface.triangles.push_back(kBox.triangles[4]);
    surface.triangles.push_back({0, 0, 1});
    surface.triangles.push_back({0, 1, 99999});
    const int all = kBox.triangleCount();
    Fixes done;
    int left = 3, wrong = all;
    for (const char* kind : {"duplicate", "flat", "missing_vertex"}) {
        const FaultFix fix = fixFor(surface, {}, kind, casesOf(surface, kind).at(0));
        QCOMPARE(fix.changed, std::vector<int>{wrong++});
        QCOMPARE(fix.faults, 2);
        done.insert(done.end(), fix.steps.begin(), fix.steps.end());
        --left;
    }
    QCOMPARE(left, 0);
    QVERIFY(fixed(surface, done).triangles == kBox.triangles);
}

void TestSurfaceFixes::allHolesAreFilledUpToALimit() {
    const Surface surface = twoHoles();
    const FaultFix all = fixForAll(surface, {}, "hole", 30), small = fixForAll(surface, {}, "hole", 5);
    QCOMPARE(all.faults, 0);
    QVERIFY(std::abs(factsOf(all.after.surface).volume.value() - 216) < 1e-9);
    QCOMPARE(small.faults, 1);
    QCOMPARE(casesOf(small.after.surface, "hole").at(0).size(), std::size_t(8));
    QVERIFY(fixForAll(surface, {}, "hole", 3).steps.empty());
    // The steps stored in a project give the same result.
    QVERIFY(fixed(surface, all.steps).triangles == all.after.surface.triangles);
}

/// Two vertices of the top that were pushed through the bottom.
void TestSurfaceFixes::allCrossingsGo() {
    Surface surface = box({0, 0, 0}, {12, 6, 6}, 12);
    for (const double x : {3.0, 9.0})
        for (int v = 0; v < surface.vertexCount(); ++v)
            if (surface.points.col(v) == Vec3(x, 3, 6)) surface.points.col(v) = Vec3(x + 0.1, 3.2, -1);
    QVERIFY(casesOf(surface, "crossing").size() > 2);
    const FaultFix all = fixForAll(surface, {}, "crossing", 30);
    QVERIFY2(all.left.boundsVolume(), all.left.summary().text().c_str());
    QCOMPARE(all.faults, 0);
    QCOMPARE(int(all.changed.size()), all.dropped);
    QVERIFY(all.dropped > 2 && all.dropped < surface.triangleCount() / 4 && all.added > 0);
}

void TestSurfaceFixes::allDoubleAndTurnedOnesArePutRight() {
    Surface surface = kBox;
    for (const int t : {0, 1, 2, 100, 101, 200}) std::swap(surface.triangles[t][0], surface.triangles[t][1]);
    for (const int t : {7, 70, 170}) surface.triangles.push_back(kBox.triangles[t]);
    const FaultFix turned = fixForAll(surface, {}, "turned_edge", 30);
    QCOMPARE(turned.turned, 6);
    const FaultFix both = fixForAll(surface, turned.steps, "duplicate", 30);
    QCOMPARE(both.dropped, 3);
    QCOMPARE(both.faults, 0);
    QVERIFY(std::abs(factsOf(both.after.surface).volume.value() - 216) < 1e-9);
    QVERIFY(fixForAll(kBox, {}, "duplicate", 30).steps.empty());
}

void TestSurfaceFixes::impossibleStepsAreRefused_data() {
    QTest::addColumn<Fixes>("fixes");
    QTest::addColumn<QString>("reason");
    using Kind = SurfaceFix::Kind;
    QTest::newRow("no such triangle")
        << Fixes{{Kind::Drop, {99999}}} << "fixes[0]: there is no triangle 99999";
    QTest::newRow("twice") << Fixes{{Kind::Drop, {4}}, {Kind::Drop, {4}}}
                           << "fixes[1]: there is no triangle 4";
    QTest::newRow("negative") << Fixes{{Kind::Turn, {-1}}} << "fixes[0]: there is no triangle -1";
    QTest::newRow("no hole") << Fixes{{Kind::Fill, {0, 1}}} << "fixes[0]: no hole has the edge 0–1";
    QTest::newRow("no vertex") << Fixes{{Kind::Fill, {0, 99999}}} << "no hole has the edge 0–99999";
}
void TestSurfaceFixes::impossibleStepsAreRefused() {
    QFETCH(Fixes, fixes);
    QFETCH(QString, reason);
    try {
        fixSurface(kBox, fixes);
        QFAIL("taken");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains(reason), error.what());
    }
}

QTEST_APPLESS_MAIN(TestSurfaceFixes)
#include "test_surface_fixes.moc"
