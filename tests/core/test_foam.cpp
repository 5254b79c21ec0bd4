// OpenFOAM cases: the mesh is put together from points, faces, owners and patches, and the points come out
// alone.

#include <zlib.h>

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QTest>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/base/safe_file.h"
#include "core/mesh/mesh_file.h"

using namespace wend;

class TestFoam : public QObject {
    Q_OBJECT
  private slots:
    void cellsAndPatches_data();
    void cellsAndPatches();
    void kindsOfCells();
    void polyhedra();
    void pointsAreReplaced_data();
    void pointsAreReplaced();
    void zonesAreGroups();
    void damage_data();
    void damage();

  private:
    std::string folder() const { return (m_folder.path() + "/case/constant/polyMesh").toStdString(); }
    std::string points() const { return folder() + "/points"; }
    void put(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(folder());
        QFile file(QString::fromStdString(folder() + "/" + name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text.data(), static_cast<qint64>(text.size()));
    }
    QTemporaryDir m_folder;
};

namespace {

using Faces = std::vector<std::vector<int>>;

/// How the case's files are written.
struct Encoding {
    bool binary = false, compressed = false;
    int labelBytes = 4, scalarBytes = 8;
};

std::string bytesOf(const auto& value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

std::string label(long value, const Encoding& how) {
    return how.labelBytes == 8 ? bytesOf(std::int64_t(value)) : bytesOf(std::int32_t(value));
}

std::string header(const char* kind, const char* object, const Encoding& how) {
    return std::string(
               "/*--- a case of the test ---*/\nFoamFile\n{\n    version     2.0;\n    format      ") +
           (how.binary ? "binary" : "ascii") +
           ";\n    arch        \"LSB;label=" + std::to_string(8 * how.labelBytes) +
           ";scalar=" + std::to_string(8 * how.scalarBytes) + "\";\n    class       " + kind +
           ";\n    object      " + object + ";\n}\n// * * * //\n\n";
}

std::string labels(const std::vector<long>& list, const Encoding& how) {
    std::string text = std::to_string(list.size()) + (how.binary ? "(" : "\n(\n");
    for (const long one : list) text += how.binary ? label(one, how) : std::to_string(one) + "\n";
    return text + ")\n";
}

std::string pointsText(const Points3& points, const Encoding& how) {
    std::string text =
        header("vectorField", "points", how) + std::to_string(points.cols()) + (how.binary ? "(" : "\n(\n");
    for (Eigen::Index v = 0; v < points.cols(); ++v)
        if (how.binary) {
            for (int k = 0; k < 3; ++k)
                text +=
                    how.scalarBytes == 8 ? bytesOf(points(k, v)) : bytesOf(static_cast<float>(points(k, v)));
        } else {
            text += "(" + QString::number(points(0, v), 'g', 17).toStdString() + " " +
                    QString::number(points(1, v), 'g', 17).toStdString() + " " +
                    QString::number(points(2, v), 'g', 17).toStdString() + ")\n";
        }
    return text + ")\n\n// * end * //\n";
}

/// The faces of a cell in VTK's numbering, outwards.
Faces facesOf(const std::vector<int>& n) {
    std::vector<std::vector<int>> places;
    if (n.size() == 4) places = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if (n.size() == 5) places = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    if (n.size() == 6) places = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
    if (n.size() == 8)
        places = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    if (n.size() > 8) {  // a prism
        const int corners = static_cast<int>(n.size()) / 2;
        places.resize(2);
        for (int k = 0; k < corners; ++k) {
            const int next = (k + 1) % corners;
            places[0].push_back(corners - 1 - k);
            places[1].push_back(corners + k);
            places.push_back({k, next, corners + next, corners + k});
        }
    }
    for (auto& face : places)
        for (int& place : face) place = n[static_cast<std::size_t>(place)];
    return places;
}

/// The files of a mesh: inner faces by owner and neighbour, then the patches.
struct Case {
    std::map<std::string, std::string> files;
};

Case caseOf(const Points3& points, const std::vector<std::vector<int>>& cells, const Encoding& how,
            const std::function<std::string(const Vec3&)>& patchOf) {
    std::map<std::vector<int>, std::pair<int, std::vector<int>>> open;  // sorted → owner, face
    std::map<std::array<int, 2>, std::vector<int>> inner;
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (const auto& face : facesOf(cells[c])) {
            std::vector<int> key = face;
            std::ranges::sort(key);
            if (const auto other = open.find(key); other != open.end()) {
                inner[{other->second.first, static_cast<int>(c)}] = other->second.second;
                open.erase(other);
            } else {
                open[key] = {static_cast<int>(c), face};
            }
        }
    Faces faces;
    std::vector<long> owner, neighbour;
    for (const auto& [sides, face] : inner) {
        faces.push_back(face);
        owner.push_back(sides[0]);
        neighbour.push_back(sides[1]);
    }
    std::map<std::string, std::vector<std::pair<int, std::vector<int>>>> patches;
    for (const auto& [key, one] : open) {
        Vec3 middle = Vec3::Zero();
        for (const int v : one.second) middle += points.col(v) / static_cast<double>(one.second.size());
        patches[patchOf(middle)].push_back(one);
    }
    std::string boundary =
        header("polyBoundaryMesh", "boundary", {}) + std::to_string(patches.size()) + "\n(\n";
    for (const auto& [name, list] : patches) {
        boundary += "    " + name +
                    "\n    {\n        type            wall;\n        inGroups        1(wall);\n"
                    "        nFaces          " +
                    std::to_string(list.size()) + ";\n        startFace       " +
                    std::to_string(faces.size()) + ";\n    }\n";
        for (const auto& [cell, face] : list) {
            faces.push_back(face);
            owner.push_back(cell);
        }
    }
    std::string faceText = header(how.binary ? "faceCompactList" : "faceList", "faces", how);
    if (how.binary) {
        std::vector<long> begins{0}, all;
        for (const auto& face : faces) {
            all.insert(all.end(), face.begin(), face.end());
            begins.push_back(static_cast<long>(all.size()));
        }
        faceText += labels(begins, how) + labels(all, how);
    } else {
        faceText += std::to_string(faces.size()) + "\n(\n";
        for (const auto& face : faces) {
            faceText += std::to_string(face.size()) + "(";
            for (std::size_t k = 0; k < face.size(); ++k)
                faceText += (k > 0 ? " " : "") + std::to_string(face[k]);
            faceText += ")\n";
        }
        faceText += ")\n";
    }
    return {{{"points", pointsText(points, how)},
             {"faces", faceText},
             {"owner", header("labelList", "owner", how) + labels(owner, how)},
             {"neighbour", header("labelList", "neighbour", how) + labels(neighbour, how)},
             {"boundary", boundary + ")\n"}}};
}

Points3 gridPoints(int nx, int ny, int nz) {
    Points3 points(3, (nx + 1) * (ny + 1) * (nz + 1));
    int v = 0;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) points.col(v++) << 0.5 * i, 0.1 * j * j + j, 0.3 * k + 0.01 * i;
    return points;
}

std::vector<std::vector<int>> gridCells(int nx, int ny, int nz) {
    std::vector<std::vector<int>> cells;
    const auto id = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                cells.push_back({id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
                                 id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
                                 id(i, j + 1, k + 1)});
    return cells;
}

std::string patchOfGrid(const Vec3& middle) {
    return middle.x() == 0 ? "inlet" : std::abs(middle.x() - 1.5) < 1e-12 ? "outlet" : "walls";
}

double volumeOf(const MeshFile& file) {
    double sum = 0;
    for (const auto& cell : file.tetrahedra) sum += cellMeasure<3>(Points3(file.points), cell);
    return sum;
}

std::string gzipped(const std::string& bytes) {
    QTemporaryDir folder;
    const std::string path = folder.filePath("z.gz").toStdString();
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    QFile read(QString::fromStdString(path));
    read.open(QIODevice::ReadOnly);
    return read.readAll().toStdString();
}

}  // namespace

void TestFoam::cellsAndPatches_data() {
    QTest::addColumn<bool>("binary");
    QTest::addColumn<bool>("compressed");
    QTest::addColumn<int>("labelBytes");
    QTest::newRow("text") << false << false << 4;
    QTest::newRow("text, compressed") << false << true << 4;
    QTest::newRow("binary, 32 bits") << true << false << 4;
    QTest::newRow("binary, 64 bits") << true << false << 8;
}

/// A grid of hexahedra has its volume, cells in their order and patches as groups.
void TestFoam::cellsAndPatches() {
    Encoding how;
    QFETCH(bool, binary);
    QFETCH(bool, compressed);
    QFETCH(int, labelBytes);
    how.binary = binary, how.compressed = compressed, how.labelBytes = labelBytes;
    const Points3 grid = gridPoints(3, 2, 2);
    const auto cells = gridCells(3, 2, 2);
    std::filesystem::remove_all(folder());
    for (const auto& [name, text] : caseOf(grid, cells, how, patchOfGrid).files)
        compressed&& name != "points" ? put(name + ".gz", gzipped(text)) : put(name, text);
    QFile stub(m_folder.path() + "/case/case.foam");
    QVERIFY(stub.open(QIODevice::WriteOnly));
    stub.close();
    for (const std::string& path : {points(), (m_folder.path() + "/case/case.foam").toStdString()}) {
        const MeshFile file = readMeshFile(path);
        QCOMPARE(file.points, Eigen::Matrix3Xd(grid));
        QCOMPARE(file.cells.kinds[0], CellKind::Hexahedron);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            std::vector<int> found(file.cells[static_cast<int>(c)].begin(),
                                   file.cells[static_cast<int>(c)].end()),
                expected = cells[c];
            std::ranges::sort(found), std::ranges::sort(expected);
            QCOMPARE(found, expected);
        }
        QVERIFY(std::abs(volumeOf(file) - 1.5 * 2.4 * 0.6) < 1e-12);
        std::map<std::string, std::size_t> groups;
        for (const MeshGroup& group : file.groups) groups[group.name] = group.cells.size();
        QCOMPARE(groups, (std::map<std::string, std::size_t>{{"inlet", 4}, {"outlet", 4}, {"walls", 24}}));
        SimplicialMesh<3> mesh = meshFrom<3>(file);
        QCOMPARE(mesh.vertexCount(), static_cast<int>(grid.cols()));
    }
}

