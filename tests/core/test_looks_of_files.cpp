// Colours and normals of vertices and faces, and integers of eight bytes, are read, written and kept through
// files.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>
#include <QtTest>
#include <algorithm>
#include <cstring>
#include <numbers>

#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"
#include "test_mesh_files.h"

using namespace wend;

namespace {

const std::string kPyramid =
    "0 0 0 255 0 0 255 0.25 0.5\n2 0 0 0 255 0 255 1 0\n2 2 0 0 0 255 255 1 1\n0 2 0 51 102 204 128 0 1\n"
    "1 1 2 255 255 255 255 0.5 0.5\n";

std::vector<double> valuesOf(const MeshFile& file, const std::string& name, bool perCell = false) {
    for (const MeshField& field : file.fields)
        if (field.name == name && field.perCell == perCell)
            return field.ofCells.empty() ? field.values : field.ofCells;
    return {};
}

QByteArray bytesOf(const std::string& path) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The first attribute of that name in a binary glTF file, as its floats.
std::vector<float> attribute(const std::string& path, const char* name) {
    const QByteArray bytes = bytesOf(path);
    const auto length = static_cast<int>(qFromLittleEndian<quint32>(bytes.constData() + 12));
    const QJsonObject gltf = QJsonDocument::fromJson(bytes.mid(20, length)).object();
    const QJsonObject primitive =
        gltf["meshes"].toArray()[0].toObject()["primitives"].toArray()[0].toObject();
    const QJsonValue index = primitive["attributes"].toObject()[name];
    if (!index.isDouble()) return {};
    const QJsonObject accessor = gltf["accessors"].toArray()[index.toInt()].toObject();
    const QJsonObject view = gltf["bufferViews"].toArray()[accessor["bufferView"].toInt()].toObject();
    std::vector<float> values(static_cast<std::size_t>(view["byteLength"].toInt()) / 4);
    std::memcpy(values.data(), bytes.constData() + 28 + length + view["byteOffset"].toInt(),
                4 * values.size());
    return values;
}

/// Implements IEC 61966-2-1 independently.
double light(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

}  // namespace

class TestLooksOfFiles : public QObject {
    Q_OBJECT
  private slots:
    void coloursAndTextureOfOff();
    void coloursOfFaces();
    void normalsOfOff();
    void someFacesHaveColours();
    void coloursInGltf();
    void coloursOfFacesAreMaterials();
    void normalsOfObj();
    void normalsOfCornersAreReported();
    void longWholeNumbers_data();
    void longWholeNumbers();
    void textureOfCorners();
    void textureOfSomeFaces();
    void namesThatWouldBeEqual_data();
    void namesThatWouldBeEqual();
    void fieldsThatWouldBeEqual();
    void objectsOfObj();
    void listsAndEdgesOfPly();
    void timesOfGmsh();
    void cellsOfHigherOrderInMedit();
    void attributesOfTetgenAreKept();
    void whatGltfLacks();
    void valuesThatFormatsLack();
};

void TestLooksOfFiles::coloursAndTextureOfOff() {
    const samples::Folder folder;
    const MeshFile file =
        readMeshFile(folder.put("a.off", "STCOFF\n5 2 0\n" + kPyramid + "4 0 3 2 1\n3 0 1 4\n"));
    QCOMPARE(valuesOf(file, "blue"), (std::vector<double>{0, 0, 255, 204, 255}));
    QCOMPARE(valuesOf(file, "alpha"), (std::vector<double>{255, 255, 255, 128, 255}));
    QCOMPARE(file.uv(1, 0), 0.5);
    QVERIFY(lostInFile("a.off", file, {}).empty());
    writeMeshFile(folder.path("b.off"), file);
    QCOMPARE(bytesOf(folder.path("b.off")).toStdString(),
             "STCOFF\n5 2 0\n" + kPyramid + "4 0 3 2 1\n3 0 1 4\n");
    writeMeshFile(folder.path("b.ply"), file);
    const QByteArray ply = bytesOf(folder.path("b.ply"));
    QVERIFY(ply.contains("property uchar red\n") && ply.contains("property uchar alpha\n"));
    writeMeshFile(folder.path("b.obj"), file);
    QVERIFY(bytesOf(folder.path("b.obj")).startsWith("v 0 0 0 1 0 0\n"));
}

/// Numbers from 0 to 1 stay numbers from 0 to 1 where bytes would round them.
void TestLooksOfFiles::coloursOfFaces() {
    const samples::Folder folder;
    const std::string points = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    for (const std::string faces :
         {"3 0 1 2 255 128 0\n3 0 2 3 1 2 3\n", "3 0 1 2 0.125 0.25 0\n3 0 2 3 0.5 1 0\n",
          "3 0 1 2 255 0 0 128\n3 0 2 3 1 2 3 255\n"}) {
        const MeshFile file = readMeshFile(folder.put("a.off", points + faces));
        QCOMPARE(valuesOf(file, "green", true).size(), std::size_t(2));
        writeMeshFile(folder.path("b.off"), file);
        QCOMPARE(bytesOf(folder.path("b.off")).toStdString(), points + faces);
    }
}

void TestLooksOfFiles::normalsOfOff() {
    const samples::Folder folder;
    const std::string text = "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0.5 0.75\n1 1 0 1 0 0\n3 0 1 2\n";
    const MeshFile file = readMeshFile(folder.put("a.off", text));
    QCOMPARE(valuesOf(file, "nz"), (std::vector<double>{1, 0.75, 0}));
    writeMeshFile(folder.path("b.off"), file);
    QCOMPARE(bytesOf(folder.path("b.off")).toStdString(), text);
}

void TestLooksOfFiles::someFacesHaveColours() {
    const samples::Folder folder;
    const MeshFile file = readMeshFile(
        folder.put("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3\n"));
    QVERIFY(file.fields.empty());
    QCOMPARE(file.notices, std::vector<std::string>{"the colours of 1 of its 2 faces"});
}

/// Colours are light in glTF, and come back as they were.
void TestLooksOfFiles::coloursInGltf() {
    const samples::Folder folder;
    const std::string path =
        folder.put("a.off",
                   "COFF\n4 4 0\n0 0 0 255 0 0 255\n2 0 0 0 128 0 255\n0 2 0 51 102 204 255\n"
                   "0 0 2 10 10 10 255\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    const Skin skin = readSkin(path);
    writeSkin(folder.path("b.glb"), skin, skin.points);
    const std::vector<float> colours = attribute(folder.path("b.glb"), "COLOR_0");
    QCOMPARE(colours.size(), std::size_t(16));
    const double expected[] = {255, 0, 0, 0, 128, 0, 51, 102, 204, 10, 10, 10};
    for (std::size_t v = 0; v < 4; ++v) {
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs(colours[4 * v + k] - light(expected[3 * v + k] / 255)) < 1e-6);
        QCOMPARE(colours[4 * v + 3], 1.0F);
    }
    const MeshFile back = readMeshFile(folder.path("b.glb"));
    QCOMPARE(valuesOf(back, "red"), (std::vector<double>{255, 0, 51, 10}));
    QCOMPARE(valuesOf(back, "blue"), (std::vector<double>{0, 0, 204, 10}));
}

void TestLooksOfFiles::coloursOfFacesAreMaterials() {
    const samples::Folder folder;
    const Skin skin = readSkin(folder.put(
        "a.off",
        "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n3 0 3 1 255 0 0\n"));
    QCOMPARE(skin.materialOf, (std::vector<int>{0, 1, 0}));
    QCOMPARE(skin.materials[0].colour, (std::array<float, 4>{1, 0, 0, 1}));
    QCOMPARE(skin.materials[1].colour, (std::array<float, 4>{0, 0, 1, 1}));
}

/// A quarter turn of the surface turns the normals that the file has, which need not be its own.
void TestLooksOfFiles::normalsOfObj() {
    const samples::Folder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", normals = "vn 0 0 1\nvn 0 0.6 0.8\n";
    const std::string path = folder.put("a.obj", points + normals + "f 1//1 2//1 3//2 4//2\n");
    const MeshFile file = readMeshFile(path);
    QCOMPARE(valuesOf(file, "nz"), (std::vector<double>{1, 1, 0.8, 0.8}));
    writeMeshFile(folder.path("b.ply"), file);
    QVERIFY(bytesOf(folder.path("b.ply")).contains("property double nx\n"));
    const Skin skin = readSkin(path);
    Points3 turned(3, 4);
    turned.row(0) = skin.points.row(0);
    turned.row(1) = -skin.points.row(2);
    turned.row(2) = skin.points.row(1);
    writeSkin(folder.path("b.obj"), skin, turned);
    const MeshFile back = readMeshFile(folder.path("b.obj"));
    const double expected[4][3] = {{0, -1, 0}, {0, -1, 0}, {0, -0.8, 0.6}, {0, -0.8, 0.6}};
    const char* names[] = {"nx", "ny", "nz"};
    for (int k = 0; k < 3; ++k) {
        const std::vector<double> values = valuesOf(back, names[k]);
        QCOMPARE(values.size(), std::size_t(4));
        for (std::size_t v = 0; v < 4; ++v) QVERIFY(std::abs(values[v] - expected[v][k]) < 1e-15);
    }
}

void TestLooksOfFiles::normalsOfCornersAreReported() {
    const samples::Folder folder;
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvn 0 0 1\nvn 0 0.6 0.8\n"
        "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n";
    const MeshFile file = readMeshFile(folder.put("a.obj", text));
    QCOMPARE(lostInFile("b.ply", file, {}),
             std::string("its list of normals of corners is not in a PLY file"));
    const Skin skin = readSkin(folder.path("a.obj"));
    writeSkin(folder.path("b.obj"), skin, skin.points);
    QCOMPARE(bytesOf(folder.path("b.obj")).toStdString(), text);
    Points3 turned = skin.points;
    turned.row(1).swap(turned.row(2));
    turned.row(1) *= -1;
    writeSkin(folder.path("c.obj"), skin, turned);
    const QByteArray other = bytesOf(folder.path("c.obj"));
    QCOMPARE(other.count("vn "), 6);  // one for each corner's vertex and normal
    QVERIFY(other.contains("f 1//4 3//5 4//6\n"));
}

void TestLooksOfFiles::longWholeNumbers_data() {
    QTest::addColumn<std::string>("type");
    QTest::addColumn<std::string>("numbers");  // of the vertices, then of the cell
    QTest::newRow("signed") << std::string("vtktypeint64")
                            << std::string(
                                   "1152921504606846977 -9007199254740993 9223372036854775807 "
                                   "-9223372036854775808 1152921504606846979");
    QTest::newRow("unsigned") << std::string("unsigned_long")
                              << std::string(
                                     "9223372036854775808 18446744073709551615 9007199254740993 0 "
                                     "18446744073709550593");
}

/// Most of the numbers have no exact double. They are the same text after every encoding of both families.
void TestLooksOfFiles::longWholeNumbers() {
    QFETCH(std::string, type);
    QFETCH(std::string, numbers);
    const samples::Folder folder;
    const std::size_t last = numbers.rfind(' ');
    const std::string text =
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
        "POINT_DATA 4\nFIELD FieldData 1\nids 1 4 " +
        type + '\n' + numbers.substr(0, last) + "\nCELL_DATA 1\nFIELD FieldData 1\nid 1 1 " + type + '\n' +
        numbers.substr(last + 1) + '\n';
    using enum MeshWriteOptions::Encoding;
    std::string path = folder.put("a.vtk", text);
    const std::pair<const char*, MeshWriteOptions> ways[] = {{"b.vtu", {}},
                                                             {"c.vtk", {Binary, false, false, 4}},
                                                             {"d.vtu", {Binary, false, false, 4}},
                                                             {"e.vtu", {Compressed, false, true, 4}},
                                                             {"f.vtk", {}}};
    for (const auto& [name, options] : ways) {
        writeMeshFile(folder.path(name), readMeshFile(path), options);
        path = folder.path(name);
    }
    const QByteArray written = bytesOf(path);
    for (const QByteArray& number : QByteArray::fromStdString(numbers).split(' '))
        QVERIFY2(written.contains('\n' + number + '\n'), number);
    const MeshFile file = readMeshFile(path);
    QVERIFY(lostInFile("g.vtu", file, {}).empty());
    QCOMPARE(lostInFile("g.xdmf", file, {}), std::string("whole numbers of 2 fields are rounded to 53 bits"));
}

namespace {

/// Returns u and v of the corners of all faces of an OBJ file, read word by word; (−1, −1) where there are
/// none.
std::vector<std::pair<double, double>> cornersOfObj(const QByteArray& text) {
    std::vector<std::pair<double, double>> points, corners;
    for (const QByteArray& line : text.split('\n')) {
        const QList<QByteArray> words = line.simplified().split(' ');
        if (words[0] == "vt") points.emplace_back(words[1].toDouble(), words[2].toDouble());
        if (words[0] != "f") continue;
        for (const QByteArray& word : words.mid(1)) {
            const QList<QByteArray> numbers = word.split('/');
            const int number = numbers.size() > 1 ? numbers[1].toInt() : 0;
            corners.push_back(number > 0 ? points[static_cast<std::size_t>(number) - 1]
                                         : std::pair(-1., -1.));
        }
    }
    return corners;
}

/// A pyramid of three triangles and a square without its base; each vertex has other texture points in every
/// face.
const std::string kCorners =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
    "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "3 0 2 1 6 0 0 1 0 0 1\n3 0 1 3 6 .5 0 1 .5 1 1\n3 1 2 3 6 0 .25 1 0 0 1\n3 2 0 3 6 0 0 .75 0 1 1\n";

}  // namespace

/// Several texture points of a vertex are kept by OBJ, PLY and glTF; other formats hold the first.
void TestLooksOfFiles::textureOfCorners() {
    const samples::Folder folder;
    const std::vector<std::pair<double, double>> expected{
        {0, 0}, {1, 0}, {0, 1}, {.5, 0}, {1, .5}, {1, 1}, {0, .25}, {1, 0}, {0, 1}, {0, 0}, {.75, 0}, {1, 1}};
    const MeshFile file = readMeshFile(folder.put("a.ply", kCorners));
    QCOMPARE(Eigen::Vector2d(file.uv.col(0)), Eigen::Vector2d(0, 0));  // the first of the vertex
    for (const auto& [name, encoding] : {std::pair("b.ply", MeshWriteOptions::Encoding::Text),
                                         std::pair("c.ply", MeshWriteOptions::Encoding::Binary)}) {
        QVERIFY(lostInFile(name, file, {}).empty());
        writeMeshFile(folder.path(name), file, {encoding, false, false, 4});
        writeMeshFile(folder.path("d.obj"), readMeshFile(folder.path(name)));
        QVERIFY(cornersOfObj(bytesOf(folder.path("d.obj"))) == expected);
    }
    QVERIFY(lostInFile("d.obj", file, {}).empty());
    const MeshFile again = readMeshFile(folder.path("d.obj"));
    writeMeshFile(folder.path("e.obj"), again);
    QVERIFY(cornersOfObj(bytesOf(folder.path("e.obj"))) == expected);
    for (const MeshFile& one : {file, again})
        QCOMPARE(lostInFile("a.vtu", one, {}),
                 std::string("texture coordinates that differ between the faces of a vertex are not in a VTU "
                             "(ParaView) file"));
    const Skin skin = readSkin(folder.path("a.ply"));
    QVERIFY(lostInSkin("a.glb", skin, {}).empty());
    writeSkin(folder.path("a.glb"), skin, skin.points);
    writeMeshFile(folder.path("f.obj"), readMeshFile(folder.path("a.glb")));
    QVERIFY(cornersOfObj(bytesOf(folder.path("f.obj"))) == expected);
}

/// Only the first of the faces has texture points.
void TestLooksOfFiles::textureOfSomeFaces() {
    const samples::Folder folder;
    const MeshFile file =
        readMeshFile(folder.put("a.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                "f 1/1 3/3 2/2\nf 1 2 4\nl 3 4\n"));
    const std::vector<std::pair<double, double>> expected{{0, 0},   {0, 1},   {1, 0},
                                                          {-1, -1}, {-1, -1}, {-1, -1}};
    QVERIFY(lostInFile("b.obj", file, {}).empty());
    writeMeshFile(folder.path("b.obj"), file);
    QVERIFY(cornersOfObj(bytesOf(folder.path("b.obj"))) == expected);
    QVERIFY(lostInFile("c.ply", file, {}).empty());
    writeMeshFile(folder.path("c.ply"), file);
    writeMeshFile(folder.path("d.obj"), readMeshFile(folder.path("c.ply")));
    QVERIFY(cornersOfObj(bytesOf(folder.path("d.obj"))) == expected);
    QCOMPARE(lostInFile("e.vtp", file, {}),
             std::string("texture coordinates that only some faces have are not in a VTP (ParaView) file"));
}

void TestLooksOfFiles::namesThatWouldBeEqual_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<QStringList>("names");
    const QString many(80, 'x'), accents = QString(39, 'x') + QString(22, QChar(0xe9));
    QTest::newRow("blank") << "a.obj"
                           << "a b"
                           << "a_b" << QStringList{"a_b_2", "a_b"};
    QTest::newRow("comma") << "a.inp"
                           << "a,b"
                           << "a_b" << QStringList{"a_b_2", "a_b"};
    QTest::newRow("case") << "a.inp"
                          << "Fix"
                          << "FIX" << QStringList{"Fix", "FIX_2"};
    QTest::newRow("long in MED") << "a.med" << many + "1" << many + "2"
                                 << QStringList{many, many.left(78) + "_2"};
    QTest::newRow("letters of two bytes") << "a.med" << accents + "1" << accents + "2"
                                          << QStringList{QString(39, 'x') + QString(20, QChar(0xe9)),
                                                         QString(39, 'x') + QString(19, QChar(0xe9)) + "_2"};
    QTest::newRow("quotes") << "a.msh"
                            << "a \"b\""
                            << "a 'b'" << QStringList{"a 'b'_2", "a 'b'"};
    QTest::newRow("different") << "a.inp"
                               << "left"
                               << "right" << QStringList{"left", "right"};
}

/// Two triangles in groups of these names are in two groups of other names behind a file, and a notice names
/// those that got a number.
void TestLooksOfFiles::namesThatWouldBeEqual() {
    QFETCH(QString, file);
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(QStringList, names);
    const samples::Folder folder;
    MeshFile mesh =
        readMeshFile(folder.put("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"));
    mesh.groups = {{first.toStdString(), 2, 0, {0}, {}}, {second.toStdString(), 2, 0, {1}, {}}};
    const std::string path = folder.path(file.toStdString()), lost = lostInFile(path, mesh, {});
    writeMeshFile(path, mesh);
    const MeshFile back = readMeshFile(path);
    QStringList found;
    for (const MeshGroup& group : back.groups) {
        QCOMPARE(group.cells.size(), std::size_t(1));
        found.push_back(QString::fromStdString(group.name));
    }
    found.sort();
    QStringList sorted = names;
    sorted.sort();
    QCOMPARE(found, sorted);
    for (const MeshGroup& group : back.groups)
        QCOMPARE(QString::fromStdString(group.name), names[group.cells[0]]);
    const QString numbered = names.filter("_2").join("");
    if (numbered.isEmpty())
        QVERIFY2(lost.empty(), lost.c_str());
    else
        QVERIFY2(QString::fromStdString(lost).endsWith(
                     "1 group is renamed, because another has the same name there (" + numbered + ")"),
                 lost.c_str());
}

void TestLooksOfFiles::fieldsThatWouldBeEqual() {
    const samples::Folder folder;
    MeshFile mesh = readMeshFile(folder.put("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"));
    mesh.fields = {{"a b", false, 1, {1, 2, 3}}, {"a_b", false, 1, {4, 5, 6}}, {"a b", true, 1, {7}}};
    for (MeshField& field : mesh.fields)
        if (field.perCell) field.ofCells = field.values;
    writeMeshFile(folder.path("a.ply"), mesh);
    const MeshFile back = readMeshFile(folder.path("a.ply"));
    QCOMPARE(valuesOf(back, "a_b_2"), (std::vector<double>{1, 2, 3}));
    QCOMPARE(valuesOf(back, "a_b"), (std::vector<double>{4, 5, 6}));
    QCOMPARE(valuesOf(back, "a_b", true), std::vector<double>{7});
    const std::string lost = lostInFile("a.ply", mesh, {});
    QVERIFY2(lost.ends_with("1 field is renamed, because another has the same name there (a_b_2)"),
             lost.c_str());
}

/// Groups within objects take the objects' place, which is named.
void TestLooksOfFiles::objectsOfObj() {
    const samples::Folder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const MeshFile file =
        readMeshFile(folder.put("a.obj", points + "o Head\ng left\nf 1 2 3\no Tail\nf 1 3 2\n"));
    QCOMPARE(lostInFile("a.msh", file, {}), std::string("its object 'Head' is not in a Gmsh file"));
    const MeshFile plain = readMeshFile(folder.put("a.obj", points + "g left\nf 1 2 3\no Tail\nf 1 3 2\n"));
    QVERIFY(lostInFile("a.msh", plain, {}).empty());
}

/// Lists of vertices and faces, and values of edges, are named if they are not written.
void TestLooksOfFiles::listsAndEdgesOfPly() {
    const samples::Folder folder;
    const MeshFile file = readMeshFile(
        folder.put("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nproperty list uchar float weights\nelement face 1\n"
                   "property list uchar int vertex_indices\nproperty list uchar float extra\n"
                   "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty float crease\n"
                   "property list uchar int more\nend_header\n"
                   "0 0 0 2 .1 .2\n1 0 0 1 .5\n0 1 0 0\n3 0 2 1 1 7\n0 1 .25 0\n"));
    QCOMPARE(lostInFile("b.ply", file, {}),
             std::string("the lists 'weights' of its vertices, the lists 'extra' of its faces, the values "
                         "'crease' of its edges and the values 'more' of its edges are not in a PLY file"));
}

/// Steps of a film have times, which Gmsh's files keep.
void TestLooksOfFiles::timesOfGmsh() {
    const samples::Folder folder;
    const std::string data =
        "$NodeData\n1\n\"T\"\n1\nTIME\n3\nSTEP\n1\n4\n1 1\n2 2\n3 3\n4 4\n$EndNodeData\n";
    const auto step = [&](const char* time, const char* number) {
        return QString::fromStdString(data).replace("TIME", time).replace("STEP", number).toStdString();
    };
    const MeshFile file = readMeshFile(
        folder.put("a.msh",
                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
                   "$EndNodes\n$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n" +
                       step("0.5", "3") + step("1.5", "4")));
    QCOMPARE(lostInFile("b.vtu", file, {}),
             std::string("the times of 2 fields are not in a VTU (ParaView) file"));
    QVERIFY(lostInFile("b.msh", file, {}).empty());
    for (const auto encoding : {MeshWriteOptions::Encoding::Text, MeshWriteOptions::Encoding::Binary}) {
        writeMeshFile(folder.path("b.msh"), file, {encoding, false, false, 4});
        const QByteArray text = bytesOf(folder.path("b.msh"));
        QVERIFY(text.contains("\"T\"\n1\n0.5\n3\n3\n1\n4\n"));
        QVERIFY(text.contains("\"T 2\"\n1\n1.5\n3\n4\n1\n4\n"));
    }
}

void TestLooksOfFiles::cellsOfHigherOrderInMedit() {
    const samples::Folder folder;
    try {
        readMeshFile(
            folder.put("a.mesh",
                       "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                       "0 0 1 0\nTetrahedraP2\n1\n1 2 3 4 1 2 3 4 1 2 0\nEnd\n"));
        QFAIL("was read");
    } catch (const InputError& error) {
        QVERIFY2(error.reason().starts_with("its cells have nodes between their corners ('TetrahedraP2')"),
                 error.what());
    }
}

void TestLooksOfFiles::attributesOfTetgenAreKept() {
    const samples::Folder folder;
    folder.put("a.ele", "1 4 0\n1 1 2 3 4\n");
    const MeshFile file =
        readMeshFile(folder.put("a.node", "4 3 2 0\n1 0 0 0 7 8.5\n2 1 0 0 1 2\n3 0 1 0 3 4\n4 0 0 1 5 6\n"));
    QVERIFY(lostInFile("b.node", file, {}).empty());
    writeMeshFile(folder.path("b.node"), file);
    QVERIFY(bytesOf(folder.path("b.node")).contains("1 0 0 0 7 8.5\n"));
}

void TestLooksOfFiles::whatGltfLacks() {
    const samples::Folder folder;
    const Skin skin = readSkin(folder.put("a.obj",
                                          "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\n"
                                          "g left\nf 1 2 3\nl 3 4\n"));
    QCOMPARE(lostInSkin("b.glb", skin, {}),
             std::string("1 line and 2 groups (left, left) are not in a binary glTF file"));
}

void TestLooksOfFiles::valuesThatFormatsLack() {
    const samples::Folder folder;
    const std::string text =
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\nCELLS 2 9\n4 0 1 2 3\n3 0 2 1\nCELL_TYPES 2\n10\n5\n"
        "CELL_DATA 2\nFIELD FieldData 1\npressure 1 2 double\n1.5\n2.5\n";
    MeshFile file = readMeshFile(folder.put("a.vtk", text));
    for (const char* name : {"b.exo", "b.cgns"}) {
        const std::string lost = lostInFile(name, file, {});
        QVERIFY2(lost.starts_with("the values of 1 cell of lower dimension are not in a"), lost.c_str());
    }
    QVERIFY(lostInFile("b.med", file, {}).empty());
    file.fields[0].name = std::string(65, 'p');
    for (const char* name : {"b.med", "b.cgns"}) {
        const std::string lost = lostInFile(name, file, {});
        QVERIFY2(lost.ends_with("the name of 1 field is changed to what the format allows"), lost.c_str());
    }
}

QTEST_GUILESS_MAIN(TestLooksOfFiles)
#include "test_looks_of_files.moc"
