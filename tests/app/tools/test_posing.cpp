#include <Eigen/Geometry>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeWidget>
#include <numbers>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/handle_panel.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/timing_edits.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/bars.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/files/file_workflow.h"
#include "app/window/film/time_strip.h"
#include "app/window/main_window.h"
#include "app/window/solid_workshop.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Posing a picture with mouse and keys on the real window: the film's length, regions, the ring, menus.
class TestPosing : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void posingKeepsTheLength();
    void dragAfterScrubbingGoesOnFromThere();
    void pinsAreSetAtTheTimeThatIsShown();
    void lengthIsTyped();
    void posesSurviveAFile();
    void regionsAreDraggedFromInside();
    void smallestRegionIsTaken();
    void regionsVeilNothing();
    void ringRotatesAndScales();
    void ringTakesNumbers();
    void dragsTurnAndScaleAsChosen();
    void pointsBecomeDiscs();
    void numbersMoveTurnAndGrow();
    void ownTimingIsKept();
    void easeIsThatOfTheTimeShown();
    void pointsHaveADottedRing();
    void menusOfferWhatLiesThere();
    void waysAreSelectedByAClick();
    void partsAreHeldByOutlines_data();
    void partsAreHeldByOutlines();
    void partsGrowAndShrink();
    void pinsByKeyboard();

  private:
    void open();
    ShapeSession& session() { return m_window->session(); }
    ShapeCanvas& canvas() { return m_window->canvas(); }
    const Project& project() { return *session().document().project(); }
    const std::vector<Pin>& handles() { return session().document().design().handles; }
    QPoint at(const Vec2& p) { return canvas().toWidget(p).toPoint(); }
    Vec2 pin(int h) { return inPlane(session().gestures().pins()[h].centre); }
    double pixel() { return 1 / canvas().view().zoom(); }
    const PinActions& pinActions() { return *m_window->findChild<PinActions*>(); }
    void click(const Vec2& p) { QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(p)); }
    void press(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void release(const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = {});
    void moveWithShift(const QPoint& to);
    void scrub(double time);
    void widen(int handle, double radius);
    QPoint ringSpot(int handle, int dx, int dy);
    QMenu* menuAt(const Vec2& p);
    void picture(const QString& name);

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestPosing::init() {
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1100, 760);
    QVERIFY(showActive(*m_window));
    open();
}

void TestPosing::cleanup() {
    if (!session().document().isEmpty()) session().document().undoStack()->setClean();
    m_window.reset();
}

/// The bar with a pin at either end.
void TestPosing::open() {
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !session().document().isEmpty(); }, 20000));
    Project coarse = project();
    coarse.domain.vertices = 400;
    session().document().change(QStringLiteral("Coarse"), coarse);
    QVERIFY(settle(session()));
    canvas().setFocus();
    click({40, 80});
    click({200, 80});
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(2));
}

void TestPosing::press(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QTest::mouseMove(&canvas(), from);
    QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&canvas(), from + (to - from) * i / 6);
}

void TestPosing::release(const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, to);
    QVERIFY(settle(session()));
}

void TestPosing::drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers) {
    press(at(from), at(to), modifiers);
    release(at(to), modifiers);
}

void TestPosing::moveWithShift(const QPoint& to) {
    QMouseEvent event(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                      Qt::ShiftModifier);
    QCoreApplication::sendEvent(&canvas(), &event);
}

void TestPosing::scrub(double time) {
    auto* strip = m_window->findChild<TimeStrip*>();
    strip->slider()->setValue(static_cast<int>(strip->slider()->maximum() * time / project().end));
    QVERIFY(settle(session()));
}

void TestPosing::widen(int handle, double radius) {
    const Vec2 centre = pin(handle);
    drag(centre, centre + Vec2(-radius, 0), Qt::AltModifier);
    QVERIFY(std::holds_alternative<Region<3>>(handles()[handle].at));
}

/// Returns a point on the screen, relative to the middle of a pin.
QPoint TestPosing::ringSpot(int handle, int dx, int dy) {
    return at(pin(handle)) + QPoint(dx, dy);
}

QMenu* TestPosing::menuAt(const Vec2& p) {
    QTest::mouseClick(&canvas(), Qt::RightButton, {}, at(p));
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
}

