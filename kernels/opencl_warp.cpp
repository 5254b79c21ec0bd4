#include "kernels/opencl_warp.h"

#include "kernels/opencl_context.h"
#include "warp/warp_job.h"

namespace wend {
namespace {

std::string optionsOf(const WarpJob& job) {
    const Image& image = job.source->base();
    std::string options = "-cl-std=CL1.2 -DKIND=" + std::to_string(static_cast<int>(image.type)) +
                          " -DN=" + std::to_string(image.channels) +
                          " -DADDS=" + std::to_string(job.addsAlpha ? 1 : 0) +
                          " -DFILTER=" + std::to_string(static_cast<int>(job.options.filter));
    if (image.alpha) options += " -DALPHA";
    if (image.unassociated && !job.source->opaque()) options += " -DWEIGHTED";
    return options;
}

class OpenClPainter final : public CellPainter {
  public:
    OpenClPainter(const OpenClDeviceInfo& device, const WarpJob& job, DeviceNotice notice)
        : m_cl(device), m_notice(std::move(notice)), m_kernel(m_cl.build("warp.cl", optionsOf(job)), "warp") {
        uploadLevels(*job.source);
        uploadCells(job.cells);
    }

    bool paint(const WarpJob& job, int top, Image& strip) override {
        try {
            guarded([&] { paintStrip(job, top, strip); });
            return true;
        } catch (const DeviceFailure& failure) {
            if (m_notice) m_notice(failureText(m_cl.info().name, failure));
            return false;
        }
    }

  private:
    void uploadLevels(const Pyramid& source) {
        std::vector<cl_long> levels;
        std::size_t bytes = 0;
        const std::size_t number =
            source.base().pixelBytes() / static_cast<std::size_t>(source.base().channels);
        for (int k = 0; k < source.levels(); ++k) {
            const Image& level = source.level(k);
            levels.insert(levels.end(), {static_cast<cl_long>(bytes / number), level.width, level.height});
            bytes += level.data.size();
        }
        m_levels = m_cl.copyOf(levels.data(), levels.size());
        m_texels = m_cl.buffer<std::byte>(bytes);
        std::size_t first = 0;
        for (int k = 0; k < source.levels(); ++k) {
            const std::vector<std::byte>& data = source.level(k).data;
            m_cl.write(m_texels, data.data(), data.size(), first);
            first += data.size();
        }
    }

    void uploadCells(const std::vector<VisibleCell>& cells) {
        std::vector<double> maps;
        std::vector<float> ellipses;
        std::vector<int> filters;
        for (const VisibleCell& cell : cells) {
            const CellMap& map = cell.map;
            const Ellipse& ellipse = cell.filter.ellipse;
            maps.insert(maps.end(), {map.anchor.x(), map.anchor.y(), map.displacement.x(),
                                     map.displacement.y(), map.gradient(0, 0), map.gradient(1, 0),
                                     map.gradient(0, 1), map.gradient(1, 1), cell.filter.shrink});
            ellipses.insert(ellipses.end(), {ellipse.xx, ellipse.xy, ellipse.yy, cell.filter.blend});
            filters.insert(filters.end(),
                           {cell.filter.level, ellipse.wholeReach.x(), ellipse.wholeReach.y(), 0});
        }
        m_maps = m_cl.copyOf(maps.data(), maps.size());
        m_ellipses = m_cl.copyOf(ellipses.data(), ellipses.size());
        m_filters = m_cl.copyOf(filters.data(), filters.size());
    }

    /// The cell on top of every pixel of the strip, −1 where there is none.
    void findCells(const WarpJob& job, int top, int rows) {
        const auto width = static_cast<std::ptrdiff_t>(job.view.width);
        m_cellAt.assign(static_cast<std::size_t>(width * rows), -1);
        for (int band = top / kBandRows; band * kBandRows < top + rows; ++band)
            for (int place : job.cellsOfBand[static_cast<std::size_t>(band)]) {
                const TriangleRows& cell = job.cells[static_cast<std::size_t>(place)].rows;
                const int begin = band * kBandRows, end = std::min(top + rows, begin + kBandRows);
                for (int y = std::max(begin, firstPixel(cell.top(), end)); y < end && y + 0.5 < cell.bottom();
                     ++y) {
                    const Span span = cell.at(y + 0.5);
                    const int from = firstPixel(span.begin, job.view.width),
                              to = firstPixel(span.end, job.view.width);
                    if (from < to) std::fill_n(m_cellAt.data() + (y - top) * width + from, to - from, place);
                }
            }
    }

    void paintStrip(const WarpJob& job, int top, Image& strip) {
        findCells(job, top, strip.height);
        if (m_capacity < m_cellAt.size()) {
            m_capacity = m_cellAt.size();
            m_cellsOnDevice = m_cl.buffer<int>(m_capacity);
            m_output = m_cl.buffer<std::byte>(strip.data.size());
        }
        m_cl.write(m_cellsOnDevice, m_cellAt.data(), m_cellAt.size());
        launch(m_cl.queue(), m_kernel, static_cast<int>(m_cellAt.size()), m_cellsOnDevice, m_maps, m_ellipses,
               m_filters, m_texels, m_levels, job.view.width, top, job.view.origin.x(), job.view.origin.y(),
               job.view.scale, m_output);
        m_cl.read(m_output, strip.data.data(), strip.data.size());
    }

    OpenClContext m_cl;
    DeviceNotice m_notice;
    cl::Kernel m_kernel;
    cl::Buffer m_texels, m_levels, m_maps, m_ellipses, m_filters, m_cellsOnDevice, m_output;
    std::vector<int> m_cellAt;
    std::size_t m_capacity = 0;
};

}  // namespace

std::unique_ptr<CellPainter> makeOpenClPainter(const OpenClDeviceInfo& device, const WarpJob& job,
                                               const DeviceNotice& notice) {
    try {
        return guarded([&] { return std::make_unique<OpenClPainter>(device, job, notice); });
    } catch (const DeviceFailure& failure) {
        if (notice) notice(failureText(device.name, failure));
        return nullptr;
    }
}

}  // namespace wend
