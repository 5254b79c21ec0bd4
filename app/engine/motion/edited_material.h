#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/engine/motion/frame.h"
#include "app/project/design.h"

namespace wend {

/// The place and strength of an eraser.
struct Eraser {
    Region<3> shape;
    double feather = 0;
    double amount = 1;
    int cell = 0;           // that the amount is of; of no account where all is erased
    std::string part = {};  // of a picture, that alone is erased; empty: whatever lies there
};

/// The material of a frame, for tools that change it. Functions that lay regions throw InputError that names
/// the key if a picture of cell values in the project's folder cannot be read.
class EditedMaterial {
  public:
    static std::unique_ptr<EditedMaterial> of(const FramePtr& frame, const std::string& folder);
    virtual ~EditedMaterial() = default;

    virtual double phiOf(int cell) const = 0;
    /// Returns nothing if the whole shape is isotropic.
    virtual std::optional<Stiffness> stiffnessOf(int cell) const = 0;
    /// Return the stiffness nearest to (1 − amount) B + amount A for the B of a cell, where A is that of a
    /// stiffness, or the mean of other cells.
    virtual Stiffness blended(int cell, double amount, const Stiffness& aim) const = 0;
    virtual Stiffness smoothed(int cell, double amount, const std::vector<int>& others) const = 0;
    /// Returns the cells whose centroids at rest are in the ball.
    virtual std::vector<int> cellsIn(const Ball<3>& ball) const = 0;
    /// Return a region around the cells that are connected with one, and one that holds the whole shape.
    virtual Region<3> around(int cell) const = 0;
    virtual Region<3> whole() const = 0;

    /// Returns the frame with the material of a design. All calls must pass the same `first` and the same
    /// layers before it.
    virtual FramePtr with(const MaterialSpec& spec, std::size_t first = 0) = 0;
    /// Returns whether every cell of another frame of this shape has the same φ and B, to 1e-9.
    virtual bool equals(const ShapeFrame& other) const = 0;
    /// Removes paint from all visible layers, so that the shape behaves as elsewhere, even after later
    /// changes. Adds no layer.
    virtual Design erased(const Design& design, std::span<const Eraser> erasers) const = 0;
    /// Removes visible layers of which erasing has left almost nothing.
    virtual Design withoutErasedLayers(const Design& design) const = 0;
};

}  // namespace wend
