#include "app/panels/cut_out_panel.h"

#include <QVBoxLayout>

#include "app/session/shape_session.h"

namespace wend {

CutOutPanel::CutOutPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_settings(session.document(), this) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 4, 16, 4);
    layout->setSpacing(8);
    for (const char* key : {"domain.outline.gap", "domain.outline.smallest"})
        layout->addWidget(m_settings.row(key));
    connect(&session.document(), &Document::projectChanged, this, [this] { m_settings.show(); });
    m_settings.show();
}

}  // namespace wend
