#include "app/tools/paint/layer_lines.h"

#include <QPainterPath>
#include <QPainterPathStroker>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

using Line = std::vector<Vec2>;

constexpr int kEdgePieces = 64;
constexpr double kLineStep = 1.0 / 400;  // of the shape's extent: the shape may be bent under a line

QPainterPath pathOf(const Line& corners) {
    QPolygonF polygon;
    for (const Vec2& p : corners) polygon << QPointF(p.x(), p.y());
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

void closeInto(std::vector<Line>& lines, Line corners) {
    if (corners.empty()) return;
    corners.push_back(corners.front());
    lines.push_back(std::move(corners));
}

/// Adds both sides of the band of the soft edge.
void addBand(std::vector<Line>& lines, const Line& corners, double width) {
    if (width <= 0) return;
    QPainterPathStroker stroker;
    stroker.setWidth(width);
    stroker.setJoinStyle(Qt::RoundJoin);
    for (const QPolygonF& piece : stroker.createStroke(pathOf(corners)).simplified().toSubpathPolygons()) {
        Line line;
        for (const QPointF& p : piece) line.emplace_back(p.x(), p.y());
        closeInto(lines, std::move(line));
    }
}

/// Finds the angle at which a ring becomes covered, between an uncovered and a covered one.
template <class IsCovered>
double seam(double open, double covered, const IsCovered& isCovered) {
    for (int i = 0; i < 24; ++i) {
        const double middle = (open + covered) / 2;
        (isCovered(middle) ? covered : open) = middle;
    }
    return open;
}

/// The last region of a layer that contains a place decides whether it is painted or erased. Lines of the
/// cover follow erasers inside their borders and paint inside its borders.
struct Cover {
    const std::vector<MaterialRegion>& layer;
    double feathers;  // so many of a soft edge beyond the borders

    bool lies(const Vec2& p, std::size_t i) const {
        const double beyond = layer[i].erases() ? -feathers : feathers;
        return signedDistance<2>(inPlane(layer[i].shape), p) < beyond * layer[i].feather - 1e-9 * radius(i);
    }
    double radius(std::size_t i) const {
        const auto* ball = std::get_if<Ball<3>>(&layer[i].shape);
        return ball ? ball->radius + (layer[i].erases() ? -feathers : feathers) * layer[i].feather : 0;
    }
    /// Ignores the region whose border this is.
    bool hides(const Vec2& p, std::size_t own) const {
        for (std::size_t i = layer.size(); i-- > own + 1;)
            if (lies(p, i)) return true;
        for (std::size_t i = own; i-- > 0;)
            if (lies(p, i)) return layer[i].erases() == layer[own].erases();
        return layer[own].erases();
    }
};

/// Adds the pieces of the ring that are on the border of the whole.
void addRing(std::vector<Line>& lines, const Cover& cover, std::size_t own) {
    const auto* ball = std::get_if<Ball<3>>(&cover.layer[own].shape);
    const double radius = cover.radius(own);
    if (!ball || radius <= 0) return;
    const auto at = [&](double a) {
        return Vec2(inPlane(ball->centre) + radius * Vec2(std::cos(a), std::sin(a)));
    };
    const auto isCovered = [&](double a) { return cover.hides(at(a), own); };
    constexpr double kPiece = 2 * std::numbers::pi / kEdgePieces;
    Line piece;
    bool before = isCovered(0);
    for (int i = 0; i <= kEdgePieces; ++i) {
        const double a = kPiece * i;
        const bool now = isCovered(a);
        if (now != before)
            piece.push_back(at(now ? seam(a - kPiece, a, isCovered) : seam(a, a - kPiece, isCovered)));
        if (!now) piece.push_back(at(a));
        if (now && piece.size() > 1) lines.push_back(piece);
        if (now) piece.clear();
        before = now;
    }
    if (piece.size() > 1) lines.push_back(piece);
}

void addBalls(std::vector<Line>& lines, const std::vector<MaterialRegion>& layer, double feathers) {
    for (std::size_t i = 0; i < layer.size(); ++i) addRing(lines, Cover{layer, feathers}, i);
}

/// Returns a line through p along a direction, across the whole shape.
Line acrossAll(const Vec2& p, const Vec2& along, const SimplicialMesh<2>& rest) {
    const double reach = (rest.points.colwise() - p).colwise().norm().maxCoeff();
    const Vec2 a = along.normalized();
    return {p - reach * a, p + reach * a};
}

struct Adder {
    RestLines& lines;
    const SimplicialMesh<2>& rest;
    double feather;

    void operator()(const Ball<2>&) const {}  // balls are added together
    void operator()(const Polygon& polygon) const {
        closeInto(lines.border, polygon.points);
        addBand(lines.soft, polygon.points, feather);
    }
    void operator()(const Box<2>& box) const {
        (*this)(Polygon{{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}});
    }
    void operator()(const HalfSpace<2>& half) const {
        const Vec2 n = half.normal.normalized(), along(-n.y(), n.x());
        lines.border.push_back(acrossAll(half.point, along, rest));
        if (feather <= 0) return;
        for (const double side : {-0.5, 0.5})
            lines.soft.push_back(acrossAll(half.point + side * feather * n, along, rest));
    }
    void operator()(const Blend<2>& blend) const {
        const Vec2 n = blend.to - blend.from, along(-n.y(), n.x());
        lines.border.push_back({blend.from, blend.to});
        for (const Vec2& end : {blend.from, blend.to}) lines.soft.push_back(acrossAll(end, along, rest));
    }
};

void draw(QPainter& painter, const QPolygonF& line, const QPen& pen) {
    painter.setPen(QPen(QColor(255, 255, 255, 217), pen.widthF() + marked(2)));
    painter.drawPolyline(line);
    painter.setPen(pen);
    painter.drawPolyline(line);
}

}  // namespace

