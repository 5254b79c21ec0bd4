#pragma once

#include <stop_token>

#include "core/solver/multigrid/prolongation.h"

namespace wend {

/// Pᵀ K P, exactly symmetric; motions that are missing have a 1 on the diagonal. Row by row: the same bits
/// for any number of threads. Empty once `stop` is requested.
template <int Size, int Modes>
BlockRows<Modes> coarseMatrix(const BlockRows<Size>& K, const Prolongation<Size, Modes>& P,
                              WorkerPool& workers, const std::stop_token& stop);

}  // namespace wend
