#include "core/mesh/turned_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_file.h"
#include "core/mesh/skin.h"

namespace wend {
namespace {

/// Returns the field of one component per vertex with a name, or null.
template <class File>
auto vertexField(File& file, const std::string& name) -> decltype(&file.fields.front()) {
    const auto found = std::ranges::find_if(file.fields, [&](const auto& field) {
        return !field.perCell && field.components == 1 && field.name == name;
    });
    return found == file.fields.end() ? nullptr : &*found;
}

bool isVectorOfNormals(const MeshField& field) {
    std::string name = field.name;
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return !field.perCell && field.components == 3 && name.find("normal") != std::string::npos;
}

void turn(const Eigen::Quaterniond& by, double& x, double& y, double& z) {
    if (by.vec().isZero()) return;
    const Eigen::Vector3d turned = by * Eigen::Vector3d(x, y, z);
    x = turned.x();
    y = turned.y();
    z = turned.z();
}

/// Returns the least rotation from a direction to another one; from one to its opposite, it turns about any
/// axis across. Eigen's own takes seven seconds to compile, for a decomposition that finds this axis.
Eigen::Quaterniond turnBetween(const Vec3& from, const Vec3& to) {
    const Vec3 a = from.normalized(), b = to.normalized();
    const double cosine = b.dot(a);
    Eigen::Quaterniond turn;
    if (cosine < -1 + Eigen::NumTraits<double>::dummy_precision()) {
        turn.w() = 0;
        turn.vec() = a.unitOrthogonal();
        return turn;
    }
    const double s = std::sqrt((1 + cosine) * 2);
    turn.vec() = a.cross(b) * (1 / s);
    turn.w() = s * 0.5;
    return turn;
}

}  // namespace

std::vector<Eigen::Quaterniond> turnsOf(const Points3& before, const Points3& now,
                                        const std::vector<std::array<int, 3>>& triangles) {
    const Points3 old = vertexNormals(before, triangles), turned = vertexNormals(now, triangles);
    std::vector<Eigen::Quaterniond> turns(static_cast<std::size_t>(old.cols()),
                                          Eigen::Quaterniond::Identity());
    for (Eigen::Index v = 0; v < old.cols(); ++v)
        if (old.col(v) != turned.col(v) && !old.col(v).isZero() && !turned.col(v).isZero())
            turns[static_cast<std::size_t>(v)] = turnBetween(old.col(v), turned.col(v));
    return turns;
}

std::array<const MeshField*, 3> normalFieldsOf(const MeshFile& file) {
    std::array<const MeshField*, 3> fields{};
    for (std::size_t k = 0; k < 3; ++k)
        if (!(fields[k] = vertexField(file, kNormalNames[k]))) return {};
    return fields;
}

/// Finds the fields that are normals, and turns each vertex's by the rotation from its normal before to the
/// present one.
void turnNormals(const Points3& before, MeshFile& file) {
    MeshField *x = vertexField(file, "nx"), *y = vertexField(file, "ny"), *z = vertexField(file, "nz");
    const bool apart = x && y && z;
    if (!apart && std::ranges::none_of(file.fields, isVectorOfNormals)) return;
    const std::vector<Eigen::Quaterniond> turns = turnsOf(before, file.points, file.triangles);
    for (std::size_t v = 0; v < turns.size(); ++v) {
        if (apart) turn(turns[v], x->values[v], y->values[v], z->values[v]);
        for (MeshField& field : file.fields)
            if (isVectorOfNormals(field))
                turn(turns[v], field.values[3 * v], field.values[3 * v + 1], field.values[3 * v + 2]);
    }
}

bool isNormals(const MeshField& field) {
    const bool isPart = !field.perCell && field.components == 1 && field.name.size() == 2;
    return isVectorOfNormals(field) ||
           (isPart && (field.name == "nx" || field.name == "ny" || field.name == "nz"));
}

}  // namespace wend
