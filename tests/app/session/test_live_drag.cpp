// The preview of a drag, and the shape after its release.

#include <QtTest>

#include "app/engine/motion/live_drag.h"
#include "app/engine/motion/shape_engine.h"
#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/project.h"
#include "app/session/shape_session.h"
#include "core/integration/deformer.h"
#include "core/mesh/mesh_of_file.h"
#include "core/solver/velocity_solver.h"
#include "kernels/back_end_choice.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/window_fixture.h"

using namespace wend;

class TestLiveDrag : public QObject {
    Q_OBJECT

  private slots:
    void largeShapesNearEquiaArePreviewedSofter();
    void smallShapesArePreviewedAsTheyAre();
    void othersGoAlongWithARecording();
    void readyBeforeTheMotionIsKnown();
    void releasedShapeIsTheCommandLines_data();
    void releasedShapeIsTheCommandLines();
};

namespace {

constexpr double kLength = 8;

/// A bar of 2 × 2 × 8, however many slices it has.
SimplicialMesh<3> sliced(int slices) {
    SimplicialMesh<3> mesh = barMesh(slices);
    mesh.points.row(2) *= kLength / slices;
    return mesh;
}

std::vector<Handle<3>> ends() {
    std::vector<Handle<3>> handles(2);
    for (const int side : {0, 1}) {
        Handle<3>& handle = handles[static_cast<std::size_t>(side)];
        handle.name = side ? "top" : "bottom";
        const Vec3 normal = (side ? 1 : -1) * Vec3::UnitZ();
        handle.at = Region<3>(HalfSpace<3>{(side ? kLength - 1e-9 : 1e-9) * Vec3::UnitZ(), normal});
    }
    return handles;
}

Shape<3> shapeOf(int slices, double phi) {
    Shape<3> shape;
    shape.rest = std::make_shared<const SimplicialMesh<3>>(sliced(slices));
    shape.material =
        std::make_shared<const Material<3>>(Material<3>::uniform(shape.rest->cellCount(), phi, {}));
    return shape;
}

Project barOf(const QTemporaryDir& folder, int slices, double phi) {
    Project project;
    project.domain.kind = DomainKind::Mesh;
    project.domain.path = folder.filePath(QStringLiteral("bar.mesh")).toStdString();
    writeMesh<3>(project.domain.path, sliced(slices));
    Design design;
    design.dimension = 3;
    design.material.phi = phi;
    for (const Handle<3>& handle : ends()) design.handles.push_back(inSpace(handle));
    project.design = design;
    return project;
}

/// Returns the amount by which the pointer moves the upper end: up to a fifth of the length, to the side.
Amount handAt(int i) {
    return {0.2 * i, 0.05 * i, -0.01 * i};
}

/// Returns the largest distance of the preview from the flow with the shape's own material, relative to the
/// bar's length.
double softening(const Shape<3>& shape) {
    LiveDrag<3> preview(shape, ends());
    preview.begin({1}, {}, shape.rest->points);
    DragFlow<3> exact(shape.rest, shape.material, ends(), backEndFactory<3>(BackEndKind::Automatic));
    exact.begin(shape.rest->points);
    for (int i = 1; i <= 8; ++i) {
        const auto step = preview.follow(handAt(i));
        if (step.stopped || step.pinError > 1e-9) return 1;
        exact.lead({1}, motionBetween({}, handAt(i - 1), handAt(i)));
    }
    return (preview.pose() - exact.pose()).colwise().norm().maxCoeff() / kLength;
}

/// Returns whether the pose is that of the shape embedded in its body, with its own φ rather than with the
/// other, or, unless `rides`, that of its own flow. The session may have skipped samples, which makes little
/// difference.
bool nearer(const Points3& pose, const Shape<3>& shape, bool rides, double otherPhi) {
    const auto distance = [&](std::shared_ptr<const CoarseBody<3>> body) {
        LiveDrag<3> drag(shape, ends(), std::move(body));
        drag.begin({1}, {}, shape.rest->points);
        for (int i = 1; i <= 4; ++i) drag.follow(handAt(i));
        return (drag.pose() - pose).colwise().norm().maxCoeff();
    };
    const auto body = CoarseBody<3>::of(shape);
    if (!rides) return !body && distance(nullptr) < 1e-3 * kLength;
    const auto other = Material<3>::uniform(shape.rest->cellCount(), otherPhi, {});
    return body && distance(body) < 0.2 * std::min(distance(nullptr), distance(body->with(other)));
}

}  // namespace

