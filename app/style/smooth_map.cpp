#include "app/style/smooth_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace wend {

namespace {

/// Returns vertex values of piecewise constant cell values: the mean over the adjacent cells weighted by rest
/// area or volume, x_v = Σ |c| x_c / Σ |c| over the cells c of vertex v, and `zero` for unused vertices.
template <class Value>
std::vector<Value> vertexMeans(const ShapeFrame& frame, const std::vector<Value>& ofCells,
                               const Value& zero) {
    std::vector<Value> means(static_cast<std::size_t>(frame.vertices), zero);
    std::vector<double> weights(means.size(), 0);
    for (int c = 0; c < frame.cells; ++c) {
        const double weight = frame.restMeasure(c);
        for (const int v : frame.corners(c)) {
            means[v] += weight * ofCells[c];
            weights[v] += weight;
        }
    }
    for (std::size_t v = 0; v < means.size(); ++v)
        if (weights[v] > 0) means[v] /= weights[v];
    return means;
}

constexpr int kRampSteps = 256;
constexpr double kPaintOpacity = 0.55;  // where maps have kMapOpacity

/// The first two of the values that meet at a vertex, and whether there are more.
struct Meeting {
    std::optional<double> first, second;
    bool isSoft = false;

    void add(double value) {
        if (!first) first = value;
        if (value == *first) return;
        if (!second) second = value;
        isSoft = isSoft || value != *second;
    }
    bool isSharp() const { return second && !isSoft; }
};

}  // namespace

bool isPainted(Measure measure) {
    return measure == Measure::Phi || measure == Measure::Stiffness;
}

std::vector<Eigen::Array4d> softColours(const ShapeFrame& frame, const std::vector<QRgb>& ofCells) {
    std::vector<Eigen::Array4d> colours;
    for (const QRgb colour : ofCells) {
        const QRgb own = qPremultiply(colour);
        colours.emplace_back(qRed(own), qGreen(own), qBlue(own), qAlpha(own));
    }
    return vertexMeans(frame, colours, Eigen::Array4d(Eigen::Array4d::Zero()));
}

std::vector<bool> sharpCells(const ShapeFrame& frame, const std::vector<double>& ofCells) {
    std::vector<Meeting> meetings(static_cast<std::size_t>(frame.vertices));
    for (int c = 0; c < frame.cells; ++c)
        for (const int v : frame.corners(c)) meetings[v].add(ofCells[c]);
    std::vector<bool> sharp;
    for (int c = 0; c < frame.cells; ++c)
        sharp.push_back(std::ranges::any_of(frame.corners(c), [&](int v) { return meetings[v].isSharp(); }));
    return sharp;
}

double paintOpacity(double mapOpacity) {
    return std::min(1.0, mapOpacity * kPaintOpacity / kMapOpacity);
}

/// Treats NaN, which a cell without area may have, as the largest value.
std::vector<double> smoothPlaces(const ShapeFrame& frame, const std::vector<double>& ofCells, Measure measure,
                                 const MeasureRange& range) {
    std::vector<double> places = vertexMeans(frame, ofCells, 0.0);
    for (double& place : places) {
        place = positionIn(range, measure, place);
        place = place <= 1 ? std::max(place, 0.0) : 1;
    }
    return places;
}

std::vector<QRgb> colourRamp(Measure measure) {
    std::vector<QRgb> colours;
    for (int i = 0; i < kRampSteps; ++i)
        colours.push_back(colourAt(measure, static_cast<double>(i) / (kRampSteps - 1)));
    return colours;
}

}  // namespace wend
