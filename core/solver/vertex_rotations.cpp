#include "core/solver/vertex_rotations.h"

#include <algorithm>
#include <cmath>

#include "core/system/run_time_dispatch.h"

namespace wend {
namespace {

// Rough rotations cost more iterations than none. In the plane, where a sweep is cheap, ten instead of six
// save one factor of seven with 11 000 vertices, and those instead of three one of ten; in space more than
// three save none.
template <int Dim>
constexpr int kSweeps = Dim == 2 ? 10 : 3;
// Newton's; what remains after them does not matter: any matrix near the rotation serves.
constexpr int kNewtonSteps = 6;
constexpr int kGrain = 512;  // vertices of a piece
constexpr int kLanes = 8;    // matrices that are turned to rotations side by side

/// The neighbours of every vertex, one list after the other.
struct Neighbours {
    const int *start, *list;
};

/// Σ_j (y_j − y) (x_j − x)ᵀ over the edges of a vertex. The rotation that is nearest to it is that of
/// argmin Σ_j ‖(y_j − y) − R (x_j − x)‖². In the plane (a, −b; b, a) is all of it that counts.
void edgeSums2(Neighbours edges, int begin, int end, const double* x, const double* y, double* sums) {
    for (int v = begin; v < end; ++v) {
        double a = 0, b = 0;
        for (int i = edges.start[v]; i < edges.start[v + 1]; ++i) {
            const int j = edges.list[i];
            const double x0 = x[2 * j] - x[2 * v], x1 = x[2 * j + 1] - x[2 * v + 1], y0 = y[2 * j] - y[2 * v],
                         y1 = y[2 * j + 1] - y[2 * v + 1];
            a += y0 * x0 + y1 * x1;
            b += y1 * x0 - y0 * x1;
        }
        sums[2 * v] = a, sums[2 * v + 1] = b;
    }
}
WEND_CLONES void edgeSums3(Neighbours edges, int begin, int end, const double* x, const double* y,
                           double* sums) {
    for (int v = begin; v < end; ++v) {
        double sum[9] = {};
        for (int i = edges.start[v]; i < edges.start[v + 1]; ++i) {
            const int j = edges.list[i];
            for (int c = 0; c < 3; ++c)
                for (int r = 0; r < 3; ++r)
                    sum[c * 3 + r] += (y[j * 3 + r] - y[v * 3 + r]) * (x[j * 3 + c] - x[v * 3 + c]);
        }
        std::copy_n(sum, 9, sums + v * 9);
    }
}

/// Every matrix and those of its vertex's neighbours, added up. Sums of edges over a wider surrounding: their
/// lengths and number are the weights. Two sums side by side, since one waits for each of its additions.
template <int kSize>
inline void addNeighbours(Neighbours edges, int first, int last, const double* in, double* out) {
    for (int v = first; v < last; ++v) {
        double sum[kSize], other[kSize] = {};
        std::copy_n(in + v * kSize, kSize, sum);
        int i = edges.start[v];
        const int end = edges.start[v + 1];
        for (; i + 1 < end; i += 2)
            for (int k = 0; k < kSize; ++k) {
                sum[k] += in[edges.list[i] * kSize + k];
                other[k] += in[edges.list[i + 1] * kSize + k];
            }
        if (i < end)
            for (int k = 0; k < kSize; ++k) sum[k] += in[edges.list[i] * kSize + k];
        for (int k = 0; k < kSize; ++k) out[v * kSize + k] = sum[k] + other[k];
    }
}

/// (a, b) / √(a² + b²); the identity where there is none.
WEND_CLONES void nearestRotations2(int begin, int end, double* rotations) {
    for (int v = begin; v < end; ++v) {
        const double a = rotations[2 * v], b = rotations[2 * v + 1], square = a * a + b * b,
                     scale = 1 / std::sqrt(square > 0 ? square : 1);
        rotations[2 * v] = square > 0 ? scale * a : 1;
        rotations[2 * v + 1] = scale * b;
    }
}

/// Newton's iteration R ← ½ (γ R + R⁻ᵀ / γ), R⁻ᵀ = cof R / det R, in lanes, with γ² = |R⁻¹| / |R|: of flat
/// cells R is nearly singular, and without it six steps are too few. The identity where a determinant is not
/// positive.
WEND_CLONES void nearestRotations3(int begin, int end, double* matrices) {
    for (int first = begin; first < end; first += kLanes) {
        const int lanes = std::min(kLanes, end - first);
        double R[9][kLanes], least[kLanes];
        for (int l = 0; l < kLanes; ++l) {
            const double* const A = matrices + 9 * (first + std::min(l, lanes - 1));
            double square = 0;
            for (int k = 0; k < 9; ++k) square += A[k] * A[k];
            const double scale = square > 0 ? std::sqrt(3 / square) : 0.0;
            for (int k = 0; k < 9; ++k) R[k][l] = scale * A[k];
            least[l] = 1;
        }
        for (int step = 0; step < kNewtonSteps; ++step) {
            for (int l = 0; l < kLanes; ++l) {
                double C[9], sizeR = 0, sizeC = 0;
                for (int k = 0; k < 9; ++k) {
                    const int c = k / 3, r = k % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3, r1 = (r + 1) % 3,
                              r2 = (r + 2) % 3;
                    C[k] = R[3 * c1 + r1][l] * R[3 * c2 + r2][l] - R[3 * c1 + r2][l] * R[3 * c2 + r1][l];
                }
                const double det = R[0][l] * C[0] + R[1][l] * C[1] + R[2][l] * C[2];
                least[l] = det < least[l] ? det : least[l];
                for (int k = 0; k < 9; ++k) sizeR += R[k][l] * R[k][l], sizeC += C[k] * C[k];
                const double gamma = std::sqrt(std::sqrt(sizeC / sizeR) / det), other = 1 / (gamma * det);
                for (int k = 0; k < 9; ++k) R[k][l] = 0.5 * (gamma * R[k][l] + other * C[k]);
            }
        }
        for (int l = 0; l < lanes; ++l)
            for (int k = 0; k < 9; ++k)
                matrices[9 * (first + l) + k] = least[l] > 0 ? R[k][l] : (k % 4 == 0 ? 1.0 : 0.0);
    }
}

/// sign 1: b ← R b, −1: b ← Rᵀ b.
void turn2(const std::vector<int>& vertices, const double* rotations, double sign, double* b) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const double* const r = rotations + 2 * static_cast<std::ptrdiff_t>(vertices[i]);
        const double c = r[0], s = sign * r[1], x = b[2 * i], y = b[2 * i + 1];
        b[2 * i] = c * x - s * y;
        b[2 * i + 1] = s * x + c * y;
    }
}

