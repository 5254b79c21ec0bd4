// Places where a pose intersects itself, and cells that have blown up: bodies with a known number of places,
// and a brute-force test of all pairs that shares no code with ours.
#include <Eigen/LU>
#include <QElapsedTimer>
#include <QTest>
#include <cmath>
#include <numbers>
#include <numeric>

#include "app/engine/shape/pose_faults.h"
#include "app/engine/shape/shape.h"

using namespace wend;

class TestPoseFaults : public QObject {
    Q_OBJECT
  private slots:
    void bentBar_data();
    void bentBar();
    void slabsInEachOther();
    void contactAtRestIsNotReported();
    void surfaceInACage();
    void ribbonCrossesItself();
    void blownUp_data();
    void blownUp();
    void crossingsAndCellsInWords();
    void time_data();
    void time();
};

namespace {

constexpr double kPi = std::numbers::pi;

/// n[0] × n[1] × n[2] cubes from `low` to `high`, six tetrahedra each.
SimplicialMesh<3> block(const Vec3& low, const Vec3& high, const std::array<int, 3>& n) {
    SimplicialMesh<3> mesh;
    const auto id = [&](int x, int y, int z) { return (x * (n[1] + 1) + y) * (n[2] + 1) + z; };
    mesh.points.resize(3, id(n[0], n[1], n[2]) + 1);
    for (int x = 0; x <= n[0]; ++x)
        for (int y = 0; y <= n[1]; ++y)
            for (int z = 0; z <= n[2]; ++z)
                mesh.points.col(id(x, y, z)) =
                    low + Vec3(double(x) / n[0], double(y) / n[1], double(z) / n[2]).cwiseProduct(high - low);
    for (int x = 0; x < n[0]; ++x)
        for (int y = 0; y < n[1]; ++y)
            for (int z = 0; z < n[2]; ++z) {
                std::array<int, 3> way{0, 1, 2};
                do {  // along the axes in each order: positive for even ones
                    std::array<int, 3> at{x, y, z};
                    Cell<3> cell{id(x, y, z)};
                    for (int k = 0; k < 3; ++k) {
                        ++at[way[k]];
                        cell[k + 1] = id(at[0], at[1], at[2]);
                    }
                    if (cellMeasure<3>(mesh.points, cell) < 0) std::swap(cell[2], cell[3]);
                    mesh.cells.push_back(cell);
                } while (std::ranges::next_permutation(way).found);
            }
    return mesh;
}

template <int Dim>
SimplicialMesh<Dim> both(SimplicialMesh<Dim> mesh, const SimplicialMesh<Dim>& other) {
    const int first = mesh.vertexCount();
    mesh.points.conservativeResize(Eigen::NoChange, first + other.points.cols());
    mesh.points.rightCols(other.points.cols()) = other.points;
    for (Cell<Dim> cell : other.cells) {
        for (int& v : cell) v += first;
        mesh.cells.push_back(cell);
    }
    return mesh;
}

template <int Dim>
Points<Dim> mapped(const Points<Dim>& points, const std::function<Vec<Dim>(const Vec<Dim>&)>& map) {
    Points<Dim> result = points;
    for (Eigen::Index v = 0; v < points.cols(); ++v) result.col(v) = map(points.col(v));
    return result;
}

template <int Dim>
Shape<Dim> shapeOf(const SimplicialMesh<Dim>& mesh) {
    Shape<Dim> shape;
    shape.rest = std::make_shared<const SimplicialMesh<Dim>>(mesh);
    return shape;
}

template <int Dim>
PoseFaults<Dim> lookAt(const SimplicialMesh<Dim>& mesh, const Points<Dim>& pose) {
    return faultsOf<Dim>(shapeOf(mesh), pose);
}

/// Bends the bar from −2 to 2 over `angle` into a spiralling arc, so that no two faces are coplanar.
Points3 bent(const Points3& bar, double angle) {
    const double radius = 4 / angle;
    return mapped<3>(bar, [&](const Vec3& p) {
        const double at = p.x() / radius, r = radius + p.y() + 0.011 * at;
        const double uneven = 0.003 * std::sin(37 * p.x() + 51 * p.y() + 43 * p.z());
        return Vec3((r + uneven) * std::sin(at + uneven), (r + uneven) * std::cos(at + uneven),
                    p.z() + 0.0137 * at + uneven);
    });
}

bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto side = [](const Vec3& o, const Vec3& u, const Vec3& v, const Vec3& w) {
        Mat3 m;
        m << u - o, v - o, w - o;
        return m.determinant() > 0;
    };
    if (side(a, b, c, p) == side(a, b, c, q)) return false;
    const bool turn = side(p, q, a, b);
    return turn == side(p, q, b, c) && turn == side(p, q, c, a);
}

