#pragma once

#include <QRgb>

namespace wend {

/// Of what is selected or being drawn around, and of a light window's highlights.
inline constexpr QRgb kAccent = 0xff4a5bd4;
/// Of what is stiff.
inline constexpr QRgb kStiffColour = 0xffc8641e;

}  // namespace wend
