#include "app/views/volume/ray_casting.h"

#include <limits>
#include <utility>

namespace wend {

namespace {

/// Adds the nearest corner of the triangle.
SolidHit solidHit(const CutSurface& surface, const Points<3>& pose, const Ray& ray,
                  const TriangleTree::Hit& hit) {
    SolidHit result;
    if (hit.triangle < 0) return result;
    result.cell = surface.cells[hit.triangle];
    result.point = ray.origin + hit.distance * ray.direction;
    double closest = std::numeric_limits<double>::infinity();
    for (const auto& c : surface.triangles[hit.triangle])
        for (const int v : {c.from, c.to}) {
            const double distance = (pose.col(v) - result.point).norm();
            if (distance < closest) result.vertex = v;
            closest = std::min(closest, distance);
        }
    return result;
}

constexpr double kOnBorder = 1e-9;  // barycentric tolerance for points on the border of a cell

/// Returns the interval of the ray that the cut has left.
std::pair<double, double> leftOf(const Ray& ray, const std::optional<CutPlane>& cut) {
    const double far = std::numeric_limits<double>::infinity();
    if (!cut) return {0, far};
    const double height = cut->height(ray.origin), climb = cut->normal.dot(ray.direction);
    const double crossing = -height / climb;
    if (height > 0) return {climb < 0 ? crossing : far, far};
    return {0, climb > 0 ? crossing : far};
}

}  // namespace

void RayCasting::takeSurface(CutSurface surface) {
    m_surface = std::move(surface);
    m_surfaceStale = true;
}

const TriangleTree& RayCasting::tree(const Points<3>& pose) {
    if (m_surfaceStale) {
        m_points.emplace(m_surface);
        m_tree = TriangleTree(m_points->at(pose), std::move(m_points->triangles));
    } else if (m_poseStale) {
        m_tree.refit(m_points->at(pose));
    }
    m_surfaceStale = m_poseStale = false;
    return m_tree;
}

SolidHit RayCasting::hit(const Ray& ray, const Points<3>& pose) {
    const TriangleTree::Hit hit = tree(pose).firstHit(ray.origin, ray.direction);
    m_visited = hit.visited;
    return solidHit(m_surface, pose, ray, hit);
}

void SkinCasting::update(const VolumePicture& solid, const Points<3>& skinPose) {
    if (m_skinStale) {
        m_tree = TriangleTree(skinPose, solid.skin->triangles);
        m_locator.emplace(solid.rest->points, solid.rest->cells);
        m_isOuter.assign(solid.rest->vertexCount(), false);
        for (const Facet<3>& facet : *solid.facets)
            if (!facet.interior())
                for (const int v : facet.vertices) m_isOuter[v] = true;
    } else if (m_poseStale) {
        m_tree.refit(skinPose);
    }
    m_skinStale = m_poseStale = false;
}

/// Returns the cell at the rest place; outside all cells that of the nearest corner of its triangle.
int SkinCasting::cellOf(const VolumePicture& solid, const Vec<3>& point) const {
    const TriangleTree::Nearest there = m_tree.nearest(point);
    const auto& corners = solid.skin->triangles[there.triangle];
    Vec<3> rest = Vec<3>::Zero();
    for (int k = 0; k < 3; ++k) rest += there.weights[k] * solid.skin->points.col(corners[k]);
    if (const auto inside = m_locator->find(rest, kOnBorder)) return inside->cell;
    int nearest = 0;
    there.weights.maxCoeff(&nearest);
    return solid.embedding->cell(corners[nearest]);
}

/// Returns the nearest corner of the cell, preferring vertices on the solid's border.
int SkinCasting::vertexOf(const VolumePicture& solid, int cell, const Vec<3>& point) const {
    int best = -1;
    std::pair<bool, double> least;
    for (const int v : solid.rest->cells[cell]) {
        const std::pair<bool, double> rank(!m_isOuter[v], (solid.pose.col(v) - point).norm());
        if (best < 0 || rank < least) {
            best = v;
            least = rank;
        }
    }
    return best;
}

SolidHit SkinCasting::hit(const Ray& ray, const VolumePicture& solid, const Points<3>& skinPose,
                          const std::optional<CutPlane>& cut) {
    update(solid, skinPose);
    SolidHit result;
    const auto [from, to] = leftOf(ray, cut);
    if (!(from < to)) return result;
    const TriangleTree::Hit hit = m_tree.firstHit(ray.origin + from * ray.direction, ray.direction);
    m_visited = hit.visited;
    if (hit.triangle < 0 || from + hit.distance > to) return result;
    result.point = ray.origin + (from + hit.distance) * ray.direction;
    result.cell = cellOf(solid, result.point);
    result.vertex = vertexOf(solid, result.cell, result.point);
    return result;
}

}  // namespace wend
