#pragma once

#include "core/motion/curve.h"

namespace wend {

/// The tangent of a cubic piece and its rates. The hodograph h(v) = dγ/dv is a quadratic; a common root of
/// its components (a Bézier handle on its own end point, a cusp) is divided out, so that the direction g(v)
/// stays smooth: at a cusp the tangent keeps its sign and the curve runs backwards from it.
class TangentPiece {
  public:
    /// Classifies the piece, which selects the formulas for its tangent and normal.
    enum class Shape {
        Still,     // does not move: no tangent
        Straight,  // constant tangent
        Planar,    // constant binormal; inflections only occur here
        Spatial    // torsion nowhere zero, no inflection, no cusp
    };
    /// `size`: the extent of the whole curve; pieces below 1e-13 of it count as points.
    TangentPiece(const CurvePiece<3>& piece, double size);

    Shape shape() const { return m_shape; }
    /// Returns the unit tangent at v, in the direction of travel at v = 0.
    Vec3 tangent(double v) const;
    /// Returns ±1, the direction of travel at v = 1 relative to tangent(1).
    double endSign() const { return m_endSign; }
    /// Returns a unit normal of the piece's plane (Planar) or the binormal at v (Spatial).
    Vec3 binormal(double v) const;
    /// Returns dT/dv.
    Vec3 tangentRate(double v) const;
    /// Returns the torsion times dσ/dv (σ arc length): the rotation rate of Frenet's frame about the tangent.
    /// Spatial only.
    double torsionRate(double v) const;
    /// Returns (γ(w) − γ(v)) / (w − v), without cancellation.
    Vec3 chord(double v, double w) const;

  private:
    Vec3 direction(double v) const { return m_g[0] + v * (m_g[1] + v * m_g[2]); }
    Vec3 directionRate(double v) const { return m_g[1] + 2 * v * m_g[2]; }
    void makeStraight(const Vec3& line);
    void dividePlanarCusp();

    Shape m_shape = Shape::Still;
    double m_endSign = 1;
    std::array<Vec3, 3> m_g;  // coefficients of the direction
    std::array<Vec3, 3> m_c;  // of γ: first to third power
    Vec3 m_normal = Vec3::UnitZ();
};

}  // namespace wend
