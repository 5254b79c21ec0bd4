#include "app/tools/paint/fill_tool.h"

#include <QCoreApplication>

#include "app/engine/shape/erasing.h"
#include "app/engine/shape/material_raster.h"
#include "app/engine/shape/mesh_parts.h"
#include "app/project/design.h"
#include "app/session/brush.h"
#include "app/style/mark_size.h"
#include "app/tools/paint/brush_paint.h"
#include "core/base/error.h"

namespace wend {

template <int Dim>
QString FillTool<Dim>::hint() const {
    return m_deed == Deed::Pick
               ? QCoreApplication::translate("FillTool", "Click to pick up what is painted there")
               : QCoreApplication::translate(
                     "FillTool",
                     "Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up");
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

/// Fills one region that contains the centroid of every cell.
template <int Dim>
void FillTool<Dim>::fill(int cell, Qt::KeyboardModifiers modifiers) try {
    const SimplicialMesh<Dim>& rest = *surface().shownFrame()->rest;
    Document& document = session().document();
    const std::string folder = document.folder().toStdString();
    const Region<3> shape =
        inSpace(modifiers & Qt::ShiftModifier ? regionOfAll(rest) : regionAround(rest, partOf(rest, cell)));
    const std::string part = partNameOf<Dim>(rest, cell);
    const Design& design = document.design();
    if (modifiers & Qt::ControlModifier) {
        const Eraser eraser{.shape = shape, .part = part};
        show(withoutErasedLayers<Dim>(withErased<Dim>(design, std::span(&eraser, 1), rest, folder), rest,
                                      folder),
             QCoreApplication::translate("PaintTool", "Erase paint"));
        return;
    }
    const BrushSettings& brush = m_brush.now();
    if (paintsNothing(brush)) {
        session().notify(nothingToPaint());
        return;
    }
    const MaterialPaint paint = paintOf<Dim>(brush);
    const QString what = brushKind(brush, Dim);
    const std::string aim = brushAim(brush);
    const std::string layer = layerFor<Dim>(design, brush, m_brush.layer().now(), aim, what.toStdString());
    MaterialRegion region{{}, shape, 0, paint.phi, paint.stiffness};
    region.part = part;
    show(withStroke(design, layer, {std::move(region)}),
         QCoreApplication::translate("FillTool", "Fill with %1").arg(what));
    m_brush.layer().set({layer, aim});
} catch (const InputError& error) {  // a picture of the material is missing
    session().notify(QString::fromStdString(error.what()));
}

template <int Dim>
void FillTool<Dim>::show(Design next, const QString& step) {
    Document& document = session().document();
    surface().showMaterial(
        rasterizeMaterial<Dim>(next.material, *surface().shownFrame()->rest, document.folder().toStdString()),
        true);
    document.changeDesign(step, std::move(next));
}

template <int Dim>
void FillTool<Dim>::move(const QMouseEvent& event) {
    m_cross.hide();
    m_at = event.position();
    m_over = true;
    surface().redraw();
}

/// Draws the fill's value beside the pointer.
template <int Dim>
void FillTool<Dim>::paint(QPainter& painter) const {
    m_cross.paint(painter);
    if (!m_over) return;
    painter.setPen(QPen(Qt::white, marked(2)));
    painter.setBrush(QColor(brushColour(m_brush.now(), Dim)));
    painter.drawEllipse(m_at + marked(16) * QPointF(1, 1), marked(7), marked(7));
}

template class FillTool<2>;
template class FillTool<3>;

ToolKind fillTool() {
    return toolKind("fill", "fill", QT_TRANSLATE_NOOP("Tools", "&Fill"),
                    QT_TRANSLATE_NOOP("Tools", "Fill a connected area with what is chosen"), "Shift+G",
                    Mode::Paint, both<FillTool>(&Workbench::brush, FillDeed::Fill), {ToolOption::Target},
                    paintedMap);
}

ToolKind eyedropperTool() {
    return toolKind("eyedropper", "pick", QT_TRANSLATE_NOOP("Tools", "E&yedropper"),
                    QT_TRANSLATE_NOOP("Tools", "Pick up what is painted under the pointer"), "I", Mode::Paint,
                    both<FillTool>(&Workbench::brush, FillDeed::Pick), {}, paintedMap);
}

}  // namespace wend
