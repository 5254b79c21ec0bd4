#pragma once

#include <memory>
#include <span>

#include "core/mesh/types.h"

namespace wend {

/// The vectors of a Runge–Kutta step: the shape y at its begin and the slopes k_i of its stages, kept where
/// the sums are made. Slopes are set in any order; a sum runs over as many as it has weights, all of them
/// set, in their order: the same bits every time.
template <int Dim>
class StageVectors {
  public:
    virtual ~StageVectors() = default;

    /// Begins a step at y, with room for so many slopes.
    virtual void begin(const Points<Dim>& y, int stages) = 0;
    virtual void setSlope(int stage, const Points<Dim>& k) = 0;
    /// y + h Σ a_i k_i.
    virtual Points<Dim> combined(double h, std::span<const double> a) = 0;
    /// max over the vertices of |h Σ e_i k_i|; no number if a vector has none.
    virtual double greatestError(double h, std::span<const double> e) = 0;
};

/// In the processor's memory.
template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeHostStages();

}  // namespace wend
