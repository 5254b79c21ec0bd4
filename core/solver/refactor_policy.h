#pragma once

namespace wend {

/// When a new factor pays: decided by counted work, never by a clock, so that a run repeats to the last bit
/// under any load. Before an evaluation: refactorize when going on, with one iteration more than the last
/// evaluation took, would cost more than the average evaluation since the factor, the factor included.
class RefactorPolicy {
  public:
    /// In one unit, that of SolverCost.
    void setCosts(double factor, double iteration) {
        m_factor = factor;
        m_iteration = iteration;
        m_spent = 0;
        m_evaluations = m_last = 0;
    }
    /// A new factor: the counting starts again.
    void factorized() { setCosts(m_factor, m_iteration); }
    void evaluated(int iterations) {
        m_spent += iterations * m_iteration;
        m_last = iterations;
        ++m_evaluations;
    }
    bool due() const {
        return m_evaluations > 0 && (m_last + 1) * m_iteration * m_evaluations > m_factor + m_spent;
    }
    /// Whether so many iterations more cost clearly more than to start from a new factor.
    bool hopeless(double iterations) const { return iterations * m_iteration > 1.5 * m_factor; }

  private:
    double m_factor = 0, m_iteration = 1, m_spent = 0;
    int m_evaluations = 0, m_last = 0;
};

/// What the parts of an evaluation cost, in seconds of a nominal machine: floating-point operations and bytes
/// at fixed rates. Only ratios matter.
struct SolverCost {
    double factorFlops = 0, factorEntries = 0;  // of the Cholesky factor
    double contributions = 0;                   // products of d × d blocks in an assembly
    double cells = 0;
    int dimension = 2;

    double factor() const;     // assembly and numeric factorization
    double iteration() const;  // one pair of triangular solves and one product with the matrix
};

}  // namespace wend
