#include "core/mesh/formats/mesh_bag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/mesh/formats/boundary_values.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend::formats {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <std::size_t N>
void list(const std::vector<std::array<int, N>>& simplices, CellKind kind, CellList& cells,
          std::vector<int>& cellOf) {
    cellOf.clear();
    for (const auto& one : simplices) {
        cellOf.push_back(cells.size());
        cells.add(kind, one);
    }
}

/// Returns for each cell the tetrahedra or triangles that it was split into.
std::vector<std::vector<int>> piecesOfCells(const MeshFile& mesh) {
    std::vector<std::vector<int>> parts(static_cast<std::size_t>(mesh.cells.size()));
    const auto& cellOf = isVolume(mesh) ? mesh.cellOfTetrahedron : mesh.cellOfTriangle;
    for (std::size_t i = 0; i < cellOf.size(); ++i)
        parts[static_cast<std::size_t>(cellOf[i])].push_back(static_cast<int>(i));
    return parts;
}

/// Adds the tetrahedra behind the triangles of a volume's boundary as parts of their cells.
void addBehind(const MeshFile& mesh, std::vector<std::vector<int>>& parts) {
    if (!isVolume(mesh) || mesh.triangles.empty()) return;
    const std::vector<int> behind = cellsBehind(mesh);
    for (std::size_t t = 0; t < behind.size(); ++t)
        if (behind[t] >= 0) parts[static_cast<std::size_t>(mesh.cellOfTriangle[t])].push_back(behind[t]);
}

/// Returns the mean of every cell's parts: the value itself where there is one, NaN where there is none.
std::vector<double> gathered(const MeshField& field, const std::vector<std::vector<int>>& parts) {
    std::vector<double> values;
    values.reserve(parts.size() * static_cast<std::size_t>(field.components));
    for (const auto& ofCell : parts)
        for (int k = 0; k < field.components; ++k) {
            double sum = 0;
            for (const int part : ofCell)
                sum += field.values[static_cast<std::size_t>(part) * field.components + k];
            values.push_back(ofCell.empty()       ? kNone
                             : ofCell.size() == 1 ? sum
                                                  : sum / static_cast<double>(ofCell.size()));
        }
    return values;
}

/// Adds the labels of generated triangles as groups, with their names.
void addLabelGroups(MeshFile& bag) {
    std::map<int, MeshGroup> groups;
    for (std::size_t t = 0; t < bag.labels.size(); ++t)
        if (const int label = bag.labels[t]; label != 0) groups[label].cells.push_back(bag.cellOfTriangle[t]);
    for (std::size_t i = 0; i < bag.labelNames.size(); ++i)
        if (!bag.labelNames[i].empty()) groups[static_cast<int>(i) + 1].name = bag.labelNames[i];
    for (auto& [label, group] : groups) {
        group.tag = label;
        bag.groups.push_back(std::move(group));
    }
}

/// Adds groups for the numbers of cells of that dimension, or of all with −1.
void addTagGroups(MeshFile& bag, std::vector<double> numbers, int dimension) {
    if (numbers.size() != static_cast<std::size_t>(bag.cells.size())) return;
    for (int c = 0; c < bag.cells.size(); ++c)
        if (dimension >= 0 && bag.cells.dimension(c) != dimension) numbers[static_cast<std::size_t>(c)] = 0;
    addGroups(bag, numbers);
}

void listMade(MeshFile& mesh, bool trianglesFirst) {
    if (trianglesFirst) list(mesh.triangles, CellKind::Triangle, mesh.cells, mesh.cellOfTriangle);
    list(mesh.tetrahedra, CellKind::Tetrahedron, mesh.cells, mesh.cellOfTetrahedron);
    if (!trianglesFirst) list(mesh.triangles, CellKind::Triangle, mesh.cells, mesh.cellOfTriangle);
}

}  // namespace

int cellCount(const MeshFile& file) {
    return static_cast<int>(file.tetrahedra.empty() ? file.triangles.size() : file.tetrahedra.size());
}

const MeshField* cellField(const MeshFile& file, std::initializer_list<const char*> names) {
    for (const char* name : names)
        for (const auto& field : file.fields)
            if (field.perCell && field.components == 1 && field.name == name) return &field;
    return nullptr;
}

long tagOf(const MeshField* field, int cell, long otherwise) {
    if (!field || !(std::abs(field->values[static_cast<std::size_t>(cell)]) < 2147483647)) return otherwise;
    return std::lround(field->values[static_cast<std::size_t>(cell)]);
}

int nodeOf(const MeshFile& file, std::int64_t number) {
    if (number < 1 || number > file.points.cols())
        throw InputError("cell " + std::to_string(file.cells.size()) + " names node " +
                         std::to_string(number) + ", but there are only " +
                         std::to_string(file.points.cols()));
    return static_cast<int>(number - 1);
}

