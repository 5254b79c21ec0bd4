#include "warp/careful_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "warp/pixels.h"

namespace wend {
namespace {

using Lanes = std::array<float, 4>;

struct Range {
    float low = std::numeric_limits<float>::infinity(), high = -low;

    void add(float value) { low = std::min(low, value), high = std::max(high, value); }
    bool empty() const { return low > high; }
    /// Returns the value within the range; NaN becomes `low`.
    float clamped(float value) const { return std::min(high, std::max(low, value)); }
};

/// Returns Catmull–Rom's weights (Keys 1981, a = −½) of the pixels −1 … 2.
std::array<float, 4> cubicWeights(float t) {
    const float s = 1 - t;
    return {-0.5F * t * s * s, 1 + t * t * (1.5F * t - 2.5F), 1 + s * s * (1.5F * s - 2.5F),
            -0.5F * s * t * t};
}

/// Returns the elliptical kernel of span_filters_inl.h at q = r².
float radial(float q) {
    const float rest = 4 - std::min(q, 4.0F);
    return rest * rest * (((-0.00488379426F * q + 0.031282487F) * q - 0.0738093829F) * q + 0.0543943942F);
}

/// The weights of a filter over a window of pixels around (i, j).
class Weights {
  public:
    Weights(const SpanTask& task, Filter filter, float s, float t)
        : m_task(task), m_s(s), m_t(t), m_cubicX(cubicWeights(s)), m_cubicY(cubicWeights(t)) {
        if (filter == Filter::Bilinear) m_before = {0, 0}, m_isCubic = false;
        if (filter == Filter::Ewa && task.blend > 0) takeEllipse();
    }
    const std::array<int, 2>& before() const { return m_before; }
    /// Returns the weight of the pixel (i + x, j + y).
    float at(int x, int y) const {
        if (!m_isCubic) return (x == 0 ? 1 - m_s : m_s) * (y == 0 ? 1 - m_t : m_t);
        float weight = 0;
        if (x >= -1 && x <= 2 && y >= -1 && y <= 2)
            weight = m_cubicShare * m_cubicX[static_cast<std::size_t>(x + 1)] *
                     m_cubicY[static_cast<std::size_t>(y + 1)];
        return m_ellipseShare > 0 ? weight + m_ellipseShare * ellipse(x, y) : weight;
    }

  private:
    float ellipse(int x, int y) const {
        const float dx = static_cast<float>(x) - m_s, dy = static_cast<float>(y) - m_t;
        return radial(m_task.xx * dx * dx + 2 * m_task.xy * dx * dy + m_task.yy * dy * dy);
    }
    void takeEllipse() {
        m_before = {std::max(1, m_task.reachX), std::max(1, m_task.reachY)};
        float sum = 0;
        for (int y = -m_before[1]; y <= m_before[1] + 1; ++y)
            for (int x = -m_before[0]; x <= m_before[0] + 1; ++x) sum += ellipse(x, y);
        if (!(sum > 0)) return;
        m_ellipseShare = m_task.blend / sum, m_cubicShare = 1 - m_task.blend;
    }

    const SpanTask& m_task;
    float m_s, m_t;
    std::array<float, 4> m_cubicX, m_cubicY;
    std::array<int, 2> m_before = {1, 1};  // pixels of the window before (i, j); one more is after it
    bool m_isCubic = true;
    float m_cubicShare = 1, m_ellipseShare = 0;
};

template <typename T>
class Level {
  public:
    Level(const TexelLevel& level, int channels) : m_level(level), m_channels(channels) {}
    /// Returns the pixel (x, y), or the nearest one of the border.
    Lanes at(int x, int y) const {
        const T* p = static_cast<const T*>(m_level.data) +
                     (static_cast<std::ptrdiff_t>(std::clamp(y, 0, m_level.height - 1)) * m_level.width +
                      std::clamp(x, 0, m_level.width - 1)) *
                         m_channels;
        Lanes values{};
        for (int c = 0; c < m_channels; ++c) values[static_cast<std::size_t>(c)] = static_cast<float>(p[c]);
        return values;
    }
    bool isFinite(const Lanes& values) const {
        return std::all_of(values.begin(), values.begin() + m_channels,
                           [](float value) { return std::isfinite(value); });
    }
    float alpha(const Lanes& values) const {
        return m_level.alpha ? values[static_cast<std::size_t>(m_channels) - 1] : 1;
    }
    std::size_t colours() const { return static_cast<std::size_t>(m_channels) - (m_level.alpha ? 1 : 0); }
    bool isStraight() const { return m_level.weighted; }

