#include <QTest>
#include <limits>

#include "app/engine/motion/drag_gesture.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/timing_edits.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/mesh/segments.h"
#include "core/motion/trajectory.h"

using namespace wend;

/// Timing: drags recorded in real time, and motions moved to other times.
class TestTiming : public QObject {
    Q_OBJECT
  private slots:
    void recordedDragsKeepTheirTimes();
    void restsStayRests();
    void recordedWhereItWasReached();
    void nothingMovedIsNoRecording();
    void recordingsJoinWhatOthersDo();
    void recordingsReplaceTheirOwn();
    void firstRecordingIsTheFilm();
    void recordedTurnsRest();
    void motionsStayBetweenTheirNeighbours_data();
    void motionsStayBetweenTheirNeighbours();
    void motionsWaitForTheirHandle();
    void laterMotionsLengthenTheFilm();
    void severalAreMovedAndScaled();
    void severalStayBetweenTheirNeighbours();
    void easeAndRemoval();
    void almostTheEndIsTheEnd_data();
    void almostTheEndIsTheEnd();
};

namespace {

constexpr double kTick = 1.0 / 60;

template <int Dim>
Pin pin(const std::string& name) {
    Pin handle;
    handle.name = name;
    handle.at = std::vector<Vec3>{Vec3::Zero()};
    return handle;
}

template <int Dim>
PinMotion motion(double start, double end) {
    return {Translate<3>{Vec3::Ones()}, start, end};
}

/// Two pins; the first moves from 0 to 1 and from 2 to 3 in a film of 4 s.
template <int Dim>
Project film() {
    Design design;
    design.handles = {pin<Dim>("A"), pin<Dim>("B")};
    design.handles[0].motions = {motion<Dim>(0, 1), motion<Dim>(2, 3)};
    Project project;
    project.end = 4;
    project.design = design;
    return project;
}

const std::vector<Pin>& handlesOf(const Project& project) {
    return project.design.handles;
}

/// Returns the amount of a timed path at a time, linearly interpolated.
Amount at(const TimedPath& path, double seconds) {
    for (std::size_t i = 1; i < path.seconds.size(); ++i)
        if (seconds <= path.seconds[i]) {
            const double u = (seconds - path.seconds[i - 1]) / (path.seconds[i] - path.seconds[i - 1]);
            return (1 - u) * path.points[i - 1] + u * path.points[i];
        }
    return path.points.back();
}

}  // namespace

/// The pointer speeds up along an arc: at each of its samples the recording is where it was, within the
/// tolerance and the distance of 20 ms.
void TestTiming::recordedDragsKeepTheirTimes() {
    constexpr double kTolerance = 0.5, kBegin = 1234.5;
    DragGesture drag({0}, {}, true);
    std::vector<std::pair<Amount, double>> samples;
    for (int i = 1; i <= 90; ++i) {
        const double t = i * kTick, angle = t * t;
        samples.emplace_back(Amount(100 * std::cos(angle) - 100, 100 * std::sin(angle), 0), t);
        drag.add(samples.back().first, kBegin + t);
    }
    const TimedPath path = drag.timedPath(kTolerance);
    QVERIFY(path.points.size() > 4 && path.points.size() < 60);
    QCOMPARE(path.seconds.front(), 0.0);
    QVERIFY(std::is_sorted(path.seconds.begin(), path.seconds.end(), std::less_equal<>()));
    QVERIFY(std::abs(path.seconds.back() - 90 * kTick) < 1e-9);
    QVERIFY(std::abs(drag.seconds() - 90 * kTick) < 1e-9);
    for (const auto& [amount, t] : samples) {
        const double speed = 100 * 2 * t;
        QVERIFY2((at(path, t) - amount).norm() <= kTolerance + 0.02 * speed, qPrintable(QString::number(t)));
    }
}

/// Between two samples far apart in time the recording rests instead of moving slowly.
void TestTiming::restsStayRests() {
    DragGesture drag({0}, {}, true);
    for (int i = 1; i <= 10; ++i) drag.add({3.0 * i, 0, 0}, i * kTick);
    for (int i = 1; i <= 10; ++i) drag.add({30, 3.0 * i, 0}, 2 + i * kTick);
    drag.add({30, 30, 0}, 4);  // and rests until it lets go
    const TimedPath path = drag.timedPath(0.5);
    for (const double t : {0.3, 1.0, 1.9}) QVERIFY((at(path, t) - Amount(30, 0, 0)).norm() < 1e-9);
    for (const double t : {2.5, 3.9}) QVERIFY((at(path, t) - Amount(30, 30, 0)).norm() < 1e-9);
    QVERIFY(std::abs(path.seconds.back() - 4) < 1e-9);
}

