// This file draws the tracks.
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "app/style/marks.h"
#include "app/style/theme.h"
#include "app/window/film/time_scale.h"
#include "app/window/film/track_view.h"

namespace wend {

void TrackView::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = Theme::of(palette());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Window));
    if (end() <= 0) {
        painter.setPen(theme.secondText);
        painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears "
                            "here, pin by pin."));
        return;
    }
    painter.save();
    painter.setClipRect(QRectF(0, top(), viewport()->width(), viewport()->height() - top()));
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) paintRow(painter, row);
    if (m_band) paintBand(painter);
    painter.restore();
    const double now = xOf(m_session.playback().time());
    painter.setPen(QPen(theme.accentText, 1.5));
    painter.drawLine(QPointF(now, top()), QPointF(now, viewport()->height()));
}

void TrackView::paintRow(QPainter& painter, int row) const {
    const Theme theme = Theme::of(palette());
    const Row& own = m_rows[static_cast<std::size_t>(row)];
    const QRectF rect = rowRect(row);
    const bool selected = m_session.selection().contains(row);
    QColor ground = theme.accent;
    ground.setAlphaF(0.14F);
    if (selected) painter.fillRect(rect, ground);
    painter.setPen(Qt::NoPen);
    painter.setBrush(own.colour);
    painter.drawEllipse(QPointF(16, rect.center().y()), 4, 4);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect.adjusted(28, 0, m_scale->way().x() - 8 - rect.width(), 0),
                     Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(own.name, Qt::ElideRight, m_scale->way().x() - 36));
    paintHold(painter, own.hold);
    for (const Bar& bar : own.bars) paintBar(painter, bar, own.colour);
    const QColor ink = palette().color(QPalette::WindowText);
    for (const double time : keysIn(row))
        paintKey(painter, {row, time}, isChosen(KeyId{row, time}) ? theme.accentText : ink);
}

/// Paints a key pose; a chosen one is larger.
void TrackView::paintKey(QPainter& painter, const KeyId& key, const QColor& colour) const {
    const double half = isChosen(key) ? 6.5 : 4.5;
    const QPointF at = keySpot(key);
    painter.setPen(QPen(palette().color(QPalette::Window), 1));
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF(
        {at + QPointF(-half, 0), at + QPointF(0, -half), at + QPointF(half, 0), at + QPointF(0, half)}));
}

/// Paints a line with stops at its ends, by which it is dragged.
void TrackView::paintHold(QPainter& painter, const Bar& hold) const {
    const QRectF box = barRect(hold);
    const double y = box.center().y(), left = box.left(), right = std::max(left, xOf(timeOf(hold).end));
    painter.setPen(QPen(Theme::of(palette()).secondText, 1.5));
    painter.drawLine(QPointF(left, y), QPointF(right, y));
    for (const double x : {left, right}) painter.drawLine(QPointF(x, y - 5), QPointF(x, y + 5));
}

void TrackView::paintBand(QPainter& painter) const {
    const Theme theme = Theme::of(palette());
    QColor ground = theme.accent;
    ground.setAlphaF(0.2F);
    painter.setPen(theme.accentText);
    painter.setBrush(ground);
    painter.drawRect(QRectF(m_band->from, m_band->to).normalized());
}

/// Paints a bar with full opacity at constant speed, lighter where the motion eases.
void TrackView::paintBar(QPainter& painter, const Bar& bar, const QColor& colour) const {
    const Theme theme = Theme::of(palette());
    const QRectF box = barRect(bar).adjusted(0.5, 0, -0.5, 0);
    const bool chosen = isChosen(bar);
    QColor soft = colour;
    soft.setAlphaF(0.45F);
    QLinearGradient fill(box.topLeft(), box.topRight());
    fill.setColorAt(0, bar.slow.start ? soft : colour);
    fill.setColorAt(0.4, colour);
    fill.setColorAt(0.6, colour);
    fill.setColorAt(1, bar.slow.end ? soft : colour);
    painter.setPen(chosen ? QPen(theme.accentText, 2) : QPen(colour.darker(130), 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(box, 4, 4);
    if (painter.fontMetrics().horizontalAdvance(bar.kind) + 10 > box.width()) return;
    painter.setPen(colour.lightnessF() > 0.55F ? QColor(kInk) : QColor(Qt::white));
    painter.drawText(box, Qt::AlignCenter, bar.kind);
}

}  // namespace wend
