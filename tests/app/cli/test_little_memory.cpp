// A limit on addresses, from one under which the program cannot be loaded to one under which it works: the
// run ends well, or with one line and exit code 1. Never with a signal, and never not at all.

#include <QtTest>

#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

class TestLittleMemory : public QObject {
    Q_OBJECT

  private slots:
    void runEndsWell_data();
    void runEndsWell();
    void threadsOfBlasTakeNothing();

  private:
    QString writeStrip() const;
    QString writeCaged() const;

    QTemporaryDir m_folder;
};

/// A mesh in the plane, and a project that bends it.
QString TestLittleMemory::writeStrip() const {
    writeMesh<2>(m_folder.filePath("strip.obj").toStdString(), stripMesh(40, 8));
    putProject(m_folder.path(), "strip.wend",
               "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'points': [[1, 1]]}}, {'at': {'points': "
               "[[39, 7]]}, 'motion': [{'kind': 'translate', 'by': [0, 9]}]}]");
    return m_folder.filePath("strip.wend");
}

/// A surface in a cage, which a process of its own makes, under the same limit.
QString TestLittleMemory::writeCaged() const {
    QFile::copy(QStringLiteral(WEND_SOURCE_DIR "/resources/samples/bar.obj"), m_folder.filePath("bar.obj"));
    putProject(m_folder.path(), "caged.wend",
               "'domain': {'surface': 'bar.obj', 'cage': true, 'vertices': 4000}, 'handles': [{'at': "
               "{'region': {'sphere': {'centre': [0, 0, 0], 'radius': 1}}}}]");
    return m_folder.filePath("caged.wend");
}

void TestLittleMemory::runEndsWell_data() {
    QTest::addColumn<QString>("domain");
    QTest::addColumn<int>("megabytes");
    for (int megabytes = 80; megabytes <= 1200; megabytes += 40)
        QTest::addRow("picture, %d MB", megabytes) << "picture" << megabytes;
    // What needs no library for pictures comes to the libraries for matrices.
    for (const QString domain : {"mesh", "solid", "cage"})
        for (int megabytes = 340; megabytes <= 560; megabytes += 20)
            QTest::addRow("%s, %d MB", qPrintable(domain), megabytes) << domain << megabytes;
}

void TestLittleMemory::runEndsWell() {
    QFETCH(QString, domain);
    QFETCH(int, megabytes);
    const bool isPicture = domain == "picture";
    const QTemporaryDir folder;
    const QString samples = QStringLiteral(WEND_SOURCE_DIR "/resources/samples/");
    const QString project = isPicture           ? samples + "frog.wend"
                            : domain == "solid" ? samples + "bar.wend"
                            : domain == "cage"  ? writeCaged()
                                                : writeStrip();
    const QString command = QString(
                                "ulimit -v %1; exec timeout -k 1 100 \"%2\" run \"%3\" %4 "
                                "--mesh o.vtu --quiet --backend cpu --at 0.1")
                                .arg(megabytes * 1024)
                                .arg(WEND_BINARY, project, isPicture ? "--image o.png" : "");
    const CliResult result =
        runCli(folder.path(), {"-c", command}, QProcessEnvironment::systemEnvironment(), "/bin/bash");
    QVERIFY2(!result.crashed, qPrintable(result.error));
    const QStringList left = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
    if (result.code == 0) {
        QCOMPARE(left, (isPicture ? QStringList{"o.png", "o.vtu"} : QStringList{"o.vtu"}));
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
    QVERIFY2(result.error.startsWith("wend: ") &&
                 result.error.contains(QFileInfo(project).completeBaseName()) &&
                 result.error.contains("memory"),
             qPrintable(result.error));
}

/// OpenBLAS starts a thread for each further processor, and each of them takes 128 MB as soon as it runs:
/// that would leave too little here, and where it comes late nothing for the call that was promised its room.
void TestLittleMemory::threadsOfBlasTakeNothing() {
    const QTemporaryDir folder;
    const QString command = QString(
                                "ulimit -v %1; exec timeout -k 1 100 \"%2\" run \"%3\" --mesh o.vtu --quiet "
                                "--backend cpu --at 0.1")
                                .arg(440 * 1024)
                                .arg(WEND_BINARY, writeStrip());
    const CliResult result =
        runCli(folder.path(), {"-c", command}, QProcessEnvironment::systemEnvironment(), "/bin/bash");
    QVERIFY2(result.code == 0, qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestLittleMemory)
#include "test_little_memory.moc"
