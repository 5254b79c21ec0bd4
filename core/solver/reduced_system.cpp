#include "core/solver/reduced_system.h"

#include <algorithm>

namespace wend {
namespace {

/// A term on its way to its block of K.
struct Target {
    int row, block;
    bool transposed;
    double coefficient;
};

}  // namespace

template <int Dim>
ReducedSystem<Dim>::ReducedSystem(const AssemblyPlan<Dim>& plan, const Elimination& elimination,
                                  const Sliders& sliders)
    : m_elimination(elimination), m_sliders(sliders) {
    numberUnknowns(plan);
    std::vector<int> pivots;
    for (const auto& pivot : m_elimination.pivots) pivots.push_back(pivot.vertex);
    std::ranges::sort(pivots);
    m_sliders.erase(pivots);
    if (!m_sliders.empty()) m_held.assign(m_unknowns.size(), 0);
    if (!m_sliders.areAlongAxes()) m_projectors.assign(m_unknowns.size(), Mat<Dim>::Zero());
    placeProjectors();
    if (!plan.columnStart.empty()) buildPattern(plan);
}

template <int Dim>
void ReducedSystem<Dim>::placeProjectors() {
    for (const auto& slider : m_sliders.vertices()) {
        if (m_unknownOf[slider.vertex] < 0) continue;
        const auto unknown = static_cast<std::size_t>(m_unknownOf[slider.vertex]);
        if (slider.isAlongAxes)
            m_held[unknown] = slider.held;
        else
            m_projectors[unknown] = slider.projector;
    }
}

template <int Dim>
Nodal<Dim> ReducedSystem<Dim>::setDirections(Nodal<Dim> directions) {
    if (directions && directions != m_directions) {
        m_sliders.turn(*directions);
        placeProjectors();
    }
    return std::exchange(m_directions, std::move(directions));
}

/// Takes out of a block what couples held coordinates. With the projectors P onto the held directions it
/// becomes (I − P_row) K (I − P_column), plus P K P on the diagonal, which keeps K positive definite: y is 0
/// in these directions, so that the values there do not matter.
template <int Dim>
void ReducedSystem<Dim>::release(std::size_t row, std::size_t column, Mat<Dim>& K) const {
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            if ((holds(row, i) || holds(column, j)) && !(row == column && i == j)) K(i, j) = 0;
    if (m_projectors.empty()) return;
    const Mat<Dim>&left = m_projectors[row], &right = m_projectors[column];
    const Mat<Dim> free = K - left * K - K * right + left * K * right;
    K = row == column ? Mat<Dim>(free + left * K * right) : free;
}

template <int Dim>
void ReducedSystem<Dim>::release(Points<Dim>& y) const {
    for (std::size_t P = 0; P < m_held.size(); ++P)
        for (int k = 0; k < Dim; ++k)
            if (holds(P, k)) y(k, static_cast<Eigen::Index>(P)) = 0;
    for (std::size_t P = 0; P < m_projectors.size(); ++P) {
        const Vec<Dim> own = y.col(static_cast<Eigen::Index>(P));
        y.col(static_cast<Eigen::Index>(P)) = own - m_projectors[P] * own;
    }
}

/// Unknown are the vertices that have a cell and are no pivot, in their order.
template <int Dim>
void ReducedSystem<Dim>::numberUnknowns(const AssemblyPlan<Dim>& plan) {
    m_pivotOf.assign(plan.vertexCount, -1);
    m_unknownOf.assign(plan.vertexCount, -1);
    for (std::size_t i = 0; i < m_elimination.pivots.size(); ++i)
        m_pivotOf[m_elimination.pivots[i].vertex] = static_cast<int>(i);
    for (int v = 0; v < plan.vertexCount; ++v) {
        if (m_pivotOf[v] >= 0 || plan.cornerStart[v] == plan.cornerStart[v + 1]) continue;
        m_unknownOf[v] = static_cast<int>(m_unknowns.size());
        m_unknowns.push_back(v);
    }
}

/// Builds the pattern of K_PQ = Σ z_pP z_qQ A_pq over all ordered pairs (p, q); A_qp = A_pqᵀ gives the upper
/// triangle. A row of Z has one entry for an unknown vertex, and one per free vertex of its row for a pivot,
/// so a block of A contributes to few blocks of K. Terms keep the order of the plan's blocks within a block
/// of K, which makes the sums repeatable.
template <int Dim>
void ReducedSystem<Dim>::buildPattern(const AssemblyPlan<Dim>& plan) {
    std::vector<std::vector<Target>> columns(m_unknowns.size());
    const auto add = [&](const auto& rowP, const auto& rowQ, int block, bool transposed) {
        for (const auto& [P, zP] : rowP)
            for (const auto& [Q, zQ] : rowQ)
                if (P >= Q) columns[Q].push_back({P, block, transposed, zP * zQ});
    };
    std::vector<std::vector<std::pair<int, double>>> Z(plan.vertexCount);
    for (int v = 0; v < plan.vertexCount; ++v)
        forUnknowns(v, [&](int unknown, double z) { Z[v].emplace_back(unknown, z); });
    for (int q = 0; q < plan.vertexCount; ++q)
        for (int b = plan.columnStart[q]; b < plan.columnStart[q + 1]; ++b) {
            const int p = plan.row[b];
            add(Z[p], Z[q], b, false);
            if (p != q) add(Z[q], Z[p], b, true);
        }
    m_columnStart.push_back(0);
    m_blockStart.push_back(0);
    for (auto& column : columns) {
        std::stable_sort(column.begin(), column.end(),
                         [](const auto& a, const auto& b) { return a.row < b.row; });
        std::vector<int> blockRows;
        for (const auto& target : column) {
            if (blockRows.empty() || blockRows.back() != target.row) {
                blockRows.push_back(target.row);
                m_termStart.push_back(static_cast<int>(m_terms.size()));
            }
            m_terms.push_back({target.block, target.transposed, target.coefficient});
        }
        m_blockStart.push_back(m_blockStart.back() + static_cast<int>(blockRows.size()));
        for (int k = 0; k < Dim; ++k) {
            for (int P : blockRows)
                for (int i = 0; i < Dim; ++i) m_row.push_back(P * Dim + i);
            m_columnStart.push_back(static_cast<int>(m_row.size()));
        }
    }
    m_termStart.push_back(static_cast<int>(m_terms.size()));
}

/// Sums the terms of every block, and writes its lower triangle into the scalar pattern.
template <int Dim>
void ReducedSystem<Dim>::gather(std::span<const double> blocksOfA, std::span<double> values) const {
    for (std::size_t Q = 0; Q < m_unknowns.size(); ++Q) {
        const int first = m_blockStart[Q], blocks = m_blockStart[Q + 1] - first, stride = blocks * Dim;
        for (int i = 0; i < blocks; ++i) {
            Mat<Dim> K = Mat<Dim>::Zero();
            for (int t = m_termStart[first + i]; t < m_termStart[first + i + 1]; ++t) {
                const auto& term = m_terms[t];
                const Eigen::Map<const Mat<Dim>> A(blocksOfA.data() + term.block * Dim * Dim);
                if (term.transposed)
                    K += term.coefficient * A.transpose();
                else
                    K += term.coefficient * A;
            }
            if (!m_held.empty()) {
                const int scalarRow = m_row[static_cast<std::size_t>(m_columnStart[Q * Dim]) +
                                            static_cast<std::size_t>(i) * Dim];
                release(static_cast<std::size_t>(scalarRow / Dim), Q, K);
            }
            double* out = values.data() + static_cast<std::ptrdiff_t>(first) * Dim * Dim + i * Dim;
            for (int k = 0; k < Dim; ++k)
                for (int j = 0; j < Dim; ++j) out[k * stride + j] = K(j, k);
        }
    }
}

template <int Dim>
void ReducedSystem<Dim>::particular(const Points<Dim>& prescribed, Points<Dim>& v) const {
    v.setZero(Dim, static_cast<Eigen::Index>(m_unknownOf.size()));
    for (const auto& pivot : m_elimination.pivots)
        for (const auto& [row, value] : pivot.values) v.col(pivot.vertex) += value * prescribed.col(row);
    const Eigen::Index first = rowCount();
    if (m_sliders.empty() || prescribed.cols() < first + m_sliders.count()) return;
    for (const auto& slider : m_sliders.vertices()) v.col(slider.vertex) = slider.valueOf(prescribed, first);
    for (const auto& pivot : m_elimination.pivots)
        for (const auto& [other, weight] : pivot.free) v.col(pivot.vertex) -= weight * v.col(other);
}

template <int Dim>
Eigen::Index ReducedSystem<Dim>::rowCount() const {
    return static_cast<Eigen::Index>(m_elimination.pivots.size() + m_elimination.dependent.size());
}

template <int Dim>
void ReducedSystem<Dim>::adopt(const Points<Dim>& field, Points<Dim>& v) const {
    Points<Dim> y(Dim, static_cast<Eigen::Index>(m_unknowns.size()));
    for (std::size_t P = 0; P < m_unknowns.size(); ++P)
        y.col(static_cast<Eigen::Index>(P)) = field.col(m_unknowns[P]);
    release(y);
    expand(y, v);
}

template <int Dim>
void ReducedSystem<Dim>::expand(const Points<Dim>& y, Points<Dim>& v) const {
    for (std::size_t P = 0; P < m_unknowns.size(); ++P)
        v.col(m_unknowns[P]) += y.col(static_cast<Eigen::Index>(P));
    for (const auto& pivot : m_elimination.pivots)
        for (const auto& [other, weight] : pivot.free)
            if (m_unknownOf[other] >= 0) v.col(pivot.vertex) -= weight * y.col(m_unknownOf[other]);
}

template <int Dim>
void ReducedSystem<Dim>::restrict(const Points<Dim>& f, Points<Dim>& reduced) const {
    reduced.resize(Dim, static_cast<Eigen::Index>(m_unknowns.size()));
    for (std::size_t P = 0; P < m_unknowns.size(); ++P)
        reduced.col(static_cast<Eigen::Index>(P)) = f.col(m_unknowns[P]);
    for (const auto& pivot : m_elimination.pivots)
        for (const auto& [other, weight] : pivot.free)
            if (m_unknownOf[other] >= 0) reduced.col(m_unknownOf[other]) -= weight * f.col(pivot.vertex);
    release(reduced);
}

template class ReducedSystem<2>;
template class ReducedSystem<3>;

}  // namespace wend
