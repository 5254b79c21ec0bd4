// Deformations that cannot be completed: the messages, and the shape at the stop.

#include <Eigen/Geometry>
#include <QRegularExpression>
#include <QTest>
#include <cstdlib>

#include "core/base/number_text.h"
#include "core/energy/distortion.h"
#include "core/integration/stop_message.h"
#include "core/mesh/quality.h"
#include "core/motion/constraints.h"
#include "tests/core/test_strip.h"

using namespace wend;

namespace {

/// A strip between a wall, which is held, and a ram, which moves; a clamp, which is held too, is farther
/// away.
template <int Dim>
struct Press {
    SimplicialMesh<Dim> mesh = samples::strip<Dim>(8, 2, 4);
    double phi = phi::kMetr;
    std::vector<Motion<Dim>> motions;
    IntegrationOptions options;

    explicit Press(const Vec<Dim>& by) { motions = {Motion<Dim>{Translate<Dim>{by}}}; }

    std::vector<Handle<Dim>> handles() const {
        std::vector<Handle<Dim>> all{samples::Bend<Dim>::at("wall", -1, 0.1),
                                     samples::Bend<Dim>::at("ram", 3.9, 5)};
        all[1].motions = motions;
        return all;
    }
    Deformer<Dim> deformer() const {
        const auto rest = std::make_shared<const SimplicialMesh<Dim>>(mesh);
        const auto material =
            std::make_shared<const Material<Dim>>(Material<Dim>::uniform(mesh.cellCount(), phi));
        return Deformer<Dim>(rest, material, handles(), options);
    }
};

template <int Dim>
Vec<Dim> along(double x) {
    return x * Vec<Dim>::Unit(0);
}

/// Sums products of the coordinates as they are, in a format that does not round them, as another program may
/// compute with the numbers in a file.
template <int Dim>
bool isPositiveElsewhere(const Points<Dim>& points, const Cell<Dim>& cell) {
    for (int first = 0; first <= Dim; ++first) {
        Eigen::Matrix<long double, Dim, Dim> edges;
        for (int k = 0; k < Dim; ++k)
            edges.col(k) = (points.col(cell[(first + k + 1) % (Dim + 1)]) - points.col(cell[first]))
                               .template cast<long double>();
        const bool odd = Dim == 3 && first % 2 == 1;
        if (!((odd ? -1 : 1) * edges.determinant() > 0)) return false;
    }
    return !isFlat<Dim>(points, cell);
}

/// Converts through a text with 17 digits.
template <int Dim>
Points<Dim> readAgain(const Points<Dim>& points) {
    Points<Dim> read(Dim, points.cols());
    for (Eigen::Index k = 0; k < points.size(); ++k) {
        std::string text;
        appendNumber(text, points.data()[k]);
        read.data()[k] = std::strtod(text.c_str(), nullptr);
    }
    return read;
}

template <int Dim>
int invertedElsewhere(const SimplicialMesh<Dim>& mesh, const Points<Dim>& points) {
    const Points<Dim> read = readAgain<Dim>(points);
    int count = 0;
    for (const Cell<Dim>& cell : mesh.cells) count += !isPositiveElsewhere<Dim>(read, cell);
    return count;
}

}  // namespace

class TestStops : public QObject {
    Q_OBJECT

    /// Returns the place that a message names.
    template <int Dim>
    static Vec<Dim> placeIn(const QString& message) {
        const auto match = QRegularExpression("near \\(([^)]*)\\)").match(message);
        const QStringList numbers = match.captured(1).split(", ");
        Vec<Dim> place = Vec<Dim>::Constant(NAN);
        for (int a = 0; a < Dim && numbers.size() == Dim; ++a) place[a] = numbers[a].toDouble();
        return place;
    }

