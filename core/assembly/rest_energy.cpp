#include "core/assembly/rest_energy.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>

namespace wend {
namespace {

/// The Bernstein coefficients of a polynomial of degree Dim on [0, 1], Dim + 1 of them.
template <int Dim>
using Bernstein = std::array<double, Dim + 1>;

/// Returns the Bernstein coefficients of det(E + s D). The mixed ones are means over the columns that are
/// taken from E + D.
Bernstein<2> determinants(const Mat2& E, const Mat2& end) {
    const double mixed =
        E(0, 0) * end(1, 1) + end(0, 0) * E(1, 1) - E(0, 1) * end(1, 0) - end(0, 1) * E(1, 0);
    return {E.determinant(), 0.5 * mixed, end.determinant()};
}
Bernstein<3> determinants(const Mat3& E, const Mat3& end) {
    const auto mixed = [](const Mat3& twice, const Mat3& once) {
        double sum = 0;
        for (int k = 0; k < 3; ++k)
            sum += once.col(k).dot(twice.col((k + 1) % 3).cross(twice.col((k + 2) % 3)));
        return sum / 3;
    };
    return {E.determinant(), mixed(E, end), mixed(end, E), end.determinant()};
}

/// Returns a lower bound of the first root in [0, 1] of a polynomial, 1 if there is none. A polynomial is
/// within the range of its Bernstein coefficients: if all are positive, there is no root. Otherwise the
/// interval is halved by de Casteljau's algorithm, the first half first. After the last halving the beginning
/// of the piece counts as the root, whether it has one or not: the bound is safe, and close to the root
/// except where the polynomial nearly touches 0 before. It is 0 if b(0) ≤ 0.
template <int Dim>
double beforeFirstRoot(const Bernstein<Dim>& b, int halvings) {
    if (std::ranges::all_of(b, [](double value) { return value > 0; })) return 1;
    if (halvings == 0 || !(b[0] > 0)) return 0;
    Bernstein<Dim> left, right = b;
    for (int k = 0; k <= Dim; ++k) {  // de Casteljau
        left[k] = right[0];
        for (int i = 0; i < Dim - k; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    const double first = beforeFirstRoot<Dim>(left, halvings - 1);
    return first < 1 ? 0.5 * first : 0.5 + 0.5 * beforeFirstRoot<Dim>(right, halvings - 1);
}

}  // namespace

template <int Dim>
RestEnergy<Dim>::RestEnergy(std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
                            const Material<Dim>& material)
    : m_plan(std::move(plan)), m_anisotropy(material.anisotropy), m_corners(*m_plan) {
    for (int c = 0; c < rest.cellCount(); ++c) {
        m_weights.push_back(EnergyWeights::of(material.phi[c]));
        m_restInverse.push_back(edgeMatrix<Dim>(rest.points, rest.cells[c]).inverse());
        m_measure.push_back(std::abs(cellMeasure<Dim>(rest.points, rest.cells[c])));
    }
    if (isIsotropic()) prepareCells();
}

/// Fills the arrays of the kernels.
template <int Dim>
void RestEnergy<Dim>::prepareCells() {
    const int count = m_plan->cellCount(), n = isotropic::padded(count);
    m_hats.resize(static_cast<std::size_t>(n) * Dim * Dim);
    m_tangent.resize(static_cast<std::size_t>(n) * rest::Cells<Dim>::kTangent);
    for (int i = 0; i < n; ++i) {
        const int c = std::min(i, count - 1);
        m_vertices.insert(m_vertices.end(), m_plan->cells[c].begin(), m_plan->cells[c].end());
        m_q.push_back(m_weights[c].q);
        m_r.push_back(m_weights[c].r);
        m_measures.push_back(i < count ? m_measure[c] : 0);
        for (int k = 0; k < Dim; ++k)
            for (int a = 0; a < Dim; ++a)
                m_hats[static_cast<std::size_t>(k * Dim + a) * n + i] = m_restInverse[c](k, a);
    }
}

template <int Dim>
rest::Cells<Dim> RestEnergy<Dim>::cells() const {
    return {m_plan->cellCount(), m_vertices.data(), m_q.data(), m_r.data(), m_measures.data(), m_hats.data()};
}

template <int Dim>
Mat<Dim> RestEnergy<Dim>::mapOf(const Points<Dim>& shape, int cell) const {
    return edgeMatrix<Dim>(shape, m_plan->cells[cell]) * m_restInverse[cell];
}

/// Returns the map of the shape of linearize().
template <int Dim>
Mat<Dim> RestEnergy<Dim>::tangentMap(int cell) const {
    const auto n = static_cast<std::size_t>(isotropic::padded(m_plan->cellCount()));
    Mat<Dim> F;
    for (int a = 0; a < Dim; ++a)
        for (int b = 0; b < Dim; ++b) F(a, b) = m_tangent[static_cast<std::size_t>(a * Dim + b) * n + cell];
    return F;
}

template <int Dim>
double RestEnergy<Dim>::energy(const Points<Dim>& shape) const {
    if (isIsotropic()) return rest::energy<Dim>(cells(), 0, m_plan->cellCount(), shape.data());
    double sum = 0;
    for (int c = 0; c < m_plan->cellCount(); ++c)
        sum += m_measure[c] * restDensity<Dim>(m_weights[c], anisotropy(c), mapOf(shape, c));
    return sum;
}

template <int Dim>
void RestEnergy<Dim>::setForces(int cell, const Mat<Dim>& forces) {
    constexpr int kPoint = rest::Cells<Dim>::kPoint;
    double* const to = m_corners.force.data() + static_cast<std::ptrdiff_t>(cell) * kPoint * (Dim + 1);
    for (int a = 0; a < Dim; ++a) {
        to[a] = -forces.row(a).sum();
        for (int k = 0; k < Dim; ++k) to[kPoint * (k + 1) + a] = forces(a, k);
    }
}

/// Adds up the forces on the corners of every vertex.
template <int Dim>
void RestEnergy<Dim>::gather(Points<Dim>& sum, WorkerPool& workers) const {
    sum.resize(Dim, m_plan->vertexCount);
    workers.forPieces(m_plan->vertexCount, kPlanGrain,
                      [&](int begin, int end) { m_corners.sum(begin, end, sum.data()); });
}

/// Sums ∂W/∂x_k = V₀ ∂w/∂F h_k with the hat gradients h_k at rest, the columns of E₀⁻ᵀ.
template <int Dim>
void RestEnergy<Dim>::gradient(const Points<Dim>& shape, Points<Dim>& gradient, WorkerPool& workers) {
    workers.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        if (isIsotropic())
            return rest::forces<Dim>(cells(), begin, end, shape.data(), m_corners.force.data());
        for (int c = begin; c < end; ++c)
            setForces(c, m_measure[c] * restStress<Dim>(m_weights[c], anisotropy(c), mapOf(shape, c)) *
                             m_restInverse[c].transpose());
    });
    gather(gradient, workers);
}

/// Computes ∂²W/∂x_k ∂x_l, the exact one in closed form, others as V₀ Σ_m λ_m (M_m h_k)(M_m h_l)ᵀ over the
/// modes M_m.
template <int Dim>
void RestEnergy<Dim>::linearizeCell(int cell, double negative, const Mat<Dim>& F) {
    const Mat<Dim> hats = m_restInverse[cell].transpose();
    if (negative == 1) {
        m_hessian[cell] = m_measure[cell] * restHessian<Dim>(m_weights[cell], anisotropy(cell), F, hats);
        return;
    }
    auto [values, modes] = restModes<Dim>(m_weights[cell], anisotropy(cell), F);
    for (double& value : values.reshaped()) value = std::max(value, negative * value);
    CellHessian onCorners;  // its rows are the modes on the corners 1 …
    for (int m = 0; m < Dim * Dim; ++m) {
        const Mat<Dim> moved = Eigen::Map<const Mat<Dim>>(modes.col(m).data()) * hats;
        onCorners.row(m) = Eigen::Map<const Eigen::Matrix<double, 1, Dim * Dim>>(moved.data());
    }
    m_hessian[cell].noalias() = onCorners.transpose() * (m_measure[cell] * values).asDiagonal() * onCorners;
}

/// For B₀ = I the exact Hessian is applied without its blocks, which only a factor needs.
template <int Dim>
void RestEnergy<Dim>::linearize(const Points<Dim>& shape, double negative, WorkerPool& workers) {
    m_isTangent = isIsotropic() && negative == 1;
    if (!m_isTangent) m_hessian.resize(m_plan->cells.size());
    workers.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        if (m_isTangent) return rest::linearize<Dim>(cells(), begin, end, shape.data(), m_tangent.data());
        for (int c = begin; c < end; ++c) linearizeCell(c, negative, mapOf(shape, c));
    });
}

