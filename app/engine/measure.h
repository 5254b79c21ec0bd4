#pragma once

namespace wend {

/// The quantity that a map shows: a distortion measure, the distance from rest, the material (φ, relative
/// stiffness), the speed, the influence of the selected handles, the cell size,
/// or the shape of the cells.
enum class Measure {
    Angle,
    Area,
    Length,
    Shear,
    Way,
    Phi,
    Stiffness,
    Speed,
    Influence,
    CellSize,
    ScaledJacobian,
    AspectRatio,
    SmallestAngle
};

}  // namespace wend
