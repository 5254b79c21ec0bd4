#include "core/solver/rotation_kernels.h"

#include <cstddef>

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/solver/rotation_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/assembly/rows_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend::rotations {
namespace HWY_NAMESPACE {
namespace {

using namespace wend::HWY_NAMESPACE;

constexpr int kNewtonSteps = 6;

HWY_INLINE V set(double value) {
    return hn::Set(D(), value);
}

/// A matrix of space: eight of its numbers, and the last one.
struct Matrix {
    Row<4> first, second;
    double last;
};
HWY_INLINE Matrix loadMatrix(const double* p) {
    return {loadRow<4>(p), loadRow<4>(p + 4), p[8]};
}
HWY_INLINE Matrix operator+(const Matrix& a, const Matrix& b) {
    return {a.first + b.first, a.second + b.second, a.last + b.last};
}
HWY_INLINE Matrix scaled(const Matrix& a, double factor) {
    return {a.first * factor, a.second * factor, a.last * factor};
}
HWY_INLINE void storeMatrix(const Matrix& a, double* p) {
    storeRow(a.first, p), storeRow(a.second, p + 4);
    p[8] = a.last;
}

/// Computes the cofactors of R, and returns its determinant.
HWY_INLINE V cofactors(const V (&R)[9], V (&C)[9]) {
#pragma GCC unroll 9
    for (int k = 0; k < 9; ++k) {
        const int c = k / 3, r = k % 3, c1 = 3 * ((c + 1) % 3), c2 = 3 * ((c + 2) % 3), r1 = (r + 1) % 3,
                  r2 = (r + 2) % 3;
        C[k] = R[c1 + r1] * R[c2 + r2] - R[c1 + r2] * R[c2 + r1];
    }
    return hn::MulAdd(R[0], C[0], hn::MulAdd(R[1], C[1], R[2] * C[2]));
}

HWY_INLINE V squaredNorm(const V (&A)[9]) {
    V sum = A[0] * A[0];
#pragma GCC unroll 8
    for (int k = 1; k < 9; ++k) sum = hn::MulAdd(A[k], A[k], sum);
    return sum;
}

/// Loads the matrices of kLanes vertices from p on side by side; storeMatrices() reverses that.
HWY_INLINE void loadMatrices(const double* p, V (&A)[9]) {
    V again[3];
    loadLanes(p, 9, A[0], A[1], A[2], A[3]);
    loadLanes(p + 4, 9, A[4], A[5], A[6], A[7]);
    loadLanes(p + 5, 9, again[0], again[1], again[2], A[8]);
}
HWY_INLINE void storeMatrices(const V (&A)[9], double* p) {
    storeLanes(A[0], A[1], A[2], A[3], p, 9);
    storeLanes(A[4], A[5], A[6], A[7], p + 4, 9);
    storeLanes(A[5], A[6], A[7], A[8], p + 5, 9);
}

}  // namespace

/// Computes a = Σ d₀ e₀ + d₁ e₁ and b = Σ d₁ e₀ − d₀ e₁ with d = y_j − y and e = x_j − x.
void edgeSumsInPlane(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums) {
    for (int v = begin; v < end; ++v) {
        const Row<2> x0 = loadRow<2>(x + 2 * static_cast<std::ptrdiff_t>(v)),
                     y0 = loadRow<2>(y + 2 * static_cast<std::ptrdiff_t>(v));
        Row<2> straight = zeroRow<2>(), crossed = straight;
        for (int i = edges.start[v]; i < edges.start[v + 1]; ++i) {
            const std::ptrdiff_t j = 2 * static_cast<std::ptrdiff_t>(edges.list[i]);
            const Row<2> e = loadRow<2>(x + j) - x0, d = loadRow<2>(y + j) - y0;
            straight = addProducts(straight, d, e);
            crossed = addProducts(crossed, reversed(d), e);
        }
        HWY_ALIGN double s[2], c[2];
        storeRow(straight, s), storeRow(crossed, c);
        sums[2 * v] = s[0] + s[1], sums[2 * v + 1] = c[0] - c[1];
    }
}

/// Computes Σ_j (y_j − y) (x_j − x)ᵀ column by column.
void edgeSumsInSpace(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums) {
    for (int v = begin; v < end; ++v) {
        const double* const from = x + 3 * static_cast<std::ptrdiff_t>(v);
        const Row<4> y0 = loadTriple(y + 3 * static_cast<std::ptrdiff_t>(v));
        Row<4> column[3] = {zeroRow<4>(), zeroRow<4>(), zeroRow<4>()};
        for (int i = edges.start[v]; i < edges.start[v + 1]; ++i) {
            const std::ptrdiff_t j = 3 * static_cast<std::ptrdiff_t>(edges.list[i]);
            const Row<4> d = loadTriple(y + j) - y0;
#pragma GCC unroll 3
            for (int c = 0; c < 3; ++c) column[c] = addProduct(column[c], d, x[j + c] - from[c]);
        }
        double* const out = sums + 9 * static_cast<std::ptrdiff_t>(v);
        // The fourth of a column is overwritten by the next one.
        storeRow(column[0], out), storeRow(column[1], out + 3), storeTriple(column[2], out + 6);
    }
}

void addNeighboursInPlane(Neighbours edges, int begin, int end, const double* in, double* out) {
    for (int v = begin; v < end; ++v) {
        Row<2> sum[2] = {loadRow<2>(in + 2 * static_cast<std::ptrdiff_t>(v)) * edges.own[v], zeroRow<2>()};
        for (int i = edges.start[v]; i < edges.start[v + 1]; i += kGroup)
#pragma GCC unroll 4
            for (int k = 0; k < kGroup; ++k)
                sum[k % 2] = sum[k % 2] + loadRow<2>(in + 2 * static_cast<std::ptrdiff_t>(edges.list[i + k]));
        storeRow(sum[0] + sum[1], out + 2 * static_cast<std::ptrdiff_t>(v));
    }
}

void addNeighboursInSpace(Neighbours edges, int begin, int end, const double* in, double* out) {
    for (int v = begin; v < end; ++v) {
        Matrix sum[2];
        sum[0] = scaled(loadMatrix(in + 9 * static_cast<std::ptrdiff_t>(v)), edges.own[v]);
        sum[1] = {zeroRow<4>(), zeroRow<4>(), 0};
        for (int i = edges.start[v]; i < edges.start[v + 1]; i += kGroup)
#pragma GCC unroll 4
            for (int k = 0; k < kGroup; ++k)
                sum[k % 2] = sum[k % 2] + loadMatrix(in + 9 * static_cast<std::ptrdiff_t>(edges.list[i + k]));
        storeMatrix(sum[0] + sum[1], out + 9 * static_cast<std::ptrdiff_t>(v));
    }
}

void nearestInPlane(int begin, int end, double* matrices) {
    for (int v = begin; v < end; v += kLanes) {
        double* const p = matrices + 2 * static_cast<std::ptrdiff_t>(v);
        V a, b;
        loadLanes(p, 2, a, b);
        const V square = hn::MulAdd(a, a, b * b);
        const auto some = square > hn::Zero(D());
        const V scale = set(1) / hn::Sqrt(hn::IfThenElse(some, square, set(1)));
        storeLanes(hn::IfThenElse(some, scale * a, set(1)), scale * b, p, 2);
    }
}

/// Replaces kLanes matrices at a time by their nearest rotations.
void nearestInSpace(int begin, int end, double* matrices) {
    for (int v = begin; v < end; v += kLanes) {
        double* const p = matrices + 9 * static_cast<std::ptrdiff_t>(v);
        V R[9], C[9], least = set(1);
        loadMatrices(p, R);
        const V square = squaredNorm(R);
        const V scale = hn::IfThenElseZero(square > hn::Zero(D()), hn::Sqrt(set(3) / square));
#pragma GCC unroll 9
        for (int k = 0; k < 9; ++k) R[k] = scale * R[k];
        for (int step = 0; step < kNewtonSteps; ++step) {
            const V det = cofactors(R, C);
            least = hn::IfThenElse(det < least, det, least);
            const V s = hn::Sqrt(squaredNorm(C) / squaredNorm(R)), gamma = hn::Sqrt(s / det),
                    other = gamma / s;
            const V half = set(0.5) * gamma, halfOther = set(0.5) * other;
#pragma GCC unroll 9
            for (int k = 0; k < 9; ++k) R[k] = hn::MulAdd(half, R[k], halfOther * C[k]);
        }
        const auto proper = least > hn::Zero(D());
#pragma GCC unroll 9
        for (int k = 0; k < 9; ++k) R[k] = hn::IfThenElse(proper, R[k], set(k % 4 == 0 ? 1 : 0));
        storeMatrices(R, p);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace wend::rotations
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend::rotations {
namespace {

HWY_EXPORT(edgeSumsInPlane);
HWY_EXPORT(edgeSumsInSpace);
HWY_EXPORT(addNeighboursInPlane);
HWY_EXPORT(addNeighboursInSpace);
HWY_EXPORT(nearestInPlane);
HWY_EXPORT(nearestInSpace);

}  // namespace

void edgeSums2(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums) {
    HWY_DYNAMIC_DISPATCH(edgeSumsInPlane)(edges, begin, end, x, y, sums);
}
void edgeSums3(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums) {
    HWY_DYNAMIC_DISPATCH(edgeSumsInSpace)(edges, begin, end, x, y, sums);
}
void addNeighbours2(Neighbours edges, int begin, int end, const double* in, double* out) {
    HWY_DYNAMIC_DISPATCH(addNeighboursInPlane)(edges, begin, end, in, out);
}
void addNeighbours3(Neighbours edges, int begin, int end, const double* in, double* out) {
    HWY_DYNAMIC_DISPATCH(addNeighboursInSpace)(edges, begin, end, in, out);
}
void nearestRotations2(int begin, int end, double* matrices) {
    HWY_DYNAMIC_DISPATCH(nearestInPlane)(begin, end, matrices);
}
void nearestRotations3(int begin, int end, double* matrices) {
    HWY_DYNAMIC_DISPATCH(nearestInSpace)(begin, end, matrices);
}

}  // namespace wend::rotations
#endif
