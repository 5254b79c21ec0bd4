#include <xcb/xcb.h>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTextStream>
#include <QWheelEvent>

#include <array>
#include <cmath>
#include <cstdlib>

#include "app/document/curve_edits.h"
#include "app/document/material_edits.h"
#include "app/document/project.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/energy_slider.h"
#include "app/panels/material_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/surface_panel.h"
#include "app/session/held_border.h"
#include "app/session/opening.h"
#include "app/session/shape_builder.h"
#include "app/tools/measure_tool.h"
#include "app/view/actions.h"
#include "app/view/exporter.h"
#include "app/view/info_banner.h"
#include "app/view/main_window.h"
#include "app/view/pin_actions.h"
#include "app/view/solid_workshop.h"
#include "app/view/toolbox.h"
#include "app/view/volume/solid_canvas.h"
#include "app/view/work_note.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/mesh/mesh_file.h"
#include "tests/support/dialogs.h"
#include "tests/support/surfaces.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The window with a solid, with real mouse and key events.
class TestSolidWindow : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void opensSurfacesAndTetrahedra();
    void windowKeepsItsPlace();
    void clickPinsAndArrowMoves();
    void escapeRestoresAndUndoTakesBack();
    void typedNumbersAreExact();
    void longWorkIsToldAndCancelled();
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
    void badSurfacesAreShownAndRepaired();
    void pictureHasItsSizeAndNoBackground();
    void detailedSurfaceIsShownAndTellsItsNotices();
    void presetsTurnTheView();
    void zoomedViewIsKept();
    void backToAPicture();

  private:
    void open(int vertices = 300);
    SolidCanvas& canvas() { return *m_window->solids().canvas(); }
    ShapeSession& session() { return m_window->session(); }
    QPoint at(const Vec<3>& p) { return canvas().toWidget(p).toPoint(); }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void holdEnds();
    bool saysThatThereIsNoSolid();
    const std::vector<Handle<3>>& handles() { return session().document().design<3>().handles; }
    bool edgesAreAsTheButtonSays();
    bool axesAreSeen();
    int greenPixels();
    void picture(const QString& name);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

/// A bar along x from −2 to 2, as an OBJ file.
QString writeBar(const QTemporaryDir& folder) {
    const Surface bar = box({-2, -0.5, -0.5}, {2, 0.5, 0.5}, 6);
    const QString path = folder.filePath(QStringLiteral("bar.obj"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return {};
    QTextStream out(&file);
    for (Eigen::Index i = 0; i < bar.points.cols(); ++i)
        out << "v " << bar.points(0, i) << ' ' << bar.points(1, i) << ' ' << bar.points(2, i) << '\n';
    for (const auto& t : bar.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    return path;
}

xcb_connection_t* screenServer() {
    return qGuiApp->nativeInterface<QNativeInterface::QX11Application>()->connection();
}

/// As a window manager does it, of which Qt is only told.
void moveFromOutside(const QWidget& window, const QPoint& place) {
    const std::array<int, 2> values = {place.x(), place.y()};
    const auto id = static_cast<xcb_window_t>(window.winId());
    xcb_configure_window(screenServer(), id, XCB_CONFIG_WINDOW_X | XCB_CONFIG_WINDOW_Y, values.data());
    xcb_flush(screenServer());
}

/// Where it really is, whatever Qt believes.
QPoint placeOf(const QWidget& window) {
    const auto request = xcb_get_geometry(screenServer(), static_cast<xcb_window_t>(window.winId()));
    const std::unique_ptr<xcb_get_geometry_reply_t, decltype(&std::free)> reply(
        xcb_get_geometry_reply(screenServer(), request, nullptr), &std::free);
    return reply ? QPoint(reply->x, reply->y) : QPoint(-1, -1);
}

}  // namespace

void TestSolidWindow::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_folder = std::make_unique<QTemporaryDir>();
    isolateSettings(*m_folder);
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1200, 800);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get(), 20000));
}

void TestSolidWindow::cleanup() {
    if (!m_window) return;
    if (!session().document().isEmpty()) session().document().undoStack()->setClean();
    m_window.reset();
}

/// A bar seen from the front, so that x runs to the right and z up.
void TestSolidWindow::open(int vertices) {
    m_window->openPath(writeBar(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !session().document().isEmpty(); }, 20000));
    Project coarse = *session().document().project();
    coarse.domain.vertices = vertices;
    session().document().change(QStringLiteral("Coarse"), coarse);
    QVERIFY(settle(session()));
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get(), 20000));
    m_window->solids().actions().front->trigger();
    canvas().setFocus();
}

