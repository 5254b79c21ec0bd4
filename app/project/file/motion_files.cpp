#include "app/project/file/motion_files.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/guide_file.h"
#include "app/project/file/named_files.h"
#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/number_text.h"
#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"
#include "core/motion/screw_motion.h"

namespace wend {

namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\"'");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\"'") - first + 1);
}

/// Blanks separate where nothing else does.
std::vector<std::string> cellsOf(std::string_view line) {
    std::vector<std::string> cells;
    char separator = ' ';
    for (const char one : {'\t', ';', ','})
        if (line.find(one) != std::string_view::npos) separator = one;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find(separator, at), line.size());
        const std::string_view cell = trimmed(line.substr(at, end - at));
        if (separator != ' ' || !cell.empty()) cells.emplace_back(cell);
        at = end + 1;
    }
    if (!cells.empty() && cells.back().empty()) cells.pop_back();  // a separator at the end
    return cells;
}

std::string lowered(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

/// A table of numbers in a text file: one row a line, columns between commas, semicolons, tabs or blanks, #
/// before remarks, and maybe a header of names.
struct NumberTable {
    std::string path;
    std::vector<std::string> header;  // lower case, without quotes; empty: none
    std::vector<std::vector<double>> rows;
    std::vector<int> lines;  // of the rows, from 1

    /// Returns the column with one of these names.
    std::optional<std::size_t> column(const std::vector<std::string>& names) const;
    [[noreturn]] void failAt(std::size_t row, const std::string& what) const;
};

std::optional<std::size_t> NumberTable::column(const std::vector<std::string>& names) const {
    const auto found = std::ranges::find_first_of(header, names);
    if (found == header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
}

void NumberTable::failAt(std::size_t row, const std::string& what) const {
    throw InputError(path, "line " + std::to_string(lines[row]) + ": " + what);
}

/// Throws InputError(path, "line 3: …") for a row that is no numbers, and where rows differ in length.
NumberTable readNumberTable(const std::string& path) {
    NumberTable table;
    table.path = path;
    const std::string text = readTextFile(path);
    std::string_view rest = text;
    if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
    for (int line = 1; !rest.empty(); ++line) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view row = rest.substr(0, std::min(rest.find('#'), end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::vector<std::string> cells = cellsOf(row);
        if (cells.empty()) continue;
        if (table.rows.empty() && table.header.empty() && !parseNumber(cells.front())) {
            for (const std::string& cell : cells) table.header.push_back(lowered(cell));
            continue;
        }
        table.lines.push_back(line);
        std::vector<double>& numbers = table.rows.emplace_back();
        for (const std::string& cell : cells) {
            const auto number = parseNumber(cell);
            if (!number || !std::isfinite(*number))
                table.failAt(table.rows.size() - 1, "\"" + cell.substr(0, 30) + "\" is not a number");
            numbers.push_back(*number);
        }
        const std::size_t columns = table.header.empty() ? table.rows.front().size() : table.header.size();
        if (numbers.size() != columns)
            table.failAt(table.rows.size() - 1, "has " + std::to_string(numbers.size()) +
                                                    " columns instead of " + std::to_string(columns));
    }
    if (table.rows.empty()) throw InputError(path, "has no row of numbers");
    return table;
}

bool isTable(const std::string& path) {
    const std::string extension = lowerExtension(path);
    return extension == ".csv" || extension == ".txt" || extension == ".tsv";
}

// --- Fields ---

const MeshField& fieldOf(const MeshFile& file, const std::string& array, int dim) {
    const auto isOfPoints = [&](const MeshField& field) {
        return !field.perCell && (field.components == dim || field.components == 3);
    };
    std::string known;
    const MeshField* found = nullptr;
    int count = 0;
    for (const MeshField& field : fieldsOf(file)) {
        if (!isOfPoints(field)) continue;
        known += (known.empty() ? "" : ", ") + field.name;
        if (!array.empty() && field.name != array) continue;
        found = &field;
        ++count;
    }
    if (known.empty()) throw InputError("has no field of vectors per vertex");
    if (!found) throw InputError("has no field \"" + array + "\" of vectors per vertex; it has " + known);
    if (count > 1) throw InputError("has several fields (" + known + "): `array` has to name one");
    return *found;
}

/// Returns the vector of a field, in the plane of a flat mesh if there is one. `where` begins the message
/// about one that leaves it.
Vec3 vectorIn(const PlaneFrame* plane, const double* value, int components, const std::string& where) {
    if (components == 2) return {value[0], value[1], 0};
    if (!plane) return Eigen::Map<const Vec3>(value);
    constexpr double kAcross = 1e-9;  // of its length: what rounding leaves of it in a plane that is turned
    const Vec3 inSpace = Eigen::Map<const Vec3>(value);
    const Vec3 own = plane->isXy() ? inSpace : Vec3(plane->axes.transpose() * inSpace);
    if (std::abs(own.z()) > (plane->isXy() ? 0 : kAcross * own.norm()))
        throw InputError(where + " out of the plane");
    return {own.x(), own.y(), 0};
}

Displacements<3> fromMesh(const std::string& path, const std::string& array, int vertices,
                          const PlaneFrame* plane) {
    const auto file = sharedMeshFile(path);
    const auto count = static_cast<int>(pointsOf(*file).cols());
    if (vertices > 0 && count != vertices)
        throw InputError("has " + std::to_string(count) + " vertices, but the mesh has " +
                         std::to_string(vertices));
    const MeshField& field = fieldOf(*file, array, plane ? 2 : 3);
    Displacements<3> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int v = 0; v < count; ++v) {
        const double* value = &field.values[static_cast<std::size_t>(v) * field.components];
        // NaN is how files say that there is no value.
        if (!std::all_of(value, value + field.components, [](double x) { return std::isfinite(x); }))
            continue;
        const std::string where = "field " + field.name + ": displaces vertex " + std::to_string(v);
        values.emplace_back(v, vectorIn(plane, value, field.components, where));
    }
    return values;
}

Displacements<3> fromTable(const std::string& path, const std::string& array, int vertices,
                           const PlaneFrame* plane) {
    const NumberTable table = readNumberTable(path);
    const auto id = table.column({"id", "vertex", "vertex id", "vertexid", "point id", "pointid", "node"});
    std::string name = array;
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    std::vector<std::size_t> columns;
    const int components = plane && plane->isXy() ? 2 : 3;
    for (int k = 0; k < components; ++k) {
        const auto column = table.column(
            {std::string("d") + "xyz"[k], name + ":" + std::to_string(k), name + "_" + "xyz"[k]});
        if (column) columns.push_back(*column);
    }
    if (!id || static_cast<int>(columns.size()) != components)
        throw InputError(std::string("needs a header with the columns id, dx, dy") +
                         (components == 3 ? ", dz" : ""));
    Displacements<3> values;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const double number = table.rows[r][*id];
        const bool isId =
            number >= 0 && number == std::floor(number) && number <= std::numeric_limits<int>::max();
        if (!isId) table.failAt(r, "the id is not a vertex number");
        if (vertices > 0 && number >= vertices)
            table.failAt(r, "there is no vertex " + std::to_string(static_cast<long>(number)) +
                                ", the mesh has vertices 0 to " + std::to_string(vertices - 1));
        std::array<double, 3> displacement{};
        for (std::size_t k = 0; k < columns.size(); ++k) displacement[k] = table.rows[r][columns[k]];
        const std::string where =
            "row " + std::to_string(r + 1) + ": displaces vertex " + std::to_string(static_cast<int>(number));
        values.emplace_back(static_cast<int>(number),
                            vectorIn(plane, displacement.data(), components, where));
    }
    std::ranges::stable_sort(values, {}, &Displacements<3>::value_type::first);
    const auto twice = std::ranges::adjacent_find(values, {}, &Displacements<3>::value_type::first);
    if (twice != values.end()) throw InputError("has two rows for vertex " + std::to_string(twice->first));
    return values;
}

// --- Poses ---

struct PoseColumns {
    std::size_t time = 0;
    std::vector<std::size_t> position, rotation;
    bool isQuaternion = false;  // rotation: x, y, z, w
};

std::vector<std::size_t> columnsOf(const NumberTable& table,
                                   const std::vector<std::vector<std::string>>& names) {
    std::vector<std::size_t> columns;
    for (const auto& one : names)
        if (const auto column = table.column(one)) columns.push_back(*column);
    return columns;
}

std::string poseColumnNames(int dimension) {
    return dimension == 2
               ? "time, x, y, angle"
               : "time, x, y, z, and rx, ry, rz (a rotation vector) or qx, qy, qz, qw (a quaternion)";
}

PoseColumns namedColumns(const NumberTable& table, int dimension) {
    PoseColumns columns;
    const auto time = table.column({"time", "t", "timestamp"});
    columns.position = columnsOf(table, {{"x", "tx", "px"}, {"y", "ty", "py"}, {"z", "tz", "pz"}});
    columns.position.resize(std::min(columns.position.size(), static_cast<std::size_t>(dimension)));
    const auto quaternion = columnsOf(table, {{"qx"}, {"qy"}, {"qz"}, {"qw"}});
    columns.isQuaternion = dimension == 3 && quaternion.size() == 4;
    columns.rotation = columns.isQuaternion ? quaternion
                       : dimension == 2     ? columnsOf(table, {{"angle", "rotation", "rz", "a"}})
                                            : columnsOf(table, {{"rx"}, {"ry"}, {"rz"}});
    const std::size_t turns = dimension == 2 ? 1 : columns.isQuaternion ? 4 : 3;
    if (!time || columns.position.size() != static_cast<std::size_t>(dimension) ||
        columns.rotation.size() != turns)
        throw InputError("needs the columns " + poseColumnNames(dimension));
    columns.time = *time;
    return columns;
}

PoseColumns columnsByPlace(std::size_t count, int dimension) {
    PoseColumns columns;
    columns.isQuaternion = dimension == 3 && count == 8;
    if (!columns.isQuaternion && count != (dimension == 2 ? 4 : 7))
        throw InputError("has " + std::to_string(count) + " columns where poses need " +
                         poseColumnNames(dimension));
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t k = 0; k < d; ++k) columns.position.push_back(1 + k);
    for (std::size_t k = 1 + d; k < count; ++k) columns.rotation.push_back(k);
    return columns;
}

