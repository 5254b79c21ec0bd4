// Handles that hold their vertices in some directions only.

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>

#include "app/document/file/project_reader.h"
#include "app/document/file/project_writer.h"
#include "app/document/project.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

namespace {

constexpr const char* kFoot =
    "{'name': 'foot', 'at': {'region': {'box': {'min': [-9, -9, -0.5], 'max': [9, 9, 0.5]}}}}";
constexpr const char* kHead = "'region': {'box': {'min': [-9, -9, 5.5], 'max': [9, 9, 6.5]}}";

/// The mesh with its image in the plane x = 0, where both have the same vertices.
SimplicialMesh<3> withImage(const SimplicialMesh<3>& half) {
    SimplicialMesh<3> whole = half;
    std::vector<int> image(static_cast<std::size_t>(half.vertexCount()));
    int count = half.vertexCount();
    for (int v = 0; v < half.vertexCount(); ++v) image[v] = half.points(0, v) == 0 ? v : count++;
    whole.points.conservativeResize(Eigen::NoChange, count);
    for (int v = 0; v < half.vertexCount(); ++v) {
        whole.points.col(image[v]) = half.points.col(v);
        whole.points(0, image[v]) = -half.points(0, v);
        if (image[v] == v) whole.points(0, v) = 0;
    }
    for (Cell<3> cell : half.cells) {
        for (int& v : cell) v = image[v];
        std::swap(cell[2], cell[3]);
        whole.cells.push_back(cell);
    }
    return whole;
}

}  // namespace

class TestHoldCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void axes();
    void normals_data();
    void normals();
    void halfAndWhole();
    void quarterAndWhole();
    void inThePlane();
    void motionsFollowEachOther();
    void savedAsRead();
    void bad_data();
    void bad();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    /// The deformed points of a project with these handles, and the report.
    Points<3> bent(const std::string& domain, const std::string& handles, const std::string& more = "") {
        putProject(path(), "bend.wend",
                   "'domain': {'mesh': '" + domain + "'}, 'handles': [" + handles + "]" + more);
        const CliResult result = run({"run", "bend.wend", "--mesh", "bent.vtu", "--report", "bent.json"});
        if (result.code != 0) qWarning("%s", qPrintable(result.error));
        const auto report =
            QJsonDocument::fromJson(QByteArray::fromStdString(readTextFile(file("bent.json"))));
        m_error = report["constraintError"].toDouble(1);
        return pointsOf(*sharedMeshFile(file("bent.vtu")));
    }
    static std::string head(const std::string& motion, const std::string& hold) {
        return std::string("{'name': 'head', 'at': {") + kHead + "}, 'motion': [" + motion +
               "], 'hold': " + hold + "}";
    }

    QTemporaryDir m_folder;
    SimplicialMesh<3> m_bar = barMesh(6);
    double m_error = 1;
};

void TestHoldCli::initTestCase() {
    writeMesh<3>(file("bar.mesh"), m_bar);
    writeMesh<2>(file("strip.obj"), stripMesh(10, 2));
    const SimplicialMesh<3> half = blockMesh(1, 2, 6);
    writeMesh<3>(file("half.mesh"), half);
    writeMesh<3>(file("whole.mesh"), withImage(half));
}

/// Held coordinates go where the motion has them, to rounding, and the others are free.
void TestHoldCli::axes() {
    const std::string motion = "{'kind': 'translate', 'by': [3, 0, 0.5], 'time': [0, 1]}";
    const Points<3> end = bent("bar.mesh", kFoot + std::string(", ") + head(motion, "['z']"));
    QVERIFY(m_error <= 1e-12);
    double across = 0;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(2, v) < 5.5) continue;
        QVERIFY(std::abs(end(2, v) - 6.5) <= 1e-12 * 7);
        across = std::max(across, (end.col(v) - m_bar.points.col(v)).head<2>().norm());
    }
    QVERIFY2(across > 1e-3 && across < 0.5, qPrintable(QString::number(across)));  // the bar gets thinner
    const Points<3> two = bent("bar.mesh", kFoot + std::string(", ") + head(motion, "['z', 'x']"));
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5) QVERIFY(std::abs(two(0, v) - m_bar.points(0, v) - 3) <= 1e-12 * 7);
    const Points<3> all = bent("bar.mesh", kFoot + std::string(", ") + head(motion, "'all'"));
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5)
            QVERIFY((all.col(v) - m_bar.points.col(v) - Vec<3>(3, 0, 0.5)).norm() <= 1e-12 * 7);
}

void TestHoldCli::normals_data() {
    QTest::addColumn<QString>("motion");
    QTest::newRow("straight")
        << "{'kind': 'translate', 'by': [0.2, -0.1, 0.6], 'time': [0, 1], 'ease': 'inOut'}";
    QTest::newRow("curve")
        << "{'kind': 'curve', 'interpolation': 'bezier', 'points': [[0, 0, 0], [0, 0.3, 0.1], [0, "
           "0.4, 0.4], [0.2, -0.1, 0.6]], 'frame': 'none', 'time': [0, 1]}";
}

