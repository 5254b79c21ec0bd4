#include "core/mesh/formats/mesh_format.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/mesh/formats/boundary_values.h"
#include "core/mesh/formats/lost_parts.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

template <std::size_t N>
void requireVertices(const std::vector<std::array<int, N>>& cells, Eigen::Index vertexCount,
                     const char* kind) {
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (int v : cells[c])
            if (v < 0 || v >= vertexCount)
                throw InputError(std::string(kind) + " " + std::to_string(c) + " names vertex " +
                                 std::to_string(v) + ", but there are only " + std::to_string(vertexCount) +
                                 " (counted from 0)");
}

/// Throws InputError if a field has other than one value per component and vertex, or per component and cell.
void requireFields(const MeshFile& file) {
    for (const auto& field : file.fields) {
        const auto count = field.perCell ? cellCount(file) : file.points.cols();
        if (!field.ofCells.empty() && field.ofCells.size() != static_cast<std::size_t>(file.cells.size()) *
                                                                  static_cast<std::size_t>(field.components))
            throw InputError("the field " + inQuotes(field.name) + " has " +
                             std::to_string(field.ofCells.size()) + " values for the " +
                             std::to_string(file.cells.size()) + " cells of the file");
        if (field.components < 1 ||
            static_cast<Eigen::Index>(field.values.size()) != count * field.components)
            throw InputError("the field " + inQuotes(field.name) + " has " +
                             std::to_string(field.values.size()) + " values where " + std::to_string(count) +
                             " times " + std::to_string(field.components) + " are needed");
    }
    if (file.uv.cols() != 0 && file.uv.cols() != file.points.cols())
        throw InputError("there are " + std::to_string(file.uv.cols()) + " texture coordinates for " +
                         std::to_string(file.points.cols()) + " vertices");
}

