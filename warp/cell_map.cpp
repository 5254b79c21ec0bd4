#include "warp/cell_map.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace wend {
namespace {

constexpr double kAnisotropy = 8;     // longest axis of an ellipse in pixels of its level
constexpr double kBlendWidth = 0.35;  // stretch over which bicubic goes over into elliptical

}  // namespace

CellMap::CellMap(const Points<2>& rest, const Points<2>& pose, const Cell<2>& cell)
    : anchor(pose.col(cell[0])), displacement(pose.col(cell[0]) - rest.col(cell[0])) {
    Mat<2> edges, change;
    for (int k = 0; k < 2; ++k) {
        edges.col(k) = pose.col(cell[k + 1]) - pose.col(cell[0]);
        change.col(k) = (pose.col(cell[k + 1]) - rest.col(cell[k + 1])) - displacement;
    }
    gradient = change * edges.inverse();
}

CellFilter::CellFilter(const Mat<2>& jacobian, Filter filter, int levels) {
    const Eigen::JacobiSVD<Mat<2>> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Vec<2> stretch = svd.singularValues();
    // Elliptical filters need two levels less: they average themselves, and a level above the picture softens
    // it.
    const double reduce =
        filter == Filter::Ewa ? std::max(stretch[1] / 2, stretch[0] / kAnisotropy) : stretch[1];
    if (filter != Filter::Nearest && reduce > 1)
        level = std::min(levels - 1, static_cast<int>(std::floor(std::log2(reduce) + 0.5)));
    if (filter != Filter::Ewa) return;
    const Vec<2> axes = (stretch / std::ldexp(1.0, level)).cwiseMax(1.0);
    ellipse = std::clamp((axes[0] - 1) / kBlendWidth, 0.0, 1.0);
    inverse = axes.cwiseInverse().asDiagonal() * svd.matrixU().transpose();
    const Mat<2> forward = svd.matrixU() * axes.asDiagonal();
    reach = 2 * forward.rowwise().norm();
}

}  // namespace wend
