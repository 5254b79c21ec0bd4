// Gestures of the pin tool, with pictures and solids in one test body: pins set and dragged at once, chosen
// by drawing beside them, widened, and dragged along an axis by a number.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <QStatusBar>
#include <QToolBar>
#include <numbers>

#include "app/project/design.h"
#include "app/tools/pins/pin_tool.h"
#include "app/window/actions/pin_actions.h"
#include "tests/support/bar.h"

using namespace wend;
using namespace wend::test;

class TestPinGestures : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void dragsFromTheBareShapeSetAPin_data() { dimensions(); }
    void dragsFromTheBareShapeSetAPin();
    void cancelledNewPinsAreRemoved_data() { dimensions(); }
    void cancelledNewPinsAreRemoved();
    void otherDragsDrawAnOutline_data() { dimensions(); }
    void otherDragsDrawAnOutline();
    void viewsThatTheLeftButtonTurnsAreTurned();
    void outlinesChoosePins_data();
    void outlinesChoosePins();
    void partsAreGrabbed_data() { outlinesChoosePins_data(); }
    void partsAreGrabbed();
    void pinsAreWidened_data() { dimensions(); }
    void pinsAreWidened();
    void pointsWidenToRotateAndScale_data() { dimensions(); }
    void pointsWidenToRotateAndScale();
    void ringsRotatePoints();
    void pinsHoldTheirAngle();
    void pointsTurnOnFromTheirAngle();
    void axesAndNumbers_data() { dimensions(); }
    void axesAndNumbers();
    void arrowsFollowTheScreen();
    void shiftKeepsItStraight_data() { dimensions(); }
    void shiftKeepsItStraight();
    void otherFilesBeginAnew_data() { dimensions(); }
    void otherFilesBeginAnew();
    void hintsUnderAStillPointerAreUpdated_data() { dimensions(); }
    void hintsUnderAStillPointerAreUpdated();
    void choosingHowToSelectKeepsThePinTool();
    void pointsAreWidenedByANumber_data() { dimensions(); }
    void pointsAreWidenedByANumber();
    void grabbingBrushHasItsSizeBesideItsName_data() { dimensions(); }
    void grabbingBrushHasItsSizeBesideItsName();

  private:
    ShapeSession& session() { return m_f->session(); }
    QUndoStack& undo() { return *session().document().undoStack(); }
    PinActions& pins() { return *m_f->window().findChild<PinActions*>(); }
    template <int Dim>
    QPoint at(double u, double v = 0) {
        return Bar<Dim>::canvas(*m_f).toWidget(Bar<Dim>::place(u, v)).toPoint();
    }
    template <int Dim>
    Vec<Dim> pin(int handle) {
        for (const auto& view : session().gestures().pins(true))
            if (view.handle == handle) return view.centre.head<Dim>();
        return Vec<Dim>::Zero();
    }
    template <int Dim>
    bool open(const std::vector<double>& places);
    void press(const QPoint& at, Qt::KeyboardModifiers modifiers = {});
    void moveBy(const QPoint& from, const QPoint& way, Qt::KeyboardModifiers modifiers = {});
    bool let(const QPoint& at, Qt::KeyboardModifiers modifiers = {});
    bool drag(const QPoint& from, const QPoint& way, Qt::KeyboardModifiers modifiers = {});
    template <int Dim>
    void setAndDrag();
    template <int Dim>
    void giveUp();
    template <int Dim>
    void drawBeside();
    template <int Dim>
    void choose(DrawnOutline::Kind kind);
    template <int Dim>
    void grab(DrawnOutline::Kind kind);
    template <int Dim>
    void widen();
    template <int Dim>
    void widenByGrip();
    double angleAround(int handle, double reach);
    double angleOf(int handle);
    template <int Dim>
    void lock();
    template <int Dim>
    void straight();
    template <int Dim>
    void anew();
    template <int Dim>
    void stillPointer();
    template <int Dim>
    void widenByNumber();
    template <int Dim>
    void sizeBeside();
    template <int Dim>
    Viewport& viewport() {
        return Bar<Dim>::canvas(*m_f).viewport();
    }
    QString hint() {
        for (const auto* label : m_f->window().statusBar()->findChildren<QLabel*>())
            if (label->accessibleName().isEmpty() && !label->toolTip().isEmpty()) return label->toolTip();
        return {};
    }

    std::unique_ptr<SolidFixture> m_f;
};

