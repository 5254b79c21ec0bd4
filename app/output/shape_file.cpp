#include "app/output/shape_file.h"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "app/output/output_set.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/number_text.h"
#include "core/energy/distortion.h"
#include "core/mesh/cell_shape.h"
#include "core/mesh/embedding.h"
#include "core/mesh/file_cells.h"
#include "core/mesh/gltf.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_formats.h"
#include "core/mesh/skin_file.h"
#include "core/mesh/turned_normals.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

template <int Dim>
MeshField directionsField(const std::vector<Mat<Dim>>& anisotropy) {
    MeshField field{"B", true, Dim * Dim, {}};
    for (const Mat<Dim>& B : anisotropy)
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j) field.values.push_back(B(i, j));
    return field;
}

/// Makes a field of three components in the plane, too, because other programs take no others for vectors.
template <int Dim>
MeshField vectorField(const char* name, const Points<Dim>& vectors) {
    MeshField field{name, false, 3, {}};
    for (Eigen::Index i = 0; i < vectors.cols(); ++i)
        for (int a = 0; a < 3; ++a) field.values.push_back(a < Dim ? vectors(a, i) : 0);
    return field;
}

template <int Dim>
MeshField gradientField(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    MeshField field{"F", true, 9, {}};
    for (const Mat<Dim>& F : deformationGradients(rest, pose))
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                field.values.push_back(i < Dim && j < Dim ? F(i, j) : (i == j ? 1 : 0));
    return field;
}

void addQuality(const std::vector<CellShape>& shapes, const std::string& suffix,
                std::vector<MeshField>& fields) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    MeshField jacobian{"scaled_jacobian" + suffix, true, 1, {}}, aspect{"aspect_ratio" + suffix, true, 1, {}},
        least{"min_angle" + suffix, true, 1, {}}, greatest{"max_angle" + suffix, true, 1, {}};
    for (const CellShape& shape : shapes) {
        jacobian.values.push_back(shape.scaledJacobian);
        aspect.values.push_back(shape.aspectRatio);
        least.values.push_back(kDegrees * shape.minAngle);
        greatest.values.push_back(kDegrees * shape.maxAngle);
    }
    for (MeshField* field : {&jacobian, &aspect, &least, &greatest}) fields.push_back(std::move(*field));
}

/// Returns the values of cells at the vertices: means over the cells around, weighted with their rest
/// volumes.
std::vector<double> atVertices(const SimplicialMesh<3>& rest, const MeshField& field) {
    std::vector<double> values(static_cast<std::size_t>(rest.vertexCount()) * field.components, 0.0);
    std::vector<double> weights(static_cast<std::size_t>(rest.vertexCount()), 0.0);
    for (int c = 0; c < rest.cellCount(); ++c) {
        const double weight = std::abs(cellMeasure<3>(rest.points, rest.cells[c]));
        for (int v : rest.cells[c]) {
            weights[v] += weight;
            for (int k = 0; k < field.components; ++k)
                values[v * field.components + k] += weight * field.values[c * field.components + k];
        }
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (const double weight = weights[i / field.components]; weight > 0) values[i] /= weight;
    return values;
}

/// Interpolates a field of the solid at the vertices of the skin embedded in it.
MeshField onSkin(const Shape<3>& shape, const MeshField& field) {
    const std::vector<double> values = field.perCell ? atVertices(*shape.rest, field) : field.values;
    MeshField carried{field.name, false, field.components, {}};
    const int count = shape.exported().vertexCount();
    carried.values.resize(static_cast<std::size_t>(count) * field.components);
    Points3 one = Points3::Zero(3, shape.rest->vertexCount());
    for (int k = 0; k < field.components; ++k) {
        for (int v = 0; v < shape.rest->vertexCount(); ++v) one(0, v) = values[v * field.components + k];
        const Points3 there = shape.exportedEmbedding().interpolate(*shape.rest, one);
        for (int v = 0; v < count; ++v) carried.values[v * field.components + k] = there(0, v);
    }
    return carried;
}

/// Turns vectors and gradients of a mesh in another plane than that of x and y.
void turnFields(const PlaneFrame& plane, std::vector<MeshField>& fields) {
    if (plane.isXy()) return;
    for (MeshField& field : fields) {
        const int width = field.components;
        if (width != 3 && width != 9) continue;
        for (std::size_t at = 0; at < field.values.size(); at += static_cast<std::size_t>(width)) {
            Eigen::Map<Eigen::Matrix3Xd> columns(&field.values[at], 3, width / 3);
            columns = (plane.axes * columns).eval();
            if (width == 9) columns = (columns * plane.axes.transpose()).eval();
        }
    }
}

/// Moves the nodes between the corners of cells, and those of separate lines and vertices, as the shape
/// around them.
template <int Dim>
void carryNodes(const Shape<Dim>& shape, const Points<Dim>& pose, const Points3& before, MeshFile& file) {
    const std::vector<int> nodes = carriedNodes(file);
    if (nodes.empty()) return;
    const Points3 there = before(Eigen::all, nodes);
    const Points<Dim> rest = ownCoordinates(shape, there);
    file.points(Eigen::all, nodes) =
        inSpace(shape, there, Points<Dim>(Embedding<Dim>(*shape.rest, rest).carry(*shape.rest, pose)));
}

void addUv(const Shape<2>& shape, MeshFile& file) {
    const auto pixels = restInPixels(shape).points.leftCols(shape.rest->vertexCount());
    file.uv.resize(2, pixels.cols());
    file.uv.row(0) = pixels.row(0) / shape.picture->width;
    file.uv.row(1) = 1 - pixels.row(1).array() / shape.picture->height;
}

}  // namespace

