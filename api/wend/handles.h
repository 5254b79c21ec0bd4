#pragma once

/// @file
/// What holds and moves a shape: places in it, and their movements in time.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "wend/mesh.h"

namespace wend {

template <int Dim>
class Flow;

/// Points of a shape at rest that move as one: vertices, points anywhere in it, or all vertices in a region.
/// A value; immutable once made.
template <int Dim>
class WEND_API Place {
  public:
    /// Holds vertices by number.
    Place(std::vector<int> vertices);
    /// Returns a place of vertices by number.
    static Place vertices(std::vector<int> vertices);
    /// Points in the rest shape, each held by the corners of its cell.
    static Place points(std::vector<Coordinates<Dim>> points);
    /// Returns a place of all vertices in a disc or ball.
    static Place ball(const Coordinates<Dim>& centre, double radius);
    /// Returns a place of all vertices in an axis-aligned box.
    static Place box(const Coordinates<Dim>& min, const Coordinates<Dim>& max);
    /// Returns a place of all vertices on the side of a line or plane that its normal points to.
    static Place halfSpace(const Coordinates<Dim>& point, const Coordinates<Dim>& normal);
    /// Returns a place of all vertices in a polygon.
    static Place polygon(std::vector<Coordinates<2>> points) requires(Dim == 2);

    /// The same points, free along some coordinates (true) and held along the others.
    Place free(const std::array<bool, Dim>& along) const;

  private:
    friend class Flow<Dim>;
    struct Data;
    explicit Place(std::shared_ptr<const Data> data);
    std::shared_ptr<const Data> m_data;
};

/// Selects the speed of a movement in its time window: even, or starting, ending or both at rest.
enum class Pacing { Even, EaseIn, EaseOut, EaseInOut };

/// The time in which a movement happens.
struct TimeWindow {
    double start = 0;              ///< Its beginning.
    double end = 1;                ///< Its end, after the beginning.
    Pacing pacing = Pacing::Even;  ///< How evenly it is run through.
};

/// How the points of a curve are joined. Cubics is a chain of Bézier cubics, 3 k + 1 points.
enum class Joining { Cubics, Spline, Lines };
/// Selects the frame with which a curve carries the points: none, they are translated; Frenet's; or one that
/// does not spin about the tangent.
enum class CurveFrame { None, Frenet, Minimal };

/// How a curve carries points: x(t) = γ(t) + σ(t) Q(t) (x(0) − γ(0)), docs/method.md (18).
struct CurveCarriage {
    Joining joining = Joining::Cubics;    ///< How its points are joined.
    CurveFrame frame = CurveFrame::None;  ///< The frame that carries the points, Q.
    double twist = 0;  ///< In radians about the tangent over the whole curve; in space only.
    double scale = 1;  ///< The factor σ that is reached at the end.
};

/// The motion of a handle: pieces one after another, each in its own time window; windows of one movement do
/// not overlap. Outside them the handle holds still. A value; every function adds a piece and returns the
/// movement. In the plane angles turn x towards y.
template <int Dim>
class WEND_API Movement {
  public:
    /// Makes a movement without pieces, which holds still.
    Movement();
    /// @cond
    Movement(const Movement&);
    Movement(Movement&&) noexcept;
    Movement& operator=(const Movement&);
    Movement& operator=(Movement&&) noexcept;
    /// @endcond
    ~Movement();

    /// x ↦ x + e(s) by, with s in [0, 1] over the window and e its pacing.
    Movement& translate(const Coordinates<Dim>& by, const TimeWindow& when = {});
    /// Rotates about a centre by an angle in radians.
    Movement& rotate(const Coordinates<2>& centre, double angle,
                     const TimeWindow& when = {}) requires(Dim == 2);
    /// Rotates about an axis through a centre by an angle in radians.
    Movement& rotate(const Coordinates<3>& centre, const Coordinates<3>& axis, double angle,
                     const TimeWindow& when = {}) requires(Dim == 3);
    /// Carries the points along a curve, relative to its first point.
    Movement& follow(const std::vector<Coordinates<Dim>>& curve, const CurveCarriage& carriage = {},
                     const TimeWindow& when = {});
    /// Translates along recorded points, relative to the first; `times` increase, and are spread over the
    /// window.
    Movement& record(const std::vector<double>& times, const std::vector<Coordinates<Dim>>& points,
                     const TimeWindow& when = {});
    /// Displaces vertices of the handle, each along its own straight line: x ↦ x + e(s) u.
    Movement& displace(const std::vector<std::pair<int, Coordinates<Dim>>>& displacements,
                       const TimeWindow& when = {});

  private:
    friend class Flow<Dim>;
    struct Data;
    std::unique_ptr<Data> m_data;
};

extern template class Place<2>;
extern template class Place<3>;
extern template class Movement<2>;
extern template class Movement<3>;

}  // namespace wend
