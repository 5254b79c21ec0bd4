#include "core/assembly/isotropic_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/system/run_time_dispatch.h"

// Every loop over cells or facets is written so that the compiler vectorizes it: no call, no branch, inner
// loops of constant length. Clones cannot be templates: each has a body that is inlined into two of them.

namespace wend::isotropic {
namespace {

/// A hint for the loop after it: no two iterations touch the same entry.
#define WEND_INDEPENDENT _Pragma("GCC ivdep")

[[gnu::always_inline]] inline void inverse(const double (&e)[2][2], double determinant, double (&g)[2][2]) {
    g[0][0] = e[1][1] / determinant;
    g[0][1] = -e[1][0] / determinant;
    g[1][0] = -e[0][1] / determinant;
    g[1][1] = e[0][0] / determinant;
}

/// Rows e are edges; rows g their dual basis: the cross products of the other two over the determinant.
[[gnu::always_inline]] inline void inverse(const double (&e)[3][3], double determinant, double (&g)[3][3]) {
    const double scale = 1 / determinant;
    g[0][0] = (e[1][1] * e[2][2] - e[1][2] * e[2][1]) * scale;
    g[0][1] = (e[1][2] * e[2][0] - e[1][0] * e[2][2]) * scale;
    g[0][2] = (e[1][0] * e[2][1] - e[1][1] * e[2][0]) * scale;
    g[1][0] = (e[2][1] * e[0][2] - e[2][2] * e[0][1]) * scale;
    g[1][1] = (e[2][2] * e[0][0] - e[2][0] * e[0][2]) * scale;
    g[1][2] = (e[2][0] * e[0][1] - e[2][1] * e[0][0]) * scale;
    g[2][0] = (e[0][1] * e[1][2] - e[0][2] * e[1][1]) * scale;
    g[2][1] = (e[0][2] * e[1][0] - e[0][0] * e[1][2]) * scale;
    g[2][2] = (e[0][0] * e[1][1] - e[0][1] * e[1][0]) * scale;
}

[[gnu::always_inline]] inline double determinant(const double (&e)[2][2]) {
    return e[0][0] * e[1][1] - e[0][1] * e[1][0];
}
[[gnu::always_inline]] inline double determinant(const double (&e)[3][3]) {
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
           e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/// The differences to corner 0, one row per other corner.
template <int Dim>
[[gnu::always_inline]] inline void differences(const Cells<Dim>& s, int c, const double* field,
                                               double (&e)[Dim][Dim]) {
    const int first = s.vertices[c] * Dim;
#pragma GCC unroll 3
    for (int k = 0; k < Dim; ++k) {
        const int other = s.vertices[(k + 1) * s.count + c] * Dim;
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) e[k][a] = field[other + a] - field[first + a];
    }
}

template <int Dim>
[[gnu::always_inline]] inline void geometryBody(const Cells<Dim>& s, int begin, int end, const double* x) {
    constexpr double kFactorial = Dim == 2 ? 2 : 6;
    const int n = s.count;
    double *const measure = s.measure, *const gradients = s.gradients, *const centroids = s.centroids;
    WEND_INDEPENDENT
    for (int c = begin; c < end; ++c) {
        double e[Dim][Dim], g[Dim][Dim];
        differences<Dim>(s, c, x, e);
        const double d = determinant(e);
        inverse(e, d, g);
        measure[c] = s.orientation[c] * d / kFactorial;
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
            double sum = 0;
#pragma GCC unroll 3
            for (int k = 0; k < Dim; ++k) {
                gradients[(k * Dim + a) * n + c] = g[k][a];
                sum += e[k][a];
            }
            centroids[a * n + c] = x[s.vertices[c] * Dim + a] + sum / (Dim + 1);
        }
    }
}

template <int Dim, Jump kJump>
[[gnu::always_inline]] inline void tensorsBody(const Cells<Dim>& s, int begin, int end, const double* v) {
    const int n = s.count;
    double* const tensor = s.tensor;
    const double* const gradients = s.gradients;
    WEND_INDEPENDENT
    for (int c = begin; c < end; ++c) {
        double e[Dim][Dim], J[Dim][Dim];
        differences<Dim>(s, c, v, e);
        double trace = 0;
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
#pragma GCC unroll 3
            for (int b = 0; b < Dim; ++b) {
                J[a][b] = 0;
#pragma GCC unroll 3
                for (int k = 0; k < Dim; ++k) J[a][b] += e[k][a] * gradients[(k * Dim + b) * n + c];
            }
            trace += J[a][a];
        }
        const double q = kJump == Jump::Stress ? 4 * s.q[c] : 1;
        const double dilation = kJump == Jump::Stress ? 2 * s.r[c] * trace : 0;
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) tensor[a * n + c] = 2 * q * J[a][a] + dilation;
        tensor[Dim * n + c] = q * (J[0][1] + J[1][0]);
        if constexpr (Dim == 3) {
            tensor[4 * n + c] = q * (J[0][2] + J[2][0]);
            tensor[5 * n + c] = q * (J[1][2] + J[2][1]);
        }
    }
}

