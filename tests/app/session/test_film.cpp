#include <QActionGroup>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QSlider>

#include "app/engine/motion/drag_gesture.h"
#include "app/panels/distortion_panel.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/timing_edits.h"
#include "app/views/shape/shape_painter.h"
#include "app/views/volume/solid_overlay.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/film/time_ruler.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The step Animate on the real window, for pictures and solids alike: drags that are recorded in real time,
/// tracks, onion skin.
class TestFilm : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_window.reset(); }
    void recordsWhatTheHandDoes_data() { dimensions(); }
    void recordsWhatTheHandDoes();
    void recordsWithTheSwitch();
    void othersGoOnWhileOneIsRecorded();
    void recordsByTheClockOfTheFilm();
    void dragsLeaveOthersAlone_data() { dimensions(); }
    void dragsLeaveOthersAlone();
    void otherPinsMoveDuringARecording_data() { dimensions(); }
    void otherPinsMoveDuringARecording();
    void playsAtItsSpeed();
    void shortBarsKeepTheirPlace();
    void givenUpRecordingLeavesNothing();
    void tracksAreThereInTheirStep();
    void barsAreDragged_data() { dimensions(); }
    void barsAreDragged();
    void holdsAreDragged_data() { dimensions(); }
    void holdsAreDragged();
    void barsSnapToEachOther();
    void lockedBarsStay();
    void barsByKeyboard();
    void severalBarsGoTogether_data() { dimensions(); }
    void severalBarsGoTogether();
    void framesChooseBars();
    void menuOfABar();
    void ghostsTellWhenTheyHold_data() { dimensions(); }
    void ghostsTellWhenTheyHold();
    void playingShowsTheShapeAlone_data() { dimensions(); }
    void playingShowsTheShapeAlone();
    void rulerIsScrubbed();
    void movingPinsAreInViewAtFirst();
    void manyPinsScroll();
    void onionSkinShowsPastAndFuture();
    void onionSkinLeavesOutTheMargin();
    void onionSkinOfASolid();
    void influenceOfPins_data() { dimensions(); }
    void influenceOfPins();

  private:
    static void dimensions();
    void open(int dimension);
    void openFilm(int dimension);
    ShapeSession& session() { return m_window->session(); }
    const Project& project() { return *session().document().project(); }
    TrackView& tracks() { return *m_window->window().findChild<TrackView*>(); }
    QWidget& canvas() {
        return session().document().dimension() == 2 ? static_cast<QWidget&>(m_window->window().canvas())
                                                     : m_window->canvas();
    }
    QPoint pin(int handle);
    void record(int handle, Qt::KeyboardModifiers modifiers = Qt::ControlModifier, int pause = 0);
    void dragBar(int handle, int motion, double fromX, double by);
    std::size_t motions(int handle);
    double span() { return tracks().barOf(0, TrackView::kHold).width(); }  // of a pin that holds throughout

    std::unique_ptr<SolidFixture> m_window;
};

void TestFilm::dimensions() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

void TestFilm::init() {
    m_window = std::make_unique<SolidFixture>();
}

/// A bar with two handles.
void TestFilm::open(int dimension) {
    if (dimension == 3) {
        QVERIFY(m_window->open() && m_window->holdEnds());
    } else {
        QVERIFY(m_window->openPicture());
        session().addPin({40, 80, 0});
        session().addPin({200, 80, 0});
        QVERIFY(settle(session()));
    }
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Animate);
    settleLayout(canvas());
}

/// The first handle moves from 0 to 1, the second from 1 to 2, in a film of 4 s.
void TestFilm::openFilm(int dimension) {
    open(dimension);
    const auto next = copyOf(project());
    endOf(*next) = 4;
    Design& design = designOf(*next);
    for (std::size_t h = 0; h < 2; ++h) {
        auto& motions = design.handles[h].motions;
        motions.resize(1);
        const bool isPicture = design.handles.size() == 2 && design.dimension == 2;
        std::get<0>(motions[0].kind).by = Vec3(0, isPicture ? 20 : 0.5, 0);
        motions[0].start = static_cast<double>(h);
        motions[0].end = static_cast<double>(h) + 1;
    }
    session().document().change(QStringLiteral("Film"), next);
    QVERIFY(settle(session()));
}

QPoint TestFilm::pin(int handle) {
    if (session().document().dimension() == 2)
        return m_window->window().canvas().onScreen(session().gestures().pins()[handle].centre).toPoint();
    return m_window->canvas().onScreen(session().gestures().pins()[handle].centre).toPoint();
}

std::size_t TestFilm::motions(int handle) {
    return designOf(project()).handles[handle].motions.size();
}

