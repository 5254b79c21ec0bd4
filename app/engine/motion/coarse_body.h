#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/engine/shape/shape.h"
#include "core/motion/handle.h"

namespace wend {

/// A coarse body that carries a large shape during a drag. A velocity field of the shape takes 0.1 s to 1 s,
/// one of the body a few milliseconds. The body has the material of the shape.
template <int Dim>
class CoarseBody {
  public:
    /// Returns null if the shape is small enough to be dragged directly, or if no body can be made.
    static std::shared_ptr<const CoarseBody> of(const Shape<Dim>& shape);
    CoarseBody(const Shape<Dim>& shape, SimplicialMesh<Dim> mesh);
    /// Returns this body with another material of the same mesh; reuses all locations.
    std::shared_ptr<const CoarseBody> with(const Material<Dim>& material) const;

    const std::shared_ptr<const SimplicialMesh<Dim>>& rest() const { return m_rest; }
    const std::shared_ptr<const Material<Dim>>& material() const { return m_material; }

    /// A point held by a handle, as a combination of vertices of the shape and of the body.
    struct Pin {
        std::vector<std::pair<int, double>> inShape;
        Location<Dim> inBody;
    };
    /// The vertices that a handle holds rigidly, in both meshes.
    struct Part {
        std::vector<int> inShape, inBody;
    };
    /// Handles of the shape mapped to the body. A handle of many vertices holds the body's vertices that they
    /// depend on (the handle with the largest weight wins); single points are held inside cells.
    struct Held {
        std::vector<Handle<Dim>> handles;
        std::vector<Pin> pins;
        std::vector<Part> parts;
    };
    /// Returns nothing if a handle has no place in the body, or if two of them cannot move independently.
    std::optional<Held> held(const std::vector<Handle<Dim>>& handles) const;

    /// Poses of body and shape at the start of a drag.
    struct Ride {
        Points<Dim> body, shape;
        Points<Dim> ahead;  // offset of each of the shape's vertices from its place in the body
    };
    /// Returns nothing if the body would be inverted in this pose, even after moving the affected vertices to
    /// the mean of their neighbours.
    std::optional<Ride> begin(const Points<Dim>& pose) const;
    /// Maps a pose of the body to the shape: x = Σ w X + F F₀⁻¹ a, with the rest weights w of the vertex in
    /// its cell, the cell's deformation gradient F, its value F₀ at the start of the drag, and the vertex's
    /// offset a at that time. It reproduces the start pose up to rounding and rotates and shears with the
    /// body. Held points are exact: a rigid part follows the body's vertices that it holds, and vertices
    /// around a pin are corrected by the remaining error of the pin.
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
