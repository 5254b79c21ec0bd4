// Parts that touch: where they are joined, and where they only touch.

#include <QtTest>

#include "core/mesh/hanging_parts.h"
#include "core/mesh/joined_parts.h"
#include "core/mesh/used_vertices.h"
#include "test_mesh_samples.h"
#include "tests/support/surfaces.h"

using namespace wend;

namespace {

/// Every cell with vertices of its own.
template <int Dim>
SimplicialMesh<Dim> soupOf(const SimplicialMesh<Dim>& mesh) {
    SimplicialMesh<Dim> soup;
    soup.points.resize(Dim, mesh.cellCount() * (Dim + 1));
    for (int c = 0; c < mesh.cellCount(); ++c) {
        Cell<Dim> cell;
        for (int k = 0; k <= Dim; ++k) {
            cell[k] = c * (Dim + 1) + k;
            soup.points.col(cell[k]) = mesh.points.col(mesh.cells[c][k]);
        }
        soup.cells.push_back(cell);
    }
    return soup;
}

template <int Dim>
SimplicialMesh<Dim> together(const SimplicialMesh<Dim>& a, const SimplicialMesh<Dim>& b,
                             const Vec<Dim>& move) {
    SimplicialMesh<Dim> both = a;
    both.points.resize(Dim, a.vertexCount() + b.vertexCount());
    both.points << a.points, b.points.colwise() + move;
    for (auto cell : b.cells) {
        for (int& v : cell) v += a.vertexCount();
        both.cells.push_back(cell);
    }
    return both;
}

template <int Dim>
void soupHangsTogether() {
    const auto grid = samples::jitteredGrid<Dim>(3);
    const auto joined = joinedParts<Dim>(soupOf<Dim>(grid));
    const auto facets = [](const SimplicialMesh<Dim>& mesh) { return facetsOf<Dim>(mesh).size(); };
    QCOMPARE(facets(joined.mesh), facets(grid));
    QCOMPARE(joined.vertices, joined.mesh.vertexCount() - grid.vertexCount());
    QCOMPARE(joined.mesh.vertexCount(), grid.cellCount() * (Dim + 1));  // all stay, and move along
    QCOMPARE(static_cast<int>(twinsOf<Dim>(joined.mesh).size()), joined.vertices);
    for (int c = 0; c < grid.cellCount(); ++c)
        for (int k = 0; k <= Dim; ++k)
            QVERIFY(joined.mesh.points.col(joined.mesh.cells[c][k]) == grid.points.col(grid.cells[c][k]));
}

/// Layers that share places but not boundaries do not affect each other.
template <int Dim>
void layersStayApart() {
    const auto grid = samples::grid<Dim>(2);
    Vec<Dim> half = Vec<Dim>::Zero();
    half[0] = 0.5;
    QCOMPARE(joinedParts<Dim>(together<Dim>(grid, grid, half)).vertices, 0);
    QCOMPARE(joinedParts<Dim>(together<Dim>(grid, grid, Vec<Dim>::Zero())).vertices, 0);
    QCOMPARE(joinedParts<Dim>(grid).vertices, 0);
    Vec<Dim> beside = Vec<Dim>::Zero();
    beside[0] = 1;
    QCOMPARE(joinedParts<Dim>(together<Dim>(grid, grid, beside)).vertices, Dim == 2 ? 3 : 9);
}

std::vector<int> jointsOf(const std::vector<HangingPart>& parts) {
    std::vector<int> joints;
    for (const auto& part : parts) joints.insert(joints.end(), part.joint.begin(), part.joint.end());
    return joints;
}

/// A second grid at the corner, or in space along an edge, of a first one, joined by their common vertices.
template <int Dim>
SimplicialMesh<Dim> touching(int directions) {
    const auto large = samples::grid<Dim>(2), small = samples::grid<Dim>(1);
    Vec<Dim> move = Vec<Dim>::Zero();
    for (int k = 0; k < directions; ++k) move[k] = 1;
    SimplicialMesh<Dim> both = together<Dim>(large, small, move);
    const auto first = firstAtPlace<Dim>(both.points);
    for (auto& cell : both.cells)
        for (int& v : cell) v = first[v];
    return both;
}

}  // namespace

