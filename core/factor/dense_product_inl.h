// This file multiplies panels for one SIMD target. It is included once for every target and therefore has no
// include guard.

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/factor/dense_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace wend::dense::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using std::ptrdiff_t;

template <class Real>
using Tag = hn::ScalableTag<Real>;
template <class Real>
using Vector = hn::Vec<Tag<Real>>;
template <class Real>
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag<Real>()));

// The number of columns of a block. Two vectors of rows times this many columns need as many accumulators as
// there are registers, less those for the factors: 12 of 16, and 16 of the 32 of AVX-512.
constexpr int kBlock = HWY_TARGET <= HWY_AVX3 ? 8 : 6;
static_assert(kSolveColumns % kBlock == 0);

// A packed block of rows takes a quarter of a megabyte, half of the second-level cache of most processors.
constexpr int kDepth = 256;
template <class Real>
constexpr int kRows = 262144 / (kDepth * static_cast<int>(sizeof(Real)));
// Factors of fewer bytes than this are in the first-level cache without packing.
constexpr ptrdiff_t kFirstLevel = 24576;

/// Calls Kernel<count>::run(arguments…) for a count that is known at run time only, 0 < count <= kBlock.
template <template <int> class Kernel, int kCount = kBlock, class... Arguments>
HWY_INLINE void ofWidth(int count, Arguments... arguments) {
    if constexpr (kCount > 1)
        if (count < kCount) return ofWidth<Kernel, kCount - 1>(count, arguments...);
    Kernel<kCount>::run(arguments...);
}

/// Locates the rows of a factor of a product, from row `begin` on: row begin + r of column k is first[r /
/// kPad · group + r % kPad + k · stride], and the next vector of rows is `second` numbers farther.
template <class Real>
struct Rows {
    const Real* first;
    ptrdiff_t group, stride, second;
    int begin = 0;

    const Real* row(int r) const {
        return first + (r - begin) / kPad<Real> * group + (r - begin) % kPad<Real>;
    }
};

/// Computes C −= sum, or C = −sum.
template <bool kReplaces, class Real>
HWY_INLINE void subtract(Vector<Real> sum, Real* C) {
    const Tag<Real> d;
    if constexpr (kReplaces)
        hn::StoreU(hn::Sub(hn::Zero(d), sum), d, C);  // GCC vectorizes no emulated Neg
    else
        hn::StoreU(hn::Sub(hn::LoadU(d, C), sum), d, C);
}

/// Adds one or two vectors of rows times a factor to the accumulators p and q.
template <int kVectors, class V>
HWY_INLINE void accumulate(V a, V b, V factor, V& p, V& q) {
    p = hn::MulAdd(a, factor, p);
    if constexpr (kVectors == 2) q = hn::MulAdd(b, factor, q);
}

/// Computes C −= A Bᵀ, or C = −A Bᵀ, for one or two vectors of rows and the columns J. Every accumulator is a
/// register, because the indices are constants.
template <bool kReplaces, int kVectors, class Real, std::size_t... J>
HWY_INLINE void tile(std::index_sequence<J...>, int depth, const Real* A, ptrdiff_t strideA, ptrdiff_t second,
                     const Real* B, ptrdiff_t strideB, Real* C, ptrdiff_t leadingC) {
    const Tag<Real> d;
    Vector<Real> p[sizeof...(J)] = {((void)J, hn::Zero(d))...}, q[sizeof...(J)] = {((void)J, hn::Zero(d))...};
    for (int k = 0; k < depth; ++k, A += strideA, B += strideB) {
        const auto a = hn::LoadU(d, A), b = kVectors == 2 ? hn::LoadU(d, A + second) : a;
        (accumulate<kVectors>(a, b, hn::Set(d, B[J]), p[J], q[J]), ...);
    }
    (subtract<kReplaces>(p[J], C + J * leadingC), ...);
    if constexpr (kVectors == 2) (subtract<kReplaces>(q[J], C + J * leadingC + kLanes<Real>), ...);
}

/// Computes C −= A Bᵀ, or C = −A Bᵀ, for the rows [rowBegin, rowEnd), in whole groups of kPad, and kColumns
/// columns.
template <int kColumns>
struct Strip {
    template <class Real>
    static void run(const Rows<Real>* A, int depth, const Real* B, ptrdiff_t strideB, Real* C,
                    ptrdiff_t leadingC, int rowBegin, int rowEnd, bool replaces) {
        if (replaces)
            tiles<true>(*A, depth, B, strideB, C, leadingC, rowBegin, rowEnd);
        else
            tiles<false>(*A, depth, B, strideB, C, leadingC, rowBegin, rowEnd);
    }

