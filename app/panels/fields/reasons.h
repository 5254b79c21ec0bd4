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
/// The reason where something acts on an entry of a list, and none is chosen.
QString chooseFirst();

}  // namespace wend
