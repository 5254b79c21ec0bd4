#include <QTest>
#include <random>

#include "app/project/edits/key_edits.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/motion/constraints.h"
#include "core/motion/trajectory.h"

using namespace wend;

/// A drag at a time sets the pin's place then, and all other times stay as they were.
class TestPoses : public QObject {
    Q_OBJECT
  private slots:
    void leadsThroughTheNewPose();
    void movesAKeyPose();
    void comesFromWhereItHeld();
    void startsAtRest();
    void pathsAreSplitExactly_data();
    void pathsAreSplitExactly();
    void scalingsAndFieldsAreSplitExactly_data();
    void scalingsAndFieldsAreSplitExactly();
    void easedScalingsAndFieldsKeepTheirKeys_data();
    void easedScalingsAndFieldsKeepTheirKeys();
    void evenRotationsStayRotations_data();
    void evenRotationsStayRotations();
    void rotationsAreKept_data();
    void rotationsAreKept();
    void longerFilmKeepsItsTimes();
    void randomPosesKeepTheRest_data();
    void randomPosesKeepTheRest();
};

namespace {

template <int Dim>
Pin pin(const std::string& name) {
    Pin handle;
    handle.name = name;
    handle.at = std::vector<Vec3>{Vec3::Zero()};
    return handle;
}

/// Returns a film of 4 s with a handle that moves from 0 to 1 s and from 2 to 3 s, and one that does not
/// move.
template <int Dim>
Project film() {
    Design design;
    design.handles = {pin<Dim>("A"), pin<Dim>("B")};
    design.handles[0].motions = {{Translate<3>{Vec3::Unit(0)}, 0, 1},
                                 {Translate<3>{2 * Vec3::Unit(1)}, 2, 3}};
    Project project;
    project.end = 4;
    project.design = design;
    return project;
}

/// The place of a handle's point that rests at the origin.
template <int Dim>
Vec3 placeAt(const Project& project, int handle, double time) {
    const HandleTimeline<3> timeline(handleIn<3>(project.design.handles[handle]));
    return timeline.bodyAt(time, Side::Before).position(Vec3::Zero());
}

template <int Dim>
std::optional<Project> posed(const Project& project, int handle, double time, const Vec3& by) {
    Gesture gesture;
    gesture.handles = {handle};
    gesture.path = {Amount::Zero(), (by)};
    gesture.from = time;
    return withPose(project, gesture, {placeAt<Dim>(project, handle, time)});
}

/// Returns the place at time t of vertex 7, which starts from `start` and follows the first handle.
Vec3 vertexAt(const Project& project, double t, const Vec3& start) {
    Vec3 place = start;
    for (const auto& motion : project.design.handles[0].motions) {
        const auto map = Trajectory<3>(motion).at(t, Side::Before);
        place = map.position(place);
        if (const auto* field = std::get_if<FieldMotion<3>>(&motion.kind))
            place += map.share * field->values->front().second;
    }
    return place;
}

}  // namespace

