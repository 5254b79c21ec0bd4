#pragma once

#include "core/integration/step_method.h"

namespace wend {

/// Stores an accepted step, with which a run continues to the step's end, and computes every shape within it,
/// to the same bits without solving.
template <int Dim>
struct StepRecord {
    double from = 0, to = 0;
    Nodal<Dim> next;      // the shape at its end, normalized; null: nothing moved
    Nodal<Dim> endField;  // the velocity field there, for methods that need it
    DenseStep<Dim> dense;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [begin, end, shape, field, within] = *this;
        archive(begin, end, shape, field, within);
    }
};

template <int Dim>
struct State;
struct Statistics;

/// Supplies the steps of an earlier run of the same deformation, one after another from its start.
template <int Dim>
class StepSource {
  public:
    virtual ~StepSource() = default;
    virtual bool hasNext() const = 0;
    virtual StepRecord<Dim> next() = 0;
    /// Restores, after the last step, what that run continued with besides the shape, and its statistics.
    virtual void resume(State<Dim>& state, Statistics& statistics) = 0;
};

}  // namespace wend
