#include "warp/cell_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace wend {
namespace {

constexpr double kAnisotropy = 8;  // longest axis of an ellipse in pixels of its level
constexpr double kBlendBegin =
    1.01;  // stretch up to which bicubic is good enough: rotations are 1 up to rounding
constexpr double kBlendWidth = 0.34;  // width of the transition to elliptical filtering

/// Singular values of a 2 × 2 matrix, largest first, and the left singular vectors: the eigenvalues' roots
/// and eigenvectors of J Jᵀ.
class LeftSingular {
  public:
    explicit LeftSingular(const Mat2& J) {
        const Mat2 square = J * J.transpose();
        const double mean = (square(0, 0) + square(1, 1)) / 2;
        m_difference = (square(0, 0) - square(1, 1)) / 2, m_mixed = square(0, 1);
        const double radius = std::sqrt(m_difference * m_difference + m_mixed * m_mixed);
        m_values = Vec2(std::sqrt(mean + radius), std::sqrt(std::max(0.0, mean - radius)));
    }
    const Vec2& values() const { return m_values; }
    /// Returns the vectors as columns.
    Mat2 vectors() const {
        const double angle = std::atan2(m_mixed, m_difference) / 2;
        Mat2 result;
        result << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        return result;
    }

  private:
    double m_difference, m_mixed;
    Vec2 m_values;
};

}  // namespace

CellMap::CellMap(const Points2& rest, const Points2& pose, const Cell<2>& cell)
    : anchor(pose.col(cell[0])), displacement(pose.col(cell[0]) - rest.col(cell[0])) {
    Mat2 edges, change;
    for (int k = 0; k < 2; ++k) {
        edges.col(k) = pose.col(cell[k + 1]) - pose.col(cell[0]);
        change.col(k) = (pose.col(cell[k + 1]) - rest.col(cell[k + 1])) - displacement;
    }
    gradient = change * edges.inverse();
    exact = gradient.allFinite() && gradient.cwiseAbs().maxCoeff() < 1e6;
    // A triangle without area has no inverse; it covers nothing, but for positions that rounding gives it.
    if (!gradient.allFinite()) gradient.setZero();
}

CellFilter::CellFilter(const Mat2& jacobian, Filter filter, int levels) {
    if (filter == Filter::Nearest) return;
    const LeftSingular singular(jacobian);
    const Vec2& stretch = singular.values();
    // Elliptical filters average themselves: they need fewer levels, and a level above the picture softens
    // it.
    const double reduce =
        filter == Filter::Ewa ? std::max(stretch[1] / 2, stretch[0] / kAnisotropy) : stretch[1];
    if (reduce > 1) level = static_cast<int>(std::min(levels - 1.0, std::floor(std::log2(reduce) + 0.5)));
    shrink = std::ldexp(1.0, -level);
    if (filter != Filter::Ewa) return;
    const Vec2 axes = (stretch * shrink).cwiseMax(1.0).cwiseMin(2 * kAnisotropy);  // where levels end
    blend = static_cast<float>(std::clamp((axes[0] - kBlendBegin) / kBlendWidth, 0.0, 1.0));
    const Mat2 vectors = singular.vectors();
    const Mat2 metric = vectors * axes.cwiseAbs2().cwiseInverse().asDiagonal() * vectors.transpose();
    ellipse.xx = static_cast<float>(metric(0, 0)), ellipse.xy = static_cast<float>(metric(0, 1));
    ellipse.yy = static_cast<float>(metric(1, 1));
    const Vec2 reach = 2 * (vectors * axes.asDiagonal()).rowwise().norm();
    ellipse.wholeReach = (reach.array() - 1e-6).ceil().cast<int>().max(2) - 1;
}

}  // namespace wend
