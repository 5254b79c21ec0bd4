#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QStatusBar>

#include "app/panels/distortion_panel.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/handle_panel.h"
#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/files/file_workflow.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "core/motion/curve.h"
#include "tests/support/dialogs.h"
#include "tests/support/window_test.h"
#include "warp/warp.h"

using namespace wend;
using namespace wend::test;

/// Pins and curves of a picture in the whole window, with real mouse and key events.
class TestWindowPins : public WindowTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { end(); }
    void clickPinsAndDragMoves();
    void dragIsOneStepThatUndoes();
    void escapeEndsADrag();
    void marqueeAndShiftSelect();
    void arrowsNudge();
    void deleteRemoves();
    void clickBesideTheShapeSaysSo();
    void handlesThatAreGoneCanBeFound();
    void undoInADragLeavesTheWindowWhole();
    void curvesAreEdited();
    void doublePressTakesThePinOnItsCurve();
    void menusWaitForTheGesture();

  private:
    bool openWithCurve();
};

void TestWindowPins::clickPinsAndDragMoves() {
    open();
    click(40, 80);
    click(200, 80);
    QCOMPARE(pinCount(), std::size_t(2));
    click(10, 10);  // beside the shape
    QCOMPARE(pinCount(), std::size_t(2));
    QVERIFY(m_window->session().selection().isEmpty());
    QVERIFY(settle(m_window->session()));
    dragPin(200, 80, -10, 25);
    QVERIFY(QTest::qWaitFor([&] { return m_window->session().motion().frame()->live; },
                            20000));  // it follows before the release
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(190, 105));
    QVERIFY(settle(m_window->session()));
    const double pixel = 1 / m_window->canvas().view().zoom();
    QVERIFY((m_window->session().gestures().pins()[1].centre - Vec3(190, 105, 0)).norm() < 2 * pixel);
    QVERIFY(m_window->isWindowModified());
}

void TestWindowPins::dragIsOneStepThatUndoes() {
    open();
    click(40, 80);
    click(200, 80);
    QVERIFY(settle(m_window->session()));
    const Points2 before = m_window->session().motion().frame<2>()->pose;
    QUndoStack& undo = *m_window->session().document().undoStack();
    const int steps = undo.count();
    dragPin(200, 80, 0, 20);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(200, 100));
    QVERIFY(settle(m_window->session()));
    const Points2 after = m_window->session().motion().frame<2>()->pose;
    QCOMPARE(undo.count(), steps + 1);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(settle(m_window->session()));
    QVERIFY(m_window->session().motion().frame<2>()->pose == before);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(settle(m_window->session()));
    QVERIFY(m_window->session().motion().frame<2>()->pose == after);
}

void TestWindowPins::escapeEndsADrag() {
    open();
    click(40, 80);
    click(200, 80);
    QVERIFY(settle(m_window->session()));
    const Points2 before = m_window->session().motion().frame<2>()->pose;
    const int steps = m_window->session().document().undoStack()->count();
    dragPin(200, 80, 0, 25);
    QTest::keyClick(&m_window->canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(200, 105));
    QVERIFY(settle(m_window->session()));
    QVERIFY(m_window->session().motion().frame<2>()->pose == before);
    QCOMPARE(m_window->session().document().undoStack()->count(), steps);
}

void TestWindowPins::marqueeAndShiftSelect() {
    open();
    click(40, 80);
    click(120, 80);
    click(200, 80);
    Selection& selection = m_window->session().selection();
    QCOMPARE(selection.handles(), std::vector<int>({2}));
    click(40, 80, Qt::ShiftModifier);
    QCOMPARE(selection.handles(), std::vector<int>({0, 2}));
    ShapeCanvas& canvas = m_window->canvas();
    QTest::mousePress(&canvas, Qt::LeftButton, {}, at(100, 40));
    QTest::mouseMove(&canvas, at(150, 100));
    QTest::mouseMove(&canvas, at(220, 120));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at(220, 120));
    QCOMPARE(selection.handles(), std::vector<int>({1, 2}));
    QTest::mousePress(&canvas, Qt::LeftButton, Qt::ControlModifier, at(180, 40));
    QTest::mouseMove(&canvas, at(200, 100));
    QTest::mouseMove(&canvas, at(220, 120));
    QTest::mouseRelease(&canvas, Qt::LeftButton, Qt::ControlModifier, at(220, 120));
    QCOMPARE(selection.handles(), std::vector<int>({1}));
    QCOMPARE(pinCount(), std::size_t(3));
}

