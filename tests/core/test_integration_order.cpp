#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "core/integration/runge_kutta.h"
#include "core/integration/step_control.h"
#include "tests/core/test_strip.h"

using namespace wend;

namespace {

using State2 = Eigen::Matrix<double, 2, Eigen::Dynamic>;

/// A planar rotation of changing rate with a drift: y′ = w(t) J y + g(t), with y = R(∫w) y₀ + (sin t, t²)
/// known.
struct Known {
    static double angle(double t) { return 2 * std::sin(t) + t * t / 2; }
    static double rate(double t) { return 2 * std::cos(t) + t; }
    static Eigen::Vector2d drift(double t) { return {std::sin(t), t * t}; }
    static Eigen::Vector2d driftRate(double t) { return {std::cos(t), 2 * t}; }

    static State2 slope(double t, const State2& y) {
        const auto stages = makeHostStages<2>();
        stages->combine(std::make_shared<const State2>(y), {});
        State2 dy;
        f(t, Side::After, *stages, dy);
        return dy;
    }
    static State2 exact(double t) {
        State2 y(2, 2);
        y << 1, 0.5, 0, 2;
        return (Eigen::Rotation2Dd(angle(t)).toRotationMatrix() * y).colwise() + drift(t);
    }
    static bool f(double t, Side, StageVectors<2>& stages, State2& dy) {
        const State2 z = stages.shape()->colwise() - drift(t);
        dy.resize(2, z.cols());
        dy.row(0) = -rate(t) * z.row(1);
        dy.row(1) = rate(t) * z.row(0);
        dy.colwise() += driftRate(t);
        return true;
    }
};

/// The slope of log error over log step by least squares.
double order(const std::vector<double>& steps, const std::vector<double>& errors) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double n = double(steps.size());
    for (size_t i = 0; i < steps.size(); ++i) {
        const double x = std::log(1 / steps[i]), y = std::log(errors[i]);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Nodal<2> nodal(const State2& y) {
    return std::make_shared<const State2>(y);
}

State2 integrate(Method method, int steps) {
    RungeKuttaStep<2> step(method);
    const auto stages = makeHostStages<2>();
    Nodal<2> y = nodal(Known::exact(0));
    for (int i = 0; i < steps; ++i) {
        if (!step.attempt(Known::f, *stages, 2.0 * i / steps, 2.0 * (i + 1) / steps, y, nullptr)) return {};
        y = step.result();
    }
    return *y;
}

}  // namespace

class TestIntegrationOrder : public QObject {
    Q_OBJECT

    template <int Dim>
    void bendOrder(Method method, double expected, const std::vector<double>& steps, int fine) {
        // At CONF the leading term of the error dominates from eight steps on, at METR only below rounding.
        const samples::Bend<Dim> bend(12, 3, 4, 1.5, phi::conformal(Dim));
        const auto run = [&](int count) {
            IntegrationOptions options;
            options.method = method;
            options.steps = count;
            options.velocityTolerance = 0;  // the error of the solver is of no order
            Deformer<Dim> deformer = bend.deformer(options);
            if (deformer.advance(1).outcome != Outcome::Done) qFatal("the bend failed");
            return deformer.state().points;
        };
        const Points<Dim> reference = run(fine);
        std::vector<double> errors;
        for (const double n : steps) errors.push_back(samples::distance(run(int(n)), reference));
        const double measured = order(steps, errors);
        QVERIFY2(std::abs(measured - expected) < 0.35, qPrintable(QString::number(measured)));
    }

  private slots:
    void orders_data() {
        QTest::addColumn<int>("method");
        QTest::addColumn<double>("expected");
        QTest::newRow("Dormand-Prince") << int(Method::DormandPrince) << 5.0;
        QTest::newRow("Runge-Kutta 4") << int(Method::RungeKutta4) << 4.0;
        QTest::newRow("midpoint") << int(Method::Midpoint) << 2.0;
    }
    void orders() {
        QFETCH(int, method);
        QFETCH(double, expected);
        const std::vector<double> steps = {16, 23, 32, 45, 64};
        std::vector<double> errors;
        for (const double n : steps)
            errors.push_back(samples::distance(integrate(Method(method), int(n)), Known::exact(2)));
        const double measured = order(steps, errors);
        QVERIFY2(std::abs(measured - expected) < 0.15, qPrintable(QString::number(measured)));
    }

    void tableausAreConsistent_data() { orders_data(); }
    void tableausAreConsistent() {
        QFETCH(int, method);
        QFETCH(double, expected);
        const Tableau& tableau = Tableau::of(Method(method));
        for (int i = 0; i < tableau.stages; ++i) {
            double sum = 0;
            for (int j = 0; j < i; ++j) sum += tableau.a[i][j];
            QVERIFY(std::abs(sum - tableau.c[i]) < 1e-14);
        }
        for (int k = 0; k < int(expected);
             ++k) {  // quadrature: Σ b c^k = 1/(k+1); the embedded one to order 4
            double sum = 0, embedded = 0;
            for (int i = 0; i < tableau.stages; ++i) {
                sum += tableau.b[i] * std::pow(tableau.c[i], k);
                embedded += tableau.error[i] * std::pow(tableau.c[i], k);
            }
            QVERIFY(std::abs(sum - 1.0 / (k + 1)) < 1e-14);
            if (k < 4) QVERIFY(std::abs(embedded) < 1e-14);
        }
    }

