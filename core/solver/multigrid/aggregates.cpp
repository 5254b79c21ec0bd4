#include "core/solver/multigrid/aggregates.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace wend {
namespace {

std::span<const int> around(const Graph& graph, int i) {
    return {graph.neighbours.data() + graph.start[i], graph.neighbours.data() + graph.start[i + 1]};
}

/// Appends what is left of a list of neighbours once it is ascending without repetitions.
void append(std::vector<int>& list, Graph& graph) {
    std::sort(list.begin(), list.end());
    graph.neighbours.insert(graph.neighbours.end(), list.begin(), std::unique(list.begin(), list.end()));
    graph.start.push_back(static_cast<int>(graph.neighbours.size()));
}

/// Returns the number that comes most often, the least of several; −1 if there is none. Sorts the numbers.
int mostFrequent(std::vector<int>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    int result = -1;
    std::ptrdiff_t most = 0;
    for (auto at = numbers.begin(); at != numbers.end();) {
        const auto next = std::upper_bound(at, numbers.end(), *at);
        if (next - at > most) most = next - at, result = *at;
        at = next;
    }
    return result;
}

}  // namespace

template <int Dim>
Graph graphOf(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system) {
    Graph graph;
    graph.start.push_back(0);
    std::vector<int> list;
    for (int vertex : system.unknowns()) {
        list.clear();
        for (int i = plan.cornerStart[vertex]; i < plan.cornerStart[vertex + 1]; ++i)
            for (int other : plan.cells[plan.corners[i] / (Dim + 1)])
                if (other != vertex && system.unknownOf(other) >= 0) list.push_back(system.unknownOf(other));
        append(list, graph);
    }
    return graph;
}

/// Works in three passes in the order of the unknowns: whole neighbourhoods found groups, others join the
/// group of most of their neighbours as founded, and what has no such neighbour founds one with what is left
/// around it.
Aggregates aggregatesOf(const Graph& graph) {
    Aggregates result;
    auto& of = result.of;
    of.assign(graph.size(), -1);
    const auto found = [&](int i) {
        of[i] = result.count;
        for (int other : around(graph, i))
            if (of[other] < 0) of[other] = result.count;
        ++result.count;
    };
    for (int i = 0; i < graph.size(); ++i) {
        const auto near = around(graph, i);
        const bool alone =
            of[i] < 0 && std::all_of(near.begin(), near.end(), [&](int other) { return of[other] < 0; });
        if (alone) found(i);
    }
    const std::vector<int> founded = of;
    std::vector<int> groups;
    for (int i = 0; i < graph.size(); ++i) {
        if (of[i] >= 0) continue;
        groups.clear();
        for (int other : around(graph, i))
            if (founded[other] >= 0) groups.push_back(founded[other]);
        of[i] = mostFrequent(groups);
    }
    for (int i = 0; i < graph.size(); ++i)
        if (of[i] < 0) found(i);
    return result;
}

Graph quotient(const Graph& graph, const Aggregates& aggregates) {
    std::vector<int> start(aggregates.count + 1, 0), members(aggregates.of.size());
    for (int group : aggregates.of) ++start[group + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    auto next = start;
    for (int i = 0; i < graph.size(); ++i) members[next[aggregates.of[i]]++] = i;
    Graph result;
    result.start.push_back(0);
    std::vector<int> list;
    for (int group = 0; group < aggregates.count; ++group) {
        list.clear();
        for (int k = start[group]; k < start[group + 1]; ++k)
            for (int other : around(graph, members[k]))
                if (aggregates.of[other] != group) list.push_back(aggregates.of[other]);
        append(list, result);
    }
    return result;
}

template Graph graphOf(const AssemblyPlan<2>&, const ReducedSystem<2>&);
template Graph graphOf(const AssemblyPlan<3>&, const ReducedSystem<3>&);

}  // namespace wend
