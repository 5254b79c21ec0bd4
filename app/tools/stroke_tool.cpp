#include "app/tools/stroke_tool.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/style/marks.h"
#include "app/tools/drag_label.h"

namespace wend {

namespace {

constexpr double kDabSpacing = 0.3;  // of the radius
constexpr double kMostSteps = 8000;  // between two places of the pointer
constexpr double kHardnessStep = 0.1;
constexpr double kStrokeStart = 3;    // pixels of the screen
constexpr double kHardnessWay = 200;  // pixels from wholly soft to wholly hard
constexpr double kFace = 3;           // pixels between samples of the surface normal
constexpr double kSteepest = 5;       // times as long as on the screen; more is an edge
constexpr int kRingParts = 72;

QChar textOf(const QKeyEvent& key) {
    return key.text().isEmpty() ? QChar() : key.text().front();
}

}  // namespace

Ball<3> StrokeTool::ballOf(const Dab& dab) const {
    return {dab.rest, dab.radius * (1 + m_brush.now().hardness) / 2};
}

double StrokeTool::featherOf(const Dab& dab) const {
    return dab.radius * (1 - m_brush.now().hardness);
}

std::string StrokeTool::partOf(const Dab& dab) const {
    return frame()->partOf(dab.place.cell);
}

/// Adds a ball around the rest place, unless it is close to an earlier one; the last one takes the pen's
/// strongest pressure. Returns false if nothing changed.
bool StrokeTool::dab(const QPointF& at, double pressure) {
    const FramePtr frame = this->frame();
    const auto touch = view().touch(at);
    if (!frame || !touch) return false;
    if (!m_dabs.empty() && frame->partOf(touch->place.cell) != partOf(m_dabs.front())) return false;
    Dab next{touch->place, frame->restAt(touch->place), m_brush.now().radius * view().pixelSize(touch->point),
             axisAt(*frame, *touch), pressure};
    const auto near = std::find_if(m_dabs.rbegin(), m_dabs.rend(), [&](const Dab& other) {
        return (other.rest - next.rest).norm() < kDabSpacing * next.radius;
    });
    const bool isNew = near == m_dabs.rend();
    const bool presses = !isNew && near == m_dabs.rbegin() && near->pressure < pressure;
    if (presses) near->pressure = pressure;
    if (isNew) m_dabs.push_back(next);
    return isNew || presses;
}

/// Interpolates between pointer events, so that strokes have no gaps. A line from a place far outside an
/// enlarged view may be millions of pixels long: it gets at most as many dabs as one across a large screen.
void StrokeTool::dabsTo(const QPointF& at) {
    const FramePtr frame = this->frame();
    if (!frame || frame->shape != m_mesh) {
        cancel();
        return;
    }
    bool grown = false;
    const double leap = QLineF(m_last, at).length(), pressure = view().pressure();
    const double wanted = leap / (0.5 * kDabSpacing * m_brush.now().radius);
    const int steps = std::max(1, static_cast<int>(std::min(kMostSteps, wanted)));
    for (int i = 1; i <= steps; ++i) {
        const double part = double(i) / steps;
        grown =
            dab(m_last + (at - m_last) * part, m_lastPressure + (pressure - m_lastPressure) * part) || grown;
    }
    m_last = at;
    m_lastPressure = pressure;
    if (grown) follow(m_dabs);
}

QString StrokeTool::hint() const {
    return m_tuning ? QCoreApplication::translate("StrokeTool",
                                                  "To the right: larger; up: harder. Esc leaves it as it was")
                    : strokeHint();
}

bool StrokeTool::takesButton(const QMouseEvent& event) const {
    return event.button() == Qt::RightButton && (event.modifiers() & Qt::AltModifier) && !m_active;
}

void StrokeTool::setTip(double radius, double hardness) {
    BrushSettings next = m_brush.now();
    next.radius = radius;
    next.hardness = hardness;
    m_brush.set(next);
}

/// Adjusts size and hardness so that the rim follows the pointer.
void StrokeTool::tune(const QPointF& at) {
    const QPointF way = at - m_tuning->from;
    setTip(m_tuning->radius + way.x(), m_tuning->hardness - way.y() / kHardnessWay);
}

void StrokeTool::press(const QMouseEvent& event) {
    m_cross.hide();
    if (takesButton(event)) {
        m_at = event.position();
        m_over = true;
        m_tuning = {m_brush.now().radius, m_brush.now().hardness, m_at};
        view().redraw();
        return;
    }
    const FramePtr frame = this->frame();
    if (m_tuning || event.button() != Qt::LeftButton || !frame) return;
    m_at = event.position();
    m_over = m_active = true;
    m_modifiers = event.modifiers();
    m_mesh = frame->shape;
    m_dabs.clear();
    m_last = m_at;
    m_lastPressure = view().pressure();
    m_waits = (m_modifiers & Qt::ShiftModifier) && lineStart();
    if (!m_waits) start(m_at);
    view().redraw();
}

void StrokeTool::start(const QPointF& at) {
    if (!frame()) return cancel();
    m_waits = false;
    begin();
    dabsTo(at);
}

void StrokeTool::move(const QMouseEvent& event) {
    m_cross.hide();
    if (m_tuning) {  // the brush stays where it was pressed
        tune(event.position());
        view().redraw();
        return;
    }
    m_at = event.position();
    m_over = true;
    if (m_active && m_waits && QLineF(m_last, m_at).length() >= kStrokeStart) start(m_last);
    if (m_active && !m_waits)
        dabsTo(m_at);
    else if (!m_active)
        m_modifiers = event.modifiers();
    view().redraw();
}

void StrokeTool::release(const QMouseEvent& event) {
    if (event.button() == Qt::RightButton && std::exchange(m_tuning, std::nullopt)) view().redraw();
    if (event.button() != Qt::LeftButton || !m_active) return;
    if (m_waits) drawLine();
    if (!std::exchange(m_active, false) || m_dabs.empty()) return;
    m_end = m_dabs.back().place;
    const FramePtr frame = this->frame();
    m_endShape = frame ? frame->shape : nullptr;
    take(std::exchange(m_dabs, {}));
    view().redraw();
}

/// Returns the start of a straight line on the screen; nothing if the last stroke was on another mesh.
std::optional<QPointF> StrokeTool::lineStart() const {
    const FramePtr frame = this->frame();
    if (!drawsLines() || !m_end || !frame || frame->shape != m_endShape) return {};
    return view().onScreen(frame->at(*m_end));
}

void StrokeTool::drawLine() {
    const auto from = lineStart();
    if (!from) return cancel();
    const QPointF to = std::exchange(m_last, *from);
    m_modifiers &= ~Qt::ShiftModifier;
    m_waits = false;
    begin();
    dabsTo(m_last);
    dabsTo(to);
}

bool StrokeTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape && (m_active || m_tuning)) {
        cancel();
        view().redraw();
        return true;
    }
    if (!m_active && !m_tuning && m_cross.clicks(event, view(), *this)) return true;
    BrushSettings next = m_brush.now();
    const QChar text = textOf(event);
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    const bool down = text == '[' || text == '{', up = text == ']' || text == '}';
    if (!up && !down) return false;
    m_tuning.reset();
    if (shift || text == '{' || text == '}')
        next.hardness += up ? kHardnessStep : -kHardnessStep;
    else
        next.radius *= up ? 1.25 : 0.8;
    m_brush.set(next);
    view().redraw();
    return true;
}

