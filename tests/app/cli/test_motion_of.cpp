// wend run --motion-of: the motion of one project on the shape of another.

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>
#include <cmath>

#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/pictures.h"
#include "warp/image.h"

using namespace wend;

class TestMotionOf : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void scaledCopies_data();
    void scaledCopies();
    void scaledPictures();
    void fieldOnAnotherMesh();
    void otherPins();
    void groups();
    void timesComeAlong();
    void badInput_data();
    void badInput();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0, qPrintable(QString::number(result.code) + result.error));
    }
    template <int Dim>
    Points<Dim> pointsIn(const char* name) const {
        return pointsOf(*sharedMeshFile(file(name))).topRows<Dim>();
    }
    QStringList noticesIn(const char* name) const {
        QFile report(path() + "/" + name);
        if (!report.open(QIODevice::ReadOnly)) return {};
        QStringList all;
        for (const auto& one : QJsonDocument::fromJson(report.readAll())["notices"].toArray())
            all << one.toString();
        return all;
    }

    QTemporaryDir m_folder;
};

namespace {

constexpr double kScale = 2.5;
// Steps are chosen in the frame of the shape, so the results differ by rounding only.
constexpr double kRounding = 1e-10;

template <int Dim>
Points<Dim> scaled(const Points<Dim>& points) {
    Vec<Dim> shift = Vec<Dim>::Constant(7);
    shift[0] = -3;
    return (kScale * points).colwise() + shift;
}

std::string number(double x) {
    return QString::number(x, 'g', 17).toStdString();
}

std::string list(const Vec3& p) {
    return "[" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + "]";
}

std::string boxRegion(const Vec3& low, const Vec3& high) {
    return "{'region': {'box': {'min': " + list(low) + ", 'max': " + list(high) + "}}}";
}

const Vec3 kFootLow(-1, -1, -0.5), kFootHigh(3, 3, 0.5), kHeadLow(-1, -1, 5.5), kHeadHigh(3, 3, 6.5);

/// The same box in the scaled copy.
std::string scaledBox(const Vec3& low, const Vec3& high) {
    Points3 corners(3, 2);
    corners << low, high;
    const Points3 there = scaled<3>(corners);
    return boxRegion(there.col(0), there.col(1));
}

}  // namespace

void TestMotionOf::initTestCase() {
    const SimplicialMesh<3> bar = barMesh(6);
    writeMesh<3>(file("bar.mesh"), bar);
    writeMesh<3>(file("large.mesh"), {scaled<3>(bar.points), bar.cells});
    const SimplicialMesh<2> strip = stripMesh(10, 2);
    writeMesh<2>(file("strip.obj"), strip);
    SimplicialMesh<2> finer = stripMesh(30, 6);
    finer.points /= 3;
    writeMesh<2>(file("finer.obj"), finer);
    put(path(), "poses.csv",
        "time,x,y,z,rx,ry,rz\n0,1,1,6,0,0,0\n0.5,1.2,1,6.1,0,0,0.2\n1,1.3,0.9,6,0.1,0,0.4\n");
    put(path(), "u.csv",
        "id,dx,dy,dz\n54,0.1,0,0.2\n55,0.1,0.1,0.2\n56,0.1,0.2,0.2\n57,0.1,0,0.3\n58,0.1,0.1,0.3\n"
        "59,0.1,0.2,0.3\n60,0.1,0,0.4\n61,0.1,0.1,0.4\n62,0.1,0.2,0.4\n");
}

void TestMotionOf::scaledCopies_data() {
    QTest::addColumn<QString>("motion");
    const auto row = [](const char* name, const char* motion) { QTest::newRow(name) << QString(motion); };
    row("translate", "{'kind': 'translate', 'by': [0.5, 0.2, 0.3], 'time': [0, 1]}");
    row("rotate",
        "{'kind': 'rotate', 'centre': [1, 2, 5], 'axis': [0.3, 1, 0], 'angle': 0.7, 'time': [0, 1]}");
    row("curve",
        "{'kind': 'curve', 'interpolation': 'bezier', 'points': [[1, 1, 6], [1.2, 1, 6.5], [1.5, 1.4, 7], "
        "[2, 1, 6.5]], 'frame': 'minimal', 'twist': 0.4, 'scale': 0.9, 'time': [0, 1]}");
    row("recorded",
        "{'kind': 'recorded', 'times': [0, 0.3, 1], 'points': [[1, 1, 6], [1.3, 1, 6.2], [1.3, 1.5, 6]], "
        "'time': [0, 1]}");
    row("poses", "{'kind': 'poses', 'file': 'poses.csv'}");
    row("field", "{'kind': 'field', 'file': 'u.csv', 'time': [0, 1]}");
    row("one after another",
        "{'kind': 'rotate', 'centre': [1, 1, 6], 'axis': [0, 0, 1], 'angle': 0.5, 'time': [0, 0.5], 'ease': "
        "'inOut'}, {'kind': 'translate', 'by': [0, 0.4, 0.2], 'time': [0.5, 1]}");
}