/// Checks what every reader must guarantee and every printer may rely on.
void requireSound(const MeshFile& file, MeshNeeds needs = MeshNeeds::Cells) {
    if (file.points.cols() == 0) throw InputError("there is no vertex in it");
    if (cellCount(file) == 0 && needs == MeshNeeds::Cells)
        throw InputError(
            {sentence("Core",
                      "holds %1 points, but neither triangles nor tetrahedra between them: a surface has to "
                      "be made of the points first, as MeshLab and CloudCompare do"),
             file.points.cols()});
    for (Eigen::Index v = 0; v < file.points.cols(); ++v)
        if (!file.points.col(v).allFinite())
            throw InputError("vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
    requireVertices(file.triangles, file.points.cols(), "triangle");
    requireVertices(file.tetrahedra, file.points.cols(), "tetrahedron");
    for (const int v : file.cells.nodes)
        if (v < 0 || v >= file.points.cols())
            throw InputError("a cell names vertex " + std::to_string(v) + ", but there are only " +
                             std::to_string(file.points.cols()) + " (counted from 0)");
    requireFields(file);
}

bool canCarry(const MeshFormat& format, const MeshFile& mesh) {
    return mesh.tetrahedra.empty() || format.holdsTetrahedra;
}

void requireCarriable(const MeshFormat& format, const MeshFile& mesh) {
    if (canCarry(format, mesh)) return;
    std::string able;
    for (const auto& other : meshFormats())
        if (other.holdsTetrahedra) able += " " + std::string(other.extensions.front());
    throw InputError(std::string(format.article) + std::string(format.name) +
                     " file cannot hold tetrahedra; these can:" + able);
}

/// Returns the part of a mesh that is written, if the mesh was generated or its boundary was requested.
MeshFile asWritten(const MeshFile& mesh, const MeshFormat& format, const MeshWriteOptions& options) {
    MeshFile file = usedPart(mesh);
    if (!isVolume(file)) return file;
    if (file.triangles.empty() && options.boundary) return withBoundary(std::move(file));
    return mesh.made && !format.withBoundary && !options.boundary ? withoutBoundary(std::move(file)) : file;
}

/// Adds the numbers of the groups as the field "label", unless a field has them.
void addLabels(MeshFile& bag) {
    if (bag.groups.empty() || cellField(bag, {"label", "physical", "ref", "attribute", "material", "pid"}))
        return;
    const std::vector<long> numbers = groupNumbers(bag);
    MeshField field{"label", true, 1, {}, {numbers.begin(), numbers.end()}, Scalar::Int32};
    bag.fields.push_back(std::move(field));
}

/// Returns the mesh as the format is given it. Gmsh numbers triangles first; PLY has groups as a field alone.
MeshFile bagFor(const MeshFormat& format, const MeshFile& mesh, const MeshWriteOptions& options) {
    MeshFile bag = bagOf(asWritten(mesh, format, options), format.print == printGmsh);
    if (format.print == printPly) addLabels(bag);
    return bag;
}

constexpr CellKind kFirstOfSpace = CellKind::Tetrahedron;

bool holdsFaces(CellKind kind) {
    return kind == CellKind::Triangle || kind == CellKind::Quad || kind == CellKind::Polygon;
}
bool holdsFacesAndLines(CellKind kind) {
    return holdsFaces(kind) || kind == CellKind::Line;
}
bool holdsObj(CellKind kind) {
    return holdsFacesAndLines(kind) || kind == CellKind::PolyLine || kind == CellKind::Vertex;
}
bool holdsOff(CellKind kind) {
    return holdsFacesAndLines(kind) || kind == CellKind::PolyVertex;
}
bool holdsTriangles(CellKind kind) {
    return kind == CellKind::Triangle;
}
bool holdsAll(CellKind) {
    return true;
}
bool holdsPolyData(CellKind kind) {
    return factsOf(kind).dimension <= 2 && linearKind(kind) == kind;
}
bool holdsTetgen(CellKind kind) {
    return kind == CellKind::Triangle || kind == CellKind::Tetrahedron || kind == CellKind::Line;
}
/// Returns whether a kind is a line, a face of three or four corners or a cell of space, without nodes
/// between the corners.
bool holdsLinear(CellKind kind) {
    return kind == CellKind::Line || kind == CellKind::Triangle || kind == CellKind::Quad ||
           (kind >= kFirstOfSpace && linearKind(kind) == kind);
}
bool holdsUcd(CellKind kind) {
    return holdsLinear(kind) || kind == CellKind::Vertex;
}
bool holdsGmsh(CellKind kind) {
    return factsOf(kind).corners > 0;
}
bool holdsAbaqus(CellKind kind) {
    return holdsGmsh(kind) && kind != CellKind::Vertex && kind != CellKind::Quad9 &&
           kind != CellKind::Pyramid13 && kind != CellKind::Wedge18 && kind != CellKind::Hexahedron27;
}
bool holdsFoam(CellKind kind) {
    return holdsFaces(kind) || (kind >= kFirstOfSpace && linearKind(kind) == kind);
}
bool holdsMed(CellKind kind) {
    return holdsGmsh(kind);
}
bool holdsCgns(CellKind kind) {
    return holdsGmsh(kind);
}
bool holdsExodus(CellKind kind) {
    return holdsGmsh(kind);
}
bool holdsXdmf(CellKind kind) {
    return kind != CellKind::TriangleStrip;
}
bool holdsNastran(CellKind kind) {
    return holdsGmsh(kind) && kind != CellKind::Vertex && kind != CellKind::Line3 &&
           kind != CellKind::Quad9 && kind != CellKind::Wedge18 && kind != CellKind::Hexahedron27;
}

/// AVS UCD and Abaqus share an extension: a file of Abaqus begins with a keyword or a comment.
const MeshFormat& formatOfContent(const MeshFormat& format, const MeshSource& source) {
    if (format.read != readAbaqus) return format;
    const auto first = source.bytes.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || source.bytes[first] == '*') return format;
    for (const MeshFormat& other : meshFormats())
        if (other.read == readUcd) return other;
    return format;
}

}  // namespace

bool MeshFormat::holdsPointsAlone() const {
    return holds(CellKind::Vertex) || holds(CellKind::PolyVertex) || print == printPly;
}

