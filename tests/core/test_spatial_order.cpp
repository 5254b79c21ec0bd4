// Vertices and cells along a space-filling curve: the same mesh, with neighbours near in memory.
#include <QTest>
#include <algorithm>
#include <numeric>

#include "core/meshing/spatial_order.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestSpatialOrder : public QObject {
    Q_OBJECT
  private slots:
    void sameMesh2() { sameMesh<2>(); }
    void sameMesh3() { sameMesh<3>(); }
    void neighboursAreNear() {
        nearness<2>(40);
        nearness<3>(12);
    }

  private:
    template <int Dim>
    static SimplicialMesh<Dim> shuffled(int n) {
        std::mt19937 random(5);
        auto mesh = unitGrid<Dim>(n, 0.1, random);
        std::vector<int> number(mesh.vertexCount());
        std::iota(number.begin(), number.end(), 0);
        std::shuffle(number.begin(), number.end(), random);
        const Points<Dim> points = mesh.points;
        for (int v = 0; v < mesh.vertexCount(); ++v) mesh.points.col(number[v]) = points.col(v);
        for (auto& cell : mesh.cells)
            for (int& v : cell) v = number[v];
        std::shuffle(mesh.cells.begin(), mesh.cells.end(), random);
        return mesh;
    }

    template <int Dim>
    static void sameMesh() {
        const auto before = shuffled<Dim>(6);
        auto after = before;
        const int first = 10;
        const auto number = sortSpatially<Dim>(after, first);
        for (int v = 0; v < before.vertexCount(); ++v) {
            if (v < first) QCOMPARE(number[v], v);
            QVERIFY(after.points.col(number[v]) == before.points.col(v));
        }
        auto expected = before.cells, cells = after.cells;
        for (auto& cell : expected)
            for (int& v : cell) v = number[v];
        QVERIFY(cells != expected);
        std::sort(expected.begin(), expected.end());
        std::sort(cells.begin(), cells.end());
        QVERIFY(cells == expected);
    }

    /// Returns the mean distance of the numbers of a cell's vertices, and that of the numbers of neighbouring
    /// cells' vertices.
    template <int Dim>
    static double meanDistance(const SimplicialMesh<Dim>& mesh) {
        double sum = 0;
        for (int c = 0; c < mesh.cellCount(); ++c) {
            const auto [minimum, maximum] = std::minmax_element(mesh.cells[c].begin(), mesh.cells[c].end());
            sum += *maximum - *minimum;
            if (c > 0) sum += std::abs(mesh.cells[c][0] - mesh.cells[c - 1][0]);
        }
        return sum / mesh.cellCount();
    }
    template <int Dim>
    static void nearness(int n) {
        auto mesh = shuffled<Dim>(n);
        const double before = meanDistance<Dim>(mesh);
        sortSpatially<Dim>(mesh, 0);
        // Random numbers are apart by a third of all; those on the curve by about n^(1 − 1/Dim) of n.
        QVERIFY2(meanDistance<Dim>(mesh) < before / 4,
                 qPrintable(QString("%1 of %2").arg(meanDistance<Dim>(mesh)).arg(before)));
    }
};

QTEST_APPLESS_MAIN(TestSpatialOrder)
#include "test_spatial_order.moc"
