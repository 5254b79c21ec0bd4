// Stiffness along the normal of a wall, values of cells by the names of fields, and handles of flat meshes in
// planes other than that of x and y.

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>

#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/pictures.h"

using namespace wend;

class TestWallsCli : public QObject {
    Q_OBJECT

  private slots:
    void normalsOfARing();
    void layersKeepTheirHeight();
    void savedAsRead();
    void cellsByName_data();
    void cellsByName();
    void badInput_data();
    void badInput();
    void openFoamCase();
    void otherPlanes_data();
    void otherPlanes();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0, qPrintable(QString::number(result.code) + result.error));
    }
    Points3 pointsIn(const char* name) const { return pointsOf(*sharedMeshFile(file(name))); }
    void putRing() const;

    QTemporaryDir m_folder;
};

namespace {

std::string digits(double x) {
    return QString::number(x, 'g', 17).toStdString();
}

const MeshField* fieldOf(const MeshFile& file, const std::string& name) {
    for (const MeshField& field : file.fields)
        if (field.name == name) return &field;
    return nullptr;
}

constexpr int kAround = 96, kLayers = 8;

/// A strip whose bottom is a group of lines, in Medit's format.
std::string stripText(const SimplicialMesh<2>& strip, int bottomLines) {
    std::string text =
        "MeshVersionFormatted 2\nDimension 2\nVertices\n" + std::to_string(strip.vertexCount()) + "\n";
    for (Eigen::Index v = 0; v < strip.points.cols(); ++v)
        text += digits(strip.points(0, v)) + " " + digits(strip.points(1, v)) + " 0\n";
    text += "Edges\n" + std::to_string(bottomLines) + "\n";
    for (int i = 1; i <= bottomLines; ++i) text += std::to_string(i) + " " + std::to_string(i + 1) + " 5\n";
    text += "Triangles\n" + std::to_string(strip.cellCount()) + "\n";
    for (const auto& t : strip.cells)
        text += std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) +
                " 1\n";
    return text + "End\n";
}

}  // namespace

/// A ring of radii 1 to 2 whose inner circle is the group 5.
void TestWallsCli::putRing() const {
    std::string text =
        "MeshVersionFormatted 2\nDimension 2\nVertices\n" + std::to_string(kAround * (kLayers + 1)) + "\n";
    for (int j = 0; j <= kLayers; ++j)
        for (int i = 0; i < kAround; ++i) {
            const double r = 1 + double(j) / kLayers, angle = 2 * std::numbers::pi * i / kAround;
            text += digits(r * std::cos(angle)) + " " + digits(r * std::sin(angle)) + " 0\n";
        }
    text += "Edges\n" + std::to_string(kAround) + "\n";
    for (int i = 0; i < kAround; ++i)
        text += std::to_string(i + 1) + " " + std::to_string((i + 1) % kAround + 1) + " 5\n";
    text += "Triangles\n" + std::to_string(2 * kAround * kLayers) + "\n";
    for (int j = 0; j < kLayers; ++j)
        for (int i = 0; i < kAround; ++i) {
            const int a = j * kAround + i + 1, b = j * kAround + (i + 1) % kAround + 1, c = b + kAround,
                      d = a + kAround;
            text += std::to_string(a) + " " + std::to_string(c) + " " + std::to_string(b) + " 1\n";
            text += std::to_string(a) + " " + std::to_string(d) + " " + std::to_string(c) + " 1\n";
        }
    put(path(), "ring.mesh", text + "End\n");
}

/// B is I + (s − 1) n nᵀ with the radial direction n within the distance, and I beyond.
void TestWallsCli::normalsOfARing() {
    putRing();
    putProject(
        path(), "ring.wend",
        "'domain': {'mesh': 'ring.mesh'}, 'material': {'regions': [{'shape': {'circle': {'centre': [0, 0], "
        "'radius': 9}}, 'stiffness': {'axis': 'normal of 5', 'ratio': 20, 'within': 0.3}}]}, 'handles': "
        "[{'at': {'group': '5'}}]");
    succeed({"run", "ring.wend", "--mesh", "ring.vtu"});
    const MeshFile out = readMeshFile(file("ring.vtu"));
    const MeshField* B = fieldOf(out, "B");
    QVERIFY(B && B->components == 4);
    int within = 0;
    for (std::size_t c = 0; c < out.triangles.size(); ++c) {
        Vec2 centre = Vec2::Zero();
        for (const int v : out.triangles[c]) centre += out.points.col(v).head<2>() / 3;
        const Vec2 n = centre.normalized();
        const bool isWithin = centre.norm() < 1.3;
        within += isWithin;
        const Mat2 expected = isWithin ? Mat2(Mat2::Identity() + 19 * n * n.transpose()) : Mat2::Identity();
        const Mat2 found = Eigen::Map<const Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>(&B->values[4 * c]);
        // The foot on a chord of the circle is off by the distance times the angle from the chord's middle.
        constexpr double kAngle = 0.3 * std::numbers::pi / kAround,
                         kError = 19 * std::numbers::sqrt2 * kAngle;
        QVERIFY2((found - expected).norm() < kError, qPrintable(QString::number((found - expected).norm())));
    }
    QVERIFY(within > 2 * kAround);
}

