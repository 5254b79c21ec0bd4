#include "warp/warped_picture.h"

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <numeric>
#include <thread>

#include "core/base/error.h"
#include "warp/at_rest.h"
#include "warp/convert.h"
#include "warp/image_formats.h"
#include "warp/warp_job.h"

namespace wend {
namespace {

/// Does the same work in that many threads, including this one. An exception must not leave a helper: the
/// first one is kept for the caller, and the others notice it by `failed`.
template <typename Work>
void inThreads(int threads, const Work& work) {
    std::mutex mutex;
    std::exception_ptr first;
    std::atomic<bool> failed = false;
    const auto catching = [&] {
        try {
            work(failed);
        } catch (...) {
            const std::scoped_lock lock(mutex);
            if (!first) first = std::current_exception();
            failed = true;
        }
    };
    std::vector<std::jthread> helpers;
    for (int k = 1; k < threads; ++k) helpers.emplace_back(catching);
    catching();
    helpers.clear();
    if (first) std::rethrow_exception(first);
}

/// Returns as many threads as are wanted, but no more than there are pieces.
int threadsFor(const WarpOptions& options, std::size_t pieces) {
    static const int cores = static_cast<int>(std::thread::hardware_concurrency());  // asks a file each time
    const int wanted = options.threads > 0 ? options.threads : cores;
    return std::clamp(wanted, 1, static_cast<int>(std::max<std::size_t>(1, pieces)));
}

void requireFinite(const Points2& pose) {
    if (!pose.allFinite()) throw InputError("the shape has a vertex that is not a finite number");
}

/// Returns whether a grey picture is composed over a colour that it cannot hold.
bool needsColours(const Image& source, const WarpOptions& options) {
    const auto& colour = options.colour;
    const bool isGrey = colour[0] == colour[1] && colour[1] == colour[2];
    return options.outside == Outside::Colour && source.colours() < 3 && !isGrey;
}

/// Returns the picture itself, which the caller keeps, or a copy with equal colours if a grey picture needs
/// some.
std::shared_ptr<const Image> colouredAsNeeded(const Image& source, const WarpOptions& options) {
    if (!needsColours(source, options)) return {std::shared_ptr<const Image>(), &source};
    PixelLayout layout = layoutOf(source);
    layout.channels = source.alpha ? 4 : 3;
    return std::make_shared<const Image>(converted(source, layout));
}

Image warpedHeader(const Image& source, const View& view, const WarpOptions& options, bool addsAlpha) {
    const bool hasFrame = options.frameWidth > 0;
    return {view.width,
            view.height,
            source.channels + (addsAlpha ? 1 : 0),
            source.type,
            source.alpha || addsAlpha,
            source.unassociated || addsAlpha,
            {},
            source.metadata,
            placeOf(view, hasFrame ? options.frameWidth : source.width,
                    hasFrame ? options.frameHeight : source.height)};
}

bool visible(const Points2& pixels, const Cell<2>& cell, const View& view) {
    const auto corners = [&](int row) {
        return std::minmax({pixels(row, cell[0]), pixels(row, cell[1]), pixels(row, cell[2])});
    };
    const auto [left, right] = corners(0);
    const auto [top, bottom] = corners(1);
    return left < view.width && right > 0 && top < bottom && top < view.height && bottom > 0;
}

VisibleCell visibleCell(const WarpJob& job, const SimplicialMesh<2>& rest, const Points2& pose,
                        const Points2& pixels, const Cell<2>& cell, int levels) {
    const TriangleRows rows(pixels.col(cell[0]), pixels.col(cell[1]), pixels.col(cell[2]));
    const CellMap map(rest.points, pose, cell);
    const Mat2 jacobian = job.view.scale * (Mat2::Identity() - map.gradient);
    const auto corner = [&](int k) { return rest.points.col(cell[static_cast<std::size_t>(k)]); };
    return {rows, map, CellFilter(jacobian, job.options.filter, levels),
            corner(0).cwiseMin(corner(1)).cwiseMin(corner(2)),
            corner(0).cwiseMax(corner(1)).cwiseMax(corner(2))};
}

/// Notes how the part that a cell belongs to is blended.
void takeBlend(const std::vector<MeshPart>& parts, const std::vector<BlendMode>& blends, int cell,
               VisibleCell& visible) {
    const auto own = std::ranges::find_if(
        parts, [&](const MeshPart& part) { return part.firstCell <= cell && cell < part.endCell; });
    visible.part = static_cast<int>(own - parts.begin());
    if (own != parts.end()) visible.blend = blends[static_cast<std::size_t>(visible.part)];
}

constexpr std::size_t kCellsOfPiece = 1500;  // in less time no thread has begun

/// Returns the visible cells in the order of painting.
std::vector<VisibleCell> visibleCells(const WarpJob& job, const PaintingPlan& plan,
                                      const SimplicialMesh<2>& rest, const Points2& pose,
                                      const Points2& pixels, int levels) {
    const std::size_t pieces = (plan.order.size() + kCellsOfPiece - 1) / kCellsOfPiece;
    std::vector<std::vector<VisibleCell>> found(pieces);
    std::atomic<std::size_t> next = 0;
    inThreads(threadsFor(job.options, pieces), [&](const std::atomic<bool>& failed) {
        for (std::size_t piece; (piece = next++) < pieces && !failed;) {
            const std::size_t end = std::min(plan.order.size(), (piece + 1) * kCellsOfPiece);
            found[piece].reserve(kCellsOfPiece);
            for (std::size_t k = piece * kCellsOfPiece; k < end; ++k) {
                const Cell<2>& cell = rest.cells[static_cast<std::size_t>(plan.order[k])];
                if (!visible(pixels, cell, job.view)) continue;
                found[piece].push_back(visibleCell(job, rest, pose, pixels, cell, levels));
                if (!job.options.blends.empty())
                    takeBlend(rest.parts, job.options.blends, plan.order[k], found[piece].back());
            }
        }
    });
    std::vector<VisibleCell> cells;
    cells.reserve(std::transform_reduce(found.begin(), found.end(), std::size_t(0), std::plus(),
                                        [](const auto& piece) { return piece.size(); }));
    for (const auto& piece : found) cells.insert(cells.end(), piece.begin(), piece.end());
    return cells;
}

void sortIntoBands(WarpJob& job) {
    for (std::size_t place = 0; place < job.cells.size(); ++place) {
        const TriangleRows& rows = job.cells[place].rows;
        const double high = std::min<double>(job.view.height, rows.bottom());
        for (int band = static_cast<int>(std::max(0.0, rows.top())) / kBandRows; band * kBandRows < high;
             ++band)
            job.cellsOfBand[static_cast<std::size_t>(band)].push_back(static_cast<int>(place));
    }
}

/// Makes the job without its source; `levels` are those that the source's pyramid has or might have.
std::unique_ptr<WarpJob> makeJob(const Image& source, int levels, const SimplicialMesh<2>& rest,
                                 const Points2& pose, const View& view, const WarpOptions& options) {
    requireFinite(pose);
    auto job = std::make_unique<WarpJob>();
    job->view = view;
    job->options = options;
    job->header = warpedHeader(source, view, options, false);
    job->atRest = options.restMargin > 0 && source.alpha && options.outside == Outside::Transparent &&
                  isAtRest(source, rest, pose, view);
    job->outsideFilter = CellFilter(view.scale * Mat2::Identity(), options.filter, levels);
    const int bands = view.width > 0 ? (std::max(view.height, 0) + kBandRows - 1) / kBandRows : 0;
    job->cellsOfBand.resize(static_cast<std::size_t>(bands));
    const Points2 pixels = (pose.colwise() - view.origin) / view.scale;
    const auto plan = options.plan ? options.plan : std::make_shared<PaintingPlan>(rest, options.depth);
    job->cells = visibleCells(*job, *plan, rest, pose, pixels, levels);
    sortIntoBands(*job);
    job->outline = options.antialias && bands > 0
                       ? OutlinePixels(*plan, pixels, view.width, view.height, kBandRows)
                       : OutlinePixels(bands, kBandRows);
    return job;
}

/// Returns whether the cells cover all of every pixel of a band.
bool covered(const WarpJob& job, int band) {
    const int begin = band * kBandRows, end = std::min(job.view.height, begin + kBandRows);
    const auto width = static_cast<std::ptrdiff_t>(job.view.width);
    std::vector<std::uint8_t> centres(static_cast<std::size_t>(width * (end - begin)));
    const auto& outline = job.outline.pixels(band);
    std::vector<std::uint64_t> samples(outline.size());
    for (int place : job.cellsOfBand[static_cast<std::size_t>(band)]) {
        const TriangleRows& rows = job.cells[static_cast<std::size_t>(place)].rows;
        job.outline.visit(band, rows, [&](int pixel, std::uint64_t found) {
            samples[static_cast<std::size_t>(pixel)] |= found;
        });
        forRuns(rows, begin, end, job.view.width, [&](int y, int from, int to) {
            std::fill_n(centres.data() + (y - begin) * width + from, to - from, std::uint8_t(1));
        });
    }
    for (const auto& pixel : outline)
        centres[static_cast<std::size_t>((pixel.y - begin) * width + pixel.x)] =
            samples[static_cast<std::size_t>(pixel.index)] == ~std::uint64_t{0} ? 1 : 0;
    return std::find(centres.begin(), centres.end(), 0) == centres.end();
}

bool coversView(const WarpJob& job) {
    for (int band = 0; band < job.bands(); ++band)
        if (!covered(job, band)) return false;
    return true;
}

void setSource(WarpJob& job, const Pyramid& source) {
    const Image& image = source.base();
    const bool needsAlpha = !image.alpha && image.channels < 4 && job.options.outside == Outside::Transparent;
    job.source = &source;
    job.addsAlpha = needsAlpha && !coversView(job);
    job.header = warpedHeader(image, job.view, job.options, job.addsAlpha);
}

int deepestLevel(const WarpJob& job) {
    int deepest = job.outsideFilter.level;
    for (const VisibleCell& cell : job.cells) deepest = std::max(deepest, cell.filter.level);
    return deepest;
}

}  // namespace

CanvasPlace placeOf(const View& view, int sourceWidth, int sourceHeight) {
    const Vec2 whole = view.origin.array().round();
    const bool isOwn = whole == Vec2::Zero() && view.width == sourceWidth && view.height == sourceHeight;
    if (isOwn || view.scale != 1 || whole != view.origin || whole.cwiseAbs().maxCoeff() > 1e6) return {};
    return {static_cast<int>(whole.x()), static_cast<int>(whole.y()), sourceWidth, sourceHeight};
}

WarpedPicture::WarpedPicture(const Image& source, const SimplicialMesh<2>& rest, const Points2& pose,
                             const View& view, const WarpOptions& options)
    : m_job(makeJob(source, Pyramid::levelsOf(source.width, source.height), rest, pose, view, options)) {
    m_pyramid.emplace(colouredAsNeeded(source, options), deepestLevel(*m_job));
    setSource(*m_job, *m_pyramid);
    if (options.makePainter && options.blends.empty()) m_painter = options.makePainter(*m_job);
}

WarpedPicture::WarpedPicture(const Pyramid& source, const SimplicialMesh<2>& rest, const Points2& pose,
                             const View& view, const WarpOptions& options)
    : m_job(makeJob(source.base(), source.levels(), rest, pose, view, options)) {
    if (needsColours(source.base(), options))
        m_pyramid.emplace(colouredAsNeeded(source.base(), options), deepestLevel(*m_job));
    setSource(*m_job, m_pyramid ? *m_pyramid : source);
    if (options.makePainter && options.blends.empty()) m_painter = options.makePainter(*m_job);
}

WarpedPicture::~WarpedPicture() = default;

const Image& WarpedPicture::header() const {
    return m_job->header;
}

bool WarpedPicture::paintCells(int top, Image& strip) const {
    if (!m_painter || strip.data.empty()) return false;
    if (m_painter->paint(*m_job, top, strip)) return true;
    m_painter.reset();
    std::fill(strip.data.begin(), strip.data.end(), std::byte(0));
    return false;
}

bool WarpedPicture::paint(int top, Image& strip) const {
    const WarpJob& job = *m_job;
    const BandPart part = paintCells(top, strip) ? BandPart::BesideCells : BandPart::All;
    const int begin = top / kBandRows, end = (top + strip.height + kBandRows - 1) / kBandRows;
    std::atomic<int> next = begin, done = begin;
    inThreads(threadsFor(job.options, static_cast<std::size_t>(end - begin)), [&](const auto& failed) {
        for (int band; (band = next++) < end && !job.options.stop.stop_requested() && !failed;) {
            withPixelType(job.header.type,
                          [&](auto t) { paintBand<decltype(t)>(job, band, part, strip, top); });
            const int row = band * kBandRows - top;
            if (job.options.finishRows)
                job.options.finishRows(strip.row(row), std::min(kBandRows, strip.height - row));
            if (job.options.progress) job.options.progress(static_cast<double>(++done) / job.bands());
        }
    });
    if (job.atRest) copyAtRest(job, job.options.restMargin, top, strip);
    return !job.options.stop.stop_requested();
}

void writeWarped(const std::string& path, const WarpedPicture& picture, std::optional<PixelType> type,
                 bool lossy) {
    Image header = picture.header();
    header.type = type.value_or(header.type);
    const bool own = header.type == picture.header().type;
    const MakeRows makeRows = [&](int top, Image& strip) {
        if (own) {
            if (!picture.paint(top, strip)) throw Cancelled();
            return;
        }
        Image painted = strip;
        painted.type = picture.header().type;
        painted.makePixels();
        if (!picture.paint(top, painted)) throw Cancelled();
        strip = converted(painted, layoutOf(strip));
    };
    writeImage(path, header, WarpedPicture::kRows, makeRows, lossy);
}

}  // namespace wend
