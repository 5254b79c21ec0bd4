#include <wend/flow.h>
#include <cstdio>

int main() {
    const auto strip = wend::meshPolygons({{{0, 0}, {4, 0}, {4, 1}, {0, 1}}}, {.vertices = 500});
    wend::Flow<2> flow(strip);
    flow.hold(wend::Place<2>::halfSpace({0.1, 0}, {-1, 0}));
    flow.move(wend::Place<2>::halfSpace({3.9, 0}, {1, 0}), wend::Movement<2>().rotate({2, 0.5}, 1.2));
    const wend::RunResult result = flow.run();
    std::printf("%s %zu vertices, least det F %g\n", result.message.c_str(), flow.points().size(),
                flow.minDet());
    return result.done() ? 0 : 1;
}
