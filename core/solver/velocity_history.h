#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/types.h"

namespace wend {

/// The last velocity fields, from which the next one is guessed. A guess only saves iterations: the solver's
/// answer is as accurate whatever it starts from. Cheap to copy.
template <int Dim>
class VelocityHistory {
  public:
    /// What was solved for at a time; an earlier field of the same time is replaced.
    void record(double time, const Points<Dim>& prescribed, const Points<Dim>& velocity);
    /// After a jump (other constraints, a breakpoint between motions, a restored state).
    void clear() { m_fields.clear(); }
    /// The polynomial in time through the last fields (quadratic, once there are three); none without a
    /// field. For a prescribed motion that is smooth in time.
    std::optional<Points<Dim>> at(double time) const;
    /// The combination of the last fields that reproduces the prescribed velocities best (v̂ is linear in
    /// them): for a drag, whose motion is not smooth in time. None without a field of as many constraints.
    std::optional<Points<Dim>> fitting(const Points<Dim>& prescribed) const;

  private:
    struct Field {
        double time;
        std::shared_ptr<const Points<Dim>> prescribed, velocity;
    };
    Points<Dim> combined(const Eigen::VectorXd& weights) const;

    std::vector<Field> m_fields;  // the oldest first
};

}  // namespace wend
