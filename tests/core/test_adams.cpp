// The Adams method alone, on an equation with a known solution; the deformer's tests include it with the
// others.
#include <QTest>
#include <cmath>

#include "core/integration/adams_method.h"

using namespace wend;

namespace {

using Field = Points2;
constexpr double kStart = 0.3;

/// ẋ = w(t) J x + ġ − w J g: a rotation of changing rate about a drifting centre, x = R(∫w) x₀ + g.
struct Known {
    static double angle(double t) { return 2 * std::sin(t) + t * t / 2; }
    static double rate(double t) { return 2 * std::cos(t) + t; }
    static Field exact(double t) {
        const double c = std::cos(angle(t)), s = std::sin(angle(t));
        Field x(2, 2);
        x << c, 0.5 * c - 2 * s, s, 0.5 * s + 2 * c;
        return x.colwise() + Vec2(std::sin(t), t * t);
    }
    static bool f(double t, Side, StageVectors<2>& stages, Field& v) {
        const Field z = stages.shape()->colwise() - Vec2(std::sin(t), t * t);
        v.resize(2, z.cols());
        v.row(0) = -rate(t) * z.row(1);
        v.row(1) = rate(t) * z.row(0);
        v.colwise() += Vec2(std::cos(t), 2 * t);
        return true;
    }
};

double distance(const Field& a, const Field& b) {
    return (a - b).colwise().norm().maxCoeff();
}

/// The slope of log y over log x by least squares.
double slope(const std::vector<double>& xs, const std::vector<double>& ys) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(xs.size());
    for (std::size_t i = 0; i < xs.size(); ++i) {
        const double x = std::log(xs[i]), y = std::log(ys[i]);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Nodal<2> nodal(const Field& x) {
    return std::make_shared<const Field>(x);
}

/// Returns the history that `order` exact steps of changing lengths before kStart would have left.
Pace<2> pastOf(int order, double h) {
    Pace<2> pace;
    pace.order = order;
    double t = kStart;
    for (int i = 0; i < order; ++i) {
        const auto stages = makeHostStages<2>();
        stages->combine(nodal(Known::exact(t)), {});
        auto field = std::make_shared<Field>();
        Known::f(t, Side::After, *stages, *field);
        pace.fields.insert(pace.fields.begin(), {t, std::move(field)});
        t -= i % 2 == 0 ? 0.6 * h : 1.7 * h;
    }
    return pace;
}

struct Run {
    double error = 0;
    int evaluations = 0, rejected = 0, highest = 0;
};

Run runTo(double end, double tolerance) {
    AdamsMethod<2> method(tolerance);
    Pace<2> pace;
    pace.step = method.firstStep(4);
    Run run;
    const auto f = [&](double t, Side side, StageVectors<2>& at, Field& v) {
        ++run.evaluations;
        return Known::f(t, side, at, v);
    };
    const auto stages = makeHostStages<2>();
    Nodal<2> x = nodal(Known::exact(0));
    for (double t = 0; t < end;) {
        const double to = std::min(end, t + pace.step);
        if (!method.attempt(f, *stages, t, to, x, pace)) qFatal("not evaluated");
        if (!(method.error() <= 1)) {
            ++run.rejected;
            method.retry(pace);
            continue;
        }
        x = method.result();
        method.accept(pace, false, to < t + pace.step);
        t = to;
        run.highest = std::max(run.highest, pace.order);
    }
    run.error = distance(*x, Known::exact(end));
    return run;
}

}  // namespace

class TestAdams : public QObject {
    Q_OBJECT
  private slots:
    /// Polynomials up to the degree that so many times determine are integrated to rounding.
    void weightsAreExact() {
        const std::vector<double> all = {-1.3, -1, -0.45, -0.4, -0.1, 0, 0.37};
        for (std::size_t count = 1; count <= all.size(); ++count) {
            const std::vector<double> times(all.end() - static_cast<std::ptrdiff_t>(count), all.end());
            const auto weights = adamsWeights(times, -0.05, 0.3);
            for (int power = 0; power < static_cast<int>(count); ++power) {
                double sum = 0;
                for (std::size_t i = 0; i < count; ++i) sum += weights[i] * std::pow(times[i], power);
                const double exact = (std::pow(0.3, power + 1) - std::pow(-0.05, power + 1)) / (power + 1);
                QVERIFY2(std::abs(sum - exact) < 1e-13, qPrintable(QString::number(sum - exact)));
            }
        }
    }

