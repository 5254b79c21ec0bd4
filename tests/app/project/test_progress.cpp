#include <QTest>
#include <array>
#include <random>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/key_edits.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/edits/progress.h"
#include "app/project/file/project_writer.h"
#include "app/project/project_fwd.h"
#include "core/motion/constraints.h"
#include "core/motion/easing.h"

using namespace wend;

/// The progress of moves between key poses: curves with two handles, written as the motions of the file.
class TestProgress : public QObject {
    Q_OBJECT
  private slots:
    void easingsAreCurves();
    void straightMovesFollowTheCurve();
    void presetsAreEasings();
    void theFileHoldsTheCurve();
    void curveIsReadBack_data();
    void curveIsReadBack();
    void recordingsKeepTheirPath();
    void rotationsHaveEasingsOnly();
    void keysEaseTheirSides();
    void posedKeysKeepTheCurve();
    void splitIsExact_data();
    void splitIsExact();
    void motionsBetweenKeys();
};

namespace {

using Film = std::shared_ptr<Project>;

/// Returns a film with a pin that moves from 0 to 1 and from 1 to 3 s.
Film film(std::vector<PinMotion> motions) {
    Pin handle;
    handle.name = "A";
    handle.at = std::vector<Vec3>{Vec3(10, 20, 0)};
    handle.motions = std::move(motions);
    Design design;
    design.handles = {handle};
    auto project = newProject();
    endOf(*project) = 5;
    domainOf(*project).path = "a.png";
    designOf(*project) = design;
    return project;
}

Pin& handleOf(const Film& project) {
    return designOf(*project).handles[0];
}

/// Returns the pin's place as `wend run` computes it.
Vec3 placeAt(const Film& project, double time) {
    return HandleTimeline<3>(handleIn<3>(handleOf(project)))
        .bodyAt(time, Side::Before)
        .position(Vec3(10, 20, 0));
}

Film eased(const Film& before, const std::vector<MotionId>& motions, const Progress& progress) {
    const Film project = copyOf(*before);
    designOf(*project) = withProgress(designOf(*before), motions, progress, {Vec3(10, 20, 0)});
    return project;
}

Recorded<3> scrawl() {
    Recorded<3> stroke;
    for (int i = 0; i <= 40; ++i) {
        const double s = i / 40.0;
        stroke.times.push_back(s * s);
        stroke.points.emplace_back(100 * s, 30 * std::sin(6 * s), 0);
    }
    return stroke;
}

/// The distance of a point from a line through points.
double offLine(const std::vector<Vec3>& line, const Vec3& p) {
    double best = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 along = line[i] - line[i - 1];
        const double s = std::clamp((p - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (line[i - 1] + s * along - p).norm());
    }
    return best;
}

}  // namespace

void TestProgress::easingsAreCurves() {
    for (const Ease kind : {Ease::Linear, Ease::In, Ease::Out, Ease::InOut}) {
        const Progress progress = progressOf(kind);
        QCOMPARE(easeOf(progress), std::optional(kind));
        for (double s = 0; s <= 1; s += 0.0625) QVERIFY(std::abs(progress.at(s) - ease(kind, s)) < 1e-15);
        QVERIFY(std::abs(progress.startSpeed() - easeRate(kind, 0)) < 1e-15);
        QVERIFY(std::abs(progress.endSpeed() - easeRate(kind, 1)) < 1e-15);
    }
    QVERIFY(!easeOf({0.1, 0.7}));
}

/// A straight move follows its curve, even one that goes beyond its end and comes back.
void TestProgress::straightMovesFollowTheCurve() {
    const Vec3 first(30, 0, 0), by(12, -16, 0);
    for (const Progress progress :
         {Progress{0.1, 0.7}, Progress{-0.3, 1.6}, Progress{0, 0}, Progress{1, 0}}) {
        const Film after = eased(film({{Translate<3>{first}, 0, 1}, {Translate<3>{by}, 1, 3, Ease::In}}),
                                 {{0, 1}}, progress);
        for (double s = 0; s <= 1; s += 0.0625) {
            const double p = 3 * s * (1 - s) * (1 - s) * progress.first +
                             3 * s * s * (1 - s) * progress.second + s * s * s;
            QVERIFY((placeAt(after, 1 + 2 * s) - (Vec3(10, 20, 0) + first + p * by)).norm() < 1e-12);
        }
        QVERIFY((placeAt(after, 0.5) - Vec3(25, 20, 0)).norm() < 1e-12);
    }
}

