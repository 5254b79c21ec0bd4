// Solids on the command line: from surfaces to files for other programs, and the messages where that fails.

#include <QtTest>

#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/child_processes.h"
#include "tests/support/mesh_files.h"
#include "tests/support/surfaces.h"

using namespace wend;

class TestSolidCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void meshCommand_data();
    void meshCommand();
    void meshOptions();
    void volumeOutputs_data();
    void volumeOutputs();
    void skinOutputs_data();
    void skinOutputs();
    void objKeepsItsLook();
    void framesWithCollection();
    void animation();
    void fieldsAreLeftOut();
    void infoOfVolume();
    void infoOfBadSurface();
    void badSurfaces_data();
    void badSurfaces();
    void cagedSurfaceBends();
    void faultsAreCounted();
    void cancelledMeshing();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const QString& name) const { return (path() + "/" + name).toStdString(); }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0 && result.error.isEmpty(),
                 qPrintable(QString::number(result.code) + result.error));
    }
    void write(const char* name, const Surface& surface) const { test::writeSurface(file(name), surface); }

    QTemporaryDir m_folder;
};

namespace {

const Surface kBar = test::box({0, 0, 0}, {2, 1, 1}, 6);

const MeshField* find(const MeshFile& file, const std::string& name) {
    for (const auto& field : fieldsOf(file))
        if (field.name == name) return &field;
    return nullptr;
}

double volumeOf(const MeshFile& file) {
    double sum = 0;
    for (const auto& cell : tetrahedraOf(file)) sum += cellMeasure<3>(pointsOf(file), cell);
    return sum;
}

}  // namespace

void TestSolidCli::initTestCase() {
    write("bar.off", kBar);
    // The same as OBJ with two materials and texture points of corners.
    std::string text = "mtllib bar.mtl\nvt 0 0\nvt 1 0\nvt 0 1\n";
    for (int v = 0; v < kBar.vertexCount(); ++v)
        text += "v " + std::to_string(kBar.points(0, v)) + " " + std::to_string(kBar.points(1, v)) + " " +
                std::to_string(kBar.points(2, v)) + "\n";
    for (int t = 0; t < kBar.triangleCount(); ++t) {
        if (t == 0 || t == 100) text += t == 0 ? "usemtl red\n" : "usemtl blue\n";
        text += "f";
        for (int k = 0; k < 3; ++k)
            text += " " + std::to_string(kBar.triangles[t][k] + 1) + "/" + std::to_string(k + 1);
        text += "\n";
    }
    put(path(), "bar.obj", text);
    put(path(), "bar.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    putProject(
        path(), "twist.wend",
        "'domain': {'surface': 'bar.obj', 'vertices': 350}, 'material': {'regions': [{'shape': {'sphere': "
        "{'centre': [1, 0.5, 0.5], 'radius': 0.5}}, 'stiffness': {'axis': [1, 0, 0], 'ratio': 4}}]}, "
        "'handles': [{'at': {'region': {'box': {'min': [-1, -1, -1], 'max': [0.1, 2, 2]}}}},"
        "{'at': {'region': {'box': {'min': [1.9, -1, -1], 'max': [4, 2, 2]}}}, 'motion': [{'kind': 'rotate',"
        "'centre': [2, 0.5, 0.5], 'axis': [1, 0, 0], 'angle': 1.5}]}]");
}

