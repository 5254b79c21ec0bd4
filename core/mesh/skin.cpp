#include "core/mesh/skin.h"

#include <Eigen/Geometry>
#include <map>

namespace wend {

Skin boundaryOf(const SimplicialMesh<3>& mesh) {
    Skin skin;
    std::vector<int> newId(static_cast<std::size_t>(mesh.vertexCount()), -1);
    for (const auto& facet : facetsOf(mesh)) {
        if (facet.interior()) continue;
        skin.triangles.push_back(facet.vertices);
        for (int v : facet.vertices) newId[v] = 0;
    }
    int count = 0;
    for (int& id : newId)
        if (id == 0) id = count++;
    skin.points.resize(3, count);
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (newId[v] >= 0) skin.points.col(newId[v]) = mesh.points.col(v);
    for (auto& triangle : skin.triangles)
        for (int& v : triangle) v = newId[v];
    return skin;
}

UnfoldedSkin unfolded(const Skin& skin) {
    UnfoldedSkin result;
    result.triangles = skin.triangles;
    for (int v = 0; v < skin.vertexCount(); ++v) result.vertices.push_back(v);
    if (skin.uvCorners.empty()) return result;

    std::vector<int> uvOf(result.vertices.size(), -1);  // of the copies
    std::map<std::pair<int, int>, int> copies;          // (vertex, texture point) → copy
    for (std::size_t t = 0; t < skin.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int v = skin.triangles[t][k], uv = skin.uvCorners[t][k];
            if (uvOf[v] < 0) {
                uvOf[v] = uv;
                copies[{v, uv}] = v;
            }
            const auto [copy, isNew] = copies.try_emplace({v, uv}, static_cast<int>(result.vertices.size()));
            if (isNew) {
                result.vertices.push_back(v);
                uvOf.push_back(uv);
            }
            result.triangles[t][k] = copy->second;
        }
    result.uv = Eigen::Matrix2Xd::Zero(2, static_cast<Eigen::Index>(uvOf.size()));
    for (std::size_t i = 0; i < uvOf.size(); ++i)
        if (uvOf[i] >= 0) result.uv.col(static_cast<Eigen::Index>(i)) = skin.uv.col(uvOf[i]);
    return result;
}

Points3 vertexNormals(const Points3& points, const std::vector<std::array<int, 3>>& triangles) {
    Points3 normals = Points3::Zero(3, points.cols());
    for (const auto& t : triangles) {
        const Vec3 normal = (points.col(t[1]) - points.col(t[0]))
                                .cross(points.col(t[2]) - points.col(t[0]))
                                .stableNormalized();
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = points.col(t[(k + 1) % 3]) - points.col(t[k]),
                       b = points.col(t[(k + 2) % 3]) - points.col(t[k]);
            normals.col(t[k]) += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
        }
    }
    for (Eigen::Index v = 0; v < normals.cols(); ++v) normals.col(v).stableNormalize();
    return normals;
}

}  // namespace wend
