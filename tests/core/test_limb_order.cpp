#include <QtTest>
#include <algorithm>
#include <numeric>
#include <random>

#include "core/mesh/limb_order.h"
#include "core/meshing/planar_mesher.h"

using namespace wend;

/// Limbs are known by construction: shapes of unit squares, each of two triangles.
class TestLimbOrder : public QObject {
    Q_OBJECT
  private slots:
    void armsLieOverTheBody_data();
    void armsLieOverTheBody();
    void fartherReachingCellsAreInFront();
    void bumpsAreNoLimbs();
    void limbsOfFiguresLieWhole_data();
    void limbsOfFiguresLieWhole();
    void componentsKeepTheirOrder();
    void nothingIsNothing();
};

namespace {

/// Each mark is a square, each blank a gap; rows are from the top. `marks` receives the mark of every cell.
SimplicialMesh<2> drawn(const QStringList& rows, QString& marks) {
    const int width = static_cast<int>(rows[0].size()) + 1;
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, width * (rows.size() + 1));
    for (int v = 0; v < mesh.points.cols(); ++v) mesh.points.col(v) = Vec2(v % width, -(v / width));
    for (int y = 0; y < rows.size(); ++y)
        for (int x = 0; x < rows[y].size(); ++x) {
            if (rows[y][x] == ' ') continue;
            const int a = y * width + x, b = a + 1, c = a + width, d = c + 1;
            mesh.cells.push_back({a, c, b});
            mesh.cells.push_back({b, c, d});
            marks += QString(2, rows[y][x]);
        }
    return mesh;
}

/// Returns the lowest and the highest place of the cells with that mark.
std::pair<int, int> placesOf(QChar mark, const QString& marks, const std::vector<int>& order) {
    int low = static_cast<int>(order.size()), high = -1;
    for (int c = 0; c < marks.size(); ++c)
        if (marks[c] == mark) {
            low = std::min(low, order[c]);
            high = std::max(high, order[c]);
        }
    return {low, high};
}

/// A figure seen from the front: a head on a neck, a trunk, two arms that stand out, two legs.
struct Figure {
    double head = 46, trunkWidth = 32, trunkLength = 150, armLength = 120, armWidth = 16, legLength = 80,
           legWidth = 18;
    int vertices = 600;

    double shoulder() const { return 20; }  // below the trunk's top, at the middle of the arms

    Outline outline() const {
        const double t = trunkWidth, a = armWidth, y = shoulder(), foot = trunkLength + legLength;
        std::vector<Vec2> half{{12, 0},
                               {t, y - a},
                               {t + armLength, y - 0.8 * a},
                               {t + armLength + 8, y},
                               {t + armLength, y + 0.8 * a},
                               {t, y + a},
                               {t, trunkLength},
                               {t + 6, foot},
                               {t + 6 - 2 * legWidth, foot}};
        std::vector<Vec2> loop = half;
        loop.push_back({0, trunkLength});
        for (auto it = half.rbegin(); it != half.rend(); ++it) loop.push_back({-it->x(), it->y()});
        const double neck = std::asin(12 / head);
        for (int k = 0; k <= 24; ++k) {  // clockwise on the screen, around the head from the left of the neck
            const double angle = neck + (2 * M_PI - 2 * neck) * k / 24;
            loop.push_back({-head * std::sin(angle), -head * std::cos(neck) - 2 + head * std::cos(angle)});
        }
        return {{loop}};
    }
    /// Returns the part of a cell: h, b, l, r (arms), m, n (legs), blank near the joints and at the
    /// shoulders, which may belong to the trunk or to an arm.
    QChar part(const Vec2& p) const {
        const double slack = std::max(0.9 * armWidth, 0.45 * trunkWidth), x = std::abs(p.x());
        if (p.y() < -8) return 'h';
        if (x > trunkWidth + slack && p.y() < shoulder() + 2 * armWidth) return p.x() < 0 ? 'l' : 'r';
        if (p.y() > trunkLength + std::max(legWidth, 0.6 * trunkWidth)) return p.x() < 0 ? 'm' : 'n';
        const double side = p.y() < shoulder() + armWidth + slack ? slack : 0.3 * armWidth;
        const bool isTrunk = p.y() > shoulder() && p.y() < trunkLength - 0.5 * trunkWidth;
        return x < trunkWidth - side && isTrunk ? 'b' : ' ';
    }
};

}  // namespace

