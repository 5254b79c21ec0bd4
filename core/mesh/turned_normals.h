#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "core/base/types.h"

namespace wend {

struct MeshField;
struct MeshFile;

/// The fields of the components of normals of vertices.
inline constexpr std::array<const char*, 3> kNormalNames = {"nx", "ny", "nz"};

/// Returns for every vertex the smallest rotation from the normal of a surface there to that after a move. It
/// is exactly the identity where the normal is the same, and where a vertex has no triangle with an area.
/// From a normal to its opposite it is a half turn about some axis across.
std::vector<Eigen::Quaterniond> turnsOf(const Points3& before, const Points3& now,
                                        const std::vector<std::array<int, 3>>& triangles);

/// Turns the normals of vertices that are fields of a file (nx, ny, nz, or three components of a name with
/// "normal") as its triangles turned from `before` to their present points: by the smallest rotation between
/// the surface's own normals there. Where nothing moves, they keep their bits.
void turnNormals(const Points3& before, MeshFile& file);

/// Returns the fields nx, ny and nz of vertices, in this order; null unless all three are there.
std::array<const MeshField*, 3> normalFieldsOf(const MeshFile& file);

/// Returns whether a field has normals of vertices, or a component of them.
bool isNormals(const MeshField& field);

}  // namespace wend