/// A wedge is on a hexahedron with a pyramid on top, and a tetrahedron is at its side.
void TestFoam::kindsOfCells() {
    Points3 p(3, 12);
    p << 0, 1, 1, 0, 0, 1, 1, 0, 0.5, 2, 2, 3,  //
        0, 0, 1, 1, 0, 0, 1, 1, 0.5, 0, 0, 0,   //
        0, 0, 0, 0, 1, 1, 1, 1, 2, 0.5, 0, 0;
    p.col(9) << 2, 0, 0.5;
    p.col(10) << 2, 1, 0.5;
    p.col(11) << 1.5, 0.5, 3;
    const std::vector<std::vector<int>> cells{
        {0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8}, {1, 5, 9, 2, 6, 10}, {5, 6, 8, 11}};
    std::filesystem::remove_all(folder());
    double expected = 0;
    for (const auto& cell : cells)  // by Gauss's theorem
        for (const auto& face : facesOf(cell))
            for (std::size_t k = 1; k + 1 < face.size(); ++k)
                expected += p.col(face[0]).dot(Vec3(p.col(face[k])).cross(Vec3(p.col(face[k + 1])))) / 6;
    for (const auto& [name, text] : caseOf(p, cells, {}, [](const Vec3&) { return "all"; }).files)
        put(name, text);
    const MeshFile file = readMeshFile(points());
    const CellKind kinds[] = {CellKind::Hexahedron, CellKind::Pyramid, CellKind::Wedge,
                              CellKind::Tetrahedron};
    for (int c = 0; c < 4; ++c) QCOMPARE(file.cells.kinds[static_cast<std::size_t>(c)], kinds[c]);
    double sum = 0;
    for (const auto& cell : file.tetrahedra) {
        const double volume = cellMeasure<3>(Points3(file.points), cell);
        QVERIFY(volume > 0);
        sum += volume;
    }
    QVERIFY(std::abs(sum - expected) < 1e-12);
}

