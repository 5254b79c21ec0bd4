#pragma once

#include <memory>
#include <span>

#include "core/mesh/types.h"

namespace wend {

/// A shape or a velocity field that does not change any more. It is known by its address, so that whoever has
/// made a copy of it elsewhere, as on a device, knows it again.
template <int Dim>
using Nodal = std::shared_ptr<const Points<Dim>>;

template <int Dim>
struct WeightedField {
    double weight;
    Nodal<Dim> field;
};

/// The shapes at the stages of an integrator's step, sums y + Σ w_i k_i of a shape and velocity fields, kept
/// where they are made and used. Sums run in the order given: the same bits every time.
template <int Dim>
class StageVectors {
  public:
    static constexpr std::size_t kMostTerms = 8;
    using Terms = std::span<const WeightedField<Dim>>;

    virtual ~StageVectors() = default;

    /// The stage's shape becomes y + Σ w_i k_i.
    virtual void combine(const Nodal<Dim>& y, Terms terms) = 0;
    /// The stage's shape in the processor's memory, where it is copied when it is first asked for.
    virtual Nodal<Dim> shape() = 0;
    /// The largest difference of a coordinate between the stage's shape and another one.
    virtual double distance(const Nodal<Dim>& other) = 0;
    /// max over the vertices of |Σ w_i k_i|; no number if a vector has none.
    virtual double maximum(Terms terms) = 0;
};

/// In the processor's memory.
template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeHostStages();

}  // namespace wend
