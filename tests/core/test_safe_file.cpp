// Files that replace the old ones completely or not at all, and child processes.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "core/base/checked_file.h"
#include "core/base/child_process.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/safe_file.h"
#include "core/base/same_file.h"

using namespace wend;
namespace fs = std::filesystem;

class TestSafeFile : public QObject {
    Q_OBJECT
  private slots:
    void twoOfOneName();
    void goesAlong();
    void leavesNoTrace();
    void staysPrivate();
    void replacesByRenaming();
    void keepsRights();
    void keepsWhatIsReadOnly();
    void writesLongNames();
    void clearsUpAfterTheDead();
    void tellsOfEveryLostByte();
    void linkIsFollowedToWhereNothingIs();
    void pipeNeedsAReader();
    void pipeGetsAll();
    void pipeThatIsFullDoesNotHold();
    void knowsTheSameFile();
    void childStandsAlone();
    void idleChildIsEnded();

  private:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }
    static void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }
    static std::string get(const std::string& path) {
        std::ifstream in(path);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static struct stat statusOf(const std::string& path) {
        struct stat status {};
        stat(path.c_str(), &status);
        return status;
    }
    static int modeOf(const std::string& path) { return static_cast<int>(statusOf(path).st_mode & 0777); }
    std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator(m_folder.path().toStdString()), {});
    }

    QTemporaryDir m_folder;
};

/// Two simultaneous exports to one file do not write into one another: the later one replaces it completely.
void TestSafeFile::twoOfOneName() {
    PendingFile one(file("a.txt")), other(file("a.txt"));
    QVERIFY(one.temporary() != other.temporary());
    put(one.temporary(), "one");
    put(other.temporary(), "other");
    one.commit();
    QCOMPARE(get(file("a.txt")), std::string("one"));
    other.commit();
    QCOMPARE(get(file("a.txt")), std::string("other"));
}

void TestSafeFile::goesAlong() {
    PendingFile points(file("m.node"));
    PendingFile cells = points.companion(".ele");
    QCOMPARE(cells.temporary(), fs::path(points.temporary()).replace_extension(".ele").string());
    put(points.temporary(), "points");
    put(cells.temporary(), "cells");
    points.commit();
    cells.commit();
    QCOMPARE(get(file("m.node")), std::string("points"));
    QCOMPARE(get(file("m.ele")), std::string("cells"));
}

void TestSafeFile::leavesNoTrace() {
    const auto before = entries();
    {
        PendingFile file(this->file("b.txt"));
        put(file.temporary(), "never");
        QVERIFY(entries() > before);
    }
    QCOMPARE(entries(), before);
    QVERIFY_THROWS_EXCEPTION(InputError, PendingFile(file("none/b.txt")));
}

/// Temporary files are in a folder that only this user can read, whatever the permissions around it.
void TestSafeFile::staysPrivate() {
    const PendingFile pending(file("c.txt")), nowhere("/dev/null");
    QVERIFY(nowhere.isSpecial() && !pending.isSpecial());
    for (const PendingFile* one : {&pending, &nowhere}) {
        const fs::path folder = fs::path(one->temporary()).parent_path();
        QCOMPARE(fs::symlink_status(folder).type(), fs::file_type::directory);
        QCOMPARE(fs::status(folder).permissions(), fs::perms::owner_all);
    }
    QCOMPARE(writeBytes(pending.temporary(), "c"), std::string());
    QCOMPARE(modeOf(pending.temporary()), 0600);
}

/// The new file is another one: readers of the old one, and its other names, still have it completely.
void TestSafeFile::replacesByRenaming() {
    put(file("r.txt"), "old");
    fs::create_hard_link(file("r.txt"), file("r.link"));
    std::ifstream reader(file("r.txt"));
    const auto before = statusOf(file("r.txt")).st_ino;
    writeWhole(file("r.txt"), "new and longer");
    QVERIFY(statusOf(file("r.txt")).st_ino != before);
    QCOMPARE(statusOf(file("r.link")).st_ino, before);
    QCOMPARE(get(file("r.txt")), std::string("new and longer"));
    QCOMPARE(get(file("r.link")), std::string("old"));
    QCOMPARE(std::string(std::istreambuf_iterator<char>(reader), {}), std::string("old"));
}

