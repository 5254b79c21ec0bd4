// Everything read is written again: polygons, cells of every kind, groups, lists and values, in every format
// that supports them; and the losses in the others.

#include <QtTest>
#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <sstream>

#include "core/mesh/file_cells.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/polygon_split.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/turned_normals.h"
#include "test_mesh_files.h"

using namespace wend;

namespace {

double areaOf(const MeshFile& file) {
    double area = 0;
    for (const auto& t : file.triangles) {
        const Eigen::Vector3d a = file.points.col(t[0]), b = file.points.col(t[1]), c = file.points.col(t[2]);
        area += (b - a).cross(c - a).z() / 2;
    }
    return area;
}

double volumeOf(const MeshFile& file) {
    double volume = 0;
    for (const auto& cell : file.tetrahedra) volume += std::abs(cellMeasure<3>(file.points, cell));
    return volume;
}

std::string reasonOf(const std::string& name, const std::string& text) {
    const samples::Folder folder;
    try {
        readMeshFile(folder.put(name, text));
    } catch (const InputError& error) {
        return error.reason();
    }
    return {};
}

/// The letter L of area 5, a star-shaped polygon that is visible from another corner than the first,
/// and a comb.
const std::string kPoints = "0 0 0\n3 0 0\n3 1 0\n1 1 0\n1 3 0\n0 3 0\n";

/// Two boxes beside each other whose vertices have numbers in any order.
MeshFile twoBoxes(unsigned seed) {
    std::vector<int> number(12);
    std::iota(number.begin(), number.end(), 0);
    samples::Random random(seed);
    for (int k = 11; k > 0; --k) std::swap(number[k], number[random.index(k + 1)]);
    MeshFile file;
    file.points.resize(3, 12);
    for (int x = 0; x < 3; ++x)
        for (int k = 0; k < 4; ++k)
            file.points.col(number[4 * x + k]) =
                Eigen::Vector3d(x, (k == 1 || k == 2) ? 1 : 0, k >= 2 ? 1 : 0);
    for (int x = 0; x < 2; ++x) {
        std::vector<int> nodes;
        for (int k = 0; k < 8; ++k) nodes.push_back(number[4 * (x + k / 4) + k % 4]);
        file.cells.add(CellKind::Hexahedron, nodes);
    }
    return file;
}

/// One cell of each kind of space without nodes between corners, apart from each other, and of the plane and
/// the line beside them, with values, groups that overlap, and numbers.
MeshFile vocabulary() {
    MeshFile file;
    std::vector<Eigen::Vector3d> points;
    const auto add = [&](CellKind kind, const std::vector<Eigen::Vector3d>& corners) {
        std::vector<int> nodes;
        for (const auto& p : corners) {
            nodes.push_back(static_cast<int>(points.size()));
            points.push_back(p + Eigen::Vector3d(3.0 * file.cells.size(), 0, 0));
        }
        file.cells.add(kind, nodes);
    };
    const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), up(0, 0, 1);
    add(CellKind::Tetrahedron, {a, b, d, up});
    add(CellKind::Hexahedron, {a, b, c, d, a + up, b + up, c + up, d + up});
    add(CellKind::Wedge, {a, b, d, a + up, b + up, d + up});
    add(CellKind::Pyramid, {a, b, c, d, up});
    add(CellKind::Triangle, {a, b, d});
    add(CellKind::Quad, {a, b, c, d});
    add(CellKind::Line, {a, b});
    file.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t v = 0; v < points.size(); ++v) file.points.col(static_cast<Eigen::Index>(v)) = points[v];
    MeshField count{"count", true, 1, {}, {}, formats::Scalar::Int32}, heat{"heat", false, 1, {}};
    for (int cell = 0; cell < file.cells.size(); ++cell) count.values.push_back(10 * cell);
    for (std::size_t v = 0; v < points.size(); ++v) heat.values.push_back(1.0 / (1.0 + v));
    file.fields = {count, heat};
    file.groups = {{"rubber part", 3, 12, {0, 2}, {}, false},
                   {"steel", 3, 11, {1, 3}, {}, false},
                   {"fixed end", 2, 21, {4}, {}, false},
                   {"load", 2, 22, {5}, {}, false},
                   {"wall", 1, 31, {6}, {}, false}};
    formats::finishCells(file);
    return file;
}

