#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

#include "tests/core/test_mesh_samples.h"

namespace wend::bench {

/// Processor time of all threads: what counts on a machine with other work.
inline double now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
/// A bar of 4:1(:1) with n boxes across, inner vertices moved a little; diagonal 1.
template <int Dim>
SimplicialMesh<Dim> bar(int n) {
    const auto unit = samples::grid<Dim>(4 * n);
    SimplicialMesh<Dim> mesh;
    std::vector<int> number(unit.points.cols(), -1);
    for (const auto& cell : unit.cells) {
        const auto inside = [&](int v) {
            for (int k = 1; k < Dim; ++k)
                if (unit.points(k, v) > 0.25 + 1e-9) return false;
            return true;
        };
        if (!std::all_of(cell.begin(), cell.end(), inside)) continue;
        for (int v : cell) number[v] = 0;
        mesh.cells.push_back(cell);
    }
    samples::Random random(3);
    std::vector<Vec<Dim>> points;
    for (int v = 0; v < unit.vertexCount(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int>(points.size());
        const Vec<Dim> x = unit.points.col(v);
        Vec<Dim> moved = x;
        for (int k = 0; k < Dim; ++k)
            if (x[k] > 1e-9 && x[k] < (k == 0 ? 1 : 0.25) - 1e-9) moved[k] += random(-0.05, 0.05) / n;
        points.push_back(moved);
    }
    mesh.points.resize(Dim, static_cast<Eigen::Index>(points.size()));
    for (std::size_t v = 0; v < points.size(); ++v) mesh.points.col(static_cast<Eigen::Index>(v)) = points[v];
    for (auto& cell : mesh.cells)
        for (int& v : cell) v = number[v];
    mesh.points /= boundingBoxDiagonal<Dim>(mesh.points);
    return mesh;
}

}  // namespace wend::bench
