#pragma once

#include <span>

#include "core/base/types.h"

namespace wend {

/// Returns the coordinates as one vector.
template <int Dim>
std::span<double> flat(Points<Dim>& points) {
    return {points.data(), static_cast<std::size_t>(points.size())};
}

}  // namespace wend