/// Only the way along the normal is prescribed.
void TestHoldCli::normals() {
    QFETCH(QString, motion);
    const std::string text = motion.toStdString();
    const Points<3> along =
        bent("bar.mesh", kFoot + std::string(", ") + head(text, "{'normal': [0, 0, -3]}"));
    const Points<3> axis = bent("bar.mesh", kFoot + std::string(", ") + head(text, "['z']"));
    QCOMPARE(along, axis);
    const Points<3> end = bent("bar.mesh", kFoot + std::string(", ") + head(text, "{'normal': [1, 2, 2]}"));
    QVERIFY(m_error <= 1e-12);
    const Vec<3> normal = Vec<3>(1, 2, 2) / 3, by(0.2, -0.1, 0.6);
    double across = 0;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(2, v) < 5.5) continue;
        const Vec<3> moved = end.col(v) - m_bar.points.col(v);
        QVERIFY(std::abs(normal.dot(moved - by)) <= 1e-12 * 7);
        across = std::max(across, (moved - by).norm());
    }
    QVERIFY(across > 0.05);
}

/// A half with its plane of symmetry held across bends as the whole does. Without smoothness, whose terms at
/// the plane only the whole has.
void TestHoldCli::halfAndWhole() {
    const std::string
        turn = "{'kind': 'rotate', 'centre': [0, 1, 6], 'axis': [1, 0, 0], 'angle': 0.9, 'time': [0, 1]}",
        settings =
            ", 'material': {'phi': 'metr', 'smoothing': {'kind': 'none'}}, 'integration': "
            "{'tolerance': 1e-6}";
    const std::string both = kFoot + std::string(", ") + head(turn, "'all'");
    const Points<3> whole = bent("whole.mesh", both, settings);
    for (const char* hold : {"['x']", "{'normal': [2, 0, 0]}"}) {
        const std::string plane =
            "{'name': 'plane', 'at': {'region': {'box': {'min': [-0.1, -9, -9], 'max': [0.1, 9, 9]}}}, "
            "'hold': " +
            std::string(hold) + "}";
        const Points<3> half = bent("half.mesh", both + ", " + plane, settings);
        const double off = (half - whole.leftCols(half.cols())).colwise().norm().maxCoeff();
        QVERIFY2(off < 1e-5 * 7, qPrintable(QString::number(off)));
        for (int v = 0; v < half.cols(); ++v)
            if (whole(0, v) == 0) QCOMPARE(half(0, v), 0.0);
    }
    // Without it the half would bend another way.
    const Points<3> loose = bent("half.mesh", both, settings);
    QVERIFY((loose - whole.leftCols(loose.cols())).colwise().norm().maxCoeff() > 1e-3);
}

/// Two planes that meet in an edge, one of them tilted in the coordinates' axes: the edge has both normals.
void TestHoldCli::quarterAndWhole() {
    const std::string
        pull = "{'kind': 'translate', 'by': [0, 0, 1.5], 'time': [0, 1]}",
        foot = "{'at': {'region': {'box': {'min': [-9, -9, -0.5], 'max': [9, 9, 0.5]}}}, 'hold': ['z']}",
        settings = ", 'material': {'phi': 'metr', 'smoothing': {'kind': 'none'}}";
    const auto plane = [](const char* box, const char* hold) {
        return std::string(", {'at': {'region': {'box': {") + box + "}}}, 'hold': " + hold + "}";
    };
    const Points<3> axes =
        bent("bar.mesh",
             foot + ", " + head(pull, "['z']") + plane("'min': [-0.1, -9, -9], 'max': [0.1, 9, 9]", "['x']") +
                 plane("'min': [-9, -0.1, -9], 'max': [9, 0.1, 9]", "['y']"),
             settings);
    // The same turned by 30° about z.
    SimplicialMesh<3> turned = m_bar;
    const Mat<3> R = Eigen::AngleAxisd(0.5, Vec<3>::UnitZ()).toRotationMatrix();
    turned.points = R * m_bar.points;
    writeMesh<3>(file("turned.mesh"), turned);
    std::string x, y;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(0, v) == 0) x += (x.empty() ? "" : ", ") + std::to_string(v);
        if (m_bar.points(1, v) == 0) y += (y.empty() ? "" : ", ") + std::to_string(v);
    }
    std::ostringstream nx, ny;
    nx.precision(17), ny.precision(17);
    nx << '[' << R(0, 0) << ", " << R(1, 0) << ", 0]";
    ny << '[' << R(0, 1) << ", " << R(1, 1) << ", 0]";
    const Points<3> tilted = bent("turned.mesh",
                                  foot + ", " + head(pull, "['z']") + ", {'at': {'vertices': [" + x +
                                      "]}, 'hold': {'normal': " + nx.str() + "}}, {'at': {'vertices': [" + y +
                                      "]}, 'hold': {'normal': " + ny.str() + "}}",
                                  settings);
    const double off = (R.transpose() * tilted - axes).colwise().norm().maxCoeff();
    QVERIFY2(off < 1e-4 * 7, qPrintable(QString::number(off)));  // the tolerance of the steps
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        const Vec<3> moved = R.transpose() * (tilted.col(v) - turned.points.col(v));
        if (m_bar.points(0, v) == 0) QVERIFY(std::abs(moved.x()) < 1e-11);
        if (m_bar.points(1, v) == 0) QVERIFY(std::abs(moved.y()) < 1e-11);
    }
}

