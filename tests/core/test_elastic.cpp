// Elastic motion, settling and strong memory by Newton's method: minima of the energy of the map from rest,
// compared with its gradient, with closed paths, and with each other.
#include <Eigen/Dense>
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/assembly/rest_energy.h"
#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "core/integration/drag_flow.h"
#include "core/mesh/shape_size.h"
#include "tests/core/test_energy_samples.h"
#include "tests/core/test_strip.h"
#include "tests/support/simd_targets.h"

using namespace wend;
using namespace wend::test;
using samples::Bend;
using samples::distance;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kElastic = std::numeric_limits<double>::infinity();

template <int Dim>
std::shared_ptr<const Material<Dim>> withMemory(const Material<Dim>& material, double memory) {
    auto result = std::make_shared<Material<Dim>>(material);
    result->memory = memory;
    return result;
}

/// The Hessian's blocks, and its product with a field, are compared with differences of the gradient.
template <int Dim>
void hessianIsTheDerivative(bool isotropic) {
    std::mt19937 random(5);
    SimplicialMesh<Dim> rest = unitGrid<Dim>(Dim == 2 ? 5 : 3, 0.15, random);
    Material<Dim> material = randomMaterial<Dim>(random, rest.cellCount(), {});
    for (std::size_t c = 0; c < rest.cells.size(); c += 2) material.anisotropy[c] = Mat<Dim>::Identity();
    if (isotropic) material.anisotropy.clear();
    const Points<Dim> shape = (Mat<Dim>::Identity() + 0.2 * randomMatrix<Dim, Dim>(random)) * rest.points +
                              0.03 * randomField<Dim>(random, rest.vertexCount());
    for (const bool smoothing : {false, true}) {
        const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, smoothing));
        RestEnergy<Dim> W(plan, rest, material);
        WorkerPool pool(2);
        W.linearize(shape, 1, pool);
        std::vector<double> blocks(static_cast<std::size_t>(plan->blockCount()) * Dim * Dim, 0);
        W.addHessian(blocks, pool);
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(Dim * rest.vertexCount(), Dim * rest.vertexCount());
        for (int q = 0; q < plan->vertexCount; ++q)
            for (int b = plan->columnStart[q]; b < plan->columnStart[q + 1]; ++b) {
                const Eigen::Map<const Mat<Dim>> block(blocks.data() + b * Dim * Dim);
                H.template block<Dim, Dim>(Dim * plan->row[b], Dim * q) = block;
                H.template block<Dim, Dim>(Dim * q, Dim * plan->row[b]) = block.transpose();
            }
        for (int i = 0; i < 10; ++i) {
            Points<Dim> u = randomField<Dim>(random, rest.vertexCount()), Hu, up, down;
            const double h = 1e-6;
            W.gradient(shape + h * u, up, pool);
            W.gradient(shape - h * u, down, pool);
            W.applyHessian(u, Hu, pool);
            QVERIFY((Hu - (up - down) / (2 * h)).norm() < 1e-6 * Hu.norm());
            const Eigen::VectorXd product = H * u.reshaped();
            QVERIFY((product - Hu.reshaped()).norm() < 1e-12 * Hu.norm());
        }
        W.linearize(shape, 0, pool);
        for (int i = 0; i < 10; ++i) {
            const Points<Dim> u = randomField<Dim>(random, rest.vertexCount());
            Points<Dim> Hu;
            W.applyHessian(u, Hu, pool);
            QVERIFY(Hu.cwiseProduct(u).sum() >= -1e-12 * Hu.norm() * u.norm());
        }
    }
}

