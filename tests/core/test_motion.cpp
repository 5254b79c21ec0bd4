#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/motion/easing.h"
#include "core/motion/trajectory.h"

using namespace wend;

namespace {

constexpr double kPi = std::numbers::pi;

template <int Dim>
Vec<Dim> point(double x, double y, double z = 0) {
    Vec<Dim> p;
    p[0] = x, p[1] = y;
    if constexpr (Dim == 3) p[2] = z;
    return p;
}

template <int Dim>
CurveMotion<Dim> curve(Interpolation interpolation, FrameKind frame, std::vector<Vec<Dim>> points,
                       double twist = 0, double scale = 1) {
    return {interpolation, std::move(points), frame, twist, scale};
}

/// A curve that bends in all directions there are, with a smooth joint.
template <int Dim>
std::vector<Vec<Dim>> windingBezier() {
    return {point<Dim>(3, 1, 2),  point<Dim>(4, 1, 2.5), point<Dim>(5, 3, 3),  point<Dim>(4, 4, 1),
            point<Dim>(3, 5, -1), point<Dim>(1, 4, 0),   point<Dim>(0, 6, 0.5)};
}
template <int Dim>
std::vector<Vec<Dim>> windingPoints() {
    return {point<Dim>(1, 1, 0), point<Dim>(2, 1.5, 1), point<Dim>(2.5, 3, 1), point<Dim>(1, 4, -1),
            point<Dim>(-1, 3.5, 0)};
}

/// Every kind of motion with every frame.
template <int Dim>
std::vector<Motion<Dim>> allMotions() {
    std::vector<Motion<Dim>> motions;
    motions.push_back({Translate<Dim>{point<Dim>(1, -2, 0.5)}});
    motions.push_back({Rotate<Dim>{point<Dim>(0.3, 0.2, 0.1), point<Dim>(1, 2, -1), 2.5}});
    motions.push_back({Recorded<Dim>{
        {0, 0.1, 0.5, 0.6}, {point<Dim>(0, 0), point<Dim>(1, 1, 1), point<Dim>(2, 0), point<Dim>(2, 3, 1)}}});
    PoseMotion<Dim> poses;
    poses.times = {3, 3.5, 5, 5.5};
    for (const double k : {0.0, 1.0, 2.0, 3.0}) {
        RotationVector<Dim> rotation = RotationVector<Dim>::Constant(0.3 * k * k - 0.4);
        rotation[0] += std::sin(k);
        poses.poses.push_back({point<Dim>(k, std::cos(k), k * k), rotation});
    }
    motions.push_back({std::move(poses)});
    for (const FrameKind frame : {FrameKind::None, FrameKind::Frenet, FrameKind::Minimal}) {
        const double twist = Dim == 3 && frame != FrameKind::None ? 1.7 : 0;
        motions.push_back({curve<Dim>(Interpolation::Bezier, frame, windingBezier<Dim>(), twist, 1.5)});
        motions.push_back({curve<Dim>(Interpolation::Spline, frame, windingPoints<Dim>(), twist, 0.5)});
        motions.push_back({curve<Dim>(Interpolation::Polyline, frame, windingPoints<Dim>(), twist)});
    }
    return motions;
}

/// d/dt of the position map by the 4th-order central difference.
template <int Dim>
AffineMap<Dim> difference(const Trajectory<Dim>& trajectory, double t, double h) {
    const auto at = [&](double offset) { return trajectory.at(t + offset * h).position; };
    const AffineMap<Dim> p1 = at(1), m1 = at(-1), p2 = at(2), m2 = at(-2);
    return {(8 * (p1.A - m1.A) - (p2.A - m2.A)) / (12 * h), (8 * (p1.b - m1.b) - (p2.b - m2.b)) / (12 * h)};
}

double maxNorm(const auto& m) {
    return m.cwiseAbs().maxCoeff();
}

/// An S in the plane z = 0 with its inflection in the middle.
template <int Dim>
std::vector<Vec<Dim>> sCurve() {
    return {point<Dim>(0, 0), point<Dim>(2, 0), point<Dim>(1, 2), point<Dim>(3, 2)};
}

/// An arc of a helix as a spline through n points; radius 1, rise c per radian.
std::vector<Vec3> helix(int n, double turns, double rise) {
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * kPi * turns * i / (n - 1);
        points.push_back({std::cos(a), std::sin(a), rise * a});
    }
    return points;
}

