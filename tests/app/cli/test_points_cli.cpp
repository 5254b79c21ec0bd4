// Points mapped by a deformation, forward and back.

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>
#include <random>

#include "app/project/file/text_file.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/core/plain_readers.h"
#include "warp/image.h"

using namespace wend;

namespace {

constexpr double kAngle = 0.7;
const Vec2 kCentre(3, 1);

/// Returns a handle that rotates the whole shape about (3, 1[, 0]).
std::string turned(int dim) {
    const std::string third = dim == 3 ? ", 0" : "";
    return "{'name': 'all', 'at': {'region': {'box': {'min': [-9, -9" +
           (dim == 3 ? std::string(", -9") : "") + "], 'max': [99, 99" +
           (dim == 3 ? std::string(", 99") : "") + "]}}}, 'motion': [{'kind': 'rotate', 'centre': [3, 1" +
           third + "], " + (dim == 3 ? "'axis': [0, 0, 1], " : "") + "'angle': 0.7}]}";
}

Points3 turnedPoints(const Points3& points) {
    const Eigen::Rotation2Dd R(kAngle);
    Points3 result = points;
    for (auto p : result.colwise()) p.head<2>() = kCentre + R * (p.head<2>() - kCentre);
    return result;
}

/// Returns both ends of a bar or strip as handles, one of which rotates against the other.
std::string bend(int dim, double length) {
    const auto box = [&](double low, double high) {
        const std::string end = dim == 2 ? "]" : ", -9]", far = dim == 2 ? "]" : ", 99]";
        const auto at = [](double x) { return QString::number(x).toStdString(); };
        return "'region': {'box': {'min': [" + at(low) + ", -9" + end + ", 'max': [" + at(high) + ", 99" +
               far + "}}";
    };
    return "{'name': 'held', 'at': {" + box(-0.5, 0.5) + "}}, {'name': 'turned', 'at': {" +
           box(length - 0.5, length + 0.5) + "}, 'motion': [{'kind': 'rotate', 'centre': [" +
           QString::number(length / 2).toStdString() + ", 8" + (dim == 3 ? ", 1], 'axis': [0, 0, 1" : "") +
           "], 'angle': -0.8}]}";
}

std::string digits(double x) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << x;
    return out.str();
}

Points3 randomPoints(int count, const Vec3& low, const Vec3& high) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> unit(0, 1);
    Points3 points(3, count);
    for (auto p : points.colwise())
        for (int k = 0; k < 3; ++k) p[k] = low[k] + unit(engine) * (high[k] - low[k]);
    return points;
}

/// Parses rows of comma-separated numbers below a header line, as any program would.
Points3 rows(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    std::vector<std::vector<double>> found;
    while (std::getline(in, line)) {
        std::ranges::replace(line, ',', ' ');
        found.push_back(samples::plain::numbers(line));
    }
    Points3 points = Points3::Zero(3, static_cast<Eigen::Index>(found.size()));
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t k = 0; k < found[i].size() && k < 3; ++k)
            points(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) = found[i][k];
    return points;
}

std::string table(const Points3& points, int dim) {
    std::string text = dim == 2 ? "x,y\n" : "x,y,z\n";
    for (const auto p : points.colwise())
        for (int k = 0; k < dim; ++k) text += digits(p[k]) + (k + 1 < dim ? "," : "\n");
    return text;
}

double difference(const Points3& a, const Points3& b) {
    return a.cols() == b.cols() && a.cols() > 0 ? (a - b).cwiseAbs().maxCoeff() : 1e9;
}

}  // namespace

class TestPointsCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void rigidMotion_data();
    void rigidMotion();
    void thereAndBack_data();
    void thereAndBack();
    void likeTheStMap();
    void likeTheMesh();
    void textStaysAsItWas_data();
    void textStaysAsItWas();
    void clouds_data();
    void clouds();
    void wholeMeshes();
    void outsideAndCovered();
    void anyPlane_data();
    void anyPlane();
    void noPlane();
    void singlePrecision();
    void carriedDetail_data();
    void carriedDetail();
    void bad_data();
    void bad();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    std::string text(const std::string& name) const { return readTextFile(file(name)); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0, qPrintable(QString::number(result.code) + result.error));
    }

    /// Writes cloud.ply, with colours, and lines.obj.
    Points3 putClouds(const Vec3& low, const Vec3& high) const;

    QTemporaryDir m_folder;
};

