#include "warp/plane_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wend {
namespace {

constexpr double kRounding = 1e-7;  // of a cell's size

/// Returns the gradient of a cell's linear map, and its area at rest.
std::pair<Mat2, double> gradientOf(const SimplicialMesh<2>& rest, const Points2& pose, const Cell<2>& cell) {
    Mat2 X, x;
    for (int k = 0; k < 2; ++k) {
        X.col(k) = rest.points.col(cell[static_cast<std::size_t>(k) + 1]) - rest.points.col(cell[0]);
        x.col(k) = pose.col(cell[static_cast<std::size_t>(k) + 1]) - pose.col(cell[0]);
    }
    return {x * X.inverse(), std::abs(X.determinant()) / 2};
}

}  // namespace

PlaneMap::PlaneMap(SimplicialMesh<2> rest, Points2 pose)
    : m_rest(std::move(rest)), m_pose(std::move(pose)), m_locator(m_rest.points, m_rest.cells) {
    const auto count = static_cast<std::size_t>(m_rest.vertexCount());
    m_gradients.assign(count, Mat2::Zero());
    std::vector<double> weights(count, 0.0);
    double area = 0;
    for (const Cell<2>& cell : m_rest.cells) {
        const auto [gradient, weight] = gradientOf(m_rest, m_pose, cell);
        for (const int v : cell) {
            m_gradients[static_cast<std::size_t>(v)] += weight * gradient;
            weights[static_cast<std::size_t>(v)] += weight;
        }
        area += weight;
    }
    for (std::size_t v = 0; v < count; ++v)
        if (weights[v] > 0) m_gradients[v] /= weights[v];
    m_cellSize = std::sqrt(area / std::max(1, m_rest.cellCount()));
    m_rest.parts.clear(), m_rest.welds.clear();
    for (const Facet<2>& facet : facetsOf(m_rest))
        if (!facet.interior()) m_border.push_back(facet.vertices);
}

PlaneMap::Place PlaneMap::nearestOnBorder(const Vec2& p) const {
    Place nearest{{0, 0, 0}, {1, 0, 0}, {0, 0}};
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : m_border) {
        const Vec2 from = m_rest.points.col(a), along = m_rest.points.col(b) - from;
        const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const Vec2 beyond = p - (from + t * along);
        if (beyond.squaredNorm() >= least) continue;
        least = beyond.squaredNorm();
        nearest = {{a, b, b}, {1 - t, t, 0}, beyond};
    }
    return nearest;
}

PlaneMap::Place PlaneMap::placeOf(const Vec2& p) const {
    if (const auto found = m_locator.find(p, 1e-9))
        return {m_rest.cells[static_cast<std::size_t>(found->cell)], found->weights, {0, 0}};
    return nearestOnBorder(p);
}

Vec2 PlaneMap::operator()(const Vec2& p) const {
    const Place place = placeOf(p);
    Vec2 at(0, 0);
    Mat2 G = Mat2::Zero();
    const Vec2 inside = p - place.beyond;
    for (int k = 0; k < 3; ++k) {
        const int v = place.vertices[static_cast<std::size_t>(k)];
        const Mat2& own = m_gradients[static_cast<std::size_t>(v)];
        at += place.weights[k] * (m_pose.col(v) + own * (inside - m_rest.points.col(v)) / 2);
        G += place.weights[k] * own;
    }
    return at + G * place.beyond;
}

Mat2 PlaneMap::gradient(const Vec2& p) const {
    const Place place = placeOf(p);
    Mat2 G = Mat2::Zero();
    for (int k = 0; k < 3; ++k)
        G += place.weights[k] *
             m_gradients[static_cast<std::size_t>(place.vertices[static_cast<std::size_t>(k)])];
    return G;
}

bool PlaneMap::contains(const Vec2& p) const {
    return m_locator.find(p, 1e-9) || nearestOnBorder(p).beyond.norm() <= kRounding * m_cellSize;
}

std::vector<std::vector<Vec2>> PlaneMap::border() const {
    std::multimap<int, int> next;
    for (const auto& [a, b] : m_border) next.emplace(a, b);
    std::vector<std::vector<Vec2>> loops;
    while (!next.empty()) {
        auto& loop = loops.emplace_back();
        for (auto at = next.begin(); at != next.end();) {
            loop.emplace_back(m_pose.col(at->first));
            const int to = at->second;
            next.erase(at);
            at = next.find(to);
        }
    }
    return loops;
}

/// Minimizes Σ |A (p − c) − (F(p) − F̄)|² + λ |A − G(c)|² with the points' mean c.
Affine nearestAffine(const PlaneMap& map, const std::vector<Vec2>& points) {
    constexpr double kWeight = 1e-3;  // of the gradient, beside the points
    Vec2 centre(0, 0), image(0, 0);
    std::vector<Vec2> images;
    for (const Vec2& p : points) {
        images.push_back(map(p));
        centre += p / static_cast<double>(points.size());
        image += images.back() / static_cast<double>(points.size());
    }
    Mat2 square = Mat2::Zero(), mixed = Mat2::Zero();
    for (std::size_t k = 0; k < points.size(); ++k) {
        square += (points[k] - centre) * (points[k] - centre).transpose();
        mixed += (images[k] - image) * (points[k] - centre).transpose();
    }
    const double weight = kWeight * square.trace() + std::numeric_limits<double>::min();
    square += weight * Mat2::Identity();
    mixed += weight * map.gradient(centre);
    const Mat2 A = mixed * square.inverse();
    return {A, image - A * centre};
}

}  // namespace wend
