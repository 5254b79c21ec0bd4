#pragma once

#include <QString>

class QAction;
class QWidget;

namespace wend {

/// Enables or disables a widget that describe() has described. If disabled, its tooltip starts with the
/// reason, which the status bar shows, too.
void allow(QWidget* widget, bool allowed, const QString& whyNot);
/// Does the same for an entry of a menu.
void allow(QAction* action, bool allowed, const QString& whyNot);
/// Returns the reason for a disabled command that needs an entry of a list, if none is chosen.
QString chooseFirst();

}  // namespace wend