void TestSolidCli::meshCommand_data() {
    QTest::addColumn<QStringList>("output");
    for (const char* name : {"a.mesh", "a.msh", "a.node"}) QTest::newRow(name) << QStringList{name};
    for (const char* name : {"a.vtk", "a.vtu"}) QTest::newRow(name) << QStringList{name, "--border"};
    QTest::newRow("old msh") << QStringList{"old.msh", "--msh", "2.2"};
    QTest::newRow("binary msh") << QStringList{"binary.msh", "--encoding", "binary"};
    QTest::newRow("compressed") << QStringList{"small.vtu", "--encoding", "compressed", "--border"};
}
void TestSolidCli::meshCommand() {
    QFETCH(QStringList, output);
    succeed(QStringList{"mesh", "bar.obj", "--vertices", "600", "-o"} + output);
    const auto mesh = sharedMeshFile(file(output[0]));
    QVERIFY(std::abs(pointsOf(*mesh).cols() - 600) <= 90);
    QVERIFY(std::abs(volumeOf(*mesh) - 2) < 1e-12);
    QVERIFY((pointsOf(*mesh).leftCols(kBar.vertexCount()) - kBar.points).cwiseAbs().maxCoeff() < 1e-6);  // %f
    if (output[0].endsWith(".node")) return;
    QCOMPARE(trianglesOf(*mesh).size(), kBar.triangles.size());
    QCOMPARE(std::ranges::count(labelsOf(*mesh), 1), 100);
    QCOMPARE(std::ranges::count(labelsOf(*mesh), 2), kBar.triangleCount() - 100);
    if (output[0].endsWith(".msh"))
        QVERIFY(test::labelNamesOf(*mesh) == (std::vector<std::string>{"red", "blue"}));
}

void TestSolidCli::meshOptions() {
    succeed({"mesh", "bar.off", "--max-volume", "0.002", "--refine-surface", "-o", "fine.vtu"});
    const auto fine = sharedMeshFile(file("fine.vtu"));
    int tooLarge = 0;  // TetGen leaves some, hardly larger, whose new vertex would come too close to others
    for (const auto& cell : tetrahedraOf(*fine)) {
        const double volume = cellMeasure<3>(pointsOf(*fine), cell);
        QVERIFY(volume <= 0.002 * 1.5);
        tooLarge += volume > 0.002 * (1 + 1e-9);
    }
    QVERIFY(static_cast<std::size_t>(tooLarge) * 50 <= tetrahedraOf(*fine).size());
    Surface holed = kBar;
    holed.triangles.pop_back();
    write("holed.off", holed);
    const CliResult repaired =
        run({"mesh", "holed.off", "--repair", "-o", "repaired.vtu", "--vertices", "500"});
    QCOMPARE(repaired.code, 0);
    QCOMPARE(repaired.error, QString("wend: holed.off: the surface was repaired: 1 hole filled\n"));
    put(path(), "paint.txt", std::string(2 * kBar.vertexCount(), ' ').replace(0, 1, "1"));
    QCOMPARE(run({"mesh", "bar.off", "--sizes", "paint.txt", "-o", "p.vtu"}).code, 3);
    QCOMPARE(run({"mesh", "bar.off", "--cage", "--no-cage", "-o", "p.vtu"}).code, 2);
    QCOMPARE(run({"mesh", "bar.off", "--cage-detail", "0", "-o", "p.vtu"}).code, 2);
    succeed({"mesh", "bar.off", "--cage", "--cage-detail", "3", "--vertices", "500", "-o", "caged.vtu"});
    QVERIFY(volumeOf(*sharedMeshFile(file("caged.vtu"))) > 2);
    QCOMPARE(run({"mesh", "bar.off", "--largest-hole", "3", "-o", "p.vtu"}).code, 2);
    QCOMPARE(run({"mesh", "bar.off", "--vertices", "300", "--max-volume", "1", "-o", "p.vtu"}).code, 2);
    const CliResult surface = run({"mesh", "bar.off", "-o", "p.stl"});
    QCOMPARE(surface.code, 3);
    QVERIFY2(surface.error.contains("cannot hold tetrahedra"), qPrintable(surface.error));
}

