#include "app/tools/onion_skin.h"

#include <QPainterPath>
#include <algorithm>
#include <map>

#include "app/session/shape.h"

namespace wend {

namespace {

constexpr int kEachWay = 3;
constexpr double kSpacing = 0.1;  // of the film
const QColor kPast(0xd9, 0x82, 0x2b), kFuture(0x1e, 0x8f, 0xb5);
constexpr double kTints[kEachWay] = {0.18, 0.12, 0.06};
constexpr double kLine = 1.5;                  // pixels
constexpr double kLineStrength = 3.5;          // of an outline, against the tint
constexpr std::size_t kMostTriangles = 60000;  // of an embedded surface; of a finer one the solid is shown

/// Closed lines along the edges of a boundary, each edge once.
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

}  // namespace

template <int Dim>
std::vector<typename OnionSkin<Dim>::Layer> OnionSkin<Dim>::layers(ShapeSession& session) const {
    std::vector<Layer> layers;
    const auto shown = session.frame<Dim>();
    const Playback& playback = session.playback();
    if (!m_shown || !shown || playback.isPlaying() || playback.end() <= 0) return layers;
    for (int k = kEachWay; k > 0; --k)
        for (const int side : {-1, 1}) {
            const double time = playback.time() + side * k * kSpacing * playback.end();
            if (time < 0 || time > playback.end()) continue;
            const auto frame = posed<Dim>(session.track().at(time));
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

/// In the plane the boundary; of a solid the edges between what faces the viewer and what does not.
template <int Dim>
std::vector<QPolygonF> OnionSkin<Dim>::outline(const PosedFrame<Dim>& frame, SurfaceOf<Dim>& surface) const {
    Points<Dim> points = frame.pose;
    if constexpr (Dim == 3)
        if (m_isEmbedded) points = frame.built->embedding->carry(*frame.rest, frame.pose);
    std::vector<QPointF> at;
    for (Eigen::Index v = 0; v < points.cols(); ++v) at.push_back(surface.toWidget(points.col(v)));
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
void OnionSkin<Dim>::paintFills(QPainter& painter, SurfaceOf<Dim>& surface) {
    painter.setPen(Qt::NoPen);
    for (const Layer& layer : layers(surface.session())) {
        takeBoundary(*layer.frame);
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        for (const QPolygonF& line : outline(*layer.frame, surface)) path.addPolygon(line);
        painter.fillPath(path, layer.colour);
    }
}

template <int Dim>
void OnionSkin<Dim>::paintOutlines(QPainter& painter, SurfaceOf<Dim>& surface) {
    painter.setBrush(Qt::NoBrush);
    for (const Layer& layer : layers(surface.session())) {
        takeBoundary(*layer.frame);
        QColor colour = layer.colour;
        colour.setAlphaF(static_cast<float>(kLineStrength) * colour.alphaF());
        painter.setPen(QPen(colour, kLine));
        for (const QPolygonF& line : outline(*layer.frame, surface)) painter.drawPolyline(line);
    }
}

template class OnionSkin<2>;
template class OnionSkin<3>;

}  // namespace wend
