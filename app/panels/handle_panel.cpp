#include "app/panels/handle_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <cmath>

#include "app/panels/curve_panel.h"
#include "app/panels/fields/exact_box.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/session/calm_follower.h"
#include "app/style/theme.h"

namespace wend {

HandlePanel::HandlePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_none(secondLabel(tr("Select a pin to see its numbers."), this)),
      m_body(new QWidget(this)),
      m_place(secondLabel({}, this)),
      m_kind(new QComboBox(this)),
      m_axis(new QComboBox(this)),
      m_apply(new QToolButton(this)) {
    makeControls();
    arrange();
    connect(m_kind, &QComboBox::currentIndexChanged, this, &HandlePanel::showStep);
    connect(m_apply, &QToolButton::clicked, this, &HandlePanel::apply);
    new CalmFollower(m_session, CalmFollower::Of::Both, this, [this] { showHandle(); });
    showStep();
    showHandle();
}

void HandlePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_apply->setIcon(wendIcon(QStringLiteral("apply"), palette()));
}

void HandlePanel::makeControls() {
    m_place->setObjectName(QStringLiteral("pinPlace"));
    m_place->setWordWrap(false);
    m_place->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_place->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long numbers widen no panel
    m_apply->setIcon(wendIcon(QStringLiteral("apply"), palette()));
    m_kind->addItems({tr("Move by"), tr("Rotate by"), tr("Scale by")});
    describe(m_kind, tr("Exact step"), tr("Moves, rotates or scales what is selected by exact numbers."));
    m_numbers =
        coordinateBoxes(1e9, 3, tr("Amount"), tr("How far along x, y and z; an angle; or a factor."), this);
    for (ExactBox* box : m_numbers) box->setMinimumWidth(42);
    m_axis->addItems({tr("around X"), tr("around Y"), tr("around Z")});
    m_axis->setCurrentIndex(2);
    describe(m_axis, tr("Axis"), tr("The axis of the rotation, through the middle of what is selected."));
    describe(m_apply, tr("Apply"), tr("Applies this step; it becomes part of the motion."));
    m_apply->setObjectName(QStringLiteral("applyStep"));
}

void HandlePanel::arrange() {
    auto* layout = sectionColumn(this);
    auto* title = sideBySide({panelTitle(tr("Pin"), this), m_place});
    title->setStretch(1, 1);
    layout->addLayout(title);
    layout->addWidget(m_none);
    layout->addWidget(m_body);
    auto* body = bareColumn(m_body, 10);
    m_step = new QHBoxLayout;
    m_step->setSpacing(4);
    m_step->addWidget(m_kind);
    m_step->addWidget(m_axis);
    m_step->addStretch();
    m_step->addWidget(m_apply);
    body->addLayout(m_step);
    m_space = new QHBoxLayout;
    body->addLayout(m_space);
    body->addWidget(new CurvePanel(m_session, this));
}

/// Returns the centre of the selected handles that act now; in the plane without z.
std::optional<Vec3> HandlePanel::middle() const {
    std::vector<Vec3> centres;
    for (const PinView& pin : m_session.pins(true))
        if (m_session.selection().contains(pin.handle)) centres.push_back(pin.centre);
    return centres.empty() ? std::nullopt : std::optional(meanOf(centres));
}

/// Places the numbers: in the plane beside the kind of step, in space in a row of their own.
void HandlePanel::placeNumbers() {
    const int kind = m_kind->currentIndex();
    m_axis->setVisible(kind == 1 && isSolid());
    m_numbers[1]->setVisible(kind == 0);
    m_numbers[2]->setVisible(kind == 0 && isSolid());
    QHBoxLayout* row = isSolid() ? m_space : m_step;
    if (row->indexOf(m_numbers[0]) >= 0) return;
    for (int k = 0; k < 3; ++k)
        isSolid() ? row->addWidget(m_numbers[k]) : row->insertWidget(1 + k, m_numbers[k], 1);
    setTabOrder(m_numbers[2], m_apply);
}

void HandlePanel::showStep() {
    const int kind = m_kind->currentIndex();
    placeNumbers();
    m_numbers[0]->setSuffix(kind == 1 ? QStringLiteral(" °") : QString());
    m_numbers[0]->setPrefix(kind == 2 ? QStringLiteral("×") : QString());
    m_numbers[0]->setRange(kind == 2 ? 0.01 : -1e9, 1e9);
    m_numbers[0]->setValue(kind == 2 ? 1 : 0);
}

void HandlePanel::apply() {
    for (ExactBox* box : m_numbers) box->interpretText();
    const auto centre = middle();
    if (!centre) return;
    const int kind = m_kind->currentIndex();
    Grip grip;
    grip.kind = static_cast<Grip::Kind>(kind);
    grip.centre = *centre;
    if (isSolid()) grip.axis = Vec<3>::Unit(m_axis->currentIndex());
    Amount amount(m_numbers[0]->value(), m_numbers[1]->value(), m_numbers[2]->value());
    if (kind == 1) amount = {amount[0] / kDegrees, 0, 0};
    if (kind == 2) amount = {amount[0] - 1, 0, 0};
    m_session.moveSelected(grip, amount);
}

void HandlePanel::showHandle() {
    const bool any = !m_session.selection().isEmpty();
    m_none->setVisible(!any);
    m_body->setVisible(any);
    m_place->setVisible(any);
    placeNumbers();
    if (!any) return;
    const double size = m_session.frame() ? m_session.frame()->diagonal : 1;
    const double unit = std::pow(10, std::floor(std::log10(size > 0 ? size : 1)) - 5);
    const auto centre = middle();
    const QString none = tr("does not hold now");
    allow(m_apply, centre.has_value(), none);
    if (!centre) return m_place->setText(none);
    const Vec<3> at = ((*centre / unit).array().round() * unit + 0.0).matrix();  // and no −0
    const QLocale locale;
    const auto number = [&locale](double value) { return locale.toString(value, 'g', 5); };
    m_place->setText(isSolid() ? tr("at %1, %2, %3").arg(number(at.x()), number(at.y()), number(at.z()))
                               : tr("at %1, %2").arg(number(at.x()), number(at.y())));
}

}  // namespace wend
