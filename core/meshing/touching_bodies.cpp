#include "core/meshing/touching_bodies.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/number_text.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

constexpr double kReach = 1e-6;  // of the extent: what counts as in a plane

/// Returns the number of each triangle's component, from 1. Edges of more than two triangles connect none, so
/// that bodies with vertices in common stay apart.
std::vector<int> componentsOf(const Surface& surface) {
    DisjointSets sets(surface.triangleCount());
    for (const SurfaceEdge& edge : edgesOf(surface))
        if (edge.triangles.size() == 2) sets.join(edge.triangles[0], edge.triangles[1]);
    std::map<int, int> numbers;
    std::vector<int> components;
    for (int t = 0; t < surface.triangleCount(); ++t)
        components.push_back(
            numbers.try_emplace(sets.root(t), static_cast<int>(numbers.size()) + 1).first->second);
    return components;
}

/// How two triangles that intersect meet.
enum class Meeting { Crossing, Touching, InOnePlane };

class Meetings {
  public:
    explicit Meetings(const Surface& surface) : m_surface(surface) {
        const Eigen::Vector3d extent =
            surface.points.rowwise().maxCoeff() - surface.points.rowwise().minCoeff();
        m_reach = kReach * extent.norm();
    }
    Meeting between(int a, int b) const {
        const auto [lowA, highA] = sides(a, b);
        const auto [lowB, highB] = sides(b, a);
        if (std::max({-lowA, highA, -lowB, highB}) <= m_reach)
            return overlap(a, b) && overlap(b, a) ? Meeting::InOnePlane : Meeting::Touching;
        const bool crosses = -lowA > m_reach && highA > m_reach && -lowB > m_reach && highB > m_reach;
        return crosses ? Meeting::Crossing : Meeting::Touching;
    }
    Eigen::Vector3d middleOf(int triangle) const {
        const auto& [a, b, c] = m_surface.triangles[static_cast<std::size_t>(triangle)];
        return (m_surface.points.col(a) + m_surface.points.col(b) + m_surface.points.col(c)) / 3;
    }

  private:
    /// Returns whether no side of one triangle has all of another one, in the same plane, beyond it.
    bool overlap(int of, int other) const {
        const auto& corners = m_surface.triangles[static_cast<std::size_t>(of)];
        const auto at = [&](int k) {
            return Eigen::Vector3d(m_surface.points.col(corners[static_cast<std::size_t>(k % 3)]));
        };
        const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d outward = (at(k + 1) - at(k)).cross(normal).normalized();
            if (std::ranges::all_of(m_surface.triangles[static_cast<std::size_t>(other)], [&](int v) {
                    return outward.dot(m_surface.points.col(v) - at(k)) >= -m_reach;
                }))
                return false;
        }
        return true;
    }
    /// Returns how far the corners of one triangle reach to both sides of another's plane.
    std::array<double, 2> sides(int of, int plane) const {
        const auto& [a, b, c] = m_surface.triangles[static_cast<std::size_t>(plane)];
        const Eigen::Vector3d p = m_surface.points.col(a), q = m_surface.points.col(b),
                              r = m_surface.points.col(c);
        const Eigen::Vector3d normal = (q - p).cross(r - p).normalized();
        double low = 0, high = 0;
        for (const int v : m_surface.triangles[static_cast<std::size_t>(of)]) {
            const double height = normal.dot(m_surface.points.col(v) - p);
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return {low, high};
    }

    const Surface& m_surface;
    double m_reach;
};

}  // namespace

std::vector<TouchingBodies> touchingBodies(const Surface& surface,
                                           const std::vector<std::array<int, 2>>& intersecting) {
    if (intersecting.empty()) return {};
    const std::vector<int> component = componentsOf(surface);
    const Meetings meetings(surface);
    std::map<std::array<int, 2>, TouchingBodies> found;
    std::map<std::array<int, 2>, bool> cross;
    for (const auto& [a, b] : intersecting) {
        const auto [first, second] =
            std::minmax(component[static_cast<std::size_t>(a)], component[static_cast<std::size_t>(b)]);
        const Meeting meeting = meetings.between(a, b);
        if (first == second || meeting == Meeting::Crossing) {
            cross[{first, second}] = true;
            continue;
        }
        const bool inPlane = meeting == Meeting::InOnePlane;
        auto [entry, isNew] = found.try_emplace(
            {first, second}, TouchingBodies{first, second, inPlane, meetings.middleOf(inPlane ? b : a), 0});
        ++entry->second.pairs;
        if (inPlane && !entry->second.alongAFace) {
            entry->second.alongAFace = true;
            entry->second.place = meetings.middleOf(b);
        }
    }
    std::vector<TouchingBodies> touching;
    for (const auto& [pair, bodies] : found)
        if (!cross.contains(pair)) touching.push_back(bodies);
    return touching;
}

Message textOf(const TouchingBodies& one) {
    const std::string place =
        numberText(one.place.x()) + " " + numberText(one.place.y()) + " " + numberText(one.place.z());
    return {one.alongAFace
                ? sentence(
                      "Core",
                      "bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both "
                      "the same triangles there or leave a gap")
                : sentence("Core",
                           "bodies %1 and %2 touch along an edge or at a point (near %3): give both the same "
                           "triangles there or leave a gap"),
            one.first, one.second, place};
}

}  // namespace wend
