#include "core/motion/guide_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/error.h"

namespace wend {
namespace {

const double kSharp = std::cos(50 * std::numbers::pi / 180);

using Triangle = std::array<int, 3>;
using Segment = std::array<int, 2>;

/// Returns twice the area times the normal; zero for a triangle of no area.
Vec3 areaNormal(const Points3& points, const Triangle& t) {
    return (points.col(t[1]) - points.col(t[0])).cross(points.col(t[2]) - points.col(t[0]));
}

double angleAt(const Points3& points, const Triangle& t, int corner) {
    const Vec3 x = points.col(t[corner]);
    const Vec3 a = points.col(t[(corner + 1) % 3]) - x, b = points.col(t[(corner + 2) % 3]) - x;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Returns for every point the first one with the same coordinates, since a file may repeat them per facet.
template <int Dim>
std::vector<int> firstOfEqual(const Points<Dim>& points) {
    std::map<std::array<double, Dim>, int> first;
    std::vector<int> result;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        std::array<double, Dim> key;
        std::copy_n(points.col(i).data(), Dim, key.begin());
        result.push_back(first.try_emplace(key, static_cast<int>(i)).first->second);
    }
    return result;
}

/// The sum of a direction and others that differ from it by less than a sharp angle, whatever their sense.
class SmoothDirection {
  public:
    explicit SmoothDirection(const Vec3& own) : m_own(own) {}
    void add(const Vec3& other, double weight) {
        const double cosine = m_own.dot(other);
        if (std::abs(cosine) >= kSharp) m_sum += std::copysign(weight, cosine) * other;
    }
    Vec3 value() const { return m_sum.norm() > 0 ? Vec3(m_sum.normalized()) : m_own; }

  private:
    Vec3 m_own, m_sum = Vec3::Zero();
};

}  // namespace

/// Merges equal points, finds sharp edges and corners, and smooths normals and tangents elsewhere.
template <int Dim>
GuideSurface<Dim>::GuideSurface(const GuideMesh<Dim>& mesh) {
    m_points.setZero(3, mesh.points.cols());
    m_points.template topRows<Dim>() = mesh.points;
    const std::vector<int> first = firstOfEqual<Dim>(mesh.points);
    for (const Triangle& t : mesh.triangles) {
        const Triangle own{first[t[0]], first[t[1]], first[t[2]]};
        if (!areaNormal(m_points, own).isZero(0)) m_triangles.push_back(own);
    }
    for (const Segment& s : mesh.segments)
        if (first[s[0]] != first[s[1]]) m_segments.push_back({first[s[0]], first[s[1]]});
    if (m_triangles.empty() && m_segments.empty())
        throw InputError(Dim == 2 ? "has no line to slide along" : "has no surface or line to slide on");
    findSharpEdges(m_triangles);
    smoothNormals(m_triangles);
    smoothTangents();
    m_faces = TriangleTree(m_points, m_triangles);
    std::vector<Triangle> lines;
    for (const Segment& s : m_segments) lines.push_back({s[0], s[1], s[1]});
    m_lines = TriangleTree(m_points, std::move(lines));
}

/// Adds the edges between two triangles at a sharp angle, and those of more than two triangles. Finds the
/// rim, too.
template <int Dim>
void GuideSurface<Dim>::findSharpEdges(const std::vector<Triangle>& triangles) {
    std::map<Segment, std::vector<Vec3>> normalsOf;
    const auto edgeOf = [](const Triangle& t, int opposite) {
        const auto [a, b] = std::minmax(t[(opposite + 1) % 3], t[(opposite + 2) % 3]);
        return Segment{a, b};
    };
    for (const Triangle& t : triangles)
        for (int k = 0; k < 3; ++k) normalsOf[edgeOf(t, k)].push_back(areaNormal(m_points, t).normalized());
    m_rimVertices.assign(static_cast<std::size_t>(m_points.cols()), false);
    for (const Triangle& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const Segment edge = edgeOf(t, k);
            m_rimEdges.push_back(normalsOf[edge].size() == 1);
            if (m_rimEdges.back()) m_rimVertices[edge[0]] = m_rimVertices[edge[1]] = true;
        }
    for (const auto& [edge, normals] : normalsOf)
        if (normals.size() > 2 || (normals.size() == 2 && std::abs(normals[0].dot(normals[1])) < kSharp))
            m_segments.push_back(edge);
}

/// Computes a normal for every corner of every triangle: the mean over the triangles at the vertex, weighted
/// by their angles there (Thürmer and Wüthrich 1998), which does not depend on how a flat part is
/// triangulated. Triangles at a sharp angle to the corner's own do not count, so that an edge between two
/// sides stays sharp.
template <int Dim>
void GuideSurface<Dim>::smoothNormals(const std::vector<Triangle>& triangles) {
    std::vector<std::vector<std::pair<int, int>>> around(static_cast<std::size_t>(m_points.cols()));
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int k = 0; k < 3; ++k) around[triangles[f][k]].emplace_back(static_cast<int>(f), k);
    m_normals.resize(3, 3 * static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            SmoothDirection normal(areaNormal(m_points, triangles[f]).normalized());
            for (const auto& [other, corner] : around[triangles[f][k]])
                normal.add(areaNormal(m_points, triangles[other]).normalized(),
                           angleAt(m_points, triangles[other], corner));
            m_normals.col(static_cast<Eigen::Index>(3 * f) + k) = normal.value();
        }
}