void StrokeTool::cancel() {
    if (const auto before = std::exchange(m_tuning, std::nullopt)) setTip(before->radius, before->hardness);
    if (std::exchange(m_active, false)) view().showMaterial(nullptr);
    m_waits = false;
    m_dabs.clear();
}

/// Draws circles around touched places.
void StrokeTool::paintStroke(QPainter& painter, const std::vector<Dab>& dabs) const {
    const FramePtr frame = this->frame();
    if (!frame) return;
    QColor fill = colour();
    fill.setAlpha(60);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const Dab& one : dabs) {
        const Vec3 p = frame->at(one.place);
        const double r = ballOf(one).radius / view().pixelSize(p);
        painter.drawEllipse(view().onScreen(p), r, r);
    }
}

/// Draws the line that a Shift-click would add.
void StrokeTool::paintLine(QPainter& painter) const {
    const auto from = lineStart();
    if (!from || !(m_modifiers & Qt::ShiftModifier) || (m_active && !m_waits)) return;
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen :
         {QPen(QColor(255, 255, 255, 217), marked(3.5)), QPen(colour(), marked(1.5), Qt::DashLine)}) {
        painter.setPen(pen);
        painter.drawLine(*from, m_at);
    }
}

/// Size and hardness in numbers, as the panel has them.
void StrokeTool::paintTuning(QPainter& painter) const {
    if (!m_tuning) return;
    const QLocale locale;
    paintLabel(painter, m_at + QPointF(14, 14),
               QCoreApplication::translate("StrokeTool", "%1 px · %2 % hard")
                   .arg(locale.toString(2 * m_brush.now().radius, 'f', 0),
                        locale.toString(100 * m_brush.now().hardness, 'f', 0)));
}

