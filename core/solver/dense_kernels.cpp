#include "core/solver/dense_kernels.h"

#include <algorithm>
#include <cmath>

#include "core/assembly/run_time_dispatch.h"

// Sixteen floats: one register with AVX-512, two with AVX2, four with SSE. The compiler's vector extension
// keeps the accumulators in registers where arrays of accumulators would be spilled. No function takes or
// returns one by value: that would depend on the instruction set.
using Lanes = float __attribute__((vector_size(64), aligned(4), may_alias));

namespace wend::dense {
namespace {

constexpr int kBlock = 8;  // columns of a block

const Lanes& at(const float* p) {
    return *reinterpret_cast<const Lanes*>(p);
}
Lanes& at(float* p) {
    return *reinterpret_cast<Lanes*>(p);
}

/// C (32 × columns ≤ 8) −= A Bᵀ with A, B of one leading dimension: 16 accumulators, for 32 registers.
[[gnu::always_inline]] inline void tile32(int columns, int depth, const float* A, const float* B,
                                          std::ptrdiff_t leading, float* C, std::ptrdiff_t leadingC) {
    Lanes p0{}, p1{}, p2{}, p3{}, p4{}, p5{}, p6{}, p7{}, q0{}, q1{}, q2{}, q3{}, q4{}, q5{}, q6{}, q7{};
    for (int k = 0; k < depth; ++k, A += leading, B += leading) {
        const Lanes a = at(A), b = at(A + 16);
        p0 += a * B[0], q0 += b * B[0];
        p1 += a * B[1], q1 += b * B[1];
        p2 += a * B[2], q2 += b * B[2];
        p3 += a * B[3], q3 += b * B[3];
        p4 += a * B[4], q4 += b * B[4];
        p5 += a * B[5], q5 += b * B[5];
        p6 += a * B[6], q6 += b * B[6];
        p7 += a * B[7], q7 += b * B[7];
    }
    if (columns > 0) at(C) -= p0, at(C + 16) -= q0;
    if (columns > 1) at(C += leadingC) -= p1, at(C + 16) -= q1;
    if (columns > 2) at(C += leadingC) -= p2, at(C + 16) -= q2;
    if (columns > 3) at(C += leadingC) -= p3, at(C + 16) -= q3;
    if (columns > 4) at(C += leadingC) -= p4, at(C + 16) -= q4;
    if (columns > 5) at(C += leadingC) -= p5, at(C + 16) -= q5;
    if (columns > 6) at(C += leadingC) -= p6, at(C + 16) -= q6;
    if (columns > 7) at(C += leadingC) -= p7, at(C + 16) -= q7;
}

/// The same, 16 × columns ≤ 4: for 16 registers of half the width, and for ends.
[[gnu::always_inline]] inline void tile16(int columns, int depth, const float* A, const float* B,
                                          std::ptrdiff_t leading, float* C, std::ptrdiff_t leadingC) {
    Lanes p0{}, p1{}, p2{}, p3{};
    for (int k = 0; k < depth; ++k, A += leading, B += leading) {
        const Lanes a = at(A);
        p0 += a * B[0];
        p1 += a * B[1];
        p2 += a * B[2];
        p3 += a * B[3];
    }
    if (columns > 0) at(C) -= p0;
    if (columns > 1) at(C += leadingC) -= p1;
    if (columns > 2) at(C += leadingC) -= p2;
    if (columns > 3) at(C += leadingC) -= p3;
}

bool wideRegisters() {
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool wide = __builtin_cpu_supports("avx512f") != 0;
    return wide;
#else
    return false;
#endif
}

/// C (rows, a multiple of 16, × columns ≤ 8) −= A Bᵀ.
WEND_CLONES void subtractProduct(bool wide, int rows, int columns, int depth, const float* A, const float* B,
                                 int leading, float* C, int leadingC) {
    int r = 0;
    if (wide)
        for (; r + 32 <= rows; r += 32) tile32(columns, depth, A + r, B, leading, C + r, leadingC);
    for (; r < rows; r += 16) {
        tile16(columns, depth, A + r, B, leading, C + r, leadingC);
        if (columns > 4)
            tile16(columns - 4, depth, A + r, B + 4, leading,
                   C + r + 4 * static_cast<std::ptrdiff_t>(leadingC), leadingC);
    }
}

/// Cholesky factor of the block's diagonal, T lower, and 1 / diagonal; missing columns are the identity's.
bool factorDiagonal(const float* block, int leading, int columns, float (&T)[kBlock][kBlock],
                    float (&inverse)[kBlock]) {
    for (int i = 0; i < kBlock; ++i)
        for (int j = 0; j <= i; ++j)
            T[i][j] = i < columns ? block[j * static_cast<std::ptrdiff_t>(leading) + i] : 0.0F;
    for (int j = 0; j < kBlock; ++j) {
        if (j >= columns) {
            inverse[j] = 1;
            continue;
        }
        const float pivot = T[j][j];
        if (!(pivot > 0) || !std::isfinite(pivot)) return false;
        inverse[j] = 1 / std::sqrt(pivot);
        for (int i = j; i < columns; ++i) T[i][j] *= inverse[j];
        for (int k = j + 1; k < columns; ++k)
            for (int i = k; i < columns; ++i) T[i][k] -= T[i][j] * T[k][j];
    }
    return true;
}

/// Rows of a block of eight columns times T⁻ᵀ, sixteen rows at a time.
WEND_CLONES void solveRows(float* first, int leading, int rows, int columns, const float (&T)[kBlock][kBlock],
                           const float (&inverse)[kBlock]) {
    const std::ptrdiff_t n = leading;
    for (int r = 0; r < rows; r += 16) {
        float* c = first + r;
        const Lanes x0 = at(c) * inverse[0];
        const Lanes x1 = (at(c + n) - x0 * T[1][0]) * inverse[1];
        const Lanes x2 = (at(c + 2 * n) - x0 * T[2][0] - x1 * T[2][1]) * inverse[2];
        const Lanes x3 = (at(c + 3 * n) - x0 * T[3][0] - x1 * T[3][1] - x2 * T[3][2]) * inverse[3];
        at(c) = x0;
        if (columns > 1) at(c + n) = x1;
        if (columns > 2) at(c + 2 * n) = x2;
        if (columns > 3) at(c + 3 * n) = x3;
        if (columns <= 4) continue;
        const Lanes y4 = at(c + 4 * n) - x0 * T[4][0] - x1 * T[4][1] - x2 * T[4][2] - x3 * T[4][3];
        const Lanes y5 = at(c + 5 * n) - x0 * T[5][0] - x1 * T[5][1] - x2 * T[5][2] - x3 * T[5][3];
        const Lanes y6 = at(c + 6 * n) - x0 * T[6][0] - x1 * T[6][1] - x2 * T[6][2] - x3 * T[6][3];
        const Lanes y7 = at(c + 7 * n) - x0 * T[7][0] - x1 * T[7][1] - x2 * T[7][2] - x3 * T[7][3];
        const Lanes x4 = y4 * inverse[4];
        const Lanes x5 = (y5 - x4 * T[5][4]) * inverse[5];
        const Lanes x6 = (y6 - x4 * T[6][4] - x5 * T[6][5]) * inverse[6];
        const Lanes x7 = (y7 - x4 * T[7][4] - x5 * T[7][5] - x6 * T[7][6]) * inverse[7];
        at(c + 4 * n) = x4;
        if (columns > 5) at(c + 5 * n) = x5;
        if (columns > 6) at(c + 6 * n) = x6;
        if (columns > 7) at(c + 7 * n) = x7;
    }
}

float sumOf(const Lanes& lanes) {
    float half[8], quarter[4];
    for (int i = 0; i < 8; ++i) half[i] = lanes[i] + lanes[i + 8];
    for (int i = 0; i < 4; ++i) quarter[i] = half[i] + half[i + 4];
    return (quarter[0] + quarter[2]) + (quarter[1] + quarter[3]);
}

}  // namespace

bool factorPanel(float* panel, int leading, int columns, float* inverse) {
    const bool wide = wideRegisters();
    float T[kBlock][kBlock], inverses[kBlock];
    for (int c = 0; c < columns; c += kBlock) {
        const int count = std::min(kBlock, columns - c), top = c & ~(kPad - 1);
        float* block = panel + static_cast<std::ptrdiff_t>(c) * leading;
        if (c > 0)
            subtractProduct(wide, leading - top, count, c, panel + top, panel + c, leading, block + top,
                            leading);
        if (!factorDiagonal(block + c, leading, count, T, inverses)) return false;
        solveRows(block + top, leading, leading - top, count, T, inverses);
        for (int j = 0; j < count; ++j) {
            inverse[c + j] = inverses[j];
            std::fill(block + static_cast<std::ptrdiff_t>(j) * leading + top,
                      block + static_cast<std::ptrdiff_t>(j) * leading + c + j, 0.0F);
        }
    }
    return true;
}

void subtractSquare(const float* below, int leading, int columns, float* U, int leadingU, int rows) {
    const bool wide = wideRegisters();
    for (int c = 0; c < rows; c += kBlock) {
        const int top = c & ~(kPad - 1);
        subtractProduct(wide, leadingU - top, std::min(kBlock, rows - c), columns, below + top, below + c,
                        leading, U + static_cast<std::ptrdiff_t>(c) * leadingU + top, leadingU);
    }
}

WEND_CLONES void forward(const float* panel, int leading, int columns, const float* inverse, float* w,
                         float* x) {
    const std::ptrdiff_t n = leading;
    int c = 0;
    for (; c + 4 <= columns; c += 4) {
        const float* const a = panel + c * n;
        const float x0 = w[c] * inverse[c];
        const float x1 = (w[c + 1] - a[c + 1] * x0) * inverse[c + 1];
        const float x2 = (w[c + 2] - a[c + 2] * x0 - a[n + c + 2] * x1) * inverse[c + 2];
        const float x3 =
            (w[c + 3] - a[c + 3] * x0 - a[n + c + 3] * x1 - a[2 * n + c + 3] * x2) * inverse[c + 3];
        x[c] = x0, x[c + 1] = x1, x[c + 2] = x2, x[c + 3] = x3;
        for (int r = (c + 4) & ~(kPad - 1); r < leading; r += kPad)
            at(w + r) -=
                at(a + r) * x0 + at(a + n + r) * x1 + (at(a + 2 * n + r) * x2 + at(a + 3 * n + r) * x3);
    }
    for (; c < columns; ++c) {
        const float* const a = panel + c * n;
        x[c] = w[c] * inverse[c];
        for (int r = (c + 1) & ~(kPad - 1); r < leading; r += kPad) at(w + r) -= at(a + r) * x[c];
    }
}

WEND_CLONES void backward(const float* panel, int leading, int columns, const float* inverse, float* w,
                          float* x) {
    const std::ptrdiff_t n = leading;
    int c = columns;
    for (; c % 4 != 0; --c) {
        const float* const a = panel + (c - 1) * n;
        Lanes s{};
        for (int r = (c - 1) & ~(kPad - 1); r < leading; r += kPad) s += at(a + r) * at(w + r);
        x[c - 1] = w[c - 1] = (x[c - 1] - sumOf(s)) * inverse[c - 1];
    }
    for (c -= 4; c >= 0; c -= 4) {
        const float* const a = panel + c * n;
        Lanes s0{}, s1{}, s2{}, s3{};
        for (int r = c & ~(kPad - 1); r < leading; r += kPad) {
            const Lanes y = at(w + r);
            s0 += at(a + r) * y;
            s1 += at(a + n + r) * y;
            s2 += at(a + 2 * n + r) * y;
            s3 += at(a + 3 * n + r) * y;
        }
        const float x3 = (x[c + 3] - sumOf(s3)) * inverse[c + 3];
        const float x2 = (x[c + 2] - sumOf(s2) - a[2 * n + c + 3] * x3) * inverse[c + 2];
        const float x1 = (x[c + 1] - sumOf(s1) - a[n + c + 2] * x2 - a[n + c + 3] * x3) * inverse[c + 1];
        const float x0 = (x[c] - sumOf(s0) - a[c + 1] * x1 - a[c + 2] * x2 - a[c + 3] * x3) * inverse[c];
        x[c] = w[c] = x0, x[c + 1] = w[c + 1] = x1, x[c + 2] = w[c + 2] = x2, x[c + 3] = w[c + 3] = x3;
    }
}

}  // namespace wend::dense
