// Medit .mesh (text): keyword, count, items; every item ends with a reference number, which becomes the field
// "ref".

#include <algorithm>

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

bool isKeyword(std::string_view word) {
    return !word.empty() && ((word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z'));
}

class MeditReader {
  public:
    explicit MeditReader(std::string_view bytes) : m_scanner(bytes, '#') {}

    MeshFile read() {
        requireKind();
        while (!m_scanner.atEnd()) {
            const auto keyword = m_scanner.word("a keyword");
            if (sameWord(keyword, "End")) break;
            if (!isKeyword(keyword)) m_scanner.fail(inQuotes(keyword) + " where a keyword is expected");
            section(keyword);
        }
        if (std::any_of(m_vertexRefs.begin(), m_vertexRefs.end(), [](double ref) { return ref != 0; }))
            m_file.fields.push_back({"ref", false, 1, std::move(m_vertexRefs)});
        m_file.fields.push_back({"ref", true, 1, m_cells.perCell(m_elementRefs, 1)});
        m_file.labels = m_cells.boundaryLabels(m_elementRefs);
        m_cells.moveInto(m_file);
        return std::move(m_file);
    }

  private:
    void requireKind() {
        const auto word = m_scanner.word("MeshVersionFormatted");
        if (!sameWord(word, "MeshVersionFormatted"))
            m_scanner.fail("does not begin with MeshVersionFormatted: no Medit text file");
        m_scanner.integer("a version");
    }
    void section(std::string_view keyword) {
        if (sameWord(keyword, "Dimension"))
            readDimension();
        else if (sameWord(keyword, "Vertices"))
            readVertices();
        else if (sameWord(keyword, "Triangles"))
            readCells(3);
        else if (sameWord(keyword, "Quadrilaterals"))
            readCells(4);
        else if (sameWord(keyword, "Tetrahedra"))
            readTetrahedra();
        else
            passOver(keyword);
    }
    void readDimension() {
        m_dimension = m_scanner.integer("the dimension");
        if (m_dimension != 2 && m_dimension != 3) m_scanner.fail("the dimension is neither 2 nor 3");
    }
    void readVertices() {
        if (m_dimension == 0) m_scanner.fail("the vertices stand before the dimension");
        if (m_file.points.cols()) m_scanner.fail("there are vertices a second time");
        const int count = m_scanner.count("vertices", 2 * (m_dimension + 1));
        m_file.points = Eigen::Matrix3Xd::Zero(3, count);
        for (auto p : m_file.points.colwise()) {
            for (int k = 0; k < m_dimension; ++k) p[k] = m_scanner.finite("a coordinate");
            m_vertexRefs.push_back(m_scanner.real("a reference"));
        }
    }
    int corner() {
        const auto number = m_scanner.integer("a vertex number");
        if (number < 1 || number > m_file.points.cols())
            m_scanner.fail("vertex " + std::to_string(number) + " is named, but there are only " +
                           std::to_string(m_file.points.cols()));
        return static_cast<int>(number - 1);
    }
    int reference() {
        m_elementRefs.push_back(m_scanner.real("a reference"));
        return static_cast<int>(m_elementRefs.size()) - 1;
    }
    void readCells(int corners) {
        const int count = m_scanner.count("cells", 2 * (corners + 1));
        std::vector<int> polygon(corners);
        for (int c = 0; c < count; ++c) {
            for (int& v : polygon) v = corner();
            m_cells.polygon(polygon, reference());
        }
    }
    void readTetrahedra() {
        const int count = m_scanner.count("tetrahedra", 10);
        for (int c = 0; c < count; ++c) {
            std::array<int, 4> corners;
            for (int& v : corners) v = corner();
            m_cells.tetrahedron(corners, reference());
        }
    }
    /// A section without meaning here ends at the next keyword.
    void passOver(std::string_view keyword) {
        const auto at = m_scanner.offset();
        if (sameWord(keyword, "Hexahedra") || sameWord(keyword, "Prisms") || sameWord(keyword, "Pyramids"))
            if (m_scanner.integer("a number of cells") != 0)
                m_scanner.fail(std::string(keyword) + ": only triangles and tetrahedra are read");
        m_scanner.seek(at);
        while (!m_scanner.atEnd()) {
            const auto before = m_scanner.offset();
            if (isKeyword(m_scanner.word("a keyword"))) {
                m_scanner.seek(before);
                return;
            }
        }
    }

    Scanner m_scanner;
    std::int64_t m_dimension = 0;
    MeshFile m_file;
    CellCollector m_cells;
    std::vector<double> m_vertexRefs, m_elementRefs;
};

const MeshField* vertexRefs(const MeshFile& mesh) {
    for (const auto& field : mesh.fields)
        if (!field.perCell && field.components == 1 && (field.name == "ref" || field.name == "marker"))
            return &field;
    return nullptr;
}

template <std::size_t N>
void printCells(TextWriter& out, const char* keyword, const std::vector<std::array<int, N>>& cells,
                const MeshField* refs) {
    if (cells.empty()) return;
    out << keyword << '\n' << cells.size() << '\n';
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (int v : cells[c]) out << v + 1 << ' ';
        out << tagOf(refs, static_cast<int>(c), 0) << '\n';
    }
}

}  // namespace

MeshFile readMedit(std::span<const MeshSource> files) {
    return MeditReader(files[0].bytes).read();
}

std::vector<std::string> printMedit(const MeshFile& mesh, const MeshWriteOptions&) {
    const auto* refs = cellField(mesh, {"ref", "physical", "entity", "attribute"});
    const auto* ofVertices = vertexRefs(mesh);
    TextWriter out;
    // in three dimensions always: Gmsh does not read flat ones
    out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.cols() << '\n';
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        for (int k = 0; k < 3; ++k) out << mesh.points(k, v) << ' ';
        out << tagOf(ofVertices, static_cast<int>(v), 0) << '\n';
    }
    const auto labels = labelField(mesh);
    printCells(out, "Triangles", mesh.triangles,
               mesh.tetrahedra.empty() ? refs
               : labels                ? &*labels
                                       : nullptr);
    printCells(out, "Tetrahedra", mesh.tetrahedra, refs);
    out << "End\n";
    return {std::move(out.text())};
}

}  // namespace wend::formats
