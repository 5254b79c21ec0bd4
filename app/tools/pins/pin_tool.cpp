#include "app/tools/pins/pin_tool.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

#include "app/engine/shape/shape.h"
#include "app/session/pins/pin_shapes.h"
#include "app/tools/drag_label.h"

namespace wend {

namespace {

constexpr double kStrokeDetail = 0.5;  // pixels of the screen that a recorded path may deviate
constexpr double kTurnDetail = 0.005;  // radians, or a factor: tolerance of recorded rotations and scalings
constexpr double kMinDetail = 0.2;     // but no less than this, in pixels of the picture
constexpr double kPinDrag = 3;         // pixels: less is a click

/// Returns the step of an arrow key: pixels of the picture, whose axes are those of the screen.
Vec<2> nudgeOf(ToolSurface& surface, const Vec<2>&, const QPointF& by) {
    const double down = surface.toShape({0, 1}).y() - surface.toShape({0, 0}).y();
    return surface.session().pixel() * Vec<2>(by.x(), std::copysign(by.y(), down * by.y()));
}

/// Returns the step in a solid: pixels of the screen, across the direction of view.
Vec<3> nudgeOf(SolidSurface& surface, const Vec<3>& p, const QPointF& by) {
    const QPointF at = surface.toWidget(p);
    return acrossTheScreen(surface, p, at + by) - acrossTheScreen(surface, p, at);
}

}  // namespace

template <int Dim>
PinTool<Dim>::PinTool(SurfaceOf<Dim>& view, PinChoice& choice, bool adds)
    : ShapeTool<Dim>(view), m_curve(view), m_choice(choice), m_adds(adds) {
    QObject::connect(&choice, &PinChoice::changed, &m_listener, [this] { takeChoice(); });
    takeChoice();
}

template <int Dim>
void PinTool<Dim>::takeChoice() {
    m_gizmo.setGrip(m_choice.now().grip);
    m_outline.setKind(m_choice.now().selectBy);
    m_outline.setRadius(m_choice.now().radius);
    surface().redraw();
}

template <int Dim>
int PinTool<Dim>::handleAt(const QPointF& widget) const {
    const int pin = pinAt(widget);
    return pin >= 0 ? pin : partUnder<Dim>(surface(), widget, takesHidden());
}

/// The end of a curve is below its pin, which takes precedence until that point is chosen.
template <int Dim>
int PinTool<Dim>::curvePointAt(const QPointF& at) const {
    const int point = m_curve.pointAt(at);
    return point == m_curve.chosen() || pinAt(at) < 0 ? point : -1;
}

template <int Dim>
std::optional<GizmoPart> PinTool<Dim>::partAt(const QPointF& at) const {
    const bool looks = (Gizmo<Dim>::kComesFirst || pinAt(at) < 0) && placeGizmo();
    return looks ? m_gizmo.partAt(surface(), at) : std::nullopt;
}

/// Returns the part that a drag would use.
template <int Dim>
std::optional<GizmoPart> PinTool<Dim>::litPart() const {
    return m_part ? m_part : m_gizmo.anywhere();
}

template <int Dim>
bool PinTool<Dim>::wants(const QPointF& at) const {
    return handleAt(at) >= 0 || m_curve.pointAt(at) > 0 || m_curve.isOnCurve(at) ||
           wayUnder<Dim>(surface(), at) >= 0 || partAt(at);
}

/// Places the gizmo at the centre of the selection; false if nothing is selected.
template <int Dim>
bool PinTool<Dim>::placeGizmo() const {
    if (m_gesture == Gesture::Drag) return true;
    if (!surface().showsManipulators()) return false;
    std::vector<Vec<Dim>> centres;
    std::size_t points = 0;
    for (const auto& pin : session().template pins<Dim>()) {
        if (!isSelected(pin.handle)) continue;
        centres.push_back(pin.centre);
        points += pin.points.size();
    }
    if (centres.empty()) return false;
    m_gizmo.place(meanOf<Dim>(centres), points > 1);
    return true;
}

template <int Dim>
void PinTool<Dim>::takePointer(const QMouseEvent& event) {
    m_at = event.position();
    m_seconds = secondsOf(event);
    m_over = true;
}

template <int Dim>
void PinTool<Dim>::hover() {
    m_part = partAt(m_at);
    m_hovered = m_part ? pinAt(m_at) : handleAt(m_at);
}

template <int Dim>
void PinTool<Dim>::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || m_gesture != Gesture::None) return;
    takePointer(event);
    m_gesture = Gesture::Pressed;
    m_cross.hide();
    m_from = m_at;
    m_with = event.modifiers();
    m_outline.begin(m_from);
    if (const int point = curvePointAt(m_from); point > 0) {
        m_gesture = Gesture::Curve;
        m_curve.begin(point, m_from);
        return;
    }
    m_part = partAt(m_from);
    m_pressed = pinAt(m_from);
    if (m_pressed < 0 && !m_part && m_curve.isOnCurve(m_from)) {
        m_gesture = Gesture::OnCurve;
        return;
    }
    if (m_pressed < 0 && !m_part) m_pressed = handleAt(m_from);
    const bool isOwn = m_part && isSelected(m_pressed);  // the gizmo's middle is on its pin
    if (m_part && !isOwn) m_pressed = -1;
    const bool extend = m_with & Qt::ShiftModifier;
    m_leaves = extend && isSelected(m_pressed);
    if (m_pressed >= 0 && !m_leaves && (!isOwn || extend)) select(m_pressed, extend);
}

