// This file defines rows of two or four doubles, and lanes, which hold the same number of two or four items
// side by side. It is included once for every target of Highway.

#if defined(WEND_ASSEMBLY_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEND_ASSEMBLY_ROWS_INL_H
#undef WEND_ASSEMBLY_ROWS_INL_H
#else
#define WEND_ASSEMBLY_ROWS_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wend {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// There are at most four lanes, on AVX-512 too, because the rows of four that are loaded and transposed need
// no wider registers.
using D = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));

/// N doubles, 2 or 4, in as many registers as the target needs.
template <int N>
struct Row {
    using Tag = hn::CappedTag<double, N>;
    static constexpr int kPartLanes = static_cast<int>(hn::MaxLanes(Tag()));
    static constexpr int kParts = N / kPartLanes;
    hn::Vec<Tag> part[kParts];
};

/// Loads N doubles; the address need not be aligned.
template <int N>
HWY_ATTR HWY_INLINE Row<N> loadRow(const double* p) {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i)
        row.part[i] = hn::LoadU(typename Row<N>::Tag(), p + i * Row<N>::kPartLanes);
    return row;
}

/// Stores N doubles; the address need not be aligned.
template <int N>
HWY_ATTR HWY_INLINE void storeRow(const Row<N>& row, double* p) {
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i)
        hn::StoreU(row.part[i], typename Row<N>::Tag(), p + i * Row<N>::kPartLanes);
}

/// Returns a row of zeros.
template <int N>
HWY_ATTR HWY_INLINE Row<N> zeroRow() {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i) row.part[i] = hn::Zero(typename Row<N>::Tag());
    return row;
}

template <int N>
HWY_ATTR HWY_INLINE Row<N> operator-(const Row<N>& a, const Row<N>& b) {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i) row.part[i] = a.part[i] - b.part[i];
    return row;
}

template <int N>
HWY_ATTR HWY_INLINE Row<N> operator+(const Row<N>& a, const Row<N>& b) {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i) row.part[i] = a.part[i] + b.part[i];
    return row;
}

template <int N>
HWY_ATTR HWY_INLINE Row<N> operator*(const Row<N>& a, double factor) {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i)
        row.part[i] = a.part[i] * hn::Set(typename Row<N>::Tag(), factor);
    return row;
}

/// Returns sum + a · factor.
template <int N>
HWY_ATTR HWY_INLINE Row<N> addProduct(const Row<N>& sum, const Row<N>& a, double factor) {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i)
        row.part[i] = hn::MulAdd(a.part[i], hn::Set(typename Row<N>::Tag(), factor), sum.part[i]);
    return row;
}

/// Returns sum + a · b, element by element.
template <int N>
HWY_ATTR HWY_INLINE Row<N> addProducts(const Row<N>& sum, const Row<N>& a, const Row<N>& b) {
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i) row.part[i] = hn::MulAdd(a.part[i], b.part[i], sum.part[i]);
    return row;
}

/// Returns the two doubles in reverse order.
HWY_INLINE Row<2> reversed(const Row<2>& row) {
    return {{hn::Reverse2(Row<2>::Tag(), row.part[0])}};
}

/// Loads three doubles and appends a zero; the fourth double in memory is not read.
HWY_INLINE Row<4> loadTriple(const double* p) {
    Row<4> row;
#if HWY_CAP_GE256
    row.part[0] = hn::MaskedLoad(hn::FirstN(D(), 3), D(), p);
#else
    row.part[0] = hn::LoadU(D(), p);
    row.part[1] = hn::InsertLane(hn::Zero(D()), 0, p[2]);
#endif
    return row;
}

/// Stores the first three doubles; the fourth in memory is not written.
HWY_INLINE void storeTriple(const Row<4>& row, double* p) {
#if HWY_CAP_GE256
    const hn::Half<D> half;
    hn::StoreU(hn::LowerHalf(half, row.part[0]), half, p);
    p[2] = hn::GetLane(hn::UpperHalf(half, row.part[0]));
#else
    hn::StoreU(row.part[0], D(), p);
    p[2] = hn::GetLane(row.part[1]);
#endif
}

/// Loads a point: a row of two in the plane, a row of four with a zero in space.
template <int Dim>
HWY_ATTR HWY_INLINE auto loadPoint(const double* points, int vertex) {
    if constexpr (Dim == 2)
        return loadRow<2>(points + 2 * static_cast<std::ptrdiff_t>(vertex));
    else
        return loadTriple(points + 3 * static_cast<std::ptrdiff_t>(vertex));
}

