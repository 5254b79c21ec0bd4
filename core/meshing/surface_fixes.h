#pragma once

#include <string>
#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// A step that fixes one fault of a surface. Vertices and triangles have the file's numbers, followed by
/// those that earlier steps added: removals change no other number.
struct SurfaceFix {
    /// Fill adds triangles, Drop removes some, and Turn reverses their orientation.
    enum class Kind { Fill, Drop, Turn };
    Kind kind = Kind::Drop;
    std::vector<int> ids;  // Fill: an edge of the hole; Drop: triangles; Turn: triangles, each with all that
                           // agree with it
    bool operator==(const SurfaceFix&) const = default;
};

/// A surface after some steps.
struct FixedSurface {
    Surface surface;
    std::vector<int> numbers;  // of its triangles, as steps name them
};

/// Returns the surface after the steps, one after another. Throws InputError for an impossible step.
FixedSurface fixSurface(const Surface& surface, const std::vector<SurfaceFix>& fixes);

/// A possible fix of one fault, with its result.
struct FaultFix {
    std::vector<SurfaceFix> steps;  // none: no simple one helps
    FixedSurface after;
    std::vector<int> changed;  // triangles of the earlier surface that are removed or flipped
    int added = 0, dropped = 0, turned = 0;
    SurfaceProblems left;
    int faults = 0;  // cases of all kinds that are left
};

/// Proposes a fix for one case of a kind (see faultsOf) of the surface after the steps `done`. Crossing
/// triangles are removed with as few neighbours as possible, and the resulting hole is filled.
FaultFix fixFor(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                const std::vector<int>& triangles);

}  // namespace wend
