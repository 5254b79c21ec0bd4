#include <QTest>
#include <QUndoStack>
#include <array>
#include <limits>
#include <random>

#include "app/project/edits/document.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/key_edits.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/edits/progress.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/motion/easing.h"
#include "core/motion/trajectory.h"

using namespace wend;

/// Key poses are moved, removed, held, eased, copied and pasted, and recordings become keys.
class TestKeys : public QObject {
    Q_OBJECT
  private slots:
    void keysAreTheEndsOfMotions();
    void movedKeysTakeBothSides();
    void movedKeysStayInTheirRoom();
    void removedKeysAreBridged();
    void heldKeysStay();
    void keysAreEased();
    void copiesAreSetElsewhere();
    void straightMotionsKeepTheirEasing();
    void recordingsBecomeKeys();
    void randomEditsKeepTheRest_data();
    void randomEditsKeepTheRest();
};

namespace {

/// Returns a film of 5 s with a handle that moves from 0 to 1 and to 2 s, holds, and moves from 3 to 4 s, and
/// one that moves from 1 to 2 s.
template <int Dim>
Project film() {
    Design design;
    for (const char* name : {"A", "B", "C"}) {
        Pin handle;
        handle.name = name;
        handle.at = std::vector<Vec3>{Vec3::Zero()};
        design.handles.push_back(handle);
    }
    const Vec3 x = Vec3::Unit(0), y = Vec3::Unit(1);
    design.handles[0].motions = {
        {Translate<3>{x}, 0, 1}, {Translate<3>{2 * y}, 1, 2}, {Translate<3>{4 * x}, 3, 4}};
    design.handles[1].motions = {{Translate<3>{8 * y}, 1, 2}};
    Project project;
    project.end = 5;
    project.design = design;
    return project;
}

template <int Dim>
std::vector<PinMotion>& motionsOf(Project& project, int handle) {
    return project.design.handles[static_cast<std::size_t>(handle)].motions;
}

/// The place of a point that rests at the origin, and is vertex 3 of fields.
template <int Dim>
Vec3 placeAt(const Project& project, int handle, double time) {
    Vec3 place = Vec3::Zero();
    for (const PinMotion& motion : project.design.handles[static_cast<std::size_t>(handle)].motions) {
        const auto map = Trajectory<3>(motion).at(time, Side::Before);
        place = map.position(place);
        if (const auto* field = std::get_if<FieldMotion<3>>(&motion.kind))
            for (const auto& [vertex, displacement] : *field->values)
                if (vertex == 3) place += map.share * displacement;
    }
    return place;
}

/// Computes the place by the closed form of a film of straight motions, independently of the timeline.
Vec3 straightPlace(const std::vector<PinMotion>& motions, double time) {
    Vec3 place = Vec3::Zero();
    for (const PinMotion& motion : motions) {
        const double s = std::clamp((time - motion.start) / (motion.end - motion.start), 0.0, 1.0);
        const std::array factors = {s, s * s, s * (2 - s), s * s * (3 - 2 * s)};
        place += factors[static_cast<std::size_t>(motion.ease)] * std::get<Translate<3>>(motion.kind).by;
    }
    return place;
}

Project with(Project project, Design design) {
    project.design = std::move(design);
    return project;
}

/// Returns a film of straight, curved or recorded motions.
template <int Dim>
bool sameBits(const PinMotion& a, const PinMotion& b) {
    if (a.start != b.start || a.end != b.end || a.ease != b.ease || a.kind.index() != b.kind.index())
        return false;
    if (const auto* straight = std::get_if<Translate<3>>(&a.kind))
        return straight->by == std::get<Translate<3>>(b.kind).by;
    if (const auto* curve = std::get_if<CurveMotion<3>>(&a.kind)) {
        const auto& other = std::get<CurveMotion<3>>(b.kind);
        return curve->points == other.points && curve->scale == other.scale;
    }
    if (const auto* field = std::get_if<FieldMotion<3>>(&a.kind))
        return *field->values == *std::get<FieldMotion<3>>(b.kind).values;
    const auto &stroke = std::get<Recorded<3>>(a.kind), &other = std::get<Recorded<3>>(b.kind);
    return stroke.times == other.times && stroke.points == other.points;
}

template <int Dim>
bool sameBits(const std::vector<PinMotion>& a, const std::vector<PinMotion>& b) {
    return std::ranges::equal(a, b,
                              [](const auto& one, const auto& other) { return sameBits<Dim>(one, other); });
}

}  // namespace

