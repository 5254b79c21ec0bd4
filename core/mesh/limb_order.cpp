#include "core/mesh/limb_order.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "core/mesh/disjoint_sets.h"

namespace wend {

namespace {

constexpr double kStandsOut = 0.1;  // of the largest reach of its component

/// The cells of a mesh as a graph, whose edges are as long as the way from centroid to centroid.
class CellGraph {
  public:
    struct Neighbour {
        int cell;
        double away;
    };

    explicit CellGraph(const SimplicialMesh<2>& mesh)
        : m_neighbours(mesh.cells.size()), m_onBoundary(mesh.cells.size()), m_components(mesh.cellCount()) {
        const auto centroid = [&mesh](int cell) -> Vec<2> {
            const Cell<2>& corners = mesh.cells[cell];
            return (mesh.points.col(corners[0]) + mesh.points.col(corners[1]) + mesh.points.col(corners[2])) /
                   3;
        };
        for (const Facet<2>& facet : facetsOf<2>(mesh)) {
            const auto [a, b] = facet.cells;
            if (!facet.interior()) {
                m_onBoundary[a] = true;
                continue;
            }
            const double away = (centroid(a) - centroid(b)).norm();
            m_neighbours[a].push_back({b, away});
            m_neighbours[b].push_back({a, away});
            m_components.join(a, b);
        }
    }
    int count() const { return static_cast<int>(m_neighbours.size()); }
    const std::vector<Neighbour>& neighbours(int cell) const { return m_neighbours[cell]; }
    /// The lowest cell of its component.
    int component(int cell) { return m_components.root(cell); }

    std::vector<int> boundary() const {
        std::vector<int> cells;
        for (int c = 0; c < count(); ++c)
            if (m_onBoundary[c]) cells.push_back(c);
        return cells;
    }
    /// Dijkstra's distances from the nearest of these cells; 0 where no way leads.
    std::vector<double> distances(const std::vector<int>& from) const {
        using Entry = std::pair<double, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        std::vector<double> distance(m_neighbours.size(), std::numeric_limits<double>::infinity());
        for (const int cell : from) open.emplace(distance[cell] = 0, cell);
        while (!open.empty()) {
            const auto [way, cell] = open.top();
            open.pop();
            if (way > distance[cell]) continue;
            for (const auto& [other, away] : m_neighbours[cell])
                if (way + away < distance[other]) open.emplace(distance[other] = way + away, other);
        }
        for (double& value : distance)
            if (value == std::numeric_limits<double>::infinity()) value = 0;
        return distance;
    }
    /// The cell of each component that is farthest from the boundary.
    std::vector<int> middles() {
        const std::vector<double> inside = distances(boundary());
        std::vector<int> farthest(m_neighbours.size(), -1), cells;
        for (int c = 0; c < count(); ++c) {
            int& best = farthest[component(c)];
            if (best < 0 || inside[c] > inside[best]) best = c;
        }
        for (const int cell : farthest)
            if (cell >= 0) cells.push_back(cell);
        return cells;
    }

