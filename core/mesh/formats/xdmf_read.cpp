// XDMF files are XML that describes grids; their numbers are in it, in raw files beside it, or in HDF5 files.

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <pugixml.hpp>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/xdmf.h"
#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend::formats {
namespace {

namespace fs = std::filesystem;

/// Returns a text without the blanks and line ends around it.
std::string_view bare(std::string_view text) {
    constexpr const char* kBlanks = " \t\r\n";
    const auto first = text.find_first_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The numbers of a <DataItem>.
struct Item {
    std::vector<double> values;
    std::vector<std::int64_t> shape;
    Scalar type = Scalar::Float32;

    /// Returns how many numbers are in a row.
    std::size_t width() const {
        std::size_t width = 1;
        for (std::size_t k = 1; k < shape.size(); ++k) width *= static_cast<std::size_t>(shape[k]);
        return width;
    }
};

class XdmfReader {
  public:
    explicit XdmfReader(const MeshSource& source) : m_folder(fs::path(source.path).parent_path()) {
        const auto result = m_document.load_buffer(source.bytes.data(), source.bytes.size());
        if (!result) throw InputError(std::string("not valid XML: ") + result.description());
    }

    MeshFile read() {
        const auto grid = chosenGrid(m_document.child("Xdmf").child("Domain"));
        readPoints(withOwn(grid, "Geometry"));
        readCells(withOwn(grid, "Topology"));
        for (const auto attribute : grid.children("Attribute")) readField(attribute);
        readNames(grid);
        addGroupsOfFields(m_file);
        readSets(grid);
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    [[noreturn]] static void fail(pugi::xml_node node, const std::string& what) {
        const std::string name = node.attribute("Name").value();
        throw InputError(std::string("<") + node.name() + (name.empty() ? "" : " " + inQuotes(name)) +
                         ">: " + what);
    }
    /// Returns a grid of the domain: of every collection within another, the last of a series in time, the
    /// first of others.
    pugi::xml_node chosenGrid(pugi::xml_node parent) {
        for (;;) {
            pugi::xml_node grid = parent.child("Grid");
            if (!grid) throw InputError("there is no <Grid> in it");
            const auto others =
                std::distance(parent.children("Grid").begin(), parent.children("Grid").end()) - 1;
            const bool isSeries = std::string_view(parent.attribute("CollectionType").value()) == "Temporal";
            if (isSeries)
                grid = parent.find_child([&](pugi::xml_node node) {
                    return std::string_view(node.name()) == "Grid" && !node.next_sibling("Grid");
                });
            if (others > 0)
                m_file.notices.push_back("its " + std::to_string(others) + " other " +
                                         (isSeries ? "step" : "grid") + (others > 1 ? "s" : ""));
            const std::string_view type = grid.attribute("GridType").as_string("Uniform");
            if (type != "Collection" && type != "Tree") return grid;
            parent = grid;
        }
    }
    /// Returns the topology or geometry of a grid, or the first one of the file: series name theirs once.
    pugi::xml_node withOwn(pugi::xml_node grid, const char* name) const {
        pugi::xml_node own = grid.child(name);
        if (!own)
            own = m_document.find_node(
                [&](pugi::xml_node node) { return std::string_view(node.name()) == name; });
        if (!own) fail(grid, std::string("there is no <") + name + "> in it");
        return referenced(own);
    }
    /// Follows a reference to another element.
    pugi::xml_node referenced(pugi::xml_node node) const {
        const std::string reference = node.attribute("Reference").value();
        if (reference.empty()) return node;
        const std::string path = reference == "XML" ? node.text().as_string() : reference;
        try {
            const auto found = m_document.select_node(std::string(bare(path)).c_str()).node();
            if (found && !found.attribute("Reference")) return found;
        } catch (const pugi::xpath_exception&) {
        }
        fail(node, "refers to " + inQuotes(path) + ", which is not there");
    }

    static Scalar scalarOf(pugi::xml_node node) {
        const std::string_view type = node.attribute("DataType")
                                          ? node.attribute("DataType").value()
                                          : node.attribute("NumberType").as_string("Float");
        const int precision = node.attribute("Precision").as_int(type == "Char" || type == "UChar" ? 1 : 4);
        if (type == "Char") return Scalar::Int8;
        if (type == "UChar") return Scalar::UInt8;
        if (type == "Short") return Scalar::Int16;
        if (type == "UShort") return Scalar::UInt16;
        if (type == "Int") return precision == 8 ? Scalar::Int64 : Scalar::Int32;
        if (type == "UInt") return precision == 8 ? Scalar::UInt64 : Scalar::UInt32;
        if (type == "Float") return precision == 8 ? Scalar::Float64 : Scalar::Float32;
        fail(node, "the type " + inQuotes(type) + " is not known");
    }
    Item itemOf(pugi::xml_node parent) {
        const auto node = referenced(parent.child("DataItem"));
        if (!node) fail(parent, "there is no <DataItem> in it");
        if (const std::string_view kind = node.attribute("ItemType").as_string("Uniform"); kind != "Uniform")
            fail(parent, "items of the type " + inQuotes(kind) + " are not read");
        Item item;
        item.type = scalarOf(node);
        std::size_t count = 1;
        for (const std::int64_t extent :
             numbersIn<std::int64_t>(node.attribute("Dimensions").value(), node)) {
            if (extent < 0 || (extent > 0 && count > std::numeric_limits<std::int32_t>::max() *
                                                         std::size_t(64) / static_cast<std::size_t>(extent)))
                fail(parent, "its dimensions make no sense");
            item.shape.push_back(extent);
            count *= static_cast<std::size_t>(extent);
        }
        const std::string_view format = node.attribute("Format").as_string("XML");
        if (format == "HDF")
            readHdf(node, item);
        else if (format == "Binary")
            readBinary(node, count, item);
        else if (format == "XML")
            item.values = numbersIn<double>(node.text().as_string(), node);
        else
            fail(parent, "the format " + inQuotes(format) + " is not known");
        if (item.values.size() != count)
            fail(parent, "has " + std::to_string(item.values.size()) + " numbers where " +
                             std::to_string(count) + " are announced");
        return item;
    }
    template <class T>
    static std::vector<T> numbersIn(std::string_view text, pugi::xml_node node) {
        std::vector<T> numbers;
        constexpr const char* kBlanks = " \t\r\n,";
        for (std::size_t at = text.find_first_not_of(kBlanks); at < text.size();
             at = text.find_first_not_of(kBlanks, at)) {
            const auto end = std::min(text.find_first_of(kBlanks, at), text.size());
            T value{};
            const char* first = text.data() + at + (text[at] == '+' ? 1 : 0);
            const auto read = std::from_chars(first, text.data() + end, value);
            if (read.ptr != text.data() + end || read.ec == std::errc::invalid_argument)
                fail(node, inQuotes(text.substr(at, end - at)) + " is no number");
            numbers.push_back(value);
            at = end;
        }
        return numbers;
    }
    std::string beside(std::string_view name) const {
        return (m_folder / fs::path(std::string(bare(name)))).string();
    }
    /// "file.h5:/path" names a data set.
    void readHdf(pugi::xml_node node, Item& item) {
        const std::string_view text = bare(node.text().as_string());
        const auto colon = text.rfind(":/");
        if (colon == std::string_view::npos) fail(node, inQuotes(text) + " names no data set of a file");
        const std::string path = beside(text.substr(0, colon));
        auto tree = m_trees.find(path);
        try {
            if (tree == m_trees.end()) tree = m_trees.emplace(path, readHdf5(readInput(path))).first;
            const Hdf5Array& data = tree->second.at(text.substr(colon + 2));
            item.values = data.reals();
            item.type = data.type;
        } catch (const InputError& error) {
            throw InputError(error.named(path).what());
        }
    }
    void readBinary(pugi::xml_node node, std::size_t count, Item& item) const {
        const std::string path = beside(node.text().as_string()), bytes = readInput(path);
        const std::size_t size = sizeOf(item.type), seek = node.attribute("Seek").as_ullong(0);
        if (seek > bytes.size() || count > (bytes.size() - seek) / size)
            fail(node, "there are too few bytes in " + inQuotes(path));
        const auto order = std::string_view(node.attribute("Endian").value()) == "Big" ? std::endian::big
                                                                                       : std::endian::little;
        for (std::size_t i = 0; i < count; ++i)
            item.values.push_back(
                decodeReal(std::string_view(bytes).substr(seek + i * size, size), item.type, order));
    }

    void readPoints(pugi::xml_node geometry) {
        const std::string_view type = geometry.attribute("GeometryType")
                                          ? geometry.attribute("GeometryType").value()
                                          : geometry.attribute("Type").as_string("XYZ");
        if (type != "XYZ" && type != "XY") fail(geometry, "the type " + inQuotes(type) + " is not read");
        const Item item = itemOf(geometry);
        const std::size_t width = type == "XY" ? 2 : 3;
        if (item.values.size() % width != 0) fail(geometry, "has no whole points");
        m_file.points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(item.values.size() / width));
        for (std::size_t i = 0; i < item.values.size(); ++i)
            m_file.points(static_cast<Eigen::Index>(i % width), static_cast<Eigen::Index>(i / width)) =
                item.values[i];
    }

    void readCells(pugi::xml_node topology) {
        const std::string_view type = topology.attribute("TopologyType")
                                          ? topology.attribute("TopologyType").value()
                                          : topology.attribute("Type").value();
        if (topology.attribute("NumberOfElements").as_int(-1) == 0) return;
        const Item item = itemOf(topology);
        const auto base = topology.attribute("BaseOffset").as_llong(0);
        std::vector<int> nodes;
        for (const double value : item.values) {
            if (!(std::abs(value) < std::numeric_limits<int>::max()))
                fail(topology, "has a node that is not there");
            nodes.push_back(static_cast<int>(value));
        }
        if (sameWord(type, "Mixed")) return readMixed(topology, nodes, static_cast<int>(base));
        const auto found = std::ranges::find_if(xdmfTopologies(), [&](const XdmfTopology& one) {
            return sameWord(one.name, type) || sameWord(one.other, type);
        });
        if (found == xdmfTopologies().end()) fail(topology, "the type " + inQuotes(type) + " is not read");
        const auto own = static_cast<std::size_t>(std::max(factsOf(found->kind).nodes, 0));
        std::size_t size =
            found->number <= kXdmfPolygon
                ? topology.attribute("NodesPerElement")
                      .as_uint(static_cast<unsigned>(item.shape.size() > 1 ? item.width() : own))
                : own;
        if (size == 0 || nodes.size() % size != 0) fail(topology, "has no whole cells");
        for (std::size_t at = 0; at < nodes.size(); at += size)
            add(topology, found->number, std::span(nodes).subspan(at, size), static_cast<int>(base));
    }
    /// Adds a cell of a topology.
    void add(pugi::xml_node topology, int number, std::span<const int> nodes, int base) {
        std::vector<int> cell;
        for (const int v : nodes) {
            if (v < base || v - base >= m_file.points.cols())
                fail(topology, "cell " + std::to_string(m_file.cells.size()) + " names node " +
                                   std::to_string(v) + ", but there are only " +
                                   std::to_string(m_file.points.cols()));
            cell.push_back(v - base);
        }
        if (number == kXdmfVertex)
            return m_file.cells.add(cell.size() == 1 ? CellKind::Vertex : CellKind::PolyVertex, cell);
        if (number == kXdmfLine && cell.size() >= 2)
            return m_file.cells.add(cell.size() == 2 ? CellKind::Line : CellKind::PolyLine, cell);
        if (number == kXdmfPolygon && cell.size() >= 3) return m_file.cells.addFace(cell);
        const auto found = std::ranges::find(xdmfTopologies(), number, &XdmfTopology::number);
        if (number <= kXdmfPolygon || found == xdmfTopologies().end())
            fail(topology, "cell " + std::to_string(m_file.cells.size()) + " has too few nodes");
        m_file.cells.add(found->kind, cell);
    }
    void readMixed(pugi::xml_node topology, const std::vector<int>& numbers, int base) {
        for (std::size_t at = 0; at < numbers.size();) {
            const int number = numbers[at++];
            const auto found = std::ranges::find(xdmfTopologies(), number, &XdmfTopology::number);
            if (found == xdmfTopologies().end())
                fail(topology, "cells of the number " + std::to_string(number) + " are not read");
            int size = factsOf(found->kind).nodes;
            if (number <= kXdmfPolygon) size = at < numbers.size() ? numbers[at++] : 0;
            if (size < 1 || static_cast<std::size_t>(size) > numbers.size() - at)
                fail(topology, "its last cell is cut off");
            add(topology, number, std::span(numbers).subspan(at, static_cast<std::size_t>(size)), base);
            at += static_cast<std::size_t>(size);
        }
    }

    void readField(pugi::xml_node attribute) {
        const std::string_view centre = attribute.attribute("Center").as_string("Node");
        if (centre != "Node" && centre != "Cell" && centre != "Grid") {
            m_file.notices.push_back("its field " + inQuotes(attribute.attribute("Name").value()) + " of " +
                                     std::string(centre) + "s");
            return;
        }
        Item item = itemOf(attribute);
        const auto count = centre == "Node" ? static_cast<std::size_t>(m_file.points.cols())
                                            : static_cast<std::size_t>(m_file.cells.size());
        std::size_t components = item.width();
        if (centre != "Grid" && (count == 0 || item.values.size() % count != 0))
            fail(attribute, "has " + std::to_string(item.values.size()) + " values for " +
                                std::to_string(count) + (centre == "Node" ? " nodes" : " cells"));
        if (centre != "Grid") components = item.values.size() / count;
        if (components == 0) return;
        MeshField field{attribute.attribute("Name").value(),
                        centre == "Cell",
                        static_cast<int>(components),
                        std::move(item.values),
                        {},
                        item.type};
        (centre == "Grid" ? m_file.fileFields : m_file.fields).push_back(std::move(field));
    }
    /// Makes groups of the field of numbers that belongs to the names in <Information>, as meshio writes
    /// them.
    void readNames(pugi::xml_node grid) {
        const std::string text = grid.child("Information").text().as_string();
        pugi::xml_document names;
        if (text.empty() || !names.load_string(text.c_str())) return;
        std::map<std::pair<int, long>, std::string> known;
        for (const auto map : names.first_child().children("map"))
            known[{map.attribute("dim").as_int(), map.text().as_llong()}] = map.attribute("key").value();
        const MeshField* numbers = cellField(m_file, {kXdmfGroups, "gmsh:physical", "physical", "ref",
                                                      "attribute", "material", "pid", "label"});
        if (!numbers || known.empty()) return;
        addGroups(m_file, numbers->values, [&](int dimension, long tag) {
            const auto name = known.find({dimension, tag});
            return name == known.end() ? std::string() : name->second;
        });
        std::erase_if(m_file.fields,
                      [](const MeshField& field) { return field.perCell && field.name == kXdmfGroups; });
    }
    /// Makes groups of the sets; one with cells of several dimensions becomes a group for each.
    void readSets(pugi::xml_node grid) {
        for (const auto set : grid.children("Set")) {
            const std::string_view type = set.attribute("SetType").as_string("Cell");
            const bool isOfNodes = type == "Node";
            if (!isOfNodes && type != "Cell") {
                m_file.notices.push_back("its set " + inQuotes(set.attribute("Name").value()));
                continue;
            }
            std::map<int, std::vector<int>> members;
            const auto count = isOfNodes ? m_file.points.cols() : m_file.cells.size();
            for (const double value : itemOf(set).values) {
                if (!(value >= 0 && value < static_cast<double>(count)))
                    fail(set, "has a member that is not there");
                const int member = static_cast<int>(value);
                members[isOfNodes ? 0 : m_file.cells.dimension(member)].push_back(member);
            }
            for (auto& [dimension, list] : members) {
                MeshGroup group;
                nameGroup(set.attribute("Name").value(), group);
                group.dimension = dimension;
                std::ranges::sort(list);
                list.erase(std::unique(list.begin(), list.end()), list.end());
                (isOfNodes ? group.vertices : group.cells) = std::move(list);
                m_file.groups.push_back(std::move(group));
            }
        }
    }

    fs::path m_folder;
    pugi::xml_document m_document;
    std::map<std::string, Hdf5Node> m_trees;
    MeshFile m_file;
};

}  // namespace

MeshFile readXdmf(std::span<const MeshSource> files) {
    return XdmfReader(files[0]).read();
}

}  // namespace wend::formats
