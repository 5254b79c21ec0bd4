#include <QTemporaryDir>
#include <QTest>
#include <limits>

#include "app/project/edits/document.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/handle_comparison.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/timing_edits.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/motion/trajectory.h"
#include "tests/support/projects.h"

using namespace wend;
using wend::test::withPin;

/// Gestures applied to a project, and their undo.
class TestCommands : public QObject {
    Q_OBJECT
  private slots:
    void undoAndRedoSkipNothing();
    void stepsOfOneKeyMerge();
    void noMergeAcrossASave();
    void savedUnderAnotherNameItIsThat();
    void firstPinsAreThereFromTheStart();
    void laterPinsBeginAtTheEnd();
    void removedPinsThatActedAreReleased();
    void filmsKeepTheirLength();
    void earlierStrokesReplaceTheirOwn();
    void strokesThatEndAllReplaceAll();
    void posesAreNoFilm();
    void cutMotionsKeepTheirPath_data();
    void cutMotionsKeepTheirPath();
    void cutSplinesRunAlongTheWholeOnes();
    void anotherLengthIsTheSameMotion();
    void settlingKeepsItsPlace();
    void longerStrokesKeepOneMotion();
    void simplifiedStaysWithinTolerance();
    void firstDifference_data();
    void firstDifference();
};

namespace {

Project withPins(int count) {
    Project project;
    for (int i = 0; i < count; ++i)
        project = withPin(project, {10.0 * i, 5.0}, "Pin " + std::to_string(i + 1));
    return project;
}

Project without(Project project, const std::vector<int>& handles, double time) {
    project.design = withoutHandles(project.design, handles, time);
    return project;
}

const std::vector<Pin>& handlesOf(const Project& project) {
    return project.design.handles;
}

void open(Document& document, Project project) {
    OpenedFile file;
    file.project = std::make_shared<const Project>(std::move(project));
    document.open(std::move(file));
}

void setPhi(Document& document, double phi, const QString& key) {
    Project next = *document.project();
    next.design.material.phi = phi;
    document.change(QStringLiteral("Change energy"), std::move(next), key);
}

}  // namespace

void TestCommands::undoAndRedoSkipNothing() {
    Document document;
    open(document, {});
    std::vector<std::shared_ptr<const Project>> states = {document.project()};
    for (int i = 0; i < 5; ++i) {
        document.change(QStringLiteral("Add"), withPin(*document.project(), {1.0 * i, 0},
                                                       freeName(namesOf(document.design().handles), "Pin")));
        states.push_back(document.project());
    }
    QVERIFY(document.isModified());
    for (int i = 4; i >= 0; --i) {
        document.undoStack()->undo();
        QCOMPARE(document.project(), states[i]);
    }
    QVERIFY(!document.isModified());
    for (int i = 1; i <= 5; ++i) {
        document.undoStack()->redo();
        QCOMPARE(document.project(), states[i]);
    }
}

void TestCommands::stepsOfOneKeyMerge() {
    Document document;
    open(document, {});
    const double before = document.design().material.phi;
    for (const double phi : {0.5, 0.6, 0.7}) setPhi(document, phi, QStringLiteral("phi 1"));
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document.design().material.phi, 0.7);
    setPhi(document, 0.9, QStringLiteral("phi 2"));
    QCOMPARE(document.undoStack()->count(), 2);
    document.undoStack()->undo();
    QCOMPARE(document.design().material.phi, 0.7);
    document.undoStack()->undo();
    QCOMPARE(document.design().material.phi, before);
}

void TestCommands::noMergeAcrossASave() {
    Document document;
    open(document, {});
    setPhi(document, 0.5, QStringLiteral("phi 1"));
    QVERIFY(document.merges(QStringLiteral("phi 1")));
    document.undoStack()->setClean();
    QVERIFY(!document.merges(QStringLiteral("phi 1")));
    setPhi(document, 0.6, QStringLiteral("phi 1"));
    QCOMPARE(document.undoStack()->count(), 2);
    QVERIFY(document.isModified());
}