void TestPointsCli::initTestCase() {
    writeMesh<2>(file("strip.obj"), stripMesh(10, 2));
    SimplicialMesh<3> bar = blockMesh(10, 2, 2);
    writeMesh<3>(file("bar.mesh"), bar);
    writeImage(file("disc.png"), discPicture(80, 30));
    const auto project = [this](const char* name, const std::string& domain, const std::string& handles) {
        putProject(path(), name, "'domain': {" + domain + "}, 'handles': [" + handles + "]");
    };
    project("turn2.wend", "'mesh': 'strip.obj'", turned(2));
    project("turn3.wend", "'mesh': 'bar.mesh'", turned(3));
    project("bend2.wend", "'mesh': 'strip.obj'", bend(2, 10));
    project("bend3.wend", "'mesh': 'bar.mesh'", bend(3, 10));
    project("picture.wend", "'image': 'disc.png', 'outline': {'from': 'frame'}, 'vertices': 300",
            "{'name': 'a', 'at': {'region': {'circle': {'centre': [20, 20], 'radius': 12}}}}, {'name': 'b', "
            "'at': {'points': [[60, 60]]}, 'motion': [{'kind': 'translate', 'by': [9, -7]}]}");
}

void TestPointsCli::rigidMotion_data() {
    QTest::addColumn<int>("dim");
    QTest::newRow("plane") << 2;
    QTest::newRow("space") << 3;
}

/// Points inside, on the border and far outside rotate with the shape.
void TestPointsCli::rigidMotion() {
    QFETCH(int, dim);
    Points3 points = randomPoints(200, Vec3(-5, -5, -5), Vec3(15, 7, 7));
    if (dim == 2) points.row(2).setZero();
    put(path(), "in.csv", table(points, dim));
    const QString project = QString("turn%1.wend").arg(dim);
    succeed({"run", project, "--points", "in.csv", "out.csv"});
    QVERIFY(difference(rows(text("out.csv")), turnedPoints(points)) < 1e-12);
    succeed({"run", project, "--points", "out.csv", "back.csv", "--inverse"});
    QVERIFY(difference(rows(text("back.csv")), points) < 1e-11);
}

void TestPointsCli::thereAndBack_data() {
    rigidMotion_data();
}

/// Points within the bent shape are mapped back; points within the first half of the time as well.
void TestPointsCli::thereAndBack() {
    QFETCH(int, dim);
    Points3 points = randomPoints(300, Vec3(0, 0, 0), Vec3(10, 2, 2));
    if (dim == 2) points.row(2).setZero();
    put(path(), "in.csv", table(points, dim));
    const QString project = QString("bend%1.wend").arg(dim);
    for (const char* time : {"0.5", "1"}) {
        succeed({"run", project, "--points", "in.csv", "out.csv", "--at", time});
        succeed({"run", project, "--points", "out.csv", "back.csv", "--inverse", "--at", time});
        QVERIFY(difference(rows(text("out.csv")), points) > 1);
        QVERIFY(difference(rows(text("back.csv")), points) < 1e-9);
    }
}

/// The ST map gives, for every pixel of the warped picture, its place in the source.
void TestPointsCli::likeTheStMap() {
    constexpr int kSize = 80;
    Points3 centres = Points3::Zero(3, kSize * kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) centres.col(kSize * y + x).head<2>() << x + 0.5, y + 0.5;
    put(path(), "in.csv", table(centres, 2));
    succeed({"run", "picture.wend", "--points", "in.csv", "out.csv", "--inverse", "--stmap", "st.exr"});
    const Points3 sources = rows(text("out.csv"));
    const Image map = readImage(file("st.exr"));
    QCOMPARE(map.width, kSize);
    int compared = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const float* st = reinterpret_cast<const float*>(map.row(y)) + 4 * x;
            if (st[3] < 1) continue;
            ++compared;
            const Vec2 expected(st[0] * kSize, (1 - st[1]) * kSize);
            QVERIFY((sources.col(kSize * y + x).head<2>() - expected).norm() < 1e-4);  // floats of 80 pixels
        }
    QVERIFY(compared > 5000);
}

