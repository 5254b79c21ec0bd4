#include "core/assembly/cpu_back_end.h"

#include <Eigen/LU>
#include <atomic>
#include <limits>
#include <numeric>
#include <thread>

#include "core/assembly/isotropic_back_end.h"
#include "core/energy/cell_energy.h"
#include "core/energy/smoothness.h"
#include "core/factor/worker_pool.h"

namespace wend {
namespace {

template <int Dim>
bool isIsotropic(const Mat<Dim>& B) {
    return (B - B(0, 0) * Mat<Dim>::Identity()).norm() <= 1e-15 * B.norm();
}

template <int Dim>
class CpuBackEnd final : public BackEnd<Dim> {
    static constexpr int kCorners = Dim + 1;
    using Plan = AssemblyPlan<Dim>;
    using Columns = StrainColumns<Dim>;

  public:
    CpuBackEnd(std::shared_ptr<const Plan> plan, const SimplicialMesh<Dim>& rest,
               const Material<Dim>& material, int threads)
        : m_plan(std::move(plan)),
          m_material(material),
          m_pool(usefulThreads(threads, Dim * rest.vertexCount())),
          m_B(material.anisotropy) {
        const auto cells = static_cast<std::size_t>(m_plan->cellCount());
        m_geometry.resize(cells);
        m_D.resize(cells);
        m_orientation.resize(cells);
        m_strain.resize(cells);
        m_stress.resize(cells);
        m_load.resize(cells);
        m_facetWeight.resize(m_plan->facets.size());
        for (int c = 0; c < m_plan->cellCount(); ++c) prepareCell(rest, c);
    }

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
    void prepareCell(const SimplicialMesh<Dim>& rest, int c);
    void updateStressMatrix(const Points<Dim>& shape, int c);
    class Source;
    void computeCornerTerms();
    void computeCornerTerms(int c);
    Mat<Dim> ownBlock(int left, int right) const;
    Mat<Dim> crossBlock(int left, int right, int facet) const;
    /// Returns B of a cell, or I.
    Mat<Dim> anisotropy(int c) const { return m_B.empty() ? Mat<Dim>(Mat<Dim>::Identity()) : m_B[c]; }
    EnergyWeights facetWeights(int f) const;
    Mat<Dim> facetAnisotropy(int f) const;
    Strain<Dim> facetStress(int f, const Strain<Dim>& jump) const;
    void computeFields(const Points<Dim>& v);
    Mat<Dim> massBlock(int left, int right) const;
    Strain<Dim> strain(const Points<Dim>& v, int c) const;
    Strain<Dim> load(int c) const;
    Vec<Dim> massTimes(const Points<Dim>& v, int c, int vertex) const;
    bool isPaper() const { return m_material.smoothing.kind == SmoothingKind::Paper; }
    double massRegularization(int c) const {
        return m_massRegularization.empty() ? 0.0 : m_massRegularization[c];
    }
    Vec<Dim> gradient(int corner) const {
        return m_geometry[corner / kCorners].gradients.col(corner % kCorners);
    }
    /// Returns Σ item(i) for i in [0, count), in fixed pieces that one thread sums each, the pieces in their
    /// order.
    template <typename Item>
    double sum(int count, Item&& item);