/// Makes ten moves, a rest of half a second if there is a pause, and goes back half of the distance.
void TestFilm::record(int handle, Qt::KeyboardModifiers modifiers, int pause) {
    const QPoint from = pin(handle);
    QTest::mouseMove(&canvas(), from);
    QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(&canvas(), from + QPoint(0, 6 * i), 20);
    if (pause > 0) QTest::mouseMove(&canvas(), from + QPoint(0, 54), pause);
    for (int i = 8; i >= 5; --i) QTest::mouseMove(&canvas(), from + QPoint(0, 6 * i), 20);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, from + QPoint(0, 30), 20);
    QVERIFY(settle(session()));
}

/// The recording lasts as long as the events, including the rest, begins at the shown time, and the film
/// returns to that time.
void TestFilm::recordsWhatTheHandDoes() {
    QFETCH(int, dimension);
    open(dimension);
    record(1, Qt::ControlModifier, 500);
    QCOMPARE(motions(1), std::size_t(1));
    QCOMPARE(session().playback().time(), 0.0);
    const MotionTime time = timeOf(designOf(project()), 1, 0);
    QCOMPARE(time.start, 0.0);
    QCOMPARE(time.end, endOf(project()));
    // The clock of the events runs at least as long as their pauses.
    QVERIFY2(time.end > 0.7 && time.end < 1.5, qPrintable(QString::number(time.end)));
    QCOMPARE(session().document().undoStack()->undoText().left(6), QString("Record"));
    session().playback().setTime(session().playback().end());
    QVERIFY(settle(session()));
    session().document().undoStack()->undo();
    QCOMPARE(motions(1), std::size_t(0));
}

void TestFilm::recordsWithTheSwitch() {
    open(2);
    QAction* switchOn = m_window->window().actions().record;
    switchOn->trigger();
    record(1, Qt::NoModifier, 300);
    QCOMPARE(session().playback().time(), 0.0);
    QVERIFY(endOf(project()) > 0.4 && endOf(project()) != 1.0);
    switchOn->trigger();
    const double end = endOf(project());
    session().playback().setTime(end);
    record(1, Qt::NoModifier);
    QCOMPARE(endOf(project()), end + 1);  // what was recorded keeps its times
    QCOMPARE(motions(1), std::size_t(2));
}

void TestFilm::othersGoOnWhileOneIsRecorded() {
    openFilm(2);
    session().playback().setTime(0);
    QVERIFY(settle(session()));
    const MotionTime before = timeOf(designOf(project()), 0, 0);
    record(1, Qt::ControlModifier, 200);
    QCOMPARE(timeOf(designOf(project()), 0, 0), before);
    QCOMPARE(endOf(project()), 4.0);
    QCOMPARE(motions(1), std::size_t(1));  // its own, which was later, is replaced
    QCOMPARE(timeOf(designOf(project()), 1, 0).start, 0.0);
}

/// A plain drag at an earlier time replaces only the later motions of the dragged handle, with a notice. The
/// poses before it are the same, the others keep their times, and the film its length.
void TestFilm::dragsLeaveOthersAlone() {
    QFETCH(int, dimension);
    openFilm(dimension);
    m_window->window().actions().poseHere->setChecked(false);
    const auto poseAt = [&](double time) -> Eigen::MatrixXd {
        session().playback().setTime(time);
        if (!settle(session())) return {};
        if (dimension == 2) return session().motion().frame<2>()->pose;
        return session().motion().frame<3>()->pose;
    };
    const Eigen::MatrixXd early = poseAt(0.25), shown = poseAt(0.5), later = poseAt(3);
    QStringList told;
    connect(&session().document(), &Document::notice, this, [&told](const QString& text) { told << text; });
    const auto before = session().document().project();
    const auto dragAt = [&](double time, int handle) {
        session().playback().setTime(time);
        QVERIFY(settle(session()));
        record(handle, Qt::NoModifier);
    };
    dragAt(0.5, 0);
    QCOMPARE(timeOf(designOf(project()), 0, 0), (MotionTime{0, 0.5}));
    QCOMPARE(timeOf(designOf(project()), 0, 1), (MotionTime{0.5, 4}));
    QCOMPARE(timeOf(designOf(project()), 1, 0), (MotionTime{1, 2}));
    QCOMPARE(motions(1), std::size_t(1));
    QCOMPARE(endOf(project()), 4.0);
    QCOMPARE(session().playback().time(), 4.0);
    QVERIFY(told.size() == 1 && told[0].contains("replaces what"));
    // The integrator begins anew where the drag begins: they are the same but for its error.
    const double error = dimension == 2 ? 0.05 : 1e-3;
    QVERIFY((poseAt(0.25) - early).cwiseAbs().maxCoeff() < error);
    QVERIFY((poseAt(0.5) - shown).cwiseAbs().maxCoeff() < error);
    QVERIFY((poseAt(3) - later).cwiseAbs().maxCoeff() > 0.01);
    session().document().undoStack()->undo();
    QVERIFY(session().document().project() == before && settle(session()));
    // A drag that replaces nothing gives no notice, and arrow keys continue its step.
    told.clear();
    dragAt(3, 1);
    QCOMPARE(timeOf(designOf(project()), 1, 1), (MotionTime{3, 4}));
    QCOMPARE(timeOf(designOf(project()), 0, 0), (MotionTime{0, 1}));
    QVERIFY(told.isEmpty());
    session().document().undoStack()->undo();
    session().playback().setTime(3);
    QVERIFY(settle(session()));
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(&canvas(), Qt::Key_Down);
        QVERIFY(settle(session()));
    }
    QCOMPARE(motions(1), std::size_t(2));
    QCOMPARE(timeOf(designOf(project()), 1, 1), (MotionTime{3, 4}));
    QCOMPARE(timeOf(designOf(project()), 0, 0), (MotionTime{0, 1}));
}