template <int Dim>
bool throwsNaming(const Motion<Dim>& motion, const char* key) {
    try {
        Trajectory<Dim> trajectory(motion);
    } catch (const InputError& error) {
        return error.reason().find(key) != std::string::npos;
    }
    return false;
}

/// The angle about the tangent between the frames of two trajectories on the same curve, less that at the
/// start.
double spinBetween(const Trajectory<3>& a, const Trajectory<3>& b, double t) {
    const Mat3 relative = b.at(t).position.A.transpose() * a.at(t).position.A;
    const Eigen::AngleAxisd turn(relative);
    const Vec3 tangent = a.frame(0).col(0);
    return turn.angle() * turn.axis().dot(tangent);
}

}  // namespace

class TestMotion : public QObject {
    Q_OBJECT

    template <int Dim>
    void velocityIsDerivative() {
        int index = -1;
        for (Motion<Dim> motion : allMotions<Dim>()) {
            ++index;
            for (const Ease easing : {Ease::Linear, Ease::In, Ease::Out, Ease::InOut}) {
                motion.ease = easing;
                motion.start = 2, motion.end = 5;
                const Trajectory<Dim> trajectory(motion);
                for (const double t : {2.1, 2.77, 3.14, 3.6, 4.2, 4.93}) {
                    const AffineMap<Dim> expected = difference(trajectory, t, 1e-4),
                                         given = trajectory.at(t).velocity;
                    // h⁴ times the fifth derivative, and rounding over h
                    const double error =
                        std::max(maxNorm(expected.A - given.A), maxNorm(expected.b - given.b));
                    QVERIFY2(error < 2e-9, qPrintable(QString("kind %1, ease %2, t %3: %4")
                                                          .arg(index)
                                                          .arg(int(easing))
                                                          .arg(t)
                                                          .arg(error)));
                }
            }
        }
    }

    template <int Dim>
    void startsAsIdentity() {
        for (Motion<Dim> motion : allMotions<Dim>()) {
            motion.start = 0.25, motion.end = 0.75;
            const Trajectory<Dim> trajectory(motion);
            for (const double t : {-1.0, 0.25}) {
                QVERIFY(trajectory.at(t).position.A == Mat<Dim>::Identity());
                QVERIFY(trajectory.at(t).position.b == Vec<Dim>::Zero());
            }
            QVERIFY(trajectory.at(0.75).position.b == trajectory.at(3).position.b);
            QVERIFY(trajectory.at(3).velocity.A.isZero(0) && trajectory.at(3).velocity.b.isZero(0));
            QVERIFY(!trajectory.at(0.25).velocity.b.isZero(1e-9) ||
                    !trajectory.at(0.25).velocity.A.isZero(1e-9));
        }
    }

    template <int Dim>
    void anchorFollowsCurve() {
        for (const Interpolation kind :
             {Interpolation::Bezier, Interpolation::Spline, Interpolation::Polyline}) {
            const auto points = kind == Interpolation::Bezier ? windingBezier<Dim>() : windingPoints<Dim>();
            for (const FrameKind frame : {FrameKind::None, FrameKind::Frenet, FrameKind::Minimal}) {
                const Trajectory<Dim> trajectory({curve<Dim>(kind, frame, points, 0, 2)});
                for (const double t : {0.1, 0.5, 0.9, 1.0}) {
                    QVERIFY((trajectory.at(t).position(points.front()) - trajectory.curvePoint(t)).norm() <
                            1e-14 * 10);
                }
                QVERIFY((trajectory.at(1).position(points.front()) - points.back()).norm() < 1e-14 * 10);
            }
        }
    }

    /// The displacement counts, not the place of the curve: a curve given elsewhere moves the points alike.
    template <int Dim>
    void translationIsRelative() {
        auto points = windingBezier<Dim>();
        const Trajectory<Dim> here({curve<Dim>(Interpolation::Bezier, FrameKind::None, points)});
        for (auto& p : points) p += point<Dim>(10, 20, 30);
        const Trajectory<Dim> there({curve<Dim>(Interpolation::Bezier, FrameKind::None, points)});
        for (const double t : {0.0, 0.3, 1.0}) {
            const Vec<Dim> x = point<Dim>(1, 2, 3);
            QVERIFY((here.at(t).position(x) - there.at(t).position(x)).norm() < 1e-13);
        }
    }

