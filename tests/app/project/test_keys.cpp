#include <QTest>
#include <QUndoStack>
#include <array>
#include <random>

#include "app/project/edits/document.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/key_edits.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/edits/progress.h"
#include "app/project/edits/simplify_edits.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/motion/constraints.h"
#include "core/motion/easing.h"

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

/// One that moves from 0 to 1 and to 2 s, holds, and moves from 3 to 4 s, and one that moves from 1 to 2 s,
/// in a film of 5 s.
template <int Dim>
Project film() {
    Design<Dim> design;
    for (const char* name : {"A", "B", "C"}) {
        Handle<Dim> handle;
        handle.name = name;
        handle.at = std::vector<Vec<Dim>>{Vec<Dim>::Zero()};
        design.handles.push_back(handle);
    }
    const Vec<Dim> x = Vec<Dim>::Unit(0), y = Vec<Dim>::Unit(1);
    design.handles[0].motions = {
        {Translate<Dim>{x}, 0, 1}, {Translate<Dim>{2 * y}, 1, 2}, {Translate<Dim>{4 * x}, 3, 4}};
    design.handles[1].motions = {{Translate<Dim>{8 * y}, 1, 2}};
    Project project;
    project.end = 5;
    project.design = design;
    return project;
}

template <int Dim>
std::vector<Motion<Dim>>& motionsOf(Project& project, int handle) {
    return std::get<Design<Dim>>(project.design).handles[static_cast<std::size_t>(handle)].motions;
}

template <int Dim>
Vec<Dim> placeAt(const Project& project, int handle, double time) {
    const HandleTimeline<Dim> timeline(
        std::get<Design<Dim>>(project.design).handles[static_cast<std::size_t>(handle)]);
    return timeline.bodyAt(time, Side::Before).position(Vec<Dim>::Zero());
}

/// The place by the closed form of a film of straight motions, independent of the timeline.
Vec<2> straightPlace(const std::vector<Motion<2>>& motions, double time) {
    Vec<2> place = Vec<2>::Zero();
    for (const Motion<2>& motion : motions) {
        const double s = std::clamp((time - motion.start) / (motion.end - motion.start), 0.0, 1.0);
        const std::array factors = {s, s * s, s * (2 - s), s * s * (3 - 2 * s)};
        place += factors[static_cast<std::size_t>(motion.ease)] * std::get<Translate<2>>(motion.kind).by;
    }
    return place;
}

Project with(Project project, AnyDesign design) {
    project.design = std::move(design);
    return project;
}

/// Of motions that are straight, curves or recorded.
template <int Dim>
bool sameBits(const Motion<Dim>& a, const Motion<Dim>& b) {
    if (a.start != b.start || a.end != b.end || a.ease != b.ease || a.kind.index() != b.kind.index())
        return false;
    if (const auto* straight = std::get_if<Translate<Dim>>(&a.kind))
        return straight->by == std::get<Translate<Dim>>(b.kind).by;
    if (const auto* curve = std::get_if<CurveMotion<Dim>>(&a.kind)) {
        const auto& other = std::get<CurveMotion<Dim>>(b.kind);
        return curve->points == other.points && curve->scale == other.scale;
    }
    if (const auto* field = std::get_if<FieldMotion<Dim>>(&a.kind))
        return *field->values == *std::get<FieldMotion<Dim>>(b.kind).values;
    const auto &stroke = std::get<Recorded<Dim>>(a.kind), &other = std::get<Recorded<Dim>>(b.kind);
    return stroke.times == other.times && stroke.points == other.points;
}

