#include "core/assembly/isotropic_back_end.h"

#include "core/assembly/block_kernels.h"
#include "core/assembly/corner_lists.h"
#include "core/assembly/cpu_back_end.h"
#include "core/assembly/isotropic_kernels.h"
#include "core/energy/smoothness.h"
#include "core/factor/worker_pool.h"

namespace wend {
namespace {

template <int Dim>
class IsotropicBackEnd final : public BackEnd<Dim> {
    static constexpr int kCorners = Dim + 1;
    static constexpr int kPoint = isotropic::Cells<Dim>::kPoint;
    static constexpr int kTensor = Dim * (Dim + 1) / 2;
    using Plan = AssemblyPlan<Dim>;

  public:
    IsotropicBackEnd(std::shared_ptr<const Plan> plan, const SimplicialMesh<Dim>& rest,
                     const Material<Dim>& material, int threads);

    std::string name() const override { return "cpu"; }
    std::string device() const override {
        return m_pool.threads() == 1 ? "1 thread" : std::to_string(m_pool.threads()) + " threads";
    }
    WorkerPool& workers() override { return m_pool; }
    void setMassRegularization(std::vector<double> epsilon) override {
        m_massRegularization = std::move(epsilon);
    }
    int setShape(const Points<Dim>& shape) override;
    void assemble(std::span<double> values) override;
    std::unique_ptr<BlockSource> blockSource() override;
    void apply(const Points<Dim>& v, Points<Dim>& Av) override;
    double energy(const Points<Dim>& v) override;

  private:
    void prepareCells(const SimplicialMesh<Dim>& rest, const Material<Dim>& material);
    void prepareFacets();
    void listContributions();
    void connect();
    isotropic::Jump kindOfJump() const;
    /// Factors of the contributions at one shape.
    struct Terms {
        std::vector<double> gradients;     // of the corners
        std::vector<double> coefficients;  // pairs: of the cells, then of the facets
    };
    class Source;
    void computeTerms(Terms& terms);
    void cellTerms(int begin, int end, Terms& terms) const;
    void facetTerms(int begin, int end, Terms& terms) const;
    void addMassTimes(const Points<Dim>& v, int p, Points<Dim>& Av) const;
    /// Returns ε V / ((d + 1)(d + 2)), the consistent mass of two different corners.
    double mass(int c) const { return m_massRegularization[c] * m_measure[c] / (kCorners * (kCorners + 1)); }
    double gradient(int corner, int axis) const;
    Strain<Dim> tensor(int cell) const;

    std::shared_ptr<const Plan> m_plan;
    Smoothing m_smoothing;
    WorkerPool m_pool;
    int m_cellCount, m_facetCount;
    // See isotropic_kernels.h.
    std::vector<int> m_vertices, m_facets, m_neighbours, m_facetVertices, m_facetCells;
    std::vector<double> m_q, m_r, m_orientation, m_measure, m_gradients, m_centroids, m_shear, m_dilation,
        m_tensor, m_tensorRest, m_facetWeight, m_facetShear, m_facetDilation, m_facetQ, m_facetR;
    isotropic::Jump m_jump = isotropic::Jump::Shear;
    isotropic::Cells<Dim> m_cells;
    isotropic::Facets<Dim> m_facetArrays;

