#pragma once

#include <QString>

class QAction;
class QWidget;

namespace wend {

/// Enables what describe() has described, or disables it: then its tooltip begins with the reason, and the
/// status line tells it.
void allow(QWidget* widget, bool allowed, const QString& whyNot);
/// The same of an entry of a menu.
void allow(QAction* action, bool allowed, const QString& whyNot);
/// The reason where something acts on an entry of a list, and none is chosen.
QString chooseFirst();

}  // namespace wend
