#pragma once

#include "app/panels/look/colour_map.h"

namespace wend {

/// What is painted is seen with edges as soft as it is.
bool isPainted(Measure measure);
/// For that: colours of cells at the vertices, where they mix: red, green, blue and alpha, premultiplied,
/// from 0 to 255. (On the way from one to the other there is no third, as between places.)
template <int Dim>
std::vector<Eigen::Array4d> softColours(const SimplicialMesh<Dim>& rest, const std::vector<QRgb>& ofCells);

/// But where only two values meet at a corner of a cell the edge between them is sharp: a soft one has many.
template <int Dim>
std::vector<bool> sharpCells(const SimplicialMesh<Dim>& rest, const std::vector<double>& ofCells);

/// How much what is painted covers a picture below it, for the opacity of maps.
double paintOpacity(double mapOpacity);

/// A map without the edges of its cells: what the cells have is brought to the vertices (vertexMeans), goes
/// linearly between their places in the range, and has the colour of each place in between.
///
/// The places of the vertices, in [0, 1].
template <int Dim>
std::vector<double> smoothPlaces(const SimplicialMesh<Dim>& rest, const std::vector<double>& ofCells,
                                 Measure measure, const MeasureRange& range);
/// The colours of the places, in even steps from 0 to 1.
std::vector<QRgb> colourRamp(Measure measure);

}  // namespace wend
