#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <thread>

#include "core/base/error.h"
#include "core/meshing/surface_check.h"
#include "core/meshing/surface_holes.h"
#include "core/meshing/volume_mesher.h"
#include "tests/support/surfaces.h"

using namespace wend;
using namespace wend::test;

class TestVolumeMesher : public QObject {
    Q_OBJECT
  private slots:
    void boxIsFilled();
    void surfaceIsKept();
    void shellInShellIsAHole_data();
    void shellInShellIsAHole();
    void aimIsMet();
    void aimOfASoup();
    void labelsComeThrough();
    void splitSurfaceKeepsLabels();
    void sizeFieldIsFollowed();
    void sizesDoNotMatter_data();
    void sizesDoNotMatter();
    void soupOfTriangles();
    void strayPoints();
    void badSurfaces_data();
    void badSurfaces();
    void repairs();
    void holesThatMeet_data();
    void holesThatMeet();
    void boundariesFollowTheHoles();
    void timeLimitEnds();
    void cancelEnds();
    void checkOfAHeapEnds();
};

namespace {

double volumeOf(const SimplicialMesh<3>& mesh) {
    double sum = 0;
    for (const auto& cell : mesh.cells) sum += cellMeasure<3>(mesh.points, cell);
    return sum;
}

const Surface kBox = box({0, 0, 0}, {4, 1, 1}, 4);

Surface changed(const std::function<void(Surface&)>& change) {
    Surface surface = kBox;
    change(surface);
    return surface;
}

}  // namespace

/// Every triangle has vertices of its own: those without a cell do not count.
void TestVolumeMesher::aimOfASoup() {
    const Surface whole = box({0, 0, 0}, {4, 1, 1}, 8);
    Surface soup;
    soup.points.resize(3, 3 * whole.triangleCount());
    for (int t = 0; t < whole.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) soup.points.col(3 * t + k) = whole.points.col(whole.triangles[t][k]);
        soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    VolumeMeshOptions options;
    options.vertices = 2 * whole.vertexCount();
    const VolumeMesh mesh = meshVolume(soup, options);
    QVERIFY(mesh.aimMet && mesh.mesh.vertexCount() > 2 * mesh.usedCount());
    QVERIFY2(std::abs(mesh.usedCount() / double(options.vertices) - 1) <= 0.15,
             qPrintable(QStringLiteral("%1 of %2").arg(mesh.usedCount()).arg(options.vertices)));
}

void TestVolumeMesher::boxIsFilled() {
    VolumeMeshOptions options;
    options.maxVolume = 0.01;
    options.keepSurface = false;
    const VolumeMesh result = meshVolume(kBox, options);
    QVERIFY(std::abs(volumeOf(result.mesh) - 4) < 1e-12);
    for (const auto& cell : result.mesh.cells) {
        const double volume = cellMeasure<3>(result.mesh.points, cell);
        QVERIFY(volume > 0 && volume <= 0.01 * (1 + 1e-9));
    }
}

void TestVolumeMesher::surfaceIsKept() {
    VolumeMeshOptions options;
    options.maxVolume = 0.005;
    const VolumeMesh result = meshVolume(kBox, options);
    QVERIFY(result.mesh.vertexCount() > kBox.vertexCount());
    QVERIFY(result.mesh.points.leftCols(kBox.vertexCount()) == kBox.points);
    QCOMPARE(result.boundary.size(), kBox.triangles.size());
}

void TestVolumeMesher::shellInShellIsAHole_data() {
    QTest::addColumn<bool>("turned");
    QTest::newRow("orientations agree") << false;
    QTest::newRow("inner one turned over") << true;
}

void TestVolumeMesher::shellInShellIsAHole() {
    QFETCH(bool, turned);
    Surface inner = box({1, 0.25, 0.25}, {3, 0.75, 0.75}, 2);
    if (turned)
        for (auto& t : inner.triangles) std::swap(t[0], t[1]);
    const Surface island = box({1.5, 0.4, 0.4}, {2, 0.6, 0.6});
    const VolumeMesh result = meshVolume(joined(joined(kBox, inner), island), {});
    QVERIFY(std::abs(volumeOf(result.mesh) - (4 - 0.5 + 0.02)) < 1e-12);
}

