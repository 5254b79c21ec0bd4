#include "app/views/volume/draw_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace wend {
namespace {

using Triangle = std::array<int, 3>;

/// Faces that meet at a sharper angle than this keep their edge.
const double kCrease = std::cos(40 * std::numbers::pi / 180);

/// Groups corners (3 t + k) that share a normal: those at one point whose triangles are connected through
/// edges that are no creases. Flat triangles share none.
class SmoothGroups {
  public:
    SmoothGroups(const std::vector<Triangle>& triangles, const Points3& rest, const std::vector<bool>& flat)
        : m_triangles(triangles), m_groups(3 * triangles.size(), -1) {
        for (const Triangle& t : triangles) {
            const Vec3 a = rest.col(t[0]);
            m_areas.push_back((rest.col(t[1]) - a).cross(rest.col(t[2]) - a));
        }
        std::vector<int> start(static_cast<std::size_t>(rest.cols()) + 1, 0);
        const auto isFlat = [&](std::size_t t) { return !flat.empty() && flat[t]; };
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (const int v : triangles[t]) start[v + 1] += isFlat(t) ? 0 : 1;
        std::partial_sum(start.begin(), start.end(), start.begin());
        std::vector<int> corners(static_cast<std::size_t>(start.back())), at(start.begin(), start.end() - 1);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int corner = static_cast<int>(3 * t) + k;
                if (isFlat(t))
                    m_groups[corner] = m_count++;
                else
                    corners[at[triangles[t][k]]++] = corner;
            }
        for (Eigen::Index v = 0; v < rest.cols(); ++v)
            group(corners.data() + start[v], start[v + 1] - start[v]);
    }

    int count() const { return m_count; }
    int operator[](std::size_t corner) const { return m_groups[corner]; }

  private:
    bool isSmooth(int a, int b) const {
        const Vec3 &p = m_areas[a / 3], &q = m_areas[b / 3];
        return p.dot(q) >= kCrease * p.norm() * q.norm();
    }

    /// Groups the corners at one point that share edges, which are found by their other ends.
    void group(const int* corners, int count) {
        m_edges.clear();
        m_root.resize(static_cast<std::size_t>(count));
        std::iota(m_root.begin(), m_root.end(), 0);
        for (int i = 0; i < count; ++i)
            for (const int k : {1, 2})
                m_edges.emplace_back(m_triangles[corners[i] / 3][(corners[i] % 3 + k) % 3], i);
        std::sort(m_edges.begin(), m_edges.end());
        for (std::size_t e = 1; e < m_edges.size(); ++e) {
            const auto& [to, i] = m_edges[e - 1];
            const auto& [same, j] = m_edges[e];
            if (to == same && isSmooth(corners[i], corners[j])) m_root[find(i)] = find(j);
        }
        for (int i = 0; i < count; ++i)
            if (find(i) == i) m_groups[corners[i]] = m_count++;
        for (int i = 0; i < count; ++i) m_groups[corners[i]] = m_groups[corners[find(i)]];
    }

    int find(int i) {
        while (m_root[i] != i) i = m_root[i] = m_root[m_root[i]];
        return i;
    }

    const std::vector<Triangle>& m_triangles;
    std::vector<Vec3> m_areas;
    std::vector<int> m_groups, m_root;
    std::vector<std::pair<int, int>> m_edges;
    int m_count = 0;
};

/// Sets vertices from the groups alone.
void setVertices(DrawMesh& mesh, const SmoothGroups& groups) {
    mesh.normals = groups.count();
    mesh.vertices.resize(static_cast<std::size_t>(groups.count()));
    mesh.corners.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int group = groups[3 * t + k];
            mesh.vertices[group] = {mesh.triangles[t][k], group};
            mesh.corners[t][k] = group;
        }
}

