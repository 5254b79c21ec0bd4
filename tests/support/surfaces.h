#pragma once

#include <cmath>
#include <map>

#include "core/meshing/surface.h"

namespace wend::test {

/// An axis-aligned box with n × n squares a side (2 n² triangles), outward oriented.
inline Surface box(const Vec3& low, const Vec3& high, int n = 1) {
    Surface surface;
    std::map<std::array<int, 3>, int> ids;
    std::vector<Vec3> points;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [entry, isNew] = ids.try_emplace(at, static_cast<int>(points.size()));
        const Vec3 t(at[0] / double(n), at[1] / double(n), at[2] / double(n));
        if (isNew) points.push_back(low + t.cwiseProduct(high - low));
        return entry->second;
    };
    const auto square = [&](int axis, int side, int i, int j) {
        const auto corner = [&](int u, int v) {
            std::array<int, 3> at{};
            at[axis] = side * n;
            at[(axis + 1) % 3] = i + u;
            at[(axis + 2) % 3] = j + v;
            return vertex(at);
        };
        const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        if (side == 1)
            surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {a, c, d}});
        else
            surface.triangles.insert(surface.triangles.end(), {{a, c, b}, {a, d, c}});
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) square(axis, side, i, j);
    surface.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        surface.points.col(static_cast<Eigen::Index>(i)) = points[i];
    return surface;
}

/// Both surfaces in one, nothing merged.
inline Surface joined(const Surface& a, const Surface& b) {
    Surface both = a;
    both.points.resize(3, a.points.cols() + b.points.cols());
    both.points << a.points, b.points;
    for (auto t : b.triangles) {
        for (int& id : t) id += a.vertexCount();
        both.triangles.push_back(t);
    }
    return both;
}

/// A Möbius band of n squares.
inline Surface moebius(int n) {
    Surface band;
    band.points.resize(3, 2 * n);
    for (int i = 0; i < n; ++i) {
        const double u = 2 * M_PI * i / n;
        for (int side = 0; side < 2; ++side) {
            const double w = 0.3 * (2 * side - 1), r = 1 + w * std::cos(u / 2);
            band.points.col(2 * i + side) = Vec3(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
        }
    }
    for (int i = 0; i < n; ++i) {
        const bool last = i == n - 1;
        const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
        band.triangles.insert(band.triangles.end(), {{a, b, c}, {b, d, c}});
    }
    return band;
}

/// Two plates of 1 × 1 and the thickness 0.2, apart by a slot between x = 0.2 and 0.2 + slot, and joined
/// below y = 0.2.
inline Surface fork(double slot) {
    const double right = 0.4 + slot;
    const std::vector<Vec2> profile{{0, 0},     {right, 0}, {right, 1}, {right - 0.2, 1}, {right - 0.2, 0.2},
                                    {0.2, 0.2}, {0.2, 1},   {0, 1}};
    const int n = static_cast<int>(profile.size());
    Surface surface;
    surface.points.resize(3, 2 * n);
    const auto quad = [&](int a, int b, int c, int d) {
        surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    for (int i = 0; i < n; ++i) {
        surface.points.col(i) << profile[i], 0;
        surface.points.col(n + i) << profile[i], 1;
        quad(i, (i + 1) % n, n + (i + 1) % n, n + i);
    }
    for (const auto& [a, b, c, d] :
         {std::array{0, 5, 6, 7}, std::array{1, 2, 3, 4}, std::array{0, 1, 4, 5}}) {
        quad(d, c, b, a);
        quad(n + a, n + b, n + c, n + d);
    }
    return surface;
}

}  // namespace wend::test
