// Memory of the rest shape and settling: the energy of the map from rest, its gradient, and their effect on
// the flow, one body for 2D and 3D.
#include <Eigen/Dense>
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/assembly/rest_energy.h"
#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "core/energy/rest_density.h"
#include "core/integration/drag_flow.h"
#include "core/mesh/shape_size.h"
#include "tests/core/test_energy_samples.h"
#include "tests/core/test_strip.h"

using namespace wend;
using namespace wend::test;
using samples::Bend;
using samples::distance;

namespace {

constexpr double kPi = std::numbers::pi;

/// φ all over the range and B: I, a multiple of it, anisotropic.
template <int Dim, typename Body>
void forMaterials(Body&& body) {
    std::mt19937 random(4);
    for (double phi : {phi::kEquia, phi::kMetr, 1.0, phi::kAkvf, 2.2, phi::conformal(Dim)})
        for (const Mat<Dim>& B : {Mat<Dim>(Mat<Dim>::Identity()), Mat<Dim>(3 * Mat<Dim>::Identity()),
                                  randomAnisotropy<Dim>(random, 20)})
            body(EnergyWeights::of(phi), B, random);
}

/// w(I + hJ) = h² e(J) + O(h³); the odd terms cancel in the mean of both signs.
template <int Dim>
void expansionIsTheEnergy() {
    forMaterials<Dim>([](EnergyWeights w, const Mat<Dim>& B, std::mt19937& random) {
        for (int i = 0; i < 5; ++i) {
            const Mat<Dim> J = randomMatrix<Dim, Dim>(random), I = Mat<Dim>::Identity();
            const double e = energyDensity<Dim>(w, B, J), scale = w.q * B.trace() + std::abs(w.r);
            std::array<double, 2> off;
            for (int k : {0, 1}) {
                const double h = k == 0 ? 2e-3 : 1e-3;
                const double mean = restDensity<Dim>(w, B, I + h * J) + restDensity<Dim>(w, B, I - h * J);
                off[k] = std::abs(mean / (2 * h * h) - e);
            }
            QVERIFY(off[1] < 1e-3 * scale);
            QVERIFY(off[1] < 0.3 * off[0] + 1e-8 * scale);  // of order h²
        }
    });
}

template <int Dim>
void stressIsTheDerivative() {
    forMaterials<Dim>([](EnergyWeights w, const Mat<Dim>& B, std::mt19937& random) {
        for (int i = 0; i < 10; ++i) {
            const Mat<Dim> F = Mat<Dim>::Identity() + 0.4 * randomMatrix<Dim, Dim>(random);
            if (F.determinant() < 0.2) continue;
            const Mat<Dim> P = restStress<Dim>(w, B, F);
            const double h = 1e-5;
            for (int a = 0; a < Dim; ++a)
                for (int b = 0; b < Dim; ++b) {
                    Mat<Dim> step = Mat<Dim>::Zero();
                    step(a, b) = h;
                    const double slope =
                        (restDensity<Dim>(w, B, F + step) - restDensity<Dim>(w, B, F - step)) / (2 * h);
                    QVERIFY(std::abs(slope - P(a, b)) < 1e-6 * (P.norm() + B.trace()));
                }
        }
    });
}

/// The second differences of the stress, along single entries of F.
template <int Dim>
void modesAreTheHessian() {
    forMaterials<Dim>([](EnergyWeights w, const Mat<Dim>& B, std::mt19937& random) {
        for (int i = 0; i < 10; ++i) {
            Mat<Dim> F = Mat<Dim>::Identity() + 0.4 * randomMatrix<Dim, Dim>(random);
            if (i == 0) F = 1.2 * polarRotation<Dim>(F);  // equal singular values
            if (F.determinant() < 0.2) continue;
            const auto [values, modes] = restModes<Dim>(w, B, F);
            const auto H = (modes * values.asDiagonal() * modes.transpose()).eval();
            QVERIFY((modes.transpose() * modes - H.Identity()).norm() < 1e-12);
            const double h = 1e-5;
            for (int a = 0; a < Dim * Dim; ++a) {
                Mat<Dim> step = Mat<Dim>::Zero();
                step(a % Dim, a / Dim) = h;
                const Mat<Dim> slope =
                    (restStress<Dim>(w, B, F + step) - restStress<Dim>(w, B, F - step)) / (2 * h);
                for (int b = 0; b < Dim * Dim; ++b)
                    QVERIFY(std::abs(slope(b % Dim, b / Dim) - H(b, a)) < 1e-6 * H.norm());
            }
        }
    });
}

template <int Dim>
void rotationsCostNothing() {
    forMaterials<Dim>([](EnergyWeights w, const Mat<Dim>& B, std::mt19937& random) {
        const Mat<Dim> R = polarRotation<Dim>(Mat<Dim>::Identity() + randomSkew<Dim>(random));
        const Mat<Dim> F = Mat<Dim>::Identity() + 0.2 * randomMatrix<Dim, Dim>(random);
        QVERIFY(restStress<Dim>(w, B, R) == Mat<Dim>::Zero());
        QVERIFY(std::abs(restDensity<Dim>(w, B, R)) < 1e-13 * B.trace());
        QVERIFY(std::abs(restDensity<Dim>(w, B, R * F) - restDensity<Dim>(w, B, F)) <
                1e-12 * (1 + restDensity<Dim>(w, B, F)));
        Mat<Dim> folded = F;
        folded.col(0) *= -1;
        QVERIFY(std::isinf(restDensity<Dim>(w, B, folded)));
    });
}

template <int Dim>
struct Warped {
    SimplicialMesh<Dim> rest;
    Material<Dim> material;
    Points<Dim> shape;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;

