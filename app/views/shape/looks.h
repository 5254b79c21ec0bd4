#pragma once

#include <QColor>
#include <tuple>

#include "app/engine/motion/frame.h"
#include "app/engine/shape/shape.h"
#include "app/panels/group_list.h"
#include "app/project/id.h"
#include "app/style/colour_map.h"

namespace wend {

/// Colours of a map.
struct MapLook {
    Measure measure = Measure::Length;
    MeasureRange range;
    double opacity = kMapOpacity;  // over a picture, or a surface that has colours of its own
    bool smooth = false;           // without the edges of its cells

    bool operator==(const MapLook& o) const {
        return std::tie(measure, range, opacity, smooth) == std::tie(o.measure, o.range, o.opacity, o.smooth);
    }
};

/// View options of a shape.
struct Looks {
    bool mesh = false, map = false, arrows = false, marks = false;
    bool onionSkin = false;  // earlier and later shapes
    bool hidden = false;     // all overlays
    bool rest = false;       // the undeformed shape
    bool values = false;     // under the pointer they are shown elsewhere, the velocity among them
    bool detail = true;   // the detailed or painted surface in a solid, rather than the tetrahedra's border
    bool flat = false;    // each facet of it by itself
    MapLook colours;      // of the map
    GroupMarks groups;    // of the mesh's file, to be marked; null: none
    Id layer = Id::None;  // the layer whose border is drawn
    QColor backdrop;      // invalid: the view's own
    FramePtr standIn;     // in the place of the session's frame; null: none
};

/// Returns the frame that is shown instead of the session's own, if any.
inline FramePtr seen(const Looks& looks, const FramePtr& own) {
    const FramePtr& frame = looks.standIn ? looks.standIn : own;
    return frame && looks.rest ? atRest(frame) : frame;
}

}  // namespace wend
