// Distortion measures: zero where nothing is lost, the closed forms on stretched shapes, totals and the worst
// cell.
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <QTest>

#include "core/energy/distortion.h"
#include "tests/core/test_energy_samples.h"
#include "tests/support/simd_targets.h"

using namespace wend;
using namespace wend::test;

namespace {

template <int Dim>
Mat<Dim> rotation();
template <>
Mat2 rotation<2>() {
    return Eigen::Rotation2Dd(0.7).toRotationMatrix();
}
template <>
Mat3 rotation<3>() {
    return Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
}

template <int Dim>
void rigidIsNothing(bool negative) {
    std::mt19937 random(1);
    auto mesh = unitGrid<Dim>(3, 0.2, random);
    if (negative)
        for (auto& cell : mesh.cells) std::swap(cell[0], cell[1]);
    const auto d = distortion<Dim>(mesh, affineField<Dim>(mesh.points, rotation<Dim>(), Vec<Dim>::Ones()));
    for (double total : {d.totalAngle, d.totalVolume, d.totalMetric}) QVERIFY(std::abs(total) < 1e-24);
    QCOMPARE(d.flips, 0);
    QVERIFY(std::abs(d.minDet - 1) < 1e-12);
}

/// method.md's forms, written out for one stretch σ.
template <int Dim>
void stretched(const Vec<Dim>& s) {
    std::mt19937 random(2);
    const auto mesh = unitGrid<Dim>(3, 0.2, random);
    const Mat<Dim> F = rotation<Dim>() * s.asDiagonal() * rotation<Dim>();
    const auto d = distortion<Dim>(mesh, affineField<Dim>(mesh.points, F, Vec<Dim>::Zero()));
    double angle, volume = s.prod() + 1 / s.prod() - 2, metric;
    if constexpr (Dim == 2) {
        angle = s[0] / s[1] + s[1] / s[0] - 2;
        metric = std::pow(s[0] - 1, 2) + std::pow(s[1] - 1, 2) - std::pow(s[0] - s[1], 2) / 4;
    } else {
        angle = s[0] / s[1] + s[1] / s[0] + s[0] / s[2] + s[2] / s[0] + s[1] / s[2] + s[2] / s[1] - 6;
        metric = std::pow(s[0] - 1, 2) + std::pow(s[1] - 1, 2) + std::pow(s[2] - 1, 2) -
                 (std::pow(s[0] - s[1], 2) + std::pow(s[0] - s[2], 2) + std::pow(s[1] - s[2], 2)) / 5;
    }
    for (int c = 0; c < mesh.cellCount(); ++c) {
        QVERIFY(std::abs(d.angle[c] - angle) < 1e-11);
        QVERIFY(std::abs(d.volume[c] - volume) < 1e-11);
        QVERIFY(std::abs(d.metric[c] - metric) < 1e-11);
        QVERIFY(std::abs(d.ratio[c] - s.prod()) < 1e-11);
    }
    QVERIFY(std::abs(d.totalAngle - angle) < 1e-11);
    QVERIFY(std::abs(d.totalVolume - volume) < 1e-11);
    QVERIFY(std::abs(d.totalMetric - metric) < 1e-11);
}

/// The forms of method.md are evaluated with the singular values of another method, from nearly rigid to
/// nearly flat, and with two that are nearly equal.
template <int Dim>
void anyMap() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-1, 1);
    SimplicialMesh<Dim> mesh = unitGrid<Dim>(1, 0, random);
    for (int i = 0; i < 4000; ++i) {
        const double spread = std::pow(10.0, -6 + 8.0 * i / 4000);
        Vec<Dim> s;
        for (int k = 0; k < Dim; ++k) s[k] = std::exp(spread / 25 * exponent(random));
        if (i % 3 == 0) s[1] = s[0] * (1 + 1e-7 * exponent(random));
        const Mat<Dim> F = rotation<Dim>() * s.asDiagonal() * rotation<Dim>();
        const auto d = distortion<Dim>(mesh, affineField<Dim>(mesh.points, F, Vec<Dim>::Zero()));
        const Vec<Dim> sigma = Eigen::JacobiSVD<Mat<Dim>>(F).singularValues();
        double angle = 0, metric = (sigma.array() - 1).square().sum();
        for (int j = 0; j < Dim; ++j)
            for (int k = 0; k < j; ++k) {
                angle += std::pow(sigma[j] - sigma[k], 2) / (sigma[j] * sigma[k]);
                metric -= std::pow(sigma[j] - sigma[k], 2) / (Dim + 2);
            }
        // Rounding of F is in both: relative to the largest σ, and squared where σ is far from 1.
        const double rounding = 1e-13 * std::pow(sigma.maxCoeff() / sigma.minCoeff(), 2) * (1 + angle);
        QVERIFY2(std::abs(d.angle[0] - angle) < 1e-9 * angle + rounding * spread + 1e-26,
                 qPrintable(QString::number(d.angle[0]) + ' ' + QString::number(angle)));
        QVERIFY2(std::abs(d.metric[0] - metric) < 1e-9 * std::abs(metric) + rounding * spread + 1e-26,
                 qPrintable(QString::number(d.metric[0]) + ' ' + QString::number(metric)));
    }
}