void TestWindowPins::arrowsNudge() {
    open();
    click(40, 80);
    click(200, 80);
    const int steps = m_window->session().document().undoStack()->count();
    const Vec3 before = m_window->session().gestures().pins()[1].centre;
    QTest::keyClick(&m_window->canvas(), Qt::Key_Right);
    QTest::keyClick(&m_window->canvas(), Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(settle(m_window->session()));
    QVERIFY((m_window->session().gestures().pins()[1].centre - before - Vec3(1, 10, 0)).norm() < 1e-6);
    QCOMPARE(m_window->session().document().undoStack()->count(), steps + 1);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&m_window->canvas(), Qt::Key_Left);
    for (int i = 0; i < 4; ++i) QTest::keyClick(&m_window->canvas(), Qt::Key_Up);
    QVERIFY(settle(m_window->session()));
    QVERIFY((m_window->session().gestures().pins()[1].centre - before - Vec3(-2, 6, 0)).norm() < 1e-6);
}

void TestWindowPins::deleteRemoves() {
    open();
    click(40, 80);
    click(200, 80);
    QTest::keyClick(m_window.get(), Qt::Key_Delete);
    QCOMPARE(pinCount(), std::size_t(1));
    QVERIFY(!m_window->actions().remove->isEnabled());
    m_window->actions().undo->trigger();
    QCOMPARE(pinCount(), std::size_t(2));
    // All are deleted at once, and restored in one step.
    click(120, 80);
    m_window->actions().selectAll->trigger();
    QCOMPARE(m_window->session().selection().handles(), std::vector<int>({0, 1, 2}));
    m_window->actions().remove->trigger();
    QCOMPARE(pinCount(), std::size_t(0));
    m_window->actions().undo->trigger();
    QCOMPARE(pinCount(), std::size_t(3));
}

void TestWindowPins::clickBesideTheShapeSaysSo() {
    open();
    click(10, 10);
    QCOMPARE(pinCount(), std::size_t(0));
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("outside")));
    click(120, 80);  // until a pin is there
    QCOMPARE(pinCount(), std::size_t(1));
    QVERIFY(!m_window->statusBar()->currentMessage().contains(QStringLiteral("outside")));
}

/// A released pin stays visible and can be selected and removed.
void TestWindowPins::handlesThatAreGoneCanBeFound() {
    open();
    QVERIFY(bend());
    click(40, 80);
    QCOMPARE(m_window->session().selection().handles(), std::vector<int>({0}));
    QTest::keyClick(m_window.get(), Qt::Key_Delete);
    QVERIFY(settle(m_window->session()));
    QCOMPARE(pinCount(), std::size_t(2));
    QCOMPARE(m_window->session().gestures().pins().size(), std::size_t(1));
    click(40, 80);
    QCOMPARE(pinCount(), std::size_t(2));
    QCOMPARE(m_window->session().selection().handles(), std::vector<int>({0}));
    QTest::keyClick(m_window.get(), Qt::Key_Delete);
    QCOMPARE(pinCount(), std::size_t(1));
}

void TestWindowPins::undoInADragLeavesTheWindowWhole() {
    open();
    click(40, 80);
    click(200, 80);
    QVERIFY(settle(m_window->session()));
    dragPin(200, 80, 0, 20);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QTest::mouseMove(&m_window->canvas(), at(200, 110));
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(200, 110));
    QVERIFY(settle(m_window->session()));
    QCOMPARE(pinCount(), std::size_t(1));
}

/// Opens a picture with two pins, the right one moved along a curve.
bool TestWindowPins::openWithCurve() {
    open();
    click(40, 80);
    click(200, 80);
    dragPin(200, 80, -30, 30);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(170, 110));
    const bool moved = settle(m_window->session());
    m_window->curves().make->trigger();
    return moved;
}

/// The curve is below its selected pin.
void TestWindowPins::doublePressTakesThePinOnItsCurve() {
    QVERIFY(openWithCurve());
    m_window->session().playback().setTime(0.5);
    QVERIFY(settle(m_window->session()));
    const Vec3 pin = m_window->session().gestures().pins()[1].centre;
    QTest::mouseDClick(&m_window->canvas(), Qt::LeftButton, {}, at(pin.x(), pin.y()));
    QVERIFY(settle(m_window->session()));
    QCOMPARE(lastCurve(m_window->session().document().design(), 1)->points.size(), std::size_t(4));
}