void TestPoses::leadsThroughTheNewPose() {
    const Project before = film<2>();
    const auto after = posed<2>(before, 0, 2.5, {3, 0, 0});
    QVERIFY(after);
    QCOMPARE(after->design.handles[0].motions.size(), 3U);
    QCOMPARE(after->end, 4.0);
    for (const double time : {0.0, 0.3, 1.0, 1.7, 2.0, 3.0, 3.5})
        QVERIFY((placeAt<2>(*after, 0, time) - placeAt<2>(before, 0, time)).norm() < 1e-14);
    QVERIFY((placeAt<2>(*after, 0, 2.5) - Vec3(4, 1, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(*after, 0, 2.25) - Vec3(2.5, 0.5, 0)).norm() < 1e-14);
}

void TestPoses::movesAKeyPose() {
    const Project before = film<2>();
    const auto after = posed<2>(before, 0, 1, {0, 5, 0});  // it holds there until 2
    QVERIFY(after);
    QVERIFY((placeAt<2>(*after, 0, 1) - Vec3(1, 5, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(*after, 0, 0.5) - Vec3(0.5, 2.5, 0)).norm() < 1e-14);
    QVERIFY((placeAt<2>(*after, 0, 1.5) - Vec3(1, 2.5, 0)).norm() < 1e-14);
    for (const double time : {0.0, 2.0, 2.5, 3.0, 4.0})
        QVERIFY((placeAt<2>(*after, 0, time) - placeAt<2>(before, 0, time)).norm() < 1e-14);
    const auto last = posed<2>(before, 0, 3, {7, 0, 0});
    QVERIFY(last);
    QCOMPARE(last->design.handles[0].motions.size(), 2U);
    QVERIFY((placeAt<2>(*last, 0, 4) - Vec3(8, 2, 0)).norm() < 1e-14);
}

void TestPoses::comesFromWhereItHeld() {
    const auto after = posed<2>(film<2>(), 1, 1.5, {6, 0, 0});
    QVERIFY(after);
    QVERIFY((placeAt<2>(*after, 1, 0.75) - Vec3(3, 0, 0)).norm() < 1e-14);
    for (const double time : {1.5, 2.0, 4.0})
        QVERIFY((placeAt<2>(*after, 1, time) - Vec3(6, 0, 0)).norm() < 1e-14);
}

/// Nothing can be posed before a handle acts, where the shape is at rest.
void TestPoses::startsAtRest() {
    QVERIFY(!posed<2>(film<2>(), 0, 0, {1, 0, 0}));
    QVERIFY(!posed<2>(film<2>(), 1, 0, {1, 0, 0}));
}

void TestPoses::pathsAreSplitExactly_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("interpolation");
    QTest::addColumn<int>("motions");
    QTest::addColumn<int>("easing");
    const int even = int(Ease::Linear);
    for (const int dimension : {2, 3}) {
        QTest::addRow("chain, %dD", dimension) << dimension << int(Interpolation::Bezier) << 4 << even;
        QTest::addRow("spline, %dD", dimension) << dimension << int(Interpolation::Spline) << 7 << even;
        for (const Ease ease : {Ease::In, Ease::Out, Ease::InOut})
            QTest::addRow("polyline with easing %d, %dD", int(ease), dimension)
                << dimension << int(Interpolation::Polyline) << 7 << int(ease);
    }
}

/// A chain of four cubics, a spline through seven points of unequal distances, and eased polylines: at all
/// times the pin is where it was, plus the displacement times a factor that rises from the path's start to
/// the pose and falls to its end. The places before are the trajectory's own.
void TestPoses::pathsAreSplitExactly() {
    QFETCH(int, dimension);
    QFETCH(int, interpolation);
    QFETCH(int, motions);
    QFETCH(int, easing);
    const auto check = [&](auto dim) {
        constexpr int Dim = decltype(dim)::value;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> any(-5, 5);
        CurveMotion<3> curve;
        curve.interpolation = static_cast<Interpolation>(interpolation);
        for (int k = 0; k < (curve.interpolation == Interpolation::Bezier ? 13 : 7); ++k) {
            Vec3 point = Vec3::Zero();
            for (int i = 0; i < Dim; ++i) point[i] = any(random);
            curve.points.push_back(k == 0 ? Vec3(Vec3::Zero()) : point);
        }
        Project before = film<Dim>();
        before.design.handles[0].motions = {{curve, 0.5, 3.5, static_cast<Ease>(easing)}};
        const Vec3 by = 2 * Vec3::Unit(0) - Vec3::Unit(1);
        const double time = easing == int(Ease::In) ? 2.3 : 1.7;  // not too near a joint
        const auto after = posed<Dim>(before, 0, time, by);
        QVERIFY(after);
        QCOMPARE(int(after->design.handles[0].motions.size()), motions);
        double worst = 0;
        for (int k = 0; k <= 400; ++k) {
            const double t = 4 * k / 400.0;
            const double factor =
                std::clamp(std::min((t - 0.5) / (time - 0.5), (3.5 - t) / (3.5 - time)), 0.0, 1.0);
            const Vec3 wanted = placeAt<Dim>(before, 0, t) + factor * by;
            worst = std::max(worst, (placeAt<Dim>(*after, 0, t) - wanted).norm());
        }
        QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
    };
    if (dimension == 2)
        check(std::integral_constant<int, 2>());
    else
        check(std::integral_constant<int, 3>());
}

void TestPoses::scalingsAndFieldsAreSplitExactly_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("kind");
    for (const int dimension : {2, 3}) {
        QTest::addRow("about a centre, %dD", dimension) << dimension << 1;
        QTest::addRow("along a chain, %dD", dimension) << dimension << 4;
        QTest::addRow("along a spline, %dD", dimension) << dimension << 0;
        QTest::addRow("field, %dD", dimension) << dimension << -1;
    }
}