void TestSolidCli::volumeOutputs_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("fields");
    for (const char* name : {"t.mesh", "t.msh", "t.node"}) QTest::newRow(name) << name << false;
    for (const char* name : {"t.vtk", "t.vtu"}) QTest::newRow(name) << name << true;
}
void TestSolidCli::volumeOutputs() {
    QFETCH(QString, name);
    QFETCH(bool, fields);
    succeed({"run", "twist.wend", "--mesh", name});
    const auto mesh = sharedMeshFile(file(name));
    QVERIFY(tetrahedraOf(*mesh).size() > 500);
    if (name == "t.msh") {  // Gmsh's own data, which is not read back here
        const std::string text = readTextFile(file(name));
        for (const char* field : {"\"error_metric\"", "\"phi\"", "\"B\"", "\"velocity\""})
            QVERIFY2(text.find(field) != std::string::npos, field);
    }
    if (!fields) return;
    for (const char* field : {"error_angle", "error_volume", "error_metric", "ratio", "phi"})
        QCOMPARE(find(*mesh, field)->values.size(), tetrahedraOf(*mesh).size());
    QCOMPARE(find(*mesh, "B")->components, 9);
    QCOMPARE(find(*mesh, "phi")->values[0], std::atan(0.5));
    const MeshField* velocity = find(*mesh, "velocity");
    QVERIFY(!velocity->perCell && velocity->components == 3);
    QVERIFY(trianglesOf(*mesh).empty());
    succeed({"run", "twist.wend", "--mesh", "bordered-" + name, "--border"});
    const auto bordered = sharedMeshFile(file("bordered-" + name));
    QVERIFY(std::ranges::count(labelsOf(*bordered), 2) > 0 && tetrahedraOf(*bordered) == tetrahedraOf(*mesh));
    double most = 0;
    for (double x : velocity->values) most = std::max(most, std::abs(x));
    QVERIFY(most > 0.5 && most < 3);  // 1.5 radians in a unit of time, half a diagonal away at most
}

void TestSolidCli::skinOutputs_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("lost");
    QTest::newRow("obj") << "s.obj"
                         << "";
    QTest::newRow("ply") << "s.ply"
                         << "the names of 2 groups are not in a PLY file";
    QTest::newRow("stl") << "s.stl"
                         << "texture coordinates are not in an STL file";
    QTest::newRow("off") << "s.off"
                         << "2 groups (red, blue) and texture coordinates that differ between the faces of "
                            "a vertex are not in an OFF file";
}
void TestSolidCli::skinOutputs() {
    QFETCH(QString, name);
    QFETCH(QString, lost);
    const CliResult result = run({"run", "twist.wend", "--mesh", name});
    QCOMPARE(result.error, lost.isEmpty() ? QString() : "wend: twist.wend: " + name + ": " + lost + "\n");
    QCOMPARE(result.code, 0);
    succeed({"run", "twist.wend", "--mesh", "whole.mesh"});
    const auto skin = sharedMeshFile(file(name));
    const auto whole = sharedMeshFile(file("whole.mesh"));
    QCOMPARE(trianglesOf(*skin).size(), kBar.triangles.size());
    if (name != "s.stl")
        QVERIFY(pointsOf(*skin) == pointsOf(*whole).leftCols(kBar.vertexCount()));  // to the last bit
    if (name != "s.ply") return;
    QCOMPARE(find(*skin, "error_metric")->values.size(), std::size_t(pointsOf(*skin).cols()));
    QVERIFY(find(*skin, "velocity_2") != nullptr);
    QCOMPARE(uvOf(*skin).cols(), pointsOf(*skin).cols());
}

void TestSolidCli::objKeepsItsLook() {
    QDir(path()).mkdir("out");
    succeed({"run", "twist.wend", "--mesh", "out/look.obj"});
    const Skin before = readSkin(file("bar.obj")), after = readSkin(file("out/look.obj"));
    QVERIFY(after.uvCorners == before.uvCorners && after.materialOf == before.materialOf);
    QVERIFY(after.warnings.empty());  // the material file is found from there
}