    template <int Dim>
    void frameIsRotationOnTangent() {
        for (const FrameKind frame : {FrameKind::Frenet, FrameKind::Minimal}) {
            const Trajectory<Dim> trajectory(
                {curve<Dim>(Interpolation::Bezier, frame, windingBezier<Dim>())});
            for (int i = 0; i <= 50; ++i) {
                const double t = i / 50.0;
                const Mat<Dim> Q = trajectory.at(t).position.A;
                QVERIFY(maxNorm(Q * Q.transpose() - Mat<Dim>::Identity()) < 1e-13);
                QVERIFY(std::abs(Q.determinant() - 1) < 1e-13);
                const Vec<Dim> tangent = trajectory.at(t).velocity(windingBezier<Dim>().front()).normalized();
                QVERIFY((trajectory.frame(t).col(0) - tangent).norm() < 1e-11);
            }
        }
    }

    /// Twice as many points on a circle reduce the spline's error by 16, away from its natural ends.
    template <int Dim>
    void splineOrder() {
        const auto error = [](int n) {
            std::vector<Vec<Dim>> points;
            for (int i = 0; i <= n; ++i)
                points.push_back(point<Dim>(std::cos(4.0 * i / n), std::sin(4.0 * i / n), 0));
            const Trajectory<Dim> trajectory({curve<Dim>(Interpolation::Spline, FrameKind::None, points)});
            double worst = 0;
            for (int i = 30; i <= 70; ++i) {
                const Vec<Dim> p = trajectory.curvePoint(i / 100.0);
                worst = std::max(worst, (p - point<Dim>(std::cos(0.04 * i), std::sin(0.04 * i), 0)).norm());
            }
            return worst;
        };
        const double order = std::log2(error(40) / error(80));
        QVERIFY2(order > 3.7 && order < 4.5, qPrintable(QString::number(order)));
    }

  private slots:
    void velocityIsDerivative2() { velocityIsDerivative<2>(); }
    void velocityIsDerivative3() { velocityIsDerivative<3>(); }
    void startsAsIdentity2() { startsAsIdentity<2>(); }
    void startsAsIdentity3() { startsAsIdentity<3>(); }
    void anchorFollowsCurve2() { anchorFollowsCurve<2>(); }
    void anchorFollowsCurve3() { anchorFollowsCurve<3>(); }
    void translationIsRelative2() { translationIsRelative<2>(); }
    void translationIsRelative3() { translationIsRelative<3>(); }
    void frameIsRotationOnTangent2() { frameIsRotationOnTangent<2>(); }
    void frameIsRotationOnTangent3() { frameIsRotationOnTangent<3>(); }
    void splineOrder2() { splineOrder<2>(); }
    void splineOrder3() { splineOrder<3>(); }

    void rotationSense() {
        const Trajectory<2> plane({Rotate<2>{{1, 1}, {0, 0}, kPi / 2}});
        QVERIFY((plane.at(1).position({2, 1}) - Vec2(1, 2)).norm() < 1e-15);  // x towards y
        const Trajectory<3> space({Rotate<3>{{1, 1, 0}, {0, 0, 7}, kPi / 2}});
        QVERIFY((space.at(1).position({2, 1, 5}) - Vec3(1, 2, 5)).norm() < 1e-14);
    }

    void evenSpeedOnPolylines() {
        const Trajectory<2> trajectory(
            {curve<2>(Interpolation::Polyline, FrameKind::None, {{0, 0}, {3, 0}, {3, 1}, {3, 1}, {3, 4}})});
        for (const double t : {0.05, 0.3, 0.5, 0.99})
            QVERIFY(std::abs(trajectory.at(t).velocity.b.norm() - 7) < 1e-12);
        // One corner at 3 of 7; the point on the straight part and the repeated one are none.
        QCOMPARE(trajectory.breakTimes().size(), size_t(1));
        QVERIFY(std::abs(trajectory.breakTimes()[0] - 3.0 / 7) < 1e-15);
    }