/// The body grows, and the field is scaled by its share: all points are displaced by the pose times its
/// factor at all times, and are back where they were once the key is removed.
void TestPoses::scalingsAndFieldsAreSplitExactly() {
    QFETCH(int, dimension);
    QFETCH(int, kind);
    const auto check = [&](auto dim) {
        constexpr int Dim = decltype(dim)::value;
        std::mt19937 random(11);
        std::uniform_real_distribution<double> any(-2, 2);
        const auto anyPoint = [&] {
            Vec3 point = Vec3::Zero();
            for (int i = 0; i < Dim; ++i) point[i] = any(random);
            return point;
        };
        Project before = film<Dim>();
        auto& motion = before.design.handles[0].motions[1];  // from 2 to 3
        const Vec3 own = anyPoint();
        if (kind < 0) {
            FieldMotion<3> field;
            field.values = std::make_shared<const Displacements<3>>(Displacements<3>{{7, own}});
            motion.kind = field;
        } else {
            CurveMotion<3> grows;
            grows.scale = 0.3;
            grows.interpolation = kind == 0 ? Interpolation::Spline : Interpolation::Bezier;
            for (int k = 0; k < (kind == 0 ? 5 : 3 * kind + 1); ++k)
                grows.points.push_back(k == 0 || kind != 1 ? anyPoint() : grows.points.front());
            motion.kind = grows;
        }
        const double time = 2.4;
        const Vec3 by = 0.5 * Vec3::Unit(0) - 0.7 * Vec3::Unit(1);
        const auto after = posed<Dim>(before, 0, time, by);
        QVERIFY(after);
        const auto isBeside = [&](const Project& project, const Vec3& displacement) {
            double worst = 0;
            for (int k = 0; k <= 80; ++k) {
                const double t = k / 20.0;
                const double factor =
                    std::clamp(std::min((t - 2) / (time - 2), (3 - t) / (3 - time)), 0.0, 1.0);
                for (int i = 0; i < Dim; ++i) {
                    const Vec3 p = Vec3::Unit(i);
                    worst = std::max(
                        worst,
                        (vertexAt(project, t, p) - vertexAt(before, t, p) - factor * displacement).norm());
                }
            }
            return worst < 1e-12;
        };
        QVERIFY(isBeside(*after, by));
        if (kind > 1 || kind == 0) return;
        Project removed = *after;
        removed.design = withoutKeys(after->design, {{0, time}});
        QCOMPARE(removed.design.handles[0].motions.size(), std::size_t(2));
        QVERIFY(isBeside(removed, Vec3::Zero()));
    };
    if (dimension == 2)
        check(std::integral_constant<int, 2>());
    else
        check(std::integral_constant<int, 3>());
}

void TestPoses::easedScalingsAndFieldsKeepTheirKeys_data() {
    QTest::addColumn<int>("easing");
    QTest::addColumn<bool>("isField");
    for (const Ease easing : {Ease::In, Ease::Out, Ease::InOut})
        for (const bool isField : {false, true})
            QTest::addRow("%s, %d", isField ? "field" : "scaling", int(easing)) << int(easing) << isField;
}