/// A strip that keeps its area gets thinner when it is stretched, except for the part that is stiff across
/// it.
void TestWallsCli::layersKeepTheirHeight() {
    const SimplicialMesh<2> strip = stripMesh(20, 6);
    put(path(), "strip.mesh", stripText(strip, 20));
    const auto project = [](const std::string& material) {
        return "'domain': {'mesh': 'strip.mesh'}, 'material': {'phi': 'equia'" + material +
               "}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1], 'max': [0.1, 7]}}}, 'hold': "
               "['x']}, "
               "{'at': {'region': {'box': {'min': [19.9, -1], 'max': [21, 7]}}}, 'hold': ['x'], 'motion': "
               "[{'kind': 'translate', 'by': [6, 0], 'time': [0, 1]}]}, {'at': {'group': '5'}, 'hold': "
               "['y']}]";
    };
    putProject(path(), "soft.wend", project(""));
    putProject(
        path(), "stiff.wend",
        project(", 'regions': [{'shape': {'halfspace': {'point': [0, -1], 'normal': [0, 1]}}, 'stiffness': "
                "{'axis': 'normal of 5', 'ratio': 300, 'within': 2}}]"));
    const auto heightOf = [&](const char* name) {  // of the first layer in the middle
        const Points3 points = pointsIn(name);
        return points(1, 21 + 10) - points(1, 10);
    };
    succeed({"run", "soft.wend", "--mesh", "soft.mesh"});
    succeed({"run", "stiff.wend", "--mesh", "stiff.mesh"});
    const double soft = std::abs(heightOf("soft.mesh") - 1), stiff = std::abs(heightOf("stiff.mesh") - 1);
    QVERIFY2(soft > 0.1 && stiff < soft / 2, qPrintable(QString("%1 %2").arg(soft).arg(stiff)));
}

void TestWallsCli::savedAsRead() {
    putRing();
    const std::string path = file("saved.wend");
    putProject(
        this->path(), "saved.wend",
        "'domain': {'mesh': 'ring.mesh'}, 'material': {'regions': [{'shape': {'circle': {'centre': [0, 0], "
        "'radius': 9}}, 'stiffness': {'axis': 'normal of 5', 'ratio': 20, 'within': 0.3}}], 'cells': "
        "{'file': 'values.vtu', 'phi': 'angle', 'B': 'tensor'}}");
    const std::string text = toJson(*readProject(path).project);
    for (const char* part : {"\"axis\": \"normal of 5\"", "\"within\": 0.3", "\"file\": \"values.vtu\"",
                             "\"phi\": \"angle\"", "\"B\": \"tensor\""})
        QVERIFY2(text.find(part) != std::string::npos, part);
    QCOMPARE(toJson(*parseProject(text, path).project), text);
}

void TestWallsCli::cellsByName_data() {
    QTest::addColumn<int>("components");
    for (const int components : {3, 4, 6, 9}) QTest::addRow("%d numbers", components) << components;
}