/// Saves a screenshot for inspection.
void TestPosing::picture(const QString& name) {
    if (!qEnvironmentVariableIsSet("WEND_TEST_PICTURES")) return;
    QVERIFY(QTest::qWaitFor([&] { return canvas().isSettled(); }, 20000));
    m_window->grab().save(qEnvironmentVariable("WEND_TEST_PICTURES") + "/posing-" + name + ".png");
}

void TestPosing::posingKeepsTheLength() {
    auto* length = m_window->findChild<TimeStrip*>()->length();
    QCOMPARE(length->value(), 1.0);
    drag({200, 80}, {190, 110});
    drag({190, 110}, {185, 100});
    drag({40, 80}, {50, 70});
    QCOMPARE(session().playback().end(), 1.0);
    QCOMPARE(length->value(), 1.0);
    QVERIFY((pin(1) - Vec2(185, 100)).norm() < 2 * pixel());
    QVERIFY((pin(0) - Vec2(50, 70)).norm() < 2 * pixel());
    QCOMPARE(handles()[1].motions.size(), std::size_t(2));
    const double ratio = handles()[1].motions[0].end / handles()[1].motions[1].end;
    QVERIFY(std::abs(ratio - std::hypot(10, 30) / (std::hypot(10, 30) + std::hypot(5, 10))) < 0.05);
    QCOMPARE(handles()[0].motions[0].end, 1.0);
    picture(QStringLiteral("ways"));
}

void TestPosing::dragAfterScrubbingGoesOnFromThere() {
    drag({200, 80}, {200, 130});
    drag({40, 80}, {40, 60});
    const auto before = session().document().project();
    const double border = handles()[0].motions[0].start;
    scrub(border / 2);
    const Vec2 seen = pin(1);
    QVERIFY(std::abs(seen.y() - 105) < 4);
    const QPoint from = at(seen), to = from + QPoint(-40, 0);
    press(from, to);
    QVERIFY(QTest::qWaitFor([&] { return session().motion().frame()->live; }, 20000));
    QVERIFY(QLineF(at(pin(1)), to).length() < 3);  // it stays under the pointer
    release(to);
    QVERIFY(QLineF(at(pin(1)), to).length() < 3);
    QVERIFY((pin(0) - Vec2(40, 60)).norm() < 2 * pixel());  // it goes on as it did
    QCOMPARE(timeOf(project().design, 0, 0), timeOf(before->design, 0, 0));
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("replaces")));
    QCOMPARE(project().end, 1.0);
    const std::string after = toJson(project());
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(settle(session()));
    QVERIFY(session().document().project() == before);
    QVERIFY((pin(1) - Vec2(200, 130)).norm() < 2 * pixel());
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(settle(session()));
    QCOMPARE(toJson(project()), after);
}

/// The pin can be dragged where it was set, and holds from then on; nothing before it changes.
void TestPosing::pinsAreSetAtTheTimeThatIsShown() {
    drag({200, 80}, {200, 120});
    scrub(0.5);
    const Points2 shown = session().motion().frame<2>()->pose;
    click({120, 82});
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(3));
    QVERIFY(std::abs(handles()[2].activeFrom - 0.5) < 0.03);
    // The integrator begins anew there: it is the same but for its error.
    QVERIFY((session().motion().frame<2>()->pose - shown).colwise().norm().maxCoeff() < 0.05);
    const Vec2 added = pin(2);
    QVERIFY((added - Vec2(120, 82)).norm() < 2 * pixel());
    m_window->actions().toEnd->trigger();
    QVERIFY(settle(session()));
    QVERIFY((pin(2) - added).norm() < 1e-6);
    QVERIFY((pin(1) - Vec2(200, 120)).norm() < 2 * pixel());  // its motion is still there
}

