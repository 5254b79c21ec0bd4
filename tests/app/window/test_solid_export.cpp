#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "app/output/run_options.h"
#include "app/panels/fields/option_field.h"
#include "app/project/project.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/export/export_panel.h"
#include "app/window/export/exporter.h"
#include "app/window/export/picture_dialog.h"
#include "app/window/export/view_picture.h"
#include "app/window/main_window.h"
#include "app/window/solid_workshop.h"
#include "core/base/error.h"
#include "core/mesh/mesh_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/surfaces.h"
#include "tests/support/webp_frames.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The window's export of a solid compared with that of `wend run` for the same project.
class TestSolidExport : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void cleanupTestCase();
    void meshIsThatOfTheCommandLine_data();
    void meshIsThatOfTheCommandLine();
    void verticesAreThoseOfTheFile();
    void borderTrianglesAreAtChoice();
    void sequenceIsThatOfTheCommandLine();
    void animationIsThatOfTheCommandLine();
    void picturesAreAsChosen();
    void picturesAreWrittenInStrips();
    void picturesAreCancelled();
    void viewIsFilmed();
    void filmIsCancelled();
    void filmIsAtChoiceWhereThereIsMotion();
    void choicesOfViewsAreRemembered();
    void legendAndMarksAreAtChoice();
    void badPlacesAreReported();

  private:
    bool finish(const std::function<void()>& write);
    QString file(const QString& name) const { return m_folder->filePath(name); }
    QByteArray bytes(const QString& name) const;

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
    QString m_failure;
};

namespace {

std::string objOf(const Surface& surface) {
    std::string text = "mtllib bar.mtl\nusemtl blue\nvt 0 0\n";
    for (Eigen::Index i = 0; i < surface.points.cols(); ++i) {
        const Vec3 p = surface.points.col(i);
        text +=
            "v " + std::to_string(p.x()) + ' ' + std::to_string(p.y()) + ' ' + std::to_string(p.z()) + '\n';
    }
    for (const auto& t : surface.triangles)
        text += "f " + std::to_string(t[0] + 1) + "/1 " + std::to_string(t[1] + 1) + "/1 " +
                std::to_string(t[2] + 1) + "/1\n";
    return text;
}

/// Compares everything exactly, except for the velocity, which the two compute from different initial
/// guesses.
void compareMeshes(const MeshFile& window, const MeshFile& commandLine) {
    QVERIFY(window.points == commandLine.points);
    QVERIFY(window.triangles == commandLine.triangles && window.tetrahedra == commandLine.tetrahedra);
    QVERIFY(window.labels == commandLine.labels && window.labelNames == commandLine.labelNames);
    QCOMPARE(window.fields.size(), commandLine.fields.size());
    for (std::size_t f = 0; f < window.fields.size(); ++f) {
        const MeshField &a = window.fields[f], &b = commandLine.fields[f];
        QCOMPARE(a.name, b.name);
        QCOMPARE(a.values.size(), b.values.size());
        double difference = 0;
        for (std::size_t i = 0; i < a.values.size(); ++i)
            difference = std::max(difference, std::abs(a.values[i] - b.values[i]));
        // The ends move at a speed of about 3; the integration's tolerance is 1e-4.
        QVERIFY2(difference <= (QByteArray(a.name.c_str()).startsWith("velocity") ? 1e-5 : 0),
                 a.name.c_str());
    }
}

}  // namespace

