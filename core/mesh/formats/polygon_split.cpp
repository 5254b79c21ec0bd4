#include "core/mesh/formats/polygon_split.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace wend::formats {
namespace {

using Triangle = std::array<int, 3>;

constexpr double kFarFromPlane = 0.15;  // of the greatest distance between corners
constexpr double kNoArea = 1e-14;       // of the square of that distance: rounding of the products

/// Adds x to a sum that is kept exactly, as doubles that do not overlap (Shewchuk's GROW-EXPANSION).
void grow(std::vector<double>& expansion, double x) {
    for (double& e : expansion) {
        const double sum = e + x, part = sum - e;
        const double rest = (e - (sum - part)) + (x - part);
        e = rest;
        x = sum;
    }
    expansion.push_back(x);
}

/// Adds a · b exactly: the rounded product, and its rounding error by a fused multiplication.
void growByProduct(std::vector<double>& expansion, double a, double b) {
    const double product = a * b;
    grow(expansion, std::fma(a, b, -product));
    grow(expansion, product);
}

/// Returns the sign of an expansion, which is that of its last component that is not 0, the greatest one.
int signOfSum(const std::vector<double>& expansion) {
    for (auto e = expansion.rbegin(); e != expansion.rend(); ++e)
        if (*e != 0) return *e > 0 ? 1 : -1;
    return 0;
}

std::vector<Triangle> fan(std::span<const int> corners) {
    std::vector<Triangle> triangles;
    for (std::size_t k = 2; k < corners.size(); ++k)
        triangles.push_back({corners[0], corners[k - 1], corners[k]});
    return triangles;
}

std::vector<int> withoutRepeats(std::span<const int> corners) {
    std::vector<int> ring;
    for (const int v : corners)
        if (ring.empty() || ring.back() != v) ring.push_back(v);
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

/// A polygon projected into the plane of two axes, counter-clockwise.
class FlatPolygon {
  public:
    /// Measures the polygon, whose normal is given by Newell's formula, and projects it.
    FlatPolygon(const Eigen::Matrix3Xd& points, const std::vector<int>& ring) : m_ring(ring) {
        const Eigen::Matrix3Xd corners = points(Eigen::all, ring);
        const auto n = corners.cols();
        const Eigen::Vector3d centre = corners.rowwise().mean();
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // Newell's: twice the area
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Vector3d a = corners.col(i) - centre, b = corners.col((i + 1) % n) - centre;
            normal += a.cross(b);
            m_spread += (b - a).cross(corners.col((i + 2) % n) - corners.col((i + 1) % n)).norm();
        }
        m_size = (corners.rowwise().maxCoeff() - corners.rowwise().minCoeff()).norm();
        m_area = normal.norm() / 2;
        if (m_area > 0)
            m_height = ((corners.colwise() - centre).transpose() * normal.normalized()).cwiseAbs().maxCoeff();
        layDown(corners, normal);
    }

    /// Returns whether neither the polygon nor its parts have an area.
    bool isLine() const { return m_spread <= kNoArea * m_size * m_size; }
    bool hasArea() const { return m_area > kNoArea * m_size * m_size; }
    bool isFarFromPlane() const { return m_height > kFarFromPlane * m_size; }
    int turn(int a, int b, int c) const {
        return orientation(m_points[static_cast<std::size_t>(a)], m_points[static_cast<std::size_t>(b)],
                           m_points[static_cast<std::size_t>(c)]);
    }
    int size() const { return static_cast<int>(m_ring.size()); }
    int vertex(int k) const { return m_ring[static_cast<std::size_t>(k)]; }
    bool samePlace(int a, int b) const {
        return m_points[static_cast<std::size_t>(a)] == m_points[static_cast<std::size_t>(b)];
    }

    bool fillsItsFan() const {
        for (int k = 2; k < size(); ++k)
            if (turn(0, k - 1, k) <= 0) return false;
        return true;
    }
    /// Returns whether two edges cross in their interiors.
    bool crossesItself() const {
        for (int i = 0; i < size(); ++i)
            for (int j = i + 2; j < size(); ++j)
                if (cross(i, (i + 1) % size(), j, (j + 1) % size())) return true;
        return false;
    }
    /// Returns the area relative to the square of the longest edge.
    double shape(int a, int b, int c) const {
        const Eigen::Vector2d &p = m_points[static_cast<std::size_t>(a)],
                              &q = m_points[static_cast<std::size_t>(b)],
                              &r = m_points[static_cast<std::size_t>(c)];
        const double longest =
            std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
        const Eigen::Vector2d u = q - p, v = r - p;
        return longest > 0 ? (u.x() * v.y() - u.y() * v.x()) / longest : 0;
    }

  private:
    bool cross(int a, int b, int c, int d) const {
        return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
    }
    /// Drops the coordinate along which the normal is longest: the others stay exact.
    void layDown(const Eigen::Matrix3Xd& corners, const Eigen::Vector3d& normal) {
        Eigen::Index dropped = 0;
        normal.cwiseAbs().maxCoeff(&dropped);
        Eigen::Index x = (dropped + 1) % 3, y = (dropped + 2) % 3;
        if (normal[dropped] < 0) std::swap(x, y);
        for (Eigen::Index i = 0; i < corners.cols(); ++i) m_points.emplace_back(corners(x, i), corners(y, i));
    }

    const std::vector<int>& m_ring;
    std::vector<Eigen::Vector2d> m_points;
    double m_area = 0, m_spread = 0, m_size = 0, m_height = 0;
};

/// Cuts ears off a simple polygon: corners whose triangle is inside and contains no other corner.
class EarClipper {
  public:
    explicit EarClipper(const FlatPolygon& polygon) : m_polygon(polygon) {
        for (int k = 0; k < polygon.size(); ++k) m_left.push_back(k);
        m_shapes.assign(m_left.size(), 0);
        for (int k = 0; k < count(); ++k) judge(k);
    }

