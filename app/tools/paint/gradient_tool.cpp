#include "app/tools/paint/gradient_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "app/engine/shape/material_raster.h"
#include "app/engine/shape/mesh_parts.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/part_edits.h"
#include "app/session/brush.h"
#include "app/style/colours.h"
#include "app/style/mark_size.h"
#include "app/tools/in_steps.h"
#include "app/tools/paint/brush_paint.h"
#include "core/base/error.h"

namespace wend {

namespace {

constexpr double kShortest = 4;     // pixels: less is a click
constexpr double kHandleReach = 9;  // of a handle

/// Maps a place of a part of the mesh, or of all if none is named, from one of its forms to another one, such
/// as from rest to a pose; outside the part by the offset from its nearest vertex.
template <int Dim>
Vec<Dim> carriedTo(const Points<Dim>& to, const Points<Dim>& from, const SimplicialMesh<Dim>& mesh,
                   const std::string& part, const Vec<Dim>& place) {
    const auto own = std::ranges::find(mesh.parts, part, &MeshPart::name);
    const int first = own == mesh.parts.end() ? 0 : own->firstCell,
              end = own == mesh.parts.end() ? mesh.cellCount() : own->endCell;
    const std::vector<Cell<Dim>> cells(mesh.cells.begin() + first, mesh.cells.begin() + end);
    const PointLocator<Dim> locator(from, cells);
    if (auto found = locator.find(place)) {
        found->cell += first;
        return positionOf<Dim>(*found, mesh, to);
    }
    const int nearest = locator.nearestVertex(place);
    return nearest < 0 ? place : Vec<Dim>(to.col(nearest) + place - from.col(nearest));
}

void dot(QPainter& painter, const QPointF& at, const QColor& colour, double radius) {
    painter.setPen(QPen(QColor(255, 255, 255, 217), marked(2)));
    painter.setBrush(colour);
    painter.drawEllipse(at, marked(radius), marked(radius));
}

}  // namespace

template <int Dim>
QString GradientTool<Dim>::hint() const {
    return QCoreApplication::translate("GradientTool",
                                       "Drag over the shape to blend evenly from what is there to what is "
                                       "chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels");
}

/// Returns the part of a picture that a gradient is drawn or moved on; empty: the picture is one.
template <int Dim>
const std::string& GradientTool<Dim>::part() const {
    if (!m_handle) return m_part;
    return session().document().design().material.regions[m_handle->region].part;
}

/// Finds the part that a new gradient begins on. Returns false if it must begin on one and does not.
template <int Dim>
bool GradientTool<Dim>::findPart(const QPointF& at) {
    m_part.clear();
    if (m_handle || m_frame->rest->parts.empty()) return true;
    const auto touch = surface().touch(at);
    if (touch) m_part = partNameOf<Dim>(*m_frame->rest, touch->place.cell);
    return touch.has_value();
}

/// In a picture places are those of the part, whatever is in front of it, and beside it those of its nearest
/// vertex; outside a solid there is none.
template <int Dim>
std::optional<typename GradientTool<Dim>::End> GradientTool<Dim>::endAt(const QPointF& at) const {
    const auto touch = surface().touch(at);
    if constexpr (Dim == 2)
        if (!touch || partNameOf<2>(*m_frame->rest, touch->place.cell) != part()) {
            const Vec<2> seen = surface().toShape(at);
            return End{carriedTo<2>(m_frame->rest->points, m_frame->pose, *m_frame->rest, part(), seen),
                       seen};
        }
    if (!touch) return {};
    return End{positionOf<Dim>(touch->place, *m_frame->rest, m_frame->rest->points), touch->point};
}

template <int Dim>
std::vector<typename GradientTool<Dim>::Handle> GradientTool<Dim>::handles() const {
    std::vector<Handle> found;
    const auto frame = session().template frame<Dim>();
    if (!frame || session().document().dimension() != Dim) return found;
    const auto& regions = session().document().design().material.regions;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const auto* blend = std::get_if<Blend<3>>(&regions[i].shape);
        if (!blend || isProtected(session().document().domain().parts, regions[i].part)) continue;
        for (const bool isTo : {false, true})
            found.push_back({i, isTo,
                             carriedTo<Dim>(frame->pose, frame->rest->points, *frame->rest, regions[i].part,
                                            (isTo ? blend->to : blend->from).template head<Dim>())});
    }
    return found;
}

/// Returns the topmost handle under the pointer.
template <int Dim>
std::optional<typename GradientTool<Dim>::Handle> GradientTool<Dim>::handleAt(const QPointF& at) const {
    std::optional<Handle> found;
    for (const Handle& one : handles())
        if (QLineF(surface().toWidget(one.seen), at).length() <= marked(kHandleReach)) found = one;
    return found;
}

/// The design with the end where it was dragged to; nothing where both ends would be one place.
template <int Dim>
std::optional<Design> GradientTool<Dim>::moved() const {
    Design next = session().document().design();
    auto& blend = std::get<Blend<3>>(next.material.regions[m_handle->region].shape);
    (m_handle->isTo ? blend.to : blend.from) = inSpace(m_to->rest);
    if (blend.from == blend.to) return {};
    return next;
}

