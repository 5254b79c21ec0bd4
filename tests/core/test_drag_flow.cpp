// The preview of a drag against the exact integration of the same path.
#include <QTest>
#include <cmath>
#include <limits>

#include "core/assembly/cpu_back_end.h"
#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "core/integration/drag_flow.h"
#include "tests/core/test_strip.h"

using namespace wend;
using samples::Bend;
using samples::distance;

namespace {

template <int Dim>
DragFlow<Dim> flowOf(const Bend<Dim>& bend) {
    return DragFlow<Dim>(bend.mesh, bend.material, bend.handles, makeCpuBackEnd<Dim>);
}

template <int Dim>
Motion<Dim> shift(double x, double y) {
    Translate<Dim> translate;
    translate.by[0] = x, translate.by[1] = y;
    return {translate};
}

/// Returns a wavy path of 60 samples, like that of a pointer.
template <int Dim>
std::vector<Motion<Dim>> wavyWay() {
    std::vector<Motion<Dim>> way;
    const auto at = [](int i) { return std::array{-0.9 * std::pow(i / 60.0, 2), 1.2 * std::sin(0.04 * i)}; };
    for (int i = 0; i < 60; ++i) way.push_back(shift<Dim>(at(i + 1)[0] - at(i)[0], at(i + 1)[1] - at(i)[1]));
    return way;
}

/// A fully elastic strip of length 4 and height 1, held at two points near its left end; handle 1 is a point
/// near the right end.
struct ElasticStrip {
    std::shared_ptr<const SimplicialMesh<2>> mesh;
    DragFlow<2> flow;

    explicit ElasticStrip(int across)
        : mesh(std::make_shared<const SimplicialMesh<2>>(samples::strip<2>(4 * across, across, 4))),
          flow(mesh, elastic(mesh->cellCount()), handles(), makeCpuBackEnd<2>) {}

    static std::shared_ptr<const Material<2>> elastic(int cells) {
        auto material = Material<2>::uniform(cells, phi::kMetr);
        material.memory = std::numeric_limits<double>::infinity();
        return std::make_shared<const Material<2>>(material);
    }
    static std::vector<Handle<2>> handles() {
        Handle<2> left, right;
        left.name = "left", left.at = std::vector<Vec2>{{0.2, 0.5}, {0.2, 0.8}};
        right.name = "right", right.at = std::vector<Vec2>{{3.7, 0.5}};
        return {left, right};
    }
};

}  // namespace

class TestDragFlow : public QObject {
    Q_OBJECT

    template <int Dim>
    void followsTheExactMotion(double phi) {
        Bend<Dim> bend(Dim == 2 ? 24 : 12, Dim == 2 ? 6 : 3, 4, 0, phi);
        auto flow = flowOf(bend);
        std::vector<Motion<Dim>> way = wavyWay<Dim>();
        for (const Motion<Dim>& motion : way) QCOMPARE(flow.lead({1}, motion).done, 1.0);
        // One field a sample; a few more while the directions are new.
        QVERIFY2(flow.evaluations() <= 66, qPrintable(QString::number(flow.evaluations())));
        QVERIFY(flow.constraintError() < 1e-12);
        for (size_t i = 0; i < way.size(); ++i)
            way[i].start = double(i) / way.size(), way[i].end = double(i + 1) / way.size();
        bend.handles[1].motions = way;
        IntegrationOptions options;
        options.method = Method::RungeKutta4;
        options.steps = 60;
        options.velocityTolerance = 0;
        Deformer<Dim> exact = bend.deformer(options);
        QCOMPARE(exact.advance(1).outcome, Outcome::Done);
        const double error =
            distance(flow.pose(), exact.state().points) / boundingBoxDiagonal<Dim>(bend.mesh->points);
        // The error is the fields' tolerance of 1e-3 over a path of 0.4 diagonals.
        QVERIFY2(error < 4e-4, qPrintable(QString::number(error)));
        QVERIFY(distance(flow.pose(), bend.mesh->points) > 0.5);
    }

    /// The gradient of the memory acts during a drag as in the exact motion: its effect on the shape is much
    /// larger than the error of the preview.
    template <int Dim>
    void remembersWhileDragging() {
        Bend<Dim> bend(Dim == 2 ? 24 : 12, Dim == 2 ? 6 : 3, 4, 0);
        std::vector<Motion<Dim>> way = wavyWay<Dim>();
        const auto dragged = [&] {
            auto flow = flowOf(bend);
            for (const Motion<Dim>& motion : way) flow.lead({1}, motion);
            return Points<Dim>(flow.pose());
        };
        const Points<Dim> forgetful = dragged();
        Material<Dim> material = *bend.material;
        material.memory = 10;
        bend.material = std::make_shared<const Material<Dim>>(material);
        const Points<Dim> remembering = dragged();
        for (std::size_t i = 0; i < way.size(); ++i)
            way[i].start = double(i) / way.size(), way[i].end = double(i + 1) / way.size();
        bend.handles[1].motions = way;
        IntegrationOptions options;
        options.tolerance = 1e-6;
        Deformer<Dim> exact = bend.deformer(options);
        QCOMPARE(exact.advance(1).outcome, Outcome::Done);
        const double missed = distance(remembering, exact.state().points),
                     made = distance(remembering, forgetful);
        qInfo("missed %.2e, made %.2e", missed, made);
        QVERIFY(missed < 4e-4 * boundingBoxDiagonal<Dim>(bend.mesh->points));
        QVERIFY(made > 10 * missed);
    }

