#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/engine/motion/frame.h"

namespace wend {

/// The places that a handle holds; none if it is outside the shape.
struct PinPlace {
    std::vector<Place> points;  // for vertices and points
    bool region = false;        // many vertices: shown as one pin at their centre

    bool isEmpty() const { return points.empty(); }
};

/// Finds places in the rest shape of a frame, which must outlive it.
class RestPlaces {
  public:
    static std::unique_ptr<const RestPlaces> of(const ShapeFrame& frame);
    virtual ~RestPlaces() = default;

    /// Returns the place of a point at rest, on the boundary within 1e-9 of a cell's size.
    virtual std::optional<Place> find(const Vec3& p) const = 0;
    /// Returns the nearest vertex of a cell, the lowest of several.
    virtual int nearestVertex(const Vec3& p) const = 0;
    /// Returns the places of a handle's points, in the part that it names or in the frontmost one that has
    /// them.
    virtual PinPlace placeOf(const Pin& pin) const = 0;
    std::vector<PinPlace> placesOf(const std::vector<Pin>& pins) const;
};

}  // namespace wend
