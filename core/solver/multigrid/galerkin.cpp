#include "core/solver/multigrid/galerkin.h"

#include <algorithm>
#include <stop_token>

namespace wend {
namespace {

constexpr int kBatch = 4096, kGrain = 64;  // forms
constexpr int kRowClasses = 16;            // rows are added to side by side if these differ

}  // namespace

/// What a form adds: the lower triangle of a matrix of the aggregates that it touches.
template <int Dim>
struct Galerkin<Dim>::Part {
    using Square = typename CoarseSpace<Dim>::Square;
    std::vector<int> aggregates;
    std::vector<Square> blocks;  // by rows, of the lower triangle
    int count = 0;
    std::array<int, LocalForms<Dim>::kMost> vertices;
    std::array<Mat<Dim>, LocalForms<Dim>::kMost> diagonal;

    // Scratch.
    std::vector<Eigen::Matrix<double, kStrainCount<Dim>, kModes>> strains, stresses;
    std::vector<typename CoarseSpace<Dim>::Exact> sums;
};

/// A row has the aggregates of all vertices in the cells around its own vertices and next to those.
template <int Dim>
void Galerkin<Dim>::analyze(const CoarseSpace<Dim>& space) {
    const AssemblyPlan<Dim>& plan = space.plan();
    std::vector<std::vector<int>> verticesOf(space.aggregates());
    for (int v = 0; v < plan.vertexCount; ++v)
        for (int e = space.begin(v); e < space.end(v); ++e) verticesOf[space.aggregate(e)].push_back(v);
    std::vector<int> seenCell(plan.cells.size(), -1), seenVertex(plan.vertexCount, -1),
        seen(space.aggregates(), -1);
    m_matrix.blockSize = kModes;
    m_matrix.start.assign(1, 0);
    m_matrix.column.clear();
    std::vector<int> row;
    for (int a = 0; a < space.aggregates(); ++a) {
        row.clear();
        const auto visitVertices = [&](int cell) {
            for (int v : plan.cells[cell]) {
                if (std::exchange(seenVertex[v], a) == a) continue;
                for (int e = space.begin(v); e < space.end(v); ++e)
                    if (std::exchange(seen[space.aggregate(e)], a) != a) row.push_back(space.aggregate(e));
            }
        };
        for (int v : verticesOf[a])
            for (int i = plan.cornerStart[v]; i < plan.cornerStart[v + 1]; ++i) {
                const int cell = plan.corners[i] / (Dim + 1);
                if (std::exchange(seenCell[cell], a) == a) continue;
                visitVertices(cell);
                for (int facet : plan.facetOfCorner[cell])
                    if (facet >= 0) visitVertices(plan.across(facet, cell));
            }
        std::sort(row.begin(), row.end());
        m_matrix.column.insert(m_matrix.column.end(), row.begin(), row.end());
        m_matrix.start.push_back(static_cast<int>(m_matrix.column.size()));
    }
    m_matrix.values.resize(m_matrix.column.size() * m_matrix.blockEntries());
}

/// With ε = Σ_a E_a c_a the form is Σ_ab c_aᵀ E_aᵀ M E_b c_b.
template <int Dim>
void Galerkin<Dim>::compute(const CoarseSpace<Dim>& space, const typename LocalForms<Dim>::Form& form,
                            Part& part) const {
    auto& list = part.aggregates;
    list.clear();
    for (int k = 0; k < form.count; ++k)
        for (int e = space.begin(form.vertices[k]); e < space.end(form.vertices[k]); ++e)
            list.push_back(space.aggregate(e));
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    const std::size_t n = list.size();
    const auto place = [&](int aggregate) {
        return static_cast<std::size_t>(std::lower_bound(list.begin(), list.end(), aggregate) - list.begin());
    };
    part.strains.resize(n);
    part.stresses.resize(n);
    for (auto& E : part.strains) E.setZero();
    part.count = form.count;
    for (int k = 0; k < form.count; ++k) {
        const int v = form.vertices[k];
        for (int e = space.begin(v); e < space.end(v); ++e)
            part.strains[place(space.aggregate(e))] +=
                form.columns[k] * space.block(e).template cast<double>();
        part.vertices[k] = v;
        part.diagonal[k].noalias() = form.columns[k].transpose() * (form.weight * form.columns[k]);
        part.diagonal[k].diagonal().array() += 2 * form.mass;
    }
    part.blocks.resize(n * (n + 1) / 2);
    auto* next = part.blocks.data();
    for (std::size_t i = 0; i < n; ++i) {
        part.stresses[i].noalias() = form.weight * part.strains[i];
        for (std::size_t j = 0; j <= i; ++j)
            (next++)->noalias() = part.stresses[i].transpose() * part.strains[j];
    }
    if (form.mass == 0) return;
    part.sums.resize(n);
    for (auto& sum : part.sums) sum.setZero();
    for (int k = 0; k < form.count; ++k)
        for (int e = space.begin(form.vertices[k]); e < space.end(form.vertices[k]); ++e) {
            const auto P = space.block(e).template cast<double>();
            const std::size_t i = place(space.aggregate(e));
            part.sums[i] += P;
            for (int other = space.begin(form.vertices[k]); other <= e; ++other) {
                const std::size_t j = place(space.aggregate(other));
                part.blocks[i * (i + 1) / 2 + j] +=
                    form.mass * P.transpose() * space.block(other).template cast<double>();
            }
        }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            part.blocks[i * (i + 1) / 2 + j] += form.mass * part.sums[i].transpose() * part.sums[j];
}

template <int Dim>
void Galerkin<Dim>::add(const Part& part, int rowClass) {
    for (int k = 0; k < part.count; ++k)
        if (part.vertices[k] % kRowClasses == rowClass) m_diagonal[part.vertices[k]] += part.diagonal[k];
    const auto& list = part.aggregates;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] % kRowClasses != rowClass) continue;
        auto at = m_matrix.column.begin() + m_matrix.start[list[i]];
        const auto last = m_matrix.column.begin() + m_matrix.start[list[i] + 1];
        for (std::size_t j = 0; j <= i; ++j) {
            at = std::lower_bound(at, last, list[j]);
            block(static_cast<int>(at - m_matrix.column.begin())) += part.blocks[i * (i + 1) / 2 + j];
        }
    }
}

