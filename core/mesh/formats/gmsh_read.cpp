// Gmsh .msh, versions 2.2 and 4.1, text and binary. Physical and entity tags of the cells become fields.

#include <algorithm>
#include <map>

#include "core/mesh/formats/gmsh_groups.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

/// The element types that can be met; those without corners to keep are passed over.
struct ElementType {
    int number, nodes;
    const char* name;
};
constexpr ElementType elementTypes[] = {{15, 1, "point"},     {1, 2, "line"},     {8, 3, "line"},
                                        {26, 4, "line"},      {2, 3, "triangle"}, {3, 4, "quadrangle"},
                                        {4, 4, "tetrahedron"}};
constexpr std::pair<int, const char*> unreadTypes[] = {{5, "hexahedron"},
                                                       {6, "prism"},
                                                       {7, "pyramid"},
                                                       {9, "triangle of second order"},
                                                       {10, "curved quadrangle"},
                                                       {11, "tetrahedron of second order"}};

constexpr int kHighestNamed = 100000;  // labels have a list of names: no file shall make it a long one

class GmshReader {
  public:
    explicit GmshReader(std::string_view bytes) : m_scanner(bytes) {}

    MeshFile read() {
        readFormat();
        while (!m_scanner.atEnd()) section();
        if (!m_hasNodes) m_scanner.fail("there is no section $Nodes");
        for (const int dimension : {2, 3}) ungroupTheRest(dimension);
        m_file.fields.push_back({"physical", true, 1, m_cells.perCell(m_physical, 1)});
        m_file.fields.push_back({"entity", true, 1, m_cells.perCell(m_entity, 1)});
        m_file.labels = m_cells.boundaryLabels(m_physical);
        takeNames();
        m_cells.moveInto(m_file);
        return std::move(m_file);
    }

  private:
    void readFormat() {
        if (m_scanner.word("$MeshFormat") != "$MeshFormat")
            m_scanner.fail("does not begin with $MeshFormat: no Gmsh file of version 2.2 or 4.1");
        const auto version = m_scanner.word("the version");
        if (version != "4.1" && version != "2.2" && version != "2.1" && version != "2" && version != "2.0")
            m_scanner.fail("version " + inQuotes(version) + " is not read; save the mesh as 4.1 or 2.2");
        m_version4 = version == "4.1";
        const auto fileType = m_scanner.integer("0 or 1 for text or binary");
        const auto dataSize = m_scanner.integer("the size of a number");
        m_binary = fileType != 0;
        if (m_binary && dataSize != 8) m_scanner.fail("only numbers of 8 bytes are read");
        m_scanner.line();
        if (m_binary) findOrder();
        endSection("$EndMeshFormat");
    }
    /// Binary files hold the number 1 here, in their byte order.
    void findOrder() {
        m_scanner.placesAreOffsets();
        const auto one = m_scanner.raw(4, "the byte order");
        for (const auto order : {std::endian::little, std::endian::big}) {
            if (decodeInteger(one, Scalar::Int32, order) != 1) continue;
            m_numbers = NumberReader(m_scanner, true, order);
            return;
        }
        m_scanner.fail("the byte order cannot be told");
    }
    void endSection(const std::string& wanted) {
        const auto word = m_scanner.word(wanted.c_str());
        if (word != wanted) m_scanner.fail(inQuotes(word) + " where " + wanted + " is expected");
    }
    void section() {
        const std::string name(m_scanner.word("a section"));
        if (name.size() < 2 || name[0] != '$')
            m_scanner.fail(inQuotes(name) + " where a section is expected");
        const std::string end = "$End" + name.substr(1);
        if (name == "$PhysicalNames") return readNames(end);
        if (name != "$Nodes" && name != "$Elements" && name != "$Entities") return passOver(end);
        m_scanner.line();
        if (name == "$Entities")
            readEntities();
        else if (name == "$Nodes")
            m_version4 ? readNodes4() : readNodes2();
        else
            m_version4 ? readElements4() : readElements2();
        endSection(end);
    }
    void readNames(const std::string& end) {
        m_scanner.line();
        const int count = m_scanner.count("names", 6);
        m_scanner.line();
        for (int k = 0; k < count; ++k) {
            const auto dimension = m_scanner.integer("a dimension"),
                       tag = m_scanner.integer("a physical tag");
            std::string name(m_scanner.line());
            const auto first = name.find('"'), last = name.rfind('"');
            if (first == std::string::npos || last == first) m_scanner.fail("a name should stand in quotes");
            if (tag > 0 && tag <= kHighestNamed)
                m_names[{static_cast<int>(dimension), static_cast<int>(tag)}] =
                    name.substr(first + 1, last - first - 1);
        }
        endSection(end);
    }
    /// Names of surfaces become those of the labels 1, 2, …
    void takeNames() {
        if (m_file.labels.empty()) return;
        for (const auto& [group, name] : m_names) {
            if (group[0] != 2) continue;
            m_file.labelNames.resize(static_cast<std::size_t>(group[1]));
            m_file.labelNames.back() = name;
        }
    }
    /// The group that GmshGroups gives to what has no tag.
    void ungroupTheRest(int dimension) {
        int maximum = 0, before = 0;
        for (std::size_t e = 0; e < m_physical.size(); ++e)
            if (m_dimensions[e] == dimension) maximum = std::max(maximum, static_cast<int>(m_physical[e]));
        for (std::size_t e = 0; e < m_physical.size(); ++e)
            if (m_dimensions[e] == dimension && m_physical[e] < maximum)
                before = std::max(before, static_cast<int>(m_physical[e]));
        const bool volume = std::ranges::count(m_dimensions, 3) > 0;
        const auto name = m_names.find({dimension, maximum});
        if (name == m_names.end() || name->second != groupOfTheRest(volume, dimension) ||
            maximum != before + 1)
            return;
        for (std::size_t e = 0; e < m_physical.size(); ++e)
            if (m_dimensions[e] == dimension && m_physical[e] == maximum) m_physical[e] = 0;
        m_names.erase(name);
    }
    void passOver(const std::string& end) {
        const auto at = m_scanner.bytes().find("\n" + end, m_scanner.offset());
        if (at == std::string_view::npos) m_scanner.fail("the section is not closed with " + end);
        m_scanner.seek(at + 1 + end.size());
    }