void TestPosing::lengthIsTyped() {
    drag({200, 80}, {190, 110});
    const Points2 end = session().motion().frame<2>()->pose;
    auto* length = m_window->findChild<TimeStrip*>()->length();
    length->setFocus();
    length->selectAll();
    QTest::keyClicks(length, QLocale().toString(2.5, 'f', 1));
    QTest::keyClick(length, Qt::Key_Return);
    QVERIFY(settle(session()));
    QCOMPARE(project().end, 2.5);
    QCOMPARE(handles()[1].motions[0].end, 2.5);
    QCOMPARE(session().playback().end(), 2.5);
    QVERIFY(canvas().hasFocus());
    QVERIFY((session().motion().frame<2>()->pose - end).colwise().norm().maxCoeff() < 1e-6);
    QTest::keyClick(&canvas(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(settle(session()));
    QCOMPARE(project().end, 1.0);
    QCOMPARE(length->value(), 1.0);
}

void TestPosing::posesSurviveAFile() {
    drag({200, 80}, {190, 110});
    widen(1, 18);
    press(ringSpot(1, 31, -31), ringSpot(1, 44, 0));
    release(ringSpot(1, 44, 0));
    scrub(0.7);
    drag(pin(0), pin(0) + Vec2(0, -12));
    const std::string text = toJson(project());
    const Points2 shown = session().motion().frame<2>()->pose;
    const QString path = m_folder->filePath(QStringLiteral("posed.wend"));
    session().document().save(path);
    const int generation = session().document().generation();
    m_window->openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session().document().generation() > generation; }, 20000));
    m_window->actions().toEnd->trigger();
    QVERIFY(settle(session()));
    session().playback().setTime(session().playback().end());
    QVERIFY(settle(session()));
    QCOMPARE(toJson(project()), text);
    QVERIFY((session().motion().frame<2>()->pose - shown).colwise().norm().maxCoeff() < 1e-6);
}

void TestPosing::regionsAreDraggedFromInside() {
    widen(1, 22);
    const Vec2 inside = pin(1) + Vec2(-14, 4);
    m_window->actions().selectTool->trigger();
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QVERIFY(session().selection().isEmpty());
    const Vec2 before = pin(1);
    drag(inside, inside + Vec2(-6, 20));
    QCOMPARE(handles()[1].motions.size(), std::size_t(1));
    QVERIFY((pin(1) - before - Vec2(-6, 20)).norm() < 2 * pixel());
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    m_window->actions().pinTool->trigger();
    click(pin(1) + Vec2(-12, 3));  // no pin within what is held already
    QCOMPARE(handles().size(), std::size_t(2));
}

/// The smallest region is taken, whichever was made first; a rectangle selects regions by any of their
/// points.
void TestPosing::smallestRegionIsTaken() {
    const auto box = [this](const Vec2& from, const Vec2& to) {
        m_window->tools().action(QStringLiteral("rectangle"))->trigger();
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(from));
        QTest::mouseMove(&canvas(), at(to));
        release(at(to));
        m_window->actions().selectTool->trigger();
        QTest::keyClick(&canvas(), Qt::Key_Escape);
    };
    box({108, 68}, {132, 92});
    box({90, 55}, {150, 105});
    box({112, 72}, {124, 84});
    QCOMPARE(handles().size(), std::size_t(5));
    const auto taken = [this](const Vec2& p) {
        click(p);
        const std::vector<int> selected = session().selection().handles();
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        return selected;
    };
    QCOMPARE(taken({115, 89}), std::vector<int>{2});
    QCOMPARE(taken({142, 90}), std::vector<int>{3});
    QCOMPARE(taken({113.5, 83}), std::vector<int>{4});
    // The press is over the right end of the large one, far from all middles.
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, at({165, 40}));
    QTest::mouseMove(&canvas(), at({150, 100}));
    QTest::mouseMove(&canvas(), at({138, 110}));
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at({138, 110}));
    QCOMPARE(session().selection().handles(), std::vector<int>{3});
}

/// The picture inside is the same with the pins hidden, until the pointer is over it.
void TestPosing::regionsVeilNothing() {
    widen(1, 24);
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseMove(&canvas(), QPoint(5, 5));
    QVERIFY(QTest::qWaitFor([&] { return canvas().isSettled(); }, 20000));
    const QPoint spot = at(pin(1) + Vec2(-15, 0));
    const auto colour = [&] {
        return canvas().grab().toImage().pixelColor(spot * canvas().devicePixelRatio());
    };
    const QColor shown = colour();
    QTest::mouseMove(&canvas(), spot);
    const QColor hovered = colour();
    QVERIFY(hovered != shown);
    picture(QStringLiteral("region"));
    QTest::mouseMove(&canvas(), QPoint(5, 5));
    m_window->actions().hideOverlays->setChecked(true);
    QVERIFY(QTest::qWaitFor([&] { return canvas().isSettled(); }, 20000));
    QCOMPARE(colour(), shown);
}

