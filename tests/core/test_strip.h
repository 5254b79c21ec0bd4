#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "core/integration/deformer.h"

namespace wend::samples {

/// [0, length] × [0, 1]^(Dim − 1) in along · across^(Dim − 1) boxes, each cut into Dim! cells (Kuhn's
/// subdivision, mirrored in every other box, so that it has no preferred diagonal).
template <int Dim>
SimplicialMesh<Dim> strip(int along, int across, double length) {
    std::array<int, Dim> count;
    count.fill(across);
    count[0] = along;
    SimplicialMesh<Dim> mesh;
    std::array<int, Dim> stride;
    int vertices = 1, boxes = 1;
    for (int a = 0; a < Dim; ++a) {
        stride[a] = vertices;
        vertices *= count[a] + 1;
        boxes *= count[a];
    }
    mesh.points.resize(Dim, vertices);
    for (int v = 0; v < vertices; ++v) {
        for (int a = 0; a < Dim; ++a) {
            mesh.points(a, v) = double(v / stride[a] % (count[a] + 1)) / count[a] * (a == 0 ? length : 1);
        }
    }
    for (int box = 0; box < boxes; ++box) {
        int corner = 0;
        std::array<int, Dim> step = stride, axes;
        for (int a = 0, rest = box; a < Dim; rest /= count[a++]) {
            const int i = rest % count[a];
            corner += (i + i % 2) * stride[a];
            if (i % 2 == 1) step[a] = -stride[a];
        }
        std::iota(axes.begin(), axes.end(), 0);
        do {
            Cell<Dim> cell;
            cell[0] = corner;
            for (int a = 0; a < Dim; ++a) cell[a + 1] = cell[a] + step[axes[a]];
            if (cellMeasure<Dim>(mesh.points, cell) < 0) std::swap(cell[Dim - 1], cell[Dim]);
            mesh.cells.push_back(cell);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    return mesh;
}

/// A strip with its left end held and its right end turned in the plane of x and y.
template <int Dim>
struct Bend {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh;
    std::shared_ptr<const Material<Dim>> material;
    std::vector<Handle<Dim>> handles;

    Bend(int along, int across, double length, double angle, double phi = phi::kMetr)
        : mesh(std::make_shared<SimplicialMesh<Dim>>(strip<Dim>(along, across, length))),
          material(std::make_shared<Material<Dim>>(Material<Dim>::uniform(mesh->cellCount(), phi))) {
        const double cell = length / along;
        Rotate<Dim> rotate;
        rotate.centre[0] = length / 2;
        rotate.centre[1] = length * 0.55;
        rotate.axis[Dim - 1] = 1;
        rotate.angle = angle;
        handles.push_back(at("left", -1, cell / 2));
        handles.push_back(at("right", length - cell / 2, length + 1));
        handles.back().motions.push_back({rotate});
    }

    /// All vertices with x between two bounds.
    static Handle<Dim> at(const char* name, double from, double to) {
        Box<Dim> box{Vec<Dim>::Constant(-10), Vec<Dim>::Constant(10)};
        box.min[0] = from, box.max[0] = to;
        Handle<Dim> handle;
        handle.name = name;
        handle.at = Region<Dim>(box);
        return handle;
    }

    Deformer<Dim> deformer(IntegrationOptions options = {}) const {
        return Deformer<Dim>(mesh, material, handles, options);
    }
};

/// Returns the points at a time; if it cannot be reached, returns no points and prints the reason.
template <int Dim>
Points<Dim> runTo(Deformer<Dim>& deformer, double time, const typename Deformer<Dim>::Watch& watch = {}) {
    const AdvanceResult result = deformer.advance(time, watch);
    if (result.outcome != Outcome::Done) std::fprintf(stderr, "%s\n", result.message.text().c_str());
    return result.outcome == Outcome::Done ? deformer.state().points
                                           : Points<Dim>::Constant(Dim, deformer.state().points.cols(), NAN);
}

/// Largest distance of corresponding columns.
template <class A, class B>
double distance(const A& a, const B& b) {
    return (a - b).colwise().norm().maxCoeff();
}

}  // namespace wend::samples