void TestVolumeMesher::aimIsMet() {
    for (int aim : {500, 2000, 5000}) {
        VolumeMeshOptions options;
        options.vertices = aim;
        const VolumeMesh result = meshVolume(box({0, 0, 0}, {4, 1, 1}, 6), options);
        QVERIFY2(std::abs(result.mesh.vertexCount() - aim) <= 0.15 * aim,
                 qPrintable(QString::number(result.mesh.vertexCount())));
        QVERIFY(result.aimMet);
    }
}

void TestVolumeMesher::labelsComeThrough() {
    Surface surface = kBox;
    for (int t = 0; t < surface.triangleCount(); ++t) surface.labels.push_back(t / 32 + 7);  // one per side
    const VolumeMesh result = meshVolume(surface, {});
    QCOMPARE(result.boundaryLabels.size(), result.boundary.size());
    for (std::size_t f = 0; f < result.boundary.size(); ++f) {
        auto ids = result.boundary[f];
        std::sort(ids.begin(), ids.end());
        for (int t = 0; t < surface.triangleCount(); ++t) {
            auto input = surface.triangles[t];
            std::sort(input.begin(), input.end());
            if (input == ids) QCOMPARE(result.boundaryLabels[f], surface.labels[t]);
        }
    }
}

void TestVolumeMesher::splitSurfaceKeepsLabels() {
    Surface surface = kBox;
    for (int t = 0; t < surface.triangleCount(); ++t)
        surface.labels.push_back(10 * (t / 32));  // one per side
    VolumeMeshOptions options;
    options.maxVolume = 0.01;
    options.keepSurface = false;
    const VolumeMesh result = meshVolume(surface, options);
    QVERIFY(result.boundary.size() > surface.triangles.size());
    QVERIFY(result.mesh.points.leftCols(kBox.vertexCount()) == kBox.points);
    std::map<int, double> areas;
    const auto area = [](const Points3& points, const std::array<int, 3>& t) {
        return (points.col(t[1]) - points.col(t[0])).cross(points.col(t[2]) - points.col(t[0])).norm() / 2;
    };
    for (std::size_t f = 0; f < result.boundary.size(); ++f)
        areas[result.boundaryLabels[f]] += area(result.mesh.points, result.boundary[f]);
    for (int t = 0; t < surface.triangleCount(); ++t)
        areas[surface.labels[t]] -= area(surface.points, surface.triangles[t]);
    QCOMPARE(areas.size(), std::size_t(6));
    for (const auto& [label, difference] : areas) QVERIFY(std::abs(difference) < 1e-12);
}

/// Inside, where new cells are made, each is as small as its place requires; elsewhere they are not.
void TestVolumeMesher::sizeFieldIsFollowed() {
    const Surface surface = box({0, 0, 0}, {2, 2, 2}, 8);
    const Vec3 centre(1, 1, 1);
    VolumeMeshOptions options;
    options.maxVolume = 0.01;
    options.sizes =
        sampleSizes(surface, [&](const Vec3& p) { return (p - centre).norm() < 0.5 ? 0.4 : 1.0; });
    const VolumeMesh result = meshVolume(surface, options);
    QVERIFY(std::abs(volumeOf(result.mesh) - 8) < 1e-12);
    double outer = 0;
    int inner = 0, tooLarge = 0;
    for (const auto& cell : result.mesh.cells) {
        Vec3 middle = Vec3::Zero();
        for (int v : cell) middle += result.mesh.points.col(v) / 4;
        const double volume = cellMeasure<3>(result.mesh.points, cell), away = (middle - centre).norm();
        QVERIFY(volume <= 0.01 * (1 + 1e-9));
        if (away > 0.65) outer = std::max(outer, volume);
        if (away > 0.42) continue;  // the grid's nodes are 0.04 apart
        tooLarge += volume > 0.01 * 0.064 * (1 + 1e-9);
        ++inner;
    }
    QVERIFY(inner > 500);
    QVERIFY(tooLarge <= inner / 100);  // TetGen leaves a cell whose new vertex would come too close to others
    QVERIFY(outer > 0.01 * 0.3);
}

