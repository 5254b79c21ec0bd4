// The assembly plan and the CPU back end against an energy that is summed straight from its definition, 2D
// and 3D.
#include <Eigen/Dense>
#include <QTest>
#include <cstring>
#include <map>
#include <set>

#include "core/assembly/cpu_back_end.h"
#include "core/energy/smoothness.h"
#include "core/factor/worker_pool.h"
#include "tests/core/test_energy_samples.h"
#include "tests/support/simd_targets.h"

using namespace wend;
using namespace wend::test;

namespace {

template <int Dim>
Mat<Dim> jacobian(const Points<Dim>& x, const Points<Dim>& v, const Cell<Dim>& cell) {
    return edgeMatrix<Dim>(v, cell) * edgeMatrix<Dim>(x, cell).inverse();
}

/// E = Σ V e(J) + Σ weight q(J_j − J_i), or weight ‖P_j − P_i‖²_F with the paper's kind, as method.md writes
/// it: B turned by the polar factor (by SVD), J by the inverse edge matrix, neighbours by common vertices. No
/// Mandel coordinates, no plan.
template <int Dim>
double summedEnergy(const SimplicialMesh<Dim>& rest, const Material<Dim>& material, const Points<Dim>& x,
                    const Points<Dim>& v) {
    std::vector<Mat<Dim>> P, jacobians, turned;
    double energy = 0;
    for (int c = 0; c < rest.cellCount(); ++c) {
        const auto& cell = rest.cells[c];
        const double wq = std::sin(material.phi[c]), wr = std::cos(material.phi[c]);
        Mat<Dim> B = Mat<Dim>::Identity();
        if (!material.anisotropy.empty()) {
            const Eigen::JacobiSVD<Mat<Dim>> svd(jacobian<Dim>(rest.points, x, cell),
                                                 Eigen::ComputeFullU | Eigen::ComputeFullV);
            const Mat<Dim> R = svd.matrixU() * svd.matrixV().transpose();
            B = R * material.anisotropy[c] * R.transpose();
        }
        const Mat<Dim> J = jacobian<Dim>(x, v, cell), S = J + Mat<Dim>(J.transpose());
        const double k = Dim / B.trace(), trBJ = (B * J).trace();
        energy += std::abs(cellMeasure<Dim>(x, cell)) * (wq * (S * B * S).trace() + wr * k * trBJ * trBJ);
        P.push_back(2 * wq * (S * B + B * S) + 2 * wr * k * trBJ * B);
        jacobians.push_back(J);
        turned.push_back(B);
    }
    const auto q = [&](int i, int j) {
        const Mat<Dim> B = (turned[i] + turned[j]) / 2, J = jacobians[j] - jacobians[i],
                       S = J + Mat<Dim>(J.transpose());
        const double wq = (std::sin(material.phi[i]) + std::sin(material.phi[j])) / 2,
                     wr = (std::cos(material.phi[i]) + std::cos(material.phi[j])) / 2;
        return wq * (S * B * S).trace() + std::min(wr, 0.0) * Dim / B.trace() * std::pow((B * J).trace(), 2);
    };
    const auto centroid = [&](int c) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (int p : rest.cells[c]) sum += x.col(p);
        return Vec<Dim>(sum / (Dim + 1));
    };
    for (int i = 0; i < rest.cellCount(); ++i)
        for (int j = 0; j < i; ++j) {
            std::vector<int> shared;
            for (int p : rest.cells[i])
                if (std::count(rest.cells[j].begin(), rest.cells[j].end(), p) > 0) shared.push_back(p);
            if (shared.size() != static_cast<std::size_t>(Dim)) continue;
            double B = (x.col(shared[1]) - x.col(shared[0])).norm();
            if (Dim == 3) {
                const Vec<Dim> a = x.col(shared[1]) - x.col(shared[0]),
                               b = x.col(shared[Dim - 1]) - x.col(shared[0]);
                B = 0.5 * std::sqrt(a.squaredNorm() * b.squaredNorm() - std::pow(a.dot(b), 2));
            }
            if (material.smoothing.kind == SmoothingKind::Paper)
                energy += material.smoothing.lambda * B * (P[j] - P[i]).squaredNorm();
            if (material.smoothing.kind == SmoothingKind::Invariant)
                energy +=
                    std::pow(material.smoothing.length, 2) * B / (centroid(i) - centroid(j)).norm() * q(i, j);
        }
    return energy;
}

