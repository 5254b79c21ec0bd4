#include "app/tools/pin_ring.h"

#include <QLocale>
#include <cmath>
#include <numbers>

#include "app/session/accent.h"
#include "app/session/mark_size.h"

namespace wend {

namespace {

constexpr double kRadius = 44, kDot = 5, kSquare = 4;  // pixels
constexpr double kReach = 9, kRingReach = 5;
constexpr double kSnap = std::numbers::pi / 12;
constexpr double kMinFactor = 0.05;
constexpr double kMiddle =
    16;  // pixels; nearer to the middle a direction means little, and a factor too much

double distance(const QPointF& a, const QPointF& b) {
    return QLineF(a, b).length();
}

}  // namespace

void PinRing::place(const QPointF& widget, const Vec<2>& shape, bool canTurn) {
    m_at = widget;
    m_centre = shape;
    m_canTurn = canTurn;
    m_turned = 0;
}

/// The dot is at the upper right at rest, the square at the lower right.
QPointF PinRing::spot(Part part) const {
    const double angle = part == Part::Rotate ? m_turned - std::numbers::pi / 4 : std::numbers::pi / 4;
    return m_at + marked(kRadius) * QPointF(std::cos(angle), std::sin(angle));
}

std::optional<PinRing::Part> PinRing::partAt(const QPointF& widget) const {
    for (const Part part : {Part::Rotate, Part::Scale})
        if (m_canTurn && distance(spot(part), widget) <= marked(kReach)) return part;
    return {};
}

bool PinRing::isOn(const QPointF& widget) const {
    return std::abs(distance(m_at, widget) - marked(kRadius)) <= marked(kRingReach);
}

void PinRing::begin(Part part, const QPointF& widget, const ToShape& toShape) {
    m_part = part;
    m_angle = m_turned = 0;
    m_lastAngle = angleAt(widget, toShape);
    m_startDistance = std::max(distance(m_at, widget), kMiddle);
    m_lead = m_startDistance - distance(m_at, widget);
}

/// Of the pointer around the middle; nothing where it is too near.
std::optional<double> PinRing::angleAt(const QPointF& widget, const ToShape& toShape) const {
    if (distance(m_at, widget) < kMiddle) return {};
    const Vec<2> arm = toShape(widget) - m_centre;
    return std::atan2(arm.y(), arm.x());
}

Grip PinRing::grip() const {
    Grip grip;
    grip.kind = m_part == Part::Rotate ? Grip::Kind::Turn : Grip::Kind::Grow;
    grip.centre.head<2>() = m_centre;
    return grip;
}

Amount PinRing::drag(const QPointF& widget, const ToShape& toShape, bool snaps) {
    if (m_part == Part::Scale) {
        const double factor = std::max((distance(m_at, widget) + m_lead) / m_startDistance, kMinFactor);
        return {factor - 1, 0, 0};
    }
    if (const auto angle = angleAt(widget, toShape)) {
        m_angle += std::remainder(*angle - m_lastAngle.value_or(*angle), 2 * std::numbers::pi);
        m_lastAngle = angle;
    }
    m_turned = snaps ? kSnap * std::round(m_angle / kSnap) : m_angle;
    return {m_turned, 0, 0};
}

Amount PinRing::typed(double number) const {
    if (m_part == Part::Rotate) return {number * std::numbers::pi / 180, 0, 0};
    return {std::max(number, kMinFactor) - 1, 0, 0};
}

QString PinRing::text(const Amount& amount) const {
    const QLocale locale;
    if (m_part == Part::Scale) return QStringLiteral("×") + locale.toString(1 + amount[0], 'f', 2);
    return locale.toString(amount[0] * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°");
}

void PinRing::paint(QPainter& painter, const std::optional<Part>& lit) const {
    const QColor accent(kAccent);
    const double radius = marked(kRadius);
    QPen pen(accent, marked(2), m_canTurn ? Qt::SolidLine : Qt::CustomDashLine, Qt::RoundCap);
    if (!m_canTurn) pen.setDashPattern({0.1, 3});
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, m_canTurn ? 200 : 130), marked(4)));
    if (m_canTurn) painter.drawEllipse(m_at, radius, radius);
    painter.setPen(pen);
    painter.drawEllipse(m_at, radius, radius);
    if (!m_canTurn) return;
    painter.setPen(QPen(Qt::white, marked(1.5)));
    painter.setBrush(accent);
    const double dot = marked(kDot + (lit == Part::Rotate ? 1.5 : 0));
    painter.drawEllipse(spot(Part::Rotate), dot, dot);
    const double side = marked(kSquare + (lit == Part::Scale ? 1.5 : 0));
    const QPointF corner = spot(Part::Scale);
    painter.drawRect(QRectF(corner.x() - side, corner.y() - side, 2 * side, 2 * side));
}

}  // namespace wend