template <int Dim>
void PinTool<Dim>::move(const QMouseEvent& event) {
    takePointer(event);
    if (m_gesture == Gesture::None) hover();
    const bool drags = QLineF(m_at, m_from).length() >= kPinDrag;
    if (m_gesture == Gesture::OnCurve && drags) m_gesture = Gesture::Pressed;
    if (m_gesture == Gesture::Pressed && drags) begin();
    if (m_gesture == Gesture::Marquee) m_outline.goOn(m_at);
    const bool steps = event.modifiers() & Qt::ShiftModifier;
    if (m_gesture == Gesture::Drag) drag(steps);
    if (m_gesture == Gesture::Curve) m_curve.drag(reached(steps), event.modifiers() & Qt::ControlModifier);
    surface().redraw();
}

/// Returns whether the drag of a pin widens it. Window managers take drags with Alt alone.
template <int Dim>
bool PinTool<Dim>::widens() const {
    constexpr Qt::KeyboardModifiers kBoth = Qt::ControlModifier | Qt::ShiftModifier;
    return m_with & Qt::AltModifier || (m_with & kBoth) == kBoth;
}

/// Starts the gesture of the pressed item: a part of the gizmo, a pin, the bare shape, or none.
template <int Dim>
void PinTool<Dim>::begin() {
    const bool onPin = isSelected(m_pressed);
    if (onPin && widens()) {
        session().selection().set({m_pressed});
        m_gesture = Gesture::Widen;
        return;
    }
    const bool isPlaced = placeGizmo();
    if (isPlaced) m_part = litPart();
    if (isPlaced && !m_part && !onPin && m_gizmo.turnsPointAt(surface(), m_from))
        m_part = Part{Grip::Kind::Turn};
    if (m_part && !canUse(*m_part)) {
        m_gesture = Gesture::None;
        return;
    }
    if (m_part || onPin || setPin())
        beginDrag(m_part.value_or(Part{}));
    else
        m_gesture = Gesture::Marquee;
}

/// Adds and drags a pin in one step.
template <int Dim>
bool PinTool<Dim>::setPin() {
    const bool isPlain = !(m_with & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier));
    if (!m_adds || !isPlain || !surface().touch(m_from)) return false;
    session().document().beginStep();
    m_pressed = addPin(m_from);
    m_sets = m_pressed >= 0;
    if (!m_sets) session().document().endStep();
    placeGizmo();
    return m_sets;
}

/// Widens a single point before it rotates or scales: its disc gets the angle that the shape has there before
/// it is rotated on.
template <int Dim>
bool PinTool<Dim>::canUse(const Part& part) {
    const int handle = session().singleHandle();
    if (part.kind == Grip::Kind::Move || m_gizmo.canTurn() || !holdsPoint<Dim>(session(), handle))
        return true;
    const Vec<Dim> point = m_gizmo.centre();
    session().document().beginStep();
    m_sets = Dim == 2 && part.kind == Grip::Kind::Turn ? widenTurned(session(), handle)
                                                       : widenPoint<Dim>(session(), handle);
    if (!m_sets) session().document().endStep();
    m_gizmo.place(point, m_sets);  // not at the mean of the disc's vertices
    return m_sets;
}

