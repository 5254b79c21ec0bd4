#include "app/session/coarse_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/mesh/cell_geometry.h"
#include "core/mesh/error.h"
#include "core/mesh/shape_size.h"
#include "core/meshing/coarse_mesh.h"
#include "core/motion/handle_points.h"

namespace wend {

namespace {

// Vertices from which on a shape's own fields are too slow for a hand, and those of the body.
template <int Dim>
constexpr int kLarge = Dim == 2 ? 16000 : 8000;
template <int Dim>
constexpr int kAim = Dim == 2 ? 5000 : 2000;
// Times as many where so few hold together what is apart.
constexpr int kFiner = 2;
// A body of more than a third of the shape's vertices is not worth its while.
constexpr int kWorthwhile = 3;
// Weights of less are rounding.
constexpr double kNoWeight = 1e-9;

template <int Dim>
Points<Dim> centroids(const SimplicialMesh<Dim>& mesh) {
    Points<Dim> result(Dim, mesh.cellCount());
    for (int c = 0; c < mesh.cellCount(); ++c) result.col(c) = centroid<Dim>(mesh.points, mesh.cells[c]);
    return result;
}

/// Of each cell of the body the mean over the shape's cells in it, by volume; where there is none, what the
/// shape has at the cell's centroid.
template <int Dim>
Material<Dim> coarseMaterial(const Shape<Dim>& shape, const SimplicialMesh<Dim>& body) {
    const SimplicialMesh<Dim>& fine = *shape.rest;
    const Material<Dim>& from = *shape.material;
    const bool anisotropic = !from.anisotropy.empty();
    Material<Dim> material = from;
    material.smoothing.length *=
        shapeSize<Dim>(fine.points, fine.cells).size / shapeSize<Dim>(body.points, body.cells).size;
    material.phi.assign(body.cells.size(), 0);
    if (anisotropic) material.anisotropy.assign(body.cells.size(), Mat<Dim>::Zero());
    std::vector<double> volume(body.cells.size(), 0);
    const auto add = [&](int to, int cell, double part) {
        volume[to] += part;
        material.phi[to] += part * from.phi[cell];
        if (anisotropic) material.anisotropy[to] += part * from.anisotropy[cell];
    };
    const Embedding<Dim> fineCells(body, centroids(fine)), bodyCells(fine, centroids(body));
    for (int c = 0; c < fine.cellCount(); ++c)
        add(fineCells.cell(c), c, std::abs(cellMeasure<Dim>(fine.points, fine.cells[c])));
    for (int c = 0; c < body.cellCount(); ++c) {
        if (volume[c] == 0) add(c, bodyCells.cell(c), 1);
        material.phi[c] /= volume[c];
        if (anisotropic) material.anisotropy[c] /= volume[c];
    }
    return material;
}

template <int Dim>
Mat<Dim> edges(const Points<Dim>& points, const Cell<Dim>& cell) {
    Mat<Dim> result;
    for (int k = 0; k < Dim; ++k) result.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    return result;
}

template <int Dim>
Vec<Dim> inCell(const Points<Dim>& pose, const SimplicialMesh<Dim>& mesh, const Location<Dim>& location) {
    Vec<Dim> p = Vec<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) p += location.weights[k] * pose.col(mesh.cells[location.cell][k]);
    return p;
}

template <int Dim>
Vec<Dim> combined(const Points<Dim>& pose, const std::vector<std::pair<int, double>>& terms) {
    Vec<Dim> p = Vec<Dim>::Zero();
    for (const auto& [vertex, weight] : terms) p += weight * pose.col(vertex);
    return p;
}

}  // namespace

/// What handles hold of the body, one handle after another.
template <int Dim>
class CoarseBody<Dim>::Holding {
  public:
    explicit Holding(const CoarseBody& body)
        : m_body(body),
          m_placer(*body.m_fine, {}),
          m_locator(body.m_rest->points, body.m_rest->cells),
          m_owner(static_cast<std::size_t>(body.m_rest->vertexCount()), -1),
          m_points(body.m_rest->cells.size(), 0) {}

    /// False if it would hold what another one holds already.
    bool take(const Handle<Dim>& handle, int number) {
        const std::vector<ConstrainedPoint> points = m_placer.place(handle.at, number);
        Handle<Dim>& held = m_held.handles.emplace_back(handle);
        const bool single = static_cast<int>(points.size()) <= Dim || points.front().terms.size() > 1;
        if (!single || handle.slides != 0) return takeVertices(points, number, held);
        takePoints(points, held);
        return true;
    }

    /// Where a point's cell has no free vertex left, the point cannot move by itself.
    bool isFree() const {
        for (std::size_t c = 0; c < m_points.size(); ++c) {
            int held = m_points[c];
            for (const int v : m_body.m_rest->cells[c]) held += m_owner[v] >= 0;
            if (m_points[c] > 0 && held > Dim) return false;
        }
        return true;
    }

    Held all() && { return std::move(m_held); }

  private:
    bool takeVertices(const std::vector<ConstrainedPoint>& points, int number, Handle<Dim>& held) {
        std::vector<int> vertices;
        for (const ConstrainedPoint& point : points)
            for (const auto& term : point.terms)
                for (const auto& [v, weight] : m_body.m_shapeInBody.weights(*m_body.m_rest, term.first)) {
                    if (std::abs(weight) < kNoWeight || m_owner[v] == number) continue;
                    if (m_owner[v] >= 0 && held.slides == 0) return false;
                    if (m_owner[v] >= 0) continue;  // what slides is left to those that hold it
                    m_owner[v] = number;
                    vertices.push_back(v);
                }
        const bool any = !vertices.empty();
        held.at = std::move(vertices);
        return any;
    }

