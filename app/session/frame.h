#pragma once

#include <memory>

#include "core/energy/distortion.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The shape at one time, as the compute thread hands it to the view. Immutable and shared.
struct ShapeFrame {
    double time = 0;
    bool live = false;  // a preview while dragging; otherwise of final quality
    std::shared_ptr<const SimplicialMesh<2>> rest;
    Points<2> pose;
    Distortion distortion;
    double pinError = 0;      // greatest distance of a pin from where it should be, in the domain's units
    double milliseconds = 0;  // that this frame took; 0 if it came from a longer run
    int sample = -1;          // live: the newest sample of the drag that it follows
    Vec<2> offset = Vec<2>::Zero();  // live: how far the dragged handles have come
    bool stopped = false;            // live: the handles could not reach the sample without a fold
    std::string message;             // why not
};
using FramePtr = std::shared_ptr<const ShapeFrame>;

}  // namespace wend
