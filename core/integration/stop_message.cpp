#include "core/integration/stop_message.h"

#include "core/base/number_text.h"

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

Message stopMessage(StopReason reason, const std::string& place, int cell) {
    switch (reason) {
        case StopReason::CellInverted:
            if (cell < 0)
                return {
                    sentence("Core",
                             "the shape would fold over near %1; move it less far or along another path, or "
                             "release what holds the shape there"),
                    place};
            return {
                sentence("Core",
                         "the shape would fold over near %1, in cell %2; move it less far or along another "
                         "path, or release what holds the shape there"),
                place, cell};
        case StopReason::StepTooSmall:
            return {sentence("Core",
                             "it moves too fast near %1: the steps would be too short; give its motion more "
                             "time, or allow a larger tolerance"),
                    place};
        case StopReason::Indefinite:
            return {sentence("Core",
                             "the shape near %1 is stretched or squeezed so much that no velocity can be "
                             "computed; move it less far, or make the material or the mesh more even there"),
                    place};
        case StopReason::NotFinite:
            return {sentence("Core",
                             "it moves so fast near %1 that numbers overflow; move it less far, or give its "
                             "motion more time"),
                    place};
        case StopReason::NotConverged:
            return {sentence("Core",
                             "the multigrid solver did not find the velocities near %1; solve directly "
                             "(--solver direct), or make the material or the mesh more even"),
                    place};
    }
    return {};
}

Message snapMessage(const std::vector<Snap>& snaps, int dimension) {
    if (snaps.empty()) return {};
    const Snap& first = snaps.front();
    const Vec3 place(first.place[0], first.place[1], first.place[2]);
    const std::string time = numberText(first.time),
                      where = dimension == 2 ? placeName<2>(place.head<2>()) : placeName<3>(place);
    if (snaps.size() == 1)
        return {sentence("Core", "at time %1 the shape snaps to another equilibrium near %2"), time, where};
    if (snaps.size() == 2)
        return {sentence("Core", "at time %1 the shape snaps to another equilibrium near %2, and once more"),
                time, where};
    return {sentence("Core", "at time %1 the shape snaps to another equilibrium near %2, and %3 times more"),
            time, where, snaps.size() - 1};
}

Message snapRemark(const std::vector<Snap>& snaps, int dimension, double size, double secondsPerUnit) {
    if (snaps.empty()) return {};
    const Snap& first = snaps.front();
    const Vec3 place(first.place[0], first.place[1], first.place[2]);
    const std::string time = fixedText(first.time * secondsPerUnit, 2),
                      where = dimension == 2 ? roughPlaceName<2>(place.head<2>(), size)
                                             : roughPlaceName<3>(place, size);
    if (snaps.size() == 1)
        return {sentence("Core", "at %1 s the shape jumps to another pose near %2"), time, where};
    if (snaps.size() == 2)
        return {sentence("Core", "at %1 s the shape jumps to another pose near %2, and once more"), time,
                where};
    return {sentence("Core", "at %1 s the shape jumps to another pose near %2, and %3 times more"), time,
            where, snaps.size() - 1};
}

}  // namespace wend
