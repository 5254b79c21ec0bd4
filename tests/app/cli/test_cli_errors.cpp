// Errors on the command line: each gives one line and the right exit code, and touches no file.

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <QtTest>

#include "core/base/simd_target.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;
namespace fs = std::filesystem;

namespace {

const std::string kDisc = "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 300}";
const std::string kStrip = "'domain': {'mesh': 'strip.obj'}";

}  // namespace

class TestCliErrors : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void usage_data();
    void usage();
    void simdTargets();
    void nothingAskedFor();
    void overwriting_data();
    void overwriting();
    void badInput_data();
    void badInput();
    void outputsStayWhole_data();
    void outputsStayWhole();
    void fullStandardOutput_data();
    void fullStandardOutput();
    void fullDisk_data();
    void fullDisk();
    void foldedOver();
    void interrupted();
    void interruptedWhileWriting();
    void standardInputIsNotReplaced();
    void emptyTemporaryFolderIsNone();
    void killed();

  private:
    QString path() const { return m_folder.path(); }
    QStringList listing() const {
        return QDir(path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    CliResult runLimited(const QStringList& arguments, qint64 most) const;
    void putMeshes();
    void putPictures();

    QTemporaryDir m_folder;
};

void TestCliErrors::putMeshes() {
    const std::string base = path().toStdString();
    writeMesh<2>(base + "/strip.obj", stripMesh(10, 2));
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='80' height='60' "
        "xmlns:xlink='http://www.w3.org/1999/xlink'>";
    put(path(), "cycle.svg",
        svg +
            "<g id='a'><use xlink:href='#b'/></g><g id='b'><use xlink:href='#a'/></g><rect width='30' "
            "height='20'/></svg>");
    put(path(), "damaged.svg", svg + "<g><rect width='30' height='20'/>");
    put(path(), "tetrahedron.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");  // a tetrahedron
    put(path(), "nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
    put(path(), "flat.obj", points + "v 2 0 0\nf 1 2 3\nf 1 2 5\n");
    put(path(), "overlapping.obj", points + "f 1 2 3\nf 2 4 3\nf 4 3 1\n");
    put(path(), "twice.obj", points + "f 1 2 3\nf 2 3 1\n");
    put(path(), "index.obj", points + "f 1 2 3\nf 2 4 9\n");
    put(path(), "empty.obj", "");
    put(path(), "truncated.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n");
    put(path(), "other.msh", "solid nothing\n");
}

void TestCliErrors::putPictures() {
    const std::string base = path().toStdString();
    writeImage(base + "/disc.png", discPicture(200, 80));
    writeImage(base + "/clear.png", discPicture(64, 0));
    const std::string bytes = readTextFile(base + "/disc.png");
    put(path(), "cut.png", bytes.substr(0, bytes.size() / 2));
    put(path(), "empty.png", "");
    put(path(), "noise.png", "this is no picture");
}

void TestCliErrors::initTestCase() {
    putMeshes();
    putPictures();
    putProject(path(), "disc.wend", kDisc);
    putProject(path(), "strip.wend", kStrip + ", 'handles': [{'at': {'vertices': [0]}}]");
}

void TestCliErrors::usage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("message");
    QTest::newRow("command") << QStringList{"jump"} << "there is no command or file jump";
    QTest::newRow("option") << QStringList{"--jump"} << "--jump";
    QTest::newRow("no project") << QStringList{"run"} << "no project is named";
    QTest::newRow("two projects") << QStringList{"run", "a.wend", "b.wend"} << "there is also b.wend";
    QTest::newRow("unknown") << QStringList{"run", "disc.wend", "--speed", "3"} << "has no option --speed";
    QTest::newRow("foreign") << QStringList{"run", "disc.wend", "--vertices", "3"}
                             << "has no option --vertices";
    QTest::newRow("no value") << QStringList{"run", "disc.wend", "--image"} << "--image needs a value";
    QTest::newRow("empty value") << QStringList{"run", "disc.wend", "--image="} << "--image: names no file";
    QTest::newRow("twice") << QStringList{"run", "d", "--at", "1", "--at", "2"} << "--at is given twice";
    QTest::newRow("number") << QStringList{"run", "d", "--tolerance", "x"}
                            << "--tolerance: \"x\" is not a number";
    QTest::newRow("comma") << QStringList{"run", "d", "--at", "0,5"} << "is not a number";
    QTest::newRow("range") << QStringList{"run", "d", "--tolerance=2"}
                           << "--tolerance: 2 is out of range: it must be in [1e-12, 0.1]";
    QTest::newRow("whole") << QStringList{"run", "d", "--steps", "2.5"} << "not a whole number";
    QTest::newRow("negative") << QStringList{"run", "d", "--at", "-1"} << "--at: -1 is out of range";
    QTest::newRow("choice") << QStringList{"run", "d", "--method", "euler"} << "known are dopri5";
    QTest::newRow("flag") << QStringList{"run", "d", "--quiet=1"} << "--quiet takes no value";
    QTest::newRow("phi") << QStringList{"run", "disc.wend", "--phi", "3"} << "]0, 2.677945045]";
    QTest::newRow("phi word") << QStringList{"run", "disc.wend", "--phi", "soft"}
                              << "equia, metr, akvf, conf";
    QTest::newRow("two dashes") << QStringList{"run", "disc.wend", "--report", "-", "--velocity", "-"}
                                << "only one output";
    QTest::newRow("frames") << QStringList{"run", "disc.wend", "--frames", "-"} << "--frames";
    QTest::newRow("mesh output") << QStringList{"mesh", "disc.png"} << "no output is named";
    QTest::newRow("mesh sizes") << QStringList{"mesh",   "disc.png", "-o",         "a.obj",
                                               "--edge", "3",        "--vertices", "9"}
                                << "cannot both";
    const auto meshRow = [](const char* name, const char* input, const QStringList& more, const char* what) {
        QTest::newRow(name) << QStringList(QStringList{"mesh", input, "-o", "a.vtu"} + more) << what;
    };
    meshRow("solid's option", "disc.png", {"--max-volume", "3"}, "--max-volume is for closed surfaces");
    meshRow("picture's option", "tetrahedron.obj", {"--edge", "5"}, "--edge is for pictures");
    meshRow("cut-out's option", "disc.png", {"--outline", "frame", "--margin", "5"}, "--margin is for");
    meshRow("outline of a solid", "tetrahedron.obj", {"--outline", "alpha"}, "--outline is for pictures");
    meshRow("mesh of a mesh", "strip.wend", {"--vertices", "50"}, "--vertices is for");
    QTest::newRow("steps") << QStringList{"run", "disc.wend", "--method", "rk4"} << "--steps N";
    QTest::newRow("devices") << QStringList{"devices", "all"} << "takes no file";
}

void TestCliErrors::usage() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, message);
    const CliResult result = runCli(path(), arguments);
    QCOMPARE(result.code, 2);
    QVERIFY2(result.error.startsWith("wend: ") && result.error.count('\n') == 1, qPrintable(result.error));
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
    QVERIFY(result.out.isEmpty());
}

