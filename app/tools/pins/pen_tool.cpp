#include <QCoreApplication>
#include <QLineF>
#include <algorithm>
#include <memory>

#include "app/project/edits/bezier_edits.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/in_steps.h"
#include "app/tools/pins/pin_picking.h"
#include "app/tools/tool_kinds.h"

namespace wend {

namespace {

/// Draws the path of the selected pins, or of a clicked pin: a click adds a corner, a drag a smooth point.
/// Shift constrains both to steps of 45°; with Ctrl or Alt a drag changes only the direction after the point.
/// In space every point has the depth of the one before. The path is one undo step; other changes cancel it.
class PenTool : public ShapeTool<> {
  public:
    explicit PenTool(ShapeView& view) : ShapeTool<>(view) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    bool ownsKey(const QKeyEvent& event) const override;
    MenuPlace menuAt(const QPointF& at) override;
    void cancel() override;
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

    bool isDrawing() const;

  private:
    int pinAt(const QPointF& widget) const;
    bool begin(const QPointF& at);
    bool beginAt(const std::vector<int>& handles);
    Vec3 placeAt(const QPointF& widget) const;
    Vec3 nextPlace() const;
    QPointF last() const { return view().onScreen(m_joints.back().at); }
    void takePointer(const QMouseEvent& event);
    void pullDirections(bool oneOnly);
    bool isOnLast(const QPointF& widget) const;
    void finish();
    void removeLast();
    void paintJoints(QPainter& painter) const;

    std::vector<DrawnJoint> m_joints;     // the first one is where the pins are
    std::shared_ptr<const Project> m_of;  // the project of these pins …
    double m_time = 0;                    // … at that time
    bool m_pressed = false;               // the last joint's direction follows the pointer
    bool m_over = false;
    bool m_steps = false;  // constrains to 45°
    QPointF m_from, m_at;
};

constexpr double kPenReach = 9;   // pixels of the screen, of pins
constexpr double kSamePoint = 4;  // of the last point
constexpr double kArmDrag = 3;
constexpr int kPaintedSamples = 32;  // of a piece that is painted
const QColor kPathColour(0xd4, 0x7a, 0x1e);

bool takesBack(const QKeyEvent& event) {
    return event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete ||
           event.matches(QKeySequence::Undo);
}

bool ends(const QKeyEvent& event) {
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

QString PenTool::hint() const {
    if (isDrawing() && m_pressed)
        return QCoreApplication::translate(
            "PenTool", "Drag for a smooth point: Shift snaps to 45°, Ctrl or Alt moves this side only");
    if (isDrawing())
        return QCoreApplication::translate("PenTool",
                                           "Click for a corner, drag for a smooth point, Shift snaps to 45°; "
                                           "Enter ends, Backspace removes the last point, Esc cancels");
    if (session().selection().isEmpty())
        return QCoreApplication::translate("PenTool", "Click the pin whose path you want to draw");
    return QCoreApplication::translate(
        "PenTool", "Click where the selected pin should go, point by point; drag for a smooth point");
}

bool PenTool::isDrawing() const {
    return !m_joints.empty() && m_of == session().document().project() &&
           m_time == session().playback().time();
}

int PenTool::pinAt(const QPointF& widget) const {
    PinPick pick;
    for (const PinView& pin : session().gestures().pins())
        if (const double d = QLineF(view().onScreen(pin.centre), widget).length(); d <= marked(kPenReach))
            pick.offer(pin.handle, d, false);
    return pick.handle();
}

/// In space, projects on the plane through the last point that faces the viewer.
Vec3 PenTool::placeAt(const QPointF& widget) const {
    return acrossTheScreen(view(), m_joints.back().at, widget);
}

Vec3 PenTool::nextPlace() const {
    return placeAt(m_steps ? last() + inSteps(m_at - last()) : m_at);
}

bool PenTool::isOnLast(const QPointF& widget) const {
    return QLineF(last(), widget).length() <= marked(kSamePoint);
}

/// Begins a path at the pin under the pointer, or at the selected ones; returns false if there is none.
bool PenTool::begin(const QPointF& at) {
    m_joints.clear();
    if (const int pin = pinAt(at); pin >= 0) {
        session().selection().set({pin});
        if (!beginAt({pin})) return false;
        session().document().notify({});  // about a click outside all pins
        return true;
    }
    if (beginAt(session().selection().handles())) return true;
    if (session().selection().isEmpty()) session().document().notify(hint());
    return false;
}

/// Begins at the centre of the handles that act now.
bool PenTool::beginAt(const std::vector<int>& handles) {
    session().playback().setPlaying(false);
    std::vector<Vec3> centres;
    for (const PinView& pin : session().gestures().pins(true))
        if (std::count(handles.begin(), handles.end(), pin.handle)) centres.push_back(inSpace(pin.centre));
    const bool may =
        std::ranges::all_of(handles, [this](int h) { return session().gestures().mayChange(h); });
    if (centres.empty() || !may) return false;
    m_joints = {{meanOf(centres)}};
    m_of = session().document().project();
    m_time = session().playback().time();
    return true;
}

void PenTool::takePointer(const QMouseEvent& event) {
    m_at = event.position();
    m_steps = event.modifiers() & Qt::ShiftModifier;
    m_over = true;
}

/// Sets the directions from the length of the drag; Shift may have put the point beside the pointer.
void PenTool::pullDirections(bool oneOnly) {
    const QPointF way = m_at - m_from;
    DrawnJoint& joint = m_joints.back();
    joint.out = placeAt(last() + (m_steps ? inSteps(way) : way)) - joint.at;
    if (!oneOnly) joint.in = -joint.out;
}

void PenTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || m_pressed) return;
    takePointer(event);
    m_from = m_at;
    const bool goesOn = isDrawing();
    if (goesOn && isOnLast(m_at)) {
        finish();
    } else if (goesOn || begin(m_at)) {
        if (!isOnLast(m_at)) m_joints.push_back({nextPlace()});
        m_pressed = true;
    }
    view().redraw();
}

void PenTool::move(const QMouseEvent& event) {
    takePointer(event);
    if (m_pressed && isDrawing() && QLineF(m_at, m_from).length() >= kArmDrag)
        pullDirections(event.modifiers() & (Qt::AltModifier | Qt::ControlModifier));
    view().redraw();
}

void PenTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    m_pressed = false;
    view().redraw();
}