    int int32(const char* what) {
        const auto value = m_numbers.integer(Scalar::Int32, what);
        if (value < -2147483647 || value > 2147483647) m_scanner.fail(std::string(what) + " is too great");
        return static_cast<int>(value);
    }
    int count64(const char* things, std::size_t numbersEach, Scalar type) {
        return m_numbers.count(Scalar::UInt64, things, numbersEach, type);
    }
    Eigen::Vector3d point() {
        Eigen::Vector3d p;
        for (double& coordinate : p) coordinate = m_numbers.finite(Scalar::Float64, "a coordinate");
        return p;
    }
    /// The count at the head of a section of version 2 is text in binary files too, with a line of its own.
    int count2(const char* things, std::size_t bytesEach) {
        const int count = m_scanner.count(things, bytesEach);
        if (m_binary) m_scanner.line();
        return count;
    }

    void startNodes(int count) {
        if (m_hasNodes) m_scanner.fail("there are nodes a second time");
        m_hasNodes = true;
        m_file.points.resize(3, count);
        m_tags.reserve(count);
    }
    void readNodes2() {
        startNodes(count2("nodes", m_binary ? 28 : 8));
        for (Eigen::Index v = 0; v < m_file.points.cols(); ++v) {
            m_tags.emplace_back(int32("a node's number"), static_cast<int>(v));
            m_file.points.col(v) = point();
        }
        sortTags();
    }
    void readNodes4() {
        const int blocks = count64("blocks of nodes", 4, Scalar::Int32);
        startNodes(count64("nodes", 4, Scalar::Int32));
        m_numbers.integer(Scalar::UInt64, "the smallest node number");
        m_numbers.integer(Scalar::UInt64, "the largest node number");
        int v = 0;
        for (int b = 0; b < blocks; ++b) v = readNodeBlock(v);
        if (v != m_file.points.cols())
            m_scanner.fail("the blocks hold " + std::to_string(v) + " nodes instead of " +
                           std::to_string(m_file.points.cols()));
        sortTags();
    }
    int readNodeBlock(int v) {
        const int dimension = int32("a dimension");
        int32("an entity");
        const bool parametric = int32("0 or 1 for parameters") != 0;
        if (dimension < 0 || dimension > 3) m_scanner.fail("an entity's dimension is 0 to 3");
        const int count = count64("nodes in a block", 4, Scalar::Int32);
        if (count > m_file.points.cols() - v)
            m_scanner.fail("the blocks hold more nodes than the section says");
        for (int k = 0; k < count; ++k)
            m_tags.emplace_back(m_numbers.integer(Scalar::UInt64, "a node's number"), v + k);
        for (int k = 0; k < count; ++k) {
            m_file.points.col(v + k) = point();
            for (int u = 0; parametric && u < dimension; ++u) m_numbers.real(Scalar::Float64, "a parameter");
        }
        return v + count;
    }
    void sortTags() {
        std::sort(m_tags.begin(), m_tags.end());
        const auto twice = std::adjacent_find(m_tags.begin(), m_tags.end(),
                                              [](auto& a, auto& b) { return a.first == b.first; });
        if (twice != m_tags.end())
            m_scanner.fail("there are two nodes of number " + std::to_string(twice->first));
    }
    int corner(Scalar type) {
        const auto tag = m_numbers.integer(type, "a node's number");
        const auto at = std::lower_bound(m_tags.begin(), m_tags.end(), std::pair(tag, -1));
        if (at == m_tags.end() || at->first != tag)
            m_scanner.fail("there is no node of number " + std::to_string(tag));
        return at->second;
    }

