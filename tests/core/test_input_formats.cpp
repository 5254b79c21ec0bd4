// Formats that are read only: binary glTF and 3MF, of files as other programs write them.

#include <minizip/zip.h>

#include <QtTest>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/gltf.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/skin_file.h"
#include "tests/core/test_folder.h"
#include "tests/support/surfaces.h"

using namespace wend;

namespace {

void append(std::string& bytes, const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A container around JSON (with ' for ") and bytes.
std::string glb(std::string json, std::string binary) {
    for (char& c : json) c = c == '\'' ? '"' : c;
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string bytes = "glTF";
    append(bytes, std::uint32_t(2));
    append(bytes, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
    append(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    append(bytes, static_cast<std::uint32_t>(binary.size()));
    return bytes + std::string("BIN\0", 4) + binary;
}

/// Corners of a unit square in the plane of glTF's x and y, and indices of two triangles as bytes.
std::string squareBytes() {
    std::string bytes;
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) append(bytes, x);
    return bytes + std::string("\0\1\2\0\2\3", 6);
}

const char* const kSquareTables =
    "'buffers': [{'byteLength': 54}], 'bufferViews': [{'buffer': 0, 'byteOffset': 0, 'byteLength': 48}, "
    "{'buffer': 0, "
    "'byteOffset': 48, 'byteLength': 6}], 'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 4, "
    "'type': "
    "'VEC3'}, {'bufferView': 1, 'componentType': 5121, 'count': 6, 'type': 'SCALAR'}, {'bufferView': 1, "
    "'componentType': 5121, 'count': 4, 'type': 'SCALAR'}]";

std::string square(const std::string& nodes, const std::string& primitive, const std::string& more = "") {
    return glb("{'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [" + nodes +
                   "], 'meshes': [{'name': 'leaf', 'primitives': [" + primitive + "]}], " + kSquareTables +
                   more + "}",
               squareBytes());
}

constexpr const char* kTriangles = "{'attributes': {'POSITION': 0}, 'indices': 1}";

void zipInto(const QString& path, const std::vector<std::pair<std::string, std::string>>& files) {
    const zipFile zip = zipOpen64(path.toUtf8().constData(), APPEND_STATUS_CREATE);
    for (const auto& [name, content] : files) {
        zip_fileinfo info{};
        zipOpenNewFileInZip(zip, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, 6);
        zipWriteInFileInZip(zip, content.data(), static_cast<unsigned>(content.size()));
        zipCloseFileInZip(zip);
    }
    zipClose(zip, nullptr);
}

/// A tetrahedron as an object.
std::string tetrahedron(const char* id, const char* name) {
    return std::string("<object id=\"") + id + "\" name=\"" + name +
           "\" type=\"model\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" "
           "z=\"0\"/><vertex "
           "x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles><triangle "
           "v1=\"0\" v2=\"2\" "
           "v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle "
           "v1=\"0\" "
           "v2=\"3\" v3=\"2\"/></triangles></mesh></object>";
}

std::string model(const std::string& resources, const std::string& items) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model unit=\"millimeter\" "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"><resources>" +
           resources + "</resources><build>" + items + "</build></model>";
}

}  // namespace

class TestInputFormats : public QObject {
    Q_OBJECT

  private slots:
    void glbOfOurOwn();
    void glbFarFromTheOrigin();
    void glbOfNodes();
    void longChainOfNodes();
    void mirroredNodesFaceOutwards();
    void glbOfKinds_data();
    void glbOfKinds();
    void badGlb_data();
    void badGlb();
    void threeMf();
    void mirroredItemsFaceOutwards();
    void badThreeMf_data();
    void badThreeMf();

  private:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }
    void put(const char* name, const std::string& bytes) const {
        QFile out(m_folder.filePath(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(bytes.data(), static_cast<qint64>(bytes.size()));
    }

    QTemporaryDir m_folder;
};

/// A written file is read back: seams of texture points are closed again, and each corner has its own.
void TestInputFormats::glbOfOurOwn() {
    Skin skin;
    skin.points = Points3(3, 4);
    skin.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    skin.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    skin.uv = Eigen::Matrix2Xd(2, 4);
    skin.uv << 0, 1, 0, 0.5, 0, 0, 1, 0.5;
    skin.uvCorners = {{0, 2, 1}, {3, 1, 2}, {1, 2, 3}, {0, 3, 2}};
    skin.materials = {{"red", {1, 0, 0, 1}, ""}, {"blue", {0, 0, 1, 1}, ""}};
    skin.materialOf = {0, 0, 1, 1};
    writeGltf(file("own.glb"), gltfScene(skin, skin.points));
    const Skin back = readSkin(file("own.glb"));
    QCOMPARE(back.points.cols(), 4);
    for (std::size_t t = 0; t < 4; ++t)
        for (int k = 0; k < 3; ++k) {
            QCOMPARE(Vec3(back.points.col(back.triangles[t][k])),
                     Vec3(skin.points.col(skin.triangles[t][k])));
            QCOMPARE(Vec2(back.uv.col(back.uvCorners[t][k])), Vec2(skin.uv.col(skin.uvCorners[t][k])));
        }
    QCOMPARE(back.materialOf, skin.materialOf);
    QCOMPARE(back.materials.at(1).colour, skin.materials[1].colour);
}

/// Single precision would give a shape of size 1 at a distance of 1e6 an error of 0.06.
void TestInputFormats::glbFarFromTheOrigin() {
    Skin skin;
    skin.points = Points3::Random(3, 30).colwise() + Vec3(1e6, -3e6, 2e5);
    for (int k = 0; k + 2 < 30; ++k) skin.triangles.push_back({k, k + 1, k + 2});
    writeGltf(file("far.glb"), gltfScene(skin, skin.points));
    const MeshFile back = readMeshFile(file("far.glb"));
    QCOMPARE(back.points.cols(), 30);
    QVERIFY((back.points - skin.points).cwiseAbs().maxCoeff() < 1e-6);
}

/// Transforms multiply along the tree: a child with a translation is in a parent that is rotated about x and
/// scaled.
void TestInputFormats::glbOfNodes() {
    put("nodes.glb", square("{'children': [1, 2], 'rotation': [0.70710678118654752, 0, 0, "
                            "0.70710678118654752], 'scale': [2, 2, 2]}, "
                            "{'mesh': 0, 'name': 'first', 'translation': [10, 0, 0]}, {'mesh': 0, 'name': "
                            "'second', 'matrix': [1, 0, 0, "
                            "0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 0, 1]}",
                            kTriangles));
    const MeshFile mesh = readMeshFile(file("nodes.glb"));
    QCOMPARE(mesh.points.cols(), 8);
    // The corner (1, 1, 0): of the first in glTF 2 Rx(90°) (11, 1, 0) = (22, 0, 2), which is (22, −2, 0)
    // where z is up.
    QVERIFY((mesh.points.col(2) - Vec3(22, -2, 0)).norm() < 1e-12);
    QVERIFY((mesh.points.col(6) - Vec3(2, -12, 0)).norm() < 1e-12);
    QCOMPARE(mesh.triangles.size(), std::size_t(4));
    QCOMPARE(mesh.groups.size(), std::size_t(2));
    QCOMPARE(mesh.groups[1].name, std::string("second"));
    QCOMPARE(mesh.groups[1].cells, (std::vector<int>{2, 3}));
}

/// Each of 50,000 nodes is the only child of the one before, moved by one along x.
void TestInputFormats::longChainOfNodes() {
    constexpr int kCount = 50000;
    std::string nodes;
    for (int k = 1; k < kCount; ++k)
        nodes += "{'translation': [1, 0, 0], 'children': [" + std::to_string(k) + "]}, ";
    put("chain.glb", square(nodes + "{'mesh': 0}", kTriangles));
    const MeshFile mesh = readMeshFile(file("chain.glb"));
    QCOMPARE(mesh.triangles.size(), std::size_t(2));
    QCOMPARE(Vec3(mesh.points.col(0)), Vec3(kCount - 1, 0, 0));
}

namespace {

double volumeWithin(const MeshFile& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += mesh.points.col(a).dot(mesh.points.col(b).cross(mesh.points.col(c))) / 6;
    return sum;
}

}  // namespace

/// The square faces −y (in glTF +z), also where its own node, or that above, mirrors it.
void TestInputFormats::mirroredNodesFaceOutwards() {
    put("mirror.glb",
        square("{'children': [1, 2], 'scale': [-1, 1, 1]}, {'mesh': 0, 'translation': [2, 0, 0]}, "
               "{'mesh': 0, 'scale': [1, -1, 1]}",
               kTriangles));
    const MeshFile mesh = readMeshFile(file("mirror.glb"));
    QCOMPARE(mesh.triangles.size(), std::size_t(4));
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 p = mesh.points.col(a), q = mesh.points.col(b), r = mesh.points.col(c);
        QCOMPARE((q - p).cross(r - p).normalized(), Vec3(0, -1, 0));
    }
}

void TestInputFormats::glbOfKinds_data() {
    QTest::addColumn<QString>("primitive");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<int>("cells");
    QTest::newRow("triangles") << kTriangles << 2 << 2;
    QTest::newRow("no indices, fan") << "{'attributes': {'POSITION': 0}, 'mode': 6}" << 2 << 2;
    QTest::newRow("strip") << "{'attributes': {'POSITION': 0}, 'indices': 2, 'mode': 5}" << 2 << 2;
    QTest::newRow("strip with a corner twice")
        << "{'attributes': {'POSITION': 0}, 'indices': 1, 'mode': 5}" << 3 << 3;
    QTest::newRow("lines beside triangles")
        << QString(kTriangles) + ", {'attributes': {'POSITION': 0}, 'mode': 2}" << 2 << 6;
    QTest::newRow("points beside triangles")
        << QString(kTriangles) + ", {'attributes': {'POSITION': 0}, 'mode': 0}" << 2 << 6;
}

void TestInputFormats::glbOfKinds() {
    QFETCH(QString, primitive);
    QFETCH(int, triangles);
    QFETCH(int, cells);
    put("kinds.glb", square("{'mesh': 0}", primitive.toStdString()));
    const MeshFile mesh = readMeshFile(file("kinds.glb"));
    QCOMPARE(mesh.points.cols(), 4);
    QCOMPARE(mesh.triangles.size(), static_cast<std::size_t>(triangles));
    QCOMPARE(mesh.cells.size(), cells);
    QCOMPARE(Vec3(mesh.points.col(2)), Vec3(1, 0, 1));
}

void TestInputFormats::badGlb_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& bytes, const char* message) {
        QTest::newRow(name) << QByteArray::fromStdString(bytes) << message;
    };
    const std::string whole = square("{'mesh': 0}", kTriangles);
    row("text", "hello, hello", "does not begin with 'glTF'");
    row("cut off", whole.substr(0, whole.size() - 30), "is cut off");
    row("no JSON", glb("{", ""), "its JSON is not that of a glTF file");
    row("no table", square("{'mesh': 0}", "{'attributes': {'POSITION': 7}}"),
        "its JSON is not that of a glTF file");
    row("a cycle", square("{'mesh': 0, 'children': [0]}", kTriangles), "node 0 is in the scene twice");
    row("beyond the file",
        square("{'mesh': 0}", kTriangles).replace(whole.find("\"count\":"), 11, "\"count\": 9,"),
        "accessor 0 reaches beyond the file");
    row("deep JSON",
        square("{'mesh': 0}", kTriangles,
               ", 'extras': " + std::string(100000, '[') + std::string(100000, ']')),
        "its JSON is nested too deep");
    row("compressed",
        square("{'mesh': 0}", kTriangles, ", 'extensionsRequired': ['KHR_draco_mesh_compression']"),
        "is compressed by 'KHR_draco_mesh_compression'");
    row("wrong corner",
        square("{'mesh': 0}", "{'attributes': {'POSITION': 0}, 'indices': 1}")
            .replace(whole.size() - 3, 1, "\x9"),
        "a triangle names vertex 9");
}

