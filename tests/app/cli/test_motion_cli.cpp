// Handles moved by files: fields of displacements and tables of poses.

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>

#include "app/project/file/motion_files.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

class TestMotionCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void fieldsOfFiles_data();
    void fieldsOfFiles();
    void fieldInThePlane();
    void poses_data();
    void poses();
    void posesInThePlane();
    void times();
    void savedAsRead();
    void inputsAreNotReplaced();
    void badFiles_data();
    void badFiles();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0 && result.error.isEmpty(),
                 qPrintable(QString::number(result.code) + result.error));
    }
    void putBar(const char* name, const std::string& motion) const {
        putProject(
            path(), name,
            "'domain': {'mesh': 'bar.mesh'}, 'handles': [{'name': 'foot', 'at': {'region': {'box': {'min': "
            "[-1, -1, -0.5], 'max': [3, 3, 0.5]}}}}, {'name': 'head', 'at': {'region': {'box': {'min': "
            "[-1, -1, 5.5], 'max': [3, 3, 6.5]}}}, 'motion': [" +
                motion + "]}]");
    }
    Points3 pointsIn(const char* name) const { return pointsOf(*sharedMeshFile(file(name))); }

    QTemporaryDir m_folder;
    SimplicialMesh<3> m_bar = barMesh(6);
};

namespace {

Vec3 displacementAt(const Vec3& p) {
    return Vec3(0.2 * p.y(), 0.1 * p.x() * p.y(), 0.3 + 0.05 * p.x());
}

std::string digits(double x) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << x;
    return out.str();
}

}  // namespace

void TestMotionCli::initTestCase() {
    writeMesh<3>(file("bar.mesh"), m_bar);
    writeMesh<2>(file("strip.obj"), stripMesh(10, 2));
    MeshFile mesh = toMeshFile<3>(m_bar);
    MeshField field{"u", false, 3, {}}, other{"w", false, 3, {}};
    std::string table = "id,dx,dy,dz\n", named = "Point ID;u:0;u:1;u:2\n";
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        const Vec3 u = displacementAt(m_bar.points.col(v));
        field.values.insert(field.values.end(), {u[0], u[1], u[2]});
        other.values.insert(other.values.end(), {0, 0, 0});
        const std::string id = std::to_string(v);
        if (m_bar.points(2, v) > 5) {
            table += id + "," + digits(u[0]) + "," + digits(u[1]) + "," + digits(u[2]) + "\n";
            named += id + ";" + digits(u[0]) + ";" + digits(u[1]) + ";" + digits(u[2]) + "\n";
        }
    }
    put(path(), "u.csv", table);
    put(path(), "named.txt", "# from elsewhere\n" + named);
    mesh.fields = {field};
    for (const char* name : {"one.vtu", "one.vtk", "one.msh"}) writeMeshFile(file(name), mesh);
    mesh.fields = {other, field};
    for (const char* name : {"two.vtu", "two.vtk", "two.msh"}) writeMeshFile(file(name), mesh);
}

void TestMotionCli::fieldsOfFiles_data() {
    QTest::addColumn<QString>("source");
    for (const char* name : {"one.vtu", "one.vtk", "one.msh"})
        QTest::newRow(name) << QString("'file': '%1'").arg(name);
    for (const char* name : {"two.vtu", "two.vtk", "two.msh"})
        QTest::newRow(name) << QString("'file': '%1', 'array': 'u'").arg(name);
    QTest::newRow("csv") << "'file': 'u.csv'";
    QTest::newRow("named columns") << "'file': 'named.txt', 'array': 'u'";
}

/// Every held vertex ends where the field puts it, up to rounding, and is half way there at half the time.
void TestMotionCli::fieldsOfFiles() {
    QFETCH(QString, source);
    putBar("field.wend", "{'kind': 'field', " + source.toStdString() + ", 'time': [0, 2], 'ease': 'inOut'}");
    succeed({"run", "field.wend", "--mesh", "end.vtu", "--report", "end.json"});
    succeed({"run", "field.wend", "--mesh", "half.vtu", "--at", "0.5"});
    const Points3 end = pointsIn("end.vtu"), half = pointsIn("half.vtu");
    const double size = 7;
    const double share = 0.25 * 0.25 * (3 - 2 * 0.25);
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        const Vec3 rest = m_bar.points.col(v);
        if (rest.z() < 0.5) QVERIFY(end.col(v) == rest);
        if (rest.z() < 5.5) continue;
        QVERIFY((end.col(v) - rest - displacementAt(rest)).norm() <= 1e-12 * size);
        QVERIFY((half.col(v) - rest - share * displacementAt(rest)).norm() <= 1e-12 * size);
    }
    const auto report = QJsonDocument::fromJson(QByteArray::fromStdString(readTextFile(file("end.json"))));
    QCOMPARE(report["time"].toDouble(), 2.0);
    QVERIFY(report["constraintError"].toDouble() <= 1e-12);
}

