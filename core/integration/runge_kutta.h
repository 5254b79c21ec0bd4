#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/assembly/stage_vectors.h"
#include "core/integration/method.h"
#include "core/motion/trajectory.h"

namespace wend {

/// An explicit Runge–Kutta method: k_i = f(t + c_i h, y + h Σ_j a_ij k_j), y′ = y + h Σ b_i k_i.
struct Tableau {
    int stages;
    std::array<double, 7> c;
    std::array<std::array<double, 7>, 7> a;
    std::array<double, 7> b;
    std::array<double, 7> error;  // b − b̂ of the embedded method; zero for none
    bool firstSameAsLast;         // the last stage is f(t + h, y′)

    /// Returns the coefficients of a method: DormandPrince the pair 5(4) of Dormand and Prince (1980), which
    /// Adams uses, too, with prescribed steps; RungeKutta4 the classical method of order 4; Midpoint that of
    /// order 2 (Hairer, Nørsett, Wanner I, II.1 and II.5). The reference is valid for the whole run of the
    /// program. Arrays beyond `stages` are 0.
    static const Tableau& of(Method method);
};

/// Takes one step of dy/dt = f(t, y) for the nodes y of a shape. f is called as f(t, side, stages, dy) at the
/// current stage shape and returns false if it cannot be evaluated. The right-hand side may jump at both
/// ends: the first stage sees the value after the start, the last ones the value before the end.
template <int Dim>
class RungeKuttaStep {
  public:
    explicit RungeKuttaStep(Method method) : m_tableau(Tableau::of(method)), m_k(m_tableau.stages) {}

    /// Steps from y at t to `to`. `slope` is f(t, y) if known, else null. Returns false if a stage could not
    /// be evaluated.
    template <class Rhs>
    bool attempt(Rhs&& f, StageVectors<Dim>& stages, double t, double to, const Nodal<Dim>& y,
                 const Nodal<Dim>& slope) {
        m_y = y;
        m_h = to - t;
        m_k[0] = slope;
        for (int i = slope ? 1 : 0; i < m_tableau.stages; ++i) {
            const double c = m_tableau.c[i];
            stages.combine(y, terms(m_tableau.a[i], i));
            auto k = std::make_shared<Points<Dim>>();
            if (!f(c == 1 ? to : t + c * m_h, c == 1 ? Side::Before : Side::After, stages, *k)) return false;
            m_k[i] = std::move(k);
        }
        // With an FSAL method this equals the argument of the last stage.
        if (!m_tableau.firstSameAsLast) stages.combine(y, terms(m_tableau.b, m_tableau.stages));
        m_result = stages.shape();
        return true;
    }

    const Nodal<Dim>& result() const { return m_result; }
    /// Returns the largest |h Σ (b − b̂)_i k_i| of a node.
    double error(StageVectors<Dim>& stages) const {
        return stages.maximum(terms(m_tableau.error, m_tableau.stages));
    }
    bool firstSameAsLast() const { return m_tableau.firstSameAsLast; }
    /// Returns f at the result, for a method with firstSameAsLast().
    const Nodal<Dim>& lastSlope() const { return m_k.back(); }

    /// Returns y at t + θ h, 0 ≤ θ ≤ 1, within a Dormand–Prince step, by dense output of order 4 (Hairer,
    /// Nørsett, Wanner I, II.6).
    Points<Dim> dense(double theta) const;
    /// Returns the slopes that dense() needs, or hermite() without the one at the end, in the order of the
    /// stages.
    std::vector<Nodal<Dim>> denseSlopes() const {
        std::vector<Nodal<Dim>> slopes;
        for (int i = 0; i < m_tableau.stages; ++i)
            if (isDense(i)) slopes.push_back(m_k[i]);
        return slopes;
    }
    /// Takes over a step from y over h that was computed elsewhere, with its denseSlopes().
    void adopt(double h, const Nodal<Dim>& y, const Nodal<Dim>& result, std::span<const Nodal<Dim>> slopes) {
        m_h = h;
        m_y = y;
        m_result = result;
        auto slope = slopes.begin();
        for (int i = 0; i < m_tableau.stages && slope != slopes.end(); ++i)
            if (isDense(i)) m_k[i] = *slope++;
    }
    /// Returns the same for the other methods, to order 3, by the cubic Hermite polynomial with the slope at
    /// the result.
    Points<Dim> hermite(double theta, const Points<Dim>& endSlope) const;

  private:
    static constexpr std::array<double, 7> kQuartic = {
        -12715105075.0 / 11282082432,  0,
        87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
        701980252875.0 / 199316789632, -1453857185.0 / 822651844,
        69997945.0 / 29380423};

    /// Returns whether dense(), or hermite() without dense output, needs the slope of a stage.
    bool isDense(int stage) const { return m_tableau.firstSameAsLast ? kQuartic[stage] != 0 : stage == 0; }
    /// Returns h Σ w_i k_i as a list of terms.
    std::vector<WeightedField<Dim>> terms(const std::array<double, 7>& weights, int count) const {
        std::vector<WeightedField<Dim>> sum;
        for (int i = 0; i < count; ++i)
            if (weights[i] != 0) sum.push_back({m_h * weights[i], m_k[i]});
        return sum;
    }

    const Tableau& m_tableau;
    std::vector<Nodal<Dim>> m_k;
    Nodal<Dim> m_y, m_result;
    double m_h = 0;
};

template <int Dim>
Points<Dim> RungeKuttaStep<Dim>::hermite(double theta, const Points<Dim>& endSlope) const {
    const double rest = 1 - theta;
    const Points<Dim> difference = *m_result - *m_y;
    return *m_y + theta * difference +
           theta * rest * (rest * (m_h * *m_k[0] - difference) - theta * (m_h * endSlope - difference));
}

/// Adds a quartic term, which the middle stages determine, to the Hermite cubic.
template <int Dim>
Points<Dim> RungeKuttaStep<Dim>::dense(double theta) const {
    const double rest = 1 - theta;
    Points<Dim> y = hermite(theta, *m_k.back());
    for (const auto& [weight, k] : terms(kQuartic, m_tableau.stages))
        y += theta * theta * rest * rest * weight * *k;
    return y;
}

}  // namespace wend