template <int Dim>
bool sameBits(const std::vector<Motion<Dim>>& a, const std::vector<Motion<Dim>>& b) {
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
    QVERIFY((placeAt<2>(moved, 0, 0.75) - Vec<2>(0.5, 0)).norm() < 1e-14);
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
    QVERIFY((placeAt<2>(after, 0, 1) - Vec<2>(0.5, 1)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 2) - Vec<2>(1, 2)).norm() < 1e-14);
    after = with(before, withoutKeys(before.design, {{0, 2}}));  // to the next key instead
    QVERIFY((placeAt<2>(after, 0, 2) - Vec<2>(1, 1)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 4) - Vec<2>(5, 2)).norm() < 1e-14);
    after = with(before, withoutKeys(before.design, {{0, 4}}));  // the last one: it stays
    QVERIFY((placeAt<2>(after, 0, 5) - Vec<2>(1, 2)).norm() < 1e-14);
    after = with(before, withoutKeys(before.design, {{1, 1}}));  // the first one: from rest
    QVERIFY((placeAt<2>(after, 1, 1) - Vec<2>(0, 4)).norm() < 1e-14);
    QCOMPARE(toJson(with(before, withoutKeys(before.design, {{0, 0}}))), toJson(before));
    after = with(before, withoutKeys(before.design, {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}}));
    QVERIFY(motionsOf<2>(after, 0).empty());
}

void TestKeys::heldKeysStay() {
    const Project before = film<2>();
    Project after = with(before, withKeysHeld(before.design, {{0, 1}}));
    for (const double time : {1.0, 1.5, 2.0})
        QVERIFY((placeAt<2>(after, 0, time) - Vec<2>(1, 0)).norm() < 1e-14);
    for (const double time : {3.0, 4.0})  // it is back where it was
        QVERIFY((placeAt<2>(after, 0, time) - placeAt<2>(before, 0, time)).norm() < 1e-14);
    after = with(before, withKeysHeld(before.design, {{0, 0}}));
    QVERIFY(placeAt<2>(after, 0, 1) == Vec<2>(0, 0));
    QVERIFY((placeAt<2>(after, 0, 2) - placeAt<2>(before, 0, 2)).norm() < 1e-14);
    after = with(before, withKeysHeld(before.design, {{0, 3}}));
    QVERIFY((placeAt<2>(after, 0, 5) - Vec<2>(1, 2)).norm() < 1e-14);
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
    const std::vector<Vec<2>> starts(3, Vec<2>::Zero());
    const auto copies = copiedKeys<2>(std::get<Design<2>>(before.design), {{0, 2}, {0, 1}, {1, 2}}, starts);
    QCOMPARE(copies.size(), 3U);
    QVERIFY(copies[0].after == 0 && copies[1].after == 1 && copies[2].after == 1);
    QVERIFY(copies[0].offset == Amount(1, 0, 0) && copies[1].offset == Amount(1, 2, 0));
    std::vector<KeyId> pasted;
    Project after = *withKeysPasted<2>(before, copies, 6, starts, pasted);
    QCOMPARE(pasted, (std::vector<KeyId>{{0, 6}, {0, 7}, {1, 7}}));
    QCOMPARE(after.end, 7.0);
    QVERIFY((placeAt<2>(after, 0, 6) - Vec<2>(1, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 7) - Vec<2>(1, 2)).norm() < 1e-14);
    QVERIFY((placeAt<2>(after, 0, 5) - Vec<2>(3, 1)).norm() < 1e-14);  // on the way from 4 to 6
    QVERIFY((placeAt<2>(after, 1, 7) - Vec<2>(0, 8)).norm() < 1e-14);
    for (double time = 0; time <= 4; time += 0.25)
        QVERIFY((placeAt<2>(after, 0, time) - placeAt<2>(before, 0, time)).norm() < 1e-14);
    auto others = copies;  // on a pin that does not move; one where it rests
    for (CopiedKey& copy : others) copy.handle = 2;
    others.pop_back();
    after = *withKeysPasted<2>(before, others, 0, starts, pasted);
    QCOMPARE(pasted, (std::vector<KeyId>{{2, 1}}));
    QVERIFY((placeAt<2>(after, 2, 3) - Vec<2>(1, 2)).norm() < 1e-14);
}

