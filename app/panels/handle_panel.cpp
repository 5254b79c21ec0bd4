#include "app/panels/handle_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/panels/fields/region_numbers.h"
#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/timing_edits.h"
#include "app/session/calm_follower.h"
#include "app/session/pins/pin_shapes.h"
#include "app/style/theme.h"

namespace wend {

CurvePanel::CurvePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_curve(new QWidget(this)) {
    makeControls();
    arrange();
    connect(&m_session.playback(), &Playback::timeChanged, this, &CurvePanel::showCurve);
    new CalmFollower(
        m_session.motion(), this, [this] { showCurve(); }, &m_session.gestures(), &ShapeGesture::pinsChanged,
        &m_session.motion(), &ShapeMotion::frameChanged);
    showCurve();
}

void CurvePanel::makeControls() {
    m_make = new QPushButton(tr("Edit path"), this);
    m_make->setToolTip(tr("Turns the drawn path into a Bézier curve with points to drag."));
    m_make->setStatusTip(m_make->toolTip());
    m_make->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    connect(m_make, &QPushButton::clicked, this, [this] {
        const bool byKey = m_make->hasFocus();
        makeCurve(m_session);
        if (byKey) m_ease->setFocus();
    });
    QStringList eases;
    for (const Ease ease : kEases) eases << withoutKey(easeName(ease));
    m_ease = choiceBox(this, "ease", tr("Easing"), tr("How the motion at the shown time starts and ends."),
                       eases, &CurvePanel::changeEase);
    m_frame = choiceBox(this, "curveFrame", tr("Rotate with path"),
                        tr("Whether what is held turns along the curve, and how."),
                        {tr("no"), tr("as it bends (Frenet)"), tr("yes")}, &CurvePanel::change);
    for (QComboBox* box : {m_ease, m_frame}) fitToEntries(box);
    m_twist = numberBox(this, "", tr("Twist"),
                        tr("How far it turns around the curve's direction, over the whole curve."),
                        {-3600, 3600, 1, 15, QStringLiteral(" °")}, &CurvePanel::change);
    m_scale = numberBox(this, "", tr("Scale"), tr("How large it has become at the end of the curve."),
                        {0.05, 20, 3, 0.05}, &CurvePanel::change);
    m_scale->setPrefix(QStringLiteral("×"));
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
    return many(m_session.gestures().pins(true)) || many(m_session.gestures().ghosts());
}

/// Enables the fields for rotation and growth; a disabled one explains why in its tooltip.
void CurvePanel::allowTurning(bool allow) {
    const QString why = dimension() == 2
                            ? tr("A point cannot rotate or grow – drag its ring, or give it a radius.")
                            : tr("A point cannot rotate or grow: hold more vertices.");
    for (QWidget* control :
         {static_cast<QWidget*>(m_frame), static_cast<QWidget*>(m_twist), static_cast<QWidget*>(m_scale)})
        wend::allow(control, allow, why);
}

/// Returns the last motion that has begun, or the first; −1 if there is none.
int CurvePanel::shownMotion() const {
    const auto& motions = m_session.document().design().handles[single()].motions;
    int shown = motions.empty() ? -1 : 0;
    for (int i = 0; i < static_cast<int>(motions.size()); ++i)
        if (motions[i].start < m_session.playback().time()) shown = i;
    return shown;
}

void CurvePanel::changeEase() {
    if (single() < 0 || !m_session.gestures().mayChange(single())) return showCurve();
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

HandlePanel::HandlePanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_none(secondLabel(tr("Select a pin to see its numbers."), this)),
      m_body(new QWidget(this)),
      m_place(secondLabel({}, this)),
      m_kind(new QComboBox(this)),
      m_axis(new QComboBox(this)),
      m_apply(buttonFor<QToolButton>(this, "applyStep", {},
                                     tr("Applies this step; it becomes part of the motion."),
                                     &HandlePanel::apply, tr("Apply"))) {
    makeControls();
    arrange();
    connect(m_kind, &QComboBox::currentIndexChanged, this, &HandlePanel::showStep);
    new CalmFollower(
        m_session.motion(), this, [this] { showHandle(); }, &m_session.gestures(), &ShapeGesture::pinsChanged,
        &m_session.motion(), &ShapeMotion::frameChanged);
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
    for (const PinView& pin : m_session.gestures().pins(true))
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

/// Gives distances decimals that depend on the size of a solid; pixels, angles and factors have three.
void HandlePanel::showDigits() {
    const FramePtr& frame = m_session.motion().frame();
    const bool isDistance = m_kind->currentIndex() == 0 && isSolid() && frame;
    for (ExactBox* box : m_numbers) box->showDigits(isDistance ? std::max(3, digitsFor(frame->diagonal)) : 3);
}

void HandlePanel::showStep() {
    const int kind = m_kind->currentIndex();
    placeNumbers();
    showDigits();
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
    if (isSolid()) grip.axis = Vec3::Unit(m_axis->currentIndex());
    Amount amount(m_numbers[0]->value(), m_numbers[1]->value(), m_numbers[2]->value());
    if (kind == 1) amount = {amount[0] / kDegrees, 0, 0};
    if (kind == 2) amount = {amount[0] - 1, 0, 0};
    m_session.gestures().moveAtOnce(grip, amount);
}

void HandlePanel::showHandle() {
    const bool any = !m_session.selection().isEmpty();
    m_none->setVisible(!any);
    m_body->setVisible(any);
    m_place->setVisible(any);
    placeNumbers();
    showDigits();
    if (!any) return;
    const double size = m_session.motion().frame() ? m_session.motion().frame()->diagonal : 1;
    const double unit = std::pow(10, std::floor(std::log10(size > 0 ? size : 1)) - 5);
    const auto centre = middle();
    const QString none = tr("does not hold now");
    allow(m_apply, centre.has_value(), none);
    if (!centre) return m_place->setText(none);
    const Vec3 at = ((*centre / unit).array().round() * unit + 0.0).matrix();  // and no −0
    const QLocale locale;
    const auto number = [&locale](double value) { return locale.toString(value, 'g', 5); };
    m_place->setText(isSolid() ? tr("at %1, %2, %3").arg(number(at.x()), number(at.y()), number(at.z()))
                               : tr("at %1, %2").arg(number(at.x()), number(at.y())));
}

RegionPanel::RegionPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_numbers(new RegionNumbers(RegionNumbers::Radius::Elsewhere, this)),
      m_radius(numberBox(
          this, "circleRadius", tr("Radius"),
          tr("How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a "
             "ball. In the shape's own units, for a picture its pixels. Dragging the pin with Ctrl and "
             "Shift does the same."),
          {0, 1e9}, &RegionPanel::applyRadius)),
      m_holdsAngle(buttonFor<QCheckBox>(
          this, "holdsAngle", tr("Holds its a&ngle"),
          tr("The pin keeps the angle that the picture has there now, as a small circle; without it, the "
             "picture turns freely around the pin."),
          [this](bool holds) {
              if (m_session.selection().single() >= 0)
                  setHoldsAngle(m_session, m_session.selection().single(), holds);
              showHandle();
          })),
      m_count(secondLabel({}, this)) {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Region"), this));
    layout->addWidget(m_numbers);
    layout->addWidget(m_radiusRow = panelRowIn(tr("Ra&dius"), m_radius, this));
    layout->addWidget(m_holdsAngle);
    layout->addWidget(m_count);
    m_count->setObjectName(QStringLiteral("regionCount"));
    connect(m_numbers, &RegionNumbers::changed, this, &RegionPanel::apply);
    new CalmFollower(
        m_session.motion(), this, [this] { showHandle(); }, &m_session.gestures(),
        &ShapeGesture::pinsChanged);
    connect(&m_session.motion(), &ShapeMotion::frameChanged, this, &RegionPanel::takeFrame);
    showHandle();
}

std::optional<Region<3>> RegionPanel::region() const {
    const int handle = m_session.selection().single();
    if (handle < 0) return {};
    const auto* own = std::get_if<Region<3>>(&m_session.document().design().handles[handle].at);
    return own ? std::optional(*own) : std::nullopt;
}

/// Returns the radius of a disc or a ball; 0 for a point.
std::optional<double> RegionPanel::radius() const {
    const auto now = region();
    const auto* ball = now ? std::get_if<Ball<3>>(&*now) : nullptr;
    if (ball) return ball->radius;
    return holdsPoint(m_session, m_session.selection().single()) ? std::optional(0.0) : std::nullopt;
}

/// Applies the region; changes in a row merge into one undo step. A region without vertices is rejected.
void RegionPanel::apply(const Region<3>& next) {
    const FramePtr frame = m_session.motion().frame();
    const auto now = region();
    if (!now || !frame || next == *now) return;
    if (frame->verticesInside(next).empty()) {
        m_count->setText(tr("There is no vertex in this region: nothing was changed."));
        return;
    }
    const int handle = m_session.selection().handles().front();
    m_session.document().changeDesign(tr("Change region"),
                                      withHandlePlace(m_session.document().design(), handle, next),
                                      QStringLiteral("handle region %1").arg(handle));
}

/// Emits a notice and rejects a radius that is too small to contain a vertex.
void RegionPanel::applyRadius() {
    const int handle = m_session.selection().single();
    if (radius() &&
        !widenPin(m_session, handle, m_radius->exact(), QStringLiteral("handle region %1").arg(handle)))
        showHandle();
}

/// Updates after a change of the shape; poses change nothing here.
void RegionPanel::takeFrame() {
    const FramePtr& frame = m_session.motion().frame();
    if (!frame || frame->shape != m_mesh || isHidden()) showHandle();
}

void RegionPanel::showHandle() {
    const FramePtr& frame = m_session.motion().frame();
    m_mesh = frame ? frame->shape : nullptr;
    const auto now = region();
    const bool hasNumbers = isSolid() && now && RegionNumbers::canShow(*now);
    const auto wide = radius();
    setVisible(frame && (hasNumbers || wide));
    m_numbers->setVisible(hasNumbers);
    m_radiusRow->setVisible(wide.has_value());
    m_count->setVisible(!holdsPoint(m_session, m_session.selection().single()));
    m_holdsAngle->setVisible(!isSolid() && wide);
    m_holdsAngle->setChecked(wide && *wide > 0);
    if (!frame) return;
    if (hasNumbers) m_numbers->showRegion(*now, frame->diagonal);
    if (wide) showRadius(*wide, frame->diagonal);
    if (now && (hasNumbers || !isSolid()))
        m_count->setText(tr("Vertices: %n", nullptr, static_cast<int>(frame->verticesInside(*now).size())));
}

/// Shows the radius with decimals that depend on the size of the shape; whole pixels in a picture.
void RegionPanel::showRadius(double radius, double diagonal) {
    m_radius->showDigits(isSolid() ? digitsFor(diagonal) : 2);
    m_radius->put(radius);
}

}  // namespace wend