    /// Cuts off the best ear until a triangle is left. If no strict ear is left, corners on the border of an
    /// ear are allowed.
    std::vector<Triangle> clip() {
        std::vector<Triangle> triangles;
        while (count() > 2) {
            int best = bestEar();
            if (best < 0 && m_strict) {  // corners on the border of every ear: allow them
                m_strict = false;
                for (int k = 0; k < count(); ++k) judge(k);
                best = bestEar();
            }
            if (best < 0) throw InputError("the polygon crosses itself");
            triangles.push_back(m_polygon.turn(at(best - 1), at(best), at(best + 1)) > 0
                                    ? Triangle{m_polygon.vertex(at(best - 1)), m_polygon.vertex(at(best)),
                                               m_polygon.vertex(at(best + 1))}
                                    : Triangle{-1, -1, -1});
            m_left.erase(m_left.begin() + best);
            m_shapes.erase(m_shapes.begin() + best);
            if (count() < 3) break;
            judge((best + count() - 1) % count());
            judge(best % count());
        }
        std::erase_if(triangles, [](const Triangle& t) { return t[0] < 0; });
        return triangles;
    }

  private:
    int count() const { return static_cast<int>(m_left.size()); }
    int at(int k) const { return m_left[static_cast<std::size_t>((k + count()) % count())]; }
    int bestEar() const {
        const auto best = std::ranges::max_element(m_shapes);
        return *best >= 0 ? static_cast<int>(best - m_shapes.begin()) : -1;
    }
    /// Sets the shape of the ear there, −1 if it is none.
    void judge(int k) {
        const int a = at(k - 1), b = at(k), c = at(k + 1);
        double& shape = m_shapes[static_cast<std::size_t>((k + count()) % count())];
        shape = -1;
        const int turn = m_polygon.turn(a, b, c);
        if (turn < 0 || (turn == 0 && m_strict)) return;
        for (const int other : m_left)
            if (other != a && other != b && other != c && blocks(other, a, b, c)) return;
        shape = m_polygon.shape(a, b, c);
    }
    bool blocks(int p, int a, int b, int c) const {
        if (m_polygon.samePlace(p, a) || m_polygon.samePlace(p, b) || m_polygon.samePlace(p, c)) return false;
        const int least = m_strict ? 0 : 1;
        return m_polygon.turn(a, b, p) >= least && m_polygon.turn(b, c, p) >= least &&
               m_polygon.turn(c, a, p) >= least;
    }

    const FlatPolygon& m_polygon;
    std::vector<int> m_left;
    std::vector<double> m_shapes;  // of the ear at each corner that is left
    bool m_strict = true;          // no corner on an ear's border either
};

}  // namespace

/// Evaluates the determinant in doubles first, and exactly only if its rounding error could change the sign.
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y()), right = (a.y() - c.y()) * (b.x() - c.x());
    const double difference = left - right;
    // Shewchuk's bound of the rounding error of these five operations: (3 + 16 ε) ε, ε = 2⁻⁵³.
    if (std::abs(difference) > 3.3306690738754716e-16 * (std::abs(left) + std::abs(right)))
        return difference > 0 ? 1 : -1;
    std::vector<double> sum;
    sum.reserve(12);
    growByProduct(sum, a.x(), b.y());
    growByProduct(sum, -a.x(), c.y());
    growByProduct(sum, b.x(), c.y());
    growByProduct(sum, -b.x(), a.y());
    growByProduct(sum, c.x(), a.y());
    growByProduct(sum, -c.x(), b.y());
    return signOfSum(sum);
}

std::vector<Triangle> splitPolygon(const Eigen::Matrix3Xd& points, std::span<const int> corners) {
    if (corners.size() <= 3) return fan(corners);
    const std::vector<int> ring = withoutRepeats(corners);
    if (ring.size() <= 3) return fan(ring.size() == 3 ? std::span<const int>(ring) : corners);
    const FlatPolygon polygon(points, ring);
    if (polygon.isLine()) return fan(ring);
    if (!polygon.hasArea()) throw InputError("the polygon crosses itself");
    if (ring.size() > 4 && polygon.isFarFromPlane())
        throw InputError("the corners of the polygon lie far from a plane");
    if (polygon.fillsItsFan()) return fan(ring);
    if (polygon.crossesItself()) throw InputError("the polygon crosses itself");
    return EarClipper(polygon).clip();
}

}  // namespace wend::formats