void TestSolidWindow::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QTest::mouseMove(&canvas(), from);
    QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&canvas(), from + (to - from) * i / 8);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, to);
}

/// Both ends of the bar by rectangle, all through: two handles.
void TestSolidWindow::holdEnds() {
    m_window->solids().actions().through->setChecked(true);
    m_window->solids().actions().rectangle->trigger();
    for (const double x : {-2.0, 2.0}) {
        const QPoint centre = at({x, 0, 0}), reach(12, at({0, 0, -0.5}).y() - at({0, 0, 0}).y() + 40);
        drag(centre - reach, centre + reach);
    }
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(2));
    m_window->actions().selectTool->trigger();
}

/// For looking at: saved where the variable says.
void TestSolidWindow::picture(const QString& name) {
    if (!qEnvironmentVariableIsSet("WEND_TEST_PICTURES")) return;
    QTest::qWait(300);
    m_window->grab().save(qEnvironmentVariable("WEND_TEST_PICTURES") + '/' + name + ".png");
}

void TestSolidWindow::opensSurfacesAndTetrahedra() {
    open();
    QCOMPARE(session().document().project()->domain.kind, DomainKind::Surface);
    const auto frame = session().frame<3>();
    QVERIFY(frame && frame->pose == frame->rest->points);
    QVERIFY(canvas().isVisible() && !m_window->solids().actions().front->toolTip().isEmpty());
    SimplicialMesh<3> mesh = *frame->rest;
    const QString path = m_folder->filePath(QStringLiteral("bar.vtu"));
    writeMeshFile(path.toStdString(), toMeshFile<3>(mesh));
    m_window->session().document().undoStack()->setClean();
    m_window->openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session().document().project()->domain.kind == DomainKind::Mesh; },
                            20000));
    QVERIFY(settle(session()));
    QCOMPARE(session().frame()->vertices, mesh.vertexCount());
}

/// Where the user has moved it. Qt makes it anew when the first solid comes.
void TestSolidWindow::windowKeepsItsPlace() {
    const QPoint place(61, 73);
    moveFromOutside(*m_window, place);
    QVERIFY(QTest::qWaitFor([&] { return m_window->geometry().topLeft() == place; }, 20000));
    const QSize size = m_window->size();
    open();
    QTest::qWait(200);
    QCOMPARE(placeOf(*m_window), place);
    QCOMPARE(m_window->geometry(), QRect(place, size));
}

void TestSolidWindow::clickPinsAndArrowMoves() {
    open();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({-1.7, -0.5, 0}));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({1.7, -0.5, 0}));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, QPoint(5, 5));  // beside the solid
    QCOMPARE(handles().size(), std::size_t(2));
    QVERIFY(session().selection().isEmpty());
    QVERIFY(settle(session()));
    const Vec<3> pin = session().pins<3>()[1].centre;
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(pin));
    QVERIFY(session().selection().contains(1));
    // The arrow of z stands upright over the pin.
    const QPoint tip = at(pin) - QPoint(0, 60);
    QTest::mouseMove(&canvas(), tip);
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, tip);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&canvas(), tip - QPoint(i, 8 * i));
    QVERIFY(QTest::qWaitFor([&] { return session().frame()->live; }, 20000));
    picture(QStringLiteral("drag"));
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, tip - QPoint(6, 48));
    QVERIFY(settle(session()));
    const Vec<3> moved = session().pins<3>()[1].centre;
    QVERIFY(std::abs(moved.x() - pin.x()) < 1e-9 && std::abs(moved.y() - pin.y()) < 1e-9);
    QVERIFY(std::abs(moved.z() - pin.z() - 48 * canvas().pixelSize(pin)) < 3 * canvas().pixelSize(pin));
    QVERIFY(session().frame()->pinError < 1e-9);
    QVERIFY(session().playback().end() == 1);
}

void TestSolidWindow::escapeRestoresAndUndoTakesBack() {
    open();
    holdEnds();
    const Points<3> before = session().frame<3>()->pose;
    const Vec<3> pin = session().pins<3>()[1].centre;
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(pin));
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(pin));
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&canvas(), at(pin) - QPoint(0, 8 * i));
    QVERIFY(QTest::qWaitFor([&] { return session().frame()->live; }, 20000));
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(pin));
    QVERIFY(settle(session()));
    QVERIFY(session().frame<3>()->pose == before);
    drag(at(pin), at(pin) - QPoint(0, 50));
    QVERIFY(settle(session()));
    QVERIFY(session().frame<3>()->pose != before);
    m_window->actions().undo->trigger();
    QVERIFY(settle(session()));
    QVERIFY(session().frame<3>()->pose == before);
}

