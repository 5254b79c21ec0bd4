#pragma once

#include <QAction>
#include <QList>

namespace wend {

class BrushActions;
class PictureActions;
class PinActions;
class SolidActions;

/// What may stand beside a tool's name, for a shape of that dimension.
struct ToolOptions {
    const SolidActions& solids;
    const PictureActions& pictures;
    const PinActions& pins;
    const BrushActions& brush;
    int dimension = 0;
};

/// What stands beside the names of tools; a null action separates.
template <bool Adds>
QList<QAction*> pinOptions(const ToolOptions& o);
QList<QAction*> throughOptions(const ToolOptions& o);
QList<QAction*> outlineOptions(const ToolOptions& o);
QList<QAction*> outlineBrushOptions(const ToolOptions& o);
QList<QAction*> wandOptions(const ToolOptions& o);
QList<QAction*> sizeOptions(const ToolOptions& o);
QList<QAction*> targetOptions(const ToolOptions& o);
QList<QAction*> tipOptions(const ToolOptions& o);
QList<QAction*> paintOptions(const ToolOptions& o);
QList<QAction*> depthOptions(const ToolOptions& o);

}  // namespace wend
