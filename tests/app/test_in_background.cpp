#include <QSemaphore>
#include <QTest>
#include <QThreadPool>

#include "app/document/in_background.h"

using namespace wend;

/// Work beside the window and what becomes of its result.
class TestInBackground : public QObject {
    Q_OBJECT
  private slots:
    void resultsComeBack();
    void whatIsGoneIsNotCalled();
    void workMayThrow();
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

/// A dialog that is closed while its preview is drawn; also between the end of the work and its event.
void TestInBackground::whatIsGoneIsNotCalled() {
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

QTEST_GUILESS_MAIN(TestInBackground)
#include "test_in_background.moc"
