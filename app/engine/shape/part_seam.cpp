#include "app/engine/shape/part_seam.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/meshing/outline_combination.h"
#include "warp/pixels.h"

namespace wend {
namespace {

constexpr double kBeside = 1.5;        // pixels from the border at which both sides are looked at
constexpr double kShortest = 3;        // pixels of a seam
constexpr double kLargestShare = 0.4;  // of the border
constexpr double kOnly = 0.3;          // a stretch that is shorter than that of the longest is noise
constexpr int kCapCorners = 32;
constexpr int kSamplesAcross = 64;  // of an area, in each direction

bool isOpaqueAt(const Sheet& sheet, const Vec<2>& p) {
    const Image& picture = *sheet.picture;
    const Vec<2> pixel = (p - sheet.at).array().floor();
    if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() >= picture.width || pixel.y() >= picture.height)
        return false;
    if (!picture.alpha) return true;
    return withPixelType(picture.type, [&](auto t) {
        using T = decltype(t);
        const T* row = reinterpret_cast<const T*>(picture.row(static_cast<int>(pixel.y())));
        const std::ptrdiff_t x = static_cast<std::ptrdiff_t>(pixel.x());
        return static_cast<float>(row[x * picture.channels + picture.channels - 1]) >= kFull<T> / 2;
    });
}

/// A stretch of samples of a closed border.
struct Stretch {
    std::size_t first = 0, count = 0;
};

/// Samples of a closed polygon's border a pixel apart, and whether the picture is on both sides of each.
class BorderSamples {
  public:
    BorderSamples(const std::vector<Vec<2>>& loop, const Sheet& sheet) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec<2>& a = loop[i];
            const Vec<2> side = loop[(i + 1) % loop.size()] - a;
            const int steps = std::max(1, static_cast<int>(std::lround(side.norm())));
            const Vec<2> across = kBeside * Vec<2>(-side.y(), side.x()).normalized();
            for (int k = 0; k < steps && side.norm() > 0; ++k) {
                const Vec<2> p = a + (k + 0.5) / steps * side;
                m_places.push_back(p);
                m_goesOn.push_back(isOpaqueAt(sheet, p + across) && isOpaqueAt(sheet, p - across));
            }
        }
    }

    std::size_t size() const { return m_places.size(); }
    const Vec<2>& at(std::size_t i) const { return m_places[i % size()]; }

    /// Returns the stretches where the picture continues, the longest first; none if it does so everywhere.
    std::vector<Stretch> stretches() const {
        std::vector<Stretch> all;
        const auto start = std::ranges::find(m_goesOn, false);
        if (start == m_goesOn.end()) return all;
        const auto offset = static_cast<std::size_t>(start - m_goesOn.begin());
        for (std::size_t i = 1; i <= size(); ++i) {
            if (!m_goesOn[(offset + i) % size()]) continue;
            if (!m_goesOn[(offset + i - 1) % size()]) all.push_back({offset + i, 0});
            ++all.back().count;
        }
        std::ranges::sort(all, std::ranges::greater(), &Stretch::count);
        return all;
    }

  private:
    std::vector<Vec<2>> m_places;
    std::vector<bool> m_goesOn;
};

}  // namespace

double coveredArea(const Outline& area, const Sheet& sheet) {
    Vec<2> low = Vec<2>::Constant(INFINITY), high = -low;
    for (const auto& loop : area.loops)
        for (const Vec<2>& p : loop) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const Vec<2> step = (high - low) / kSamplesAcross;
    int covered = 0;
    for (int j = 0; j < kSamplesAcross; ++j)
        for (int i = 0; i < kSamplesAcross; ++i) {
            const Vec<2> p = low + step.cwiseProduct(Vec<2>(i + 0.5, j + 0.5));
            if (isOpaqueAt(sheet, p) && isInside(area, p)) ++covered;
        }
    return covered * step.prod();
}

std::optional<PartSeam> seamOf(const Outline& area, const Sheet& sheet) {
    if (area.loops.size() != 1) return std::nullopt;
    const BorderSamples border(area.loops.front(), sheet);
    const std::vector<Stretch> stretches = border.stretches();
    if (stretches.empty()) return std::nullopt;
    const auto length = static_cast<double>(stretches.front().count);
    const bool isOnly = stretches.size() == 1 || static_cast<double>(stretches[1].count) < kOnly * length;
    if (!isOnly || length < kShortest || length > kLargestShare * static_cast<double>(border.size()))
        return std::nullopt;
    const Vec<2> from = border.at(stretches.front().first),
                 to = border.at(stretches.front().first + stretches.front().count - 1);
    return PartSeam{(from + to) / 2, (to - from).norm() / 2};
}

Outline withCap(const Outline& area, const PartSeam& seam) {
    std::vector<Vec<2>> disc;
    for (int k = 0; k < kCapCorners; ++k) {
        const double angle = 2 * std::numbers::pi * k / kCapCorners;
        disc.push_back(seam.middle + seam.radius * Vec<2>(std::cos(angle), std::sin(angle)));
    }
    return combined(area, {{disc}}, OutlineOperation::Add);
}

}  // namespace wend
