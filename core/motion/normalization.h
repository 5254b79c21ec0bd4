#pragma once

#include "core/mesh/simplicial_mesh.h"
#include "core/motion/handle.h"

namespace wend {

/// x̂ = (x − c) / D with the centre c and the diagonal D of the rest shape's bounding box (over the vertices
/// that cells have): the frame that the
/// deformation is computed in, where a tolerance or a smoothing length means the same for every shape.
template <int Dim>
struct Normalization {
    Vec<Dim> centre = Vec<Dim>::Zero();
    double diagonal = 1;

    static Normalization of(const SimplicialMesh<Dim>& rest);

    Vec<Dim> normal(const Vec<Dim>& p) const { return (p - centre) / diagonal; }
    Vec<Dim> domain(const Vec<Dim>& p) const { return centre + diagonal * p; }
    Points<Dim> normal(const Points<Dim>& points) const { return (points.colwise() - centre) / diagonal; }
    Handle<Dim> normal(const Handle<Dim>& handle) const;
};

}  // namespace wend
