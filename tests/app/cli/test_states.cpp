// States that a run keeps: outputs made from them equal those of a single run to the byte, even after runs
// are killed or frames are divided among several.

#include <QtTest>
#include <csignal>

#include "tests/app/cli/cli_harness.h"
#include "tests/support/mesh_files.h"
#include "tests/support/pictures.h"

using namespace wend;

class TestStates : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void nothingIsComputedAgain_data();
    void nothingIsComputedAgain();
    void aTimeWithinIsThatOfAFrame();
    void killedRunsGoOn();
    void cancelledRunsKeepTheirStates();
    void cancellingIsAnswered_data();
    void cancellingIsAnswered();
    void shardsMakeTheWhole_data();
    void shardsMakeTheWhole();
    void farmNamesLostShards();
    void farmJobsMakeTheWhole_data();
    void farmJobsMakeTheWhole();
    void statesOfAnotherRunAreRefused_data();
    void statesOfAnotherRunAreRefused();
    void damagedStatesAreRefused();
    void wrongUsage_data();
    void wrongUsage();

  private:
    QString path() const { return m_folder.path(); }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0 && result.error.isEmpty(),
                 qPrintable(arguments.join(' ') + ": " + QString::number(result.code) + result.error));
    }
    QByteArray bytes(const QString& name) const {
        QFile file(path() + "/" + name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QJsonObject report(const QString& name) const { return QJsonDocument::fromJson(bytes(name)).object(); }
    QStringList filesLike(const QString& pattern) const { return QDir(path()).entryList({pattern}); }
    /// Starts the program, and waits for a file that it writes.
    void start(QProcess& process, const QStringList& arguments, const QString& awaited) const;

    QTemporaryDir m_folder;
};

namespace {

// Two motions with a pause between them, and one in parallel: there are breakpoints, and an interval without
// motion.
const char* const kBend =
    "'handles': [{'name': 'left', 'at': {'points': [[0, 0], [0, 1], [0, 2]]}},"
    "{'name': 'right', 'at': {'points': [[10, 0], [10, 1], [10, 2]]}, 'motion': [{'kind': 'rotate', "
    "'centre': [5, 1], 'angle': 1, 'time': [0, 0.4]}, {'kind': 'translate', 'by': [0, 2], 'time': [0.5, "
    "1]}]}]";
const char* const kLong =
    "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 2000}, 'integration': "
    "{'tolerance': 1e-8}, 'handles': [{'at': {'points': [[60, 100]]}}, {'at': {'points': [[140, 100]]}, "
    "'motion': [{'kind': 'rotate', 'centre': [100, 100], 'angle': 3, 'time': [0, 1]}]}]";

}  // namespace

void TestStates::initTestCase() {
    writeMesh<2>((path() + "/strip.obj").toStdString(), stripMesh(10, 2));
    writeMesh<2>((path() + "/other.obj").toStdString(), stripMesh(10, 3));
    writeMesh<3>((path() + "/bar.mesh").toStdString(), barMesh(6));
    writeImage((path() + "/disc.png").toStdString(), discPicture(200, 80));
    const std::string strip = "'domain': {'mesh': 'strip.obj'}, ";
    putProject(path(), "strip.wend", strip + kBend);
    putProject(path(), "settle.wend", strip + kBend + ", 'settle': [{'time': [1, 2]}], 'time': {'end': 2}");
    putProject(path(), "bar.wend",
               "'domain': {'mesh': 'bar.mesh'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1, "
               "-0.5], 'max': [3, 3, 0.5]}}}}, {'at': {'region': {'box': {'min': [-1, -1, 5.5], 'max': [3, "
               "3, 6.5]}}}, 'motion': [{'kind': 'rotate', 'centre': [1, 1, 6], 'axis': [0, 0, 1], 'angle': "
               "1.5707963267948966, 'time': [0, 1]}]}]");
    putProject(path(), "long.wend", kLong);
    putProject(path(), "endless.wend",
               "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 2000}, "
               "'integration': {'tolerance': 1e-6}, 'handles': [{'at': {'points': [[60, 100]]}}, {'at': "
               "{'points': [[140, 100]]}, " +
                   endlessMotion("[30, 40]", "[-30, -40]") + "}]");
    writeMesh<3>((path() + "/block.mesh").toStdString(), blockMesh(14, 14, 14));
    putProject(path(), "block.wend",
               "'domain': {'mesh': 'block.mesh'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1, "
               "-1], 'max': [99, 99, 0.5]}}}}, {'at': {'vertices': [3000]}, " +
                   endlessMotion("[0, 0, 1]", "[0, 0, -1]") + "}]");
}

void TestStates::nothingIsComputedAgain_data() {
    QTest::addColumn<QString>("project");
    QTest::addColumn<QStringList>("options");
    QTest::newRow("adams") << "strip" << QStringList{};
    QTest::newRow("dopri5") << "strip" << QStringList{"--method", "dopri5"};
    QTest::newRow("rk4") << "strip" << QStringList{"--method", "rk4", "--steps", "6"};
    QTest::newRow("midpoint") << "strip" << QStringList{"--method", "midpoint", "--steps", "7"};
    QTest::newRow("settling") << "settle" << QStringList{};
    QTest::newRow("solid") << "bar" << QStringList{"--threads", "2"};
}

/// Frames, the mesh at the end and its velocities are those of a run without states; only the field at the
/// end, which is exact, takes a factor.
void TestStates::nothingIsComputedAgain() {
    QFETCH(QString, project);
    QFETCH(QStringList, options);
    const auto outputs = [&](const QString& name) {
        return QStringList{"run",      project + ".wend", "--mesh",  name + ".vtu",
                           "--frames", name + "_##.vtk",  "--count", "13",
                           "--report", name + ".json"} +
               options;
    };
    QFile::remove(path() + "/s.states");
    succeed(outputs("plain"));
    succeed(outputs("keeping") + QStringList{"--states", "s.states"});
    succeed(outputs("from") + QStringList{"--from", "s.states"});
    for (const QString name : {"keeping", "from"}) {
        QCOMPARE(bytes(name + ".vtu"), bytes("plain.vtu"));
        QCOMPARE(filesLike(name + "_*.vtk").size(), 13);
        for (int k = 0; k < 13; ++k) {
            const QString file = QString("_%1.vtk").arg(k, 2, 10, QChar('0'));
            QVERIFY2(bytes(name + file) == bytes("plain" + file), qPrintable(name + file));
        }
    }
    const QJsonObject kept = report("keeping.json"), from = report("from.json");
    for (const char* same : {"steps", "rejected", "constraintError", "errorEstimate", "errors", "restEnergy",
                             "energy", "needs", "time", "evaluations"})
        QVERIFY2(kept[same] == from[same], same);
    QCOMPARE(from["factorizations"].toInt(), kept["factorizations"].toInt());
}

void TestStates::aTimeWithinIsThatOfAFrame() {
    succeed({"run", "strip.wend", "--states", "t.states", "--frames", "t_#.obj", "--count", "4"});
    succeed({"run", "strip.wend", "--from", "t.states", "--at", "0.3333333333333333", "--mesh", "third.obj"});
    QCOMPARE(bytes("third.obj"), bytes("t_1.obj"));
}

void TestStates::start(QProcess& process, const QStringList& arguments, const QString& awaited) const {
    process.setWorkingDirectory(path());
    process.setReadChannel(QProcess::StandardError);
    process.start(WEND_BINARY, arguments);
    const auto running = [&] { return process.state() != QProcess::NotRunning; };
    QVERIFY(process.waitForStarted(60000));
    while (!awaited.isEmpty() && running() && !QFile::exists(path() + "/" + awaited))
        process.waitForReadyRead(20);
}

/// Each run is killed as soon as it has added something; the last one ends by itself at some time. The result
/// is as if nothing had happened.
void TestStates::killedRunsGoOn() {
    const auto outputs = [](const QString& name) {
        return QStringList{"run",         "endless.wend", "--at",          "2",       "--mesh",
                           name + ".vtu", "--frames",     name + "_#.vtk", "--count", "9"};
    };
    succeed(outputs("calm"));
    QProcess first;
    start(first, {"run", "endless.wend", "--states", "k.states", "--progress"}, "k.states");
    first.kill();
    QVERIFY(first.waitForFinished(60000));
    QCOMPARE(first.exitStatus(), QProcess::CrashExit);
    const QStringList kept{"--from", "k.states", "--states", "k.states"};
    for (int k = 0; k < 2; ++k) {
        const qint64 before = bytes("k.states").size();
        QProcess next;
        start(next, QStringList{"run", "endless.wend", "--progress"} + kept, {});
        while (next.state() != QProcess::NotRunning && QFileInfo(path() + "/k.states").size() <= before)
            next.waitForReadyRead(20);
        next.kill();
        QVERIFY(next.waitForFinished(60000));
        QCOMPARE(next.exitStatus(), QProcess::CrashExit);
    }
    succeed(outputs("killed") + kept);
    QCOMPARE(bytes("killed.vtu"), bytes("calm.vtu"));
    for (int k = 0; k < 9; ++k)
        QCOMPARE(bytes(QString("killed_%1.vtk").arg(k)), bytes(QString("calm_%1.vtk").arg(k)));
    // A copy of the states gives the same result.
    succeed({"run", "endless.wend", "--at", "2", "--from", "k.states", "--states", "copy.states", "--mesh",
             "copied.vtu"});
    QCOMPARE(bytes("copied.vtu"), bytes("calm.vtu"));
    QCOMPARE(bytes("copy.states"), bytes("k.states"));
}

void TestStates::cancelledRunsKeepTheirStates() {
    succeed({"run", "endless.wend", "--at", "2", "--mesh", "whole.obj"});
    QProcess process;
    start(process, {"run", "endless.wend", "--states", "c.states", "--mesh", "c.obj", "--progress"},
          "c.states");
    process.terminate();
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 4);
    const QByteArray said = process.readAllStandardError().trimmed();
    QVERIFY2(said.contains("cancelled; c.states has the states up to time "), said);
    QVERIFY(!QFile::exists(path() + "/c.obj"));
    QVERIFY(QDir(path()).entryList({".wend-*"}, QDir::AllEntries | QDir::Hidden).isEmpty());
    succeed({"run", "endless.wend", "--at", "2", "--from", "c.states", "--mesh", "c.obj"});
    QCOMPARE(bytes("c.obj"), bytes("whole.obj"));
}

