#include "app/tools/size_tool.h"

#include <QCoreApplication>

#include "app/document/size_edits.h"
#include "app/session/solid_places.h"
#include "app/tools/region_outline.h"

namespace wend {

QString SizeTool::hint() const {
    return QCoreApplication::translate(
        "SizeTool",
        "Paint finer or coarser cells; Ctrl the other way round, [ and ] change the size, Esc gives up");
}

void SizeTool::take(const std::vector<Dab>& dabs) {
    const double factor = modifiers() & Qt::ControlModifier ? 1 / m_factor : m_factor;
    std::vector<Ball<3>> balls;
    for (const Dab& one : dabs) balls.push_back(ballOf(one));
    Document& document = session().document();
    document.change(factor < 1   ? QCoreApplication::translate("SizeTool", "Paint finer cells")
                    : factor > 1 ? QCoreApplication::translate("SizeTool", "Paint coarser cells")
                                 : QCoreApplication::translate("SizeTool", "Paint plain cells"),
                    withSizeStroke(*document.project(), balls, factor));
}

/// Where they are now; of many balls one circle each.
void SizeTool::paint(QPainter& painter) const {
    StrokeTool<3>::paint(painter);
    const auto frame = session().frame<3>();
    if (!frame) return;
    painter.setPen(QPen(QColor(0x2a, 0x8a, 0x7a), 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    const Points<3>& rest = frame->rest->points;
    for (const Region<3>& region : m_shown) {
        const Carrying carry = carryingOf(*frame, verticesIn(region, *frame->rest));
        const auto* ball = std::get_if<Ball<3>>(&region);
        if (ball && m_shown.size() > 1) {
            const Vec<3> centre = carry(ball->centre);
            const double r = ball->radius / surface().pixelSize(centre);
            painter.drawEllipse(surface().toWidget(centre), r, r);
            continue;
        }
        for (const auto& line : regionOutline(region, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
            QPolygonF drawn;
            for (const Vec<3>& p : line) drawn << surface().toWidget(carry(p));
            painter.drawPolyline(drawn);
        }
    }
}

}  // namespace wend
