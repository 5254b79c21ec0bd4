#include <Eigen/Geometry>
#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "tests/core/test_strip.h"

using namespace wend;
using samples::Bend;
using samples::distance;
using samples::runTo;

namespace {

constexpr double kPi = std::numbers::pi;

IntegrationOptions precise(double tolerance) {
    IntegrationOptions options;
    options.tolerance = tolerance;
    return options;
}

template <int Dim>
bool identical(const Points<Dim>& a, const Points<Dim>& b) {
    return a.cols() == b.cols() && (a.array() == b.array()).all();
}

/// One handle on a point inside the shape, dragged along a line; nothing else holds the shape.
template <int Dim>
struct Drag {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh =
        std::make_shared<SimplicialMesh<Dim>>(samples::strip<Dim>(8, 3, 3));
    std::shared_ptr<const Material<Dim>> material =
        std::make_shared<Material<Dim>>(Material<Dim>::uniform(mesh->cellCount(), phi::kAkvf));
    Vec<Dim> p = Vec<Dim>::Constant(0.27), by = Vec<Dim>::Constant(0.2);
    Handle<Dim> handle;

    Drag() {
        by[0] = 0.3, by[1] = 1.5;
        handle.name = "hand";
        handle.at = std::vector<Vec<Dim>>{p};
        handle.motions = {Motion<Dim>{Translate<Dim>{by}}};
    }

    /// Second moments about p of the rest shape, its centroid and measure, raised to space.
    struct Moments {
        Mat3 S = Mat3::Zero();
        Vec3 r = Vec3::Zero();  // p − centroid
        double measure = 0;
    };
    static Vec3 raised(const Vec<Dim>& v) {
        Vec3 result = Vec3::Zero();
        result.template head<Dim>() = v;
        return result;
    }
    Moments moments() const {
        Moments m;
        for (const Cell<Dim>& cell : mesh->cells) {
            const double V = std::abs(cellMeasure<Dim>(mesh->points, cell));
            Vec3 sum = Vec3::Zero();
            Mat3 squares = Mat3::Zero();
            for (const int v : cell) {
                const Vec3 d = raised(mesh->points.col(v) - p);
                sum += d;
                squares += d * d.transpose();
            }
            m.S += V / ((Dim + 1) * (Dim + 2)) * (squares + sum * sum.transpose());
            m.r -= V / (Dim + 1) * sum;
            m.measure += V;
        }
        m.r /= m.measure;
        return m;
    }
    /// Returns the rigid motion v = u + ω × (x − p) of least ∫|v|²: (Tr S I − S) ω = measure · r × u, with S
    /// and r rotated; integrated by RK4.
    Points<Dim> trailed() const {
        const Moments m = moments();
        const Vec3 u = raised(by);
        const auto rate = [&](const Mat3& R) -> Mat3 {
            const Mat3 S = R * m.S * R.transpose();
            const Mat3 inertia = S.trace() * Mat3::Identity() - S;
            const Vec3 omega = inertia.ldlt().solve(m.measure * (R * m.r).cross(u));
            Mat3 result;
            for (int c = 0; c < 3; ++c) result.col(c) = omega.cross(R.col(c));
            return result;
        };
        Mat3 R = Mat3::Identity();
        const int n = 400;
        for (int i = 0; i < n; ++i) {
            const double h = 1.0 / n;
            const Mat3 k1 = rate(R), k2 = rate(R + h / 2 * k1), k3 = rate(R + h / 2 * k2),
                       k4 = rate(R + h * k3);
            R += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        Points<Dim> result = mesh->points;
        for (int v = 0; v < mesh->vertexCount(); ++v) {
            result.col(v) = p + by + (R * raised(mesh->points.col(v) - p)).template head<Dim>();
        }
        return result;
    }
};

}  // namespace

class TestIntegrationDeformer : public QObject {
    Q_OBJECT