    /// One in each cell: those beside it go with it.
    void takePoints(const std::vector<ConstrainedPoint>& points, Handle<Dim>& held) {
        std::vector<Vec<Dim>> places;
        std::vector<int> cells;
        for (const ConstrainedPoint& point : points) {
            const Vec<Dim> p = point.template in<Dim>(m_body.m_fine->points);
            const auto found = m_locator.find(p);
            const int cell = found ? found->cell : m_body.m_shapeInBody.cell(point.terms.front().first);
            if (std::ranges::count(cells, cell)) continue;
            cells.push_back(cell);
            ++m_points[cell];
            const Location<Dim> location = within(cell, p);
            places.push_back(inCell<Dim>(m_body.m_rest->points, *m_body.m_rest, location));
            m_held.pins.push_back({point.terms, location});
        }
        held.at = std::move(places);
    }

    /// Where p is in the cell, or what is near to it where the body does not reach that far.
    Location<Dim> within(int cell, const Vec<Dim>& p) const {
        const auto weights = barycentric<Dim>(m_body.m_rest->points, m_body.m_rest->cells[cell], p);
        return {cell, weights.cwiseMax(0) / weights.cwiseMax(0).sum()};
    }

    const CoarseBody& m_body;
    HandlePlacer<Dim> m_placer;
    PointLocator<Dim> m_locator;
    Held m_held;
    std::vector<int> m_owner;   // of the body's vertices: a handle, or −1
    std::vector<int> m_points;  // in each of its cells
};

template <int Dim>
std::shared_ptr<const CoarseBody<Dim>> CoarseBody<Dim>::of(const Shape<Dim>& shape) {
    const int most = shape.rest->vertexCount() / kWorthwhile;
    if (shape.rest->vertexCount() <= kLarge<Dim>) return nullptr;
    for (const int aim : {kAim<Dim>, kFiner * kAim<Dim>}) try {
            SimplicialMesh<Dim> mesh = coarseMesh<Dim>(*shape.rest, std::min(aim, most));
            if (mesh.vertexCount() <= most) return std::make_shared<const CoarseBody>(shape, std::move(mesh));
        } catch (const InputError&) {  // a finer one may do; else it is dragged as it is
        }
    return nullptr;
}

template <int Dim>
CoarseBody<Dim>::CoarseBody(const Shape<Dim>& shape, SimplicialMesh<Dim> mesh)
    : m_fine(shape.rest),
      m_rest(std::make_shared<const SimplicialMesh<Dim>>(std::move(mesh))),
      m_material(std::make_shared<const Material<Dim>>(coarseMaterial<Dim>(shape, *m_rest))),
      m_shapeInBody(*m_rest, m_fine->points),
      m_bodyInShape(*m_fine, m_rest->points) {}

template <int Dim>
std::optional<typename CoarseBody<Dim>::Held> CoarseBody<Dim>::held(
    const std::vector<Handle<Dim>>& handles) const try {
    Holding holding(*this);
    for (std::size_t h = 0; h < handles.size(); ++h)
        if (!holding.take(handles[h], static_cast<int>(h))) return std::nullopt;
    if (!holding.isFree()) return std::nullopt;
    return std::move(holding).all();
} catch (const InputError&) {  // the shape's own flow says what is wrong
    return std::nullopt;
}

template <int Dim>
std::optional<typename CoarseBody<Dim>::Ride> CoarseBody<Dim>::begin(const Points<Dim>& pose) const {
    Ride ride{m_bodyInShape.carry(*m_fine, pose), pose, {}};
    for (const Cell<Dim>& cell : m_rest->cells)
        if (!(cellMeasure<Dim>(ride.body, cell) * cellMeasure<Dim>(m_rest->points, cell) > 0))
            return std::nullopt;
    ride.ahead = pose - m_shapeInBody.interpolate(*m_rest, ride.body);
    return ride;
}

template <int Dim>
Points<Dim> CoarseBody<Dim>::carried(const Ride& ride, const Points<Dim>& body,
                                     const std::vector<Pin>& pins) const {
    std::vector<Mat<Dim>> gradients(m_rest->cells.size());
    for (std::size_t c = 0; c < gradients.size(); ++c)
        gradients[c] = edges<Dim>(body, m_rest->cells[c]) * edges<Dim>(ride.body, m_rest->cells[c]).inverse();
    Points<Dim> pose = m_shapeInBody.interpolate(*m_rest, body);
    for (int v = 0; v < m_fine->vertexCount(); ++v)
        pose.col(v) += gradients[static_cast<std::size_t>(m_shapeInBody.cell(v))] * ride.ahead.col(v);
    for (const Pin& pin : pins) {
        const Vec<Dim> gone = inCell<Dim>(body - ride.body, *m_rest, pin.inBody),
                       missing = gone - combined<Dim>(pose - ride.shape, pin.inShape);
        double squares = 0;
        for (const auto& term : pin.inShape) squares += term.second * term.second;
        for (const auto& [vertex, weight] : pin.inShape) pose.col(vertex) += weight / squares * missing;
    }
    return pose;
}

template class CoarseBody<2>;
template class CoarseBody<3>;

}  // namespace wend
