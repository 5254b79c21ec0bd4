#include "app/tools/drag_label.h"

#include <QCoreApplication>
#include <QLocale>

namespace wend {

namespace {

constexpr double kHeight = 24, kLabelDot = 5;  // pixels

/// Paints the background of a label, and returns the box for its text.
QRectF paintGround(QPainter& painter, const QString& text, double before, bool isLeft = false) {
    const double width = painter.fontMetrics().horizontalAdvance(text) + before + 16;
    const QRectF box(isLeft ? -width : 0, 0, width, kHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(28, 30, 38, 225));
    painter.drawRoundedRect(box, 5, 5);
    return box.adjusted(before, 0, 0, 0);
}

}  // namespace

void paintLabel(QPainter& painter, const QPointF& at, const QString& text, bool isLeft) {
    enlarged(painter, at, [&] {
        const QRectF room = paintGround(painter, text, 0, isLeft);
        painter.setPen(Qt::white);
        painter.drawText(room, Qt::AlignCenter, text);
    });
}

void paintRecording(QPainter& painter, const ShapeGesture& gestures, double speed, const QPointF& at) {
    if (!isRecording(gestures)) return;
    const double seconds = gestures.drag()->seconds() * speed;
    const QString text =
        QCoreApplication::translate("Recording", "%1 s").arg(QLocale().toString(seconds, 'f', 1));
    enlarged(painter, at, [&] {
        const QRectF room = paintGround(painter, text, 2 * kLabelDot + 4);
        painter.setBrush(QColor(0xff, 0x5a, 0x4d));
        painter.drawEllipse(QPointF(room.left() - 2, room.center().y()), kLabelDot, kLabelDot);
        painter.setPen(Qt::white);
        painter.drawText(room, Qt::AlignCenter, text);
    });
}

QString recordingHint() {
    return QCoreApplication::translate("Recording", "Recording until you let go; Esc cancels");
}

}  // namespace wend