bool piercesAny(const Points3& x, const std::array<int, 3>& s, const std::array<int, 3>& t) {
    for (int k = 0; k < 3; ++k)
        if (pierces(x.col(s[k]), x.col(s[(k + 1) % 3]), x.col(t[0]), x.col(t[1]), x.col(t[2]))) return true;
    return false;
}

bool meet(const Points3& x, const std::array<int, 3>& s, const std::array<int, 3>& t) {
    return piercesAny(x, s, t) || piercesAny(x, t, s);
}

bool meet(const Points2& x, const std::array<int, 2>& s, const std::array<int, 2>& t) {
    const auto left = [&](int a, int b, int p) {
        const Vec2 u = x.col(b) - x.col(a), v = x.col(p) - x.col(a);
        return u.x() * v.y() > u.y() * v.x();
    };
    return left(s[0], s[1], t[0]) != left(s[0], s[1], t[1]) &&
           left(t[0], t[1], s[0]) != left(t[0], t[1], s[1]);
}

/// Returns all pairs of facets of the border that cross and have no vertex in common, by brute force.
template <int Dim>
int pairsByHand(const SimplicialMesh<Dim>& mesh, const Points<Dim>& pose) {
    std::vector<std::array<int, Dim>> border;
    for (const auto& facet : facetsOf<Dim>(mesh))
        if (!facet.interior()) border.push_back(facet.vertices);
    int count = 0;
    for (std::size_t i = 0; i < border.size(); ++i)
        for (std::size_t j = i + 1; j < border.size(); ++j) {
            const auto &s = border[i], &t = border[j];
            const bool apart = std::ranges::find_first_of(s, t) == s.end();
            count += apart && meet(pose, s, t);
        }
    return count;
}

/// A ribbon along (t³ − 3t, t²), which meets itself in (0, 3) at an angle of 60°.
SimplicialMesh<2> ribbon(int n) {
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, 2 * (n + 1));
    for (int i = 0; i <= n; ++i)
        for (int side = 0; side < 2; ++side)
            mesh.points.col(2 * i + side) = Vec2(4.0 * i / n - 2, 0.2 * side);
    for (int i = 0; i < n; ++i) {
        mesh.cells.push_back({2 * i, 2 * i + 2, 2 * i + 3});
        mesh.cells.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    return mesh;
}

Points2 looped(const Points2& ribbon) {
    return mapped<2>(ribbon, [](const Vec2& p) {
        const double t = p.x();
        const Vec2 along = Vec2(3 * t * t - 3, 2 * t).normalized();
        return Vec2(Vec2(t * t * t - 3 * t, t * t) + (p.y() - 0.1) * Vec2(-along.y(), along.x()));
    });
}

}  // namespace

void TestPoseFaults::bentBar_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<int>("places");
    QTest::newRow("a quarter") << 90.0 << 0;
    QTest::newRow("nearly round") << 340.0 << 0;
    QTest::newRow("through its own end") << 385.0 << 1;
}

void TestPoseFaults::bentBar() {
    QFETCH(double, degrees);
    QFETCH(int, places);
    const auto bar = block({-2, -0.2, -0.2}, {2, 0.2, 0.2}, {30, 3, 3});
    const Points3 pose = bent(bar.points, degrees * kPi / 180);
    const auto faults = lookAt<3>(bar, pose);
    QCOMPARE(static_cast<int>(faults.crossings.size()), places);
    QCOMPARE(faults.pairs(), pairsByHand<3>(bar, pose));
    QCOMPARE(faults.pairs() > 0, places > 0);
    for (const auto& place : faults.crossings) {
        // Both ends are near the bottom of the circle, a radius below its middle.
        QVERIFY((place.at - Vec3(0, -4 / (degrees * kPi / 180), 0)).norm() < 0.5);
        QVERIFY(std::ranges::is_sorted(place.members));
    }
    QVERIFY(faults.blown.empty());
}

