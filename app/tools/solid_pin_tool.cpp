#include "app/tools/solid_pin_tool.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <numbers>

#include "app/session/mark_size.h"
#include "app/tools/drag_label.h"
#include "app/tools/pin_picking.h"

namespace wend {

namespace {

constexpr double kReach = 9;           // pixels of the screen
constexpr double kPointReach = 5;      // of single points of a handle of many
constexpr double kStrokeDetail = 0.5;  // pixels of the screen that a recorded path may deviate

QString said(const char* text) {
    return QCoreApplication::translate("SolidPinTool", text);
}

double distance(const QPointF& a, const QPointF& b) {
    return QLineF(a, b).length();
}

}  // namespace

SolidPinTool::SolidPinTool(SolidSurface& surface, Manipulator& manipulator, bool adds)
    : SolidTool(surface),
      m_manipulator(manipulator),
      m_curve(surface.session(), {[this](const Vec<3>& p) { return this->surface().toWidget(p); },
                                  [this](const Vec<3>& p, const QPointF& from, const QPointF& to) -> Vec<3> {
                                      return acrossTheScreen(this->surface(), p, to) -
                                             acrossTheScreen(this->surface(), p, from);
                                  },
                                  [this] { this->surface().redraw(); }}),
      m_adds(adds) {}

void SolidPinTool::setGrip(Grip::Kind kind) {
    using enum Manipulator::Mode;
    m_manipulator.setMode(kind == Grip::Kind::Turn ? Turn : kind == Grip::Kind::Grow ? Grow : Move);
    surface().redraw();
}

QString SolidPinTool::hint() const {
    if (m_gesture == Gesture::Curve || (m_gesture == Gesture::None && m_curve.pointAt(m_at) > 0))
        return curveHint(true);
    if (isRecording(session())) return recordingHint();
    if (m_gesture == Gesture::Drag)
        return said(QT_TRANSLATE_NOOP(
            "SolidPinTool", "X, Y, Z lock an axis, numbers set the amount, Esc puts the solid back"));
    if (m_part)
        return said(QT_TRANSLATE_NOOP("SolidPinTool",
                                      "Drag an arrow, a square or a ring; G moves, R turns, S scales"));
    if (m_hovered >= 0)
        return said(QT_TRANSLATE_NOOP(
            "SolidPinTool",
            "Drag to move along the screen, Ctrl-drag to record it, Shift-click to select more"));
    if (m_gesture == Gesture::None && m_curve.isOnCurve(m_at)) return curveHint(false);
    return outlineHint();
}

/// What a press beside all pins would begin.
QString SolidPinTool::outlineHint() const {
    if (m_outline.kind() == Outline::Lasso)
        return m_adds ? said(QT_TRANSLATE_NOOP(
                            "SolidPinTool",
                            "Click on the solid to set a pin, or draw around pins to select them"))
                      : said(QT_TRANSLATE_NOOP(
                            "SolidPinTool", "Draw around pins to select them; Shift adds, Ctrl takes away"));
    if (m_outline.kind() == Outline::Brush)
        return m_adds ? said(QT_TRANSLATE_NOOP(
                            "SolidPinTool",
                            "Click on the solid to set a pin, or brush over pins to select them; [ and ] "
                            "change the size"))
                      : said(QT_TRANSLATE_NOOP("SolidPinTool",
                                               "Brush over pins to select them, [ and ] change the size; "
                                               "Shift adds, Ctrl takes away"));
    if (m_adds)
        return said(
            QT_TRANSLATE_NOOP("SolidPinTool", "Click on the solid to set a pin, then drag pins to bend it"));
    return said(QT_TRANSLATE_NOOP(
        "SolidPinTool",
        "Click, or draw beside pins, to select; Shift adds, Ctrl takes away; drag or arrow keys move"));
}

QCursor SolidPinTool::cursor() const {
    if (m_gesture == Gesture::Drag) return Qt::ClosedHandCursor;
    if (m_hovered >= 0 || m_part) return Qt::OpenHandCursor;
    return m_adds ? Qt::CrossCursor : Qt::ArrowCursor;
}

/// The manipulator stands in the middle of what is selected; false if nothing is.
bool SolidPinTool::placeManipulator() const {
    if (m_gesture == Gesture::Drag) return true;
    std::vector<Vec<3>> centres;
    for (const auto& pin : session().pins<3>())
        if (session().selection().contains(pin.handle)) centres.push_back(pin.centre);
    if (centres.empty()) return false;
    m_manipulator.place(meanOf<3>(centres));
    return true;
}

int SolidPinTool::handleAt(const QPointF& widget) const {
    PinPick pick;
    for (const auto& pin : session().pins<3>())
        if (const double d = distance(surface().toWidget(pin.centre), widget); d <= marked(kReach))
            pick.offer(pin.handle, d, pin.points.size() == 1 && !m_through && isCovered<3>(surface(), pin));
    if (pick.handle() >= 0) return pick.handle();
    for (const auto& pin : session().pins<3>())
        for (const Vec<3>& p : pin.points)
            if (const double d = distance(surface().toWidget(p), widget);
                d <= marked(kPointReach) && (m_through || !surface().isHidden(p)))
                pick.offer(pin.handle, d, false);
    return pick.handle() >= 0 ? pick.handle() : ghostUnder<3>(surface(), widget);
}

bool SolidPinTool::wants(const QPointF& at) const {
    return handleAt(at) >= 0 || m_curve.pointAt(at) > 0 || m_curve.isOnCurve(at) ||
           wayUnder<3>(surface(), at) >= 0 || (placeManipulator() && m_manipulator.partAt(surface(), at));
}

void SolidPinTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || m_gesture != Gesture::None) return;
    m_gesture = Gesture::Pressed;
    m_cross.hide();
    m_from = m_at = event.position();
    m_records = event.modifiers() & Qt::ControlModifier;
    m_seconds = secondsOf(event);
    m_over = true;
    if (const int point = m_curve.pointAt(m_from); point > 0) {
        m_gesture = Gesture::Curve;
        m_curve.begin(point, m_from);
        return;
    }
    m_part = placeManipulator() ? m_manipulator.partAt(surface(), m_from) : std::nullopt;
    m_pressed = handleAt(m_from);
    const bool onOwnCentre = m_part && m_pressed >= 0 && session().selection().contains(m_pressed);
    if (m_part && !onOwnCentre) m_pressed = -1;
    if (m_pressed < 0 && !m_part && m_curve.isOnCurve(m_from)) m_gesture = Gesture::OnCurve;
    m_outline.begin(m_from);
    if (m_pressed < 0 || (onOwnCentre && !(event.modifiers() & Qt::ShiftModifier))) return;
    select(m_pressed, event.modifiers() & Qt::ShiftModifier);
}