/// Adds vertices where texture points meet.
void splitAtSeams(DrawMesh& mesh, const Skin& skin, const std::vector<int>& order) {
    std::vector<int> uvOf(mesh.vertices.size(), -1);
    std::map<std::pair<int, int>, int> copies;  // (vertex, texture point) → additional vertex
    for (std::size_t t = 0; t < mesh.corners.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int vertex = mesh.corners[t][k], uv = skin.uvCorners[order[t]][k];
            if (uvOf[vertex] < 0) uvOf[vertex] = uv;
            if (uvOf[vertex] == uv) continue;
            const auto [copy, isNew] =
                copies.try_emplace({vertex, uv}, static_cast<int>(mesh.vertices.size()));
            if (isNew) {
                mesh.vertices.push_back(DrawMesh::Vertex(mesh.vertices[vertex]));
                uvOf.push_back(uv);
            }
            mesh.corners[t][k] = copy->second;
        }
    for (const int uv : uvOf)
        mesh.uv.push_back(uv < 0 ? Eigen::Vector2f::Zero() : Eigen::Vector2f(skin.uv.col(uv).cast<float>()));
}

QRgb colourOf(const Skin& skin, int material) {
    if (material < 0 || material >= static_cast<int>(skin.materials.size()))
        return skin.colours.empty() ? qRgb(204, 204, 204) : qRgb(255, 255, 255);
    const SkinMaterial& look = skin.materials[material];
    if (!look.texture.empty()) return qRgb(255, 255, 255);
    const auto byte = [](float x) { return static_cast<int>(std::lround(255 * std::clamp(x, 0.0F, 1.0F))); };
    return qRgb(byte(look.colour[0]), byte(look.colour[1]), byte(look.colour[2]));
}

/// Returns the skin's triangles, those of one material side by side.
std::vector<int> orderOf(const Skin& skin) {
    std::vector<int> order(skin.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    if (!skin.materialOf.empty())
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return skin.materialOf[a] < skin.materialOf[b]; });
    return order;
}

void setParts(DrawMesh& mesh, const Skin& skin, const std::vector<int>& order) {
    for (std::size_t t = 0; t < order.size(); ++t) {
        const int material = skin.materialOf.empty() ? -1 : skin.materialOf[order[t]];
        if (mesh.parts.empty() || mesh.parts.back().material != material)
            mesh.parts.push_back({static_cast<int>(t), 0, material});
        ++mesh.parts.back().count;
        if (!skin.materialOf.empty() || !skin.colours.empty())
            mesh.colours.push_back(colourOf(skin, material));
    }
}

/// Sets the colours of the vertices, which are multiplied with those of the triangles.
void setTints(DrawMesh& mesh, const Skin& skin) {
    if (skin.colours.empty()) return;
    const auto byte = [](double x) { return static_cast<int>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
    for (const DrawMesh::Vertex& vertex : mesh.vertices) {
        const auto& colour = skin.colours[static_cast<std::size_t>(vertex.point)];
        mesh.tints.push_back(qRgb(byte(colour[0]), byte(colour[1]), byte(colour[2])));
    }
}

Points3 placesIn(const Points3& pose, const std::vector<CutSurface::Corner>& places) {
    Points3 points(3, static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& [from, to, weight] = places[i];
        points.col(static_cast<Eigen::Index>(i)) = (1 - weight) * pose.col(from) + weight * pose.col(to);
    }
    return points;
}

}  // namespace

bool hasOwnColours(const Skin& skin) {
    return !skin.materials.empty() || !skin.colours.empty();
}

CutPoints::CutPoints(const CutSurface& surface) {
    std::vector<int> ofVertex;
    std::map<std::pair<int, int>, int> ofEdge;
    const auto idOf = [&](const CutSurface::Corner& c) -> int& {
        if (c.weight != 0) return ofEdge.try_emplace({c.from, c.to}, -1).first->second;
        if (c.from >= static_cast<int>(ofVertex.size())) ofVertex.resize(c.from + 1, -1);
        return ofVertex[c.from];
    };
    triangles.reserve(surface.triangles.size());
    for (const auto& corners : surface.triangles) {
        Triangle& triangle = triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            int& id = idOf(corners[k]);
            if (id < 0) {
                id = static_cast<int>(points.size());
                points.push_back(corners[k]);
            }
            triangle[k] = id;
        }
    }
}

