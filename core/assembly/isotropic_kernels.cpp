#include "core/assembly/isotropic_kernels.h"

#include <algorithm>
#include <limits>

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/assembly/isotropic_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/assembly/cell_edges_inl.h"

// Every kernel takes the cells in blocks that the first cache holds. Within a block a first loop gathers what
// each cell needs of its vertices and neighbours, one cell after the other, as rows; a second loop computes,
// the same number of several cells side by side.

HWY_BEFORE_NAMESPACE();
namespace wend::isotropic {
namespace HWY_NAMESPACE {
namespace {

using namespace wend::HWY_NAMESPACE;

/// Computes the centroids of cells, as rows of kPoint doubles.
template <int Dim>
HWY_ATTR HWY_INLINE void centroids(const Cells<Dim>& s, int begin, int end, const double* x) {
    for (int c = begin; c < end; ++c) {
        const int* const vertices = s.vertices + (Dim + 1) * static_cast<std::ptrdiff_t>(c);
        const auto first = loadPoint<Dim>(x, vertices[0]);
        auto sum = loadPoint<Dim>(x, vertices[1]) - first;
#pragma GCC unroll 2
        for (int k = 2; k <= Dim; ++k) sum = sum + (loadPoint<Dim>(x, vertices[k]) - first);
        storeRow(addProduct(first, sum, 1.0 / (Dim + 1)),
                 s.centroids + Cells<Dim>::kPoint * static_cast<std::ptrdiff_t>(c));
    }
}

/// Implements geometry() for one SIMD target, in blocks of cells whose edges are gathered first.
template <int Dim>
HWY_ATTR HWY_INLINE void geometryOf(const Cells<Dim>& s, int begin, int end, const double* x) {
    constexpr double kFactorial = Dim == 2 ? 2 : 6;
    const int n = padded(s.count);
    Edges<Dim> edges;
    for (int first = begin; first < end; first += kBlock) {
        const int last = HWY_MIN(first + kBlock, padded(end));
        gatherEdges<Dim>(s.vertices, first, last, x, edges);
        centroids<Dim>(s, first, last, x);
        for (int c = first; c < last; c += kLanes) {
            V e[Dim][Dim], g[Dim][Dim];
            loadEdges<Dim>(edges, c - first, e);
            const V determinant = inverse(e, g);
            store(load(s.orientation + c) * determinant * set(1 / kFactorial), s.measure + c);
#pragma GCC unroll 3
            for (int k = 0; k < Dim; ++k)
#pragma GCC unroll 3
                for (int a = 0; a < Dim; ++a)
                    store(g[k][a], s.gradients + (k * Dim + a) * static_cast<std::ptrdiff_t>(n) + c);
        }
    }
}

HWY_INLINE void storeTensor(const Cells<2>& s, int c, const V (&T)[3]) {
    storeLanes(T[0], T[1], T[2], hn::Zero(D()), s.tensor + 4 * static_cast<std::ptrdiff_t>(c), 4);
}
HWY_INLINE void storeTensor(const Cells<3>& s, int c, const V (&T)[6]) {
    storeLanes(T[0], T[1], T[2], T[3], s.tensor + 4 * static_cast<std::ptrdiff_t>(c), 4);
    storeLanes(T[4], T[5], s.tensorRest + 2 * static_cast<std::ptrdiff_t>(c), 2);
}
HWY_INLINE void loadTensor(const double* first, const double*, V (&T)[3]) {
    V zero;
    loadLanes(first, 4, T[0], T[1], T[2], zero);
}
HWY_INLINE void loadTensor(const double* first, const double* rest, V (&T)[6]) {
    loadLanes(first, 4, T[0], T[1], T[2], T[3]);
    loadLanes(rest, 2, T[4], T[5]);
}

/// Implements tensors() for one SIMD target; with kStress the tensor is the stress P, otherwise the strain S.
template <int Dim, bool kStress>
HWY_ATTR HWY_INLINE void tensorsOf(const Cells<Dim>& s, int begin, int end, const double* v) {
    constexpr int kTensor = Dim * (Dim + 1) / 2;
    const int n = padded(s.count);
    Edges<Dim> edges;
    for (int first = begin; first < end; first += kBlock) {
        const int last = HWY_MIN(first + kBlock, padded(end));
        gatherEdges<Dim>(s.vertices, first, last, v, edges);
        for (int c = first; c < last; c += kLanes) {
            V e[Dim][Dim], J[Dim][Dim], T[kTensor];
            loadEdges<Dim>(edges, c - first, e);
            jacobian<Dim>(e, s.gradients + c, n, J);
#pragma GCC unroll 3
            for (int a = 0; a < Dim; ++a) T[a] = J[a][a] + J[a][a];
            T[Dim] = J[0][1] + J[1][0];
            if constexpr (Dim == 3) T[4] = J[0][2] + J[2][0], T[5] = J[1][2] + J[2][1];
            if constexpr (kStress) {
                V trace = T[0] + T[1];
                if constexpr (Dim == 3) trace = trace + T[2];
                const V q = set(4) * load(s.q + c), dilation = load(s.r + c) * trace;
#pragma GCC unroll 6
                for (int i = 0; i < kTensor; ++i) T[i] = i < Dim ? hn::MulAdd(q, T[i], dilation) : q * T[i];
            }
            storeTensor(s, c, T);
        }
    }
}

/// The jumps between a block's cells and their neighbours: the sums over the facets of weight · (S −
/// S_neighbour).
template <int Dim>
struct Jumps {
    HWY_ALIGN double first[kBlock][4];
    HWY_ALIGN double rest[kBlock][2];
    HWY_ALIGN double dilation[kBlock][4];  // with the weight of the dilation, the diagonal counts
};

/// Sums the weighted differences of a cell's tensor and those of its neighbours over the facets.
template <int Dim, bool kDilation>
HWY_ATTR HWY_INLINE void gatherJumps(const Cells<Dim>& s, int begin, int end, Jumps<Dim>& jumps) {
    for (int c = begin; c < end; ++c) {
        const std::ptrdiff_t at = (Dim + 1) * static_cast<std::ptrdiff_t>(c);
        const Row<4> own = loadRow<4>(s.tensor + 4 * static_cast<std::ptrdiff_t>(c));
        Row<4> sum = zeroRow<4>(), dilation = sum;
        Row<2> rest = zeroRow<2>(), ownRest = rest;
        if constexpr (Dim == 3) ownRest = loadRow<2>(s.tensorRest + 2 * static_cast<std::ptrdiff_t>(c));
#pragma GCC unroll 4
        for (int k = 0; k <= Dim; ++k) {
            const std::ptrdiff_t other = s.neighbours[at + k];
            const Row<4> jump = own - loadRow<4>(s.tensor + 4 * other);
            sum = addProduct(sum, jump, s.shear[at + k]);
            if constexpr (Dim == 3)
                rest = addProduct(rest, ownRest - loadRow<2>(s.tensorRest + 2 * other), s.shear[at + k]);
            if constexpr (kDilation) dilation = addProduct(dilation, jump, s.dilation[at + k]);
        }
        storeRow(sum, jumps.first[c - begin]);
        if constexpr (Dim == 3) storeRow(rest, jumps.rest[c - begin]);
        if constexpr (kDilation) storeRow(dilation, jumps.dilation[c - begin]);
    }
}

template <int Dim>
HWY_ATTR HWY_INLINE V traceOf(const V* diagonal) {
    V trace = diagonal[0] + diagonal[1];
    if constexpr (Dim == 3) trace = trace + diagonal[2];
    return trace;
}

/// Computes 2 L = F T + G X + H I with the cell's tensor T and the sum X of the weighted jumps.
template <int Dim, Jump kJump>
HWY_ATTR HWY_INLINE void doubledL(const Cells<Dim>& s, int c, const Jumps<Dim>& jumps, int i,
                                  V (&L)[Dim * (Dim + 1) / 2]) {
    constexpr int kTensor = Dim * (Dim + 1) / 2;
    V T[kTensor], X[kTensor];
    loadTensor(s.tensor + 4 * static_cast<std::ptrdiff_t>(c),
               s.tensorRest + 2 * static_cast<std::ptrdiff_t>(c), T);
    loadTensor(jumps.first[i], jumps.rest[i], X);
    const V measure = load(s.measure + c), q = load(s.q + c), r = load(s.r + c);
    V F, G, H;
    if constexpr (kJump == Jump::Stress) {
        F = set(0.5) * measure, G = set(8) * q, H = set(2) * r * traceOf<Dim>(X);
    } else {
        F = set(2) * measure * q, G = set(2), H = measure * r * traceOf<Dim>(T);
        if constexpr (kJump == Jump::Strain) {
            V d[4];
            loadLanes(jumps.dilation[i], 4, d[0], d[1], d[2], d[3]);
            H = H + traceOf<Dim>(d);
        }
        H = set(0.5) * H;
    }
#pragma GCC unroll 6
    for (int t = 0; t < kTensor; ++t) {
        L[t] = hn::MulAdd(G, X[t], F * T[t]);
        if (t < Dim) L[t] = L[t] + H;
    }
}

/// Stores f_k = 2 L g_k; corner 0 has minus their sum.
template <int Dim>
HWY_ATTR HWY_INLINE void storeForces(const V (&L)[Dim * (Dim + 1) / 2], const double* gradients,
                                     std::ptrdiff_t n, double* force) {
    constexpr int kPlace[3][3] = {{0, Dim, 4}, {Dim, 1, 5}, {4, 5, 2}};  // of L[a][b] in a tensor
    V sum[Dim];
#pragma GCC unroll 3
    for (int k = 0; k < Dim; ++k) {
        V g[Dim], f[Dim];
#pragma GCC unroll 3
        for (int b = 0; b < Dim; ++b) g[b] = load(gradients + (k * Dim + b) * n);
#pragma GCC unroll 3
        for (int a = 0; a < Dim; ++a) {
            f[a] = L[kPlace[a][0]] * g[0];
#pragma GCC unroll 3
            for (int b = 1; b < Dim; ++b) f[a] = hn::MulAdd(L[kPlace[a][b]], g[b], f[a]);
            sum[a] = k == 0 ? hn::Neg(f[a]) : sum[a] - f[a];
        }
        storeForce<Dim>(f, force + Cells<Dim>::kPoint * (k + 1));
    }
    storeForce<Dim>(sum, force);
}

/// Implements forces() for one SIMD target and one kind of jump, in blocks of cells whose jumps are gathered
/// first.
template <int Dim, Jump kJump>
HWY_ATTR HWY_INLINE void forcesOf(const Cells<Dim>& s, int begin, int end, double* force) {
    const int n = padded(s.count);
    Jumps<Dim> jumps;
    for (int first = begin; first < end; first += kBlock) {
        const int last = HWY_MIN(first + kBlock, padded(end));
        gatherJumps<Dim, kJump == Jump::Strain>(s, first, last, jumps);
        for (int c = first; c < last; c += kLanes) {
            V L[Dim * (Dim + 1) / 2];
            doubledL<Dim, kJump>(s, c, jumps, c - first, L);
            storeForces<Dim>(L, s.gradients + c, n,
                             force + Cells<Dim>::kPoint * (Dim + 1) * static_cast<std::ptrdiff_t>(c));
        }
    }
}

/// Implements sumForces() for one SIMD target. Two sums run side by side, because each addition waits for the
/// one before it.
template <int Dim>
HWY_ATTR HWY_INLINE void sumForcesOf(const int* start, const int* corners, const double* force, int begin,
                                     int end, double* sums) {
    constexpr int kPoint = Cells<Dim>::kPoint;
    for (int v = begin; v < end; ++v) {
        Row<kPoint> sum[2] = {zeroRow<kPoint>(), zeroRow<kPoint>()};
        for (int i = start[v]; i < start[v + 1]; i += kPadding)
#pragma GCC unroll 4
            for (int k = 0; k < kPadding; ++k)
                sum[k % 2] = sum[k % 2] +
                             loadRow<kPoint>(force + kPoint * static_cast<std::ptrdiff_t>(corners[i + k]));
        const Row<kPoint> total = sum[0] + sum[1];
        if constexpr (Dim == 2)
            storeRow(total, sums + 2 * static_cast<std::ptrdiff_t>(v));
        else
            storeTriple(total, sums + 3 * static_cast<std::ptrdiff_t>(v));
    }
}

/// The edges of a block's facets to their vertex 0, and the vectors between the two cells' centroids.
template <int Dim>
struct FacetRows {
    HWY_ALIGN double edge[kBlock][4], other[kBlock][4], between[kBlock][4];
};

/// Gathers the points of a block of facets, and the centroids of their cells, into rows.
template <int Dim>
HWY_ATTR HWY_INLINE void gatherFacets(const Facets<Dim>& s, const Cells<Dim>& cells, int begin, int end,
                                      const double* x, FacetRows<Dim>& rows) {
    constexpr int kPoint = Cells<Dim>::kPoint;
    for (int f = begin; f < end; ++f) {
        const int* const vertices = s.vertices + Dim * static_cast<std::ptrdiff_t>(f);
        const int* const sides = s.cells + 2 * static_cast<std::ptrdiff_t>(f);
        const auto first = loadPoint<Dim>(x, vertices[0]);
        const auto between =
            loadRow<kPoint>(cells.centroids + kPoint * static_cast<std::ptrdiff_t>(sides[1])) -
            loadRow<kPoint>(cells.centroids + kPoint * static_cast<std::ptrdiff_t>(sides[0]));
        storeRow(loadPoint<Dim>(x, vertices[1]) - first, rows.edge[f - begin]);
        storeRow(between, Dim == 2 ? rows.edge[f - begin] + 2 : rows.between[f - begin]);
        if constexpr (Dim == 3) storeRow(loadPoint<3>(x, vertices[2]) - first, rows.other[f - begin]);
    }
}

/// Computes the facets' measures, and the squares of the distances between centroids.
HWY_INLINE void measureFacets(const FacetRows<2>& rows, int i, V& measure, V& squared) {
    V x, y, dx, dy;
    loadLanes(rows.edge[i], 4, x, y, dx, dy);
    measure = hn::Sqrt(x * x + y * y);
    squared = dx * dx + dy * dy;
}
HWY_INLINE void measureFacets(const FacetRows<3>& rows, int i, V& measure, V& squared) {
    V u[3], v[3], d[3], zero;
    loadLanes(rows.edge[i], 4, u[0], u[1], u[2], zero);
    loadLanes(rows.other[i], 4, v[0], v[1], v[2], zero);
    loadLanes(rows.between[i], 4, d[0], d[1], d[2], zero);
    const V n0 = u[1] * v[2] - u[2] * v[1], n1 = u[2] * v[0] - u[0] * v[2], n2 = u[0] * v[1] - u[1] * v[0];
    measure = set(0.5) * hn::Sqrt(n0 * n0 + n1 * n1 + n2 * n2);
    squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

/// Implements facetWeights() for one SIMD target, in blocks of facets whose points are gathered first.
template <int Dim, bool kStress>
HWY_ATTR HWY_INLINE void weightsOf(const Facets<Dim>& s, const Cells<Dim>& cells, int begin, int end,
                                   const double* x, double factor) {
    FacetRows<Dim> rows;
    for (int first = begin; first < end; first += kBlock) {
        const int last = HWY_MIN(first + kBlock, padded(end));
        gatherFacets<Dim>(s, cells, first, last, x, rows);
        for (int f = first; f < last; f += kLanes) {
            V measure, squared;
            measureFacets(rows, f - first, measure, squared);
            V weight = set(factor) * measure;
            if constexpr (!kStress) weight = weight / hn::Sqrt(squared);
            store(weight, s.weight + f);
            store(kStress ? weight : weight * load(s.q + f), s.shear + f);
            if constexpr (!kStress) store(weight * load(s.r + f), s.dilation + f);
        }
    }
}

}  // namespace

// Functions that can be exported are no templates.
#define WEND_KERNELS(Dim)                                                                             \
    void geometry##Dim(const Cells<Dim>& s, int begin, int end, const double* x) {                    \
        geometryOf<Dim>(s, begin, end, x);                                                            \
    }                                                                                                 \
    void weights##Dim(bool stress, const Facets<Dim>& s, const Cells<Dim>& cells, int begin, int end, \
                      const double* x, double factor) {                                               \
        stress ? weightsOf<Dim, true>(s, cells, begin, end, x, factor)                                \
               : weightsOf<Dim, false>(s, cells, begin, end, x, factor);                              \
    }                                                                                                 \
    void tensors##Dim(bool stress, const Cells<Dim>& s, int begin, int end, const double* v) {        \
        stress ? tensorsOf<Dim, true>(s, begin, end, v) : tensorsOf<Dim, false>(s, begin, end, v);    \
    }                                                                                                 \
    void forces##Dim##Shear(const Cells<Dim>& s, int begin, int end, double* force) {                 \
        forcesOf<Dim, Jump::Shear>(s, begin, end, force);                                             \
    }                                                                                                 \
    void forces##Dim##Strain(const Cells<Dim>& s, int begin, int end, double* force) {                \
        forcesOf<Dim, Jump::Strain>(s, begin, end, force);                                            \
    }                                                                                                 \
    void forces##Dim##Stress(const Cells<Dim>& s, int begin, int end, double* force) {                \
        forcesOf<Dim, Jump::Stress>(s, begin, end, force);                                            \
    }                                                                                                 \
    void sums##Dim(const int* start, const int* corners, const double* force, int begin, int end,     \
                   double* sums) {                                                                    \
        sumForcesOf<Dim>(start, corners, force, begin, end, sums);                                    \
    }
