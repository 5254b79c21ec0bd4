#include "core/meshing/fewer_cells.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>

namespace wend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CellStructure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>,
                                         CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using CellTriangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CellStructure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr double kSameArea = 1e-9;

double areaOf(const SimplicialMesh<2>& mesh, const std::vector<Cell<2>>& cells) {
    double area = 0;
    for (const Cell<2>& cell : cells) area += std::abs(cellMeasure<2>(mesh.points, cell));
    return area;
}

class Places {
  public:
    Places(const SimplicialMesh<2>& mesh, CellTriangulation& to)
        : m_mesh(mesh), m_to(to), m_placed(static_cast<std::size_t>(mesh.vertexCount())) {}

    CellTriangulation::Vertex_handle place(int vertex) {
        CellTriangulation::Vertex_handle& placed = m_placed[static_cast<std::size_t>(vertex)];
        if (placed != nullptr) return placed;
        placed = m_to.insert({m_mesh.points(0, vertex), m_mesh.points(1, vertex)}, m_near);
        placed->info() = vertex;
        m_near = placed->face();
        return placed;
    }

  private:
    const SimplicialMesh<2>& m_mesh;
    CellTriangulation& m_to;
    std::vector<CellTriangulation::Vertex_handle> m_placed;
    CellTriangulation::Face_handle m_near;
};

}  // namespace

std::optional<FewerCells> fewerCells(const SimplicialMesh<2>& mesh, const PointLocator<2>& located,
                                     const std::vector<int>& vertices,
                                     const std::vector<std::array<int, 2>>& edges) try {
    CellTriangulation triangulation;
    Places places(mesh, triangulation);
    for (const int vertex : vertices) places.place(vertex);
    for (const auto& [a, b] : edges) triangulation.insert_constraint(places.place(a), places.place(b));
    FewerCells result;
    for (const auto& face : triangulation.finite_face_handles()) {
        const Cell<2> cell{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        const Vec2 middle =
            (mesh.points.col(cell[0]) + mesh.points.col(cell[1]) + mesh.points.col(cell[2])) / 3;
        const auto place = located.find(middle);
        if (!place) continue;
        result.cells.push_back(cell);
        result.cellInMesh.push_back(place->cell);
    }
    const double area = areaOf(mesh, mesh.cells);
    if (std::abs(areaOf(mesh, result.cells) - area) > kSameArea * area) return std::nullopt;
    return result;
} catch (const CellTriangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
}

}  // namespace wend