/// At half the speed the same gesture takes half as much of the film.
void TestFilm::recordsByTheClockOfTheFilm() {
    open(2);
    record(1, Qt::ControlModifier, 400);
    const double whole = endOf(project());
    session().document().undoStack()->undo();
    QVERIFY(settle(session()));
    const QList<QAction*> speeds = m_window->window().actions().speed->actions();
    QCOMPARE(speeds.size(), 4);
    speeds[1]->trigger();
    QVERIFY(m_window->window().actions().speed->title().contains("50"));
    record(1, Qt::ControlModifier, 400);
    QVERIFY2(std::abs(endOf(project()) / whole - 0.5) < 0.02,
             qPrintable(QString::number(endOf(project()) / whole)));
}

/// While the pointer rests in a recording the other pin moves on, and the time is shown; giving up restores
/// everything.
void TestFilm::otherPinsMoveDuringARecording() {
    QFETCH(int, dimension);
    openFilm(dimension);
    session().playback().setTime(0);
    QVERIFY(settle(session()));
    const auto other = [&] { return session().gestures().pins()[0].centre.y(); };
    const double begin = other();
    const QPoint from = pin(1);
    QTest::mouseMove(&canvas(), from);
    QTest::mousePress(&canvas(), Qt::LeftButton, Qt::ControlModifier, from);
    for (int i = 1; i <= 3; ++i) QTest::mouseMove(&canvas(), from + QPoint(0, 6 * i), 20);
    QVERIFY(session().gestures().drag() && session().gestures().drag()->records());
    const double whole = dimension == 2 ? 20 : 0.5;
    QVERIFY(QTest::qWaitFor([&] { return other() > begin + 0.5 * whole; }, 20000));
    QVERIFY(session().playback().time() >= 0.5);
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, Qt::ControlModifier, from);
    QVERIFY(settle(session()));
    QCOMPARE(session().playback().time(), 0.0);
    QVERIFY(std::abs(other() - begin) < 1e-9);
}

/// At a hundred times the speed even a long film is over at once.
void TestFilm::playsAtItsSpeed() {
    Playback playback;
    playback.setEnd(1e6);
    playback.setTime(0);
    playback.setReady(1e6);
    playback.setSpeed(100);
    playback.setPlaying(true);
    QVERIFY(QTest::qWaitFor([&] { return playback.time() > 60; }, 20000));
}

/// The start of a bar shorter than the minimum can only be moved away from its end.
void TestFilm::shortBarsKeepTheirPlace() {
    openFilm(2);
    const auto next = copyOf(project());
    auto& motions = designOf(*next).handles[0].motions;
    motions.resize(2, motions[0]);
    motions[0].end = 0.99;
    motions[1].start = 0.99;
    motions[1].end = 1;
    session().document().change(QStringLiteral("Short"), next);
    QVERIFY(settle(session()));
    dragBar(0, 1, tracks().barOf(0, 1).left() - 4, 60);
    QCOMPARE(timeOf(designOf(project()), 0, 1), (MotionTime{0.99, 1}));
    dragBar(0, 1, tracks().barOf(0, 1).left() - 4, -60);
    const MotionTime time = timeOf(designOf(project()), 0, 1);  // the key goes, the end stays
    QVERIFY(time.start < 0.99 && time.end == 1);
    QCOMPARE(timeOf(designOf(project()), 0, 0).end, time.start);
}

void TestFilm::givenUpRecordingLeavesNothing() {
    open(2);
    const auto before = session().document().project();
    const QPoint from = pin(1);
    QTest::mousePress(&canvas(), Qt::LeftButton, Qt::ControlModifier, from);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&canvas(), from + QPoint(0, 6 * i), 20);
    QVERIFY(session().motion().isDragging());
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, Qt::ControlModifier, from);
    QCOMPARE(session().document().project(), before);
}

void TestFilm::tracksAreThereInTheirStep() {
    open(2);
    QVERIFY(tracks().isVisible());
    QVERIFY(!tracks().accessibleName().isEmpty());
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Paint);
    QVERIFY(!tracks().isVisible());
}

