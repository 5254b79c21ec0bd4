#include <QSignalSpy>

#include "app/engine/motion/drag_gesture.h"
#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/session/opening.h"
#include "app/session/settle_step.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/integration/integration_options.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Gestures interrupted by other events: a mesh that is being made, a motion that is being computed, undo,
/// another file.
class TestGestures : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void newPinIsThereAfterACancelledDrag();
    void newPinFollowsBeforeItsMeshIsMade();
    void undoEndsADrag();
    void framesFitTheirMesh();
    void anotherFileEndsADrag();
    void refusedDragsLeaveOthersAlone();
    void dragsNeedNotWaitForTheMotion();
    void lastOfManySamplesIsFollowed();
    void handlesThatAreGoneDoNotMove();
    void handlesThatAreGoneCanBeRemoved();
    void pinSitsWhereItWasClicked();
    void clicksBesideTheShapeAreReported();
    void fixedStepsGoOnAsInTheFile();
    void newPinDoesNotDim();
    void settlingIsAStepOfItsOwn();
    void anotherTimeIsNotThatOfTheDrag();
    void refusedHandlesWaitForTheShape();

  private:
    void open(int vertices = 400);
    bool settled() { return settle(*m_session); }
    const Project& project() { return *m_session->document().project(); }
    void begin(int handle);
    void drag(int handle, const Vec2& way);
    bool follows() {
        return QTest::qWaitFor([&] { return m_session->motion().frame()->live; }, 20000);
    }
    Points2 poseOf(const Project& project) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ShapeSession> m_session;
};

void TestGestures::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_session = std::make_unique<ShapeSession>();
}

void TestGestures::open(int vertices) {
    OpenedFile file = openFile(writeCutOut(*m_folder));
    auto coarse = copyOf(*file.project);
    domainOf(*coarse).vertices = vertices;
    file.project = coarse;
    m_session->document().open(std::move(file));
    QVERIFY(settled());
    m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    QVERIFY(settled());
}

void TestGestures::begin(int handle) {
    m_session->selection().set({handle});
    m_session->gestures().begin();
    QVERIFY(m_session->motion().isDragging());
}

void TestGestures::drag(int handle, const Vec2& way) {
    begin(handle);
    m_session->gestures().moveBy(inSpace(way));
    m_session->gestures().end(0.2);
    QVERIFY(settled());
}

Points2 TestGestures::poseOf(const Project& project) const {
    const auto shape = std::get<Shape<2>>(loadShape(project, m_folder->path().toStdString()));
    Deformer<2> deformer(shape.rest, shape.material, heldHandles(project, shape), integrationOf(project));
    deformer.advance(endOf(project));
    return deformer.state().points;
}

/// The drag may begin at any time: while the request waits, during meshing, or later. The waits are the
/// input: each begins the drag at another moment of the computation.
void TestGestures::newPinIsThereAfterACancelledDrag() {
    open(6000);
    for (const int wait : {0, 1, 5, 20, 60}) {
        const Vec2 at(90.25 + wait, 80.5);
        const int added = m_session->addPin(inSpace(at));
        QTest::qWait(wait);
        begin(added);
        m_session->gestures().cancel();
        QVERIFY(settled());
        const auto& points = m_session->motion().frame<2>()->rest->points;
        QCOMPARE((points.colwise() - at).colwise().norm().minCoeff(), 0.0);
    }
}

void TestGestures::newPinFollowsBeforeItsMeshIsMade() {
    open();
    const auto before = m_session->motion().frame<2>()->rest;
    const int added = m_session->addPin({120.25, 80.5, 0});
    setVertices(m_session->document(), 1000000);  // nobody waits for it: the mesh below takes its place
    begin(added);
    m_session->gestures().moveBy({0, 12, 0});
    QVERIFY(follows());
    QCOMPARE(m_session->motion().frame<2>()->rest, before);
    QVERIFY(m_session->motion().isBusy());
    QVERIFY((m_session->gestures().pins()[2].centre - Vec3(120.25, 92.5, 0)).norm() < 1e-9);
    QVERIFY(m_session->motion().frame()->pinError < 1e-6);
    m_session->gestures().end(0.2);
    setVertices(m_session->document(), 400);
    QVERIFY(settled());
    QVERIFY(m_session->motion().frame<2>()->rest != before);
    QVERIFY(m_session->motion().frame<2>()->pose == poseOf(project()));
}

