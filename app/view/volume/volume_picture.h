#pragma once

#include <QRgb>
#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/embedding.h"
#include "core/mesh/skin.h"

namespace wend {

/// What lies over a solid's colours, from 0 to 1: a column per vertex, red, green and blue times opacity, and
/// the opacity in another's first row. Cells may have a colour of their own, not multiplied, in their place.
struct SolidPaint {
    Points<3> colours = Points<3>(3, 0), opacities = Points<3>(3, 0);
    std::vector<QRgb> own;  // per cell; 0: as its vertices
    double opacity = 0;     // of all of it; 0: there is none

    bool operator==(const SolidPaint& other) const {
        return opacity == other.opacity && own == other.own && colours.cols() == other.colours.cols() &&
               colours == other.colours && opacities == other.opacities;
    }
};

/// What the view shows: a solid at rest, its pose, and colours.
struct VolumePicture {
    std::shared_ptr<const SimplicialMesh<3>> rest;
    std::shared_ptr<const std::vector<Facet<3>>> facets;
    Points<3> pose;
    std::vector<QRgb> cellColours;  // one per cell; empty: one plain colour
    // For colours that change smoothly, a column per vertex: its place, from 0 to 1, in a row of colours (the
    // first number). None: each cell has its own.
    Points<3> places = Points<3>(3, 0);
    std::vector<QRgb> ramp;
    // Lies over those colours, and over a skin's own.
    SolidPaint paint;
    std::optional<QRgb> section;  // of the face of a cut; none: those of its cells
    // A surface that is embedded in the solid and drawn in place of its border; null if there is none.
    std::shared_ptr<const Skin> skin;
    std::shared_ptr<const Embedding<3>> embedding;
    bool materials = false;  // the skin has the colours and pictures of its materials; those of the cells lie
                             // over them as a map, where the style has an opacity for it
    std::vector<int> marked;  // facets that are seen through the others, faintly
    bool isOpen = false;      // bounds no solid: its colours tell something from behind, too
};

/// Half way to grey: of what is out of date.
QRgb dimmed(QRgb colour);

/// A surface alone, without tetrahedra; one colour per triangle.
VolumePicture pictureOfSurface(const Points<3>& points, const std::vector<std::array<int, 3>>& triangles,
                               std::vector<QRgb> colours);

}  // namespace wend