void TestCliErrors::overwriting_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* arguments, const char* message) {
        QTest::newRow(name) << QString(arguments).split(' ') << message;
    };
    row("picture", "run own.wend --image disc.png", "disc.png: would replace disc.png, which is read here");
    row("another spelling", "run own.wend --image ./x.d/../disc.png", "would replace disc.png");
    row("link", "run own.wend --image x.link.png", "would replace disc.png");
    row("hard link", "run own.wend --image x.hard.png", "would replace disc.png");
    row("linked folder", "run own.wend --report x.way/own.wend", "would replace own.wend");
    row("project", "run own.wend --report own.wend", "would replace own.wend");
    row("mesh", "run cells.wend --mesh strip.obj", "would replace strip.obj");
    row("texture", "run cells.wend --image disc.png", "would replace disc.png");
    row("cells", "run cells.wend --report cells.json", "would replace cells.json");
    row("a frame", "run own.wend --frames x_##.png --count 12", "x_10.png: would replace disc.png");
    row("the other of TetGen's input", "run pair.wend --report pair.ele", "would replace pair.ele");
    row("mesh of itself", "mesh tetrahedron.obj -o x.d/../tetrahedron.obj", "would replace tetrahedron.obj");
    row("sizes", "mesh tetrahedron.obj --sizes sizes.obj -o sizes.obj", "which is read here");
    row("materials of a surface", "run look.wend --report wood.mtl", "would replace wood.mtl");
    row("a material's picture", "run look.wend --report grain.png", "would replace grain.png");
    row("problems", "info flat.obj --problems ./flat.obj", "would replace flat.obj");
    row("one place twice", "run strip.wend --mesh out.vtu --velocity out.vtu",
        "out.vtu: would replace another output, out.vtu");
    row("one place by two names", "run strip.wend --mesh out.vtu --velocity ./x.d/../out.vtu",
        "would replace another output");
    row("one place by one option", "run strip.wend --mesh out.vtu --mesh ./out.vtu",
        "out.vtu: would replace another output, out.vtu");
    row("one sequence twice", "run strip.wend --frames out_##.obj --frames x.d/../out_0#.obj --count 5",
        "would replace frames of another output, out_##.obj");
    row("the other of TetGen's files", "run strip.wend --mesh out.node --report out.ele",
        "would replace another output");
    row("a frame's place", "run strip.wend --frames out.##.obj --mesh out.07.obj",
        "out.07.obj: would be replaced by frame 7");
}