void joinVectors(MeshFile& file, std::string_view before, std::string_view letters) {
    std::vector<MeshField> fields = std::move(file.fields);
    file.fields.clear();
    for (std::size_t f = 0; f < fields.size(); ++f) {
        const std::string& name = fields[f].name;
        const std::size_t end = before.size() + 1;
        const std::string stem = name.size() > end ? name.substr(0, name.size() - end) : std::string();
        const auto isPart = [&](std::size_t k) {
            return f + k < fields.size() && fields[f + k].perCell == fields[f].perCell &&
                   fields[f + k].name == stem + std::string(before) + letters[k];
        };
        if (stem.empty() || !isPart(0) || !isPart(1) || !isPart(2)) {
            file.fields.push_back(std::move(fields[f]));
            continue;
        }
        MeshField vector{stem, fields[f].perCell, 3, {}, {}, fields[f].type};
        for (std::size_t i = 0; i < fields[f].values.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) vector.values.push_back(fields[f + k].values[i]);
        file.fields.push_back(std::move(vector));
        f += 2;
    }
}

/// Values that were read for all cells are kept, and only computed ones gathered. Groups are made for
/// generated cells alone, because a file that was read has its own.
MeshFile bagOf(MeshFile mesh, bool trianglesFirst) {
    const bool made = mesh.cells.empty();
    if (made) listMade(mesh, trianglesFirst);
    auto parts = piecesOfCells(mesh);
    if (std::ranges::any_of(mesh.fields,
                            [](const auto& field) { return field.perCell && field.ofCells.empty(); }))
        addBehind(mesh, parts);
    for (MeshField& field : mesh.fields)
        if (field.perCell && field.ofCells.empty()) field.ofCells = gathered(field, parts);
    if (!made || !mesh.groups.empty()) return mesh;
    if (const MeshField* tags = cellField(mesh, {"physical", "ref", "attribute"}))
        addTagGroups(mesh, tags->ofCells, isVolume(mesh) ? 3 : 2);
    for (MeshGroup& group : mesh.groups)
        if (group.dimension == 3 && group.tag > 0 && group.tag <= std::ssize(mesh.spaceNames))
            group.name = mesh.spaceNames[static_cast<std::size_t>(group.tag) - 1];
    if (isVolume(mesh)) addLabelGroups(mesh);
    return mesh;
}

/// Appends the boundary facets as triangles, with the values of the cells behind them.
MeshFile withBoundary(MeshFile mesh) {
    const bool listed = !mesh.cells.empty();
    mesh.deck.reset();  // it has no such cells
    std::vector<int> behind;
    for (const auto& facet : facetsOf<3>({mesh.points, mesh.tetrahedra})) {
        if (facet.interior()) continue;
        mesh.triangles.push_back(facet.vertices);
        behind.push_back(facet.cells[0]);
        if (!listed) continue;
        mesh.cellOfTriangle.push_back(mesh.cells.size());
        mesh.cells.add(CellKind::Triangle, facet.vertices);
    }
    for (MeshField& field : mesh.fields)
        if (field.perCell && !field.beyond.empty())
            field.beyond.resize(
                field.beyond.size() + behind.size() * static_cast<std::size_t>(field.components), 0);
    for (MeshField& field : mesh.fields)
        for (std::size_t i = 0; !field.ofCells.empty() && i < behind.size(); ++i)
            for (int k = 0; k < field.components; ++k)
                field.ofCells.push_back(
                    field.values[static_cast<std::size_t>(behind[i]) * field.components + k]);
    return mesh;
}

void setCornerUv(MeshFile& file, std::vector<double> cornerUv) {
    Eigen::Matrix2Xd uv = Eigen::Matrix2Xd::Constant(2, file.points.cols(), kNone);
    bool isWhole = true, isSingle = true, isAny = false;
    for (int c = 0; c < file.cells.size(); ++c) {
        if (file.cells.dimension(c) != 2) continue;
        auto at = 2 * static_cast<std::size_t>(file.cells.begins[static_cast<std::size_t>(c)]);
        for (const int v : file.cells[c]) {
            const Eigen::Vector2d own(cornerUv[at], cornerUv[at + 1]);
            at += 2;
            if (std::isnan(own.x())) {
                isWhole = false;
                continue;
            }
            isAny = true;
            if (std::isnan(uv(0, v)))
                uv.col(v) = own;
            else
                isSingle = isSingle && uv.col(v) == own;
        }
    }
    if (!isAny) return;
    if (isWhole) file.uv = uv.unaryExpr([](double x) { return std::isnan(x) ? 0 : x; });
    if (!isWhole || !isSingle) file.cornerUv = std::move(cornerUv);
}

void addGroupsOfFields(MeshFile& file) {
    if (!file.groups.empty()) return;
    if (const auto* usual =
            cellField(file, {"physical", "ref", "attribute", "material", "pid", "gmsh:physical"}))
        addTagGroups(file, usual->values, -1);
    const MeshField* label = cellField(file, {"label"});
    if (!label) return;
    std::erase_if(file.groups, [](const MeshGroup& group) { return group.dimension == 2; });
    addTagGroups(file, label->values, 2);
}

