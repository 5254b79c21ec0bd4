#include <algorithm>
#include <array>
#include <set>

#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/xdmf.h"

namespace wend::formats {
namespace {

struct XdmfType {
    const char* name;
    int precision;
};
XdmfType typeOf(Scalar type) {
    switch (type) {
        case Scalar::Int8:
            return {"Char", 1};
        case Scalar::UInt8:
            return {"UChar", 1};
        case Scalar::Int16:
            return {"Short", 2};
        case Scalar::UInt16:
            return {"UShort", 2};
        case Scalar::Int32:
            return {"Int", 4};
        case Scalar::UInt32:
            return {"UInt", 4};
        case Scalar::Int64:
            return {"Int", 8};
        case Scalar::UInt64:
            return {"UInt", 8};
        case Scalar::Float32:
            return {"Float", 4};
        case Scalar::Float64:
            break;
    }
    return {"Float", 8};
}

class XdmfPrinter {
  public:
    explicit XdmfPrinter(const MeshFile& mesh) : m_mesh(mesh) {}

    std::string print() {
        m_out << "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n<Domain>\n<Grid Name=\"Grid\" "
                 "GridType=\"Uniform\">\n<Geometry GeometryType=\"XYZ\">\n";
        item(std::span(m_mesh.points.data(), static_cast<std::size_t>(m_mesh.points.size())), 3,
             Scalar::Float64);
        m_out << "</Geometry>\n";
        printCells();
        for (const MeshField& field : m_mesh.fields)
            attribute(field, field.perCell ? "Cell" : "Node", field.perCell ? field.ofCells : field.values);
        for (const MeshField& field : m_mesh.fileFields) attribute(field, "Grid", field.values);
        printGroups();
        m_out << "</Grid>\n</Domain>\n</Xdmf>\n";
        return std::move(m_out.text());
    }

  private:
    /// Prints numbers with so many in a row.
    template <class T>
    void item(std::span<const T> values, std::size_t width, Scalar type) {
        const auto [name, precision] = typeOf(type);
        m_out << "<DataItem DataType=\"" << name << "\" Dimensions=\"" << values.size() / width;
        if (width > 1) m_out << ' ' << width;
        m_out << "\" Format=\"XML\" Precision=\"" << precision << "\">\n";
        const std::size_t onLine = width > 1 ? width : 12;
        for (std::size_t i = 0; i < values.size(); ++i)
            m_out << values[i] << ((i + 1) % onLine && i + 1 < values.size() ? ' ' : '\n');
        m_out << "</DataItem>\n";
    }
    static const XdmfTopology& topologyOf(CellKind kind) {
        return *std::ranges::find(xdmfTopologies(), kind, &XdmfTopology::kind);
    }
    /// Prints cells of one kind by their nodes, and others as a mixed topology.
    void printCells() {
        const CellList& cells = m_mesh.cells;
        if (cells.empty()) {
            m_out << "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"0\" NodesPerElement=\"1\"/>\n";
            return;
        }
        const CellKind first = cells.kinds.front();
        const bool isUniform =
            factsOf(first).nodes > 0 && std::ranges::count(cells.kinds, first) == cells.size();
        std::vector<std::int64_t> numbers;
        for (int c = 0; c < cells.size(); ++c) {
            const CellKind kind = cells.kinds[static_cast<std::size_t>(c)];
            const int number = topologyOf(kind).number;
            if (!isUniform) numbers.push_back(number);
            if (!isUniform && number <= kXdmfPolygon) numbers.push_back(std::ssize(cells[c]));
            numbers.insert(numbers.end(), cells[c].begin(), cells[c].end());
        }
        m_out << "<Topology TopologyType=\"" << (isUniform ? topologyOf(first).name : "Mixed")
              << "\" NumberOfElements=\"" << cells.size() << '"';
        if (isUniform && topologyOf(first).number <= kXdmfPolygon)
            m_out << " NodesPerElement=\"" << factsOf(first).nodes << '"';
        m_out << ">\n";
        item<std::int64_t>(numbers, isUniform ? static_cast<std::size_t>(factsOf(first).nodes) : 1,
                           Scalar::Int64);
        m_out << "</Topology>\n";
    }
    void attribute(const MeshField& field, const char* centre, const std::vector<double>& values) {
        const int k = field.components;
        m_out << "<Attribute Name=\"" << asXml(field.name) << "\" AttributeType=\""
              << (k == 1   ? "Scalar"
                  : k == 3 ? "Vector"
                  : k == 6 ? "Tensor6"
                  : k == 9 ? "Tensor"
                           : "Matrix")
              << "\" Center=\"" << centre << "\">\n";
        item<double>(values, static_cast<std::size_t>(k), field.type);
        m_out << "</Attribute>\n";
    }
    /// Returns for every group the number that its cells have in the field of numbers; 0 for groups that
    /// share cells with others, or are of vertices.
    std::vector<long> numbersOfGroups(const std::vector<int>& main) const {
        std::vector<long> numbers;
        std::set<long> taken;
        long highest = 0;
        for (const MeshGroup& group : m_mesh.groups) highest = std::max(highest, group.tag);
        for (std::size_t g = 0; g < m_mesh.groups.size(); ++g) {
            const MeshGroup& group = m_mesh.groups[g];
            const bool isAlone = !group.cells.empty() && std::ranges::all_of(group.cells, [&](int c) {
                return main[static_cast<std::size_t>(c)] == static_cast<int>(g);
            });
            const bool isFree = isAlone && group.tag > 0 && taken.insert(group.tag).second;
            numbers.push_back(!isAlone ? 0 : isFree ? group.tag : ++highest);
        }
        return numbers;
    }
    /// Prints a field of numbers with their names, as meshio reads them; groups that it cannot hold become
    /// sets.
    void printGroups() {
        const std::vector<int> main = mainGroups(m_mesh);
        const std::vector<long> numbers = numbersOfGroups(main);
        MeshField field{kXdmfGroups, true, 1, {}, {}, Scalar::Int32};
        for (const int group : main)
            field.ofCells.push_back(
                group < 0 ? 0 : static_cast<double>(numbers[static_cast<std::size_t>(group)]));
        const MeshField* own =
            cellField(m_mesh, {"physical", "ref", "attribute", "material", "pid", "label"});
        const bool isNumbered = std::ranges::any_of(field.ofCells, [](double number) { return number != 0; });
        if (isNumbered && !(own && own->ofCells == field.ofCells)) attribute(field, "Cell", field.ofCells);
        printNames(numbers);
        for (std::size_t g = 0; g < numbers.size(); ++g)
            for (const auto* list : {&m_mesh.groups[g].cells, &m_mesh.groups[g].vertices}) {
                if (numbers[g] != 0 || list->empty()) continue;
                m_out << "<Set Name=\"" << asXml(groupName(m_mesh.groups[g])) << "\" SetType=\""
                      << (list == &m_mesh.groups[g].cells ? "Cell" : "Node") << "\">\n";
                const std::vector<std::int64_t> members(list->begin(), list->end());
                item<std::int64_t>(members, 1, Scalar::Int64);
                m_out << "</Set>\n";
            }
    }
    void printNames(const std::vector<long>& numbers) {
        std::string names;
        for (std::size_t g = 0; g < numbers.size(); ++g)
            if (const MeshGroup& group = m_mesh.groups[g]; numbers[g] != 0 && !group.name.empty())
                names += "<map key=\"" + asXml(group.name) + "\" dim=\"" + std::to_string(group.dimension) +
                         "\">" + std::to_string(numbers[g]) + "</map>";
        if (!names.empty())
            m_out << "<Information Name=\"groups\"><![CDATA[<main>" << names << "</main>]]></Information>\n";
    }