  private:
    /// Goes through the rows in tiles of two vectors, and of one at the end if a group of kPad has an odd
    /// number.
    template <bool kReplaces, class Real>
    static void tiles(const Rows<Real>& A, int depth, const Real* B, ptrdiff_t strideB, Real* C,
                      ptrdiff_t leadingC, int rowBegin, int rowEnd) {
        constexpr std::make_index_sequence<kColumns> columns;
        constexpr int kTwo = 2 * kLanes<Real>;
        int r = rowBegin;
        for (; r + kTwo <= rowEnd; r += kTwo)
            tile<kReplaces, 2>(columns, depth, A.row(r), A.stride, A.second, B, strideB, C + r, leadingC);
        if constexpr (kPad<Real> % kTwo != 0)
            if (r < rowEnd)
                tile<kReplaces, 1>(columns, depth, A.row(r), A.stride, A.second, B, strideB, C + r, leadingC);
    }
};

/// Packs rows, `leading` numbers from column to column, into groups of kPad one after another.
template <class Real>
HWY_INLINE Rows<Real> packRows(const Real* A, ptrdiff_t leading, int depth, int begin, int end,
                               Real* packed) {
    const Tag<Real> d;
    const ptrdiff_t group = static_cast<ptrdiff_t>(depth) * kPad<Real>;
    for (int k = 0; k < depth; ++k)
        for (int r = begin; r < end; r += kPad<Real>) {
            const Real* const from = A + k * leading + r;
            Real* const to = packed + (r - begin) / kPad<Real> * group + k * kPad<Real>;
            for (int i = 0; i < kPad<Real>; i += kLanes<Real>) hn::Store(hn::LoadU(d, from + i), d, to + i);
        }
    return {packed, group, kPad<Real>, kLanes<Real> == kPad<Real> ? group : kLanes<Real>, begin};
}

/// Packs rows of the second factor, kBlock numbers from column to column.
template <class Real>
HWY_INLINE void packBlock(const Real* B, ptrdiff_t leading, int depth, Real* packed) {
    for (int k = 0; k < depth; ++k)
        for (int j = 0; j < kBlock; ++j) packed[k * kBlock + j] = B[k * leading + j];
}

/// Subtracts a product whose factors are both rows of one panel. Entry (r, c) of C, for from <= c < to and
/// the rows [rowBegin, rowEnd) from the group of kPad on that holds row c, loses the product of the rows r
/// and c of A.
template <class Real>
struct Product {
    const Real* A;
    ptrdiff_t leading;
    int depth;
    Real* C;
    ptrdiff_t leadingC;
    int from, to, rowBegin, rowEnd;
    bool replaces = false;  // C is overwritten

    /// Returns the first row of a column that is computed.
    int top(int column) const { return std::max(rowBegin, column & ~(kPad<Real> - 1)); }
    void subtract() const;

  private:
    /// Returns whether packing the rows pays.
    bool packs() const {
        return static_cast<ptrdiff_t>(rowEnd - top(from)) * depth * static_cast<int>(sizeof(Real)) >
                   kFirstLevel &&
               to - from > 2 * kBlock;
    }
    void subtractPlain() const;
    void subtractPacked() const;
};

template <class Real>
void Product<Real>::subtractPlain() const {
    const Rows<Real> rows{A, kPad<Real>, leading, kLanes<Real>, 0};
    for (int c = from; c < to; c += kBlock)
        ofWidth<Strip>(to - c, &rows, depth, A + c, leading, C + c * leadingC, leadingC, top(c), rowEnd,
                       replaces);
}

/// Goes through blocks of rows that are packed once and serve all columns.
template <class Real>
void Product<Real>::subtractPacked() const {
    alignas(64) Real packedRows[kDepth * kRows<Real>], packedBlock[kDepth * kBlock];
    for (int begin = top(from); begin < rowEnd; begin += kRows<Real>) {
        const int end = std::min(rowEnd, begin + kRows<Real>);
        const Rows<Real> rows = packRows(A, leading, depth, begin, end, packedRows);
        for (int c = from; c < std::min(to, end); c += kBlock) {
            packBlock(A + c, leading, depth, packedBlock);
            ofWidth<Strip>(to - c, &rows, depth, packedBlock, static_cast<ptrdiff_t>(kBlock),
                           C + c * leadingC, leadingC, std::max(begin, top(c)), end, replaces);
        }
    }
}

// The depth is divided into blocks, packed or not, so that every entry has one order of summation.
template <class Real>
void Product<Real>::subtract() const {
    Product part = *this;
    for (int k = 0; k < depth; k += kDepth, part.A += kDepth * leading) {
        part.depth = std::min(kDepth, depth - k);
        if (part.packs())
            part.subtractPacked();
        else
            part.subtractPlain();
        part.replaces = false;
    }
}

}  // namespace wend::dense::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
