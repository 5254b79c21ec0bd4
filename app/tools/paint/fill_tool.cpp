#include <QCoreApplication>

#include "app/engine/motion/edited_material.h"
#include "app/project/design.h"
#include "app/session/brush.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/tools/key_cross.h"
#include "app/tools/paint/brush_paint.h"
#include "app/tools/tool_kind.h"
#include "app/tools/tool_kinds.h"
#include "core/base/error.h"

namespace wend {

enum class FillDeed { Fill, Pick };

/// Fills the connected area under a click with the paint of the brush, with Shift the whole shape; or picks
/// up the material.
class FillTool : public ShapeTool<> {
  public:
    using Deed = FillDeed;
    FillTool(ShapeView& view, Brush& brush, Deed deed) : ShapeTool<>(view), m_brush(brush), m_deed(deed) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::PointingHandCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent& event) override { return m_cross.clicks(event, view(), *this); }
    void cancel() override {}
    void leave() override {
        m_over = false;
        m_cross.hide();
    }
    void paint(QPainter& painter) const override;

  private:
    void fill(int cell, Qt::KeyboardModifiers modifiers);
    void show(Design next, const QString& step);
    std::unique_ptr<EditedMaterial> material() const;

    Brush& m_brush;
    Deed m_deed;
    KeyCross m_cross;
    bool m_over = false;
    QPointF m_at;
};

QString FillTool::hint() const {
    return m_deed == Deed::Pick
               ? QCoreApplication::translate("FillTool", "Click to pick up what is painted there")
               : QCoreApplication::translate(
                     "FillTool",
                     "Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up");
}

std::unique_ptr<EditedMaterial> FillTool::material() const {
    return EditedMaterial::of(view().shownFrame(), session().document().folder().toStdString());
}

void FillTool::press(const QMouseEvent& event) {
    const auto touch = view().touch(event.position());
    if (event.button() != Qt::LeftButton || !view().shownFrame() || !touch) return;
    if (m_deed == Deed::Pick || event.modifiers() & Qt::AltModifier)
        pickMaterial(*material(), touch->place.cell, m_brush);
    else
        fill(touch->place.cell, event.modifiers());
    view().redraw();
}

/// Fills one region that contains the centroid of every cell.
void FillTool::fill(int cell, Qt::KeyboardModifiers modifiers) try {
    const auto material = this->material();
    const Region<3> shape = modifiers & Qt::ShiftModifier ? material->whole() : material->around(cell);
    const std::string part = view().shownFrame()->partOf(cell);
    const Design& design = session().document().design();
    if (modifiers & Qt::ControlModifier) {
        const Eraser eraser{.shape = shape, .part = part};
        show(material->withoutErasedLayers(material->erased(design, std::span(&eraser, 1))),
             QCoreApplication::translate("PaintTool", "Erase paint"));
        return;
    }
    const BrushSettings& brush = m_brush.now();
    if (paintsNothing(brush)) {
        session().document().notify(nothingToPaint());
        return;
    }
    const MaterialPaint paint = paintOf(brush, view().dimension());
    const QString what = brushKind(brush, view().dimension());
    const std::string aim = brushAim(brush);
    const PaintedLayer layer = layerFor(design, brush, m_brush.layer().now(), aim, what.toStdString());
    show(withStroke(design, layer, {{{shape, 0, part}, paint.phi, paint.stiffness}}),
         QCoreApplication::translate("FillTool", "Fill with %1").arg(what));
    m_brush.layer().set({layer.id, aim});
} catch (const InputError& error) {  // a picture of the material is missing
    session().document().notify(QString::fromStdString(error.what()));
}

void FillTool::show(Design next, const QString& step) {
    view().showMaterial(material()->with(next.material), true);
    session().document().changeDesign(step, std::move(next));
}

void FillTool::move(const QMouseEvent& event) {
    m_cross.hide();
    m_at = event.position();
    m_over = true;
    view().redraw();
}

/// Draws the fill's value beside the pointer.
void FillTool::paint(QPainter& painter) const {
    m_cross.paint(painter);
    if (!m_over) return;
    painter.setPen(QPen(Qt::white, marked(2)));
    painter.setBrush(QColor(brushColour(m_brush.now(), view().dimension())));
    painter.drawEllipse(m_at + marked(16) * QPointF(1, 1), marked(7), marked(7));
}

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