void TestCommands::savedUnderAnotherNameItIsThat() {
    const QTemporaryDir folder;
    Document document;
    Project bar = withPins(1);
    bar.domain.kind = DomainKind::Image;
    bar.domain.path = "bar.png";
    open(document, bar);
    for (const char* name : {"one.wend", "two.wend"}) {
        setPhi(document, name[0] == 'o' ? 0.5 : 0.75, {});
        document.save(folder.filePath(name));
        QCOMPARE(document.path(), folder.filePath(name));
        QCOMPARE(document.displayName(), QString(name));
        QVERIFY(!document.isModified());
    }
    const auto phiOf = [&](const char* name) {
        const Project saved = *readProject(folder.filePath(name).toStdString()).project;
        return saved.design.material.phi;
    };
    QCOMPARE(phiOf("one.wend"), 0.5);
    QCOMPARE(phiOf("two.wend"), 0.75);
}

void TestCommands::firstPinsAreThereFromTheStart() {
    const Project project = withPins(2);
    QCOMPARE(handlesOf(project).size(), std::size_t(2));
    QVERIFY(handlesOf(project)[1].activeFrom < 0);
    QCOMPARE(freeName(namesOf(project.design.handles), "Pin"), std::string("Pin 3"));
    QCOMPARE(handlesOf(without(project, {0}, 0)).size(), std::size_t(1));
}

void TestCommands::laterPinsBeginAtTheEnd() {
    const Project moved = withStroke(withPins(2), {1}, {{10, 5, 0}}, {{0, 0, 0}, {4, 0, 0}});
    const Project later = withPin(moved, {3, 5}, "Pin 3");
    QCOMPARE(handlesOf(later)[2].activeFrom, 1.0);
    QVERIFY(isActive(handlesOf(later)[2], 1.0));
    QVERIFY(!isActive(handlesOf(later)[2], 0.5));
    // The handle never acted and is removed without a trace.
    QCOMPARE(handlesOf(without(later, {2}, 1)).size(), std::size_t(2));
}

void TestCommands::removedPinsThatActedAreReleased() {
    const Project moved = withStroke(withPins(2), {1}, {{10, 5, 0}}, {{0, 0, 0}, {4, 0, 0}});
    const Project removed = without(moved, {0}, 1);
    QCOMPARE(handlesOf(removed).size(), std::size_t(2));
    QCOMPARE(handlesOf(removed)[0].activeTo, 1.0);
    QVERIFY(isActive(handlesOf(removed)[0], 0.99));
    QVERIFY(!isActive(handlesOf(removed)[0], 1.0));
}

/// Each stroke takes a share of the film in proportion to its length, and no pose along it changes.
void TestCommands::filmsKeepTheirLength() {
    const Project once =
        withStroke(withPins(2), {0, 1}, {{0, 5, 0}, {10, 5, 0}}, {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}});
    QCOMPARE(once.end, 1.0);
    const auto& stroke = std::get<Recorded<3>>(handlesOf(once)[1].motions.at(0).kind);
    QCOMPARE(stroke.points.back(), Vec3(13, 9, 0));
    QCOMPARE(stroke.times.at(1), 3.0 / 7);  // at constant speed
    QCOMPARE(stroke.times.back(), 1.0);
    const Project twice = withStroke(once, {0}, {{3, 9, 0}}, {{0, 0, 0}, {14, 0, 0}});
    QCOMPARE(twice.end, 1.0);
    QCOMPARE(handlesOf(twice)[0].motions.at(0).end, 7.0 / 21);
    QCOMPARE(handlesOf(twice)[0].motions.at(1).start, 7.0 / 21);
    QCOMPARE(handlesOf(twice)[0].motions.at(1).end, 1.0);
    QCOMPARE(handlesOf(twice)[1].motions.size(), std::size_t(1));
    const Project thrice = withStroke(twice, {1}, {{13, 9, 0}}, {{0, 0, 0}, {0, 7, 0}});
    QCOMPARE(handlesOf(thrice)[0].motions.at(0).end, 7.0 / 28);
    QCOMPARE(handlesOf(thrice)[0].motions.at(1).end, 21.0 / 28);
    QCOMPARE(handlesOf(thrice)[1].motions.at(1).end, 1.0);
    // A rotation counts as long as the arc it covers: 0.7 radians, 10 from its centre.
    const Gesture turn{{0}, {Grip::Kind::Turn}, {Amount(0, 0, 0), Amount(0.7, 0, 0)}, 1, 10};
    const Project turned = withGesture(once, turn, {{3, 9, 0}});
    QVERIFY(std::abs(handlesOf(turned)[0].motions.at(0).end - 0.5) < 1e-12);
}