/// A field gives the same shape as its values in the project.
void TestWallsCli::cellsByName() {
    QFETCH(int, components);
    const SimplicialMesh<2> strip = stripMesh(6, 2);
    writeMesh<2>(file("s.obj"), strip);
    MeshFile values = toMeshFile<2>(strip);
    MeshField angle{"angle", true, 1, {}}, tensor{"tensor", true, components, {}}, other{"B", true, 4, {}};
    std::string phi, B;
    for (int c = 0; c < strip.cellCount(); ++c) {
        const double x = 1 + 0.1 * c, y = 2 + 0.05 * c, xy = 0.3;
        angle.values.push_back(0.3 + 0.02 * c);
        const std::vector<std::vector<double>> kinds{
            {x, y, xy}, {x, xy, xy, y}, {x, y, 1, xy, 0, 0}, {x, xy, 0, xy, y, 0, 0, 0, 1}};
        for (const auto& numbers : kinds)
            if (std::ssize(numbers) == components)
                tensor.values.insert(tensor.values.end(), numbers.begin(), numbers.end());
        other.values.insert(other.values.end(), {1, 0, 0, 1});
        phi += (c > 0 ? ", " : "") + digits(angle.values.back());
        B += (c > 0 ? ", [[" : "[[") + digits(x) + ", 0.3], [0.3, " + digits(y) + "]]";
    }
    values.fields = {angle, tensor, other};
    writeMeshFile(file("values.vtu"), values);
    const std::string handles =
        "}, 'handles': [{'at': {'vertices': [0, 7, 14]}}, {'at': {'vertices': [6, 13, 20]}, 'motion': "
        "[{'kind': "
        "'translate', 'by': [1, 1], 'time': [0, 1]}]}]";
    putProject(
        path(), "named.wend",
        "'domain': {'mesh': 's.obj'}, 'material': {'cells': {'file': 'values.vtu', 'phi': 'angle', 'B': "
        "'tensor'}" +
            handles);
    putProject(path(), "inline.wend",
               "'domain': {'mesh': 's.obj'}, 'material': {'cells': {'phi': [" + phi + "], 'B': [" + B + "]}" +
                   handles);
    succeed({"run", "named.wend", "--mesh", "named.obj"});
    succeed({"run", "inline.wend", "--mesh", "inline.obj"});
    QCOMPARE((pointsIn("named.obj") - pointsIn("inline.obj")).cwiseAbs().maxCoeff(), 0.0);
}

void TestWallsCli::badInput_data() {
    QTest::addColumn<QString>("material");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* material, const char* message) {
        QTest::newRow(name) << QString(material) << QString(message);
    };
    const char* region =
        "'regions': [{'shape': {'circle': {'centre': [0, 0], 'radius': 9}}, 'stiffness': {'axis': %1, "
        "'ratio': 2%2}}]";
    const auto stiffness = [&](const char* axis, const char* more) {
        return QString(region).arg(axis, more);
    };
    QTest::newRow("no such group") << stiffness("'normal of inlet'", "")
                                   << "material.regions[0].stiffness.axis: ";
    QTest::newRow("no wall") << stiffness("[1, 0]", ", 'within': 1") << "within: is the distance from a wall";
    QTest::newRow("a word") << stiffness("'across'", "")
                            << "must be a direction, such as [0, 1], or \"normal of";
    row("no such field", "'cells': {'file': 'ring.vtu', 'B': 'stiff'}", "has no values stiff per cell");
}

