#include "app/tools/size_tool.h"

#include <QCoreApplication>

#include "app/document/domain.h"
#include "app/document/size_edits.h"
#include "app/session/mark_size.h"
#include "app/tools/region_outline.h"

namespace wend {

QString SizeTool::strokeHint() const {
    return QCoreApplication::translate(
        "SizeTool",
        "Paint finer or coarser cells; Ctrl the other way round, [ and ] change the size, Esc gives up");
}

void SizeTool::take(const std::vector<Dab>& dabs) {
    const double factor = modifiers() & Qt::ControlModifier ? 1 / m_factor : m_factor;
    std::vector<Ball<3>> balls;
    for (const Dab& one : dabs) balls.push_back(ballOf(one));
    Document& document = session().document();
    document.changeDomain(factor < 1   ? QCoreApplication::translate("SizeTool", "Paint finer cells")
                          : factor > 1 ? QCoreApplication::translate("SizeTool", "Paint coarser cells")
                                       : QCoreApplication::translate("SizeTool", "Paint plain cells"),
                          withSizeStroke(document.domain(), balls, factor));
}

void SizeTool::paint(QPainter& painter) const {
    StrokeTool<3>::paint(painter);
    paintRegions(painter, surface(), m_shown, QPen(QColor(0x2a, 0x8a, 0x7a), marked(1.5), Qt::DashLine));
}

}  // namespace wend
