#include "app/panels/balance_panel.h"

#include <QVBoxLayout>

#include "app/panels/fields/option_field.h"
#include "app/panels/fields/picture_tip.h"
#include "app/project/options/settings.h"

namespace wend {

BalancePanel::BalancePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_settings(session.document(), this) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 4, 16, 10);
    layout->setSpacing(8);
    for (const char* key : {"material.phi", "material.smoothing.length"})
        layout->addWidget(m_settings.row(key));
    showInTip(m_settings.field("material.phi").focusProxy(),
              [this] { return energyPictures(m_session.document().dimension()); });
    showInTip(m_settings.field("material.smoothing.length").focusProxy(), reachPictures);
    connect(&m_session.document(), &Document::projectChanged, this, &BalancePanel::showProject);
    showProject();
}

/// Shows the project. Without smoothing the length is 0 and can still be set.
void BalancePanel::showProject() {
    setEnabled(!m_session.document().isEmpty());
    if (m_session.document().isEmpty()) return;
    m_settings.show();
    const bool paper = settingOf(*m_session.document().project(), "material.smoothing.kind") ==
                       static_cast<int>(SmoothingKind::Paper);
    m_settings.field("material.smoothing.length")
        .allow(!paper, tr("This project smooths as in the paper, with λ; its file says how much."));
}

}  // namespace wend