void TestFilm::dragBar(int handle, int motion, double fromX, double by) {
    QWidget* area = tracks().viewport();
    const QRectF bar = tracks().barOf(handle, motion);
    const QPoint from(static_cast<int>(std::lround(fromX)), static_cast<int>(bar.center().y()));
    QTest::mousePress(area, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(area, from + QPoint(static_cast<int>(std::lround(by * i / 5)), 0));
    QTest::mouseRelease(area, Qt::LeftButton, {}, from + QPoint(static_cast<int>(std::lround(by)), 0));
    QVERIFY(settle(session()));
}

/// A bar is moved by its middle and made longer or shorter by its ends; the shape follows.
void TestFilm::barsAreDragged() {
    QFETCH(int, dimension);
    openFilm(dimension);
    const double second = span() / 4;
    const double pixel = 4 / span();
    const QRectF bar = tracks().barOf(0, 0);
    QVERIFY(std::abs(bar.width() - second) <= 1);
    const int steps = session().document().undoStack()->count();
    dragBar(0, 0, bar.center().x(), 0.3 * second);
    MotionTime time = timeOf(designOf(project()), 0, 0);
    QVERIFY(std::abs(time.start - 0.3) <= pixel && std::abs(time.end - 1.3) <= pixel);
    QCOMPARE(session().document().undoStack()->count(), steps + 1);
    QCOMPARE(timeOf(designOf(project()), 1, 0), (MotionTime{1, 2}));
    dragBar(0, 0, tracks().barOf(0, 0).right() - 1, 0.4 * second);
    time = timeOf(designOf(project()), 0, 0);
    QVERIFY(std::abs(time.start - 0.3) <= pixel && std::abs(time.end - 1.7) <= 2 * pixel);
    dragBar(0, 0, tracks().barOf(0, 0).left() + 1, 0.2 * second);
    time = timeOf(designOf(project()), 0, 0);
    QVERIFY(std::abs(time.start - 0.5) <= 3 * pixel && std::abs(time.end - 1.7) <= 2 * pixel);
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    // Both ends of its interval are where the handle begins and ends to move.
    session().playback().setTime(time.start - 0.2);
    const auto still = session().motion().frame();
    session().playback().setTime(0);
    QVERIFY(still && session().motion().frame());
    const auto moved = [&] {
        return dimension == 2 ? (posed<2>(still)->pose - session().motion().frame<2>()->pose).norm()
                              : (posed<3>(still)->pose - session().motion().frame<3>()->pose).norm();
    };
    QVERIFY(moved() < 1e-12);
    session().playback().setTime(1.2);
    QVERIFY(moved() > 0.01);
}

/// The ends of the line give the times between which a pin holds, never shorter than its motions.
void TestFilm::holdsAreDragged() {
    QFETCH(int, dimension);
    openFilm(dimension);
    const double second = span() / 4, pixel = 4 / span();
    const double endless = std::numeric_limits<double>::infinity();
    const auto line = [&] { return tracks().barOf(1, TrackView::kHold); };
    const auto hold = [&] { return holdOf(designOf(project()), 1); };
    QCOMPARE(hold(), (MotionTime{-endless, endless}));
    QVERIFY(std::abs(line().width() - 4 * second) <= 1);
    const int steps = session().document().undoStack()->count();
    dragBar(1, TrackView::kHold, line().left(), 0.5 * second);
    QVERIFY(std::abs(hold().start - 0.5) <= pixel && hold().end == endless);
    QCOMPARE(session().document().undoStack()->count(), steps + 1);
    dragBar(1, TrackView::kHold, line().left(), 2 * second);  // its motion begins at 1
    QCOMPARE(hold().start, 1.0);
    dragBar(1, TrackView::kHold, line().right(), -0.7 * second);
    QVERIFY(std::abs(hold().end - 3.3) <= 2 * pixel);
    dragBar(1, TrackView::kHold, line().right(), -3 * second);  // and ends at 2
    QCOMPARE(hold(), (MotionTime{1, 2}));
    QCOMPARE(timeOf(designOf(project()), 1, 0), (MotionTime{1, 2}));
    session().selection().set({0, 1});
    QAction* whole = m_window->window().findChild<PinActions*>()->holdThroughout;
    QVERIFY(whole->isEnabled());
    whole->trigger();
    QVERIFY(settle(session()));
    QCOMPARE(hold(), (MotionTime{-endless, endless}));
    QVERIFY(!whole->isEnabled());
    session().document().undoStack()->undo();
    QCOMPARE(hold(), (MotionTime{1, 2}));
    // A pin set at the end holds only there, and its line is a stop that can be dragged one way only.
    const auto late = copyOf(project());
    designOf(*late) = withHold(designOf(*late), 1, {0, 4}, endOf(*late));
    designOf(*late).handles[1].motions.clear();
    designOf(*late).handles[1].activeFrom = 4;
    session().document().change(QStringLiteral("Late"), late);
    QVERIFY(settle(session()));
    for (const double beside : {-4.0, 4.0}) {
        dragBar(1, TrackView::kHold, line().left() + beside, -second);
        QVERIFY(std::abs(hold().start - 3) <= 3 * pixel);
        session().document().undoStack()->undo();
        QVERIFY(settle(session()));
    }
}

void TestFilm::barsSnapToEachOther() {
    openFilm(2);
    const double second = span() / 4;
    dragBar(0, 0, tracks().barOf(0, 0).center().x(), 1.0 * second + 4);
    QCOMPARE(timeOf(designOf(project()), 0, 0), (MotionTime{1, 2}));  // with the other, exactly
}

void TestFilm::lockedBarsStay() {
    openFilm(2);
    const auto next = copyOf(project());
    designOf(*next).handles[0].traits.locked = true;
    session().document().change(QStringLiteral("Lock"), next);
    QVERIFY(settle(session()));
    dragBar(0, 0, tracks().barOf(0, 0).center().x(), 60);
    QCOMPARE(timeOf(designOf(project()), 0, 0), (MotionTime{0, 1}));
}

void TestFilm::barsByKeyboard() {
    openFilm(2);
    session().playback().setTime(0);
    tracks().setFocus();
    session().selection().clear();
    QTest::keyClick(&tracks(), Qt::Key_Down);
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    QTest::keyClick(&tracks(), Qt::Key_Down);
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QTest::keyClick(&tracks(), Qt::Key_Right);
    QVERIFY(std::abs(session().playback().time() - 0.04) < 1e-12);
    const int steps = session().document().undoStack()->count();
    for (int i = 0; i < 5; ++i) QTest::keyClick(&tracks(), Qt::Key_Right, Qt::AltModifier);
    const MotionTime time = timeOf(designOf(project()), 1, 0);
    QVERIFY(std::abs(time.start - 1.2) < 1e-9 && std::abs(time.end - 2.2) < 1e-9);
    QCOMPARE(session().document().undoStack()->count(), steps + 1);  // keys in a row are one step
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QCOMPARE(motions(1), std::size_t(0));
    QCOMPARE(session().document().design().handles.size(), std::size_t(2));  // the pin stays
    QTest::keyClick(&tracks(), Qt::Key_Up);
    QCOMPARE(motions(0), std::size_t(1));
}

/// A click with Shift or Ctrl adds and removes; the selection is moved, scaled, eased and removed in one step
/// each, without locked bars.
void TestFilm::severalBarsGoTogether() {
    QFETCH(int, dimension);
    openFilm(dimension);
    const double second = span() / 4, pixel = 4 / span();
    const auto click = [&](int handle, Qt::KeyboardModifiers modifiers) {
        QTest::mouseClick(tracks().viewport(), Qt::LeftButton, modifiers,
                          tracks().barOf(handle, 0).center().toPoint());
    };
    const auto isAt = [&](int handle, double start, double end) {
        const MotionTime time = timeOf(designOf(project()), handle, 0);
        return std::abs(time.start - start) <= 2 * pixel && std::abs(time.end - end) <= 2 * pixel;
    };
    click(0, {});
    click(1, Qt::ShiftModifier);
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 1}));
    click(1, Qt::ControlModifier);
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    click(1, Qt::ControlModifier);
    const int steps = session().document().undoStack()->count();
    dragBar(1, 0, tracks().barOf(1, 0).center().x(), 0.5 * second);
    QVERIFY(isAt(0, 0.5, 1.5) && isAt(1, 1.5, 2.5));
    QCOMPARE(session().document().undoStack()->count(), steps + 1);
    dragBar(1, 0, tracks().barOf(1, 0).right() - 1, -second);  // all from 0.5 to 1.5
    QVERIFY(isAt(0, 0.5, 1) && isAt(1, 1, 1.5));
    dragBar(1, 0, tracks().barOf(1, 0).left() + 1, -0.2 * second);  // the end of all stays
    QVERIFY(std::abs(timeOf(designOf(project()), 1, 0).end - 1.5) <= 3 * pixel);
    QVERIFY(std::abs(timeOf(designOf(project()), 1, 0).start - 0.8) <= 3 * pixel);
    QCOMPARE(session().document().undoStack()->count(), steps + 3);
    session().document().undoStack()->setIndex(steps);
    QVERIFY(settle(session()));
    QTest::keyClick(&tracks(), Qt::Key_Right, Qt::AltModifier);
    QVERIFY(timeOf(designOf(project()), 0, 0).start > 0.03 && timeOf(designOf(project()), 1, 0).start > 1.03);
    session().document().undoStack()->undo();
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QVERIFY(motions(0) == 0 && motions(1) == 0);
    QCOMPARE(session().document().undoStack()->count(), steps + 1);
    session().document().undoStack()->undo();
    const auto locked = copyOf(project());
    designOf(*locked).handles[0].traits.locked = true;
    session().document().change(QStringLiteral("Lock"), locked);
    QVERIFY(settle(session()));
    click(0, {});
    click(1, Qt::ShiftModifier);
    dragBar(1, 0, tracks().barOf(1, 0).center().x(), 0.5 * second);
    QVERIFY(isAt(0, 0, 1) && isAt(1, 1.5, 2.5));
    click(1, {});  // without a drag it is chosen alone
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
}

