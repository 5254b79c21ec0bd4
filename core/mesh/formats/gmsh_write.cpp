#include <algorithm>
#include <map>

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scalar_type.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

/// A run of cells of one kind and one entity: an entity block of version 4.1.
struct Run {
    int dimension;
    long entity, physical;
    std::size_t first, count;
};

class GmshPrinter {
  public:
    GmshPrinter(const MeshFile& mesh, const MeshWriteOptions& options)
        : m_mesh(mesh),
          m_binary(options.binary()),
          m_physical(cellField(mesh, {"physical", "ref", "attribute"})),
          m_entity(cellField(mesh, {"entity", "physical", "ref", "attribute"})),
          m_labels(labelField(mesh)) {}

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
        m_out << m_mesh.triangles.size() + m_mesh.tetrahedra.size() << '\n';
        elements2(m_mesh.triangles, 2, 1);
        elements2(m_mesh.tetrahedra, 4, 1 + m_mesh.triangles.size());
        endSection("$EndElements");
        fields();
        return std::move(m_out.text());
    }

    std::string print4() {
        header("4.1");
        names();
        auto runs = runsOf(m_mesh.triangles.size(), 2);
        const auto ofTetrahedra = runsOf(m_mesh.tetrahedra.size(), 3);
        runs.insert(runs.end(), ofTetrahedra.begin(), ofTetrahedra.end());
        entities(runs);
        nodes4(runs.back());
        elements4(runs);
        fields();
        return std::move(m_out.text());
    }

  private:
    /// The tags of triangles are the labels if they are a volume's border.
    const MeshField* tags(int dimension, const MeshField* ofCells) const {
        if ((dimension == 3) == !m_mesh.tetrahedra.empty()) return ofCells;
        return m_labels ? &*m_labels : nullptr;
    }
    long physicalOf(int dimension, std::size_t cell) const {
        return tagOf(tags(dimension, m_physical), static_cast<int>(cell), 0);
    }
    /// Gmsh counts entities from 1. Triangles of a border without label are an entity behind the labelled
    /// ones.
    long entityOf(int dimension, std::size_t cell) const {
        if (m_labels && dimension == 2 && m_mesh.labels[cell] == 0)
            return 1 + *std::max_element(m_mesh.labels.begin(), m_mesh.labels.end());
        const long entity = tagOf(tags(dimension, m_entity), static_cast<int>(cell), 1);
        return entity > 0 ? entity : 1;
    }

    void header(const char* version) {
        m_out << "$MeshFormat\n" << version << ' ' << (m_binary ? 1 : 0) << " 8\n";
        if (m_binary) {
            whole(1, Scalar::Int32);
            m_out << '\n';
        }
        m_out << "$EndMeshFormat\n";
    }
    /// Of the labels.
    void names() {
        if (!m_labels || m_mesh.labelNames.empty()) return;
        m_out << "$PhysicalNames\n" << m_mesh.labelNames.size() << '\n';
        int tag = 1;
        for (std::string name : m_mesh.labelNames) {
            std::replace(name.begin(), name.end(), '"', '\'');
            m_out << "2 " << tag++ << " \"" << name << "\"\n";
        }
        m_out << "$EndPhysicalNames\n";
    }
    /// Values as post-processing data: Gmsh draws 1, 3 and 9 components. Tags stand with the cells already.
    void fields() {
        for (const auto& field : m_mesh.fields) {
            const bool isTag = field.name == "physical" || field.name == "entity" || field.name == "ref" ||
                               field.name == "attribute";
            const bool drawable = field.components == 1 || field.components == 3 || field.components == 9;
            if (!isTag && drawable) data(field);
        }
    }
    void data(const MeshField& field) {
        std::string name = field.name;
        std::replace(name.begin(), name.end(), '"', '\'');
        const std::size_t count = field.values.size() / field.components;
        section(field.perCell ? "$ElementData" : "$NodeData");
        m_out << "1\n\"" << name << "\"\n1\n0\n3\n0\n" << field.components << '\n' << count << '\n';
        // elements are numbered triangles first, of which a volume's border has no values
        const std::size_t first = 1 + (field.perCell && isVolume(m_mesh) ? m_mesh.triangles.size() : 0);
        for (std::size_t i = 0; i < count; ++i) {
            whole(static_cast<std::int64_t>(first + i), Scalar::Int32);
            for (int k = 0; k < field.components; ++k) number(field.values[i * field.components + k]);
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

    template <std::size_t N>
    void elements2(const std::vector<std::array<int, N>>& cells, int type, std::size_t firstNumber) {
        if (m_binary && !cells.empty())
            for (int value : {type, static_cast<int>(cells.size()), 2}) whole(value, Scalar::Int32);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const int dimension = static_cast<int>(N) - 1;
            whole(static_cast<std::int64_t>(firstNumber + c), Scalar::Int32);
            if (!m_binary) m_out << type << " 2 ";
            whole(physicalOf(dimension, c), Scalar::Int32);
            whole(entityOf(dimension, c), Scalar::Int32);
            for (int v : cells[c]) whole(v + 1, Scalar::Int32);
            endLine();
        }
    }

    std::vector<Run> runsOf(std::size_t cellCount, int dimension) const {
        std::vector<Run> runs;
        for (std::size_t c = 0; c < cellCount; ++c) {
            const long entity = entityOf(dimension, c);
            if (runs.empty() || runs.back().entity != entity)
                runs.push_back({dimension, entity, physicalOf(dimension, c), c, 0});
            ++runs.back().count;
        }
        return runs;
    }
    /// An entity has one physical tag: that of its first cell.
    void entities(const std::vector<Run>& runs) {
        std::map<std::pair<int, long>, long> physicalOfEntity;
        std::size_t counts[4] = {};
        for (const auto& run : runs)
            counts[run.dimension] +=
                physicalOfEntity.try_emplace({run.dimension, run.entity}, run.physical).second;
        section("$Entities");
        for (std::size_t count : counts) size(count);
        endLine();
        const Eigen::Vector3d low = m_mesh.points.rowwise().minCoeff(),
                              high = m_mesh.points.rowwise().maxCoeff();
        for (const auto& [entity, physical] : physicalOfEntity) {
            whole(entity.second, Scalar::Int32);
            for (double x : low) number(x);
            for (double x : high) number(x);
            size(physical != 0);
            if (physical != 0) whole(physical, Scalar::Int32);
            size(0);
            endLine();
        }
        endSection("$EndEntities");
    }
    void nodes4(const Run& owner) {
        const auto count = static_cast<std::size_t>(m_mesh.points.cols());
        section("$Nodes");
        for (std::size_t value : {std::size_t(1), count, std::size_t(1), count}) size(value);
        endLine();
        whole(owner.dimension, Scalar::Int32);
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
    void elements4(const std::vector<Run>& runs) {
        const std::size_t count = m_mesh.triangles.size() + m_mesh.tetrahedra.size();
        section("$Elements");
        for (std::size_t value : {runs.size(), count, std::size_t(1), count}) size(value);
        endLine();
        std::size_t number = 1;
        for (const auto& run : runs) {
            whole(run.dimension, Scalar::Int32);
            whole(run.entity, Scalar::Int32);
            whole(run.dimension == 2 ? 2 : 4, Scalar::Int32);
            size(run.count);
            endLine();
            for (std::size_t c = run.first; c < run.first + run.count; ++c) {
                size(number++);
                if (run.dimension == 2)
                    for (int v : m_mesh.triangles[c]) size(v + 1);
                else
                    for (int v : m_mesh.tetrahedra[c]) size(v + 1);
                endLine();
            }
        }
        endSection("$EndElements");
    }

    const MeshFile& m_mesh;
    bool m_binary;
    const MeshField *m_physical, *m_entity;
    std::optional<MeshField> m_labels;
    TextWriter m_out;
};

}  // namespace

std::vector<std::string> printGmsh(const MeshFile& mesh, const MeshWriteOptions& options) {
    GmshPrinter printer(mesh, options);
    return {options.gmshVersion == 2 ? printer.print2() : printer.print4()};
}

}  // namespace wend::formats
