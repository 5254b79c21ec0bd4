#include <QSignalSpy>
#include <QThread>

#include "app/engine/motion/compute_thread.h"
#include "app/engine/motion/motion_pass.h"
#include "app/engine/motion/shape_engine.h"
#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/opening.h"
#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "core/integration/integration_options.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

namespace {

/// Compares up to the rounding of another clock.
bool isNear(const Points2& a, const Points2& b) {
    return a.cols() == b.cols() && (a - b).colwise().norm().maxCoeff() < 1e-6;
}

std::vector<Points2> posesOf(const FrameTrack& track) {
    std::vector<Points2> poses;
    for (const FramePtr& frame : track.frames()) poses.push_back(posed<2>(frame)->pose);
    return poses;
}

}  // namespace

/// The session with its compute thread: the results of gestures, without a window.
class TestCompute : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void opensAtRest();
    void pinsBecomeVertices();
    void elasticFilmsKeepLaterFrames();
    void elasticFilmsFollowMovedEnds();
    void anotherMeshIsTakenBack();
    void dragEndsAsTheCommandLineHasIt();
    void stopsWhileItPrepares();
    void laterDragsContinueTheMotion();
    void otherLengthsKeepThePoses();
    void framesOnTheirWayCount_data();
    void framesOnTheirWayCount();
    void dragsContinueFromTheShownPose();
    void escapeRestores();
    void dragsShowTheirOwnFrames();
    void undoShowsTheEarlierShapeAtOnce();
    void laterPinMovesNothing();
    void nudgesMerge();
    void foldsStopTheHandle();
    void problemsAreReported();
    void outdatedFailuresAreIgnored();
    void cancelGoesBack_data();
    void cancelGoesBack();
    void firstMeshIsCancelled();
    void firstMotionIsCancelled();
    void playbackWaitsForComputedFrames();
    void removedHandlesAreNotSelected();
    void selectionStaysWithItsPins();
    void velocitiesWaitForRequests();
    void newestTargetsStay();
    void closedMailboxStaysInterrupted();
    void nothingOutlivesItsDocument_data();
    void nothingOutlivesItsDocument();
    void closingEndsTheWork();
    void samplesOpen();
    void hullGoesRound();

  private:
    void open();
    template <int Dim>
    void openMoved();
    template <int Dim>
    QString whatIsLeft(const FramePtr& last) const;
    void drag(int handle, const std::vector<Vec2>& way);
    /// Waits until the compute thread is idle and has nothing left to report, with or without a document.
    bool allIsTaken() const {
        const auto* thread = m_session->motion().findChild<ComputeThread*>();
        return thread && QTest::qWaitFor([&] { return thread->isIdle(); }, 60000);
    }
    Points2 commandLinePose() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ShapeSession> m_session;
};

void TestCompute::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_session = std::make_unique<ShapeSession>();
}

void TestCompute::open() {
    OpenedFile file = openFile(writeCutOut(*m_folder));
    auto project = copyOf(*file.project);
    domainOf(*project).vertices = 400;
    file.project = project;
    m_session->document().open(std::move(file));
    QVERIFY(settle(*m_session));
}

void TestCompute::drag(int handle, const std::vector<Vec2>& way) {
    m_session->selection().set({handle});
    m_session->gestures().begin();
    for (const Vec2& offset : way) m_session->gestures().moveBy(inSpace(offset));
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
}

/// The shape at the end as a fresh deformer makes it of the shape, in one run.
Points2 TestCompute::commandLinePose() const {
    const auto project = m_session->document().project();
    const auto shape = std::get<Shape<2>>(loadShape(*project, m_folder->path().toStdString()));
    Deformer<2> deformer(shape.rest, shape.material, heldHandles(*project, shape), integrationOf(*project));
    deformer.advance(endOf(*project));
    return deformer.state().points;
}

void TestCompute::opensAtRest() {
    open();
    const auto frame = m_session->motion().frame<2>();
    QVERIFY(frame->pose == frame->rest->points);
    QCOMPARE(frame->distortion->flips, 0);
    QVERIFY(std::abs(frame->rest->vertexCount() - 400) <= 40);
    QCOMPARE(m_session->playback().end(), 0.0);
}

void TestCompute::pinsBecomeVertices() {
    open();
    const Vec2 at(61.25, 79.5);
    QCOMPARE(m_session->addPin(inSpace(at)), 0);
    QVERIFY(settle(*m_session));
    const auto& points = m_session->motion().frame<2>()->rest->points;
    QCOMPARE((points.colwise() - at).colwise().norm().minCoeff(), 0.0);
    QCOMPARE(m_session->gestures().pins().size(), std::size_t(1));
    QCOMPARE(m_session->addPin({5, 5, 0}), -1);  // beside the shape
    m_session->removeSelected();
    QVERIFY(m_session->document().design().handles.empty());
}

