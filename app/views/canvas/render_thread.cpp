#include "app/views/canvas/render_thread.h"

#include <QPainter>
#include <chrono>
#include <cmath>

#include "app/engine/motion/fields.h"
#include "app/style/smooth_map.h"
#include "app/views/canvas/cell_filler.h"
#include "warp/coverage.h"
#include "warp/warp.h"

namespace wend {

namespace {

constexpr double kDrawnOff = 0.5;  // drawn pixels that a shape which moves may be drawn off

std::shared_ptr<const SimplicialMesh<2>> restOf(const RenderRequest& request) {
    const auto& rest = request.texture ? request.texture->rest : request.frame->rest;
    if (!request.cells) return rest;
    return std::make_shared<const SimplicialMesh<2>>(SimplicialMesh<2>{rest->points, request.cells->cells});
}

/// Returns the pose in pixels of the picture or of the screen.
Points2 poseOf(const RenderRequest& request) {
    if (!request.texture) return request.frame->pose;
    Points2 pose = request.texture->withRiders(request.frame->pose);
    for (Eigen::Index i = 0; i < pose.cols(); ++i) {
        const QPointF p = request.scale() * request.view.toWidget(pose.col(i));
        pose.col(i) = Vec2(p.x(), p.y());
    }
    return pose;
}

/// Returns the picture on the screen, made by the same code as an export.
QImage warped(const RenderRequest& request, std::stop_token stop) {
    View view;
    view.width = static_cast<int>(std::lround(request.size.width() * request.scale()));
    view.height = static_cast<int>(std::lround(request.size.height() * request.scale()));
    view.origin = request.view.toShape({0, 0});
    view.scale = 1 / (request.view.zoom() * request.scale());
    WarpOptions options;
    options.filter = request.filter;
    options.isQuick = request.filter == Filter::Bilinear;
    options.stop = stop;
    options.plan = request.cells ? request.cells->plan : request.plan;
    if (request.texture && !request.cells) options.blends = request.texture->blends();
    if (request.allOfPicture) options.outside = Outside::Original;
    if (request.texture) {  // the domain may be mirrored, unlike the screen's pixels
        view.origin.setZero();
        view.scale = 1;
    }
    return request.picture->warped(*restOf(request), poseOf(request), view, options);
}

QTransform toPixels(const RenderRequest& request) {
    return request.view.matrix() * QTransform::fromScale(request.scale(), request.scale());
}

int alphaAt(const RenderRequest& request, double position) {
    if (!request.picture) return 255;
    if (!request.plain) return static_cast<int>(std::lround(255 * request.colours.opacity));
    const double part =
        paintedPart(position, positionIn(request.colours.range, request.colours.measure, *request.plain));
    return static_cast<int>(std::lround(255 * paintOpacity(request.colours.opacity) * part));
}

/// Fills paint with soft edges: corners have the mean colour of their cells, except at sharp edges.
template <class ColourOf>
void fillPaint(CellFiller& filler, const PosedFrame<2>& frame, const std::vector<int>& order,
               const std::vector<double>& values, const ColourOf& colourOf) {
    std::vector<QRgb> ofCells;
    for (std::size_t c = 0; c < frame.rest->cells.size(); ++c) ofCells.push_back(colourOf(c));
    const auto means = softColours(frame, ofCells);
    const auto sharp = sharpCells(frame, values);
    for (const int index : order) {
        const auto c = static_cast<std::size_t>(index);
        const Cell<2>& cell = frame.rest->cells[c];
        if (sharp[c])
            filler.fill(cell, ofCells[c]);
        else
            filler.fill(cell, std::array{means[cell[0]], means[cell[1]], means[cell[2]]});
    }
}

/// Fills without cell borders.
void fillSmoothly(CellFiller& filler, const RenderRequest& request, const std::vector<int>& order,
                  const std::vector<double>& ofCells) {
    const PosedFrame<2>& frame = *request.frame;
    const auto places = smoothPlaces(frame, ofCells, request.colours.measure, request.colours.range);
    const int alpha = request.picture ? static_cast<int>(std::lround(255 * request.colours.opacity)) : 255;
    std::vector<QRgb> ramp = colourRamp(request.colours.measure);
    for (QRgb& colour : ramp)
        colour = qPremultiply(qRgba(qRed(colour), qGreen(colour), qBlue(colour), alpha));
    for (const int index : order) {
        const Cell<2>& cell = frame.rest->cells[static_cast<std::size_t>(index)];
        filler.fill(cell, std::array{places[cell[0]], places[cell[1]], places[cell[2]]}, ramp);
    }
}

/// Colours mean the map's: the picture below it has none.
void takeColours(QImage& image) {
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const int gray = qGray(row[x]);
            row[x] = qRgba(gray, gray, gray, qAlpha(row[x]));
        }
    }
}

