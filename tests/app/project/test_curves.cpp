#include <QTest>

#include "app/project/edits/bezier_edits.h"

using namespace wend;

/// Editing Bézier chains, in the plane and in space.
class TestCurves : public QObject {
    Q_OBJECT
  private slots:
    void splitKeepsTheCurve_data() { dimensions(); }
    void splitKeepsTheCurve();
    void removingUndoesASplit_data() { dimensions(); }
    void removingUndoesASplit();
    void endsAndLastPiecesStay_data() { dimensions(); }
    void endsAndLastPiecesStay();
    void kindsFollowTheGeometry_data() { dimensions(); }
    void kindsFollowTheGeometry();
    void alignedDirectionsStayOnOneLine_data() { dimensions(); }
    void alignedDirectionsStayOnOneLine();
    void jointsTakeTheirDirectionsAlong_data() { dimensions(); }
    void jointsTakeTheirDirectionsAlong();
    void pointsOnOtherCurves_data() { dimensions(); }
    void pointsOnOtherCurves();
    void repeatedPointsCountOnce_data() { dimensions(); }
    void repeatedPointsCountOnce();

  private:
    static void dimensions() {
        QTest::addColumn<int>("dimension");
        QTest::newRow("plane") << 2;
        QTest::newRow("space") << 3;
    }
    template <class Check>
    static void inBoth(Check check) {
        QFETCH(int, dimension);
        if (dimension == 2)
            check(std::integral_constant<int, 2>());
        else
            check(std::integral_constant<int, 3>());
    }
};

namespace {

constexpr double kRounding = 1e-12;  // of lengths near 1

/// A chain of two pieces with a corner between them.
template <int Dim>
std::vector<Vec3> chain() {
    std::vector<Vec3> points;
    for (const auto& p : std::vector<std::array<double, 3>>{{0, 0, 0},
                                                            {0.4, 0.9, 0.3},
                                                            {1, 1, -0.2},
                                                            {1.5, 0.2, 0},
                                                            {1.6, -0.7, 0.5},
                                                            {2.2, -1, 0.1},
                                                            {3, 0.1, 0.4}}) {
        Vec3 q = Vec3::Zero();
        for (int k = 0; k < Dim; ++k) q[k] = p[k];
        points.push_back(q);
    }
    return points;
}

template <int Dim>
double angleBetween(const Vec3& a, const Vec3& b) {
    return (a.normalized() - b.normalized()).norm();
}

}  // namespace

void TestCurves::splitKeepsTheCurve() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        const auto points = chain<Dim>();
        const auto before = bezierCurve<3>(points).pieces;
        for (const double v : {0.05, 0.3, 0.5, 0.8}) {
            const auto split = splitBezier(points, 1, v);
            QCOMPARE(split.size(), points.size() + 3);
            const auto after = bezierCurve<3>(split).pieces;
            for (int i = 0; i <= 10; ++i) {
                const double t = i / 10.0;
                QVERIFY((after[0].value(t) - before[0].value(t)).norm() < kRounding);
                QVERIFY((after[1].value(t) - before[1].value(v * t)).norm() < kRounding);
                QVERIFY((after[2].value(t) - before[1].value(v + (1 - v) * t)).norm() < kRounding);
            }
            QVERIFY(jointKinds(split)[2] != JointKind::Free);
            QCOMPARE(jointKinds(split)[1], JointKind::Free);
        }
    });
}

void TestCurves::removingUndoesASplit() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        const auto points = chain<Dim>();
        for (const double v : {0.05, 0.3, 0.5, 0.8}) {
            const auto back = withoutJoint(splitBezier(points, 0, v), 1);
            QCOMPARE(back.size(), points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
                QVERIFY((back[i] - points[i]).norm() < 1e-10);  // divided by v
        }
    });
}

void TestCurves::endsAndLastPiecesStay() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        CurveMotion<3> motion;
        motion.points = chain<Dim>();
        QVERIFY(!withoutPoint(motion, 0) && !withoutPoint(motion, 1));  // of the first joint
        const auto shorter = withoutPoint(motion, 6);
        QVERIFY(shorter && shorter->points.size() == 4 && shorter->points.back() == motion.points[3]);
        QVERIFY(!withoutPoint(*shorter, 3));
        QCOMPARE(withoutPoint(motion, 2)->points.size(), std::size_t(4));  // a direction stands for its joint
    });
}

