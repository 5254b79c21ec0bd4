#include "core/mesh/limb_order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/mesh/segments.h"

namespace wend {

namespace {

constexpr double kStandsOut = 0.1;  // of the largest reach of its component

/// The cells of a mesh as a graph, whose edges are as long as the distance from centroid to centroid.
class CellGraph {
  public:
    struct Neighbour {
        int cell;
        double away;
    };
    struct Border {
        int cell;
        Vec2 a, b;
    };

    /// Computes centroids and areas of the cells, and connects those that share an edge.
    explicit CellGraph(const SimplicialMesh<2>& mesh)
        : m_neighbours(mesh.cells.size()), m_components(mesh.cellCount()) {
        for (const Cell<2>& cell : mesh.cells) {
            m_centroids.push_back(
                (mesh.points.col(cell[0]) + mesh.points.col(cell[1]) + mesh.points.col(cell[2])) / 3);
            m_areas.push_back(std::abs(cellMeasure<2>(mesh.points, cell)));
        }
        for (const Facet<2>& facet : facetsOf<2>(mesh)) {
            const auto [a, b] = facet.cells;
            if (!facet.interior()) {
                m_borders.push_back(
                    {a, mesh.points.col(facet.vertices[0]), mesh.points.col(facet.vertices[1])});
                continue;
            }
            const double away = (m_centroids[a] - m_centroids[b]).norm();
            m_neighbours[a].push_back({b, away});
            m_neighbours[b].push_back({a, away});
            m_components.join(a, b);
        }
    }
    int count() const { return static_cast<int>(m_neighbours.size()); }
    const std::vector<Neighbour>& neighbours(int cell) const { return m_neighbours[cell]; }
    /// Returns the lowest cell of the component.
    int component(int cell) { return m_components.root(cell); }

    double area(int cell) const { return m_areas[cell]; }

    /// Returns the distance of every cell's centroid to the boundary: each cell tries the edges that are
    /// nearest to its neighbours.
    std::vector<double> depths() const {
        const auto away = [this](int cell, int border) {
            return std::sqrt(squaredDistanceToSegment(m_centroids[cell], m_borders[border]));
        };
        std::vector<Candidate> first;
        for (int k = 0; k < static_cast<int>(m_borders.size()); ++k)
            first.push_back({away(m_borders[k].cell, k), m_borders[k].cell, k});
        std::vector<double> distances(m_neighbours.size(), std::numeric_limits<double>::infinity());
        spread(
            first, away, [](int) { return true; }, distances);
        return distances;
    }
    /// Computes the distance of every cell of a set to the nearest disc, of radius `depths` about one of the
    /// seeds; negative inside. The `distances` of the set must be infinite before.
    template <typename Within>
    void discDistances(const std::vector<int>& seeds, const std::vector<double>& depths, const Within& within,
                       std::vector<double>& distances) const {
        const auto away = [&](int cell, int seed) {
            return (m_centroids[cell] - m_centroids[seed]).norm() - depths[seed];
        };
        std::vector<Candidate> first;
        for (const int seed : seeds) first.push_back({-depths[seed], seed, seed});
        spread(first, away, within, distances);
    }