    template <int Dim>
    void accuracy() {
        const Bend<Dim> bend(12, 3, 4, 2);
        Deformer<Dim> fine = bend.deformer(precise(1e-10));
        const Points<Dim> reference = runTo(fine, 1);
        for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
            Deformer<Dim> deformer = bend.deformer(precise(tolerance));
            const double error =
                distance(runTo(deformer, 1), reference) / boundingBoxDiagonal<Dim>(bend.mesh->points);
            QVERIFY2(error < 5 * tolerance, qPrintable(QString::number(error)));
            QVERIFY(error > tolerance / 1e5);  // it does not work much harder than asked
            QVERIFY(deformer.statistics().constraintError <= 1e-12);
            QVERIFY(deformer.statistics().steps > 0 && deformer.statistics().factorizations > 0);
            QVERIFY(deformer.statistics().energy > 0);
            for (int v = 0; v < bend.mesh->vertexCount(); ++v) {  // the held end keeps its bits
                if (bend.mesh->points(0, v) == 0)
                    QVERIFY(deformer.state().points.col(v) == bend.mesh->points.col(v));
            }
        }
    }

    template <int Dim>
    void reversible() {
        Bend<Dim> bend(12, 3, 4, 1.2);
        Motion<Dim> back = bend.handles[1].motions[0];
        std::get<Rotate<Dim>>(back.kind).angle *= -1;
        back.start = 1, back.end = 2;
        bend.handles[1].motions.push_back(back);
        for (const double tolerance : {1e-4, 1e-7}) {
            Deformer<Dim> deformer = bend.deformer(precise(tolerance));
            runTo(deformer, 1);
            QVERIFY(distance(deformer.state().points, bend.mesh->points) > 1);
            const double error =
                distance(runTo(deformer, 2), bend.mesh->points) / boundingBoxDiagonal<Dim>(bend.mesh->points);
            QVERIFY2(error < 10 * tolerance, qPrintable(QString::number(error)));
        }
    }

    /// The whole problem is scaled and moved, with the same y axis: the shape is the same.
    template <int Dim>
    void scaledAndMoved() {
        Bend<Dim> bend(12, 3, 4, 2), other = bend;
        Handle<Dim> inside;  // a point inside a cell, along a curve with a frame
        inside.name = "inside";
        inside.at = std::vector<Vec<Dim>>{Vec<Dim>::Constant(0.77)};
        const auto point = [](double x, double y) {
            Vec<Dim> p = Vec<Dim>::Constant(0.3);
            p[0] = x, p[1] = y;
            return p;
        };
        inside.motions = {{CurveMotion<Dim>{Interpolation::Bezier,
                                            {point(0.77, 0.77), point(0.8, 1), point(1, 0.9), point(1, 1)},
                                            FrameKind::Minimal}}};
        bend.handles.push_back(inside);
        const Vec<Dim> offset = Vec<Dim>::Constant(-300);
        const double scale = 37;
        auto moved = std::make_shared<SimplicialMesh<Dim>>(*bend.mesh);
        moved->points = (scale * bend.mesh->points).colwise() + offset;
        other.mesh = moved;
        other.handles = bend.handles;
        const Normalization<Dim> map{-offset / scale, 1 / scale};  // x ↦ (x − c) / D
        for (Handle<Dim>& handle : other.handles) handle = map.normal(handle);
        for (const double velocityTolerance : {0.0, -1.0}) {
            IntegrationOptions options;
            options.velocityTolerance = velocityTolerance;
            Deformer<Dim> a = bend.deformer(options), b = other.deformer(options);
            const Points<Dim> expected = (scale * runTo(a, 1)).colwise() + offset;
            const double error =
                distance(runTo(b, 1), expected) / (scale * boundingBoxDiagonal<Dim>(bend.mesh->points));
            // Iterations with a factor in single precision let the tolerance of the velocity amplify that.
            QVERIFY2(error < (velocityTolerance == 0 ? 1e-10 : 1e-7), qPrintable(QString::number(error)));
            QCOMPARE(a.statistics().evaluations, b.statistics().evaluations);
        }
    }

