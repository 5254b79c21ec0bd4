#pragma once

#include <string>

namespace wend {

/// How the linear system of a velocity field is solved: by a Cholesky factor, or by conjugate gradients with
/// multigrid. Automatic: see chosenSolver().
enum class SolverKind { Automatic, Direct, Multigrid };

/// Returns "direct" or "multigrid".
std::string nameOf(SolverKind kind);

/// Returns whether factors of so many vertices take no more than half of `machineMemory`, the bytes that the
/// machine has, not those that are free: the answer is the same at every run.
bool fitsDirectly(int dimension, int vertices, double machineMemory);

/// Returns Direct or Multigrid. Automatic takes multigrid for solids from so many vertices on that it is the
/// quicker, and for any shape whose factors do not fit. From 20,000 vertices on a solid takes multigrid; a
/// planar shape only for lack of memory. The other kinds are returned as they are, whether they fit or not.
SolverKind chosenSolver(SolverKind wanted, int dimension, int vertices, double machineMemory);

/// Returns about how many bytes a direct solve takes: matrix, contributions and factor. Measured on bars and
/// strips; a body that is more compact takes up to twice as many.
double directSolverBytes(int dimension, int vertices);

/// Returns about how many bytes multigrid takes. Measured on bars and strips.
double multigridBytes(int dimension, int vertices);

/// Returns the bytes of memory that the machine has.
double machineMemory();

}  // namespace wend
