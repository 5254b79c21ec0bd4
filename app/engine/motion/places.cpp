#include "app/engine/motion/places.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "app/engine/shape/shape.h"
#include "core/energy/cell_energy.h"
#include "core/mesh/decompositions.h"

namespace wend {

namespace {

constexpr double kFlatPoints = 1e-6;  // fraction of the extent below which points count as coplanar

SolidSize sizeWhere(const PosedFrame<3>& frame, const Points3& points, const std::vector<bool>& in) {
    const auto all = [&in](const auto& vertices) {
        return std::all_of(vertices.begin(), vertices.end(), [&in](int v) { return in[v]; });
    };
    SolidSize size;
    for (const Cell<3>& cell : frame.rest->cells)
        if (all(cell)) size.volume += std::abs(cellMeasure<3>(points, cell));
    for (const Facet<3>& facet : *frame.built->facets) {
        if (facet.interior() || !all(facet.vertices)) continue;
        const Vec3 a = points.col(facet.vertices[0]);
        const Vec3 u = points.col(facet.vertices[1]) - a, v = points.col(facet.vertices[2]) - a;
        size.area += u.cross(v).norm() / 2;
    }
    return size;
}

}  // namespace

template <int Dim>
Location<Dim> locationIn(const PosedFrame<Dim>& frame, int cell, const Vec<Dim>& p) {
    Location<Dim> location;
    location.cell = cell;
    const Cell<Dim>& corners = frame.rest->cells[cell];
    const Vec<Dim> w =
        edgeMatrix<Dim>(frame.pose, corners).partialPivLu().solve(p - frame.pose.col(corners[0]));
    location.weights << 1 - w.sum(), w;
    return location;
}

template <int Dim>
Mat<Dim> cellRotation(const PosedFrame<Dim>& frame, int cell) {
    const Cell<Dim>& corners = frame.rest->cells[cell];
    const Mat<Dim> F =
        edgeMatrix<Dim>(frame.pose, corners) * edgeMatrix<Dim>(frame.rest->points, corners).inverse();
    const auto [U, V, sigma] = singularValueDecomposition<Dim>(F);
    return U * V.transpose();
}

template <int Dim>
std::vector<int> verticesInside(const Region<Dim>& region, const SimplicialMesh<Dim>& rest) {
    std::vector<int> vertices;
    for (int v = 0; v < rest.vertexCount(); ++v)
        if (signedDistance<Dim>(region, rest.points.col(v)) <= 0) vertices.push_back(v);
    return vertices;
}

template <int Dim>
CarryingOf<Dim> carryingBetween(const std::vector<Vec<Dim>>& rest, const std::vector<Vec<Dim>>& posed) {
    CarryingOf<Dim> carrying;
    const auto count = static_cast<Eigen::Index>(std::min(rest.size(), posed.size()));
    if (count == 0) return carrying;
    Vec<Dim> from = Vec<Dim>::Zero(), to = Vec<Dim>::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        from += rest[i] / double(count);
        to += posed[i] / double(count);
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Dim>;
    Rows X(count, Dim), Y(count, Dim);
    for (Eigen::Index i = 0; i < count; ++i) {
        X.row(i) = (rest[i] - from).transpose();
        Y.row(i) = (posed[i] - to).transpose();
    }
    if (count > Dim)
        if (const auto [map, rank] = leastSquares<Dim, Dim>(X, Y, kFlatPoints); rank == Dim)
            carrying.A = map.transpose();
    carrying.b = to - carrying.A * from;
    return carrying;
}

template Location<2> locationIn<2>(const PosedFrame<2>&, int, const Vec2&);
template Location<3> locationIn<3>(const PosedFrame<3>&, int, const Vec3&);
template Mat2 cellRotation<2>(const PosedFrame<2>&, int);
template Mat3 cellRotation<3>(const PosedFrame<3>&, int);
template std::vector<int> verticesInside<2>(const Region<2>&, const SimplicialMesh<2>&);
template std::vector<int> verticesInside<3>(const Region<3>&, const SimplicialMesh<3>&);
template CarryingOf<2> carryingBetween<2>(const std::vector<Vec2>&, const std::vector<Vec2>&);
template CarryingOf<3> carryingBetween<3>(const std::vector<Vec3>&, const std::vector<Vec3>&);

CarryingOf<3> carryingOf(const PosedFrame<3>& frame, const std::vector<int>& vertices) {
    std::vector<Vec3> rest, posed;
    for (const int v : vertices) {
        rest.push_back(frame.rest->points.col(v));
        posed.push_back(frame.pose.col(v));
    }
    return carryingBetween<3>(rest, posed);
}

SolidSize sizeOf(const PosedFrame<3>& frame, const Points3& points) {
    return sizeWhere(frame, points, std::vector<bool>(frame.rest->vertexCount(), true));
}

SolidSize sizeOf(const PosedFrame<3>& frame, const Points3& points, const std::vector<int>& vertices) {
    std::vector<bool> in(frame.rest->vertexCount(), false);
    for (const int v : vertices) in[v] = true;
    return sizeWhere(frame, points, in);
}

namespace {

constexpr double kOnBorder = 1e-9;  // of barycentric coordinates

template <int Dim>
class RestPlacesOf : public RestPlaces {
  public:
    explicit RestPlacesOf(const SimplicialMesh<Dim>& rest)
        : m_rest(rest), m_locator(rest.points, rest.cells), m_vertices(rest.vertexCount()) {
        for (int c = 0; c < rest.cellCount(); ++c)
            for (int k = 0; k <= Dim; ++k) {
                Place& place = m_vertices[rest.cells[c][k]];
                if (place.cell >= 0) continue;
                place.cell = c;
                place.weights.setUnit(k);
            }
    }

