// The filters, and spans painted with them. Read once per target of Highway. Nothing of the standard library
// or of Eigen is used here: an inline function compiled for newer machines only might be linked for all.

#if defined(WEND_WARP_SPAN_FILTERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEND_WARP_SPAN_FILTERS_INL_H
#undef WEND_WARP_SPAN_FILTERS_INL_H
#else
#define WEND_WARP_SPAN_FILTERS_INL_H
#endif

#include "warp/careful_sample.h"
#include "warp/quick_span_inl.h"
#include "warp/span_lanes_inl.h"
#include "warp/span_task.h"

HWY_BEFORE_NAMESPACE();
namespace wend::HWY_NAMESPACE {
namespace {

// Emulated vectors take minutes to compile where all is inlined.
#undef WEND_SPAN_INLINE
#if HWY_TARGET == HWY_EMU128
#define WEND_SPAN_INLINE HWY_NOINLINE
#else
#define WEND_SPAN_INLINE HWY_ATTR HWY_INLINE
#endif

constexpr int kFarthestReach = 32;  // of an ellipse, in pixels of its level

/// Pixels in memory from one on, and the step to the next row.
template <typename T>
struct Window {
    const T* first;
    std::ptrdiff_t stride;
    HWY_ATTR HWY_INLINE const T* row(int j) const { return first + j * stride; }
};

/// Room for the window of one pixel at the border.
template <typename T, int N>
struct Patch {
    static constexpr int kColumns = 2 * kFarthestReach + 4;
    T pixels[(2 * kFarthestReach + 2) * kColumns * N + 4];
};

HWY_ATTR HWY_INLINE int clamped(int i, int size) {
    return i < 0 ? 0 : i < size ? i : size - 1;
}

/// Copies a window of pixels. Beyond the border of a picture, the border's pixels continue.
template <typename T, int N>
HWY_ATTR HWY_NOINLINE void copyWindow(const TexelLevel& level, int x, int y, int columns, int rows,
                                      T* pixels) {
    const T* data = static_cast<const T*>(level.data);
    for (int j = 0; j < rows; ++j) {
        const T* from = data + static_cast<std::ptrdiff_t>(clamped(y + j, level.height)) * level.width * N;
        T* to = pixels + j * Patch<T, N>::kColumns * N;
        for (int i = 0; i < columns; ++i)
            for (int c = 0; c < N; ++c) to[i * N + c] = from[clamped(x + i, level.width) * N + c];
    }
}

/// A level of a picture of N channels of type T. Reading a window may read up to four numbers beyond each of
/// its rows.
template <typename T, int N>
class Texels {
  public:
    HWY_ATTR HWY_INLINE Texels(const SpanTask& task, T* patch)
        : m_task(task),
          m_data(static_cast<const T*>(task.level.data)),
          m_stride(static_cast<std::ptrdiff_t>(task.level.width) * N),
          m_inner(task.inner),
          m_patch(patch) {}

    HWY_ATTR HWY_INLINE Window<T> window(int x, int y, int columns, int rows) const {
        if (m_inner) return {m_data + y * m_stride + static_cast<std::ptrdiff_t>(x) * N, m_stride};
        copyWindow<T, N>(m_task.level, x, y, columns, rows, m_patch);
        return {m_patch, Patch<T, N>::kColumns * N};
    }

  private:
    const SpanTask& m_task;
    const T* m_data;
    std::ptrdiff_t m_stride;
    bool m_inner;
    T* m_patch;
};

/// Colours between pixels: (i, j) is the pixel at or before the position, (s, t) how far beyond its centre
/// that is. Where colours are not associated they count by their alpha, so that nothing bleeds in from
/// transparent pixels; a position exactly on a pixel gives that pixel, whatever its alpha.
template <typename T, int N, bool weighted>
class Filters {
  public:
    HWY_ATTR HWY_INLINE Filters(const SpanTask& task, T* patch)
        : m_texels(task, patch),
          m_alpha(task.level.alpha),
          m_xx(task.xx),
          m_xy(task.xy),
          m_yy(task.yy),
          m_blend(task.blend),
          m_reachX(task.reachX),
          m_reachY(task.reachY) {}

    HWY_ATTR HWY_INLINE Colour nearest(int i, int j) const {
        return widened(m_texels.window(i, j, 1, 1).first);
    }

