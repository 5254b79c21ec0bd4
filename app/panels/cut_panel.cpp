#include "app/panels/cut_panel.h"

#include <Eigen/Geometry>
#include <cmath>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/panel_parts.h"

namespace wend {

namespace {

constexpr int kHeightSteps = 1000;

}  // namespace

CutPanel::CutPanel(QWidget* parent)
    : QWidget(parent),
      m_kind(choiceBox(this, "", {}, {}, {tr("Not cut"), tr("Whole cells"), tr("Exact")},
                       &CutPanel::kindChosen)),
      m_slider(new JumpSlider(this)),
      m_place(numberBox(this, "", tr("Distance of the cut"),
                        tr("How far the plane is from the origin, along its normal."), {-1e9, 1e9, 4},
                        &CutPanel::chooseNumbers)),
      m_numbers(new QWidget(this)) {
    makeControls();
    arrange();
    showNothing();
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        CutPlane plane = m_plane;
        const double height = minimum() + (maximum() - minimum()) * value / kHeightSteps;
        plane.point += (height - plane.normal.dot(plane.point)) * plane.normal;
        emit planeChosen(plane);
    });
    whenChanged(m_normal, this, &CutPanel::chooseNumbers);
}

void CutPanel::makeControls() {
    fitToEntries(m_kind, 150);
    const std::array<QString, 4> names = {tr("X"), tr("Y"), tr("Z"), tr("Flip")};
    for (int k = 0; k < 4; ++k) {
        m_ways[k] = chip(
            this, "", names[k],
            k < 3 ? tr("Turns the plane so that it is perpendicular to this axis.")
                  : tr("Cuts away the other side of the plane."),
            [this, k] { chooseNormal(k < 3 ? Vec3(Vec3::Unit(k)) : Vec3(-m_plane.normal)); },
            k < 3 ? tr("Cut across %1").arg(names[k]) : tr("Other side"));
    }
    m_slider->setRange(0, kHeightSteps);
    describe(m_slider, tr("Place of the cut"), tr("Moves the plane through the solid."));
    m_normal = coordinateBoxes(1, 3, tr("Normal of the cut"),
                               tr("The direction that the plane faces, as x, y and z."), this);
    for (ExactBox* box : m_normal) box->setSingleStep(0.05);
}

void CutPanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Cut"), this));
    layout->addLayout(panelRow(tr("&Look inside"), m_kind, this));
    auto* inner = bareColumn(m_numbers, 10);
    inner->addLayout(sideBySide({m_ways[0], m_ways[1], m_ways[2], m_ways[3], nullptr}));
    inner->addWidget(m_slider);
    inner->addLayout(sideBySide({m_normal[0], m_normal[1], m_normal[2]}));
    inner->addLayout(panelRow(tr("&Distance"), m_place, m_numbers));
    layout->addWidget(m_numbers);
}

double CutPanel::minimum() const {
    return m_plane.normal.cwiseProduct(m_low).cwiseMin(m_plane.normal.cwiseProduct(m_high)).sum();
}

double CutPanel::maximum() const {
    return m_plane.normal.cwiseProduct(m_low).cwiseMax(m_plane.normal.cwiseProduct(m_high)).sum();
}

void CutPanel::chooseNormal(const Vec3& normal) {
    CutPlane plane = m_plane;
    plane.normal = normal;
    emit planeChosen(plane);
}

void CutPanel::chooseNumbers() {
    CutPlane plane;
    const Vec3 normal(m_normal[0]->exact(), m_normal[1]->exact(), m_normal[2]->exact());
    if (normal.norm() < 1e-3) return;
    plane.normal = normal.normalized();
    plane.point = m_plane.point + (m_place->exact() - plane.normal.dot(m_plane.point)) * plane.normal;
    emit planeChosen(plane);
}

void CutPanel::showNothing() {
    m_kind->setCurrentIndex(0);
    m_kind->setEnabled(false);
    describe(m_kind, tr("Cut"), tr("There is no solid to cut yet."));
    m_numbers->hide();
}

void CutPanel::show(int kind, const CutPlane& plane, const Vec3& low, const Vec3& high) {
    m_plane = plane;
    m_low = low;
    m_high = high;
    if (!m_kind->isEnabled())
        describe(m_kind, tr("Cut"), tr("Looks inside: by whole tetrahedra, or along the exact plane."));
    m_kind->setEnabled(true);
    m_kind->setCurrentIndex(kind);
    m_numbers->setVisible(kind != 0);
    for (int k = 0; k < 3; ++k) m_normal[k]->put(plane.normal[k]);
    const double diagonal = (high - low).norm(), height = plane.normal.dot(plane.point);
    if (!m_place->hasFocus())  // would overwrite what is being typed
        m_place->setSingleStep(diagonal > 0 ? diagonal / 100 : 0.01);
    m_place->put(height);
    const QSignalBlocker quiet(m_slider);
    const double span = maximum() - minimum();
    if (!m_slider->isSliderDown() && span > 0)
        m_slider->setValue(static_cast<int>(std::lround(kHeightSteps * (height - minimum()) / span)));
}

}  // namespace wend
