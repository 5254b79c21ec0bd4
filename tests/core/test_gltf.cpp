#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/embedding.h"
#include "core/mesh/gltf.h"
#include "tests/support/surfaces.h"

using namespace wend;

class TestGltf : public QObject {
    Q_OBJECT
  private slots:
    void containerIsWellFormed();
    void posesComeBackAsMorphTargets();
    void skinHasPartsNormalsAndPictures();
    void textureRunsDown();
    void missingFolderIsAnError();
    void embeddedPointsFollowAffineMaps();
    void neighboursOutsideStayNeighbours();

  private:
    QTemporaryDir m_folder;
};

namespace {

struct Glb {
    QJsonObject json;
    QByteArray binary;
};

Glb readGlb(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray bytes = file.readAll();
    const auto word = [&](int at) { return qFromLittleEndian<quint32>(bytes.constData() + at); };
    if (bytes.left(4) != "glTF" || word(4) != 2 || word(8) != static_cast<quint32>(bytes.size())) return {};
    const int textLength = static_cast<int>(word(12));
    const int binaryAt = 20 + textLength;
    if (textLength % 4 != 0 || word(binaryAt) % 4 != 0) return {};  // chunks begin at words
    if (bytes.mid(16, 4) != "JSON" || bytes.mid(binaryAt + 4, 3) != "BIN") return {};
    return {QJsonDocument::fromJson(bytes.mid(20, textLength)).object(),
            bytes.mid(binaryAt + 8, static_cast<int>(word(binaryAt)))};
}

std::vector<float> floats(const Glb& glb, int accessorIndex, int components) {
    const QJsonObject accessor = glb.json["accessors"].toArray()[accessorIndex].toObject();
    const QJsonObject view = glb.json["bufferViews"].toArray()[accessor["bufferView"].toInt()].toObject();
    std::vector<float> values(static_cast<std::size_t>(accessor["count"].toInt() * components));
    std::memcpy(values.data(), glb.binary.constData() + view["byteOffset"].toInt(),
                values.size() * sizeof(float));
    return values;
}

GltfScene bendingBox() {
    const Surface box = test::box({0, 0, 0}, {2, 1, 1}, 2);
    GltfScene scene;
    scene.triangles = box.triangles;
    scene.points = box.points;
    scene.times = {0, 0.5, 1};
    for (double t : scene.times) {
        Points3 pose = box.points;
        pose.row(2).array() += t * pose.row(0).array().square();
        scene.poses.push_back(pose);
    }
    return scene;
}

}  // namespace

void TestGltf::containerIsWellFormed() {
    GltfScene scene = bendingBox();
    const QString path = m_folder.filePath("box.glb");
    for (const char* name : {"a", "bc", "def", "ghij"}) {  // of every length to a whole word
        scene.name = name;
        writeGltf(path.toStdString(), scene);
        QVERIFY2(!readGlb(path).json.isEmpty(), name);
    }
    const Glb glb = readGlb(path);
    QCOMPARE(glb.json["asset"].toObject()["version"].toString(), QString("2.0"));
    QCOMPARE(glb.json["buffers"].toArray()[0].toObject()["byteLength"].toInt(),
             static_cast<int>(glb.binary.size()));
    const QJsonObject primitive =
        glb.json["meshes"].toArray()[0].toObject()["primitives"].toArray()[0].toObject();
    const auto positions = floats(glb, primitive["attributes"].toObject()["POSITION"].toInt(), 3);
    QCOMPARE(positions.size(), static_cast<std::size_t>(scene.points.size()));
    for (Eigen::Index i = 0; i < scene.points.cols(); ++i) {
        QCOMPARE(positions[3 * i], static_cast<float>(scene.points(0, i)));
        QCOMPARE(positions[3 * i + 1], static_cast<float>(scene.points(2, i)));  // y is up
        QCOMPARE(positions[3 * i + 2], static_cast<float>(-scene.points(1, i)));
    }
}