void TestMotionCli::fieldInThePlane() {
    put(path(), "flat.csv", "dx,dy,vertex\n0.5,0.25,10\n0.5,0.5,21\n1,0,32\n");
    putProject(
        path(), "flat.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'vertices': [0, 11, 22]}}, {'at': {'vertices': "
        "[32, 10, 21]}, 'motion': [{'kind': 'field', 'file': 'flat.csv'}, {'kind': 'field', 'vertices': [10, "
        "21, 32], 'by': [[0, 1], [0, 1], [0, 2]], 'time': [1, 2]}]}]");
    succeed({"run", "flat.wend", "--mesh", "flat.obj"});
    const Points3 end = pointsIn("flat.obj");
    QVERIFY((end.col(10) - Vec3(10.5, 1.25, 0)).norm() < 1e-12);
    QVERIFY((end.col(21) - Vec3(10.5, 2.5, 0)).norm() < 1e-12);
    QVERIFY((end.col(32) - Vec3(11, 4, 0)).norm() < 1e-12);
}

void TestMotionCli::poses_data() {
    QTest::addColumn<QString>("table");
    // The head rises by 1 and rotates by 0.6 about z, then tilts by 0.4 about x.
    const double s = std::sin(0.3), c = std::cos(0.3);
    const Eigen::Quaterniond last = Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::Quaterniond(c, 0, 0, s);
    const Eigen::AngleAxisd turn(last);
    const Vec3 vector = turn.angle() * turn.axis();
    const std::string rotation = digits(vector[0]) + "," + digits(vector[1]) + "," + digits(vector[2]);
    const std::string xyzw =
        digits(last.x()) + " " + digits(last.y()) + " " + digits(last.z()) + " " + digits(last.w());
    QTest::newRow("rotation vectors")
        << QString::fromStdString("0,1,1,6,0,0,0\n1,1,1,7,0,0,0.6\n3,1,1.5,7," + rotation + "\n");
    QTest::newRow("names") << QString::fromStdString(
        "Time,rx,ry,rz,x,y,z\n0,0,0,0,1,1,6\n1,0,0,0.6,1,1,7\n3," + rotation + ",1,1.5,7\n");
    QTest::newRow("quaternions") << QString::fromStdString("0 1 1 6 0 0 0 1\n1 1 1 7 0 0 " + digits(s) + " " +
                                                           digits(c) + "\n3 1 1.5 7 " + xyzw + "\n");
    QTest::newRow("named quaternions, one of other sign") << QString::fromStdString(
        "time;x;y;z;qw;qx;qy;qz\r\n0;1;1;6;1;0;0;0\r\n1;1;1;7;" + digits(-c) + ";0;0;" + digits(-s) +
        "\r\n3;1;1.5;7;" + digits(last.w()) + ";" + digits(last.x()) + ";" + digits(last.y()) + ";" +
        digits(last.z()) + "\r\n");
}

void TestMotionCli::poses() {
    QFETCH(QString, table);
    put(path(), "poses.csv", table.toStdString());
    putBar("poses.wend", "{'kind': 'poses', 'file': 'poses.csv'}");
    succeed({"run", "poses.wend", "--mesh", "one.obj", "--mesh", "one.vtu", "--at", "1"});
    succeed({"run", "poses.wend", "--mesh", "mid.vtu", "--at", "0.5"});
    succeed({"run", "poses.wend", "--mesh", "end.vtu"});
    const Points3 middle = pointsIn("mid.vtu"), first = pointsIn("one.vtu"), end = pointsIn("end.vtu");
    const Mat3 turn = Eigen::AngleAxisd(0.6, Vec3::UnitZ()).toRotationMatrix(),
               half = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix(),
               tilt = Eigen::AngleAxisd(0.4, Vec3::UnitX()).toRotationMatrix();
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(2, v) < 5.5) continue;
        const Vec3 inBody = m_bar.points.col(v) - Vec3(1, 1, 6);
        QVERIFY((middle.col(v) - half * inBody - Vec3(1, 1, 6.5)).norm() < 7e-12);
        QVERIFY((first.col(v) - turn * inBody - Vec3(1, 1, 7)).norm() < 7e-12);
        QVERIFY((end.col(v) - tilt * turn * inBody - Vec3(1, 1.5, 7)).norm() < 7e-12);
    }
}

