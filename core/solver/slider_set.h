#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/solver/constraint_rows.h"

namespace wend {

/// Sliders by vertex. If a vertex has several, as on the edge between two planes of symmetry, it is held in
/// all their directions d_j: C x = s with the rows C_j = d_jᵀ, and the held part C⁺ C x.
template <int Dim>
class SliderSet {
  public:
    SliderSet() = default;
    explicit SliderSet(const Sliders& sliders);

    /// A vertex with all directions in which it is held.
    struct Vertex {
        int vertex = -1;
        unsigned held = 0;  // coordinates
        bool isAlongAxes = true;
        Mat<Dim> projector = Mat<Dim>::Zero();  // onto the directions in which it is held
        /// One direction d_j of a vertex.
        struct Row {
            Eigen::Index slider;         // its place in the list
            Vec<Dim> direction, column;  // d_j, and the column of C⁺
            bool isGuided = false;
        };
        std::vector<Row> rows;

        /// Returns the vector of least norm whose parts along the d_j are those of the columns `first` +
        /// slider.
        Vec<Dim> valueOf(const Points<Dim>& prescribed, Eigen::Index first) const;
        /// Moves a point by the least correction to the planes through these columns; along axes to the bit.
        /// Guided sliders do not count.
        void place(const Points<Dim>& targets, Eigen::Index first, Eigen::Ref<Vec<Dim>> p) const;
    };
    /// Returns the vertices in increasing order.
    const std::vector<Vertex>& vertices() const { return m_vertices; }
    Eigen::Index count() const { return m_count; }
    bool empty() const { return m_vertices.empty(); }
    bool areAlongAxes() const;
    /// Returns whether any slider is guided.
    bool areGuided() const;
    /// Removes vertices that are prescribed otherwise.
    void erase(const std::vector<int>& vertices);
    /// Sets the directions of guided sliders, one column per slider.
    void turn(const Points<Dim>& directions);

  private:
    std::vector<Vertex> m_vertices;
    Eigen::Index m_count = 0;  // of sliders
};

}  // namespace wend
