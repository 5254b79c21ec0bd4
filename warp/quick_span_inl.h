// Spans of pictures that move. Read once per target of Highway.

#if defined(WEND_WARP_QUICK_SPAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEND_WARP_QUICK_SPAN_INL_H
#undef WEND_WARP_QUICK_SPAN_INL_H
#else
#define WEND_WARP_QUICK_SPAN_INL_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "warp/span_task.h"

HWY_BEFORE_NAMESPACE();
namespace wend::HWY_NAMESPACE {
namespace {

#if HWY_CAP_GE256

namespace hn = hwy::HWY_NAMESPACE;

/// Bilinear colours of a span within the picture, RGBA of 8 bits: a pixel for each 64-bit lane. A lane reads
/// the two neighbours in a row at once; channels have 16 bits, in 1/128 of a level. Before it is rounded to
/// whole levels, a colour is off by less than 1/40.
class QuickSpan {
    using Lanes = hn::CappedTag<std::uint64_t, 8>;
    using Lane = hn::Vec<Lanes>;
    using Offsets = hn::RebindToSigned<Lanes>;
    using Halves = hn::Repartition<std::uint32_t, Lanes>;
    using Bytes = hn::Repartition<std::uint8_t, Lanes>;
    using Numbers = hn::Repartition<std::int16_t, Lanes>;
    using Number = hn::Vec<Numbers>;

  public:
    static constexpr int kLanes = static_cast<int>(hn::MaxLanes(Lanes()));  // pixels at a time

    HWY_ATTR explicit QuickSpan(const SpanTask& task)
        : m_base(static_cast<const std::uint64_t*>(task.level.data)),
          m_next(static_cast<const std::uint8_t*>(task.level.data) +
                 2 * 4 * static_cast<std::ptrdiff_t>(task.level.width)),
          m_rowBytes(static_cast<std::uint32_t>(task.level.width) * 4),
          m_alphas(hn::Set(Lanes(), task.level.weighted ? std::uint64_t{0xFF000000FF000000} : 0)) {
        const double across = task.left + task.scale * (task.begin + 0.5), step = across - task.anchor;
        m_x = fixed((across - (task.inRowX + task.gradientX * step)) * task.shrink - 0.5);
        m_y = fixed((task.height - (task.inRowY + task.gradientY * step)) * task.shrink - 0.5);
        m_right = fixed(task.scale * (1 - task.gradientX) * task.shrink);
        m_down = fixed(-task.scale * task.gradientY * task.shrink);
        m_rights = counted(m_right);
        m_downs = counted(m_down);
    }

    /// Paints `count` pixels from the span's pixel `at` on, kLanes at most. Returns false, and paints
    /// nothing, if colours count by their alpha and not all that are read are opaque.
    HWY_ATTR HWY_INLINE bool paint(int at, int count, std::uint8_t* to) const {
        const auto some = static_cast<std::size_t>(count);
        const Lane x = positions(m_x + at * m_right, m_rights, some),
                   y = positions(m_y + at * m_down, m_downs, some);
        const Lane offset =
            hn::MulEven(hn::BitCast(Halves(), hn::ShiftRight<32>(y)), hn::Set(Halves(), m_rowBytes)) +
            hn::ShiftLeft<2>(hn::ShiftRight<32>(x));
        const Lane below = hn::Set(Lanes(), std::uint64_t{m_rowBytes});
        const auto read = [this](Lane where) HWY_ATTR {
            return hn::GatherOffset(Lanes(), m_base, hn::BitCast(Offsets(), where));
        };
        hwy::Prefetch(m_next + (((m_y + at * m_down) >> 32) * m_rowBytes + ((m_x + at * m_right) >> 32) * 4));
        const Lane top = read(offset), bottom = read(offset + below);
        if (!hn::AllTrue(Lanes(), hn::And(hn::And(top, bottom), m_alphas) == m_alphas)) return false;
        const Number s = fraction(x), t = fraction(y);
        const Number left = between(half<0>(top), half<0>(bottom), t),
                     right = between(half<4>(top), half<4>(bottom), t);
        const Number colour = hn::ShiftRight<7>(between(left, right, s) + hn::Set(Numbers(), 64));
        const hn::Rebind<std::uint8_t, Numbers> bytes;
        const hn::Repartition<std::uint32_t, decltype(bytes)> pixels;
        const auto result = hn::BitCast(pixels, hn::DemoteTo(bytes, colour));
        auto* const out = reinterpret_cast<std::uint32_t*>(to);
        if (count == kLanes)
            hn::StoreU(result, pixels, out);
        else
            hn::BlendedStore(result, hn::FirstN(pixels, some), pixels, out);
        return true;
    }

