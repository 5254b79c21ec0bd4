#include "app/panels/distortion_panel.h"

#include <QAction>
#include <QGridLayout>
#include <QLocale>
#include <algorithm>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/engine/shape/shape.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/session/calm_follower.h"
#include "core/energy/distortion.h"

namespace wend {

namespace {

constexpr int kPoseRest = 300;  // milliseconds

const QString kUnknown = QStringLiteral("–");

}  // namespace

PoseWatch::PoseWatch(ShapeMotion& motion, Playback& playback, QObject* parent)
    : QObject(parent), m_motion(motion), m_playback(playback) {
    m_due.setSingleShot(true);
    m_due.setInterval(kPoseRest);
    connect(&m_due, &QTimer::timeout, this, &PoseWatch::look);
    connectEach(this, &PoseWatch::takeFrame, &motion, &ShapeMotion::frameChanged, &motion,
                &ShapeMotion::busyChanged, &playback, &Playback::playingChanged);
    takeFrame();
}

void PoseWatch::takeFrame() {
    if (m_motion.frame() == m_seen) return;
    m_due.start();
    m_seen.reset();
    if (!m_flat && !m_solid) return;
    m_flat.reset();
    m_solid.reset();
    emit changed();
}

void PoseWatch::look() {
    const FramePtr& frame = m_motion.frame();
    const bool moves = m_motion.isDragging() || m_playback.isPlaying() || m_motion.isBusy();
    if (!frame || frame == m_seen || frame->live || moves || m_work.isRunning()) return;
    frame->dimension == 2 ? lookAt<2>(posed<2>(frame)) : lookAt<3>(posed<3>(frame));
}

template <int Dim>
void PoseWatch::lookAt(const PosedPtr<Dim>& frame) {
    using Found = std::shared_ptr<const PoseFaults<Dim>>;
    const auto find = [frame]() -> Found {
        return std::make_shared<const PoseFaults<Dim>>(faultsOf<Dim>(*frame->built, frame->pose));
    };
    m_work = inBackground(this, find, [this, frame](const Found& found) {
        if (m_motion.frame() != frame) return m_due.start();  // it has moved on
        m_seen = frame;
        if constexpr (Dim == 2)
            m_flat = found;
        else
            m_solid = found;
        emit changed();
    });
}

DistortionPanel::DistortionPanel(ShapeMotion& motion, Playback& playback, QWidget* parent)
    : QWidget(parent),
      m_motion(motion),
      m_measure(new QComboBox(this)),
      m_legend(new Legend(this)),
      m_opacity(new JumpSlider(this)),
      m_keep(new QAction(tr("Lock the scale"), this)),
      m_lock(new QToolButton(this)),
      m_details(new QWidget(this)),
      m_angle(new QLabel(m_details)),
      m_area(new QLabel(m_details)),
      m_length(new QLabel(m_details)),
      m_worst(new QLabel(m_details)),
      m_pinError(new QLabel(m_details)),
      m_time(new QLabel(m_details)),
      m_find(chip(this, "", tr("Go to the worst place"),
                  tr("Brings the most distorted triangle into view; it is ringed in the overlay."),
                  &DistortionPanel::showWorst)),
      m_watch(motion, playback) {
    m_worst->setObjectName(QStringLiteral("worstPlace"));
    makeControls();
    makeDetails();
    arrange();
    setDimension(2);
    new CalmFollower(
        m_motion, this, [this] { takeFrame(); }, &m_motion, &ShapeMotion::frameChanged);
    connect(m_measure, &QComboBox::currentIndexChanged, this, [this] {
        const QSignalBlocker quiet(m_logarithmic);
        m_logarithmic->setChecked(false);
        m_keep->setChecked(false);
        takeFrame();
        emit mapChanged();
    });
    connect(m_measure, &QComboBox::activated, this, &DistortionPanel::mapChosen);
    connect(m_keep, &QAction::toggled, this, &DistortionPanel::takeFrame);
    connect(m_opacity, &QSlider::valueChanged, this, [this](int percent) {
        preferences::mapOpacity.set(percent);
        emit opacityChanged(opacity());
    });
    connect(&m_watch, &PoseWatch::changed, this, [this] {
        showFaults();
        emit faultsChanged();
    });
    showFaults();
    takeFrame();
}

void DistortionPanel::makeControls() {
    fitToEntries(m_measure);
    m_opacity->setObjectName(QStringLiteral("mapOpacity"));
    m_opacity->setFixedWidth(kControlWidth);
    m_opacity->setRange(5, 100);
    m_opacity->setPageStep(10);
    m_opacity->setValue(preferences::mapOpacity.value());
    describe(m_opacity, tr("Opacity"),
             tr("How much the overlay covers the picture, or the colours of the solid, below it."));
    m_keep->setCheckable(true);
    m_keep->setStatusTip(tr("Keeps the range of the colours, to compare different shapes and energies."));
    m_lock->setDefaultAction(m_keep);
    m_lock->setToolButtonStyle(Qt::ToolButtonTextOnly);
    describe(m_lock, m_keep->text(), m_keep->statusTip());
    m_keep->setToolTip(m_lock->toolTip());
    m_lock->setProperty("role", "chip");
}

void DistortionPanel::makeDetails() {
    m_smooth = checkBox(this, "mapSmooth", tr("Smooth colo&urs"),
                        tr("Blends the colours of the overlay from cell to cell. If off, each cell has the "
                           "one colour of its value."),
                        [this](bool on) {
                            preferences::mapSmooth.set(on);
                            emit smoothChanged(on);
                        });
    m_smooth->setChecked(preferences::mapSmooth.value());
    const Numbers numbers = {-1e9, 1e9, 4, 0.01};
    m_low = numberBox(
        this, "mapLow", tr("Colours from"),
        tr("The value of the first colour. A typed value locks the scale; “≤” in the legend says that some "
           "places have less."),
        numbers, &DistortionPanel::chooseRange);
    m_high = numberBox(
        this, "mapHigh", tr("Colours to"),
        tr("The value of the last colour. A typed value locks the scale; “≥” in the legend says that some "
           "places have more."),
        numbers, &DistortionPanel::chooseRange);
    for (ExactBox* box : {m_low, m_high}) {
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(56);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
    m_logarithmic = checkBox(this, "mapLogarithmic", tr("Logarithmic"),
                             tr("Spreads the colours evenly over the orders of magnitude of the values."),
                             [this](bool on) {
                                 m_range.logarithmic = on;
                                 fitLogarithm(shownValues(m_motion, measure()));
                                 takeFrame();
                                 emit mapChanged();
                             });
    m_crossings = chip(this, "crossings", {}, {}, [this] { goOn(m_nextCrossed, m_crossed); });
    m_blown = chip(this, "blownUp", {}, {}, [this] { goOn(m_nextGrown, m_grown); });
}

void DistortionPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 10, 16, 10);
    layout->setSpacing(6);
    layout->addWidget(panelTitle(tr("What changed"), this));
    layout->addLayout(panelRow(tr("Colour &by"), m_measure, this));
    layout->addWidget(m_legend);
    layout->addWidget(m_opacityRow = panelRowIn(tr("O&pacity"), m_opacity, this));
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins(16, 4, 16, 10);
    details->setSpacing(6);
    details->addWidget(m_smooth);
    details->addLayout(rangeRow());
    details->addWidget(m_logarithmic);
    details->addLayout(totals());
    layout->addLayout(sideBySide({m_lock, nullptr}));
    layout->addLayout(sideBySide({m_find, nullptr}));
}