    template <int Dim>
    void resumedRunsAreIdentical() {
        Bend<Dim> bend(10, 2, 4, 1.5);
        bend.handles[1].motions[0].end = 0.5;
        Motion<Dim> up{Translate<Dim>{0.5 * Vec<Dim>::Unit(1)}};
        up.start = 0.7, up.end = 1, up.ease = Ease::InOut;
        bend.handles[1].motions.push_back(up);
        Handle<Dim> late;
        late.name = "late";
        late.at = std::vector<Vec<Dim>>{Vec<Dim>::Constant(0.4)};
        late.activeFrom = 0.6;
        bend.handles.push_back(late);

        const IntegrationOptions options = precise(1e-5);
        Deformer<Dim> whole = bend.deformer(options);
        std::vector<State<Dim>> states = {whole.state()};
        typename Deformer<Dim>::Watch watch;
        watch.progress = [&](double) { states.push_back(whole.state()); };
        const Points<Dim> expected = runTo(whole, 1, watch);
        QVERIFY(states.size() > 6);
        for (const State<Dim>& state : states) {
            Deformer<Dim> resumed = bend.deformer(options);
            resumed.restore(state);
            QVERIFY(identical(resumed.state().points, state.points));
            QVERIFY(identical(runTo(resumed, 1), expected));
        }
        // The state behind the last breakpoint but one continues with the late handle, which is only known
        // from then on.
        Bend<Dim> before = bend;
        before.handles.pop_back();
        Deformer<Dim> other = before.deformer(options);
        runTo(other, 0.6);
        Deformer<Dim> resumed = bend.deformer(options);
        resumed.restore(other.state());
        QVERIFY(identical(runTo(resumed, 1), expected));
    }

    template <int Dim>
    void cancelledRunsGoOn() {
        const Bend<Dim> bend(10, 2, 4, 1.5);
        Deformer<Dim> whole = bend.deformer(precise(1e-6)), halted = bend.deformer(precise(1e-6));
        const Points<Dim> expected = runTo(whole, 1);
        std::stop_source source;
        typename Deformer<Dim>::Watch watch;
        watch.stop = source.get_token();
        watch.progress = [&](double) { source.request_stop(); };
        const AdvanceResult result = halted.advance(1, watch);
        QVERIFY(result.outcome == Outcome::Cancelled && result.time > 0 && result.time < 1);
        QCOMPARE(halted.state().time, result.time);
        QVERIFY(identical(runTo(halted, 1), expected));
    }

    template <int Dim>
    void framesChangeNothing(IntegrationOptions options, double allowed) {
        const Bend<Dim> bend(10, 2, 4, 1.5);
        Deformer<Dim> plain = bend.deformer(options), filmed = bend.deformer(options),
                      fine = bend.deformer(precise(1e-9));
        std::vector<State<Dim>> frames, references;
        typename Deformer<Dim>::Watch watch;
        for (int i = 0; i <= 20; ++i) watch.frames.push_back(i / 20.0);
        watch.onFrame = [&](const State<Dim>& state) { frames.push_back(state); };
        const Points<Dim> expected = runTo(plain, 1);
        QVERIFY(identical(runTo(filmed, 1, watch), expected));
        QCOMPARE(filmed.statistics().steps, plain.statistics().steps);
        watch.onFrame = [&](const State<Dim>& state) { references.push_back(state); };
        runTo(fine, 1, watch);
        QCOMPARE(frames.size(), size_t(21));
        QVERIFY(identical(frames.front().points, bend.mesh->points));
        QVERIFY(identical(frames.back().points, expected));
        const int tip = bend.mesh->vertexCount() - 1;
        const Trajectory<Dim> trajectory(bend.handles[1].motions[0]);
        for (size_t i = 0; i < frames.size(); ++i) {
            QCOMPARE(frames[i].time, watch.frames[i]);
            const double error = distance(frames[i].points, references[i].points);
            QVERIFY2(error < allowed, qPrintable(QString::number(error)));
            const Vec<Dim> wanted = trajectory.at(frames[i].time).position(bend.mesh->points.col(tip));
            QVERIFY((frames[i].points.col(tip) - wanted).norm() < 1e-12);
        }
    }

