#include <QtTest>
#include <algorithm>
#include <numeric>
#include <random>

#include "core/mesh/limb_order.h"

using namespace wend;

/// Limbs are known here by construction: shapes of unit squares, each of two triangles.
class TestLimbOrder : public QObject {
    Q_OBJECT
  private slots:
    void armsLieOverTheBody_data();
    void armsLieOverTheBody();
    void whatReachesFartherLiesInFront();
    void bumpsAreNoLimbs();
    void componentsKeepTheirOrder();
    void nothingIsNothing();
};

namespace {

/// Marks stand for squares, blanks for none; rows from the top. `marks` gets the mark of every cell.
SimplicialMesh<2> drawn(const QStringList& rows, QString& marks) {
    const int width = static_cast<int>(rows[0].size()) + 1;
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, width * (rows.size() + 1));
    for (int v = 0; v < mesh.points.cols(); ++v) mesh.points.col(v) = Vec<2>(v % width, -(v / width));
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

/// Of the cells with that mark the lowest and the highest place.
std::pair<int, int> placesOf(QChar mark, const QString& marks, const std::vector<int>& order) {
    int low = static_cast<int>(order.size()), high = -1;
    for (int c = 0; c < marks.size(); ++c)
        if (marks[c] == mark) {
            low = std::min(low, order[c]);
            high = std::max(high, order[c]);
        }
    return {low, high};
}

}  // namespace

void TestLimbOrder::armsLieOverTheBody_data() {
    QTest::addColumn<int>("seed");
    QTest::newRow("as drawn") << 0;
    for (int seed = 1; seed < 4; ++seed) QTest::addRow("mixed, seed %d", seed) << seed;
}

/// Whatever the cells are called. Fingers (f, g) lie over the arm (a) that they grow from; the other arm (l)
/// has the nearer tip, so that it lies behind that arm with its fingers as a whole.
void TestLimbOrder::armsLieOverTheBody() {
    const QStringList rows{"                  ffffff", "     bbbbbbb      f     ", "lllllbbbbbbbaaaaaaa     ",
                           "lllllbbbbbbbaaaaaaa     ", "     bbbbbbb      g     ", "     bbbbbbb      ggggg ",
                           "     bbbbbbb            "};
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

/// Along half a strip.
void TestLimbOrder::whatReachesFartherLiesInFront() {
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

/// A row of teeth on a tail: the tail is one limb, in which places follow the way, not the teeth.
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
