#pragma once

#include <QMouseEvent>
#include <QPainter>

#include "app/session/shape_gesture.h"
#include "app/style/marks.h"

namespace wend {

/// Draws something at the origin, moved to a place and scaled to the size of marks.
template <class Draw>
void enlarged(QPainter& painter, const QPointF& at, const Draw& draw) {
    painter.save();
    painter.translate(at);
    painter.scale(markSize(), markSize());
    draw();
    painter.restore();
}

/// Draws a label beside the pointer, such as a number during a drag, to the right or to the left of a place.
void paintLabel(QPainter& painter, const QPointF& at, const QString& text, bool isLeft = false);

/// Returns the time of a pointer event on the clock of the windowing system.
inline double secondsOf(const QMouseEvent& event) {
    return static_cast<double>(event.timestamp()) * 1e-3;
}

/// Returns whether the current drag records.
inline bool isRecording(const ShapeGesture& gestures) {
    return gestures.drag() && gestures.drag()->records();
}
/// Draws a red dot with the duration of the recording at a speed of the playback, if there is one.
void paintRecording(QPainter& painter, const ShapeGesture& gestures, double speed, const QPointF& at);
/// Returns the hint during a recording.
QString recordingHint();

}  // namespace wend