    const MeshFile& m_mesh;
    TextWriter m_out;
};

}  // namespace

std::span<const XdmfTopology> xdmfTopologies() {
    static const std::array<XdmfTopology, 21> topologies{{
        {"Polyvertex", "Polyvertex", kXdmfVertex, CellKind::Vertex},
        {"Polyvertex", "Polyvertex", kXdmfVertex, CellKind::PolyVertex},
        {"Polyline", "Edge", kXdmfLine, CellKind::Line},
        {"Polyline", "Polyline", kXdmfLine, CellKind::PolyLine},
        {"Polygon", "Polygon", kXdmfPolygon, CellKind::Polygon},
        {"Triangle", "Tri", 4, CellKind::Triangle},
        {"Quadrilateral", "Quad", 5, CellKind::Quad},
        {"Tetrahedron", "Tet", 6, CellKind::Tetrahedron},
        {"Pyramid", "Pyr", 7, CellKind::Pyramid},
        {"Wedge", "Prism", 8, CellKind::Wedge},
        {"Hexahedron", "Hex", 9, CellKind::Hexahedron},
        {"Edge_3", "Edge_3", 34, CellKind::Line3},
        {"Quadrilateral_9", "Quad_9", 35, CellKind::Quad9},
        {"Triangle_6", "Tri_6", 36, CellKind::Triangle6},
        {"Quadrilateral_8", "Quad_8", 37, CellKind::Quad8},
        {"Tetrahedron_10", "Tet_10", 38, CellKind::Tetrahedron10},
        {"Pyramid_13", "Pyramid_13", 39, CellKind::Pyramid13},
        {"Wedge_15", "Wedge_15", 40, CellKind::Wedge15},
        {"Wedge_18", "Wedge_18", 41, CellKind::Wedge18},
        {"Hexahedron_20", "Hex_20", 48, CellKind::Hexahedron20},
        {"Hexahedron_27", "Hex_27", 50, CellKind::Hexahedron27},
    }};
    return topologies;
}

std::vector<std::string> printXdmf(const MeshFile& mesh, const MeshWriteOptions&) {
    return {XdmfPrinter(mesh).print()};
}

}  // namespace wend::formats
