#include "app/tools/paint_tool.h"

#include <QCoreApplication>
#include <algorithm>

namespace wend {

namespace {

constexpr double kSpacing = 0.6;  // of the radius

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
    if (hit.vertex < 0 || !frame) return;
    const Dab next{hit.vertex, frame->rest->points.col(hit.vertex),
                   m_radius * surface().pixelSize(hit.point)};
    const bool near = std::any_of(m_dabs.begin(), m_dabs.end(), [&](const Dab& other) {
        return (other.rest - next.rest).norm() < kSpacing * next.radius;
    });
    if (!near) m_dabs.push_back(next);
}

void PaintTool::press(const QMouseEvent& event) {
    m_at = event.position();
    m_active = true;
    m_dabs.clear();
    dab();
    surface().redraw();
}

void PaintTool::move(const QMouseEvent& event) {
    m_at = event.position();
    if (m_active) dab();
    surface().redraw();
}

void PaintTool::release(const QMouseEvent&) {
    if (!std::exchange(m_active, false) || m_dabs.empty()) return;
    std::vector<Ball<3>> balls;
    balls.reserve(m_dabs.size());
    for (const Dab& one : m_dabs) balls.push_back({one.rest, one.radius});
    m_dabs.clear();
    Document& document = session().document();
    document.change(QCoreApplication::translate("PaintTool", "Paint material"),
                    withPaint(*document.project(), balls, m_paint));
}

bool PaintTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape && m_active) {
        cancel();
        surface().redraw();
        return true;
    }
    const double factor = event.text() == "[" ? 0.8 : event.text() == "]" ? 1.25 : 1;
    if (factor == 1) return false;
    m_radius = std::clamp(m_radius * factor, 4.0, 300.0);
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
    painter.drawEllipse(m_at, m_radius, m_radius);
    const auto frame = session().frame<3>();
    if (!frame) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const Dab& one : m_dabs) {
        const Vec<3> p = frame->pose.col(one.vertex);
        const double r = one.radius / surface().pixelSize(p);
        painter.drawEllipse(surface().toWidget(p), r, r);
    }
}

}  // namespace wend