    template <int Dim>
    void told(const Press<Dim>& press, Outcome outcome, const char* what) {
        Deformer<Dim> deformer = press.deformer();
        const AdvanceResult result = deformer.advance(1);
        const QString message = QString::fromStdString(result.message);
        QVERIFY2(result.outcome == outcome, qPrintable(message));
        QVERIFY2(message.startsWith(QString("at time %1 handle \"ram\" cannot go on: ").arg(result.time)),
                 qPrintable(message));
        QVERIFY2(message.contains(what) && message.contains("; "), qPrintable(message));
        QVERIFY2(!message.contains('\n'), qPrintable(message));
        const QString brief = QString::fromStdString(result.brief);
        QVERIFY2(brief.startsWith("handle \"ram\" cannot go on: ") && brief.contains(what),
                 qPrintable(brief));
        QVERIFY2(!brief.contains("cell"), qPrintable(brief));
        QVERIFY2((placeIn<Dim>(brief) - placeIn<Dim>(message)).cwiseAbs().maxCoeff() <= 5.1e-3,
                 qPrintable(brief));
        QCOMPARE(result.cell >= 0, outcome == Outcome::CellInverted);
        const Points<Dim>& pose = deformer.state().points;
        const Vec<Dim> place = placeIn<Dim>(message), slack = Vec<Dim>::Constant(1e-4);
        QVERIFY2(((place - pose.rowwise().minCoeff() + slack).array() >= 0).all() &&
                     ((pose.rowwise().maxCoeff() - place + slack).array() >= 0).all(),
                 qPrintable(message));
        QCOMPARE(invertedElsewhere<Dim>(press.mesh, pose), 0);
    }

    template <int Dim>
    void everyReasonIsReported() {
        const QString row = QTest::currentDataTag();
        Press<Dim> press(along<Dim>(-6));
        if (row == "folds") return told<Dim>(press, Outcome::CellInverted, "would fold over near");
        if (row == "folds with fixed steps") {
            press.options.method = Method::RungeKutta4;
            press.options.steps = 20;
            return told<Dim>(press, Outcome::CellInverted, "would fold over near");
        }
        if (row == "too fast") {
            press = Press<Dim>(1e7 * Vec<Dim>::Unit(1));
            return told<Dim>(press, Outcome::StepTooSmall, "too fast near");
        }
        if (row == "overflows") {
            press = Press<Dim>(1e300 * Vec<Dim>::Unit(1));
            return told<Dim>(press, Outcome::StepTooSmall, "too fast near");
        }
        if (row == "overflows with fixed steps") {
            press = Press<Dim>(1e308 * Vec<Dim>::Unit(1));
            press.motions[0].end = 1e-4;
            press.options.method = Method::Midpoint;
            press.options.steps = 4;
            return told<Dim>(press, Outcome::SolverFailed, "numbers overflow");
        }
        if (row == "singular") {
            for (Eigen::Index v = 0; v < press.mesh.points.cols(); ++v) press.mesh.points(Dim - 1, v) *= 1e-9;
            return told<Dim>(press, Outcome::SolverFailed, "no velocity can be computed");
        }
        Deformer<Dim> deformer = press.deformer();
        if (row == "cancelled") {
            std::stop_source source;
            source.request_stop();
            typename Deformer<Dim>::Watch watch;
            watch.stop = source.get_token();
            const AdvanceResult result = deformer.advance(1, watch);
            QVERIFY(result.outcome == Outcome::Cancelled && result.message == "at time 0 cancelled");
        } else {
            const AdvanceResult result = deformer.advance(0.25);
            QVERIFY(result.outcome == Outcome::Done && result.message.text().empty());
        }
    }

    /// With multigrid, settling takes explicit steps, which are stiff near EQUIA: if they become too short,
    /// it stops at a good shape with a message. With factors it arrives all the same.
    template <int Dim>
    void settlingSaysThatItIsTooStiff() {
        Press<Dim> press(along<Dim>(-1.2));
        press.phi = phi::kEquia;
        press.options.method = Method::DormandPrince;
        press.options.tolerance = 1e-6;
        press.options.smallestStep = 0.033;  // the first one is 1/30 of the window
        press.options.settle = {{1, 2}};
        press.options.end = 2;
        Deformer<Dim> direct = press.deformer();
        QCOMPARE(direct.advance(2).outcome, Outcome::Done);
        QVERIFY(direct.restForce() < 1e-12);
        press.options.solver = SolverKind::Multigrid;
        Deformer<Dim> deformer = press.deformer();
        const AdvanceResult moved = deformer.advance(1);
        QVERIFY2(moved.outcome == Outcome::Done, moved.message.text().c_str());
        const AdvanceResult result = deformer.advance(2);
        const QString message = QString::fromStdString(result.message);
        QVERIFY2(result.outcome == Outcome::StepTooSmall, qPrintable(message));
        QVERIFY2(message.startsWith(QString("at time %1 the shape is too stiff to settle").arg(result.time)),
                 qPrintable(message));
        QVERIFY(placeIn<Dim>(message).allFinite());
        QVERIFY(result.time >= 1 && result.time < 2);
        QCOMPARE(deformer.state().time, result.time);
        QCOMPARE(invertedElsewhere<Dim>(press.mesh, deformer.state().points), 0);
    }