/// Two hexagonal prisms, one on the other, are on a third one of five corners. They are filled by tetrahedra
/// around inner vertices, which neighbours share; the case gets only its own points back.
void TestFoam::polyhedra() {
    Points3 p(3, 23);
    std::vector<std::vector<int>> cells{
        {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, {6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17}, {}};
    for (int v = 0; v < 18; ++v) {
        const double angle = std::numbers::pi * (v % 6) / 3;
        p.col(v) << std::cos(angle), std::sin(angle), v / 6;
    }
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * std::numbers::pi * k / 5;
        p.col(18 + k) << 5 + std::cos(angle), std::sin(angle), 0;
        cells[2].push_back(18 + k);
    }
    Points3 all(3, 28);
    all << p, p.rightCols(5);
    all.row(2).tail(5).array() += 1;
    for (int k = 23; k < 28; ++k) cells[2].push_back(k);
    const double hexagon = 1.5 * std::sqrt(3.0), pentagon = 2.5 * std::sin(2 * std::numbers::pi / 5);
    std::filesystem::remove_all(folder());
    for (const auto& [name, text] : caseOf(all, cells, {}, [](const Vec3&) { return "all"; }).files)
        put(name, text);
    MeshFile file = readMeshFile(points());
    QCOMPARE(file.polyhedra, 3);
    QCOMPARE(file.points.cols(), Eigen::Index(28 + 3 + 5));  // the middles of cells, and of five faces
    double sum = 0;
    for (const auto& cell : file.tetrahedra) sum += cellMeasure<3>(Points3(file.points), cell);
    QVERIFY(std::abs(sum - 2 * hexagon - pentagon) < 1e-12);
    const auto mesh = meshFrom<3>(file);  // throws where facets do not meet
    std::size_t outer = 0;
    for (const auto& facet : facetsOf<3>(mesh)) outer += !facet.interior();
    QCOMPARE(outer, file.triangles.size());
    QCOMPARE(file.groups.size(), std::size_t(1));
    QCOMPARE(file.groups[0].cells.size(),
             std::size_t(2 * 6 + 12 + 2 * 5 + 5));  // split faces have a triangle per corner
    QCOMPARE(lostInFile("a.vtu", file, {}),
             std::string("the name of 1 group is not in a VTU (ParaView) file; 3 polyhedra are "
                         "written as tetrahedra around a vertex within"));
    file.points.row(0).array() += 0.25;
    writeMeshFile(points(), file);
    const MeshFile back = readMeshFile(points());
    QVERIFY((back.points.leftCols(28).array() == file.points.leftCols(28).array()).all());
}

