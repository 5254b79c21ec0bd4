#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <cmath>

#include "app/cli/arguments.h"
#include "app/cli/command_table.h"
#include "bench/body.h"
#include "bench/flow_rows.h"
#include "bench/paper.h"
#include "bench/solver_rows.h"
#include "core/base/error.h"

using namespace wend;

/// The arithmetic of the benchmark, and a small case that measures every column of the table.
class TestBench : public QObject {
    Q_OBJECT
  private slots:
    void mediansLeaveOutTheWarmUp();
    void exponentOfAPowerLaw();
    void growthIsPerDimensionAndThreads();
    void jsonHasEveryRow();
    void unknownCasesAreRefused();
    void helpNamesTheCases();
    void bodiesMeetTheAim_data();
    void bodiesMeetTheAim();
    void startVelocitiesAreTheHandles_data();
    void startVelocitiesAreTheHandles();
    void aSmallCaseHasAllRows();
    void theTableOfThePaper();
    void whatThePaperFindsHolds();
    void stops();
};

namespace {

BenchCase caseOf(int dimension, int vertices, double seconds) {
    BenchRow row;
    row.what = "work";
    row.time.median = seconds;
    row.figures = {{"iterations", 3}};
    return {"case", dimension, vertices, 2 * vertices, {row}};
}

template <int Dim>
void checkBody(int aim) {
    const Body<Dim> body = makeBody<Dim>(aim);
    QVERIFY(std::abs(body.rest->vertexCount() - aim) <= 0.15 * aim);  // the meshers' promise
    QVERIFY(std::abs(boundingBoxDiagonal<Dim>(body.rest->points) - 1) < 1e-14);
}

/// v = ω × (x − c) with |ω| = π has the magnitude π times the distance from the axis and is perpendicular to
/// that.
template <int Dim>
void checkVelocities() {
    const Body<Dim> body = makeBody<Dim>(300);
    const BodyRows<Dim> start = startRows(body);
    int moving = 0;
    for (Eigen::Index i = 0; i < start.velocities.cols(); ++i) {
        const Vec<Dim> p = body.rest->points.col(start.rows[static_cast<std::size_t>(i)].terms[0].first);
        const Vec<Dim> v = start.velocities.col(i);
        if (p.x() < 1e-6) {
            QCOMPARE(v, Vec<Dim>(Vec<Dim>::Zero()));
            continue;
        }
        ++moving;
        Vec<Dim> arm = p - body.centre;
        if (Dim == 3) arm.x() = 0;
        QVERIFY(std::abs(v.norm() - M_PI * arm.norm()) < 1e-13);
        QVERIFY(std::abs(v.dot(arm)) < 1e-13);
    }
    QVERIFY(moving > 2);
}

}  // namespace

void TestBench::mediansLeaveOutTheWarmUp() {
    int runs = 0, preparations = 0;
    const Timing timing = measure(
        3, [&] { ++runs; }, [&] { ++preparations; });
    QCOMPARE(runs, 4);
    QCOMPARE(preparations, 4);
    QCOMPARE(timing.repeats, 3);
    QVERIFY(timing.minimum <= timing.median && timing.median <= timing.maximum);
}

void TestBench::exponentOfAPowerLaw() {
    QVERIFY(std::abs(growthExponent({10, 100, 1000}, {3e-3, 3e-3 * std::pow(10, 1.5), 3}) - 1.5) < 1e-12);
    QCOMPARE(growthExponent({10}, {1}), 0.0);
}

void TestBench::growthIsPerDimensionAndThreads() {
    BenchTable table;
    table.cases = {caseOf(2, 100, 1), caseOf(2, 400, 4), caseOf(3, 100, 1), caseOf(3, 200, 4)};
    const std::vector<Growth> growth = growthOf(table);
    QCOMPARE(growth.size(), std::size_t(2));
    QVERIFY(std::abs(growth[0].exponent - 1) < 1e-12);
    QVERIFY(std::abs(growth[1].exponent - 2) < 1e-12);
}

void TestBench::jsonHasEveryRow() {
    BenchTable table;
    table.cores = 2;
    table.simd = "avx2";
    table.cases = {caseOf(2, 100, 0.5), caseOf(2, 200, 1.5)};
    table.cases[0].rows[0].threads = 0;
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(jsonOf(table))).object();
    QCOMPARE(json["cases"].toArray().size(), 2);
    QCOMPARE(json["simd"].toString(), "avx2");
    const QJsonObject row = json["cases"].toArray()[0].toObject()["rows"].toArray()[0].toObject();
    QCOMPARE(row["seconds"].toDouble(), 0.5);
    QCOMPARE(row["threads"].toInt(), 2);  // all of them
    QCOMPARE(row["figures"].toObject()["iterations"].toDouble(), 3.0);
}

