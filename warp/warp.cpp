#include "warp/warp.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <thread>

#include "core/mesh/error.h"
#include "warp/cell_map.h"
#include "warp/coverage.h"
#include "warp/outline_pixels.h"
#include "warp/sampling.h"

namespace wend {
namespace {

constexpr int kBandRows = 32;

/// All that the bands share.
struct Job {
    const Pyramid& source;
    const Points<2>& rest;
    const Points<2>& pose;
    const std::vector<Cell<2>>& cells;
    const View& view;
    const WarpOptions& options;
    std::vector<std::vector<int>> cellsOfBand;  // in painting order
    OutlinePixels outline;                      // pixels that need coverage
    Image output;
    bool addsAlpha = false;

    Vec<2> plane(double x, double y) const { return view.origin + view.scale * Vec<2>(x, y); }
    Vec<2> pixel(int vertex) const { return (pose.col(vertex) - view.origin) / view.scale; }
    TriangleRows rows(int cell) const {
        return {pixel(cells[cell][0]), pixel(cells[cell][1]), pixel(cells[cell][2])};
    }
};

/// First pixel whose centre is at or after x.
int firstPixel(double x, int size) {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(size)));
}

/// Paints the rows of one band of a picture of N channels of type T with the filter F.
template <typename T, int N, Filter F>
class BandPainter {
  public:
    BandPainter(Job& job, int band)
        : m_job(job),
          m_band(band),
          m_begin(band * kBandRows),
          m_end(std::min(job.view.height, m_begin + kBandRows)) {
        for (int k = 0; k < job.source.levels(); ++k) m_samplers.emplace_back(job.source.level(k));
    }

    void paint() {
        fillOutside();
        for (int cell : m_job.cellsOfBand[m_band]) paintCell(cell);
        resolveOutline();
    }

  private:
    static constexpr int kMost = 4;
    int channels() const { return m_job.output.channels; }
    T* target(int x, int y) {
        return reinterpret_cast<T*>(m_job.output.row(y)) + static_cast<std::size_t>(x) * channels();
    }

    void put(T* to, const Colour& colour) const {
        for (int c = 0; c < N; ++c) to[c] = toPixel<T>(colour[c]);
        if (m_job.addsAlpha) to[N] = toPixel<T>(kFull<T>);
    }

    Colour sample(const CellFilter& filter, const Vec<2>& at) const {
        const Sampler<T, N>& sampler = m_samplers[filter.level];
        const double shrink = std::ldexp(1.0, -filter.level);
        const double x = at.x() * shrink, y = at.y() * shrink;
        if constexpr (F == Filter::Nearest) return sampler.nearest(x, y);
        if constexpr (F == Filter::Bilinear) return sampler.bilinear(x, y);
        if constexpr (F == Filter::Bicubic) return sampler.bicubic(x, y);
        if (filter.ellipse == 0) return sampler.bicubic(x, y);
        const Colour colour = sampler.elliptical(x, y, filter.inverse, filter.reach, m_kernel);
        if (filter.ellipse == 1) return colour;
        const float t = static_cast<float>(filter.ellipse);
        return t * colour + (1 - t) * sampler.bicubic(x, y);
    }

    void paintCell(int cell) {
        const TriangleRows rows = m_job.rows(cell);
        const CellMap map(m_job.rest, m_job.pose, m_job.cells[cell]);
        const CellFilter filter(m_job.view.scale * (Mat<2>::Identity() - map.gradient), F,
                                m_job.source.levels());
        const Vec<2> step = m_job.view.scale * map.gradient.col(0);
        for (int y = std::max(m_begin, firstPixel(rows.top(), m_end)); y < m_end && y + 0.5 < rows.bottom();
             ++y) {
            const Span span = rows.at(y + 0.5);
            const int begin = firstPixel(span.begin, m_job.view.width),
                      end = firstPixel(span.end, m_job.view.width);
            if (begin >= end) continue;
            const Vec<2> first = m_job.plane(begin + 0.5, y + 0.5);
            const Vec<2> displacement = first - map.source(first);
            T* to = target(begin, y);
            for (int x = begin; x < end; ++x, to += channels()) {
                const double along = x - begin;
                const Vec<2> at(first.x() + along * m_job.view.scale - (displacement.x() + along * step.x()),
                                first.y() - (displacement.y() + along * step.y()));
                put(to, sample(filter, at));
            }
        }
    }

