#include "app/view/tool_options.h"

#include <QWidgetAction>

#include "app/view/brush_actions.h"
#include "app/view/picture_actions.h"
#include "app/view/pin_actions.h"
#include "app/view/solid_actions.h"

namespace wend {

template <bool Adds>
QList<QAction*> pinOptions(const ToolOptions& o) {
    const PinActions& a = o.pins;
    QList<QAction*> all = {a.move, a.turn, a.grow, nullptr, a.selectRectangle, a.selectLasso, a.selectBrush};
    if (o.dimension == 3) all << o.solids.through;
    if (Adds) all << (o.dimension == 3 ? o.solids.snap : o.pictures.snap);
    return all;
}

template QList<QAction*> pinOptions<true>(const ToolOptions&);
template QList<QAction*> pinOptions<false>(const ToolOptions&);

QList<QAction*> throughOptions(const ToolOptions& o) {
    return {o.solids.through};
}

QList<QAction*> outlineOptions(const ToolOptions& o) {
    return {o.pictures.adds, o.pictures.takesAway};
}

QList<QAction*> outlineBrushOptions(const ToolOptions& o) {
    return outlineOptions(o) << o.pictures.size;
}

QList<QAction*> wandOptions(const ToolOptions& o) {
    return outlineOptions(o) << o.pictures.tolerance;
}

QList<QAction*> sizeOptions(const ToolOptions& o) {
    return o.dimension == 2 ? QList<QAction*>{o.pictures.edges, o.brush.size} : QList<QAction*>{o.brush.size};
}

QList<QAction*> targetOptions(const ToolOptions& o) {
    return {o.brush.keep, o.brush.stiffness, o.brush.direction};
}

QList<QAction*> tipOptions(const ToolOptions& o) {
    return {o.brush.size, o.brush.hardness, o.brush.amount, o.brush.pressure};
}

QList<QAction*> paintOptions(const ToolOptions& o) {
    return targetOptions(o) << nullptr << tipOptions(o);
}

QList<QAction*> depthOptions(const ToolOptions& o) {
    return {o.pictures.order, o.brush.size};
}

}  // namespace wend