void SolidPinTool::move(const QMouseEvent& event) {
    m_at = event.position();
    m_seconds = secondsOf(event);
    m_over = true;
    if (m_gesture == Gesture::None) {
        m_hovered = handleAt(m_at);
        m_part = placeManipulator() ? m_manipulator.partAt(surface(), m_at) : std::nullopt;
    }
    if (m_gesture == Gesture::OnCurve && distance(m_at, m_from) >= 3) m_gesture = Gesture::Pressed;
    if (m_gesture == Gesture::Pressed && distance(m_at, m_from) >= 3) begin(m_at);
    if (m_gesture == Gesture::Marquee) m_outline.goOn(m_at);
    if (m_gesture == Gesture::Drag) drag(m_at);
    if (m_gesture == Gesture::Curve) m_curve.drag(m_at, event.modifiers() & Qt::ControlModifier);
    surface().redraw();
}

/// What was pressed decides: a part of the manipulator, a pin (along the screen), or nothing (a rectangle).
void SolidPinTool::begin(const QPointF& at) {
    const bool onPin = m_pressed >= 0 && session().selection().contains(m_pressed);
    if (!m_part && !onPin) {
        m_gesture = Gesture::Marquee;
        return;
    }
    placeManipulator();
    m_manipulator.begin(m_part.value_or(Manipulator::Part{}), surface(), m_from);
    m_part = m_manipulator.part();
    m_typed.clear();
    m_amount.setZero();
    session().beginDrag(m_manipulator.grip(surface()), m_records);
    m_gesture = session().isDragging() ? Gesture::Drag : Gesture::None;
    Q_UNUSED(at);
}