void TestSolidExport::initTestCase() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_folder = std::make_unique<TestFolder>();
    put(m_folder->path(), "bar.obj", objOf(box({-2, -0.5, -0.5}, {2, 0.5, 0.5}, 4)));
    put(m_folder->path(), "bar.mtl", "newmtl blue\nKd 0.2 0.3 0.9\n");
    putProject(
        m_folder->path(), "bar.wend",
        "'domain': {'surface': 'bar.obj', 'vertices': 200}, 'handles': [{'name': 'low', 'at': {'region': "
        "{'box': {'min': [-3, -1, -1], 'max': [-1.8, 1, 1]}}}}, {'name': 'high', 'at': {'region': {'box': "
        "{'min': [1.8, -1, -1], 'max': [3, 1, 1]}}}, 'motion': [{'kind': 'rotate', 'centre': [1, 0, 0], "
        "'axis': [0, 1, 0], 'angle': -1, 'time': [0, 1]}]}], 'time': {'end': 1}");
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1000, 700);
    m_window->show();
    m_window->openPath(file(QStringLiteral("bar.wend")));
    QVERIFY(QTest::qWaitFor([&] { return !m_window->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_window->session()));
}

void TestSolidExport::cleanupTestCase() {
    m_window.reset();
}

QByteArray TestSolidExport::bytes(const QString& name) const {
    QFile read(file(name));
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

/// Returns true once the file has been written.
bool TestSolidExport::finish(const std::function<void()>& write) {
    QSignalSpy done(&m_window->exporter(), &Exporter::done), failed(&m_window->exporter(), &Exporter::failed);
    write();
    if (!QTest::qWaitFor([&] { return done.count() + failed.count() > 0; }, 60000)) return false;
    if (failed.count() > 0) m_failure = failed.first().first().toString();
    return done.count() == 1;
}

void TestSolidExport::meshIsThatOfTheCommandLine_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<int>("gmsh");
    for (const char* extension : {"vtu", "vtk", "mesh", "node", "obj", "ply", "stl", "off", "glb"})
        QTest::newRow(extension) << extension << 4;
    QTest::newRow("msh 4.1") << "msh" << 4;
    QTest::newRow("msh 2.2") << "msh" << 2;
}

void TestSolidExport::meshIsThatOfTheCommandLine() {
    QFETCH(QString, extension);
    QFETCH(int, gmsh);
    const QString name = QStringLiteral("window.") + extension, other = QStringLiteral("line.") + extension;
    RunOptions options;
    options.meshes.gmshVersion = gmsh;
    QVERIFY2(finish([&] { m_window->exporter().write(ExportKind::Mesh, file(name), options); }),
             qPrintable(m_failure));
    const CliResult run = runCli(m_folder->path(), {"run", "bar.wend", "--quiet", "--mesh", other, "--msh",
                                                    gmsh == 2 ? "2.2" : "4.1"});
    QVERIFY2(run.code == 0, qPrintable(run.error));
    if (extension == QStringLiteral("glb")) {
        QVERIFY(bytes(name).size() > 1000 && bytes(name) == bytes(other));
        return;
    }
    const MeshFile window = readMeshFile(file(name).toStdString());
    QVERIFY(window.points.cols() > 50);
    compareMeshes(window, readMeshFile(file(other).toStdString()));
    QVERIFY(window.points.row(2).maxCoeff() > 0.6);  // bent
}

/// A surface has fewer than the solid behind it.
void TestSolidExport::verticesAreThoseOfTheFile() {
    ShapeSession& session = m_window->session();
    const auto shape = std::make_shared<const FrameExport>(session.document(), session.motion().frame(),
                                                           session.motion().track().frames(), 1.0);
    ExportDialog dialog({ExportKind::Mesh, shape}, m_window->exporter().choices(), m_window.get());
    auto* format = dialog.findChild<QComboBox*>(QStringLiteral("format"));
    const auto* facts = dialog.findChild<QLabel*>(QStringLiteral("facts"));
    for (const char* extension : {".vtu", ".off", ".obj", ".mesh"}) {
        format->setCurrentIndex(format->findData(QLatin1String(extension)));
        const QString name = file(QStringLiteral("told") + QLatin1String(extension));
        QVERIFY2(finish([&] { m_window->exporter().write(ExportKind::Mesh, name, {}); }),
                 qPrintable(m_failure));
        const auto written = readMeshFile(name.toStdString()).points.cols();
        QCOMPARE(facts->text().section(' ', 0, 0).toInt(), static_cast<int>(written));
    }
}