void TestTiming::recordedWhereItWasReached() {
    DragGesture drag({0}, {}, true);
    for (int i = 1; i <= 20; ++i) drag.add({double(i), 0, 0}, i * kTick);
    PosedFrame<2> stopped;
    stopped.sample = 12;
    stopped.amount = {7.5, 0, 0};
    stopped.stopped = true;
    drag.follow(stopped);
    const TimedPath path = drag.timedPath(0.1);
    QCOMPARE(path.points.back(), Amount(7.5, 0, 0));
    QVERIFY(std::abs(path.seconds.back() - 12 * kTick) < 1e-9);
}

void TestTiming::nothingMovedIsNoRecording() {
    DragGesture drag({0}, {}, true);
    for (int i = 1; i <= 20; ++i) drag.add(Amount::Zero(), i * kTick);
    QCOMPARE(drag.timedPath(0.1).points.size(), std::size_t(1));
}

/// Another pin is recorded while the first moves: that one keeps its times to the bit.
void TestTiming::recordingsJoinWhatOthersDo() {
    const Project before = film<2>();
    const Gesture gesture{{1}, {}, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 0.5, 1, {0, 1, 1.25}};
    const Project after = withGesture(before, gesture, {{10, 20, 0}});
    QCOMPARE(after.end, 4.0);
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(handlesOf(after)[0].motions[i].start, handlesOf(before)[0].motions[i].start);
        QCOMPARE(handlesOf(after)[0].motions[i].end, handlesOf(before)[0].motions[i].end);
    }
    QCOMPARE(handlesOf(after)[1].motions.size(), std::size_t(1));
    const Trajectory<3> path(handlesOf(after)[1].motions[0]);
    QCOMPARE(path.start(), 0.5);
    QCOMPARE(path.end(), 1.75);
    const Vec3 start(10, 20, 0);
    QVERIFY((path.at(1.0).position(start) - Vec3(12, 20, 0)).norm() < 1e-12);
    QVERIFY((path.at(1.5).position(start) - Vec3(14, 20, 0)).norm() < 1e-12);
    QVERIFY((path.at(1.625).position(start) - Vec3(14, 21.5, 0)).norm() < 1e-12);
}

/// Later motions of the recorded pin are replaced; the film becomes longer where it must.
void TestTiming::recordingsReplaceTheirOwn() {
    const Gesture gesture{{0}, {}, {{0, 0, 0}, {1, 0, 0}}, 2.5, 1, {0, 3}};
    const Project after = withGesture(film<2>(), gesture, {{0, 0, 0}});
    const auto& motions = handlesOf(after)[0].motions;
    QCOMPARE(motions.size(), std::size_t(3));
    QCOMPARE(motions[1].end, 2.5);  // cut there
    QCOMPARE(std::get<Translate<3>>(motions[1].kind).by.x(), 0.5);
    QCOMPARE(motions[2].start, 2.5);
    QCOMPARE(motions[2].end, 5.5);
    QCOMPARE(after.end, 5.5);
}

void TestTiming::firstRecordingIsTheFilm() {
    Project still = film<2>();
    still.design.handles[0].motions.clear();
    const Project after = withGesture(still, {{0}, {}, {{0, 0, 0}, {1, 0, 0}}, 0, 1, {0, 0.75}}, {{0, 0, 0}});
    QCOMPARE(after.end, 0.75);
    QCOMPARE(motionEnd(after), 0.75);
}

/// Rotations become one motion per piece of the path, none where the pointer rests.
void TestTiming::recordedTurnsRest() {
    Grip turn;
    turn.kind = Grip::Kind::Turn;
    const Gesture gesture{{1}, turn, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, 1, 1, {0, 1, 2, 2.5}};
    const Project after = withGesture(film<3>(), gesture, {Vec3::Zero()});
    const auto& motions = after.design.handles[1].motions;
    QCOMPARE(motions.size(), std::size_t(2));
    QCOMPARE(motions[0].start, 1.0);
    QCOMPARE(motions[0].end, 2.0);
    QCOMPARE(std::get<Rotate<3>>(motions[0].kind).angle, 1.0);
    QCOMPARE(motions[1].start, 3.0);
    QCOMPARE(motions[1].end, 3.5);
    QCOMPARE(std::get<Rotate<3>>(motions[1].kind).angle, -0.5);
}

