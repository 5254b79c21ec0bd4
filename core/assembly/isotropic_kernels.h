#pragma once

#include "core/mesh/types.h"

namespace wend::isotropic {

/// Which jump over a facet is weighted: that of the strain S = J + Jᵀ without or with its dilation
/// (invariant), or that of the stress (docs/method.md, (12)).
enum class Jump { Shear, Strain, Stress };

/// The loops of the back end for B = I over cells and facets, as structures of arrays: entry i of item c lies
/// at [i · count + c]. With q = w_q, r = w_r of a cell or facet: D X = 4 q X + r Tr(X) I, P = D S.
/// Symmetric tensors as their diagonal, then the entries above it by rows.
template <int Dim>
struct Cells {
    int count = 0;
    const int* vertices = nullptr;  // Dim + 1
    const double *q = nullptr, *r = nullptr;
    const double* orientation = nullptr;  // sign of the measure at rest
    const int* facets = nullptr;          // Dim + 1: opposite to the corner, −1: none
    const int* neighbours = nullptr;      // Dim + 1: the cell across, the cell itself where there is none
    double* measure = nullptr;
    double* gradients =
        nullptr;  // Dim × Dim: [Dim · (k − 1) + a] of corners k ≥ 1; corner 0 has minus their sum
    double* centroids = nullptr;  // Dim
    // Dim + 1: weight · q and weight · r of the facet opposite to the corner, 0 where there is none; with
    // stress jumps the weight alone.
    double *shear = nullptr, *dilation = nullptr;
    double* tensor = nullptr;  // Dim (Dim + 1) / 2: S, with stress jumps P
};

template <int Dim>
struct Facets {
    int count = 0;
    const int *vertices = nullptr, *cells = nullptr;  // Dim; 2
    double* weight = nullptr;
};

/// Gradients, measure, centroid of cells [begin, end); returns the first whose measure is not positive, or
/// `end`.
template <int Dim>
int geometry(const Cells<Dim>& cells, int begin, int end, const double* points);

/// weight = factor · B / h, or factor · B (docs/method.md, (10) and (12)).
template <int Dim>
void facetWeights(const Facets<Dim>& facets, const Cells<Dim>& cells, int begin, int end,
                  const double* points, double factor, bool overDistance);

/// The tensor of a nodal field.
template <int Dim>
void tensors(Jump jump, const Cells<Dim>& cells, int begin, int end, const double* v);

/// The forces of a cell on its corners, 2 L g_k with L = ¼ V P + ¼ Σ weight D_facet (S − S_neighbour), or
/// ¼ V P + D Σ weight (P − P_neighbour): [corner][axis] per cell.
template <int Dim>
void forces(Jump jump, const Cells<Dim>& cells, int begin, int end, double* force);

}  // namespace wend::isotropic