    WEND_SPAN_INLINE Colour bilinear(int i, int j, float s, float t) const {
        const Window<T> w = m_texels.window(i, j, 2, 2);
        if (s == 0 && t == 0) return widened(w.first);
        const Eight top = summands(w.row(0)), bottom = summands(w.row(1));
        const Eight column = top + eight(t) * (bottom - top);
        return colour(low(column) + all(s) * (high(column) - low(column)));
    }

    /// Interpolates by Catmull–Rom's cubic (Keys 1981, a = −½).
    WEND_SPAN_INLINE Colour bicubic(int i, int j, float s, float t) const {
        const Window<T> w = m_texels.window(i - 1, j - 1, 4, 4);
        if (s == 0 && t == 0) return widened(w.row(1) + N);
        float x[4], y[4];
        cubicWeights(s, x);
        cubicWeights(t, y);
        const Eight left = eight(all(x[0]), all(x[1])), right = eight(all(x[2]), all(x[3]));
        Eight sum = eight(y[0]) * cubicRow(w.row(0), left, right);
        for (int k = 1; k < 4; ++k) sum = sum + eight(y[k]) * cubicRow(w.row(k), left, right);
        return limited(colour(low(sum) + high(sum)));
    }

    /// Returns the mean over an ellipse, blended into the cubic where the ellipse is nearly the unit circle.
    HWY_ATTR HWY_INLINE Colour ewa(int i, int j, float s, float t) const {
        Colour soft = all(0);
        const bool found = m_blend != 0 && elliptical(i, j, s, t, soft);
        if (found && m_blend == 1) return soft;
        const Colour sharp = bicubic(i, j, s, t);
        return found ? mixed(soft, sharp) : sharp;
    }

  private:
    // --- colours that count by their alpha
    // --------------------------------------------------------------------

    HWY_ATTR HWY_INLINE static Eight associated(Eight two) {
        if constexpr (!weighted) return two;
        return lastReplaced<N>(two, eight(kFull<T>)) * (spread<N - 1>(two) * eight(1 / kFull<T>));
    }
    WEND_SPAN_INLINE static Eight summands(const T* p) { return associated(loadTwo<N>(p)); }

    /// Returns the colour of a sum of summands.
    WEND_SPAN_INLINE static Colour colour(Colour sum) {
        if constexpr (!weighted) return sum;
        const float alpha = hn::ExtractLane(sum, N - 1);
        if (!(alpha > 0)) return all(0);
        return hn::InsertLane(sum * all(kFull<T> / alpha), N - 1, alpha);
    }

    WEND_SPAN_INLINE Colour mixed(Colour a, Colour b) const {
        const Eight parts = associated(eight(a, b)) * eight(all(m_blend), all(1 - m_blend));
        return colour(low(parts) + high(parts));
    }

    /// Negative lobes of a filter must not make light below black or colour beyond its alpha: where alpha
    /// overshoots, associated colours shrink with it. Half and float numbers see sampleCarefully().
    WEND_SPAN_INLINE Colour limited(Colour value) const {
        if constexpr (std::is_integral_v<T>) {
            if (!weighted && m_alpha) {
                const float alpha = hn::ExtractLane(value, N - 1);
                if (alpha > kFull<T>) value = value * all(kFull<T> / alpha);
            }
            value = hn::Min(hn::Max(value, all(0)), all(kFull<T>));
            if (!weighted && m_alpha) value = hn::Min(value, hn::Broadcast<N - 1>(value));
        }
        return value;
    }

    // --- cubic
    // ------------------------------------------------------------------------------------------------

    HWY_ATTR HWY_INLINE static void cubicWeights(float t, float* w) {
        const float s = 1 - t;
        w[0] = -0.5F * t * s * s, w[3] = -0.5F * s * t * t;
        w[1] = 1 + t * t * (1.5F * t - 2.5F), w[2] = 1 + s * s * (1.5F * s - 2.5F);
    }
    HWY_ATTR HWY_INLINE static Eight cubicRow(const T* p, Eight left, Eight right) {
        return left * summands(p) + right * summands(p + 2 * N);
    }

    // --- elliptical
    // -------------------------------------------------------------------------------------------

