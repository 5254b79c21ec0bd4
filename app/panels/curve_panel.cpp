#include "app/panels/curve_panel.h"

#include <QComboBox>
#include <QPushButton>
#include <algorithm>

#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/exact_box.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/edits/timing_edits.h"
#include "app/session/calm_follower.h"
#include "app/session/pins/curve_making.h"

namespace wend {

CurvePanel::CurvePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_make(new QPushButton(tr("Edit path"), this)),
      m_curve(new QWidget(this)),
      m_ease(new QComboBox(this)),
      m_frame(new QComboBox(this)),
      m_twist(new ExactBox(this)),
      m_scale(new ExactBox(this)) {
    makeControls();
    arrange();
    m_make->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    connect(m_make, &QPushButton::clicked, this, [this] {
        const bool byKey = m_make->hasFocus();
        makeCurve(m_session);
        if (byKey) m_ease->setFocus();
    });
    connect(m_frame, &QComboBox::activated, this, &CurvePanel::change);
    connect(m_ease, &QComboBox::activated, this, &CurvePanel::changeEase);
    connect(&m_session.playback(), &Playback::timeChanged, this, &CurvePanel::showCurve);
    for (ExactBox* box : {m_twist, m_scale})
        connect(box, &QDoubleSpinBox::valueChanged, this, &CurvePanel::change);
    new CalmFollower(m_session, CalmFollower::Of::Both, this, [this] { showCurve(); });
    showCurve();
}

void CurvePanel::makeControls() {
    m_make->setToolTip(tr("Turns the drawn path into a Bézier curve with points to drag."));
    m_make->setStatusTip(m_make->toolTip());
    for (const Ease ease : kEases) m_ease->addItem(withoutKey(easeName(ease)));
    m_ease->setObjectName(QStringLiteral("ease"));
    fitToEntries(m_ease);
    describe(m_ease, tr("Easing"), tr("How the motion at the shown time starts and ends."));
    m_frame->addItems({tr("no"), tr("as it bends (Frenet)"), tr("yes")});
    m_frame->setObjectName(QStringLiteral("curveFrame"));
    fitToEntries(m_frame);
    describe(m_frame, tr("Rotate with path"), tr("Whether what is held turns along the curve, and how."));
    m_twist->setRange(-3600, 3600);
    m_twist->setDecimals(1);
    m_twist->setSingleStep(15);
    m_twist->setSuffix(QStringLiteral(" °"));
    describe(m_twist, tr("Twist"),
             tr("How far it turns around the curve's direction, over the whole curve."));
    m_scale->setRange(0.05, 20);
    m_scale->setDecimals(3);
    m_scale->setSingleStep(0.05);
    m_scale->setPrefix(QStringLiteral("×"));
    describe(m_scale, tr("Scale"), tr("How large it has become at the end of the curve."));
}

void CurvePanel::arrange() {
    auto* layout = bareColumn(this, 10);
    layout->addWidget(panelRowIn(tr("Easing"), m_ease, this));
    layout->addWidget(m_make);
    layout->addWidget(m_curve);
    auto* curve = bareColumn(m_curve, 10);
    curve->addLayout(panelRow(tr("Rot&ate with path"), m_frame, m_curve));
    curve->addWidget(m_twistRow = panelRowIn(tr("T&wist"), m_twist, m_curve));
    curve->addLayout(panelRow(tr("S&cale"), m_scale, m_curve));
}

/// Returns whether the handle is more than a point, so that a rotation or scaling is visible.
bool CurvePanel::holdsPart() const {
    const auto many = [this](const auto& views) {
        return std::any_of(views.begin(), views.end(), [this](const auto& view) {
            return view.handle == single() && view.points.size() > 1;
        });
    };
    return many(m_session.pins(true)) || many(m_session.ghosts());
}

/// A disabled field explains why, first in its tooltip.
void CurvePanel::allowTurning(bool allow) {
    const QString why = dimension() == 2
                            ? tr("A point cannot rotate or grow – drag its ring, or give it a radius.")
                            : tr("A point cannot rotate or grow: hold more vertices.");
    for (QWidget* control :
         {static_cast<QWidget*>(m_frame), static_cast<QWidget*>(m_twist), static_cast<QWidget*>(m_scale)})
        wend::allow(control, allow, why);
}

/// The last one that has begun, or the first.
int CurvePanel::shownMotion() const {
    const auto& motions = m_session.document().design().handles[single()].motions;
    int shown = motions.empty() ? -1 : 0;
    for (int i = 0; i < static_cast<int>(motions.size()); ++i)
        if (motions[i].start < m_session.playback().time()) shown = i;
    return shown;
}

void CurvePanel::changeEase() {
    if (single() < 0 || !m_session.mayChange(single())) return showCurve();
    const int motion = shownMotion();
    m_session.document().changeDesign(
        tr("Change easing"), withMotionEase(m_session.document().design(), {{single(), motion}},
                                            kEases.at(static_cast<std::size_t>(m_ease->currentIndex()))));
}

void CurvePanel::change() {
    if (single() < 0) return;
    Design next = m_session.document().design();
    CurveMotion<3>* curve = lastCurve(next, single());
    if (!curve) return;
    // Unchanged fields keep their exact value.
    const double twist = m_twist->exact();
    if (dimension() == 3 && twist != curve->twist * kDegrees) curve->twist = twist / kDegrees;
    curve->scale = m_scale->exact();
    curve->frame = static_cast<FrameKind>(m_frame->currentIndex());
    if (curve->twist != 0 && curve->frame == FrameKind::None) curve->frame = FrameKind::Minimal;
    m_session.document().changeDesign(tr("Change curve"), std::move(next),
                                      QStringLiteral("curve %1").arg(single()));
}

void CurvePanel::showCurve() {
    if (single() < 0) return hide();
    const CurveMotion<3>* curve = lastCurve(m_session.document().design(), single());
    const bool canMake = !curve && canMakeCurve(m_session);
    const int motion = shownMotion();
    setVisible(motion >= 0);
    if (motion >= 0) {
        const Ease ease = m_session.document().design().handles[single()].motions[motion].ease;
        m_ease->setCurrentIndex(static_cast<int>(std::ranges::find(kEases, ease) - kEases.begin()));
    }
    m_curve->setVisible(curve);
    m_make->setVisible(canMake);
    if (!curve) return;
    m_twistRow->setVisible(dimension() == 3);
    allowTurning(holdsPart());
    m_frame->setCurrentIndex(static_cast<int>(curve->frame));
    m_twist->put(curve->twist * kDegrees);
    m_scale->put(curve->scale);
}

}  // namespace wend
