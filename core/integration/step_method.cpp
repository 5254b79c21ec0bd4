#include "core/integration/step_method.h"

#include "core/integration/adams_method.h"
#include "core/integration/runge_kutta_method.h"

namespace wend {

template <int Dim>
std::unique_ptr<StepMethod<Dim>> StepMethod<Dim>::of(Method method, double tolerance) {
    if (method == Method::Adams && tolerance > 0) return std::make_unique<AdamsMethod<Dim>>(tolerance);
    return std::make_unique<RungeKuttaMethod<Dim>>(method, tolerance);
}

template class StepMethod<2>;
template class StepMethod<3>;

}  // namespace wend
