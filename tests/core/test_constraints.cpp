#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/integration/contradictions.h"
#include "tests/core/test_mesh_samples.h"

using namespace wend;

namespace {

template <int Dim>
Vec<Dim> along(double x, double others = 0) {
    Vec<Dim> v = Vec<Dim>::Constant(others);
    v[0] = x;
    return v;
}

template <int Dim>
Handle<Dim> handle(const char* name, Placement<Dim> at, std::vector<Motion<Dim>> motions = {}) {
    Handle<Dim> result;
    result.name = name;
    result.at = std::move(at);
    result.motions = std::move(motions);
    return result;
}

template <int Dim>
Motion<Dim> translate(const Vec<Dim>& by, double start, double end) {
    Motion<Dim> motion{Translate<Dim>{by}};
    motion.start = start, motion.end = end;
    return motion;
}

template <class Call>
std::string reasonOf(Call&& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.reason();
    }
    return {};
}

bool has(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) {
        if (text.find(part) == std::string::npos) {
            qWarning("\"%s\" is not in \"%s\"", part, text.c_str());
            return false;
        }
    }
    return true;
}

template <int Dim>
std::string contradiction(const std::vector<Handle<Dim>>& handles, int boxes = 4) {
    const auto mesh = samples::grid<Dim>(boxes);
    return reasonOf([&] { requireConsistent<Dim>(Constraints<Dim>(mesh, handles), mesh.points, {}); });
}

template <int Dim>
std::vector<Vec<Dim>> at(std::initializer_list<Vec<Dim>> points) {
    return points;
}

}  // namespace

class TestConstraints : public QObject {
    Q_OBJECT

    template <int Dim>
    void placement() {
        const auto mesh = samples::grid<Dim>(4);
        Vec<Dim> inside = along<Dim>(0.33, 0.41);
        inside[Dim - 1] = 0.46;
        const Vec<Dim> vertex = along<Dim>(0.5, 0.25), edge = along<Dim>(0.6, 0.25);
        Box<Dim> left{Vec<Dim>::Constant(-1), Vec<Dim>::Constant(2)};
        left.max[0] = 0;  // exactly on the breakpoint
        const Constraints<Dim> constraints(
            mesh,
            {handle<Dim>("points", at<Dim>({inside, vertex, edge, inside})),
             handle<Dim>("vertices", std::vector<int>{3, 5, 3}), handle<Dim>("region", Region<Dim>(left))});
        const auto& points = constraints.points();
        QCOMPARE(points.size(), size_t(3 + 2 + (Dim == 2 ? 5 : 25)));  // what is named twice counts once
        QVERIFY((points[0].template in<Dim>(mesh.points) - inside).norm() < 1e-15);
        QCOMPARE(points[0].terms.size(), size_t(Dim + 1));
        QCOMPARE(points[1].terms.size(), size_t(1));
        QVERIFY(points[1].template in<Dim>(mesh.points) == vertex);
        QCOMPARE(points[2].terms.size(), size_t(2));
        QCOMPARE(points[4].terms.front().first, 5);
        QCOMPARE(points[5].handle, 2);
    }

    template <int Dim>
    void wrongPlacesAreNamed() {
        const auto mesh = samples::grid<Dim>(2);
        const Normalization<Dim> units{along<Dim>(100, 100), 10};
        const auto reason = [&](Placement<Dim> place) {
            return reasonOf([&] { Constraints<Dim>(mesh, {handle<Dim>("hand", std::move(place))}, units); });
        };
        const std::string where = Dim == 2 ? "(115, 105)" : "(115, 105, 105)";
        QVERIFY(has(reason(at<Dim>({along<Dim>(1.5, 0.5)})),
                    {"handle \"hand\"", "outside the shape", where.c_str()}));
        // Different places are distinguished far from the origin, too.
        const Normalization<Dim> far{along<Dim>(1e6, 2e6), 1};
        const std::string there = Dim == 2 ? "(1000001.25, 2000000.5)" : "(1000001.25, 2000000.5, 2000000.5)";
        QVERIFY(has(reasonOf([&] {
                        Constraints<Dim>(mesh, {handle<Dim>("hand", at<Dim>({along<Dim>(1.25, 0.5)}))}, far);
                    }),
                    {there.c_str()}));
        QVERIFY(has(reason(std::vector<int>{0, 99}), {"handle \"hand\"", "vertex 99"}));
        QVERIFY(has(reason(std::vector<int>{-1}), {"vertex -1"}));
        QVERIFY(has(reason(std::vector<int>{}), {"handle \"hand\"", "no points"}));
        QVERIFY(has(reason(Region<Dim>(Ball<Dim>{along<Dim>(9), 1})), {"handle \"hand\"", "no vertex"}));
    }

