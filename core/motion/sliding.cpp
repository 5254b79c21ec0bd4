#include "core/motion/sliding.h"

#include <Eigen/LU>
#include <algorithm>

#include "core/base/error.h"
#include "core/motion/rest_guide.h"

namespace wend {
namespace {

// Relative to the size: a vertex this near to a sharp line stays on it; one that is farther from its surface
// is taken for a mistake.
constexpr double kOnLine = 1e-6, kFarthest = 1e-2;

}  // namespace

template <int Dim>
std::shared_ptr<const GuideSurface<Dim>> surfaceOf(const Handle<Dim>& handle,
                                                   const std::vector<ConstrainedPoint>& points,
                                                   const SimplicialMesh<Dim>& rest) {
    if (handle.activeFrom > 0)
        throw InputError("it slides on a surface, so it has to be active from the start");
    for (const Motion<Dim>& motion : handle.motions)
        if (std::holds_alternative<FieldMotion<Dim>>(motion.kind))
            throw InputError("it slides on a surface, which a field does not move");
    std::vector<int> vertices;
    for (const ConstrainedPoint& point : points) {
        if (point.terms.size() > 1) throw InputError("only vertices can slide");
        vertices.push_back(point.terms.front().first);
    }
    const Slide<Dim>& slide = *handle.slide;
    if (slide.mesh) return std::make_shared<const GuideSurface<Dim>>(*slide.mesh);
    const GuideMesh<Dim> guide = restGuide<Dim>(rest, vertices);
    if (guide.triangles.empty() && guide.segments.empty())
        throw InputError("no " + std::string(Dim == 2 ? "edge" : "triangle") +
                         " of the boundary is between the points that slide");
    return std::make_shared<const GuideSurface<Dim>>(guide);
}

template <int Dim>
std::vector<ConstrainedPoint> onSurface(const GuideSurface<Dim>& surface,
                                        const std::vector<ConstrainedPoint>& points,
                                        const Points<Dim>& rest) {
    std::vector<ConstrainedPoint> result;
    for (ConstrainedPoint point : points) {
        const Vec<Dim> p = rest.col(point.terms.front().first);
        point.track = surface.trackAt(p, kOnLine);
        const Contact<Dim> contact = surface.contact(point.track, p);
        if ((contact.point - p).norm() > kFarthest)
            throw InputError("vertex " + std::to_string(point.terms.front().first) +
                             " is not on the surface on which it is to slide");
        for (point.normal = 0; point.normal < contact.count; ++point.normal) result.push_back(point);
    }
    return result;
}

template <int Dim>
void Constraints<Dim>::findRestNormals(const Points<Dim>& rest) {
    if (std::ranges::none_of(m_points, &ConstrainedPoint::isGuided)) return;
    for (const ConstrainedPoint& point : m_points) {
        Vec<Dim>& normal = m_restNormals.emplace_back(Vec<Dim>::Zero());
        if (!point.isGuided()) continue;
        const auto& surface = *m_holds[static_cast<size_t>(point.handle)].surface;
        normal = surface.contact(point.track, point.in<Dim>(rest)).normals.col(point.normal);
    }
}

/// Calls visit(place in the list, point, place on the surface at time t, its velocity, direction).
template <int Dim>
template <class Visit>
void Constraints<Dim>::forContacts(const std::vector<int>& ids, const Points<Dim>& shape, double t, Side side,
                                   Visit&& visit) const {
    std::vector<MovingMap<Dim>> bodies;
    std::vector<Mat<Dim>> inverses;
    for (const HandleTimeline<Dim>& timeline : m_timelines) {
        bodies.push_back(timeline.bodyAt(t, side));
        inverses.push_back(bodies.back().position.A.inverse());
    }
    for (size_t i = 0; i < ids.size(); ++i) {
        const ConstrainedPoint& point = m_points[static_cast<size_t>(ids[i])];
        if (!point.isGuided()) continue;
        const auto handle = static_cast<size_t>(point.handle);
        const MovingMap<Dim>& body = bodies[handle];
        const Vec<Dim> p = inverses[handle] * (point.in<Dim>(shape) - body.position.b);
        const Contact<Dim> contact = m_holds[handle].surface->contact(point.track, p);
        const Vec<Dim> normal = (body.position.A * contact.normals.col(point.normal)).normalized();
        visit(static_cast<Eigen::Index>(i), point, body.position(contact.point), body.velocity(contact.point),
              normal);
    }
}

template <int Dim>
void Constraints<Dim>::guide(const std::vector<int>& ids, const Points<Dim>& shape, double t, Side side,
                             Points<Dim>& positions, Points<Dim>& velocities, Points<Dim>& normals) const {
    normals.setZero(Dim, static_cast<Eigen::Index>(ids.size()));
    forContacts(ids, shape, t, side,
                [&](Eigen::Index i, const ConstrainedPoint&, const Vec<Dim>& place, const Vec<Dim>& velocity,
                    const Vec<Dim>& normal) {
                    positions.col(i) = place;
                    velocities.col(i) = normal * normal.dot(velocity);
                    normals.col(i) = normal;
                });
}

template <int Dim>
double Constraints<Dim>::pull(const std::vector<int>& ids, double t, Side side, Points<Dim>& shape) const {
    double farthest = 0;
    forContacts(ids, shape, t, side,
                [&](Eigen::Index, const ConstrainedPoint& point, const Vec<Dim>& place, const Vec<Dim>&,
                    const Vec<Dim>&) {
                    auto p = shape.col(point.terms.front().first);
                    farthest = std::max(farthest, (place - p).norm());
                    p = place;
                });
    return farthest;
}

#define WEND_INSTANTIATE(Dim)                                                                        \
    template std::shared_ptr<const GuideSurface<Dim>> surfaceOf(                                     \
        const Handle<Dim>&, const std::vector<ConstrainedPoint>&, const SimplicialMesh<Dim>&);       \
    template std::vector<ConstrainedPoint> onSurface(                                                \
        const GuideSurface<Dim>&, const std::vector<ConstrainedPoint>&, const Points<Dim>&);         \
    template void Constraints<Dim>::findRestNormals(const Points<Dim>&);                             \
    template void Constraints<Dim>::guide(const std::vector<int>&, const Points<Dim>&, double, Side, \
                                          Points<Dim>&, Points<Dim>&, Points<Dim>&) const;           \
    template double Constraints<Dim>::pull(const std::vector<int>&, double, Side, Points<Dim>&) const
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);

}  // namespace wend