void TestFilm::framesChooseBars() {
    openFilm(2);
    QWidget* area = tracks().viewport();
    const QRectF first = tracks().barOf(0, 0), second = tracks().barOf(1, 0);
    const QPoint from(static_cast<int>(second.right() + 20), static_cast<int>(second.bottom() + 2));
    const auto frameTo = [&](const QPointF& to, Qt::KeyboardModifiers modifiers) {
        QTest::mousePress(area, Qt::LeftButton, modifiers, from);
        QTest::mouseMove(area, (from + to.toPoint()) / 2);
        QTest::mouseMove(area, to.toPoint());
        if (modifiers == Qt::NoModifier) m_window->picture(QStringLiteral("track-frame"));
        QTest::mouseRelease(area, Qt::LeftButton, modifiers, to.toPoint());
    };
    frameTo(second.center(), {});
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    frameTo(first.center(), {});
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 1}));
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QVERIFY(motions(0) == 0 && motions(1) == 0);
    session().document().undoStack()->undo();
    QTest::mousePress(area, Qt::LeftButton, {}, from);
    QTest::mouseMove(area, first.center().toPoint());
    QTest::keyClick(&tracks(), Qt::Key_Escape);
    QTest::mouseRelease(area, Qt::LeftButton, {}, first.center().toPoint());
    QTest::keyClick(&tracks(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(timeOf(designOf(project()), 0, 0), (MotionTime{0, 1}));  // none was chosen
}

void TestFilm::menuOfABar() {
    openFilm(3);
    const QPoint at = tracks().barOf(1, 0).center().toPoint();
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, tracks().viewport()->mapToGlobal(at));
    QCoreApplication::sendEvent(tracks().viewport(), &event);
    auto* menu = tracks().findChild<QMenu*>();
    QVERIFY(menu);
    QTRY_VERIFY(menu->isVisible());
    QList<QAction*> actions;
    for (QAction* action : menu->actions())
        if (!action->isSeparator()) actions << action;
    QCOMPARE(actions.size(), 8);
    QVERIFY(actions[0]->isChecked());
    actions[3]->trigger();
    QCOMPARE(designOf(project()).handles[1].motions[0].ease, Ease::InOut);
    QCOMPARE(designOf(project()).handles[0].motions[0].ease, Ease::Linear);
    actions[7]->trigger();
    QCOMPARE(motions(1), std::size_t(0));
    QCOMPARE(motions(0), std::size_t(1));
    menu->close();
}

