#include "app/panels/balance_panel.h"

#include "app/document/options.h"
#include "app/panels/number_box.h"
#include "app/panels/panel_parts.h"
#include "app/panels/whole_material.h"

namespace wend {

QString BalancePanel::phiHelp(int dimension) {
    return dimension == 3
               ? tr("What is kept as a number, φ, as it stands in the project file: 0.002 keeps volume, "
                    "0.464 "
                    "length, 1.571 is rigid, 2.498 keeps angles.")
               : tr("What is kept as a number, φ, as it stands in the project file: 0.002 keeps area, 0.464 "
                    "length, 1.571 is rigid, 2.678 keeps angles.");
}

BalancePanel::BalancePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_phi(new NumberBox(this)), m_smoothing(new NumberBox(this)) {
    makeControls();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 4, 16, 10);
    layout->setSpacing(8);
    layout->addLayout(panelRow(tr("Exact &balance"), m_phi, this));
    layout->addLayout(panelRow(tr("Smoothi&ng length"), m_smoothing, this));
    connect(m_phi, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { changeWholePhi(m_session.document(), value, -1); });
    connect(m_smoothing, &QDoubleSpinBox::valueChanged, this, &BalancePanel::chooseSmoothing);
    connect(&m_session.document(), &Document::projectChanged, this, &BalancePanel::showProject);
    showProject();
}

void BalancePanel::makeControls() {
    m_phi->setRange(0.001, phi::conformal(2));
    m_phi->setDecimals(3);
    m_phi->setSingleStep(0.05);
    m_phi->setSuffix(tr(" rad"));
    m_phi->setFixedWidth(116);
    describe(m_phi, tr("Exact balance"), phiHelp(2));
    m_smoothing->setRange(0, option("material.smoothing.length").range.max);
    m_smoothing->setDecimals(4);
    m_smoothing->setSingleStep(0.005);
    m_smoothing->setFixedWidth(116);
    m_smoothing->setSpecialValueText(tr("none"));
    describe(m_smoothing, tr("Smoothing length"),
             tr("How far a pin's pull is spread, as a part of the shape's size. Small: close to the pin, "
                "sharp. Large: soft and wide."));
}

void BalancePanel::showProject() {
    setEnabled(!m_session.document().isEmpty());
    if (m_session.document().isEmpty()) return;
    const Project& project = *m_session.document().project();
    const Smoothing smoothing =
        std::visit([](const auto& design) { return design.material.smoothing; }, project.design);
    const QSignalBlocker a(m_phi), b(m_smoothing);
    m_phi->setMaximum(phi::conformal(project.dimension()));
    describe(m_phi, tr("Exact balance"), phiHelp(project.dimension()));
    m_phi->setValue(wholePhi(project));
    m_smoothing->setValue(smoothing.kind == SmoothingKind::None ? 0 : smoothing.length);
    const bool paper = smoothing.kind == SmoothingKind::Paper;
    m_smoothing->setEnabled(!paper);
    if (paper)
        m_smoothing->setToolTip(tr("This project smooths as in the paper, with λ; its file says how much."));
}

void BalancePanel::chooseSmoothing(double length) {
    Document& document = m_session.document();
    if (document.isEmpty()) return;
    Project next = *document.project();
    Smoothing& smoothing =
        std::visit([](auto& design) -> Smoothing& { return design.material.smoothing; }, next.design);
    smoothing.kind = length > 0 ? SmoothingKind::Invariant : SmoothingKind::None;
    if (length > 0) smoothing.length = length;
    document.change(tr("Change smoothing"), std::move(next), QStringLiteral("smoothing"));
}

}  // namespace wend