/// The dialog has a check box where the format holds triangles beside tetrahedra, and the file follows it.
void TestSolidExport::borderTrianglesAreAtChoice() {
    m_window->exporter().choices() = {};
    ShapeSession& session = m_window->session();
    const auto shape = std::make_shared<const FrameExport>(session.document(), session.motion().frame(),
                                                           session.motion().track().frames(), 1.0);
    ExportDialog dialog({ExportKind::Mesh, shape}, m_window->exporter().choices(), m_window.get());
    dialog.show();
    auto* format = dialog.findChild<QComboBox*>(QStringLiteral("format"));
    QCOMPARE(format->currentData().toString(), QStringLiteral(".obj"));  // as the bar's surface came
    auto* box = dialog.form().field("--border")->findChild<QCheckBox*>();
    format->setCurrentIndex(format->findData(QStringLiteral(".stl")));
    QVERIFY(!box->isVisible());
    format->setCurrentIndex(format->findData(QStringLiteral(".vtu")));
    QVERIFY(box->isVisible() && !box->isChecked());
    for (const bool asked : {false, true}) {
        if (asked) box->click();
        const QString name = file(asked ? QStringLiteral("with.vtu") : QStringLiteral("without.vtu"));
        const RunOptions options = runOptionsFrom(dialog.form().values());
        QVERIFY2(finish([&] { m_window->exporter().write(ExportKind::Mesh, name, options); }),
                 qPrintable(m_failure));
        const MeshFile written = readMeshFile(name.toStdString());
        QVERIFY(written.tetrahedra.size() > 100);
        QCOMPARE(!written.triangles.empty(), asked);
    }
}

void TestSolidExport::sequenceIsThatOfTheCommandLine() {
    QDir(m_folder->path()).mkdir(QStringLiteral("w"));
    QDir(m_folder->path()).mkdir(QStringLiteral("c"));
    RunOptions four;
    four.outputs.count = 4;
    QVERIFY2(finish([&] {
                 m_window->exporter().write(ExportKind::Frames, file(QStringLiteral("w/f.vtu")), four);
             }),
             qPrintable(m_failure));
    QCOMPARE(
        runCli(m_folder->path(), {"run", "bar.wend", "--quiet", "--frames", "c/f_####.vtu", "--count", "4"})
            .code,
        0);
    for (int i = 0; i < 4; ++i) {
        const QString name = QStringLiteral("f_000%1.vtu").arg(i);
        QVERIFY(bytes("w/" + name).size() > 1000);
        QVERIFY(bytes("w/" + name) == bytes("c/" + name));
    }
    QVERIFY(bytes(QStringLiteral("w/f.pvd")).contains("timestep=\"1\""));
    QCOMPARE(bytes(QStringLiteral("w/f.pvd")), bytes(QStringLiteral("c/f.pvd")));
}

void TestSolidExport::animationIsThatOfTheCommandLine() {
    // A film that lasts as long as the playback.
    const double rate = 4 / (m_window->session().playback().end() * Playback::kSecondsPerUnit);
    RunOptions five;
    five.outputs.count = 5;
    five.outputs.framesPerSecond = rate;
    QVERIFY2(finish([&] {
                 m_window->exporter().write(ExportKind::Frames, file(QStringLiteral("film.glb")), five);
             }),
             qPrintable(m_failure));
    QCOMPARE(runCli(m_folder->path(), {"run", "bar.wend", "--quiet", "--frames", "line.glb", "--count", "5",
                                       "--fps", QString::number(rate, 'g', 17)})
                 .code,
             0);
    const QByteArray film = bytes(QStringLiteral("film.glb"));
    QVERIFY(film.contains("\"targets\"") && film.contains("\"animations\""));
    QVERIFY(film == bytes(QStringLiteral("line.glb")));
}

