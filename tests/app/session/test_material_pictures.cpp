#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>
#include <cmath>
#include <numbers>

#include "app/engine/shape/material_picture.h"
#include "app/engine/shape/shape_builder.h"
#include "app/output/overwriting.h"
#include "app/panels/layer_panel.h"
#include "app/project/edits/material_edits.h"
#include "app/project/file/named_files.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "app/session/opening.h"
#include "app/window/export/exporter.h"
#include "app/window/notices/info_banner.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/dialogs.h"
#include "tests/support/layers.h"
#include "tests/support/mesh_files.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// Computes φ of a gray value independently: black, a third, two thirds and white are the named energies.
double phiOfGray(double gray) {
    const double stops[] = {std::atan(1.0 / 512), std::atan(0.5), kPi / 2, kPi - std::atan(0.5)};
    const int i = std::min(2, static_cast<int>(3 * gray));
    return stops[i] + (3 * gray - i) * (stops[i + 1] - stops[i]);
}

/// Computes the gray value of φ.
double grayOfPhi(double phi) {
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) (phiOfGray((low + high) / 2) < phi ? low : high) = (low + high) / 2;
    return low;
}

Vec2 middleOf(const SimplicialMesh<2>& mesh, int cell) {
    Vec2 sum = Vec2::Zero();
    for (const int v : mesh.cells[cell]) sum += mesh.points.col(v) / 3;
    return sum;
}

/// Returns a pixel of a picture as another program's reader gives it.
double grayAt(const QImage& image, const Vec2& p) {
    return QColor(image.pixelColor(static_cast<int>(p.x()), static_cast<int>(p.y()))).redF();
}

/// Writes a ramp from black at the left to white at the right, as paint programs do.
QString writeRamp(const QTemporaryDir& folder, int width = 240, int height = 160) {
    QImage ramp(width, height, QImage::Format_Grayscale8);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ramp.scanLine(y)[x] = static_cast<uchar>(255 * x / (width - 1));
    const QString path = folder.filePath("ramp.png");
    ramp.save(path);
    return path;
}

Project stripProject(const QTemporaryDir& folder) {
    writeMesh<2>(folder.filePath("strip.obj").toStdString(), stripMesh(16, 4));
    Project project;
    project.domain.kind = DomainKind::Mesh;
    project.domain.path = folder.filePath("strip.obj").toStdString();
    return project;
}

Material<2> materialOf(const Project& project) {
    return *std::get<Shape<2>>(loadShape(project, {})).material;
}

MaterialRegion& addRegion(Project& project, const Box<3>& box) {
    return project.design.material.layers.emplace_back(layerWith({}, {{box}})).regions.front();
}

}  // namespace

/// The material is read from pictures and written to them.
class TestMaterialPictures : public QObject {
    Q_OBJECT
  private slots:
    void rampsBecomePhi();
    void everythingComesBack();
    void directionsAreAsSeen_data();
    void directionsAreAsSeen();
    void transparentLeavesWhatIsThere();
    void projectsNameTheirPictures();
    void hiddenRegionsChangeNothing();
    void cellsComeFromMeshFiles();
    void commandLineWritesAndPaints();
    void windowBringsInAndWrites();
    void brokenPicturesAreReported();
};

/// The picture covers the bounding box, whatever its size; every cell has the mean of its pixels.
void TestMaterialPictures::rampsBecomePhi() {
    QTemporaryDir folder;
    for (const QSize& size : {QSize(240, 160), QSize(24, 16), QSize(1200, 800)}) {
        Project project = stripProject(folder);
        auto& region = addRegion(project, {{0, 0, 0}, {16, 4, 0}});
        region.pictures.phi = writeRamp(folder, size.width(), size.height()).toStdString();
        const Material<2> material = materialOf(project);
        const SimplicialMesh<2> mesh = stripMesh(16, 4);
        const double pixel = 1.0 / size.width();
        for (int c = 0; c < mesh.cellCount(); ++c) {
            const double gray = (middleOf(mesh, c).x() / 16 - pixel / 2) / (1 - pixel);
            QVERIFY(std::abs(grayOfPhi(material.phi[c]) - gray) < 1.0 / 255 + pixel / 2);
        }
    }
}

