#include <QTest>

#include "app/views/volume/volume_view.h"
#include "bench/window_rows.h"

using namespace wend;

/// The rows of the window come from its own events and paintings.
class TestBenchWindow : public QObject {
    Q_OBJECT
  private slots:
    void everyRowWasSeen_data();
    void everyRowWasSeen();
    void partsWereSeen();
};

namespace {

template <int Dim>
std::vector<BenchRow> rowsOf(int vertices) {
    BenchOptions options;
    BenchTable table;
    BenchRecorder recorder(table, options);
    recorder.begin({"window", Dim, 0, 0, {}});
    addWindowRows<Dim>({{"small", vertices}}, recorder, 0.3);
    return table.cases[0].rows;
}

}  // namespace

void TestBenchWindow::everyRowWasSeen_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("rows");
    QTest::newRow("2D") << 2 << 10;
    QTest::newRow("3D") << 3 << 6;
}

void TestBenchWindow::everyRowWasSeen() {
    QFETCH(int, dimension);
    QFETCH(int, rows);
    if (dimension == 3 && !VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    const std::vector<BenchRow> found = dimension == 2 ? rowsOf<2>(400) : rowsOf<3>(300);
    QCOMPARE(static_cast<int>(found.size()), rows);
    for (const BenchRow& row : found) {
        QVERIFY2(row.time.repeats > 0 && row.time.minimum > 0, row.what.c_str());
        QVERIFY2(row.time.minimum <= row.time.median && row.time.median <= row.time.maximum,
                 row.what.c_str());
        for (const auto& [figure, value] : row.figures) {
            if (figure == "updates a second") continue;  // of a single one there is no rate
            QVERIFY2(value > 0, (row.what + ": " + figure).c_str());
        }
    }
}

void TestBenchWindow::partsWereSeen() {
    BenchOptions options;
    BenchTable table;
    BenchRecorder recorder(table, options);
    recorder.begin({"parts", 2, 0, 0, {}});
    addPartRows(600, recorder, 0.3);
    QCOMPARE(table.cases[0].rows.size(), std::size_t{2});
    for (const BenchRow& row : table.cases[0].rows) QVERIFY(row.time.repeats > 0 && row.time.minimum > 0);
}

QTEST_MAIN(TestBenchWindow)
#include "test_bench_window.moc"
