#include "app/output/point_file.h"

#include <algorithm>
#include <numeric>

#include "app/output/shape_file.h"
#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/mesh/embedding.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_formats.h"
#include "core/mesh/skin_file.h"
#include "core/mesh/turned_normals.h"

namespace wend {
namespace {

bool isTable(const std::string& path) {
    return path == "-" || isPointTable(path);
}

bool isGlb(const std::string& path) {
    return lowerExtension(path) == ".glb";
}

/// Returns whether the file keeps its own bytes with other vertices.
bool staysObj(const std::string& from, const std::string& to) {
    return lowerExtension(from) == ".obj" && lowerExtension(to) == ".obj";
}

/// Makes a cell of every point, because programs show cells only.
void addVertexCells(MeshFile& file) {
    for (int v = 0; v < file.points.cols(); ++v) file.cells.add(CellKind::Vertex, std::span(&v, 1));
}

std::string knownFormats(bool isOutput) {
    std::string list = " .csv .tsv .txt .xyz .dat";
    for (const std::string& one : isOutput ? meshFileExtensions() : readableMeshExtensions())
        list += " " + one;
    return list + (isOutput ? " .glb" : "");
}

}  // namespace

void requirePointFormat(const std::string& path, bool isOutput) {
    const std::string extension = lowerExtension(path);
    const std::vector<std::string> meshes = isOutput ? meshFileExtensions() : readableMeshExtensions();
    const bool isKnown =
        isTable(path) || std::ranges::find(meshes, extension) != meshes.end() || (isOutput && isGlb(path));
    if (!isKnown)
        throw InputError(path, "is in no known format of points; known are" + knownFormats(isOutput));
}

PointFile::PointFile(const std::string& path, int dimension) try : m_path(path), m_dimension(dimension) {
    if (isTable(path))
        m_table.emplace(readTextFile(path), dimension);
    else
        m_mesh = std::make_shared<const MeshFile>(readMeshFile(path, MeshNeeds::Points));
} catch (const InputError& error) {
    throw error.named(path);
}

const Points<3>& PointFile::points() const {
    return m_table ? m_table->points() : m_mesh->points;
}

void PointFile::requireHeldBy(const std::string& path) const {
    if (isTable(path) || staysObj(m_path, path)) return;
    const bool hasCells = m_mesh && (!m_mesh->triangles.empty() || !m_mesh->tetrahedra.empty());
    if (!hasCells && (isGlb(path) || !holdsPointsAlone(path)))
        throw InputError(path, "the format cannot hold points without triangles or tetrahedra");
    if (m_mesh && isVolume(*m_mesh) && isSkinFile(path))
        throw InputError(path, "the format cannot hold the tetrahedra of " + m_path);
}

std::string PointFile::lostIn(const std::string& path, const MeshWriteOptions& options) const {
    if (isTable(path)) {
        if (m_table) return {};
        return m_mesh->cells.empty() ? std::string() : "only the vertices are in a text file";
    }
    if (m_mesh) return isGlb(path) || staysObj(m_path, path) ? "" : lostInFile(path, *m_mesh, options);
    const int columns = m_table->furtherColumns();
    if (columns == 0) return {};
    return columns == 1 ? "1 column beside the coordinates is not in a mesh file"
                        : std::to_string(columns) + " columns beside the coordinates are not in a mesh file";
}

void PointFile::write(const std::string& path, const Points<3>& points,
                      const MeshWriteOptions& options) const {
    if (isTable(path) && m_table) return writeTextFile(path, m_table->withPoints(points));
    if (isTable(path))
        return writeTextFile(path, pointTableText(points, m_dimension, lowerExtension(path) == ".csv"));
    if (isGlb(path)) return writeSkin(path, readSkin(m_path), points, {}, options);
    if (staysObj(m_path, path)) {
        Skin skin;
        skin.path = m_path;
        return writeSkin(path, skin, points, {}, options);
    }
    MeshFile file = m_mesh ? *m_mesh : MeshFile();
    const Points<3> before = this->points();
    file.points = points;
    turnNormals(before, file);
    if (file.cells.empty() && file.triangles.empty() && file.tetrahedra.empty()) addVertexCells(file);
    writeMeshFile(path, file, options);
}

// --- The map ---

template <int Dim>
struct PointMap<Dim>::Data {
    SimplicialMesh<Dim> from;
    Embedding<Dim> embedding;
};

namespace {

template <int Dim>
SimplicialMesh<Dim> inOrderOf(SimplicialMesh<Dim> mesh, const std::vector<float>& depth) {
    if (depth.size() != mesh.cells.size()) return mesh;
    std::vector<int> order(mesh.cells.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int c) { return depth[static_cast<std::size_t>(c)]; });
    std::vector<Cell<Dim>> cells;
    for (const int c : order) cells.push_back(mesh.cells[static_cast<std::size_t>(c)]);
    mesh.cells = std::move(cells);
    return mesh;
}

/// Counts points well within two cells at least: the first of them and the last.
template <int Dim>
int coveredPoints(const SimplicialMesh<Dim>& mesh, const Points<Dim>& points) {
    constexpr double kInside = -1e-9;
    const std::vector<Cell<Dim>> backwards(mesh.cells.rbegin(), mesh.cells.rend());
    const PointLocator<Dim> last(mesh.points, mesh.cells), first(mesh.points, backwards);
    int count = 0;
    for (const auto point : points.colwise()) {
        const auto a = first.find(point, kInside), b = last.find(point, kInside);
        if (a && b && mesh.cellCount() - 1 - a->cell != b->cell) ++count;
    }
    return count;
}

}  // namespace

template <int Dim>
PointMap<Dim>::PointMap(SimplicialMesh<Dim> from, const std::vector<float>& depth, const Points<Dim>& points)
    : m_covered(coveredPoints<Dim>(from, points)) {
    SimplicialMesh<Dim> ordered = inOrderOf<Dim>(std::move(from), depth);
    Embedding<Dim> embedding(ordered, points);
    m_data = std::make_unique<const Data>(Data{std::move(ordered), std::move(embedding)});
}

template <int Dim>
PointMap<Dim>::~PointMap() = default;
template <int Dim>
PointMap<Dim>::PointMap(PointMap&&) noexcept = default;

template <int Dim>
Points<Dim> PointMap<Dim>::mapped(const Points<Dim>& to) const {
    return m_data->embedding.carry(m_data->from, to);
}

template <int Dim>
int PointMap<Dim>::outside() const {
    return m_data->embedding.outside();
}

template class PointMap<2>;
template class PointMap<3>;

}  // namespace wend
