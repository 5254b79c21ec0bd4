#include "core/solver/multigrid/block_product.h"

#include <cstddef>

#include "core/base/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/solver/multigrid/block_product.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/assembly/rows_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend {
namespace HWY_NAMESPACE {
namespace {

/// Returns N floats as doubles.
template <int N>
HWY_ATTR HWY_INLINE Row<N> promoted(const float* p) {
    using Tag = typename Row<N>::Tag;
    Row<N> row;
#pragma GCC unroll 2
    for (int i = 0; i < Row<N>::kParts; ++i)
        row.part[i] = hn::PromoteTo(Tag(), hn::LoadU(hn::Rebind<float, Tag>(), p + i * Row<N>::kPartLanes));
    return row;
}

/// Columns of N numbers in so many rows of registers; of three in one of four.
template <int Size>
struct Column {
    static constexpr int kWidth = Size % 4 == 0 || Size == 3 ? 4 : 2;
    static constexpr int kRows = (Size + kWidth - 1) / kWidth;
};

/// Multiplies the rows of one block size. Short columns are summed in several accumulators side by side.
template <int Size>
HWY_ATTR HWY_INLINE void product(const int* start, const int* column, const float* blocks, const double* x,
                                 int begin, int end, double* y) {
    constexpr int kWidth = Column<Size>::kWidth, kRows = Column<Size>::kRows;
    constexpr int kSums = kRows == 1 ? 3 : 1;  // of short columns several, side by side
    for (int i = begin; i < end; ++i) {
        Row<kWidth> sum[kSums][kRows];
#pragma GCC unroll 3
        for (int s = 0; s < kSums; ++s)
#pragma GCC unroll 3
            for (int r = 0; r < kRows; ++r) sum[s][r] = zeroRow<kWidth>();
        for (int k = start[i]; k < start[i + 1]; ++k) {
            const float* const A = blocks + Size * Size * static_cast<std::ptrdiff_t>(k);
            const double* const v = x + Size * static_cast<std::ptrdiff_t>(column[k]);
#pragma GCC unroll 12
            for (int c = 0; c < Size; ++c)
#pragma GCC unroll 3
                for (int r = 0; r < kRows; ++r)
                    sum[c % kSums][r] =
                        addProduct(sum[c % kSums][r], promoted<kWidth>(A + Size * c + kWidth * r), v[c]);
        }
        double* const out = y + Size * static_cast<std::ptrdiff_t>(i - begin);
        if constexpr (Size == 3) {
            storeTriple(sum[0][0] + sum[1][0] + sum[2][0], out);
        } else if constexpr (Size == 2) {
            storeRow(sum[0][0] + sum[1][0], out);
        } else {
#pragma GCC unroll 3
            for (int r = 0; r < kRows; ++r) storeRow(sum[0][r], out + kWidth * r);
        }
    }
}

}  // namespace

// Functions that can be exported are no templates.
#define WEND_PRODUCT(Size)                                                                                   \
    void product##Size(const int* start, const int* column, const float* blocks, const double* x, int begin, \
                       int end, double* y) {                                                                 \
        product<Size>(start, column, blocks, x, begin, end, y);                                              \
    }
WEND_PRODUCT(2)
WEND_PRODUCT(3)
WEND_PRODUCT(6)
WEND_PRODUCT(12)
#undef WEND_PRODUCT

}  // namespace HWY_NAMESPACE
}  // namespace wend
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend {
namespace {

HWY_EXPORT(product2);
HWY_EXPORT(product3);
HWY_EXPORT(product6);
HWY_EXPORT(product12);

}  // namespace

#define WEND_PRODUCT(Size)                                                                               \
    template <>                                                                                          \
    void multiplyBlocks<Size>(const int* start, const int* column, const float* blocks, const double* x, \
                              int begin, int end, double* y) {                                           \
        HWY_DYNAMIC_DISPATCH(product##Size)(start, column, blocks, x, begin, end, y);                    \
    }
WEND_PRODUCT(2)
WEND_PRODUCT(3)
WEND_PRODUCT(6)
WEND_PRODUCT(12)

}  // namespace wend
#endif
