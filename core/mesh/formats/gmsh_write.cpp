#include <algorithm>
#include <map>
#include <optional>

#include "core/mesh/formats/boundary_values.h"
#include "core/mesh/formats/gmsh_elements.h"
#include "core/mesh/formats/gmsh_groups.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scalar_type.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

/// A run of cells of one kind and one entity: an entity block of version 4.1.
struct Run {
    CellKind kind;
    long entity;
    int first, count;
};

class GmshPrinter {
  public:
    GmshPrinter(const MeshFile& mesh, const MeshWriteOptions& options)
        : m_mesh(mesh), m_binary(options.binary()), m_groups(mesh) {}

    /// Prints version 2.2: names, nodes, and elements with their tags.
    std::string print2() {
        header("2.2");
        names();
        section("$Nodes");
        m_out << m_mesh.points.cols() << '\n';
        for (Eigen::Index v = 0; v < m_mesh.points.cols(); ++v) {
            whole(v + 1, Scalar::Int32);
            point(v);
        }
        endSection("$EndNodes");
        section("$Elements");
        m_out << m_mesh.cells.size() << '\n';
        for (const Run& run : runs()) elements2(run);
        endSection("$EndElements");
        fields();
        return std::move(m_out.text());
    }

    /// Prints version 4.1: names, entities, and nodes and elements by entities.
    std::string print4() {
        header("4.1");
        names();
        const auto all = runs();
        entities(all);
        nodes4(all);
        elements4(all);
        fields();
        return std::move(m_out.text());
    }

  private:
    void header(const char* version) {
        m_out << "$MeshFormat\n" << version << ' ' << (m_binary ? 1 : 0) << " 8\n";
        if (m_binary) {
            whole(1, Scalar::Int32);
            m_out << '\n';
        }
        m_out << "$EndMeshFormat\n";
    }
    void names() {
        const auto names = m_groups.names();
        if (names.empty()) return;
        m_out << "$PhysicalNames\n" << names.size() << '\n';
        for (const auto& [dimension, tag, name] : names)
            m_out << dimension << ' ' << tag << " \"" << name << "\"\n";
        m_out << "$EndPhysicalNames\n";
    }
    /// Writes values as post-processing data; tags are already written with the cells.
    void fields() {
        for (const auto& field : m_mesh.fields) {
            if (m_groups.holds(field)) continue;
            if (const auto drawable = inSpace(field)) data(*drawable);
        }
    }
    /// Gmsh draws 1, 3 and 9 components: what has 2 or 2 × 2 is of the plane.
    static std::optional<MeshField> inSpace(const MeshField& field) {
        const int n = field.components == 4 ? 2 : field.components == 2 ? 1 : 0;
        if (n == 0)
            return field.components == 1 || field.components == 3 || field.components == 9
                       ? std::optional(field)
                       : std::nullopt;
        const int rows = n == 2 ? 3 : 1;
        const auto& values = field.perCell ? field.ofCells : field.values;
        MeshField wide{field.name, field.perCell, 3 * rows, {}};
        wide.time = field.time;
        wide.step = field.step;
        auto& wider = field.perCell ? wide.ofCells : wide.values;
        for (std::size_t i = 0; i < values.size(); i += field.components)
            for (int row = 0; row < rows; ++row)
                for (int k = 0; k < 3; ++k) wider.push_back(row < n && k < 2 ? values[i + 2 * row + k] : 0);
        return wide;
    }
    /// Every element has a value: meshio reads no data of a part of them.
    void data(const MeshField& field) {
        const auto& values = field.perCell ? field.ofCells : field.values;
        std::string name = field.name;
        std::replace(name.begin(), name.end(), '"', '\'');
        section(field.perCell ? "$ElementData" : "$NodeData");
        m_out << "1\n\"" << name << "\"\n1\n"
              << field.time << "\n3\n"
              << field.step << '\n'
              << field.components << '\n'
              << values.size() / field.components << '\n';
        std::int64_t number = 1;
        for (std::size_t i = 0; i < values.size(); i += field.components) {
            whole(number++, Scalar::Int32);
            for (int k = 0; k < field.components; ++k) this->number(values[i + k]);
            endLine();
        }
        endSection(field.perCell ? "$EndElementData" : "$EndNodeData");
    }
    void section(const char* name) { m_out << name << '\n'; }
    void endSection(const char* name) {
        if (m_binary) m_out << '\n';
        m_out << name << '\n';
    }
    void whole(std::int64_t value, Scalar type) {
        if (m_binary)
            appendInteger(m_out.text(), value, type, std::endian::native);
        else
            m_out << value << ' ';
    }
    void number(double value) {
        if (m_binary)
            appendReal(m_out.text(), value, Scalar::Float64, std::endian::native);
        else
            m_out << value << ' ';
    }
    void endLine() {
        if (!m_binary) m_out.text().back() = '\n';
    }
    void size(std::size_t value) { whole(static_cast<std::int64_t>(value), Scalar::UInt64); }
    void point(Eigen::Index v) {
        for (double x : m_mesh.points.col(v)) number(x);
        endLine();
    }

