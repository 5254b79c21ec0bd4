// TetGen and Triangle: .node (points, attributes, a marker) and .ele (cells, attributes), counted from 0 or
// from 1; beside them maybe .face and .edge (corners, a marker).

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

/// Adds this file's name to whatever `read` throws, because the pair has two.
template <class Read>
auto inFile(const MeshSource& source, const Read& read) {
    try {
        return read();
    } catch (const InputError& error) {
        throw error.named(source.path);
    }
}

/// The items are numbered one by one from 0 or 1.
void readNumber(Scanner& scanner, int item, std::int64_t& first) {
    const auto number = scanner.integer("the item's number");
    if (item == 0) first = number;
    if (number != first + item || first < 0 || first > 1)
        scanner.fail("the items should be numbered one by one from 0 or 1, but here is " +
                     std::to_string(number));
}

struct Nodes {
    MeshFile file;
    std::int64_t first = 0, dimension = 3;
};

int attributeCount(Scanner& scanner) {
    return scanner.atLineEnd() ? 0 : scanner.count("attributes", 0);
}

/// Reads a .node file: points with attributes and markers, numbered from 0 or 1.
Nodes readNodes(std::string_view bytes) {
    Scanner scanner(bytes, '#');
    Nodes nodes;
    const auto declared = scanner.integer("the number of points");
    nodes.dimension = scanner.integer("the dimension");
    if (nodes.dimension != 2 && nodes.dimension != 3) scanner.fail("the dimension is neither 2 nor 3");
    const int attributes = attributeCount(scanner), markers = attributeCount(scanner);
    if (markers > 1) scanner.fail("there is 0 or 1 marker per point");
    const std::size_t numbers = 1 + nodes.dimension + attributes + markers;
    const int count = scanner.checkedCount(declared, "points", 2 * numbers);

    nodes.file.points = Eigen::Matrix3Xd::Zero(3, count);
    MeshField attribute{"attribute", false, attributes, {}}, marker{"marker", false, 1, {}};
    for (int v = 0; v < count; ++v) {
        readNumber(scanner, v, nodes.first);
        for (int k = 0; k < nodes.dimension; ++k) nodes.file.points(k, v) = scanner.finite("a coordinate");
        for (int k = 0; k < attributes; ++k) attribute.values.push_back(scanner.real("an attribute"));
        if (markers) marker.values.push_back(scanner.real("a marker"));
    }
    scanner.requireEnd("the first line");
    if (attributes) nodes.file.fields.push_back(std::move(attribute));
    if (markers) nodes.file.fields.push_back(std::move(marker));
    return nodes;
}

int readPointNumber(Scanner& scanner, const Nodes& nodes) {
    const auto number = scanner.integer("a point's number"), index = number - nodes.first;
    if (index < 0 || index >= nodes.file.points.cols())
        scanner.fail("point " + std::to_string(number) + " is named, but there are only " +
                     std::to_string(nodes.file.points.cols()) + ", counted from " +
                     std::to_string(nodes.first));
    return static_cast<int>(index);
}

std::optional<CellKind> elementKind(std::int64_t corners) {
    if (corners == 3) return CellKind::Triangle;
    if (corners == 4) return CellKind::Tetrahedron;
    if (corners == 6) return CellKind::Triangle6;
    if (corners == 10) return CellKind::Tetrahedron10;
    return std::nullopt;
}

/// Returns the nodes in VTK's order. Triangle and TetGen number the nodes on edges differently, so each is
/// assigned to the edge whose midpoint is nearest.
std::vector<int> inOrderOfVtk(const std::vector<int>& cell, const Eigen::Matrix3Xd& points) {
    constexpr std::array<int, 2> edges[] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    const std::size_t corners = cell.size() == 6 ? 3 : 4;
    if (cell.size() == corners || cell.size() < 6) return cell;
    std::vector<int> turned(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(corners));
    std::vector<int> left(cell.begin() + static_cast<std::ptrdiff_t>(corners), cell.end());
    for (std::size_t e = 0; e + corners < cell.size(); ++e) {
        const Eigen::Vector3d middle = (points.col(cell[static_cast<std::size_t>(edges[e][0])]) +
                                        points.col(cell[static_cast<std::size_t>(edges[e][1])])) /
                                       2;
        const auto nearest =
            std::ranges::min_element(left, {}, [&](int v) { return (points.col(v) - middle).squaredNorm(); });
        turned.push_back(*nearest);
        left.erase(nearest);
    }
    return turned;
}

