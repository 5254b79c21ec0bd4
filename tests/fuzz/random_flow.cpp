#include "tests/fuzz/random_flow.h"

#include <algorithm>
#include <numbers>

#include "core/energy/cell_energy.h"
#include "core/mesh/cell_geometry.h"
#include "tests/core/test_energy_samples.h"
#include "tests/core/test_strip.h"

namespace wend::fuzz {

namespace {

using Random = std::mt19937;
using test::uniform;

constexpr double kPi = std::numbers::pi;

bool chance(Random& random, double share) {
    return uniform(random, 0, 1) < share;
}
int below(Random& random, int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
}

template <int Dim>
bool upright(const SimplicialMesh<Dim>& mesh) {
    return std::ranges::all_of(mesh.cells, [&](const Cell<Dim>& cell) {
        return cellMeasure<Dim>(mesh.points, cell) > 1e-3 / static_cast<double>(mesh.cells.size());
    });
}

/// Adds waves over the whole shape, and moves every vertex aside a little.
template <int Dim>
Points<Dim> waved(const Points<Dim>& points, Random& random, double edge) {
    Points<Dim> result = points;
    for (int a = 0; a < Dim; ++a) {
        const Vec<Dim> wave = 2 * test::randomMatrix<Dim, 1>(random);
        const double height = uniform(random, 0, 0.3), phase = uniform(random, 0, 2 * kPi);
        for (Eigen::Index v = 0; v < points.cols(); ++v)
            result(a, v) +=
                height * std::sin(wave.dot(points.col(v)) + phase) + edge * uniform(random, -0.15, 0.15);
    }
    return result;
}

/// Leaves out a ball of cells, which makes a notch, a hole or an end of a strip.
template <int Dim>
void cutOut(SimplicialMesh<Dim>& mesh, Random& random) {
    const Vec<Dim> centre = mesh.points.col(below(random, mesh.vertexCount()));
    const double radius = uniform(random, 0.15, 0.35);
    std::vector<Cell<Dim>> left;
    for (const Cell<Dim>& cell : mesh.cells)
        if ((centroid<Dim>(mesh.points, cell) - centre).norm() > radius) left.push_back(cell);
    if (left.size() > mesh.cells.size() / 2) mesh.cells = left;
}

/// Returns a strip or block with waves, notches and holes, rotated, in any unit and anywhere.
template <int Dim>
SimplicialMesh<Dim> randomShape(Random& random) {
    const int across = Dim == 2 ? 2 + below(random, 5) : 1 + below(random, 2);
    const double length = uniform(random, 1, 4);
    SimplicialMesh<Dim> mesh = samples::strip<Dim>(std::max(2, int(length * across)), across, length);
    if (chance(random, 0.4)) cutOut(mesh, random);
    const Points<Dim> plain = mesh.points;
    do mesh.points = waved<Dim>(plain, random, 1.0 / across);
    while (!upright(mesh));
    const Mat<Dim> Q = polarRotation<Dim>(Mat<Dim>::Identity() + test::randomSkew<Dim>(random));
    const double unit = std::pow(10, uniform(random, -2, 3));
    mesh.points =
        (unit * Q * mesh.points).colwise() + Vec<Dim>(3 * unit * test::randomMatrix<Dim, 1>(random));
    return mesh;
}

template <int Dim>
double randomPhi(Random& random) {
    const std::array named{phi::kEquia, phi::kMetr, phi::kAkvf, phi::conformal(Dim)};
    return chance(random, 0.6) ? named[static_cast<std::size_t>(below(random, 4))]
                               : uniform(random, phi::kEquia, phi::conformal(Dim));
}

/// φ and B are constant, blended along a direction, or different in every cell.
template <int Dim>
Material<Dim> randomMaterial(const SimplicialMesh<Dim>& mesh, Random& random) {
    Material<Dim> material = Material<Dim>::uniform(mesh.cellCount(), randomPhi<Dim>(random));
    const int phiKind = below(random, 3), BKind = below(random, 4);
    const double other = randomPhi<Dim>(random), ratio = std::pow(10, uniform(random, 0, 2));
    const Mat<Dim> B = test::randomAnisotropy<Dim>(random, ratio);
    for (int c = 0; c < mesh.cellCount(); ++c) {
        if (phiKind == 1) material.phi[c] += (other - material.phi[c]) * c / mesh.cellCount();
        if (phiKind == 2) material.phi[c] = uniform(random, phi::kEquia, phi::conformal(Dim));
        if (BKind == 1) material.anisotropy.push_back(B);
        if (BKind == 2) material.anisotropy.push_back(c % 2 ? B : Mat<Dim>(Mat<Dim>::Identity()));
        if (BKind == 3 && ratio < 10)
            material.anisotropy.push_back(test::randomAnisotropy<Dim>(random, ratio));
    }
    if (chance(random, 0.1)) material.smoothing.kind = SmoothingKind::Paper;
    if (chance(random, 0.1)) material.smoothing.kind = SmoothingKind::None;
    if (chance(random, 0.5)) material.memory = std::pow(10, uniform(random, -1, 2));
    return material;
}

template <int Dim>
Vec<Dim> someStep(Random& random, double size) {
    return std::pow(uniform(random, 0, 1), 2) * size * test::randomMatrix<Dim, 1>(random);
}

template <int Dim>
Motion<Dim> randomMotion(const Vec<Dim>& at, double size, Random& random) {
    Motion<Dim> motion;
    const int kind = below(random, 4);
    if (kind == 0) {
        motion.kind = Translate<Dim>{someStep<Dim>(random, size)};
    } else if (kind == 1) {
        const Vec<Dim> axis = test::randomMatrix<Dim, 1>(random).normalized();
        motion.kind = Rotate<Dim>{at + someStep<Dim>(random, size), axis, uniform(random, -kPi, kPi)};
    } else if (kind == 2) {
        CurveMotion<Dim> curve;
        curve.interpolation = static_cast<Interpolation>(below(random, 3));
        curve.frame = static_cast<FrameKind>(below(random, 3));
        curve.twist = Dim == 3 && chance(random, 0.3) ? uniform(random, -1, 1) : 0;
        curve.scale = chance(random, 0.3) ? uniform(random, 0.7, 1.3) : 1;
        curve.points = {at};
        for (int i = 0; i < 3; ++i) curve.points.push_back(curve.points.back() + someStep<Dim>(random, size));
        motion.kind = curve;
    } else {
        Recorded<Dim> stroke{{0}, {at}};
        for (int i = 1; i < 5; ++i) {
            stroke.times.push_back(i);
            stroke.points.push_back(stroke.points.back() + someStep<Dim>(random, size / 3));
        }
        motion.kind = stroke;
    }
    motion.ease = static_cast<Ease>(below(random, 4));
    return motion;
}

/// Returns handles at vertices, at points within cells, or at all vertices in a ball.
template <int Dim>
Handle<Dim> randomHandle(const SimplicialMesh<Dim>& mesh, double size, Random& random) {
    const Cell<Dim>& cell = mesh.cells[static_cast<std::size_t>(below(random, mesh.cellCount()))];
    Handle<Dim> handle;
    Vec<Dim> at = mesh.points.col(cell[0]);
    const int kind = below(random, 3);
    if (kind == 0) {
        handle.at = std::vector<int>{cell[0]};
    } else if (kind == 1) {
        at = centroid<Dim>(mesh.points, cell);
        handle.at = std::vector<Vec<Dim>>{at};
    } else {
        handle.at = Region<Dim>(Ball<Dim>{at, uniform(random, 0.05, 0.2) * size});
    }
    const double reach = size * uniform(random, 0.1, 0.7);
    const int motions = below(random, 3);
    for (int i = 0; i < motions; ++i) {
        handle.motions.push_back(randomMotion<Dim>(at, reach, random));
        handle.motions.back().start = i * 0.5;
        handle.motions.back().end = (i + 1) * 0.5;
    }
    if (chance(random, 0.1)) handle.activeTo = uniform(random, 0.3, 0.9);
    return handle;
}

IntegrationOptions randomOptions(Random& random) {
    IntegrationOptions options;
    options.threads = 1;
    options.tolerance = std::pow(10, uniform(random, -5, -3));
    const std::array methods{Method::Adams, Method::Adams, Method::DormandPrince, Method::RungeKutta4,
                             Method::Midpoint};
    options.method = methods[static_cast<std::size_t>(below(random, 5))];
    const bool fixed = options.method == Method::RungeKutta4 || options.method == Method::Midpoint;
    if (fixed) options.steps = 10 + below(random, 60);
    // Steps of a prescribed length are for flows that are not stiff.
    if (!fixed && chance(random, 0.4)) {
        const double start = chance(random, 0.5) ? 1 : uniform(random, 0.2, 0.6);
        options.settle = {{start, start + uniform(random, 0.2, 1)}};
        options.end = std::max(1.0, options.settle[0].end);
    }
    return options;
}

}  // namespace

template <int Dim>
RandomFlow<Dim> randomFlow(unsigned seed, unsigned number) {
    std::seed_seq sequence{seed, number};
    Random random(sequence);
    const auto mesh = std::make_shared<const SimplicialMesh<Dim>>(randomShape<Dim>(random));
    RandomFlow<Dim> flow{mesh, {}, {}, {}};
    flow.material = std::make_shared<const Material<Dim>>(randomMaterial<Dim>(*mesh, random));
    const double size = boundingBoxDiagonal<Dim>(mesh->points);
    const int handles = 1 + below(random, 4);
    for (int i = 0; i < handles; ++i) {
        flow.handles.push_back(randomHandle<Dim>(*mesh, size, random));
        flow.handles.back().name = "number " + std::to_string(i + 1);
    }
    flow.options = randomOptions(random);
    return flow;
}

template RandomFlow<2> randomFlow<2>(unsigned, unsigned);
template RandomFlow<3> randomFlow<3>(unsigned, unsigned);

}  // namespace wend::fuzz