template <int Dim>
struct Scene {
    SimplicialMesh<Dim> rest;
    Material<Dim> material;
    Points<Dim> shape;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::unique_ptr<BackEnd<Dim>> backEnd;
};

enum class Kind { Uniform, Swelling, Anisotropic, Mirrored };

template <int Dim>
Scene<Dim> sceneOf(Kind kind, SmoothingKind smoothingKind, int n = Dim == 2 ? 4 : 2, int threads = 1) {
    std::mt19937 random(3);
    Scene<Dim> scene;
    scene.rest = unitGrid<Dim>(n, 0.15, random);
    if (kind == Kind::Mirrored)
        for (auto& cell : scene.rest.cells) std::swap(cell[0], cell[1]);
    const Smoothing smoothing{smoothingKind, 0.2, 0.1};
    scene.material = kind == Kind::Uniform ? Material<Dim>::uniform(scene.rest.cellCount(), 1.1, smoothing)
                                           : randomMaterial<Dim>(random, scene.rest.cellCount(), smoothing);
    if (kind == Kind::Swelling) scene.material.anisotropy.clear();      // φ on both sides of AKVF
    Mat<Dim> F = Mat<Dim>::Identity() + 0.3 * randomSkew<Dim>(random);  // turned, so that R matters
    scene.shape = F * scene.rest.points + 0.05 / n * randomField<Dim>(random, scene.rest.vertexCount());
    scene.plan = std::make_shared<const AssemblyPlan<Dim>>(
        makeAssemblyPlan(scene.rest, smoothingKind != SmoothingKind::None));
    scene.backEnd = makeCpuBackEnd<Dim>(scene.plan, scene.rest, scene.material, threads);
    return scene;
}

/// The assembled blocks as a dense symmetric matrix.
template <int Dim>
Eigen::MatrixXd dense(const AssemblyPlan<Dim>& plan, const std::vector<double>& values) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(Dim * plan.vertexCount, Dim * plan.vertexCount);
    for (int q = 0; q < plan.vertexCount; ++q)
        for (int b = plan.columnStart[q]; b < plan.columnStart[q + 1]; ++b) {
            const Eigen::Map<const Mat<Dim>> block(values.data() + b * Dim * Dim);
            A.template block<Dim, Dim>(Dim * plan.row[b], Dim * q) = block;
            A.template block<Dim, Dim>(Dim * q, Dim * plan.row[b]) = Mat<Dim>(block.transpose());
        }
    return A;
}

template <int Dim>
std::vector<double> assembled(Scene<Dim>& scene) {
    std::vector<double> values(scene.plan->row.size() * Dim * Dim);
    scene.backEnd->assemble(values);
    return values;
}

/// Second differences of the summed energy, exact for a quadratic form: E(a + b) − E(a) − E(b) = 2 aᵀ A b.
template <int Dim>
void matrixIsHessian(Kind kind, SmoothingKind smoothing) {
    auto scene = sceneOf<Dim>(kind, smoothing);
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    const auto A = dense<Dim>(*scene.plan, assembled<Dim>(scene));
    const int n = static_cast<int>(A.rows());
    const auto E = [&](const Points<Dim>& v) {
        return summedEnergy<Dim>(scene.rest, scene.material, scene.shape, v);
    };
    const auto unit = [&](int i) {
        Points<Dim> v = Points<Dim>::Zero(Dim, scene.rest.vertexCount());
        v.data()[i] = 1;
        return v;
    };
    std::vector<double> single;
    for (int i = 0; i < n; ++i) single.push_back(E(unit(i)));
    for (int i = 0; i < n; i += 3)
        for (int j = 0; j <= i; ++j) {
            const double expected = (E(unit(i) + unit(j)) - single[i] - single[j]) / 2;
            QVERIFY(std::abs(A(i, j) - expected) < 1e-12 * A.cwiseAbs().maxCoeff());
        }
}

