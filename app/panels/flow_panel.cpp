#include "app/panels/flow_panel.h"

#include <QPushButton>
#include <QSlider>
#include <cmath>

#include "app/panels/fields/memory_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/picture_tip.h"
#include "app/panels/fields/reasons.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"
#include "app/session/settle_step.h"

namespace wend {

FlowPanel::FlowPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_memory(new MemorySlider(this)),
      m_settle(new QPushButton(tr("Relax"), this)) {
    m_settle->setObjectName(QStringLiteral("settle"));
    describe(m_settle, tr("Relax"),
             tr("The pins stay where they are, and what lies between them releases its tension. This takes "
                "one second at the end of the film."));
    showInTip(m_settle, relaxPictures);
    showInTip(m_memory->slider(), memoryPictures);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->setSpacing(8);
    layout->addLayout(sideBySide({panelTitle(tr("Springs back"), this), nullptr, m_settle}));
    layout->addWidget(m_memory);
    connect(m_settle, &QPushButton::clicked, this, [this] { settleAtEnd(m_session); });
    connect(m_memory, &MemorySlider::memoryChosen, this, [this](double memory, int gesture) {
        changeSetting(m_session.document(), "material.memory", memory, gesture);
    });
    connect(&m_session.document(), &Document::projectChanged, this, &FlowPanel::showProject);
    showProject();
}

void FlowPanel::showProject() {
    setEnabled(!m_session.document().isEmpty());
    if (m_session.document().isEmpty()) return;
    const double memory = settingOf(*m_session.document().project(), "material.memory");
    const bool isElastic = std::isinf(memory);
    allow(
        m_settle, canSettle(m_session.document()),
        isElastic ? tr("A shape that springs back fully is always relaxed.") : tr("Nothing has moved yet."));
    m_memory->setMemory(memory);
}

}  // namespace wend
