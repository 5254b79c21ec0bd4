#pragma once

#include <span>

namespace wend {

/// A contribution to a block of A: two corners of one cell, or of the two cells of an interior facet. `term`
/// is the number of the cell, or the number of cells plus that of the facet.
struct Contribution {
    int left, right, term;
};

/// Computes blocks of A at one shape, for rows that the caller chooses. Any number of threads may use it at a
/// time.
class BlockSource {
  public:
    virtual ~BlockSource() = default;

    /// Computes block i as the sum of the contributions [start[i], start[i + 1]) in their order. Every block
    /// has Dim × Dim numbers, column-major, and follows the one before it.
    virtual void compute(std::span<const int> start, const Contribution* contributions,
                         double* values) const = 0;
};

}  // namespace wend
