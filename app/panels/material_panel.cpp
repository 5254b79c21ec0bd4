#include "app/panels/material_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/picture_tip.h"
#include "app/panels/fields/reasons.h"
#include "app/project/edits/document.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"
#include "app/session/calm_follower.h"
#include "app/style/theme.h"
#include "core/energy/material.h"

namespace wend {

namespace {

constexpr const char* kKey = "material.smoothing.length";
constexpr int kReachSteps = 100;
constexpr double kNear = 0.002, kFar = 0.5;  // of the shape's size

/// Rounds to three digits, which is finer than the steps.
double lengthAt(int value) {
    const double exact = kNear * std::pow(kFar / kNear, static_cast<double>(value) / kReachSteps);
    const double unit = std::pow(10, std::floor(std::log10(exact)) - 2);
    return std::round(exact / unit) * unit;
}

int stepOfReach(double length) {
    const double within = std::clamp(length, kNear, kFar);
    return static_cast<int>(std::lround(kReachSteps * std::log(within / kNear) / std::log(kFar / kNear)));
}

constexpr double kMuch = 2;  // growth from which on something else is proposed
constexpr int kHead = 24;

}  // namespace

ReachRow::ReachRow(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_slider(new JumpSlider(this)) {
    m_slider->setObjectName(QStringLiteral("reachSlider"));
    m_slider->setRange(0, kReachSteps);
    m_slider->setSingleStep(2);
    m_slider->setPageStep(20);
    describe(m_slider, tr("Pull reaches"),
             tr("How far a pin's pull spreads. Near: close to the pin, sharp. Far: soft and wide."));
    showInTip(m_slider, reachPictures);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 0, 16, 6);
    row->setSpacing(8);
    auto* name = new QLabel(tr("Pull &reaches"), this);
    name->setBuddy(m_slider);
    row->addWidget(name);
    const auto end = [&](const QString& word) {
        QLabel* label = secondLabel(word, this);
        label->setWordWrap(false);
        row->addWidget(label);
    };
    end(tr("near"));
    row->addWidget(m_slider, 1);
    end(tr("far"));
    connect(m_slider, &JumpSlider::moved, this,
            [this](int value, int gesture) { changeSetting(m_document, kKey, lengthAt(value), gesture); });
    connect(&m_document, &Document::projectChanged, this, &ReachRow::showProject);
    showProject();
}

void ReachRow::showProject() {
    if (m_document.isEmpty()) return;
    const Project& project = *m_document.project();
    const bool paper =
        settingOf(project, "material.smoothing.kind") == static_cast<int>(SmoothingKind::Paper);
    setEnabled(!paper);
    allow(m_slider, !paper, tr("This project smooths as in the paper, with λ; its file says how much."));
    const QSignalBlocker quiet(m_slider);
    if (!m_slider->isSliderDown()) m_slider->setValue(stepOfReach(settingOf(project, kKey)));
}

BalancePanel::BalancePanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_settings(document, this) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 4, 16, 10);
    layout->setSpacing(8);
    for (const char* key : {"material.phi", "material.smoothing.length"})
        layout->addWidget(m_settings.row(key));
    showInTip(m_settings.field("material.phi").focusProxy(),
              [this] { return energyPictures(m_document.dimension()); });
    showInTip(m_settings.field("material.smoothing.length").focusProxy(), reachPictures);
    connect(&m_document, &Document::projectChanged, this, &BalancePanel::showProject);
    showProject();
}

/// Shows the project. Without smoothing the length is 0 and can still be set.
void BalancePanel::showProject() {
    setEnabled(!m_document.isEmpty());
    if (m_document.isEmpty()) return;
    m_settings.show();
    const bool paper =
        settingOf(*m_document.project(), "material.smoothing.kind") == static_cast<int>(SmoothingKind::Paper);
    m_settings.field("material.smoothing.length")
        .allow(!paper, tr("This project smooths as in the paper, with λ; its file says how much."));
}

MaterialPanel::MaterialPanel(Document& document, ShapeMotion& motion, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_motion(motion),
      m_title(panelTitle({}, this)),
      m_slider(new EnergySlider(this, EnergySlider::Stops::Tiles)),
      m_help(secondLabel({}, this)),
      m_grown(pushButton(this, "grown", {}, {},
                         [this] { choosePhi(m_slider->scale().stops().at(calmerStop()).phi, -1); })) {
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
    new CalmFollower(
        m_motion, this, [this] { showGrowth(); }, &m_motion, &ShapeMotion::frameChanged);
    connect(&m_document, &Document::projectChanged, this, &MaterialPanel::showProject);
    showProject();
    showGrowth();
}

void MaterialPanel::setBesideBrush(bool beside) {
    m_besideBrush = beside;
    showGrowth();
}

void MaterialPanel::showProject() {
    setEnabled(!m_document.isEmpty());
    if (m_document.isEmpty()) return;
    const double phi = settingOf(*m_document.project(), "material.phi");
    m_slider->setDimension(m_document.dimension());
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
    const FramePtr& frame = m_motion.frame();
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
    changeSetting(m_document, "material.phi", phi, gesture);
}

}  // namespace wend
