// The command line when all is well: every output of every kind of domain, as other programs will read it.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/project/options/options.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/mesh_files.h"
#include "tests/support/pictures.h"
#include "warp/convert.h"

using namespace wend;

class TestCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void helps();
    void referencePageIsCurrent();
    void translatedStrip();
    void velocityTable();
    void velocityOnTheMesh();
    void reportKeys();
    void solvers();
    void remembersAndSettles();
    void standardOutput();
    void repeatedOutputs();
    void repeatedSequences();
    void stopsEarlier();
    void frames();
    void framesFit();
    void partOfThePicture();
    void meshFrames();
    void picture();
    void pictureFits();
    void fittedPictureHasItsLastRowAndColumn();
    void texturedMesh();
    void twistedBar();
    void volumeFormats_data();
    void volumeFormats();
    void germanLocale();
    void sameBits();
    void warnsOfUnknownKeys();
    void qualityAndGradients();
    void endOfTheLastMotion();
    void endBeforeTheMotions();
    void strict();
    void roundedNumbersAreReported_data();
    void roundedNumbersAreReported();
    void meshCommand();
    void surfaceCommand();
    void infoOfPicture();
    void infoOfBadMesh();
    void infoOfProject();
    void convert();
    void objStaysObj();
    void devices();
    void linksAndPermissions();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const char* name) const { return (path() + "/" + name).toStdString(); }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    QJsonDocument jsonFile(const char* name) const {
        return QJsonDocument::fromJson(QByteArray::fromStdString(readTextFile(file(name))));
    }
    void succeed(const QStringList& arguments) const {
        const CliResult result = run(arguments);
        QVERIFY2(result.code == 0 && result.error.isEmpty(),
                 qPrintable(QString::number(result.code) + result.error));
    }

    QTemporaryDir m_folder;
};

void TestCli::initTestCase() {
    writeMesh<2>(file("strip.obj"), stripMesh(10, 2));
    writeMesh<3>(file("bar.mesh"), barMesh(6));
    writeImage(file("disc.png"), discPicture(200, 80));
    putProject(path(), "strip.wend",
               "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1], "
               "'max': [11, 3]}}},"
               "'motion': [{'kind': 'translate', 'by': [3, 0.5], 'time': [0, 1]}]}]");
    putProject(
        path(), "bend.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'points': [[0, 0], [0, 1], [0, 2]]}},"
        "{'at': {'points': [[10, 0], [10, 1], [10, 2]]}, 'motion': [{'kind': 'rotate', 'centre': [5, 1],"
        "'angle': 1, 'time': [0, 1]}]}]");
    putProject(path(), "bar.wend",
               "'domain': {'mesh': 'bar.mesh'}, 'handles': [{'at': {'region': {'box': {'min': [-1, -1, "
               "-0.5], 'max': [3, 3, 0.5]}}}},"
               "{'at': {'region': {'box': {'min': [-1, -1, 5.5], 'max': [3, 3, 6.5]}}}, 'motion': [{'kind': "
               "'rotate',"
               "'centre': [1, 1, 6], 'axis': [0, 0, 1], 'angle': 1.5707963267948966, 'time': [0, 1]}]}]");
    putProject(
        path(), "disc.wend",
        "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 400}, 'handles': ["
        "{'at': {'points': [[60, 100]]}}, {'at': {'points': [[140, 100]]}, 'motion': [{'kind': 'translate',"
        "'by': [20, 10], 'time': [0, 1]}]}]");
}

void TestCli::helps() {
    QVERIFY(run({"--help"}).out.contains("Exit codes"));
    QVERIFY(run({"--version"}).out.startsWith("wend "));
    for (const char* command : {"run", "mesh", "info", "convert", "devices", "bench"}) {
        const CliResult result = run({command, "--help"});
        QCOMPARE(result.code, 0);
        QVERIFY(result.out.startsWith(QString("Usage: wend ") + command));
    }
    QVERIFY(run({"run", "--help"}).out.contains("--tolerance X"));
    QVERIFY(run({"bench", "--help"}).out.contains("paper"));
    QCOMPARE(run({"bench", "warp", "--keep", path()}).code, 2);
    QCOMPARE(run({"bench", "paper", "--keep", "nowhere"}).code, 3);
    QCOMPARE(run({"bench", "nothing"}).code, 2);
}

/// docs/reference.md is the output of `wend reference`: regenerate it with that when the table of options
/// changes.
void TestCli::referencePageIsCurrent() {
    QCOMPARE(run({"reference"}).out,
             QString::fromStdString(readTextFile(WEND_SOURCE_DIR "/docs/reference.md")));
}

/// The shape follows a handle of all vertices exactly, up to rounding, and the order and number of vertices
/// are the input's.
void TestCli::translatedStrip() {
    succeed({"run", "strip.wend", "--mesh", "moved.obj"});
    const auto moved = sharedMeshFile(file("moved.obj"));
    const SimplicialMesh<2> rest = stripMesh(10, 2);
    QVERIFY(trianglesOf(*moved) == rest.cells);
    for (int i = 0; i < rest.vertexCount(); ++i)
        QVERIFY((pointsOf(*moved).col(i).head<2>() - rest.points.col(i) - Vec2(3, 0.5)).norm() < 1e-13);
}

void TestCli::velocityTable() {
    succeed({"run", "bend.wend", "--velocity", "v.csv", "--at", "0.5"});
    const QStringList lines =
        QString::fromStdString(readTextFile(file("v.csv"))).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines[0], QString("x,y,vx,vy"));
    QCOMPARE(lines.size(), 34);
    const QStringList fixed = lines[1].split(','), end = lines[11].split(',');  // vertices 0 and 10
    QCOMPARE(fixed[2].toDouble(), 0.0);
    // vertex 10 rotates about (5, 1) with unit angular velocity: v = (−(y − 1), x − 5)
    QVERIFY(std::abs(end[2].toDouble() + end[1].toDouble() - 1) < 1e-9);
    QVERIFY(std::abs(end[3].toDouble() - end[0].toDouble() + 5) < 1e-9);
    const double radius = std::hypot(5, 1), angle = std::atan2(-1, 5) + 0.5;
    QVERIFY(std::abs(end[0].toDouble() - 5 - radius * std::cos(angle)) < 1e-12);
    QVERIFY(std::abs(end[1].toDouble() - 1 - radius * std::sin(angle)) < 1e-12);
}

void TestCli::velocityOnTheMesh() {
    succeed({"run", "bar.wend", "--velocity", "v.vtu"});
    const auto mesh = sharedMeshFile(file("v.vtu"));
    QCOMPARE(tetrahedraOf(*mesh).size(), barMesh(6).cells.size());
    const auto velocity = std::ranges::find(fieldsOf(*mesh), std::string("velocity"), &MeshField::name);
    QVERIFY(velocity != fieldsOf(*mesh).end());
    QCOMPARE(velocity->values.size(), std::size_t(3 * pointsOf(*mesh).cols()));
}

