#include "app/tools/flat_size_tool.h"

#include <QCoreApplication>

#include "app/document/domain.h"
#include "app/document/size_edits.h"

namespace wend {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("FlatSizeTool", text);
}

}  // namespace

QString FlatSizeTool::strokeHint() const {
    return said(QT_TRANSLATE_NOOP("FlatSizeTool",
                                  "Brush over what shall be meshed finer; Shift makes it coarser, Ctrl even "
                                  "again, [ and ] change the size"));
}

double FlatSizeTool::factor() const {
    if (modifiers() & Qt::ControlModifier) return 1;
    return modifiers() & Qt::ShiftModifier ? 1 / m_factor.now() : m_factor.now();
}

void FlatSizeTool::take(const std::vector<Dab>& dabs) {
    Document& document = session().document();
    if (document.domain().kind != DomainKind::Image) {
        emit session().notice(
            said(QT_TRANSLATE_NOOP("FlatSizeTool", "The mesh comes from a file and is used as it is.")));
        return;
    }
    std::vector<Ball<2>> balls;
    for (const Dab& one : dabs) balls.push_back(ballOf(one));
    document.changeDomain(factor() < 1   ? said(QT_TRANSLATE_NOOP("FlatSizeTool", "Paint finer mesh"))
                          : factor() > 1 ? said(QT_TRANSLATE_NOOP("FlatSizeTool", "Paint coarser mesh"))
                                         : said(QT_TRANSLATE_NOOP("FlatSizeTool", "Paint even mesh")),
                          withFlatSizeStroke(document.domain(), balls, featherOf(dabs.front()), factor()));
}

/// The mesh as it is, so that one sees what is fine.
void FlatSizeTool::paint(QPainter& painter) const {
    if (const auto frame = session().frame<2>()) {
        painter.setPen(QPen(QColor(0x2a, 0x8a, 0x7a, 120), 0.75));
        QList<QLineF> lines;
        for (const auto& facet : facetsOf(*frame->rest))
            lines << QLineF(surface().toWidget(frame->pose.col(facet.vertices[0])),
                            surface().toWidget(frame->pose.col(facet.vertices[1])));
        painter.drawLines(lines);
    }
    StrokeTool<2>::paint(painter);
}

}  // namespace wend
