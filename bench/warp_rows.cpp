#include "bench/warp_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "bench/test_picture.h"
#include "core/meshing/planar_mesher.h"
#include "warp/warp.h"

namespace wend {
namespace {

constexpr int kWidth = 6000, kHeight = 4000;

/// Turns by 20° about the middle and adds a wave: stretches are between 0.7 and 1.4.
Points2 bent(const Points2& rest) {
    const Vec2 middle(kWidth / 2.0, kHeight / 2.0);
    const double c = std::cos(0.35), s = std::sin(0.35);
    Points2 pose = rest;
    for (Eigen::Index i = 0; i < rest.cols(); ++i) {
        const Vec2 p = rest.col(i) - middle;
        const Vec2 q(c * p.x() - s * p.y(), s * p.x() + c * p.y());
        pose.col(i) = middle + 0.8 * q + Vec2(200 * std::sin(q.y() / 800), 200 * std::sin(q.x() / 1000));
    }
    return pose;
}

struct Depth {
    const char* name;  // behind that of the row
    PixelType type;
    std::vector<Filter> filters;
};

const char* nameOf(Filter filter) {
    constexpr const char* kNames[] = {"nearest", "bilinear", "bicubic", "EWA"};
    return kNames[static_cast<int>(filter)];
}

void addTimedRow(BenchRecorder& recorder, const std::string& name, int threads,
                 const std::function<void()>& work) {
    const Timing timing = measure(recorder.repeats(0.5), work);
    const double megapixels = 1e-6 * kWidth * kHeight;
    recorder.add(
        {name,
         threads,
         timing,
         {{"Mpixel/s", megapixels / timing.median}, {"Mpixel/s and core", megapixels / timing.processor}}});
}

/// Copies as a warp makes its result: into new memory, with every pixel written once.
void copyOf(const Image& image) {
    Image copy{image.width, image.height, image.channels, image.type, image.alpha, image.unassociated, {},
               {}};
    copy.makePixels();
    std::copy(image.data.begin(), image.data.end(), copy.data.begin());
}

}  // namespace

void addWarpRows(BenchRecorder& recorder) {
    PlanarMeshOptions options;
    options.vertices = 5000;
    const SimplicialMesh<2> rest =
        meshOutline(Outline{{{{0, 0}, {kWidth, 0}, {kWidth, kHeight}, {0, kHeight}}}}, options);
    const Points2 pose = bent(rest.points);
    const View view{kWidth, kHeight, Vec2::Zero(), 1};
    const Depth depths[] = {
        {"", PixelType::UInt8, {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa}},
        {", 16 bit", PixelType::UInt16, {Filter::Bilinear, Filter::Ewa}},
        {", float", PixelType::Float, {Filter::Bilinear, Filter::Ewa}}};
    for (const Depth& depth : depths) {
        const Pyramid pyramid(std::make_shared<const Image>(testPicture(kWidth, kHeight, depth.type)));
        addTimedRow(recorder, std::string("copy") + depth.name, 1, [&] { copyOf(pyramid.base()); });
        for (const Filter filter : depth.filters)
            for (int threads : {1, 0}) {
                WarpOptions warp;
                warp.filter = filter;
                warp.threads = threads;
                addTimedRow(recorder, std::string("warp, ") + nameOf(filter) + depth.name, threads,
                            [&] { warpImage(pyramid, rest, pose, view, warp); });
            }
    }
}

}  // namespace wend