    std::shared_ptr<const Plan> m_plan;
    Material<Dim> m_material;
    WorkerPool m_pool;
    // Per cell.
    std::vector<double> m_orientation;          // sign of the measure at rest
    std::vector<Mat<Dim>> m_restInverse;        // inverse edge matrix at rest; only with anisotropy
    std::vector<CellGeometry<Dim>> m_geometry;  // of the current shape; measure is positive here
    std::vector<EnergyWeights> m_weights;
    std::vector<Mat<Dim>> m_B;  // of the current shape; only with anisotropy
    std::vector<StressMatrix<Dim>> m_D;
    std::vector<double> m_massRegularization;
    std::vector<Strain<Dim>> m_strain, m_stress, m_load;  // of the field in apply() and energy()
    std::vector<double> m_facetWeight;                    // per facet
    std::vector<Columns> m_T, m_U;                        // per corner: D G_a, and what own blocks need
};

template <int Dim>
void CpuBackEnd<Dim>::prepareCell(const SimplicialMesh<Dim>& rest, int c) {
    m_weights.push_back(EnergyWeights::of(m_material.phi[c]));
    m_orientation[c] = cellMeasure<Dim>(rest.points, rest.cells[c]) < 0 ? -1.0 : 1.0;
    m_D[c] = stressMatrix<Dim>(m_weights[c], anisotropy(c));
    if (!m_B.empty()) m_restInverse.push_back(edgeMatrix<Dim>(rest.points, rest.cells[c]).inverse());
}

/// Computes the stress matrix with B(t) = R B₀ Rᵀ, where R is the rotation of the cell's map from rest
/// (docs/method.md, (7)).
template <int Dim>
void CpuBackEnd<Dim>::updateStressMatrix(const Points<Dim>& shape, int c) {
    const Mat<Dim>& B0 = m_material.anisotropy[c];
    if (isIsotropic<Dim>(B0)) return;
    const Mat<Dim> F = edgeMatrix<Dim>(shape, m_plan->cells[c]) * m_restInverse[c];
    const Mat<Dim> R = polarRotation<Dim>(F);
    m_B[c] = R * B0 * R.transpose();
    m_D[c] = stressMatrix<Dim>(m_weights[c], m_B[c]);
}

/// Computes everything that depends on the shape, in fixed pieces that threads share. The first bad cell is
/// the least of those that the pieces find, so that it does not depend on the threads. An atomic minimum is
/// enough for that, since nothing but the number of the cell is reported.
template <int Dim>
int CpuBackEnd<Dim>::setShape(const Points<Dim>& shape) {
    constexpr int kNone = std::numeric_limits<int>::max();
    std::atomic<int> firstBad = kNone;
    m_pool.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        for (int c = begin; c < end; ++c) {
            m_geometry[c] = cellGeometry<Dim>(shape, m_plan->cells[c]);
            m_geometry[c].measure *= m_orientation[c];
            if (m_geometry[c].measure > 0 && m_geometry[c].gradients.allFinite()) {
                if (!m_restInverse.empty()) updateStressMatrix(shape, c);
                continue;
            }
            for (int minimum = firstBad; c < minimum && !firstBad.compare_exchange_weak(minimum, c);) {
            }
        }
    });
    if (firstBad != kNone) return firstBad;
    m_pool.forPieces(static_cast<int>(m_plan->facets.size()), kPlanGrain, [&](int begin, int end) {
        for (int f = begin; f < end; ++f) {
            const auto& facet = m_plan->facets[f];
            m_facetWeight[f] =
                smoothnessWeight<Dim>(m_material.smoothing, shape, facet.vertices,
                                      m_plan->cells[facet.cells[0]], m_plan->cells[facet.cells[1]]);
        }
    });
    return -1;
}

/// Returns the weights of q between the facet's two cells (docs/method.md, (11)).
template <int Dim>
EnergyWeights CpuBackEnd<Dim>::facetWeights(int f) const {
    const auto [i, j] = m_plan->facets[f].cells;
    return jumpWeights(m_weights[i], m_weights[j]);
}

template <int Dim>
Mat<Dim> CpuBackEnd<Dim>::facetAnisotropy(int f) const {
    const auto [i, j] = m_plan->facets[f].cells;
    return 0.5 * (anisotropy(i) + anisotropy(j));
}

