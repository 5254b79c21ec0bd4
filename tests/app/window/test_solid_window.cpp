#include <xcb/xcb.h>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTextStream>
#include <QWheelEvent>

#include <array>
#include <cmath>
#include <cstdlib>

#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/output/frame_export.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/surface_panel.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/edits/material_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/tools/measure_tool.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/exporter.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "app/window/notices/notes.h"
#include "app/window/solid_workshop.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/integration/integration_options.h"
#include "core/mesh/mesh_of_file.h"
#include "core/solver/solver_choice.h"
#include "tests/support/address_limit.h"
#include "tests/support/dialogs.h"
#include "tests/support/projects.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The window with a solid, with real mouse and key events.
class TestSolidWindow : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void opensSurfacesAndTetrahedra();
    void verticesAreThoseThatCellsHave();
    void windowKeepsItsPlace();
    void clickPinsAndArrowMoves();
    void escapeRestoresAndUndoTakesBack();
    void typedNumbersAreExact();
    void longWorkIsReportedAndCancelled();
#ifndef WEND_SANITIZED  // sanitizers take all addresses themselves
    void whereMemoryIsShortLessIsOffered();
#endif
    void surfaceIsRefinedByTheSwitch();
    void turningTwistsTheBar();
    void areasAreOneHandle();
    void shiftAndControlChangeAnArea();
    void throughTakesWhatIsHidden();
    void ballsAndBoxesAreRegions();
    void sameShapeAsTheCommandLine();
    void saveAndLoadGiveTheSameShape();
    void cutShowsTheInsideAndMoves();
    void coloursFollowTheMeasure();
    void curvePointsAreDragged();
    void paintingChangesTheMaterial();
    void measuresLengthAndAngle();
    void pictureHasItsSizeAndNoBackground();
    void presetsTurnTheView();
    void zoomedViewIsKept();
    void backToAPicture();

  private:
    void holdEnds();

    std::unique_ptr<SolidFixture> m_f;
};

namespace {

xcb_connection_t* screenServer() {
    return qGuiApp->nativeInterface<QNativeInterface::QX11Application>()->connection();
}

/// Moves the window as a window manager does, so that Qt only receives an event.
void moveFromOutside(const QWidget& window, const QPoint& place) {
    const std::array<int, 2> values = {place.x(), place.y()};
    const auto id = static_cast<xcb_window_t>(window.winId());
    xcb_configure_window(screenServer(), id, XCB_CONFIG_WINDOW_X | XCB_CONFIG_WINDOW_Y, values.data());
    xcb_flush(screenServer());
}

/// Returns the real place of the window, independently of Qt.
QPoint placeOf(const QWidget& window) {
    const auto request = xcb_get_geometry(screenServer(), static_cast<xcb_window_t>(window.winId()));
    const std::unique_ptr<xcb_get_geometry_reply_t, decltype(&std::free)> reply(
        xcb_get_geometry_reply(screenServer(), request, nullptr), &std::free);
    return reply ? QPoint(reply->x, reply->y) : QPoint(-1, -1);
}

}  // namespace

void TestSolidWindow::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

/// Selects both ends of the bar by rectangle, through the whole depth, as two handles.
void TestSolidWindow::holdEnds() {
    m_f->actions().through->setChecked(true);
    for (const double x : {-2.0, 2.0}) {
        m_f->tool("rectangle")->trigger();
        const QPoint centre = m_f->at({x, 0, 0}),
                     reach(12, m_f->at({0, 0, -0.5}).y() - m_f->at({0, 0, 0}).y() + 40);
        m_f->drag(centre - reach, centre + reach);
    }
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->handles().size(), std::size_t(2));
    m_f->window().actions().selectTool->trigger();
}

