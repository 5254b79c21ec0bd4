#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <Eigen/Core>
#include <cstring>

#include "warp/pixels.h"

namespace wend {

/// A colour in the picture's own scale (0 … kFull): four lanes, those beyond the picture's channels
/// undefined.
using Lanes = Eigen::Array4f;

#if defined(__SSE2__)
// The compiler turns bytes into numbers one by one; these are the instructions for four at a time that every
// x86-64 has.

inline Lanes fromLanes(__m128i lanes) {
    Lanes colour;
    _mm_storeu_ps(colour.data(), _mm_cvtepi32_ps(lanes));
    return colour;
}

inline __m128i roundedLanes(const Lanes& colour, float full) {
    const __m128 value =
        _mm_min_ps(_mm_max_ps(_mm_loadu_ps(colour.data()), _mm_setzero_ps()), _mm_set1_ps(full));
    return _mm_cvttps_epi32(_mm_add_ps(value, _mm_set1_ps(0.5F)));
}

inline Lanes widened(const std::uint8_t* p) {
    int bytes;
    std::memcpy(&bytes, p, sizeof bytes);
    const __m128i zero = _mm_setzero_si128();
    return fromLanes(_mm_unpacklo_epi16(_mm_unpacklo_epi8(_mm_cvtsi32_si128(bytes), zero), zero));
}

inline Lanes widened(const std::uint16_t* p) {
    return fromLanes(
        _mm_unpacklo_epi16(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)), _mm_setzero_si128()));
}

/// The bits of a half, moved to their places in a float, are that number times 2⁻¹¹².
inline Lanes widened(const half* p) {
    const __m128i bits =
        _mm_unpacklo_epi16(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)), _mm_setzero_si128());
    const __m128i sign = _mm_slli_epi32(_mm_and_si128(bits, _mm_set1_epi32(0x8000)), 16);
    const __m128i magnitude = _mm_slli_epi32(_mm_and_si128(bits, _mm_set1_epi32(0x7fff)), 13);
    const __m128 finite = _mm_mul_ps(_mm_castsi128_ps(magnitude), _mm_set1_ps(0x1p112F));
    const __m128i special = _mm_cmpgt_epi32(magnitude, _mm_set1_epi32(0x0f7fffff));  // infinity, NaN
    const __m128i exponent = _mm_and_si128(special, _mm_set1_epi32(0x7f800000));
    Lanes colour;
    _mm_storeu_ps(colour.data(), _mm_or_ps(finite, _mm_castsi128_ps(_mm_or_si128(sign, exponent))));
    return colour;
}

inline void narrowed(const Lanes& colour, std::uint8_t* p) {
    const __m128i words = _mm_packs_epi32(roundedLanes(colour, 255), _mm_setzero_si128());
    const int bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
    std::memcpy(p, &bytes, sizeof bytes);
}

/// Packing to 16 bits saturates as signed: shifted by half of the range there and back.
inline void narrowed(const Lanes& colour, std::uint16_t* p) {
    const __m128i shifted = _mm_sub_epi32(roundedLanes(colour, 65535), _mm_set1_epi32(32768));
    const __m128i words = _mm_add_epi16(_mm_packs_epi32(shifted, shifted), _mm_set1_epi16(-32768));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p), words);
}
#else
template <typename T>
Lanes widened(const T* p) {
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
            static_cast<float>(p[3])};
}
template <typename T>
void narrowed(const Lanes& colour, T* p) {
    for (int c = 0; c < 4; ++c) p[c] = toPixel<T>(colour[c]);
}
#endif

inline Lanes widened(const float* p) {
    return Lanes(p);
}
inline void narrowed(const Lanes& colour, float* p) {
    std::memcpy(p, colour.data(), 4 * sizeof *p);
}
#if defined(__SSE2__)
inline void narrowed(const Lanes& colour, half* p) {
    for (int c = 0; c < 4; ++c) p[c] = half(colour[c]);
}
#endif

/// The lane in all lanes.
template <int lane>
Lanes spread(const Lanes& lanes) {
#if defined(__SSE2__)
    const __m128 v = _mm_loadu_ps(lanes.data());
    Lanes result;
    _mm_storeu_ps(result.data(), _mm_shuffle_ps(v, v, _MM_SHUFFLE(lane, lane, lane, lane)));
    return result;
#else
    return Lanes::Constant(lanes[lane]);
#endif
}

/// `lanes` but for one lane, which is that of `other`.
template <int lane>
Lanes replaced(const Lanes& lanes, const Lanes& other) {
#if defined(__SSE2__)
    const __m128 mask =
        _mm_castsi128_ps(_mm_setr_epi32(-(lane == 0), -(lane == 1), -(lane == 2), -(lane == 3)));
    Lanes result;
    _mm_storeu_ps(result.data(), _mm_or_ps(_mm_andnot_ps(mask, _mm_loadu_ps(lanes.data())),
                                           _mm_and_ps(mask, _mm_loadu_ps(other.data()))));
    return result;
#else
    Lanes result = lanes;
    result[lane] = other[lane];
    return result;
#endif
}

/// The pixel of N channels at p. With `beyond`, the channel after a pixel of three may be read.
template <int N, bool beyond, typename T>
Lanes loadColour(const T* p) {
    if constexpr (N == 4 || (N == 3 && beyond)) return widened(p);
    Lanes colour = Lanes::Zero();
    for (int c = 0; c < N; ++c) colour[c] = static_cast<float>(p[c]);
    return colour;
}

/// Writes the first lanes, rounded and clamped.
template <int channels, typename T>
void storeColour(const Lanes& colour, T* p) {
    if constexpr (channels == 4) return narrowed(colour, p);
    T four[4];
    narrowed(colour, four);
    for (int c = 0; c < channels; ++c) p[c] = four[c];
}

}  // namespace wend