    /// Returns the radial cubic of Mitchell and Netravali (1988) with B = 0.3782, C = 0.3109, which keeps
    /// straight lines straight, within 0.004 as a polynomial of q = r² that ends smoothly at r = 2.
    WEND_SPAN_INLINE static Eight kernel(Eight q) {
        const Eight rest = eight(4) - smaller(q, eight(4));
        const Eight inner =
            ((eight(-0.00488379426F) * q + eight(0.031282487F)) * q - eight(0.0738093829F)) * q +
            eight(0.0543943942F);
        return rest * rest * inner;
    }

    struct Sum {
        Eight colours, weights;
    };

    /// Returns whether any pixel weighs something.
    WEND_SPAN_INLINE bool elliptical(int i, int j, float s, float t, Colour& mean) const {
        Sum sum{eight(0), eight(0)};
        if (m_reachX <= 1 && m_reachY <= 1)
            addBox<1>(i, j, s, t, sum);
        else if (m_reachX <= 2 && m_reachY <= 2)
            addBox<2>(i, j, s, t, sum);
        else if (m_reachX <= 3 && m_reachY <= 3)
            addBox<3>(i, j, s, t, sum);
        else
            addChords(i, j, s, t, sum);
        const Colour four = low(sum.weights) + high(sum.weights);
        const float weight = hn::GetLane(hn::SumOfLanes(Four(), four));
        if (!(weight > 0)) return false;
        mean = limited(colour((low(sum.colours) + high(sum.colours)) * all(1 / weight)));
        return true;
    }

    /// Adds all pixels of a box that holds the ellipse, from `reach` before the pixel (i, j) to reach + 1
    /// after it.
    template <int reach>
    WEND_SPAN_INLINE void addBox(int i, int j, float s, float t, Sum& sum) const {
        constexpr int kSize = 2 * reach + 2;
        const Window<T> w = m_texels.window(i - reach, j - reach, kSize, kSize);
        const Eight dx = counted() - eight(static_cast<float>(reach) + s);
        const Eight square = eight(m_xx) * dx * dx, slant = eight(2 * m_xy) * dx;
        for (int k = 0; k < kSize; ++k) {
            const float dy = static_cast<float>(k - reach) - t;
            const Eight weights = kernel(square + (slant * eight(dy) + eight(m_yy * dy * dy)));
            const T* p = w.row(k);
            Eight line = spreadTwo<0>(weights) * summands(p) + spreadTwo<1>(weights) * summands(p + 2 * N);
            if constexpr (kSize > 4) line = line + spreadTwo<2>(weights) * summands(p + 4 * N);
            if constexpr (kSize > 6) line = line + spreadTwo<3>(weights) * summands(p + 6 * N);
            sum.colours = sum.colours + line;
            sum.weights = sum.weights + weights;
        }
    }

    /// Adds row by row over the chord of the ellipse: q = xx (dx − middle)² + rest(dy).
    HWY_ATTR HWY_INLINE void addChords(int i, int j, float s, float t, Sum& sum) const {
        const int last = 2 * m_reachX + 1;
        const Window<T> w = m_texels.window(i - m_reachX, j - m_reachY, last + 2, 2 * m_reachY + 2);
        const float slant = m_xy / m_xx, depth = m_yy - m_xy * slant;
        for (int k = 0; k < 2 * m_reachY + 2; ++k) {
            const float dy = static_cast<float>(k - m_reachY) - t, rest = depth * dy * dy;
            if (rest >= 4) continue;
            const float middle = static_cast<float>(m_reachX) + s - slant * dy;
            const float half = __builtin_sqrtf((4 - rest) / m_xx);
            const int begin = middle > half ? static_cast<int>(middle - half) : 0;
            const int end = middle + half < static_cast<float>(last) ? static_cast<int>(middle + half) : last;
            for (int x = begin; x <= end; x += 8)
                addEight(w.row(k) + x * N, static_cast<float>(x) - middle, rest, end - x, sum);
        }
    }

    /// Adds up to eight pixels from p on; the one at p is dx from the middle of the chord, and those after
    /// the first 1 + `more` weigh nothing.
    WEND_SPAN_INLINE void addEight(const T* p, float dx, float rest, int more, Sum& sum) const {
        const Eight across = counted() + eight(dx);
        const Eight weights = kernel(eight(m_xx) * across * across + eight(rest));
        sum.weights = sum.weights + weights;
        sum.colours = sum.colours + spreadTwo<0>(weights) * summands(p);
        if (more >= 2) sum.colours = sum.colours + spreadTwo<1>(weights) * summands(p + 2 * N);
        if (more >= 4) sum.colours = sum.colours + spreadTwo<2>(weights) * summands(p + 4 * N);
        if (more >= 6) sum.colours = sum.colours + spreadTwo<3>(weights) * summands(p + 6 * N);
    }