void TestCli::solvers() {
    std::vector<Points3> poses;
    for (const char* solver : {"direct", "multigrid"}) {
        const std::string mesh = std::string(solver) + ".mesh";
        succeed({"run", "bar.wend", "--solver", solver, "--report", "r.json", "--mesh", mesh.c_str()});
        const QJsonObject report = jsonFile("r.json").object();
        QCOMPARE(report["solver"].toString(), QString(solver));
        QVERIFY(report["needs"].toDouble() > 0);
        poses.push_back(readMesh<3>(file(mesh.c_str())).points);
    }
    QVERIFY((poses[0] - poses[1]).cwiseAbs().maxCoeff() < 1e-2);
    const CliResult wrong = run({"run", "bar.wend", "--solver", "lu", "--mesh", "o.mesh"});
    QCOMPARE(wrong.code, 2);
    QVERIFY(wrong.error.contains("auto, direct, multigrid") || wrong.error.contains("--solver"));
    QCOMPARE(
        run({"run", "bar.wend", "--solver", "multigrid", "--backend", "opencl", "--mesh", "o.mesh"}).code, 2);
}

void TestCli::reportKeys() {
    succeed({"run", "bend.wend", "--report", "r.json"});
    const QJsonObject report = jsonFile("r.json").object();
    QStringList expected{"vertices",      "cells",      "dimension",   "time",           "backend",
                         "device",        "errors",     "flips",       "minDet",         "constraintError",
                         "steps",         "rejected",   "evaluations", "factorizations", "solverIterations",
                         "seconds",       "energy",     "restEnergy",  "restForce",      "errorEstimate",
                         "selfCrossings", "blownUp",    "needs",       "solver",         "reached",
                         "notices",       "cellQuality"};
    QStringList keys = report.keys();
    expected.sort();
    keys.sort();
    QCOMPARE(keys, expected);
    QCOMPARE(report["errors"].toObject().keys(), (QStringList{"angle", "metric", "volume"}));
    QCOMPARE(report["seconds"].toObject().keys(),
             (QStringList{"analyze", "assemble", "factor", "integrate", "solve", "total"}));
    QCOMPARE(report["vertices"].toInt(), 33);
    QCOMPARE(report["cells"].toInt(), 40);
    QCOMPARE(report["dimension"].toInt(), 2);
    QCOMPARE(report["time"].toDouble(), 1.0);
    QCOMPARE(report["flips"].toInt(), 0);
    QVERIFY(report["minDet"].toDouble() > 0.3);
    QVERIFY(report["constraintError"].toDouble() <= 1e-12);
    QVERIFY(report["energy"].toDouble() > 0);
    QVERIFY(report["steps"].toInt() > 0);
}

/// Memory and settling give the same result from the command line and from the project; both bring the shape
/// nearer to its rest.
void TestCli::remembersAndSettles() {
    const auto report = [&](const QStringList& options) {
        succeed(QStringList{"run", "bend.wend", "--report", "r.json", "--mesh", "m.obj"} + options);
        return jsonFile("r.json").object();
    };
    const double plain = report({})["restEnergy"].toDouble();
    const double remembered = report({"--memory", "10"})["restEnergy"].toDouble();
    QVERIFY(0 < remembered && remembered < plain);
    const QJsonObject settled = report({"--settle"});
    QCOMPARE(settled["time"].toDouble(), 2.0);
    QVERIFY(settled["restEnergy"].toDouble() < remembered);
    const double force = report({})["restForce"].toDouble();
    QVERIFY(settled["restForce"].toDouble() < 1e-9 * force);
    const QJsonObject elastic = report({"--memory", "elastic"});
    QVERIFY(elastic["restForce"].toDouble() < 1e-9 * force);
    QVERIFY(std::abs(elastic["restEnergy"].toDouble() / settled["restEnergy"].toDouble() - 1) < 1e-9);
    QVERIFY(elastic["notices"].toArray().isEmpty());
    const CliResult unknown = run({"run", "bend.wend", "--memory", "elastik", "--report", "-"});
    QCOMPARE(unknown.code, 2);
    QVERIFY(unknown.error.contains("\"elastik\" is neither a number nor elastic"));
    const CliResult large =
        run({"run", "bend.wend", "--memory", "elastic", "--solver", "multigrid", "--report", "-"});
    QCOMPARE(large.code, 3);
    QVERIFY(large.error.contains("needs the direct solver"));
    QVERIFY(settled["constraintError"].toDouble() < 1e-12);
    const std::string bend = readTextFile(file("bend.wend"));
    put(path(), "settled.wend", bend.substr(0, bend.rfind('}')) + ", \"settle\": [{\"time\": [1, 2]}]}");
    succeed({"run", "settled.wend", "--report", "r.json"});
    QCOMPARE(jsonFile("r.json").object()["restEnergy"], settled["restEnergy"]);
    QCOMPARE(run({"run", "bend.wend", "--memory", "-1", "--report", "-"}).code, 2);
}

void TestCli::standardOutput() {
    const CliResult report = run({"run", "bend.wend", "--report", "-"});
    QCOMPARE(QJsonDocument::fromJson(report.out.toUtf8())["vertices"].toInt(), 33);
    QVERIFY(run({"run", "bend.wend", "--velocity", "-"}).out.startsWith("x,y,vx,vy\n"));
    QProcess process;
    process.setWorkingDirectory(path());
    process.start(WEND_BINARY, {"run", "disc.wend", "--image", "-"});
    QVERIFY(process.waitForFinished(60000));
    QVERIFY(process.readAllStandardOutput().startsWith("\x89PNG"));
}

