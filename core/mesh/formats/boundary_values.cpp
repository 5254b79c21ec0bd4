#include "core/mesh/formats/boundary_values.h"

#include <algorithm>

namespace wend::formats {
namespace {

using Face = std::array<int, 3>;

Face sortedFace(Face face) {
    std::sort(face.begin(), face.end());
    return face;
}

Face faceOpposite(const std::array<int, 4>& cell, int corner) {
    return sortedFace({cell[(corner + 1) % 4], cell[(corner + 2) % 4], cell[(corner + 3) % 4]});
}

template <std::size_t N>
void rename(std::vector<std::array<int, N>>& cells, const std::vector<int>& newId) {
    for (auto& cell : cells)
        for (int& v : cell) v = newId[v];
}

std::vector<double> valuesAt(const MeshField& field, const std::vector<int>& vertices) {
    std::vector<double> values;
    values.reserve(vertices.size() * field.components);
    for (const int v : vertices)
        for (int k = 0; k < field.components; ++k) values.push_back(field.values[v * field.components + k]);
    return values;
}

}  // namespace

/// Sorts the triangles, and finds the faces of the tetrahedra among them by binary search.
std::vector<int> cellsBehind(const MeshFile& mesh) {
    std::vector<std::pair<Face, int>> triangles;  // with their numbers
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        triangles.emplace_back(sortedFace(mesh.triangles[t]), static_cast<int>(t));
    std::sort(triangles.begin(), triangles.end());
    std::vector<int> behind(triangles.size(), -1);
    for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
        for (int corner = 0; corner < 4; ++corner) {
            const Face face = faceOpposite(mesh.tetrahedra[c], corner);
            auto it = std::lower_bound(triangles.begin(), triangles.end(), std::pair(face, -1));
            for (; it != triangles.end() && it->first == face; ++it)
                if (behind[it->second] < 0) behind[it->second] = static_cast<int>(c);
        }
    return behind;
}

MeshFile withoutBoundary(MeshFile mesh) {
    mesh.triangles.clear();
    mesh.labels.clear();
    mesh.labelNames.clear();
    return mesh;
}

/// Renumbers the vertices of a generated mesh so that those without a cell disappear.
MeshFile usedPart(const MeshFile& mesh) {
    if (!mesh.made) return mesh;
    std::vector<int> newId(static_cast<std::size_t>(mesh.points.cols()), -1);
    for (const auto& cell : mesh.tetrahedra)
        for (const int v : cell) newId[v] = 0;
    for (const auto& cell : mesh.triangles)
        for (const int v : cell) newId[v] = 0;
    if (std::ranges::count(newId, -1) == 0) return mesh;
    std::vector<int> kept;
    for (std::size_t v = 0; v < newId.size(); ++v) {
        if (newId[v] < 0) continue;
        newId[v] = static_cast<int>(kept.size());
        kept.push_back(static_cast<int>(v));
    }
    MeshFile part = mesh;
    part.points = mesh.points(Eigen::all, kept);
    if (mesh.uv.cols() > 0) part.uv = mesh.uv(Eigen::all, kept);
    rename(part.triangles, newId);
    rename(part.tetrahedra, newId);
    for (MeshField& field : part.fields)
        if (!field.perCell) field.values = valuesAt(field, kept);
    return part;
}

}  // namespace wend::formats
