#pragma once

#include <vector>

#include "core/base/types.h"

namespace wend {

/// A cubic in the local parameter v ∈ [0, 1] over [from, to] of the curve's parameter u: Σ
/// coefficients.col(k) v^k.
template <int Dim>
struct CurvePiece {
    double from = 0, to = 1;
    Eigen::Matrix<double, Dim, 4> coefficients = Eigen::Matrix<double, Dim, 4>::Zero();

    double local(double u) const { return (u - from) / (to - from); }
    /// Returns the point at v.
    Vec<Dim> value(double v) const;
    /// Returns the derivative by u, not by v.
    Vec<Dim> rate(double v) const;
};

/// A continuous curve γ(u), u ∈ [0, 1], of cubic pieces.
template <int Dim>
struct Curve {
    std::vector<CurvePiece<Dim>> pieces;

    /// Returns the piece in [first, last[ that contains u (at a joint the later one). A u before `first`
    /// gives `first`, one after the last piece gives that. It takes logarithmic time.
    int locate(double u, int first, int last) const;
    /// Returns the first pieces of the intervals between jumps of γ′: 0 and every piece at whose start γ′
    /// jumps.
    std::vector<int> smoothStretches() const;
};

/// Returns a chain of cubics over 3k + 1 control points, each taking the same share of u. The number of
/// points must be 3k + 1 ≥ 4. Consecutive cubics share a control point; γ′ jumps there unless its neighbours
/// are in line with it at equal distances.
template <int Dim>
Curve<Dim> bezierCurve(const std::vector<Vec<Dim>>& points);
/// Returns the indices of the points that splines and polylines interpolate, without repetitions up to 1e-12
/// of the length, at least two. Piece k is between the k-th and the next. A point is left out if it is that
/// near to the last one that was kept; if all coincide, the first point counts twice.
template <int Dim>
std::vector<int> distinctPoints(const std::vector<Vec<Dim>>& points);
/// Returns the C² interpolating cubic spline with natural ends (γ″ = 0) over chord lengths. Two points give a
/// straight piece. Time is linear in the number of points, by a tridiagonal system (de Boor, A Practical
/// Guide to Splines, 1978).
template <int Dim>
Curve<Dim> splineCurve(const std::vector<Vec<Dim>>& points);
/// Returns straight pieces over chord lengths, hence with even speed.
template <int Dim>
Curve<Dim> polylineCurve(const std::vector<Vec<Dim>>& points);
/// Returns straight pieces over the given increasing times, mapped linearly to [0, 1]. There must be at least
/// two points, and as many times. Points that repeat are kept: the stroke rests there.
template <int Dim>
Curve<Dim> timedCurve(const std::vector<double>& times, const std::vector<Vec<Dim>>& points);

/// Returns the curve in space: itself, or with z = 0.
Curve<3> inSpace(const Curve<2>& curve);
inline const Curve<3>& inSpace(const Curve<3>& curve) {
    return curve;
}

}  // namespace wend
