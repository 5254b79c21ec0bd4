#pragma once

#include <QImage>
#include <QRgb>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/embedding.h"
#include "core/mesh/skin.h"

namespace wend {

/// Paint over a solid's colours: a column per vertex with red, green and blue times opacity, from 0 to 1, and
/// the opacity in the first row of `opacities`. Cells may have colours of their own instead, not
/// premultiplied.
struct SolidPaint {
    Points<3> colours = Points<3>(3, 0), opacities = Points<3>(3, 0);
    std::vector<QRgb> own;  // per cell; 0: as its vertices
    double opacity = 0;     // of all paint; 0: there is none

    bool operator==(const SolidPaint& other) const {
        return opacity == other.opacity && own == other.own && colours.cols() == other.colours.cols() &&
               colours == other.colours && opacities == other.opacities;
    }
};

/// The content of the view: a solid at rest, its pose, and colours.
struct VolumePicture {
    std::shared_ptr<const SimplicialMesh<3>> rest;
    std::shared_ptr<const std::vector<Facet<3>>> facets;
    Points<3> pose;
    std::vector<QRgb> cellColours;  // one per cell; empty: one plain colour
    // Positions of smooth colours in the ramp, from 0 to 1, a column per vertex (first number). None: each
    // cell has its own colour.
    Points<3> places = Points<3>(3, 0);
    std::vector<QRgb> ramp;
    // Lies over those colours, and over a skin's own.
    SolidPaint paint;
    std::optional<QRgb> section;  // of the face of a cut; none: those of its cells
    // A surface embedded in the solid and drawn instead of its border; null if there is none.
    std::shared_ptr<const Skin> skin;
    std::shared_ptr<const Embedding<3>> embedding;
    // the skin uses its materials; cell colours cover them as a map with the opacity of the style
    bool materials = false;
    std::vector<int> marked;  // facets that are faintly visible through others
    bool isOpen = false;      // not closed: its colours are meaningful from behind, too
};

/// Returns the colour halfway to grey, for outdated shapes.
QRgb dimmed(QRgb colour);

/// Returns a surface alone, without tetrahedra, with one colour per triangle.
VolumePicture pictureOfSurface(const Points<3>& points, const std::vector<std::array<int, 3>>& triangles,
                               std::vector<QRgb> colours);

/// Reads the pictures of the skin's materials, scaled to what every GPU supports; null if there is none or it
/// cannot be read. Empty without a skin. `unread` receives the unreadable files.
std::vector<QImage> texturesOf(const Skin* skin, QStringList* unread = nullptr);

}  // namespace wend