void TestSolidCli::framesWithCollection() {
    QDir(path()).mkdir("frames");
    succeed({"run", "twist.wend", "--frames", "frames/f_####.vtu", "--count", "3"});
    QCOMPARE(QDir(path() + "/frames").entryList(QDir::Files),
             (QStringList{"f.pvd", "f_0000.vtu", "f_0001.vtu", "f_0002.vtu"}));
    const std::string text = readTextFile(file("frames/f.pvd"));
    QVERIFY2(text.find("<DataSet timestep=\"0.5\" part=\"0\" file=\"f_0001.vtu\"/>") != std::string::npos,
             text.c_str());
    const auto rest = sharedMeshFile(file("frames/f_0000.vtu"));
    for (double error : find(*rest, "error_metric")->values) QVERIFY(std::abs(error) < 1e-12);
}

void TestSolidCli::animation() {
    succeed({"run", "twist.wend", "--frames", "move.glb", "--count", "5", "--fps", "8"});
    const std::string bytes = readTextFile(file("move.glb"));
    QCOMPARE(bytes.substr(0, 4), std::string("glTF"));
    const auto length = static_cast<unsigned char>(bytes[12]) + 256 * static_cast<unsigned char>(bytes[13]) +
                        65536 * static_cast<unsigned char>(bytes[14]);
    const auto gltf = QJsonDocument::fromJson(QByteArray::fromStdString(bytes.substr(20, length)));
    const auto parts = gltf["meshes"][0]["primitives"].toArray();
    QCOMPARE(parts.size(), qsizetype(2));
    QCOMPARE(parts[0].toObject()["targets"].toArray().size(), qsizetype(5));
    const auto times = gltf["accessors"][gltf["animations"][0]["samplers"][0]["input"].toInt()];
    QCOMPARE(times["count"].toInt(), 5);
    QCOMPARE(times["max"][0].toDouble(), 0.5);
    QCOMPARE(run({"run", "twist.wend", "--frames", "f_##.vtu", "--fps", "8"}).code, 2);
}

void TestSolidCli::fieldsAreLeftOut() {
    succeed({"run", "twist.wend", "--mesh", "bare.vtu", "--fields", "none"});
    QVERIFY(fieldsOf(*sharedMeshFile(file("bare.vtu"))).empty());
}

void TestSolidCli::infoOfVolume() {
    succeed({"mesh", "bar.off", "--vertices", "500", "-o", "info.vtu"});
    const auto info = QJsonDocument::fromJson(run({"info", "info.vtu", "--json"}).out.toUtf8());
    const auto sum = [&](const char* name) {
        int total = 0;
        for (const QJsonValue count : info["quality"][name]["counts"].toArray()) total += count.toInt();
        return total;
    };
    const int cells = info["cells"].toInt();
    QCOMPARE(sum("angles"), 6 * cells);
    QCOMPARE(sum("radiusEdgeRatios"), cells);
    QCOMPARE(sum("cellSizesToTheMean"), cells);
    QVERIFY(run({"info", "info.vtu"}).out.contains("█"));
    const CliResult none = run({"info", "info.vtu", "--problems", "none.vtu"});
    QVERIFY(none.code == 0 && !QFileInfo::exists(path() + "/none.vtu"));
    QVERIFY2(none.error.contains("there are no problems"), qPrintable(none.error));
}