namespace {

QString ghostName(ShapeSession& session) {
    const auto ghosts = session.gestures().ghosts();
    if (ghosts.size() != 1) return {};
    const auto& handles = session.document().design().handles;
    return wend::ghostName(handles[ghosts[0].handle], "x", session.playback().time());
}

}  // namespace

/// A pin that does not hold is a faint mark that can be picked and gives the time since or until which it
/// holds.
void TestFilm::ghostsTellWhenTheyHold() {
    QFETCH(int, dimension);
    openFilm(dimension);
    session().document().changeDesign(QStringLiteral("Hold"),
                                      withHold(designOf(project()), 1, {1, 2.5}, endOf(project())));
    QVERIFY(settle(session()));
    const auto name = [&] { return dimension == 2 ? ghostName(session()) : ghostName(session()); };
    session().playback().setTime(0.2);
    QCOMPARE(name(), QStringLiteral("x: holds from 1.00 s"));
    session().playback().setTime(1.5);
    QCOMPARE(name(), QString());
    session().playback().setTime(3);
    QCOMPARE(name(), QStringLiteral("x: released at 2.50 s"));
    session().selection().clear();
    const QPoint at =
        dimension == 2
            ? m_window->window().canvas().onScreen(session().gestures().ghosts()[0].centre).toPoint()
            : m_window->canvas().onScreen(session().gestures().ghosts()[0].centre).toPoint();
    const auto around = [&] {
        return canvas().grab(QRect(at - QPoint(8, 8), at + QPoint(120, 8))).toImage();
    };
    QTest::mouseMove(&canvas(), at + QPoint(0, 60));
    const QImage before = around();
    QTest::mouseMove(&canvas(), at);
    QVERIFY(around() != before);  // with its name beside
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at);
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    const auto* place = m_window->window().findChild<QLabel*>(QStringLiteral("pinPlace"));
    QCOMPARE(place->text(), QStringLiteral("does not hold now"));
    session().playback().setTime(1.5);
    QVERIFY(place->text().startsWith(QStringLiteral("at ")));
}

