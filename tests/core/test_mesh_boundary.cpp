// Boundaries, fields and groups in files for other programs, read by independent readers.

#include <QtTest>

#include "plain_readers.h"
#include "test_mesh_files.h"

using namespace wend;
using samples::PlainMesh;

namespace {

/// Cubes of tetrahedra with their boundary, whose triangles are labelled 0, 1 and 2, and fields of all kinds.
MeshFile solidFile() {
    const auto cube = samples::jitteredGrid<3>(2);
    MeshFile file = toMeshFile<3>(cube);
    for (const auto& facet : facetsOf<3>(cube))
        if (!facet.interior()) file.triangles.push_back(facet.vertices);
    for (std::size_t t = 0; t < file.triangles.size(); ++t)
        file.labels.push_back(static_cast<int>(t / 5 % 3));
    file.labelNames = {"left", "right"};
    MeshField error{"error", true, 1, {}}, flow{"flow", false, 3, {}}, B{"B", true, 9, {}};
    for (std::size_t c = 0; c < file.tetrahedra.size(); ++c) {
        error.values.push_back(100 + static_cast<double>(c) / 3);
        for (int k = 0; k < 9; ++k) B.values.push_back(static_cast<double>(10 * c + k));
    }
    for (Eigen::Index i = 0; i < 3 * file.points.cols(); ++i) flow.values.push_back(1.0 / (1.0 + i));
    file.fields = {error, flow, B};
    return file;
}

MeshFile flatFile() {
    MeshFile file = toMeshFile<2>(samples::jitteredGrid<2>(3));
    MeshField error{"error", true, 1, {}}, B{"B", true, 4, {}}, flow{"flow", false, 2, {}};
    for (std::size_t c = 0; c < file.triangles.size(); ++c) {
        error.values.push_back(7 + static_cast<double>(c));
        for (int k = 0; k < 4; ++k) B.values.push_back(static_cast<double>(10 * c + k));
    }
    for (Eigen::Index i = 0; i < 2 * file.points.cols(); ++i) flow.values.push_back(0.5 * i);
    file.fields = {error, B, flow};
    return file;
}

PlainMesh written(const MeshFile& file, const std::string& name, MeshWriteOptions options = {}) {
    const samples::Folder folder;
    if (name.ends_with("2.msh")) options.gmshVersion = 2;
    writeMeshFile(folder.path(name), file, options);
    const std::string text = folder.get(name);
    if (name.ends_with(".vtu")) return samples::plainVtu(text);
    if (name.ends_with(".avs")) return samples::plainUcd(text);
    return name.ends_with(".vtk") ? samples::plainVtk(text) : samples::plainMsh(text);
}

std::vector<const PlainMesh::Cell*> cellsOf(const PlainMesh& mesh, std::size_t corners) {
    std::vector<const PlainMesh::Cell*> found;
    for (const auto& cell : mesh.cells)
        if (cell.corners.size() == corners) found.push_back(&cell);
    return found;
}

/// The tetrahedron of a triangle's three corners and one more.
int ownerOf(const MeshFile& file, const std::vector<int>& triangle) {
    for (std::size_t c = 0; c < file.tetrahedra.size(); ++c)
        if (std::ranges::all_of(triangle,
                                [&](int v) { return std::ranges::count(file.tetrahedra[c], v) > 0; }))
            return static_cast<int>(c);
    return -1;
}

void everyFormat() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.vtu", "a.vtk", "a.avs", "a4.msh", "a2.msh"})
        QTest::newRow(name) << QString(name);
}

}  // namespace

class TestMeshBoundary : public QObject {
    Q_OBJECT