    template <int Dim>
    void motionsMustBeInOrder() {
        const auto mesh = samples::grid<Dim>(2);
        const auto reason = [&](std::vector<Motion<Dim>> motions) {
            return reasonOf(
                [&] { Constraints<Dim>(mesh, {handle<Dim>("hand", std::vector<int>{0}, motions)}); });
        };
        const auto a = translate<Dim>(along<Dim>(1), 0, 0.5), b = translate<Dim>(along<Dim>(1), 0.4, 1);
        QVERIFY(has(reason({a, b}), {"handle \"hand\"", "motion 2"}));
        QVERIFY(has(reason({b, a}), {"handle \"hand\"", "motion 2"}));
        QVERIFY(has(reason({translate<Dim>(along<Dim>(1), 1, 0)}), {"handle \"hand\"", "motion 1", "time"}));
        Handle<Dim> never = handle<Dim>("hand", std::vector<int>{0});
        never.activeFrom = never.activeTo = 1;
        QVERIFY(has(reasonOf([&] { Constraints<Dim>(mesh, {never}); }), {"handle \"hand\"", "active"}));
    }

    /// Two translations and a rotation with a pause: each starts from where the last one ended.
    template <int Dim>
    void motionsFollowEachOther() {
        const auto mesh = samples::grid<Dim>(2);
        Motion<Dim> rotate{Rotate<Dim>{Vec<Dim>::Zero(), Vec<Dim>::Unit(Dim - 1), std::acos(-1.0) / 2}};
        rotate.start = 3, rotate.end = 4;
        const Constraints<Dim> constraints(
            mesh, {handle<Dim>(
                      "hand", std::vector<int>{0},
                      {translate<Dim>(along<Dim>(1), 0, 1), translate<Dim>(along<Dim>(2), 1, 2), rotate})});
        QCOMPARE(constraints.breakpoints(), (std::vector<double>{0, 1, 2, 3, 4}));
        auto anchors = constraints.anchors(mesh.points, 0);
        const auto position = [&](double t, Side side) {
            Points<Dim> x, v;
            constraints.evaluate({0}, anchors, t, side, x, v);
            return Vec<Dim>(x.col(0));
        };
        QVERIFY((position(0.5, Side::After) - along<Dim>(0.5)).norm() < 1e-15);
        for (const double breakpoint : {1.0, 2.0, 3.0}) {
            const Vec<Dim> before = position(breakpoint, Side::Before);
            constraints.crossBreakpoint(breakpoint, mesh.points, anchors);
            QVERIFY((position(breakpoint, Side::After) - before).norm() < 1e-15);
            QVERIFY((position(breakpoint, Side::After) - along<Dim>(breakpoint == 1 ? 1 : 3)).norm() < 1e-15);
            QCOMPARE(constraints.moving(breakpoint, Side::After), breakpoint != 2);
        }
        Vec<Dim> top = Vec<Dim>::Zero();
        top[1] = 3;
        QVERIFY((position(4, Side::Before) - top).norm() < 1e-14);
    }

    /// A handle that begins in the middle of a motion takes its point from where it is.
    template <int Dim>
    void lateHandlesStartWhereTheirPointsAre() {
        const auto mesh = samples::grid<Dim>(2);
        Handle<Dim> late = handle<Dim>("late", std::vector<int>{0}, {translate<Dim>(along<Dim>(1), 0, 1)});
        late.activeFrom = 0.5, late.activeTo = 0.75;
        const Constraints<Dim> constraints(mesh, {late});
        QCOMPARE(constraints.breakpoints(), (std::vector<double>{0, 0.5, 0.75, 1}));
        QVERIFY(constraints.activePoints(0.5, Side::Before).empty() && !constraints.moving(0.3, Side::After));
        QCOMPARE(constraints.activePoints(0.5, Side::After).size(), size_t(1));
        QVERIFY(constraints.activePoints(0.75, Side::After).empty());
        Points<Dim> shape = mesh.points;
        shape.col(0) = along<Dim>(-7, 2);
        auto anchors = constraints.anchors(mesh.points, 0);
        constraints.crossBreakpoint(0.5, shape, anchors);
        Points<Dim> x, v;
        constraints.evaluate({0}, anchors, 0.75, Side::Before, x, v);
        QVERIFY((x.col(0) - along<Dim>(-6.75, 2)).norm() < 1e-14);
        QVERIFY((v.col(0) - along<Dim>(1)).norm() < 1e-14);
    }

