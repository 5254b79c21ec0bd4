#pragma once

#include "core/integration/runge_kutta.h"
#include "core/integration/step_method.h"

namespace wend {

/// Takes steps by a Runge–Kutta method, with error control if its tableau has an embedded method.
template <int Dim>
class RungeKuttaMethod final : public StepMethod<Dim> {
  public:
    RungeKuttaMethod(Method method, double tolerance) : m_step(method), m_tolerance(tolerance) {}

    double firstStep(double speed) const override;
    bool attempt(const typename StepMethod<Dim>::Rhs& f, StageVectors<Dim>& stages, double t, double to,
                 const Nodal<Dim>& x, Pace<Dim>& pace) override;
    const Nodal<Dim>& result() const override { return m_step.result(); }
    double error() const override { return m_error; }
    void retry(Pace<Dim>& pace) const override;
    void accept(Pace<Dim>& pace, bool shortened, bool cut) override;
    bool needsEndField() const override { return !m_step.firstSameAsLast(); }
    Points<Dim> at(double t, const Points<Dim>& endField) const override;
    DenseStep<Dim> dense() const override;
    void adopt(const DenseStep<Dim>& step, double t, double to, const Nodal<Dim>& x) override;

  private:
    RungeKuttaStep<Dim> m_step;
    double m_tolerance;
    double m_from = 0, m_to = 0, m_error = 0;
};

}  // namespace wend