/// 2 L = f T + g X + h I with the cell's tensor T and the sum X of the weighted jumps.
template <int Dim, Jump kJump>
[[gnu::always_inline]] inline void forcesBody(const Cells<Dim>& s, int begin, int end, double* f) {
    constexpr int kTensor = Dim * (Dim + 1) / 2;
    const int n = s.count;
    const double *const tensor = s.tensor, *const gradients = s.gradients;
    WEND_INDEPENDENT
    for (int c = begin; c < end; ++c) {
        double own[kTensor], X[kTensor], ownTrace = 0, XTrace = 0, swelling = 0;
#pragma GCC unroll 6
        for (int i = 0; i < kTensor; ++i) {
            own[i] = tensor[i * n + c];
            X[i] = 0;
        }
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) ownTrace += own[a];
#pragma GCC unroll 4
        for (int k = 0; k <= Dim; ++k) {
            const int other = s.neighbours[k * n + c];
            const double weight = s.shear[k * n + c];
            double jump[kTensor];
#pragma GCC unroll 6
            for (int i = 0; i < kTensor; ++i) {
                jump[i] = own[i] - tensor[i * n + other];
                X[i] += weight * jump[i];
            }
            if constexpr (kJump == Jump::Strain) {
                double trace = 0;
#pragma GCC unroll 3
                for (int a = 0; a < Dim; ++a) trace += jump[a];
                swelling += s.dilation[k * n + c] * trace;
            }
        }
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) XTrace += X[a];
        constexpr bool kStress = kJump == Jump::Stress;
        const double V = s.measure[c], F = kStress ? 0.5 * V : 2 * V * s.q[c], G = kStress ? 8 * s.q[c] : 2;
        const double H = kStress ? 2 * s.r[c] * XTrace : 0.5 * (V * s.r[c] * ownTrace + swelling);
        double L[Dim][Dim];
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) L[a][a] = F * own[a] + G * X[a] + H;
        L[0][1] = L[1][0] = F * own[Dim] + G * X[Dim];
        if constexpr (Dim == 3) {
            L[0][2] = L[2][0] = F * own[4] + G * X[4];
            L[1][2] = L[2][1] = F * own[5] + G * X[5];
        }
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
            double sum = 0;
#pragma GCC unroll 3
            for (int k = 0; k < Dim; ++k) {
                double force = 0;
#pragma GCC unroll 3
                for (int b = 0; b < Dim; ++b) force += L[a][b] * gradients[(k * Dim + b) * n + c];
                f[((k + 1) * Dim + a) * n + c] = force;
                sum -= force;
            }
            f[a * n + c] = sum;
        }
    }
}

[[gnu::always_inline]] inline double facetMeasure(const Facets<2>& s, int f, const double* x) {
    const int a = 2 * s.vertices[f], b = 2 * s.vertices[s.count + f];
    const double dx = x[b] - x[a], dy = x[b + 1] - x[a + 1];
    return std::sqrt(dx * dx + dy * dy);
}

[[gnu::always_inline]] inline double facetMeasure(const Facets<3>& s, int f, const double* x) {
    const int a = 3 * s.vertices[f], b = 3 * s.vertices[s.count + f], c = 3 * s.vertices[2 * s.count + f];
    const double u0 = x[b] - x[a], u1 = x[b + 1] - x[a + 1], u2 = x[b + 2] - x[a + 2];
    const double v0 = x[c] - x[a], v1 = x[c + 1] - x[a + 1], v2 = x[c + 2] - x[a + 2];
    const double n0 = u1 * v2 - u2 * v1, n1 = u2 * v0 - u0 * v2, n2 = u0 * v1 - u1 * v0;
    return 0.5 * std::sqrt(n0 * n0 + n1 * n1 + n2 * n2);
}

