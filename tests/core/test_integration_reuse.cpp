// Integration with factors and guesses carried from step to step: as accurate as without, and the same bits
// however a run is cut into pieces, by states, questions, cancellations and other deformers.
#include <QTest>
#include <cmath>

#include "tests/core/test_strip.h"

using namespace wend;
using samples::Bend;
using samples::distance;
using samples::runTo;

namespace {

template <int Dim>
bool identical(const Points<Dim>& a, const Points<Dim>& b) {
    return a.cols() == b.cols() && (a.array() == b.array()).all();
}

IntegrationOptions optionsFor(Method method, double tolerance) {
    IntegrationOptions options;
    options.method = method;
    options.tolerance = tolerance;
    if (!isAdaptive(method)) options.steps = 8;
    return options;
}

/// Returns a rotation, then hardly any motion, then a sudden fast one, so that steps are rejected.
template <int Dim>
Bend<Dim> jerkyBend(double phi = phi::kMetr) {
    Bend<Dim> bend(Dim == 2 ? 24 : 12, Dim == 2 ? 6 : 3, 4, 1.2, phi);
    bend.handles[1].motions[0].end = 0.6;
    const auto point = [](double x, double y) {
        Vec<Dim> p = Vec<Dim>::Zero();
        p[0] = x, p[1] = y;
        return p;
    };
    Motion<Dim> curve{CurveMotion<Dim>{Interpolation::Bezier,
                                       {point(0, 0), point(0, 0.001), point(0, 0.002), point(0, 0.003),
                                        point(0, 0.004), point(0.4, 2), point(-1, 0.8)}}};
    curve.start = 0.6, curve.end = 1;
    bend.handles[1].motions.push_back(curve);
    return bend;
}

}  // namespace

class TestIntegrationReuse : public QObject {
    Q_OBJECT