/// The pose of a scaled copy is the scaled pose.
void TestMotionOf::scaledCopies() {
    QFETCH(QString, motion);
    putProject(
        path(), "a.wend",
        "'domain': {'mesh': 'bar.mesh'}, 'material': {'memory': 0.3}, 'handles': [{'name': 'foot', 'at': " +
            boxRegion(kFootLow, kFootHigh) + "}, {'name': 'head', 'at': " + boxRegion(kHeadLow, kHeadHigh) +
            ", 'motion': [" + motion.toStdString() + "]}]");
    putProject(path(), "b.wend",
               "'domain': {'mesh': 'large.mesh'}, 'time': {'end': 5}, 'handles': [{'name': 'head', 'at': " +
                   scaledBox(kHeadLow, kHeadHigh) +
                   ", 'motion': [{'kind': 'translate', 'by': [9, 9, 9], 'time': [0, 5]}]}, {'name': 'foot', "
                   "'at': " +
                   scaledBox(kFootLow, kFootHigh) + "}]");
    succeed({"run", "a.wend", "--mesh", "a.mesh"});
    succeed({"run", "b.wend", "--motion-of", "a.wend", "--mesh", "b.mesh", "--report", "b.json"});
    QCOMPARE(noticesIn("b.json"), QStringList());
    const Points3 a = pointsIn<3>("a.mesh"), b = pointsIn<3>("b.mesh"), rest = pointsIn<3>("bar.mesh");
    QVERIFY((a - rest).cwiseAbs().maxCoeff() > 0.1);
    const double off = (b - scaled<3>(a)).cwiseAbs().maxCoeff();
    QVERIFY2(off < kRounding * kScale * 6, qPrintable(QString::number(off)));
}

/// A picture of twice the size, with its pins where they are, moves twice as far.
void TestMotionOf::scaledPictures() {
    for (const int size : {1, 2}) {
        Image image = discPicture(64 * size, 24 * size);
        writeImage(file(size == 1 ? "small.png" : "double.png"), image);
    }
    const auto project = [](const char* image, int size, const char* motion) {
        const std::string s = std::to_string(20 * size), t = std::to_string(44 * size),
                          m = std::to_string(32 * size), l = std::to_string(12 * size),
                          h = std::to_string(52 * size);
        return "'domain': {'image': '" + std::string(image) + "', 'outline': {'polygons': [[[" + l + ", " +
               l + "], [" + h + ", " + l + "], [" + h + ", " + h + "], [" + l + ", " + h +
               "]]]}, 'vertices': 400}, 'handles': [{'name': 'held', 'at': {'points': [[" + s + ", " + m +
               "]]}}, {'name': 'moved', 'at': {'points': [[" + t + ", " + m + "]]}" + motion + "}]";
    };
    putProject(path(), "small.wend",
               project("small.png", 1, ", 'motion': [{'kind': 'translate', 'by': [4, -6], 'time': [0, 1]}]"));
    putProject(path(), "double.wend", project("double.png", 2, ""));
    succeed({"run", "small.wend", "--mesh", "small.obj"});
    succeed({"run", "double.wend", "--motion-of", "small.wend", "--mesh", "double.obj"});
    const Points2 a = pointsIn<2>("small.obj"), b = pointsIn<2>("double.obj");
    QCOMPARE(a.cols(), b.cols());
    const double off = (b - 2 * a).cwiseAbs().maxCoeff();
    QVERIFY2(off < kRounding * 128, qPrintable(QString::number(off)));
}