void TestKeys::keysAreTheEndsOfMotions() {
    const Project project = film<2>();
    QCOMPARE(keyTimes(project.design, 0), (std::vector<double>{0, 1, 2, 3, 4}));
    QCOMPARE(keyTimes(project.design, 1), (std::vector<double>{1, 2}));
    QVERIFY(keyTimes(project.design, 2).empty());
}

void TestKeys::movedKeysTakeBothSides() {
    Project moved = *withKeysMoved(film<2>(), {{0, 1}}, 0.5);
    QCOMPARE(motionsOf<2>(moved, 0)[0].end, 1.5);
    QCOMPARE(motionsOf<2>(moved, 0)[1].start, 1.5);
    QCOMPARE(motionsOf<2>(moved, 0)[1].end, 2.0);
    QVERIFY((placeAt<2>(moved, 0, 0.75) - Vec3(0.5, 0, 0)).norm() < 1e-14);
    moved = *withKeysMoved(film<2>(), {{0, 4}, {1, 2}}, 3);  // one goes beyond the end
    QCOMPARE(moved.end, 7.0);
    QCOMPARE(motionsOf<2>(moved, 0)[2].end, 7.0);
    QCOMPARE(motionsOf<2>(moved, 1)[0].end, 5.0);
    moved = *withKeysMoved(film<2>(), {{0, 3}, {0, 4}}, -0.5);  // both ends: a motion moves as a whole
    QCOMPARE(motionsOf<2>(moved, 0)[2].start, 2.5);
    QCOMPARE(motionsOf<2>(moved, 0)[2].end, 3.5);
}

void TestKeys::movedKeysStayInTheirRoom() {
    Project moved = *withKeysMoved(film<2>(), {{0, 1}}, 9);
    QCOMPARE(motionsOf<2>(moved, 0)[0].end, 2 - kShortestMotion);
    moved = *withKeysMoved(film<2>(), {{0, 2}}, 9);  // up to where the next motion begins: no hold is left
    QCOMPARE(motionsOf<2>(moved, 0)[1].end, 3.0);
    QCOMPARE(keyTimes(moved.design, 0), (std::vector<double>{0, 1, 3, 4}));
    moved = *withKeysMoved(film<2>(), {{0, 1}, {1, 1}}, -9);  // together, as far as the first one can
    QCOMPARE(motionsOf<2>(moved, 0)[0].end, kShortestMotion);
    QCOMPARE(motionsOf<2>(moved, 1)[0].start, kShortestMotion);
    QCOMPARE(toJson(*withKeysMoved(film<2>(), {{0, 0}}, -1)), toJson(film<2>()));
}

void TestKeys::removedKeysAreBridged() {
    const Project before = film<2>();
    Project after = with(before, withoutKeys(before.design, {{0, 1}}));
    QCOMPARE(motionsOf<2>(after, 0).size(), 2U);
    QVERIFY((placeAt<2>(after, 0, 1) - Vec3(0.5, 1, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 2) - Vec3(1, 2, 0)).norm() < 1e-14);
    after = with(before, withoutKeys(before.design, {{0, 2}}));  // to the next key instead
    QVERIFY((placeAt<2>(after, 0, 2) - Vec3(1, 1, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 4) - Vec3(5, 2, 0)).norm() < 1e-14);
    after = with(before, withoutKeys(before.design, {{0, 4}}));  // the last one: it stays
    QVERIFY((placeAt<2>(after, 0, 5) - Vec3(1, 2, 0)).norm() < 1e-14);
    after = with(before, withoutKeys(before.design, {{1, 1}}));  // the first one: from rest
    QVERIFY((placeAt<2>(after, 1, 1) - Vec3(0, 4, 0)).norm() < 1e-14);
    QCOMPARE(toJson(with(before, withoutKeys(before.design, {{0, 0}}))), toJson(before));
    after = with(before, withoutKeys(before.design, {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}}));
    QVERIFY(motionsOf<2>(after, 0).empty());
}

