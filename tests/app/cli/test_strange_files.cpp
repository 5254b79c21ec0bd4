// Inputs that are not regular files, or not of the kind they seem: one printable line and exit code 3,
// without delay.

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <QtTest>

#include "core/base/printable.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

namespace {

const std::string kStrip = "'domain': {'mesh': 'strip.obj'}";

/// One line of printable ASCII and UTF-8.
bool isOneLine(const QString& text) {
    const std::string line = text.chopped(1).toStdString();
    return text.startsWith("wend: ") && text.endsWith('\n') && printable(line) == line;
}

}  // namespace

class TestStrangeFiles : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void oddInputs_data();
    void oddInputs();
    void standardInput();
    void terminationEndsARead();
    void linkToItself();
    void noFolderForTemporaryFiles();
    void controlCharacters_data();
    void controlCharacters();
    void listedNames();

  private:
    QString path() const { return m_folder.path(); }
    QString file(const QString& name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
    int m_socket = -1;
};

void TestStrangeFiles::initTestCase() {
    writeMesh<2>(file("strip.obj").toStdString(), stripMesh(10, 2));
    put(path(), "tetrahedron.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    writeImage(file("disc.png").toStdString(), discPicture(64, 24));
    putProject(path(), "disc.wend", "'domain': {'image': 'disc.png', 'vertices': 100}");
}

/// Every kind of irregular file is tried × at every place where a file is named.
void TestStrangeFiles::oddInputs_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("project");
    QTest::addColumn<QStringList>("arguments");
    const QStringList run{"run", "p.wend", "--report", "r.json"};
    const auto project = [](const std::string& text) {
        return QString::fromStdString(json("{'format': 'wend', 'version': 1, " + text + "}"));
    };
    for (const char* kind : {"pipe", "socket", "device", "folder"}) {
        const auto row = [&](const char* place, const QString& name, const QString& text,
                             const QStringList& arguments) {
            QTest::addRow("%s as %s", kind, place) << kind << name << text << arguments;
        };
        row("project", "odd.wend", "", {"run", "odd.wend"});
        row("project to tell of", "odd.wend", "", {"info", "odd.wend"});
        row("picture", "odd.png", project("'domain': {'image': 'odd.png', 'vertices': 100}"), run);
        row("picture to tell of", "odd.png", "", {"info", "odd.png"});
        row("picture to mesh", "odd.png", "", {"mesh", "odd.png", "-o", "o.obj"});
        row("outline", "odd.json", "", {"mesh", "odd.json", "-o", "o.obj"});
        row("mesh", "odd.vtu", project("'domain': {'mesh': 'odd.vtu'}"), run);
        row("mesh to tell of", "odd.obj", "", {"info", "odd.obj"});
        row("cells file", "odd.json", project(kStrip + ", 'material': {'cells': 'odd.json'}"), run);
        row("texture", "odd.png", project("'domain': {'mesh': 'strip.obj', 'image': 'odd.png'}"),
            run + QStringList{"--image", "o.png"});
        row("surface", "odd.stl", project("'domain': {'surface': 'odd.stl'}, 'handles': []"), run);
        row("sizes file", "odd.txt",
            project("'domain': {'surface': 'tetrahedron.obj', 'sizes': [{'values': 'odd.txt'}]}"), run);
    }
}

