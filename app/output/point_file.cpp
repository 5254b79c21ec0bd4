#include "app/output/point_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "app/output/shape_file.h"
#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/number_text.h"
#include "core/mesh/embedding.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_formats.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"
#include "core/mesh/turned_normals.h"

namespace wend {

namespace {

constexpr std::string_view kBlanks = " \t\r", kMark = "\xef\xbb\xbf";  // a byte order mark

std::string lowered(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

/// Returns which coordinate a column of that name holds.
std::optional<int> axisOf(const std::string& name) {
    for (int k = 0; k < 3; ++k)
        for (const std::string& known :
             {std::string(1, "xyz"[k]), "points:" + std::to_string(k), "points_" + std::to_string(k)})
            if (name == known) return k;
    return std::nullopt;
}

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

/// Goes through the lines of the text.
class PointTable::Reader {
  public:
    explicit Reader(PointTable& table) : m_table(table), m_text(table.m_text) {}

    void read() {
        std::size_t at = m_text.starts_with(kMark) ? kMark.size() : 0;
        for (; at < m_text.size(); ++m_line) {
            const std::size_t end = std::min(m_text.find('\n', at), m_text.size());
            if (!isCommentOfXyz()) readLine({at, end});
            at = end + 1;
        }
        if (m_values.empty())
            throw InputError(std::string("has no row of ") +
                             (m_table.m_dimension == 2 ? "2 numbers (x, y)" : "3 numbers (x, y, z)"));
        const auto count = static_cast<Eigen::Index>(m_values.size()) / m_table.m_dimension;
        m_table.m_points = Points3::Zero(3, count);
        m_table.m_points.topRows(m_table.m_dimension) =
            Eigen::Map<const Eigen::MatrixXd>(m_values.data(), m_table.m_dimension, count);
    }

  private:
    std::string_view view(const Field& field) const {
        return std::string_view(m_text).substr(field.begin, field.end - field.begin);
    }
    /// Returns a field without blanks and quotes around it.
    Field trimmed(Field field, std::string_view without = " \t\r\"'") const {
        while (field.begin < field.end && without.find(m_text[field.begin]) != std::string_view::npos)
            ++field.begin;
        while (field.begin < field.end && without.find(m_text[field.end - 1]) != std::string_view::npos)
            --field.end;
        return field;
    }
    bool isCommentOfXyz() const { return m_line == 2 && m_countsAtoms; }

    void readLine(Field line) {
        line = trimmed(line, kBlanks);
        const std::string_view text = view(line);
        const std::size_t mark = text.starts_with("//") ? 2 : text.starts_with('#') || text.starts_with('%');
        line.begin += mark;
        const std::vector<Field> fields = fieldsOf(line);
        if (fields.empty()) return;
        if (m_values.empty() && readHeader(fields)) return;
        if (mark > 0) return;
        m_countsAtoms = m_line == 1 && fields.size() == 1 && isCount(view(fields[0]));
        if (m_columns.empty() && !findColumns(fields)) return;
        takePoint(fields);
    }
    static bool isCount(std::string_view text) {
        return text.find_first_not_of("0123456789") == std::string_view::npos;
    }

    /// Blanks separate where nothing else does.
    std::vector<Field> fieldsOf(const Field& line) const {
        char separator = ' ';
        for (const char one : {'\t', ',', ';'})
            if (view(line).find(one) != std::string_view::npos) separator = one;
        std::vector<Field> fields;
        for (std::size_t at = line.begin; at < line.end;) {
            const std::size_t end = std::min(m_text.find(separator, at), line.end);
            const Field field = trimmed({at, end});
            if (separator != ' ' || field.begin < field.end) fields.push_back(field);
            at = end + 1;
        }
        return fields;
    }

    bool readHeader(const std::vector<Field>& fields) {
        std::array<int, 3> columns{-1, -1, -1};
        for (std::size_t k = 0; k < fields.size(); ++k)
            if (const auto axis = axisOf(lowered(view(fields[k])))) columns[*axis] = static_cast<int>(k);
        if (std::any_of(columns.begin(), columns.begin() + m_table.m_dimension,
                        [](int column) { return column < 0; }))
            return false;
        m_columns.assign(columns.begin(), columns.begin() + m_table.m_dimension);
        return true;
    }

    /// Takes the first numbers of a row that has enough of them.
    bool findColumns(const std::vector<Field>& fields) {
        std::vector<int> columns;
        for (std::size_t k = 0; k < fields.size(); ++k)
            if (parseNumber(view(fields[k]))) columns.push_back(static_cast<int>(k));
        if (static_cast<int>(columns.size()) < m_table.m_dimension) return false;
        columns.resize(static_cast<std::size_t>(m_table.m_dimension));
        m_columns = columns;
        return true;
    }

    void takePoint(const std::vector<Field>& fields) {
        for (const int column : m_columns) {
            if (column >= static_cast<int>(fields.size()))
                fail("has " + std::to_string(fields.size()) + " columns, where at least " +
                     std::to_string(1 + *std::ranges::max_element(m_columns)) + " are needed");
            const Field& field = fields[static_cast<std::size_t>(column)];
            const auto number = parseNumber(view(field));
            if (!number || !std::isfinite(*number)) fail(formats::inQuotes(view(field)) + " is not a number");
            m_values.push_back(*number);
            m_table.m_fields.push_back(field);
        }
        m_table.m_furtherColumns =
            std::max(m_table.m_furtherColumns, static_cast<int>(fields.size() - m_columns.size()));
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError("line " + std::to_string(m_line) + ": " + what);
    }

    PointTable& m_table;
    const std::string& m_text;
    int m_line = 1;
    bool m_countsAtoms = false;
    std::vector<int> m_columns;  // of the coordinates
    std::vector<double> m_values;
};

PointTable::PointTable(std::string text, int dimension) : m_text(std::move(text)), m_dimension(dimension) {
    Reader(*this).read();
}

std::string PointTable::withPoints(const Points3& points) const {
    std::string text;
    text.reserve(m_text.size() + 8 * m_fields.size());
    std::size_t at = 0;
    // A row names its coordinates in any order, such as z before x.
    std::vector<std::size_t> order(m_fields.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, {}, [this](std::size_t k) { return m_fields[k].begin; });
    for (const std::size_t k : order) {
        text.append(m_text, at, m_fields[k].begin - at);
        const auto point = static_cast<Eigen::Index>(k) / m_dimension;
        appendNumber(text, points(static_cast<Eigen::Index>(k) % m_dimension, point));
        at = m_fields[k].end;
    }
    return text.append(m_text, at);
}

bool isPointTable(const std::string& path) {
    const std::string extension = lowerExtension(path);
    constexpr std::array kKnown{".csv", ".tsv", ".txt", ".xyz", ".dat"};
    return std::ranges::find(kKnown, extension) != kKnown.end();
}

std::string pointTableText(const Points3& points, int dimension, bool commas) {
    std::string text;
    if (commas) text = dimension == 2 ? "x,y\n" : "x,y,z\n";
    for (Eigen::Index i = 0; i < points.cols(); ++i)
        for (int k = 0; k < dimension; ++k) {
            appendNumber(text, points(k, i));
            text += k + 1 == dimension ? '\n' : commas ? ',' : ' ';
        }
    return text;
}

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

const Points3& PointFile::points() const {
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

void PointFile::write(const std::string& path, const Points3& points, const MeshWriteOptions& options) const {
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
    const Points3 before = this->points();
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

template <int Dim>
MappedPoints<Dim>::MappedPoints(const Shape<Dim>& shape, const RunOptions& options, Notice notice,
                                Depths depths)
    : m_shape(shape), m_options(options), m_notice(std::move(notice)), m_depths(std::move(depths)) {
    for (const PointsOutput& one : m_options.outputs.points) {
        const PointFile& file = m_files.emplace_back(one.in, pointDimension());
        file.requireHeldBy(one.out);
        if (const std::string lost = file.lostIn(one.out, m_options.meshes); !lost.empty())
            m_notice(one.out + ": " + lost);
        if (!m_options.inverse) m_maps.push_back(mapFrom(*carrier(), file, 0));
    }
}

template <int Dim>
void MappedPoints<Dim>::write(double time, const Points<Dim>& pose, OutputSet& files) {
    const auto rest = carrier();
    const Points<Dim> bent = carrierIn(pose);
    for (std::size_t k = 0; k < m_files.size(); ++k) {
        const PointFile& file = m_files[k];
        Points<Dim> own;
        if (m_options.inverse) {
            SimplicialMesh<Dim> from = *rest;
            from.points = bent;
            own = mapFrom(from, file, time).mapped(rest->points);
        } else {
            own = m_maps[k].mapped(bent);
        }
        const Points3 points = inSpace(m_shape, file.points(), own);
        files.add(m_options.outputs.points[k].out, ".csv",
                  [&](const std::string& to) { file.write(to, points, m_options.meshes); });
    }
}

/// Points of a flat mesh in another plane than that of x and y have three coordinates.
template <int Dim>
int MappedPoints<Dim>::pointDimension() const {
    if constexpr (Dim == 2) return m_shape.plane.isXy() ? 2 : 3;
    return Dim;
}

/// Returns the mesh that carries points, with the attached parts of a picture.
template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> MappedPoints<Dim>::carrier() const {
    if constexpr (Dim == 2) return drawnRest(m_shape);
    return m_shape.rest;
}

template <int Dim>
Points<Dim> MappedPoints<Dim>::carrierIn(const Points<Dim>& pose) const {
    if constexpr (Dim == 2)
        if (m_shape.texture) return m_shape.texture->withRiders(pose);
    return pose;
}

template <int Dim>
PointMap<Dim> MappedPoints<Dim>::mapFrom(const SimplicialMesh<Dim>& mesh, const PointFile& file,
                                         double time) const {
    std::vector<float> order;
    if constexpr (Dim == 2) order = m_depths(time);
    PointMap<Dim> map(mesh, order, ownCoordinates(m_shape, file.points()));
    const auto tellOf = [&](int count, const std::string& where) {
        if (count > 0)
            m_notice(file.path() + ": " + std::to_string(count) + " of " +
                     std::to_string(file.points().cols()) + " points " + (count == 1 ? "lies " : "lie ") +
                     where);
    };
    tellOf(map.outside(),
           "outside the shape: such points follow the nearest place of its border, as the shape turns and "
           "stretches there");
    tellOf(map.covered(), std::string("where the shape covers itself: ") +
                              (Dim == 2 ? "the front counts" : "the last cell there counts"));
    return map;
}

template class MappedPoints<2>;
template class MappedPoints<3>;

}  // namespace wend
