#pragma once

#include <vector>

#include "core/solver/multigrid/aggregates.h"
#include "core/solver/multigrid/chebyshev.h"

namespace wend {

/// The prolongation P of smoothed aggregation (Vaněk, Mandel, Brezina 1996): a coarse field is `Modes`
/// numbers for each aggregate. Within it they are the motions of a near null space, made orthonormal; steps
/// of Jacobi's method with K make them smooth.
template <int Size, int Modes>
class Prolongation {
  public:
    using Block = Eigen::Matrix<float, Size, Modes, Eigen::RowMajor>;
    /// The values of all motions at one row.
    using Motions = Eigen::Matrix<double, Size, Modes>;
    using Square = Eigen::Matrix<double, Modes, Modes>;

    /// Makes P and returns the motions as coarse fields, for the aggregates that have rows of K, ascending.
    /// In a part of a divided matrix those have no rows in other parts. The result is unfinished if the
    /// threads are stopped.
    std::vector<Square> build(const Aggregates& aggregates, const std::vector<Motions>& motions,
                              const BlockRows<Size>& K, const Chebyshev<Size>& smoother, WorkerPool& workers,
                              const PartLinks& links = {});

    /// Returns the number of rows: those of K, and behind them those of its other columns.
    int rows() const { return static_cast<int>(m_start.size()) - 1; }
    /// Return the number of all aggregates that the rows have, and the number of each in the whole,
    /// ascending.
    int aggregates() const { return static_cast<int>(m_numbers.size()); }
    int number(int aggregate) const { return m_numbers[aggregate]; }
    /// Returns the numbers of the aggregates that have rows of K.
    const std::vector<int>& ownAggregates() const { return m_own; }
    /// Returns the first entry of a row, whose entries are [begin(row), begin(row + 1)), their aggregates
    /// ascending.
    int begin(int row) const { return m_start[row]; }
    int aggregate(int entry) const { return m_aggregate[entry]; }
    const Block& block(int entry) const { return m_blocks[entry]; }
    /// Return the rows of K that have an aggregate, ascending, and their entries.
    int usersBegin(int aggregate) const { return m_usersStart[aggregate]; }
    int user(int place) const { return m_users[place]; }
    int userEntry(int place) const { return m_userEntries[place]; }
    /// Returns the motions that an aggregate of too few rows does not have, as bits; none for an aggregate of
    /// another part.
    unsigned missing(int aggregate) const { return m_missing[aggregate]; }

    /// Compute Pᵀ r and P c, in the rows of K.
    void restrict(const Points<Size>& r, Points<Modes>& coarse, WorkerPool& workers) const;
    void prolong(const Points<Modes>& coarse, Points<Size>& z, WorkerPool& workers) const;

  private:
    std::vector<Square> makeMotions(const Aggregates& aggregates, const std::vector<Motions>& motions);
    void smooth(double damping, const BlockRows<Size>& K, const Chebyshev<Size>& smoother,
                WorkerPool& workers);
    void addCopies(const PartLinks& links);
    void renumber();
    void listUsers(int rows);

    int m_rows = 0;                         // of K
    std::vector<int> m_own, m_numbers;      // numbers of aggregates
    std::vector<unsigned> m_ownMissing;     // of the first
    std::vector<int> m_start, m_aggregate;  // while it is built by their numbers
    std::vector<Block> m_blocks;
    std::vector<int> m_usersStart, m_users, m_userEntries;
    std::vector<unsigned> m_missing;
};

}  // namespace wend