void TestSolidCli::infoOfBadSurface() {
    Surface bad = test::joined(kBar, test::box({1.5, 0.2, 0.2}, {4, 0.8, 0.8}));
    bad.triangles.push_back({0, 0, 1});
    write("crossing.off", bad);
    succeed({"info", "crossing.off", "--problems", "wrong.ply"});
    const auto info = QJsonDocument::fromJson(run({"info", "crossing.off", "--json"}).out.toUtf8());
    QHash<QString, QJsonObject> problems;
    for (const QJsonValue problem : info["problems"].toArray())
        problems[problem["what"].toString()] = problem.toObject();
    QCOMPARE(problems["triangles without area"]["where"].toArray(), (QJsonArray{bad.triangleCount() - 1}));
    const QJsonArray pairs = problems["pairs of triangles that intersect"]["where"].toArray();
    QVERIFY(!pairs.isEmpty());
    const auto wrong = sharedMeshFile(file("wrong.ply"));
    const MeshField* cells = find(*wrong, "cell");
    QVERIFY(cells != nullptr);
    const MeshField* crossing = find(*wrong, "crossing");  // which fault each one has
    const MeshField* flat = find(*wrong, "flat");
    QVERIFY(crossing && flat && flat->values.back() == 1 && crossing->values.back() == 0);
    for (std::size_t i = 0; i < crossing->values.size(); ++i) {
        const auto has = [&](const QJsonValue pair) {
            return pair.toArray().contains(static_cast<int>(cells->values[i]));
        };
        QCOMPARE(crossing->values[i] == 1, std::any_of(pairs.begin(), pairs.end(), has));
    }
    for (const QJsonValue pair : pairs)
        for (const QJsonValue t : pair.toArray())
            QCOMPARE(std::ranges::count(cells->values, t.toInt()), std::ptrdiff_t(1));
    for (std::size_t i = 0; i < trianglesOf(*wrong).size(); ++i) {  // the same corners as in the file
        const auto& original = bad.triangles[static_cast<std::size_t>(cells->values[i])];
        for (int k = 0; k < 3; ++k)
            QVERIFY(pointsOf(*wrong).col(trianglesOf(*wrong)[i][k]) == bad.points.col(original[k]));
    }
}

