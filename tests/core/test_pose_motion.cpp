// Motions by poses and by fields of displacements, and the completed fraction of motions.

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/motion/constraints.h"
#include "core/motion/easing.h"
#include "core/motion/reach.h"
#include "core/motion/screw_motion.h"

using namespace wend;

namespace {

constexpr double kPi = std::numbers::pi;

/// The rotation by Eigen's formula instead of ours.
Mat3 rotation(const RotationVector<3>& w) {
    return w.norm() > 0 ? Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix() : Mat3::Identity();
}
Mat2 rotation(const RotationVector<2>& w) {
    return (Mat2() << std::cos(w[0]), -std::sin(w[0]), std::sin(w[0]), std::cos(w[0])).finished();
}

template <int Dim>
RigidPose<Dim> pose(int seed) {
    RigidPose<Dim> result;
    for (int k = 0; k < Dim; ++k) result.position[k] = 3 * std::sin(seed * 1.7 + k);
    for (int k = 0; k < result.rotation.size(); ++k) result.rotation[k] = 1.5 * std::sin(seed * 2.3 + 2 * k);
    return result;
}

template <int Dim>
PoseMotion<Dim> posesAt(const std::vector<double>& times) {
    PoseMotion<Dim> motion;
    motion.times = times;
    for (std::size_t k = 0; k < times.size(); ++k) motion.poses.push_back(pose<Dim>(static_cast<int>(k)));
    return motion;
}

/// A row of unit squares in the plane, or one tetrahedron in space.
template <int Dim>
SimplicialMesh<Dim> smallMesh() {
    SimplicialMesh<Dim> mesh;
    mesh.points.resize(Dim, Dim + 1);
    mesh.points.setZero();
    for (int k = 0; k < Dim; ++k) mesh.points(k, k + 1) = 2;
    Cell<Dim> cell;
    for (int k = 0; k <= Dim; ++k) cell[k] = k;
    mesh.cells = {cell};
    return mesh;
}

template <class Call>
std::string errorOf(Call call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.reason();
    }
    return {};
}

}  // namespace

class TestPoseMotion : public QObject {
    Q_OBJECT

