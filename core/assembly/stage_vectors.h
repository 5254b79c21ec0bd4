#pragma once

#include <memory>
#include <span>

#include "core/base/types.h"

namespace wend {

/// A shape or a velocity field that does not change any more. It is identified by its address, so that an
/// object that has copied it elsewhere, such as to a device, recognizes it.
template <int Dim>
using Nodal = std::shared_ptr<const Points<Dim>>;

/// A velocity field with its weight in a sum.
template <int Dim>
struct WeightedField {
    double weight;
    Nodal<Dim> field;
};

/// Keeps the shapes at the stages of an integrator's step, sums y + Σ w_i k_i of a shape and velocity fields,
/// where they are computed and used. Sums run in the given order and have the same bits every time.
template <int Dim>
class StageVectors {
  public:
    static constexpr std::size_t kMostTerms = 8;
    using Terms = std::span<const WeightedField<Dim>>;

    virtual ~StageVectors() = default;

    /// Sets the stage's shape to y + Σ w_i k_i, with at most kMostTerms terms.
    virtual void combine(const Nodal<Dim>& y, Terms terms) = 0;
    /// Returns the stage's shape in the processor's memory; it is copied there when it is first needed.
    virtual Nodal<Dim> shape() = 0;
    /// Returns the largest difference of a coordinate between the stage's shape and another one.
    virtual double distance(const Nodal<Dim>& other) = 0;
    /// Returns the maximum of |Σ w_i k_i| over the vertices; NaN if a vector has a NaN.
    virtual double maximum(Terms terms) = 0;
};

/// Makes stage vectors in the processor's memory.
template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeHostStages();

}  // namespace wend