/// The later motions of the dragged pin are removed, and the rest of the film belongs to the drag; others
/// keep their motions and times.
void TestCommands::earlierStrokesReplaceTheirOwn() {
    Project project = withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {10, 0, 0}});
    project = withStroke(project, {1}, {{10, 5, 0}}, {{0, 0, 0}, {0, 10, 0}});
    project = withPin(project, {3, 5}, "Pin 3");  // from the end on
    project = without(project, {1}, 1);
    appendSettling(project, 0.75);
    const std::string others = toJson(without(project, {0}, 0));
    Gesture gesture{{0}, {}, {Amount(0, 0, 0), Amount(0, 5, 0), Amount(10, 5, 0)}, 0.25};
    const Project next = withGesture(project, gesture, {{5, 5, 0}});
    QCOMPARE(toJson(without(next, {0}, 0)), others);
    const auto& motions = handlesOf(next)[0].motions;
    QCOMPARE(motions.size(), std::size_t(2));
    QCOMPARE(motions[0].start, 0.0);
    QCOMPARE(motions[0].end, 0.25);
    QCOMPARE(std::get<Recorded<3>>(motions[0].kind).points.back(), Vec3(5, 5, 0));
    QCOMPARE(motions[1].start, 0.25);
    QCOMPARE(motions[1].end, project.end);
    QCOMPARE(std::get<Recorded<3>>(motions[1].kind).times.at(1), 1.0 / 3);
    // A pin that is released later holds on; from the beginning nothing of its own is left.
    gesture.handles = {1};
    const Project held = withGesture(project, gesture, {{10, 5, 0}});
    QVERIFY(isActive(handlesOf(held)[1], project.end) && handlesOf(held)[1].motions.size() == 1);
    gesture.handles = {0};
    gesture.from = 0;
    QCOMPARE(handlesOf(withGesture(project, gesture, {{0, 5, 0}}))[0].motions.size(), std::size_t(1));
}

/// The rest of a handle's motions is removed where it cannot go further, whichever handle is dragged.
void TestCommands::strokesThatEndAllReplaceAll() {
    Project project = withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {10, 0, 0}});
    project = withStroke(project, {1}, {{10, 5, 0}}, {{0, 0, 0}, {0, 10, 0}});
    project = withPin(project, {3, 5}, "Pin 3");  // from the end on
    project = without(project, {1}, 1);
    Gesture gesture{{0}, {}, {Amount(0, 0, 0), Amount(0, 5, 0)}, 0.25};
    gesture.endsAll = true;
    const Project next = withGesture(project, gesture, {{5, 5, 0}});
    const auto& handles = handlesOf(next);
    QCOMPARE(next.end, 1.0);
    QCOMPARE(handles.size(), std::size_t(3));
    QCOMPARE(handles[0].motions.size(), std::size_t(2));
    QCOMPARE(handles[0].motions[0].end, 0.5);  // five there, five here
    QCOMPARE(std::get<Recorded<3>>(handles[0].motions[0].kind).points.back(), Vec3(5, 5, 0));
    QVERIFY(handles[1].motions.empty());
    QVERIFY(isActive(handles[1], 1.0));  // it has not been let go of any more
    QCOMPARE(handles[2].activeFrom, 1.0);
    QVERIFY(movesAfter(project.design, 0.25));
    QVERIFY(!movesAfter(next.design, 1.0));
}

