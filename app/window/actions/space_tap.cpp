#include "app/window/actions/space_tap.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTextEdit>
#include <utility>

namespace wend {

namespace {

template <class... Kinds>
bool isOneOf(const QObject* widget) {
    return (qobject_cast<const Kinds*>(widget) || ...);
}

bool usesSpace(const QObject* widget) {
    return isOneOf<QLineEdit, QTextEdit, QAbstractSpinBox, QAbstractButton, QComboBox, QAbstractItemView>(
        widget);
}

}  // namespace

SpaceTap::SpaceTap(QWidget& window) : QObject(&window), m_window(window) {
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
    if (std::exchange(m_down, false)) emit tapped();
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