    /// Calls use(vertex) in Gmsh's order of the nodes.
    template <class Use>
    void eachNode(int c, const Use& use) const {
        const auto nodes = m_mesh.cells[c];
        const auto& order = gmshElement(m_mesh.cells.kinds[static_cast<std::size_t>(c)])->order;
        if (order.empty()) {
            for (const int v : nodes) use(v);
            return;
        }
        std::vector<int> turned(nodes.size());
        for (std::size_t k = 0; k < nodes.size(); ++k) turned[static_cast<std::size_t>(order[k])] = nodes[k];
        for (const int v : turned) use(v);
    }
    void elements2(const Run& run) {
        const int type = gmshElement(run.kind)->number;
        if (m_binary)
            for (int value : {type, run.count, 2}) whole(value, Scalar::Int32);
        for (int c = run.first; c < run.first + run.count; ++c) {
            whole(c + 1, Scalar::Int32);
            if (!m_binary) m_out << type << " 2 ";
            whole(m_groups.physical(c)[0], Scalar::Int32);
            whole(m_groups.entity(c), Scalar::Int32);
            eachNode(c, [&](int v) { whole(v + 1, Scalar::Int32); });
            endLine();
        }
    }

    /// Returns the runs of consecutive cells of one kind and one entity.
    std::vector<Run> runs() const {
        std::vector<Run> runs;
        for (int c = 0; c < m_mesh.cells.size(); ++c) {
            const CellKind kind = m_mesh.cells.kinds[static_cast<std::size_t>(c)];
            const long entity = m_groups.entity(c);
            if (runs.empty() || runs.back().entity != entity || runs.back().kind != kind)
                runs.push_back({kind, entity, c, 0});
            ++runs.back().count;
        }
        return runs;
    }
    /// Writes the entities that the elements belong to, each with the box of the whole mesh and its physical
    /// groups.
    void entities(const std::vector<Run>& runs) {
        std::map<std::pair<int, long>, int> firstOf;  // a cell of each
        std::size_t counts[4] = {};
        for (const auto& run : runs) {
            const int dimension = factsOf(run.kind).dimension;
            counts[dimension] += firstOf.try_emplace({dimension, run.entity}, run.first).second;
        }
        section("$Entities");
        for (std::size_t count : counts) size(count);
        endLine();
        const Eigen::Vector3d low = m_mesh.points.rowwise().minCoeff(),
                              high = m_mesh.points.rowwise().maxCoeff();
        for (const auto& [entity, first] : firstOf) {
            whole(entity.second, Scalar::Int32);
            for (double x : low) number(x);
            for (double x : high)
                if (entity.first > 0) number(x);
            size(m_groups.physical(first).size());
            for (const long physical : m_groups.physical(first)) whole(physical, Scalar::Int32);
            if (entity.first > 0) size(0);
            endLine();
        }
        endSection("$EndEntities");
    }
    /// Writes the nodes, all of which belong to an entity of the highest dimension.
    void nodes4(const std::vector<Run>& runs) {
        const Run& owner =
            *std::ranges::max_element(runs, {}, [](const Run& run) { return factsOf(run.kind).dimension; });
        const auto count = static_cast<std::size_t>(m_mesh.points.cols());
        section("$Nodes");
        for (std::size_t value : {std::size_t(1), count, std::size_t(1), count}) size(value);
        endLine();
        whole(factsOf(owner.kind).dimension, Scalar::Int32);
        whole(owner.entity, Scalar::Int32);
        whole(0, Scalar::Int32);
        size(count);
        endLine();
        for (std::size_t v = 1; v <= count; ++v) {
            size(v);
            endLine();
        }
        for (std::size_t v = 0; v < count; ++v) point(static_cast<Eigen::Index>(v));
        endSection("$EndNodes");
    }
    /// Writes the elements in blocks of one entity and one type, numbered from 1.
    void elements4(const std::vector<Run>& runs) {
        const auto count = static_cast<std::size_t>(m_mesh.cells.size());
        section("$Elements");
        for (std::size_t value : {runs.size(), count, std::size_t(1), count}) size(value);
        endLine();
        for (const auto& run : runs) {
            whole(factsOf(run.kind).dimension, Scalar::Int32);
            whole(run.entity, Scalar::Int32);
            whole(gmshElement(run.kind)->number, Scalar::Int32);
            size(static_cast<std::size_t>(run.count));
            endLine();
            for (int c = run.first; c < run.first + run.count; ++c) {
                size(static_cast<std::size_t>(c) + 1);
                eachNode(c, [&](int v) { size(static_cast<std::size_t>(v) + 1); });
                endLine();
            }
        }
        endSection("$EndElements");
    }

    const MeshFile& m_mesh;
    bool m_binary;
    GmshGroups m_groups;
    TextWriter m_out;
};

/// Returns the cells of a generated volume without those of its boundary.
MeshFile withoutTriangles(const MeshFile& bag) {
    MeshFile bare = withoutBoundary(bag);
    bare.cells = {};
    bare.groups.clear();
    for (MeshField& field : bare.fields) field.ofCells.clear();
    return bagOf(std::move(bare), true);
}

}  // namespace

std::vector<std::string> printGmsh(const MeshFile& mesh, const MeshWriteOptions& options) {
    if (options.gmshVersion != 2) return {GmshPrinter(mesh, options).print4()};
    // meshio takes no values on two kinds of cells from version 2.2 (it cuts them at two).
    const bool valued = std::ranges::any_of(mesh.fields, &MeshField::perCell);
    if (mesh.made && valued && !options.boundary)
        return {GmshPrinter(withoutTriangles(mesh), options).print2()};
    return {GmshPrinter(mesh, options).print2()};
}

}  // namespace wend::formats
