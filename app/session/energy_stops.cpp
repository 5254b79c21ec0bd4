#include "app/session/energy_stops.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/energy/material.h"

namespace wend {

namespace {

std::array<double, kEnergyStops> stopsOf(int dimension) {
    return {phi::kEquia, phi::kMetr, phi::kAkvf, phi::conformal(dimension)};
}

/// The stop before a place, and how far behind it that is.
std::pair<int, double> split(double stop) {
    const double x = std::clamp(stop, 0.0, kEnergyStops - 1.0);
    const int i = std::min(static_cast<int>(x), kEnergyStops - 2);
    return {i, x - i};
}

}  // namespace

double phiAtStop(double stop, int dimension) {
    const auto stops = stopsOf(dimension);
    const auto [i, t] = split(stop);
    if (t == 1) return stops[i + 1];
    return stops[i] + t * (stops[i + 1] - stops[i]);
}

double stopOfPhi(double phi, int dimension) {
    const auto stops = stopsOf(dimension);
    for (int i = 0; i + 1 < kEnergyStops; ++i)
        if (phi <= stops[i + 1]) return i + std::max(0.0, (phi - stops[i]) / (stops[i + 1] - stops[i]));
    return kEnergyStops - 1;
}

QRgb energyColour(double stop) {
    constexpr std::array<QRgb, kEnergyStops> kColours = {0xfff4c95d, 0xff57b8a0, 0xff2e77ae, 0xff54267f};
    const auto [i, t] = split(stop);
    const auto mix = [t = t](int a, int b) { return static_cast<int>(std::lround(a + t * (b - a))); };
    const QRgb a = kColours[i], b = kColours[i + 1];
    return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

}  // namespace wend
