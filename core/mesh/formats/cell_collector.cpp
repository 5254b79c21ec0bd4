#include "core/mesh/formats/cell_collector.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_file.h"

namespace wend::formats {

void CellCollector::polygon(std::span<const int> corners, int element) {
    for (std::size_t k = 2; k < corners.size(); ++k) {
        m_triangles.push_back({corners[0], corners[k - 1], corners[k]});
        m_triangleElements.push_back(element);
    }
}

void CellCollector::tetrahedron(const std::array<int, 4>& corners, int element) {
    m_tetrahedra.push_back(corners);
    m_tetrahedronElements.push_back(element);
}

std::vector<double> CellCollector::perCell(const std::vector<double>& perElement, int components) const {
    const auto& elements = m_tetrahedronElements.empty() ? m_triangleElements : m_tetrahedronElements;
    std::vector<double> values;
    values.reserve(elements.size() * components);
    for (int element : elements) {
        const auto first = perElement.begin() + static_cast<std::ptrdiff_t>(element) * components;
        values.insert(values.end(), first, first + components);
    }
    return values;
}

std::vector<int> CellCollector::boundaryLabels(const std::vector<double>& perElement) const {
    std::vector<int> labels;
    if (m_tetrahedra.empty()) return labels;
    for (int element : m_triangleElements) {
        const double value = perElement[static_cast<std::size_t>(element)];
        labels.push_back(std::abs(value) < 2147483647 ? static_cast<int>(std::lround(value)) : 0);
    }
    if (std::ranges::all_of(labels, [](int label) { return label == 0; })) labels.clear();
    return labels;
}

void CellCollector::moveInto(MeshFile& file) {
    file.triangles = std::move(m_triangles);
    file.tetrahedra = std::move(m_tetrahedra);
}

int cellCount(const MeshFile& file) {
    return static_cast<int>(file.tetrahedra.empty() ? file.triangles.size() : file.tetrahedra.size());
}

const MeshField* cellField(const MeshFile& file, std::initializer_list<const char*> names) {
    for (const char* name : names)
        for (const auto& field : file.fields)
            if (field.perCell && field.components == 1 && field.name == name) return &field;
    return nullptr;
}

std::optional<MeshField> labelField(const MeshFile& file) {
    if (file.tetrahedra.empty() || file.labels.empty()) return std::nullopt;
    return MeshField{"label", true, 1, {file.labels.begin(), file.labels.end()}};
}

long tagOf(const MeshField* field, int cell, long otherwise) {
    if (!field || !(std::abs(field->values[cell]) < 2147483647)) return otherwise;
    return std::lround(field->values[cell]);
}

}  // namespace wend::formats