/// A right click on the curve opens its menu, but not while the left button drags.
void TestWindowPins::menusWaitForTheGesture() {
    QVERIFY(openWithCurve());
    QVERIFY(settle(m_window->session()));
    const Vec3 inner = lastCurve(m_window->session().document().design(), 1)->points[1];
    ShapeCanvas& canvas = m_window->canvas();
    canvas.viewport().disconnect(SIGNAL(menuWanted(QPoint, wend::MenuPlace)));  // it would wait for an answer
    QSignalSpy menus(&canvas.viewport(), &Viewport::menuWanted);
    const QPointF where = at(inner.x(), inner.y());
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held) {
        QMouseEvent event(type, where, canvas.mapToGlobal(where), button, held, {});
        QCoreApplication::sendEvent(&canvas, &event);
    };
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseButtonPress, Qt::RightButton, Qt::LeftButton | Qt::RightButton);
    send(QEvent::MouseButtonRelease, Qt::RightButton, Qt::LeftButton);
    QCOMPARE(menus.count(), 0);
    send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
    send(QEvent::MouseButtonPress, Qt::RightButton, Qt::RightButton);
    send(QEvent::MouseButtonRelease, Qt::RightButton, Qt::NoButton);
    QCOMPARE(menus.count(), 1);
}

/// A dragged pin's path becomes a curve; its points are dragged, inserted and deleted.
void TestWindowPins::curvesAreEdited() {
    open();
    click(40, 80);
    click(200, 80);
    dragPin(200, 80, -10, -40);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(190, 40));
    QVERIFY(settle(m_window->session()));
    m_window->curves().make->trigger();
    QVERIFY(settle(m_window->session()));
    const auto curve = [&] { return lastCurve(m_window->session().document().design(), 1)->points; };
    QCOMPARE(curve().size(), std::size_t(4));
    const Vec3 inner = curve()[1];
    dragPin(inner.x(), inner.y(), 15, 0);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(inner.x() + 15, inner.y()));
    QVERIFY(settle(m_window->session()));
    QVERIFY((curve()[1] - inner - Vec3(15, 0, 0)).norm() < 1);  // a pixel of the screen
    const Vec3 middle = bezierCurve<3>(curve()).pieces[0].value(0.5);
    QTest::mouseDClick(&m_window->canvas(), Qt::LeftButton, {}, at(middle.x(), middle.y()));
    QVERIFY(settle(m_window->session()));
    QCOMPARE(curve().size(), std::size_t(7));
    QVERIFY((curve()[3] - middle).norm() < 1);
    QCOMPARE(pinCount(), std::size_t(2));
    QVERIFY(m_window->curves().automatic->isEnabled());
    QTest::keyClick(&m_window->canvas(), Qt::Key_Delete);
    QVERIFY(settle(m_window->session()));
    QCOMPARE(curve().size(), std::size_t(4));
    QCOMPARE(pinCount(), std::size_t(2));
    // The panel adds a frame along the curve, and a scale.
    CurvePanel* panel = nullptr;
    for (CurvePanel* one : m_window->findChildren<CurvePanel*>())
        if (one->isVisible()) panel = one;
    QVERIFY(panel);
    auto* frame = panel->findChild<QComboBox*>(QStringLiteral("curveFrame"));
    QVERIFY(!frame->isEnabled() &&
            frame->toolTip().startsWith(QStringLiteral("<p><i>A point cannot rotate")));
    QTest::mousePress(&m_window->canvas(), Qt::LeftButton, Qt::AltModifier, at(190, 40));
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&m_window->canvas(), at(190 - 4 * i, 40));
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, Qt::AltModifier, at(170, 40));
    QVERIFY(settle(m_window->session()));
    QVERIFY(frame->isEnabled());
    frame->setFocus();
    for (int i = 0; i < 2; ++i) QTest::keyClick(frame, Qt::Key_Down);
    QVERIFY(settle(m_window->session()));
    const auto motion = [&] { return *lastCurve(m_window->session().document().design(), 1); };
    QCOMPARE(motion().frame, FrameKind::Minimal);
    for (QDoubleSpinBox* box : panel->findChildren<QDoubleSpinBox*>())
        if (box->isVisible()) box->setValue(1.2);
    QVERIFY(settle(m_window->session()));
    QCOMPARE(motion().scale, 1.2);
    QCOMPARE(motion().twist, 0.0);
    if (qEnvironmentVariableIsSet("WEND_TEST_PICTURES"))  // for looking at
        m_window->grab().save(qEnvironmentVariable("WEND_TEST_PICTURES") + "/flat-curve.png");
    // A pin at the end of its curve is still a pin: another drag continues from there.
    dragPin(190, 40, 0, -8);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(190, 32));
    QVERIFY(settle(m_window->session()));
    QCOMPARE(m_window->session().document().design().handles[1].motions.size(), std::size_t(2));
}

QTEST_MAIN(TestWindowPins)
#include "test_window_pins.moc"