void TestStates::cancellingIsAnswered_data() {
    QTest::addColumn<int>("milliseconds");
    for (const int milliseconds : {0, 150, 600}) QTest::addRow("%d", milliseconds) << milliseconds;
}

/// A run that is cancelled at any point prints its line and leaves nothing behind.
void TestStates::cancellingIsAnswered() {
    QFETCH(int, milliseconds);
    QProcess process;
    start(process, {"run", "block.wend", "--mesh", "block.vtu", "--frames", "block_#.vtk", "--count", "3"},
          {});
    process.waitForFinished(milliseconds);
    process.terminate();
    QVERIFY(process.waitForFinished(60000));
    const QByteArray said = process.readAllStandardError();
    const bool isEarly = process.exitStatus() == QProcess::CrashExit;  // before it takes signals
    QVERIFY2(isEarly || (process.exitCode() == 4 && said == "wend: cancelled; nothing was written\n"), said);
    QVERIFY(filesLike("block*.vt?").isEmpty());
    QVERIFY(isEarly || QDir(path()).entryList({".wend-*"}, QDir::AllEntries | QDir::Hidden).isEmpty());
}

void TestStates::shardsMakeTheWhole_data() {
    QTest::addColumn<QString>("project");
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QStringList>("options");
    QTest::newRow("pictures") << "long"
                              << "png" << QStringList{"--tolerance", "1e-4"};
    QTest::newRow("fitting canvas") << "long"
                                    << "png" << QStringList{"--tolerance", "1e-4", "--canvas", "fit"};
    QTest::newRow("meshes") << "bar"
                            << "vtu" << QStringList{};
}

