#include "app/tools/gizmos.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "app/style/colours.h"
#include "app/style/marks.h"

namespace wend {

namespace {

constexpr double kRadius = 44, kDot = 5, kSquare = 4;  // pixels
constexpr double kGripReach = 9, kRingReach = 5;
constexpr double kMinFactor = 0.05;
constexpr double kMiddle =
    16;  // pixels; nearer to the middle a direction means little, and a factor too much

constexpr double kArrow = 86, kRing = 68, kPlaneNear = 22, kPlaneFar = 40;  // pixels
constexpr double kAxisReach = 7;
constexpr int kRotationPieces = 72;
// Told apart by lightness too; the usual order x, y, z.
const QColor kAxisColours[] = {QColor(214, 69, 65), QColor(72, 148, 60), QColor(58, 104, 214)};
const QColor kFree(235, 238, 245), kLit(250, 190, 40);

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF ab = b - a;
    const double squared = QPointF::dotProduct(ab, ab);
    const double t = squared > 0 ? std::clamp(QPointF::dotProduct(p - a, ab) / squared, 0.0, 1.0) : 0.0;
    return QLineF(p, a + t * ab).length();
}

QPolygonF projected(const std::vector<Vec3>& line, const ShapeView& view) {
    QPolygonF polygon;
    for (const Vec3& p : line) polygon << view.onScreen(p);
    return polygon;
}

/// Returns the point of the line nearest to the ray.
Vec3 nearestOnLine(const Vec3& centre, const Vec3& along, const Ray& ray) {
    const double cosine = along.dot(ray.direction), sine2 = std::max(1 - cosine * cosine, 1e-6);
    const Vec3 offset = ray.origin - centre;
    return centre + (offset.dot(along) - cosine * offset.dot(ray.direction)) / sine2 * along;
}

Vec3 onPlane(const Vec3& centre, const Vec3& normal, const Ray& ray) {
    double slope = normal.dot(ray.direction);
    if (std::abs(slope) < 0.02) slope = std::copysign(0.02, slope);
    return ray.origin + normal.dot(centre - ray.origin) / slope * ray.direction;
}

std::pair<Vec3, Vec3> across(const Vec3& normal) {
    const Vec3 u = normal.unitOrthogonal();
    return {u, normal.cross(u)};
}

}  // namespace

std::optional<PinRing::Part> PinRing::anywhere() const {
    return m_kind == Grip::Kind::Move ? std::nullopt : std::optional(Part{m_kind});
}

/// Returns the place of a knob: the dot starts at the upper right, the square at the lower right.
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

void Manipulator::setGrip(Grip::Kind kind) {
    m_mode = kind == Grip::Kind::Turn ? Mode::Turn : kind == Grip::Kind::Grow ? Mode::Grow : Mode::Move;
}

void Manipulator::place(const Vec3& centre, const Mat3& axes) {
    m_centre = centre;
    m_axes = axes;
}

QString Manipulator::hint() const {
    return QCoreApplication::translate("PinTool",
                                       "Drag an arrow, a square or a ring; G moves, R rotates, S scales");
}

double Manipulator::length(const ShapeView& view) const {
    return marked(view.pixelSize(m_centre));
}

Vec3 Manipulator::normalOf(const Part& part, const ShapeView& view) const {
    return part.axis >= 0 ? axis(part.axis) : Vec3(-view.viewDirection());
}

std::vector<Manipulator::Part> Manipulator::parts() const {
    using Kind = Grip::Kind;
    switch (m_mode) {
        case Mode::Move:
            return {{Kind::Move, 0},       {Kind::Move, 1},       {Kind::Move, 2}, {Kind::Move, 0, true},
                    {Kind::Move, 1, true}, {Kind::Move, 2, true}, {Kind::Move, -1}};
        case Mode::Turn:
            return {{Kind::Turn, 0}, {Kind::Turn, 1}, {Kind::Turn, 2}, {Kind::Turn, -1}};
        case Mode::Grow:
            return {{Kind::Grow, -1}};
        case Mode::Tilt:
            break;
    }
    return {{Kind::Move, 2}, {Kind::Turn, 0}, {Kind::Turn, 1}};
}

/// Returns the line that is drawn and can be dragged.
std::vector<Vec3> Manipulator::outline(const Part& part, const ShapeView& view) const {
    const double pixel = length(view);
    if (part.kind == Grip::Kind::Move && part.plane) {
        const Vec3 u = pixel * axis((part.axis + 1) % 3), v = pixel * axis((part.axis + 2) % 3);
        const Vec3 a = m_centre + kPlaneNear * (u + v), b = kPlaneFar * u - kPlaneNear * u,
                   c = kPlaneFar * v - kPlaneNear * v;
        return {a, a + b, a + b + c, a + c, a};
    }
    if (part.kind == Grip::Kind::Move && part.axis >= 0)
        return {m_centre + 10 * pixel * axis(part.axis), m_centre + kArrow * pixel * axis(part.axis)};
    double radius = kRing;
    if (part.kind == Grip::Kind::Move) radius = 8;
    if (part.kind == Grip::Kind::Turn && part.axis < 0) radius = kArrow;
    const auto [u, v] = across(normalOf(part, view));
    std::vector<Vec3> ring;
    for (int i = 0; i <= kRotationPieces; ++i) {
        const double a = 2 * std::numbers::pi * i / kRotationPieces;
        ring.push_back(m_centre + radius * pixel * (std::cos(a) * u + std::sin(a) * v));
    }
    return ring;
}

