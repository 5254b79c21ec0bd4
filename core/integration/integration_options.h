#pragma once

#include <string>
#include <vector>

#include "core/integration/method.h"
#include "core/solver/solver_choice.h"

namespace wend {

/// An interval in which the shape relaxes: it flows towards the minimum energy of its map from rest, with the
/// handles where they are (docs/method.md, section 8).
struct SettleWindow {
    double start = 0, end = 1;
    bool operator==(const SettleWindow&) const = default;
};

/// Returns an empty string if the windows are finite, in the order of time and apart from each other, else
/// the reason.
std::string problemOf(const std::vector<SettleWindow>& windows);

/// Options of the time integration.
struct IntegrationOptions {
    Method method = Method::Adams;
    double tolerance = 1e-4;  // error per step allowed, relative to the size
    int steps = 0;  // > 0: this many equal steps over the whole time [0, end], cut at breakpoints of motions;
                    // 0: adaptive (Dormand–Prince and Adams only). Adams, which cannot start with a long
                    // step, then leaves them to Dormand–Prince.
    double end = 1;              // with steps: the time that they are spread over
    double smallestStep = 1e-6;  // of the stretch between two breakpoints of motions: below it the run stops
    int threads = 0;             // 0: all cores
    /// The error of a velocity field that is allowed, relative to the largest velocity; < 0: as the tolerance
    /// needs. With 0, every field is solved for directly with a factorization of its own, as in the paper.
    double velocityTolerance = -1;
    SolverKind solver = SolverKind::Automatic;
    std::vector<SettleWindow> settle;  // in the order of time

    /// Returns an empty string if all options are in range, else the reason.
    std::string problem() const;
};

}  // namespace wend