  private slots:
    /// Every triangle has its tetrahedron's values, wherever it is in the file.
    void boundaryHasItsCellsValues_data() { everyFormat(); }
    void boundaryHasItsCellsValues() {
        QFETCH(QString, name);
        const MeshFile file = solidFile();
        const PlainMesh mesh = written(file, name.toStdString());
        QCOMPARE(mesh.complaints, std::vector<std::string>());
        QCOMPARE(mesh.cells.size(), file.tetrahedra.size() + file.triangles.size());
        const auto &error = mesh.cellData.at("error"), &B = mesh.cellData.at("B");
        QCOMPARE(error.size(), mesh.cells.size());
        QCOMPARE(B.size(), 9 * mesh.cells.size());
        for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
            const int owner = ownerOf(file, mesh.cells[i].corners);
            QCOMPARE(error[i], file.fields[0].values[owner]);
            for (int k = 0; k < 9; ++k) QCOMPARE(B[9 * i + k], file.fields[2].values[9 * owner + k]);
        }
        QCOMPARE(mesh.pointData.at("flow"), file.fields[1].values);
    }

    /// A triangle that bounds no tetrahedron has no value that could be taken for one.
    void strangeTriangleHasNoValue() {
        MeshFile file = solidFile();
        file.triangles.push_back({0, 13, 26});
        file.labels.push_back(1);
        const PlainMesh mesh = written(file, "a.vtu");
        QVERIFY(std::isnan(mesh.cellData.at("error").back()));
    }

    /// A boundary that was made with the cells is left out of visualization formats unless it is requested.
    void madeBoundaryGoesToSolvers_data() { everyFormat(); }
    void madeBoundaryGoesToSolvers() {
        QFETCH(QString, name);
        MeshFile file = solidFile();
        file.made = true;
        const bool forSolvers = name == "a4.msh";
        const PlainMesh unasked = written(file, name.toStdString());
        QCOMPARE(cellsOf(unasked, 3).size(), forSolvers ? file.triangles.size() : 0);
        QCOMPARE(unasked.cellData.at("error").size(), unasked.cells.size());
        QCOMPARE(unasked.cellData.contains("label"), false);
        MeshFile bare = file;  // meshio reads version 2.2 so, and with values without the boundary
        bare.fields.clear();
        QCOMPARE(cellsOf(written(bare, name.toStdString()), 3).size(),
                 name.endsWith(".msh") ? file.triangles.size() : 0);
        MeshWriteOptions options;
        options.boundary = true;
        QCOMPARE(cellsOf(written(file, name.toStdString(), options), 3).size(), file.triangles.size());
        MeshFile read = solidFile();  // that has none
        read.triangles.clear();
        read.labels.clear();
        QCOMPARE(cellsOf(written(read, name.toStdString()), 3).size(), std::size_t(0));
        QCOMPARE(cellsOf(written(read, name.toStdString(), options), 3).size(), file.triangles.size());
    }

    /// In a generated mesh, vertices without a cell are left out, and values at the others are kept.
    void spareVerticesStayOut_data() { everyFormat(); }
    void spareVerticesStayOut() {
        QFETCH(QString, name);
        const MeshFile plain = solidFile();
        MeshFile file = plain;
        file.points.resize(3, plain.points.cols() + 2);
        file.points << plain.points.col(4), plain.points, Vec3::Constant(50);
        for (auto& cell : file.tetrahedra)
            for (int& v : cell) ++v;
        for (auto& cell : file.triangles)
            for (int& v : cell) ++v;
        auto& flow = file.fields[1].values;
        flow.insert(flow.begin(), 3, -1);
        flow.insert(flow.end(), 3, -2);
        QCOMPARE(written(file, name.toStdString()).points.size(), std::size_t(file.points.cols()));
        file.made = true;
        const PlainMesh mesh = written(file, name.toStdString());
        QCOMPARE(mesh.points.size(), std::size_t(plain.points.cols()));
        for (Eigen::Index v = 0; v < plain.points.cols(); ++v)
            for (int k = 0; k < 3; ++k) QCOMPARE(mesh.points[v][k], plain.points(k, v));
        QCOMPARE(mesh.pointData.at("flow"), plain.fields[1].values);
        const auto tetrahedra = cellsOf(mesh, 4);
        for (std::size_t c = 0; c < tetrahedra.size(); ++c)
            QVERIFY(std::ranges::equal(tetrahedra[c]->corners, plain.tetrahedra[c]));
    }

    /// Every element is in a group: solvers read 0 as none. Labels keep their numbers and names.
    void groupsOfGmsh_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"a4.msh", "a2.msh"}) QTest::newRow(name) << QString(name);
    }
    void groupsOfGmsh() {
        QFETCH(QString, name);
        const MeshFile file = solidFile();
        const PlainMesh mesh = written(file, name.toStdString());
        using Groups = std::map<std::string, std::pair<int, int>>;
        QCOMPARE(mesh.groups,
                 (Groups{{"left", {2, 1}}, {"right", {2, 2}}, {"boundary", {2, 3}}, {"volume", {3, 1}}}));
        const auto triangles = cellsOf(mesh, 3);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            QCOMPARE(triangles[t]->physical, file.labels[t] == 0 ? 3 : file.labels[t]);
        for (const auto* cell : cellsOf(mesh, 4)) QCOMPARE(cell->physical, 1);
        const PlainMesh flat = written(flatFile(), name.toStdString());
        QCOMPARE(flat.groups, (Groups{{"surface", {2, 1}}}));
        for (const auto& cell : flat.cells) QCOMPARE(cell.physical, 1);
    }

    /// Tags are unchanged; two groups in one entity make two entities.
    void tagsOfGmsh_data() { groupsOfGmsh_data(); }
    void tagsOfGmsh() {
        QFETCH(QString, name);
        MeshFile file = flatFile();
        MeshField physical{"physical", true, 1, {}}, entity{"entity", true, 1, {}};
        for (std::size_t c = 0; c < file.triangles.size(); ++c) {
            physical.values.push_back(static_cast<double>(c % 3 == 0 ? 0 : 10 + c % 3));
            entity.values.push_back(4);
        }
        file.fields = {physical, entity};
        const PlainMesh mesh = written(file, name.toStdString());
        QCOMPARE(mesh.complaints, std::vector<std::string>());
        std::map<int, int> groupOfEntity;
        for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
            QCOMPARE(mesh.cells[c].physical, c % 3 == 0 ? 13 : 10 + static_cast<int>(c % 3));
            const int group =
                groupOfEntity.try_emplace(mesh.cells[c].entity, mesh.cells[c].physical).first->second;
            QCOMPARE(group, mesh.cells[c].physical);
        }
        QVERIFY(mesh.cellData.empty());  // they stand with the cells
        const samples::Folder folder;
        writeMeshFile(folder.path("a.msh"), file, {});
        for (const auto& field : readMeshFile(folder.path("a.msh")).fields)
            if (field.name == "physical") QCOMPARE(field.values, physical.values);
    }

    /// Values in the plane are filled up to the sizes that Gmsh draws: vectors of three, tensors of nine.
    void valuesOfThePlane_data() { groupsOfGmsh_data(); }
    void valuesOfThePlane() {
        QFETCH(QString, name);
        const MeshFile file = flatFile();
        const PlainMesh mesh = written(file, name.toStdString());
        QCOMPARE(mesh.complaints, std::vector<std::string>());
        const auto &B = mesh.cellData.at("B"), &flow = mesh.pointData.at("flow");
        QCOMPARE(B.size(), 9 * file.triangles.size());
        for (std::size_t c = 0; c < file.triangles.size(); ++c) {
            const std::vector<double> rows(B.begin() + 9 * c, B.begin() + 9 * c + 9);
            const double b = 10.0 * c;
            QCOMPARE(rows, (std::vector<double>{b, b + 1, 0, b + 2, b + 3, 0, 0, 0, 0}));
        }
        for (std::size_t v = 0; v < mesh.points.size(); ++v)
            QCOMPARE((std::vector<double>(flow.begin() + 3 * v, flow.begin() + 3 * v + 3)),
                     (std::vector<double>{1.0 * v, 1.0 * v + 0.5, 0}));
        QCOMPARE(mesh.cellData.at("error"), file.fields[0].values);
    }
};

QTEST_APPLESS_MAIN(TestMeshBoundary)
#include "test_mesh_boundary.moc"