    /// Returns Dijkstra's distances from the nearest of these cells; 0 where no path leads.
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
    /// Returns the cells of the shortest way from a set to the nearest cell that is a goal, without that one
    /// and the set's; empty if it is longer than `farthest`.
    template <typename Within, typename IsGoal>
    std::vector<int> shortestWay(const std::vector<int>& from, const Within& within, const IsGoal& isGoal,
                                 double farthest) const {
        using Entry = std::tuple<double, int, int>;  // the way to a cell, and the one before it
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        std::map<int, int> before;
        for (const int cell : from) open.emplace(0, cell, -1);
        while (!open.empty()) {
            const auto [way, cell, previous] = open.top();
            open.pop();
            if (!before.emplace(cell, previous).second) continue;
            if (isGoal(cell)) {
                std::vector<int> cells;
                for (int c = previous; c >= 0 && before.at(c) >= 0; c = before.at(c)) cells.push_back(c);
                return cells;
            }
            for (const Neighbour& next : m_neighbours[cell])
                if (within(next.cell) && way + next.away <= farthest)
                    open.emplace(way + next.away, next.cell, cell);
        }
        return {};
    }
    /// Returns the cell of each component that is farthest from the boundary, the first of several.
    std::vector<int> middles(const std::vector<double>& inside) {
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
    struct Candidate {
        double value;
        int cell, source;
        bool operator>(const Candidate& other) const {
            return std::tie(value, cell, source) > std::tie(other.value, other.cell, other.source);
        }
    };

    static double squaredDistanceToSegment(const Vec2& p, const Border& border) {
        return (p - nearestOnSegment<2>(p, border.a, border.b)).squaredNorm();
    }
    /// Computes the least value of each cell over the sources that reach it from neighbour to neighbour,
    /// through cells that count.
    template <typename Value, typename Within>
    void spread(const std::vector<Candidate>& first, const Value& value, const Within& within,
                std::vector<double>& best) const {
        std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
        const auto offer = [&](const Candidate& candidate) {
            if (candidate.value >= best[candidate.cell]) return;
            best[candidate.cell] = candidate.value;
            open.push(candidate);
        };
        for (const Candidate& candidate : first) offer(candidate);
        while (!open.empty()) {
            const Candidate candidate = open.top();
            open.pop();
            if (candidate.value > best[candidate.cell]) continue;
            for (const Neighbour& next : m_neighbours[candidate.cell])
                if (within(next.cell))
                    offer({value(next.cell, candidate.source), next.cell, candidate.source});
        }
    }

    std::vector<std::vector<Neighbour>> m_neighbours;
    std::vector<Vec2> m_centroids;
    std::vector<double> m_areas;
    std::vector<Border> m_borders;
    DisjointSets m_components;
};

/// The tree of bodies and limbs that limbOrder() describes.
class BodyTree {
  public:
    BodyTree(CellGraph& graph, const std::vector<double>& depths, const std::vector<double>& reach)
        : m_graph(graph),
          m_depths(depths),
          m_reach(reach),
          m_nodeOf(depths.size(), -1),
          m_beyond(depths.size()),
          m_isSeen(depths.size()) {
        std::vector<std::vector<int>> components(depths.size());
        for (int c = 0; c < graph.count(); ++c) components[graph.component(c)].push_back(c);
        for (std::vector<int>& cells : components)
            if (!cells.empty()) decompose(std::move(cells));
    }

    /// Returns the position of each cell's body or limb.
    std::vector<int> places() {
        for (const int root : m_roots) place(root);
        std::vector<int> places;
        for (const int node : m_nodeOf) places.push_back(m_nodes[node].place);
        return places;
    }
    /// Returns the position of what each of them grows from, by its own; −1 for a body. After places().
    std::vector<int> parents() const {
        std::vector<int> parents(m_nodes.size(), -1);
        for (const Node& node : m_nodes)
            if (node.parent >= 0) parents[node.place] = m_nodes[node.parent].place;
        return parents;
    }

  private:
    static constexpr double kThick = 0.8, kAround = 0.25,
                            kSticksOut = 0.5;  // the latter two of a disc's least radius
    static constexpr double kAsThick = 0.65;

    struct Node {
        int parent = -1, place = -1;
        double thickness = 0;  // mean depth of its own cells …
        double slimness = 0;  // … and of all that grows from it: in steps, so that rounding does not decide
        double tip = 0;       // the largest reach of these
        std::vector<int> limbs;
    };
    struct Work {
        std::vector<int> cells;
        int parent;
    };

    /// Divides a component into its body and limbs, and these in the same manner, without recursion.
    void decompose(std::vector<int> component) {
        double farthest = 0;
        for (const int c : component) farthest = std::max(farthest, m_reach[c]);
        m_roots.push_back(static_cast<int>(m_nodes.size()));
        std::vector<Work> open{{std::move(component), -1}};
        while (!open.empty()) {
            Work work = std::move(open.back());
            open.pop_back();
            const int node = newNode(work);
            for (std::vector<int>& limb : limbsOf(work.cells, node, farthest))
                open.push_back({std::move(limb), node});
            m_nodes[node].thickness = meanDepth(work.cells, node);
        }
    }

    /// Adds a node of the tree, whose cells are all its own at first.
    int newNode(const Work& work) {
        const int node = static_cast<int>(m_nodes.size());
        m_nodes.push_back({});
        m_nodes[node].parent = work.parent;
        if (work.parent >= 0) m_nodes[work.parent].limbs.push_back(node);
        for (const int c : work.cells) {
            m_nodeOf[c] = node;
            m_nodes[node].tip = std::max(m_nodes[node].tip, m_reach[c]);
        }
        const double mean = meanDepth(work.cells, node);
        m_nodes[node].slimness = mean > 0 ? std::round(std::log(mean) / std::log(1.25)) : 0;
        return node;
    }

