// The module wend-multigrid.so: algebraic multigrid by PETSc (GAMG), loaded with the first system that needs
// it.

#include <petscksp.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>

#include "core/solver/multigrid/algebraic_hierarchy.h"

namespace wend {
namespace {

/// What PETSc reports of an error on its way up, kept for the message; it prints and ends nothing.
PetscErrorCode keepError(MPI_Comm, int, const char*, const char*, PetscErrorCode code, PetscErrorType type,
                         const char* message, void* context) {
    auto& text = *static_cast<std::string*>(context);
    if (type == PETSC_ERROR_INITIAL && message) text = message;
    return code;
}

/// Of the levels. Measured on a bar of 12 600 vertices, whose coarse matrix has 3300 rows: 18 iterations,
/// where an exact solve leaves 16, and GAMG as it comes 33. Richardson over SOR twice takes 21.
constexpr std::array<std::array<const char*, 2>, 5> kOptions = {{{"-wend_pc_gamg_aggressive_coarsening", "0"},
                                                                 {"-wend_pc_gamg_coarse_eq_limit", "1000"},
                                                                 {"-wend_mg_levels_ksp_type", "chebyshev"},
                                                                 {"-wend_mg_levels_ksp_max_it", "3"},
                                                                 {"-wend_mg_levels_pc_type", "pbjacobi"}}};

/// What happens at every signal, as it was when this was made: MPI and PETSc put handlers of their own in
/// place of the program's.
class SignalHandlers {
  public:
    SignalHandlers() {
        for (int signal = 1; signal < kSignals; ++signal)
            m_known[signal] = sigaction(signal, nullptr, &m_actions[signal]) == 0;
    }
    ~SignalHandlers() {
        for (int signal = 1; signal < kSignals; ++signal)
            if (m_known[signal]) sigaction(signal, &m_actions[signal], nullptr);
    }
    SignalHandlers(const SignalHandlers&) = delete;
    SignalHandlers& operator=(const SignalHandlers&) = delete;

  private:
    static constexpr int kSignals = 32;
    std::array<struct sigaction, kSignals> m_actions{};
    std::array<bool, kSignals> m_known{};
};

/// MPI is for this process alone: else it would start a daemon beside it, and leave a folder where this ends
/// early.
PetscErrorCode start() {
    const SignalHandlers handlers;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    PetscCall(PetscOptionsSetValue(nullptr, "-no_signal_handler", "1"));
    PetscCall(PetscOptionsSetValue(nullptr, "-skip_petscrc", "1"));
    PetscCall(PetscInitializeNoArguments());
    for (const auto& [name, value] : kOptions) PetscCall(PetscOptionsSetValue(nullptr, name, value));
    return 0;
}

/// PETSc, once per process.
bool started() {
    static const bool done = start() == 0;
    return done;
}

class PetscHierarchy final : public AlgebraicHierarchy {
  public:
    ~PetscHierarchy() override { clear(); }

    std::string build(const BlockMatrix& matrix, std::span<const double> nearNullSpace,
                      int vectors) override {
        if (!started()) return "PETSc does not start";
        m_error.clear();
        PetscPushErrorHandler(keepError, &m_error);
        clear();
        const PetscErrorCode code = make(matrix, nearNullSpace, vectors);
        PetscPopErrorHandler();
        if (code == 0) return {};
        clear();
        return m_error.empty() ? "PETSc reports error " + std::to_string(code) : m_error;
    }

    bool apply(std::span<const double> r, std::span<double> z) override {
        m_error.clear();
        PetscPushErrorHandler(keepError, &m_error);
        const PetscErrorCode code = cycle(r, z);
        PetscPopErrorHandler();
        return code == 0;
    }

  private:
    PetscErrorCode makeMatrix(const BlockMatrix& matrix);
    PetscErrorCode attachNearNullSpace(std::span<const double> vectors, int count, PetscInt length);
    PetscErrorCode make(const BlockMatrix& matrix, std::span<const double> nearNullSpace, int vectors);
    PetscErrorCode cycle(std::span<const double> r, std::span<double> z);
    void clear();

