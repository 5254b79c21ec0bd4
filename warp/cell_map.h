#pragma once

#include "core/mesh/simplicial_mesh.h"
#include "warp/warp.h"

namespace wend {

/// The inverse affine map of one cell, pose → rest, written as source = destination −
/// displacement(destination), which is exact without displacement. Every position is computed from its own
/// coordinates alone, so that a crop has the same bits as the whole.
struct CellMap {
    Vec2 anchor;        // of the pose
    Vec2 displacement;  // there
    Mat2 gradient;      // of the displacement
    bool exact = true;  // whether positions are, to far less than a pixel

    /// Displaces nothing.
    CellMap() : anchor(0, 0), displacement(0, 0), gradient(Mat2::Zero()) {}
    CellMap(const Points2& rest, const Points2& pose, const Cell<2>& cell);

    /// Returns the displacement at height y in the anchor's column.
    Vec2 inRow(double y) const { return displacement + gradient.col(1) * (y - anchor.y()); }
    Vec2 source(double x, double y, const Vec2& inRowOfY) const {
        return {x - (inRowOfY.x() + gradient(0, 0) * (x - anchor.x())),
                y - (inRowOfY.y() + gradient(1, 0) * (x - anchor.x()))};
    }
    Vec2 source(const Vec2& p) const { return source(p.x(), p.y(), inRow(p.y())); }
};

/// The ellipse {J u : |u| ≤ 2} of source pixels around a position, J mapping destination pixels to source
/// pixels and stretching by at least 1 in every direction: |u|² = xx dx² + 2 xy dx dy + yy dy².
struct Ellipse {
    float xx = 1, xy = 0, yy = 1;
    /// The ellipse reaches at most this many pixels before the first of the two pixels around a position, and
    /// one more after it.
    Eigen::Vector2i wholeReach = {1, 1};
};

/// The sampling of a cell: the level of the pyramid and the ellipse.
struct CellFilter {
    int level = 0;
    double shrink = 1;  // size of a pixel of the picture in pixels of the level
    float blend = 0;    // 0: bicubic only … 1: elliptical only
    Ellipse ellipse;

    CellFilter() = default;
    /// `jacobian` maps steps of output pixels to steps of source pixels.
    CellFilter(const Mat2& jacobian, Filter filter, int levels);
};

}  // namespace wend