/// A run that is asked for nothing says so, in one line, and is no failure.
// WEND_SIMD accepts any target that the processor has; any other value ends the program with one line and no
// work.
void TestCliErrors::simdTargets() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    const auto run = [&](const QString& name) {
        environment.insert("WEND_SIMD", name);
        return runCli(path(), {"info", "strip.obj"}, environment);
    };
    for (const SimdTarget target : supportedSimdTargets()) {
        const CliResult result = run(QString::fromStdString(std::string(nameOf(target))));
        QCOMPARE(result.code, 0);
        QCOMPARE(result.error, QString());
    }
    QCOMPARE(run({}).code, 0);
    const CliResult unknown = run("AVX2");
    QCOMPARE(unknown.code, 2);
    QCOMPARE(unknown.out, QString());
    QCOMPARE(unknown.error.count('\n'), 1);
    QVERIFY(unknown.error.contains(
        "WEND_SIMD: 'AVX2' is not an instruction set (sse2, ssse3, sse4, avx2, avx512)"));
    if (supportedSimdTargets().back() == SimdTarget::Avx512) return;
    const CliResult lacking = run("avx512");
    QCOMPARE(lacking.code, 2);
    QCOMPARE(lacking.error.count('\n'), 1);
    QVERIFY(lacking.error.contains("WEND_SIMD: this processor has no avx512 (it has sse2"));
}

void TestCliErrors::nothingAskedFor() {
    const QStringList before = listing();
    const CliResult result = runCli(path(), {"run", "strip.wend"});
    QCOMPARE(result.code, 0);
    QCOMPARE(result.error, QString("wend: strip.wend: no output was asked for; nothing will be written\n"));
    QCOMPARE(result.out, QString());
    QCOMPARE(listing(), before);
}

