// The texture warp's table: megapixels per second of processor time by filter and number type, on a shape
// that is bent and swells and shrinks like an animal's neck, and on one that is nearly rigid (a turn by 20°).
// warp_table [width height]
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "tests/support/pictures.h"
#include "warp/warp.h"

using namespace wend;
using namespace wend::test;

namespace {

double now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Soft blobs of colour with grain, opaque or with transparent stripes.
Image photograph(int width, int height, int channels, PixelType type) {
    const bool alpha = channels == 4;
    Image image{width, height, channels, type, alpha, alpha, {}, nullptr};
    image.data.resize(image.rowBytes() * static_cast<std::size_t>(height));
    withPixelType(type, [&](auto t) {
        using T = decltype(t);
        unsigned grain = 1;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < channels; ++c) {
                    grain = grain * 1664525 + 1013904223;
                    const double wave = 0.5 + 0.4 * std::sin(x * 0.01 * (c + 1)) * std::cos(y * 0.013 + c);
                    const double value = alpha && c == 3 ? std::clamp(4 * wave, 0.0, 1.0) : wave;
                    reinterpret_cast<T*>(image.row(y))[x * channels + c] =
                        toPixel<T>(static_cast<float>(value + 0.05 * (grain >> 24) / 255.0) * kFull<T>);
                }
    });
    return image;
}

Points<2> bent(const Points<2>& rest, const Vec<2>& size) {
    Points<2> pose = rest;
    for (Eigen::Index i = 0; i < rest.cols(); ++i) {
        const Vec<2> unit = rest.col(i).cwiseQuotient(size) - Vec<2>(0.5, 0.5);
        const double angle = 0.9 * unit.y(), grow = 0.85 + 0.25 * std::sin(5 * unit.x());
        const Vec<2> turned(std::cos(angle) * unit.x() - std::sin(angle) * unit.y(),
                            std::sin(angle) * unit.x() + std::cos(angle) * unit.y());
        pose.col(i) = size.cwiseProduct(grow * turned + Vec<2>(0.5, 0.5));
    }
    return pose;
}

Points<2> nearlyRigid(const Points<2>& rest, const Vec<2>& size) {
    const Eigen::Rotation2Dd turn(20 * std::numbers::pi / 180);
    Points<2> pose = (turn.toRotationMatrix() * (rest.colwise() - size / 2)).colwise() + size / 2;
    for (Eigen::Index i = 0; i < rest.cols(); ++i)
        pose.col(i) += 0.5 * Vec<2>(std::sin(pose(1, i) / 90), std::cos(pose(0, i) / 70));
    return pose;
}

/// Pixels that the shape covers, in millions.
double megapixels(const SimplicialMesh<2>& mesh, const Points<2>& pose, const View& view) {
    WarpOptions options;
    options.filter = Filter::Nearest;
    const Image white = plainPicture(view.width, view.height, {255, 255});
    const Image shown = warpImage(white, mesh, pose, view, options);
    std::size_t count = 0;
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x) count += valueAt<std::uint8_t>(shown, x, y, 1) != 0;
    return 1e-6 * static_cast<double>(count);
}

double seconds(const Pyramid& pyramid, const SimplicialMesh<2>& mesh, const Points<2>& pose, const View& view,
               Filter filter) {
    WarpOptions options;
    options.filter = filter;
    options.threads = 1;
    double best = 1e300;
    for (int k = 0; k < 5; ++k) {
        const double start = now();
        const Image warped = warpImage(pyramid, mesh, pose, view, options);
        best = std::min(best, now() - start);
    }
    return best;
}

}  // namespace

int main(int argc, char** argv) {
    const int width = argc > 2 ? std::atoi(argv[1]) : 2400, height = argc > 2 ? std::atoi(argv[2]) : 2000;
    const Vec<2> size(width, height);
    const View view{width, height, Vec<2>::Zero(), 1};
    const auto mesh = rectangle({0, 0}, size, 70);
    const std::pair<const char*, Points<2>> poses[] = {{"bent", bent(mesh.points, size)},
                                                       {"nearly rigid", nearlyRigid(mesh.points, size)}};
    const char* filters[] = {"nearest", "bilinear", "bicubic", "ewa"};
    std::printf("%-14s %-8s %8s %8s %8s %8s   Mpixel/s and core\n", "shape", "picture", filters[0],
                filters[1], filters[2], filters[3]);
    const std::tuple<const char*, int, PixelType> kinds[] = {{"RGBA8", 4, PixelType::UInt8},
                                                             {"RGB8", 3, PixelType::UInt8},
                                                             {"RGBA16", 4, PixelType::UInt16},
                                                             {"RGBAh", 4, PixelType::Half},
                                                             {"RGBAf", 4, PixelType::Float}};
    for (const auto& [name, channels, type] : kinds) {
        const Pyramid pyramid(std::make_shared<Image>(photograph(width, height, channels, type)));
        for (const auto& [shape, pose] : poses) {
            std::printf("%-14s %-8s", shape, name);
            const double pixels = megapixels(mesh, pose, view);
            for (int filter = 0; filter < 4; ++filter)
                std::printf(" %8.1f",
                            pixels / seconds(pyramid, mesh, pose, view, static_cast<Filter>(filter)));
            std::printf("\n");
        }
    }
}
