#include "app/views/volume/solid_look.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/engine/motion/fields.h"
#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/smooth_map.h"
#include "app/views/volume/glyphs.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

namespace {

// The colour of a cut face while no map is shown: a rose that no map uses.
constexpr QRgb kSectionColour = 0xffd6a8b8;
const QRgb kPlain = qRgb(199, 186, 164), kPlainDark = qRgb(176, 164, 146);
const QRgb kArrowColour = qRgb(54, 84, 196), kArrowOnDark = qRgb(92, 126, 255);
const QRgb kGlyphColour = qRgb(226, 140, 44);

QRgb withAlpha(QRgb colour, double alpha) {
    return qRgba(qRed(colour), qGreen(colour), qBlue(colour), static_cast<int>(std::lround(255 * alpha)));
}

/// Returns cell colours, not premultiplied, so that edges stay sharp.
SolidPaint paintOf(const ShapeFrame& frame, const std::vector<QRgb>& ofCells,
                   const std::vector<bool>& sharp) {
    SolidPaint paint;
    const auto means = softColours(frame, ofCells);
    paint.colours = paint.opacities = Points3::Zero(3, static_cast<Eigen::Index>(means.size()));
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

}  // namespace

const ShapeMotion& SolidLook::motion() const {
    return m_viewport.shape().session().motion();
}

bool SolidLook::hasDetail(const PosedFrame<3>& frame) const {
    const auto& skin = frame.built->skin;
    return skin && frame.built->embedding &&
           (frame.built->cage || !m_viewport.shape().session().document().domain().detail.empty() ||
            hasOwnColours(*skin));
}

QRgb SolidLook::plainColour() const {
    const QRgb plain = m_viewport.theme().dark ? kPlainDark : kPlain;
    return m_viewport.isDimmed() ? dimmed(plain) : plain;
}

QColor SolidLook::ground() const {
    const QColor& backdrop = m_viewport.looks().backdrop;
    return backdrop.isValid() ? backdrop : m_viewport.theme().workspace;
}

VolumePicture SolidLook::picture(const PosedFrame<3>& frame) const {
    VolumePicture picture = plainPicture(frame);
    if (m_viewport.showsMap()) addMap(picture, frame);
    return picture;
}

VolumePicture SolidLook::plainPicture(const PosedFrame<3>& frame) const {
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

SurfaceStyle SolidLook::style() const {
    const Looks& looks = m_viewport.looks();
    const bool hasMap = m_viewport.showsMap() && !isPainted(looks.colours.measure);
    SurfaceStyle style;
    style.edges = looks.mesh;
    style.flat = looks.flat;
    style.edgeColour = m_viewport.theme().dark ? QColor(12, 13, 18) : QColor(20, 24, 32);
    style.dimming = m_viewport.isDimmed() ? 0.5 : 0;
    style.mapOpacity = hasMap ? looks.colours.opacity : 0;
    style.rim = hasMap && isOnDark() ? QColor::fromRgba(kRim) : QColor();
    return style;
}

SurfaceStyle SolidLook::plainStyle() const {
    SurfaceStyle style = this->style();
    style.edges = false;
    style.dimming = style.mapOpacity = 0;
    style.rim = QColor();
    return style;
}

// --- Maps and glyphs ---

void SolidLook::addMap(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    if (isPainted(measure)) return addPaint(picture, frame);
    const auto own = [&](QRgb map) { return m_viewport.isDimmed() ? dimmed(map) : map; };
    const auto values = cellValues(frame, measure, fieldOf(motion(), measure));
    picture.section.reset();
    picture.materials = picture.materials && hasOwnColours(*picture.skin);
    picture.cellColours.clear();
    for (const double value : values)
        picture.cellColours.push_back(own(colourAt(measure, positionIn(range, measure, value))));
    if (!smooth) return;
    const auto places = smoothPlaces(frame, values, measure, range);
    picture.places = Points3::Zero(3, frame.pose.cols());
    picture.places.row(0) =
        Eigen::Map<const Eigen::RowVectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
    picture.ramp = colourRamp(measure);
    std::ranges::transform(picture.ramp, picture.ramp.begin(), own);
}

/// Adds paint; other places keep their own colours.
void SolidLook::addPaint(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    const auto plain = plainValue(motion(), measure);
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

std::pair<std::vector<DrawVertex>, std::vector<DrawVertex>> SolidLook::glyphs(const PosedFrame<3>& frame,
                                                                              const DrawnSolid& solid) const {
    const Looks& looks = m_viewport.looks();
    std::vector<DrawVertex> triangles, ellipsoids;
    const Eigen::MatrixXd velocity = looks.arrows && !looks.hidden ? motion().velocity() : Eigen::MatrixXd();
    if (velocity.cols() == frame.pose.cols())
        triangles =
            velocityArrows(frame, velocity, solid.surface(), isOnDark() ? kArrowOnDark : kArrowColour);
    if (looks.marks && !looks.hidden) {
        ellipsoids = stiffnessEllipsoids(frame, solid.surface(), kGlyphColour);
        triangles.insert(triangles.end(), ellipsoids.begin(), ellipsoids.end());
    }
    if (m_faults && m_viewport.showsMap() && !looks.rest && !looks.standIn) {
        const auto faulty = faultMarks(frame, *m_faults, [&](const Vec3& p) { return solid.isCutOff(p); });
        for (auto* list : {&triangles, &ellipsoids}) list->insert(list->end(), faulty.begin(), faulty.end());
    }
    return {std::move(triangles), std::move(ellipsoids)};
}

QImage PlainView::draw(const SolidCanvas& like, const PosedFrame<3>& frame, const QSize& size) {
    if (!m_view) {
        m_view = new VolumeView(like.parentWidget());
        m_view->hide();
    }
    m_view->setStyle(like.solidLook().plainStyle());
    m_view->setPicture(like.solidLook().plainPicture(frame), false);
    m_view->resize(size);
    m_view->camera() = like.camera();
    m_view->fit();
    if (!m_view->obstacle().isEmpty()) m_view->grabFramebuffer();  // the first time: makes its context
    return m_view->picture(size, true);
}

}  // namespace wend
