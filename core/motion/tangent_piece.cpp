#include "core/motion/tangent_piece.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/mesh/decompositions.h"

namespace wend {

namespace {

constexpr double kFlat =
    1e-10;                      // relative singular value of the hodograph's coefficients that counts as zero
constexpr double kRoot = 1e-9;  // relative size of the hodograph that counts as a common root

/// Returns the sign of a + b v + c v² just after 0, where it may vanish: that of the first coefficient that
/// is not 0 relative to the scale.
double signAfterZero(double a, double b, double c, double scale) {
    for (const double coefficient : {a, b, c}) {
        if (std::abs(coefficient) > kRoot * scale) return coefficient > 0 ? 1 : -1;
    }
    return 1;
}

}  // namespace

/// Classifies the piece by the rank of the hodograph's three coefficients: with one singular value it is
/// straight, with two planar, with three spatial. Then its normal is the direction of the least one.
TangentPiece::TangentPiece(const CurvePiece<3>& piece, double size) {
    const auto& c = piece.coefficients;
    m_c = {c.col(1), c.col(2), c.col(3)};
    m_g = {c.col(1), 2 * c.col(2), 3 * c.col(3)};
    Mat3 columns;
    columns << m_g[0], m_g[1], m_g[2];
    const auto [U, V, sigma] = singularValueDecomposition<3>(columns);
    if (!(sigma[0] > 1e-13 * size)) return;
    if (sigma[1] <= kFlat * sigma[0]) {
        makeStraight(U.col(0));
        return;
    }
    m_shape = sigma[2] <= kFlat * sigma[0] ? Shape::Planar : Shape::Spatial;
    m_normal = U.col(2);
    if (m_normal.cwiseAbs()[2] > 1 - 1e-12) m_normal = Vec3::UnitZ();  // exact in the plane z = 0
    if (m_shape == Shape::Planar) dividePlanarCusp();
}

void TangentPiece::makeStraight(const Vec3& line) {
    m_shape = Shape::Straight;
    const double a = line.dot(m_g[0]), b = line.dot(m_g[1]), c = line.dot(m_g[2]);
    const double scale = std::abs(a) + std::abs(b) + std::abs(c);
    const double start = signAfterZero(a, b, c, scale);
    m_endSign = start * signAfterZero(a + b + c, -(b + 2 * c), c, scale);
    m_g = {start * line, Vec3::Zero(), Vec3::Zero()};
}

/// h = a + b v + c v² with a common root r is (v − r)(b + c r + c v), and h × h′ = a×b + 2v a×c + v² b×c then
/// has the double root r = −(a×c) / (b×c).
void TangentPiece::dividePlanarCusp() {
    const auto [a, b, c] = m_g;
    const double curl = m_normal.dot(b.cross(c));
    const double scale = a.norm() + b.norm() + c.norm();
    if (std::abs(curl) <= kRoot * scale * scale)
        return;  // with a common root as well the piece would be straight
    const double r = -m_normal.dot(a.cross(c)) / curl;
    if (r < -kRoot || r > 1 + kRoot || (a + r * (b + r * c)).norm() > kRoot * scale) return;
    const double sign = r <= kRoot ? 1 : -1;
    m_g = {sign * (b + c * r), sign * c, Vec3::Zero()};
    m_endSign = r > kRoot && r < 1 - kRoot ? -1 : 1;
}

Vec3 TangentPiece::tangent(double v) const {
    return direction(v).normalized();
}

Vec3 TangentPiece::binormal(double v) const {
    if (m_shape != Shape::Spatial) return m_normal;
    return direction(v).cross(directionRate(v)).normalized();
}

/// Returns d/dv (g / |g|).
Vec3 TangentPiece::tangentRate(double v) const {
    const Vec3 t = tangent(v), rate = directionRate(v);
    return (rate - t * t.dot(rate)) / direction(v).norm();
}

/// Returns det(g, g′, g″) |g| / |g × g′|².
double TangentPiece::torsionRate(double v) const {
    const Vec3 g = direction(v), cross = g.cross(directionRate(v));
    return cross.dot(2 * m_g[2]) * g.norm() / cross.squaredNorm();
}

Vec3 TangentPiece::chord(double v, double w) const {
    return m_c[0] + (v + w) * m_c[1] + (v * v + v * w + w * w) * m_c[2];
}

}  // namespace wend
