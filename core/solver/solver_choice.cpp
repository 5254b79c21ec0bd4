#include "core/solver/solver_choice.h"

#include <unistd.h>

#include <cmath>
namespace wend {
namespace {

// Multigrid is quicker from this many vertices on, measured on a bar (docs/scale.md): 12,800 vertices take
// about as long either way, 22,400 a third less by multigrid.
constexpr int kQuickerSolid = 20000;
constexpr double kPartOfMemory = 0.5;

}  // namespace

std::string nameOf(SolverKind kind) {
    return kind == SolverKind::Automatic ? "auto" : kind == SolverKind::Direct ? "direct" : "multigrid";
}

/// Returns a power law through a measured size: 1.0 GB at 160,000 vertices in the plane, 6.4 GB at 105,000 in
/// space. Nested dissection has n^(4/3) entries of a factor in space and n log n in the plane (George 1973);
/// the exponents are somewhat larger, as measured.
double directSolverBytes(int dimension, int vertices) {
    if (dimension == 2) return 1.0e9 * std::pow(vertices / 160e3, 1.1);
    return 6.4e9 * std::pow(vertices / 105e3, 1.4);
}

double multigridBytes(int dimension, int vertices) {
    return (dimension == 2 ? 2500.0 : 12000.0) * vertices;
}

bool fitsDirectly(int dimension, int vertices, double machineMemory) {
    return directSolverBytes(dimension, vertices) <= kPartOfMemory * machineMemory;
}

SolverKind chosenSolver(SolverKind wanted, int dimension, int vertices, double machineMemory) {
    if (wanted != SolverKind::Automatic) return wanted;
    const bool large =
        (dimension == 3 && vertices >= kQuickerSolid) || !fitsDirectly(dimension, vertices, machineMemory);
    return large ? SolverKind::Multigrid : SolverKind::Direct;
}

double machineMemory() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace wend
