#pragma once

namespace wend {

/// The number of named energies. Besides its value in radians, φ can be given as a position among them: 0 is
/// area (φ_EQUIA), 1 length (φ_METR), 2 rigid (φ_AKVF), 3 angle (φ_CONF, which depends on the dimension, 2 or
/// 3), piecewise linear in between. The effect changes fast in φ near area and slowly near angle; with equal
/// distances between the named energies it looks even.
inline constexpr int kEnergyStops = 4;
/// Returns φ at a position, which is clamped to [0, 3]; exact at the named energies.
double phiAtStop(double stop, int dimension);
/// Returns the position of φ in [0, 3]; φ below φ_EQUIA gives 0, above φ_CONF 3. Inverse of phiAtStop() in
/// that range.
double stopOfPhi(double phi, int dimension);

}  // namespace wend
