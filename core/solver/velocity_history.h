#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/assembly/stage_vectors.h"

namespace wend {

/// Keeps the last velocity fields, from which the next one is guessed. A guess only saves iterations: the
/// solver's answer is equally accurate from any start. It is cheap to copy.
template <int Dim>
class VelocityHistory {
  public:
    /// Turns fields along with the surroundings of their vertices, from one shape to another.
    using Turn =
        std::function<void(const Points<Dim>& from, const Points<Dim>& to, std::vector<Points<Dim>>& fields)>;

    /// Begins a step from a shape. The errors of the guesses in the step before predict those in this one, at
    /// the same part of the step.
    void begin(double from, double to, const Nodal<Dim>& shape, const Turn& turn);
    /// Records a field that was solved for; an earlier field of about the same time is replaced.
    void record(double time, const Points<Dim>& prescribed, const Points<Dim>& velocity);
    /// Forgets all fields, after a jump (other constraints, a breakpoint between motions, a restored state).
    void clear() { *this = {}; }
    /// Returns the polynomial in time through the last fields (quadratic, once there are three), corrected
    /// within a step by its error in the step before; nothing without a field. It suits a prescribed motion
    /// that is smooth in time.
    std::optional<Points<Dim>> at(double time);
    /// Returns the combination of the last fields that best reproduces the prescribed velocities (v̂ is
    /// linear in them); nothing without a field of as many constraints. It suits a drag, whose motion is not
    /// smooth in time.
    std::optional<Points<Dim>> fitting(const Points<Dim>& prescribed) const;

    /// Hands all that it holds to an archive, which stores or restores it.
    template <class Archive>
    void archive(Archive& archive) {
        auto& [fields, before, step, polynomial] = *this;
        archive(fields, before, step, polynomial);
    }

  private:
    /// A field that was solved for, with the velocities that were prescribed for it.
    struct Field {
        double time = 0;
        Nodal<Dim> prescribed, velocity;

        template <class Archive>
        void archive(Archive& archive) {
            auto& [at, asked, found] = *this;
            archive(at, asked, found);
        }
    };
    /// The error of a guess, at its place within the step.
    struct Miss {
        double place = 0;  // in the step: 0 at its start, 1 at its end
        int turn = 0;      // how many of this place came before it
        Nodal<Dim> field;

        template <class Archive>
        void archive(Archive& archive) {
            auto& [where, number, what] = *this;
            archive(where, number, what);
        }
    };
    /// A step with the errors of its guesses. The next step expects the same errors at the same places.
    struct Step {
        double from = 0, width = 0;  // no width: there is none
        Nodal<Dim> shape;            // at its start
        std::vector<Miss> misses;

        template <class Archive>
        void archive(Archive& archive) {
            auto& [begin, length, start, missed] = *this;
            archive(begin, length, start, missed);
        }
    };
    Points<Dim> combined(const Eigen::VectorXd& weights) const;
    Points<Dim> through(double time) const;
    double place(double time) const { return (time - m_step.from) / m_step.width; }
    int turnOf(double place) const;

    std::vector<Field> m_fields;  // the oldest first
    Step m_before, m_step;        // the one before, its misses turned to where the other begins
    Nodal<Dim> m_polynomial;      // that the last guess began with; null where it was none of three fields
};

}  // namespace wend
