#include <algorithm>
#include <cmath>
#include <map>

#include "core/mesh/formats/med.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend::formats {
namespace {

constexpr const char* kMesh = "mesh";
/// The names of a step without a time, and of the first one.
constexpr const char *kNoStep = "-0000000000000000001-0000000000000000001",
                     *kFirstStep = "0000000000000000000100000000000000000001";

using Numbers = std::vector<std::int64_t>;

Hdf5Array whole(std::int64_t value) {
    return Hdf5Array::of(value, Scalar::Int32);
}

/// Returns whole numbers of 32 bits, as the MED library stores them.
Hdf5Array list(const Numbers& values) {
    return Hdf5Array::of(values, {std::ssize(values)}, Scalar::Int32);
}

std::string withBlanks(std::string text, std::size_t size) {
    text.resize(size, ' ');
    return text;
}

/// Returns a name as that of an HDF5 group.
std::string linkName(std::string name) {
    if (name.size() > kMedName) name.resize(kMedName);
    std::ranges::replace(name, '/', '_');
    return name.empty() || name == "." ? "_" : name;
}

/// Families are the combinations of groups that nodes or cells are in: 0 is in none.
struct Families {
    std::map<std::vector<std::string>, std::int64_t> numbers;
    Numbers of;  // each node or cell
};

/// Returns the families of nodes (1, 2, …) or cells (−1, −2, …).
Families familiesOf(const MeshFile& mesh, bool ofCells) {
    std::vector<std::vector<std::string>> names(ofCells ? static_cast<std::size_t>(mesh.cells.size())
                                                        : static_cast<std::size_t>(mesh.points.cols()));
    for (const MeshGroup& group : mesh.groups)
        for (const int member : ofCells ? group.cells : group.vertices) {
            auto& own = names[static_cast<std::size_t>(member)];
            if (std::ranges::count(own, groupName(group)) == 0) own.push_back(groupName(group));
        }
    Families families;
    for (auto& own : names) {
        std::ranges::sort(own);
        if (own.empty()) {
            families.of.push_back(0);
            continue;
        }
        const auto next = std::ssize(families.numbers) + 1;
        families.of.push_back(families.numbers.try_emplace(own, ofCells ? -next : next).first->second);
    }
    return families;
}

class MedPrinter {
  public:
    explicit MedPrinter(const MeshFile& mesh)
        : m_mesh(mesh), m_ofNodes(familiesOf(mesh, false)), m_ofCells(familiesOf(mesh, true)) {
        for (int c = 0; c < mesh.cells.size(); ++c)
            m_ofKind[mesh.cells.kinds[static_cast<std::size_t>(c)]].push_back(c);
    }

    Hdf5Node print() {
        Hdf5Node root;
        root.group("INFOS_GENERALES").with("MAJ", whole(3)).with("MIN", whole(0)).with("REL", whole(0));
        printMesh(root.group("ENS_MAA").group(kMesh));
        printFamilies(root.group("FAS").group(kMesh));
        if (!m_mesh.fields.empty()) printFields(root.group("CHA"));
        return root;
    }