    Texels<T, N> m_texels;
    bool m_alpha;
    float m_xx, m_xy, m_yy, m_blend;
    int m_reachX, m_reachY;
};

/// The sources of the pixels of a piece of a span.
struct Places {
    static constexpr int kSize = 32;
    int i[kSize], j[kSize];    // the pixel at or before
    float s[kSize], t[kSize];  // how far beyond its centre, in [0, 1)
};

/// Locates `count` pixels (eight at a time, which may be some more) from `begin` on; `half` is ½ for pixels'
/// centres, 0 for their corners. Positions far outside (or NaN) are moved near the picture, which only limits
/// the range of the numbers.
HWY_ATTR HWY_INLINE void locate(const SpanTask& task, int begin, int count, double half, Places& places) {
    constexpr double kFar = 64;
    const double left = task.left, scale = task.scale, anchor = task.anchor, height = task.height;
    const double rowX = task.inRowX, rowY = task.inRowY, gradientX = task.gradientX,
                 gradientY = task.gradientY, shrink = task.shrink;
    const double right = task.level.width + kFar, bottom = task.level.height + kFar;
    for (int eighth = 0; eighth < count; eighth += 8)
        for (int k = eighth; k < eighth + 8; ++k) {
            const double across = left + scale * (begin + k + 0.5), step = across - anchor;
            double x = (across - (rowX + gradientX * step)) * shrink - half;
            double y = (height - (rowY + gradientY * step)) * shrink - half;
            x = x > -kFar ? x : -kFar, x = x < right ? x : right;
            y = y > -kFar ? y : -kFar, y = y < bottom ? y : bottom;
            int i = static_cast<int>(x), j = static_cast<int>(y);
            i -= x < i ? 1 : 0, j -= y < j ? 1 : 0;
            places.i[k] = i, places.j[k] = j;
            places.s[k] = static_cast<float>(x - i), places.t[k] = static_cast<float>(y - j);
        }
}

template <typename T, int N, Filter F>
class SpanPainter {
  public:
    HWY_ATTR static void paint(const SpanTask& task, SpanOutput output, void* to) {
        if constexpr (N % 2 == 0 && F != Filter::Nearest) {
            if (task.isQuick && task.inner && output == SpanOutput::Pixels)
                return paintQuickly(task, static_cast<T*>(to));
            if (task.level.weighted) return paintPieces<true>(task, output, static_cast<T*>(to));
        }
        paintPieces<false>(task, output, static_cast<T*>(to));
    }

  private:
    static constexpr double kHalf = F == Filter::Nearest ? 0 : 0.5;

    HWY_ATTR static void paintExactly(const SpanTask& task, T* to) {
        task.level.weighted ? paintPieces<true>(task, SpanOutput::Pixels, to)
                            : paintPieces<false>(task, SpanOutput::Pixels, to);
    }

    HWY_ATTR static void paintQuickly(const SpanTask& task, T* to) {
#if HWY_CAP_GE256
        if constexpr (std::is_same_v<T, std::uint8_t> && N == 4 && F == Filter::Bilinear) {
            const QuickSpan span(task);
            const int count = task.end - task.begin;
            for (int at = 0; at < count; at += QuickSpan::kLanes, to += QuickSpan::kLanes * N) {
                const int some = count - at < QuickSpan::kLanes ? count - at : QuickSpan::kLanes;
                if (span.paint(at, some, to)) continue;
                SpanTask piece = task;
                piece.begin = task.begin + at, piece.end = piece.begin + some;
                paintExactly(piece, to);
            }
            return;
        }
#endif
        paintExactly(task, to);
    }

    template <bool weighted>
    HWY_ATTR HWY_INLINE static Colour colourAt(const Filters<T, N, weighted>& filters, const Places& at,
                                               int k) {
        if constexpr (F == Filter::Nearest) return filters.nearest(at.i[k], at.j[k]);
        if constexpr (F == Filter::Bilinear) return filters.bilinear(at.i[k], at.j[k], at.s[k], at.t[k]);
        if constexpr (F == Filter::Bicubic) return filters.bicubic(at.i[k], at.j[k], at.s[k], at.t[k]);
        if constexpr (F == Filter::Ewa) return filters.ewa(at.i[k], at.j[k], at.s[k], at.t[k]);
    }

