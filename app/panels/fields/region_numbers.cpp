#include "app/panels/fields/region_numbers.h"

#include <algorithm>
#include <cmath>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"

namespace wend {

namespace {

enum Kind { BallKind, BoxKind, HalfKind };
constexpr int kDirectionDigits = 6;

Vec3 valuesOf(const std::array<ExactBox*, 3>& boxes) {
    return {boxes[0]->exact(), boxes[1]->exact(), boxes[2]->exact()};
}

void put(const std::array<ExactBox*, 3>& boxes, const Vec3& values) {
    for (int k = 0; k < 3; ++k) boxes[k]->put(values[k]);
}

/// Returns the middle and the reach of any of the three.
std::pair<Vec3, double> extentOf(const Region<3>& region, double fallback) {
    if (const auto* ball = std::get_if<Ball<3>>(&region)) return {ball->centre, ball->radius};
    if (const auto* box = std::get_if<Box<3>>(&region))
        return {(box->min + box->max) / 2, (box->max - box->min).norm() / (2 * std::sqrt(3.0))};
    if (const auto* half = std::get_if<HalfSpace<3>>(&region)) return {half->point, fallback};
    return {Vec3::Zero(), fallback};
}

}  // namespace

int digitsFor(double diagonal) {
    return diagonal > 0 ? std::clamp(4 - static_cast<int>(std::floor(std::log10(diagonal))), 1, 12) : 4;
}

RegionNumbers::RegionNumbers(Radius radius, QWidget* parent)
    : QWidget(parent),
      m_kind(choiceBox(this, "", tr("Kind of region"),
                       tr("What the region is; another kind keeps its place."),
                       {tr("Ball"), tr("Box"), tr("Half-space")}, &RegionNumbers::chooseKind)),
      m_firstName(secondLabel({}, this)),
      m_secondName(secondLabel({}, this)),
      m_hasRadius(radius == Radius::Here) {
    makeControls();
    arrange();
}

void RegionNumbers::makeControls() {
    fitToEntries(m_kind);
    const auto tell = [this] { emit changed(numbers()); };
    for (ThreeBoxes* boxes : {&m_first, &m_second}) {
        *boxes = coordinateBoxes(1e9, 4, tr("Numbers of the region"),
                                 tr("As x, y and z, in the coordinates of the rest shape."), this);
        whenChanged(*boxes, this, tell);
    }
    m_radius = numberBox(this, "", tr("Radius"), tr("The radius of the ball."), {1e-9, 1e9, 4}, tell);
}

void RegionNumbers::arrange() {
    auto* layout = bareColumn(this, 10);
    layout->addLayout(panelRow(tr("&Region"), m_kind, this));
    for (const auto& [name, boxes] : {std::pair{m_firstName, m_first}, {m_secondName, m_second}}) {
        layout->addWidget(name);
        layout->addLayout(sideBySide({boxes[0], boxes[1], boxes[2]}));
    }
    layout->addWidget(m_radiusRow = panelRowIn(tr("Ra&dius"), m_radius, this));
}

Region<3> RegionNumbers::numbers() const {
    const Vec3 a = valuesOf(m_first), b = valuesOf(m_second);
    if (m_kind->currentIndex() == BallKind) return Ball<3>{a, m_radius->exact()};
    if (m_kind->currentIndex() == BoxKind) return Box<3>{a.cwiseMin(b), a.cwiseMax(b)};
    return HalfSpace<3>{a, b};
}

/// Changes the kind of region at the same place.
void RegionNumbers::chooseKind(int kind) {
    const auto [centre, reach] = extentOf(m_region, 0.1 * m_diagonal);
    Region<3> next = Ball<3>{centre, reach};
    if (kind == BoxKind) next = Box<3>{centre.array() - reach, centre.array() + reach};
    if (kind == HalfKind) next = HalfSpace<3>{centre, Vec3::UnitX()};
    emit changed(next);
}

void RegionNumbers::showRegion(const Region<3>& region, double diagonal) {
    m_region = region;
    m_diagonal = diagonal;
    const QSignalBlocker quiet(m_kind);
    const int kind = std::holds_alternative<Ball<3>>(region)  ? BallKind
                     : std::holds_alternative<Box<3>>(region) ? BoxKind
                                                              : HalfKind;
    m_kind->setCurrentIndex(kind);
    m_firstName->setText(kind == BallKind  ? tr("centre")
                         : kind == BoxKind ? tr("from")
                                           : tr("point of the plane"));
    m_secondName->setText(kind == BoxKind ? tr("to") : tr("direction into it"));
    m_secondName->setVisible(kind != BallKind);
    for (ExactBox* box : m_second) box->setVisible(kind != BallKind);
    m_radiusRow->setVisible(m_hasRadius && kind == BallKind);
    showDigits(kind == HalfKind);
    if (const auto* ball = std::get_if<Ball<3>>(&region)) {
        put(m_first, ball->centre);
        m_radius->put(ball->radius);
    } else if (const auto* box = std::get_if<Box<3>>(&region)) {
        put(m_first, box->min);
        put(m_second, box->max);
    } else if (const auto* half = std::get_if<HalfSpace<3>>(&region)) {
        put(m_first, half->point);
        put(m_second, half->normal);
    }
}

/// Decimals depend on the size of the shape; directions have no length.
void RegionNumbers::showDigits(bool direction) {
    const int digits = digitsFor(m_diagonal);
    for (ExactBox* box : m_first) box->showDigits(digits);
    for (ExactBox* box : m_second) box->showDigits(direction ? kDirectionDigits : digits);
    m_radius->showDigits(digits);
    const QSignalBlocker quiet(m_radius);
    m_radius->setMinimum(std::pow(0.1, digits));
}

}  // namespace wend
