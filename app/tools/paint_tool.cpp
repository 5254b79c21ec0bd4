#include "app/tools/paint_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

#include "app/session/solid_places.h"
#include "core/mesh/segments.h"

namespace wend {

QString PaintTool::hint() const {
    return QCoreApplication::translate(
        "PaintTool",
        "Paint the material chosen on the right; [ and ] change the size, Esc gives up the stroke");
}

/// Directions of what is seen are carried back to rest.
Vec<3> PaintTool::axisAt(const PosedFrame<3>& frame, const SolidHit& hit) const {
    if (m_along == StiffAlong::View)
        return cellRotation(frame, hit.cell).transpose() * surface().viewDirection();
    if (m_along == StiffAlong::Way) return cellRotation(frame, hit.cell).transpose() * wayAt(hit.point);
    return Vec<3>::Zero();
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

/// Along the stroke: from the ball before to the one behind, at rest.
std::vector<Vec<3>> PaintTool::axes(const std::vector<Dab>& dabs) const {
    std::vector<Vec<3>> axes;
    for (std::size_t i = 0; i < dabs.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, behind = std::min(i + 1, dabs.size() - 1);
        axes.push_back(m_along == StiffAlong::Stroke ? Vec<3>(dabs[behind].rest - dabs[before].rest)
                                                     : dabs[i].axis);
    }
    return axes;
}

void PaintTool::take(const std::vector<Dab>& dabs, Qt::KeyboardModifiers) {
    const auto along = axes(dabs);
    const bool lost = m_paint.stiffness && m_along != StiffAlong::Axis &&
                      std::all_of(along.begin(), along.end(), [](const Vec<3>& a) { return a.isZero(); });
    if (lost)
        emit session().notice(QCoreApplication::translate(
            "PaintTool", "There is no direction to follow: the numbers on the right were taken."));
    Document& document = session().document();
    document.change(QCoreApplication::translate("PaintTool", "Paint material"),
                    withPaint(*document.project(), ballsOf(dabs), m_paint, along));
}

}  // namespace wend