void TestCompute::dragEndsAsTheCommandLineHasIt() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 5}, {-4, 14}, {-10, 25}});
    QCOMPARE(m_session->playback().time(), 1.0);
    QVERIFY(!m_session->motion().frame()->live);
    const Points2 expected = commandLinePose();
    QVERIFY(m_session->motion().frame<2>()->pose == expected);
    const auto pins = m_session->gestures().pins();
    QVERIFY((pins[1].centre - Vec3(190, 105, 0)).norm() < 1e-9);
    QVERIFY(m_session->motion().frame()->pinError < 1e-9);
}

/// A request to stop does not wait for the analysis of the system; an analysis that is complete by then
/// serves the next motion, with the same bits as one that was never stopped.
void TestCompute::stopsWhileItPrepares() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 5}, {-4, 14}});
    const auto first = m_session->document().project();
    const auto shape = *m_session->motion().frame<2>()->built;
    drag(1, {{0, 5}});
    const auto second = m_session->document().project();
    MotionPass<2> pass;
    std::vector<Points2> frames;
    MotionPass<2>::Sink sink;
    sink.onFrame = [&](const State<2>& state, double) { frames.push_back(state.points); };
    sink.progress = [](double, double) {};
    std::stop_source stopped;
    stopped.request_stop();
    pass.set(shape, first);
    for (int i = 0; i < 3; ++i) pass.run(sink, stopped.get_token());
    QVERIFY(!pass.isFinished());
    QVERIFY(frames.size() == 1 && frames[0] == shape.rest->points);
    pass.set(shape, second);
    pass.run(sink, {});
    QVERIFY(pass.isFinished());
    QCOMPARE(pass.result().outcome, Outcome::Done);
    MotionPass<2> straight;
    straight.set(shape, second);
    straight.run(sink, {});
    QVERIFY(pass.state().points == straight.state().points);
    // An impossible motion is reported where it is run, not in the thread that detected it.
    auto impossible = copyOf(*second);
    designOf(*impossible).handles[0].at = std::vector<Vec3>{{-500, -500, 0}};
    pass.set(shape, impossible);
    QVERIFY_THROWS_EXCEPTION(InputError, pass.run(sink, {}));
}

/// In an elastic film only the part that a change affects is computed again: the frames before and after it
/// are reused, and those between agree with a computation from the start. A flow depends on its path.
void TestCompute::elasticFilmsKeepLaterFrames() {
    for (const bool elastic : {true, false}) {
        open();
        m_session->addPin({40, 80, 0});
        m_session->addPin({200, 80, 0});
        m_session->addPin({120, 80, 0});
        const auto film = copyOf(*m_session->document().project());
        endOf(*film) = 4;
        designOf(*film).material.memory = elastic ? std::numeric_limits<double>::infinity() : 0;
        auto& handles = designOf(*film).handles;
        handles[1].motions = {{Translate<3>{{0, 20, 0}}, 0, 1, Ease::InOut},
                              {Translate<3>{{-10, 5, 0}}, 1, 2, Ease::InOut},
                              {Translate<3>{{5, -15, 0}}, 2, 3.5, Ease::InOut}};
        handles[2].motions = {{Translate<3>{{0, -12, 0}}, 0.4, 2.6, Ease::InOut}};
        m_session->document().change({}, film);
        QVERIFY(settle(*m_session));
        const auto before = m_session->motion().track().frames();
        // The pose at 1 s affects the time before 2 s.
        for (const Vec3& by : {Vec3(4, 3, 0), Vec3(-6, 9, 0)}) {
            const auto next = copyOf(*m_session->document().project());
            auto& own = designOf(*next).handles[1].motions;
            std::get<Translate<3>>(own[0].kind).by += by;
            std::get<Translate<3>>(own[1].kind).by -= by;
            m_session->document().change({}, next);
        }
        QVERIFY(settle(*m_session));
        const auto after = m_session->motion().track().frames();
        QCOMPARE(after.size(), before.size());
        int kept = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            QCOMPARE(after[i]->time, before[i]->time);
            kept += after[i] == before[i];
            if (after[i]->time > 2 + 1e-9) QCOMPARE(after[i] == before[i], elastic);
            if (after[i]->time > 0.1 && after[i]->time < 1.9) QVERIFY(after[i] != before[i]);
        }
        QVERIFY(!elastic || kept > 40);
        MotionPass<2> fresh;
        MotionPass<2>::Sink sink;
        std::size_t i = 0;
        double worst = 0;
        sink.onFrame = [&](const State<2>& state, double) {
            const auto own = posed<2>(after.at(i++));
            QCOMPARE(own->time, state.time);
            worst = std::max(worst, (own->pose - state.points).cwiseAbs().maxCoeff());
        };
        sink.progress = [](double, double) {};
        fresh.set(*posed<2>(after[0])->built, m_session->document().project());
        fresh.run(sink, {});
        QCOMPARE(i, after.size());
        QVERIFY2(worst < (elastic ? 1e-5 : 1e-12), qPrintable(QString::number(worst)));  // pixels
    }
}

