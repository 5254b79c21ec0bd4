#include "app/tools/pin_tool.h"

#include <QApplication>
#include <QCoreApplication>
#include <algorithm>

namespace wend {

namespace {

constexpr double kReach = 8;           // pixels of the screen
constexpr double kGhostReach = 5;      // of handles that do not hold now: a new pin may be wanted there
constexpr double kStrokeDetail = 0.5;  // pixels of the screen that a recorded path may deviate
constexpr double kLeastDetail = 0.2;   // but no less than this, in pixels of the picture

QString said(const char* text) {
    return QCoreApplication::translate("PinTool", text);
}

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

QString PinTool::hint() const {
    if (m_gesture == Gesture::Curve || curvePointAt(m_at) > 0) return curveHint(true);
    if (m_gesture == Gesture::None && m_hovered < 0 && m_curve.isOnCurve(m_at)) return curveHint(false);
    if (m_gesture == Gesture::Drag)
        return said(QT_TRANSLATE_NOOP("PinTool", "Drag the pin; Esc puts the shape back"));
    if (m_hovered >= 0)
        return said(QT_TRANSLATE_NOOP("PinTool",
                                      "Drag to move the pin, Shift-click to select more, Delete to remove"));
    if (m_adds)
        return said(
            QT_TRANSLATE_NOOP("PinTool", "Click on the shape to set a pin, then drag pins to bend it"));
    return said(QT_TRANSLATE_NOOP(
        "PinTool", "Click or draw a rectangle to select pins, drag to move them, arrow keys nudge"));
}

QCursor PinTool::cursor() const {
    if (m_gesture == Gesture::Drag) return Qt::ClosedHandCursor;
    if (m_hovered >= 0) return Qt::OpenHandCursor;
    return m_adds ? Qt::CrossCursor : Qt::ArrowCursor;
}

/// The end of the curve lies under its pin, which comes first until that point is chosen.
int PinTool::curvePointAt(const QPointF& at) const {
    const int point = m_curve.pointAt(at);
    return point == m_curve.chosen() || handleAt(at) < 0 ? point : -1;
}

int PinTool::handleAt(const QPointF& widget) const {
    int best = -1;
    double nearest = kReach;
    for (const PinView<2>& pin : session().pins()) {
        std::vector<Vec<2>> spots = {pin.centre};
        if (!pin.region) spots.insert(spots.end(), pin.points.begin(), pin.points.end());
        for (const Vec<2>& spot : spots) {
            const double d = distance(surface().toWidget(spot), widget);
            if (d <= nearest) nearest = d, best = pin.handle;
        }
    }
    if (best >= 0) return best;
    nearest = kGhostReach;
    for (const PinView<2>& ghost : session().ghosts()) {
        const double d = distance(surface().toWidget(ghost.centre), widget);
        if (d <= nearest) nearest = d, best = ghost.handle;
    }
    return best;
}

void PinTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || m_gesture != Gesture::None) return;
    m_gesture = Gesture::Pressed;
    m_from = m_at = event.position();
    if (const int point = curvePointAt(m_from); point > 0) {
        m_gesture = Gesture::Curve;
        m_curve.begin(point, m_from);
        return;
    }
    m_pressed = handleAt(m_from);
    if (m_pressed < 0 && m_curve.isOnCurve(m_from)) m_gesture = Gesture::OnCurve;
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
    if (m_gesture == Gesture::None) hover(at);
    if (m_gesture == Gesture::OnCurve && distance(at, m_from) >= 3) m_gesture = Gesture::Pressed;
    if (m_gesture == Gesture::Curve) m_curve.drag(at, event.modifiers() & Qt::ControlModifier);
    if (m_gesture == Gesture::None && m_curve.hasCurve()) surface().redraw();
    if (m_gesture == Gesture::Pressed && distance(at, m_from) >= 3) begin(event);
    if (m_gesture == Gesture::Drag) session().dragTo<2>(surface().toShape(at) - surface().toShape(m_from));
    if (m_gesture == Gesture::Marquee) surface().setMarquee(QRectF(m_from, at).normalized());
}

void PinTool::begin(const QMouseEvent&) {
    const bool onPin = m_pressed >= 0 && session().selection().contains(m_pressed);
    m_gesture = onPin ? Gesture::Drag : Gesture::Marquee;
    if (onPin) session().beginDrag();
    if (onPin && !session().isDragging()) m_gesture = Gesture::None;
}

void PinTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    const bool extend = event.modifiers() & Qt::ShiftModifier;
    if (gesture == Gesture::Curve) m_curve.finish();
    if (gesture == Gesture::OnCurve) m_curve.choose(-1), surface().redraw();
    if (gesture == Gesture::Drag) {
        const double pixel = (surface().toShape({1, 0}) - surface().toShape({0, 0})).norm();
        session().endDrag(std::max(kStrokeDetail * pixel, kLeastDetail * session().pixel()));
    }
    if (gesture == Gesture::Marquee) {
        surface().setMarquee({});
        selectInside(QRectF(m_from, event.position()).normalized(), event.modifiers());
    }
    if (gesture == Gesture::Pressed && m_pressed < 0) {
        const int added = m_adds ? session().addPin(surface().toShape(event.position())) : -1;
        if (added < 0 && !extend) session().selection().clear();
    }
    hover(event.position());
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
        event.button() == Qt::LeftButton && curvePointAt(at) <= 0 && handleAt(at) < 0;  // pins come first
    if (!onCurve || !m_curve.insertAt(at)) press(event);
}

bool PinTool::ownsKey(const QKeyEvent& event) const {
    return event.key() == Qt::Key_Delete && !event.modifiers() && m_curve.chosen() > 0;
}

void PinTool::hover(const QPointF& at) {
    m_hovered = handleAt(at);
    surface().setHovered(m_hovered);
}

bool PinTool::nudge(const QKeyEvent& event) {
    Vec<2> by = Vec<2>::Zero();
    switch (event.key()) {
        case Qt::Key_Left:
            by = {-1, 0};
            break;
        case Qt::Key_Right:
            by = {1, 0};
            break;
        case Qt::Key_Up:
            by = {0, -1};
            break;
        case Qt::Key_Down:
            by = {0, 1};
            break;
        default:
            return false;
    }
    const double size = session().pixel() * (event.modifiers() & Qt::ShiftModifier ? 10 : 1);
    session().nudgeSelected<2>(size * by);
    return true;
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
    if (m_gesture != Gesture::None) return false;
    return nudge(event);
}

void PinTool::cancel() {
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    if (gesture == Gesture::Drag) session().cancelDrag();
    if (gesture == Gesture::Marquee) surface().setMarquee({});
    m_curve.cancel();
}

}  // namespace wend
