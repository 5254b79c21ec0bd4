#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/mesh/formats/exodus.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/netcdf.h"

namespace wend::formats {
namespace {

using Numbers = std::vector<std::int64_t>;

constexpr std::int64_t kName = 33;  // of names, with a 0 at the end

class ExodusPrinter {
  public:
    explicit ExodusPrinter(const MeshFile& mesh) : m_mesh(mesh) {
        for (int c = 0; c < mesh.cells.size(); ++c)
            m_dimension = std::max(m_dimension, mesh.cells.dimension(c));
        m_sideOf = sidesInExodus(mesh);
        makeBlocks();
    }

    std::string print() {
        printPoints();
        printBlocks();
        printSets();
        printFields();
        Hdf5Array title;
        title.type = Scalar::Int8;
        title.bytes = "Wend";
        Hdf5Array version;
        version.type = Scalar::Float32;
        const float number = 5.1F;
        version.bytes.assign(reinterpret_cast<const char*>(&number), sizeof number);
        const auto whole = [](std::int64_t value) { return Hdf5Array::of(value, Scalar::Int32); };
        const auto elements = std::ranges::count_if(m_element, [](int element) { return element >= 0; });
        return printNetcdf(m_variables,
                           {{"api_version", version},
                            {"version", version},
                            {"floating_point_word_size", whole(8)},
                            {"file_size", whole(1)},
                            {"maximum_name_length", whole(m_width - 1)},
                            {"title", title}},
                           {{"len_string", kName}, {"len_line", 81}, {"four", 4}, {"num_elem", elements}});
    }

  private:
    /// Cells of one kind in one group.
    struct Block {
        CellKind kind;
        int group;  // −1: none
        std::vector<int> cells;
    };
    struct Set {
        const MeshGroup* group;
        Numbers members, sides;
    };

    void add(std::string name, std::vector<std::string> dimensions, Hdf5Array values,
             std::vector<std::pair<std::string, std::string>> attributes = {}) {
        m_variables.push_back(
            {std::move(name), std::move(dimensions), std::move(values), std::move(attributes)});
    }
    void add(std::string name, const std::string& dimension, const Numbers& values,
             std::vector<std::pair<std::string, std::string>> attributes = {}) {
        add(std::move(name), {dimension}, Hdf5Array::of(values, {std::ssize(values)}, Scalar::Int32),
            std::move(attributes));
    }
    void addNames(const std::string& name, const std::string& dimension,
                  const std::vector<std::string>& names) {
        Hdf5Array letters;
        letters.kind = Hdf5Array::Kind::Numbers;
        letters.type = Scalar::Int8;
        letters.shape = {std::ssize(names), m_width};
        for (std::string one : names) {
            one.resize(static_cast<std::size_t>(m_width), '\0');
            letters.bytes += one;
        }
        add(name, {dimension, "len_name"}, std::move(letters));
    }

    bool isSide(int c) const { return m_sideOf[static_cast<std::size_t>(c)].element >= 0; }

    /// Divides the cells that are no sides into blocks in the order of their first cells, and numbers them.
    void makeBlocks() {
        const std::vector<int> main = mainGroups(m_mesh);
        std::map<std::pair<CellKind, int>, std::size_t> places;
        for (int c = 0; c < m_mesh.cells.size(); ++c) {
            if (isSide(c)) continue;
            const CellKind kind = m_mesh.cells.kinds[static_cast<std::size_t>(c)];
            const int group = main[static_cast<std::size_t>(c)];
            const auto [place, isNew] = places.try_emplace({kind, group}, m_blocks.size());
            if (isNew) m_blocks.push_back({kind, group, {}});
            m_blocks[place->second].cells.push_back(c);
        }
        m_element.resize(static_cast<std::size_t>(m_mesh.cells.size()), -1);
        int next = 0;
        for (const Block& block : m_blocks)
            for (const int c : block.cells) m_element[static_cast<std::size_t>(c)] = next++;
        for (const MeshGroup& group : m_mesh.groups)
            m_width = std::max<std::int64_t>(m_width, std::ssize(group.name) + 1);
        for (const MeshField& field : m_mesh.fields)
            m_width = std::max<std::int64_t>(m_width, std::ssize(field.name) + 6);
        for (const MeshField& field : m_mesh.fileFields)
            m_width = std::max<std::int64_t>(m_width, std::ssize(field.name) + 6);
    }

