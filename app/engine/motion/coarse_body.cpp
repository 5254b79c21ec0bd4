#include "app/engine/motion/coarse_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/mesh/cell_geometry.h"
#include "core/mesh/decompositions.h"
#include "core/mesh/shape_size.h"
#include "core/meshing/coarse_mesh.h"
#include "core/motion/handle_points.h"

namespace wend {

namespace {

// Number of vertices above which a drag uses the coarse body, and the number of vertices of that body.
template <int Dim>
constexpr int kLarge = Dim == 2 ? 16000 : 8000;
template <int Dim>
constexpr int kAim = Dim == 2 ? 5000 : 2000;
// The same for a solid that springs back fully, which takes several factors for a frame.
constexpr int kLargeElastic = 2500, kAimElastic = 1500;
// Factor on the number of vertices where too few of them connect separate parts.
constexpr int kFiner = 2;
// A body is not used if it has more than this fraction of the shape's vertices.
constexpr int kWorthwhile = 3;
// Weights of less are rounding.
constexpr double kNoWeight = 1e-9;
// Relative to the largest second moment of the vertices: below it they are coplanar or collinear.
constexpr double kFlatBody = 1e-4;
// Rounds in which folded cells are taken apart.
constexpr int kUnfoldings = 20;

template <int Dim>
Points<Dim> centroids(const SimplicialMesh<Dim>& mesh) {
    Points<Dim> result(Dim, mesh.cellCount());
    for (int c = 0; c < mesh.cellCount(); ++c) result.col(c) = centroid<Dim>(mesh.points, mesh.cells[c]);
    return result;
}

/// Returns the cells of the other mesh that contain the centroids of this mesh's cells.
template <int Dim>
std::vector<int> cellsIn(const SimplicialMesh<Dim>& other, const SimplicialMesh<Dim>& mesh) {
    const Embedding<Dim> middles(other, centroids(mesh));
    std::vector<int> cells;
    for (int c = 0; c < mesh.cellCount(); ++c) cells.push_back(middles.cell(c));
    return cells;
}

template <int Dim>
std::vector<std::vector<int>> neighboursIn(const SimplicialMesh<Dim>& mesh) {
    std::vector<std::set<int>> sets(static_cast<std::size_t>(mesh.vertexCount()));
    for (const Cell<Dim>& cell : mesh.cells)
        for (const int a : cell)
            for (const int b : cell)
                if (a != b) sets[a].insert(b);
    std::vector<std::vector<int>> neighbours;
    for (const auto& set : sets) neighbours.emplace_back(set.begin(), set.end());
    return neighbours;
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

/// Returns the affine map that takes the points to their other places, by least squares.
template <int Dim>
AffineMap<Dim> mapBetween(const Points<Dim>& from, const Points<Dim>& to, const std::vector<int>& vertices) {
    Vec<Dim> a = Vec<Dim>::Zero(), b = Vec<Dim>::Zero();
    for (const int v : vertices) a += from.col(v), b += to.col(v);
    a /= static_cast<double>(vertices.size()), b /= static_cast<double>(vertices.size());
    Mat<Dim> moments = Mat<Dim>::Zero(), mixed = Mat<Dim>::Zero();
    for (const int v : vertices) {
        const Vec<Dim> p = from.col(v) - a;
        moments += p * p.transpose();
        mixed += (to.col(v) - b) * p.transpose();
    }
    const Mat<Dim> A = mixed * moments.inverse();
    return {A, b - A * a};
}

}  // namespace

/// The part of the body that handles hold.
template <int Dim>
class CoarseBody<Dim>::Holding {
  public:
    explicit Holding(const CoarseBody& body)
        : m_body(body),
          m_placer(*body.m_fine, {}),
          m_locator(body.m_rest->points, body.m_rest->cells),
          m_owner(static_cast<std::size_t>(body.m_rest->vertexCount()), -1),
          m_most(m_owner.size(), 0),
          m_points(body.m_rest->cells.size(), 0) {}

    void take(const Handle<Dim>& handle) {
        const int number = static_cast<int>(m_held.handles.size());
        const std::vector<ConstrainedPoint> points = m_placer.place(handle, number);
        m_held.handles.push_back(handle);
        const bool single = static_cast<int>(points.size()) <= Dim || points.front().terms.size() > 1;
        if (single && !handle.isPartlyHeld()) return takePoints(points, m_held.handles.back());
        std::vector<int>& vertices = m_wholes.emplace_back(number, std::vector<int>()).second;
        for (const ConstrainedPoint& point : points) vertices.push_back(point.terms.front().first);
        claim(vertices, number);
    }