void TestSolidWindow::typedNumbersAreExact() {
    open();
    holdEnds();
    session().selection().set({1});
    const Vec<3> pin = session().pins<3>()[1].centre;
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(pin));
    for (const QPoint& wander : {QPoint(9, 9), QPoint(40, -5), QPoint(20, 30), QPoint(9, 9)})
        QTest::mouseMove(&canvas(), at(pin) + wander);
    QTest::keyClicks(&canvas(), QStringLiteral("z0.25"));
    QTest::keyClick(&canvas(), Qt::Key_Return);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(pin) + QPoint(9, 9));
    QVERIFY(settle(session()));
    QVERIFY((session().pins<3>()[1].centre - pin - Vec<3>(0, 0, 0.25)).norm() < 1e-9);
    // Who types a number wants the straight way, not the hand's.
    const auto way = pinPaths<3>(handles()[1], {pin}).front().points;
    for (const Vec<3>& p : way) QVERIFY((p - pin).head<2>().norm() < 1e-9);
}

void TestSolidWindow::longWorkIsToldAndCancelled() {
    m_window->statusBar()->showMessage(QStringLiteral("a button's hint"));
    open();
    QVERIFY(m_window->statusBar()->currentMessage().isEmpty());  // the hint is not drawn over it
    const auto rest = session().frame<3>()->rest;
    for (const bool byKey : {true, false}) {
        Project fine = *session().document().project();
        fine.domain.vertices = 300000;
        session().document().change(QStringLiteral("Fine"), fine);
        QVERIFY(QTest::qWaitFor([&] { return m_window->work().isVisible(); }, 20000));
        QVERIFY(m_window->work().text().contains(QStringLiteral("Meshing")));
        picture(QStringLiteral("work"));
        if (byKey)
            QTest::keyClick(&canvas(), Qt::Key_Escape);
        else
            QTest::mouseClick(m_window->work().cancelButton(), Qt::LeftButton);
        QCOMPARE(session().document().project()->domain.vertices, 300);
        QVERIFY(settle(session()));
        QVERIFY(session().frame<3>()->rest == rest);
        QVERIFY(m_window->work().isHidden());
    }
}

void TestSolidWindow::surfaceIsRefinedByTheSwitch() {
    open(2000);
    QVERIFY(!m_window->banner().text().contains('`'));  // no words of the command line
    for (const QString& line : m_window->banner().text().split('\n'))
        QVERIFY2(!line[0].isLower() && line.endsWith('.'), qPrintable(line));
    QVERIFY(m_window->actions().exportPicture->toolTip().contains(QStringLiteral("view")));
    m_window->tools().setMode(Mode::Mesh);
    auto* refine = m_window->findChild<MeshPanel*>()->findChild<QCheckBox*>();
    QVERIFY(refine && refine->isVisible() && !refine->isChecked());
    refine->click();
    QVERIFY(settle(session()));
    QVERIFY(session().document().project()->domain.refineSurface);
    m_window->actions().undo->trigger();
    QVERIFY(!session().document().project()->domain.refineSurface && !refine->isChecked());
    QVERIFY(settle(session()));
}

void TestSolidWindow::turningTwistsTheBar() {
    open();
    holdEnds();
    session().selection().set({1});
    Grip grip;
    grip.kind = Grip::Kind::Turn;
    grip.centre = session().pins<3>()[1].centre;
    grip.axis = Vec<3>::UnitX();
    session().moveSelected<3>(grip, {M_PI / 2, 0, 0});
    QVERIFY(settle(session()));
    QCOMPARE(session().frame()->distortion->flips, 0);
    // A corner of the turned end has gone a quarter of a circle: y → z.
    const auto frame = session().frame<3>();
    for (const int v : session().verticesOf(1)) {
        const Vec<3> rest = frame->rest->points.col(v);
        QVERIFY((frame->pose.col(v) - Vec<3>(rest.x(), -rest.z(), rest.y())).norm() < 1e-9);
    }
    m_window->actions().showMap->setChecked(true);
    m_window->solids().actions().oblique->trigger();
    m_window->findChild<PinActions*>()->turn->trigger();
    picture(QStringLiteral("twist"));
    grip.kind = Grip::Kind::Grow;
    session().moveSelected<3>(grip, {0.5, 0, 0});
    QVERIFY(settle(session()));
    for (const int v : session().verticesOf(1)) {
        const Vec<3> rest = frame->rest->points.col(v);
        QVERIFY(
            (session().frame<3>()->pose.col(v) - Vec<3>(rest.x(), -1.5 * rest.z(), 1.5 * rest.y())).norm() <
            1e-9);
    }
}

