// The map of a solid and marks on its surface.
#include <algorithm>
#include <cmath>

#include "app/style/smooth_map.h"
#include "app/views/volume/fault_marks.h"
#include "app/views/volume/glyphs.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

namespace {

const QRgb kArrowColour = qRgb(54, 84, 196), kArrowOnDark = qRgb(92, 126, 255);
const QRgb kGlyphColour = qRgb(226, 140, 44);
constexpr double kNear = 0.2;  // fraction of the diagonal shown around a cell

QRgb withAlpha(QRgb colour, double alpha) {
    return qRgba(qRed(colour), qGreen(colour), qBlue(colour), static_cast<int>(std::lround(255 * alpha)));
}

/// Returns cell colours, not premultiplied, so that edges stay sharp.
SolidPaint paintOf(const SimplicialMesh<3>& rest, const std::vector<QRgb>& ofCells,
                   const std::vector<bool>& sharp) {
    SolidPaint paint;
    const auto means = softColours<3>(rest, ofCells);
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

}  // namespace

/// Adds paint; other places keep their own colours.
void SolidCanvas::addPaint(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    const auto plain = plainValue(m_session, measure);
    const double plainPlace = plain ? positionIn(range, measure, *plain) : 0;
    const auto values = cellValues<3>(frame, measure, {});
    std::vector<QRgb> colours;
    for (const double value : values) {
        const double place = positionIn(range, measure, value);
        const QRgb colour = colourAt(measure, place);
        colours.push_back(withAlpha(m_viewport.isDimmed() ? dimmed(colour) : colour,
                                    plain ? paintedPart(place, plainPlace) : 1));
    }
    picture.paint = paintOf(*frame.rest, colours, sharpCells<3>(*frame.rest, values));
    const bool isColoured = picture.materials && hasOwnColours(*picture.skin);
    picture.paint.opacity = isColoured ? paintOpacity(opacity) : 1;
}

void SolidCanvas::addMap(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    if (isPainted(measure)) return addPaint(picture, frame);
    const auto own = [&](QRgb map) { return m_viewport.isDimmed() ? dimmed(map) : map; };
    const auto values = cellValues<3>(frame, measure, fieldOf<3>(m_session, measure));
    picture.section.reset();
    picture.materials = picture.materials && hasOwnColours(*picture.skin);
    picture.cellColours.clear();
    for (const double value : values)
        picture.cellColours.push_back(own(colourAt(measure, positionIn(range, measure, value))));
    if (!smooth) return;
    const auto places = smoothPlaces<3>(*frame.rest, values, measure, range);
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
        triangles = velocityArrows(frame, m_session.velocity<3>(), surface(),
                                   isOnDark() ? kArrowOnDark : kArrowColour);
    if (looks.marks && !looks.hidden) {
        ellipsoids = stiffnessEllipsoids(frame, surface(), kGlyphColour);
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
    const auto frame = m_session.frame<3>();
    const int cell = frame ? worstOf(*frame->distortion, m_viewport.looks().colours.measure).cell : -1;
    if (cell >= 0) showPlace(frame->centreOf(cell));
}

void SolidCanvas::showCell(int cell) {
    const auto frame = m_session.frame<3>();
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
    update();
    emit cameraChanged();
}

void SolidCanvas::showPlace(const Vec<3>& at) {
    camera().lookAt(at);
    update();
    emit cameraChanged();
}

}  // namespace wend