    // --- outside the shape
    // -----------------------------------------------------------------------------------------

    bool inPicture(const Vec<2>& p) const {
        const Image& image = m_job.source.base();
        return p.x() >= 0 && p.y() >= 0 && p.x() < image.width && p.y() < image.height;
    }

    /// The colour beside the shape, alpha behind the picture's own channels if one is added.
    std::array<float, kMost + 1> outsideColour(int x, int y) const {
        std::array<float, kMost + 1> colour{};
        const Vec<2> p = m_job.plane(x + 0.5, y + 0.5);
        const Outside kind = m_job.options.outside;
        if (kind == Outside::Clamp || (kind == Outside::Original && inPicture(p))) {
            const Colour sampled =
                sample(CellFilter(m_job.view.scale * Mat<2>::Identity(), F, m_job.source.levels()), p);
            std::copy_n(sampled.data(), N, colour.begin());
            colour[N] = kFull<T>;
        } else if (kind == Outside::Colour) {
            const auto& given = m_job.options.colour;
            const bool alpha = m_job.output.alpha;
            const int colours = channels() - (alpha ? 1 : 0);
            const float divide = m_job.output.unassociated && given[3] > 0 ? given[3] : 1;
            for (int c = 0; c < colours; ++c) colour[c] = given[std::min(c, 2)] / divide * kFull<T>;
            if (alpha) colour[colours] = given[3] * kFull<T>;
        }
        return colour;
    }

    void fillOutside() {
        for (int y = m_begin; y < m_end; ++y)
            for (int x = 0; x < m_job.view.width; ++x) putOutside(x, y);
    }

    void putOutside(int x, int y) {
        if (m_job.options.outside == Outside::Transparent) {
            std::fill_n(target(x, y), channels(), T(0));
            return;
        }
        const auto colour = outsideColour(x, y);
        for (int c = 0; c < channels(); ++c) target(x, y)[c] = toPixel<T>(colour[c]);
    }

    // --- the outline
    // -----------------------------------------------------------------------------------------------

    struct Piece {
        int pixel, cell;
        std::uint64_t samples;
    };

    /// What the cells cover of the outline's pixels, cell by cell in painting order.
    std::vector<Piece> pieces() const {
        std::vector<Piece> list;
        for (int cell : m_job.cellsOfBand[m_band])
            m_job.outline.visit(m_band, m_job.rows(cell), [&](int pixel, std::uint64_t samples) {
                list.push_back({pixel, cell, samples});
            });
        std::stable_sort(list.begin(), list.end(),
                         [](const Piece& a, const Piece& b) { return a.pixel < b.pixel; });
        return list;
    }

    void resolveOutline() {
        const std::vector<Piece> list = pieces();
        std::size_t at = 0;
        for (const auto& pixel : m_job.outline.pixels(m_band)) {
            const std::size_t begin = at;
            while (at < list.size() && list[at].pixel == pixel.index) ++at;
            resolve(pixel.x, pixel.y, list.data() + begin, list.data() + at);
        }
    }

    /// Mixes what shows of each cell, from the top one down, and what is left of the outside.
    void resolve(int x, int y, const Piece* begin, const Piece* end) {
        std::array<double, kMost + 1> sum{};
        std::array<float, kMost + 1> first{};
        bool same = true;
        std::uint64_t left = ~std::uint64_t{0};
        const auto mix = [&](const std::array<float, kMost + 1>& colour, int samples) {
            if (left == ~std::uint64_t{0}) first = colour;
            same = same && colour == first;
            const double weight = samples / 64.0;
            const bool multiply = m_job.output.unassociated;
            const double alpha = multiply ? static_cast<double>(colour[channels() - 1]) / kFull<T> : 1;
            for (int c = 0; c < channels(); ++c)
                sum[c] += weight * colour[c] * (multiply && c == channels() - 1 ? 1 : alpha);
        };
        for (const Piece* piece = end; piece-- != begin && left != 0;) {
            const std::uint64_t shown = piece->samples & left;
            if (shown == 0) continue;
            const CellMap map(m_job.rest, m_job.pose, m_job.cells[piece->cell]);
            const CellFilter filter(m_job.view.scale * (Mat<2>::Identity() - map.gradient), F,
                                    m_job.source.levels());
            const Colour sampled = sample(filter, map.source(m_job.plane(x + 0.5, y + 0.5)));
            std::array<float, kMost + 1> colour{};
            std::copy_n(sampled.data(), N, colour.begin());
            if (m_job.addsAlpha) colour[N] = kFull<T>;
            mix(colour, std::popcount(shown));
            left &= ~shown;
        }
        if (left != 0) mix(outsideColour(x, y), std::popcount(left));
        T* to = target(x, y);
        if (same) {
            for (int c = 0; c < channels(); ++c) to[c] = toPixel<T>(first[c]);
            return;
        }
        const double alpha = m_job.output.unassociated ? sum[channels() - 1] / kFull<T> : 1;
        for (int c = 0; c < channels(); ++c) {
            const bool colour = !m_job.output.unassociated || c < channels() - 1;
            to[c] = toPixel<T>(static_cast<float>(colour && alpha > 0 ? sum[c] / alpha : sum[c]));
        }
    }

