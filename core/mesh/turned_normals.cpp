#include "core/mesh/turned_normals.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/mesh_file.h"
#include "core/mesh/skin.h"

namespace wend {
namespace {

using Turns = std::vector<Eigen::Quaterniond>;

Turns turnsOf(const Points<3>& before, const MeshFile& file) {
    const Points<3> old = vertexNormals(before, file.triangles),
                    now = vertexNormals(file.points, file.triangles);
    Turns turns(static_cast<std::size_t>(old.cols()), Eigen::Quaterniond::Identity());
    for (Eigen::Index v = 0; v < old.cols(); ++v)
        if (old.col(v) != now.col(v) && !old.col(v).isZero() && !now.col(v).isZero())
            turns[static_cast<std::size_t>(v)].setFromTwoVectors(old.col(v), now.col(v));
    return turns;
}

MeshField* vertexField(MeshFile& file, const std::string& name) {
    const auto found = std::ranges::find_if(file.fields, [&](const auto& field) {
        return !field.perCell && field.components == 1 && field.name == name;
    });
    return found == file.fields.end() ? nullptr : &*found;
}

bool isNormals(const MeshField& field) {
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

}  // namespace

/// Finds the fields that are normals, and turns each vertex's by the rotation from its normal before to the
/// present one.
void turnNormals(const Points<3>& before, MeshFile& file) {
    MeshField *x = vertexField(file, "nx"), *y = vertexField(file, "ny"), *z = vertexField(file, "nz");
    const bool apart = x && y && z;
    if (!apart && std::ranges::none_of(file.fields, isNormals)) return;
    const Turns turns = turnsOf(before, file);
    for (std::size_t v = 0; v < turns.size(); ++v) {
        if (apart) turn(turns[v], x->values[v], y->values[v], z->values[v]);
        for (MeshField& field : file.fields)
            if (isNormals(field))
                turn(turns[v], field.values[3 * v], field.values[3 * v + 1], field.values[3 * v + 2]);
    }
}

}  // namespace wend
