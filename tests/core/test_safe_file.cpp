// Files that take their place whole or not at all, and programs that run beside this one.

#include <unistd.h>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/mesh/child_process.h"
#include "core/mesh/error.h"
#include "core/mesh/safe_file.h"

using namespace wend;
namespace fs = std::filesystem;

class TestSafeFile : public QObject {
    Q_OBJECT
  private slots:
    void twoOfOneName();
    void goesAlong();
    void leavesNoTrace();
    void followsNobodysLink();
    void childStandsAlone();
    void idleChildIsEnded();

  private:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }
    static void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }
    static std::string get(const std::string& path) {
        std::ifstream in(path);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator(m_folder.path().toStdString()), {});
    }

    QTemporaryDir m_folder;
};

/// Two exports to one file at a time do not write into one another: the later wins, whole.
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
    QVERIFY_EXCEPTION_THROWN(PendingFile(file("none/b.txt")), InputError);
}

/// A link that somebody put where the temporary is expected is not followed, and what goes to no regular file
/// waits in a folder that is this user's alone.
void TestSafeFile::followsNobodysLink() {
    put(file("victim"), "whole");
    const std::string expected = PendingFile(file("c.txt")).temporary();
    fs::create_symlink(file("victim"), expected);
    PendingFile pending(file("c.txt"));
    QVERIFY(pending.temporary() != expected);
    put(pending.temporary(), "c");
    pending.commit();
    QCOMPARE(get(file("victim")), std::string("whole"));
    QCOMPARE(get(file("c.txt")), std::string("c"));
    fs::remove(expected);
    const PendingFile nowhere("/dev/null");
    QVERIFY(nowhere.isSpecial() && !pending.isSpecial());
    QCOMPARE(fs::status(fs::path(nowhere.temporary()).parent_path()).permissions(), fs::perms::owner_all);
}

/// It has a process group of its own, so that Ctrl-C reaches this program alone, and none of the signals that
/// this one blocks or ignores.
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

/// A child that only sleeps is ended early, with what it has started; one that computes is not.
void TestSafeFile::idleChildIsEnded() {
    const std::string script = file("idle.sh"), busy = file("busy.sh");
    put(script, "#!/bin/sh\nsleep 1000 &\necho $!\nsleep 1000\n");
    put(busy, "#!/bin/sh\nk=0\nwhile [ $k -lt 400000 ]; do k=$((k+1)); done\necho done\n");
    for (const std::string& name : {script, busy}) fs::permissions(name, fs::perms::owner_all);
    const ChildResult idle = runChild(script, {}, 600, 1000, {}, 0, 1);
    QVERIFY(idle.end == ChildResult::End::Idle);
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