/// Reads an .ele file: triangles or tetrahedra of first or second order, with attributes.
void readElements(std::string_view bytes, Nodes& nodes) {
    Scanner scanner(bytes, '#');
    const auto declared = scanner.integer("the number of cells");
    const auto corners = scanner.integer("the number of corners");
    const auto kind = elementKind(corners);
    if (!kind) scanner.fail("cells with 3, 4, 6 or 10 corners are read, not with " + std::to_string(corners));
    const int attributes = attributeCount(scanner);
    const int count = scanner.checkedCount(declared, "cells", 2 * (1 + corners + attributes));

    std::vector<int> cell(static_cast<std::size_t>(corners));
    MeshField attribute{"attribute", true, attributes, {}};
    std::int64_t first = 0;
    for (int c = 0; c < count; ++c) {
        readNumber(scanner, c, first);
        for (int& v : cell) v = readPointNumber(scanner, nodes);
        nodes.file.cells.add(*kind, inOrderOfVtk(cell, nodes.file.points));
        for (int k = 0; k < attributes; ++k) attribute.values.push_back(scanner.real("an attribute"));
    }
    scanner.requireEnd("the first line");
    if (attributes == 1) addGroups(nodes.file, attribute.values);
    if (attributes) nodes.file.fields.push_back(std::move(attribute));
}

/// Faces or edges with markers, which become groups; cells have the marker 0.
void readSides(std::string_view bytes, CellKind kind, Nodes& nodes) {
    if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    Scanner scanner(bytes, '#');
    const auto declared = scanner.integer("the number of faces or edges");
    const int markers = attributeCount(scanner);
    const auto corners = static_cast<std::size_t>(factsOf(kind).corners);
    const int count = scanner.checkedCount(declared, "faces or edges", 2 * (1 + corners));
    std::vector<int> cell(corners);
    std::vector<double> numbers(static_cast<std::size_t>(nodes.file.cells.size()), 0.0);
    std::int64_t first = 0;
    for (int c = 0; c < count; ++c) {
        readNumber(scanner, c, first);
        for (int& v : cell) v = readPointNumber(scanner, nodes);
        nodes.file.cells.add(kind, cell);
        numbers.push_back(markers ? scanner.real("a marker") : 0);
        scanner.line();  // TetGen may add the cells on both sides
    }
    addGroups(nodes.file, numbers);
    MeshFile& file = nodes.file;
    for (MeshField& field : file.fields)
        if (field.perCell)
            field.values.resize(static_cast<std::size_t>(file.cells.size() * field.components), 0.0);
    if (!markers) return;
    const auto marker = std::ranges::find_if(
        file.fields, [](const auto& one) { return one.perCell && one.name == "marker"; });
    if (marker == file.fields.end())
        file.fields.push_back({"marker", true, 1, std::move(numbers), {}, Scalar::Int32});
    else
        std::copy(numbers.end() - count, numbers.end(), marker->values.end() - count);
}

const MeshField* fieldNamed(const MeshFile& mesh, bool perCell, std::string_view name) {
    for (const auto& field : mesh.fields)
        if (field.perCell == perCell && field.name == name) return &field;
    return nullptr;
}

void printAttributes(TextWriter& out, const MeshField* field, std::size_t item) {
    const auto& values = field && field->perCell ? field->ofCells
                         : field                 ? field->values
                                                 : std::vector<double>();
    for (int k = 0; field && k < field->components; ++k) out << ' ' << values[item * field->components + k];
}