const MeshField* find(const MeshFile& file, const std::string& name) {
    for (const auto& field : file.fields)
        if (field.name == name) return &field;
    return nullptr;
}

std::map<std::pair<int, std::string>, std::vector<std::vector<int>>> groupsOf(const MeshFile& file,
                                                                              bool names) {
    std::map<std::pair<int, std::string>, std::vector<std::vector<int>>> groups;
    for (const MeshGroup& group : file.groups) {
        auto& cells = groups[{group.dimension, names ? group.name : std::to_string(group.tag)}];
        for (const int c : group.cells) cells.emplace_back(file.cells[c].begin(), file.cells[c].end());
    }
    return groups;
}

std::vector<std::vector<int>> sortedCells(const MeshFile& file) {
    std::vector<std::vector<int>> cells;
    for (int c = 0; c < file.cells.size(); ++c)
        cells.emplace_back(file.cells[c].begin(), file.cells[c].end());
    std::ranges::sort(cells);
    return cells;
}

}  // namespace

class TestMeshWhole : public QObject {
    Q_OBJECT

  private slots:
    /// The area of an L is 5 whatever corner it begins with, and it is written as one polygon again.
    void concavePolygons_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"a.obj", "a.off", "a.ply", "a.vtk", "a.vtu"})
            QTest::newRow(name) << QString(name);
    }
    void concavePolygons() {
        QFETCH(QString, name);
        for (int first = 0; first < 6; ++first) {
            MeshFile file;
            const samples::Folder folder;
            std::string obj, face = "f";
            std::istringstream lines(kPoints);
            for (std::string line; std::getline(lines, line);) obj += "v " + line + "\n";
            for (int k = 0; k < 6; ++k) face += " " + std::to_string((first + k) % 6 + 1);
            file = readMeshFile(folder.put("l.obj", obj + face + "\n"));
            QCOMPARE(areaOf(file), 5.0);
            QCOMPARE(file.triangles.size(), std::size_t(4));
            writeMeshFile(folder.path(name.toStdString()), file);
            const MeshFile back = readMeshFile(folder.path(name.toStdString()));
            QCOMPARE(back.cells.size(), 1);
            QVERIFY(std::ranges::equal(back.cells[0], file.cells[0]));
            QCOMPARE(areaOf(back), 5.0);
            if (name == "a.obj") QVERIFY(folder.get("a.obj").find(face) != std::string::npos);
            for (const auto& t : back.triangles) QVERIFY(cellMeasure<2>(back.points.topRows<2>(), t) > 0);
        }
    }
    /// An arrowhead is cut from its notch; convex polygons are fans as before.
    void quadrilaterals() {
        const std::string arrow = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n";
        const samples::Folder folder;
        const MeshFile file = readMeshFile(folder.put("a.obj", arrow));
        QCOMPARE(areaOf(file), 1.0);
        for (const auto& t : file.triangles)
            QVERIFY(std::ranges::count(t, 3) > 0 && std::ranges::count(t, 1) > 0);
        const MeshFile square =
            readMeshFile(folder.put("b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
        QCOMPARE(square.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
    }
    /// A polygon with random notches, whose area the shoelace formula gives.
    void combs() {
        samples::Random random(3);
        for (int n : {5, 12, 60}) {
            Eigen::Matrix3Xd points(3, 2 * n);
            double area = 0;
            std::vector<int> corners;
            for (int k = 0; k < 2 * n; ++k) {  // a star: radii differ, angles grow
                const double radius = random(0.1, 1), angle = std::numbers::pi * k / n;
                points.col(k) = Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 7);
                corners.push_back(k);
            }
            for (int k = 0; k < 2 * n; ++k) {
                const auto p = points.col(k), q = points.col((k + 1) % (2 * n));
                area += (p.x() * q.y() - p.y() * q.x()) / 2;
            }
            double sum = 0;
            const auto triangles = formats::splitPolygon(points, corners);
            QCOMPARE(triangles.size(), std::size_t(2 * n - 2));
            for (const auto& t : triangles) {
                const double one = cellMeasure<2>(points.topRows<2>(), t);
                QVERIFY(one > 0);
                sum += one;
            }
            QVERIFY(std::abs(sum - area) < 1e-12);
        }
    }
    void crossingPolygonsAreNamed() {
        const std::string bow = "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 3 4\n";
        QCOMPARE(reasonOf("a.obj", bow), std::string("line 6: the polygon crosses itself"));
        QCOMPARE(reasonOf("a.off", "OFF\n5 1 0\n0 0 0\n2 0 0\n0 1 0\n2 1 0\n1 3 0\n5 0 1 2 3 4\n"),
                 std::string("line 8: the polygon crosses itself"));
        QVERIFY(reasonOf("b.obj", "v 0 0 0\nv 1 0 3\nv 1 1 0\nv .5 2 3\nv 0 1 0\nf 1 2 3 4 5\n")
                    .starts_with("line 6: the corners of the polygon lie far from a plane"));
    }
    /// Points that are collinear except for the last bit are distinguished; products of doubles alone would
    /// not suffice.
    void exactOrientation() {
        const Eigen::Vector2d a(12, 12), b(24, 24);
        for (int k = -20; k <= 20; ++k) {
            const double x = 0.5, y = 0.5 + k * std::ldexp(1.0, -53);
            QCOMPARE(formats::orientation(a, b, {x, y}), k > 0 ? 1 : k < 0 ? -1 : 0);
        }
    }
    void continuedLines() {
        const samples::Folder folder;
        const MeshFile file = readMeshFile(folder.put(
            "a.obj",
            "v 0 \\\r\n 0 0\r\nv 1 0\\\r\n 0\r\nv 0 1 0\r\ng two \\\r\n names\r\nf 1 \\\r\n2 3\r\n"));
        QCOMPARE(areaOf(file), 0.5);
        QCOMPARE(file.groups.size(), std::size_t(2));
        QVERIFY(reasonOf("b.obj", "v 0 0 \\\n 0\nf 1 \\\n 2 3\n").starts_with("line 4: 2 is named"));
    }

    /// Neighbours agree on the faces between them, whatever their numbers are: no volume is lost or doubled.
    void splitCells() {
        for (unsigned seed = 1; seed < 40; ++seed) {
            MeshFile file = twoBoxes(seed);
            formats::finishCells(file);
            QCOMPARE(volumeOf(file), 2.0);
            QCOMPARE(file.tetrahedra.size(), std::size_t(12));
            const auto mesh = meshFrom<3>(file);  // throws where facets do not meet
            int outer = 0;
            for (const auto& facet : facetsOf<3>(mesh)) outer += !facet.interior();
            QCOMPARE(outer, 20);
        }
        const MeshFile all = vocabulary();
        QVERIFY(std::abs(volumeOf(all) - (1.0 / 6 + 1 + 0.5 + 1.0 / 3)) < 1e-14);
    }

    /// Every format returns the cells, values and groups that it was given, sorted by kinds in some.
    void vocabularies_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("version");
        QTest::addColumn<bool>("binary");
        for (const bool binary : {false, true}) {
            for (const char* name : {"a.vtu", "a.vtk", "a.msh"})
                QTest::addRow("%s %d", name, binary) << QString(name) << 4 << binary;
            QTest::addRow("2.2 %d", binary) << QString("a.msh") << 2 << binary;
        }
        for (const char* name : {"a.mesh", "a.inp", "a.bdf", "a.avs"})
            QTest::newRow(name) << QString(name) << 4 << false;
    }
    void vocabularies() {
        QFETCH(QString, name);
        QFETCH(int, version);
        QFETCH(bool, binary);
        const samples::Folder folder;
        const MeshFile file = vocabulary();
        MeshWriteOptions options;
        options.gmshVersion = version;
        if (binary) options.encoding = MeshWriteOptions::Encoding::Binary;
        writeMeshFile(folder.path(name.toStdString()), file, options);
        const MeshFile back = readMeshFile(folder.path(name.toStdString()));
        QVERIFY(samples::sameBits(back.points, file.points));
        QCOMPARE(sortedCells(back), sortedCells(file));
        const bool names = name == "a.msh" || name == "a.inp", tags = name != "a.inp";
        if (names) QCOMPARE(groupsOf(back, true), groupsOf(file, true));
        const bool fields = name != "a.mesh" && name != "a.inp" && name != "a.bdf";
        if (tags && !fields) QCOMPARE(groupsOf(back, false), groupsOf(file, false));
        if (!fields) return;
        QCOMPARE(back.cells.nodes, file.cells.nodes);  // in the order of the file
        QCOMPARE(find(back, "count")->ofCells, find(file, "count")->ofCells);
        QCOMPARE(find(back, "heat")->values, find(file, "heat")->values);
        if (name == "a.vtu" || name == "a.vtk") QVERIFY(find(back, "count")->type == formats::Scalar::Int32);
    }
    /// A loss is named once, in one line.
    void losses() {
        const MeshFile file = vocabulary();
        QCOMPARE(lostInFile("a.vtu", file, {}),
                 std::string("the names of 5 groups are not in a VTU (ParaView) file"));
        QCOMPARE(lostInFile("a.msh", file, {}), std::string());
        const std::string stl = lostInFile("a.node", file, {});
        QVERIFY2(stl.find("1 hexahedron is written as tetrahedra") != std::string::npos, stl.c_str());
        QVERIFY2(stl.find("2 fields (count, heat)") != std::string::npos, stl.c_str());
    }
    /// An element is in two groups: version 4.1 keeps both; Gmsh's version 2 lists it twice, which is one
    /// cell.
    void overlappingGroups() {
        const samples::Folder folder;
        MeshFile file = vocabulary();
        file.groups.push_back({"all", 3, 40, {0, 1, 2, 3}, {}, false});
        writeMeshFile(folder.path("a.msh"), file);
        QCOMPARE(groupsOf(readMeshFile(folder.path("a.msh")), true), groupsOf(file, true));
        const MeshFile twice = readMeshFile(folder.put(
            "b.msh",
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"a\"\n3 2 "
            "\"b\"\n$EndPhysicalNames\n"
            "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n"
            "2 4 2 2 1 1 2 3 4\n$EndElements\n"));
        QCOMPARE(twice.tetrahedra.size(), std::size_t(1));
        QCOMPARE(twice.groups.size(), std::size_t(2));
    }
    /// Lines and points of an OBJ file belong to the groups that they follow, as faces do.
    void groupsOfObj() {
        const samples::Folder folder;
        const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng skin wall\nf 1 2 3\ng wall\nl 1 2\np 3\n";
        const MeshFile file = readMeshFile(folder.put("a.obj", text));
        const auto groups = groupsOf(file, true);
        QCOMPARE(groups.size(), std::size_t(4));
        QCOMPARE(groups.at({1, "wall"}), (std::vector<std::vector<int>>{{0, 1}}));
        QCOMPARE(groups.at({0, "wall"}), (std::vector<std::vector<int>>{{2}}));
        MeshFile blanks = file;
        for (MeshGroup& group : blanks.groups)
            if (group.name == "skin") group.name = "the skin";
        QCOMPARE(lostInFile("a.obj", blanks, {}),
                 std::string("the name of 1 group is changed to what the format allows"));
    }
    void solidsOfStl() {
        const samples::Folder folder;
        const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 ",
                          end = "\nendloop\nendfacet\n";
        folder.put("a.stl", "solid left one\n" + facet + "0" + end + "endsolid left one\nsolid right\n" +
                                facet + "2" + end + facet + "3" + end + "endsolid right\n");
        const MeshFile file = readMeshFile(folder.path("a.stl"));
        for (const char* name : {"b.stl", "b.msh", "b.obj"}) {
            writeMeshFile(folder.path(name), file);
            const MeshFile back = readMeshFile(folder.path(name));
            QCOMPARE(back.groups.size(), std::size_t(2));
            QCOMPARE(back.groups[0].name, std::string(name) == "b.obj" ? "left_one" : "left one");
            QCOMPARE(back.groups[1].cells, (std::vector<int>{1, 2}));
        }
        QCOMPARE(groupVertices(file, "left one", {}), (std::vector<int>{0, 1, 2}));
        try {
            groupVertices(file, "middle", {});
            QFAIL("was found");
        } catch (const InputError& error) {
            QCOMPARE(QString(error.what()),
                     QString("there is no group 'middle' in the file; it has 'left one' (surfaces), "
                             "'right' (surfaces)"));
        }
    }
    void listsOfMedit() {
        const samples::Folder folder;
        const std::string text =
            "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 7\n0 1 0 0\n0 0 1 "
            "0\nTetrahedra\n1\n"
            "1 2 3 4 5\nEdges\n2\n1 2 5\n2 3 6\nCorners\n2\n1\n3\nRidges\n1\n2\nEnd\n";
        const MeshFile file = readMeshFile(folder.put("a.mesh", text));
        writeMeshFile(folder.path("b.mesh"), file);
        const std::string written = folder.get("b.mesh");
        for (const char* part :
             {"Corners\n2\n1\n3\n", "Ridges\n1\n2\n", "Edges\n2\n1 2 5\n2 3 6\n", "1 0 0 7\n"})
            QVERIFY2(written.find(part) != std::string::npos, part);
        QVERIFY(lostInFile("b.mesh", file, {}).empty());
        QVERIFY(lostInFile("b.vtu", file, {}).find("1 group of vertices") != std::string::npos);
    }
    /// The files have faces beside the usual pair of TetGen's, and numbers that begin at 0 or 1.
    void facesOfTetgen() {
        const samples::Folder folder;
        folder.put("a.node", "4 3 0 1\n0 0 0 0 1\n1 1 0 0 2\n2 0 1 0 3\n3 0 0 1 4\n");
        folder.put("a.ele", "1 4 1\n0 0 1 2 3 10\n");
        folder.put("a.face", "2 1\n0 0 1 2 5\n1 0 1 3 6\n");
        const MeshFile file = readMeshFile(folder.path("a.ele"));
        writeMeshFile(folder.path("b.node"), file);
        QCOMPARE(folder.get("b.face"), std::string("2 1\n0 0 1 2 5\n1 0 1 3 6\n"));
        QCOMPARE(folder.get("b.ele"), std::string("1 4 1\n0 0 1 2 3 10\n"));
        QVERIFY(folder.get("b.node").ends_with("\n3 0 0 1 4\n"));
        QCOMPARE(groupVertices(file, "6", {}), (std::vector<int>{0, 1, 3}));
    }
    /// Everything in a deck except the coordinates is unchanged.
    void decks() {
        const samples::Folder folder;
        const std::string
            head = "*HEADING\nmine, 1\n** a comment\n*NODE, NSET=all\n1, 0., 0., 0.\n2, 1., 0., 0.\n",
            tail =
                "3, 0., 1., 0.\n7, 0., 0., 1.\n*ELEMENT, TYPE=C3D4, ELSET=solid\n1, 1, 2,\n3, 7\n"
                "*NSET, NSET=end, GENERATE\n2, 3, 1\n*MATERIAL, NAME=steel\n*ELASTIC\n210000., .3\n";
        MeshFile file = readMeshFile(folder.put("a.inp", head + tail));
        QCOMPARE(file.tetrahedra.size(), std::size_t(1));
        QCOMPARE(groupVertices(file, "end", {}), (std::vector<int>{1, 2}));
        file.points(2, 1) = 0.25;
        writeMeshFile(folder.path("b.inp"), file);
        const std::string written = folder.get("b.inp");
        QVERIFY(written.find("2, 1., 0., 0.25\n") != std::string::npos);
        QVERIFY(written.ends_with(tail.substr(tail.find("*ELEMENT"))));
        QVERIFY(lostInFile("b.inp", file, {}).empty());
        QVERIFY(lostInFile("b.vtu", file, {}).find("its keywords *MATERIAL, *ELASTIC") != std::string::npos);

        const std::string bulk =
            "SOL 101\n"
            "BEGIN BULK\n"
            "GRID    1               0.      0.      0.\n"
            "GRID,2,,1.5-3,0.,0.\n"
            "GRID*   3                               0.              1.\n"
            "*       0.\n"
            "GRID    4               0.      0.      1.\n"
            "$ steel\n"
            "CTETRA  9       5       1       2       3       4\n"
            "PSOLID,5,1\n"
            "ENDDATA\n";
        MeshFile nastran = readMeshFile(folder.put("a.bdf", bulk));
        QCOMPARE(nastran.points(0, 1), 1.5e-3);
        QCOMPARE(nastran.points(1, 2), 1.0);
        writeMeshFile(folder.path("b.bdf"), nastran);
        QVERIFY(samples::sameBits(readMeshFile(folder.path("b.bdf")).points, nastran.points));
        QVERIFY(folder.get("b.bdf").find("PSOLID,5,1\nENDDATA\n") != std::string::npos);
    }
    /// A cell with its top inverted has a negative corner.
    void jacobians() {
        const MeshFile file = vocabulary();
        QVERIFY(turnedCells(file, file.points).empty());
        for (const double jacobian : cornerJacobians(file, file.points)) QVERIFY(jacobian > 0);
        Eigen::Matrix3Xd bent = file.points;
        bent.col(8 + 0).z() = -3;  // a top corner of the hexahedron below its bottom
        QVERIFY(turnedCells(file, bent).find("the first cell 1") != std::string::npos);
    }
    /// Normals rotate with the surface, and keep their bits where it does not move.
    void normals() {
        MeshFile file = toMeshFile<2>(samples::grid<2>(2));
        const auto n = static_cast<std::size_t>(file.points.cols());
        file.fields = {{"nx", false, 1, std::vector<double>(n, 0.6)},
                       {"ny", false, 1, std::vector<double>(n, 0.0)},
                       {"nz", false, 1, std::vector<double>(n, 0.8)}};
        MeshFile same = file;
        turnNormals(file.points, same);
        QCOMPARE(same.fields[0].values, file.fields[0].values);
        MeshFile turned = file;
        const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
        turned.points = R * file.points;
        turnNormals(file.points, turned);
        const Eigen::Vector3d wanted = R * Eigen::Vector3d(0.6, 0, 0.8);
        for (int k = 0; k < 3; ++k) QVERIFY(std::abs(turned.fields[k].values[4] - wanted[k]) < 1e-14);
    }
    void notANumber() {
        const samples::Folder folder;
        MeshFile file = vocabulary();
        file.fields[1].values[3] = std::nan("");
        for (const char* name : {"a.vtk", "a.vtu"}) {
            writeMeshFile(folder.path(name), file);
            if (std::string(name) == "a.vtk")  // VTK reads none from the text of this format
                QVERIFY(folder.get(name).find("BINARY") != std::string::npos);
            QVERIFY(std::isnan(find(readMeshFile(folder.path(name)), "heat")->values[3]));
        }
    }
};

QTEST_APPLESS_MAIN(TestMeshWhole)
#include "test_mesh_whole.moc"