  private:
    std::vector<std::vector<Neighbour>> m_neighbours;
    std::vector<bool> m_onBoundary;
    DisjointSets m_components;
};

/// The join tree of the reach: what stands out becomes a limb, and where two limbs meet, both grow from a
/// third one, which goes on from there.
class LimbTree {
  public:
    LimbTree(CellGraph& graph, const std::vector<double>& reach)
        : m_graph(graph),
          m_reach(reach),
          m_sets(graph.count()),
          m_limbOf(reach.size(), -1),
          m_current(reach.size(), -1),
          m_farthest(reach.size()) {
        for (int c = 0; c < graph.count(); ++c) {
            double& farthest = m_farthest[graph.component(c)];
            farthest = std::max(farthest, reach[c]);
        }
        std::vector<int> falling(reach.size());
        std::iota(falling.begin(), falling.end(), 0);
        std::ranges::stable_sort(falling, std::greater(), [&reach](int c) { return reach[c]; });
        for (const int cell : falling) add(cell);
    }
    /// The place of each cell's limb, when limbs follow those that they grow from, the nearer tips first.
    std::vector<int> places() {
        std::vector<std::vector<int>> growing(m_limbs.size());
        std::vector<std::pair<int, int>> first;  // by component
        for (int cell = 0; cell < m_graph.count(); ++cell)
            if (m_graph.component(cell) == cell) first.emplace_back(cell, limbAt(cell));
        for (int limb = 0; limb < static_cast<int>(m_limbs.size()); ++limb)
            if (m_limbs[limb].parent >= 0) growing[m_limbs[limb].parent].push_back(limb);
        std::vector<int> place(m_limbs.size()), next;
        for (auto it = first.rbegin(); it != first.rend(); ++it) next.push_back(it->second);
        for (int k = 0; !next.empty(); ++k) {
            const int limb = next.back();
            next.pop_back();
            place[limb] = k;
            std::ranges::stable_sort(growing[limb], std::greater(), [this](int l) { return m_limbs[l].tip; });
            next.insert(next.end(), growing[limb].begin(), growing[limb].end());
        }
        std::vector<int> places;
        for (const int limb : m_limbOf) places.push_back(place[resolved(limb)]);
        return places;
    }

  private:
    struct Limb {
        double tip = 0;   // its largest reach
        int parent = -1;  // the limb that it grows from
        int partOf = -1;  // it does not stand out, and belongs to that one
    };
    int resolved(int limb) const {
        while (m_limbs[limb].partOf >= 0) limb = m_limbs[limb].partOf;
        return limb;
    }
    /// That which now goes on in the set of a cell.
    int limbAt(int cell) { return m_current[m_sets.root(cell)]; }

    void add(int cell) {
        int limb = m_limbOf[cell] = newLimb(m_reach[cell]);
        m_current[cell] = limb;
        for (const auto& [other, away] : m_graph.neighbours(cell)) {
            if (m_limbOf[other] < 0 || limbAt(other) == limb) continue;
            limb = meeting(limb, limbAt(other), m_reach[cell], m_farthest[m_graph.component(cell)]);
            m_sets.join(cell, other);
            m_current[m_sets.root(cell)] = limb;
        }
        m_limbOf[cell] = limb;
    }
    int newLimb(double tip) {
        m_limbs.push_back({tip, -1, -1});
        return static_cast<int>(m_limbs.size()) - 1;
    }
    /// The limb that goes on where these two meet.
    int meeting(int a, int b, double reach, double farthest) {
        if (m_limbs[a].tip < m_limbs[b].tip) std::swap(a, b);
        if (m_limbs[b].tip - reach <= kStandsOut * farthest) {
            m_limbs[b].partOf = a;
            return a;
        }
        return m_limbs[a].parent = m_limbs[b].parent = newLimb(m_limbs[a].tip);
    }

    CellGraph& m_graph;
    const std::vector<double>& m_reach;
    DisjointSets m_sets;
    std::vector<Limb> m_limbs;
    std::vector<int> m_limbOf;       // of each cell
    std::vector<int> m_current;      // of each set
    std::vector<double> m_farthest;  // of each component
};

}  // namespace

std::vector<int> limbOrder(const SimplicialMesh<2>& mesh) {
    CellGraph graph(mesh);
    const std::vector<double> reach = graph.distances(graph.middles());
    const std::vector<int> limbs = LimbTree(graph, reach).places();
    std::vector<std::tuple<int, double, int>> keys;
    for (int c = 0; c < graph.count(); ++c) keys.emplace_back(limbs[c], reach[c], c);
    std::ranges::sort(keys);
    std::vector<int> place(keys.size());
    for (int k = 0; k < graph.count(); ++k) place[std::get<2>(keys[k])] = k;
    return place;
}

}  // namespace wend
