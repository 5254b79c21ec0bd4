#pragma once

// The dense kernels for numbers of type Real, which is defined before this file is included: once for every
// type, since functions that are cloned for several processors may not be templates.

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/factor/dense_kernels.h"
#include "core/system/run_time_dispatch.h"

// 64 bytes: one register with AVX-512, two with AVX2, four with SSE. The compiler's vector extension keeps
// the accumulators in registers where arrays of accumulators would be spilled. No function takes or returns
// one by value: that would depend on the instruction set.
using Lanes = Real __attribute__((vector_size(64), aligned(sizeof(Real)), may_alias));

namespace wend::dense {
namespace {

constexpr int kBlock = 8;  // columns of a block
// Together half a megabyte: what every block of columns reads again.
constexpr int kDepth = 256, kRows = 16 * kPad<Real> * 2;
constexpr int kLanes = kPad<Real>;

const Lanes& at(const Real* p) {
    return *reinterpret_cast<const Lanes*>(p);
}
Lanes& at(Real* p) {
    return *reinterpret_cast<Lanes*>(p);
}

/// C (two registers' rows × columns ≤ 8) −= A Bᵀ with A, B of one leading dimension: 16 accumulators, for 32
/// registers.
[[gnu::always_inline]] inline void tileOfTwo(int columns, int depth, const Real* A, const Real* B,
                                             std::ptrdiff_t leading, Real* C, std::ptrdiff_t leadingC) {
    Lanes p0{}, p1{}, p2{}, p3{}, p4{}, p5{}, p6{}, p7{}, q0{}, q1{}, q2{}, q3{}, q4{}, q5{}, q6{}, q7{};
    for (int k = 0; k < depth; ++k, A += leading, B += leading) {
        const Lanes a = at(A), b = at(A + kLanes);
        p0 += a * B[0], q0 += b * B[0];
        p1 += a * B[1], q1 += b * B[1];
        p2 += a * B[2], q2 += b * B[2];
        p3 += a * B[3], q3 += b * B[3];
        p4 += a * B[4], q4 += b * B[4];
        p5 += a * B[5], q5 += b * B[5];
        p6 += a * B[6], q6 += b * B[6];
        p7 += a * B[7], q7 += b * B[7];
    }
    if (columns > 0) at(C) -= p0, at(C + kLanes) -= q0;
    if (columns > 1) at(C += leadingC) -= p1, at(C + kLanes) -= q1;
    if (columns > 2) at(C += leadingC) -= p2, at(C + kLanes) -= q2;
    if (columns > 3) at(C += leadingC) -= p3, at(C + kLanes) -= q3;
    if (columns > 4) at(C += leadingC) -= p4, at(C + kLanes) -= q4;
    if (columns > 5) at(C += leadingC) -= p5, at(C + kLanes) -= q5;
    if (columns > 6) at(C += leadingC) -= p6, at(C + kLanes) -= q6;
    if (columns > 7) at(C += leadingC) -= p7, at(C + kLanes) -= q7;
}

/// The same, one register's rows × columns ≤ 4: for 16 registers of half the width, and for ends.
[[gnu::always_inline]] inline void tileOfOne(int columns, int depth, const Real* A, const Real* B,
                                             std::ptrdiff_t leading, Real* C, std::ptrdiff_t leadingC) {
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

/// C (rows, a multiple of kLanes, × columns ≤ 8) −= A Bᵀ.
WEND_CLONES void subtractProduct(bool wide, int rows, int columns, int depth, const Real* A, const Real* B,
                                 int leading, Real* C, int leadingC) {
    int r = 0;
    if (wide)
        for (; r + 2 * kLanes <= rows; r += 2 * kLanes)
            tileOfTwo(columns, depth, A + r, B, leading, C + r, leadingC);
    for (; r < rows; r += kLanes) {
        tileOfOne(columns, depth, A + r, B, leading, C + r, leadingC);
        if (columns > 4)
            tileOfOne(columns - 4, depth, A + r, B + 4, leading,
                      C + r + 4 * static_cast<std::ptrdiff_t>(leadingC), leadingC);
    }
}

/// Cholesky factor of the block's diagonal, T lower, and 1 / diagonal; missing columns are the identity's.
bool factorDiagonal(const Real* block, int leading, int columns, Real (&T)[kBlock][kBlock],
                    Real (&inverse)[kBlock]) {
    for (int i = 0; i < kBlock; ++i)
        for (int j = 0; j <= i; ++j)
            T[i][j] = i < columns ? block[j * static_cast<std::ptrdiff_t>(leading) + i] : Real(0);
    for (int j = 0; j < kBlock; ++j) {
        if (j >= columns) {
            inverse[j] = 1;
            continue;
        }
        const Real pivot = T[j][j];
        if (!(pivot > 0) || !std::isfinite(pivot)) return false;
        inverse[j] = 1 / std::sqrt(pivot);
        for (int i = j; i < columns; ++i) T[i][j] *= inverse[j];
        for (int k = j + 1; k < columns; ++k)
            for (int i = k; i < columns; ++i) T[i][k] -= T[i][j] * T[k][j];
    }
    return true;
}

/// Rows of a block of eight columns times T⁻ᵀ, kLanes rows at a time. Missing columns are read as the first.
WEND_CLONES void solveRows(Real* first, int leading, int rows, int columns, const Real (&T)[kBlock][kBlock],
                           const Real (&inverse)[kBlock]) {
    std::ptrdiff_t o[kBlock];
    for (int j = 0; j < kBlock; ++j) o[j] = j < columns ? j * static_cast<std::ptrdiff_t>(leading) : 0;
    for (int r = 0; r < rows; r += kLanes) {
        Real* c = first + r;
        const Lanes x0 = at(c) * inverse[0];
        const Lanes x1 = (at(c + o[1]) - x0 * T[1][0]) * inverse[1];
        const Lanes x2 = (at(c + o[2]) - x0 * T[2][0] - x1 * T[2][1]) * inverse[2];
        const Lanes x3 = (at(c + o[3]) - x0 * T[3][0] - x1 * T[3][1] - x2 * T[3][2]) * inverse[3];
        at(c) = x0;
        if (columns > 1) at(c + o[1]) = x1;
        if (columns > 2) at(c + o[2]) = x2;
        if (columns > 3) at(c + o[3]) = x3;
        if (columns <= 4) continue;
        const Lanes y4 = at(c + o[4]) - x0 * T[4][0] - x1 * T[4][1] - x2 * T[4][2] - x3 * T[4][3];
        const Lanes y5 = at(c + o[5]) - x0 * T[5][0] - x1 * T[5][1] - x2 * T[5][2] - x3 * T[5][3];
        const Lanes y6 = at(c + o[6]) - x0 * T[6][0] - x1 * T[6][1] - x2 * T[6][2] - x3 * T[6][3];
        const Lanes y7 = at(c + o[7]) - x0 * T[7][0] - x1 * T[7][1] - x2 * T[7][2] - x3 * T[7][3];
        const Lanes x4 = y4 * inverse[4];
        const Lanes x5 = (y5 - x4 * T[5][4]) * inverse[5];
        const Lanes x6 = (y6 - x4 * T[6][4] - x5 * T[6][5]) * inverse[6];
        const Lanes x7 = (y7 - x4 * T[7][4] - x5 * T[7][5] - x6 * T[7][6]) * inverse[7];
        at(c + o[4]) = x4;
        if (columns > 5) at(c + o[5]) = x5;
        if (columns > 6) at(c + o[6]) = x6;
        if (columns > 7) at(c + o[7]) = x7;
    }
}

/// Rows of a block of eight columns times −T⁻¹, kLanes rows at a time. Missing columns are read as the first.
WEND_CLONES void divideRows(Real* first, int leading, int rows, int columns, const Real (&T)[kBlock][kBlock],
                            const Real (&inverse)[kBlock]) {
    std::ptrdiff_t o[kBlock];
    for (int j = 0; j < kBlock; ++j) o[j] = j < columns ? j * static_cast<std::ptrdiff_t>(leading) : 0;
    for (int r = 0; r < rows; r += kLanes) {
        Real* c = first + r;
        Lanes y0 = at(c), y1 = at(c + o[1]), y2 = at(c + o[2]), y3 = at(c + o[3]);
        if (columns > 4) {
            const Lanes x7 = at(c + o[7]) * -inverse[7];
            const Lanes x6 = (at(c + o[6]) + x7 * T[7][6]) * -inverse[6];
            const Lanes x5 = (at(c + o[5]) + x7 * T[7][5] + x6 * T[6][5]) * -inverse[5];
            const Lanes x4 = (at(c + o[4]) + x7 * T[7][4] + x6 * T[6][4] + x5 * T[5][4]) * -inverse[4];
            y3 += x7 * T[7][3] + x6 * T[6][3] + (x5 * T[5][3] + x4 * T[4][3]);
            y2 += x7 * T[7][2] + x6 * T[6][2] + (x5 * T[5][2] + x4 * T[4][2]);
            y1 += x7 * T[7][1] + x6 * T[6][1] + (x5 * T[5][1] + x4 * T[4][1]);
            y0 += x7 * T[7][0] + x6 * T[6][0] + (x5 * T[5][0] + x4 * T[4][0]);
            at(c + o[4]) = x4;
            if (columns > 5) at(c + o[5]) = x5;
            if (columns > 6) at(c + o[6]) = x6;
            if (columns > 7) at(c + o[7]) = x7;
        }
        const Lanes x3 = y3 * -inverse[3];
        const Lanes x2 = (y2 + x3 * T[3][2]) * -inverse[2];
        const Lanes x1 = (y1 + x3 * T[3][1] + x2 * T[2][1]) * -inverse[1];
        at(c) = (y0 + x3 * T[3][0] + x2 * T[2][0] + x1 * T[1][0]) * -inverse[0];
        if (columns > 1) at(c + o[1]) = x1;
        if (columns > 2) at(c + o[2]) = x2;
        if (columns > 3) at(c + o[3]) = x3;
    }
}

/// What factorDiagonal() made, from the panel.
void readDiagonal(const Real* block, int leading, int columns, Real (&T)[kBlock][kBlock]) {
    for (int i = 0; i < kBlock; ++i)
        for (int j = 0; j < i; ++j)
            T[i][j] = i < columns ? block[j * static_cast<std::ptrdiff_t>(leading) + i] : Real(0);
}

using Place = std::conditional_t<sizeof(Real) == 4, int, long>;
using Places = Place __attribute__((vector_size(64), may_alias));
alignas(64) constexpr Place kPlaces[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

using Four = Real __attribute__((vector_size(4 * sizeof(Real))));
using FourPlaces = Place __attribute__((vector_size(4 * sizeof(Real))));

/// The lanes added up by fours.
[[gnu::always_inline]] inline void addUp(const Lanes& lanes, Four& sum) {
    Four parts[kLanes / 4];
    __builtin_memcpy(parts, &lanes, sizeof lanes);
    sum = parts[0];
    for (int i = 1; i < kLanes / 4; ++i) sum += parts[i];
}

/// The sums of the lanes of four vectors: added up side by side, since one after another they cost more than
/// the short columns that they are of.
[[gnu::always_inline]] inline void sumsOf(const Lanes& s0, const Lanes& s1, const Lanes& s2, const Lanes& s3,
                                          Real* sums) {
    Four a, b, c, d;
    addUp(s0, a), addUp(s1, b), addUp(s2, c), addUp(s3, d);
    const Four ab = __builtin_shuffle(a, b, FourPlaces{0, 4, 1, 5}) +
                    __builtin_shuffle(a, b, FourPlaces{2, 6, 3, 7}),
               cd = __builtin_shuffle(c, d, FourPlaces{0, 4, 1, 5}) +
                    __builtin_shuffle(c, d, FourPlaces{2, 6, 3, 7});
    const Four all =
        __builtin_shuffle(ab, cd, FourPlaces{0, 1, 4, 5}) + __builtin_shuffle(ab, cd, FourPlaces{2, 3, 6, 7});
    __builtin_memcpy(sums, &all, sizeof all);
}

/// M y of a block, the rows of one register. Missing columns are read as the first, with 0 in y.
template <int kColumns>
[[gnu::always_inline]] inline void timesColumns(const Real* M, const std::ptrdiff_t (&o)[kBlock],
                                                const Real (&y)[kBlock], Lanes& sum) {
    Lanes odd = at(M + o[1]) * y[1];
    sum = at(M) * y[0];
#pragma GCC unroll 4
    for (int j = 2; j < kColumns; j += 2) {
        sum += at(M + o[j]) * y[j];
        odd += at(M + o[j + 1]) * y[j + 1];
    }
    sum += odd;
}

/// A block of a forward solve: in the rows of the block's own M y is x, in those below it is added.
template <int kColumns>
[[gnu::always_inline]] inline void forwardBlock(const Real* block, int leading, int c, int count, int rowEnd,
                                                Real* w, Real* x) {
    std::ptrdiff_t o[kBlock];
    Real y[kBlock], first[kLanes];
    for (int j = 0; j < kColumns; ++j) {
        o[j] = j < count ? j * static_cast<std::ptrdiff_t>(leading) : 0;
        y[j] = j < count ? w[c + j] : Real(0);
    }
    const int top = c & ~(kLanes - 1);
    Lanes sum;
    timesColumns<kColumns>(block + top, o, y, sum);
    __builtin_memcpy(first, &sum, sizeof sum);
    for (int j = 0; j < count; ++j) x[c + j] = first[c - top + j];
    const Places& places = *reinterpret_cast<const Places*>(kPlaces);
    at(w + top) += places >= c - top + count ? sum : Lanes{};
    for (int r = top + kLanes; r < rowEnd; r += kLanes) {
        timesColumns<kColumns>(block + r, o, y, sum);
        at(w + r) += sum;
    }
}

/// Mᵀ w of a block's columns, four at a time for 16 registers of half the width. Missing ones are read as the
/// first.
[[gnu::always_inline]] inline void transposedTimes(const Real* M, int leading, int columns, int rowBegin,
                                                   int rowEnd, const Real* w, Real (&sums)[kBlock]) {
    for (int c = 0; c < columns; c += 4) {
        const Real* const a = M + c * static_cast<std::ptrdiff_t>(leading);
        std::ptrdiff_t o[4];
        for (int j = 0; j < 4; ++j) o[j] = c + j < columns ? j * static_cast<std::ptrdiff_t>(leading) : 0;
        Lanes s0{}, s1{}, s2{}, s3{};
        for (int r = rowBegin; r < rowEnd; r += kLanes) {
            const Lanes y = at(w + r);
            s0 += at(a + r) * y;
            s1 += at(a + o[1] + r) * y;
            s2 += at(a + o[2] + r) * y;
            s3 += at(a + o[3] + r) * y;
        }
        sumsOf(s0, s1, s2, s3, sums + c);
    }
}

}  // namespace

bool factorColumns(Real* panel, int leading, int from, int to, int rowEnd, Real* inverse) {
    const bool wide = wideRegisters();
    Real T[kBlock][kBlock], inverses[kBlock];
    for (int c = from; c < to; c += kBlock) {
        const int count = std::min(kBlock, to - c), top = c & ~(kLanes - 1);
        Real* block = panel + static_cast<std::ptrdiff_t>(c) * leading;
        if (c > 0)
            subtractProduct(wide, rowEnd - top, count, c, panel + top, panel + c, leading, block + top,
                            leading);
        if (!factorDiagonal(block + c, leading, count, T, inverses)) return false;
        solveRows(block + top, leading, rowEnd - top, count, T, inverses);
        for (int j = 0; j < count; ++j) {
            inverse[c + j] = inverses[j];
            std::fill(block + static_cast<std::ptrdiff_t>(j) * leading + top,
                      block + static_cast<std::ptrdiff_t>(j) * leading + c + j, Real(0));
        }
    }
    return true;
}

void continueColumns(Real* panel, int leading, int from, int to, int rowBegin, int rowEnd,
                     const Real* inverse) {
    const bool wide = wideRegisters();
    const int rows = rowEnd - rowBegin;
    Real T[kBlock][kBlock], inverses[kBlock];
    for (int c = from; c < to; c += kBlock) {
        const int count = std::min(kBlock, to - c);
        Real* block = panel + static_cast<std::ptrdiff_t>(c) * leading;
        if (c > 0)
            subtractProduct(wide, rows, count, c, panel + rowBegin, panel + c, leading, block + rowBegin,
                            leading);
        readDiagonal(block + c, leading, count, T);
        for (int j = 0; j < kBlock; ++j) inverses[j] = j < count ? inverse[c + j] : Real(1);
        solveRows(block + rowBegin, leading, rows, count, T, inverses);
    }
}

// By blocks of rows and of the depth, so that what the columns of U share stays in the second-level cache.
void subtractSquare(const Real* below, int leading, int columns, Real* U, int leadingU, int from, int to) {
    const bool wide = wideRegisters();
    for (int k = 0; k < columns; k += kDepth)
        for (int r = from; r < leadingU; r += kRows) {
            const Real* const A = below + static_cast<std::ptrdiff_t>(k) * leading;
            const int rowEnd = std::min(leadingU, r + kRows);
            for (int c = from; c < std::min(to, rowEnd); c += kBlock) {
                const int top = std::max(r, c & ~(kLanes - 1));
                subtractProduct(wide, rowEnd - top, std::min(kBlock, to - c), std::min(kDepth, columns - k),
                                A + top, A + c, leading, U + static_cast<std::ptrdiff_t>(c) * leadingU + top,
                                leadingU);
            }
        }
}

// The rows of the triangle become T⁻¹ like all others: they are minus the identity's before.
void prepareSolves(Real* panel, int leading, int columns, int rowBegin, int rowEnd, const Real* inverse) {
    Real T[kBlock][kBlock], inverses[kBlock];
    for (int c = 0; c < columns; c += kBlock) {
        const int count = std::min(kBlock, columns - c), top = std::max(rowBegin, c & ~(kLanes - 1));
        Real* const block = panel + static_cast<std::ptrdiff_t>(c) * leading;
        readDiagonal(block + c, leading, count, T);
        for (int j = 0; j < kBlock; ++j) inverses[j] = j < count ? inverse[c + j] : Real(1);
        if (rowBegin == 0)
            for (int j = 0; j < count; ++j)
                for (int i = 0; i < count; ++i)
                    block[j * static_cast<std::ptrdiff_t>(leading) + c + i] = i == j ? Real(-1) : Real(0);
        divideRows(block + top, leading, rowEnd - top, count, T, inverses);
    }
}

WEND_CLONES void forward(const Real* panel, int leading, int columns, int rowEnd, Real* w, Real* x) {
    for (int c = 0; c < columns; c += kBlock) {
        const Real* const block = panel + static_cast<std::ptrdiff_t>(c) * leading;
        if (columns - c <= 4)
            forwardBlock<4>(block, leading, c, columns - c, rowEnd, w, x);
        else
            forwardBlock<8>(block, leading, c, std::min(kBlock, columns - c), rowEnd, w, x);
    }
}

WEND_CLONES void continueForward(const Real* panel, int leading, int columns, int rowBegin, int rowEnd,
                                 Real* w) {
    for (int c = 0; c < columns; c += kBlock) {
        std::ptrdiff_t o[kBlock];
        Real y[kBlock];
        for (int j = 0; j < kBlock; ++j) {
            o[j] = c + j < columns ? j * static_cast<std::ptrdiff_t>(leading) : 0;
            y[j] = c + j < columns ? w[c + j] : Real(0);
        }
        const Real* const block = panel + static_cast<std::ptrdiff_t>(c) * leading;
        for (int r = rowBegin; r < rowEnd; r += kLanes) {
            Lanes sum;
            timesColumns<8>(block + r, o, y, sum);
            at(w + r) += sum;
        }
    }
}

WEND_CLONES void prepareBackward(const Real* panel, int leading, int from, int to, int rowBegin,
                                 const Real* w, Real* x) {
    for (int c = from; c < to; c += kBlock) {
        const int count = std::min(kBlock, to - c);
        Real sums[kBlock];
        transposedTimes(panel + static_cast<std::ptrdiff_t>(c) * leading, leading, count, rowBegin, leading,
                        w, sums);
        for (int j = 0; j < count; ++j) x[c + j] += sums[j];
    }
}

WEND_CLONES void backward(const Real* panel, int leading, int columns, int rowEnd, Real* w, Real* x) {
    for (int c = (columns - 1) / kBlock * kBlock; c >= 0; c -= kBlock) {
        const int count = std::min(kBlock, columns - c);
        Real sums[kBlock];
        transposedTimes(panel + static_cast<std::ptrdiff_t>(c) * leading, leading, count, c & ~(kLanes - 1),
                        rowEnd, w, sums);
        for (int j = 0; j < count; ++j) x[c + j] = w[c + j] = x[c + j] + sums[j];
    }
}

}  // namespace wend::dense
