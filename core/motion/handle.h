#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/mesh/region.h"

namespace wend {

/// Selects how a motion starts and ends; see ease().
enum class Ease { Linear, In, Out, InOut };

/// Moves points along a straight line by a vector in the domain's unit.
template <int Dim>
struct Translate {
    Vec<Dim> by = Vec<Dim>::Zero();
};
/// Rotates counter-clockwise in the coordinates' own axes (x towards y); the axis is used in 3D only.
template <int Dim>
struct Rotate {
    Vec<Dim> centre = Vec<Dim>::Zero();
    Vec<Dim> axis = Vec<Dim>::Zero();
    double angle = 0;
};
/// Selects the curve through, or guided by, the points of a CurveMotion.
enum class Interpolation { Bezier, Spline, Polyline };
/// Selects the frame that a shape follows along a curve; see MovingFrame.
enum class FrameKind { None, Frenet, Minimal };
/// Motion along a curve, relative to its first point. A Bezier curve is a chain of cubics (3k + 1 points).
template <int Dim>
struct CurveMotion {
    Interpolation interpolation = Interpolation::Bezier;
    std::vector<Vec<Dim>> points;
    FrameKind frame = FrameKind::None;
    double twist = 0;  // radians over the whole curve, 3D only
    double scale = 1;  // factor reached at the end
};
/// A recorded stroke: times (increasing) and points, relative to the first; linear in between.
template <int Dim>
struct Recorded {
    std::vector<double> times;
    std::vector<Vec<Dim>> points;
};

/// The displacements of vertices, with their numbers.
template <int Dim>
using Displacements = std::vector<std::pair<int, Vec<Dim>>>;
/// Moves every held vertex along a straight line of its own: x ↦ x + e(s) u.
template <int Dim>
struct FieldMotion {
    std::string file, array;  // that the values are from; empty: they are the project's own
    std::shared_ptr<const Displacements<Dim>> values = std::make_shared<const Displacements<Dim>>();
};
/// A rotation: in the plane an angle; in space the axis times the angle.
template <int Dim>
using RotationVector = Eigen::Matrix<double, Dim == 2 ? 1 : 3, 1>;
/// The place of a rigid body, x ↦ R x + position.
template <int Dim>
struct RigidPose {
    Vec<Dim> position = Vec<Dim>::Zero();
    RotationVector<Dim> rotation = RotationVector<Dim>::Zero();
};
/// Motion of a body through poses, relative to the first: M(t) = P(t) P(0)⁻¹, with a screw motion of constant
/// twist between each two (see ScrewMotion).
template <int Dim>
struct PoseMotion {
    std::string file;           // that the poses are from; empty: they are the project's own
    std::vector<double> times;  // increasing
    std::vector<RigidPose<Dim>> poses;
    bool hasOwnTimes = false;  // the file's times are those of the project
};

/// One motion of a handle: its kind, its interval of time, and how it starts and ends.
template <int Dim>
struct Motion {
    std::variant<Translate<Dim>, Rotate<Dim>, CurveMotion<Dim>, Recorded<Dim>, FieldMotion<Dim>,
                 PoseMotion<Dim>>
        kind;
    double start = 0, end = 1;  // the time window
    Ease ease = Ease::Linear;
};

/// The points of a handle: vertex ids, points anywhere in the rest shape, or all vertices inside a region.
template <int Dim>
using Placement = std::variant<std::vector<int>, std::vector<Vec<Dim>>, Region<Dim>>;

/// A surface of triangles, or lines of segments; in the plane lines only.
template <int Dim>
struct GuideMesh {
    Points<Dim> points = Points<Dim>(Dim, 0);
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> segments;
};
/// The surface on which the points of a handle slide; in the plane a path.
template <int Dim>
struct Slide {
    std::string file;                            // empty: the rest surface between the points themselves
    std::shared_ptr<const GuideMesh<Dim>> mesh;  // from the file
};

/// Prescribes the motion of some points of the shape. Without a motion it holds them still; its motions act
/// one after another. Coordinates and displacements are in the domain's unit, angles in radians, and times in
/// the project's unit of time.
template <int Dim>
struct Handle {
    std::string name;
    Placement<Dim> at;
    std::vector<Motion<Dim>> motions;
    double activeFrom = -std::numeric_limits<double>::infinity();
    double activeTo = std::numeric_limits<double>::infinity();
    unsigned slides = 0;  // bit k: the points are free along coordinate k, and held along the others
    std::optional<Vec<Dim>> normal = {};   // the points are held along this direction only
    std::optional<Slide<Dim>> slide = {};  // the points are held on this surface, which the motions move
    bool isPartlyHeld() const { return slides != 0 || normal || slide; }
    std::string part = {};  // of the mesh; empty: the frontmost part that has the place
};

}  // namespace wend