/// The softening must be enough to keep the drag going, and hardly visible.
void TestLiveDrag::largeShapesNearEquiaArePreviewedSofter() {
    const double off = softening(shapeOf(500, phi::kEquia));
    QVERIFY2(off > 1e-4 && off < 0.02, qPrintable(QString::number(off)));
}

void TestLiveDrag::smallShapesArePreviewedAsTheyAre() {
    QCOMPARE(softening(shapeOf(40, phi::kEquia)), 0.0);
    QCOMPARE(softening(shapeOf(500, phi::kMetr)), 0.0);
}

/// While the upper end is dragged the lower one rotates and then moves by itself: it is exactly where its
/// motions have it, and the preview is near the later motion of the film.
void TestLiveDrag::othersGoAlongWithARecording() {
    constexpr double kBegin = 0.25, kEnd = 1;
    constexpr int kSamples = 15;
    const Shape<3> shape = shapeOf(40, phi::kMetr);
    std::vector<Handle<3>> film = ends();
    film[0].motions = {{Rotate<3>{Vec3(1, 1, 0), Vec3::UnitZ(), 0.5}, 0, 0.75},
                       {Translate<3>{Vec3(0.3, 0, 0)}, 0.75, 1}};
    Recorded<3> led;
    const auto timeAt = [](int i) { return kBegin + (kEnd - kBegin) * i / kSamples; };
    for (int i = 0; i <= kSamples; ++i) {
        led.times.push_back(timeAt(i));
        led.points.push_back(i == 0 ? Vec3::Zero() : Vec3(0.5 * handAt(i)));
    }
    film[1].motions = {{led, kBegin, kEnd}};
    Deformer<3> exact(shape.rest, shape.material, film, {}, backEndFactory<3>(BackEndKind::Automatic));
    QCOMPARE(exact.advance(kBegin).outcome, Outcome::Done);
    LiveDrag<3> preview(shape, film);
    preview.begin({1}, {}, exact.state().points, film, kBegin);
    for (int i = 1; i <= kSamples; ++i) {
        const auto step = preview.follow(0.5 * handAt(i), timeAt(i));
        QVERIFY(!step.stopped && step.pinError < 1e-9);
        const Trajectory<3> turn(film[0].motions[0]), shift(film[0].motions[1]);
        for (int v = 0; v < shape.rest->vertexCount(); ++v) {
            const Vec3 p = shape.rest->points.col(v);
            if (p.z() > 1e-9) continue;
            const Vec3 there =
                shift.at(timeAt(i), Side::Before).position(turn.at(timeAt(i), Side::Before).position(p));
            QVERIFY((preview.pose().col(v) - there).norm() < 1e-9 * kLength);
        }
    }
    QCOMPARE(exact.advance(kEnd).outcome, Outcome::Done);
    const double off = (preview.pose() - exact.state().points).colwise().norm().maxCoeff() / kLength;
    QVERIFY2(off < 2e-3, qPrintable(QString::number(off)));
    // After the end of their motions they are still.
    const Points3 before = preview.pose();
    preview.follow(0.5 * handAt(kSamples), kEnd + 1);
    QVERIFY((preview.pose() - before).cwiseAbs().maxCoeff() < 1e-9 * kLength);
}

/// A press on the visible part, while the motion of a file is still being computed, waits for no analysis.
void TestLiveDrag::readyBeforeTheMotionIsKnown() {
    const QTemporaryDir folder;
    Project project = barOf(folder, 1000, phi::kMetr);
    project.design.handles[1].motions = {{Translate<3>{Vec3(1, 0, 0)}, 0, 1}};
    std::stop_source stop;
    ShapeEngine::Sink sink;
    sink.shapeReady = [](int, const std::shared_ptr<const void>&, const KeptFrames&) {};
    sink.progress = [](double, double) {};
    sink.finished = [](double, const std::string&, const std::string&) {};
    sink.frameReady = [&](const FramePtr& frame) {
        if (frame->time > 0) stop.request_stop();
    };
    const auto engine = ShapeEngine::make(3, sink);
    engine->setShape({{1, 1, std::make_shared<const Project>(project), nullptr, {}}});
    while (!engine->isIdle() && !stop.stop_requested()) engine->work(stop.get_token());
    QVERIFY(!engine->isIdle());
    QVERIFY(engine->isReadyForDrag());
}

