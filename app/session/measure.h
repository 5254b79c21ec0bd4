#pragma once

namespace wend {

/// What is coloured over the shape: a measure of distortion, how far it is from where it was at rest, its
/// material (φ, and how many times stiffer than elsewhere), how fast it moves, how far the selected handles
/// take it along, or how fine its mesh is.
enum class Measure { Angle, Area, Length, Shear, Way, Phi, Stiffness, Speed, Influence, CellSize };

}  // namespace wend
