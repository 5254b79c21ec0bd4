// Medit .mesh (text): keyword, count, items; every cell and vertex ends with a reference number, which
// becomes the field "ref" and a group. Corners, ridges and what is required are groups of these names.

#include <algorithm>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

bool isKeyword(std::string_view word) {
    return !word.empty() && ((word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z'));
}

struct MeditKind {
    std::string_view keyword;
    CellKind kind;
};
constexpr MeditKind kKinds[] = {{"Edges", CellKind::Line},           {"Triangles", CellKind::Triangle},
                                {"Quadrilaterals", CellKind::Quad},  {"Tetrahedra", CellKind::Tetrahedron},
                                {"Hexahedra", CellKind::Hexahedron}, {"Prisms", CellKind::Wedge},
                                {"Pyramids", CellKind::Pyramid}};

/// Lists of vertices or of cells, by their numbers.
struct MeditList {
    std::string_view keyword;
    int dimension;
};
constexpr MeditList kLists[] = {
    {"Corners", 0},       {"RequiredVertices", 0},  {"Ridges", 1},
    {"RequiredEdges", 1}, {"RequiredTriangles", 2}, {"RequiredQuadrilaterals", 2}};

const MeditList* listNamed(std::string_view name) {
    for (const MeditList& list : kLists)
        if (sameWord(list.keyword, name)) return &list;
    return nullptr;
}

/// Returns whether a list counts cells of this kind.
bool countsIn(const MeditList& list, CellKind kind) {
    if (list.keyword == "RequiredTriangles") return kind == CellKind::Triangle;
    if (list.keyword == "RequiredQuadrilaterals") return kind == CellKind::Quad;
    return kind == CellKind::Line;
}

class MeditReader {
  public:
    explicit MeditReader(std::string_view bytes) : m_scanner(bytes, '#') {}

    /// Reads sections up to End. References of vertices that are all 0 are no field.
    MeshFile read() {
        requireKind();
        while (!m_scanner.atEnd()) {
            const auto keyword = m_scanner.word("a keyword");
            if (sameWord(keyword, "End")) break;
            if (!isKeyword(keyword)) m_scanner.fail(inQuotes(keyword) + " where a keyword is expected");
            section(keyword);
        }
        requireCells();
        if (std::any_of(m_vertexRefs.begin(), m_vertexRefs.end(), [](double ref) { return ref != 0; }))
            m_file.fields.push_back({"ref", false, 1, std::move(m_vertexRefs), {}, Scalar::Int32});
        addGroups(m_file, m_refs);
        for (const auto& [list, numbers] : m_lists) takeList(*list, numbers);
        m_file.fields.push_back({"ref", true, 1, std::move(m_refs), {}, Scalar::Int32});
        finishCells(m_file, [this](int cell) {
            return m_scanner.placeOf(m_offsets[static_cast<std::size_t>(cell)]);
        });
        return std::move(m_file);
    }

  private:
    void requireKind() {
        const auto word = m_scanner.word("MeshVersionFormatted");
        if (!sameWord(word, "MeshVersionFormatted"))
            m_scanner.fail("does not begin with MeshVersionFormatted: no Medit text file");
        m_scanner.integer("a version");
    }
    /// Reads the section of a keyword; sections without meaning here are skipped.
    void section(std::string_view keyword) {
        if (sameWord(keyword, "Dimension"))
            readDimension();
        else if (sameWord(keyword, "Vertices"))
            readVertices();
        else if (const auto kind = std::ranges::find_if(
                     kKinds, [&](const auto& one) { return sameWord(one.keyword, keyword); });
                 kind != std::end(kKinds))
            readCells(kind->kind);
        else if (const MeditList* list = listNamed(keyword))
            readList(*list);
        else
            passOver(std::string(keyword));
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
    void readCells(CellKind kind) {
        const auto corners = static_cast<std::size_t>(factsOf(kind).corners);
        const int count = m_scanner.count("cells", 2 * (corners + 1));
        std::vector<int> cell(corners);
        for (int c = 0; c < count; ++c) {
            m_offsets.push_back(m_scanner.offset());
            for (int& v : cell) v = corner();
            m_file.cells.add(kind, cell);
            m_refs.push_back(m_scanner.real("a reference"));
        }
    }
    /// Cells may follow their list.
    void readList(const MeditList& list) {
        const int count = m_scanner.count("numbers", 2);
        std::vector<std::int64_t> numbers;
        for (int i = 0; i < count; ++i) numbers.push_back(m_scanner.integer("a number"));
        m_lists.emplace_back(&list, std::move(numbers));
    }
    /// Makes a group of one of Medit's lists, whose numbers count the vertices, or the cells of its kinds,
    /// from 1.
    void takeList(const MeditList& list, const std::vector<std::int64_t>& numbers) {
        MeshGroup group{std::string(list.keyword), list.dimension, 0, {}, {}, false};
        std::vector<int> counted;
        if (list.dimension == 0)
            for (int v = 0; v < m_file.points.cols(); ++v) counted.push_back(v);
        for (int c = 0; list.dimension > 0 && c < m_file.cells.size(); ++c)
            if (countsIn(list, m_file.cells.kinds[static_cast<std::size_t>(c)])) counted.push_back(c);
        auto& members = list.dimension == 0 ? group.vertices : group.cells;
        for (const auto number : numbers) {
            if (number < 1 || number > static_cast<std::int64_t>(counted.size()))
                throw InputError(std::string(list.keyword) + ": names number " + std::to_string(number) +
                                 ", but there are only " + std::to_string(counted.size()));
            members.push_back(counted[static_cast<std::size_t>(number) - 1]);
        }
        std::ranges::sort(members);
        if (!members.empty()) m_file.groups.push_back(std::move(group));
    }
    /// A section without meaning here ends at the next keyword.
    void passOver(const std::string& keyword) {
        const auto at = m_scanner.offset();
        m_scanner.seek(at);
        while (!m_scanner.atEnd()) {
            const auto before = m_scanner.offset();
            if (isKeyword(m_scanner.word("a keyword"))) {
                m_scanner.seek(before);
                break;
            }
        }
        if (isOfHigherOrder(keyword)) m_higherOrder = keyword;
        m_file.notices.push_back("its section " + inQuotes(keyword));
    }
    /// Returns whether a section holds cells with nodes between their corners: TetrahedraP2, HexahedraQ2.
    static bool isOfHigherOrder(std::string_view keyword) {
        if (keyword.size() < 3) return false;
        const char family = keyword[keyword.size() - 2], order = keyword.back();
        return (family == 'P' || family == 'Q') && order >= '2' && order <= '9';
    }
    void requireCells() const {
        if (m_file.cells.empty() && !m_higherOrder.empty())
            throw InputError("its cells have nodes between their corners (" + inQuotes(m_higherOrder) +
                             "), which are not read from Medit files");
    }

    Scanner m_scanner;
    std::int64_t m_dimension = 0;
    MeshFile m_file;
    std::string m_higherOrder;                 // a section of such cells that is passed over
    std::vector<double> m_vertexRefs, m_refs;  // of vertices and cells
    std::vector<std::size_t> m_offsets;        // of cells
    std::vector<std::pair<const MeditList*, std::vector<std::int64_t>>> m_lists;
};

const MeshField* vertexRefs(const MeshFile& mesh) {
    for (const auto& field : mesh.fields)
        if (!field.perCell && field.components == 1 && (field.name == "ref" || field.name == "marker"))
            return &field;
    return nullptr;
}

/// Prints the cells of one kind with their references.
void printKind(TextWriter& out, const MeditKind& kind, const MeshFile& mesh,
               const std::vector<long>& references) {
    const auto count = std::ranges::count(mesh.cells.kinds, kind.kind);
    if (count == 0) return;
    out << kind.keyword << '\n' << count << '\n';
    for (int c = 0; c < mesh.cells.size(); ++c) {
        if (mesh.cells.kinds[static_cast<std::size_t>(c)] != kind.kind) continue;
        for (const int v : mesh.cells[c]) out << v + 1 << ' ';
        out << references[static_cast<std::size_t>(c)] << '\n';
    }
}

/// Prints a group as one of Medit's lists.
void printList(TextWriter& out, const MeditList& list, const MeshGroup& group, const MeshFile& mesh) {
    std::vector<int> numbers;
    for (const int v : group.vertices) numbers.push_back(v + 1);
    int number = 0;
    for (int c = 0; c < mesh.cells.size() && list.dimension > 0; ++c) {
        if (!countsIn(list, mesh.cells.kinds[static_cast<std::size_t>(c)])) continue;
        ++number;
        if (std::ranges::binary_search(group.cells, c)) numbers.push_back(number);
    }
    if (numbers.empty()) return;
    out << list.keyword << '\n' << numbers.size() << '\n';
    for (const int one : numbers) out << one << '\n';
}

}  // namespace

bool isMeditList(std::string_view name) {
    return listNamed(name) != nullptr;
}

MeshFile readMedit(std::span<const MeshSource> files) {
    return MeditReader(files[0].bytes).read();
}

std::vector<std::string> printMedit(const MeshFile& mesh, const MeshWriteOptions&) {
    const auto* ofVertices = vertexRefs(mesh);
    TextWriter out;
    // The dimension is always 3, because Gmsh does not read flat files.
    out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.cols() << '\n';
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        for (int k = 0; k < 3; ++k) out << mesh.points(k, v) << ' ';
        out << tagOf(ofVertices, static_cast<int>(v), 0) << '\n';
    }
    const std::vector<long> references = groupNumbers(mesh);
    for (const MeditKind& kind : kKinds) printKind(out, kind, mesh, references);
    for (const MeshGroup& group : mesh.groups)
        if (const MeditList* list = listNamed(group.name)) printList(out, *list, group, mesh);
    out << "End\n";
    return {std::move(out.text())};
}

}  // namespace wend::formats
