// The spaces between the shells of a surface: bodies that share walls, and nested shells.

#include <QTest>
#include <map>
#include <numeric>

#include "core/meshing/surface_check.h"
#include "core/meshing/volume_mesher.h"
#include "tests/support/surfaces.h"

using namespace wend;
using namespace wend::test;

class TestShellSpaces : public QObject {
    Q_OBJECT
  private slots:
    void stacksKeepTheirLayers_data();
    void stacksKeepTheirLayers();
    void blocksOfCubes();
    void nestedShells_data();
    void nestedShells();
    void shellsThatTouch();
    void namesOfSpaces();
    void facingTrianglesAreNoFault();
    void depthsOfKnownWalls();
};

namespace {

constexpr double kRounding = 1e-12;

/// Selects how the walls between layers are there: once, or as a triangle of each layer, facing the other.
enum class Walls { Single, Doubled, Soup };

/// A stack of boxes along an axis, whose inner walls are ordered as the bits of `flips` say.
Surface stack(const std::vector<double>& heights, int axis, Walls walls, unsigned flips) {
    Surface surface;
    std::vector<Vec3> points;
    double height = -0.7;
    for (std::size_t k = 0; k <= heights.size(); ++k) {
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 p;
            p[axis] = height;
            p[(axis + 1) % 3] = corner == 1 || corner == 2 ? 1.3 : 0.1;
            p[(axis + 2) % 3] = corner >= 2 ? 0.9 : -0.2;
            points.push_back(p);
        }
        if (k < heights.size()) height += heights[k];
    }
    const auto quad = [&](int a, int b, int c, int d, bool flip) {
        if (flip) std::swap(b, d);
        surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    const int layers = static_cast<int>(heights.size());
    for (int k = 0; k <= layers; ++k) {
        const bool isInner = k > 0 && k < layers;
        const int at = 4 * k;
        quad(at, at + 1, at + 2, at + 3, isInner ? (flips >> k & 1) != 0 : k == 0);
        if (isInner && walls != Walls::Single) {
            surface.triangles.push_back({at, at + 2, at + 1});
            surface.triangles.push_back({at, at + 3, at + 2});
            if ((flips >> k & 1) != 0)
                for (std::size_t t = surface.triangles.size() - 2; t < surface.triangles.size(); ++t)
                    std::swap(surface.triangles[t][1], surface.triangles[t][2]);
        }
    }
    for (int k = 0; k < layers; ++k)
        for (int corner = 0; corner < 4; ++corner) {
            const int a = 4 * k + corner, b = 4 * k + (corner + 1) % 4;
            quad(a, b, b + 4, a + 4, false);
        }
    surface.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) surface.points.col(static_cast<int>(i)) = points[i];
    if (walls != Walls::Soup) return surface;
    Surface soup;
    soup.points.resize(3, 3 * surface.triangleCount());
    for (int t = 0; t < surface.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) soup.points.col(3 * t + k) = surface.points.col(surface.triangles[t][k]);
        soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return soup;
}

/// The volume of the cells of each label.
std::map<int, double> volumesOf(const VolumeMesh& mesh) {
    std::map<int, double> volumes;
    for (int c = 0; c < mesh.mesh.cellCount(); ++c)
        volumes[mesh.cellLabels.empty() ? 0 : mesh.cellLabels[static_cast<std::size_t>(c)]] +=
            cellMeasure<3>(mesh.mesh.points, mesh.mesh.cells[static_cast<std::size_t>(c)]);
    return volumes;
}

bool isNear(double a, double b) {
    return std::abs(a - b) <= kRounding * std::max(1.0, std::abs(b)) * 100;
}

VolumeMesh meshed(const Surface& surface, Shells shells = Shells::Automatic, bool keepSurface = true) {
    VolumeMeshOptions options;
    options.shells = shells;
    options.keepSurface = keepSurface;
    return meshVolume(surface, options);
}

/// Returns nested boxes, the outermost first, of half sides n, n − 1, …, 1.
Surface nestedBoxes(int n, bool inwards) {
    Surface all;
    for (int half = n; half > 0; --half) {
        Surface one = box(Vec3::Constant(-half), Vec3::Constant(half));
        if (inwards && half % 2 == 0)
            for (auto& t : one.triangles) std::swap(t[0], t[1]);
        one.labels.assign(one.triangles.size(), n - half + 1);
        const std::vector<int> labels = all.labels;
        all = half == n ? one : joined(all, one);
        if (half != n) {
            all.labels = labels;
            all.labels.insert(all.labels.end(), one.labels.begin(), one.labels.end());
        }
    }
    return all;
}

}  // namespace