class TestJoinedParts : public QObject {
    Q_OBJECT

  private slots:
    void soupHangsTogether2D() { soupHangsTogether<2>(); }
    void soupHangsTogether3D() { soupHangsTogether<3>(); }
    void layersStayApart2D() { layersStayApart<2>(); }
    void layersStayApart3D() { layersStayApart<3>(); }

    /// The two sides of a cut belong to one part.
    void slitStaysOpen() {
        auto mesh = samples::grid<2>(4);  // 5 × 5 vertices; cut from (0.5, 0) up to below the middle
        const int low = 2, high = mesh.vertexCount();
        mesh.points.conservativeResize(Eigen::NoChange, high + 1);
        mesh.points.col(high) = mesh.points.col(low);
        for (auto& cell : mesh.cells) {
            const bool right = centreX(mesh, cell) > 0.5;
            for (int& v : cell)
                if (v == low && right) v = high;
        }
        QCOMPARE(joinedParts<2>(mesh).vertices, 0);
    }

    void partsThatOnlyHang() {
        auto found = hangingParts<2>(touching<2>(2));
        QCOMPARE(jointsOf(found), std::vector<int>{8});
        QCOMPARE(found[0].cells, 2);  // the smaller one
        QCOMPARE(found[0].firstCell, 8);
        QCOMPARE(jointsOf(hangingParts<3>(touching<3>(3))), std::vector<int>{26});
        QCOMPARE(hangingParts<3>(touching<3>(2)).size(), std::size_t(1));  // along an edge
        QVERIFY(hangingParts<2>(samples::grid<2>(3)).empty());
        QVERIFY(hangingParts<3>(samples::grid<3>(2)).empty());
        const auto apart = together<2>(samples::grid<2>(1), samples::grid<2>(1), Vec2(5, 5));
        QVERIFY(hangingParts<2>(apart).empty());
    }

    /// Two corners of a triangle are a hinge, all three hold.
    void threePointsHold() {
        SimplicialMesh<3> mesh;
        mesh.points.resize(3, 7);
        mesh.points.setRandom();
        mesh.cells = {{0, 1, 2, 3}, {4, 5, 6, 1}, {4, 5, 6, 2}};
        QCOMPARE(jointsOf(hangingParts<3>(mesh)), (std::vector<int>{1, 2}));
        mesh.cells.push_back({4, 5, 2, 3});
        QVERIFY(hangingParts<3>(mesh).empty());
    }

    void surfacesThatOnlyHang() {
        const Surface one = test::box({0, 0, 0}, {2, 2, 2}, 2);
        const Surface corner = test::joined(one, test::box({2, 2, 2}, {3, 3, 3}, 1));
        const auto found = hangingParts(corner.points, corner.triangles);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(corner.points.col(found[0].joint.at(0)) == Vec3(2, 2, 2));
        QCOMPARE(found[0].joint.size(), std::size_t(1));
        const Surface edge =
            test::joined(test::box({0, 0, 0}, {1, 1, 1}, 1), test::box({1, 1, 0}, {2, 2, 1}, 1));
        QCOMPARE(hangingParts(edge.points, edge.triangles).at(0).joint.size(), std::size_t(2));
        QVERIFY(hangingParts(one.points, one.triangles).empty());
    }

  private:
    static double centreX(const SimplicialMesh<2>& mesh, const Cell<2>& cell) {
        return (mesh.points(0, cell[0]) + mesh.points(0, cell[1]) + mesh.points(0, cell[2])) / 3;
    }
};

QTEST_APPLESS_MAIN(TestJoinedParts)
#include "test_joined_parts.moc"