/// A part of an easing is not one of the four easings. The ends of the motion, the pose, and the part before
/// it where the motion only speeds up are exact; elsewhere the nearest easing differs by little. Removing the
/// key restores the motion.
void TestPoses::easedScalingsAndFieldsKeepTheirKeys() {
    QFETCH(int, easing);
    QFETCH(bool, isField);
    constexpr double kTime = 2.4, kOff = 0.08;  // of the way
    const Vec3 own(3, -1, 0), by(0.5, -0.7, 0), centre(-2, 5, 0);
    Project before = film<2>();
    auto& motion = before.design.handles[0].motions[1];  // from 2 to 3
    motion.ease = static_cast<Ease>(easing);
    if (isField) {
        FieldMotion<3> field;
        field.values = std::make_shared<const Displacements<3>>(Displacements<3>{{7, own}});
        motion.kind = field;
    } else {
        CurveMotion<3> grows;
        grows.points.assign(4, centre);
        grows.scale = 2;
        motion.kind = grows;
    }
    const Vec3 start = Vec3::Unit(0);
    const auto after = posed<2>(before, 0, kTime, by);
    QVERIFY(after);
    QVERIFY((vertexAt(*after, kTime, start) - vertexAt(before, kTime, start) - by).norm() < 1e-12);
    const double way = (vertexAt(before, 3, start) - vertexAt(before, 2, start)).norm();
    for (int k = 0; k <= 80; ++k) {
        const double t = k / 20.0, s = t - 2;
        const double share = easing == int(Ease::In)    ? s * s
                             : easing == int(Ease::Out) ? s * (2 - s)
                                                        : s * s * (3 - 2 * s);
        const double key = 0.4, there = easing == int(Ease::In)    ? key * key
                                        : easing == int(Ease::Out) ? key * (2 - key)
                                                                   : key * key * (3 - 2 * key);
        const bool isOut = t <= 2 || t >= 3;
        const double factor = isOut ? 0 : t <= kTime ? share / there : (1 - share) / (1 - there);
        const double off = (vertexAt(*after, t, start) - vertexAt(before, t, start) - factor * by).norm();
        const bool isExact = isOut || (easing == int(Ease::In) && t <= kTime);
        QVERIFY2(off < (isExact ? 1e-12 : kOff * (way + by.norm())), qPrintable(QString::number(off)));
    }
    Project removed = *after;
    removed.design = withoutKeys(after->design, {{0, kTime}});
    QCOMPARE(removed.design.handles[0].motions.size(), std::size_t(2));
    if (easing != int(Ease::InOut)) return;  // the only one that both ends tell
    for (int k = 0; k <= 80; ++k)
        QVERIFY((vertexAt(removed, k / 20.0, start) - vertexAt(before, k / 20.0, start)).norm() < 1e-12);
}

void TestPoses::evenRotationsStayRotations_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<bool>("isAcross");
    QTest::addRow("2D") << 2 << true;
    QTest::addRow("3D, across the axis") << 3 << true;
    QTest::addRow("3D, along the axis too") << 3 << false;
}

/// The body keeps the rotation that it had at all times, is displaced at the key, and is where it was before
/// and after. Removing the key restores the rotation.
void TestPoses::evenRotationsStayRotations() {
    QFETCH(int, dimension);
    QFETCH(bool, isAcross);
    const auto check = [&](auto dim) {
        constexpr int Dim = decltype(dim)::value;
        Project before = film<Dim>();
        Rotate<3> turn;
        turn.centre = 3 * Vec3::Unit(1);
        turn.axis = 2 * Vec3::UnitZ();
        turn.angle = 2.5;
        before.design.handles[0].motions[1].kind = turn;  // from 2 to 3
        const double time = 2.4;
        const Vec3 by =
            0.5 * Vec3::Unit(0) - 0.7 * Vec3::Unit(1) + (isAcross ? 0 : 0.4) * Vec3::Unit(Dim - 1);
        const auto after = posed<Dim>(before, 0, time, by);
        QVERIFY(after);
        const auto& motions = after->design.handles[0].motions;
        QCOMPARE(int(motions.size()), 3);
        QCOMPARE(std::holds_alternative<Rotate<3>>(motions[1].kind), isAcross);
        const auto at = [&](const Project& project, double t, const Vec3& p) {
            const HandleTimeline<3> timeline(handleIn<3>(project.design.handles[0]));
            return timeline.bodyAt(t, Side::Before).position(p);
        };
        Project removed = *after;
        removed.design = withoutKeys(after->design, {{0, time}});
        QCOMPARE(removed.design.handles[0].motions.size(), std::size_t(2));
        for (int k = 0; k <= 80; ++k) {
            const double t = k / 20.0;
            const Vec3 zero = Vec3::Zero(), off = at(*after, t, zero) - at(before, t, zero);
            for (int i = 0; i < Dim; ++i) {
                const Vec3 p = Vec3::Unit(i);
                QVERIFY((at(*after, t, p) - at(before, t, p) - off).norm() < 1e-12);  // the same rotation
                QVERIFY((at(removed, t, p) - at(before, t, p)).norm() < 1e-12);
            }
            QVERIFY(off.norm() < 1.5 * by.norm());
            if (t <= 2 || t >= 3) QVERIFY(off.norm() < 1e-12);
            if (k == 48) QVERIFY((off - by).norm() < 1e-12);
        }
    };
    if (dimension == 2)
        check(std::integral_constant<int, 2>());
    else
        check(std::integral_constant<int, 3>());
}

