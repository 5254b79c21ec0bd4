#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/integration/deformer.h"
#include "core/solver/velocity_solver.h"

namespace wend {

/// The reasons for which a motion cannot continue.
enum class StopReason { CellInverted, StepTooSmall, Indefinite, NotFinite, NotConverged };
/// Returns the reason for an outcome that is not done. NotPositiveDefinite becomes Indefinite; NotFinite, and
/// everything without a reason of its own such as a stopped solve, NotFinite. StepTooSmall is the
/// integrator's own.
StopReason reasonOf(const SolveOutcome& outcome);

/// Describes to a user why a handle, "it", cannot continue: what is wrong, where, and what helps. `place` is
/// a point of the domain as it is printed; the cell counts for CellInverted only, −1: none to name.
Message stopMessage(StopReason reason, const std::string& place, int cell);

/// Says when and where the shape of an elastic run snapped: the first time, and how many followed. Empty if
/// it did not. The place has `dimension` coordinates. The place is that of the first snap.
Message snapMessage(const std::vector<Snap>& snaps, int dimension);
/// Returns the same remark for a window: times in seconds, and places rounded for a shape of this size.
Message snapRemark(const std::vector<Snap>& snaps, int dimension, double size, double secondsPerUnit);

}  // namespace wend
