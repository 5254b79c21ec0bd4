// The energy density, its stress and the material's checks, one body for 2D and 3D.
#include <Eigen/Dense>
#include <QTest>

#include "core/base/error.h"
#include "core/energy/cell_energy.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

namespace {

const std::array<double, 5> kFractions{0.01, 0.2, 0.5, 0.9, 1.0};  // of φ_CONF

template <int Dim>
void rigidAndSimilarFields() {
    std::mt19937 random(1);
    for (double fraction : kFractions)
        for (int i = 0; i < 20; ++i) {
            const auto w = EnergyWeights::of(fraction * phi::conformal(Dim));
            const Mat<Dim> B = randomAnisotropy<Dim>(random, 30);
            QVERIFY(std::abs(energyDensity<Dim>(w, B, randomSkew<Dim>(random))) <
                    1e-28 * B.trace());  // squares
            const Mat<Dim> similar = randomSkew<Dim>(random) + 0.7 * Mat<Dim>::Identity();
            const double e = energyDensity<Dim>(w, B, similar);
            if (fraction == 1.0)
                QVERIFY(std::abs(e) < 1e-13 * B.trace());
            else
                QVERIFY(e > 1e-3);
        }
}

template <int Dim>
void stressIsTheDerivative() {
    std::mt19937 random(2);
    for (double fraction : kFractions) {
        const auto w = EnergyWeights::of(fraction * phi::conformal(Dim));
        const Mat<Dim> B = randomAnisotropy<Dim>(random, 5), J = randomMatrix<Dim, Dim>(random);
        const Mat<Dim> P = stress<Dim>(w, B, J);
        for (int a = 0; a < Dim; ++a)
            for (int b = 0; b < Dim; ++b) {
                Mat<Dim> step = Mat<Dim>::Zero();
                step(a, b) = 0.5;  // central differences of a quadratic are exact
                const double slope = energyDensity<Dim>(w, B, J + step) - energyDensity<Dim>(w, B, J - step);
                QVERIFY(std::abs(slope - P(a, b)) < 1e-12 * P.norm());
            }
        QVERIFY(std::abs(0.5 * (J.transpose() * P).trace() - energyDensity<Dim>(w, B, J)) <
                1e-13 * P.norm() * J.norm());
    }
}

template <int Dim>
void stressMatrixIsStress() {
    std::mt19937 random(3);
    for (double fraction : kFractions)
        for (int i = 0; i < 20; ++i) {
            const auto w = EnergyWeights::of(fraction * phi::conformal(Dim));
            const Mat<Dim> B = randomAnisotropy<Dim>(random, 10), J = randomMatrix<Dim, Dim>(random);
            const auto D = stressMatrix<Dim>(w, B);
            const Strain<Dim> S = toMandel<Dim>(Mat<Dim>(J + Mat<Dim>(J.transpose())));
            QVERIFY((fromMandel<Dim>(D * S) - stress<Dim>(w, B, J)).norm() < 1e-13 * D.norm() * S.norm());
            QVERIFY(std::abs(0.25 * S.dot(D * S) - energyDensity<Dim>(w, B, J)) <
                    1e-13 * D.norm() * S.squaredNorm());
            QVERIFY(D == D.transpose());
            const Eigen::SelfAdjointEigenSolver<StressMatrix<Dim>> eigen(D);
            if (fraction < 1)
                QVERIFY(eigen.eigenvalues()[0] > 0);
            else
                QVERIFY(eigen.eigenvalues()[0] > -1e-14 * D.norm());
        }
    // Beyond φ_CONF a dilation has negative energy.
    const auto beyond = EnergyWeights::of(phi::conformal(Dim) + 0.01);
    QVERIFY(energyDensity<Dim>(beyond, Mat<Dim>::Identity(), Mat<Dim>::Identity()) < 0);
}

/// Unit directions and weights that integrate polynomials of degree ≤ 9 exactly: trapezoid on the circle,
/// times 5 Gauss points in the height on the sphere.
struct Direction {
    Vec3 r;
    double weight;
};
std::vector<Direction> directions(int dim) {
    constexpr int kAround = 16;
    std::vector<std::pair<double, double>> heights{{0, 1}};
    if (dim == 3)
        heights = {{-0.9061798459386640, 0.2369268850561891 / 2},
                   {-0.5384693101056831, 0.4786286704993665 / 2},
                   {0, 0.5688888888888889 / 2},
                   {0.5384693101056831, 0.4786286704993665 / 2},
                   {0.9061798459386640, 0.2369268850561891 / 2}};
    std::vector<Direction> result;
    for (const auto& [z, weight] : heights)
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * std::numbers::pi * i / kAround, r = std::sqrt(1 - z * z);
            result.push_back({{r * std::cos(angle), r * std::sin(angle), z}, weight / kAround});
        }
    return result;
}

/// The mean of (rᵀ S r)² over unit directions, and of (rᵀ S t)² over pairs of orthogonal ones (paper, Eqs. 6
/// and 9: the rates at which lengths and right angles change).
struct Means {
    double length = 0, angle = 0;
};
Means means(const Mat3& S, int dim) {
    Means result;
    for (const auto& [r, weight] : directions(dim)) {
        result.length += weight * std::pow(r.dot(S * r), 2);
        const Vec3 a = dim == 2 ? Vec3(-r[1], r[0], 0) : r.unitOrthogonal();
        if (dim == 2) {
            result.angle += weight * std::pow(r.dot(S * a), 2);
            continue;
        }
        const Vec3 b = r.cross(a);
        for (const auto& [t, turn] : directions(2))
            result.angle += weight * turn * std::pow(r.dot(S * (t[0] * a + t[1] * b)), 2);
    }
    return result;
}