/// Motions that follow one another in proportion to their lengths are only poses, even rotations; a rest, an
/// overlap, another pace, a soft start or a recorded rhythm makes them timed.
void TestCommands::posesAreNoFilm() {
    Project posed =
        withStroke(withPins(3), {0, 1}, {{0, 5, 0}, {10, 5, 0}}, {{0, 0, 0}, {30, 0, 0}, {30, 5, 0}});
    QVERIFY(!hasOwnTiming(withPins(2)) && !hasOwnTiming(posed));
    posed = withGesture(posed, {{0, 1, 2}, {Grip::Kind::Turn}, {Amount(0, 0, 0), Amount(1.2, 0, 0)}, 1, 60},
                        {{30, 10, 0}, {40, 10, 0}, {20, 5, 0}});
    posed = withStroke(posed, {2}, {{20, 5, 0}}, {{0, 0, 0}, {0, 0.01, 0}});  // hardly a way
    QVERIFY(!hasOwnTiming(posed));
    posed = withStroke(posed, {1}, {{40, 10, 0}}, {{0, 0, 0}, {0, 25, 0}});
    QVERIFY(!hasOwnTiming(posed) && !hasOwnTiming(withLength(posed, 3)));
    const Project two = withStroke(withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {5, 0, 0}}), {1},
                                   {{10, 5, 0}}, {{0, 0, 0}, {0, 5, 0}});
    QVERIFY(!hasOwnTiming(two));
    const auto timed = [&two](const MotionTime& first, const MotionTime& second) {
        return hasOwnTiming(withMotionSpan(withMotionSpan(two, {{0, 0}}, first), {{1, 0}}, second));
    };
    QVERIFY(!timed({0, 0.5}, {0.5, 1}));
    QVERIFY(timed({0, 0.4}, {0.5, 1}) && timed({0, 0.6}, {0.5, 1}) && timed({0.1, 0.5}, {0.5, 1}));
    QVERIFY(timed({0, 0.5}, {0.5, 0.9}) && timed({0, 0.2}, {0.2, 1}) && timed({0, 1}, {0.5, 1}));
    Project relaxed = two;
    appendSettling(relaxed, 1);
    QVERIFY(!hasOwnTiming(relaxed));
    Project soft = two;
    soft.design = withMotionEase(soft.design, {{0, 0}}, Ease::In);
    QVERIFY(hasOwnTiming(soft));
    const Gesture byHand{{0}, {}, {Amount(0, 0, 0), Amount(5, 0, 0), Amount(10, 0, 0)}, 0, 1, {0, 0.8, 1}};
    QVERIFY(hasOwnTiming(withGesture(withPins(1), byHand, {{0, 5, 0}})));
}

void TestCommands::cutMotionsKeepTheirPath_data() {
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind < 6; ++kind) QTest::addRow("kind %d", kind) << kind;
}

/// Points carried by a cut motion are, at each of its times, where the whole motion has them on its path.
void TestCommands::cutMotionsKeepTheirPath() {
    QFETCH(int, kind);
    const std::vector<Vec3> points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {30, 10, 0}};
    PinMotion motion;
    motion.start = 1, motion.end = 3;
    motion.ease = Ease::In;
    if (kind == 0) motion.kind = Translate<3>{{4, 7, 0}};
    if (kind == 1) motion.kind = Rotate<3>{{3, 3, 0}, Vec3::UnitZ(), 2.5};
    if (kind == 2) motion.kind = Recorded<3>{{0, 1, 3, 4}, points};
    if (kind == 3) motion.kind = CurveMotion<3>{Interpolation::Bezier, points, FrameKind::Minimal, 0, 3};
    if (kind == 4) motion.kind = CurveMotion<3>{Interpolation::Polyline, points, FrameKind::None, 0, 2};
    if (kind == 5) motion.kind = CurveMotion<3>{Interpolation::Spline, points, FrameKind::None, 0, 1};
    Pin handle;
    handle.motions = {motion};
    endMotionsAt(handle, 2.2);
    const Trajectory<3> whole(motion), cut(handle.motions.at(0));
    QCOMPARE(cut.end(), 2.2);
    const bool timed = kind != 5;  // a spline becomes a chain whose pieces take even shares
    for (const double t : {1.0, 1.3, 1.7, 2.0, 2.2})
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(2, -1, 0)})
            if (timed || t == 1 || t == 2.2)
                QVERIFY((whole.at(t).position(p) - cut.at(t).position(p)).norm() < 1e-6);
    endMotionsAt(handle, 1.0);
    QVERIFY(handle.motions.empty());
}