/// A pose stays where it was put: a change that moves the end for good is computed to the end.
void TestCompute::elasticFilmsFollowMovedEnds() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    const auto film = copyOf(*m_session->document().project());
    endOf(*film) = 2;
    designOf(*film).material.memory = std::numeric_limits<double>::infinity();
    designOf(*film).handles[1].motions = {{Translate<3>{{0, 20, 0}}, 0, 1},
                                          {Translate<3>{{-10, 5, 0}}, 1, 2}};
    m_session->document().change({}, film);
    QVERIFY(settle(*m_session));
    const auto before = m_session->motion().track().frames();
    const auto next = copyOf(*film);
    std::get<Translate<3>>(designOf(*next).handles[1].motions[0].kind).by = {0, 10, 0};
    m_session->document().change({}, next);
    QVERIFY(settle(*m_session));
    QVERIFY(m_session->motion().track().last() != before.back());
    QVERIFY((m_session->motion().frame<2>()->pose - commandLinePose()).cwiseAbs().maxCoeff() < 1e-6);
}

/// The very same frames return: nothing is computed again when a change of the mesh is undone, redone, or
/// cancelled, whether the mesh was ready or not.
void TestCompute::anotherMeshIsTakenBack() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 5}, {-4, 14}, {-10, 25}});
    const auto coarse = m_session->motion().track().frames();
    QUndoStack& undo = *m_session->document().undoStack();
    setVertices(m_session->document(), 900);
    QVERIFY(settle(*m_session));
    const auto fine = m_session->motion().track().frames();
    QVERIFY(fine.back()->vertices > 1.5 * coarse.back()->vertices);
    undo.undo();
    QVERIFY(settle(*m_session));
    QVERIFY(m_session->motion().track().frames() == coarse);
    undo.redo();
    QVERIFY(settle(*m_session));
    QVERIFY(m_session->motion().track().frames() == fine);
    undo.undo();
    QVERIFY(settle(*m_session));
    for (const bool ready : {false, true}) {
        setVertices(m_session->document(), ready ? 1500 : 1300);
        if (ready) QVERIFY(QTest::qWaitFor([&] { return !m_session->motion().isMeshing(); }, 60000));
        m_session->motion().cancelWork();
        QVERIFY(settle(*m_session));
        QVERIFY(m_session->motion().track().frames() == coarse);
        QCOMPARE(m_session->document().domain().vertices, 400);
    }
    // The motion continues from there as if nothing had happened.
    drag(1, {{0, 3}});
    QVERIFY(isNear(m_session->motion().frame<2>()->pose, commandLinePose()));
}

/// The computed frames of the first drag are kept and get other times.
void TestCompute::laterDragsContinueTheMotion() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 6}, {0, 20}});
    const auto shapes = posesOf(m_session->motion().track());
    drag(0, {{3, -8}, {5, -16}});
    QCOMPARE(m_session->document().end(), 1.0);
    QCOMPARE(m_session->playback().end(), 1.0);
    QVERIFY(isNear(m_session->motion().frame<2>()->pose, commandLinePose()));
    const auto later = posesOf(m_session->motion().track());
    QVERIFY(later.size() > shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) QVERIFY(later[i] == shapes[i]);
    const double border = m_session->document().design().handles[0].motions[0].start;
    QVERIFY(std::abs(m_session->motion().track().frames()[shapes.size() - 1]->time - border) < 1e-9);
}

/// A longer or shorter film has the same poses; missing frames are added where it has too few.
void TestCompute::otherLengthsKeepThePoses() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 6}, {0, 20}});
    const Points2 end = m_session->motion().frame<2>()->pose;
    for (const double length : {0.5, 5.0}) {
        setLength(m_session->document(), length);
        QVERIFY(settle(*m_session));
        QCOMPARE(m_session->playback().end(), length);
        QCOMPARE(m_session->playback().time(), length);
        QVERIFY(isNear(m_session->motion().frame<2>()->pose, end));
        QVERIFY(isNear(m_session->motion().frame<2>()->pose, commandLinePose()));
        QVERIFY(m_session->motion().track().frames().size() >= 24 * length);
    }
}

void TestCompute::framesOnTheirWayCount_data() {
    QTest::addColumn<double>("factor");
    QTest::newRow("the same") << 1.0;
    QTest::newRow("another length") << 0.5;
}