template <int Dim>
void GradientTool<Dim>::press(const QMouseEvent& event) {
    m_cross.hide();
    if (event.button() != Qt::LeftButton) return;
    m_byKeys = m_cross.isAtWork();
    m_frame = surface().shownFrame();
    if (!m_frame) return;
    if (event.modifiers() & Qt::AltModifier) {
        if (const auto touch = surface().touch(event.position()))
            pickMaterial<Dim>(*m_frame, touch->place.cell, m_brush);
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
    const QString kind =
        QCoreApplication::translate("GradientTool", "To %1").arg(brushKind(m_brush.now(), Dim));
    m_layer = freeName(namesOf(session().document().design().material.regions), kind.toStdString());
    if (!m_from) m_frame.reset();
}

template <int Dim>
bool GradientTool<Dim>::isCurrent() const {
    const auto frame = session().template frame<Dim>();
    return frame && frame->shape == m_frame->shape && session().document().project() == m_project;
}

/// Returns the fixed end on the screen.
template <int Dim>
QPointF GradientTool<Dim>::otherEnd() const {
    if (m_handle)
        for (const Handle& one : handles())
            if (one.region == m_handle->region && one.isTo != m_handle->isTo)
                return surface().toWidget(one.seen);
    return surface().toWidget(m_from->seen);
}

/// Outside a solid the last place is kept. Mouse input cancels a gradient begun by keys.
template <int Dim>
void GradientTool<Dim>::move(const QMouseEvent& event) {
    m_cross.hide();
    if (!m_frame) return;
    if (!isCurrent() || m_byKeys != m_cross.isAtWork()) return cancel();
    const bool steps =
        event.modifiers() & Qt::ShiftModifier && !m_byKeys;  // arrow keys take longer ones by it
    const QPointF from = otherEnd(), way = event.position() - from;
    if (const auto end = endAt(from + (steps ? inSteps(way) : way))) m_to = end;
    preview(true);
}

template <int Dim>
std::optional<MaterialRegion> GradientTool<Dim>::region() const {
    const QPointF from = surface().toWidget(m_from->seen), to = surface().toWidget(m_to->seen);
    if (QLineF(from, to).length() < kShortest || m_from->rest == m_to->rest) return {};
    const MaterialPaint paint = paintOf<Dim>(m_brush.now(), m_to->rest - m_from->rest);
    MaterialRegion region{
        {}, Blend<3>{inSpace(m_from->rest), inSpace(m_to->rest)}, 0, paint.phi, paint.stiffness};
    region.part = m_part;
    return region;
}

/// Returns the design with the moved end or the new gradient; nothing for a click.
template <int Dim>
std::optional<Design> GradientTool<Dim>::next() const {
    if (m_handle) return moved();
    const auto drawn = region();
    if (!drawn) return {};
    return withStroke(session().document().design(), m_layer, {*drawn});
}

template <int Dim>
bool GradientTool<Dim>::preview(bool lasts) try {
    const auto design = next();
    const std::string folder = session().document().folder().toStdString();
    surface().showMaterial(
        design ? rasterizeMaterial<Dim>(design->material, *m_frame->rest, folder) : m_frame->material, lasts);
    surface().redraw();
    return design.has_value();
} catch (const InputError& error) {  // a picture of the material is missing
    session().notify(QString::fromStdString(error.what()));
    return false;
}

template <int Dim>
void GradientTool<Dim>::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !m_frame) return;
    const bool isBare = !m_handle && region() && paintsNothing(m_brush.now());
    if (isBare) session().notify(nothingToPaint());
    // or a click, or it began on removed cells
    if (isBare || !isCurrent() || !preview(true)) return cancel();
    auto design = *next();
    m_frame.reset();
    const QString what = brushKind(m_brush.now(), Dim);
    session().document().changeDesign(
        m_handle ? QCoreApplication::translate("GradientTool", "Move gradient")
                 : QCoreApplication::translate("GradientTool", "Blend to %1").arg(what),
        std::move(design));
    if (!m_handle) m_brush.layer().set({m_layer});
}

template <int Dim>
bool GradientTool<Dim>::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape)
        return m_cross.clicks<Dim>(event, surface(), *this,
                                   m_frame ? KeyCross::Enter::LetsGo : KeyCross::Enter::Presses);
    const bool has = m_frame != nullptr;
    cancel();
    return has;
}

template <int Dim>
void GradientTool<Dim>::cancel() {
    if (!m_frame) return;
    m_frame.reset();
    surface().showMaterial(nullptr);
    surface().redraw();
}

template <int Dim>
void GradientTool<Dim>::paint(QPainter& painter) const {
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
        const auto& region = session().document().design().material.regions[ends[i].region];
        const QColor colour = region.phi ? energyColour(stopOfPhi(*region.phi, Dim)) : kStiffColour;
        std::array<QPointF, 2> at = {surface().toWidget(ends[i].seen), surface().toWidget(ends[i + 1].seen)};
        if (m_frame && m_handle && m_handle->region == ends[i].region)
            at[m_handle->isTo ? 1 : 0] = surface().toWidget(m_to->seen);
        line(at[0], at[1], colour);
    }
    if (m_frame && !m_handle)
        line(surface().toWidget(m_from->seen), surface().toWidget(m_to->seen),
             QColor(brushColour(m_brush.now(), Dim)));
}

template class GradientTool<2>;
template class GradientTool<3>;

ToolKind gradientTool() {
    return toolKind("gradient", "gradient", QT_TRANSLATE_NOOP("Tools", "&Gradient"),
                    QT_TRANSLATE_NOOP("Tools", "Drag to blend evenly from what is there to what is chosen"),
                    "G", Mode::Paint, both<GradientTool>(&Workbench::brush), {ToolOption::Target},
                    paintedMap);
}

}  // namespace wend