/// Every output may be named several times, and each file is as if it were the only one.
void TestCli::repeatedOutputs() {
    const auto bytes = [&](const char* name) { return readTextFile(file(name)); };
    succeed({"run", "bend.wend", "--mesh", "a.vtu", "--mesh", "a.msh", "--mesh=a.obj", "--velocity", "a.csv",
             "--velocity", "a-velocity.vtu", "--report", "a.json", "--report", "b.json", "--states",
             "a.states", "--states", "b.states"});
    for (const char* name : {"vtu", "msh", "obj"}) {
        const std::string alone = "alone." + std::string(name), together = "a." + std::string(name);
        succeed({"run", "bend.wend", "--mesh", QString::fromStdString(alone)});
        QVERIFY2(bytes(alone.c_str()) == bytes(together.c_str()), name);
    }
    QVERIFY(bytes("a.csv").starts_with("x,y,vx,vy\n"));
    QCOMPARE(fieldsOf(*sharedMeshFile(file("a-velocity.vtu"))).size(), std::size_t(1));
    QCOMPARE(bytes("a.json"), bytes("b.json"));
    QCOMPARE(bytes("a.states"), bytes("b.states"));
    succeed({"run", "bend.wend", "--from", "b.states", "--mesh", "again.obj"});
    QCOMPARE(bytes("again.obj"), bytes("a.obj"));

    succeed({"run", "disc.wend", "--image", "a.png", "--image", "a.tif", "--stmap", "a.exr", "--stmap",
             "b.tif", "--phi-picture", "phi.png", "--phi-picture", "phi.tif"});
    QCOMPARE(readImage(file("a.png")).data, readImage(file("a.tif")).data);
    QCOMPARE(readImage(file("a.exr")).data, readImage(file("b.tif")).data);
    QCOMPARE(readImage(file("phi.png")).data, readImage(file("phi.tif")).data);
    const CliResult report = run({"run", "bend.wend", "--report", "-", "--report", "c.json"});
    QCOMPARE(report.out.toStdString().substr(0, 20), bytes("c.json").substr(0, 20));
}

void TestCli::repeatedSequences() {
    succeed({"run", "disc.wend", "--frames", "p_##.png", "--frames", "film.webp", "--frames", "t_#.tif",
             "--frames", "m_#.vtu", "--frames", "m_#.obj", "--count", "3", "--fps", "10"});
    for (const char* k : {"0", "1", "2"}) {
        const std::string number(k);
        QCOMPARE(readImage(file(("p_0" + number + ".png").c_str())).data,
                 readImage(file(("t_" + number + ".tif").c_str())).data);
        QCOMPARE(trianglesOf(*sharedMeshFile(file(("m_" + number + ".vtu").c_str()))).size(),
                 trianglesOf(*sharedMeshFile(file(("m_" + number + ".obj").c_str()))).size());
    }
    QVERIFY(QFile::exists(path() + "/m.pvd"));
    QVERIFY(readTextFile(file("film.webp")).substr(0, 4) == "RIFF");
    succeed({"run", "bar.wend", "--frames", "s.glb", "--frames", "s_#.vtk", "--frames", "s_#.stl", "--count",
             "2", "--fps", "10"});
    for (const char* name : {"s.glb", "s_0.vtk", "s_1.vtk", "s_0.stl", "s_1.stl"})
        QVERIFY2(QFile::exists(path() + "/" + name), name);
}

void TestCli::stopsEarlier() {
    succeed({"run", "strip.wend", "--at", "0.5", "--mesh", "half.obj"});
    const auto halfway = sharedMeshFile(file("half.obj"));
    QVERIFY((pointsOf(*halfway).col(0) - Vec3(1.5, 0.25, 0)).norm() < 1e-13);
    succeed({"run", "strip.wend", "--at", "0", "--mesh", "rest.obj"});
    QCOMPARE(pointsOf(*sharedMeshFile(file("rest.obj"))), pointsOf(*sharedMeshFile(file("strip.obj"))));
}

void TestCli::frames() {
    QDir(path()).mkdir("frames");
    succeed({"run", "disc.wend", "--frames", "frames/f_###.png", "--count", "4", "--image", "last.png"});
    QCOMPARE(QDir(path() + "/frames").entryList(QDir::Files | QDir::Hidden),
             (QStringList{"f_000.png", "f_001.png", "f_002.png", "f_003.png"}));
    QCOMPARE(readImage(file("frames/f_003.png")).data, readImage(file("last.png")).data);
    QVERIFY(readImage(file("frames/f_001.png")).data != readImage(file("last.png")).data);
    // nothing has moved in the first frame, so it has the picture's pixels
    QCOMPARE(readImage(file("frames/f_000.png")).data, readImage(file("disc.png")).data);
}

/// All frames of the sequence have the same canvas.
void TestCli::framesFit() {
    const QStringList common{"run", "disc.wend", "--canvas", "fit"};
    succeed(common + QStringList{"--frames", "fit_#.png", "--count", "3", "--image", "fit.png"});
    const Image first = readImage(file("fit_0.png")), last = readImage(file("fit_2.png"));
    QCOMPARE(first.width, last.width);
    QCOMPARE(first.height, last.height);
    QVERIFY(first.width >= readImage(file("fit.png")).width);
    succeed({"run", "disc.wend", "--canvas", "fit", "--at", "0", "--image", "rest.png"});
    QVERIFY(first.width > readImage(file("rest.png")).width);
    QVERIFY(QDir(path()).entryList({".*"}, QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());
}

/// A crop of a still and of all frames has exactly the pixels that the whole picture has there.
void TestCli::partOfThePicture() {
    succeed({"run", "disc.wend", "--image", "whole.png"});
    succeed({"run", "disc.wend", "--canvas", "-7,60,70,30", "--image", "part.png", "--frames", "p_#.png",
             "--count", "2", "--report", "part.json"});
    const QJsonObject canvas = jsonFile("part.json").object()["canvas"].toObject();
    QCOMPARE(canvas, (QJsonObject{{"x", -7}, {"y", 60}, {"width", 70}, {"height", 30}}));
    const Image whole = readImage(file("whole.png")), part = readImage(file("part.png"));
    QCOMPARE(QPoint(part.width, part.height), QPoint(70, 30));
    const auto pixel = [](const Image& image, int x, int y) {
        const auto size = static_cast<std::ptrdiff_t>(image.rowBytes() / image.width);
        const auto at = image.data.begin() + (static_cast<std::ptrdiff_t>(y) * image.width + x) * size;
        return std::vector(at, at + size);
    };
    int seen = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 7; x < 70; ++x) {
            QVERIFY(pixel(part, x, y) == pixel(whole, x - 7, y + 60));
            seen += pixel(part, x, y) != pixel(part, 0, 0);
        }
    QVERIFY(seen > 100);
    QCOMPARE(readImage(file("p_1.png")).data, readImage(file("part.png")).data);
    QCOMPARE(readImage(file("p_0.png")).width, 70);
    for (const char* wrong :
         {"1,2,3", "0,0,0,9", "a,b,c,d", "1,1,5,5,", "1.5,0,9,9", "0,0,99999999,9", "crop"}) {
        const CliResult result = runCli(path(), {"run", "disc.wend", "--canvas", wrong, "--image", "no.png"});
        QCOMPARE(result.code, 2);
        QVERIFY2(result.error.contains("--canvas") && result.error.contains("X,Y,WIDTH,HEIGHT"),
                 qPrintable(result.error));
    }
    for (const char* wrong : {"pink", "#12345", "#1234567", "#12345g", "d9e4f2"}) {
        const CliResult result =
            runCli(path(), {"run", "disc.wend", "--outside", wrong, "--image", "no.png"});
        QCOMPARE(result.code, 2);
        QVERIFY2(result.error.contains("--outside") && result.error.contains("#d9822b"),
                 qPrintable(result.error));
    }
    QVERIFY(!QFile::exists(QString::fromStdString(file("no.png"))));
}

