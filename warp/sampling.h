#pragma once

#include <array>
#include <cstddef>

#include "core/mesh/types.h"
#include "warp/pixels.h"

namespace wend {

/// A colour in the picture's own scale (0 … kFull): four lanes, those beyond the picture's channels 0.
using Colour = Eigen::Array4f;

/// The pixel at p as numbers.
template <typename T, int N>
inline Colour loadPixel(const T* p) {
    if constexpr (N == 4 && std::is_same_v<T, std::uint8_t>) {
        using Bytes = std::uint8_t __attribute__((vector_size(4)));
        using Floats = float __attribute__((vector_size(16)));
        Bytes bytes;
        std::memcpy(&bytes, p, sizeof bytes);
        const Floats floats = __builtin_convertvector(bytes, Floats);
        Colour colour;
        std::memcpy(colour.data(), &floats, sizeof floats);
        return colour;
    } else {
        Colour colour = Colour::Zero();
        for (int c = 0; c < N; ++c) colour[c] = static_cast<float>(p[c]);
        return colour;
    }
}

/// The radial cubic of Mitchell and Netravali (1988) with B = 0.3782, C = 0.3109, which keeps straight lines
/// straight, as a table over r².
class RadialKernel {
  public:
    RadialKernel() {
        for (int k = 0; k <= kSteps; ++k) m_values[k] = exact(std::sqrt(static_cast<float>(k) * 4 / kSteps));
    }
    /// r² < 4; the table's step changes the weight by less than 0.002.
    float operator()(float square) const {
        return m_values[static_cast<int>(square * (kSteps / 4.0F) + 0.5F)];
    }

  private:
    static constexpr int kSteps = 2048;
    static float exact(float r) {
        constexpr float kB = 0.3782F, kC = 0.3109F;
        if (r < 1)
            return ((12 - 9 * kB - 6 * kC) * r * r * r + (-18 + 12 * kB + 6 * kC) * r * r + (6 - 2 * kB)) / 6;
        return ((-kB - 6 * kC) * r * r * r + (6 * kB + 30 * kC) * r * r + (-12 * kB - 48 * kC) * r +
                (8 * kB + 24 * kC)) /
               6;
    }
    std::array<float, kSteps + 1> m_values;
};

/// Reads a picture of N channels of type T between its pixels; beyond its border the border's pixels go on.
/// Where colours are not associated they are weighted with alpha, so that nothing bleeds in from transparent
/// pixels; a position exactly on a pixel gives that pixel, whatever its alpha. Positions are in pixels,
/// centres at +0.5.
template <typename T, int N>
class Sampler {
  public:
    explicit Sampler(const Image& image)
        : m_data(reinterpret_cast<const T*>(image.data.data())),
          m_width(image.width),
          m_height(image.height),
          m_unassociated(image.unassociated),
          m_alpha(image.alpha) {}

    Colour nearest(double x, double y) const { return loadPixel<T, N>(clamped(floorOf(x), floorOf(y))); }

    Colour bilinear(double x, double y) const {
        const Place px(x), py(y);
        const std::array<float, 2> wx = {1 - px.t, px.t}, wy = {1 - py.t, py.t};
        return weighted<2>(px.i, py.i, wx, wy);
    }

    /// Catmull–Rom's cubic (Keys 1981, a = −½): interpolating.
    Colour bicubic(double x, double y) const {
        const Place px(x), py(y);
        return limited(weighted<4>(px.i - 1, py.i - 1, cubicWeights(px.t), cubicWeights(py.t)));
    }

