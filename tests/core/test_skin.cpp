// The look of surfaces: texture points of corners, materials and groups are read and written.

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"
#include "tests/support/surfaces.h"

using namespace wend;

class TestSkin : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void objLookIsRead();
    void negativeTextureNumbersCountFromTheLatest();
    void missingFilesAreWarnings();
    void groupsAreLabels();
    void seamsUnfold();
    void objIsTheSameFileElsewhere();
    void fieldsAndLabelsInPly();
    void normalsPointOut();

  private:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }
    void put(const char* name, const std::string& text) const { std::ofstream(file(name)) << text; }
    std::string get(const char* name) const {
        std::ifstream in(file(name));
        return {std::istreambuf_iterator<char>(in), {}};
    }

    QTemporaryDir m_folder;
};

namespace {

// A square folded along its diagonal; the quad's texture points differ on both sides of vertex 1.
const char* const kObj =
    "# folded\nmtllib looks/paint.mtl\no sheet\nv 0 0 0\nv 1 0 0 0.5\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nvn 0 0 1\n"
    "usemtl red\nf 1/1/1 2/2/1 3/3/1 \\\n4/4/1\nusemtl wood\nf 1/5/1 2/2/1 5/-1/1 # up\n";

}  // namespace

void TestSkin::init() {
    QDir(m_folder.path()).mkdir("looks");
    put("sheet.obj", kObj);
    put("looks/paint.mtl", "newmtl red\nKd 1 0.25 0\nd 0.5\nnewmtl wood\nmap_Kd -s 1 1 1 wood.png\n");
    put("looks/wood.png", "\x89PNG");
}

void TestSkin::objLookIsRead() {
    const Skin skin = readSkin(file("sheet.obj"));
    QCOMPARE(skin.triangles.size(), std::size_t(3));
    QVERIFY(skin.uvCorners[1] == (std::array{0, 2, 3}));
    QVERIFY(skin.uvCorners[2] == (std::array{4, 1, 4}));
    QCOMPARE(skin.materialOf, (std::vector{0, 0, 1}));
    QCOMPARE(skin.materials[0].colour[1], 0.25F);
    QCOMPARE(skin.materials[0].colour[3], 0.5F);
    QCOMPARE(QString::fromStdString(skin.materials[1].texture), m_folder.filePath("looks/wood.png"));
    QCOMPARE(skin.labels, (std::vector{1, 1, 2}));
    QVERIFY(skin.labelNames == (std::vector<std::string>{"red", "wood"}));
    QVERIFY(skin.warnings.empty());
}

void TestSkin::negativeTextureNumbersCountFromTheLatest() {
    put("back.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/-3 2/-2 3/-1\nvt 1 1\nvt .5 .5\n"
        "f 1/-2/-1 2/-5 4/5\nvt 7 7\n");
    const Skin skin = readSkin(file("back.obj"));
    QVERIFY(skin.uvCorners.at(0) == (std::array{0, 1, 2}));
    QVERIFY(skin.uvCorners.at(1) == (std::array{3, 0, 4}));
}

void TestSkin::missingFilesAreWarnings() {
    QFile::remove(m_folder.filePath("looks/wood.png"));
    QCOMPARE(readSkin(file("sheet.obj")).warnings.size(), std::size_t(1));
    QFile::remove(m_folder.filePath("looks/paint.mtl"));
    const Skin skin = readSkin(file("sheet.obj"));
    QVERIFY(QString::fromStdString(skin.warnings.at(0)).contains("paint.mtl cannot be read"));
    QCOMPARE(skin.materials.size(), std::size_t(2));  // they still tell parts apart
}

void TestSkin::groupsAreLabels() {
    put("groups.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng left\nf 1 2 3\ng right\nf 1 2 4\ng left\nf 2 3 4\n");
    const Skin skin = readSkin(file("groups.obj"));
    QCOMPARE(skin.labels, (std::vector{1, 2, 1}));
    QVERIFY(skin.labelNames == (std::vector<std::string>{"left", "right"}));
    QVERIFY(skin.uvCorners.empty() && skin.materialOf.empty());
}

void TestSkin::seamsUnfold() {
    const Skin skin = readSkin(file("sheet.obj"));
    const UnfoldedSkin one = unfolded(skin);
    QCOMPARE(one.vertices.size(), std::size_t(6));  // vertex 0 twice
    for (std::size_t t = 0; t < skin.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            QCOMPARE(one.vertices[one.triangles[t][k]], skin.triangles[t][k]);
            QVERIFY(one.uv.col(one.triangles[t][k]) == skin.uv.col(skin.uvCorners[t][k]));
        }
}

/// Everything but vertices stays as it was, relative to the new folder; so do normals if nothing rotates.
void TestSkin::objIsTheSameFileElsewhere() {
    QDir(m_folder.path()).mkdir("out");
    const Skin skin = readSkin(file("sheet.obj"));
    writeSkin(file("out/bent.obj"), skin, skin.points.array() + 0.25);
    const std::string text = get("out/bent.obj");
    QVERIFY2(text.find("mtllib ../looks/paint.mtl") != std::string::npos, text.c_str());
    QVERIFY2(text.find("f 1/1/1 2/2/1 3/3/1 4/4/1\n") != std::string::npos, text.c_str());  // still a quad
    QVERIFY2(text.find("v 1.25 0.25 0.25 0.5\n") != std::string::npos, text.c_str());
    QCOMPARE(QByteArray::fromStdString(text).count("vn 0 0 1\n"), qsizetype(1));
    const Skin again = readSkin(file("out/bent.obj"));
    QVERIFY(again.points == (skin.points.array() + 0.25).matrix());
    QVERIFY(again.uvCorners == skin.uvCorners && again.uv == skin.uv && again.materialOf == skin.materialOf);
    QVERIFY(again.warnings.empty());
}

void TestSkin::fieldsAndLabelsInPly() {
    const Skin skin = readSkin(file("sheet.obj"));
    writeSkin(file("sheet.ply"), skin, skin.points, {{"heat", true, 1, {1, 2, 3}}});
    const auto mesh = sharedMeshFile(file("sheet.ply"));
    QVERIFY(trianglesOf(*mesh) == skin.triangles);
    QCOMPARE(uvOf(*mesh).cols(), pointsOf(*mesh).cols());
    const auto& fields = fieldsOf(*mesh);
    const auto heat = std::ranges::find(fields, "heat", &MeshField::name);
    QVERIFY(heat != fields.end());
    QCOMPARE(heat->values, (std::vector<double>{1.5, 1.5, 3}));  // a quad has the mean of its triangles
    QCOMPARE(readSkin(file("sheet.ply")).labels, skin.labels);
}

void TestSkin::normalsPointOut() {
    const Surface box = test::box({-1, -1, -1}, {1, 1, 1}, 4);
    const Points3 normals = vertexNormals(box.points, box.triangles);
    for (Eigen::Index v = 0; v < normals.cols(); ++v) {
        QVERIFY(std::abs(normals.col(v).norm() - 1) < 1e-14);
        const Vec3 p = box.points.col(v);
        const Vec3 outside = (p.array().abs() == 1).select(p, 0).matrix();
        QVERIFY((normals.col(v) - outside.normalized()).norm() < 1e-14);  // by angles: exact at corners too
    }
}

QTEST_APPLESS_MAIN(TestSkin)
#include "test_skin.moc"