/// The admissible difference of two runs whose times differ by rounding, relative to the bar's length: `part`
/// of the tolerance τ of a velocity field. Other times move the shape by rounding, which a factor in single
/// precision amplifies: the remaining error of a field's iterations, up to τ, is then another one. Measured
/// with a Deformer whose clock is 0.7 and 0.3 times as fast, the greater of both, for τ = 5e-5, 1e-5, 1e-6,
/// 1e-7: 300 slices 8e-9, 1e-9, 3e-10, 2e-12; 1000, whose cells are as flat as 1 : 125, 3e-7, 9e-8, 2e-9,
/// 3e-10. So the difference scales with τ. With factors in double precision it is 3e-12, whatever τ is. First
/// guesses do not contribute: without them it is 5e-8 and 9e-7. With many digits the step control is
/// affected, too, and takes other steps: then both are within the integration's own error, and at a tolerance
/// of 1e-7 of the size up to 2e-8 of it apart. Near EQUIA factors are double and every field has its own: the
/// condition is decisive there.
void TestLiveDrag::releasedShapeIsTheCommandLines_data() {
    QTest::addColumn<double>("phi");
    QTest::addColumn<int>("slices");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<double>("part");
    QTest::addColumn<double>("phiBefore");
    QTest::newRow("METR") << phi::kMetr << 300 << 1e-4 << 1e-3 << phi::kMetr;
    QTest::newRow("EQUIA") << phi::kEquia << 300 << 1e-4 << 2e-4 << phi::kEquia;
    QTest::newRow("METR, riding") << phi::kMetr << 1000 << 1e-4 << 0.02 << phi::kEquia;
    QTest::newRow("METR, riding, many digits") << phi::kMetr << 1000 << 1e-7 << 1.0 << phi::kEquia;
}

/// The shape is compared after each of two drags, the second of which continues with the solver of the first.
/// The first has the bits of a new run; by the second the clock of the first has changed, which leaves
/// rounding (MotionPass).
void TestLiveDrag::releasedShapeIsTheCommandLines() {
    QFETCH(double, phi);
    QFETCH(int, slices);
    QFETCH(double, tolerance);
    QFETCH(double, part);
    QFETCH(double, phiBefore);
    const QTemporaryDir folder;
    ShapeSession session;
    OpenedFile file;
    Project project = barOf(folder, slices, phiBefore);
    project.integration.tolerance = tolerance;
    file.project = std::make_shared<const Project>(project);
    session.document().open(file);
    QVERIFY(test::settle(session));
    if (phi != phiBefore) {
        project.design.material.phi = phi;
        session.document().change(QStringLiteral("Energy"), project);
        QVERIFY(test::settle(session));
    }
    session.selection().set({1});
    for (const int drag : {1, 2}) {
        session.gestures().begin();
        for (int i = 1; i <= 4; ++i) session.gestures().moveBy(drag * handAt(i));
        QVERIFY(QTest::qWaitFor(
            [&] { return session.motion().frame()->live && session.motion().frame()->sample == 4; }, 60000));
        if (drag == 1)
            QVERIFY(nearer(session.motion().frame<3>()->pose, *session.motion().frame<3>()->built,
                           slices > 500, phiBefore));
        session.gestures().end(1e-3);
        QVERIFY(test::settle(session));
        const Project& now = *session.document().project();
        const auto shape = std::get<Shape<3>>(loadShape(now, folder.path().toStdString()));
        Deformer<3> deformer(shape.rest, shape.material, heldHandles(now, shape), integrationOf(now),
                             backEndFactory<3>(BackEndKind::Automatic));
        QCOMPARE(deformer.advance(now.end).outcome, Outcome::Done);
        const double off =
            (session.motion().frame<3>()->pose - deformer.state().points).cwiseAbs().maxCoeff();
        QVERIFY2(off <= (drag == 1 ? 0 : part * velocityToleranceFor(tolerance) * kLength),
                 qPrintable(QStringLiteral("drag %1: %2").arg(drag).arg(off)));
    }
}

QTEST_GUILESS_MAIN(TestLiveDrag)
#include "test_live_drag.moc"
