#include "app/bench/drag_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/bench/test_picture.h"
#include "core/assembly/cpu_back_end.h"
#include "core/energy/distortion.h"
#include "core/integration/drag_flow.h"
#include "warp/warp.h"

namespace wend {
namespace {

constexpr int kFrames = 60;
constexpr int kWindowWidth = 1280, kWindowHeight = 800;

/// Where the hand is after i samples, relative to the start, in diagonals.
Vec<2> handAt(int i) {
    const double jitter = i % 3 == 0 ? 0.001 : 0;
    return {-0.15 * std::pow(i / 60.0, 2), 0.3 * std::sin(0.03 * i) + jitter};
}

template <int Dim>
Motion<Dim> sampleMotion(int i) {
    Translate<Dim> translate;
    translate.by.template head<2>() = handAt(i + 1) - handAt(i);
    return {translate};
}

/// The picture on the screen, as the window draws it while the shape moves.
class ScreenPicture {
  public:
    explicit ScreenPicture(const SimplicialMesh<2>& rest)
        : m_scale(kWindowWidth * 0.8),
          m_rest(rest),
          m_pyramid(std::make_shared<const Image>(testPicture(kWindowWidth, kWindowHeight))) {
        m_rest.points = toPixels(rest.points);
        m_options.filter = Filter::Bilinear;
    }
    void draw(const Points<2>& pose) const {
        const View view{kWindowWidth, kWindowHeight, Vec<2>(-0.1 * kWindowWidth, -0.3 * kWindowHeight), 1};
        warpImage(m_pyramid, m_rest, toPixels(pose), view, m_options);
    }

  private:
    Points<2> toPixels(const Points<2>& points) const { return m_scale * points; }

    double m_scale;
    SimplicialMesh<2> m_rest;
    Pyramid m_pyramid;
    WarpOptions m_options;
};

struct FrameTimes {
    std::vector<double> flow, whole;
};

template <int Dim>
FrameTimes dragOnce(DragFlow<Dim>& flow, const Body<Dim>& body) {
    std::function<void(const Points<Dim>&)> draw = [](const Points<Dim>&) {};
    if constexpr (Dim == 2)
        draw = [picture = std::make_shared<const ScreenPicture>(*body.rest)](const Points<2>& pose) {
            picture->draw(pose);
        };
    FrameTimes times;
    for (int i = 0; i < kFrames; ++i) {
        const Timing lead = measureOnce([&] {
            if (flow.lead({1}, sampleMotion<Dim>(i)).done < 1) throw std::runtime_error("the drag stopped");
        });
        const Timing rest = measureOnce([&] {
            distortion<Dim>(*body.rest, flow.pose());
            draw(flow.pose());
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
    const auto material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(body.rest->cellCount(), phi::kMetr, {}));
    for (int threads : {1, 0}) {
        DragFlow<Dim> flow(body.rest, material, body.handles, makeCpuBackEnd<Dim>, threads);
        const FrameTimes times = dragOnce(flow, body);
        add(recorder, "drag frame, flow", threads, times.flow);
        add(recorder, Dim == 2 ? "drag frame, distortion and picture" : "drag frame, distortion", threads,
            times.whole);
    }
}

template void addDragRows<2>(const Body<2>&, BenchRecorder&);
template void addDragRows<3>(const Body<3>&, BenchRecorder&);

}  // namespace wend
