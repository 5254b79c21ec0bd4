#pragma once

namespace wend::rotations {

/// Vertices are computed in groups of this many; arrays of matrices have room for the last group.
constexpr int kGroup = 4;
constexpr int grouped(int count) {
    return (count + kGroup - 1) / kGroup * kGroup;
}

/// The neighbours of every vertex, one list after the other. Each list is filled up with the vertex itself to
/// a multiple of kGroup, so that the lengths of loops over them are few, which the processor predicts.
struct Neighbours {
    const int *start, *list;
    const double* own;  // 1 − how often the list has the vertex itself
};

// These functions compute the matrices of the vertices [begin, end) from those of all vertices or from their
// points: Dim × Dim numbers each, column-major; in the plane the two of (a, −b; b, a).

/// Compute Σ_j (y_j − y) (x_j − x)ᵀ over the edges of a vertex. The nearest rotation to it minimizes Σ_j
/// ‖(y_j − y) − R (x_j − x)‖². In the plane only its part (a, −b; b, a) matters.
void edgeSums2(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums);
void edgeSums3(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums);

/// Add up every matrix and those of its vertex's neighbours. The results are sums of edges over a wider
/// neighbourhood, weighted by their lengths and number.
void addNeighbours2(Neighbours edges, int begin, int end, const double* in, double* out);
void addNeighbours3(Neighbours edges, int begin, int end, const double* in, double* out);

/// Replace the matrices by the nearest rotations: (a, b) / √(a² + b²) in the plane, in space by six steps of
/// Newton's iteration R ← ½ (γ R + R⁻ᵀ / γ), R⁻ᵀ = cof R / det R, with γ² = |R⁻¹| / |R|. Without γ six steps
/// are too few for flat cells, where R is nearly singular. The error that remains does not matter. The result
/// is the identity if a determinant is not positive. `begin` is a multiple of kGroup.
void nearestRotations2(int begin, int end, double* matrices);
void nearestRotations3(int begin, int end, double* matrices);

}  // namespace wend::rotations
