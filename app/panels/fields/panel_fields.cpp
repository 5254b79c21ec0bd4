#include "app/panels/fields/panel_fields.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSlider>
#include <QSpinBox>

namespace wend {

namespace {

int pressedKey(const QEvent& event) {
    return event.type() == QEvent::KeyPress ? static_cast<const QKeyEvent&>(event).key() : 0;
}

bool isEnter(const QEvent& event) {
    return pressedKey(event) == Qt::Key_Return || pressedKey(event) == Qt::Key_Enter;
}

bool isTyped(const QObject& widget) {
    return qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget);
}

bool isField(const QObject& widget) {
    return isTyped(widget) || qobject_cast<const QComboBox*>(&widget) ||
           qobject_cast<const QSlider*>(&widget);
}

}  // namespace

PanelFields::PanelFields(QWidget& panels) : QObject(&panels) {
    for (auto* box : panels.findChildren<QAbstractSpinBox*>())
        box->setKeyboardTracking(false);  // a change is shown again, and not while the number is being typed
    for (auto* text : panels.findChildren<QLineEdit*>()) selectOnlyWithKeyboard(*text);
    for (auto* widget : panels.findChildren<QWidget*>()) {
        if (!isField(*widget)) continue;
        widget->installEventFilter(this);
        if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
    }
}

/// Removes the selection that a field makes if it loses the keyboard while it takes its number.
void PanelFields::selectOnlyWithKeyboard(QLineEdit& text) {
    connect(&text, &QLineEdit::selectionChanged, this, [&text] {
        if (text.hasSelectedText() && !text.hasFocus()) text.deselect();
    });
}

bool PanelFields::eventFilter(QObject* watched, QEvent* event) {
    if (isTyped(*watched) && isEnter(*event)) {
        takeEnter(*watched, static_cast<QKeyEvent&>(*event));
        return true;
    }
    if (isTyped(*watched) && pressedKey(*event) == Qt::Key_Escape) {
        giveUp(*watched);
        return true;
    }
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();  // the panels get it then
        return true;
    }
    return QObject::eventFilter(watched, event);
}

/// Passes the key to the field first, so that it takes its number.
void PanelFields::takeEnter(QObject& field, QKeyEvent& key) {
    field.event(&key);
    key.accept();
    emit done();
}

/// Discards the text that is being typed.
void PanelFields::giveUp(QObject& field) {
    if (auto* whole = qobject_cast<QSpinBox*>(&field)) whole->setValue(whole->value());
    if (auto* number = qobject_cast<QDoubleSpinBox*>(&field)) number->setValue(number->value());
    emit done();
}

}  // namespace wend
