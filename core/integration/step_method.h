#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/assembly/stage_vectors.h"
#include "core/integration/method.h"
#include "core/motion/trajectory.h"

namespace wend {

/// The right-hand side at an earlier time.
template <int Dim>
struct PastField {
    double time = 0;
    Nodal<Dim> field;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [at, what] = *this;
        archive(at, what);
    }
};

/// The state of a method between steps. It is cheap to copy.
template <int Dim>
struct Pace {
    double step = 0;   // that the control would try next; 0: its own start
    double error = 0;  // of the last step, over the tolerance; 0: there was none
    int order = 0;     // Adams: that it would try next
    /// The last fields at the current time and before, the oldest first; empty if none is known.
    std::vector<PastField<Dim>> fields;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [next, last, degree, known] = *this;
        archive(next, last, degree, known);
    }
};

/// Holds what a method keeps of a step, beside the shape at its start, to compute the shapes within it.
template <int Dim>
struct DenseStep {
    int order = 0;      // Adams
    Nodal<Dim> result;  // Runge–Kutta, before constrained points were put on their paths
    std::vector<PastField<Dim>> fields;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [degree, end, known] = *this;
        archive(degree, end, known);
    }
};

/// A method for dx/dt = f(x, t), one step at a time. The right-hand side may jump at the ends of a step: the
/// start uses the value after the jump, the end the value before it.
template <int Dim>
class StepMethod {
  public:
    /// Computes f at the shape of the stages; returns false if it cannot be evaluated.
    using Rhs = std::function<bool(double t, Side side, StageVectors<Dim>& stages, Points<Dim>& v)>;
    /// Makes a method. `tolerance` is the error allowed per step, the largest distance of a point; with 0,
    /// steps are prescribed and no error is estimated.
    static std::unique_ptr<StepMethod> of(Method method, double tolerance);
    virtual ~StepMethod() = default;

    /// Returns the first step if the fastest points have this speed. `speed` is in sizes per unit of time and
    /// positive; the step is in the same unit of time.
    virtual double firstStep(double speed) const = 0;
    /// Attempts a step from x at t to `to`, with sums by the stages; adds the field at t to the pace if it
    /// was unknown. Returns false if a field could not be evaluated.
    virtual bool attempt(const Rhs& f, StageVectors<Dim>& stages, double t, double to, const Nodal<Dim>& x,
                         Pace<Dim>& pace) = 0;

    // The following functions refer to the last successful attempt.
    /// Returns the shape at the end of the step.
    virtual const Nodal<Dim>& result() const = 0;
    /// Returns the error relative to the tolerance: the step is accepted up to 1.
    virtual double error() const = 0;
    /// Sets step and order for another attempt, because the error was too large.
    virtual void retry(Pace<Dim>& pace) const = 0;
    /// Accepts the step. `shortened`: earlier attempts failed; `cut`: it is shorter than the control
    /// proposed.
    virtual void accept(Pace<Dim>& pace, bool shortened, bool cut) = 0;
    /// Returns whether at() needs the right-hand side at the end of the step.
    virtual bool needsEndField() const = 0;
    /// Returns the solution (Dim × n) at a time t inside the step: by the integral of the fields'
    /// interpolant, of the step's order (Adams), by dense output of order 4 (Dormand–Prince), or by cubic
    /// Hermite interpolation of order 3 with `endField` (if needsEndField()). Equals result() at the end of
    /// the step up to rounding.
    virtual Points<Dim> at(double t, const Points<Dim>& endField) const = 0;
    /// Return what at() depends on, and adopt it for a step from a shape at t to `to` that was taken
    /// elsewhere.
    virtual DenseStep<Dim> dense() const = 0;
    virtual void adopt(const DenseStep<Dim>& step, double t, double to, const Nodal<Dim>& x) = 0;
};

/// Returns f as a field that does not change any more; null if it cannot be evaluated.
template <int Dim>
Nodal<Dim> fieldAt(const typename StepMethod<Dim>::Rhs& f, StageVectors<Dim>& stages, double t, Side side) {
    auto field = std::make_shared<Points<Dim>>();
    return f(t, side, stages, *field) ? field : nullptr;
}

/// Returns the largest length of a column; 0 without columns.
template <int Dim>
double largestColumn(const Points<Dim>& points) {
    return points.cols() == 0 ? 0 : points.colwise().norm().maxCoeff();
}

}  // namespace wend