/// The vertices of the mesh itself move as they do in --mesh, bit for bit.
void TestPointsCli::likeTheMesh() {
    succeed({"run", "bend3.wend", "--points", "bar.mesh", "carried.mesh", "--mesh", "bent.mesh"});
    QCOMPARE(pointsOf(*sharedMeshFile(file("carried.mesh"))), pointsOf(*sharedMeshFile(file("bent.mesh"))));
    QCOMPARE(readMesh<3>(file("carried.mesh")).cells, readMesh<3>(file("bar.mesh")).cells);
    succeed({"run", "bend2.wend", "--points", "strip.obj", "carried.obj", "--mesh", "bent.obj"});
    QCOMPARE(pointsOf(*sharedMeshFile(file("carried.obj"))), pointsOf(*sharedMeshFile(file("bent.obj"))));
}

void TestPointsCli::textStaysAsItWas_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("in");  // @ stands for a coordinate
    QTest::addColumn<int>("dim");
    QTest::newRow("other columns") << "a.csv"
                                   << "id,x,y,z,label\n7,@,@,@,left end\n8,@,@,@,\"b\"\n"
                                   << 3;
    QTest::newRow("semicolons, CRLF") << "a.csv"
                                      << "X; Y ;T\r\n@; @ ;5\r\n\r\n@;@;6\r\n"
                                      << 2;
    QTest::newRow("no header") << "a.txt"
                               << "@ @ @\n@\t@\t@\n  @   @  @  17" << 3;
    QTest::newRow("comments") << "a.txt"
                              << "# made by hand\n// x y are not here\n@ @ 3 4\n# next\n% more\n@ @ 5 6\n"
                              << 2;
    QTest::newRow("CloudCompare") << "a.txt"
                                  << "//X,Y,Z,R\n@,@,@,255\n"
                                  << 3;
    QTest::newRow("ParaView") << "a.csv"
                              << "\"u\",\"Points:0\",\"Points:1\",\"Points:2\"\n1,@,@,@\n"
                              << 3;
    QTest::newRow("molecule") << "a.xyz"
                              << "2\n1 2 3 frames\nC @ @ @\nH @ @ @ 0.1\n"
                              << 3;
    QTest::newRow("byte order mark") << "a.csv" << QString::fromUtf8("\xef\xbb\xbfx,y\n@,@\n") << 2;
}

/// Only the coordinates change.
void TestPointsCli::textStaysAsItWas() {
    QFETCH(QString, name);
    QFETCH(QString, in);
    QFETCH(int, dim);
    const auto count = static_cast<int>(in.count('@')) / dim;
    Points3 points = randomPoints(count, Vec3(0, 0, 0), Vec3(10, 2, 2));
    const auto filled = [&](const Points3& values) {
        std::string text;
        int next = 0;
        for (const char c : in.toStdString())
            text += c == '@' ? digits(values(next % dim, next / dim)) : std::string(1, c), next += c == '@';
        return text;
    };
    put(path(), qPrintable(name), filled(points));
    const QString out = "out." + name.section('.', -1);
    succeed({"run", QString("turn%1.wend").arg(dim), "--points", name, out});
    const std::string got = text(out.toStdString());
    // The text around the numbers, and the numbers.
    const Points3 expected = turnedPoints(points);
    std::size_t at = 0;
    int next = 0;
    for (const char c : in.toStdString()) {
        if (c != '@') {
            QCOMPARE(got.at(at++), c);
            continue;
        }
        char* end = nullptr;
        const double value = std::strtod(got.c_str() + at, &end);
        QVERIFY(std::abs(value - expected(next % dim, next / dim)) < 1e-12);
        at = static_cast<std::size_t>(end - got.c_str());
        ++next;
    }
    QCOMPARE(at, got.size());
}