/// The second pin holds until 1: its disc is drawn then, except while the film plays.
void TestFilm::playingShowsTheShapeAlone() {
    QFETCH(int, dimension);
    openFilm(dimension);
    session().selection().clear();
    session().playback().setTime(0.2);
    const auto around = [&, at = pin(1)] {
        return canvas().grab(QRect(at - QPoint(8, 8), at + QPoint(8, 8))).toImage();
    };
    const auto unlike = [](const QImage& a, const QImage& b) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                if (std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 40) ++count;
        return count;
    };
    const QImage still = around();
    session().playback().setSpeed(0.01);
    session().playback().setPlaying(true);
    QVERIFY(unlike(around(), still) > 40);
    session().playback().setPlaying(false);
    QVERIFY(unlike(around(), still) <= 4);
}

void TestFilm::rulerIsScrubbed() {
    openFilm(2);
    QWidget* area = &tracks().ruler();
    const auto at = [&](double time) {
        const double left = tracks().barOf(0, TrackView::kHold).left();
        return QPoint(static_cast<int>(std::lround(left + time * span() / 4)), 8);
    };
    QTest::mousePress(area, Qt::LeftButton, {}, at(1));
    QVERIFY(std::abs(session().playback().time() - 1) < 4 / span());
    QTest::mouseMove(area, at(2.5));
    QVERIFY(std::abs(session().playback().time() - 2.5) < 4 / span());
    QTest::mouseRelease(area, Qt::LeftButton, {}, at(2.5));
    QTest::mouseMove(area, at(1));
    QVERIFY(std::abs(session().playback().time() - 2.5) < 4 / span());
    // A click on the slider below shows the same time.
    QSlider* slider = m_window->window().findChild<TimeStrip*>()->slider();
    for (const double time : {0.0, 1.0, 2.3, 4.0}) {
        const QPoint below = slider->mapFromGlobal(area->mapToGlobal(at(time)));
        QTest::mouseClick(slider, Qt::LeftButton, {}, {below.x(), slider->height() / 2});
        QVERIFY(std::abs(session().playback().time() - time) <= 4 / span() + 4e-4);
    }
}

/// The moving pins are in view when a film is opened, however many others come before them.
void TestFilm::movingPinsAreInViewAtFirst() {
    open(2);
    for (int i = 0; i < 10; ++i) session().addPin({60.0 + 10 * i, 80, 0});
    const auto next = copyOf(project());
    designOf(*next).handles.back().motions = {PinMotion{Translate<3>{{0, 5, 0}}}};
    OpenedFile file;
    file.project = next;
    file.picture = session().document().picture();
    session().document().undoStack()->setClean();
    session().document().open(std::move(file));
    QVERIFY(settle(session()));
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Animate);
    const auto isInView = [&] {
        const QRectF bar = tracks().barOf(11, 0);
        return tracks().isVisible() && bar.top() >= 22 && bar.bottom() <= tracks().viewport()->height();
    };
    QTRY_VERIFY(isInView());
}

/// A pin that is selected on the shape has its row in view.
void TestFilm::manyPinsScroll() {
    openFilm(2);
    for (int i = 0; i < 12; ++i) session().addPin({60.0 + 10 * i, 80, 0});
    QVERIFY(settle(session()));
    QVERIFY(tracks().verticalScrollBar()->maximum() > 0);
    session().selection().set({0});
    QCOMPARE(tracks().verticalScrollBar()->value(), 0);
    session().selection().set({13});
    QCOMPARE(tracks().verticalScrollBar()->value(), tracks().verticalScrollBar()->maximum());
}

/// The canvas is tinted where the shape was, and in another colour where it will be; not while it plays.
void TestFilm::onionSkinShowsPastAndFuture() {
    openFilm(2);
    const auto next = copyOf(project());  // the whole bar goes down, evenly
    for (auto& handle : designOf(*next).handles) {
        std::get<Translate<3>>(handle.motions[0].kind).by = {0, 60, 0};
        handle.motions[0].start = 0, handle.motions[0].end = 4;
    }
    session().document().change(QStringLiteral("Down"), next);
    QVERIFY(settle(session()));
    session().playback().setTime(2);
    ShapeCanvas& canvas = m_window->window().canvas();
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const auto at = [&](double y) {
        const QPoint p = canvas.toWidget({120, y}).toPoint();
        return QColor(canvas.grab().toImage().pixel(p));
    };
    // At rest the bar is from 60 to 100, now from 90 to 130; 0.4 s before and after, 6 higher and lower.
    const QColor above = at(87), below = at(133);
    m_window->window().actions().onionSkin->trigger();
    const QColor past = at(87), future = at(133);
    QVERIFY(past != above && future != below);
    QVERIFY(past.red() - past.blue() > above.red() - above.blue() + 15);      // orange
    QVERIFY(future.blue() - future.red() > below.blue() - below.red() + 15);  // blue
    session().playback().setTime(0);
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const QColor before = at(50);
    m_window->window().actions().onionSkin->trigger();
    QCOMPARE(at(50), before);  // nothing was before the beginning
}

