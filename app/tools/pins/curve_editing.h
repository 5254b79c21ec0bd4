#pragma once

#include <QString>
#include <optional>

#include "app/project/edits/bezier_edits.h"

namespace wend {

/// Menu commands for the curve of the single selected handle, of either dimension.
class CurveEditing {
  public:
    virtual ~CurveEditing() = default;

    /// Returns whether there is a curve with visible points.
    virtual bool hasCurve() const = 0;
    /// Returns the relation of the directions at the chosen point; nothing if it has only one direction, or
    /// if no point is chosen.
    virtual std::optional<JointKind> chosenKind() const = 0;
    virtual bool canRemove() const = 0;
    /// Inserts a point at the last pointed place of the curve; otherwise in the middle of the piece after the
    /// chosen point.
    virtual void insertPoint() = 0;
    virtual void removePoint() = 0;
    virtual void setKind(JointKind kind) = 0;
};

}  // namespace wend