/// One slab enters another at one place, and another one elsewhere. The larger place is reported first.
void TestPoseFaults::slabsInEachOther() {
    const auto slab = block({0, 0, 0}, {8, 3, 1}, {8, 3, 1}), small = block({1, 1, 2}, {2, 2, 3}, {2, 2, 2}),
               large = block({4, 0.5, 2}, {7, 2.5, 3}, {6, 4, 2});
    const SimplicialMesh<3> all = both<3>(both<3>(slab, small), large);
    Points3 pose = all.points;
    QCOMPARE(lookAt<3>(all, pose).pairs(), 0);
    const auto lower = [&](int from, int count) {
        pose.middleCols(from, count).colwise() += Vec3(0.013, 0.021, -1.47);
    };
    lower(slab.vertexCount(), small.vertexCount());
    const auto one = lookAt<3>(all, pose);
    QCOMPARE(one.crossings.size(), std::size_t(1));
    QCOMPARE(one.pairs(), pairsByHand<3>(all, pose));
    QVERIFY((one.crossings[0].at - Vec3(1.5, 1.5, 1)).norm() < 1);
    lower(slab.vertexCount() + small.vertexCount(), large.vertexCount());
    const auto two = lookAt<3>(all, pose);
    QCOMPARE(two.crossings.size(), std::size_t(2));
    QCOMPARE(two.pairs(), pairsByHand<3>(all, pose));
    QVERIFY(two.crossings[0].count > two.crossings[1].count);
    QCOMPARE(two.crossings[1].count, one.pairs());
    QVERIFY(two.crossings[0].at.x() > 3);
}