void TestHoldCli::inThePlane() {
    putProject(
        path(), "flat.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'vertices': [0, 11, 22]}}, {'at': {'vertices': "
        "[10, 21, 32]}, 'hold': {'normal': [1, 1]}, 'motion': [{'kind': 'translate', 'by': [1, 1]}]}]");
    QCOMPARE(run({"run", "flat.wend", "--mesh", "flat.obj"}).error, QString());
    const Points<3> rest = pointsOf(*sharedMeshFile(file("strip.obj"))),
                    end = pointsOf(*sharedMeshFile(file("flat.obj")));
    for (const int v : {10, 21, 32})
        QVERIFY(std::abs((end.col(v) - rest.col(v)).dot(Vec<3>(1, 1, 0)) - 2) < 1e-11);
    QVERIFY((end.col(21) - rest.col(21) - Vec<3>(1, 1, 0)).norm() > 0.01);
}

/// A vertex that slid begins the next motion at its present place, and is free outside its active time.
void TestHoldCli::motionsFollowEachOther() {
    const std::string twice =
        "{'kind': 'translate', 'by': [0, 0, 0.5], 'time': [0, 1]}, {'kind': 'translate', 'by': [0, 0, 0.25], "
        "'time': "
        "[2, 3]}";
    const Points<3> end = bent("bar.mesh", kFoot + std::string(", ") + head(twice, "['z']"));
    QVERIFY(m_error <= 1e-12);
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5) QVERIFY(std::abs(end(2, v) - 6.75) <= 1e-12 * 7);
    std::string brief = head("{'kind': 'translate', 'by': [0, 0, 1], 'time': [0, 1]}", "['z']");
    brief.insert(brief.size() - 1, ", 'active': [0.25, 0.5]");
    const Points<3> part = bent("bar.mesh", kFoot + std::string(", ") + brief, ", 'time': {'end': 1}");
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5) QVERIFY(std::abs(part(2, v) - 6.25) <= 1e-11);
}

void TestHoldCli::savedAsRead() {
    putProject(path(), "saved.wend",
               std::string("'domain': {'mesh': 'bar.mesh'}, 'handles': [") + kFoot + ", " +
                   head("{'kind': 'translate', 'by': [0, 0, 1], 'time': [0, 1]}", "['x', 'z']") + ", " +
                   "{'at': {'vertices': [3]}, 'hold': {'normal': [1, 2, 3]}}, {'at': {'vertices': [4]}, "
                   "'hold': 'all'}]");
    writeProject(file("again.wend"), *readProject(file("saved.wend")).project);
    writeProject(file("third.wend"), *readProject(file("again.wend")).project);
    const std::string again = readTextFile(file("again.wend"));
    QCOMPARE(readTextFile(file("third.wend")), again);
    for (const char* piece : {"\"hold\": [\"x\", \"z\"]", "\"normal\": [1, 2, 3]"})
        QVERIFY2(again.find(piece) != std::string::npos, again.c_str());
}

void TestHoldCli::bad_data() {
    QTest::addColumn<QString>("hold");
    QTest::addColumn<QString>("message");
    QTest::newRow("axis") << "['w']"
                          << "handles[1].hold[0]: \"w\" is not an axis of this project";
    QTest::newRow("none") << "[]"
                          << "handles[1].hold: names no axis";
    QTest::newRow("word") << "'some'"
                          << "handles[1].hold: unknown value \"some\"";
    QTest::newRow("no direction") << "{'normal': [0, 0, 0]}"
                                  << "handles[1].hold.normal: must not be the zero vector";
    QTest::newRow("misspelt") << "{'nromal': [0, 0, 1]}"
                              << "`nromal` is not known; `normal`?";
    QTest::newRow("dimension") << "{'normal': [0, 1]}"
                               << "handles[1].hold.normal: has 2 numbers";
}

void TestHoldCli::bad() {
    QFETCH(QString, hold);
    QFETCH(QString, message);
    putProject(path(), "bad.wend",
               std::string("'domain': {'mesh': 'bar.mesh'}, 'handles': [") + kFoot + ", " +
                   head("{'kind': 'translate', 'by': [0, 0, 1]}", hold.toStdString()) + "]");
    const CliResult result = run({"run", "bad.wend", "--mesh", "bad.vtu"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.count('\n') == 1 && result.error.contains(message), qPrintable(result.error));
    putProject(
        path(), "bad.wend",
        "'domain': {'mesh': 'bar.mesh'}, 'handles': [{'name': 'inside', 'at': {'points': [[0.3, 0.4, 0.5]]}, "
        "'hold': ['x']}]");
    QVERIFY(run({"run", "bad.wend", "--mesh", "bad.vtu"})
                .error.contains("handle \"inside\": only vertices can slide"));
}

QTEST_GUILESS_MAIN(TestHoldCli)
#include "test_hold_cli.moc"
