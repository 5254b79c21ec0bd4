#include "app/window/actions/menu_reasons.h"

#include <QApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>

namespace wend {

MenuReasons::MenuReasons(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool MenuReasons::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip) return false;
    auto* menu = qobject_cast<QMenu*>(watched);
    if (!menu) return false;
    const auto& help = static_cast<const QHelpEvent&>(*event);
    QAction* entry = menu->actionAt(help.pos());
    if (!entry || entry->isEnabled() || entry->statusTip().isEmpty()) return false;
    QToolTip::showText(help.globalPos(), entry->statusTip(), menu, menu->actionGeometry(entry));
    return true;
}

}  // namespace wend
