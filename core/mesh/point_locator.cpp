#include "core/mesh/point_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/cell_geometry.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

template <int Dim>
using Index = std::array<int, Dim>;

/// Lists of ids per bin, one behind the other: list b is ids[starts[b]] … ids[starts[b + 1] − 1], ascending.
struct BinnedIds {
    std::vector<int> starts;
    std::vector<int> ids;
};

template <int Dim>
bool finite(const Points<Dim>& points, const Cell<Dim>& cell) {
    return std::all_of(cell.begin(), cell.end(), [&](int v) { return points.col(v).allFinite(); });
}

template <int Dim>
struct Bounds {
    Vec<Dim> low = Vec<Dim>::Constant(std::numeric_limits<double>::infinity());
    Vec<Dim> high = Vec<Dim>::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vec<Dim>& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    Vec<Dim> extent() const { return (high - low).cwiseMax(0.0); }
    double distanceSquared(const Vec<Dim>& p) const {
        return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
    }
};

template <int Dim>
Bounds<Dim> boundsOf(const Points<Dim>& points, const Cell<Dim>& cell) {
    Bounds<Dim> bounds;
    for (int v : cell) bounds.add(points.col(v));
    return bounds;
}

/// A box of equal cubic bins. Bin indices grow monotonically with the coordinates regardless of rounding, so
/// a point within a cell's bounds always falls into one of the cell's bins.
template <int Dim>
struct BinLayout {
    Vec<Dim> origin = Vec<Dim>::Zero();
    double size = 1;
    Index<Dim> counts{};

    int total() const {
        int product = 1;
        for (int n : counts) product *= n;
        return product;
    }
    Index<Dim> binOf(const Vec<Dim>& p) const {
        Index<Dim> bin;
        for (int k = 0; k < Dim; ++k)
            bin[k] = static_cast<int>(std::clamp((p[k] - origin[k]) / size, 0.0, counts[k] - 1.0));
        return bin;
    }
    int flat(const Index<Dim>& bin) const {
        int at = 0;
        for (int k = Dim - 1; k >= 0; --k) at = at * counts[k] + bin[k];
        return at;
    }
};

/// Calls visit(bin) for all bins from low to high, both included.
template <int Dim, class Visit>
void forBins(const Index<Dim>& low, const Index<Dim>& high, const Visit& visit) {
    Index<Dim> bin = low;
    for (;;) {
        visit(bin);
        int k = 0;
        while (k < Dim && bin[k] == high[k]) {
            bin[k] = low[k];
            ++k;
        }
        if (k == Dim) return;
        ++bin[k];
    }
}

/// Returns the number of bins of a size, as a double because it may be too large for an int.
template <int Dim>
double binsNeeded(const Vec<Dim>& extent, double size) {
    double product = 1;
    for (int k = 0; k < Dim; ++k) product *= std::floor(extent[k] / size) + 1;
    return product;
}

/// Returns a layout of at most `wanted` bins.
template <int Dim>
BinLayout<Dim> layoutFor(const Bounds<Dim>& bounds, double wanted) {
    BinLayout<Dim> layout;
    layout.counts.fill(1);
    const Vec<Dim> extent = bounds.extent();
    const double longest = extent.maxCoeff();
    if (!(longest > 0) || !std::isfinite(longest)) return layout;
    layout.origin = bounds.low;
    layout.size = 2 * longest;
    while (binsNeeded<Dim>(extent, layout.size / 1.25) <= wanted) layout.size /= 1.25;
    for (int k = 0; k < Dim; ++k)
        layout.counts[k] = static_cast<int>(std::floor(extent[k] / layout.size)) + 1;
    return layout;
}