void TestPosing::ringRotatesAndScales() {
    widen(1, 18);
    const Vec2 centre = pin(1);
    const auto before = session().gestures().pins()[1].points;
    press(ringSpot(1, 31, -31), ringSpot(1, 31, 31));  // a quarter, clockwise
    release(ringSpot(1, 31, 31));
    const auto* turn = std::get_if<Rotate<3>>(&handles()[1].motions.at(0).kind);
    QVERIFY(turn && std::abs(turn->angle - std::numbers::pi / 2) < 0.03);
    QVERIFY((pin(1) - centre).norm() < 0.5);
    const auto turned = session().gestures().pins()[1].points;
    for (std::size_t i = 0; i < turned.size(); ++i) {
        const Vec2 hub = inPlane(turn->centre), arm = inPlane(before[i]) - hub;
        QVERIFY((inPlane(turned[i]) - hub - Eigen::Rotation2Dd(turn->angle) * arm).norm() < 1e-6);
    }
    press(ringSpot(1, 31, 31), ringSpot(1, 24, 24));
    release(ringSpot(1, 24, 24));
    const auto* grown = std::get_if<CurveMotion<3>>(&handles()[1].motions.back().kind);
    QVERIFY(grown && std::abs(grown->scale - 24.0 / 31) < 0.03);
    QCOMPARE(project().end, 1.0);
    press(ringSpot(1, 31, -31), ringSpot(1, 40, -18));
    moveWithShift(ringSpot(1, 42, -10));
    picture(QStringLiteral("ring"));
    QVERIFY(session().gestures().drag());
    const double steps = session().gestures().drag()->amount()[0] / (std::numbers::pi / 12);
    QVERIFY(std::abs(steps - std::round(steps)) < 1e-9 && std::round(steps) == 2);
    const int count = session().document().undoStack()->count();
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QVERIFY(!session().motion().isDragging());
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, ringSpot(1, 42, -10));
    QCOMPARE(session().document().undoStack()->count(), count);
}

/// The keys are those of solids; the drag may begin anywhere, also on the pin and in its very middle.
void TestPosing::dragsTurnAndScaleAsChosen() {
    widen(1, 18);
    const auto* row = m_window->findChild<OptionRow*>();
    for (const QAction* one : {pinActions().move, pinActions().turn, pinActions().grow})
        QVERIFY(row->actions().contains(one));
    const Vec2 centre = pin(1);
    const std::size_t count = handles().size();
    QTest::keyClick(&canvas(), Qt::Key_R);
    QVERIFY(pinActions().turn->isChecked());
    press(ringSpot(1, -90, 0), ringSpot(1, 0, -90));  // a quarter, clockwise
    QVERIFY(session().gestures().drag() && session().gestures().drag()->grip().kind == Grip::Kind::Turn);
    release(ringSpot(1, 0, -90));
    const auto* turn = std::get_if<Rotate<3>>(&handles()[1].motions.at(0).kind);
    QVERIFY(turn && std::abs(turn->angle - std::numbers::pi / 2) < 0.01);
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QCOMPARE(handles().size(), count);
    // From the very middle, the direction counts once there is one.
    press(ringSpot(1, -3, 2), ringSpot(1, 60, 0));
    QVERIFY(session().gestures().drag() && std::abs(session().gestures().drag()->amount()[0]) < 0.05);
    QTest::mouseMove(&canvas(), ringSpot(1, 52, 30));
    QVERIFY(std::abs(session().gestures().drag()->amount()[0] - std::numbers::pi / 6) < 0.05);
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, ringSpot(1, 52, 30));
    QTest::keyClick(&canvas(), Qt::Key_S);
    press(ringSpot(1, -60, 0), ringSpot(1, -90, 0));
    QVERIFY(session().gestures().drag() && session().gestures().drag()->grip().kind == Grip::Kind::Grow);
    QVERIFY(std::abs(session().gestures().drag()->amount()[0] - 0.5) < 0.01);
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, ringSpot(1, -90, 0));
    press(ringSpot(1, 0, 0), ringSpot(1, 0, -16));
    QVERIFY(std::abs(session().gestures().drag()->amount()[0] - 1) < 0.1);
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, ringSpot(1, 0, -16));
    QTest::keyClick(&canvas(), Qt::Key_G);
    drag(centre, centre + Vec2(-10, 5));
    QVERIFY((pin(1) - centre - Vec2(-10, 5)).norm() < 1);
}