/// No input is replaced by an output, nor one output by another, under whatever path they are given.
void TestCliErrors::overwriting() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, message);
    QDir(path()).mkdir("x.d");
    const fs::path base = path().toStdString();
    std::error_code there;
    fs::create_symlink("disc.png", base / "x.link.png", there);
    fs::create_hard_link(base / "disc.png", base / "x.hard.png", there);
    fs::create_symlink("disc.png", base / "x_10.png", there);
    fs::create_directory_symlink(".", base / "x.way", there);
    put(path(), "cells.json", "{}");
    put(path(), "look.obj",
        "mtllib wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    put(path(), "wood.mtl", "newmtl wood\nmap_Kd grain.png\n");
    put(path(), "grain.png", "a picture");
    putProject(path(), "look.wend", "'domain': {'mesh': 'look.obj'}");
    put(path(), "sizes.obj", "1 1 1 1");
    putProject(path(), "own.wend", kDisc);
    putProject(path(), "cells.wend",
               "'domain': {'mesh': 'strip.obj', 'image': 'disc.png'}, 'material': {'cells': 'cells.json'}");
    putProject(path(), "pair.wend", "'domain': {'mesh': 'pair.node'}");
    const QStringList before = listing();
    const CliResult result = runCli(path(), arguments);
    QVERIFY2(result.code == 2, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(result.error.startsWith("wend: ") && result.error.count('\n') == 1, qPrintable(result.error));
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
    QCOMPARE(listing(), before);
}

void TestCliErrors::badInput_data() {
    QTest::addColumn<QString>("project");  // what stands in p.wend; empty: the arguments name something else
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& project, const char* message,
                        QStringList more = {}) {
        const std::string text = json("{'format': 'wend', 'version': 1, " + project + "}");
        QTest::newRow(name) << QString::fromStdString(text) << (QStringList{"run", "p.wend"} + more)
                            << message;
    };
    const auto meshRow = [&](const char* name, const std::string& file, const char* message) {
        row(name, "'domain': {'mesh': '" + file + "'}", message);
    };
    const auto pictureRow = [&](const char* name, const std::string& file, const char* message) {
        row(name, "'domain': {'image': '" + file + "', 'outline': {'from': 'alpha'}}", message);
    };
    QTest::newRow("no project") << "" << QStringList{"run", "none.wend"} << "none.wend: does not exist";
    QTest::newRow("folder") << "" << QStringList{"run", "."} << ".: is a folder";
    QTest::newRow("empty") << " " << QStringList{"run", "p.wend"} << "p.wend: is empty";
    QTest::newRow("broken") << "{\n \"format\": \"wend\",\n}" << QStringList{"run", "p.wend"}
                            << "p.wend: is not valid JSON: line 3";
    QTest::newRow("number too large")
        << "{\n \"format\": \"wend\", \"x1e999\": 1,\n \"version\": 1e999}" << QStringList{"run", "p.wend"}
        << "p.wend: is not valid JSON: line 3, column 13: number overflow";
    row("cut beside its part",
        "'domain': {'parts': [{'name': 'a', 'cut': {'from': 'b', 'polygons': [[[900, 900], [990, 900], [990, "
        "990]]]}}, {'name': 'b', 'image': 'disc.png'}]}",
        "p.wend: domain.parts[0]: the cut is outside of");
    row("cycle of a drawing", "'domain': {'image': 'cycle.svg', 'outline': {'from': 'frame'}}",
        "cycle.svg: uses its \"b\" within itself", {"--image", "out.svg"});
    row("damaged drawing", "'domain': {'image': 'damaged.svg', 'outline': {'from': 'frame'}}",
        "damaged.svg: is damaged (not valid XML)");
    row("unknown kind", kDisc + ", 'handles': [{'at': {'points': [[1, 2]]}, 'motion': [{'kind': 'jump'}]}]",
        "p.wend: handles[0].motion[0].kind: unknown value");
    row("no drawing", kDisc, "no.svg: the project's picture is no SVG drawing", {"--image", "no.svg"});
    row("size of pixels", kDisc, "disc.png: is no SVG drawing: --size is for these",
        {"--image", "no.png", "--size", "900"});
    row("phi", kDisc + ", 'material': {'phi': 3}",
        "p.wend: material.phi: phi = 3 is outside ]0, 2.677945045]");
    row("B", kStrip + ", 'material': {'cells': {'B': [[1, 2, 2, 1]]}}",
        "p.wend: material.cells.B[0]: B is not positive definite");
    row("cell count", kStrip + ", 'material': {'cells': {'phi': [1, 1]}}",
        "p.wend: material.cells.phi: has 2 entries, but the mesh has 40 cells");
    row("cells file", kStrip + ", 'material': {'cells': 'none.json'}", "none.json: does not exist");
    row("outside", kDisc + ", 'handles': [{'name': 'far', 'at': {'points': [[-50, 10]]}}]", "far");
    row("contradiction",
        kStrip +
            ", 'handles': [{'name': 'still', 'at': {'points': [[5, 1]]}}, {'name': 'moving', 'at': "
            "{'points': [[5, 1]]},"
            "'motion': [{'kind': 'translate', 'by': [1, 0], 'time': [0, 1]}]}]",
        "moving");
    // by a ten-thousandth of the distance: more than rounding, less than is visible
    row("small contradiction",
        kStrip +
            ", 'handles': [{'name': 'one', 'at': {'points': [[5, 1]]}, 'motion': [{'kind': 'translate', "
            "'by': "
            "[1, 0], 'time': [0, 1]}]}, {'name': 'other', 'at': {'points': [[5, 1]]}, 'motion': [{'kind': "
            "'translate', 'by': [1.0001, 0], 'time': [0, 1]}]}]",
        "in different ways");
    row("vertex", kStrip + ", 'handles': [{'name': 'tip', 'at': {'vertices': [9999]}}]", "9999");
    row("crossing",
        "'domain': {'image': 'disc.png', 'outline': {'polygons': [[[0, 0], [90, 90], [90, 0], [0, 90]]]}}",
        "domain.outline.polygons: the outline crosses or overlaps itself");
    meshRow("no mesh", "none.obj", "none.obj: does not exist");
    meshRow("empty mesh", "empty.obj", "empty.obj: ");
    meshRow("NaN", "nan.obj", "nan.obj: ");
    meshRow("no area", "flat.obj", "flat.obj: cell 1 has no area");
    meshRow("overlapping", "overlapping.obj", "overlapping.obj: cells 0 and 2 overlap");
    meshRow("duplicate", "twice.obj", "twice.obj: cell 1 is a duplicate of cell 0");
    meshRow("index", "index.obj", "index.obj: ");
    meshRow("truncated mesh", "truncated.mesh", "truncated.mesh: ");
    meshRow("other mesh", "other.msh", "other.msh: ");
    meshRow("mesh format", "disc.png", "disc.png: ");
    pictureRow("no picture", "none.png", "none.png: ");
    pictureRow("empty picture", "empty.png", "empty.png: ");
    pictureRow("truncated picture", "cut.png", "cut.png: ");
    pictureRow("no picture at all", "noise.png", "noise.png: ");
    pictureRow("transparent", "clear.png", "clear.png: ");
    row("picture of a mesh", kStrip, "there is no picture to warp", {"--image", "out.png"});
    row("image format", kDisc, "out.xyz: is in no picture format", {"--image", "out.xyz"});
    row("mesh format out", kDisc, "out.xyz: is in no known mesh format", {"--mesh", "out.xyz"});
    row("velocity format", kDisc, "a velocity field is written as", {"--velocity", "v.txt"});
    row("ST map format", kDisc, "floating-point pixels", {"--stmap", "st.png"});
    row("frames without #", kDisc, "needs ####", {"--frames", "f.png"});
    row("output folder", kDisc, "no/out.png: the folder no does not exist", {"--image", "no/out.png"});
    row("output is a folder", kDisc, "out.d: is a folder", {"--report", "out.d"});
    QTest::newRow("mesh of a flat mesh")
        << "" << QStringList{"mesh", "strip.obj", "-o", "out.mesh"} << "strip.obj: ";
    QTest::newRow("mesh of nothing") << "" << QStringList{"mesh", "none.png", "-o", "out.obj"}
                                     << "none.png: ";
    QTest::newRow("info of nothing") << "" << QStringList{"info", "none.png"} << "none.png: ";
    QTest::newRow("info of noise") << "" << QStringList{"info", "noise.png"} << "noise.png: ";
}