void TestKeys::heldKeysStay() {
    const Project before = film<2>();
    Project after = with(before, withKeysHeld(before.design, {{0, 1}}));
    for (const double time : {1.0, 1.5, 2.0})
        QVERIFY((placeAt<2>(after, 0, time) - Vec3(1, 0, 0)).norm() < 1e-14);
    for (const double time : {3.0, 4.0})  // it is back where it was
        QVERIFY((placeAt<2>(after, 0, time) - placeAt<2>(before, 0, time)).norm() < 1e-14);
    after = with(before, withKeysHeld(before.design, {{0, 0}}));
    QVERIFY(placeAt<2>(after, 0, 1) == Vec3(0, 0, 0));
    QVERIFY((placeAt<2>(after, 0, 2) - placeAt<2>(before, 0, 2)).norm() < 1e-14);
    after = with(before, withKeysHeld(before.design, {{0, 3}}));
    QVERIFY((placeAt<2>(after, 0, 5) - Vec3(1, 2, 0)).norm() < 1e-14);
    QCOMPARE(toJson(with(before, withKeysHeld(before.design, {{0, 2}, {0, 4}}))), toJson(before));
}

void TestKeys::keysAreEased() {
    Project project = film<2>();
    project.design = withKeyEase(project.design, {{0, 1}}, {true, false});
    QCOMPARE(motionsOf<2>(project, 0)[0].ease, Ease::Out);
    QCOMPARE(motionsOf<2>(project, 0)[1].ease, Ease::Linear);
    project.design = withKeyEase(project.design, {{0, 0}, {0, 2}}, {true, true});
    QCOMPARE(motionsOf<2>(project, 0)[0].ease, Ease::InOut);
    QCOMPARE(motionsOf<2>(project, 0)[1].ease, Ease::Out);
    QCOMPARE(motionsOf<2>(project, 0)[2].ease, Ease::Linear);
    QCOMPARE(easeAt(project.design, {0, 1}), (KeyEase{true, false}));
    QVERIFY((placeAt<2>(project, 0, 1.5) - straightPlace(motionsOf<2>(project, 0), 1.5)).norm() < 1e-14);
    project.design = withKeyEase(project.design, {{0, 1}}, {});
    QCOMPARE(motionsOf<2>(project, 0)[0].ease, Ease::In);
}

void TestKeys::copiesAreSetElsewhere() {
    const Project before = film<2>();
    const std::vector<Vec3> starts(3, Vec3::Zero());
    const auto copies = copiedKeys(before.design, {{0, 2}, {0, 1}, {1, 2}}, starts);
    QCOMPARE(copies.size(), 3U);
    QVERIFY(copies[0].after == 0 && copies[1].after == 1 && copies[2].after == 1);
    QVERIFY(copies[0].offset == Amount(1, 0, 0) && copies[1].offset == Amount(1, 2, 0));
    std::vector<KeyId> pasted;
    Project after = *withKeysPasted(before, copies, 6, starts, pasted);
    QCOMPARE(pasted, (std::vector<KeyId>{{0, 6}, {0, 7}, {1, 7}}));
    QCOMPARE(after.end, 7.0);
    QVERIFY((placeAt<2>(after, 0, 6) - Vec3(1, 0, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 7) - Vec3(1, 2, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 5) - Vec3(3, 1, 0)).norm() < 1e-14);  // on the way from 4 to 6
    QVERIFY((placeAt<2>(after, 1, 7) - Vec3(0, 8, 0)).norm() < 1e-14);
    for (double time = 0; time <= 4; time += 0.25)
        QVERIFY((placeAt<2>(after, 0, time) - placeAt<2>(before, 0, time)).norm() < 1e-14);
    auto others = copies;  // on a pin that does not move; one where it rests
    for (CopiedKey& copy : others) copy.handle = 2;
    others.pop_back();
    after = *withKeysPasted(before, others, 0, starts, pasted);
    QCOMPARE(pasted, (std::vector<KeyId>{{2, 1}}));
    QVERIFY((placeAt<2>(after, 2, 3) - Vec3(1, 2, 0)).norm() < 1e-14);
}

