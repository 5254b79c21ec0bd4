#pragma once

#include <array>
#include <cstdint>

#include "warp/blend_mode.h"
#include "warp/layers.h"

namespace wend {

/// Composites colours of parts with blend modes over the samples of a pixel, 64, or 1 for colours that all
/// cover it, from the lowest one up. The colours of one part are put over one another first; then the part is
/// blended with what is below it.
template <std::size_t Samples>
class BlendedLayers {
  public:
    /// `full`: the number that represents opaque.
    BlendedLayers(const Image& layout, float full)
        : m_channels(static_cast<std::size_t>(layout.channels)),
          m_unassociated(layout.unassociated),
          m_isLight(layout.type == PixelType::Half || layout.type == PixelType::Float),
          m_hasAlpha(layout.alpha),
          m_full(static_cast<double>(full)) {}

    /// Adds a colour above all earlier ones. Those of a part follow one another.
    void put(const OutColour& colour, std::uint64_t places, int part, BlendMode mode) {
        if (part != m_part) blend();
        m_part = part, m_mode = mode;
        const Sample top = associated(colour);
        for (std::size_t s = 0; s < Samples; ++s)
            if ((places >> s & 1U) != 0)
                for (std::size_t c = 0; c <= kAlpha; ++c)
                    m_own[s][c] = top[c] + (1 - top[kAlpha]) * m_own[s][c];
    }

    OutColour colour() {
        blend();
        Sample mean{};
        for (const Sample& sample : m_below)
            for (std::size_t c = 0; c <= kAlpha; ++c) mean[c] += sample[c] / static_cast<double>(Samples);
        const double alpha = m_unassociated && mean[kAlpha] > 0 ? mean[kAlpha] : 1;
        OutColour colour{};
        for (std::size_t c = 0; c < colours(); ++c) colour[c] = static_cast<float>(m_full * mean[c] / alpha);
        if (m_hasAlpha) colour[m_channels - 1] = static_cast<float>(m_full * mean[kAlpha]);
        return colour;
    }

  private:
    static constexpr std::size_t kAlpha = 4;
    using Sample = std::array<double, kAlpha + 1>;  // colours, associated, and alpha, in [0, 1]

    std::size_t colours() const { return m_channels - (m_hasAlpha ? 1 : 0); }

    Sample associated(const OutColour& colour) const {
        Sample sample{};
        const double alpha = m_hasAlpha ? static_cast<double>(colour[m_channels - 1]) / m_full : 1;
        sample[kAlpha] = alpha < 1 ? std::max(alpha, 0.0) : 1;
        for (std::size_t c = 0; c < colours(); ++c)
            sample[c] = static_cast<double>(colour[c]) / m_full * (m_unassociated ? sample[kAlpha] : 1);
        return sample;
    }

    void blend() {
        for (std::size_t s = 0; s < Samples; ++s) {
            const double top = m_own[s][kAlpha], below = m_below[s][kAlpha];
            for (std::size_t c = 0; c < colours(); ++c)
                m_below[s][c] = blendedColour(m_mode, m_own[s][c], top, m_below[s][c], below, m_isLight);
            m_below[s][kAlpha] = top + (1 - top) * below;
            m_own[s] = {};
        }
    }

    std::size_t m_channels;
    bool m_unassociated, m_isLight, m_hasAlpha;
    double m_full;
    int m_part = -1;
    BlendMode m_mode = BlendMode::Normal;
    std::array<Sample, Samples> m_own{}, m_below{};
};

}  // namespace wend