    /// The easings follow the manual's formulas: in is t², out the same from the other end, both 3t² − 2t³.
    void easesAreTheManuals() {
        for (int k = 0; k <= 16; ++k) {
            const double t = k / 16.0;
            const std::pair<Ease, double> expected[] = {{Ease::Linear, t},
                                                        {Ease::In, t * t},
                                                        {Ease::Out, 1 - (1 - t) * (1 - t)},
                                                        {Ease::InOut, 3 * t * t - 2 * t * t * t}};
            for (const auto& [easing, way] : expected) {
                Motion<2> motion{Translate<2>{{10, -4}}};
                motion.ease = easing;
                motion.start = 2, motion.end = 4;
                const AffineMap<2> place = Trajectory<2>(motion).at(2 + 2 * t).position;
                QVERIFY((place.b - way * Vec2(10, -4)).norm() < 1e-14);
            }
        }
    }

    void sidesOfBreaks_data() {
        QTest::addColumn<int>("ease");
        for (const Ease easing : {Ease::Linear, Ease::In, Ease::Out, Ease::InOut}) {
            QTest::addRow("ease %d", int(easing)) << int(easing);
        }
    }
    void sidesOfBreaks() {
        QFETCH(int, ease);
        Motion<2> motion{
            curve<2>(Interpolation::Polyline, FrameKind::None, {{0, 0}, {1, 0}, {1, 0.4}, {0, 1}, {4, 4}})};
        motion.start = 1000.1, motion.end = 1000.2, motion.ease = Ease(ease);
        const Trajectory<2> trajectory(motion);
        QCOMPARE(trajectory.breakTimes().size(), size_t(3));
        for (const double t : trajectory.breakTimes()) {
            const double h = 1e-7;
            const Vec2 before = trajectory.at(t, Side::Before).velocity.b,
                       after = trajectory.at(t, Side::After).velocity.b;
            QVERIFY((before.normalized() - trajectory.at(t - h).velocity.b.normalized()).norm() < 1e-9);
            QVERIFY((after.normalized() - trajectory.at(t + h).velocity.b.normalized()).norm() < 1e-9);
            QVERIFY((before - after).norm() > 1);
        }
    }

    void breaksOfBeziers() {
        const auto breaks = [](std::vector<Vec2> points) {
            return Trajectory<2>({curve<2>(Interpolation::Bezier, FrameKind::None, std::move(points))})
                .breakTimes();
        };
        QCOMPARE(breaks(windingBezier<2>()).size(), std::size_t(0));
        auto loose = windingBezier<2>();
        loose[4] += Vec2(0.1, 0);
        QCOMPARE(breaks(loose), std::vector<double>{0.5});
    }

    void strokesKeepTheirTimes() {
        Motion<2> motion{Recorded<2>{{5, 6, 9}, {{1, 1}, {2, 1}, {2, 4}}}};
        motion.start = 10, motion.end = 14;
        const Trajectory<2> trajectory(motion);
        QCOMPARE(trajectory.breakTimes(), std::vector<double>{11});
        QVERIFY((trajectory.at(10.5).position({0, 0}) - Vec2(0.5, 0)).norm() < 1e-14);
        QVERIFY((trajectory.at(12.5).position({0, 0}) - Vec2(1, 1.5)).norm() < 1e-14);
    }

    /// Both frames of a planar curve rotate with the tangent, past the inflection too.
    void planarFrames() {
        for (const FrameKind kind : {FrameKind::Frenet, FrameKind::Minimal}) {
            const Trajectory<2> plane({curve<2>(Interpolation::Bezier, kind, sCurve<2>())});
            const Trajectory<3> space({curve<3>(Interpolation::Bezier, kind, sCurve<3>())});
            for (int i = 0; i <= 100; ++i) {
                const double t = i / 100.0, angle = std::atan2(plane.frame(t)(1, 0), plane.frame(t)(0, 0));
                const Mat2 expected = Eigen::Rotation2Dd(angle).toRotationMatrix();
                QVERIFY(maxNorm(plane.at(t).position.A - expected) < 1e-14);
                Mat3 raised = Mat3::Identity();
                raised.topLeftCorner<2, 2>() = expected;
                QVERIFY(maxNorm(space.at(t).position.A - raised) < 1e-13);
            }
            QVERIFY(maxNorm(plane.at(1).position.A - Mat2::Identity()) < 1e-14);  // the S ends as it began
        }
    }

