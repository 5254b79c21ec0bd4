#include "app/panels/material_panel.h"

#include "app/panels/panel_parts.h"
#include "app/panels/whole_material.h"

namespace wend {

MaterialPanel::MaterialPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_slider(new EnergySlider(this)), m_help(secondLabel({}, this)) {
    m_help->setMinimumHeight(2 * m_help->fontMetrics().lineSpacing());
    m_help->setAlignment(Qt::AlignTop);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 8);
    layout->setSpacing(8);
    layout->addWidget(panelTitle(tr("Keep"), this));
    layout->addWidget(m_slider);
    layout->addWidget(m_help);
    connect(m_slider, &EnergySlider::phiChosen, this, &MaterialPanel::choosePhi);
    connect(&m_session.document(), &Document::projectChanged, this, &MaterialPanel::showProject);
    showProject();
}

void MaterialPanel::showProject() {
    setEnabled(!m_session.document().isEmpty());
    if (m_session.document().isEmpty()) return;
    const Project& project = *m_session.document().project();
    const double phi = wholePhi(project);
    m_slider->setDimension(project.dimension());
    m_slider->setPhi(phi);
    const EnergyScale& scale = m_slider->scale();
    const int stop = scale.stopAt(phi);
    const int below = static_cast<int>(scale.positionOf(phi));
    m_help->setText(
        stop >= 0 ? scale.stops()[stop].shortHelp
                  : tr("Between %1 and %2.").arg(scale.stops()[below].name, scale.stops()[below + 1].name));
}

void MaterialPanel::choosePhi(double phi, int gesture) {
    changeWholePhi(m_session.document(), phi, gesture);
}

}  // namespace wend