    /// The error is of second order in the length of the samples: a rotation in 10, 20, 40.
    template <int Dim>
    void isOfSecondOrder() {
        // Near EQUIA every field is exact.
        Bend<Dim> bend(8, 3, 4, 1, std::atan(1.0 / 25));
        IntegrationOptions options;
        options.tolerance = 1e-9;
        Deformer<Dim> exact = bend.deformer(options);
        exact.advance(1);
        std::vector<double> errors;
        for (const int samples : {10, 20, 40}) {
            auto flow = flowOf(bend);
            Motion<Dim> turn = bend.handles[1].motions[0];
            std::get<Rotate<Dim>>(turn.kind).angle /= samples;
            for (int i = 0; i < samples; ++i) QCOMPARE(flow.lead({1}, turn).done, 1.0);
            errors.push_back(distance(flow.pose(), exact.state().points));
            QVERIFY(flow.statistics().factorizations >= samples);
        }
        const double order = std::log2(errors[0] / errors[2]) / 2;
        QVERIFY2(order > 1.7, qPrintable(QString::number(order)));
    }

    /// A drag towards the held end stops before it, reports that, and comes back.
    template <int Dim>
    void stopsBeforeCellsFold() {
        const Bend<Dim> bend(8, 2, 2, 0);
        auto flow = flowOf(bend);
        double gone = 0;
        typename DragFlow<Dim>::Led led;
        for (int i = 0; i < 60 && led.done == 1; ++i) {
            led = flow.lead({1}, shift<Dim>(-0.05, 0));
            gone += 0.05 * led.done;
        }
        QVERIFY(led.done < 1 && gone > 1 && gone < 2);
        QVERIFY2(led.problem.text().find("would fold over") != std::string::npos, led.problem.text().c_str());
        QCOMPARE(distortion<Dim>(*bend.mesh, flow.pose()).flips, 0);
        QVERIFY(flow.constraintError() < 1e-12);
        const int tip = bend.mesh->vertexCount() - 1;
        QVERIFY(std::abs(flow.pose()(0, tip) - 2 + gone) < 1e-12);
        QCOMPARE(flow.lead({1}, shift<Dim>(0.05, 0)).done, 1.0);
    }

    template <int Dim>
    void beginsAnywhere() {
        const Bend<Dim> bend(8, 2, 4, 0);
        auto flow = flowOf(bend), other = flowOf(bend);
        QVERIFY(flow.pose() == bend.mesh->points);
        flow.lead({1}, shift<Dim>(0, 0.1));
        const Points<Dim> pose = flow.pose();
        other.begin(pose);
        QVERIFY(other.pose() == pose);
        flow.lead({0, 1}, shift<Dim>(0.3, 0.2));  // all handles: a translation
        Vec<Dim> by = Vec<Dim>::Zero();
        by[0] = 0.3, by[1] = 0.2;
        QVERIFY(distance(flow.pose(), Points<Dim>(pose.colwise() + by)) < 1e-3);
        flow.begin(bend.mesh->points);
        QVERIFY(flow.pose() == bend.mesh->points);
        QCOMPARE(flow.lead({}, shift<Dim>(1, 0)).done, 1.0);
        QVERIFY(flow.pose() == bend.mesh->points);
        QVERIFY_THROWS_EXCEPTION(InputError, flow.begin(Points<Dim>(Dim, 3)));
    }

    /// A drag that begins where the last one ended extrapolates its motion; far from there it starts from a
    /// zero guess.
    template <int Dim>
    void goesOnWithTheLastFields() {
        const Bend<Dim> bend(16, 4, 4, 0);
        auto flow = flowOf(bend);
        const auto fieldsOf = [&](const Points<Dim>& pose) {
            flow.begin(pose);
            const int before = flow.evaluations();
            if (flow.lead({1}, shift<Dim>(0, 0.02)).done < 1) return -1;
            return flow.evaluations() - before;
        };
        QCOMPARE(fieldsOf(bend.mesh->points), 2);
        const Points<Dim> start = flow.pose();
        QCOMPARE(fieldsOf(start), 1);
        for (int i = 0; i < 60; ++i) flow.lead({1}, shift<Dim>(-0.01, 0.02));
        QCOMPARE(fieldsOf(start), 2);
    }