void fillCells(QImage& image, const RenderRequest& request) {
    const PosedFrame<2>& frame = *request.frame;
    const auto values =
        request.map ? cellValues(frame, request.colours.measure, request.velocity) : std::vector<double>();
    const auto colourOf = [&](std::size_t c) {
        const double position = positionIn(request.colours.range, request.colours.measure, values[c]);
        const QRgb colour = colourAt(request.colours.measure, position);
        return qRgba(qRed(colour), qGreen(colour), qBlue(colour), alphaAt(request, position));
    };
    image.convertTo(QImage::Format_ARGB32_Premultiplied);
    if (request.map && request.picture && !request.plain) takeColours(image);
    const auto plan = request.cellPlan ? request.cellPlan
                                       : std::make_shared<PaintingPlan>(*frame.rest, std::vector<float>());
    CellFiller filler(image.size(), *plan, frame.pose, toPixels(request));
    if (request.map && isPainted(request.colours.measure)) {
        fillPaint(filler, frame, plan->order, values, colourOf);
    } else if (request.map && request.colours.smooth) {
        fillSmoothly(filler, request, plan->order, values);
    } else {
        for (const int cell : plan->order) {
            const auto c = static_cast<std::size_t>(cell);
            filler.fill(frame.rest->cells[c], request.map ? colourOf(c) : request.fill.rgba());
        }
    }
    using Extent = CellFiller::Extent;
    filler.layOver(image, request.picture && request.cutOut ? Extent::Picture : Extent::Shape);
}

/// The lightness of an image over a background, smoothed so that neither the grain of a picture nor its
/// outline interrupts lines.
class Lightness {
  public:
    Lightness(const QImage& image, const QColor& ground)
        : m_image(image),
          m_smooth(image
                       .scaled(std::max(1, image.width() / kReach), std::max(1, image.height() / kReach),
                               Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                       .scaled(image.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation)),
          m_ground(qGray(ground.rgb())) {}
    /// Returns the lightness from 0 to 255.
    int at(int x, int y) const {
        const QRgb mean = line(m_smooth, y)[x];
        const int alpha = qAlpha(line(m_image, y)[x]), around = std::max(1, qAlpha(mean));
        return (alpha * std::min(255, qGray(mean) * 255 / around) + (255 - alpha) * m_ground) / 255;
    }

  private:
    static constexpr int kReach = 10;
    static const QRgb* line(const QImage& image, int y) {
        return reinterpret_cast<const QRgb*>(image.constScanLine(y));
    }
    const QImage& m_image;
    QImage m_smooth;
    int m_ground;
};

QImage edgesOf(const RenderRequest& request, const QSize& size) {
    constexpr double kTooDense = 2;  // pixels between lines that would be a veil
    const PosedFrame<2>& frame = *request.frame;
    const double edge = frame.diagonal / std::sqrt(2.0 * frame.rest->vertexCount()) *
                        request.view.zoom();  // about, on the screen
    QImage drawn(size, QImage::Format_ARGB32_Premultiplied);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    painter.setTransform(toPixels(request));
    painter.setRenderHint(QPainter::Antialiasing);
    QColor colour = request.line;
    colour.setAlphaF(std::clamp((edge - kTooDense) / 14, 0.06, 0.55));
    QPen pen(colour, 1);
    pen.setCosmetic(true);
    painter.setPen(pen);
    QList<QLineF> lines;
    for (const auto& facet : facetsOf(*frame.rest)) {
        const int a = facet.vertices[0], b = facet.vertices[1];
        lines << QLineF(frame.pose(0, a), frame.pose(1, a), frame.pose(0, b), frame.pose(1, b));
    }
    painter.drawLines(lines);
    return drawn;
}

/// Light ones where it is dark below.
void drawEdges(QImage& image, const RenderRequest& request) {
    constexpr int kDark = 112;
    const QRgb light = request.lightLine.rgb() & RGB_MASK;
    QImage lines = edgesOf(request, image.size());
    image.convertTo(QImage::Format_ARGB32_Premultiplied);
    const Lightness below(image, request.ground);
    for (int y = 0; y < lines.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(lines.scanLine(y));
        for (int x = 0; x < lines.width(); ++x)
            if (line[x] != 0 && below.at(x, y) < kDark)
                line[x] = qPremultiply(light | static_cast<QRgb>(qAlpha(line[x])) << 24);
    }
    QPainter(&image).drawImage(0, 0, lines);
}

}  // namespace

