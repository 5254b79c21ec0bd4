// Constraint rows: dependence, vertices without cells, parts with and without constraints, repeated use,
// threads.
#include <QTest>
#include <cstring>

#include "core/base/error.h"
#include "core/solver/components.h"
#include "core/solver/velocity_solver.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

namespace {

ConstraintRow fixed(int vertex) {
    return {{{vertex, 1.0}}};
}

template <int Dim>
VelocitySolver<Dim> solverOf(const SimplicialMesh<Dim>& mesh, double phi = phi::kMetr, int threads = 1) {
    return VelocitySolver<Dim>(
        std::make_shared<const SimplicialMesh<Dim>>(mesh),
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(mesh.cellCount(), phi)),
        BackEndKind::Cpu, threads);
}

/// Two copies of a mesh side by side, and one vertex without a cell at the end.
template <int Dim>
SimplicialMesh<Dim> twoParts(std::mt19937& random) {
    const auto one = unitGrid<Dim>(3, 0.1, random);
    SimplicialMesh<Dim> mesh;
    const int n = one.vertexCount();
    mesh.points.resize(Dim, 2 * n + 1);
    mesh.points.leftCols(n) = one.points;
    mesh.points.middleCols(n, n) = one.points.colwise() + Vec<Dim>(1.5 * Vec<Dim>::Unit(0));
    mesh.points.col(2 * n).setConstant(0.5);
    mesh.cells = one.cells;
    for (auto cell : one.cells) {
        for (int& vertex : cell) vertex += n;
        mesh.cells.push_back(cell);
    }
    mesh.points /= boundingBoxDiagonal<Dim>(mesh.points);
    return mesh;
}

/// Three rows on one edge's two vertices: each is a combination of the other two.
void findsCombination() {
    const std::vector<ConstraintRow> rows{{{{3, 0.25}, {4, 0.75}}},
                                          {{{4, 0.5}, {3, 0.5}}},
                                          {{{3, 0.4}, {4, 0.6}}},
                                          fixed(9),
                                          {{{9, 0.5}, {9, 0.5}, {2, 0.0}}}};
    const auto dependent = dependentRows(rows);
    QCOMPARE(dependent.size(), std::size_t{2});
    for (const auto& d : dependent) {
        std::map<int, double> sum;
        for (const auto& [row, factor] : d.combination) {
            QVERIFY(row != d.row);
            for (const auto& [vertex, weight] : rows[row].terms) sum[vertex] += factor * weight;
        }
        for (const auto& [vertex, weight] : rows[d.row].terms) sum[vertex] -= weight;
        for (const auto& [vertex, rest] : sum) QVERIFY(std::abs(rest) < 1e-14);
    }
}

/// Random barycentric rows, some on all corners of a cell together (then all are determined), some too many.
template <int Dim>
void countsDependentRows() {
    std::mt19937 random(1);
    const auto mesh = unitGrid<Dim>(2, 0.1, random);
    std::vector<ConstraintRow> rows;
    for (int i = 0; i < Dim + 3; ++i) {  // Dim + 1 of them fix the cell, two are too many
        ConstraintRow row;
        for (int k = 0; k <= Dim; ++k) row.terms.emplace_back(mesh.cells[0][k], uniform(random, 0.1, 1));
        rows.push_back(row);
    }
    QCOMPARE(dependentRows(rows).size(), std::size_t{2});
    rows.push_back(fixed(mesh.cells[0][1]));
    QCOMPARE(dependentRows(rows).size(), std::size_t{3});
    for (const auto& d : dependentRows(rows)) QVERIFY(d.row != Dim + 3);  // single vertices come first
}

