#pragma once

#include <optional>

#include "core/meshing/outline.h"
#include "warp/atlas.h"

namespace wend {

/// The place where a limb that is cut out is connected to the rest.
struct PartSeam {
    Vec<2> middle;
    double radius = 0;  // half the distance between its ends
};

/// Returns how much of an area a sheet covers: its pixels of at least half opacity.
double coveredArea(const Outline& area, const Sheet& sheet);

/// Returns the only stretch of an area's border at which the picture continues on both sides, if it is a
/// small part of the border; none for an area inside a picture, or with several such stretches.
std::optional<PartSeam> seamOf(const Outline& area, const Sheet& sheet);

/// The area with a disc around the seam, which covers the joint wherever the limb turns.
Outline withCap(const Outline& area, const PartSeam& seam);

}  // namespace wend
