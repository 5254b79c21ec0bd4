// The map of a solid, and what is marked beside its surface.
#include <algorithm>

#include "app/panels/legend.h"
#include "app/panels/smooth_map.h"
#include "app/view/volume/fault_marks.h"
#include "app/view/volume/glyphs.h"
#include "app/view/volume/solid_canvas.h"
#include "core/energy/distortion.h"

namespace wend {

namespace {

const QRgb kArrowColour = qRgb(54, 84, 196), kGlyphColour = qRgb(226, 140, 44);
constexpr double kNear = 0.2;  // of the diagonal: what is seen around a cell

/// From 0 to 1.
Points<3> coloursOfVertices(const SimplicialMesh<3>& rest, const std::vector<QRgb>& ofCells) {
    const auto means = softColours<3>(rest, ofCells);
    Points<3> colours(3, static_cast<Eigen::Index>(means.size()));
    for (std::size_t v = 0; v < means.size(); ++v)
        colours.col(static_cast<Eigen::Index>(v)) = means[v].head<3>() / 255;
    return colours;
}

}  // namespace

void SolidCanvas::addMap(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto own = [this](QRgb colour) { return m_dimmed ? dimmed(colour) : colour; };
    const auto values = cellValues<3>(frame, m_measure, fieldOf<3>(m_session, m_measure));
    picture.section.reset();
    picture.materials = picture.materials && !picture.skin->materials.empty();
    picture.cellColours.clear();
    for (const double value : values)
        picture.cellColours.push_back(own(colourAt(m_measure, positionIn(m_range, m_measure, value))));
    if (isPainted(m_measure))
        picture.places = coloursOfVertices(*frame.rest, picture.cellColours);
    else if (m_smooth) {
        const auto places = smoothPlaces<3>(*frame.rest, values, m_measure, m_range);
        picture.places = Points<3>::Zero(3, frame.pose.cols());
        picture.places.row(0) =
            Eigen::Map<const Eigen::RowVectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
        picture.ramp = colourRamp(m_measure);
        std::ranges::transform(picture.ramp, picture.ramp.begin(), own);
    }
}

void SolidCanvas::showGlyphs(const PosedFrame<3>& frame) {
    std::vector<DrawVertex> triangles, ellipsoids;
    if (m_arrows && !m_hidden)
        triangles = velocityArrows(frame, m_session.velocity<3>(), surface(), kArrowColour);
    if (m_glyphs && !m_hidden) {
        ellipsoids = stiffnessEllipsoids(frame, surface(), kGlyphColour);
        triangles.insert(triangles.end(), ellipsoids.begin(), ellipsoids.end());
    }
    if (m_faults && showsMap() && !m_rest && !m_standIn) {
        const auto faulty = faultMarks(frame, *m_faults, [this](const Vec<3>& p) { return isCutOff(p); });
        for (auto* list : {&triangles, &ellipsoids}) list->insert(list->end(), faulty.begin(), faulty.end());
    }
    setGlyphs(std::move(triangles), std::move(ellipsoids));
}

void SolidCanvas::setFaults(const std::shared_ptr<const PoseFaults<3>>& faults) {
    if (std::exchange(m_faults, faults) != faults && m_map) refresh();
}

void SolidCanvas::wantVelocity() {
    if (m_session.document().dimension() == 3)
        m_session.setFieldWanted(wantedField(m_map, m_measure, m_arrows || m_values));
}

void SolidCanvas::setMapShown(bool shown) {
    m_map = shown, wantVelocity(), refresh();
}
void SolidCanvas::setMap(Measure measure, const MeasureRange& range) {
    m_measure = measure;
    m_range = range;
    wantVelocity();
    if (m_map) refresh();
}

void SolidCanvas::setRangeKeeper(QAction& keep) {
    m_lock = new LegendLock(keep, *this);
    refresh();
}

void SolidCanvas::setMapOpacity(double opacity) {
    m_opacity = opacity;
    if (m_map) refresh();
}

void SolidCanvas::setMapSmooth(bool smooth) {
    m_smooth = smooth;
    if (m_map) refresh();
}

void SolidCanvas::showWorst() {
    const auto frame = m_session.frame<3>();
    const int cell = frame ? worstOf(*frame->distortion, m_measure).cell : -1;
    if (cell < 0) return;
    Vec<3> centre = Vec<3>::Zero();
    for (const int v : frame->rest->cells[cell]) centre += frame->pose.col(v) / 4;
    showPlace(centre);
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