/// A new file has the permissions that the user's mask leaves, a replaced one those that it had, a private
/// one its owner's alone. Owner and attributes are kept where this user may set them.
void TestSafeFile::keepsRights() {
    const mode_t mask = umask(027);
    writeWhole(file("new.txt"), "n");
    umask(mask);
    QCOMPARE(modeOf(file("new.txt")), 0640);
    writeWhole(file("own.txt"), "n", Access::Private);
    QCOMPARE(modeOf(file("own.txt")), 0600);
    put(file("old.txt"), "o");
    QCOMPARE(chmod(file("old.txt").c_str(), 0604), 0);
    const bool given = chown(file("old.txt").c_str(), 12345, 23456) == 0;
    const bool marked = setxattr(file("old.txt").c_str(), "user.note", "kept", 4, 0) == 0;
    const struct stat before = statusOf(file("old.txt"));
    writeWhole(file("old.txt"), "n");
    const struct stat after = statusOf(file("old.txt"));
    QVERIFY(before.st_ino != after.st_ino);
    QCOMPARE(after.st_mode, before.st_mode);
    QCOMPARE(after.st_uid, before.st_uid);
    QCOMPARE(after.st_gid, before.st_gid);
    QCOMPARE(after.st_uid == 12345, given);
    char note[8] = {};
    QCOMPARE(getxattr(file("old.txt").c_str(), "user.note", note, sizeof note), marked ? 4 : -1);
    QCOMPARE(std::string(note), std::string(marked ? "kept" : ""));
}

void TestSafeFile::keepsWhatIsReadOnly() {
    put(file("kept.txt"), "o");
    fs::permissions(file("kept.txt"), fs::perms::owner_read);
    const auto before = entries();
    QVERIFY_THROWS_EXCEPTION(InputError, writeWhole(file("kept.txt"), "n"));
    QCOMPARE(entries(), before);
    QCOMPARE(get(file("kept.txt")), std::string("o"));
}

/// The longest possible file names work; one character more is refused before anything is written.
void TestSafeFile::writesLongNames() {
    for (int length : {249, 255}) {
        const std::string name = file((std::string(length - 4, 'n') + ".png").c_str());
        writeWhole(name, "long");
        QCOMPARE(get(name), std::string("long"));
        fs::remove(name);
    }
    QVERIFY_THROWS_EXCEPTION(InputError, PendingFile(file((std::string(252, 'n') + ".png").c_str())));
}

/// The remains of killed programs are removed by the next one that works there; files of a living one, and
/// those that only look alike, stay.
void TestSafeFile::clearsUpAfterTheDead() {
    const auto folder = [&](const char* name) {
        fs::create_directory(file(name));
        put(file(name) + "/lock", "");
        put(file(name) + "/0.png", "half");
    };
    for (const char* name : {".wend-killed", ".wend-living", ".wend-other-one"}) folder(name);
    fs::create_directory(file(".wend-begun_"));
    const int lock = open((file(".wend-living") + "/lock").c_str(), O_RDWR);
    QCOMPARE(flock(lock, LOCK_EX), 0);
    writeWhole(file("d.txt"), "d");
    QVERIFY(!fs::exists(file(".wend-killed")));
    QVERIFY(!fs::exists(file(".wend-begun_")));
    QVERIFY(fs::exists(file(".wend-living") + "/0.png"));
    QVERIFY(fs::exists(file(".wend-other-one") + "/0.png"));
    close(lock);
    writeWhole(file("d.txt"), "d");
    QVERIFY(!fs::exists(file(".wend-living")));
    fs::remove_all(file(".wend-other-one"));
}

