#include <QSemaphore>
#include <QTest>
#include <QThreadPool>
#include <memory>
#include <thread>
#include <vector>

#include "app/base/hand_over.h"
#include "app/base/in_background.h"

using namespace wend;

/// Work in the background and the delivery of its results.
class TestInBackground : public QObject {
    Q_OBJECT
  private slots:
    void resultsComeBack();
    void deletedReceiversAreNotCalled();
    void workMayThrow();
    void callsComeInTheirOrder();
    void callsEndWithTheObject();
};

void TestInBackground::resultsComeBack() {
    QObject context;
    QThread* worker = nullptr;
    int got = 0;
    inBackground(
        &context,
        [&worker] {
            worker = QThread::currentThread();
            return 42;
        },
        [&](int result) {
            got = result;
            QCOMPARE(QThread::currentThread(), context.thread());
        });
    QTRY_COMPARE(got, 42);
    QVERIFY(worker != context.thread());
    QTRY_VERIFY(context.children().isEmpty());  // nothing piles up
}

/// A dialog may be closed while its preview is drawn, or between the end of the work and its event.
void TestInBackground::deletedReceiversAreNotCalled() {
    for (const bool finishesFirst : {false, true}) {
        QSemaphore mayGoOn;
        auto context = std::make_unique<QObject>();
        bool called = false;
        const BackgroundWork work = inBackground(
            context.get(),
            [&mayGoOn] {
                mayGoOn.acquire();
                return 1;
            },
            [&called](int) { called = true; });
        if (!finishesFirst) context.reset();
        mayGoOn.release();
        work.wait();
        QVERIFY(QThreadPool::globalInstance()->waitForDone(20000));
        context.reset();
        QCoreApplication::processEvents();
        QVERIFY(!called);
    }
}

void TestInBackground::workMayThrow() {
    QObject context;
    bool called = false;
    const BackgroundWork work = inBackground(
        &context, []() -> int { throw std::bad_alloc(); }, [&called](int) { called = true; });
    QTRY_VERIFY(!work.isRunning() && context.children().isEmpty());
    QVERIFY(!called);
}

/// Calls run in the thread of the object, one in each turn of its event loop.
void TestInBackground::callsComeInTheirOrder() {
    constexpr int kCalls = 200;
    HandOver out;
    std::vector<int> got;
    bool here = true;
    std::jthread caller([&] {
        for (int i = 0; i < kCalls; ++i)
            out.call([&, i] {
                got.push_back(i);
                here = here && QThread::currentThread() == out.thread();
            });
    });
    QTRY_COMPARE(got.size(), std::size_t(kCalls));
    for (int i = 0; i < kCalls; ++i) QCOMPARE(got[static_cast<std::size_t>(i)], i);
    QVERIFY(here);
}

void TestInBackground::callsEndWithTheObject() {
    auto out = std::make_unique<HandOver>();
    int calls = 0;
    out->call([&] {
        ++calls;
        out.reset();  // a call may end it
    });
    out->call([&] { ++calls; });
    QTRY_COMPARE(calls, 1);
    QCoreApplication::processEvents();
    QCOMPARE(calls, 1);
}

QTEST_GUILESS_MAIN(TestInBackground)
#include "test_in_background.moc"