void TestProgress::presetsAreEasings() {
    Film project = film({{Translate<3>{{30, 0, 0}}, 0, 1}});
    project = eased(project, {{0, 0}}, {0.2, 0.9});
    QVERIFY(std::holds_alternative<CurveMotion<3>>(handleOf(project).motions[0].kind));
    for (const Ease kind : {Ease::InOut, Ease::Linear}) {
        project = eased(project, {{0, 0}}, progressOf(kind));
        QVERIFY(std::holds_alternative<Translate<3>>(handleOf(project).motions[0].kind));
        QCOMPARE(handleOf(project).motions[0].ease, kind);
        QVERIFY((std::get<Translate<3>>(handleOf(project).motions[0].kind).by - Vec3(30, 0, 0)).norm() <
                1e-13);
    }
    project = eased(project, {{0, 0}}, {0.2, 0.9});
    designOf(*project) = withMotionEase(designOf(*project), {{0, 0}}, Ease::Out);  // the menu's
    QVERIFY(std::holds_alternative<Translate<3>>(handleOf(project).motions[0].kind));
}

/// The file needs no other kind of motion: its text has a Bézier curve on the line of the move.
void TestProgress::theFileHoldsTheCurve() {
    const Film project = eased(film({{Translate<3>{{30, 0, 0}}, 0, 1}}), {{0, 0}}, {0.2, 0.9});
    const std::string text = toJson(*project);
    QVERIFY(text.find("\"kind\": \"curve\"") != std::string::npos);
    QVERIFY(text.find("\"points\": [[10, 20], [16, 20], [37, 20], [40, 20]]") != std::string::npos);
}

void TestProgress::curveIsReadBack_data() {
    QTest::addColumn<double>("first");
    QTest::addColumn<double>("second");
    for (const double first : {-0.5, 0.0, 0.3, 1.0})
        for (const double second : {0.0, 0.5, 1.0, 1.5})
            QTest::addRow("%g %g", first, second) << first << second;
}

void TestProgress::curveIsReadBack() {
    QFETCH(double, first);
    QFETCH(double, second);
    const Film straight = eased(film({{Translate<3>{{30, 7, 0}}, 0, 1}}), {{0, 0}}, {first, second});
    const ShownProgress shown = shownProgress(designOf(*straight), {0, 0});
    QVERIFY(std::abs(shown.curve.first - first) < 1e-12 && std::abs(shown.curve.second - second) < 1e-12);
    QVERIFY(shown.isFree && shown.way.empty());
    // A recording only moves forward along its length.
    const Film stroke = eased(film({{scrawl(), 0, 1}}), {{0, 0}}, {first, second});
    const ShownProgress fitted = shownProgress(designOf(*stroke), {0, 0});
    QVERIFY(fitted.isFree);
    QVERIFY(std::abs(fitted.curve.first - std::clamp(first, 0.0, 1.0)) < 0.01);
    QVERIFY(std::abs(fitted.curve.second - std::clamp(second, 0.0, 1.0)) < 0.01);
}