    void methods() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<int>("method");
        for (const int dim : {2, 3}) {
            QTest::addRow("Dormand-Prince %dD", dim) << dim << int(Method::DormandPrince);
            QTest::addRow("Adams %dD", dim) << dim << int(Method::Adams);
            QTest::addRow("Runge-Kutta 4 %dD", dim) << dim << int(Method::RungeKutta4);
        }
    }

    /// The result is compared with one at a far smaller tolerance, and with direct solves in the same method.
    template <int Dim>
    void staysWithinTolerance(Method method, double phi) {
        const Bend<Dim> bend(Dim == 2 ? 24 : 12, Dim == 2 ? 6 : 3, 4, 2, phi);
        IntegrationOptions options = optionsFor(method, 1e-4), direct = options;
        direct.velocityTolerance = 0;
        Deformer<Dim> reusing = bend.deformer(options), factorizing = bend.deformer(direct);
        const double diagonal = boundingBoxDiagonal<Dim>(bend.mesh->points);
        const double difference = distance(runTo(reusing, 1), runTo(factorizing, 1)) / diagonal;
        QVERIFY2(difference <= 1e-4, qPrintable(QString::number(difference)));
        QVERIFY(difference > 0);
        QVERIFY(reusing.statistics().factorizations < reusing.statistics().evaluations / 2 + 3);
        QCOMPARE(factorizing.statistics().factorizations, factorizing.statistics().evaluations);
        QVERIFY(reusing.statistics().constraintError <= 1e-12);
    }

    template <int Dim>
    void goesOnFromEveryState(Method method) {
        const Bend<Dim> bend = jerkyBend<Dim>();
        const IntegrationOptions options = optionsFor(method, 1e-5);
        Deformer<Dim> whole = bend.deformer(options);
        std::vector<State<Dim>> states = {whole.state()};
        std::vector<int> rejections = {0};
        typename Deformer<Dim>::Watch watch;
        watch.progress = [&](double) {
            states.push_back(whole.state());
            rejections.push_back(whole.statistics().rejected);
        };
        const Points<Dim> expected = runTo(whole, 1, watch);
        QVERIFY(states.size() > 6);
        QVERIFY(whole.statistics().factorizations < whole.statistics().evaluations);
        if (isAdaptive(method)) QVERIFY(rejections.back() > 0);
        Deformer<Dim> other = bend.deformer(options);  // goes to and fro: what it did before must not matter
        for (size_t i = 0; i < states.size(); i += (i + 7 < states.size() ? 2 : 1)) {
            Deformer<Dim> resumed = bend.deformer(options);
            resumed.restore(states[i]);
            QVERIFY(identical(runTo(resumed, 1), expected));
            other.restore(states[states.size() - 1 - i]);
            QVERIFY(identical(runTo(other, 1), expected));
        }
    }

    /// Cancelling in the middle of a step, evaluating its velocity and writing frames change nothing.
    template <int Dim>
    void questionsChangeNothing(Method method) {
        const Bend<Dim> bend = jerkyBend<Dim>();
        const IntegrationOptions options = optionsFor(method, 1e-5);
        Deformer<Dim> whole = bend.deformer(options), disturbed = bend.deformer(options);
        const Points<Dim> expected = runTo(whole, 1);
        for (int pieces = 0; disturbed.state().time < 1; ++pieces) {
            QVERIFY(pieces < 1000);
            std::stop_source source;
            typename Deformer<Dim>::Watch watch;
            for (int i = 0; i < 50; ++i)
                if (i / 50.0 >= disturbed.state().time) watch.frames.push_back(i / 50.0);
            int steps = 0;
            watch.onFrame = [](const State<Dim>&) {};
            watch.progress = [&](double) {
                if (++steps == 2) source.request_stop();
            };
            watch.stop = source.get_token();
            disturbed.advance(1, watch);
            QVERIFY(disturbed.velocity().cols() > 0);
        }
        QVERIFY(identical(disturbed.state().points, expected));
    }

    /// There are as many unknowns as two threads need.
    template <int Dim>
    void threadsChangeNothing(Method method) {
        const Bend<Dim> bend(Dim == 2 ? 144 : 60, Dim == 2 ? 36 : 7, 4, 0.5);
        QVERIFY(Dim * bend.mesh->vertexCount() > 10000);
        Points<Dim> expected;
        for (const int threads : {1, 2, 3}) {
            IntegrationOptions options = optionsFor(method, 1e-3);
            if (options.steps > 0) options.steps = 2;
            options.threads = threads;
            Deformer<Dim> deformer = bend.deformer(options);
            const Points<Dim> end = runTo(deformer, 1);
            QVERIFY(deformer.deviceName().starts_with(std::to_string(threads)));
            if (threads == 1) expected = end;
            QVERIFY(identical(end, expected));
        }
    }

  private slots:
    void staysWithinTolerance_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<int>("method");
        QTest::addColumn<double>("phi");
        for (const int dim : {2, 3})
            for (const Method method : {Method::DormandPrince, Method::Adams, Method::RungeKutta4}) {
                QTest::addRow("metr %dD %d", dim, int(method)) << dim << int(method) << phi::kMetr;
                QTest::addRow("akvf %dD %d", dim, int(method)) << dim << int(method) << phi::kAkvf;
                QTest::addRow("conf %dD %d", dim, int(method)) << dim << int(method) << phi::conformal(dim);
            }
    }
    void staysWithinTolerance() {
        QFETCH(int, dim);
        QFETCH(int, method);
        QFETCH(double, phi);
        dim == 2 ? staysWithinTolerance<2>(Method(method), phi)
                 : staysWithinTolerance<3>(Method(method), phi);
    }
    void goesOnFromEveryState_data() { methods(); }
    void goesOnFromEveryState() {
        QFETCH(int, dim);
        QFETCH(int, method);
        dim == 2 ? goesOnFromEveryState<2>(Method(method)) : goesOnFromEveryState<3>(Method(method));
    }
    void questionsChangeNothing_data() { methods(); }
    void questionsChangeNothing() {
        QFETCH(int, dim);
        QFETCH(int, method);
        dim == 2 ? questionsChangeNothing<2>(Method(method)) : questionsChangeNothing<3>(Method(method));
    }
    void threadsChangeNothing_data() { methods(); }
    void threadsChangeNothing() {
        QFETCH(int, dim);
        QFETCH(int, method);
        dim == 2 ? threadsChangeNothing<2>(Method(method)) : threadsChangeNothing<3>(Method(method));
    }

    void equiaFactorizesAlways() {
        for (const Method method : {Method::DormandPrince, Method::Adams}) {
            const Bend<2> bend(16, 4, 4, 0.5, phi::kEquia);
            Deformer<2> deformer = bend.deformer(optionsFor(method, 1e-3));
            runTo(deformer, 1);
            QCOMPARE(deformer.statistics().factorizations, deformer.statistics().evaluations);
        }
    }
};

QTEST_APPLESS_MAIN(TestIntegrationReuse)
#include "test_integration_reuse.moc"