/// Results that the window has not taken when it asks for the next ones are not repeated: the next ones hold
/// only the new part.
void TestCompute::framesOnTheirWayCount() {
    QFETCH(double, factor);
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 20}});
    const auto poses = posesOf(m_session->motion().track());
    double end = m_session->playback().end();
    for (int i = 0; i < 2; ++i) {
        end *= factor;
        setLength(m_session->document(), end);
        QThread::msleep(500);  // the thread is done, and nobody has heard of it
    }
    QVERIFY(settle(*m_session));
    QCOMPARE(m_session->motion().track().lastTime(), end);
    QCOMPARE(posesOf(m_session->motion().track()).size(), poses.size());

    OpenedFile file = openFile(writeCutOut(*m_folder));  // and what is all new
    m_session->document().open(std::move(file));
    QThread::msleep(500);
    m_session->document().change("Again", m_session->document().project());
    QVERIFY(settle(*m_session));
}

/// A drag continues from the visible place of the pin; the pin's later motions are replaced, with a notice,
/// and restored by undo. Other pins continue.
void TestCompute::dragsContinueFromTheShownPose() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 10}, {0, 40}});
    drag(0, {{0, -10}});
    const auto before = m_session->document().project();
    m_session->playback().setTime(0.4);
    const Vec3 seen = m_session->gestures().pins()[1].centre;
    const Points2 pose = m_session->motion().frame<2>()->pose;
    QVERIFY(seen.y() > 85 && seen.y() < 115);
    QSignalSpy notices(&m_session->document(), &Document::notice);
    m_session->selection().set({1});
    m_session->gestures().begin();
    m_session->gestures().moveBy({-8, 0, 0});
    QVERIFY(QTest::qWaitFor([&] { return m_session->motion().frame()->live; }, 20000));
    QVERIFY((m_session->gestures().pins()[1].centre - (seen - Vec3(8, 0, 0))).norm() < 1e-9);
    QVERIFY((m_session->motion().frame<2>()->pose - pose).colwise().norm().maxCoeff() < 20);
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    QCOMPARE(notices.size(), 1);
    QCOMPARE(m_session->playback().time(), 1.0);
    QVERIFY((m_session->gestures().pins()[1].centre - (seen - Vec3(8, 0, 0))).norm() < 1e-6);
    QVERIFY((m_session->gestures().pins()[0].centre - Vec3(40, 70, 0)).norm() < 1e-6);  // what it did stays
    QVERIFY(isNear(m_session->motion().frame<2>()->pose, commandLinePose()));
    m_session->document().undoStack()->undo();
    QVERIFY(m_session->document().project() == before);
    QVERIFY(settle(*m_session));
    QVERIFY(isNear(m_session->motion().frame<2>()->pose, commandLinePose()));
}

void TestCompute::escapeRestores() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    QVERIFY(settle(*m_session));
    const Points2 before = m_session->motion().frame<2>()->pose;
    const int steps = m_session->document().undoStack()->count();
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 20, 0});
    QVERIFY(QTest::qWaitFor([&] { return m_session->motion().frame()->live; }, 20000));
    QVERIFY(m_session->motion().frame<2>()->pose != before);
    m_session->motion().dragTo({0, 25, 0}, 2, {});  // its frame comes too late
    m_session->gestures().cancel();
    QVERIFY(m_session->motion().frame<2>()->pose == before);
    QVERIFY(allIsTaken());
    QVERIFY(m_session->motion().frame<2>()->pose == before);
    QCOMPARE(m_session->document().undoStack()->count(), steps);
}

/// A frame of a cancelled drag that arrives during the next one does not move the shape.
void TestCompute::dragsShowTheirOwnFrames() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    QVERIFY(settle(*m_session));
    const FramePtr before = m_session->motion().frame();
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 20, 0});
    m_session->gestures().cancel();
    m_session->gestures().begin();
    QVERIFY(m_session->motion().isDragging());
    QSignalSpy live(&m_session->motion(), &ShapeMotion::liveReady);
    QVERIFY(allIsTaken());  // with the frame of the first drag
    QVERIFY(live.isEmpty() && m_session->motion().frame() == before);
    m_session->gestures().moveBy({0, 5, 0});
    QVERIFY(QTest::qWaitFor([&] { return m_session->motion().frame()->amount == Amount(0, 5, 0); }, 20000));
    m_session->gestures().cancel();
}

void TestCompute::undoShowsTheEarlierShapeAtOnce() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 20}});
    const Points2 first = m_session->motion().frame<2>()->pose;
    drag(1, {{0, -30}});
    m_session->document().undoStack()->undo();
    QVERIFY(settle(*m_session));
    QCOMPARE(m_session->playback().time(), 1.0);
    QVERIFY(isNear(m_session->motion().frame<2>()->pose, first));
}

