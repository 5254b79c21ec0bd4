#include "core/mesh/triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace wend {
namespace {

constexpr int kLeaf = 4;  // triangles
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// Returns the distance along the ray (Möller and Trumbore 1997), or infinity.
double distanceTo(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& origin, const Vec3& direction) {
    const Vec3 e1 = b - a, e2 = c - a;
    const Vec3 p = direction.cross(e2);
    const double det = e1.dot(p);
    if (det == 0) return kNothing;
    const Vec3 s = origin - a;
    const double u = s.dot(p) / det;
    if (!(u >= 0 && u <= 1)) return kNothing;
    const Vec3 q = s.cross(e1);
    const double v = direction.dot(q) / det;
    if (!(v >= 0 && u + v <= 1)) return kNothing;
    const double t = e2.dot(q) / det;
    return t > 0 ? t : kNothing;
}

/// Returns where the ray enters the box, or infinity. Slightly enlarged, so that rounding loses no triangle.
double entryOf(const Vec3& low, const Vec3& high, const Vec3& origin, const Vec3& direction) {
    constexpr double kSlack = 1 + 1e-12;
    double from = 0, to = kNothing;
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) {
            if (origin[k] < low[k] || origin[k] > high[k]) return kNothing;
            continue;
        }
        const double a = (low[k] - origin[k]) / direction[k], b = (high[k] - origin[k]) / direction[k];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b) * kSlack);
    }
    return from <= to ? from : kNothing;
}

/// Weights of the point of the segment a b that is nearest to p.
Eigen::Vector2d nearestOnEdge(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double length = (b - a).squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0;
    return {1 - t, t};
}

/// Returns the barycentric weights of the triangle's point nearest to p: its projection if inside, else the
/// nearest point of the edges.
Vec3 nearestOnTriangle(const Vec3& p, const std::array<Vec3, 3>& x) {
    const Vec3 e1 = x[1] - x[0], e2 = x[2] - x[0], n = e1.cross(e2), q = p - x[0];
    const double area = n.squaredNorm();
    if (area > 0) {
        const double w1 = q.cross(e2).dot(n) / area, w2 = e1.cross(q).dot(n) / area;
        if (w1 >= 0 && w2 >= 0 && w1 + w2 <= 1) return {1 - w1 - w2, w1, w2};
    }
    Vec3 best = Vec3::UnitX();
    double minimum = kNothing;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const Eigen::Vector2d t = nearestOnEdge(p, x[k], x[next]);
        const double distance = (t[0] * x[k] + t[1] * x[next] - p).squaredNorm();
        if (distance >= minimum) continue;
        minimum = distance;
        best.setZero();
        best[k] = t[0];
        best[next] = t[1];
    }
    return best;
}

double squaredDistance(const Vec3& low, const Vec3& high, const Vec3& p) {
    return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
}

}  // namespace

TriangleTree::TriangleTree(const Points3& points, std::vector<std::array<int, 3>> triangles)
    : m_points(points), m_triangles(std::move(triangles)), m_order(m_triangles.size()) {
    std::iota(m_order.begin(), m_order.end(), 0);
    std::vector<Vec3> centres;
    centres.reserve(m_triangles.size());
    for (const auto& t : m_triangles) {
        const Vec3 centre = (points.col(t[0]) + points.col(t[1]) + points.col(t[2])) / 3;
        centres.push_back(centre.allFinite() ? centre : Vec3::Zero());
    }
    m_nodes.reserve(m_triangles.size());
    if (!m_triangles.empty()) build(0, triangleCount(), centres);
    refit(points);
}

