#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "app/engine/motion/fields.h"
#include "app/engine/motion/pose_places.h"
#include "app/engine/shape/shape.h"
#include "app/style/smooth_map.h"
#include "app/views/shape/shape_painter.h"
#include "app/views/volume/glyphs.h"
#include "app/views/volume/solid_canvas.h"
#include "core/mesh/simplicial_mesh.h"
#include "core/mesh/skin.h"

// Painting on and over a solid, and the interface for tools.

namespace wend {

namespace {

/// Paints a small cross of the axes of the world, the nearest last.
void paintCompass(QPainter& painter, const QPointF& at, const Mat<3>& worldToScreen) {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return worldToScreen(2, a) < worldToScreen(2, b); });
    static const QString kNames[] = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    font.setBold(true);
    painter.setFont(font);
    for (const int k : order) {
        const QPointF tip = at + 30 * QPointF(worldToScreen(0, k), -worldToScreen(1, k));
        painter.setPen(QPen(kSpaceAxes[k], 2.25, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at, tip);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kSpaceAxes[k]);
        painter.drawEllipse(tip, 8, 8);
        painter.setPen(Qt::white);
        painter.drawText(QRectF(tip.x() - 8, tip.y() - 8, 16, 16), Qt::AlignCenter, kNames[k]);
    }
}

const QRgb kArrowColour = qRgb(54, 84, 196), kArrowOnDark = qRgb(92, 126, 255);
const QRgb kGlyphColour = qRgb(226, 140, 44);
constexpr double kNear = 0.2;  // fraction of the diagonal shown around a cell

QRgb withAlpha(QRgb colour, double alpha) {
    return qRgba(qRed(colour), qGreen(colour), qBlue(colour), static_cast<int>(std::lround(255 * alpha)));
}

/// Returns cell colours, not premultiplied, so that edges stay sharp.
SolidPaint paintOf(const ShapeFrame& frame, const std::vector<QRgb>& ofCells,
                   const std::vector<bool>& sharp) {
    SolidPaint paint;
    const auto means = softColours(frame, ofCells);
    paint.colours = paint.opacities = Points<3>::Zero(3, static_cast<Eigen::Index>(means.size()));
    for (std::size_t v = 0; v < means.size(); ++v) {
        paint.colours.col(static_cast<Eigen::Index>(v)) = means[v].head<3>() / 255;
        paint.opacities(0, static_cast<Eigen::Index>(v)) = means[v][3] / 255;
    }
    for (std::size_t c = 0; c < ofCells.size(); ++c) {
        const QRgb visible = (ofCells[c] & RGB_MASK) == 0 ? ofCells[c] | qRgba(1, 1, 1, 0) : ofCells[c];
        paint.own.push_back(sharp[c] ? visible : 0);
    }
    return paint;
}

/// Finds the nearest of many points: they are sorted by x, and the search proceeds in both directions until
/// the x distance alone exceeds the best.
class NearestPoint {
  public:
    explicit NearestPoint(const Points<3>& points)
        : m_points(points), m_order(static_cast<std::size_t>(points.cols())) {
        std::iota(m_order.begin(), m_order.end(), 0);
        std::stable_sort(m_order.begin(), m_order.end(),
                         [&](int a, int b) { return points(0, a) < points(0, b); });
    }

    /// The lowest of equally near ones; −1 if there are none.
    int to(const Vec<3>& p) const {
        int best = -1;
        double minimum = std::numeric_limits<double>::infinity();
        const auto look = [&](int i) {  // false once all that follow are further away
            const double across = m_points(0, i) - p.x();
            if (across * across > minimum) return false;
            const double distance = (m_points.col(i) - p).squaredNorm();
            if (distance < minimum || (distance == minimum && i < best)) best = i;
            minimum = std::min(minimum, distance);
            return true;
        };
        const auto middle = std::partition_point(m_order.begin(), m_order.end(),
                                                 [&](int i) { return m_points(0, i) < p.x(); });
        for (auto it = middle; it != m_order.end() && look(*it);) ++it;
        for (auto it = middle; it != m_order.begin() && look(*(it - 1));) --it;
        return best;
    }

  private:
    const Points<3>& m_points;
    std::vector<int> m_order;
};

/// Returns the nearest skin point of each vertex on the solid's border at rest; −1 for inner vertices.
std::vector<int> nearestSkinPoints(const Skin& skin, const Points<3>& rest,
                                   const std::vector<Facet<3>>& border) {
    std::vector<int> nearest(static_cast<std::size_t>(rest.cols()), -1);
    const NearestPoint search(skin.points);
    for (const Facet<3>& facet : border) {
        if (facet.interior()) continue;
        for (const int v : facet.vertices)
            if (int& found = nearest[static_cast<std::size_t>(v)]; found < 0) found = search.to(rest.col(v));
    }
    return nearest;
}

constexpr std::size_t kMostRays = 4000;  // vertices of one handle beyond which all count as visible

}  // namespace

