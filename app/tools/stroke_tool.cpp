#include "app/tools/stroke_tool.h"

#include <algorithm>

#include "app/session/solid_places.h"

namespace wend {

namespace {

constexpr double kSpacing = 0.6;       // of the radius
constexpr double kLargestBrush = 300;  // pixels

}  // namespace

/// A ball around the rest place of what is under the pointer, unless it is close to the one before.
void StrokeTool::dab() {
    const SolidHit hit = surface().pick(m_at);
    const auto frame = session().frame<3>();
    if (hit.cell < 0 || !frame) return;
    Dab next{locationIn(*frame, hit.cell, hit.point), Vec<3>::Zero(),
             m_radius * surface().pixelSize(hit.point), axisAt(*frame, hit)};
    next.rest = positionOf<3>(next.place, *frame->rest, frame->rest->points);
    const bool near = std::any_of(m_dabs.begin(), m_dabs.end(), [&](const Dab& other) {
        return (other.rest - next.rest).norm() < kSpacing * next.radius;
    });
    if (!near) m_dabs.push_back(next);
}

std::vector<Ball<3>> StrokeTool::ballsOf(const std::vector<Dab>& dabs) {
    std::vector<Ball<3>> balls;
    balls.reserve(dabs.size());
    for (const Dab& one : dabs) balls.push_back({one.rest, one.radius});
    return balls;
}

void StrokeTool::press(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    m_active = true;
    m_dabs.clear();
    dab();
    surface().redraw();
}

void StrokeTool::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (m_active) dab();
    surface().redraw();
}

void StrokeTool::release(const QMouseEvent& event) {
    if (!std::exchange(m_active, false) || m_dabs.empty()) return;
    take(std::exchange(m_dabs, {}), event.modifiers());
}

bool StrokeTool::key(const QKeyEvent& event) {
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

void StrokeTool::cancel() {
    m_active = false;
    m_dabs.clear();
}

void StrokeTool::paint(QPainter& painter) const {
    QColor fill = m_colour;
    fill.setAlpha(60);
    painter.setPen(QPen(m_colour, 1.5));
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
