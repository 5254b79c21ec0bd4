#include "app/window/toolbar/option_row.h"

#include <QLabel>
#include <QToolButton>

#include "app/panels/fields/panel_parts.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"

namespace wend {

OptionRow::OptionRow(const Toolbox& tools, const Actions& actions, const ToolOptions& options,
                     QWidget* parent)
    : QToolBar(tr("Options"), parent), m_tools(tools), m_actions(actions), m_options(options) {
    setObjectName(QStringLiteral("optionRow"));
    setMovable(false);
    setIconSize({20, 20});
    setFixedHeight(40);
    setContextMenuPolicy(Qt::PreventContextMenu);
    connect(&m_tools, &Toolbox::changed, this, &OptionRow::showTool);
    showTool();
}

/// Options of solids are hidden with their actions while a picture is open.
void OptionRow::showTool() {
    clear();
    const ToolKind* kind = m_tools.current();
    if (!kind) return;
    QAction* tool = m_tools.action(QString::fromLatin1(kind->id));
    auto* title = new QLabel(withoutKey(tool->text()));
    title->setProperty("role", "title");
    title->setContentsMargins(8, 0, 8, 0);
    addWidget(title);
    bool any = false;
    for (QAction* option : m_options.of(*kind)) {
        option ? addAction(option) : static_cast<void>(addSeparator());
        any = any || (option && option->isVisible());
    }
    if (m_tools.mode() == Mode::Animate) return showMotion();
    if (any) return;
    auto* help = new QLabel(ActionMaker::helpOf(*tool));
    help->setProperty("role", "second");
    addWidget(help);
}

void OptionRow::showMotion() {
    QAction* speed = m_actions.speed->menuAction();
    addSeparator();
    for (QAction* action : {m_actions.record, m_actions.onionSkin, m_actions.loop}) {
        addAction(action);
        qobject_cast<QToolButton*>(widgetForAction(action))->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    addAction(speed);
    qobject_cast<QToolButton*>(widgetForAction(speed))->setPopupMode(QToolButton::InstantPopup);
}

}  // namespace wend
