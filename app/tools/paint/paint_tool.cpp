#include "app/tools/paint/paint_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/engine/motion/pose_places.h"
#include "app/engine/shape/erasing.h"
#include "app/engine/shape/material_raster.h"
#include "app/project/design.h"
#include "app/style/colours.h"
#include "app/tools/paint/brush_paint.h"
#include "core/base/error.h"
#include "core/mesh/segments.h"

namespace wend {

namespace {

constexpr double kStiffFrom = 1.01;     // less is as everywhere
constexpr double kSameMaterial = 1e-9;  // relative to the material
constexpr QRgb kEraser = 0xff5c5f69;

template <int Dim>
Vec<Dim> centroidOf(const SimplicialMesh<Dim>& mesh, int cell) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const int v : mesh.cells[cell]) sum += mesh.points.col(v) / (Dim + 1);
    return sum;
}

template <int Dim>
Mat<Dim> anisotropyAt(const Material<Dim>& material, int cell) {
    return material.anisotropy.empty() ? Mat<Dim>(Mat<Dim>::Identity()) : material.anisotropy[cell];
}

/// No stiffness is stiffness ×1.
template <int Dim>
bool isSame(const Material<Dim>& a, const Material<Dim>& b) {
    for (std::size_t c = 0; c < a.phi.size(); ++c) {
        const int cell = static_cast<int>(c);
        if (std::abs(a.phi[c] - b.phi[c]) > kSameMaterial) return false;
        if ((anisotropyAt(a, cell) - anisotropyAt(b, cell)).norm() > kSameMaterial) return false;
    }
    return true;
}

}  // namespace

template <int Dim>
QString PaintTool<Dim>::strokeHint() const {
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

template <int Dim>
QColor PaintTool<Dim>::colour() const {
    return m_deed == Deed::Erase ? kEraser : brushColour(brush().now(), Dim);
}

template <int Dim>
typename PaintTool<Dim>::Deed PaintTool<Dim>::deed() const {
    if (m_deed == Deed::Erase || (this->modifiers() & Qt::ControlModifier)) return Deed::Erase;
    return this->modifiers() & Qt::ShiftModifier ? Deed::Smooth : Deed::Paint;
}

template <int Dim>
void PaintTool<Dim>::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !(event.modifiers() & Qt::AltModifier)) {
        StrokeTool<Dim>::press(event);
        return;
    }
    const auto frame = surface().shownFrame();
    const auto touch = surface().touch(event.position());
    if (frame && touch) pickMaterial<Dim>(*frame, touch->place.cell, brush());
}

template <int Dim>
void PaintTool<Dim>::begin() {
    const auto& design = session().document().design();
    m_frame = surface().shownFrame();
    m_layer = layer();
    m_regions.clear();
    m_first = deed() == Deed::Erase ? 0 : layerBegin(design, m_layer);
    m_below.reset();
}

/// Maps directions of the view back to rest.
template <int Dim>
Vec<Dim> PaintTool<Dim>::axisAt(const PosedFrame<Dim>& frame, const Touch<Dim>& touch) const {
    Vec<Dim> seen = Vec<Dim>::Zero();
    if constexpr (Dim == 3)
        if (brush().now().along == StiffAlong::View) seen = surface().viewDirection();
    if (brush().now().along == StiffAlong::Way) seen = wayAt(touch.point);
    return cellRotation<Dim>(frame, touch.place.cell).transpose() * seen;
}

/// Returns the direction of the selected handle's path at its nearest point; zero without one.
template <int Dim>
Vec<Dim> PaintTool<Dim>::wayAt(const Vec<Dim>& p) const {
    const int selected = session().singleHandle();
    if (selected < 0) return Vec<Dim>::Zero();
    const auto starts = session().template pathStarts<Dim>(selected);
    if (starts.empty()) return Vec<Dim>::Zero();
    const auto& handle = session().document().design().handles[selected];
    const auto way = pinPaths<Dim>(handle, {meanOf<Dim>(starts)}).front().points;
    Vec<Dim> along = Vec<Dim>::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double d = distanceToSegment<Dim>(p, way[i - 1], way[i]);
        if (d < nearest && way[i] != way[i - 1]) nearest = d, along = (way[i] - way[i - 1]).normalized();
    }
    return along;
}