void TestProgress::recordingsKeepTheirPath() {
    const Film before = film({{scrawl(), 0, 1}}), after = eased(before, {{0, 0}}, {0, 0.5});
    const auto line = scrawl().points;
    double length = 0;
    std::vector<double> lengths = {0};
    for (std::size_t i = 1; i < line.size(); ++i) lengths.push_back(length += (line[i] - line[i - 1]).norm());
    for (double s = 0; s <= 1; s += 0.03125) {
        const Vec3 p = placeAt(after, s) - placeAt(before, 0) + line[0];
        QVERIFY(offLine(line, p) < 1e-9);
        const double share = Progress{0, 0.5}.at(s) * length;  // the point of the line as far along it
        std::size_t i = 1;
        while (i + 1 < line.size() && lengths[i] < share) ++i;
        const double v = (share - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
        QVERIFY((line[i - 1] + v * (line[i] - line[i - 1]) - p).norm() < 1e-9);
    }
    QVERIFY((placeAt(after, 1) - placeAt(before, 1)).norm() < 1e-12);
}

void TestProgress::rotationsHaveEasingsOnly() {
    Rotate<3> turn;
    turn.axis = Vec3::UnitZ();
    turn.angle = 1;
    const Film before = film({{turn, 0, 1}});
    QVERIFY(!shownProgress(designOf(*before), {0, 0}).isFree);
    Film after = eased(before, {{0, 0}}, progressOf(Ease::In));
    QCOMPARE(handleOf(after).motions[0].ease, Ease::In);
    after = eased(before, {{0, 0}}, {0.1, 0.9});
    QCOMPARE(toJson(*after), toJson(*before));
}

void TestProgress::keysEaseTheirSides() {
    Film project = film({{Translate<3>{{30, 0, 0}}, 0, 1}, {Translate<3>{{0, 30, 0}}, 1, 3}});
    project = eased(project, {{0, 0}, {0, 1}}, {0.2, 0.9});
    designOf(*project) = withKeyEase(designOf(*project), {{0, 1}}, {true, false});
    const auto own = [&](int motion) { return shownProgress(designOf(*project), {0, motion}).curve; };
    QVERIFY(std::abs(own(0).first - 0.2) < 1e-12 && own(0).second == 1);
    QVERIFY(std::abs(own(1).first - 0.2) < 1e-12 && std::abs(own(1).second - 0.9) < 1e-12);
    QVERIFY(easeAt(designOf(*project), {0, 1}) == (KeyEase{true, false}));
    designOf(*project) = withKeyEase(designOf(*project), {{0, 1}}, {true, true});
    QVERIFY(std::abs(own(1).first) < 1e-12 && std::abs(own(1).second - 0.9) < 1e-12);
    designOf(*project) = withoutKeys(designOf(*project), {{0, 1}});
    QVERIFY((placeAt(project, 3) - Vec3(40, 50, 0)).norm() < 1e-12);
}

/// A key at the end of a curve that is moved keeps the curve of the move.
void TestProgress::posedKeysKeepTheCurve() {
    Film project = eased(film({{Translate<3>{{30, 0, 0}}, 0, 1}, {Translate<3>{{0, 30, 0}}, 1, 3}}),
                         {{0, 0}, {0, 1}}, {0.2, 0.9});
    QVERIFY(poseAt(handleOf(project), Vec3(40, 20, 0), Vec3(5, -8, 0), 1));
    for (int motion = 0; motion < 2; ++motion) {
        const Progress curve = shownProgress(designOf(*project), {0, motion}).curve;
        QVERIFY(std::abs(curve.first - 0.2) < 1e-12 && std::abs(curve.second - 0.9) < 1e-12);
    }
    QVERIFY((placeAt(project, 1) - Vec3(45, 12, 0)).norm() < 1e-12);
    QVERIFY((placeAt(project, 3) - Vec3(40, 50, 0)).norm() < 1e-12);
}

void TestProgress::splitIsExact_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("eased in") << 1;
    QTest::newRow("eased out") << 2;
    QTest::newRow("eased in and out") << 3;
    QTest::newRow("curve of progress") << 4;
    QTest::newRow("drawn cubic") << 5;
}

/// A pose inside a move leads the path through it and changes nothing else: at every time the pin is
/// displaced by a factor that rises linearly to 1 and falls back to 0.
void TestProgress::splitIsExact() {
    QFETCH(int, kind);
    PinMotion motion{Translate<3>{{40, 10, 0}}, 1, 3};
    if (kind < 4) motion.ease = static_cast<Ease>(kind);
    if (kind == 5)
        motion.kind = CurveMotion<3>{Interpolation::Bezier, {{0, 0, 0}, {9, 30, 0}, {-7, 4, 0}, {40, 10, 0}}};
    Film before = film({{Translate<3>{{3, 4, 0}}, 0, 1}, motion, {Translate<3>{{0, 30, 0}}, 4, 5}});
    if (kind == 4) before = eased(before, {{0, 1}}, {0.05, 1.3});
    std::mt19937 random(static_cast<unsigned>(kind));
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 200; ++round) {
        const double key = 1.1 + 1.8 * unit(random);
        const Vec3 by(20 * unit(random) - 10, 20 * unit(random) - 10, 0);
        const Film after = copyOf(*before);
        QVERIFY(poseAt(handleOf(after), placeAt(before, key), by, key));
        QCOMPARE(handleOf(after).motions.size(), std::size_t{4});
        for (double t = 0; t <= 5; t += 0.0625) {
            const double factor = t <= 1 || t >= 3 ? 0 : t < key ? (t - 1) / (key - 1) : (3 - t) / (3 - key);
            QVERIFY((placeAt(after, t) - placeAt(before, t) - factor * by).norm() < 1e-11);
        }
    }
}

void TestProgress::motionsBetweenKeys() {
    const Film project = film(
        {{Translate<3>{{3, 4, 0}}, 0, 1}, {Translate<3>{{3, 4, 0}}, 1, 3}, {Translate<3>{{0, 30, 0}}, 4, 5}});
    using Ids = std::vector<MotionId>;
    QCOMPARE(motionsBetween(designOf(*project), {{0, 1}, {0, 3}}), (Ids{{0, 1}}));
    QCOMPARE(motionsBetween(designOf(*project), {{0, 0}, {0, 1}, {0, 3}}), (Ids{{0, 0}, {0, 1}}));
    QCOMPARE(motionsBetween(designOf(*project), {{0, 1}}), (Ids{{0, 1}}));
    QCOMPARE(motionsBetween(designOf(*project), {{0, 5}}), (Ids{{0, 2}}));
    QCOMPARE(motionsBetween(designOf(*project), {}), Ids{});
}

QTEST_APPLESS_MAIN(TestProgress)
#include "test_progress.moc"
