#include "app/view/volume/solid_canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/domain.h"
#include "app/panels/legend.h"
#include "app/session/caged_solid.h"
#include "app/session/rest_frame.h"
#include "app/session/shape.h"
#include "app/view/volume/solid_painter.h"

namespace wend {

namespace {

constexpr int kDimAfter = 250;                                // milliseconds
constexpr QRgb kSectionColour = 0xffe3b48e;                   // of the face of a cut, while no map is shown
constexpr int kMarksEvery = 40, kMarksEveryInSoftware = 120;  // without a frame
const QRgb kPlain = qRgb(199, 186, 164), kPlainDark = qRgb(176, 164, 146);

/// What lies over the picture; the pointer goes through it.
class Overlay : public QWidget {
  public:
    explicit Overlay(SolidCanvas& canvas) : QWidget(&canvas), m_canvas(canvas) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_canvas.paintOver(painter);
    }

  private:
    SolidCanvas& m_canvas;
};

bool isEmbeddedInCage(const PosedFrame<3>& frame) {
    return frame.built->source && frame.built->skin && isCage(*frame.built->source, *frame.built->skin);
}

}  // namespace

SolidCanvas::SolidCanvas(ShapeSession& session, QWidget* parent)
    : VolumeView(parent),
      m_session(session),
      m_cutTool(*this, [this](const CutPlane& plane) { setCutPlane(plane); }),
      m_overlay(new Overlay(*this)) {
    setMinimumSize(320, 240);
    m_dim.setSingleShot(true);
    m_dim.setInterval(kDimAfter);
    m_style.edges = false;
    applyTheme();
    connect(&m_dim, &QTimer::timeout, this, [this] {
        m_dimmed = m_session.isStale();
        refresh();
    });
    m_marksDue.setSingleShot(true);
    connect(&m_marksDue, &QTimer::timeout, m_overlay, qOverload<>(&QWidget::update));
    connect(&m_session, &ShapeSession::frameChanged, this, &SolidCanvas::takeFrame);
    connect(&m_session, &ShapeSession::pinsChanged, this, &SolidCanvas::redraw);
    connect(&m_animation, &PinAnimation::changed, m_overlay, qOverload<>(&QWidget::update));
    connect(&m_session.playback(), &Playback::playingChanged, m_overlay, qOverload<>(&QWidget::update));
    connect(&m_session.document(), &Document::projectChanged, this, [this] {
        m_preview.takeProject();
        takeUpAxis();
    });
    connect(&m_session.document(), &Document::viewWanted, this, &SolidCanvas::keepCamera);
    connect(this, &VolumeView::cameraChanged, this, &SolidCanvas::redraw);
    takeFrame();
}

void SolidCanvas::applyTheme() {
    const Theme theme = Theme::of(palette());
    setBackground(m_backdrop.isValid() ? m_backdrop : theme.workspace);
    m_style.edgeColour = theme.dark ? QColor(12, 13, 18) : QColor(20, 24, 32);
    setStyle(m_style);
}

void SolidCanvas::setBackdrop(const QColor& colour) {
    m_backdrop = colour;
    applyTheme();
    update();
}

void SolidCanvas::setTool(Tool* tool) {
    if (Tool* last = std::exchange(m_tool, nullptr)) {
        last->cancel();
        last->leave();
        last->dismiss();
    }
    m_tool = tool;
    m_active = nullptr;
    redraw();
    if (!tool) return;
    tool->choose();
    setCursor(tool->cursor());
    tellHint(*tool);
}

/// Without a solid there is nothing that a tool could do.
void SolidCanvas::tellHint(const Tool& tool) {
    emit hintChanged(m_session.frame<3>() ? tool.hint() : QString());
}

