#include "app/views/canvas/cell_filler.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "warp/coverage.h"

namespace wend {
namespace {

constexpr int kFilledRows = 32;
constexpr int kPlaces = 64;  // in a pixel of the outline

/// Returns the first pixel whose centre is at or after x.
int firstCentre(double x, int size) {
    return static_cast<int>(std::ceil(std::clamp(x - 0.5, 0.0, static_cast<double>(size))));
}

/// Multiplies two 8-bit components at a time by part / 255.
QRgb scaled(QRgb pair, QRgb part) {
    const QRgb product = (pair & 0xFF00FF) * part;
    return ((product + ((product >> 8) & 0xFF00FF) + 0x800080) >> 8) & 0xFF00FF;
}

QRgb times(QRgb colour, QRgb part) {
    return scaled(colour, part) + (scaled(colour >> 8, part) << 8);
}

QRgb alphaOf(QRgb colour) {
    return colour >> 24;
}

/// Returns the middle of the set samples, of 8 × 8 places in the pixel.
Vec2 middleOf(std::uint64_t samples) {
    Vec2 sum = Vec2::Zero();
    for (std::uint64_t rest = samples; rest != 0; rest &= rest - 1) {
        const int place = std::countr_zero(rest);
        sum += Vec2(place % 8, place / 8);
    }
    return (sum / std::popcount(samples) + Vec2(0.5, 0.5)) / 8;
}

/// Returns the bounds of the visible points in whole pixels.
QRect pixelBoxOf(const Points2& points, const QSize& size) {
    if (points.cols() == 0) return {};
    const auto bounded = [](double x, int most) { return std::clamp(x, -1.0, most + 1.0); };
    const Vec2 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
    const QPointF first(bounded(low.x(), size.width()), bounded(low.y(), size.height()));
    const QPointF last(bounded(high.x(), size.width()), bounded(high.y(), size.height()));
    return QRectF(first, last).toAlignedRect().adjusted(0, 0, 1, 1) & QRect(QPoint(), size);
}

/// The covered part of a pixel, and the sum of its samples' colours, where later pieces are on top.
class Mix {
  public:
    void add(std::uint64_t samples, QRgb colour) {
        const std::uint64_t seen = samples & m_open;
        const QRgb count = static_cast<QRgb>(std::popcount(seen));
        for (int k = 0; k < 4; ++k) m_sum[k] += count * ((colour >> (8 * k)) & 0xFF);
        m_open &= ~seen;
        m_count += count;
    }
    /// Returns the coverage from 0 to 255.
    QRgb coverage() const { return (m_count * 255 + kPlaces / 2) / kPlaces; }
    /// Returns the mean colour of the covered samples.
    QRgb colour() const {
        QRgb mean = 0;
        if (m_count == 0) return mean;
        for (int k = 0; k < 4; ++k) mean |= ((m_sum[k] + m_count / 2) / m_count) << (8 * k);
        return mean;
    }

  private:
    std::array<QRgb, 4> m_sum{};
    std::uint64_t m_open = ~std::uint64_t{0};
    QRgb m_count = 0;
};

}  // namespace

CellFiller::CellFiller(const QSize& size, const PaintingPlan& plan, const Points2& points,
                       const QTransform& toPixels)
    : m_points(points) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const QPointF p = toPixels.map(QPointF(points(0, i), points(1, i)));
        m_points.col(i) = Vec2(p.x(), p.y());
    }
    const QRect box = pixelBoxOf(m_points, size);
    if (box.isEmpty()) return;
    m_at = box.topLeft();
    m_points.colwise() -= Vec2(m_at.x(), m_at.y());
    m_layer = QImage(box.size(), QImage::Format_ARGB32_Premultiplied);
    m_layer.fill(Qt::transparent);
    m_outline = OutlinePixels(plan, m_points, box.width(), box.height(), kFilledRows);
}

/// Calls run(y, x, first, last) for the pixels of each row, from x on, whose centres are in the triangle.
template <class Run>
void CellFiller::forRows(const TriangleRows& rows, const Run& run) {
    auto* const first = reinterpret_cast<QRgb*>(m_layer.bits());
    const std::ptrdiff_t stride = m_layer.bytesPerLine() / static_cast<std::ptrdiff_t>(sizeof(QRgb));
    const int bottom = firstCentre(rows.bottom(), m_layer.height());
    for (int y = firstCentre(rows.top(), m_layer.height()); y < bottom; ++y) {
        const Span span = rows.at(y + 0.5);
        const int begin = firstCentre(span.begin, m_layer.width());
        const int end = firstCentre(span.end, m_layer.width());
        QRgb* const line = first + y * stride;
        if (begin < end) run(y, begin, line + begin, line + end);
    }
}

