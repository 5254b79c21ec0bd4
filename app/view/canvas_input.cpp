// What the pointer and the keys do on a picture.
#include <QWheelEvent>
#include <cmath>

#include "app/view/canvas.h"

namespace wend {

/// The middle button always; the left one with the space bar, or by the tool that does nothing else.
bool ShapeCanvas::pansBy(const QMouseEvent& event) const {
    if (event.button() == Qt::MiddleButton) return true;
    return event.button() == Qt::LeftButton && (m_spaceDown || (m_tool && m_tool->pans()));
}

void ShapeCanvas::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    const bool taken = m_tool && m_tool->takesButton(*event);
    m_menuPressed = !taken && event->buttons() == Qt::RightButton;  // alone
    if (pansBy(*event)) {
        m_panning = true;
        m_lastPan = event->position();
    } else if (m_tool && !m_panning) {
        m_leads = m_leads || taken || event->button() == Qt::LeftButton;
        m_tool->press(*event);
        emit hintChanged(m_tool->hint());
    }
    updateCursor();
}

void ShapeCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!m_tool || m_panning || pansBy(*event) || event->button() != Qt::LeftButton) {
        mousePressEvent(event);
        return;
    }
    m_tool->doubleClick(*event);
    emit hintChanged(m_tool->hint());
}

/// A move from before the press, which the system brings late, does not lead the tool: it has no button down.
void ShapeCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_leads && event->buttons() == Qt::NoButton) return;
    const Vec<2> p = toShape(event->position());
    emit pointed(p.x(), p.y(), true);
    if (m_panning) {
        m_fitted = false;
        m_view.pan(event->position() - m_lastPan);
        m_lastPan = event->position();
        showView();
    } else if (m_tool) {
        m_tool->move(*event);
        emit hintChanged(m_tool->hint());
    }
    updateCursor();
}

void ShapeCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) m_leads = false;
    if (m_panning)
        endPan();
    else if (m_tool) {
        m_tool->release(*event);
        // A menu takes the pointer: not in the middle of a gesture.
        const bool alone = std::exchange(m_menuPressed, false) && event->buttons() == Qt::NoButton;
        const bool wanted = alone && event->button() == Qt::RightButton;
        const MenuPlace place = wanted ? m_tool->menuAt(event->position()) : MenuPlace::None;
        if (place != MenuPlace::None) emit menuWanted(event->globalPosition().toPoint(), place);
        emit hintChanged(m_tool->hint());
    }
    updateCursor();
}

void ShapeCanvas::endPan() {
    m_panning = false;
    updateCursor();
}

void ShapeCanvas::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps == 0) return;
    m_fitted = false;
    m_view.setZoom(m_view.zoom() * std::pow(1.2, steps), event->position());
    showView();
    event->accept();
}

void ShapeCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space) {
        m_spaceDown = m_spaceDown || !event->isAutoRepeat();
        updateCursor();
    } else if (!m_tool || !m_tool->key(*event)) {
        QWidget::keyPressEvent(event);
    }
}

void ShapeCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) return;
    if (event->key() == Qt::Key_Space) m_spaceDown = false;
    updateCursor();
}

void ShapeCanvas::focusOutEvent(QFocusEvent*) {
    m_spaceDown = false;
    updateCursor();
}

void ShapeCanvas::leaveEvent(QEvent*) {
    emit pointed(0, 0, false);
    if (m_tool) m_tool->leave();
    update();
}

void ShapeCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) render();
    QWidget::changeEvent(event);
}

/// Arrow keys, Escape and Space belong to the canvas while it has the focus, also where a shortcut has them.
bool ShapeCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool owned = m_tool && m_tool->ownsKey(*static_cast<QKeyEvent*>(event));
        if (owned || key == Qt::Key_Space || (key >= Qt::Key_Left && key <= Qt::Key_Down) ||
            (key == Qt::Key_Escape)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void ShapeCanvas::updateCursor() {
    if (m_panning)
        setCursor(Qt::ClosedHandCursor);
    else if (m_spaceDown)
        setCursor(Qt::OpenHandCursor);
    else
        setCursor(m_tool ? m_tool->cursor() : QCursor(Qt::ArrowCursor));
}

}  // namespace wend
