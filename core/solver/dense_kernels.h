#pragma once

namespace wend::dense {

/// Dense kernels of the supernodal factor. A panel holds the columns of a supernode: column-major, the
/// leading dimension (rows, those at the end padding) a multiple of kPad, 64-byte aligned. Kernels work on
/// whole groups of kPad rows and may read up to kSlack numbers behind a panel, and write garbage above the
/// diagonal and into padding that stays within a panel.
template <class Real>
inline constexpr int kPad = 64 / sizeof(Real);
inline constexpr int kSlack = 8192;

/// [L11; L21] from [A11; A21] in place, A11 columns × columns: left-looking by blocks of columns. `inverse`
/// gets 1 / diagonal. False at a pivot that is not positive. Zero above the diagonal afterwards.
bool factorPanel(float* panel, int leading, int columns, float* inverse);

/// The lower triangle of U −= L21 L21ᵀ: `rows` = order of U, `below` = first row of L21 in its panel.
void subtractSquare(const float* below, int leading, int columns, float* U, int leadingU, int rows);

/// w = [b1; 0] → x1 = L11⁻¹ b1 and w2 = −L21 x1; w has `leading` entries, w1 is lost.
void forward(const float* panel, int leading, int columns, const float* inverse, float* w, float* x);

/// x1 = L11⁻ᵀ (x1 − L21ᵀ w2) for w = [0; w2]; w1 becomes x1.
void backward(const float* panel, int leading, int columns, const float* inverse, float* w, float* x);

// The same in double precision.
bool factorPanel(double* panel, int leading, int columns, double* inverse);
void subtractSquare(const double* below, int leading, int columns, double* U, int leadingU, int rows);
void forward(const double* panel, int leading, int columns, const double* inverse, double* w, double* x);
void backward(const double* panel, int leading, int columns, const double* inverse, double* w, double* x);

}  // namespace wend::dense
