#include "mpi/division.h"

#include <algorithm>
#include <numeric>

namespace wend {

template <int Dim>
WeightedGraph groupGraph(const AssemblyPlan<Dim>& plan, const std::vector<int>& groupOf, int groups) {
    WeightedGraph graph;
    graph.nodeWeight.assign(groups, 0);
    std::vector<std::vector<int>> verticesOf(groups);
    for (int v = 0; v < plan.vertexCount; ++v)
        if (groupOf[v] >= 0) verticesOf[groupOf[v]].push_back(v);
    std::vector<int> around;
    for (int group = 0; group < groups; ++group) {
        graph.nodeWeight[group] = static_cast<int>(verticesOf[group].size());
        around.clear();
        for (int v : verticesOf[group])
            for (int i = plan.cornerStart[v]; i < plan.cornerStart[v + 1]; ++i)
                for (int other : plan.cells[plan.corners[i] / (Dim + 1)])
                    if (groupOf[other] >= 0 && groupOf[other] != group) around.push_back(groupOf[other]);
        std::sort(around.begin(), around.end());
        for (auto at = around.begin(); at != around.end();) {
            const auto next = std::upper_bound(at, around.end(), *at);
            graph.neighbour.push_back(*at);
            graph.edgeWeight.push_back(static_cast<int>(next - at));
            at = next;
        }
        graph.start.push_back(static_cast<int>(graph.neighbour.size()));
    }
    return graph;
}

template <int Dim>
Division<Dim>::Division(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system,
                        std::vector<int> ownerOf, int parts)
    : m_plan(plan),
      m_system(system),
      m_ownerOf(std::move(ownerOf)),
      m_pivotOf(plan.vertexCount, -1),
      m_parts(parts) {
    const auto& pivots = system.elimination().pivots;
    for (std::size_t i = 0; i < pivots.size(); ++i) m_pivotOf[pivots[i].vertex] = static_cast<int>(i);
    for (std::size_t i = 0; i < pivots.size(); ++i) m_homeOf.push_back(homeOf(i));
}

/// Returns the part of an unknown that determines the pivot or shares a cell with it; if there is none,
/// spreads the pivots evenly over the parts.
template <int Dim>
int Division<Dim>::homeOf(std::size_t pivot) const {
    const auto& [vertex, row, values, free] = m_system.elimination().pivots[pivot];
    for (const auto& [other, weight] : free)
        if (isUnknown(other)) return m_ownerOf[other];
    for (int i = m_plan.cornerStart[vertex]; i < m_plan.cornerStart[vertex + 1]; ++i)
        for (int other : m_plan.cells[m_plan.corners[i] / (Dim + 1)])
            if (isUnknown(other)) return m_ownerOf[other];
    return static_cast<int>(pivot * static_cast<std::size_t>(m_parts) / m_system.elimination().pivots.size());
}

/// Returns the vertices whose rows of A a part needs: its own unknowns, the pivots that depend on them, and
/// the pivots that are assigned to it.
template <int Dim>
std::vector<int> Division<Dim>::rowsOf(int number) const {
    std::vector<int> rows;
    for (int v : m_system.unknowns())
        if (m_ownerOf[v] == number) rows.push_back(v);
    const auto& pivots = m_system.elimination().pivots;
    for (std::size_t i = 0; i < pivots.size(); ++i)
        if (m_homeOf[i] == number ||
            std::any_of(pivots[i].free.begin(), pivots[i].free.end(),
                        [&](const auto& term) { return m_ownerOf[term.first] == number; }))
            rows.push_back(pivots[i].vertex);
    return rows;
}

/// Adds the cells around a vertex, and those across their facets.
template <int Dim>
void Division<Dim>::addCellsOf(int vertex, std::vector<char>& hasCell, std::vector<int>& cells) const {
    const auto add = [&](int cell) {
        if (!std::exchange(hasCell[cell], 1)) cells.push_back(cell);
    };
    for (int i = m_plan.cornerStart[vertex]; i < m_plan.cornerStart[vertex + 1]; ++i) {
        const int cell = m_plan.corners[i] / (Dim + 1);
        add(cell);
        for (int facet : m_plan.facetOfCorner[cell])
            if (facet >= 0) add(m_plan.across(facet, cell));
    }
}

/// Gives every unknown that a pivot with a cell follows from one cell at least.
template <int Dim>
void Division<Dim>::close(std::vector<char>& hasCell, std::vector<int>& cells) const {
    std::vector<char> seen(m_plan.vertexCount, 0);
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (int v : m_plan.cells[cells[i]]) {
            if (std::exchange(seen[v], 1) || m_pivotOf[v] < 0) continue;
            for (const auto& [other, weight] : m_system.elimination().pivots[m_pivotOf[v]].free) {
                if (!isUnknown(other)) continue;
                const auto first = m_plan.corners.begin() + m_plan.cornerStart[other],
                           last = m_plan.corners.begin() + m_plan.cornerStart[other + 1];
                if (std::any_of(first, last, [&](int corner) { return hasCell[corner / (Dim + 1)] != 0; }))
                    continue;
                const int cell = *first / (Dim + 1);
                hasCell[cell] = 1;
                cells.push_back(cell);
            }
        }
}

/// Lists the vertices in their order, and what is copied from where.
template <int Dim>
void Division<Dim>::number(int number, const std::vector<char>& hasVertex, Part<Dim>& part) const {
    std::vector<std::vector<int>> copied(m_parts);
    std::vector<int> others;
    for (int v = 0; v < m_plan.vertexCount; ++v) {
        if (!hasVertex[v]) continue;
        if (!isUnknown(v))
            others.push_back(v);
        else if (m_ownerOf[v] == number)
            part.vertices.push_back(v);
        else
            copied[m_ownerOf[v]].push_back(v);
    }
    part.own = static_cast<int>(part.vertices.size());
    for (int owner = 0; owner < m_parts; ++owner) {
        if (copied[owner].empty()) continue;
        part.neighbours.push_back(
            {owner, {}, static_cast<int>(part.vertices.size()), static_cast<int>(copied[owner].size())});
        part.vertices.insert(part.vertices.end(), copied[owner].begin(), copied[owner].end());
    }
    part.copies = static_cast<int>(part.vertices.size()) - part.own;
    part.vertices.insert(part.vertices.end(), others.begin(), others.end());
}

template <int Dim>
void Division<Dim>::copyConstraints(const std::vector<int>& local, Part<Dim>& part) const {
    for (const auto& pivot : m_system.elimination().pivots) {
        if (local[pivot.vertex] < 0) continue;
        Elimination::Pivot copy;
        copy.vertex = local[pivot.vertex];
        for (const auto& [other, weight] : pivot.free)
            if (local[other] >= 0 && isUnknown(other)) copy.free.emplace_back(local[other], weight);
        if (m_homeOf[m_pivotOf[pivot.vertex]] == part.number) part.followers.push_back(copy.vertex);
        part.elimination.pivots.push_back(std::move(copy));
    }
    for (const auto& slider : m_system.sliders().vertices()) {
        const int v = local[slider.vertex];
        if (v < 0) continue;
        if (slider.isAlongAxes) {
            part.sliders.push_back({v, slider.held});
            continue;
        }
        for (const auto& row : slider.rows) {
            part.sliders.push_back({v});
            part.sliders.back().normal.template head<Dim>() = row.direction;
        }
    }
}

template <int Dim>
Part<Dim> Division<Dim>::part(int number) const {
    Part<Dim> part;
    part.number = number;
    std::vector<char> hasCell(m_plan.cells.size(), 0), hasVertex(m_plan.vertexCount, 0);
    for (int v : rowsOf(number)) {
        hasVertex[v] = 1;
        addCellsOf(v, hasCell, part.cells);
    }
    close(hasCell, part.cells);
    std::sort(part.cells.begin(), part.cells.end());
    for (int cell : part.cells)
        for (int v : m_plan.cells[cell]) hasVertex[v] = 1;
    this->number(number, hasVertex, part);
    for (std::size_t i = 0; i < m_system.unknowns().size(); ++i)
        if (m_ownerOf[m_system.unknowns()[i]] == number) part.unknowns.push_back(static_cast<int>(i));
    std::vector<int> local(m_plan.vertexCount, -1);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) local[part.vertices[i]] = static_cast<int>(i);
    for (int cell : part.cells) {
        part.corners.push_back(m_plan.cells[cell]);
        for (int& v : part.corners.back()) v = local[v];
    }
    copyConstraints(local, part);
    return part;
}