    std::string m_error;
    Mat m_matrix = nullptr;
    PC m_preconditioner = nullptr;
    Vec m_right = nullptr, m_solution = nullptr;
    std::vector<PetscInt> m_start, m_column;
    std::vector<double> m_values;
};

void PetscHierarchy::clear() {
    PCDestroy(&m_preconditioner);
    MatDestroy(&m_matrix);
    VecDestroy(&m_right);
    VecDestroy(&m_solution);
}

/// Scalar rows, in arrays of ours.
PetscErrorCode PetscHierarchy::makeMatrix(const BlockMatrix& matrix) {
    const int size = matrix.blockSize;
    const std::size_t entries = matrix.column.size() * matrix.blockEntries();
    m_start.assign(1, 0);
    m_column.clear();
    m_column.reserve(entries);
    m_values.clear();
    m_values.reserve(entries);
    for (int row = 0; row < matrix.rows(); ++row)
        for (int i = 0; i < size; ++i) {
            for (int b = matrix.start[row]; b < matrix.start[row + 1]; ++b)
                for (int j = 0; j < size; ++j) {
                    m_column.push_back(matrix.column[b] * size + j);
                    m_values.push_back(
                        matrix.values[static_cast<std::size_t>(b) * matrix.blockEntries() + j * size + i]);
                }
            m_start.push_back(static_cast<PetscInt>(m_column.size()));
        }
    const PetscInt rows = matrix.rows() * size;
    PetscCall(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, rows, rows, m_start.data(), m_column.data(),
                                        m_values.data(), &m_matrix));
    PetscCall(MatSetBlockSize(m_matrix, size));
    PetscCall(MatSetOption(m_matrix, MAT_SPD, PETSC_TRUE));
    return 0;
}

PetscErrorCode PetscHierarchy::attachNearNullSpace(std::span<const double> vectors, int count,
                                                   PetscInt length) {
    std::vector<Vec> basis(count);
    for (int k = 0; k < count; ++k) {
        PetscCall(MatCreateVecs(m_matrix, &basis[k], nullptr));
        PetscScalar* values = nullptr;
        PetscCall(VecGetArray(basis[k], &values));
        std::copy_n(vectors.data() + static_cast<std::size_t>(k) * length, length, values);
        PetscCall(VecRestoreArray(basis[k], &values));
        for (int other = 0; other < k; ++other) {
            PetscScalar product = 0;
            PetscCall(VecDot(basis[k], basis[other], &product));
            PetscCall(VecAXPY(basis[k], -product, basis[other]));
        }
        PetscReal norm = 0;
        PetscCall(VecNormalize(basis[k], &norm));
    }
    MatNullSpace space = nullptr;
    PetscCall(MatNullSpaceCreate(PETSC_COMM_SELF, PETSC_FALSE, count, basis.data(), &space));
    PetscCall(MatSetNearNullSpace(m_matrix, space));
    PetscCall(MatNullSpaceDestroy(&space));
    for (auto& vector : basis) PetscCall(VecDestroy(&vector));
    return 0;
}

PetscErrorCode PetscHierarchy::make(const BlockMatrix& matrix, std::span<const double> nearNullSpace,
                                    int vectors) {
    PetscCall(makeMatrix(matrix));
    const PetscInt length = matrix.rows() * matrix.blockSize;
    PetscCall(attachNearNullSpace(nearNullSpace, vectors, length));
    PetscCall(MatCreateVecs(m_matrix, &m_solution, &m_right));
    PetscCall(PCCreate(PETSC_COMM_SELF, &m_preconditioner));
    PetscCall(PCSetOptionsPrefix(m_preconditioner, "wend_"));
    PetscCall(PCSetOperators(m_preconditioner, m_matrix, m_matrix));
    PetscCall(PCSetType(m_preconditioner, PCGAMG));
    PetscCall(PCSetFromOptions(m_preconditioner));
    PetscCall(PCSetUp(m_preconditioner));
    return 0;
}

PetscErrorCode PetscHierarchy::cycle(std::span<const double> r, std::span<double> z) {
    PetscCall(VecPlaceArray(m_right, r.data()));
    PetscCall(VecPlaceArray(m_solution, z.data()));
    const PetscErrorCode code = PCApply(m_preconditioner, m_right, m_solution);
    PetscCall(VecResetArray(m_right));
    PetscCall(VecResetArray(m_solution));
    return code;
}

}  // namespace
}  // namespace wend

extern "C" __attribute__((visibility("default"))) wend::AlgebraicHierarchy* wendAlgebraicHierarchy() {
    return new wend::PetscHierarchy;
}
