#include "app/tools/pin_tool.h"

#include <QApplication>
#include <algorithm>

#include "app/document/design.h"
#include "app/session/accent.h"
#include "app/session/mark_size.h"
#include "app/session/pin_shapes.h"
#include "app/tools/drag_label.h"
#include "app/tools/pin_picking.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

constexpr double kReach = 8;           // pixels of the screen
constexpr double kStrokeDetail = 0.5;  // pixels of the screen that a recorded path may deviate
constexpr double kTurnDetail = 0.005;  // radians, or of a factor, that a recorded turn may deviate
constexpr double kMinDetail = 0.2;     // but no less than this, in pixels of the picture

double distance(const QPointF& a, const QPointF& b) {
    return QLineF(a, b).length();
}

}  // namespace

PinTool::PinTool(ToolSurface& surface, bool adds)
    : m_surface(surface),
      m_curve(surface.session(), {[this](const Vec<2>& p) { return m_surface.toWidget(p); },
                                  [this](const Vec<2>&, const QPointF& from, const QPointF& to) -> Vec<2> {
                                      return m_surface.toShape(to) - m_surface.toShape(from);
                                  },
                                  [this] { m_surface.redraw(); }}),
      m_adds(adds) {}

void PinTool::setGrip(Grip::Kind kind) {
    m_grip = kind;
    surface().redraw();
}

/// The end of the curve lies under its pin, which comes first until that point is chosen.
int PinTool::curvePointAt(const QPointF& at) const {
    const int point = m_curve.pointAt(at);
    return point == m_curve.chosen() || pinAt(at) < 0 ? point : -1;
}

int PinTool::handleAt(const QPointF& widget) const {
    const int pin = pinAt(widget);
    return pin >= 0 ? pin : regionAt(widget);
}

int PinTool::pinAt(const QPointF& widget) const {
    PinPick pick;
    for (const PinView<2>& pin : session().pins()) {
        for (std::size_t i = 0; i < pin.points.size() && !pin.region; ++i)
            if (const double d = distance(surface().toWidget(pin.points[i]), widget); d <= marked(kReach))
                pick.offer(pin.handle, d, isCovered<2>(surface(), pin, i));
        const bool isArea = pin.region || pin.points.size() > 1;
        if (const double d = distance(surface().toWidget(pin.centre), widget); isArea && d <= marked(kReach))
            pick.offer(pin.handle, d, false);
    }
    return pick.handle() >= 0 ? pick.handle() : ghostUnder<2>(surface(), widget);
}

/// Of regions that lie over each other one that is seen there, of several the smallest.
int PinTool::regionAt(const QPointF& widget) const {
    const auto frame = session().frame<2>();
    if (!frame) return -1;
    const auto seen = surface().touch(widget);
    PinPick pick;
    for (const PinView<2>& view : session().pins()) {
        if (!view.region) continue;
        const Handle<2>& handle = session().document().design<2>().handles[view.handle];
        QPolygonF border;
        for (const Vec<2>& p : regionBorder(handle, view, *frame)) border << surface().toWidget(p);
        if (!border.containsPoint(widget, Qt::OddEvenFill)) continue;
        const QRectF box = border.boundingRect();
        const auto* region = std::get_if<Region<2>>(&handle.at);
        const bool covered =
            seen && region &&
            signedDistance<2>(*region, positionOf<2>(seen->place, *frame->rest, frame->rest->points)) > 0;
        pick.offer(view.handle, box.width() * box.height(), covered);
    }
    return pick.handle();
}

/// The ring stands around the middle of what is selected; false if nothing is.
bool PinTool::placeRing() const {
    if (m_gesture == Gesture::Ring) return true;
    std::vector<Vec<2>> centres;
    std::size_t points = 0;
    for (const PinView<2>& pin : session().pins())
        if (session().selection().contains(pin.handle)) {
            centres.push_back(pin.centre);
            points += pin.points.size();
        }
    m_hasRing = !centres.empty() && (m_gesture == Gesture::None || m_gesture == Gesture::Pressed);
    if (m_hasRing) m_ring.place(surface().toWidget(meanOf<2>(centres)), meanOf<2>(centres), points > 1);
    return m_hasRing;
}

void PinTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || m_gesture != Gesture::None) return;
    m_gesture = Gesture::Pressed;
    m_cross.hide();
    m_widens = event.modifiers() & Qt::AltModifier;
    m_records = event.modifiers() & Qt::ControlModifier;
    m_seconds = secondsOf(event);
    m_from = m_at = event.position();
    if (const int point = curvePointAt(m_from); point > 0) {
        m_gesture = Gesture::Curve;
        m_curve.begin(point, m_from);
        return;
    }
    m_pressed = pinAt(m_from);
    m_part = m_pressed < 0 && placeRing() ? m_ring.partAt(m_from) : std::nullopt;
    if (m_part) return;
    if (m_pressed < 0 && m_curve.isOnCurve(m_from)) m_gesture = Gesture::OnCurve;
    if (m_pressed < 0 && m_gesture != Gesture::OnCurve) m_pressed = regionAt(m_from);
    if (m_pressed >= 0) pressHandle(m_pressed, event.modifiers() & Qt::ShiftModifier);
}

