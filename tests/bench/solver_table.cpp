// The velocity solver's table: parts of an evaluation, and ten RK4 steps of a 180° bend or twist against the
// paper's scheme (assembly on one thread and a full numeric factorization at every stage), run in the same
// process. solver_table [2D boxes across …] reads "2:37" or "3:10": dimension and boxes across a 4:1(:1) bar.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "core/assembly/cpu_back_end.h"
#include "core/solver/cholesky.h"
#include "core/solver/float_factor.h"
#include "core/solver/reduced_system.h"
#include "core/solver/velocity_history.h"
#include "core/solver/velocity_solver.h"
#include "tests/bench/bar.h"

using namespace wend;
using namespace wend::bench;

namespace {

double seconds(double start) {
    return now() - start;
}

double median(int repeats, const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i <= repeats; ++i) {
        const auto start = now();
        work();
        if (i > 0) times.push_back(seconds(start));
    }
    std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
    return times[repeats / 2];
}

/// The left end is fixed, the right end goes along: 2D round the arc into which the bar bends by 180°, 3D
/// turning by 180° about the bar's axis.
template <int Dim>
struct Scene {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh;
    std::vector<ConstraintRow> rows;
    std::vector<int> vertices;
    double length = 0, width = 0;

    explicit Scene(int n) : mesh(std::make_shared<const SimplicialMesh<Dim>>(bar<Dim>(n))) {
        length = mesh->points.row(0).maxCoeff();
        width = mesh->points.row(1).maxCoeff();
        for (int v = 0; v < mesh->vertexCount(); ++v)
            if (mesh->points(0, v) == 0 || mesh->points(0, v) > length * (1 - 1e-12)) {
                rows.push_back({{{v, 1.0}}});
                vertices.push_back(v);
            }
    }
    Vec<Dim> position(const Vec<Dim>& x, double t) const {
        if (x[0] == 0) return x;
        const double a = std::numbers::pi * t, c = std::cos(a), s = std::sin(a);
        if constexpr (Dim == 2) {
            const double y = x[1] - width / 2;
            const double turn = a > 1e-6 ? length / a : 0;
            const double px = a > 1e-6 ? turn * s : length, py = a > 1e-6 ? turn * (1 - c) : length * a / 2;
            return {px - s * y, py + c * y + width / 2};
        } else {
            const double y = x[1] - width / 2, z = x[2] - width / 2;
            return {x[0], c * y - s * z + width / 2, s * y + c * z + width / 2};
        }
    }
    Points<Dim> targets(double t) const {
        Points<Dim> p(Dim, static_cast<Eigen::Index>(vertices.size()));
        for (std::size_t i = 0; i < vertices.size(); ++i)
            p.col(static_cast<Eigen::Index>(i)) = position(mesh->points.col(vertices[i]), t);
        return p;
    }
    Points<Dim> speeds(double t) const {
        constexpr double h = 1e-4;
        return (8 * (targets(t + h) - targets(t - h)) - (targets(t + 2 * h) - targets(t - 2 * h))) / (12 * h);
    }
};

template <int Dim>
struct Run {
    double time = 0;
    Points<Dim> pose;
    SolverStatistics statistics;
};

template <int Dim>
Run<Dim> rungeKutta(const Scene<Dim>& scene, double phi, double tolerance, int threads, int steps,
                    Smoothing smoothing) {
    const auto material = std::make_shared<const Material<Dim>>(
        Material<Dim>::uniform(scene.mesh->cellCount(), phi, smoothing));
    VelocitySolver<Dim> solver(scene.mesh, material, BackEndKind::Cpu, threads);
    solver.setConstraints(scene.rows);
    solver.setVelocityTolerance(tolerance);
    VelocityHistory<Dim> history;
    const auto start = now();
    Points<Dim> x = scene.mesh->points, k[4];
    const double h = 1.0 / steps;
    const auto evaluate = [&](double t, const Points<Dim>& shape, Points<Dim>& v) {
        const Points<Dim> speeds = scene.speeds(t);
        const auto guess = tolerance > 0 ? history.at(t) : std::nullopt;
        if (!solver.solve(shape, speeds, v, guess).done()) std::printf("failed at %g\n", t);
        if (tolerance > 0) history.record(t, speeds, v);
    };
    for (int i = 0; i < steps; ++i) {
        const double t = i * h;
        evaluate(t, x, k[0]);
        evaluate(t + h / 2, x + h / 2 * k[0], k[1]);
        evaluate(t + h / 2, x + h / 2 * k[1], k[2]);
        evaluate(t + h, x + h * k[2], k[3]);
        x += h / 6 * (k[0] + 2 * k[1] + 2 * k[2] + k[3]);
        solver.project(x, scene.targets(t + h));
    }
    return {seconds(start), x, solver.statistics()};
}

