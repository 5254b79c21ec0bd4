#pragma once

namespace wend {

/// φ as its place among the four named energies: 0 area, 1 length, 2 rigid, 3 angle; φ is linear between
/// neighbours. What an energy keeps changes fast in φ near Area and slowly near Angle; equal parts between
/// the named ones make it even to the eye.
inline constexpr int kEnergyStops = 4;
double phiAtStop(double stop, int dimension);
double stopOfPhi(double phi, int dimension);

}  // namespace wend