/// 540 stacks: of 2 to 6 layers, along each axis, with six orders of the walls' triangles.
void TestShellSpaces::stacksKeepTheirLayers_data() {
    QTest::addColumn<int>("layers");
    QTest::addColumn<int>("axis");
    for (int layers = 2; layers <= 6; ++layers)
        for (int axis = 0; axis < 3; ++axis)
            QTest::addRow("%d layers along axis %d", layers, axis) << layers << axis;
}

/// Every layer keeps its volume and has a label of its own.
void TestShellSpaces::stacksKeepTheirLayers() {
    QFETCH(int, layers);
    QFETCH(int, axis);
    std::vector<double> heights;
    for (int k = 0; k < layers; ++k) heights.push_back(0.2 + 0.37 * ((3 * k) % 5));
    for (const Walls walls : {Walls::Single, Walls::Doubled, Walls::Soup})
        for (const unsigned flips : {0U, ~0U, 0x2aU, 0x14U, 0x36U, 0x08U})
            for (const bool keep : {true, false}) {
                const VolumeMesh mesh = meshed(stack(heights, axis, walls, flips), Shells::Automatic, keep);
                const auto volumes = volumesOf(mesh);
                QCOMPARE(static_cast<int>(volumes.size()), layers);
                std::vector<double> expected, found;
                for (const double height : heights) expected.push_back(1.2 * 1.1 * height);
                for (const auto& [label, volume] : volumes) {
                    QVERIFY(label >= 1 && label <= layers);
                    found.push_back(volume);
                }
                if (walls == Walls::Soup) std::ranges::sort(expected), std::ranges::sort(found);
                for (std::size_t k = 0; k < expected.size(); ++k) QVERIFY(isNear(found[k], expected[k]));
                QVERIFY(mesh.spaces.shareWalls());
            }
}

/// 3 × 2 × 2 cubes whose walls occur once: edges of four walls are inside.
void TestShellSpaces::blocksOfCubes() {
    Surface all;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k) {
                const Vec3 low(i, j, k);
                const Surface cube = box(low, low + Vec3::Ones());
                all = all.triangles.empty() ? cube : joined(all, cube);
            }
    // A wall between two cubes has two copies of each triangle, unless the diagonals differ.
    std::map<std::array<double, 9>, int> seen;
    Surface once{all.points, {}, {}};
    for (const auto& t : all.triangles) {
        std::array<std::array<double, 3>, 3> corners;
        for (int c = 0; c < 3; ++c)
            corners[c] = {all.points(0, t[c]), all.points(1, t[c]), all.points(2, t[c])};
        std::ranges::sort(corners);
        std::array<double, 9> key;
        for (int c = 0; c < 9; ++c) key[c] = corners[c / 3][c % 3];
        if (seen.try_emplace(key, 0).second) once.triangles.push_back(t);
    }
    if (!checkSurface(once).boundsVolume()) QSKIP("the diagonals of the walls differ");
    const auto volumes = volumesOf(meshed(once));
    QCOMPARE(volumes.size(), std::size_t(12));
    for (const auto& [label, volume] : volumes) QVERIFY(isNear(volume, 1));
}

void TestShellSpaces::nestedShells_data() {
    QTest::addColumn<int>("shells");
    QTest::addColumn<bool>("inwards");
    for (int shells = 1; shells <= 5; ++shells)
        for (const bool inwards : {false, true})
            QTest::addRow("%d shells%s", shells, inwards ? ", some turned inwards" : "") << shells << inwards;
}

/// Every second space between nested shells is hollow, or all are regions with labels of their own.
void TestShellSpaces::nestedShells() {
    QFETCH(int, shells);
    QFETCH(bool, inwards);
    const Surface surface = nestedBoxes(shells, inwards);
    const auto between = [](int half) {
        return 8.0 * (half * half * half - (half - 1) * (half - 1) * (half - 1));
    };
    double filled = 0;
    for (int half = shells; half > 0; half -= 2) filled += between(half);
    for (const Shells choice : {Shells::Automatic, Shells::Holes}) {
        const VolumeMesh holes = meshed(surface, choice);
        QVERIFY(isNear(volumesOf(holes)[0], filled));
        QCOMPARE(holes.spaces.filled(), (shells + 1) / 2);
        QCOMPARE(holes.spaces.deepest(), shells);
        QCOMPARE(holes.spaces.summary().text().empty(), shells == 1);
    }
    const VolumeMesh regions = meshed(surface, Shells::Regions);
    QCOMPARE(regions.spaces.filled(), shells);
    auto volumes = volumesOf(regions);
    QCOMPARE(static_cast<int>(volumes.size()), shells);
    for (int k = 1; k <= shells && shells > 1; ++k) QVERIFY(isNear(volumes[k], between(shells - k + 1)));
    QCOMPARE(regions.mesh.cellCount() == 0, false);
}