    Job& m_job;
    int m_band, m_begin, m_end;
    RadialKernel m_kernel;
    std::vector<Sampler<T, N>> m_samplers;
};

template <typename T, int N>
void paintBand(Job& job, int band) {
    switch (job.options.filter) {
        case Filter::Nearest:
            BandPainter<T, N, Filter::Nearest>(job, band).paint();
            break;
        case Filter::Bilinear:
            BandPainter<T, N, Filter::Bilinear>(job, band).paint();
            break;
        case Filter::Bicubic:
            BandPainter<T, N, Filter::Bicubic>(job, band).paint();
            break;
        case Filter::Ewa:
            BandPainter<T, N, Filter::Ewa>(job, band).paint();
            break;
    }
}

void paintBand(Job& job, int band) {
    withPixelType(job.output.type, [&](auto t) {
        using T = decltype(t);
        switch (job.source.base().channels) {
            case 1:
                paintBand<T, 1>(job, band);
                break;
            case 2:
                paintBand<T, 2>(job, band);
                break;
            case 3:
                paintBand<T, 3>(job, band);
                break;
            default:
                paintBand<T, 4>(job, band);
                break;
        }
    });
}

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

std::vector<std::vector<int>> sortIntoBands(const Job& job, int bands) {
    std::vector<std::vector<int>> lists(static_cast<std::size_t>(bands));
    for (int cell : paintingOrder(static_cast<int>(job.cells.size()), job.options.depth)) {
        const TriangleRows rows = job.rows(cell);
        const double low = std::max(0.0, std::floor(rows.top())),
                     high = std::min<double>(job.view.height, rows.bottom());
        if (!(low < high) || !(rows.top() < rows.bottom())) continue;
        for (int band = static_cast<int>(low) / kBandRows; band * kBandRows < high; ++band)
            lists[band].push_back(cell);
    }
    return lists;
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

void paintAll(Job& job, int bands) {
    std::atomic<int> next = 0, done = 0;
    const auto work = [&] {
        for (int band; (band = next++) < bands && !job.options.stop.stop_requested();) {
            paintBand(job, band);
            if (job.options.progress) job.options.progress(static_cast<double>(++done) / bands);
        }
    };
    int threads =
        job.options.threads > 0 ? job.options.threads : static_cast<int>(std::thread::hardware_concurrency());
    threads = std::clamp(threads, 1, bands);
    std::vector<std::jthread> helpers;
    for (int k = 1; k < threads; ++k) helpers.emplace_back(work);
    work();
}

}  // namespace

Image warpImage(const Pyramid& source, const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view,
                const WarpOptions& options) {
    requireFinite(pose);
    const bool addsAlpha =
        !source.base().alpha && source.base().channels < 4 && options.outside == Outside::Transparent;
    const int bands = (view.height + kBandRows - 1) / kBandRows;
    Job job{source,     rest.points, pose,
            rest.cells, view,        options,
            {},         {},          emptyOutput(source.base(), view, addsAlpha),
            addsAlpha};
    if (bands == 0 || view.width <= 0) return std::move(job.output);
    job.cellsOfBand = sortIntoBands(job, bands);
    if (options.antialias) {
        const Points<2> pixels = (pose.colwise() - view.origin) / view.scale;
        job.outline = OutlinePixels(rest, pixels, view.width, view.height, kBandRows);
    } else {
        job.outline = OutlinePixels(bands, kBandRows);
    }
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
