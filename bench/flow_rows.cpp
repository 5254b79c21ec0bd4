#include "bench/flow_rows.h"

#include <optional>
#include <stdexcept>

#include "core/base/error.h"
#include "core/integration/deformer.h"

namespace wend {
namespace {

constexpr double kAim = 1e-4;          // true error, relative to the diagonal
constexpr double kSearchAim = 0.8e-4;  // on the small body, whose flow differs a little
constexpr double kReference = 1e-7;    // tolerance of the run that the others are compared to
constexpr int kSearchVertices = 1500;  // settings are looked for on a small body: the flow is the same

struct Integrator {
    const char* name;
    Method method;
    bool adaptive;
};
constexpr Integrator kIntegrators[] = {{"Adams", Method::Adams, true},
                                       {"Dormand–Prince 5(4)", Method::DormandPrince, true},
                                       {"Runge–Kutta 4", Method::RungeKutta4, false},
                                       {"midpoint", Method::Midpoint, false}};

struct BrokenDown : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// This part of the path is far enough for a factor.
constexpr double kWarmUp = 0.02;

/// Returns a deformation of the body that is analyzed, and was factorized once as it will be.
template <int Dim>
Deformer<Dim> prepared(const Body<Dim>& body, const IntegrationOptions& options) {
    const auto material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(body.rest->cellCount(), phi::kMetr, {}));
    Deformer<Dim> deformer(body.rest, material, body.handles, options, BackEndKind::Cpu);
    const State<Dim> start = deformer.state();
    deformer.advance(kWarmUp);
    deformer.restore(start);
    return deformer;
}

template <int Dim>
void finish(Deformer<Dim>& deformer) {
    const AdvanceResult result = deformer.advance(1);
    if (result.outcome != Outcome::Done) throw BrokenDown("the benchmark stopped: " + result.message.text());
}

template <int Dim>
Points<Dim> endPose(const Body<Dim>& body, const IntegrationOptions& options) {
    Deformer<Dim> deformer = prepared(body, options);
    finish(deformer);
    return deformer.state().points;
}

template <int Dim>
Points<Dim> referenceOf(const Body<Dim>& body) {
    IntegrationOptions options;
    options.tolerance = kReference;
    return endPose(body, options);
}

template <int Dim>
double errorOf(const Points<Dim>& pose, const Points<Dim>& reference) {
    return (pose - reference).colwise().norm().maxCoeff();
}

IntegrationOptions fixedSteps(Method method, int steps, int threads) {
    IntegrationOptions options;
    options.method = method;
    options.steps = steps;
    options.threads = threads;
    return options;
}

/// Returns the paper's options: assembly on one thread and a factorization at each of the four stages of a
/// step.
IntegrationOptions paperScheme() {
    IntegrationOptions options = fixedSteps(Method::RungeKutta4, 10, 1);
    options.velocityTolerance = 0;
    return options;
}

/// Returns whether a run comes close enough to the reference; false if its steps are so large that it breaks
/// down.
template <int Dim>
bool reaches(const Body<Dim>& body, const IntegrationOptions& options, const Points<Dim>& reference) try {
    return errorOf(endPose(body, options), reference) <= kSearchAim;
} catch (const BrokenDown&) {
    return false;
}

/// Returns the coarsest setting that reaches the aim on a small body.
template <int Dim>
IntegrationOptions coarsest(const Integrator& integrator) {
    static const Body<Dim> body = makeBody<Dim>(kSearchVertices);
    static const Points<Dim> reference = referenceOf(body);
    IntegrationOptions options;
    options.method = integrator.method;
    double tolerance = 3e-3;
    for (int steps = 5; steps <= 1000; steps += 1 + steps / 4, tolerance *= 0.7) {
        options.steps = integrator.adaptive ? 0 : steps;
        options.tolerance = integrator.adaptive ? tolerance : kAim;
        if (reaches(body, options, reference)) break;
    }
    return options;
}

template <int Dim>
class FlowBench {
  public:
    FlowBench(const Body<Dim>& body, double bound, BenchRecorder& recorder)
        : m_body(body), m_recorder(recorder), m_bound(bound), m_reference(referenceOf(body)) {}

