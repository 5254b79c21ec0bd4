#pragma once

#include <stop_token>
#include <vector>

#include "core/solver/multigrid/prolongation.h"

namespace wend {

/// The contribution of a part's rows of K to the lower triangle of Pᵀ K P: the number of blocks in every row,
/// their columns, ascending, and their values. Rows and columns are numbers of aggregates in the whole.
template <int Modes>
struct CoarseShare {
    std::vector<int> rows, count, columns;
    std::vector<unsigned> missing;  // per row: see Prolongation
    std::vector<Eigen::Matrix<float, Modes, Modes>> blocks;
    // Remainders of the blocks beyond single precision, if the sum over the parts must be that of the whole.
    std::vector<Eigen::Matrix<float, Modes, Modes>> rests;
    // The aggregates that have no rows in other parts, and what Prolongation::build() returns of them.
    std::vector<int> own;
    std::vector<Eigen::Matrix<double, Modes, Modes>> motions;
};

/// Computes the share row by row, with the same bits for any number of threads. It is incomplete if the
/// threads are stopped. It has rests if there are other parts.
template <int Size, int Modes>
CoarseShare<Modes> coarseShare(const BlockRows<Size>& K, const Prolongation<Size, Modes>& P,
                               WorkerPool& workers);

/// Returns the sum of the shares of all parts, in their order, without motions.
template <int Modes>
CoarseShare<Modes> merged(const std::vector<CoarseShare<Modes>>& shares);

/// Returns Pᵀ K P, exactly symmetric, from the share of the whole; missing motions have a 1 on the diagonal.
/// It is symmetric positive definite if K is, up to the rounding of its single precision.
template <int Modes>
BlockRows<Modes> coarseMatrix(const CoarseShare<Modes>& share);

}  // namespace wend