void TestVolumeMesher::sizesDoNotMatter_data() {
    QTest::addColumn<double>("size");
    QTest::newRow("huge") << 1e7;
    QTest::newRow("tiny") << 1e-7;
}

void TestVolumeMesher::sizesDoNotMatter() {
    QFETCH(double, size);
    Surface surface = kBox;
    surface.points *= size;
    VolumeMeshOptions options;
    options.vertices = 600;
    const VolumeMesh result = meshVolume(surface, options);
    QVERIFY(std::abs(volumeOf(result.mesh) / (4 * size * size * size) - 1) < 1e-12);
    QVERIFY(result.aimMet);
}

/// Every triangle has vertices of its own, as many programs write them: the surface needs no repair.
void TestVolumeMesher::soupOfTriangles() {
    Surface soup;
    soup.points.resize(3, 3 * kBox.triangleCount());
    for (int t = 0; t < kBox.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) soup.points.col(3 * t + k) = kBox.points.col(kBox.triangles[t][k]);
        soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const VolumeMesh volume = meshVolume(soup, {});
    QVERIFY(std::abs(volumeOf(volume.mesh) - 4) < 1e-12);
    QVERIFY(volume.mesh.points.leftCols(soup.vertexCount()) == soup.points);  // in their order
}

/// Points without a triangle, inside and outside, keep their numbers and have no effect.
void TestVolumeMesher::strayPoints() {
    Surface surface = kBox;
    surface.points.conservativeResize(Eigen::NoChange, kBox.vertexCount() + 2);
    surface.points.rightCols(2) << 50, 1, 50, 0.5, 50, 0.5;
    std::swap(surface.triangles.front(), surface.triangles.back());
    const VolumeMesh volume = meshVolume(surface, {});
    QVERIFY(std::abs(volumeOf(volume.mesh) - 4) < 1e-12);
    QVERIFY(volume.mesh.points.leftCols(surface.vertexCount()) == surface.points);
    for (const auto& cell : volume.mesh.cells)
        for (const int v : cell) QVERIFY(v < kBox.vertexCount() || v >= surface.vertexCount());
}

void TestVolumeMesher::badSurfaces_data() {
    QTest::addColumn<Surface>("surface");
    QTest::addColumn<QString>("reason");
    QTest::newRow("empty") << Surface{} << "no triangle";
    QTest::newRow("open") << changed([](Surface& s) { s.triangles.pop_back(); }) << "3 open edges";
    QTest::newRow("one triangle") << Surface{kBox.points, {kBox.triangles[0]}, {}} << "open edges";
    QTest::newRow("NaN") << changed([](Surface& s) { s.points(1, 3) = std::nan(""); })
                         << "not finite (first: 3)";
    QTest::newRow("infinite") << changed([](Surface& s) { s.points(0, 0) = 1 / 0.0; }) << "not finite";
    QTest::newRow("missing vertex") << changed([](Surface& s) { s.triangles[5][1] = 9999; })
                                    << "missing vertex (first: 5)";
    QTest::newRow("degenerate") << changed([](Surface& s) {
        s.triangles.push_back({0, 1, 0});
    }) << "without area";
    QTest::newRow("duplicate") << changed([](Surface& s) { s.triangles.push_back(s.triangles[0]); })
                               << "duplicate";
    QTest::newRow("shells that cross") << joined(kBox, box({3, 0.2, 0.2}, {5, 0.8, 0.8})) << "intersect";
    QTest::newRow("bodies that touch")
        << joined(kBox, box({4, 0, 0}, {6, 1, 1}, 3))
        << "volume: bodies 1 and 2 touch along a face whose triangles do not match "
           "(near 4 ";
    QTest::newRow("a small face on a large one") << joined(kBox, box({4, 0.25, 0.25}, {6, 0.75, 0.75}, 3))
                                                 << "volume: bodies 1 and 2 touch along a face";
    QTest::newRow("an edge on an edge") << joined(kBox, box({4, 1, 0}, {6, 2, 1}, 3))
                                        << "bodies 1 and 2 touch along an edge or at a point (near 4 0.9";
    QTest::newRow("three bodies") << joined(joined(kBox, box({4, 0, 0}, {6, 1, 1}, 3)),
                                            box({1, 1, 0}, {2, 2, 1}, 3))
                                  << "bodies 1 and 3 touch along a face";
    QTest::newRow("flat") << changed([](Surface& s) { s.points.row(2).setZero(); }) << "one plane";
    QTest::newRow("moebius") << moebius(24) << "open edges";
    QTest::newRow("pushed through itself")
        << changed([](Surface& s) { s.points.col(0) = Vec3(3, 3, 3); }) << "intersect";
}

