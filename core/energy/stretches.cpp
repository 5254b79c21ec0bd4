#include "core/energy/stretches.h"

#include <limits>

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/energy/stretches.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wend::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

constexpr double kNothing = std::numeric_limits<double>::min();  // instead of 0, to divide by
constexpr double kLeast = 0.05, kMost = 20;  // of the eigenvalues of FᵀF: between them σ is exact
// The cosine c of a third of an angle whose cosine is r: c = ½ + t with t √(6 + 4t) = √(1 + r), which is
// smooth. The guess is off by a thousandth, each step of Newton's squares that.
constexpr double kGuess = 0.408248, kBend = 0.0387;
constexpr int kSteps = 3;

HWY_INLINE V set(double value) {
    return hn::Set(D(), value);
}
HWY_INLINE V load(const double* p) {
    return hn::LoadU(D(), p);
}
HWY_INLINE void store(V v, double* p) {
    hn::StoreU(v, D(), p);
}
HWY_INLINE V dot(V a, V b, V c, V d, V e, V f) {
    return hn::MulAdd(a, b, hn::MulAdd(c, d, e * f));
}
HWY_INLINE V minor(V a, V b, V c, V d) {
    return hn::MulSub(a, d, b * c);
}

/// The symmetric matrix FᵀF − I, its mean taken off its diagonal.
struct Strain {
    V xx, yy, zz, xy, xz, yz, mean;
};
/// Returns the strain FᵀF − I of several maps: its diagonal, then the entries (0, 1), (0, 2) and (1, 2).
HWY_INLINE Strain strainOf(const V (&F)[9]) {
    const auto product = [&](int i, int j) HWY_ATTR {
        return dot(F[3 * i], F[3 * j], F[3 * i + 1], F[3 * j + 1], F[3 * i + 2], F[3 * j + 2]);
    };
    Strain s{product(0, 0) - set(1),
             product(1, 1) - set(1),
             product(2, 2) - set(1),
             product(0, 1),
             product(0, 2),
             product(1, 2),
             set(0)};
    s.mean = (s.xx + s.yy + s.zz) * set(1.0 / 3);
    s.xx = s.xx - s.mean, s.yy = s.yy - s.mean, s.zz = s.zz - s.mean;
    return s;
}

/// Returns t = cos(⅓ arccos r) − ½ for r in [−1, 1], the root of t √(6 + 4t) = √(1 + r): three Newton steps
/// from a guess that is linear in √(1 + r). In √(1 + r) the function is smooth, whereas in r its slope is
/// infinite at −1, where two eigenvalues are equal.
HWY_INLINE V thirdOfAngle(V r) {
    const V root = hn::Sqrt(set(1) + r);
    V t = root * hn::NegMulAdd(set(kBend), root, set(kGuess));
    for (int step = 0; step < kSteps; ++step) {
        const V inner = hn::MulAdd(set(4), t, set(6));
        t = t - (hn::MulSub(t, inner, root * hn::Sqrt(inner))) / hn::MulAdd(set(6), t, set(6));
    }
    return t;
}

}  // namespace

/// Computes σ as half the sum and half the difference of the lengths of the conformal and the anticonformal
/// part of F.
void stretchesInPlane(Stretches<2>& cells) {
    for (int i = 0; i < Stretches<2>::kCells; i += static_cast<int>(hn::Lanes(D()))) {
        const auto& m = cells.maps;
        const V a = load(&m[0][i]), b = load(&m[1][i]), c = load(&m[2][i]), d = load(&m[3][i]);
        const V kept = hn::Sqrt(hn::MulAdd(a + d, a + d, (b - c) * (b - c))),
                lost = hn::Sqrt(hn::MulAdd(a - d, a - d, (b + c) * (b + c)));
        store(set(0.5) * (kept + lost), &cells.sigma[0][i]);
        store(set(0.5) * hn::Abs(kept - lost), &cells.sigma[1][i]);
        store(minor(a, b, c, d), &cells.determinant[i]);
    }
    for (bool& exact : cells.isExact) exact = true;
}

/// Computes σ = √(1 + δ) with the eigenvalues δ of the strain E = FᵀF − I, which is 0 where F is rigid. With
/// the mean m = ⅓ Tr E, the deviator E − m I, p² = ⅙ ‖E − m I‖² and r = det(E − m I) / (2p³), the eigenvalues
/// are m + 2p cos θ and m − p cos θ ± √3 p sin θ, θ = ⅓ arccos r (Smith 1961). sin θ follows from the factors
/// of 1 − cos² θ, without cancellation at small angles. Rounding may put r outside of [−1, 1], and p may be
/// 0; hence the bounds.
void stretchesInSpace(Stretches<3>& cells) {
    for (int i = 0; i < Stretches<3>::kCells; i += static_cast<int>(hn::Lanes(D()))) {
        V F[9];
#pragma GCC unroll 9
        for (int k = 0; k < 9; ++k) F[k] = load(&cells.maps[k][i]);
        const Strain s = strainOf(F);
        const V squares = hn::MulAdd(set(2), dot(s.xy, s.xy, s.xz, s.xz, s.yz, s.yz),
                                     dot(s.xx, s.xx, s.yy, s.yy, s.zz, s.zz)) *
                          set(1.0 / 6);
        const V size = hn::Sqrt(squares), cube = hn::Max(set(2) * squares * size, set(kNothing));
        const V determinant = dot(s.xx, minor(s.yy, s.yz, s.yz, s.zz), s.xy, minor(s.yz, s.zz, s.xy, s.xz),
                                  s.xz, minor(s.xy, s.yy, s.xz, s.yz));
        const V t = thirdOfAngle(hn::Min(hn::Max(determinant / cube, set(-1)), set(1)));
        const V cosine = size * (set(0.5) + t),
                sine = size * hn::Sqrt(set(3) * (set(0.5) - t) * (set(1.5) + t)), centre = set(1) + s.mean;
        const V most = hn::MulAdd(set(2), cosine, centre), middle = centre + (sine - cosine),
                least = centre - sine - cosine;
        store(hn::Sqrt(hn::Abs(most)), &cells.sigma[0][i]);
        store(hn::Sqrt(hn::Abs(middle)), &cells.sigma[1][i]);
        store(hn::Sqrt(hn::Abs(least)), &cells.sigma[2][i]);
        store(dot(F[0], minor(F[4], F[5], F[7], F[8]), F[3], minor(F[7], F[8], F[1], F[2]), F[6],
                  minor(F[1], F[2], F[4], F[5])),
              &cells.determinant[i]);
        HWY_ALIGN double exact[HWY_LANES(double)];
        store(hn::IfThenElseZero(hn::And(least > set(kLeast), most < set(kMost)), set(1)), exact);
        for (int k = 0; k < static_cast<int>(hn::Lanes(D())); ++k) cells.isExact[i + k] = exact[k] != 0;
    }
}

}  // namespace wend::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend {
namespace {

HWY_EXPORT(stretchesInPlane);
HWY_EXPORT(stretchesInSpace);

}  // namespace

void computeStretches(Stretches<2>& cells) {
    HWY_DYNAMIC_DISPATCH(stretchesInPlane)(cells);
}
void computeStretches(Stretches<3>& cells) {
    HWY_DYNAMIC_DISPATCH(stretchesInSpace)(cells);
}

}  // namespace wend
#endif
