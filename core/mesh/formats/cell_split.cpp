#include "core/mesh/formats/cell_split.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/mesh/formats/polygon_split.h"

namespace wend::formats {
namespace {

/// Faces by their corners within the cell, counter-clockwise from outside where the cell is positive; −1 ends
/// a triangle.
using CellFace = std::array<int, 4>;
constexpr CellFace kPyramid[] = {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}};
constexpr CellFace kWedge[] = {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
constexpr CellFace kHexahedron[] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::span<const CellFace> facesOf(CellKind linear) {
    if (linear == CellKind::Pyramid) return kPyramid;
    if (linear == CellKind::Wedge) return kWedge;
    return kHexahedron;
}

bool repeats(const std::array<int, 4>& cell) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j)
            if (cell[i] == cell[j]) return true;
    return false;
}

/// Returns the triangles of a face, split from its vertex of the smallest number.
std::vector<std::array<int, 3>> splitFace(const CellFace& face, std::span<const int> nodes) {
    std::vector<int> corners;
    for (const int k : face)
        if (k >= 0) corners.push_back(nodes[static_cast<std::size_t>(k)]);
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    std::vector<std::array<int, 3>> triangles{{corners[0], corners[1], corners[2]}};
    if (corners.size() == 4) triangles.push_back({corners[0], corners[2], corners[3]});
    return triangles;
}

/// Returns the triangles of a strip: every corner forms one with the two before it, and every second one is
/// reversed to keep the orientation. A triangle that has a corner twice only leads the strip on.
std::vector<std::array<int, 3>> splitStrip(std::span<const int> corners) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const bool odd = k % 2 != 0;
        const int a = corners[k - (odd ? 1 : 2)], b = corners[k - (odd ? 2 : 1)], c = corners[k];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}

/// Quadrilaterals of a volume are split as the faces of its cells are.
std::vector<std::array<int, 3>> splitFlatCell(const MeshFile& file, int c, bool volume) {
    const CellKind kind = file.cells.kinds[static_cast<std::size_t>(c)];
    auto nodes = file.cells[c];
    if (kind == CellKind::TriangleStrip) return splitStrip(nodes);
    if (const int corners = factsOf(kind).corners; corners > 0)
        nodes = nodes.first(static_cast<std::size_t>(corners));
    std::vector<int> ring(nodes.begin(), nodes.end());
    if (volume && ring.size() == 4) std::ranges::rotate(ring, std::ranges::min_element(ring));
    return splitPolygon(file.points, ring);
}

/// Returns the values of a field for the simplices that cells were split into.
std::vector<double> spread(const MeshField& field, const std::vector<int>& cellOf) {
    std::vector<double> values;
    values.reserve(cellOf.size() * static_cast<std::size_t>(field.components));
    for (const int cell : cellOf) {
        const auto first = field.ofCells.begin() + static_cast<std::ptrdiff_t>(cell) * field.components;
        values.insert(values.end(), first, first + field.components);
    }
    return values;
}

/// Turns the fields per cell, which have values of all cells, into those of the triangles or tetrahedra.
void finishFields(MeshFile& file) {
    const auto& cellOf = isVolume(file) ? file.cellOfTetrahedron : file.cellOfTriangle;
    for (MeshField& field : file.fields) {
        if (field.type < Scalar::Float32 &&
            std::ranges::any_of(field.values, [](double value) { return std::isnan(value); }))
            field.type = Scalar::Float64;  // no whole number tells that there is no value
        if (!field.perCell) continue;
        field.ofCells = std::move(field.values);
        if (field.ofCells.size() ==
            static_cast<std::size_t>(file.cells.size()) * static_cast<std::size_t>(field.components))
            field.values = spread(field, cellOf);
    }
}

