#pragma once

#include <vector>

#include "core/base/message.h"
#include "core/meshing/closed_gaps.h"

namespace wend {

struct Domain;

/// The setting that opens the widest gap of a cage; all zeros if no cage of acceptable size does.
struct GapOpener {
    int vertices = 0;
    double maxVolume = 0, detail = 0;

    bool helps() const { return vertices > 0 || maxVolume > 0 || detail > 0; }
    void applyTo(Domain& domain) const;
};

/// The cage that carries a surface.
struct CageFacts {
    Message why;                       // it was chosen by itself; empty: it was asked for
    double edge = 0;                   // of its cubes
    int bodies = 0;                    // of the cage
    int parts = 0;                     // of the surface …
    int apart = 0;                     // … and sets of those that share no cube
    std::vector<ClosedGap> gaps = {};  // within parts, that it closes
    GapOpener opener = {};             // of the widest of them
};

}  // namespace wend
