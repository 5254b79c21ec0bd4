#include "core/solver/velocity_history.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/decompositions.h"

namespace wend {
namespace {

constexpr std::size_t kFields = 3;  // a cubic guess saves nothing more
// Directions of the prescribed velocities that are weaker than this, relatively, are rounding.
constexpr double kRankTolerance = 1e-6;
// Times closer than this are one time with rounding.
constexpr double kSameTime = 1e-6;
// Fields closer than this part of the history's span count as one field. A polynomial through both, like the
// last stages of Dormand and Prince, whose shapes differ in their errors, would be inaccurate.
constexpr double kTooClose = 0.15;
// Errors in a step whose width differs by more than this factor are of little use.
constexpr double kOtherWidth = 2;

bool samePlace(double a, double b) {
    return std::abs(a - b) <= 1e-9;
}

}  // namespace

/// Misses turn with the shape, like the fields themselves: without it they are wrong by the angle of a step.
/// Measured on a bar that twists by 18° in a step: guesses wrong by 0.35 % without, by 0.005 % with it.
template <int Dim>
void VelocityHistory<Dim>::begin(double from, double to, const Nodal<Dim>& shape, const Turn& turn) {
    if (m_step.width > 0 && from != m_step.from) {  // else the last attempt is made again
        m_before = std::move(m_step);
        std::vector<Points<Dim>> fields;
        for (const Miss& miss : m_before.misses) fields.push_back(*miss.field);
        if (!fields.empty()) turn(*m_before.shape, *shape, fields);
        for (std::size_t i = 0; i < fields.size(); ++i)
            m_before.misses[i].field = std::make_shared<const Points<Dim>>(std::move(fields[i]));
    }
    m_step = {from, to - from, shape, {}};
}

template <int Dim>
int VelocityHistory<Dim>::turnOf(double place) const {
    return static_cast<int>(std::count_if(m_step.misses.begin(), m_step.misses.end(),
                                          [&](const Miss& miss) { return samePlace(miss.place, place); }));
}

/// Keeps at most kFields fields. The difference to the polynomial is the error that the next step expects
/// here.
template <int Dim>
void VelocityHistory<Dim>::record(double time, const Points<Dim>& prescribed, const Points<Dim>& velocity) {
    if (m_polynomial && m_step.width > 0)
        m_step.misses.push_back({place(time), turnOf(place(time)),
                                 std::make_shared<const Points<Dim>>(velocity - *m_polynomial)});
    m_polynomial = nullptr;
    double span = 0;
    for (const auto& field : m_fields) span = std::max(span, std::abs(time - field.time));
    std::erase_if(m_fields, [&](const Field& field) {
        return std::abs(time - field.time) <= std::max(kTooClose * span, kSameTime * std::abs(time));
    });
    if (m_fields.size() == kFields) m_fields.erase(m_fields.begin());
    m_fields.push_back({time, std::make_shared<const Points<Dim>>(prescribed),
                        std::make_shared<const Points<Dim>>(velocity)});
}

template <int Dim>
Points<Dim> VelocityHistory<Dim>::combined(const Eigen::VectorXd& weights) const {
    Points<Dim> sum = weights[0] * *m_fields[0].velocity;
    for (std::size_t i = 1; i < m_fields.size(); ++i)
        sum += weights[static_cast<Eigen::Index>(i)] * *m_fields[i].velocity;
    return sum;
}

/// Evaluates with Lagrange's weights Π (t − t_j) / (t_i − t_j).
template <int Dim>
Points<Dim> VelocityHistory<Dim>::through(double time) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(m_fields.size()));
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        for (std::size_t j = 0; j < m_fields.size(); ++j)
            if (j != i)
                weights[static_cast<Eigen::Index>(i)] *=
                    (time - m_fields[j].time) / (m_fields[i].time - m_fields[j].time);
    return combined(weights);
}

/// Extrapolates the polynomial through the last fields. Within a step the previous step's error at the same
/// place is added, scaled with the cube of the steps' ratio, since the error of a quadratic polynomial is of
/// third order.
template <int Dim>
std::optional<Points<Dim>> VelocityHistory<Dim>::at(double time) {
    m_polynomial = nullptr;
    if (m_fields.empty()) return std::nullopt;
    Points<Dim> guess = through(time);
    if (m_fields.size() < kFields || m_step.width == 0) return guess;
    m_polynomial = std::make_shared<const Points<Dim>>(guess);
    const double wider = m_step.width / m_before.width;  // nothing is less than it, where there was no step
    if (!(wider <= kOtherWidth && wider >= 1 / kOtherWidth)) return guess;
    for (const Miss& miss : m_before.misses)
        if (samePlace(miss.place, place(time)) && miss.turn == turnOf(place(time)))
            guess += wider * wider * wider * *miss.field;  // of third order
    return guess;
}

/// Solves for the weights of least norm that reproduce the prescribed velocities best, in the least-squares
/// sense; directions of them that are weaker than kRankTolerance are ignored.
template <int Dim>
std::optional<Points<Dim>> VelocityHistory<Dim>::fitting(const Points<Dim>& prescribed) const {
    if (m_fields.empty() || prescribed.size() == 0) return std::nullopt;
    Eigen::MatrixXd directions(prescribed.size(), static_cast<Eigen::Index>(m_fields.size()));
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (m_fields[i].prescribed->size() != prescribed.size()) return std::nullopt;
        directions.col(static_cast<Eigen::Index>(i)) = m_fields[i].prescribed->reshaped();
    }
    return combined(leastNormSolution(directions, prescribed.reshaped(), kRankTolerance));
}

template class VelocityHistory<2>;
template class VelocityHistory<3>;

}  // namespace wend