/// A handle in the plane rotates by a whole turn relative to its first pose, in its own time and with an
/// ease.
void TestMotionCli::posesInThePlane() {
    put(path(), "turn.csv", "time,x,y,angle\n5,0,1,0.5\n6,0,1,3.5\n8,0,1,6.7831853071795862\n");
    putProject(
        path(), "turn.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1], 'max': "
        "[11, 3]}}}, 'motion': [{'kind': 'poses', 'file': 'turn.csv', 'time': [0, 3], 'ease': 'in'}]}]");
    succeed({"run", "turn.wend", "--mesh", "turned.obj"});
    const Points3 rest = pointsIn("strip.obj"), whole = pointsIn("turned.obj");
    QVERIFY((whole - rest).norm() < 1e-11);
    const double u = 4.0 / 9;  // of the file's times at time 2: 5 + 4/3
    const double angle = 3 + (5 + 3 * u - 6) / 2 * (6.7831853071795862 - 3.5);
    succeed({"run", "turn.wend", "--mesh", "part.obj", "--at", "2"});
    const Vec2 from = rest.col(10).head<2>() - Vec2(0, 1);
    const Vec2 expected = Eigen::Rotation2Dd(angle) * from + Vec2(0, 1);
    QVERIFY((pointsIn("part.obj").col(10).head<2>() - expected).norm() < 1e-11);
}

/// Without `time` the motion has the times of its file, and the run ends with the last of them.
void TestMotionCli::times() {
    put(path(), "late.csv", "2,0,0,0\n4,1,0,0\n");
    const std::string head = "{'at': {'vertices': [0]}, 'motion': [", tail = "]}]";
    const auto project = [&](const std::string& motions) {
        putProject(path(), "late.wend",
                   "'domain': {'mesh': 'strip.obj'}, 'handles': [" + head + motions + tail);
        return readProject(file("late.wend")).project;
    };
    QCOMPARE(endOf(*project("{'kind': 'poses', 'file': 'late.csv'}")), 4.0);
    QCOMPARE(endOf(*project("{'kind': 'poses', 'file': 'late.csv', 'time': [0, 0.5]}")), 0.5);
    QCOMPARE(endOf(*project("{'kind': 'translate', 'by': [1, 1], 'time': [0, 2]}, {'kind': 'poses', 'file': "
                            "'late.csv'}, {'kind': 'poses', 'poses': [[7, 0, 0, 0], [9, 1, 1, 1]]}")),
             9.0);
    project("{'kind': 'translate', 'by': [1, 1], 'time': [0, 3]}, {'kind': 'poses', 'file': 'late.csv'}");
    const CliResult overlap = run({"run", "late.wend", "--mesh", "x.obj"});
    QCOMPARE(overlap.code, 3);
    QVERIFY2(overlap.error.contains("motion 2 begins before motion 1 has ended"), qPrintable(overlap.error));
}

void TestMotionCli::savedAsRead() {
    put(path(), "late.csv", "2,0,0,0,0,0,0\n4,1,0,0,0,0,1\n");
    putBar(
        "saved.wend",
        "{'kind': 'field', 'file': 'u.csv', 'time': [0, 1]}, {'kind': 'poses', 'file': 'late.csv', 'speed': "
        "2}, "
        "{'kind': 'field', 'file': 'two.vtu', 'array': 'u', 'time': [4, 5], 'ease': 'in'}, {'kind': 'poses', "
        "'poses': [[5, 0, 0, 0, 0, 0, 1], [6, 1, 2, 3, 0, 0, 0.1]]}");
    const std::string again = file("again.wend"), third = file("third.wend");
    const LoadedProject loaded = readProject(file("saved.wend"));
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    writeProject(again, *loaded.project);
    writeProject(third, *readProject(again).project);
    QCOMPARE(readTextFile(third), readTextFile(again));
    for (const char* piece : {"\"file\": \"u.csv\"", "\"file\": \"late.csv\"", "\"array\": \"u\"",
                              "[6, 1, 2, 3, 0, 0, 0.1]", "\"speed\": 2"})
        QVERIFY2(readTextFile(again).find(piece) != std::string::npos, piece);
    // In another folder the files are named from there.
    QDir(path()).mkdir("below");
    writeProject(file("below/moved.wend"), *loaded.project, path().toStdString());
    QVERIFY(readTextFile(file("below/moved.wend")).find("\"../u.csv\"") != std::string::npos);
    QCOMPARE(readProject(file("below/moved.wend")).project->end, 6.0);
}