void TestGestures::undoEndsADrag() {
    open();
    begin(1);
    m_session->gestures().moveBy({0, 8, 0});
    QVERIFY(follows());
    m_session->document().undoStack()->undo();  // the pin that is being dragged
    QVERIFY(!m_session->motion().isDragging());
    m_session->gestures().moveBy({0, 12, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settled());
    QCOMPARE(m_session->document().design().handles.size(), std::size_t(1));
    QVERIFY(!m_session->motion().frame()->live);
    QVERIFY(m_session->motion().frame<2>()->pose == m_session->motion().frame<2>()->rest->points);
}

/// At whatever moment of the computation the pointer moves or the drag ends: the waits are these moments.
void TestGestures::framesFitTheirMesh() {
    open();
    int seen = 0;
    connect(&m_session->motion(), &ShapeMotion::frameChanged, this, [&] {
        const auto frame = m_session->motion().frame<2>();
        if (!frame) return;
        ++seen;
        QCOMPARE(frame->pose.cols(), frame->rest->points.cols());
        QCOMPARE(frame->distortion->angle.size(), frame->rest->cells.size());
    });
    for (int i = 0; i < 6; ++i) {
        const int added = m_session->addPin({70.0 + 15 * i, 80, 0});
        begin(added);
        m_session->gestures().moveBy({0, 3, 0});
        QTest::qWait(7 * i);
        m_session->gestures().moveBy({0, 5, 0});
        if (i % 2)
            m_session->document().undoStack()->undo();
        else
            m_session->gestures().cancel();
        QTest::qWait(3 * i);
    }
    QVERIFY(settled());
    QVERIFY(seen > 6);
}

void TestGestures::anotherFileEndsADrag() {
    open();
    begin(1);
    m_session->gestures().moveBy({0, 8, 0});
    QVERIFY(follows());
    m_session->document().open(openFile(writeCutOut(*m_folder, QStringLiteral("other.png"))));
    QVERIFY(settled());
    QVERIFY(!m_session->motion().frame()->live);
    const int added = m_session->addPin({40, 80, 0});
    begin(added);
    m_session->gestures().moveBy({0, 8, 0});
    QVERIFY(follows());
}

/// A pin within a held part cannot move; others still can.
void TestGestures::refusedDragsLeaveOthersAlone() {
    open();
    m_session->document().changeDesign(
        QStringLiteral("Edit"),
        withHandle(m_session->document().design(), Region<3>(Ball<3>{{110, 80, 0}, 14}), "Block"));
    const int inside = m_session->addPin({112.5, 81.25, 0});
    QVERIFY(settled());
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem);
    begin(inside);
    m_session->gestures().moveBy({5, 0, 0});
    m_session->gestures().end(0.2);
    QVERIFY(QTest::qWaitFor([&] { return !problems.isEmpty(); }, 20000));
    begin(1);
    m_session->gestures().moveBy({0, 8, 0});
    QVERIFY(QTest::qWaitFor([&] { return m_session->motion().frame()->amount == Amount(0, 8, 0); }, 20000));
    QVERIFY(m_session->motion().frame()->live && !m_session->motion().frame()->stopped);
    m_session->gestures().cancel();
    m_session->document().undoStack()->undo();
    QVERIFY(settled());
}

void TestGestures::dragsNeedNotWaitForTheMotion() {
    open(1500);
    drag(1, {0, 10});
    changeSetting(m_session->document(), "integration.tolerance", 1e-12);
    QSignalSpy busy(&m_session->motion(), &ShapeMotion::busyChanged);
    QVERIFY(QTest::qWaitFor([&] { return m_session->playback().time() == 1; }, 20000));
    begin(1);
    m_session->gestures().moveBy({0, 8, 0});
    QVERIFY(follows());
    QVERIFY(m_session->motion().isBusy() && busy.isEmpty());
    m_session->gestures().cancel();
    m_session->document().undoStack()->undo();
    QVERIFY(settled());
}

