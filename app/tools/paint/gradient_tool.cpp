#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/material_edits.h"
#include "app/project/edits/part_edits.h"
#include "app/project/project_fwd.h"
#include "app/session/brush.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/in_steps.h"
#include "app/tools/key_cross.h"
#include "app/tools/paint/brush_paint.h"
#include "app/tools/tool_kind.h"
#include "app/tools/tool_kinds.h"
#include "core/base/error.h"

namespace wend {

/// Draws a gradient from the existing material at the start of a drag to the paint of the brush at its end
/// and beyond. It is one layer and one undo step. The ends of all gradients are handles that can be dragged.
class GradientTool : public ShapeTool<> {
  public:
    GradientTool(ShapeView& view, Brush& brush) : ShapeTool<>(view), m_brush(brush) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override { m_cross.hide(); }
    void paint(QPainter& painter) const override;

  private:
    struct End {
        Vec3 rest, seen;
    };
    /// An end of a gradient that is there, by its layer and the place of its region in it.
    struct Handle {
        Id layer;
        std::size_t region;
        bool isTo;
        Vec3 seen;
    };
    std::vector<Handle> handles() const;
    std::optional<Handle> handleAt(const QPointF& at) const;
    const std::string& part() const;
    const MaterialRegion& gradientOf(const Handle& handle) const;
    bool findPart(const QPointF& at);
    std::optional<Design> moved() const;
    bool isCurrent() const;
    std::optional<End> endAt(const QPointF& at) const;
    QPointF otherEnd() const;
    std::optional<MaterialRegion> region() const;
    std::optional<Design> next() const;
    bool preview(bool lasts);