/// Returns the block of the Hessian for two corners of one cell. Since h_0 = −Σ_k h_k, a block of corner 0 is
/// minus the sum of the corresponding blocks of the corners 1 …, and that of corner 0 with itself is the sum
/// of all.
template <int Dim>
Mat<Dim> RestEnergy<Dim>::hessianBlock(int left, int right) const {
    const CellHessian& H = m_hessian[left / (Dim + 1)];
    const int k = left % (Dim + 1), l = right % (Dim + 1);
    Mat<Dim> sum = Mat<Dim>::Zero();
    for (int i = k > 0 ? k - 1 : 0; i < (k > 0 ? k : Dim); ++i)
        for (int j = l > 0 ? l - 1 : 0; j < (l > 0 ? l : Dim); ++j)
            sum += H.template block<Dim, Dim>(Dim * i, Dim * j);
    return (k > 0) == (l > 0) ? sum : Mat<Dim>(-sum);
}

template <int Dim>
void RestEnergy<Dim>::addHessian(std::span<double> blocks, WorkerPool& workers) {
    if (m_isTangent) {
        m_hessian.resize(m_plan->cells.size());
        workers.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
            for (int c = begin; c < end; ++c) linearizeCell(c, 1, tangentMap(c));
        });
    }
    workers.forPieces(m_plan->blockCount(), kPlanGrain, [&](int begin, int end) {
        for (int b = begin; b < end; ++b) {
            Eigen::Map<Mat<Dim>> block(blocks.data() + static_cast<std::ptrdiff_t>(b) * Dim * Dim);
            for (int i = m_plan->ownStart[b]; i < m_plan->ownStart[b + 1]; ++i)
                block += hessianBlock(m_plan->own[i].left, m_plan->own[i].right);
        }
    });
}

