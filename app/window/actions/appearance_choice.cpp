#include "app/window/actions/appearance_choice.h"

#include <QApplication>

#include "app/base/preferences.h"
#include "app/style/mark_size.h"
#include "app/tools/shape_view.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"

namespace wend {

AppearanceChoice::AppearanceChoice(Actions& actions, QWidget& window)
    : QObject(&window), m_actions(actions), m_window(window), m_system(QApplication::palette()) {
    for (const auto& [action, appearance] : {std::pair{actions.systemLook, Appearance::System},
                                             {actions.lightLook, Appearance::Light},
                                             {actions.darkLook, Appearance::Dark}})
        connect(action, &QAction::triggered, this, [this, look = appearance] { apply(look); });
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

}  // namespace wend