  private:
    /// Returns a fixed-point number with 32 bits behind the point.
    HWY_ATTR HWY_INLINE static std::int64_t fixed(double number) {
        return static_cast<std::int64_t>(number * 4294967296.0);
    }
    /// Returns as many steps for each lane as its number, whose bits select multiples.
    HWY_ATTR HWY_INLINE static Lane counted(std::int64_t step) {
        const Lane number = hn::Iota(Lanes(), 0), one = hn::Set(Lanes(), static_cast<std::uint64_t>(step));
        const auto times = [number, one](auto bit) HWY_ATTR {
            const Lane isSet = hn::Set(Lanes(), std::uint64_t{1} << bit());
            return hn::IfThenElseZero(hn::And(number, isSet) == isSet, hn::ShiftLeft<bit()>(one));
        };
        return times(std::integral_constant<int, 0>()) + times(std::integral_constant<int, 1>()) +
               times(std::integral_constant<int, 2>());
    }
    /// Lanes that are not painted read where the first one does.
    HWY_ATTR HWY_INLINE static Lane positions(std::int64_t first, Lane steps, std::size_t count) {
        const Lane begin = hn::Set(Lanes(), static_cast<std::uint64_t>(first));
        return begin + (count == kLanes ? steps : hn::IfThenElseZero(hn::FirstN(Lanes(), count), steps));
    }
    /// Returns the part behind the point for all four channels, as a number of 15 bits.
    HWY_ATTR HWY_INLINE static Number fraction(Lane position) {
        HWY_ALIGN static constexpr std::uint8_t kOrder[16] = {2,  3,  2,  3,  2,  3,  2,  3,
                                                              10, 11, 10, 11, 10, 11, 10, 11};
        const auto order = hn::LoadDup128(Bytes(), kOrder);
        const hn::RebindToUnsigned<Numbers> whole;
        const auto bits = hn::BitCast(whole, hn::TableLookupBytes(hn::BitCast(Bytes(), position), order));
        return hn::BitCast(Numbers(), hn::ShiftRight<1>(bits));
    }
    /// Returns the channels of the left or the right neighbour.
    template <int from>
    HWY_ATTR HWY_INLINE static Number half(Lane two) {
        HWY_ALIGN static constexpr std::uint8_t kOrder[16] = {from,      128, from + 1,  128, from + 2, 128,
                                                              from + 3,  128, from + 8,  128, from + 9, 128,
                                                              from + 10, 128, from + 11, 128};
        const auto order = hn::LoadDup128(Bytes(), kOrder);
        const auto bytes = hn::TableLookupBytesOr0(hn::BitCast(Bytes(), two), order);
        return hn::ShiftLeft<7>(hn::BitCast(Numbers(), bytes));
    }
    HWY_ATTR HWY_INLINE static Number between(Number a, Number b, Number part) {
        return a + hn::MulFixedPoint15(b - a, part);
    }

    const std::uint64_t* m_base;
    const std::uint8_t* m_next;  // two rows below: read ahead, for the span below
    std::uint32_t m_rowBytes;
    Lane m_alphas;
    std::int64_t m_x, m_y, m_right, m_down;
    Lane m_rights, m_downs;  // for each lane as many steps as its number
};

#endif

}  // namespace
}  // namespace wend::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
