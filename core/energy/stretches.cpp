#include "core/energy/stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/system/run_time_dispatch.h"

namespace wend {
namespace {

constexpr double kNothing = std::numeric_limits<double>::min();  // instead of 0, to divide by
constexpr double kLeast = 0.05, kMost = 20;  // of the eigenvalues of FᵀF: between them σ is exact
// The cosine c of a third of an angle whose cosine is r: c = ½ + t with t √(6 + 4t) = √(1 + r), which is
// smooth. The guess is off by a thousandth, each step of Newton's squares that.
constexpr double kGuess = 0.408248, kBend = 0.0387;
constexpr int kSteps = 3;

}  // namespace

/// Half the sum and half the difference of both, each of a conformal or anticonformal part of F.
WEND_CLONES void computeStretches(Stretches<2>& cells) {
    for (int i = 0; i < Stretches<2>::kCells; ++i) {
        const double a = cells.maps[0][i], b = cells.maps[1][i], c = cells.maps[2][i], d = cells.maps[3][i];
        const double kept = std::sqrt((a + d) * (a + d) + (b - c) * (b - c)),
                     lost = std::sqrt((a - d) * (a - d) + (b + c) * (b + c));
        cells.sigma[0][i] = (kept + lost) / 2;
        cells.sigma[1][i] = std::abs(kept - lost) / 2;
        cells.determinant[i] = a * d - b * c;
        cells.isExact[i] = true;
    }
}

/// √(1 + δ) of the eigenvalues δ of the strain FᵀF − I, which is 0 where F is rigid, by the cosines of a
/// third of an angle.
WEND_CLONES void computeStretches(Stretches<3>& cells) {
    const auto& m = cells.maps;
    for (int i = 0; i < Stretches<3>::kCells; ++i) {
        const double a = m[0][i], b = m[1][i], c = m[2][i], d = m[3][i], e = m[4][i], f = m[5][i],
                     g = m[6][i], h = m[7][i], k = m[8][i];
        double xx = a * a + b * b + c * c - 1, yy = d * d + e * e + f * f - 1, zz = g * g + h * h + k * k - 1;
        const double xy = a * d + b * e + c * f, xz = a * g + b * h + c * k, yz = d * g + e * h + f * k;
        const double mean = (xx + yy + zz) / 3;
        xx -= mean, yy -= mean, zz -= mean;
        const double squares = (xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)) / 6,
                     size = std::sqrt(squares), cube = std::max(2 * squares * size, kNothing);
        const double D = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        const double r = std::min(std::max(D / cube, -1.0), 1.0);
        const double root = std::sqrt(1 + r);
        double t = root * (kGuess - kBend * root);
        for (int step = 0; step < kSteps; ++step)
            t -= (t * (6 + 4 * t) - root * std::sqrt(6 + 4 * t)) / (6 + 6 * t);
        const double cosine = size * (0.5 + t), sine = size * std::sqrt(3 * (0.5 - t) * (1.5 + t));
        const double most = 1 + mean + 2 * cosine, middle = 1 + mean + sine - cosine,
                     least = 1 + mean - sine - cosine;
        cells.sigma[0][i] = std::sqrt(std::abs(most));
        cells.sigma[1][i] = std::sqrt(std::abs(middle));
        cells.sigma[2][i] = std::sqrt(std::abs(least));
        cells.determinant[i] = a * (e * k - f * h) - d * (b * k - c * h) + g * (b * f - c * e);
        cells.isExact[i] = (least > kLeast) & (most < kMost);  // without a branch
    }
}

}  // namespace wend
