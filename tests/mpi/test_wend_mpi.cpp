// wend-mpi in one, two and four processes is compared with itself and with the program of one process.
#include <csignal>

#include <QtTest>
#include <random>

#include "tests/app/cli/cli_harness.h"
#include "tests/support/mesh_files.h"

using namespace wend;

class TestWendMpi : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void sameShapeForAnyProcesses_data();
    void sameShapeForAnyProcesses();
    void errorsAreReportedOnce_data();
    void errorsAreReportedOnce();
    void runsThatCannotBeCompleted();
    void cancelledRuns();
    void lostProcessesAreNamed_data();
    void lostProcessesAreNamed();
    void moreProcessesThanUnknowns();

  private:
    QString path() const { return m_folder.path(); }
    CliResult runMany(int processes, const QStringList& arguments) const {
        return runCli(path(), launch(processes) + arguments, environment(), "mpirun");
    }
    static QStringList launch(int processes) {
        return {"-q", "--allow-run-as-root",      "--oversubscribe",
                "-n", QString::number(processes), WEND_MPI_BINARY};
    }
    static QProcessEnvironment environment() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove("DISPLAY");
        environment.remove("QT_QPA_PLATFORM");
        return environment;
    }
    QJsonObject report(const QString& name) const {
        return QJsonDocument::fromJson(
                   QByteArray::fromStdString(readTextFile((path() + "/" + name).toStdString())))
            .object();
    }
    std::string file(const QString& name) const { return (path() + "/" + name).toStdString(); }

    QTemporaryDir m_folder;
};

namespace {

// Rounding differs with the order of sums, by far less than the 5e-5 to which velocities are solved for.
constexpr double kAgreement = 1e-8;  // of the size

/// Returns the process with this rank that an mpirun has started, or 0 if there is none.
qint64 processOf(qint64 mpirun, int rank) {
    const QByteArray wanted = "OMPI_COMM_WORLD_RANK=" + QByteArray::number(rank);
    for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
        QFile status("/proc/" + name + "/stat"), environment("/proc/" + name + "/environ");
        if (!status.open(QIODevice::ReadOnly) || !environment.open(QIODevice::ReadOnly)) continue;
        const QByteArray text = status.readAll();
        const QList<QByteArray> behindName = text.mid(text.lastIndexOf(')') + 2).split(' ');
        if (behindName.value(1).toLongLong() == mpirun && environment.readAll().split('\0').contains(wanted))
            return name.toLongLong();
    }
    return 0;
}

template <int Dim>
SimplicialMesh<Dim> jittered(SimplicialMesh<Dim> mesh) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> offset(-0.12, 0.12);
    for (auto& x : mesh.points.reshaped()) x += offset(random);
    return mesh;
}

/// Compares two meshes point by point.
template <int Dim>
double distance(const std::string& a, const std::string& b) {
    const auto first = readMesh<Dim>(a), second = readMesh<Dim>(b);
    if (first.points.cols() != second.points.cols()) return std::numeric_limits<double>::infinity();
    return (first.points - second.points).cwiseAbs().maxCoeff() / boundingBoxDiagonal<Dim>(first.points);
}

}  // namespace

void TestWendMpi::initTestCase() {
    writeMesh<3>(file("bar.mesh"), jittered<3>(blockMesh(11, 11, 20)));
    writeMesh<2>(file("strip.obj"), jittered<2>(stripMesh(60, 16)));
    writeMesh<2>(file("small.obj"), stripMesh(10, 2));
    const std::string ends =
        "'handles': [{'at': {'region': {'box': {'min': [-1, -1, -1], 'max': [12, 12, 0.4]}}}}, "
        "{'at': {'region': {'box': {'min': [-1, -1, 19.6], 'max': [12, 12, 21]}}}, 'motion': [{'kind': "
        "'rotate', 'centre': [5.5, 5.5, 20], 'axis': [0, 0, 1], 'angle': 1.2}]}";
    putProject(path(), "twist.wend", "'domain': {'mesh': 'bar.mesh'}, " + ends + "]");
    // Large enough for two processes to divide the first coarse level, too.
    writeMesh<3>(file("thick.mesh"), jittered<3>(blockMesh(15, 15, 24)));
    putProject(
        path(), "thick.wend",
        "'domain': {'mesh': 'thick.mesh'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1, -1], "
        "'max': [16, 16, 0.4]}}}}, {'at': {'region': {'box': {'min': [-1, -1, 23.6], 'max': [16, 16, "
        "25]}}}, 'motion': [{'kind': 'rotate', 'centre': [7.5, 7.5, 24], 'axis': [0, 0, 1], 'angle': "
        "0.4}]}]");
    // Points within cells, a side that slides, stiffness along an axis, and a shape that remembers.
    putProject(path(), "kinds.wend",
               "'domain': {'mesh': 'bar.mesh'}, 'material': {'memory': 2, 'regions': [{'shape': {'sphere': "
               "{'centre': [5, 5, 10], 'radius': 4}}, 'stiffness': {'axis': [1, 0, 0], 'ratio': 4}}]}, " +
                   ends +
                   ", {'at': {'points': [[5.3, 5.4, 10.2], [5.6, 5.4, 10.3]]}}, {'at': {'region': {'box': "
                   "{'min': [-1, -1, 5], 'max': [12, 0.3, 15]}}}, 'hold': ['y']}]");
    putProject(path(), "endless.wend",
               "'domain': {'mesh': 'bar.mesh'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1, -1], "
               "'max': [12, 12, 0.4]}}}}, {'at': {'region': {'box': {'min': [-1, -1, 19.6], 'max': [12, 12, "
               "21]}}}, " +
                   endlessMotion("[4, 0, 0]", "[-4, 0, 0]") + "}]");
    // The handles act in two intervals of time, with other constraints in each.
    putProject(path(), "plane.wend",
               "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'points': [[0.5, 1], [0.5, 15]]}}, "
               "{'at': {'points': [[59, 8.2], [59, 3.1]]}, 'active': [0, 0.5], 'motion': [{'kind': "
               "'rotate', 'centre': [59, 8], 'angle': 1, 'time': [0, 0.5]}]}, {'at': {'points': [[30, 8]]}, "
               "'active': [0.5, 1], 'motion': [{'kind': 'translate', 'by': [0, 9], 'time': [0.5, 1]}]}]");
}

