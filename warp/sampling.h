#pragma once

#include <array>
#include <cstddef>

#include "core/mesh/types.h"
#include "warp/lanes.h"

namespace wend {

/// The radial cubic of Mitchell and Netravali (1988) with B = 0.3782, C = 0.3109, which keeps straight lines
/// straight, as a table over r².
class RadialKernel {
  public:
    RadialKernel() {
        for (int k = 0; k <= kSteps; ++k) m_values[k] = exact(std::sqrt(static_cast<float>(k) * 4 / kSteps));
    }
    /// 0 ≤ r² ≤ 4; the table's step changes the weight by less than 0.002.
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

/// The ellipse {J u : |u| ≤ 2} of source pixels around a position, J mapping destination pixels to source
/// pixels and stretching by at least 1 in every direction: |u|² = xx dx² + 2 xy dx dy + yy dy².
struct Ellipse {
    float xx = 1, xy = 0, yy = 1;
    Vec<2> reach = Vec<2>::Constant(2);  // half of its bounding box
};

/// Reads a picture of N channels of type T between its pixels; beyond its border the border's pixels go on.
/// Where colours are not associated they are weighted with alpha, so that nothing bleeds in from transparent
/// pixels; a position exactly on a pixel gives that pixel, whatever its alpha. Positions are in pixels,
/// centres at +0.5. `inner` promises that all pixels that are needed, and one more to the right, are in the
/// picture: see inner().
template <typename T, int N>
class Sampler {
  public:
    /// `opaque`: no pixel's alpha is less than full.
    Sampler(const Image& image, bool opaque)
        : m_data(reinterpret_cast<const T*>(image.data.data())),
          m_width(image.width),
          m_height(image.height),
          m_weighted(image.unassociated && !opaque),
          m_alpha(image.alpha) {}

    /// Whether everything within `reach` of the positions of a box is in the picture.
    bool inner(const Vec<2>& low, const Vec<2>& high, const Vec<2>& reach) const {
        return low.x() - reach.x() >= 1 && low.y() - reach.y() >= 1 && high.x() + reach.x() < m_width - 2 &&
               high.y() + reach.y() < m_height - 1;
    }

    /// Brings a position that is far beyond the border (or no number) near: nothing changes but the range of
    /// the numbers.
    void bound(double& x, double& y) const {
        constexpr double kFar = 64;  // farther than any filter reaches
        x = x > -kFar ? std::min(x, m_width + kFar) : -kFar;
        y = y > -kFar ? std::min(y, m_height + kFar) : -kFar;
    }

    template <bool inner>
    Lanes nearest(double x, double y) const {
        return pixel<inner>(floorOf<inner>(x), floorOf<inner>(y));
    }

    template <bool inner>
    Lanes bilinear(double x, double y) const {
        const Place px(x, inner), py(y, inner);
        if (px.t == 0 && py.t == 0) return pixel<inner>(px.i, py.i);
        return separable<2, inner>(px.i, py.i, {1 - px.t, px.t}, {1 - py.t, py.t});
    }

    /// Catmull–Rom's cubic (Keys 1981, a = −½): interpolating.
    template <bool inner>
    Lanes bicubic(double x, double y) const {
        const Place px(x, inner), py(y, inner);
        if (px.t == 0 && py.t == 0) return pixel<inner>(px.i, py.i);
        return limited(separable<4, inner>(px.i - 1, py.i - 1, cubicWeights(px.t), cubicWeights(py.t)));
    }

    /// The mean over the ellipse with the radial kernel of |u|.
    template <bool inner>
    Lanes elliptical(double x, double y, const Ellipse& ellipse, const RadialKernel& kernel) const {
        return limited(m_weighted ? mean<inner, true>(x, y, ellipse, kernel)
                                  : mean<inner, false>(x, y, ellipse, kernel));
    }

    /// t a + (1 − t) b, by their alphas where colours are not associated.
    Lanes mixed(const Lanes& a, const Lanes& b, float t) const {
        if (!m_weighted) return t * a + (1 - t) * b;
        return unweighted<true>(t * associated(a) + (1 - t) * associated(b));
    }

  private:
    /// std::floor is a call without SSE 4.1.
    template <bool inner>
    static int floorOf(double x) {
        if constexpr (inner) return static_cast<int>(x);
        const int i = static_cast<int>(x);
        return i - (x < i ? 1 : 0);
    }

    /// Within ±1000.
    static int floorOf(float x) { return static_cast<int>(x + 1024.0F) - 1024; }

