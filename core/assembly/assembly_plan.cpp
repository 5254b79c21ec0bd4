#include "core/assembly/assembly_plan.h"

#include <algorithm>
#include <numeric>

namespace wend {
namespace {

/// A contribution before it is sorted into its block. Facet −1 means that both corners are in one cell.
struct PlannedContribution {
    int row, facet, left, right;
};

/// Lists the interior facets, and for every corner the facet opposite to it.
template <int Dim>
void addInteriorFacets(const SimplicialMesh<Dim>& mesh, AssemblyPlan<Dim>& plan) {
    for (const auto& facet : facetsOf(mesh)) {
        if (!facet.interior()) continue;
        for (int cell : facet.cells)
            for (int k = 0; k <= Dim; ++k) {
                const auto& on = facet.vertices;
                if (std::find(on.begin(), on.end(), mesh.cells[cell][k]) == on.end())
                    plan.facetOfCorner[cell][k] = static_cast<int>(plan.facets.size());
            }
        plan.facets.push_back(facet);
    }
}

/// Lists the corners of every vertex in ascending order, by a counting sort.
template <int Dim>
void listCorners(AssemblyPlan<Dim>& plan) {
    plan.cornerStart.assign(plan.vertexCount + 1, 0);
    for (const auto& cell : plan.cells)
        for (int v : cell) ++plan.cornerStart[v + 1];
    std::partial_sum(plan.cornerStart.begin(), plan.cornerStart.end(), plan.cornerStart.begin());
    plan.corners.resize(plan.cornerStart.back());
    auto next = plan.cornerStart;
    for (int c = 0; c < plan.cellCount(); ++c)
        for (int k = 0; k <= Dim; ++k) plan.corners[next[plan.cells[c][k]]++] = c * (Dim + 1) + k;
}

/// Calls visit(row vertex, column vertex, left corner, right corner, facet) for every contribution of the
/// lower triangle.
template <int Dim, typename Visit>
void forContributions(const AssemblyPlan<Dim>& plan, Visit&& visit) {
    const auto pairs = [&](int left, int right, int facet) {
        for (int a = 0; a <= Dim; ++a)
            for (int b = 0; b <= Dim; ++b) {
                const int p = plan.cells[left][a], q = plan.cells[right][b];
                if (p >= q) visit(p, q, left * (Dim + 1) + a, right * (Dim + 1) + b, facet);
            }
    };
    for (int c = 0; c < plan.cellCount(); ++c) pairs(c, c, -1);
    for (std::size_t f = 0; f < plan.facets.size(); ++f) {
        // ‖J_j − J_i‖² couples every corner of one cell to every corner of the other, in both orders; its
        // squares are part of the cells' own contributions.
        const auto [i, j] = plan.facets[f].cells;
        pairs(i, j, static_cast<int>(f));
        pairs(j, i, static_cast<int>(f));
    }
}

/// Appends a block column to the plan: contributions are sorted by row, stably, so that their order does not
/// depend on the sorting algorithm, and each new row begins a block.
template <int Dim>
void appendColumn(std::vector<PlannedContribution>& column, AssemblyPlan<Dim>& plan) {
    std::stable_sort(column.begin(), column.end(),
                     [](const auto& a, const auto& b) { return a.row < b.row; });
    for (std::size_t i = 0; i < column.size(); ++i) {
        const auto& c = column[i];
        if (i == 0 || c.row != column[i - 1].row) {
            plan.row.push_back(c.row);
            plan.ownStart.push_back(static_cast<int>(plan.own.size()));
            plan.crossStart.push_back(static_cast<int>(plan.cross.size()));
        }
        if (c.facet < 0)
            plan.own.push_back({c.left, c.right});
        else
            plan.cross.push_back({c.left, c.right, c.facet});
    }
    plan.columnStart.push_back(plan.blockCount());
}

/// Builds the block pattern and the lists of contributions. Contributions are first distributed to their
/// columns by a counting sort, then each column is sorted by rows.
template <int Dim>
void buildPattern(AssemblyPlan<Dim>& plan) {
    std::vector<std::size_t> start(plan.vertexCount + 1, 0);
    forContributions(plan, [&](int, int q, int, int, int) { ++start[q + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<PlannedContribution> all(start.back());
    auto next = start;
    forContributions(plan, [&](int p, int q, int left, int right, int facet) {
        all[next[q]++] = {p, facet, left, right};
    });
    plan.columnStart.assign(1, 0);
    std::vector<PlannedContribution> column;
    for (int q = 0; q < plan.vertexCount; ++q) {
        column.assign(all.begin() + static_cast<std::ptrdiff_t>(start[q]),
                      all.begin() + static_cast<std::ptrdiff_t>(start[q + 1]));
        appendColumn(column, plan);
    }
    plan.ownStart.push_back(static_cast<int>(plan.own.size()));
    plan.crossStart.push_back(static_cast<int>(plan.cross.size()));
}

}  // namespace

template <int Dim>
AssemblyPlan<Dim> makeAssemblyPlan(const SimplicialMesh<Dim>& mesh, bool smoothing,
                                   Contributions contributions) {
    AssemblyPlan<Dim> plan;
    plan.vertexCount = mesh.vertexCount();
    plan.cells = mesh.cells;
    plan.facetOfCorner.resize(mesh.cells.size());
    for (auto& facets : plan.facetOfCorner) facets.fill(-1);
    if (smoothing) addInteriorFacets(mesh, plan);
    listCorners(plan);
    if (contributions == Contributions::Listed) buildPattern(plan);
    return plan;
}

template AssemblyPlan<2> makeAssemblyPlan(const SimplicialMesh<2>&, bool, Contributions);
template AssemblyPlan<3> makeAssemblyPlan(const SimplicialMesh<3>&, bool, Contributions);

}  // namespace wend