/// There are more shards than frames in one case, so that some are empty; each shard runs in a process of its
/// own, at the same time. A lost one is made again.
void TestStates::shardsMakeTheWhole() {
    QFETCH(QString, project);
    QFETCH(QString, extension);
    QFETCH(QStringList, options);
    QFile::remove(path() + "/f.states");
    for (const QString& file : filesLike("one_*") + filesLike("part_*")) QFile::remove(path() + "/" + file);
    const QStringList common = QStringList{"run", project + ".wend", "--count", "7"} + options;
    succeed(common + QStringList{"--frames", "one_##." + extension, "--states", "f.states"});
    const auto shard = [&](int index, int count) {
        return common + QStringList{"--from",   "f.states",
                                    "--frames", "part_##." + extension,
                                    "--shard",  QString("%1/%2").arg(index).arg(count)};
    };
    for (const int count : {3, 9}) {
        std::vector<std::unique_ptr<QProcess>> processes;
        for (int k = 1; k <= count; ++k) {
            processes.push_back(std::make_unique<QProcess>());
            start(*processes.back(), shard(k, count), {});
        }
        for (const auto& process : processes) {
            QVERIFY(process->waitForFinished(60000));
            QVERIFY2(process->exitCode() == 0, process->readAllStandardError());
        }
        const QStringList whole = filesLike("one_*"), parts = filesLike("part_*");
        QCOMPARE(parts.size(), whole.size());
        for (int k = 0; k < whole.size(); ++k)
            QCOMPARE(bytes(parts[k]), bytes(whole[k]).replace("one_", "part_"));
        for (const QString& file : parts) QFile::remove(path() + "/" + file);
    }
    succeed(shard(2, 3));
    QCOMPARE(filesLike("part_*"), (QStringList{"part_02." + extension, "part_03." + extension}));
}