/// Two blocks that touch at rest are not reported, however they are rotated, whether their points meet or
/// not.
void TestPoseFaults::contactAtRestIsNotReported() {
    for (const int n : {2, 3}) {
        const auto pile =
            both<3>(block({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), block({0, 0, 1}, {1, 1, 2}, {n, n, n}));
        QCOMPARE(lookAt<3>(pile, pile.points).pairs(), 0);
        const Points3 moved = mapped<3>(pile.points, [](const Vec3& p) { return Vec3(4 * p); });
        QCOMPARE(lookAt<3>(pile, moved).pairs(), 0);
    }
}

/// The embedded surface is checked in place of its cage.
void TestPoseFaults::surfaceInACage() {
    const auto cage = block({-2.5, -0.5, -0.5}, {2.5, 0.5, 0.5}, {30, 3, 3});
    const auto bar = block({-2, -0.2, -0.2}, {2, 0.2, 0.2}, {30, 3, 3});
    Shape<3> shape = shapeOf(cage);
    shape.skin = std::make_shared<const Skin>(boundaryOf(bar));
    shape.embedding = std::make_shared<const Embedding<3>>(cage, shape.skin->points);
    shape.cage = CageFacts{};
    // Once around, the cage meets itself, the bar in it does not.
    const Points3 once = bent(cage.points, 340 * kPi / 180), more = bent(cage.points, 400 * kPi / 180);
    QVERIFY(pairsByHand<3>(cage, once) > 0);
    QCOMPARE(faultsOf<3>(shape, once).pairs(), 0);
    const auto faults = faultsOf<3>(shape, more);
    QCOMPARE(faults.crossings.size(), std::size_t(1));
    QCOMPARE(faults.border.size(), shape.skin->triangles.size());
}

/// Two straight bands cross at four points, however fine their edges are.
void TestPoseFaults::ribbonCrossesItself() {
    for (const int n : {60, 150}) {
        const auto band = ribbon(n);
        const Points2 pose = looped(band.points);
        const auto faults = lookAt<2>(band, pose);
        QCOMPARE(pairsByHand<2>(band, pose), 4);
        QCOMPARE(faults.pairs(), 4);
        QCOMPARE(faults.crossings.size(), std::size_t(4));
        // The corners of a rhombus 0.2 high whose angles are 60° and 120°: 0.2 and 0.2/√3 from its middle.
        std::vector<double> away;
        for (const auto& place : faults.crossings) away.push_back((place.at - Vec2(0, 3)).norm());
        std::ranges::sort(away);
        const double near = 0.2 / std::sqrt(3.0);
        for (int k = 0; k < 4; ++k)
            QVERIFY2(std::abs(away[k] - (k < 2 ? near : 0.2)) < 0.01, qPrintable(QString::number(away[k])));
        QCOMPARE(lookAt<2>(band, band.points).pairs(), 0);
    }
}

void TestPoseFaults::blownUp_data() {
    QTest::addColumn<double>("one");
    QTest::addColumn<double>("other");
    QTest::addColumn<int>("slices");
    QTest::addColumn<double>("worst");
    QTest::newRow("nothing") << 9.9 << 0.102 << 0 << 1.0;
    QTest::newRow("grown") << 10.1 << 0.2 << 1 << 10.1;
    QTest::newRow("shrunk") << 3.0 << 0.098 << 1 << 0.098;
    QTest::newRow("both") << 12.0 << 0.05 << 2 << 0.05;
    QTest::newRow("folded") << 12.0 << -1.0 << 2 << -1.0;
}

/// Two slices of a bar, the third and the eighth, grow or shrink by known factors.
void TestPoseFaults::blownUp() {
    QFETCH(double, one);
    QFETCH(double, other);
    QFETCH(int, slices);
    QFETCH(double, worst);
    const auto bar = block({0, 0, 0}, {10, 1, 1}, {10, 2, 2});
    const Points3 pose = mapped<3>(bar.points, [&](const Vec3& p) {
        const auto within = [&](double from) { return std::clamp(p.x() - from, 0.0, 1.0); };
        return Vec3(p.x() + (one - 1) * within(2) + (other - 1) * within(7), p.y(), p.z());
    });
    const auto faults = lookAt<3>(bar, pose);
    QCOMPARE(static_cast<int>(faults.blown.size()), slices);
    QCOMPARE(faults.cells(), slices * 4 * 6);
    if (slices == 0) return;
    QVERIFY(std::abs(faults.blown.front().ratio - worst) < 1e-9);
    const int cell = faults.blown.front().worstCell;
    QCOMPARE(cell / 24, worst == other ? 7 : 2);
    Vec3 middle = Vec3::Zero();
    for (const int v : bar.cells[cell]) middle += pose.col(v) / 4;
    QVERIFY((faults.blown.front().at - middle).norm() < 1e-12);
}

void TestPoseFaults::crossingsAndCellsInWords() {
    PoseFaults<3> solid;
    QVERIFY(crossingText(solid).empty() && blownText(solid).empty());
    solid.crossings = {{{0, 1}, 1, {1, 2, 3}}};
    QCOMPARE(
        crossingText(solid),
        std::string("the surface passes through itself in 1 place (1 pair of triangles) near (1, 2, 3)"));
    solid.crossings.push_back({{2, 3, 4}, 2, {4, 5, 6}});
    QCOMPARE(crossingText(solid), std::string("the surface passes through itself in 2 places (3 pairs of "
                                              "triangles), the first near (1, 2, 3)"));
    PoseFaults<2> flat;
    flat.blown = {{{5}, 1, {1, 2}, 5, 0.05}};
    QCOMPARE(blownText(flat), std::string("1 cell has grown or shrunk more than 10 times, in 1 place: the "
                                          "worst to 0.05 of its size near (1, 2)"));
}

void TestPoseFaults::time_data() {
    QTest::addColumn<int>("across");
    QTest::newRow("5k") << 12;
    QTest::newRow("20k") << 20;
}

/// Prints the time and does not assert it.
void TestPoseFaults::time() {
    QFETCH(int, across);
    const auto bar = block({-2, -0.2, -0.2}, {2, 0.2, 0.2}, {2 * across + 6, across, across});
    Shape<3> shape = shapeOf(bar);
    shape.facets = std::make_shared<const std::vector<Facet<3>>>(facetsOf<3>(bar));
    for (const double degrees : {90.0, 385.0}) {
        const Points3 pose = bent(bar.points, degrees * kPi / 180);
        QElapsedTimer clock;
        clock.start();
        const auto faults = faultsOf<3>(shape, pose);
        qInfo("%d vertices, %d triangles, %d pairs in %d places: %lld ms", bar.vertexCount(),
              static_cast<int>(faults.border.size()), faults.pairs(),
              static_cast<int>(faults.crossings.size()), static_cast<long long>(clock.elapsed()));
        QCOMPARE(faults.crossings.empty(), degrees < 360);
    }
}

QTEST_GUILESS_MAIN(TestPoseFaults)
#include "test_pose_faults.moc"