/// Returns D_f S for a jump S of the strain, with q = ¼ S : D_f S.
template <int Dim>
Strain<Dim> CpuBackEnd<Dim>::facetStress(int f, const Strain<Dim>& jump) const {
    const EnergyWeights w = facetWeights(f);
    const Mat<Dim> B = facetAnisotropy(f), S = fromMandel<Dim>(jump), SB = S * B;
    const double dilation = w.r * (Dim / B.trace()) * SB.trace();
    return toMandel<Dim>(2 * w.q * (SB + Mat<Dim>(SB.transpose())) + dilation * B);
}

/// Computes T_a = D G_a and U_a = M G_a of the corners of a cell, where M is ¼ (V D + Σ_facets weight D_f),
/// or ¼ V D + Σ_facets weight D² with the paper's kind.
template <int Dim>
void CpuBackEnd<Dim>::computeCornerTerms(int c) {
    StressMatrix<Dim> M = 0.25 * m_geometry[c].measure * m_D[c];
    for (int f : m_plan->facetOfCorner[c]) {
        if (f < 0) continue;
        if (isPaper())
            M += m_facetWeight[f] * m_D[c] * m_D[c];
        else
            M += 0.25 * m_facetWeight[f] * stressMatrix<Dim>(facetWeights(f), facetAnisotropy(f));
    }
    for (int k = 0; k < kCorners; ++k) {
        const int corner = c * kCorners + k;
        const Columns G = strainColumns<Dim>(gradient(corner));
        m_T[corner].noalias() = m_D[c] * G;
        m_U[corner].noalias() = M * G;
    }
}

template <int Dim>
void CpuBackEnd<Dim>::computeCornerTerms() {
    m_T.resize(m_plan->cells.size() * kCorners);
    m_U.resize(m_T.size());
    m_pool.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        for (int c = begin; c < end; ++c) computeCornerTerms(c);
    });
}

/// Returns the block of a contribution across a facet: −¼ weight G_leftᵀ D_f G_right, or −weight T_leftᵀ
/// T_right with the paper's kind.
template <int Dim>
Mat<Dim> CpuBackEnd<Dim>::crossBlock(int left, int right, int facet) const {
    const double weight = -m_facetWeight[facet];
    if (isPaper()) return weight * m_T[left].transpose().lazyProduct(m_T[right]);
    return 0.25 * weight *
           stressBlock<Dim>(facetWeights(facet), facetAnisotropy(facet), gradient(left), gradient(right));
}

/// Returns ε V (1 + δ_ab) / ((d + 1)(d + 2)) I, the consistent mass of linear hat functions.
template <int Dim>
Mat<Dim> CpuBackEnd<Dim>::massBlock(int left, int right) const {
    const int c = left / kCorners;
    const double mass = massRegularization(c) * m_geometry[c].measure / (kCorners * (kCorners + 1));
    return (left == right ? 2 * mass : mass) * Mat<Dim>::Identity();
}

/// Returns the block of a contribution within a cell: G_leftᵀ U_right, and the mass if it is regularized.
template <int Dim>
Mat<Dim> CpuBackEnd<Dim>::ownBlock(int left, int right) const {
    Mat<Dim> A = strainColumns<Dim>(gradient(left)).transpose().lazyProduct(m_U[right]);
    if (!m_massRegularization.empty()) A += massBlock(left, right);
    return A;
}

/// Blocks of A from the corners' terms.
template <int Dim>
class CpuBackEnd<Dim>::Source final : public BlockSource {
  public:
    explicit Source(const CpuBackEnd& backEnd) : m_backEnd(backEnd) {}

    void compute(std::span<const int> start, const Contribution* contributions,
                 double* values) const override {
        const int cells = m_backEnd.m_plan->cellCount();
        for (std::size_t b = 0; b + 1 < start.size(); ++b) {
            Mat<Dim> A = Mat<Dim>::Zero();
            for (int i = start[b]; i < start[b + 1]; ++i) {
                const auto [left, right, term] = contributions[i];
                A += term < cells ? m_backEnd.ownBlock(left, right)
                                  : m_backEnd.crossBlock(left, right, term - cells);
            }
            Eigen::Map<Mat<Dim>>(values + b * Dim * Dim) = A;
        }
    }

