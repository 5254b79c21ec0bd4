// Abaqus .inp files consist of keywords with parameters, each followed by lines of data. Nodes, elements and
// sets are read; parts and instances are read only if they are not moved.

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/mesh/formats/abaqus.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

std::string upper(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

/// Splits a line at commas, and removes the blanks around each item.
std::vector<std::string_view> splitAtCommas(std::string_view line) {
    std::vector<std::string_view> items;
    for (std::size_t at = 0; at <= line.size();) {
        const auto end = std::min(line.find(',', at), line.size());
        items.push_back(trimmed(line.substr(at, end - at)));
        at = end + 1;
    }
    if (!items.empty() && items.back().empty()) items.pop_back();
    return items;
}

/// Node or element sets by name, in the order of the file.
struct Sets {
    std::vector<std::pair<std::string, std::vector<std::int64_t>>> all;

    std::vector<std::int64_t>& named(std::string_view name) {
        for (auto& [known, members] : all)
            if (sameWord(known, name)) return members;
        return all.emplace_back(std::string(name), std::vector<std::int64_t>()).second;
    }
    const std::vector<std::int64_t>* find(std::string_view name) const {
        for (const auto& [known, members] : all)
            if (sameWord(known, name)) return &members;
        return nullptr;
    }
};

class AbaqusReader {
  public:
    explicit AbaqusReader(std::string_view bytes) : m_scanner(bytes) {}

    /// Reads all lines, and then resolves the numbers of nodes and elements, which may be defined after their
    /// use.
    MeshFile read() {
        while (nextLine()) {
            if (m_line.starts_with('*'))
                keyword();
            else
                data();
        }
        finishElement();
        m_file.points =
            Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3, static_cast<Eigen::Index>(m_nodes.size()));
        addCells();
        addSets();
        for (const auto& [type, count] : m_noCells)
            m_file.notices.push_back(std::to_string(count) + (count == 1 ? " element" : " elements") +
                                     " of the type " + type);
        if (!m_passed.empty()) m_file.notices.push_back("its keywords " + m_passed);
        finishCells(m_file, [this](int cell) {
            return m_scanner.placeOf(m_elements[static_cast<std::size_t>(cell)].offset);
        });
        m_file.deck = std::make_shared<const std::string>(m_scanner.bytes());
        m_file.deckFormat = ".inp";
        return std::move(m_file);
    }

  private:
    enum class Data { Other, Nodes, Elements, NodeSet, ElementSet, Instance };
    struct Element {
        std::int64_t number;
        CellKind kind;
        std::size_t offset, first;  // of its nodes in m_corners
    };

    /// Takes the next line that is no comment; a keyword's line continues after a comma.
    bool nextLine() {
        while (m_scanner.remaining() > 0) {
            m_offset = m_scanner.offset();
            m_line = std::string(trimmed(m_scanner.line()));
            if (m_line.empty() || m_line.starts_with("**")) continue;
            while (m_line.starts_with('*') && m_line.ends_with(',') && m_scanner.remaining() > 0)
                m_line += std::string(trimmed(m_scanner.line()));
            return true;
        }
        return false;
    }
    [[noreturn]] void fail(const std::string& what) {
        m_scanner.mark(m_offset);
        m_scanner.fail(what);
    }
    std::int64_t whole(std::string_view word, const char* what) {
        m_scanner.mark(m_offset);
        return m_scanner.integerFrom(word, what);
    }
    double real(std::string_view word, const char* what) {
        m_scanner.mark(m_offset);
        std::string number(word);  // Fortran writes exponents with a D
        std::ranges::replace(number, 'D', 'E');
        std::ranges::replace(number, 'd', 'e');
        const double value = m_scanner.realFrom(number, what);
        if (!std::isfinite(value)) fail(inQuotes(word) + " is not a finite number");
        return value;
    }
    /// Returns a parameter of the keyword, without quotes.
    std::string parameter(std::string_view wanted) const {
        for (const auto item : m_items) {
            const auto equals = item.find('=');
            if (equals == std::string_view::npos || !sameWord(trimmed(item.substr(0, equals)), wanted))
                continue;
            auto value = trimmed(item.substr(equals + 1));
            if (value.size() > 1 && value.front() == '"' && value.back() == '"')
                value = value.substr(1, value.size() - 2);
            return std::string(value);
        }
        return {};
    }
    bool hasFlag(std::string_view wanted) const {
        return std::ranges::any_of(m_items, [&](auto item) { return sameWord(item, wanted); });
    }

    /// Handles a line with a keyword, which determines how the following lines of data are read.
    void keyword() {
        finishElement();
        m_keyword = m_line;  // that the items are parts of
        m_items = splitAtCommas(m_keyword);
        const std::string name = upper(m_items[0].substr(1));
        m_data = Data::Other;
        if (name == "NODE") {
            m_data = Data::Nodes;
            m_set = parameter("NSET");
        } else if (name == "ELEMENT") {
            beginElements();
        } else if (name == "NSET" || name == "ELSET") {
            m_data = name == "NSET" ? Data::NodeSet : Data::ElementSet;
            m_set = parameter(name);
            if (m_set.empty()) fail("a set without a name");
            m_generate = hasFlag("GENERATE");
        } else if (name == "INSTANCE") {
            if (++m_instances > 1) fail("a second *INSTANCE: only one is read");
            m_data = Data::Instance;
        } else if (name == "INCLUDE") {
            fail("*INCLUDE: only what stands in the file itself is read");
        } else if (name != "HEADING" && name != "PART" && name != "END PART" && name != "ASSEMBLY" &&
                   name != "END ASSEMBLY" && name != "END INSTANCE" &&
                   m_passed.find("*" + name) == std::string::npos) {
            m_passed += (m_passed.empty() ? "*" : ", *") + name;
        }
    }
    void beginElements() {
        const std::string type = parameter("TYPE");
        if (type.empty()) fail("*ELEMENT without a TYPE");
        m_set = parameter("ELSET");
        m_type = upper(type);
        m_kind = abaqusKind(type);
        m_data = Data::Elements;
    }
    void data() {
        m_items = splitAtCommas(m_line);
        if (m_data == Data::Nodes) return node();
        if (m_data == Data::Elements) return element();
        if (m_data == Data::NodeSet) return addTo(m_nodeSets);
        if (m_data == Data::ElementSet) return addTo(m_elementSets);
        if (m_data == Data::Instance) fail("*INSTANCE: parts that are moved to their place are not read");
    }
    /// Adds a node with two or three coordinates. A number may be used once only.
    void node() {
        if (m_items.size() < 3) fail("a node has a number and two or three coordinates");
        const auto number = whole(m_items[0], "a node's number");
        if (!m_nodes.emplace(number, static_cast<int>(m_nodes.size())).second)
            fail("there are two nodes of number " + std::to_string(number));
        for (std::size_t k = 1; k <= 3; ++k) {
            const double x = k < m_items.size() && !m_items[k].empty() ? real(m_items[k], "a coordinate") : 0;
            m_points.push_back(x);
        }
        if (!m_set.empty()) m_nodeSets.named(m_set).push_back(number);
    }
    /// Reads an element, whose nodes may continue on several lines.
    void element() {
        std::size_t k = 0;
        if (m_missing == 0) {
            const auto number = whole(m_items[k++], "an element's number");
            if (!m_kind) {
                ++m_noCells[m_type];
                return;
            }
            m_elements.push_back({number, *m_kind, m_offset, m_corners.size()});
            if (!m_set.empty()) m_elementSets.named(m_set).push_back(number);
            m_missing = static_cast<std::size_t>(factsOf(*m_kind).nodes);
        }
        for (; k < m_items.size() && m_missing > 0; ++k, --m_missing)
            m_corners.push_back(whole(m_items[k], "a node's number"));
        if (k < m_items.size() && m_missing == 0 && factsOf(*m_kind).dimension > 1)
            fail("more nodes than an element of the type " + m_type + " has");
    }
    void finishElement() {
        if (m_missing > 0) fail("the element before has too few nodes");
    }
    /// Adds the members of a line to a set: listed ones, or a range with a step if the set is generated.
    void addTo(Sets& sets) {
        auto members = sets.named(m_set);
        if (m_generate) {
            if (m_items.size() < 2) fail("a set that is generated needs a first and a last number");
            const auto first = whole(m_items[0], "a first number"), last = whole(m_items[1], "a last number"),
                       step = m_items.size() > 2 ? whole(m_items[2], "a step") : 1;
            if (step < 1 || (last - first) / step > 100000000) fail("the numbers of the set make no sense");
            for (auto number = first; number <= last; number += step) members.push_back(number);
        } else {
            for (const auto item : m_items) addItem(item, sets, members);
        }
        sets.named(m_set) = std::move(members);
    }
    /// Adds a number, or the members of an earlier set by its name.
    void addItem(std::string_view item, const Sets& sets, std::vector<std::int64_t>& members) {
        if (const auto* other = sets.find(item)) {
            members.insert(members.end(), other->begin(), other->end());
        } else if (!item.empty()) {
            members.push_back(whole(item, "a number or the name of a set"));
        }
    }

    /// Makes cells of the elements, with the indices of their nodes. Fails at an element with an unknown
    /// node.
    void addCells() {
        std::vector<int> nodes;
        for (const Element& one : m_elements) {
            nodes.clear();
            for (int k = 0; k < factsOf(one.kind).nodes; ++k) {
                const auto number = m_corners[one.first + static_cast<std::size_t>(k)];
                const auto found = m_nodes.find(number);
                if (found == m_nodes.end()) {
                    m_offset = one.offset;
                    fail("there is no node of number " + std::to_string(number));
                }
                nodes.push_back(found->second);
            }
            m_file.cells.add(one.kind, nodes);
        }
    }
    /// Makes groups of the sets. An element set with cells of several dimensions becomes one group for each.
    void addSets() {
        std::unordered_map<std::int64_t, int> cells;
        for (std::size_t c = 0; c < m_elements.size(); ++c)
            cells.emplace(m_elements[c].number, static_cast<int>(c));
        for (const auto& [name, members] : m_elementSets.all) {
            std::map<int, std::vector<int>> byDimension;
            for (const auto number : members)
                if (const auto found = cells.find(number); found != cells.end())
                    byDimension[m_file.cells.dimension(found->second)].push_back(found->second);
            if (byDimension.empty()) m_file.notices.push_back("its empty set " + inQuotes(name));
            for (auto& [dimension, list] : byDimension)
                addGroup({name, dimension, 0, std::move(list), {}, false});
        }
        for (const auto& [name, members] : m_nodeSets.all) {
            MeshGroup group{name, 0, 0, {}, {}, false};
            for (const auto number : members)
                if (const auto found = m_nodes.find(number); found != m_nodes.end())
                    group.vertices.push_back(found->second);
            if (group.vertices.empty()) m_file.notices.push_back("its empty set " + inQuotes(name));
            if (!group.vertices.empty()) addGroup(std::move(group));
        }
    }
    void addGroup(MeshGroup group) {
        for (auto* list : {&group.cells, &group.vertices}) {
            std::ranges::sort(*list);
            list->erase(std::unique(list->begin(), list->end()), list->end());
        }
        m_file.groups.push_back(std::move(group));
    }

    Scanner m_scanner;
    MeshFile m_file;
    std::string m_line, m_keyword;
    std::size_t m_offset = 0;  // of the line
    std::vector<std::string_view> m_items;
    Data m_data = Data::Other;
    std::string m_set, m_type;
    std::optional<CellKind> m_kind;
    bool m_generate = false;
    int m_instances = 0;
    std::size_t m_missing = 0;  // nodes of the element that is being read
    std::vector<double> m_points;
    std::unordered_map<std::int64_t, int> m_nodes;
    std::vector<Element> m_elements;
    std::vector<std::int64_t> m_corners;
    Sets m_nodeSets, m_elementSets;
    std::map<std::string, int> m_noCells;
    std::string m_passed;
};

}  // namespace

MeshFile readAbaqus(std::span<const MeshSource> files) {
    return AbaqusReader(files[0].bytes).read();
}

}  // namespace wend::formats
