#include <QSemaphore>
#include <QTest>
#include <QThreadPool>
#include <atomic>
#include <memory>

#include "app/base/latest.h"

using namespace wend;

/// Only the newest request is answered.
class TestLatest : public QObject {
    Q_OBJECT
  private slots:
    void newestIsAnswered();
    void olderWorkIsStopped();
    void droppedIsNotAnswered();
    void nothingIsAnsweredAfterTheEnd();
    void errorsArrive();
};

namespace {

bool poolIsDone() {
    return QThreadPool::globalInstance()->waitForDone(20000);
}

}  // namespace

/// The newest request is answered, whichever finishes first.
void TestLatest::newestIsAnswered() {
    QThreadPool::globalInstance()->setMaxThreadCount(2);
    for (const int first : {0, 1}) {
        QObject context;
        Latest latest(&context);
        QSemaphore mayEnd[2];
        QList<int> got;
        for (const int number : {0, 1})
            latest.ask(
                [number, &mayEnd] {
                    mayEnd[number].acquire();
                    return number;
                },
                [&got](const Answer<int>& answer) { got << answer.value; });
        mayEnd[first].release();
        QTRY_COMPARE(context.children().size(), 1);
        mayEnd[1 - first].release();
        QTRY_VERIFY(context.children().isEmpty());
        QCOMPARE(got, QList<int>{1});
    }
}

void TestLatest::olderWorkIsStopped() {
    QObject context;
    Latest latest(&context);
    std::atomic<bool> isStopped = false;
    const auto untilStopped = [&isStopped](const std::stop_token& stop) {
        while (!stop.stop_requested()) QThread::yieldCurrentThread();
        isStopped = true;
        return 1;
    };
    int got = 0;
    latest.ask(untilStopped, [&got](const Answer<int>& answer) { got = answer.value; });
    latest.ask([] { return 2; }, [&got](const Answer<int>& answer) { got = answer.value; });
    QTRY_COMPARE(got, 2);
    QTRY_VERIFY(context.children().isEmpty());
    QVERIFY(isStopped);
    QCOMPARE(got, 2);
}

void TestLatest::droppedIsNotAnswered() {
    QObject context;
    Latest latest(&context);
    latest.drop();  // nothing yet
    bool called = false;
    latest.ask([] { return 1; }, [&called](const Answer<int>&) { called = true; });
    QVERIFY(poolIsDone());  // its answer is on its way
    latest.drop();
    QTRY_VERIFY(context.children().isEmpty());
    QVERIFY(!called);
    latest.ask([] { return 2; }, [&called](const Answer<int>& answer) { called = answer.value == 2; });
    QTRY_VERIFY(called);
}

/// A dialog is closed meanwhile, with or without its parent.
void TestLatest::nothingIsAnsweredAfterTheEnd() {
    for (const bool contextEnds : {false, true}) {
        auto context = std::make_unique<QObject>();
        auto latest = std::make_unique<Latest>(context.get());
        QSemaphore mayEnd;
        bool called = false;
        latest->ask(
            [&mayEnd] {
                mayEnd.acquire();
                return 1;
            },
            [&called](const Answer<int>&) { called = true; });
        latest.reset();
        if (contextEnds) context.reset();
        mayEnd.release();
        QVERIFY(poolIsDone());
        QCoreApplication::processEvents();
        QVERIFY(!called);
    }
}

void TestLatest::errorsArrive() {
    QObject context;
    Latest latest(&context);
    Answer<int> got;
    bool called = false;
    const auto take = [&](const Answer<int>& answer) {
        got = answer;
        called = true;
    };
    latest.ask([]() -> int { throw InputError("a.obj", "is empty"); }, take);
    QTRY_VERIFY(called);
    QVERIFY2(got.problem.contains("a.obj") && got.problem.contains("is empty"), qPrintable(got.problem));
    QVERIFY(!got.stopped);
    called = false;
    latest.ask([]() -> int { throw Cancelled(); }, take);
    QTRY_VERIFY(called);
    QVERIFY(got.stopped && got.problem.isEmpty());
}

QTEST_GUILESS_MAIN(TestLatest)
#include "test_latest.moc"
