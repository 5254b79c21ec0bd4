#include "warp/outline_contour.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"

namespace wend {
namespace {

using Loop = std::vector<Vec2>;

constexpr std::size_t mostVertices = 40'000'000;

/// Contour vertices sit on grid edges; each is entered by the segment of one of the two cells at its edge and
/// left by the other's.
class ContourTracer {
  public:
    ContourTracer(const ContourGrid& grid, const RowSource& source) : m_grid(grid), m_source(source) {}

    std::vector<Loop> loops();

  private:
    using Edges = std::array<int, 4>;  // top, right, bottom, left: vertex ids

    void readRow(int row);
    void addRowOfCells(int row);
    void addHorizontalVertices(int row, const std::vector<float>& values, std::vector<int>& edges);
    void addVerticalVertices(int row);
    void linkCell(const std::array<float, 4>& corners, const Edges& edges);
    int addVertex(double x, double y);
    Loop follow(int start);

    const ContourGrid& m_grid;
    const RowSource& m_source;
    std::vector<float> m_upper, m_lower;           // values of two rows of nodes
    std::vector<int> m_top, m_bottom, m_vertical;  // vertices on their edges
    std::vector<Vec2> m_vertices;
    std::vector<int> m_next;
};

/// Returns the zero between two nodes, kept off the nodes so that contours do not meet in one.
double between(double p, double q, float atP, float atQ) {
    const double t = static_cast<double>(atP) / (static_cast<double>(atP) - atQ);
    return p + (q - p) * std::clamp(t, 1e-3, 1 - 1e-3);
}

bool differ(float a, float b) {
    return (a > 0) != (b > 0);
}

int ContourTracer::addVertex(double x, double y) {
    if (m_vertices.size() >= mostVertices)
        throw InputError(sentence("Core", "the picture's alpha has too many contours: it looks like noise"));
    m_vertices.emplace_back(x, y);
    m_next.push_back(-1);
    return static_cast<int>(m_vertices.size()) - 1;
}

void ContourTracer::readRow(int row) {
    m_lower.assign(m_grid.columns(), -1);
    if (row > 0 && row < m_grid.rows() - 1) m_source(row, m_lower);
    m_lower.front() = m_lower.back() = -1;
}

void ContourTracer::addHorizontalVertices(int row, const std::vector<float>& values,
                                          std::vector<int>& edges) {
    for (int i = 0; i + 1 < m_grid.columns(); ++i)
        if (differ(values[i], values[i + 1]))
            edges[i] =
                addVertex(between(m_grid.x(i), m_grid.x(i + 1), values[i], values[i + 1]), m_grid.y(row));
}

void ContourTracer::addVerticalVertices(int row) {
    for (int i = 0; i < m_grid.columns(); ++i)
        if (differ(m_upper[i], m_lower[i]))
            m_vertical[i] =
                addVertex(m_grid.x(i), between(m_grid.y(row), m_grid.y(row + 1), m_upper[i], m_lower[i]));
}

/// Links the edges of a cell. Each run of inside corners, in cyclic order, is entered through one edge and
/// left through another, which a contour segment connects. Two runs are joined if the cell's mean is inside.
void ContourTracer::linkCell(const std::array<float, 4>& corners, const Edges& edges) {
    std::array<int, 2> entries{}, exits{};
    int runs = 0;
    for (int k = 0; k < 4; ++k) {
        if (corners[k] > 0 || corners[(k + 1) % 4] <= 0) continue;
        int last = (k + 1) % 4;
        while (corners[(last + 1) % 4] > 0) last = (last + 1) % 4;
        entries[runs] = edges[k];
        exits[runs++] = edges[last];
    }
    const bool joined = runs == 2 && corners[0] + corners[1] + corners[2] + corners[3] > 0;
    if (joined) std::swap(exits[0], exits[1]);
    for (int r = 0; r < runs; ++r) m_next[entries[r]] = exits[r];
}

void ContourTracer::addRowOfCells(int row) {
    addVerticalVertices(row);
    addHorizontalVertices(row + 1, m_lower, m_bottom);
    for (int i = 0; i + 1 < m_grid.columns(); ++i) {
        const std::array<float, 4> corners{m_upper[i], m_upper[i + 1], m_lower[i + 1], m_lower[i]};
        if (!differ(corners[0], corners[1]) && !differ(corners[1], corners[2]) &&
            !differ(corners[2], corners[3]))
            continue;
        linkCell(corners, {m_top[i], m_vertical[i + 1], m_bottom[i], m_vertical[i]});
    }
}

/// Takes the loop out of the links.
Loop ContourTracer::follow(int start) {
    Loop loop;
    for (int at = start; at >= 0;) {
        const Vec2& p = m_vertices[at];
        if (loop.empty() || loop.back() != p) loop.push_back(p);
        at = std::exchange(m_next[at], -1);
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
}

std::vector<Loop> ContourTracer::loops() {
    m_top.assign(m_grid.columns(), -1);
    m_bottom = m_vertical = m_top;
    readRow(0);
    for (int row = 0; row + 1 < m_grid.rows(); ++row) {
        std::swap(m_upper, m_lower);
        std::swap(m_top, m_bottom);
        readRow(row + 1);
        addRowOfCells(row);
    }
    std::vector<Loop> loops;
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
        if (m_next[v] < 0) continue;
        loops.push_back(follow(static_cast<int>(v)));
        if (loops.back().size() < 3) loops.pop_back();
    }
    return loops;
}

}  // namespace

std::vector<Loop> zeroContours(const ContourGrid& grid, const RowSource& source) {
    return ContourTracer(grid, source).loops();
}

}  // namespace wend
