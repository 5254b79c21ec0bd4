#include "core/integration/contradictions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace wend {

template <int Dim>
std::vector<ConstraintRow> rowsOf(const Constraints<Dim>& constraints, const std::vector<int>& ids) {
    std::vector<ConstraintRow> rows;
    rows.reserve(ids.size());
    for (const int id : ids) rows.push_back({constraints.points()[id].terms});
    return rows;
}

template <int Dim>
Sliders slidersOf(const Constraints<Dim>& constraints, const std::vector<int>& ids) {
    Sliders sliders;
    for (const int id : ids) {
        const ConstrainedPoint& point = constraints.points()[id];
        const auto& hold = constraints.hold(point.handle);
        Slider& slider = sliders.emplace_back(Slider{point.terms.front().first, hold.held});
        if (hold.normal) slider.normal.template head<Dim>() = *hold.normal;
        if (!point.isGuided()) continue;
        slider.isGuided = true;
        slider.normal.template head<Dim>() = constraints.restNormal(id);
    }
    return sliders;
}

template <int Dim>
std::vector<int> guidedAlone(const Constraints<Dim>& constraints, const std::vector<int>& held,
                             const std::vector<int>& sliding) {
    if (!constraints.hasGuides()) return {};
    const auto& points = constraints.points();
    std::set<int> vertices;
    for (const int id : held)
        if (points[id].terms.size() == 1) vertices.insert(points[id].terms.front().first);
    std::vector<int> result;
    for (const int id : sliding)
        if (points[id].isGuided() && !vertices.contains(points[id].terms.front().first)) result.push_back(id);
    return result;
}

namespace {

// Relative to the largest velocity: frames are tabulated to about 1e-10.
constexpr double kAgree = 1e-7;

/// Returns the rows of points, and those of welds behind them.
template <int Dim>
std::vector<ConstraintRow> withWelds(const Constraints<Dim>& constraints, const std::vector<int>& ids) {
    std::vector<ConstraintRow> rows = rowsOf(constraints, ids);
    for (const Weld& weld : constraints.welds()) rows.push_back({weld.terms});
    return rows;
}

/// Follows the constrained points alone from breakpoint to breakpoint.
template <int Dim>
class Rehearsal {
  public:
    Rehearsal(const Constraints<Dim>& constraints, const Points<Dim>& rest, const Normalization<Dim>& units)
        : m_constraints(constraints), m_units(units) {
        for (const ConstrainedPoint& point : constraints.points()) m_positions.push_back(point.in<Dim>(rest));
        m_anchors.resize(m_positions.size());
    }

    void run() {
        double from = 0;
        for (double to = m_constraints.nextBreakpoint(from); std::isfinite(to);
             to = m_constraints.nextBreakpoint(from)) {
            stretch(from, to);
            from = to;
        }  // behind the last breakpoint all hold still
    }

  private:
    void stretch(double from, double to) {
        activate(from);
        for (const double part : {0.0, 0.13, 0.5, 0.87}) check(from + part * (to - from));
        Points<Dim> positions, velocities;
        m_constraints.evaluate(m_ids, m_anchors, to, Side::Before, positions, velocities);
        for (size_t i = 0; i < m_ids.size(); ++i)
            m_positions[m_ids[i]] = positions.col(static_cast<Eigen::Index>(i));
    }

    /// Places points that become active at the combination that they depend on.
    void activate(double t) {
        const std::vector<int> before = std::exchange(m_ids, m_constraints.activePoints(t, Side::After));
        if (before != m_ids) {
            m_dependent = dependentRows(withWelds(m_constraints, m_ids));
            for (const DependentRow& row : m_dependent)
                if (!isWeld(row.row)) join(row, before);
        }
        for (const int id : m_ids) {
            const auto& timeline = m_constraints.timeline(m_constraints.points()[id].handle);
            const bool restarts = !std::binary_search(before.begin(), before.end(), id) ||
                                  timeline.motionAt(t, Side::Before) != timeline.motionAt(t, Side::After);
            if (restarts) m_anchors[id] = m_constraints.anchor(id, m_positions[id], t);
        }
    }

