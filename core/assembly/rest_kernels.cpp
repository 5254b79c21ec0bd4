#include "core/assembly/rest_kernels.h"

#include <cmath>
#include <limits>

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/assembly/rest_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/assembly/cell_edges_inl.h"

// Every kernel gathers the edges of a block of cells and then computes with several cells side by side, as in
// isotropic_kernels.cpp.

HWY_BEFORE_NAMESPACE();
namespace wend::rest {
namespace HWY_NAMESPACE {
namespace {

using namespace wend::HWY_NAMESPACE;

using isotropic::padded;

// The square of a strain that is rounding: see rest_density.cpp.
constexpr double kNoStrainSquared = 1e-24;

/// Gathers a field's edges of the cells [begin, end) block by block, and calls visit(c, e) with the edges of
/// kLanes cells from c on.
template <int Dim, class Visit>
HWY_ATTR HWY_INLINE void forEdges(const Cells<Dim>& s, int begin, int end, const double* field,
                                  const Visit& visit) {
    Edges<Dim> edges;
    for (int first = begin; first < end; first += kBlock) {
        const int last = HWY_MIN(first + kBlock, padded(end));
        gatherEdges<Dim>(s.vertices, first, last, field, edges);
        for (int c = first; c < last; c += kLanes) {
            V e[Dim][Dim];
            loadEdges<Dim>(edges, c - first, e);
            visit(c, e);
        }
    }
}

/// Returns A : B.
template <int Dim>
HWY_ATTR HWY_INLINE V inner(const V (&A)[Dim][Dim], const V (&B)[Dim][Dim]) {
    V sum = A[0][0] * B[0][0];
#pragma GCC unroll 9
    for (int i = 1; i < Dim * Dim; ++i) sum = hn::MulAdd(A[i / Dim][i % Dim], B[i / Dim][i % Dim], sum);
    return sum;
}

/// Returns det A.
HWY_INLINE V determinantOf(const V (&A)[2][2]) {
    return A[0][0] * A[1][1] - A[0][1] * A[1][0];
}
HWY_INLINE V determinantOf(const V (&A)[3][3]) {
    return A[0][0] * (A[1][1] * A[2][2] - A[1][2] * A[2][1]) +
           A[0][1] * (A[1][2] * A[2][0] - A[1][0] * A[2][2]) +
           A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
}

/// Returns J^(−2/d).
template <int Dim>
HWY_ATTR HWY_INLINE V shrink(V J) {
    if constexpr (Dim == 2) return set(1) / J;
    HWY_ALIGN double lanes[kLanes];
    hn::Store(J * J, D(), lanes);
    for (double& x : lanes) x = std::cbrt(x);
    return set(1) / hn::Load(D(), lanes);
}

/// The numbers a, b and c of restHessian().
struct Terms {
    V a, b, c;
};

template <int Dim>
HWY_ATTR HWY_INLINE Terms termsOf(const Cells<Dim>& s, int cell, V J, V squares) {
    const V q = set(4) * load(s.q + cell), k = hn::MulAdd(q, set(1.0 / Dim), load(s.r + cell)),
            a = q * shrink<Dim>(J), inverse = set(1) / J, part = a * squares * set(1.0 / Dim);
    return {a, k * (J - inverse) - part, hn::MulAdd(part, set(2.0 / Dim), k * (J + inverse))};
}

/// Stores V₀ P h_k on corner k; corner 0 has minus their sum.
template <int Dim>
HWY_ATTR HWY_INLINE void storeStress(const Cells<Dim>& s, int c, const V (&P)[Dim][Dim], V measure,
                                     double* force) {
    const std::ptrdiff_t n = padded(s.count);
    double* const to = force + Cells<Dim>::kPoint * (Dim + 1) * static_cast<std::ptrdiff_t>(c);
    V sum[Dim];
#pragma GCC unroll 3
    for (int k = 0; k < Dim; ++k) {
        V h[Dim], f[Dim];
#pragma GCC unroll 3
        for (int b = 0; b < Dim; ++b) h[b] = measure * load(s.hats + (k * Dim + b) * n + c);
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
            f[a] = P[a][0] * h[0];
#pragma GCC unroll 3
            for (int b = 1; b < Dim; ++b) f[a] = hn::MulAdd(P[a][b], h[b], f[a]);
            sum[a] = k == 0 ? hn::Neg(f[a]) : sum[a] - f[a];
        }
        storeForce<Dim>(f, to + Cells<Dim>::kPoint * (k + 1));
    }
    storeForce<Dim>(sum, to);
}

template <int Dim>
HWY_ATTR HWY_INLINE double energyOf(const Cells<Dim>& s, int begin, int end, const double* x) {
    const std::ptrdiff_t n = padded(s.count);
    V sum = hn::Zero(D()), least = set(1);
    forEdges<Dim>(s, begin, end, x, [&](int c, const V(&e)[Dim][Dim]) HWY_ATTR {
        V F[Dim][Dim];
        jacobian<Dim>(e, s.hats + c, n, F);
        const V J = determinantOf(F), q = load(s.q + c), k = hn::MulAdd(q, set(4.0 / Dim), load(s.r + c)),
                angle = hn::MulSub(inner<Dim>(F, F), shrink<Dim>(J), set(Dim)), change = J - set(1);
        least = hn::Min(least, J);
        sum = hn::MulAdd(load(s.measure + c), set(2) * q * angle + k * change * change / J, sum);
    });
    HWY_ALIGN double sums[kLanes], determinants[kLanes];
    hn::Store(sum, D(), sums);
    hn::Store(least, D(), determinants);
    double total = 0;
    for (int i = 0; i < kLanes; ++i) {
        if (!(determinants[i] > 0)) return std::numeric_limits<double>::infinity();
        total += sums[i];
    }
    return std::isnan(total) ? std::numeric_limits<double>::infinity() : total;
}

template <int Dim>
HWY_ATTR HWY_INLINE void forcesOf(const Cells<Dim>& s, int begin, int end, const double* x, double* force) {
    const std::ptrdiff_t n = padded(s.count);
    forEdges<Dim>(s, begin, end, x, [&](int c, const V(&e)[Dim][Dim]) HWY_ATTR {
        V F[Dim][Dim], N[Dim][Dim], strain = hn::Zero(D());
        jacobian<Dim>(e, s.hats + c, n, F);
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a)
#pragma GCC unroll 3
            for (int b = a; b < Dim; ++b) {
                V E = F[0][a] * F[0][b];
#pragma GCC unroll 3
                for (int i = 1; i < Dim; ++i) E = hn::MulAdd(F[i][a], F[i][b], E);
                if (a == b) E = E - set(1);
                strain = hn::MulAdd(a == b ? E : E + E, E, strain);
            }
        const V J = inverse(F, N);
        const Terms terms = termsOf<Dim>(s, c, J, inner<Dim>(F, F));
        V P[Dim][Dim];
#pragma GCC unroll 9
        for (int i = 0; i < Dim * Dim; ++i)
            P[i / Dim][i % Dim] = hn::MulAdd(terms.a, F[i / Dim][i % Dim], terms.b * N[i / Dim][i % Dim]);
        const V measure = hn::IfThenElseZero(hn::Gt(strain, set(kNoStrainSquared)), load(s.measure + c));
        storeStress<Dim>(s, c, P, measure, force);
    });
}

template <int Dim>
HWY_ATTR HWY_INLINE void linearizeAt(const Cells<Dim>& s, int begin, int end, const double* x,
                                     double* tangent) {
    const std::ptrdiff_t n = padded(s.count);
    forEdges<Dim>(s, begin, end, x, [&](int c, const V(&e)[Dim][Dim]) HWY_ATTR {
        V F[Dim][Dim], N[Dim][Dim];
        jacobian<Dim>(e, s.hats + c, n, F);
        const V J = inverse(F, N), measure = load(s.measure + c);
        const Terms terms = termsOf<Dim>(s, c, J, inner<Dim>(F, F));
        double* const to = tangent + c;
#pragma GCC unroll 9
        for (int i = 0; i < Dim * Dim; ++i) {
            store(F[i / Dim][i % Dim], to + i * n);
            store(N[i / Dim][i % Dim], to + (Dim * Dim + i) * n);
        }
        store(measure * terms.a, to + (2 * Dim * Dim) * n);
        store(measure * terms.b, to + (2 * Dim * Dim + 1) * n);
        store(measure * terms.c, to + (2 * Dim * Dim + 2) * n);
    });
}

template <int Dim>
HWY_ATTR HWY_INLINE void productsOf(const Cells<Dim>& s, int begin, int end, const double* tangent,
                                    const double* v, double* force) {
    const std::ptrdiff_t n = padded(s.count);
    forEdges<Dim>(s, begin, end, v, [&](int c, const V(&e)[Dim][Dim]) HWY_ATTR {
        V G[Dim][Dim], F[Dim][Dim], N[Dim][Dim];
        jacobian<Dim>(e, s.hats + c, n, G);
        const double* const from = tangent + c;
#pragma GCC unroll 9
        for (int i = 0; i < Dim * Dim; ++i) {
            F[i / Dim][i % Dim] = load(from + i * n);
            N[i / Dim][i % Dim] = load(from + (Dim * Dim + i) * n);
        }
        const V a = load(from + (2 * Dim * Dim) * n), b = load(from + (2 * Dim * Dim + 1) * n),
                c1 = load(from + (2 * Dim * Dim + 2) * n);
        const V alongN = inner<Dim>(N, G), mixed = set(2.0 / Dim) * a, byF = mixed * alongN,
                byN = hn::NegMulAdd(mixed, inner<Dim>(F, G), c1 * alongN);
        V P[Dim][Dim];
#pragma GCC unroll 3
        for (int i = 0; i < Dim; ++i) {
            V turned[Dim];  // row i of N Gᵀ, times b
#pragma GCC unroll 3
            for (int j = 0; j < Dim; ++j) {
                turned[j] = N[i][0] * G[j][0];
#pragma GCC unroll 3
                for (int k = 1; k < Dim; ++k) turned[j] = hn::MulAdd(N[i][k], G[j][k], turned[j]);
                turned[j] = b * turned[j];
            }
#pragma GCC unroll 3
            for (int j = 0; j < Dim; ++j) {
                V sum = hn::MulAdd(byN, N[i][j], a * G[i][j]);
                sum = hn::NegMulAdd(byF, F[i][j], sum);
#pragma GCC unroll 3
                for (int k = 0; k < Dim; ++k) sum = hn::NegMulAdd(turned[k], N[k][j], sum);
                P[i][j] = sum;
            }
        }
        storeStress<Dim>(s, c, P, set(1), force);
    });
}

/// Replaces columns of A by those of B where the bits of `columns` say so, and returns the determinant.
template <int Dim>
HWY_ATTR HWY_INLINE V mixedDeterminant(const V (&A)[Dim][Dim], const V (&B)[Dim][Dim], unsigned columns) {
    V M[Dim][Dim];
#pragma GCC unroll 9
    for (int i = 0; i < Dim * Dim; ++i)
        M[i / Dim][i % Dim] = (columns >> (i % Dim) & 1U) != 0 ? B[i / Dim][i % Dim] : A[i / Dim][i % Dim];
    return determinantOf(M);
}

/// Returns whether all Bernstein coefficients on [0, 1] of det(A + s (B − A)) are positive. Those between the
/// first and the last are means of determinants with columns of both.
template <int Dim>
HWY_ATTR HWY_INLINE auto arePositive(const V (&A)[Dim][Dim], const V (&B)[Dim][Dim]) {
    const V zero = hn::Zero(D());
    const auto ends = hn::And(hn::Gt(determinantOf(A), zero), hn::Gt(determinantOf(B), zero));
    if constexpr (Dim == 2) {
        return hn::And(ends, hn::Gt(mixedDeterminant<2>(A, B, 1) + mixedDeterminant<2>(A, B, 2), zero));
    } else {
        const V one = mixedDeterminant<3>(A, B, 1) + mixedDeterminant<3>(A, B, 2) +
                      mixedDeterminant<3>(A, B, 4),
                two = mixedDeterminant<3>(A, B, 6) + mixedDeterminant<3>(A, B, 5) +
                      mixedDeterminant<3>(A, B, 3);
        return hn::And(ends, hn::And(hn::Gt(one, zero), hn::Gt(two, zero)));
    }
}

template <int Dim>
HWY_ATTR HWY_INLINE bool staysPositiveIn(const Cells<Dim>& s, int begin, int end, const double* x,
                                         const double* step) {
    const std::ptrdiff_t n = padded(s.count);
    Edges<Dim> edges, changes;
    for (int first = begin; first < end; first += kBlock) {
        const int last = HWY_MIN(first + kBlock, padded(end));
        gatherEdges<Dim>(s.vertices, first, last, x, edges);
        gatherEdges<Dim>(s.vertices, first, last, step, changes);
        for (int c = first; c < last; c += kLanes) {
            V e[Dim][Dim], F[Dim][Dim], G[Dim][Dim];
            loadEdges<Dim>(edges, c - first, e);
            jacobian<Dim>(e, s.hats + c, n, F);
            loadEdges<Dim>(changes, c - first, e);
            jacobian<Dim>(e, s.hats + c, n, G);
#pragma GCC unroll 9
            for (int i = 0; i < Dim * Dim; ++i)
                G[i / Dim][i % Dim] = F[i / Dim][i % Dim] + G[i / Dim][i % Dim];
            if (!hn::AllTrue(D(), arePositive<Dim>(F, G))) return false;
        }
    }
    return true;
}

}  // namespace

