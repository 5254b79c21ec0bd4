#include "app/tools/mesh/size_tool.h"

#include <QCoreApplication>

#include "app/project/domain.h"
#include "app/project/edits/value_edits.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

void paintMesh(QPainter& painter, ShapeView& view) {
    const auto frame = view.session().motion().frame<2>();
    if (!frame) return;
    painter.setPen(QPen(QColor(0x2a, 0x8a, 0x7a, 120), 0.75));
    QList<QLineF> lines;
    for (const auto& facet : facetsOf(*frame->rest))
        lines << QLineF(view.onScreen(frame->vertex(facet.vertices[0])),
                        view.onScreen(frame->vertex(facet.vertices[1])));
    painter.drawLines(lines);
}

}  // namespace

QString SizeTool::strokeHint() const {
    return QCoreApplication::translate("SizeTool",
                                       "Brush over what should be meshed finer; Shift makes it coarser, Ctrl "
                                       "evens it out again, [ and ] change the size");
}

double SizeTool::factor() const {
    if (modifiers() & Qt::ControlModifier) return 1;
    const double chosen = brush().edges().now();
    return modifiers() & Qt::ShiftModifier ? 1 / chosen : chosen;
}

void SizeTool::take(const std::vector<Dab>& dabs) {
    Document& document = session().document();
    if (view().dimension() == 2 && document.domain().kind != DomainKind::Image) {
        session().document().notify(
            QCoreApplication::translate("SizeTool", "The mesh comes from a file and is used as it is."));
        return;
    }
    std::vector<SoftRegion> stroke;
    for (const Dab& one : dabs) {
        const double feather = view().dimension() == 2 ? featherOf(dabs.front()) : 0.5 * one.radius;
        stroke.push_back({Ball<3>{one.rest, one.radius}, feather, partOf(dabs.front())});
    }
    const QString name = factor() < 1   ? QCoreApplication::translate("SizeTool", "Paint finer mesh")
                         : factor() > 1 ? QCoreApplication::translate("SizeTool", "Paint coarser mesh")
                                        : QCoreApplication::translate("SizeTool", "Paint even mesh");
    document.changeSizes(name, withSizeStroke(document.domain().sizes, std::move(stroke), factor()));
}

void SizeTool::paint(QPainter& painter) const {
    if (view().dimension() == 2) paintMesh(painter, view());
    StrokeTool::paint(painter);
}

ToolKind detailBrushTool() {
    return toolKind("sizes", "sizes", QT_TRANSLATE_NOOP("Tools", "&Detail Brush"),
                    QT_TRANSLATE_NOOP("Tools", "Brush where the mesh should be finer or coarser"), "Shift+A",
                    Mode::Mesh, both<SizeTool>(&Workbench::brush), {ToolOption::Edges, ToolOption::BrushSize},
                    [](const Workbench&, int dimension) {
                        return dimension == 3 ? std::optional(Measure::CellSize) : std::nullopt;
                    });
}

}  // namespace wend