void TestSolidWindow::opensSurfacesAndTetrahedra() {
    QVERIFY(m_f->open());
    QCOMPARE(m_f->domain().kind, DomainKind::Surface);
    const auto frame = m_f->session().motion().frame<3>();
    QVERIFY(frame && frame->pose == frame->rest->points);
    QVERIFY(m_f->canvas().isVisible() && !m_f->actions().front->toolTip().isEmpty());
    SimplicialMesh<3> mesh = *frame->rest;
    const QString path = m_f->folder().filePath(QStringLiteral("bar.vtu"));
    writeMesh<3>(path.toStdString(), mesh);
    m_f->window().session().document().undoStack()->setClean();
    m_f->window().openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return m_f->domain().kind == DomainKind::Mesh; }, 20000));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().motion().frame()->vertices, mesh.vertexCount());
}

/// Every triangle of the file has vertices of its own: the panel, the notice and the export count the same
/// vertices.
void TestSolidWindow::verticesAreThoseThatCellsHave() {
    const Surface whole = box({-2, -0.5, -0.5}, {2, 0.5, 0.5}, 8);
    QFile file(m_f->folder().filePath(QStringLiteral("soup.off")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QTextStream out(&file);
    out << "OFF\n" << 3 * whole.triangleCount() << ' ' << whole.triangleCount() << " 0\n";
    for (const auto& t : whole.triangles)
        for (const int v : t)
            out << whole.points(0, v) << ' ' << whole.points(1, v) << ' ' << whole.points(2, v) << '\n';
    for (int t = 0; t < whole.triangleCount(); ++t)
        out << "3 " << 3 * t << ' ' << 3 * t + 1 << ' ' << 3 * t + 2 << '\n';
    out.flush();
    file.close();
    QVERIFY(m_f->openFile(file.fileName()));
    setVertices(m_f->session().document(), 60);  // its surface needs more: that is noticed
    QVERIFY(settle(m_f->session()));
    const auto frame = m_f->session().motion().frame<3>();
    QVERIFY(frame->used < frame->vertices / 2);
    const QString count = QLocale().toString(frame->used);
    const auto labels = m_f->window().findChild<MeshPanel*>()->findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(labels, [&](const QLabel* label) {
        return label->text().startsWith(count + QStringLiteral(" vertices, "));
    }));
    QVERIFY(std::ranges::any_of(frame->built->notices, [&](const std::string& notice) {
        return notice.starts_with("the mesh has " + std::to_string(frame->used) + " vertices, where 60");
    }));
    const FrameExport shape(m_f->session().document(), m_f->session().motion().frame(), {}, 1);
    QCOMPARE(shape.vertexCount(".vtu"), frame->used);
}

/// The window stays where the user has moved it, although Qt recreates it when the first solid is opened.
void TestSolidWindow::windowKeepsItsPlace() {
    const QPoint place(61, 73);
    moveFromOutside(m_f->window(), place);
    QVERIFY(QTest::qWaitFor([&] { return m_f->window().geometry().topLeft() == place; }, 20000));
    const QSize size = m_f->window().size();
    QVERIFY(m_f->open());
    QVERIFY(QTest::qWaitForWindowExposed(&m_f->window(), 20000));
    QCOMPARE(placeOf(m_f->window()), place);
    QCOMPARE(m_f->window().geometry(), QRect(place, size));
}

void TestSolidWindow::clickPinsAndArrowMoves() {
    QVERIFY(m_f->open());
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({-1.7, -0.5, 0}));
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({1.7, -0.5, 0}));
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, QPoint(5, 5));  // beside the solid
    QCOMPARE(m_f->handles().size(), std::size_t(2));
    QVERIFY(m_f->session().selection().isEmpty());
    QVERIFY(settle(m_f->session()));
    const Vec3 pin = m_f->session().gestures().pins()[1].centre;
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(pin));
    QVERIFY(m_f->session().selection().contains(1));
    // The arrow of z is upright over the pin.
    const QPoint tip = m_f->at(pin) - QPoint(0, 60);
    QTest::mouseMove(&m_f->canvas(), tip);
    QTest::mousePress(&m_f->canvas(), Qt::LeftButton, {}, tip);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&m_f->canvas(), tip - QPoint(i, 8 * i));
    QVERIFY(QTest::qWaitFor([&] { return m_f->session().motion().frame()->live; }, 20000));
    m_f->picture(QStringLiteral("drag"));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, tip - QPoint(6, 48));
    QVERIFY(settle(m_f->session()));
    const Vec3 moved = m_f->session().gestures().pins()[1].centre;
    QVERIFY(std::abs(moved.x() - pin.x()) < 1e-9 && std::abs(moved.y() - pin.y()) < 1e-9);
    QVERIFY(std::abs(moved.z() - pin.z() - 48 * m_f->canvas().pixelSize(pin)) <
            3 * m_f->canvas().pixelSize(pin));
    QVERIFY(m_f->session().motion().frame()->pinError < 1e-9);
    QVERIFY(m_f->session().playback().end() == 1);
}