/// A shell that touches another one from inside at a vertex only is a shell of its own.
void TestShellSpaces::shellsThatTouch() {
    const Surface inner = box({0, 0, 0}, {1, 1, 1}), outer = box({0, 0, 0}, {4, 4, 4});
    Surface both = joined(outer, inner);
    both.points.rightCols(8).array() += 1;  // inside
    QCOMPARE(volumesOf(meshed(both)).begin()->second, 63.0);
    const Surface beside = joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}));
    const VolumeMesh mesh = meshed(beside);
    QVERIFY(isNear(volumesOf(mesh)[0], 2));
    QVERIFY(mesh.spaces.summary().text().empty());
}

void TestShellSpaces::namesOfSpaces() {
    VolumeMeshOptions options;
    options.shells = Shells::Regions;
    options.labelNames = {"skin", "bone", "marrow"};
    QCOMPARE(meshVolume(nestedBoxes(3, false), options).spaces.names, options.labelNames);
    // The layers' shared wall belongs to the first of them.
    Surface layers = stack({1, 2}, 2, Walls::Single, 0);
    for (const auto& t : layers.triangles) {
        const double top = std::max({layers.points(2, t[0]), layers.points(2, t[1]), layers.points(2, t[2])});
        layers.labels.push_back(top < 0.5 ? 1 : 2);
    }
    options.shells = Shells::Automatic;
    options.labelNames = {"lower", "upper"};
    QCOMPARE(meshVolume(layers, options).spaces.names, options.labelNames);
    // Names of parts of one body's border are not its name.
    Surface patched = stack({1, 2}, 2, Walls::Single, 0);
    for (int t = 0; t < patched.triangleCount(); ++t) patched.labels.push_back(t % 2 + 1);
    QCOMPARE(meshVolume(patched, options).spaces.names, std::vector<std::string>({"", ""}));
}

/// Two triangles at one place that face each other are a wall; two that face one way are a fault.
void TestShellSpaces::facingTrianglesAreNoFault() {
    Surface surface = stack({1, 2}, 2, Walls::Doubled, 0);
    QCOMPARE(checkSurface(surface).shared.size(), std::size_t(2));
    QVERIFY(checkSurface(surface).boundsVolume());
    surface.triangles.push_back(surface.triangles.front());
    QCOMPARE(checkSurface(surface).duplicate, std::vector<int>{surface.triangleCount() - 1});
    QVERIFY(!checkSurface(surface).boundsVolume());
    Surface fin = box({0, 0, 0}, {1, 1, 1});  // a double triangle that bounds nothing
    fin.triangles.push_back({0, 1, 7});
    fin.triangles.push_back({0, 7, 1});
    QVERIFY(!checkSurface(fin).boundsVolume());
}

void TestShellSpaces::depthsOfKnownWalls() {
    const std::vector<SpaceWall> walls{{{0, -1}, 0, {}, {0, 1, 2}},
                                       {{0, 1}, 1, {}, {3, 4, 5}},
                                       {{1, 2}, 1, {}, {3, 6, 7}},
                                       {{2, 0}, 1, {}, {8, 9, 5}}};
    const ShellSpaces holes = shellSpaces(3, walls, Shells::Holes, {});
    QCOMPARE(holes.spaces[0].depth, 1);
    for (const int inner : {1, 2}) {
        QCOMPARE(holes.spaces[static_cast<std::size_t>(inner)].depth, 2);
        QCOMPARE(holes.spaces[static_cast<std::size_t>(inner)].shell, 1);
    }
    QCOMPARE(holes.filled(), 1);
    QCOMPARE(holes.summary().text(),
             std::string("shells lie one in the other, up to 2 deep, and bodies touch along "
                         "shared walls; spaces filled: 1, hollow: 2"));
    QCOMPARE(shellSpaces(3, walls, Shells::Regions, {}).filled(), 3);
}

QTEST_GUILESS_MAIN(TestShellSpaces)
#include "test_shell_spaces.moc"
