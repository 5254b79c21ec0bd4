#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The number of items in a piece of work for one thread. It is large enough to hide the cost of handing work
/// over, and fixed, so that partial sums do not depend on the number of threads.
constexpr int kPlanGrain = 1024;

/// Describes the assembly for one topology: the sparse pattern of A as blocks of vertex pairs, and for each
/// nonzero block the list of its contributions in a fixed order. Every block is therefore gathered by one
/// thread, without atomics, and sums have the same bits for any number of threads. All arrays are flat, so
/// that a device can take them unchanged.
///
/// With G_a the strain operator of corner a (strainColumns) and T_a = D G_a its stress, in Mandel
/// coordinates:
///   A_pq = ¼ (Σ_own G_leftᵀ (V D + Σ_facets weight D_f) G_right − Σ_cross weight G_leftᵀ D_f G_right)
/// where D_f is the stress matrix of q over a facet; with the paper's smoothness
///   A_pq = Σ_own G_leftᵀ (¼ V D + Σ_facets weight D²) G_right − Σ_cross weight T_leftᵀ T_right.
template <int Dim>
struct AssemblyPlan {
    static constexpr int kCorners = Dim + 1;

    /// Names two corners of one cell. The number of a corner is cell · kCorners + local index.
    struct Own {
        int left, right;
    };
    /// Names two corners in the two cells of an interior facet.
    struct Cross {
        int left, right, facet;
    };

    int vertexCount = 0;
    std::vector<Cell<Dim>> cells;
    std::vector<Facet<Dim>> facets;                       // interior ones only; none without smoothing
    std::vector<std::array<int, Dim + 1>> facetOfCorner;  // the interior facet opposite to a corner, or −1
    std::vector<int> cornerStart, corners;                // per vertex: its corners, ascending

    std::vector<int> columnStart, row;      // block pattern by columns, rows ≥ column, ascending
    std::vector<int> ownStart, crossStart;  // per block: where its contributions begin
    std::vector<Own> own;
    std::vector<Cross> cross;

    int cellCount() const { return static_cast<int>(cells.size()); }
    int blockCount() const { return static_cast<int>(row.size()); }
    /// Returns the cell on the other side of an interior facet.
    int across(int facet, int cell) const {
        const auto& sides = facets[facet].cells;
        return sides[0] == cell ? sides[1] : sides[0];
    }
};

/// Says whether a plan lists the contributions to the matrix. In a solid these are about 300 per vertex and
/// take most of the memory; without them a back end applies A, but cannot assemble it.
enum class Contributions { Listed, Left };

/// Makes the plan of a valid mesh. Without `smoothing` it has no facets, and the pattern is the one-ring of
/// E_φ alone. With it a vertex is coupled to those of the cells across its cells' facets, too. Contributions
/// that are left out leave `columnStart`, `row`, `own` and `cross` empty. Takes time O(n log n) in the number
/// of contributions, the logarithm being that of a vertex's contributions, and depends on the order of the
/// mesh alone.
template <int Dim>
AssemblyPlan<Dim> makeAssemblyPlan(const SimplicialMesh<Dim>& mesh, bool smoothing,
                                   Contributions contributions = Contributions::Listed);

}  // namespace wend