void TestSolidWindow::areasAreOneHandle() {
    open();
    m_window->solids().actions().lasso->trigger();
    const QPoint c = at({1.4, -0.5, 0});
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, c + QPoint(60, 0));
    for (int i = 1; i <= 12; ++i)
        QTest::mouseMove(&canvas(), c + QPoint(int(60 * std::cos(i * 0.5)), int(60 * std::sin(i * 0.5))));
    picture(QStringLiteral("lasso"));
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, c + QPoint(60, 0));
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(1));
    const auto held = session().verticesOf(0);
    QVERIFY(held.size() >= 3);
    for (const int v : held) QVERIFY(session().frame<3>()->pose(1, v) < 0.5 - 1e-9);  // not on the far side
}

void TestSolidWindow::shiftAndControlChangeAnArea() {
    open();
    m_window->solids().actions().brush->trigger();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({1.33, -0.5, 0.17}));
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(1));
    const auto first = session().verticesOf(0);
    QVERIFY(!first.empty());
    QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::ShiftModifier, at({-1.33, -0.5, 0.17}));
    QVERIFY(settle(session()));
    const auto both = session().verticesOf(0);
    QVERIFY(both.size() > first.size());
    QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::ControlModifier, at({-1.33, -0.5, 0.17}));
    QVERIFY(settle(session()));
    QCOMPARE(session().verticesOf(0), first);
    QCOMPARE(handles().size(), std::size_t(1));
}

void TestSolidWindow::throughTakesWhatIsHidden() {
    open();
    const QRectF all = canvas().rect();
    const auto inside = [&](const QPointF& p) { return all.contains(p); };
    const auto visible = canvas().verticesWhere(inside, true),
               through = canvas().verticesWhere(inside, false);
    QCOMPARE(static_cast<int>(through.size()), session().frame()->vertices);
    QVERIFY(visible.size() < through.size() && !visible.empty());
}

void TestSolidWindow::ballsAndBoxesAreRegions() {
    open();
    m_window->solids().actions().ball->trigger();
    drag(at({1.5, -0.5, 0}), at({1.5, -0.5, 0}) + QPoint(60, 0));
    m_window->solids().actions().box->trigger();
    drag(at({-1.5, -0.5, 0}), at({-1.5, -0.5, 0}) + QPoint(60, 0));
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(2));
    QVERIFY(std::holds_alternative<Ball<3>>(std::get<Region<3>>(handles()[0].at)));
    QVERIFY(std::holds_alternative<Box<3>>(std::get<Region<3>>(handles()[1].at)));
    QVERIFY(session().pins<3>()[0].points.size() > 3);
}

void TestSolidWindow::sameShapeAsTheCommandLine() {
    open();
    holdEnds();
    session().selection().set({1});
    drag(at(session().pins<3>()[1].centre), at(session().pins<3>()[1].centre) - QPoint(30, 80));
    QVERIFY(settle(session()));
    const Project& project = *session().document().project();
    const auto shape = std::get<Shape<3>>(loadShape(project, m_folder->path().toStdString()));
    IntegrationOptions options = project.integration;
    options.end = project.end;
    Deformer<3> deformer(shape.rest, shape.material, heldHandles(project, shape), options);
    deformer.advance(project.end);
    QVERIFY(session().frame<3>()->pose == deformer.state().points);
}

void TestSolidWindow::saveAndLoadGiveTheSameShape() {
    open();
    holdEnds();
    session().selection().set({1});
    drag(at(session().pins<3>()[1].centre), at(session().pins<3>()[1].centre) - QPoint(30, 80));
    QVERIFY(settle(session()));
    const Points<3> shape = session().frame<3>()->pose;
    const QString path = m_folder->filePath(QStringLiteral("bar.wend"));
    session().document().save(path);
    MainWindow other;
    other.resize(900, 700);
    other.show();
    other.openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return !other.session().document().isEmpty(); }, 20000));
    QVERIFY(settle(other.session()));
    QVERIFY(other.session().frame<3>()->pose == shape);
}

