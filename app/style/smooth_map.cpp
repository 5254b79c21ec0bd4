#include "app/style/smooth_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/mesh/cell_geometry.h"

namespace wend {

namespace {

/// Returns vertex values of piecewise constant cell values: the mean over the adjacent cells weighted by rest
/// area or volume, x_v = Σ |c| x_c / Σ |c| over the cells c of vertex v, and `zero` for unused vertices.
template <int Dim, class Value>
std::vector<Value> vertexMeans(const SimplicialMesh<Dim>& rest, const std::vector<Value>& ofCells,
                               const Value& zero) {
    std::vector<Value> means(static_cast<std::size_t>(rest.vertexCount()), zero);
    std::vector<double> weights(means.size(), 0);
    for (std::size_t c = 0; c < rest.cells.size(); ++c) {
        const double weight = std::abs(cellMeasure<Dim>(rest.points, rest.cells[c]));
        for (const int v : rest.cells[c]) {
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

template <int Dim>
std::vector<Eigen::Array4d> softColours(const SimplicialMesh<Dim>& rest, const std::vector<QRgb>& ofCells) {
    std::vector<Eigen::Array4d> colours;
    for (const QRgb colour : ofCells) {
        const QRgb own = qPremultiply(colour);
        colours.emplace_back(qRed(own), qGreen(own), qBlue(own), qAlpha(own));
    }
    return vertexMeans<Dim>(rest, colours, Eigen::Array4d(Eigen::Array4d::Zero()));
}

template <int Dim>
std::vector<bool> sharpCells(const SimplicialMesh<Dim>& rest, const std::vector<double>& ofCells) {
    std::vector<Meeting> meetings(static_cast<std::size_t>(rest.vertexCount()));
    for (std::size_t c = 0; c < rest.cells.size(); ++c)
        for (const int v : rest.cells[c]) meetings[v].add(ofCells[c]);
    std::vector<bool> sharp;
    for (const Cell<Dim>& cell : rest.cells)
        sharp.push_back(std::ranges::any_of(cell, [&](int v) { return meetings[v].isSharp(); }));
    return sharp;
}

double paintOpacity(double mapOpacity) {
    return std::min(1.0, mapOpacity * kPaintOpacity / kMapOpacity);
}

/// A cell without area may have NaN, which counts as the largest value.
template <int Dim>
std::vector<double> smoothPlaces(const SimplicialMesh<Dim>& rest, const std::vector<double>& ofCells,
                                 Measure measure, const MeasureRange& range) {
    std::vector<double> places = vertexMeans<Dim>(rest, ofCells, 0.0);
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

template std::vector<Eigen::Array4d> softColours<2>(const SimplicialMesh<2>&, const std::vector<QRgb>&);
template std::vector<Eigen::Array4d> softColours<3>(const SimplicialMesh<3>&, const std::vector<QRgb>&);
template std::vector<bool> sharpCells<2>(const SimplicialMesh<2>&, const std::vector<double>&);
template std::vector<bool> sharpCells<3>(const SimplicialMesh<3>&, const std::vector<double>&);
template std::vector<double> smoothPlaces<2>(const SimplicialMesh<2>&, const std::vector<double>&, Measure,
                                             const MeasureRange&);
template std::vector<double> smoothPlaces<3>(const SimplicialMesh<3>&, const std::vector<double>&, Measure,
                                             const MeasureRange&);

}  // namespace wend
