#pragma once

#include <array>
#include <vector>

#include "core/integration/method.h"
#include "core/motion/trajectory.h"

namespace wend {

/// An explicit Runge–Kutta method: k_i = f(t + c_i h, y + h Σ_j a_ij k_j), y′ = y + h Σ b_i k_i.
struct Tableau {
    int stages;
    std::array<double, 7> c;
    std::array<std::array<double, 7>, 7> a;
    std::array<double, 7> b;
    std::array<double, 7> error;  // b − b̂ of the embedded method; zero if there is none
    bool firstSameAsLast;         // the last stage is f(t + h, y′)

    static const Tableau& of(Method method);
};

/// One step of dy/dt = f(t, y) for y an Eigen matrix. f is a call f(t, side, y, dy) that returns false where
/// it cannot be evaluated. The stage at the start of the step sees the right-hand side after it, those at its
/// end before it: it may jump at either.
template <class Y>
class RungeKuttaStep {
  public:
    explicit RungeKuttaStep(Method method) : m_tableau(Tableau::of(method)), m_k(m_tableau.stages) {}

    /// From y at t to `to`. `slope` is f(t, y) if it is known, else empty. False if a stage could not be
    /// evaluated.
    template <class Rhs>
    bool attempt(Rhs&& f, double t, double to, const Y& y, const Y& slope) {
        m_y = y;
        m_h = to - t;
        for (int i = 0; i < m_tableau.stages; ++i) {
            const double c = m_tableau.c[i];
            if (i == 0 && slope.size() > 0) {
                m_k[0] = slope;
                continue;
            }
            m_stage = y;
            for (int j = 0; j < i; ++j) {
                if (m_tableau.a[i][j] != 0) m_stage += m_h * m_tableau.a[i][j] * m_k[j];
            }
            const Side side = c == 1 ? Side::Before : Side::After;
            if (!f(c == 1 ? to : t + c * m_h, side, m_stage, m_k[i])) return false;
        }
        // With an FSAL method this is the argument of the last stage.
        if (!m_tableau.firstSameAsLast) m_stage = combined(m_tableau.b);
        return true;
    }

    const Y& result() const { return m_stage; }
    /// h Σ (b − b̂)_i k_i.
    Y error() const { return combined(m_tableau.error) - m_y; }
    bool firstSameAsLast() const { return m_tableau.firstSameAsLast; }
    /// f at the result, for a method that has it.
    const Y& lastSlope() const { return m_k.back(); }

    /// y at t + θ h between the ends of a Dormand–Prince step, of order 4 (Hairer, Nørsett, Wanner I, II.6).
    Y dense(double theta) const;
    /// The same for the others, of order 3, from the slope at the result: the cubic Hermite polynomial.
    Y hermite(double theta, const Y& endSlope) const;

  private:
    Y combined(const std::array<double, 7>& weights) const {
        Y y = m_y;
        for (int i = 0; i < m_tableau.stages; ++i) {
            if (weights[i] != 0) y += m_h * weights[i] * m_k[i];
        }
        return y;
    }

    const Tableau& m_tableau;
    std::vector<Y> m_k;
    Y m_y, m_stage;
    double m_h = 0;
};

template <class Y>
Y RungeKuttaStep<Y>::hermite(double theta, const Y& endSlope) const {
    const double rest = 1 - theta;
    const Y difference = m_stage - m_y;
    return m_y + theta * difference +
           theta * rest * (rest * (m_h * m_k[0] - difference) - theta * (m_h * endSlope - difference));
}

/// The Hermite cubic and a quartic term that the middle stages determine.
template <class Y>
Y RungeKuttaStep<Y>::dense(double theta) const {
    static constexpr std::array<double, 7> kQuartic = {
        -12715105075.0 / 11282082432,  0,
        87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
        701980252875.0 / 199316789632, -1453857185.0 / 822651844,
        69997945.0 / 29380423};
    const double rest = 1 - theta;
    const Y quartic = combined(kQuartic) - m_y;
    return hermite(theta, m_k.back()) + theta * theta * rest * rest * quartic;
}

}  // namespace wend
