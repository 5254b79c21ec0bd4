#include "bench/drag_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "app/engine/motion/fields.h"
#include "app/views/canvas/render_thread.h"
#include "bench/test_picture.h"
#include "core/assembly/cpu_back_end.h"
#include "core/energy/distortion.h"
#include "core/integration/drag_flow.h"

namespace wend {
namespace {

constexpr int kFrames = 60;
constexpr int kWindowWidth = 1280, kWindowHeight = 800;

/// Returns the place of the hand after i samples, relative to the start, in diagonals.
Vec2 handAt(int i) {
    const double jitter = i % 3 == 0 ? 0.001 : 0;
    return {-0.15 * std::pow(i / 60.0, 2), 0.3 * std::sin(0.03 * i) + jitter};
}

template <int Dim>
Motion<Dim> sampleMotion(int i) {
    Translate<Dim> translate;
    translate.by.template head<2>() = handAt(i + 1) - handAt(i);
    return {translate};
}

/// The picture on the screen, with the colour map of the distortion over it, by the window's own painter.
class Screen {
  public:
    explicit Screen(const SimplicialMesh<2>& rest)
        : m_rest(std::make_shared<const SimplicialMesh<2>>(
              SimplicialMesh<2>{kScale * rest.points, rest.cells})) {
        m_request.picture = std::make_shared<const ScreenPicture>(
            std::make_shared<const Image>(testPicture(kWindowWidth, kWindowHeight)));
        m_request.size = QSize(kWindowWidth, kWindowHeight);
        m_request.view.pan(QPointF(0.1 * kWindowWidth, 0.3 * kWindowHeight));
        m_request.map = true;
    }
    void draw(const Points2& pose, Distortion distortion) {
        auto frame = std::make_shared<PosedFrame<2>>();
        frame->rest = m_rest;
        frame->pose = kScale * pose;
        frame->distortion = std::make_shared<const Distortion>(std::move(distortion));
        m_request.colours.range =
            rangeOf(cellValues(*frame, m_request.colours.measure), m_request.colours.measure);
        m_request.frame = std::move(frame);
        if (RenderThread::render(m_request).isNull()) throw std::runtime_error("nothing was drawn");
    }

  private:
    static constexpr double kScale = 0.8 * kWindowWidth;

    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    RenderRequest m_request;
};

struct FrameTimes {
    std::vector<double> flow, whole;
};

template <int Dim>
FrameTimes dragOnce(DragFlow<Dim>& flow, const Body<Dim>& body) {
    std::optional<Screen> picture;
    if constexpr (Dim == 2) picture.emplace(*body.rest);
    FrameTimes times;
    for (int i = 0; i < kFrames; ++i) {
        const Timing lead = measureOnce([&] {
            if (flow.lead({1}, sampleMotion<Dim>(i)).done < 1) throw std::runtime_error("the drag stopped");
        });
        const Timing rest = measureOnce([&] {
            Distortion map = distortion<Dim>(*body.rest, flow.pose());
            if constexpr (Dim == 2) picture->draw(flow.pose(), std::move(map));
        });
        times.flow.push_back(lead.median);
        times.whole.push_back(lead.median + rest.median);
    }
    return times;
}

void add(BenchRecorder& recorder, const std::string& what, int threads, std::vector<double> times) {
    std::ranges::sort(times);
    BenchRow row{what, threads, {}, {}};
    row.time = {times[times.size() / 2], times.front(), times.back(), 0, static_cast<int>(times.size())};
    row.figures = {{"95 % below (ms)", 1e3 * times[times.size() * 95 / 100]}};
    recorder.add(row);
}

}  // namespace

template <int Dim>
void addDragRows(const Body<Dim>& body, BenchRecorder& recorder) {
    struct Energy {
        const char* name;
        double phi;
        double memory = 0;
    };
    constexpr double kElastic = std::numeric_limits<double>::infinity();
    for (const Energy& energy :
         {Energy{"", phi::kMetr}, Energy{", EQUIA", phi::kEquia}, Energy{", elastic", phi::kMetr, kElastic},
          Energy{", elastic, AKVF", phi::kAkvf, kElastic}, Energy{", elastic, EQUIA", phi::kEquia, kElastic},
          Energy{", elastic, CONF", phi::conformal(Dim), kElastic}}) {
        auto own = Material<Dim>::uniform(body.rest->cellCount(), energy.phi, {});
        own.memory = energy.memory;
        const auto material = std::make_shared<const Material<Dim>>(std::move(own));
        for (int threads : {1, 0}) {
            DragFlow<Dim> flow(body.rest, material, body.handles, makeCpuBackEnd<Dim>, threads);
            const FrameTimes times = dragOnce(flow, body);
            add(recorder, std::string("drag frame, flow") + energy.name, threads, times.flow);
            const std::string whole =
                Dim == 2 ? "drag frame, with coloured picture" : "drag frame, with distortion";
            add(recorder, whole + energy.name, threads, times.whole);
        }
    }
}

template void addDragRows<2>(const Body<2>&, BenchRecorder&);
template void addDragRows<3>(const Body<3>&, BenchRecorder&);

}  // namespace wend
