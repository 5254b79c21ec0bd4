#include "core/solver/vertex_rotations.h"

#include <algorithm>
#include <cmath>

#include "core/solver/rotation_kernels.h"

namespace wend {
namespace {

// The number of sweeps. Rough rotations cost more iterations than none. In the plane, where a sweep is cheap,
// ten instead of six save one factor of seven with 11 000 vertices, and those instead of three one of ten; in
// space more than three save none.
template <int Dim>
constexpr int kSweeps = Dim == 2 ? 10 : 3;
constexpr int kVertexGrain = 512;  // vertices of a piece

/// Computes b ← R b for the sign 1, and b ← Rᵀ b for −1.
void turn2(const std::vector<int>& vertices, const double* rotations, double sign, double* b) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const double* const r = rotations + 2 * static_cast<std::ptrdiff_t>(vertices[i]);
        const double c = r[0], s = sign * r[1], x = b[2 * i], y = b[2 * i + 1];
        b[2 * i] = c * x - s * y;
        b[2 * i + 1] = s * x + c * y;
    }
}

}  // namespace

/// Lists the neighbours of every vertex, filled up to a multiple of kGroup.
template <int Dim>
VertexRotations<Dim>::VertexRotations(const AssemblyPlan<Dim>& plan)
    : m_rotations(static_cast<std::size_t>(rotations::grouped(plan.vertexCount)) * kNumbers),
      m_other(m_rotations) {
    std::vector<int> around;
    m_start.push_back(0);
    for (int v = 0; v < plan.vertexCount; ++v) {
        around.clear();
        for (int i = plan.cornerStart[v]; i < plan.cornerStart[v + 1]; ++i)
            for (const int other : plan.cells[plan.corners[i] / (Dim + 1)])
                if (other != v) around.push_back(other);
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        const int count = static_cast<int>(around.size()), length = rotations::grouped(count);
        m_own.push_back(1 - (length - count));
        around.resize(length, v);
        m_neighbours.insert(m_neighbours.end(), around.begin(), around.end());
        m_start.push_back(static_cast<int>(m_neighbours.size()));
    }
}

/// Fits a rotation to the edges of every vertex. Smooth ones use sums over a wider neighbourhood.
template <int Dim>
void VertexRotations<Dim>::compute(const Points<Dim>& from, const Points<Dim>& to, WorkerPool& workers,
                                   Finish finish) {
    constexpr auto sums = Dim == 2 ? rotations::edgeSums2 : rotations::edgeSums3;
    constexpr auto add = Dim == 2 ? rotations::addNeighbours2 : rotations::addNeighbours3;
    constexpr auto nearest = Dim == 2 ? rotations::nearestRotations2 : rotations::nearestRotations3;
    const rotations::Neighbours edges{m_start.data(), m_neighbours.data(), m_own.data()};
    const auto forAll = [&](auto&& make) {
        workers.forPieces(static_cast<int>(m_start.size()) - 1, kVertexGrain, make);
    };
    forAll([&](int begin, int end) { sums(edges, begin, end, from.data(), to.data(), m_rotations.data()); });
    const int sweeps = finish == Finish::Smooth ? kSweeps<Dim> : 0;
    for (int i = 0; i < sweeps; ++i) {
        forAll([&](int begin, int end) { add(edges, begin, end, m_rotations.data(), m_other.data()); });
        m_rotations.swap(m_other);
    }
    forAll([&](int begin, int end) { nearest(begin, end, m_rotations.data()); });
}

template <int Dim>
Mat<Dim> VertexRotations<Dim>::rotation(int vertex) const {
    const double* const r = m_rotations.data() + static_cast<std::ptrdiff_t>(vertex) * kNumbers;
    if constexpr (Dim == 2)
        return (Mat2() << r[0], -r[1], r[1], r[0]).finished();
    else
        return Mat3(r);
}

template <int Dim>
void VertexRotations<Dim>::turnBack(const std::vector<int>& vertices, std::span<double> b) const {
    if constexpr (Dim == 2) return turn2(vertices, m_rotations.data(), -1, b.data());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Eigen::Map<Vec<Dim>> part(b.data() + i * Dim);
        part = (rotation(vertices[i]).transpose() * part).eval();
    }
}

template <int Dim>
void VertexRotations<Dim>::turn(const std::vector<int>& vertices, std::span<double> b) const {
    if constexpr (Dim == 2) return turn2(vertices, m_rotations.data(), 1, b.data());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Eigen::Map<Vec<Dim>> part(b.data() + i * Dim);
        part = (rotation(vertices[i]) * part).eval();
    }
}

template <int Dim>
void VertexRotations<Dim>::turn(Points<Dim>& field) const {
    for (Eigen::Index v = 0; v < field.cols(); ++v)
        field.col(v) = (rotation(static_cast<int>(v)) * field.col(v)).eval();
}

template class VertexRotations<2>;
template class VertexRotations<3>;

}  // namespace wend