    /// At every row a point of the body is where that pose has it, relative to the first pose.
    template <int Dim>
    void goesThroughPoses() {
        const std::vector<double> times{-1, 0.25, 2, 2.5, 4};
        Motion<Dim> motion{posesAt<Dim>(times)};
        motion.start = 10, motion.end = 20;
        const auto& poses = std::get<PoseMotion<Dim>>(motion.kind).poses;
        const Trajectory<Dim> trajectory(motion);
        QCOMPARE(trajectory.breakTimes().size(), std::size_t(3));
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double t = 10 + 10 * (times[k] + 1) / 5;
            if (k > 0 && k < 4) QVERIFY(std::abs(trajectory.breakTimes()[k - 1] - t) < 1e-14 * t);
            const Vec<Dim> inBody = Vec<Dim>::LinSpaced(0.5, 1.5);
            const Vec<Dim> before = rotation(poses[0].rotation) * inBody + poses[0].position;
            const Vec<Dim> expected = rotation(poses[k].rotation) * inBody + poses[k].position;
            for (const Side side : {Side::Before, Side::After}) {
                const double off = (trajectory.at(t, side).position(before) - expected).norm();
                QVERIFY2(off < 1e-13, qPrintable(QString::number(off)));
            }
        }
    }

    /// The twist is constant: v = ω × x + v₀ with the same ω and v₀ all the way between two rows.
    template <int Dim>
    void twistIsConstant() {
        const Trajectory<Dim> trajectory(Motion<Dim>{posesAt<Dim>({0, 1})});
        const auto twist = [&](double t) {
            const MovingMap<Dim> map = trajectory.at(t);
            const Mat<Dim> spin = map.velocity.A * map.position.A.transpose();
            Eigen::Matrix<double, Dim, Dim + 1> all;
            all << spin, map.velocity.b - spin * map.position.b;
            return all;
        };
        for (const double t : {0.1, 0.35, 0.5, 0.99}) {
            QVERIFY((twist(t) - twist(0)).norm() < 1e-12 * twist(0).norm());
            QVERIFY(
                (twist(t).template leftCols<Dim>() + twist(t).template leftCols<Dim>().transpose()).norm() <
                1e-12);
        }
        // Twice the same half of a screw motion is all of it.
        const AffineMap<Dim> half = trajectory.at(0.5).position, whole = trajectory.at(1).position;
        const Vec<Dim> x = Vec<Dim>::LinSpaced(1, 4);
        QVERIFY((half(half(x)) - whole(x)).norm() < 1e-12);
    }

    template <int Dim>
    void rotationVectorsAreRotations() {
        for (const double size : {0.0, 1e-9, 1e-3, 1.0, 3.1, 6.0}) {
            const RotationVector<Dim> w = size * RotationVector<Dim>::Ones().normalized();
            QVERIFY((rotationOf<Dim>(w) - rotation(w)).norm() < 1e-14);
        }
    }

    /// The pose between two rows is that of the trajectory, also when the rotation exceeds a turn.
    template <int Dim>
    void posesBetween() {
        RigidPose<Dim> from = pose<Dim>(1), to = pose<Dim>(2);
        from.rotation *= 5;
        to.rotation = from.rotation;
        to.rotation *= 1.2;
        const RigidPose<Dim> third = poseBetween<Dim>(from, to, 1.0 / 3);
        const Vec<Dim> x = Vec<Dim>::LinSpaced(1, 4);
        const Vec<Dim> there = ScrewMotion<Dim>(from, to).at(1.0 / 3).position(x);
        const Vec<Dim> inBody = rotation(from.rotation).transpose() * (x - from.position);
        QVERIFY((rotation(third.rotation) * inBody + third.position - there).norm() < 1e-12);
        QVERIFY((third.rotation - (from.rotation + (to.rotation - from.rotation) / 3)).norm() < 1e-12);
    }

    /// Every vertex moves along its own line; the velocity is the derivative, and the end is exact.
    template <int Dim>
    void fields() {
        const SimplicialMesh<Dim> mesh = smallMesh<Dim>();
        Displacements<Dim> values;
        for (int v = 0; v <= Dim; ++v) values.emplace_back(v, Vec<Dim>::LinSpaced(v, 2 * v - 1.0));
        Handle<Dim> handle;
        const Vec<Dim> middle = mesh.points.rowwise().mean();
        handle.at = std::vector<Vec<Dim>>{mesh.points.col(1), mesh.points.col(0), middle};
        Motion<Dim> motion{FieldMotion<Dim>{"u.csv", "", std::make_shared<const Displacements<Dim>>(values)}};
        motion.start = 1, motion.end = 3, motion.ease = Ease::InOut;
        handle.motions = {{Translate<Dim>{Vec<Dim>::Ones()}, 0, 1}, motion};
        const Constraints<Dim> constraints(mesh, {handle});
        auto anchors = constraints.anchors(mesh.points, 0);
        const std::vector<int> ids = constraints.activePoints(0, Side::After);
        QCOMPARE(ids.size(), std::size_t(3));
        constraints.crossBreakpoint(1, mesh.points, anchors);
        const auto placesAt = [&](double t, Points<Dim>* velocities = nullptr) {
            Points<Dim> places, speeds;
            constraints.evaluate(ids, anchors, t, Side::Before, places, speeds);
            if (velocities) *velocities = speeds;
            return places;
        };
        Vec<Dim> mean = Vec<Dim>::Zero();
        for (const auto& [vertex, displacement] : values) mean += displacement / (Dim + 1);
        const Points<Dim> end = placesAt(3);
        QVERIFY((end.col(0) - mesh.points.col(1) - Vec<Dim>::Ones() - values[1].second).norm() < 1e-14);
        QVERIFY((end.col(1) - mesh.points.col(0) - Vec<Dim>::Ones() - values[0].second).norm() < 1e-14);
        QVERIFY((end.col(2) - middle - Vec<Dim>::Ones() - mean).norm() < 1e-14);
        for (const double t : {1.2, 2.0, 2.9}) {
            Points<Dim> given;
            placesAt(t, &given);
            const double h = 1e-4;
            const Points<Dim> expected = (placesAt(t + h) - placesAt(t - h)) / (2 * h);
            QVERIFY((expected - given).norm() < 1e-7);  // h² times the third derivative
            const double u = ease(Ease::InOut, (t - 1) / 2);
            QVERIFY(
                (placesAt(t).col(0) - mesh.points.col(1) - Vec<Dim>::Ones() - u * values[1].second).norm() <
                1e-14);
        }
        // The anchor is found again from an intermediate place.
        const Points<Dim> halfway = placesAt(2);
        for (const int id : ids)
            QVERIFY(
                (constraints.anchor(id, halfway.col(id), 2) - anchors[static_cast<std::size_t>(id)]).norm() <
                1e-14);
        std::get<FieldMotion<Dim>>(handle.motions[1].kind).values =
            std::make_shared<const Displacements<Dim>>(Displacements<Dim>{values[0]});
        QCOMPARE(errorOf([&] { Constraints<Dim>(mesh, {handle}); }),
                 std::string("handle 0: motion 2: there is no displacement for vertex 1 in u.csv"));
    }

  private slots:
    void goesThroughPosesInThePlane() { goesThroughPoses<2>(); }
    void goesThroughPosesInSpace() { goesThroughPoses<3>(); }
    void twistIsConstantInThePlane() { twistIsConstant<2>(); }
    void twistIsConstantInSpace() { twistIsConstant<3>(); }
    void rotationVectors() {
        rotationVectorsAreRotations<2>();
        rotationVectorsAreRotations<3>();
    }
    void between() {
        posesBetween<2>();
        posesBetween<3>();
    }
    void fieldsInThePlane() { fields<2>(); }
    void fieldsInSpace() { fields<3>(); }

    /// The rotation is the shortest one, unless the rotation vectors give more.
    void turns() {
        const auto turnedBy = [](double from, double to) {
            const Vec3 axis = Vec3(1, 2, 2) / 3;
            const RigidPose<3> a{Vec3::Zero(), from * axis}, b{Vec3::Zero(), to * axis};
            const Mat3 rate = ScrewMotion<3>(a, b).at(0).velocity.A;
            return Vec3(rate(2, 1), rate(0, 2), rate(1, 0)).dot(axis);
        };
        QVERIFY(std::abs(turnedBy(3, -3) - (2 * kPi - 6)) < 1e-12);
        QVERIFY(std::abs(turnedBy(0, 2 * kPi) - 2 * kPi) < 1e-12);
        QVERIFY(std::abs(turnedBy(1, 8) - 7) < 1e-12);
        QVERIFY(std::abs(turnedBy(0.5, 2) - 1.5) < 1e-12);
        // A whole turn on the spot or along its axis is a screw motion, across it is none.
        const Vec3 z = Vec3::UnitZ();
        const RigidPose<3> here{Vec3(1, 2, 3), Vec3::Zero()};
        const ScrewMotion<3> along(here, {Vec3(1, 2, 5), 2 * kPi * z});
        QVERIFY((along.at(0.5).position(Vec3(2, 2, 3)) - Vec3(0, 2, 4)).norm() < 1e-13);
        QVERIFY(errorOf([&] {
                    ScrewMotion<3>(here, {Vec3(2, 2, 3), 2 * kPi * z});
                }).starts_with("a whole turn"));
        PoseMotion<2> standing = posesAt<2>({0, 1});
        standing.times[1] = 0;
        QVERIFY(errorOf([&] { Trajectory<2>(Motion<2>{standing}); }).find("do not increase at pose 1") !=
                std::string::npos);
    }

    /// The fraction of its motion that a handle has made.
    void reach() {
        Handle<2> handle;
        QCOMPARE(reachOf(handle, 0), 1.0);
        handle.motions = {{Translate<2>{}, 1, 2}, {Translate<2>{}, 3, 6, Ease::In}};
        const double times[] = {0, 1.5, 2.5, 4.5, 6, 9};
        const double expected[] = {0, 0.125, 0.25, 0.25 + 0.75 * 0.25, 1, 1};
        for (int k = 0; k < 6; ++k) QVERIFY(std::abs(reachOf(handle, times[k]) - expected[k]) < 1e-15);
        handle.activeFrom = 1.5, handle.activeTo = 4.5;  // half of the first, a quarter of the second
        QVERIFY(std::abs(reachOf(handle, 2) - 0.5 / (0.5 + 0.75)) < 1e-15);
        QCOMPARE(reachOf(handle, 4.5), 1.0);
        QCOMPARE(lastMotionEnd<2>({Handle<2>(), handle}, 1), 6.0);
        QCOMPARE(lastMotionEnd<2>({Handle<2>()}, 7), 7.0);
    }
};

QTEST_GUILESS_MAIN(TestPoseMotion)
#include "test_pose_motion.moc"
