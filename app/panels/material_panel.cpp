#include "app/panels/material_panel.h"

#include <QPushButton>

#include "app/document/options.h"
#include "app/panels/number_box.h"
#include "app/panels/panel_parts.h"
#include "app/session/settle_step.h"

namespace wend {

namespace {

double phiOf(const Project& project) {
    return std::visit([](const auto& design) { return design.material.phi; }, project.design);
}

}  // namespace

QString MaterialPanel::phiHelp(int dimension) {
    return dimension == 3 ? tr("The same choice as a number, as it stands in the project file: 0.002 keeps "
                               "volume, 0.464 length, 1.571 is rigid, 2.498 keeps angles.")
                          : tr("The same choice as a number, as it stands in the project file: 0.002 keeps "
                               "area, 0.464 length, 1.571 is rigid, 2.678 keeps angles.");
}

MaterialPanel::MaterialPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_slider(new EnergySlider(this)),
      m_help(secondLabel({}, this)),
      m_phi(new NumberBox(this)),
      m_smoothing(new NumberBox(this)),
      m_memory(new MemorySlider(this)),
      m_settle(new QPushButton(tr("Settle"), this)) {
    makeControls();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Keep"), this));
    layout->addWidget(m_slider);
    layout->addWidget(m_help);
    layout->addLayout(panelRow(tr("Energ&y φ"), m_phi, this));
    layout->addLayout(panelRow(tr("Smoothi&ng"), m_smoothing, this));
    layout->addSpacing(6);
    layout->addWidget(panelTitle(tr("Remembers its shape"), this));
    layout->addWidget(m_memory);
    layout->addWidget(m_settle);
    connect(m_settle, &QPushButton::clicked, this, [this] { settleAtEnd(m_session); });
    connect(m_memory, &MemorySlider::memoryChosen, this, &MaterialPanel::chooseMemory);
    connect(m_slider, &EnergySlider::phiChosen, this, &MaterialPanel::choosePhi);
    connect(m_phi, &QDoubleSpinBox::valueChanged, this, [this](double value) { choosePhi(value, -1); });
    connect(m_smoothing, &QDoubleSpinBox::valueChanged, this, &MaterialPanel::chooseSmoothing);
    connect(&m_session.document(), &Document::projectChanged, this, &MaterialPanel::showProject);
    showProject();
}

void MaterialPanel::makeControls() {
    m_phi->setRange(0.001, phi::conformal(2));
    m_phi->setDecimals(3);
    m_phi->setSingleStep(0.05);
    m_phi->setSuffix(tr(" rad"));
    m_phi->setFixedWidth(116);
    describe(m_phi, tr("Energy φ"), phiHelp(2));
    m_smoothing->setRange(0, option("material.smoothing.length").range.max);
    m_smoothing->setDecimals(4);
    m_smoothing->setSingleStep(0.005);
    m_smoothing->setFixedWidth(116);
    m_smoothing->setSpecialValueText(tr("none"));
    describe(m_smoothing, tr("Smoothing length"),
             tr("How far a pin's pull is spread, as a part of the shape's size. Small: close to the pin, "
                "sharp. Large: soft and "
                "wide."));
    m_settle->setObjectName(QStringLiteral("settle"));
    describe(
        m_settle, tr("Settle"),
        tr("Let the shape relax with the pins where they are, until it is as near to its rest as it can be. "
           "This takes a moment at the end of the motion."));
    m_help->setMinimumHeight(3 * m_help->fontMetrics().lineSpacing());
    m_help->setAlignment(Qt::AlignTop);
}

void MaterialPanel::showProject() {
    setEnabled(!m_session.document().isEmpty());
    if (m_session.document().isEmpty()) return;
    const Project& project = *m_session.document().project();
    const double phi = phiOf(project);
    const Smoothing smoothing =
        std::visit([](const auto& design) { return design.material.smoothing; }, project.design);
    const QSignalBlocker a(m_phi), b(m_smoothing);
    m_phi->setMaximum(phi::conformal(project.dimension()));
    describe(m_phi, tr("Energy φ"), phiHelp(project.dimension()));
    m_slider->setDimension(project.dimension());
    m_slider->setPhi(phi);
    m_phi->setValue(phi);
    m_smoothing->setValue(smoothing.kind == SmoothingKind::None ? 0 : smoothing.length);
    m_settle->setEnabled(canSettle(m_session.document()));
    m_memory->setMemory(
        std::visit([](const auto& design) { return design.material.memory; }, project.design));
    const bool paper = smoothing.kind == SmoothingKind::Paper;
    m_smoothing->setEnabled(!paper);
    if (paper)
        m_smoothing->setToolTip(tr("This project smooths as in the paper, with λ; its file says how much."));
    const EnergyScale& scale = m_slider->scale();
    const int stop = scale.stopAt(phi);
    const int below = static_cast<int>(scale.positionOf(phi));
    m_help->setText(
        stop >= 0 ? scale.stops()[stop].shortHelp
                  : tr("Between %1 and %2.").arg(scale.stops()[below].name, scale.stops()[below + 1].name));
}

void MaterialPanel::choosePhi(double phi, int gesture) {
    Document& document = m_session.document();
    if (document.isEmpty() || phi == phiOf(*document.project())) return;
    Project next = *document.project();
    const double limit = phi::conformal(next.dimension());
    std::visit([&](auto& design) { design.material.phi = std::min(phi, limit); }, next.design);
    document.change(tr("Change energy"), std::move(next), QStringLiteral("phi %1").arg(gesture));
}

void MaterialPanel::chooseSmoothing(double length) {
    Document& document = m_session.document();
    if (document.isEmpty()) return;
    Project next = *document.project();
    Smoothing& smoothing =
        std::visit([](auto& design) -> Smoothing& { return design.material.smoothing; }, next.design);
    smoothing.kind = length > 0 ? SmoothingKind::Invariant : SmoothingKind::None;
    if (length > 0) smoothing.length = length;
    document.change(tr("Change smoothing"), std::move(next), QStringLiteral("smoothing"));
}

void MaterialPanel::chooseMemory(double memory, int gesture) {
    Document& document = m_session.document();
    if (document.isEmpty()) return;
    Project next = *document.project();
    std::visit([&](auto& design) { design.material.memory = memory; }, next.design);
    document.change(tr("Change memory"), std::move(next), QStringLiteral("memory %1").arg(gesture));
}

}  // namespace wend