/// A drag beside a point makes it a small disc; Esc or one undo makes it a point again.
void TestPosing::pointsBecomeDiscs() {
    session().selection().set({1});
    const Vec2 before = pin(1);
    for (const auto& [key, kind] : {std::pair{Qt::Key_R, Grip::Kind::Turn}, {Qt::Key_S, Grip::Kind::Grow}}) {
        QTest::keyClick(&canvas(), key);
        press(ringSpot(1, -70, 0), ringSpot(1, -90, 30));
        QVERIFY(session().motion().isDragging());
        QVERIFY(session().gestures().drag() && session().gestures().drag()->grip().kind == kind);
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        release(ringSpot(1, -90, 30));
        QCOMPARE(pin(1), before);
        QVERIFY(handles()[1].motions.empty());
    }
    QTest::keyClick(&canvas(), Qt::Key_R);
    press(ringSpot(1, -70, 0), ringSpot(1, -70, 40));
    release(ringSpot(1, -70, 40));
    QCOMPARE(handles()[1].motions.size(), std::size_t(1));
    QVERIFY(std::holds_alternative<Rotate<3>>(handles()[1].motions[0].kind));
    session().document().undoStack()->undo();
    QVERIFY(handles()[1].motions.empty());
    QTRY_COMPARE(pin(1), before);
}

/// The panel makes the same exact steps as for solids.
void TestPosing::numbersMoveTurnAndGrow() {
    widen(1, 18);
    auto* panel = m_window->findChild<HandlePanel*>();
    auto* kind = panel->findChild<QComboBox*>();
    auto* apply = panel->findChild<QToolButton*>(QStringLiteral("applyStep"));
    const auto step = [&](int which, const QStringList& numbers) {
        kind->setCurrentIndex(which);
        QList<QDoubleSpinBox*> boxes;
        for (auto* box : panel->findChildren<NumberBox*>())
            if (box->isVisible() && box->y() == apply->y() + (apply->height() - box->height()) / 2)
                boxes << box;
        QCOMPARE(boxes.size(), numbers.size());
        std::ranges::sort(boxes, {}, &QWidget::x);
        for (int k = 0; k < numbers.size(); ++k) {
            boxes[k]->setFocus();
            boxes[k]->selectAll();
            QTest::keyClicks(boxes[k], numbers[k]);
        }
        QTest::mouseClick(apply, Qt::LeftButton);
        QVERIFY(settle(session()));
    };
    const auto held = [&] { return session().gestures().pins()[1].points; };
    const auto before = held();
    const Vec2 by(-12.5, 7.25), centre = pin(1) + by;
    step(0, {QStringLiteral("-12.5"), QStringLiteral("7.25")});
    step(1, {QStringLiteral("30")});
    step(2, {QStringLiteral("1.25")});
    const auto after = held();
    QCOMPARE(after.size(), before.size());
    QVERIFY(after.size() > 2);
    const Mat2 turn = Eigen::Rotation2Dd(std::numbers::pi / 6).toRotationMatrix();
    for (std::size_t i = 0; i < after.size(); ++i) {
        const Vec2 expected = centre + 1.25 * (turn * (inPlane(before[i]) + by - centre));
        QVERIFY2((inPlane(after[i]) - expected).norm() < 1e-6,
                 qPrintable(QString::number((inPlane(after[i]) - expected).norm())));
    }
    QVERIFY(panel->findChild<QLabel*>(QStringLiteral("pinPlace"))
                ->text()
                .contains(QLocale().toString(pin(1).x(), 'g', 5)));
}

/// A drag divides the film in proportion to the lengths of the paths; motions with a timing of their own keep
/// their times, and the film becomes longer, with a notice.
void TestPosing::ownTimingIsKept() {
    const auto told = [&] {
        return m_window->statusBar()->currentMessage().contains(QStringLiteral("keeps its times"));
    };
    drag(pin(1), pin(1) + Vec2(0, 20));
    drag(pin(1), pin(1) + Vec2(-20, 0));
    QVERIFY(!hasOwnTiming(project()));
    QVERIFY(!told());
    const double border = handles()[1].motions[0].end;
    QVERIFY(std::abs(border - 0.5 * project().end) < 0.02 * project().end);
    Project timed = withMotionSpan(project(), {{1, 0}}, {0, 0.4 * border});
    session().document().change(QStringLiteral("Time"), timed);
    QVERIFY(settle(session()));
    QVERIFY(hasOwnTiming(project()));
    session().playback().setTime(project().end);
    QVERIFY(settle(session()));
    drag(pin(1), pin(1) + Vec2(0, -20));
    QVERIFY(told());
    QCOMPARE(handles()[1].motions[0].end, 0.4 * border);
    QCOMPARE(handles()[1].motions[1].end, timed.end);
    QCOMPARE(project().end, timed.end + 1);
}