  private:
    const CpuBackEnd& m_backEnd;
};

template <int Dim>
std::unique_ptr<BlockSource> CpuBackEnd<Dim>::blockSource() {
    computeCornerTerms();
    return std::make_unique<Source>(*this);
}

/// Sums every block in the order of the plan, own contributions first; the mass is part of these.
template <int Dim>
void CpuBackEnd<Dim>::assemble(std::span<double> values) {
    computeCornerTerms();
    m_pool.forPieces(m_plan->blockCount(), kPlanGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Mat<Dim> A = Mat<Dim>::Zero();
            for (int k = m_plan->ownStart[i]; k < m_plan->ownStart[i + 1]; ++k)
                A += ownBlock(m_plan->own[k].left, m_plan->own[k].right);
            for (int k = m_plan->crossStart[i]; k < m_plan->crossStart[i + 1]; ++k)
                A += crossBlock(m_plan->cross[k].left, m_plan->cross[k].right, m_plan->cross[k].facet);
            Eigen::Map<Mat<Dim>>(values.data() + i * Dim * Dim) = A;
        }
    });
}

/// Returns S = J + Jᵀ of a field on a cell.
template <int Dim>
Strain<Dim> CpuBackEnd<Dim>::strain(const Points<Dim>& v, int c) const {
    Mat<Dim> J = Mat<Dim>::Zero();
    for (int k = 0; k < kCorners; ++k)
        J += v.col(m_plan->cells[c][k]) * m_geometry[c].gradients.col(k).transpose();
    Strain<Dim> S;
    for (int a = 0; a < Dim; ++a) S[a] = 2 * J(a, a);
    forOffDiagonal<Dim>([&](int i, int a, int b) { S[i] = std::numbers::sqrt2 * (J(a, b) + J(b, a)); });
    return S;
}

/// Returns ½ ∂E/∂S of a cell: ¼ V P + ¼ Σ_facets weight D_f (S − S_neighbour), so that A v = Σ_cells Gᵀ load;
/// with the paper's kind ¼ V P + D Σ_facets weight (P − P_neighbour).
template <int Dim>
Strain<Dim> CpuBackEnd<Dim>::load(int c) const {
    Strain<Dim> load = 0.25 * m_geometry[c].measure * m_stress[c];
    for (int f : m_plan->facetOfCorner[c]) {
        if (f < 0) continue;
        const int other = m_plan->across(f, c);
        if (isPaper())
            load += m_facetWeight[f] * (m_D[c] * (m_stress[c] - m_stress[other]));
        else
            load += 0.25 * m_facetWeight[f] * facetStress(f, m_strain[c] - m_strain[other]);
    }
    return load;
}

/// Computes strain and stress of a field on every cell.
template <int Dim>
void CpuBackEnd<Dim>::computeFields(const Points<Dim>& v) {
    m_pool.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        for (int c = begin; c < end; ++c) {
            m_strain[c] = strain(v, c);
            m_stress[c] = m_D[c] * m_strain[c];
        }
    });
}

/// Returns the row of a vertex of ε M_c v in a cell: ε V / ((d + 1)(d + 2)) (v_vertex + Σ_corners v), as
/// massBlock().
template <int Dim>
Vec<Dim> CpuBackEnd<Dim>::massTimes(const Points<Dim>& v, int c, int vertex) const {
    Vec<Dim> sum = v.col(vertex);
    for (int other : m_plan->cells[c]) sum += v.col(other);
    return massRegularization(c) * m_geometry[c].measure / (kCorners * (kCorners + 1)) * sum;
}

