#pragma once

#include <QRgb>

#include "core/energy/energy_stops.h"

namespace wend {

/// Colours with one meaning in all tools and panels.

/// The colour of selected objects, selection outlines and highlights in the light window.
inline constexpr QRgb kAccent = 0xff4a5bd4;
/// Stiff places.
inline constexpr QRgb kStiffColour = 0xffc8641e;
/// Outline of a shape whose map may be as dark as the background, and its width in pixels; half of it is
/// covered by the shape.
inline constexpr QRgb kRim = 0x59ffffff;
inline constexpr double kRimWidth = 3;
/// Returns the colour of an energy at its position between the stops. Lightness falls monotonically (L* 83,
/// 69, 48, 26), so the order survives colour blindness.
QRgb energyColour(double stop);

}  // namespace wend