template <int Dim>
void productAndEnergyAgree(Kind kind, SmoothingKind smoothing) {
    auto scene = sceneOf<Dim>(kind, smoothing);
    std::mt19937 random(11);
    if (kind == Kind::Anisotropic)  // with mass regularization too
        scene.backEnd->setMassRegularization(std::vector<double>(scene.rest.cells.size(), 0.7));
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    const auto A = dense<Dim>(*scene.plan, assembled<Dim>(scene));
    const Points<Dim> v = randomField<Dim>(random, scene.rest.vertexCount());
    Points<Dim> Av;
    scene.backEnd->apply(v, Av);
    const Eigen::VectorXd expected = A * v.reshaped();
    QVERIFY((Av.reshaped() - expected).cwiseAbs().maxCoeff() <
            1e-14 * A.cwiseAbs().rowwise().sum().maxCoeff());
    const double energy = summedEnergy<Dim>(scene.rest, scene.material, scene.shape, v);
    QVERIFY(std::abs(scene.backEnd->energy(v) - energy) < 1e-12 * energy);
}

/// vᵀ M v = ∫|v|²; for v = x by the exact second moments of a simplex.
template <int Dim>
void massRegularizationIsMass() {
    auto scene = sceneOf<Dim>(Kind::Uniform, SmoothingKind::Invariant);
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    Points<Dim> Av, AMv;
    const Points<Dim>& v = scene.shape;
    scene.backEnd->apply(v, Av);
    scene.backEnd->setMassRegularization(std::vector<double>(scene.rest.cells.size(), 1.0));
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    scene.backEnd->apply(v, AMv);
    double expected = 0;
    for (const auto& cell : scene.rest.cells) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        double squares = 0;
        for (int p : cell) {
            sum += v.col(p);
            squares += v.col(p).squaredNorm();
        }
        expected +=
            cellMeasure<Dim>(scene.shape, cell) * (sum.squaredNorm() + squares) / ((Dim + 1) * (Dim + 2));
    }
    QVERIFY(std::abs(v.reshaped().dot((AMv - Av).reshaped()) - expected) < 1e-12 * expected);
}

/// Rigid fields have zero energy for any material, also where φ and B jump; similarities at φ_CONF, for any
/// B.
template <int Dim>
void nullFields() {
    std::mt19937 random(12);
    for (const auto kind : {SmoothingKind::Invariant, SmoothingKind::Paper}) {
        auto scene = sceneOf<Dim>(Kind::Anisotropic, kind);
        const auto rigid = affineField<Dim>(scene.shape, randomSkew<Dim>(random), Vec<Dim>::Ones());
        const auto similar = affineField<Dim>(scene.shape, Mat<Dim>::Identity(), Vec<Dim>::Ones());
        QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
        const double unit = scene.backEnd->energy(similar);
        QVERIFY(unit > 1);
        QVERIFY(scene.backEnd->energy(rigid) < 1e-26 * unit);

        scene.material.phi.assign(scene.material.phi.size(), phi::conformal(Dim));
        scene.backEnd = makeCpuBackEnd<Dim>(scene.plan, scene.rest, scene.material, 1);
        QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
        QVERIFY(std::abs(scene.backEnd->energy(similar)) < 1e-14 * unit);
        QVERIFY(scene.backEnd->energy(rigid) < 1e-26 * unit);
    }
}

/// The back end for B = I equals the general one with a B of ones.
template <int Dim>
void backEndsAgree(SmoothingKind smoothing) {
    auto scene = sceneOf<Dim>(Kind::Swelling, smoothing);
    const auto general = makeGeneralBackEnd<Dim>(scene.plan, scene.rest, scene.material, 1);
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    QCOMPARE(general->setShape(scene.shape), -1);
    std::vector<double> values(scene.plan->row.size() * Dim * Dim);
    general->assemble(values);
    const Eigen::MatrixXd A = dense<Dim>(*scene.plan, assembled<Dim>(scene)),
                          B = dense<Dim>(*scene.plan, values);
    QVERIFY((A - B).cwiseAbs().maxCoeff() < 1e-14 * A.cwiseAbs().maxCoeff());
}