/// The onion skin leaves out the transparent margin that bends with the picture.
void TestFilm::onionSkinLeavesOutTheMargin() {
    openFilm(2);
    const auto next = copyOf(project());
    domainOf(*next).alpha.margin = 16;
    for (auto& handle : designOf(*next).handles) {
        std::get<Translate<3>>(handle.motions[0].kind).by = {0, 60, 0};
        handle.motions[0].start = 0, handle.motions[0].end = 4;
    }
    session().document().change(QStringLiteral("Down"), next);
    QVERIFY(settle(session()));
    session().playback().setTime(2);
    session().selection().clear();
    ShapeCanvas& canvas = m_window->window().canvas();
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const auto grabbed = [&] { return canvas.grab().toImage(); };
    const QImage without = grabbed();
    m_window->window().actions().onionSkin->trigger();
    const QImage with = grabbed();
    const auto isTinted = [&](double x, double y) {
        const QPoint p = canvas.toWidget({x, y}).toPoint();
        return without.pixel(p) != with.pixel(p);
    };
    // The bar is from 90 to 130 now, 18 higher at the farthest; the mesh begins 16 above that.
    for (const double x : {60.0, 120.0, 180.0}) {
        QVERIFY(isTinted(x, 87) && isTinted(x, 75) && isTinted(x, 145));
        for (const double y : {58.0, 62.0, 66.0, 154.0, 160.0}) QVERIFY(!isTinted(x, y));
    }
    m_window->window().actions().onionSkin->trigger();
}

void TestFilm::onionSkinOfASolid() {
    openFilm(3);
    session().playback().setTime(2);
    QVERIFY(settle(session()));
    SolidCanvas& canvas = m_window->canvas();
    const auto marks = [&] {
        QImage image(canvas.size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        canvas.overlay().paintMarks(painter);
        return image;
    };
    const QImage without = marks();
    m_window->window().actions().onionSkin->trigger();
    const QImage with = marks();
    int orange = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x) {
            const QColor colour = with.pixelColor(x, y);
            if (with.pixel(x, y) != without.pixel(x, y) && colour.red() > colour.blue() + 30) ++orange;
        }
    QVERIFY2(orange > 200, qPrintable(QString::number(orange)));
    session().playback().setPlaying(true);
    const QImage playing = marks();
    m_window->window().actions().onionSkin->trigger();
    QVERIFY(marks() == playing);
    session().playback().setPlaying(false);
}

namespace {

/// Returns the influence in percent over the vertices of the shown frame: the least, the largest, and that at
/// a handle.
template <int Dim>
std::array<double, 3> influence(ShapeSession& session, int handle) {
    const Eigen::MatrixXd field = session.motion().influence();
    if (field.cols() == 0) return {-1, -1, -1};
    const Points<Dim>& pose = session.motion().frame<Dim>()->pose;
    Eigen::Index nearest = 0;
    (pose.colwise() - session.gestures().pins()[handle].centre.head<Dim>())
        .colwise()
        .norm()
        .minCoeff(&nearest);
    return {100 * field.row(0).minCoeff(), 100 * field.row(0).maxCoeff(), 100 * field(0, nearest)};
}

}  // namespace

/// The selected pin has full influence at its place and none where the other one holds; with both selected
/// the whole shape follows.
void TestFilm::influenceOfPins() {
    QFETCH(int, dimension);
    open(dimension);
    DistortionPanel& maps = m_window->window().distortionPanel();
    maps.setMeasure(Measure::Influence);
    m_window->window().actions().showMap->setChecked(true);
    const auto of = [&](int handle) {
        return dimension == 2 ? influence<2>(session(), handle) : influence<3>(session(), handle);
    };
    const auto select = [&](const std::vector<int>& handles) {
        session().selection().set(handles);
        return QTest::qWaitFor([&] { return of(0)[0] >= 0; }, 20000);
    };
    QVERIFY(select({1}));
    QVERIFY(of(1)[2] > 90 && of(0)[2] < 10);
    QVERIFY(of(0)[0] >= 0 && of(1)[1] < 200);
    const std::vector<double> one = shownValues(session().motion(), Measure::Influence);
    QVERIFY(select({0}));
    QVERIFY(of(1)[2] < 10 && of(0)[2] > 90);
    QVERIFY(shownValues(session().motion(), Measure::Influence) != one);
    QVERIFY(select({0, 1}));
    QVERIFY2(std::abs(of(0)[0] - 100) < 1e-3 && std::abs(of(0)[1] - 100) < 1e-3,
             qPrintable(QStringLiteral("%1 %2").arg(of(0)[0]).arg(of(0)[1])));
    session().selection().clear();
    QCOMPARE(of(0)[0], -1.0);
    const std::vector<double> none = shownValues(session().motion(), Measure::Influence);
    QVERIFY(std::ranges::all_of(none, [](double value) { return value == 0; }));
    // The arrows still show its motion.
    m_window->window().actions().showMap->setChecked(false);
    m_window->window().actions().showArrows->setChecked(true);
    QVERIFY(QTest::qWaitFor([&] { return session().motion().hasVelocity(); }, 20000));
}

QTEST_MAIN(TestFilm)
#include "test_film.moc"