/// A pose at the end of an eased motion adds or removes one vector and keeps the easing.
void TestKeys::straightMotionsKeepTheirEasing() {
    Project project = film<2>();
    project.design = withKeyEase(project.design, {{0, 1}, {0, 2}}, {true, true});
    Gesture gesture;
    gesture.handles = {0};
    gesture.path = {Amount::Zero(), Amount(0, 3, 0)};
    gesture.from = 1;
    auto after = *withPose(project, gesture, {Vec3(1, 0, 0)});
    const auto& motions = motionsOf<2>(after, 0);
    QVERIFY(std::get<Translate<3>>(motions[0].kind).by == Vec3(1, 3, 0));
    QVERIFY(std::get<Translate<3>>(motions[1].kind).by == Vec3(0, -1, 0));
    QVERIFY(motions[0].ease == Ease::Out && motions[1].ease == Ease::InOut);
}

/// Straight pieces with easing are found again; anything else is followed within the tolerance.
void TestKeys::recordingsBecomeKeys() {
    std::vector<PinMotion> pieces;
    for (int i = 0; i < 4; ++i)
        pieces.push_back(
            {Translate<3>{Vec3(i % 2 == 0 ? 10 : -6, 3 * i, 0)}, i * 1.0, i + 1.0, static_cast<Ease>(i)});
    Recorded<3> stroke;
    for (int i = 0; i <= 400; ++i) {
        stroke.times.push_back(i / 100.0);
        stroke.points.push_back(straightPlace(pieces, i / 100.0));
    }
    Project project = film<2>();
    motionsOf<2>(project, 0) = {{stroke, 0, 4}};
    Project keys = with(project, withFewKeys(project.design, {{0, 0}}, 0.05));
    const std::size_t count = motionsOf<2>(keys, 0).size();
    qInfo("%zu keys of 4 pieces", count);
    QVERIFY(count >= 4 && count <= 12);
    std::mt19937 random(1);
    std::normal_distribution<double> step(0, 1);
    Vec3 at = Vec3::Zero();
    for (Vec3& point : stroke.points) point = at += Vec3(step(random), step(random), 0);
    for (const double tolerance : {0.01, 1.0, 5.0}) {
        motionsOf<2>(project, 0) = {{stroke, 0.5, 4.5}};
        keys = with(project, withFewKeys(project.design, {{0, 0}}, tolerance));
        const auto& straight = motionsOf<2>(keys, 0);
        QVERIFY(straight.front().start == 0.5 && straight.back().end == 4.5);
        qInfo("%zu keys within %g", straight.size(), tolerance);
        double worst = 0;
        for (int i = 0; i <= 400; ++i) {
            const double time = 0.5 + i / 100.0;
            worst = std::max(worst,
                             (straightPlace(straight, time) - (stroke.points[i] - stroke.points[0])).norm());
        }
        QVERIFY2(worst <= tolerance * (1 + 1e-9), qPrintable(QString::number(worst)));
    }
    const Project line = with(project, straightened(project.design, {{0, 0}}));
    QCOMPARE(placeAt<2>(line, 0, 5), placeAt<2>(project, 0, 5));
    QVERIFY((placeAt<2>(line, 0, 2.5) - 0.5 * placeAt<2>(project, 0, 5)).norm() < 1e-9);
}

void TestKeys::randomEditsKeepTheRest_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

