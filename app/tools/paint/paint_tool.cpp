#include "app/tools/paint/paint_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/project/design.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/tools/paint/brush_paint.h"
#include "core/base/error.h"
#include "core/mesh/segments.h"

namespace wend {

namespace {

constexpr double kStiffFrom = 1.01;  // less is as everywhere
constexpr QRgb kEraser = 0xff5c5f69;

}  // namespace

QString PaintTool::strokeHint() const {
    if (m_deed == Deed::Erase)
        return QCoreApplication::translate(
            "PaintTool",
            "Erases paint from all visible layers: brush over what should be like "
            "the rest again; Shift-click draws a line, Esc cancels the stroke");
    if (paintsNothing(brush().now())) return nothingToPaint();
    return brush().now().target == BrushTarget::Direction
               ? QCoreApplication::translate(
                     "PaintTool",
                     "Comb along the direction in which it should be stiff; Ctrl erases, Shift smooths, "
                     "Shift-click draws a line, Alt-click picks up, Esc cancels the stroke")
               : QCoreApplication::translate(
                     "PaintTool",
                     "Paint what is chosen on the right; Ctrl erases, Shift smooths, Shift-click draws a "
                     "line, Alt-click picks up, Esc cancels the stroke");
}

QColor PaintTool::colour() const {
    return m_deed == Deed::Erase ? kEraser : brushColour(brush().now(), view().dimension());
}

PaintTool::Deed PaintTool::deed() const {
    if (m_deed == Deed::Erase || (modifiers() & Qt::ControlModifier)) return Deed::Erase;
    return modifiers() & Qt::ShiftModifier ? Deed::Smooth : Deed::Paint;
}

void PaintTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !(event.modifiers() & Qt::AltModifier)) {
        StrokeTool::press(event);
        return;
    }
    const FramePtr shown = view().shownFrame();
    const auto touch = view().touch(event.position());
    if (shown && touch) pickMaterial(*EditedMaterial::of(shown, {}), touch->place.cell, brush());
}

void PaintTool::begin() {
    const auto& design = session().document().design();
    m_material = EditedMaterial::of(view().shownFrame(), session().document().folder().toStdString());
    m_layer = layer();
    m_regions.clear();
    m_first = 0;
    if (deed() != Deed::Erase)
        m_first = static_cast<std::size_t>(
            std::ranges::find(design.material.layers, m_layer.id, &MaterialLayer::id) -
            design.material.layers.begin());
}

/// Maps directions of the view back to rest.
Vec3 PaintTool::axisAt(const ShapeFrame& frame, const Touch& touch) const {
    Vec3 seen = Vec3::Zero();
    if (view().dimension() == 3 && brush().now().along == StiffAlong::View) seen = view().viewDirection();
    if (brush().now().along == StiffAlong::Way) seen = wayAt(touch.point);
    return frame.rotationOf(touch.place.cell).transpose() * seen;
}

/// Returns the direction of the selected handle's path at its nearest point; zero without one.
Vec3 PaintTool::wayAt(const Vec3& p) const {
    const int selected = session().selection().single();
    if (selected < 0) return Vec3::Zero();
    const auto starts = session().pins().pathStarts(selected);
    if (starts.empty()) return Vec3::Zero();
    const auto& handle = session().document().design().handles[selected];
    const auto way = pinPaths(handle, {meanOf(starts)}, view().dimension()).front().points;
    Vec3 along = Vec3::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double d = distanceToSegment<3>(p, way[i - 1], way[i]);
        if (d < nearest && way[i] != way[i - 1]) nearest = d, along = (way[i] - way[i - 1]).normalized();
    }
    return along;
}

/// Returns the direction of the stroke at rest, from the ball before to the one after.
Vec3 PaintTool::directionOf(const std::vector<Dab>& dabs, std::size_t i) const {
    const StiffAlong along = brush().now().along;
    if (along == StiffAlong::Axis) return axisOf(brush().now(), view().dimension());
    if (along != StiffAlong::Stroke && along != StiffAlong::AsItIs) return dabs[i].axis;
    const std::size_t before = i > 0 ? i - 1 : 0, behind = std::min(i + 1, dabs.size() - 1);
    return dabs[behind].rest - dabs[before].rest;
}