    /// Returns whether the filter may have made of half or float numbers what sampleCarefully() corrects.
    /// Alpha may miss 1 by rounding.
    template <bool weighted>
    HWY_ATTR HWY_INLINE static bool isDoubtful(const SpanTask& task, Colour& colour) {
        constexpr float kLargest = sizeof(T) == 2 ? 65504.0F : 3.4e38F, kRounding = 1e-5F;
        const bool alpha = task.level.alpha;
        const Colour own = N == 4 ? colour : hn::IfThenElseZero(hn::FirstN(Four(), N), colour);
        if (!hn::AllTrue(Four(), hn::And(own >= all(0), own <= all(kLargest)))) return true;
        const bool isNothing = hn::AllTrue(Four(), own == all(0));
        if (F == Filter::Bilinear || !alpha) return weighted && isNothing;
        if (isNothing) return weighted;
        const float beyond = hn::ExtractLane(colour, N - 1) - 1;
        if (beyond > 0 && beyond <= kRounding) colour = hn::InsertLane(colour, N - 1, 1.0F);
        return !(beyond >= -kRounding && beyond <= kRounding);
    }

    template <bool weighted>
    HWY_ATTR HWY_INLINE static Colour settled(const SpanTask& task, const Places& at, int k, Colour colour) {
        if constexpr (!std::is_integral_v<T> && F != Filter::Nearest) {
            const bool isSoft = F == Filter::Ewa && task.blend > 0;
            const bool isPixel = at.s[k] == 0 && at.t[k] == 0 && !isSoft;
            if (isPixel || !isDoubtful<weighted>(task, colour)) return colour;
            float numbers[4];
            hn::StoreU(colour, Four(), numbers);
            sampleCarefully<T>(task, F, N, at.i[k], at.j[k], at.s[k], at.t[k], numbers);
            colour = hn::LoadU(Four(), numbers);
        }
        return colour;
    }

    /// Returns where the next pixel begins.
    HWY_ATTR HWY_INLINE static T* put(Colour colour, bool addsAlpha, T* to) {
        constexpr int kMore = N == 4 ? N : N + 1;
        if (!addsAlpha) return storeColour<N>(colour, to), to + N;
        if constexpr (kMore > N) colour = hn::InsertLane(colour, N % 4, kFull<T>);
        storeColour<kMore>(colour, to);
        return to + kMore;
    }

    template <bool weighted>
    HWY_ATTR HWY_NOINLINE static void paintPieces(const SpanTask& task, SpanOutput output, T* to) {
        Patch<T, N> patch;
        Places places;
        const Filters<T, N, weighted> filters(task, patch.pixels);
        const int last = task.end;
        const bool addsAlpha = task.addsAlpha;
        for (int begin = task.begin; begin < last; begin += Places::kSize) {
            const int count = last - begin < Places::kSize ? last - begin : Places::kSize;
            locate(task, begin, count, kHalf, places);
            for (int k = 0; k < count; ++k) {
                const Colour colour = settled<weighted>(task, places, k, colourAt(filters, places, k));
                if (output == SpanOutput::Colour)
                    return hn::StoreU(colour, Four(), reinterpret_cast<float*>(to));
                to = put(colour, addsAlpha, to);
            }
        }
    }
};

template <typename T, int N>
HWY_ATTR PaintSpan spanPainter(Filter filter) {
    switch (filter) {
        case Filter::Nearest:
            return SpanPainter<T, N, Filter::Nearest>::paint;
        case Filter::Bilinear:
            return SpanPainter<T, N, Filter::Bilinear>::paint;
        case Filter::Bicubic:
            return SpanPainter<T, N, Filter::Bicubic>::paint;
        case Filter::Ewa:
            return SpanPainter<T, N, Filter::Ewa>::paint;
    }
    return nullptr;
}

template <typename T>
HWY_ATTR PaintSpan spanPainter(int channels, Filter filter) {
    switch (channels) {
        case 1:
            return spanPainter<T, 1>(filter);
        case 2:
            return spanPainter<T, 2>(filter);
        case 3:
            return spanPainter<T, 3>(filter);
        default:
            return spanPainter<T, 4>(filter);
    }
}

}  // namespace
}  // namespace wend::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
