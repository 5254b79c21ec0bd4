#include "app/tools/pins/curve_editor.h"

#include <QCoreApplication>
#include <QLineF>
#include <algorithm>
#include <utility>

#include "app/project/design.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"

namespace wend {

namespace {

constexpr double kCurvePointReach = 8;  // pixels, of points
constexpr double kLineReach = 6;        // pixels, of the curve
constexpr int kSearchSamples = 48;      // of a piece, to look for the place nearest to the pointer
const QColor kCurveColour(0xd4, 0x7a, 0x1e);

}  // namespace

QString curveHint(bool onPoint) {
    return onPoint
               ? QCoreApplication::translate(
                     "CurveEditor",
                     "Drag the curve's point, Shift keeps it straight, Ctrl moves one "
                     "direction only; Delete removes it, a right-click shows more")
               : QCoreApplication::translate("CurveEditor", "Double-click to insert a point into the curve");
}

int CurveEditor::handle() const {
    const int handle = m_view.session().document().dimension() == m_view.dimension()
                           ? m_view.session().selection().single()
                           : -1;
    return handle >= 0 && m_view.session().pins().isLocked(handle) ? -1 : handle;
}

std::optional<CurveMotion<3>> CurveEditor::curve() const {
    if (handle() < 0 || !m_view.session().motion().frame()) return {};
    const CurveMotion<3>* last = lastCurve(m_view.session().document().design(), handle());
    return last ? std::optional(*last) : std::nullopt;
}

CurveEditor::Chosen CurveEditor::identity() const {
    const auto own = curve();
    if (!own) return {};
    return {handle(), static_cast<int>(own->points.size()), own->points.front()};
}

void CurveEditor::forgetOthers() const {
    if (identity() == m_of) return;
    m_of = identity();
    m_chosen = -1;
    m_free.clear();
}

int CurveEditor::chosen() const {
    forgetOthers();
    return m_chosen;
}

/// Returns the offset from the stored curve to the handle's actual place at its start.
Vec3 CurveEditor::shift() const {
    Pin before = m_view.session().document().design().handles[handle()];
    const auto curve = std::get<CurveMotion<3>>(before.motions.back().kind);
    before.motions.pop_back();
    const auto starts = m_view.session().pins().pathStarts(handle());
    if (starts.empty()) return Vec3::Zero();
    return pinPaths(before, {meanOf(starts)}, m_view.dimension()).front().points.back() -
           curve.points.front();
}

std::vector<JointKind> CurveEditor::kinds(const CurveMotion<3>& curve) const {
    if (curve.interpolation != Interpolation::Bezier) return {};
    forgetOthers();
    auto kinds = jointKinds(curve.points);
    for (const int joint : m_free)
        if (joint < static_cast<int>(kinds.size())) kinds[joint] = JointKind::Free;
    if (m_freely && isDragging()) kinds[jointOf(m_dragged)] = JointKind::Free;
    return kinds;
}

/// Returns the control points, including the dragged one.
std::vector<Vec3> CurveEditor::moved(const CurveMotion<3>& curve) const {
    std::vector<Vec3> points = curve.points;
    if (!isDragging() || m_dragged >= static_cast<int>(points.size())) return points;
    if (curve.interpolation == Interpolation::Bezier)
        return withMovedPoint(std::move(points), kinds(curve), m_dragged, m_by);
    points[m_dragged] += m_by;
    return points;
}

std::vector<Vec3> CurveEditor::points() const {
    const auto own = curve();
    if (!own) return {};
    std::vector<Vec3> points = moved(*own);
    const Vec3 by = shift();
    for (Vec3& p : points) p += by;
    return points;
}

bool CurveEditor::isDragging() const {
    return m_dragged >= 0 && m_draggedOf == m_view.session().document().project();
}

int CurveEditor::pointAt(const QPointF& widget) const {
    const auto all = points();
    int best = -1;
    double nearest = marked(kCurvePointReach);
    for (int i = 1; i < static_cast<int>(all.size()); ++i) {
        const double d = QLineF(m_view.onScreen(all[i]), widget).length();
        if (d < nearest) nearest = d, best = i;
    }
    return best;
}

CurveEditor::Place CurveEditor::placeAt(const QPointF& widget) const {
    Place best{-1, 0, marked(kLineReach)};
    const auto own = curve();
    if (!own) return best;
    const Vec3 by = shift();
    const auto pieces = curveOf(*own).pieces;
    for (int k = 0; k < static_cast<int>(pieces.size()); ++k) {
        QPointF before = m_view.onScreen(pieces[k].value(0) + by);
        for (int i = 1; i <= kSearchSamples; ++i) {
            const QPointF after = m_view.onScreen(pieces[k].value(double(i) / kSearchSamples) + by);
            const QPointF along = after - before;
            const double size = QPointF::dotProduct(along, along);
            const double t =
                size > 0 ? std::clamp(QPointF::dotProduct(widget - before, along) / size, 0.0, 1.0) : 0;
            const double d = QLineF(widget, before + t * along).length();
            if (d < best.distance) best = {k, (i - 1 + t) / kSearchSamples, d};
            before = after;
        }
    }
    best.v = std::clamp(best.v, 0.02, 0.98);
    return best;
}

void CurveEditor::choose(int point) {
    forgetOthers();
    m_chosen = point;
    m_place.reset();  // of a menu that was opened for something else
}

void CurveEditor::begin(int point, const QPointF& widget) {
    choose(point);
    m_dragged = point;
    m_draggedOf = m_view.session().document().project();
    m_freely = false;
    m_from = widget;
    m_by.setZero();
    m_view.redraw();
}

void CurveEditor::drag(const QPointF& widget, bool freely) {
    const auto own = curve();
    if (!own || !isDragging() || m_dragged >= static_cast<int>(own->points.size())) return;
    m_freely = freely;
    const Vec3 p = own->points[m_dragged] + shift();
    m_by = acrossTheScreen(m_view, p, widget) - acrossTheScreen(m_view, p, m_from);
    m_view.redraw();
}

void CurveEditor::change(const QString& name, CurveMotion<3> next) {
    Design design = m_view.session().document().design();
    *lastCurve(design, handle()) = std::move(next);
    m_view.session().document().changeDesign(name, std::move(design));
    m_view.redraw();
}

void CurveEditor::finish() {
    auto own = curve();
    if (own && isDragging() && !m_by.isZero()) {
        own->points = moved(*own);
        m_dragged = -1;
        change(QCoreApplication::translate("CurveEditor", "Change curve"), *own);
    }
    cancel();
}

void CurveEditor::cancel() {
    m_dragged = -1;
    m_draggedOf.reset();
    m_freely = false;
    m_by.setZero();
}

void CurveEditor::insertOn(const Place& place) {
    const auto own = curve();
    if (!own || place.piece < 0 || place.piece >= static_cast<int>(curveOf(*own).pieces.size())) return;
    const bool bezier = own->interpolation == Interpolation::Bezier;
    change(QCoreApplication::translate("CurveEditor", "Insert curve point"),
           withPointOn(*own, place.piece, place.v));
    forgetOthers();
    m_chosen = bezier ? 3 * place.piece + 3 : place.piece + 1;
    m_view.redraw();
}

bool CurveEditor::insertAt(const QPointF& widget) {
    const Place place = placeAt(widget);
    if (place.piece < 0) return false;
    insertOn(place);
    return true;
}

bool CurveEditor::pointAtForMenu(const QPointF& widget) {
    m_place.reset();
    if (const int point = pointAt(widget); point > 0) {
        forgetOthers();
        m_chosen = point;
        m_view.redraw();
        return true;
    }
    const Place place = placeAt(widget);
    if (place.piece >= 0) m_place = place;
    return place.piece >= 0;
}

std::optional<JointKind> CurveEditor::chosenKind() const {
    const auto own = curve();
    if (!own || own->interpolation != Interpolation::Bezier || chosen() < 0) return {};
    const int joint = jointOf(chosen());
    if (!isInnerJoint(own->points, joint)) return {};
    return kinds(*own)[joint];
}

bool CurveEditor::canRemove() const {
    const auto own = curve();
    return own && chosen() > 0 && withoutPoint(*own, chosen());
}

void CurveEditor::insertPoint() {
    const auto own = curve();
    if (!own) return;
    const Place behind{pieceBehind(*own, chosen()), 0.5, 0};
    insertOn(std::exchange(m_place, std::nullopt).value_or(behind));
}

void CurveEditor::removePoint() {
    const auto own = curve();
    const auto next = own && chosen() > 0 ? withoutPoint(*own, chosen()) : std::nullopt;
    if (next)
        change(QCoreApplication::translate("CurveEditor", "Delete curve point"), *next);
    else if (own && chosen() > 0)
        m_view.session().document().notify(
            QCoreApplication::translate("CurveEditor", "The ends of a curve must stay."));
}

void CurveEditor::setKind(JointKind kind) {
    auto own = curve();
    if (!own || !chosenKind()) return;
    const int joint = jointOf(chosen());
    std::erase(m_free, joint);
    if (kind == JointKind::Free) {
        m_free.push_back(joint);  // nothing moves: it is for the next drag
        m_view.redraw();
        return;
    }
    auto points = withJointKind(own->points, joint, kind);
    if (points == own->points) return;
    own->points = std::move(points);
    change(QCoreApplication::translate("CurveEditor", "Change curve"), *own);
}

/// Draws the resulting curve while a point is dragged.
void CurveEditor::paintMoved(QPainter& painter) const {
    auto own = curve();
    own->points = moved(*own);
    const Vec3 by = shift();
    QPolygonF line;
    for (const auto& piece : curveOf(*own).pieces)
        for (int i = 0; i <= kSearchSamples; ++i)
            line << m_view.onScreen(piece.value(double(i) / kSearchSamples) + by);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kCurveColour, marked(1.75)));
    painter.drawPolyline(line);
}