void TestCompute::laterPinMovesNothing() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 20}});
    const Points2 before = m_session->motion().frame<2>()->pose;
    const auto rest = m_session->motion().frame<2>()->rest;
    const int added = m_session->addPin(m_session->gestures().pins()[1].centre + Vec3(-60, -2, 0));
    QCOMPARE(added, 2);
    QVERIFY(settle(*m_session));
    QCOMPARE(m_session->motion().frame<2>()->rest, rest);
    QVERIFY(m_session->motion().frame<2>()->pose == before);
    drag(2, {{0, 6}});
    QVERIFY(isNear(m_session->motion().frame<2>()->pose, commandLinePose()));
    const auto pins = m_session->gestures().pins();
    QVERIFY((pins[1].centre - Vec3(200, 100, 0)).norm() < 1e-9);  // the others held still
}

void TestCompute::nudgesMerge() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    const int steps = m_session->document().undoStack()->count();
    for (int i = 0; i < 4; ++i) m_session->gestures().nudge({1, 0, 0});
    QVERIFY(settle(*m_session));
    QCOMPARE(m_session->document().undoStack()->count(), steps + 1);
    QVERIFY((m_session->gestures().pins()[1].centre - Vec3(204, 80, 0)).norm() < 1e-9);
}

/// One pin dragged through the other cannot arrive without a fold. The flow is used, since an elastic shape
/// may snap past it.
void TestCompute::foldsStopTheHandle() {
    open();
    changeSetting(m_session->document(), "material.memory", 0);
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    QVERIFY(settle(*m_session));
    QSignalSpy notices(&m_session->document(), &Document::notice);
    m_session->selection().set({1});
    m_session->gestures().begin();
    for (int i = 1; i <= 40 && notices.isEmpty(); ++i) {
        m_session->gestures().moveBy({-5.0 * i, 0, 0});
        QVERIFY(QTest::qWaitFor(
            [&] { return !notices.isEmpty() || m_session->motion().frame()->sample == i; }, 60000));
    }
    QVERIFY(QTest::qWaitFor([&] { return !notices.isEmpty(); }, 20000));
    QVERIFY(notices.first().first().toString().startsWith(QStringLiteral("Pin 2")));
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    QCOMPARE(m_session->motion().frame()->distortion->flips, 0);
    QVERIFY(m_session->gestures().pins()[1].centre.x() > 40);
}

void TestCompute::problemsAreReported() {
    open();
    const Points2 before = m_session->motion().frame<2>()->pose;
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem);
    test::addPin(m_session->document(), {5, 5}, "stray");
    QVERIFY(QTest::qWaitFor([&] { return !problems.isEmpty(); }, 20000));
    QVERIFY(!problems.first().first().toString().isEmpty());
    QVERIFY(m_session->motion().frame<2>()->pose == before);  // the last good shape stays
    m_session->document().undoStack()->undo();
    QVERIFY(settle(*m_session));
    QVERIFY(problems.last().first().toString().isEmpty());
}

/// The failure of an earlier request, which may arrive after the next request, affects neither the shape nor
/// a drag.
void TestCompute::outdatedFailuresAreIgnored() {
    open();
    m_session->addPin({40, 80, 0});
    QVERIFY(settle(*m_session));
    const FramePtr before = m_session->motion().frame();
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem);
    m_session->gestures().begin();
    QVERIFY(m_session->motion().isDragging());
    auto* thread = m_session->motion().findChild<ComputeThread*>();
    emit thread->failed(0, QStringLiteral("outdated"), ComputeFailure::Shapeless);
    QVERIFY(problems.isEmpty() && !m_session->motion().hasFailed());
    QVERIFY(m_session->motion().frame() == before && m_session->motion().isDragging());
    m_session->gestures().cancel();
}

void TestCompute::cancelGoesBack_data() {
    QTest::addColumn<QString>("key");
    QTest::newRow("a step of its own") << QString();
    QTest::newRow("merged with the step before") << QStringLiteral("vertices");
}

/// Cancelling restores the previous mesh and setting, wherever the undo stack is.
void TestCompute::cancelGoesBack() {
    QFETCH(QString, key);
    open();
    const auto vertices = [this](int count) {
        const auto next = copyOf(*m_session->document().project());
        domainOf(*next).vertices = count;
        return next;
    };
    m_session->document().change(QStringLiteral("A"), vertices(401), key);
    QVERIFY(settle(*m_session));
    const auto rest = m_session->motion().frame<2>()->rest;
    m_session->document().change(QStringLiteral("B"), vertices(90000), key);
    QVERIFY(m_session->motion().isBusy() && m_session->motion().isMeshing());
    m_session->motion().cancelWork();
    QCOMPARE(m_session->document().domain().vertices, 401);
    QVERIFY(settle(*m_session));
    QVERIFY(m_session->motion().frame<2>()->rest == rest);  // not made anew
    QCOMPARE(m_session->document().undoStack()->canRedo(), key.isEmpty());
    m_session->motion().cancelWork();  // nothing is being done
    QCOMPARE(m_session->document().domain().vertices, 401);
}