void TestPinGestures::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

/// The bar with pins along its middle, none selected; the tool sets pins.
template <int Dim>
bool TestPinGestures::open(const std::vector<double>& places) {
    if (!Bar<Dim>::open(*m_f)) return false;
    m_f->tool("pin")->trigger();
    for (const double u : places) {
        press(at<Dim>(u));
        if (!let(at<Dim>(u))) return false;
        session().selection().clear();  // what stands around a pin may lie where the next one goes
    }
    return session().pins().count() == static_cast<int>(places.size());
}

void TestPinGestures::press(const QPoint& at, Qt::KeyboardModifiers modifiers) {
    QTest::mouseMove(&m_f->view(), at);
    QTest::mousePress(&m_f->view(), Qt::LeftButton, modifiers, at);
}

void TestPinGestures::moveBy(const QPoint& from, const QPoint& way, Qt::KeyboardModifiers modifiers) {
    QWidget& view = m_f->view();
    for (int i = 1; i <= 6; ++i) {
        const QPoint to = from + way * i / 6;
        QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QCoreApplication::sendEvent(&view, &move);
    }
}

bool TestPinGestures::let(const QPoint& at, Qt::KeyboardModifiers modifiers) {
    QTest::mouseRelease(&m_f->view(), Qt::LeftButton, modifiers, at);
    return settle(session());
}

bool TestPinGestures::drag(const QPoint& from, const QPoint& way, Qt::KeyboardModifiers modifiers) {
    press(from, modifiers);
    moveBy(from, way, modifiers);
    return let(from + way, modifiers);
}

void TestPinGestures::dragsFromTheBareShapeSetAPin() {
    BOTH(setAndDrag);
}

/// The gesture is one step with a name: undo removes it completely, redo restores the bent shape.
template <int Dim>
void TestPinGestures::setAndDrag() {
    QVERIFY(open<Dim>({-1.5}));
    const int steps = undo().count();
    const Points<Dim> before = session().motion().frame<Dim>()->pose;
    const QPoint from = at<Dim>(1.5), way(-20, -60);
    press(from);
    moveBy(from, way);
    QCOMPARE(session().pins().count(), 2);
    QVERIFY(session().motion().isDragging());
    QVERIFY(QTest::qWaitFor([&] { return session().motion().frame()->live; }, 20000));
    QVERIFY(let(from + way));
    QCOMPARE(undo().count(), steps + 1);
    QCOMPARE(undo().undoText(), QStringLiteral("Add Pin 2"));
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    const auto& canvas = Bar<Dim>::canvas(*m_f);
    // The pin is at the pointer.
    const QPointF now = canvas.toWidget(pin<Dim>(1)), hand = from + way;
    QVERIFY2(QLineF(now, hand).length() < 2, qPrintable(QString::number(QLineF(now, hand).length())));
    const Points<Dim> bent = session().motion().frame<Dim>()->pose;
    QVERIFY((bent - before).colwise().norm().maxCoeff() > 20 * canvas.pixelSize(inSpace(pin<Dim>(1))));
    undo().undo();
    QVERIFY(settle(session()));
    QCOMPARE(session().pins().count(), 1);
    QVERIFY(session().motion().frame<Dim>()->pose == before);
    undo().redo();
    QVERIFY(settle(session()));
    QCOMPARE(session().pins().count(), 2);
    QVERIFY(session().motion().frame<Dim>()->pose == bent);
    // The next one is another step.
    QVERIFY(drag(at<Dim>(0), {0, 40}));
    QCOMPARE(session().pins().count(), 3);
    QCOMPARE(undo().count(), steps + 2);
}

void TestPinGestures::cancelledNewPinsAreRemoved() {
    BOTH(giveUp);
}

