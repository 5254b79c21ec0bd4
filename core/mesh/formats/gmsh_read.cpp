// Gmsh .msh, versions 2.2, 4.0 and 4.1, text and binary. Physical groups become groups; physical and entity
// tags, and of partitioned files the partition, fields of the cells; $NodeData and $ElementData fields, too.

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/gmsh_elements.h"
#include "core/mesh/formats/gmsh_groups.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

/// The properties that elements get from an entity of the model.
struct Entity {
    int number = 0;     // of the entity that was cut into partitions, or its own
    int partition = 0;  // 0: the file is whole
    std::vector<int> physical;
};

class GmshReader {
  public:
    explicit GmshReader(std::string_view bytes) : m_scanner(bytes) {}

    /// Reads all sections, and then makes groups and fields of the tags.
    MeshFile read() {
        readFormat();
        while (!m_scanner.atEnd()) section();
        if (!m_hasNodes) m_scanner.fail("there is no section $Nodes");
        if (m_version == 2) mergeRepeated();
        for (const int dimension : {0, 1, 2, 3}) ungroupTheRest(dimension);
        takeTags();
        takeGroups();
        finishCells(m_file, [this](int cell) {
            return "element " + std::to_string(m_elements[static_cast<std::size_t>(cell)].number);
        });
        return std::move(m_file);
    }