void PenTool::finish() {
    const auto joints = std::exchange(m_joints, {});
    m_pressed = false;
    if (joints.size() > 1) session().gestures().followCurve(bezierThrough(joints));
}

void PenTool::removeLast() {
    m_joints.pop_back();
    m_pressed = false;
    if (m_joints.size() < 2) m_joints.clear();
}

bool PenTool::ownsKey(const QKeyEvent& event) const {
    return isDrawing() && (ends(event) || takesBack(event));
}

bool PenTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape)
        isDrawing() ? cancel() : session().selection().clear();
    else if (ownsKey(event))
        ends(event) ? finish() : removeLast();
    else
        return false;
    view().redraw();
    return true;
}

MenuPlace PenTool::menuAt(const QPointF& at) {
    return isDrawing() ? MenuPlace::None : menuOfPin(session().selection(), pinAt(at));
}

void PenTool::cancel() {
    m_joints.clear();
    m_pressed = false;
}

/// Also draws what a click would add.
void PenTool::paint(QPainter& painter) const {
    if (!isDrawing()) return;
    auto joints = m_joints;
    if (!m_pressed && m_over && !isOnLast(m_at)) joints.push_back({nextPlace()});
    QPolygonF line;
    if (joints.size() > 1)
        for (const auto& piece : bezierCurve<3>(bezierThrough(joints)).pieces)
            for (int i = 0; i <= kPaintedSamples; ++i)
                line << view().onScreen(piece.value(double(i) / kPaintedSamples));
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen :
         {QPen(QColor(255, 255, 255, 216), marked(3.75)), QPen(kPathColour, marked(1.75))}) {
        painter.setPen(pen);
        painter.drawPolyline(line);
    }
    paintJoints(painter);
}

/// Squares, and the directions of the last one.
void PenTool::paintJoints(QPainter& painter) const {
    const DrawnJoint& last = m_joints.back();
    painter.setPen(QPen(kPathColour, marked(1.25)));
    painter.setBrush(kPathColour);
    for (const Vec3& way : {last.in, last.out}) {
        if (way.isZero()) continue;
        const QPointF end = view().onScreen(last.at + way);
        painter.drawLine(view().onScreen(last.at), end);
        painter.drawEllipse(end, marked(4), marked(4));
    }
    for (const auto& joint : m_joints) {
        const QPointF at = view().onScreen(joint.at);
        const bool isLast = &joint == &last;
        painter.setPen(QPen(isLast ? QColor(kAccent) : QColor(Qt::white), marked(isLast ? 2.25 : 1.25)));
        painter.setBrush(isLast ? QColor(Qt::white) : kPathColour);
        const double r = marked(4.5);
        painter.drawRect(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r));
    }
}

}  // namespace

ToolKind penTool() {
    return toolKind("pen", "pen", QT_TRANSLATE_NOOP("Tools", "Pe&n"),
                    QT_TRANSLATE_NOOP("Tools", "Draw the path of a pin, point by point"), "P", Mode::Animate,
                    both<PenTool>());
}

}  // namespace wend