namespace {

/// A late pin, the cycle or a marker: none of these changes a motion.
template <int Dim>
Project randomAddition(const Project& project, std::mt19937& random) {
    const double time = std::uniform_real_distribution<double>(0.5, 6)(random);
    const auto& design = project.design;
    const auto marks = static_cast<int>(project.markers.size());
    switch (random() % 5) {
        case 0:
            if (design.handles.size() >= 8) break;
            {
                Project next = project;
                const std::vector<Vec3> at = {Vec3::Zero()};
                next.design = withHandle(design, at, "Late " + std::to_string(design.handles.size()), time);
                return next;
            }
        case 1:
            return *withoutCycle(project);
        case 2:
            if (marks > 0) return *withoutMarker(project, marks - 1);
            break;
        case 3:
            return *withMarker(project, time, "Marker");
        default:
            break;
    }
    return random() % 2 == 0 ? *withCycle(project, time, {}) : *withCycle(project, {}, time);
}

/// Poses a handle at a key: with a random pose, or a copy of one of this or another handle, mirrored or not.
template <int Dim>
CopiedKey randomPose(const Project& project, int handle, std::mt19937& random,
                     const std::vector<Vec3>& starts) {
    CopiedKey copy{handle, 0, Amount::Zero(), {random() % 2 == 0, random() % 2 == 0}};
    for (int k = 0; k < Dim; ++k) copy.offset[k] = std::uniform_real_distribution<double>(-5, 5)(random);
    const int other = static_cast<int>(random() % starts.size());
    const std::vector<double> times = keyTimes(project.design, other);
    if (times.empty() || random() % 2 == 0) return copy;
    const double time = times[random() % times.size()];
    copy = copiedKeys(project.design, {{other, time}}, starts).at(0);
    copy.handle = handle;
    if (random() % 2 == 0) copy.offset[0] = -copy.offset[0];
    return copy;
}

/// A random edit of a few keys of one handle, or of its motions; the handle is −1 for one of none.
template <int Dim>
Project randomEdit(const Project& project, int& handle, std::mt19937& random, double& from, double& to) {
    const auto upTo = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    if (upTo(12) == 0) {
        handle = -1;
        return randomAddition<Dim>(project, random);
    }
    const std::vector<double> times = keyTimes(project.design, handle);
    const std::vector<Vec3> starts(project.design.handles.size(), Vec3::Zero());
    const int what = times.empty() ? 5 : times.size() > 30 ? upTo(2) : upTo(7);
    if (what == 5) {
        const CopiedKey copy = randomPose<Dim>(project, handle, random, starts);
        const double time = uniform(0, 8);
        std::vector<KeyId> pasted;
        Project next = *withKeysPasted(project, {copy}, time, starts, pasted);
        from = to = pasted.empty() ? time : pasted[0].time;
        return next;
    }
    const double key = times[static_cast<std::size_t>(upTo(static_cast<int>(times.size())))];
    from = to = key;
    Project next = project;
    if (what == 0 && times.size() <= 30) return *withKeysMoved(project, {{handle, key}}, uniform(-1, 1));
    if (what <= 1) next.design = withoutKeys(project.design, {{handle, key}});
    if (what == 2) {  // it moves the next key, too
        const auto after = std::ranges::upper_bound(times, key);
        to = after == times.end() ? key : *after;
        next.design = withKeysHeld(project.design, {{handle, key}});
    }
    if (what == 3) next.design = withKeyEase(project.design, {{handle, key}}, {upTo(2) == 0, upTo(2) == 0});
    if (what == 6) {
        const auto between = motionsBetween(project.design, {{handle, key}});
        const Progress progress{uniform(-0.5, 1.5), uniform(-0.5, 1.5)};
        const auto& motion = project.design.handles[static_cast<std::size_t>(handle)]
                                 .motions[static_cast<std::size_t>(between.at(0).motion)];
        from = motion.start, to = motion.end;
        next.design = withProgress(project.design, between, progress, starts);
    }
    if (what == 4) {
        auto motions = project.design.handles[handle].motions;
        const int motion = upTo(static_cast<int>(motions.size()));
        from = motions[static_cast<std::size_t>(motion)].start,
        to = motions[static_cast<std::size_t>(motion)].end;
        next.design = upTo(2) == 0 ? straightened(project.design, {{handle, motion}})
                                   : withFewKeys(project.design, {{handle, motion}}, 0.1);
    }
    return next;
}

/// A film with motions of every kind.
template <int Dim>
Project fullFilm() {
    const auto along = [](double x) { return inSpace(Vec<Dim>(Vec<Dim>::Constant(x))); };
    Project project = film<Dim>();
    Recorded<3> stroke;
    for (int k = 0; k < 9; ++k) {
        stroke.times.push_back(k);
        stroke.points.push_back(along(std::sin(k)));
    }
    CurveMotion<3> path, grows;
    for (int k = 0; k < 7; ++k) path.points.push_back(along(std::cos(3 * k)));
    grows.points.assign(4, along(3));
    grows.scale = 1.5;
    FieldMotion<3> field;
    field.values =
        std::make_shared<const Displacements<3>>(Displacements<3>{{3, Vec3::Unit(0)}, {7, Vec3::Unit(1)}});
    motionsOf<Dim>(project, 2) = {{stroke, 0.5, 3}, {path, 3.5, 4.5}};
    motionsOf<Dim>(project, 1).push_back({grows, 3, 5, Ease::InOut});
    motionsOf<Dim>(project, 1).push_back({field, 5.5, 7, Ease::Out});
    return project;
}

/// Checks that motions are in order, that those of the handle which do not touch its edited keys from `left`
/// to `right` keep their bits, and that the handle's places at untouched keys are unchanged.
template <int Dim>
void compareRest(Project& before, Project& after, int handle, double left, double right) {
    const auto &old = motionsOf<Dim>(before, handle), &now = motionsOf<Dim>(after, handle);
    for (std::size_t i = 1; i < now.size(); ++i) QVERIFY(now[i - 1].end <= now[i].start);
    for (const auto& motion : now) QVERIFY(motion.end > motion.start);
    for (const auto& motion : old) {
        if (motion.end > left && motion.start < right) continue;
        const auto same = std::ranges::find(now, motion.start, &PinMotion::start);
        QVERIFY(same != now.end() && sameBits<Dim>(*same, motion));
    }
    for (const double time : keyTimes(before.design, handle))
        if (time <= left || time >= right)
            QVERIFY((placeAt<Dim>(after, handle, time) - placeAt<Dim>(before, handle, time)).norm() < 1e-8);
}

/// Makes a random edit and compares the rest; returns whether it changed anything.
template <int Dim>
bool editAtRandom(Document& document, std::mt19937& random) {
    Project before = *document.project();
    const int count = static_cast<int>(before.design.handles.size());
    int handle = static_cast<int>(random() % static_cast<unsigned>(count));
    double from = 0, to = 0;
    Project after = randomEdit<Dim>(before, handle, random, from, to);
    const double never = std::numeric_limits<double>::infinity();
    for (int h = 0; h < count; ++h) {
        const auto times = keyTimes(before.design, h);
        const auto low = std::ranges::lower_bound(times, from), high = std::ranges::upper_bound(times, to);
        const bool isEdited = h == handle;
        const double left = !isEdited ? never : low == times.begin() ? -1 : *std::prev(low);
        const double right = !isEdited ? -never : high == times.end() ? 1e9 : *high;
        compareRest<Dim>(before, after, h, left, right);
    }
    if (handle >= 0 && after.end == before.end &&
        sameBits<Dim>(motionsOf<Dim>(before, handle), motionsOf<Dim>(after, handle)))
        return false;
    document.change(QStringLiteral("Edit"), std::move(after));
    return true;
}

template <int Dim>
void editThousands() {
    std::mt19937 random(Dim);
    Document document;
    OpenedFile file;
    file.project = std::make_shared<const Project>(fullFilm<Dim>());
    document.open(std::move(file));
    const std::string text = toJson(*document.project());
    int changes = 0;
    for (int round = 0; round < 3600 && !QTest::currentTestFailed(); ++round)
        changes += editAtRandom<Dim>(document, random);
    qInfo("%d edits", changes);
    QVERIFY(changes > 2000);
    while (document.undoStack()->canUndo()) document.undoStack()->undo();
    QCOMPARE(toJson(*document.project()), text);
    while (document.undoStack()->canRedo()) document.undoStack()->redo();
    QVERIFY(toJson(*document.project()) != text);
    document.undoStack()->setIndex(0);
    QCOMPARE(toJson(*document.project()), text);
}

}  // namespace

/// Thousands of edits (keys moved, copied, pasted, mirrored, held, removed and eased, recordings simplified,
/// late pins, cycles and markers) keep the bits of other handles and of motions that do not touch the edited
/// keys. Motions stay in order, places at untouched keys stay, and undoing everything gives the first file
/// byte for byte.
void TestKeys::randomEditsKeepTheRest() {
    QFETCH(int, dimension);
    dimension == 2 ? editThousands<2>() : editThousands<3>();
}

QTEST_APPLESS_MAIN(TestKeys)
#include "test_keys.moc"