void TestSolidWindow::escapeRestoresAndUndoTakesBack() {
    QVERIFY(m_f->open());
    holdEnds();
    const Points3 before = m_f->session().motion().frame<3>()->pose;
    const Vec3 pin = m_f->session().gestures().pins()[1].centre;
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(pin));
    QTest::mousePress(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(pin));
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&m_f->canvas(), m_f->at(pin) - QPoint(0, 8 * i));
    QVERIFY(QTest::qWaitFor([&] { return m_f->session().motion().frame()->live; }, 20000));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(pin));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().motion().frame<3>()->pose == before);
    m_f->drag(m_f->at(pin), m_f->at(pin) - QPoint(0, 50));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().motion().frame<3>()->pose != before);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().motion().frame<3>()->pose == before);
}

void TestSolidWindow::typedNumbersAreExact() {
    QVERIFY(m_f->open());
    holdEnds();
    m_f->session().selection().set({1});
    const Vec3 pin = m_f->session().gestures().pins()[1].centre;
    QTest::mousePress(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(pin));
    for (const QPoint& wander : {QPoint(9, 9), QPoint(40, -5), QPoint(20, 30), QPoint(9, 9)})
        QTest::mouseMove(&m_f->canvas(), m_f->at(pin) + wander);
    QTest::keyClicks(&m_f->canvas(), QStringLiteral("z0.25"));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Return);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(pin) + QPoint(9, 9));
    QVERIFY(settle(m_f->session()));
    QVERIFY((m_f->session().gestures().pins()[1].centre - pin - Vec3(0, 0, 0.25)).norm() < 1e-9);
    // A typed number gives a straight path, not the drawn one.
    const auto way = pinPaths(m_f->handles()[1], {pin}, 3).front().points;
    for (const Vec3& p : way) QVERIFY((p - pin).head<2>().norm() < 1e-9);
}

void TestSolidWindow::longWorkIsReportedAndCancelled() {
    m_f->window().statusBar()->showMessage(QStringLiteral("a button's hint"));
    QVERIFY(m_f->open());
    QVERIFY(m_f->window().statusBar()->currentMessage().isEmpty());  // the hint is not drawn over it
    const auto rest = m_f->session().motion().frame<3>()->rest;
    for (const bool byKey : {true, false}) {
        setVertices(m_f->session().document(), 300000);
        QVERIFY(QTest::qWaitFor([&] { return m_f->window().work().isVisible(); }, 20000));
        QVERIFY(m_f->window().work().text().contains(QStringLiteral("Meshing")));
        m_f->picture(QStringLiteral("work"));
        if (byKey)
            QTest::keyClick(&m_f->canvas(), Qt::Key_Escape);
        else
            QTest::mouseClick(m_f->window().work().cancelButton(), Qt::LeftButton);
        QCOMPARE(m_f->domain().vertices, 300);
        QVERIFY(settle(m_f->session()));
        QVERIFY(m_f->session().motion().frame<3>()->rest == rest);
        QVERIFY(m_f->window().work().isHidden());
    }
}

