// Helper programs that hang or are killed: the error is one line, and no process or file is left.

#include <QtTest>
#include <csignal>

#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/child_processes.h"

using namespace wend;
using namespace wend::test;

class TestHelperPrograms : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void failuresAreReported_data();
    void failuresAreReported();
    void diesWithTheProgram();
    void killedMesher_data();
    void killedMesher();
    void missingHdf5();

  private:
    QProcessEnvironment environment(const QString& way) const;
    QString path() const { return m_folder.path(); }
    QStringList listing() const {
        return QDir(path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    QTemporaryDir m_folder;
};

void TestHelperPrograms::initTestCase() {
    put(path(), "hanging.icd", WEND_TEST_DRIVER_FILE "\n");
    writeMesh<2>((path() + "/strip.obj").toStdString(), stripMesh(4, 2));
    putProject(path(), "strip.wend", "'domain': {'mesh': 'strip.obj'}");
}

QProcessEnvironment TestHelperPrograms::environment(const QString& way) const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("OCL_ICD_VENDORS", path());
    environment.insert("WEND_TEST_DRIVER", way);
    return environment;
}

void TestHelperPrograms::failuresAreReported_data() {
    QTest::addColumn<QString>("way");
    QTest::addColumn<QString>("limit");
    QTest::newRow("sleeps") << "sleep"
                            << "within 4 seconds";
    QTest::newRow("computes") << "loop"
                              << "within 10 seconds of computing";
}

void TestHelperPrograms::failuresAreReported() {
    QFETCH(QString, way);
    QFETCH(QString, limit);
    const CliResult devices = runCli(path(), {"devices"}, environment(way));
    QVERIFY2(devices.code == 0 && !devices.crashed, qPrintable(devices.error));
    QVERIFY2(devices.out.contains("an OpenCL driver gave no answer " + limit), qPrintable(devices.out));
    const CliResult run =
        runCli(path(), {"run", "strip.wend", "--report", "r.json", "--backend", "opencl"}, environment(way));
    QVERIFY2(run.code == 3 && run.error.count('\n') == 1, qPrintable(run.error));
    QVERIFY2(run.error.contains(limit), qPrintable(run.error));
}

void TestHelperPrograms::diesWithTheProgram() {
    QProcess process;
    process.setProcessEnvironment(environment("sleep"));
    process.start(WEND_BINARY, {"devices"});
    QVERIFY(process.waitForStarted());
    const pid_t probe = childCalled("wend-clprobe", process.processId());
    QVERIFY(probe > 0);
    process.kill();
    QVERIFY(process.waitForFinished(60000));
    QVERIFY(QTest::qWaitFor([&] { return !lives(probe); }, 60000));
}

void TestHelperPrograms::killedMesher_data() {
    QTest::addColumn<QString>("mesher");
    QTest::addColumn<int>("signal");
    for (const QString mesher : {"wend-tetgen", "wend-cage"}) {
        QTest::addRow("%s, ended by somebody", qPrintable(mesher)) << mesher << SIGKILL;
        QTest::addRow("%s, a fault of its own", qPrintable(mesher)) << mesher << SIGSEGV;
    }
}

void TestHelperPrograms::killedMesher() {
    QFETCH(QString, mesher);
    QFETCH(int, signal);
    put(path(), "tetrahedron.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    put(path(), "kept.vtu", "old");
    const QStringList before = listing();
    QProcess process;
    process.setWorkingDirectory(path());
    process.start(WEND_BINARY, {"mesh", "tetrahedron.obj", "-o", "kept.vtu", "--refine-surface",
                                mesher == "wend-cage" ? "--cage" : "--no-cage", "--max-volume",
                                "1e-8"});  // a minute's work
    QVERIFY(process.waitForStarted());
    const pid_t child = childCalled(mesher, process.processId());
    QVERIFY(child > 0);
    QCOMPARE(::kill(child, signal), 0);
    QVERIFY(process.waitForFinished(60000));
    const QByteArray said = process.readAllStandardError();
    QVERIFY(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 3);
    QVERIFY2(said.startsWith("wend: tetrahedron.obj: ") && said.count('\n') == 1, said.constData());
    QVERIFY2(said.contains("signal " + QByteArray::number(signal)), said.constData());
    QCOMPARE(listing(), before);
    QCOMPARE(readTextFile((path() + "/kept.vtu").toStdString()), std::string("old"));
}

/// A copy of the program without its helpers can do everything else.
void TestHelperPrograms::missingHdf5() {
    QTemporaryDir alone;
    const QString program = alone.filePath(QStringLiteral("wend"));
    QVERIFY(QFile::copy(QStringLiteral(WEND_BINARY), program));
    put(alone.path(), "a.med", "\x89HDF\r\n\x1a\n and more");
    const CliResult info =
        runCli(alone.path(), {"info", "a.med"}, QProcessEnvironment::systemEnvironment(), program);
    QCOMPARE(info.code, 3);
    QCOMPARE(info.error,
             QString("wend: a.med: HDF5 files need wend-hdf5, which is missing beside the program: it is "
                     "built where libhdf5-dev is installed\n"));
}

QTEST_GUILESS_MAIN(TestHelperPrograms)
#include "test_helper_programs.moc"