/// W and its gradient where B₀ = I, which are computed for several cells at once, are compared with sums over
/// the cells; one cell, possibly the last, is inverted.
template <int Dim>
void energyIsTheSumOverCells() {
    std::mt19937 random(6);
    const SimplicialMesh<Dim> rest = unitGrid<Dim>(Dim == 2 ? 9 : 4, 0.15, random);
    Material<Dim> material = randomMaterial<Dim>(random, rest.cellCount(), {});
    material.anisotropy.clear();
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, false));
    RestEnergy<Dim> W(plan, rest, material);
    WorkerPool pool(2);
    const Mat<Dim> none = Mat<Dim>::Identity();
    Points<Dim> shape = (Mat<Dim>::Identity() + 0.2 * randomMatrix<Dim, Dim>(random)) * rest.points +
                        0.02 * randomField<Dim>(random, rest.vertexCount()),
                expected = Points<Dim>::Zero(Dim, rest.vertexCount()), gradient;
    double sum = 0;
    for (int c = 0; c < rest.cellCount(); ++c) {
        const Mat<Dim> inverse = edgeMatrix<Dim>(rest.points, rest.cells[c]).inverse(),
                       F = edgeMatrix<Dim>(shape, rest.cells[c]) * inverse;
        const auto weights = EnergyWeights::of(material.phi[c]);
        sum += W.measure(c) * restDensity<Dim>(weights, none, F);
        const Mat<Dim> forces = W.measure(c) * restStress<Dim>(weights, none, F) * inverse.transpose();
        for (int k = 0; k < Dim; ++k) {
            expected.col(rest.cells[c][k + 1]) += forces.col(k);
            expected.col(rest.cells[c][0]) -= forces.col(k);
        }
    }
    QVERIFY(std::abs(W.energy(shape) - sum) < 1e-12 * sum);
    W.gradient(shape, gradient, pool);
    QVERIFY((gradient - expected).norm() < 1e-12 * expected.norm());
    W.gradient(rest.points, gradient, pool);
    QVERIFY(gradient.isZero(0));
    for (const int c : {0, rest.cellCount() - 1}) {
        Points<Dim> folded = shape;
        const Cell<Dim>& cell = rest.cells[c];
        Vec<Dim> across = Vec<Dim>::Zero();  // the middle of the facet opposite to corner 0
        for (int k = 1; k <= Dim; ++k) across += shape.col(cell[k]) / Dim;
        folded.col(cell[0]) = 2 * across - shape.col(cell[0]);
        QVERIFY(edgeMatrix<Dim>(folded, cell).determinant() *
                    edgeMatrix<Dim>(rest.points, cell).determinant() <
                0);
        QVERIFY(std::isinf(W.energy(folded)));
    }
}

/// The first flat cell along a straight path is compared with the smallest measure at many places of it.
template <int Dim>
void stepsEndBeforeCellsAreFlat() {
    std::mt19937 random(7);
    const SimplicialMesh<Dim> rest = unitGrid<Dim>(3, 0.15, random);
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, false));
    const RestEnergy<Dim> W(plan, rest, Material<Dim>::uniform(rest.cellCount(), phi::kMetr));
    int shortened = 0;
    for (int i = 0; i < 40; ++i) {
        const Points<Dim> step = uniform(random, 0.02, 0.6) * randomField<Dim>(random, rest.vertexCount());
        const double part = W.unfoldedPart(rest.points, step);
        const auto leastAt = [&](double t) {
            double least = 1;
            for (const Cell<Dim>& cell : rest.cells)
                least = std::min(least, edgeMatrix<Dim>(rest.points + t * step, cell).determinant() /
                                            edgeMatrix<Dim>(rest.points, cell).determinant());
            return least;
        };
        for (int k = 0; k < 200; ++k) QVERIFY(leastAt(part * k / 200) > 0);
        if (part == 1) continue;
        ++shortened;
        double least = 1;
        for (int k = 0; k <= 200; ++k) least = std::min(least, leastAt(part + k / 200.0 * 0.02));
        QVERIFY2(least <= 0, qPrintable(QString::number(least)));
    }
    QVERIFY(shortened > 5);
}

/// The gradient of W without the part that the ends hold, in the frame where the shape has size 1.
template <int Dim>
double forceOf(const Bend<Dim>& bend, const Points<Dim>& shape) {
    const double size = shapeSize<Dim>(bend.mesh->points, bend.mesh->cells).size;
    const SimplicialMesh<Dim> rest{bend.mesh->points / size, bend.mesh->cells};
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, false));
    RestEnergy<Dim> W(plan, rest, *bend.material);
    WorkerPool pool(1);
    Points<Dim> gradient;
    W.gradient(shape / size, gradient, pool);
    for (int v = 0; v < bend.mesh->vertexCount(); ++v)
        if (const double along = bend.mesh->points(0, v); along < 1e-9 || along > 4 - 1e-9)
            gradient.col(v).setZero();
    return gradient.norm();
}

