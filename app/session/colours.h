#pragma once

#include <QRgb>

#include "core/energy/energy_stops.h"

namespace wend {

/// The colours that mean the same wherever they are seen, in tools and in panels.

/// Of what is selected or being drawn around, and of a light window's highlights.
inline constexpr QRgb kAccent = 0xff4a5bd4;
/// Of what is stiff.
inline constexpr QRgb kStiffColour = 0xffc8641e;
/// Of an energy at its place between the stops. Its lightness falls all along (L* 83, 69, 48, 26), so that
/// the order survives colour blindness.
QRgb energyColour(double stop);

}  // namespace wend