RotationVector<3> rotationIn(const NumberTable& table, std::size_t r, const PoseColumns& columns,
                             const RotationVector<3>& before) {
    Eigen::Vector4d values = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < columns.rotation.size(); ++k)
        values[static_cast<Eigen::Index>(k)] = table.rows[r][columns.rotation[k]];
    if (columns.rotation.size() == 1) return {0, 0, values[0]};
    if (!columns.isQuaternion) return values.head<3>();
    if (std::abs(values.norm() - 1) > 1e-3) table.failAt(r, "the quaternion is not of length 1");
    return rotationVectorOf(Eigen::Quaterniond(values[3], values[0], values[1], values[2]), before);
}

// --- Of a project ---

void readSurface(Pin& handle, std::size_t number, const std::string& folder, const PlaneFrame* plane) try {
    if (handle.slide && !handle.slide->file.empty())
        handle.slide->mesh =
            std::make_shared<const GuideMesh<3>>(readGuide(pathIn(folder, handle.slide->file), plane));
} catch (const InputError& error) {
    throw InputError("handles[" + std::to_string(number) + "].hold.slide: " + error.what());
}

/// Returns the plane of a flat mesh, whose coordinates handles have; that of x and y for pictures.
PlaneFrame planeOfMesh(const Domain& domain, const std::string& folder) {
    if (domain.kind != DomainKind::Mesh) return {};
    try {
        const auto file = sharedMeshFile(pathIn(folder, domain.path));
        return planeOf(pointsOf(*file), trianglesOf(*file)).value_or(PlaneFrame());
    } catch (const InputError&) {
        return {};  // whoever needs the mesh reports it
    }
}

