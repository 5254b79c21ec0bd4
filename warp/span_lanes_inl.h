// Colours as vectors. Read once per target of Highway.

#if defined(WEND_WARP_SPAN_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEND_WARP_SPAN_LANES_INL_H
#undef WEND_WARP_SPAN_LANES_INL_H
#else
#define WEND_WARP_SPAN_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "warp/pixels.h"

HWY_BEFORE_NAMESPACE();
namespace wend::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A colour in the picture's own scale (0 … kFull): four lanes, those beyond its channels undefined.
using Four = hn::CappedTag<float, 4>;
using Colour = hn::Vec<Four>;

HWY_INLINE Colour all(float a) {
    return hn::Set(Four(), a);
}

/// Two colours, or eight numbers.
#if HWY_CAP_GE256
using EightTag = hn::CappedTag<float, 8>;
using Eight = hn::Vec<EightTag>;

HWY_INLINE Eight eight(float a) {
    return hn::Set(EightTag(), a);
}
HWY_INLINE Eight eight(Colour low, Colour high) {
    return hn::Combine(EightTag(), high, low);
}
HWY_INLINE Eight counted() {
    return hn::Iota(EightTag(), 0);
}
HWY_INLINE Eight smaller(Eight a, Eight b) {
    return hn::Min(a, b);
}
HWY_INLINE Colour low(Eight a) {
    return hn::LowerHalf(Four(), a);
}
HWY_INLINE Colour high(Eight a) {
    return hn::UpperHalf(Four(), a);
}
/// Returns number 2 k in the lower four lanes and 2 k + 1 in the upper ones.
template <int k>
HWY_ATTR HWY_INLINE Eight spreadTwo(Eight a) {
    HWY_ALIGN static constexpr std::int32_t kLanes[8] = {2 * k,     2 * k,     2 * k,     2 * k,
                                                         2 * k + 1, 2 * k + 1, 2 * k + 1, 2 * k + 1};
    return hn::TableLookupLanes(a, hn::SetTableIndices(EightTag(), kLanes));
}
/// Returns one lane of each colour in all of its lanes.
template <int lane>
HWY_ATTR HWY_INLINE Eight spread(Eight a) {
    return hn::Broadcast<lane>(a);
}
/// Returns `a` with the last of `channels` lanes of each colour, two or four, from `b`.
template <int channels>
HWY_ATTR HWY_INLINE Eight lastReplaced(Eight a, Eight b) {
    const Eight odd = hn::OddEven(b, a);
    if constexpr (channels == 2) return odd;
    const hn::RepartitionToWide<EightTag> pairs;
    return hn::BitCast(EightTag(), hn::OddEven(hn::BitCast(pairs, odd), hn::BitCast(pairs, a)));
}
#else
struct Eight {
    Colour l, h;
};
HWY_INLINE Eight operator+(Eight a, Eight b) {
    return {a.l + b.l, a.h + b.h};
}
HWY_INLINE Eight operator-(Eight a, Eight b) {
    return {a.l - b.l, a.h - b.h};
}
HWY_INLINE Eight operator*(Eight a, Eight b) {
    return {a.l * b.l, a.h * b.h};
}
HWY_INLINE Eight eight(float a) {
    return {all(a), all(a)};
}
HWY_INLINE Eight eight(Colour low, Colour high) {
    return {low, high};
}
HWY_INLINE Eight counted() {
    return {hn::Iota(Four(), 0), hn::Iota(Four(), 4)};
}
HWY_INLINE Eight smaller(Eight a, Eight b) {
    return {hn::Min(a.l, b.l), hn::Min(a.h, b.h)};
}
HWY_INLINE Colour low(Eight a) {
    return a.l;
}
HWY_INLINE Colour high(Eight a) {
    return a.h;
}
template <int k>
HWY_ATTR HWY_INLINE Eight spreadTwo(Eight a) {
    const Colour from = k < 2 ? a.l : a.h;
    return {hn::Broadcast<2 * k % 4>(from), hn::Broadcast<2 * k % 4 + 1>(from)};
}
template <int lane>
HWY_ATTR HWY_INLINE Eight spread(Eight a) {
    return {hn::Broadcast<lane>(a.l), hn::Broadcast<lane>(a.h)};
}
template <int channels>
HWY_ATTR HWY_INLINE Colour lastReplaced(Colour a, Colour b) {
    const Colour odd = hn::OddEven(b, a);
    if constexpr (channels == 2) return odd;
    const hn::RepartitionToWide<Four> pairs;
    return hn::BitCast(Four(), hn::OddEven(hn::BitCast(pairs, odd), hn::BitCast(pairs, a)));
}
template <int channels>
HWY_ATTR HWY_INLINE Eight lastReplaced(Eight a, Eight b) {
    return {lastReplaced<channels>(a.l, b.l), lastReplaced<channels>(a.h, b.h)};
}
#endif