    /// A fully elastic shape is rigid where nothing else holds it: a pin moves it without a rotation, from
    /// any place and by any distance in one step.
    template <int Dim>
    void lonePinsCarryTheShape() {
        for (const double phi : {phi::kMetr, phi::conformal(Dim)}) {
            Bend<Dim> bend(Dim == 2 ? 24 : 12, Dim == 2 ? 6 : 3, 4, 0, phi);
            Material<Dim> material = *bend.material;
            material.memory = std::numeric_limits<double>::infinity();
            bend.material = std::make_shared<const Material<Dim>>(material);
            bend.handles.resize(1);
            bend.handles[0].at = std::vector<Vec<Dim>>{Vec<Dim>::Constant(0.3)};  // near an end
            auto flow = flowOf(bend);
            Vec<Dim> by = Vec<Dim>::Zero();
            for (const auto& [x, y] : {std::pair{0.1, 0.05}, {2.0, 1.5}, {-1.0, 3.0}, {0.02, -0.04}}) {
                QCOMPARE(flow.lead({0}, shift<Dim>(x, y)).done, 1.0);
                by[0] += x, by[1] += y;
                QVERIFY(distance(flow.pose(), bend.mesh->points.colwise() + by) < 1e-9);
            }
        }
    }

  private slots:
    /// Where long steps would invert cells, a long displacement takes many short ones, and arrives.
    void longDisplacementsOfElasticShapesArrive() {
        for (const double by : {-0.45, -0.315}) {
            ElasticStrip strip(20);
            for (int i = 0; i < 6; ++i) {
                const auto led = strip.flow.lead({1}, shift<2>(2 * by, i % 2 == 0 ? 0.45 : 0.225));
                QVERIFY2(led.done == 1,
                         qPrintable(QString("%1: %2 of jump %3").arg(by).arg(led.done).arg(i)));
            }
            QCOMPARE(distortion<2>(*strip.mesh, strip.flow.pose()).flips, 0);
        }
    }
    /// The first step of a bent pose that nothing holds so contains its whole way back to rest.
    void elasticShapesSettleBeforeTheyStop() {
        ElasticStrip strip(10);
        Points<2> pose = strip.mesh->points;
        for (int v = 0; v < strip.mesh->vertexCount(); ++v) {
            pose(0, v) *= 0.6;
            pose(1, v) += 0.5 * std::sin(0.785 * strip.mesh->points(0, v));
        }
        strip.flow.begin(pose);
        QCOMPARE(strip.flow.lead({1}, shift<2>(0.01, 0)).done, 1.0);
        QCOMPARE(distortion<2>(*strip.mesh, strip.flow.pose()).flips, 0);
    }
    void lonePinsCarryTheShape2() { lonePinsCarryTheShape<2>(); }
    void lonePinsCarryTheShape3() { lonePinsCarryTheShape<3>(); }
    /// A pause of a second would be visible: the factor of a large solid is reused as long as it works at
    /// all.
    void expensiveFactorsAreReused() {
        const Bend<3> bend(40, 12, 4, 0);
        auto flow = flowOf(bend);
        QCOMPARE(flow.statistics().factorizations, 1);
        for (const Motion<3>& motion : wavyWay<3>()) QCOMPARE(flow.lead({1}, motion).done, 1.0);
        QVERIFY2(flow.statistics().factorizations <= 2,
                 qPrintable(QString::number(flow.statistics().factorizations)));
        QCOMPARE(distortion<3>(*bend.mesh, flow.pose()).flips, 0);
        QVERIFY(flow.constraintError() < 1e-12);
    }
    void followsTheExactMotion_data() {
        QTest::addColumn<int>("dim");
        QTest::addColumn<double>("phi");
        for (const int dim : {2, 3}) {
            QTest::addRow("metr %dD", dim) << dim << phi::kMetr;
            QTest::addRow("akvf %dD", dim) << dim << phi::kAkvf;
            QTest::addRow("conf %dD", dim) << dim << phi::conformal(dim);
        }
    }
    void followsTheExactMotion() {
        QFETCH(int, dim);
        QFETCH(double, phi);
        dim == 2 ? followsTheExactMotion<2>(phi) : followsTheExactMotion<3>(phi);
    }
    void remembersWhileDragging2() { remembersWhileDragging<2>(); }
    void remembersWhileDragging3() { remembersWhileDragging<3>(); }
    void isOfSecondOrder2() { isOfSecondOrder<2>(); }
    void isOfSecondOrder3() { isOfSecondOrder<3>(); }
    void stopsBeforeCellsFold2() { stopsBeforeCellsFold<2>(); }
    void stopsBeforeCellsFold3() { stopsBeforeCellsFold<3>(); }
    void beginsAnywhere2() { beginsAnywhere<2>(); }
    void beginsAnywhere3() { beginsAnywhere<3>(); }
    void goesOnWithTheLastFields2() { goesOnWithTheLastFields<2>(); }
    void goesOnWithTheLastFields3() { goesOnWithTheLastFields<3>(); }
};

QTEST_APPLESS_MAIN(TestDragFlow)
#include "test_drag_flow.moc"
