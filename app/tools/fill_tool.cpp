#include "app/tools/fill_tool.h"

#include <QCoreApplication>

#include "app/document/design.h"
#include "app/session/brush.h"
#include "app/session/mark_size.h"
#include "app/session/material_raster.h"
#include "app/session/mesh_parts.h"
#include "app/tools/brush_paint.h"

namespace wend {

template <int Dim>
QString FillTool<Dim>::hint() const {
    return m_deed == Deed::Pick
               ? QCoreApplication::translate("FillTool", "Click to take up what is painted there")
               : QCoreApplication::translate(
                     "FillTool",
                     "Click to fill what hangs together there; Shift fills all, Ctrl empties, Alt picks up");
}

template <int Dim>
void FillTool<Dim>::press(const QMouseEvent& event) {
    const auto frame = surface().shownFrame();
    const auto touch = surface().touch(event.position());
    if (event.button() != Qt::LeftButton || !frame || !touch) return;
    if (m_deed == Deed::Pick || event.modifiers() & Qt::AltModifier)
        pickMaterial<Dim>(*frame, touch->place.cell, m_brush);
    else
        fill(touch->place.cell, event.modifiers());
    surface().redraw();
}

/// One region, of which every cell's middle lies inside.
template <int Dim>
void FillTool<Dim>::fill(int cell, Qt::KeyboardModifiers modifiers) {
    const auto frame = surface().shownFrame();
    const SimplicialMesh<Dim>& rest = *frame->rest;
    Document& document = session().document();
    MaterialRegion<Dim> region;
    region.shape = modifiers & Qt::ShiftModifier ? regionOfAll(rest) : regionAround(rest, partOf(rest, cell));
    BrushSettings brush = m_brush.now();
    const bool empties = modifiers & Qt::ControlModifier;
    if (empties) brush.phi = document.template design<Dim>().material.phi, brush.ratio = 1;
    const MaterialPaint<Dim> paint = paintOf<Dim>(brush);
    region.phi = paint.phi;
    region.stiffness = paint.stiffness;
    auto painted = std::make_shared<Material<Dim>>(*frame->material);
    layRegion<Dim>(region, rest, *painted);
    surface().showMaterial(painted, true);
    const QString where = shortName(document.displayName()), what = brushKind(brush, Dim);
    const QString kind = empties ? QCoreApplication::translate("FillTool", "Emptied") : what;
    document.changeDesign(empties
                              ? QCoreApplication::translate("FillTool", "Empty %1").arg(where)
                              : QCoreApplication::translate("FillTool", "Fill %1 with %2").arg(where, what),
                          withRegions<Dim>(document.design<Dim>(), kind.toStdString(), {region}));
}

template <int Dim>
void FillTool<Dim>::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    surface().redraw();
}

/// Beside the pointer what would be laid.
template <int Dim>
void FillTool<Dim>::paint(QPainter& painter) const {
    if (!m_over) return;
    painter.setPen(QPen(Qt::white, marked(2)));
    painter.setBrush(QColor(brushColour(m_brush.now(), Dim)));
    painter.drawEllipse(m_at + marked(16) * QPointF(1, 1), marked(7), marked(7));
}

template class FillTool<2>;
template class FillTool<3>;

}  // namespace wend