void TestStrangeFiles::oddInputs() {
    QFETCH(QString, kind);
    QFETCH(QString, name);
    QFETCH(QString, project);
    QFETCH(QStringList, arguments);
    const QByteArray place = file(name).toLocal8Bit();
    if (kind == "pipe") QCOMPARE(mkfifo(place.constData(), 0600), 0);
    if (kind == "device") QCOMPARE(symlink("/dev/zero", place.constData()), 0);
    if (kind == "folder") QVERIFY(QDir(path()).mkdir(name));
    if (kind == "socket") {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        qstrncpy(address.sun_path, place.constData(), sizeof address.sun_path);
        m_socket = socket(AF_UNIX, SOCK_STREAM, 0);
        QCOMPARE(bind(m_socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    if (!project.isEmpty()) put(path(), "p.wend", project.toStdString());
    const CliResult result = runCli(path(), arguments);
    if (m_socket >= 0) close(m_socket);
    m_socket = -1;
    if (!QDir(path()).rmdir(name)) QFile::remove(file(name));
    QVERIFY2(result.code == 3 && !result.crashed, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(isOneLine(result.error), qPrintable(result.error));
    QVERIFY2(result.error.contains(name) && result.error.contains("is a " + kind), qPrintable(result.error));
}

/// A project may come from standard input, pipes included: `-` says so.
void TestStrangeFiles::standardInput() {
    const QString command = QString("cat disc.wend | exec \"%1\" run - --report r.json").arg(WEND_BINARY);
    const CliResult result =
        runCli(path(), {"-c", command}, QProcessEnvironment::systemEnvironment(), "/bin/bash");
    QVERIFY2(result.code == 0, qPrintable(result.error));
    QVERIFY(QFile::exists(file("r.json")));
}

void TestStrangeFiles::terminationEndsARead() {
    for (const char* signal : {"-TERM", "-INT"}) {
        QProcess process;
        process.setWorkingDirectory(path());
        process.start(WEND_BINARY, {"run", "-"});  // nobody writes
        QVERIFY(process.waitForStarted());
        QProcess::execute("kill", {signal, QString::number(process.processId())});
        QVERIFY(process.waitForFinished(60000));
        QVERIFY(process.exitStatus() == QProcess::CrashExit || process.exitCode() != 0);
    }
}

void TestStrangeFiles::linkToItself() {
    QVERIFY(QFile::link("loop.png", file("loop.png")));
    for (const QStringList& arguments :
         {QStringList{"run", "disc.wend", "--image", "loop.png"}, QStringList{"info", "loop.png"}}) {
        const CliResult result = runCli(path(), arguments);
        QVERIFY2(result.code == 3 && isOneLine(result.error), qPrintable(result.error));
        QVERIFY2(result.error.contains("loop.png: "), qPrintable(result.error));
    }
}

void TestStrangeFiles::noFolderForTemporaryFiles() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("TMPDIR", "/none/at/all");
    for (const char* output : {"-", "/dev/null"}) {
        const CliResult result = runCli(path(), {"run", "disc.wend", "--report", output}, environment);
        QVERIFY2(result.code == 3 && isOneLine(result.error), qPrintable(result.error));
        QVERIFY2(result.error.contains("/none/at/all"), qPrintable(result.error));
    }
}

void TestStrangeFiles::controlCharacters_data() {
    QTest::addColumn<QString>("project");
    QTest::addColumn<QString>("shown");
    const auto row = [](const char* name, const std::string& text, const char* shown) {
        QTest::newRow(name) << QString::fromStdString(json("{'format': 'wend', 'version': 1, " + text + "}"))
                            << shown;
    };
    row("key", kStrip + ", '\\u001b[2Jred\\u0007': 1, 'handles': [{'at': {'points': [[-50, 1]]}}]",
        "\\x1b[2Jred\\x07");
    row("name", kStrip + ", 'handles': [{'name': 'a\\u001b]0;b\\u0007', 'at': {'points': [[-50, 1]]}}]",
        "a\\x1b]0;b\\x07");
    row("C1", kStrip + ", 'handles': [{'name': 'a\\u009bb', 'at': {'points': [[-50, 1]]}}]", "a\\u{9b}b");
    row("turned writing", kStrip + ", 'handles': [{'name': 'a\\u202eb', 'at': {'points': [[-50, 1]]}}]",
        "a\\u{202e}b");
    row("path", "'domain': {'image': 'a\\u001bc.png'}", "a\\x1bc.png: does not exist");
    row("NUL in a path", "'domain': {'image': 'a\\u0000b.png', 'vertices': 9}",
        "a\\x00b.png: has a NUL character in its name");
    row("NUL in a mesh's path", "'domain': {'mesh': 'a\\u0000b.obj'}",
        "a\\x00b.obj: has a NUL character in its name");
    row("text where a number belongs", kStrip + ", 'time': {'end': 'a\\u007fb'}", "a\\x7fb");
    row("choice", kStrip + ", 'integration': {'method': 'a\\u0000b'}", "a\\x00b");
}

void TestStrangeFiles::controlCharacters() {
    QFETCH(QString, project);
    QFETCH(QString, shown);
    put(path(), "p.wend", project.toStdString());
    const CliResult result = runCli(path(), {"run", "p.wend", "--report", "r.json"});
    QCOMPARE(result.code, 3);
    for (const QString& line : result.error.split('\n', Qt::SkipEmptyParts))
        QVERIFY2(isOneLine(line + '\n'), qPrintable(line));
    QVERIFY2(result.error.contains(shown), qPrintable(result.error));
}

/// The output of `info` may reach a terminal, so names in it are printable.
void TestStrangeFiles::listedNames() {
    put(path(), "named.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 0 1 "
        "0\n"
        "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 3\nSCALARS he\x1b[31mat double\nLOOKUP_TABLE d\n1 2 "
        "3\n");
    const CliResult mesh = runCli(path(), {"info", "named.vtk"});
    QVERIFY2(mesh.code == 0 && mesh.out.contains("he\\x1b[31mat"), qPrintable(mesh.out + mesh.error));
    putProject(path(), "named.wend",
               kStrip + ", 'handles': [{'name': 'x\\u001b[31m', 'at': {'vertices': [0]}}]");
    const CliResult project = runCli(path(), {"info", "named.wend"});
    QVERIFY2(project.code == 0 && project.out.contains("x\\x1b[31m"), qPrintable(project.out));
    QVERIFY(!mesh.out.contains('\x1b') && !project.out.contains('\x1b'));
}

QTEST_GUILESS_MAIN(TestStrangeFiles)
#include "test_strange_files.moc"
