#pragma once

class QDialogButtonBox;
class QPushButton;

namespace wend {

/// Adds the main button of an export dialog.
QPushButton* addExportButton(QDialogButtonBox& box);

}  // namespace wend
