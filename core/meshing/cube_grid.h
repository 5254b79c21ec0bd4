#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/base/types.h"
#include "core/meshing/surface.h"

namespace wend {

/// A grid of equal cubes around a surface. It numbers and places the cubes, and finds those near a triangle.
class CubeGrid {
  public:
    using Place = std::array<int, 3>;

    CubeGrid() = default;
    /// Centres the grid on the box, except for a shift of at most half a cube (in cubes), with `layers` of
    /// cubes beyond it on every side.
    CubeGrid(const Eigen::AlignedBox3d& box, double edge, int layers, const Vec3& shift = Vec3::Zero());
    /// Returns the number of cubes without overflow.
    static double sizeFor(const Eigen::AlignedBox3d& box, double edge, int layers);

    double edge() const { return m_edge; }
    const Place& counts() const { return m_counts; }
    std::int64_t size() const { return stride(2) * m_counts[2]; }
    /// Returns the difference of the numbers of neighbours along an axis.
    std::int64_t stride(int axis) const {
        std::int64_t stride = 1;
        for (int k = 0; k < axis; ++k) stride *= m_counts[k];
        return stride;
    }
    /// Returns the number of the cube at a place.
    std::int64_t number(const Place& place) const {
        return place[0] + m_counts[0] * (place[1] + static_cast<std::int64_t>(m_counts[1]) * place[2]);
    }
    /// Returns the place of the cube with a number.
    Place place(std::int64_t number) const {
        const auto rest = number / m_counts[0];
        return {static_cast<int>(number % m_counts[0]), static_cast<int>(rest % m_counts[1]),
                static_cast<int>(rest / m_counts[1])};
    }
    /// Returns the cube that contains a point, or the nearest one for a point outside.
    std::int64_t numberAt(const Vec3& p) const {
        return number({index(0, p[0]), index(1, p[1]), index(2, p[2])});
    }
    /// Returns the lowest corner of the cube at a place.
    Vec3 corner(const Place& place) const { return m_low + m_edge * Vec3(place[0], place[1], place[2]); }
    /// Returns the centre of the cube at a place.
    Vec3 centre(const Place& place) const { return corner(place) + Vec3::Constant(m_edge / 2); }

    using Triangle = std::array<Vec3, 3>;
    /// Calls take(number) for every cube that is at most `distance` away, along the axes, from the triangle.
    /// Large triangles are taken in pieces: a cube may be named several times.
    template <class Take>
    void forEachNear(const Triangle& triangle, double distance, const Take& take) const;

  private:
    int index(int axis, double coordinate) const;

    double m_edge = 1;
    Vec3 m_low = Vec3::Zero();
    Place m_counts{};
};

/// Returns whether a cube of half edge `half` around the origin intersects the triangle.
bool meetsCube(const CubeGrid::Triangle& triangle, double half);

/// Returns the full cubes of a grid in increasing order: those within `distance` of the surface, and those
/// enclosed by it. With a width `gap` the enclosed ones are those that a cube of that width cannot reach from
/// outside. Without one they are those unreachable by any path of cubes, and those that the surface faces
/// outwards from in four of the six axis directions: the inside of a bust that is open below. Throws
/// Cancelled.
std::vector<std::int64_t> fullCubes(const CubeGrid& grid, const Surface& surface, double distance, double gap,
                                    const std::stop_token& stop);

/// Returns the corners of a triangle of the surface.
CubeGrid::Triangle cornersOf(const Surface& surface, int triangle);

template <class Take>
void CubeGrid::forEachNear(const Triangle& triangle, double distance, const Take& take) const {
    const Vec3 low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]),
               high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
    if ((high - low).maxCoeff() > 2 * m_edge) {
        int longest = 0;  // edge, from this corner
        for (int k = 1; k < 3; ++k)
            if ((triangle[(k + 1) % 3] - triangle[k]).squaredNorm() >
                (triangle[(longest + 1) % 3] - triangle[longest]).squaredNorm())
                longest = k;
        const int next = (longest + 1) % 3;
        Triangle half = triangle;
        half[next] = (triangle[longest] + triangle[next]) / 2;
        forEachNear(half, distance, take);
        half = triangle;
        half[longest] = (triangle[longest] + triangle[next]) / 2;
        return forEachNear(half, distance, take);
    }
    Place from, to;
    for (int k = 0; k < 3; ++k) {
        from[k] = index(k, low[k] - distance);
        to[k] = index(k, high[k] + distance);
    }
    for (int z = from[2]; z <= to[2]; ++z)
        for (int y = from[1]; y <= to[1]; ++y)
            for (int x = from[0]; x <= to[0]; ++x) {
                const Vec3 middle = centre({x, y, z});
                if (meetsCube({triangle[0] - middle, triangle[1] - middle, triangle[2] - middle},
                              m_edge / 2 + distance))
                    take(number({x, y, z}));
            }
}

}  // namespace wend