/// Every vertex of a finer mesh has the displacement of the nearest one.
void TestMotionOf::fieldOnAnotherMesh() {
    put(path(), "end.csv", "id,dx,dy\n10,0.5,0\n21,0.5,0.25\n32,0.5,0.5\n");
    const std::string pins =
        "{'name': 'start', 'at': {'region': {'box': {'min': [-1, -1], 'max': [0.1, 3]}}}}, ";
    putProject(path(), "a.wend",
               "'domain': {'mesh': 'strip.obj'}, 'handles': [" + pins +
                   "{'name': 'end', 'at': {'vertices': [10, 21, 32]}, 'motion': [{'kind': 'field', 'file': "
                   "'end.csv', 'time': [0, 1]}]}]");
    putProject(path(), "b.wend",
               "'domain': {'mesh': 'finer.obj'}, 'handles': [" + pins +
                   "{'name': 'end', 'at': {'region': {'box': {'min': [9.99, -1], 'max': [11, 3]}}}}]");
    succeed({"run", "b.wend", "--motion-of", "a.wend", "--mesh", "b.obj"});
    const Points2 rest = pointsIn<2>("finer.obj"), b = pointsIn<2>("b.obj");
    int held = 0;
    for (Eigen::Index v = 0; v < rest.cols(); ++v) {
        if (rest(0, v) < 9.99) continue;
        ++held;
        const Vec2 moved = b.col(v) - rest.col(v);
        QVERIFY(std::abs(moved.x() - 0.5) < 1e-9);
        QVERIFY(std::abs(moved.y() - 0.25 * std::round(rest(1, v))) < 1e-9);
    }
    QCOMPARE(held, 7);
}

/// Handles without a namesake are placed in proportion, left out, or hold still, and are named in a message.
void TestMotionOf::otherPins() {
    putProject(
        path(), "a.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'name': 'hip', 'at': {'points': [[0, 0]]}}, {'name': "
        "'hand', 'at': {'points': [[10, 2]]}, 'motion': [{'kind': 'translate', 'by': [0, 1], 'time': [0, "
        "1]}]}, {'name': 'nose', 'at': {'region': {'circle': {'centre': [9.5, 0.1], 'radius': 0.2}}}}]");
    // An L: the nose of the strip would lie outside of it.
    SimplicialMesh<2> l = stripMesh(10, 4);
    std::erase_if(l.cells, [&](const Cell<2>& cell) {
        Vec2 centre = Vec2::Zero();
        for (const int v : cell) centre += l.points.col(v) / 3;
        return centre.x() > 5 && centre.y() < 2;
    });
    writeMesh<2>(file("l.obj"), l);
    putProject(
        path(), "b.wend",
        "'domain': {'mesh': 'l.obj'}, 'handles': [{'name': 'hip', 'at': {'points': [[0, 0]]}}, {'name': "
        "'tail', 'at': {'points': [[1, 4]]}, 'motion': [{'kind': 'translate', 'by': [3, 0], 'time': [0, "
        "1]}]}]");
    succeed({"run", "b.wend", "--motion-of", "a.wend", "--mesh", "b.obj", "--report", "b.json"});
    QStringList named;
    for (const QString& notice : noticesIn("b.json"))
        if (notice.startsWith("pins")) named << notice;
    QCOMPARE(named,
             QStringList({"pins of the other project without a namesake here, placed in proportion: \"hand\"",
                          "pins of the other project that find no place here and are left out: \"nose\"",
                          "pins without a motion in the other project, which hold still: \"tail\""}));
    const Points2 rest = pointsIn<2>("l.obj"), b = pointsIn<2>("b.obj");
    for (Eigen::Index v = 0; v < rest.cols(); ++v) {
        const Vec2 moved = b.col(v) - rest.col(v);
        if (rest.col(v) == Vec2(1, 4) || rest.col(v) == Vec2(0, 0)) QVERIFY(moved.norm() < 1e-9);
        // √(12 Tr C) of a box is its diagonal; that of the L follows from its two boxes.
        if (rest.col(v) == Vec2(10, 4)) QVERIFY(moved.y() > 1 && std::abs(moved.x()) < 1e-9);
    }
    QCOMPARE(run({"run", "b.wend", "--motion-of", "a.wend", "--mesh", "c.obj", "--strict"}).code, 3);
}

