#pragma once

#include <string>
#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// A step that puts one fault of a surface right. Vertices and triangles have the numbers of the file, and
/// behind those, as they came, the ones that earlier steps added: what is taken away changes no other number.
struct SurfaceFix {
    enum class Kind { Fill, Drop, Turn };
    Kind kind = Kind::Drop;
    std::vector<int> ids;  // Fill: an edge of the hole; Drop: triangles; Turn: triangles, each with all that
                           // agree with it
    bool operator==(const SurfaceFix&) const = default;
};

struct FixedSurface {
    Surface surface;
    std::vector<int> numbers;  // of its triangles, as steps name them
};

/// The surface after the steps, one after another. Throws InputError: a step that is impossible.
FixedSurface fixSurface(const Surface& surface, const std::vector<SurfaceFix>& fixes);

/// What could be done about one fault.
struct FaultFix {
    std::vector<SurfaceFix> steps;  // none: no simple one helps
    FixedSurface after;
    std::vector<int> changed;  // triangles of the surface before that go away or are turned
    int added = 0, dropped = 0, turned = 0;
    SurfaceProblems left;
    int faults = 0;  // cases of all kinds that are left
};

/// For one case of a kind (see faultsOf) of the surface that the steps `done` have left. Where triangles
/// cross, they go with what is around them, as little as does, and what is open then is filled.
FaultFix fixFor(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                const std::vector<int>& triangles);

}  // namespace wend
