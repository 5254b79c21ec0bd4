#include "core/integration/implicit_method.h"

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

// Displacement of the fastest constrained point in the first step, relative to the size.
constexpr double kFirstMove = 0.05;
// A step's error is of second order: what is predicted is linear in time.
constexpr double kImplicitSafety = 0.8, kLeastImplicitGrowth = 0.25, kMostImplicitGrowth = 2;

/// Returns the growth of the step after an error relative to what is allowed, which grows with the square of
/// the step: 0.8 / √error, within [¼, 2].
double factorFor(double error) {
    return std::clamp(kImplicitSafety / std::sqrt(std::max(error, 1e-3)), kLeastImplicitGrowth,
                      kMostImplicitGrowth);
}

}  // namespace

template <int Dim>
double ImplicitMethod<Dim>::firstStep(double speed) const {
    return kFirstMove / speed;
}

template <int Dim>
bool ImplicitMethod<Dim>::attempt(const typename StepMethod<Dim>::Rhs&, StageVectors<Dim>&, double t,
                                  double to, const Nodal<Dim>& x, Pace<Dim>&) {
    m_from = t;
    m_to = to;
    m_start = x;
    auto result = std::make_shared<Points<Dim>>();
    if (!m_solve(t, to, x, *result, m_error)) return false;
    m_result = std::move(result);
    return true;
}

template <int Dim>
void ImplicitMethod<Dim>::retry(Pace<Dim>& pace) const {
    pace.step = (m_to - m_from) * std::min(0.5, factorFor(m_error));
}

template <int Dim>
void ImplicitMethod<Dim>::accept(Pace<Dim>& pace, bool shortened, bool cut) {
    const double wanted = (m_to - m_from) * (shortened ? 1 : factorFor(m_error));
    pace.step = cut ? std::max(wanted, pace.step) : wanted;
    pace.error = m_error;
}

template <int Dim>
Points<Dim> ImplicitMethod<Dim>::at(double t, const Points<Dim>&) const {
    const double rate = m_rate(m_from), part = (t - m_from) / (m_to - m_from),
                 done =
                     rate > 0 ? std::expm1(-rate * (t - m_from)) / std::expm1(-rate * (m_to - m_from)) : part;
    return *m_start + done * (*m_result - *m_start);
}

template <int Dim>
void ImplicitMethod<Dim>::adopt(const DenseStep<Dim>& step, double t, double to, const Nodal<Dim>& x) {
    m_from = t;
    m_to = to;
    m_start = x;
    m_result = step.result;
}

template class ImplicitMethod<2>;
template class ImplicitMethod<3>;

}  // namespace wend