void TestCliErrors::badInput() {
    QFETCH(QString, project);
    QFETCH(QStringList, arguments);
    QFETCH(QString, message);
    QDir(path()).mkdir("out.d");
    if (!project.isEmpty()) put(path(), "p.wend", project.toStdString());
    const QStringList before = listing();
    const CliResult result =
        runCli(path(), arguments + (arguments[0] == "info" ? QStringList{} : QStringList{"--quiet"}));
    QVERIFY(!result.crashed);
    QVERIFY2(result.code == 3, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(result.error.startsWith("wend: ") && result.error.count('\n') == 1, qPrintable(result.error));
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
    QCOMPARE(listing(), before);
}

void TestCliErrors::outputsStayWhole_data() {
    QTest::addColumn<QStringList>("arguments");
    const QStringList common{"run", "disc.wend", "--image", "kept.png"};
    QTest::newRow("another folder is missing") << common + QStringList{"--report", "no/r.json"};
    QTest::newRow("another format is unknown") << common + QStringList{"--mesh", "m.xyz"};
    QTest::newRow("the input is broken") << QStringList{"run", "none.wend", "--image", "kept.png"};
    // found only on writing, after the picture is done: the format cannot hold the requested data
    QTest::newRow("a later output fails") << common + QStringList{"--report", "/dev/full"};
}

void TestCliErrors::outputsStayWhole() {
    QFETCH(QStringList, arguments);
    put(path(), "kept.png", "old");
    const QStringList before = listing();
    QCOMPARE(runCli(path(), arguments).code, 3);
    QCOMPARE(listing(), before);
    QCOMPARE(readTextFile((path() + "/kept.png").toStdString()), std::string("old"));
}

void TestCliErrors::fullStandardOutput_data() {
    QTest::addColumn<QString>("arguments");
    for (const char* arguments : {"--help", "reference", "devices", "info disc.png"})
        QTest::newRow(arguments) << QString(arguments);
}

void TestCliErrors::fullStandardOutput() {
    QFETCH(QString, arguments);
    const QString command = QString("exec \"%1\" %2 > /dev/full").arg(WEND_BINARY, arguments);
    const CliResult result =
        runCli(path(), {"-c", command}, QProcessEnvironment::systemEnvironment(), "/bin/bash");
    QVERIFY2(result.code == 3, qPrintable(result.error));
    QVERIFY2(result.error.contains("standard output cannot be written"), qPrintable(result.error));
}

void TestCliErrors::fullDisk_data() {
    QTest::addColumn<QString>("output");
    for (const char* name : {"png", "jpg", "tif", "exr", "webp", "bmp", "tga", "jp2", "hdr", "ppm"})
        QTest::newRow(name) << QString("--image kept.%1").arg(name);
    for (const char* name : {"obj", "ply", "stl", "off", "node", "vtu", "vtk", "msh", "mesh", "inp"})
        QTest::newRow(name) << QString("--mesh kept.%1").arg(name);
    QTest::newRow("velocity") << "--velocity kept.csv";
    QTest::newRow("material") << "--phi-picture kept.png";
    QTest::newRow("ST map") << "--stmap kept.exr";
    QTest::newRow("ST map as TIFF") << "--stmap kept.tif";
    QTest::newRow("frames") << "--frames kept_#.png --count 2";
    QTest::newRow("fitting frames") << "--canvas fit --frames kept_#.png --count 2";
    QTest::newRow("frames of meshes") << "--frames kept_#.obj --count 2";
}

/// A limit on the size of files simulates a full disk: it strikes in the middle of a file, some pages before
/// its end, or one byte before it.
void TestCliErrors::fullDisk() {
    QFETCH(QString, output);
    const QString kept = output.contains("#") ? QString("kept_1.") + output.section('.', 1).section(' ', 0, 0)
                                              : output.section(' ', 1, 1);
    const QStringList arguments = QStringList{"run", "still.wend"} + output.split(' ');
    const bool ofMesh = output.contains("--mesh") || output.contains(".obj");
    putProject(path(), "still.wend", ofMesh ? kStrip : kDisc);
    for (const QString& name : listing().filter("kept")) QFile::remove(path() + "/" + name);
    QCOMPARE(runCli(path(), arguments).code, 0);
    qint64 size = 0;  // of the largest file
    for (const QString& name : listing().filter("kept")) {
        size = std::max(size, QFileInfo(path() + "/" + name).size());
        QFile::remove(path() + "/" + name);
    }
    put(path(), qPrintable(kept), "old");
    const QStringList before = listing();
    for (const qint64 missing : {qint64(1), qint64(4096), qint64(4 * 4096), size / 2}) {
        if (missing >= size) continue;
        const CliResult result = runLimited(arguments, size - missing);
        QVERIFY2(result.code == 3, qPrintable(QString::number(missing) + output + result.error));
        QVERIFY2(result.error.startsWith("wend: ") && result.error.count('\n') == 1,
                 qPrintable(result.error));
        QVERIFY2(result.error.contains("cannot be written: "), qPrintable(result.error));
        QVERIFY2(!result.error.contains(".wend-"), qPrintable(result.error));
        QCOMPARE(listing(), before);
        QCOMPARE(readTextFile((path() + "/" + kept).toStdString()), std::string("old"));
    }
    QCOMPARE(runLimited(arguments, size).code, 0);
}

/// Runs the program with a limit on the size of its files.
CliResult TestCliErrors::runLimited(const QStringList& arguments, qint64 most) const {
    QProcess process;
    process.setWorkingDirectory(path());
    process.setChildProcessModifier([most] {
        const struct rlimit limit { static_cast<rlim_t>(most), static_cast<rlim_t>(most) };
        setrlimit(RLIMIT_FSIZE, &limit);
    });
    process.start(WEND_BINARY, arguments);
    process.waitForFinished(120000);
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError()), process.exitStatus() != QProcess::NormalExit};
}

