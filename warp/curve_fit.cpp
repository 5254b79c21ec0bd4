#include "warp/curve_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace wend {
namespace {

using Kind = PathPiece::Kind;

constexpr int kFewestSamples = 8, kMostSamples = 256;
constexpr int kDeepest = 10;
constexpr double kStraight = 0.1;  // of the tolerance: how far a line may be from its chord

struct Cubic {
    std::array<Vec2, 4> p;

    Vec2 at(double t) const {
        const double s = 1 - t;
        return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
    }
    Vec2 derivative(double t) const {
        const double s = 1 - t;
        return 3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
    }
    double length() const { return (p[1] - p[0]).norm() + (p[2] - p[1]).norm() + (p[3] - p[2]).norm(); }
};

/// Carries one cubic.
class CubicCarrier {
  public:
    CubicCarrier(const Cubic& source, const PlaneMap& map, double tolerance, bool isLine)
        : m_source(source), m_map(map), m_tolerance(tolerance), m_isLine(isLine) {}

    void carry(SvgPath& path) const { carry(0, 1, 0, path); }

  private:
    struct Fit {
        Cubic cubic;
        double error = 0;
    };

    void carry(double from, double to, int depth, SvgPath& path) const {
        const Fit fit = fitted(from, to);
        if (fit.error > m_tolerance && depth < kDeepest) {
            const double middle = (from + to) / 2;
            carry(from, middle, depth + 1, path);
            return carry(middle, to, depth + 1, path);
        }
        const auto& p = fit.cubic.p;
        if (m_isLine && isStraight(fit.cubic))
            path.push_back({Kind::Line, {p[3]}});
        else
            path.push_back({Kind::Cubic, {p[1], p[2], p[3]}});
    }

    bool isStraight(const Cubic& cubic) const {
        const Vec2 chord = cubic.p[3] - cubic.p[0];
        const double length = chord.norm();
        const auto distance = [&](const Vec2& p) {
            const Vec2 from = p - cubic.p[0];
            return length > 0 ? std::abs(from.x() * chord.y() - from.y() * chord.x()) / length : from.norm();
        };
        return std::max(distance(cubic.p[1]), distance(cubic.p[2])) <= kStraight * m_tolerance;
    }

    /// Returns the tangent of the carried curve per unit of the parameter; where the source has none, that to
    /// a point nearby.
    Vec2 tangent(double t, double inward) const {
        Vec2 own = m_source.derivative(t);
        const double small = 1e-6 * m_source.length();
        if (own.norm() <= small) own = (m_source.at(t + inward / 16) - m_source.at(t)) / (inward / 16);
        return m_map.gradient(m_source.at(t)) * own;
    }

    /// Fits the lengths α, β of the tangents: least squares of
    ///   B0 p0 + B1 (p0 + α T0/3) + B2 (p3 − β T1/3) + B3 p3 at the samples, which have their parameters.
    Fit fitted(double from, double to) const {
        const double span = to - from;
        const int count =
            std::clamp(static_cast<int>(std::ceil(2 * span * m_source.length() / m_map.cellSize())),
                       kFewestSamples, kMostSamples);
        std::vector<Vec2> samples;
        for (int k = 0; k <= count; ++k) samples.push_back(m_map(m_source.at(from + span * k / count)));
        const Vec2 p0 = samples.front(), p3 = samples.back();
        const Vec2 a = span * tangent(from, span) / 3, b = -span * tangent(to, -span) / 3;
        Mat2 normal = Mat2::Zero();
        Vec2 right(0, 0);
        for (int k = 1; k < count; ++k) {
            const double t = static_cast<double>(k) / count, s = 1 - t;
            const Vec2 rest = samples[static_cast<std::size_t>(k)] - (s * s * s + 3 * s * s * t) * p0 -
                              (t * t * t + 3 * s * t * t) * p3;
            Mat2 row;
            row << 3 * s * s * t * a, 3 * s * t * t * b;
            normal += row.transpose() * row;
            right += row.transpose() * rest;
        }
        Vec2 lengths(1, 1);
        const double size = normal.trace();
        if (normal.determinant() > 1e-9 * size * size) lengths = normal.inverse() * right;
        if (!(lengths.minCoeff() > 0.1 && lengths.maxCoeff() < 10)) lengths = {1, 1};
        Fit fit{{{p0, p0 + lengths[0] * a, p3 + lengths[1] * b, p3}}, 0};
        for (int k = 1; k < count; ++k)
            fit.error = std::max(
                fit.error,
                (fit.cubic.at(static_cast<double>(k) / count) - samples[static_cast<std::size_t>(k)]).norm());
        return fit;
    }

    Cubic m_source;
    const PlaneMap& m_map;
    double m_tolerance;
    bool m_isLine;
};

Cubic lineCubic(const Vec2& a, const Vec2& b) {
    return {{a, a + (b - a) / 3, b + (a - b) / 3, b}};
}

}  // namespace

SvgPath carriedPath(const SvgPath& path, const PlaneMap& map, double tolerance) {
    SvgPath carried;
    Vec2 at(0, 0), start(0, 0);
    const auto line = [&](const Vec2& to) {
        CubicCarrier(lineCubic(at, to), map, tolerance, true).carry(carried);
    };
    for (const PathPiece& piece : path) {
        switch (piece.kind) {
            case Kind::Move:
                start = piece.points[0];
                carried.push_back({Kind::Move, {map(start)}});
                break;
            case Kind::Line:
                line(piece.points[0]);
                break;
            case Kind::Cubic:
                CubicCarrier({{at, piece.points[0], piece.points[1], piece.points[2]}}, map, tolerance, false)
                    .carry(carried);
                break;
            case Kind::Close: {
                const std::size_t before = carried.size();
                if (at != start) line(start);
                const bool isLine = carried.size() == before + 1 && carried.back().kind == Kind::Line;
                if (isLine) carried.pop_back();  // which the end of the curve is
                carried.push_back(piece);
            }
        }
        at = piece.kind == Kind::Close ? start : piece.points[static_cast<std::size_t>(piece.count() - 1)];
    }
    return carried;
}

}  // namespace wend
