// AVS UCD .avs, .ucd (text): the numbers of nodes, cells and values; nodes and cells with numbers of their
// own, a cell with a material, which becomes the field "material"; then what is known at the nodes and in the
// cells.

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/vtk_fields.h"

namespace wend::formats {
namespace {

/// A kind of cell in AVS UCD. `order[k]` is the position of VTK's node k in AVS's list; it is empty if both
/// orders agree.
struct UcdKind {
    std::string_view name;
    CellKind kind;
    std::vector<std::size_t> order;
};
const std::vector<UcdKind>& ucdKinds() {
    static const std::vector<UcdKind> kinds = {{"pt", CellKind::Vertex, {}},
                                               {"line", CellKind::Line, {}},
                                               {"tri", CellKind::Triangle, {}},
                                               {"quad", CellKind::Quad, {}},
                                               {"tet", CellKind::Tetrahedron, {}},
                                               {"pyr", CellKind::Pyramid, {1, 2, 3, 4, 0}},
                                               {"prism", CellKind::Wedge, {3, 4, 5, 0, 1, 2}},
                                               {"hex", CellKind::Hexahedron, {4, 5, 6, 7, 0, 1, 2, 3}}};
    return kinds;
}

class UcdReader {
  public:
    explicit UcdReader(std::string_view bytes) : m_scanner(bytes, '#') {}

