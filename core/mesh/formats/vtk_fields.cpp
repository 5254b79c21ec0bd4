#include "core/mesh/formats/vtk_fields.h"

#include <algorithm>

#include "core/mesh/formats/boundary_values.h"

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

std::vector<MeshField> vtkFieldsOf(const MeshFile& mesh) {
    auto fields = mesh.fields;
    const bool withBoundary = isVolume(mesh) && !mesh.triangles.empty();
    const auto behind = withBoundary ? cellsBehind(mesh) : std::vector<int>();
    auto labels = labelField(mesh);
    if (labels) std::erase_if(fields, isVtkLabels);
    for (auto& field : fields) {
        if (!field.perCell || !withBoundary) continue;
        const auto ofBoundary = boundaryValues(field, behind);
        field.values.insert(field.values.end(), ofBoundary.begin(), ofBoundary.end());
    }
    if (labels) {
        labels->values.insert(labels->values.begin(), mesh.tetrahedra.size(), 0.0);
        fields.push_back(std::move(*labels));
    }
    return fields;
}

bool isVtkLabels(const MeshField& field) {
    return field.perCell && field.components == 1 && field.name == "label";
}

void takeVtkLabels(const MeshField& field, const CellCollector& collector, MeshFile& file) {
    file.labels = collector.boundaryLabels(field.values);
    MeshField ofCells = field;
    ofCells.values = collector.perCell(field.values, 1);
    const bool none = std::ranges::all_of(ofCells.values, [](double value) { return value == 0; });
    if (file.labels.empty() || !none) file.fields.push_back(std::move(ofCells));
}

}  // namespace wend::formats
