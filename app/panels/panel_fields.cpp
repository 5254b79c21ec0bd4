#include "app/panels/panel_fields.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace wend {

namespace {

bool isEnter(const QEvent& event) {
    if (event.type() != QEvent::KeyPress) return false;
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

}  // namespace

PanelFields::PanelFields(QWidget& panels) : QObject(&panels) {
    for (auto* box : panels.findChildren<QAbstractSpinBox*>()) {
        box->setKeyboardTracking(false);  // a change is shown again, and not while the number is being typed
        box->installEventFilter(this);
    }
    for (auto* text : panels.findChildren<QLineEdit*>()) text->installEventFilter(this);
}

bool PanelFields::eventFilter(QObject* watched, QEvent* event) {
    if (!isEnter(*event)) return QObject::eventFilter(watched, event);
    takeEnter(*watched, static_cast<QKeyEvent&>(*event));
    return true;
}

/// The field first, so that it knows its number.
void PanelFields::takeEnter(QObject& field, QKeyEvent& key) {
    field.event(&key);
    key.accept();
    emit done();
}

}  // namespace wend