    double meanDepth(const std::vector<int>& cells, int node) const {
        double sum = 0, area = 0;
        for (const int c : cells) {
            if (m_nodeOf[c] != node) continue;
            sum += m_graph.area(c) * m_depths[c];
            area += m_graph.area(c);
        }
        return area > 0 ? sum / area : 0;
    }

    /// Returns the parts of a node's cells that reach out of its body.
    std::vector<std::vector<int>> limbsOf(const std::vector<int>& cells, int node, double farthest) {
        double deepest = 0;
        for (const int c : cells) deepest = std::max(deepest, m_depths[c]);
        const double radius = kThick * deepest;
        std::vector<int> seeds;
        for (const int c : cells)
            if (m_depths[c] >= radius) seeds.push_back(c);
        for (const int c : cells) m_beyond[c] = std::numeric_limits<double>::infinity(), m_isSeen[c] = false;
        const auto within = [&](int c) { return m_nodeOf[c] == node; };
        m_graph.discDistances(seeds, m_depths, within, m_beyond);
        const auto isBody = [&](int c) { return m_beyond[c] <= kAround * radius; };
        bridge(seeds, within, isBody, radius);
        std::vector<std::vector<int>> limbs;
        for (const int c : cells) {
            if (m_isSeen[c] || isBody(c)) continue;
            std::vector<int> part = connected(c, [&](int other) { return within(other) && !isBody(other); });
            if (lengthOf(part, isBody, within) > std::max(kSticksOut * radius, kStandsOut * farthest))
                limbs.push_back(std::move(part));
        }
        return limbs;
    }

    /// Connects the pieces of a body that are within `farthest` of one another by discs along the shortest
    /// path between them. A head and a chest of the same thickness, for example, are joined through the neck.
    template <typename Within, typename IsBody>
    void bridge(const std::vector<int>& seeds, const Within& within, const IsBody& isBody, double farthest) {
        std::map<int, int> pieceOf;
        std::vector<std::vector<int>> pieces;
        for (const int seed : seeds) {
            if (pieceOf.contains(seed)) continue;
            const int piece = static_cast<int>(pieces.size());
            std::vector<int>& own = pieces.emplace_back(1, seed);
            pieceOf[seed] = piece;
            for (std::size_t k = 0; k < own.size(); ++k)
                for (const CellGraph::Neighbour& next : m_graph.neighbours(own[k]))
                    if (within(next.cell) && isBody(next.cell) && pieceOf.emplace(next.cell, piece).second)
                        own.push_back(next.cell);
        }
        std::vector<int> ways;
        for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
            const std::vector<int> way = m_graph.shortestWay(
                pieces[piece], within,
                [&](int c) {
                    const auto other = pieceOf.find(c);
                    return other != pieceOf.end() && other->second != static_cast<int>(piece);
                },
                farthest);
            ways.insert(ways.end(), way.begin(), way.end());
        }
        m_graph.discDistances(ways, m_depths, within, m_beyond);
    }

    /// Returns the cells that are connected with one through cells that belong.
    template <typename Belongs>
    std::vector<int> connected(int first, const Belongs& belongs) {
        std::vector<int> part{first};
        m_isSeen[first] = true;
        for (std::size_t k = 0; k < part.size(); ++k)
            for (const CellGraph::Neighbour& next : m_graph.neighbours(part[k]))
                if (!m_isSeen[next.cell] && belongs(next.cell)) {
                    m_isSeen[next.cell] = true;
                    part.push_back(next.cell);
                }
        return part;
    }

    /// Returns how far the part reaches from the body that it grows from: the longest of its shortest paths.
    template <typename IsBody, typename Within>
    double lengthOf(const std::vector<int>& part, const IsBody& isBody, const Within& within) const {
        using Entry = std::pair<double, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        std::map<int, double> distance;
        for (const int c : part)
            for (const CellGraph::Neighbour& next : m_graph.neighbours(c))
                if (within(next.cell) && isBody(next.cell)) open.emplace(next.away, c);
        double length = 0;
        while (!open.empty()) {
            const auto [way, c] = open.top();
            open.pop();
            if (!distance.emplace(c, way).second) continue;
            length = way;
            for (const CellGraph::Neighbour& next : m_graph.neighbours(c))
                if (within(next.cell) && !isBody(next.cell)) open.emplace(way + next.away, next.cell);
        }
        return length;
    }