/// Points a millionth of an edge apart are two; those that differ by rounding alone are one.
void nearRowsAreReported() {
    const auto pointNear = [](double weight) {
        return ConstraintRow{{{0, 1 - 2 * weight}, {1, weight}, {2, weight}}};
    };
    QCOMPARE(dependentRows({pointNear(0.3), pointNear(0.3 + 1e-6)}).size(), std::size_t{0});
    QCOMPARE(dependentRows({fixed(0), pointNear(1e-6)}).size(), std::size_t{0});
    QCOMPARE(dependentRows({pointNear(0.3), pointNear(0.3 + 1e-14)}).size(), std::size_t{1});
    QCOMPARE(dependentRows({fixed(0), pointNear(1e-14)}).size(), std::size_t{1});
}

/// The row is solved for the corner with the largest weight: nothing is divided by a small weight.
void pivotIsTheLargest() {
    std::array<double, 4> weights = {1e-9, 0.1, 0.2, 0.7 - 1e-9};
    std::sort(weights.begin(), weights.end());
    do {
        ConstraintRow row;
        for (int k = 0; k < 4; ++k) row.terms.emplace_back(k, weights[static_cast<std::size_t>(k)]);
        const auto pivots = eliminate({row}).pivots;
        QCOMPARE(pivots.size(), std::size_t{1});
        const auto largest = std::max_element(weights.begin(), weights.end());
        QCOMPARE(pivots[0].vertex, int(largest - weights.begin()));
        for (const auto& [vertex, weight] : pivots[0].free)
            QCOMPARE(weight, weights[static_cast<std::size_t>(vertex)] / *largest);
    } while (std::next_permutation(weights.begin(), weights.end()));
}

template <int Dim>
void dependentRowsDoNoHarm() {
    std::mt19937 random(2);
    const auto mesh = unitGrid<Dim>(3, 0.1, random);
    std::vector<ConstraintRow> rows;
    for (int v : {0, 5, 9, mesh.vertexCount() - 1}) rows.push_back(fixed(v));
    auto solver = solverOf<Dim>(mesh);
    const Points<Dim> prescribed = randomField<Dim>(random, 4);
    Points<Dim> v, twice(Dim, 6), w;
    solver.setConstraints(rows);
    QVERIFY(solver.solve(mesh.points, prescribed, v).done());
    rows.push_back(rows[1]);
    rows.push_back({{{0, 0.5}, {5, 0.5}}});
    twice << prescribed, prescribed.col(1), 0.5 * (prescribed.col(0) + prescribed.col(1));
    solver.setConstraints(rows);
    QVERIFY(solver.solve(mesh.points, twice, w).done());
    QVERIFY(v == w);
}

template <int Dim>
void partsAreIndependent() {
    std::mt19937 random(3);
    const auto mesh = twoParts<Dim>(random);
    const int n = mesh.vertexCount() / 2;
    QVERIFY(cellComponents(mesh).front() == 0 && cellComponents(mesh).back() == 1);
    auto solver = solverOf<Dim>(mesh);
    std::vector<ConstraintRow> rows;
    for (int i = 0; i < 4; ++i) rows.push_back(fixed(i * (n - 1) / 3 - (i == 1 ? 1 : 0)));
    const Points<Dim> prescribed = randomField<Dim>(random, 4);
    solver.setConstraints(rows);
    Points<Dim> v;
    QVERIFY(solver.solve(mesh.points, prescribed, v).done());
    QVERIFY(v.leftCols(n).norm() > 0.1);
    QVERIFY(v.middleCols(n, n).isZero(0));  // nothing pulls the other part
    QVERIFY(v.col(2 * n).isZero(0));        // nor the vertex without cells

    // The mass regularization of the free part does not affect the other, which moves as it would alone.
    SimplicialMesh<Dim> alone{mesh.points.leftCols(n),
                              {mesh.cells.begin(), mesh.cells.begin() + mesh.cellCount() / 2}};
    auto single = solverOf<Dim>(alone);
    single.setConstraints(rows);
    Points<Dim> w;
    QVERIFY(single.solve(alone.points, prescribed, w).done());
    QVERIFY((w - v.leftCols(n)).cwiseAbs().maxCoeff() < 1e-10);

    // A vertex without cells can be prescribed.
    rows.push_back(fixed(2 * n));
    Points<Dim> more(Dim, 5);
    more << prescribed, Vec<Dim>::Constant(7);
    solver.setConstraints(rows);
    QVERIFY(solver.solve(mesh.points, more, v).done());
    QVERIFY((v.leftCols(n) - w).cwiseAbs().maxCoeff() < 1e-10);
    QVERIFY(v.col(2 * n) == Vec<Dim>(Vec<Dim>::Constant(7)));
}

