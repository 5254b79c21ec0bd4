// The factor of our own and the tree that its threads share, against CHOLMOD.
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/factor/cholesky.h"
#include "core/factor/supernodal_factor.h"
#include "core/solver/reduced_system.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestSupernodalFactor : public QObject {
    Q_OBJECT
  private slots:
    void treeIsSplit();
    void factorsSolve();
    void factorThreads();
    void floatFactorRefuses();
};

namespace {

/// The low and the high side of a grid, held.
template <int Dim>
std::vector<ConstraintRow> sides(const SimplicialMesh<Dim>& mesh) {
    std::vector<ConstraintRow> rows;
    const double high = mesh.points.row(0).maxCoeff();
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (mesh.points(0, v) < 0.02 * high || mesh.points(0, v) > 0.98 * high) rows.push_back({{{v, 1.0}}});
    return rows;
}

/// The scene's matrix in a Cholesky object, with its pattern.
template <int Dim>
struct Factored {
    ReducedSystem<Dim> system;
    Cholesky cholesky;

    Factored(int n, double phi, Ordering ordering) {
        std::mt19937 random(11);
        const auto mesh = unitGrid<Dim>(n, 0.1, random);
        const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(mesh, true));
        const auto backEnd =
            makeCpuBackEnd<Dim>(plan, mesh, Material<Dim>::uniform(mesh.cellCount(), phi), 1);
        system = ReducedSystem<Dim>(*plan, eliminate(sides(mesh)));
        cholesky.analyze(system.columnStart(), system.row(), Dim, ordering);
        backEnd->setShape(mesh.points);
        std::vector<double> blocks(static_cast<std::size_t>(plan->blockCount()) * Dim * Dim);
        backEnd->assemble(blocks);
        system.gather(blocks, cholesky.values());
    }
    template <class Real>
    SupernodalFactor<Real> factor() const {
        return {cholesky.supernodes(), system.columnStart(), system.row()};
    }
};

/// Against the solve in double, for all shapes of supernodes that the orderings make.
template <int Dim>
void compareFactors(int n) {
    for (const auto ordering : {Ordering::MinimumDegree, Ordering::NestedDissection}) {
        Factored<Dim> scene(n, phi::kAkvf, ordering);
        WorkerPool workers(2);
        auto single = scene.template factor<float>();
        QVERIFY(single.factorize(scene.cholesky.values(), workers));
        QVERIFY(scene.cholesky.factorize() == Cholesky::Status::Done);
        std::mt19937 random(3);
        const auto unknowns = scene.system.columnStart().size() - 1;
        std::vector<double> b(unknowns), x(unknowns), y(unknowns);
        // Tiny numbers: the residuals of late iterations.
        for (auto& value : b) value = 1e-60 * uniform(random, -1, 1);
        QVERIFY(single.solve(b, x, workers));
        QVERIFY(scene.cholesky.solve(b, y) == Cholesky::Status::Done);
        const Eigen::Map<Eigen::VectorXd> X(x.data(), static_cast<Eigen::Index>(unknowns)),
            Y(y.data(), X.size());
        // The condition of these small matrices is about 1e3 to 1e4, the precision 6e-8 and 1e-16.
        QVERIFY2((X - Y).norm() <= 2e-3 * Y.norm(), qPrintable(QString::number((X - Y).norm() / Y.norm())));
        auto twice = scene.template factor<double>();
        QVERIFY(twice.factorize(scene.cholesky.values(), workers));
        QVERIFY(twice.solve(b, x, workers));
        QVERIFY2((X - Y).norm() <= 1e-11 * Y.norm(), qPrintable(QString::number((X - Y).norm() / Y.norm())));
    }
}

/// The same bits for any number of threads, with fronts that are shared.
template <int Dim, class Real>
void compareThreads(int n) {
    Factored<Dim> scene(n, phi::kAkvf, Ordering::NestedDissection);
    std::mt19937 random(4);
    std::vector<double> b(scene.system.columnStart().size() - 1), first;
    for (auto& value : b) value = uniform(random, -1, 1);
    for (int threads : {1, 2, 3}) {
        WorkerPool workers(threads);
        auto factor = scene.template factor<Real>();
        std::vector<double> x(b.size());
        for (int repeat = 0; repeat < 3; ++repeat) {
            QVERIFY(factor.factorize(scene.cholesky.values(), workers));
            QVERIFY(factor.solve(b, x, workers));
            if (first.empty()) first = x;
            QVERIFY(x == first);
        }
    }
}

/// Every supernode is in the separator or in one subtree, a subtree holds all that is below its root and none
/// of it is the whole; the separator is closed upwards.
template <int Dim>
void checkTree(int n) {
    const Factored<Dim> scene(n, phi::kMetr, Ordering::NestedDissection);
    const auto symbolic = scene.cholesky.supernodes();
    const auto tree = makeEliminationTree(symbolic);
    std::vector<int> owner(symbolic.count(), -2), inSeparator(symbolic.count(), 0);
    for (int s : tree.separator) inSeparator[s] = 1;
    for (int i = 0; i < static_cast<int>(tree.subtrees.size()); ++i)
        for (int s = tree.subtrees[i].begin; s < tree.subtrees[i].end; ++s) {
            QCOMPARE(owner[s], -2);
            owner[s] = i;
        }
    QVERIFY(tree.subtrees.size() >= 4);
    QVERIFY(!tree.separator.empty());
    for (int s = 0; s < symbolic.count(); ++s) {
        const int parent = tree.parent[s];
        QVERIFY(inSeparator[s] == (owner[s] == -2));
        QVERIFY(parent == -1 || parent > s);
        if (inSeparator[s])
            QVERIFY(parent == -1 || inSeparator[parent]);
        else if (s != tree.subtrees[owner[s]].root())
            QCOMPARE(owner[parent], owner[s]);
        else
            QVERIFY(parent == -1 || inSeparator[parent]);
    }
}

}  // namespace

void TestSupernodalFactor::treeIsSplit() {
    checkTree<2>(40);
    checkTree<3>(9);
}

void TestSupernodalFactor::factorThreads() {
    compareThreads<2, float>(70);
    compareThreads<2, double>(70);
    compareThreads<3, float>(11);
    compareThreads<3, double>(11);
}

void TestSupernodalFactor::factorsSolve() {
    for (int n : {2, 3, 5, 24}) compareFactors<2>(n);
    for (int n : {2, 3, 6, 11}) compareFactors<3>(n);  // the last with fronts that threads share in a solve
}

void TestSupernodalFactor::floatFactorRefuses() {
    Factored<2> scene(6, phi::kMetr, Ordering::MinimumDegree);
    WorkerPool workers(2);
    auto single = scene.factor<float>();
    for (auto& value : scene.cholesky.values()) value = -value;
    QVERIFY(!single.factorize(scene.cholesky.values(), workers));
    for (auto& value : scene.cholesky.values()) value = std::nan("");
    QVERIFY(!single.factorize(scene.cholesky.values(), workers));
}

QTEST_APPLESS_MAIN(TestSupernodalFactor)
#include "test_supernodal_factor.moc"