    CornerLists<Dim> m_corners;
    std::vector<double> m_massRegularization;
    // The assembly needs the contributions of every block in one list.
    std::vector<int> m_start;
    std::vector<Contribution> m_contributions;
    Terms m_terms;
};

template <int Dim>
IsotropicBackEnd<Dim>::IsotropicBackEnd(std::shared_ptr<const Plan> plan, const SimplicialMesh<Dim>& rest,
                                        const Material<Dim>& material, int threads)
    : m_plan(std::move(plan)),
      m_smoothing(material.smoothing),
      m_pool(usefulThreads(threads, Dim * rest.vertexCount())),
      m_cellCount(m_plan->cellCount()),
      m_facetCount(static_cast<int>(m_plan->facets.size())),
      m_corners(*m_plan) {
    prepareCells(rest, material);
    prepareFacets();
    connect();
}

/// Repeats the last cell in the entries beyond it.
template <int Dim>
void IsotropicBackEnd<Dim>::prepareCells(const SimplicialMesh<Dim>& rest, const Material<Dim>& material) {
    const int count = isotropic::padded(m_cellCount);
    for (int i = 0; i < count; ++i) {
        const int c = std::min(i, m_cellCount - 1);
        const auto weights = EnergyWeights::of(material.phi[c]);
        m_q.push_back(weights.q);
        m_r.push_back(weights.r);
        m_orientation.push_back(cellMeasure<Dim>(rest.points, rest.cells[c]) < 0 ? -1.0 : 1.0);
        for (int k = 0; k < kCorners; ++k) {
            const int facet = m_plan->facetOfCorner[c][k];
            m_vertices.push_back(m_plan->cells[c][k]);
            m_facets.push_back(facet >= 0 ? facet : isotropic::padded(m_facetCount));
            m_neighbours.push_back(facet >= 0 ? m_plan->across(facet, c) : c);
        }
    }
    const auto n = static_cast<std::size_t>(count);
    m_measure.resize(n);
    m_gradients.resize(n * Dim * Dim);
    m_centroids.resize(n * kPoint);
    m_shear.assign(n * kCorners, 0.0);
    m_dilation.assign(n * kCorners, 0.0);
    m_tensor.resize(n * 4);
    if (Dim == 3) m_tensorRest.resize(n * 2);
}

/// Copies the facets of the plan to structures of arrays. Entries beyond the last facet repeat it.
template <int Dim>
void IsotropicBackEnd<Dim>::prepareFacets() {
    const int count = isotropic::padded(m_facetCount);
    for (int i = 0; i < count; ++i) {
        const int f = std::min(i, m_facetCount - 1);
        const auto& facet = m_plan->facets[f];
        m_facetVertices.insert(m_facetVertices.end(), facet.vertices.begin(), facet.vertices.end());
        m_facetCells.insert(m_facetCells.end(), facet.cells.begin(), facet.cells.end());
        const auto [a, b] = facet.cells;
        const auto w = jumpWeights({m_q[a], m_r[a]}, {m_q[b], m_r[b]});
        m_facetQ.push_back(w.q);
        m_facetR.push_back(w.r);
    }
    for (auto* weights : {&m_facetWeight, &m_facetShear, &m_facetDilation})
        weights->assign(static_cast<std::size_t>(count) + 1, 0.0);
    m_jump = kindOfJump();
}

template <int Dim>
isotropic::Jump IsotropicBackEnd<Dim>::kindOfJump() const {
    if (m_smoothing.kind == SmoothingKind::Paper) return isotropic::Jump::Stress;
    const bool swells = std::any_of(m_facetR.begin(), m_facetR.end(), [](double r) { return r < 0; });
    return swells ? isotropic::Jump::Strain : isotropic::Jump::Shear;
}

template <int Dim>
void IsotropicBackEnd<Dim>::connect() {
    m_cells = {m_cellCount,          m_vertices.data(),  m_q.data(),          m_r.data(),
               m_orientation.data(), m_facets.data(),    m_neighbours.data(), m_measure.data(),
               m_gradients.data(),   m_centroids.data(), m_shear.data(),      m_dilation.data(),
               m_tensor.data(),      m_tensorRest.data()};
    m_facetArrays = {m_facetCount,    m_facetVertices.data(), m_facetCells.data(), m_facetQ.data(),
                     m_facetR.data(), m_facetWeight.data(),   m_facetShear.data(), m_facetDilation.data()};
}

/// Computes geometry and weights at a shape. Every piece reports its first bad cell, so that the result does
/// not depend on the threads.
template <int Dim>
int IsotropicBackEnd<Dim>::setShape(const Points<Dim>& shape) {
    std::vector<int> bad((m_cellCount + kPlanGrain - 1) / kPlanGrain);
    m_pool.forPieces(m_cellCount, kPlanGrain, [&](int begin, int end) {
        const int first = isotropic::geometry<Dim>(m_cells, begin, end, shape.data());
        bad[begin / kPlanGrain] = first < end ? first : m_cellCount;
    });
    for (int first : bad)
        if (first < m_cellCount) return first;
    if (m_smoothing.kind == SmoothingKind::None) return -1;
    const bool invariant = m_smoothing.kind == SmoothingKind::Invariant;
    const double factor = invariant ? m_smoothing.length * m_smoothing.length : m_smoothing.lambda;
    m_pool.forPieces(m_facetCount, kPlanGrain, [&](int begin, int end) {
        isotropic::facetWeights<Dim>(m_jump, m_facetArrays, m_cells, begin, end, shape.data(), factor);
    });
    m_pool.forPieces(m_cellCount, kPlanGrain, [&](int begin, int end) {
        isotropic::spreadWeights<Dim>(m_jump, m_facetArrays, m_cells, begin, end);
    });
    return -1;
}

/// Computes A v in passes over cells and vertices: tensors, forces on the corners, and their sums at the
/// vertices.
template <int Dim>
void IsotropicBackEnd<Dim>::apply(const Points<Dim>& v, Points<Dim>& Av) {
    Av.resize(Dim, m_plan->vertexCount);
    m_pool.forPieces(m_cellCount, kPlanGrain, [&](int begin, int end) {
        isotropic::tensors<Dim>(m_jump, m_cells, begin, end, v.data());
    });
    m_pool.forPieces(m_cellCount, kPlanGrain, [&](int begin, int end) {
        isotropic::forces<Dim>(m_jump, m_cells, begin, end, m_corners.force.data());
    });
    m_pool.forPieces(m_plan->vertexCount, kPlanGrain, [&](int begin, int end) {
        m_corners.sum(begin, end, Av.data());
        if (!m_massRegularization.empty())
            for (int p = begin; p < end; ++p) addMassTimes(v, p, Av);
    });
}

template <int Dim>
void IsotropicBackEnd<Dim>::addMassTimes(const Points<Dim>& v, int p, Points<Dim>& Av) const {
    for (int i = m_plan->cornerStart[p]; i < m_plan->cornerStart[p + 1]; ++i) {
        const int c = m_plan->corners[i] / kCorners;
        Vec<Dim> sum = v.col(p);
        for (int other : m_plan->cells[c]) sum += v.col(other);
        Av.col(p) += mass(c) * sum;
    }
}

template <int Dim>
double IsotropicBackEnd<Dim>::gradient(int corner, int axis) const {
    const std::size_t n = m_measure.size();
    const int c = corner / kCorners, k = corner % kCorners;
    if (k > 0) return m_gradients[((k - 1) * Dim + axis) * n + c];
    double sum = 0;
    for (int other = 0; other < Dim; ++other) sum += m_gradients[(other * Dim + axis) * n + c];
    return -sum;
}

/// Merges the lists of the plan into one, own contributions first.
template <int Dim>
void IsotropicBackEnd<Dim>::listContributions() {
    m_start.assign(1, 0);
    m_contributions.reserve(m_plan->own.size() + m_plan->cross.size());
    for (int b = 0; b < m_plan->blockCount(); ++b) {
        for (int i = m_plan->ownStart[b]; i < m_plan->ownStart[b + 1]; ++i)
            m_contributions.push_back(
                {m_plan->own[i].left, m_plan->own[i].right, m_plan->own[i].left / kCorners});
        for (int i = m_plan->crossStart[b]; i < m_plan->crossStart[b + 1]; ++i)
            m_contributions.push_back(
                {m_plan->cross[i].left, m_plan->cross[i].right, m_cellCount + m_plan->cross[i].facet});
        m_start.push_back(static_cast<int>(m_contributions.size()));
    }
}

/// Computes the terms of contributions within one cell: ¼ (V D + Σ weight D_facet), so a = 2 (V q + Σ weight
/// q_facet), b = V r + Σ weight r_facet. With stress jumps it is ¼ V D + β D², D² X = 16 q² X + (8 q r + d
/// r²) Tr(X) I, with β the sum of the weights: a = 2 (V q + 16 β q²), b = V r + 4 β (8 q r + d r²).
template <int Dim>
void IsotropicBackEnd<Dim>::cellTerms(int begin, int end, Terms& terms) const {
    for (int c = begin; c < end; ++c) {
        const double q = m_q[c], r = m_r[c], V = m_measure[c];
        double shear = 0, dilation = 0;
        for (int k = 0; k < kCorners; ++k) {
            const std::size_t corner = static_cast<std::size_t>(c) * kCorners + k;
            shear += m_shear[corner];
            dilation += m_dilation[corner];
            double* const g = terms.gradients.data() + kPoint * corner;
            for (int a = 0; a < Dim; ++a) g[a] = gradient(c * kCorners + k, a);
        }
        if (m_jump == isotropic::Jump::Stress) {
            dilation = 4 * shear * (8 * q * r + Dim * r * r);
            shear *= 16 * q * q;
        }
        terms.coefficients[2 * c] = 2 * (V * q + shear);
        terms.coefficients[2 * c + 1] = V * r + dilation;
    }
}

/// Computes the terms of contributions across a facet: −¼ weight D_facet, with stress jumps −weight D_i D_j.
template <int Dim>
void IsotropicBackEnd<Dim>::facetTerms(int begin, int end, Terms& terms) const {
    double* const pairs = terms.coefficients.data() + 2 * static_cast<std::size_t>(m_cellCount);
    for (int f = begin; f < end; ++f) {
        if (m_jump != isotropic::Jump::Stress) {
            pairs[2 * f] = -2 * m_facetShear[f];
            pairs[2 * f + 1] = -m_facetDilation[f];
            continue;
        }
        const auto [i, j] = m_plan->facets[f].cells;
        pairs[2 * f] = -32 * m_facetWeight[f] * m_q[i] * m_q[j];
        pairs[2 * f + 1] =
            -4 * m_facetWeight[f] * (4 * (m_q[i] * m_r[j] + m_q[j] * m_r[i]) + Dim * m_r[i] * m_r[j]);
    }
}

template <int Dim>
void IsotropicBackEnd<Dim>::computeTerms(Terms& terms) {
    terms.gradients.resize(static_cast<std::size_t>(m_cellCount) * kCorners * kPoint);
    terms.coefficients.resize(2 * static_cast<std::size_t>(m_cellCount + m_facetCount));
    m_pool.forPieces(m_cellCount, kPlanGrain, [&](int begin, int end) { cellTerms(begin, end, terms); });
    m_pool.forPieces(m_facetCount, kPlanGrain, [&](int begin, int end) { facetTerms(begin, end, terms); });
}

/// Blocks of A, mass regularization included.
template <int Dim>
class IsotropicBackEnd<Dim>::Source final : public BlockSource {
  public:
    Source(const IsotropicBackEnd& backEnd, const Terms& terms) : m_backEnd(backEnd), m_terms(terms) {}
    Source(IsotropicBackEnd& backEnd) : m_backEnd(backEnd), m_terms(m_own) { backEnd.computeTerms(m_own); }