template <int Dim>
void settlesToTheMinimum(double phi, bool anisotropic) {
    Bend<Dim> bend(Dim == 2 ? 24 : 9, Dim == 2 ? 6 : 3, 4, 1.5, phi);
    Material<Dim> material = *bend.material;
    if (anisotropic) {
        std::mt19937 random(3);
        for (int c = 0; c < bend.mesh->cellCount(); ++c)
            material.anisotropy.push_back(randomAnisotropy<Dim>(random, 5));
    }
    bend.material = withMemory(material, 0);
    IntegrationOptions options;
    options.settle = {{1, 2}};
    options.end = 2;
    auto settled = bend.deformer(options);
    QCOMPARE(settled.advance(1).outcome, Outcome::Done);
    const double before = forceOf<Dim>(bend, settled.state().points);
    QCOMPARE(settled.advance(2).outcome, Outcome::Done);
    const double force = forceOf<Dim>(bend, settled.state().points);
    qInfo("%dD, phi %.3f: force %.2e -> %.2e, %d factors", Dim, phi, before, force,
          settled.statistics().factorizations);
    QVERIFY(force < 1e-9 * before);
    QVERIFY(std::abs(settled.restForce() - force) < 1e-12);
    QCOMPARE(distortion<Dim>(*bend.mesh, settled.state().points).flips, 0);
    QVERIFY(settled.statistics().constraintError < 1e-12);

    bend.material = withMemory(material, kElastic);
    auto elastic = bend.deformer({});
    QCOMPARE(elastic.advance(1).outcome, Outcome::Done);
    qInfo("elastic: force %.2e, %d steps, %d rejected, %d factors, off %.2e", elastic.restForce(),
          elastic.statistics().steps, elastic.statistics().rejected, elastic.statistics().factorizations,
          distance(elastic.state().points, settled.state().points));
    QVERIFY(forceOf<Dim>(bend, elastic.state().points) < 1e-9 * before);
    QVERIFY(distance(elastic.state().points, settled.state().points) < 1e-7);
    QVERIFY(elastic.statistics().snaps.empty());
    // Near the minimum one factor serves for several steps.
    QVERIFY(elastic.statistics().solverIterations > elastic.statistics().factorizations);
}

/// Moves three pins of a strip along random closed polygons.
template <int Dim>
void closedPathsClose(double phi, unsigned seed) {
    std::mt19937 random(seed);
    const auto mesh = std::make_shared<SimplicialMesh<Dim>>(samples::strip<Dim>(Dim == 2 ? 24 : 9, 4, 4));
    const auto material = withMemory(Material<Dim>::uniform(mesh->cellCount(), phi), kElastic);
    std::vector<Handle<Dim>> handles = {Bend<Dim>::at("left", -1, 0.01)};
    for (const double along : {2.0, 4.0}) {
        Handle<Dim> pin;
        pin.name = "pin" + std::to_string(along);
        pin.at = std::vector<Vec<Dim>>{Vec<Dim>::Constant(0.5) + (along - 0.5) * Vec<Dim>::Unit(0)};
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (int k = 0; k < 3; ++k) {
            Vec<Dim> by = 0.3 * randomMatrix<Dim, 1>(random);
            if (k == 2) by = -sum;
            sum += by;
            Motion<Dim> motion{Translate<Dim>{by}};
            motion.start = k, motion.end = k + 1;
            pin.motions.push_back(motion);
        }
        handles.push_back(pin);
    }
    Deformer<Dim> deformer(mesh, material, handles, {});
    const double size = shapeSize<Dim>(mesh->points, mesh->cells).size;
    double farthest = 0;
    for (const double t : {1.0, 2.0}) {
        const AdvanceResult result = deformer.advance(t);
        QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
        farthest = std::max(farthest, distance(deformer.state().points, mesh->points) / size);
    }
    QCOMPARE(deformer.advance(3).outcome, Outcome::Done);
    const double off = distance(deformer.state().points, mesh->points) / size;
    qInfo("%dD, phi %.3f: away %.3f, back %.2e, %d steps, %d factors", Dim, phi, farthest, off,
          deformer.statistics().steps, deformer.statistics().factorizations);
    QVERIFY(farthest > 0.02);
    QVERIFY(off < 1e-8);
}

