#pragma once

#include <QString>
#include <optional>

#include "app/document/edits/bezier_edits.h"

namespace wend {

/// What the menu does with the curve of the one selected handle, whatever its dimension.
class CurveEditing {
  public:
    virtual ~CurveEditing() = default;

    /// True if there is a curve whose points are shown.
    virtual bool hasCurve() const = 0;
    /// How the directions at the chosen point go together; nothing where there is only one, or no choice.
    virtual std::optional<JointKind> chosenKind() const = 0;
    virtual bool canRemove() const = 0;
    /// Where the curve was pointed at last; otherwise in the middle of the piece behind the chosen point.
    virtual void insertPoint() = 0;
    virtual void removePoint() = 0;
    virtual void setKind(JointKind kind) = 0;
};

}  // namespace wend