    /// One step of unequal steps from the exact past: result and interpolant are of order k + 1 (an error of
    /// h^(k + 2)), the estimate is of order k.
    void orders_data() {
        QTest::addColumn<int>("order");
        for (int order = 1; order <= AdamsMethod<2>::kHighestOrder; ++order)
            QTest::addRow("%d", order) << order;
    }
    void orders() {
        QFETCH(int, order);
        const std::vector<double> steps = {0.02, 0.014, 0.01, 0.007};
        std::vector<double> result, inside, estimate;
        for (const double h : steps) {
            AdamsMethod<2> method(1);
            Pace<2> pace = pastOf(order, h);
            const auto stages = makeHostStages<2>();
            QVERIFY(method.attempt(Known::f, *stages, kStart, kStart + h, nodal(Known::exact(kStart)), pace));
            result.push_back(distance(*method.result(), Known::exact(kStart + h)));
            inside.push_back(distance(method.at(kStart + 0.4 * h, {}), Known::exact(kStart + 0.4 * h)));
            estimate.push_back(method.error());
            QVERIFY(distance(method.at(kStart + h, {}), *method.result()) < 1e-14);
            QVERIFY(distance(method.at(kStart, {}), Known::exact(kStart)) < 1e-14);
            QVERIFY(!method.needsEndField());
        }
        const auto near = [](double measured, double expected) {
            return std::abs(measured - expected) < 0.3;
        };
        QVERIFY2(near(slope(steps, result), order + 2), qPrintable(QString::number(slope(steps, result))));
        QVERIFY2(near(slope(steps, inside), order + 2), qPrintable(QString::number(slope(steps, inside))));
        QVERIFY2(near(slope(steps, estimate), order + 1),
                 qPrintable(QString::number(slope(steps, estimate))));
    }

    /// The method starts itself from order 1: the error falls with the tolerance, for little more work.
    void errorFollowsTheTolerance() {
        std::vector<double> tolerances, errors, work;
        for (double tolerance = 1e-3; tolerance > 1e-9; tolerance /= 10) {
            const Run run = runTo(2, tolerance);
            QVERIFY2(run.error < 20 * tolerance, qPrintable(QString::number(run.error)));
            QVERIFY(run.rejected <= run.evaluations / 5);
            tolerances.push_back(tolerance);
            errors.push_back(run.error);
            work.push_back(run.evaluations);
        }
        QVERIFY2(std::abs(slope(tolerances, errors) - 1) < 0.25,
                 qPrintable(QString::number(slope(tolerances, errors))));
        // A method of order 5 needs 10^(1/5) times the steps for a tenth of the error, one of order 2
        // 10^(1/2).
        QVERIFY2(slope(tolerances, work) > -0.25, qPrintable(QString::number(slope(tolerances, work))));
        QCOMPARE(runTo(2, 1e-6).highest, AdamsMethod<2>::kHighestOrder);
    }

    /// The right-hand side jumps at both ends of the interval: only the values inside it count.
    void jumpsAtTheEndsAreSeenFromInside() {
        const auto f = [](double t, Side side, StageVectors<2>& at, Field& v) {
            const bool inside = (t > 1 || side == Side::After) && (t < 2 || side == Side::Before);
            v = Field::Constant(2, at.shape()->cols(), inside ? 3 : 1e6);
            return true;
        };
        AdamsMethod<2> method(1e-3);
        Pace<2> pace;
        const auto stages = makeHostStages<2>();
        QVERIFY(method.attempt(f, *stages, 1, 2, nodal(Field::Zero(2, 1)), pace));
        QVERIFY(std::abs((*method.result())(0, 0) - 3) < 1e-13);
        QVERIFY(method.error() < 1e-9);
    }

    /// After a rejected step a shorter one starts from the same past.
    void triesAgainWithLess() {
        AdamsMethod<2> method(1e-9);
        Pace<2> pace = pastOf(3, 0.3);
        const Pace<2> before = pace;
        const auto stages = makeHostStages<2>();
        const Nodal<2> start = nodal(Known::exact(kStart));
        QVERIFY(method.attempt(Known::f, *stages, kStart, kStart + 0.3, start, pace));
        QVERIFY(method.error() > 1);
        method.retry(pace);
        QVERIFY(pace.step > 0 && pace.step < 0.3);
        QVERIFY(pace.order == 3 || pace.order == 2);
        QCOMPARE(pace.fields.size(), before.fields.size());
        for (std::size_t i = 0; i < pace.fields.size(); ++i)
            QCOMPARE(pace.fields[i].field, before.fields[i].field);
        const auto fails = [](double, Side, StageVectors<2>&, Field&) { return false; };
        QVERIFY(!method.attempt(fails, *stages, kStart, kStart + 0.1, start, pace));
    }
};

QTEST_APPLESS_MAIN(TestAdams)
#include "test_adams.moc"