Points3 CutPoints::at(const Points3& pose) const {
    return placesIn(pose, points);
}

/// Sections without area, where the plane meets vertices, have each of their edges twice.
std::vector<std::array<int, 2>> borderOf(const std::vector<std::array<int, 3>>& triangles) {
    std::vector<std::array<int, 2>> edges, border;
    for (const Triangle& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            if (low != high) edges.push_back({low, high});
        }
    std::ranges::sort(edges);
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next = std::upper_bound(edge, edges.end(), *edge);
        if ((next - edge) % 2 == 1) border.push_back(*edge);
        edge = next;
    }
    return border;
}

CutSurface partOf(const CutSurface& surface, bool onCut) {
    CutSurface part;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (surface.onCut[t] != onCut) continue;
        part.triangles.push_back(surface.triangles[t]);
        part.cells.push_back(surface.cells[t]);
        part.onCut.push_back(onCut);
    }
    return part;
}

namespace {

/// Makes everything but the vertices.
DrawMesh unshaded(const CutSurface& surface) {
    CutPoints cut(surface);
    DrawMesh mesh;
    mesh.triangles = std::move(cut.triangles);
    mesh.places = std::move(cut.points);
    mesh.points = static_cast<int>(mesh.places.size());
    mesh.cells = surface.cells;
    mesh.parts = {{0, static_cast<int>(mesh.triangles.size()), -1}};
    return mesh;
}

}  // namespace

DrawMesh drawMesh(const CutSurface& surface, const Points3& rest) {
    DrawMesh mesh = unshaded(surface);
    setVertices(mesh, SmoothGroups(mesh.triangles, drawnPoints(mesh, rest), surface.onCut));
    return mesh;
}

DrawMesh drawSection(const CutSurface& section) {
    DrawMesh mesh = unshaded(section);
    mesh.corners = mesh.triangles;
    for (int point = 0; point < mesh.points; ++point) mesh.vertices.push_back({point, 0});
    mesh.normals = 1;
    return mesh;
}

DrawMesh drawMesh(const Skin& skin, const Embedding<3>& embedding) {
    DrawMesh mesh;
    const std::vector<int> order = orderOf(skin);
    for (const int t : order) {
        mesh.triangles.push_back(skin.triangles[t]);
        mesh.cells.push_back(embedding.cell(skin.triangles[t][0]));
    }
    mesh.points = skin.vertexCount();
    setParts(mesh, skin, order);
    setVertices(mesh, SmoothGroups(mesh.triangles, skin.points, {}));
    if (!skin.uvCorners.empty()) splitAtSeams(mesh, skin, order);
    setTints(mesh, skin);
    return mesh;
}

Points3 drawnPoints(const DrawMesh& mesh, const Points3& pose) {
    return placesIn(pose, mesh.places);
}

std::vector<Eigen::Vector3f> drawnNormals(const DrawMesh& mesh, const Eigen::Matrix3Xf& points) {
    std::vector<Eigen::Vector3f> sums(static_cast<std::size_t>(mesh.normals), Eigen::Vector3f::Zero());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& p = mesh.triangles[t];
        const Eigen::Vector3f a = points.col(p[0]);
        const Eigen::Vector3f area = (points.col(p[1]) - a).cross(points.col(p[2]) - a);
        for (const int vertex : mesh.corners[t]) sums[mesh.vertices[vertex].normal] += area;
    }
    for (Eigen::Vector3f& sum : sums) sum.stableNormalize();
    return sums;
}

}  // namespace wend