#ifndef WEND_SANITIZED
/// The factor of so many vertices takes about 550 MB, and the steps before it less than a third of that.
void TestSolidWindow::whereMemoryIsShortLessIsOffered() {
    QVERIFY(m_f->openProject(3, 16000));
    QVERIFY(settle(m_f->session()));
    Document& document = m_f->session().document();
    test::addPin<3>(document, {-2, 0, 0}, "held");
    test::addPin<3>(document, {2, 0, 0}, "moved");
    QVERIFY(settle(m_f->session()));
    m_f->session().selection().set({1});
    const auto buttons = [this] {
        QStringList texts;
        for (const auto* button : m_f->window().banner().findChildren<QPushButton*>())
            texts << button->text();
        return texts;
    };
    {
        const AddressLimit limit(450);
        m_f->session().gestures().moveAtOnce({}, {0, 0, 0.3});
        QVERIFY(QTest::qWaitFor([&] { return m_f->session().motion().lacksMemory(); }, 60000));
    }
    QVERIFY(m_f->window().banner().text().contains(QStringLiteral("memory")));
    const QStringList offered{QStringLiteral("Use Multigrid"), QStringLiteral("Half as Many Vertices"),
                              QStringLiteral("Undo")};
    QCOMPARE(buttons(), offered);
    for (auto* button : m_f->window().banner().findChildren<QPushButton*>())
        if (button->text() == offered[0]) button->click();
    QVERIFY(settle(m_f->session()));
    QVERIFY(!m_f->session().motion().hasFailed());
    QVERIFY2(!m_f->window().banner().text().contains(QStringLiteral("memory")),
             qPrintable(m_f->window().banner().text()));
    QCOMPARE(settingOf(document, "integration.solver"), static_cast<double>(SolverKind::Multigrid));
}
#endif

void TestSolidWindow::surfaceIsRefinedByTheSwitch() {
    QVERIFY(m_f->open(2000));
    QVERIFY(!m_f->window().banner().text().contains('`'));  // no words of the command line
    for (const QString& line : m_f->window().banner().text().split('\n'))
        QVERIFY2(!line[0].isLower() && line.endsWith('.'), qPrintable(line));
    QVERIFY(m_f->window().actions().exportPicture->toolTip().contains(QStringLiteral("view")));
    m_f->window().tools().setMode(Mode::Mesh);
    auto* refine = m_f->window().findChild<MeshPanel*>()->findChild<QCheckBox*>();
    QVERIFY(refine && refine->isVisible() && !refine->isChecked());
    refine->click();
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->domain().refineSurface);
    m_f->window().actions().undo->trigger();
    QVERIFY(!m_f->domain().refineSurface && !refine->isChecked());
    QVERIFY(settle(m_f->session()));
}

void TestSolidWindow::turningTwistsTheBar() {
    QVERIFY(m_f->open());
    holdEnds();
    m_f->session().selection().set({1});
    Grip grip;
    grip.kind = Grip::Kind::Turn;
    grip.centre = m_f->session().gestures().pins()[1].centre;
    grip.axis = Vec3::UnitX();
    m_f->session().gestures().moveAtOnce(grip, {M_PI / 2, 0, 0});
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().motion().frame()->distortion->flips, 0);
    // A corner of the rotated end has moved a quarter of a circle: y → z.
    const auto frame = m_f->session().motion().frame<3>();
    for (const int v : m_f->session().pins().verticesOf(1)) {
        const Vec3 rest = frame->rest->points.col(v);
        QVERIFY((frame->pose.col(v) - Vec3(rest.x(), -rest.z(), rest.y())).norm() < 1e-9);
    }
    m_f->window().actions().showMap->setChecked(true);
    m_f->actions().oblique->trigger();
    m_f->window().findChild<PinActions*>()->turn->trigger();
    m_f->picture(QStringLiteral("twist"));
    grip.kind = Grip::Kind::Grow;
    m_f->session().gestures().moveAtOnce(grip, {0.5, 0, 0});
    QVERIFY(settle(m_f->session()));
    for (const int v : m_f->session().pins().verticesOf(1)) {
        const Vec3 rest = frame->rest->points.col(v);
        QVERIFY((m_f->session().motion().frame<3>()->pose.col(v) -
                 Vec3(rest.x(), -1.5 * rest.z(), 1.5 * rest.y()))
                    .norm() < 1e-9);
    }
}