void TestPoses::rotationsAreKept_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("kind");
    for (const int dimension : {2, 3}) {
        QTest::addRow("rotation, %dD", dimension) << dimension << 0;
        QTest::addRow("frame, %dD", dimension) << dimension << 1;
        QTest::addRow("rotation at a key, %dD", dimension) << dimension << 2;
    }
}

/// Three points of a rotating body are displaced by the same vector times its factor; before and after the
/// motion they are where they were.
void TestPoses::rotationsAreKept() {
    QFETCH(int, dimension);
    QFETCH(int, kind);
    const auto check = [&](auto dim) {
        constexpr int Dim = decltype(dim)::value;
        Project before = film<Dim>();
        auto& motion = before.design.handles[0].motions[1];  // from 2 to 3
        if (kind == 1) {
            CurveMotion<3> curve;
            curve.frame = FrameKind::Minimal;
            for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {3.0, 2.0}, {2.0, 4.0}})
                curve.points.push_back(x * Vec3::Unit(0) + y * Vec3::Unit(Dim - 1));
            motion.kind = curve;
        } else {
            Rotate<3> turn;
            turn.centre = 3 * Vec3::Unit(1);
            turn.axis = Dim == 2 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::Constant(1).normalized());
            turn.angle = 4;  // more than half a turn
            motion.kind = turn;
        }
        motion.ease = Ease::InOut;
        const double time = kind == 2 ? 3 : 2.4;
        const Vec3 by = 0.5 * Vec3::Unit(0) - 0.7 * Vec3::Unit(1);
        const auto after = posed<Dim>(before, 0, time, by);
        QVERIFY(after);
        const auto& handle = after->design.handles[0];
        QCOMPARE(int(handle.motions.size()), kind == 2 ? 2 : 3);
        const auto at = [&](const Project& project, double t, const Vec3& p) {
            const HandleTimeline<3> timeline(handleIn<3>(project.design.handles[0]));
            return timeline.bodyAt(t, Side::Before).position(p);
        };
        double worst = 0;
        for (int k = 0; k <= 80; ++k) {
            const double t = k / 20.0;
            const double rises = (t - 2) / (time - 2), falls = kind == 2 ? 1 : (3 - t) / (3 - time);
            const double factor = std::clamp(std::min(rises, falls), 0.0, 1.0);
            for (int i = 0; i < Dim; ++i) {
                const Vec3 p = Vec3::Unit(i), off = at(*after, t, p) - at(before, t, p) - factor * by;
                worst = std::max(worst, off.norm());
                if (t <= 2 || (t >= 3 && kind != 2) || t == time) QVERIFY(off.norm() < 1e-9);
            }
        }
        QVERIFY2(worst < 0.01, qPrintable(QString::number(worst)));
        Project again = *after;
        const auto file = toJson(again);
        QVERIFY(file.find("\"poses\"") != std::string::npos);
    };
    if (dimension == 2)
        check(std::integral_constant<int, 2>());
    else
        check(std::integral_constant<int, 3>());
}

void TestPoses::longerFilmKeepsItsTimes() {
    const Project before = film<2>();
    Gesture gesture;
    gesture.handles = {1};
    gesture.path = {Amount::Zero(), Amount(1, 0, 0), Amount(1, 3, 0)};
    gesture.from = 4;
    const Project after = withPoseAppended(before, gesture, {Vec3::Zero()});
    QCOMPARE(after.end, 5.0);
    QVERIFY(placeAt<2>(after, 1, 5) == Vec3(1, 3, 0));
    QVERIFY((placeAt<2>(after, 1, 4.25) - Vec3(1, 0, 0)).norm() < 1e-14);
    for (double time = 0; time <= 4; time += 0.125) {
        QVERIFY(placeAt<2>(after, 0, time) == placeAt<2>(before, 0, time));
        QVERIFY(placeAt<2>(after, 1, time) == placeAt<2>(before, 1, time));
    }
}

