#pragma once

#include <limits>

namespace wend {

/// Decides when a new factor pays, by counted work and never by a clock, so that a run repeats to the last
/// bit under any load. It refactorizes before an evaluation if continuing, with half an iteration more than
/// the last evaluation took, would cost more than the average evaluation since the factor, the factor
/// included.
class RefactorPolicy {
  public:
    /// The counts since the factor was made.
    struct Counts {
        int iterations = 0, evaluations = 0, last = 0;  // last: iterations of the last evaluation

        template <class Archive>
        void archive(Archive& archive) {
            auto& [inAll, solves, newest] = *this;
            archive(inAll, solves, newest);
        }
    };

    /// Sets both costs in one unit, that of SolverCost.
    void setCosts(double factor, double iteration) {
        m_factor = factor;
        m_iteration = iteration;
    }
    /// Defers a factor that costs more than this, for an even pace, until the iterations of a single
    /// evaluation cost a good part of it.
    void setLongestPause(double cost) { m_longestPause = cost; }
    /// Restarts the counts for a new factor.
    void factorized() { m_counts = {}; }
    /// Counts an evaluation.
    void evaluated(int iterations) {
        m_counts.iterations += iterations;
        m_counts.last = iterations;
        ++m_counts.evaluations;
    }
    /// Returns whether a new factor is deferred for an even pace.
    bool keepsPace() const { return m_factor > m_longestPause; }
    /// Returns whether a new factor pays.
    bool due() const {
        if (keepsPace()) return m_counts.last * m_iteration > kPartOfPause * m_factor;
        return m_counts.evaluations > 0 && (m_counts.last + kMore) * m_iteration * m_counts.evaluations >
                                               m_factor + m_counts.iterations * m_iteration;
    }
    /// Returns whether that many more iterations cost clearly more than starting from a new factor.
    bool hopeless(double iterations) const { return iterations * m_iteration > 1.5 * m_factor; }

    const Counts& counts() const { return m_counts; }
    void setCounts(const Counts& counts) { m_counts = counts; }

  private:
    static constexpr double kPartOfPause = 0.15, kMore = 0.5;

    double m_factor = 0, m_iteration = 1, m_longestPause = std::numeric_limits<double>::infinity();
    Counts m_counts;
};

/// The costs of the parts of an evaluation, in seconds of a nominal machine, which does floating-point
/// operations and moves bytes at fixed rates. Only their ratios matter.
struct SolverCost {
    double factorFlops = 0, factorEntries = 0;  // of the Cholesky factor
    double contributions = 0;                   // products of d × d blocks in an assembly
    double cells = 0;
    int dimension = 2;

    double factor() const;     // assembly and numeric factorization
    double iteration() const;  // one pair of triangular solves and one product with the matrix
};

}  // namespace wend
