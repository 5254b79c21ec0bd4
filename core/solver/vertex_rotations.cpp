#include "core/solver/vertex_rotations.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace wend {
namespace {

// Rough rotations cost more iterations than none.
constexpr int kSweeps = 3;
constexpr int kNewtonSteps = 6;
constexpr int kGrain = 512;  // vertices of a piece

/// The rotation nearest to a matrix; the identity where there is none.
Mat<2> nearestRotation(const Mat<2>& A) {
    const double c = A(0, 0) + A(1, 1), s = A(1, 0) - A(0, 1), size = std::sqrt(c * c + s * s);
    if (!(size > 0)) return Mat<2>::Identity();
    return (Mat<2>() << c, -s, s, c).finished() / size;
}

/// Newton's iteration R ← ½ (R + R⁻ᵀ), scaled; what remains after a few steps does not matter: any rotation
/// nearby serves.
Mat<3> nearestRotation(const Mat<3>& A) {
    Mat<3> R = A;
    for (int i = 0; i < kNewtonSteps; ++i) {
        const double det = R.determinant();
        if (!(det > 0)) return Mat<3>::Identity();
        if (i == 0) R /= std::cbrt(det);
        const Mat<3> next = 0.5 * (R + R.inverse().transpose());
        const double change = (next - R).cwiseAbs().maxCoeff();
        R = next;
        if (change < 1e-3) break;
    }
    return R;
}

}  // namespace

template <int Dim>
VertexRotations<Dim>::VertexRotations(const AssemblyPlan<Dim>& plan)
    : m_rotations(plan.vertexCount, Mat<Dim>::Identity()), m_other(m_rotations) {
    std::vector<int> around;
    m_start.push_back(0);
    for (int v = 0; v < plan.vertexCount; ++v) {
        around.clear();
        for (int i = plan.cornerStart[v]; i < plan.cornerStart[v + 1]; ++i)
            for (const int other : plan.cells[plan.corners[i] / (Dim + 1)])
                if (other != v) around.push_back(other);
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        m_neighbours.insert(m_neighbours.end(), around.begin(), around.end());
        m_start.push_back(static_cast<int>(m_neighbours.size()));
    }
}

/// argmin Σ_j ‖(y_j − y) − R (x_j − x)‖²: the rotation of Σ_j (y_j − y) (x_j − x)ᵀ.
template <int Dim>
Mat<Dim> VertexRotations<Dim>::edgeFit(int vertex, const Points<Dim>& from, const Points<Dim>& to) const {
    Mat<Dim> sum = Mat<Dim>::Zero();
    for (int i = m_start[vertex]; i < m_start[vertex + 1]; ++i)
        sum += (to.col(m_neighbours[i]) - to.col(vertex)) *
               (from.col(m_neighbours[i]) - from.col(vertex)).transpose();
    return nearestRotation(sum);
}

template <int Dim>
Mat<Dim> VertexRotations<Dim>::average(int vertex) const {
    Mat<Dim> sum = m_rotations[vertex];
    for (int i = m_start[vertex]; i < m_start[vertex + 1]; ++i) sum += m_rotations[m_neighbours[i]];
    return sum / (1 + m_start[vertex + 1] - m_start[vertex]);
}

template <int Dim>
void VertexRotations<Dim>::compute(const Points<Dim>& from, const Points<Dim>& to, WorkerPool& workers) {
    const int count = static_cast<int>(m_rotations.size());
    const auto forAll = [&](auto&& make) {
        workers.forPieces(count, kGrain, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) m_other[v] = make(v);
        });
        m_rotations.swap(m_other);
    };
    forAll([&](int v) { return edgeFit(v, from, to); });
    for (int i = 0; i < kSweeps; ++i) forAll([&](int v) { return average(v); });
    forAll([&](int v) { return nearestRotation(m_rotations[v]); });
}

template <int Dim>
void VertexRotations<Dim>::turnBack(const std::vector<int>& vertices, std::span<double> b) const {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Eigen::Map<Vec<Dim>> part(b.data() + i * Dim);
        part = (m_rotations[vertices[i]].transpose() * part).eval();
    }
}

template <int Dim>
void VertexRotations<Dim>::turn(const std::vector<int>& vertices, std::span<double> b) const {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Eigen::Map<Vec<Dim>> part(b.data() + i * Dim);
        part = (m_rotations[vertices[i]] * part).eval();
    }
}

template class VertexRotations<2>;
template class VertexRotations<3>;

}  // namespace wend