void TestPosing::easeIsThatOfTheTimeShown() {
    drag(pin(1), pin(1) + Vec2(0, 20));
    drag(pin(1), pin(1) + Vec2(-10, 10));
    QCOMPARE(handles()[1].motions.size(), std::size_t(2));
    auto* ease = m_window->findChild<QComboBox*>(QStringLiteral("ease"));
    QVERIFY(ease->isVisible());
    const auto choose = [&](int steps) {
        ease->setFocus();
        for (int k = 0; k < steps; ++k) QTest::keyClick(ease, Qt::Key_Down);
        QVERIFY(settle(session()));
    };
    choose(1);
    QVERIFY(handles()[1].motions[1].ease == Ease::In && handles()[1].motions[0].ease == Ease::Linear);
    scrub(0.5 * handles()[1].motions[0].end);
    QCOMPARE(ease->currentIndex(), 0);
    choose(3);
    QVERIFY(handles()[1].motions[1].ease == Ease::In && handles()[1].motions[0].ease == Ease::InOut);
}

void TestPosing::ringTakesNumbers() {
    widen(1, 18);
    press(ringSpot(1, 31, -31), ringSpot(1, 40, -18));
    QTest::keyClicks(&canvas(), QStringLiteral("10"));  // of which 1 is a shortcut elsewhere
    QTest::keyClick(&canvas(), Qt::Key_Return);
    release(ringSpot(1, 40, -18));
    const auto* turn = std::get_if<Rotate<3>>(&handles()[1].motions.at(0).kind);
    QVERIFY(turn && std::abs(turn->angle - std::numbers::pi / 18) < 1e-9);
    QCOMPARE(handles()[1].motions.size(), std::size_t(1));
}

void TestPosing::pointsHaveADottedRing() {
    session().selection().set({1});
    QTest::mouseMove(&canvas(), ringSpot(1, -44, 0));
    QVERIFY(canvas().viewport().tool()->hint().contains(QStringLiteral("becomes a small circle")));
    picture(QStringLiteral("point"));
    const std::size_t count = handles().size();
    press(ringSpot(1, -44, 0), ringSpot(1, -30, 30));
    release(ringSpot(1, -30, 30));
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QCOMPARE(handles().size(), count);
    QCOMPARE(handles()[1].motions.size(), std::size_t(1));
    session().document().undoStack()->undo();
    drag(pin(1), pin(1) + Vec2(0.9, 0), Qt::AltModifier);  // smaller than the mesh
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("smaller than the mesh")) ||
            std::holds_alternative<std::vector<Vec3>>(handles()[1].at));
    QCOMPARE(handles().size(), count);
    QVERIFY(handles()[1].motions.empty());
}

void TestPosing::menusOfferWhatLiesThere() {
    QMenu* menu = menuAt(pin(0));
    QVERIFY(menu && menu->actions().contains(m_window->actions().remove));
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    menu->close();
    menu = menuAt({120, 80});
    QVERIFY(menu && menu->actions().contains(m_window->actions().fit));
    QVERIFY(!menu->actions().contains(m_window->actions().remove));
    menu->close();
    QCOMPARE(handles().size(), std::size_t(2));
    menu = menuAt(pin(1));
    QVERIFY(menu);
    m_window->actions().remove->trigger();
    menu->close();
    QVERIFY(settle(session()));
    QCOMPARE(handles().size(), std::size_t(1));
}

void TestPosing::waysAreSelectedByAClick() {
    drag({200, 80}, {170, 130});
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QVERIFY(session().selection().isEmpty());
    const Vec2 middle = (Vec2(200, 80) + Vec2(170, 130)) / 2;
    click(middle);
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QCOMPARE(handles().size(), std::size_t(2));
}

void TestPosing::partsAreHeldByOutlines_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("modifier");
    QTest::newRow("rectangle") << int(Qt::Key_B) << int(Qt::ShiftModifier);
    QTest::newRow("lasso") << int(Qt::Key_L) << 0;
    QTest::newRow("brush") << int(Qt::Key_U) << 0;
}

