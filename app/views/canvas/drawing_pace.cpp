#include "app/views/canvas/drawing_pace.h"

#include <algorithm>
#include <cmath>

namespace wend {

namespace {

constexpr double kFewest = 0.2e6;  // pixels: no picture is coarser
constexpr double kUnknown = 3e6;   // and so many while nothing is known
constexpr double kTime = 14;       // milliseconds: with the rest of the pipeline 30 frames per second
constexpr double kSmall =
    1.5e6;  // pixels of a view that gets more time before it is coarser than the screen:
constexpr double kFineTime = 20;      // milliseconds
constexpr double kFinerMargin = 0.7;  // fraction of the time: hysteresis
constexpr double kNewest = 0.3;       // weight of the last picture
constexpr int kCoarsest = 4;

}  // namespace

bool DrawingPace::isInTime(double pixels, int coarseness, double margin) const {
    const double drawn = pixels / (coarseness * coarseness);
    const double time = pixels <= kSmall && coarseness == 1 ? kFineTime : kTime;
    return m_perPixel > 0 ? drawn * m_perPixel <= margin * time : drawn <= kUnknown;
}

int DrawingPace::coarseness(double pixels) {
    const int coarsest = std::clamp(static_cast<int>(std::sqrt(pixels / kFewest)), 1, kCoarsest);
    m_coarseness = std::min(m_coarseness, coarsest);
    while (m_coarseness > 1 && isInTime(pixels, m_coarseness - 1, kFinerMargin)) --m_coarseness;
    while (m_coarseness < coarsest && !isInTime(pixels, m_coarseness, 1)) ++m_coarseness;
    return m_coarseness;
}

void DrawingPace::learn(double drawnPixels, double milliseconds) {
    if (drawnPixels <= 0) return;
    const double perPixel = milliseconds / drawnPixels;
    m_perPixel = m_perPixel > 0 ? (1 - kNewest) * m_perPixel + kNewest * perPixel : perPixel;
}

}  // namespace wend
