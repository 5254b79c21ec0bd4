// MED files are HDF5 files of Salome and Code_Aster: a mesh in ENS_MAA, families of its nodes and cells with
// the names of groups in FAS, fields in CHA. Values are stored component by component.

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/med.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend::formats {
namespace {

using Numbers = std::vector<std::int64_t>;

/// Returns a text without the blanks at its end.
std::string withoutBlanks(std::string text) {
    text.resize(std::min(text.size(), text.find('\0')));
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

class MedReader {
  public:
    explicit MedReader(const std::string& bytes) : m_root(readHdf5(bytes)) {}

    MeshFile read() {
        const Hdf5Node& meshes = required(m_root, "ENS_MAA");
        if (meshes.nodes.empty()) throw InputError("there is no mesh in it");
        m_mesh = &meshes.nodes.front();
        if (meshes.nodes.size() > 1)
            m_file.notices.push_back(std::to_string(meshes.nodes.size() - 1) + " other meshes of the file");
        m_step = m_mesh;  // of old files
        if (!m_mesh->find("NOE")) {
            if (m_mesh->nodes.empty()) throw InputError("there is no mesh in it");
            m_step = &m_mesh->nodes.front();
            if (m_mesh->nodes.size() > 1)
                m_file.notices.push_back(std::to_string(m_mesh->nodes.size() - 1) +
                                         " other steps of the mesh");
        }
        readPoints();
        readCells();
        sortCells();
        readGroups();
        readFields();
        addGroupsOfFields(m_file);
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    /// The cells of one type, as the file has them.
    struct Block {
        std::string name;
        int first, count;  // of all cells, in the order of the blocks
    };

    static const Hdf5Node& required(const Hdf5Node& node, std::string_view path) {
        const Hdf5Node* found = node.find(path);
        if (!found || !found->isGroup) throw InputError("there is no group " + inQuotes(path) + " in it");
        return *found;
    }
    static std::int64_t whole(const Hdf5Node& node, std::string_view attribute, std::int64_t otherwise) {
        const Hdf5Array* value = node.attribute(attribute);
        if (!value || value->kind != Hdf5Array::Kind::Numbers || value->size() != 1) return otherwise;
        return value->integers().front();
    }

    void readPoints() {
        const std::vector<double> values = m_step->at("NOE/COO").reals();
        const std::int64_t space = whole(*m_mesh, "ESP", whole(*m_mesh, "DIM", 3));
        if (space < 1 || space > 3 || values.size() % static_cast<std::size_t>(space) != 0)
            throw InputError("the coordinates of its nodes do not fit to their dimension");
        const Eigen::Index count = static_cast<Eigen::Index>(values.size()) / space;
        m_file.points = Eigen::Matrix3Xd::Zero(3, count);
        for (Eigen::Index k = 0; k < space; ++k)
            for (Eigen::Index v = 0; v < count; ++v)
                m_file.points(k, v) = values[static_cast<std::size_t>(k * count + v)];
    }

    void readCells() {
        const Hdf5Node* all = m_step->find("MAI");
        if (!all) return;
        for (const MedType& type : medTypes())
            if (const Hdf5Node* block = all->find(type.name)) readBlock(*block, type);
        if (const Hdf5Node* polygons = all->find("POG")) readPolygons(*polygons);
        for (const Hdf5Node& other : all->nodes)
            if (std::ranges::none_of(m_blocks, [&](const Block& one) { return one.name == other.name; }))
                m_file.notices.push_back("its cells of the type " + other.name);
    }
    void beginBlock(const Hdf5Node& block) { m_blocks.push_back({block.name, m_file.cells.size(), 0}); }
    /// Notes the families and numbers of a block's cells.
    void endBlock(const Hdf5Node& block) {
        const int count = m_file.cells.size() - m_blocks.back().first;
        m_blocks.back().count = count;
        append(block, "FAM", count, m_families);
        append(block, "NUM", count, m_numbers);
    }
    static void append(const Hdf5Node& block, const char* name, int count, Numbers& list) {
        Numbers values;
        if (const Hdf5Node* data = block.find(name)) values = data->data.integers();
        values.resize(static_cast<std::size_t>(count), 0);
        list.insert(list.end(), values.begin(), values.end());
    }
    void readBlock(const Hdf5Node& block, const MedType& type) {
        const Numbers nodes = block.at("NOD").integers();
        const auto size = static_cast<std::size_t>(factsOf(type.kind).nodes), count = nodes.size() / size;
        if (nodes.size() % size != 0)
            throw InputError("the nodes of the cells " + std::string(type.name) + " do not make whole cells");
        beginBlock(block);
        std::vector<int> cell(size);
        for (std::size_t c = 0; c < count; ++c) {
            for (std::size_t k = 0; k < size; ++k) {
                const std::size_t place = type.order.empty() ? k : static_cast<std::size_t>(type.order[k]);
                cell[k] = nodeOf(m_file, nodes[place * count + c]);
            }
            m_file.cells.add(type.kind, cell);
        }
        endBlock(block);
    }
    void readPolygons(const Hdf5Node& block) {
        const Numbers nodes = block.at("NOD").integers(), begins = block.at("INN").integers();
        beginBlock(block);
        for (std::size_t c = 0; c + 1 < begins.size(); ++c) {
            if (begins[c] < 1 || begins[c + 1] < begins[c] + 3 || begins[c + 1] > std::ssize(nodes) + 1)
                throw InputError("the places of its polygons make no sense");
            std::vector<int> cell;
            for (auto k = begins[c]; k < begins[c + 1]; ++k)
                cell.push_back(nodeOf(m_file, nodes[static_cast<std::size_t>(k - 1)]));
            m_file.cells.addFace(cell);
        }
        endBlock(block);
    }

    /// Brings the cells into the order of their numbers, if all have different ones.
    void sortCells() {
        m_place.resize(m_numbers.size());
        std::iota(m_place.begin(), m_place.end(), 0);
        std::vector<int> order = m_place;
        std::ranges::stable_sort(order, {}, [this](int c) { return m_numbers[static_cast<std::size_t>(c)]; });
        const auto number = [&](std::size_t i) { return m_numbers[static_cast<std::size_t>(order[i])]; };
        for (std::size_t i = 0; i < order.size(); ++i)
            if (number(i) <= 0 || (i > 0 && number(i) == number(i - 1))) return;
        const CellList old = std::move(m_file.cells);
        const Numbers families = std::move(m_families);
        m_file.cells = {};
        m_families.clear();
        for (std::size_t i = 0; i < order.size(); ++i) {
            m_file.cells.add(old.kinds[static_cast<std::size_t>(order[i])], old[order[i]]);
            m_families.push_back(families[static_cast<std::size_t>(order[i])]);
            m_place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        }
    }

    /// Makes a group of every name and dimension.
    void readGroups() {
        Numbers ofNodes;
        append(required(*m_step, "NOE"), "FAM", static_cast<int>(m_file.points.cols()), ofNodes);
        std::map<std::pair<std::string, int>, MeshGroup> groups;
        const Hdf5Node* all = m_root.find("FAS");
        all = all ? all->find(m_mesh->name) : nullptr;
        if (!all) return;
        readFamilies(*all, ofNodes, groups);
        for (auto& [key, group] : groups) {
            nameGroup(key.first, group);
            group.dimension = std::max(key.second, 0);
            for (auto* list : {&group.cells, &group.vertices}) {
                std::ranges::sort(*list);
                list->erase(std::unique(list->begin(), list->end()), list->end());
            }
            m_file.groups.push_back(std::move(group));
        }
    }
    void readFamilies(const Hdf5Node& node, const Numbers& ofNodes,
                      std::map<std::pair<std::string, int>, MeshGroup>& groups) const {
        for (const Hdf5Node& child : node.nodes) {
            if (!child.attribute("NUM")) {
                readFamilies(child, ofNodes, groups);
                continue;
            }
            const std::int64_t number = whole(child, "NUM", 0);
            if (number == 0) continue;
            const bool isOfCells = number < 0;  // the numbers of families of nodes are positive
            const Numbers& list = isOfCells ? m_families : ofNodes;
            for (const std::string& name : namesIn(child))
                for (int i = 0; i < std::ssize(list); ++i) {
                    if (list[static_cast<std::size_t>(i)] != number) continue;
                    MeshGroup& group = groups[{name, isOfCells ? m_file.cells.dimension(i) : -1}];
                    (isOfCells ? group.cells : group.vertices).push_back(i);
                }
        }
    }
    /// Returns the names of a family's groups, each in 80 bytes.
    static std::vector<std::string> namesIn(const Hdf5Node& family) {
        std::vector<std::string> names;
        const Hdf5Node* data = family.find("GRO/NOM");
        if (!data || data->isGroup) return names;
        for (const std::string& text : data->data.texts) names.push_back(withoutBlanks(text));
        for (std::size_t at = 0; at + kMedGroupName <= data->data.bytes.size(); at += kMedGroupName)
            names.push_back(withoutBlanks(data->data.bytes.substr(at, kMedGroupName)));
        return names;
    }

    /// Reads the last step of every field.
    void readFields() {
        const Hdf5Node* all = m_root.find("CHA");
        if (!all) return;
        for (const Hdf5Node& field : all->nodes) {
            const Hdf5Array* mesh = field.attribute("MAI");
            if (field.nodes.empty() || (mesh && withoutBlanks(mesh->text()) != m_mesh->name)) continue;
            if (field.nodes.size() > 1)
                m_file.notices.push_back("all but the last of the " + std::to_string(field.nodes.size()) +
                                         " steps of the field " + inQuotes(field.name));
            readField(field, field.nodes.back());
        }
    }
    void readField(const Hdf5Node& field, const Hdf5Node& step) {
        const std::int64_t components = whole(field, "NCO", 1);
        if (components < 1 || components > 1000)
            throw InputError("the field " + inQuotes(field.name) + " makes no sense");
        MeshField ofNodes{field.name, false, static_cast<int>(components), {}};
        MeshField ofCells{field.name, true, static_cast<int>(components), {}};
        for (const Hdf5Node& support : step.nodes) {
            const bool isNodes = support.name == "NOE";
            const auto block = std::ranges::find_if(
                m_blocks, [&](const Block& one) { return "MAI." + one.name == support.name; });
            const Hdf5Node* data = support.find(std::string(kMedNoProfile) + "/CO");
            if (!data || data->isGroup || (!isNodes && block == m_blocks.end())) {
                m_file.notices.push_back("values of the field " + inQuotes(field.name) + " at " +
                                         support.name);
                continue;
            }
            if (isNodes)
                take(data->data, 0, static_cast<std::size_t>(m_file.points.cols()), false, ofNodes);
            else
                take(data->data, block->first, static_cast<std::size_t>(block->count), true, ofCells);
        }
        for (MeshField* one : {&ofNodes, &ofCells})
            if (!one->values.empty()) m_file.fields.push_back(std::move(*one));
    }
    void take(const Hdf5Array& data, int first, std::size_t count, bool perCell, MeshField& field) const {
        const std::vector<double> values = data.reals();
        const auto components = static_cast<std::size_t>(field.components);
        if (values.size() != count * components)
            throw InputError("the field " + inQuotes(field.name) + " has " + std::to_string(values.size()) +
                             " values where " + std::to_string(count * components) + " are needed");
        const auto all = perCell ? m_place.size() : count;
        if (field.values.empty()) {
            field.values.resize(all * components, std::numeric_limits<double>::quiet_NaN());
            field.type = data.type;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t to =
                perCell ? static_cast<std::size_t>(m_place[static_cast<std::size_t>(first) + i]) : i;
            for (std::size_t k = 0; k < components; ++k)
                field.values[to * components + k] = values[k * count + i];
        }
    }

    Hdf5Node m_root;
    const Hdf5Node *m_mesh = nullptr, *m_step = nullptr;
    MeshFile m_file;
    std::vector<Block> m_blocks;
    Numbers m_families, m_numbers;  // of the cells
    std::vector<int> m_place;       // of the cells in the order of their blocks
};

}  // namespace

MeshFile readMed(std::span<const MeshSource> files) {
    return MedReader(files[0].bytes).read();
}

}  // namespace wend::formats
