#pragma once

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "warp/image.h"

namespace wend {

/// Calls f with a value of the picture's own number type.
template <typename F>
decltype(auto) withPixelType(PixelType type, F&& f) {
    switch (type) {
        case PixelType::UInt8:
            return f(std::uint8_t{});
        case PixelType::UInt16:
            return f(std::uint16_t{});
        case PixelType::Half:
            return f(half{});
        default:
            return f(float{});
    }
}

/// The number that represents 1 (opaque, white).
template <typename T>
inline constexpr float kFull = 1;
template <>
inline constexpr float kFull<std::uint8_t> = 255;
template <>
inline constexpr float kFull<std::uint16_t> = 65535;

/// Rounds to the number type; integers are clamped to their range.
template <typename T>
T toPixel(float value) {
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(std::clamp(value, 0.0F, kFull<T>) + 0.5F);
    else
        return static_cast<T>(value);
}

}  // namespace wend