void TestWendMpi::sameShapeForAnyProcesses_data() {
    QTest::addColumn<QString>("project");
    QTest::addColumn<bool>("solid");
    QTest::newRow("twist") << "twist" << true;
    QTest::newRow("divided coarse level") << "thick" << true;
    QTest::newRow("all kinds of constraints") << "kinds" << true;
    QTest::newRow("plane") << "plane" << false;
}

void TestWendMpi::sameShapeForAnyProcesses() {
    QFETCH(QString, project);
    QFETCH(bool, solid);
    const QString extension = solid ? ".mesh" : ".obj";
    const auto arguments = [&](const QString& name) {
        return QStringList{"run",    project + ".wend", "--tolerance", "1e-3",
                           "--mesh", name + extension,  "--report",    name + ".json"};
    };
    const CliResult one =
        runCli(path(), arguments("one") + QStringList{"--solver", "multigrid", "--backend", "cpu"});
    QVERIFY2(one.code == 0, qPrintable(one.error));
    for (int processes : {1, 2, 4}) {
        const QString name = QString::number(processes);
        const CliResult many = runMany(processes, arguments(name));
        QVERIFY2(many.code == 0 && many.error == one.error, qPrintable(many.error));
        const std::string own = file(name + extension), other = file("one" + extension);
        const double difference = solid ? distance<3>(own, other) : distance<2>(own, other);
        QVERIFY2(difference < kAgreement, qPrintable(name + ": " + QString::number(difference)));
        const QJsonObject mine = report(name + ".json"), theirs = report("one.json");
        QCOMPARE(mine.keys(), theirs.keys());
        for (const char* same : {"vertices", "cells", "steps", "evaluations", "factorizations", "solver"})
            QCOMPARE(mine[same], theirs[same]);
        QCOMPARE(mine["device"].toString(), processes == 1 ? "1 process" : name + " processes");
        QVERIFY(std::abs(mine["energy"].toDouble() - theirs["energy"].toDouble()) <=
                1e-6 * theirs["energy"].toDouble());
    }
}

void TestWendMpi::errorsAreReportedOnce_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::newRow("missing") << QStringList{"run", "missing.wend"} << 3;
    QTest::newRow("bad") << QStringList{"run", "bad.wend", "--mesh", "bad.mesh"} << 3;
    QTest::newRow("output") << QStringList{"run", "twist.wend", "--mesh", "none/out.mesh"} << 3;
    QTest::newRow("direct") << QStringList{"run", "twist.wend", "--solver", "direct"} << 2;
    QTest::newRow("other command") << QStringList{"info", "twist.wend"} << 2;
}

void TestWendMpi::errorsAreReportedOnce() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    putProject(path(), "bad.wend", "'domain': {'mesh': 'no.mesh'}, 'handles': []");
    const CliResult many = runMany(4, arguments);
    QCOMPARE(many.code, code);
    QVERIFY2(many.error.startsWith("wend: ") && many.error.count('\n') == 1, qPrintable(many.error));
    if (code == 3) QCOMPARE(many.error, runCli(path(), arguments).error);
    QVERIFY(many.out.isEmpty());
}