    /// Returns false if the body cannot move the handles independently, cannot rotate one of them, or has
    /// other points on a surface than the shape.
    bool settle() {
        for (const Handle<Dim>& handle : m_held.handles)
            if (handle.slide) return false;
        for (auto& [number, vertices] : m_wholes) {
            std::vector<int> own;
            for (std::size_t v = 0; v < m_owner.size(); ++v)
                if (m_owner[v] == number) own.push_back(static_cast<int>(v));
            Handle<Dim>& handle = m_held.handles[static_cast<std::size_t>(number)];
            if (own.empty() || (!handle.isPartlyHeld() && !spans(own))) return false;
            if (!handle.isPartlyHeld()) m_held.parts.push_back({std::move(vertices), own});
            handle.at = std::move(own);
        }
        return isFree();
    }

    Held all() && { return std::move(m_held); }

  private:
    /// Assigns vertices to the handle; sliding handles only get vertices that no other handle needs.
    void claim(const std::vector<int>& vertices, int number) {
        const bool slides = m_held.handles[static_cast<std::size_t>(number)].isPartlyHeld();
        std::map<int, double> wanted;
        for (const int vertex : vertices)
            for (const auto& [v, weight] : m_body.m_shapeInBody.weights(*m_body.m_rest, vertex))
                if (std::abs(weight) > kNoWeight) wanted[v] += slides ? kNoWeight : std::abs(weight);
        for (const auto& [v, weight] : wanted) {
            if (weight <= m_most[v]) continue;
            m_most[v] = weight;
            m_owner[v] = number;
        }
    }

    /// Returns whether the vertices determine a rotation of space.
    bool spans(const std::vector<int>& vertices) const {
        Points<Dim> points(Dim, static_cast<Eigen::Index>(vertices.size()));
        for (std::size_t i = 0; i < vertices.size(); ++i)
            points.col(static_cast<Eigen::Index>(i)) = m_body.m_rest->points.col(vertices[i]);
        points.colwise() -= points.rowwise().mean().eval();
        const Vec<Dim> values = singularValues<Dim>(points * points.transpose());
        return static_cast<int>(vertices.size()) > Dim && values[Dim - 1] > kFlatBody * values[0];
    }

    /// Returns whether every held point has a free vertex in its cell, so that it can move by itself.
    bool isFree() const {
        for (std::size_t c = 0; c < m_points.size(); ++c) {
            int held = m_points[c];
            for (const int v : m_body.m_rest->cells[c]) held += m_owner[v] >= 0;
            if (m_points[c] > 0 && held > Dim) return false;
        }
        return true;
    }

    /// Holds one point per cell; its neighbours follow.
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

    /// Returns the location of p in the cell, or the nearest one if the body does not reach that far.
    Location<Dim> within(int cell, const Vec<Dim>& p) const {
        const auto weights = barycentric<Dim>(m_body.m_rest->points, m_body.m_rest->cells[cell], p);
        return {cell, weights.cwiseMax(0) / weights.cwiseMax(0).sum()};
    }