    /// The pixel whose centre is at or before a position, and how far beyond it that is.
    struct Place {
        int i;
        float t;
        Place(double x, bool inner)
            : i(inner ? floorOf<true>(x - 0.5) : floorOf<false>(x - 0.5)),
              t(static_cast<float>(x - 0.5 - i)) {}
    };

    const T* at(int x, int y) const { return m_data + (static_cast<std::ptrdiff_t>(y) * m_width + x) * N; }
    template <bool inner>
    Lanes pixel(int x, int y) const {
        if constexpr (inner) return loadColour<N, true>(at(x, y));
        return loadColour<N, false>(at(std::clamp(x, 0, m_width - 1), std::clamp(y, 0, m_height - 1)));
    }

    /// A pixel as a summand: where alpha is to weigh the colours, they are multiplied with it.
    template <bool inner, bool weighted>
    Lanes summand(int x, int y) const {
        const Lanes colour = pixel<inner>(x, y);
        if constexpr (!weighted) return colour;
        return associated(colour);
    }
    static Lanes associated(const Lanes& colour) {
        return replaced<N - 1>(colour, Lanes::Constant(kFull<T>)) * (spread<N - 1>(colour) * (1 / kFull<T>));
    }

    /// The colours of a sum of summands.
    template <bool weighted>
    static Lanes unweighted(const Lanes& sum) {
        if constexpr (!weighted) return sum;
        if (!(sum[N - 1] > 0)) return Lanes::Zero();
        return replaced<N - 1>(sum * (kFull<T> / sum[N - 1]), sum);
    }

    template <int taps, bool inner>
    Lanes separable(int x0, int y0, const std::array<float, taps>& wx,
                    const std::array<float, taps>& wy) const {
        return m_weighted ? sum<taps, inner, true>(x0, y0, wx, wy) : sum<taps, inner, false>(x0, y0, wx, wy);
    }

    template <int taps, bool inner, bool weighted>
    Lanes sum(int x0, int y0, const std::array<float, taps>& wx, const std::array<float, taps>& wy) const {
        Lanes total = Lanes::Zero();
        for (int j = 0; j < taps; ++j) {
            Lanes line = wx[0] * summand<inner, weighted>(x0, y0 + j);
            for (int i = 1; i < taps; ++i) line += wx[i] * summand<inner, weighted>(x0 + i, y0 + j);
            total += wy[j] * line;
        }
        return unweighted<weighted>(total);
    }

    /// Row by row over the chord of the ellipse: |u|² = xx (dx − middle)² + rest(dy). Places are counted from
    /// the pixel that holds the position, so that single precision is enough.
    template <bool inner, bool weighted>
    Lanes mean(double x, double y, const Ellipse& ellipse, const RadialKernel& kernel) const {
        const int px = floorOf<inner>(x), py = floorOf<inner>(y);
        const float fx = static_cast<float>(x - 0.5 - px), fy = static_cast<float>(y - 0.5 - py);
        const float slant = ellipse.xy / ellipse.xx, width = 1 / ellipse.xx;
        const float depth = ellipse.yy - ellipse.xy * slant, reach = static_cast<float>(ellipse.reach.y());
        Lanes total = Lanes::Zero();
        float weight = 0;
        const int last = floorOf(fy + reach);
        for (int j = -floorOf(reach - fy); j <= last; ++j) {
            const float dy = static_cast<float>(j) - fy, rest = depth * dy * dy;
            if (rest >= 4) continue;
            const float middle = fx - slant * dy, half = std::sqrt((4 - rest) * width);
            const int begin = -floorOf(half - middle), end = floorOf(middle + half);
            float dx = static_cast<float>(begin) - middle;
            for (int i = begin; i <= end; ++i, dx += 1) {
                const float w = kernel(std::min(4.0F, ellipse.xx * dx * dx + rest));
                total += w * summand<inner, weighted>(px + i, py + j);
                weight += w;
            }
        }
        if (!(weight > 0)) return bicubic<inner>(x, y);
        return unweighted<weighted>(total / weight);
    }

    /// Negative lobes of a filter must not make light below black or colour beyond its alpha.
    Lanes limited(Lanes colour) const {
        if constexpr (std::is_integral_v<T>) {
            colour = colour.max(0.0F).min(kFull<T>);
            if (m_alpha && !m_weighted) colour = colour.min(spread<N - 1>(colour));
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
    bool m_weighted, m_alpha;
};

}  // namespace wend