  private:
    /// Reads the version and the encoding. Throws for versions other than 2.2, 4, 4.0 and 4.1.
    void readFormat() {
        if (m_scanner.word("$MeshFormat") != "$MeshFormat")
            m_scanner.fail("does not begin with $MeshFormat: no Gmsh file of version 2.2 or 4.1");
        const auto version = m_scanner.word("the version");
        m_version = version == "4.1"                     ? 41
                    : version == "4" || version == "4.0" ? 40
                    : version.starts_with('2')           ? 2
                                                         : 0;
        if (m_version == 0)
            m_scanner.fail("version " + inQuotes(version) + " is not read; save the mesh as 4.1 or 2.2");
        const auto fileType = m_scanner.integer("0 or 1 for text or binary");
        const auto dataSize = m_scanner.integer("the size of a number");
        m_binary = fileType != 0;
        if (m_binary && m_version == 40)
            m_scanner.fail("a binary file of version 4.0 is not read; save it as 4.1");
        if (m_binary && dataSize != 8) m_scanner.fail("only numbers of 8 bytes are read");
        m_scanner.line();
        if (m_binary) findOrder();
        endSection("$EndMeshFormat");
    }
    /// Finds the byte order: binary files hold the number 1 here.
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
    /// Reads a section by its name; unknown sections are skipped up to their end.
    void section() {
        const std::string name(m_scanner.word("a section"));
        if (name.size() < 2 || name[0] != '$')
            m_scanner.fail(inQuotes(name) + " where a section is expected");
        const std::string end = "$End" + name.substr(1);
        if (name == "$PhysicalNames") return readNames(end);
        if (name == "$NodeData" || name == "$ElementData") return readData(name == "$ElementData", end);
        if (name != "$Nodes" && name != "$Elements" && name != "$Entities" && name != "$PartitionedEntities")
            return passOver(name, end);
        m_scanner.line();
        if (name == "$Entities" || name == "$PartitionedEntities")
            readEntities(name == "$PartitionedEntities");
        else if (name == "$Nodes")
            m_version == 2 ? readNodes2() : readNodes4();
        else
            m_version == 2 ? readElements2() : readElements4();
        endSection(end);
    }
    /// Reads the names of physical groups, which belong to a dimension and a number each.
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
            if (tag > 0 && tag <= 2147483647)
                m_names[{static_cast<int>(dimension), static_cast<int>(tag)}] =
                    name.substr(first + 1, last - first - 1);
        }
        endSection(end);
    }
    /// Merges repeated elements, because version 2 lists an element once for each of its physical groups.
    void mergeRepeated() {
        std::vector<int> order(m_elements.size());
        std::iota(order.begin(), order.end(), 0);
        const CellList& cells = m_file.cells;
        const auto before = [&](int a, int b) {
            const auto x = cells[a], y = cells[b];
            return std::ranges::lexicographical_compare(x, y);
        };
        std::ranges::stable_sort(order, before);
        std::vector<bool> again(order.size(), false);
        for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
            if (before(order[first], order[i]) || !mergeInto(order[first], order[i])) {
                first = i;
                continue;
            }
            again[static_cast<std::size_t>(order[i])] = true;
        }
        if (std::ranges::count(again, true) > 0) leaveOut(again);
    }
    /// True if the second is the first in another group.
    bool mergeInto(int first, int second) {
        auto& physical = m_elements[static_cast<std::size_t>(first)].physical;
        const auto& more = m_elements[static_cast<std::size_t>(second)].physical;
        if (more.empty() || std::ranges::count(physical, more[0]) > 0) return false;
        physical.push_back(more[0]);
        return true;
    }
    /// Leaves out the marked elements, with their values.
    void leaveOut(const std::vector<bool>& again) {
        CellList cells;
        std::vector<Element> elements;
        for (int c = 0; c < m_file.cells.size(); ++c) {
            if (again[static_cast<std::size_t>(c)]) continue;
            cells.add(m_file.cells.kinds[static_cast<std::size_t>(c)], m_file.cells[c]);
            elements.push_back(std::move(m_elements[static_cast<std::size_t>(c)]));
        }
        for (MeshField& field : m_file.fields) {
            if (!field.perCell) continue;
            std::vector<double> kept;
            for (std::size_t c = 0; c < again.size(); ++c)
                for (int k = 0; !again[c] && k < field.components; ++k)
                    kept.push_back(field.values[c * static_cast<std::size_t>(field.components) + k]);
            field.values = std::move(kept);
        }
        m_file.cells = std::move(cells);
        m_elements = std::move(elements);
    }
    /// The group that GmshGroups gives to what has no tag.
    void ungroupTheRest(int dimension) {
        int maximum = 0, before = 0;
        const auto each = [&](const auto& use) {
            for (std::size_t e = 0; e < m_elements.size(); ++e)
                if (m_file.cells.dimension(static_cast<int>(e)) == dimension)
                    for (const int tag : m_elements[e].physical) use(tag);
        };
        each([&](int tag) { maximum = std::max(maximum, tag); });
        each([&](int tag) { before = tag < maximum ? std::max(before, tag) : before; });
        const bool volume =
            std::ranges::any_of(m_file.cells.kinds, [](auto kind) { return factsOf(kind).dimension == 3; });
        const auto name = m_names.find({dimension, maximum});
        if (name == m_names.end() || name->second != groupOfTheRest(volume, dimension) ||
            maximum != before + 1)
            return;
        for (std::size_t e = 0; e < m_elements.size(); ++e)
            if (m_file.cells.dimension(static_cast<int>(e)) == dimension)
                std::erase(m_elements[e].physical, maximum);
        m_names.erase(name);
    }
    /// Makes fields of the physical groups, entities and partitions of the elements.
    void takeTags() {
        std::vector<double> physical, entity, partition;
        for (const Element& one : m_elements) {
            physical.push_back(one.physical.empty() ? 0 : one.physical[0]);
            entity.push_back(one.entity);
            partition.push_back(one.partition);
        }
        const bool whole = std::ranges::all_of(partition, [](double p) { return p == 0; });
        std::vector<MeshField> tags{{"physical", true, 1, std::move(physical), {}, Scalar::Int32},
                                    {"entity", true, 1, std::move(entity), {}, Scalar::Int32}};
        if (!whole) tags.push_back({"partition", true, 1, std::move(partition), {}, Scalar::Int32});
        m_file.fields.insert(m_file.fields.begin(), tags.begin(), tags.end());
    }
    /// Those with a name that no element has are left out, and named.
    void takeGroups() {
        std::map<std::array<int, 2>, MeshGroup> groups;
        for (std::size_t e = 0; e < m_elements.size(); ++e)
            for (const int tag : m_elements[e].physical)
                groups[{m_file.cells.dimension(static_cast<int>(e)), tag}].cells.push_back(
                    static_cast<int>(e));
        for (auto& [key, group] : groups) {
            group.dimension = key[0];
            group.tag = key[1];
            if (const auto name = m_names.find(key); name != m_names.end()) group.name = name->second;
            m_file.groups.push_back(std::move(group));
        }
        for (const auto& [key, name] : m_names)
            if (!groups.contains(key)) m_file.notices.push_back("its empty group " + inQuotes(name));
    }
    void passOver(const std::string& name, const std::string& end) {
        const auto at = m_scanner.bytes().find("\n" + end, m_scanner.offset());
        if (at == std::string_view::npos) m_scanner.fail("the section is not closed with " + end);
        m_scanner.seek(at + 1 + end.size());
        if (name != "$Comments") m_file.notices.push_back("its section " + name);
    }

    /// Reads the data of a field. The numbers at its head are on lines of their own, in binary files too.
    void readData(bool perCell, const std::string& end) {
        m_scanner.line();
        const int strings = m_scanner.count("string tags", 1);
        m_scanner.line();
        std::string name = "field";
        for (int k = 0; k < strings; ++k) {
            const std::string line(m_scanner.line());
            const auto first = line.find('"'), last = line.rfind('"');
            if (k == 0 && first != std::string::npos && last > first)
                name = line.substr(first + 1, last - first - 1);
        }
        const int reals = m_scanner.count("real tags", 1);
        MeshField field;
        for (int k = 0; k < reals; ++k)
            if (const double tag = m_scanner.real("a real tag"); k == 0) field.time = tag;
        const int integers = m_scanner.count("integer tags", 1);
        std::int64_t tags[3] = {0, 1, 0};  // step, components, rows
        for (int k = 0; k < integers; ++k) {
            const auto tag = m_scanner.integer("an integer tag");
            if (k < 3) tags[k] = tag;
        }
        m_scanner.line();
        if (tags[1] < 1 || tags[1] > 1000) m_scanner.fail("the number of components makes no sense");
        const int rows =
            m_numbers.checkedCount(tags[2], "rows", static_cast<std::size_t>(tags[1]), Scalar::Float64);
        if (!(std::abs(field.time) < 1e300)) field.time = 0;
        field.step = static_cast<int>(std::clamp<std::int64_t>(tags[0], 0, 1000000000));
        field.name = unusedName(name, perCell);
        field.perCell = perCell;
        field.components = static_cast<int>(tags[1]);
        readRows(std::move(field), rows);
        endSection(end);
    }
    /// Steps of time have one name.
    std::string unusedName(const std::string& name, bool perCell) const {
        const auto used = [&](const std::string& wanted) {
            return std::ranges::any_of(m_file.fields, [&](const auto& field) {
                return field.name == wanted && field.perCell == perCell;
            });
        };
        std::string free = name;
        for (int n = 2; used(free); ++n) free = name + " " + std::to_string(n);
        return free;
    }
    /// Reads the values of a field, whose rows name their vertex or element.
    void readRows(MeshField field, int rows) {
        const auto count = field.perCell ? m_elements.size() : static_cast<std::size_t>(m_file.points.cols());
        const auto n = static_cast<std::size_t>(field.components);
        field.values.assign(count * n, std::numeric_limits<double>::quiet_NaN());
        for (int row = 0; row < rows; ++row) {
            const int number = int32(field.perCell ? "an element's number" : "a node's number");
            const int item = field.perCell ? elementOf(number) : nodeOf(number);
            for (std::size_t k = 0; k < n; ++k)
                field.values[static_cast<std::size_t>(item) * n + k] =
                    m_numbers.real(Scalar::Float64, "a value");
        }
        m_file.fields.push_back(std::move(field));
    }
    /// Returns the index of the element with a number.
    int elementOf(int number) {
        if (m_elementTags.size() != m_elements.size()) {
            m_elementTags.clear();
            for (std::size_t e = 0; e < m_elements.size(); ++e)
                m_elementTags.emplace_back(m_elements[e].number, e);
            std::ranges::sort(m_elementTags);
        }
        const auto at = std::ranges::lower_bound(m_elementTags, std::pair(std::int64_t(number), 0));
        if (at == m_elementTags.end() || at->first != number)
            m_scanner.fail("there is no element of number " + std::to_string(number));
        return at->second;
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
    /// Reads the nodes of version 4, in blocks of one entity.
    void readNodes4() {
        const int blocks = count64("blocks of nodes", 3, Scalar::Int32);
        startNodes(count64("nodes", 4, Scalar::Int32));
        if (m_version == 41) {
            m_numbers.integer(Scalar::UInt64, "the smallest node number");
            m_numbers.integer(Scalar::UInt64, "the largest node number");
        }
        int v = 0;
        for (int b = 0; b < blocks; ++b) v = readNodeBlock(v);
        if (v != m_file.points.cols())
            m_scanner.fail("the blocks hold " + std::to_string(v) + " nodes instead of " +
                           std::to_string(m_file.points.cols()));
        sortTags();
    }
    /// Version 4.0 has the entity before the dimension, and each node's number before its point.
    int readNodeBlock(int v) {
        int dimension = int32("a dimension or an entity");
        const int second = int32("an entity or a dimension");
        if (m_version == 40) dimension = second;
        const bool parametric = int32("0 or 1 for parameters") != 0;
        if (dimension < 0 || dimension > 3) m_scanner.fail("an entity's dimension is 0 to 3");
        const int count = count64("nodes in a block", 4, Scalar::Int32);
        if (count > m_file.points.cols() - v)
            m_scanner.fail("the blocks hold more nodes than the section says");
        for (int k = 0; k < count && m_version == 41; ++k)
            m_tags.emplace_back(m_numbers.integer(Scalar::UInt64, "a node's number"), v + k);
        for (int k = 0; k < count; ++k) {
            if (m_version == 40) m_tags.emplace_back(int32("a node's number"), v + k);
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
    int nodeOf(std::int64_t tag) {
        const auto at = std::lower_bound(m_tags.begin(), m_tags.end(), std::pair(tag, -1));
        if (at == m_tags.end() || at->first != tag)
            m_scanner.fail("there is no node of number " + std::to_string(tag));
        return at->second;
    }

    const GmshElement& elementType(int number) {
        const GmshElement* type = gmshElement(number);
        if (!type) m_scanner.fail(unreadGmshElement(number) + " is not read");
        return *type;
    }
    void readCell(const GmshElement& type, Scalar cornerType, std::int64_t number, const Entity& entity) {
        if (!m_hasNodes) m_scanner.fail("the elements stand before the nodes");
        const auto count = static_cast<std::size_t>(factsOf(type.kind).nodes);
        std::vector<int> read(count), nodes(count);
        for (int& v : read) v = nodeOf(m_numbers.integer(cornerType, "a node's number"));
        for (std::size_t k = 0; k < count; ++k)
            nodes[k] = read[type.order.empty() ? k : static_cast<std::size_t>(type.order[k])];
        m_file.cells.add(type.kind, nodes);
        Element element{number, entity.number, entity.partition, entity.physical};
        std::erase(element.physical, 0);
        m_elements.push_back(std::move(element));
    }
    /// Reads the physical group, the entity, possibly a number of partitions with these, and the cell.
    void readTagsAndCell(const GmshElement& type, std::int64_t number, int tagCount) {
        int tags[4] = {0, 0, 0, 0};
        for (int k = 0; k < tagCount; ++k) {
            const int tag = int32("a tag");
            if (k < 4) tags[k] = tag;
        }
        readCell(type, Scalar::Int32, number, {tags[1], tags[2] > 0 ? tags[3] : 0, {std::abs(tags[0])}});
    }
    /// Reads the elements of version 2, each with its own type and tags; in binary files those of one type
    /// form a block.
    void readElements2() {
        const int count = count2("elements", 8);
        for (int read = 0; read < count;) {
            if (!m_binary) {
                const int number = int32("an element's number");
                const auto& type = elementType(int32("an element type"));
                readTagsAndCell(type, number, m_numbers.count(Scalar::Int32, "tags", 1, Scalar::Int32));
                ++read;
                continue;
            }
            const auto& type = elementType(int32("an element type"));
            const int following = int32("a number of elements");
            const int tagCount = m_numbers.count(Scalar::Int32, "tags", 1, Scalar::Int32);
            if (following < 1 || following > count - read)
                m_scanner.fail("more elements follow than the section says");
            for (int k = 0; k < following; ++k, ++read) {
                const int number = int32("an element's number");
                readTagsAndCell(type, number, tagCount);
            }
        }
    }
    /// Reads the elements of version 4, in blocks of one entity and one type.
    void readElements4() {
        const int blocks = count64("blocks of elements", 4, Scalar::Int32);
        const int count = count64("elements", 2, Scalar::Int32);
        if (m_version == 41) {
            m_numbers.integer(Scalar::UInt64, "the smallest element number");
            m_numbers.integer(Scalar::UInt64, "the largest element number");
        }
        int read = 0;
        for (int b = 0; b < blocks; ++b) {
            int dimension = int32("a dimension or an entity"), tag = int32("an entity or a dimension");
            if (m_version == 40) std::swap(dimension, tag);
            const auto& type = elementType(int32("an element type"));
            const int inBlock = count64("elements in a block", 2, Scalar::Int32);
            if (inBlock > count - read) m_scanner.fail("the blocks hold more elements than the section says");
            const auto known = m_entities.find({dimension, tag});
            const Entity entity = known == m_entities.end() ? Entity{tag, 0, {}} : known->second;
            const Scalar numbers = m_version == 41 ? Scalar::UInt64 : Scalar::Int32;
            for (int k = 0; k < inBlock; ++k, ++read)
                readCell(type, numbers, m_numbers.integer(numbers, "an element's number"), entity);
        }
        if (read != count) m_scanner.fail("the blocks hold fewer elements than the section says");
    }

    void readEntities(bool partitioned) {
        if (m_version == 2) m_scanner.fail("a file of version 2 has no $Entities");
        if (partitioned) {
            m_numbers.integer(Scalar::UInt64, "a number of partitions");
            const int ghosts = count64("ghost entities", 2, Scalar::Int32);
            for (int k = 0; k < 2 * ghosts; ++k) int32("a ghost entity");
        }
        int counts[4];
        for (int& count : counts) count = count64("entities", 4, Scalar::Int32);
        for (int dimension = 0; dimension < 4; ++dimension)
            for (int e = 0; e < counts[dimension]; ++e) readEntity(dimension, partitioned);
    }
    /// Reads an entity and its physical groups. An entity of a partition is replaced by its parent.
    void readEntity(int dimension, bool partitioned) {
        Entity entity;
        const int tag = entity.number = int32("an entity");
        if (partitioned) {
            const int parentDimension = int32("a dimension"), parent = int32("an entity");
            if (parentDimension == dimension) entity.number = parent;
            const int partitions = count64("partitions", 1, Scalar::Int32);
            for (int k = 0; k < partitions; ++k) {
                const int partition = int32("a partition");
                if (k == 0) entity.partition = partition;
            }
        }
        const int bounds = dimension == 0 && m_version == 41 ? 3 : 6;
        for (int k = 0; k < bounds; ++k) m_numbers.real(Scalar::Float64, "a bound");
        const int physicalCount = count64("physical tags", 1, Scalar::Int32);
        for (int k = 0; k < physicalCount; ++k) entity.physical.push_back(std::abs(int32("a physical tag")));
        m_entities[{dimension, tag}] = std::move(entity);
        if (dimension == 0) return;
        const int boundaries = count64("bounding entities", 1, Scalar::Int32);
        for (int k = 0; k < boundaries; ++k) int32("a bounding entity");
    }

    struct Element {
        std::int64_t number;
        int entity, partition;
        std::vector<int> physical;
    };

    Scanner m_scanner;
    int m_version = 41;  // 2, 40 or 41
    bool m_binary = false, m_hasNodes = false;
    NumberReader m_numbers{m_scanner, false, std::endian::native};
    MeshFile m_file;
    std::vector<Element> m_elements;                          // as m_file.cells
    std::vector<std::pair<std::int64_t, int>> m_tags;         // node number → vertex, sorted
    std::vector<std::pair<std::int64_t, int>> m_elementTags;  // the same for elements, once it is asked for
    std::map<std::pair<int, int>, Entity> m_entities;         // by dimension and tag
    std::map<std::array<int, 2>, std::string> m_names;        // of physical groups: (dimension, tag)
};

}  // namespace

MeshFile readGmsh(std::span<const MeshSource> files) {
    return GmshReader(files[0].bytes).read();
}

}  // namespace wend::formats