    /// On a helix of curvature κ and torsion τ the Frenet frame spins against the minimal one by τ s.
    void helixSpin() {
        const double rise = 0.4, turns = 1.25;
        const auto points = helix(600, turns, rise);
        const Trajectory<3> frenet({curve<3>(Interpolation::Spline, FrameKind::Frenet, points)});
        const Trajectory<3> minimal({curve<3>(Interpolation::Spline, FrameKind::Minimal, points)});
        const double torsion = rise / (1 + rise * rise), length = std::sqrt(1 + rise * rise) * 2 * kPi;
        for (const double t : {0.3, 0.5, 0.8}) {
            // from t0 = 0.1 on: the spline's natural ends have another torsion
            const double expected = torsion * length * turns * (t - 0.1);
            const double spin = spinBetween(frenet, minimal, t) - spinBetween(frenet, minimal, 0.1);
            // torsion needs third derivatives: first order in the spacing
            QVERIFY2(std::abs(std::remainder(spin - expected, 2 * kPi)) < 1e-3,
                     qPrintable(QString::number(spin - expected)));
        }
        const Mat3 Q = frenet.at(0.7).position.A * frenet.at(0.2).position.A.transpose();
        const Mat3 expected = Eigen::AngleAxisd(2 * kPi * turns * 0.5, Vec3::UnitZ()).toRotationMatrix();
        QVERIFY(maxNorm(Q - expected) < 1e-3);  // the Frenet frame of a helix turns about its axis
    }