/// The files that a killed program has left are removed by the next one that writes there. SIGTERM leaves
/// nothing in the first place.
void TestCliErrors::killed() {
    putProject(path(), "long.wend",
               "'domain': {'image': 'disc.png', 'vertices': 20000}, 'integration': {'tolerance': 1e-10},"
               "'handles': [{'at': {'points': [[20, 20]]}}, {'at': {'points': [[150, 150]]}, 'motion': ["
               "{'kind': 'rotate', 'centre': [100, 100], 'angle': 3}]}]");
    const QStringList before = listing();
    for (const bool orderly : {true, false}) {
        QProcess process;
        process.setWorkingDirectory(path());
        process.setReadChannel(QProcess::StandardError);
        process.start(WEND_BINARY,
                      {"run", "long.wend", "--frames", "long_####.png", "--count", "9999", "--progress"});
        const auto parts = [&] {
            return QDir(path()).entryList({".wend-*"}, QDir::AllEntries | QDir::Hidden);
        };
        while (parts().isEmpty() && process.waitForReadyRead(60000)) process.readAllStandardError();
        QVERIFY(!parts().isEmpty());
        orderly ? process.terminate() : process.kill();
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(parts().isEmpty(), orderly);
    }
    QCOMPARE(runCli(path(), {"run", "disc.wend", "--report", "after.json"}).code, 0);
    QFile::remove(path() + "/after.json");
    QCOMPARE(listing(), before);
}

