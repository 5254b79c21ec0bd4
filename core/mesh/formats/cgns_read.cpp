// CGNS files, kept as HDF5: bases with zones, which have points, sections of elements, boundary conditions
// and solutions. The first base is read; structured zones become hexahedra or quadrilaterals.

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/cgns.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend::formats {
namespace {

using Numbers = std::vector<std::int64_t>;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kMostCells = 500000000;

std::string labelOf(const Hdf5Node& node) {
    const Hdf5Array* label = node.attribute("label");
    return label ? label->text() : std::string();
}
std::vector<const Hdf5Node*> childrenOf(const Hdf5Node& node, std::string_view label) {
    std::vector<const Hdf5Node*> found;
    for (const Hdf5Node& child : node.nodes)
        if (child.isGroup && labelOf(child) == label) found.push_back(&child);
    return found;
}
/// Returns the text of a node's data; empty if there is none.
std::string textAt(const Hdf5Node& node, std::string_view path) {
    const Hdf5Node* data = node.find(std::string(path) + "/ data");
    std::string text = data && !data->isGroup ? data->data.text() : std::string();
    while (text.ends_with(' ')) text.pop_back();
    return text;
}

class CgnsReader {
  public:
    explicit CgnsReader(const std::string& bytes) : m_root(readHdf5(bytes)) {}

    MeshFile read() {
        const auto bases = childrenOf(m_root, "CGNSBase_t");
        if (bases.empty()) throw InputError("there is no CGNSBase_t in it: no CGNS file");
        if (bases.size() > 1)
            m_file.notices.push_back("its " + std::to_string(bases.size() - 1) + " other bases");
        const Numbers dimensions = bases[0]->at(" data").integers();
        m_dimension =
            dimensions.empty() ? 3 : static_cast<int>(std::clamp<std::int64_t>(dimensions[0], 1, 3));
        const auto zones = childrenOf(*bases[0], "Zone_t");
        if (zones.empty()) throw InputError("there is no zone in it");
        for (const Hdf5Node* zone : zones) {
            try {
                readZone(*zone, zones.size() > 1);
            } catch (const InputError& error) {
                throw InputError("zone " + inQuotes(zone->name) + ": " + error.reason());
            }
        }
        if (zones.size() > 1)
            m_file.notices.push_back("what joins its " + std::to_string(zones.size()) + " zones");
        m_file.points = Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3,
                                                           static_cast<Eigen::Index>(m_points.size() / 3));
        endFields();
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    void readZone(const Hdf5Node& zone, bool isOneOfMany) {
        m_firstPoint = static_cast<int>(m_points.size() / 3);
        m_firstCell = m_file.cells.size();
        m_cellOf.clear();
        readPoints(zone);
        if (textAt(zone, "ZoneType") == "Structured")
            addGrid(zone.at(" data").integers());
        else
            readSections(zone);
        readGroups(zone);
        for (const Hdf5Node* solution : childrenOf(zone, "FlowSolution_t")) readSolution(*solution);
        if (!isOneOfMany) return;
        MeshGroup group;
        nameGroup(zone.name, group);
        group.dimension = m_dimension;
        for (int c = m_firstCell; c < m_file.cells.size(); ++c)
            if (m_file.cells.dimension(c) == m_dimension) group.cells.push_back(c);
        if (!group.cells.empty()) m_file.groups.push_back(std::move(group));
    }
    int pointCount() const { return static_cast<int>(m_points.size() / 3) - m_firstPoint; }

    void readPoints(const Hdf5Node& zone) {
        const auto grids = childrenOf(zone, "GridCoordinates_t");
        if (grids.empty()) throw InputError("has no coordinates");
        if (grids.size() > 1) m_file.notices.push_back("its coordinates at other times");
        std::array<std::vector<double>, 3> rows;
        for (std::size_t k = 0; k < 3; ++k)
            if (grids[0]->find(std::string("Coordinate") + "XYZ"[k]))
                rows[k] = grids[0]->at(std::string("Coordinate") + "XYZ"[k] + "/ data").reals();
        if (rows[0].empty()) throw InputError("has no Cartesian coordinates");
        for (auto& row : rows) {
            if (row.empty()) row.resize(rows[0].size(), 0.0);
            if (row.size() != rows[0].size()) throw InputError("has coordinates of different numbers");
        }
        for (std::size_t v = 0; v < rows[0].size(); ++v)
            for (const auto& row : rows) m_points.push_back(row[v]);
    }
    int vertex(std::int64_t number) const {
        if (number < 1 || number > pointCount())
            throw InputError("a cell names vertex " + std::to_string(number) + ", but there are only " +
                             std::to_string(pointCount()));
        return m_firstPoint + static_cast<int>(number - 1);
    }

    /// Adds the cells of a structured zone, by its numbers of vertices along each direction.
    void addGrid(const Numbers& sizes) {
        const auto directions = sizes.size() / 3;
        if (sizes.size() % 3 != 0 || directions < 2 || directions > 3)
            throw InputError("has sizes that make no sense");
        std::array<std::int64_t, 3> n{1, 1, 1};
        for (std::size_t k = 0; k < directions; ++k) n[k] = std::clamp<std::int64_t>(sizes[k], 0, kMostCells);
        if (n[0] * n[1] > kMostCells || n[0] * n[1] * n[2] != pointCount())
            throw InputError("has other vertices than its sizes say");
        m_extents = n;
        const auto at = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
            return m_firstPoint + static_cast<int>(i + n[0] * (j + n[1] * k));
        };
        const std::int64_t layers = directions == 3 ? n[2] - 1 : 1;
        for (std::int64_t k = 0; k < layers; ++k)
            for (std::int64_t j = 0; j + 1 < n[1]; ++j)
                for (std::int64_t i = 0; i + 1 < n[0]; ++i) {
                    std::vector<int> cell{at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)};
                    if (directions == 3)
                        for (const int corner : std::vector<int>(cell))
                            cell.push_back(corner + static_cast<int>(n[0] * n[1]));
                    m_file.cells.add(directions == 3 ? CellKind::Hexahedron : CellKind::Quad, cell);
                }
    }

    void readSections(const Hdf5Node& zone) {
        m_extents = {};
        std::map<std::int64_t, const Hdf5Node*> sections;  // by their first element
        for (const Hdf5Node* section : childrenOf(zone, "Elements_t")) {
            const Numbers range = section->at("ElementRange/ data").integers();
            if (range.size() != 2 || range[0] < 1 || range[1] < range[0] ||
                !sections.emplace(range[0], section).second)
                throw InputError("the range of the section " + inQuotes(section->name) + " makes no sense");
        }
        for (const auto& [first, section] : sections) {
            const Numbers type = section->at(" data").integers(),
                          nodes = section->at("ElementConnectivity/ data").integers();
            const int before = m_file.cells.size();
            readSection(*section, type.empty() ? 0 : type[0], nodes);
            for (int c = before; c < m_file.cells.size(); ++c) m_cellOf.emplace(first + c - before, c);
        }
    }
    void readSection(const Hdf5Node& section, std::int64_t number, const Numbers& nodes) {
        for (std::size_t at = 0; at < nodes.size();) {
            const std::int64_t own = number == kCgnsMixed ? nodes[at++] : number;
            const auto type = std::ranges::find(cgnsTypes(), own, &CgnsType::number);
            if (type == cgnsTypes().end())
                throw InputError("the section " + inQuotes(section.name) + " has elements of the type " +
                                 nameOf(own) + ", which are not read");
            const auto size = static_cast<std::size_t>(factsOf(type->kind).nodes);
            if (size > nodes.size() - at)
                throw InputError("the section " + inQuotes(section.name) + " ends within an element");
            std::vector<int> cell(size);
            for (std::size_t k = 0; k < size; ++k)
                cell[k] =
                    vertex(nodes[at + (type->order.empty() ? k : static_cast<std::size_t>(type->order[k]))]);
            m_file.cells.add(type->kind, cell);
            at += size;
        }
    }
    static std::string nameOf(std::int64_t type) {
        if (type == 22) return "NGON_n (polygons)";
        if (type == 23) return "NFACE_n (polyhedra)";
        return std::to_string(type);
    }

    void readGroups(const Hdf5Node& zone) {
        for (const Hdf5Node* all : childrenOf(zone, "ZoneBC_t"))
            for (const Hdf5Node* condition : childrenOf(*all, "BC_t")) readGroup(*condition);
        for (const Hdf5Node* region : childrenOf(zone, "ZoneSubRegion_t")) readGroup(*region);
    }
    /// Reads a list or a range of vertices or elements; one of cells of several dimensions becomes a group
    /// for each.
    void readGroup(const Hdf5Node& node) {
        const bool isOld = node.find("ElementList") || node.find("ElementRange");
        const std::string place = textAt(node, "GridLocation");
        const bool isOfCells = isOld || (!place.empty() && place != "Vertex");
        Numbers members;
        if (const Hdf5Node* list = node.find(isOld ? "ElementList/ data" : "PointList/ data"))
            members = list->data.integers();
        else if (const Hdf5Node* range = node.find(isOld ? "ElementRange/ data" : "PointRange/ data"))
            members = membersOf(range->data.integers(), isOfCells);
        std::string name = node.name;
        if (const std::string whole = textAt(node, "GroupName"); !whole.empty()) name = whole;
        if (members.empty() || (isOfCells && m_extents[0] > 0)) {
            m_file.notices.push_back("its boundary condition " + inQuotes(name));
            return;
        }
        std::map<int, std::vector<int>> byDimension;
        for (const std::int64_t member : members) {
            if (!isOfCells) {
                byDimension[-1].push_back(vertex(member));
            } else if (const auto cell = m_cellOf.find(member); cell != m_cellOf.end()) {
                byDimension[m_file.cells.dimension(cell->second)].push_back(cell->second);
            }
        }
        for (auto& [dimension, list] : byDimension) {
            MeshGroup group;
            nameGroup(name, group);
            group.dimension = std::max(dimension, 0);
            std::ranges::sort(list);
            list.erase(std::unique(list.begin(), list.end()), list.end());
            (dimension < 0 ? group.vertices : group.cells) = std::move(list);
            m_file.groups.push_back(std::move(group));
        }
    }
    /// Returns the members of a range: numbers, or the vertices of a block of a structured zone.
    Numbers membersOf(const Numbers& range, bool isOfCells) const {
        Numbers members;
        const std::size_t directions = range.size() / 2;
        if (directions == 1)
            for (std::int64_t i = std::max<std::int64_t>(range[0], 1); i <= std::min(range[1], kMostCells);
                 ++i) {
                if (!isOfCells && i > pointCount()) break;
                if (isOfCells && !m_cellOf.contains(i)) break;
                members.push_back(i);
            }
        if (directions < 2 || directions > 3 || m_extents[0] == 0) return members;
        std::array<std::int64_t, 3> low{1, 1, 1}, high{1, 1, 1};
        for (std::size_t k = 0; k < directions; ++k) {
            low[k] = std::max<std::int64_t>(std::min(range[k], range[directions + k]), 1);
            high[k] = std::min(std::max(range[k], range[directions + k]), m_extents[k]);
        }
        for (auto k = low[2]; k <= high[2]; ++k)
            for (auto j = low[1]; j <= high[1]; ++j)
                for (auto i = low[0]; i <= high[0]; ++i)
                    members.push_back(i + m_extents[0] * (j - 1 + m_extents[1] * (k - 1)));
        return members;
    }

    /// Reads the values of a solution at vertices or cells.
    void readSolution(const Hdf5Node& solution) {
        const std::string place = textAt(solution, "GridLocation");
        const bool perCell = place == "CellCenter";
        if (!perCell && !place.empty() && place != "Vertex") {
            m_file.notices.push_back("its solution " + inQuotes(solution.name));
            return;
        }
        std::vector<int> members;
        if (perCell) {
            for (int c = m_firstCell; c < m_file.cells.size(); ++c)
                if (m_file.cells.dimension(c) == m_dimension) members.push_back(c);
        } else {
            for (int v = 0; v < pointCount(); ++v) members.push_back(m_firstPoint + v);
        }
        for (const Hdf5Node* array : childrenOf(solution, "DataArray_t")) {
            const Hdf5Array& data = array->at(" data");
            const std::vector<double> values = data.reals();
            if (values.size() != members.size()) {
                m_file.notices.push_back(
                    "its field " + inQuotes(array->name) + " (" + std::to_string(values.size()) +
                    " values for " + std::to_string(members.size()) + (perCell ? " cells)" : " vertices)"));
                continue;
            }
            MeshField& field = fieldOf(array->name, perCell, data.type);
            const std::size_t needed = static_cast<std::size_t>(members.empty() ? 0 : members.back() + 1);
            if (field.values.size() < needed) field.values.resize(needed, kNoValue);
            for (std::size_t i = 0; i < members.size(); ++i)
                field.values[static_cast<std::size_t>(members[i])] = values[i];
        }
    }
    MeshField& fieldOf(const std::string& name, bool perCell, Scalar type) {
        for (MeshField& field : m_file.fields)
            if (field.name == name && field.perCell == perCell) return field;
        m_file.fields.push_back({name, perCell, 1, {}, {}, type});
        return m_file.fields.back();
    }
    /// Gives all fields a value per vertex or cell, and joins those that end in X, Y and Z to vectors.
    void endFields() {
        for (MeshField& field : m_file.fields)
            field.values.resize(
                static_cast<std::size_t>(field.perCell ? m_file.cells.size() : m_file.points.cols()),
                kNoValue);
        joinVectors(m_file, "", "XYZ");
    }

    Hdf5Node m_root;
    MeshFile m_file;
    int m_dimension = 3;
    std::vector<double> m_points;
    // Of the zone that is being read:
    int m_firstPoint = 0, m_firstCell = 0;
    std::array<std::int64_t, 3> m_extents{};  // of a structured one
    std::map<std::int64_t, int> m_cellOf;     // by the numbers of elements
};

}  // namespace

MeshFile readCgns(std::span<const MeshSource> files) {
    if (!isHdf5(files[0].bytes))
        throw InputError(
            "is a CGNS file in the old form (ADF): adf2hdf of the CGNS tools makes one of HDF5 of it");
    return CgnsReader(files[0].bytes).read();
}

}  // namespace wend::formats
