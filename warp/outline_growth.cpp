#include "warp/outline_growth.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/segments.h"

namespace wend {
namespace {

constexpr int stripRows = 32;
constexpr float far = 1e30F;

/// Distances are needed a cell beyond the farthest zero, for the interpolation there.
constexpr double beyond = 1.5;

int stripOf(double y, int strips) {
    return std::clamp(static_cast<int>(std::floor((y + 1.5) / stripRows)), 0, strips - 1);
}

}  // namespace

GrownShape::GrownShape(const ContourGrid& grid, const std::vector<std::vector<Vec2>>& loops, double margin,
                       double gap)
    : m_grid(grid), m_margin(margin), m_gap(gap) {
    for (const auto& loop : loops) addLoop(loop);
    sortIntoStrips();
}

void GrownShape::addLoop(const std::vector<Vec2>& loop) {
    double length = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
        const double step = (b - a).norm();
        m_segments.push_back({a, b, static_cast<int>(m_lengths.size()), length + step / 2});
        length += step;
    }
    m_lengths.push_back(length);
}

void GrownShape::sortIntoStrips() {
    const int strips = (m_grid.rows() + stripRows - 1) / stripRows;
    m_strips.resize(strips);
    const double reach = 2 * m_margin + m_gap + beyond + 1;  // a row more, for the border's rows
    for (int i = 0; i < static_cast<int>(m_segments.size()); ++i) {
        const auto& s = m_segments[i];
        const int last = stripOf(std::max(s.a.y(), s.b.y()) + reach, strips);
        for (int k = stripOf(std::min(s.a.y(), s.b.y()) - reach, strips); k <= last; ++k)
            m_strips[k].push_back(i);
    }
}

/// Calls visit(node, its place) for the strip's nodes in the segment's bounding box grown by reach.
template <typename Visit>
void GrownShape::visitNear(const Segment& s, double reach, const Visit& visit) {
    const auto first = [&](double at) { return static_cast<int>(std::floor(at - reach)) + 1; };
    const auto last = [&](double at) { return static_cast<int>(std::ceil(at + reach)) + 2; };
    const int left = std::max(first(std::min(s.a.x(), s.b.x())), 0);
    const int right = std::min(last(std::max(s.a.x(), s.b.x())), m_grid.columns() - 1);
    const int top = std::max(first(std::min(s.a.y(), s.b.y())), m_firstRow);
    const int bottom = std::min(last(std::max(s.a.y(), s.b.y())), m_lastRow);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column)
            visit(node(column, row), Vec2(m_grid.x(column), m_grid.y(row)));
}

void GrownShape::findNearest(const Segment& s, int index) {
    visitNear(s, m_margin + beyond, [&](Node& n, const Vec2& p) {
        const Vec2 q = nearestOnSegment<2>(p, s.a, s.b);
        const auto d = static_cast<float>((p - q).norm());
        if (d >= n.distance) return;
        n.distance = d;
        n.nearest = q;
        n.segment = index;
    });
}

/// Returns whether the segments belong to different loops, or are so far apart along one that the contour in
/// between encloses a notch rather than a bay.
bool GrownShape::isFarAlong(const Segment& a, const Segment& b) const {
    if (a.loop != b.loop) return true;
    const double way = std::abs(a.arc - b.arc);
    const double chord = ((a.a + a.b) - (b.a + b.b)).norm() / 2;
    return std::min(way, m_lengths[a.loop] - way) > 2 * chord + 2;
}

/// Finds for each inside node the contour opposite of its nearest contour point.
void GrownShape::findFacing(const Segment& s) {
    visitNear(s, 2 * m_margin + m_gap + beyond, [&](Node& n, const Vec2& p) {
        if (n.distance > (n.inside ? 0 : m_margin) + beyond) return;
        const Vec2 from = n.inside ? n.nearest : p;
        const Vec2 outwards = n.inside ? Vec2(n.nearest - p) : Vec2(p - n.nearest);
        const Vec2 q = nearestOnSegment<2>(from, s.a, s.b);
        const auto d = static_cast<float>((from - q).norm());
        if (d >= n.facing || (q - from).dot(outwards) < 0 || !isFarAlong(s, m_segments[n.segment])) return;
        n.facing = d;
    });
}

/// Applies the even-odd rule along each row, with the signs of the pixels that nodes repeat, because the
/// contours run on the border.
void GrownShape::markInside(const std::vector<int>& segments) {
    std::vector<std::vector<double>> crossings(m_lastRow - m_firstRow + 1);
    for (int index : segments) {
        const auto& s = m_segments[index];
        const double low = std::min(s.a.y(), s.b.y()), high = std::max(s.a.y(), s.b.y());
        const int from = std::max(static_cast<int>(std::floor(low)), m_firstRow);
        const int to = std::min(static_cast<int>(std::ceil(high)) + 3, m_lastRow);
        for (int row = from; row <= to; ++row) {
            const double y = ContourGrid::pixel(row, m_grid.height) + 0.5;
            if (low <= y && y < high)
                crossings[row - m_firstRow].push_back(s.a.x() + (s.b.x() - s.a.x()) * (y - s.a.y()) /
                                                                    (s.b.y() - s.a.y()));
        }
    }
    for (int row = m_firstRow; row <= m_lastRow; ++row) {
        auto& xs = crossings[row - m_firstRow];
        std::sort(xs.begin(), xs.end());
        std::size_t passed = 0;
        for (int column = 0; column < m_grid.columns(); ++column) {
            const double x = ContourGrid::pixel(column, m_grid.width) + 0.5;
            while (passed < xs.size() && xs[passed] < x) ++passed;
            node(column, row).inside = passed % 2 != 0;
        }
    }
}

void GrownShape::computeStrip(int strip) {
    m_strip = strip;
    m_firstRow = strip * stripRows;
    m_lastRow = std::min(m_firstRow + stripRows, m_grid.rows()) - 1;
    m_nodes.assign(static_cast<std::size_t>(m_grid.columns()) * stripRows,
                   {far, far, Vec2::Zero(), -1, false});
    const auto& segments = m_strips[strip];
    markInside(segments);
    for (int i : segments) findNearest(m_segments[i], i);
    if (m_gap > 0)
        for (int i : segments) findFacing(m_segments[i]);
}

float GrownShape::value(const Node& n) const {
    const auto beyondAll = static_cast<float>(m_margin + beyond);
    if (n.distance >= far) return n.inside ? beyondAll : -beyondAll;
    const float signedDistance = n.inside ? -n.distance : n.distance;
    const double width = static_cast<double>(n.facing) + std::max(signedDistance, 0.0F);
    return static_cast<float>(std::clamp((width - m_gap) / 2, 0.0, m_margin) - signedDistance);
}

void GrownShape::fillRow(int row, std::vector<float>& values) {
    if (row / stripRows != m_strip) computeStrip(row / stripRows);
    for (int column = 0; column < m_grid.columns(); ++column) values[column] = value(node(column, row));
}

}  // namespace wend