/// q is the energy density of admissible weights: no jump lowers the energy.
template <int Dim>
void jumpsCost() {
    std::mt19937 random(16);
    for (int i = 0; i < 2000; ++i) {
        const auto phi = [&] {
            return i % 4 == 0 ? phi::conformal(Dim) : uniform(random, 1e-3, phi::conformal(Dim));
        };
        const auto w = jumpWeights(EnergyWeights::of(phi()), EnergyWeights::of(phi()));
        const Mat<Dim> B =
            0.5 * (randomAnisotropy<Dim>(random, 30) +
                   (i % 2 ? Mat<Dim>(Mat<Dim>::Identity()) : randomAnisotropy<Dim>(random, 30)));
        const Mat<Dim> J = i % 8 == 0 ? Mat<Dim>(Mat<Dim>::Identity()) : randomMatrix<Dim, Dim>(random);
        QVERIFY(w.r <= 0);
        QVERIFY(energyDensity<Dim>(w, B, J) >= -1e-13 * w.q * B.trace());
    }
}

template <int Dim>
void motionOfTheFrameChangesNothing() {
    std::mt19937 random(13);
    auto scene = sceneOf<Dim>(Kind::Uniform, SmoothingKind::Invariant);
    const Points<Dim> v = randomField<Dim>(random, scene.rest.vertexCount());
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    const double energy = scene.backEnd->energy(v);
    const Mat<Dim> R = polarRotation<Dim>(Mat<Dim>::Identity() + randomSkew<Dim>(random));
    QCOMPARE(scene.backEnd->setShape(affineField<Dim>(scene.shape, R, Vec<Dim>::Constant(3))), -1);
    QVERIFY(std::abs(scene.backEnd->energy(R * v) - energy) < 1e-11 * energy);
}

template <int Dim>
void firstInvertedCell() {
    auto scene = sceneOf<Dim>(Kind::Mirrored, SmoothingKind::Invariant, Dim == 2 ? 40 : 8, 3);
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
    const int vertex = scene.rest.cells[scene.rest.cellCount() / 2][0];
    Points<Dim> broken = scene.shape;
    broken.col(vertex).array() += 10;
    int expected = -1;
    for (int c = scene.rest.cellCount() - 1; c >= 0; --c)
        if (cellMeasure<Dim>(broken, scene.rest.cells[c]) >= 0) expected = c;
    QVERIFY(expected >= 0);
    QCOMPARE(scene.backEnd->setShape(broken), expected);
    QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
}

/// Evaluates matrix, product and energy of a scene, one after the other.
template <int Dim>
std::vector<double> everythingOf(Scene<Dim>& scene) {
    auto all = assembled<Dim>(scene);
    std::mt19937 random(17);
    Points<Dim> Av;
    const Points<Dim> v = randomField<Dim>(random, scene.rest.vertexCount());
    scene.backEnd->apply(v, Av);
    all.insert(all.end(), Av.reshaped().begin(), Av.reshaped().end());
    all.push_back(scene.backEnd->energy(v));
    return all;
}

/// The same bits for any number of threads, and each time, on a mesh where they are used.
template <int Dim>
void sameBits(Kind kind) {
    std::vector<double> first;
    for (int threads : {1, 2, 4, 4}) {
        auto scene = sceneOf<Dim>(kind, SmoothingKind::Invariant, Dim == 2 ? 75 : 15, threads);
        QVERIFY(scene.backEnd->device().starts_with(std::to_string(threads)));
        QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
        const auto all = everythingOf<Dim>(scene);
        if (first.empty()) first = all;
        QVERIFY(first.size() == all.size() && std::memcmp(first.data(), all.data(), 8 * all.size()) == 0);
    }
}

/// Targets sum in different orders and round products once or twice: the results differ by a few last bits of
/// the largest number. Some counts of cells are not divisible by any number of lanes.
template <int Dim>
void targetsAgree(SmoothingKind smoothing, int n) {
    std::vector<double> first;
    onEveryTarget([&](SimdTarget) {
        auto scene = sceneOf<Dim>(Kind::Swelling, smoothing, n);
        QCOMPARE(scene.backEnd->setShape(scene.shape), -1);
        const auto all = everythingOf<Dim>(scene);
        if (first.empty()) first = all;
        QCOMPARE(all.size(), first.size());
        const auto size = static_cast<Eigen::Index>(all.size());
        const Eigen::Map<const Eigen::VectorXd> a(first.data(), size), b(all.data(), size);
        QVERIFY((a - b).cwiseAbs().maxCoeff() < 1e-13 * a.cwiseAbs().maxCoeff());
    });
}