void TestPoses::randomPosesKeepTheRest_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

namespace {

/// A film with easings, curves and recordings of its own for each round of fifty.
template <int Dim, class Vector>
Project otherFilm(int round, const Vector& vector) {
    Project project = film<Dim>();
    auto& motions = project.design.handles[0].motions;
    motions[1].ease = static_cast<Ease>(round / 50 % 4);
    CurveMotion<3> curve;
    const bool isSpline = round / 50 % 3 == 1;
    if (isSpline) curve.interpolation = Interpolation::Spline;
    const int points = isSpline ? 6 : round / 50 % 3 == 0 ? 4 : 10;
    for (int k = 0; k < points; ++k) curve.points.push_back(vector());
    project.design.handles[1].motions = {{curve, 0.5, 3}};
    Recorded<3> stroke;
    for (int k = 0; k < 6; ++k) stroke.times.push_back(k), stroke.points.push_back(vector());
    if (round % 100 == 0) motions[0].kind = stroke;
    return project;
}

/// Poses the handle at the time, or at the nearest end or start of a motion, and checks that the other handle
/// and everything beyond the neighbouring key poses are as before.
template <int Dim>
void comparePosed(const Project& project, const Project& next, int handle, double time, const Vec3& by) {
    const auto& motions = project.design.handles[handle].motions;
    double before = -1, after = 1e9;  // key poses around
    double key = time, off = 0.02;
    for (const auto& motion : motions)  // the nearest end of a motion, else a start
        if (std::abs(motion.end - time) < off) off = std::abs(motion.end - time), key = motion.end;
    for (const auto& motion : motions)
        if (key == time && std::abs(motion.start - time) < 0.02) key = motion.start;
    for (const auto& motion : motions)
        for (const double t : {motion.start, motion.end}) {
            if (t < key) before = std::max(before, t);
            if (t > key) after = std::min(after, t);
        }
    const Vec3 wanted = placeAt<Dim>(project, handle, key) + by;
    QVERIFY((placeAt<Dim>(next, handle, key) - wanted).norm() < 1e-9);
    for (double t = 0; t <= 4; t += 0.25) {
        QVERIFY(placeAt<Dim>(next, 1 - handle, t) == placeAt<Dim>(project, 1 - handle, t));
        if (t <= before || t >= after)
            QVERIFY((placeAt<Dim>(next, handle, t) - placeAt<Dim>(project, handle, t)).norm() < 1e-9);
    }
}

template <int Dim>
void poseAtRandom() {
    std::mt19937 random(Dim);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto vector = [&] {
        Vec3 v = Vec3::Zero();
        for (int k = 0; k < Dim; ++k) v[k] = uniform(-5, 5);
        return v;
    };
    int done = 0;
    Project project = film<Dim>();
    for (int round = 0; round < 1000 && !QTest::currentTestFailed(); ++round) {
        if (round % 50 == 0) {
            project = otherFilm<Dim>(round, vector);
            continue;
        }
        const int handle = static_cast<int>(uniform(0, 2));
        const double time = uniform(0, 4);
        const Vec3 by = vector();
        const auto next = posed<Dim>(project, handle, time, by);
        if (!next) continue;
        ++done;
        comparePosed<Dim>(project, *next, handle, time, by);
        project = *next;
    }
    qInfo("%d poses", done);
    QVERIFY(done > 500);
}

}  // namespace

/// Hundreds of poses of random pins at random times, with recordings, eased moves and paths: the pin is where
/// it was put, its motion beyond the neighbouring key poses stays, and that of the other pin keeps its bits.
void TestPoses::randomPosesKeepTheRest() {
    QFETCH(int, dimension);
    dimension == 2 ? poseAtRandom<2>() : poseAtRandom<3>();
}

QTEST_APPLESS_MAIN(TestPoses)
#include "test_poses.moc"