template <int Dim>
std::vector<Part<Dim>> allParts(const Division<Dim>& division) {
    std::vector<Part<Dim>> parts;
    for (int i = 0; i < division.parts(); ++i) parts.push_back(division.part(i));
    for (int i = 0; i < division.parts(); ++i) {
        const auto& from = parts[i].neighbours;
        for (std::size_t n = 0; n < from.size(); ++n) {
            if (from[n].copies == 0) continue;
            auto& owner = parts[from[n].part];
            std::vector<int> sent;
            const auto ownEnd = owner.vertices.begin() + owner.own;
            for (int k = 0; k < from[n].copies; ++k)
                sent.push_back(static_cast<int>(std::lower_bound(owner.vertices.begin(), ownEnd,
                                                                 parts[i].vertices[from[n].firstCopy + k]) -
                                                owner.vertices.begin()));
            auto& list = owner.neighbours;
            auto at = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.part == i; });
            if (at == list.end()) at = list.insert(list.end(), {i, {}, 0, 0});
            at->sent = std::move(sent);
        }
    }
    return parts;
}

template <int Dim>
Points<Dim> gathered(const Points<Dim>& whole, const std::vector<int>& vertices) {
    Points<Dim> part(Dim, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        part.col(static_cast<Eigen::Index>(i)) = whole.col(vertices[i]);
    return part;
}

#define WEND_INSTANTIATE(Dim)                                                                  \
    template WeightedGraph groupGraph(const AssemblyPlan<Dim>&, const std::vector<int>&, int); \
    template class Division<Dim>;                                                              \
    template std::vector<Part<Dim>> allParts(const Division<Dim>&);                            \
    template Points<Dim> gathered(const Points<Dim>&, const std::vector<int>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
