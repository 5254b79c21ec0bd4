#include "app/window/actions/menus.h"

#include <QApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QRegularExpression>
#include <QSet>
#include <QToolTip>

#include "app/panels/fields/panel_parts.h"
#include "app/session/shape_session.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/curve_actions.h"
#include "app/window/actions/depth_actions.h"
#include "app/window/actions/pin_actions.h"

namespace wend {

namespace {

/// Returns the mnemonic; null if there is none.
QChar letterOf(const QString& text) {
    static const QRegularExpression letter(QStringLiteral("&([^&\\s])"));
    const auto found = letter.match(QString(text).remove(QStringLiteral("&&")));
    return found.hasMatch() ? found.captured(1)[0].toUpper() : QChar();
}

/// Assigns a free letter; languages without an alphabet have one in brackets at the end.
QString withFreeLetter(const QString& text, const QSet<QChar>& taken) {
    static const QRegularExpression bracket(QStringLiteral("\\(&.\\)"));
    if (text.contains(bracket)) {
        for (char letter = 'A'; letter <= 'Z'; ++letter)
            if (!taken.contains(QLatin1Char(letter)))
                return QString(text).replace(bracket, QStringLiteral("(&%1)").arg(QLatin1Char(letter)));
        return QString(text).remove(bracket);
    }
    QString plain = withoutKey(text);
    for (qsizetype i = 0; i < plain.size(); ++i)
        if (plain[i].isLetter() && !taken.contains(plain[i].toUpper())) return plain.insert(i, u'&');
    return plain;
}

}  // namespace

ContextMenu::ContextMenu(const Offers& offers, QObject* parent)
    : QObject(parent), m_offers(offers), m_menu(std::make_unique<QMenu>()) {}

void ContextMenu::popUp(const QPoint& global, MenuPlace place) {
    if (place == MenuPlace::None || m_offers.session.document().isEmpty()) return;
    if (place == MenuPlace::Curve) {
        m_offers.curves.popUp(global);
        return;
    }
    m_offers.curves.refresh();
    m_menu->clear();
    if (place == MenuPlace::Handle)
        offerPin();
    else
        offerCanvas();
    m_menu->popup(global);
}

void ContextMenu::offerPin() {
    const Actions& a = m_offers.actions;
    m_menu->addSection(m_offers.session.pins().nameOf(m_offers.session.selection().handles()));
    if (m_offers.session.document().dimension() == 2) m_menu->addMenu(m_offers.depth.menu());
    m_offers.pins.fill(*m_menu);
    m_menu->addSeparator();
    m_menu->addAction(m_offers.curves.make);
    m_menu->addAction(a.remove);
    m_menu->addSeparator();
    m_menu->addActions({a.selectAll, a.selectNone});
}

void ContextMenu::offerCanvas() {
    const Actions& a = m_offers.actions;
    m_menu->addActions({a.undo, a.redo});
    m_menu->addSeparator();
    m_menu->addActions({a.pinTool, a.selectTool, a.selectAll, m_offers.pins.showAll});
    m_menu->addSeparator();
    m_menu->addActions({a.showMesh, a.showMap, a.hideOverlays});
    m_menu->addSeparator();
    m_menu->addActions({a.fit, a.actualSize});
}

void makeLettersUnique(QMenu& menu) {
    QSet<QChar> taken;
    QList<QAction*> others;
    for (QAction* action : menu.actions()) {
        if (action->menu()) makeLettersUnique(*action->menu());
        const QChar letter = letterOf(action->text());
        if (letter.isNull()) continue;
        if (taken.contains(letter))
            others << action;
        else
            taken << letter;
    }
    for (QAction* action : others) {
        action->setText(withFreeLetter(action->text(), taken));
        if (const QChar letter = letterOf(action->text()); !letter.isNull()) taken << letter;
    }
}

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