void TestSolidExport::picturesAreAsChosen() {
    SolidCanvas& canvas = *m_window->solids().canvas();
    PictureChoice choice;
    choice.size = {640, 480};
    for (const char* extension : {"png", "tif", "exr", "webp"}) {
        const QString path = file(QStringLiteral("view.") + QString::fromLatin1(extension));
        writeViewPicture(path, canvas, choice);
        const Image image = readImage(path.toStdString());
        QCOMPARE(QSize(image.width, image.height), choice.size);
        QVERIFY2(image.alpha, extension);
    }
    const QImage clear(file(QStringLiteral("view.png")));
    QCOMPARE(qAlpha(clear.pixel(2, 2)), 0);
    QCOMPARE(qAlpha(clear.pixel(320, 240)), 255);
    writeViewPicture(file(QStringLiteral("view.jpg")), canvas, choice);
    const QImage opaque(file(QStringLiteral("view.jpg")));
    QVERIFY(qGray(opaque.pixel(2, 2)) > 20);  // the view's background, not black
    choice.transparent = false;
    writeViewPicture(file(QStringLiteral("full.png")), canvas, choice);
    QCOMPARE(qAlpha(QImage(file(QStringLiteral("full.png"))).pixel(2, 2)), 255);
    // The skin's material is the visible one.
    const QColor middle = clear.pixelColor(320, 240);
    QVERIFY(middle.blue() > 2 * middle.red());
}

/// Several strips, with the overlays of the view, have no seams.
void TestSolidExport::picturesAreWrittenInStrips() {
    SolidCanvas& canvas = *m_window->solids().canvas();
    PictureChoice choice;
    choice.size = {700, 1300};
    choice.marks = true;
    QVERIFY(writeViewPicture(file(QStringLiteral("strips.png")), canvas, choice));
    const QImage whole = viewPicture(canvas, choice).convertToFormat(QImage::Format_RGBA8888);
    const QImage strips = QImage(file(QStringLiteral("strips.png"))).convertToFormat(QImage::Format_RGBA8888);
    QCOMPARE(strips.size(), choice.size);
    int off = 0;  // smoothed lines may end in another grey where a strip ends
    for (int y = 0; y < 1300; ++y)
        for (int x = 0; x < 700; ++x)
            off += std::abs(qAlpha(strips.pixel(x, y)) - qAlpha(whole.pixel(x, y))) > 8;
    QVERIFY2(off < 20, qPrintable(QString::number(off)));
}

void TestSolidExport::picturesAreCancelled() {
    SolidCanvas& canvas = *m_window->solids().canvas();
    PictureChoice choice;
    choice.size = {3000, 6000};
    QTimer::singleShot(0, [this] {
        if (auto* dialog = m_window->findChild<QProgressDialog*>())
            dialog->findChild<QPushButton*>()->click();
    });
    QVERIFY(!writeViewPicture(file(QStringLiteral("never.png")), canvas, choice));
    QVERIFY(!QFile::exists(file(QStringLiteral("never.png"))));
}

/// The film runs from the start of the motion to its end, each frame equal to an export of the view at that
/// time; then the shown time is restored.
void TestSolidExport::viewIsFilmed() {
    SolidCanvas& canvas = *m_window->solids().canvas();
    Playback& playback = m_window->session().playback();
    playback.setTime(0.3 * playback.end());
    const double before = playback.time();
    PictureChoice choice;
    choice.size = {320, 240};
    choice.marks = true;
    choice.frames = 4;
    choice.framesPerSecond = 10;
    QVERIFY(writeViewPicture(file(QStringLiteral("film.webp")), canvas, choice));
    QCOMPARE(playback.time(), before);
    const WebpFrames film = webpFrames(file(QStringLiteral("film.webp")));
    QCOMPARE(film.pictures.size(), std::size_t(4));
    QVERIFY(seenDifference(film.pictures.front(), film.pictures.back()) > 60);
    choice.frames = 0;
    for (int k = 0; k < 4; ++k) {
        playback.setTime(playback.end() * k / 3);
        QVERIFY(writeViewPicture(file(QStringLiteral("still.png")), canvas, choice));
        const QImage still(file(QStringLiteral("still.png")));
        QCOMPARE(seenDifference(film.pictures[std::size_t(k)], still), 0);
        QCOMPARE(film.ends[std::size_t(k)], 100 * (k + 1));
    }
}