    explicit Warped(std::mt19937& random) : rest(unitGrid<Dim>(Dim == 2 ? 5 : 3, 0.15, random)) {
        material = randomMaterial<Dim>(random, rest.cellCount(), {});
        for (std::size_t c = 0; c < rest.cells.size(); c += 2) material.anisotropy[c] = Mat<Dim>::Identity();
        shape = (Mat<Dim>::Identity() + 0.2 * randomMatrix<Dim, Dim>(random)) * rest.points +
                0.03 * randomField<Dim>(random, rest.vertexCount());
        plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, true));
    }
};

template <int Dim>
void gradientIsTheDerivative() {
    std::mt19937 random(5);
    const Warped<Dim> warped(random);
    RestEnergy<Dim> W(warped.plan, warped.rest, warped.material);
    WorkerPool pool(2);
    Points<Dim> gradient;
    W.gradient(warped.shape, gradient, pool);
    for (int i = 0; i < 20; ++i) {
        const Points<Dim> u = randomField<Dim>(random, warped.rest.vertexCount());
        const double h = 1e-6,
                     slope = (W.energy(warped.shape + h * u) - W.energy(warped.shape - h * u)) / (2 * h);
        QVERIFY(std::abs(slope - gradient.cwiseProduct(u).sum()) < 1e-6 * gradient.norm() * u.norm());
    }
    const auto rigid = affineField<Dim>(warped.shape, randomSkew<Dim>(random), Vec<Dim>::Ones());
    QVERIFY(std::abs(gradient.cwiseProduct(rigid).sum()) < 1e-12 * gradient.norm() * rigid.norm());
}

/// E(v) + rate ⟨∇W, v⟩ is stationary on all fields that the constraints allow.
template <int Dim>
void fieldIsTheMinimizer() {
    std::mt19937 random(6);
    const Warped<Dim> warped(random);
    const auto rest = std::make_shared<const SimplicialMesh<Dim>>(warped.rest);
    const auto material = std::make_shared<const Material<Dim>>(warped.material);
    VelocitySolver<Dim> solver(rest, material, BackEndKind::Cpu, 1);
    std::vector<ConstraintRow> rows;
    for (int v = 0; v < Dim + 1; ++v) rows.push_back({{{3 * v, 1.0}}});
    solver.setConstraints(rows);
    const double rate = 4;
    solver.setMemoryRate(rate);
    Points<Dim> v;
    const Points<Dim> prescribed = randomField<Dim>(random, Dim + 1);
    QVERIFY(solver.solve(warped.shape, prescribed, v).done());
    const auto backEnd = makeCpuBackEnd<Dim>(warped.plan, warped.rest, warped.material, 1);
    QCOMPARE(backEnd->setShape(warped.shape), -1);
    RestEnergy<Dim> W(warped.plan, warped.rest, warped.material);
    WorkerPool pool(1);
    Points<Dim> Av, gradient;
    backEnd->apply(v, Av);
    W.gradient(warped.shape, gradient, pool);
    Points<Dim> slope = 2 * Av + rate * gradient;
    const double scale = gradient.norm();
    for (int i = 0; i < Dim + 1; ++i) {
        QVERIFY((v.col(3 * i) - prescribed.col(i)).norm() < 1e-14);
        slope.col(3 * i).setZero();
    }
    QVERIFY(slope.norm() < 1e-9 * scale);
}

