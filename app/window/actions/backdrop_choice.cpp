#include "app/window/actions/backdrop_choice.h"
#include "app/base/preferences.h"

#include <QActionGroup>

namespace wend {

BackdropChoice::BackdropChoice(QObject* parent)
    : ActionMaker(parent), m_menu(new QMenu), m_group(new QActionGroup(this)) {
    m_menu->setTitle(tr("Bac&kdrop"));
    const std::pair<Words, QColor> choices[] = {
        {{tr("&Checks"), tr("Checks behind a picture, the workspace behind a solid")}, QColor()},
        {{tr("&White"), tr("White behind the shape, to see dark edges")}, QColor(Qt::white)},
        {{tr("&Grey"), tr("Grey behind the shape")}, QColor(128, 128, 128)},
        {{tr("&Black"), tr("Black behind the shape, to see light edges")}, QColor(Qt::black)}};
    const int remembered = preferences::backdrop.value();
    for (const auto& [words, colour] : choices) {
        QAction* one = addToggle(QStringLiteral("backdrop%1").arg(m_group->actions().size() + 1), words, {});
        one->setData(colour);
        m_menu->addAction(m_group->addAction(one));
    }
    m_group->actions().at(std::clamp(remembered, 0, 3))->setChecked(true);
    connect(m_group, &QActionGroup::triggered, this, &BackdropChoice::choose);
}

QColor BackdropChoice::colour() const {
    return m_group->checkedAction()->data().value<QColor>();
}

void BackdropChoice::choose(const QAction* chosen) {
    preferences::backdrop.set(static_cast<int>(m_group->actions().indexOf(chosen)));
    emit changed(colour());
}

}  // namespace wend