template <int Dim>
void weightedTotals() {
    std::mt19937 random(3);
    auto mesh = unitGrid<Dim>(2, 0.2, random);
    const Points<Dim> pose = mesh.points + 0.03 * randomField<Dim>(random, mesh.vertexCount());
    const auto d = distortion<Dim>(mesh, pose);
    double metric = 0, measure = 0, worst = 0;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const double V = cellMeasure<Dim>(mesh.points, mesh.cells[c]);
        metric += V * d.metric[c];
        measure += V;
        worst = std::max(worst, d.metric[c]);
    }
    QVERIFY(std::abs(d.totalMetric - metric / measure) < 1e-14);
    QCOMPARE(d.metric[d.worstCell], worst);
    QVERIFY(d.minDet < 1);
}

/// Each cell is measured as if it were alone, for any number of cells, even if another one is far from rigid.
template <int Dim>
void cellsAreMeasuredOneByOne() {
    std::mt19937 random(6);
    const auto mesh = unitGrid<Dim>(Dim == 2 ? 13 : 5, 0.2, random);
    Points<Dim> pose = mesh.points + 0.02 * randomField<Dim>(random, mesh.vertexCount());
    for (Eigen::Index v = 0; v < pose.cols(); v += 7) pose.col(v) *= 3;
    const auto all = distortion<Dim>(mesh, pose);
    QVERIFY(mesh.cellCount() > 300 && all.flips > 0 && all.flips < mesh.cellCount() / 2);
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const auto one = distortion<Dim>(SimplicialMesh<Dim>{mesh.points, {mesh.cells[c]}}, pose);
        QCOMPARE(all.angle[c], one.angle[0]);
        QCOMPARE(all.volume[c], one.volume[0]);
        QCOMPARE(all.metric[c], one.metric[0]);
        QCOMPARE(all.ratio[c], one.ratio[0]);
    }
}

template <int Dim>
void flipsAreCounted() {
    std::mt19937 random(4);
    const auto mesh = unitGrid<Dim>(3, 0, random);
    Points<Dim> pose = mesh.points;
    pose.row(0) *= -1;
    const auto d = distortion<Dim>(mesh, pose);
    QCOMPARE(d.flips, mesh.cellCount());
    QVERIFY(std::abs(d.minDet + 1) < 1e-12);
    // A cell without area has no inverse either.
    pose.row(0).setZero();
    const auto flat = distortion<Dim>(mesh, pose);
    QCOMPARE(flat.flips, mesh.cellCount());
    QCOMPARE(flat.minDet, 0.0);
}

}  // namespace

class TestDistortion : public QObject {
    Q_OBJECT

  private slots:
    void oneByOne() {
        onEveryTarget([](SimdTarget) {
            cellsAreMeasuredOneByOne<2>();
            cellsAreMeasuredOneByOne<3>();
        });
    }
    void rigid() {
        for (bool negative : {false, true}) {
            onEveryTarget([&](SimdTarget) {
                rigidIsNothing<2>(negative);
                rigidIsNothing<3>(negative);
            });
        }
    }
    void maps() {
        onEveryTarget([](SimdTarget) {
            anyMap<2>();
            anyMap<3>();
        });
    }
    void closedForms() {
        stretched<2>({1.5, 0.8});
        stretched<2>({0.3, 0.3});
        stretched<3>({1.5, 0.8, 1.1});
        stretched<3>({2, 2, 0.25});
    }
    void totals() {
        weightedTotals<2>();
        weightedTotals<3>();
    }
    void flips() {
        flipsAreCounted<2>();
        flipsAreCounted<3>();
    }
};

QTEST_APPLESS_MAIN(TestDistortion)
#include "test_distortion.moc"