void TestSolidWindow::areasAreOneHandle() {
    QVERIFY(m_f->open());
    m_f->tool("lasso")->trigger();
    const QPoint c = m_f->at({1.4, -0.5, 0});
    QTest::mousePress(&m_f->canvas(), Qt::LeftButton, {}, c + QPoint(60, 0));
    for (int i = 1; i <= 12; ++i)
        QTest::mouseMove(&m_f->canvas(),
                         c + QPoint(int(60 * std::cos(i * 0.5)), int(60 * std::sin(i * 0.5))));
    m_f->picture(QStringLiteral("lasso"));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, c + QPoint(60, 0));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->handles().size(), std::size_t(1));
    const auto held = m_f->session().pins().verticesOf(0);
    QVERIFY(held.size() >= 3);
    for (const int v : held)
        QVERIFY(m_f->session().motion().frame<3>()->pose(1, v) < 0.5 - 1e-9);  // not on the far side
}

void TestSolidWindow::shiftAndControlChangeAnArea() {
    QVERIFY(m_f->open());
    m_f->tool("grabBrush")->trigger();
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({1.33, -0.5, 0.17}));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->tool("select")->isChecked());  // to drag it
    m_f->tool("grabBrush")->trigger();
    QCOMPARE(m_f->handles().size(), std::size_t(1));
    const auto first = m_f->session().pins().verticesOf(0);
    QVERIFY(!first.empty());
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, Qt::ShiftModifier, m_f->at({-1.33, -0.5, 0.17}));
    QVERIFY(settle(m_f->session()));
    const auto both = m_f->session().pins().verticesOf(0);
    QVERIFY(both.size() > first.size());
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, Qt::ControlModifier, m_f->at({-1.33, -0.5, 0.17}));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().pins().verticesOf(0), first);
    QCOMPARE(m_f->handles().size(), std::size_t(1));
}

void TestSolidWindow::throughTakesWhatIsHidden() {
    QVERIFY(m_f->open());
    const QRectF all = m_f->canvas().rect();
    const auto inside = [&](const QPointF& p) { return all.contains(p); };
    const auto visible = m_f->canvas().verticesWhere(inside, true),
               through = m_f->canvas().verticesWhere(inside, false);
    QCOMPARE(static_cast<int>(through.size()), m_f->session().motion().frame()->vertices);
    QVERIFY(visible.size() < through.size() && !visible.empty());
}

void TestSolidWindow::ballsAndBoxesAreRegions() {
    QVERIFY(m_f->open());
    m_f->tool("ball")->trigger();
    m_f->drag(m_f->at({1.5, -0.5, 0}), m_f->at({1.5, -0.5, 0}) + QPoint(60, 0));
    m_f->tool("block")->trigger();
    m_f->drag(m_f->at({-1.5, -0.5, 0}), m_f->at({-1.5, -0.5, 0}) + QPoint(60, 0));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->handles().size(), std::size_t(2));
    QVERIFY(std::holds_alternative<Ball<3>>(std::get<Region<3>>(m_f->handles()[0].at)));
    QVERIFY(std::holds_alternative<Box<3>>(std::get<Region<3>>(m_f->handles()[1].at)));
    QVERIFY(m_f->session().gestures().pins()[0].points.size() > 3);
}