/// Prints a .node file with the attributes and markers of the vertices.
std::string printNodes(const MeshFile& mesh, int dimension) {
    const auto *attribute = fieldNamed(mesh, false, "attribute"), *marker = fieldNamed(mesh, false, "marker");
    if (marker && marker->components != 1) marker = nullptr;
    TextWriter out;
    out << mesh.points.cols() << ' ' << dimension << ' ' << (attribute ? attribute->components : 0) << ' '
        << (marker ? 1 : 0) << '\n';
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        out << v + mesh.firstNumber;
        for (int k = 0; k < dimension; ++k) out << ' ' << mesh.points(k, v);
        printAttributes(out, attribute, static_cast<std::size_t>(v));
        if (marker) out << ' ' << tagOf(marker, static_cast<int>(v), 0);
        out << '\n';
    }
    return std::move(out.text());
}

/// Cells of one kind, numbered one by one, each followed by what `rest` prints.
template <class Rest>
std::string cellLines(const MeshFile& mesh, CellKind kind, const std::string& head, const Rest& rest) {
    TextWriter out;
    out << std::ranges::count(mesh.cells.kinds, kind) << ' ' << head << '\n';
    int number = mesh.firstNumber;
    for (int c = 0; c < mesh.cells.size(); ++c) {
        if (mesh.cells.kinds[static_cast<std::size_t>(c)] != kind) continue;
        out << number++;
        for (const int v : mesh.cells[c]) out << ' ' << v + mesh.firstNumber;
        rest(out, static_cast<std::size_t>(c));
        out << '\n';
    }
    return std::move(out.text());
}

/// Prints the elements with the field "attribute", or the numbers of the groups.
std::string elementLines(const MeshFile& mesh, CellKind kind) {
    const MeshField* attribute = fieldNamed(mesh, true, "attribute");
    const std::string corners = std::to_string(factsOf(kind).corners) + " ";
    if (attribute)
        return cellLines(mesh, kind, corners + std::to_string(attribute->components),
                         [&](TextWriter& out, std::size_t c) { printAttributes(out, attribute, c); });
    const bool grouped = std::ranges::any_of(mesh.groups, [&](const auto& group) {
        return group.dimension == factsOf(kind).dimension && !group.cells.empty();
    });
    if (!grouped) return cellLines(mesh, kind, corners + "0", [](TextWriter&, std::size_t) {});
    const std::vector<long> numbers = groupNumbers(mesh);
    return cellLines(mesh, kind, corners + "1",
                     [&](TextWriter& out, std::size_t c) { out << ' ' << numbers[c]; });
}

/// Prints the boundary; empty if there are no cells of the kind.
std::string printSides(const MeshFile& mesh, CellKind kind) {
    if (std::ranges::count(mesh.cells.kinds, kind) == 0) return {};
    const std::vector<long> numbers = groupNumbers(mesh);
    return cellLines(mesh, kind, "1", [&](TextWriter& out, std::size_t c) { out << ' ' << numbers[c]; });
}

}  // namespace

MeshFile readTetgen(std::span<const MeshSource> files) {
    Nodes nodes = inFile(files[0], [&] { return readNodes(files[0].bytes); });
    nodes.file.firstNumber = static_cast<int>(nodes.first);
    inFile(files[1], [&] { readElements(files[1].bytes, nodes); });
    if (files.size() > 2) {
        const bool volume = std::ranges::any_of(nodes.file.cells.kinds,
                                                [](auto kind) { return factsOf(kind).dimension == 3; });
        if (volume) inFile(files[2], [&] { readSides(files[2].bytes, CellKind::Triangle, nodes); });
        inFile(files[3], [&] { readSides(files[3].bytes, CellKind::Line, nodes); });
    }
    finishCells(nodes.file);
    return std::move(nodes.file);
}

std::vector<std::string> printTetgen(const MeshFile& mesh, const MeshWriteOptions&) {
    const std::string edges = printSides(mesh, CellKind::Line);
    if (isVolume(mesh))
        return {printNodes(mesh, 3), elementLines(mesh, CellKind::Tetrahedron),
                printSides(mesh, CellKind::Triangle), edges};
    if ((mesh.points.row(2).array() != 0).any())
        throw InputError("TetGen files hold tetrahedra or triangles in the plane z = 0, and these are not");
    return {printNodes(mesh, 2), elementLines(mesh, CellKind::Triangle), {}, edges};
}

}  // namespace wend::formats