void TestSolidExport::filmIsCancelled() {
    SolidCanvas& canvas = *m_window->solids().canvas();
    Playback& playback = m_window->session().playback();
    playback.setTime(0.6 * playback.end());
    const double before = playback.time();
    PictureChoice choice;
    choice.size = {320, 240};
    choice.frames = 1000;
    QTimer::singleShot(0, [this] {
        if (auto* dialog = m_window->findChild<QProgressDialog*>())
            dialog->findChild<QPushButton*>()->click();
    });
    QVERIFY(!writeViewPicture(file(QStringLiteral("never.webp")), canvas, choice));
    QVERIFY(!QFile::exists(file(QStringLiteral("never.webp"))));
    QCOMPARE(playback.time(), before);
}

void TestSolidExport::filmIsAtChoiceWhereThereIsMotion() {
    PictureDialog still({321, 201}, false, nullptr);
    still.show();
    QCOMPARE(still.findChild<QComboBox*>()->findText(QStringLiteral("Animated WebP")), -1);
    QVERIFY(!still.findChild<QDoubleSpinBox*>()->isVisible());
    QCOMPARE(still.choice().frames, 0);
    QCOMPARE(still.choice().size, QSize(321, 201));
    auto project = copyOf(*m_window->session().document().project());
    project->cycle = {0.5, 1.5};
    project->frameRate = 25;
    PictureDialog dialog({321, 201}, false, nullptr, {}, FilmSubject{project, 2, {}});
    dialog.show();
    auto* format = dialog.findChild<QComboBox*>();
    auto* rate = dialog.findChild<QDoubleSpinBox*>();
    QVERIFY(rate->isVisible());
    QCOMPARE(dialog.extension(), QStringLiteral(".mp4"));
    QVERIFY(!dialog.choice().transparent);
    QCOMPARE(dialog.choice().size, QSize(322, 202));  // even, as the codec asks
    QCOMPARE(dialog.choice().frames, 51);
    rate->setValue(10);
    QCOMPARE(dialog.choice().frames, 21);
    QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("facts"))->text().contains(QStringLiteral("21")));
    format->setCurrentIndex(format->findText(QStringLiteral("Animated WebP")));
    QCOMPARE(dialog.choice().size, QSize(321, 201));
    QVERIFY(dialog.choice().transparent);
    dialog.findChild<OptionField*>(QStringLiteral("--loop"))->findChild<QCheckBox*>()->setChecked(true);
    QCOMPARE(dialog.choice().frames, 10);  // of the cycle, without its end
    QCOMPARE(dialog.choice().span->from, 0.5);
}

/// The box is clear while the format cannot hold transparency, and all choices return in the next dialog.
void TestSolidExport::choicesOfViewsAreRemembered() {
    const FilmSubject film{m_window->session().document().project(), 2, {}};
    PictureDialog dialog({320, 200}, false, nullptr, {}, film);
    const auto boxOf = [](PictureDialog& one) {
        return one.findChild<QCheckBox*>(QStringLiteral("transparent"));
    };
    const auto choose = [](PictureDialog& one, const char* extension) {
        auto* format = one.findChild<QComboBox*>();
        format->setCurrentIndex(format->findData(QString::fromLatin1(extension)));
    };
    choose(dialog, ".mp4");
    QVERIFY(!boxOf(dialog)->isEnabled() && !boxOf(dialog)->isChecked());
    choose(dialog, ".webm");
    QVERIFY(boxOf(dialog)->isEnabled() && boxOf(dialog)->isChecked());
    boxOf(dialog)->setChecked(false);
    dialog.findChildren<QSpinBox*>().front()->setValue(640);
    dialog.findChild<QDoubleSpinBox*>()->setValue(12);
    PictureDialog next({320, 200}, false, nullptr, {}, film);
    next.set(dialog.settings());
    QCOMPARE(next.extension(), QStringLiteral(".webm"));
    QCOMPARE(next.choice().size, QSize(640, 400));
    QCOMPARE(next.choice().framesPerSecond, 12.);
    QVERIFY(!next.choice().transparent);
    choose(dialog, ".mp4");
    next.set(dialog.settings());
    choose(next, ".webm");
    QVERIFY(!next.choice().transparent);  // as chosen before the format that cannot hold it
}

