#pragma once

#include <array>
#include <bit>

#include "warp/warp_job.h"

namespace wend {

/// Paints the rows of one band of a picture of N channels of type T with the filter F: the cells, then the
/// outline's pixels, then what no cell covers.
template <typename T, int N, Filter F>
class BandPainter {
  public:
    BandPainter(WarpJob& job, int band)
        : m_job(job),
          m_band(band),
          m_begin(band * kBandRows),
          m_end(std::min(job.view.height, m_begin + kBandRows)),
          m_channels(job.output.channels),
          m_outsideFilter(job.view.scale * Mat<2>::Identity(), F, job.source.levels()) {
        for (int k = 0; k < job.source.levels(); ++k)
            m_samplers.emplace_back(job.source.level(k), job.source.opaque());
        if (job.options.outside != Outside::Transparent)
            m_covered.resize(static_cast<std::size_t>(m_end - m_begin) *
                             static_cast<std::size_t>(job.view.width));
    }

    void paint() {
        for (int cell : m_job.cellsOfBand[static_cast<std::size_t>(m_band)])
            paintCell(m_job.cells[static_cast<std::size_t>(cell)]);
        fillOutside();
        resolveOutline();
    }

  private:
    /// A colour of the output: the picture's own channels, then alpha if one is added.
    using OutColour = std::array<float, 5>;

    T* target(int x, int y) {
        return reinterpret_cast<T*>(m_job.output.row(y)) + static_cast<std::ptrdiff_t>(x) * m_channels;
    }

    // --- cells
    // ---------------------------------------------------------------------------------------------------

    const Sampler<T, N>& samplerOf(const CellFilter& filter) const {
        return m_samplers[static_cast<std::size_t>(filter.level)];
    }

    template <bool inner>
    static Lanes sample(const Sampler<T, N>& sampler, const CellFilter& filter, const RadialKernel& kernel,
                        const Vec<2>& at) {
        double x = at.x() * filter.shrink, y = at.y() * filter.shrink;
        if constexpr (!inner) sampler.bound(x, y);
        if constexpr (F == Filter::Nearest) return sampler.template nearest<inner>(x, y);
        if constexpr (F == Filter::Bilinear) return sampler.template bilinear<inner>(x, y);
        if (F == Filter::Bicubic || filter.blend == 0) return sampler.template bicubic<inner>(x, y);
        const Lanes colour = sampler.template elliptical<inner>(x, y, filter.ellipse, kernel);
        if (filter.blend == 1) return colour;
        return sampler.mixed(colour, sampler.template bicubic<inner>(x, y), filter.blend);
    }

    Lanes sample(const CellFilter& filter, const Vec<2>& at) const {
        return sample<false>(samplerOf(filter), filter, m_kernel, at);
    }

    static Vec<2> reach(const CellFilter& filter) {
        return F == Filter::Ewa ? filter.ellipse.reach.cwiseMax(2.0) : Vec<2>(2, 2);
    }

    /// Works on copies: a pixel that is written might be any of the members for all the compiler knows.
    template <bool inner, bool addsAlpha>
    void paintSpan(const VisibleCell& cell, int begin, int end, int y) {
        const Sampler<T, N> sampler = samplerOf(cell.filter);
        const CellFilter filter = cell.filter;
        const CellMap map = cell.map;
        const double height = m_job.plane(0, y + 0.5).y(), left = m_job.view.origin.x(),
                     scale = m_job.view.scale;
        const Vec<2> inRow = map.inRow(height);
        constexpr int channels = addsAlpha ? N + 1 : N;
        T* to = target(begin, y);
        for (int x = begin; x < end; ++x, to += channels) {
            const double across = left + scale * (x + 0.5);
            Lanes colour = sample<inner>(sampler, filter, m_kernel, map.source(across, height, inRow));
            if constexpr (addsAlpha) colour[N] = kFull<T>;
            storeColour<channels>(colour, to);
        }
    }

