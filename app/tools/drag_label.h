#pragma once

#include <QMouseEvent>
#include <QPainter>

#include "app/session/mark_size.h"
#include "app/session/shape_session.h"

namespace wend {

/// Draws at the origin what is meant for a place, in the size of the marks.
template <class Draw>
void enlarged(QPainter& painter, const QPointF& at, const Draw& draw) {
    painter.save();
    painter.translate(at);
    painter.scale(markSize(), markSize());
    draw();
    painter.restore();
}

/// What stands beside the pointer while something is dragged: a number, how many … From a place on to the
/// right, or to the left.
void paintLabel(QPainter& painter, const QPointF& at, const QString& text, bool isLeft = false);

/// When an event of the pointer happened, by the clock of the system that sent it.
inline double secondsOf(const QMouseEvent& event) {
    return static_cast<double>(event.timestamp()) * 1e-3;
}

/// True while a drag goes on that records.
inline bool isRecording(const ShapeSession& session) {
    return session.gesture() && session.gesture()->records();
}
/// A red dot and how long it has lasted; nothing if none goes on.
void paintRecording(QPainter& painter, const ShapeSession& session, const QPointF& at);
/// What the pointer does meanwhile.
QString recordingHint();

}  // namespace wend