    template <int Dim>
    void anchorsAreAdopted() {
        const auto mesh = samples::grid<Dim>(2);
        const auto moving = handle<Dim>("a", std::vector<int>{4}, {translate<Dim>(along<Dim>(0.1), 0, 1)});
        const Constraints<Dim> before(mesh, {moving}),
            after(mesh, {handle<Dim>("new", std::vector<int>{0, 1}), moving});
        typename Constraints<Dim>::Anchors anchors = {along<Dim>(0.123456789012345678, 0.3)};
        Points<Dim> shape = mesh.points, v, x;
        before.evaluate({0}, anchors, 0.37, Side::After, x, v);
        shape.col(4) = x.col(0) + along<Dim>(1e-14);
        const auto adopted = after.adopt(before.points(), anchors, shape, 0.37);
        QVERIFY(adopted[2] == anchors[0]);
        QVERIFY(adopted[0] == mesh.points.col(0));
        // With another motion the point's place is decisive.
        const Constraints<Dim> other(
            mesh, {handle<Dim>("a", std::vector<int>{4}, {translate<Dim>(along<Dim>(5), 0, 1)})});
        const auto placed = other.adopt(before.points(), anchors, shape, 0.37);
        QVERIFY((placed[0] + along<Dim>(5 * 0.37) - shape.col(4)).norm() < 1e-14);
    }

    template <int Dim>
    void contradictionsNameBoth() {
        const Vec<Dim> p = along<Dim>(0.3, 0.4);
        const auto move = translate<Dim>(along<Dim>(0.1), 0, 1);
        QVERIFY(has(
            contradiction<Dim>({handle<Dim>("pin", at<Dim>({p})), handle<Dim>("hand", at<Dim>({p}), {move})}),
            {"\"pin\"", "\"hand\"", "different"}));
        QVERIFY(contradiction<Dim>(
                    {handle<Dim>("a", at<Dim>({p}), {move}), handle<Dim>("b", at<Dim>({p}), {move})})
                    .empty());
        QVERIFY(contradiction<Dim>({handle<Dim>("a", at<Dim>({p})), handle<Dim>("b", at<Dim>({p}))}).empty());
        // A point in a cell whose corners are held.
        Handle<Dim> corners = handle<Dim>("all", Region<Dim>(HalfSpace<Dim>{along<Dim>(2), along<Dim>(-1)}));
        corners.at = Region<Dim>(Ball<Dim>{along<Dim>(0.5, 0.5), 5});
        QVERIFY(has(contradiction<Dim>({corners, handle<Dim>("hand", at<Dim>({p}), {move})}),
                    {"\"all\"", "\"hand\""}));
        QVERIFY(contradiction<Dim>({corners, handle<Dim>("pin", at<Dim>({p}))}).empty());
        // A pin at the centre of a rotation agrees with it, one beside it does not.
        const auto turn = Motion<Dim>{Rotate<Dim>{p, Vec<Dim>::Unit(Dim - 1), 1}};
        const Vec<Dim> q = along<Dim>(0.35, 0.4);
        QVERIFY(
            contradiction<Dim>({handle<Dim>("pin", at<Dim>({p})), handle<Dim>("hand", at<Dim>({p}), {turn})})
                .empty());
        QVERIFY(
            !contradiction<Dim>({handle<Dim>("pin", at<Dim>({q})), handle<Dim>("hand", at<Dim>({q}), {turn})})
                 .empty());
    }

