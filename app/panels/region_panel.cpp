#include "app/panels/region_panel.h"

#include <QComboBox>
#include <algorithm>
#include <cmath>

#include "app/document/handle_edits.h"
#include "app/panels/exact_box.h"
#include "app/panels/panel_parts.h"
#include "app/session/solid_places.h"

namespace wend {

namespace {

enum Kind { BallKind, BoxKind, HalfKind };
constexpr int kDirectionDigits = 6;

Vec<3> valuesOf(const std::array<ExactBox*, 3>& boxes) {
    return {boxes[0]->exact(), boxes[1]->exact(), boxes[2]->exact()};
}

void put(const std::array<ExactBox*, 3>& boxes, const Vec<3>& values) {
    for (int k = 0; k < 3; ++k) boxes[k]->put(values[k]);
}

/// Behind the point, so that lengths are shown to a ten-thousandth of the shape at least.
int digitsFor(double diagonal) {
    return diagonal > 0 ? std::clamp(4 - static_cast<int>(std::floor(std::log10(diagonal))), 1, 12) : 4;
}

/// The middle and the reach of any of the three.
std::pair<Vec<3>, double> extentOf(const Region<3>& region, double fallback) {
    if (const auto* ball = std::get_if<Ball<3>>(&region)) return {ball->centre, ball->radius};
    if (const auto* box = std::get_if<Box<3>>(&region))
        return {(box->min + box->max) / 2, (box->max - box->min).norm() / (2 * std::sqrt(3.0))};
    if (const auto* half = std::get_if<HalfSpace<3>>(&region)) return {half->point, fallback};
    return {Vec<3>::Zero(), fallback};
}

}  // namespace

RegionPanel::RegionPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_kind(new QComboBox(this)),
      m_firstName(secondLabel({}, this)),
      m_secondName(secondLabel({}, this)),
      m_count(secondLabel({}, this)),
      m_radiusRow(new QWidget(this)),
      m_radius(new ExactBox(this)) {
    makeControls();
    arrange();
    connect(m_kind, &QComboBox::activated, this, &RegionPanel::chooseKind);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, [this] { apply(numbers()); });
    for (ExactBox* box : {m_first[0], m_first[1], m_first[2], m_second[0], m_second[1], m_second[2]})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] { apply(numbers()); });
    connect(&m_session, &ShapeSession::pinsChanged, this, &RegionPanel::showHandle);
    connect(&m_session, &ShapeSession::frameChanged, this, &RegionPanel::takeFrame);
    showHandle();
}

RegionPanel::Numbers RegionPanel::makeNumbers() {
    Numbers boxes;
    for (ExactBox*& box : boxes) {
        box = new ExactBox(this);
        box->setRange(-1e9, 1e9);
        box->setDecimals(4);
        box->setKeyboardTracking(false);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(56);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        describe(box, tr("Numbers of the region"),
                 tr("As x, y and z, in the coordinates of the rest shape."));
    }
    return boxes;
}

void RegionPanel::makeControls() {
    m_kind->addItems({tr("Ball"), tr("Box"), tr("Half-space")});
    m_kind->setFixedWidth(116);
    describe(m_kind, tr("Kind of region"), tr("What the region is; another kind keeps its place."));
    m_first = makeNumbers();
    m_second = makeNumbers();
    m_radius->setRange(1e-9, 1e9);
    m_radius->setDecimals(4);
    m_radius->setKeyboardTracking(false);
    m_radius->setFixedWidth(116);
    describe(m_radius, tr("Radius"), tr("The radius of the ball."));
    m_count->setObjectName(QStringLiteral("regionCount"));
}

void RegionPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Region"), this));
    layout->addLayout(panelRow(tr("&Region"), m_kind, this));
    for (const auto& [name, boxes] : {std::pair{m_firstName, m_first}, {m_secondName, m_second}}) {
        layout->addWidget(name);
        auto* row = new QHBoxLayout;
        for (ExactBox* box : boxes) row->addWidget(box);
        layout->addLayout(row);
    }
    auto* radius = panelRow(tr("Ra&dius"), m_radius, m_radiusRow);
    radius->setContentsMargins(0, 0, 0, 0);
    m_radiusRow->setLayout(radius);
    layout->addWidget(m_radiusRow);
    layout->addWidget(m_count);
}

const Region<3>* RegionPanel::region() const {
    const auto& selected = m_session.selection().handles();
    if (m_session.document().dimension() != 3 || selected.size() != 1) return nullptr;
    const auto& handles = m_session.document().design<3>().handles;
    if (selected.front() >= static_cast<int>(handles.size())) return nullptr;
    const auto* region = std::get_if<Region<3>>(&handles[selected.front()].at);
    return region && !std::holds_alternative<Blend<3>>(*region) ? region : nullptr;
}

Region<3> RegionPanel::numbers() const {
    const Vec<3> a = valuesOf(m_first), b = valuesOf(m_second);
    if (m_kind->currentIndex() == BallKind) return Ball<3>{a, m_radius->exact()};
    if (m_kind->currentIndex() == BoxKind) return Box<3>{a.cwiseMin(b), a.cwiseMax(b)};
    return HalfSpace<3>{a, b};
}

void RegionPanel::chooseKind(int kind) {
    if (!region() || !m_session.frame()) return;
    const auto [centre, reach] = extentOf(*region(), 0.1 * m_session.frame()->diagonal);
    Region<3> next = Ball<3>{centre, reach};
    if (kind == BoxKind) next = Box<3>{centre.array() - reach, centre.array() + reach};
    if (kind == HalfKind) next = HalfSpace<3>{centre, Vec<3>::UnitX()};
    apply(next);
}

/// One undo step for numbers that follow each other. What holds nothing is not taken.
void RegionPanel::apply(const Region<3>& next) {
    const auto frame = m_session.frame<3>();
    if (!region() || !frame || next == *region()) return;
    if (verticesIn(next, *frame->rest).empty()) {
        m_count->setText(tr("There is no vertex in this region: nothing was changed."));
        return;
    }
    const int handle = m_session.selection().handles().front();
    m_session.document().change(tr("Change region"),
                                withHandlePlace<3>(*m_session.document().project(), handle, next),
                                QStringLiteral("handle region %1").arg(handle));
}

void RegionPanel::showNumbers(const Region<3>& region) {
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
    m_radiusRow->setVisible(kind == BallKind);
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

/// As the shape is large; a direction has no length.
void RegionPanel::showDigits(bool direction) {
    const int digits = digitsFor(m_session.frame() ? m_session.frame()->diagonal : 0);
    for (ExactBox* box : m_first) box->showDigits(digits);
    for (ExactBox* box : m_second) box->showDigits(direction ? kDirectionDigits : digits);
    m_radius->showDigits(digits);
    const QSignalBlocker quiet(m_radius);
    m_radius->setMinimum(std::pow(0.1, digits));
}

/// Poses change nothing here.
void RegionPanel::takeFrame() {
    const auto frame = m_session.frame<3>();
    if (!frame || frame->shape != m_mesh || isHidden()) showHandle();
}

void RegionPanel::showHandle() {
    const Region<3>* now = region();
    const auto frame = m_session.frame<3>();
    m_mesh = frame ? frame->shape : nullptr;
    setVisible(now && frame);
    if (!now || !frame) return;
    showNumbers(*now);
    m_count->setText(tr("%n vertices", nullptr, static_cast<int>(verticesIn(*now, *frame->rest).size())));
}

}  // namespace wend