/// Computes A v in two passes: first the load of every cell, then for every vertex the sum over its corners
/// in a fixed order.
template <int Dim>
void CpuBackEnd<Dim>::apply(const Points<Dim>& v, Points<Dim>& Av) {
    Av.resize(Dim, m_plan->vertexCount);
    computeFields(v);
    m_pool.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        for (int c = begin; c < end; ++c) m_load[c] = load(c);
    });
    m_pool.forPieces(m_plan->vertexCount, kPlanGrain, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            Vec<Dim> total = Vec<Dim>::Zero();
            for (int i = m_plan->cornerStart[p]; i < m_plan->cornerStart[p + 1]; ++i) {
                const int corner = m_plan->corners[i], c = corner / kCorners;
                total += 2 * fromMandel<Dim>(m_load[c]) * gradient(corner);
                if (!m_massRegularization.empty()) total += massTimes(v, c, p);
            }
            Av.col(p) = total;
        }
    });
}

/// Adds up within pieces of kPlanGrain items first, and then the pieces in their order: neither depends on
/// which thread computes a piece, so the sum has the same bits for any number of threads.
template <int Dim>
template <typename Item>
double CpuBackEnd<Dim>::sum(int count, Item&& item) {
    std::vector<double> partial((count + kPlanGrain - 1) / kPlanGrain, 0.0);
    m_pool.forPieces(count, kPlanGrain, [&](int begin, int end) {
        double total = 0;
        for (int i = begin; i < end; ++i) total += item(i);
        partial[begin / kPlanGrain] = total;
    });
    return std::accumulate(partial.begin(), partial.end(), 0.0);
}

/// Returns Σ ¼ V S : P over the cells and the weighted jumps over the facets, each in fixed pieces.
template <int Dim>
double CpuBackEnd<Dim>::energy(const Points<Dim>& v) {
    computeFields(v);
    const double inside = sum(m_plan->cellCount(), [&](int c) {
        return 0.25 * m_geometry[c].measure * m_strain[c].dot(m_stress[c]);
    });
    const double across = sum(static_cast<int>(m_plan->facets.size()), [&](int f) {
        const auto [i, j] = m_plan->facets[f].cells;
        if (isPaper()) return m_facetWeight[f] * (m_stress[j] - m_stress[i]).squaredNorm();
        const Strain<Dim> jump = m_strain[j] - m_strain[i];
        return 0.25 * m_facetWeight[f] * jump.dot(facetStress(f, jump));
    });
    return inside + across;
}

}  // namespace

int usefulThreads(int wanted, int unknowns) {
    if (unknowns < 10000) return 1;
    return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeCpuBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                             const SimplicialMesh<Dim>& rest, const Material<Dim>& material,
                                             int threads) {
    if (material.anisotropy.empty())
        return makeIsotropicBackEnd<Dim>(std::move(plan), rest, material, threads);
    return makeGeneralBackEnd<Dim>(std::move(plan), rest, material, threads);
}

template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeGeneralBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                 const SimplicialMesh<Dim>& rest,
                                                 const Material<Dim>& material, int threads) {
    return std::make_unique<CpuBackEnd<Dim>>(std::move(plan), rest, material, threads);
}

template std::unique_ptr<BackEnd<2>> makeCpuBackEnd<2>(std::shared_ptr<const AssemblyPlan<2>>,
                                                       const SimplicialMesh<2>&, const Material<2>&, int);
template std::unique_ptr<BackEnd<3>> makeCpuBackEnd<3>(std::shared_ptr<const AssemblyPlan<3>>,
                                                       const SimplicialMesh<3>&, const Material<3>&, int);
template std::unique_ptr<BackEnd<2>> makeGeneralBackEnd<2>(std::shared_ptr<const AssemblyPlan<2>>,
                                                           const SimplicialMesh<2>&, const Material<2>&, int);
template std::unique_ptr<BackEnd<3>> makeGeneralBackEnd<3>(std::shared_ptr<const AssemblyPlan<3>>,
                                                           const SimplicialMesh<3>&, const Material<3>&, int);

}  // namespace wend
