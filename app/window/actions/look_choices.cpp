#include "app/window/actions/look_choices.h"

#include <QApplication>

#include "app/base/preferences.h"
#include "app/style/marks.h"
#include "app/tools/shape_view.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"

namespace wend {

AppearanceChoice::AppearanceChoice(Actions& actions, QWidget& window)
    : QObject(&window), m_actions(actions), m_window(window), m_system(QApplication::palette()) {
    using enum Appearance;
    onTriggered(
        this, actions.systemLook, [this] { apply(System); }, actions.lightLook, [this] { apply(Light); },
        actions.darkLook, [this] { apply(Dark); });
    connect(actions.markSizes.get(), &QMenu::triggered, this,
            [this](const QAction* chosen) { enlargeMarks(chosen->data().toDouble()); });
}

void AppearanceChoice::restore() {
    apply(static_cast<Appearance>(preferences::appearance.value()));
    restoreMarks();
}

void AppearanceChoice::restoreMarks() {
    const double kept = preferences::markSize.value();
    const QAction* chosen = nullptr;
    for (QAction* one : m_actions.markSizes->actions())
        if (one->data().toDouble() == kept) one->setChecked(true), chosen = one;
    setMarkSize(chosen ? kept : 1);
}

/// Updates all views at once.
void AppearanceChoice::enlargeMarks(double factor) {
    preferences::markSize.set(factor);
    setMarkSize(factor);
    for (QWidget* one : m_window.findChildren<QWidget*>()) {
        if (auto* picture = dynamic_cast<PictureShapeView*>(one)) picture->redraw();
        if (auto* solid = dynamic_cast<SolidCanvas*>(one)) solid->showLooks();
    }
}

void AppearanceChoice::apply(Appearance appearance) {
    preferences::appearance.set(static_cast<int>(appearance));
    const QPalette look = wendPalette(appearance, m_system);
    QApplication::setPalette(look);
    const QString sheet = wendStyleSheet(look);
    if (sheet != qApp->styleSheet()) qApp->setStyleSheet(sheet);  // every widget is looked at for it
    m_window.setPalette(look);
    (appearance == Appearance::System  ? m_actions.systemLook
     : appearance == Appearance::Light ? m_actions.lightLook
                                       : m_actions.darkLook)
        ->setChecked(true);
    emit changed();
}

BackdropChoice::BackdropChoice(QObject* parent) : ActionMaker(parent), m_menu(new QMenu), m_group(oneOf({})) {
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