/// The pattern has exactly the pairs of vertices of one cell or of two cells with a common facet.
template <int Dim>
void patternIsTwoRing() {
    const auto scene = sceneOf<Dim>(Kind::Uniform, SmoothingKind::Invariant);
    std::set<std::pair<int, int>> expected, found;
    const auto& cells = scene.rest.cells;
    const auto add = [&](const Cell<Dim>& a, const Cell<Dim>& b) {
        for (int p : a)
            for (int q : b)
                if (p >= q) expected.emplace(q, p);
    };
    for (const auto& a : cells)
        for (const auto& b : cells) {
            int shared = 0;
            for (int p : a) shared += static_cast<int>(std::count(b.begin(), b.end(), p));
            if (shared >= Dim) add(a, b);
        }
    const auto& plan = *scene.plan;
    for (int q = 0; q < plan.vertexCount; ++q)
        for (int b = plan.columnStart[q]; b < plan.columnStart[q + 1]; ++b) {
            QVERIFY(b == plan.columnStart[q] || plan.row[b - 1] < plan.row[b]);
            found.emplace(q, plan.row[b]);
        }
    QVERIFY(found == expected);
    QVERIFY(makeAssemblyPlan(scene.rest, false).blockCount() < plan.blockCount());
}

}  // namespace

class TestAssembly : public QObject {
    Q_OBJECT

    template <typename Body>
    void forAll(Body&& body) {
        for (const auto kind : {Kind::Uniform, Kind::Swelling, Kind::Anisotropic, Kind::Mirrored})
            for (const auto smoothing : {SmoothingKind::Invariant, SmoothingKind::Paper, SmoothingKind::None})
                body(kind, smoothing);
    }

  private slots:
    void hessian() {
        forAll([](Kind kind, SmoothingKind smoothing) {
            matrixIsHessian<2>(kind, smoothing);
            matrixIsHessian<3>(kind, smoothing);
        });
    }
    void product() {
        onEveryTarget([&](SimdTarget) {
            forAll([](Kind kind, SmoothingKind smoothing) {
                productAndEnergyAgree<2>(kind, smoothing);
                productAndEnergyAgree<3>(kind, smoothing);
            });
        });
    }
    void backEnds() {
        onEveryTarget([](SimdTarget) {
            for (const auto smoothing :
                 {SmoothingKind::Invariant, SmoothingKind::Paper, SmoothingKind::None}) {
                backEndsAgree<2>(smoothing);
                backEndsAgree<3>(smoothing);
            }
        });
    }
    void targets() {
        for (const auto smoothing : {SmoothingKind::Invariant, SmoothingKind::Paper, SmoothingKind::None})
            for (int n : {1, 3, 7}) {
                targetsAgree<2>(smoothing, n);
                targetsAgree<3>(smoothing, n);
            }
    }
    void jumps() {
        jumpsCost<2>();
        jumpsCost<3>();
    }
    void massRegularization() {
        massRegularizationIsMass<2>();
        massRegularizationIsMass<3>();
    }
    void zeroEnergy() {
        nullFields<2>();
        nullFields<3>();
    }
    void frame() {
        motionOfTheFrameChangesNothing<2>();
        motionOfTheFrameChangesNothing<3>();
    }
    void inverted() {
        firstInvertedCell<2>();
        firstInvertedCell<3>();
    }
    void threads() {
        sameBits<2>(Kind::Anisotropic);
        sameBits<3>(Kind::Anisotropic);
        onEveryTarget([](SimdTarget) {
            sameBits<2>(Kind::Swelling);
            sameBits<3>(Kind::Swelling);
        });
    }
    void pattern() {
        patternIsTwoRing<2>();
        patternIsTwoRing<3>();
    }
    void workerPool() {
        WorkerPool pool(4);
        std::vector<int> visits(10007, 0);
        for (int round = 0; round < 2000; ++round) {
            const int count = 1 + (round * 37) % static_cast<int>(visits.size());
            pool.forPieces(count, 64, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) ++visits[i];
            });
            QCOMPARE(visits[count - 1], 1);
            QCOMPARE(std::count(visits.begin(), visits.end(), 1), count);
            std::fill(visits.begin(), visits.end(), 0);
        }
    }
};

QTEST_APPLESS_MAIN(TestAssembly)
#include "test_assembly.moc"