void TestCli::meshFrames() {
    succeed({"run", "strip.wend", "--frames", "m_#.vtu", "--count", "3"});
    for (int k = 0; k < 3; ++k) {
        const auto mesh = sharedMeshFile(file(qPrintable(QString("m_%1.vtu").arg(k))));
        QVERIFY((pointsOf(*mesh).col(0) - Vec3(1.5 * k, 0.25 * k, 0)).norm() < 1e-12);
    }
}

void TestCli::picture() {
    succeed({"run", "disc.wend", "--image", "warped.png", "--stmap", "st.exr", "--mesh", "warped.obj"});
    const Image warped = readImage(file("warped.png"));
    QCOMPARE(warped.width, 200);
    const auto alphaAt = [&](int x, int y) { return std::to_integer<int>(warped.row(y)[4 * x + 3]); };
    QCOMPARE(alphaAt(190, 110), 255);  // the dragged side has come here
    QCOMPARE(alphaAt(2, 2), 0);
    const Image map = readImage(file("st.exr"));
    QCOMPARE(map.channels, 4);
    QCOMPARE(map.type, PixelType::Float);
    const auto mesh = sharedMeshFile(file("warped.obj"));
    QCOMPARE(uvOf(*mesh).cols(), pointsOf(*mesh).cols());
    QCOMPARE(pointsOf(*mesh).col(1).head<2>(), Vec2(160, 110));  // the handle, to the last bit
    QVERIFY((uvOf(*mesh).col(1) - Vec2(140.0 / 200, 1 - 100.0 / 200)).norm() < 1e-15);
}

/// An opaque picture that has moved by half a pixel needs one more row and column, which are partly covered.
void TestCli::fittedPictureHasItsLastRowAndColumn() {
    putProject(
        path(), "half.wend",
        "'domain': {'image': 'opaque.png', 'outline': {'from': 'frame'}, 'vertices': 100}, 'handles': ["
        "{'at': {'region': {'box': {'min': [0, 0], 'max': [200, 200]}}}, 'motion': [{'kind': 'translate',"
        "'by': [300.5, -40.25], 'time': [0, 1]}]}]");
    writeImage(file("opaque.png"), test::plainPicture(200, 160, {90, 180, 30}));
    succeed({"run", "half.wend", "--image", "half.png", "--canvas", "fit"});
    const Image fitted = readImage(file("half.png"));
    QCOMPARE(fitted.width, 201);
    QCOMPARE(fitted.height, 161);
    const auto alphaAt = [&](int x, int y) { return std::to_integer<int>(fitted.row(y)[4 * x + 3]); };
    QCOMPARE(alphaAt(100, 80), 255);
    QCOMPARE(alphaAt(0, 80), 128);
    QCOMPARE(alphaAt(200, 80), 128);
    QCOMPARE(alphaAt(100, 0), 64);  // a quarter
    QCOMPARE(alphaAt(100, 160), 191);
}

void TestCli::pictureFits() {
    putProject(
        path(), "away.wend",
        "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 200}, 'handles': ["
        "{'at': {'region': {'box': {'min': [0, 0], 'max': [200, 200]}}}, 'motion': [{'kind': 'translate',"
        "'by': [500, 0], 'time': [0, 1]}]}]");
    succeed({"run", "away.wend", "--image", "away.png", "--canvas", "fit"});
    const Image fitted = readImage(file("away.png"));
    QVERIFY(fitted.width > 150 && fitted.width < 170);
    succeed({"run", "away.wend", "--image", "away.png"});
    QCOMPARE(readImage(file("away.png")).width, 200);
}

void TestCli::texturedMesh() {
    SimplicialMesh<2> mesh = stripMesh(4, 4);
    mesh.points *= 50;  // as large as the picture
    Eigen::Matrix2Xd uv = mesh.points / 200;
    uv.row(1) = 1 - uv.row(1).array();
    test::writeSurface(file("card.obj"), test::surfaceOf(mesh), uv);
    putProject(path(), "card.wend", "'domain': {'mesh': 'card.obj', 'image': 'disc.png'}");
    succeed({"run", "card.wend", "--image", "card.png", "--mesh", "card2.obj", "--filter", "bilinear"});
    QCOMPARE(uvOf(*sharedMeshFile(file("card2.obj"))), uv);
    // y of mesh and picture both run down, so the card is the picture again, to the rounding of the fit
    const Image card = readImage(file("card.png")), disc = readImage(file("disc.png"));
    for (std::size_t i = 3; i < card.data.size(); i += 4)
        QVERIFY(std::abs(std::to_integer<int>(card.data[i]) - std::to_integer<int>(disc.data[i])) <= 1);
}

/// One end of a bar rotates by a quarter turn while the other stays, and no tetrahedron is inverted.
void TestCli::twistedBar() {
    succeed({"run", "bar.wend", "--mesh", "twisted.mesh", "--report", "bar.json"});
    const auto twisted = sharedMeshFile(file("twisted.mesh"));
    const SimplicialMesh<3> rest = barMesh(6);
    QVERIFY(tetrahedraOf(*twisted) == rest.cells);
    QVERIFY((pointsOf(*twisted).col(0) - Vec3(0, 0, 0)).norm() < 1e-13);
    QVERIFY((pointsOf(*twisted).col(6 * 9) - Vec3(2, 0, 6)).norm() <
            1e-12);  // (0, 0, 6) about (1, 1): x towards y
    const QJsonObject report = jsonFile("bar.json").object();
    QCOMPARE(report["dimension"].toInt(), 3);
    QCOMPARE(report["flips"].toInt(), 0);
    QVERIFY(report["minDet"].toDouble() > 0.5);
}

void TestCli::volumeFormats_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"b.mesh", "b.msh", "b.vtk", "b.vtu", "b.node"}) QTest::newRow(name) << name;
}
void TestCli::volumeFormats() {
    QFETCH(QString, name);
    succeed({"run", "bar.wend", "--mesh", name});
    succeed({"run", "bar.wend", "--mesh", "same.mesh"});
    const auto mesh = sharedMeshFile(file(qPrintable(name)));
    QVERIFY(tetrahedraOf(*mesh) == barMesh(6).cells);
    QCOMPARE(pointsOf(*mesh), pointsOf(*sharedMeshFile(file("same.mesh"))));
}