template <int Dim>
void TestPinGestures::giveUp() {
    QVERIFY(open<Dim>({-1.5}));
    const int steps = undo().count();
    const auto before = session().document().project();
    press(at<Dim>(1));
    moveBy(at<Dim>(1), {0, -50});
    QCOMPARE(session().pins().count(), 2);
    QTest::keyClick(&m_f->view(), Qt::Key_Escape);
    QCOMPARE(session().pins().count(), 1);
    QVERIFY(let(at<Dim>(1) + QPoint(0, -50)));
    QCOMPARE(undo().count(), steps);
    QVERIFY(!undo().canRedo());
    QVERIFY(session().document().project() == before);
    // When another file is opened in the middle of a gesture, only the new file's steps are undone.
    press(at<Dim>(1));
    moveBy(at<Dim>(1), {0, -50});
    undo().setClean();  // nothing is asked
    QVERIFY(m_f->openProject(Dim, 300));
    const int own = undo().count();
    let(at<Dim>(1));
    QTest::keyClick(&m_f->view(), Qt::Key_Escape);
    QCOMPARE(undo().count(), own);
}

void TestPinGestures::otherDragsDrawAnOutline() {
    BOTH(drawBeside);
}

/// With Shift, with the selection tool, or beside the shape a press sets no pin.
template <int Dim>
void TestPinGestures::drawBeside() {
    QVERIFY(open<Dim>({-1.5, 1.5}));
    const QPoint over = at<Dim>(1, 0.3), way = at<Dim>(1.8, -0.3) - over;
    QVERIFY(drag(over, way, Qt::ShiftModifier));
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    session().selection().clear();
    const QPoint beside = at<Dim>(-2.3, 0.8), through = at<Dim>(-1, -0.3) - beside;
    QVERIFY(drag(beside, through));
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    session().selection().clear();
    m_f->tool("select")->trigger();
    QVERIFY(drag(over, way));
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QCOMPARE(session().pins().count(), 2);
}

/// The tool still gets clicks.
void TestPinGestures::viewsThatTheLeftButtonTurnsAreTurned() {
    QVERIFY(open<3>({}));
    m_f->actions().vtkKeys->trigger();
    const Vec3 before = m_f->canvas().viewDirection();
    QVERIFY(drag(at<3>(0), {50, 0}));
    QCOMPARE(session().pins().count(), 0);
    QVERIFY((m_f->canvas().viewDirection() - before).norm() > 0.05);
    press(at<3>(0));
    QVERIFY(let(at<3>(0)));
    QCOMPARE(session().pins().count(), 1);
    m_f->actions().wendKeys->trigger();
}

void TestPinGestures::outlinesChoosePins_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<DrawnOutline::Kind>("kind");
    using enum DrawnOutline::Kind;
    for (const auto& [name, kind] : {std::pair{"rectangle", Rectangle}, {"lasso", Lasso}, {"brush", Brush}})
        for (const int dimension : {2, 3}) QTest::addRow("%s %d", name, dimension) << dimension << kind;
}

void TestPinGestures::outlinesChoosePins() {
    QFETCH(DrawnOutline::Kind, kind);
    QFETCH(int, dimension);
    dimension == 2 ? choose<2>(kind) : choose<3>(kind);
}

/// The stroke passes around the middle pin along two sides: a lasso and a brush leave out pins that only
/// their bounding box contains.
template <int Dim>
void TestPinGestures::choose(DrawnOutline::Kind kind) {
    using enum DrawnOutline::Kind;
    QVERIFY(open<Dim>({-0.5, 0.0, 0.5}));
    QAction* action = kind == Rectangle ? pins().selectRectangle
                      : kind == Lasso   ? pins().selectLasso
                                        : pins().selectBrush;
    QVERIFY(action->isVisible() && action->isEnabled());
    m_f->tool("select")->trigger();  // beside a pin the other one would set more
    action->trigger();
    // The stroke starts at the left pin's upper side, follows the upper edge to the right pin, and descends
    // to it.
    const QList<QPoint> way = {at<Dim>(-0.5, 0.45), at<Dim>(0.5, 0.45), at<Dim>(0.5, -0.05)};
    press(way[0]);
    moveBy(way[0], way[1] - way[0]);
    moveBy(way[1], way[2] - way[1]);
    QVERIFY(let(way[2]));
    QCOMPARE(session().selection().contains(1), kind == Rectangle);
    if (kind == Brush) QCOMPARE(session().selection().handles(), std::vector<int>{2});
    QCOMPARE(session().pins().count(), 3);
}

void TestPinGestures::partsAreGrabbed() {
    QFETCH(DrawnOutline::Kind, kind);
    QFETCH(int, dimension);
    dimension == 2 ? grab<2>(kind) : grab<3>(kind);
}