QLayout* DistortionPanel::rangeRow() {
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    auto* label = new QLabel(tr("Colours from, to"), m_details);
    label->setProperty("role", "second");
    rows->addWidget(label);
    rows->addLayout(sideBySide({m_low, m_high}));
    return rows;
}

/// Takes the range that was typed, unless it is empty or the logarithm of its low end does not exist.
void DistortionPanel::chooseRange() {
    const double low = m_low->exact(), high = m_high->exact();
    if (!(low < high) || (m_logarithmic->isChecked() && low <= 0)) return showRange();
    m_range.low = low;
    m_range.high = high;
    m_keep->setChecked(true);
    takeFrame();
    emit mapChanged();
}

/// Raises the low end of a logarithmic range to the smallest value above zero, of at most six orders.
void DistortionPanel::fitLogarithm(const std::vector<double>& values) {
    if (!m_range.logarithmic || m_range.low > 0) return;
    double least = m_range.high;
    for (const double value : values)
        if (value > 0) least = std::min(least, value);
    m_range.low = std::max(least, 1e-6 * m_range.high);
    if (m_range.low >= m_range.high) m_range.low = m_range.high / 10;
}

/// Shows the ends of the range, and which of its settings the measure leaves open.
void DistortionPanel::showRange() {
    m_low->put(m_range.low);
    m_high->put(m_range.high);
    const bool isFixed = measure() == Measure::Phi;
    for (QWidget* box : std::initializer_list<QWidget*>{m_low, m_high})
        allow(box, !isFixed, tr("These colours are those of the four energies."));
    allow(m_logarithmic, leavesScale(measure()), tr("The scale of this measure is fixed."));
}

