// A limit on addresses, from one under which the program cannot be loaded to one under which it works: the
// run ends well, or with one line and exit code 1. Never with a signal, and never not at all.

#include <QtTest>

#include "tests/app/cli_harness.h"

class TestLittleMemory : public QObject {
    Q_OBJECT

  private slots:
    void runEndsWell_data();
    void runEndsWell();
};

void TestLittleMemory::runEndsWell_data() {
    QTest::addColumn<int>("megabytes");
    for (int megabytes = 80; megabytes <= 1200; megabytes += 40)
        QTest::addRow("%d MB", megabytes) << megabytes;
}

void TestLittleMemory::runEndsWell() {
    QFETCH(int, megabytes);
    const QTemporaryDir folder;
    const QString command =
        QString(
            "ulimit -v %1; exec \"%2\" run \"%3/resources/samples/frog.wend\" --image o.png "
            "--mesh o.vtu --quiet --backend cpu")
            .arg(megabytes * 1024)
            .arg(WEND_BINARY, WEND_SOURCE_DIR);
    const CliResult result =
        runCli(folder.path(), {"-c", command}, QProcessEnvironment::systemEnvironment(), "/bin/bash");
    QVERIFY2(!result.crashed, qPrintable(result.error));
    const QStringList left = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
    if (result.code == 0) {
        QCOMPARE(left, (QStringList{"o.png", "o.vtu"}));
        return;
    }
    QVERIFY2(result.error.count('\n') == 1, qPrintable(result.error));
    QCOMPARE(left, QStringList());
    // The dynamic linker speaks for itself, before anything of the program runs.
    if (result.code == 127) {
        QVERIFY(result.error.contains("while loading shared libraries"));
        return;
    }
    QVERIFY2(result.code == 1, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(
        result.error.startsWith("wend: ") && result.error.contains("frog") && result.error.contains("memory"),
        qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestLittleMemory)
#include "test_little_memory.moc"