void TestLimbOrder::armsLieOverTheBody_data() {
    QTest::addColumn<int>("seed");
    QTest::newRow("as drawn") << 0;
    for (int seed = 1; seed < 4; ++seed) QTest::addRow("mixed, seed %d", seed) << seed;
}

/// The order holds for any numbering of the cells; x is near a joint. Fingers (f, g) are over the arm (a)
/// that they grow from; the other arm (l) has the nearer tip, so that it is behind that arm with its fingers
/// as a whole.
void TestLimbOrder::armsLieOverTheBody() {
    const QStringList rows{"                  xxffffff", "     bbbbbbb      x       ",
                           "llllxbbbbbbbxaaaaaa       ", "llllxbbbbbbbxaaaaaa       ",
                           "     bbbbbbb      x       ", "     bbbbbbb      ggggg   ",
                           "     bbbbbbb              "};
    QString marks;
    SimplicialMesh<2> mesh = drawn(rows, marks);
    QFETCH(int, seed);
    if (seed) {
        std::vector<int> mixed(mesh.cells.size());
        std::iota(mixed.begin(), mixed.end(), 0);
        std::shuffle(mixed.begin(), mixed.end(), std::mt19937(static_cast<unsigned>(seed)));
        const auto cells = mesh.cells;
        const QString old = marks;
        for (std::size_t k = 0; k < mixed.size(); ++k) {
            mesh.cells[k] = cells[static_cast<std::size_t>(mixed[k])];
            marks[static_cast<int>(k)] = old[mixed[k]];
        }
    }
    const std::vector<int> order = limbOrder(mesh);
    std::vector<int> sorted = order;
    std::ranges::sort(sorted);
    for (std::size_t k = 0; k < sorted.size(); ++k) QCOMPARE(sorted[k], static_cast<int>(k));
    const auto places = [&](QChar mark) { return placesOf(mark, marks, order); };
    QVERIFY(places('l').second < places('a').first);
    QVERIFY(places('a').first < places('g').first);
    QVERIFY(places('g').second < places('f').first);  // that finger is the longer one
}

/// The order follows the distance along half a strip.
void TestLimbOrder::fartherReachingCellsAreInFront() {
    QString marks;
    const SimplicialMesh<2> mesh = drawn({QString(41, 's'), QString(41, 's'), QString(41, 's')}, marks);
    const std::vector<int> order = limbOrder(mesh);
    const auto xOf = [&mesh](int cell) {
        double x = 0;
        for (const int v : mesh.cells[static_cast<std::size_t>(cell)]) x += mesh.points(0, v) / 3;
        return x;
    };
    const int last = static_cast<int>(std::ranges::max_element(order) - order.begin());
    const double side = xOf(last) > 20.5 ? 1 : -1;
    QVERIFY(std::abs(xOf(last) - 20.5) > 19.5);
    for (int a = 0; a < mesh.cellCount(); ++a)
        for (int b = 0; b < mesh.cellCount(); ++b)  // farther by more than the strip's width
            if (side * (xOf(a) - 20.5) > 3 && side * (xOf(b) - xOf(a)) > 4)
                QVERIFY(order[static_cast<std::size_t>(b)] > order[static_cast<std::size_t>(a)]);
}

/// A row of teeth is on a tail: the tail is one limb, in which places are ordered along its path, not by the
/// teeth.
void TestLimbOrder::bumpsAreNoLimbs() {
    QString marks;
    const SimplicialMesh<2> mesh = drawn({"bbbbbb     t   t   t   t    ", "bbbbbb1111111122222223333333",
                                          "bbbbbb1111111122222223333333", "bbbbbb                      "},
                                         marks);
    const std::vector<int> order = limbOrder(mesh);
    QVERIFY(placesOf('b', marks, order).second < placesOf('2', marks, order).first);
    QVERIFY(placesOf('1', marks, order).second < placesOf('3', marks, order).first);
    QVERIFY(placesOf('t', marks, order).second < placesOf('3', marks, order).second);
}