void TestCli::germanLocale() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"LC_ALL", "LC_NUMERIC", "LANG"}) environment.insert(name, "de_DE.UTF-8");
    environment.insert("LOCPATH", WEND_LOCALES);
    // Another program prints the comma, so the locale is really installed.
    QCOMPARE(runCli(path(), {"decimal_point"}, environment, "locale").out.trimmed(), QString(","));
    const CliResult german =
        runCli(path(), {"run", "bend.wend", "--at", "0.5", "--velocity", "-"}, environment);
    QCOMPARE(german.code, 0);
    QCOMPARE(german.out, run({"run", "bend.wend", "--at", "0.5", "--velocity", "-"}).out);
    for (const char* name : {"de.obj", "de.vtu"})
        QCOMPARE(runCli(path(), {"run", "bend.wend", "--at", "0.5", "--mesh", name}, environment).code, 0);
    QCOMPARE(pointsOf(*sharedMeshFile(file("de.obj"))), pointsOf(*sharedMeshFile(file("de.vtu"))));
}

/// The same project gives the same bits with any number of threads.
void TestCli::sameBits() {
    // Two threads are used only from this number of unknowns on.
    writeMesh<2>(file("plate.obj"), stripMesh(110, 50));
    putProject(path(), "plate.wend",
               "'domain': {'mesh': 'plate.obj'}, 'handles': [{'at': {'points': [[0, 0], [0, 50]]}},"
               "{'at': {'points': [[110, 25]]}, 'motion': [{'kind': 'translate', 'by': [-5, 12],"
               "'time': [0, 1]}]}]");
    for (const char* threads : {"1", "2"}) {
        succeed({"run", "plate.wend", "--mesh", QString(threads) + ".obj", "--threads", threads, "--backend",
                 "cpu", "--report", "r.json"});
        const QJsonObject report = jsonFile("r.json").object();
        QVERIFY2(report["device"].toString().startsWith(threads), qPrintable(report["device"].toString()));
    }
    QCOMPARE(readTextFile(file("1.obj")), readTextFile(file("2.obj")));
}

void TestCli::warnsOfUnknownKeys() {
    putProject(path(), "strange.wend", "'domain': {'mesh': 'strip.obj'}, 'mood': 1");
    const CliResult result = run({"run", "strange.wend", "--mesh", "s.obj"});
    QCOMPARE(result.code, 0);
    QVERIFY2(result.error.contains("strange.wend: mood: is not known"), qPrintable(result.error));
    QVERIFY(run({"run", "strange.wend", "--mesh", "s.obj", "--quiet"}).error.isEmpty());
    putProject(
        path(), "centre.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'points': [[0, 0]]}, 'motion': [{'kind': "
        "'rotate', 'center': [0, 0], 'angle': 1}]}]");
    const CliResult centre = run({"run", "centre.wend", "--mesh", "s.obj"});
    QCOMPARE(centre.code, 3);
    QCOMPARE(centre.error,
             QString("wend: centre.wend: handles[0].motion[0]: `center` is not known; `centre`?\n"));
    // Messages about the mesh name the file, too.
    Surface spare = test::surfaceOf(stripMesh(10, 2));
    spare.points.conservativeResize(Eigen::NoChange, spare.points.cols() + 2);
    spare.points.rightCols<2>() << 20, 21, 20, 21, 0, 0;
    test::writeSurface(file("spare.obj"), spare);
    putProject(path(), "spare.wend", "'domain': {'mesh': 'spare.obj'}");
    const CliResult told = run({"run", "spare.wend", "--mesh", "s.obj"});
    QVERIFY2(told.error.contains("spare.wend: 2 vertices belong to no cell"), qPrintable(told.error));
}

/// A body that is only moved keeps the quality of its cells, and its gradient is that of the motion.
void TestCli::qualityAndGradients() {
    std::string turned = readTextFile(file("strip.wend"));
    const std::string move = "\"kind\": \"translate\", \"by\": [3, 0.5]";
    turned.replace(turned.find(move), move.size(),
                   "\"kind\": \"rotate\", \"centre\": [0, 0], \"angle\": 0.5");
    put(path(), "turned.wend", turned);
    succeed(
        {"run", "turned.wend", "--mesh", "turned.vtu", "--mesh", "turned.msh", "--report", "turned.json"});
    const auto mesh = sharedMeshFile(file("turned.vtu"));
    const auto field = [&](const std::string& name) {
        const auto found = std::ranges::find(fieldsOf(*mesh), name, &MeshField::name);
        return found == fieldsOf(*mesh).end() ? MeshField{} : *found;
    };
    const SimplicialMesh<2> rest = stripMesh(10, 2);
    const MeshField displacement = field("displacement"), F = field("F");
    QCOMPARE(displacement.values.size(), std::size_t(3 * rest.vertexCount()));
    QCOMPARE(F.values.size(), std::size_t(9 * rest.cellCount()));
    const double c = std::cos(0.5), s = std::sin(0.5), expected[] = {c, -s, 0, s, c, 0, 0, 0, 1};
    for (std::size_t i = 0; i < F.values.size(); ++i)
        QVERIFY(std::abs(F.values[i] - expected[i % 9]) < 1e-12);
    for (int v = 0; v < rest.vertexCount(); ++v) {
        const Vec2 by(displacement.values[3 * v], displacement.values[3 * v + 1]);
        QVERIFY((pointsOf(*mesh).col(v).head<2>() - rest.points.col(v) - by).norm() < 1e-14);
    }
    // Halves of unit squares: scaled Jacobian 2/√3 · 1/√2, angles 45° and 90°.
    for (const std::string suffix : {"", "_rest"}) {
        for (const double x : field("scaled_jacobian" + suffix).values)
            QVERIFY(std::abs(x - std::sqrt(2.0 / 3)) < 1e-12);
        for (const double x : field("max_angle" + suffix).values) QVERIFY(std::abs(x - 90) < 1e-10);
        QCOMPARE(field("aspect_ratio" + suffix).values.size(), std::size_t(rest.cellCount()));
    }
    const QJsonObject quality = jsonFile("turned.json")["cellQuality"].toObject();
    for (const char* when : {"before", "after"}) {
        const QJsonObject one = quality[when].toObject();
        QVERIFY(std::abs(one["scaledJacobian"].toObject()["worst"].toDouble() - std::sqrt(2.0 / 3)) < 1e-12);
        QVERIFY(std::abs(one["minAngle"].toObject()["mean"].toDouble() - 45) < 1e-10);
        QVERIFY(one["aspectRatio"].toObject().contains("cell"));
    }
    const auto other = sharedMeshFile(file("turned.msh"));
    const auto same = std::ranges::find(fieldsOf(*other), std::string("F"), &MeshField::name);
    QVERIFY(same != fieldsOf(*other).end() && same->values == F.values);
}