/// The place of a block in its row, which has it.
template <int Dim>
int Galerkin<Dim>::placeOf(int row, int column) const {
    const auto first = m_matrix.column.begin() + m_matrix.start[row],
               last = m_matrix.column.begin() + m_matrix.start[row + 1];
    return static_cast<int>(std::lower_bound(first, last, column) - m_matrix.column.begin());
}

/// The upper triangle, from the lower one.
template <int Dim>
void Galerkin<Dim>::mirror(WorkerPool& workers) {
    workers.forPieces(m_matrix.rows(), kGrain, [&](int begin, int end) {
        for (int a = begin; a < end; ++a)
            for (int i = m_matrix.start[a]; i < m_matrix.start[a + 1]; ++i)
                if (m_matrix.column[i] > a) block(i) = block(placeOf(m_matrix.column[i], a)).transpose();
    });
}

template <int Dim>
bool Galerkin<Dim>::build(const CoarseSpace<Dim>& space, const LocalForms<Dim>& forms, WorkerPool& workers,
                          const std::stop_token& stop) {
    std::fill(m_matrix.values.begin(), m_matrix.values.end(), 0.0);
    m_diagonal.assign(space.plan().vertexCount, Mat<Dim>::Zero());
    const int cells = forms.cells(), count = cells + forms.facets();
    std::vector<Part> parts(std::min(kBatch, count));
    for (int first = 0; first < count; first += kBatch) {
        if (stop.stop_requested()) return false;
        const int size = std::min(kBatch, count - first);
        workers.forPieces(size, kGrain, [&](int begin, int end) {
            for (int i = begin; i < end; ++i)
                compute(space, first + i < cells ? forms.cell(first + i) : forms.facet(first + i - cells),
                        parts[i]);
        });
        workers.forPieces(kRowClasses, 1, [&](int begin, int) {
            for (int i = 0; i < size; ++i) add(parts[i], begin);
        });
    }
    for (const auto& [v, row] : space.unknowns().dependent)
        for (const auto& [other, weight] : row) m_diagonal[other] += weight * weight * m_diagonal[v];
    for (int a = 0; a < space.aggregates(); ++a)
        for (int k = 0; k < kModes; ++k) {
            if (!(space.missing(a) >> k & 1U)) continue;
            block(placeOf(a, a))(k, k) = 1;
        }
    mirror(workers);
    return true;
}

template class Galerkin<2>;
template class Galerkin<3>;

}  // namespace wend