/// A pose at the end of an eased motion: one vector less or more, the same easing.
void TestKeys::straightMotionsKeepTheirEasing() {
    Project project = film<2>();
    project.design = withKeyEase(project.design, {{0, 1}, {0, 2}}, {true, true});
    Gesture gesture;
    gesture.handles = {0};
    gesture.path = {Amount::Zero(), Amount(0, 3, 0)};
    gesture.from = 1;
    auto after = *withPose<2>(project, gesture, {Vec<2>(1, 0)});
    const auto& motions = motionsOf<2>(after, 0);
    QVERIFY(std::get<Translate<2>>(motions[0].kind).by == Vec<2>(1, 3));
    QVERIFY(std::get<Translate<2>>(motions[1].kind).by == Vec<2>(0, -1));
    QVERIFY(motions[0].ease == Ease::Out && motions[1].ease == Ease::InOut);
}

/// Straight pieces with easing are found again; anything else is followed within the tolerance.
void TestKeys::recordingsBecomeKeys() {
    std::vector<Motion<2>> pieces;
    for (int i = 0; i < 4; ++i)
        pieces.push_back(
            {Translate<2>{Vec<2>(i % 2 == 0 ? 10 : -6, 3 * i)}, i * 1.0, i + 1.0, static_cast<Ease>(i)});
    Recorded<2> stroke;
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
    Vec<2> at = Vec<2>::Zero();
    for (Vec<2>& point : stroke.points) point = at += Vec<2>(step(random), step(random));
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
    const auto& design = std::get<Design<Dim>>(project.design);
    const auto marks = static_cast<int>(project.markers.size());
    switch (random() % 5) {
        case 0:
            if (design.handles.size() >= 8) break;
            {
                Project next = project;
                const std::vector<Vec<Dim>> at = {Vec<Dim>::Zero()};
                next.design =
                    withHandle<Dim>(design, at, "Late " + std::to_string(design.handles.size()), time);
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

/// A pose of a handle: any one, or a copy of one that it or another handle has, mirrored or not.
template <int Dim>
CopiedKey randomPose(const Project& project, int handle, std::mt19937& random,
                     const std::vector<Vec<Dim>>& starts) {
    CopiedKey copy{handle, 0, Amount::Zero(), {random() % 2 == 0, random() % 2 == 0}};
    for (int k = 0; k < Dim; ++k) copy.offset[k] = std::uniform_real_distribution<double>(-5, 5)(random);
    const int other = static_cast<int>(random() % starts.size());
    const std::vector<double> times = keyTimes(project.design, other);
    if (times.empty() || random() % 2 == 0) return copy;
    const double time = times[random() % times.size()];
    copy = copiedKeys<Dim>(std::get<Design<Dim>>(project.design), {{other, time}}, starts).at(0);
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
    const std::vector<Vec<Dim>> starts(std::get<Design<Dim>>(project.design).handles.size(),
                                       Vec<Dim>::Zero());
    const int what = times.empty() ? 5 : times.size() > 30 ? upTo(2) : upTo(7);
    if (what == 5) {
        const CopiedKey copy = randomPose<Dim>(project, handle, random, starts);
        const double time = uniform(0, 8);
        std::vector<KeyId> pasted;
        Project next = *withKeysPasted<Dim>(project, {copy}, time, starts, pasted);
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
        const auto& motion = std::get<Design<Dim>>(project.design)
                                 .handles[static_cast<std::size_t>(handle)]
                                 .motions[static_cast<std::size_t>(between.at(0).motion)];
        from = motion.start, to = motion.end;
        next.design = withProgress<Dim>(std::get<Design<Dim>>(project.design), between, progress, starts);
    }
    if (what == 4) {
        auto motions = std::get<Design<Dim>>(project.design).handles[handle].motions;
        const int motion = upTo(static_cast<int>(motions.size()));
        from = motions[static_cast<std::size_t>(motion)].start,
        to = motions[static_cast<std::size_t>(motion)].end;
        next.design = upTo(2) == 0 ? straightened(project.design, {{handle, motion}})
                                   : withFewKeys(project.design, {{handle, motion}}, 0.1);
    }
    return next;
}

}  // namespace

/// Thousands of edits (keys moved, copied, pasted, mirrored, held, removed and eased, recordings made simple,
/// late pins, cycles and markers): other handles, and motions that do not touch the edited keys, keep their
/// bits; motions stay in order; where the handle was at untouched keys it is; undo to the start gives the
/// first file byte for byte.
void TestKeys::randomEditsKeepTheRest() {
    QFETCH(int, dimension);
    const auto check = [](auto dim) {
        constexpr int Dim = decltype(dim)::value;
        std::mt19937 random(Dim);
        Document document;
        OpenedFile file;
        Project first = film<Dim>();
        Recorded<Dim> stroke;
        for (int k = 0; k < 9; ++k) {
            stroke.times.push_back(k);
            stroke.points.push_back(Vec<Dim>::Constant(std::sin(k)));
        }
        motionsOf<Dim>(first, 2) = {{stroke, 0.5, 3}};
        CurveMotion<Dim> path;
        for (int k = 0; k < 7; ++k) path.points.push_back(Vec<Dim>::Constant(std::cos(3 * k)));
        motionsOf<Dim>(first, 2).push_back({path, 3.5, 4.5});
        CurveMotion<Dim> grows;
        grows.points.assign(4, Vec<Dim>::Constant(3));
        grows.scale = 1.5;
        FieldMotion<Dim> field;
        field.values = std::make_shared<const Displacements<Dim>>(
            Displacements<Dim>{{3, Vec<Dim>::Unit(0)}, {7, Vec<Dim>::Unit(1)}});
        motionsOf<Dim>(first, 1).push_back({grows, 3, 5, Ease::InOut});
        motionsOf<Dim>(first, 1).push_back({field, 5.5, 7, Ease::Out});
        file.project = std::make_shared<const Project>(first);
        document.open(std::move(file));
        const std::string text = toJson(*document.project());
        int changes = 0;
        for (int round = 0; round < 3000; ++round) {
            const Project before = *document.project();
            const int count = static_cast<int>(std::get<Design<Dim>>(before.design).handles.size());
            int handle = static_cast<int>(random() % static_cast<unsigned>(count));
            double from = 0, to = 0;
            Project after = randomEdit<Dim>(before, handle, random, from, to);
            Project was = before;
            for (int h = 0; h < count; ++h) {
                const auto &old = motionsOf<Dim>(was, h), &now = motionsOf<Dim>(after, h);
                for (std::size_t i = 1; i < now.size(); ++i) QVERIFY(now[i - 1].end <= now[i].start);
                for (const auto& motion : now) QVERIFY(motion.end > motion.start);
                const auto times = keyTimes(before.design, h);
                const auto low = std::ranges::lower_bound(times, from);
                const double left = low == times.begin() ? -1 : *std::prev(low);
                const auto high = std::ranges::upper_bound(times, to);
                const double right = high == times.end() ? 1e9 : *high;
                for (const auto& motion : old) {
                    if (h == handle && motion.end > left && motion.start < right) continue;
                    const auto same = std::ranges::find(now, motion.start, &Motion<Dim>::start);
                    QVERIFY(same != now.end() && sameBits<Dim>(*same, motion));
                }
                for (const double time : times)
                    if (h != handle || time <= left || time >= right)
                        QVERIFY((placeAt<Dim>(after, h, time) - placeAt<Dim>(before, h, time)).norm() < 1e-8);
            }
            if (handle >= 0 && after.end == before.end &&
                sameBits<Dim>(motionsOf<Dim>(was, handle), motionsOf<Dim>(after, handle)))
                continue;
            document.change(QStringLiteral("Edit"), std::move(after));
            ++changes;
        }
        qInfo("%d edits", changes);
        QVERIFY(changes > 2000);
        while (document.undoStack()->canUndo()) document.undoStack()->undo();
        QCOMPARE(toJson(*document.project()), text);
        while (document.undoStack()->canRedo()) document.undoStack()->redo();
        QVERIFY(toJson(*document.project()) != text);
        document.undoStack()->setIndex(0);
        QCOMPARE(toJson(*document.project()), text);
    };
    if (dimension == 2)
        check(std::integral_constant<int, 2>());
    else
        check(std::integral_constant<int, 3>());
}

QTEST_APPLESS_MAIN(TestKeys)
#include "test_keys.moc"
