#include "warp/warp.h"

#include <atomic>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

#include "core/mesh/error.h"
#include "warp/warp_job.h"

namespace wend {
namespace {

void requireFinite(const Points<2>& pose) {
    if (!pose.allFinite()) throw InputError("the shape has a vertex that is not a finite number");
}

Image emptyOutput(const Image& source, const View& view, bool addsAlpha) {
    Image output{view.width,
                 view.height,
                 source.channels + (addsAlpha ? 1 : 0),
                 source.type,
                 source.alpha || addsAlpha,
                 source.unassociated || addsAlpha,
                 {},
                 source.metadata};
    output.data.resize(static_cast<std::size_t>(view.width) * view.height * output.pixelBytes());
    return output;
}

bool visible(const Points<2>& pixels, const Cell<2>& cell, const View& view) {
    const auto corners = [&](int row) {
        return std::minmax({pixels(row, cell[0]), pixels(row, cell[1]), pixels(row, cell[2])});
    };
    const auto [left, right] = corners(0);
    const auto [top, bottom] = corners(1);
    return left < view.width && right > 0 && top < bottom && top < view.height && bottom > 0;
}

void collectCells(WarpJob& job, const SimplicialMesh<2>& rest, const Points<2>& pose,
                  const Points<2>& pixels) {
    for (int index : paintingOrder(rest.cellCount(), job.options.depth)) {
        const Cell<2>& cell = rest.cells[static_cast<std::size_t>(index)];
        if (!visible(pixels, cell, job.view)) continue;
        const TriangleRows rows(pixels.col(cell[0]), pixels.col(cell[1]), pixels.col(cell[2]));
        const CellMap map(rest.points, pose, cell);
        const Mat<2> jacobian = job.view.scale * (Mat<2>::Identity() - map.gradient);
        const int low = static_cast<int>(std::max(0.0, rows.top()));
        const double high = std::min<double>(job.view.height, rows.bottom());
        for (int band = low / kBandRows; band * kBandRows < high; ++band)
            job.cellsOfBand[static_cast<std::size_t>(band)].push_back(static_cast<int>(job.cells.size()));
        job.cells.push_back({rows, map, CellFilter(jacobian, job.options.filter, job.source.levels())});
    }
}

/// Takes the alpha channel away again from a picture that came without one and is covered everywhere.
void dropAlpha(Image& image) {
    const std::size_t from = image.pixelBytes(), to = from / image.channels * (image.channels - 1);
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
    for (std::size_t p = 0; p < count; ++p)
        std::memmove(image.data.data() + p * to, image.data.data() + p * from, to);
    --image.channels;
    image.alpha = image.unassociated = false;
    image.data.resize(count * to);
}

template <typename T>
bool opaque(const Image& image) {
    const T* alpha = reinterpret_cast<const T*>(image.data.data()) + image.channels - 1;
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
    for (std::size_t p = 0; p < count; ++p, alpha += image.channels)
        if (static_cast<float>(*alpha) != kFull<T>) return false;
    return true;
}

void paintAll(WarpJob& job, int bands) {
    std::atomic<int> next = 0, done = 0;
    std::mutex failing;
    std::exception_ptr failure;  // the first: an exception must not leave a helper
    const auto work = [&] {
        try {
            for (int band; (band = next++) < bands && !job.options.stop.stop_requested();) {
                withPixelType(job.output.type, [&](auto t) { paintBand<decltype(t)>(job, band); });
                if (job.options.progress) job.options.progress(static_cast<double>(++done) / bands);
            }
        } catch (...) {
            const std::scoped_lock lock(failing);
            if (!failure) failure = std::current_exception();
            next = bands;
        }
    };
    int threads =
        job.options.threads > 0 ? job.options.threads : static_cast<int>(std::thread::hardware_concurrency());
    threads = std::clamp(threads, 1, bands);
    std::vector<std::jthread> helpers;
    for (int k = 1; k < threads; ++k) helpers.emplace_back(work);
    work();
    helpers.clear();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace

Image warpImage(const Pyramid& source, const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view,
                const WarpOptions& options) {
    requireFinite(pose);
    const bool addsAlpha =
        !source.base().alpha && source.base().channels < 4 && options.outside == Outside::Transparent;
    const int bands = (view.height + kBandRows - 1) / kBandRows;
    WarpJob job{source, view, options, emptyOutput(source.base(), view, addsAlpha), addsAlpha, {}, {}, {}};
    if (bands <= 0 || view.width <= 0) return std::move(job.output);
    const Points<2> pixels = (pose.colwise() - view.origin) / view.scale;
    job.cellsOfBand.resize(static_cast<std::size_t>(bands));
    collectCells(job, rest, pose, pixels);
    job.outline = options.antialias ? OutlinePixels(rest, pixels, view.width, view.height, kBandRows)
                                    : OutlinePixels(bands, kBandRows);
    paintAll(job, bands);
    if (options.stop.stop_requested()) return {};
    if (addsAlpha && withPixelType(job.output.type, [&](auto t) { return opaque<decltype(t)>(job.output); }))
        dropAlpha(job.output);
    return std::move(job.output);
}

Image warpImage(const Image& source, const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view,
                const WarpOptions& options) {
    // The caller keeps the picture; levels are made only as far as the view shrinks it, or the shape might.
    const std::shared_ptr<const Image> borrowed(std::shared_ptr<const Image>(), &source);
    return warpImage(Pyramid(borrowed, options.filter == Filter::Nearest ? 0 : -1), rest, pose, view,
                     options);
}

}  // namespace wend