void PinTool::pressHandle(int handle, bool extend) {
    Selection& selection = session().selection();
    if (extend)
        selection.toggle(handle);
    else if (!selection.contains(handle))
        selection.set({handle});
}

void PinTool::move(const QMouseEvent& event) {
    const QPointF at = event.position();
    m_at = at;
    m_seconds = secondsOf(event);
    if (m_gesture == Gesture::None) hover(at);
    if (m_gesture == Gesture::OnCurve && distance(at, m_from) >= 3) m_gesture = Gesture::Pressed;
    if (m_gesture == Gesture::Curve) m_curve.drag(at, event.modifiers() & Qt::ControlModifier);
    if (m_gesture == Gesture::Pressed && distance(at, m_from) >= 3) begin();
    follow(event);
}

void PinTool::follow(const QMouseEvent& event) {
    const QPointF at = event.position();
    if (m_gesture == Gesture::Drag)
        session().dragTo<2>(surface().toShape(at) - surface().toShape(m_from), m_seconds);
    if (m_gesture == Gesture::Ring) dragRing(event.modifiers() & Qt::ShiftModifier);
    if (m_gesture == Gesture::Marquee) surface().setMarquee(QRectF(m_from, at).normalized());
    if (m_gesture == Gesture::None || m_gesture == Gesture::Widen || m_gesture == Gesture::Ring)
        surface().redraw();
}

void PinTool::begin() {
    if (m_part) return beginRing();
    const bool onPin = m_pressed >= 0 && session().selection().contains(m_pressed);
    if (onPin && m_widens) {
        session().selection().set({m_pressed});
        m_gesture = Gesture::Widen;
        return;
    }
    if (m_grip != Grip::Kind::Move && placeRing()) return beginGrip();
    // Who pulls at the dotted ring of a point wants to turn it.
    if (!onPin && placeRing() && !m_ring.canTurn() && m_ring.isOn(m_from)) return refuse(Grip::Kind::Turn);
    m_gesture = onPin ? Gesture::Drag : Gesture::Marquee;
    if (onPin) session().beginDrag({}, m_records);
    if (onPin && !session().isDragging()) m_gesture = Gesture::None;
}

/// Wherever it was pressed.
void PinTool::beginGrip() {
    if (!m_ring.canTurn()) return refuse(m_grip);
    m_part = litPart();
    beginRing();
}

void PinTool::refuse(Grip::Kind kind) {
    m_gesture = Gesture::None;
    emit session().notice(refusal(kind));
}

/// That a drag would take hold of.
std::optional<PinRing::Part> PinTool::litPart() const {
    if (m_part || m_grip == Grip::Kind::Move) return m_part;
    return m_grip == Grip::Kind::Turn ? PinRing::Part::Rotate : PinRing::Part::Scale;
}

void PinTool::beginRing() {
    m_ring.begin(*m_part, m_from, [this](const QPointF& p) { return surface().toShape(p); });
    m_typed.clear();
    m_amount.setZero();
    session().beginDrag(m_ring.grip(), m_records);
    m_gesture = session().isDragging() ? Gesture::Ring : Gesture::None;
}

void PinTool::dragRing(bool snaps) {
    m_amount = m_ring.drag(
        m_at, [this](const QPointF& p) { return surface().toShape(p); }, snaps);
    if (!m_typed.isEmpty()) m_amount = m_ring.typed(m_typed.value());
    session().dragBy(m_amount, m_seconds);
}

void PinTool::finishDrag() {
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    m_part.reset();
    if (!std::exchange(m_typed, TypedNumber()).isEmpty()) {
        session().endDragStraight();
        return;
    }
    const double pixel = (surface().toShape({1, 0}) - surface().toShape({0, 0})).norm();
    session().endDrag(gesture == Gesture::Ring
                          ? kTurnDetail
                          : std::max(kStrokeDetail * pixel, kMinDetail * session().pixel()));
}

/// From the middle of the pin to the pointer, in the domain's units.
double PinTool::widenedTo(const QPointF& at) const {
    for (const PinView<2>& pin : session().pins())
        if (pin.handle == m_pressed) return (surface().toShape(at) - pin.centre).norm();
    return 0;
}

void PinTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    if (m_gesture == Gesture::Drag || m_gesture == Gesture::Ring) {
        m_seconds = secondsOf(event);
        if (isRecording(session()))  // it has rested until now
            session().dragBy(session().gesture()->amount(), m_seconds);
        finishDrag();
        hover(event.position());
        return;
    }
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    if (gesture == Gesture::Curve) m_curve.finish();
    if (gesture == Gesture::OnCurve) m_curve.choose(-1), surface().redraw();
    if (gesture == Gesture::Widen) widenPin(session(), m_pressed, widenedTo(event.position()));
    if (gesture == Gesture::Marquee) {
        surface().setMarquee({});
        selectInside(QRectF(m_from, event.position()).normalized(), event.modifiers());
    }
    if (gesture == Gesture::Pressed && m_pressed < 0 && !m_part)
        clickAt(event.position(), event.modifiers() & Qt::ShiftModifier);
    hover(event.position());
}

