#pragma once

#include "core/mesh/simplicial_mesh.h"
#include "core/motion/handle.h"

namespace wend {

/// The map x̂ = (x − c) / s with the centroid c and the size s of the rest shape (ShapeSize): the
/// computational frame, in which a tolerance or a smoothing length means the same for every shape in every
/// orientation.
template <int Dim>
struct Normalization {
    Vec<Dim> centre = Vec<Dim>::Zero();
    double size = 1;

    /// Returns the normalization of a rest mesh.
    static Normalization of(const SimplicialMesh<Dim>& rest);

    /// Returns x̂, in the frame of the computation.
    Vec<Dim> normal(const Vec<Dim>& p) const { return (p - centre) / size; }
    /// Returns x, in the domain's coordinates.
    Vec<Dim> domain(const Vec<Dim>& p) const { return centre + size * p; }
    Points<Dim> normal(const Points<Dim>& points) const { return (points.colwise() - centre) / size; }
    SimplicialMesh<Dim> normal(const SimplicialMesh<Dim>& mesh) const {
        return {normal(mesh.points), mesh.cells, mesh.parts, mesh.welds};
    }
    /// Returns the handle in the frame: its positions, lengths and guides; angles, times and factors stay as
    /// they are.
    Handle<Dim> normal(const Handle<Dim>& handle) const;
};

}  // namespace wend