/// A pointer that moves more often than the screen is drawn, and then rests, has the shape at its last place.
void TestGestures::lastOfManySamplesIsFollowed() {
    open();
    begin(1);
    m_session->gestures().moveBy({0, 1, 0});
    QVERIFY(follows());
    for (int burst = 1; burst <= 3; ++burst) {
        for (int i = 0; i < 10; ++i) m_session->gestures().moveBy({0, 4.0 * burst + 0.1 * i, 0});
        QTRY_COMPARE_WITH_TIMEOUT(m_session->motion().frame()->sample, 1 + 10 * burst, 20000);
        QCOMPARE(m_session->motion().frame()->amount.y(), 4.0 * burst + 0.9);
    }
    m_session->gestures().cancel();
    QVERIFY(settled());
}

void TestGestures::handlesThatAreGoneDoNotMove() {
    open();
    drag(1, {0, 10});
    m_session->selection().set({0});
    m_session->removeSelected();  // let go of at 1
    QVERIFY(settled());
    const auto before = m_session->document().project();
    m_session->selection().set({0});
    QSignalSpy notices(&m_session->document(), &Document::notice);
    m_session->gestures().begin();
    QVERIFY(!m_session->motion().isDragging());
    m_session->gestures().nudge({1, 0, 0});
    QCOMPARE(m_session->document().project(), before);
    QCOMPARE(notices.size(), 2);
    m_session->selection().set({0, 1});  // the other one alone
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 4, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settled());
    QVERIFY(m_session->document().design().handles[0].motions.empty());
    QCOMPARE(m_session->document().design().handles[1].motions.size(), std::size_t(2));
}

void TestGestures::handlesThatAreGoneCanBeRemoved() {
    open();
    drag(1, {0, 10});
    QVERIFY(m_session->gestures().ghosts().empty());
    for (const std::size_t left : {2, 1}) {
        m_session->selection().set({0});
        m_session->removeSelected();
        QCOMPARE(m_session->document().design().handles.size(), left);
        QVERIFY(settled());
        QCOMPARE(m_session->gestures().ghosts().size(), left - 1);  // let go of at first: still to be found
    }
}

/// A pin is placed where it was clicked, even at a time before the end.
void TestGestures::pinSitsWhereItWasClicked() {
    open();
    drag(1, {0, 30});
    const Vec2 far(210, 82);  // of the shape at rest; at the end it is elsewhere
    m_session->playback().setTime(0);
    QVERIFY(m_session->motion().frame<2>()->pose == m_session->motion().frame<2>()->rest->points);
    const int added = m_session->addPin(inSpace(far));
    QCOMPARE(added, 2);
    const auto& points = std::get<std::vector<Vec3>>(m_session->document().design().handles[2].at);
    QVERIFY((inPlane(points[0]) - far).norm() < 1e-9);
}

void TestGestures::clicksBesideTheShapeAreReported() {
    open();
    QSignalSpy notices(&m_session->document(), &Document::notice);
    QCOMPARE(m_session->addPin({5, 5, 0}), -1);
    QCOMPARE(notices.size(), 1);
}

/// The end that fixed steps divide is the project's, however often it was extended.
void TestGestures::fixedStepsGoOnAsInTheFile() {
    open();
    changeSetting(m_session->document(), "integration.method", static_cast<double>(Method::RungeKutta4));
    changeSetting(m_session->document(), "integration.steps", 3);
    drag(1, {0, 10});
    drag(1, {0, 10});
    QCOMPARE(endOf(project()), 1.0);
    const auto read = parseProject(toJson(project()), "memory.wend").project;
    QVERIFY(m_session->motion().frame<2>()->pose == poseOf(*read));
    QVERIFY(m_session->motion().frame<2>()->pose == poseOf(project()));
}