    /// A motion of a ten-thousandth of the time is not stepped over, and nothing happens around it.
    template <int Dim>
    void shortWindowsAreSeen() {
        Bend<Dim> bend(8, 2, 4, 0);
        Motion<Dim> move{Translate<Dim>{0.4 * Vec<Dim>::Unit(1)}};
        move.start = 0.6180339, move.end = 0.6181339;
        bend.handles[1].motions = {move};
        Deformer<Dim> deformer = bend.deformer();
        std::vector<double> times;
        typename Deformer<Dim>::Watch watch;
        watch.progress = [&](double t) { times.push_back(t); };
        const Points<Dim> end = runTo(deformer, 1, watch);
        const int tip = bend.mesh->vertexCount() - 1;
        QVERIFY((end.col(tip) - bend.mesh->points.col(tip) - 0.4 * Vec<Dim>::Unit(1)).norm() < 1e-12);
        QCOMPARE(times.front(), move.start);
        QVERIFY(std::find(times.begin(), times.end(), move.end) != times.end());
        QCOMPARE(times.back(), 1.0);
        // The same motion over all the time gives the same shape: velocity is linear in the handle's.
        bend.handles[1].motions = {Motion<Dim>{Translate<Dim>{0.4 * Vec<Dim>::Unit(1)}}};
        Deformer<Dim> slow = bend.deformer();
        QVERIFY(distance(runTo(slow, 1), end) < 1e-9);
    }

    /// Corners of a polyline end steps, so that a fixed-step method keeps its order there.
    template <int Dim>
    void cornersEndSteps() {
        Bend<Dim> bend(8, 2, 4, 0);
        const Vec<Dim> start = Vec<Dim>::Zero();
        bend.handles[1].motions = {{CurveMotion<Dim>{
            Interpolation::Polyline,
            {start, 0.3 * Vec<Dim>::Unit(1), 0.3 * Vec<Dim>::Unit(1) + 0.5 * Vec<Dim>::Unit(0)}}}};
        std::vector<double> times;
        typename Deformer<Dim>::Watch watch;
        watch.progress = [&](double t) { times.push_back(t); };
        IntegrationOptions options;
        options.method = Method::RungeKutta4;
        options.steps = 4;
        Deformer<Dim> deformer = bend.deformer(options), fine = bend.deformer(precise(1e-9));
        const Points<Dim> end = runTo(deformer, 1, watch);
        const std::vector<double> expected = {0.25, 0.375, 0.5, 0.75, 1};
        QCOMPARE(times.size(), expected.size());
        for (size_t i = 0; i < times.size(); ++i) QVERIFY(std::abs(times[i] - expected[i]) < 1e-15);
        QVERIFY(distance(end, runTo(fine, 1)) < 1e-5);
    }

    template <int Dim>
    void nothingMovesWithoutMotion() {
        Bend<Dim> bend(8, 2, 4, 1);
        bend.handles[1].motions.clear();
        Deformer<Dim> held = bend.deformer();
        QVERIFY(identical(runTo(held, 5), bend.mesh->points));
        QCOMPARE(held.statistics().evaluations, 0);
        QCOMPARE(held.statistics().steps, 1);
        QVERIFY(held.velocity().isZero(0));
        bend.handles.clear();
        Deformer<Dim> free = bend.deformer();
        QVERIFY(identical(runTo(free, 5), bend.mesh->points));
        QVERIFY(free.velocity().isZero(0));
    }

