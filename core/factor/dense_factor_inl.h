// This file factorizes panels for one SIMD target. It is included once for every target and therefore has no
// include guard.

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace wend::dense::HWY_NAMESPACE {

// This many columns are factorized from the left among themselves; those before them are subtracted at once.
constexpr int kPanel = 48;
static_assert(kPanel % kBlock == 0);

/// The lower triangle T of a block of columns and 1 / diagonal.
template <class Real>
struct Triangle {
    Real T[kBlock][kBlock], inverse[kBlock];
};

/// Computes the Cholesky factor of the block's diagonal. Returns false at a pivot that is not positive or not
/// finite.
template <class Real>
bool factorDiagonal(const Real* block, ptrdiff_t leading, int columns, Triangle<Real>& triangle) {
    auto& [T, inverse] = triangle;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j <= i; ++j) T[i][j] = block[j * leading + i];
    for (int j = 0; j < columns; ++j) {
        const Real pivot = T[j][j];
        if (!(pivot > 0) || !std::isfinite(pivot)) return false;
        inverse[j] = 1 / std::sqrt(pivot);
        for (int i = j; i < columns; ++i) T[i][j] *= inverse[j];
        for (int k = j + 1; k < columns; ++k)
            for (int i = k; i < columns; ++i) T[i][k] -= T[i][j] * T[k][j];
    }
    return true;
}

/// Reads the triangle that factorDiagonal() has made back from the panel.
template <class Real>
Triangle<Real> readDiagonal(const Real* block, ptrdiff_t leading, int columns, const Real* inverse) {
    Triangle<Real> triangle;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < i; ++j) triangle.T[i][j] = block[j * leading + i];
        triangle.inverse[i] = inverse[i];
    }
    return triangle;
}

/// Computes y −= Σ x_i T(j, i) over the columns i that are already solved.
template <class Real, class V, std::size_t... I>
HWY_INLINE void subtractSolved(std::index_sequence<I...>, [[maybe_unused]] const Real* T,
                               [[maybe_unused]] const V* x, V& y) {
    [[maybe_unused]] const Tag<Real> d;
    ((y = hn::NegMulAdd(x[I], hn::Set(d, T[I]), y)), ...);
}

/// Solves for column kColumn of a vector of rows, and then for the columns after it.
template <int kColumn, int kColumns, class Real, class V>
HWY_INLINE void solveColumn(Real* row, ptrdiff_t leading, const Triangle<Real>& triangle, V (&x)[kColumns]) {
    if constexpr (kColumn < kColumns) {
        const Tag<Real> d;
        V y = hn::LoadU(d, row + kColumn * leading);
        subtractSolved(std::make_index_sequence<kColumn>(), triangle.T[kColumn], x, y);
        x[kColumn] = hn::Mul(y, hn::Set(d, triangle.inverse[kColumn]));
        hn::StoreU(x[kColumn], d, row + kColumn * leading);
        solveColumn<kColumn + 1>(row, leading, triangle, x);
    }
}

/// Multiplies rows of a block of columns by T⁻ᵀ.
template <int kColumns>
struct SolveRows {
    template <class Real>
    static void run(Real* first, ptrdiff_t leading, int rows, const Triangle<Real>* triangle) {
        for (int r = 0; r < rows; r += kLanes<Real>) {
            Vector<Real> x[kColumns];
            solveColumn<0>(first + r, leading, *triangle, x);
        }
    }
};

/// Computes y += Σ x_i T(i, j) over the columns i > j.
template <int kColumn, int kColumns, class Real, class V, std::size_t... I>
HWY_INLINE void addDivided(std::index_sequence<I...>, [[maybe_unused]] const Triangle<Real>& triangle,
                           [[maybe_unused]] const V (&x)[kColumns], V& y) {
    [[maybe_unused]] const Tag<Real> d;
    ((y = hn::MulAdd(x[kColumn + 1 + I], hn::Set(d, triangle.T[kColumn + 1 + I][kColumn]), y)), ...);
}

/// Computes column kColumn of a vector of rows times −T⁻¹, and then the columns before it.
template <int kColumn, int kColumns, class Real, class V>
HWY_INLINE void divideColumn(Real* row, ptrdiff_t leading, const Triangle<Real>& triangle, V (&x)[kColumns]) {
    if constexpr (kColumn >= 0) {
        const Tag<Real> d;
        V y = hn::LoadU(d, row + kColumn * leading);
        addDivided<kColumn>(std::make_index_sequence<kColumns - 1 - kColumn>(), triangle, x, y);
        x[kColumn] = hn::Mul(y, hn::Set(d, -triangle.inverse[kColumn]));
        hn::StoreU(x[kColumn], d, row + kColumn * leading);
        divideColumn<kColumn - 1>(row, leading, triangle, x);
    }
}

