#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/project/extras.h"
#include "core/meshing/outline.h"
#include "warp/alpha_outline_options.h"
#include "warp/blend_mode.h"

namespace wend {

enum class OutlineKind { Frame, Alpha, Polygons };

/// A part of the plane that is meshed, of one part of a picture.
struct PartOutline {
    OutlineKind kind = OutlineKind::Frame;
    AlphaOutlineOptions alpha;
    Outline polygons;
    bool operator==(const PartOutline&) const = default;
};

/// Fastens a point of a part, or all of a disc of it, to another part.
struct Joint {
    std::string to;
    Vec2 at = Vec2::Zero();
    double radius = 0;
    Extras extras = {};
    bool operator==(const Joint&) const = default;
};

/// The place of a part among the others from a time on: see PicturePart::order.
struct PartOrder {
    double time = 0, place = 0;
    bool operator==(const PartOrder&) const = default;
};

/// One of the sheets that a picture is put together from, as the project's file says it. Coordinates are the
/// document's: pixels of the whole picture.
struct PicturePart {
    std::string name;
    std::string path;     // of its picture, or of the file that has its layer; empty: it is cut out
    std::string layer;    // the layer's name; empty: the whole picture
    std::string cutFrom;  // the part that it is cut out of
    Outline cut;
    double feather = 0;                  // width of the soft edge of the cut
    bool fill = false;                   // what the cut hides at rest is inpainted
    std::optional<PartOutline> outline;  // without: the domain's
    int vertices = 0;                    // 0: its share of the domain's
    std::optional<Vec2> at;              // of its first pixel; without: where its layer is, or the origin
    double opacity = 1;                  // of a layer: in its file's place if not 1
    bool hidden = false;
    bool locked = false;  // not to be picked, painted or dragged in the window
    /// Without: that of its layer or of the part that it is cut out of; otherwise normal.
    std::optional<BlendMode> blend;
    /// Changes of the place from front to back, in order of time. Until the first one, the place is that in
    /// the list, counted from 0. Of two parts at the same place, the one that was moved there is in front.
    std::vector<PartOrder> order;
    std::vector<Joint> joints;
    std::string ridesOn;  // the part whose map it follows
    Extras extras = {};

    bool operator==(const PicturePart&) const = default;
};

}  // namespace wend