/// There is no previous mesh to restore: the document stays, and any change makes a mesh.
void TestCompute::firstMeshIsCancelled() {
    OpenedFile file = openFile(writeCutOut(*m_folder));
    auto project = copyOf(*file.project);
    domainOf(*project).vertices = 90000;
    file.project = project;
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem);
    m_session->document().open(std::move(file));
    m_session->motion().cancelWork();
    QVERIFY(!m_session->motion().isBusy());
    QCOMPARE(problems.count(), 1);
    setVertices(m_session->document(), 300);
    QVERIFY(settle(*m_session));
    QVERIFY(std::abs(m_session->motion().frame<2>()->rest->vertexCount() - 300) <= 40);
    QCOMPARE(problems.last().first().toString(), QString());  // taken back
}

/// A change before the first motion is complete leaves the mesh as it is: cancelling affects only the motion.
void TestCompute::firstMotionIsCancelled() {
    OpenedFile file = openFile(writeCutOut(*m_folder));
    auto project = copyOf(*file.project);
    for (const double x : {40.0, 200.0}) {
        Pin handle;
        handle.at = std::vector<Vec3>{{x, 80, 0}};
        handle.motions = {{Translate<3>{{0, x / 4, 0}}, 0, 60}};
        designOf(*project).handles.push_back(handle);
    }
    endOf(*project) = 60;
    file.project = project;
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem);
    m_session->document().open(std::move(file));
    QVERIFY(QTest::qWaitFor(
        [this] { return m_session->motion().frame() && !m_session->motion().isMeshing(); }, 60000));
    if (!m_session->motion().isBusy()) QSKIP("the motion is complete already");
    auto next = copyOf(*m_session->document().project());
    std::get<Translate<3>>(designOf(*next).handles[0].motions[0].kind).by.y() = 5;
    m_session->document().change(QStringLiteral("Move"), next);
    QVERIFY(m_session->motion().isMeshing());
    m_session->motion().cancelWork();
    QVERIFY(problems.last().first().toString().contains(QStringLiteral("motion")));
}

/// The selection stays with its pins when others before them are added, removed or reordered.
void TestCompute::selectionStaysWithItsPins() {
    open();
    for (const double x : {40.0, 120.0, 200.0}) m_session->addPin({x, 80, 0});
    QVERIFY(settle(*m_session));
    m_session->selection().set({2});
    QSignalSpy changes(&m_session->selection(), &Selection::changed);
    Design fewer = m_session->document().design();
    fewer.handles.erase(fewer.handles.begin());
    m_session->document().changeDesign(QStringLiteral("Fewer"), fewer);
    QCOMPARE(m_session->selection().handles(), std::vector<int>{1});
    QCOMPARE(m_session->selection().single(), 1);
    Design turned = fewer;
    std::ranges::reverse(turned.handles);
    m_session->document().changeDesign(QStringLiteral("Turned"), turned);
    QVERIFY(m_session->selection().contains(0) && !m_session->selection().contains(1));
    m_session->document().undoStack()->setIndex(3);
    QCOMPARE(m_session->selection().handles(), std::vector<int>{2});
    QVERIFY(changes.isEmpty());
    m_session->document().undoStack()->setIndex(2);  // before the pin was set
    QVERIFY(m_session->selection().isEmpty() && changes.size() == 1);
}

void TestCompute::removedHandlesAreNotSelected() {
    open();
    m_session->addPin({40, 80, 0});
    const int last = m_session->addPin({200, 80, 0});
    m_session->selection().set({0, last});
    m_session->document().undoStack()->undo();
    QCOMPARE(m_session->selection().handles(), std::vector<int>{0});
    m_session->document().undoStack()->undo();
    QVERIFY(m_session->selection().isEmpty());
    QVERIFY(settle(*m_session));
}

/// Playback waits at the end of the computed part of the motion, and continues when more of it is available.
void TestCompute::playbackWaitsForComputedFrames() {
    Playback playback;
    playback.setEnd(0.2);
    playback.setTime(0);
    constexpr double kReady = 0.0537;  // the clock counts milliseconds: it does not come there by itself
    playback.setReady(kReady);
    playback.setPlaying(true);
    QVERIFY(QTest::qWaitFor([&] { return playback.time() >= kReady; }, 20000));
    QCOMPARE(playback.time(), kReady);
    QVERIFY(playback.isPlaying());
    playback.setReady(0.2);
    QVERIFY(QTest::qWaitFor([&] { return !playback.isPlaying(); }, 20000));
    QCOMPARE(playback.time(), 0.2);
    // It repeats if it loops.
    playback.setLoops(true);
    playback.setPlaying(true);
    int ends = 0;
    const auto count = connect(&playback, &Playback::timeChanged, this,
                               [&](double time) { ends += time == playback.end() ? 1 : 0; });
    QVERIFY(QTest::qWaitFor([&] { return ends >= 2 || !playback.isPlaying(); }, 20000));
    disconnect(count);
    QVERIFY(playback.isPlaying());
}