double PaintTool::amountOf(const Dab& dab) const {
    return brush().now().amount * (brush().now().pressure ? dab.pressure : 1);
}

/// Returns the cells within the brush, at least the touched one.
std::vector<int> PaintTool::cellsIn(const Dab& dab) const {
    const std::vector<int> cells = m_material->cellsIn({dab.rest, dab.radius});
    return cells.empty() ? std::vector{dab.place.cell} : cells;
}

/// Blends the existing and the painted φ linearly on the slider.
double PaintTool::phiFor(const Dab& dab) const {
    const BrushSettings& now = brush().now();
    const auto stopAt = [this](int cell) { return stopOfPhi(m_material->phiOf(cell), view().dimension()); };
    double phi = now.phi;
    if (deed() == Deed::Smooth) {
        const auto cells = cellsIn(dab);
        double sum = 0;
        for (const int c : cells) sum += stopAt(c);
        phi = phiAtStop(sum / static_cast<double>(cells.size()), view().dimension());
    }
    const double amount = amountOf(dab);
    if (amount == 1) return phi;
    const double there = stopAt(dab.place.cell);
    return phiAtStop(there + amount * (stopOfPhi(phi, view().dimension()) - there), view().dimension());
}

Stiffness PaintTool::stiffnessFor(const std::vector<Dab>& dabs, std::size_t i) const {
    const BrushSettings& now = brush().now();
    const int cell = dabs[i].place.cell;
    const double amount = amountOf(dabs[i]);
    if (deed() == Deed::Smooth) return m_material->smoothed(cell, amount, cellsIn(dabs[i]));
    const Stiffness there = m_material->stiffnessOf(cell).value_or(Stiffness{Vec3::UnitX(), 1});
    Stiffness own{directionOf(dabs, i), now.ratio};
    if (own.axis.isZero()) own.axis = axisOf(now, view().dimension());
    if (own.axis.isZero()) own.axis = Vec3::UnitX();
    if (now.target == BrushTarget::Direction) own.ratio = std::max(own.ratio, there.ratio);
    if (now.target == BrushTarget::Stiffness && now.along == StiffAlong::AsItIs && there.ratio > kStiffFrom)
        own.axis = there.axis;
    own.axis.normalize();
    return amount == 1 ? own : m_material->blended(cell, amount, own);
}

MaterialRegion PaintTool::regionOf(const std::vector<Dab>& dabs, std::size_t i) const {
    MaterialRegion region{{ballOf(dabs[i]), featherOf(dabs[i]), partOf(dabs[i])}};
    if (brush().now().target == BrushTarget::Keep)
        region.phi = phiFor(dabs[i]);
    else
        region.stiffness = stiffnessFor(dabs, i);
    return region;
}

/// Recomputes the last ball each time, because its direction is known only once the next one exists.
Design PaintTool::painted(const std::vector<Dab>& dabs) {
    const auto& design = session().document().design();
    if (deed() == Deed::Erase) {
        std::vector<Eraser> erasers;
        for (const Dab& dab : dabs)
            erasers.push_back({ballOf(dab), featherOf(dab), amountOf(dab), dab.place.cell, partOf(dab)});
        return m_material->erased(design, erasers);
    }
    while (m_regions.size() + 1 < dabs.size()) m_regions.push_back(regionOf(dabs, m_regions.size()));
    auto regions = m_regions;
    regions.push_back(regionOf(dabs, m_regions.size()));
    return withStroke(design, m_layer, std::move(regions));
}

/// Recomputes only the cells that the stroke may change. Returns null and emits a notice if a picture of the
/// material is missing.
FramePtr PaintTool::laid(const Design& next) try {
    return m_material->with(next.material, m_first);
} catch (const InputError& error) {
    session().document().notify(QString::fromStdString(error.what()));
    return nullptr;
}

void PaintTool::follow(const std::vector<Dab>& dabs) {
    view().showMaterial(laid(painted(dabs)));
}

std::string PaintTool::aim() const {
    return deed() == Deed::Smooth ? "smooth" : brushAim(brush().now());
}

PaintedLayer PaintTool::layer() const {
    const QString kind = deed() == Deed::Smooth ? QCoreApplication::translate("PaintTool", "Smoothed")
                                                : brushKind(brush().now(), view().dimension());
    return layerFor(session().document().design(), brush().now(), brush().layer().now(), aim(),
                    kind.toStdString());
}