    void printPoints() {
        for (int k = 0; k < 3; ++k) {
            const Eigen::VectorXd row = m_mesh.points.row(k);
            add(
                std::string("coord") + "xyz" [k], { "num_nodes" },
                Hdf5Array::of(std::span(row.data(), static_cast<std::size_t>(row.size())), {row.size()}));
        }
        addNames("coor_names", "num_dim", {"x", "y", "z"});
    }
    /// Returns numbers for blocks or sets: those of the groups where they are free.
    static Numbers idsOf(const std::vector<long>& tags) {
        std::set<long> taken;
        Numbers ids;
        for (const long tag : tags) ids.push_back(tag > 0 && taken.insert(tag).second ? tag : 0);
        long next = 1;
        for (std::int64_t& id : ids) {
            while (id == 0 && !taken.insert(next).second) ++next;
            if (id == 0) id = next;
        }
        return ids;
    }
    void addIds(const std::string& kind, const std::string& dimension, const std::vector<long>& tags,
                const std::vector<std::string>& names) {
        add(kind + "_status", dimension, Numbers(tags.size(), 1));
        add(kind + "_prop1", dimension, idsOf(tags), {{"name", "ID"}});
        addNames(kind + "_names", dimension, names);
    }
    void printBlocks() {
        std::vector<long> tags;
        std::vector<std::string> names;
        for (const Block& block : m_blocks) {
            const MeshGroup* group =
                block.group < 0 ? nullptr : &m_mesh.groups[static_cast<std::size_t>(block.group)];
            tags.push_back(group ? group->tag : 0);
            names.push_back(group ? group->name : "");
        }
        addIds("eb", "num_el_blk", tags, names);
        for (std::size_t b = 0; b < m_blocks.size(); ++b) {
            const ExodusType& type = *exodusTypeOf(m_blocks[b].kind);
            const auto size = static_cast<std::size_t>(factsOf(type.kind).nodes);
            Numbers nodes(size * m_blocks[b].cells.size());
            for (std::size_t i = 0; i < m_blocks[b].cells.size(); ++i)
                for (std::size_t k = 0; k < size; ++k)
                    nodes[i * size + (type.order.empty() ? k : static_cast<std::size_t>(type.order[k]))] =
                        m_mesh.cells[m_blocks[b].cells[i]][k] + 1;
            const std::string end = std::to_string(b + 1);
            add("connect" + end, {"num_el_in_blk" + end, "num_nod_per_el" + end},
                Hdf5Array::of(nodes, {std::ssize(m_blocks[b].cells), static_cast<std::int64_t>(size)},
                              Scalar::Int32),
                {{"elem_type", std::string(type.name)}});
        }
    }

    /// Groups of nodes, of sides, and those of elements that are no blocks.
    void printSets() {
        std::vector<Set> nodes, sides, elements;
        const std::vector<int> main = mainGroups(m_mesh);
        for (std::size_t g = 0; g < m_mesh.groups.size(); ++g) {
            const MeshGroup& group = m_mesh.groups[g];
            Set ofNodes{&group, {}, {}}, ofSides = ofNodes, ofElements = ofNodes;
            for (const int v : group.vertices) ofNodes.members.push_back(v + 1);
            bool isBlock = true;
            for (const int c : group.cells) {
                if (isSide(c)) {
                    const ExodusSide& side = m_sideOf[static_cast<std::size_t>(c)];
                    ofSides.members.push_back(m_element[static_cast<std::size_t>(side.element)] + 1);
                    ofSides.sides.push_back(side.side + 1);
                } else {
                    ofElements.members.push_back(m_element[static_cast<std::size_t>(c)] + 1);
                    isBlock = isBlock && main[static_cast<std::size_t>(c)] == static_cast<int>(g);
                }
            }
            if (!ofNodes.members.empty()) nodes.push_back(std::move(ofNodes));
            if (!ofSides.members.empty()) sides.push_back(std::move(ofSides));
            if (!isBlock) elements.push_back(std::move(ofElements));
        }
        Set rest{&m_rest, {}, {}};
        for (int c = 0; c < m_mesh.cells.size(); ++c)
            if (isSide(c) && main[static_cast<std::size_t>(c)] < 0) {
                rest.members.push_back(
                    m_element[static_cast<std::size_t>(m_sideOf[static_cast<std::size_t>(c)].element)] + 1);
                rest.sides.push_back(m_sideOf[static_cast<std::size_t>(c)].side + 1);
            }
        if (!rest.members.empty()) sides.push_back(std::move(rest));
        printSets("ns", "num_node_sets", "node_ns", "num_nod_ns", nodes);
        printSets("ss", "num_side_sets", "elem_ss", "num_side_ss", sides);
        printSets("els", "num_elem_sets", "elem_els", "num_ele_els", elements);
    }
    void printSets(const std::string& kind, const std::string& dimension, const std::string& list,
                   const std::string& length, const std::vector<Set>& sets) {
        if (sets.empty()) return;
        std::vector<long> tags;
        std::vector<std::string> names;
        for (const Set& set : sets) {
            tags.push_back(set.group->tag);
            names.push_back(set.group->name);
        }
        addIds(kind, dimension, tags, names);
        for (std::size_t s = 0; s < sets.size(); ++s) {
            const std::string end = std::to_string(s + 1);
            add(list + end, length + end, sets[s].members);
            if (!sets[s].sides.empty()) add("side_ss" + end, length + end, sets[s].sides);
        }
    }