    template <bool inner>
    void paintSpan(const VisibleCell& cell, int begin, int end, int y) {
        if constexpr (N < 4) {
            if (m_job.addsAlpha) return paintSpan<inner, true>(cell, begin, end, y);
        }
        paintSpan<inner, false>(cell, begin, end, y);
    }

    void paintCell(const VisibleCell& cell) {
        const Sampler<T, N>& sampler = samplerOf(cell.filter);
        for (int y = std::max(m_begin, firstPixel(cell.rows.top(), m_end));
             y < m_end && y + 0.5 < cell.rows.bottom(); ++y) {
            const Span span = cell.rows.at(y + 0.5);
            const int begin = firstPixel(span.begin, m_job.view.width),
                      end = firstPixel(span.end, m_job.view.width);
            if (begin >= end) continue;
            const Vec<2> a = cell.map.source(m_job.plane(begin + 0.5, y + 0.5)) * cell.filter.shrink;
            const Vec<2> b = cell.map.source(m_job.plane(end - 0.5, y + 0.5)) * cell.filter.shrink;
            if (sampler.inner(a.cwiseMin(b), a.cwiseMax(b), reach(cell.filter)))
                paintSpan<true>(cell, begin, end, y);
            else
                paintSpan<false>(cell, begin, end, y);
            if (!m_covered.empty()) std::fill_n(covered(begin, y), end - begin, std::uint8_t(1));
        }
    }

    // --- outside the shape
    // ---------------------------------------------------------------------------------------

    std::uint8_t* covered(int x, int y) {
        return m_covered.data() + static_cast<std::ptrdiff_t>(y - m_begin) * m_job.view.width + x;
    }

    bool inPicture(const Vec<2>& p) const {
        const Image& image = m_job.source.base();
        return p.x() >= 0 && p.y() >= 0 && p.x() < image.width && p.y() < image.height;
    }

    OutColour givenColour() const {
        OutColour colour{};
        const auto& given = m_job.options.colour;
        const bool alpha = m_job.output.alpha;
        const int colours = m_channels - (alpha ? 1 : 0);
        const float divide = m_job.output.unassociated && given[3] > 0 ? given[3] : 1;
        for (int c = 0; c < colours; ++c)
            colour[static_cast<std::size_t>(c)] =
                given[static_cast<std::size_t>(std::min(c, 2))] / divide * kFull<T>;
        if (alpha) colour[static_cast<std::size_t>(colours)] = given[3] * kFull<T>;
        return colour;
    }

    OutColour asOutput(const Lanes& sampled) const {
        OutColour colour{};
        std::copy_n(sampled.data(), N, colour.begin());
        if (m_job.addsAlpha) colour[N] = kFull<T>;
        return colour;
    }

    OutColour outsideColour(int x, int y) const {
        const Vec<2> p = m_job.plane(x + 0.5, y + 0.5);
        const Outside kind = m_job.options.outside;
        if (kind == Outside::Colour) return givenColour();
        if (kind == Outside::Clamp || (kind == Outside::Original && inPicture(p)))
            return asOutput(sample(m_outsideFilter, p));
        return {};
    }

    void putOut(const OutColour& colour, T* to) const {
        for (int c = 0; c < m_channels; ++c) to[c] = toPixel<T>(colour[static_cast<std::size_t>(c)]);
    }

    /// The output came with zeros: transparent.
    void fillOutside() {
        if (m_covered.empty()) return;
        for (int y = m_begin; y < m_end; ++y)
            for (int x = 0; x < m_job.view.width; ++x)
                if (*covered(x, y) == 0) putOut(outsideColour(x, y), target(x, y));
    }

    // --- the outline
    // ---------------------------------------------------------------------------------------------

    struct Piece {
        int pixel, cell;
        std::uint64_t samples;
    };

