#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// How far a pose is from rest (docs/method.md, (24)–(26)). Per cell and weighted with rest
/// volume fractions.
struct Distortion {
    std::vector<double> angle, volume, metric;  // per cell, unweighted
    std::vector<double> ratio;                  // det F: area or volume change per cell, 1 = kept
    double totalAngle = 0, totalVolume = 0, totalMetric = 0;
    int flips = 0;       // cells with det F ≤ 0
    double minDet = 1;   // the least det F
    int worstCell = -1;  // cell of the largest metric error
};

template <int Dim>
Distortion distortion(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose);

}  // namespace wend