void TestSolidWindow::sameShapeAsTheCommandLine() {
    QVERIFY(m_f->open());
    holdEnds();
    m_f->session().selection().set({1});
    m_f->drag(m_f->at(m_f->session().gestures().pins()[1].centre),
              m_f->at(m_f->session().gestures().pins()[1].centre) - QPoint(30, 80));
    QVERIFY(settle(m_f->session()));
    const Project& project = *m_f->session().document().project();
    const auto shape = std::get<Shape<3>>(loadShape(project, m_f->folder().path().toStdString()));
    Deformer<3> deformer(shape.rest, shape.material, heldHandles(project, shape), integrationOf(project));
    deformer.advance(endOf(project));
    QVERIFY(m_f->session().motion().frame<3>()->pose == deformer.state().points);
}

void TestSolidWindow::saveAndLoadGiveTheSameShape() {
    QVERIFY(m_f->open());
    holdEnds();
    m_f->session().selection().set({1});
    m_f->drag(m_f->at(m_f->session().gestures().pins()[1].centre),
              m_f->at(m_f->session().gestures().pins()[1].centre) - QPoint(30, 80));
    QVERIFY(settle(m_f->session()));
    const Points3 shape = m_f->session().motion().frame<3>()->pose;
    const QString path = m_f->folder().filePath(QStringLiteral("bar.wend"));
    m_f->session().document().save(path);
    MainWindow other;
    other.resize(900, 700);
    other.show();
    other.openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return !other.session().document().isEmpty(); }, 20000));
    QVERIFY(settle(other.session()));
    QVERIFY(other.session().motion().frame<3>()->pose == shape);
}

void TestSolidWindow::cutShowsTheInsideAndMoves() {
    QVERIFY(m_f->open());
    m_f->actions().oblique->trigger();
    const QImage whole = m_f->canvas().grabFramebuffer();
    m_f->actions().cut->trigger();
    QCOMPARE(m_f->canvas().solid().cut(), CutKind::Exact);
    const QImage exact = m_f->canvas().grabFramebuffer();
    QVERIFY(exact != whole);
    m_f->picture(QStringLiteral("cut"));
    const Vec3 before = m_f->canvas().solid().plane().point;
    const QPoint tip =
        m_f->at(before + 60 * m_f->canvas().pixelSize(before) * m_f->canvas().solid().plane().normal);
    QTest::mouseMove(&m_f->canvas(), tip);
    m_f->drag(tip, tip + QPoint(25, 8));
    QVERIFY((m_f->canvas().solid().plane().point - before).norm() > 1e-3);
    QVERIFY(
        (m_f->canvas().solid().plane().point - before).cross(m_f->canvas().solid().plane().normal).norm() <
        1e-9);
    m_f->canvas().setCutKind(CutKind::WholeCells);
    QVERIFY(m_f->canvas().grabFramebuffer() != exact);
    m_f->actions().cut->trigger();
    QVERIFY(m_f->canvas().grabFramebuffer() == whole);
}

void TestSolidWindow::coloursFollowTheMeasure() {
    QVERIFY(m_f->open());
    holdEnds();
    const auto painted =
        copyOf(*m_f->session().document().project());  // what is painted nowhere is seen nowhere
    MaterialRegion right;
    right.shape = HalfSpace<3>{Vec3::Zero(), -Vec3::UnitX()};
    right.phi = phi::kAkvf;
    right.stiffness = Stiffness{Vec3::UnitZ(), 30};
    designOf(*painted).material.layers.push_back({"", {right}});
    m_f->session().document().change(QStringLiteral("Paint"), painted);
    m_f->session().selection().set({1});
    Grip grip;
    m_f->session().gestures().moveAtOnce(grip, {0, 0.3, 0.8});
    QVERIFY(settle(m_f->session()));
    const QImage plain = m_f->canvas().grabFramebuffer();
    m_f->window().actions().showMap->setChecked(true);
    const QImage length = m_f->canvas().grabFramebuffer();
    QVERIFY(length != plain);
    auto* measure = m_f->window().distortionPanel().findChild<QComboBox*>();
    QCOMPARE(measure->count(), static_cast<int>(measuresOf(3).size()));
    for (int i = 1; i < measure->count(); ++i) {
        measure->setCurrentIndex(i);
        QVERIFY2(m_f->canvas().grabFramebuffer() != plain, qPrintable(measure->itemText(i)));
    }
    m_f->session().playback().setTime(0.5);
    const QImage without = m_f->canvas().grabFramebuffer();
    m_f->window().actions().showArrows->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(m_f->canvas().grabFramebuffer() != without, 20000);
    m_f->picture(QStringLiteral("arrows"));
}