/// Loads and transposes: row l, at p + l · stride, becomes lane l of v0 … v3.
HWY_INLINE void loadLanes(const double* p, int stride, V& v0, V& v1, V& v2, V& v3) {
#if HWY_CAP_GE256
    const V r0 = hn::LoadU(D(), p), r1 = hn::LoadU(D(), p + stride), r2 = hn::LoadU(D(), p + 2 * stride),
            r3 = hn::LoadU(D(), p + 3 * stride);
    const V even02 = hn::ConcatLowerLower(D(), r2, r0), even13 = hn::ConcatLowerLower(D(), r3, r1),
            odd02 = hn::ConcatUpperUpper(D(), r2, r0), odd13 = hn::ConcatUpperUpper(D(), r3, r1);
    v0 = hn::InterleaveLower(D(), even02, even13), v1 = hn::InterleaveUpper(D(), even02, even13);
    v2 = hn::InterleaveLower(D(), odd02, odd13), v3 = hn::InterleaveUpper(D(), odd02, odd13);
#else
    const V a0 = hn::LoadU(D(), p), b0 = hn::LoadU(D(), p + 2), a1 = hn::LoadU(D(), p + stride),
            b1 = hn::LoadU(D(), p + stride + 2);
    v0 = hn::InterleaveLower(D(), a0, a1), v1 = hn::InterleaveUpper(D(), a0, a1);
    v2 = hn::InterleaveLower(D(), b0, b1), v3 = hn::InterleaveUpper(D(), b0, b1);
#endif
}

/// Reverses loadLanes(): lane l of v0 … v3 becomes the row at p + l · stride.
HWY_INLINE void storeLanes(V v0, V v1, V v2, V v3, double* p, int stride) {
#if HWY_CAP_GE256
    const V even01 = hn::InterleaveLower(D(), v0, v1), odd01 = hn::InterleaveUpper(D(), v0, v1),
            even23 = hn::InterleaveLower(D(), v2, v3), odd23 = hn::InterleaveUpper(D(), v2, v3);
    hn::StoreU(hn::ConcatLowerLower(D(), even23, even01), D(), p);
    hn::StoreU(hn::ConcatLowerLower(D(), odd23, odd01), D(), p + stride);
    hn::StoreU(hn::ConcatUpperUpper(D(), even23, even01), D(), p + 2 * stride);
    hn::StoreU(hn::ConcatUpperUpper(D(), odd23, odd01), D(), p + 3 * stride);
#else
    hn::StoreU(hn::InterleaveLower(D(), v0, v1), D(), p);
    hn::StoreU(hn::InterleaveLower(D(), v2, v3), D(), p + 2);
    hn::StoreU(hn::InterleaveUpper(D(), v0, v1), D(), p + stride);
    hn::StoreU(hn::InterleaveUpper(D(), v2, v3), D(), p + stride + 2);
#endif
}

/// Does the same for rows of two.
HWY_INLINE void loadLanes(const double* p, int stride, V& v0, V& v1) {
#if HWY_CAP_GE256
    const hn::Half<D> half;
    const V r01 = hn::Combine(D(), hn::LoadU(half, p + 2 * stride), hn::LoadU(half, p)),
            r23 = hn::Combine(D(), hn::LoadU(half, p + 3 * stride), hn::LoadU(half, p + stride));
    v0 = hn::InterleaveLower(D(), r01, r23), v1 = hn::InterleaveUpper(D(), r01, r23);
#else
    const V r0 = hn::LoadU(D(), p), r1 = hn::LoadU(D(), p + stride);
    v0 = hn::InterleaveLower(D(), r0, r1), v1 = hn::InterleaveUpper(D(), r0, r1);
#endif
}

HWY_INLINE void storeLanes(V v0, V v1, double* p, int stride) {
#if HWY_CAP_GE256
    const hn::Half<D> half;
    const V even = hn::InterleaveLower(D(), v0, v1), odd = hn::InterleaveUpper(D(), v0, v1);
    hn::StoreU(hn::LowerHalf(half, even), half, p);
    hn::StoreU(hn::LowerHalf(half, odd), half, p + stride);
    hn::StoreU(hn::UpperHalf(half, even), half, p + 2 * stride);
    hn::StoreU(hn::UpperHalf(half, odd), half, p + 3 * stride);
#else
    hn::StoreU(hn::InterleaveLower(D(), v0, v1), D(), p);
    hn::StoreU(hn::InterleaveUpper(D(), v0, v1), D(), p + stride);
#endif
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wend
HWY_AFTER_NAMESPACE();

#endif
