#include "app/style/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wend {

QRgb energyColour(double stop) {
    constexpr std::array<QRgb, kEnergyStops> kColours = {0xfff4c95d, 0xff57b8a0, 0xff2e77ae, 0xff54267f};
    const double x = std::clamp(stop, 0.0, kEnergyStops - 1.0);
    const int i = std::min(static_cast<int>(x), kEnergyStops - 2);
    const auto mix = [t = x - i](int a, int b) { return static_cast<int>(std::lround(a + t * (b - a))); };
    const QRgb a = kColours[i], b = kColours[i + 1];
    return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

}  // namespace wend
