#include "app/views/canvas/drawn_shape.h"

#include <QPainter>
#include <utility>

#include "app/base/in_background.h"
#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/session/shape_session.h"
#include "app/style/smooth_map.h"
#include "core/energy/distortion.h"

namespace wend {

namespace {

constexpr int kRefineAfter = 140;  // milliseconds
constexpr int kRefineInDrag = 250;

/// Returns a picture at rest as two triangles.
PosedPtr<2> unbent(const Image& picture) {
    auto rest = std::make_shared<SimplicialMesh<2>>();
    rest->points.resize(2, 4);
    const double w = picture.width, h = picture.height;
    rest->points << 0, w, w, 0, 0, 0, h, h;
    rest->cells = {{0, 1, 2}, {0, 2, 3}};
    auto frame = std::make_shared<PosedFrame<2>>();
    frame->rest = rest;
    frame->pose = rest->points;
    frame->distortion = std::make_shared<const Distortion>(distortion<2>(*rest, rest->points));
    return frame;
}

}  // namespace

DrawnShape::DrawnShape(const Viewport& viewport, const ViewTransform& view)
    : m_viewport(viewport), m_view(view) {
    m_refine.setSingleShot(true);
    connect(&m_refine, &QTimer::timeout, this, [this] {
        if (isReady()) m_renderer.post(request(Filter::Ewa));
    });
    connect(&m_renderer, &RenderThread::rendered, this, &DrawnShape::takeRendered);
}

const Document& DrawnShape::document() const {
    return m_viewport.shape().session().document();
}

const ShapeMotion& DrawnShape::motion() const {
    return m_viewport.shape().session().motion();
}

void DrawnShape::takeOpened() {
    m_picture = m_flat = nullptr;
    m_source = m_pictureOf = nullptr;
    m_unbent = nullptr;
    m_drawn = nullptr;
    const auto& picture = document().picture();
    if (!picture) return;
    m_unbent = unbent(*picture);
    prepare(picture);
}

void DrawnShape::prepare(const std::shared_ptr<const Image>& picture) {
    m_source = picture;
    const auto prepare = [picture] { return std::make_shared<const ScreenPicture>(picture); };
    inBackground(this, prepare, [this, picture](const std::shared_ptr<const ScreenPicture>& prepared) {
        if (picture == document().picture()) m_flat = prepared;
        if (m_source != picture) return;
        m_picture = prepared;
        m_pictureOf = picture;
        emit this->prepared();
    });
}

/// Prepares the picture to draw: the atlas of a picture of parts, the picture that a mesh brings, or else the
/// document's.
void DrawnShape::takeFrame(const PosedFrame<2>& frame) {
    if (!frame.built) return;
    const auto& texture = frame.built->texture;
    const auto& own = document().picture();
    if (!own && (!texture || m_drawn)) return;
    const auto& wanted = !own || (texture && texture->drawn) ? frame.built->picture : own;
    if (wanted != m_source) prepare(wanted);
}

/// Returns the picture of a frame; null without one, or while it is prepared.
std::shared_ptr<const ScreenPicture> DrawnShape::pictureOf(const PosedPtr<2>& frame) const {
    if (!frame || frame == m_unbent || !frame->built) return frame == m_unbent ? m_flat : m_picture;
    const bool hasParts = frame->built->texture && frame->built->texture->drawn;
    if (!hasParts) return document().picture() ? m_flat : m_picture;
    return m_pictureOf == frame->built->picture ? m_picture : nullptr;
}

Theme DrawnShape::theme() const {
    const Theme theme = m_viewport.theme();
    return m_picture && !m_picture->opaque() ? theme.behind(m_picture->lightness()) : theme;
}

/// Returns whether there is what is to be drawn.
bool DrawnShape::isReady() const {
    return frame() && (pictureOf(frame()) || !document().picture());
}

PosedPtr<2> DrawnShape::frame() const {
    const PosedPtr<2> own =
        posed<2>(m_viewport.shape().shownFrame());  // a picture itself is seen before its mesh is there
    const PosedPtr<2> frame = own ? posed<2>(seen(m_viewport.looks(), own)) : nullptr;
    return frame ? frame : m_unbent;
}

CellDepths::Values DrawnShape::depths() const {
    const auto frame = motion().frame<2>();
    if (!frame) return nullptr;
    const FramePtr& standIn = m_viewport.looks().standIn;
    const auto seen = standIn ? posed<2>(standIn) : frame;
    const auto mesh = seen->built ? drawnRest(*seen->built) : seen->rest;
    return m_depths.of(document().depth(), mesh, partLevels(document().domain().parts, *mesh, seen->time));
}

std::shared_ptr<const PaintingPlan> DrawnShape::plan() const {
    return depths() ? m_depths.plan() : nullptr;
}

/// Returns the plan of the mesh without attached parts.
std::shared_ptr<const PaintingPlan> DrawnShape::cellPlan() const {
    const PosedPtr<2> frame = this->frame();
    if (!depths() || !frame || !frame->built ||
        drawnRest(*frame->built)->cellCount() == frame->rest->cellCount())
        return plan();
    m_cellDepths.of(document().depth(), frame->rest,
                    partLevels(document().domain().parts, *frame->rest, frame->time));
    return m_cellDepths.plan();
}

/// Returns whether parts outside the outline are shown, too.
bool DrawnShape::showsAll() const {
    return m_viewport.tool() && m_viewport.tool()->showsPicture() && !m_viewport.looks().hidden;
}

bool DrawnShape::isSettled() const {
    return m_drawn && !m_refine.isActive() && m_drawn->request.filter == Filter::Ewa && motion().frame() &&
           m_drawn->request.frame == frame() && m_drawn->request.view == m_view &&
           m_drawn->request.plan == plan() &&
           (m_drawn->request.allOfPicture == showsAll() || !document().domain().parts.empty());
}

RenderRequest DrawnShape::request(Filter filter) const {
    const Looks& looks = m_viewport.looks();
    RenderRequest request;
    request.document = document().generation();
    request.frame = frame();
    request.picture = pictureOf(request.frame);
    if (request.frame && request.frame->built) request.texture = request.frame->built->texture;
    request.plan = plan();
    request.cellPlan = cellPlan();
    request.allOfPicture = showsAll() && !(request.texture && request.texture->drawn);
    request.view = m_view;
    request.size = m_viewport.widget().size();
    request.ratio = m_viewport.widget().devicePixelRatioF();
    request.filter = filter;
    const double pixels = request.ratio * request.ratio * request.size.width() * request.size.height();
    if (filter == Filter::Bilinear) request.coarseness = m_pace.coarseness(pixels);
    request.cutOut = !document().isEmpty() && document().domain().outline == OutlineKind::Alpha;
    const bool isShape = request.frame != m_unbent;
    request.mesh = isShape && (looks.mesh || !m_picture) && !looks.hidden;
    request.map = isShape && m_viewport.showsMap();
    request.colours = looks.colours;
    if (request.map) request.plain = plainValue(motion(), looks.colours.measure);
    if (request.map) request.velocity = fieldOf(motion(), looks.colours.measure);
    const Theme theme = this->theme();
    request.fill = theme.dark ? QColor(0x5b6070) : QColor(0xbfc6dd);
    request.ground = !m_picture                 ? theme.workspace
                     : looks.backdrop.isValid() ? looks.backdrop
                                                : theme.checkerA;
    request.line = QColor(24, 28, 44);
    return request;
}

QImage DrawnShape::smallView(const QSize& size) const {
    const auto small = smallRequest(motion().frame<2>(), size);
    return small && m_picture ? RenderThread::render(*small) : QImage();
}

std::optional<RenderRequest> DrawnShape::smallRequest(const PosedPtr<2>& frame, const QSize& size) const {
    if (!frame || !motion().frame() || m_viewport.looks().standIn) return {};  // owner of the plan
    RenderRequest small = request(Filter::Ewa);
    small.frame = frame;
    small.mesh = small.map = small.allOfPicture = false;
    small.ratio = 1;
    small.size = size;
    small.view.fit(boxOf(frame->pose), size, 0);
    return small;
}

void DrawnShape::render() {
    if (!isReady()) return;
    m_renderer.post(request(Filter::Bilinear));
    m_refine.start(motion().isDragging() ? kRefineInDrag : kRefineAfter);
}

void DrawnShape::takeRendered(const std::shared_ptr<const RenderResult>& result) {
    const bool isOld = result->request.document != document().generation();
    if (isOld || !frame() || result->request.picture != pictureOf(frame())) return;
    m_drawn = result;
    if (result->request.filter == Filter::Bilinear)
        m_pace.learn(double(result->image.width()) * result->image.height(), result->milliseconds);
    m_viewport.widget().update();
}

void DrawnShape::paint(QPainter& painter) const {
    if (!m_drawn) return;
    // Until the new view is drawn, shows the last one, moved and scaled.
    const RenderRequest& request = m_drawn->request;
    const double scale = m_view.zoom() / request.view.zoom();
    const QPointF origin = m_view.toWidget(request.view.toShape({0, 0}));
    painter.save();
    painter.setOpacity(m_viewport.isDimmed() ? 0.55 : 1);
    const QRectF target(origin, QSizeF(m_drawn->image.size()) / request.scale() * scale);
    const bool fits = request.view == m_view && request.coarseness == 1;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !fits);
    if (fits) {
        painter.drawImage(QPointF(0, 0), m_drawn->image);
    } else {  // Qt does not enlarge an image of fewer pixels than the screen's by its ratio
        painter.drawImage(target, m_drawn->image);
    }
    painter.restore();
}

}  // namespace wend
