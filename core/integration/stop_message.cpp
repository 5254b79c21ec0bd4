#include "core/integration/stop_message.h"

#include "core/mesh/number_text.h"

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

std::string snapMessage(const std::vector<Snap>& snaps, int dimension) {
    if (snaps.empty()) return {};
    const Snap& first = snaps.front();
    const Vec<3> place(first.place[0], first.place[1], first.place[2]);
    const std::string where = dimension == 2 ? placeName<2>(place.head<2>()) : placeName<3>(place);
    const std::string text =
        "at time " + numberText(first.time) + " the shape snaps to another equilibrium near " + where;
    return snaps.size() == 1 ? text : text + ", and " + std::to_string(snaps.size() - 1) + " times more";
}

}  // namespace wend