/// A drawn area is one handle, ready to be dragged; Shift adds to it and Ctrl removes from it. An area
/// without any of the shape gives a message and changes nothing.
template <int Dim>
void TestPinGestures::grab(DrawnOutline::Kind kind) {
    using enum DrawnOutline::Kind;
    QVERIFY(open<Dim>({-1.5}));
    const QPoint reach = Dim == 2 ? QPoint(30, 20) : QPoint(110, 90), along(reach.x(), 0);
    const auto draw = [&](const QPoint& middle, Qt::KeyboardModifiers with = {}) {
        m_f->tool(kind == Rectangle ? "rectangle" : kind == Lasso ? "lasso" : "grabBrush")->trigger();
        const QPoint across(reach.x(), -reach.y());
        QList<QPoint> way = {middle - reach, middle + across, middle + reach, middle - across};
        if (kind == Rectangle) way = {middle - reach, middle + reach};
        press(way[0], with);
        for (int i = 1; i < way.size(); ++i) moveBy(way[i - 1], way[i] - way[i - 1], with);
        return let(way.last(), with);
    };
    const QPoint middle = at<Dim>(0.2);
    const auto held = [this] {
        std::size_t count = 0;
        for (const auto& view : session().gestures().pins())
            if (view.handle == 1) count = view.points.size();
        return count;
    };
    QVERIFY(draw(middle));
    QCOMPARE(session().pins().count(), 2);
    QVERIFY(m_f->tool("select")->isChecked());
    QCOMPARE(hint(), viewport<Dim>().tool()->hint());  // no longer that of what has drawn
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    const std::size_t first = held();
    QVERIFY(first >= 3);
    QVERIFY(draw(middle + along, Qt::ShiftModifier));
    QVERIFY(held() > first);
    QVERIFY(draw(middle + along, Qt::ControlModifier));
    QVERIFY(held() < first);
    QCOMPARE(session().pins().count(), 2);
    const int steps = undo().count();
    QVERIFY(draw(at<Dim>(0.2, 1.7)));
    QCOMPARE(undo().count(), steps);
    QVERIFY(m_f->window().statusBar()->currentMessage().contains(QStringLiteral("No part of the shape")));
    const Vec<Dim> before = pin<Dim>(1);
    m_f->tool("select")->trigger();
    QVERIFY(drag(Bar<Dim>::canvas(*m_f).toWidget(before).toPoint(), {0, -30}));
    QVERIFY((pin<Dim>(1) - before).norm() > 10 * Bar<Dim>::canvas(*m_f).pixelSize(inSpace(before)));
}

void TestPinGestures::pinsAreWidened() {
    BOTH(widen);
}

/// The pin becomes a circle or a ball that reaches to the pointer.
template <int Dim>
void TestPinGestures::widen() {
    QVERIFY(open<Dim>({-1.5, 0.0}));
    const int steps = undo().count();
    const auto& canvas = Bar<Dim>::canvas(*m_f);
    const QPoint from = canvas.toWidget(pin<Dim>(1)).toPoint();
    const Vec<Dim> middle = pin<Dim>(1);
    QVERIFY(drag(from, {70, 0}, Qt::ControlModifier | Qt::ShiftModifier));
    QCOMPARE(undo().count(), steps + 1);
    const auto* region = std::get_if<Region<3>>(&session().document().design().handles[1].at);
    const auto* ball = region ? std::get_if<Ball<3>>(region) : nullptr;
    QVERIFY(ball);
    const double pixel = canvas.pixelSize(inSpace(middle));
    QVERIFY2(std::abs(ball->radius - 70 * pixel) < 2 * pixel,
             qPrintable(QString::number(ball->radius / pixel)));
    QVERIFY((ball->centre - inSpace(middle)).norm() < 1e-9 * session().motion().frame()->diagonal);
    // A wide pin rotates.
    QVERIFY(session().gestures().pins()[1].points.size() > 1);
    undo().undo();
    QVERIFY(drag(from, {4, 0}, Qt::AltModifier));  // nothing lies so near
    QCOMPARE(undo().count(), steps + 1);
    QVERIFY(m_f->window().statusBar()->currentMessage().contains(QStringLiteral("smaller than the mesh")));
}

void TestPinGestures::pointsWidenToRotateAndScale() {
    BOTH(widenByGrip);
}

