#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "core/mesh/formats/cgns.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend::formats {
namespace {

using Numbers = std::vector<std::int64_t>;

/// From so many runs of one kind on, cells of mixed kinds are one section.
constexpr int kMostSections = 100;

Hdf5Array whole(const Numbers& values, std::vector<std::int64_t> shape) {
    return Hdf5Array::of(values, std::move(shape), Scalar::Int32);
}
Hdf5Array whole(const Numbers& values) {
    return whole(values, {std::ssize(values)});
}
Hdf5Array charactersOf(std::string text) {
    Hdf5Array array;
    array.kind = Hdf5Array::Kind::Numbers;
    array.type = Scalar::Int8;
    array.shape = {std::ssize(text)};
    array.bytes = std::move(text);
    return array;
}
Hdf5Array real(std::span<const double> values) {
    return Hdf5Array::of(values, {std::ssize(values)});
}

/// Gives a node of the file the attributes that the CGNS library expects.
Hdf5Node& described(Hdf5Node& node, const std::string& name, const std::string& label,
                    const std::string& type) {
    constexpr int kText = kCgnsName + 1, kType = 3;
    node.with("name", Hdf5Array::of(name, kText)).with("label", Hdf5Array::of(label, kText));
    return node.with("type", Hdf5Array::of(type, kType));
}

/// Adds a node, whose data may be none.
Hdf5Node& add(Hdf5Node& parent, const std::string& name, const std::string& label, Hdf5Array data = {}) {
    const bool none = data.kind == Hdf5Array::Kind::None;
    const std::string type = none                           ? "MT"
                             : data.type == Scalar::Int8    ? "C1"
                             : data.type == Scalar::Int32   ? "I4"
                             : data.type == Scalar::Float32 ? "R4"
                                                            : "R8";
    Hdf5Node& node = described(parent.group(name), name, label, type);
    const std::int64_t flags = 1;
    node.with("flags", whole({flags}));
    if (!none) node.dataSet(" data", std::move(data));
    return node;
}

/// Names within one node: of 32 bytes, without slashes, and each once.
class Names {
  public:
    std::string of(std::string name) {
        std::ranges::replace(name, '/', '_');
        if (name.empty() || name.front() == ' ') name = "_" + name;
        if (name.size() > kCgnsName) name.resize(kCgnsName);
        std::string one = name;
        for (int k = 2; !m_taken.insert(one).second; ++k) {
            const std::string end = " " + std::to_string(k);
            one = name.substr(0, kCgnsName - end.size()) + end;
        }
        return one;
    }

  private:
    std::set<std::string> m_taken;
};

class CgnsPrinter {
  public:
    explicit CgnsPrinter(const MeshFile& mesh) : m_mesh(mesh) {
        for (int c = 0; c < mesh.cells.size(); ++c)
            m_dimension = std::max(m_dimension, mesh.cells.dimension(c));
        for (int c = 0; c < mesh.cells.size(); ++c)
            if (mesh.cells.dimension(c) == m_dimension) m_main.push_back(c);
    }

    Hdf5Node print() {
        Hdf5Node root;
        described(root, "HDF5 MotherNode", "Root Node of HDF5 File", "MT");
        std::string format = "IEEE_LITTLE_32", version = "HDF5 Version 1.10";
        format.resize(15), version.resize(33);
        root.dataSet(" format", charactersOf(format));
        root.dataSet(" hdf5version", charactersOf(version));
        constexpr float kVersion = 3.4F;
        Hdf5Array number;
        number.kind = Hdf5Array::Kind::Numbers;
        number.type = Scalar::Float32;
        number.shape = {1};
        number.bytes.assign(reinterpret_cast<const char*>(&kVersion), sizeof kVersion);
        add(root, "CGNSLibraryVersion", "CGNSLibraryVersion_t", number);
        Hdf5Node& base = add(root, "Base", "CGNSBase_t", whole({std::max(m_dimension, 1), 3}));
        printZone(add(base, "Zone", "Zone_t", whole({m_mesh.points.cols(), std::ssize(m_main), 0}, {3, 1})));
        for (const std::string& family : m_families) add(base, family, "Family_t");
        return root;
    }

  private:
    void printZone(Hdf5Node& zone) {
        add(zone, "ZoneType", "ZoneType_t", charactersOf("Unstructured"));
        Hdf5Node& points = add(zone, "GridCoordinates", "GridCoordinates_t");
        for (int k = 0; k < 3; ++k) {
            const Eigen::VectorXd row = m_mesh.points.row(k);
            add(points, std::string("Coordinate") + "XYZ"[k], "DataArray_t",
                real({row.data(), static_cast<std::size_t>(row.size())}));
        }
        printSections(zone);
        printGroups(zone);
        printFields(zone, false);
        printFields(zone, true);
    }