/// A query is answered when no other request is pending, and is not lost.
void TestCompute::velocitiesWaitForRequests() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    drag(1, {{0, 6}, {0, 20}});
    FramePtr last;
    int answers = 0;
    ShapeEngine::Sink sink;
    sink.shapeReady = [](int, const std::shared_ptr<const void>&, KeptFrames) {};
    sink.progress = [](double, double) {};
    sink.finished = [](double, const std::string&, const std::string&) {};
    sink.frameReady = [&](const FramePtr& frame) { last = frame; };
    sink.fieldReady = [&](int number, const VelocityPtr& field) {
        QVERIFY(number == 7 && field->cols() == last->vertices && !field->isZero(0));
        ++answers;
    };
    const auto engine = ShapeEngine::make(2, sink);
    const Document& document = m_session->document();
    engine->setShape({{document.generation(), 1, document.project(), document.picture(),
                       document.folder().toStdString()}});
    while (!engine->isIdle()) engine->work({});
    QVERIFY(last);
    engine->askField({last, 1, {}, 7});
    std::stop_source stop;
    stop.request_stop();
    engine->work(stop.get_token());
    QVERIFY(answers == 0 && !engine->isIdle());
    engine->work({});
    QVERIFY(answers == 1 && engine->isIdle());
    engine->askField({last, 2, {}, 7});  // of another shape
    engine->work({});
    QVERIFY(answers == 1 && engine->isIdle());
}

void TestCompute::newestTargetsStay() {
    Mailbox mailbox;
    mailbox.post(BeginDrag{{0}, {}, 1, 1, {}});
    for (int i = 0; i < 5; ++i) mailbox.post(DragTo{Amount(i, 0, 0), i});
    mailbox.post(EndDrag{});
    QVERIFY(mailbox.interruption().stop_requested());
    QVERIFY(std::holds_alternative<BeginDrag>(*mailbox.take(false, {})));
    const auto target = std::get<DragTo>(*mailbox.take(false, {}));
    QCOMPARE(target.amount, Amount(4, 0, 0));
    QCOMPARE(target.sample, 4);
    QVERIFY(std::holds_alternative<EndDrag>(*mailbox.take(false, {})));
    QVERIFY(!mailbox.take(false, {}));
    QVERIFY(!mailbox.interruption().stop_requested());
}

void TestCompute::closedMailboxStaysInterrupted() {
    Mailbox mailbox;
    mailbox.close();
    QVERIFY(mailbox.interruption().stop_requested());
    QVERIFY(mailbox.interruption().stop_requested());
}

/// A mesh from a file, held at one end and moved at the other, shown at the end of its motion.
template <int Dim>
void TestCompute::openMoved() {
    const std::string name = m_folder->path().toStdString() + (Dim == 2 ? "/strip.obj" : "/bar.mesh");
    if constexpr (Dim == 2)
        writeMesh<2>(name, stripMesh(6, 2));
    else
        writeMesh<3>(name, barMesh(4));
    m_session->document().open(openFile(QString::fromStdString(name)));
    QVERIFY(settle(*m_session));
    const auto frame = m_session->motion().frame<Dim>();
    m_session->addHandle(std::vector<int>{0, 1}, "Pin");
    m_session->addHandle(std::vector<int>{frame->vertices - 2, frame->vertices - 1}, "Pin");
    m_session->gestures().moveAtOnce({}, {0.3, 0.2, 0});
    QVERIFY(settle(*m_session));
    QCOMPARE(m_session->playback().time(), 1.0);
}

/// Returns the data of the previous document that a view can still get; empty if there is none.
template <int Dim>
QString TestCompute::whatIsLeft(const FramePtr& last) const {
    const Document& document = m_session->document();
    if (m_session->motion().frame() && document.isEmpty()) return QStringLiteral("a shape of no document");
    if (m_session->motion().frame() && m_session->motion().frame()->shape == last->shape)
        return QStringLiteral("the shape");
    if (m_session->motion().frame<Dim>() && document.dimension() != Dim)
        return QStringLiteral("its dimension");
    if (!m_session->motion().frame() && m_session->motion().isStale()) return QStringLiteral("a stale frame");
    if (m_session->motion().isDragging()) return QStringLiteral("the drag");
    if (!m_session->selection().isEmpty()) return QStringLiteral("the selection");
    if (!m_session->gestures().pins().empty()) return QStringLiteral("pins");
    if (!m_session->motion().frame() && m_session->motion().velocity().cols() > 0)
        return QStringLiteral("the velocity");
    return {};
}