void TestVolumeMesher::badSurfaces() {
    QFETCH(Surface, surface);
    QFETCH(QString, reason);
    try {
        meshVolume(surface, {});
        QFAIL("accepted");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains(reason), error.what());
    }
}

void TestVolumeMesher::repairs() {
    // A soup: every triangle with vertices of its own, some turned over, one missing, one twice, one without
    // area.
    Surface soup;
    soup.points.resize(3, 3 * kBox.triangleCount());
    for (int t = 0; t < kBox.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) soup.points.col(3 * t + k) = kBox.points.col(kBox.triangles[t][k]);
        soup.triangles.push_back(t % 5 == 1 ? std::array{3 * t, 3 * t + 2, 3 * t + 1}
                                            : std::array{3 * t, 3 * t + 1, 3 * t + 2});
    }
    soup.triangles.pop_back();
    soup.triangles.push_back(soup.triangles[0]);
    soup.triangles.push_back({0, 0, 1});
    RepairReport report;
    const Surface repaired = repairSurface(soup, 10, report);
    QVERIFY2(checkSurface(repaired).boundsVolume(),
             qPrintable(QString::fromStdString(checkSurface(repaired).summary())));
    QVERIFY(checkSurface(repaired).misoriented.empty());
    QCOMPARE(report.filledHoles, 1);
    QCOMPARE(report.droppedDuplicate, 1);
    QCOMPARE(report.droppedDegenerate, 1);
    QVERIFY(checkSurface(repairSurface(soup, 3, report)).boundsVolume());  // the hole is as large as that
    repairSurface(soup, 2, report);
    QCOMPARE(report.filledHoles, 0);
    QCOMPARE(report.largerHoles, std::vector<int>{3});
    QVERIFY(std::abs(volumeOf(meshVolume(repaired, {}).mesh) - 4) < 1e-12);
}

namespace {

/// A plate of 7 × 7 × 1 with unit squares on top, (0, 0) to (6, 6), without some triangles: both of a square,
/// or the one below or above its diagonal.
struct Taken {
    int x, y;
    bool below = true, above = true;
};

Surface plateWithout(const std::vector<Taken>& taken) {
    Surface plate = box({0, 0, 0}, {7, 7, 1}, 7);
    std::erase_if(plate.triangles, [&](const std::array<int, 3>& t) {
        const Vec3 a = plate.points.col(t[0]), b = plate.points.col(t[1]), c = plate.points.col(t[2]);
        const Vec3 middle = (a + b + c) / 3;
        if (middle.z() < 1 - 1e-9) return false;
        const double x = std::floor(middle.x()), y = std::floor(middle.y());
        const bool below = middle.y() - y < middle.x() - x;
        return std::any_of(taken.begin(), taken.end(), [&](const Taken& s) {
            return s.x == x && s.y == y && (below ? s.below : s.above);
        });
    });
    return plate;
}

}  // namespace