RenderThread::RenderThread(QObject* parent)
    : QObject(parent), m_thread([this](std::stop_token stop) { loop(std::move(stop)); }) {}

RenderThread::~RenderThread() {
    m_thread.request_stop();
    {
        const std::lock_guard lock(m_mutex);
        m_current.request_stop();
    }
    m_thread.join();
}

void RenderThread::post(RenderRequest request) {
    {
        const std::lock_guard lock(m_mutex);
        // A drawing of higher quality is interrupted; one of a moving shape is finished, or none would ever
        // be shown.
        if (!m_next && request.filter == Filter::Bilinear) m_current.request_stop();
        m_next = std::move(request);
    }
    m_arrived.notify_one();
}

void RenderThread::loop(std::stop_token stop) {
    while (!stop.stop_requested()) {
        std::stop_token token;
        auto result = std::make_shared<RenderResult>();
        {
            std::unique_lock lock(m_mutex);
            m_arrived.wait(lock, stop, [this] { return m_next.has_value(); });
            if (!m_next) return;
            result->request = std::move(*m_next);
            m_next.reset();
            m_current = std::stop_source();
            // Only drawings of full quality can be interrupted.
            if (result->request.filter != Filter::Bilinear) token = m_current.get_token();
        }
        const auto begin = std::chrono::steady_clock::now();
        chooseCells(result->request);
        result->image = render(result->request, token);
        result->milliseconds =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        if (result->image.isNull()) continue;
        m_out.call([this, result = std::shared_ptr<const RenderResult>(std::move(result))] {
            emit rendered(result);
        });
    }
}

void RenderThread::chooseCells(RenderRequest& request) {
    const bool moves = request.filter == Filter::Bilinear && request.frame && request.frame->live;
    if (!moves || !request.picture) return;
    const double tolerance = kDrawnOff / (request.view.zoom() * request.scale());
    const Texture* parts = request.texture && request.texture->drawn ? request.texture.get() : nullptr;
    if (!parts) {
        request.cells = m_moving.of(request.frame->rest, request.plan, request.frame->pose, tolerance);
    } else if (parts->blends().empty()) {  // which are of the parts' own cells
        const Points2 pose = parts->withRiders(request.frame->pose);
        request.cells = m_moving.of(parts->rest, request.plan, pose, tolerance);
    }
}

QImage RenderThread::render(const RenderRequest& request, std::stop_token stop) {
    if (!request.frame || request.size.isEmpty()) return {};
    QImage image;
    if (request.picture) image = warped(request, stop);
    if (stop.stop_requested()) return {};
    if (image.isNull()) {
        image = QImage(request.size * request.scale(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
    }
    if (request.map || !request.picture) fillCells(image, request);
    if (request.mesh) drawEdges(image, request);
    image.setDevicePixelRatio(request.scale());
    return image;
}

}  // namespace wend
