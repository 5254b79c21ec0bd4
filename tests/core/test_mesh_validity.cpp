#include <Eigen/LU>
#include <QtTest>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "core/mesh/shape_size.h"
#include "test_mesh_samples.h"

using namespace wend;

namespace {

template <int Dim>
struct Damage {
    const char* name;
    std::function<void(SimplicialMesh<Dim>&)> apply;
    std::string reason;  // part of it: what, and which vertex or cell
};

template <int Dim>
std::vector<Damage<Dim>> damages() {
    using Mesh = SimplicialMesh<Dim>;
    const std::string facet = Dim == 2 ? "edge" : "face";
    return {
        {"no cell", [](Mesh& m) { m.cells.clear(); }, Dim == 2 ? "no triangle" : "no tetrahedron"},
        {"NaN", [](Mesh& m) { m.points(1, 3) = std::nan(""); }, "vertex 3 "},
        {"infinity", [](Mesh& m) { m.points(0, 2) = -std::numeric_limits<double>::infinity(); }, "vertex 2 "},
        {"index too great", [](Mesh& m) { m.cells[3][1] = m.vertexCount(); }, "cell 3 names vertex"},
        {"negative index", [](Mesh& m) { m.cells[2][0] = -1; }, "cell 2 names vertex -1"},
        {"repeated vertex", [](Mesh& m) { m.cells[1][2] = m.cells[1][0]; },
         "cell 1 names the same vertex twice"},
        {"duplicate", [](Mesh& m) { m.cells.push_back(m.cells[5]); }, "is a duplicate of cell 5"},
        {"duplicate in another order",
         [](Mesh& m) {
             auto cell = m.cells[4];
             std::reverse(cell.begin(), cell.end());
             m.cells.push_back(cell);
         },
         "is a duplicate of cell 4"},
        {"inverted", [](Mesh& m) { std::swap(m.cells[6][0], m.cells[6][1]); }, "cell 6 is inverted"},
        {"one of the others is positive",
         [](Mesh& m) {
             for (auto& cell : m.cells) std::swap(cell[0], cell[1]);
             std::swap(m.cells[2][0], m.cells[2][1]);
         },
         "cell 2 is inverted"},
        {"flat", [](Mesh& m) { m.points.col(m.cells[0][0]) = m.points.col(m.cells[0][1]); }, "has no "},
        {"flat to rounding",
         [](Mesh& m) {
             const auto last = m.vertexCount();
             m.points.conservativeResize(Eigen::NoChange, last + 2);
             m.points.col(last) = (m.points.col(m.cells[0][0]) + m.points.col(m.cells[0][1])) / 2;
             m.points.col(last + 1) = m.points.col(m.cells[0][2]);
             Cell<Dim> cell = m.cells[0];
             cell[2] = last;
             m.cells.push_back(cell);
         },
         "has no "},
        {"three cells at a facet",
         [](Mesh& m) {
             // another cell on an interior facet, its tip beyond the neighbour's
             for (const auto& f : facetsOf<Dim>(m)) {
                 if (!f.interior()) continue;
                 Cell<Dim> cell = m.cells[f.cells[0]];
                 const int tip = m.vertexCount();
                 m.points.conservativeResize(Eigen::NoChange, tip + 1);
                 for (int& v : cell)
                     if (std::find(f.vertices.begin(), f.vertices.end(), v) == f.vertices.end()) {
                         m.points.col(tip) = m.points.col(v) * 1.01;
                         v = tip;
                     }
                 if (cellMeasure<Dim>(m.points, cell) < 0) std::swap(cell[0], cell[1]);
                 m.cells.push_back(cell);
                 return;
             }
         },
         "share one " + facet},
    };
}

template <int Dim>
void addDamages() {
    for (const auto& damage : damages<Dim>())
        QTest::addRow("%dD, %s", Dim, damage.name) << Dim << damage.name;
}

template <int Dim>
void refuses(const QString& name) {
    for (const auto& damage : damages<Dim>()) {
        if (name != damage.name) continue;
        auto mesh = samples::jitteredGrid<Dim>(3);
        damage.apply(mesh);
        try {
            requireValid<Dim>(mesh);
            QFAIL("was accepted");
        } catch (const InputError& error) {
            QVERIFY2(error.reason().find(damage.reason) != std::string::npos, error.what());
        }
    }
}

template <int Dim>
void acceptsGoodMeshes() {
    auto mesh = samples::jitteredGrid<Dim>(3);
    requireValid<Dim>(mesh);
    for (double scale : {1e-100, 1e100}) {  // no absolute size counts
        auto scaled = mesh;
        scaled.points *= scale;
        requireValid<Dim>(scaled);
    }
    for (auto& cell : mesh.cells) std::swap(cell[0], cell[1]);
    requireValid<Dim>(mesh);  // all turned the other way
    auto thin = samples::grid<Dim>(3);
    thin.points.row(0) *= 1e-9;
    requireValid<Dim>(thin);
    thin.points.conservativeResize(Eigen::NoChange, thin.vertexCount() + 1);
    thin.points.col(thin.vertexCount() - 1).setConstant(5);
    requireValid<Dim>(thin);  // a vertex without a cell is no error
}

/// Euler's formula, both sides of every facet, and the order of the vertices on the boundary.
template <int Dim>
void facetsAreRight() {
    const int n = Dim == 2 ? 6 : 4;
    const auto mesh = samples::jitteredGrid<Dim>(n);
    const auto facets = facetsOf<Dim>(mesh);
    int boundary = 0;
    double enclosed = 0;
    std::set<std::array<int, Dim>> seen;
    int latest = 0;
    for (const auto& facet : facets) {
        auto key = facet.vertices;
        std::sort(key.begin(), key.end());
        QVERIFY(seen.insert(key).second);
        QVERIFY(facet.cells[0] >= latest);  // in the order of the cells that bring them
        latest = facet.cells[0];
        for (int c : facet.cells)
            for (int v : facet.vertices)
                QVERIFY(c < 0 || std::count(mesh.cells[c].begin(), mesh.cells[c].end(), v) == 1);
        if (facet.interior()) {
            QVERIFY(facet.cells[0] < facet.cells[1]);
            continue;
        }
        ++boundary;
        // divergence theorem: the boundary's cones from the origin add up to the measure
        Mat<Dim> cone;
        for (int k = 0; k < Dim; ++k) cone.col(k) = mesh.points.col(facet.vertices[k]);
        enclosed += cone.determinant() / (Dim == 2 ? 2 : 6);
    }
    double total = 0;
    for (const auto& cell : mesh.cells) total += cellMeasure<Dim>(mesh.points, cell);
    QVERIFY(std::abs(enclosed - total) < 1e-13);
    QCOMPARE(boundary, Dim == 2 ? 4 * n : 12 * n * n);
    QCOMPARE(2 * static_cast<int>(facets.size()) - boundary, (Dim + 1) * mesh.cellCount());
}

/// All cells round one vertex, in space round one edge.
template <int Dim>
SimplicialMesh<Dim> fan(int cells) {
    constexpr int kHub = Dim - 1;
    SimplicialMesh<Dim> mesh;
    mesh.points = Points<Dim>::Zero(Dim, kHub + cells);
    if constexpr (Dim == 3) mesh.points(2, 1) = 1;
    for (int i = 0; i < cells; ++i) {
        const double angle = 2 * std::numbers::pi * i / cells;
        mesh.points(0, kHub + i) = std::cos(angle), mesh.points(1, kHub + i) = std::sin(angle);
        Cell<Dim> cell;
        for (int k = 0; k < kHub; ++k) cell[k] = k;
        cell[kHub] = kHub + i, cell[kHub + 1] = kHub + (i + 1) % cells;
        mesh.cells.push_back(cell);
    }
    return mesh;
}

/// A fan is a common way to make a disc; a search through the facets of its hub would take minutes.
template <int Dim>
void facetsOfFan() {
    const int cells = 200000;
    const auto mesh = fan<Dim>(cells);
    const auto facets = facetsOf<Dim>(mesh);
    QCOMPARE(static_cast<int>(facets.size()), Dim * cells);
    std::map<std::array<int, Dim>, std::size_t> placeOf;
    std::vector<std::array<int, 2>> cellsOf;
    for (int c = 0; c < cells; ++c)
        for (int k = 0; k <= Dim; ++k) {
            std::array<int, Dim> key;
            for (int i = 0, at = 0; i <= Dim; ++i)
                if (i != k) key[at++] = mesh.cells[c][i];
            std::sort(key.begin(), key.end());
            const auto [place, isNew] = placeOf.insert({key, cellsOf.size()});
            if (isNew)
                cellsOf.push_back({c, -1});
            else
                cellsOf[place->second][1] = c;
        }
    for (const auto& facet : facets) {
        auto key = facet.vertices;
        std::sort(key.begin(), key.end());
        QCOMPARE(placeOf.at(key), static_cast<std::size_t>(&facet - facets.data()));
        QVERIFY(facet.cells == cellsOf[placeOf.at(key)]);
    }
}

/// The size of a box is its diagonal, however it is rotated, moved, scaled, and cut into cells; spare
/// vertices do not count.
template <int Dim>
void sizeIsOfTheShape() {
    for (int n : {1, 3}) {
        auto mesh = samples::grid<Dim>(n);
        Vec<Dim> sides = Vec<Dim>::Constant(2);
        sides[0] = 5, sides[Dim - 1] = 0.5;
        mesh.points = sides.asDiagonal() * mesh.points;
        const auto box = shapeSize<Dim>(mesh.points, mesh.cells);
        QVERIFY(std::abs(box.size - sides.norm()) < 1e-14);
        QVERIFY((box.centroid - 0.5 * sides).norm() < 1e-14);
        Mat<Dim> turn = Mat<Dim>::Identity();
        turn.template topLeftCorner<2, 2>() << std::cos(0.6), -std::sin(0.6), std::sin(0.6), std::cos(0.6);
        const Vec<Dim> offset = Vec<Dim>::Constant(1e5);
        Points<Dim> moved(Dim, mesh.vertexCount() + 1);
        moved << (40 * turn * mesh.points).colwise() + offset, Vec<Dim>::Constant(-1e7);
        std::swap(mesh.cells[0][0], mesh.cells[0][1]);  // the orientation does not count
        const auto other = shapeSize<Dim>(moved, mesh.cells);
        QVERIFY(std::abs(other.size - 40 * sides.norm()) < 1e-9);
        QVERIFY((other.centroid - offset - 20 * turn * sides).norm() < 1e-9);
    }
    QCOMPARE(shapeSize<Dim>({}, {}).size, 0.0);
}

}  // namespace

