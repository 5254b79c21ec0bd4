#include "core/assembly/block_kernels.h"

#include <cstddef>

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/assembly/block_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/assembly/rows_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend::isotropic {
namespace HWY_NAMESPACE {
namespace {

using namespace wend::HWY_NAMESPACE;

/// Returns g hᵀ, column-major.
HWY_INLINE Row<4> outerProduct(const double* g, const double* h) {
    Row<4> product;
#if HWY_CAP_GE256
    const hn::Half<D> half;
    product.part[0] = hn::LoadDup128(D(), g) * hn::Combine(D(), hn::Set(half, h[1]), hn::Set(half, h[0]));
#else
    const V column = hn::LoadU(D(), g);
    product.part[0] = column * hn::Set(D(), h[0]);
    product.part[1] = column * hn::Set(D(), h[1]);
#endif
    return product;
}

}  // namespace

/// Computes, with O = g hᵀ, the blocks Σ b O + (Σ a O)ᵀ + tr(Σ a O) I.
void blocksInPlane(const int* start, const Contribution* contributions, const double* gradients,
                   const double* coefficients, int begin, int end, double* values) {
    for (int block = begin; block < end; ++block) {
        Row<4> A = zeroRow<4>(), B = A;
        for (int i = start[block]; i < start[block + 1]; ++i) {
            const Contribution& pair = contributions[i];
            const Row<4> O = outerProduct(gradients + 2 * static_cast<std::ptrdiff_t>(pair.left),
                                          gradients + 2 * static_cast<std::ptrdiff_t>(pair.right));
            const double* const ab = coefficients + 2 * static_cast<std::ptrdiff_t>(pair.term);
            A = addProduct(A, O, ab[0]);
            B = addProduct(B, O, ab[1]);
        }
        HWY_ALIGN double a[4];
        storeRow(A, a);
        double* const out = values + 4 * static_cast<std::ptrdiff_t>(block);
        storeRow(B, out);
        const double trace = a[0] + a[3];
        out[0] += a[0] + trace, out[1] += a[2], out[2] += a[1], out[3] += a[3] + trace;
    }
}

/// Column c of a contribution: a g_c h + b h_c g + a (g·h) e_c; the last term is summed apart.
void blocksInSpace(const int* start, const Contribution* contributions, const double* gradients,
                   const double* coefficients, int begin, int end, double* values) {
    for (int block = begin; block < end; ++block) {
        Row<4> column[3] = {zeroRow<4>(), zeroRow<4>(), zeroRow<4>()}, diagonal = zeroRow<4>();
        for (int i = start[block]; i < start[block + 1]; ++i) {
            const Contribution& pair = contributions[i];
            const double* const p = gradients + 4 * static_cast<std::ptrdiff_t>(pair.left);
            const double* const q = gradients + 4 * static_cast<std::ptrdiff_t>(pair.right);
            const double* const ab = coefficients + 2 * static_cast<std::ptrdiff_t>(pair.term);
            const Row<4> g = loadRow<4>(p), h = loadRow<4>(q), ah = h * ab[0], bg = g * ab[1];
#pragma GCC unroll 3
            for (int c = 0; c < 3; ++c) column[c] = addProduct(addProduct(column[c], ah, p[c]), bg, q[c]);
            diagonal = addProducts(diagonal, ah, g);
        }
        HWY_ALIGN double products[4];
        storeRow(diagonal, products);
        const double dot = products[0] + products[1] + products[2];
        double* const out = values + 9 * static_cast<std::ptrdiff_t>(block);
        // The fourth of a column is overwritten by the next one.
        storeRow(column[0], out), storeRow(column[1], out + 3), storeTriple(column[2], out + 6);
        out[0] += dot, out[4] += dot, out[8] += dot;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace wend::isotropic
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend::isotropic {
namespace {

HWY_EXPORT(blocksInPlane);
HWY_EXPORT(blocksInSpace);

}  // namespace

void blocks2(const int* start, const Contribution* contributions, const double* gradients,
             const double* coefficients, int begin, int end, double* values) {
    HWY_DYNAMIC_DISPATCH(blocksInPlane)
    (start, contributions, gradients, coefficients, begin, end, values);
}

void blocks3(const int* start, const Contribution* contributions, const double* gradients,
             const double* coefficients, int begin, int end, double* values) {
    HWY_DYNAMIC_DISPATCH(blocksInSpace)
    (start, contributions, gradients, coefficients, begin, end, values);
}

}  // namespace wend::isotropic
#endif