void TestLimbOrder::limbsOfFiguresLieWhole_data() {
    QTest::addColumn<Figure>("figure");
    const auto row = [](const Figure& f) {
        QTest::addRow("head %g trunk %g x %g arms %g x %g legs %g x %g, %d vertices", f.head, f.trunkWidth,
                      f.trunkLength, f.armLength, f.armWidth, f.legLength, f.legWidth, f.vertices)
            << f;
    };
    for (double arms : {40.0, 60.0, 80.0, 100.0, 130.0, 170.0, 220.0, 300.0})
        for (double width : {9.0, 13.0, 17.0}) row({.armLength = arms, .armWidth = width});
    for (double head : {25.0, 35.0, 60.0, 90.0})
        for (double arms : {70.0, 160.0}) row({.head = head, .armLength = arms});
    for (double trunk : {24.0, 40.0, 60.0})
        for (double length : {90.0, 150.0, 220.0})
            row({.trunkWidth = trunk,
                 .trunkLength = length,
                 .armWidth = 0.4 * trunk,
                 .legWidth = 0.5 * trunk});
    for (double legs : {40.0, 140.0, 240.0})
        for (double width : {11.0, 15.0, 18.0}) row({.armWidth = 13, .legLength = legs, .legWidth = width});
    for (int vertices : {200, 400, 1500}) row({.vertices = vertices});
    std::mt19937 random(7);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / std::mt19937::max();
    };
    for (int k = 0; k < 600; ++k) {
        Figure f;
        f.trunkWidth = between(20, 60);
        f.trunkLength = between(3, 6) * f.trunkWidth;
        f.head = between(0.8, 2) * f.trunkWidth;
        f.armLength = between(1.5, 8) * f.trunkWidth;
        f.armWidth = between(0.25, 0.5) * f.trunkWidth;
        f.legLength = between(1.5, 6) * f.trunkWidth;
        f.legWidth = between(0.3, 0.5) * f.trunkWidth;
        f.vertices = static_cast<int>(between(400, 1500));
        row(f);
    }
}

/// Arms are over head and trunk, and over thicker legs; any two places of one limb are on the same side of
/// another one.
void TestLimbOrder::limbsOfFiguresLieWhole() {
    QFETCH(Figure, figure);
    PlanarMeshOptions options;
    options.vertices = figure.vertices;
    const SimplicialMesh<2> mesh = meshOutline(figure.outline(), options);
    QString marks;
    for (const Cell<2>& cell : mesh.cells)
        marks +=
            figure.part((mesh.points.col(cell[0]) + mesh.points.col(cell[1]) + mesh.points.col(cell[2])) / 3);
    const std::vector<int> order = limbOrder(mesh);
    for (const QChar arm : {'l', 'r'})
        for (const QChar other : {'h', 'b', 'm', 'n'})
            if (other < 'l' || figure.armWidth < 0.8 * figure.legWidth)
                QVERIFY2(placesOf(arm, marks, order).first > placesOf(other, marks, order).second,
                         qPrintable(QString(arm) + " over " + other));
    for (const auto& [one, other] : {std::pair('l', 'r'),
                                     {'m', 'n'},
                                     {'m', 'b'},
                                     {'n', 'b'},
                                     {'l', 'm'},
                                     {'l', 'n'},
                                     {'r', 'm'},
                                     {'r', 'n'}}) {
        const auto a = placesOf(one, marks, order), b = placesOf(other, marks, order);
        QVERIFY2(a.first > b.second || b.first > a.second, qPrintable(QString(one) + " and " + other));
    }
}

void TestLimbOrder::componentsKeepTheirOrder() {
    QString marks;
    const SimplicialMesh<2> mesh = drawn({"aaaaa", "     ", "bb   ", "     ", "ccccc", "ccccc"}, marks);
    const std::vector<int> order = limbOrder(mesh);
    QVERIFY(placesOf('a', marks, order).second < placesOf('b', marks, order).first);
    QVERIFY(placesOf('b', marks, order).second < placesOf('c', marks, order).first);
}

void TestLimbOrder::nothingIsNothing() {
    QVERIFY(limbOrder(SimplicialMesh<2>{}).empty());
}

QTEST_APPLESS_MAIN(TestLimbOrder)
#include "test_limb_order.moc"
