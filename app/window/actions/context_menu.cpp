#include "app/window/actions/context_menu.h"

#include "app/session/shape_session.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/curve_actions.h"
#include "app/window/actions/depth_actions.h"
#include "app/window/actions/pin_actions.h"

namespace wend {

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
    m_menu->addSection(m_offers.session.nameOf(m_offers.session.selection().handles()));
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

}  // namespace wend