/// A point becomes a disc or a ball in the same step as the drag that rotates or scales it.
template <int Dim>
void TestPinGestures::widenByGrip() {
    QVERIFY(open<Dim>({-1.5, 0.0}));
    const auto place = [this] { return session().document().design().handles[1].at; };
    for (QAction* grip : {pins().turn, pins().grow}) {
        session().selection().set({1});
        const int steps = undo().index();
        grip->trigger();
        // In the plane the drag may begin anywhere; in space it starts on a ring of the manipulator, the
        // widest of which is across the screen.
        const QPoint middle = Bar<Dim>::canvas(*m_f).toWidget(pin<Dim>(1)).toPoint();
        const int radius = grip == pins().turn ? 86 : 68;
        QVERIFY(drag(middle + QPoint(0, -radius), {40, 20}));
        QCOMPARE(undo().index(), steps + 1);
        const Placement<3> wide = place();
        QVERIFY(std::holds_alternative<Region<3>>(wide));
        QVERIFY(session().gestures().pins()[1].points.size() > std::size_t{Dim});
        undo().undo();
        QVERIFY(settle(session()));
        const Placement<3> point = place();
        QVERIFY(std::holds_alternative<std::vector<Vec3>>(point));
    }
    pins().move->trigger();
}

/// Returns the angle of the rotation that fits the points best: atan2(Σ x × y, Σ x · y) of their places at
/// rest and now, from their means.
double fittedAngle(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
    const Vec3 rest = meanOf(before), now = meanOf(after);
    double cross = 0, dot = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec3 x = before[i] - rest, y = after[i] - now;
        cross += x.x() * y.y() - x.y() * y.x(), dot += x.dot(y);
    }
    return std::atan2(cross, dot);
}

/// Returns the angle of the shape around a pin.
double TestPinGestures::angleAround(int handle, double reach) {
    const auto frame = session().motion().frame<2>();
    std::vector<Vec3> before, after;
    for (int v = 0; v < frame->rest->vertexCount(); ++v) {
        if ((frame->pose.col(v) - pin<2>(handle)).norm() >= reach) continue;
        before.push_back(frame->restVertex(v));
        after.push_back(frame->vertex(v));
    }
    return fittedAngle(before, after);
}

/// Returns the angle of the points that a pin holds.
double TestPinGestures::angleOf(int handle) {
    const PinView view = session().gestures().pins()[static_cast<std::size_t>(handle)];
    std::vector<Vec3> before;
    for (const Place& place : view.places) before.push_back(session().motion().frame()->restAt(place));
    return fittedAngle(before, view.points);
}

/// A drag of a point's dotted ring by a quarter rotates its whole disc by exactly that.
void TestPinGestures::ringsRotatePoints() {
    QVERIFY(open<2>({-1.5, 0.0}));
    session().selection().set({1});
    const QPoint middle = Bar<2>::canvas(*m_f).toWidget(pin<2>(1)).toPoint();
    press(middle + QPoint(44, 0));
    for (int k = 1; k <= 9; ++k) {
        const double angle = k * std::numbers::pi / 18;
        moveBy(middle + QPoint(qRound(44 * std::cos(angle)), qRound(44 * std::sin(angle))), {});
    }
    QVERIFY(let(middle + QPoint(0, 44)));
    const auto& ball = std::get<Ball<3>>(std::get<Region<3>>(session().document().design().handles[1].at));
    const double shown =
        Bar<2>::canvas(*m_f).toShape(QPointF(0, 1)).y() - Bar<2>::canvas(*m_f).toShape(QPointF(0, 0)).y();
    const double angle = angleOf(1);
    QVERIFY2(std::abs(angle - std::copysign(std::numbers::pi / 2, shown)) < 0.03,
             qPrintable(QString::number(angle)));
    QVERIFY((pin<2>(1) - inPlane(ball.centre)).norm() < 0.5 * ball.radius);  // the mean of its vertices
}

