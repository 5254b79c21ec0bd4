#include "app/panels/handle_panel.h"

#include <QComboBox>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <numbers>

#include "app/document/handle_edits.h"
#include "app/panels/curve_panel.h"
#include "app/panels/number_box.h"
#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

HandlePanel::HandlePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_none(secondLabel(tr("Select a pin to see its numbers."), this)),
      m_body(new QWidget(this)),
      m_name(new QLineEdit(this)),
      m_place(secondLabel({}, this)),
      m_kind(new QComboBox(this)),
      m_axis(new QComboBox(this)),
      m_apply(new QPushButton(tr("Apply"), this)),
      m_curve(new CurvePanel(session, 3, false, this)) {
    makeControls();
    arrange();
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (single() < 0 || m_name->text().isEmpty()) return;
        const std::string name = m_name->text().toStdString();
        const Document& document = m_session.document();
        if (document.design<3>().handles[single()].name == name) return;
        m_session.document().change(tr("Rename"), withHandleName(*document.project(), single(), name));
    });
    connect(m_kind, &QComboBox::currentIndexChanged, this, &HandlePanel::showStep);
    connect(m_apply, &QPushButton::clicked, this, &HandlePanel::apply);
    connect(&m_session, &ShapeSession::pinsChanged, this, &HandlePanel::showHandle);
    connect(&m_session, &ShapeSession::frameChanged, this, &HandlePanel::showHandle);
    showStep();
    showHandle();
}

void HandlePanel::makeControls() {
    describe(m_name, tr("Name"), tr("What the handle is called in the project and in messages."));
    m_kind->addItems({tr("Move by"), tr("Rotate by"), tr("Scale by")});
    describe(m_kind, tr("Exact step"), tr("Moves, turns or scales what is selected by exact numbers."));
    for (QDoubleSpinBox*& box : m_numbers) {
        box = new NumberBox(this);
        box->setRange(-1e9, 1e9);
        box->setDecimals(3);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(56);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        describe(box, tr("Amount"), tr("How far along x, y and z; an angle; or a factor."));
    }
    m_axis->addItems({tr("around X"), tr("around Y"), tr("around Z")});
    m_axis->setCurrentIndex(2);
    describe(m_axis, tr("Axis"), tr("The axis of the turn, through the middle of what is selected."));
    m_apply->setToolTip(tr("Does this step; it becomes part of the motion."));
    m_apply->setStatusTip(m_apply->toolTip());
}

void HandlePanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Pin"), this));
    layout->addWidget(m_none);
    layout->addWidget(m_body);
    auto* body = new QVBoxLayout(m_body);
    body->setContentsMargins(0, 0, 0, 0);
    body->setSpacing(10);
    body->addWidget(m_name);
    body->addWidget(m_place);
    auto* first = new QHBoxLayout;
    first->addWidget(m_kind);
    first->addWidget(m_axis);
    first->addStretch(1);
    first->addWidget(m_apply);
    body->addLayout(first);
    auto* second = new QHBoxLayout;
    for (QDoubleSpinBox* box : m_numbers) second->addWidget(box);
    body->addLayout(second);
    body->addWidget(m_curve);
}

int HandlePanel::single() const {
    return m_session.document().dimension() == 3 ? m_session.singleHandle() : -1;
}

Vec<3> HandlePanel::middle() const {
    std::vector<Vec<3>> centres;
    for (const auto& pin : m_session.pins<3>(true))
        if (m_session.selection().contains(pin.handle)) centres.push_back(pin.centre);
    return centres.empty() ? Vec<3>(Vec<3>::Zero()) : meanOf<3>(centres);
}

void HandlePanel::showStep() {
    const int kind = m_kind->currentIndex();
    m_axis->setVisible(kind == 1);
    for (int k = 1; k < 3; ++k) m_numbers[k]->setVisible(kind == 0);
    m_numbers[0]->setSuffix(kind == 1 ? QStringLiteral(" °") : QString());
    m_numbers[0]->setPrefix(kind == 2 ? QStringLiteral("×") : QString());
    m_numbers[0]->setRange(kind == 2 ? 0.01 : -1e9, 1e9);
    m_numbers[0]->setValue(kind == 2 ? 1 : 0);
}

void HandlePanel::apply() {
    for (QDoubleSpinBox* box : m_numbers) box->interpretText();
    const int kind = m_kind->currentIndex();
    Grip grip;
    grip.kind = static_cast<Grip::Kind>(kind);
    grip.centre = middle();
    grip.axis = Vec<3>::Unit(m_axis->currentIndex());
    Amount amount(m_numbers[0]->value(), m_numbers[1]->value(), m_numbers[2]->value());
    if (kind == 1) amount = {amount[0] / kDegrees, 0, 0};
    if (kind == 2) amount = {amount[0] - 1, 0, 0};
    m_session.moveSelected<3>(grip, amount);
}

void HandlePanel::showHandle() {
    const bool any = m_session.document().dimension() == 3 && !m_session.selection().isEmpty();
    m_none->setVisible(m_session.selection().isEmpty());
    m_body->setVisible(any);
    if (!any) return;
    const int handle = single();
    const auto& handles = m_session.document().design<3>().handles;
    m_name->setEnabled(handle >= 0);
    if (!m_name->hasFocus())
        m_name->setText(
            handle >= 0 ? QString::fromStdString(handles[handle].name)
                        : tr("%n pins", nullptr, static_cast<int>(m_session.selection().handles().size())));
    const double minimum = 1e-9 * (m_session.frame() ? m_session.frame()->diagonal : 1);
    const Vec<3> at = (middle().array().abs() < minimum).select(0, middle());
    const QLocale locale;
    m_place->setText(tr("at %1, %2, %3")
                         .arg(locale.toString(at.x(), 'g', 5), locale.toString(at.y(), 'g', 5),
                              locale.toString(at.z(), 'g', 5)));
}

}  // namespace wend