    Brush& m_brush;
    KeyCross m_cross;
    bool m_byKeys = false;                     // of the current drag
    FramePtr m_frame;                          // when the drag began, with its material; null without a drag
    std::shared_ptr<const Project> m_project;  // then
    std::optional<End> m_from, m_to;
    PaintedLayer m_layer;            // of a new gradient,
    std::string m_part;              // and the part of the picture
    std::optional<Handle> m_handle;  // that is dragged, in place of a new gradient
};

namespace {

constexpr double kShortest = 4;     // pixels: less is a click
constexpr double kHandleReach = 9;  // of a handle

void dot(QPainter& painter, const QPointF& at, const QColor& colour, double radius) {
    painter.setPen(QPen(QColor(255, 255, 255, 217), marked(2)));
    painter.setBrush(colour);
    painter.drawEllipse(at, marked(radius), marked(radius));
}

}  // namespace

QString GradientTool::hint() const {
    return QCoreApplication::translate("GradientTool",
                                       "Drag over the shape to blend evenly from what is there to what is "
                                       "chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels");
}

/// Returns the part of a picture that a gradient is drawn or moved on; empty: the picture is one.
const std::string& GradientTool::part() const {
    if (!m_handle) return m_part;
    return gradientOf(*m_handle).part;
}

const MaterialRegion& GradientTool::gradientOf(const Handle& handle) const {
    return layerOf(session().document().design().material.layers, handle.layer)->regions[handle.region];
}

/// Finds the part that a new gradient begins on. Returns false if it must begin on one and does not.
bool GradientTool::findPart(const QPointF& at) {
    m_part.clear();
    if (m_handle || m_frame->parts().empty()) return true;
    const auto touch = view().touch(at);
    if (touch) m_part = m_frame->partOf(touch->place.cell);
    return touch.has_value();
}

/// In a picture places are those of the part, whatever is in front of it, and beside it those of its nearest
/// vertex; outside a solid there is none.
std::optional<GradientTool::End> GradientTool::endAt(const QPointF& at) const {
    const auto touch = view().touch(at);
    if (view().dimension() == 2 && (!touch || m_frame->partOf(touch->place.cell) != part())) {
        const Vec3 seen = acrossTheScreen(view(), Vec3::Zero(), at);
        return End{m_frame->carriedToRest(seen, part()), seen};
    }
    if (!touch) return {};
    return End{m_frame->restAt(touch->place), touch->point};
}

std::vector<GradientTool::Handle> GradientTool::handles() const {
    std::vector<Handle> found;
    const FramePtr frame = this->frame();
    if (!frame) return found;
    for (const MaterialLayer& layer : session().document().design().material.layers)
        for (std::size_t i = 0; i < layer.regions.size(); ++i) {
            const MaterialRegion& region = layer.regions[i];
            const auto* blend = std::get_if<Blend<3>>(&region.shape);
            if (!blend || isProtected(session().document().domain().parts, region.part)) continue;
            for (const bool isTo : {false, true})
                found.push_back(
                    {layer.id, i, isTo, frame->carriedFromRest(isTo ? blend->to : blend->from, region.part)});
        }
    return found;
}

/// Returns the topmost handle under the pointer.
std::optional<GradientTool::Handle> GradientTool::handleAt(const QPointF& at) const {
    std::optional<Handle> found;
    for (const Handle& one : handles())
        if (QLineF(view().onScreen(one.seen), at).length() <= marked(kHandleReach)) found = one;
    return found;
}

/// Returns the design with the dragged end; nothing if both ends would coincide.
std::optional<Design> GradientTool::moved() const {
    Design next = session().document().design();
    MaterialLayer* layer = layerOf(next.material.layers, m_handle->layer);
    auto& blend = std::get<Blend<3>>(layer->regions[m_handle->region].shape);
    (m_handle->isTo ? blend.to : blend.from) = m_to->rest;
    if (blend.from == blend.to) return {};
    return next;
}

void GradientTool::press(const QMouseEvent& event) {
    m_cross.hide();
    if (event.button() != Qt::LeftButton) return;
    m_byKeys = m_cross.isAtWork();
    m_frame = view().shownFrame();
    if (!m_frame) return;
    if (event.modifiers() & Qt::AltModifier) {
        if (const auto touch = view().touch(event.position()))
            pickMaterial(*EditedMaterial::of(m_frame, {}), touch->place.cell, m_brush);
        m_frame.reset();
        return;
    }
    m_project = session().document().project();
    m_handle = handleAt(event.position());
    if (!findPart(event.position())) {
        m_frame.reset();
        return;
    }
    m_from = m_to = endAt(event.position());
    const QString kind = QCoreApplication::translate("GradientTool", "To %1")
                             .arg(brushKind(m_brush.now(), view().dimension()));
    m_layer = {.name = freeName(namesOf(session().document().design().material.layers), kind.toStdString())};
    if (!m_from) m_frame.reset();
}

bool GradientTool::isCurrent() const {
    const FramePtr frame = this->frame();
    return frame && frame->shape == m_frame->shape && session().document().project() == m_project;
}

/// Returns the fixed end on the screen.
QPointF GradientTool::otherEnd() const {
    if (m_handle)
        for (const Handle& one : handles())
            if (one.layer == m_handle->layer && one.region == m_handle->region && one.isTo != m_handle->isTo)
                return view().onScreen(one.seen);
    return view().onScreen(m_from->seen);
}

/// Outside a solid the last place is kept. Mouse input cancels a gradient begun by keys.
void GradientTool::move(const QMouseEvent& event) {
    m_cross.hide();
    if (!m_frame) return;
    if (!isCurrent() || m_byKeys != m_cross.isAtWork()) return cancel();
    const bool steps =
        event.modifiers() & Qt::ShiftModifier && !m_byKeys;  // arrow keys take longer ones by it
    const QPointF from = otherEnd(), way = event.position() - from;
    if (const auto end = endAt(from + (steps ? inSteps(way) : way))) m_to = end;
    preview(true);
}

std::optional<MaterialRegion> GradientTool::region() const {
    const QPointF from = view().onScreen(m_from->seen), to = view().onScreen(m_to->seen);
    if (QLineF(from, to).length() < kShortest || m_from->rest == m_to->rest) return {};
    const MaterialPaint paint = paintOf(m_brush.now(), view().dimension(), m_to->rest - m_from->rest);
    return MaterialRegion{{Blend<3>{m_from->rest, m_to->rest}, 0, m_part}, paint.phi, paint.stiffness};
}

/// Returns the design with the moved end or the new gradient; nothing for a click.
std::optional<Design> GradientTool::next() const {
    if (m_handle) return moved();
    const auto drawn = region();
    if (!drawn) return {};
    return withStroke(session().document().design(), m_layer, {*drawn});
}

bool GradientTool::preview(bool lasts) try {
    const auto design = next();
    const std::string folder = session().document().folder().toStdString();
    view().showMaterial(design ? EditedMaterial::of(m_frame, folder)->with(design->material) : m_frame,
                        lasts);
    view().redraw();
    return design.has_value();
} catch (const InputError& error) {  // a picture of the material is missing
    session().document().notify(QString::fromStdString(error.what()));
    return false;
}

void GradientTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !m_frame) return;
    const bool isBare = !m_handle && region() && paintsNothing(m_brush.now());
    if (isBare) session().document().notify(nothingToPaint());
    // or a click, or it began on removed cells
    if (isBare || !isCurrent() || !preview(true)) return cancel();
    auto design = *next();
    m_frame.reset();
    const QString what = brushKind(m_brush.now(), view().dimension());
    session().document().changeDesign(
        m_handle ? QCoreApplication::translate("GradientTool", "Move gradient")
                 : QCoreApplication::translate("GradientTool", "Blend to %1").arg(what),
        std::move(design));
    if (!m_handle) m_brush.layer().set({m_layer.id});
}

