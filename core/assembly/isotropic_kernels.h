#pragma once

#include "core/base/types.h"

namespace wend::isotropic {

/// Selects the jump over a facet that is weighted: that of the strain S = J + Jᵀ without its dilation (Shear)
/// or with it (Strain), both invariant, or that of the stress (docs/method.md, (12)).
enum class Jump { Shear, Strain, Stress };

/// Arrays have room for a multiple of this many cells and facets, because kernels compute up to three entries
/// beyond the last one, which repeat it.
constexpr int kPadding = 4;
/// Returns the count rounded up to a multiple of kPadding.
constexpr int padded(int count) {
    return (count + kPadding - 1) / kPadding * kPadding;
}

/// Holds the arrays of the back end for B = I. Values that are gathered from other cells are stored together
/// for each cell; all others are structures of arrays, in which number i of cell c is at [i · padded(count) +
/// c]. With q = w_q and r = w_r of a cell or facet, D X = 4 q X + r Tr(X) I and P = D S.
template <int Dim>
struct Cells {
    static constexpr int kCorners = Dim + 1;
    static constexpr int kPoint = Dim == 2 ? 2 : 4;  // doubles of a vector: in space the fourth is 0
    static constexpr int kTensor = 4;                // doubles of the first part of a tensor

    int count = 0;
    const int* vertices = nullptr;  // of cell c at kCorners · c
    const double *q = nullptr, *r = nullptr;
    const double* orientation = nullptr;  // sign of the measure at rest
    const int* facets =
        nullptr;  // at kCorners · c: opposite to the corner; padded(facets' count) where there is none
    const int* neighbours = nullptr;  // at kCorners · c: the cell across, the cell itself where there is none
    double* measure = nullptr;
    double* gradients =
        nullptr;  // Dim × Dim: number Dim · (k − 1) + a of corner k ≥ 1; corner 0 has minus their sum
    double* centroids = nullptr;  // at kPoint · c
    // At kCorners · c: weight · q and weight · r of the facet opposite to the corner, 0 where there is none;
    // with stress jumps the weight alone.
    double *shear = nullptr, *dilation = nullptr;
    // S, with stress jumps P: (xx, yy, xy, 0) or (xx, yy, zz, xy) at kTensor · c, in space (xz, yz) at 2 c.
    double *tensor = nullptr, *tensorRest = nullptr;
};

/// Holds the arrays of the interior facets in the same layout.
template <int Dim>
struct Facets {
    int count = 0;
    const int *vertices = nullptr, *cells = nullptr;  // of facet f at Dim · f; at 2 f
    const double *q = nullptr, *r = nullptr;
    // weight; weight · q and weight · r, with stress jumps weight and 0. One entry more than padded(count):
    // 0.
    double *weight = nullptr, *shear = nullptr, *dilation = nullptr;
};

/// Computes gradients, measure and centroid of the cells [begin, end). Returns the first cell whose measure
/// is not positive, or `end`. Here and below, `begin` is a multiple of kPadding, and so is `end` unless it is
/// the count.
template <int Dim>
int geometry(const Cells<Dim>& cells, int begin, int end, const double* points);

/// Computes the weights of facets, weight = factor · B / h or factor · B (docs/method.md, (10) and (12)), and
/// their products with q and r.
template <int Dim>
void facetWeights(Jump jump, const Facets<Dim>& facets, const Cells<Dim>& cells, int begin, int end,
                  const double* points, double factor);

/// Copies the facets' weights to the corners opposite to them.
template <int Dim>
void spreadWeights(Jump jump, const Facets<Dim>& facets, const Cells<Dim>& cells, int begin, int end);

/// Computes the tensor of a nodal field v in every cell: S, or P with stress jumps.
template <int Dim>
void tensors(Jump jump, const Cells<Dim>& cells, int begin, int end, const double* v);

/// Computes the forces of a cell on its corners, 2 L g_k with L = ¼ V P + ¼ Σ weight D_facet (S −
/// S_neighbour), or ¼ V P + D Σ weight (P − P_neighbour) with stress jumps, and stores them at kPoint ·
/// (kCorners · cell + corner).
template <int Dim>
void forces(Jump jump, const Cells<Dim>& cells, int begin, int end, double* force);

/// Sums the forces on every vertex of [begin, end), which are at kPoint · corners[i] for i in [start[v],
/// start[v + 1]). The number of corners of a vertex is a multiple of kPadding, since the processor predicts
/// loops of few different lengths. `sums` has Dim doubles per vertex.
template <int Dim>
void sumForces(const int* start, const int* corners, const double* force, int begin, int end, double* sums);

}  // namespace wend::isotropic