void TestSolidExport::legendAndMarksAreAtChoice() {
    SolidCanvas& canvas = *m_window->solids().canvas();
    PictureChoice choice;
    choice.size = {800, 600};
    const QImage bare = viewPicture(canvas, choice);
    choice.legend = true;
    QVERIFY(viewPicture(canvas, choice) == bare);  // no map, nothing to explain
    m_window->actions().showMap->setChecked(true);
    const QImage legend = viewPicture(canvas, choice);
    // The legend is where the window has it, in the same proportion to the solid: at the lower right, and
    // nowhere else.
    const double scale = 600.0 / canvas.height();
    const QRect card = QRectF(QPointF(800, 600) - scale * QPointF(228, 68), scale * QSizeF(216, 56)).toRect();
    const QPoint inside = card.center();
    QVERIFY(qAlpha(bare.pixel(inside)) == 0 && qAlpha(legend.pixel(inside)) > 200);
    QCOMPARE(qAlpha(legend.pixel(card.topLeft() - QPoint(3, 3))), 0);
    QCOMPARE(qAlpha(legend.pixel(60, 32)), 0);
    choice.legend = false;
    choice.marks = true;
    const QImage marks = viewPicture(canvas, choice);
    QVERIFY(qAlpha(marks.pixel(inside)) == 0 && marks != bare);
    if (qEnvironmentVariableIsSet("WEND_TEST_PICTURES")) {
        choice.size = {1600, 1000};
        choice.transparent = false;
        choice.legend = true;
        viewPicture(canvas, choice).save(qEnvironmentVariable("WEND_TEST_PICTURES") + "/view-picture.png");
    }
    m_window->actions().showMap->setChecked(false);
    PictureDialog dialog({320, 200}, false, nullptr);
    QCOMPARE(dialog.choice().size, QSize(320, 200));
    auto* width = dialog.findChildren<QSpinBox*>().front();
    width->setValue(640);  // the height follows
    QCOMPARE(dialog.choice().size, QSize(640, 400));
    QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("sizeNote"))->text().isEmpty());
    width->setValue(20001);
    QVERIFY(!dialog.findChild<QLabel*>(QStringLiteral("sizeNote"))->text().isEmpty());
    for (const QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons())
        QCOMPARE(button->isEnabled(), button->property("role") != QStringLiteral("primary"));
    QVERIFY(dialog.choice().transparent && !dialog.choice().legend && !dialog.choice().marks);
}

void TestSolidExport::badPlacesAreReported() {
    QVERIFY(!finish(
        [&] { m_window->exporter().write(ExportKind::Mesh, file(QStringLiteral("missing/shape.vtu"))); }));
    QVERIFY(m_failure.contains(QStringLiteral("missing")));
    QVERIFY(
        !finish([&] { m_window->exporter().write(ExportKind::Mesh, file(QStringLiteral("shape.xyz"))); }));
    for (const char* known : {".glb", ".vtu", ".obj"}) QVERIFY(m_failure.contains(QLatin1String(known)));
    QVERIFY(m_failure.contains(QStringLiteral("shape.xyz")));
    PictureChoice choice;
    choice.size = {64, 64};
    SolidCanvas& canvas = *m_window->solids().canvas();
    QVERIFY_THROWS_EXCEPTION(InputError, writeViewPicture(file(QStringLiteral("view.xyz")), canvas, choice));
    QVERIFY(!QFile::exists(file(QStringLiteral("shape.xyz"))));
}

QTEST_MAIN(TestSolidExport)
#include "test_solid_export.moc"