void SolidPinTool::drag(const QPointF& at) {
    m_amount = m_manipulator.drag(surface(), at);
    if (!m_typed.isEmpty()) m_amount = m_manipulator.typed(m_typed.value(), surface());
    session().dragBy(m_amount, m_seconds);
}

/// Another axis for the gesture that goes on: it begins again from where it began.
void SolidPinTool::lock(int axis) {
    Manipulator::Part part = m_manipulator.part();
    part.axis = part.axis == axis ? -1 : axis;
    part.plane = false;
    m_manipulator.begin(part, surface(), m_from);
    m_part = part;
    if (part.kind == Grip::Kind::Turn) {  // around another axis it is another gesture
        session().cancelDrag();
        session().beginDrag(m_manipulator.grip(surface()), m_records);
    }
    drag(m_at);
}

void SolidPinTool::finish() {
    m_gesture = Gesture::None;
    m_part.reset();
    if (!std::exchange(m_typed, TypedNumber()).isEmpty()) {
        session().endDragStraight();
        return;
    }
    const double pixel = surface().pixelSize(m_manipulator.centre());
    const bool moves = m_manipulator.part().kind == Grip::Kind::Move;
    session().endDrag(moves ? kStrokeDetail * pixel : 0.005);
}

void SolidPinTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    const bool extend = event.modifiers() & Qt::ShiftModifier;
    if (m_gesture == Gesture::Drag) {
        m_seconds = secondsOf(event);
        drag(event.position());
        finish();
        return;
    }
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    if (gesture == Gesture::Curve) m_curve.finish();
    if (gesture == Gesture::OnCurve) m_curve.choose(-1);
    m_at = event.position();
    m_outline.endAt(m_at);
    if (gesture == Gesture::Marquee) selectInside(event.modifiers());
    if (gesture == Gesture::Pressed && m_pressed < 0 && !m_part) clickAt(event.position(), extend);
    surface().redraw();
}

/// What is there is selected, or a pin is set.
void SolidPinTool::clickAt(const QPointF& at, bool extend) {
    const int handle = handleAt(at);
    const int found = handle >= 0 ? handle : wayUnder<3>(surface(), at);
    if (found >= 0) return select(found, extend);
    const SolidHit hit = m_adds ? surface().pick(at) : SolidHit{};
    if (hit.vertex >= 0 && m_snaps)
        session().addSolidHandle({hit.vertex}, ShapeSession::tr("Pin").toStdString());
    else if (hit.vertex >= 0)
        session().addPin<3>(surface().touch(at)->place);
    else if (!extend)
        session().selection().clear();
}

void SolidPinTool::select(int handle, bool extend) {
    if (extend)
        session().selection().toggle(handle);
    else if (!session().selection().contains(handle))
        session().selection().set({handle});
}

/// If its mark lies inside, or any point of it; only what is seen, unless through.
bool SolidPinTool::isTaken(const PinView<3>& pin) const {
    const bool many = pin.points.size() > 1;
    if (many && m_outline.contains(surface().toWidget(pin.centre))) return true;  // the mark is never hidden
    return std::any_of(pin.points.begin(), pin.points.end(), [&](const Vec<3>& p) {
        return m_outline.contains(surface().toWidget(p)) && (m_through || !surface().isHidden(p));
    });
}

void SolidPinTool::selectInside(Qt::KeyboardModifiers modifiers) {
    std::vector<int> handles;
    for (const auto& pin : session().pins<3>())
        if (isTaken(pin)) handles.push_back(pin.handle);
    session().selection().pick(handles, pickBy(modifiers));
}

void SolidPinTool::doubleClick(const QMouseEvent& event) {
    const QPointF at = event.position();
    const bool taken = m_curve.pointAt(at) > 0 || handleAt(at) >= 0 ||
                       (placeManipulator() && m_manipulator.partAt(surface(), at));
    if (event.button() != Qt::LeftButton || taken || !m_curve.insertAt(at)) press(event);
}