  private:
    void printMesh(Hdf5Node& mesh) const {
        int dimension = 0;
        for (int c = 0; c < m_mesh.cells.size(); ++c)
            dimension = std::max(dimension, m_mesh.cells.dimension(c));
        std::string axes, units;
        for (const char* axis : {"X", "Y", "Z"}) {
            axes += withBlanks(axis, kMedShortName);
            units += withBlanks("", kMedShortName);
        }
        mesh.with("DIM", whole(dimension)).with("ESP", whole(3)).with("REP", whole(0)).with("SRT", whole(1));
        mesh.with("TYP", whole(0)).with("DES", Hdf5Array::of("", 200)).with("UNT", Hdf5Array::of("", 17));
        mesh.with("NOM", Hdf5Array::of(axes)).with("UNI", Hdf5Array::of(units));
        Hdf5Node& step = mesh.group(kNoStep);
        step.with("CGT", whole(1))
            .with("NDT", whole(-1))
            .with("NOR", whole(-1))
            .with("PDT", Hdf5Array::of(-1.0));
        printNodes(step.group("NOE"));
        Hdf5Node& cells = step.group("MAI").with("CGT", whole(1));
        for (const MedType& type : medTypes())
            if (m_ofKind.contains(type.kind)) printCells(type, cells.group(std::string(type.name)));
    }
    static Hdf5Node& ofAll(Hdf5Node& node) {
        node.with("CGT", whole(1)).with("CGS", whole(1));
        return node.with("PFL", Hdf5Array::of(std::string(kMedNoProfile)));
    }
    static void addNumbers(Hdf5Node& node, const char* name, const Numbers& values, std::size_t count) {
        node.dataSet(name, list(values))
            .with("CGT", whole(1))
            .with("NBR", whole(static_cast<std::int64_t>(count)));
    }
    void printNodes(Hdf5Node& nodes) const {
        ofAll(nodes);
        const Eigen::MatrixX3d points = m_mesh.points.transpose();
        nodes
            .dataSet("COO", Hdf5Array::of(std::span(points.data(), static_cast<std::size_t>(points.size())),
                                          {points.size()}))
            .with("CGT", whole(1))
            .with("NBR", whole(m_mesh.points.cols()));
        addNumbers(nodes, "FAM", m_ofNodes.of, m_ofNodes.of.size());
    }
    /// Prints the cells of one type; their numbers, where there are several types, tell the order of all.
    void printCells(const MedType& type, Hdf5Node& block) const {
        const std::vector<int>& cells = m_ofKind.at(type.kind);
        const auto size = static_cast<std::size_t>(factsOf(type.kind).nodes);
        Numbers nodes(size * cells.size()), families, numbers;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            for (std::size_t k = 0; k < size; ++k) {
                const std::size_t place = type.order.empty() ? k : static_cast<std::size_t>(type.order[k]);
                nodes[place * cells.size() + c] = m_mesh.cells[cells[c]][k] + 1;
            }
            families.push_back(m_ofCells.of[static_cast<std::size_t>(cells[c])]);
            numbers.push_back(cells[c] + 1);
        }
        ofAll(block).with("GEO", whole(type.number));
        addNumbers(block, "NOD", nodes, cells.size());
        addNumbers(block, "FAM", families, cells.size());
        if (m_ofKind.size() > 1) addNumbers(block, "NUM", numbers, cells.size());
    }

    void printFamilies(Hdf5Node& all) const {
        all.group("FAMILLE_ZERO").with("NUM", whole(0));
        for (const auto& [name, families] :
             {std::pair("NOEUD", &m_ofNodes), std::pair("ELEME", &m_ofCells)}) {
            if (families->numbers.empty()) continue;
            Hdf5Node& group = all.group(name);
            for (const auto& [names, number] : families->numbers)
                printFamily(names, number, group.group("FAM_" + std::to_string(number)));
        }
    }
    static void printFamily(const std::vector<std::string>& names, std::int64_t number, Hdf5Node& family) {
        family.with("NUM", whole(number));
        Hdf5Array bytes;
        bytes.kind = Hdf5Array::Kind::Numbers;
        bytes.type = Scalar::Int8;
        bytes.inner = 1;
        bytes.shape = {std::ssize(names), kMedGroupName};
        for (std::string name : names) {
            name.resize(kMedGroupName, '\0');
            bytes.bytes += name;
        }
        family.group("GRO").with("NBR", whole(std::ssize(names))).dataSet("NOM", std::move(bytes));
    }

