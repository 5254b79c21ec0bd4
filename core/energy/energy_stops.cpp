#include "core/energy/energy_stops.h"

#include <algorithm>
#include <array>

#include "core/energy/material.h"

namespace wend {

namespace {

/// Returns φ of the named energies in increasing order, which stopOfPhi() relies on.
std::array<double, kEnergyStops> stopsOf(int dimension) {
    return {phi::kEquia, phi::kMetr, phi::kAkvf, phi::conformal(dimension)};
}

}  // namespace

double phiAtStop(double stop, int dimension) {
    const auto stops = stopsOf(dimension);
    const double x = std::clamp(stop, 0.0, kEnergyStops - 1.0);
    // The last position belongs to the last interval, as its end.
    const int i = std::min(static_cast<int>(x), kEnergyStops - 2);
    const double t = x - i;
    // a + 1 · (b − a) need not be b in floating point.
    if (t == 1) return stops[i + 1];
    return stops[i] + t * (stops[i + 1] - stops[i]);
}

double stopOfPhi(double phi, int dimension) {
    const auto stops = stopsOf(dimension);
    for (int i = 0; i + 1 < kEnergyStops; ++i)
        if (phi <= stops[i + 1]) return i + std::max(0.0, (phi - stops[i]) / (stops[i + 1] - stops[i]));
    return kEnergyStops - 1;
}

}  // namespace wend
