#include <algorithm>
#include <map>
#include <optional>

#include "core/mesh/formats/boundary_values.h"
#include "core/mesh/formats/gmsh_groups.h"
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
        : m_mesh(mesh), m_binary(options.binary()), m_groups(mesh) {}

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
    /// Values as post-processing data; tags stand with the cells already.
    void fields() {
        const bool withBoundary = isVolume(m_mesh) && !m_mesh.triangles.empty();
        const auto behind = withBoundary ? cellsBehind(m_mesh) : std::vector<int>();
        for (const auto& field : m_mesh.fields) {
            if (m_groups.holds(field)) continue;
            const auto drawable = inSpace(field);
            if (!drawable) continue;
            data(*drawable,
                 withBoundary && field.perCell ? boundaryValues(*drawable, behind) : std::vector<double>());
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
        MeshField wide{field.name, field.perCell, 3 * rows, {}};
        for (std::size_t i = 0; i < field.values.size(); i += field.components)
            for (int row = 0; row < rows; ++row)
                for (int k = 0; k < 3; ++k)
                    wide.values.push_back(row < n && k < 2 ? field.values[i + 2 * row + k] : 0);
        return wide;
    }
    /// Elements are numbered triangles first. Every one has a value: meshio reads no data of a part of them.
    void data(const MeshField& field, const std::vector<double>& ofBoundary) {
        std::string name = field.name;
        std::replace(name.begin(), name.end(), '"', '\'');
        section(field.perCell ? "$ElementData" : "$NodeData");
        m_out << "1\n\"" << name << "\"\n1\n0\n3\n0\n"
              << field.components << '\n'
              << (ofBoundary.size() + field.values.size()) / field.components << '\n';
        std::size_t element = 1;
        for (const auto* values : {&ofBoundary, &field.values})
            for (std::size_t i = 0; i < values->size(); i += field.components) {
                whole(static_cast<std::int64_t>(element++), Scalar::Int32);
                for (int k = 0; k < field.components; ++k) number((*values)[i + k]);
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
            whole(m_groups.physical(dimension, c), Scalar::Int32);
            whole(m_groups.entity(dimension, c), Scalar::Int32);
            for (int v : cells[c]) whole(v + 1, Scalar::Int32);
            endLine();
        }
    }

    std::vector<Run> runsOf(std::size_t cellCount, int dimension) const {
        std::vector<Run> runs;
        for (std::size_t c = 0; c < cellCount; ++c) {
            const long entity = m_groups.entity(dimension, c);
            if (runs.empty() || runs.back().entity != entity)
                runs.push_back({dimension, entity, m_groups.physical(dimension, c), c, 0});
            ++runs.back().count;
        }
        return runs;
    }
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
            size(1);
            whole(physical, Scalar::Int32);
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
    GmshGroups m_groups;
    TextWriter m_out;
};

}  // namespace

std::vector<std::string> printGmsh(const MeshFile& mesh, const MeshWriteOptions& options) {
    if (options.gmshVersion != 2) return {GmshPrinter(mesh, options).print4()};
    // meshio takes no values on two kinds of cells from version 2.2 (it cuts them at two).
    const bool valued = std::ranges::any_of(mesh.fields, &MeshField::perCell);
    if (mesh.made && valued && !options.boundary)
        return {GmshPrinter(withoutBoundary(mesh), options).print2()};
    return {GmshPrinter(mesh, options).print2()};
}

}  // namespace wend::formats
