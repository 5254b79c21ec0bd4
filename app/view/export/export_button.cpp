#include "app/view/export/export_button.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QStyle>

namespace wend {

/// The box gives its buttons the style at once: what it goes by has to be told anew.
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