/// A handle that is pulled through a fixed one cannot arrive: the exit code is 4, and only the report is
/// written, with the last good time.
void TestCliErrors::foldedOver() {
    putProject(path(), "fold.wend",
               kStrip +
                   ", 'handles': [{'name': 'wall', 'at': {'points': [[10, 0], [10, 1], [10, 2]]}},"
                   "{'name': 'ram', 'at': {'points': [[0, 0], [0, 1], [0, 2]]},"
                   "'motion': [{'kind': 'translate', 'by': [12, 0], 'time': [0, 1]}]}]");
    put(path(), "kept.obj", "old");
    const CliResult result = runCli(path(), {"run", "fold.wend", "--mesh", "kept.obj", "--report",
                                             "fold.json", "--frames", "fold_#.obj", "--count", "5"});
    QCOMPARE(result.code, 4);
    QVERIFY(listing().filter("fold_").isEmpty());  // frames that had been passed
    QVERIFY2(result.error.startsWith("wend: fold.wend: ") && result.error.count('\n') == 1,
             qPrintable(result.error));
    QVERIFY2(result.error.contains("cell") && result.error.contains("0.8"), qPrintable(result.error));
    QCOMPARE(readTextFile((path() + "/kept.obj").toStdString()), std::string("old"));
    const auto report = QJsonDocument::fromJson(
        QByteArray::fromStdString(readTextFile((path() + "/fold.json").toStdString())));
    QVERIFY(report["time"].toDouble() > 0.7 && report["time"].toDouble() < 10.0 / 12);
    QCOMPARE(report["flips"].toInt(), 0);

    QCOMPARE(runCli(path(), {"run", "fold.wend", "--mesh", "kept.obj", "--partial"}).code, 4);
    QCOMPARE(readMesh<2>((path() + "/kept.obj").toStdString()).points.cols(), Eigen::Index(33));
}