/// The disc has the angle of the bent shape at the point; without the disc the pin is a point again.
void TestPinGestures::pinsHoldTheirAngle() {
    QVERIFY(open<2>({-1.5, 0.0, 1.5}));
    const QPoint end = Bar<2>::canvas(*m_f).toWidget(pin<2>(2)).toPoint();
    QVERIFY(drag(end, {-30, 90}));
    session().selection().set({1});
    auto* check = m_f->window().findChild<QCheckBox*>(QStringLiteral("holdsAngle"));
    QVERIFY(check && check->isVisible() && !check->isChecked());
    const double reach = 0.15 * Bar<2>::kUnit, before = angleAround(1, reach);
    QVERIFY(std::abs(before) > 0.1);
    const int steps = undo().count();
    QTest::mouseClick(check, Qt::LeftButton, {}, QPoint(8, check->height() / 2));
    QVERIFY(settle(session()));
    QCOMPARE(undo().count(), steps + 1);
    QVERIFY(check->isChecked());
    const double after = angleAround(1, reach);
    QVERIFY2(std::abs(after - before) < 0.1, qPrintable(QString("%1 %2").arg(before).arg(after)));
    const double held = angleOf(1);
    QVERIFY2(std::abs(held - before) < 0.1, qPrintable(QString("%1 %2").arg(before).arg(held)));
    // The end moves on, and the disc does not rotate with it.
    session().selection().set({2});
    const QPoint next = Bar<2>::canvas(*m_f).toWidget(pin<2>(2)).toPoint();
    QVERIFY(drag(next, {-60, 40}));
    QVERIFY(std::abs(angleOf(1) - held) < 1e-3);
    session().selection().set({1});
    QTest::mouseClick(check, Qt::LeftButton, {}, QPoint(8, check->height() / 2));
    QVERIFY(!check->isChecked());
    QVERIFY(std::holds_alternative<std::vector<Vec3>>(session().document().design().handles[1].at));
}

/// While the ring of a point is dragged the preview already has the rotation of the motion: its angle there
/// is not added again.
void TestPinGestures::pointsTurnOnFromTheirAngle() {
    QVERIFY(open<2>({-1.5, 0.0, 1.5}));
    QVERIFY(drag(Bar<2>::canvas(*m_f).toWidget(pin<2>(2)).toPoint(), {-30, 90}));
    session().selection().set({1});
    const double reach = 0.15 * Bar<2>::kUnit, before = angleAround(1, reach);
    QVERIFY(std::abs(before) > 0.1);
    const QPoint middle = Bar<2>::canvas(*m_f).toWidget(pin<2>(1)).toPoint();
    press(middle + QPoint(44, 0));
    QPoint at;
    for (int k = 1; k <= 4; ++k) {
        at = middle + QPoint(qRound(44 * std::cos(0.02 * k)), qRound(44 * std::sin(0.02 * k)));
        moveBy(at, {});
    }
    QTRY_VERIFY(session().motion().frame() && session().motion().frame()->live &&
                session().motion().frame()->sample >= 4);
    const double live = angleAround(1, reach);
    QVERIFY(let(at));
    const double after = angleAround(1, reach);
    QVERIFY(!session().motion().frame()->live);
    QVERIFY2(std::abs(live - after) < 0.5 * std::abs(before),
             qPrintable(QString("%1 %2 %3").arg(before).arg(live).arg(after)));
}

void TestPinGestures::axesAndNumbers() {
    BOTH(lock);
}

/// X restricts a drag to that axis, a number gives the distance; Y and Z do the same.
template <int Dim>
void TestPinGestures::lock() {
    QVERIFY(open<Dim>({-1.5, 1.5}));
    m_f->tool("select")->trigger();
    for (const int axis : {0, Dim - 1}) {
        const Vec<Dim> before = pin<Dim>(1);
        const QPoint from = Bar<Dim>::canvas(*m_f).toWidget(before).toPoint();
        const double wanted = 0.25 * Bar<Dim>::kUnit;
        press(from);
        moveBy(from, {-30, 25});
        QTest::keyClick(&m_f->view(), axis == 0 ? Qt::Key_X : Dim == 2 ? Qt::Key_Y : Qt::Key_Z);
        moveBy(from, {-33, 22});
        const Vec<Dim> now = pin<Dim>(1) - before;
        QVERIFY(std::abs(now[axis]) > 1e-3 * session().motion().frame()->diagonal);
        QVERIFY((now - now[axis] * Vec<Dim>::Unit(axis)).norm() <
                1e-9 * session().motion().frame()->diagonal);
        QTest::keyClicks(&m_f->view(), QString::number(wanted));
        QTest::keyClick(&m_f->view(), Qt::Key_Return);
        let(from);
        QVERIFY(settle(session()));
        const double error = (pin<Dim>(1) - before - wanted * Vec<Dim>::Unit(axis)).norm();
        QVERIFY2(error < 1e-3 * session().motion().frame()->diagonal, qPrintable(QString::number(error)));
    }
}

