// AVS UCD .inp (text): the numbers of nodes, cells and values; nodes and cells with numbers of their own, a
// cell with a material, which becomes the field "material"; then what is known at the nodes and in the cells.

#include <algorithm>
#include <unordered_map>

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/vtk_fields.h"

namespace wend::formats {
namespace {

struct UcdKind {
    std::string_view name;
    int corners;
};
constexpr UcdKind kKinds[] = {{"pt", 1}, {"line", 2}, {"tri", 3}, {"quad", 4}, {"tet", 4}};

class UcdReader {
  public:
    explicit UcdReader(std::string_view bytes) : m_scanner(bytes, '#') {}

    MeshFile read() {
        if (m_scanner.bytes().starts_with('\7')) m_scanner.fail("a binary UCD file is not read");
        const int nodes = m_scanner.count("nodes", 8), cells = m_scanner.count("cells", 8);
        const auto ofNodes = m_scanner.integer("the number of values of a node");
        const auto ofCells = m_scanner.integer("the number of values of a cell");
        m_scanner.line();  // values of the model
        readNodes(nodes);
        for (int c = 0; c < cells; ++c) readCell(c);
        if (ofNodes > 0) readFields(m_nodes, ofNodes, false);
        if (ofCells > 0) readFields(m_cells, ofCells, true);
        const bool plain = std::ranges::all_of(m_materials, [](double material) { return material == 0; });
        if (!plain) m_file.fields.push_back({"material", true, 1, m_collector.perCell(m_materials, 1)});
        m_collector.moveInto(m_file);
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
    void readCell(int element) {
        readNumber(m_cells, "cell");
        m_materials.push_back(static_cast<double>(m_scanner.integer("a material")));
        const auto name = m_scanner.word("a kind of cell");
        const auto kind =
            std::ranges::find_if(kKinds, [&](const UcdKind& one) { return sameWord(one.name, name); });
        if (kind == std::end(kKinds))
            m_scanner.fail(inQuotes(name) + ": only triangles and tetrahedra are read");
        std::array<int, 4> corners{};
        for (int k = 0; k < kind->corners; ++k) corners[k] = known(m_nodes, "node");
        if (kind->name == "tet")
            m_collector.tetrahedron(corners, element);
        else if (kind->corners >= 3)
            m_collector.polygon(std::span(corners).first(kind->corners), element);
    }
    /// How many fields and the components of each, a line with name and unit for each, and a line of values
    /// for each node or cell.
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
        for (MeshField& field : fields) take(std::move(field));
    }
    void take(MeshField field) {
        if (isVtkLabels(field)) return takeVtkLabels(field, m_collector, m_file);
        if (field.perCell) field.values = m_collector.perCell(field.values, field.components);
        m_file.fields.push_back(std::move(field));
    }

    Scanner m_scanner;
    MeshFile m_file;
    CellCollector m_collector;
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

std::vector<std::string> printUcd(const MeshFile& mesh, const MeshWriteOptions&) {
    const VtkCells cells = vtkCellsOf(mesh);
    std::vector<MeshField> fields = vtkFieldsOf(mesh);
    const auto ofCells =
        std::ranges::stable_partition(fields, [](const auto& field) { return !field.perCell; });
    const std::vector<MeshField> atCells(ofCells.begin(), ofCells.end()),
        atNodes(fields.begin(), ofCells.begin());
    TextWriter out;
    out << mesh.points.cols() << ' ' << cells.types.size() << ' ' << components(atNodes) << ' '
        << components(atCells) << " 0\n";
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        out << v + 1;
        for (int k = 0; k < 3; ++k) out << ' ' << mesh.points(k, v);
        out << '\n';
    }
    for (std::size_t c = 0; c < cells.types.size(); ++c) {
        out << c + 1 << " 0 " << (cells.types[c] == vtkTetrahedron ? "tet" : "tri");
        for (auto at = cells.offsets[c]; at < cells.offsets[c + 1]; ++at)
            out << ' ' << cells.connectivity[at] + 1;
        out << '\n';
    }
    printFields(out, atNodes, mesh.points.cols());
    printFields(out, atCells, static_cast<Eigen::Index>(cells.types.size()));
    return {std::move(out.text())};
}

}  // namespace wend::formats