/// A pin on a group is placed on the group of that name.
void TestMotionOf::groups() {
    const auto obj = [](int shift) {
        std::string text;
        for (int i = 0; i <= 4; ++i)
            for (int j = 0; j <= 1; ++j)
                text += "v " + std::to_string(i + shift) + " " + std::to_string(j) + " 0\n";
        for (int i = 0; i < 4; ++i) {
            const int a = 2 * i + 1;
            text += std::string("g ") + (i == 0 ? "left" : i == 3 ? "right" : "middle") + "\n";
            text +=
                "f " + std::to_string(a) + " " + std::to_string(a + 2) + " " + std::to_string(a + 3) + "\n";
            text +=
                "f " + std::to_string(a) + " " + std::to_string(a + 3) + " " + std::to_string(a + 1) + "\n";
        }
        return text;
    };
    put(path(), "one.obj", obj(0));
    put(path(), "two.obj", obj(50));
    putProject(
        path(), "a.wend",
        "'domain': {'mesh': 'one.obj'}, 'handles': [{'name': 'l', 'at': {'group': 'left'}}, {'name': 'r', "
        "'at': {'group': 'right'}, 'motion': [{'kind': 'translate', 'by': [0.5, 0], 'time': [0, 1]}]}]");
    putProject(path(), "b.wend", "'domain': {'mesh': 'two.obj'}");
    succeed({"run", "b.wend", "--motion-of", "a.wend", "--mesh", "b.obj"});
    const Points2 rest = pointsIn<2>("two.obj"), b = pointsIn<2>("b.obj");
    for (Eigen::Index v = 0; v < rest.cols(); ++v) {
        const double x = rest(0, v) - 50;
        if (x <= 1) QVERIFY((b.col(v) - rest.col(v)).norm() < 1e-12);
        if (x >= 3) QVERIFY((b.col(v) - rest.col(v) - Vec2(0.5, 0)).norm() < 1e-12);
    }
}

/// The end, the frame rate and the cycle are those of the motion.
void TestMotionOf::timesComeAlong() {
    putProject(path(), "a.wend",
               "'domain': {'mesh': 'strip.obj'}, 'time': {'end': 2, 'frameRate': 6, 'cycle': [0.5, 1.5]}, "
               "'handles': [{'name': 'hip', 'at': {'points': [[0, 0], [0, 2]]}}, {'name': 'hand', 'at': "
               "{'points': [[10, 2]]}, 'motion': [{'kind': 'translate', 'by': [0, 1], 'time': [0, 2]}]}]");
    putProject(path(), "b.wend",
               "'domain': {'mesh': 'strip.obj'}, 'handles': [{'name': 'hip', 'at': {'points': [[0, 0], [0, "
               "2]]}}, {'name': 'hand', 'at': {'points': [[10, 2]]}}]");
    succeed({"run", "b.wend", "--motion-of", "a.wend", "--mesh", "b.obj", "--report", "b.json", "--frames",
             "f_##.obj", "--loop", "--count", "4"});
    succeed({"run", "a.wend", "--mesh", "a.obj", "--frames", "g_##.obj", "--loop", "--count", "4"});
    QVERIFY((pointsIn<2>("a.obj") - pointsIn<2>("b.obj")).cwiseAbs().maxCoeff() < kRounding);
    for (const int k : {0, 3})
        QVERIFY((pointsIn<2>(qPrintable(QString("f_0%1.obj").arg(k))) -
                 pointsIn<2>(qPrintable(QString("g_0%1.obj").arg(k))))
                    .cwiseAbs()
                    .maxCoeff() < kRounding);
    QFile report(path() + "/b.json");
    QVERIFY(report.open(QIODevice::ReadOnly));
    QCOMPARE(QJsonDocument::fromJson(report.readAll())["time"].toDouble(), 2.0);
}

void TestMotionOf::badInput_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const QStringList& arguments, int code, const char* message) {
        QTest::newRow(name) << (QStringList{"run", "flat.wend"} + arguments) << code << message;
    };
    row("a solid's", {"--motion-of", "solid.wend", "--mesh", "o.obj"}, 3,
        "solid.wend: moves a solid: its motion does not fit a picture");
    row("missing", {"--motion-of", "none.wend", "--mesh", "o.obj"}, 3, "none.wend: does not exist");
    row("no project", {"--motion-of", "strip.obj", "--mesh", "o.obj"}, 3, "strip.obj: ");
    row("its own input", {"--motion-of", "other.wend", "--report", "other.wend"}, 2,
        "other.wend: would replace other.wend");
    row("a pin outside", {"--motion-of", "outside.wend", "--mesh", "o.obj"}, 3, "outside.wend: ");
}

void TestMotionOf::badInput() {
    putProject(path(), "flat.wend", "'domain': {'mesh': 'strip.obj'}");
    putProject(path(), "other.wend", "'domain': {'mesh': 'strip.obj'}");
    putProject(path(), "solid.wend", "'domain': {'mesh': 'bar.mesh'}");
    putProject(
        path(), "outside.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'name': 'p', 'at': {'region': {'circle': {'centre': "
        "[90, 0], 'radius': 1}}}}, {'name': 'q', 'at': {'vertices': [5000]}}]");
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, message);
    const CliResult result = run(arguments);
    QCOMPARE(result.code, code);
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestMotionOf)
#include "test_motion_of.moc"
