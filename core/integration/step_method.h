#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/assembly/stage_vectors.h"
#include "core/integration/method.h"
#include "core/motion/trajectory.h"

namespace wend {

/// The right-hand side at a time of the past.
template <int Dim>
struct PastField {
    double time;
    Nodal<Dim> field;
};

/// What a method goes on with from one step to the next. Cheap to copy.
template <int Dim>
struct Pace {
    double step = 0;   // that the control would try next; 0: its own start
    double error = 0;  // of the last step, over the tolerance; 0: there was none
    int order = 0;     // Adams: that it would try next
    /// The last of them at the current time, the oldest first; empty: none is known.
    std::vector<PastField<Dim>> fields;
};

/// A method for dx/dt = f(x, t): one step at a time, and how to go on from it. The right-hand side may jump
/// at the ends of a step: the value at its start is the one after the jump, that at its end the one before.
template <int Dim>
class StepMethod {
  public:
    /// f at the shape that the stages have; false where it cannot be evaluated.
    using Rhs = std::function<bool(double t, Side side, StageVectors<Dim>& stages, Points<Dim>& v)>;
    /// tolerance: error allowed per step, the largest distance of a point; 0: steps are prescribed, no error
    /// is estimated.
    static std::unique_ptr<StepMethod> of(Method method, double tolerance);
    virtual ~StepMethod() = default;

    /// Where the points that move fastest have this speed.
    virtual double firstStep(double speed) const = 0;
    /// From x at t to `to`, all sums by the stages; the field at t is added to the pace if it was not known.
    /// False if a value could not be had.
    virtual bool attempt(const Rhs& f, StageVectors<Dim>& stages, double t, double to, const Nodal<Dim>& x,
                         Pace<Dim>& pace) = 0;

    // Of the last attempt that succeeded:
    virtual const Nodal<Dim>& result() const = 0;
    /// Over the tolerance: the step is good up to 1.
    virtual double error() const = 0;
    /// The error was too great: step and order to try again with.
    virtual void retry(Pace<Dim>& pace) const = 0;
    /// The step counts. `shortened`: attempts before it failed; `cut`: it is shorter than the control wanted.
    virtual void accept(Pace<Dim>& pace, bool shortened, bool cut) = 0;
    /// The solution at a time inside the step, by interpolation; endField is f at its end, where that is
    /// needed.
    virtual bool needsEndField() const = 0;
    virtual Points<Dim> at(double t, const Points<Dim>& endField) const = 0;
};

/// f as a field that does not change any more; null where it cannot be evaluated.
template <int Dim>
Nodal<Dim> fieldAt(const typename StepMethod<Dim>::Rhs& f, StageVectors<Dim>& stages, double t, Side side) {
    auto field = std::make_shared<Points<Dim>>();
    return f(t, side, stages, *field) ? field : nullptr;
}

/// The largest length of a column.
template <int Dim>
double largestColumn(const Points<Dim>& points) {
    return points.cols() == 0 ? 0 : points.colwise().norm().maxCoeff();
}

}  // namespace wend
