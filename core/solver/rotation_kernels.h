#pragma once

namespace wend::rotations {

/// Vertices are computed in groups of so many; arrays of matrices have room for the last group.
constexpr int kGroup = 4;
constexpr int grouped(int count) {
    return (count + kGroup - 1) / kGroup * kGroup;
}

/// The neighbours of every vertex, one list after the other, each made as long as a multiple of kGroup with
/// the vertex itself: loops over them so have few lengths, which the processor foresees.
struct Neighbours {
    const int *start, *list;
    const double* own;  // 1 − how often the list has the vertex itself
};

// The matrices of vertices [begin, end) from those of all or of their points: Dim × Dim numbers each, by
// columns; in the plane the two of (a, −b; b, a).

/// Σ_j (y_j − y) (x_j − x)ᵀ over the edges of a vertex. The rotation that is nearest to it is that of
/// argmin Σ_j ‖(y_j − y) − R (x_j − x)‖². In the plane (a, −b; b, a) is all of it that counts.
void edgeSums2(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums);
void edgeSums3(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums);

/// Every matrix and those of its vertex's neighbours, added up. Sums of edges over a wider surrounding: their
/// lengths and number are the weights.
void addNeighbours2(Neighbours edges, int begin, int end, const double* in, double* out);
void addNeighbours3(Neighbours edges, int begin, int end, const double* in, double* out);

/// The rotations that are nearest to the matrices, in their place: (a, b) / √(a² + b²) in the plane, in space
/// by six steps of Newton's iteration R ← ½ (γ R + R⁻ᵀ / γ), R⁻ᵀ = cof R / det R, with γ² = |R⁻¹| / |R|: of
/// flat cells R is nearly singular, and without it six steps are too few. What remains after them does not
/// matter. The identity where a determinant is not positive. `begin` is a multiple of kGroup.
void nearestRotations2(int begin, int end, double* matrices);
void nearestRotations3(int begin, int end, double* matrices);

}  // namespace wend::rotations