/// Returns the direction of the stroke at rest, from the ball before to the one after.
template <int Dim>
Vec<Dim> PaintTool<Dim>::directionOf(const std::vector<Dab>& dabs, std::size_t i) const {
    const StiffAlong along = brush().now().along;
    if (along == StiffAlong::Axis) return brush().now().axis.template head<Dim>();
    if (along != StiffAlong::Stroke && along != StiffAlong::AsItIs) return dabs[i].axis;
    const std::size_t before = i > 0 ? i - 1 : 0, behind = std::min(i + 1, dabs.size() - 1);
    return dabs[behind].rest - dabs[before].rest;
}

template <int Dim>
Mat<Dim> PaintTool<Dim>::thereAt(const Dab& dab) const {
    return anisotropyAt(*m_frame->material, dab.place.cell);
}

template <int Dim>
double PaintTool<Dim>::amountOf(const Dab& dab) const {
    return brush().now().amount * (brush().now().pressure ? dab.pressure : 1);
}

/// Returns the cells within the brush, at least the touched one.
template <int Dim>
std::vector<int> PaintTool<Dim>::cellsIn(const Dab& dab) const {
    std::vector<int> cells;
    for (int c = 0; c < m_frame->rest->cellCount(); ++c)
        if ((centroidOf(*m_frame->rest, c) - dab.rest).norm() <= dab.radius) cells.push_back(c);
    if (cells.empty()) cells.push_back(dab.place.cell);
    return cells;
}

/// Blends the existing and the painted φ linearly on the slider.
template <int Dim>
double PaintTool<Dim>::phiFor(const Dab& dab) const {
    const BrushSettings& now = brush().now();
    const auto stopAt = [this](int cell) { return stopOfPhi(m_frame->material->phi[cell], Dim); };
    double phi = now.phi;
    if (deed() == Deed::Smooth) {
        const auto cells = cellsIn(dab);
        double sum = 0;
        for (const int c : cells) sum += stopAt(c);
        phi = phiAtStop(sum / static_cast<double>(cells.size()), Dim);
    }
    const double amount = amountOf(dab);
    if (amount == 1) return phi;
    const double there = stopAt(dab.place.cell);
    return phiAtStop(there + amount * (stopOfPhi(phi, Dim) - there), Dim);
}

template <int Dim>
Stiffness PaintTool<Dim>::stiffnessFor(const std::vector<Dab>& dabs, std::size_t i) const {
    const BrushSettings& now = brush().now();
    const Mat<Dim> B = thereAt(dabs[i]);
    const Stiffness there = stiffnessOf<Dim>(B);
    const bool isStiff = there.ratio > kStiffFrom;
    const double amount = amountOf(dabs[i]);
    Mat<Dim> aim = Mat<Dim>::Identity();
    if (deed() == Deed::Smooth) {
        const auto cells = cellsIn(dabs[i]);
        aim.setZero();
        for (const int c : cells)
            aim += anisotropyAt(*m_frame->material, c) / static_cast<double>(cells.size());
    }
    if (deed() == Deed::Paint) {
        Stiffness own{inSpace(directionOf(dabs, i)), now.ratio};
        if (own.axis.isZero()) own.axis = inSpace(Vec<Dim>(now.axis.template head<Dim>()));
        if (own.axis.isZero()) own.axis = Vec3::UnitX();
        if (now.target == BrushTarget::Direction) own.ratio = std::max(own.ratio, there.ratio);
        if (now.target == BrushTarget::Stiffness && now.along == StiffAlong::AsItIs && isStiff)
            own.axis = there.axis;
        own.axis.normalize();
        if (amount == 1) return own;
        aim = anisotropyOf<Dim>(own);
    }
    return stiffnessOf<Dim>((1 - amount) * B + amount * aim);
}

template <int Dim>
MaterialRegion PaintTool<Dim>::regionOf(const std::vector<Dab>& dabs, std::size_t i) const {
    MaterialRegion region{{}, inSpace(Region<Dim>(this->ballOf(dabs[i]))), this->featherOf(dabs[i]), {}, {}};
    region.part = this->partOf(dabs[i]);
    if (brush().now().target == BrushTarget::Keep)
        region.phi = phiFor(dabs[i]);
    else
        region.stiffness = stiffnessFor(dabs, i);
    return region;
}

