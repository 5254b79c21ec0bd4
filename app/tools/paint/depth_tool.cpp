#include "app/tools/paint/depth_tool.h"

#include <QCoreApplication>

#include "app/project/edits/value_edits.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/tools/picture_marks.h"

namespace wend {

QString DepthTool::strokeHint() const {
    return QCoreApplication::translate("DepthTool",
                                       "Brush over what lies in front or behind; Ctrl clears it, Shift swaps "
                                       "front and back, [ and ] change the size");
}

double DepthTool::order() const {
    if (modifiers() & Qt::ControlModifier) return 0;
    const double chosen = brush().order().now();
    return modifiers() & Qt::ShiftModifier ? -chosen : chosen;
}

QColor DepthTool::colour() const {
    return order() > 0 ? QColor(kAccent) : order() < 0 ? QColor(kBehind) : QColor(kPlain);
}

void DepthTool::take(const std::vector<Dab>& dabs) {
    std::vector<SoftRegion> stroke;
    for (const Dab& one : dabs) stroke.push_back({Ball<3>{one.rest, one.radius}, 0, partOf(dabs.front())});
    Document& document = session().document();
    document.changeDepth(order() > 0   ? QCoreApplication::translate("DepthTool", "Paint in front")
                         : order() < 0 ? QCoreApplication::translate("DepthTool", "Paint behind")
                                       : QCoreApplication::translate("DepthTool", "Clear depth"),
                         withDepthStroke(document.depth(), std::move(stroke), order()));
}

void DepthTool::paint(QPainter& painter) const {
    const auto frame = session().motion().frame<2>();
    if (frame) {
        const auto& orders = m_orders.of(session().document().depth(), frame->rest);
        paintDepths(painter, *frame, *orders, [this](const Vec2& p) { return view().onScreen(inSpace(p)); });
    }
    StrokeTool::paint(painter);
}

ToolKind depthTool() {
    return toolKind("depth", "depth", QT_TRANSLATE_NOOP("Tools", "Depth Brus&h"),
                    QT_TRANSLATE_NOOP("Tools", "Brush over what lies in front where the shape covers itself"),
                    "O", Mode::Paint, picturesOnly<DepthTool>(&Workbench::brush),
                    {ToolOption::Order, ToolOption::BrushSize});
}

}  // namespace wend
