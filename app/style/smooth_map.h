#pragma once

#include "app/style/colour_map.h"

namespace wend {

/// Returns whether a measure shows paint, which has soft edges.
bool isPainted(Measure measure);
/// Returns colours of paint at the vertices, blended between cells: premultiplied red, green, blue and alpha
/// from 0 to 255. (Blending colours avoids the third colour that blending positions would show.)
std::vector<Eigen::Array4d> softColours(const ShapeFrame& frame, const std::vector<QRgb>& ofCells);

/// Returns the cells at sharp edges: where only two values meet at a corner, since soft edges have many.
std::vector<bool> sharpCells(const ShapeFrame& frame, const std::vector<double>& ofCells);

/// Returns the opacity of paint over a picture for an opacity of maps.
double paintOpacity(double mapOpacity);

/// Computes a map without cell borders: values are averaged at the vertices (vertexMeans), interpolated as
/// positions in the range, and coloured per pixel. Returns the positions of the vertices, in [0, 1].
std::vector<double> smoothPlaces(const ShapeFrame& frame, const std::vector<double>& ofCells, Measure measure,
                                 const MeasureRange& range);
/// Returns the colours of the positions, in even steps from 0 to 1.
std::vector<QRgb> colourRamp(Measure measure);

}  // namespace wend