/// A ball's direction is known once the next one exists, so the last one is recomputed each time.
template <int Dim>
Design PaintTool<Dim>::painted(const std::vector<Dab>& dabs) {
    const auto& design = session().document().design();
    if (deed() == Deed::Erase) {
        std::vector<Eraser> erasers;
        for (const Dab& dab : dabs)
            erasers.push_back({inSpace(Region<Dim>(this->ballOf(dab))), this->featherOf(dab), amountOf(dab),
                               dab.place.cell, this->partOf(dab)});
        return withErased<Dim>(design, erasers, *m_frame->rest, folder());
    }
    while (m_regions.size() + 1 < dabs.size()) m_regions.push_back(regionOf(dabs, m_regions.size()));
    auto regions = m_regions;
    regions.push_back(regionOf(dabs, m_regions.size()));
    return withStroke(design, m_layer, std::move(regions));
}

/// Recomputes only the cells that the stroke may change. Returns null and emits a notice if a picture of the
/// material is missing.
template <int Dim>
std::shared_ptr<const Material<Dim>> PaintTool<Dim>::laid(const Design& next) try {
    const SimplicialMesh<Dim>& rest = *m_frame->rest;
    if (!m_below) {
        MaterialSpec below = session().document().design().material;
        below.regions.resize(m_first);
        m_below = rasterizeMaterial<Dim>(below, rest, folder());
    }
    auto material = std::make_shared<Material<Dim>>(*m_below);
    layRegions<Dim>(std::span(next.material.regions).subspan(m_first), rest, folder(), *material);
    return material;
} catch (const InputError& error) {
    session().notify(QString::fromStdString(error.what()));
    return nullptr;
}

template <int Dim>
void PaintTool<Dim>::follow(const std::vector<Dab>& dabs) {
    surface().showMaterial(laid(painted(dabs)));
}

template <int Dim>
std::string PaintTool<Dim>::aim() const {
    return deed() == Deed::Smooth ? "smooth" : brushAim(brush().now());
}

template <int Dim>
std::string PaintTool<Dim>::layer() const {
    const QString kind = deed() == Deed::Smooth ? QCoreApplication::translate("PaintTool", "Smoothed")
                                                : brushKind(brush().now(), Dim);
    return layerFor<Dim>(session().document().design(), brush().now(), brush().layer().now(), aim(),
                         kind.toStdString());
}

/// Names the step, with its place if that has a name: "Paint Rigid on Neck".
template <int Dim>
QString PaintTool<Dim>::title(const std::vector<Dab>& dabs) const {
    const bool erases = deed() == Deed::Erase;
    const QString where =
        placeName<Dim>(session(), dabs[dabs.size() / 2].rest, erases ? std::string() : m_layer);
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
    const QString what = brushKind(brush().now(), Dim);
    return where.isEmpty() ? QCoreApplication::translate("PaintTool", "Paint %1").arg(what)
                           : QCoreApplication::translate("PaintTool", "Paint %1 on %2").arg(what, where);
}

/// Emits a notice instead of adding a step without effect.
template <int Dim>
void PaintTool<Dim>::take(const std::vector<Dab>& dabs) {
    const bool erases = deed() == Deed::Erase, paints = deed() == Deed::Paint;
    Design next = painted(dabs);
    if (erases) next = withoutErasedLayers<Dim>(next, *m_frame->rest, folder());
    const auto material = laid(next);
    const bool same = material && isSame(*material, *m_frame->material);
    if (same && erases)
        session().notify(QCoreApplication::translate("PaintTool", "Nothing is painted there"));
    const bool isBare = same && paints && paintsNothing(brush().now());
    if (isBare) session().notify(nothingToPaint());
    const bool changes = material && !isBare && !(same && erases);
    surface().showMaterial(changes ? material : nullptr, changes);
    m_frame.reset();
    if (!changes) return;
    const bool lost = paints && brush().now().target != BrushTarget::Keep &&
                      brush().now().along != StiffAlong::AsItIs && directionOf(dabs, 0).isZero();
    if (lost)
        session().notify(QCoreApplication::translate(
            "PaintTool", "There is no direction to follow: the numbers on the right were used."));
    session().document().changeDesign(title(dabs), std::move(next));
    if (!erases) brush().layer().set({m_layer, aim()});
}

template class PaintTool<2>;
template class PaintTool<3>;

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