bool GradientTool::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape)
        return m_cross.clicks(event, view(), *this,
                              m_frame ? KeyCross::Enter::LetsGo : KeyCross::Enter::Presses);
    const bool has = m_frame != nullptr;
    cancel();
    return has;
}

void GradientTool::cancel() {
    if (!m_frame) return;
    m_frame.reset();
    view().showMaterial(nullptr);
    view().redraw();
}

void GradientTool::paint(QPainter& painter) const {
    m_cross.paint(painter);
    const auto line = [&](const QPointF& from, const QPointF& to, const QColor& colour) {
        painter.setPen(QPen(QColor(255, 255, 255, 217), marked(3.5)));
        painter.drawLine(from, to);
        painter.setPen(QPen(QColor(0x14, 0x16, 0x1e), marked(1.5)));
        painter.drawLine(from, to);
        dot(painter, from, QColor(0x14, 0x16, 0x1e), 5);
        dot(painter, to, colour, 7);
    };
    const auto ends = handles();
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const MaterialRegion& region = gradientOf(ends[i]);
        const QColor colour =
            region.phi ? energyColour(stopOfPhi(*region.phi, view().dimension())) : kStiffColour;
        std::array<QPointF, 2> at = {view().onScreen(ends[i].seen), view().onScreen(ends[i + 1].seen)};
        if (m_frame && m_handle && m_handle->layer == ends[i].layer && m_handle->region == ends[i].region)
            at[m_handle->isTo ? 1 : 0] = view().onScreen(m_to->seen);
        line(at[0], at[1], colour);
    }
    if (m_frame && !m_handle)
        line(view().onScreen(m_from->seen), view().onScreen(m_to->seen),
             QColor(brushColour(m_brush.now(), view().dimension())));
}

ToolKind gradientTool() {
    return toolKind("gradient", "gradient", QT_TRANSLATE_NOOP("Tools", "&Gradient"),
                    QT_TRANSLATE_NOOP("Tools", "Drag to blend evenly from what is there to what is chosen"),
                    "G", Mode::Paint, both<GradientTool>(&Workbench::brush), {ToolOption::Target},
                    paintedMap);
}

}  // namespace wend
