#pragma once

#include <type_traits>

#include "app/tools/manipulator.h"
#include "app/tools/pins/pin_ring.h"

namespace wend {

/// The gizmo around selected pins: a ring in the plane, a manipulator in space. Both have the same members.
template <int Dim>
using Gizmo = std::conditional_t<Dim == 2, PinRing, Manipulator>;

}  // namespace wend