void CurveEditor::paint(QPainter& painter, const QPointF& pointer) const {
    const auto all = points();
    if (all.empty()) return;
    if (isDragging()) paintMoved(painter);
    QPolygonF screen;
    for (const Vec3& p : all) screen << m_view.onScreen(p);
    const bool bezier = curve()->interpolation == Interpolation::Bezier;
    painter.setPen(QPen(kCurveColour, marked(1.25)));
    for (int i = 0; bezier && i + 3 < screen.size(); i += 3) {  // from the joints to their directions
        painter.drawLine(screen[i], screen[i + 1]);
        painter.drawLine(screen[i + 2], screen[i + 3]);
    }
    for (int i = 1; i < screen.size(); ++i) {
        const double r = marked(QLineF(screen[i], pointer).length() < marked(kCurvePointReach) ? 5.5 : 4.5);
        painter.setPen(
            QPen(i == chosen() ? QColor(kAccent) : QColor(Qt::white), marked(i == chosen() ? 2.25 : 1.25)));
        painter.setBrush(i == chosen() ? QColor(Qt::white) : kCurveColour);
        if (bezier && i % 3 == 0)
            painter.drawRect(QRectF(screen[i].x() - r, screen[i].y() - r, 2 * r, 2 * r));
        else
            painter.drawEllipse(screen[i], r, r);
    }
}

}  // namespace wend