template <int Dim>
void parts(const Scene<Dim>& scene, double phi, Smoothing smoothing) {
    const auto material = Material<Dim>::uniform(scene.mesh->cellCount(), phi, smoothing);
    const auto plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(*scene.mesh, true));
    std::vector<double> blocks(static_cast<std::size_t>(plan->blockCount()) * Dim * Dim);
    const ReducedSystem<Dim> system(*plan, eliminate(scene.rows));
    Cholesky cholesky;
    const auto start = now();
    cholesky.analyze(
        system.columnStart(), system.row(), Dim,
        Dim == 2 && system.unknowns().size() < 8000 ? Ordering::MinimumDegree : Ordering::NestedDissection);
    std::printf("  analyze %.1f ms, nnz(L) %.2fM, %.2f Gflop\n", 1e3 * seconds(start),
                cholesky.factorEntries() / 1e6, cholesky.factorFlops() / 1e9);
    Points<Dim> Av;
    for (int threads : {1, 0}) {
        const auto cpu = makeCpuBackEnd<Dim>(plan, *scene.mesh, material, threads);
        const double shape = median(9, [&] { cpu->setShape(scene.mesh->points); });
        const double assemble = median(9, [&] { cpu->assemble(blocks); });
        const double apply = median(9, [&] { cpu->apply(scene.mesh->points, Av); });
        std::printf("  %-9s setShape %.3f  assemble %.3f  apply %.3f ms\n", cpu->device().c_str(),
                    1e3 * shape, 1e3 * assemble, 1e3 * apply);
    }
    const double gather = median(9, [&] { system.gather(blocks, cholesky.values()); });
    const double factor = median(5, [&] { cholesky.factorize(); });
    std::vector<double> b(system.columnStart().size() - 1, 1.0), x(b.size());
    const double solve = median(9, [&] { cholesky.solve(b, x); });
    FloatFactor single(cholesky.supernodes(), system.columnStart(), system.row());
    std::vector<double> y(b.size());
    const double singleFactor = median(9, [&] { single.factorize(cholesky.values()); });
    const double singleSolve = median(9, [&] { single.solve(b, y); });
    double greatest = 0, difference = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        greatest = std::max(greatest, std::abs(x[i]));
        difference = std::max(difference, std::abs(x[i] - y[i]));
    }
    std::printf("  single precision: factor %.2f (%.0f Gflop/s)  solve %.3f ms, error %.1e\n",
                1e3 * singleFactor, 1e-9 * cholesky.factorFlops() / singleFactor, 1e3 * singleSolve,
                difference / greatest);
    std::printf("  gather %.3f  factor %.2f  solve %.3f ms\n", 1e3 * gather, 1e3 * factor, 1e3 * solve);
}

template <int Dim>
void print(const char* name, const Run<Dim>& run, double paper, const Points<Dim>& reference) {
    const auto& s = run.statistics;
    std::printf(
        "  %-26s %8.1f ms  x%5.2f  factors %3d iterations %4d  (assemble %.0f factor %.0f solve %.0f)  error "
        "%.1e\n",
        name, 1e3 * run.time, paper / run.time, s.factorizations, s.iterations, 1e3 * s.assemble,
        1e3 * s.factor, 1e3 * s.solve, (run.pose - reference).colwise().norm().maxCoeff());
}

template <int Dim>
void table(int n, double phi, Smoothing smoothing) {
    const Scene<Dim> scene(n);
    std::printf("%dD: %d vertices, %d cells\n", Dim, scene.mesh->vertexCount(), scene.mesh->cellCount());
    parts<Dim>(scene, phi, smoothing);
    const auto paper = rungeKutta<Dim>(scene, phi, 0, 1, 10, smoothing);
    print<Dim>("paper's scheme", paper, paper.time, paper.pose);
    for (double tolerance : {1e-3, 1e-4, 3e-5, 1e-6}) {
        char name[64];
        std::snprintf(name, sizeof name, "tolerance %g, 1 thread", tolerance);
        print<Dim>(name, rungeKutta<Dim>(scene, phi, tolerance, 1, 10, smoothing), paper.time, paper.pose);
        std::snprintf(name, sizeof name, "tolerance %g, all", tolerance);
        print<Dim>(name, rungeKutta<Dim>(scene, phi, tolerance, 0, 10, smoothing), paper.time, paper.pose);
    }
}

}  // namespace

int main(int argc, char** argv) {
    double phi = phi::kMetr;
    Smoothing smoothing;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "akvf") phi = phi::kAkvf;
        if (word == "metr") phi = phi::kMetr;
        if (word == "conf") phi = 2.5;
        if (word == "paper") smoothing.kind = SmoothingKind::Paper;
        const int n = std::atoi(word.c_str() + std::min<std::size_t>(2, word.size()));
        if (word.rfind("2:", 0) == 0) table<2>(n, phi, smoothing);
        if (word.rfind("3:", 0) == 0) table<3>(n, phi, smoothing);
    }
}
