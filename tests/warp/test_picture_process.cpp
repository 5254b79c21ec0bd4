// The process that reads pictures: any failure of it gives one message that names the file, and the next
// picture is read again.

#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <future>
#include <thread>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "tests/support/child_processes.h"
#include "tests/support/pictures.h"
#include "warp/picture_process.h"

using namespace wend;
using namespace wend::test;

namespace {

/// The standard input of another process.
int inputOf(pid_t process) {
    const auto handle = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
    const auto input = static_cast<int>(syscall(SYS_pidfd_getfd, handle, STDIN_FILENO, 0));
    close(handle);
    return input;
}

}  // namespace

class TestPictureProcess : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void isKeptForTheNextPicture();
    void isReplacedAfterADamagedFile();
    void severalAtOnce();
    void signalsAreReported_data();
    void signalsAreReported();
    void hangIsReported();
#ifndef WEND_SANITIZED  // sanitizers end a process that gets no memory
    void littleMemoryIsReported();
#endif
    void canBeCancelled();

  private:
    std::string path(const char* name) const {
        return m_folder.filePath(name).toStdString();
    }
    /// Returns the process that has read the small picture and waits for the next.
    pid_t waiting() const {
        readPicture(path("small.png"), {});
        return childCalled("wend-picture", QCoreApplication::applicationPid());
    }
    std::string reasonOf(const PictureLimits& limits = {}, const char* name = "small.png") const {
        try {
            readPicture(path(name), limits);
        } catch (const InputError& error) {
            return error.file() == path(name) ? error.reason() : "another file: " + error.file();
        }
        return {};
    }
    bool isReadAgain() const {
        return readPicture(path("small.png"), {}).image.data == m_small.data && reasonOf().empty();
    }

    QTemporaryDir m_folder;
    Image m_small = randomPicture(30, 20, 4, PixelType::UInt8, true);
};

void TestPictureProcess::initTestCase() {
    m_small.unassociated = true;
    writeImage(path("small.png"), m_small);
    Image tall = randomPicture(50, 1000, 3, PixelType::UInt16, false);
    writeImage(path("tall.tif"), tall);
    writeImage(path("large.webp"), randomPicture(2000, 2000, 4, PixelType::UInt8, true));
    QFile whole(m_folder.filePath("tall.tif")), cut(m_folder.filePath("cut.tif"));
    QVERIFY(whole.open(QIODevice::ReadOnly) && cut.open(QIODevice::WriteOnly));
    cut.write(whole.readAll().left(9000));
}

void TestPictureProcess::isKeptForTheNextPicture() {
    const pid_t process = waiting();
    QVERIFY(process > 0);
    for (int k = 0; k < 3; ++k) QVERIFY(isReadAgain());
    readPictureHeader(path("tall.tif"));
    QVERIFY(reasonOf({}, "missing.png") == "does not exist");  // which needs no process
    QCOMPARE(waiting(), process);
}

/// A damaged file may have corrupted the process's memory.
void TestPictureProcess::isReplacedAfterADamagedFile() {
    const pid_t process = waiting();
    QVERIFY(!reasonOf({}, "cut.tif").empty());
    QVERIFY(!lives(process));
    QVERIFY(waiting() != process);
}

void TestPictureProcess::severalAtOnce() {
    const Image tall = readPicture(path("tall.tif"), {}).image;
    std::vector<std::future<bool>> threads;
    for (int t = 0; t < 4; ++t)
        threads.push_back(std::async(std::launch::async, [&] {
            for (int k = 0; k < 2; ++k)
                if (!isReadAgain() || readPicture(path("tall.tif"), {}).image.data != tall.data) return false;
            return true;
        }));
    for (auto& thread : threads) QVERIFY(thread.get());
}

void TestPictureProcess::signalsAreReported_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<QString>("reason");
    QTest::newRow("killed") << SIGKILL << "cannot be read: its reader was ended (signal 9)";
    QTest::newRow("crashed") << SIGABRT << "cannot be read: its reader failed inside (signal 6)";
    QTest::newRow("computed for ever") << SIGXCPU << "cannot be read: its reader has not come to an end";
}

/// The process is stopped, so that reading is under way when the signal comes. If the signal came before the
/// request, another process has read the picture: then the next attempt waits longer.
void TestPictureProcess::signalsAreReported() {
    QFETCH(int, signal);
    QFETCH(QString, reason);
    std::string read;
    for (unsigned long wait = 1; read.empty() && wait <= 4096; wait *= 4) {
        const pid_t process = waiting();
        QCOMPARE(childrenOf(QCoreApplication::applicationPid()).size(), 1);
        QCOMPARE(kill(process, SIGSTOP), 0);
        auto reading = std::async(std::launch::async, [&] { return reasonOf(); });
        QThread::msleep(wait);
        QCOMPARE(kill(process, signal), 0);
        QCOMPARE(kill(process, SIGCONT), 0);
        read = reading.get();
    }
    QCOMPARE(QString::fromStdString(read), reason);
    QVERIFY(isReadAgain());
}

void TestPictureProcess::hangIsReported() {
    const pid_t process = waiting();
    QCOMPARE(kill(process, SIGSTOP), 0);
    QCOMPARE(reasonOf({.idleSeconds = 0.3}),
             std::string("cannot be read: its reader has done nothing for 0.3 s"));
    QVERIFY(!lives(process));
    QVERIFY(isReadAgain());
}

#ifndef WEND_SANITIZED
/// Eight megabytes are left, and the picture takes sixteen.
void TestPictureProcess::littleMemoryIsReported() {
    readPictureHeader(path("large.webp"));  // its library is loaded
    const pid_t process = waiting();
    QFile memory(QString("/proc/%1/statm").arg(process));
    QVERIFY(memory.open(QIODevice::ReadOnly));
    const auto pages = memory.readAll().split(' ').at(0).toULongLong();
    const rlimit limit{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (8U << 20U), 8ULL << 30U};
    if (prlimit(process, RLIMIT_AS, &limit, nullptr) != 0) QSKIP("the limit of another process is not ours");
    const std::string reason = reasonOf({}, "large.webp");
    QVERIFY2(reason.starts_with("cannot be read: it needs more than the 8192 MB of memory"), reason.c_str());
    QVERIFY(isReadAgain());
}
#endif

void TestPictureProcess::canBeCancelled() {
    const pid_t process = waiting();
    QCOMPARE(kill(process, SIGSTOP), 0);
    const int socket = inputOf(process);
    if (socket < 0) QSKIP("what another process has open is not ours");
    auto reading = std::async(std::launch::async, [&] { return reasonOf(); });
    int waiting = 0;  // bytes of the request
    QVERIFY(QTest::qWaitFor([&] { return ioctl(socket, FIONREAD, &waiting) == 0 && waiting > 0; }, 60000));
    close(socket);
    stopReading(true);
    QVERIFY_THROWS_EXCEPTION(Cancelled, reading.get());
    stopReading(false);
    QVERIFY(!lives(process));
    QVERIFY(isReadAgain());
}

QTEST_GUILESS_MAIN(TestPictureProcess)
#include "test_picture_process.moc"
