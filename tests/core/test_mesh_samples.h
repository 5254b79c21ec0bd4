#pragma once

#include <numeric>
#include <random>

#include "core/mesh/simplicial_mesh.h"

namespace wend::samples {

/// The unit square or cube in n^Dim boxes, each cut into Dim! cells of positive orientation (Kuhn's
/// subdivision: one cell per order of the axes).
template <int Dim>
SimplicialMesh<Dim> grid(int n) {
    SimplicialMesh<Dim> mesh;
    const auto power = [](int base, int exponent) {
        int result = 1;
        for (int i = 0; i < exponent; ++i) result *= base;
        return result;
    };
    mesh.points.resize(Dim, power(n + 1, Dim));
    for (int v = 0; v < mesh.vertexCount(); ++v)
        for (int k = 0; k < Dim; ++k) mesh.points(k, v) = double(v / power(n + 1, k) % (n + 1)) / n;
    for (int box = 0; box < power(n, Dim); ++box) {
        int corner = 0;
        for (int k = 0; k < Dim; ++k) corner += box / power(n, k) % n * power(n + 1, k);
        std::array<int, Dim> axes;
        std::iota(axes.begin(), axes.end(), 0);
        do {
            Cell<Dim> cell;
            cell[0] = corner;
            for (int k = 0; k < Dim; ++k) cell[k + 1] = cell[k] + power(n + 1, axes[k]);
            if (cellMeasure<Dim>(mesh.points, cell) < 0) std::swap(cell[Dim - 1], cell[Dim]);
            mesh.cells.push_back(cell);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    return mesh;
}

/// Uniform in [low, high]; the same numbers on every run.
class Random {
  public:
    explicit Random(unsigned seed = 1) : m_engine(seed) {}
    double operator()(double low = 0, double high = 1) {
        return low + (high - low) * (static_cast<double>(m_engine()) / 4294967296.0);
    }
    int index(int count) { return static_cast<int>((*this)(0, count)); }
    template <int Dim>
    Vec<Dim> point(double low = 0, double high = 1) {
        Vec<Dim> p;
        for (int k = 0; k < Dim; ++k) p[k] = (*this)(low, high);
        return p;
    }

  private:
    std::mt19937 m_engine;
};

/// The grid with every vertex moved by up to `amount` of the spacing.
template <int Dim>
SimplicialMesh<Dim> jitteredGrid(int n, double amount = 0.15) {
    auto mesh = grid<Dim>(n);
    Random random(7);
    for (int v = 0; v < mesh.vertexCount(); ++v)
        mesh.points.col(v) += random.point<Dim>(-amount / n, amount / n);
    return mesh;
}

}  // namespace wend::samples
