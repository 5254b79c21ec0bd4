#include "core/factor/dense_kernels.h"

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/factor/dense_kernels.cpp"
#include <hwy/foreach_target.h>
// After the line above, which includes this file once for every target but the last one.
#include "core/factor/dense_product_inl.h"
//
#include "core/factor/dense_factor_inl.h"
#include "core/factor/dense_solve_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend::dense::HWY_NAMESPACE {

template <class Real>
constexpr Kernels<Real> kKernels = {&factorColumns<Real>, &continueColumns<Real>, &squareNegated<Real>,
                                    &prepareSolves<Real>, &forward<Real>,         &continueForward<Real>,
                                    &backward<Real>,      &prepareBackward<Real>};

const Kernels<float>& kernelsOfFloat() {
    return kKernels<float>;
}
const Kernels<double>& kernelsOfDouble() {
    return kKernels<double>;
}

}  // namespace wend::dense::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend::dense {

HWY_EXPORT(kernelsOfFloat);
HWY_EXPORT(kernelsOfDouble);

template <>
const Kernels<float>& kernels() {
    return HWY_DYNAMIC_DISPATCH(kernelsOfFloat)();
}
template <>
const Kernels<double>& kernels() {
    return HWY_DYNAMIC_DISPATCH(kernelsOfDouble)();
}

}  // namespace wend::dense
#endif
