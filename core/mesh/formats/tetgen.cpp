// TetGen and Triangle: .node (points, attributes, a marker) and .ele (cells, attributes), counted from 0 or
// from 1.

#include "core/mesh/error.h"
#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

/// Whatever `read` throws gets this file's name: the pair has two.
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

int readCorner(Scanner& scanner, const Nodes& nodes) {
    const auto number = scanner.integer("a point's number"), index = number - nodes.first;
    if (index < 0 || index >= nodes.file.points.cols())
        scanner.fail("point " + std::to_string(number) + " is named, but there are only " +
                     std::to_string(nodes.file.points.cols()) + ", counted from " +
                     std::to_string(nodes.first));
    return static_cast<int>(index);
}

void readElements(std::string_view bytes, Nodes& nodes) {
    Scanner scanner(bytes, '#');
    const auto declared = scanner.integer("the number of cells");
    const auto corners = scanner.integer("the number of corners");
    if (corners != 3 && corners != 4)
        scanner.fail("cells with 3 or 4 corners are read, not with " + std::to_string(corners));
    const int attributes = attributeCount(scanner);
    const int count = scanner.checkedCount(declared, "cells", 2 * (1 + corners + attributes));

    CellCollector cells;
    std::vector<int> cell(corners);
    MeshField attribute{"attribute", true, attributes, {}};
    std::int64_t first = 0;
    for (int c = 0; c < count; ++c) {
        readNumber(scanner, c, first);
        for (int& v : cell) v = readCorner(scanner, nodes);
        corners == 3 ? cells.polygon(cell, c) : cells.tetrahedron({cell[0], cell[1], cell[2], cell[3]}, c);
        for (int k = 0; k < attributes; ++k) attribute.values.push_back(scanner.real("an attribute"));
    }
    scanner.requireEnd("the first line");
    cells.moveInto(nodes.file);
    if (attributes) nodes.file.fields.push_back(std::move(attribute));
}

const MeshField* fieldNamed(const MeshFile& mesh, bool perCell, std::string_view name) {
    for (const auto& field : mesh.fields)
        if (field.perCell == perCell && field.name == name) return &field;
    return nullptr;
}

void printAttributes(TextWriter& out, const MeshField* field, std::size_t item) {
    for (int k = 0; field && k < field->components; ++k)
        out << ' ' << field->values[item * field->components + k];
}

std::string printNodes(const MeshFile& mesh, int dimension) {
    const auto *attribute = fieldNamed(mesh, false, "attribute"), *marker = fieldNamed(mesh, false, "marker");
    if (marker && marker->components != 1) marker = nullptr;
    TextWriter out;
    out << mesh.points.cols() << ' ' << dimension << ' ' << (attribute ? attribute->components : 0) << ' '
        << (marker ? 1 : 0) << '\n';
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        out << v + 1;
        for (int k = 0; k < dimension; ++k) out << ' ' << mesh.points(k, v);
        printAttributes(out, attribute, static_cast<std::size_t>(v));
        if (marker) out << ' ' << tagOf(marker, static_cast<int>(v), 0);
        out << '\n';
    }
    return std::move(out.text());
}

template <std::size_t N>
std::string printElements(const MeshFile& mesh, const std::vector<std::array<int, N>>& cells) {
    const MeshField* attribute = fieldNamed(mesh, true, "attribute");
    if (!attribute) attribute = cellField(mesh, {"ref", "physical", "entity"});
    TextWriter out;
    out << cells.size() << ' ' << N << ' ' << (attribute ? attribute->components : 0) << '\n';
    for (std::size_t c = 0; c < cells.size(); ++c) {
        out << c + 1;
        for (int v : cells[c]) out << ' ' << v + 1;
        printAttributes(out, attribute, c);
        out << '\n';
    }
    return std::move(out.text());
}

}  // namespace

MeshFile readTetgen(std::span<const MeshSource> files) {
    Nodes nodes = inFile(files[0], [&] { return readNodes(files[0].bytes); });
    inFile(files[1], [&] { readElements(files[1].bytes, nodes); });
    return std::move(nodes.file);
}

std::vector<std::string> printTetgen(const MeshFile& mesh, const MeshWriteOptions&) {
    if (!mesh.tetrahedra.empty()) return {printNodes(mesh, 3), printElements(mesh, mesh.tetrahedra)};
    if ((mesh.points.row(2).array() != 0).any())
        throw InputError("TetGen files hold tetrahedra or triangles in the plane z = 0, and these are not");
    return {printNodes(mesh, 2), printElements(mesh, mesh.triangles)};
}

}  // namespace wend::formats