/// The farm script starts a job for each shard and lists those that are missing in the end.
void TestStates::farmNamesLostShards() {
    const auto farm = [&](const QStringList& arguments) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("WEND", WEND_BINARY);
        return runCli(path(), arguments, environment,
                      QStringLiteral(WEND_SOURCE_DIR "/scripts/farm/frames.sh"));
    };
    succeed({"run", "strip.wend", "--states", "g.states", "--frames", "alone_##.obj", "--count", "10"});
    const QStringList job{"strip.wend", "g.states", "farm_##.obj", "10", "4"};
    for (const QString shard : {"1", "2", "4"}) QCOMPARE(farm(job + QStringList{shard}).code, 0);
    CliResult missing = farm(job + QStringList{"missing"});
    QCOMPARE(missing.code, 1);
    QCOMPARE(missing.out, QString("shard 3 of 4: frames 5 to 6 are missing\n"));
    QCOMPARE(farm(job + QStringList{"3"}).code, 0);
    missing = farm(job + QStringList{"missing"});
    QVERIFY2(missing.code == 0 && missing.out.isEmpty(), qPrintable(missing.out + missing.error));
    for (int k = 0; k < 10; ++k)
        QCOMPARE(bytes(QString("farm_0%1.obj").arg(k)), bytes(QString("alone_0%1.obj").arg(k)));
    // The ranks of MPI are processes of their own.
    if (QStandardPaths::findExecutable("mpirun").isEmpty()) return;
    for (const QString& file : filesLike("farm_*")) QFile::remove(path() + "/" + file);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("WEND", WEND_BINARY);
    const QStringList ranks{"-n", "2", "--allow-run-as-root", "--oversubscribe",
                            QStringLiteral(WEND_SOURCE_DIR "/scripts/farm/frames.sh")};
    const CliResult result =
        runCli(path(), ranks + job.mid(0, 4) + QStringList{"2", "rank"}, environment, "mpirun");
    QVERIFY2(result.code == 0, qPrintable(result.out + result.error));
    for (int k = 0; k < 10; ++k)
        QCOMPARE(bytes(QString("farm_0%1.obj").arg(k)), bytes(QString("alone_0%1.obj").arg(k)));
}

void TestStates::farmJobsMakeTheWhole_data() {
    QTest::addColumn<QStringList>("start");
    const QString scripts = QStringLiteral(WEND_SOURCE_DIR "/scripts/farm/");
    const QString node = QStringLiteral(WEND_SOURCE_DIR "/tests/support/slurm_node.sh");
    QTest::newRow("on this machine") << QStringList{scripts + "parallel.sh"};
    QTest::newRow("Slurm") << QStringList{node, m_folder.filePath("slurm"), scripts + "slurm.sh"};
}

