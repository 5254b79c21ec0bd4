// flow_fuzzer SEED COUNT [FIRST]: deforms COUNT random shapes, half of them in the plane and half in space,
// by random handles, and checks every accepted state and frames between: no cell may be inverted, and
// constrained points must be in their places to 1e-12 of the size. A flow that cannot continue has to report
// the time, the handle and the place. The same seed gives the same flows; exit code 0 if there is no fault.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <regex>

#include "core/base/error.h"
#include "core/mesh/shape_size.h"
#include "tests/fuzz/random_flow.h"

using namespace wend;
using fuzz::RandomFlow;

namespace {

constexpr double kPrecision = 1e-12;  // of the size

struct Tally {
    int flows = 0, arrived = 0, refused = 0, settled = 0, remembering = 0;
    int folding = 0, tooFast = 0, indefinite = 0, tooStiff = 0;
    long states = 0, frames = 0;
    double offPath = 0, offOwn = 0;  // largest, as the program says and by the formulas here
    int findings = 0;
};

std::string printed(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// Unlike the program, uses cofactors in a longer format than that of the coordinates.
template <int Dim>
bool turnedOver(const Points<Dim>& points, const Cell<Dim>& cell) {
    Eigen::Matrix<long double, Dim, Dim> e;
    for (int k = 0; k < Dim; ++k)
        e.col(k) = (points.col(cell[k + 1]) - points.col(cell[0])).template cast<long double>();
    if constexpr (Dim == 2)
        return !(e(0, 0) * e(1, 1) - e(0, 1) * e(1, 0) > 0);
    else
        return !(e.col(0).cross(e.col(1)).dot(e.col(2)) > 0);
}

/// Returns the place to which translations and rotations at an even pace move a point; nothing for other
/// motions.
template <int Dim>
std::optional<Vec<Dim>> placeOf(const Handle<Dim>& handle, Vec<Dim> p, double t) {
    for (const Motion<Dim>& motion : handle.motions) {
        const double s = std::clamp((t - motion.start) / (motion.end - motion.start), 0.0, 1.0);
        if (motion.ease != Ease::Linear && s > 0 && s < 1) return {};
        if (const auto* translate = std::get_if<Translate<Dim>>(&motion.kind)) {
            p += s * translate->by;
        } else if (const auto* rotate = std::get_if<Rotate<Dim>>(&motion.kind)) {
            Mat<Dim> R;
            if constexpr (Dim == 2)
                R = Eigen::Rotation2D<double>(s * rotate->angle).toRotationMatrix();
            else
                R = Eigen::AngleAxis<double>(s * rotate->angle, rotate->axis.normalized()).toRotationMatrix();
            p = rotate->centre + R * (p - rotate->centre);
        } else if (s > 0) {
            return {};
        }
    }
    return p;
}

template <int Dim>
class Check {
  public:
    Check(unsigned seed, unsigned number, Tally& tally)
        : m_flow(fuzz::randomFlow<Dim>(seed, number)), m_number(number), m_tally(tally) {}

    void run() try {
        ++m_tally.flows;
        m_size = shapeSize<Dim>(m_flow.mesh->points, m_flow.mesh->cells).size;
        Deformer<Dim> deformer(m_flow.mesh, m_flow.material, m_flow.handles, m_flow.options,
                               BackEndKind::Cpu);
        m_tally.settled += !m_flow.options.settle.empty();
        m_tally.remembering += m_flow.material->memory > 0;
        typename Deformer<Dim>::Watch watch;
        for (int k = 0; k <= 20; ++k) watch.frames.push_back(m_flow.options.end * k / 20);
        watch.onFrame = [&](const State<Dim>& state) {
            ++m_tally.frames;
            look(state.points, state.time, "a frame");
        };
        watch.progress = [&](double t) {
            ++m_tally.states;
            look(deformer.state().points, t, "a state");
        };
        judge(deformer.advance(m_flow.options.end, watch));
        look(deformer.state().points, deformer.state().time, "the end");
        const double off = deformer.statistics().constraintError;
        m_tally.offPath = std::max(m_tally.offPath, off);
        if (!(off <= kPrecision * m_grown)) found("the constraints are off by " + printed(off));
    } catch (const InputError&) {
        ++m_tally.refused;  // two handles that want different things of one point
    }

  private:
    void found(const std::string& what) {
        ++m_tally.findings;
        std::printf("%dD, flow %u: %s\n", Dim, m_number, what.c_str());
    }

    void look(const Points<Dim>& points, double t, const std::string& what) {
        // A shape that has grown has fewer digits after the point.
        m_grown = std::max(m_grown, shapeSize<Dim>(points, m_flow.mesh->cells).size / m_size);
        int inverted = 0;
        for (const Cell<Dim>& cell : m_flow.mesh->cells) inverted += turnedOver<Dim>(points, cell);
        if (inverted > 0)
            found(what + " at time " + std::to_string(t) + " with " + std::to_string(inverted) +
                  " cells turned over");
        for (const Handle<Dim>& handle : m_flow.handles) {
            const auto* ids = std::get_if<std::vector<int>>(&handle.at);
            if (!ids || t > handle.activeTo) continue;
            for (const int v : *ids)
                compare(placeOf<Dim>(handle, m_flow.mesh->points.col(v), t), points.col(v));
        }
    }

    void compare(const std::optional<Vec<Dim>>& place, const Vec<Dim>& point) {
        if (!place) return;
        // Coordinates far from 0 have fewer digits left.
        const double off = (*place - point).norm() / (m_size + place->norm());
        m_tally.offOwn = std::max(m_tally.offOwn, off);
        if (!(off <= kPrecision)) found("a point is off its path by " + printed(off));
    }

    void judge(const AdvanceResult& result) {
        static const std::regex told(
            "at time [0-9.e+-]+ (handle \"number [1-4]\" cannot go on: .*|the shape is too stiff to settle "
            "further .*)near \\([^()]+\\).*"),
            alone("at time [0-9.e+-]+ the shape cannot go on: .*near \\([^()]+\\).*");
        const bool held = std::ranges::any_of(
            m_flow.handles, [&](const Handle<Dim>& handle) { return result.time < handle.activeTo; });
        m_tally.arrived += result.outcome == Outcome::Done;
        m_tally.folding += result.outcome == Outcome::CellInverted;
        m_tally.indefinite += result.outcome == Outcome::SolverFailed;
        const bool stiff = result.message.text().find("too stiff") != std::string::npos;
        m_tally.tooStiff += stiff;
        m_tally.tooFast += result.outcome == Outcome::StepTooSmall && !stiff;
        if (result.outcome != Outcome::Done && !std::regex_match(result.message.text(), held ? told : alone))
            found("stops with \"" + result.message.text() + "\"");
    }

    RandomFlow<Dim> m_flow;
    unsigned m_number;
    Tally& m_tally;
    double m_size = 1, m_grown = 1;  // at rest; times that, at most
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const auto seed = static_cast<unsigned>(std::atoi(argv[1])),
               count = static_cast<unsigned>(std::atoi(argv[2])),
               first = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 0;
    Tally t;
    for (unsigned number = first; number < first + count; ++number) {
        if (number % 2 == 0)
            Check<2>(seed, number, t).run();
        else
            Check<3>(seed, number, t).run();
        std::fflush(stdout);
    }
    std::printf("%d flows (%d with memory, %d that settle), %ld states, %ld frames\n", t.flows, t.remembering,
                t.settled, t.states, t.frames);
    std::printf(
        "arrived %d; stopped: folding %d, too fast %d, too stiff to settle %d, indefinite %d; refused %d\n",
        t.arrived, t.folding, t.tooFast, t.tooStiff, t.indefinite, t.refused);
    std::printf("constrained points off by %.1e of the size, by formulas of their own %.1e\n", t.offPath,
                t.offOwn);
    std::printf("%d findings\n", t.findings);
    return t.findings == 0 ? 0 : 1;
}
