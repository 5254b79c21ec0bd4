#pragma once

#include <span>

#include "core/assembly/assembly_plan.h"
#include "core/assembly/stage_vectors.h"
#include "core/solver/constraint_rows.h"
#include "core/solver/slider_set.h"

namespace wend {

/// Represents K = Zᵀ A Z for constraints that are eliminated, v = Z y + v_p: which block of A contributes
/// with which coefficient to which block of K is decided once, if the plan lists blocks. Without barycentric
/// rows K is a part of A. In a direction in which a vertex is held, y is 0 and K has nothing but its
/// diagonal.
template <int Dim>
class ReducedSystem {
  public:
    ReducedSystem() = default;
    /// Sliders whose vertex is a pivot are ignored.
    ReducedSystem(const AssemblyPlan<Dim>& plan, const Elimination& elimination, const Sliders& sliders = {});

    /// Returns the vertex of every block of unknowns.
    const std::vector<int>& unknowns() const { return m_unknowns; }
    const Elimination& elimination() const { return m_elimination; }
    /// Returns the coordinates in which an unknown is held, one bit each; empty if none is.
    const std::vector<unsigned>& held() const { return m_held; }

    /// Returns the unknown that is a vertex's own, or −1.
    int unknownOf(int vertex) const { return m_unknownOf[static_cast<std::size_t>(vertex)]; }
    /// Calls visit(unknown, coefficient) for the row of Z of a vertex.
    template <typename Visit>
    void forUnknowns(int vertex, Visit&& visit) const;

    /// Return the scalar pattern of the lower triangle of K by columns (its diagonal blocks are full). If the
    /// plan does not list its contributions, it is empty and gather() is impossible.
    const std::vector<int>& columnStart() const { return m_columnStart; }
    const std::vector<int>& row() const { return m_row; }

    /// Computes the values of K in that pattern, from the blocks of A in the plan's order.
    void gather(std::span<const double> blocksOfA, std::span<double> values) const;
    /// Computes v_p, the field that moves the constrained vertices while all free ones rest. `prescribed` has
    /// a column per row and may have one per slider behind them, of which the held part counts.
    void particular(const Points<Dim>& prescribed, Points<Dim>& v) const;
    /// Computes v = Z y + v_p with y from another field; v is v_p on entry.
    void adopt(const Points<Dim>& field, Points<Dim>& v) const;
    /// Computes v += Z y.
    void expand(const Points<Dim>& y, Points<Dim>& v) const;
    /// Computes Zᵀ f, one column per unknown vertex.
    void restrict(const Points<Dim>& f, Points<Dim>& reduced) const;
    const SliderSet<Dim>& sliders() const { return m_sliders; }
    /// Sets the directions of guided sliders, one column per slider, and returns those before. Null means the
    /// initial ones. The pattern of K does not depend on them.
    Nodal<Dim> setDirections(Nodal<Dim> directions);
    const Nodal<Dim>& directions() const { return m_directions; }
    /// Removes the parts in held directions from a field of unknowns.
    void release(Points<Dim>& y) const;

  private:
    /// One contribution of a block of A to a block of K.
    struct Term {  // K_PQ += coefficient · A_block, or its transpose
        int block;
        bool transposed;
        double coefficient;
    };
    void numberUnknowns(const AssemblyPlan<Dim>& plan);
    Eigen::Index rowCount() const;
    void buildPattern(const AssemblyPlan<Dim>& plan);
    bool holds(std::size_t unknown, int coordinate) const {
        return !m_held.empty() && (m_held[unknown] >> coordinate & 1U) != 0;
    }
    void release(std::size_t row, std::size_t column, Mat<Dim>& K) const;
    void placeProjectors();

    Elimination m_elimination;
    std::vector<int> m_unknowns, m_unknownOf, m_pivotOf;  // the last two per vertex, −1: none
    std::vector<unsigned> m_held;                         // per unknown; empty: none slides
    std::vector<Mat<Dim>> m_projectors;     // per unknown, onto held directions across the axes; empty: none
    SliderSet<Dim> m_sliders;               // that are no pivots
    Nodal<Dim> m_directions;                // of guided ones
    std::vector<int> m_columnStart, m_row;  // scalar
    std::vector<int> m_blockStart, m_termStart;  // block columns; terms per block
    std::vector<Term> m_terms;
};

template <int Dim>
template <typename Visit>
void ReducedSystem<Dim>::forUnknowns(int vertex, Visit&& visit) const {
    if (m_unknownOf[vertex] >= 0) visit(m_unknownOf[vertex], 1.0);
    if (m_pivotOf[vertex] < 0) return;
    for (const auto& [other, weight] : m_elimination.pivots[m_pivotOf[vertex]].free)
        if (m_unknownOf[other] >= 0) visit(m_unknownOf[other], -weight);
}

}  // namespace wend
