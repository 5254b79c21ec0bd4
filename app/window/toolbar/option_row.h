#pragma once

#include <QToolBar>

#include "app/window/toolbar/tool_options.h"

namespace wend {

class Actions;
class Toolbox;

/// The options row of the active tool: its name, its hint and its options; in the step Animate also those of
/// the film.
class OptionRow : public QToolBar {
    Q_OBJECT

  public:
    OptionRow(const Toolbox& tools, const Actions& actions, const ToolOptions& options, QWidget* parent);

  private:
    void showTool();
    void showMotion();

    const Toolbox& m_tools;
    const Actions& m_actions;
    ToolOptions m_options;
};

}  // namespace wend