    /// Prints each component of a field as a variable; those of vectors end in _x, _y and _z.
    void printFields() {
        const std::vector<double> times(m_mesh.fields.empty() && m_mesh.fileFields.empty() ? 0 : 1, 0.0);
        add("time_whole", {"time_step"}, Hdf5Array::of(times, {std::ssize(times)}));
        std::vector<std::string> ofNodes, ofCells, ofFile;
        std::vector<double> numbers;
        for (const MeshField& field : m_mesh.fields)
            for (int k = 0; k < field.components; ++k) {
                auto& names = field.perCell ? ofCells : ofNodes;
                names.push_back(componentName(field, k));
                const std::string end = std::to_string(names.size());
                if (!field.perCell) {
                    addValues("vals_nod_var" + end, "num_nodes",
                              componentOf(field.values, field.components, k));
                    continue;
                }
                const std::vector<double> all = componentOf(field.ofCells, field.components, k);
                for (std::size_t b = 0; b < m_blocks.size(); ++b) {
                    std::vector<double> values;
                    for (const int c : m_blocks[b].cells) values.push_back(all[static_cast<std::size_t>(c)]);
                    const std::string block = std::to_string(b + 1);
                    addValues("vals_elem_var" + end + "eb" + block, "num_el_in_blk" + block, values);
                }
            }
        for (const MeshField& field : m_mesh.fileFields)
            for (std::size_t i = 0; i < field.values.size(); ++i) {
                ofFile.push_back(field.values.size() == 1 ? field.name
                                                          : field.name + " " + std::to_string(i + 1));
                numbers.push_back(field.values[i]);
            }
        if (!ofNodes.empty()) addNames("name_nod_var", "num_nod_var", ofNodes);
        if (!ofCells.empty()) {
            addNames("name_elem_var", "num_elem_var", ofCells);
            add("elem_var_tab", {"num_el_blk", "num_elem_var"},
                Hdf5Array::of(Numbers(m_blocks.size() * ofCells.size(), 1),
                              {std::ssize(m_blocks), std::ssize(ofCells)}, Scalar::Int32));
        }
        if (ofFile.empty()) return;
        addNames("name_glo_var", "num_glo_var", ofFile);
        addValues("vals_glo_var", "num_glo_var", numbers);
    }
    void addValues(const std::string& name, const std::string& dimension, const std::vector<double>& values) {
        add(name, {"time_step", dimension}, Hdf5Array::of(values, {1, std::ssize(values)}));
    }
    static std::string componentName(const MeshField& field, int k) {
        if (field.components == 1) return field.name;
        return field.name +
               (field.components == 3 ? std::string("_") + "xyz"[k] : "_" + std::to_string(k + 1));
    }
    static std::vector<double> componentOf(const std::vector<double>& all, int components, int k) {
        std::vector<double> values;
        for (std::size_t i = static_cast<std::size_t>(k); i < all.size();
             i += static_cast<std::size_t>(components))
            values.push_back(all[i]);
        return values;
    }

    const MeshFile& m_mesh;
    int m_dimension = 0;
    std::vector<ExodusSide> m_sideOf;  // of the cells
    std::vector<Block> m_blocks;
    std::vector<int> m_element;  // the place of each cell among the elements
    std::int64_t m_width = kName;
    MeshGroup m_rest{"sides", 2, 0, {}, {}, false};  // of no group
    std::vector<NetcdfVariable> m_variables;
};

}  // namespace

/// Finds the cells of the dimension below that are sides of others: only they can be in side sets.
std::vector<ExodusSide> sidesInExodus(const MeshFile& mesh) {
    int dimension = 0;
    for (int c = 0; c < mesh.cells.size(); ++c) dimension = std::max(dimension, mesh.cells.dimension(c));
    std::map<std::vector<int>, std::pair<int, int>> sides;
    for (int c = 0; c < mesh.cells.size(); ++c) {
        if (mesh.cells.dimension(c) != dimension) continue;
        const auto all = exodusSidesOf(mesh.cells.kinds[static_cast<std::size_t>(c)]);
        for (std::size_t s = 0; s < all.size(); ++s) {
            std::vector<int> key;
            for (const int k : all[s]) key.push_back(mesh.cells[c][static_cast<std::size_t>(k)]);
            std::ranges::sort(key);
            sides.try_emplace(key, c, static_cast<int>(s));
        }
    }
    std::vector<ExodusSide> sideOf(static_cast<std::size_t>(mesh.cells.size()), {-1, -1});
    for (int c = 0; c < mesh.cells.size(); ++c) {
        const CellKind kind = mesh.cells.kinds[static_cast<std::size_t>(c)];
        if (mesh.cells.dimension(c) != dimension - 1) continue;
        const auto corners = mesh.cells[c].first(static_cast<std::size_t>(factsOf(kind).corners));
        std::vector<int> key(corners.begin(), corners.end());
        std::ranges::sort(key);
        if (const auto side = sides.find(key); side != sides.end())
            sideOf[static_cast<std::size_t>(c)] = {side->second.first, side->second.second};
    }
    return sideOf;
}

std::vector<std::string> printExodus(const MeshFile& mesh, const MeshWriteOptions&) {
    return {ExodusPrinter(mesh).print()};
}

}  // namespace wend::formats
