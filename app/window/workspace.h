#pragma once

#include <QObject>
#include <map>

#include "app/session/brush.h"
#include "app/views/canvas/paint_map.h"
#include "app/window/actions/tool_table.h"

namespace wend {

class Actions;
class PictureActions;
class PinActions;
class Properties;
class ShapeCanvas;
class SolidWorkshop;
class Toolbox;
class Viewport;

/// Connects the active tool with the view of the open document. Tools are made on first use.
class Workspace : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        Toolbox& tools;
        const Actions& actions;
        ShapeCanvas& picture;
        SolidWorkshop& solids;
        Properties& properties;
        PictureActions& outline;
        PinActions& pins;
        Crop& crop;
    };
    explicit Workspace(const Parts& parts);
    ~Workspace() override;

    /// The curve that the chosen tool edits; null if it edits none.
    CurveEditing* curve() const;

  private:
    Viewport* viewport() const;
    void show();
    void showMap();
    void takeTool();
    void takeBrush();
    Tool* toolOf(const ToolKind& kind);

    Parts m_parts;
    PaintMap m_map;
    BrushTarget m_painted = BrushTarget::Keep;  // by the brush, rather than by the comb
    Workbench m_bench;
    std::map<std::pair<const ToolKind*, int>, std::unique_ptr<Tool>> m_tools;  // by kind and dimension
};

}  // namespace wend
