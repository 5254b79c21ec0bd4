#pragma once

#include <QRgb>

#include "core/energy/energy_stops.h"

namespace wend {

/// The colour of an energy at its place, the same wherever energies are seen. Its lightness falls all along
/// (L* 83, 69, 48, 26), so that the order survives colour blindness.
QRgb energyColour(double stop);

}  // namespace wend