void TestSolidCli::badSurfaces_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    const auto row = [&](const char* name, const Surface& surface, const char* reason) {
        write((std::string(name) + ".off").c_str(), surface);
        QTest::newRow(name) << QString(name) + ".off" << reason;
    };
    const auto textRow = [&](const char* name, const std::string& text, const char* reason) {
        put(path(), name, text);
        QTest::newRow(name) << QString(name) << reason;
    };
    const auto changed = [](const std::function<void(Surface&)>& change) {
        Surface surface = kBar;
        change(surface);
        return surface;
    };
    row("open", changed([](Surface& s) { s.triangles.pop_back(); }), "3 open edges (first: ");
    row("pushed-through", changed([](Surface& s) { s.points.col(0) = Vec3(1.5, 2, 2); }),
        "triangles that intersect");
    row("shells-cross", test::joined(kBar, test::box({1, 0.2, 0.2}, {5, 0.8, 0.8})),
        "triangles that intersect");
    row("moebius", test::moebius(24), "open edges");
    row("flat", changed([](Surface& s) { s.points.row(1).setZero(); }), "all points lie in one plane");
    row("one-triangle", Surface{kBar.points, {kBar.triangles[0]}, {}}, "open edges");
    row("no-area", changed([](Surface& s) { s.triangles.push_back({0, 1, 0}); }), "1 triangle without area");
    row("twice", changed([](Surface& s) { s.triangles.push_back(s.triangles[7]); }), "1 duplicate triangle");
    textRow("nan.off", "OFF\n3 1 0\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n", "line 4");
    textRow("empty.stl", "", "is empty");
    textRow("picture.obj", "\x89PNG\r\n\x1a\n", "picture.obj: line 1");
    textRow("words.ply", "Dear diary,\n", "does not begin with 'ply'");
    textRow("cut.ply", "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\n", "cut.ply");
    textRow("lies.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", "lies.off: line 2");
    textRow("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "neither triangles nor tetrahedra");
}
void TestSolidCli::badSurfaces() {
    QFETCH(QString, name);
    QFETCH(QString, reason);
    const CliResult result = run({"mesh", name, "--no-cage", "-o", "never.vtu"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.startsWith("wend: " + name + ": ") && result.error.count('\n') == 1,
             qPrintable(result.error));
    QVERIFY2(result.error.contains(reason), qPrintable(result.error));
    QVERIFY(!QFileInfo::exists(path() + "/never.vtu"));

    const CliResult free = run({"mesh", name, "--vertices", "400", "-o", "caged.vtu", "--json"});
    const bool isOff = name.endsWith(".off") && name != "nan.off" && name != "lies.off";
    if (!isOff || name == "flat.off") {
        QCOMPARE(free.code, 3);
        QVERIFY(free.error.count('\n') == 1 && !QFileInfo::exists(path() + "/caged.vtu"));
        return;
    }
    QCOMPARE(free.code, 0);
    QVERIFY2(free.error.startsWith("wend: " + name + ": the surface is embedded in a cage of ") &&
                 free.error.contains(reason),
             qPrintable(free.error));
    const auto told = QJsonDocument::fromJson(free.out.toUtf8());
    QVERIFY(told["cage"]["why"].toString().contains(reason));
    const auto caged = sharedMeshFile(file("caged.vtu"));
    QCOMPARE(told["vertices"].toInt(), int(pointsOf(*caged).cols()));
    QVERIFY(std::abs(pointsOf(*caged).cols() - 400) <= 60);
    QFile::remove(path() + "/caged.vtu");
}

/// Crossing boxes bend in a cage and come out with their texture points and materials.
void TestSolidCli::cagedSurfaceBends() {
    std::string text = readTextFile(file("bar.obj"));
    const Surface other = test::box({1, 0.3, 0.3}, {3, 0.7, 0.7});
    for (int v = 0; v < other.vertexCount(); ++v)
        text += "v " + std::to_string(other.points(0, v)) + " " + std::to_string(other.points(1, v)) + " " +
                std::to_string(other.points(2, v)) + "\n";
    text += "g spike\nusemtl red\n";
    for (const auto& t : other.triangles) {
        text += "f";
        for (int k = 0; k < 3; ++k)
            text += " " + std::to_string(kBar.vertexCount() + t[k] + 1) + "/" + std::to_string(k + 1);
        text += "\n";
    }
    put(path(), "spiked.obj", text);
    putProject(
        path(), "bend.wend",
        "'domain': {'surface': 'spiked.obj', 'vertices': 600}, 'handles': [{'at': {'vertices': [0, 1, "
        "2, 3]}}, {'at': {'region': {'box': {'min': [2.5, -1, -1], 'max': [4, 2, 2]}}}, 'motion': "
        "[{'kind': 'rotate', 'centre': [1, 0.5, 0.5], 'axis': [0, 0, 1], 'angle': 1.5707963267948966}]}]");
    const CliResult result = run({"run", "bend.wend", "--mesh", "bent.obj", "--report", "bend.json"});
    QVERIFY2(result.code == 0 && result.error.contains("is embedded in a cage of") &&
                 result.error.contains("move together as 1"),
             qPrintable(result.error));
    const auto lines = [](const std::string& all, const char* start) {
        QStringList found;
        for (const QString& line : QString::fromStdString(all).split('\n'))
            if (line.startsWith(start)) found << line.trimmed();
        return found;
    };
    const std::string bent = readTextFile(file("bent.obj"));
    for (const char* kind : {"vt ", "f ", "usemtl ", "g "}) QCOMPARE(lines(bent, kind), lines(text, kind));
    const QStringList before = lines(text, "v "), after = lines(bent, "v ");
    QCOMPARE(after.size(), before.size());
    const auto place = [](const QString& line) {
        const QStringList words = line.split(' ', Qt::SkipEmptyParts);
        return Vec3(words[1].toDouble(), words[2].toDouble(), words[3].toDouble());
    };
    for (int v = 0; v < 4; ++v)  // held, by the numbers that they have in the file
        QVERIFY((place(after[v]) - place(before[v])).norm() < 1e-3);
    // The tip is rotated by a right angle about (1, ½, ½).
    const Vec3 tip = place(before.last()), turned(1 - (tip.y() - 0.5), 0.5 + (tip.x() - 1), tip.z());
    QVERIFY2((place(after.last()) - turned).norm() < 0.05, qPrintable(after.last()));
    const auto report = QJsonDocument::fromJson(readTextFile(file("bend.json")).c_str());
    QCOMPARE(report["cage"]["parts"].toInt(), 2);
    QCOMPARE(report["flips"].toInt(), 0);
}

/// Meshing that would take hours ends at a signal and leaves nothing behind. A bar moves into another one,
/// into a corner of it, and grows to three times its size meanwhile.
void TestSolidCli::faultsAreCounted() {
    SimplicialMesh<3> pair = barMesh(2);
    const int first = pair.vertexCount(), cells = pair.cellCount();
    pair.points.conservativeResize(Eigen::NoChange, 2 * first);
    pair.points.rightCols(first) = pair.points.leftCols(first).colwise() + Vec3(8, 0, 0);
    for (int c = 0; c < cells; ++c) {
        Cell<3> cell = pair.cells[c];
        for (int& v : cell) v += first;
        pair.cells.push_back(cell);
    }
    writeMesh<3>(file("pair.mesh"), pair);
    const auto moved = [&](const std::string& motion) {
        putProject(path(), "pair.wend",
                   "'domain': {'mesh': 'pair.mesh'}, 'handles': ["
                   "{'at': {'region': {'box': {'min': [-1, -1, -1], 'max': [3, 3, 3]}}}},"
                   "{'at': {'region': {'box': {'min': [7, -1, -1], 'max': [11, 3, 3]}}}, 'motion': [" +
                       motion + "]}]");
        return run({"run", "pair.wend", "--report", "r.json"});
    };
    const auto part = [&](const char* key) {
        QFile report(path() + "/r.json");
        return report.open(QIODevice::ReadOnly)
                   ? QJsonDocument::fromJson(report.readAll()).object()[key].toObject()
                   : QJsonObject();
    };
    const CliResult apart = moved("{'kind': 'translate', 'by': [-5.13, 0.71, 0.53]}");
    QCOMPARE(apart.error, QString());
    QCOMPARE(part("selfCrossings"), (QJsonObject{{"places", 0}, {"pairs", 0}, {"first", QJsonValue::Null}}));
    QCOMPARE(part("blownUp"),
             (QJsonObject{{"factor", 10}, {"cells", 0}, {"places", 0}, {"worst", QJsonValue::Null}}));

    const CliResult inside = moved("{'kind': 'translate', 'by': [-7.13, 0.71, 0.53]}");
    QCOMPARE(inside.code, 0);
    QVERIFY2(inside.error.contains("pair.wend: the surface passes through itself in 1 place ("),
             qPrintable(inside.error));
    QCOMPARE(part("selfCrossings")["places"].toInt(), 1);
    QVERIFY(part("selfCrossings")["pairs"].toInt() > 0);
    const QJsonArray at = part("selfCrossings")["first"].toArray();
    for (int k = 0; k < 3; ++k) QVERIFY(at[k].toDouble() > 0 && at[k].toDouble() < 3);
    QCOMPARE(part("blownUp")["cells"].toInt(), 0);

    moved("{'kind': 'curve', 'interpolation': 'polyline', 'points': [[9, 1, 1], [15, 1, 1]], 'scale': 3}");
    QCOMPARE(part("selfCrossings")["places"].toInt(), 0);
    QCOMPARE(part("blownUp")["cells"].toInt(), cells);
    QCOMPARE(part("blownUp")["places"].toInt(), 1);
    QVERIFY(std::abs(part("blownUp")["worst"].toObject()["ratio"].toDouble() - 27) < 1e-6);
    QVERIFY(part("blownUp")["worst"].toObject()["cell"].toInt() >= cells);
}

void TestSolidCli::cancelledMeshing() {
    QProcess process;
    process.setWorkingDirectory(path());
    process.start(WEND_BINARY, {"mesh", "bar.off", "--max-volume", "1e-9", "-o", "never.vtu", "--progress"});
    QVERIFY(process.waitForStarted());
    QVERIFY(test::childCalled("wend-tetgen", process.processId()) > 0);
    QProcess::execute("kill", {"-INT", QString::number(process.processId())});
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 4);
    QVERIFY(process.readAllStandardError().trimmed().endsWith("cancelled; nothing was written"));
    QVERIFY(!QFileInfo::exists(path() + "/never.vtu"));
}

QTEST_GUILESS_MAIN(TestSolidCli)
#include "test_solid_cli.moc"
