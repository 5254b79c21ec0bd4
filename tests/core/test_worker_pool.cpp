// Loops that threads share: their progress, and a request to stop them.
#include <QTest>
#include <mutex>

#include "core/factor/worker_pool.h"

using namespace wend;

namespace {

constexpr int kItems = 1000, kGrain = 10;

/// Counts every item once.
struct Counted {
    std::vector<std::atomic<int>> counts = std::vector<std::atomic<int>>(kItems);
    std::atomic<int> pieces = 0;

    void operator()(int begin, int end) {
        ++pieces;
        for (int i = begin; i < end; ++i) ++counts[i];
    }
    bool isWhole() const {
        return std::all_of(counts.begin(), counts.end(), [](const auto& count) { return count == 1; });
    }
};

}  // namespace

class TestWorkerPool : public QObject {
    Q_OBJECT
  private slots:
    void everyItemOnce();
    void stoppedLoopsEnd();
    void measuredLoopsTell();
};

void TestWorkerPool::everyItemOnce() {
    for (const int threads : {1, 2, 5}) {
        WorkerPool pool(threads);
        Counted counted;
        pool.forPieces(kItems, kGrain, counted);
        QVERIFY(counted.isWhole());
        QCOMPARE(counted.pieces.load(), kItems / kGrain);
    }
}

/// No thread begins a piece after the request, and the next loop is complete.
void TestWorkerPool::stoppedLoopsEnd() {
    constexpr int kUntil = 3;
    for (const int threads : {1, 2, 5}) {
        WorkerPool pool(threads);
        std::stop_source source;
        Counted counted, next, after;
        {
            const WorkerPool::Watched watched(pool, source.get_token());
            QVERIFY(!pool.isStopped());
            pool.forPieces(kItems, kGrain, [&](int begin, int end) {
                counted(begin, end);
                if (counted.pieces >= kUntil) source.request_stop();
            });
            QVERIFY(pool.isStopped());
            QVERIFY(counted.pieces >= kUntil && counted.pieces < kUntil + threads);
            pool.forPieces(kItems, kGrain, next);
            QCOMPARE(next.pieces.load(), 0);
        }
        QVERIFY(!pool.isStopped());
        pool.forPieces(kItems, kGrain, after);
        QVERIFY(after.isWhole());
    }
}

/// Each measured loop covers its share of the remaining progress and reports it in hundredths.
void TestWorkerPool::measuredLoopsTell() {
    for (const int threads : {1, 2}) {
        WorkerPool pool(threads);
        std::mutex mutex;
        std::vector<double> told;
        const auto tell = [&](double part) {
            const std::scoped_lock lock(mutex);
            told.push_back(part);
        };
        const auto loop = [&] { pool.forPieces(kItems, kGrain, [](int, int) {}); };
        {
            const WorkerPool::Watched watched(pool, {}, tell);
            loop();
            QVERIFY(told.empty());
            pool.measureNext(0.5);
            loop();
            QVERIFY(told.size() >= 49 && told.size() <= 51);
            QCOMPARE(std::ranges::max(told), 0.5);
            QVERIFY(std::ranges::min(told) < 0.05);
            told.clear();
            loop();
            QVERIFY(told.empty());
            pool.measureNext(0.5);
            loop();
            QCOMPARE(std::ranges::max(told), 0.75);
            QVERIFY(std::ranges::min(told) > 0.5);
            told.clear();
        }
        pool.measureNext(1);
        loop();
        QVERIFY(told.empty());
    }
}

QTEST_APPLESS_MAIN(TestWorkerPool)
#include "test_worker_pool.moc"