/// The arrows follow the screen both for a mesh from a file, whose y points up, and for a picture, whose y
/// points down.
void TestPinGestures::arrowsFollowTheScreen() {
    const QString path = m_f->folder().filePath(QStringLiteral("square.obj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    file.close();
    QVERIFY(m_f->openFile(path));
    QCOMPARE(session().document().dimension(), 2);
    QCOMPARE(session().addPin(Vec3(0.5, 0.5, 0)), 0);
    QCOMPARE(session().addPin(Vec3(0.1, 0.1, 0)), 1);
    m_f->tool("select")->trigger();
    QVERIFY(settle(session()));
    const QPointF before = m_f->window().canvas().toWidget(pin<2>(1));
    const Vec2 place = pin<2>(1);
    QTest::keyClick(&m_f->view(), Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(settle(session()));
    QVERIFY(m_f->window().canvas().toWidget(pin<2>(1)).y() < before.y() - 0.1);
    QVERIFY((pin<2>(1) - place - Vec2(0, 10 * session().motion().pixel())).norm() < 1e-9);
}

/// The drag follows the nearest of eight directions of the screen, also if the key is held from the start,
/// which releases nothing.
template <int Dim>
void TestPinGestures::straight() {
    QVERIFY(open<Dim>({0.2, 0.8}));
    press(at<Dim>(0.8));
    QVERIFY(let(at<Dim>(0.8)));
    QVERIFY(session().selection().contains(1));
    const auto wayBy = [&](const QPoint& way) {
        const QPointF before = Bar<Dim>::canvas(*m_f).toWidget(pin<Dim>(1));
        if (!drag(before.toPoint(), way, Qt::ShiftModifier)) return QPointF(1e9, 1e9);
        return Bar<Dim>::canvas(*m_f).toWidget(pin<Dim>(1)) - before;
    };
    for (const auto& [way, expected] : {std::pair{QPoint(30, 8), QPointF(30, 0)},
                                        {QPoint(-7, 28), QPointF(0, 28)},
                                        {QPoint(-24, -20), QPointF(-22, -22)}}) {
        const QPointF went = wayBy(way);
        QVERIFY2(QLineF(went, expected).length() < 1.5,
                 qPrintable(QString("%1 %2").arg(went.x()).arg(went.y())));
        QVERIFY(session().selection().contains(1));
    }
    const QPoint there = Bar<Dim>::canvas(*m_f).toWidget(pin<Dim>(1)).toPoint();
    press(there, Qt::ShiftModifier);
    QVERIFY(let(there, Qt::ShiftModifier));
    QVERIFY(!session().selection().contains(1));  // a click alone
}

void TestPinGestures::shiftKeepsItStraight() {
    BOTH(straight);
}

/// The hint has the modifiers of a drag, and nothing under the pointer from the previous file.
template <int Dim>
void TestPinGestures::anew() {
    QVERIFY(open<Dim>({0.2, 0.8}));
    QTest::mouseMove(&m_f->view(), at<Dim>(0.2));
    QCOMPARE(viewport<Dim>().hovered(), 0);
    QVERIFY2(hint().startsWith(QStringLiteral("Drag to move the pin")), qPrintable(hint()));
    pins().turn->trigger();
    undo().setClean();
    QVERIFY(m_f->openProject(Dim, 300));
    QCOMPARE(viewport<Dim>().hovered(), -1);
    QVERIFY(pins().move->isChecked());
    QVERIFY2(hint().startsWith(QStringLiteral("Click")), qPrintable(hint()));
}

void TestPinGestures::otherFilesBeginAnew() {
    BOTH(anew);
}

/// A pin is undone under the pointer, and one is restored.
template <int Dim>
void TestPinGestures::stillPointer() {
    QVERIFY(open<Dim>({0.2, 0.8}));
    QTest::mouseMove(&m_f->view(), at<Dim>(0.8));
    QCOMPARE(viewport<Dim>().hovered(), 1);
    undo().undo();
    QVERIFY(settle(session()));
    QCOMPARE(viewport<Dim>().hovered(), -1);
    QVERIFY2(hint().startsWith(QStringLiteral("Click")), qPrintable(hint()));
    undo().redo();
    QVERIFY(settle(session()));
    QCOMPARE(viewport<Dim>().hovered(), 1);
    QVERIFY2(hint().startsWith(QStringLiteral("Drag to move the pin")), qPrintable(hint()));
}

void TestPinGestures::hintsUnderAStillPointerAreUpdated() {
    BOTH(stillPointer);
}

void TestPinGestures::pointsAreWidenedByANumber() {
    BOTH(widenByNumber);
}

/// A point has a radius of 0; a radius that is too small is refused with a message. 0 makes a point of a
/// circle or a ball.
template <int Dim>
void TestPinGestures::widenByNumber() {
    QVERIFY(open<Dim>({0.2, 0.8}));
    session().selection().set({1});
    QVERIFY(settle(session()));
    auto* radius = m_f->window().template findChild<QDoubleSpinBox*>(QStringLiteral("circleRadius"));
    QVERIFY(radius->isVisible());
    QCOMPARE(radius->value(), 0.0);
    const int before = undo().count();
    const auto type = [radius](double number) {
        radius->setFocus();
        radius->selectAll();
        QTest::keyClicks(radius, QLocale().toString(number, 'f', 2));
        QTest::keyClick(radius, Qt::Key_Return);
    };
    type(0.01 * Bar<Dim>::kUnit);
    QCOMPARE(undo().count(), before);
    QCOMPARE(radius->value(), 0.0);
    type(0.5 * Bar<Dim>::kUnit);
    QCOMPARE(undo().count(), before + 1);
    const auto place = [this] { return session().document().design().handles[1].at; };
    const auto ball = std::get<Ball<3>>(std::get<Region<3>>(place()));
    QCOMPARE(ball.radius, 0.5 * Bar<Dim>::kUnit);
    QVERIFY((ball.centre - inSpace(Bar<Dim>::place(0.8, 0))).norm() < 0.1 * Bar<Dim>::kUnit);
    QVERIFY(settle(session()));
    type(0);
    const Placement<3> point = place();
    const auto* points = std::get_if<std::vector<Vec3>>(&point);
    QVERIFY(points && points->size() == 1);
    QVERIFY((points->front() - inSpace(Bar<Dim>::place(0.8, 0))).norm() < 0.1 * Bar<Dim>::kUnit);
    QVERIFY(settle(session()));
    QVERIFY(radius->isVisible() && radius->value() == 0);
    QCOMPARE(session().gestures().pins()[1].points.size(), 1U);
    session().selection().set({0});
    QVERIFY(radius->isVisible() && radius->value() == 0);
}

void TestPinGestures::grabbingBrushHasItsSizeBesideItsName() {
    BOTH(sizeBeside);
}

/// The field, the keys and the circle share one number.
template <int Dim>
void TestPinGestures::sizeBeside() {
    QVERIFY(Bar<Dim>::open(*m_f));
    m_f->tool("grabBrush")->trigger();
    const auto* row = m_f->window().template findChild<QToolBar*>(QStringLiteral("optionRow"));
    settleLayout(m_f->window());
    QSpinBox* size = nullptr;
    for (auto* box : row->findChildren<QSpinBox*>())
        if (box->accessibleName() == QStringLiteral("Size") && box->isVisible()) size = box;
    QVERIFY(size);
    const int first = size->value();
    QTest::keyClick(&m_f->view(), Qt::Key_BracketRight);
    QVERIFY(size->value() > first);
    const auto held = [&](int across) {
        size->setValue(across);
        session().selection().clear();
        drag(at<Dim>(0), QPoint(1, 0));
        return session().gestures().pins().back().points.size();
    };
    const auto few = held(50);
    m_f->tool("grabBrush")->trigger();
    QVERIFY(held(100) > few);
}

/// The pin tool also selects; every other tool is replaced by the selection tool.
void TestPinGestures::choosingHowToSelectKeepsThePinTool() {
    QVERIFY(Bar<2>::open(*m_f));
    m_f->tool("pin")->trigger();
    pins().selectLasso->trigger();
    QVERIFY(m_f->tool("pin")->isChecked());
    m_f->tool("paint")->trigger();
    pins().selectBrush->trigger();
    QVERIFY(m_f->tool("select")->isChecked());
}

QTEST_MAIN(TestPinGestures)
#include "test_pin_gestures.moc"