template <class ColourAt>
void CellFiller::addPieces(const TriangleRows& rows, const ColourAt& colourAt) {
    const double high = std::min<double>(m_layer.height(), rows.bottom());
    for (int band = static_cast<int>(std::max(0.0, rows.top())) / kFilledRows; band * kFilledRows < high;
         ++band)
        m_outline.visit(band, rows, [&](int index, std::uint64_t samples) {
            const auto& pixel = m_outline.pixels(band)[static_cast<std::size_t>(index)];
            m_pieces.push_back({band, index, samples, colourAt(pixel, samples)});
        });
}

void CellFiller::fill(const Cell<2>& cell, QRgb colour) {
    const TriangleRows rows(m_points.col(cell[0]), m_points.col(cell[1]), m_points.col(cell[2]));
    const QRgb premultiplied = qPremultiply(colour);
    forRows(rows, [premultiplied](int, int, QRgb* from, QRgb* to) { std::fill(from, to, premultiplied); });
    addPieces(rows, [premultiplied](const auto&, std::uint64_t) { return premultiplied; });
}

void CellFiller::fill(const Cell<2>& cell, const std::array<Colour, 3>& colours) {
    fillBetween(cell, colours, [](const Colour& colour) {
        const auto part = [&colour](int k) { return static_cast<int>(colour[k] + 0.5); };
        return qRgba(part(0), part(1), part(2), part(3));
    });
}

/// Rounding may move a sample out of the corners' range.
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
    const Vec2 a = m_points.col(cell[0]), u = m_points.col(cell[1]) - a, v = m_points.col(cell[2]) - a;
    const double twice = u.x() * v.y() - u.y() * v.x();
    if (twice == 0) return;
    const Value first = corners[1] - corners[0], second = corners[2] - corners[0];
    const Value right = (first * v.y() - second * u.y()) / twice;
    const Value down = (second * u.x() - first * v.x()) / twice;
    const auto valueAt = [&](double x, double y) -> Value {
        return corners[0] + (x - a.x()) * right + (y - a.y()) * down;
    };
    const TriangleRows rows(a, m_points.col(cell[1]), m_points.col(cell[2]));
    forRows(rows, [&](int y, int begin, QRgb* from, QRgb* to) {
        Value value = valueAt(begin + 0.5, y + 0.5);
        for (QRgb* pixel = from; pixel < to; ++pixel) {
            *pixel = colourOf(value);
            value += right;
        }
    });
    addPieces(rows, [&](const auto& pixel, std::uint64_t samples) {
        const Vec2 middle = middleOf(samples);
        return colourOf(valueAt(pixel.x + middle.x(), pixel.y + middle.y()));
    });
}

/// With coverage k the image becomes k i, where i is what the shape shows of the picture, and beside it the
/// excess; the layer's colour c with alpha a makes it k (c + (1 - a) i). In the extent of the picture c
/// counts as far as i is opaque.
void CellFiller::layOutline(QImage& image, Extent extent) {
    std::ranges::stable_sort(m_pieces, {}, [](const Piece& p) { return std::pair(p.band, p.pixel); });
    auto piece = m_pieces.cbegin();
    for (int band = 0; band * kFilledRows < m_layer.height(); ++band)
        for (const auto& pixel : m_outline.pixels(band)) {
            const auto first = piece;
            while (piece != m_pieces.cend() && piece->band == band && piece->pixel == pixel.index) ++piece;
            Mix mix;
            for (auto it = piece; it != first;) {
                --it;
                mix.add(it->samples, it->colour);
            }
            reinterpret_cast<QRgb*>(m_layer.scanLine(pixel.y))[pixel.x] = 0;
            QRgb& under = reinterpret_cast<QRgb*>(image.scanLine(pixel.y + m_at.y()))[pixel.x + m_at.x()];
            const QRgb colour = mix.colour(), covered = mix.coverage(), there = alphaOf(under);
            const QRgb part = extent == Extent::Shape ? covered : std::min(covered, there);
            const QRgb veiled =  // rounded as times() does: a sum above 255 would run over
                there <= covered ? alphaOf(colour) : (alphaOf(colour) * covered + there / 2) / there;
            under = times(colour, part) + times(under, 255 - veiled);
        }
}

void CellFiller::layOver(QImage& image, Extent extent) {
    Q_ASSERT(image.format() == QImage::Format_ARGB32_Premultiplied);
    if (m_layer.isNull()) return;
    layOutline(image, extent);
    for (int y = 0; y < m_layer.height(); ++y) {
        const auto* colour = reinterpret_cast<const QRgb*>(m_layer.constScanLine(y));
        auto* under = reinterpret_cast<QRgb*>(image.scanLine(y + m_at.y())) + m_at.x();
        if (extent == Extent::Shape)
            for (int x = 0; x < m_layer.width(); ++x)
                under[x] = colour[x] + times(under[x], 255 - alphaOf(colour[x]));
        else
            for (int x = 0; x < m_layer.width(); ++x)
                under[x] = times(colour[x], alphaOf(under[x])) + times(under[x], 255 - alphaOf(colour[x]));
    }
}

}  // namespace wend