void addNeighbours2(Neighbours edges, int begin, int end, const double* in, double* out) {
    addNeighbours<2>(edges, begin, end, in, out);
}
WEND_CLONES void addNeighbours3(Neighbours edges, int begin, int end, const double* in, double* out) {
    addNeighbours<9>(edges, begin, end, in, out);
}

}  // namespace

template <int Dim>
VertexRotations<Dim>::VertexRotations(const AssemblyPlan<Dim>& plan)
    : m_rotations(static_cast<std::size_t>(plan.vertexCount) * kNumbers), m_other(m_rotations) {
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

template <int Dim>
void VertexRotations<Dim>::compute(const Points<Dim>& from, const Points<Dim>& to, WorkerPool& workers,
                                   Finish finish) {
    constexpr auto sums = Dim == 2 ? edgeSums2 : edgeSums3;
    constexpr auto add = Dim == 2 ? addNeighbours2 : addNeighbours3;
    constexpr auto nearest = Dim == 2 ? nearestRotations2 : nearestRotations3;
    const Neighbours edges{m_start.data(), m_neighbours.data()};
    const auto forAll = [&](auto&& make) {
        workers.forPieces(static_cast<int>(m_start.size()) - 1, kGrain, make);
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
        return (Mat<2>() << r[0], -r[1], r[1], r[0]).finished();
    else
        return Mat<3>(r);
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