/// Bins in two passes over the same visits: count, then fill. visitAll(put) calls put(bin, id) in ascending
/// order of id.
template <int Dim, class VisitAll>
BinnedIds binned(const BinLayout<Dim>& layout, const VisitAll& visitAll) {
    BinnedIds lists;
    lists.starts.assign(layout.total() + 1, 0);
    visitAll([&](const Index<Dim>& bin, int) { ++lists.starts[layout.flat(bin) + 1]; });
    for (std::size_t b = 1; b < lists.starts.size(); ++b) lists.starts[b] += lists.starts[b - 1];
    lists.ids.resize(lists.starts.back());
    std::vector<int> next(lists.starts.begin(), lists.starts.end() - 1);
    visitAll([&](const Index<Dim>& bin, int id) { lists.ids[next[layout.flat(bin)]++] = id; });
    return lists;
}

}  // namespace

template <int Dim>
struct PointLocator<Dim>::Grid {
    const Points<Dim>& points;
    const std::vector<Cell<Dim>>& cells;
    std::vector<int> vertices;  // finite ones: those of cells, or all of a set without cells
    Bounds<Dim> bounds;
    Vec<Dim> maxExtent = Vec<Dim>::Zero();  // of any cell, per axis
    BinLayout<Dim> layout;
    BinnedIds cellsOfBin;
    BinnedIds verticesOfBin;

    Grid(const Points<Dim>& allPoints, const std::vector<Cell<Dim>>& allCells)
        : points(allPoints), cells(allCells) {
        const std::vector<bool> used = usedVertices<Dim>(points.cols(), cells);
        for (int v = 0; v < static_cast<int>(points.cols()); ++v)
            if ((used[v] || cells.empty()) && points.col(v).allFinite()) vertices.push_back(v);
        for (int v : vertices) bounds.add(points.col(v));
        for (const auto& cell : cells)
            if (finite<Dim>(points, cell))
                maxExtent = maxExtent.cwiseMax(boundsOf<Dim>(points, cell).extent());
        chooseLayout();
        binCells();
        binVertices();
    }

    /// Uses about a bin per triangle or per four tetrahedra (whose bounding boxes are emptier), but larger
    /// bins if long cells would fill very many of them.
    void chooseLayout() {
        const double cellCount = static_cast<double>(cells.size());
        const double bins = cellCount / (Dim == 2 ? 1 : 4);
        for (double wanted = std::max({1.0, bins, vertices.size() / 2.0});; wanted /= 4) {
            layout = layoutFor<Dim>(bounds, wanted);
            if (layout.total() == 1 || entriesOf(layout) <= 32 * cellCount) return;
        }
    }
    /// Returns how many entries a layout of bins would have.
    double entriesOf(const BinLayout<Dim>& candidate) const {
        double entries = 0;
        for (const auto& cell : cells) {
            if (!finite<Dim>(points, cell)) continue;
            const auto box = boundsOf<Dim>(points, cell);
            const auto low = candidate.binOf(box.low), high = candidate.binOf(box.high);
            double product = 1;
            for (int k = 0; k < Dim; ++k) product *= high[k] - low[k] + 1;
            entries += product;
        }
        return entries;
    }
    /// Lists for every bin the cells whose box intersects it.
    void binCells() {
        cellsOfBin = binned<Dim>(layout, [&](const auto& put) {
            for (int c = 0; c < static_cast<int>(cells.size()); ++c) {
                if (!finite<Dim>(points, cells[c])) continue;
                const auto box = boundsOf<Dim>(points, cells[c]);
                forBins<Dim>(layout.binOf(box.low), layout.binOf(box.high),
                             [&](const auto& bin) { put(bin, c); });
            }
        });
    }
    void binVertices() {
        verticesOfBin = binned<Dim>(layout, [&](const auto& put) {
            for (int v : vertices) put(layout.binOf(points.col(v)), v);
        });
    }

    /// Finds the highest cell of the bin that contains p, if it is above the one found so far.
    void findIn(int bin, const Vec<Dim>& p, double tolerance, std::optional<Location<Dim>>& found) const {
        for (int at = cellsOfBin.starts[bin + 1] - 1; at >= cellsOfBin.starts[bin]; --at) {
            const int cell = cellsOfBin.ids[at];
            if (found && cell <= found->cell) return;
            const auto weights = barycentric<Dim>(points, cells[cell], p);
            if (!(weights.minCoeff() >= -tolerance) || !weights.allFinite()) continue;
            found = Location<Dim>{cell, weights};
            return;
        }
    }

