#pragma once

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QToolButton>
#include <algorithm>

/// Finds clipped texts in a window, and widgets without an accessible name.

namespace wend::test {

/// Returns the description of a widget in a test's message.
inline QString placeOf(const QWidget& widget, const QString& text) {
    const QWidget* parent = widget.parentWidget();
    return QStringLiteral("“%1” (%2 in %3)")
        .arg(text, widget.metaObject()->className(), parent ? parent->metaObject()->className() : "nothing");
}

inline bool isIconOnly(const QWidget& widget) {
    const auto* tool = qobject_cast<const QToolButton*>(&widget);
    return tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
}

/// The words of a label or a button; rich text is measured by the label itself.
inline QString wordsOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return button && !isIconOnly(widget) ? button->text() : QString();
}

/// Returns the size that the text needs, as bold as a chosen button's.
inline QSize neededFor(const QWidget& widget, const QString& text) {
    const auto* label = qobject_cast<const QLabel*>(&widget);
    if (label && label->wordWrap()) return {0, label->heightForWidth(label->width())};
    if (label && Qt::mightBeRichText(text)) return label->sizeHint();
    if (qobject_cast<const QCheckBox*>(&widget) || qobject_cast<const QRadioButton*>(&widget) ||
        qobject_cast<const QPushButton*>(&widget))
        return widget.sizeHint();
    QFont font = widget.font();
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    if (button && button->isCheckable()) font.setWeight(QFont::DemiBold);
    return QFontMetrics(font).size(Qt::TextShowMnemonic, text);
}

/// Returns the width of the widest entry, since any may be the chosen one.
inline int neededFor(const QComboBox& box) {
    int width = 0;
    for (int i = 0; i < box.count(); ++i) {
        const int icon = box.itemIcon(i).isNull() ? 0 : box.iconSize().width() + 4;
        width = std::max(width, icon + box.fontMetrics().horizontalAdvance(box.itemText(i)));
    }
    return width;
}

inline int roomOf(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    return box.style()
        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
        .width();
}

/// Returns the part of a widget that its parents leave visible. Scrolling parents clip at the sides only.
inline QRect leftOf(const QWidget& widget) {
    QRect rect = widget.rect();
    bool scrolls = false;
    for (const QWidget* at = &widget; !at->isWindow() && at->parentWidget();) {
        rect.translate(at->pos());
        at = at->parentWidget();
        scrolls = scrolls || qobject_cast<const QAbstractScrollArea*>(at->parentWidget());
        QRect room = at->rect();
        if (scrolls) room = QRect(room.left(), rect.top(), room.width(), rect.height());
        rect = rect.intersected(room);
    }
    return rect;
}

inline void tellNarrow(const QWidget& widget, QStringList& wrong) {
    const auto tell = [&](const QString& text, int needed, int room, const char* what) {
        wrong << QStringLiteral("%1: %2 of %3 pixels of %4")
                     .arg(placeOf(widget, text))
                     .arg(room)
                     .arg(needed)
                     .arg(QLatin1String(what));
    };
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget);
        combo && neededFor(*combo) > roomOf(*combo))
        tell(combo->accessibleName(), neededFor(*combo), roomOf(*combo), "width");
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget);
        line && line->objectName() != "qt_spinbox_lineedit") {
        const int needed = line->fontMetrics().horizontalAdvance(line->placeholderText());
        if (needed > line->width() - 6) tell(line->placeholderText(), needed, line->width() - 6, "width");
    }
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget)) {
        const auto* line = box->findChild<QLineEdit*>();
        const int needed = line->fontMetrics().horizontalAdvance(line->text()) + 4;
        if (needed > line->width()) tell(line->text(), needed, line->width(), "width");
    }
    const QString text = wordsOf(widget);
    if (text.isEmpty()) return;
    const QSize needed = neededFor(widget, text);
    if (needed.width() > widget.width()) tell(text, needed.width(), widget.width(), "width");
    if (needed.height() > widget.height()) tell(text, needed.height(), widget.height(), "height");
    if (const QRect left = leftOf(widget); left.size() != widget.size())
        wrong << QStringLiteral("%1: only %2 × %3 of %4 × %5 pixels are within its window")
                     .arg(placeOf(widget, text))
                     .arg(left.width())
                     .arg(left.height())
                     .arg(widget.width())
                     .arg(widget.height());
}

/// Adds texts that overlap by more than the rims that buttons have around them.
inline void tellOverlaps(const QWidget& parent, QStringList& wrong) {
    QList<const QWidget*> seen;
    for (const QObject* child : parent.children()) {
        const auto* widget = qobject_cast<const QWidget*>(child);
        if (!widget || widget->isWindow() || !widget->isVisible() || wordsOf(*widget).isEmpty()) continue;
        for (const QWidget* other : seen)
            if (const QRect both = widget->geometry() & other->geometry();
                both.width() > 6 && both.height() > 6)
                wrong << placeOf(*widget, wordsOf(*widget)) + " lies on " + wordsOf(*other);
        seen << widget;
    }
}

/// Describes the innermost part that determines a panel's minimum width.
inline QString widestIn(const QWidget& panel) {
    const QWidget* widest = &panel;
    for (const QWidget* next = widest; next; widest = next ? next : widest) {
        next = nullptr;
        for (const QWidget* one : widest->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
            if (one->isVisible() &&
                (!next || one->minimumSizeHint().width() > next->minimumSizeHint().width()))
                next = one;
        if (next && !next->layout()) break;
    }
    QStringList words;
    for (const QLabel* label : widest->findChildren<QLabel*>(Qt::FindDirectChildrenOnly))
        words << label->text();
    return placeOf(*widest, words.isEmpty() ? widest->objectName() : words.join(' '));
}

/// Returns widgets without room for their text or outside their window, and panels wider than their scroll
/// areas.
inline QStringList cutOff(const QWidget& window) {
    QStringList wrong;
    tellOverlaps(window, wrong);
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        if (const auto* scroll = qobject_cast<const QScrollArea*>(widget))
            if (scroll->widget() && scroll->widget()->minimumSizeHint().width() > scroll->viewport()->width())
                wrong << QStringLiteral("a panel is %1 pixels too wide: %2")
                             .arg(scroll->widget()->minimumSizeHint().width() - scroll->viewport()->width())
                             .arg(widestIn(*scroll->widget()));
        tellNarrow(*widget, wrong);
        tellOverlaps(*widget, wrong);
    }
    return wrong;
}

/// Returns widgets that take the keyboard and have no accessible name.
inline QStringList nameless(const QWidget& window) {
    QStringList wrong;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus || widget->inherits("QScrollArea") ||
            qobject_cast<QAbstractSpinBox*>(widget->parentWidget()))
            continue;
        const QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(widget);
        if (!heard || heard->text(QAccessible::Name).isEmpty())
            wrong << QStringLiteral("without a name: ") + placeOf(*widget, widget->objectName());
    }
    return wrong;
}

}  // namespace wend::test