/// A frame within a step is the minimum at its time, which is the shape of a run that ends there.
void framesAreMinima() {
    const Bend<2> bend(24, 6, 4, 1.5, phi::kMetr);
    const auto elastic = withMemory(*bend.material, kElastic);
    Deformer<2> deformer(bend.mesh, elastic, bend.handles, {});
    std::vector<State<2>> frames;
    Deformer<2>::Watch watch;
    watch.frames = {0.13, 0.4, 0.77};
    watch.onFrame = [&](const State<2>& frame) { frames.push_back(frame); };
    QCOMPARE(deformer.advance(1, watch).outcome, Outcome::Done);
    Deformer<2> other(bend.mesh, elastic, bend.handles, {});
    QCOMPARE(other.advance(1).outcome, Outcome::Done);
    QVERIFY(other.state().points == deformer.state().points);  // frames do not change the steps
    QCOMPARE(frames.size(), 3U);
    // The guesses are so close that few factors are needed.
    const int forFrames = deformer.statistics().factorizations - other.statistics().factorizations;
    qInfo("%d factors for 3 frames, %d for the steps", forFrames, other.statistics().factorizations);
    QVERIFY(forFrames <= 12);
    for (const State<2>& frame : frames) {
        Deformer<2> till(bend.mesh, elastic, bend.handles, {});
        QCOMPARE(till.advance(frame.time).outcome, Outcome::Done);
        QVERIFY(distance(till.state().points, frame.points) < 1e-8);
    }
}

/// Single vertices that swing far within a step: between its ends no shape can be interpolated without folds,
/// and the frames are the minima at their times all the same.
void framesOfLongStepsAreMinima() {
    const Bend<2> bend(24, 6, 4, 1.5, phi::kMetr);
    const auto elastic = withMemory(*bend.material, kElastic);
    const Vec2 low = bend.mesh->points.rowwise().minCoeff(), high = bend.mesh->points.rowwise().maxCoeff();
    std::vector<Handle<2>> handles;
    for (const double share : {0.05, 0.35, 0.65, 0.95}) {
        const Vec2 place(std::lerp(low.x(), high.x(), share), 0.5 * (low.y() + high.y()));
        Handle<2> handle;
        handle.at = std::vector<Vec2>{place};
        CurveMotion<2> wave;
        wave.points = {place};
        for (int k = 0; k < 4; ++k)
            for (const double y : {1.0, 1.0, 0.0})
                wave.points.push_back(place + Vec2(0, (k % 2 ? -y : y) * (share - 0.5)));
        handle.motions = {{wave, 0, 1}};
        handles.push_back(handle);
    }
    Deformer<2> deformer(bend.mesh, elastic, handles, {});
    std::vector<State<2>> frames;
    Deformer<2>::Watch watch;
    for (int i = 1; i < 32; ++i) watch.frames.push_back(i / 32.0);
    watch.onFrame = [&](const State<2>& frame) { frames.push_back(frame); };
    QCOMPARE(deformer.advance(1, watch).outcome, Outcome::Done);
    QCOMPARE(frames.size(), watch.frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (i > 0) QVERIFY(distance(frames[i - 1].points, frames[i].points) > 1e-3);
        if (i % 5 != 2) continue;
        Deformer<2> till(bend.mesh, elastic, handles, {});
        QCOMPARE(till.advance(frames[i].time).outcome, Outcome::Done);
        QVERIFY(distance(till.state().points, frames[i].points) < 1e-7);
    }
}

/// The derivative of the minimizer, against differences of minima.
void velocityIsTheDerivative() {
    const Bend<2> bend(24, 6, 4, 1.5, phi::kMetr);
    const auto elastic = withMemory(*bend.material, kElastic);
    const auto at = [&](double t) {
        Deformer<2> deformer(bend.mesh, elastic, bend.handles, {});
        if (deformer.advance(t).outcome != Outcome::Done) return std::pair<Points2, Points2>();
        return std::pair<Points2, Points2>(deformer.state().points, deformer.velocity());
    };
    const double h = 1e-3;
    const Points2 slope = (at(0.5 + h).first - at(0.5 - h).first) / (2 * h), v = at(0.5).second;
    QVERIFY(v.cols() > 0);
    QVERIFY((slope - v).norm() < 1e-4 * v.norm());
}

