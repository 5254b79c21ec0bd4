#include "app/views/volume/solid_canvas.h"

#include <utility>

#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/style/colours.h"
#include "app/style/smooth_map.h"
#include "app/style/theme.h"

namespace wend {

namespace {

// The colour of a cut face while no map is shown: a rose that no map uses.
constexpr QRgb kSectionColour = 0xffd6a8b8;
constexpr int kMarksEvery = 40, kMarksEveryInSoftware = 120;  // without a frame
const QRgb kPlain = qRgb(199, 186, 164), kPlainDark = qRgb(176, 164, 146);

/// The overlay of the picture, transparent to the mouse.
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

}  // namespace

SolidCanvas::SolidCanvas(ShapeSession& session, QWidget* parent)
    : VolumeView(parent),
      m_session(session),
      m_cutTool(
          *this, [this](const CutPlane& plane) { setCutPlane(plane); },
          [this] { return m_viewport.tool() && m_viewport.tool()->hasManipulator(); }),
      m_overlay(new Overlay(*this)),
      m_viewport(*this, *this, *m_overlay, session, 3, &m_cutTool) {
    setMinimumSize(320, 240);
    applyTheme();
    connect(&m_session, &ShapeSession::frameChanged, this, &SolidCanvas::takeFrame);
    connect(&m_session, &ShapeSession::pinsChanged, this, &SolidCanvas::redraw);
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
    const Looks& looks = m_viewport.looks();
    m_style.edges = looks.mesh;
    m_style.flat = looks.flat;
    setBackground(ground());
    m_style.edgeColour = theme.dark ? QColor(12, 13, 18) : QColor(20, 24, 32);
    setStyle(m_style);
}

QColor SolidCanvas::ground() const {
    const QColor& backdrop = m_viewport.looks().backdrop;
    return backdrop.isValid() ? backdrop : Theme::of(palette()).workspace;
}

void SolidCanvas::showLooks() {
    applyTheme();
    refresh();
    update();
}

/// Repainting composes the whole window, which is slow without a GPU.
void SolidCanvas::redraw() {
    m_viewport.redraw(drawsInSoftware() ? kMarksEveryInSoftware : kMarksEvery);
}

/// Cancels gestures with cells and vertices of an old mesh.
void SolidCanvas::takeFrame() {
    const auto frame = m_session.frame<3>();
    const std::shared_ptr<const void> mesh = frame ? frame->shape : nullptr;
    if (std::exchange(m_mesh, mesh) != mesh) m_viewport.cancelGesture();
    m_viewport.takeFrame();
    refresh();
}

QRgb SolidCanvas::plainColour() const {
    const QRgb plain = Theme::of(palette()).dark ? kPlainDark : kPlain;
    return m_viewport.isDimmed() ? dimmed(plain) : plain;
}

bool SolidCanvas::hasDetail(const PosedFrame<3>& frame) const {
    const auto& skin = frame.built->skin;
    return skin && frame.built->embedding &&
           (frame.built->cage || !m_session.document().domain().detail.empty() || hasOwnColours(*skin));
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
    picture.materials = m_viewport.looks().detail && hasDetail(frame);
    if (!picture.materials) return picture;
    picture.skin = frame.built->skin;
    picture.embedding = frame.built->embedding;
    return picture;
}

SurfaceStyle SolidCanvas::plainStyle() const {
    SurfaceStyle style = m_style;
    style.edges = false;
    style.dimming = style.mapOpacity = 0;
    style.rim = QColor();
    return style;
}

/// Returns true once per document, whose view is then initialized.
bool SolidCanvas::meetsNewDocument() {
    const int generation = m_session.document().generation();
    if (std::exchange(m_generation, generation) == generation) return false;
    m_planeChosen = false;
    m_fitted = true;
    return true;
}

/// Fits the view to a new solid: first at rest, then again when its motion is known.
void SolidCanvas::refresh() {
    const Looks& looks = m_viewport.looks();
    const auto frame = seen<3>(looks, posed<3>(shownFrame()));
    m_missed = m_held;
    m_viewport.showLegendLock();
    if (!frame) setGlyphs({});  // those of the last solid
    if (!frame || m_held) return;
    VolumePicture picture = plainPicture(*frame);
    if (m_viewport.showsMap()) addMap(picture, *frame);
    m_style.dimming = m_viewport.isDimmed() && picture.materials ? 0.5 : 0;
    const bool hasMap = m_viewport.showsMap() && !isPainted(looks.colours.measure);
    m_style.mapOpacity = hasMap && picture.materials ? looks.colours.opacity : 0;
    m_style.rim = hasMap && isOnDark() ? QColor::fromRgba(kRim) : QColor();
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

void SolidCanvas::setDetailRegions(const std::vector<SoftRegion>& regions) {
    m_detailRegions.setRegions(regions);
    m_overlay->update();
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

void SolidCanvas::takeView(const SolidCanvas& other) {
    m_fitted = other.m_fitted;
    camera() = other.camera();
    m_cutTool.setPlane(other.plane());
    setCut(other.cut(), other.plane());
    update();
    redraw();
}

void SolidCanvas::resizeEvent(QResizeEvent* event) {
    VolumeView::resizeEvent(event);
    m_overlay->setGeometry(rect());
    if (m_fitted && !m_held) fit();
}

}  // namespace wend