/// Wherever the disk ends, the error is reported, even if only the last byte is missing; otherwise every byte
/// is there, in whatever order it came.
void TestSafeFile::tellsOfEveryLostByte() {
    std::signal(SIGXFSZ, SIG_IGN);
    const auto written = [&](std::size_t size, std::size_t most) {
        struct rlimit before {};
        getrlimit(RLIMIT_FSIZE, &before);
        const struct rlimit limit { most, before.rlim_max };
        setrlimit(RLIMIT_FSIZE, &limit);
        CheckedFile out(file("bytes"));
        for (std::size_t at = 10; at < size; ++at) out.write(std::int64_t(at), "x", 1);
        out.write(0, "0123456789", 10);  // the head comes last, as some formats have it
        const std::string reason = out.finish();
        setrlimit(RLIMIT_FSIZE, &before);
        return reason;
    };
    for (const std::size_t size : {std::size_t(100), std::size_t(65536), std::size_t(200001)}) {
        for (const std::size_t missing : {1, 2, 50})
            QVERIFY2(!written(size, size - missing).empty(), qPrintable(QString::number(size - missing)));
        QCOMPARE(written(size, size), std::string());
        QCOMPARE(get(file("bytes")), "0123456789" + std::string(size - 10, 'x'));
    }
    std::signal(SIGXFSZ, SIG_DFL);
    QVERIFY(!writeBytes("/dev/full", "lost").empty());
    QVERIFY(!writeBytes(file("none/b"), "lost").empty());
}

/// One file has many names, also by a link to a link; two links to each other are an error.
void TestSafeFile::linkIsFollowedToWhereNothingIs() {
    fs::create_directory(file("far"));
    fs::create_symlink("far/there", file("second"));
    fs::create_symlink("second", file("first"));
    writeWhole(file("first"), "text");
    QCOMPARE(get(file("far/there")), std::string("text"));
    QVERIFY(fs::is_symlink(file("first")) && fs::is_symlink(file("second")));
    fs::remove(file("far/there"));
    const std::string straight = fs::absolute(file("far/straight")).string();
    fs::create_symlink(straight, file("absolute"));
    writeWhole(file("absolute"), "more");
    QCOMPARE(get(straight), std::string("more"));
    for (const char* name : {"first", "second", "absolute", "far"}) fs::remove_all(file(name));
}

void TestSafeFile::pipeNeedsAReader() {
    QCOMPARE(mkfifo(file("pipe").c_str(), 0600), 0);
    try {
        writeWhole(file("pipe"), "text");
        QFAIL("nobody reads from it");
    } catch (const InputError& error) {
        QCOMPARE(error.reason(), std::string("cannot be written: nobody reads from it"));
    }
    QVERIFY(fs::is_fifo(file("pipe")));
    fs::remove(file("pipe"));
}

/// More bytes than a pipe holds reach a slow reader.
void TestSafeFile::pipeGetsAll() {
    QCOMPARE(mkfifo(file("pipe").c_str(), 0600), 0);
    std::string text, got;
    for (int i = 0; i < 40000; ++i) text += std::to_string(i) + ' ';
    const int end = open(file("pipe").c_str(), O_RDONLY | O_NONBLOCK);
    QVERIFY(end >= 0);
    std::jthread reader([&] {
        fcntl(end, F_SETFL, 0);
        char piece[1000];
        while (got.size() < text.size()) {  // before there is a writer its end is seen
            const ssize_t count = read(end, piece, sizeof piece);
            if (count < 0) break;
            got.append(piece, static_cast<std::size_t>(count));
        }
    });
    writeWhole(file("pipe"), text);
    reader.join();
    close(end);
    QVERIFY(got == text);
    fs::remove(file("pipe"));
}

