#include "app/window/export/dialogs.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>
#include <QStyle>

namespace wend {

QString askFileToWrite(QWidget* parent, const QString& title, const QString& proposal,
                       const QString& filter) {
    const QFileInfo proposed(proposal);
    QFileDialog dialog(parent, title, proposed.absolutePath(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(proposed.suffix());
    dialog.selectFile(proposed.fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QDialogButtonBox* dialogButtons(QDialogButtonBox::StandardButtons which, QDialog* dialog) {
    auto* buttons = new QDialogButtonBox(which, dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    return buttons;
}

/// Refreshes the button's style after its property is set, because the box styles its buttons at once.
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