    template <int Dim>
    void draggedPointTrails() {
        const Drag<Dim> drag;
        Deformer<Dim> deformer(drag.mesh, drag.material, {drag.handle}, precise(1e-8));
        const Points<Dim> end = runTo(deformer, 1), expected = drag.trailed();
        QVERIFY(distance(expected, drag.mesh->points) > 0.5);
        const double error = distance(end, expected);
        // The solver's mass term of 1e-4 bends the shape by as much of the path as it is smaller than the
        // energy of bending.
        QVERIFY2(error < 3e-5, qPrintable(QString::number(error)));
        QVERIFY(deformer.statistics().constraintError <= 1e-12);
    }

    /// Motions that no step is short enough for end at once, with a reason, whatever overflows.
    template <int Dim>
    void absurdlyFastMotionsEnd() {
        const double far = QTest::currentDataTag() == QByteArray("overflow") ? 1e300 : 1e7;
        Bend<Dim> bend(4, 1, 4, 0);
        bend.handles[1].motions = {Motion<Dim>{Translate<Dim>{far * Vec<Dim>::Unit(1)}}};
        Deformer<Dim> deformer = bend.deformer(precise(1e-3));
        const AdvanceResult result = deformer.advance(1);
        QCOMPARE(result.outcome, Outcome::StepTooSmall);
        QVERIFY(result.time < 1e-3);
        QVERIFY2(result.message.text().find("too fast") != std::string::npos, result.message.text().c_str());
        QVERIFY(deformer.statistics().steps < 1000);
    }

    /// The right end moves straight through the left one, which is held.
    template <int Dim>
    void pushedThroughAnEdge() {
        Bend<Dim> bend(8, 2, 2, 0);
        bend.handles[1].motions = {Motion<Dim>{Translate<Dim>{-3 * Vec<Dim>::Unit(0)}}};
        Deformer<Dim> deformer = bend.deformer(precise(1e-3));
        const AdvanceResult result = deformer.advance(1);
        QCOMPARE(result.outcome, Outcome::CellInverted);
        QVERIFY(result.time > 0.3 && result.time < 0.667);  // they meet at 2/3
        QCOMPARE(deformer.state().time, result.time);
        QVERIFY(result.cell >= 0 && result.cell < bend.mesh->cellCount());
        const QString message = QString::fromStdString(result.message);
        QVERIFY2(QRegularExpression("^at time 0\\.\\d+ handle .* cannot go on: the shape would fold over "
                                    "near \\(.*\\), in cell \\d+; ")
                     .match(message)
                     .hasMatch(),
                 qPrintable(message));
        QCOMPARE(distortion<Dim>(*bend.mesh, deformer.state().points).flips, 0);
        QVERIFY(deformer.statistics().rejected > 0);
        QVERIFY(deformer.statistics().constraintError <= 1e-12);
    }

    template <int Dim>
    void halfTurnOfAnEnd(double phi) {
        const Bend<Dim> bend(16, 3, 4, kPi, phi);
        Deformer<Dim> deformer = bend.deformer();
        int flips = 0;
        typename Deformer<Dim>::Watch watch;
        for (int i = 0; i <= 30; ++i) watch.frames.push_back(i / 30.0);
        watch.onFrame = [&](const State<Dim>& state) {
            flips += distortion<Dim>(*bend.mesh, state.points).flips;
        };
        const AdvanceResult result = deformer.advance(1, watch);
        QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
        QCOMPARE(flips, 0);
        QVERIFY(deformer.statistics().constraintError <= 1e-12);
    }

    /// The velocity field is the derivative of the poses.
    template <int Dim>
    void velocityIsDerivative() {
        const Bend<Dim> bend(8, 2, 4, 1);
        Deformer<Dim> deformer = bend.deformer(precise(1e-10));
        const double h = 1e-4;
        const Points<Dim> before = runTo(deformer, 0.5 - h);
        runTo(deformer, 0.5);
        const Points<Dim> velocity = deformer.velocity(), after = runTo(deformer, 0.5 + h);
        QVERIFY(distance(velocity, (after - before) / (2 * h)) < 1e-6);
        runTo(deformer, 1);
        const Points<Dim> last = deformer.velocity();  // of the motion that ends here
        QVERIFY(distance(last, velocity) < 2 * velocity.colwise().norm().maxCoeff());
        QVERIFY(last.colwise().norm().maxCoeff() > 1);
        runTo(deformer, 2);
        QVERIFY(deformer.velocity().isZero(0));
    }