IntegrationOptions settling(double from, double to, double tolerance = 1e-4) {
    IntegrationOptions options;
    options.tolerance = tolerance;
    options.settle = {{from, to}};
    options.end = to;
    return options;
}

/// The moves leave the ends alone: W has a minimum here, and its slope is no greater than the force allows.
template <int Dim>
void noMoveLowersEnergy(const Bend<Dim>& bend, Deformer<Dim>& deformer) {
    std::mt19937 random(9);
    const double size = shapeSize<Dim>(bend.mesh->points, bend.mesh->cells).size;
    const SimplicialMesh<Dim> rest{bend.mesh->points / size, bend.mesh->cells};
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, true));
    const RestEnergy<Dim> W(plan, rest, *bend.material);
    const Points<Dim> x = deformer.state().points / size;
    const double here = W.energy(x), force = deformer.restForce(), h = 1e-4;
    QVERIFY(std::abs(here / deformer.restEnergy() - 1) < 1e-9);
    for (int i = 0; i < 20; ++i) {
        Points<Dim> u = randomField<Dim>(random, bend.mesh->vertexCount()) / bend.mesh->vertexCount();
        for (int v = 0; v < bend.mesh->vertexCount(); ++v)
            if (const double along = bend.mesh->points(0, v); along < 1e-9 || along > 4 - 1e-9)
                u.col(v).setZero();
        QVERIFY(W.energy(x + h * u) + W.energy(x - h * u) > 2 * here);
        const auto slope = [&](double by) {
            return (W.energy(x + by * u) - W.energy(x - by * u)) / (2 * by);
        };
        const double extrapolated = (4 * slope(h / 2) - slope(h)) / 3;
        QVERIFY(std::abs(extrapolated) <= 1.01 * force * u.norm() + 1e-9 * here);
    }
}

/// After the interval no admissible move of the vertices lowers W, and nothing flips on the way there.
template <int Dim>
void settledIsStationary(double phi, bool anisotropic) {
    Bend<Dim> bend(Dim == 2 ? 24 : 9, Dim == 2 ? 6 : 3, 4, 1.5, phi);
    if (anisotropic) {
        std::mt19937 random(3);
        Material<Dim> material = *bend.material;
        for (int c = 0; c < bend.mesh->cellCount(); ++c)
            material.anisotropy.push_back(randomAnisotropy<Dim>(random, 5));
        bend.material = std::make_shared<const Material<Dim>>(material);
    }
    auto deformer = bend.deformer(settling(1, 2));
    QCOMPARE(deformer.advance(1).outcome, Outcome::Done);
    const double before = deformer.restEnergy(), force = deformer.restForce();
    QVERIFY(force > 1e-4);
    const AdvanceResult result = deformer.advance(2);
    QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
    QVERIFY(deformer.restEnergy() < before);
    qInfo("%dD, phi %.3f: W %.6f -> %.6f, force %.2e -> %.2e, steps %d, rejected %d", Dim, phi, before,
          deformer.restEnergy(), force, deformer.restForce(), deformer.statistics().steps,
          deformer.statistics().rejected);
    QVERIFY(deformer.restForce() < 2e-3 * force);
    noMoveLowersEnergy<Dim>(bend, deformer);
    QCOMPARE(distortion<Dim>(*bend.mesh, deformer.state().points).flips, 0);
    QVERIFY(deformer.statistics().constraintError < 1e-12);
}