    /// What the cells cover of the outline's pixels, cell by cell in painting order.
    std::vector<Piece> pieces() const {
        std::vector<Piece> list;
        for (int cell : m_job.cellsOfBand[static_cast<std::size_t>(m_band)])
            m_job.outline.visit(m_band, m_job.cells[static_cast<std::size_t>(cell)].rows,
                                [&](int pixel, std::uint64_t samples) {
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

    /// A weighted sum of colours in associated form; exact where it has one colour only.
    class Mix {
      public:
        Mix(int channels, bool unassociated) : m_channels(channels), m_unassociated(unassociated) {}

        void add(const OutColour& colour, int samples) {
            if (samples == 0) return;
            m_same = m_same && (!m_any || colour == m_first);
            if (!m_any) m_first = colour;
            m_any = true;
            const double weight = samples / 64.0;
            const double alpha = m_unassociated ? static_cast<double>(colour[last()]) / kFull<T> : 1;
            for (std::size_t c = 0; c <= last(); ++c)
                m_sum[c] += weight * static_cast<double>(colour[c]) * (isAlpha(c) ? 1 : alpha);
        }

        OutColour colour() const {
            if (m_same) return m_first;
            OutColour colour{};
            const double alpha = m_unassociated ? m_sum[last()] / static_cast<double>(kFull<T>) : 1;
            for (std::size_t c = 0; c <= last(); ++c)
                colour[c] = static_cast<float>(isAlpha(c) || !(alpha > 0) ? m_sum[c] : m_sum[c] / alpha);
            return colour;
        }

      private:
        std::size_t last() const { return static_cast<std::size_t>(m_channels - 1); }
        bool isAlpha(std::size_t c) const { return m_unassociated && c == last(); }

        int m_channels;
        bool m_unassociated, m_same = true, m_any = false;
        std::array<double, 5> m_sum{};
        OutColour m_first{};
    };

    /// Mixes what shows of each cell, from the top one down, and what is left of the outside.
    void resolve(int x, int y, const Piece* begin, const Piece* end) {
        Mix mix(m_channels, m_job.output.unassociated);
        std::uint64_t left = ~std::uint64_t{0};
        for (const Piece* piece = end; piece-- != begin && left != 0;) {
            const std::uint64_t shown = piece->samples & left;
            if (shown == 0) continue;
            const VisibleCell& cell = m_job.cells[static_cast<std::size_t>(piece->cell)];
            const Vec<2> at = cell.map.source(m_job.plane(x + 0.5, y + 0.5));
            mix.add(asOutput(sample(cell.filter, at)), std::popcount(shown));
            left &= ~shown;
        }
        if (left != 0) mix.add(outsideColour(x, y), std::popcount(left));
        putOut(mix.colour(), target(x, y));
    }

    WarpJob& m_job;
    int m_band, m_begin, m_end, m_channels;
    CellFilter m_outsideFilter;
    RadialKernel m_kernel;
    std::vector<Sampler<T, N>> m_samplers;
    std::vector<std::uint8_t> m_covered;  // pixels of the band, if the outside is not transparent
};

template <typename T, int N>
void paintBandOf(WarpJob& job, int band) {
    switch (job.options.filter) {
        case Filter::Nearest:
            return BandPainter<T, N, Filter::Nearest>(job, band).paint();
        case Filter::Bilinear:
            return BandPainter<T, N, Filter::Bilinear>(job, band).paint();
        case Filter::Bicubic:
            return BandPainter<T, N, Filter::Bicubic>(job, band).paint();
        case Filter::Ewa:
            return BandPainter<T, N, Filter::Ewa>(job, band).paint();
    }
}

template <typename T>
void paintBand(WarpJob& job, int band) {
    switch (job.source.base().channels) {
        case 1:
            return paintBandOf<T, 1>(job, band);
        case 2:
            return paintBandOf<T, 2>(job, band);
        case 3:
            return paintBandOf<T, 3>(job, band);
        default:
            return paintBandOf<T, 4>(job, band);
    }
}

}  // namespace wend