Points3 TestPointsCli::putClouds(const Vec3& low, const Vec3& high) const {
    const Points3 points = randomPoints(20, low, high);
    std::string
        ply =
            "ply\nformat ascii 1.0\nelement vertex 20\nproperty double x\nproperty double y\nproperty "
            "double z\nproperty uchar red\nend_header\n",
        obj;
    for (const auto p : points.colwise()) {
        const std::string place = digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]);
        ply += place + " 200\n";
        obj += "v " + place + "\n";
    }
    put(path(), "cloud.ply", ply);
    put(path(), "lines.obj", obj + "o thread\nl 1 2 3 4\nl 5 6\n");
    return points;
}

void TestPointsCli::clouds_data() {
    QTest::addColumn<QString>("in");
    QTest::addColumn<QString>("out");
    QTest::newRow("ply") << "cloud.ply"
                         << "out.ply";
    QTest::newRow("obj with lines") << "lines.obj"
                                    << "out.obj";
    QTest::newRow("text to ply") << "cloud.csv"
                                 << "out.ply";
    QTest::newRow("text to vtu") << "cloud.csv"
                                 << "out.vtu";
    QTest::newRow("text to obj") << "cloud.csv"
                                 << "out.obj";
    QTest::newRow("text to off") << "cloud.csv"
                                 << "out.off";
    QTest::newRow("text to msh") << "cloud.csv"
                                 << "out.msh";
    QTest::newRow("ply to text") << "cloud.ply"
                                 << "out.csv";
    QTest::newRow("lines to vtk") << "lines.obj"
                                  << "out.vtk";
}

void TestPointsCli::clouds() {
    QFETCH(QString, in);
    QFETCH(QString, out);
    const Points3 points = putClouds(Vec3(0, 0, 0), Vec3(10, 2, 2));
    put(path(), "cloud.csv", table(points, 3));
    succeed({"run", "turn3.wend", "--points", in, out});
    const std::string got = text(out.toStdString());
    Points3 read;
    if (out.endsWith(".csv"))
        read = rows(got);
    else
        read = readMeshFile(file(out.toStdString()), MeshNeeds::Points).points;
    QVERIFY(difference(read, turnedPoints(points)) < 1e-12);
    if (out == "out.obj" && in == "lines.obj") QVERIFY(got.ends_with("o thread\nl 1 2 3 4\nl 5 6\n"));
    if (in == "cloud.ply" && out == "out.ply") QVERIFY(got.find(" 200\n") != std::string::npos);
    if (out == "out.vtk") QVERIFY(got.find("\n4 0 1 2 3\n") != std::string::npos);
    if (out == "out.vtu")
        QVERIFY(got.find("NumberOfPoints=\"20\" NumberOfCells=\"20\"") != std::string::npos);
}

/// Cells, fields and groups of a finer mesh are kept.
void TestPointsCli::wholeMeshes() {
    SimplicialMesh<3> fine = blockMesh(20, 4, 4);
    fine.points *= 0.5;
    MeshFile mesh = toMeshFile<3>(fine);
    MeshField field{"u", false, 1, {}};
    for (int v = 0; v < fine.vertexCount(); ++v) field.values.push_back(v);
    mesh.fields = {field};
    writeMeshFile(file("fine.vtu"), mesh);
    succeed({"run", "turn3.wend", "--points", "fine.vtu", "out.vtu", "--points", "fine.vtu", "out.msh"});
    for (const char* name : {"out.vtu", "out.msh"}) {
        const auto read = sharedMeshFile(file(name));
        QVERIFY(difference(pointsOf(*read), turnedPoints(mesh.points)) < 1e-12);
        QCOMPARE(tetrahedraOf(*read), fine.cells);
    }
    QCOMPARE(fieldsOf(*sharedMeshFile(file("out.vtu"))).at(0).values, field.values);
}