void TestVolumeMesher::holesThatMeet_data() {
    QTest::addColumn<Surface>("surface");
    QTest::addColumn<int>("holes");
    QTest::newRow("one") << plateWithout({{3, 3}}) << 1;
    QTest::newRow("two triangles") << plateWithout({{2, 2, true, false}, {3, 3, true, false}}) << 2;
    QTest::newRow("two squares") << plateWithout({{2, 2}, {3, 3}}) << 2;
    QTest::newRow("a chain of squares") << plateWithout({{1, 1}, {2, 2}, {3, 1}, {4, 2}, {5, 1}}) << 5;
    QTest::newRow("three triangles and one")
        << plateWithout({{3, 3, true, false}, {2, 3}, {2, 2, false, true}}) << 2;
    // Every other one of the six triangles around (3, 3).
    QTest::newRow("every other triangle")
        << plateWithout({{3, 3, true, false}, {2, 3, true, false}, {2, 2, true, false}}) << 3;
    // A triangle that hangs at a corner of a hole is no hole.
    Surface hanging = plateWithout({{3, 3}});
    hanging.points.conservativeResize(Eigen::NoChange, hanging.vertexCount() + 2);
    hanging.points.rightCols(2) << 3.5, 3.2, 3.2, 3.5, 3, 3;
    for (int v = 0; v < hanging.vertexCount(); ++v)
        if (hanging.points.col(v) == Vec3(3, 3, 1))
            hanging.triangles.push_back({v, hanging.vertexCount() - 2, hanging.vertexCount() - 1});
    QTest::newRow("a hanging triangle") << hanging << 1;
}

/// Each hole is filled separately, so that the plate is whole again.
void TestVolumeMesher::holesThatMeet() {
    QFETCH(Surface, surface);
    QFETCH(int, holes);
    QVERIFY(!checkSurface(surface).boundsVolume());
    RepairReport report;
    const Surface repaired = repairSurface(surface, 30, report);
    QCOMPARE(report.filledHoles, holes);
    const SurfaceProblems left = checkSurface(repaired);
    if (qstrcmp(QTest::currentDataTag(), "a hanging triangle") == 0) {
        QCOMPARE(left.openEdges.size(), std::size_t(3));  // its own
        return;
    }
    QVERIFY2(left.boundsVolume() && left.misoriented.empty(), left.summary().text().c_str());
    QVERIFY(std::abs(volumeOf(meshVolume(repaired, {}).mesh) - 49) < 1e-12);
}

/// Holes meet at two vertices, around two squares attached there: the boundary of one does not continue along
/// the other.
void TestVolumeMesher::boundariesFollowTheHoles() {
    const Surface surface = plateWithout({{3, 1}, {4, 2}, {4, 3}, {4, 4}, {3, 4}, {2, 4}, {2, 3}, {2, 2}});
    std::vector<std::size_t> sizes;
    for (const auto& loop : holeLoops(surface)) sizes.push_back(loop.size());
    std::sort(sizes.begin(), sizes.end());
    QCOMPARE(sizes, (std::vector<std::size_t>{4, 16}));
}

void TestVolumeMesher::timeLimitEnds() {
    VolumeMeshOptions options;
    options.maxVolume = 1e-8;  // 400 million cells
    options.timeLimit = 0.5;
    try {
        meshVolume(kBox, options);
        QFAIL("400 million cells within half a second");
    } catch (const InputError& error) {
        QVERIFY2(std::string(error.what()).find("did not finish within 0.5 s") != std::string::npos,
                 error.what());
    }
}

void TestVolumeMesher::cancelEnds() {
    std::stop_source source;
    VolumeMeshOptions options;
    options.maxVolume = 1e-8;
    options.stop = source.get_token();
    std::jthread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        source.request_stop();
    });
    QVERIFY_THROWS_EXCEPTION(Cancelled, meshVolume(kBox, options));
}

/// Four hundred walls through one line: each crosses all others.
void TestVolumeMesher::checkOfAHeapEnds() {
    constexpr int kWalls = 400;
    Surface heap{Points3(3, 3 * kWalls), {}, {}};
    for (int i = 0; i < kWalls; ++i) {
        const double angle = std::numbers::pi * i / kWalls, x = std::cos(angle), y = std::sin(angle);
        heap.points.middleCols<3>(3 * i) << -x, x, x, -y, y, y, -2, -2, 2;
        heap.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    QCOMPARE(checkSurface(heap, kWalls * kWalls).intersecting.size(), std::size_t(kWalls * (kWalls - 1) / 2));
    QCOMPARE(checkSurface(heap, 7).intersecting.size(), std::size_t(7));
    std::stop_source source;
    source.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled, checkSurface(heap, 7, source.get_token()));
}

QTEST_APPLESS_MAIN(TestVolumeMesher)
#include "test_volume_mesher.moc"
