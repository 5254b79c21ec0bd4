// Wend's own factor and the tree that its threads share, compared with CHOLMOD.
#include <Eigen/Cholesky>
#include <QDir>
#include <QTest>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "core/assembly/cpu_back_end.h"
#include "core/base/memory.h"
#include "core/factor/cholesky.h"
#include "core/factor/dense_kernels.h"
#include "core/factor/supernodal_factor.h"
#include "core/solver/reduced_system.h"
#include "tests/core/test_energy_samples.h"
#include "tests/core/test_folder.h"
#include "tests/support/simd_targets.h"

using namespace wend;
using namespace wend::test;

class TestSupernodalFactor : public QObject {
    Q_OBJECT
  private slots:
    void targetsHaveKernelsOfTheirOwn();
    void denseKernels();
    void treeIsSplit();
    void factorsSolve();
    void factorThreads();
    void factorOutlivesTheChoiceOfTarget();
    void floatFactorRefuses();
    void progressIsReportedAndStopped();
    void stoppedCholmodIsLeftAlone();
    void memoryIsReported();
    void freeMemoryIsTheLeastLimit_data();
    void freeMemoryIsTheLeastLimit();
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

/// The solve is compared with one in double precision, for all shapes of supernodes that the orderings make.
template <int Dim>
void compareFactors(int n) {
    for (const auto ordering : {Ordering::MinimumDegree, Ordering::NestedDissection}) {
        Factored<Dim> scene(n, phi::kAkvf, ordering);
        WorkerPool workers(2);
        auto single = scene.template factor<float>();
        QVERIFY(single.factorize(scene.cholesky.values(), workers));
        QCOMPARE(scene.cholesky.factorize(), Cholesky::Status::Done);
        std::mt19937 random(3);
        const auto unknowns = scene.system.columnStart().size() - 1;
        std::vector<double> b(unknowns), x(unknowns), y(unknowns);
        // Tiny numbers: the residuals of late iterations.
        for (auto& value : b) value = 1e-60 * uniform(random, -1, 1);
        QVERIFY(single.solve(b, x, workers));
        QCOMPARE(scene.cholesky.solve(b, y), Cholesky::Status::Done);
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

/// The bits are the same for any number of threads, with shared fronts.
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

/// A front, and its factor by Eigen in double precision, against which the kernels are checked.
template <class Real>
class FrontCheck {
  public:
    FrontCheck(int columns, int rows, double tolerance)
        : m_columns(columns),
          m_below(rows - columns),
          m_leading(dense::padded<Real>(rows)),
          m_tolerance(tolerance),
          m_front(rows, columns),
          m_random(columns),
          m_panel(static_cast<std::size_t>(m_leading) * columns + dense::kPad<Real>),
          m_inverse(columns) {
        for (auto& value : m_front.reshaped()) value = static_cast<Real>(uniform(m_random, -1, 1));
        m_front.diagonal().array() += columns + 4;
        m_triangle = m_front.topRows(columns).selfadjointView<Eigen::Lower>().llt().matrixL();
        m_rows = m_triangle.triangularView<Eigen::Lower>()
                     .solve(m_front.bottomRows(m_below).transpose())
                     .transpose();
    }
    void run() {
        fill();
        QVERIFY(
            m_kernels.factorColumns(m_panel.data(), m_leading, 0, m_columns, m_leading, m_inverse.data()));
        checkPanel();
        fill();
        factorInPieces();
        checkPanel();
        if (m_below == 0) return;
        checkSquare();
        checkSolves();
    }

  private:
    using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

    Eigen::Map<Matrix> panel() { return {m_panel.data(), m_leading, m_columns}; }

    void fill() {
        for (int c = 0; c < m_columns; ++c)
            for (int r = c; r < m_front.rows(); ++r) panel()(r, c) = static_cast<Real>(m_front(r, c));
    }

    void factorInPieces() {
        const int half = m_columns / 2;
        for (const auto& [from, to] : {std::pair(0, half), std::pair(half, m_columns)}) {
            const int top = dense::padded<Real>(to);
            QVERIFY(m_kernels.factorColumns(m_panel.data(), m_leading, from, to, top, m_inverse.data()));
            m_kernels.continueColumns(m_panel.data(), m_leading, from, to, top, m_leading, m_inverse.data());
        }
    }

    void checkPanel() {
        const Eigen::MatrixXd L = panel().topRows(m_front.rows()).template cast<double>();
        const Eigen::MatrixXd top = L.topRows(m_columns).triangularView<Eigen::Lower>();
        checkZero(top - m_triangle);
        checkZero(L.bottomRows(m_below) - m_rows);
    }

    void checkSquare() {
        const int leading = dense::padded<Real>(m_below);
        LargeArray<Real> square(static_cast<std::size_t>(leading) * m_below + dense::kPad<Real>);
        for (int from = 0; from < m_below; from += dense::kPad<Real>)
            m_kernels.squareNegated(m_panel.data() + m_columns, m_leading, m_columns, square.data(), leading,
                                    from, std::min(m_below, from + dense::kPad<Real>));
        const Eigen::MatrixXd U =
            Eigen::Map<Matrix>(square.data(), leading, m_below).topRows(m_below).template cast<double>();
        const Eigen::MatrixXd difference = (U + m_rows * m_rows.transpose()).triangularView<Eigen::Lower>();
        checkZero(difference);
    }

    void checkSolves() {
        const int end = dense::padded<Real>(m_columns);
        Real* const p = m_panel.data();
        m_kernels.prepareSolves(p, m_leading, m_columns, end, m_leading, m_inverse.data());
        m_kernels.prepareSolves(p, m_leading, m_columns, 0, end, m_inverse.data());
        Vector w = Vector::Zero(m_leading), x = Vector::Zero(m_columns);
        for (int i = 0; i < m_columns; ++i) w[i] = static_cast<Real>(uniform(m_random, -1, 1));
        const Eigen::VectorXd y =
            m_triangle.triangularView<Eigen::Lower>().solve(w.head(m_columns).template cast<double>());
        m_kernels.forward(p, m_leading, m_columns, end, w.data(), x.data());
        m_kernels.continueForward(p, m_leading, m_columns, end, m_leading, w.data());
        checkZero(x.template cast<double>() - y);
        checkZero(w.segment(m_columns, m_below).template cast<double>() + m_rows * y);
        w.head(m_columns) = x;
        w.tail(m_leading - m_front.rows()).setZero();
        x.setZero();
        const Eigen::VectorXd right =
            w.head(m_columns).template cast<double>() -
            m_rows.transpose() * w.segment(m_columns, m_below).template cast<double>();
        m_kernels.prepareBackward(p, m_leading, 0, m_columns, end, w.data(), x.data());
        m_kernels.backward(p, m_leading, m_columns, end, w.data(), x.data());
        checkZero(x.template cast<double>() -
                  m_triangle.transpose().triangularView<Eigen::Upper>().solve(right));
    }

    /// Checks that the difference is within the tolerance, relative to the largest number of the front.
    void checkZero(const Eigen::MatrixXd& difference) const {
        if (difference.size() == 0) return;
        const double error = difference.cwiseAbs().maxCoeff() / m_front.cwiseAbs().maxCoeff();
        QVERIFY2(
            error <= m_tolerance,
            qPrintable(QString("%1 columns, %2 rows: %3").arg(m_columns).arg(m_front.rows()).arg(error)));
    }

    const dense::Kernels<Real>& m_kernels = dense::kernels<Real>();
    int m_columns, m_below, m_leading;
    double m_tolerance;
    Eigen::MatrixXd m_front, m_triangle, m_rows;
    std::mt19937 m_random;
    LargeArray<Real> m_panel;
    std::vector<Real> m_inverse;
};

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

// A dispatch that always used the same variant would pass every other test.
void TestSupernodalFactor::targetsHaveKernelsOfTheirOwn() {
    std::set<const void*> seen;
    onEveryTarget([&](SimdTarget) {
        QVERIFY(seen.insert(&dense::kernels<float>()).second);
        QVERIFY(seen.insert(&dense::kernels<double>()).second);
    });
    QCOMPARE(seen.size(), 2 * supportedSimdTargets().size());
}

void TestSupernodalFactor::denseKernels() {
    onEveryTarget([](SimdTarget) {
        for (int columns = 1; columns <= 20; ++columns) {
            FrontCheck<float>(columns, columns + columns % 3 * 19, 1e-5).run();
            FrontCheck<double>(columns, columns + columns % 3 * 19, 2e-14).run();
        }
        // Several panels, blocks of the depth, packed rows.
        FrontCheck<float>(301, 520, 1e-5).run();
        FrontCheck<double>(301, 520, 2e-14).run();
    });
}

void TestSupernodalFactor::factorThreads() {
    onEveryTarget([](SimdTarget) {
        compareThreads<2, float>(70);
        compareThreads<2, double>(70);
        compareThreads<3, float>(11);
        compareThreads<3, double>(11);
    });
}

void TestSupernodalFactor::factorsSolve() {
    onEveryTarget([](SimdTarget) {
        for (int n : {2, 3, 5, 24}) compareFactors<2>(n);
        for (int n : {2, 3, 6, 11})
            compareFactors<3>(n);  // the last with fronts that threads share in a solve
    });
}

// Blocks have other widths on other targets: the solves go on with the kernels of the factorization.
void TestSupernodalFactor::factorOutlivesTheChoiceOfTarget() {
    Factored<3> scene(6, phi::kAkvf, Ordering::NestedDissection);
    WorkerPool workers(1);
    std::vector<double> b(scene.system.columnStart().size() - 1, 1.0), x(b.size()), y(b.size());
    onEveryTarget([&](SimdTarget) {
        auto factor = scene.factor<double>();
        QVERIFY(factor.factorize(scene.cholesky.values(), workers));
        QVERIFY(factor.solve(b, x, workers));
        for (const SimdTarget other : supportedSimdTargets()) {
            setSimdTarget(other);
            QVERIFY(factor.solve(b, y, workers));
            QVERIFY(x == y);
        }
    });
}

void TestSupernodalFactor::floatFactorRefuses() {
    onEveryTarget([](SimdTarget) {
        Factored<2> scene(6, phi::kMetr, Ordering::MinimumDegree);
        WorkerPool workers(2);
        auto single = scene.factor<float>();
        for (auto& value : scene.cholesky.values()) value = -value;
        QVERIFY(!single.factorize(scene.cholesky.values(), workers));
        for (auto& value : scene.cholesky.values()) value = std::nan("");
        QVERIFY(!single.factorize(scene.cholesky.values(), workers));
    });
}

/// Progress rises to the whole; a request to stop meanwhile is heard before the end. The next factorization
/// is unaffected.
void TestSupernodalFactor::progressIsReportedAndStopped() {
    Factored<3> scene(11, phi::kAkvf, Ordering::NestedDissection);
    std::vector<double> b(scene.system.columnStart().size() - 1, 1.0), x(b.size()), y(b.size());
    for (const int threads : {1, 2}) {
        WorkerPool workers(threads);
        auto factor = scene.factor<double>();
        std::mutex mutex;
        std::vector<double> parts;
        const auto tell = [&](double part) {
            const std::lock_guard lock(mutex);
            parts.push_back(part);
        };
        QVERIFY(factor.factorize(scene.cholesky.values(), workers, {}, tell));
        QVERIFY(factor.solve(b, x, workers));
        QVERIFY2(parts.size() > 10 && parts.size() <= 100, qPrintable(QString::number(parts.size())));
        QVERIFY(std::ranges::max(parts) > 0.99 && std::ranges::max(parts) <= 1);
        QVERIFY(std::ranges::min(parts) < 0.2);
        for (const double limit : {0.1, 0.6, 0.9}) {
            std::stop_source stop;
            std::atomic<double> last = 0;
            const auto ask = [&](double part) {
                last = std::max<double>(last, part);
                if (part > limit) stop.request_stop();
            };
            QVERIFY(!factor.factorize(scene.cholesky.values(), workers, stop.get_token(), ask));
            QVERIFY2(last < 1, qPrintable(QString::number(last)));
        }
        QVERIFY(factor.factorize(scene.cholesky.values(), workers));
        QVERIFY(factor.solve(b, y, workers));
        QVERIFY(x == y);
    }
}

/// Whenever CHOLMOD is asked to stop, it either completes, or is analyzed again, with the same order.
void TestSupernodalFactor::stoppedCholmodIsLeftAlone() {
    Factored<2> scene(100, phi::kAkvf, Ordering::NestedDissection);
    const auto order = scene.cholesky.supernodes().order;
    const auto analyze = [&](Cholesky& cholesky, const std::stop_token& stop) {
        return cholesky.analyze(scene.system.columnStart(), scene.system.row(), 2, Ordering::NestedDissection,
                                stop);
    };
    Cholesky cholesky;
    std::stop_source never;
    for (const bool early : {true, false}) {
        std::stop_source stop;
        if (early) stop.request_stop();
        std::jthread asking([&] { stop.request_stop(); });
        const bool done = analyze(cholesky, stop.get_token());
        QVERIFY(!(early && done));
        QCOMPARE(cholesky.isAnalyzed(), done);
        QVERIFY(analyze(cholesky, never.get_token()));
        QVERIFY(cholesky.supernodes().order == order);
    }
    std::ranges::copy(scene.cholesky.values(), cholesky.values().begin());
    QCOMPARE(cholesky.factorize(never.get_token()), Cholesky::Status::Done);
    std::stop_source stop;
    stop.request_stop();
    QCOMPARE(cholesky.factorize(stop.get_token()), Cholesky::Status::Stopped);
    QVERIFY(!cholesky.isAnalyzed());
}

/// The memory is known before any is allocated: all panels, with the factor's numbers and their padding, and
/// update matrices, of which more threads need more.
void TestSupernodalFactor::memoryIsReported() {
    Factored<3> scene(9, phi::kMetr, Ordering::NestedDissection);
    auto single = scene.factor<float>();
    auto twice = scene.factor<double>();
    QCOMPARE(single.bytesToTake(1), single.bytes(1));
    QVERIFY(single.bytes(1) > sizeof(float) * scene.cholesky.factorEntries());
    QVERIFY(single.bytes(1) < 6 * sizeof(float) * scene.cholesky.factorEntries());
    QVERIFY(twice.bytes(1) > 1.8 * single.bytes(1));
    QVERIFY(single.bytes(2) > single.bytes(1));
    WorkerPool workers(1);
    QVERIFY(single.factorize(scene.cholesky.values(), workers));
    QCOMPARE(single.bytesToTake(1), 0.0);
    QVERIFY(single.bytesToTake(2) > 0);
    QVERIFY(!scene.cholesky.hasNumbers());
    QVERIFY(scene.cholesky.bytes() >= sizeof(double) * scene.cholesky.factorEntries());
    QCOMPARE(scene.cholesky.factorize(), Cholesky::Status::Done);
    QVERIFY(scene.cholesky.hasNumbers());
    QVERIFY_THROWS_EXCEPTION(NotEnoughMemory, requireMemory(1e18));
    requireMemory(1);
}

void TestSupernodalFactor::freeMemoryIsTheLeastLimit_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("free");
    const auto row = [](const char* name, const char* file, const char* text, double free) {
        QTest::newRow(name) << file << QByteArray(text) << free;
    };
    // The rows build on each other, each with the files of those before it.
    row("nothing known", "empty", "", std::numeric_limits<double>::infinity());
    row("system", "proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable:    5000000 kB\n", 5.12e9);
    row("no limit of the group", "proc/self/cgroup", "0::/user/work\n", 5.12e9);
    row("around the group", "sys/fs/cgroup/user/memory.max", "4000000000\n", 5.12e9);
    row("and what it holds", "sys/fs/cgroup/user/memory.current", "1500000000\n", 2.5e9);
    row("less its files", "sys/fs/cgroup/user/memory.stat", "anon 7\ninactive_file 500000000\n", 3e9);
    row("the group itself", "sys/fs/cgroup/user/work/memory.max", "max\n", 3e9);
    row("seen from a container", "sys/fs/cgroup/memory.max", "2000000000\n", 3e9);
    row("which holds more than it may", "sys/fs/cgroup/memory.current", "2000000001\n", 0);
    row("not this one", "proc/self/cgroup", "0::/\n", 0);
    row("first version", "proc/self/cgroup", "5:cpu,cpuacct:/a\n4:memory:/a\n", 5.12e9);
    row("its limit", "sys/fs/cgroup/memory/a/memory.limit_in_bytes", "1000000000\n", 5.12e9);
    row("its use", "sys/fs/cgroup/memory/a/memory.usage_in_bytes", "400000000\n", 6e8);
}

void TestSupernodalFactor::freeMemoryIsTheLeastLimit() {
    static const samples::Folder folder;
    QFETCH(QString, file);
    QFETCH(QByteArray, text);
    QFETCH(double, free);
    QVERIFY(QDir().mkpath(QFileInfo(folder.path(file.toStdString()).c_str()).path()));
    folder.put(file.toStdString(), text.toStdString());
    QCOMPARE(freeMemory(folder.path("")), free);
    QCOMPARE(byteText(7.94e9), std::string("7.9 GB"));
    QCOMPARE(byteText(5.4e7), std::string("54 MB"));
}

QTEST_APPLESS_MAIN(TestSupernodalFactor)
#include "test_supernodal_factor.moc"