void TestWallsCli::badInput() {
    putRing();
    succeed({"convert", "ring.mesh", "ring.vtu"});
    QFETCH(QString, material);
    QFETCH(QString, message);
    putProject(path(), "bad.wend",
               "'domain': {'mesh': 'ring.mesh'}, 'material': {" + material.toStdString() + "}");
    const CliResult result = run({"run", "bad.wend", "--mesh", "o.mesh"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
}

/// A case of one hexahedron: only its points are written, and never over those that were read.
void TestWallsCli::openFoamCase() {
    const QString mesh = path() + "/case/constant/polyMesh/", copy = path() + "/bent/constant/polyMesh/";
    for (const QString& folder : {mesh, copy}) QVERIFY(QDir().mkpath(folder));
    const std::string head = "FoamFile { version 2.0; format ascii; class x; object y; }\n";
    const std::string points =
        head + "8\n(\n(0 0 0)\n(1 0 0)\n(1 1 0)\n(0 1 0)\n(0 0 1)\n(1 0 1)\n(1 1 1)\n(0 1 1)\n)\n";
    put(mesh, "points", points);
    put(mesh, "faces",
        head + "6\n(\n4(0 3 2 1)\n4(4 5 6 7)\n4(0 1 5 4)\n4(1 2 6 5)\n4(2 3 7 6)\n4(3 0 4 7)\n)\n");
    put(mesh, "owner", head + "6\n(\n0\n0\n0\n0\n0\n0\n)\n");
    put(mesh, "neighbour", head + "0\n(\n)\n");
    put(mesh, "boundary",
        head +
            "2\n(\n floor { type wall; nFaces 1; startFace 0; }\n lid { type wall; nFaces 1; startFace 1; "
            "}\n)\n");
    put(path() + "/case", "case.foam", "");
    putProject(
        path(), "case.wend",
        "'domain': {'mesh': 'case/case.foam'}, 'handles': [{'at': {'group': 'floor'}}, {'at': {'group': "
        "'lid'}, 'motion': [{'kind': 'translate', 'by': [0.25, 0, 0], 'time': [0, 1]}]}]");
    succeed({"run", "case.wend", "--mesh", "bent/constant/polyMesh/points"});
    QFile written(copy + "points");
    QVERIFY(written.open(QIODevice::ReadOnly));
    QString expected = QString::fromStdString(points);
    for (const auto& [from, to] : {std::pair{"(0 0 1)", "(0.25 0 1)"}, std::pair{"(1 0 1)", "(1.25 0 1)"},
                                   std::pair{"(1 1 1)", "(1.25 1 1)"}, std::pair{"(0 1 1)", "(0.25 1 1)"}})
        expected.replace(from, to);
    QCOMPARE(QString::fromUtf8(written.readAll()), expected);
    for (const char* taken : {"case/constant/polyMesh/points", "case/case.foam"})
        QVERIFY(run({"run", "case.wend", "--mesh", taken}).code != 0);
    const CliResult other = run({"convert", "case/case.foam", "out.foam"});
    QVERIFY2(other.code != 0, qPrintable(other.error));
}

void TestWallsCli::otherPlanes_data() {
    QTest::addColumn<int>("turn");
    QTest::newRow("x and z") << 0;
    QTest::newRow("y and z") << 1;
    QTest::newRow("tilted") << 2;
}

/// A strip that is rotated in space with its handles has the rotated pose.
void TestWallsCli::otherPlanes() {
    QFETCH(int, turn);
    Mat3 R;
    if (turn == 0)
        R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    else if (turn == 1)
        R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    else
        R = Eigen::AngleAxisd(0.7, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    const SimplicialMesh<2> strip = stripMesh(8, 2);
    MeshFile flat = toMeshFile<2>(strip);
    MeshField u{"u", false, 3, {}};
    for (int v = 0; v < strip.vertexCount(); ++v) {
        const Vec2 p = strip.points.col(v);
        u.values.insert(u.values.end(), {0.1 * p.y(), 0.4 + 0.05 * p.x(), 0});
    }
    flat.fields = {u};
    MeshFile turned = flat;
    turned.points = R * flat.points;
    for (std::size_t i = 0; i < turned.fields[0].values.size(); i += 3) {
        Eigen::Map<Vec3> value(&turned.fields[0].values[i]);
        value = (R * value).eval();
    }
    writeMeshFile(file("flat.vtu"), flat);
    writeMeshFile(file("turned.vtu"), turned);
    // The path extends over both ends of the strip.
    const Points3 path3 = R * (Points3(3, 3) << 0, 0.05, 0, -1, 1, 3, 0, 0, 0).finished();
    std::string flatPath, turnedPath;
    for (int k = 0; k < 3; ++k) {
        const Vec3 p = R.transpose() * path3.col(k), q = path3.col(k);
        flatPath += "v " + digits(p.x()) + " " + digits(p.y()) + " " + digits(p.z()) + "\n";
        turnedPath += "v " + digits(q.x()) + " " + digits(q.y()) + " " + digits(q.z()) + "\n";
    }
    put(path(), "flat.obj", flatPath + "l 1 2 3\n");
    put(path(), "turned.obj", turnedPath + "l 1 2 3\n");
    for (const char* name : {"flat", "turned"})
        putProject(path(), (std::string(name) + ".wend").c_str(),
                   "'domain': {'mesh': '" + std::string(name) +
                       ".vtu'}, 'handles': [{'at': {'vertices': [0, 9, 18]}, 'hold': {'slide': '" + name +
                       ".obj'}}, {'at': {'vertices': [8, 17, 26]}, 'motion': [{'kind': 'field', 'file': '" +
                       name + ".vtu', 'array': 'u', 'time': [0, 1]}]}]");
    succeed({"run", "flat.wend", "--mesh", "flat_out.vtu"});
    succeed({"run", "turned.wend", "--mesh", "turned_out.vtu"});
    const Points3 a = R * pointsIn("flat_out.vtu"), b = pointsIn("turned_out.vtu");
    QVERIFY((a - turned.points).cwiseAbs().maxCoeff() > 0.3);
    // Rotated coordinates round differently: far below the tolerance of the integration, 1e-4 of the size.
    QVERIFY2((a - b).cwiseAbs().maxCoeff() < 1e-5,
             qPrintable(QString::number((a - b).cwiseAbs().maxCoeff())));
}

QTEST_GUILESS_MAIN(TestWallsCli)
#include "test_walls_cli.moc"