    /// No last state or frame before it has a cell that is inverted or flat in any arithmetic, whatever stops
    /// the run and wherever the shape is.
    template <int Dim>
    void nothingInvertedIsHandedOut() {
        QFETCH(double, offset);
        QFETCH(double, tolerance);
        QFETCH(int, steps);
        Press<Dim> press(along<Dim>(-6));
        press.mesh.points.colwise() += Vec<Dim>::Constant(offset);
        press.options.tolerance = tolerance;
        press.options.smallestStep = 1e-9;
        press.options.steps = steps;
        press.options.method = steps > 0 ? Method::RungeKutta4 : Method::DormandPrince;
        const auto rest = std::make_shared<const SimplicialMesh<Dim>>(press.mesh);
        const auto material =
            std::make_shared<const Material<Dim>>(Material<Dim>::uniform(press.mesh.cellCount(), phi::kMetr));
        auto handles = press.handles();
        for (auto& handle : handles) {
            std::vector<int> ids;
            for (int v = 0; v < press.mesh.vertexCount(); ++v) {
                const double x = press.mesh.points(0, v) - offset;
                if (handle.name == "wall" ? x < 0.1 : x > 3.9) ids.push_back(v);
            }
            handle.at = ids;
        }
        Deformer<Dim> deformer(rest, material, handles, press.options);
        typename Deformer<Dim>::Watch watch;
        for (int k = 0; k <= 400; ++k) watch.frames.push_back(k / 400.0);
        int bad = 0;
        watch.onFrame = [&](const State<Dim>& state) {
            bad += invertedElsewhere<Dim>(press.mesh, state.points);
        };
        const AdvanceResult result = deformer.advance(1, watch);
        QVERIFY2(result.outcome == Outcome::CellInverted, result.message.text().c_str());
        QCOMPARE(bad, 0);
        QCOMPARE(invertedElsewhere<Dim>(press.mesh, deformer.state().points), 0);
        QVERIFY(distortion<Dim>(press.mesh, deformer.state().points).minDet > 0);
    }

    /// All vertices are moved so that the cells are flat up to rounding at the end, in any orientation.
    template <int Dim>
    void flatToRoundingIsInverted() {
        int inverted = 0, done = 0;
        for (int k = 0; k < 200; ++k) {
            const double size = std::pow(1.05, k - 100), angle = 0.61 * k;
            Mat<Dim> turn = Mat<Dim>::Identity();
            turn.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
            const SimplicialMesh<Dim> straight = samples::strip<Dim>(1, 1, 1);
            SimplicialMesh<Dim> mesh{size * (turn * straight.points), straight.cells};
            mesh.points.colwise() += Vec<Dim>::Constant(0.1 * k);
            Handle<Dim> wall, ram;
            std::vector<int> held, led;
            for (int v = 0; v < mesh.vertexCount(); ++v)
                (straight.points(0, v) < 0.5 ? held : led).push_back(v);
            wall.name = "wall", wall.at = held;
            ram.name = "ram", ram.at = led;
            ram.motions = {Motion<Dim>{Translate<Dim>{-size * turn.col(0)}}};
            IntegrationOptions options;
            options.method = Method::Midpoint;
            options.steps = 4;
            const auto material =
                std::make_shared<const Material<Dim>>(Material<Dim>::uniform(mesh.cellCount(), phi::kMetr));
            Deformer<Dim> deformer(std::make_shared<const SimplicialMesh<Dim>>(mesh), material, {wall, ram},
                                   options);
            done += deformer.advance(1).outcome == Outcome::Done;
            inverted += invertedElsewhere<Dim>(mesh, deformer.state().points);
        }
        QCOMPARE(done, 0);
        QCOMPARE(inverted, 0);
    }