RestLines linesOf(const std::vector<MaterialRegion>& layer, const SimplicialMesh<2>& rest) {
    RestLines lines;
    addBalls(lines.border, layer, 0);
    const bool soft =
        std::any_of(layer.begin(), layer.end(), [](const auto& region) { return region.feather > 0; });
    if (soft) addBalls(lines.soft, layer, 0.5);
    if (soft) addBalls(lines.soft, layer, -0.5);
    for (const auto& region : layer)
        if (!region.erases()) std::visit(Adder{lines, rest, region.feather}, inPlane(region.shape));
    return lines;
}

std::vector<Line> carriedLine(const Line& line, const SimplicialMesh<2>& rest, const PointLocator<2>& locator,
                              const Points2& pose) {
    const double step = kLineStep * boundingBoxDiagonal<2>(rest.points);
    std::vector<Line> pieces(1);
    const auto add = [&](const Vec2& p) {
        if (const auto place = locator.find(p))
            pieces.back().push_back(positionOf<2>(*place, rest, pose));
        else if (!pieces.back().empty())
            pieces.emplace_back();
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 way = line[i + 1] - line[i];
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / step)));
        for (int k = 0; k < steps; ++k) add(line[i] + way * k / steps);
    }
    if (!line.empty()) add(line.back());
    std::erase_if(pieces, [](const Line& piece) { return piece.size() < 2; });
    return pieces;
}

void RegionLines::setRegions(std::vector<MaterialRegion> regions) {
    m_regions = std::move(regions);
    m_rest.reset();
}

void RegionLines::setRegions(const std::vector<SoftRegion>& regions) {
    std::vector<MaterialRegion> all;
    for (const SoftRegion& region : regions) all.push_back({region});
    setRegions(std::move(all));
}

void RegionLines::paint(QPainter& painter, PictureShapeView& view) {
    const auto frame = view.session().motion().frame<2>();
    if (m_regions.empty() || !frame) return;
    if (m_rest != frame->rest) m_lines = linesOf(m_regions, *frame->rest);
    m_rest = frame->rest;
    const PointLocator<2> locator(frame->rest->points, frame->rest->cells);
    const auto drawAll = [&](const std::vector<Line>& lines, const QPen& pen) {
        for (const Line& line : lines)
            for (const Line& piece : carriedLine(line, *frame->rest, locator, frame->pose)) {
                QPolygonF seen;
                for (const Vec2& p : piece) seen << view.toWidget(p);
                draw(painter, seen, pen);
            }
    };
    painter.setBrush(Qt::NoBrush);
    drawAll(m_lines.soft, QPen(QColor(kAccent), marked(1), Qt::DashLine));
    drawAll(m_lines.border, QPen(QColor(kAccent), marked(2)));
}

void RegionLines::paint(QPainter& painter, SolidShapeView& view) const {
    if (!view.shownFrame()) return;
    std::vector<Region<3>> shapes;
    for (const MaterialRegion& region : m_regions)
        if (!region.erases()) shapes.push_back(region.shape);
    paintRegions(painter, view, shapes, QPen(QColor(kAccent), marked(1.5), Qt::DashLine));
}

void LayerLines::paint(QPainter& painter, PictureShapeView& view) {
    takeLayer(view.session().document());
    m_lines.paint(painter, view);
}

void LayerLines::paint(QPainter& painter, SolidShapeView& view) {
    takeLayer(view.session().document());
    m_lines.paint(painter, view);
}

void LayerLines::takeLayer(const Document& document) {
    const auto& project = document.project();
    if (m_project == project && m_drawn == m_layer) return;
    const MaterialLayer* layer = project ? layerOf(document.design().material.layers, m_layer) : nullptr;
    m_lines.setRegions(layer ? layer->regions : std::vector<MaterialRegion>());
    m_project = project, m_drawn = m_layer;
}

}  // namespace wend
