// This file gathers the edges of cells and computes with those of several cells side by side. It is included
// once for every target of Highway.

#if defined(WEND_ASSEMBLY_CELL_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEND_ASSEMBLY_CELL_EDGES_INL_H
#undef WEND_ASSEMBLY_CELL_EDGES_INL_H
#else
#define WEND_ASSEMBLY_CELL_EDGES_INL_H
#endif

#include "core/assembly/rows_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend {
namespace HWY_NAMESPACE {
namespace {

constexpr int kBlock = 64;  // cells or facets

HWY_INLINE V load(const double* p) {
    return hn::LoadU(D(), p);
}
HWY_INLINE V set(double value) {
    return hn::Set(D(), value);
}
HWY_INLINE void store(V v, double* p) {
    hn::StoreU(v, D(), p);
}

/// The differences of a block's corners to corner 0: in the plane both in one row.
template <int Dim>
struct Edges {
    static constexpr int kRows = Dim == 2 ? 1 : 3;
    HWY_ALIGN double row[kRows][kBlock][4];
};

/// Gathers the edges of cells [begin, end), whose vertices are at (Dim + 1) · cell, from a field with Dim
/// doubles a vertex.
template <int Dim>
HWY_ATTR HWY_INLINE void gatherEdges(const int* cells, int begin, int end, const double* field,
                                     Edges<Dim>& edges) {
    for (int c = begin; c < end; ++c) {
        const int* const vertices = cells + (Dim + 1) * static_cast<std::ptrdiff_t>(c);
        const auto first = loadPoint<Dim>(field, vertices[0]);
#pragma GCC unroll 3
        for (int k = 0; k < Dim; ++k) {
            double* const to =
                Dim == 2 ? edges.row[0][c - begin] + 2 * k : edges.row[k % Edges<Dim>::kRows][c - begin];
            storeRow(loadPoint<Dim>(field, vertices[k + 1]) - first, to);
        }
    }
}

template <int Dim>
HWY_ATTR HWY_INLINE void loadEdges(const Edges<Dim>& edges, int i, V (&e)[Dim][Dim]) {
    if constexpr (Dim == 2) {
        loadLanes(edges.row[0][i], 4, e[0][0], e[0][1], e[1][0], e[1][1]);
    } else {
        V zero;
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) loadLanes(edges.row[k][i], 4, e[k][0], e[k][1], e[k][2], zero);
    }
}

HWY_INLINE V inverse(const V (&e)[2][2], V (&g)[2][2]) {
    const V determinant = e[0][0] * e[1][1] - e[0][1] * e[1][0], scale = set(1) / determinant;
    g[0][0] = e[1][1] * scale, g[0][1] = hn::Neg(e[1][0]) * scale;
    g[1][0] = hn::Neg(e[0][1]) * scale, g[1][1] = e[0][0] * scale;
    return determinant;
}

/// Rows e are edges; rows g their dual basis: the cross products of the other two over the determinant.
HWY_INLINE V inverse(const V (&e)[3][3], V (&g)[3][3]) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const V(&p)[3] = e[(k + 1) % 3], (&q)[3] = e[(k + 2) % 3];
        g[k][0] = p[1] * q[2] - p[2] * q[1];
        g[k][1] = p[2] * q[0] - p[0] * q[2];
        g[k][2] = p[0] * q[1] - p[1] * q[0];
    }
    const V determinant = e[0][0] * g[0][0] + e[0][1] * g[0][1] + e[0][2] * g[0][2];
    const V scale = set(1) / determinant;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a) g[k][a] = g[k][a] * scale;
    return determinant;
}

/// Computes J = Σ_k e_k g_kᵀ.
template <int Dim>
HWY_ATTR HWY_INLINE void jacobian(const V (&e)[Dim][Dim], const double* gradients, std::ptrdiff_t n,
                                  V (&J)[Dim][Dim]) {
#pragma GCC unroll 3
    for (int b = 0; b < Dim; ++b) {
        V g[Dim];
#pragma GCC unroll 3
        for (int k = 0; k < Dim; ++k) g[k] = load(gradients + (k * Dim + b) * n);
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
            J[a][b] = e[0][a] * g[0];
#pragma GCC unroll 3
            for (int k = 1; k < Dim; ++k) J[a][b] = hn::MulAdd(e[k][a], g[k], J[a][b]);
        }
    }
}

/// Stores the forces of cells side by side on one of their corners, where `to` is that of the first cell. A
/// force has two doubles in the plane, four in space.
template <int Dim>
HWY_ATTR HWY_INLINE void storeForce(const V (&f)[Dim], double* to) {
    constexpr int kStride = (Dim == 2 ? 2 : 4) * (Dim + 1);
    if constexpr (Dim == 2)
        storeLanes(f[0], f[1], to, kStride);
    else
        storeLanes(f[0], f[1], f[2], hn::Zero(D()), to, kStride);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wend
HWY_AFTER_NAMESPACE();

#endif
