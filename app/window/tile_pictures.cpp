#include "app/window/tile_pictures.h"

#include "app/engine/shape/shape.h"
#include "app/engine/shape/shape_builder.h"
#include "app/panels/fields/energy_slider.h"
#include "app/project/domain.h"
#include "app/project/options/options.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

namespace {

constexpr int kIdle = 500;  // milliseconds
constexpr int kVertices = 600;
constexpr double kTileMargin = 2;  // pixels

}  // namespace

TilePictures::TilePictures(ShapeSession& session, const ShapeCanvas& picture,
                           std::function<SolidCanvas*()> solid, EnergySlider& tiles)
    : QObject(&tiles), m_session(session), m_canvas(picture), m_solid(std::move(solid)), m_tiles(tiles) {
    m_coarse.document().undoStack()->setUndoLimit(1);
    m_idle.setSingleShot(true);
    m_idle.setInterval(kIdle);
    connect(&m_idle, &QTimer::timeout, this, &TilePictures::begin);
    connect(&m_session, &ShapeSession::frameChanged, this, &TilePictures::expire);
    connect(&m_session.document(), &Document::opened, this, [this] {
        m_coarse.document().close();
        m_project.reset();
        m_tiles.setPictures({});
        expire();
    });
    connect(&m_coarse, &ShapeSession::busyChanged, this, &TilePictures::take);
}

/// There is no coarser mesh for a mesh from a file.
bool TilePictures::isPossible() const {
    if (m_session.document().isEmpty() || !m_session.frame() || m_session.playback().end() <= 0) return false;
    const DomainKind kind = m_session.document().domain().kind;
    return (kind == DomainKind::Image && m_session.document().picture()) ||
           (kind == DomainKind::Surface && m_solid());
}

void TilePictures::expire() {
    const bool same = m_project == m_session.document().project() && m_time == m_session.playback().time();
    if (same && (m_done || m_running)) return;
    m_running = m_done = false;
    if (!isPossible()) {
        m_idle.stop();
        return m_tiles.setPictures({});
    }
    m_tiles.setPicturesStale(true);
    m_idle.start();
}

void TilePictures::begin() {
    if (!isPossible() || m_running) return;
    const bool moves = m_session.isBusy() || m_session.isDragging() || m_session.playback().isPlaying();
    const bool flat = m_session.document().dimension() == 2;
    if (moves || !m_tiles.isVisible() || (flat && !m_canvas.screenPicture())) return m_idle.start();
    m_project = m_session.document().project();
    m_time = m_session.playback().time();
    m_made.clear();
    m_running = true;
    ask();
}

/// Requests the next picture.
void TilePictures::ask() {
    const auto project = copyOf(*m_project);
    Domain& domain = domainOf(*project);
    const auto set = [&](const char* key, double value) { option(key).field.at.set(*project, value); };
    set("material.phi", m_tiles.scale().stops().at(m_made.size()).phi);
    set("domain.vertices", std::min(domain.edge > 0 ? kVertices : domain.vertices, kVertices));
    if (domain.kind == DomainKind::Surface) domain.fit = Fit::Cage;
    Document& document = m_coarse.document();
    if (!document.isEmpty()) {
        document.change({}, project);
    } else {
        const Document& own = m_session.document();
        OpenedFile file;
        file.project = project;
        file.picture = own.picture();
        file.path = own.path();
        file.source = own.source();
        document.open(std::move(file));
    }
    m_coarse.playback().setTime(m_time);
}

void TilePictures::take() {
    if (!m_running || m_coarse.isBusy()) return;
    if (!m_coarse.frame()) {  // failed: the window reports it
        m_running = false;
        m_done = true;
        return m_tiles.setPictures({});
    }
    m_made.push_back(drawn(m_coarse.frame()));
    if (m_made.size() < EnergyScale::kStops) return ask();
    m_running = false;
    m_done = true;
    m_tiles.setPictures(m_made);
}

QPixmap TilePictures::drawn(const FramePtr& frame) {
    return frame->dimension == 2 ? drawnFlat(frame) : drawnSolid(static_cast<const PosedFrame<3>&>(*frame));
}

/// Draws from the view's direction.
QPixmap TilePictures::drawnSolid(const PosedFrame<3>& frame) {
    const double ratio = m_tiles.devicePixelRatioF();
    QPixmap picture = QPixmap::fromImage(m_view.draw(*m_solid(), frame, EnergySlider::pictureSize() * ratio));
    picture.setDevicePixelRatio(ratio);
    return picture;
}

QPixmap TilePictures::drawnFlat(const FramePtr& frame) const {
    RenderRequest request;
    request.frame = posed<2>(frame);
    request.picture = m_canvas.screenPicture();
    if (request.frame->built) request.texture = request.frame->built->texture;
    request.size = EnergySlider::pictureSize();
    request.ratio = m_tiles.devicePixelRatioF();
    request.filter = Filter::Ewa;
    const Points<2>& pose = request.frame->pose;
    const Vec<2> low = pose.rowwise().minCoeff(), size = pose.rowwise().maxCoeff() - low;
    request.view.setZoomLimits(1e-9, 1e9);
    request.view.fit(QRectF(low.x(), low.y(), size.x(), size.y()), request.size, kTileMargin);
    return QPixmap::fromImage(RenderThread::render(request));
}

}  // namespace wend
