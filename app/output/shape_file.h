#pragma once

#include <string>
#include <vector>

#include "app/engine/shape/shape.h"
#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_write_options.h"

namespace wend {

struct MeshFile;

/// Returns the values that are written with a deformed mesh: per cell "error_angle", "error_volume",
/// "error_metric", "ratio" (of its volume or area), "phi", and "B" (row-major) if the material has
/// directions; per vertex "velocity", if it has columns. `pose` may be the rest.
template <int Dim>
std::vector<MeshField> shapeFields(const Shape<Dim>& shape, const Points<Dim>& pose,
                                   const Points<Dim>& velocity = {});

/// Returns the values that are written to a file of that name: shapeFields(), and in a .vtu file (or on
/// standard output, "-") per vertex "displacement", per cell "F" (row-major, 3 × 3 in the plane too), and of
/// the pose and of the rest (name + "_rest") "scaled_jacobian", "aspect_ratio", "min_angle" and "max_angle"
/// in degrees: see CellShape.
template <int Dim>
std::vector<MeshField> fieldsFor(const std::string& path, const Shape<Dim>& shape, const Points<Dim>& pose,
                                 const Points<Dim>& velocity = {});

/// Returns the mesh of a pose with the other contents of the domain's file: uv, fields, labels, order and
/// count. For a picture, uv come from the rest mesh. `fields` replace those of the same name. Throws
/// InputError for a pose of another mesh.
template <int Dim>
MeshFile poseFile(const Shape<Dim>& shape, const Points<Dim>& pose,
                  const std::vector<MeshField>& fields = {});

/// Returns the columns of the vertices that meshes are written with: see MeshFile::made.
template <int Dim>
Points<Dim> writtenPart(const Shape<Dim>& shape, const Points<Dim>& columns);

/// Writes a pose. In space, formats of surfaces get the skin, with the fields at its vertices; others the
/// tetrahedra. Throws InputError.
template <int Dim>
void writeShape(const std::string& path, const Shape<Dim>& shape, const Points<Dim>& pose,
                const std::vector<MeshField>& fields = {}, const MeshWriteOptions& options = {});

/// Describes in one line what a file of that name would not hold of the shape's file; empty if it would hold
/// everything.
template <int Dim>
std::string lostInShape(const std::string& path, const Shape<Dim>& shape, const MeshWriteOptions& options);

/// Describes, for the user, hexahedra, wedges, pyramids and cells of second order whose Jacobian a pose turns
/// over at a corner; empty if there are none.
template <int Dim>
std::string turnedOver(const Shape<Dim>& shape, const Points<Dim>& pose);

/// Throws InputError if what a file of that name gets of the shape is more than its format holds: points
/// without triangles.
template <int Dim>
void requireHeldBy(const std::string& path, const Shape<Dim>& shape);

/// Throws InputError that lists the formats that a shape of this dimension can be written in if `extension`,
/// lower case with its dot, is of none. `path` is what the user named.
void requireShapeFormat(const std::string& path, const std::string& extension, int dimension);

/// Returns whether a format of solids keeps shapeFields().
bool holdsFields(const std::string& path);

/// Returns whether other programs find shapeFields() in the format.
bool carriesValues(const std::string& path);
/// Returns whether numbers in the format can be text or binary.
bool knowsEncodings(const std::string& path);

/// Returns whether a format is written with the skin of a solid.
bool isSkinFile(const std::string& path);

/// Writes consecutive poses to one file as morph targets of a .glb, `framesPerSecond` of them a second.
void writeAnimation(const std::string& path, const Shape<3>& shape, const std::vector<Points3>& poses,
                    double framesPerSecond);

/// Returns a ParaView collection (.pvd) of files in the same folder.
std::string collectionText(const std::vector<std::string>& files, const std::vector<double>& times);

}  // namespace wend