void TestSolidWindow::cutShowsTheInsideAndMoves() {
    open();
    m_window->solids().actions().oblique->trigger();
    const QImage whole = canvas().grabFramebuffer();
    m_window->solids().actions().cut->trigger();
    QCOMPARE(canvas().cut(), CutKind::Exact);
    const QImage exact = canvas().grabFramebuffer();
    QVERIFY(exact != whole);
    picture(QStringLiteral("cut"));
    const Vec<3> before = canvas().plane().point;
    const QPoint tip = at(before + 60 * canvas().pixelSize(before) * canvas().plane().normal);
    QTest::mouseMove(&canvas(), tip);
    drag(tip, tip + QPoint(25, 8));
    QVERIFY((canvas().plane().point - before).norm() > 1e-3);
    QVERIFY((canvas().plane().point - before).cross(canvas().plane().normal).norm() < 1e-9);
    canvas().setCutKind(CutKind::WholeCells);
    QVERIFY(canvas().grabFramebuffer() != exact);
    m_window->solids().actions().cut->trigger();
    QVERIFY(canvas().grabFramebuffer() == whole);
}

void TestSolidWindow::coloursFollowTheMeasure() {
    open();
    holdEnds();
    session().selection().set({1});
    Grip grip;
    session().moveSelected<3>(grip, {0, 0.3, 0.8});
    QVERIFY(settle(session()));
    const QImage plain = canvas().grabFramebuffer();
    m_window->actions().showMap->setChecked(true);
    const QImage length = canvas().grabFramebuffer();
    QVERIFY(length != plain);
    auto* measure = m_window->distortionPanel().findChild<QComboBox*>();
    QCOMPARE(measure->count(), static_cast<int>(measuresOf(3).size()));
    for (int i = 1; i < measure->count(); ++i) {
        measure->setCurrentIndex(i);
        QVERIFY2(canvas().grabFramebuffer() != plain, qPrintable(measure->itemText(i)));
    }
    m_window->actions().showArrows->setChecked(true);
    session().playback().setTime(0.5);
    QTest::qWait(50);
    picture(QStringLiteral("arrows"));
}

void TestSolidWindow::curvePointsAreDragged() {
    open();
    holdEnds();
    session().selection().set({1});
    session().moveSelected<3>(Grip{}, {0, 0, 0.8});
    QVERIFY(settle(session()));
    const Vec<3> end = session().pins<3>()[1].centre;
    const auto curved = withCurve(session().document().design<3>(), 1, end);
    QVERIFY(curved);
    session().document().changeDesign(QStringLiteral("Curve"), *curved);
    QVERIFY(settle(session()));
    QVERIFY((session().pins<3>()[1].centre - end).norm() < 1e-9);
    // The last point is where the handle ends; beside the manipulator's centre it is the curve's.
    const Vec<3> inner = std::get<CurveMotion<3>>(handles()[1].motions.back().kind).points[2];
    const QPoint from = at(inner);
    drag(from, from + QPoint(40, 0));
    QVERIFY(settle(session()));
    const Vec<3> moved = std::get<CurveMotion<3>>(handles()[1].motions.back().kind).points[2];
    QVERIFY(std::abs((moved - inner).x() - 40 * canvas().pixelSize(inner)) < 2 * canvas().pixelSize(inner));
    QVERIFY((session().pins<3>()[1].centre - end).norm() < 1e-9);
    Design<3> framed = session().document().design<3>();
    auto* curve = lastCurve(framed, 1);
    curve->frame = FrameKind::Minimal;
    curve->twist = 1;
    session().document().changeDesign(QStringLiteral("Twist"), framed);
    QVERIFY(settle(session()));
    QCOMPARE(session().frame()->distortion->flips, 0);
    m_window->solids().actions().oblique->trigger();
    picture(QStringLiteral("curve"));
}

void TestSolidWindow::paintingChangesTheMaterial() {
    open();
    m_window->tools().action(QStringLiteral("paint"))->trigger();
    drag(at({-1, -0.5, 0}), at({1, -0.5, 0}));
    QVERIFY(settle(session()));
    const auto groups = regionGroups(session().document().design<3>());
    QCOMPARE(groups.size(), std::size_t(1));
    QVERIFY(groups[0].count > 1);
    const auto& phi = session().frame<3>()->material->phi;
    QVERIFY(*std::max_element(phi.begin(), phi.end()) > phi::kMetr + 0.1);
    // What is painted is shown as long as the brush is chosen, then what was shown before.
    QVERIFY(m_window->actions().showMap->isChecked());
    QCOMPARE(m_window->distortionPanel().measure(), Measure::Phi);
    picture(QStringLiteral("paint"));
    const auto isDrawn = [this] {
        QImage image(canvas().size(), QImage::Format_RGB32);
        image.fill(Qt::black);
        QPainter painter(&image);
        canvas().tool()->paint(painter);
        painter.end();
        QImage empty = image;
        empty.fill(Qt::black);
        return image != empty;
    };
    QVERIFY(isDrawn());  // the brush, where the pointer is
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&canvas(), &leave);
    QVERIFY(!isDrawn());
    m_window->actions().selectTool->trigger();
    QVERIFY(!m_window->actions().showMap->isChecked());
    QCOMPARE(m_window->distortionPanel().measure(), Measure::Length);
    m_window->actions().undo->trigger();
    QVERIFY(settle(session()));
    QVERIFY(regionGroups(session().document().design<3>()).empty());
}