/// A strip between two ends that come together by a third buckles, and is straight again when they are back.
void bucklesAndComesBack() {
    const auto mesh = std::make_shared<SimplicialMesh<2>>(samples::strip<2>(48, 4, 4));
    auto material = Material<2>::uniform(mesh->cellCount(), phi::kMetr);
    std::vector<Handle<2>> handles = {Bend<2>::at("left", -1, 0.01), Bend<2>::at("right", 3.99, 5)};
    for (int k : {0, 1}) {
        Motion<2> motion{Translate<2>{Vec2(k == 0 ? -1.2 : 1.2, 0)}};
        motion.start = k, motion.end = k + 1;
        handles[1].motions.push_back(motion);
    }
    Deformer<2> deformer(mesh, withMemory(material, kElastic), handles, {});
    AdvanceResult result = deformer.advance(1);
    QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
    const double bulge = (deformer.state().points.row(1) - mesh->points.row(1)).cwiseAbs().maxCoeff();
    qInfo("bulge %.3f, force %.1e, %zu snaps, %d steps", bulge, deformer.restForce(),
          deformer.statistics().snaps.size(), deformer.statistics().steps);
    QVERIFY(bulge > 0.5);
    QVERIFY(deformer.restForce() < 1e-9);
    result = deformer.advance(2);
    QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
    QVERIFY(distance(deformer.state().points, mesh->points) < 1e-8);
}

/// The ends of a strip come together, so that it buckles, and then rotate: in one direction it bends further,
/// in the other it snaps to the other side.
void snapsAreReported() {
    const auto mesh = std::make_shared<SimplicialMesh<2>>(samples::strip<2>(48, 4, 4));
    for (int v = 0; v < mesh->vertexCount(); ++v) mesh->points(1, v) *= 0.3;  // slender
    auto material = Material<2>::uniform(mesh->cellCount(), phi::kMetr);
    std::array<int, 2> snaps{};
    for (const int way : {0, 1}) {
        std::vector<Handle<2>> handles = {Bend<2>::at("left", -1, 0.01), Bend<2>::at("right", 3.99, 5)};
        handles[1].motions = {{Translate<2>{Vec2(-0.6, 0)}}};
        for (const int end : {0, 1}) {
            Rotate<2> turn;
            turn.centre = Vec2(end == 0 ? 0 : 3.4, 0.15);
            turn.angle = (end == 0 ? -1 : 1) * (way == 0 ? 1 : -1) * 1.2;
            Motion<2> motion{turn};
            motion.start = 1, motion.end = 2;
            handles[end].motions.push_back(motion);
        }
        Deformer<2> deformer(mesh, withMemory(material, kElastic), handles, {});
        const AdvanceResult result = deformer.advance(2);
        QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
        QVERIFY(deformer.restForce() < 1e-9);
        QCOMPARE(distortion<2>(*mesh, deformer.state().points).flips, 0);
        for (const Snap& snap : deformer.statistics().snaps) {
            qInfo("snap at %.4f near (%.2f, %.2f)", snap.time, snap.place[0], snap.place[1]);
            QVERIFY(snap.place[0] > 0.2 && snap.place[0] < 3.2);
            snaps[way] += snap.time > 1;
        }
        qInfo("%d steps, %d rejected, %d factors", deformer.statistics().steps,
              deformer.statistics().rejected, deformer.statistics().factorizations);
    }
    QCOMPARE(std::min(snaps[0], snaps[1]), 0);
    QCOMPARE(std::max(snaps[0], snaps[1]), 1);
}

/// When a pin is released, the shape is at once in its equilibrium without it, here at rest.
void letsGo() {
    const auto mesh = std::make_shared<SimplicialMesh<2>>(samples::strip<2>(24, 6, 4));
    auto material = Material<2>::uniform(mesh->cellCount(), phi::kMetr);
    Handle<2> left = Bend<2>::at("left", -1, 0.01), pin;
    pin.name = "pin";
    pin.at = std::vector<Vec2>{Vec2(3.9, 0.5)};
    pin.motions = {{Translate<2>{Vec2(-0.5, 1)}}};
    pin.activeTo = 1.5;
    Deformer<2> deformer(mesh, withMemory(material, kElastic), {left, pin}, {});
    QCOMPARE(deformer.advance(1.5).outcome, Outcome::Done);
    QVERIFY(distance(deformer.state().points, mesh->points) > 0.5);
    const AdvanceResult result = deformer.advance(2);
    QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
    QVERIFY(distance(deformer.state().points, mesh->points) < 1e-8);
    QVERIFY(deformer.statistics().snaps.empty());
}