const std::vector<MeshFormat>& meshFormats() {
    using enum GroupsHeld;
    static const std::vector<MeshFormat> formats = {
        // name, extensions, together, tetrahedra, withBoundary, fields, binary; article, reader, printer,
        // cells,
        // groups, texture, colours, fields of the file, colours of faces, normals
        {{"Wavefront OBJ", {".obj"}, 1, false, false, false, false},
         "a ",
         readObj,
         printObj,
         holdsObj,
         All,
         true,
         true,
         false,
         false,
         true},
        {{"PLY", {".ply"}, 1, false, false, true, true},
         "a ",
         readPly,
         printPly,
         holdsFacesAndLines,
         Numbers,
         true,
         true},
        {{"OFF", {".off"}, 1, false, false, false, false},
         "an ",
         readOff,
         printOff,
         holdsOff,
         None,
         true,
         true,
         false,
         true,
         true},
        {{"STL", {".stl"}, 1, false, false, false, true}, "an ", readStl, printStl, holdsTriangles, Names},
        {{"VTP (ParaView)", {".vtp"}, 1, false, false, true, true},
         "a ",
         readVtp,
         printVtp,
         holdsPolyData,
         Numbers,
         true,
         true,
         true},
        {{"VTU (ParaView)", {".vtu"}, 1, true, false, true, true},
         "a ",
         readVtu,
         printVtu,
         holdsAll,
         Numbers,
         true,
         true,
         true},
        {{"VTK", {".vtk"}, 1, true, false, true, true},
         "a ",
         readVtk,
         printVtk,
         holdsAll,
         Numbers,
         true,
         true,
         true},
        {{"Medit", {".mesh"}, 1, true, true, false, false}, "a ", readMedit, printMedit, holdsLinear, Lists},
        {{"Gmsh", {".msh"}, 1, true, true, true, true}, "a ", readGmsh, printGmsh, holdsGmsh, All},
        {{"Abaqus", {".inp"}, 1, true, true, false, false},
         "an ",
         readAbaqus,
         printAbaqus,
         holdsAbaqus,
         Sets},
        {{"Nastran", {".bdf", ".nas"}, 1, true, true, false, false},
         "a ",
         readNastran,
         printNastran,
         holdsNastran,
         Numbers},
        {{"OpenFOAM", {".foam"}, 1, true, true, false, false, true},
         "an ",
         readFoam,
         printFoam,
         holdsFoam,
         All},
        {{"MED (Salome)", {".med"}, 1, true, true, true, true}, "a ", readMed, printMed, holdsMed, Sets},
        {{"CGNS", {".cgns"}, 1, true, true, true, true}, "a ", readCgns, printCgns, holdsCgns, Sets},
        {{"Exodus", {".exo", ".e", ".ex2", ".g"}, 1, true, true, true, false},
         "an ",
         readExodus,
         printExodus,
         holdsExodus,
         Sets,
         false,
         false,
         true},
        {{"XDMF", {".xdmf", ".xmf"}, 1, true, false, true, false},
         "an ",
         readXdmf,
         printXdmf,
         holdsXdmf,
         Sets,
         false,
         false,
         true},
        {{"AVS UCD", {".avs", ".ucd"}, 1, true, false, true, false},
         "an ",
         readUcd,
         printUcd,
         holdsUcd,
         Numbers},
        {{"TetGen", {".node", ".ele"}, 2, true, false, false, false},
         "a ",
         readTetgen,
         printTetgen,
         holdsTetgen,
         Numbers},
    };
    return formats;
}

const MeshFormat& formatOf(const std::string& path) {
    const std::string extension = lowerExtension(path);
    std::string known;
    for (const auto& format : meshFormats())
        for (const auto candidate : format.extensions) {
            if (sameWord(candidate, extension)) return format;
            known += " " + std::string(candidate);
        }
    const auto what = extension.empty() ? std::string("without an extension") : inQuotes(extension);
    throw InputError(path, "the mesh format is not known: " + what + " is none of" + known);
}

MeshFile readSources(const MeshFormat& format, std::span<const MeshSource> files, MeshNeeds needs) {
    try {
        MeshFile file = formatOfContent(format, files[0]).read(files);
        requireSound(file, needs);
        return file;
    } catch (const InputError& error) {
        throw error.named(files[0].path);
    }
}

const std::vector<InputFormat>& inputFormats() {
    static const std::vector<InputFormat> formats = {{".glb", readGltf}, {".3mf", readThreeMf}};
    return formats;
}

MeshFile readSource(const InputFormat& format, const MeshSource& source, MeshNeeds needs) {
    try {
        MeshFile file = format.read(std::span(&source, 1));
        requireSound(file, needs);
        return file;
    } catch (const InputError& error) {
        throw error.named(source.path);
    }
}

std::vector<std::string> printed(const MeshFormat& format, const MeshFile& mesh,
                                 const MeshWriteOptions& options) {
    requireSound(mesh, format.holdsPointsAlone() ? MeshNeeds::Points : MeshNeeds::Cells);
    requireCarriable(format, mesh);
    return format.print(asHeld(format, bagFor(format, mesh, options)), options);
}

std::string lostIn(const MeshFormat& format, const MeshFile& mesh, const MeshWriteOptions& options) {
    if (mesh.made || !canCarry(format, mesh)) return {};
    MeshFormat asked = format;
    if (format.print == printStl && options.binary()) asked.groups = GroupsHeld::None;
    if (format.print == printGmsh && options.gmshVersion == 2) asked.groups = GroupsHeld::Names;
    return lostParts(asked, bagFor(format, mesh, options));
}

std::string lostInGltf(const MeshFile& mesh, const MeshWriteOptions& options) {
    MeshFormat format{
        {"binary glTF", {".glb"}, 1, false, false, false, true}, "a ", nullptr, nullptr, holdsTriangles};
    format.holdsTexture = true;
    return lostParts(format, bagFor(format, mesh, options));
}

}  // namespace wend::formats
