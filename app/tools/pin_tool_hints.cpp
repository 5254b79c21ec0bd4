// What the pin tool says and which pointer it shows.
#include <QCoreApplication>

#include "app/tools/drag_label.h"
#include "app/tools/pin_tool.h"

namespace wend {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("PinTool", text);
}

}  // namespace

QString PinTool::hint() const {
    if (m_gesture == Gesture::Curve || curvePointAt(m_at) > 0) return curveHint(true);
    if (m_gesture == Gesture::None && m_hovered < 0 && m_curve.isOnCurve(m_at)) return curveHint(false);
    if (isRecording(session())) return recordingHint();
    if (m_gesture == Gesture::Drag)
        return said(QT_TRANSLATE_NOOP("PinTool", "Drag the pin; Esc puts the shape back"));
    if (m_gesture == Gesture::Widen)
        return said(QT_TRANSLATE_NOOP("PinTool", "Drag as far as the pin shall hold; Esc gives it up"));
    if (m_gesture == Gesture::Ring || m_part)
        return said(QT_TRANSLATE_NOOP(
            "PinTool",
            "Drag the dot to rotate, Shift by 15°, or the square to scale; digits set the number"));
    if (m_gesture == Gesture::None && m_grip != Grip::Kind::Move && m_hasRing) return gripHint();
    if (m_hovered >= 0)
        return said(QT_TRANSLATE_NOOP("PinTool",
                                      "Drag to move the pin, Ctrl-drag to record it, Alt-drag to widen it, "
                                      "Shift-click to select more"));
    if (m_gesture == Gesture::None && m_hasRing && !m_ring.canTurn() && m_ring.isOn(m_at))
        return refusal(Grip::Kind::Turn);
    if (m_adds)
        return said(
            QT_TRANSLATE_NOOP("PinTool", "Click on the shape to set a pin, then drag pins to bend it"));
    return said(QT_TRANSLATE_NOOP(
        "PinTool", "Click or draw a rectangle to select pins, drag to move them, arrow keys nudge"));
}

/// Of a drag that turns or scales.
QString PinTool::gripHint() const {
    if (!m_ring.canTurn()) return refusal(m_grip);
    return m_grip == Grip::Kind::Turn
               ? said(
                     QT_TRANSLATE_NOOP("PinTool",
                                       "Drag anywhere to rotate what is selected, Shift by 15°, Ctrl records "
                                       "it; digits set the number"))
               : said(
                     QT_TRANSLATE_NOOP("PinTool",
                                       "Drag anywhere to scale what is selected, Ctrl records it; digits set "
                                       "the number"));
}

/// Of a ring around a single point.
QString PinTool::refusal(Grip::Kind kind) {
    return kind == Grip::Kind::Grow
               ? said(QT_TRANSLATE_NOOP("PinTool", "A point cannot scale – Alt-drag to widen it"))
               : said(QT_TRANSLATE_NOOP("PinTool", "A point cannot rotate – Alt-drag to widen it"));
}

QCursor PinTool::cursor() const {
    if (m_gesture == Gesture::Drag || m_gesture == Gesture::Ring) return Qt::ClosedHandCursor;
    if (m_gesture == Gesture::Widen) return Qt::SizeAllCursor;
    if (m_hovered >= 0 || m_part) return Qt::OpenHandCursor;
    return m_adds ? Qt::CrossCursor : Qt::ArrowCursor;
}

}  // namespace wend
