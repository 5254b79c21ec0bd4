// The program runs under limits on its address space, from one under which it cannot be loaded to one under
// which it works. Every run ends well, or with one line and exit code 5, never with a signal and never
// without ending.

#include <QRegularExpression>
#include <QtTest>

#include "core/base/input_file.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/address_limit.h"
#include "warp/picture_library.h"

class TestLittleMemory : public QObject {
    Q_OBJECT

  private slots:
    void runEndsWell_data();
    void runEndsWell();
    void threadsOfBlasTakeNothing();
    void memoryIsCheckedBeforeItIsAllocated();
    void pictureLibraryNeedsRoom();

  private:
    CliResult runWithin(int megabytes, const QString& folder, const QString& project,
                        const QString& outputs) const;
    QString writeStrip() const;
    QString writeCaged() const;

    QTemporaryDir m_folder;
};

/// Writes a mesh in the plane and a project that bends it.
QString TestLittleMemory::writeStrip() const {
    writeMesh<2>(m_folder.filePath("strip.obj").toStdString(), stripMesh(40, 8));
    putProject(m_folder.path(), "strip.wend",
               "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'points': [[1, 1]]}}, {'at': {'points': "
               "[[39, 7]]}, 'motion': [{'kind': 'translate', 'by': [0, 9]}]}]");
    return m_folder.filePath("strip.wend");
}

/// Writes a surface in a cage, which a separate process makes under the same limit.
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
    // Commands that need no picture library get as far as the matrix libraries.
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
    const CliResult result = runWithin(megabytes, folder.path(), project,
                                       isPicture ? "--image o.png --mesh o.vtu" : "--mesh o.vtu");
    QVERIFY2(!result.crashed, qPrintable(result.error));
    const QStringList left = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
    if (result.code == 0) {
        QCOMPARE(left, (isPicture ? QStringList{"o.png", "o.vtu"} : QStringList{"o.vtu"}));
        return;
    }
    QVERIFY2(result.error.count('\n') == 1, qPrintable(result.error));
    QCOMPARE(left, QStringList());
    // The dynamic linker reports its own error before the program runs.
    if (result.code == 127) {
        QVERIFY(result.error.contains("while loading shared libraries"));
        return;
    }
    QVERIFY2(result.code == 5, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(result.error.startsWith("wend: ") &&
                 (result.error.contains(QFileInfo(project).completeBaseName()) ||
                  result.error.contains(" o.png: ")) &&
                 result.error.contains("memory"),
             qPrintable(result.error));
}

/// OpenBLAS would start a thread for each further processor, each of which takes 128 MB when it runs. That
/// would leave too little memory here, or, if it came late, none for a call that had reserved its share.
void TestLittleMemory::threadsOfBlasTakeNothing() {
    const QTemporaryDir folder;
    const CliResult result = runWithin(440, folder.path(), writeStrip(), "--mesh o.vtu");
    QVERIFY2(result.code == 0, qPrintable(result.error));
}

/// The factor takes about 530 MB; limits in smaller steps fall between the memory used before it and its own.
void TestLittleMemory::memoryIsCheckedBeforeItIsAllocated() {
    const QTemporaryDir folder;
    const int n = 24;
    writeMesh<3>(folder.filePath("block.mesh").toStdString(), blockMesh(n, n, n));
    putProject(
        folder.path(), "block.wend",
        "'domain': {'mesh': 'block.mesh'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1, -1], "
        "'max': [99, 99, 0.5]}}}}, {'at': {'vertices': [5000]}, 'motion': [{'kind': 'translate', "
        "'by': [0, 0, 1]}]}]");
    const QString project = folder.filePath("block.wend");
    bool told = false;
    for (int megabytes = 500; !told && megabytes < 900; megabytes += 80) {
        const CliResult result = runWithin(megabytes, folder.path(), project, "--report -");
        QCOMPARE(result.code, 5);
        static const QRegularExpression line(
            "^wend: .*block.wend: needs about (\\d+) MB of memory; (\\d+) MB are free: take a coarser mesh "
            "or --solver multigrid\n$");
        const auto match = line.match(result.error);
        told = match.hasMatch();
        if (told) QVERIFY(match.captured(1).toInt() > match.captured(2).toInt());
        if (told) QVERIFY(match.captured(1).toInt() > 400);
    }
    QVERIFY(told);
}

/// A picture library that would just fit is refused: with a little less room, loading it would end the
/// process.
void TestLittleMemory::pictureLibraryNeedsRoom() {
    const wend::test::AddressLimit limit(700);
    QVERIFY_THROWS_EXCEPTION(wend::OutOfMemory, wend::pictureLibrary("o.png"));
}

CliResult TestLittleMemory::runWithin(int megabytes, const QString& folder, const QString& project,
                                      const QString& outputs) const {
    const QString command = QString(
                                "ulimit -v %1; exec timeout -k 1 100 \"%2\" run \"%3\" %4 --quiet "
                                "--backend cpu --at 0.1")
                                .arg(megabytes * 1024)
                                .arg(WEND_BINARY, project, outputs);
    return runCli(folder, {"-c", command}, QProcessEnvironment::systemEnvironment(), "/bin/bash");
}

QTEST_GUILESS_MAIN(TestLittleMemory)
#include "test_little_memory.moc"
