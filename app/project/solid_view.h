#pragma once

#include <optional>

#include "app/project/extras.h"
#include "core/base/types.h"

namespace wend {

/// The axis of the world that points up in views of a solid.
enum class UpAxis { X, Y, Z };

/// The camera of a solid: `target` is in the middle of the picture, and its distance defines the scale.
struct SavedCamera {
    Vec3 position = Vec3::Zero(), target = Vec3::Zero(), up = Vec3::UnitZ();
    std::optional<Vec3> pivot;  // centre of rotation; none: the target
    bool parallel = false;      // without perspective

    bool operator==(const SavedCamera&) const = default;
};

/// The view of a project's solid, which does not affect its shape.
struct SolidView {
    UpAxis up = UpAxis::Z;
    std::optional<SavedCamera> camera;  // none: all of it is shown, from the side and above
    Extras extras = {};
};

}  // namespace wend