/// Written pictures are read back unchanged; an independent reader finds the documented numbers.
void TestMaterialPictures::everythingComesBack() {
    QTemporaryDir folder;
    Project project;
    project.domain.path = writeCutOut(folder).toStdString();
    project.domain.outline = OutlineKind::Alpha;
    project.domain.vertices = 200;
    project.design.material.layers.push_back(layerWith(
        "ramp", {{Blend<3>{{20, 80, 0}, {220, 80, 0}}}, phi::conformal(2), Stiffness{{1, 2, 0}, 500}}));
    const Shape<2> shape = std::get<Shape<2>>(loadShape(project, {}));
    const PictureFrame frame = pictureFrame(240, 160, *shape.rest);
    MaterialPictures pictures;
    for (const MaterialPart part : kMaterialParts) {
        const std::string path = folder.filePath("part%1.png").arg(static_cast<int>(part)).toStdString();
        writeImage(path, materialPicture(part, frame, *shape.rest, *shape.material));
        pictures.*fileOf(part) = path;
    }
    const QImage keep(QString::fromStdString(pictures.phi)),
        stiff(QString::fromStdString(pictures.stiffness));
    QCOMPARE(keep.size(), QSize(240, 160));
    QCOMPARE(keep.pixelColor(2, 2).alpha(), 0);  // beside the shape
    for (int c = 0; c < shape.rest->cellCount(); ++c) {
        const Vec2 p = middleOf(*shape.rest, c);
        QVERIFY(std::abs(phiOfGray(grayAt(keep, p)) - shape.material->phi[c]) < 1e-3);
        const auto B = shape.material->anisotropy[c];
        const double half = (B(0, 0) - B(1, 1)) / 2, mean = B.trace() / 2, r = std::hypot(half, B(0, 1));
        QVERIFY(std::abs(1000 * std::pow(1000, grayAt(stiff, p) - 1) - (mean + r) / (mean - r)) <
                1e-3 * (mean + r));
    }
    project.design.material.layers.clear();
    project.design = withPictures(project.design, "all", frame.box, pictures);
    const Material<2> again = materialOf(project);
    for (int c = 0; c < shape.rest->cellCount(); ++c) {
        QVERIFY(std::abs(again.phi[c] - shape.material->phi[c]) < 1e-4);
        QVERIFY((again.anisotropy[c] - shape.material->anisotropy[c]).norm() <
                1e-3 * shape.material->anisotropy[c].norm());
    }
}

void TestMaterialPictures::directionsAreAsSeen_data() {
    QTest::addColumn<int>("gray");
    QTest::addColumn<bool>("up");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    const double r = std::sqrt(0.5);
    QTest::newRow("lies") << 0 << true << 1.0 << 0.0;
    QTest::newRow("rises") << 16384 << true << r << r;
    QTest::newRow("rises, y down") << 16384 << false << r << -r;
    QTest::newRow("stands") << 32768 << true << 0.0 << 1.0;
    QTest::newRow("falls") << 49151 << true << -r << r;
    QTest::newRow("lies again") << 65535 << true << 1.0 << 0.0;
}

void TestMaterialPictures::directionsAreAsSeen() {
    QFETCH(int, gray);
    QFETCH(bool, up);
    QFETCH(double, x);
    QFETCH(double, y);
    QTemporaryDir folder;
    QImage one(3, 3, QImage::Format_Grayscale16);
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i) reinterpret_cast<quint16*>(one.scanLine(row))[i] = quint16(gray);
    const QString path = folder.filePath("one.png");
    one.save(path);
    Project project = stripProject(folder);
    auto& base = addRegion(project, {{0, 0, 0}, {16, 4, 0}});
    base.stiffness = Stiffness{{3, 1, 0}, 20};
    auto& region = addRegion(project, {{0, 0, 0}, {16, 4, 0}});
    region.pictures.direction = path.toStdString();
    region.pictures.up = up;
    const Vec2 axis(x, y);
    for (const Mat2& B : materialOf(project).anisotropy)
        QVERIFY((B - Mat2::Identity() - 19 * axis * axis.transpose()).norm() < 5e-3);
}

void TestMaterialPictures::transparentLeavesWhatIsThere() {
    QTemporaryDir folder;
    QImage image(160, 40, QImage::Format_RGBA64);
    image.fill(Qt::transparent);
    for (int y = 0; y < 40; ++y)
        for (int x = 80; x < 160; ++x) image.setPixelColor(x, y, QColor(255, 255, 255, x < 120 ? 255 : 128));
    const QString path = folder.filePath("half.png");
    image.save(path);
    Project project = stripProject(folder);
    addRegion(project, {{0, 0, 0}, {16, 4, 0}}).pictures.phi = path.toStdString();
    const Material<2> material = materialOf(project);
    const SimplicialMesh<2> mesh = stripMesh(16, 4);
    const double to = phi::conformal(2) - phi::kMetr;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const double part = std::abs(material.phi[c] - phi::kMetr) / to, at = middleOf(mesh, c).x();
        QVERIFY(std::abs(part - (at < 8 ? 0 : at < 12 ? 1 : 128.0 / 255)) < 1e-3);
    }
}