QLayout* DistortionPanel::totals() {
    auto* totals = new QGridLayout;
    totals->setVerticalSpacing(6);
    int row = 0;
    const auto add = [&](const QString& name, QWidget* value, const QString& help) -> QLabel* {
        auto* label = new QLabel(name, m_details);
        label->setProperty("role", "second");
        value->setToolTip(help);
        label->setToolTip(help);
        value->setAccessibleName(name);
        totals->addWidget(label, row, 0);
        totals->addWidget(value, row++, 1, Qt::AlignRight);
        return label;
    };
    add(tr("Angle error"), m_angle,
        tr("Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept."));
    m_areaName = add(tr("Area error"), m_area, {});
    add(tr("Stretch"), m_length, tr("How far lengths are from those at rest: zero for a rigid motion."));
    add(tr("Worst place"), m_worst, {});
    add(tr("Pin error"), m_pinError, tr("How far the worst pin is from where it should be"));
    add(tr("Computing time"), m_time, tr("How long the shown shape took to compute"));
    m_crossingsName = add({}, m_crossings, {});
    add(tr("Blown up"), m_blown, {});
    return totals;
}

/// Solids have further maps: the speed and the cell size.
void DistortionPanel::setDimension(int dimension) {
    if (dimension == m_dimension) return;
    m_dimension = dimension;
    const QSignalBlocker quiet(m_measure);
    const QVariant before = m_measure->currentData();
    m_measure->clear();
    for (const Measure measure : measuresOf(dimension))
        m_measure->addItem(measureName(measure, dimension), static_cast<int>(measure));
    m_measure->setCurrentIndex(std::max(0, m_measure->findData(before)));  // as far as both have it
    const bool solid = dimension == 3;
    m_areaName->setText(solid ? tr("Volume error") : tr("Area error"));
    const QString help = solid
                             ? tr("Sum over the shape of det F + 1/det F − 2: zero if all volumes are kept.")
                             : tr("Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.");
    for (QLabel* label : {m_areaName, m_area}) label->setToolTip(help);
    m_worst->setToolTip(solid ? tr("The tetrahedron that is farthest from rest in what the overlay shows.")
                              : tr("The triangle that is farthest from rest in what the overlay shows."));
    describeFaults();
    describe(m_measure, tr("Colour by"),
             solid
                 ? tr("What is coloured over the solid: the error of lengths, volumes or angles, how far it "
                      "is from where it was, the material, how fast it moves, or how fine its mesh is.")
                 : tr("What is coloured over the picture: the error of lengths, areas or angles, how far it "
                      "is from where it was, the material, or how fast it moves."));
}

void DistortionPanel::describeFaults() {
    const bool solid = m_dimension == 3;
    m_crossingsName->setText(solid ? tr("Passes through itself") : tr("Crosses itself"));
    describe(
        m_crossings, m_crossingsName->text(),
        solid
            ? tr("In how many places the surface passes through itself once the pose is at rest, each "
                 "with its pairs of triangles. A click goes to the next one; the overlay marks them in red.")
            : tr("Where the outline crosses itself once the pose is at rest: one part lies over "
                 "another. A click goes to the next one; the overlay marks them in red."));
    describe(m_blown, tr("Blown up"),
             solid ? tr("Tetrahedra with more than ten times their volume, or less than a tenth of it. A "
                        "click goes to the next place; the overlay marks them in red.")
                   : tr("Triangles with more than ten times their area, or less than a tenth of it. A click "
                        "goes to the next place; the overlay marks them in red."));
}