template <int Dim>
std::vector<MeshField> shapeFields(const Shape<Dim>& shape, const Points<Dim>& pose,
                                   const Points<Dim>& velocity) {
    const Distortion error = distortion(*shape.rest, pose);
    std::vector<MeshField> fields{{"error_angle", true, 1, error.angle},
                                  {"error_volume", true, 1, error.volume},
                                  {"error_metric", true, 1, error.metric},
                                  {"ratio", true, 1, error.ratio},
                                  {"phi", true, 1, shape.material->phi}};
    if (!shape.material->anisotropy.empty())
        fields.push_back(directionsField<Dim>(shape.material->anisotropy));
    if (velocity.cols() > 0) fields.push_back(vectorField<Dim>("velocity", velocity));
    return fields;
}

template <int Dim>
std::vector<MeshField> fieldsFor(const std::string& path, const Shape<Dim>& shape, const Points<Dim>& pose,
                                 const Points<Dim>& velocity) {
    std::vector<MeshField> fields = shapeFields(shape, pose, velocity);
    const SimplicialMesh<Dim>& rest = *shape.rest;
    fields.push_back(vectorField<Dim>("displacement", pose - rest.points));
    if (Dim == 3 && path != "-" && isSkinFile(path)) return fields;  // without those of cells
    fields.push_back(gradientField<Dim>(rest, pose));
    addQuality(cellShapes<Dim>(pose, rest.cells), "", fields);
    addQuality(cellShapes<Dim>(rest.points, rest.cells), "_rest", fields);
    return fields;
}

template <int Dim>
MeshFile poseFile(const Shape<Dim>& shape, const Points<Dim>& pose, const std::vector<MeshField>& fields) {
    MeshFile file = shape.source ? *shape.source : toMeshFile<Dim>(*shape.rest);
    if (file.points.cols() != pose.cols())
        throw InputError("the mesh has " + std::to_string(file.points.cols()) + " vertices, its pose " +
                         std::to_string(pose.cols()));
    const Points3 before = file.points;
    file.points = inSpace(shape, before, pose);
    carryNodes<Dim>(shape, pose, before, file);
    turnNormals(before, file);
    if constexpr (Dim == 2)
        if (!shape.source && shape.picture) addUv(shape, file);
    std::vector<MeshField> turned = fields;
    if constexpr (Dim == 2) turnFields(shape.plane, turned);
    for (const MeshField& field : turned) {
        std::erase_if(file.fields, [&](const MeshField& old) {
            return old.name == field.name && old.perCell == field.perCell;
        });
        file.fields.push_back(field);
    }
    return file;
}

template <int Dim>
Points<Dim> writtenPart(const Shape<Dim>& shape, const Points<Dim>& columns) {
    if (!shape.source || !shape.source->made) return columns;
    const std::vector<bool> used = usedVertices<Dim>(columns.cols(), shape.rest->cells);
    std::vector<int> kept;
    for (int v = 0; v < columns.cols(); ++v)
        if (used[v]) kept.push_back(v);
    return columns(Eigen::all, kept);
}

template <int Dim>
void writeShape(const std::string& path, const Shape<Dim>& shape, const Points<Dim>& pose,
                const std::vector<MeshField>& fields, const MeshWriteOptions& options) {
    if constexpr (Dim == 3)
        if (isSkinFile(path)) {
            std::vector<MeshField> carried;
            if (holdsFields(path))
                for (const MeshField& field : fields) carried.push_back(onSkin(shape, field));
            return writeSkin(path, shape.exported(), shape.exportedEmbedding().carry(*shape.rest, pose),
                             carried, options);
        }
    writeMeshFile(path, poseFile(shape, pose, fields), options);
}

