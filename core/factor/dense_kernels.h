#pragma once

namespace wend::dense {

/// The number of rows in a group. A panel holds the columns of a supernode, column-major and 64-byte aligned;
/// its leading dimension is a multiple of kPad, and the rows at its end are padding.
template <class Real>
inline constexpr int kPad = 64 / sizeof(Real);

/// Returns the number of rows, rounded up to a multiple of kPad.
template <class Real>
constexpr int padded(int rows) {
    return (rows + kPad<Real> - 1) / kPad<Real> * kPad<Real>;
}

/// Points to the dense kernels of the supernodal factor for one SIMD target. They work on whole groups of
/// kPad rows, may read up to kPad numbers behind a panel, and write garbage above the diagonal and into
/// padding. Pieces of one panel or square, of whole groups of kPad rows, may be computed by several threads.
/// How columns are grouped into blocks differs between targets, so a panel is solved with the kernels that
/// factorized it.
template <class Real>
struct Kernels {
    /// Factorizes [A11; A21] into [L11; L21] in place: the columns [from, to), once those before are done,
    /// from the diagonal down to the row `rowEnd`. `inverse` gets 1 / diagonal. Returns false at a pivot that
    /// is not positive. Writes zeros above the diagonal within its group of kPad rows; groups before that are
    /// not read.
    bool (*factorColumns)(Real* panel, int leading, int from, int to, int rowEnd, Real* inverse);
    /// Continues the same columns in the rows [rowBegin, rowEnd) below those that factorColumns() did.
    void (*continueColumns)(Real* panel, int leading, int from, int to, int rowBegin, int rowEnd,
                            const Real* inverse);
    /// Computes the columns [from, to) of the lower triangle of U = −L21 L21ᵀ; `below` is the first row of
    /// L21 in its panel, `from` a multiple of kPad. L21 must have at least one column.
    void (*squareNegated)(const Real* below, int leading, int columns, Real* U, int leadingU, int from,
                          int to);
    /// Replaces factorized columns by what the solves use, in the rows [rowBegin, rowEnd): per block of
    /// columns with the triangle T on the diagonal and B below it, M = [T⁻¹; −B T⁻¹]. A block then takes one
    /// matrix-vector product in each direction, whereas solving for one column after another would wait for
    /// every result. `rowBegin` is 0 or below the triangle; the rows that hold the triangle come last, since
    /// all others read it.
    void (*prepareSolves)(Real* panel, int leading, int columns, int rowBegin, int rowEnd,
                          const Real* inverse);
    /// Solves forward: turns w = [b1; 0] into x1 = L11⁻¹ b1 and w2 = −L21 x1 in the rows up to `rowEnd`. w1
    /// keeps the numbers that continueForward() multiplies with.
    void (*forward)(const Real* panel, int leading, int columns, int rowEnd, Real* w, Real* x);
    /// Does the same in the rows [rowBegin, rowEnd) below.
    void (*continueForward)(const Real* panel, int leading, int columns, int rowBegin, int rowEnd, Real* w);
    /// Solves backward: x1 += L11⁻ᵀ (w1 − L21ᵀ w2) with the rows up to `rowEnd`; w1 becomes x1.
    void (*backward)(const Real* panel, int leading, int columns, int rowEnd, Real* w, Real* x);
    /// Precedes backward() for the rows from `rowBegin` on: adds their part of the sum in the columns [from,
    /// to) to x. `from` is a multiple of kSolveColumns. The panel (leading × columns, column-major) is one
    /// that prepareSolves() has finished, so that the sum is Mᵀ w and its sign is right; w has `leading`
    /// numbers, and x one for each column. Pieces of columns may be done by several threads, since each
    /// writes its own numbers of x.
    void (*prepareBackward)(const Real* panel, int leading, int from, int to, int rowBegin, const Real* w,
                            Real* x);
};

/// A multiple of the number of columns of a block, on every target.
inline constexpr int kSolveColumns = 24;

/// Returns the kernels of the SIMD target in use.
template <class Real>
const Kernels<Real>& kernels();

template <>
const Kernels<float>& kernels();
template <>
const Kernels<double>& kernels();

}  // namespace wend::dense