void TestSolidWindow::curvePointsAreDragged() {
    QVERIFY(m_f->open());
    holdEnds();
    m_f->session().selection().set({1});
    m_f->session().gestures().moveAtOnce(Grip{}, {0, 0, 0.8});
    QVERIFY(settle(m_f->session()));
    const Vec3 end = m_f->session().gestures().pins()[1].centre;
    const auto curved = withCurve(m_f->session().document().design(), 1, end);
    QVERIFY(curved);
    m_f->session().document().changeDesign(QStringLiteral("Curve"), *curved);
    QVERIFY(settle(m_f->session()));
    QVERIFY((m_f->session().gestures().pins()[1].centre - end).norm() < 1e-9);
    // The last point is where the handle ends; beside the manipulator's centre the curve's point is dragged.
    const Vec3 inner = std::get<CurveMotion<3>>(m_f->handles()[1].motions.back().kind).points[2];
    const QPoint from = m_f->at(inner);
    m_f->drag(from, from + QPoint(40, 0));
    QVERIFY(settle(m_f->session()));
    const Vec3 moved = std::get<CurveMotion<3>>(m_f->handles()[1].motions.back().kind).points[2];
    QVERIFY(std::abs((moved - inner).x() - 40 * m_f->canvas().pixelSize(inner)) <
            2 * m_f->canvas().pixelSize(inner));
    QVERIFY((m_f->session().gestures().pins()[1].centre - end).norm() < 1e-9);
    Design framed = m_f->session().document().design();
    auto* curve = lastCurve(framed, 1);
    curve->frame = FrameKind::Minimal;
    curve->twist = 1;
    m_f->session().document().changeDesign(QStringLiteral("Twist"), framed);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().motion().frame()->distortion->flips, 0);
    m_f->actions().oblique->trigger();
    m_f->picture(QStringLiteral("curve"));
}

void TestSolidWindow::paintingChangesTheMaterial() {
    QVERIFY(m_f->open());
    m_f->window().tools().action(QStringLiteral("paint"))->trigger();
    m_f->drag(m_f->at({-1, -0.5, 0}), m_f->at({1, -0.5, 0}));
    QVERIFY(settle(m_f->session()));
    const auto layers = m_f->session().document().design().material.layers;
    QCOMPARE(layers.size(), std::size_t(1));
    QVERIFY(layers[0].regions.size() > 1);
    const auto& phi = m_f->session().motion().frame<3>()->material->phi;
    QVERIFY(*std::max_element(phi.begin(), phi.end()) > phi::kMetr + 0.1);
    // The painted material is shown while the brush is chosen, then the previous map.
    QVERIFY(m_f->window().actions().showMap->isChecked());
    QCOMPARE(m_f->window().distortionPanel().measure(), Measure::Phi);
    m_f->picture(QStringLiteral("paint"));
    const auto isDrawn = [this] {
        QImage image(m_f->canvas().size(), QImage::Format_RGB32);
        image.fill(Qt::black);
        QPainter painter(&image);
        m_f->canvas().viewport().tool()->paint(painter);
        painter.end();
        QImage empty = image;
        empty.fill(Qt::black);
        return image != empty;
    };
    QVERIFY(isDrawn());  // the brush, where the pointer is
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&m_f->canvas(), &leave);
    QVERIFY(!isDrawn());
    m_f->window().actions().selectTool->trigger();
    QVERIFY(!m_f->window().actions().showMap->isChecked());
    QCOMPARE(m_f->window().distortionPanel().measure(), Measure::Length);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().document().design().material.layers.empty());
}