    const ElementType& elementType(int number) {
        for (const auto& type : elementTypes)
            if (type.number == number) return type;
        for (const auto& [unread, name] : unreadTypes)
            if (unread == number)
                m_scanner.fail(std::string("a ") + name + ": only triangles and tetrahedra are read");
        m_scanner.fail("element type " + std::to_string(number) + ": only triangles and tetrahedra are read");
    }
    void readCell(const ElementType& type, Scalar cornerType, int physical, int entity) {
        if (!m_hasNodes) m_scanner.fail("the elements stand before the nodes");
        std::array<int, 4> corners{};
        for (int k = 0; k < type.nodes; ++k) corners[k] = corner(cornerType);
        if (type.number != 2 && type.number != 3 && type.number != 4) return;
        const int element = static_cast<int>(m_physical.size());
        m_physical.push_back(physical);
        m_entity.push_back(entity);
        m_dimensions.push_back(type.number == 4 ? 3 : 2);
        if (type.number == 4)
            m_cells.tetrahedron(corners, element);
        else
            m_cells.polygon(std::span(corners.data(), type.nodes), element);
    }
    void readTagsAndCell(const ElementType& type, int tagCount) {
        int tags[2] = {0, 0};
        for (int k = 0; k < tagCount; ++k) {
            const int tag = int32("a tag");
            if (k < 2) tags[k] = tag;
        }
        readCell(type, Scalar::Int32, tags[0], tags[1]);
    }
    void readElements2() {
        const int count = count2("elements", 8);
        for (int read = 0; read < count;) {
            if (!m_binary) {
                int32("an element's number");
                const auto& type = elementType(int32("an element type"));
                readTagsAndCell(type, m_numbers.count(Scalar::Int32, "tags", 1, Scalar::Int32));
                ++read;
                continue;
            }
            const auto& type = elementType(int32("an element type"));
            const int following = int32("a number of elements");
            const int tagCount = m_numbers.count(Scalar::Int32, "tags", 1, Scalar::Int32);
            if (following < 1 || following > count - read)
                m_scanner.fail("more elements follow than the section says");
            for (int k = 0; k < following; ++k, ++read) {
                int32("an element's number");
                readTagsAndCell(type, tagCount);
            }
        }
    }
    void readElements4() {
        const int blocks = count64("blocks of elements", 4, Scalar::Int32);
        const int count = count64("elements", 2, Scalar::Int32);
        m_numbers.integer(Scalar::UInt64, "the smallest element number");
        m_numbers.integer(Scalar::UInt64, "the largest element number");
        int read = 0;
        for (int b = 0; b < blocks; ++b) {
            const int dimension = int32("a dimension"), entity = int32("an entity");
            const auto& type = elementType(int32("an element type"));
            const int inBlock = count64("elements in a block", 2, Scalar::Int32);
            if (inBlock > count - read) m_scanner.fail("the blocks hold more elements than the section says");
            const auto physical = m_physicalOf.find({dimension, entity});
            for (int k = 0; k < inBlock; ++k, ++read) {
                m_numbers.integer(Scalar::UInt64, "an element's number");
                readCell(type, Scalar::UInt64, physical == m_physicalOf.end() ? 0 : physical->second, entity);
            }
        }
        if (read != count) m_scanner.fail("the blocks hold fewer elements than the section says");
    }

    void readEntities() {
        if (!m_version4) m_scanner.fail("a file of version 2 has no $Entities");
        int counts[4];
        for (int& count : counts) count = count64("entities", 4, Scalar::Int32);
        for (int dimension = 0; dimension < 4; ++dimension)
            for (int e = 0; e < counts[dimension]; ++e) readEntity(dimension);
    }
    void readEntity(int dimension) {
        const int tag = int32("an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) m_numbers.real(Scalar::Float64, "a bound");
        const int physicalCount = count64("physical tags", 1, Scalar::Int32);
        for (int k = 0; k < physicalCount; ++k) {
            const int physical = int32("a physical tag");
            if (k == 0) m_physicalOf[{dimension, tag}] = physical;
        }
        if (dimension == 0) return;
        const int boundaries = count64("bounding entities", 1, Scalar::Int32);
        for (int k = 0; k < boundaries; ++k) int32("a bounding entity");
    }

    Scanner m_scanner;
    bool m_version4 = true, m_binary = false, m_hasNodes = false;
    NumberReader m_numbers{m_scanner, false, std::endian::native};
    MeshFile m_file;
    CellCollector m_cells;
    std::vector<std::pair<std::int64_t, int>> m_tags;   // node number → vertex, sorted
    std::map<std::pair<int, int>, int> m_physicalOf;    // (dimension, entity) → its first physical tag
    std::vector<double> m_physical, m_entity;           // per element kept
    std::vector<int> m_dimensions;                      // … and its dimension
    std::map<std::array<int, 2>, std::string> m_names;  // of physical groups: (dimension, tag)
};

}  // namespace

MeshFile readGmsh(std::span<const MeshSource> files) {
    return GmshReader(files[0].bytes).read();
}

}  // namespace wend::formats