void SolidCanvas::paintOver(QPainter& painter) {
    m_viewport.marksPainted();
    paintMarks(painter);
    if (m_viewport.looks().hidden || !m_session.motion().frame<3>()) return;
    m_layer.setLayer(m_viewport.looks().layer);
    m_layer.paint(painter, *this);
    m_detailRegions.paint(painter, *this);
    if (!m_session.playback().isPlaying()) {
        m_cutTool.paint(painter);
        if (const Tool* tool = m_viewport.tool()) tool->paint(painter);
    }
    m_viewport.paintLegend(painter, size());
}

void SolidCanvas::paintMarks(QPainter& painter) {
    const auto frame = m_session.motion().frame<3>();
    const Looks& looks = m_viewport.looks();
    const Measure measure = looks.colours.measure;
    if (solid().picture().pose.cols() == 0) return;
    painter.save();
    paintCompass(painter, QPointF(46, height() - 46), camera().view().topLeftCorner<3, 3>());
    painter.restore();
    if (looks.hidden || !frame) return;
    const Theme theme = Theme::of(palette());
    ShapePainter over(painter, *this, theme);
    if (looks.map && isDistortion(measure)) over.worst(*frame, measure);
    if (m_pointedOf == frame->shape) over.worst(*frame, m_pointedCell);
    m_onion.setShown(looks.onionSkin);
    m_onion.paintOutlines(painter, *this);
    if (const auto& built = *frame->built; built.cloud && looks.detail)
        over.dots(built.cloudEmbedding->carry(*frame->rest, frame->pose));
    if (m_session.playback().isPlaying()) return;  // pins are hidden during playback
    if (looks.groups) over.groups(*looks.groups);
    over.paths(m_viewport.hovered());
    over.pins(m_viewport.hovered(), m_viewport.named());
}

// --- The map of a solid and marks on its surface ---

/// Adds paint; other places keep their own colours.
void SolidCanvas::addPaint(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    const auto plain = plainValue(m_session.motion(), measure);
    const double plainPlace = plain ? positionIn(range, measure, *plain) : 0;
    const auto values = cellValues(frame, measure);
    std::vector<QRgb> colours;
    for (const double value : values) {
        const double place = positionIn(range, measure, value);
        const QRgb colour = colourAt(measure, place);
        colours.push_back(withAlpha(m_viewport.isDimmed() ? dimmed(colour) : colour,
                                    plain ? paintedPart(place, plainPlace) : 1));
    }
    picture.paint = paintOf(frame, colours, sharpCells(frame, values));
    const bool isColoured = picture.materials && hasOwnColours(*picture.skin);
    picture.paint.opacity = isColoured ? paintOpacity(opacity) : 1;
}

void SolidCanvas::addMap(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    if (isPainted(measure)) return addPaint(picture, frame);
    const auto own = [&](QRgb map) { return m_viewport.isDimmed() ? dimmed(map) : map; };
    const auto values = cellValues(frame, measure, fieldOf(m_session.motion(), measure));
    picture.section.reset();
    picture.materials = picture.materials && hasOwnColours(*picture.skin);
    picture.cellColours.clear();
    for (const double value : values)
        picture.cellColours.push_back(own(colourAt(measure, positionIn(range, measure, value))));
    if (!smooth) return;
    const auto places = smoothPlaces(frame, values, measure, range);
    picture.places = Points<3>::Zero(3, frame.pose.cols());
    picture.places.row(0) =
        Eigen::Map<const Eigen::RowVectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
    picture.ramp = colourRamp(measure);
    std::ranges::transform(picture.ramp, picture.ramp.begin(), own);
}

void SolidCanvas::showGlyphs(const PosedFrame<3>& frame) {
    const Looks& looks = m_viewport.looks();
    std::vector<DrawVertex> triangles, ellipsoids;
    if (looks.arrows && !looks.hidden)
        triangles = velocityArrows(frame, m_session.motion().velocity(), solid().surface(),
                                   isOnDark() ? kArrowOnDark : kArrowColour);
    if (looks.marks && !looks.hidden) {
        ellipsoids = stiffnessEllipsoids(frame, solid().surface(), kGlyphColour);
        triangles.insert(triangles.end(), ellipsoids.begin(), ellipsoids.end());
    }
    if (m_faults && m_viewport.showsMap() && !looks.rest && !looks.standIn) {
        const auto faulty = faultMarks(frame, *m_faults, [this](const Vec<3>& p) { return isCutOff(p); });
        for (auto* list : {&triangles, &ellipsoids}) list->insert(list->end(), faulty.begin(), faulty.end());
    }
    setGlyphs(std::move(triangles), std::move(ellipsoids));
}

void SolidCanvas::setFaults(const std::shared_ptr<const PoseFaults<3>>& faults) {
    if (std::exchange(m_faults, faults) != faults && m_viewport.looks().map) refresh();
}

void SolidCanvas::showWorst() {
    const auto frame = m_session.motion().frame<3>();
    const int cell = frame ? worstOf(*frame->distortion, m_viewport.looks().colours.measure).cell : -1;
    if (cell >= 0) showPlace(frame->centreOf(cell));
}