/// Pins and paths as well.
Points<3> SolidCanvas::fitted() const {
    const Points<3> drawn = VolumeView::fitted();
    if (m_hidden || !m_session.frame<3>()) return drawn;
    const std::vector<Vec<3>> marked = pathPoints(m_session);
    Points<3> all(3, drawn.cols() + static_cast<Eigen::Index>(marked.size()));
    all.leftCols(drawn.cols()) = drawn;
    for (std::size_t i = 0; i < marked.size(); ++i)
        all.col(drawn.cols() + static_cast<Eigen::Index>(i)) = marked[i];
    return all;
}

/// While a solid follows the hand, painting for the pointer alone would take the time that the solid needs:
/// the whole window is put together for it, by the processor where there is nothing else that draws.
void SolidCanvas::redraw() {
    if (!m_session.isDragging())
        m_overlay->update();
    else if (!m_marksDue.isActive())
        m_marksDue.start(drawsInSoftware() ? kMarksEveryInSoftware : kMarksEvery);
}

/// What a gesture has gathered are cells and vertices of the mesh that it began on.
void SolidCanvas::endGestureOnOtherMesh() {
    const auto frame = m_session.frame<3>();
    const std::shared_ptr<const void> mesh = frame ? frame->shape : nullptr;
    if (std::exchange(m_mesh, mesh) == mesh || !m_active) return;
    std::exchange(m_active, nullptr)->cancel();
    redraw();
}

void SolidCanvas::takeFrame() {
    endGestureOnOtherMesh();
    const bool hasSolid = m_session.frame<3>() != nullptr;
    if (std::exchange(m_hasSolid, hasSolid) != hasSolid && m_tool) tellHint(*m_tool);
    if (m_session.isStale() && !m_dimmed) {
        if (!m_dim.isActive()) m_dim.start();
    } else if (!m_session.isStale()) {
        m_dim.stop();
        m_dimmed = false;
    }
    refresh();
}

QRgb SolidCanvas::plainColour() const {
    const QRgb plain = Theme::of(palette()).dark ? kPlainDark : kPlain;
    return m_dimmed ? dimmed(plain) : plain;
}

bool SolidCanvas::hasDetail(const PosedFrame<3>& frame) const {
    const auto& skin = frame.built->skin;
    return skin && frame.built->embedding &&
           (isEmbeddedInCage(frame) || !m_session.document().domain().detail.empty() ||
            !skin->materials.empty());
}

bool SolidCanvas::hasDetail() const {
    const auto frame = m_session.frame<3>();
    return frame && hasDetail(*frame);
}

VolumePicture SolidCanvas::plainPicture(const PosedFrame<3>& frame) const {
    VolumePicture picture;
    picture.rest = frame.rest;
    picture.facets = frame.built->facets;
    picture.pose = frame.pose;
    picture.cellColours.assign(frame.rest->cells.size(), plainColour());
    picture.section = kSectionColour;
    picture.materials = m_detail && hasDetail(frame);
    if (!picture.materials) return picture;
    picture.skin = frame.built->skin;
    picture.embedding = frame.built->embedding;
    return picture;
}

SurfaceStyle SolidCanvas::plainStyle() const {
    SurfaceStyle style = m_style;
    style.edges = false;
    style.dimming = style.mapOpacity = 0;
    return style;
}

/// True once for each document: its view is still to be found.
bool SolidCanvas::meetsNewDocument() {
    const int generation = m_session.document().generation();
    if (std::exchange(m_generation, generation) == generation) return false;
    m_planeChosen = false;
    m_fitted = true;
    return true;
}

/// A new solid is seen whole: first as it comes, then, when its motion is known, as it is shown then.
void SolidCanvas::refresh() {
    auto frame = m_standIn ? posed<3>(m_standIn) : shownFrame();
    if (frame && m_rest) frame = atRest<3>(frame);
    m_missed = m_held;
    if (m_lock) m_lock->setVisible(frame && hasLegend());
    if (!frame) setGlyphs({});  // those of the last solid
    if (!frame || m_held) return;
    VolumePicture picture = plainPicture(*frame);
    if (showsMap()) addMap(picture, *frame);
    m_style.dimming = m_dimmed && picture.materials ? 0.5 : 0;
    m_style.mapOpacity = showsMap() && picture.materials ? m_opacity : 0;
    setStyle(m_style);
    const bool isNew = meetsNewDocument();
    if (isNew) {
        m_toFit = true;
        lookAtFirst();
    }
    if (frame->live || m_session.playback().isPlaying()) hurry();
    setPicture(std::move(picture), m_toFit && m_fitted);
    if (isNew) takeKeptCamera();
    m_toFit = m_toFit && m_session.isStale();
    showGlyphs(*frame);
    m_overlay->update();  // with the solid: the window is put together once
}