    /// Reads the counts, nodes, cells with their materials, and the values of nodes and cells.
    MeshFile read() {
        if (m_scanner.bytes().starts_with('\7')) m_scanner.fail("a binary UCD file is not read");
        const int nodes = m_scanner.count("nodes", 8), cells = m_scanner.count("cells", 8);
        const auto ofNodes = m_scanner.integer("the number of values of a node");
        const auto ofCells = m_scanner.integer("the number of values of a cell");
        m_scanner.line();  // values of the model
        readNodes(nodes);
        for (int c = 0; c < cells; ++c) readCell();
        if (ofNodes > 0) readFields(m_nodes, ofNodes, false);
        if (ofCells > 0) readFields(m_cells, ofCells, true);
        const bool plain = std::ranges::all_of(m_materials, [](double material) { return material == 0; });
        if (!plain) m_file.fields.push_back({"material", true, 1, m_materials, {}, Scalar::Int32});
        addGroupsOfFields(m_file);
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    using Numbers = std::unordered_map<std::int64_t, int>;

    void readNumber(Numbers& numbers, const char* what) {
        const auto number = m_scanner.integer(what);
        if (!numbers.emplace(number, static_cast<int>(numbers.size())).second)
            m_scanner.fail(std::string(what) + " " + std::to_string(number) + " is there a second time");
    }
    int known(const Numbers& numbers, const char* what) {
        const auto number = m_scanner.integer(what);
        const auto found = numbers.find(number);
        if (found == numbers.end())
            m_scanner.fail(std::string(what) + " " + std::to_string(number) + " is not there");
        return found->second;
    }
    void readNodes(int count) {
        m_file.points.resize(3, count);
        for (auto p : m_file.points.colwise()) {
            readNumber(m_nodes, "node");
            for (double& coordinate : p) coordinate = m_scanner.finite("a coordinate");
        }
    }
    void readCell() {
        readNumber(m_cells, "cell");
        m_materials.push_back(static_cast<double>(m_scanner.integer("a material")));
        const auto name = m_scanner.word("a kind of cell");
        const auto kind =
            std::ranges::find_if(ucdKinds(), [&](const UcdKind& one) { return sameWord(one.name, name); });
        if (kind == ucdKinds().end()) m_scanner.fail(inQuotes(name) + " is no kind of cell that is read");
        std::vector<int> read(static_cast<std::size_t>(factsOf(kind->kind).nodes));
        for (int& v : read) v = known(m_nodes, "node");
        std::vector<int> nodes = read;
        for (std::size_t k = 0; k < kind->order.size(); ++k) nodes[k] = read[kind->order[k]];
        m_file.cells.add(kind->kind, nodes);
    }
    /// Reads the number of fields and the components of each, a line with name and unit for each, and a line
    /// of values for each node or cell.
    void readFields(const Numbers& numbers, std::int64_t perLine, bool perCell) {
        std::vector<MeshField> fields(m_scanner.count("fields", 2));
        std::int64_t sum = 0;
        for (MeshField& field : fields) {
            field.perCell = perCell;
            field.components =
                m_scanner.checkedCount(m_scanner.integer("a number of components"), "components", 1);
            if (field.components < 1) m_scanner.fail("a field without components");
            sum += field.components;
        }
        if (sum != perLine)
            m_scanner.fail("the fields have " + std::to_string(sum) +
                           " components where the first line says " + std::to_string(perLine));
        m_scanner.checkedCount(sum * static_cast<std::int64_t>(numbers.size()), "values", 2);
        m_scanner.line();
        for (MeshField& field : fields) {
            const auto line = m_scanner.line();
            field.name = line.substr(0, line.find(','));
            field.values.resize(numbers.size() * static_cast<std::size_t>(field.components));
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const int at = known(numbers, perCell ? "cell" : "node");
            for (MeshField& field : fields)
                for (int k = 0; k < field.components; ++k)
                    field.values[static_cast<std::size_t>(at) * field.components + k] =
                        m_scanner.real("a value");
        }
        for (MeshField& field : fields) m_file.fields.push_back(std::move(field));
    }

    Scanner m_scanner;
    MeshFile m_file;
    Numbers m_nodes, m_cells;
    std::vector<double> m_materials;
};

/// A comma would end the name.
std::string ucdName(std::string name) {
    for (char& c : name)
        if (c == ',' || c == '#' || static_cast<unsigned char>(c) < ' ') c = '_';
    return name.empty() ? "field" : name;
}

void printFields(TextWriter& out, const std::vector<MeshField>& fields, Eigen::Index count) {
    if (fields.empty()) return;
    out << fields.size();
    for (const MeshField& field : fields) out << ' ' << field.components;
    for (const MeshField& field : fields) out << '\n' << ucdName(field.name) << ", none";
    for (Eigen::Index i = 0; i < count; ++i) {
        out << '\n' << i + 1;
        for (const MeshField& field : fields)
            for (int k = 0; k < field.components; ++k) out << ' ' << field.values[i * field.components + k];
    }
    out << '\n';
}

int components(const std::vector<MeshField>& fields) {
    int sum = 0;
    for (const MeshField& field : fields) sum += field.components;
    return sum;
}

}  // namespace

MeshFile readUcd(std::span<const MeshSource> files) {
    return UcdReader(files[0].bytes).read();
}

/// Prints nodes, cells with their materials, and all other fields.
std::vector<std::string> printUcd(const MeshFile& mesh, const MeshWriteOptions&) {
    std::vector<MeshField> fields = vtkFieldsOf(mesh);
    const MeshField* material = cellField(mesh, {"material"});
    std::erase_if(fields, [](const auto& field) { return field.perCell && field.name == "material"; });
    const auto ofCells =
        std::ranges::stable_partition(fields, [](const auto& field) { return !field.perCell; });
    const std::vector<MeshField> atCells(ofCells.begin(), ofCells.end()),
        atNodes(fields.begin(), ofCells.begin());
    TextWriter out;
    out << mesh.points.cols() << ' ' << mesh.cells.size() << ' ' << components(atNodes) << ' '
        << components(atCells) << " 0\n";
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        out << v + 1;
        for (int k = 0; k < 3; ++k) out << ' ' << mesh.points(k, v);
        out << '\n';
    }
    for (int c = 0; c < mesh.cells.size(); ++c) {
        const auto kind =
            std::ranges::find(ucdKinds(), mesh.cells.kinds[static_cast<std::size_t>(c)], &UcdKind::kind);
        const double number = material ? material->ofCells[static_cast<std::size_t>(c)] : 0;
        out << c + 1 << ' ' << (std::abs(number) < 2147483647 ? std::lround(number) : 0) << ' ' << kind->name;
        std::vector<int> nodes(mesh.cells[c].begin(), mesh.cells[c].end());
        for (std::size_t k = 0; k < kind->order.size(); ++k) nodes[kind->order[k]] = mesh.cells[c][k];
        for (const int v : nodes) out << ' ' << v + 1;
        out << '\n';
    }
    printFields(out, atNodes, mesh.points.cols());
    printFields(out, atCells, mesh.cells.size());
    return {std::move(out.text())};
}

}  // namespace wend::formats
