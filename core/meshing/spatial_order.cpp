#include "core/meshing/spatial_order.h"

#include <CGAL/Hilbert_sort_median_2.h>
#include <CGAL/Hilbert_sort_median_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>

#include <numeric>

namespace wend {
namespace {

using OrderKernel = CGAL::Simple_cartesian<double>;

std::vector<OrderKernel::Point_2> places(const Points2& points) {
    std::vector<OrderKernel::Point_2> result;
    for (const auto& p : points.colwise()) result.emplace_back(p.x(), p.y());
    return result;
}

std::vector<OrderKernel::Point_3> places(const Points3& points) {
    std::vector<OrderKernel::Point_3> result;
    for (const auto& p : points.colwise()) result.emplace_back(p.x(), p.y(), p.z());
    return result;
}

/// Returns the indices in the order of the curve; those before `first` stay.
template <int Dim>
std::vector<int> curveOrder(const Points<Dim>& points, int first) {
    const auto at = places(points);
    const auto map = CGAL::make_property_map(at);
    std::vector<int> order(at.size());
    std::iota(order.begin(), order.end(), 0);
    if constexpr (Dim == 2) {
        using Traits = CGAL::Spatial_sort_traits_adapter_2<OrderKernel, decltype(map)>;
        CGAL::Hilbert_sort_median_2<Traits, CGAL::Sequential_tag> sort{Traits(map)};
        sort(order.begin() + first, order.end());
    } else {
        using Traits = CGAL::Spatial_sort_traits_adapter_3<OrderKernel, decltype(map)>;
        CGAL::Hilbert_sort_median_3<Traits, CGAL::Sequential_tag> sort{Traits(map)};
        sort(order.begin() + first, order.end());
    }
    return order;
}

template <int Dim>
Points<Dim> centroids(const SimplicialMesh<Dim>& mesh) {
    Points<Dim> result = Points<Dim>::Zero(Dim, mesh.cellCount());
    for (int c = 0; c < mesh.cellCount(); ++c)
        for (int v : mesh.cells[c]) result.col(c) += mesh.points.col(v) / (Dim + 1);
    return result;
}

}  // namespace

template <int Dim>
std::vector<int> sortSpatially(SimplicialMesh<Dim>& mesh, int first, std::vector<int>* cellOrder) {
    const auto vertices = curveOrder<Dim>(mesh.points, first), cells = curveOrder<Dim>(centroids(mesh), 0);
    const SimplicialMesh<Dim> old = mesh;
    std::vector<int> number(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        number[vertices[i]] = static_cast<int>(i);
        mesh.points.col(static_cast<Eigen::Index>(i)) = old.points.col(vertices[i]);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        mesh.cells[i] = old.cells[cells[i]];
        for (int& v : mesh.cells[i]) v = number[v];
    }
    if (cellOrder) cellOrder->assign(cells.begin(), cells.end());
    return number;
}

template std::vector<int> sortSpatially<2>(SimplicialMesh<2>&, int, std::vector<int>*);
template std::vector<int> sortSpatially<3>(SimplicialMesh<3>&, int, std::vector<int>*);

}  // namespace wend
