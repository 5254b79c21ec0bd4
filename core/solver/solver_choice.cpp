#include "core/solver/solver_choice.h"

#include <unistd.h>

#include <cmath>
namespace wend {
namespace {

// By extrapolation from what was measured on a bar (docs/scale.md): from about here on multigrid takes less
// time. With 35 700 vertices it still takes more.
constexpr int kQuickerSolid = 80000;
constexpr double kPartOfMemory = 0.5;

}  // namespace

std::string nameOf(SolverKind kind) {
    return kind == SolverKind::Automatic ? "auto" : kind == SolverKind::Direct ? "direct" : "multigrid";
}

/// Nested dissection: n^(4/3) entries of a factor in space, n log n in the plane.
double directSolverBytes(int dimension, int vertices) {
    if (dimension == 2) return 1.0e9 * std::pow(vertices / 160e3, 1.1);
    return 6.4e9 * std::pow(vertices / 105e3, 1.4);
}

SolverKind chosenSolver(SolverKind wanted, int dimension, int vertices, double machineMemory) {
    if (wanted != SolverKind::Automatic) return wanted;
    const bool large = (dimension == 3 && vertices >= kQuickerSolid) ||
                       directSolverBytes(dimension, vertices) > kPartOfMemory * machineMemory;
    return large ? SolverKind::Multigrid : SolverKind::Direct;
}

double machineMemory() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace wend
