#pragma once

#include <memory>
#include <type_traits>

#include "app/project/edits/grip.h"
#include "core/base/message.h"
#include "core/energy/material.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

struct Distortion;

/// The dimension-independent part of a frame, which the compute thread passes to the views. Immutable and
/// shared.
struct ShapeFrame {
    int generation = 0;  // of the document that it belongs to
    double time = 0;
    bool live = false;  // a preview while dragging; otherwise of final quality
    int dimension = 0;
    std::shared_ptr<const void> shape;      // the rest mesh, to compare shapes by identity
    int vertices = 0, used = 0, cells = 0;  // the vertices that cells have, of all
    double diagonal = 0;                    // size of the rest shape; for a box its diagonal (ShapeSize)
    std::shared_ptr<const Distortion> distortion;
    double growth = 1;        // area or volume relative to rest
    double pinError = 0;      // largest distance of a pin from where it should be, in the domain's units
    double milliseconds = 0;  // that this frame took; 0 if it came from a longer run
    int gesture = 0;          // live: the number of the drag
    int sample = -1;          // live: the newest sample of the drag that it follows
    Amount amount = Amount::Zero();  // live: offset that the dragged handles have reached
    bool stopped = false;            // live: the handles could not reach the sample without a fold
    Message message;                 // why not

    virtual ~ShapeFrame() = default;
};
/// How much of the existing frames stays valid after a change: their times are multiplied by the scale, then
/// those up to a time are kept (−∞: none).
struct KeptFrames {
    double timeScale = 1;
    double upTo = 0;
};
using FramePtr = std::shared_ptr<const ShapeFrame>;
/// Velocities, one column per vertex, in domain units per unit of time.
using VelocityPtr = std::shared_ptr<const Eigen::MatrixXd>;

template <int Dim>
struct Shape;

/// The shape itself.
template <int Dim>
struct PosedFrame : ShapeFrame {
    std::shared_ptr<const Shape<Dim>> built;  // the built shape with its file, picture and skin
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    Points<Dim> pose;
};
template <int Dim>
using PosedPtr = std::shared_ptr<const PosedFrame<Dim>>;

/// Casts the frame; returns null if there is none or if its dimension differs.
template <int Dim>
PosedPtr<Dim> posed(const FramePtr& frame) {
    if (!frame || frame->dimension != Dim) return {};
    return std::static_pointer_cast<const PosedFrame<Dim>>(frame);
}

/// The same shape, standing for another time.
inline FramePtr atTime(const FramePtr& frame, double time) {
    const auto copy = [time](const auto& own) -> FramePtr {
        auto other = std::make_shared<std::decay_t<decltype(own)>>(own);
        other->time = time;
        return other;
    };
    return frame->dimension == 2 ? copy(*posed<2>(frame)) : copy(*posed<3>(frame));
}

}  // namespace wend
