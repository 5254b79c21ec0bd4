// The drag's table: processor time of a frame while the middle of one end of a bar is led along a wavy way,
// its distortion included, in milliseconds: median, 95 %, greatest.
// drag_table ["2:37" or "3:10": dimension and boxes across a 4:1(:1) bar …] [metr|akvf|conf|equia] [1: one
// thread]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/assembly/cpu_back_end.h"
#include "core/energy/distortion.h"
#include "core/integration/drag_flow.h"
#include "tests/bench/bar.h"

using namespace wend;
using namespace wend::bench;

namespace {

void print(const char* name, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const auto part = [&](double p) { return 1e3 * times[static_cast<std::size_t>(p * (times.size() - 1))]; };
    std::printf("  %-12s %7.2f %7.2f %7.2f\n", name, part(0.5), part(0.95), part(1));
}

/// The left end is held, one vertex in the middle of the right end led.
template <int Dim>
std::vector<Handle<Dim>> handlesOf(const SimplicialMesh<Dim>& mesh) {
    const double length = mesh.points.row(0).maxCoeff(), width = mesh.points.row(1).maxCoeff();
    Box<Dim> box{Vec<Dim>::Constant(-10), Vec<Dim>::Constant(10)};
    box.max[0] = 1e-9;
    std::vector<Handle<Dim>> handles(2);
    handles[0].at = Region<Dim>(box);
    Vec<Dim> middle = Vec<Dim>::Constant(width / 2);
    middle[0] = length;
    int nearest = 0;
    (mesh.points.colwise() - middle).colwise().squaredNorm().minCoeff(&nearest);
    handles[1].at = std::vector<int>{nearest};
    return handles;
}

template <int Dim>
void table(int n, double phi, int threads) {
    const auto mesh = std::make_shared<const SimplicialMesh<Dim>>(bar<Dim>(n));
    const auto material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(mesh->cellCount(), phi));
    std::printf("%dD: %d vertices, %d cells\n", Dim, mesh->vertexCount(), mesh->cellCount());
    double start = now();
    DragFlow<Dim> flow(mesh, material, handlesOf(*mesh), makeCpuBackEnd<Dim>, threads);
    std::printf("  preparation %.1f ms\n", 1e3 * (now() - start));
    std::vector<double> lead, whole;
    const auto at = [](int i) { return std::array{-0.2 * std::pow(i / 120.0, 2), 0.3 * std::sin(0.02 * i)}; };
    for (int i = 0; i < 120; ++i) {
        Translate<Dim> translate;
        const double jitter = i % 3 == 0 ? 0.002 : 0;
        translate.by[0] = at(i + 1)[0] - at(i)[0], translate.by[1] = at(i + 1)[1] - at(i)[1] + jitter;
        start = now();
        if (flow.lead({1}, {translate}).done < 1) std::printf("stopped\n");
        lead.push_back(now() - start);
        const Distortion d = distortion<Dim>(*mesh, flow.pose());
        whole.push_back(now() - start);
        if (d.flips > 0) std::printf("%d flips\n", d.flips);
    }
    print("lead", lead);
    print("whole", whole);
    std::printf("  evaluations %d factorizations %d iterations %d\n", flow.evaluations(),
                flow.statistics().factorizations, flow.statistics().iterations);
}

}  // namespace

int main(int argc, char** argv) {
    double phi = phi::kMetr;
    int threads = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "equia") phi = phi::kEquia;
        if (word == "metr") phi = phi::kMetr;
        if (word == "akvf") phi = phi::kAkvf;
        if (word == "conf") phi = 2.5;
        if (word == "1") threads = 1;
        const int n = std::atoi(word.c_str() + std::min<std::size_t>(2, word.size()));
        if (word.rfind("2:", 0) == 0) table<2>(n, phi, threads);
        if (word.rfind("3:", 0) == 0) table<3>(n, phi, threads);
    }
}