/// The sets determine the motion by points of the first part.
template <int Dim>
void countsPoints() {
    const auto mesh = samples::grid<Dim>(2);
    const auto components = cellComponents(mesh);
    const auto enough = [&](const std::vector<ConstraintRow>& rows) -> bool {
        return wellConstrained(mesh, components, rows).front();
    };
    QVERIFY(!enough({}));
    QVERIFY(!enough({fixed(0)}));
    QVERIFY(!enough({fixed(0), fixed(0), fixed(0)}));
    QCOMPARE(enough({fixed(0), fixed(1)}), Dim == 2);
    QCOMPARE(enough({fixed(0), fixed(1), fixed(2)}), Dim == 2);  // on one line
    QCOMPARE(enough({fixed(0), fixed(1), fixed(3)}), true);
    // Two points in cells at one place.
    const ConstraintRow a{{{0, 0.5}, {2, 0.5}}};
    QVERIFY(!enough({a, fixed(1), fixed(1)}));
}

template <int Dim>
void allFixed() {
    std::mt19937 random(4);
    const auto mesh = unitGrid<Dim>(2, 0.1, random);
    auto solver = solverOf<Dim>(mesh);
    std::vector<ConstraintRow> rows;
    for (int i = 0; i < mesh.vertexCount(); ++i) rows.push_back(fixed(i));
    const auto prescribed = randomField<Dim>(random, mesh.vertexCount());
    solver.setConstraints(rows);
    Points<Dim> v;
    QVERIFY(solver.solve(mesh.points, prescribed, v).done());
    QVERIFY(v == prescribed);
    QVERIFY(solver.energy() > 0);
}

template <int Dim>
void analysesOnce() {
    std::mt19937 random(5);
    const auto mesh = unitGrid<Dim>(3, 0.1, random);
    auto solver = solverOf<Dim>(mesh);
    const std::vector<ConstraintRow> rows{fixed(0), fixed(3), fixed(7), fixed(12)};
    const auto prescribed = randomField<Dim>(random, 4);
    Points<Dim> first, v;
    for (int i = 0; i < 3; ++i) {
        solver.setConstraints(rows);
        QVERIFY(solver.solve(mesh.points, prescribed, v).done());
        if (i == 0) first = v;
        QVERIFY(v == first);
    }
    QCOMPARE(solver.statistics().analyses, 1);
    QCOMPARE(solver.statistics().factorizations, 3);
    solver.setConstraints({fixed(0), fixed(3), fixed(7)});
    QCOMPARE(solver.statistics().analyses, 2);
}

/// Moving and scaling: the caller normalizes, so only a motion of the frame is left to test here.
template <int Dim>
void frameDoesNotMatter() {
    std::mt19937 random(6);
    const auto mesh = unitGrid<Dim>(3, 0.1, random);
    auto moved = mesh;
    moved.points.colwise() += Vec<Dim>::Constant(3);
    const std::vector<ConstraintRow> rows{fixed(0), fixed(3), fixed(7), fixed(12)};
    const auto prescribed = randomField<Dim>(random, 4);
    Points<Dim> v, w;
    auto a = solverOf<Dim>(mesh), b = solverOf<Dim>(moved);
    a.setConstraints(rows);
    b.setConstraints(rows);
    QVERIFY(a.solve(mesh.points, prescribed, v).done());
    QVERIFY(b.solve(moved.points, prescribed, w).done());
    QVERIFY((v - w).cwiseAbs().maxCoeff() < 1e-11);
}

