#pragma once

namespace wend::dense {

/// Dense kernels of the supernodal factor. A panel holds the columns of a supernode: column-major, the
/// leading dimension (rows, those at the end padding) a multiple of kPad, 64-byte aligned. Kernels work on
/// whole groups of kPad rows, may read up to kPad numbers behind a panel, and write garbage above the
/// diagonal and into padding. Pieces of one panel or square, of whole groups of kPad, may be done by several
/// threads.
template <class Real>
inline constexpr int kPad = 64 / sizeof(Real);

/// Up to whole groups of them.
template <class Real>
constexpr int padded(int rows) {
    return (rows + kPad<Real> - 1) / kPad<Real> * kPad<Real>;
}

/// Of [L11; L21] from [A11; A21] in place: columns [from, to), when those before are done, in their rows
/// below the diagonal up to `rowEnd`. `inverse` gets 1 / diagonal. False at a pivot that is not positive.
/// Zero above the diagonal afterwards.
bool factorColumns(float* panel, int leading, int from, int to, int rowEnd, float* inverse);

/// The same columns in the rows [rowBegin, rowEnd) below those that factorColumns() did.
void continueColumns(float* panel, int leading, int from, int to, int rowBegin, int rowEnd,
                     const float* inverse);

/// Columns [from, to) of the lower triangle of U −= L21 L21ᵀ; `below` is the first row of L21 in its panel,
/// `from` a multiple of kPad.
void subtractSquare(const float* below, int leading, int columns, float* U, int leadingU, int from, int to);

/// What the solves take in place of such columns, in the rows [rowBegin, rowEnd): per block of columns with
/// the triangle T on the diagonal and B below it, M = [T⁻¹; −B T⁻¹]. A block is then one product with a
/// vector each way, where solving for one column after another waits for every result. `rowBegin` is 0, or
/// not within the triangle: the rows that hold it come last, since all others read it.
void prepareSolves(float* panel, int leading, int columns, int rowBegin, int rowEnd, const float* inverse);

/// w = [b1; 0] → x1 = L11⁻¹ b1 and w2 = −L21 x1 in the rows up to `rowEnd`; in w1 remains what
/// continueForward() multiplies with.
void forward(const float* panel, int leading, int columns, int rowEnd, float* w, float* x);
/// The same in the rows [rowBegin, rowEnd) below.
void continueForward(const float* panel, int leading, int columns, int rowBegin, int rowEnd, float* w);

/// x1 += L11⁻ᵀ (w1 − L21ᵀ w2) with the rows up to `rowEnd`; w1 becomes x1.
void backward(const float* panel, int leading, int columns, int rowEnd, float* w, float* x);
/// Before it, with the rows from `rowBegin` on: their part of the sum in the columns [from, to), to x.
void prepareBackward(const float* panel, int leading, int from, int to, int rowBegin, const float* w,
                     float* x);

// The same in double precision.
bool factorColumns(double* panel, int leading, int from, int to, int rowEnd, double* inverse);
void continueColumns(double* panel, int leading, int from, int to, int rowBegin, int rowEnd,
                     const double* inverse);
void subtractSquare(const double* below, int leading, int columns, double* U, int leadingU, int from, int to);
void prepareSolves(double* panel, int leading, int columns, int rowBegin, int rowEnd, const double* inverse);
void forward(const double* panel, int leading, int columns, int rowEnd, double* w, double* x);
void continueForward(const double* panel, int leading, int columns, int rowBegin, int rowEnd, double* w);
void backward(const double* panel, int leading, int columns, int rowEnd, double* w, double* x);
void prepareBackward(const double* panel, int leading, int from, int to, int rowBegin, const double* w,
                     double* x);

}  // namespace wend::dense