void TestTiming::motionsStayBetweenTheirNeighbours_data() {
    QTest::addColumn<int>("motion");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("end");
    QTest::addColumn<double>("expectedStart");
    QTest::addColumn<double>("expectedEnd");
    QTest::newRow("free") << 0 << 0.5 << 1.5 << 0.5 << 1.5;
    QTest::newRow("before the film") << 0 << -1.0 << 0.0 << 0.0 << 1.0;
    QTest::newRow("into the next") << 0 << 1.5 << 2.5 << 1.0 << 2.0;
    QTest::newRow("longer than the room behind") << 0 << 0.0 << 3.0 << 0.0 << 2.0;
    QTest::newRow("longer than the room before") << 1 << -1.0 << 3.0 << 1.0 << 3.0;
    QTest::newRow("into the one before") << 1 << 0.5 << 1.5 << 1.0 << 2.0;
    QTest::newRow("too short") << 1 << 2.0 << 2.0 << 2.0 << 2.0 + kShortestMotion;
}

void TestTiming::motionsStayBetweenTheirNeighbours() {
    QFETCH(int, motion);
    QFETCH(double, start);
    QFETCH(double, end);
    const auto check = [&](const Project& project) {
        const MotionTime time =
            timeOf(withMotionSpan(project, {{0, motion}}, {start, end}).design, 0, motion);
        QTEST(time.start, "expectedStart");
        QTEST(time.end, "expectedEnd");
    };
    check(film<2>());
    check(film<3>());
}

void TestTiming::motionsWaitForTheirHandle() {
    Project project = film<2>();
    auto& handle = project.design.handles[0];
    handle.motions.erase(handle.motions.begin());
    handle.activeFrom = 1.5;
    handle.activeTo = 3.5;
    QCOMPARE(timeOf(withMotionSpan(project, {{0, 0}}, {0, 1}).design, 0, 0), (MotionTime{1.5, 2.5}));
    const Project late = withMotionSpan(project, {{0, 0}}, {6, 7});
    QCOMPARE(timeOf(late.design, 0, 0), (MotionTime{2.5, 3.5}));
    QCOMPARE(late.end, 4.0);
}

void TestTiming::laterMotionsLengthenTheFilm() {
    const Project after = withMotionSpan(film<2>(), {{0, 1}}, {5, 6});
    QCOMPARE(after.end, 6.0);
    QCOMPARE(timeOf(after.design, 0, 1), (MotionTime{5, 6}));
    QCOMPARE(timeOf(after.design, 0, 0), (MotionTime{0, 1}));
    QCOMPARE(withMotionSpan(film<2>(), {{0, 1}}, {2.5, 3}).end, 4.0);
}

namespace {

/// Returns a film of pins A and B; A moves three times, B once.
Project busyFilm() {
    Project project = film<2>();
    auto& handles = project.design.handles;
    handles[0].motions.push_back(motion<2>(3, 4));
    handles[1].motions = {motion<2>(0.5, 2.5)};
    return project;
}

const std::vector<MotionId> kSeveral = {{0, 0}, {0, 1}, {1, 0}};  // from 0 to 3, before {0, 2}

}  // namespace

/// The map of times is linear, so the ends of each motion are mapped to the given times.
void TestTiming::severalAreMovedAndScaled() {
    Project project = busyFilm();
    project.design = withoutMotions(project.design, {{0, 2}});
    QCOMPARE(spanOf(project.design, kSeveral), (MotionTime{0, 3}));
    for (const MotionTime& to : {MotionTime{0, 1.5}, {0.25, 3.25}, {1.5, 4.5}, {0, 6}, {1.5, 3}}) {
        const Project after = withMotionSpan(project, kSeveral, to);
        for (const auto& [handle, motion] : kSeveral) {
            const MotionTime was = timeOf(project.design, handle, motion),
                             is = timeOf(after.design, handle, motion);
            const double scale = (to.end - to.start) / 3;
            QVERIFY(std::abs(is.start - (to.start + scale * was.start)) < 1e-12);
            QVERIFY(std::abs(is.end - (to.start + scale * was.end)) < 1e-12);
        }
        QCOMPARE(after.end, std::max(4.0, to.end));
    }
}

