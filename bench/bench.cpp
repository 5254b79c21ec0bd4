#include "bench/bench.h"

#include <algorithm>
#include <thread>

#include "app/cli/arguments.h"
#include "bench/drag_rows.h"
#include "bench/flow_rows.h"
#include "bench/kernel_rows.h"
#include "bench/paper.h"
#include "bench/recorder.h"
#include "bench/solver_rows.h"
#include "bench/warp_rows.h"
#include "bench/window_rows.h"
#include "core/base/error.h"
#include "core/base/simd_target.h"

namespace wend {
namespace {

struct Size {
    const char* name;
    int dimension, vertices;
    bool isShown = false;  // is dragged in the window
};
constexpr Size kSizes[] = {{"2d-5.6k", 2, 5600, true}, {"2d-11k", 2, 11000, true}, {"2d-40k", 2, 40000, true},
                           {"2d-160k", 2, 160000},     {"3d-1.5k", 3, 1500},       {"3d-5k", 3, 5000, true},
                           {"3d-20k", 3, 20000, true}};
constexpr const char *kFlatWindow = "window-2d", *kSolidWindow = "window-3d", *kPartsWindow = "window-parts";
constexpr const char *kWarp = "warp", *kKernels = "kernels";
constexpr const char* kPaper = "paper";  // measures more than speed: only when it is asked for

template <int Dim>
void runSize(const Size& size, BenchRecorder& recorder) {
    const Body<Dim> body = makeBody<Dim>(size.vertices);
    recorder.begin({size.name, Dim, body.rest->vertexCount(), body.rest->cellCount(), {}});
    const double bound = addSolverRows(body, recorder);
    addFlowRows(body, bound, recorder);
    addDragRows(body, recorder);
}

template <int Dim>
void runWindow(const char* name, BenchRecorder& recorder) {
    recorder.begin({name, Dim, 0, 0, {}});
    std::vector<ShownSize> shown;
    for (const Size& size : kSizes)
        if (size.dimension == Dim && size.isShown) shown.push_back({size.name, size.vertices});
    addWindowRows<Dim>(shown, recorder);
}

void requireKnown(const std::vector<std::string>& cases) {
    const std::vector<std::string> known = benchCases();
    for (const std::string& name : cases) {
        if (std::ranges::find(known, name) != known.end()) continue;
        std::string list;
        for (const std::string& one : known) list += " " + one;
        throw UsageError(name + ": is no case of the benchmark; there are" + list);
    }
}

}  // namespace

std::vector<std::string> benchCases() {
    std::vector<std::string> names;
    for (const Size& size : kSizes) names.push_back(size.name);
    names.insert(names.end(), {kFlatWindow, kPartsWindow, kSolidWindow, kWarp, kKernels, kPaper});
    return names;
}

BenchTable runBenchmarks(const BenchOptions& options) {
    requireKnown(options.cases);
    const auto wanted = [&](const std::string& name) {
        return options.cases.empty() || std::ranges::find(options.cases, name) != options.cases.end();
    };
    BenchTable table;
    table.machine = processorName();
    table.cores = static_cast<int>(std::thread::hardware_concurrency());
    table.simd = nameOf(simdTarget());
    BenchRecorder recorder(table, options);
    recorder.remark("SIMD target: " + table.simd);
    for (const Size& size : kSizes) {
        if (!wanted(size.name)) continue;
        size.dimension == 2 ? runSize<2>(size, recorder) : runSize<3>(size, recorder);
    }
    if (wanted(kFlatWindow)) runWindow<2>(kFlatWindow, recorder);
    if (wanted(kPartsWindow)) {
        constexpr int kVertices = 5600;
        recorder.begin({kPartsWindow, 2, kVertices, 0, {}});
        addPartRows(kVertices, recorder);
    }
    if (wanted(kSolidWindow)) runWindow<3>(kSolidWindow, recorder);
    if (wanted(kWarp)) {
        recorder.begin({kWarp, 2, 0, 0, {}});
        addWarpRows(recorder);
    }
    if (wanted(kKernels)) {
        recorder.begin({kKernels, 0, 0, 0, {}});
        addKernelRows(recorder);
    }
    if (std::ranges::find(options.cases, kPaper) != options.cases.end()) {
        PaperOptions paper;
        paper.folder = options.folder;
        table.claims = addPaperCases(paper, recorder);
        for (const BenchClaim& claim : table.claims) recorder.remark(textOf(claim));
    }
    return table;
}

void BenchRecorder::begin(BenchCase heading) {
    remark(headingOf(heading));
    m_table.cases.push_back(std::move(heading));
}

void BenchRecorder::add(BenchRow row) {
    if (m_options.stop.stop_requested()) throw Cancelled();
    remark(textOf(row));
    m_table.cases.back().rows.push_back(std::move(row));
}

void BenchRecorder::remark(const std::string& text) const {
    if (m_options.say) m_options.say(text);
}

int BenchRecorder::repeats(double expectedSeconds) const {
    return expectedSeconds < 1 ? m_options.repeats : std::min(m_options.repeats, 2);
}

}  // namespace wend
