// The map of a solid, and what is marked beside its surface.
#include <algorithm>
#include <cmath>

#include "app/panels/smooth_map.h"
#include "app/view/volume/fault_marks.h"
#include "app/view/volume/glyphs.h"
#include "app/view/volume/solid_canvas.h"

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

QRgb between(QRgb from, QRgb to, double part) {
    const auto mix = [part](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
    return qRgb(mix(qRed(from), qRed(to)), mix(qGreen(from), qGreen(to)), mix(qBlue(from), qBlue(to)));
}

}  // namespace

/// What is painted has its colour, the rest of the solid its own.
void SolidCanvas::addMap(VolumePicture& picture, const PosedFrame<3>& frame) const {
    const auto& [measure, range, opacity, smooth] = m_viewport.looks().colours;
    const auto plain = plainValue(m_session, measure);
    const double plainPlace = plain ? positionIn(range, measure, *plain) : 0;
    const auto own = [&, plainPlace](QRgb map, double place) {
        const QRgb colour = m_viewport.isDimmed() ? dimmed(map) : map;
        return plain ? between(plainColour(), colour, paintedPart(place, plainPlace)) : colour;
    };
    const auto values = cellValues<3>(frame, measure, fieldOf<3>(m_session, measure));
    picture.section.reset();
    picture.materials = picture.materials && !picture.skin->materials.empty();
    picture.cellColours.clear();
    for (const double value : values) {
        const double place = positionIn(range, measure, value);
        picture.cellColours.push_back(own(colourAt(measure, place), place));
    }
    if (isPainted(measure)) {
        picture.places = coloursOfVertices(*frame.rest, picture.cellColours);
    } else if (smooth) {
        const auto places = smoothPlaces<3>(*frame.rest, values, measure, range);
        picture.places = Points<3>::Zero(3, frame.pose.cols());
        picture.places.row(0) =
            Eigen::Map<const Eigen::RowVectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
        picture.ramp = colourRamp(measure);
        for (std::size_t i = 0; i < picture.ramp.size(); ++i)
            picture.ramp[i] = own(picture.ramp[i], double(i) / double(picture.ramp.size() - 1));
    }
}

void SolidCanvas::showGlyphs(const PosedFrame<3>& frame) {
    const Looks& looks = m_viewport.looks();
    std::vector<DrawVertex> triangles, ellipsoids;
    if (looks.arrows && !looks.hidden)
        triangles = velocityArrows(frame, m_session.velocity<3>(), surface(), kArrowColour);
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
    if (cell >= 0) showPlace(centreOf<3>(*frame, cell));
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
