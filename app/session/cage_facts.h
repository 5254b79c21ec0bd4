#pragma once

#include <string>

#include "core/meshing/closed_gaps.h"

namespace wend {

/// The cage that carries a surface.
struct CageFacts {
    std::string why;                   // it was chosen by itself; empty: it was asked for
    double edge = 0;                   // of its cubes
    int bodies = 0;                    // of the cage
    int parts = 0;                     // of the surface …
    int apart = 0;                     // … and sets of those that share no cube
    std::vector<ClosedGap> gaps = {};  // within parts, that it closes
};

/// {"edge", "bodies", "parts", "apart", "gaps", "why"}, as text.
std::string cageJson(const CageFacts& cage);

}  // namespace wend
