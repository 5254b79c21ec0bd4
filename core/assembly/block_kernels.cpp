#include "core/assembly/block_kernels.h"

#include "core/system/run_time_dispatch.h"

namespace wend::isotropic {
namespace {

using Quad = double __attribute__((vector_size(32), aligned(8), may_alias));

const Quad& at(const double* p) {
    return *reinterpret_cast<const Quad*>(p);
}

}  // namespace

/// With O = g hᵀ, column-major as (O00, O10, O01, O11): Σ b O + (Σ a O)ᵀ + tr(Σ a O) I.
WEND_CLONES void blocks2(const int* start, const Contribution* contributions, const double* gradients,
                         const double* coefficients, int begin, int end, double* values) {
    for (int block = begin; block < end; ++block) {
        Quad A{}, B{};
        for (int i = start[block]; i < start[block + 1]; ++i) {
            const Contribution& pair = contributions[i];
            const double* const h = gradients + 4 * pair.right;
            const Quad O = at(gradients + 4 * pair.left) * Quad{h[0], h[0], h[1], h[1]};
            A += O * coefficients[2 * pair.coefficients];
            B += O * coefficients[2 * pair.coefficients + 1];
        }
        const double trace = A[0] + A[3];
        double* const out = values + 4 * static_cast<long>(block);
        out[0] = B[0] + A[0] + trace, out[1] = B[1] + A[2], out[2] = B[2] + A[1],
        out[3] = B[3] + A[3] + trace;
    }
}

/// Column c of a contribution: a g_c h + b h_c g + a (g·h) e_c; the last term is summed apart.
WEND_CLONES void blocks3(const int* start, const Contribution* contributions, const double* gradients,
                         const double* coefficients, int begin, int end, double* values) {
    for (int block = begin; block < end; ++block) {
        Quad m0{}, m1{}, m2{}, diagonal{};
        for (int i = start[block]; i < start[block + 1]; ++i) {
            const Contribution& pair = contributions[i];
            const double *const p = gradients + 4 * pair.left, *const q = gradients + 4 * pair.right;
            const Quad g = at(p), h = at(q);
            const Quad ah = h * coefficients[2 * pair.coefficients],
                       bg = g * coefficients[2 * pair.coefficients + 1];
            m0 += ah * p[0] + bg * q[0];
            m1 += ah * p[1] + bg * q[1];
            m2 += ah * p[2] + bg * q[2];
            diagonal += ah * g;
        }
        const double dot = diagonal[0] + diagonal[1] + diagonal[2];
        double* const out = values + 9 * static_cast<long>(block);
        for (int r = 0; r < 3; ++r) out[r] = m0[r], out[3 + r] = m1[r], out[6 + r] = m2[r];
        for (int r = 0; r < 3; ++r) out[4 * r] += dot;
    }
}

}  // namespace wend::isotropic