/// Names the step, with its place if that has a name: "Paint Rigid on Neck".
QString PaintTool::title(const std::vector<Dab>& dabs) const {
    const bool erases = deed() == Deed::Erase;
    const QString where = placeName(session().motion(), session().pins(), dabs[dabs.size() / 2].rest,
                                    erases ? std::string() : m_layer.name);
    const auto with = [&](const char* somewhere, const char* bare) {
        return where.isEmpty() ? QCoreApplication::translate("PaintTool", bare)
                               : QCoreApplication::translate("PaintTool", somewhere).arg(where);
    };
    if (erases)
        return with(QT_TRANSLATE_NOOP("PaintTool", "Erase paint from %1"),
                    QT_TRANSLATE_NOOP("PaintTool", "Erase paint"));
    if (deed() == Deed::Smooth)
        return with(QT_TRANSLATE_NOOP("PaintTool", "Smooth %1"), QT_TRANSLATE_NOOP("PaintTool", "Smooth"));
    if (brush().now().target == BrushTarget::Direction)
        return with(QT_TRANSLATE_NOOP("PaintTool", "Comb %1"), QT_TRANSLATE_NOOP("PaintTool", "Comb"));
    const QString what = brushKind(brush().now(), view().dimension());
    return where.isEmpty() ? QCoreApplication::translate("PaintTool", "Paint %1").arg(what)
                           : QCoreApplication::translate("PaintTool", "Paint %1 on %2").arg(what, where);
}

/// Emits a notice instead of adding a step without effect.
void PaintTool::take(const std::vector<Dab>& dabs) {
    const bool erases = deed() == Deed::Erase, paints = deed() == Deed::Paint;
    Design next = painted(dabs);
    if (erases) next = m_material->withoutErasedLayers(next);
    const FramePtr shown = laid(next);
    const bool same = shown && m_material->equals(*shown);
    if (same && erases)
        session().document().notify(QCoreApplication::translate("PaintTool", "Nothing is painted there"));
    const bool isBare = same && paints && paintsNothing(brush().now());
    if (isBare) session().document().notify(nothingToPaint());
    const bool changes = shown && !isBare && !(same && erases);
    view().showMaterial(changes ? shown : nullptr, changes);
    m_material.reset();
    if (!changes) return;
    const bool lost = paints && brush().now().target != BrushTarget::Keep &&
                      brush().now().along != StiffAlong::AsItIs && directionOf(dabs, 0).isZero();
    if (lost)
        session().document().notify(QCoreApplication::translate(
            "PaintTool", "There is no direction to follow: the numbers on the right were used."));
    session().document().changeDesign(title(dabs), std::move(next));
    if (!erases) brush().layer().set({m_layer.id, aim()});
}

ToolKind paintTool() {
    return toolKind("paint", "brush", QT_TRANSLATE_NOOP("Tools", "&Paint"),
                    QT_TRANSLATE_NOOP("Tools", "Paint what is kept, or how stiff it is"), "B; A", Mode::Paint,
                    both<PaintTool>(&Workbench::brush, PaintDeed::Paint),
                    {ToolOption::Target, ToolOption::Separator, ToolOption::Tip}, paintedMap, Mode::Paint);
}

ToolKind combTool() {
    return toolKind("comb", "comb", QT_TRANSLATE_NOOP("Tools", "&Comb"),
                    QT_TRANSLATE_NOOP("Tools", "Comb the direction along which the shape is stiff"), "N",
                    Mode::Paint, both<PaintTool>(&Workbench::brush, PaintDeed::Paint),
                    {ToolOption::Target, ToolOption::Separator, ToolOption::Tip}, paintedMap);
}

ToolKind eraserTool() {
    return toolKind("eraser", "eraser", QT_TRANSLATE_NOOP("Tools", "E&raser"),
                    QT_TRANSLATE_NOOP("Tools", "Erase paint: what you brush over is like the rest again"),
                    "E", Mode::Paint, both<PaintTool>(&Workbench::brush, PaintDeed::Erase), {ToolOption::Tip},
                    paintedMap);
}

}  // namespace wend