/// Finds the corners and ends, too.
template <int Dim>
void GuideSurface<Dim>::smoothTangents() {
    std::map<int, std::vector<int>> around;
    const auto tangent = [&](int s) {
        return Vec3((m_points.col(m_segments[s][1]) - m_points.col(m_segments[s][0])).normalized());
    };
    for (std::size_t s = 0; s < m_segments.size(); ++s)
        for (const int v : m_segments[s]) around[v].push_back(static_cast<int>(s));
    m_ends.assign(static_cast<std::size_t>(m_points.cols()), false);
    for (const auto& [v, segments] : around) m_ends[v] = segments.size() == 1;
    for (const auto& [v, segments] : around)
        if (segments.size() > 2 ||
            (segments.size() == 2 && std::abs(tangent(segments[0]).dot(tangent(segments[1]))) < kSharp))
            m_corners.push_back(v);
    m_tangents.resize(3, 2 * static_cast<Eigen::Index>(m_segments.size()));
    for (std::size_t s = 0; s < m_segments.size(); ++s)
        for (int k = 0; k < 2; ++k) {
            SmoothDirection direction(tangent(static_cast<int>(s)));
            const auto& segments = around[m_segments[s][k]];
            if (segments.size() == 2)
                for (const int other : segments) direction.add(tangent(other), 1);
            m_tangents.col(static_cast<Eigen::Index>(2 * s) + k) = direction.value();
        }
}

/// Tries corners first, then lines, and then the whole guide.
template <int Dim>
Track GuideSurface<Dim>::trackAt(const Vec<Dim>& p, double tolerance) const {
    const Track whole = m_triangles.empty() ? Track::Line : Track::Face;
    const Vec<Dim> place = contact(whole, p).point;
    const auto isNear = [&](const Vec<Dim>& q) { return (q - place).norm() <= tolerance; };
    for (const int corner : m_corners)
        if (isNear(m_points.col(corner).template head<Dim>())) return Track::Corner;
    if (whole == Track::Face && !m_segments.empty() && isNear(contact(Track::Line, place).point))
        return Track::Line;
    return whole;
}

/// Returns whether the place is on an edge of the rim, or at a vertex of it.
template <int Dim>
bool GuideSurface<Dim>::isOnRim(const TriangleTree::Nearest& nearest) const {
    for (int k = 0; k < 3; ++k) {
        if (nearest.weights[k] == 1 && m_rimVertices[m_triangles[nearest.triangle][k]]) return true;
        const std::size_t edge = 3 * static_cast<std::size_t>(nearest.triangle) + static_cast<std::size_t>(k);
        if (nearest.weights[k] == 0 && m_rimEdges[edge]) return true;
    }
    return false;
}

/// Returns the nearest place on the faces, with the normal that is interpolated there.
template <int Dim>
Contact<Dim> GuideSurface<Dim>::onFace(const Vec3& p) const {
    const TriangleTree::Nearest nearest = m_faces.nearest(p);
    const auto& [f, w] = nearest;
    const Triangle& t = m_triangles[f];
    Vec3 x = w[0] * m_points.col(t[0]) + w[1] * m_points.col(t[1]) + w[2] * m_points.col(t[2]);
    const Vec3 n = m_normals.template middleCols<3>(3 * static_cast<Eigen::Index>(f)) * w;
    if (isOnRim(nearest)) {
        const Vec3 own = areaNormal(m_points, t).normalized();
        x = p - own * own.dot(p - x);
    }
    Contact<Dim> contact;
    contact.point = x.template head<Dim>();
    contact.normals.col(0) = n.normalized().template head<Dim>();
    contact.count = 1;
    return contact;
}

/// Returns the nearest place on the lines. At an end the line continues along its tangent.
template <int Dim>
Contact<Dim> GuideSurface<Dim>::onLine(const Vec3& p) const {
    const auto [number, w] = m_lines.nearest(p);
    const Segment& s = m_segments[number];
    const auto first = 2 * static_cast<Eigen::Index>(number);
    Vec3 x = w[0] * m_points.col(s[0]) + (1 - w[0]) * m_points.col(s[1]);
    if ((w[0] == 1 && m_ends[s[0]]) || (w[0] == 0 && m_ends[s[1]])) {
        const Vec3 own = (m_points.col(s[1]) - m_points.col(s[0])).normalized();
        x += own * own.dot(p - x);
    }
    const Vec3 t = (w[0] * m_tangents.col(first) + (1 - w[0]) * m_tangents.col(first + 1)).normalized();
    Contact<Dim> contact;
    contact.point = x.template head<Dim>();
    contact.count = Dim - 1;
    if constexpr (Dim == 2) {
        contact.normals.col(0) = Vec2(-t.y(), t.x());
    } else {
        contact.normals.col(0) = t.unitOrthogonal();
        contact.normals.col(1) = t.cross(Vec3(contact.normals.col(0)));
    }
    return contact;
}

template <int Dim>
Contact<Dim> GuideSurface<Dim>::onCorner(const Vec3& p) const {
    const int nearest =
        *std::ranges::min_element(m_corners, {}, [&](int v) { return (m_points.col(v) - p).squaredNorm(); });
    return {m_points.col(nearest).template head<Dim>(), Mat<Dim>::Identity(), Dim};
}

template <int Dim>
Contact<Dim> GuideSurface<Dim>::contact(Track track, const Vec<Dim>& p) const {
    Vec3 q = Vec3::Zero();
    q.template head<Dim>() = p;
    return track == Track::Face ? onFace(q) : track == Track::Line ? onLine(q) : onCorner(q);
}

template class GuideSurface<2>;
template class GuideSurface<3>;

}  // namespace wend