MeshFile inOrder(const MeshFile& mesh, const std::vector<int>& order) {
    MeshFile bag = mesh;
    bag.cells = {};
    bag.cornerUv.clear();
    std::vector<int> newNumber(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        newNumber[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        bag.cells.add(mesh.cells.kinds[static_cast<std::size_t>(order[i])], mesh.cells[order[i]]);
    }
    for (std::size_t f = 0; f < bag.fields.size(); ++f) {
        const MeshField& field = mesh.fields[f];
        if (!field.perCell) continue;
        const auto width = static_cast<std::ptrdiff_t>(field.components);
        bag.fields[f].ofCells.clear();
        bag.fields[f].beyond.clear();
        for (const int c : order) {
            const auto first = field.ofCells.begin() + c * width;
            bag.fields[f].ofCells.insert(bag.fields[f].ofCells.end(), first, first + width);
            if (field.beyond.empty()) continue;
            const auto more = field.beyond.begin() + c * width;
            bag.fields[f].beyond.insert(bag.fields[f].beyond.end(), more, more + width);
        }
    }
    for (MeshGroup& group : bag.groups) {
        for (int& c : group.cells) c = newNumber[static_cast<std::size_t>(c)];
        std::ranges::sort(group.cells);
    }
    for (std::vector<int>* cellOf : {&bag.cellOfTriangle, &bag.cellOfTetrahedron})
        for (int& c : *cellOf)
            if (c >= 0) c = newNumber[static_cast<std::size_t>(c)];
    return bag;
}

void nameGroup(const std::string& name, MeshGroup& group) {
    constexpr std::size_t kLongest = 9;  // digits
    const bool isNumber = !name.empty() && name.size() <= kLongest && name.front() != '0' &&
                          name.find_first_not_of("0123456789") == std::string::npos;
    group.name = isNumber ? std::string() : name;
    group.tag = isNumber ? std::stol(name) : 0;
}

std::string groupName(const MeshGroup& group) {
    return group.name.empty() ? std::to_string(group.tag) : group.name;
}

std::vector<int> mainGroups(const MeshFile& bag) {
    std::vector<int> main(static_cast<std::size_t>(bag.cells.size()), -1);
    for (const bool numbered : {true, false})
        for (std::size_t g = 0; g < bag.groups.size(); ++g) {
            if ((bag.groups[g].tag != 0) != numbered) continue;
            for (const int c : bag.groups[g].cells)
                if (int& group = main[static_cast<std::size_t>(c)]; group < 0) group = static_cast<int>(g);
        }
    return main;
}

std::vector<long> groupNumbers(const MeshFile& bag) {
    long highest = 0;
    for (const MeshGroup& group : bag.groups) highest = std::max(highest, group.tag);
    std::vector<long> tags;
    for (const MeshGroup& group : bag.groups)
        tags.push_back(group.tag != 0 || isMeditList(group.name) ? group.tag : ++highest);
    std::vector<long> numbers(static_cast<std::size_t>(bag.cells.size()), 0);
    for (std::size_t g = 0; g < tags.size(); ++g)
        for (const int c : bag.groups[g].cells)
            if (long& one = numbers[static_cast<std::size_t>(c)]; one == 0) one = tags[g];
    return numbers;
}

/// Numbers the groups that represent some triangle. A group keeps its own number if that is free.
SurfaceLabels surfaceLabels(const MeshFile& file) {
    SurfaceLabels result;
    if (file.groups.empty() || file.cellOfTriangle.empty()) return result;
    const std::vector<int> main = mainGroups(file);
    const std::set<int> used(main.begin(), main.end());
    std::map<int, int> numberOf;  // of groups
    std::set<long> taken;
    for (std::size_t g = 0; g < file.groups.size(); ++g) {
        const MeshGroup& group = file.groups[g];
        if (group.dimension != 2 || !used.contains(static_cast<int>(g))) continue;
        const bool own = group.tag > 0 && group.tag <= kHighestLabel && taken.insert(group.tag).second;
        numberOf[static_cast<int>(g)] = own ? static_cast<int>(group.tag) : 0;
    }
    int next = 1;
    for (auto& [g, number] : numberOf) {
        while (number == 0 && taken.contains(next)) ++next;
        if (number == 0) taken.insert(number = next);
        const std::string& name = file.groups[static_cast<std::size_t>(g)].name;
        if (name.empty()) continue;
        if (result.names.size() < static_cast<std::size_t>(number))
            result.names.resize(static_cast<std::size_t>(number));
        result.names[static_cast<std::size_t>(number) - 1] = name;
    }
    for (const int c : file.cellOfTriangle) {
        const auto found = numberOf.find(main[static_cast<std::size_t>(c)]);
        result.labels.push_back(found == numberOf.end() ? 0 : found->second);
    }
    if (std::ranges::all_of(result.labels, [](int label) { return label == 0; })) return {};
    return result;
}

}  // namespace wend::formats