bool namesFiles(const std::vector<Pin>& handles) {
    return std::ranges::any_of(handles, [](const Pin& handle) {
        return (handle.slide && !handle.slide->file.empty()) ||
               std::ranges::any_of(handle.motions, [](const auto& motion) {
                   return std::holds_alternative<FieldMotion<3>>(motion.kind);
               });
    });
}

}  // namespace

void readHandleFiles(Project& project, const std::string& folder) {
    const Domain& domain = domainOf(project);
    const int dimension = dimensionOf(project);
    PlaneFrame flat;
    if (dimension == 2 && namesFiles(designOf(project).handles)) flat = planeOfMesh(domain, folder);
    const PlaneFrame* plane = dimension == 2 ? &flat : nullptr;
    int vertices = 0;
    const auto vertexCount = [&] {
        if (vertices == 0 && domain.kind == DomainKind::Mesh)
            vertices = static_cast<int>(pointsOf(*sharedMeshFile(pathIn(folder, domain.path))).cols());
        return vertices;
    };
    auto& handles = designOf(project).handles;
    for (std::size_t h = 0; h < handles.size(); ++h) readSurface(handles[h], h, folder, plane);
    for (std::size_t h = 0; h < handles.size(); ++h)
        for (std::size_t m = 0; m < handles[h].motions.size(); ++m) try {
                PinMotion& motion = handles[h].motions[m];
                if (auto* field = std::get_if<FieldMotion<3>>(&motion.kind); field && !field->file.empty())
                    field->values = std::make_shared<const Displacements<3>>(
                        readDisplacements(pathIn(folder, field->file), field->array, vertexCount(), plane));
                auto* poses = std::get_if<PoseMotion<3>>(&motion.kind);
                if (!poses || poses->file.empty()) continue;
                PoseMotion<3> read = readPoseTable(pathIn(folder, poses->file), dimension);
                read.file = poses->file;
                read.hasOwnTimes = poses->hasOwnTimes;
                *poses = std::move(read);
                if (poses->hasOwnTimes) motion.start = poses->times.front(), motion.end = poses->times.back();
            } catch (const InputError& error) {
                throw InputError("handles[" + std::to_string(h) + "].motion[" + std::to_string(m) +
                                 "].file: " + error.what());
            }
}

Displacements<3> readDisplacements(const std::string& path, const std::string& array, int vertices,
                                   const PlaneFrame* plane) try {
    return isTable(path) ? fromTable(path, array, vertices, plane) : fromMesh(path, array, vertices, plane);
} catch (const InputError& error) {
    throw error.named(path);
}

PoseMotion<3> readPoseTable(const std::string& path, int dimension) try {
    const NumberTable table = readNumberTable(path);
    const PoseColumns columns = table.header.empty() ? columnsByPlace(table.rows.front().size(), dimension)
                                                     : namedColumns(table, dimension);
    PoseMotion<3> motion;
    RotationVector<3> rotation = RotationVector<3>::Zero();
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const double time = table.rows[r][columns.time];
        if (r > 0 && time <= motion.times.back())
            table.failAt(r, "the time does not come after that of the row before");
        motion.times.push_back(time);
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < dimension; ++k)
            position[k] = table.rows[r][columns.position[static_cast<std::size_t>(k)]];
        rotation = rotationIn(table, r, columns, rotation);
        motion.poses.push_back({position, rotation});
    }
    if (motion.poses.size() < 2) throw InputError("has 1 pose, at least 2 are needed");
    return motion;
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
