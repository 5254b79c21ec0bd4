#include "app/tools/pins/onion_skin.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/engine/shape/shape.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "core/base/error.h"
#include "core/meshing/outline_combination.h"
#include "warp/outline.h"

namespace wend {

namespace {

constexpr int kEachWay = 3;
constexpr double kSkinSpacing = 0.1;  // of the film
const QColor kPast(0xd9, 0x82, 0x2b), kFuture(0x1e, 0x8f, 0xb5);
constexpr double kTints[kEachWay] = {0.18, 0.12, 0.06};
constexpr double kOutlineWidth = 1.5;          // pixels
constexpr double kLineStrength = 3.5;          // of an outline, against the tint
constexpr std::size_t kMostTriangles = 60000;  // of an embedded surface; of a finer one the solid is shown

constexpr double kSeen = 0.5;  // alpha above which a pixel counts as drawn

/// Returns closed lines along the edges of a boundary, with each edge once.
std::vector<std::vector<int>> loopsOf(const std::vector<Facet<2>>& edges) {
    std::multimap<int, int> next;
    for (const Facet<2>& edge : edges) next.emplace(edge.vertices[0], edge.vertices[1]);
    std::vector<std::vector<int>> loops;
    while (!next.empty()) {
        std::vector<int> loop;
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            loop.push_back(at->second);
            next.erase(at);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// Returns the drawing's outline without the margin; empty if the picture is opaque.
Outline drawingOf(const Image& picture) {
    Outline drawing;
    if (!picture.alpha) return drawing;
    AlphaOutlineOptions options;
    options.margin = options.gap = 0;
    for (const double threshold : {kSeen, options.threshold}) {
        options.threshold = threshold;
        try {
            return outlineFromAlpha(picture, options);
        } catch (const InputError&) {  // it is fainter, or there is nothing
        }
    }
    return drawing;
}

double lengthOf(const std::vector<Vec2>& loop) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    return length;
}

/// Appends points close enough to follow the deformation.
void appendDense(std::vector<Vec2>& points, const std::vector<Vec2>& loop, double step) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 way = loop[(i + 1) % loop.size()] - loop[i];
        const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / step)));
        for (int k = 0; k < parts; ++k) points.emplace_back(loop[i] + way * k / parts);
    }
}

}  // namespace

template <int Dim>
std::vector<typename OnionSkin<Dim>::Layer> OnionSkin<Dim>::layers(const ShapeMotion& motion,
                                                                   const Playback& playback) const {
    std::vector<Layer> layers;
    const auto shown = motion.frame<Dim>();
    if (!m_shown || !shown || playback.isPlaying() || playback.end() <= 0) return layers;
    for (int k = kEachWay; k > 0; --k)
        for (const int side : {-1, 1}) {
            const double time = playback.time() + side * k * kSkinSpacing * playback.end();
            if (time < 0 || time > playback.end()) continue;
            const auto frame = posed<Dim>(motion.track().at(time));
            if (!frame || frame->rest != shown->rest) continue;
            QColor colour = side < 0 ? kPast : kFuture;
            colour.setAlphaF(static_cast<float>(kTints[k - 1]));
            layers.push_back({frame, colour});
        }
    return layers;
}

template <int Dim>
void OnionSkin<Dim>::takeBoundary(const PosedFrame<Dim>& frame) {
    if (std::exchange(m_rest, frame.rest) == frame.rest) return;
    std::vector<Facet<Dim>> facets = facetsOf<Dim>(*m_rest);
    std::erase_if(facets, [](const Facet<Dim>& facet) { return facet.interior(); });
    if constexpr (Dim == 2) {
        m_loops = loopsOf(facets);
        takeDrawing(*frame.built);
    } else {
        const auto& skin = frame.built->skin;
        m_isEmbedded = skin && frame.built->embedding && skin->triangles.size() <= kMostTriangles;
        m_triangles.clear();
        for (const Facet<3>& facet : facets) m_triangles.push_back(facet.vertices);
        if (m_isEmbedded) m_triangles = skin->triangles;
        std::map<std::pair<int, int>, Edge> edges;
        for (int f = 0; f < static_cast<int>(m_triangles.size()); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& t = m_triangles[static_cast<std::size_t>(f)];
                const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
                const auto [at, isNew] = edges.try_emplace({a, b}, Edge{a, b, {f, -1}});
                if (!isNew) at->second.sides[1] = f;
            }
        m_edges.clear();
        for (const auto& [ends, edge] : edges) m_edges.push_back(edge);
    }
}