/// Strong memory falls to the elastic shape as 1/ρ.
void strongMemoryIsNearlyElastic() {
    Bend<2> bend(24, 6, 4, 1.5, phi::kMetr);
    const Material<2> material = *bend.material;
    bend.material = withMemory(material, kElastic);
    auto elastic = bend.deformer({});
    QCOMPARE(elastic.advance(1).outcome, Outcome::Done);
    double last = 0;
    for (const double memory : {50.0, 200.0, 800.0}) {
        bend.material = withMemory(material, memory);
        auto deformer = bend.deformer({});
        const AdvanceResult result = deformer.advance(1);
        QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
        const double off = distance(deformer.state().points, elastic.state().points);
        qInfo("memory %g: off %.2e, %d steps, %d factors", memory, off, deformer.statistics().steps,
              deformer.statistics().factorizations);
        if (last > 0) QVERIFY(std::abs(off / last * 4 - 1) < 0.2);
        last = off;
    }
}

/// Implicit steps agree with explicit ones where both can be taken.
void bothMemoriesAgree() {
    Bend<2> bend(24, 6, 4, 1.5, phi::kMetr);
    const Material<2> material = *bend.material;
    std::array<Points2, 2> shapes;
    for (const int implicit : {0, 1}) {
        bend.material = withMemory(material, implicit ? 40.01 : 39.99);
        IntegrationOptions options;
        options.tolerance = 1e-6;
        auto deformer = bend.deformer(options);
        QCOMPARE(deformer.advance(1).outcome, Outcome::Done);
        qInfo("%d steps, %d factors", deformer.statistics().steps, deformer.statistics().factorizations);
        shapes[implicit] = deformer.state().points;
    }
    QVERIFY(distance(shapes[0], shapes[1]) < 2e-3);
}

/// The run resumes with the same bits after a pause, from its state in another deformer.
void resumesToTheSameBits() {
    const Bend<2> bend(24, 6, 4, 1.5, phi::kMetr);
    const auto elastic = withMemory(*bend.material, kElastic);
    IntegrationOptions options;
    options.settle = {{1, 1.5}};
    for (const auto& material : {elastic, withMemory(*bend.material, 100), bend.material}) {
        Deformer<2> whole(bend.mesh, material, bend.handles, options);
        std::optional<State<2>> middle;
        Deformer<2>::Watch watch;
        watch.onStep = [&](const StepRecord<2>& step) {
            if (step.to > 0.5 && !middle) middle = whole.state();
        };
        QCOMPARE(whole.advance(1.5, watch).outcome, Outcome::Done);
        QVERIFY(middle.has_value());
        Deformer<2> other(bend.mesh, material, bend.handles, options);
        other.restore(*middle);
        QCOMPARE(other.advance(1.5).outcome, Outcome::Done);
        QVERIFY(other.state().points == whole.state().points);
    }
}

/// A drag keeps the shape near the minimum: its end is that of the motion.
template <int Dim>
void dragIsElastic(double phi) {
    Bend<Dim> bend(Dim == 2 ? 24 : 9, Dim == 2 ? 6 : 3, 4, 1, phi);
    bend.material = withMemory(*bend.material, kElastic);
    auto deformer = bend.deformer({});
    QCOMPARE(deformer.advance(1).outcome, Outcome::Done);
    DragFlow<Dim> drag(bend.mesh, bend.material, bend.handles, makeCpuBackEnd<Dim>);
    constexpr int kSamples = 20;
    Motion<Dim> turn = bend.handles[1].motions[0];
    std::get<Rotate<Dim>>(turn.kind).angle /= kSamples;
    for (int i = 0; i < kSamples; ++i) QCOMPARE(drag.lead({1}, turn).done, 1.0);
    const double off = distance(drag.pose(), deformer.state().points);
    qInfo("%dD, phi %.3f: off %.2e, %d factors", Dim, phi, off, drag.statistics().factorizations);
    QVERIFY(off < 1e-3);
    std::get<Rotate<Dim>>(turn.kind).angle *= -1;
    for (int i = 0; i < kSamples; ++i) QCOMPARE(drag.lead({1}, turn).done, 1.0);
    QVERIFY(distance(drag.pose(), bend.mesh->points) < 1e-3);
    QVERIFY(drag.constraintError() < 1e-12);
}