    /// Prints runs of cells of one kind as a section each, or all as one mixed section.
    void printSections(Hdf5Node& zone) {
        const auto& kinds = m_mesh.cells.kinds;
        std::vector<int> begins;
        for (int c = 0; c < m_mesh.cells.size(); ++c)
            if (c == 0 || kinds[static_cast<std::size_t>(c)] != kinds[static_cast<std::size_t>(c) - 1])
                begins.push_back(c);
        const bool isMixed = std::ssize(begins) > kMostSections;
        if (isMixed) begins = {0};
        begins.push_back(m_mesh.cells.size());
        for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
            const int type =
                isMixed ? kCgnsMixed : cgnsTypeOf(kinds[static_cast<std::size_t>(begins[i])]).number;
            printSection(begins[i], begins[i + 1], isMixed,
                         add(zone, "Elements " + std::to_string(i + 1), "Elements_t", whole({type, 0})));
        }
    }
    void printSection(int first, int end, bool isMixed, Hdf5Node& section) const {
        Numbers nodes;
        for (int c = first; c < end; ++c) {
            const CgnsType& type = cgnsTypeOf(m_mesh.cells.kinds[static_cast<std::size_t>(c)]);
            if (isMixed) nodes.push_back(type.number);
            appendNodes(c, type, nodes);
        }
        add(section, "ElementRange", "IndexRange_t", whole({first + 1, end}));
        add(section, "ElementConnectivity", "DataArray_t", whole(nodes));
    }
    void appendNodes(int c, const CgnsType& type, Numbers& nodes) const {
        const auto cell = m_mesh.cells[c];
        const std::size_t first = nodes.size();
        nodes.resize(first + cell.size());
        for (std::size_t k = 0; k < cell.size(); ++k)
            nodes[first + (type.order.empty() ? k : static_cast<std::size_t>(type.order[k]))] = cell[k] + 1;
    }

    /// Groups of cells of the highest dimension become regions of the zone, and others boundary conditions.
    void printGroups(Hdf5Node& zone) {
        Names names;
        names.of("ZoneBC");
        std::vector<const MeshGroup*> boundary;
        for (const MeshGroup& group : m_mesh.groups) {
            if (group.cells.empty() || group.dimension < m_dimension) {
                boundary.push_back(&group);
                continue;
            }
            Hdf5Node& region = add(zone, names.of(groupName(group)), "ZoneSubRegion_t", whole({m_dimension}));
            printMembers(group, region);
        }
        if (boundary.empty()) return;
        Hdf5Node& all = add(zone, "ZoneBC", "ZoneBC_t");
        for (const MeshGroup* group : boundary) {
            const std::string name = names.of(groupName(*group));
            Hdf5Node& condition = add(all, name, "BC_t", charactersOf("FamilySpecified"));
            printMembers(*group, condition);
            add(condition, "FamilyName", "FamilyName_t", charactersOf(name));
            m_families.push_back(name);
        }
    }
    /// A boundary condition is that of a family of its name; a name of a group that is no name here is beside
    /// it.
    void printMembers(const MeshGroup& group, Hdf5Node& node) {
        Numbers members;
        for (const int member : group.cells.empty() ? group.vertices : group.cells)
            members.push_back(member + 1);
        const auto count = std::ssize(members);
        add(node, "PointList", "IndexArray_t", whole(members, {count, 1}));
        const char* const places[] = {"CellCenter", "EdgeCenter", "FaceCenter", "CellCenter"};
        const char* const place = group.cells.empty()              ? "Vertex"
                                  : group.dimension == m_dimension ? "CellCenter"
                                                                   : places[group.dimension];
        add(node, "GridLocation", "GridLocation_t", charactersOf(place));
        if (node.name != groupName(group))
            add(node, "GroupName", "Descriptor_t", charactersOf(groupName(group)));
    }

    void printFields(Hdf5Node& zone, bool perCell) {
        Names names;
        Hdf5Node* solution = nullptr;
        for (const MeshField& field : m_mesh.fields) {
            if (field.perCell != perCell) continue;
            if (!solution) {
                solution = &add(zone, perCell ? "CellData" : "PointData", "FlowSolution_t");
                add(*solution, "GridLocation", "GridLocation_t",
                    charactersOf(perCell ? "CellCenter" : "Vertex"));
            }
            for (int k = 0; k < field.components; ++k) {
                std::string name = field.name;
                if (field.components == 3) name.resize(std::min<std::size_t>(name.size(), kCgnsName - 1));
                if (field.components == 3)
                    name += "XYZ"[k];
                else if (field.components > 1)
                    name += " " + std::to_string(k + 1);
                add(*solution, names.of(name), "DataArray_t", component(field, k));
            }
        }
    }
    /// Fields of cells are those of the highest dimension.
    Hdf5Array component(const MeshField& field, int k) const {
        std::vector<double> values;
        const auto at = [&](const std::vector<double>& all, int i) {
            values.push_back(all[static_cast<std::size_t>(i) * field.components + k]);
        };
        if (field.perCell)
            for (const int c : m_main) at(field.ofCells, c);
        else
            for (int v = 0; v < m_mesh.points.cols(); ++v) at(field.values, v);
        const bool isWhole = field.type < Scalar::UInt32 &&
                             std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
        return isWhole ? whole(Numbers(values.begin(), values.end())) : real(values);
    }

    const MeshFile& m_mesh;
    int m_dimension = 0;
    std::vector<int> m_main;  // the cells of that dimension
    std::vector<std::string> m_families;
};

}  // namespace

/// Cells of the highest dimension come first, as other programs expect.
std::vector<std::string> printCgns(const MeshFile& mesh, const MeshWriteOptions& options) {
    std::vector<int> order(static_cast<std::size_t>(mesh.cells.size()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(), [&](int c) { return mesh.cells.dimension(c); });
    const MeshFile bag = inOrder(mesh, order);
    return {printHdf5(CgnsPrinter(bag).print(), options.encoding == MeshWriteOptions::Encoding::Compressed)};
}

}  // namespace wend::formats