  private:
    const TexelLevel& m_level;
    int m_channels;
};

/// The sums of sampleCarefully(), and the ranges that bound them.
template <typename T>
class BoundedSum {
  public:
    explicit BoundedSum(const Level<T>& level) : m_level(level) {}

    void add(const Lanes& values, float weight) {
        if (weight == 0) return;
        if (!m_level.isFinite(values)) {
            m_isBroken = true;
            return;
        }
        const float alpha = m_level.alpha(values);
        m_weight += weight;
        m_alpha += weight * alpha;
        m_alphas.add(alpha);
        for (std::size_t c = 0; c < m_level.colours(); ++c) addColour(m_colours[c], values[c], alpha, weight);
    }
    /// Returns whether the weights added so far are enough to determine a colour.
    bool isSound() const { return m_weight > 1e-3F; }

    Lanes result() const {
        Lanes values{};
        const float alpha = m_alphas.clamped(m_alpha / m_weight);
        for (std::size_t c = 0; c < m_level.colours(); ++c) {
            const float value = colour(m_colours[c], alpha);
            values[c] = !m_level.isStraight() ? value : alpha > 0 ? value / alpha : 0;
        }
        if (m_level.colours() < values.size()) values[m_level.colours()] = alpha;
        return values;
    }

  private:
    struct Sum {
        float covering = 0, light = 0;
        Range straight, associated, uncovered;
    };

    void addColour(Sum& sum, float value, float alpha, float weight) const {
        const float associated = m_level.isStraight() ? value * alpha : value;
        if (alpha > 0) {
            sum.covering += weight * associated;
            sum.straight.add(m_level.isStraight() ? value : value / alpha);
            sum.associated.add(associated);
        } else {
            sum.light += weight * associated;
            sum.uncovered.add(associated);
        }
    }

    float colour(const Sum& sum, float alpha) const {
        const bool isEven = m_alphas.low == m_alphas.high && (alpha >= 1 || alpha <= 0);
        if (isEven && !m_isBroken) return evenColour(sum);
        float value = 0;
        if (!sum.straight.empty() && alpha > 0) {
            const Range bounds{alpha * sum.straight.low, alpha * sum.straight.high};
            Range own = sum.associated;
            if (!sum.uncovered.empty()) own.add(0);
            value = own.clamped(bounds.clamped(sum.covering / m_weight));
        }
        if (sum.uncovered.empty()) return value;
        Range own = sum.uncovered;
        if (!sum.straight.empty()) own.add(0);
        return value + own.clamped(sum.light / m_weight);
    }

    /// Returns the colour where no edge is near; removes only values that the type or light cannot have.
    float evenColour(const Sum& sum) const {
        const Range& own = sum.straight.empty() ? sum.uncovered : sum.associated;
        const float value = (sum.covering + sum.light) / m_weight;
        if (!(std::abs(value) <= kLargest)) return own.clamped(value);
        return std::max(value, std::min(0.0F, own.low));
    }

    static constexpr float kLargest = sizeof(T) == 2 ? 65504.0F : std::numeric_limits<float>::max();

    const Level<T>& m_level;
    float m_weight = 0, m_alpha = 0;
    bool m_isBroken = false;
    Range m_alphas;
    std::array<Sum, 4> m_colours;
};

template <typename T>
Lanes filtered(const SpanTask& task, const Level<T>& level, Filter filter, int i, int j, float s, float t) {
    const Weights weights(task, filter, s, t);
    BoundedSum<T> sum(level);
    for (int y = -weights.before()[1]; y <= weights.before()[1] + 1; ++y)
        for (int x = -weights.before()[0]; x <= weights.before()[0] + 1; ++x)
            sum.add(level.at(i + x, j + y), weights.at(x, y));
    return sum.isSound() ? sum.result() : level.at(i + (s < 0.5F ? 0 : 1), j + (t < 0.5F ? 0 : 1));
}

}  // namespace

template <typename T>
void sampleCarefully(const SpanTask& task, Filter filter, int channels, int i, int j, float s, float t,
                     float* colour) {
    const Level<T> level(task.level, channels);
    Lanes values = level.at(i + (s < 0.5F ? 0 : 1), j + (t < 0.5F ? 0 : 1));
    const bool isSoft = filter == Filter::Ewa && task.blend > 0;
    if ((s != 0 || t != 0 || isSoft) && level.isFinite(values))
        values = filtered<T>(task, level, filter, i, j, s, t);
    std::copy_n(values.begin(), channels, colour);
}

template void sampleCarefully<half>(const SpanTask&, Filter, int, int, int, float, float, float*);
template void sampleCarefully<float>(const SpanTask&, Filter, int, int, int, float, float, float*);

}  // namespace wend