// Functions that can be exported are no templates.
#define WEND_KERNELS(Dim)                                                                               \
    double energy##Dim(const Cells<Dim>& s, int begin, int end, const double* x) {                      \
        return energyOf<Dim>(s, begin, end, x);                                                         \
    }                                                                                                   \
    void forces##Dim(const Cells<Dim>& s, int begin, int end, const double* x, double* force) {         \
        forcesOf<Dim>(s, begin, end, x, force);                                                         \
    }                                                                                                   \
    void linearize##Dim(const Cells<Dim>& s, int begin, int end, const double* x, double* tangent) {    \
        linearizeAt<Dim>(s, begin, end, x, tangent);                                                    \
    }                                                                                                   \
    void products##Dim(const Cells<Dim>& s, int begin, int end, const double* tangent, const double* v, \
                       double* force) {                                                                 \
        productsOf<Dim>(s, begin, end, tangent, v, force);                                              \
    }                                                                                                   \
    bool stays##Dim(const Cells<Dim>& s, int begin, int end, const double* x, const double* step) {     \
        return staysPositiveIn<Dim>(s, begin, end, x, step);                                            \
    }
WEND_KERNELS(2)
WEND_KERNELS(3)
#undef WEND_KERNELS

}  // namespace HWY_NAMESPACE
}  // namespace wend::rest
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend::rest {
namespace {

HWY_EXPORT(energy2);
HWY_EXPORT(energy3);
HWY_EXPORT(forces2);
HWY_EXPORT(forces3);
HWY_EXPORT(linearize2);
HWY_EXPORT(linearize3);
HWY_EXPORT(products2);
HWY_EXPORT(products3);
HWY_EXPORT(stays2);
HWY_EXPORT(stays3);

}  // namespace

template <int Dim>
double energy(const Cells<Dim>& cells, int begin, int end, const double* points) {
    if constexpr (Dim == 2)
        return HWY_DYNAMIC_DISPATCH(energy2)(cells, begin, end, points);
    else
        return HWY_DYNAMIC_DISPATCH(energy3)(cells, begin, end, points);
}

template <int Dim>
void forces(const Cells<Dim>& cells, int begin, int end, const double* points, double* force) {
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(forces2)(cells, begin, end, points, force);
    else
        HWY_DYNAMIC_DISPATCH(forces3)(cells, begin, end, points, force);
}

template <int Dim>
void linearize(const Cells<Dim>& cells, int begin, int end, const double* points, double* tangent) {
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(linearize2)(cells, begin, end, points, tangent);
    else
        HWY_DYNAMIC_DISPATCH(linearize3)(cells, begin, end, points, tangent);
}

template <int Dim>
void products(const Cells<Dim>& cells, int begin, int end, const double* tangent, const double* v,
              double* force) {
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(products2)(cells, begin, end, tangent, v, force);
    else
        HWY_DYNAMIC_DISPATCH(products3)(cells, begin, end, tangent, v, force);
}

template <int Dim>
bool staysPositive(const Cells<Dim>& cells, int begin, int end, const double* points, const double* step) {
    if constexpr (Dim == 2)
        return HWY_DYNAMIC_DISPATCH(stays2)(cells, begin, end, points, step);
    else
        return HWY_DYNAMIC_DISPATCH(stays3)(cells, begin, end, points, step);
}

#define WEND_INSTANTIATE(Dim)                                                                   \
    template double energy(const Cells<Dim>&, int, int, const double*);                         \
    template void forces(const Cells<Dim>&, int, int, const double*, double*);                  \
    template void linearize(const Cells<Dim>&, int, int, const double*, double*);               \
    template void products(const Cells<Dim>&, int, int, const double*, const double*, double*); \
    template bool staysPositive(const Cells<Dim>&, int, int, const double*, const double*);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend::rest
#endif
