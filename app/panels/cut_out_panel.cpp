#include "app/panels/cut_out_panel.h"

#include <QVBoxLayout>

#include "app/project/edits/document.h"

namespace wend {

QString CutOutPanel::notACutOut() {
    return tr("Only a cut-out has this. An outline that you have drawn stays as you drew it.");
}

CutOutPanel::CutOutPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_settings(document, this, notACutOut()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 4, 16, 4);
    layout->setSpacing(8);
    for (const char* key : {"domain.outline.gap", "domain.outline.smallest"})
        layout->addWidget(m_settings.row(key));
    connect(&document, &Document::projectChanged, this, [this] { m_settings.show(); });
    m_settings.show();
}

void CutOutPanel::setPart(int part) {
    m_settings.setPart(part);
    m_settings.show();
}

}  // namespace wend
