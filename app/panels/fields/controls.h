#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QStringList>
#include <QToolButton>

#include "app/panels/fields/number_boxes.h"

/// Controls of panels, each made in one step: its words, its numbers, and what a change by the user does.
/// The panel is the parent of the control, until a layout places it in another one, and the receiver of its
/// signal. `id` is the object name. `help` is for the tooltip and what reads the screen aloud, as `name` is
/// where the text would not tell enough.
namespace wend {

/// The numbers of a box; fewer than 0 decimals: its own.
struct Numbers {
    double min, max;
    int decimals = 2;
    double step = 1;
    QString unit = {};
};

/// Sets the text of a button, and describes it.
void setWords(QAbstractButton* button, const char* id, const QString& text, const QString& help,
              const QString& name = {});
void describe(QWidget* field, const char* id, const QString& name, const QString& help);
void limit(QDoubleSpinBox* box, const Numbers& numbers);

template <class Button, class Panel, class Slot>
Button* buttonFor(Panel* panel, const char* id, const QString& text, const QString& help, const Slot& slot,
                  const QString& name = {}) {
    auto* button = new Button(panel);
    setWords(button, id, text, help, name);
    QObject::connect(button, &QAbstractButton::clicked, panel, slot);
    return button;
}

template <class Panel, class Slot>
QPushButton* pushButton(Panel* panel, const char* id, const QString& text, const QString& help,
                        const Slot& slot, const QString& name = {}) {
    return buttonFor<QPushButton>(panel, id, text, help, slot, name);
}

/// Makes a small button, in a row of such or beside a title.
template <class Panel, class Slot>
QToolButton* chip(Panel* panel, const char* id, const QString& text, const QString& help, const Slot& slot,
                  const QString& name = {}) {
    auto* button = buttonFor<QToolButton>(panel, id, text, help, slot, name);
    button->setProperty("role", "chip");
    return button;
}

/// Makes a box to tick; the slot takes a change by code, too.
template <class Panel, class Slot>
QCheckBox* checkBox(Panel* panel, const char* id, const QString& text, const QString& help,
                    const Slot& slot) {
    auto* box = new QCheckBox(panel);
    setWords(box, id, text, help);
    QObject::connect(box, &QCheckBox::toggled, panel, slot);
    return box;
}

/// Makes a list of entries to choose from; the slot may take the place of the chosen one.
template <class Panel, class Slot>
QComboBox* choiceBox(Panel* panel, const char* id, const QString& name, const QString& help,
                     const QStringList& entries, const Slot& slot) {
    auto* box = new QComboBox(panel);
    box->addItems(entries);
    describe(box, id, name, help);
    QObject::connect(box, &QComboBox::activated, panel, slot);
    return box;
}

template <class Box = ExactBox, class Panel, class Slot>
Box* numberBox(Panel* panel, const char* id, const QString& name, const QString& help, const Numbers& numbers,
               const Slot& slot) {
    auto* box = new Box(panel);
    limit(box, numbers);
    describe(box, id, name, help);
    QObject::connect(box, &QDoubleSpinBox::valueChanged, panel, slot);
    return box;
}

/// Connects several number boxes with one slot.
template <class Boxes, class Panel, class Slot>
void whenChanged(const Boxes& boxes, Panel* panel, const Slot& slot) {
    for (QDoubleSpinBox* box : boxes) QObject::connect(box, &QDoubleSpinBox::valueChanged, panel, slot);
}

}  // namespace wend