    bool lessInFront(int a, int b) const {
        const Node &p = m_nodes[a], &q = m_nodes[b];
        if (p.slimness != q.slimness) return p.slimness > q.slimness;
        return p.tip != q.tip ? p.tip < q.tip : a < b;
    }
    bool letsLimbsGo(const Node& node) const {
        return node.limbs.size() > 1 && node.thickness >= kAsThick * m_nodes[node.parent].thickness;
    }

    /// Places a body, and then what grows from it, the thickest first. A body nearly as thick as the one that
    /// it grows from hands its limbs over, so that they are ordered among that one's limbs.
    void place(int root) {
        m_nodes[root].place = m_places++;
        std::vector<int> waiting = m_nodes[root].limbs;
        while (!waiting.empty()) {
            const auto next =
                std::ranges::min_element(waiting, [this](int a, int b) { return lessInFront(a, b); });
            const int node = *next;
            waiting.erase(next);
            if (!letsLimbsGo(m_nodes[node])) {
                place(node);
                continue;
            }
            m_nodes[node].place = m_places++;
            waiting.insert(waiting.end(), m_nodes[node].limbs.begin(), m_nodes[node].limbs.end());
        }
    }

    CellGraph& m_graph;
    const std::vector<double>& m_depths;
    const std::vector<double>& m_reach;
    std::vector<int> m_nodeOf;     // of each cell
    std::vector<double> m_beyond;  // of each cell that is being looked at
    std::vector<bool> m_isSeen;
    std::vector<Node> m_nodes;
    std::vector<int> m_roots;
    int m_places = 0;
};

/// The join tree of the reach. A part that reaches out becomes a limb; where two limbs meet, both grow from a
/// third one, which continues from there.
class LimbTree {
  public:
    /// Inserts the cells by decreasing reach, so that limbs grow from their tips and are joined where they
    /// meet.
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
    /// Returns the position of each cell's limb, when limbs follow those that they grow from, the nearer tips
    /// first.
    std::vector<int> places() {
        std::vector<std::vector<int>> growing(m_limbs.size());
        std::vector<std::pair<int, int>> first;  // by component
        for (int cell = 0; cell < m_graph.count(); ++cell)
            if (m_graph.component(cell) == cell) first.emplace_back(cell, limbAt(cell));
        for (int limb = 0; limb < static_cast<int>(m_limbs.size()); ++limb)
            if (m_limbs[limb].parent >= 0) growing[m_limbs[limb].parent].push_back(limb);
        std::vector<int>& place = m_places;
        std::vector<int> next;
        place.resize(m_limbs.size());
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
    /// Returns the position of the limb that each one grows from, by its own; −1 for none. After places().
    std::vector<int> parents() const {
        std::vector<int> parents(m_limbs.size(), -1);
        for (const Limb& limb : m_limbs)
            if (limb.partOf < 0 && limb.parent >= 0)
                parents[m_places[&limb - m_limbs.data()]] = m_places[resolved(limb.parent)];
        return parents;
    }

  private:
    struct Limb {
        double tip = 0;   // its largest reach
        int parent = -1;  // the limb that it grows from
        int partOf = -1;  // it does not reach out, and belongs to that one
    };
    int resolved(int limb) const {
        while (m_limbs[limb].partOf >= 0) limb = m_limbs[limb].partOf;
        return limb;
    }
    /// Returns the limb that currently continues in the set of a cell.
    int limbAt(int cell) { return m_current[m_sets.root(cell)]; }

    /// Adds a cell to the tree: it begins a limb, or continues or joins those of its neighbours.
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
    /// Returns the limb that continues where these two meet.
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
    std::vector<int> m_places;       // of each limb
};

/// Finds what belongs to a limb of a body's cells. Of legs that are hardly thinner than the hips, discs cover
/// all but the feet: the body forks there.
class Prongs {
  public:
    /// `bodies` and `branches` are positions of BodyTree and LimbTree.
    Prongs(const CellGraph& graph, const std::vector<double>& depths, const std::vector<double>& reach,
           const std::vector<int>& bodies, const std::vector<int>& bodyParents,
           const std::vector<int>& branches, const std::vector<int>& branchParents)
        : m_bodies(bodies), m_branches(branches), m_parents(branchParents) {
        std::map<int, double> deepest;  // of each body
        for (int c = 0; c < graph.count(); ++c) {
            double& most = deepest[bodies[c]];
            most = std::max(most, depths[c]);
            measure(bodies[c], branches[c], reach[c]);
        }
        for (int c = 0; c < graph.count(); ++c) measureEnd(bodies[c], branches[c], reach[c], depths[c]);
        findLong(deepest);
        for (int c = 0; c < graph.count(); ++c)
            for (const CellGraph::Neighbour& next : graph.neighbours(c))
                if (bodyParents[bodies[c]] == bodies[next.cell])
                    m_limbs[{bodies[next.cell], prongOf(bodies[next.cell], branches[next.cell])}].insert(
                        bodies[c]);
        keepForks();
    }

