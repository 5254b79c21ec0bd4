#pragma once

#include <algorithm>
#include <vector>

#include "core/base/types.h"
#include "core/solver/multigrid/block_product.h"

namespace wend {

/// Rows of a symmetric matrix of square blocks in single precision, with all columns of each row. The first
/// rows() columns are those of its own rows; others follow if the matrix is part of a larger one.
template <int Size>
class BlockRows {
  public:
    using Block = Eigen::Matrix<float, Size, Size>;

    /// Sets the pattern; the columns of a row ascend. The values are not set.
    void setPattern(std::vector<int> start, std::vector<int> column, int columns) {
        m_start = std::move(start);
        m_column = std::move(column);
        m_columns = columns;
        m_values = {};
        m_values.resize(m_column.size() * Size * Size + kPadding);
    }

    int rows() const { return static_cast<int>(m_start.size()) - 1; }
    int columns() const { return m_columns; }
    /// Returns the first entry of a row, whose entries are [begin(row), begin(row + 1)).
    int begin(int row) const { return m_start[row]; }
    int column(int entry) const { return m_column[entry]; }
    Eigen::Map<const Block> block(int entry) const {
        return Eigen::Map<const Block>(m_values.data() + static_cast<std::size_t>(entry) * Size * Size);
    }
    Eigen::Map<Block> block(int entry) {
        return Eigen::Map<Block>(m_values.data() + static_cast<std::size_t>(entry) * Size * Size);
    }
    /// Returns the entry of a column that a row has. By binary search; a column that the row does not have
    /// gives another entry.
    int entryOf(int row, int column) const {
        const auto first = m_column.begin() + m_start[row], last = m_column.begin() + m_start[row + 1];
        return static_cast<int>(std::lower_bound(first, last, column) - m_column.begin());
    }

    /// Computes A x in the rows [begin, end), Size numbers each. Sums are in double precision.
    void multiply(const Points<Size>& x, int begin, int end, double* Ax) const {
        multiplyBlocks<Size>(m_start.data(), m_column.data(), m_values.data(), x.data(), begin, end, Ax);
    }

  private:
    static constexpr std::size_t kPadding = 4;  // read by the kernels

    std::vector<int> m_start{0}, m_column;
    std::vector<float> m_values;
    int m_columns = 0;
};

}  // namespace wend
