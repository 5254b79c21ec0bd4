#include "app/tools/pins/pin_ring.h"

#include <QCoreApplication>
#include <QLineF>
#include <cmath>

#include "app/style/colours.h"
#include "app/style/mark_size.h"

namespace wend {

namespace {

constexpr double kRadius = 44, kDot = 5, kSquare = 4;  // pixels
constexpr double kGripReach = 9, kRingReach = 5;
constexpr double kMinFactor = 0.05;
constexpr double kMiddle =
    16;  // pixels; nearer to the middle a direction means little, and a factor too much

}  // namespace

std::optional<PinRing::Part> PinRing::anywhere() const {
    return m_kind == Grip::Kind::Move ? std::nullopt : std::optional(Part{m_kind});
}

/// The dot starts at the upper right, the square at the lower right.
QPointF PinRing::spot(Grip::Kind kind, const QPointF& centre) const {
    const double angle = kind == Grip::Kind::Turn ? m_turned - std::numbers::pi / 4 : std::numbers::pi / 4;
    return centre + marked(kRadius) * QPointF(std::cos(angle), std::sin(angle));
}

std::optional<PinRing::Part> PinRing::partAt(const ShapeView& view, const QPointF& widget) const {
    const QPointF centre = view.onScreen(m_centre);
    for (const auto kind : {Grip::Kind::Turn, Grip::Kind::Grow})
        if (m_canTurn && QLineF(spot(kind, centre), widget).length() <= marked(kGripReach)) return Part{kind};
    return {};
}

bool PinRing::turnsPointAt(const ShapeView& view, const QPointF& widget) const {
    const double radius = QLineF(view.onScreen(m_centre), widget).length();
    return !m_canTurn && std::abs(radius - marked(kRadius)) <= marked(kRingReach);
}

QString PinRing::hint() const {
    return QCoreApplication::translate(
        "PinTool",
        "Drag the dot to rotate, Shift snaps to 15°, or the square to scale; digits set the number");
}

void PinRing::begin(const Part& part, const ShapeView& view, const QPointF& widget) {
    m_part = part;
    m_startPoint = acrossTheScreen(view, m_centre, widget);
    m_angle = m_turned = 0;
    m_lastAngle = angleAt(view, widget);
    const double radius = QLineF(view.onScreen(m_centre), widget).length();
    m_startDistance = std::max(radius, kMiddle);
    m_lead = m_startDistance - radius;
}

/// Returns the pointer's angle around the centre; nothing if it is too close.
std::optional<double> PinRing::angleAt(const ShapeView& view, const QPointF& widget) const {
    if (QLineF(view.onScreen(m_centre), widget).length() < kMiddle) return {};
    const Vec3 arm = acrossTheScreen(view, m_centre, widget) - m_centre;
    return std::atan2(arm.y(), arm.x());
}

Grip PinRing::grip(const ShapeView&) const {
    Grip grip;
    grip.kind = m_part.kind;
    if (grip.kind != Grip::Kind::Move) grip.centre = m_centre;
    return grip;
}

Amount PinRing::drag(const ShapeView& view, const QPointF& widget, bool snaps) {
    if (m_part.kind == Grip::Kind::Move) {
        m_way = acrossTheScreen(view, m_centre, widget) - m_startPoint;
        if (isAlongAxis()) m_way = Vec3(m_way[m_part.axis] * Vec3::Unit(m_part.axis));
        return m_way;
    }
    if (m_part.kind == Grip::Kind::Grow) {
        const double radius = QLineF(view.onScreen(m_centre), widget).length();
        return {std::max((radius + m_lead) / m_startDistance, kMinFactor) - 1, 0, 0};
    }
    if (const auto angle = angleAt(view, widget)) {
        m_angle += std::remainder(*angle - m_lastAngle.value_or(*angle), 2 * std::numbers::pi);
        m_lastAngle = angle;
    }
    m_turned = snaps ? kAngleStep * std::round(m_angle / kAngleStep) : m_angle;
    return {m_turned, 0, 0};
}

Amount PinRing::typed(double number, const ShapeView&) const {
    if (m_part.kind != Grip::Kind::Move) return turnedOrScaled(number);
    return number * (isAlongAxis() ? Vec3(Vec3::Unit(m_part.axis)) : m_way.normalized());
}

void PinRing::paintDragged(QPainter& painter, const ShapeView& view, const Amount&) const {
    if (m_part.kind != Grip::Kind::Move) paint(painter, view, m_part);
}

void PinRing::paint(QPainter& painter, const ShapeView& view, const std::optional<Part>& lit) const {
    const QColor accent(kAccent);
    const QPointF centre = view.onScreen(m_centre);
    const double radius = marked(kRadius);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(QColor(255, 255, 255, 200), 4.0), std::pair(accent, 2.0)}) {
        QPen pen(colour, marked(width), m_canTurn ? Qt::SolidLine : Qt::CustomDashLine, Qt::RoundCap);
        if (!m_canTurn) pen.setDashPattern({0.2 / width, 6 / width});
        painter.setPen(pen);
        painter.drawEllipse(centre, radius, radius);
    }
    if (!m_canTurn) {
        painter.setPen(QPen(Qt::white, marked(1.5)));
        painter.setBrush(accent);
        const QPointF dot = spot(Grip::Kind::Turn, centre);
        return painter.drawEllipse(dot, marked(kDot), marked(kDot));
    }
    const auto size = [&lit](Grip::Kind kind, double usual) {
        return marked(usual + (lit == Part{kind} ? 1.5 : 0));
    };
    painter.setPen(QPen(Qt::white, marked(1.5)));
    painter.setBrush(accent);
    const double dot = size(Grip::Kind::Turn, kDot), side = size(Grip::Kind::Grow, kSquare);
    painter.drawEllipse(spot(Grip::Kind::Turn, centre), dot, dot);
    painter.drawRect(
        QRectF(spot(Grip::Kind::Grow, centre) - QPointF(side, side), QSizeF(2 * side, 2 * side)));
}

}  // namespace wend