/// Returns two tangents of equal length and the place on the surface under the pointer; nothing outside it,
/// or if a few pixels away another part is visible.
std::optional<Mat3> StrokeTool::facing(const QPointF& at) const {
    if (view().dimension() == 2) return {};
    const auto middle = view().touch(at), right = view().touch(at + QPointF(kFace, 0)),
               below = view().touch(at + QPointF(0, kFace));
    if (!middle || !right || !below) return {};
    const Vec3 u = right->point - middle->point, v = below->point - middle->point;
    const Vec3 normal = u.cross(v).normalized();
    const double most = kSteepest * kFace * view().pixelSize(middle->point);
    if (!normal.allFinite() || normal.isZero() || u.norm() > most || v.norm() > most) return {};
    Mat3 face;
    face << u.normalized(), normal.cross(u.normalized()), middle->point;
    return face;
}

/// Returns the ring of that radius in pixels, on the surface of a solid or on the screen.
QPainterPath StrokeTool::ringAt(const QPointF& at, double radius) const {
    QPainterPath ring;
    const auto face = facing(at);
    if (!face) {
        ring.addEllipse(at, radius, radius);
        return ring;
    }
    const Vec3 middle = face->col(2);
    const double length = radius * view().pixelSize(middle);
    QPolygonF line;
    for (int i = 0; i <= kRingParts; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingParts;
        line << view().onScreen(middle +
                                length * (std::cos(angle) * face->col(0) + std::sin(angle) * face->col(1)));
    }
    ring.addPolygon(line);
    return ring;
}

/// Draws the brush: its rim, its hard core and its effect.
void StrokeTool::paint(QPainter& painter) const {
    paintStroke(painter, m_dabs);
    m_cross.paint(painter);
    if (!m_over && !m_active) return;
    paintLine(painter);
    const double radius = m_brush.now().radius, hard = m_brush.now().hardness * radius;
    const auto ring = [&](double r, const QPen& pen) {
        painter.setPen(pen);
        painter.drawPath(ringAt(m_at, r));
    };
    painter.setBrush(Qt::NoBrush);
    ring(radius, QPen(QColor(255, 255, 255, 217), marked(3.5)));
    ring(radius, QPen(colour(), marked(1.75)));
    if (hard > 3 && hard < radius - 3) {
        ring(hard, QPen(QColor(255, 255, 255, 150), marked(2)));
        ring(hard, QPen(QColor(0x14, 0x16, 0x1e, 190), marked(1), Qt::DashLine));
    }
    const QString sign = takesAway()                       ? QStringLiteral("−")
                         : m_modifiers & Qt::ShiftModifier ? QStringLiteral("~")
                                                           : QString();
    painter.setPen(QColor(0x14, 0x16, 0x1e));
    enlarged(painter, m_at, [&] { painter.drawText(QRectF(-10, -10, 20, 20), Qt::AlignCenter, sign); });
    paintTuning(painter);
}

}  // namespace wend
