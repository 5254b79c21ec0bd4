#include "app/panels/legend.h"

#include <QPainter>
#include <QPainterPath>

#include "app/panels/energy_scale.h"
#include "app/panels/theme.h"

namespace wend {

namespace {

constexpr int kBar = 12;

/// The four names below their colours.
void paintStops(QPainter& painter, const QRect& where, int dimension) {
    const EnergyScale scale(dimension);
    constexpr int kLast = EnergyScale::kStops - 1;
    for (int i = 0; i <= kLast; ++i) {
        const QString& name = scale.stops()[i].name;
        const int width = painter.fontMetrics().horizontalAdvance(name);
        const int middle = where.left() + where.width() * i / kLast;
        const int x = std::clamp(middle - width / 2, where.left(), where.right() - width);
        painter.drawText(QRect(x, where.top(), width + 2, where.height()), Qt::AlignLeft, name);
    }
}

}  // namespace

Legend::Legend(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Legend"));
}

QSize Legend::sizeHint() const {
    return {160, kBar + 4 + fontMetrics().height()};
}

void Legend::set(Measure measure, const MeasureRange& range, int dimension) {
    m_measure = measure;
    m_range = range;
    setAccessibleDescription(tr("%1: from %2 to %3")
                                 .arg(measureName(measure, dimension), measureText(measure, range.low),
                                      measureText(measure, range.high)));
    update();
}

void Legend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLegend(painter, rect(), m_measure, m_range, Theme::of(palette()).secondText);
}

void paintLegend(QPainter& painter, const QRect& where, Measure measure, const MeasureRange& range,
                 const QColor& textColour) {
    QLinearGradient gradient(where.topLeft(), where.topRight());
    for (int i = 0; i <= 20; ++i) gradient.setColorAt(i / 20.0, QColor(colourAt(measure, i / 20.0)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(gradient);
    painter.drawRoundedRect(QRectF(where.topLeft(), QSizeF(where.width(), kBar)), 3, 3);
    painter.setPen(textColour);
    const QRect text(where.left(), where.top() + kBar + 3, where.width(), painter.fontMetrics().height());
    if (measure == Measure::Phi) {
        paintStops(painter, text, range.dimension);
        return;
    }
    painter.drawText(text, Qt::AlignLeft, measureText(measure, range.low));
    painter.drawText(text, Qt::AlignHCenter, measureText(measure, valueAt(range, measure, 0.5)));
    painter.drawText(text, Qt::AlignRight, measureText(measure, range.high));
}

}  // namespace wend
