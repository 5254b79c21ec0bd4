#include "app/window/export/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>

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

}  // namespace wend