template <int Dim>
void PinTool<Dim>::beginDrag(const Part& part) {
    m_gizmo.begin(part, surface(), m_from);
    m_part = part;
    m_typed.clear();
    m_amount.setZero();
    session().beginDrag(m_gizmo.grip(surface()), m_with & Qt::ControlModifier);
    m_gesture = Gesture::Drag;
    if (!session().isDragging()) finishDrag();
}

template <int Dim>
void PinTool<Dim>::drag(bool snaps) {
    const bool isFree = m_gizmo.part().kind == Grip::Kind::Move && m_gizmo.part().axis < 0;
    m_amount = m_gizmo.drag(surface(), reached(snaps && isFree), snaps);
    if (!m_typed.isEmpty()) m_amount = m_gizmo.typed(m_typed.value(), surface());
    session().dragBy(m_amount, m_seconds);
}

/// Restarts the gesture from its beginning along another axis.
template <int Dim>
void PinTool<Dim>::lock(int axis) {
    Part part = m_gizmo.part();
    part.axis = part.axis == axis ? -1 : axis;
    part.plane = false;
    m_gizmo.begin(part, surface(), m_from);
    m_part = part;
    session().cancelDrag();  // drops the path so far
    session().beginDrag(m_gizmo.grip(surface()), m_with & Qt::ControlModifier);
    drag();
}

template <int Dim>
void PinTool<Dim>::finishDrag() {
    m_gesture = Gesture::None;
    m_part.reset();
    const double pixel = surface().pixelSize(m_gizmo.centre());
    if (!std::exchange(m_typed, TypedNumber()).isEmpty())
        session().endDragStraight();
    else if (m_gizmo.part().kind == Grip::Kind::Move)
        session().endDrag(std::max(kStrokeDetail * pixel, kMinDetail * session().pixel()));
    else
        session().endDrag(kTurnDetail);
    if (std::exchange(m_sets, false)) session().document().endStep();
}

/// Returns the distance from the pin's centre to the pointer in domain units.
template <int Dim>
double PinTool<Dim>::widenedTo(const QPointF& at) const {
    for (const auto& pin : session().template pins<Dim>())
        if (pin.handle == m_pressed) return (acrossTheScreen(surface(), pin.centre, at) - pin.centre).norm();
    return 0;
}

template <int Dim>
void PinTool<Dim>::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    takePointer(event);
    if (m_gesture == Gesture::Drag) {
        drag(event.modifiers() & Qt::ShiftModifier);
        finishDrag();
    }
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    if (gesture == Gesture::Pressed && m_leaves) session().selection().toggle(m_pressed);
    if (gesture == Gesture::Curve) m_curve.finish();
    if (gesture == Gesture::OnCurve) m_curve.choose(-1);
    if (gesture == Gesture::Widen) widenPin<Dim>(session(), m_pressed, widenedTo(m_at));
    m_outline.endAt(m_at);
    if (gesture == Gesture::Marquee) selectInside(event.modifiers());
    if (gesture == Gesture::Pressed && m_pressed < 0 && !m_part)
        clickAt(m_at, event.modifiers() & Qt::ShiftModifier);
    hover();
    surface().redraw();
}

/// Selects what is under the pointer, or adds a pin.
template <int Dim>
void PinTool<Dim>::clickAt(const QPointF& at, bool extend) {
    const int handle = handleAt(at);
    const int found = handle >= 0 ? handle : wayUnder<Dim>(surface(), at);
    if (found >= 0) return select(found, extend);
    const int added = m_adds ? addPin(at) : -1;
    if (added < 0 && !extend) session().selection().clear();
}

/// Adds a pin at the visible place, or at the nearest corner of its cell if that is visible. Returns −1 and
/// emits a notice outside the shape.
template <int Dim>
int PinTool<Dim>::addPin(const QPointF& at) {
    auto touched = surface().touch(at);
    if (!touched) return session().template addPin<Dim>(std::optional<Location<Dim>>());
    const bool snaps = m_choice.now().snaps && !session().template frame<Dim>()->built->hidesVertices();
    Eigen::Index corner = 0;
    touched->place.weights.maxCoeff(&corner);
    if (snaps) touched->place.weights.setUnit(corner);
    return session().template addPin<Dim>(std::optional(touched->place));
}

