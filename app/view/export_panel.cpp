#include "app/view/export_panel.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/panels/panel_parts.h"
#include "app/view/actions.h"

namespace wend {

ExportPanel::ExportPanel(const Actions& actions, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(12);
    column->addWidget(panelTitle(tr("Export"), this));
    for (QAction* action : actions.exports->actions()) column->addWidget(row(action));
}

QWidget* ExportPanel::row(QAction* action) {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* button = new QPushButton(holder);
    auto* help = secondLabel({}, holder);
    column->addWidget(button);
    column->addWidget(help);
    const auto show = [action, button, help] {
        button->setText(withoutKey(action->text()));
        button->setAccessibleName(button->text());
        button->setEnabled(action->isEnabled());
        button->setToolTip(action->toolTip());
        button->setStatusTip(action->statusTip());
        help->setText(action->statusTip());
    };
    connect(action, &QAction::changed, button, show);
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    show();
    return holder;
}

}  // namespace wend