void TestGestures::newPinDoesNotDim() {
    open();
    m_session->addPin({120, 80, 0});
    QVERIFY(m_session->motion().isBusy() && !m_session->motion().isStale());
    QVERIFY(settled());
    setVertices(m_session->document(), 500);
    QVERIFY(m_session->motion().isStale());
    QVERIFY(settled());
}

/// Settling follows the motion as part of it and is undone in one step; the shape is nearer to its rest then.
void TestGestures::settlingIsAStepOfItsOwn() {
    open();
    QVERIFY(!canSettle(m_session->document()));
    drag(1, {-20, 50});
    QVERIFY(!canSettle(m_session->document()));  // it springs back fully
    changeSetting(m_session->document(), "material.memory", 0);
    QVERIFY(settled());
    QVERIFY(canSettle(m_session->document()));
    const double end = endOf(project()), before = m_session->motion().frame()->distortion->totalMetric;
    const int steps = m_session->document().undoStack()->index();
    m_session->playback().setTime(0.3 * end);
    settleAtEnd(m_session->document(), m_session->playback());
    QVERIFY(settled());
    QCOMPARE(m_session->document().undoStack()->index(), steps + 1);
    QVERIFY((settlingOf(project()) == std::vector<SettleWindow>{{end, end + 1}}));
    QCOMPARE(endOf(project()), end + 1);
    QCOMPARE(m_session->playback().time(), end + 1);
    QVERIFY(m_session->motion().frame()->distortion->totalMetric < before);
    QVERIFY(m_session->motion().frame()->pinError < 1e-9);
    QVERIFY(m_session->motion().frame<2>()->pose == poseOf(project()));  // as the command line's
    m_session->document().undoStack()->undo();
    QVERIFY(settled());
    QVERIFY(settlingOf(project()).empty());
    QCOMPARE(m_session->playback().end(), end);
}

/// The last frame of a drag replaces the end of the motion while that is computed, and no other time.
void TestGestures::anotherTimeIsNotThatOfTheDrag() {
    open();
    drag(1, {0, 20});
    m_session->selection().set({1});
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 10, 0});
    QVERIFY(QTest::qWaitFor([&] { return m_session->motion().frame() && m_session->motion().frame()->live; },
                            20000));
    m_session->gestures().end(0.2);
    QVERIFY(m_session->motion().isBusy());
    m_session->playback().setTime(0);
    const auto first = m_session->motion().frame<2>();
    QVERIFY(first->pose == first->rest->points);
    QVERIFY(settled());
}

/// A refused handle waits, however far the pointer moves, until the shape can follow again.
void TestGestures::refusedHandlesWaitForTheShape() {
    DragGesture drag({0}, Grip{});
    const auto follow = [&](int sample, double x, bool stopped) {
        PosedFrame<2> live;
        live.sample = sample;
        live.amount = Amount(x, 0, 0);
        live.stopped = stopped;
        drag.follow(live);
    };
    const int first = drag.add({10, 0, 0});
    QCOMPARE(drag.amount().x(), 10.0);  // not known yet
    follow(first, 4, true);
    QCOMPARE(drag.amount().x(), 4.0);
    const int second = drag.add({30, 0, 0});
    QCOMPARE(drag.amount().x(), 4.0);
    QCOMPARE(drag.straight().back().x(), 4.0);
    QCOMPARE(drag.path(0).back().x(), 4.0);
    const int third = drag.add({2, 0, 0});
    follow(third, 2, false);
    QCOMPARE(drag.amount().x(), 2.0);
    QVERIFY(second < third);
    // Places between the last reached one and the refusal have never been reached.
    drag = DragGesture({0}, Grip{});
    for (const Amount& amount : {Amount(10, 0, 0), Amount(0, 20, 0), Amount(30, 0, 0)}) drag.add(amount);
    follow(3, 4, true);
    QVERIFY((drag.path(0) == std::vector<Amount>{{0, 0, 0}, {4, 0, 0}}));
}

QTEST_GUILESS_MAIN(TestGestures)
#include "test_gestures.moc"
