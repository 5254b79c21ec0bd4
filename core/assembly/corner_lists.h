#pragma once

#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/assembly/isotropic_kernels.h"

namespace wend {

/// The corners of every vertex, for isotropic::sumForces(). Each list is filled up to a multiple of kPadding
/// with a corner after all others, whose force stays 0.
template <int Dim>
struct CornerLists {
    explicit CornerLists(const AssemblyPlan<Dim>& plan) {
        const int none = isotropic::padded(plan.cellCount()) * (Dim + 1);
        start.push_back(0);
        for (int p = 0; p < plan.vertexCount; ++p) {
            corners.insert(corners.end(), plan.corners.begin() + plan.cornerStart[p],
                           plan.corners.begin() + plan.cornerStart[p + 1]);
            corners.resize(isotropic::padded(static_cast<int>(corners.size())), none);
            start.push_back(static_cast<int>(corners.size()));
        }
        force.resize(static_cast<std::size_t>(none + 1) * isotropic::Cells<Dim>::kPoint);
    }
    /// Sums the forces on the vertices [begin, end) of a field with one column each.
    void sum(int begin, int end, double* sums) const {
        isotropic::sumForces<Dim>(start.data(), corners.data(), force.data(), begin, end, sums);
    }

    std::vector<int> start, corners;
    std::vector<double> force;  // on every corner
};

}  // namespace wend
