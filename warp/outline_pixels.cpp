#include "warp/outline_pixels.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace wend {
namespace {

/// Calls visit(x, y) for all pixels that the segment passes through or nearly touches.
template <typename Visit>
void forPixelsOf(Vec2 a, Vec2 b, int width, int height, Visit&& visit) {
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

/// Returns the first sample, of 8 in a pixel, whose place is at or after x.
int firstSample(double x, double left, double right) {
    const double place = 8 * std::clamp(x, left, right) - 0.5;
    const int whole = static_cast<int>(place);
    return whole + (whole < place ? 1 : 0);
}

}  // namespace

SampleRows::SampleRows(const TriangleRows& rows, int y, double left, double right)
    : m_least(8 * static_cast<int>(right)), m_allTo(m_least) {
    for (std::size_t j = 0; j < 8; ++j) {
        const double at = y + (static_cast<double>(j) + 0.5) / 8;
        const Span span = at >= rows.top() && at < rows.bottom() ? rows.at(at) : Span();
        if (span.begin < span.end) {
            m_from[j] = firstSample(span.begin, left, right);
            m_to[j] = firstSample(span.end, left, right);
        }
        m_allFrom = std::max(m_allFrom, m_from[j]), m_allTo = std::min(m_allTo, m_to[j]);
        if (m_from[j] >= m_to[j]) continue;
        m_least = std::min(m_least, m_from[j]), m_most = std::max(m_most, m_to[j]);
    }
}

OutlinePixels::OutlinePixels(const PaintingPlan& plan, const Points2& pixels, int width, int height,
                             int bandRows)
    : m_bandRows(bandRows),
      m_width(width),
      m_words((width + kWord - 1) / kWord),
      m_bands(static_cast<std::size_t>((height + bandRows - 1) / bandRows)) {
    const auto words = static_cast<std::size_t>(m_words);
    for (const auto& [from, to] : plan.outline)
        forPixelsOf(pixels.col(from), pixels.col(to), width, height, [&](int x, int y) {
            Band& band = m_bands[static_cast<std::size_t>(y / bandRows)];
            if (band.marks.empty()) band.marks.resize(words * static_cast<std::size_t>(bandRows));
            const auto row = static_cast<std::size_t>(y % bandRows);
            band.marks[row * words + static_cast<std::size_t>(x / kWord)] |= std::uint64_t{1} << (x % kWord);
        });
    for (int band = 0; band < static_cast<int>(m_bands.size()); ++band) list(band);
}

void OutlinePixels::list(int band) {
    Band& own = m_bands[static_cast<std::size_t>(band)];
    own.before.reserve(own.marks.size());
    for (std::size_t at = 0; at < own.marks.size(); ++at) {
        const int row = static_cast<int>(at) / m_words, column = static_cast<int>(at) % m_words * kWord;
        own.before.push_back(static_cast<int>(own.pixels.size()));
        for (std::uint64_t marks = own.marks[at]; marks != 0; marks &= marks - 1)
            own.pixels.push_back({column + std::countr_zero(marks), band * m_bandRows + row,
                                  static_cast<int>(own.pixels.size())});
    }
}

}  // namespace wend