class TestMeshValidity : public QObject {
    Q_OBJECT

  private slots:
    void damaged_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<QString>("name");
        addDamages<2>();
        addDamages<3>();
    }
    void damaged() {
        QFETCH(int, dim);
        QFETCH(QString, name);
        dim == 2 ? refuses<2>(name) : refuses<3>(name);
    }
    void good2D() { acceptsGoodMeshes<2>(); }
    void good3D() { acceptsGoodMeshes<3>(); }
    void facets2D() { facetsAreRight<2>(); }
    void facets3D() { facetsAreRight<3>(); }
    void fan2D() { facetsOfFan<2>(); }
    void fan3D() { facetsOfFan<3>(); }
    void measures() {
        QCOMPARE(cellMeasure<2>(samples::grid<2>(1).points, {0, 1, 2}), 0.5);
        QCOMPARE(cellMeasure<3>(samples::grid<3>(1).points, {0, 1, 2, 4}), 1.0 / 6);
        QCOMPARE(boundingBoxDiagonal<3>(samples::grid<3>(2).points), std::sqrt(3.0));
        QCOMPARE(boundingBoxDiagonal<2>(Points2(2, 0)), 0.0);
    }
    void size2D() { sizeIsOfTheShape<2>(); }
    void size3D() { sizeIsOfTheShape<3>(); }
    /// The moments of a regular polygon with n corners are known.
    void sizeOfPolygon() {
        constexpr int kCorners = 12;
        Points2 points = Points2::Zero(2, kCorners + 1);
        std::vector<Cell<2>> cells;
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2 * std::numbers::pi * i / kCorners;
            points.col(i + 1) = 3 * Vec2(std::cos(angle), std::sin(angle));
            cells.push_back({0, i + 1, 1 + (i + 1) % kCorners});
        }
        const double c = std::cos(2 * std::numbers::pi / kCorners);
        QVERIFY(std::abs(shapeSize<2>(points, cells).size - std::sqrt(12 * 9 * (2 + c) / 6)) < 1e-13);
    }
};

QTEST_APPLESS_MAIN(TestMeshValidity)
#include "test_mesh_validity.moc"