    /// A handle acts for part of the time: before and after it the point is free.
    template <int Dim>
    void partTimeHandles() {
        Bend<Dim> bend(10, 2, 4, 1);
        Handle<Dim> hand;
        hand.name = "hand";
        Vec<Dim> p = Vec<Dim>::Constant(0.5);
        p[0] = 2.2;
        hand.at = std::vector<Vec<Dim>>{p};
        hand.activeFrom = 0.4, hand.activeTo = 0.6;
        bend.handles.push_back(hand);
        Deformer<Dim> deformer = bend.deformer(precise(1e-6));
        const ConstrainedPoint point = Constraints<Dim>(*bend.mesh, {hand}).points().front();
        const auto at = [&](double t) { return point.in<Dim>(runTo(deformer, t)); };
        const Vec<Dim> first = at(0.4), middle = at(0.5), last = at(0.6), later = at(1);
        QVERIFY((first - p).norm() > 0.05);
        QVERIFY((first - middle).norm() < 1e-12 && (middle - last).norm() < 1e-12);
        QVERIFY((later - last).norm() > 0.05);
        QVERIFY(deformer.statistics().constraintError <= 1e-12);
    }

    /// Handles are changed during the motion: the result is as if the new motion had been there from the
    /// start.
    template <int Dim>
    void changedOnTheWay() {
        Bend<Dim> bend(10, 2, 4, 1);
        bend.handles[1].motions[0].end = 0.5;
        Deformer<Dim> live = bend.deformer();
        runTo(live, 0.5);
        Motion<Dim> more{Translate<Dim>{0.5 * Vec<Dim>::Unit(1)}};
        more.start = 0.5, more.end = 1;
        bend.handles[1].motions.push_back(more);
        Deformer<Dim> whole = bend.deformer();
        live.setHandles(bend.handles);
        QVERIFY(identical(runTo(live, 1), runTo(whole, 1)));
        // Invalid handles are refused, and nothing has changed.
        const Points<Dim> points = live.state().points;
        auto wrong = bend.handles;
        wrong.push_back(wrong[1]);
        wrong.back().motions.clear();
        QVERIFY_THROWS_EXCEPTION(InputError, live.setHandles(wrong));
        QVERIFY(identical(live.state().points, points));
    }

