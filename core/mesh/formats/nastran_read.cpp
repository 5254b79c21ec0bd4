// Nastran bulk data (.bdf, .nas): fields of 8 or 16 characters, or between commas. Nodes and elements are
// read; the property of an element becomes the field "pid" and a group.

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/nastran.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

std::string_view withoutComment(std::string_view line) {
    return line.substr(0, line.find('$'));
}

/// Returns the name and fields of one line.
std::vector<std::string> cardFields(std::string_view line) {
    std::vector<std::string> fields;
    if (line.find(',') != std::string_view::npos) {
        for (std::size_t at = 0; at <= line.size();) {
            const auto end = std::min(line.find(',', at), line.size());
            fields.emplace_back(trimmed(line.substr(at, end - at)));
            at = end + 1;
        }
    } else {
        fields.emplace_back(trimmed(line.substr(0, 8)));
        const std::size_t width = fields[0].find('*') != std::string::npos ? 16 : 8;
        for (std::size_t at = 8; at < 72 && at < line.size(); at += width)
            fields.emplace_back(trimmed(line.substr(at, std::min(width, 72 - at))));
    }
    const std::size_t most = fields[0].find('*') != std::string::npos ? 5 : 9;
    fields.resize(most);
    return fields;
}

class NastranReader {
  public:
    explicit NastranReader(std::string_view bytes) : m_scanner(bytes) {}

    /// Reads all entries, and then resolves the numbers of nodes, which may be defined after their use.
    MeshFile read() {
        for (std::size_t at = 0; at < m_scanner.bytes().size();) {
            const NastranCard card = takeNastranCard(m_scanner.bytes(), at);
            m_scanner.mark(card.begin);
            if (card.name == "ENDDATA") break;
            if (card.name == "INCLUDE")
                m_scanner.fail("INCLUDE: only what stands in the file itself is read");
            if (card.name == "GRID") grid(card);
            const auto element = std::ranges::find(nastranElements(), card.name, &NastranElement::name);
            if (element != nastranElements().end()) elements(card, element->name);
        }
        m_file.points =
            Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3, static_cast<Eigen::Index>(m_nodes.size()));
        addCells();
        addGroups(m_file, m_properties);
        m_file.fields.push_back({"pid", true, 1, m_properties, {}, Scalar::Int32});
        m_file.notices.push_back("all that is no mesh");
        m_file.deck = std::make_shared<const std::string>(m_scanner.bytes());
        m_file.deckFormat = ".bdf";
        finishCells(m_file, [this](int cell) {
            return m_scanner.placeOf(m_elements[static_cast<std::size_t>(cell)].offset);
        });
        return std::move(m_file);
    }

  private:
    struct Element {
        std::string_view name;
        std::vector<std::int64_t> nodes;
        std::size_t offset;
    };

    std::string field(const NastranCard& card, std::size_t k) const {
        return k < card.fields.size() ? card.fields[k] : std::string();
    }
    /// "1.5-3" is 0.0015, and so is "1.5D-3".
    double real(const std::string& text) const {
        std::string number;
        for (std::size_t k = 0; k < text.size(); ++k) {
            const char c = text[k] == 'D' || text[k] == 'd' ? 'e' : text[k];
            const bool sign = (c == '-' || c == '+') && k > 0 && number.back() != 'e' && number.back() != 'E';
            if (sign) number += 'e';
            number += c;
        }
        const double value = number.empty() ? 0 : m_scanner.realFrom(number, "a coordinate");
        if (!std::isfinite(value)) m_scanner.fail(inQuotes(text) + " is not a finite number");
        return value;
    }
    /// Reads a GRID entry. Only the basic coordinate system is accepted.
    void grid(const NastranCard& card) {
        const auto number = m_scanner.integerFrom(field(card, 0), "a node's number");
        const std::string system = field(card, 1);
        if (!system.empty() && system != "0")
            m_scanner.fail("node " + std::to_string(number) + " is in the coordinate system " +
                           inQuotes(system) + "; only the basic one is read");
        if (!m_nodes.emplace(number, static_cast<int>(m_nodes.size())).second)
            m_scanner.fail("there are two nodes of number " + std::to_string(number));
        for (std::size_t k = 2; k < 5; ++k) m_points.push_back(real(field(card, k)));
    }
    /// Reads the entry of an element with its property and its nodes.
    void elements(const NastranCard& card, std::string_view name) {
        const bool plain = name == "PLOTEL" || name == "CONROD";  // without a property
        const std::string property = plain ? std::string() : field(card, 1);
        m_properties.push_back(
            property.empty() ? 0 : static_cast<double>(m_scanner.integerFrom(property, "a property")));
        Element element{name, {}, card.begin};
        std::size_t most = 0;
        for (const auto& one : nastranElements())
            if (one.name == name) most = std::max(most, static_cast<std::size_t>(factsOf(one.kind).nodes));
        for (std::size_t k = plain ? 1 : 2; element.nodes.size() < most && !field(card, k).empty(); ++k)
            element.nodes.push_back(m_scanner.integerFrom(field(card, k), "a node's number"));
        m_elements.push_back(std::move(element));
    }
    /// Makes cells of the elements whose name and number of nodes are those of a known element.
    void addCells() {
        for (const Element& one : m_elements) {
            m_scanner.mark(one.offset);
            const auto kind = std::ranges::find_if(nastranElements(), [&](const NastranElement& element) {
                return element.name == one.name &&
                       static_cast<std::size_t>(factsOf(element.kind).nodes) == one.nodes.size();
            });
            if (kind == nastranElements().end())
                m_scanner.fail("a " + std::string(one.name) + " of " + std::to_string(one.nodes.size()) +
                               " nodes is not read");
            std::vector<int> nodes;
            for (std::size_t k = 0; k < one.nodes.size(); ++k) {
                const auto number =
                    one.nodes[kind->order.empty() ? k : static_cast<std::size_t>(kind->order[k])];
                const auto found = m_nodes.find(number);
                if (found == m_nodes.end())
                    m_scanner.fail("there is no node of number " + std::to_string(number));
                nodes.push_back(found->second);
            }
            m_file.cells.add(kind->kind, nodes);
        }
    }

    Scanner m_scanner;
    MeshFile m_file;
    std::vector<double> m_points, m_properties;
    std::unordered_map<std::int64_t, int> m_nodes;
    std::vector<Element> m_elements;
};

}  // namespace