/// One handle rotates every vertex by a right angle, and the shape settles.
template <int Dim>
void nothingIsFree(double memory) {
    Bend<Dim> bend(6, 2, 3, kPi / 2);
    bend.material = withMemory(*bend.material, memory);
    bend.handles = {bend.handles.back()};
    bend.handles[0].at = Region<Dim>(Box<Dim>{Vec<Dim>::Constant(-10), Vec<Dim>::Constant(10)});
    IntegrationOptions options;
    options.settle = {{1, 2}};
    options.end = 2;
    auto deformer = bend.deformer(options);
    QCOMPARE(deformer.advance(2).outcome, Outcome::Done);
    Vec<Dim> centre = Vec<Dim>::Zero();
    centre[0] = 1.5, centre[1] = 3 * 0.55;
    Mat<Dim> turn = Mat<Dim>::Identity();
    turn.template topLeftCorner<2, 2>() << 0, -1, 1, 0;
    const Points<Dim> expected = (turn * (bend.mesh->points.colwise() - centre)).colwise() + centre;
    QVERIFY(distance(deformer.state().points, expected) < 1e-12);
}

}  // namespace

class TestElastic : public QObject {
    Q_OBJECT

  private slots:
    void hessian() {
        hessianIsTheDerivative<2>(false);
        hessianIsTheDerivative<3>(false);
        onEveryTarget([](SimdTarget) {
            hessianIsTheDerivative<2>(true);
            hessianIsTheDerivative<3>(true);
        });
    }
    void energy() {
        onEveryTarget([](SimdTarget) {
            energyIsTheSumOverCells<2>();
            energyIsTheSumOverCells<3>();
        });
    }
    void unfolded() {
        onEveryTarget([](SimdTarget) {
            stepsEndBeforeCellsAreFlat<2>();
            stepsEndBeforeCellsAreFlat<3>();
        });
    }
    void settles_data() {
        QTest::addColumn<double>("phi");
        QTest::addColumn<bool>("anisotropic");
        QTest::newRow("EQUIA") << phi::kEquia << false;
        QTest::newRow("METR") << phi::kMetr << false;
        QTest::newRow("AKVF") << phi::kAkvf << false;
        QTest::newRow("CONF") << phi::conformal(3) << false;
        QTest::newRow("METR, B") << phi::kMetr << true;
    }
    void settles() {
        QFETCH(double, phi);
        QFETCH(bool, anisotropic);
        settlesToTheMinimum<2>(phi, anisotropic);
        settlesToTheMinimum<3>(phi, anisotropic);
    }
    void closes_data() {
        QTest::addColumn<double>("flat");
        QTest::addColumn<double>("solid");
        QTest::addColumn<int>("seed");
        for (int seed : {1, 2, 3, 4, 5, 6}) {
            QTest::addRow("EQUIA %d", seed) << phi::kEquia << phi::kEquia << seed;
            QTest::addRow("METR %d", seed) << phi::kMetr << phi::kMetr << seed;
            QTest::addRow("AKVF %d", seed) << phi::kAkvf << phi::kAkvf << seed;
            QTest::addRow("CONF %d", seed) << phi::conformal(2) << phi::conformal(3) << seed;
        }
    }
    void closes() {
        QFETCH(double, flat);
        QFETCH(double, solid);
        QFETCH(int, seed);
        closedPathsClose<2>(flat, static_cast<unsigned>(seed));
        closedPathsClose<3>(solid, static_cast<unsigned>(seed));
    }
    void frames() { framesAreMinima(); }
    void framesOfLongSteps() { framesOfLongStepsAreMinima(); }
    void velocity() { velocityIsTheDerivative(); }
    void buckles() { bucklesAndComesBack(); }
    void snaps() { snapsAreReported(); }
    void release() { letsGo(); }
    void strong() { strongMemoryIsNearlyElastic(); }
    void agree() { bothMemoriesAgree(); }
    void drag_data() { settles_data(); }
    void drag() {
        QFETCH(double, phi);
        dragIsElastic<2>(phi);
        dragIsElastic<3>(phi);
    }
    void resumes() { resumesToTheSameBits(); }
    void heldEverywhere() {
        for (const double memory : {1.0, kElastic}) {
            nothingIsFree<2>(memory);
            nothingIsFree<3>(memory);
        }
    }
};

QTEST_APPLESS_MAIN(TestElastic)
#include "test_elastic.moc"
