#include "core/integration/stop_message.h"

namespace wend {

StopReason reasonOf(const SolveOutcome& outcome) {
    switch (outcome.kind) {
        case SolveOutcome::Kind::CellInverted:
            return StopReason::CellInverted;
        case SolveOutcome::Kind::NotPositiveDefinite:
            return StopReason::Indefinite;
        case SolveOutcome::Kind::NotConverged:
            return StopReason::NotConverged;
        default:
            return StopReason::NotFinite;
    }
}

std::string stopMessage(StopReason reason, const std::string& place, int cell) {
    switch (reason) {
        case StopReason::CellInverted:
            return "the shape would fold over near " + place +
                   (cell < 0 ? "" : ", in cell " + std::to_string(cell)) +
                   "; move it less far or along another path, or release what holds the shape there";
        case StopReason::StepTooSmall:
            return "it moves too fast near " + place +
                   ": the steps would be too short; give its motion more time, or allow a larger tolerance";
        case StopReason::Indefinite:
            return "the shape near " + place +
                   " is stretched or squeezed so much that no velocity can be computed; move it less far, or "
                   "make the material or the mesh more even there";
        case StopReason::NotFinite:
            return "it moves so fast near " + place +
                   " that numbers overflow; move it less far, or give its motion more time";
        case StopReason::NotConverged:
            return "the multigrid solver did not find the velocities near " + place +
                   "; solve directly (--solver direct), or make the material or the mesh more even";
    }
    return {};
}

}  // namespace wend
