// Colours as vectors. No include guard: read once per instruction set, within its namespace (span_painters.h).

#define WEND_INLINE WEND_TARGET inline __attribute__((always_inline))

/// A colour in the picture's own scale (0 … kFull): four lanes, those beyond its channels undefined.
typedef float Colour __attribute__((vector_size(16)));

/// Two colours, or eight numbers.
#if defined(WEND_WIDE)
struct Eight {
    __m256 v;
};
WEND_INLINE Eight operator+(Eight a, Eight b) {
    return {a.v + b.v};
}
WEND_INLINE Eight operator-(Eight a, Eight b) {
    return {a.v - b.v};
}
WEND_INLINE Eight operator*(Eight a, Eight b) {
    return {a.v * b.v};
}
WEND_INLINE Eight eight(float a) {
    return {_mm256_set1_ps(a)};
}
WEND_INLINE Eight eight(Colour low, Colour high) {
    return {_mm256_set_m128(high, low)};
}
WEND_INLINE Eight counted() {
    return {_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7)};
}
WEND_INLINE Eight smaller(Eight a, Eight b) {
    return {_mm256_min_ps(a.v, b.v)};
}
WEND_INLINE Colour low(Eight a) {
    return _mm256_castps256_ps128(a.v);
}
WEND_INLINE Colour high(Eight a) {
    return _mm256_extractf128_ps(a.v, 1);
}
/// Number 2 k in the lower four lanes, 2 k + 1 in the upper.
template <int k>
WEND_INLINE Eight spreadTwo(Eight a) {
    const __m256i lanes =
        _mm256_setr_epi32(2 * k, 2 * k, 2 * k, 2 * k, 2 * k + 1, 2 * k + 1, 2 * k + 1, 2 * k + 1);
    return {_mm256_permutevar8x32_ps(a.v, lanes)};
}
/// One lane of each colour in all of its lanes.
template <int lane>
WEND_INLINE Eight spread(Eight a) {
    return {_mm256_permute_ps(a.v, lane * 0x55)};
}
template <int lane>
WEND_INLINE Eight replaced(Eight a, Eight b) {
    return {_mm256_blend_ps(a.v, b.v, 0x11 << lane)};
}
#else
struct Eight {
    Colour l, h;
};
WEND_INLINE Eight operator+(Eight a, Eight b) {
    return {a.l + b.l, a.h + b.h};
}
WEND_INLINE Eight operator-(Eight a, Eight b) {
    return {a.l - b.l, a.h - b.h};
}
WEND_INLINE Eight operator*(Eight a, Eight b) {
    return {a.l * b.l, a.h * b.h};
}
WEND_INLINE Colour four(float a) {
    return Colour{a, a, a, a};
}
WEND_INLINE Eight eight(float a) {
    return {four(a), four(a)};
}
WEND_INLINE Eight eight(Colour low, Colour high) {
    return {low, high};
}
WEND_INLINE Eight counted() {
    return {Colour{0, 1, 2, 3}, Colour{4, 5, 6, 7}};
}
WEND_INLINE Eight smaller(Eight a, Eight b) {
    return {a.l < b.l ? a.l : b.l, a.h < b.h ? a.h : b.h};
}
WEND_INLINE Colour low(Eight a) {
    return a.l;
}
WEND_INLINE Colour high(Eight a) {
    return a.h;
}
template <int k>
WEND_INLINE Eight spreadTwo(Eight a) {
    const Colour from = k < 2 ? a.l : a.h;
    return {four(from[2 * k % 4]), four(from[2 * k % 4 + 1])};
}
template <int lane>
WEND_INLINE Eight spread(Eight a) {
    return {four(a.l[lane]), four(a.h[lane])};
}
template <int lane>
WEND_INLINE Eight replaced(Eight a, Eight b) {
    a.l[lane] = b.l[lane], a.h[lane] = b.h[lane];
    return a;
}
#endif

WEND_INLINE Colour least(Colour a, Colour b) {
    return a < b ? a : b;
}
WEND_INLINE Colour most(Colour a, Colour b) {
    return a > b ? a : b;
}
WEND_INLINE Colour all(float a) {
    return Colour{a, a, a, a};
}

