#include "app/tools/key_cross.h"

#include "app/session/shape_session.h"
#include "app/style/marks.h"

namespace wend {

namespace {

constexpr double kCrossStep = 5;  // pixels

}  // namespace

std::optional<QPointF> arrowOf(const QKeyEvent& key) {
    const double length = key.modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (key.key()) {
        case Qt::Key_Left:
            return QPointF(-length, 0);
        case Qt::Key_Right:
            return QPointF(length, 0);
        case Qt::Key_Up:
            return QPointF(0, -length);
        case Qt::Key_Down:
            return QPointF(0, length);
        default:
            return {};
    }
}

bool KeyCross::take(const QKeyEvent& key, ShapeView& view, const std::function<void(const QPointF&)>& click) {
    const FramePtr frame = view.session().motion().frame();
    const auto by = arrowOf(key);
    const bool enters = m_at && (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter);
    if (!frame || !(by || enters)) return false;
    if (enters)
        click(*m_at);
    else
        m_at = m_at ? *m_at + kCrossStep * *by : view.onScreen(frame->middle());
    view.redraw();
    return true;
}

bool KeyCross::clicks(const QKeyEvent& key, ShapeView& view, Tool& tool, Enter enter) {
    const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeypadModifier;
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons) {
        return QMouseEvent(type, *m_at, *m_at, *m_at, button, buttons, held);
    };
    m_clicks = true;
    const bool taken = take(key, view, [&](const QPointF&) {
        if (enter != Enter::LetsGo)
            tool.press(send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton));
        if (enter != Enter::Presses)
            tool.release(send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton));
    });
    if (taken && m_at) tool.move(send(QEvent::MouseMove, Qt::NoButton, Qt::NoButton));
    m_clicks = false;
    return taken;
}

void KeyCross::paint(QPainter& painter) const {
    if (!m_at) return;
    for (const QPen& pen : {QPen(Qt::white, marked(3.5)), QPen(QColor(0x14, 0x16, 0x1e), marked(1.5))}) {
        painter.setPen(pen);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(*m_at + marked(3) * way, *m_at + marked(12) * way);
    }
}

}  // namespace wend