    const CoarseBody& m_body;
    HandlePlacer<Dim> m_placer;
    PointLocator<Dim> m_locator;
    Held m_held;
    std::vector<std::pair<int, std::vector<int>>> m_wholes;  // handles, and their vertices of the shape
    std::vector<int> m_owner;                                // of the body's vertices: a handle, or −1
    std::vector<double> m_most;                              // and the weight of that handle
    std::vector<int> m_points;                               // in each of its cells
};

template <int Dim>
std::shared_ptr<const CoarseBody<Dim>> CoarseBody<Dim>::of(const Shape<Dim>& shape) {
    const int most = shape.rest->vertexCount() / kWorthwhile;
    const bool takesFactors = Dim == 3 && std::isinf(shape.material->memory);
    const int large = takesFactors ? kLargeElastic : kLarge<Dim>;
    const int first = takesFactors ? kAimElastic : kAim<Dim>;
    if (shape.rest->vertexCount() <= large || !shape.rest->parts.empty()) return nullptr;
    for (const int aim : {first, kFiner * first}) try {
            SimplicialMesh<Dim> mesh = coarseMesh<Dim>(*shape.rest, std::min(aim, most));
            if (mesh.vertexCount() <= most) return std::make_shared<const CoarseBody>(shape, std::move(mesh));
        } catch (const InputError&) {  // a finer body may work; otherwise the shape itself is dragged
        }
    return nullptr;
}

template <int Dim>
CoarseBody<Dim>::CoarseBody(const Shape<Dim>& shape, SimplicialMesh<Dim> mesh)
    : m_fine(shape.rest),
      m_rest(std::make_shared<const SimplicialMesh<Dim>>(std::move(mesh))),
      m_neighbours(neighboursIn<Dim>(*m_rest)),
      m_shapeInBody(*m_rest, m_fine->points),
      m_bodyInShape(*m_fine, m_rest->points),
      m_cellsInBody(cellsIn<Dim>(*m_rest, *m_fine)),
      m_bodyCells(cellsIn<Dim>(*m_fine, *m_rest)) {
    m_material = std::make_shared<const Material<Dim>>(coarse(*shape.material));
}

template <int Dim>
std::shared_ptr<const CoarseBody<Dim>> CoarseBody<Dim>::with(const Material<Dim>& material) const {
    auto other = std::make_shared<CoarseBody>(*this);
    other->m_material = std::make_shared<const Material<Dim>>(coarse(material));
    return other;
}

/// Averages the shape's material over each cell of the body, weighted by volume. A cell without any takes the
/// material at its centroid.
template <int Dim>
Material<Dim> CoarseBody<Dim>::coarse(const Material<Dim>& from) const {
    const bool anisotropic = !from.anisotropy.empty();
    Material<Dim> material = from;
    material.smoothing.length *= shapeSize<Dim>(m_fine->points, m_fine->cells).size /
                                 shapeSize<Dim>(m_rest->points, m_rest->cells).size;
    material.phi.assign(m_rest->cells.size(), 0);
    if (anisotropic) material.anisotropy.assign(m_rest->cells.size(), Mat<Dim>::Zero());
    std::vector<double> volume(m_rest->cells.size(), 0);
    const auto add = [&](int to, int cell, double part) {
        volume[to] += part;
        material.phi[to] += part * from.phi[cell];
        if (anisotropic) material.anisotropy[to] += part * from.anisotropy[cell];
    };
    for (int c = 0; c < m_fine->cellCount(); ++c)
        add(m_cellsInBody[c], c, std::abs(cellMeasure<Dim>(m_fine->points, m_fine->cells[c])));
    for (int c = 0; c < m_rest->cellCount(); ++c) {
        if (volume[c] == 0) add(c, m_bodyCells[c], 1);
        material.phi[c] /= volume[c];
        if (anisotropic) material.anisotropy[c] /= volume[c];
    }
    return material;
}

template <int Dim>
std::optional<typename CoarseBody<Dim>::Held> CoarseBody<Dim>::held(
    const std::vector<Handle<Dim>>& handles) const try {
    Holding holding(*this);
    for (const Handle<Dim>& handle : handles) holding.take(handle);
    if (!holding.settle()) return std::nullopt;
    return std::move(holding).all();
} catch (const InputError&) {  // the flow of the shape itself reports the error
    return std::nullopt;
}

template <int Dim>
std::vector<int> CoarseBody<Dim>::foldedCells(const Points<Dim>& body) const {
    std::vector<int> folded;
    for (int c = 0; c < m_rest->cellCount(); ++c) {
        const Cell<Dim>& cell = m_rest->cells[c];
        if (!(cellMeasure<Dim>(body, cell) * cellMeasure<Dim>(m_rest->points, cell) > 0)) folded.push_back(c);
    }
    return folded;
}

template <int Dim>
std::optional<typename CoarseBody<Dim>::Ride> CoarseBody<Dim>::begin(const Points<Dim>& pose) const {
    Ride ride{m_bodyInShape.carry(*m_fine, pose), pose, {}};
    for (int round = 0; round < kUnfoldings; ++round)
        for (const int cell : foldedCells(ride.body))
            for (const int v : m_rest->cells[cell])
                ride.body.col(v) =
                    mapBetween<Dim>(m_rest->points, ride.body, m_neighbours[v])(m_rest->points.col(v));
    if (!foldedCells(ride.body).empty()) return std::nullopt;
    ride.ahead = pose - m_shapeInBody.interpolate(*m_rest, ride.body);
    return ride;
}

template <int Dim>
Points<Dim> CoarseBody<Dim>::carried(const Ride& ride, const Points<Dim>& body, const Held& held) const {
    std::vector<Mat<Dim>> gradients(m_rest->cells.size());
    for (std::size_t c = 0; c < gradients.size(); ++c)
        gradients[c] = edges<Dim>(body, m_rest->cells[c]) * edges<Dim>(ride.body, m_rest->cells[c]).inverse();
    Points<Dim> pose = m_shapeInBody.interpolate(*m_rest, body);
    for (int v = 0; v < m_fine->vertexCount(); ++v)
        pose.col(v) += gradients[static_cast<std::size_t>(m_shapeInBody.cell(v))] * ride.ahead.col(v);
    for (const Part& part : held.parts) {
        const AffineMap<Dim> map = mapBetween<Dim>(ride.body, body, part.inBody);
        for (const int v : part.inShape) pose.col(v) = map(ride.shape.col(v));
    }
    for (const Pin& pin : held.pins) {
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