/// Halves the triangles along the longest side of their centres' box, down to a few.
int TriangleTree::build(int first, int last, const std::vector<Vec3>& centres) {
    const int index = static_cast<int>(m_nodes.size());
    m_nodes.emplace_back();
    if (last - first <= kLeaf) {
        m_nodes[index].first = first;
        m_nodes[index].count = last - first;
        return index;
    }
    Vec3 low = centres[m_order[first]], high = low;
    for (int i = first; i < last; ++i) {
        low = low.cwiseMin(centres[m_order[i]]);
        high = high.cwiseMax(centres[m_order[i]]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const int middle = (first + last) / 2;
    std::nth_element(m_order.begin() + first, m_order.begin() + middle, m_order.begin() + last,
                     [&](int a, int b) { return centres[a][axis] < centres[b][axis]; });
    build(first, middle, centres);
    const int right = build(middle, last, centres);
    m_nodes[index].right = right;
    return index;
}

/// Computes the box of a node from its children or, in a leaf, from its triangles.
void TriangleTree::fit(Node& node, int index) {
    if (node.count == 0) {
        const Node &left = m_nodes[index + 1], &right = m_nodes[node.right];
        node.low = left.low.cwiseMin(right.low);
        node.high = left.high.cwiseMax(right.high);
        return;
    }
    node.low.setConstant(kNothing);
    node.high.setConstant(-kNothing);
    for (int i = node.first; i < node.first + node.count; ++i)
        for (const int v : m_triangles[m_order[i]]) {
            if (!m_points.col(v).allFinite()) continue;
            node.low = node.low.cwiseMin(m_points.col(v));
            node.high = node.high.cwiseMax(m_points.col(v));
        }
}

/// Updates the boxes from the end of the list, where children follow their parents.
void TriangleTree::refit(const Points3& points) {
    m_points = points;
    for (int i = static_cast<int>(m_nodes.size()) - 1; i >= 0; --i) fit(m_nodes[i], i);
}

/// Visits the nearer child first, and skips boxes that the ray enters behind the nearest hit so far.
TriangleTree::Hit TriangleTree::firstHit(const Vec3& origin, const Vec3& direction) const {
    Hit hit;
    if (m_nodes.empty()) return hit;
    struct Entry {
        int node;
        double distance;
    };
    std::vector<Entry> open{{0, entryOf(m_nodes[0].low, m_nodes[0].high, origin, direction)}};
    while (!open.empty()) {
        const Entry entry = open.back();
        open.pop_back();
        if (!(entry.distance <= hit.distance && entry.distance < kNothing)) continue;
        const Node& node = m_nodes[entry.node];
        ++hit.visited;
        for (int i = node.first; i < node.first + node.count; ++i, ++hit.visited) {
            const int triangle = m_order[i];
            const auto& t = m_triangles[triangle];
            const double distance =
                distanceTo(m_points.col(t[0]), m_points.col(t[1]), m_points.col(t[2]), origin, direction);
            // At equal distances the triangle with the lowest index wins, independently of the tree.
            const bool nearer = distance < hit.distance ||
                                (distance == hit.distance && distance < kNothing && triangle < hit.triangle);
            if (!nearer) continue;
            hit.distance = distance;
            hit.triangle = triangle;
        }
        if (node.count > 0) continue;
        Entry near{entry.node + 1, 0}, far{node.right, 0};
        for (Entry* child : {&near, &far})
            child->distance = entryOf(m_nodes[child->node].low, m_nodes[child->node].high, origin, direction);
        if (far.distance < near.distance) std::swap(near, far);
        if (far.distance < kNothing) open.push_back(far);
        if (near.distance < kNothing) open.push_back(near);
    }
    return hit;
}

/// Visits the nearer child first, and skips boxes that are farther away than the nearest point so far.
TriangleTree::Nearest TriangleTree::nearest(const Vec3& p) const {
    Nearest best;
    double minimum = kNothing;
    std::vector<std::pair<int, double>> open;
    if (!m_nodes.empty()) open.emplace_back(0, squaredDistance(m_nodes[0].low, m_nodes[0].high, p));
    while (!open.empty()) {
        const auto [index, distance] = open.back();
        open.pop_back();
        if (!(distance < minimum)) continue;
        const Node& node = m_nodes[index];
        for (int i = node.first; i < node.first + node.count; ++i) {
            const auto& t = m_triangles[m_order[i]];
            const std::array<Vec3, 3> x{m_points.col(t[0]), m_points.col(t[1]), m_points.col(t[2])};
            const Vec3 weights = nearestOnTriangle(p, x);
            const double there =
                (weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] - p).squaredNorm();
            if (!(there < minimum)) continue;
            minimum = there;
            best = {m_order[i], weights};
        }
        if (node.count > 0) continue;
        std::pair<int, double> near{index + 1, 0}, far{node.right, 0};
        for (auto* child : {&near, &far})
            child->second = squaredDistance(m_nodes[child->first].low, m_nodes[child->first].high, p);
        if (far.second < near.second) std::swap(near, far);
        open.push_back(far);
        open.push_back(near);
    }
    return best;
}

}  // namespace wend
