#include "core/integration/adams_method.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wend {

namespace {

// Displacement of the fastest constrained point in the first step of an interval, relative to the size, at a
// tolerance of 1; the error of order 1 grows with the square of the step.
constexpr double kFirstAdamsMove = 1;
// Target error of the control relative to the tolerance. A whole deformation then ends with about the
// tolerance's error, and few steps are rejected.
constexpr double kAim = 0.1;
constexpr double kLeastGrowth = 0.2, kMostGrowth = 3, kMostGrowthAtStart = 4;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Returns the growth of the step that brings an error of order h^(order + 1) to the aim of the control.
double growth(double error, int order) {
    return std::pow(kAim / std::max(error, 1e-12), 1.0 / (order + 1));
}

}  // namespace

/// Gauss's rule with four points is exact to degree 7, that is, for eight times.
std::vector<double> adamsWeights(const std::vector<double>& times, double a, double b) {
    static constexpr std::array<double, 4> kAt = {-0.8611363115940526, -0.3399810435848563,
                                                  0.3399810435848563, 0.8611363115940526};
    static constexpr std::array<double, 4> kWeight = {0.3478548451374538, 0.6521451548625461,
                                                      0.6521451548625461, 0.3478548451374538};
    std::vector<double> weights(times.size(), 0.0);
    for (std::size_t g = 0; g < kAt.size(); ++g) {
        const double t = a + (b - a) / 2 * (1 + kAt[g]);
        for (std::size_t i = 0; i < times.size(); ++i) {
            double value = (b - a) / 2 * kWeight[g];
            for (std::size_t j = 0; j < times.size(); ++j)
                if (j != i) value *= (t - times[j]) / (times[i] - times[j]);
            weights[i] += value;
        }
    }
    return weights;
}

template <int Dim>
double AdamsMethod<Dim>::firstStep(double speed) const {
    return kFirstAdamsMove * std::sqrt(m_tolerance) / speed;
}

/// Returns the integral from m_from to `to` of the polynomial through the last fields.
template <int Dim>
std::vector<WeightedField<Dim>> AdamsMethod<Dim>::integral(const std::vector<PastField<Dim>>& fields,
                                                           int count, double to) const {
    const auto last = fields.end() - count;
    std::vector<double> times;
    for (auto field = last; field != fields.end(); ++field) times.push_back(field->time);
    const auto weights = adamsWeights(times, m_from, to);
    std::vector<WeightedField<Dim>> terms;
    for (int i = 0; i < count; ++i) terms.push_back({weights[i], last[i].field});
    return terms;
}

/// Returns the difference of the corrections with k + 1 and with k fields, of order h^(k + 1).
template <int Dim>
double AdamsMethod<Dim>::estimate(StageVectors<Dim>& stages, int order) const {
    const int known = static_cast<int>(m_fields.size());
    if (order < 1 || order + 1 > known) return kUnknown;
    auto difference = integral(m_fields, order + 1, m_to);
    const auto lower = integral(m_fields, order, m_to);
    for (int i = 0; i < order; ++i) difference[i + 1].weight -= lower[i].weight;
    return stages.maximum(difference) / m_tolerance;
}

/// Predicts by the polynomial through the last fields, evaluates the field at the predicted shape, corrects,
/// and estimates the errors of the neighbouring orders.
template <int Dim>
bool AdamsMethod<Dim>::attempt(const typename StepMethod<Dim>::Rhs& f, StageVectors<Dim>& stages, double t,
                               double to, const Nodal<Dim>& x, Pace<Dim>& pace) {
    m_from = t;
    m_to = to;
    m_start = x;
    if (pace.fields.empty()) {
        stages.combine(x, {});
        auto field = fieldAt<Dim>(f, stages, t, Side::After);
        if (!field) return false;
        pace.fields = {{t, std::move(field)}};
    }
    m_order = std::clamp(pace.order, 1, static_cast<int>(pace.fields.size()));
    stages.combine(x, integral(pace.fields, m_order, to));
    auto field = fieldAt<Dim>(f, stages, to, Side::Before);
    if (!field) return false;
    m_fields = pace.fields;
    m_fields.push_back({to, std::move(field)});
    stages.combine(x, integral(m_fields, m_order + 1, to));
    m_result = stages.shape();
    for (int i : {0, 1, 2}) m_errors[i] = estimate(stages, m_order - 1 + i);
    return true;
}

/// Lowers the order if that promises less error, and shortens the step by its error, by a tenth at least.
template <int Dim>
void AdamsMethod<Dim>::retry(Pace<Dim>& pace) const {
    const bool lower = m_errors[0] < m_errors[1];
    pace.order = lower ? m_order - 1 : m_order;
    const double factor = lower ? growth(m_errors[0], m_order - 1) : growth(m_errors[1], m_order);
    pace.step =
        (m_to - m_from) * (std::isfinite(factor) ? std::clamp(factor, kLeastGrowth, 0.9) : kLeastGrowth);
}

/// Chooses the order and the step that promise the longest steps for the tolerance. While the method starts,
/// both grow with every step.
template <int Dim>
void AdamsMethod<Dim>::accept(Pace<Dim>& pace, bool shortened, bool cut) {
    // No order was refused yet: raise it with every step.
    const bool starting = m_order == static_cast<int>(m_fields.size()) - 1 && m_order < kHighestOrder;
    int order = m_order;
    double factor = growth(m_errors[1], m_order);
    if (starting && !shortened) {
        ++order;
    } else {
        for (const int other : {m_order - 1, m_order + 1}) {
            if (other < 1 || other > kHighestOrder) continue;
            const double possible = growth(m_errors[other - m_order + 1], other);
            if (possible <= factor) continue;
            factor = possible;
            order = other;
        }
    }
    factor = std::clamp(factor, kLeastGrowth, shortened ? 1.0 : starting ? kMostGrowthAtStart : kMostGrowth);
    const double wanted = (m_to - m_from) * factor;
    pace.step = cut ? std::max(wanted, pace.step) : wanted;
    pace.error = m_errors[1];
    pace.order = order;
    pace.fields = m_fields;
    if (pace.fields.size() > kHighestOrder) pace.fields.erase(pace.fields.begin());
}

template <int Dim>
Points<Dim> AdamsMethod<Dim>::at(double t, const Points<Dim>&) const {
    Points<Dim> x = *m_start;
    for (const auto& [weight, field] : integral(m_fields, m_order + 1, t)) x += weight * *field;
    return x;
}

template <int Dim>
void AdamsMethod<Dim>::adopt(const DenseStep<Dim>& step, double t, double to, const Nodal<Dim>& x) {
    m_from = t;
    m_to = to;
    m_start = x;
    m_order = step.order;
    m_fields = step.fields;
}

template class AdamsMethod<2>;
template class AdamsMethod<3>;

}  // namespace wend
