#include "app/panels/material_panel.h"

#include <QEvent>
#include <QLocale>
#include <QPushButton>

#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"
#include "app/session/calm_follower.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr double kMuch = 2;  // growth from which on something else is proposed
constexpr int kHead = 24;

}  // namespace

MaterialPanel::MaterialPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_title(panelTitle({}, this)),
      m_slider(new EnergySlider(this, EnergySlider::Stops::Tiles)),
      m_help(secondLabel({}, this)),
      m_grown(new QPushButton(this)) {
    m_grown->setObjectName(QStringLiteral("grown"));
    m_grown->setIcon(wendIcon(QStringLiteral("warning"), Theme::of(palette()).warning));
    m_grown->hide();
    m_help->setMinimumHeight(m_help->fontMetrics().lineSpacing());
    m_help->setAlignment(Qt::AlignTop);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 6, 16, 6);
    layout->setSpacing(6);
    m_title->setMinimumHeight(kHead);
    layout->addLayout(sideBySide({m_title, nullptr, m_grown}));
    layout->addWidget(m_slider);
    layout->addWidget(m_help);
    connect(m_slider, &EnergySlider::phiChosen, this, &MaterialPanel::choosePhi);
    connect(m_grown, &QPushButton::clicked, this,
            [this] { choosePhi(m_slider->scale().stops().at(calmerStop()).phi, -1); });
    new CalmFollower(m_session, CalmFollower::Of::Frames, this, [this] { showGrowth(); });
    connect(&m_session.document(), &Document::projectChanged, this, &MaterialPanel::showProject);
    showProject();
    showGrowth();
}

void MaterialPanel::setBesideBrush(bool beside) {
    m_besideBrush = beside;
    showGrowth();
}

void MaterialPanel::showProject() {
    setEnabled(!m_session.document().isEmpty());
    if (m_session.document().isEmpty()) return;
    const double phi = settingOf(*m_session.document().project(), "material.phi");
    m_slider->setDimension(m_session.document().dimension());
    m_slider->setPhi(phi);
    const EnergyScale& scale = m_slider->scale();
    const int stop = scale.stopAt(phi);
    const int below = static_cast<int>(scale.positionOf(phi));
    m_help->setText(
        stop >= 0 ? scale.stops()[stop].shortHelp
                  : tr("Between %1 and %2.").arg(scale.stops()[below].name, scale.stops()[below + 1].name));
    showGrowth();
}

/// Returns the stop with less growth: length, or area below that; −1 if there is none.
int MaterialPanel::calmerStop() const {
    const double at = m_slider->scale().positionOf(m_slider->phi());
    return at > 1 ? 1 : at > 0 ? 0 : -1;
}

void MaterialPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_grown->setIcon(wendIcon(QStringLiteral("warning"), Theme::of(palette()).warning));
}

void MaterialPanel::showGrowth() {
    const FramePtr& frame = m_session.frame();
    const bool much = frame && frame->growth > kMuch && calmerStop() >= 0;
    m_grown->setVisible(much);
    m_title->setText(!m_besideBrush ? tr("Keep") : much ? tr("Whole shape") : tr("Keep: whole shape"));
    if (!much) return;
    const QString factor = QLocale().toString(frame->growth, 'f', frame->growth < 10 ? 1 : 0);
    m_grown->setText(tr("Grown ×%1 – try %2").arg(factor, m_slider->scale().stops().at(calmerStop()).name));
    describe(m_grown, m_grown->text(),
             tr("The shape has become much larger than at rest. A click keeps more of its size."));
}

void MaterialPanel::choosePhi(double phi, int gesture) {
    changeSetting(m_session.document(), "material.phi", phi, gesture);
}

}  // namespace wend
