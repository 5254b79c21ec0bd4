#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/mesh_field.h"

namespace wend {
struct MeshFile;
}

namespace wend::formats {

/// Gathers the cells of a file in their order and remembers which of the file's elements each one came from,
/// because polygons are split and lines and points are passed over.
class CellCollector {
  public:
    /// Split into a fan from its first corner.
    void polygon(std::span<const int> corners, int element);
    void tetrahedron(const std::array<int, 4>& corners, int element);

    /// Values per element of the file → values per cell of the mesh: its tetrahedra if it has any, else its
    /// triangles.
    std::vector<double> perCell(const std::vector<double>& perElement, int components) const;
    /// The values of the triangles that are the boundary of tetrahedra, as labels; empty if there are no
    /// tetrahedra or all values are 0.
    std::vector<int> boundaryLabels(const std::vector<double>& perElement) const;
    void moveInto(MeshFile& file);

  private:
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<std::array<int, 4>> m_tetrahedra;
    std::vector<int> m_triangleElements, m_tetrahedronElements;
};

/// The cells of a file that are the mesh's: its tetrahedra if it has any, else its triangles.
int cellCount(const MeshFile& file);

/// The first of these fields that the file has with one component per cell, or null.
const MeshField* cellField(const MeshFile& file, std::initializer_list<const char*> names);
/// The labels of a volume's boundary as a field of one value per triangle; nothing if it has none.
std::optional<MeshField> labelField(const MeshFile& file);
/// Its value for a cell as a whole number, or `otherwise` if there is no field.
long tagOf(const MeshField* field, int cell, long otherwise);

}  // namespace wend::formats
