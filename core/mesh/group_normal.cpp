#include "core/mesh/group_normal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/plane_frame.h"

namespace wend {
namespace {

template <int Dim>
using FacetVertices = std::array<int, Dim>;

/// Returns the normal times the length or area.
Vec2 areaNormal(const Points3& points, const FacetVertices<2>& f) {
    const Vec3 along = points.col(f[1]) - points.col(f[0]);
    return {along.y(), -along.x()};
}
Vec3 areaNormal(const Points3& points, const FacetVertices<3>& f) {
    return (points.col(f[1]) - points.col(f[0])).cross(points.col(f[2]) - points.col(f[0])) / 2;
}

template <int Dim>
FacetVertices<Dim> sortedFacet(FacetVertices<Dim> facet) {
    std::ranges::sort(facet);
    return facet;
}

/// Returns the facets on the boundary of the mesh with their outward normals.
template <int Dim>
std::map<FacetVertices<Dim>, Vec<Dim>> outwardNormals(const MeshFile& file) {
    SimplicialMesh<Dim> mesh;
    mesh.points = file.points.topRows<Dim>();
    if constexpr (Dim == 2)
        mesh.cells = file.triangles;
    else
        mesh.cells = file.tetrahedra;
    std::map<FacetVertices<Dim>, Vec<Dim>> normals;
    for (const auto& facet : facetsOf<Dim>(mesh)) {
        if (facet.interior()) continue;
        Vec<Dim> normal = areaNormal(file.points, facet.vertices);
        for (const int v : mesh.cells[static_cast<std::size_t>(facet.cells[0])])
            if (normal.dot(mesh.points.col(v) - mesh.points.col(facet.vertices[0])) > 0 &&
                std::ranges::count(facet.vertices, v) == 0)
                normal = -normal;
        normals.emplace(sortedFacet<Dim>(facet.vertices), normal);
    }
    return normals;
}

/// Returns −1 for a closed surface whose triangles are ordered in the opposite direction.
double outwardSign(const MeshFile& file) {
    if (isVolume(file)) return 1;
    double volume = 0;
    for (const auto& t : file.triangles)
        volume += file.points.col(t[0]).dot(file.points.col(t[1]).cross(file.points.col(t[2])));
    Vec3 sum = Vec3::Zero();  // 0 of a closed surface
    double area = 0;
    for (const auto& t : file.triangles) {
        const Vec3 normal = areaNormal(file.points, t);
        sum += normal;
        area += normal.norm();
    }
    return sum.norm() < 1e-9 * area && volume < 0 ? -1 : 1;
}

/// Returns the cells of the group that are facets of a mesh of that dimension.
template <int Dim>
std::vector<FacetVertices<Dim>> facetsIn(const MeshFile& file, const std::vector<int>& cells) {
    std::vector<FacetVertices<Dim>> facets;
    if constexpr (Dim == 3) {
        const std::set<int> within(cells.begin(), cells.end());
        for (std::size_t t = 0; t < file.cellOfTriangle.size(); ++t)
            if (within.contains(file.cellOfTriangle[t])) facets.push_back(file.triangles[t]);
    } else {
        for (const int c : cells) {
            if (file.cells.dimension(c) != 1) continue;
            const auto nodes = file.cells[c];
            const std::size_t last = file.cells.kinds[static_cast<std::size_t>(c)] == CellKind::PolyLine
                                         ? nodes.size()
                                         : std::min<std::size_t>(nodes.size(), 2);  // a node between them
            for (std::size_t k = 0; k + 1 < last; ++k) facets.push_back({nodes[k], nodes[k + 1]});
        }
    }
    return facets;
}

/// Returns the facets of the boundary all of whose vertices are in the list.
template <int Dim>
std::vector<FacetVertices<Dim>> facetsBetween(const MeshFile& file, const std::vector<int>& vertices,
                                              const std::map<FacetVertices<Dim>, Vec<Dim>>& boundary) {
    const std::set<int> within(vertices.begin(), vertices.end());
    const auto isWithin = [&](const FacetVertices<Dim>& facet) {
        return std::ranges::all_of(facet, [&](int v) { return within.contains(v); });
    };
    std::vector<FacetVertices<Dim>> facets;
    for (const auto& [facet, normal] : boundary)
        if (isWithin(facet)) facets.push_back(facet);
    if constexpr (Dim == 3)
        if (!isVolume(file)) std::ranges::copy_if(file.triangles, std::back_inserter(facets), isWithin);
    return facets;
}

/// Returns the file of a mesh in a plane, in the coordinates of that plane.
std::optional<MeshFile> inItsPlane(const MeshFile& file) {
    const auto plane = planeOf(file.points, file.triangles);
    if (!plane || plane->isXy()) return std::nullopt;
    MeshFile flat = file;
    flat.points = plane->toPlane(file.points);
    flat.points.row(2).setZero();
    return flat;
}

/// Returns the facets of a group of a file in space, or in the plane of x and y.
template <int Dim>
std::vector<FacetVertices<Dim>> facetsOfGroup(const MeshFile& file, const std::string& name,
                                              const std::map<FacetVertices<Dim>, Vec<Dim>>& boundary) {
    const GroupParts group = groupParts(file, name, std::nullopt);
    auto facets = group.cells.empty() ? facetsBetween<Dim>(file, group.vertices, boundary)
                                      : facetsIn<Dim>(file, group.cells);
    if (facets.empty())
        throw InputError("the group '" + name + "' has no " + (Dim == 2 ? "lines" : "surface") +
                         " whose normal could be taken");
    return facets;
}

}  // namespace

template <int Dim>
GroupFacets<Dim> groupFacets(const MeshFile& file, const std::string& name) {
    if constexpr (Dim == 2)
        if (const auto flat = inItsPlane(file)) return groupFacets<2>(*flat, name);
    return {file.points.topRows<Dim>(), facetsOfGroup<Dim>(file, name, outwardNormals<Dim>(file))};
}

template <int Dim>
Vec<Dim> groupNormal(const MeshFile& file, const std::string& name) {
    if constexpr (Dim == 2)
        if (const auto flat = inItsPlane(file)) return groupNormal<2>(*flat, name);
    const auto boundary = outwardNormals<Dim>(file);
    const auto facets = facetsOfGroup<Dim>(file, name, boundary);
    Vec<Dim> sum = Vec<Dim>::Zero();
    double total = 0;
    for (const auto& facet : facets) {
        const auto outward = boundary.find(sortedFacet<Dim>(facet));
        const Vec<Dim> normal = outward != boundary.end() ? outward->second : areaNormal(file.points, facet);
        sum += normal;
        total += normal.norm();
    }
    constexpr double kNoNormal = 1e-9;
    if (!(sum.norm() > kNoNormal * total))
        throw InputError("the normals of the group '" + name + "' cancel out: it has no mean normal");
    if constexpr (Dim == 3) sum *= outwardSign(file);
    return sum.normalized();
}

template GroupFacets<2> groupFacets<2>(const MeshFile&, const std::string&);
template GroupFacets<3> groupFacets<3>(const MeshFile&, const std::string&);
template Vec2 groupNormal<2>(const MeshFile&, const std::string&);
template Vec3 groupNormal<3>(const MeshFile&, const std::string&);

}  // namespace wend