bool SolidCanvas::isMoving() const {
    return VolumeView::isMoving() || m_session.isDragging() || m_session.playback().isPlaying();
}

void SolidCanvas::setHeld(bool held) {
    m_held = held;
    if (!held && m_missed) refresh();
}

void SolidCanvas::showPreview(const std::shared_ptr<const Skin>& skin) {
    if (m_session.frame<3>() || skin->points.cols() == 0 || !skin->points.allFinite()) return;
    const QRgb plain = Theme::of(palette()).dark ? kPlainDark : kPlain;
    lookAtFirst();
    setPicture(pictureOfSurface(skin->points, skin->triangles,
                                std::vector<QRgb>(skin->triangles.size(), dimmed(plain))),
               true);
    takeKeptCamera();
    redraw();
}

void SolidCanvas::showRefused(VolumePicture picture, const Vec<3>& direction) {
    const bool isNew = meetsNewDocument();
    if (isNew) lookAtFirst();
    m_toFit = false;
    setPicture(std::move(picture), false);
    if (isNew) lookAlong(direction);
    redraw();
}

void SolidCanvas::showPlace(VolumePicture picture, const Vec<3>& direction, const Points<3>& around) {
    setPicture(std::move(picture), false);
    camera().lookAlong(direction);
    camera().fit(around, size());
    m_fitted = false;
    update();
    redraw();
}

void SolidCanvas::showSolid() {
    refresh();
    fit();
}

void SolidCanvas::lookAlong(const Vec<3>& direction) {
    camera().lookAlong(direction);
    m_fitted = true;
    fit();
}

void SolidCanvas::setFlat(bool flat) {
    m_style.flat = flat;
    setStyle(m_style);
}

void SolidCanvas::setEdgesShown(bool shown) {
    m_style.edges = shown;
    setStyle(m_style);
}

void SolidCanvas::setDetailShown(bool shown) {
    m_detail = shown, refresh();
}
void SolidCanvas::setArrowsShown(bool shown) {
    m_arrows = shown, wantVelocity(), refresh();
}
void SolidCanvas::setValuesShown(bool shown) {
    m_values = shown, wantVelocity();
}
void SolidCanvas::setGlyphsShown(bool shown) {
    m_glyphs = shown, refresh();
}
void SolidCanvas::setLayer(const QString& name) {
    m_layer.setLayer(name), redraw();
}
void SolidCanvas::setRestShown(bool shown) {
    if (std::exchange(m_rest, shown) != shown) refresh();
}

void SolidCanvas::setStandIn(const FramePtr& frame) {
    if (std::exchange(m_standIn, frame) != frame) refresh();
}

void SolidCanvas::takeView(const SolidCanvas& other) {
    m_fitted = other.m_fitted;
    camera() = other.camera();
    m_cutTool.setPlane(other.plane());
    setCut(other.cut(), other.plane());
    update();
    redraw();
}

void SolidCanvas::setOnionSkin(bool shown) {
    m_onion.setShown(shown), redraw();
}

void SolidCanvas::setOverlaysHidden(bool hidden) {
    m_hidden = hidden, refresh();
}

void SolidCanvas::resizeEvent(QResizeEvent* event) {
    VolumeView::resizeEvent(event);
    m_overlay->setGeometry(rect());
    if (m_fitted && !m_held) fit();
}

}  // namespace wend