    /// Prints each field once, for nodes and cells if there are two of its name.
    void printFields(Hdf5Node& all) const {
        for (const MeshField& field : m_mesh.fields) {
            const std::string name = linkName(field.name);
            const auto known = std::ranges::find(all.nodes, name, &Hdf5Node::name);
            if (known != all.nodes.end() && whole(field.components).bytes == known->attribute("NCO")->bytes &&
                typeOf(field).bytes == known->attribute("TYP")->bytes)
                printValues(field, known->nodes.front());
            else if (known == all.nodes.end())
                printValues(field, beginField(field, all.group(name)));
            else
                printValues(field,
                            beginField(field, all.group(linkName(name.substr(0, kMedName - 6) +
                                                                 (field.perCell ? " cells" : " nodes")))));
        }
    }
    /// Returns whether the values are written as whole numbers.
    static bool isWhole(const MeshField& field) {
        return field.type < Scalar::Float32 &&
               std::ranges::all_of(field.perCell ? field.ofCells : field.values,
                                   [](double value) { return std::isfinite(value); });
    }
    static Hdf5Array typeOf(const MeshField& field) {
        constexpr int kReal = 6, kInt32 = 24, kInt64 = 26;
        return whole(!isWhole(field) ? kReal : field.type >= Scalar::UInt32 ? kInt64 : kInt32);
    }
    static Hdf5Node& beginField(const MeshField& field, Hdf5Node& node) {
        std::string names, blanks;
        for (int k = 0; k < field.components; ++k) {
            names += withBlanks(field.components > 1 ? "C" + std::to_string(k + 1) : "", kMedShortName);
            blanks += withBlanks("", kMedShortName);
        }
        node.with("MAI", Hdf5Array::of(kMesh))
            .with("NCO", whole(field.components))
            .with("TYP", typeOf(field));
        node.with("NOM", Hdf5Array::of(names))
            .with("UNI", Hdf5Array::of(blanks))
            .with("UNT", Hdf5Array::of("", 17));
        Hdf5Node& step = node.group(kFirstStep);
        step.with("NDT", whole(1)).with("NOR", whole(1)).with("PDT", Hdf5Array::of(0.0));
        return step.with("RDT", whole(-1)).with("ROR", whole(-1));
    }
    void printValues(const MeshField& field, Hdf5Node& step) const {
        if (!field.perCell) {
            std::vector<int> all(static_cast<std::size_t>(m_mesh.points.cols()));
            for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
            return printSupport(field, field.values, all, step.group("NOE"));
        }
        for (const MedType& type : medTypes())
            if (m_ofKind.contains(type.kind))
                printSupport(field, field.ofCells, m_ofKind.at(type.kind),
                             step.group("MAI." + std::string(type.name)));
    }
    static void printSupport(const MeshField& field, const std::vector<double>& all,
                             const std::vector<int>& members, Hdf5Node& support) {
        const std::string none(kMedNoProfile);
        const auto count = std::ssize(members);
        support.with("GAU", Hdf5Array::of("", kMedName + 1)).with("PFL", Hdf5Array::of(none));
        Hdf5Node& node = support.group(none);
        node.with("GAU", Hdf5Array::of("", kMedName + 1)).with("NBR", whole(count)).with("NGA", whole(1));
        std::vector<double> values;
        for (int k = 0; k < field.components; ++k)
            for (const int i : members)
                values.push_back(all[static_cast<std::size_t>(i) * field.components + k]);
        Hdf5Array array = Hdf5Array::of(values, {std::ssize(values)});
        if (isWhole(field)) {
            const Numbers numbers(values.begin(), values.end());
            array = Hdf5Array::of(numbers, {std::ssize(numbers)},
                                  field.type >= Scalar::UInt32 ? Scalar::Int64 : Scalar::Int32);
        }
        node.dataSet("CO", std::move(array));
    }

    const MeshFile& m_mesh;
    Families m_ofNodes, m_ofCells;
    std::map<CellKind, std::vector<int>> m_ofKind;
};

}  // namespace

std::vector<std::string> printMed(const MeshFile& mesh, const MeshWriteOptions& options) {
    return {printHdf5(MedPrinter(mesh).print(), options.encoding == MeshWriteOptions::Encoding::Compressed)};
}

}  // namespace wend::formats
