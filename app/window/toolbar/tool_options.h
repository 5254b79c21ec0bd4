#pragma once

#include <QAction>
#include <QList>

#include "app/tools/tool_kind.h"

namespace wend {

class BrushActions;
class PictureActions;
class PinActions;
class SolidActions;

/// The options beside tools' names.
struct ToolOptions {
    const SolidActions& solids;
    const PictureActions& outline;
    const PinActions& pins;
    const BrushActions& brush;

    /// A null action separates.
    QList<QAction*> of(const ToolKind& kind) const;

  private:
    QList<QAction*> of(ToolOption option) const;
};

}  // namespace wend