void SolidCanvas::showCell(int cell) {
    const auto frame = m_session.motion().frame<3>();
    if (!frame || cell < 0 || cell >= frame->cells) return;
    m_pointedCell = cell;
    m_pointedOf = frame->shape;
    Points<3> around(3, 4);
    for (int k = 0; k < 4; ++k) around.col(k) = frame->pose.col(frame->rest->cells[cell][k]);
    const Vec<3> centre = around.rowwise().mean();
    const double wanted = kNear * frame->diagonal,
                 is = (around.colwise() - centre).colwise().norm().maxCoeff();
    camera().fit(((around.colwise() - centre) * std::max(1.0, wanted / is)).colwise() + centre, size());
    m_fitted = false;
    emit cameraChanged();
}

void SolidCanvas::showPlace(const Vec<3>& at) {
    camera().lookAt(at);
    emit cameraChanged();
}

// --- The interface of a solid's view for tools ---

Ray SolidCanvas::ray(const QPointF& widget) const {
    return camera().ray({widget.x(), widget.y()}, size());
}

QPointF SolidCanvas::onScreen(const Vec<3>& p) const {
    const Vec<3> screen = camera().project(p, size());
    return {screen.x(), screen.y()};
}

std::vector<int> SolidCanvas::verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                            bool visibleOnly) const {
    return showsFrame() ? VolumeView::verticesWhere(inside, visibleOnly) : std::vector<int>();
}

/// Returns whether the frame is shown, rather than a file's surface or an earlier mesh with other cells and
/// vertices.
bool SolidCanvas::showsFrame() const {
    const auto frame = m_session.motion().frame<3>();
    return frame && solid().picture().rest == frame->rest;
}

SolidHit SolidCanvas::pick(const QPointF& widget) const {
    return showsFrame() ? VolumeView::pick(widget) : SolidHit{};
}

std::optional<Touch> SolidCanvas::touch(const QPointF& widget) const {
    const SolidHit hit = pick(widget);
    if (hit.cell < 0) return {};
    Place place = m_session.motion().frame()->placeIn(hit.cell, hit.point);
    // A surface may reach out of the solid that takes it along.
    place.weights = place.weights.cwiseMax(0);
    place.weights /= place.weights.sum();
    return Touch{place, hit.point};
}

void SolidCanvas::showMaterial(const FramePtr& painted, bool lasts) {
    m_preview.set(m_session.motion().frame<3>(), posed<3>(painted), lasts);
    refresh();
}

/// Whole cells reach beyond the plane: points on the drawn surface are not cut off.
bool SolidCanvas::isHidden(const Vec<3>& p) const {
    const Ray sight = ray(onScreen(p));
    const SolidHit hit = solid().hit(sight);
    const double within = 2 * pixelSize(p);
    const double before = hit.cell < 0
                              ? -std::numeric_limits<double>::infinity()
                              : (p - sight.origin).dot(sight.direction) - (hit.point - sight.origin).norm();
    return before > within || (isCutOff(p) && before < -within);
}

/// Asks through its middle and those of its sides.
std::optional<Vec3> SolidCanvas::placeOf(const ShapeFrame&, int cell) const {
    if (!showsFrame()) return {};
    const Points<3>& pose = solid().picture().pose;
    const Cell<3>& corners = solid().picture().rest->cells[cell];
    Vec<3> sum = Vec<3>::Zero();
    for (const int v : corners) sum += pose.col(v);
    std::vector<Vec<3>> middles = {sum / 4};
    for (const int v : corners) middles.push_back((sum - pose.col(v)) / 3);
    for (const Vec<3>& middle : middles) {
        const SolidHit hit = solid().hit(ray(onScreen(middle)));
        if (hit.cell == cell) return hit.point;
    }
    return {};
}

std::vector<VertexMark> SolidCanvas::marksOf(const std::vector<int>& vertices) const {
    const Points<3>& pose = solid().picture().pose;
    // Without a frame of this mesh the picture is a preview.
    const bool isSkin = solid().showsSkin() && static_cast<Eigen::Index>(skinPoints().size()) == pose.cols();
    const bool asks = vertices.size() <= kMostRays;
    std::vector<VertexMark> marks;
    for (const int v : vertices) {
        if (v >= pose.cols()) continue;
        const int point = isSkin ? skinPoints()[static_cast<std::size_t>(v)] : -1;
        const Vec<3> at = point < 0 ? Vec<3>(pose.col(v)) : Vec<3>(solid().skinPose().col(point));
        if (!isCutOff(at) && !isCutOff(pose.col(v))) marks.push_back({at, asks && isHidden(pose.col(v))});
    }
    return marks;
}

/// Cached per skin.
const std::vector<int>& SolidCanvas::skinPoints() const {
    const VolumePicture& picture = solid().picture();
    if (m_marked != picture.skin)
        m_skinPoints = nearestSkinPoints(*picture.skin, picture.rest->points, *picture.facets);
    m_marked = picture.skin;
    return m_skinPoints;
}

}  // namespace wend