    /// The rotation-minimizing frame is compared with its differential equation, integrated by RK4 with many
    /// steps.
    void minimalFrameSolvesItsEquation() {
        const Trajectory<3> trajectory(
            {curve<3>(Interpolation::Bezier, FrameKind::Minimal, windingBezier<3>())});
        const auto omega = [&](double t) {
            const double h = 1e-4;  // T × T′ from the curve alone
            const Vec3 anchor = windingBezier<3>().front();
            const auto tangent = [&](double s) -> Vec3 {
                return trajectory.at(s).velocity(anchor).normalized();
            };
            return Vec3(tangent(t).cross(
                (8 * (tangent(t + h) - tangent(t - h)) - (tangent(t + 2 * h) - tangent(t - 2 * h))) /
                (12 * h)));
        };
        const int n = 400;
        const double from = 0.01, to = 0.49, h = (to - from) / n;
        Mat3 Q = trajectory.at(from).position.A;
        const auto rate = [&](double t, const Mat3& q) -> Mat3 {
            const Vec3 w = omega(t);
            Mat3 result;
            for (int c = 0; c < 3; ++c) result.col(c) = w.cross(q.col(c));
            return result;
        };
        for (int i = 0; i < n; ++i) {
            const double t = from + i * h;
            const Mat3 k1 = rate(t, Q), k2 = rate(t + h / 2, Q + h / 2 * k1),
                       k3 = rate(t + h / 2, Q + h / 2 * k2), k4 = rate(t + h, Q + h * k3);
            Q += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        const double error = maxNorm(Q - trajectory.at(to).position.A);
        QVERIFY2(error < 1e-9, qPrintable(QString::number(error)));
    }

    /// The curve nearly has a cusp, where no step of the table is short enough for a rule of lower order; the
    /// frame is compared with RK4 on the tangent's own formula.
    void minimalFrameOfSharpBends() {
        const std::vector<Vec3> points = {{0, 0, 0}, {1, 1, 0.1}, {0.02, 1, -0.1}, {1, 0.02, 0.15}};
        const Trajectory<3> trajectory({curve<3>(Interpolation::Bezier, FrameKind::Minimal, points)});
        const auto omega = [&](double v) -> Vec3 {
            const double w = 1 - v;
            const Vec3 a = points[1] - points[0], b = points[2] - points[1], c = points[3] - points[2];
            const Vec3 first = w * w * a + 2 * w * v * b + v * v * c,
                       second = 2 * (w * (b - a) + v * (c - b));
            return first.cross(second) / first.squaredNorm();
        };
        const int n = 20000;
        Mat3 Q = Mat3::Identity();
        const auto rate = [&](double v, const Mat3& q) -> Mat3 {
            const Vec3 w = omega(v);
            Mat3 result;
            for (int k = 0; k < 3; ++k) result.col(k) = w.cross(q.col(k));
            return result;
        };
        for (int i = 0; i < n; ++i) {
            const double v = double(i) / n, h = 1.0 / n;
            const Mat3 k1 = rate(v, Q), k2 = rate(v + h / 2, Q + h / 2 * k1),
                       k3 = rate(v + h / 2, Q + h / 2 * k2), k4 = rate(v + h, Q + h * k3);
            Q += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        const double error = maxNorm(Q - trajectory.at(1).position.A);
        QVERIFY2(error < 1e-10, qPrintable(QString::number(error)));
    }

    /// The fractions of the path at half the time are those that the documentation gives for each easing.
    void easingIsAsPromised() {
        const struct {
            Ease kind;
            double quarter, half, rateAtEnd;
        } rows[] = {{Ease::Linear, 0.25, 0.5, 1},
                    {Ease::In, 0.0625, 0.25, 2},
                    {Ease::Out, 0.4375, 0.75, 0},
                    {Ease::InOut, 0.15625, 0.5, 0}};
        for (const auto& row : rows) {
            QCOMPARE(ease(row.kind, 0.25), row.quarter);
            QCOMPARE(ease(row.kind, 0.5), row.half);
            QCOMPARE(ease(row.kind, 0.0), 0.0);
            QCOMPARE(ease(row.kind, 1.0), 1.0);
            QCOMPARE(easeRate(row.kind, 1.0), row.rateAtEnd);
            for (const double s : {0.1, 0.25, 0.5, 0.9}) {
                const double h = 1e-6, slope = (ease(row.kind, s + h) - ease(row.kind, s - h)) / (2 * h);
                QVERIFY(std::abs(easeRate(row.kind, s) - slope) < 1e-9);
                QVERIFY(std::abs(easeInverse(row.kind, ease(row.kind, s)) - s) < 1e-14);
            }
        }
    }

    /// Position and velocity agree to the accuracy that the table promises, also where pieces join.
    void fineContinuity() {
        for (const FrameKind kind : {FrameKind::Frenet, FrameKind::Minimal}) {
            const Trajectory<3> trajectory({curve<3>(Interpolation::Spline, kind, windingPoints<3>())});
            double worst = 0;
            for (int i = 1; i < 4000; ++i) {
                const double t = i / 4000.0, h = 1e-6;
                const Mat3 jump = trajectory.at(t + h).position.A - trajectory.at(t - h).position.A;
                worst = std::max(worst, maxNorm(jump - 2 * h * trajectory.at(t).velocity.A));
            }
            QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
        }
    }

    /// A bend in one plane, a straight piece, a bend in another plane: no spin on the way, no jump.
    void frenetAcrossStraightPiece() {
        const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0},
                                          {2, 4, 0}, {2, 5, 0}, {2, 6, 0}, {2, 7, 1}, {2, 7, 2}};
        const Trajectory<3> trajectory({curve<3>(Interpolation::Bezier, FrameKind::Frenet, points)});
        const Mat3 before = trajectory.at(1.0 / 3).position.A;
        QVERIFY(maxNorm(trajectory.at(0.5).position.A - before) < 1e-14);
        QVERIFY(maxNorm(trajectory.at(2.0 / 3).position.A - before) < 1e-14);
        QVERIFY(maxNorm(trajectory.at(2.0 / 3 + 1e-9).position.A - before) < 1e-7);
        // From there on Frenet's frame rotates about the binormal of the second bend, which is x.
        const Mat3 second = trajectory.at(1).position.A * before.transpose();
        QVERIFY(maxNorm(second - Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()).toRotationMatrix()) < 1e-13);
    }

    void degenerateTangents_data() {
        QTest::addColumn<QList<double>>("xy");
        QTest::newRow("start handle on the start") << QList<double>{0, 0, 0, 0, 1, 2, 3, 0};
        QTest::newRow("end handle on the end") << QList<double>{0, 0, 1, 2, 3, 0, 3, 0};
        QTest::newRow("both") << QList<double>{0, 0, 0, 0, 3, 1, 3, 1};
        QTest::newRow("cusp") << QList<double>{0, 0, 1, 1, 0, 1, 1, 0};
        QTest::newRow("there and back") << QList<double>{0, 0, 2, 2, 2, 2, 0, 0};
        QTest::newRow("a point") << QList<double>{1, 1, 1, 1, 1, 1, 1, 1};
    }
    void degenerateTangents() {
        QFETCH(QList<double>, xy);
        std::vector<Vec3> points;
        for (int i = 0; i < xy.size(); i += 2) points.push_back({xy[i], xy[i + 1], xy[i] - xy[i + 1]});
        for (const FrameKind kind : {FrameKind::Frenet, FrameKind::Minimal}) {
            const Trajectory<3> trajectory({curve<3>(Interpolation::Bezier, kind, points)});
            Mat3 last = Mat3::Identity();
            for (int i = 0; i <= 1000; ++i) {
                const MovingMap<3> map = trajectory.at(i / 1000.0);
                QVERIFY(map.position.A.allFinite() && map.velocity.A.allFinite() &&
                        map.velocity.b.allFinite());
                QVERIFY(maxNorm(map.position.A - last) < 0.05);  // a flip would be 1 or more
                QVERIFY(maxNorm(map.velocity.A) < 50);
                last = map.position.A;
            }
        }
    }

    /// At a corner the frame rotates over the neighbouring pieces: continuously, and completely in the end.
    void cornersAreTurnedAbout() {
        const std::vector<Vec2> points = {{0, 0}, {1, 0}, {1, 1}, {3, 1}};
        const Trajectory<2> trajectory({curve<2>(Interpolation::Polyline, FrameKind::Minimal, points)});
        QVERIFY(maxNorm(trajectory.at(0.125).position.A - Mat2::Identity()) < 1e-14);
        QVERIFY(maxNorm(trajectory.at(0.25).position.A - Eigen::Rotation2Dd(kPi / 4).toRotationMatrix()) <
                1e-14);
        QVERIFY(maxNorm(trajectory.at(0.375).position.A - Eigen::Rotation2Dd(kPi / 2).toRotationMatrix()) <
                1e-14);
        QVERIFY(maxNorm(trajectory.at(1).position.A - Mat2::Identity()) < 1e-14);
        double worst = 0;
        for (int i = 1; i < 500; ++i) {
            worst = std::max(worst, maxNorm(trajectory.at(i / 500.0).position.A -
                                            trajectory.at((i - 1) / 500.0).position.A));
        }
        QVERIFY(worst < 0.05);
    }

    void twistAndScaleAreLinear() {
        const std::vector<Vec3> line = {{0, 0, 0}, {2, 0, 0}};
        const Trajectory<3> trajectory({curve<3>(Interpolation::Polyline, FrameKind::Minimal, line, kPi, 3)});
        for (const double t : {0.25, 0.5, 1.0}) {
            const Mat3 expected = (1 + 2 * t) * Eigen::AngleAxisd(kPi * t, Vec3::UnitX()).toRotationMatrix();
            QVERIFY(maxNorm(trajectory.at(t).position.A - expected) < 1e-14 * 10);
        }
    }

    void nonsenseIsRefused() {
        const std::vector<Vec2> good = sCurve<2>();
        Motion<2> reversed{Translate<2>{{1, 0}}};
        reversed.start = 1, reversed.end = 1;
        QVERIFY(throwsNaming<2>(reversed, "time"));
        QVERIFY(throwsNaming<2>({Translate<2>{{NAN, 0}}}, "by"));
        QVERIFY(throwsNaming<3>({Rotate<3>{{0, 0, 0}, {0, 0, 0}, 1}}, "axis"));
        QVERIFY(throwsNaming<2>({curve<2>(Interpolation::Bezier, FrameKind::None, {{0, 0}, {1, 1}, {2, 2}})},
                                "points"));
        QVERIFY(throwsNaming<2>({curve<2>(Interpolation::Spline, FrameKind::None, {{0, 0}})}, "points"));
        QVERIFY(throwsNaming<2>({curve<2>(Interpolation::Bezier, FrameKind::Minimal, good, 1)}, "twist"));
        QVERIFY(throwsNaming<3>({curve<3>(Interpolation::Bezier, FrameKind::None, sCurve<3>(), 1)}, "twist"));
        QVERIFY(throwsNaming<2>({curve<2>(Interpolation::Bezier, FrameKind::None, good, 0, 0)}, "scale"));
        QVERIFY(throwsNaming<2>({Recorded<2>{{0, 1, 1}, {{0, 0}, {1, 1}, {2, 2}}}}, "times"));
        QVERIFY(throwsNaming<2>({Recorded<2>{{0, 1}, {{0, 0}}}}, "times"));
    }
};

QTEST_APPLESS_MAIN(TestMotion)
#include "test_motion.moc"