/// A Slurm node with its controller is started for this test. All names have blanks; options reach `wend
/// run`.
void TestStates::farmJobsMakeTheWhole() {
    QFETCH(QStringList, start);
    const QString folder = m_folder.filePath("a folder");
    QDir(folder).removeRecursively();
    QVERIFY(QDir().mkpath(folder) && QFile::copy(path() + "/long.wend", folder + "/a strip.wend") &&
            QFile::copy(path() + "/disc.png", folder + "/disc.png"));
    const QStringList canvas{"--canvas", "fit"};
    const CliResult whole = runCli(
        folder, QStringList{"run", "a strip.wend", "--frames", "whole ##.png", "--count", "7"} + canvas);
    QVERIFY2(whole.code == 0, qPrintable(whole.error));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("WEND", WEND_BINARY);
    const CliResult jobs =
        runCli(folder, start.mid(1) + QStringList{"a strip.wend", "part ##.png", "7", "3"} + canvas,
               environment, start[0]);
    if (jobs.code == 77) QSKIP("Slurm cannot be started here");
    QVERIFY2(jobs.code == 0, qPrintable(jobs.out + jobs.error));
    const auto read = [&](const QString& name) {
        QFile file(folder + "/" + name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("not there");
    };
    for (int k = 0; k < 7; ++k)
        QCOMPARE(read(QString("part 0%1.png").arg(k)), read(QString("whole 0%1.png").arg(k)));
    if (start.size() > 1) QCOMPARE(read("wend-missing.txt"), QByteArray());
}

void TestStates::statesOfAnotherRunAreRefused_data() {
    QTest::addColumn<QString>("project");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("why");
    const QString other = "holds states of another run: its ";
    QTest::newRow("settings") << "strip" << QStringList{"--tolerance", "1e-5"} << other + "settings differ";
    QTest::newRow("material") << "strip" << QStringList{"--phi", "conf"} << other + "material differs";
    QTest::newRow("mesh") << "mesh" << QStringList{} << other + "mesh differs";
    QTest::newRow("handles") << "handles" << QStringList{} << other + "handles differ";
    QTest::newRow("dimension") << "bar" << QStringList{} << "holds states of a shape in the plane";
    QTest::newRow("longer") << "strip" << QStringList{"--at", "1.5"}
                            << "holds the states of a run to time 1 only";
    QTest::newRow("no states") << "plain" << QStringList{} << "is no states file of Wend";
    QTest::newRow("missing") << "missing" << QStringList{} << "does not exist";
}

void TestStates::statesOfAnotherRunAreRefused() {
    QFETCH(QString, project);
    QFETCH(QStringList, options);
    QFETCH(QString, why);
    succeed({"run", "strip.wend", "--states", "r.states"});
    std::string bend = kBend;
    putProject(path(), "mesh.wend", "'domain': {'mesh': 'other.obj'}, " + bend);
    bend.replace(bend.find("'angle': 1"), 10, "'angle': 2");
    putProject(path(), "handles.wend", "'domain': {'mesh': 'strip.obj'}, " + bend);
    QString from = "r.states";
    if (project == "plain") project = "strip", from = "disc.png";
    if (project == "missing") project = "strip", from = "none.states";
    const QByteArray before = bytes(from);
    const CliResult result =
        run(QStringList{"run", project + ".wend", "--from", from, "--states", from, "--mesh", "no.vtu"} +
            options);
    QCOMPARE(result.code, 3);
    const QString line = result.error.trimmed().section('\n', -1);  // a warning may come first
    QVERIFY2(line.startsWith("wend: " + from + ": ") && line.contains(why), qPrintable(result.error));
    QCOMPARE(bytes(from), before);
    QVERIFY(!QFile::exists(path() + "/no.vtu"));
}

/// A file truncated at any byte has everything before its last checkpoint, or is refused; a changed byte is
/// detected where it matters.
void TestStates::damagedStatesAreRefused() {
    succeed({"run", "strip.wend", "--states", "d.states", "--mesh", "right.vtu", "--fields", "none"});
    const QByteArray whole = bytes("d.states");
    const auto attempt = [&](const QByteArray& damaged) {
        put(path(), "bad.states", damaged.toStdString());
        QFile::remove(path() + "/bad.vtu");
        const CliResult result =
            run({"run", "strip.wend", "--from", "bad.states", "--mesh", "bad.vtu", "--fields", "none"});
        QVERIFY(!result.crashed);
        if (result.code == 0) {
            QCOMPARE(bytes("bad.vtu"), bytes("right.vtu"));
        } else {
            QVERIFY2(result.code == 3 && result.error.startsWith("wend: bad.states: ") &&
                         result.error.count('\n') == 1,
                     qPrintable(result.error));
        }
    };
    const qsizetype step = whole.size() / 8;
    for (qsizetype size = 0; size < whole.size(); size += step) attempt(whole.left(size));
    int refused = 0;
    for (qsizetype at = 5; at < whole.size(); at += step) {
        QByteArray damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
        attempt(damaged);
        refused += QFile::exists(path() + "/bad.vtu") ? 0 : 1;
    }
    QVERIFY(refused > 5);
    attempt(whole);
    QVERIFY(QFile::exists(path() + "/bad.vtu"));
}

void TestStates::wrongUsage_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("no states") << QStringList{"--frames", "u_#.obj", "--shard", "1/2"};
    QTest::newRow("no frames") << QStringList{"--from", "u.states", "--shard", "1/2"};
    QTest::newRow("more than frames")
        << QStringList{"--from", "u.states", "--frames", "u_#.obj", "--shard", "1/2", "--report", "-"};
    for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/0"})
        QTest::newRow(shard) << QStringList{"--from", "u.states", "--frames", "u_#.obj", "--shard", shard};
    QTest::newRow("standard output") << QStringList{"--states", "-"};
    QTest::newRow("over the project") << QStringList{"--states", "strip.wend"};
    QTest::newRow("over other states")
        << QStringList{"--from", "u.states", "--mesh", "u.states.obj", "--states", "u.states.obj"};
}

void TestStates::wrongUsage() {
    QFETCH(QStringList, options);
    const CliResult result = run(QStringList{"run", "strip.wend"} + options);
    QCOMPARE(result.code, 2);
    QVERIFY2(result.error.startsWith("wend: ") && result.error.count('\n') == 1, qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestStates)
#include "test_states.moc"