void TestPointsCli::outsideAndCovered() {
    put(path(), "in.csv", "x,y\n5,1\n5,3\n-2,1\n");
    const CliResult outside = run({"run", "turn2.wend", "--points", "in.csv", "out.csv"});
    QCOMPARE(outside.code, 0);
    QVERIFY(outside.error.contains("in.csv: 2 of 3 points lie outside the shape"));
    QCOMPARE(outside.error.count("outside the shape"), 1);
    QCOMPARE(run({"run", "turn2.wend", "--points", "in.csv", "strict.csv", "--strict"}).code, 3);
    QVERIFY(!QFile::exists(path() + "/strict.csv"));

    // The right one of two squares is moved over the left, in front of it or behind.
    put(path(), "squares.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\nf 1 2 3\nf 1 3 4\nf 5 6 "
        "7\nf 5 7 8\n");
    put(path(), "over.csv", "x,y\n0.9,0.5\n");
    for (const bool isInFront : {true, false}) {
        putProject(path(), "over.wend",
                   std::string("'domain': {'mesh': 'squares.obj'}, 'depth': [{'order': ") +
                       (isInFront ? "5" : "-5") +
                       ", 'shape': {'box': {'min': [2, -1], 'max': [5, 2]}}}], 'handles': [{'at': "
                       "{'vertices': [0, 1, 2, "
                       "3]}}, {'at': {'vertices': [4, 5, 6, 7]}, 'motion': [{'kind': 'translate', 'by': "
                       "[-2.5, 0.25]}]}]");
        const CliResult covered = run({"run", "over.wend", "--points", "over.csv", "out.csv", "--inverse"});
        QVERIFY2(covered.code == 0, qPrintable(covered.error));
        QVERIFY2(covered.error.contains("over.csv: 1 of 1 points lies where the shape covers itself"),
                 qPrintable(covered.error));
        const Points3 expected = isInFront ? Vec3(3.4, 0.25, 0) : Vec3(0.9, 0.5, 0);
        QVERIFY(difference(rows(text("out.csv")), expected) < 1e-12);
    }
}

void TestPointsCli::anyPlane_data() {
    QTest::addColumn<int>("across");  // coordinate axis; −1: tilted
    QTest::addColumn<double>("noise");
    QTest::newRow("across x") << 0 << 0.0;
    QTest::newRow("across y") << 1 << 0.0;
    QTest::newRow("across z, with noise") << 2 << 4e-6;
    QTest::newRow("tilted") << -1 << 0.0;
    QTest::newRow("tilted, with noise") << -1 << 4e-6;
}

/// A rotation about the origin in the plane's coordinates equals one in space about the normal through its
/// origin.
void TestPointsCli::anyPlane() {
    QFETCH(int, across);
    QFETCH(double, noise);
    MeshFile mesh = toMeshFile<2>(stripMesh(10, 2));
    const Points3 jitter = randomPoints(33, Vec3(0, 0, -noise), Vec3(0, 0, noise));
    mesh.points.row(2) = jitter.row(2).array() + 3;
    Eigen::Matrix3d R = Eigen::AngleAxisd(0.9, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    if (across == 0) R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    if (across == 1) R << 1, 0, 0, 0, 0, 1, 0, 1, 0;
    if (across == 2) R.setIdentity();
    mesh.points = R * mesh.points;
    writeMeshFile(file("plane.obj"), mesh);
    put(path(), "in.csv", table(mesh.points, 3));
    putProject(
        path(), "plane.wend",
        "'domain': {'mesh': 'plane.obj'}, 'handles': [{'at': {'region': {'box': {'min': [-99, -99], 'max': "
        "[99, 99]}}}, 'motion': [{'kind': 'rotate', 'centre': [0, 0], 'angle': 0.7}]}]");
    QStringList arguments{"run", "plane.wend", "--mesh", "out.obj", "--mesh", "out.vtu"};
    if (across != 2) arguments += {"--points", "in.csv", "out.csv"};
    succeed(arguments);
    Vec3 normal = R.col(2);
    int largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    if (normal[largest] < 0) normal = -normal;
    if (across == 1) normal = -normal;  // from x to z
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, normal).toRotationMatrix();
    const Points3 expected = rotation * mesh.points;
    // A fitted plane differs from the exact one by the noise over the width, which turns the axis.
    const double tolerance = across < 0 && noise > 0 ? 1e-4 : 1e-12;
    const auto bent = sharedMeshFile(file("out.vtu"));
    QVERIFY(difference(pointsOf(*sharedMeshFile(file("out.obj"))), expected) < tolerance);
    QVERIFY(difference(pointsOf(*bent), expected) < tolerance);
    if (across != 2) QVERIFY(difference(rows(text("out.csv")), expected) < tolerance);
    for (const MeshField& field : fieldsOf(*bent)) {
        const auto count = static_cast<Eigen::Index>(field.values.size()) / field.components;
        if (field.name == "displacement") {
            const Points3 moved = mesh.points + Eigen::Map<const Points3>(field.values.data(), 3, count);
            QVERIFY(difference(moved, expected) < tolerance);
        }
        if (field.name != "F") continue;
        for (Eigen::Index c = 0; c < count; ++c) {
            const Eigen::Matrix3d F =
                Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&field.values[9 * c]);
            QVERIFY((F - rotation).cwiseAbs().maxCoeff() < tolerance);
        }
    }
}

