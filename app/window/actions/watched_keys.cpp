#include "app/window/actions/watched_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTextEdit>
#include <QWidget>
#include <utility>

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

template <class... Kinds>
bool isOneOf(const QObject* widget) {
    return (qobject_cast<const Kinds*>(widget) || ...);
}

bool usesSpace(const QObject* widget) {
    return isOneOf<QLineEdit, QTextEdit, QAbstractSpinBox, QAbstractButton, QComboBox, QAbstractItemView>(
        widget);
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

SpaceTap::SpaceTap(QWidget& window, QAction& action) : QObject(&window), m_window(window), m_action(action) {
    qApp->installEventFilter(this);
}

/// Events that are not accepted propagate to parents: only the first one counts.
bool SpaceTap::isOurs(const QObject* watched) const {
    const QWidget* focus = QApplication::focusWidget();
    return watched == focus && focus->window() == &m_window && !QApplication::activePopupWidget() &&
           !usesSpace(focus);
}

void SpaceTap::press(const QKeyEvent& key) {
    m_down = key.key() == Qt::Key_Space && !key.modifiers() && !key.isAutoRepeat() && !m_buttons;
}

void SpaceTap::release(const QKeyEvent& key) {
    if (key.key() != Qt::Key_Space || key.isAutoRepeat()) return;
    if (std::exchange(m_down, false)) m_action.trigger();
}

bool SpaceTap::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
            if (isOurs(watched)) press(static_cast<QKeyEvent&>(*event));
            return false;
        case QEvent::KeyRelease:
            if (isOurs(watched)) release(static_cast<QKeyEvent&>(*event));
            return false;
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
            m_buttons = static_cast<QMouseEvent&>(*event).buttons();
            m_down = false;
            return false;
        case QEvent::Wheel:
        case QEvent::FocusIn:
        case QEvent::WindowDeactivate:
            m_down = false;
            return false;
        default:
            return false;
    }
}

}  // namespace wend
