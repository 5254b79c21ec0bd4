#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "warp/image.h"

namespace wend {

/// A colour in a picture's own scale: its channels, then alpha if one is added.
using OutColour = std::array<float, 5>;

/// Composites colours over 8 × 8 samples of a pixel: their sum in associated form, each weighted with what
/// those above let through. A single colour is unchanged.
class Layers {
  public:
    /// `full`: the number that represents opaque.
    Layers(const Image& layout, float full)
        : m_channels(static_cast<std::size_t>(layout.channels)),
          m_alpha(layout.alpha),
          m_unassociated(layout.unassociated),
          m_full(static_cast<double>(full)) {
        m_through.fill(1);
    }

    static constexpr std::uint64_t kAll = ~std::uint64_t{0};

    /// Places that nothing has covered.
    std::uint64_t bare() const { return ~m_covered; }
    /// Returns the samples that are not fully covered.
    std::uint64_t open() const { return m_open; }

    /// Adds a colour below all earlier ones.
    void put(const OutColour& colour, std::uint64_t places) {
        places &= m_open;
        if (places == 0) return;
        m_single = m_single && (m_covered & places) == 0 && (m_covered == 0 || isSame(colour, m_first));
        if (m_covered == 0) m_first = colour;
        m_covered |= places;
        const double alpha = m_alpha ? opacity(static_cast<double>(colour[m_channels - 1]) / m_full) : 1;
        add(colour, pass(places, alpha) / 64, m_unassociated ? alpha : 1);
    }

    OutColour colour() const {
        if (m_single) return m_first;
        OutColour colour{};
        const double alpha = m_unassociated ? m_sum[m_channels - 1] / m_full : 1;
        for (std::size_t c = 0; c < m_channels; ++c)
            colour[c] = static_cast<float>(isAlpha(c) || !(alpha > 0) ? m_sum[c] : m_sum[c] / alpha);
        return colour;
    }

  private:
    /// Bit by bit: what is not a number is the same as itself.
    static bool isSame(const OutColour& a, const OutColour& b) {
        return std::memcmp(a.data(), b.data(), sizeof a) == 0;
    }
    /// Returns the opacity of an alpha; NaN counts as opaque.
    static double opacity(double alpha) { return alpha < 1 ? std::max(alpha, 0.0) : 1; }
    bool isAlpha(std::size_t c) const { return m_unassociated && c == m_channels - 1; }

    /// Covers samples by `alpha`, and returns how much of them was visible.
    double pass(std::uint64_t places, double alpha) {
        double shown = 0;
        for (std::uint64_t rest = places; rest != 0; rest &= rest - 1) {
            double& through = m_through[static_cast<std::size_t>(std::countr_zero(rest))];
            shown += through;
            through *= 1 - alpha;
        }
        if (alpha >= 1) m_open &= ~places;
        return shown;
    }

    void add(const OutColour& colour, double weight, double alpha) {
        for (std::size_t c = 0; c < m_channels; ++c)
            m_sum[c] += weight * static_cast<double>(colour[c]) * (isAlpha(c) ? 1 : alpha);
    }

    std::size_t m_channels;
    bool m_alpha, m_unassociated, m_single = true;
    double m_full;
    std::uint64_t m_covered = 0, m_open = kAll;
    std::array<double, 64> m_through;  // transmittance above each sample
    std::array<double, 5> m_sum{};
    OutColour m_first{};
};

}  // namespace wend