    void run() {
        m_paper = add("ten RK4 steps, paper's scheme", paperScheme());
        for (int threads : {1, 0}) add("ten RK4 steps", fixedSteps(Method::RungeKutta4, 10, threads));
        for (const Integrator& integrator : kIntegrators)
            if (!large() || integrator.method != Method::Midpoint) addToAim(integrator);
    }

  private:
    /// Returns whether the body is large. Its runs take many seconds, so each is done once, and none by the
    /// midpoint rule, whose two hundred fields add no information.
    bool large() const { return m_body.rest->vertexCount() > (Dim == 2 ? 30000 : 10000); }

    void addToAim(const Integrator& integrator) {
        for (int threads : {1, 0}) {
            IntegrationOptions options = coarsest<Dim>(integrator);
            options.threads = threads;
            add(std::string("to 1e-4 by ") + integrator.name, options);
        }
    }

    double add(const std::string& what, const IntegrationOptions& options) {
        std::optional<Deformer<Dim>> deformer;
        Statistics before;
        const auto prepare = [&] {
            deformer.emplace(prepared(m_body, options));
            before = deformer->statistics();
        };
        const auto work = [&] { finish(*deformer); };
        const bool slow = m_paper > 2 || large();
        if (slow) prepare();
        BenchRow row{what,
                     options.threads,
                     slow ? measureOnce(work) : measure(m_recorder.repeats(0.5), work, prepare),
                     {}};
        if (m_paper > 0) row.figures.push_back({"times the paper's speed", m_paper / row.time.median});
        row.figures.push_back({"times a solve's bound", row.time.median / m_bound});
        const Statistics& counts = deformer->statistics();
        row.figures.push_back({"evaluations", counts.evaluations - before.evaluations});
        row.figures.push_back({"factorizations", counts.factorizations - before.factorizations});
        row.figures.push_back({"iterations", counts.solverIterations - before.solverIterations});
        row.figures.push_back({"error", errorOf(deformer->state().points, m_reference)});
        m_recorder.add(row);
        return row.time.median;
    }

    const Body<Dim>& m_body;
    BenchRecorder& m_recorder;
    double m_bound;  // of one solve: seconds
    Points<Dim> m_reference;
    double m_paper = 0;
};

}  // namespace

template <int Dim>
void addFlowRows(const Body<Dim>& body, double bound, BenchRecorder& recorder) {
    FlowBench<Dim>(body, bound, recorder).run();
}

template <int Dim>
void addPaperFlow(const Body<Dim>& body, BenchRecorder& recorder) {
    const auto add = [&](const std::string& what, const IntegrationOptions& options) {
        Deformer<Dim> deformer = prepared(body, options);
        const Statistics before = deformer.statistics();
        const Timing time = measureOnce([&] { finish(deformer); });
        const Statistics& after = deformer.statistics();
        const double fields = after.evaluations - before.evaluations;
        recorder.add({what,
                      options.threads,
                      time,
                      {{"analysis (ms)", 1e3 * after.analyze},
                       {"assembly of a field (ms)", 1e3 * (after.assemble - before.assemble) / fields},
                       {"factor + solve of a field (ms)",
                        1e3 * (after.factor - before.factor + after.solve - before.solve) / fields},
                       {"fields", fields},
                       {"factorizations", after.factorizations - before.factorizations}}});
    };
    add("ten RK4 steps, paper's scheme", paperScheme());
    add("ten RK4 steps", fixedSteps(Method::RungeKutta4, 10, 1));
}

template void addFlowRows<2>(const Body<2>&, double, BenchRecorder&);
template void addFlowRows<3>(const Body<3>&, double, BenchRecorder&);
template void addPaperFlow<2>(const Body<2>&, BenchRecorder&);
template void addPaperFlow<3>(const Body<3>&, BenchRecorder&);

}  // namespace wend