std::optional<Manipulator::Part> Manipulator::partAt(const ShapeView& view, const QPointF& widget) const {
    std::optional<Part> best;
    double nearest = marked(kAxisReach);
    for (const Part& part : parts()) {
        const QPolygonF line = projected(outline(part, view), view);
        double distance = 1e9;
        const bool filled = part.plane || (part.kind == Grip::Kind::Move && part.axis < 0);
        if (filled && line.containsPoint(widget, Qt::OddEvenFill)) distance = 0;
        for (int i = 1; i < line.size(); ++i)
            distance = std::min(distance, distanceToSegment(widget, line[i - 1], line[i]));
        if (distance < nearest) nearest = distance, best = part;
    }
    return best;
}

/// Returns the point of the part's line or plane under the pointer.
Vec3 Manipulator::pointAt(const ShapeView& view, const QPointF& widget) const {
    const Ray ray = view.ray(widget);
    if (isAlongAxis()) return nearestOnLine(m_centre, axis(m_part.axis), ray);
    return onPlane(m_centre, normalOf(m_part, view), ray);
}

/// Returns the angle around the axis; for a ring seen edge-on, the pointer's movement along it.
double Manipulator::angleAt(const ShapeView& view, const QPointF& widget) const {
    const Vec3 normal = normalOf(m_part, view);
    if (std::abs(normal.dot(view.viewDirection())) < 0.15) {
        const Vec3 along = normal.cross(view.viewDirection()).normalized();
        const Vec3 p = onPlane(m_centre, view.viewDirection(), view.ray(widget));
        return -along.dot(p - m_centre) / (kRing * length(view));
    }
    const auto [u, v] = across(normal);
    const Vec3 arm = onPlane(m_centre, normal, view.ray(widget)) - m_centre;
    return std::atan2(v.dot(arm), u.dot(arm));
}

double Manipulator::distanceAt(const ShapeView& view, const QPointF& widget) const {
    return std::max(QLineF(view.onScreen(m_centre), widget).length(), 12.0);
}

void Manipulator::begin(const Part& part, const ShapeView& view, const QPointF& widget) {
    m_part = part;
    m_angle = 0;
    m_startPoint = pointAt(view, widget);
    m_lastAngle = angleAt(view, widget);
    m_startDistance = distanceAt(view, widget);
}

Amount Manipulator::drag(const ShapeView& view, const QPointF& widget, bool snaps) {
    switch (m_part.kind) {
        case Grip::Kind::Turn: {
            const double angle = angleAt(view, widget);
            m_angle += std::remainder(angle - m_lastAngle, 2 * std::numbers::pi);
            m_lastAngle = angle;
            return {snaps ? kAngleStep * std::round(m_angle / kAngleStep) : m_angle, 0, 0};
        }
        case Grip::Kind::Grow:
            return {distanceAt(view, widget) / m_startDistance - 1, 0, 0};
        case Grip::Kind::Move:
            break;
    }
    const Vec3 way = pointAt(view, widget) - m_startPoint;
    return snaps && m_part.plane ? alongOneAxis(way) : way;
}

/// Projects on the axis of the plane that is closer to the displacement.
Vec3 Manipulator::alongOneAxis(const Vec3& way) const {
    const Vec3 u = axis((m_part.axis + 1) % 3), v = axis((m_part.axis + 2) % 3);
    const double byU = way.dot(u), byV = way.dot(v);
    return std::abs(byU) > std::abs(byV) ? byU * u : byV * v;
}

Grip Manipulator::grip(const ShapeView& view) const {
    return {m_part.kind, m_centre, normalOf(m_part, view)};
}

Amount Manipulator::typed(double number, const ShapeView& view) const {
    if (m_part.kind != Grip::Kind::Move) return turnedOrScaled(number);
    return number * (isAlongAxis() ? axis(m_part.axis) : view.viewDirection().unitOrthogonal());
}

void Manipulator::paintDragged(QPainter& painter, const ShapeView& view, const Amount& amount) const {
    Manipulator moved = *this;
    if (m_part.kind == Grip::Kind::Move) moved.m_centre += amount;
    moved.paint(painter, view, m_part);
}

void Manipulator::paint(QPainter& painter, const ShapeView& view, const std::optional<Part>& lit) const {
    for (const Part& part : parts()) {
        const QPolygonF line = projected(outline(part, view), view);
        QColor colour = part.axis < 0 ? kFree : kAxisColours[part.axis];
        if (lit == part) colour = kLit;
        painter.setBrush(Qt::NoBrush);
        if (part.plane || (part.kind == Grip::Kind::Move && part.axis < 0)) {
            QColor fill = colour;
            fill.setAlpha(lit == part ? 200 : 130);
            painter.setBrush(fill);
        }
        painter.setPen(
            QPen(QColor(15, 17, 24, 150), marked(part.plane ? 2 : 4.5), Qt::SolidLine, Qt::RoundCap));
        painter.drawPolyline(line);
        const bool isDotted = !m_canTurn && part.kind != Grip::Kind::Move;
        painter.setPen(
            QPen(colour, marked(part.plane ? 1 : 2.5), isDotted ? Qt::DotLine : Qt::SolidLine, Qt::RoundCap));
        part.plane || part.axis < 0 ? painter.drawPolygon(line) : painter.drawPolyline(line);
        if (part.kind != Grip::Kind::Move || part.axis < 0 || part.plane) continue;
        const QPointF tip = line.last(), along = tip - line.first();
        const double size = std::hypot(along.x(), along.y());
        if (size < 4) continue;  // seen from its end
        const QPointF u = along / size, n(-u.y(), u.x());
        painter.setPen(QPen(QColor(15, 17, 24, 150), marked(1)));
        painter.setBrush(colour);
        painter.drawPolygon(QPolygonF({tip + marked(11) * u, tip + marked(5.5) * n, tip - marked(5.5) * n}));
    }
}

}  // namespace wend