/// Returns whether the mark or any point of the pin is inside; in a solid only visible ones, unless through.
template <int Dim>
bool PinTool<Dim>::isTaken(const PinView<Dim>& pin) const {
    const bool many = pin.points.size() > 1;
    if (many && m_outline.contains(surface().toWidget(pin.centre))) return true;  // the mark is never hidden
    for (std::size_t i = 0; i < pin.points.size(); ++i) {
        const bool isSeen = Dim == 2 || takesHidden() || !isCovered<Dim>(surface(), pin, i);
        if (isSeen && m_outline.contains(surface().toWidget(pin.points[i]))) return true;
    }
    return false;
}

template <int Dim>
void PinTool<Dim>::selectInside(Qt::KeyboardModifiers modifiers) {
    std::vector<int> handles;
    for (const auto& pin : session().template pins<Dim>())
        if (isTaken(pin)) handles.push_back(pin.handle);
    session().selection().pick(handles, pickBy(modifiers));
}

template <int Dim>
void PinTool<Dim>::doubleClick(const QMouseEvent& event) {
    const QPointF at = event.position();
    const bool isTaken = curvePointAt(at) > 0 || pinAt(at) >= 0 || partAt(at);
    if (event.button() != Qt::LeftButton || isTaken || !m_curve.insertAt(at)) press(event);
}

template <int Dim>
bool PinTool<Dim>::ownsKey(const QKeyEvent& event) const {
    if (m_gesture == Gesture::Drag) return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    return event.key() == Qt::Key_Delete && !event.modifiers() && m_curve.chosen() > 0;
}

template <int Dim>
MenuPlace PinTool<Dim>::menuAt(const QPointF& at) {
    if (m_gesture != Gesture::None) return MenuPlace::None;
    if (pinAt(at) < 0 && m_curve.pointAtForMenu(at)) return MenuPlace::Curve;
    const int handle = handleAt(at);
    return menuOfPin(session().selection(), handle >= 0 ? handle : wayUnder<Dim>(surface(), at));
}

/// The pins that are selected; without any, a cross that Enter clicks at.
template <int Dim>
bool PinTool<Dim>::nudge(const QKeyEvent& event) {
    if (session().selection().isEmpty())
        return m_cross.take<Dim>(event, surface(), [this](const QPointF& at) { clickAt(at, false); });
    m_cross.hide();
    placeGizmo();
    const auto by = arrowOf(event);
    if (by) session().template nudgeSelected<Dim>(nudgeOf(surface(), m_gizmo.centre(), *by));
    return by.has_value();
}

template <int Dim>
bool PinTool<Dim>::key(const QKeyEvent& event) {
    if (m_gesture == Gesture::Drag && event.key() != Qt::Key_Escape) return keyInDrag(event);
    if (m_gesture == Gesture::None && ownsKey(event)) {
        m_curve.removePoint();
        return true;
    }
    const auto sizes = m_outline.radiusAfter(event);
    if (sizes) m_choice.change(&PinSettings::radius, *sizes);
    if (!sizes && event.key() != Qt::Key_Escape) return m_gesture == Gesture::None && nudge(event);
    if (!sizes && m_gesture == Gesture::None) session().selection().clear();
    if (!sizes) cancel();
    surface().redraw();
    return true;
}

template <int Dim>
bool PinTool<Dim>::keyInDrag(const QKeyEvent& event) {
    const int axis = event.key() - Qt::Key_X;
    const bool hasAxes = Dim == 3 || m_gizmo.part().kind == Grip::Kind::Move;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        finishDrag();
    else if (hasAxes && axis >= 0 && axis < Dim)
        lock(axis);
    else if (m_typed.take(event))
        drag();
    else
        return false;
    surface().redraw();
    return true;
}

template <int Dim>
void PinTool<Dim>::cancel() {
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    m_part.reset();
    m_typed.clear();
    if (gesture == Gesture::Drag) session().cancelDrag();
    if (std::exchange(m_sets, false)) session().document().dropStep();
    m_curve.cancel();
}

template class PinTool<2>;
template class PinTool<3>;

}  // namespace wend