WEND_KERNELS(2)
WEND_KERNELS(3)
#undef WEND_KERNELS

}  // namespace HWY_NAMESPACE
}  // namespace wend::isotropic
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend::isotropic {
namespace {

HWY_EXPORT(geometry2);
HWY_EXPORT(geometry3);
HWY_EXPORT(weights2);
HWY_EXPORT(weights3);
HWY_EXPORT(tensors2);
HWY_EXPORT(tensors3);
HWY_EXPORT(forces2Shear);
HWY_EXPORT(forces3Shear);
HWY_EXPORT(forces2Strain);
HWY_EXPORT(forces3Strain);
HWY_EXPORT(forces2Stress);
HWY_EXPORT(forces3Stress);
HWY_EXPORT(sums2);
HWY_EXPORT(sums3);

}  // namespace

template <int Dim>
int geometry(const Cells<Dim>& cells, int begin, int end, const double* points) {
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(geometry2)(cells, begin, end, points);
    else
        HWY_DYNAMIC_DISPATCH(geometry3)(cells, begin, end, points);
    constexpr double kLeast = std::numeric_limits<double>::min();  // 1 / m is finite
    const double* const bad =
        std::find_if(cells.measure + begin, cells.measure + end, [](double m) { return !(m >= kLeast); });
    return static_cast<int>(bad - cells.measure);
}

template <int Dim>
void facetWeights(Jump jump, const Facets<Dim>& facets, const Cells<Dim>& cells, int begin, int end,
                  const double* points, double factor) {
    const bool stress = jump == Jump::Stress;
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(weights2)(stress, facets, cells, begin, end, points, factor);
    else
        HWY_DYNAMIC_DISPATCH(weights3)(stress, facets, cells, begin, end, points, factor);
}

template <int Dim>
void spreadWeights(Jump jump, const Facets<Dim>& facets, const Cells<Dim>& cells, int begin, int end) {
    const int first = (Dim + 1) * begin, last = (Dim + 1) * end;
    for (int i = first; i < last; ++i) cells.shear[i] = facets.shear[cells.facets[i]];
    // Jumps of shear and of stress have none.
    if (jump == Jump::Strain)
        for (int i = first; i < last; ++i) cells.dilation[i] = facets.dilation[cells.facets[i]];
}

template <int Dim>
void tensors(Jump jump, const Cells<Dim>& cells, int begin, int end, const double* v) {
    const bool stress = jump == Jump::Stress;
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(tensors2)(stress, cells, begin, end, v);
    else
        HWY_DYNAMIC_DISPATCH(tensors3)(stress, cells, begin, end, v);
}

template <int Dim>
void forces(Jump jump, const Cells<Dim>& cells, int begin, int end, double* force) {
    const auto choose = [&](auto* shear, auto* strain, auto* stress) {
        (jump == Jump::Shear ? shear : jump == Jump::Strain ? strain : stress)(cells, begin, end, force);
    };
    if constexpr (Dim == 2)
        choose(&HWY_DYNAMIC_DISPATCH(forces2Shear), &HWY_DYNAMIC_DISPATCH(forces2Strain),
               &HWY_DYNAMIC_DISPATCH(forces2Stress));
    else
        choose(&HWY_DYNAMIC_DISPATCH(forces3Shear), &HWY_DYNAMIC_DISPATCH(forces3Strain),
               &HWY_DYNAMIC_DISPATCH(forces3Stress));
}

template <int Dim>
void sumForces(const int* start, const int* corners, const double* force, int begin, int end, double* sums) {
    if constexpr (Dim == 2)
        HWY_DYNAMIC_DISPATCH(sums2)(start, corners, force, begin, end, sums);
    else
        HWY_DYNAMIC_DISPATCH(sums3)(start, corners, force, begin, end, sums);
}

#define WEND_INSTANTIATE(Dim)                                                                        \
    template int geometry(const Cells<Dim>&, int, int, const double*);                               \
    template void facetWeights(Jump, const Facets<Dim>&, const Cells<Dim>&, int, int, const double*, \
                               double);                                                              \
    template void spreadWeights(Jump, const Facets<Dim>&, const Cells<Dim>&, int, int);              \
    template void tensors(Jump, const Cells<Dim>&, int, int, const double*);                         \
    template void forces(Jump, const Cells<Dim>&, int, int, double*);                                \
    template void sumForces<Dim>(const int*, const int*, const double*, int, int, double*);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend::isotropic
#endif