void TestInputFormats::badGlb() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    put("bad.glb", bytes.toStdString());
    try {
        readMeshFile(file("bad.glb"));
        QFAIL("is read");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains(message), error.what());
        QVERIFY2(QString(error.what()).startsWith(m_folder.filePath("bad.glb")), error.what());
    }
}

/// Items with transforms, and an object of components, one of which is in another file of the archive.
void TestInputFormats::threeMf() {
    zipInto(m_folder.filePath("two.3mf"),
            {{"[Content_Types].xml", "<Types/>"},
             {"_rels/.rels",
              "<Relationships><Relationship Target=\"/3D/main.model\" Id=\"r\" "
              "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
             {"3D/part.model", model(tetrahedron("7", "inner"), "")},
             {"3D/main.model",
              model(tetrahedron("1", "plain") +
                        "<object id=\"2\" name=\"both\"><components><component objectid=\"1\" "
                        "transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\"/><component p:path=\"/3D/part.model\" "
                        "objectid=\"7\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object>",
                    "<item objectid=\"1\"/><item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 9\"/>")}});
    const MeshFile mesh = readMeshFile(file("two.3mf"));
    QCOMPARE(mesh.points.cols(), 12);
    QCOMPARE(mesh.triangles.size(), std::size_t(12));
    QCOMPARE(Vec3(mesh.points.col(1)), Vec3(1, 0, 0));
    QCOMPARE(Vec3(mesh.points.col(5)), Vec3(0, 2, 9));     // (1, 0, 0) turned to (0, 1, 0)
    QCOMPARE(Vec3(mesh.points.col(11)), Vec3(10, 0, 11));  // (0, 0, 1) moved to (5, 0, 1)
    QCOMPARE(mesh.groups.size(), std::size_t(2));
    QCOMPARE(mesh.groups[1].name, std::string("both"));
    QCOMPARE(mesh.groups[1].cells.size(), std::size_t(8));
    QCOMPARE(mesh.triangles[4], (std::array{4, 6, 5}));
}

/// A tetrahedron, one that its item mirrors, and one whose component and item both do.
void TestInputFormats::mirroredItemsFaceOutwards() {
    constexpr const char* kMirror = "transform=\"-1 0 0 0 1 0 0 0 1 5 0 0\"";
    zipInto(m_folder.filePath("mirror.3mf"),
            {{"3D/3dmodel.model",
              model("<basematerials id=\"9\"><base name=\"red\" displaycolor=\"#FF0000\"/><base "
                    "name=\"blue\" displaycolor=\"#0000FF\"/></basematerials>" +
                        tetrahedron("1", "plain") +
                        "<object id=\"2\" name=\"other\"><components><component objectid=\"1\" " + kMirror +
                        "/></components></object>",
                    std::string("<item objectid=\"1\"/><item objectid=\"1\" ") + kMirror +
                        "/><item objectid=\"2\" " + kMirror + "/>")}});
    MeshFile mesh = readMeshFile(file("mirror.3mf"));
    QCOMPARE(mesh.groups.size(), std::size_t(3));
    QCOMPARE(volumeWithin(mesh), 3 / 6.0);
    QCOMPARE(mesh.notices, std::vector<std::string>{"its 2 colours"});
    QCOMPARE(unitOfThreeMf(file("mirror.3mf")), std::string("millimeter"));
    zipInto(m_folder.filePath("inch.3mf"),
            {{"3D/3dmodel.model", "<model unit=\"inch\"><!--" + std::string(100000, '-') + "--></model>"}});
    QCOMPARE(unitOfThreeMf(file("inch.3mf")), std::string("inch"));
    zipInto(m_folder.filePath("usual.3mf"), {{"3D/3dmodel.model", "<model/>"}});
    QCOMPARE(unitOfThreeMf(file("usual.3mf")), std::string("millimeter"));
    QCOMPARE(unitOfThreeMf(file("none.3mf")), std::string());
    mesh.triangles.resize(8);
    QCOMPARE(volumeWithin(mesh), 2 / 6.0);
}

void TestInputFormats::badThreeMf_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& text, const char* message) {
        QTest::newRow(name) << QString::fromStdString(text) << message;
    };
    row("no object", model("", "<item objectid=\"1\"/>"), "there is no object '1'");
    row("itself",
        model("<object id=\"1\"><components><component objectid=\"1\"/></components></object>",
              "<item objectid=\"1\"/>"),
        "the components are nested too deep");
    row("no XML", "<model><a></model>", "not valid XML");
    row("corner",
        model("<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" "
              "z=\"0\"/></vertices><triangles><triangle "
              "v1=\"0\" v2=\"1\" v3=\"0\"/></triangles></mesh></object>",
              "<item objectid=\"1\"/>"),
        "a triangle names vertex 1, but there are only 1");
    row("number",
        model("<object id=\"1\"><mesh><vertices><vertex x=\"a\" y=\"0\" z=\"0\"/></vertices></mesh></object>",
              "<item objectid=\"1\"/>"),
        "'a' is not a number");
    row("nothing", model("", ""), "there is no vertex in it");
}

void TestInputFormats::badThreeMf() {
    QFETCH(QString, model);
    QFETCH(QString, message);
    zipInto(m_folder.filePath("bad.3mf"), {{"3D/3dmodel.model", model.toStdString()}});
    try {
        readMeshFile(file("bad.3mf"));
        QFAIL("is read");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains(message), error.what());
    }
    put("bad.3mf", "PK hello");
    QVERIFY_EXCEPTION_THROWN(readMeshFile(file("bad.3mf")), InputError);
}

QTEST_GUILESS_MAIN(TestInputFormats)
#include "test_input_formats.moc"