void TestCliErrors::interrupted() {
    putProject(path(), "long.wend",
               "'domain': {'image': 'disc.png', 'vertices': 20000}, 'integration': {'tolerance': 1e-10},"
               "'handles': [{'at': {'points': [[20, 20]]}}, {'at': {'points': [[150, 150]]}, 'motion': ["
               "{'kind': 'rotate', 'centre': [100, 100], 'angle': 3}]}]");
    const QStringList before = listing();
    QProcess process;
    process.setWorkingDirectory(path());
    process.setReadChannel(QProcess::StandardError);
    process.start(WEND_BINARY,
                  {"run", "long.wend", "--image", "long.png", "--report", "long.json", "--progress"});
    QByteArray said;
    while (!said.contains("deforming") && process.waitForReadyRead(60000))
        said += process.readAllStandardError();
    QVERIFY(said.contains("deforming"));
    QProcess::execute("kill", {"-INT", QString::number(process.processId())});
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 4);
    QVERIFY(process.readAllStandardError().trimmed().endsWith("cancelled; nothing was written"));
    QCOMPARE(listing(), before);
}

/// The program is interrupted while it writes to a full pipe that has no reader.
void TestCliErrors::interruptedWhileWriting() {
    const QByteArray pipe = QString(path() + "/pipe.ppm").toLocal8Bit();
    QCOMPARE(mkfifo(pipe.constData(), 0600), 0);
    const int end = open(pipe.constData(), O_RDWR | O_NONBLOCK);
    QVERIFY(end >= 0);
    QProcess process;
    process.setWorkingDirectory(path());
    process.start(WEND_BINARY, {"run", "disc.wend", "--image", "pipe.ppm", "--quiet"});  // 120,000 bytes
    int held = 0;
    QVERIFY(QTest::qWaitFor([&] { return ioctl(end, FIONREAD, &held) == 0 && held > 60000; }, 60000));
    QProcess::execute("kill", {"-TERM", QString::number(process.processId())});
    QVERIFY(process.waitForFinished(20000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 4);
    close(end);
    QFile::remove(path() + "/pipe.ppm");
}

/// Standard input is recognized as the same file although its name is unknown.
void TestCliErrors::standardInputIsNotReplaced() {
    const std::string file = path().toStdString() + "/disc.wend", before = readTextFile(file);
    QProcess process;
    process.setWorkingDirectory(path());
    process.setStandardInputFile(path() + "/disc.wend");
    process.start(WEND_BINARY, {"run", "-", "--report", "disc.wend", "--quiet"});
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 2);
    QVERIFY(process.readAllStandardError().contains("would replace"));
    QCOMPARE(readTextFile(file), before);
}

void TestCliErrors::emptyTemporaryFolderIsNone() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("TMPDIR", "");
    const CliResult result = runCli(path(), {"run", "disc.wend", "--image", "-", "--quiet"}, environment);
    QVERIFY2(result.code == 0, qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestCliErrors)
#include "test_cli_errors.moc"