/// What is seen there, or the nearest corner of its cell.
std::optional<Location<2>> PinTool::placeAt(const QPointF& widget) const {
    const auto seen = surface().touch(widget);
    if (!seen) return {};
    Location<2> place = seen->place;
    Eigen::Index corner = 0;
    place.weights.maxCoeff(&corner);
    if (m_snaps) place.weights = Eigen::Vector3d::Unit(corner);
    return place;
}

/// Every handle of which a point lies inside.
void PinTool::selectInside(const QRectF& rectangle, Qt::KeyboardModifiers modifiers) {
    std::vector<int> handles;
    for (const PinView<2>& pin : session().pins()) {
        const auto inside = [&](const Vec<2>& p) { return rectangle.contains(surface().toWidget(p)); };
        if (inside(pin.centre) || std::any_of(pin.points.begin(), pin.points.end(), inside))
            handles.push_back(pin.handle);
    }
    session().selection().pick(handles, pickBy(modifiers));
}

void PinTool::doubleClick(const QMouseEvent& event) {
    const QPointF at = event.position();
    const bool onCurve =
        event.button() == Qt::LeftButton && curvePointAt(at) <= 0 && pinAt(at) < 0;  // pins come first
    if (!onCurve || !m_curve.insertAt(at)) press(event);
}

bool PinTool::ownsKey(const QKeyEvent& event) const {
    if (m_gesture == Gesture::Ring) return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    return event.key() == Qt::Key_Delete && !event.modifiers() && m_curve.chosen() > 0;
}

MenuPlace PinTool::menuAt(const QPointF& at) {
    if (m_gesture != Gesture::None) return MenuPlace::None;
    if (pinAt(at) < 0 && m_curve.pointAtForMenu(at)) return MenuPlace::Curve;
    const int handle = handleAt(at);
    return menuOfPin(session().selection(), handle >= 0 ? handle : wayUnder<2>(surface(), at));
}

void PinTool::hover(const QPointF& at) {
    m_part = pinAt(at) < 0 && placeRing() ? m_ring.partAt(at) : std::nullopt;
    m_hovered = m_part ? -1 : handleAt(at);
    surface().setHovered(m_hovered);
}

/// The pins that are selected; without any, a cross that Enter clicks at.
bool PinTool::nudge(const QKeyEvent& event) {
    if (session().selection().isEmpty())
        return m_cross.take<2>(event, surface(), [this](const QPointF& at) { clickAt(at, false); });
    m_cross.hide();
    const auto by = arrowOf(event);
    if (by) session().nudgeSelected<2>(session().pixel() * Vec<2>(by->x(), by->y()));
    return by.has_value();
}

/// What is there is selected, or a pin is set.
void PinTool::clickAt(const QPointF& at, bool extend) {
    const int handle = handleAt(at);
    const int found = handle >= 0 ? handle : wayUnder<2>(surface(), at);
    if (found >= 0) return pressHandle(found, extend);
    const int added = m_adds ? session().addPin<2>(placeAt(at)) : -1;
    if (added < 0 && !extend) session().selection().clear();
}

bool PinTool::key(const QKeyEvent& event) {
    if (ownsKey(event) && m_gesture == Gesture::None) {
        m_curve.removePoint();
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        if (m_gesture == Gesture::None)
            session().selection().clear();
        else
            cancel();
        return true;
    }
    if (m_gesture == Gesture::None) return nudge(event);
    if (m_gesture != Gesture::Ring) return false;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        finishDrag();
    else if (m_typed.take(event))
        dragRing(false);
    else
        return false;
    surface().redraw();
    return true;
}

void PinTool::cancel() {
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    m_part.reset();
    m_typed.clear();
    if (gesture == Gesture::Drag || gesture == Gesture::Ring) session().cancelDrag();
    if (gesture == Gesture::Marquee) surface().setMarquee({});
    m_curve.cancel();
}

void PinTool::paint(QPainter& painter) const {
    m_curve.paint(painter, m_at);
    paintRecording(painter, session(), m_at + QPointF(16, -34));
    if (session().selection().isEmpty()) m_cross.paint(painter);
    if (m_gesture == Gesture::Widen) return paintWidened(painter);
    if (!placeRing()) return;
    m_ring.paint(painter, litPart());
    if (m_gesture == Gesture::Ring) paintLabel(painter, m_at + QPointF(16, 16), m_ring.text(m_amount));
}

void PinTool::paintWidened(QPainter& painter) const {
    for (const PinView<2>& pin : session().pins()) {
        if (pin.handle != m_pressed) continue;
        const QPointF centre = surface().toWidget(pin.centre);
        painter.setPen(QPen(QColor(kAccent), marked(2)));
        painter.setBrush(QColor(0x4a, 0x5b, 0xd4, 20));
        painter.drawEllipse(centre, distance(centre, m_at), distance(centre, m_at));
    }
}

}  // namespace wend