void TestFoam::pointsAreReplaced_data() {
    QTest::addColumn<bool>("binary");
    QTest::addColumn<int>("scalarBytes");
    QTest::newRow("text") << false << 8;
    QTest::newRow("binary, double") << true << 8;
    QTest::newRow("binary, single") << true << 4;
}

/// The written file differs in the numbers only: everything else, and unchanged numbers, are kept byte for
/// byte.
void TestFoam::pointsAreReplaced() {
    Encoding how;
    QFETCH(bool, binary);
    QFETCH(int, scalarBytes);
    how.binary = binary, how.scalarBytes = scalarBytes;
    Points3 grid = gridPoints(2, 2, 1);
    std::filesystem::remove_all(folder());
    for (const auto& [name, text] : caseOf(grid, gridCells(2, 2, 1), how, patchOfGrid).files) put(name, text);
    MeshFile file = readMeshFile(points());
    const std::string copy = m_folder.path().toStdString() + "/bent";
    std::filesystem::create_directories(copy);
    const auto written = [&] {
        writeMeshFile(copy + "/points", file);
        QFile read(QString::fromStdString(copy + "/points"));
        read.open(QIODevice::ReadOnly);
        return read.readAll().toStdString();
    };
    if (scalarBytes == 8) QCOMPARE(written(), pointsText(grid, how));
    file.points.col(3) += Vec3(0.125, -0.3, 1e-5);
    grid = file.points;
    QCOMPARE(written(), pointsText(grid, how));
}

void TestFoam::zonesAreGroups() {
    std::filesystem::remove_all(folder());
    for (const auto& [name, text] : caseOf(gridPoints(3, 1, 1), gridCells(3, 1, 1), {}, patchOfGrid).files)
        put(name, text);
    put("cellZones",
        header("regIOobject", "cellZones", {}) +
            "1\n(\nporous\n{\n    type cellZone;\n    cellLabels      List<label>\n2\n(\n2\n0\n)\n;\n}\n)\n");
    put("faceZones", header("regIOobject", "faceZones", {}) + "2\n(\n)\n");
    const MeshFile file = readMeshFile(points());
    const auto zone = std::ranges::find(file.groups, "porous", &MeshGroup::name);
    QVERIFY(zone != file.groups.end());
    QCOMPARE(zone->dimension, 3);
    QCOMPARE(zone->cells, std::vector<int>({0, 2}));
    QCOMPARE(file.notices, std::vector<std::string>{"its 2 faceZones"});
}

void TestFoam::damage_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* what, const char* name, const char* from, const char* to,
                        const char* message) {
        QTest::newRow(what) << QString(name) << QString(from) << QString(to) << QString(message);
    };
    row("a word for a number", "points", "(0 0 0)", "(0 zero 0)",
        "points: line 14: \"zero\" is not a number");
    row("a list too long", "owner", "\n16\n", "\n99999999\n", "owner: line 12: a list of 99999999 entries");
    row("a vertex too many", "faces", "4(0 ", "4(900 ", "names vertex 900, but there are only 16");
    row("no end", "points", "// * end * //", "/* no end", "");
    row("a patch beyond", "boundary", "startFace       2;", "startFace       900;", "patch inlet has faces");
    row("a polyhedron", "owner", "\n0\n0\n", "\n0\n1\n", "cell ");
}

void TestFoam::damage() {
    QFETCH(QString, name);
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, message);
    std::filesystem::remove_all(folder());
    for (const auto& [file, text] : caseOf(gridPoints(3, 1, 1), gridCells(3, 1, 1), {}, patchOfGrid).files) {
        QString changed = QString::fromStdString(text);
        if (file == name.toStdString()) {
            const auto at = changed.indexOf(from);
            QVERIFY2(at >= 0, qPrintable(changed));
            changed.replace(at, from.size(), to);
        }
        put(file, changed.toStdString());
    }
    try {
        readMeshFile(points());
        QVERIFY(message.isEmpty());
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains(message), error.what());
    }
}

QTEST_GUILESS_MAIN(TestFoam)
#include "test_foam.moc"