/// The report has the last good time, and no other file is written.
void TestWendMpi::runsThatCannotBeCompleted() {
    putProject(path(), "fold.wend",
               "'domain': {'mesh': 'small.obj'}, 'handles': [{'name': 'wall', 'at': {'points': [[10, 0], "
               "[10, 1], [10, 2]]}}, {'name': 'ram', 'at': {'points': [[0, 0], [0, 1], [0, 2]]}, 'motion': "
               "[{'kind': 'translate', 'by': [12, 0], 'time': [0, 1]}]}]");
    const CliResult many = runMany(2, {"run", "fold.wend", "--mesh", "fold.obj", "--report", "fold.json"});
    QCOMPARE(many.code, 4);
    QVERIFY2(many.error.startsWith("wend: fold.wend: ") && many.error.count('\n') == 1,
             qPrintable(many.error));
    QVERIFY(!QFile::exists(path() + "/fold.obj"));
    const double time = report("fold.json")["time"].toDouble();
    QVERIFY(time > 0.7 && time < 10.0 / 12);
}

/// A request to stop that reaches the first process ends all of them.
void TestWendMpi::cancelledRuns() {
    QProcess process;
    process.setWorkingDirectory(path());
    process.setProcessEnvironment(environment());
    process.setReadChannel(QProcess::StandardError);
    process.start("mpirun",
                  launch(3) + QStringList{"run", "endless.wend", "--mesh", "long.mesh", "--progress"});
    QByteArray said;
    while (!said.contains("deforming") && process.waitForReadyRead(60000))
        said += process.readAllStandardError();
    QVERIFY2(said.contains("deforming"), said.constData());
    process.terminate();
    QVERIFY(process.waitForFinished(60000));
    QVERIFY(process.exitCode() != 0);
    QVERIFY(!QFile::exists(path() + "/long.mesh"));
}

void TestWendMpi::lostProcessesAreNamed_data() {
    QTest::addColumn<int>("rank");
    QTest::newRow("first") << 0;
    QTest::newRow("second") << 1;
    QTest::newRow("last") << 2;
}

/// A process is killed, as the kernel does when memory is short; the others do not wait for it forever.
void TestWendMpi::lostProcessesAreNamed() {
    QFETCH(int, rank);
    QProcess process;
    process.setWorkingDirectory(path());
    process.setProcessEnvironment(environment());
    process.setReadChannel(QProcess::StandardError);
    process.start("mpirun",
                  launch(3) + QStringList{"run", "endless.wend", "--mesh", "lost.mesh", "--progress"});
    QByteArray said;
    while (!said.contains("deforming") && process.waitForReadyRead(60000))
        said += process.readAllStandardError();
    QVERIFY2(said.contains("deforming"), said.constData());
    const qint64 lost = processOf(process.processId(), rank);
    QVERIFY(lost > 0);
    QCOMPARE(::kill(static_cast<pid_t>(lost), SIGKILL), 0);
    QVERIFY(process.waitForFinished(60000));
    said += process.readAllStandardError();
    QCOMPARE(process.exitCode(), 137);
    const QByteArray name = "process " + QByteArray::number(rank + 1) + " of 3 was lost";
    QCOMPARE(said.count("\nwend: "), 1);
    QVERIFY2(said.contains(name), said.constData());
    QVERIFY(!QFile::exists(path() + "/lost.mesh"));
}

void TestWendMpi::moreProcessesThanUnknowns() {
    putProject(
        path(), "tiny.wend",
        "'domain': {'mesh': 'small.obj'}, 'handles': [{'at': {'points': [[0, 0], [0, 1], [0, 2], [1, 0], "
        "[1, 1], [1, 2], [2, 0], [2, 1], [2, 2], [3, 0], [3, 1], [3, 2], [4, 0], [4, 1], [4, 2], [5, "
        "0], [5, 1], [5, 2], [6, 0], [6, 1], [6, 2], [7, 0], [7, 1], [7, 2], [8, 0], [8, 1], [8, 2]]}}, "
        "{'at': {'points': [[10, 0], [10, 1], [10, 2]]}, 'motion': [{'kind': 'translate', 'by': [0, "
        "1]}]}]");
    const CliResult one = runCli(
        path(), {"run", "tiny.wend", "--solver", "multigrid", "--backend", "cpu", "--mesh", "tiny1.obj"});
    QVERIFY2(one.code == 0, qPrintable(one.error));
    const CliResult many = runMany(4, {"run", "tiny.wend", "--mesh", "tiny4.obj"});
    QVERIFY2(many.code == 0, qPrintable(many.error));
    QVERIFY(distance<2>(file("tiny1.obj"), file("tiny4.obj")) < kAgreement);
}

QTEST_GUILESS_MAIN(TestWendMpi)
#include "test_wend_mpi.moc"