/// A run without time.end ends with the last motion.
void TestCli::endOfTheLastMotion() {
    const char* handles =
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'name': 'all', 'at': {'region': {'box': {'min': [-1, "
        "-1], "
        "'max': [11, 3]}}}, 'motion': [{'kind': 'translate', 'by': [3, 0.5], 'time': [0.5, 2.5], 'ease': "
        "'inOut'}]}]";
    putProject(path(), "late.wend", handles);
    succeed({"run", "late.wend", "--mesh", "late.obj", "--report", "late.json"});
    QCOMPARE(jsonFile("late.json")["time"].toDouble(), 2.5);
    QVERIFY((pointsOf(*sharedMeshFile(file("late.obj"))).col(0) - Vec3(3, 0.5, 0)).norm() < 1e-13);
    QCOMPARE(run({"info", "late.wend", "--json"}).out.count("\"end\": 2.5"), 1);
    putProject(path(), "still.wend", "'domain': {'mesh': 'strip.obj'}");
    succeed({"run", "still.wend", "--report", "still.json"});
    QCOMPARE(jsonFile("still.json")["time"].toDouble(), 1.0);
    succeed({"run", "late.wend", "--at", "1.5", "--report", "late.json"});
    const QJsonArray middle = jsonFile("late.json")["reached"].toArray();
    QCOMPARE(middle.size(), 1);
    QCOMPARE(middle.at(0)["name"].toString(), QString("all"));
    QVERIFY(std::abs(middle.at(0)["reached"].toDouble() - 0.5) < 1e-12);
}

void TestCli::endBeforeTheMotions() {
    putProject(path(), "early.wend",
               "'domain': {'mesh': 'strip.obj'}, 'time': {'end': 0.6}, 'mood': 1, 'handles': ["
               "{'name': 'left', 'at': {'points': [[0, 1]]}},"
               "{'name': 'right', 'at': {'points': [[10, 1]]}, 'motion': [{'kind': 'translate', 'by': [1, "
               "0], 'time': [0, 1]}]},"
               "{'at': {'points': [[5, 1]]}, 'active': [0.1, 0.5], 'motion': [{'kind': 'translate', 'by': "
               "[0.1, 0], 'time': [0, 1]}]},"
               "{'at': {'points': [[3, 1]]}, 'motion': [{'kind': 'translate', 'by': [0, 1], 'time': [0, 1], "
               "'ease': 'in'}]}]");
    const CliResult result = run({"run", "early.wend", "--report", "early.json"});
    QCOMPARE(result.code, 0);
    QCOMPARE(result.error.count('\n'), 2);
    QVERIFY2(result.error.contains("early.wend: handle 3 reaches only 36 % of its motion"),
             qPrintable(result.error));
    QVERIFY2(result.error.contains("and 1 more"), qPrintable(result.error));
    const QJsonObject report = jsonFile("early.json").object();
    const double shares[] = {1, 0.6, 1, 0.36};
    for (int h = 0; h < 4; ++h)
        QVERIFY(std::abs(report["reached"].toArray().at(h)["reached"].toDouble() - shares[h]) < 1e-12);
    const QJsonArray notices = report["notices"].toArray();
    QCOMPARE(notices.size(), 2);
    QVERIFY(notices.at(0).toString().startsWith("mood: is not known"));
    QVERIFY(notices.at(1).toString().startsWith("handle 3 reaches only 36 %"));
    // An earlier time given with --at is not reported as the end.
    QCOMPARE(run({"run", "early.wend", "--at", "0.3", "--mesh", "early.obj"}).error.count('\n'), 1);
}

/// A notice about the input ends a strict run before anything is computed, one about the shape after it.
void TestCli::strict() {
    putProject(path(), "odd.wend", "'domain': {'mesh': 'strip.obj', 'vertexes': 3}, 'mood': 1");
    const CliResult odd = run({"run", "odd.wend", "--strict", "--mesh", "odd.obj"});
    QCOMPARE(odd.code, 3);
    QCOMPARE(odd.error.count('\n'), 1);
    QVERIFY2(odd.error.startsWith("wend: odd.wend: ") && odd.error.contains("(and 1 more) (--strict)"),
             qPrintable(odd.error));
    QVERIFY(!QFile::exists(path() + "/odd.obj"));
    QCOMPARE(run({"run", "bend.wend", "--strict", "--mesh", "good.obj"}).code, 0);
    // A format that cannot hold the mesh's data.
    writeMesh<3>(file("plain.vtu"), barMesh(6));
    QCOMPARE(run({"run", "bar.wend", "--strict", "--mesh", "good.vtu"}).code, 0);
    // A twist by seven turns squeezes cells to next to nothing.
    std::string wild = readTextFile(file("bar.wend"));
    wild.replace(wild.find("1.5707963267948966"), 18, "44");
    put(path(), "wild.wend", wild);
    const CliResult loose = run({"run", "wild.wend", "--report", "loose.json"});
    const QJsonArray told = jsonFile("loose.json")["notices"].toArray();
    if (loose.code != 0 || told.isEmpty()) return;
    QFile::remove(path() + "/wild.obj");
    const CliResult shape =
        run({"run", "wild.wend", "--strict", "--mesh", "wild.obj", "--report", "wild.json"});
    QCOMPARE(shape.code, 4);
    QVERIFY(!QFile::exists(path() + "/wild.obj"));
    QCOMPARE(jsonFile("wild.json")["notices"].toArray(), told);
}

void TestCli::roundedNumbersAreReported_data() {
    QTest::addColumn<QString>("input");
    QTest::addColumn<QString>("output");
    QTest::addColumn<QString>("notice");
    const QString rounded("does not hold numbers of this depth"), dark("holds no negative light"), none;
    for (const char* output : {"o.webp", "o.jpg", "o.bmp", "o.tga", "o.ppm"})
        QTest::addRow("16 bits, %s", output) << "deep.tif" << output << rounded;
    for (const char* output : {"o.png", "o.tif", "o.exr"})
        QTest::addRow("16 bits, %s", output) << "deep.tif" << output << none;
    for (const char* output : {"o.png", "o.jp2"})
        QTest::addRow("floats, %s", output) << "float.tif" << output << rounded;
    for (const char* output : {"o.tif", "o.exr"})
        QTest::addRow("floats, %s", output) << "float.tif" << output << none;
    QTest::addRow("negative light") << "float.tif"
                                    << "o.hdr" << dark;
    QTest::addRow("16 bits, o.hdr") << "deep.tif"
                                    << "o.hdr" << rounded;
    for (const char* output : {"o.exr", "o.hdr"})
        QTest::addRow("8 bits, %s", output) << "shallow.png" << output << none;
}
void TestCli::roundedNumbersAreReported() {
    QFETCH(QString, input);
    QFETCH(QString, output);
    QFETCH(QString, notice);
    const PixelType type = input == "deep.tif"    ? PixelType::UInt16
                           : input == "float.tif" ? PixelType::Float
                                                  : PixelType::UInt8;
    Image image = converted(test::plainPicture(40, 40, {90, 180, 30}), {type, 3, false, false});
    if (type == PixelType::Float) reinterpret_cast<float*>(image.row(7))[12] = -0.5F;
    writeImage(file(qPrintable(input)), image);
    putProject(
        path(), "numbers.wend",
        "'domain': {'image': '" + input.toStdString() + "', 'outline': {'from': 'frame'}, 'vertices': 40}");
    const CliResult made = run({"run", "numbers.wend", "--image", output, "--report", "numbers.json"});
    QCOMPARE(made.code, 0);
    const QJsonArray notices = jsonFile("numbers.json")["notices"].toArray();
    QVERIFY(notices.size() == (notice.isEmpty() ? 0 : 1));
    const CliResult copied = run({"convert", input, output});
    QCOMPARE(copied.code, 0);
    QCOMPARE(copied.error.isEmpty(), notice.isEmpty());
    QCOMPARE(run({"run", "numbers.wend", "--image", output, "--strict"}).code, notice.isEmpty() ? 0 : 3);
    if (notice.isEmpty()) return;
    QVERIFY2(notices[0].toString().startsWith(output + ": the format " + notice),
             qPrintable(notices[0].toString()));
    QVERIFY2(copied.error.contains(output + ": the format " + notice), qPrintable(copied.error));
}

void TestCli::meshCommand() {
    succeed({"mesh", "disc.png", "-o", "disc.obj", "--vertices", "600"});
    QVERIFY(std::abs(pointsOf(*sharedMeshFile(file("disc.obj"))).cols() - 600) <= 60);
    succeed({"mesh", "disc.png", "-o", "all.obj", "--vertices", "600", "--outline", "frame"});
    const auto all = sharedMeshFile(file("all.obj"));
    QCOMPARE(pointsOf(*all).row(0).maxCoeff(), 200.0);
    put(path(), "square.json",
        json("{'polygons': [[[0, 0], [10, 0], [10, 10], [0, 10]], [[4, 4], [6, 4], [6, 6], [4, 6]]]}"));
    succeed({"mesh", "square.json", "-o", "square.obj", "--edge", "1"});
    const auto mesh = readMesh<2>(file("square.obj"));
    double area = 0;
    for (const auto& cell : mesh.cells) area += cellMeasure<2>(mesh.points, cell);
    QVERIFY(std::abs(area - 96) < 1e-10);
    // A star of 200 corners keeps them all, and says so.
    std::string corners;
    for (int i = 0; i < 200; ++i) {
        const double angle = i * std::numbers::pi / 100, radius = i % 2 == 0 ? 10 : 8;
        corners += (i > 0 ? ", [" : "[") + std::to_string(radius * std::cos(angle)) + ", " +
                   std::to_string(radius * std::sin(angle)) + "]";
    }
    put(path(), "star.json", json("{'polygons': [[" + corners + "]]}"));
    const CliResult star = runCli(path(), {"mesh", "star.json", "-o", "star.obj", "--vertices", "50"});
    const auto count = pointsOf(*sharedMeshFile(file("star.obj"))).cols();
    QVERIFY(count >= 200);
    QVERIFY2(star.error.contains(QString("has %1 vertices, where 50 were aimed at: its outline").arg(count)),
             qPrintable(star.error));
    succeed({"mesh", "disc.wend", "-o", "again.vtu"});
    QCOMPARE(pointsOf(*sharedMeshFile(file("again.vtu"))).col(1).head<2>(),
             Vec2(140, 100));  // the handle's point
}

void TestCli::surfaceCommand() {
    put(path(), "cube.off",
        "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    succeed({"mesh", "cube.off", "-o", "cube.vtu", "--max-volume", "0.01"});
    const auto mesh = readMesh<3>(file("cube.vtu"));
    double volume = 0;
    for (const auto& cell : mesh.cells) volume += std::abs(cellMeasure<3>(mesh.points, cell));
    QVERIFY(std::abs(volume - 1) < 1e-12);
}

void TestCli::infoOfPicture() {
    const auto info = QJsonDocument::fromJson(run({"info", "disc.png", "--json"}).out.toUtf8());
    QCOMPARE(info["width"].toInt(), 200);
    QCOMPARE(info["alpha"].toBool(), true);
    QCOMPARE(info["outline"]["loops"].toInt(), 1);
    // The outline grows by a margin of a few pixels beyond the disc of 80.
    const double area = info["outline"]["each"][0]["area"].toDouble(), disc = std::numbers::pi * 80 * 80;
    QVERIFY2(area > disc && area < 1.15 * disc, qPrintable(QString::number(area)));
    QVERIFY(run({"info", "disc.png"}).out.contains("width: 200\n"));
    // Layers are listed from front to back, whatever their format.
    const auto namesIn = [&](const char* layered) {
        const QString picture = QStringLiteral(WEND_SOURCE_DIR "/tests/data/pictures/") + layered;
        const auto json = QJsonDocument::fromJson(run({"info", picture, "--json"}).out.toUtf8());
        QStringList names;
        for (const QJsonValue& layer : json["layers"].toArray()) names << layer["name"].toString();
        return names;
    };
    const QString body = QString::fromUtf8("Körper");
    QCOMPARE(namesIn("layers.psd"), (QStringList{"arm", "masked", body}));
    QCOMPARE(namesIn("layers.ora"), (QStringList{"head", "arm & hand", body}));
    QCOMPARE(namesIn("layers.kra").last(), body);
}

void TestCli::infoOfBadMesh() {
    put(path(), "bad.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 0 0\nf 1 2 3\nf 2 4 3\nf 2 4 5\nf 1 2 5\nf 2 5 1\n");
    const auto info = QJsonDocument::fromJson(run({"info", "bad.obj", "--json"}).out.toUtf8());
    QCOMPARE(info["cells"].toInt(), 5);
    QHash<QString, QJsonArray> problems;
    for (const QJsonValue& problem : info["problems"].toArray())
        problems[problem["what"].toString()] = problem["where"].toArray();
    QCOMPARE(problems.value("cells without area"), (QJsonArray{3, 4}));
    QCOMPARE(problems.value("cells that repeat an earlier one"), (QJsonArray{4}));
    QVERIFY(!problems.contains("cells oriented against the others"));  // a matter of order, turned inside
    QVERIFY(run({"info", "bad.obj"}).out.contains("cells without area"));
    const auto good = QJsonDocument::fromJson(run({"info", "bar.mesh", "--json"}).out.toUtf8());
    QVERIFY(good["problems"].toArray().isEmpty());
    QVERIFY(std::abs(good["volume"].toDouble() - 24) < 1e-12);
    QCOMPARE(good["parts"].toInt(), 1);
    int angles = 0;
    for (const QJsonValue count : good["quality"]["leastAngles"]["counts"].toArray()) angles += count.toInt();
    QCOMPARE(angles, good["cells"].toInt());
    // The corner of a cube, and one below it that is eight times as deep, by the normals of their sides.
    put(path(), "two.mesh",
        "MeshVersionFormatted 1\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 -8 0\n"
        "Tetrahedra 2\n1 2 3 4 0\n1 3 2 5 0\nEnd\n");
    const auto two = QJsonDocument::fromJson(run({"info", "two.mesh", "--json"}).out.toUtf8())["quality"];
    const double degrees = 180 / std::numbers::pi, even = degrees * std::acos(1 / std::sqrt(3)),
                 deep = degrees * std::acos(1 / std::sqrt(2 + 1.0 / 64));
    QVERIFY(std::abs(two["leastAngle"].toDouble() - deep) < 1e-6);
    QVERIFY(std::abs(two["meanOfLeastAngles"].toDouble() - (even + deep) / 2) < 1e-6);
    const QString text = run({"info", "bar.mesh"}).out;
    QVERIFY(text.contains("least angles:\n"));
    QVERIFY(text.contains("█\n"));
}

void TestCli::infoOfProject() {
    const auto info = QJsonDocument::fromJson(run({"info", "bend.wend", "--json"}).out.toUtf8());
    QCOMPARE(info["dimension"].toInt(), 2);
    QCOMPARE(info["handles"].toArray().size(), 2);
    QCOMPARE(info["phi"].toString(), QString("metr"));
    QVERIFY(info["domain"]["vertices"].isUndefined());  // the mesh is what it is
    put(path(), "solid.wend",
        R"({"format": "wend", "version": 1, "domain": {"surface": "cube.off", "vertices": 700, "detail": "skin.obj"}})");
    const auto solid = QJsonDocument::fromJson(run({"info", "solid.wend", "--json"}).out.toUtf8());
    QCOMPARE(solid["domain"]["vertices"].toInt(), 700);
    QCOMPARE(solid["domain"]["detail"].toString(), QString("skin.obj"));
}

void TestCli::convert() {
    succeed({"convert", "bar.mesh", "bar.vtu"});
    succeed({"convert", "bar.vtu", "bar-again.msh", "--encoding", "binary", "--msh", "2.2"});
    const auto bar = sharedMeshFile(file("bar.mesh")), again = sharedMeshFile(file("bar-again.msh"));
    QCOMPARE(pointsOf(*again), pointsOf(*bar));
    QVERIFY(tetrahedraOf(*again) == tetrahedraOf(*bar));
    put(path(), "colours.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
        "z\nproperty "
        "uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int "
        "vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    succeed({"convert", "colours.ply", "colours.vtu"});
    const CliResult told = run({"convert", "colours.ply", "colours.stl"});
    QCOMPARE(told.code, 0);
    QCOMPARE(told.error.count('\n'), 1);
    QVERIFY2(told.error.startsWith("wend: colours.stl: "), qPrintable(told.error));
    succeed({"convert", "colours.ply", "colours.stl", "--quiet"});
    succeed({"convert", "disc.png", "disc.tif"});
    QCOMPARE(readImage(file("disc.tif")).data, readImage(file("disc.png")).data);
    QVERIFY(run({"convert", "disc.png", "disc.jpg"}).error.contains("no transparency"));
    QVERIFY(run({"convert", "strip.obj", "-"}).out.contains("VTKFile"));
    // Layers, and what is written, are named with the file once.
    const QString layers = QStringLiteral(WEND_SOURCE_DIR "/tests/data/pictures/layers.ora");
    const QString notice = run({"convert", layers, "flat.png"}).error;
    QVERIFY2(notice.startsWith("wend: " + layers + ": has 3 layers"), qPrintable(notice));
    QCOMPARE(run({"convert", "strip.obj"}).code, 2);
    QCOMPARE(run({"convert", "strip.obj", "./strip.obj"}).code, 2);
    QCOMPARE(run({"convert", "strip.obj", "strip.xyz"}).code, 3);
    QCOMPARE(run({"convert", "nowhere.obj", "strip.vtu"}).code, 3);
    QCOMPARE(run({"convert", "strip.wend", "strip.vtu"}).code, 2);
    for (const QStringList& words :
         {QStringList{"convert", "-", "strip.vtu"}, {"info", "-"}, {"mesh", "-", "-o", "a.msh"}}) {
        const CliResult refused = run(words);
        QCOMPARE(refused.code, 2);
        QVERIFY2(refused.error.contains("only `wend run` reads standard input"), qPrintable(refused.error));
    }
}

/// OBJ files keep their materials, objects, smoothing groups and comments, as those of `wend run` do; a
/// material file is named from the folder of the output.
void TestCli::objStaysObj() {
    QDir(path()).mkdir("obj");
    put(path(), "look.mtl", "newmtl red\nKd 1 0 0\n");
    put(path(), "more.mtl", "newmtl blue\nKd 0 0 1\n");
    const std::string rest =
        "o Head\ng left\ns 1\nusemtl red\nf 1/1 3/3 2/2\ns off\nf 1 2 4\no Tail\nf 2 3 4\nf 3 1 4\n";
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n" + rest;
    put(path(), "look.obj", "# by hand\nmtllib look.mtl more.mtl\n" + text);
    const CliResult result = run({"convert", "look.obj", "obj/look.obj"});
    QCOMPARE(result.code, 0);
    QCOMPARE(result.error, QString());
    QCOMPARE(readTextFile(file("obj/look.obj")), "# by hand\nmtllib ../look.mtl ../more.mtl\n" + text);
}

void TestCli::devices() {
    const CliResult result = run({"devices"});
    QCOMPARE(result.code, 0);
    QVERIFY(result.out.startsWith("cpu "));
}

/// Writing to a link changes the file that it names and keeps the file's permissions; anything that is not a
/// regular file is left as it is.
void TestCli::linksAndPermissions() {
    put(path(), "real.json", "old");
    QFile::setPermissions(path() + "/real.json", QFile::ReadOwner | QFile::WriteOwner);
    QFile::link("real.json", path() + "/link.json");
    succeed({"run", "bend.wend", "--report", "link.json"});
    QVERIFY(QFileInfo(path() + "/link.json").isSymLink());
    QCOMPARE(jsonFile("real.json")["vertices"].toInt(), 33);
    QVERIFY(!(QFileInfo(path() + "/real.json").permissions() & QFile::ReadOther));
    succeed({"run", "bend.wend", "--report", "/dev/null"});
    QVERIFY(!QFileInfo("/dev/null").isFile());
}

QTEST_GUILESS_MAIN(TestCli)
#include "test_cli.moc"
