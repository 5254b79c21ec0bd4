#include "app/window/actions/held_key.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QWidget>

namespace wend {

namespace {

/// Boxes of numbers have no use for letters.
bool typesText(const QObject* widget) {
    const auto* line = qobject_cast<const QLineEdit*>(widget);
    return line && !line->isReadOnly() && !qobject_cast<const QAbstractSpinBox*>(line->parent());
}

bool isPlain(const QEvent& event, Qt::Key key) {
    const auto& press = static_cast<const QKeyEvent&>(event);
    return press.key() == key && !press.modifiers();
}

}  // namespace

HeldKey::HeldKey(Qt::Key key, QWidget& window) : QObject(&window), m_key(key), m_window(window) {
    qApp->installEventFilter(this);
}

bool HeldKey::begins(QObject* watched, const QEvent& event) const {
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (!widget || widget->window() != &m_window || QApplication::activePopupWidget()) return false;
    return isPlain(event, m_key) && !typesText(watched);
}

bool HeldKey::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
            if (!begins(watched, *event)) return false;
            setHeld(true);
            return true;
        case QEvent::KeyRelease: {
            const auto& release = static_cast<const QKeyEvent&>(*event);
            if (m_held && release.key() == m_key && !release.isAutoRepeat()) setHeld(false);
            return false;
        }
        case QEvent::WindowDeactivate:
            if (watched == &m_window) setHeld(false);
            return false;
        default:
            return false;
    }
}

void HeldKey::setHeld(bool held) {
    if (held == m_held) return;
    m_held = held;
    emit heldChanged(held);
}

}  // namespace wend
