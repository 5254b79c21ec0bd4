#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/session/shape/shape.h"
#include "core/motion/handle.h"

namespace wend {

/// The coarser body in which a large shape rides while a hand drags it: a field of the shape's own takes a
/// tenth of a second to a second there, one of the body a few milliseconds. The body keeps what the shape
/// keeps, place by place.
template <int Dim>
class CoarseBody {
  public:
    /// Null where the shape is small enough to be dragged as it is, or no such body can be made.
    static std::shared_ptr<const CoarseBody> of(const Shape<Dim>& shape);
    CoarseBody(const Shape<Dim>& shape, SimplicialMesh<Dim> mesh);
    /// The same body where the same mesh has another material: no place is looked for again.
    std::shared_ptr<const CoarseBody> with(const Material<Dim>& material) const;

    const std::shared_ptr<const SimplicialMesh<Dim>>& rest() const { return m_rest; }
    const std::shared_ptr<const Material<Dim>>& material() const { return m_material; }

    /// A point that a handle holds: a combination of the shape's vertices, and one of the body's.
    struct Pin {
        std::vector<std::pair<int, double>> inShape;
        Location<Dim> inBody;
    };
    /// What a handle holds as a whole: vertices of both.
    struct Part {
        std::vector<int> inShape, inBody;
    };
    /// The shape's handles as handles of the body: what holds many vertices holds those of the body that they
    /// depend on (of two handles the one that needs one most has it), single points hold points in its cells.
    struct Held {
        std::vector<Handle<Dim>> handles;
        std::vector<Pin> pins;
        std::vector<Part> parts;
    };
    /// Nothing where one of them has no place, or two are so near to each other that the body could not move
    /// one without the other.
    std::optional<Held> held(const std::vector<Handle<Dim>>& handles) const;

    /// Where body and shape are when a ride begins.
    struct Ride {
        Points<Dim> body, shape;
        Points<Dim> ahead;  // of the shape's vertices: from where the body's cells have them
    };
    /// Nothing where the body would be folded in that pose of the shape, even after its vertices there went
    /// to where those around have them.
    std::optional<Ride> begin(const Points<Dim>& pose) const;
    /// The shape's pose in a pose of the body: x = Σ w X + F F₀⁻¹ a, with the weights of the cell at rest,
    /// its gradient F, F₀ at the ride's beginning, and what the vertex was ahead then. That is the pose in
    /// which the ride began, but for rounding, and turns and shears with the body. What is held is exact: a
    /// part goes as the body's vertices that it holds do, and the vertices around a pin go so much further
    /// that it has gone as far as the body's point has.
    Points<Dim> carried(const Ride& ride, const Points<Dim>& body, const Held& held = {}) const;

  private:
    class Holding;
    Material<Dim> coarse(const Material<Dim>& material) const;
    std::vector<int> foldedCells(const Points<Dim>& body) const;

    std::shared_ptr<const SimplicialMesh<Dim>> m_fine, m_rest;
    std::shared_ptr<const Material<Dim>> m_material;
    std::vector<std::vector<int>> m_neighbours;   // of the body's vertices
    Embedding<Dim> m_shapeInBody, m_bodyInShape;  // the vertices of one in the other
    std::vector<int> m_cellsInBody, m_bodyCells;  // where the middles of one's cells are in the other
};

}  // namespace wend