  private slots:
    void placesAreRoughInAWindow() {
        QCOMPARE(roughPlaceName<2>({667.059565, 564.990692}, 300), "(667.1, 565.0)");
        QCOMPARE(roughPlaceName<2>({667.059565, -0.004}, 985), "(667, 0)");
        QCOMPARE(roughPlaceName<2>({1e300, 4e5}, 1e300), "(" + fixedText(1e300, 0) + ", 400000)");
        QCOMPARE(roughPlaceName<3>({0.123456, -1.98765, -1e-9}, 2), "(0.123, -1.988, 0.000)");
        QCOMPARE(roughPlaceName<3>({1.23456e-10, 0, 1}, 1e-10), "(1.23456e-10, 0, 1)");
        QCOMPARE(roughPlaceName<2>({0.5, 2}, 0), "(0.500, 2.000)");
        QCOMPARE(fixedText(0.8728614, 2), "0.87");
        QCOMPARE(fixedText(-0.001, 2), "0.00");
        QCOMPARE(fixedText(NAN, 2), "nan");
    }
    void snapsAreCounted() {
        std::vector<Snap> snaps;
        QVERIFY(snapMessage(snaps, 2).isEmpty() && snapRemark(snaps, 2, 300, 1).isEmpty());
        const auto told = [&] {
            snaps.push_back({0.8728614, {411.49658, 68.4414358, 0}});
            return std::pair(snapMessage(snaps, 2).text(), snapRemark(snaps, 2, 300, 2).text());
        };
        const std::string exactly =
                              "at time 0.8728614 the shape snaps to another equilibrium near (411.49658, "
                              "68.4414358)",
                          roughly = "at 1.75 s the shape jumps to another pose near (411.5, 68.4)";
        for (const char* more : {"", ", and once more", ", and 2 times more"})
            QCOMPARE(told(), std::pair(exactly + more, roughly + more));
        QVERIFY(snapRemark(snaps, 3, 300, 1).text().find("(411.5, 68.4, 0.0)") != std::string::npos);
    }
    void settlingSaysThatItIsTooStiff2() { settlingSaysThatItIsTooStiff<2>(); }
    void settlingSaysThatItIsTooStiff3() { settlingSaysThatItIsTooStiff<3>(); }
    void flatToRoundingIsInverted2() { flatToRoundingIsInverted<2>(); }
    void flatToRoundingIsInverted3() { flatToRoundingIsInverted<3>(); }
    void everyReasonIsReported2_data() { reasons(); }
    void everyReasonIsReported2() { everyReasonIsReported<2>(); }
    void everyReasonIsReported3_data() { reasons(); }
    void everyReasonIsReported3() { everyReasonIsReported<3>(); }
    void nothingInvertedIsHandedOut2_data() { presses(); }
    void nothingInvertedIsHandedOut2() { nothingInvertedIsHandedOut<2>(); }
    void nothingInvertedIsHandedOut3_data() { presses(); }
    void nothingInvertedIsHandedOut3() { nothingInvertedIsHandedOut<3>(); }

  private:
    static void reasons() {
        QTest::addColumn<int>("none");
        for (const char* row : {"folds", "folds with fixed steps", "too fast", "overflows",
                                "overflows with fixed steps", "singular", "cancelled", "done"})
            QTest::newRow(row) << 0;
    }
    static void presses() {
        QTest::addColumn<double>("offset");
        QTest::addColumn<double>("tolerance");
        QTest::addColumn<int>("steps");
        for (const double offset : {0.0, 1e3, 1e6})
            for (const double tolerance : {1e-2, 1e-4})
                QTest::addRow("at %g to %g", offset, tolerance) << offset << tolerance << 0;
        QTest::newRow("fixed steps") << 0.0 << 1e-3 << 30;
        QTest::newRow("fixed steps far away") << 1e6 << 1e-3 << 30;
    }
};

QTEST_GUILESS_MAIN(TestStops)
#include "test_stops.moc"