void TestSolidWindow::measuresLengthAndAngle() {
    QVERIFY(m_f->open());
    m_f->tool("measure")->trigger();
    const auto& tool = *static_cast<MeasureTool*>(m_f->canvas().viewport().tool());
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({-1.99, -0.5, 0.49}));
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({-1.99, -0.5, -0.49}));
    QVERIFY(tool.text().contains(QStringLiteral("length 1,")));
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({1.99, -0.5, -0.49}));
    QVERIFY(tool.text().contains(QStringLiteral("angle 90°")));
    m_f->picture(QStringLiteral("measure"));
    const QPoint beside(5, 5);
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({-1.99, -0.5, 0.49}));
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({-1.99, -0.5, -0.49}));
    QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, beside);
    QVERIFY(tool.text().contains(QStringLiteral("length 1,")));  // a missed click loses nothing
}

void TestSolidWindow::pictureHasItsSizeAndNoBackground() {
    QVERIFY(m_f->open());
    const QImage image = m_f->canvas().picture({1000, 400}, true);
    QCOMPARE(image.size(), QSize(1000, 400));
    QCOMPARE(qAlpha(image.pixel(2, 2)), 0);
    QCOMPARE(qAlpha(image.pixel(500, 200)), 255);
}

void TestSolidWindow::presetsTurnTheView() {
    QVERIFY(m_f->open());
    m_f->window().actions().selectTool->trigger();  // a drag sets no pin
    const auto turns = [&](Qt::MouseButton button, const QPoint& from) {
        const Vec3 before = m_f->canvas().viewDirection();
        QTest::mousePress(&m_f->canvas(), button, {}, from);
        for (int i = 1; i <= 4; ++i) QTest::mouseMove(&m_f->canvas(), from + QPoint(10 * i, 0));
        QTest::mouseRelease(&m_f->canvas(), button, {}, from + QPoint(40, 0));
        return (m_f->canvas().viewDirection() - before).norm() > 0.05;
    };
    // The press may be over anything.
    for (const QPoint& from : {m_f->canvas().rect().center(), QPoint(8, 8)}) {
        m_f->actions().wendKeys->trigger();
        QVERIFY(turns(Qt::RightButton, from) && turns(Qt::MiddleButton, from) &&
                !turns(Qt::LeftButton, from));
        m_f->actions().vtkKeys->trigger();
        QVERIFY(turns(Qt::LeftButton, from) && !turns(Qt::MiddleButton, from));
        m_f->actions().blenderKeys->trigger();
        QVERIFY(turns(Qt::MiddleButton, from) && !turns(Qt::RightButton, from));
    }
}

/// The zoom stays when panels appear beside the view.
void TestSolidWindow::zoomedViewIsKept() {
    QVERIFY(m_f->open());
    const QPointF place(200, 200);
    QWheelEvent wheel(place, m_f->canvas().mapToGlobal(place), {}, QPoint(0, 240), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&m_f->canvas(), &wheel);
    const Eigen::Matrix4d view = m_f->canvas().camera().view();
    const int height = m_f->canvas().height();
    m_f->window().resize(1200, 700);
    QVERIFY(QTest::qWaitFor([&] { return m_f->canvas().height() != height; }, 20000));
    QVERIFY(m_f->canvas().camera().view() == view);
}

void TestSolidWindow::backToAPicture() {
    QVERIFY(m_f->open());
    m_f->session().document().undoStack()->setClean();
    m_f->window().openPath(writeCutOut(m_f->folder()));
    QVERIFY(QTest::qWaitFor([&] { return m_f->session().document().dimension() == 2; }, 20000));
    QVERIFY(settle(m_f->session()));
    QVERIFY(!m_f->canvas().isVisible() && !m_f->actions().cut->isVisible());
    QVERIFY(m_f->window().actions().actualSize->isEnabled());
}

QTEST_MAIN(TestSolidWindow)
#include "test_solid_window.moc"