void TestMotionCli::inputsAreNotReplaced() {
    putBar("own.wend", "{'kind': 'field', 'file': 'one.vtu', 'array': 'displacement'}");
    const CliResult result = run({"run", "own.wend", "--mesh", "./one.vtu"});
    QVERIFY2(result.code == 2, qPrintable(result.error));
    QVERIFY2(result.error.contains("would replace one.vtu, which is read here"), qPrintable(result.error));
}

void TestMotionCli::badFiles_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("motion");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* text, const char* motion, const char* message) {
        QTest::newRow(name) << text << motion << message;
    };
    const char *field = "{'kind': 'field', 'file': 'bad.csv'}",
               *poses = "{'kind': 'poses', 'file': 'bad.csv'}";
    row("no file", "", "{'kind': 'field', 'file': 'nowhere.vtu'}",
        "handles[1].motion[0].file: nowhere.vtu: does not exist");
    row("no array", "", "{'kind': 'field', 'file': 'two.vtu'}",
        "has several fields (w, u): `array` has to name one");
    row("wrong array", "", "{'kind': 'field', 'file': 'two.vtu', 'array': 'v'}", "has no field \"v\"");
    row("no field", "", "{'kind': 'field', 'file': 'bar.mesh'}", "has no field of vectors per vertex");
    row("no header", "0,1,2,3\n", field, "needs a header with the columns id, dx, dy, dz");
    row("no such vertex", "id,dx,dy,dz\n999,1,1,1\n", field, "line 2: there is no vertex 999");
    row("half an id", "id,dx,dy,dz\n0.5,1,1,1\n", field, "line 2: the id is not a vertex number");
    row("twice", "id,dx,dy,dz\n4,1,1,1\n3,1,1,1\n4,2,2,2\n", field, "has two rows for vertex 4");
    row("no number", "id,dx,dy,dz\n4,1,x,1\n", field, "line 2: \"x\" is not a number");
    row("short row", "id,dx,dy,dz\n4,1,1\n", field, "line 2: has 3 columns instead of 4");
    row("a vertex is missing", "id,dx,dy,dz\n4,1,1,1\n", field, "there is no displacement for vertex");
    row("empty", "\n\n", poses, "has no row of numbers");
    row("columns", "0,1,2\n1,2,3\n", poses, "has 3 columns where poses need time, x, y, z, and rx, ry, rz");
    row("one pose", "0,1,2,3,0,0,0\n", poses, "has 1 pose, at least 2 are needed");
    row("time stands", "0,1,2,3,0,0,0\n0,1,2,3,0,0,1\n", poses, "line 2: the time does not come after");
    row("quaternion", "0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0,2\n", poses,
        "line 2: the quaternion is not of length 1");
    row("names", "time,x,y,z\n0,1,2,3\n", poses, "needs the columns time, x, y, z, and rx");
    row("whole turn", "0,0,0,0,0,0,0\n1,1,0,0,0,0,6.283185307179586\n", poses,
        "pose 1: a whole turn cannot be a screw motion with a shift across its axis");
    row("no source", "", "{'kind': 'poses'}", "has none of the known kinds: file, poses");
    row("misspelt", "", "{'kind': 'field', 'fiel': 'u.csv'}", "`fiel` is not known; `file`?");
    row("uneven", "", "{'kind': 'field', 'vertices': [1, 2], 'by': [[0, 0, 1]]}",
        "has 1 displacements for 2 vertices");
}

void TestMotionCli::badFiles() {
    QFETCH(QString, text);
    QFETCH(QString, motion);
    QFETCH(QString, message);
    put(path(), "bad.csv", text.toStdString());
    putBar("bad.wend", motion.toStdString());
    const CliResult result = run({"run", "bad.wend", "--mesh", "bad.vtu"});
    QVERIFY2(result.code == 3, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(result.error.startsWith("wend: bad.wend: ") && result.error.count('\n') == 1,
             qPrintable(result.error));
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestMotionCli)
#include "test_motion_cli.moc"