void TestCompute::nothingOutlivesItsDocument_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<bool>("closes");
    QTest::addColumn<QString>("state");
    for (const int dimension : {2, 3})
        for (const bool closes : {true, false})
            for (const char* state : {"standing", "playing", "dragging"})
                QTest::addRow("%dD, %s, %s", dimension, closes ? "closed" : "another file", state)
                    << dimension << closes << state;
}

/// Another document, or none, replaces one with a motion, with signals in any order: at no time is any data
/// of the last one visible.
void TestCompute::nothingOutlivesItsDocument() {
    QFETCH(int, dimension);
    QFETCH(bool, closes);
    QFETCH(QString, state);
    const auto check = [dimension](auto&& use) {
        dimension == 2 ? use.template operator()<2>() : use.template operator()<3>();
    };
    check([this]<int Dim>() { openMoved<Dim>(); });
    const FramePtr last = m_session->motion().frame();
    QVERIFY(last);
    if (state == QStringLiteral("dragging")) {
        m_session->gestures().begin();
        m_session->gestures().moveBy({0.1, 0, 0});
        QVERIFY(QTest::qWaitFor([this] { return m_session->motion().frame()->live; }, 20000));
    }
    m_session->playback().setPlaying(state == QStringLiteral("playing"));
    QStringList left;
    int told = 0;
    const auto look = [&] {
        if (m_session->document().generation() == last->generation) return;
        ++told;
        check([&]<int Dim>() { left << whatIsLeft<Dim>(last); });
    };
    QObject here;
    const ShapeSession& session = *m_session;
    QObject::connect(&session.motion(), &ShapeMotion::frameChanged, &here, look);
    QObject::connect(&session.gestures(), &ShapeGesture::pinsChanged, &here, look);
    QObject::connect(&session.motion(), &ShapeMotion::busyChanged, &here, look);
    QObject::connect(&session.selection(), &Selection::changed, &here, look);
    QObject::connect(&m_session->playback(), &Playback::timeChanged, &here, look);
    QObject::connect(&m_session->playback(), &Playback::endChanged, &here, look);
    QObject::connect(&m_session->playback(), &Playback::playingChanged, &here, look);
    QObject::connect(&session.document(), &Document::opened, &here, look);
    QObject::connect(&session.document(), &Document::projectChanged, &here, look);
    QObject::connect(&session.document(), &Document::titleChanged, &here, look);
    if (closes)
        m_session->document().close();
    else
        m_session->document().open(openFile(writeCutOut(*m_folder)));
    left.removeAll(QString());
    QVERIFY2(left.isEmpty(), qPrintable(left.join(", ")));
    QVERIFY(told > 4);
    QVERIFY(allIsTaken());
    if (!closes) QVERIFY(settle(*m_session));
    left.removeAll(QString());
    QVERIFY2(left.isEmpty(), qPrintable(left.join(", ")));
    QCOMPARE(m_session->playback().end(), 0.0);
    QCOMPARE(m_session->motion().frame() == nullptr, closes);
}

/// Nothing is computed and no signal is emitted after closing.
void TestCompute::closingEndsTheWork() {
    open();
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    QVERIFY(settle(*m_session));
    m_session->gestures().moveAtOnce({}, {0, 40, 0});
    test::addPin(m_session->document(), {5, 5}, "stray");
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem),
        notices(&m_session->document(), &Document::notice);
    m_session->document().close();
    QVERIFY(!m_session->motion().isBusy());
    QVERIFY(allIsTaken());
    QVERIFY(problems.isEmpty() && notices.isEmpty() && !m_session->motion().isBusy() &&
            !m_session->motion().frame());
}

void TestCompute::samplesOpen() {
    const QStringList samples = samplePaths();
    QVERIFY(samples.size() >= 3);
    for (const QString& path : samples) {
        const OpenedFile file = openFile(path);
        const bool solid = dimensionOf(*file.project) == 3;
        QVERIFY2(solid || (file.picture && file.picture->width >= 2000), qPrintable(path));
        QVERIFY2(file.warnings.isEmpty(), qPrintable(file.warnings.join(' ')));
        QVERIFY2(motionEnd(*file.project) > 0, qPrintable(path));
    }
}

void TestCompute::hullGoesRound() {
    const auto hull = convexHull({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}, {1, 2}});
    QCOMPARE(hull.size(), std::size_t(4));
    double area = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
        area += (a.x() * b.y() - b.x() * a.y()) / 2;
    }
    QCOMPARE(area, 4.0);
}

QTEST_GUILESS_MAIN(TestCompute)
#include "test_compute.moc"