void TestSafeFile::pipeThatIsFullDoesNotHold() {
    QCOMPARE(mkfifo(file("pipe").c_str(), 0600), 0);
    const int end = open(file("pipe").c_str(), O_RDWR);  // never reads
    QVERIFY(end >= 0);
    std::jthread stopper([] {
        QThread::msleep(300);
        stopReading(true);
    });
    const auto again = qScopeGuard([] { stopReading(false); });
    QVERIFY_THROWS_EXCEPTION(Cancelled, writeWhole(file("pipe"), std::string(1 << 20, 'x')));
    close(end);
    fs::remove(file("pipe"));
}

void TestSafeFile::knowsTheSameFile() {
    fs::create_directory(file("place"));
    put(file("place/one"), "1");
    put(file("two"), "1");
    fs::create_symlink(file("place/one"), file("link"));
    fs::create_hard_link(file("place/one"), file("hard"));
    fs::create_symlink(file("place"), file("way"));
    const std::string one = file("place/one");
    const std::string relative = fs::relative(one).string();
    for (const std::string& name :
         {file("link"), file("hard"), file("way/one"), file("way/../place/./one"), relative})
        QVERIFY2(sameFile(one, name) && sameFile(name, one), name.c_str());
    for (const std::string& name :
         {file("two"), file("place"), file("place/two"), std::string("-"), std::string()})
        QVERIFY2(!sameFile(one, name), name.c_str());
    QVERIFY(sameFile(file("way/new"), file("place/new")));
    QVERIFY(!sameFile(file("way/new"), file("place/newer")));
    QVERIFY(!sameFile("-", "-"));
}

/// The child has a process group of its own, so that Ctrl-C reaches this program alone, and none of the
/// signals that this one blocks or ignores.
void TestSafeFile::childStandsAlone() {
    const std::string script = file("child.sh");
    // grep inherits the shell's signals; the shell itself blocks all of them for a moment while it starts
    // grep.
    put(script,
        "#!/bin/sh\necho $$\ncut -d' ' -f5 /proc/$$/stat\ngrep -E 'Sig(Blk|Ign)' /proc/self/status\n");
    fs::permissions(script, fs::perms::owner_all);
    std::signal(SIGPIPE, SIG_IGN);
    const ChildResult result = runChild(script, {}, 20, 1000, {});
    std::signal(SIGPIPE, SIG_DFL);
    QVERIFY(result.end == ChildResult::End::Exited && result.code == 0);
    const QStringList lines = QString::fromStdString(result.output).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 4);
    QCOMPARE(lines[1], lines[0]);
    const qulonglong pipe = 1ULL << (SIGPIPE - 1);
    for (int k : {2, 3}) QCOMPARE(lines[k].section('\t', 1).toULongLong(nullptr, 16) & pipe, 0ULL);
}

/// A child that only sleeps is ended early, with its own children; one that computes is not.
void TestSafeFile::idleChildIsEnded() {
    const std::string script = file("idle.sh"), busy = file("busy.sh");
    put(script, "#!/bin/sh\nsleep 1000 &\necho $!\nsleep 1000\n");
    put(busy, "#!/bin/sh\nk=0\nwhile [ $k -lt 400000 ]; do k=$((k+1)); done\necho done\n");
    for (const std::string& name : {script, busy}) fs::permissions(name, fs::perms::owner_all);
    const ChildResult idle = runChild(script, {}, 600, 1000, {}, 0, 1);
    QCOMPARE(idle.end, ChildResult::End::Idle);
    const std::string stat = "/proc/" + std::to_string(std::stoi(idle.output)) + "/stat";
    QVERIFY(QTest::qWaitFor([&] {  // gone, or not yet waited for by whoever adopted it
        const QByteArray state = QByteArray::fromStdString(fs::exists(stat) ? get(stat) : "");
        return state.isEmpty() || state.contains(") Z ");
    }));
    const ChildResult other = runChild(busy, {}, 600, 1000, {}, 0, 1);
    QVERIFY(other.end == ChildResult::End::Exited && other.output == "done\n");
}

QTEST_GUILESS_MAIN(TestSafeFile)
#include "test_safe_file.moc"
