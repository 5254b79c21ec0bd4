#pragma once

class QDialogButtonBox;
class QPushButton;

namespace wend {

/// The button that a dialog of exports is there for, beside what else its box has.
QPushButton* addExportButton(QDialogButtonBox& box);

}  // namespace wend
