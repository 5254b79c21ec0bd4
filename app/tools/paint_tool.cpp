#include "app/tools/paint_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

#include "app/session/solid_places.h"
#include "core/mesh/segments.h"

namespace wend {

namespace {

constexpr double kSpacing = 0.6;       // of the radius
constexpr double kLargestBrush = 300;  // pixels

}  // namespace

QString PaintTool::hint() const {
    return QCoreApplication::translate(
        "PaintTool",
        "Paint the material chosen on the right; [ and ] change the size, Esc gives up the stroke");
}

/// A ball around the rest place of what is under the pointer, unless it is close to the one before.
void PaintTool::dab() {
    const SolidHit hit = surface().pick(m_at);
    const auto frame = session().frame<3>();
    if (hit.cell < 0 || !frame) return;
    Dab next{locationIn(*frame, hit.cell, hit.point), Vec<3>::Zero(),
             m_radius * surface().pixelSize(hit.point), Vec<3>::Zero()};
    next.rest = positionOf<3>(next.place, *frame->rest, frame->rest->points);
    // Directions of what is seen are carried back to rest.
    if (m_along == StiffAlong::View)
        next.axis = cellRotation(*frame, hit.cell).transpose() * surface().viewDirection();
    if (m_along == StiffAlong::Way) next.axis = cellRotation(*frame, hit.cell).transpose() * wayAt(hit.point);
    const bool near = std::any_of(m_dabs.begin(), m_dabs.end(), [&](const Dab& other) {
        return (other.rest - next.rest).norm() < kSpacing * next.radius;
    });
    if (!near) m_dabs.push_back(next);
}

/// The direction of the selected handle's way where it comes nearest; zero without one.
Vec<3> PaintTool::wayAt(const Vec<3>& p) const {
    const auto& selected = session().selection().handles();
    if (selected.size() != 1) return Vec<3>::Zero();
    const auto starts = session().pathStarts<3>(selected.front());
    if (starts.empty()) return Vec<3>::Zero();
    const auto& handle = session().document().design<3>().handles[selected.front()];
    const auto way = pinPaths<3>(handle, {meanOf<3>(starts)}).front().points;
    Vec<3> along = Vec<3>::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double d = distanceToSegment<3>(p, way[i - 1], way[i]);
        if (d < nearest && way[i] != way[i - 1]) nearest = d, along = (way[i] - way[i - 1]).normalized();
    }
    return along;
}

/// Along the stroke: from the dab before to the one behind, at rest.
std::vector<Vec<3>> PaintTool::axes() const {
    std::vector<Vec<3>> axes;
    for (std::size_t i = 0; i < m_dabs.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, behind = std::min(i + 1, m_dabs.size() - 1);
        axes.push_back(m_along == StiffAlong::Stroke ? Vec<3>(m_dabs[behind].rest - m_dabs[before].rest)
                                                     : m_dabs[i].axis);
    }
    return axes;
}

void PaintTool::press(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    m_active = true;
    m_dabs.clear();
    dab();
    surface().redraw();
}

void PaintTool::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (m_active) dab();
    surface().redraw();
}

void PaintTool::release(const QMouseEvent&) {
    if (!std::exchange(m_active, false) || m_dabs.empty()) return;
    std::vector<Ball<3>> balls;
    balls.reserve(m_dabs.size());
    for (const Dab& one : m_dabs) balls.push_back({one.rest, one.radius});
    const auto along = axes();
    m_dabs.clear();
    const bool lost = m_paint.stiffness && m_along != StiffAlong::Axis &&
                      std::all_of(along.begin(), along.end(), [](const Vec<3>& a) { return a.isZero(); });
    if (lost)
        emit session().notice(QCoreApplication::translate(
            "PaintTool", "There is no direction to follow: the numbers on the right were taken."));
    Document& document = session().document();
    document.change(QCoreApplication::translate("PaintTool", "Paint material"),
                    withPaint(*document.project(), balls, m_paint, along));
}

bool PaintTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape && m_active) {
        cancel();
        surface().redraw();
        return true;
    }
    const auto radius = brushAfter(event, m_radius, kLargestBrush);
    if (!radius) return false;
    m_radius = *radius;
    surface().redraw();
    return true;
}

void PaintTool::cancel() {
    m_active = false;
    m_dabs.clear();
}

void PaintTool::paint(QPainter& painter) const {
    const QColor colour(0xd4, 0x7a, 0x1e);
    QColor fill = colour;
    fill.setAlpha(60);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    if (m_over || m_active) painter.drawEllipse(m_at, m_radius, m_radius);
    const auto frame = session().frame<3>();
    if (!frame) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const Dab& one : m_dabs) {
        const Vec<3> p = positionOf<3>(one.place, *frame->rest, frame->pose);
        const double r = one.radius / surface().pixelSize(p);
        painter.drawEllipse(surface().toWidget(p), r, r);
    }
}

}  // namespace wend
