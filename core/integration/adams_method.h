#pragma once

#include <array>

#include "core/integration/step_method.h"

namespace wend {

/// Adams–Bashforth–Moulton with variable steps and order (Hairer, Nørsett, Wanner I, III.5; Shampine, Gordon
/// 1975), in variable-coefficient form: the weights are integrals of Lagrange polynomials over the stored
/// times.
/// A step of order k predicts from the last k fields, evaluates once at the predicted shape, and corrects
/// with k + 1 fields, so the result is of order k + 1. The field at the predicted shape is kept (PEC): a
/// second evaluation at the corrected shape (PECE) costs as much as another step and gains less (measured: 50
/// % more evaluations for the same error). Starts at order 1 with a small step; both grow as far as the
/// estimated errors allow.
template <int Dim>
class AdamsMethod final : public StepMethod<Dim> {
  public:
    static constexpr int kHighestOrder = 5;

    explicit AdamsMethod(double tolerance) : m_tolerance(tolerance) {}

    double firstStep(double speed) const override;
    bool attempt(const typename StepMethod<Dim>::Rhs& f, StageVectors<Dim>& stages, double t, double to,
                 const Nodal<Dim>& x, Pace<Dim>& pace) override;
    const Nodal<Dim>& result() const override { return m_result; }
    double error() const override { return m_errors[1]; }
    void retry(Pace<Dim>& pace) const override;
    void accept(Pace<Dim>& pace, bool shortened, bool cut) override;
    bool needsEndField() const override { return false; }
    Points<Dim> at(double t, const Points<Dim>& endField) const override;
    DenseStep<Dim> dense() const override { return {m_order, nullptr, m_fields}; }
    void adopt(const DenseStep<Dim>& step, double t, double to, const Nodal<Dim>& x) override;

  private:
    std::vector<WeightedField<Dim>> integral(const std::vector<PastField<Dim>>& fields, int count,
                                             double to) const;
    double estimate(StageVectors<Dim>& stages, int order) const;

    double m_tolerance;
    double m_from = 0, m_to = 0;
    Nodal<Dim> m_start, m_result;
    std::vector<PastField<Dim>> m_fields;  // those of the pace and the one at the predicted shape
    int m_order = 1;
    std::array<double, 3> m_errors{};  // over the tolerance, of orders k − 1, k, k + 1; infinite: not known
};

/// Returns the integrals from a to b of the Lagrange polynomials over some distinct times, one per time: ∫
/// Π_{j≠i} (t − t_j) / (t_i − t_j) dt. They sum to b − a, and are exact to rounding for up to eight times.
/// With equal distances and [a, b] the interval after the last time they are the weights of Adams–Bashforth,
/// with the interval before it those of Adams–Moulton (Hairer, Nørsett, Wanner I, III.1).
std::vector<double> adamsWeights(const std::vector<double>& times, double a, double b);

}  // namespace wend
