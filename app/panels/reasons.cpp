#include "app/panels/reasons.h"

#include <QCoreApplication>

#include "app/panels/panel_parts.h"

namespace wend {

void allow(QWidget* widget, bool allowed, const QString& whyNot) {
    widget->setEnabled(allowed);
    describe(widget, widget->accessibleName(), widget->accessibleDescription());
    if (allowed || whyNot.isEmpty()) return;
    widget->setToolTip(QStringLiteral("<p><i>%1</i></p>").arg(whyNot.toHtmlEscaped()) + widget->toolTip());
    widget->setStatusTip(whyNot);
}

QString chooseFirst() {
    return QCoreApplication::translate("Reasons", "Choose one in the list first.");
}

}  // namespace wend