  private slots:
    void accuracy2() { accuracy<2>(); }
    void accuracy3() { accuracy<3>(); }
    void reversible2() { reversible<2>(); }
    void reversible3() { reversible<3>(); }
    void scaledAndMoved2() { scaledAndMoved<2>(); }
    void scaledAndMoved3() { scaledAndMoved<3>(); }
    void resumedRunsAreIdentical2() { resumedRunsAreIdentical<2>(); }
    void resumedRunsAreIdentical3() { resumedRunsAreIdentical<3>(); }
    void cancelledRunsGoOn2() { cancelledRunsGoOn<2>(); }
    void cancelledRunsGoOn3() { cancelledRunsGoOn<3>(); }
    void framesChangeNothing_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<int>("method");
        for (const int dim : {2, 3}) {
            QTest::addRow("Dormand-Prince %dD", dim) << dim << int(Method::DormandPrince);
            QTest::addRow("Runge-Kutta 4 %dD", dim) << dim << int(Method::RungeKutta4);
        }
    }
    void framesChangeNothing() {
        QFETCH(int, dim);
        QFETCH(int, method);
        IntegrationOptions options = precise(1e-5);
        options.method = Method(method);
        if (options.method != Method::DormandPrince) options.steps = 12;
        const double allowed = options.steps > 0 ? 1e-3 : 5e-4;
        dim == 2 ? framesChangeNothing<2>(options, allowed) : framesChangeNothing<3>(options, allowed);
    }
    void shortWindowsAreSeen2() { shortWindowsAreSeen<2>(); }
    void shortWindowsAreSeen3() { shortWindowsAreSeen<3>(); }
    void cornersEndSteps2() { cornersEndSteps<2>(); }
    void cornersEndSteps3() { cornersEndSteps<3>(); }
    void nothingMovesWithoutMotion2() { nothingMovesWithoutMotion<2>(); }
    void nothingMovesWithoutMotion3() { nothingMovesWithoutMotion<3>(); }
    void draggedPointTrails2() { draggedPointTrails<2>(); }
    void draggedPointTrails3() { draggedPointTrails<3>(); }
    void absurdlyFastMotionsEnd2_data() {
        QTest::addColumn<int>("unused");
        QTest::newRow("ten million diagonals") << 0;
        QTest::newRow("overflow") << 0;
    }
    void absurdlyFastMotionsEnd2() { absurdlyFastMotionsEnd<2>(); }
    void absurdlyFastMotionsEnd3_data() { absurdlyFastMotionsEnd2_data(); }
    void absurdlyFastMotionsEnd3() { absurdlyFastMotionsEnd<3>(); }
    void pushedThroughAnEdge2() { pushedThroughAnEdge<2>(); }
    void pushedThroughAnEdge3() { pushedThroughAnEdge<3>(); }
    void halfTurnOfAnEnd_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<double>("phi");
        for (const int dim : {2, 3}) {
            QTest::addRow("equia %dD", dim) << dim << phi::kEquia;
            QTest::addRow("metr %dD", dim) << dim << phi::kMetr;
            QTest::addRow("akvf %dD", dim) << dim << phi::kAkvf;
            QTest::addRow("conf %dD", dim) << dim << phi::conformal(dim);
        }
    }
    void halfTurnOfAnEnd() {
        QFETCH(int, dim);
        QFETCH(double, phi);
        dim == 2 ? halfTurnOfAnEnd<2>(phi) : halfTurnOfAnEnd<3>(phi);
    }
    void velocityIsDerivative2() { velocityIsDerivative<2>(); }
    void velocityIsDerivative3() { velocityIsDerivative<3>(); }
    void partTimeHandles2() { partTimeHandles<2>(); }
    void partTimeHandles3() { partTimeHandles<3>(); }
    void changedOnTheWay2() { changedOnTheWay<2>(); }
    void changedOnTheWay3() { changedOnTheWay<3>(); }

    void optionsAreChecked() {
        const Bend<2> bend(4, 1, 4, 1);
        const auto refused = [&](auto change) {
            IntegrationOptions options;
            change(options);
            if (options.problem().empty()) return false;
            try {
                bend.deformer(options);
            } catch (const InputError&) {
                return true;
            }
            return false;
        };
        QVERIFY(IntegrationOptions{}.problem().empty());
        QVERIFY(refused([](auto& o) { o.tolerance = 0; }));
        QVERIFY(refused([](auto& o) { o.steps = -1; }));
        QVERIFY(refused([](auto& o) { o.method = Method::RungeKutta4; }));
        QVERIFY(refused([](auto& o) { o.end = NAN; }));
        QVERIFY(refused([](auto& o) { o.smallestStep = 0; }));
        QVERIFY(refused([](auto& o) { o.threads = -1; }));
        Deformer<2> deformer = bend.deformer();
        State<2> state = deformer.state();
        state.points.conservativeResize(2, 3);
        QVERIFY_THROWS_EXCEPTION(InputError, deformer.restore(state));
    }
};

QTEST_APPLESS_MAIN(TestIntegrationDeformer)
#include "test_integration_deformer.moc"
