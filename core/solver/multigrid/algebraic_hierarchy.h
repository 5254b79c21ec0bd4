#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace wend {

/// A symmetric positive definite matrix of square blocks: all block rows, columns ascending, blocks
/// column-major.
struct BlockMatrix {
    int blockSize = 0;
    std::vector<int> start, column;  // per block row; per block
    std::vector<double> values;

    int rows() const { return static_cast<int>(start.size()) - 1; }
    std::size_t blockEntries() const {
        return static_cast<std::size_t>(blockSize) * static_cast<std::size_t>(blockSize);
    }
};

/// Algebraic multigrid for a BlockMatrix: the levels, and their V-cycle as z = B r with B symmetric positive
/// definite. One thread uses it at a time; it repeats to the bit.
class AlgebraicHierarchy {
  public:
    virtual ~AlgebraicHierarchy() = default;

    /// Builds all levels, those of an earlier matrix are gone. `nearNullSpace` has `vectors` vectors of
    /// blockSize · rows entries each, one after the other: what the energy hardly sees. Returns an empty
    /// text, or what went wrong.
    virtual std::string build(const BlockMatrix& matrix, std::span<const double> nearNullSpace,
                              int vectors) = 0;
    /// z = B r; false if that failed or is not finite.
    virtual bool apply(std::span<const double> r, std::span<double> z) = 0;
};

/// The module beside the program that has PETSc: wend-multigrid.so. Loaded at the first call. Throws
/// InputError where it is missing or does not load.
std::unique_ptr<AlgebraicHierarchy> makeAlgebraicHierarchy();

/// Whether that module is there and loads.
bool hasAlgebraicHierarchy();

}  // namespace wend
