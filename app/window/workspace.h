#pragma once

#include <QAction>
#include <QObject>
#include <map>
#include <optional>

#include "app/panels/distortion_panel.h"
#include "app/session/brush.h"
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
struct Looks;

/// Makes a view follow the view actions and the map's panel, or a single switch.
void followLooks(Viewport& view, const Actions& actions, const DistortionPanel& map);
void followLook(Viewport& view, const QAction* action, bool Looks::*look);

/// Shows the map of the painted property while a brush is active, and restores the earlier map afterwards,
/// unless the user has chosen another one. A map that the user switched off stays off.
class PaintMap {
  public:
    PaintMap(DistortionPanel& panel, QAction& showMap);
    void show(Measure wanted);
    void end();

  private:
    struct Before {
        Measure measure;
        bool shown;
    };
    DistortionPanel& m_panel;
    QAction& m_showMap;
    std::optional<Before> m_before;  // while painting
    Measure m_painted = Measure::Phi;
    bool m_isChosen = false;  // the map that is shown, by the user
    QObject m_listener;
};

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

    /// Returns the curve that the chosen tool edits; null if it edits none.
    CurveEditor* curve() const;

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