void SolidPinTool::leave() {
    m_over = false;
}

MenuPlace SolidPinTool::menuAt(const QPointF& at) {
    if (m_curve.pointAtForMenu(at)) return MenuPlace::Curve;
    const int handle = handleAt(at);
    return menuOfPin(session().selection(), handle >= 0 ? handle : wayUnder<3>(surface(), at));
}

bool SolidPinTool::ownsKey(const QKeyEvent& event) const {
    return event.key() == Qt::Key_Delete && !event.modifiers() && m_curve.chosen() > 0;
}

/// Along the screen, by a pixel of it; without a pin that is selected, a cross that Enter clicks at.
bool SolidPinTool::nudge(const QKeyEvent& event) {
    if (session().selection().isEmpty())
        return m_cross.take<3>(event, surface(), [this](const QPointF& at) { clickAt(at, false); });
    m_cross.hide();
    const auto by = arrowOf(event);
    if (!by || !placeManipulator()) return false;
    const QPointF at = surface().toWidget(m_manipulator.centre());
    m_manipulator.begin({}, surface(), at);
    session().nudgeSelected<3>(m_manipulator.drag(surface(), at + *by));
    return true;
}

bool SolidPinTool::key(const QKeyEvent& event) {
    if (ownsKey(event) && m_gesture == Gesture::None) {
        m_curve.removePoint();
        return true;
    }
    if (m_gesture != Gesture::Drag && m_outline.key(event)) {
        surface().redraw();
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        if (m_gesture == Gesture::None)
            session().selection().clear();
        else
            cancel();
        surface().redraw();
        return true;
    }
    if (m_gesture == Gesture::None) return nudge(event);
    if (m_gesture != Gesture::Drag) return false;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        finish();
        return true;
    }
    if (event.key() >= Qt::Key_X && event.key() <= Qt::Key_Z) {
        lock(event.key() - Qt::Key_X);
        surface().redraw();
        return true;
    }
    if (!m_typed.take(event)) return false;
    drag(m_at);
    surface().redraw();
    return true;
}

void SolidPinTool::cancel() {
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    m_part.reset();
    m_typed.clear();
    if (gesture == Gesture::Drag) session().cancelDrag();
    m_curve.cancel();
}

QString SolidPinTool::numbers() const {
    const QLocale locale;
    const auto text = [&locale](double x) { return locale.toString(x, 'g', 4); };
    switch (m_manipulator.part().kind) {
        case Grip::Kind::Turn:
            return text(m_amount[0] * 180 / std::numbers::pi) + QStringLiteral("°");
        case Grip::Kind::Grow:
            return QStringLiteral("×") + text(1 + m_amount[0]);
        case Grip::Kind::Move:
            break;
    }
    return QStringLiteral("%1  %2  %3").arg(text(m_amount[0]), text(m_amount[1]), text(m_amount[2]));
}

void SolidPinTool::paint(QPainter& painter) const {
    if (m_gesture == Gesture::Marquee) return m_outline.paint(painter);
    const bool beside = m_hovered < 0 && !m_part;
    const bool waits = m_gesture == Gesture::None || m_gesture == Gesture::Pressed;
    if (m_outline.kind() == Outline::Brush && m_over && waits && beside) m_outline.paintBrush(painter, m_at);
    m_curve.paint(painter, m_at);
    if (session().selection().isEmpty()) m_cross.paint(painter);
    if (!placeManipulator()) return;
    if (m_gesture != Gesture::Drag) {
        m_manipulator.paint(painter, surface(), m_part);
        return;
    }
    Manipulator moved = m_manipulator;
    if (m_manipulator.part().kind == Grip::Kind::Move) moved.place(m_manipulator.centre() + m_amount);
    moved.paint(painter, surface(), m_part);
    paintLabel(painter, surface().toWidget(moved.centre()) + QPointF(18, 34), numbers());
    paintRecording(painter, session(), m_at + QPointF(16, -34));
}

}  // namespace wend