template <int Dim>
std::string lostInShape(const std::string& path, const Shape<Dim>& shape, const MeshWriteOptions& options) {
    if (Dim == 3 && isSkinFile(path)) {
        if constexpr (Dim == 3) return lostInSkin(path, shape.exported(), options);
    }
    return shape.source ? lostInFile(path, *shape.source, options) : std::string();
}

template <int Dim>
std::string turnedOver(const Shape<Dim>& shape, const Points<Dim>& pose) {
    if (!shape.source || shape.source->made || !hasWholeCells(*shape.source)) return {};
    return turnedCells(*shape.source, poseFile<Dim>(shape, pose, {}).points);
}

template <int Dim>
void requireHeldBy(const std::string& path, const Shape<Dim>& shape) {
    if constexpr (Dim == 3)
        if (isSkinFile(path)) requireSkinHeldBy(path, shape.exported());
}

void requireShapeFormat(const std::string& path, const std::string& extension, int dimension) {
    if (extension == ".foam" && std::filesystem::path(path).filename() != "points")
        throw InputError(path,
                         "only the points of an OpenFOAM case are written: name the file \"points\", for the "
                         "folder constant/polyMesh of a copy of the case");
    std::vector<std::string> known = meshFileExtensions();
    if (dimension == 3) known.push_back(".glb");
    if (std::ranges::find(known, extension) != known.end()) return;
    std::string list;
    for (const std::string& one : known) list += " " + one;
    throw InputError(path, "is in no known mesh format; known are" + list);
}

/// Returns whether a format keeps fields: two of those with the skin do.
bool holdsFields(const std::string& path) {
    return !isSkinFile(path) || lowerExtension(path) == ".ply" || lowerExtension(path) == ".vtp";
}

namespace {

/// Returns whether the format of the path has the property.
bool isOneWith(bool MeshFormatFacts::*fact, const std::string& path) {
    return std::ranges::any_of(meshFormatFacts(), [&](const MeshFormatFacts& format) {
        return format.*fact && std::ranges::count(format.extensions, lowerExtension(path)) > 0;
    });
}

}  // namespace

bool carriesValues(const std::string& path) {
    return isOneWith(&MeshFormatFacts::holdsFields, path);
}

bool knowsEncodings(const std::string& path) {
    return isOneWith(&MeshFormatFacts::knowsBinary, path);
}

bool isSkinFile(const std::string& path) {
    return std::ranges::count(skinFileExtensions(), lowerExtension(path)) > 0;
}

void writeAnimation(const std::string& path, const Shape<3>& shape, const std::vector<Points3>& poses,
                    double framesPerSecond) {
    std::vector<Points3> carried;
    std::vector<double> times;
    for (const Points3& pose : poses) {
        times.push_back(static_cast<double>(times.size()) / framesPerSecond);
        carried.push_back(shape.embedding->carry(*shape.rest, pose));
    }
    writeGltf(path, gltfScene(*shape.skin, carried, times));
}

std::string collectionText(const std::vector<std::string>& files, const std::vector<double>& times) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t i = 0; i < files.size(); ++i) {
        text += "<DataSet timestep=\"";
        appendNumber(text, times[i]);
        text += "\" part=\"0\" file=\"";
        for (char c : files[i])
            text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
        text += "\"/>\n";
    }
    return text + "</Collection>\n</VTKFile>\n";
}

#define WEND_INSTANTIATE(Dim)                                                                              \
    template std::vector<MeshField> shapeFields<Dim>(const Shape<Dim>&, const Points<Dim>&,                \
                                                     const Points<Dim>&);                                  \
    template std::vector<MeshField> fieldsFor<Dim>(const std::string&, const Shape<Dim>&,                  \
                                                   const Points<Dim>&, const Points<Dim>&);                \
    template MeshFile poseFile<Dim>(const Shape<Dim>&, const Points<Dim>&, const std::vector<MeshField>&); \
    template std::string lostInShape<Dim>(const std::string&, const Shape<Dim>&, const MeshWriteOptions&); \
    template void requireHeldBy<Dim>(const std::string&, const Shape<Dim>&);                               \
    template std::string turnedOver<Dim>(const Shape<Dim>&, const Points<Dim>&);                           \
    template Points<Dim> writtenPart<Dim>(const Shape<Dim>&, const Points<Dim>&);                          \
    template void writeShape<Dim>(const std::string&, const Shape<Dim>&, const Points<Dim>&,               \
                                  const std::vector<MeshField>&, const MeshWriteOptions&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
