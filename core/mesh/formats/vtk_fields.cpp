#include "core/mesh/formats/vtk_fields.h"

namespace wend::formats {
namespace {

template <std::size_t N>
void append(VtkCells& cells, const std::vector<std::array<int, N>>& simplices, int type) {
    for (const auto& simplex : simplices) {
        cells.types.push_back(type);
        cells.connectivity.insert(cells.connectivity.end(), simplex.begin(), simplex.end());
        cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
    }
}

}  // namespace

VtkCells vtkCellsOf(const MeshFile& mesh) {
    VtkCells cells;
    cells.offsets = {0};
    append(cells, mesh.tetrahedra, vtkTetrahedron);
    append(cells, mesh.triangles, vtkTriangle);
    return cells;
}

std::vector<double> vtkValuesOf(const MeshField& field, const VtkCells& cells) {
    auto values = field.values;
    if (field.perCell) values.resize(cells.types.size() * field.components, 0.0);
    return values;
}

}  // namespace wend::formats