void TestGltf::posesComeBackAsMorphTargets() {
    const GltfScene scene = bendingBox();
    const QString path = m_folder.filePath("bend.glb");
    writeGltf(path.toStdString(), scene, false);
    const Glb glb = readGlb(path);
    const QJsonObject mesh = glb.json["meshes"].toArray()[0].toObject();
    const QJsonArray targets = mesh["primitives"].toArray()[0].toObject()["targets"].toArray();
    QCOMPARE(targets.size(), qsizetype(3));
    for (int k = 0; k < 3; ++k) {
        const auto delta = floats(glb, targets[k].toObject()["POSITION"].toInt(), 3);
        for (Eigen::Index i = 0; i < scene.points.size(); ++i)
            QCOMPARE(delta[i], static_cast<float>(scene.poses[k].data()[i] - scene.points.data()[i]));
    }
    const QJsonObject sampler =
        glb.json["animations"].toArray()[0].toObject()["samplers"].toArray()[0].toObject();
    QCOMPARE(floats(glb, sampler["input"].toInt(), 1), (std::vector<float>{0, 0.5F, 1}));
    QCOMPARE(floats(glb, sampler["output"].toInt(), 1), (std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
}

/// A part per material, vertices doubled along seams, normals in every pose.
void TestGltf::skinHasPartsNormalsAndPictures() {
    const Surface box = test::box({0, 0, 0}, {2, 1, 1}, 1);
    QFile picture(m_folder.filePath("tile.png"));
    QVERIFY(picture.open(QIODevice::WriteOnly) && picture.write("\x89PNG and so on") > 0);
    picture.close();
    Skin skin;
    skin.points = box.points;
    skin.triangles = box.triangles;
    skin.uv = Eigen::Matrix2Xd::Random(2, 3);
    for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
        skin.uvCorners.push_back({0, 1, 2});
        skin.materialOf.push_back(t < 4 ? 0 : 2);  // nothing has the second one
    }
    skin.materials = {
        {"red", {1, 0, 0, 1}, {}}, {"unused", {}, {}}, {"tiled", {}, picture.fileName().toStdString()}};
    const Points3 bent = box.points * 1.5;
    const GltfScene scene = gltfScene(skin, {box.points, bent}, {0, 0.5});
    QVERIFY(scene.points.cols() > box.points.cols());
    const QString path = m_folder.filePath("skin.glb");
    writeGltf(path.toStdString(), scene, false);
    const Glb glb = readGlb(path);
    const QJsonArray parts = glb.json["meshes"].toArray()[0].toObject()["primitives"].toArray();
    QCOMPARE(parts.size(), qsizetype(2));
    QCOMPARE(parts[1].toObject()["material"].toInt(), 2);
    QCOMPARE(glb.json["materials"].toArray().size(), qsizetype(3));
    QCOMPARE(glb.json["images"].toArray()[0].toObject()["mimeType"].toString(), QString("image/png"));
    const QJsonObject attributes = parts[0].toObject()["attributes"].toObject();
    const auto normals = floats(glb, attributes["NORMAL"].toInt(), 3);
    QCOMPARE(normals.size(), std::size_t(scene.points.size()));
    const auto texture = floats(glb, attributes["TEXCOORD_0"].toInt(), 2);
    QCOMPARE(texture.size(), std::size_t(2 * scene.points.cols()));
    std::array<int, 3> seen{};
    for (std::size_t i = 0; i < texture.size(); i += 2)
        for (int k = 0; k < 3; ++k)  // glTF counts v from the upper boundary
            seen[static_cast<std::size_t>(k)] += texture[i] == static_cast<float>(skin.uv(0, k)) &&
                                                 texture[i + 1] == static_cast<float>(1 - skin.uv(1, k));
    QCOMPARE(seen[0] + seen[1] + seen[2], int(scene.points.cols()));
    QVERIFY(seen[0] > 0 && seen[1] > 0 && seen[2] > 0);
    const QJsonObject last = parts[0].toObject()["targets"].toArray()[1].toObject();
    for (float x : floats(glb, last["NORMAL"].toInt(), 3)) QVERIFY(std::abs(x) < 1e-6F);  // only larger
    QVERIFY(gltfScene(skin, box.points).poses.empty());
}

/// glTF counts v from the top of the picture, we from its bottom.
void TestGltf::textureRunsDown() {
    GltfScene scene = bendingBox();
    scene.uv = Eigen::Matrix2Xd::Random(2, scene.points.cols());
    const QString path = m_folder.filePath("uv.glb");
    writeGltf(path.toStdString(), scene);
    const Glb glb = readGlb(path);
    const QJsonObject primitive =
        glb.json["meshes"].toArray()[0].toObject()["primitives"].toArray()[0].toObject();
    const auto uv = floats(glb, primitive["attributes"].toObject()["TEXCOORD_0"].toInt(), 2);
    QCOMPARE(uv.size(), std::size_t(scene.uv.size()));
    for (Eigen::Index i = 0; i < scene.uv.cols(); ++i) {
        QCOMPARE(uv[2 * i], static_cast<float>(scene.uv(0, i)));
        QCOMPARE(uv[2 * i + 1], static_cast<float>(1 - scene.uv(1, i)));
    }
}

void TestGltf::missingFolderIsAnError() {
    QVERIFY_THROWS_EXCEPTION(InputError, writeGltf("/nowhere/at/all/x.glb", bendingBox()));
}

void TestGltf::embeddedPointsFollowAffineMaps() {
    // Any affine map of a single tetrahedron carries points inside and outside exactly.
    SimplicialMesh<3> mesh;
    mesh.points.resize(3, 4);
    mesh.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    mesh.cells = {{0, 1, 2, 3}};
    Points3 points(3, 3);
    points << 0.2, 1.5, -0.3, 0.1, 0.2, -0.4, 0.3, 0.1, 2.0;
    Mat3 A;
    A << 1, 0.3, 0.1, -0.2, 1.4, 0, 0.5, 0, 0.8;
    const Points3 pose = (A * mesh.points).colwise() + Vec3(1, 2, 3);
    const Embedding<3> embedding(mesh, points);
    QCOMPARE(embedding.outside(), 2);
    QVERIFY((embedding.carry(mesh, pose) - ((A * points).colwise() + Vec3(1, 2, 3)).matrix())
                .cwiseAbs()
                .maxCoeff() < 1e-14);
}

/// However the cells are bent, a line of points in front of them is mapped to a continuous line.
void TestGltf::neighboursOutsideStayNeighbours() {
    SimplicialMesh<3> mesh;
    mesh.points.resize(3, 6);
    mesh.points << 0, 1, 0, 0, 1, 2, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 1, 1;
    mesh.cells = {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 5, 4, 3}};
    for (auto& cell : mesh.cells)
        if (cellMeasure<3>(mesh.points, cell) < 0) std::swap(cell[2], cell[3]);
    Points3 pose = mesh.points;
    pose.row(2) += 0.4 * mesh.points.row(0).array().square().matrix();
    pose.row(1) -= 0.3 * (mesh.points.row(0).array() * mesh.points.row(2).array()).matrix();
    constexpr int kCount = 2001;
    Points3 line(3, kCount);
    for (int i = 0; i < kCount; ++i) line.col(i) << -1 + 4.0 * i / (kCount - 1), 0.7, 1.6;
    const Embedding<3> embedding(mesh, line);
    QCOMPARE(embedding.outside(), kCount);
    const Points3 carried = embedding.carry(mesh, pose);
    double longest = 0;
    for (int i = 1; i < kCount; ++i)
        longest = std::max(longest, (carried.col(i) - carried.col(i - 1)).norm());
    QVERIFY(longest < 10 * 4.0 / (kCount - 1));  // a jump would be some hundred times the step
    QVERIFY(longest > 0.5 * 4.0 / (kCount - 1));
    QVERIFY((embedding.carry(mesh, mesh.points) - line).cwiseAbs().maxCoeff() < 1e-13);
}

QTEST_APPLESS_MAIN(TestGltf)
#include "test_gltf.moc"