void TestSolidWindow::measuresLengthAndAngle() {
    open();
    m_window->solids().actions().measure->trigger();
    const auto& tool = *static_cast<MeasureTool<3>*>(canvas().tool());
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({-1.99, -0.5, 0.49}));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({-1.99, -0.5, -0.49}));
    QVERIFY(tool.text().contains(QStringLiteral("length 1,")));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({1.99, -0.5, -0.49}));
    QVERIFY(tool.text().contains(QStringLiteral("angle 90°")));
    picture(QStringLiteral("measure"));
    const QPoint beside(5, 5);
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({-1.99, -0.5, 0.49}));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at({-1.99, -0.5, -0.49}));
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, beside);
    QVERIFY(tool.text().contains(QStringLiteral("length 1,")));  // a missed click loses nothing
}

void TestSolidWindow::badSurfacesAreShownAndRepaired() {
    open();
    session().document().undoStack()->setClean();
    QFile good(m_folder->filePath(QStringLiteral("bar.obj")));
    QVERIFY(good.open(QIODevice::ReadOnly));
    QByteArray text = good.readAll();
    text.truncate(text.lastIndexOf("f "));  // one triangle less: a hole
    QFile bad(m_folder->filePath(QStringLiteral("open.obj")));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(text);
    bad.close();
    m_window->openPath(bad.fileName());
    const auto isOpen = [&] { return session().document().project()->domain.path.ends_with("open.obj"); };
    QVERIFY(QTest::qWaitFor(isOpen, 20000));
    QVERIFY(settle(session()));  // in a cage, which is taken away now
    auto* panel = m_window->findChild<SurfacePanel*>();
    const auto press = [&](const QString& name) {
        for (QPushButton* button : panel->findChildren<QPushButton*>())
            if (button->text() == name) QTest::mouseClick(button, Qt::LeftButton);
    };
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible(); }, 20000));
    QVERIFY(canvas().hasDetail());
    const double before = canvas().camera().pixelSize(canvas().size());
    press(QStringLiteral("Show them"));  // the hole is looked at from near
    picture(QStringLiteral("hole-in-cage"));
    const double near = canvas().camera().pixelSize(canvas().size());
    QVERIFY2(near < 0.8 * before, qPrintable(QString("%1 of %2").arg(near).arg(before)));
    press(QStringLiteral("Show them"));
    QVERIFY(canvas().camera().pixelSize(canvas().size()) > 1.2 * near);
    press(QStringLiteral("Exact surface only"));
    QCOMPARE(session().document().project()->domain.fit, Fit::Exact);
    const auto offersCage = [&] {
        return std::ranges::any_of(panel->findChildren<QPushButton*>(), [](const QPushButton* button) {
            return button->isVisible() && button->text() == QStringLiteral("Fit a cage");
        });
    };
    QVERIFY(QTest::qWaitFor(offersCage, 20000));
    QVERIFY(m_window->banner().isVisible());
    QTest::qWait(100);
    picture(QStringLiteral("bad"));
    QVERIFY(saysThatThereIsNoSolid());
    QPushButton* repair = nullptr;
    for (QPushButton* button : panel->findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("Repair")) repair = button;
    QVERIFY(repair && repair->isEnabled());
    const QImage enabled = repair->grab().toImage();
    repair->setEnabled(false);
    QVERIFY(repair->grab().toImage() != enabled);  // is seen to do nothing
    repair->setEnabled(true);
    QVERIFY(edgesAreAsTheButtonSays());
    QVERIFY(axesAreSeen());
    QVERIFY(panel->findChildren<QLabel*>()[1]->text().contains(QStringLiteral("It would fill holes (1).")));
    QCOMPARE(greenPixels(), 0);
    press(QStringLiteral("See the repair"));
    picture(QStringLiteral("repair-seen"));
    QVERIFY(greenPixels() > 50);  // what would close the hole
    press(QStringLiteral("See the repair"));
    QCOMPARE(greenPixels(), 0);
    QTest::mousePress(&canvas(), Qt::RightButton, {}, QPoint(300, 300));
    QTest::mouseMove(&canvas(), QPoint(340, 280));
    QTest::mouseRelease(&canvas(), Qt::RightButton, {}, QPoint(340, 280));
    const Eigen::Matrix4d view = canvas().camera().view();
    const QString list = m_folder->filePath(QStringLiteral("wrong.txt"));
    nameNextFile(m_window.get(), list);
    press(QStringLiteral("Save list…"));
    QFile saved(list);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("\nopen_edges 3\n"));
    panel->findChild<QSpinBox*>()->setValue(7);
    QTest::mouseClick(repair, Qt::LeftButton);
    QVERIFY(session().document().project()->domain.repair);
    QCOMPARE(session().document().project()->domain.largestHole, 7);
    QVERIFY(settle(session()));
    QVERIFY(QTest::qWaitFor([&] { return !panel->isVisible(); }, 20000));
    QVERIFY(session().frame<3>()->cells > 100);
    QVERIFY(!saysThatThereIsNoSolid());
    const QString told = m_window->banner().text().section('\n', 0, 0);
    QCOMPARE(told, QStringLiteral("The surface was repaired: 1 hole filled."));
    QVERIFY(canvas().camera().view() == view);
    QVERIFY(edgesAreAsTheButtonSays());
    m_window->actions().undo->trigger();
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible(); }, 20000));
    QVERIFY(saysThatThereIsNoSolid());
    QVERIFY(canvas().camera().view() == view);
    QVERIFY(edgesAreAsTheButtonSays());
    session().playback().setTime(0);  // nothing brings the repaired one back
    QVERIFY(saysThatThereIsNoSolid());
    QSignalSpy refusal(&m_window->exporter(), &Exporter::failed);
    m_window->exporter().write(ExportKind::Mesh, m_folder->filePath(QStringLiteral("none.vtu")));
    QVERIFY(refusal.count() == 1 && refusal[0][0].toString().contains(QStringLiteral("no shape")));
    m_window->actions().redo->trigger();
    QVERIFY(settle(session()));
    QVERIFY(!saysThatThereIsNoSolid());
    QVERIFY(canvas().camera().view() == view);
}

