#include "app/views/volume/glyphs.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "app/engine/motion/places.h"
#include "app/style/marks.h"
#include "core/mesh/decompositions.h"

namespace wend {

namespace {

constexpr std::size_t kMost = 60000;  // triangles
constexpr double kLift = 5e-4;        // of the diagonal

}  // namespace

DrawVertex drawVertex(const Vec3& p, const Vec3& normal, QRgb colour) {
    const auto floats = [](const Vec3& v) {
        return std::array{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    };
    const auto byte = [](int x) { return static_cast<unsigned char>(x); };
    return {floats(p), floats(normal), {byte(qRed(colour)), byte(qGreen(colour)), byte(qBlue(colour)), 255}};
}

namespace {

constexpr double kMostGlyphs = 1000;
constexpr int kSides = 8;

class Builder {
  public:
    explicit Builder(QRgb colour) : m_colour(colour) {}

    void corner(const Vec3& p, const Vec3& n) {
        m_vertices.push_back(drawVertex(p, n.normalized(), m_colour));
    }
    /// Adds a band of a body of revolution from radius r at p to radius s at q.
    void band(const Vec3& p, double r, const Vec3& q, double s) {
        const Vec3 along = (q - p).normalized(), u = along.unitOrthogonal(), v = along.cross(u);
        const auto way = [&](int i) -> Vec3 {
            const double a = 2 * std::numbers::pi * i / kSides;
            return std::cos(a) * u + std::sin(a) * v;
        };
        for (int i = 0; i < kSides; ++i) {
            const Vec3 a = way(i), b = way(i + 1);
            for (const auto& [point, normal] : {std::pair<Vec3, Vec3>{p + r * a, a},
                                                {p + r * b, b},
                                                {q + s * b, b},
                                                {p + r * a, a},
                                                {q + s * b, b},
                                                {q + s * a, a}})
                corner(point, normal);
        }
    }
    void arrow(const Vec3& from, const Vec3& by, double width) {
        const double length = by.norm(), head = std::min(0.4 * length, 4.5 * width);
        const Vec3 neck = from + (1 - head / length) * by;
        band(from, width / 2, neck, width / 2);
        band(neck, 0, neck - 1e-3 * by, 1.4 * width);
        band(neck, 1.4 * width, from + by, 0);
    }
    /// Adds the image of the unit sphere under A around the centre.
    void ellipsoid(const Vec3& centre, const Mat3& A) {
        const Mat3 N = A.inverse().transpose();
        const auto on = [](int i, int j) {
            const double theta = std::numbers::pi * i / 6, a = 2 * std::numbers::pi * j / kSides;
            return Vec3(std::sin(theta) * std::cos(a), std::sin(theta) * std::sin(a), std::cos(theta));
        };
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < kSides; ++j)
                for (const auto& p :
                     {on(i, j), on(i + 1, j), on(i + 1, j + 1), on(i, j), on(i + 1, j + 1), on(i, j + 1)})
                    corner(centre + A * p, N * p);
    }
    std::vector<DrawVertex> take() { return std::move(m_vertices); }

  private:
    QRgb m_colour;
    std::vector<DrawVertex> m_vertices;
};

/// Returns every k-th item, so that at most `most` are left; fewer for larger marks.
std::vector<int> thinned(const std::set<int>& all, double most) {
    const double room = most / (markSize() * markSize());
    const std::size_t step = 1 + static_cast<std::size_t>(static_cast<double>(all.size()) / room);
    std::vector<int> kept;
    std::size_t i = 0;
    for (const int x : all)
        if (i++ % step == 0) kept.push_back(x);
    return kept;
}

}  // namespace

std::vector<DrawVertex> velocityArrows(const PosedFrame<3>& frame, const Points3& velocity,
                                       const CutSurface& surface, QRgb colour) {
    std::set<int> drawn;
    for (const auto& triangle : surface.triangles)
        for (const auto& corner : triangle) drawn.insert(corner.weight < 0.5 ? corner.from : corner.to);
    const double fastest = velocity.colwise().norm().maxCoeff();
    const double size = marked(frame.diagonal);
    Builder builder(colour);
    if (fastest <= 0) return {};
    for (const int v : thinned(drawn, kMostGlyphs)) {
        const Vec3 by = 0.1 * size / fastest * velocity.col(v);
        if (by.norm() > 1e-3 * size) builder.arrow(frame.pose.col(v), by, 0.0025 * size);
    }
    return builder.take();
}

std::vector<DrawVertex> stiffnessEllipsoids(const PosedFrame<3>& frame, const CutSurface& surface,
                                            QRgb colour) {
    if (!frame.material || frame.material->anisotropy.empty()) return {};
    std::map<int, std::size_t> seen;  // visible place of each stiff cell
    std::set<int> stiff;
    for (std::size_t t = 0; t < surface.cells.size(); ++t)
        if (const int c = surface.cells[t]; !frame.material->anisotropy[c].isIdentity(1e-6))
            seen.try_emplace(c, t), stiff.insert(c);
    Builder builder(colour);
    for (const int c : thinned(stiff, kMostGlyphs / 2)) {
        Vec3 centre = Vec3::Zero();  // on the surface, so that half of it is visible
        for (const auto& corner : surface.triangles[seen[c]])
            centre += ((1 - corner.weight) * frame.pose.col(corner.from) +
                       corner.weight * frame.pose.col(corner.to)) /
                      3;
        const double size = marked(std::cbrt(std::abs(cellMeasure<3>(frame.pose, frame.rest->cells[c]))));
        const auto [axes, values] = principalAxes<3>(frame.material->anisotropy[c]);
        const Vec3 lengths = size * (values / values.maxCoeff()).cwiseSqrt();
        Mat3 A = cellRotation<3>(frame, c) * axes * lengths.asDiagonal();
        if (A.determinant() < 0) A.col(0) = -A.col(0);  // its outside stays outside
        builder.ellipsoid(centre, A);
    }
    return builder.take();
}

std::vector<DrawVertex> faultMarks(const PosedFrame<3>& frame, const PoseFaults<3>& faults,
                                   const std::function<bool(const Vec3&)>& hidden) {
    const SimplicialMesh<3>& rest = *frame.rest;
    const double side = cellMeasure<3>(rest.points, rest.cells.front()) > 0 ? 1 : -1;
    std::vector<DrawVertex> marks;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const std::array<Vec3, 3> corners{a, b, c};
        if (marks.size() > 3 * kMost || std::ranges::any_of(corners, hidden)) return;
        const Vec3 normal = side * (b - a).cross(c - a).stableNormalized();
        for (const Vec3& p : corners)
            marks.push_back(drawVertex(p + kLift * frame.diagonal * normal, normal, kWrong));
    };
    for (const auto& place : faults.crossings)
        for (const int t : place.members) {
            const auto& [a, b, c] = faults.border[t];
            add(faults.points.col(a), faults.points.col(b), faults.points.col(c));
        }
    const Points3& pose = frame.pose;
    for (const auto& place : faults.blown)
        for (const int cell : place.members) {
            const auto& [a, b, c, d] = rest.cells[cell];
            for (const auto& [p, q, r] : {std::array{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}})
                add(pose.col(p), pose.col(q), pose.col(r));
        }
    return marks;
}

}  // namespace wend