    void compute(std::span<const int> start, const Contribution* contributions,
                 double* values) const override {
        const int count = static_cast<int>(start.size()) - 1;
        const auto blocks = Dim == 2 ? isotropic::blocks2 : isotropic::blocks3;
        blocks(start.data(), contributions, m_terms.gradients.data(), m_terms.coefficients.data(), 0, count,
               values);
        if (m_backEnd.m_massRegularization.empty()) return;
        for (int b = 0; b < count; ++b)
            for (int i = start[b]; i < start[b + 1]; ++i) addMass(contributions[i], values + b * Dim * Dim);
    }

  private:
    void addMass(const Contribution& pair, double* block) const {
        if (pair.term >= m_backEnd.m_cellCount) return;
        const double mass = (pair.left == pair.right ? 2 : 1) * m_backEnd.mass(pair.term);
        for (int a = 0; a < Dim; ++a) block[a * (Dim + 1)] += mass;
    }

    const IsotropicBackEnd& m_backEnd;
    Terms m_own;
    const Terms& m_terms;
};

template <int Dim>
std::unique_ptr<BlockSource> IsotropicBackEnd<Dim>::blockSource() {
    return std::make_unique<Source>(*this);
}

/// Computes the coefficients of all terms first, and then every block from them.
template <int Dim>
void IsotropicBackEnd<Dim>::assemble(std::span<double> values) {
    if (m_start.empty()) listContributions();
    computeTerms(m_terms);
    const Source source(*this, m_terms);
    m_pool.forPieces(m_plan->blockCount(), kPlanGrain, [&](int begin, int end) {
        source.compute({m_start.data() + begin, static_cast<std::size_t>(end - begin) + 1},
                       m_contributions.data(),
                       values.data() + static_cast<std::ptrdiff_t>(begin) * Dim * Dim);
    });
}

/// Returns the tensor of a cell in Mandel coordinates.
template <int Dim>
Strain<Dim> IsotropicBackEnd<Dim>::tensor(int cell) const {
    Strain<Dim> T;
    for (int i = 0; i < kTensor; ++i)
        T[i] = (i < Dim ? 1 : std::numbers::sqrt2) *
               (i < 4 ? m_tensor[4 * static_cast<std::size_t>(cell) + i]
                      : m_tensorRest[2 * static_cast<std::size_t>(cell) + i - 4]);
    return T;
}

/// Returns Σ V (q ‖S‖² + r (½ Tr S)²) and the same of the jumps of S, weighted; with stress jumps Σ weight
/// ‖P_j − P_i‖².
template <int Dim>
double IsotropicBackEnd<Dim>::energy(const Points<Dim>& v) {
    const auto density = [](double q, double r, const Strain<Dim>& S) {
        const double trace = 0.5 * S.template head<Dim>().sum();
        return q * S.squaredNorm() + r * trace * trace;
    };
    isotropic::tensors<Dim>(isotropic::Jump::Shear, m_cells, 0, m_cellCount, v.data());
    double total = 0;
    for (int c = 0; c < m_cellCount; ++c) total += m_measure[c] * density(m_q[c], m_r[c], tensor(c));
    const bool stress = m_jump == isotropic::Jump::Stress;
    if (stress) isotropic::tensors<Dim>(m_jump, m_cells, 0, m_cellCount, v.data());
    for (int f = 0; f < m_facetCount; ++f) {
        const auto [i, j] = m_plan->facets[f].cells;
        const Strain<Dim> jump = tensor(j) - tensor(i);
        total += m_facetWeight[f] * (stress ? jump.squaredNorm() : density(m_facetQ[f], m_facetR[f], jump));
    }
    return total;
}

}  // namespace

template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeIsotropicBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                   const SimplicialMesh<Dim>& rest,
                                                   const Material<Dim>& material, int threads) {
    return std::make_unique<IsotropicBackEnd<Dim>>(std::move(plan), rest, material, threads);
}

#define WEND_INSTANTIATE(Dim)                                         \
    template std::unique_ptr<BackEnd<Dim>> makeIsotropicBackEnd<Dim>( \
        std::shared_ptr<const AssemblyPlan<Dim>>, const SimplicialMesh<Dim>&, const Material<Dim>&, int);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
