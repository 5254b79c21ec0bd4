#pragma once

#include <optional>

#include "core/mesh/types.h"
#include "core/motion/handle.h"

namespace wend {

/// The axis of the world that points up in views of a solid.
enum class UpAxis { X, Y, Z };

/// From where a solid is seen: `target` is in the middle of the picture, as large as its distance makes it.
struct SavedCamera {
    Vec<3> position = Vec<3>::Zero(), target = Vec<3>::Zero(), up = Vec<3>::UnitZ();
    std::optional<Vec<3>> pivot;  // to turn around; none: the target
    bool parallel = false;        // without perspective

    bool operator==(const SavedCamera&) const = default;
};

/// How a project's solid is looked at; its shape does not depend on it.
struct SolidView {
    UpAxis up = UpAxis::Z;
    std::optional<SavedCamera> camera;  // none: all of it is shown, from the side and above
    Extras extras = {};
};

}  // namespace wend
