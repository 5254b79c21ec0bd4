#include "app/panels/fields/reasons.h"

#include <QAction>
#include <QCoreApplication>

#include "app/panels/fields/panel_parts.h"

namespace wend {

void allow(QWidget* widget, bool allowed, const QString& whyNot) {
    widget->setEnabled(allowed);
    describe(widget, widget->accessibleName(), widget->accessibleDescription());
    if (allowed || whyNot.isEmpty()) return;
    widget->setToolTip(QStringLiteral("<p><i>%1</i></p>").arg(whyNot.toHtmlEscaped()) + widget->toolTip());
    widget->setStatusTip(whyNot);
}

/// Keeps the help text in the property in which describe() stored it.
void allow(QAction* action, bool allowed, const QString& whyNot) {
    constexpr auto kHelp = "help";
    if (!action->property(kHelp).isValid()) action->setProperty(kHelp, action->statusTip());
    action->setEnabled(allowed);
    action->setStatusTip(allowed ? action->property(kHelp).toString() : whyNot);
    action->setToolTip(action->statusTip());
}

QString chooseFirst() {
    return QCoreApplication::translate("Reasons", "Choose one in the list first.");
}

}  // namespace wend
