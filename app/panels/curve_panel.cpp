#include "app/panels/curve_panel.h"

#include <QComboBox>
#include <QPushButton>
#include <algorithm>
#include <numbers>

#include "app/document/curve_edits.h"
#include "app/panels/exact_box.h"
#include "app/panels/panel_parts.h"
#include "app/session/curve_making.h"

namespace wend {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

CurvePanel::CurvePanel(ShapeSession& session, int dimension, bool titled, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_dimension(dimension),
      m_make(new QPushButton(tr("Edit path"), this)),
      m_curve(new QWidget(this)),
      m_frame(new QComboBox(this)),
      m_twist(new ExactBox(this)),
      m_scale(new ExactBox(this)) {
    makeControls();
    arrange(titled);
    connect(m_make, &QPushButton::clicked, this, [this] { makeCurve(m_session); });
    connect(m_frame, &QComboBox::activated, this, &CurvePanel::change);
    for (ExactBox* box : {m_twist, m_scale})
        connect(box, &QDoubleSpinBox::valueChanged, this, &CurvePanel::change);
    connect(&m_session, &ShapeSession::pinsChanged, this, &CurvePanel::showCurve);
    connect(&m_session, &ShapeSession::frameChanged, this, &CurvePanel::showCurve);
    showCurve();
}

void CurvePanel::makeControls() {
    m_make->setToolTip(tr("Turns the way that was drawn into a Bézier curve with points to drag."));
    m_make->setStatusTip(m_make->toolTip());
    m_frame->addItems({tr("no"), tr("as it bends (Frenet)"), tr("yes")});
    m_frame->setFixedWidth(116);
    describe(m_frame, tr("Rotate with path"), tr("Whether what is held turns along the curve, and how."));
    m_twist->setRange(-3600, 3600);
    m_twist->setDecimals(1);
    m_twist->setSingleStep(15);
    m_twist->setSuffix(QStringLiteral(" °"));
    m_twist->setFixedWidth(116);
    describe(m_twist, tr("Twist"),
             tr("How far it turns around the curve's direction, over the whole curve."));
    m_scale->setRange(0.05, 20);
    m_scale->setDecimals(3);
    m_scale->setSingleStep(0.05);
    m_scale->setPrefix(QStringLiteral("×"));
    m_scale->setFixedWidth(116);
    describe(m_scale, tr("Scale"), tr("How large it has become at the end of the curve."));
}

void CurvePanel::arrange(bool titled) {
    auto* layout = new QVBoxLayout(this);
    titled ? layout->setContentsMargins(16, 14, 16, 14) : layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    if (titled) layout->addWidget(panelTitle(tr("Path"), this));
    layout->addWidget(m_make);
    layout->addWidget(m_curve);
    auto* curve = new QVBoxLayout(m_curve);
    curve->setContentsMargins(0, 0, 0, 0);
    curve->setSpacing(10);
    curve->addLayout(panelRow(tr("Rot&ate with path"), m_frame, m_curve));
    if (m_dimension == 3)
        curve->addLayout(panelRow(tr("T&wist"), m_twist, m_curve));
    else
        m_twist->hide();
    curve->addLayout(panelRow(tr("S&cale"), m_scale, m_curve));
}

/// True if the handle has more than a point: only then something can be seen to rotate or grow.
bool CurvePanel::holdsPart() const {
    const auto many = [this](const auto& views) {
        return std::any_of(views.begin(), views.end(), [this](const auto& view) {
            return view.handle == single() && view.points.size() > 1;
        });
    };
    return many(m_session.pins<2>(true)) || many(m_session.pins<3>(true)) || many(m_session.ghosts<2>()) ||
           many(m_session.ghosts<3>());
}

/// What is switched off says why first.
void CurvePanel::allowTurning(bool allow) {
    const QString why = m_dimension == 2 ? tr("A point cannot rotate or grow – Alt-drag the pin to widen it.")
                                         : tr("A point cannot rotate or grow: hold more vertices.");
    for (QWidget* control :
         {static_cast<QWidget*>(m_frame), static_cast<QWidget*>(m_twist), static_cast<QWidget*>(m_scale)}) {
        control->setEnabled(allow);
        control->setToolTip(allow ? control->statusTip() : why + '\n' + control->statusTip());
    }
}

int CurvePanel::single() const {
    return m_session.document().dimension() == m_dimension ? m_session.singleHandle() : -1;
}

void CurvePanel::change() {
    if (single() >= 0) m_dimension == 2 ? changeOf<2>() : changeOf<3>();
}

template <int Dim>
void CurvePanel::changeOf() {
    Project next = *m_session.document().project();
    CurveMotion<Dim>* curve = lastCurve<Dim>(next, single());
    if (!curve) return;
    // What was not touched keeps its bits.
    const double twist = m_twist->exact();
    if (Dim == 3 && twist != curve->twist * kDegrees) curve->twist = twist / kDegrees;
    curve->scale = m_scale->exact();
    curve->frame = static_cast<FrameKind>(m_frame->currentIndex());
    if (curve->twist != 0 && curve->frame == FrameKind::None) curve->frame = FrameKind::Minimal;
    m_session.document().change(tr("Change curve"), std::move(next),
                                QStringLiteral("curve %1").arg(single()));
}

void CurvePanel::showCurve() {
    if (single() < 0)
        hide();
    else
        m_dimension == 2 ? show<2>() : show<3>();
}

template <int Dim>
void CurvePanel::show() {
    const CurveMotion<Dim>* curve = lastCurve<Dim>(*m_session.document().project(), single());
    const bool canMake = !curve && canMakeCurve(m_session);
    setVisible(curve || canMake);
    m_curve->setVisible(curve);
    m_make->setVisible(canMake);
    if (!curve) return;
    allowTurning(holdsPart());
    m_frame->setCurrentIndex(static_cast<int>(curve->frame));
    m_twist->put(curve->twist * kDegrees);
    m_scale->put(curve->scale);
}

}  // namespace wend