int TestSolidWindow::greenPixels() {
    const QImage seen = canvas().grabFramebuffer();
    int count = 0;
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x) {
            const QColor c = seen.pixelColor(x, y);
            count += c.green() > 1.5 * c.red() && c.green() > 1.3 * c.blue() ? 1 : 0;
        }
    return count;
}

/// In the lower left corner, over whatever is shown.
bool TestSolidWindow::axesAreSeen() {
    QImage over(canvas().size(), QImage::Format_ARGB32_Premultiplied);
    over.fill(Qt::transparent);
    QPainter painter(&over);
    canvas().paintOver(painter);
    painter.end();
    return qAlpha(over.pixel(46, over.height() - 46)) > 0;
}

/// They are off, and the button brings them.
bool TestSolidWindow::edgesAreAsTheButtonSays() {
    QAction* button = m_window->actions().showMesh;
    const QImage before = canvas().grabFramebuffer();
    button->trigger();
    const QImage with = canvas().grabFramebuffer();
    button->trigger();
    return !button->isChecked() && with != before && canvas().grabFramebuffer() == before;
}

/// Controls, hints and counts of a solid; false if any speaks of one.
bool TestSolidWindow::saysThatThereIsNoSolid() {
    auto* cut = m_window->findChild<CutPanel*>();
    for (const auto* box : cut->findChildren<QDoubleSpinBox*>())
        if (box->isVisible()) return false;
    if (cut->findChild<QComboBox*>()->isEnabled()) return false;
    for (const auto* label : m_window->statusBar()->findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("Click"))) return false;
    for (const auto* label : m_window->findChild<MeshPanel*>()->findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("tetrahedra"))) return false;
    return !session().frame();
}

void TestSolidWindow::pictureHasItsSizeAndNoBackground() {
    open();
    const QImage image = canvas().picture({1000, 400}, true);
    QCOMPARE(image.size(), QSize(1000, 400));
    QCOMPARE(qAlpha(image.pixel(2, 2)), 0);
    QCOMPARE(qAlpha(image.pixel(500, 200)), 255);
}