// --- one colour
// -----------------------------------------------------------------------------------------------

HWY_INLINE Colour widened(const std::uint8_t* p) {
    return hn::ConvertTo(
        Four(), hn::PromoteTo(hn::RebindToSigned<Four>(), hn::LoadU(hn::CappedTag<std::uint8_t, 4>(), p)));
}
HWY_INLINE Colour widened(const std::uint16_t* p) {
    return hn::ConvertTo(
        Four(), hn::PromoteTo(hn::RebindToSigned<Four>(), hn::LoadU(hn::CappedTag<std::uint16_t, 4>(), p)));
}
HWY_INLINE Colour widened(const float* p) {
    return hn::LoadU(Four(), p);
}

HWY_INLINE hn::Vec<hn::RebindToSigned<Four>> rounded(Colour colour) {
    return hn::ConvertTo(hn::RebindToSigned<Four>(), colour + all(0.5F));
}
HWY_INLINE void narrowed(Colour colour, std::uint8_t* p) {
    const hn::CappedTag<std::uint8_t, 4> d;
    hn::StoreU(hn::DemoteTo(d, rounded(colour)), d, p);
}
HWY_INLINE void narrowed(Colour colour, std::uint16_t* p) {
    const hn::CappedTag<std::uint16_t, 4> d;
    hn::StoreU(hn::DemoteTo(d, rounded(colour)), d, p);
}
HWY_INLINE void narrowed(Colour colour, float* p) {
    hn::StoreU(colour, Four(), p);
}

// Highway's own half floats, where processors have none, are cut off instead of rounded and know no infinity.
#if HWY_CAP_GE256
using Halves = hn::CappedTag<hwy::float16_t, 4>;
HWY_INLINE Colour widened(const half* p) {
    const hn::CappedTag<std::uint16_t, 4> bits;
    return hn::PromoteTo(Four(),
                         hn::BitCast(Halves(), hn::LoadU(bits, reinterpret_cast<const std::uint16_t*>(p))));
}
HWY_INLINE void narrowed(Colour colour, half* p) {
    const hn::CappedTag<std::uint16_t, 4> bits;
    hn::StoreU(hn::BitCast(bits, hn::DemoteTo(Halves(), colour)), bits, reinterpret_cast<std::uint16_t*>(p));
}
#else
HWY_INLINE Colour widened(const half* p) {
    HWY_ALIGN const float values[4] = {p[0], p[1], p[2], p[3]};
    return hn::Load(Four(), values);
}
HWY_INLINE void narrowed(Colour colour, half* p) {
    HWY_ALIGN float values[4];
    hn::Store(colour, Four(), values);
    for (int c = 0; c < 4; ++c) p[c] = half(values[c]);
}
#endif

// --- two colours
// -----------------------------------------------------------------------------------------------

#if HWY_CAP_GE256
/// Loads four numbers at p and four at p + N; with N = 4 these are eight in a row.
template <int N, typename Number>
HWY_ATTR HWY_INLINE auto loadNumbers(const Number* p) {
    const hn::CappedTag<Number, 8> d;
    const hn::CappedTag<Number, 4> half;
    if constexpr (N == 4)
        return hn::LoadU(d, p);
    else
        return hn::Combine(d, hn::LoadU(half, p + N), hn::LoadU(half, p));
}

/// Loads the pixels of N channels at p and after it.
template <int N, typename T>
HWY_ATTR HWY_INLINE Eight loadTwo(const T* p) {
    if constexpr (std::is_same_v<T, float>)
        return loadNumbers<N>(p);
    else if constexpr (std::is_integral_v<T>)
        return hn::ConvertTo(EightTag(), hn::PromoteTo(hn::RebindToSigned<EightTag>(), loadNumbers<N>(p)));
    else
        return hn::PromoteTo(EightTag(),
                             hn::BitCast(hn::CappedTag<hwy::float16_t, 8>(),
                                         loadNumbers<N>(reinterpret_cast<const std::uint16_t*>(p))));
}
#else
template <int N, typename T>
HWY_ATTR HWY_INLINE Eight loadTwo(const T* p) {
    return {widened(p), widened(p + N)};
}
#endif

/// Writes the first lanes, rounded and clamped.
template <int channels, typename T>
HWY_ATTR HWY_INLINE void storeColour(Colour colour, T* p) {
    if constexpr (channels == 4) return narrowed(colour, p);
    T few[4];
    narrowed(colour, few);
    std::memcpy(static_cast<void*>(p), few, channels * sizeof(T));
}

}  // namespace
}  // namespace wend::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
