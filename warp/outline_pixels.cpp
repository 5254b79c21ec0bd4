#include "warp/outline_pixels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wend {
namespace {

/// Calls visit(x, y) for all pixels that the segment passes through or nearly touches.
template <typename Visit>
void forPixelsOf(Vec<2> a, Vec<2> b, int width, int height, Visit&& visit) {
    constexpr double kNear = 1e-6;
    if (a.y() > b.y()) std::swap(a, b);
    const int top = std::max(0, static_cast<int>(std::floor(std::max(a.y() - kNear, -1.0))));
    const int bottom = std::min<double>(height - 1, std::floor(b.y() + kNear));
    const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0;
    for (int y = top; y <= bottom; ++y) {
        double x0 = a.x(), x1 = b.x();
        if (b.y() - a.y() > 1e-9) {
            x0 = a.x() + slope * (std::clamp<double>(y, a.y(), b.y()) - a.y());
            x1 = a.x() + slope * (std::clamp<double>(y + 1, a.y(), b.y()) - a.y());
        }
        const double low = std::max(0.0, std::floor(std::min(x0, x1) - kNear));
        const double high = std::min<double>(width - 1, std::floor(std::max(x0, x1) + kNear));
        for (double x = low; x <= high; ++x) visit(static_cast<int>(x), y);
    }
}

}  // namespace

OutlinePixels::OutlinePixels(const PaintingPlan& plan, const Points<2>& pixels, int width, int height,
                             int bandRows)
    : m_bandRows(bandRows), m_bands(static_cast<std::size_t>((height + bandRows - 1) / bandRows)) {
    for (const auto& [from, to] : plan.outline)
        forPixelsOf(pixels.col(from), pixels.col(to), width, height, [&](int x, int y) {
            m_bands[static_cast<std::size_t>(y / bandRows)].pixels.push_back({x, y, 0});
        });
    const auto inOrder = [](const Pixel& a, const Pixel& b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    };
    const auto equal = [](const Pixel& a, const Pixel& b) { return a.x == b.x && a.y == b.y; };
    for (std::size_t band = 0; band < m_bands.size(); ++band) {
        auto& [list, rowStart, before] = m_bands[band];
        std::sort(list.begin(), list.end(), inOrder);
        list.erase(std::unique(list.begin(), list.end(), equal), list.end());
        rowStart.assign(static_cast<std::size_t>(bandRows) + 1, 0);
        before.assign(static_cast<std::size_t>(width) / kColumn + 2, 0);
        for (std::size_t k = 0; k < list.size(); ++k) {
            ++before[static_cast<std::size_t>(list[k].x) / kColumn + 1];
            list[k].index = static_cast<int>(k);
            ++rowStart[static_cast<std::size_t>(list[k].y) - band * static_cast<std::size_t>(bandRows) + 1];
        }
        std::partial_sum(rowStart.begin(), rowStart.end(), rowStart.begin());
        std::partial_sum(before.begin(), before.end(), before.begin());
    }
}

std::uint64_t OutlinePixels::samplesOf(int x, const std::array<Span, 8>& spans) {
    std::uint64_t samples = 0;
    for (std::size_t j = 0; j < 8; ++j)
        for (std::size_t i = 0; i < 8; ++i) {
            const double at = x + (static_cast<double>(i) + 0.5) / 8;
            if (at >= spans[j].begin && at < spans[j].end) samples |= std::uint64_t{1} << (8 * j + i);
        }
    return samples;
}

}  // namespace wend
