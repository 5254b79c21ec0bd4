#pragma once

#include <span>

namespace wend {

/// One contribution to a block of A: two corners of a cell, or of the two cells of an interior facet. `term`
/// is the cell, or the number of cells plus the facet.
struct Contribution {
    int left, right, term;
};

/// The blocks of A at one shape, for rows of the caller's choice. Any number of threads use it at a time.
class BlockSource {
  public:
    virtual ~BlockSource() = default;

    /// Block i is the sum of the contributions [start[i], start[i + 1]) in their order: Dim × Dim numbers,
    /// column-major, one block after the other.
    virtual void compute(std::span<const int> start, const Contribution* contributions,
                         double* values) const = 0;
};

}  // namespace wend
