#include "app/view/cell_filler.h"

#include <algorithm>
#include <cmath>

#include "warp/coverage.h"

namespace wend {
namespace {

/// First pixel whose centre is at or after x.
int firstCentre(double x, int size) {
    return static_cast<int>(std::ceil(std::clamp(x - 0.5, 0.0, static_cast<double>(size))));
}

/// Two components of 8 bits at a time, times part / 255.
QRgb scaled(QRgb pair, QRgb part) {
    const QRgb product = (pair & 0xFF00FF) * part;
    return ((product + ((product >> 8) & 0xFF00FF) + 0x800080) >> 8) & 0xFF00FF;
}

void blend(QRgb* begin, const QRgb* end, QRgb premultiplied) {
    const QRgb rest = 255 - static_cast<QRgb>(qAlpha(premultiplied));
    for (QRgb* pixel = begin; pixel != end; ++pixel)
        *pixel = premultiplied + scaled(*pixel, rest) + (scaled(*pixel >> 8, rest) << 8);
}

}  // namespace

CellFiller::CellFiller(QImage& image, const Points<2>& points, const QTransform& toPixels)
    : m_first(reinterpret_cast<QRgb*>(image.bits())),
      m_stride(image.bytesPerLine() / static_cast<std::ptrdiff_t>(sizeof(QRgb))),
      m_width(image.width()),
      m_height(image.height()),
      m_points(points) {
    Q_ASSERT(image.format() == QImage::Format_ARGB32_Premultiplied);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const QPointF p = toPixels.map(QPointF(points(0, i), points(1, i)));
        m_points.col(i) = Vec<2>(p.x(), p.y());
    }
}

void CellFiller::fill(const Cell<2>& cell, QRgb colour) {
    const TriangleRows rows(m_points.col(cell[0]), m_points.col(cell[1]), m_points.col(cell[2]));
    const QRgb premultiplied = qPremultiply(colour);
    const int bottom = firstCentre(rows.bottom(), m_height);
    for (int y = firstCentre(rows.top(), m_height); y < bottom; ++y) {
        const Span span = rows.at(y + 0.5);
        QRgb* const line = m_first + y * m_stride;
        const int begin = firstCentre(span.begin, m_width), end = firstCentre(span.end, m_width);
        if (begin < end) blend(line + begin, line + end, premultiplied);
    }
}

void CellFiller::fill(const Cell<2>& cell, const std::array<Colour, 3>& colours) {
    fillBetween(cell, colours, [](const Colour& colour) {
        const auto part = [&colour](int k) { return static_cast<int>(colour[k] + 0.5); };
        return qRgba(part(0), part(1), part(2), part(3));
    });
}

/// Rounding may lead a place out of the corners' range.
void CellFiller::fill(const Cell<2>& cell, const std::array<double, 3>& places,
                      const std::vector<QRgb>& ramp) {
    const double last = static_cast<double>(ramp.size() - 1);
    fillBetween(cell, places, [&](double place) {
        return ramp[static_cast<std::size_t>(std::clamp(place * last + 0.5, 0.0, last))];
    });
}

/// Values are linear in the place: those where a row begins, and a step further.
template <class Value, class ColourOf>
void CellFiller::fillBetween(const Cell<2>& cell, const std::array<Value, 3>& corners,
                             const ColourOf& colourOf) {
    const Vec<2> a = m_points.col(cell[0]), u = m_points.col(cell[1]) - a, v = m_points.col(cell[2]) - a;
    const double twice = u.x() * v.y() - u.y() * v.x();
    if (twice == 0) return;
    const Value first = corners[1] - corners[0], second = corners[2] - corners[0];
    const Value right = (first * v.y() - second * u.y()) / twice;
    const Value down = (second * u.x() - first * v.x()) / twice;
    const TriangleRows rows(a, m_points.col(cell[1]), m_points.col(cell[2]));
    const int bottom = firstCentre(rows.bottom(), m_height);
    for (int y = firstCentre(rows.top(), m_height); y < bottom; ++y) {
        const Span span = rows.at(y + 0.5);
        const int begin = firstCentre(span.begin, m_width), end = firstCentre(span.end, m_width);
        Value value = corners[0] + (begin + 0.5 - a.x()) * right + (y + 0.5 - a.y()) * down;
        for (QRgb* pixel = m_first + y * m_stride + begin; pixel < m_first + y * m_stride + end; ++pixel) {
            blend(pixel, pixel + 1, colourOf(value));
            value += right;
        }
    }
}

}  // namespace wend