void TestCurves::kindsFollowTheGeometry() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        const auto points = chain<Dim>();
        QVERIFY(jointKinds(points) == std::vector<JointKind>(3, JointKind::Free));
        const auto aligned = withJointKind(points, 1, JointKind::Aligned);
        QCOMPARE(jointKinds(aligned)[1], JointKind::Aligned);
        for (const int side : {2, 4})  // only turned
            QVERIFY(std::abs((aligned[side] - aligned[3]).norm() - (points[side] - points[3]).norm()) <
                    kRounding);
        const auto automatic = withJointKind(points, 1, JointKind::Automatic);
        QCOMPARE(jointKinds(automatic)[1], JointKind::Automatic);
        QVERIFY(angleBetween<Dim>(automatic[4] - automatic[3], automatic[6] - automatic[0]) < kRounding);
        QVERIFY(withJointKind(points, 0, JointKind::Aligned) == points);
    });
}

void TestCurves::alignedDirectionsStayOnOneLine() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        const auto points = withJointKind(chain<Dim>(), 1, JointKind::Aligned);
        const Vec3 by = Vec3::Constant(0.3);
        auto kinds = jointKinds(points);
        for (const int point : {2, 4}) {
            const auto moved = withMovedPoint(points, kinds, point, by);
            QVERIFY((moved[point] - points[point] - by).norm() < kRounding);
            QVERIFY(angleBetween<Dim>(moved[3] - moved[2], moved[4] - moved[3]) < kRounding);
            const int other = 6 - point;
            QVERIFY(std::abs((moved[other] - moved[3]).norm() - (points[other] - points[3]).norm()) <
                    kRounding);
        }
        kinds[1] = JointKind::Free;
        const auto alone = withMovedPoint(points, kinds, 2, by);
        QVERIFY(alone[4] == points[4] && alone[3] == points[3]);
    });
}

void TestCurves::jointsTakeTheirDirectionsAlong() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        const auto points = withJointKind(chain<Dim>(), 1, JointKind::Automatic);
        const Vec3 by = Vec3::Constant(-0.4);
        const auto moved = withMovedPoint(points, jointKinds(points), 6, by);
        QVERIFY((moved[5] - points[5] - by).norm() < kRounding);
        QVERIFY(moved[3] == points[3]);
        QCOMPARE(jointKinds(moved)[1], JointKind::Automatic);  // follows its neighbour
        QVERIFY(angleBetween<Dim>(moved[4] - moved[3], moved[6] - moved[0]) < kRounding);
    });
}

void TestCurves::pointsOnOtherCurves() {
    inBoth([](auto dim) {
        constexpr int Dim = dim;
        for (const Interpolation kind : {Interpolation::Polyline, Interpolation::Spline}) {
            CurveMotion<3> motion;
            motion.interpolation = kind;
            motion.points = chain<Dim>();
            motion.points.insert(motion.points.begin() + 2, motion.points[2]);  // twice: counts once
            const Vec3 p = curveOf(motion).pieces[3].value(0.25);
            const auto more = withPointOn(motion, 3, 0.25);
            QCOMPARE(more.points.size(), std::size_t(8));
            QVERIFY(more.points[4] == p);
            QVERIFY(withoutPoint(more, 4)->points == chain<Dim>());
        }
    });
}

/// Points that coincide up to rounding have no piece between them.
void TestCurves::repeatedPointsCountOnce() {
    inBoth([](auto) {
        const auto x = [](double value) -> Vec3 { return value * Vec3::UnitX(); };
        CurveMotion<3> motion;
        motion.interpolation = Interpolation::Polyline;
        motion.points = {x(0), x(1), x(1 + 1e-14), x(2), x(2), x(4)};
        QCOMPARE(curveOf(motion).pieces.size(), std::size_t(3));
        const std::vector<int> pieces = {0, 1, 1, 2, 2, 2};
        for (int i = 0; i < 6; ++i) QCOMPARE(pieceBehind(motion, i), pieces[i]);
        QCOMPARE(pieceBehind(motion, -1), 0);
        const auto next = withPointOn(motion, 2, 0.5);
        const std::vector<Vec3> expected = {x(0), x(1), x(2), x(3), x(4)};
        QVERIFY(next.points == expected);
    });
}

QTEST_APPLESS_MAIN(TestCurves)
#include "test_curves.moc"
