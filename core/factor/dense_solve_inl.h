// This file solves with a panel for one SIMD target. It is included once for every target and therefore has
// no include guard.

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace wend::dense::HWY_NAMESPACE {

/// Returns M y for the columns of a block, the first one and the others J. Only this sum is added to w: in
/// single precision that is three times as accurate as adding one product after another.
template <class Real, class V, std::size_t... J>
HWY_INLINE V timesColumns(std::index_sequence<J...>, const Real* M, ptrdiff_t leading, const V* y) {
    const Tag<Real> d;
    V sum = hn::Mul(hn::LoadU(d, M), y[0]);
    ((sum = hn::MulAdd(hn::LoadU(d, M + (J + 1) * leading), y[J + 1], sum)), ...);
    return sum;
}

/// Fills y with the numbers of w that a block's columns are multiplied with.
template <class Real, class V, std::size_t... J>
HWY_INLINE void spread(std::index_sequence<J...>, const Real* w, V* y) {
    const Tag<Real> d;
    ((y[J] = hn::Set(d, w[J])), ...);
}

/// Adds a vector to w.
template <class Real>
HWY_INLINE void addTo(Real* w, Vector<Real> sum) {
    const Tag<Real> d;
    hn::StoreU(hn::Add(hn::LoadU(d, w), sum), d, w);
}

/// Does a block of a forward solve, from column c on. In the block's own rows M y is x; in the rows below it
/// is added to w.
template <int kColumns>
struct ForwardBlock {
    template <class Real>
    static void run(const Real* block, ptrdiff_t leading, int c, int rowEnd, Real* w, Real* x) {
        const Tag<Real> d;
        constexpr std::make_index_sequence<kColumns - 1> others;
        Vector<Real> y[kColumns];
        spread(std::make_index_sequence<kColumns>(), w + c, y);
        // The block's own rows are in at most two groups: kBlock <= kPad.
        const int top = c & ~(kPad<Real> - 1), below = c + kColumns, end = padded<Real>(below);
        Real own[2 * kPad<Real>];
        const auto first = hn::Set(d, static_cast<Real>(below));
        for (int r = top; r < end; r += kLanes<Real>) {
            const auto sum = timesColumns(others, block + r, leading, y);
            hn::StoreU(sum, d, own + (r - top));
            addTo(w + r, hn::IfThenElseZero(hn::Ge(hn::Iota(d, static_cast<Real>(r)), first), sum));
        }
        for (int j = 0; j < kColumns; ++j) x[c + j] = own[c - top + j];
        for (int r = end; r < rowEnd; r += kLanes<Real>)
            addTo(w + r, timesColumns(others, block + r, leading, y));
    }
};

/// Implements Kernels::forward.
template <class Real>
void forward(const Real* panel, int leading, int columns, int rowEnd, Real* w, Real* x) {
    for (int c = 0; c < columns; c += kBlock)
        ofWidth<ForwardBlock>(columns - c, panel + c * static_cast<ptrdiff_t>(leading),
                              static_cast<ptrdiff_t>(leading), c, rowEnd, w, x);
}

/// Adds M y of a block to the rows [rowBegin, rowEnd) of w.
template <int kColumns>
struct ForwardRows {
    template <class Real>
    static void run(const Real* block, ptrdiff_t leading, const Real* factors, int rowBegin, int rowEnd,
                    Real* w) {
        constexpr std::make_index_sequence<kColumns - 1> others;
        Vector<Real> y[kColumns];
        spread(std::make_index_sequence<kColumns>(), factors, y);
        for (int r = rowBegin; r < rowEnd; r += kLanes<Real>)
            addTo(w + r, timesColumns(others, block + r, leading, y));
    }
};

/// Implements Kernels::continueForward.
template <class Real>
void continueForward(const Real* panel, int leading, int columns, int rowBegin, int rowEnd, Real* w) {
    for (int c = 0; c < columns; c += kBlock)
        ofWidth<ForwardRows>(columns - c, panel + c * static_cast<ptrdiff_t>(leading),
                             static_cast<ptrdiff_t>(leading), w + c, rowBegin, rowEnd, w);
}

/// Returns the halves of a vector added up until one of 128 bits is left.
template <class D, class V>
HWY_INLINE auto folded(D d, V v) {
    if constexpr (hn::MaxLanes(d) * sizeof(hn::TFromD<D>) > 16) {
        const hn::Half<D> half;
        return folded(half, hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
    } else {
        return v;
    }
}

/// Returns sums of two vectors' lanes in every 128 bits: [a0 + a2, b0 + b2, a1 + a3, b1 + b3] of floats, [a0
/// + a1, b0 + b1] of doubles.
template <class V, class D>
HWY_INLINE V interleaved(D d, V a, V b) {
    return hn::Add(hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b));
}

/// Computes the sum of the lanes of every vector of s. They are added side by side, because one after another
/// they would cost more than the short columns that they belong to.
template <int kColumns, class V>
HWY_INLINE void sumsOf(const V (&s)[kColumns], float* sums) {
    const Tag<float> d;
    const hn::RepartitionToWide<Tag<float>> pairs;
    for (int j = 0; j < kColumns; j += 4) {
        const auto at = [&](int i) HWY_ATTR { return s[std::min(j + i, kColumns - 1)]; };
        const auto ab = hn::BitCast(pairs, interleaved(d, at(0), at(1)));
        const auto cd = hn::BitCast(pairs, interleaved(d, at(2), at(3)));
        const auto all = hn::Add(hn::BitCast(d, hn::InterleaveLower(pairs, ab, cd)),
                                 hn::BitCast(d, hn::InterleaveUpper(pairs, ab, cd)));
        hn::StoreU(folded(d, all), hn::Full128<float>(), sums + j);
    }
}
template <int kColumns, class V>
HWY_INLINE void sumsOf(const V (&s)[kColumns], double* sums) {
    const Tag<double> d;
    for (int j = 0; j < kColumns; j += 2)
        hn::StoreU(folded(d, interleaved(d, s[j], s[std::min(j + 1, kColumns - 1)])), hn::Full128<double>(),
                   sums + j);
}

/// Computes sums_j += M_j y for the columns J.
template <class Real, class V, std::size_t... J>
HWY_INLINE void addProducts(std::index_sequence<J...>, const Real* M, ptrdiff_t leading, V y, V* sums) {
    const Tag<Real> d;
    ((sums[J] = hn::MulAdd(hn::LoadU(d, M + J * leading), y, sums[J])), ...);
}

/// Computes Mᵀ w of a block's columns over the rows [rowBegin, rowEnd).
template <int kColumns>
struct TransposedTimes {
    template <class Real>
    static void run(const Real* M, ptrdiff_t leading, int rowBegin, int rowEnd, const Real* w, Real* sums) {
        const Tag<Real> d;
        Vector<Real> s[kColumns];
        for (auto& sum : s) sum = hn::Zero(d);
        for (int r = rowBegin; r < rowEnd; r += kLanes<Real>)
            addProducts(std::make_index_sequence<kColumns>(), M + r, leading, hn::LoadU(d, w + r), s);
        sumsOf(s, sums);
    }
};

/// Implements Kernels::prepareBackward.
template <class Real>
void prepareBackward(const Real* panel, int leading, int from, int to, int rowBegin, const Real* w, Real* x) {
    for (int c = from; c < to; c += kBlock) {
        Real sums[kBlock + 3];
        ofWidth<TransposedTimes>(to - c, panel + c * static_cast<ptrdiff_t>(leading),
                                 static_cast<ptrdiff_t>(leading), rowBegin, leading, w, &sums[0]);
        for (int j = 0; j < std::min(kBlock, to - c); ++j) x[c + j] += sums[j];
    }
}

/// Implements Kernels::backward.
template <class Real>
void backward(const Real* panel, int leading, int columns, int rowEnd, Real* w, Real* x) {
    for (int c = (columns - 1) / kBlock * kBlock; c >= 0; c -= kBlock) {
        Real sums[kBlock + 3];
        ofWidth<TransposedTimes>(columns - c, panel + c * static_cast<ptrdiff_t>(leading),
                                 static_cast<ptrdiff_t>(leading), c & ~(kPad<Real> - 1), rowEnd,
                                 static_cast<const Real*>(w), &sums[0]);
        for (int j = 0; j < std::min(kBlock, columns - c); ++j) x[c + j] = w[c + j] = x[c + j] + sums[j];
    }
}

}  // namespace wend::dense::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