    /// Two paths of one point differ a little, or only from a later time on.
    template <int Dim>
    void smallContradictionsAreSeen() {
        const Vec<Dim> p = along<Dim>(0.3, 0.4), centre = along<Dim>(0.1, 0.1);
        const auto together = [&](const Motion<Dim>& one, const Motion<Dim>& other) {
            return contradiction<Dim>(
                {handle<Dim>("a", at<Dim>({p}), {one}), handle<Dim>("b", at<Dim>({p}), {other})});
        };
        const auto move = [](double x, double y) { return translate<Dim>(along<Dim>(x, y), 0, 1); };
        for (const double by : {1e-2, 1e-4, 1e-6}) {
            QVERIFY(!together(move(0.1, 0), move(0.1 * (1 + by), 0)).empty());
            QVERIFY(!together(move(0.1, 0), move(0.1, 0.1 * by)).empty());
        }
        QVERIFY(together(move(0.1, 0), move(0.1 * (1 + 1e-9), 0)).empty());
        // A straight path along the tangent of a rotation, of the same length.
        Motion<Dim> turn{Rotate<Dim>{centre, Vec<Dim>::Unit(Dim - 1), 1}};
        turn.start = 0, turn.end = 1;
        const Vec<Dim> arm = p - centre;
        Vec<Dim> tangent = Vec<Dim>::Zero();
        tangent.template head<2>() << -arm.y(), arm.x();
        const std::string reason = together(turn, translate<Dim>(tangent, 0, 1));
        QVERIFY(has(reason, {"different ways at time 0."}));
    }

    /// Only the time in which both act counts; a handle that takes over starts where the other has moved the
    /// point.
    template <int Dim>
    void contradictionsInTime() {
        const Vec<Dim> p = along<Dim>(0.3, 0.4);
        auto first = handle<Dim>("first", at<Dim>({p}), {translate<Dim>(along<Dim>(0.1), 0, 1)});
        auto second = handle<Dim>("second", at<Dim>({p}), {translate<Dim>(along<Dim>(-0.1), 1, 2)});
        QVERIFY(!contradiction<Dim>({first, second}).empty());
        first.activeTo = 1;
        second.activeFrom = 1;
        QVERIFY(contradiction<Dim>({first, second}).empty());
        second.activeFrom = 0.5;
        QVERIFY(has(contradiction<Dim>({first, second}), {"\"first\"", "\"second\"", "time 0.5"}));
        // Both rotate about one centre, the later one from the point's place at that time.
        auto turn = Motion<Dim>{Rotate<Dim>{along<Dim>(0.1, 0.1), Vec<Dim>::Unit(Dim - 1), 1}};
        first.motions = {turn};
        first.activeTo = INFINITY;
        second.motions = {turn};
        QVERIFY(contradiction<Dim>({first, second}).empty());
        QVERIFY(contradiction<Dim>({second, first}).empty());
    }

  private slots:
    void placement2() { placement<2>(); }
    void placement3() { placement<3>(); }
    void wrongPlacesAreNamed2() { wrongPlacesAreNamed<2>(); }
    void wrongPlacesAreNamed3() { wrongPlacesAreNamed<3>(); }
    void motionsMustBeInOrder2() { motionsMustBeInOrder<2>(); }
    void motionsMustBeInOrder3() { motionsMustBeInOrder<3>(); }
    void motionsFollowEachOther2() { motionsFollowEachOther<2>(); }
    void motionsFollowEachOther3() { motionsFollowEachOther<3>(); }
    void lateHandles2() { lateHandlesStartWhereTheirPointsAre<2>(); }
    void lateHandles3() { lateHandlesStartWhereTheirPointsAre<3>(); }
    void anchorsAreAdopted2() { anchorsAreAdopted<2>(); }
    void anchorsAreAdopted3() { anchorsAreAdopted<3>(); }
    void contradictionsNameBoth2() { contradictionsNameBoth<2>(); }
    void contradictionsNameBoth3() { contradictionsNameBoth<3>(); }
    void smallContradictionsAreSeen2() { smallContradictionsAreSeen<2>(); }
    void smallContradictionsAreSeen3() { smallContradictionsAreSeen<3>(); }
    void contradictionsInTime2() { contradictionsInTime<2>(); }
    void contradictionsInTime3() { contradictionsInTime<3>(); }
};

QTEST_APPLESS_MAIN(TestConstraints)
#include "test_constraints.moc"
