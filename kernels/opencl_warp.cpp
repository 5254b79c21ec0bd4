#include "kernels/opencl_warp.h"

#include "kernels/opencl_context.h"
#include "warp/pixel_cells.h"
#include "warp/warp_job.h"

namespace wend {
namespace {

bool isPaintedByDevices(const Image& image) {
    return image.type == PixelType::UInt8 || image.type == PixelType::UInt16;
}

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

}  // namespace

/// The data that stays on the device from one frame to the next.
struct OpenClPicture::Device {
    explicit Device(const OpenClPlace& place) : cl(place) {}

    /// Levels that are there already are not copied again.
    void hold(const Pyramid& source) {
        if (base == &source.base() && bytes == source.base().data.data() && count >= source.levels()) return;
        base = nullptr;  // until all of it is there
        std::vector<cl_long> places;
        std::size_t size = 0;
        const std::size_t number =
            source.base().pixelBytes() / static_cast<std::size_t>(source.base().channels);
        for (int k = 0; k < source.levels(); ++k) {
            const Image& level = source.level(k);
            places.insert(places.end(), {static_cast<cl_long>(size / number), level.width, level.height});
            size += level.data.size();
        }
        levels = cl.copyOf(places.data(), places.size());
        texels = cl.buffer<std::byte>(size);
        std::size_t first = 0;
        for (int k = 0; k < source.levels(); ++k) {
            const std::vector<std::byte>& data = source.level(k).data;
            cl.write(texels, data.data(), data.size(), first);
            first += data.size();
        }
        base = &source.base();
        bytes = source.base().data.data();
        count = source.levels();
    }

    cl::Kernel& kernelFor(const std::string& options) {
        if (options != kernelOptions) kernel = cl::Kernel(cl.build({"warp.cl"}, options), "warp");
        kernelOptions = options;
        return kernel;
    }

    OpenClContext cl;
    cl::Kernel kernel;
    std::string kernelOptions;
    cl::Buffer texels, levels;
    const Image* base = nullptr;
    const std::byte* bytes = nullptr;
    int count = 0;
};

class OpenClPainter final : public CellPainter {
  public:
    OpenClPainter(std::shared_ptr<OpenClPicture> picture, const WarpJob& job)
        : m_picture(std::move(picture)),
          m_device(*m_picture->m_device),
          m_cl(m_device.cl),
          m_options(optionsOf(job)) {
        m_device.hold(*job.source);
        m_device.kernelFor(m_options);
        uploadCells(job.cells);
    }

    bool paint(const WarpJob& job, int top, Image& strip) override {
        try {
            guarded([&] { paintStrip(job, top, strip); });
            return true;
        } catch (const DeviceFailure& failure) {
            m_picture->fail(failure);
            return false;
        }
    }

  private:
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

    /// Finds the cells of every pixel of the strip, as the kernel reads them.
    void findCells(const WarpJob& job, int top, int rows) {
        PixelCells cells(job.view.width, top, rows);
        for (int band = top / kBandRows; band * kBandRows < top + rows; ++band)
            for (int place : job.cellsOfBand[static_cast<std::size_t>(band)])
                forRuns(job.cells[static_cast<std::size_t>(place)].rows, band * kBandRows,
                        std::min(top + rows, (band + 1) * kBandRows), job.view.width,
                        [&](int y, int from, int to) { cells.cover(y, from, to, place); });
        m_cellAt = cells.onTop();
        m_layers.clear();
        if (job.source->opaque()) return;
        cells.forOverlaps([&](int pixel, std::span<const int> found) {
            m_cellAt[static_cast<std::size_t>(pixel)] = -2 - static_cast<int>(m_layers.size());
            m_layers.push_back(static_cast<int>(found.size()));
            m_layers.insert(m_layers.end(), found.begin(), found.end());
        });
    }

    void paintStrip(const WarpJob& job, int top, Image& strip) {
        findCells(job, top, strip.height);
        if (m_capacity < m_cellAt.size()) {
            m_capacity = m_cellAt.size();
            m_cellsOnDevice = m_cl.buffer<int>(m_capacity);
            m_output = m_cl.buffer<std::byte>(strip.data.size());
        }
        if (m_layerCapacity < m_layers.size() || m_layerCapacity == 0) {
            m_layerCapacity = std::max<std::size_t>(1, m_layers.size());
            m_layersOnDevice = m_cl.buffer<int>(m_layerCapacity);
        }
        m_device.hold(*job.source);  // another painter's picture may be there
        m_cl.write(m_cellsOnDevice, m_cellAt.data(), m_cellAt.size());
        if (!m_layers.empty()) m_cl.write(m_layersOnDevice, m_layers.data(), m_layers.size());
        launch(m_cl.queue(), m_device.kernelFor(m_options), static_cast<int>(m_cellAt.size()),
               m_cellsOnDevice, m_layersOnDevice, m_maps, m_ellipses, m_filters, m_device.texels,
               m_device.levels, job.view.width, top, job.view.origin.x(), job.view.origin.y(), job.view.scale,
               m_output);
        m_cl.read(m_output, strip.data.data(), strip.data.size());
    }

    std::shared_ptr<OpenClPicture> m_picture;
    OpenClPicture::Device& m_device;
    OpenClContext& m_cl;
    std::string m_options;
    cl::Buffer m_maps, m_ellipses, m_filters, m_cellsOnDevice, m_layersOnDevice, m_output;
    std::vector<int> m_cellAt, m_layers;
    std::size_t m_capacity = 0, m_layerCapacity = 0;
};

OpenClPicture::OpenClPicture(OpenClPlace place, DeviceNotice notice)
    : m_place(std::move(place)), m_notice(std::move(notice)) {}
OpenClPicture::~OpenClPicture() = default;

void OpenClPicture::fail(const DeviceFailure& failure) {
    if (!m_failed && m_notice) m_notice(failureText(m_place.info().name, failure));
    m_failed = true;
}

CopiedBytes OpenClPicture::copied() const {
    return m_device ? m_device->cl.copied() : CopiedBytes{};
}

std::unique_ptr<CellPainter> OpenClPicture::painter(const std::shared_ptr<OpenClPicture>& picture,
                                                    const WarpJob& job) {
    if (picture->m_failed || !isPaintedByDevices(job.source->base())) return nullptr;
    try {
        return guarded([&] {
            if (!picture->m_device) picture->m_device = std::make_unique<Device>(picture->m_place);
            return std::make_unique<OpenClPainter>(picture, job);
        });
    } catch (const DeviceFailure& failure) {
        picture->fail(failure);
        return nullptr;
    }
}

}  // namespace wend