    /// One step from the exact solution gives the local error of the interpolant and of the embedded error
    /// estimate.
    void localOrders() {
        const std::vector<double> steps = {8, 12, 16, 24};
        std::vector<double> dense, hermite, estimate;
        for (const double n : steps) {
            const double t = 0.3, h = 1 / n;
            RungeKuttaStep<2> step(Method::DormandPrince);
            const auto stages = makeHostStages<2>();
            QVERIFY(step.attempt(Known::f, *stages, t, t + h, nodal(Known::exact(t)), nullptr));
            double worst = 0, worstHermite = 0;
            for (double theta = 0.1; theta < 1; theta += 0.1) {
                worst = std::max(worst, samples::distance(step.dense(theta), Known::exact(t + theta * h)));
                worstHermite = std::max(
                    worstHermite,
                    samples::distance(step.hermite(theta, *step.lastSlope()), Known::exact(t + theta * h)));
            }
            dense.push_back(worst);
            hermite.push_back(worstHermite);
            estimate.push_back(step.error(*stages));
            QVERIFY(samples::distance(step.dense(1), *step.result()) < 1e-14);
            QVERIFY(samples::distance(step.dense(0), Known::exact(t)) < 1e-14);
        }
        QVERIFY2(std::abs(order(steps, dense) - 5) < 0.3, qPrintable(QString::number(order(steps, dense))));
        QVERIFY2(std::abs(order(steps, hermite) - 4) < 0.3,
                 qPrintable(QString::number(order(steps, hermite))));
        QVERIFY2(std::abs(order(steps, estimate) - 5) < 0.3,
                 qPrintable(QString::number(order(steps, estimate))));
    }

    void lastStageIsTheNextFirst() {
        RungeKuttaStep<2> step(Method::DormandPrince);
        const auto stages = makeHostStages<2>();
        const Nodal<2> start = nodal(Known::exact(0));
        QVERIFY(step.attempt(Known::f, *stages, 0, 0.1, start, nullptr));
        QVERIFY(samples::distance(Known::slope(0.1, *step.result()), *step.lastSlope()) < 1e-15);
        const State2 result = *step.result();
        const Nodal<2> slope = nodal(Known::slope(0, *start));
        QVERIFY(step.attempt(Known::f, *stages, 0, 0.1, start, slope));
        QVERIFY(*step.result() == result);
    }

    /// The right-hand side jumps at both ends of the step: only the values inside it count.
    void jumpsAtTheEndsAreSeenFromInside_data() { orders_data(); }
    void jumpsAtTheEndsAreSeenFromInside() {
        QFETCH(int, method);
        const auto f = [](double t, Side side, StageVectors<2>& at, State2& dy) {
            const bool inside =
                (t > 1 || side == Side::After) && (t < 2 || side == Side::Before) && t >= 1 && t <= 2;
            dy = State2::Constant(2, at.shape()->cols(), inside ? 2 * t : 1e6);
            return true;
        };
        RungeKuttaStep<2> step{Method(method)};
        const auto stages = makeHostStages<2>();
        QVERIFY(step.attempt(f, *stages, 1, 2, nodal(State2::Zero(2, 1)), nullptr));
        QVERIFY(std::abs((*step.result())(0, 0) - 3) < 1e-13);
    }

    void failedStageStopsTheAttempt() {
        int calls = 0;
        const auto f = [&](double, Side, StageVectors<2>& at, State2& dy) {
            dy = *at.shape();
            return ++calls < 3;
        };
        RungeKuttaStep<2> step(Method::RungeKutta4);
        const auto stages = makeHostStages<2>();
        QVERIFY(!step.attempt(f, *stages, 0, 1, nodal(State2::Ones(2, 1)), nullptr));
        QCOMPARE(calls, 3);
    }

    void stepControl() {
        QVERIFY(growthAfterStep(1, 1) < 1);
        QVERIFY(growthAfterStep(0, 0) > 1 && growthAfterStep(0, 0) <= 5);
        QVERIFY(growthAfterStep(0.1, 0.1) >
                growthAfterStep(0.1, 0.01));  // an error that grows makes it careful
        QVERIFY(shrinkAfterError(2) < 1 && shrinkAfterError(100) < shrinkAfterError(2));
        QVERIFY(shrinkAfterError(NAN) > 0 && shrinkAfterError(NAN) < 1);
    }

    void bendOrder_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<int>("method");
        for (const int dim : {2, 3}) {
            QTest::addRow("Dormand-Prince %dD", dim) << dim << int(Method::DormandPrince);
            QTest::addRow("Runge-Kutta 4 %dD", dim) << dim << int(Method::RungeKutta4);
            QTest::addRow("midpoint %dD", dim) << dim << int(Method::Midpoint);
        }
    }
    void bendOrder() {
        QFETCH(int, dim);
        QFETCH(int, method);
        const double expected = Tableau::of(Method(method)).stages == 7 ? 5
                                : Method(method) == Method::RungeKutta4 ? 4
                                                                        : 2;
        const std::vector<double> steps =
            expected == 5 ? std::vector<double>{12, 16, 24, 32} : std::vector<double>{4, 6, 8, 12};
        const int fine = expected == 2 ? 100 : expected == 4 ? 40 : 96;
        dim == 2 ? bendOrder<2>(Method(method), expected, steps, fine)
                 : bendOrder<3>(Method(method), expected, steps, fine);
    }
};

QTEST_APPLESS_MAIN(TestIntegrationOrder)
#include "test_integration_order.moc"