void TestPointsCli::noPlane() {
    MeshFile mesh = toMeshFile<2>(stripMesh(10, 2));
    mesh.points(2, 16) = 1e-4;
    writeMeshFile(file("bumpy.obj"), mesh);
    putProject(path(), "bumpy.wend", "'domain': {'mesh': 'bumpy.obj'}, 'handles': []");
    const CliResult result = run({"run", "bumpy.wend", "--mesh", "out.obj"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.contains("bumpy.obj: the triangles do not lie in a plane"),
             qPrintable(result.error));
}

/// At 2^23 consecutive floats are 1 apart, so that a quarter is lost.
void TestPointsCli::singlePrecision() {
    SimplicialMesh<2> strip = stripMesh(10, 2);
    strip.points.row(0).array() += 8388608.25;
    writeMesh<2>(file("far.obj"), strip);
    putProject(path(), "far.wend", "'domain': {'mesh': 'far.obj'}, 'handles': [{'at': {'vertices': [0]}}]");
    const CliResult binary = run({"run", "far.wend", "--mesh", "far.stl", "--encoding", "binary"});
    QVERIFY2(binary.error.contains("far.stl: single precision moves vertices by up to 0.25, because"),
             qPrintable(binary.error));
    const CliResult written = run({"run", "far.wend", "--mesh", "far-text.stl"});
    QVERIFY2(!written.error.contains("single precision"), qPrintable(written.error));
    const CliResult near = run({"run", "bend2.wend", "--mesh", "near.stl", "--encoding", "binary"});
    QVERIFY2(!near.error.contains("single precision"), qPrintable(near.error));
    const CliResult converted = run({"convert", "far.obj", "converted.stl", "--encoding", "binary"});
    QVERIFY2(converted.error.contains("converted.stl: single precision moves vertices by up to 0.25"),
             qPrintable(converted.error));
}

void TestPointsCli::carriedDetail_data() {
    QTest::addColumn<QString>("detail");
    QTest::addColumn<QString>("out");
    QTest::addColumn<QString>("kept");
    QTest::newRow("cloud") << "cloud.ply"
                           << "out.ply"
                           << "property uchar red\n";
    QTest::newRow("cloud as OBJ") << "cloud.ply"
                                  << "out.obj"
                                  << "";
    QTest::newRow("polylines") << "lines.obj"
                               << "out.obj"
                               << "l 1 2 3 4\nl 5 6\n";
    QTest::newRow("polylines as PLY") << "lines.obj"
                                      << "out.ply"
                                      << "element edge 4\n";
}

/// Points and lines of `domain.detail`, inside and outside the solid, rotate with it.
void TestPointsCli::carriedDetail() {
    QFETCH(QString, detail);
    QFETCH(QString, out);
    QFETCH(QString, kept);
    const Points3 points = putClouds(Vec3(-1, -1, -1), Vec3(11, 3, 3));
    putProject(path(), "detail.wend",
               "'domain': {'mesh': 'bar.mesh', 'detail': '" + detail.toStdString() + "'}, 'handles': [" +
                   turned(3) + "]");
    succeed({"run", "detail.wend", "--mesh", out, "--mesh", "out.vtu"});
    const Points3 expected = turnedPoints(points);
    QVERIFY(difference(readMeshFile(file(out.toStdString()), MeshNeeds::Points).points, expected) < 1e-12);
    QVERIFY(text(out.toStdString()).find(kept.toStdString()) != std::string::npos);
    QCOMPARE(tetrahedraOf(*sharedMeshFile(file("out.vtu"))), readMesh<3>(file("bar.mesh")).cells);
    for (const char* wrong : {"out.stl", "out.glb"}) {
        const CliResult result = run({"run", "detail.wend", "--mesh", wrong});
        QCOMPARE(result.code, 3);
        QVERIFY2(result.error.contains("the format cannot hold points and lines without triangles"),
                 qPrintable(result.error));
    }
}

void TestPointsCli::bad_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const QStringList& arguments, int code, const char* message) {
        QTest::newRow(name) << arguments << code << message;
    };
    row("one file", {"--points", "in.csv"}, 2, "--points needs two files, IN and OUT");
    row("inverse alone", {"--inverse", "--mesh", "o.obj"}, 2, "--inverse is for --points");
    row("its own input", {"--points", "good.csv", "good.csv"}, 2, "good.csv: would replace good.csv");
    row("another's input", {"--points", "good.csv", "o.csv", "--points", "good.txt", "good.csv"}, 2,
        "good.csv: would replace good.csv");
    row("two of one name", {"--points", "good.csv", "o.csv", "--points", "good.txt", "o.csv"}, 2,
        "would replace another output");
    row("unknown input", {"--points", "good.foo", "o.csv"}, 3, "good.foo: is in no known format of points");
    row("unknown output", {"--points", "good.csv", "o.foo"}, 3, "o.foo: is in no known format of points");
    row("missing", {"--points", "missing.csv", "o.csv"}, 3, "missing.csv: ");
    row("a word", {"--points", "word.csv", "o.csv"}, 3, "word.csv: line 3: 'abc' is not a number");
    row("not finite", {"--points", "nan.csv", "o.csv"}, 3, "nan.csv: line 2: 'nan' is not a number");
    row("a short row", {"--points", "short.csv", "o.csv"}, 3, "short.csv: line 3: has 1 column");
    row("no points", {"--points", "none.csv", "o.csv"}, 3, "none.csv: has no row of 2 numbers (x, y)");
    row("points in STL", {"--points", "good.csv", "o.stl"}, 3, "o.stl: the format cannot hold points");
    row("tetrahedra in PLY", {"--points", "bar.mesh", "o.ply"}, 3, "o.ply: the format cannot hold the tetra");
}

void TestPointsCli::bad() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, message);
    put(path(), "good.csv", "x,y\n1,1\n");
    put(path(), "good.txt", "1 1\n");
    put(path(), "word.csv", "x,y\n1,1\nabc,1\n");
    put(path(), "nan.csv", "x,y\nnan,1\n");
    put(path(), "short.csv", "x,y\n1,1\n1\n");
    put(path(), "none.csv", "hello\n");
    const CliResult result = run(QStringList{"run", "bend2.wend"} + arguments);
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
    QCOMPARE(result.code, code);
    QCOMPARE(text("good.csv"), std::string("x,y\n1,1\n"));
    for (const char* left : {"o.csv", "o.obj", "o.stl", "o.ply"})
        QVERIFY(!QFile::exists(path() + "/" + left));
}

QTEST_GUILESS_MAIN(TestPointsCli)
#include "test_points_cli.moc"