template <int Dim>
void sameBitsForAnyThreads() {
    std::mt19937 random(7);
    const auto mesh = unitGrid<Dim>(Dim == 2 ? 75 : 15, 0.2, random);
    std::vector<ConstraintRow> rows;
    for (int i = 0; i < 6; ++i) rows.push_back(fixed(i * (mesh.vertexCount() - 1) / 5));
    rows.push_back({{{mesh.cells[99][0], 0.5}, {mesh.cells[99][1], 0.3}, {mesh.cells[99][2], 0.2}}});
    const auto prescribed = randomField<Dim>(random, 7);
    Points<Dim> first;
    for (int threads : {1, 2, 4}) {
        auto solver = solverOf<Dim>(mesh, phi::kMetr, threads);
        solver.setConstraints(rows);
        Points<Dim> v;
        QVERIFY(solver.solve(mesh.points, prescribed, v).done());
        if (threads == 1) first = v;
        QVERIFY(std::memcmp(first.data(), v.data(), 8 * v.size()) == 0);
    }
}

/// The stiffest material is the worst conditioned: refinement must make up for it.
template <int Dim>
void equia() {
    std::mt19937 random(8);
    const auto mesh = unitGrid<Dim>(Dim == 2 ? 30 : 6, 0.2, random);
    auto solver = solverOf<Dim>(mesh, phi::kEquia);
    std::vector<ConstraintRow> rows;
    for (int i = 0; i < 6; ++i) rows.push_back(fixed(i * (mesh.vertexCount() - 1) / 5));
    solver.setConstraints(rows);
    // A rigid motion of the handles is answered by that motion.
    const auto rigid = affineField<Dim>(mesh.points, randomSkew<Dim>(random), Vec<Dim>::Ones());
    Points<Dim> prescribed(Dim, 6), v;
    for (int i = 0; i < 6; ++i) prescribed.col(i) = rigid.col(rows[i].terms.front().first);
    QVERIFY(solver.solve(mesh.points, prescribed, v).done());
    QVERIFY((v - rigid).cwiseAbs().maxCoeff() < 1e-9);
}

template <int Dim>
void badRowsThrow() {
    const auto mesh = samples::grid<Dim>(2);
    auto solver = solverOf<Dim>(mesh);
    QVERIFY_THROWS_EXCEPTION(InputError, solver.setConstraints({fixed(-1)}));
    QVERIFY_THROWS_EXCEPTION(InputError, solver.setConstraints({fixed(mesh.vertexCount())}));
    QVERIFY_THROWS_EXCEPTION(InputError, solver.setConstraints({{{{0, std::nan("")}}}}));
    QVERIFY_THROWS_EXCEPTION(InputError, solver.setConstraints({{}}));
    QVERIFY_THROWS_EXCEPTION(InputError, solver.setConstraints({{{{0, 0.0}}}}));
}

}  // namespace

class TestSolverConstraints : public QObject {
    Q_OBJECT

  private slots:
    void combination() { findsCombination(); }
    void pivots() { pivotIsTheLargest(); }
    void dependence() {
        countsDependentRows<2>();
        countsDependentRows<3>();
        nearRowsAreReported();
        dependentRowsDoNoHarm<2>();
        dependentRowsDoNoHarm<3>();
    }
    void parts() {
        partsAreIndependent<2>();
        partsAreIndependent<3>();
    }
    void points() {
        countsPoints<2>();
        countsPoints<3>();
    }
    void everything() {
        allFixed<2>();
        allFixed<3>();
    }
    void analysis() {
        analysesOnce<2>();
        analysesOnce<3>();
    }
    void frame() {
        frameDoesNotMatter<2>();
        frameDoesNotMatter<3>();
    }
    void threads() {
        sameBitsForAnyThreads<2>();
        sameBitsForAnyThreads<3>();
    }
    void stiff() {
        equia<2>();
        equia<3>();
    }
    void badRows() {
        badRowsThrow<2>();
        badRowsThrow<3>();
    }
};

QTEST_APPLESS_MAIN(TestSolverConstraints)
#include "test_solver_constraints.moc"