/// Shows unknown counts while a pose moves.
void DistortionPanel::showFaults() {
    m_crossed.clear();
    m_grown.clear();
    m_nextCrossed = m_nextGrown = 0;
    for (QToolButton* button : {m_crossings, m_blown}) button->setText(kUnknown);
    showFaults<2>();
    showFaults<3>();
    const QString moves = tr("This is checked once the pose is at rest."),
                  none = tr("There is no such place.");
    allow(m_crossings, !m_crossed.empty(), m_crossings->text() == kUnknown ? moves : none);
    allow(m_blown, !m_grown.empty(), m_blown->text() == kUnknown ? moves : none);
}

template <int Dim>
void DistortionPanel::showFaults() {
    const auto faults = m_watch.faults<Dim>();
    if (!faults) return;
    const auto takePlaces = [](const std::vector<PosePlace<Dim>>& from, std::vector<Vec3>& to) {
        for (const PosePlace<Dim>& place : from)
            to.push_back(Vec3::Zero()), to.back().template head<Dim>() = place.at;
    };
    takePlaces(faults->crossings, m_crossed);
    takePlaces(faults->blown, m_grown);
    const int places = static_cast<int>(m_crossed.size()), cells = faults->cells();
    m_crossings->setText(places == 0   ? tr("nowhere")
                         : places == 1 ? tr("1 place")
                                       : tr("%n places", nullptr, places));
    m_blown->setText(cells == 0 ? tr("nowhere") : cells == 1 ? tr("1 cell") : tr("%n cells", nullptr, cells));
}

void DistortionPanel::goOn(std::size_t& next, const std::vector<Vec3>& places) {
    if (places.empty()) return;
    emit placeWanted(places[next % places.size()]);
    next = (next + 1) % places.size();
}

double DistortionPanel::opacity() const {
    return m_opacity->value() / 100.0;
}

bool DistortionPanel::isSmooth() const {
    return m_smooth->isChecked();
}

Measure DistortionPanel::measure() const {
    return static_cast<Measure>(m_measure->currentData().toInt());
}

/// Ignores a measure that this dimension lacks.
void DistortionPanel::setMeasure(Measure measure) {
    const int index = m_measure->findData(static_cast<int>(measure));
    if (index >= 0) m_measure->setCurrentIndex(index);
}

/// Returns whether a map covers something: a picture, or the materials of a solid's surface.
bool DistortionPanel::hasPicture(const ShapeFrame& frame) {
    if (frame.dimension == 2) return true;
    const auto& skin = static_cast<const PosedFrame<3>&>(frame).built->skin;
    return skin && (!skin->materials.empty() || !skin->colours.empty());
}

void DistortionPanel::takeFrame() {
    const FramePtr& frame = m_motion.frame();
    setEnabled(frame != nullptr);
    m_details->setEnabled(frame != nullptr);
    if (!frame) return;
    setDimension(frame->dimension);
    m_opacityRow->setVisible(hasPicture(*frame));
    showTotals(*frame);
    const std::vector<double> values = shownValues(m_motion, measure());
    if (!m_keep->isChecked()) {
        m_range = rangeOf(values, measure(), m_dimension);
        m_range.logarithmic = m_logarithmic->isChecked() && leavesScale(measure());
        fitLogarithm(values);
    }
    findBeyond(values, m_range);
    if (!m_keep->isChecked()) emit mapChanged();
    m_legend->set(measure(), m_range, m_dimension, values, restValues(m_motion, measure()));
    showRange();
}

void DistortionPanel::showTotals(const ShapeFrame& frame) {
    const Distortion& distortion = *frame.distortion;
    const QLocale locale;
    const QString about = frame.live || m_motion.isStale() ? QStringLiteral("≈ ") : QString();
    const auto text = [&](double value) { return about + locale.toString(value, 'f', 4); };
    m_angle->setText(text(distortion.totalAngle));
    m_area->setText(text(distortion.totalVolume));
    m_length->setText(text(distortion.totalMetric));
    allow(m_find, worstOf(distortion, measure()).cell >= 0,
          tr("No place is farther from rest than another."));
    m_worst->setText(about + worstText(distortion, measure(), m_dimension));
    const QString error = locale.toString(frame.pinError, 'f', 2);
    m_pinError->setText(m_motion.document().picture() ? tr("%1 px").arg(error) : error);
    m_time->setText(tr("%1 ms").arg(locale.toString(frame.milliseconds, 'f', 0)));
}

}  // namespace wend
