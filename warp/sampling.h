#pragma once

#include <array>
#include <vector>

#include "core/mesh/types.h"
#include "warp/pixels.h"

namespace wend {

/// A colour in the picture's own scale (0 … kFull), in the picture's own convention of alpha.
using Colour = std::array<float, 4>;

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

    Colour nearest(double x, double y) const {
        Colour colour{};
        const T* p = pixel(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
        for (int c = 0; c < N; ++c) colour[c] = static_cast<float>(p[c]);
        return colour;
    }

    Colour bilinear(double x, double y) const {
        const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5);
        const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
        const float tx = static_cast<float>(x - 0.5 - fx), ty = static_cast<float>(y - 0.5 - fy);
        const T* p[4] = {pixel(ix, iy), pixel(ix + 1, iy), pixel(ix, iy + 1), pixel(ix + 1, iy + 1)};
        const float w[4] = {(1 - tx) * (1 - ty), tx * (1 - ty), (1 - tx) * ty, tx * ty};
        if (m_unassociated) return weighted<4>(p, w);
        Colour colour{};
        for (int c = 0; c < N; ++c)
            colour[c] = w[0] * static_cast<float>(p[0][c]) + w[1] * static_cast<float>(p[1][c]) +
                        w[2] * static_cast<float>(p[2][c]) + w[3] * static_cast<float>(p[3][c]);
        return colour;
    }

    /// Catmull–Rom's cubic (Keys 1981, a = −½): interpolating.
    Colour bicubic(double x, double y) const {
        const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5);
        const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
        const auto wx = cubicWeights(static_cast<float>(x - 0.5 - fx)),
                   wy = cubicWeights(static_cast<float>(y - 0.5 - fy));
        const T* p[16];
        float w[16];
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                p[4 * j + i] = pixel(ix - 1 + i, iy - 1 + j);
                w[4 * j + i] = wx[i] * wy[j];
            }
        return limited(weighted<16>(p, w));
    }

    /// The mean over the ellipse {centre + J u : |u| ≤ 2} with a radial cubic of |u| (Mitchell and Netravali
    /// 1988, with B = 0.3782, C = 0.3109, which keeps straight lines straight); J maps destination pixels to
    /// source pixels and stretches by at least 1 in every direction.
    Colour elliptical(double x, double y, const Mat<2>& inverse, const Vec<2>& reach) const {
        const int x0 = static_cast<int>(std::ceil(x - reach.x() - 0.5)),
                  x1 = static_cast<int>(std::floor(x + reach.x() - 0.5));
        const int y0 = static_cast<int>(std::ceil(y - reach.y() - 0.5)),
                  y1 = static_cast<int>(std::floor(y + reach.y() - 0.5));
        Sum sum;
        for (int j = y0; j <= y1; ++j) {
            const double dy = j + 0.5 - y;
            for (int i = x0; i <= x1; ++i) {
                const double dx = i + 0.5 - x;
                const double u = inverse(0, 0) * dx + inverse(0, 1) * dy,
                             v = inverse(1, 0) * dx + inverse(1, 1) * dy;
                const double square = u * u + v * v;
                if (square < 4) add(sum, pixel(i, j), radialWeight(static_cast<float>(std::sqrt(square))));
            }
        }
        return sum.weight == 0 ? bicubic(x, y) : limited(result(sum));
    }

  private:
    struct Sum {
        Colour colours{}, plain{};
        float weight = 0, alpha = 0;
    };

    const T* pixel(int x, int y) const {
        x = std::clamp(x, 0, m_width - 1);
        y = std::clamp(y, 0, m_height - 1);
        return m_data + (static_cast<std::size_t>(y) * m_width + x) * N;
    }

    void add(Sum& sum, const T* p, float w) const {
        const float a = m_unassociated ? w * static_cast<float>(p[N - 1]) : w;
        for (int c = 0; c < N; ++c) {
            sum.colours[c] += a * static_cast<float>(p[c]);
            sum.plain[c] += w * static_cast<float>(p[c]);
        }
        sum.weight += w;
        sum.alpha += a;
    }

    Colour result(const Sum& sum) const {
        Colour colour = sum.plain;
        for (float& c : colour) c /= sum.weight;
        if (!m_unassociated || sum.alpha <= 0) return colour;
        for (int c = 0; c < N - 1; ++c) colour[c] = sum.colours[c] / sum.alpha;
        return colour;
    }

    template <int Taps>
    Colour weighted(const T* const* p, const float* w) const {
        Sum sum;
        for (int k = 0; k < Taps; ++k) {
            if (w[k] == 1) return exactly(p[k]);
            add(sum, p[k], w[k]);
        }
        sum.weight = 1;
        return result(sum);
    }

    static Colour exactly(const T* p) {
        Colour colour{};
        for (int c = 0; c < N; ++c) colour[c] = static_cast<float>(p[c]);
        return colour;
    }

    /// Negative lobes of a filter must not make light below black or colour beyond its alpha.
    Colour limited(Colour colour) const {
        if constexpr (std::is_integral_v<T>)
            for (float& c : colour) c = std::clamp(c, 0.0F, kFull<T>);
        if (m_alpha && !m_unassociated && std::is_integral_v<T>)
            for (int c = 0; c < N - 1; ++c) colour[c] = std::min(colour[c], colour[N - 1]);
        if (m_alpha && !std::is_integral_v<T>) colour[N - 1] = std::clamp(colour[N - 1], 0.0F, 1.0F);
        return colour;
    }

    static std::array<float, 4> cubicWeights(float t) {
        const float s = 1 - t;
        return {-0.5F * t * s * s, 1 + t * t * (1.5F * t - 2.5F), 1 + s * s * (1.5F * s - 2.5F),
                -0.5F * s * t * t};
    }

    static float radialWeight(float r) {
        constexpr float kB = 0.3782F, kC = 0.3109F;
        if (r < 1)
            return ((12 - 9 * kB - 6 * kC) * r * r * r + (-18 + 12 * kB + 6 * kC) * r * r + (6 - 2 * kB)) / 6;
        return ((-kB - 6 * kC) * r * r * r + (6 * kB + 30 * kC) * r * r + (-12 * kB - 48 * kC) * r +
                (8 * kB + 24 * kC)) /
               6;
    }

    const T* m_data;
    int m_width, m_height;
    bool m_unassociated, m_alpha;
};

}  // namespace wend