/// Labels the triangles of a volume with the number of their first group that has one, and names the labels
/// after the groups.
void findLabels(MeshFile& file) {
    if (!isVolume(file) || file.triangles.empty()) return;
    std::vector<long> tags(static_cast<std::size_t>(file.cells.size()), 0);
    std::map<long, std::string> names;
    for (const MeshGroup& group : file.groups) {
        if (group.dimension != 2 || group.tag <= 0 || group.tag > kHighestLabel) continue;
        for (const int c : group.cells)
            if (tags[static_cast<std::size_t>(c)] == 0) tags[static_cast<std::size_t>(c)] = group.tag;
        if (!group.name.empty()) names.emplace(group.tag, group.name);
    }
    for (const int c : file.cellOfTriangle)
        file.labels.push_back(static_cast<int>(tags[static_cast<std::size_t>(c)]));
    if (std::ranges::all_of(file.labels, [](int label) { return label == 0; })) file.labels.clear();
    if (file.labels.empty()) return;
    for (const auto& [tag, name] : names) {
        file.labelNames.resize(static_cast<std::size_t>(tag));
        file.labelNames.back() = name;
    }
}

}  // namespace

/// Fans tetrahedra from the cell's vertex of the smallest number to the triangles of all faces that do not
/// contain it.
std::vector<std::array<int, 4>> splitCell(CellKind kind, std::span<const int> nodes) {
    const CellKind linear = linearKind(kind);
    if (linear == CellKind::Tetrahedron) return {{nodes[0], nodes[1], nodes[2], nodes[3]}};
    const auto corners = nodes.first(static_cast<std::size_t>(factsOf(linear).corners));
    const int apex = *std::ranges::min_element(corners);
    std::vector<std::array<int, 4>> tetrahedra;
    for (const CellFace& face : facesOf(linear)) {
        if (std::ranges::any_of(
                face, [&](int k) { return k >= 0 && corners[static_cast<std::size_t>(k)] == apex; }))
            continue;
        for (const auto& [a, b, c] : splitFace(face, corners))
            if (const std::array<int, 4> one{a, c, b, apex}; !repeats(one)) tetrahedra.push_back(one);
    }
    return tetrahedra;
}

/// Splits the cells into triangles and tetrahedra, and remembers which cell each is from.
void finishCells(MeshFile& file, const std::function<std::string(int cell)>& place) {
    const CellList& cells = file.cells;
    const bool volume =
        std::ranges::any_of(cells.kinds, [](auto kind) { return factsOf(kind).dimension == 3; });
    for (int c = 0; c < cells.size(); ++c) {
        if (cells.dimension(c) == 3)
            for (const auto& one : splitCell(cells.kinds[static_cast<std::size_t>(c)], cells[c])) {
                file.tetrahedra.push_back(one);
                file.cellOfTetrahedron.push_back(c);
            }
        if (cells.dimension(c) != 2) continue;
        try {
            for (const auto& one : splitFlatCell(file, c, volume)) {
                file.triangles.push_back(one);
                file.cellOfTriangle.push_back(c);
            }
        } catch (const InputError& error) {
            throw InputError((place ? place(c) : "cell " + std::to_string(c)) + ": " + error.reason());
        }
    }
    finishFields(file);
    findLabels(file);
}

/// Collects the cells of every dimension and number. Numbers are rounded; 0 and those of more than 31 bits
/// are left out.
void addGroups(MeshFile& file, const std::vector<double>& numbers,
               const std::function<std::string(int dimension, long tag)>& name) {
    std::map<std::pair<int, long>, MeshGroup> groups;
    for (int c = 0; c < file.cells.size(); ++c) {
        const double number = numbers[static_cast<std::size_t>(c)];
        if (!(std::abs(number) < 2147483647) || std::lround(number) == 0) continue;
        const int dimension = file.cells.dimension(c);
        groups[{dimension, std::lround(number)}].cells.push_back(c);
    }
    for (auto& [key, group] : groups) {
        group.dimension = key.first;
        group.tag = key.second;
        if (name) group.name = name(key.first, key.second);
        file.groups.push_back(std::move(group));
    }
}

}  // namespace wend::formats