/// The times differ, the path does not.
void TestCommands::cutSplinesRunAlongTheWholeOnes() {
    PinMotion motion;
    motion.start = 0, motion.end = 1;
    motion.kind = CurveMotion<3>{Interpolation::Spline,
                                 {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {30, 10, 0}, {35, -5, 0}},
                                 FrameKind::None,
                                 0,
                                 1};
    const Trajectory<3> whole(motion);
    std::vector<Vec3> way;
    for (int i = 0; i <= 20000; ++i) way.push_back(whole.at(i / 20000.0).position(Vec3(0, 0, 0)));
    for (const double end : {0.2, 0.55, 0.8}) {
        Pin handle;
        handle.motions = {motion};
        endMotionsAt(handle, end);
        const Trajectory<3> cut(handle.motions.at(0));
        for (int i = 0; i <= 40; ++i) {
            const Vec3 p = cut.at(end * i / 40).position(Vec3(0, 0, 0));
            double nearest = std::numeric_limits<double>::infinity();
            for (const Vec3& q : way) nearest = std::min(nearest, (p - q).norm());
            QVERIFY2(nearest < 0.01, qPrintable(QString("%1 %2: %3").arg(end).arg(i).arg(nearest)));
        }
    }
}

void TestCommands::anotherLengthIsTheSameMotion() {
    Project project = withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {1, 0, 0}});
    project = withStroke(project, {1}, {{10, 5, 0}}, {{0, 0, 0}, {0, 2, 0}});
    const Project longer = withLength(project, 7.3);
    QCOMPARE(longer.end, 7.3);
    QCOMPARE(handlesOf(longer)[1].motions[0].end, 7.3);
    const double scale = timeScale(handlesOf(project), handlesOf(longer));
    QCOMPARE(scale, 7.3);
    QCOMPARE(wend::firstDifference(handlesOf(project), handlesOf(longer), scale),
             std::numeric_limits<double>::infinity());
    const Project other = withStroke(project, {1}, {{10, 7, 0}}, {{0, 0, 0}, {0, 2, 0}});
    const double before = timeScale(handlesOf(project), handlesOf(other));
    QCOMPARE(wend::firstDifference(handlesOf(project), handlesOf(other), before),
             handlesOf(other)[1].motions[1].start);
    QVERIFY(wend::firstDifference(handlesOf(project), handlesOf(other)) < 0.5);
}

/// Settling follows its motion directly, before any later ones, and lasts its share of the film.
void TestCommands::settlingKeepsItsPlace() {
    Project project = withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {10, 0, 0}});
    appendSettling(project, 1);
    QVERIFY((project.settle == std::vector<SettleWindow>{{1, 2}}));
    project.cycle = {0.5, 1};
    const Project longer = withLength(project, 6);
    QVERIFY((*longer.cycle == std::array{1.5, 3.0}));
    QVERIFY((longer.settle == std::vector<SettleWindow>{{3, 6}}));
    const Project next = withStroke(project, {1}, {{10, 5, 0}}, {{0, 0, 0}, {0, 10, 0}});
    QCOMPARE(next.end, 2.0);
    QCOMPARE(next.settle.size(), std::size_t(1));
    QCOMPARE(next.settle[0].start, handlesOf(next)[0].motions[0].end);
    QCOMPARE(next.settle[0].end, handlesOf(next)[1].motions[0].start);
    QVERIFY(next.settle[0].end < 1.5);
}