    /// Puts the point of a dependent row at the combination of the other rows' points. Points that were held
    /// before keep their positions.
    void join(const DependentRow& row, const std::vector<int>& before) {
        const auto old = [&](int id) { return std::binary_search(before.begin(), before.end(), id); };
        const int id = m_ids[row.row];
        if (row.combination.size() == 1 && !isWeld(row.combination.front().first)) {
            const int other = m_ids[row.combination.front().first];
            if (old(id) && !old(other)) m_positions[other] = m_positions[id];
            if (old(id)) return;
        } else if (old(id)) {
            return;
        }
        Vec<Dim> p = Vec<Dim>::Zero();
        for (const auto& [other, weight] : row.combination)
            if (!isWeld(other)) p += weight * m_positions[m_ids[other]];
        m_positions[id] = p;
    }

    /// Throws InputError if the velocities of a dependent row differ from those of its combination at time t.
    void check(double t) const {
        if (m_dependent.empty()) return;
        Points<Dim> positions, velocities;
        m_constraints.evaluate(m_ids, m_anchors, t, Side::After, positions, velocities);
        for (const DependentRow& row : m_dependent) {
            Vec<Dim> difference = Vec<Dim>::Zero();
            if (!isWeld(row.row)) difference = velocities.col(row.row);
            double size = difference.norm();
            for (const auto& [other, weight] : row.combination) {
                if (isWeld(other)) continue;
                difference -= weight * velocities.col(other);
                size = std::max(size, velocities.col(other).norm());
            }
            if (difference.norm() > kAgree * size) contradict(row, t, positions);
        }
    }

    /// A weld's number is behind those of the points.
    bool isWeld(int row) const { return row >= static_cast<int>(m_ids.size()); }

    /// Throws InputError that names two handles. The other handle is the one that weighs most in the
    /// combination; of a weld, so are both.
    [[noreturn]] void contradict(const DependentRow& row, double t, const Points<Dim>& positions) const {
        const auto handleOf = [&](int index) { return m_constraints.points()[m_ids[index]].handle; };
        int first = isWeld(row.row) ? -1 : row.row, other = -1;
        const auto take = [&](int& place, int without) {
            double most = 0;
            for (const auto& [index, weight] : row.combination) {
                if (isWeld(index) || std::abs(weight) <= most) continue;
                if (without >= 0 && handleOf(index) == handleOf(without)) continue;
                most = std::abs(weight);
                place = index;
            }
        };
        if (first < 0) take(first, -1);
        take(other, first);
        if (other < 0) take(other, -1);
        const int low = std::min(handleOf(first), handleOf(other)),
                  high = std::max(handleOf(first), handleOf(other));
        const Sentence what =
            isWeld(row.row) ? sentence("Core", "%1 and %2 move the joint at %3 in different ways at time %4")
                            : sentence("Core", "%1 and %2 move the point %3 in different ways at time %4");
        throw InputError({what, m_constraints.handleName(low), m_constraints.handleName(high),
                          placeName<Dim>(m_units.domain(positions.col(first))), timeText(t)});
    }

    const Constraints<Dim>& m_constraints;
    const Normalization<Dim>& m_units;
    std::vector<Vec<Dim>> m_positions, m_anchors;
    std::vector<int> m_ids;  // active ones, ascending
    std::vector<DependentRow> m_dependent;
};

}  // namespace

template <int Dim>
void requireConsistent(const Constraints<Dim>& constraints, const Points<Dim>& rest,
                       const Normalization<Dim>& units) {
    std::vector<int> all;
    for (size_t k = 0; k < constraints.points().size(); ++k)
        if (!constraints.points()[k].slides) all.push_back(static_cast<int>(k));
    if (dependentRows(withWelds(constraints, all)).empty()) return;  // nor are those of any part of them
    Rehearsal<Dim>(constraints, rest, units).run();
}

template std::vector<int> guidedAlone<2>(const Constraints<2>&, const std::vector<int>&,
                                         const std::vector<int>&);
template std::vector<int> guidedAlone<3>(const Constraints<3>&, const std::vector<int>&,
                                         const std::vector<int>&);
template Sliders slidersOf<2>(const Constraints<2>&, const std::vector<int>&);
template Sliders slidersOf<3>(const Constraints<3>&, const std::vector<int>&);
template std::vector<ConstraintRow> rowsOf<2>(const Constraints<2>&, const std::vector<int>&);
template void requireConsistent<2>(const Constraints<2>&, const Points2&, const Normalization<2>&);
template std::vector<ConstraintRow> rowsOf<3>(const Constraints<3>&, const std::vector<int>&);
template void requireConsistent<3>(const Constraints<3>&, const Points3&, const Normalization<3>&);

}  // namespace wend