/// Replaces the mesh boundary by the opaque part of the picture inside it.
template <int Dim>
void OnionSkin<Dim>::takeDrawing(const Shape<Dim>& shape) {
    m_drawn.reset();
    if constexpr (Dim == 2) {
        const bool hasParts = shape.texture && shape.texture->drawn;
        Outline drawing = shape.picture && !hasParts ? drawingOf(*shape.picture) : Outline();
        if (drawing.loops.empty()) return;
        const SimplicialMesh<2>& rest = restInPixels(shape);
        Outline boundary;
        double length = 0;
        std::size_t edges = 0;
        for (const Loop& loop : m_loops) {
            auto& line = boundary.loops.emplace_back();
            for (const int v : loop) line.emplace_back(rest.points.col(v));
            length += lengthOf(line);
            edges += line.size();
        }
        drawing = combined(drawing, boundary, OutlineOperation::Keep);
        std::vector<Vec2> points;
        m_loops.clear();
        for (const auto& line : drawing.loops) {
            const auto first = static_cast<int>(points.size());
            appendDense(points, line, length / static_cast<double>(edges));
            m_loops.emplace_back(points.size() - static_cast<std::size_t>(first));
            std::iota(m_loops.back().begin(), m_loops.back().end(), first);
        }
        Points2 columns(2, static_cast<Eigen::Index>(points.size()));
        for (Eigen::Index i = 0; i < columns.cols(); ++i)
            columns.col(i) = points[static_cast<std::size_t>(i)];
        m_drawn = std::make_shared<const Embedding<2>>(rest, columns);
    }
}

/// Returns in the plane the outline of the drawing or the boundary, in space the silhouette edges.
template <int Dim>
std::vector<QPolygonF> OnionSkin<Dim>::outline(const PosedFrame<Dim>& frame, ShapeView& view) const {
    Points<Dim> points = frame.pose;
    if constexpr (Dim == 2)
        if (m_drawn) points = m_drawn->interpolate(restInPixels(*frame.built), frame.pose);
    if constexpr (Dim == 3)
        if (m_isEmbedded) points = frame.built->embedding->carry(*frame.rest, frame.pose);
    std::vector<QPointF> at;
    for (Eigen::Index v = 0; v < points.cols(); ++v)
        at.push_back(view.onScreen(inSpace(Vec<Dim>(points.col(v)))));
    const auto place = [&at](int v) { return at[static_cast<std::size_t>(v)]; };
    std::vector<QPolygonF> lines;
    for (const Loop& loop : m_loops) {
        QPolygonF line;
        for (const int v : loop) line << place(v);
        line << line.first();
        lines.push_back(std::move(line));
    }
    std::vector<bool> faces;
    for (const auto& t : m_triangles) {
        const QPointF a = place(t[0]), u = place(t[1]) - a, v = place(t[2]) - a;
        faces.push_back(u.x() * v.y() - u.y() * v.x() < 0);
    }
    for (const Edge& edge : m_edges)
        if (edge.sides[1] < 0 ||
            faces[static_cast<std::size_t>(edge.sides[0])] != faces[static_cast<std::size_t>(edge.sides[1])])
            lines.push_back(QPolygonF({place(edge.from), place(edge.to)}));
    return lines;
}

template <int Dim>
void OnionSkin<Dim>::paintFills(QPainter& painter, ShapeView& view) {
    painter.setPen(Qt::NoPen);
    for (const Layer& layer : layers(view.session().motion(), view.session().playback())) {
        takeBoundary(*layer.frame);
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        for (const QPolygonF& line : outline(*layer.frame, view)) path.addPolygon(line);
        painter.fillPath(path, layer.colour);
    }
}

template <int Dim>
void OnionSkin<Dim>::paintOutlines(QPainter& painter, ShapeView& view) {
    painter.setBrush(Qt::NoBrush);
    for (const Layer& layer : layers(view.session().motion(), view.session().playback())) {
        takeBoundary(*layer.frame);
        QColor colour = layer.colour;
        colour.setAlphaF(static_cast<float>(kLineStrength) * colour.alphaF());
        painter.setPen(QPen(colour, kOutlineWidth));
        for (const QPolygonF& line : outline(*layer.frame, view)) painter.drawPolyline(line);
    }
}

template <int Dim>
void OnionSkin<Dim>::paintRim(QPainter& painter, ShapeView& view, const PosedFrame<Dim>& frame) {
    takeBoundary(frame);
    painter.setPen(QPen(QColor::fromRgba(kRim), kRimWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const QPolygonF& line : outline(frame, view)) painter.drawPolyline(line);
}

template class OnionSkin<2>;
template class OnionSkin<3>;

}  // namespace wend