/// The project names its pictures relative to its folder, follows them when moved, and refuses them as
/// outputs of a run.
void TestMaterialPictures::projectsNameTheirPictures() {
    QTemporaryDir folder;
    Project project = stripProject(folder);
    auto& region = addRegion(project, {{0, 0, 0}, {16, 4, 0}});
    project.design.material.layers.back().name = "ramp";
    region.pictures = {writeRamp(folder).toStdString(), "", "", true, 3};
    region.hidden = true;
    const std::string path = folder.filePath("ramp.wend").toStdString();
    writeProject(path, project);
    QVERIFY(readTextFile(path).find("\"phi\": \"ramp.png\"") != std::string::npos);
    const Project read = *readProject(path).project;
    const auto& back = read.design.material.layers.at(0).regions.at(0);
    QVERIFY(back.hidden && back.pictures.up && back.pictures.phi == "ramp.png" && !back.phi);
    QCOMPARE(toJson(read), toJson(*readProject(path).project));
    RunOutputs outputs;
    outputs.image = {folder.filePath("ramp.png").toStdString()};
    QVERIFY(!overwriting(inputsOf(read, path, folderOf(path)), outputs).empty());
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string text = readTextFile(path);
        text.replace(text.find(from), from.size(), to);
        QVERIFY_THROWS_EXCEPTION(InputError, parseProject(text, path));
    };
    refused("\"pictures\"", "\"phi\": 1, \"pictures\"");
    refused("\"box\"", "\"halfspace\"");
    refused("\"up\": true", "\"up\": 1");
}

void TestMaterialPictures::hiddenRegionsChangeNothing() {
    QTemporaryDir folder;
    Project project = stripProject(folder);
    const Material<2> plain = materialOf(project);
    auto& region = addRegion(project, {{0, 0, 0}, {16, 4, 0}});
    region.phi = phi::kAkvf;
    region.stiffness = Stiffness{{1, 0, 0}, 9};
    QVERIFY(materialOf(project).phi != plain.phi);
    region.hidden = true;
    QVERIFY(materialOf(project).phi == plain.phi && materialOf(project).anisotropy.empty());
}

/// The values are read back from a mesh file that was written with them.
void TestMaterialPictures::cellsComeFromMeshFiles() {
    QTemporaryDir folder;
    for (const char* name : {"cells.vtu", "cells.vtk"}) {
        const SimplicialMesh<3> bar = barMesh(3);
        MeshField phi{"phi", true, 1, {}}, B{"B", true, 9, {}};
        const std::size_t count = bar.cells.size();
        for (std::size_t c = 0; c < count; ++c) {
            phi.values.push_back(0.1 + 0.01 * static_cast<double>(c));
            const double own[] = {2, 0.5, 0, 0.5, 3, 0, 0, 0, 1.0 + static_cast<double>(c)};
            B.values.insert(B.values.end(), std::begin(own), std::end(own));
        }
        const std::string path = folder.filePath(name).toStdString();
        writeSolid(path, bar, {phi, B});
        MaterialSpec spec;
        readCells(path, spec, 3);
        QVERIFY(spec.cellPhi == phi.values);
        QCOMPARE(spec.cellB.size(), count);
        QCOMPARE(spec.cellB[5](2, 2), 6.0);
        QCOMPARE(spec.cellB[5](0, 1), 0.5);
        MaterialSpec flat;
        readCells(path, flat, 2);
        QVERIFY((flat.cellB[5].topLeftCorner<2, 2>().isApprox(spec.cellB[5].topLeftCorner<2, 2>(), 0)));
        B.values[7] = 0.5;  // leaves the plane
        writeSolid(path, bar, {phi, B});
        QVERIFY_THROWS_EXCEPTION(InputError, readCells(path, flat, 2));
        writeSolid(path, bar);
        QVERIFY_THROWS_EXCEPTION(InputError, readCells(path, spec, 2));
    }
}

void TestMaterialPictures::commandLineWritesAndPaints() {
    QTemporaryDir folder;
    writeCutOut(folder);
    writeRamp(folder);
    putProject(folder.path(), "bar.wend",
               "'domain': {'image': 'bar.png', 'outline': {'from': 'alpha'}, 'vertices': 200},"
               "'material': {'phi': 'metr'}, 'handles': []");
    const CliResult painted =
        runCli(folder.path(), {"run", "bar.wend", "--paint-phi", "ramp.png", "--phi-picture", "back.png",
                               "--stiffness-picture", "stiff.tif"});
    QCOMPARE(painted.code, 0);
    const QImage back(folder.filePath("back.png")), ramp(folder.filePath("ramp.png"));
    QCOMPARE(back.size(), ramp.size());
    for (const int x : {40, 120, 200}) {
        const double gray = back.pixelColor(x, 80).redF();
        QVERIFY(std::abs(gray - ramp.pixelColor(x, 80).redF()) < 0.08);  // a cell's width
    }
    QVERIFY(QFile::exists(folder.filePath("stiff.tif")));
    // Exporting again gives the same pictures and keeps the user's own.
    QCOMPARE(
        runCli(folder.path(), {"run", "bar.wend", "--paint-phi", "back.png", "--phi-picture", "again.png"})
            .code,
        0);
    const QImage again(folder.filePath("again.png"));
    QCOMPARE(again.pixelColor(120, 80), back.pixelColor(120, 80));
    QCOMPARE(
        runCli(folder.path(), {"run", "bar.wend", "--paint-phi", "back.png", "--phi-picture", "back.png"})
            .code,
        2);
    QCOMPARE(runCli(folder.path(), {"run", "bar.wend", "--paint-phi", "none.png"}).code, 3);
    QCOMPARE(runCli(folder.path(), {"run", "bar.wend", "--phi-picture", "back.obj"}).code, 3);
}