/// A red plate lies on the bar; most of it lies outside, which the window says.
void TestSolidWindow::detailedSurfaceIsShownAndTellsItsNotices() {
    writeBar(*m_folder);
    const auto write = [&](const char* name, const QByteArray& text) {
        QFile file(m_folder->filePath(QString::fromLatin1(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    QVERIFY(write("plate.mtl", "newmtl red\nKd 1 0 0\n"));
    QVERIFY(write("plate.obj",
                  "mtllib plate.mtl\nusemtl red\nv -1 -0.4 0.6\nv 1 -0.4 0.6\nv 1 0.4 0.6\nv -1 0.4 0.6\n"
                  "f 1 2 3 4\n"));
    QVERIFY(write("bar.wend",
                  R"({"format": "wend", "version": 1, "domain": {"surface": "bar.obj", "vertices": 300,
                  "detail": "plate.obj"}, "handles": [{"name": "all", "at": {"region": {"box": {"min":
                  [-3, -1, -1], "max": [3, 1, 1]}}}, "motion": [{"kind": "translate", "by": [0, 5, 0], "time":
                  [0, 1]}]}], "time": {"end": 1}})"));
    m_window->openPath(m_folder->filePath(QStringLiteral("bar.wend")));
    QVERIFY(QTest::qWaitFor([&] { return !session().document().isEmpty(); }, 20000));
    QVERIFY(settle(session()));
    QVERIFY(m_window->banner().isVisible() && m_window->banner().text().contains(QStringLiteral("outside")));
    QAction* detail = m_window->solids().actions().detail;
    QVERIFY(detail->isEnabled() && detail->isChecked());
    const auto isRed = [&] {
        const QColor c = canvas().grabFramebuffer().pixelColor(at({0, 5, 0.6}));
        return c.red() > 90 && c.green() < 60;
    };
    // The view is framed on the solid as it is shown: at the end of its motion.
    QVERIFY((canvas().camera().pivot() - Vec<3>(0, 5, 0)).norm() < 0.2);
    m_window->solids().actions().top->trigger();
    QVERIFY(isRed());
    QCOMPARE(canvas().drawnTriangles(), 2);
    detail->trigger();
    QVERIFY(!isRed());
    QVERIFY(canvas().drawnTriangles() > 100);
    detail->trigger();
    m_window->actions().showMap->setChecked(true);  // the colours of the map lie on it
    QVERIFY(!isRed());
    m_window->actions().showMap->setChecked(false);
    m_window->solids().actions().cut->trigger();  // the section is the solid's
    canvas().grabFramebuffer();
    QVERIFY(canvas().drawnTriangles() > 2);
    m_window->actions().closeFile->trigger();
    QVERIFY(session().document().isEmpty() && !m_window->banner().isVisible());
}

void TestSolidWindow::presetsTurnTheView() {
    open();
    const auto turns = [&](Qt::MouseButton button, const QPoint& from) {
        const Vec<3> before = canvas().viewDirection();
        QTest::mousePress(&canvas(), button, {}, from);
        for (int i = 1; i <= 4; ++i) QTest::mouseMove(&canvas(), from + QPoint(10 * i, 0));
        QTest::mouseRelease(&canvas(), button, {}, from + QPoint(40, 0));
        return (canvas().viewDirection() - before).norm() > 0.05;
    };
    // Whatever is under the pointer.
    for (const QPoint& from : {canvas().rect().center(), QPoint(8, 8)}) {
        m_window->solids().actions().wendKeys->trigger();
        QVERIFY(turns(Qt::RightButton, from) && turns(Qt::MiddleButton, from) &&
                !turns(Qt::LeftButton, from));
        m_window->solids().actions().vtkKeys->trigger();
        QVERIFY(turns(Qt::LeftButton, from) && !turns(Qt::MiddleButton, from));
        m_window->solids().actions().blenderKeys->trigger();
        QVERIFY(turns(Qt::MiddleButton, from) && !turns(Qt::RightButton, from));
    }
}

/// Whatever appears beside it.
void TestSolidWindow::zoomedViewIsKept() {
    open();
    const QPointF place(200, 200);
    QWheelEvent wheel(place, canvas().mapToGlobal(place), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas(), &wheel);
    const Eigen::Matrix4d view = canvas().camera().view();
    const int height = canvas().height();
    m_window->resize(1200, 700);
    QVERIFY(QTest::qWaitFor([&] { return canvas().height() != height; }, 20000));
    QVERIFY(canvas().camera().view() == view);
}

void TestSolidWindow::backToAPicture() {
    open();
    session().document().undoStack()->setClean();
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return session().document().dimension() == 2; }, 20000));
    QVERIFY(settle(session()));
    QVERIFY(!canvas().isVisible() && !m_window->solids().actions().cut->isVisible());
    QVERIFY(m_window->actions().actualSize->isEnabled());
}

QTEST_MAIN(TestSolidWindow)
#include "test_solid_window.moc"
