#include "app/window/export/export_button.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QStyle>

namespace wend {

/// The box styles its buttons at once, so the style must be refreshed after the property is set.
QPushButton* addExportButton(QDialogButtonBox& box) {
    const QString text = QCoreApplication::translate("wend::ExportDialog", "E&xport…");
    QPushButton* button = box.addButton(text, QDialogButtonBox::AcceptRole);
    button->setProperty("role", "primary");
    button->style()->unpolish(button);
    button->style()->polish(button);
    button->setDefault(true);
    return button;
}

}  // namespace wend
