#include "core/solver/velocity_history.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace wend {
namespace {

constexpr std::size_t kFields = 3;  // a cubic guess saves nothing more
// Directions of the prescribed velocities that are weaker than this, relatively, are rounding.
constexpr double kRankTolerance = 1e-6;
// Times closer than this, relative to the span of the history, are one time with rounding.
constexpr double kSameTime = 1e-6;

}  // namespace

template <int Dim>
void VelocityHistory<Dim>::record(double time, const Points<Dim>& prescribed, const Points<Dim>& velocity) {
    double span = 0;
    for (const auto& field : m_fields) span = std::max(span, std::abs(time - field.time));
    std::erase_if(m_fields, [&](const Field& field) {
        return std::abs(time - field.time) <= kSameTime * std::max(span, std::abs(time));
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

/// Lagrange's weights Π (t − t_j) / (t_i − t_j).
template <int Dim>
std::optional<Points<Dim>> VelocityHistory<Dim>::at(double time) const {
    if (m_fields.empty()) return std::nullopt;
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(m_fields.size()));
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        for (std::size_t j = 0; j < m_fields.size(); ++j)
            if (j != i)
                weights[static_cast<Eigen::Index>(i)] *=
                    (time - m_fields[j].time) / (m_fields[i].time - m_fields[j].time);
    return combined(weights);
}

template <int Dim>
std::optional<Points<Dim>> VelocityHistory<Dim>::fitting(const Points<Dim>& prescribed) const {
    if (m_fields.empty() || prescribed.size() == 0) return std::nullopt;
    Eigen::MatrixXd directions(prescribed.size(), static_cast<Eigen::Index>(m_fields.size()));
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (m_fields[i].prescribed->size() != prescribed.size()) return std::nullopt;
        directions.col(static_cast<Eigen::Index>(i)) = m_fields[i].prescribed->reshaped();
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
    fit.setThreshold(kRankTolerance);
    fit.compute(directions);
    return combined(fit.solve(Eigen::VectorXd(prescribed.reshaped())));
}

template class VelocityHistory<2>;
template class VelocityHistory<3>;

}  // namespace wend
