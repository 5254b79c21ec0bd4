#include "core/motion/curve.h"

#include <algorithm>

namespace wend {

template <int Dim>
Vec<Dim> CurvePiece<Dim>::value(double v) const {
    const auto& c = coefficients;
    return c.col(0) + v * (c.col(1) + v * (c.col(2) + v * c.col(3)));
}

template <int Dim>
Vec<Dim> CurvePiece<Dim>::rate(double v) const {
    const auto& c = coefficients;
    return (c.col(1) + v * (2 * c.col(2) + 3 * v * c.col(3))) / (to - from);
}

template <int Dim>
int Curve<Dim>::locate(double u, int first, int last) const {
    const auto begin = pieces.begin() + first + 1;
    const auto later =
        std::upper_bound(begin, pieces.begin() + last, u,
                         [](double value, const CurvePiece<Dim>& p) { return value < p.from; });
    return static_cast<int>(later - pieces.begin()) - 1;
}

template <int Dim>
std::vector<int> Curve<Dim>::smoothStretches() const {
    std::vector<int> starts = {0};
    for (int i = 1; i < static_cast<int>(pieces.size()); ++i) {
        const Vec<Dim> before = pieces[i - 1].rate(1), after = pieces[i].rate(0);
        if ((after - before).norm() > 1e-9 * (after.norm() + before.norm())) starts.push_back(i);
    }
    return starts;
}

namespace {

template <int Dim>
CurvePiece<Dim> linearPiece(double from, double to, const Vec<Dim>& a, const Vec<Dim>& b) {
    CurvePiece<Dim> piece{from, to};
    piece.coefficients.col(0) = a;
    piece.coefficients.col(1) = b - a;
    return piece;
}

template <int Dim>
std::vector<Vec<Dim>> distinct(const std::vector<Vec<Dim>>& points) {
    std::vector<Vec<Dim>> kept;
    for (const int i : distinctPoints<Dim>(points)) kept.push_back(points[i]);
    return kept;
}

/// Returns a parameter for each point, from 0 to 1 exactly, in proportion to the summed chord lengths; all
/// are 0 but the last if the points coincide.
template <int Dim>
std::vector<double> chordKnots(const std::vector<Vec<Dim>>& points) {
    std::vector<double> knots = {0};
    for (size_t i = 1; i < points.size(); ++i)
        knots.push_back(knots.back() + (points[i] - points[i - 1]).norm());
    const double length = knots.back() > 0 ? knots.back() : 1;
    for (double& knot : knots) knot /= length;
    knots.back() = 1;
    return knots;
}

/// Returns γ″ at the knots of the natural spline, by the tridiagonal system h_{i−1} m_{i−1} + 2 (h_{i−1} +
/// h_i) m_i + h_i m_{i+1} = 6 (d_i − d_{i−1}) with d the chords' slopes and m = 0 at both ends.
template <int Dim>
std::vector<Vec<Dim>> naturalCurvatures(const std::vector<double>& t, const std::vector<Vec<Dim>>& p) {
    const int n = static_cast<int>(p.size());
    std::vector<Vec<Dim>> m(n, Vec<Dim>::Zero());
    std::vector<double> upper(n, 0.0);
    for (int i = 1; i + 1 < n; ++i) {
        const double left = t[i] - t[i - 1], right = t[i + 1] - t[i];
        const double pivot = 2 * (left + right) - left * upper[i - 1];
        const Vec<Dim> bend = 6 * ((p[i + 1] - p[i]) / right - (p[i] - p[i - 1]) / left);
        upper[i] = right / pivot;
        m[i] = (bend - left * m[i - 1]) / pivot;
    }
    for (int i = n - 2; i > 0; --i) m[i] -= upper[i] * m[i + 1];
    return m;
}

}  // namespace

/// A chord of length zero has no share of the time.
template <int Dim>
std::vector<int> distinctPoints(const std::vector<Vec<Dim>>& points) {
    double length = 0;
    for (size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    std::vector<int> kept = {0};
    for (int i = 1; i < static_cast<int>(points.size()); ++i)
        if ((points[i] - points[kept.back()]).norm() > 1e-12 * length) kept.push_back(i);
    if (kept.size() == 1) kept.push_back(0);
    return kept;
}

template <int Dim>
Curve<Dim> bezierCurve(const std::vector<Vec<Dim>>& points) {
    const int count = (static_cast<int>(points.size()) - 1) / 3;
    Curve<Dim> curve;
    for (int i = 0; i < count; ++i) {
        const Vec<Dim>* p = &points[3 * i];
        CurvePiece<Dim> piece{static_cast<double>(i) / count, static_cast<double>(i + 1) / count};
        piece.coefficients.col(0) = p[0];
        piece.coefficients.col(1) = 3 * (p[1] - p[0]);
        piece.coefficients.col(2) = 3 * ((p[2] - p[1]) - (p[1] - p[0]));
        piece.coefficients.col(3) = (p[3] - p[0]) - 3 * (p[2] - p[1]);
        curve.pieces.push_back(piece);
    }
    return curve;
}

template <int Dim>
Curve<Dim> splineCurve(const std::vector<Vec<Dim>>& points) {
    const std::vector<Vec<Dim>> p = distinct(points);
    const std::vector<double> t = chordKnots(p);
    const std::vector<Vec<Dim>> m = naturalCurvatures(t, p);
    Curve<Dim> curve;
    for (size_t i = 0; i + 1 < p.size(); ++i) {
        const double h2 = (t[i + 1] - t[i]) * (t[i + 1] - t[i]);
        CurvePiece<Dim> piece = linearPiece(t[i], t[i + 1], p[i], p[i + 1]);
        piece.coefficients.col(1) -= h2 / 6 * (2 * m[i] + m[i + 1]);
        piece.coefficients.col(2) = h2 / 2 * m[i];
        piece.coefficients.col(3) = h2 / 6 * (m[i + 1] - m[i]);
        curve.pieces.push_back(piece);
    }
    return curve;
}

template <int Dim>
Curve<Dim> polylineCurve(const std::vector<Vec<Dim>>& points) {
    const std::vector<Vec<Dim>> p = distinct(points);
    return timedCurve(chordKnots(p), p);
}

template <int Dim>
Curve<Dim> timedCurve(const std::vector<double>& times, const std::vector<Vec<Dim>>& points) {
    const double first = times.front(), span = times.back() - first;
    Curve<Dim> curve;
    double from = 0;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const double to = i + 2 == points.size() ? 1 : (times[i + 1] - first) / span;
        curve.pieces.push_back(linearPiece(from, to, points[i], points[i + 1]));
        from = to;
    }
    return curve;
}

Curve<3> inSpace(const Curve<2>& curve) {
    Curve<3> result;
    for (const CurvePiece<2>& piece : curve.pieces) {
        CurvePiece<3> raised{piece.from, piece.to};
        raised.coefficients.topRows<2>() = piece.coefficients;
        result.pieces.push_back(raised);
    }
    return result;
}

template std::vector<int> distinctPoints<2>(const std::vector<Vec2>&);
template struct CurvePiece<2>;
template struct Curve<2>;
template Curve<2> bezierCurve<2>(const std::vector<Vec2>&);
template Curve<2> splineCurve<2>(const std::vector<Vec2>&);
template Curve<2> polylineCurve<2>(const std::vector<Vec2>&);
template Curve<2> timedCurve<2>(const std::vector<double>&, const std::vector<Vec2>&);
template std::vector<int> distinctPoints<3>(const std::vector<Vec3>&);
template struct CurvePiece<3>;
template struct Curve<3>;
template Curve<3> bezierCurve<3>(const std::vector<Vec3>&);
template Curve<3> splineCurve<3>(const std::vector<Vec3>&);
template Curve<3> polylineCurve<3>(const std::vector<Vec3>&);
template Curve<3> timedCurve<3>(const std::vector<double>&, const std::vector<Vec3>&);

}  // namespace wend
