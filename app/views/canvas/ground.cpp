#include "app/views/canvas/ground.h"

namespace wend {

namespace {

QPixmap checker(const Theme& theme) {
    constexpr int kSquare = 10;
    QPixmap tile(2 * kSquare, 2 * kSquare);
    tile.fill(theme.checkerA);
    QPainter painter(&tile);
    painter.fillRect(0, 0, kSquare, kSquare, theme.checkerB);
    painter.fillRect(kSquare, kSquare, kSquare, kSquare, theme.checkerB);
    return tile;
}

/// Draws the paper with a soft shadow outside it.
void drawPaper(QPainter& painter, const QRect& paper, const QColor& colour, const Theme& theme) {
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setClipRegion(QRegion(paper.adjusted(-8, -8, 8, 10)) - paper, Qt::IntersectClip);
    for (int i = 6; i > 0; --i) {
        painter.setBrush(QColor(0, 0, 0, theme.dark ? 14 : 6));
        painter.drawRoundedRect(QRectF(paper).adjusted(-i, -i + 2, i, i + 2), i, i);
    }
    painter.restore();
    if (colour.isValid())
        painter.fillRect(paper, colour);
    else
        fillWithChecks(painter, paper, theme);
}

}  // namespace

void fillWithChecks(QPainter& painter, const QRectF& paper, const Theme& theme) {
    painter.setBrushOrigin(paper.topLeft());
    painter.fillRect(paper, QBrush(checker(theme)));
    painter.setBrushOrigin(0, 0);
}

void Ground::draw(QPainter& painter, const Look& look, const Theme& theme) {
    painter.fillRect(QRect(QPoint(), look.size), theme.workspace);
    if (!look.paper) return;
    // Pixels that the picture hardly covers are left out, to avoid a bright line beside dark ones.
    drawPaper(painter, look.view.matrix().mapRect(*look.paper).toRect(), look.colour, theme);
}

void Ground::paint(QPainter& painter, const Look& look, const Theme& theme, bool keeps) {
    if (!keeps) {
        m_kept = QPixmap();
        return draw(painter, look, theme);
    }
    if (m_kept.isNull() || look != m_look) {
        m_look = look;
        m_kept = QPixmap(look.size * look.ratio);
        m_kept.setDevicePixelRatio(look.ratio);
        QPainter kept(&m_kept);
        draw(kept, look, theme);
    }
    painter.drawPixmap(0, 0, m_kept);
}

}  // namespace wend