    /// Returns the position of the limb that a cell of a body belongs to, or that of its body.
    int placeOf(int cell) const {
        const int prong = prongOf(m_bodies[cell], m_branches[cell]);
        const auto limbs = m_limbs.find({m_bodies[cell], prong});
        return prong < 0 || limbs == m_limbs.end() ? m_bodies[cell] : *limbs->second.begin();
    }

  private:
    static constexpr double kLong = 2,
                            kThin = 0.85;  // depths of the body: of a prong's length and half width
    struct Span {
        double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
        double depth = 0;  // in the farther half
        double length() const { return farthest - nearest; }
    };
    using BodyAndBranch = std::pair<int, int>;

    void measure(int body, int branch, double reach) {
        double& nearest = m_spans[{body, branch}].nearest;
        nearest = std::min(nearest, reach);
        for (; branch >= 0; branch = m_parents[branch]) {
            double& farthest = m_spans[{body, branch}].farthest;
            farthest = std::max(farthest, reach);
        }
    }

    void measureEnd(int body, int branch, double reach, double depth) {
        for (; branch >= 0; branch = m_parents[branch]) {
            Span& own = m_spans[{body, branch}];
            if (reach > own.nearest + own.length() / 2) own.depth = std::max(own.depth, depth);
        }
    }

    /// Prongs are long within the body, and thinner …
    void findLong(const std::map<int, double>& deepest) {
        for (const auto& [of, span] : m_spans)
            if (const double depth = deepest.at(of.first);
                m_parents[of.second] >= 0 && span.length() > kLong * depth && span.depth < kThin * depth)
                m_prongs.insert(of);
    }
    /// … two or more grow from the same branch, and each ends in one limb, unlike a chest.
    void keepForks() {
        std::map<BodyAndBranch, std::vector<BodyAndBranch>> forks;
        for (const BodyAndBranch& prong : m_prongs) {
            const auto limbs = m_limbs.find(prong);
            if (limbs == m_limbs.end() || limbs->second.size() == 1)
                forks[{prong.first, m_parents[prong.second]}].push_back(prong);
        }
        m_prongs.clear();
        for (const auto& [from, prongs] : forks)
            if (prongs.size() > 1) m_prongs.insert(prongs.begin(), prongs.end());
    }

    /// Returns the prong of a body that a branch belongs to; −1 for none.
    int prongOf(int body, int branch) const {
        while (branch >= 0 && !m_prongs.contains({body, branch})) branch = m_parents[branch];
        return branch;
    }

    const std::vector<int>&m_bodies, &m_branches, &m_parents;
    std::map<BodyAndBranch, Span> m_spans;  // within a body, of a branch and what grows from it
    std::set<BodyAndBranch> m_prongs;
    std::map<BodyAndBranch, std::set<int>> m_limbs;  // that grow from a prong
};

}  // namespace

/// Sorts the cells by the limb that they belong to, within it by the branch of the join tree, then by reach,
/// and last by number, which makes the order total. BodyTree finds limbs by thickness, LimbTree branches by
/// reach; the prongs of both tell where a thick body forks.
std::vector<int> limbOrder(const SimplicialMesh<2>& mesh) {
    CellGraph graph(mesh);
    const std::vector<double> depths = graph.depths(), reach = graph.distances(graph.middles(depths));
    BodyTree bodyTree(graph, depths, reach);
    LimbTree limbTree(graph, reach);
    const std::vector<int> bodies = bodyTree.places(), branches = limbTree.places(),
                           bodyParents = bodyTree.parents(), branchParents = limbTree.parents();
    const Prongs prongs(graph, depths, reach, bodies, bodyParents, branches, branchParents);
    std::vector<std::tuple<int, int, double, int>> keys;
    for (int c = 0; c < graph.count(); ++c) keys.emplace_back(prongs.placeOf(c), branches[c], reach[c], c);
    std::ranges::sort(keys);
    std::vector<int> place(keys.size());
    for (int k = 0; k < graph.count(); ++k) place[std::get<3>(keys[k])] = k;
    return place;
}

}  // namespace wend
