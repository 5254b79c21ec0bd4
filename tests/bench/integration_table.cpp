// The integrators' table: a whole bend (2D) or twist (3D) by 180° with each method and tolerance, against the
// paper's scheme (ten RK4 steps, a factorization at every stage). Processor time; the error is against a run
// of a far smaller tolerance, relative to the diagonal.
// integration_table ["2:37" or "3:10": dimension and boxes across a 4:1(:1) bar …] [metr|akvf|conf|equia]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "core/integration/deformer.h"
#include "tests/bench/bar.h"

using namespace wend;
using namespace wend::bench;

namespace {

template <int Dim>
Handle<Dim> end(const char* name, double from, double to) {
    Box<Dim> box{Vec<Dim>::Constant(-10), Vec<Dim>::Constant(10)};
    box.min[0] = from, box.max[0] = to;
    Handle<Dim> handle;
    handle.name = name;
    handle.at = Region<Dim>(box);
    return handle;
}

/// The left end is held, the right one turned by 180°: in the plane beside the bar, or about its axis.
template <int Dim>
std::vector<Handle<Dim>> turnedEnd(const SimplicialMesh<Dim>& mesh) {
    const double length = mesh.points.row(0).maxCoeff(), width = mesh.points.row(1).maxCoeff();
    Rotate<Dim> rotate;
    rotate.angle = std::numbers::pi;
    if constexpr (Dim == 2) {
        rotate.centre = {length / 2, 0.55 * length};
    } else {
        rotate.centre = {0, width / 2, width / 2};
        rotate.axis = {1, 0, 0};
    }
    std::vector<Handle<Dim>> handles = {end<Dim>("left", -1, 1e-9),
                                        end<Dim>("right", length * (1 - 1e-9), length + 1)};
    handles.back().motions.push_back({rotate});
    return handles;
}

template <int Dim>
struct Result {
    double seconds = 0;
    Points<Dim> pose;
    Statistics statistics;
};

template <int Dim>
Result<Dim> run(std::shared_ptr<const SimplicialMesh<Dim>> mesh, double phi,
                const IntegrationOptions& options) {
    const auto material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(mesh->cellCount(), phi));
    Deformer<Dim> deformer(mesh, material, turnedEnd(*mesh), options, BackEndKind::Cpu);
    deformer.velocity();  // analysis
    const int before = deformer.statistics().factorizations;
    const double start = now();
    const AdvanceResult result = deformer.advance(1);
    if (result.outcome != Outcome::Done) std::printf("%s\n", result.message.c_str());
    Result<Dim> done{now() - start, deformer.state().points, deformer.statistics()};
    done.statistics.factorizations -= before;
    return done;
}

template <int Dim>
void print(const char* name, const Result<Dim>& result, double paper, const Points<Dim>& reference) {
    const Statistics& s = result.statistics;
    std::printf(
        "  %-34s %8.1f ms x%6.2f  steps %3d (%d)  evaluations %3d  factors %3d  iterations %4d  error %.1e\n",
        name, 1e3 * result.seconds, paper / result.seconds, s.steps, s.rejected, s.evaluations,
        s.factorizations, s.solverIterations, (result.pose - reference).colwise().norm().maxCoeff());
    std::fflush(stdout);
}

template <int Dim>
void table(int n, double phi) {
    const auto mesh = std::make_shared<const SimplicialMesh<Dim>>(bar<Dim>(n));
    std::printf("%dD: %d vertices, %d cells\n", Dim, mesh->vertexCount(), mesh->cellCount());
    IntegrationOptions options;
    options.threads = 1;
    options.tolerance = 1e-7;
    const Points<Dim> reference = run<Dim>(mesh, phi, options).pose;
    options.method = Method::RungeKutta4;
    options.steps = 10;
    options.velocityTolerance = 0;
    const auto paper = run<Dim>(mesh, phi, options);
    print<Dim>("paper's scheme, RK4 x 10", paper, paper.seconds, reference);
    for (const double velocityTolerance : {1e-3, 3e-4, 1e-4, 3e-5}) {
        char name[64];
        std::snprintf(name, sizeof name, "RK4 x 10, velocities to %g", velocityTolerance);
        options.velocityTolerance = velocityTolerance;
        print<Dim>(name, run<Dim>(mesh, phi, options), paper.seconds, reference);
    }
    options.steps = 0;
    for (const Method method : {Method::DormandPrince, Method::Adams})
        for (const double tolerance : {1e-3, 2e-4, 1e-4, 5e-5, 1e-5})
            for (const double factor : {1.0, 0.5, 0.2}) {
                char name[64];
                std::snprintf(name, sizeof name, "%s %g, velocities to %g",
                              method == Method::Adams ? "Adams" : "DP5", tolerance, factor * tolerance);
                options.method = method;
                options.tolerance = tolerance;
                options.velocityTolerance = factor * tolerance;
                print<Dim>(name, run<Dim>(mesh, phi, options), paper.seconds, reference);
            }
}

}  // namespace

int main(int argc, char** argv) {
    double phi = phi::kMetr;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "equia") phi = phi::kEquia;
        if (word == "metr") phi = phi::kMetr;
        if (word == "akvf") phi = phi::kAkvf;
        if (word == "conf") phi = 2.5;
        const int n = std::atoi(word.c_str() + std::min<std::size_t>(2, word.size()));
        if (word.rfind("2:", 0) == 0) table<2>(n, phi);
        if (word.rfind("3:", 0) == 0) table<3>(n, phi);
    }
}