    struct Nearest {
        int vertex = -1;
        double distanceSquared = std::numeric_limits<double>::infinity();
    };
    void nearestIn(int bin, const Vec<Dim>& p, Nearest& best) const {
        for (int at = verticesOfBin.starts[bin]; at < verticesOfBin.starts[bin + 1]; ++at) {
            const int v = verticesOfBin.ids[at];
            const double distance = (points.col(v) - p).squaredNorm();
            if (distance < best.distanceSquared || (distance == best.distanceSquared && v < best.vertex))
                best = {v, distance};
        }
    }
    /// Searches all bins at `ring` steps (in the maximum norm) around the centre; returns false if there are
    /// no bins at that distance or beyond.
    bool searchRing(const Index<Dim>& centre, int ring, const Vec<Dim>& p, Nearest& best) const {
        bool any = false;
        // One slab per side of the ring; the axes before k stay strictly inside, so that no bin is visited
        // twice.
        for (int k = 0; k < Dim; ++k) {
            for (int side : {-ring, ring}) {
                Index<Dim> low, high;
                bool empty = false;
                for (int j = 0; j < Dim; ++j) {
                    const int reach = j < k ? ring - 1 : ring;
                    low[j] = j == k ? centre[j] + side : std::max(centre[j] - reach, 0);
                    high[j] = j == k ? low[j] : std::min(centre[j] + reach, layout.counts[j] - 1);
                    empty = empty || low[j] < 0 || high[j] >= layout.counts[j] || low[j] > high[j];
                }
                if (empty) continue;
                any = true;
                forBins<Dim>(low, high, [&](const auto& bin) { nearestIn(layout.flat(bin), p, best); });
            }
        }
        return any;
    }
};

template <int Dim>
PointLocator<Dim>::PointLocator(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells)
    : m_grid(std::make_unique<Grid>(points, cells)) {}
template <int Dim>
PointLocator<Dim>::~PointLocator() = default;
template <int Dim>
PointLocator<Dim>::PointLocator(PointLocator&&) noexcept = default;

template <int Dim>
std::optional<Location<Dim>> PointLocator<Dim>::find(const Vec<Dim>& p, double tolerance) const {
    if (!p.allFinite()) return std::nullopt;
    // weights ≥ −tolerance reach beyond the cell's bounding box by at most Dim · tolerance of its extent
    const Vec<Dim> reach = Dim * std::max(tolerance, 0.0) * m_grid->maxExtent;
    std::optional<Location<Dim>> found;
    if (((p + reach).array() < m_grid->bounds.low.array()).any()) return found;
    if (((p - reach).array() > m_grid->bounds.high.array()).any()) return found;
    const auto& layout = m_grid->layout;
    forBins<Dim>(layout.binOf(p - reach), layout.binOf(p + reach),
                 [&](const auto& bin) { m_grid->findIn(layout.flat(bin), p, tolerance, found); });
    return found;
}

template <int Dim>
int PointLocator<Dim>::nearestVertex(const Vec<Dim>& p) const {
    typename Grid::Nearest best;
    if (!p.allFinite()) return best.vertex;
    const auto& layout = m_grid->layout;
    const auto centre = layout.binOf(p);
    m_grid->nearestIn(layout.flat(centre), p, best);
    const double outside = m_grid->bounds.distanceSquared(p);
    for (int ring = 1;; ++ring) {
        // this ring and the following ones are at least ring − 1 bins away along one axis
        const double gap = (ring - 1) * layout.size * (1 - 1e-9);
        if (outside * (1 - 1e-9) + gap * gap > best.distanceSquared) return best.vertex;
        if (!m_grid->searchRing(centre, ring, p, best)) return best.vertex;
    }
}

template class PointLocator<2>;
template class PointLocator<3>;

}  // namespace wend