/// Applies the Hessian of every cell to the differences of its corners, and sums the results at the vertices.
template <int Dim>
void RestEnergy<Dim>::applyHessian(const Points<Dim>& v, Points<Dim>& Hv, WorkerPool& workers) {
    workers.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        if (m_isTangent)
            return rest::products<Dim>(cells(), begin, end, m_tangent.data(), v.data(),
                                       m_corners.force.data());
        for (int c = begin; c < end; ++c) {
            const Mat<Dim> edges = edgeMatrix<Dim>(v, m_plan->cells[c]);
            const Eigen::Matrix<double, Dim * Dim, 1> forces =
                m_hessian[c] * Eigen::Map<const Eigen::Matrix<double, Dim * Dim, 1>>(edges.data());
            setForces(c, Eigen::Map<const Mat<Dim>>(forces.data()));
        }
    });
    gather(Hv, workers);
}

template <int Dim>
double RestEnergy<Dim>::unfoldedPart(const Points<Dim>& shape, const Points<Dim>& step) const {
    constexpr int kHalvings = 7;
    if (isIsotropic() && rest::staysPositive<Dim>(cells(), 0, m_plan->cellCount(), shape.data(), step.data()))
        return 1;
    double part = 1;
    for (int c = 0; c < m_plan->cellCount(); ++c) {
        const Mat<Dim> E = mapOf(shape, c), D = edgeMatrix<Dim>(step, m_plan->cells[c]) * m_restInverse[c];
        // Only the part that the cells before allow is searched, so that most cells are settled by their
        // first coefficients.
        part = std::min(part, part * beforeFirstRoot<Dim>(determinants(E, E + part * D), kHalvings));
    }
    return part;
}

template class RestEnergy<2>;
template class RestEnergy<3>;

}  // namespace wend