/// The menu and the file dialog import a picture; the layer can be hidden, moved in the list and undone step
/// by step.
void TestMaterialPictures::windowBringsInAndWrites() {
    QTemporaryDir folder;
    SolidFixture f;
    QVERIFY(f.openPicture());
    auto& session = f.session();
    f.window().tools().setMode(Mode::Paint);
    const QString ramp = writeRamp(folder);
    auto& actions = f.window().materialActions();
    nameNextFile(&f.window(), ramp);
    actions.bringIn[MaterialPart::Keep]->trigger();
    QVERIFY(settle(session));
    const auto& layers = *f.window().properties().layers().list();
    const auto phiAt = [&](const Vec2& p) {
        const auto frame = session.motion().frame<2>();
        int best = 0;
        for (int c = 0; c < frame->rest->cellCount(); ++c)
            if ((middleOf(*frame->rest, c) - p).norm() < (middleOf(*frame->rest, best) - p).norm()) best = c;
        return frame->material->phi[best];
    };
    QCOMPARE(layers.count(), 1);
    QCOMPARE(layers.item(0)->text(), QStringLiteral("ramp"));
    QVERIFY(phiAt({40, 80}) < 0.4 && phiAt({200, 80}) > 2);
    const QString written = folder.filePath("out.png");
    nameNextFile(&f.window(), written);
    actions.write[MaterialPart::Keep]->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(written), 20000);
    QVERIFY(std::abs(phiOfGray(QImage(written).pixelColor(200, 80).redF()) - phiAt({200.5, 80.5})) < 0.2);
    // The eye: a click on it, beside the name.
    auto& list = const_cast<QListWidget&>(layers);
    const QRect row = list.visualItemRect(list.item(0));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, QPoint(row.left() + 10, row.center().y()));
    QVERIFY(settle(session));
    QVERIFY(session.document().design().material.layers.at(0).isHidden());
    QCOMPARE(phiAt({200, 80}), phi::kMetr);
    QCOMPARE(session.document().undoStack()->undoText(), LayerPanel::tr("Hide layer"));
    f.window().actions().undo->trigger();
    QVERIFY(settle(session));
    QVERIFY(phiAt({200, 80}) > 2);
    // The paint program saves the picture again, and it is reloaded.
    list.setCurrentRow(0);
    QImage(QImage(ramp).mirrored(true, false)).save(ramp);
    f.window().properties().layers().findChild<QToolButton*>("layerReadAgain")->click();
    QVERIFY(settle(session));
    QVERIFY(phiAt({40, 80}) > 2 && phiAt({200, 80}) < 0.4);
    // Below another layer it is covered.
    MaterialRegion all;
    all.shape = Box<3>{{0, 0, 0}, {240, 160, 0}};
    all.phi = phi::kAkvf;
    session.document().changeDesign("Box", withStroke(session.document().design(), {.name = "Box 1"}, {all}));
    QVERIFY(settle(session));
    QCOMPARE(phiAt({40, 80}), phi::kAkvf);
    QVERIFY(list.model()->moveRow({}, 1, {}, 0));
    QVERIFY(settle(session));
    QTRY_VERIFY(phiAt({40, 80}) > 2);
    QCOMPARE(session.document().design().material.layers.back().name, std::string("ramp"));
}

void TestMaterialPictures::brokenPicturesAreReported() {
    QTemporaryDir folder;
    SolidFixture f;
    QVERIFY(f.openPicture());
    put(folder.path(), "broken.png", "no picture");
    QString told;
    connect(&f.window().materialActions(), &MaterialActions::failed, this,
            [&](const QString& text) { told = text; });
    const auto before = f.session().document().project();
    f.window().materialActions().take(MaterialPart::Keep, folder.filePath("broken.png"));
    QVERIFY(told.contains("broken.png"));
    QVERIFY(f.session().document().project() == before);
}

QTEST_MAIN(TestMaterialPictures)
#include "test_material_pictures.moc"
