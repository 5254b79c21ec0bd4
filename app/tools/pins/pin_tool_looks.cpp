// Hints, drawing, cursor and menu entry of the pin tool.
#include <QCoreApplication>

#include "app/style/colours.h"
#include "app/style/mark_size.h"
#include "app/tools/drag_label.h"
#include "app/tools/pins/pin_tool.h"

namespace wend {

QString PinTool::hint() const {
    const bool waits = m_gesture == Gesture::None, isOver = waits && m_over;
    if (m_gesture == Gesture::Curve || (isOver && curvePointAt(m_at) > 0)) return curveHint(true);
    if (isRecording(session())) return recordingHint();
    if (m_gesture == Gesture::Widen)
        return QCoreApplication::translate("PinTool", "Drag as far as the pin should hold; Esc cancels");
    const bool moves = m_gesture == Gesture::Drag && m_gizmo->part().kind == Grip::Kind::Move;
    if (view().dimension() == 3 && m_gesture == Gesture::Drag)
        return QCoreApplication::translate("PinTool",
                                           "Shift keeps it straight; X, Y, Z lock an axis, numbers set the "
                                           "amount, Esc puts the shape back");
    if (moves)
        return QCoreApplication::translate(
            "PinTool",
            "Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back");
    if (m_part) return m_gizmo->hint();
    const bool isPlaced = waits && placeGizmo();
    if (isPlaced && m_gizmo->anywhere()) return gripHint();
    if (m_hovered >= 0)
        return QCoreApplication::translate(
            "PinTool",
            "Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, "
            "Shift-click to select more");
    if (isOver && m_curve.isOnCurve(m_at)) return curveHint(false);
    return isPlaced && m_over && m_gizmo->turnsPointAt(view(), m_at) ? pointHint(Grip::Kind::Turn)
                                                                     : besideHint();
}

/// Returns the hint of a rotating or scaling drag.
QString PinTool::gripHint() const {
    const Grip::Kind kind = m_gizmo->anywhere()->kind;
    if (!m_gizmo->canTurn()) return pointHint(kind);
    return kind == Grip::Kind::Turn
               ? QCoreApplication::translate(
                     "PinTool",
                     "Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl "
                     "records it; digits set the number")
               : QCoreApplication::translate(
                     "PinTool",
                     "Drag anywhere to scale what is selected, Ctrl records it; digits set "
                     "the number");
}

/// Returns the hint of a drag that rotates or scales a single point.
QString PinTool::pointHint(Grip::Kind kind) {
    return kind == Grip::Kind::Grow
               ? QCoreApplication::translate("PinTool", "Drag to scale: the point becomes a small circle")
               : QCoreApplication::translate(
                     "PinTool", "Drag to rotate: the point becomes a small circle, which holds its angle");
}

/// Returns the hint for a press outside all pins.
QString PinTool::besideHint() const {
    if (m_outline.kind() == Outline::Lasso)
        return m_adds
                   ? QCoreApplication::translate("PinTool",
                                                 "Click on the shape to set a pin, drag to bend it at once; "
                                                 "beside it, draw around pins to select them")
                   : QCoreApplication::translate(
                         "PinTool", "Draw around pins to select them; Shift adds, Ctrl takes away");
    if (m_outline.kind() == Outline::Brush)
        return m_adds
                   ? QCoreApplication::translate("PinTool",
                                                 "Click on the shape to set a pin, drag to bend it at once; "
                                                 "beside it, brush over pins, [ and ] change the size")
                   : QCoreApplication::translate("PinTool",
                                                 "Brush over pins to select them, [ and ] change the size; "
                                                 "Shift adds, Ctrl takes away");
    return m_adds
               ? QCoreApplication::translate(
                     "PinTool", "Click on the shape to set a pin, or press and drag to bend it at once")
               : QCoreApplication::translate("PinTool",
                                             "Click, or draw beside pins, to select; Shift adds, Ctrl takes "
                                             "away; drag or arrow keys move");
}

QCursor PinTool::cursor() const {
    if (m_gesture == Gesture::Drag) return Qt::ClosedHandCursor;
    if (m_gesture == Gesture::Widen) return Qt::SizeAllCursor;
    if (m_hovered >= 0 || m_part) return Qt::OpenHandCursor;
    return m_adds ? Qt::CrossCursor : Qt::ArrowCursor;
}

void PinTool::paint(QPainter& painter) const {
    m_curve.paint(painter, m_at);
    paintRecording(painter, session(), m_at + QPointF(16, -34));
    if (session().selection().isEmpty()) m_cross.paint(painter);
    if (m_gesture == Gesture::Marquee) return m_outline.paint(painter);
    if (m_gesture == Gesture::Widen) return paintWidened(painter);
    const bool waits = m_gesture == Gesture::None || m_gesture == Gesture::Pressed;
    const bool isBeside = waits && m_over && m_hovered < 0 && !m_part;
    if (isBeside && m_outline.kind() == Outline::Brush) m_outline.paintBrush(painter, m_at);
    if (waits && placeGizmo()) m_gizmo->paint(painter, view(), litPart());
    if (m_gesture != Gesture::Drag) return;
    m_gizmo->paintDragged(painter, view(), m_amount);
    const bool isPlain = view().dimension() == 2 && m_part == Part{} && m_typed.isEmpty();
    if (!isPlain) paintLabel(painter, m_at + QPointF(16, 16), m_gizmo->text(m_amount, view().dimension()));
}

void PinTool::paintWidened(QPainter& painter) const {
    for (const auto& pin : session().pins()) {
        if (pin.handle != m_pressed) continue;
        const QPointF centre = view().onScreen(pin.centre);
        painter.setPen(QPen(QColor(kAccent), marked(2)));
        painter.setBrush(QColor(0x4a, 0x5b, 0xd4, 20));
        const double radius = QLineF(centre, m_at).length();
        painter.drawEllipse(centre, radius, radius);
    }
}

ToolKind pinTool() {
    return toolKind("pin", "pin", QT_TRANSLATE_NOOP("Tools", "&Pin"),
                    QT_TRANSLATE_NOOP("Tools", "Set pins and drag them"), "P", Mode::Pins,
                    both<PinTool>(&Workbench::pins, true),
                    {ToolOption::Grip, ToolOption::Separator, ToolOption::SelectBy, ToolOption::Through,
                     ToolOption::Snap},
                    {}, Mode::Pins);
}

ToolKind selectTool() {
    return toolKind("select", "select", QT_TRANSLATE_NOOP("Tools", "Se&lect"),
                    QT_TRANSLATE_NOOP("Tools", "Select and drag pins without setting new ones"), "V",
                    Modes::all(), both<PinTool>(&Workbench::pins, false),
                    {ToolOption::Grip, ToolOption::Separator, ToolOption::SelectBy, ToolOption::Through});
}

}  // namespace wend
