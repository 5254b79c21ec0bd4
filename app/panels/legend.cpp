#include "app/panels/legend.h"

#include <QAction>
#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/fields/panel_parts.h"
#include "app/style/energy_scale.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr int kBar = 12, kBars = 26;  // the height of the colours, and of the histogram
constexpr QSize kCard(216, 56);
constexpr int kEdge = 12;  // from the view's
constexpr int kLock = 20, kLockIcon = 16;

QRect cardIn(const QSize& view) {
    return {QPoint(view.width() - kCard.width() - kEdge, view.height() - kCard.height() - kEdge), kCard};
}

/// Draws the four names below their colours; only the first and the last if they would overlap.
void paintStops(QPainter& painter, const QRect& where, int dimension) {
    const EnergyScale scale(dimension);
    constexpr int kLast = EnergyScale::kStops - 1, kLegendGap = 7;
    std::array<int, EnergyScale::kStops> x{}, width{};
    for (int i = 0; i <= kLast; ++i) {
        width[i] = painter.fontMetrics().horizontalAdvance(scale.stops()[i].name);
        const int middle = where.left() + where.width() * i / kLast;
        x[i] = std::clamp(middle - width[i] / 2, where.left(), where.right() - width[i]);
    }
    for (int i = 1; i < kLast; ++i) x[i] = std::max(x[i], x[i - 1] + width[i - 1] + kLegendGap);
    for (int i = kLast - 1; i > 0; --i) x[i] = std::min(x[i], x[i + 1] - kLegendGap - width[i]);
    for (int i = 0; i <= kLast; ++i)
        painter.drawText(QRect(x[i], where.top(), width[i] + 2, where.height()), Qt::AlignLeft,
                         scale.stops()[i].name);
}

/// Draws bars by square root, so that rare values are visible.
void paintHistogram(QPainter& painter, const QRect& where, const std::vector<int>& counts,
                    const QColor& colour) {
    const int most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
    if (most == 0) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const double width = static_cast<double>(where.width()) / static_cast<double>(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double height = std::sqrt(static_cast<double>(counts[i]) / most) * where.height();
        painter.drawRect(QRectF(where.left() + static_cast<double>(i) * width, where.bottom() + 1 - height,
                                std::max(1.0, width - 1), height));
    }
}

/// Draws another histogram as a line over it.
void paintOutline(QPainter& painter, const QRect& where, const std::vector<int>& counts,
                  const QColor& colour) {
    const int most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
    if (most == 0) return;
    const double width = static_cast<double>(where.width()) / static_cast<double>(counts.size());
    QPolygonF line;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double y =
            where.bottom() + 1 - std::sqrt(static_cast<double>(counts[i]) / most) * where.height();
        line << QPointF(where.left() + static_cast<double>(i) * width, y)
             << QPointF(where.left() + static_cast<double>(i + 1) * width, y);
    }
    painter.setPen(QPen(colour, 1.25));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

/// Return the values at the ends, marked if some cells are beyond them.
QString lowText(Measure measure, const MeasureRange& range) {
    return (range.below ? QStringLiteral("≤ ") : QString()) + measureText(measure, range.low);
}
QString highText(Measure measure, const MeasureRange& range) {
    return (range.above ? QStringLiteral("≥ ") : QString()) + measureText(measure, range.high);
}

}  // namespace

Legend::Legend(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Legend"));
}

QSize Legend::sizeHint() const {
    return {160, kBars + kBar + 4 + fontMetrics().height()};
}

void Legend::set(Measure measure, const MeasureRange& range, int dimension, const std::vector<double>& values,
                 const std::vector<double>& before) {
    m_measure = measure;
    m_range = range;
    m_histogram = histogramOf(values, measure, range, kParts);
    m_before = before.empty() ? std::vector<int>() : histogramOf(before, measure, range, kParts);
    setAccessibleDescription(
        tr("%1: from %2 to %3")
            .arg(measureName(measure, dimension), lowText(measure, range), highText(measure, range)));
    update();
}

void Legend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor text = Theme::of(palette()).secondText;
    paintHistogram(painter, QRect(0, 0, width(), kBars - 1), m_histogram, text);
    paintOutline(painter, QRect(0, 0, width(), kBars - 1), m_before, palette().color(QPalette::WindowText));
    paintLegend(painter, rect().adjusted(0, kBars, 0, 0), m_measure, m_range, text);
}

void paintLegendCard(QPainter& painter, const QSize& view, Measure measure, const MeasureRange& range,
                     const QPalette& palette, int dimension) {
    const QRect card = cardIn(view);
    QColor ground = palette.color(QPalette::Button);
    ground.setAlphaF(0.92F);
    const Theme theme = Theme::of(palette);
    painter.save();
    painter.setPen(theme.line);
    painter.setBrush(ground);
    painter.drawRoundedRect(card, 8, 8);
    const QRect inside = card.adjusted(8, 4, -8, -4);
    painter.setPen(palette.color(QPalette::WindowText));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop,
                     painter.fontMetrics().elidedText(measureName(measure, dimension), Qt::ElideRight,
                                                      inside.width() - kLock));
    paintLegend(painter, inside.adjusted(0, painter.fontMetrics().height() + 1, 0, 0), measure, range,
                theme.secondText);
    painter.restore();
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
    painter.drawText(text, Qt::AlignLeft, lowText(measure, range));
    painter.drawText(text, Qt::AlignHCenter, measureText(measure, valueAt(range, measure, 0.5)));
    painter.drawText(text, Qt::AlignRight, highText(measure, range));
}

LegendLock::LegendLock(QAction& keep, QWidget& view) : QToolButton(&view) {
    setObjectName(QStringLiteral("legendLock"));
    setDefaultAction(&keep);
    setToolButtonStyle(Qt::ToolButtonIconOnly);
    setAutoRaise(true);
    setFocusPolicy(Qt::NoFocus);  // the view keeps its keys; the panel has the same for them
    setCursor(Qt::ArrowCursor);
    setFixedSize(kLock, kLock);
    setIconSize(QSize(kLockIcon, kLockIcon));
    describe(this, keep.text(), keep.statusTip());
    showIcons();
    hide();
    view.installEventFilter(this);
    place();
}

/// Closed while it holds them.
void LegendLock::showIcons() {
    QIcon icon;
    for (const auto& [name, state] : {std::pair{"unlock", QIcon::Off}, {"lock", QIcon::On}})
        icon.addPixmap(wendIcon(QString::fromLatin1(name), palette())
                           .pixmap(QSize(kLockIcon, kLockIcon), devicePixelRatioF()),
                       QIcon::Normal, state);
    defaultAction()->setIcon(icon);
}

void LegendLock::place() {
    const QRect card = cardIn(parentWidget()->size());
    move(card.right() - kLock - 3, card.top() + 1);
    raise();
}

void LegendLock::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && defaultAction()) showIcons();
    QToolButton::changeEvent(event);
}

bool LegendLock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QToolButton::eventFilter(watched, event);
}

}  // namespace wend
