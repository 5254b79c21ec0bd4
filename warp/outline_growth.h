#pragma once

#include <vector>

#include "warp/outline_contour.h"

namespace wend {

/// The shape inside closed contours, grown by `margin` with gaps of `gap` left open, as rows of a function
/// whose zero contours are the grown outline: a level set cannot cross itself.
/// At an outside point with distance d to the nearest contour and d' to the nearest opposite one (on the
/// other side of the point, and of another loop or far along the same one), the gap is w = d + d', and the
/// value is μ − d with μ = clamp((w − gap) / 2, 0, margin).
class GrownShape {
  public:
    GrownShape(const ContourGrid& grid, const std::vector<std::vector<Vec2>>& loops, double margin,
               double gap);

    /// Fills a row, as RowSource does, in ascending order.
    void fillRow(int row, std::vector<float>& values);

  private:
    struct Segment {
        Vec2 a, b;
        int loop;
        double arc;  // length along the loop up to the segment's middle
    };
    struct Node {
        float distance, facing;
        Vec2 nearest;
        int segment;
        bool inside;
    };

    void addLoop(const std::vector<Vec2>& loop);
    void sortIntoStrips();
    void computeStrip(int strip);
    void markInside(const std::vector<int>& segments);
    void findNearest(const Segment& segment, int index);
    void findFacing(const Segment& segment);
    bool isFarAlong(const Segment& a, const Segment& b) const;
    float value(const Node& node) const;
    Node& node(int column, int row) {
        return m_nodes[static_cast<std::size_t>(row - m_firstRow) * m_grid.columns() + column];
    }
    template <typename Visit>
    void visitNear(const Segment& segment, double reach, const Visit& visit);

    ContourGrid m_grid;
    double m_margin, m_gap;
    std::vector<Segment> m_segments;
    std::vector<double> m_lengths;           // of the loops
    std::vector<std::vector<int>> m_strips;  // segments that reach into a strip of rows
    std::vector<Node> m_nodes;               // of the present strip
    int m_strip = -1, m_firstRow = 0, m_lastRow = 0;
};

}  // namespace wend
