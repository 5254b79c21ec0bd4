#include "app/panels/region_panel.h"

#include <QCheckBox>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/region_numbers.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "app/session/calm_follower.h"
#include "app/session/pins/pin_shapes.h"

namespace wend {

RegionPanel::RegionPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_numbers(new RegionNumbers(RegionNumbers::Radius::Elsewhere, this)),
      m_radius(new ExactBox(this)),
      m_holdsAngle(new QCheckBox(tr("Holds its a&ngle"), this)),
      m_count(secondLabel({}, this)) {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Region"), this));
    layout->addWidget(m_numbers);
    m_radius->setObjectName(QStringLiteral("circleRadius"));
    m_radius->setRange(0, 1e9);
    describe(
        m_radius, tr("Radius"),
        tr("How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a ball. "
           "In the shape's own units, for a picture its pixels. Dragging the pin with Ctrl and Shift does "
           "the same."));
    layout->addWidget(m_radiusRow = panelRowIn(tr("Ra&dius"), m_radius, this));
    m_holdsAngle->setObjectName(QStringLiteral("holdsAngle"));
    describe(m_holdsAngle, withoutKey(m_holdsAngle->text()),
             tr("The pin keeps the angle that the picture has there now, as a small circle; without it, the "
                "picture turns freely around the pin."));
    layout->addWidget(m_holdsAngle);
    layout->addWidget(m_count);
    m_count->setObjectName(QStringLiteral("regionCount"));
    connect(m_numbers, &RegionNumbers::changed, this, &RegionPanel::apply);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &RegionPanel::applyRadius);
    connect(m_holdsAngle, &QCheckBox::clicked, this, [this](bool holds) {
        if (m_session.selection().single() >= 0)
            setHoldsAngle(m_session, m_session.selection().single(), holds);
        showHandle();
    });
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

/// Applies the region. Consecutive numbers merge into one undo step. A region without vertices is rejected.
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