/// One motion that cannot be moved stops all; none becomes shorter than the minimum.
void TestTiming::severalStayBetweenTheirNeighbours() {
    const Project project = busyFilm();
    const auto to = [&](const std::vector<MotionId>& motions, const MotionTime& span) {
        return spanOf(withMotionSpan(project, motions, span).design, motions);
    };
    QCOMPARE(to(kSeveral, {1, 4}), (MotionTime{0, 3}));  // {0, 2} begins at 3
    QCOMPARE(to(kSeveral, {0, 4}), (MotionTime{0, 3}));
    QCOMPARE(to(kSeveral, {-1, 2}), (MotionTime{0, 3}));  // the film begins
    QCOMPARE(to({{0, 1}, {1, 0}}, {0, 2.5}), (MotionTime{0, 2.5}));
    // {0, 0} ends at 1, where {0, 1} would begin when both are scaled to less.
    const MotionTime scaled = to({{0, 1}, {1, 0}}, {0.5, 1});
    QVERIFY2(std::abs(scaled.end - (0.5 + 2.5 * 0.5 / 1.5)) < 1e-12, qPrintable(QString::number(scaled.end)));
    QCOMPARE(to({{0, 2}, {1, 0}}, {0.5, 1}), (MotionTime{0.5, 4}));  // {0, 1} ends where {0, 2} begins
    // The shorter one of 1 s and 2 s.
    QVERIFY(std::abs(to({{0, 0}, {1, 0}}, {0, 0}).end - 2.5 * kShortestMotion) < 1e-12);
    const Project after = withMotionSpan(project, {{0, 2}}, {3, 3});
    QVERIFY(std::abs(timeOf(after.design, 0, 2).end - 3 - kShortestMotion) < 1e-12);
    // Rounded to any digits, they do not overlap, and the file can be read.
    for (int i = 1; i < 40; ++i) {
        const Project next = withMotionSpan(project, kSeveral, {0, 3.0 * i / 41});
        QVERIFY(timeOf(next.design, 0, 0).end <= timeOf(next.design, 0, 1).start);
        QVERIFY(timeOf(next.design, 0, 1).end <= timeOf(next.design, 0, 2).start);
    }
}

void TestTiming::easeAndRemoval() {
    Project soft = film<2>();
    soft.design = withMotionEase(soft.design, {{0, 1}}, Ease::InOut);
    QCOMPARE(handlesOf(soft)[0].motions[1].ease, Ease::InOut);
    QCOMPARE(handlesOf(soft)[0].motions[0].ease, Ease::Linear);
    Project one = film<2>();
    one.design = withoutMotions(one.design, {{0, 0}});
    QCOMPARE(handlesOf(one)[0].motions.size(), std::size_t(1));
    QCOMPARE(timeOf(one.design, 0, 0), (MotionTime{2, 3}));
    QCOMPARE(one.end, 4.0);
    const Design two = withMotionEase(busyFilm().design, {{0, 0}, {1, 0}}, Ease::In);
    QVERIFY(two.handles[0].motions[0].ease == Ease::In && two.handles[1].motions[0].ease == Ease::In &&
            two.handles[0].motions[1].ease == Ease::Linear);
    Project left = busyFilm();
    left.design = withoutMotions(left.design, {{0, 0}, {1, 0}, {0, 2}});
    QVERIFY(handlesOf(left)[0].motions.size() == 1 && handlesOf(left)[1].motions.empty());
    QCOMPARE(timeOf(left.design, 0, 0), (MotionTime{2, 3}));
    left.design = withoutMotions(busyFilm().design, {{0, 0}, {0, 1}});
    QVERIFY(timeOf(left.design, 0, 0) == timeOf(busyFilm().design, 0, 2));
}

void TestTiming::almostTheEndIsTheEnd_data() {
    QTest::addColumn<std::vector<double>>("times");
    QTest::newRow("a drag") << std::vector<double>();
    QTest::newRow("a recording") << std::vector<double>{0, 1};
}

/// The slider's last position may be before the film's end by rounding: a motion added there starts at the
/// end, and the file can be read.
void TestTiming::almostTheEndIsTheEnd() {
    QFETCH(std::vector<double>, times);
    Project project = film<2>();
    project.domain.path = "picture.png";
    auto& handles = project.design.handles;
    handles[0].motions[1].end = handles[1].activeFrom = project.end;
    const double from = std::nextafter(project.end, 0.0);
    const Gesture gesture{{0}, {}, {Amount::Zero(), Amount(0, 5, 0)}, from, 1, times};
    const Project next = withGesture(project, gesture, {Vec3(1, 1, 0)});
    const auto& motions = handlesOf(next)[0].motions;
    QCOMPARE(motions.size(), std::size_t(3));
    QVERIFY2(motions[1].end == motions[2].start,
             qPrintable(QString("%1 %2").arg(motions[1].end).arg(motions[2].start)));
    if (times.empty()) QCOMPARE(handlesOf(next)[1].activeFrom, motions[2].start);
    QCOMPARE(toJson(*parseProject(toJson(next), "memory.wend").project), toJson(next));
}

QTEST_GUILESS_MAIN(TestTiming)
#include "test_timing.moc"
