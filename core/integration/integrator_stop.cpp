// Messages for the reasons of a stop.

#include <cmath>

#include "core/base/number_text.h"
#include "core/integration/integrator.h"
#include "core/integration/stop_message.h"
#include "core/mesh/cell_geometry.h"

namespace wend {

/// Returns the fastest constrained point where the attempt began or failed; −1 without any. A speed that is
/// NaN counts as the greatest.
template <int Dim>
int Deformer<Dim>::Integrator::fastestPoint() const {
    int fastest = -1;
    double most = -1;
    Points<Dim> positions, velocities;
    const auto look = [&](double t, Side side) {
        m_constraints->evaluate(m_ids, state.anchors, t, side, positions, velocities);
        for (std::size_t i = 0; i < m_ids.size(); ++i) {
            const double speed = velocities.col(static_cast<Eigen::Index>(i)).norm();
            if (!(speed > most) && std::isfinite(speed)) continue;
            most = std::isfinite(speed) ? speed : std::numeric_limits<double>::infinity();
            fastest = m_ids[i];
        }
    };
    look(state.time, Side::After);
    if (m_failure.time > state.time) look(m_failure.time, Side::Before);
    return fastest;
}

/// Returns the constrained point next to a place (normalized) among those of handles that move, or of all if
/// none does; −1 without any.
template <int Dim>
int Deformer<Dim>::Integrator::nearestPoint(const Vec<Dim>& place) const {
    const bool any = m_constraints->moving(state.time, Side::After);
    int nearest = -1;
    double minimum = std::numeric_limits<double>::infinity();
    for (const int id : m_ids) {
        const ConstrainedPoint& point = m_constraints->points()[id];
        if (any && m_constraints->timeline(point.handle).motionAt(state.time, Side::After) < 0) continue;
        const double distance = (point.template in<Dim>(state.normalized) - place).norm();
        if (nearest >= 0 && !(distance < minimum)) continue;
        minimum = distance;
        nearest = id;
    }
    return nearest;
}

/// Describes the last failure in one line, with its time, its place in the domain's coordinates, and the
/// handle concerned.
template <int Dim>
AdvanceResult Deformer<Dim>::Integrator::stopped() const {
    AdvanceResult result{Outcome::Cancelled, state.time, -1, {}};
    const std::string time = timeText(state.time);
    if (m_failure.cancelled) {
        result.message = "at time " + time + " cancelled";
        return result;
    }
    const StopReason reason = m_failure.stepTooSmall ? StopReason::StepTooSmall : reasonOf(m_failure.outcome);
    int point = -1, cell = m_failure.outcome.cell;
    Vec<Dim> place;
    if (reason == StopReason::CellInverted || reason == StopReason::Indefinite) {
        if (reason == StopReason::Indefinite) cell = m_orientation.mostShrunk(state.normalized);
        place = centroid<Dim>(state.points, m_rest->cells[cell]);
        point = nearestPoint(centroid<Dim>(state.normalized, m_rest->cells[cell]));
    } else {
        point = fastestPoint();
        place = point < 0 ? centroid<Dim>(state.points, m_rest->cells.front())
                          : m_constraints->points()[point].template in<Dim>(state.points);
    }
    result.outcome = reason == StopReason::CellInverted   ? Outcome::CellInverted
                     : reason == StopReason::StepTooSmall ? Outcome::StepTooSmall
                                                          : Outcome::SolverFailed;
    if (reason == StopReason::CellInverted) result.cell = cell;
    const std::string where = placeName<Dim>(place), roughly = roughPlaceName<Dim>(place, m_units.size);
    const bool settles = m_settling.rate(state.time, Side::After) > 0;
    if (reason == StopReason::StepTooSmall && settles) {
        result.message = {
            sentence("Core",
                     "at time %1 the shape is too stiff to settle further near %2: the steps would "
                     "be too short; allow a larger tolerance"),
            time, where};
        result.brief = {sentence("Core",
                                 "the shape is too stiff to settle further near %1: the steps would be too "
                                 "short; allow a larger tolerance"),
                        roughly};
    } else {
        const Message subject = point < 0 ? Message(sentence("Core", "the shape"))
                                          : m_constraints->handleName(m_constraints->points()[point].handle);
        result.message = {sentence("Core", "at time %1 %2 cannot go on: %3"), time, subject,
                          stopMessage(reason, where, cell)};
        result.brief = {sentence("Core", "%1 cannot go on: %2"), subject, stopMessage(reason, roughly, -1)};
    }
    return result;
}

template int Deformer<2>::Integrator::fastestPoint() const;
template int Deformer<2>::Integrator::nearestPoint(const Vec2&) const;
template AdvanceResult Deformer<2>::Integrator::stopped() const;
template int Deformer<3>::Integrator::fastestPoint() const;
template int Deformer<3>::Integrator::nearestPoint(const Vec3&) const;
template AdvanceResult Deformer<3>::Integrator::stopped() const;

}  // namespace wend