    /// The mean over the ellipse {centre + J u : |u| ≤ 2} with the radial kernel of |u|; J maps destination
    /// pixels to source pixels and stretches by at least 1 in every direction. `inverse` = J⁻¹, `reach` half
    /// of the ellipse's box.
    Colour elliptical(double x, double y, const Mat<2>& inverse, const Vec<2>& reach,
                      const RadialKernel& kernel) const {
        const int x0 = floorOf(x - reach.x() + 0.5), x1 = floorOf(x + reach.x() - 0.5);
        const int y0 = floorOf(y - reach.y() + 0.5), y1 = floorOf(y + reach.y() - 0.5);
        const bool inner = x0 >= 0 && y0 >= 0 && x1 < m_width && y1 < m_height;
        const float ux = static_cast<float>(inverse(0, 0)), vx = static_cast<float>(inverse(1, 0));
        const float uy = static_cast<float>(inverse(0, 1)), vy = static_cast<float>(inverse(1, 1));
        const float dx = static_cast<float>(x0 + 0.5 - x);
        Sum sum;
        for (int j = y0; j <= y1; ++j) {
            const float dy = static_cast<float>(j + 0.5 - y);
            float u = ux * dx + uy * dy, v = vx * dx + vy * dy;
            const T* row = inner ? at(x0, j) : nullptr;
            for (int i = x0; i <= x1; ++i, u += ux, v += vx) {
                const float square = u * u + v * v;
                if (square < 4)
                    add(sum, loadPixel<T, N>(inner ? row + (i - x0) * N : clamped(i, j)), kernel(square));
            }
        }
        if (!(sum.weight > 0)) return bicubic(x, y);
        return limited(result(sum));
    }

  private:
    struct Sum {
        Colour colours = Colour::Zero(), plain = Colour::Zero();
        float weight = 0;
    };
    /// The pixel whose centre is at or before a position, and how far beyond it that is.
    struct Place {
        int i;
        float t;
        explicit Place(double x) : i(floorOf(x - 0.5)), t(static_cast<float>(x - 0.5 - i)) {}
    };

    /// std::floor is a call without SSE 4.1.
    static int floorOf(double x) {
        const int i = static_cast<int>(std::clamp(x, -1e9, 1e9));
        return i - (x < i ? 1 : 0);
    }

    const T* at(int x, int y) const { return m_data + (static_cast<std::ptrdiff_t>(y) * m_width + x) * N; }
    const T* clamped(int x, int y) const {
        return at(std::clamp(x, 0, m_width - 1), std::clamp(y, 0, m_height - 1));
    }

    void add(Sum& sum, const Colour& pixel, float w) const {
        sum.plain += w * pixel;
        sum.weight += w;
        if (m_unassociated) sum.colours += (w * pixel[N - 1]) * pixel;
    }

    /// The weighted mean; colours by alpha where it is not in them yet (and not 0).
    Colour result(const Sum& sum) const {
        Colour colour = sum.plain / sum.weight;
        if (!m_unassociated || !(sum.plain[N - 1] > 0)) return colour;
        const float alpha = colour[N - 1];
        colour = sum.colours / sum.plain[N - 1];
        colour[N - 1] = alpha;
        return colour;
    }

    /// Separable weights of Taps × Taps pixels from (x0, y0).
    template <int Taps>
    Colour weighted(int x0, int y0, const std::array<float, Taps>& wx,
                    const std::array<float, Taps>& wy) const {
        const bool inner = x0 >= 0 && y0 >= 0 && x0 + Taps <= m_width && y0 + Taps <= m_height;
        Sum sum;
        for (int j = 0; j < Taps; ++j) {
            const T* row = inner ? at(x0, y0 + j) : nullptr;
            for (int i = 0; i < Taps; ++i) {
                const float w = wx[i] * wy[j];
                const Colour pixel = loadPixel<T, N>(inner ? row + i * N : clamped(x0 + i, y0 + j));
                if (w == 1) return pixel;
                add(sum, pixel, w);
            }
        }
        sum.weight = 1;
        return result(sum);
    }

    /// Negative lobes of a filter must not make light below black or colour beyond its alpha.
    Colour limited(Colour colour) const {
        if constexpr (std::is_integral_v<T>) {
            colour = colour.max(0.0F).min(kFull<T>);
            if (m_alpha && !m_unassociated) colour = colour.min(colour[N - 1]);
        } else if (m_alpha) {
            colour[N - 1] = std::clamp(colour[N - 1], 0.0F, 1.0F);
        }
        return colour;
    }

    static std::array<float, 4> cubicWeights(float t) {
        const float s = 1 - t;
        return {-0.5F * t * s * s, 1 + t * t * (1.5F * t - 2.5F), 1 + s * s * (1.5F * s - 2.5F),
                -0.5F * s * t * t};
    }

    const T* m_data;
    int m_width, m_height;
    bool m_unassociated, m_alpha;
};

}  // namespace wend
