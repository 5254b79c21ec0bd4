#pragma once

#include "core/mesh/simplicial_mesh.h"
#include "warp/warp.h"

namespace wend {

/// The inverse affine map of one cell, pose → rest, written as source = destination −
/// displacement(destination): where nothing is displaced it is exact.
struct CellMap {
    Vec<2> anchor;        // of the pose
    Vec<2> displacement;  // there
    Mat<2> gradient;      // of the displacement

    CellMap(const Points<2>& rest, const Points<2>& pose, const Cell<2>& cell);
    Vec<2> source(const Vec<2>& p) const { return p - (displacement + gradient * (p - anchor)); }
};

/// How a cell is sampled: from which level of the pyramid, and with which ellipse.
struct CellFilter {
    int level = 0;
    double ellipse = 0;                   // 0: bicubic only … 1: elliptical only
    Mat<2> inverse = Mat<2>::Identity();  // source offset → unit disc of the ellipse
    Vec<2> reach = Vec<2>::Zero();        // half of its bounding box

    /// `jacobian` maps steps of output pixels to steps of source pixels.
    CellFilter(const Mat<2>& jacobian, Filter filter, int levels);
};

}  // namespace wend