/// paper, Eqs. 7 and 10: METR is the mean squared change of length, CONF that of right angles, up to the
/// constants d (d + 2) / 2 and (d + 2)(d − 1) (times w_q) that make ‖S‖² appear once.
template <int Dim>
void closedFormsAreQuadratures() {
    std::mt19937 random(4);
    for (int i = 0; i < 10; ++i) {
        const Mat<Dim> J = randomMatrix<Dim, Dim>(random);
        Mat3 S = Mat3::Zero();
        S.template topLeftCorner<Dim, Dim>() = J + Mat<Dim>(J.transpose());
        const auto mean = means(S, Dim);
        const Mat<Dim> I = Mat<Dim>::Identity();
        const auto metr = EnergyWeights::of(phi::kMetr), conf = EnergyWeights::of(phi::conformal(Dim));
        const double scale = S.squaredNorm();
        QVERIFY(std::abs(energyDensity<Dim>(metr, I, J) - metr.q * Dim * (Dim + 2) / 2 * mean.length) <
                1e-13 * scale);
        QVERIFY(std::abs(energyDensity<Dim>(conf, I, J) - conf.q * (Dim + 2) * (Dim - 1) * mean.angle) <
                1e-13 * scale);
    }
}

template <int Dim>
void polarFactor() {
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        Mat<Dim> F = randomMatrix<Dim, Dim>(random);
        if (F.determinant() < 0) F.col(0) *= -1;
        if (i % 4 == 0) F.col(1) *= 1e-6;  // nearly flat
        const Mat<Dim> R = polarRotation<Dim>(F), U = R.transpose() * F;
        QVERIFY((R.transpose() * R - Mat<Dim>::Identity()).norm() < 1e-13);
        QVERIFY(R.determinant() > 0);
        QVERIFY((U - Mat<Dim>(U.transpose())).norm() < 1e-12);
        QVERIFY(Eigen::SelfAdjointEigenSolver<Mat<Dim>>(U).eigenvalues()[0] > 0);
    }
}

template <int Dim>
void hatGradients() {
    std::mt19937 random(6);
    const auto mesh = unitGrid<Dim>(2, 0.2, random);
    const Mat<Dim> J = randomMatrix<Dim, Dim>(random);
    const auto v = affineField<Dim>(mesh.points, J, Vec<Dim>::Ones());
    for (auto cell : mesh.cells) {
        const auto geometry = cellGeometry<Dim>(mesh.points, cell);
        Mat<Dim> found = Mat<Dim>::Zero();
        for (int k = 0; k <= Dim; ++k) found += v.col(cell[k]) * geometry.gradients.col(k).transpose();
        QVERIFY((found - J).norm() < 1e-13);
        QVERIFY(std::abs(geometry.measure - cellMeasure<Dim>(mesh.points, cell)) < 1e-16);
        std::swap(cell[0], cell[1]);
        QVERIFY(cellGeometry<Dim>(mesh.points, cell).measure < 0);
    }
}

template <typename Action>
std::string reasonOf(Action&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.reason();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

template <int Dim>
void materialChecks() {
    const auto reason = [](const Material<Dim>& material) {
        return reasonOf([&] { requireValid<Dim>(material, 3); });
    };
    const auto uniform = [](double phi) { return Material<Dim>::uniform(3, phi); };
    const double end = phi::conformal(Dim);
    for (double good : {1e-6, phi::kEquia, phi::kMetr, phi::kAkvf, end, std::nextafter(end, 4.0)})
        QVERIFY(reason(uniform(good)).empty());
    const std::string range = Dim == 2 ? "]0, 2.677945045]" : "]0, 2.498091545]";
    for (double bad : {0.0, -0.1, end + 1e-9, std::nan("")}) QVERIFY(contains(reason(uniform(bad)), range));
    auto second = uniform(1);
    second.phi[1] = 3;
    QVERIFY(contains(reason(second), "cell 1"));
    second.phi.pop_back();
    QVERIFY(contains(reason(second), "2 values of phi for 3 cells"));

    auto material = uniform(1);
    material.anisotropy.assign(3, Mat<Dim>::Identity());
    QVERIFY(reason(material).empty());
    material.anisotropy[2](0, 1) = 0.1;
    QVERIFY(contains(reason(material), "cell 2: B is not symmetric"));
    material.anisotropy[2] = -Mat<Dim>::Identity();
    QVERIFY(contains(reason(material), "cell 2: B is not positive definite"));
    material.anisotropy[2](0, 0) = std::nan("");
    QVERIFY(contains(reason(material), "cell 2"));
    material.anisotropy.pop_back();
    QVERIFY(contains(reason(material), "2 values of B for 3 cells"));
    auto rough = uniform(1);
    rough.smoothing.length = -1;
    QVERIFY(contains(reason(rough), "smoothing length"));
}

}  // namespace

class TestEnergy : public QObject {
    Q_OBJECT

  private slots:
    void zeroEnergy() {
        rigidAndSimilarFields<2>();
        rigidAndSimilarFields<3>();
    }
    void stresses() {
        stressIsTheDerivative<2>();
        stressIsTheDerivative<3>();
    }
    void stressMatrices() {
        stressMatrixIsStress<2>();
        stressMatrixIsStress<3>();
    }
    void quadrature() {
        closedFormsAreQuadratures<2>();
        closedFormsAreQuadratures<3>();
    }
    void rotation() {
        polarFactor<2>();
        polarFactor<3>();
    }
    void gradients() {
        hatGradients<2>();
        hatGradients<3>();
    }
    void material() {
        materialChecks<2>();
        materialChecks<3>();
    }
};

QTEST_APPLESS_MAIN(TestEnergy)
#include "test_energy.moc"