    std::optional<Place> find(const Vec3& p) const override { return find(m_locator, p, 0); }
    int nearestVertex(const Vec3& p) const override { return m_locator.nearestVertex(p.head<Dim>()); }
    PinPlace placeOf(const Pin& pin) const override {
        std::vector<MeshPart> parts;  // that the handle may be in, from front to back
        for (auto part = m_rest.parts.rbegin(); part != m_rest.parts.rend(); ++part)
            if (pin.part.empty() || pin.part == part->name) parts.push_back(*part);
        if (parts.empty()) parts.push_back({"", 0, m_rest.vertexCount(), 0, m_rest.cellCount()});
        const bool isNamed = !pin.part.empty() && parts.size() == 1;
        if (const auto* region = std::get_if<Region<3>>(&pin.at))
            return inRegion(regionIn<Dim>(*region), parts);
        if (const auto* points = std::get_if<std::vector<Vec3>>(&pin.at))
            return isNamed ? inPart(*points, parts.front()) : inShape(*points);
        return atVertices(std::get<std::vector<int>>(pin.at), isNamed ? parts.front().firstVertex : 0);
    }

  private:
    static std::optional<Place> find(const PointLocator<Dim>& locator, const Vec3& p, int firstCell) {
        const auto found = locator.find(p.head<Dim>(), kOnBorder);
        if (!found) return {};
        Place place = inSpace(*found);
        place.cell += firstCell;
        return place;
    }
    /// Leaves out vertices that no cell has.
    void add(int vertex, PinPlace& place) const {
        if (m_vertices[vertex].cell >= 0) place.points.push_back(m_vertices[vertex]);
    }
    PinPlace atVertices(const std::vector<int>& vertices, int first) const {
        PinPlace place;
        for (const int v : vertices)
            if (v >= 0 && first + v < m_rest.vertexCount()) add(first + v, place);
        return place;
    }
    PinPlace inShape(const std::vector<Vec3>& points) const { return among(points, m_locator, 0); }
    PinPlace inPart(const std::vector<Vec3>& points, const MeshPart& part) const {
        const std::vector<Cell<Dim>> cells(m_rest.cells.begin() + part.firstCell,
                                           m_rest.cells.begin() + part.endCell);
        return among(points, PointLocator<Dim>(m_rest.points, cells), part.firstCell);
    }
    static PinPlace among(const std::vector<Vec3>& points, const PointLocator<Dim>& locator, int firstCell) {
        PinPlace place;
        for (const Vec3& p : points)
            if (const auto found = find(locator, p, firstCell)) place.points.push_back(*found);
        return place;
    }
    PinPlace inRegion(const Region<Dim>& region, const std::vector<MeshPart>& parts) const {
        PinPlace place;
        place.region = true;
        for (std::size_t i = 0; i < parts.size() && place.points.empty(); ++i)
            for (int v = parts[i].firstVertex; v < parts[i].endVertex; ++v)
                if (signedDistance<Dim>(region, m_rest.points.col(v)) <= 0) add(v, place);
        return place;
    }

    const SimplicialMesh<Dim>& m_rest;
    PointLocator<Dim> m_locator;
    std::vector<Place> m_vertices;  // each as a corner of the first cell that has it
};

}  // namespace

std::unique_ptr<const RestPlaces> RestPlaces::of(const ShapeFrame& frame) {
    if (frame.dimension == 2)
        return std::make_unique<RestPlacesOf<2>>(*static_cast<const PosedFrame<2>&>(frame).rest);
    return std::make_unique<RestPlacesOf<3>>(*static_cast<const PosedFrame<3>&>(frame).rest);
}

std::vector<PinPlace> RestPlaces::placesOf(const std::vector<Pin>& pins) const {
    std::vector<PinPlace> places;
    places.reserve(pins.size());
    for (const Pin& pin : pins) places.push_back(placeOf(pin));
    return places;
}

}  // namespace wend