template <int Dim>
[[gnu::always_inline]] inline void weightsBody(const Facets<Dim>& s, const Cells<Dim>& cells, int begin,
                                               int end, const double* x, double factor, bool overDistance) {
    double* const weight = s.weight;
    const double* const centroids = cells.centroids;
    WEND_INDEPENDENT
    for (int f = begin; f < end; ++f) {
        const int i = s.cells[f], j = s.cells[s.count + f];
        double squared = 0;
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
            const double d = centroids[a * cells.count + j] - centroids[a * cells.count + i];
            squared += d * d;
        }
        weight[f] = factor * facetMeasure(s, f, x) / (overDistance ? std::sqrt(squared) : 1.0);
    }
}

#define WEND_CLONED(Dim)                                                                             \
    WEND_CLONES void geometry##Dim(const Cells<Dim>& s, int begin, int end, const double* x) {       \
        geometryBody<Dim>(s, begin, end, x);                                                         \
    }                                                                                                \
    WEND_CLONES void weights##Dim(const Facets<Dim>& s, const Cells<Dim>& cells, int begin, int end, \
                                  const double* x, double factor, bool overDistance) {               \
        weightsBody<Dim>(s, cells, begin, end, x, factor, overDistance);                             \
    }
#define WEND_CLONED_JUMPS(Dim, kJump)                                                                \
    WEND_CLONES void tensors##Dim##kJump(const Cells<Dim>& s, int begin, int end, const double* v) { \
        tensorsBody<Dim, Jump::kJump>(s, begin, end, v);                                             \
    }                                                                                                \
    WEND_CLONES void forces##Dim##kJump(const Cells<Dim>& s, int begin, int end, double* force) {    \
        forcesBody<Dim, Jump::kJump>(s, begin, end, force);                                          \
    }
WEND_CLONED(2)
WEND_CLONED(3)
WEND_CLONED_JUMPS(2, Shear)
WEND_CLONED_JUMPS(3, Shear)
WEND_CLONED_JUMPS(2, Strain)
WEND_CLONED_JUMPS(3, Strain)
WEND_CLONED_JUMPS(2, Stress)
WEND_CLONED_JUMPS(3, Stress)

/// One of the clones, by the kind of jump.
template <typename Function>
Function* chosen(Jump jump, Function* shear, Function* strain, Function* stress) {
    return jump == Jump::Shear ? shear : jump == Jump::Strain ? strain : stress;
}

}  // namespace

template <int Dim>
int geometry(const Cells<Dim>& cells, int begin, int end, const double* points) {
    if constexpr (Dim == 2)
        geometry2(cells, begin, end, points);
    else
        geometry3(cells, begin, end, points);
    constexpr double kLeast = std::numeric_limits<double>::min();  // 1 / m is finite
    const double* const bad =
        std::find_if(cells.measure + begin, cells.measure + end, [](double m) { return !(m >= kLeast); });
    return static_cast<int>(bad - cells.measure);
}

template <int Dim>
void facetWeights(const Facets<Dim>& facets, const Cells<Dim>& cells, int begin, int end,
                  const double* points, double factor, bool overDistance) {
    if constexpr (Dim == 2)
        weights2(facets, cells, begin, end, points, factor, overDistance);
    else
        weights3(facets, cells, begin, end, points, factor, overDistance);
}

template <int Dim>
void tensors(Jump jump, const Cells<Dim>& cells, int begin, int end, const double* v) {
    if constexpr (Dim == 2)
        chosen(jump, tensors2Shear, tensors2Strain, tensors2Stress)(cells, begin, end, v);
    else
        chosen(jump, tensors3Shear, tensors3Strain, tensors3Stress)(cells, begin, end, v);
}

template <int Dim>
void forces(Jump jump, const Cells<Dim>& cells, int begin, int end, double* force) {
    if constexpr (Dim == 2)
        chosen(jump, forces2Shear, forces2Strain, forces2Stress)(cells, begin, end, force);
    else
        chosen(jump, forces3Shear, forces3Strain, forces3Stress)(cells, begin, end, force);
}

#define WEND_INSTANTIATE(Dim)                                                                          \
    template int geometry(const Cells<Dim>&, int, int, const double*);                                 \
    template void facetWeights(const Facets<Dim>&, const Cells<Dim>&, int, int, const double*, double, \
                               bool);                                                                  \
    template void tensors(Jump, const Cells<Dim>&, int, int, const double*);                           \
    template void forces(Jump, const Cells<Dim>&, int, int, double*);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend::isotropic
