#include "app/style/colour_map.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/engine/motion/fields.h"
#include "app/project/design.h"
#include "app/style/colours.h"
#include "core/energy/distortion.h"

namespace wend {

namespace {

using Stops = std::array<std::array<int, 3>, 6>;

// Lightness falls evenly (CIE L* 95, 78, 60, 42, 25, 8): small values are light.
constexpr Stops kMagnitude = {
    {{253, 248, 208}, {250, 176, 72}, {226, 94, 66}, {160, 44, 100}, {86, 22, 112}, {22, 10, 52}}};
// The colours run from cream to brown through the colour of stiffness; lightness falls evenly.
constexpr Stops kStiff = {
    {{252, 240, 222}, {245, 205, 160}, {230, 160, 98}, {205, 112, 42}, {150, 70, 16}, {88, 36, 4}}};
// Blue and orange of equal lightness on both sides of a light middle.
constexpr Stops kDiverging = {
    {{20, 68, 140}, {84, 144, 205}, {205, 223, 238}, {245, 224, 200}, {230, 140, 60}, {150, 66, 8}}};

QRgb between(const Stops& stops, double position) {
    const double x = std::clamp(position, 0.0, 1.0) * (stops.size() - 1);
    const int i = std::min(static_cast<int>(x), static_cast<int>(stops.size()) - 2);
    const auto mix = [&](int k) {
        return static_cast<int>(std::lround(stops[i][k] + (x - i) * (stops[i + 1][k] - stops[i][k])));
    };
    return qRgb(mix(0), mix(1), mix(2));
}

/// Mapping of values to positions: linear from 0; logarithmic from the minimum, about 1, or from 1; φ as on
/// the energy slider.
enum class Scale { Even, Logarithm, Ratio, Times, Energies };

/// The properties of a measure.
struct MeasureRow {
    Measure measure;
    bool flat;  // pictures have it too
    Scale scale;
    double minimum;  // that the range spans
    const char *before, *after;
    std::vector<double> Distortion::*ranks;  // the values that rank cells; none: length
    const char* name;
    const char* worst = nullptr;      // text of the worst value; none: that of length
    const char* solidName = nullptr;  // none: as in the plane
    const char* solidWorst = nullptr;
};

constexpr double kNothing = 1e-9;          // below: distances and speeds count as zero
constexpr double kLeastDistortion = 1e-6;  // of distortions: less is none

/// The measures in the order of the list.
const MeasureRow kMeasures[] = {
    // measure, flat, scale, least, before, after, ranks, words
    MeasureRow{Measure::Length, true, Scale::Even, 0.01, "", "", &Distortion::metric,
               QT_TRANSLATE_NOOP("Measure", "Stretch"), QT_TRANSLATE_NOOP("Measure", "stretch %1")},
    MeasureRow{Measure::Area, true, Scale::Ratio, 0.02, "×", "", &Distortion::ratio,
               QT_TRANSLATE_NOOP("Measure", "Area"), QT_TRANSLATE_NOOP("Measure", "area ×%1"),
               QT_TRANSLATE_NOOP("Measure", "Volume"), QT_TRANSLATE_NOOP("Measure", "volume ×%1")},
    MeasureRow{Measure::Angle, true, Scale::Even, 0.01, "", "", &Distortion::angle,
               QT_TRANSLATE_NOOP("Measure", "Angle"), QT_TRANSLATE_NOOP("Measure", "angle error %1")},
    MeasureRow{Measure::Shear, true, Scale::Even, 1, "", "°", &Distortion::angle,
               QT_TRANSLATE_NOOP("Measure", "Shear"), QT_TRANSLATE_NOOP("Measure", "angle error %1")},
    MeasureRow{Measure::Way, true, Scale::Even, kNothing, "", "", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Distance from rest")},
    MeasureRow{Measure::Phi, true, Scale::Energies, 0, "", "", nullptr, QT_TRANSLATE_NOOP("Measure", "Keep")},
    MeasureRow{Measure::Stiffness, true, Scale::Times, 100, "×", "", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Stiffness")},
    MeasureRow{Measure::Speed, true, Scale::Even, kNothing, "", "", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Speed")},
    MeasureRow{Measure::Influence, true, Scale::Even, 100, "", " %", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Influence of the pin")},
    MeasureRow{Measure::CellSize, false, Scale::Logarithm, 1.01, "", "", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Cell size")},
    MeasureRow{Measure::ScaledJacobian, true, Scale::Even, kNothing, "", "", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Scaled Jacobian")},
    MeasureRow{Measure::AspectRatio, true, Scale::Even, 1.01, "", "", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Aspect ratio")},
    MeasureRow{Measure::SmallestAngle, true, Scale::Even, 1, "", "°", nullptr,
               QT_TRANSLATE_NOOP("Measure", "Smallest angle"), nullptr,
               QT_TRANSLATE_NOOP("Measure", "Smallest dihedral angle")},
};

const MeasureRow& rowOf(Measure measure) {
    return *std::ranges::find(kMeasures, measure, &MeasureRow::measure);
}

bool isLogarithmic(Scale scale, const MeasureRange& range) {
    const bool isChosen = scale == Scale::Even && range.logarithmic && range.low > 0;
    return isChosen || scale == Scale::Logarithm || scale == Scale::Ratio || scale == Scale::Times;
}

/// Returns the distance of a value from rest.
double sizeOf(double value, Scale scale) {
    return scale == Scale::Ratio ? std::abs(std::log(std::max(value, 1e-300))) : value;
}

}  // namespace

ShapeMotion::FieldKind wantedField(bool map, Measure measure, bool arrows) {
    using Kind = ShapeMotion::FieldKind;
    if (map && measure == Measure::Influence) return Kind::Influence;
    return arrows || (map && measure == Measure::Speed) ? Kind::Velocity : Kind::None;
}

Eigen::MatrixXd fieldOf(const ShapeMotion& motion, Measure measure) {
    if (measure == Measure::Speed) return motion.velocity();
    return measure == Measure::Influence ? motion.influence() : Eigen::MatrixXd();
}

bool isDistortion(Measure measure) {
    return rowOf(measure).ranks;
}

std::vector<Measure> measuresOf(int dimension) {
    std::vector<Measure> all;
    for (const MeasureRow& row : kMeasures)
        if (row.flat || dimension == 3) all.push_back(row.measure);
    return all;
}

std::vector<double> shownValues(const ShapeMotion& motion, Measure measure) {
    if (!motion.frame()) return {};
    return cellValues(*motion.frame(), measure, fieldOf(motion, measure));
}

std::optional<double> plainValue(const ShapeMotion& motion, Measure measure) {
    if (measure == Measure::Stiffness) return 1;
    if (measure != Measure::Phi || motion.document().isEmpty()) return {};
    return motion.document().design().material.phi;
}

double paintedPart(double place, double plainPlace) {
    constexpr double kFullPaint = 0.1;
    return std::min(1.0, std::abs(place - plainPlace) / kFullPaint);
}

MeasureRange rangeOf(const std::vector<double>& values, Measure measure, int dimension) {
    const MeasureRow& row = rowOf(measure);
    if (row.scale == Scale::Energies) return {phi::kEquia, phi::conformal(dimension), dimension};
    if (values.empty()) return row.scale == Scale::Ratio ? MeasureRange{0.9, 1 / 0.9} : MeasureRange{0, 0.01};
    const auto [low, high] = std::ranges::minmax(values);
    if (row.scale == Scale::Times)  // of the design, not of an outcome
        return {1, std::max(row.minimum, high), dimension};
    if (row.scale == Scale::Logarithm) {
        const double minimum = std::max(low, 1e-300);
        return {minimum, std::max(high, row.minimum * minimum)};
    }
    std::vector<double> sizes;
    sizes.reserve(values.size());
    for (const double v : values)
        sizes.push_back(sizeOf(row.scale == Scale::Ratio ? std::max(v, 1e-6) : v, row.scale));
    const auto nth =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), nth, sizes.end());
    double span = std::max(*nth, row.minimum);
    if (span <= kNothing) span = 1;  // avoids a range around zero
    return row.scale == Scale::Ratio ? MeasureRange{std::exp(-span), std::exp(span)} : MeasureRange{0, span};
}

bool leavesScale(Measure measure) {
    return rowOf(measure).scale == Scale::Even;
}

void findBeyond(const std::vector<double>& values, MeasureRange& range) {
    const double rounding = 1e-9 * (range.high - range.low);
    range.below = std::ranges::any_of(values, [&](double value) { return value < range.low - rounding; });
    range.above = std::ranges::any_of(values, [&](double value) { return value > range.high + rounding; });
}

std::vector<double> restValues(const ShapeMotion& motion, Measure measure) {
    const bool isQuality = measure == Measure::ScaledJacobian || measure == Measure::AspectRatio ||
                           measure == Measure::SmallestAngle;
    if (!isQuality || !motion.frame()) return {};
    return cellValues(*atRest(motion.frame()), measure);
}

double positionIn(const MeasureRange& range, Measure measure, double value) {
    const Scale scale = rowOf(measure).scale;
    if (scale == Scale::Energies) return stopOfPhi(value, range.dimension) / (kEnergyStops - 1);
    if (!isLogarithmic(scale, range)) return (value - range.low) / (range.high - range.low);
    const double low = std::log(range.low), high = std::log(range.high);
    return (std::log(std::max(value, 1e-9 * range.low)) - low) / (high - low);
}

double valueAt(const MeasureRange& range, Measure measure, double position) {
    const Scale scale = rowOf(measure).scale;
    if (scale == Scale::Energies) return phiAtStop(position * (kEnergyStops - 1), range.dimension);
    if (!isLogarithmic(scale, range)) return range.low + position * (range.high - range.low);
    return range.low * std::pow(range.high / range.low, position);
}

std::vector<int> histogramOf(const std::vector<double>& values, Measure measure, const MeasureRange& range,
                             int parts) {
    std::vector<int> counts(static_cast<std::size_t>(parts), 0);
    for (const double value : values) {
        const double position = std::clamp(positionIn(range, measure, value), 0.0, 1.0);
        if (std::isfinite(position)) ++counts[std::min(static_cast<int>(parts * position), parts - 1)];
    }
    return counts;
}

QRgb colourAt(Measure measure, double position) {
    switch (rowOf(measure).scale) {
        case Scale::Energies:
            return energyColour(position * (kEnergyStops - 1));
        case Scale::Times:
            return between(kStiff, position);
        case Scale::Ratio:
            return between(kDiverging, position);
        case Scale::Even:
        case Scale::Logarithm:
            break;
    }
    return between(kMagnitude, position);
}

QString measureName(Measure measure, int dimension) {
    const MeasureRow& row = rowOf(measure);
    return QCoreApplication::translate("Measure", dimension == 3 && row.solidName ? row.solidName : row.name);
}

QString measureText(Measure measure, double value) {
    const MeasureRow& row = rowOf(measure);
    if (isDistortion(measure) && std::abs(value) < kLeastDistortion) value = 0;
    const bool plain = !*row.before && !*row.after, times = row.scale == Scale::Times;
    const bool large = std::abs(value) >= 100;  // never with an exponent
    const bool whole = (plain && value == 0) || ((plain || times) && large) || measure == Measure::Influence;
    const QString number = whole   ? QLocale().toString(value, 'f', 0)
                           : times ? QLocale().toString(value, 'g', 3)
                                   : QLocale().toString(value, plain ? 'g' : 'f', 2);
    return QString::fromUtf8(row.before) + number + QString::fromUtf8(row.after);
}

namespace {

/// Returns the measure that ranks cells for the worst place.
Measure ranking(Measure measure) {
    return isDistortion(measure) ? measure : Measure::Length;
}

}  // namespace

WorstPlace worstOf(const Distortion& distortion, Measure measure) {
    const MeasureRow& row = rowOf(ranking(measure));
    const auto& values = distortion.*row.ranks;
    WorstPlace worst;
    for (std::size_t c = 0; c < values.size(); ++c)
        if (worst.cell < 0 || sizeOf(values[c], row.scale) > sizeOf(worst.value, row.scale))
            worst = {static_cast<int>(c), values[c]};
    return worst;
}

bool isDistorted(const Distortion& distortion, Measure measure) {
    const WorstPlace worst = worstOf(distortion, measure);
    return worst.cell >= 0 && sizeOf(worst.value, rowOf(ranking(measure)).scale) >= kLeastDistortion;
}

QString worstText(const Distortion& distortion, Measure measure, int dimension) {
    const WorstPlace worst = worstOf(distortion, measure);
    if (worst.cell < 0) return QStringLiteral("–");
    const QLocale locale;
    const MeasureRow& row = rowOf(ranking(measure));
    const bool large = worst.value >= 1000,
               fixed = large || (row.scale == Scale::Ratio && worst.value >= 0.1);
    const QString number = worst.value < kLeastDistortion ? QStringLiteral("0")
                                                          : locale.toString(worst.value, fixed ? 'f' : 'g',
                                                                            large   ? 0
                                                                            : fixed ? 2
                                                                                    : 3);
    return QCoreApplication::translate("Measure",
                                       dimension == 3 && row.solidWorst ? row.solidWorst : row.worst)
        .arg(number);
}

QString worstWarning(const Distortion& distortion, Measure measure) {
    constexpr double kTwice = 2;
    const double value = worstOf(distortion, measure).value;
    const char* words = nullptr;
    if (measure == Measure::Length && value > (kTwice - 1) * (kTwice - 1))
        words = QT_TRANSLATE_NOOP("Measure", "Stretched too far here · %1");
    if (measure == Measure::Area && value > kTwice)
        words = QT_TRANSLATE_NOOP("Measure", "Grown too far here · %1");
    if (measure == Measure::Area && value < 1 / kTwice)
        words = QT_TRANSLATE_NOOP("Measure", "Shrunk too far here · %1");
    const bool isKnown = words && worstOf(distortion, measure).cell >= 0;
    return isKnown ? QCoreApplication::translate("Measure", words).arg(measureText(measure, value))
                   : QString();
}

}  // namespace wend
