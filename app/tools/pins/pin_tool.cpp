#include "app/tools/pins/pin_tool.h"

#include <QCoreApplication>
#include <QLineF>
#include <algorithm>
#include <cmath>

#include "app/session/pins/pin_shapes.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/drag_label.h"
#include "app/tools/gizmos.h"

namespace wend {

namespace {

constexpr double kStrokeDetail = 0.5;  // pixels of the screen that a recorded path may deviate
constexpr double kTurnDetail = 0.005;  // radians, or a factor: tolerance of recorded rotations and scalings
constexpr double kMinDetail = 0.2;     // but no less than this, in pixels of the picture
constexpr double kPinDrag = 3;         // pixels: less is a click

/// Returns the step of an arrow key: in a picture pixels of it, whose axes are those of the screen; in a
/// solid pixels of the screen, across the direction of view.
Vec3 nudgeOf(ShapeView& view, const Vec3& p, const QPointF& by) {
    if (view.dimension() == 2) {
        const double down = (view.ray({0, 1}).origin - view.ray({0, 0}).origin).y();
        return view.session().motion().pixel() * Vec3(by.x(), std::copysign(by.y(), down * by.y()), 0);
    }
    const QPointF at = view.onScreen(p);
    return acrossTheScreen(view, p, at + by) - acrossTheScreen(view, p, at);
}

std::unique_ptr<Gizmo> gizmoFor(const ShapeView& view) {
    if (view.dimension() == 2) return std::make_unique<PinRing>();
    return std::make_unique<Manipulator>();
}

}  // namespace

bool TypedNumber::take(const QKeyEvent& key) {
    const QString text = key.text();
    if (key.key() == Qt::Key_Backspace)
        m_text.chop(1);
    else if (text == QStringLiteral(",") || text == QStringLiteral("."))
        m_text += '.';
    else if (text.size() == 1 && (text[0].isDigit() || (text[0] == '-' && m_text.isEmpty())))
        m_text += text;
    else
        return false;
    return true;
}

PinTool::PinTool(ShapeView& view, PinChoice& choice, bool adds)
    : ShapeTool<>(view), m_gizmo(gizmoFor(view)), m_curve(view), m_choice(choice), m_adds(adds) {
    QObject::connect(&choice, &PinChoice::changed, &m_listener, [this] { takeChoice(); });
    takeChoice();
}

void PinTool::takeChoice() {
    m_gizmo->setGrip(m_choice.now().grip);
    m_outline.setKind(m_choice.now().selectBy);
    m_outline.setRadius(m_choice.now().radius);
    view().redraw();
}

int PinTool::handleAt(const QPointF& widget) const {
    const int pin = pinAt(widget);
    return pin >= 0 ? pin : partUnder(view(), widget, takesHidden());
}

bool PinTool::isSelected(int handle) const {
    return handle >= 0 && session().selection().contains(handle);
}

void PinTool::select(int handle, bool extend) {
    if (extend) return session().selection().toggle(handle);
    if (!isSelected(handle)) session().selection().set({handle});
}

/// Returns the point of the curve there. The end of a curve is below its pin, which takes precedence until
/// that point is chosen.
int PinTool::curvePointAt(const QPointF& at) const {
    const int point = m_curve.pointAt(at);
    return point == m_curve.chosen() || pinAt(at) < 0 ? point : -1;
}

std::optional<GizmoPart> PinTool::partAt(const QPointF& at) const {
    const bool looks = (m_gizmo->comesFirst() || pinAt(at) < 0) && placeGizmo();
    return looks ? m_gizmo->partAt(view(), at) : std::nullopt;
}

/// Returns the part that a drag would use.
std::optional<GizmoPart> PinTool::litPart() const {
    return m_part ? m_part : m_gizmo->anywhere();
}

bool PinTool::wants(const QPointF& at) const {
    return handleAt(at) >= 0 || m_curve.pointAt(at) > 0 || m_curve.isOnCurve(at) ||
           wayUnder(view(), at) >= 0 || partAt(at);
}

/// Places the gizmo at the centre of the selection; false if nothing is selected.
bool PinTool::placeGizmo() const {
    if (m_gesture == Gesture::Drag) return true;
    if (!view().showsManipulators()) return false;
    std::vector<Vec3> centres;
    std::size_t points = 0;
    for (const auto& pin : session().gestures().pins()) {
        if (!isSelected(pin.handle)) continue;
        centres.push_back(pin.centre);
        points += pin.points.size();
    }
    if (centres.empty()) return false;
    m_gizmo->place(meanOf(centres), points > 1);
    return true;
}

void PinTool::takePointer(const QMouseEvent& event) {
    m_at = event.position();
    m_seconds = secondsOf(event);
    m_over = true;
}

void PinTool::hover() {
    m_part = partAt(m_at);
    m_hovered = m_part ? pinAt(m_at) : handleAt(m_at);
}

void PinTool::press(const QMouseEvent& event) {
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

void PinTool::move(const QMouseEvent& event) {
    takePointer(event);
    if (m_gesture == Gesture::None) hover();
    const bool drags = QLineF(m_at, m_from).length() >= kPinDrag;
    if (m_gesture == Gesture::OnCurve && drags) m_gesture = Gesture::Pressed;
    if (m_gesture == Gesture::Pressed && drags) begin();
    if (m_gesture == Gesture::Marquee) m_outline.goOn(m_at);
    const bool steps = event.modifiers() & Qt::ShiftModifier;
    if (m_gesture == Gesture::Drag) drag(steps);
    if (m_gesture == Gesture::Curve) m_curve.drag(reached(steps), event.modifiers() & Qt::ControlModifier);
    view().redraw();
}

/// Returns whether the drag of a pin widens it. Window managers take drags with Alt alone.
bool PinTool::widens() const {
    constexpr Qt::KeyboardModifiers kBoth = Qt::ControlModifier | Qt::ShiftModifier;
    return m_with & Qt::AltModifier || (m_with & kBoth) == kBoth;
}

/// Starts the gesture of the pressed item: a part of the gizmo, a pin, the bare shape, or none.
void PinTool::begin() {
    const bool onPin = isSelected(m_pressed);
    if (onPin && widens()) {
        session().selection().set({m_pressed});
        m_gesture = Gesture::Widen;
        return;
    }
    const bool isPlaced = placeGizmo();
    if (isPlaced) m_part = litPart();
    if (isPlaced && !m_part && !onPin && m_gizmo->turnsPointAt(view(), m_from))
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
bool PinTool::setPin() {
    const bool isPlain = !(m_with & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier));
    if (!m_adds || !isPlain || !view().touch(m_from)) return false;
    session().document().beginStep();
    m_pressed = addPin(m_from);
    m_sets = m_pressed >= 0;
    if (!m_sets) session().document().endStep();
    placeGizmo();
    return m_sets;
}

/// Widens a single point before it rotates or scales: its disc gets the angle that the shape has there before
/// it is rotated on.
bool PinTool::canUse(const Part& part) {
    const int handle = session().selection().single();
    if (part.kind == Grip::Kind::Move || m_gizmo->canTurn() || !holdsPoint(session(), handle)) return true;
    const Vec3 point = m_gizmo->centre();
    session().document().beginStep();
    m_sets = view().dimension() == 2 && part.kind == Grip::Kind::Turn ? widenTurned(session(), handle)
                                                                      : widenPoint(session(), handle);
    if (!m_sets) session().document().endStep();
    m_gizmo->place(point, m_sets);  // not at the mean of the disc's vertices
    return m_sets;
}

void PinTool::beginDrag(const Part& part) {
    m_gizmo->begin(part, view(), m_from);
    m_part = part;
    m_typed.clear();
    m_amount.setZero();
    session().gestures().begin(m_gizmo->grip(view()), m_with & Qt::ControlModifier);
    m_gesture = Gesture::Drag;
    if (!session().motion().isDragging()) finishDrag();
}

void PinTool::drag(bool snaps) {
    const bool isFree = m_gizmo->part().kind == Grip::Kind::Move && m_gizmo->part().axis < 0;
    m_amount = m_gizmo->drag(view(), reached(snaps && isFree), snaps);
    if (!m_typed.isEmpty()) m_amount = m_gizmo->typed(m_typed.value(), view());
    session().gestures().moveBy(m_amount, m_seconds);
}

/// Restarts the gesture from its beginning along another axis.
void PinTool::lock(int axis) {
    Part part = m_gizmo->part();
    part.axis = part.axis == axis ? -1 : axis;
    part.plane = false;
    m_gizmo->begin(part, view(), m_from);
    m_part = part;
    session().gestures().cancel();  // drops the path so far
    session().gestures().begin(m_gizmo->grip(view()), m_with & Qt::ControlModifier);
    drag();
}

void PinTool::finishDrag() {
    m_gesture = Gesture::None;
    m_part.reset();
    const double pixel = view().pixelSize(m_gizmo->centre());
    if (!std::exchange(m_typed, TypedNumber()).isEmpty())
        session().gestures().endStraight();
    else if (m_gizmo->part().kind == Grip::Kind::Move)
        session().gestures().end(std::max(kStrokeDetail * pixel, kMinDetail * session().motion().pixel()));
    else
        session().gestures().end(kTurnDetail);
    if (std::exchange(m_sets, false)) session().document().endStep();
}

/// Returns the distance from the pin's centre to the pointer in domain units.
double PinTool::widenedTo(const QPointF& at) const {
    for (const auto& pin : session().gestures().pins())
        if (pin.handle == m_pressed) return (acrossTheScreen(view(), pin.centre, at) - pin.centre).norm();
    return 0;
}

void PinTool::release(const QMouseEvent& event) {
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
    if (gesture == Gesture::Widen) widenPin(session(), m_pressed, widenedTo(m_at));
    m_outline.endAt(m_at);
    if (gesture == Gesture::Marquee) selectInside(event.modifiers());
    if (gesture == Gesture::Pressed && m_pressed < 0 && !m_part)
        clickAt(m_at, event.modifiers() & Qt::ShiftModifier);
    hover();
    view().redraw();
}

/// Selects what is under the pointer, or adds a pin.
void PinTool::clickAt(const QPointF& at, bool extend) {
    const int handle = handleAt(at);
    const int found = handle >= 0 ? handle : wayUnder(view(), at);
    if (found >= 0) return select(found, extend);
    const int added = m_adds ? addPin(at) : -1;
    if (added < 0 && !extend) session().selection().clear();
}

/// Adds a pin at the visible place, or at the nearest corner of its cell if that is visible. Returns −1 and
/// emits a notice outside the shape.
int PinTool::addPin(const QPointF& at) {
    auto touched = view().touch(at);
    if (!touched) return session().addPin(std::optional<Place>());
    const bool snaps = m_choice.now().snaps && !frame()->hidesVertices();
    Eigen::Index corner = 0;
    touched->place.weights.maxCoeff(&corner);
    if (snaps) touched->place.weights.setUnit(corner);
    return session().addPin(std::optional(touched->place));
}

/// Returns whether the mark or any point of the pin is inside; in a solid only visible ones, unless through.
bool PinTool::isTaken(const PinView& pin) const {
    const bool many = pin.points.size() > 1;
    if (many && m_outline.contains(view().onScreen(pin.centre))) return true;  // the mark is never hidden
    for (std::size_t i = 0; i < pin.points.size(); ++i) {
        const bool isSeen = view().dimension() == 2 || takesHidden() || !isCovered(view(), pin, i);
        if (isSeen && m_outline.contains(view().onScreen(pin.points[i]))) return true;
    }
    return false;
}

void PinTool::selectInside(Qt::KeyboardModifiers modifiers) {
    std::vector<int> handles;
    for (const auto& pin : session().gestures().pins())
        if (isTaken(pin)) handles.push_back(pin.handle);
    session().selection().pick(handles, pickBy(modifiers));
}

void PinTool::doubleClick(const QMouseEvent& event) {
    const QPointF at = event.position();
    const bool isTaken = curvePointAt(at) > 0 || pinAt(at) >= 0 || partAt(at);
    if (event.button() != Qt::LeftButton || isTaken || !m_curve.insertAt(at)) press(event);
}

bool PinTool::ownsKey(const QKeyEvent& event) const {
    if (m_gesture == Gesture::Drag) return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    return event.key() == Qt::Key_Delete && !event.modifiers() && m_curve.chosen() > 0;
}

MenuPlace PinTool::menuAt(const QPointF& at) {
    if (m_gesture != Gesture::None) return MenuPlace::None;
    if (pinAt(at) < 0 && m_curve.pointAtForMenu(at)) return MenuPlace::Curve;
    const int handle = handleAt(at);
    return menuOfPin(session().selection(), handle >= 0 ? handle : wayUnder(view(), at));
}

/// Moves the selected pins or, without a selection, a cross that Enter clicks at.
bool PinTool::nudge(const QKeyEvent& event) {
    if (session().selection().isEmpty())
        return m_cross.take(event, view(), [this](const QPointF& at) { clickAt(at, false); });
    m_cross.hide();
    placeGizmo();
    const auto by = arrowOf(event);
    if (by) session().gestures().nudge(nudgeOf(view(), m_gizmo->centre(), *by));
    return by.has_value();
}

bool PinTool::key(const QKeyEvent& event) {
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
    view().redraw();
    return true;
}

bool PinTool::keyInDrag(const QKeyEvent& event) {
    const int axis = event.key() - Qt::Key_X;
    const bool hasAxes = view().dimension() == 3 || m_gizmo->part().kind == Grip::Kind::Move;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        finishDrag();
    else if (hasAxes && axis >= 0 && axis < view().dimension())
        lock(axis);
    else if (m_typed.take(event))
        drag();
    else
        return false;
    view().redraw();
    return true;
}

void PinTool::cancel() {
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    m_part.reset();
    m_typed.clear();
    if (gesture == Gesture::Drag) session().gestures().cancel();
    if (std::exchange(m_sets, false)) session().document().dropStep();
    m_curve.cancel();
}

// --- Hints, drawing, cursor and menu entry of the pin tool ---

QString PinTool::hint() const {
    const bool waits = m_gesture == Gesture::None, isOver = waits && m_over;
    if (m_gesture == Gesture::Curve || (isOver && curvePointAt(m_at) > 0)) return curveHint(true);
    if (isRecording(session().gestures())) return recordingHint();
    if (m_gesture == Gesture::Widen)
        return QCoreApplication::translate("PinTool", "Drag as far as the pin should hold; Esc cancels");
    const bool moves = m_gesture == Gesture::Drag && m_gizmo->part().kind == Grip::Kind::Move;
    if (view().dimension() == 3 && m_gesture == Gesture::Drag)
        return QCoreApplication::translate("PinTool",
                                           "Shift keeps it straight; X, Y, Z lock an axis, numbers set the "
                                           "amount, Esc puts the shape back");
    if (moves)
        return QCoreApplication::translate(
            "PinTool",
            "Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back");
    if (m_part) return m_gizmo->hint();
    const bool isPlaced = waits && placeGizmo();
    if (isPlaced && m_gizmo->anywhere()) return gripHint();
    if (m_hovered >= 0)
        return QCoreApplication::translate(
            "PinTool",
            "Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, "
            "Shift-click to select more");
    if (isOver && m_curve.isOnCurve(m_at)) return curveHint(false);
    return isPlaced && m_over && m_gizmo->turnsPointAt(view(), m_at) ? pointHint(Grip::Kind::Turn)
                                                                     : besideHint();
}

/// Returns the hint of a rotating or scaling drag.
QString PinTool::gripHint() const {
    const Grip::Kind kind = m_gizmo->anywhere()->kind;
    if (!m_gizmo->canTurn()) return pointHint(kind);
    return kind == Grip::Kind::Turn
               ? QCoreApplication::translate(
                     "PinTool",
                     "Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl "
                     "records it; digits set the number")
               : QCoreApplication::translate(
                     "PinTool",
                     "Drag anywhere to scale what is selected, Ctrl records it; digits set "
                     "the number");
}

/// Returns the hint of a drag that rotates or scales a single point.
QString PinTool::pointHint(Grip::Kind kind) {
    return kind == Grip::Kind::Grow
               ? QCoreApplication::translate("PinTool", "Drag to scale: the point becomes a small circle")
               : QCoreApplication::translate(
                     "PinTool", "Drag to rotate: the point becomes a small circle, which holds its angle");
}

/// Returns the hint for a press outside all pins.
QString PinTool::besideHint() const {
    if (m_outline.kind() == Outline::Lasso)
        return m_adds
                   ? QCoreApplication::translate("PinTool",
                                                 "Click on the shape to set a pin, drag to bend it at once; "
                                                 "beside it, draw around pins to select them")
                   : QCoreApplication::translate(
                         "PinTool", "Draw around pins to select them; Shift adds, Ctrl takes away");
    if (m_outline.kind() == Outline::Brush)
        return m_adds
                   ? QCoreApplication::translate("PinTool",
                                                 "Click on the shape to set a pin, drag to bend it at once; "
                                                 "beside it, brush over pins, [ and ] change the size")
                   : QCoreApplication::translate("PinTool",
                                                 "Brush over pins to select them, [ and ] change the size; "
                                                 "Shift adds, Ctrl takes away");
    return m_adds
               ? QCoreApplication::translate(
                     "PinTool", "Click on the shape to set a pin, or press and drag to bend it at once")
               : QCoreApplication::translate("PinTool",
                                             "Click, or draw beside pins, to select; Shift adds, Ctrl takes "
                                             "away; drag or arrow keys move");
}

QCursor PinTool::cursor() const {
    if (m_gesture == Gesture::Drag) return Qt::ClosedHandCursor;
    if (m_gesture == Gesture::Widen) return Qt::SizeAllCursor;
    if (m_hovered >= 0 || m_part) return Qt::OpenHandCursor;
    return m_adds ? Qt::CrossCursor : Qt::ArrowCursor;
}

void PinTool::paint(QPainter& painter) const {
    m_curve.paint(painter, m_at);
    paintRecording(painter, session().gestures(), session().playback().speed(), m_at + QPointF(16, -34));
    if (session().selection().isEmpty()) m_cross.paint(painter);
    if (m_gesture == Gesture::Marquee) return m_outline.paint(painter);
    if (m_gesture == Gesture::Widen) return paintWidened(painter);
    const bool waits = m_gesture == Gesture::None || m_gesture == Gesture::Pressed;
    const bool isBeside = waits && m_over && m_hovered < 0 && !m_part;
    if (isBeside && m_outline.kind() == Outline::Brush) m_outline.paintBrush(painter, m_at);
    if (waits && placeGizmo()) m_gizmo->paint(painter, view(), litPart());
    if (m_gesture != Gesture::Drag) return;
    m_gizmo->paintDragged(painter, view(), m_amount);
    const bool isPlain = view().dimension() == 2 && m_part == Part{} && m_typed.isEmpty();
    if (!isPlain) paintLabel(painter, m_at + QPointF(16, 16), m_gizmo->text(m_amount, view().dimension()));
}

void PinTool::paintWidened(QPainter& painter) const {
    for (const auto& pin : session().gestures().pins()) {
        if (pin.handle != m_pressed) continue;
        const QPointF centre = view().onScreen(pin.centre);
        painter.setPen(QPen(QColor(kAccent), marked(2)));
        painter.setBrush(QColor(0x4a, 0x5b, 0xd4, 20));
        const double radius = QLineF(centre, m_at).length();
        painter.drawEllipse(centre, radius, radius);
    }
}

ToolKind pinTool() {
    return toolKind("pin", "pin", QT_TRANSLATE_NOOP("Tools", "&Pin"),
                    QT_TRANSLATE_NOOP("Tools", "Set pins and drag them"), "P", Mode::Pins,
                    both<PinTool>(&Workbench::pins, true),
                    {ToolOption::Grip, ToolOption::Separator, ToolOption::SelectBy, ToolOption::Through,
                     ToolOption::Snap},
                    {}, Mode::Pins);
}

ToolKind selectTool() {
    return toolKind("select", "select", QT_TRANSLATE_NOOP("Tools", "Se&lect"),
                    QT_TRANSLATE_NOOP("Tools", "Select and drag pins without setting new ones"), "V",
                    Modes::all(), both<PinTool>(&Workbench::pins, false),
                    {ToolOption::Grip, ToolOption::Separator, ToolOption::SelectBy, ToolOption::Through});
}

}  // namespace wend
