#include "app/project/file/named_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "app/project/file/design_reader.h"
#include "app/project/file/json_text.h"
#include "app/project/file/matrix_numbers.h"
#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {

std::string folderOf(const std::string& path) {
    return std::filesystem::path(path).parent_path().string();
}

std::string pathIn(const std::string& folder, const std::string& file) {
    return (std::filesystem::path(folder) / file).string();
}

namespace {

/// Returns the values per cell of that name, with one of these numbers of components; null if there are none.
const MeshField* cellField(const MeshFile& file, const std::string& name,
                           const std::vector<int>& components) {
    for (const MeshField& field : fieldsOf(file))
        if (field.perCell && field.name == name) {
            if (std::ranges::count(components, field.components) > 0) return &field;
            throw InputError("field " + name + ": has " + std::to_string(field.components) +
                             " components instead of " + std::to_string(components.front()));
        }
    return nullptr;
}

/// Does the same, but throws InputError if the project names a field that is missing.
const MeshField* wantedField(const MeshFile& file, const std::string& name, const char* usual,
                             const std::vector<int>& components) {
    const MeshField* field = cellField(file, name.empty() ? usual : name, components);
    if (field || name.empty()) return field;
    std::string known;
    for (const MeshField& one : fieldsOf(file))
        if (one.perCell) known += (known.empty() ? "" : ", ") + one.name;
    throw InputError("has no values " + name + " per cell" + (known.empty() ? "" : "; it has " + known));
}

/// Returns a matrix of the plane within the 6 or 9 numbers that programs write of it in space. Throws
/// InputError for one that leaves the plane.
std::vector<double> upperLeftOf(const std::vector<double>& numbers) {
    const std::vector<std::size_t> across = numbers.size() == 9   ? std::vector<std::size_t>{2, 5, 6, 7}
                                            : numbers.size() == 6 ? std::vector<std::size_t>{4, 5}
                                                                  : std::vector<std::size_t>{};
    if (std::ranges::any_of(across, [&](std::size_t k) { return numbers[k] != 0; }))
        throw InputError("field B: has matrices that leave the plane");
    if (numbers.size() == 9) return {numbers[0], numbers[1], numbers[3], numbers[4]};
    if (numbers.size() == 6) return {numbers[0], numbers[1], numbers[3]};
    return numbers;
}

void readCellFields(const MeshFile& file, MaterialSpec& spec, int dimension) {
    std::vector<int> components{dimension * dimension, static_cast<int>(symmetricNumbers(dimension))};
    if (dimension == 2) components.insert(components.end(), {9, 6});
    const bool named = !spec.cellsPhi.empty() || !spec.cellsB.empty();
    const MeshField* phi =
        named && spec.cellsPhi.empty() ? nullptr : wantedField(file, spec.cellsPhi, "phi", {1});
    const MeshField* B =
        named && spec.cellsB.empty() ? nullptr : wantedField(file, spec.cellsB, "B", components);
    spec.cellPhi = phi ? phi->values : std::vector<double>();
    spec.cellB.clear();
    for (auto at = B ? B->values.begin() : std::vector<double>::const_iterator(); B && at < B->values.end();
         at += B->components) {
        const std::vector<double> numbers(at, at + B->components);
        spec.cellB.push_back(matrixFrom(dimension == 2 ? upperLeftOf(numbers) : numbers, dimension));
    }
    if (spec.cellPhi.empty() && spec.cellB.empty()) throw InputError("has no values phi or B per cell");
}

bool isMeshFile(const std::string& path) {
    const std::vector<std::string> known = meshFileExtensions();
    return std::find(known.begin(), known.end(), lowerExtension(path)) != known.end();
}

}  // namespace

void readCells(const std::string& path, MaterialSpec& spec, int dimension) try {
    if (isMeshFile(path)) return readCellFields(*sharedMeshFile(path), spec, dimension);
    if (!spec.cellsPhi.empty() || !spec.cellsB.empty())
        throw InputError("is no mesh file, of which fields could be taken by name");
    const auto json = parseJson(readTextFile(path), path);
    Extras extras;
    std::vector<std::string> warnings;
    JsonObject object(JsonValue(json, "", extras, warnings).ofDimension(dimension));
    readCellValues(object, spec);
} catch (const InputError& error) {
    throw error.named(path);
}

std::vector<double> readSizes(const std::string& path, int count) try {
    std::istringstream text(readTextFile(path));
    std::vector<double> sizes;
    for (std::string word; text >> word;) {
        double size = 0;
        const auto done = std::from_chars(word.data(), word.data() + word.size(), size);
        const std::string place = "value " + std::to_string(sizes.size()) + ": ";
        if (done.ec != std::errc() || done.ptr != word.data() + word.size())
            throw InputError(place + "\"" + word.substr(0, 20) + "\" is not a number");
        if (const auto problem = rangeProblem(option("domain.sizes[].factor"), size); !problem.empty())
            throw InputError(place + problem);
        sizes.push_back(size);
    }
    if (static_cast<int>(sizes.size()) != count)
        throw InputError("has " + std::to_string(sizes.size()) + " values, but the surface has " +
                         std::to_string(count) + " vertices");
    return sizes;
} catch (const InputError& error) {
    throw error.named(path);
}

Outline readOutlineFile(const std::string& path) try {
    const auto json = parseJson(readTextFile(path), path);
    Extras extras;
    std::vector<std::string> warnings;
    JsonObject object(JsonValue(json, "", extras, warnings));
    return readPolygons(object.require("polygons"));
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
