#pragma once

#include <QDialogButtonBox>

class QDialog;

namespace wend {

/// Asks for a file to write. The extension is there before it is asked whether an existing file may be
/// replaced: never is another file replaced than the one that was asked about. Empty if cancelled.
QString askFileToWrite(QWidget* parent, const QString& title, const QString& proposal, const QString& filter);

/// Makes the buttons of a dialog, which accept or reject it.
QDialogButtonBox* dialogButtons(QDialogButtonBox::StandardButtons which, QDialog* dialog);
/// Adds the main button of an export dialog.
QPushButton* addExportButton(QDialogButtonBox& box);

}  // namespace wend