// --- one colour
// -----------------------------------------------------------------------------------------------

#if defined(WEND_WIDE)
WEND_INLINE __m128i fourBytes(const std::uint8_t* p) {
    int bytes;
    std::memcpy(&bytes, p, sizeof bytes);
    return _mm_cvtsi32_si128(bytes);
}
WEND_INLINE __m128i eightBytes(const void* p) {
    return _mm_loadl_epi64(static_cast<const __m128i*>(p));
}
WEND_INLINE __m128i sixteenBytes(const void* p) {
    return _mm_loadu_si128(static_cast<const __m128i*>(p));
}

WEND_INLINE Colour widened(const std::uint8_t* p) {
    return _mm_cvtepi32_ps(_mm_cvtepu8_epi32(fourBytes(p)));
}
WEND_INLINE Colour widened(const std::uint16_t* p) {
    return _mm_cvtepi32_ps(_mm_cvtepu16_epi32(eightBytes(p)));
}
WEND_INLINE Colour widened(const half* p) {
    return _mm_cvtph_ps(eightBytes(p));
}
WEND_INLINE Colour widened(const float* p) {
    return _mm_loadu_ps(p);
}

WEND_INLINE Eight widenedTwo(__m128i bytes, std::uint8_t) {
    return {_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes))};
}
WEND_INLINE Eight widenedTwo(__m128i words, std::uint16_t) {
    return {_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(words))};
}
WEND_INLINE Eight widenedTwo(__m128i words, half) {
    return {_mm256_cvtph_ps(words)};
}

/// The pixels of N channels at p and after it.
template <int N, typename T>
WEND_INLINE Eight loadTwo(const T* p) {
    if constexpr (sizeof(T) == 4 && N == 4)
        return {_mm256_loadu_ps(p)};
    else if constexpr (sizeof(T) == 4)
        return eight(widened(p), widened(p + N));
    else if constexpr (sizeof(T) == 2)
        return widenedTwo(N == 4 ? sixteenBytes(p) : _mm_unpacklo_epi64(eightBytes(p), eightBytes(p + N)),
                          T());
    else
        return widenedTwo(N == 4 ? eightBytes(p) : _mm_unpacklo_epi32(fourBytes(p), fourBytes(p + N)), T());
}

WEND_INLINE __m128i rounded(Colour colour) {
    return _mm_cvttps_epi32(_mm_add_ps(colour, _mm_set1_ps(0.5F)));
}
WEND_INLINE void narrowed(Colour colour, std::uint8_t* p) {
    const __m128i words = _mm_packs_epi32(rounded(colour), _mm_setzero_si128());
    const int bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
    std::memcpy(p, &bytes, sizeof bytes);
}
WEND_INLINE void narrowed(Colour colour, std::uint16_t* p) {
    const __m128i words = rounded(colour);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p), _mm_packus_epi32(words, words));
}
WEND_INLINE void narrowed(Colour colour, half* p) {
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p), _mm_cvtps_ph(colour, _MM_FROUND_TO_NEAREST_INT));
}
WEND_INLINE void narrowed(Colour colour, float* p) {
    _mm_storeu_ps(p, colour);
}
#else
template <typename T>
WEND_INLINE Colour widened(const T* p) {
    return Colour{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
                  static_cast<float>(p[3])};
}
template <int N, typename T>
WEND_INLINE Eight loadTwo(const T* p) {
    return {widened(p), widened(p + N)};
}
template <typename T>
WEND_INLINE void narrowed(Colour colour, T* p) {
    for (int c = 0; c < 4; ++c) p[c] = toPixel<T>(colour[c]);
}
#endif

/// Writes the first lanes, rounded and clamped.
template <int channels, typename T>
WEND_INLINE void storeColour(Colour colour, T* p) {
    if constexpr (channels == 4) return narrowed(colour, p);
    T few[4];
    narrowed(colour, few);
    std::memcpy(static_cast<void*>(p), few, channels * sizeof(T));
}