void TestBench::unknownCasesAreRefused() {
    BenchOptions options;
    options.cases = {"4d"};
    try {
        runBenchmarks(options);
        QFAIL("a fourth dimension");
    } catch (const UsageError& error) {
        QVERIFY(std::string(error.what()).find("2d-5.6k") != std::string::npos);
    }
}

void TestBench::helpNamesTheCases() {
    const std::string help = remarksOn(*findCommand("bench"));
    for (const std::string& name : benchCases())
        QVERIFY2(help.find(" " + name) != std::string::npos, name.c_str());
}

void TestBench::bodiesMeetTheAim_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("2D") << 2;
    QTest::newRow("3D") << 3;
}

void TestBench::bodiesMeetTheAim() {
    QFETCH(int, dimension);
    dimension == 2 ? checkBody<2>(1000) : checkBody<3>(1000);
}

void TestBench::startVelocitiesAreTheHandles_data() {
    bodiesMeetTheAim_data();
}

void TestBench::startVelocitiesAreTheHandles() {
    QFETCH(int, dimension);
    dimension == 2 ? checkVelocities<2>() : checkVelocities<3>();
}

void TestBench::aSmallCaseHasAllRows() {
    BenchOptions options;
    options.repeats = 1;
    BenchTable table;
    BenchRecorder recorder(table, options);
    const Body<2> body = makeBody<2>(300);
    recorder.begin({"small", 2, body.rest->vertexCount(), body.rest->cellCount(), {}});
    addSolverRows(body, recorder);
    for (const BenchRow& row : table.cases[0].rows) QVERIFY2(row.time.median > 0, row.what.c_str());
    for (const char* what :
         {"assembly, cpu", "symbolic analysis", "factor, CHOLMOD, double", "solve, CHOLMOD, double",
          "evaluation, paper's scheme", "evaluation, stale factor"}) {
        const auto named = [&](const BenchRow& row) { return row.what == what; };
        QVERIFY2(std::ranges::any_of(table.cases[0].rows, named), what);
    }
}

void TestBench::theTableOfThePaper() {
    BenchOptions options;
    BenchTable table;
    BenchRecorder recorder(table, options);
    recorder.begin({"times", 3, 1, 1, {}});
    addPaperFlow(makeBody<3>(200), recorder);
    const auto& [paper, ours] = std::tie(table.cases[0].rows[0], table.cases[0].rows[1]);
    const auto figure = [](const BenchRow& row, const std::string& name) {
        return std::ranges::find(row.figures, name, &std::pair<std::string, double>::first)->second;
    };
    QCOMPARE(figure(paper, "fields"), 40.0);          // four in each of ten steps,
    QCOMPARE(figure(paper, "factorizations"), 40.0);  // each with a factor of its own
    QVERIFY(figure(ours, "factorizations") < 40);
    for (const char* part : {"analysis (ms)", "assembly of a field (ms)", "factor + solve of a field (ms)"})
        QVERIFY2(figure(paper, part) > 0, part);
}

/// The paper's findings hold on small shapes; `wend bench paper` shows them at the paper's size.
void TestBench::whatThePaperFindsHolds() {
    BenchOptions options;
    BenchTable table;
    BenchRecorder recorder(table, options);
    PaperOptions paper;
    paper.flatVertices = 700;
    paper.solidVertices = 300;
    paper.timings = false;
    const std::vector<BenchClaim> claims = addPaperCases(paper, recorder);
    QVERIFY(claims.size() > 30);
    for (const BenchClaim& claim : claims) QVERIFY2(claim.holds, textOf(claim).c_str());
    QCOMPARE(table.cases.size(), std::size_t(10));
}

void TestBench::stops() {
    std::stop_source source;
    source.request_stop();
    BenchOptions options;
    options.repeats = 1;
    options.stop = source.get_token();
    BenchTable table;
    BenchRecorder recorder(table, options);
    recorder.begin({"small", 2, 1, 1, {}});
    QVERIFY_THROWS_EXCEPTION(Cancelled, recorder.add({}));
}

QTEST_GUILESS_MAIN(TestBench)
#include "test_bench.moc"
