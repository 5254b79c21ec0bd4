#include "app/output/mapped_points.h"

#include <utility>

#include "app/output/shape_file.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {

template <int Dim>
MappedPoints<Dim>::MappedPoints(const Shape<Dim>& shape, const RunOptions& options, Notice notice,
                                Depths depths)
    : m_shape(shape), m_options(options), m_notice(std::move(notice)), m_depths(std::move(depths)) {
    for (const PointsOutput& one : m_options.outputs.points) {
        const PointFile& file = m_files.emplace_back(one.in, pointDimension());
        file.requireHeldBy(one.out);
        if (const std::string lost = file.lostIn(one.out, m_options.meshes); !lost.empty())
            m_notice(one.out + ": " + lost);
        if (!m_options.inverse) m_maps.push_back(mapFrom(*carrier(), file, 0));
    }
}

template <int Dim>
void MappedPoints<Dim>::write(double time, const Points<Dim>& pose, OutputSet& files) {
    const auto rest = carrier();
    const Points<Dim> bent = carrierIn(pose);
    for (std::size_t k = 0; k < m_files.size(); ++k) {
        const PointFile& file = m_files[k];
        Points<Dim> own;
        if (m_options.inverse) {
            SimplicialMesh<Dim> from = *rest;
            from.points = bent;
            own = mapFrom(from, file, time).mapped(rest->points);
        } else {
            own = m_maps[k].mapped(bent);
        }
        const Points<3> points = inSpace(m_shape, file.points(), own);
        files.add(m_options.outputs.points[k].out, ".csv",
                  [&](const std::string& to) { file.write(to, points, m_options.meshes); });
    }
}

/// Points of a flat mesh in another plane than that of x and y have three coordinates.
template <int Dim>
int MappedPoints<Dim>::pointDimension() const {
    if constexpr (Dim == 2) return m_shape.plane.isXy() ? 2 : 3;
    return Dim;
}

/// Returns the mesh that carries points, with the attached parts of a picture.
template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> MappedPoints<Dim>::carrier() const {
    if constexpr (Dim == 2) return drawnRest(m_shape);
    return m_shape.rest;
}

template <int Dim>
Points<Dim> MappedPoints<Dim>::carrierIn(const Points<Dim>& pose) const {
    if constexpr (Dim == 2)
        if (m_shape.texture) return m_shape.texture->withRiders(pose);
    return pose;
}

template <int Dim>
PointMap<Dim> MappedPoints<Dim>::mapFrom(const SimplicialMesh<Dim>& mesh, const PointFile& file,
                                         double time) const {
    std::vector<float> order;
    if constexpr (Dim == 2) order = m_depths(time);
    PointMap<Dim> map(mesh, order, ownCoordinates(m_shape, file.points()));
    const auto tellOf = [&](int count, const std::string& where) {
        if (count > 0)
            m_notice(file.path() + ": " + std::to_string(count) + " of " +
                     std::to_string(file.points().cols()) + " points " + (count == 1 ? "lies " : "lie ") +
                     where);
    };
    tellOf(map.outside(),
           "outside the shape: such points follow the nearest place of its border, as the shape turns and "
           "stretches there");
    tellOf(map.covered(), std::string("where the shape covers itself: ") +
                              (Dim == 2 ? "the front counts" : "the last cell there counts"));
    return map;
}

template class MappedPoints<2>;
template class MappedPoints<3>;

}  // namespace wend