/// A shape that is at rest, or has only been moved rigidly, stays so.
void restStaysAtRest() {
    const Bend<2> bend(12, 4, 3, 0);
    Handle<2> hand = bend.handles[1];
    Rotate<2> rotate;
    rotate.angle = 0.7;
    hand.motions = {{rotate}};
    auto other = bend.handles[0];
    other.motions = {{rotate}};
    Deformer<2> deformer(bend.mesh, bend.material, {other, hand}, settling(1, 2, 1e-8));
    QCOMPARE(deformer.advance(1).outcome, Outcome::Done);
    const Points2 moved = deformer.state().points;
    QCOMPARE(deformer.advance(2).outcome, Outcome::Done);
    QVERIFY(distance(deformer.state().points, moved) < 1e-6);

    Deformer<2> still(bend.mesh, bend.material, {bend.handles[0]}, settling(0, 1));
    QCOMPARE(still.advance(1).outcome, Outcome::Done);
    QVERIFY(still.state().points == bend.mesh->points);
}

/// The whole problem is rotated (not by a right angle), scaled and moved: the result is the same shape,
/// transformed alike.
template <int Dim>
void turnedInputTurnsTheResult(double phi, bool anisotropic) {
    std::mt19937 random(8);
    auto mesh = std::make_shared<SimplicialMesh<Dim>>(samples::strip<Dim>(9, 3, 3));
    Material<Dim> material = Material<Dim>::uniform(mesh->cellCount(), phi);
    material.memory = 4;
    if (anisotropic)
        for (int c = 0; c < mesh->cellCount(); ++c)
            material.anisotropy.push_back(c % 3 == 0 ? Mat<Dim>(Mat<Dim>::Identity())
                                                     : randomAnisotropy<Dim>(random, 10));
    Handle<Dim> left, right, inside;
    left.name = "left", right.name = "right", inside.name = "inside";
    std::array<std::vector<int>, 2> ends;
    for (int v = 0; v < mesh->vertexCount(); ++v)
        for (int side : {0, 1})
            if (std::abs(mesh->points(0, v) - 3 * side) < 1e-9) ends[side].push_back(v);
    Rotate<Dim> rotate;
    rotate.centre[0] = 1.5, rotate.centre[1] = 2;
    rotate.axis[Dim - 1] = 1;
    rotate.angle = 0.8;
    Translate<Dim> translate;
    translate.by[1] = -0.2;
    left.at = ends[0], right.at = ends[1];
    right.motions = {{rotate}};
    inside.at = std::vector<Vec<Dim>>{Vec<Dim>::Constant(0.77)};
    inside.motions = {{translate}};

    const Mat<Dim> Q = polarRotation<Dim>(Mat<Dim>::Identity() + randomSkew<Dim>(random));
    const double scale = 3.7;
    const Vec<Dim> offset = Vec<Dim>::Constant(-30);
    auto turnedMesh = std::make_shared<SimplicialMesh<Dim>>(*mesh);
    turnedMesh->points = (scale * Q * mesh->points).colwise() + offset;
    Material<Dim> turnedMaterial = material;
    for (Mat<Dim>& B : turnedMaterial.anisotropy)
        if (B != Mat<Dim>::Identity()) B = Q * B * Q.transpose();
    Rotate<Dim> turnedRotate = rotate;
    turnedRotate.centre = scale * Q * rotate.centre + offset;
    turnedRotate.axis = Q * rotate.axis;
    Handle<Dim> turnedRight = right, turnedInside = inside;
    turnedRight.motions = {{turnedRotate}};
    turnedInside.at = std::vector<Vec<Dim>>{scale * Q * Vec<Dim>::Constant(0.77) + offset};
    turnedInside.motions = {{Translate<Dim>{scale * Q * translate.by}}};

    IntegrationOptions options = settling(1, 1.3);
    options.velocityTolerance = 0;
    Deformer<Dim> a(mesh, std::make_shared<const Material<Dim>>(material), {left, right, inside}, options),
        b(turnedMesh, std::make_shared<const Material<Dim>>(turnedMaterial),
          {left, turnedRight, turnedInside}, options);
    QCOMPARE(a.advance(1.3).outcome, Outcome::Done);
    QCOMPARE(b.advance(1.3).outcome, Outcome::Done);
    const Points<Dim> expected = (scale * Q * a.state().points).colwise() + offset;
    const double error = distance(b.state().points, expected) / scale;
    QVERIFY2(error < 1e-8, qPrintable(QString::number(error)));
    QVERIFY(std::abs(b.restEnergy() / a.restEnergy() - 1) < 1e-7);
}

