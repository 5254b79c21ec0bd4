#include "app/window/export/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

namespace wend {

QString askFileToWrite(QWidget* parent, const QString& title, const QString& proposal,
                       const QString& filter) {
    const QFileInfo proposed(proposal);
    QFileDialog dialog(parent, title, proposed.absolutePath(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    static const QRegularExpression onlyOne(QStringLiteral(R"(\(\*\.([^ )]+)\)$)"));
    const QRegularExpressionMatch extension = onlyOne.match(filter);
    dialog.setDefaultSuffix(extension.hasMatch() ? extension.captured(1) : proposed.suffix());
    dialog.selectFile(proposed.fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace wend