void TestCommands::longerStrokesKeepOneMotion() {
    Project project = withStroke(withPins(1), {0}, {{0, 5, 0}}, {{0, 0, 0}, {1, 0, 0}});
    for (int i = 0; i < 3; ++i) project = withLongerStroke(project, {0}, {1, 0, 0});
    QCOMPARE(handlesOf(project)[0].motions.size(), std::size_t(1));
    const auto& stroke = std::get<Recorded<3>>(handlesOf(project)[0].motions[0].kind);
    QCOMPARE(stroke.points.size(), std::size_t(2));  // a straight way needs no more
    QCOMPARE(stroke.points.back(), Vec3(4, 5, 0));
    QCOMPARE(project.end, 1.0);
    project = withStroke(project, {0}, {{4, 5, 0}}, {{0, 0, 0}, {0, 4, 0}});
    QCOMPARE(handlesOf(project)[0].motions[1].start, 0.5);
    project = withLongerStroke(project, {0}, {0, 4, 0});
    QCOMPARE(handlesOf(project)[0].motions[1].start, 1.0 / 3);
    // A pin set at an earlier time stays there, and others keep their places.
    Project beside = withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {10, 0, 0}});
    beside = withGesture(beside, {{1}, {}, {Amount(0, 0, 0), Amount(1, 0, 0)}, 0.25}, {{10, 5, 0}});
    beside = withLongerStroke(beside, {1}, {1, 0, 0}, 1, false);
    QCOMPARE(timeOf(beside.design, 0, 0), (MotionTime{0, 1}));
    QCOMPARE(timeOf(beside.design, 1, 0), (MotionTime{0.25, 1}));
    QCOMPARE(std::get<Recorded<3>>(handlesOf(beside)[1].motions.at(0).kind).points.back(), Vec3(12, 5, 0));
}

void TestCommands::simplifiedStaysWithinTolerance() {
    std::vector<Vec3> arc;
    for (int i = 0; i <= 200; ++i) arc.emplace_back(100 * std::cos(i * 0.01), 100 * std::sin(i * 0.01), 0);
    const auto few = simplified<3>(arc, 0.2);
    QVERIFY(few.size() < arc.size() / 5);
    QCOMPARE(few.front(), arc.front());
    QCOMPARE(few.back(), arc.back());
    for (const Vec3& p : arc) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < few.size(); ++i) {
            const Vec3 way = few[i + 1] - few[i];
            const double s = std::clamp((p - few[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (p - few[i] - s * way).norm());
        }
        QVERIFY(nearest <= 0.2 + 1e-12);
    }
}

void TestCommands::firstDifference_data() {
    QTest::addColumn<int>("change");
    QTest::addColumn<double>("expected");
    const double infinity = std::numeric_limits<double>::infinity();
    QTest::newRow("nothing") << 0 << infinity;
    QTest::newRow("another pin from the start") << 1 << -infinity;
    QTest::newRow("a later motion") << 2 << 0.5;
    QTest::newRow("let go of") << 3 << 1.0;
    QTest::newRow("the first motion") << 4 << 0.0;
    QTest::newRow("a drag from the middle of a motion") << 5 << 0.25;
    QTest::newRow("from the middle of what slows down") << 6 << 0.0;
}

void TestCommands::firstDifference() {
    QFETCH(int, change);
    QFETCH(double, expected);
    Project before = withStroke(withPins(2), {0}, {{0, 5, 0}}, {{0, 0, 0}, {1, 0, 0}});
    if (change == 6) before.design = withMotionEase(before.design, {{0, 0}}, Ease::Out);
    Project after = before;
    if (change > 4)
        after = withGesture(before, {{0}, {}, {Amount(0, 0, 0), Amount(0, 3, 0)}, 0.25}, {{0.25, 5, 0}});
    if (change == 1) after.design.handles.push_back(handlesOf(withPins(3)).back());
    if (change == 2) after = withStroke(before, {1}, {{10, 5, 0}}, {{0, 0, 0}, {0, 1, 0}});
    if (change == 3) after = without(before, {1}, 1);
    if (change == 4) after = withLongerStroke(before, {0}, {0, 2, 0});
    const double scale = timeScale(handlesOf(before), handlesOf(after));
    QCOMPARE(wend::firstDifference(handlesOf(before), handlesOf(after), scale), expected);
    if (change == 5) return;  // back, nothing is kept: the integrator stopped where the motion was cut
    QCOMPARE(wend::firstDifference(handlesOf(after), handlesOf(before), 1 / scale), expected / scale);
}

QTEST_GUILESS_MAIN(TestCommands)
#include "test_commands.moc"
