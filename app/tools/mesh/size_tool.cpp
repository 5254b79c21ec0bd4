#include "app/tools/mesh/size_tool.h"

#include <QCoreApplication>

#include "app/project/domain.h"
#include "app/project/edits/size_edits.h"
#include "app/style/mark_size.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

void paintMesh(QPainter& painter, ToolSurface& surface) {
    const auto frame = surface.session().frame<2>();
    if (!frame) return;
    painter.setPen(QPen(QColor(0x2a, 0x8a, 0x7a, 120), 0.75));
    QList<QLineF> lines;
    for (const auto& facet : facetsOf(*frame->rest))
        lines << QLineF(surface.toWidget(frame->pose.col(facet.vertices[0])),
                        surface.toWidget(frame->pose.col(facet.vertices[1])));
    painter.drawLines(lines);
}

}  // namespace

template <int Dim>
QString SizeTool<Dim>::strokeHint() const {
    return QCoreApplication::translate("SizeTool",
                                       "Brush over what should be meshed finer; Shift makes it coarser, Ctrl "
                                       "evens it out again, [ and ] change the size");
}

template <int Dim>
double SizeTool<Dim>::factor() const {
    if (modifiers() & Qt::ControlModifier) return 1;
    const double chosen = brush().edges().now();
    return modifiers() & Qt::ShiftModifier ? 1 / chosen : chosen;
}

template <int Dim>
void SizeTool<Dim>::take(const std::vector<Dab>& dabs) {
    Document& document = session().document();
    if (Dim == 2 && document.domain().kind != DomainKind::Image) {
        session().notify(
            QCoreApplication::translate("SizeTool", "The mesh comes from a file and is used as it is."));
        return;
    }
    std::vector<Ball<3>> balls;
    for (const Dab& one : dabs) balls.push_back({inSpace(one.rest), one.radius});
    const QString name = factor() < 1   ? QCoreApplication::translate("SizeTool", "Paint finer mesh")
                         : factor() > 1 ? QCoreApplication::translate("SizeTool", "Paint coarser mesh")
                                        : QCoreApplication::translate("SizeTool", "Paint even mesh");
    if constexpr (Dim == 2)
        document.changeDomain(
            name, withFlatSizeStroke(document.domain(), balls, this->featherOf(dabs.front()), factor(),
                                     this->partOf(dabs.front())));
    else
        document.changeDomain(name, withSizeStroke(document.domain(), balls, factor()));
}

template <int Dim>
void SizeTool<Dim>::paint(QPainter& painter) const {
    if constexpr (Dim == 2) paintMesh(painter, surface());
    StrokeTool<Dim>::paint(painter);
    if constexpr (Dim == 3)
        paintRegions(painter, surface(), brush().regions().now(),
                     QPen(this->colour(), marked(1.5), Qt::DashLine));
}

template class SizeTool<2>;
template class SizeTool<3>;

ToolKind detailBrushTool() {
    return toolKind("sizes", "sizes", QT_TRANSLATE_NOOP("Tools", "&Detail Brush"),
                    QT_TRANSLATE_NOOP("Tools", "Brush where the mesh should be finer or coarser"), "Shift+A",
                    Mode::Mesh, both<SizeTool>(&Workbench::brush), {ToolOption::Edges, ToolOption::BrushSize},
                    [](const Workbench&, int dimension) {
                        return dimension == 3 ? std::optional(Measure::CellSize) : std::nullopt;
                    });
}

}  // namespace wend