/// Multiplies rows of a block of columns by −T⁻¹.
template <int kColumns>
struct DivideRows {
    template <class Real>
    static void run(Real* first, ptrdiff_t leading, int rows, const Triangle<Real>* triangle) {
        for (int r = 0; r < rows; r += kLanes<Real>) {
            Vector<Real> x[kColumns];
            divideColumn<kColumns - 1>(first + r, leading, *triangle, x);
        }
    }
};

/// Factorizes the columns [from, to) of a panel, at most kPanel, in the rows up to `rowEnd`. Those before
/// `from` have been subtracted.
template <class Real>
bool factorNarrow(Real* panel, ptrdiff_t leading, int from, int to, int rowEnd, Real* inverse) {
    Triangle<Real> triangle;
    for (int c = from; c < to; c += kBlock) {
        const int count = std::min(kBlock, to - c), top = c & ~(kPad<Real> - 1);
        Real* const block = panel + c * leading;
        Product<Real>{panel + from * leading, leading, c - from, panel, leading, c, c + count, 0, rowEnd}
            .subtract();
        if (!factorDiagonal(block + c, leading, count, triangle)) return false;
        ofWidth<SolveRows>(count, block + top, leading, rowEnd - top, &triangle);
        for (int j = 0; j < count; ++j) {
            inverse[c + j] = triangle.inverse[j];
            std::fill(block + j * leading + top, block + j * leading + c + j, Real(0));
        }
    }
    return true;
}

/// Implements Kernels::factorColumns.
template <class Real>
bool factorColumns(Real* panel, int leading, int from, int to, int rowEnd, Real* inverse) {
    for (int c = from; c < to; c += kPanel) {
        const int end = std::min(to, c + kPanel);
        Product<Real>{panel, leading, c, panel, leading, c, end, 0, rowEnd}.subtract();
        if (!factorNarrow<Real>(panel, leading, c, end, rowEnd, inverse)) return false;
    }
    return true;
}

/// Continues the columns [from, to) of a panel, at most kPanel, in the rows below. Those before `from` have
/// been subtracted.
template <class Real>
void continueNarrow(Real* panel, ptrdiff_t leading, int from, int to, int rowBegin, int rowEnd,
                    const Real* inverse) {
    for (int c = from; c < to; c += kBlock) {
        const int count = std::min(kBlock, to - c);
        Real* const block = panel + c * leading;
        Product<Real>{
            panel + from * leading, leading, c - from, panel, leading, c, c + count, rowBegin, rowEnd}
            .subtract();
        const Triangle<Real> triangle = readDiagonal(block + c, leading, count, inverse + c);
        ofWidth<SolveRows>(count, block + rowBegin, leading, rowEnd - rowBegin, &triangle);
    }
}

/// Implements Kernels::continueColumns.
template <class Real>
void continueColumns(Real* panel, int leading, int from, int to, int rowBegin, int rowEnd,
                     const Real* inverse) {
    for (int c = from; c < to; c += kPanel) {
        const int end = std::min(to, c + kPanel);
        Product<Real>{panel, leading, c, panel, leading, c, end, rowBegin, rowEnd}.subtract();
        continueNarrow<Real>(panel, leading, c, end, rowBegin, rowEnd, inverse);
    }
}

/// Implements Kernels::squareNegated.
template <class Real>
void squareNegated(const Real* below, int leading, int columns, Real* U, int leadingU, int from, int to) {
    Product<Real>{below, leading, columns, U, leadingU, from, to, 0, leadingU, true}.subtract();
}

// Implements Kernels::prepareSolves. The rows of the triangle become T⁻¹ like all others, because they are
// set to minus the identity first.
template <class Real>
void prepareSolves(Real* panel, int leading, int columns, int rowBegin, int rowEnd, const Real* inverse) {
    for (int c = 0; c < columns; c += kBlock) {
        const int count = std::min(kBlock, columns - c), top = std::max(rowBegin, c & ~(kPad<Real> - 1));
        Real* const block = panel + c * static_cast<ptrdiff_t>(leading);
        const Triangle<Real> triangle =
            readDiagonal(block + c, static_cast<ptrdiff_t>(leading), count, inverse + c);
        if (rowBegin == 0)
            for (int j = 0; j < count; ++j)
                for (int i = 0; i < count; ++i)
                    block[j * static_cast<ptrdiff_t>(leading) + c + i] = i == j ? Real(-1) : Real(0);
        ofWidth<DivideRows>(count, block + top, static_cast<ptrdiff_t>(leading), rowEnd - top, &triangle);
    }
}

}  // namespace wend::dense::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
