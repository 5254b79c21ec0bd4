// What the pointer and the keys do on a solid.
#include <QLocale>
#include <QMouseEvent>
#include <QWheelEvent>

#include "app/panels/legend.h"
#include "app/session/fields.h"
#include "app/view/volume/solid_canvas.h"

namespace wend {

Tool* SolidCanvas::toolAt(const QPointF& at) {
    return m_cutTool.wants(at) && !m_hidden ? &m_cutTool : m_tool;
}

void SolidCanvas::useTool(Tool* tool) {
    setCursor(tool->cursor());
    tellHint(*tool);
    redraw();
}

/// A button that turns the view does so, unless it was pressed on what the tool holds.
bool SolidCanvas::isForTool(const QMouseEvent& event, const Tool& tool) {
    return navigation().dragFor(event) == Navigation::Drag::None || tool.wants(event.position());
}

/// By the left button: with the space bar, or by a tool that does nothing else.
bool SolidCanvas::pansBy(const QMouseEvent& event, const Tool* tool) const {
    return event.button() == Qt::LeftButton && !m_active && (m_spaceDown || (tool && tool->pans()));
}

void SolidCanvas::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    const bool left = event->button() == Qt::LeftButton;
    Tool* tool = toolAt(event->position());
    if (pansBy(*event, tool)) {
        navigation().pressToPan(*event);
        return updateCursor();
    }
    const bool taken = tool && (tool->takesButton(*event) || (left && isForTool(*event, *tool)));
    if (taken && !m_active) {
        m_active = tool;
        m_activeButton = event->button();
        tool->press(*event);
        useTool(tool);
    } else if (!m_active) {
        VolumeView::mousePressEvent(event);
    }
}

/// The second press of a double click, unless the tool has a meaning for the two.
void SolidCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    Tool* tool = toolAt(event->position());
    const bool left = event->button() == Qt::LeftButton;
    if (!left || !tool || m_active || pansBy(*event, tool) || !isForTool(*event, *tool)) {
        mousePressEvent(event);
        return;
    }
    m_active = tool;
    m_activeButton = Qt::LeftButton;
    tool->doubleClick(*event);
    useTool(tool);
}

/// A move from before the press, which the system brings late, does not lead the tool: it has no button down.
void SolidCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_active && event->buttons() == Qt::NoButton) return;
    tellPointed(event->position());
    if (!m_active && navigation().isGoingOn()) {
        m_fitted = false;
        VolumeView::mouseMoveEvent(event);
        return;
    }
    Tool* tool = m_active ? m_active : toolAt(event->position());
    if (!m_active && tool != &m_cutTool) m_cutTool.move(*event);
    if (!tool) return;
    tool->move(*event);
    useTool(tool);
}

void SolidCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_active && event->button() == m_activeButton) {
        Tool* tool = std::exchange(m_active, nullptr);
        tool->release(*event);
        useTool(tool);
        return;
    }
    const bool turned = navigation().isGoingOn() && !m_spaceDown;
    const bool click = navigation().isClick(*event);
    if (click && event->button() == Qt::RightButton && m_tool && !m_active) {
        navigation().end();
        const MenuPlace place = m_tool->menuAt(event->position());
        if (place != MenuPlace::None) emit menuWanted(event->globalPosition().toPoint(), place);
        return;
    }
    VolumeView::mouseReleaseEvent(event);
    updateCursor();
    if (!turned || !click || event->button() != Qt::LeftButton || !m_tool) return;
    m_tool->press(*event);  // where the left button turns the view, a click is still the tool's
    m_tool->release(*event);
    useTool(m_tool);
}

void SolidCanvas::tellPointed(const QPointF& at) {
    const bool busy = navigation().isGoingOn() || m_session.isDragging() || !m_session.frame<3>();
    const SolidHit hit = busy ? SolidHit{} : pick(at);
    if (!busy) emit pointedAt(hit.cell, hit.vertex, hit.point);
    if (hit.cell < 0) {
        emit pointed({});
        return;
    }
    const QLocale locale;
    const double minimum = 1e-9 * m_session.frame()->diagonal;
    const auto number = [&](double x) { return locale.toString(std::abs(x) < minimum ? 0.0 : x, 'g', 4); };
    QString text =
        QStringLiteral("%1, %2, %3").arg(number(hit.point.x()), number(hit.point.y()), number(hit.point.z()));
    text = tr("Cell %1").arg(hit.cell) + QStringLiteral("   ") + text;
    if (m_map) {
        const auto values = shownValues(m_session, m_measure);
        text = measureName(m_measure, 3) + ' ' + measureText(m_measure, values[hit.cell]) +
               QStringLiteral("   ") + text;
    }
    emit pointed(text);
}

void SolidCanvas::wheelEvent(QWheelEvent* event) {
    m_fitted = false;
    VolumeView::wheelEvent(event);
}

void SolidCanvas::setSpaceDown(bool down) {
    m_spaceDown = down;
    updateCursor();
}

void SolidCanvas::updateCursor() {
    if (navigation().drag() == Navigation::Drag::Pan)
        setCursor(Qt::ClosedHandCursor);
    else if (m_spaceDown)
        setCursor(Qt::OpenHandCursor);
    else
        setCursor(m_tool ? m_tool->cursor() : QCursor(Qt::ArrowCursor));
}

void SolidCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) setSpaceDown(false);
}

void SolidCanvas::focusOutEvent(QFocusEvent* event) {
    setSpaceDown(false);
    VolumeView::focusOutEvent(event);
}

void SolidCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !m_active) {
        if (!event->isAutoRepeat()) setSpaceDown(true);
        return;
    }
    if (m_active && m_active->key(*event)) {
        useTool(m_active);
        if (m_tool == m_active && event->key() == Qt::Key_Escape) m_active = nullptr;
        return;
    }
    if (!m_active && m_tool && m_tool->key(*event)) {
        useTool(m_tool);
        return;
    }
    VolumeView::keyPressEvent(event);
}

void SolidCanvas::leaveEvent(QEvent*) {
    if (m_tool) m_tool->leave();
    redraw();
    emit pointed({});
}

void SolidCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        applyTheme();
        refresh();
    }
    VolumeView::changeEvent(event);
}

/// During a gesture all plain keys are the tool's; arrows, Escape and digits belong to the view as long as it
/// has the focus.
bool SolidCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* keys = static_cast<QKeyEvent*>(event);
        const int key = keys->key();
        const bool plain = !(keys->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
        const bool owned = m_tool && m_tool->ownsKey(*keys);
        if (owned || (m_active && plain) || (key >= Qt::Key_Left && key <= Qt::Key_Down) ||
            key == Qt::Key_Escape) {
            event->accept();
            return true;
        }
    }
    return VolumeView::event(event);
}

}  // namespace wend