/// The outlined part becomes one handle, which a drag from inside moves without a rotation.
void TestPosing::partsAreHeldByOutlines() {
    QFETCH(int, key);
    QFETCH(int, modifier);
    QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key), Qt::KeyboardModifiers(modifier));
    const std::vector<Vec2> corners = {{100, 66}, {140, 66}, {140, 96}, {100, 96}};
    const bool box = key == Qt::Key_B;
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(corners[0]));
    for (int i = box ? 2 : 1; i < (box ? 3 : 4); ++i) QTest::mouseMove(&canvas(), at(corners[i]));
    release(at(corners[box ? 2 : 3]));
    QCOMPARE(handles().size(), std::size_t(3));
    QVERIFY(std::holds_alternative<Polygon>(std::get<Region<3>>(handles()[2].at)));
    QVERIFY(m_window->actions().selectTool->isChecked());
    const auto before = session().gestures().pins()[2].points;
    QVERIFY(before.size() > 5);
    const Vec2 inside(138, 80);  // where the brush was, too
    drag(inside, inside + Vec2(0, 9));
    const auto after = session().gestures().pins()[2].points;
    for (std::size_t i = 0; i < before.size(); ++i)
        QVERIFY((after[i] - before[i] - Vec3(0, 9, 0)).norm() < 2 * pixel());
    const std::string text = toJson(project());
    QUndoStack& undo = *session().document().undoStack();
    undo.undo();
    undo.undo();
    QCOMPARE(handles().size(), std::size_t(2));
    undo.redo();
    undo.redo();
    QVERIFY(settle(session()));
    QCOMPARE(toJson(project()), text);
}

void TestPosing::partsGrowAndShrink() {
    const auto box = [this](const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers) {
        m_window->tools().action(QStringLiteral("rectangle"))->trigger();
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, at(from));
        QTest::mouseMove(&canvas(), at(to));
        release(at(to), modifiers);
        return session().gestures().pins()[2].points.size();
    };
    const std::size_t first = box({100, 66}, {130, 94}, {});
    QVERIFY(box({125, 66}, {155, 94}, Qt::ShiftModifier) > first);
    QCOMPARE(handles().size(), std::size_t(3));
    QVERIFY(box({90, 50}, {140, 110}, Qt::ControlModifier) < first);
    QCOMPARE(handles().size(), std::size_t(3));
    session().selection().clear();
    m_window->tools().action(QStringLiteral("rectangle"))->trigger();
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, at({2, 2}));
    QTest::mouseMove(&canvas(), at({12, 12}));
    release(at({12, 12}));
    QCOMPARE(handles().size(), std::size_t(3));
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("No part of the shape")));
}

/// A pin is chosen in the list, moved by the arrows, renamed and removed.
void TestPosing::pinsByKeyboard() {
    auto* list = m_window->findChild<QTreeWidget*>(QStringLiteral("pinList"));
    QVERIFY(list && list->isVisible());
    QCOMPARE(list->topLevelItemCount(), 2);
    list->setFocus();
    list->setCurrentItem(list->topLevelItem(0));
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    QTest::keyClick(list, Qt::Key_Down);
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(canvas().hasFocus());
    QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(&canvas(), Qt::Key_Left);
    QVERIFY(settle(session()));
    QVERIFY((pin(1) - Vec2(199, 90)).norm() < 2 * pixel());
    QCOMPARE(project().end, 1.0);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_F2);
    auto* editor = list->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText(QStringLiteral("hand"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(handles()[1].name, std::string("hand"),
                              20000);  // Qt takes a name a moment later
    session().document().undoStack()->undo();
    QCOMPARE(list->topLevelItem(1)->text(0), QStringLiteral("Pin 2"));
    click(pin(0));
    QVERIFY(list->topLevelItem(0)->isSelected() && !list->topLevelItem(1)->isSelected());
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Delete);  // it held while the other one moved
    QVERIFY(settle(session()));
    QCOMPARE(session().gestures().pins().size(), std::size_t(1));
    QCOMPARE(list->topLevelItemCount(), 2);
    QVERIFY(list->topLevelItem(0)->font(0).italic());
}

QTEST_MAIN(TestPosing)
#include "test_posing.moc"
