#pragma once

#include <QString>

class QWidget;

namespace wend {

/// Asks for a file to write. The extension is there before it is asked whether an existing file may be
/// replaced: never is another file replaced than the one that was asked about. Empty if cancelled.
QString askFileToWrite(QWidget* parent, const QString& title, const QString& proposal, const QString& filter);

}  // namespace wend
