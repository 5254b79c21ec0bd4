#include "app/panels/colour_map.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/energy_stops.h"
#include "app/session/fields.h"

namespace wend {

namespace {

using Stops = std::array<std::array<int, 3>, 6>;

// Lightness falls evenly (CIE L* 95, 78, 60, 42, 25, 8): what is kept stays light.
constexpr Stops kMagnitude = {
    {{253, 248, 208}, {250, 176, 72}, {226, 94, 66}, {160, 44, 100}, {86, 22, 112}, {22, 10, 52}}};
// Blue and orange of equal lightness on both sides of a light middle.
// From cream to brown through the colour of stiffness, lightness falling evenly.
constexpr Stops kStiff = {
    {{252, 240, 222}, {245, 205, 160}, {230, 160, 98}, {205, 112, 42}, {150, 70, 16}, {88, 36, 4}}};
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

bool isLogarithmic(Measure measure) {
    return measure == Measure::Area || measure == Measure::CellSize || measure == Measure::Stiffness;
}

}  // namespace

bool isDistortion(Measure measure) {
    return measure == Measure::Angle || measure == Measure::Area || measure == Measure::Length;
}

const std::vector<double>& valuesOf(const Distortion& distortion, Measure measure) {
    switch (measure) {
        case Measure::Angle:
            return distortion.angle;
        case Measure::Area:
            return distortion.ratio;
        default:
            return distortion.metric;
    }
}

template <int Dim>
std::vector<double> cellValues(const PosedFrame<Dim>& frame, Measure measure) {
    if (measure == Measure::Phi) return phiOf<Dim>(frame);
    if (measure == Measure::Stiffness) return stiffnessOf<Dim>(frame);
    if (measure == Measure::CellSize) return sizesOf<Dim>(frame);
    return valuesOf(frame.distortion, measure);
}

namespace {

template <int Dim>
std::vector<double> valuesOfShown(const ShapeSession& session, Measure measure) {
    const auto frame = session.frame<Dim>();
    return measure == Measure::Speed ? speedOf<Dim>(*frame, session.velocity<Dim>())
                                     : cellValues<Dim>(*frame, measure);
}

}  // namespace

std::vector<double> shownValues(const ShapeSession& session, Measure measure) {
    if (!session.frame()) return {};
    return session.frame()->dimension == 2 ? valuesOfShown<2>(session, measure)
                                           : valuesOfShown<3>(session, measure);
}

std::optional<double> plainValue(const ShapeSession& session, Measure measure) {
    if (measure == Measure::Stiffness) return 1;
    if (measure != Measure::Phi || session.document().isEmpty()) return {};
    return std::visit([](const auto& design) { return design.material.phi; },
                      session.document().project()->design);
}

MeasureRange rangeOf(const std::vector<double>& values, Measure measure, int dimension) {
    if (measure == Measure::Phi) return {phi::kEquia, phi::conformal(dimension), dimension};
    if (values.empty()) return measure == Measure::Area ? MeasureRange{0.9, 1 / 0.9} : MeasureRange{0, 0.01};
    if (measure == Measure::Stiffness)  // of the design, not of an outcome
        return {1, std::max(100.0, *std::max_element(values.begin(), values.end())), dimension};
    if (measure == Measure::CellSize) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return {std::max(*low, 1e-300), std::max(*high, 1.01 * std::max(*low, 1e-300))};
    }
    std::vector<double> sizes;
    sizes.reserve(values.size());
    for (const double v : values)
        sizes.push_back(measure == Measure::Area ? std::abs(std::log(std::max(v, 1e-6))) : v);
    const auto nth =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), nth, sizes.end());
    if (measure == Measure::Speed) return {0, std::max(*nth, 1e-9)};
    if (measure != Measure::Area) return {0, std::max(*nth, 0.01)};
    const double span = std::max(*nth, 0.02);
    return {std::exp(-span), std::exp(span)};
}

double positionIn(const MeasureRange& range, Measure measure, double value) {
    if (measure == Measure::Phi) return stopOfPhi(value, range.dimension) / (kEnergyStops - 1);
    if (!isLogarithmic(measure)) return (value - range.low) / (range.high - range.low);
    const double low = std::log(range.low), high = std::log(range.high);
    return (std::log(std::max(value, 1e-9 * range.low)) - low) / (high - low);
}

double valueAt(const MeasureRange& range, Measure measure, double position) {
    if (measure == Measure::Phi) return phiAtStop(position * (kEnergyStops - 1), range.dimension);
    if (!isLogarithmic(measure)) return range.low + position * (range.high - range.low);
    return range.low * std::pow(range.high / range.low, position);
}

QRgb colourAt(Measure measure, double position) {
    if (measure == Measure::Phi) return energyColour(position * (kEnergyStops - 1));
    if (measure == Measure::Stiffness) return between(kStiff, position);
    return between(measure == Measure::Area ? kDiverging : kMagnitude, position);
}

QString measureName(Measure measure, int dimension) {
    switch (measure) {
        case Measure::Angle:
            return QCoreApplication::translate("Measure", "Angle");
        case Measure::Area:
            return dimension == 3 ? QCoreApplication::translate("Measure", "Volume")
                                  : QCoreApplication::translate("Measure", "Area");
        case Measure::Phi:
            return QCoreApplication::translate("Measure", "What is kept (φ)");
        case Measure::Stiffness:
            return QCoreApplication::translate("Measure", "Stiffness");
        case Measure::Speed:
            return QCoreApplication::translate("Measure", "Speed");
        case Measure::CellSize:
            return QCoreApplication::translate("Measure", "Cell size");
        case Measure::Length:
            break;
    }
    return QCoreApplication::translate("Measure", "Stretch");
}

template std::vector<double> cellValues<2>(const PosedFrame<2>&, Measure);
template std::vector<double> cellValues<3>(const PosedFrame<3>&, Measure);

WorstPlace worstOf(const Distortion& distortion, Measure measure) {
    const auto& values = valuesOf(distortion, measure);
    const auto size = [measure](double value) {
        return measure == Measure::Area ? std::abs(std::log(std::max(value, 1e-300))) : value;
    };
    WorstPlace worst;
    for (std::size_t c = 0; c < values.size(); ++c)
        if (worst.cell < 0 || size(values[c]) > size(worst.value)) worst = {static_cast<int>(c), values[c]};
    return worst;
}

QString worstText(const Distortion& distortion, Measure measure, int dimension) {
    const WorstPlace worst = worstOf(distortion, measure);
    if (worst.cell < 0) return QStringLiteral("–");
    const QLocale locale;
    constexpr double kRounding = 1e-6;  // less is none
    const QString error =
        worst.value < kRounding ? QStringLiteral("0") : locale.toString(worst.value, 'g', 3);
    if (measure == Measure::Angle) return QCoreApplication::translate("Measure", "angle error %1").arg(error);
    if (measure != Measure::Area) return QCoreApplication::translate("Measure", "stretch %1").arg(error);
    const QString ratio = worst.value < 0.1 ? error : locale.toString(worst.value, 'f', 2);
    return (dimension == 3 ? QCoreApplication::translate("Measure", "volume ×%1")
                           : QCoreApplication::translate("Measure", "area ×%1"))
        .arg(ratio);
}

}  // namespace wend