/// Reads an entry with its continuation lines, in fields of 8 characters, of 16 with an asterisk, or
/// separated by commas.
NastranCard takeNastranCard(std::string_view bytes, std::size_t& at) {
    NastranCard card{{}, {}, at, at};
    for (bool first = true; at < bytes.size(); first = false) {
        const auto end = std::min(bytes.find('\n', at), bytes.size());
        const std::string_view whole = bytes.substr(at, end - at), line = withoutComment(whole);
        const bool empty = trimmed(line).empty();
        if (empty && first) {
            at = card.end = std::min(end + 1, bytes.size());
            return card;
        }
        const auto fields = cardFields(line);
        const bool continues = !empty && (fields[0].empty() || fields[0][0] == '+' || fields[0][0] == '*');
        if (!first && !continues) {
            if (!(empty && whole.find('$') != std::string_view::npos)) return card;
            at = std::min(end + 1, bytes.size());  // a comment within; it belongs to what follows
            continue;
        }
        if (first) {
            for (const char c : fields[0])
                if (c != '*') card.name += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
        }
        card.fields.insert(card.fields.end(), fields.begin() + 1, fields.end());
        at = card.end = std::min(end + 1, bytes.size());
    }
    return card;
}

MeshFile readNastran(std::span<const MeshSource> files) {
    return NastranReader(files[0].bytes).read();
}

}  // namespace wend::formats