struct Residue {
    double farthest = NAN, mean = NAN;
};
/// Moves the right end's middle vertex once around a circle of radius 0.1 with the left end held; returns the
/// distance of the shape from rest, in sizes.
Residue residueOf(double memory, double time = 1) {
    const auto mesh = std::make_shared<SimplicialMesh<2>>(samples::strip<2>(48, 12, 4));
    Material<2> material = Material<2>::uniform(mesh->cellCount(), phi::kMetr);
    material.memory = memory;
    const double size = shapeSize<2>(mesh->points, mesh->cells).size;
    Handle<2> pin;
    pin.name = "pin";
    const Vec2 at(4, 0.5);
    pin.at = std::vector<Vec2>{at};
    Rotate<2> turn;
    turn.centre = at + Vec2(0, 0.1 * size);
    turn.angle = 2 * kPi;
    pin.motions = {{turn}};
    pin.motions[0].start = 0, pin.motions[0].end = time;
    Deformer<2> deformer(mesh, std::make_shared<const Material<2>>(material),
                         {Bend<2>::at("left", -1, 0.01), pin});
    if (deformer.advance(time).outcome != Outcome::Done) return {};
    const auto way = ((deformer.state().points - mesh->points) / size).colwise().norm().eval();
    return {way.maxCoeff(), way.mean()};
}

}  // namespace

class TestMemory : public QObject {
    Q_OBJECT

  private slots:
    void expansion() {
        expansionIsTheEnergy<2>();
        expansionIsTheEnergy<3>();
    }
    void stress() {
        stressIsTheDerivative<2>();
        stressIsTheDerivative<3>();
    }
    void modes() {
        modesAreTheHessian<2>();
        modesAreTheHessian<3>();
    }
    void rotations() {
        rotationsCostNothing<2>();
        rotationsCostNothing<3>();
    }
    void gradient() {
        gradientIsTheDerivative<2>();
        gradientIsTheDerivative<3>();
    }
    void field() {
        fieldIsTheMinimizer<2>();
        fieldIsTheMinimizer<3>();
    }
    void settles_data() {
        QTest::addColumn<double>("phi");
        QTest::addColumn<bool>("anisotropic");
        QTest::newRow("EQUIA") << phi::kEquia << false;
        QTest::newRow("METR") << phi::kMetr << false;
        QTest::newRow("AKVF") << phi::kAkvf << false;
        QTest::newRow("CONF") << phi::conformal(2) << false;
        QTest::newRow("METR, B") << phi::kMetr << true;
    }
    void settles() {
        QFETCH(double, phi);
        QFETCH(bool, anisotropic);
        settledIsStationary<2>(phi, anisotropic);
        settledIsStationary<3>(std::min(phi, phi::conformal(3)), anisotropic);
    }
    void rest() { restStaysAtRest(); }
    void turned_data() {
        QTest::addColumn<double>("phi");
        QTest::addColumn<bool>("anisotropic");
        for (bool anisotropic : {false, true}) {
            QTest::addRow("METR %d", anisotropic) << phi::kMetr << anisotropic;
            QTest::addRow("CONF %d", anisotropic) << phi::conformal(3) << anisotropic;
        }
    }
    void turned() {
        QFETCH(double, phi);
        QFETCH(bool, anisotropic);
        turnedInputTurnsTheResult<2>(phi, anisotropic);
        turnedInputTurnsTheResult<3>(phi, anisotropic);
    }
    void residue() {
        // docs/material.md, on ten times as many vertices
        const std::array<double, 4> farthest{0.055, 0.028, 0.013, 0.007}, mean{0.034, 0.0175, 0.008, 0.0036};
        double last = 1;
        for (std::size_t i = 0; i < 4; ++i) {
            const Residue left = residueOf(std::array{0.0, 3.0, 10.0, 30.0}[i]);
            qInfo("residue %.4f, on average %.4f", left.farthest, left.mean);
            QVERIFY(std::abs(left.farthest / farthest[i] - 1) < 0.2);
            QVERIFY(std::abs(left.mean / mean[i] - 1) < 0.2);
            QVERIFY(left.mean < 0.7 * std::exchange(last, left.mean));
        }
        // The path is decisive, not the time that it takes.
        const double slow = residueOf(10, 4).mean, usual = residueOf(10).mean;
        QVERIFY2(std::abs(slow / usual - 1) < 0.02, qPrintable(QString("%1 %2").arg(slow).arg(usual)));
    }
};

QTEST_APPLESS_MAIN(TestMemory)
#include "test_memory.moc"
