#pragma once

#include "core/solver/iterative_solver.h"
#include "mpi/team.h"

namespace wend {

/// Makes iterative solvers whose systems are divided among the processes of a team. For its first process;
/// the others are in serve(). The team outlives them.
template <int Dim>
IterativeSolverFactory<Dim> dividedSolvers(const Team& team);

/// Does what dividedSolvers() of the first process ask for, until dismiss().
void serve(const Team& team);

/// Ends serve() in all other processes.
void dismiss(const Team& team);

}  // namespace wend
