#pragma once

#include <functional>
#include <limits>

#include "core/integration/step_method.h"

namespace wend {

/// Takes the steps of relaxation, which minimize the energy of the map from rest at their end
/// (docs/method.md, section 8). The caller computes a step and its error; this class controls the length of
/// steps.
template <int Dim>
class ImplicitMethod final : public StepMethod<Dim> {
  public:
    /// Computes the shape at a step's end from the one at its start, and its error relative to what is
    /// allowed. Returns false if there is none.
    using Solve =
        std::function<bool(double t, double to, const Nodal<Dim>& x, Points<Dim>& result, double& error)>;
    /// Returns the rate at which the shape approaches the end of a step from t within it; 0 means evenly.
    using Rate = std::function<double(double t)>;
    ImplicitMethod(Solve solve, Rate rate) : m_solve(std::move(solve)), m_rate(std::move(rate)) {}

    double firstStep(double speed) const override;
    bool attempt(const typename StepMethod<Dim>::Rhs& f, StageVectors<Dim>& stages, double t, double to,
                 const Nodal<Dim>& x, Pace<Dim>& pace) override;
    const Nodal<Dim>& result() const override { return m_result; }
    double error() const override { return m_error; }
    void retry(Pace<Dim>& pace) const override;
    void accept(Pace<Dim>& pace, bool shortened, bool cut) override;
    bool needsEndField() const override { return false; }
    /// Returns the start plus the part (1 − e^(−r (t − t₀)))/(1 − e^(−r (t₁ − t₀))) of the path to the end.
    Points<Dim> at(double t, const Points<Dim>& endField) const override;
    DenseStep<Dim> dense() const override { return {0, m_result, {{m_from, m_start}}}; }
    void adopt(const DenseStep<Dim>& step, double t, double to, const Nodal<Dim>& x) override;

  private:
    Solve m_solve;
    Rate m_rate;
    Nodal<Dim> m_start, m_result;
    double m_from = 0, m_to = 0, m_error = 0;
};

}  // namespace wend
